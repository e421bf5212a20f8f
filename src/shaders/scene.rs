//! The air in shaders of a scene's own: functions to call from glass, water, particles, or anything that is
//! drawn after the air before the scene or reflects the sky.
//!
//! [`wgsl`] and [`glsl`] join them with a shader of yours. Directions are from the camera, in the axes of
//! your scene, of any length; distances are metres.
//!
//! - The air between the camera and a point, through which it is seen as `color * transmittance + inscatter`;
//!   beyond the air, whatever the distance, all of the air. In WGSL
//!   `welkin_aerial(direction: vec3f, distance: f32) -> welkin_Air`, which has these two members; in GLSL
//!   `void welkin_aerial(vec3 direction, float distance, inout vec3 inscatter, inout vec3 transmittance)`.
//! - Radiance of all the air in a direction, for reflections, as from the camera's place: over a black ground
//!   and a black space, without the sun's disk. `welkin_sky(direction: vec3f) -> vec3f`,
//!   `vec3 welkin_sky(vec3 direction)`.
//! - Light on a surface from the sky and the ground below it at the camera's place, the sun's own not
//!   counted, of which a matt surface sends `albedo / π`; 0 unless
//!   [`SceneAir::with_light`](crate::SceneAir::with_light) gave it the light.
//!   `welkin_irradiance(normal: vec3f) -> vec3f`, `vec3 welkin_irradiance(vec3 normal)`.
//!
//! All other names of theirs begin with `welkin_` too. Under a moon's shadow the light is that of the clear
//! sky times what the moon leaves of the sun at the camera: in totality it is too dark.
//!
//! ```
//! let glass = "@fragment fn tint(@location(0) from_camera: vec3f) -> @location(0) vec4f {
//!     let air = welkin_aerial(from_camera, length(from_camera));
//!     let reflected = welkin_sky(reflect(from_camera, vec3f(0.0, 0.0, 1.0)));
//!     return vec4f(0.1 * reflected * air.transmittance + 0.1 * air.inscatter, 0.1);
//! }";
//! # #[cfg(feature = "wgpu")]
//! assert!(welkin::shaders::scene::wgsl(1, glass).contains("@group(1)"));
//! ```

/// A WGSL module of yours with the functions behind it; what they read is in the bind group of that number,
/// whose layout is [`air_layout`](crate::gpu::wgpu::WgpuBackend::air_layout)'s.
#[cfg(any(feature = "wgpu", feature = "translate"))]
pub fn wgsl(group: u32, shader: &str) -> String {
    let modules = super::generated_scene::scene_air::INFO.wgsl;
    // Less the vertex shader before them and the program behind them.
    let text = modules.get(1..modules.len() - 1).unwrap_or_default().concat();
    let mut names = Vec::new();
    for line in text.lines() {
        let mut words = words(line);
        match words.next() {
            Some("fn" | "struct" | "const") => names.extend(words.next()),
            Some("group") => {
                names.extend(words.skip_while(|w| *w != "var").find(|w| !["var", "uniform"].contains(w)))
            }
            _ => {}
        }
    }
    let text = renamed(&text, |word| names.contains(&word).then(|| ["welkin_", word].concat()));
    // Behind it, as WGSL has no order: errors in yours keep their lines.
    [shader, "\n", &text.replace("@group(0)", &format!("@group({group})"))].concat()
}

/// A fragment shader of yours in GLSL ES 3.00, or in GLSL 3.30 and newer, with the functions before it; what
/// they read [`scene_air`](crate::gpu::webgl::WebGlBackend::scene_air) sets.
///
/// They stand behind your lines `#version`, `#extension` and `precision`; errors keep the lines of your text.
#[cfg(feature = "webgl")]
pub fn glsl(shader: &str) -> String {
    let info = &super::generated_scene::scene_air::INFO;
    let parts = info.glsl.fragment.iter().map(|&i| info.glsl.parts[usize::from(i)]);
    let other = ["#version", "precision ", "layout(location", "void main()"];
    let text: String = parts.filter(|part| !other.iter().any(|start| part.starts_with(start))).collect();
    let mut names = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with("layout")) {
        // Functions, structs and what has a value stand each on a line: the last word before what a
        // declaration goes on with is its name.
        let declared = line.split(['(', '{', '=', ';']).next().unwrap_or_default();
        names.extend(words(declared).last());
    }
    let [_, block] = info.glsl.blocks;
    let text = renamed(&text, |word| {
        let sampler = info.glsl.samplers.iter().position(|s| *s == word);
        match sampler {
            Some(i) => Some(["welkin_", info.textures[i].name].concat()),
            None if word == block => Some(GLSL_BLOCK.to_owned()),
            None if word == "g0" => Some("welkin_values".to_owned()),
            None => names.contains(&word).then(|| ["welkin_", word].concat()),
        }
    });
    insert(shader, &text)
}

/// The name of the uniform block in GLSL.
#[cfg(feature = "webgl")]
pub const GLSL_BLOCK: &str = "welkin_air_block";

/// The words of a text, in order.
#[cfg(any(feature = "wgpu", feature = "translate", feature = "webgl"))]
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !is_word(c)).filter(|word| !word.is_empty())
}

#[cfg(any(feature = "wgpu", feature = "translate", feature = "webgl"))]
fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// A text with other names for some of its words, wherever they stand.
#[cfg(any(feature = "wgpu", feature = "translate", feature = "webgl"))]
fn renamed(text: &str, name: impl Fn(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 4);
    let mut rest = text;
    while let Some(start) = rest.find(is_word) {
        let (between, tail) = rest.split_at(start);
        let (word, tail) = tail.split_at(tail.find(|c| !is_word(c)).unwrap_or(tail.len()));
        out += between;
        match name(word) {
            Some(name) => out += &name,
            None => out += word,
        }
        rest = tail;
    }
    out + rest
}

/// A shader with a text behind its first lines: directives, precision, comments and blank lines, and never
/// between `#if` and its `#endif`.
#[cfg(feature = "webgl")]
fn insert(shader: &str, text: &str) -> String {
    let (mut at, mut end, mut line, mut next, mut depth) = (0, 0, 1, 1, 0);
    for text in shader.split_inclusive('\n') {
        (at, line) = (at + text.len(), line + 1);
        let text = text.trim_start();
        depth += i32::from(text.starts_with("#if")) - i32::from(text.starts_with("#endif"));
        if text.starts_with('#') || text.starts_with("precision ") {
            if depth == 0 {
                (end, next) = (at, line);
            }
        } else if !text.is_empty() && !text.starts_with("//") {
            break;
        }
    }
    let (before, after) = shader.split_at(end);
    let precision = "precision highp float;precision highp int;\n";
    [before, precision, text, &format!("#line {next}\n"), after].concat()
}

#[cfg(test)]
mod tests {
    #[test]
    #[cfg(feature = "wgpu")]
    fn wgsl_for_a_users_module_is_whole_and_named() {
        let user = "enable f16;\n// mine\nfn sky() -> vec3f { return welkin_sky(vec3f(1.0)); }\n";
        let text = super::wgsl(3, user);
        assert!(text.starts_with(user));
        assert!(!text.contains("@group(0)") && text.matches("@group(3)").count() == 5);
        let module = naga::front::wgsl::parse_str(&text.replace("enable f16;", "")).expect("whole");
        let own = module.functions.iter().filter_map(|(_, f)| f.name.as_deref());
        let own: Vec<_> = own.filter(|name| !name.starts_with("welkin_")).collect();
        assert_eq!(own, ["sky"]);
        for name in ["welkin_aerial", "welkin_sky", "welkin_irradiance"] {
            assert!(module.functions.iter().any(|(_, f)| f.name.as_deref() == Some(name)), "{name}");
        }
        let globals: Vec<_> = module.global_variables.iter().filter_map(|(_, v)| v.name.clone()).collect();
        assert!(globals.iter().all(|name| name.starts_with("welkin_")), "{globals:?}");
    }

    #[test]
    #[cfg(feature = "webgl")]
    fn glsl_for_a_users_shader_is_whole_and_named() {
        let user = "#version 300 es\nprecision highp float;\nout vec4 color;\nvoid main() {}\n";
        let text = super::glsl(user);
        assert!(text.starts_with("#version 300 es\nprecision highp float;\n"));
        assert!(text.ends_with("\n#line 3\nout vec4 color;\nvoid main() {}\n"));
        for part in [
            "void welkin_aerial(vec3 a,float b,inout vec3 c,inout vec3 d){",
            "vec3 welkin_sky(vec3 a){",
            "vec3 welkin_irradiance(vec3 a){",
            "layout(std140)uniform welkin_air_block{welkin_SceneAir welkin_values;};",
            "uniform highp sampler2D welkin_aerial_lut;",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
        // Code that only one side of a condition has does not take the functions with it.
        let either = super::glsl("#version 300 es\n#ifdef A\nin vec3 a;\n#endif\nvoid main() {}\n");
        assert!(either.starts_with("#version 300 es\nprecision highp float;"), "{either}");
        assert!(either.ends_with("\n#line 2\n#ifdef A\nin vec3 a;\n#endif\nvoid main() {}\n"));
        assert_eq!(text.matches("void main").count(), 1);
        assert!(!text.contains("_group_0") && !super::words(&text).any(|word| word == "g0"), "{text}");
    }
}
