//! From `shaders/wgsl/` to everything that is generated: WGSL is linked, translated to GLSL ES 3.00 by naga
//! ahead of time, and what programs read is taken from naga's reflection. A file in `shaders/wgsl/pass/` is a
//! program; nothing else lists them.
//!
//! A module may begin with lines `//#include name`: `lib/name.wgsl` comes once before it. A uniform block's
//! layout is taken from naga too, so that the Rust twins can be checked against it.

use std::fmt::Write as _;
use std::path::Path;

use naga::back::glsl;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use super::split_structs::{split_outputs, split_structs};
use super::tidy::tidy;
use crate::error::{Error, Result};
use crate::gpu::{Program, ProgramInfo, SAMPLER_BINDING, TEXTURES_MAX};

/// The number of vertices of a program that draws a triangle strip, in its WGSL.
const VERTICES: &str = "VERTICES";

/// The module of the vertex shader for programs that have none of their own.
const FULLSCREEN: &str = "fullscreen";

/// The folders of programs below `shaders/wgsl/pass/`, and the Rust file that tells of each, below `src/`.
const TABLES: [(&str, &str); 3] = [
    ("", "src/shaders/generated.rs"),
    ("scene", "src/shaders/generated_scene.rs"),
    ("probe", "src/probe/generated.rs"),
];

fn driver_error(what: &str, program: &str, reason: impl ToString) -> Error {
    Error::driver("naga", format!("{what} {program}"), reason.to_string())
}

fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).map_err(|e| driver_error("read", &path.display().to_string(), e))
}

/// Names of the `.wgsl` files in a folder, in order.
fn names(folder: &Path) -> Result<Vec<String>> {
    let failed = |e| driver_error("read", &folder.display().to_string(), e);
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let name = entry.map_err(failed)?.file_name();
        names.extend(name.to_str().and_then(|n| n.strip_suffix(".wgsl")).map(str::to_owned));
    }
    names.sort();
    Ok(names)
}

/// A program as its files and naga tell it.
struct Source {
    name: String,
    /// Linked modules in order: path below `shaders/wgsl/` without its ending, and text.
    modules: Vec<(String, String)>,
    /// Names and comments of the lines `const NAME: bool`.
    constants: Vec<(String, String)>,
    vertex: Stage,
    fragment: Stage,
    uniform_size: u32,
    textures: Vec<Texture>,
    /// Whole numbers with a name, which the Rust side may need too.
    numbers: Vec<(String, i64)>,
}

struct Texture {
    name: String,
    binding: u32,
    filtered: bool,
    sampler: String,
}

struct Stage {
    /// The module with the entry point, which names the vertex shaders' files.
    module: String,
    text: String,
    block: String,
    /// The lines `const NAME: bool` that decide anything here.
    constants: Vec<String>,
    /// The texture's binding, naga's name of the sampler, and whether the shader gives one of its own.
    samplers: Vec<(u32, String, bool)>,
}

/// Appends a module and before it what it includes.
fn link(wgsl: &Path, module: &str, out: &mut Vec<(String, String)>) -> Result<()> {
    if out.iter().any(|(name, _)| name == module) {
        return Ok(());
    }
    let text = read(&wgsl.join(format!("{module}.wgsl")))?;
    for include in text.lines().filter_map(|line| line.strip_prefix("//#include ")) {
        link(wgsl, &format!("lib/{}", include.trim()), out)?;
    }
    out.push((module.to_owned(), text));
    Ok(())
}

impl Source {
    fn new(wgsl: &Path, folder: &str, name: &str) -> Result<Self> {
        let module = if folder.is_empty() { format!("pass/{name}") } else { format!("pass/{folder}/{name}") };
        let mut modules = Vec::new();
        link(wgsl, &module, &mut modules)?;
        if !modules.iter().any(|(_, text)| text.contains("fn vertex_main(")) {
            let mut first = Vec::new();
            link(wgsl, &format!("lib/{FULLSCREEN}"), &mut first)?;
            modules.splice(0..0, first);
        }
        let text: String = modules.iter().map(|(_, text)| text.as_str()).collect();
        let mut constants = Vec::new();
        for line in text.lines() {
            if let Some((constant, rest)) =
                line.strip_prefix("const ").and_then(|l| l.split_once(": bool = true;"))
            {
                let comment = rest.trim().strip_prefix("//").unwrap_or_default().trim();
                constants.push((constant.to_owned(), comment.to_owned()));
            }
        }
        let module = parse_text(name, &text)?;
        let stage = |stage, entry: &str| {
            let owner = modules.iter().find(|(_, text)| text.contains(&format!("fn {entry}(")));
            let owner = owner.map(|(module, _)| module.as_str()).unwrap_or_default();
            // naga leaves structs in that nothing uses: from the entry point's module alone, which programs
            // may share.
            let mut own = Vec::new();
            link(wgsl, owner, &mut own)?;
            let text: String = own.into_iter().map(|(_, text)| text).collect();
            self::stage(name, &text, stage, entry, owner.rsplit('/').next().unwrap_or_default().to_owned())
        };
        let vertex = stage(naga::ShaderStage::Vertex, "vertex_main")?;
        let fragment = stage(naga::ShaderStage::Fragment, "fragment_main")?;
        // A module's constant that no function of this program asks for is no choice.
        constants.retain(|(name, _)| vertex.constants.contains(name) || fragment.constants.contains(name));
        let (mut uniform_size, mut textures) = (0, Vec::new());
        for (_, variable) in module.global_variables.iter() {
            let Some(binding) = variable.binding.as_ref().map(|b| b.binding) else { continue };
            let inner = &module.types[variable.ty].inner;
            match inner {
                naga::TypeInner::Struct { span, .. } if binding == 0 => uniform_size = *span,
                naga::TypeInner::Image { .. } if (1..=TEXTURES_MAX as u32).contains(&binding) => {
                    let sampler = fragment.samplers.iter().find(|(at, ..)| *at == binding);
                    let (sampler, filtered) =
                        sampler.map(|(_, name, own)| (name.clone(), *own)).unwrap_or_default();
                    let name = variable.name.clone().unwrap_or_default();
                    textures.push(Texture { name, binding, filtered, sampler });
                }
                naga::TypeInner::Sampler { .. } if binding == SAMPLER_BINDING => {}
                _ => {
                    let what = format!("no place for {:?} at binding {binding}", variable.name);
                    return Err(driver_error("reflect", name, what));
                }
            }
        }
        textures.sort_by_key(|t| t.binding);
        let number = |c: &naga::Constant| match module.global_expressions[c.init] {
            naga::Expression::Literal(naga::Literal::U32(value)) => Some(i64::from(value)),
            naga::Expression::Literal(naga::Literal::I32(value)) => Some(i64::from(value)),
            _ => None,
        };
        let numbers: Vec<_> =
            module.constants.iter().filter_map(|(_, c)| Some((c.name.clone()?, number(c)?))).collect();
        if (vertex.module == FULLSCREEN) == numbers.iter().any(|(name, _)| name == VERTICES) {
            return Err(driver_error("reflect", name, "a vertex shader of its own and VERTICES go together"));
        }
        Ok(Self {
            name: name.to_owned(),
            modules,
            constants,
            vertex,
            fragment,
            uniform_size,
            textures,
            numbers,
        })
    }

    /// What the program's own file says about it, up to the first line that is no comment.
    fn about(&self) -> impl Iterator<Item = &str> {
        let own = self.modules.last().map(|(_, text)| text.as_str()).unwrap_or_default();
        let comments = own.lines().skip_while(|l| l.starts_with("//#")).map_while(|l| l.strip_prefix("//"));
        comments.map(str::trim)
    }
}

fn parse_text(program: &str, text: &str) -> Result<naga::Module> {
    let module = naga::front::wgsl::parse_str(text)
        .map_err(|e| driver_error("parse", program, e.emit_to_string(text)))?;
    validate(program, text, &module)?;
    Ok(module)
}

fn validate(program: &str, text: &str, module: &naga::Module) -> Result<ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(module)
        .map_err(|e| driver_error("validate", program, e.emit_to_string(text)))
}

/// Parses and validates a program's WGSL.
pub fn parse(program: Program) -> Result<naga::Module> {
    parse_text(&program.name(), &program.wgsl())
}

fn stage(program: &str, wgsl: &str, stage: naga::ShaderStage, entry: &str, owner: String) -> Result<Stage> {
    let mut module = parse_text(program, wgsl)?;
    module.entry_points.retain(|e| e.name == entry);
    // The writer asks for features of every function left in the module, reachable or not.
    naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
    split_structs(&mut module).map_err(|e| driver_error("split the structs of", program, e))?;
    let info = validate(program, wgsl, &module)?;
    let options = glsl::Options {
        version: glsl::Version::Embedded { version: 300, is_webgl: true },
        writer_flags: glsl::WriterFlags::ADJUST_COORDINATE_SPACE,
        ..Default::default()
    };
    let pipeline = glsl::PipelineOptions { shader_stage: stage, entry_point: entry.into(), multiview: None };
    let mut text = String::new();
    let reflection = glsl::Writer::new(
        &mut text,
        &module,
        &info,
        &options,
        &pipeline,
        naga::proc::BoundsCheckPolicies::default(),
    )
    .and_then(|mut writer| writer.write())
    .map_err(|e| driver_error("translate", program, e))?;
    let text = split_outputs(&text).map_err(|e| driver_error("split the outputs of", program, e))?;
    let block = reflection.uniforms.values().next().cloned().unwrap_or_default();
    let mut samplers = Vec::new();
    for (name, mapping) in &reflection.texture_mapping {
        let binding = module.global_variables[mapping.texture].binding.as_ref().map_or(0, |b| b.binding);
        samplers.push((binding, name.clone(), mapping.sampler.is_some()));
    }
    let mut constants = Vec::new();
    for name in module.constants.iter().filter_map(|(_, c)| c.name.clone()) {
        let found = text.matches(&format!("\nconst bool {name} = ")).count();
        if wgsl.contains(&format!("\nconst {name}: bool = ")) {
            if found != 1 {
                return Err(driver_error(
                    "translate",
                    program,
                    format!("{found} lines of the constant {name}"),
                ));
            }
            // naga writes all constants that have a name, asked for or not.
            if words(&text).filter(|(word, _)| *word == name).count() > 1 {
                constants.push(name);
            }
        }
    }
    Ok(Stage { module: owner, text, block, constants, samplers })
}

/// Path below the repository's root and text of everything generated: a readable GLSL file for every shader
/// in `shaders/glsl/` (equal vertex shaders share one) and the tables of programs in Rust.
///
/// # Errors
/// [`crate::ErrorKind::Driver`] with naga's words for a shader that it does not accept, and for files that
/// cannot be read.
pub fn generate(root: &Path) -> Result<Vec<(String, String)>> {
    let wgsl = root.join("shaders/wgsl");
    let mut files: Vec<(String, String)> = Vec::new();
    for (folder, table) in TABLES {
        let mut programs = Vec::new();
        for name in names(&wgsl.join("pass").join(folder))? {
            let source = Source::new(&wgsl, folder, &name)?;
            let vertex = format!("shaders/glsl/{}.vert", source.vertex.module);
            let fragment = format!("shaders/glsl/{name}.frag");
            for (file, text) in [(vertex, &source.vertex.text), (fragment, &source.fragment.text)] {
                match files.iter().find(|(f, _)| *f == file) {
                    None => files.push((file, text.clone())),
                    Some((_, known)) if known == text => {}
                    Some(_) => return Err(driver_error("two different texts for", &name, file)),
                }
            }
            programs.push(source);
        }
        files.push((table.to_owned(), rust_table(&programs)));
    }
    Ok(files)
}

/// The Rust text of a table of programs.
fn rust_table(programs: &[Source]) -> String {
    let mut modules: Vec<&str> = Vec::new();
    for (module, _) in programs.iter().flat_map(|p| &p.modules) {
        if !modules.contains(&module.as_str()) {
            modules.push(module);
        }
    }
    let identifier = |module: &str| module.replace('/', "_").to_uppercase();
    let parts = Parts::new(programs);
    let mut out = String::from(
        "// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in \
         shaders/glsl/.\n\n\
         #[allow(unused_imports)]\n\
         use crate::gpu::{ProgramInfo, TextureSlot, Vertices};\n\n\
         /// Every program.\n\
         pub static PROGRAMS: &[&ProgramInfo] = &[",
    );
    for p in programs {
        let _ = write!(out, "&{}::INFO, ", p.name);
    }
    out += "];\n\n#[cfg(any(feature = \"wgpu\", feature = \"translate\"))]\nmod text {\n";
    for module in modules {
        let _ = writeln!(
            out,
            "    pub(super) const {}: &str = crate::shaders::wgsl!({module:?});",
            identifier(module)
        );
    }
    out += "}\n\n#[cfg(feature = \"webgl\")]\nstatic PARTS: &[&str] = &[\n";
    for part in &parts.list {
        let _ = writeln!(out, "    {:?},", tight(part));
    }
    out += "];\n";
    for (p, [vertex, fragment]) in programs.iter().zip(&parts.programs) {
        out += "\n";
        for line in p.about() {
            let _ = writeln!(out, "/// {line}");
        }
        let _ = writeln!(out, "pub mod {} {{\n    use super::*;\n", p.name);
        for (i, (name, comment)) in p.constants.iter().enumerate() {
            let _ = writeln!(out, "    /// {comment}\n    pub const {name}: u32 = 1 << {i};");
        }
        let names: Vec<_> = p.constants.iter().map(|(name, _)| name).collect();
        let slots: Vec<_> = p
            .textures
            .iter()
            .map(|t| {
                format!(
                    "TextureSlot {{ name: {:?}, binding: {}, filtered: {} }}",
                    t.name, t.binding, t.filtered
                )
            })
            .collect();
        let samplers: Vec<_> =
            p.textures.iter().map(|t| short_global(&t.sampler).unwrap_or_default()).collect();
        let strip = p.numbers.iter().find(|(name, _)| name == VERTICES);
        let vertices =
            strip.map_or("Vertices::Triangle".to_owned(), |(_, count)| format!("Vertices::Strip({count})"));
        if !p.numbers.is_empty() {
            out += "    /// Whole numbers that the shader calls by these \
             names.\n    #[allow(missing_docs)]\n    pub mod numbers {\n";
            for (name, value) in &p.numbers {
                let _ = writeln!(out, "        pub const {name}: u32 = {value};");
            }
            out += "    }\n\n";
        }
        let wgsl: Vec<_> =
            p.modules.iter().map(|(module, _)| format!("text::{}", identifier(module))).collect();
        let _ = write!(
            out,
            "    /// The row of the table.\n    \
             pub static INFO: ProgramInfo = ProgramInfo {{\n        \
             name: {:?},\n        uniform_size: {},\n        textures: &[{}],\n        constants: \
             &{names:?},\n        \
             vertices: {vertices},\n        \
             #[cfg(any(feature = \"wgpu\", feature = \"translate\"))]\n        wgsl: &[{}],\n        \
             #[cfg(feature = \"webgl\")]\n        glsl: crate::gpu::Glsl {{\n            parts: \
             PARTS,\n            \
             vertex: &{vertex:?},\n            fragment: &{fragment:?},\n            \
             blocks: {:?},\n            samplers: &{samplers:?},\n        }},\n    }};\n}}\n",
            p.name,
            p.uniform_size,
            slots.join(", "),
            wgsl.join(", "),
            [&p.vertex.block, &p.fragment.block],
        );
    }
    out
}

/// The shaders' texts cut into functions: programs share most of them, and each travels once.
struct Parts {
    list: Vec<String>,
    /// Indices into the list: vertex and fragment shader of each program.
    programs: Vec<[Vec<usize>; 2]>,
}

impl Parts {
    fn new(programs: &[Source]) -> Self {
        let texts: Vec<[Vec<String>; 2]> = programs
            .iter()
            .map(|p| [&p.vertex.text, &p.fragment.text].map(|text| split(text).map(pack).collect()))
            .collect();
        let mut list: Vec<String> = texts.iter().flatten().flatten().cloned().collect();
        // Kinds of the same function next to each other: they compress well.
        list.sort_by(|a, b| (function(a), a).cmp(&(function(b), b)));
        list.dedup();
        let index = |part: &String| list.iter().position(|p| p == part).unwrap_or_default();
        let programs =
            texts.iter().map(|t| t.each_ref().map(|parts| parts.iter().map(index).collect())).collect();
        Self { list, programs }
    }
}

/// A part as it travels: without indentation and blank lines, and a function tidied and with short names for
/// what is local to it. naga numbers names over a whole shader, so that the same function has other names in
/// every program.
fn pack(part: &str) -> String {
    let lines: Vec<&str> = part.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let is_function = lines.first().is_some_and(|line| line.ends_with(") {"));
    let tidied = if is_function { tidy(&lines) } else { Vec::new() };
    let lines: Vec<&str> = if is_function { tidied.iter().map(String::as_str).collect() } else { lines };
    let mut locals = Vec::new();
    if is_function {
        // The last words of the header's arguments, and of declarations.
        let arguments = lines[0].split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(") {"));
        locals.extend(
            arguments.split(',').filter_map(|a| a.split(' ').next_back()).filter(|name| !name.is_empty()),
        );
        for line in &lines[1..] {
            let mut words = line.split(' ');
            let (Some(kind), Some(name)) = (words.next(), words.next()) else { continue };
            let declares = name.ends_with(';') || words.next() == Some("=");
            if declares && kind != "return" && name.trim_end_matches(';').chars().all(is_word) {
                locals.push(name.trim_end_matches(';'));
            }
        }
    }
    let text = lines.iter().flat_map(|line| [line, "\n"]).collect::<String>();
    let taken: Vec<&str> =
        words(&text).filter(|(word, member)| !member && !locals.contains(word)).map(|w| w.0).collect();
    let mut names = (0..).map(short_name).filter(|name| !taken.contains(&name.as_str()));
    let mut short: Vec<(&str, String)> = Vec::new();
    for (word, member) in words(&text) {
        if !member && locals.contains(&word) && !short.iter().any(|(known, _)| *known == word) {
            short.extend(names.next().map(|name| (word, name)));
        }
    }
    let mut out = String::new();
    let mut rest = text.as_str();
    for (word, member) in words(&text) {
        let (before, tail) = rest.split_once(word).unwrap_or((rest, ""));
        out += before;
        let renamed = short.iter().find(|(known, _)| !member && *known == word);
        let global = short_global(word);
        out += renamed.map(|(_, name)| name.as_str()).or(global.as_deref()).unwrap_or(word);
        rest = tail;
    }
    out + rest
}

/// A short name of what naga names after its binding or its location: `g1`, `v0`, `o0`. A block
/// has another in each stage, as OpenGL wants of different blocks. Names of locals have no
/// digits, and those of functions and members are not of one letter.
fn short_global(name: &str) -> Option<String> {
    let number = |before: &str, after: &str| {
        let number = name.strip_prefix(before)?.strip_suffix(after)?;
        number.chars().all(|c| c.is_ascii_digit()).then_some(number)
    };
    let names = [
        ("g", number("_group_0_binding_", "_fs")),
        ("h", number("_group_0_binding_", "_vs")),
        ("v", number("_vs2fs_location", "")),
        ("o", number("_fs2p_location", "")),
    ];
    names.into_iter().find_map(|(letter, number)| Some([letter, number?].concat()))
}

/// A part on one line without the spaces that no compiler needs. Lines that are searched for when a program
/// is compiled, and those that end a directive, stay as they are.
fn tight(part: &str) -> String {
    if part.starts_with('#') || part.contains("const bool ") {
        return part.to_owned();
    }
    let all: Vec<char> = part.chars().filter(|c| *c != '\n').collect();
    let mut out = String::new();
    for (i, &c) in all.iter().enumerate() {
        let (before, after) = (all[i.saturating_sub(1)], all.get(i + 1).copied().unwrap_or(c));
        // `a - -b`, and words that would grow together.
        let needed = is_word(before) && is_word(after) || before == after && "+-/".contains(before);
        if c != ' ' || needed {
            out.push(c);
        }
    }
    out.push('\n');
    out
}

pub(super) fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The words of a text and its numbers, in order, with whether a dot before it makes a word a member's name.
pub(super) fn words(text: &str) -> impl Iterator<Item = (&str, bool)> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let start = rest.find(is_word)?;
        let dot = rest[..start].ends_with('.');
        rest = &rest[start..];
        let number = rest.starts_with(|c: char| c.is_ascii_digit());
        let end = rest.find(|c| !(is_word(c) || number && c == '.')).unwrap_or(rest.len());
        let (word, tail) = rest.split_at(end);
        rest = tail;
        Some((word, dot))
    })
}

/// a, b, … z, aa, ab, …, without the keywords of that length.
fn short_name(index: usize) -> String {
    let letter = |i: usize| char::from(b'a' + (i % 26) as u8);
    let name: String = if index < 26 {
        letter(index).into()
    } else {
        [letter(index / 26 - 1), letter(index)].iter().collect()
    };
    if ["do", "if", "in"].contains(&name.as_str()) { name + "_" } else { name }
}

/// The name of the function that a part holds; empty for other parts.
fn function(part: &str) -> &str {
    let header = part.lines().find(|line| line.ends_with(") {") && !line.starts_with(['}', '#']));
    header
        .and_then(|line| line.split_once('('))
        .and_then(|(head, _)| head.split(' ').nth(1))
        .unwrap_or_default()
}

/// A shader's text cut behind every top-level closing brace, and behind what stands before the first
/// function.
fn split(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let ends = ["\n}\n", "\n};\n", "\n\n"].iter().filter_map(|e| rest.find(e).map(|i| i + e.len()));
        let (part, tail) = rest.split_at(ends.min().unwrap_or(rest.len()));
        rest = tail;
        (!part.is_empty()).then_some(part)
    })
    .filter(|part| !part.trim().is_empty())
}

/// Name and byte offset of every member of a struct, nested ones as `outer.inner`, and the struct's size.
pub type Layout = (Vec<(String, u32)>, u32);

/// A struct of a program's WGSL as naga lays it out. `None` if there is no such struct.
pub fn struct_layout(info: &'static ProgramInfo, name: &str) -> Result<Option<Layout>> {
    layout(&parse(Program::new(info, info.all()))?, name)
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
