//! Shaders: the committed GLSL is fresh, and every uniform block's Rust twin has naga's layout.
#![cfg(feature = "translate")]

use std::path::Path;

use welkin::frame::eclipse::ShadowUniform;
use welkin::frame::lut::TablesUniform;
use welkin::frame::terrain::TerrainUniform;
use welkin::frame::tone_map::ToneUniform;
use welkin::frame::uniforms::{DepthUniform, FrameUniform, MediumUniform};
use welkin::shaders::struct_lint::struct_values_of;
use welkin::shaders::{Program, translate};

#[test]
fn committed_glsl_is_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = translate::generate().unwrap();
    assert!(files.len() > 40, "only {} files were generated", files.len());
    for (name, text) in &files {
        let folder = if name.ends_with(".rs") { "src/shaders" } else { "shaders/glsl" };
        let found = std::fs::read_to_string(root.join(folder).join(name)).unwrap_or_default();
        assert!(found == *text, "{folder}/{name} is stale: run `cargo run --features cli -- shaders`");
    }
    for entry in std::fs::read_dir(root.join("shaders/glsl")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(files.iter().any(|(n, _)| *n == name), "shaders/glsl/{name} belongs to no program");
    }
}

/// Name and text of both stages of every program.
fn all_glsl() -> Vec<(String, String)> {
    let programs = Program::all().into_iter().map(|program| translate::translate(program).unwrap());
    programs.flat_map(|t| [(format!("{}.vert", t.name), t.vertex), (format!("{}.frag", t.name), t.fragment)]).collect()
}

#[test]
fn no_shipped_shader_holds_a_struct_value() {
    let all = all_glsl();
    assert!(all.len() > 40, "only {} texts", all.len());
    let texts = || all.iter().map(|(name, text)| (name.as_str(), text.as_str()));
    let found: Vec<_> = struct_values_of(texts()).map(|(name, found)| format!("{name}: {found}")).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    // The same texts with a function that takes one of their blocks' structs fail.
    let mut seen = 0;
    for (name, text) in texts() {
        let Some(struct_name) = text.lines().find_map(|l| l.strip_prefix("struct ")?.strip_suffix(" {")) else {
            continue;
        };
        let bad = text.replace("void main() {", &format!("float f({struct_name} s) {{ return 1.0; }}\nvoid main() {{"));
        let line = 1 + bad.lines().position(|l| l.starts_with("float f(")).unwrap();
        let found: Vec<_> = struct_values_of([(name, bad.as_str())]).map(|(_, found)| found.to_string()).collect();
        assert_eq!(found, [format!("line {line}: s is of struct {struct_name}")], "{name}");
        seen += 1;
    }
    assert!(seen > 20, "only {seen} texts have a struct");
}

/// The last part of a nested field's name.
fn own_name(field: &str) -> &str {
    field.rsplit('.').next().unwrap_or(field)
}

/// A struct's fields in Rust, nested ones flattened as naga's are.
fn rust_layout(name: &str) -> (Vec<(String, u32)>, u32) {
    let own = |fields: Vec<(&str, u32)>| fields.into_iter().map(|(n, o)| (n.to_owned(), o)).collect::<Vec<_>>();
    let nest = |fields: Vec<(String, u32)>, field: &str, inner: Vec<(String, u32)>| {
        let mut out = Vec::new();
        for (n, offset) in fields {
            if n == field {
                out.extend(inner.iter().map(|(i, o)| (format!("{field}.{i}"), offset + o)));
            } else {
                out.push((n, offset));
            }
        }
        out
    };
    let medium = own(MediumUniform::offsets());
    let frame = nest(own(FrameUniform::offsets()), "medium", medium);
    let frame = nest(frame, "depth", own(DepthUniform::offsets()));
    match name {
        "Frame" => (frame, size_of::<FrameUniform>() as u32),
        "Tables" => (own(TablesUniform::offsets()), size_of::<TablesUniform>() as u32),
        "MoonShadow" => (own(ShadowUniform::offsets()), size_of::<ShadowUniform>() as u32),
        "Terrain" => {
            let terrain = nest(own(TerrainUniform::offsets()), "frame", frame);
            let terrain = nest(terrain, "tables", own(TablesUniform::offsets()));
            (nest(terrain, "eclipse", own(ShadowUniform::offsets())), size_of::<TerrainUniform>() as u32)
        }
        _ => (own(ToneUniform::offsets()), size_of::<ToneUniform>() as u32),
    }
}

#[test]
fn uniform_blocks_have_the_layout_that_naga_gives_them() {
    let mut checked = 0;
    for program in Program::all() {
        for name in ["Frame", "Tables", "MoonShadow", "Terrain", "Tone"] {
            let Some((mut members, size)) = translate::struct_layout(program, name).unwrap() else { continue };
            let (mut ours, our_size) = rust_layout(name);
            // Padding is one array in Rust and three scalars in WGSL.
            members.retain(|(n, _)| !own_name(n).starts_with("pad"));
            ours.retain(|(n, _)| !own_name(n).starts_with("pad"));
            assert_eq!(members, ours, "{name} in {}", program.name());
            assert_eq!(size, our_size, "{name} in {}", program.name());
            checked += 1;
        }
    }
    assert!(checked >= 40, "only {checked} blocks were found");
}
