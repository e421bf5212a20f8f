//! The shader programs: a table made from `shaders/wgsl/`, which is the only source.
//!
//! A file in `shaders/wgsl/pass/` is a program; it includes functions from `shaders/wgsl/lib/`. `cargo
//! lab shaders` translates each program to GLSL ES 3.00 and writes the table with what naga's reflection
//! tells: a module here for every program, with its [`ProgramInfo`](crate::gpu::ProgramInfo) and the bits of
//! its constants. Lines `const NAME: bool = true;` are what may be turned off: see [`crate::gpu::Program`].

/// Text of a WGSL module below `shaders/wgsl/` without its comments. The compiler takes them out: they stay
/// in the source, drivers and the wasm module need none.
macro_rules! wgsl {
    ($module:literal) => {{
        const WHOLE: &[u8] = include_bytes!(concat!("../../shaders/wgsl/", $module, ".wgsl"));
        const LENGTH: usize = $crate::shaders::bare::<0>(WHOLE).1;
        const BARE: [u8; LENGTH] = $crate::shaders::bare(WHOLE).0;
        match std::str::from_utf8(&BARE) {
            Ok(text) => text,
            Err(_) => panic!(),
        }
    }};
}
#[cfg(any(feature = "wgpu", feature = "translate"))]
pub(crate) use wgsl;

#[rustfmt::skip]
mod generated;
/// The program that stands for what a scene's own shaders read: see [`scene`].
#[rustfmt::skip]
pub mod generated_scene;
pub mod scene;
#[cfg(feature = "translate")]
pub mod split_structs;
#[cfg(feature = "translate")]
pub mod struct_lint;
#[cfg(feature = "translate")]
mod tidy;
#[cfg(feature = "translate")]
pub mod translate;

pub use generated::*;

/// Functions for a scene's own shaders, which shade with [`crate::LightingContextUniform`]; no program
/// includes them.
pub const LIGHTING_WGSL: &str = wgsl!("lib/lighting");

/// A text less comments, blank lines, and spaces and ends of lines that no compiler needs; and its length.
pub(crate) const fn bare<const LENGTH: usize>(text: &[u8]) -> ([u8; LENGTH], usize) {
    let mut out = [0; LENGTH];
    let (mut length, mut at) = (0, 0);
    while at < text.len() {
        let line = at;
        while at < text.len() && text[at] == b' ' {
            at += 1;
        }
        let start = at;
        // Behind the last character that stays.
        let mut end = start;
        let mut comment = false;
        while at < text.len() && text[at] != b'\n' {
            comment |= text[at] == b'/' && at + 1 < text.len() && text[at + 1] == b'/';
            if !comment && text[at] != b' ' {
                end = at + 1;
            }
            at += 1;
        }
        at += 1;
        if end > start {
            let mut from = start;
            while from < end {
                if text[from] != b' ' || is_needed(text[from - 1], text[from + 1]) {
                    if LENGTH > 0 {
                        out[length] = text[from];
                    }
                    length += 1;
                }
                from += 1;
            }
            // Each declaration of the module stands on lines of its own.
            let inner = start > line || !matches!(text[end - 1], b';' | b'}');
            if !(inner && matches!(text[end - 1], b';' | b'{' | b'}' | b',' | b'(')) {
                if LENGTH > 0 {
                    out[length] = b'\n';
                }
                length += 1;
            }
        }
    }
    (out, length)
}

const fn is_word(c: u8) -> bool {
    c.is_ascii_alphanumeric() || c == b'_'
}

/// Whether a space between these makes a difference: between words, in `a - -b`, and in `array<f32> = b`.
const fn is_needed(before: u8, after: u8) -> bool {
    is_word(before) && is_word(after)
        || before == after && matches!(before, b'+' | b'-' | b'/')
        || before == b'>' && after == b'='
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every program of this set of features is whole: the library's tests run with no feature, each backend
    /// alone, and the default ones (`scripts/test --only unit`). One that a missing feature cut a module from
    /// would be found by nobody but its user.
    #[test]
    #[cfg(any(feature = "wgpu", feature = "webgl"))]
    fn every_program_is_whole_with_these_features() {
        use crate::gpu::Program;
        for info in PROGRAMS.iter().chain(generated_scene::PROGRAMS) {
            for constants in [info.all(), 0] {
                let program = Program::new(info, constants);
                #[cfg(feature = "wgpu")]
                {
                    use naga::valid::{Capabilities, ValidationFlags, Validator};
                    let text = program.wgsl();
                    let module = naga::front::wgsl::parse_str(&text);
                    let module = module.unwrap_or_else(|e| panic!("{}: {e}", program.name()));
                    Validator::new(ValidationFlags::all(), Capabilities::empty())
                        .validate(&module)
                        .unwrap_or_else(|e| panic!("{}: {e:?}", program.name()));
                    let entries: Vec<_> = module.entry_points.iter().map(|e| e.name.as_str()).collect();
                    assert_eq!(entries.len(), 2, "{}: {entries:?}", program.name());
                }
                #[cfg(feature = "webgl")]
                for text in program.glsl() {
                    let count = |c: char| text.chars().filter(|&found| found == c).count();
                    let name = program.name();
                    assert!(text.starts_with("#version 300 es") && text.contains("void main(){"), "{name}");
                    assert_eq!((count('{'), count('(')), (count('}'), count(')')), "{name}");
                }
            }
        }
    }

    #[test]
    fn modules_are_bare() {
        let text = b"// a\n\n  //#include x // why\nlet a = b / c - -d;  // d\n   \n    f();//\n/ 2 > =";
        const BARE: &str = "let a=b/c- -d;\nf();/2> =\n";
        let (out, length) = bare::<{ BARE.len() }>(text);
        assert_eq!((std::str::from_utf8(&out), length), (Ok(BARE), BARE.len()));
    }
}
