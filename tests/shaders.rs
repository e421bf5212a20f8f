//! Shaders: the committed GLSL is fresh, and every uniform block's Rust twin has naga's layout.
#![cfg(feature = "translate")]

use std::path::Path;

use welkin::frame::airglow::AirglowUniform;
use welkin::frame::disks::DiskUniform;
use welkin::frame::eclipse::{EclipseUniform, ShadowUniform};
use welkin::frame::luts::{FrameLuts, LutsUniform, MediumLuts};
use welkin::frame::scene_air::SceneAirUniform;
use welkin::frame::terrain::TerrainUniform;
use welkin::frame::tone_map::ToneUniform;
use welkin::frame::uniforms::{DepthUniform, FrameUniform, MediumUniform};
use welkin::gpu::{Program, ProgramInfo};
use welkin::shaders::struct_lint::struct_values_of;
use welkin::shaders::{PROGRAMS, translate};

#[test]
fn committed_glsl_is_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = translate::generate(root).unwrap();
    assert!(files.len() > 25, "only {} files were generated", files.len());
    for (path, text) in &files {
        let found = std::fs::read_to_string(root.join(path)).unwrap_or_default();
        assert!(found == *text, "{path} is stale: run `cargo lab shaders`");
    }
    for entry in std::fs::read_dir(root.join("shaders/glsl")).unwrap() {
        let path = format!("shaders/glsl/{}", entry.unwrap().file_name().into_string().unwrap());
        assert!(files.iter().any(|(known, _)| *known == path), "{path} belongs to no program");
    }
}

/// Every program, the probe's included.
fn programs() -> impl Iterator<Item = &'static ProgramInfo> {
    let scene = welkin::shaders::generated_scene::PROGRAMS;
    PROGRAMS.iter().chain(scene).chain(welkin::probe::PROGRAMS).copied()
}

#[test]
fn names_are_unique() {
    let names: std::collections::BTreeSet<_> = programs().map(|info| info.name).collect();
    assert_eq!(names.len(), programs().count());
}

/// Checks that one line of a text differs between all constants on and all but one, and which.
fn differs_in(what: &str, [on, off]: [&str; 2], [line_on, line_off]: [&str; 2]) {
    assert_eq!(on.lines().filter(|l| l.trim() == line_on).count(), 1, "{what}: {line_on} in the text");
    assert_eq!(on.lines().count(), off.lines().count(), "{what}");
    let changed: Vec<_> = on.lines().zip(off.lines()).filter(|(a, b)| a != b).collect();
    assert_eq!(changed, [(line_on, line_off)], "{what}");
}

#[test]
fn every_constant_is_one_line_of_each_text_and_changes_no_other() {
    let mut checked = 0;
    for info in programs() {
        let all = Program::new(info, info.all());
        for (i, name) in info.constants.iter().enumerate() {
            let one_off = Program::new(info, info.all() & !(1 << i));
            let what = format!("{} {name}", info.name);
            let lines = ["true", "false"].map(|value| format!("const {name}:bool={value};"));
            differs_in(&what, [&all.wgsl(), &one_off.wgsl()], lines.each_ref().map(String::as_str));
            // A shader whose stage does not ask for the constant has no such line; one of the two must.
            let lines = ["true", "false"].map(|value| format!("const bool {name} = {value};"));
            let mut found = 0;
            for (on, off) in all.glsl().iter().zip(one_off.glsl()) {
                if on.contains(&lines[0]) {
                    differs_in(&what, [on, &off], lines.each_ref().map(String::as_str));
                    found += 1;
                } else {
                    assert_eq!(*on, off, "{what}");
                }
            }
            assert!(found > 0, "{what}: no line {:?} in the GLSL", lines[0]);
            checked += 1;
        }
    }
    assert!(checked >= 60, "only {checked} constants were found");
}

#[test]
fn every_program_is_valid_with_everything_off() {
    for info in programs() {
        translate::parse(Program::new(info, 0)).unwrap();
    }
}

/// Name and text of both stages of every program, as they are shipped.
fn all_glsl() -> Vec<(String, String)> {
    let texts = programs().flat_map(|info| {
        let [vertex, fragment] = Program::new(info, info.all()).glsl();
        [(format!("{}.vert", info.name), vertex), (format!("{}.frag", info.name), fragment)]
    });
    texts.collect()
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
        let Some(struct_name) =
            text.lines().find_map(|l| Some(l.strip_prefix("struct ")?.split_once('{')?.0))
        else {
            continue;
        };
        let bad = text
            .replace("void main(){", &format!("float f({struct_name} s) {{ return 1.0; }}\nvoid main(){{"));
        let line = 1 + bad.lines().position(|l| l.starts_with("float f(")).unwrap();
        let found: Vec<_> =
            struct_values_of([(name, bad.as_str())]).map(|(_, found)| found.to_string()).collect();
        assert_eq!(found, [format!("line {line}: s is of struct {struct_name}")], "{name}");
        seen += 1;
    }
    assert!(seen >= 20, "only {seen} texts have a struct");
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
        "Luts" => (own(LutsUniform::offsets()), size_of::<LutsUniform>() as u32),
        "MoonShadow" => (own(ShadowUniform::offsets()), size_of::<ShadowUniform>() as u32),
        "Terrain" => {
            let terrain = nest(own(TerrainUniform::offsets()), "frame", frame);
            let terrain = nest(terrain, "luts", own(LutsUniform::offsets()));
            (nest(terrain, "moon_shadow", own(ShadowUniform::offsets())), size_of::<TerrainUniform>() as u32)
        }
        _ => (own(ToneUniform::offsets()), size_of::<ToneUniform>() as u32),
    }
}

/// Blocks that are called `Uniforms` in every program that has one, or `SceneAir`.
fn whole_blocks() -> [(Vec<(String, u32)>, u32); 6] {
    let whole = |fields: Vec<(&str, u32)>, size: usize| {
        let mut out = Vec::new();
        for (name, offset) in fields {
            let inner = match name {
                "frame" => rust_layout("Frame").0,
                "luts" => rust_layout("Luts").0,
                "moon_shadow" => rust_layout("MoonShadow").0,
                "medium" => MediumUniform::offsets().into_iter().map(|(n, o)| (n.to_owned(), o)).collect(),
                _ => {
                    out.push((name.to_owned(), offset));
                    continue;
                }
            };
            out.extend(inner.iter().map(|(i, o)| (format!("{name}.{i}"), offset + o)));
        }
        (out, size as u32)
    };
    [
        whole(FrameLuts::offsets(), size_of::<FrameLuts>()),
        whole(MediumLuts::offsets(), size_of::<MediumLuts>()),
        whole(EclipseUniform::offsets(), size_of::<EclipseUniform>()),
        whole(DiskUniform::offsets(), size_of::<DiskUniform>()),
        whole(AirglowUniform::offsets(), size_of::<AirglowUniform>()),
        whole(SceneAirUniform::offsets(), size_of::<SceneAirUniform>()),
    ]
}

#[test]
fn whole_blocks_have_the_layout_that_naga_gives_them() {
    let mut found = [0; 6];
    for info in programs() {
        let layout = |name| translate::struct_layout(info, name).unwrap();
        let Some(layout) = layout("Uniforms").or_else(|| layout("SceneAir")) else { continue };
        assert_eq!(layout.1, info.uniform_size, "{}", info.name);
        let block = whole_blocks().iter().position(|ours| *ours == layout);
        found[block.unwrap_or_else(|| panic!("{}: no Rust block is like {layout:?}", info.name))] += 1;
    }
    assert!(found.iter().all(|&n| n > 0), "{found:?}");
}

#[test]
fn uniform_blocks_have_the_layout_that_naga_gives_them() {
    let mut checked = 0;
    for program in programs() {
        for name in ["Frame", "Luts", "MoonShadow", "Terrain", "Tone"] {
            let Some((mut members, size)) = translate::struct_layout(program, name).unwrap() else {
                continue;
            };
            let (mut ours, our_size) = rust_layout(name);
            // Padding is one array in Rust and three scalars in WGSL.
            members.retain(|(n, _)| !own_name(n).starts_with("pad"));
            ours.retain(|(n, _)| !own_name(n).starts_with("pad"));
            assert_eq!(members, ours, "{name} in {}", program.name);
            assert_eq!(size, our_size, "{name} in {}", program.name);
            checked += 1;
        }
    }
    assert!(checked >= 39, "only {checked} blocks were found");
}
