//! Shaders: the committed GLSL is fresh, and every uniform block's Rust twin has naga's layout.

use std::path::Path;

use welkin::frame::eclipse::ShadowUniform;
use welkin::frame::lut::TablesUniform;
use welkin::frame::terrain::TerrainUniform;
use welkin::frame::tone_map::ToneUniform;
use welkin::frame::uniforms::{DepthUniform, FrameUniform, MediumUniform};
use welkin::shaders::{Program, translate};

#[test]
fn committed_glsl_is_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = translate::generate().unwrap();
    assert!(files.len() > 40, "only {} files were generated", files.len());
    for (name, text) in &files {
        let folder = if name.ends_with(".rs") { "src/shaders" } else { "shaders/glsl" };
        let found = std::fs::read_to_string(root.join(folder).join(name)).unwrap_or_default();
        assert!(found == *text, "{folder}/{name} is stale: run `cargo run -- shaders`");
    }
    for entry in std::fs::read_dir(root.join("shaders/glsl")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(files.iter().any(|(n, _)| *n == name), "shaders/glsl/{name} belongs to no program");
    }
}

/// The last part of a nested field's name.
fn own_name(field: &str) -> &str {
    field.rsplit('.').next().unwrap_or(field)
}

/// A struct's fields in Rust, nested ones flattened as naga's are.
fn rust_layout(name: &str) -> (Vec<(String, u32)>, u32) {
    let own =
        |fields: Vec<(&str, u32)>| fields.into_iter().map(|(n, o)| (n.to_owned(), o)).collect::<Vec<_>>();
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
            let Some((mut members, size)) = translate::struct_layout(program, name).unwrap() else {
                continue;
            };
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
