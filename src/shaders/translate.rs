//! WGSL to GLSL ES 3.00 through naga, ahead of time, with the names that naga gave to what is bound.
//!
//! A uniform block's layout is taken from naga too, so that the Rust twins can be checked against it.

use naga::back::glsl;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use super::Program;
use crate::error::{Error, Result};

/// A translated program: its name, both shaders, the uniform block's name in each, and the sampler names
/// of the textures at bindings 1, 2, …
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Translated {
    pub name: String,
    pub vertex: String,
    pub fragment: String,
    pub blocks: [String; 2],
    pub textures: Vec<String>,
}

fn driver_error(what: &str, program: Program, reason: impl ToString) -> Error {
    Error::driver("webgl2", format!("{what} {}", program.name()), reason.to_string())
}

/// Parses and validates a program's WGSL.
pub fn parse(program: Program) -> Result<naga::Module> {
    let text = program.wgsl();
    let module =
        naga::front::wgsl::parse_str(&text).map_err(|e| driver_error("parse", program, e.emit_to_string(&text)))?;
    validate(program, &module)?;
    Ok(module)
}

fn validate(program: Program, module: &naga::Module) -> Result<ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(module)
        .map_err(|e| driver_error("validate", program, e.emit_to_string(&program.wgsl())))
}

/// Translates both stages of a program.
pub fn translate(program: Program) -> Result<Translated> {
    // naga leaves unused structs in; the full-screen triangle is the same for all, so it is taken from the
    // program that has none.
    let triangle = if program.makes_vertices() { program } else { Program::Copy };
    let (vertex, vertex_block, _) = stage(triangle, naga::ShaderStage::Vertex, "vertex_main")?;
    let (fragment, fragment_block, textures) = stage(program, naga::ShaderStage::Fragment, "fragment_main")?;
    Ok(Translated { name: program.name(), vertex, fragment, blocks: [vertex_block, fragment_block], textures })
}

fn stage(program: Program, stage: naga::ShaderStage, entry: &str) -> Result<(String, String, Vec<String>)> {
    let mut module = parse(program)?;
    module.entry_points.retain(|e| e.name == entry);
    // The writer asks for features of every function left in the module, reachable or not.
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    let info = validate(program, &module)?;
    let options = glsl::Options {
        version: glsl::Version::Embedded { version: 300, is_webgl: true },
        writer_flags: glsl::WriterFlags::ADJUST_COORDINATE_SPACE,
        ..Default::default()
    };
    let pipeline = glsl::PipelineOptions { shader_stage: stage, entry_point: entry.into(), multiview: None };
    let mut text = String::new();
    let reflection =
        glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, naga::proc::BoundsCheckPolicies::default())
            .and_then(|mut writer| writer.write())
            .map_err(|e| driver_error("translate", program, e))?;
    let block = reflection.uniforms.values().next().cloned().unwrap_or_default();
    let mut textures = vec![String::new(); program.textures()];
    let mut filtered = 0;
    for (name, mapping) in &reflection.texture_mapping {
        let binding = module.global_variables[mapping.texture].binding.as_ref().map_or(0, |b| b.binding);
        if let Some(slot) = textures.get_mut((binding as usize).wrapping_sub(1)) {
            slot.clone_from(name);
        }
        filtered |= u32::from(mapping.sampler.is_some()) << binding >> 1;
    }
    if stage == naga::ShaderStage::Fragment && filtered != program.filtered() {
        let found = format!("it samples the textures {filtered:#b}, not {:#b}", program.filtered());
        return Err(driver_error("reflect", program, found));
    }
    Ok((text, block, textures))
}

/// File name (below `shaders/glsl/`) and text of everything generated, and the Rust tables last, whose names
/// are `generated.rs` and, with what only the probe needs, `generated_probe.rs` (below `src/shaders/`). Equal
/// vertex shaders share a file. All variants travel in the wasm module and differ in few functions: the table
/// holds each function once, terse, and variants of a function next to each other, where they compress well.
pub fn generate() -> Result<Vec<(String, String)>> {
    let mut files: Vec<(String, String)> = Vec::new();
    let mut programs = Vec::new();
    for program in Program::all() {
        let t = translate(program)?;
        // The sun's variants share their vertex shader, the terrain's do not.
        let own = if matches!(program, Program::Terrain { .. }) { &t.name } else { program.module() };
        let own = format!("{own}.vert");
        let vertex_file = if program.makes_vertices() { own } else { "fullscreen.vert".to_owned() };
        let fragment_file = format!("{}.frag", t.name);
        for (file, text) in [(&vertex_file, &t.vertex), (&fragment_file, &t.fragment)] {
            match files.iter().find(|(f, _)| f == file) {
                None => files.push((file.clone(), text.clone())),
                Some((_, known)) if known == text => {}
                Some(_) => return Err(driver_error("two different texts for", program, file)),
            }
        }
        let parts = [&t.vertex, &t.fragment].map(|text| split(text).map(terse).collect::<Vec<_>>());
        programs.push((matches!(program, Program::Probe(_)), t, parts));
    }
    // The probe's parts follow those of the pictures.
    let mut parts: Vec<&String> = Vec::new();
    let mut ends = [0; 2];
    for (table, end) in ends.iter_mut().enumerate() {
        let start = parts.len();
        for part in
            programs.iter().filter(|(probe, ..)| usize::from(*probe) == table).flat_map(|p| p.2.iter().flatten())
        {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        parts[start..].sort_by_key(|part| (function(part), *part));
        *end = parts.len();
    }
    let mut rows = [String::new(), String::new()];
    for (probe, t, own) in &programs {
        let [vertex, fragment] = own.each_ref().map(|list| {
            let indices = list.iter().filter_map(|part| parts.iter().position(|p| *p == part));
            indices.map(|i| i.to_string()).collect::<Vec<_>>().join(", ")
        });
        rows[usize::from(*probe)] += &format!(
            "    Glsl {{ name: {:?}, vertex: &[{vertex}], fragment: &[{fragment}], blocks: {:?}, textures: &{:?} }},\n",
            t.name, t.blocks, t.textures,
        );
    }
    files.push(("generated.rs".to_owned(), table(&parts[..ends[0]], &rows[0])));
    files.push(("generated_probe.rs".to_owned(), table(&parts[ends[0]..], &rows[1])));
    Ok(files)
}

/// A part without indentation and blank lines, its temporaries `_e17` counted from 0: naga counts expressions
/// that leave no trace, so that functions with the same text get different names for them.
fn terse(part: &str) -> String {
    let mut out = String::new();
    let mut temporaries: Vec<&str> = Vec::new();
    for line in part.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let mut rest = line;
        while let Some(start) = rest.find("_e") {
            let (before, tail) = rest.split_at(start);
            let digits = tail[2..].find(|c: char| !c.is_ascii_digit()).unwrap_or(tail.len() - 2);
            let (name, tail) = tail.split_at(2 + digits);
            out += before;
            let inside = |c: char| c.is_ascii_alphanumeric() || c == '_';
            if digits == 0 || before.ends_with(inside) || tail.starts_with(inside) {
                out += name;
            } else {
                let index = temporaries.iter().position(|t| *t == name).unwrap_or_else(|| {
                    temporaries.push(name);
                    temporaries.len() - 1
                });
                out += &format!("_e{index}");
            }
            rest = tail;
        }
        out += rest;
        out += "\n";
    }
    out
}

/// The name of the function that a part holds; empty for other parts.
fn function(part: &str) -> &str {
    let header = part.lines().find(|line| line.ends_with(") {") && !line.starts_with(['}', '#']));
    header.and_then(|line| line.split_once('(')).and_then(|(head, _)| head.split(' ').nth(1)).unwrap_or_default()
}

/// The Rust text of a table of parts and of the programs made of them.
fn table(parts: &[&String], rows: &str) -> String {
    let mut table = String::from(
        "// Made by `cargo run --features cli -- shaders` from shaders/wgsl/; do not edit.\n// Readable whole shaders are in shaders/glsl/.\n\n\
         use super::Glsl;\n\npub(super) static PARTS: &[&str] = &[\n",
    );
    for part in parts {
        table += &format!("    {part:?},\n");
    }
    table + &format!("];\n\npub(super) static GLSL: &[Glsl] = &[\n{rows}];\n")
}

/// A shader's text cut behind every top-level closing brace.
fn split(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let end =
            ["\n}\n", "\n};\n"].iter().filter_map(|e| rest.find(e).map(|i| i + e.len())).min().unwrap_or(rest.len());
        let (part, tail) = rest.split_at(end);
        rest = tail;
        (!part.is_empty()).then_some(part)
    })
}

/// Name and byte offset of every member of a struct, nested ones as `outer.inner`, and the struct's size.
pub type Layout = (Vec<(String, u32)>, u32);

/// A struct of a program's WGSL as naga lays it out. `None` if there is no such struct.
pub fn struct_layout(program: Program, name: &str) -> Result<Option<Layout>> {
    layout(&parse(program)?, name)
}

/// A struct of a module that no program includes. `None` if there is no such struct.
///
/// # Errors
/// [`crate::ErrorKind::Driver`] if naga does not accept the text.
pub fn module_layout(wgsl: &str, name: &str) -> Result<Option<Layout>> {
    let module = naga::front::wgsl::parse_str(wgsl)
        .map_err(|e| Error::driver("naga", "parse a module", e.emit_to_string(wgsl)))?;
    layout(&module, name)
}

fn layout(module: &naga::Module, name: &str) -> Result<Option<Layout>> {
    let mut members = Vec::new();
    let found = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name));
    Ok(found.and_then(|(handle, _)| {
        let size = walk(module, handle, "", 0, &mut members)?;
        Some((members, size))
    }))
}

fn walk(
    module: &naga::Module,
    ty: naga::Handle<naga::Type>,
    prefix: &str,
    base: u32,
    out: &mut Vec<(String, u32)>,
) -> Option<u32> {
    let naga::TypeInner::Struct { members, span } = &module.types[ty].inner else { return None };
    for m in members {
        let name = format!("{prefix}{}", m.name.as_deref().unwrap_or("?"));
        if walk(module, m.ty, &format!("{name}."), base + m.offset, out).is_none() {
            out.push((name, base + m.offset));
        }
    }
    Some(*span)
}
