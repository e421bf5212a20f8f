//#include frame
// A case of the probe: what a pure function is given. A case is a run of texels, its answers are a run of
// pixels. Rust twin: `Case` in src/probe/mod.rs. Part of no picture; only built with the feature `probe`.

@group(0) @binding(1) var cases: texture_2d<f32>;

const CASE_TEXELS: i32 = 14;

struct Case {
    medium: Medium,
    view: vec4f,    // direction, altitude
    light: vec4f,   // sun, fraction
    path: vec4f,    // excess, r mu, distance, samples
    angle: vec4f,   // 1 - cos, samples towards the sun, first and span of the sun's axis
    uv: vec4f,      // u, v, whether to the ground, number of a direction
    scale: vec4f,   // altitudes' steepness and growth, the sun's middle and width
    mapping: vec4f, // as `Frame`'s `sky_view_mapping`
}

// The case of a pixel when each has so many answers.
fn case_of(pixel: vec2i, answers: i32) -> Case {
    let first = vec2i(pixel.x / answers * CASE_TEXELS, pixel.y);
    let a = textureLoad(cases, first, 0);
    let b = textureLoad(cases, first + vec2i(1, 0), 0);
    let c = textureLoad(cases, first + vec2i(2, 0), 0);
    let d = textureLoad(cases, first + vec2i(3, 0), 0);
    let e = textureLoad(cases, first + vec2i(4, 0), 0);
    let f = textureLoad(cases, first + vec2i(5, 0), 0);
    let g = textureLoad(cases, first + vec2i(6, 0), 0);
    return Case(
        Medium(
            a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w, g.x, g.y, g.z, g.w),
        textureLoad(cases, first + vec2i(7, 0), 0),
        textureLoad(cases, first + vec2i(8, 0), 0),
        textureLoad(cases, first + vec2i(9, 0), 0),
        textureLoad(cases, first + vec2i(10, 0), 0),
        textureLoad(cases, first + vec2i(11, 0), 0),
        textureLoad(cases, first + vec2i(12, 0), 0),
        textureLoad(cases, first + vec2i(13, 0), 0),
    );
}
