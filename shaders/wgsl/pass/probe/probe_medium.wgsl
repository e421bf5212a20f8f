//#include single_scattering
//#include open_sun
// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.

@group(0) @binding(1) var cases: texture_2d<f32>;

const CASE_TEXELS: i32 = 13;
const ANSWERS: i32 = 5;

fn medium_of(first: vec2i) -> Medium {
    let a = textureLoad(cases, first, 0);
    let b = textureLoad(cases, first + vec2i(1, 0), 0);
    let c = textureLoad(cases, first + vec2i(2, 0), 0);
    let d = textureLoad(cases, first + vec2i(3, 0), 0);
    let e = textureLoad(cases, first + vec2i(4, 0), 0);
    let f = textureLoad(cases, first + vec2i(5, 0), 0);
    return Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let number = pixel.x / ANSWERS;
    let answer = pixel.x - number * ANSWERS;
    let first = vec2i(number * CASE_TEXELS, pixel.y);
    let m = medium_of(first);
    let view = textureLoad(cases, first + vec2i(6, 0), 0);   // direction, altitude
    let light = textureLoad(cases, first + vec2i(7, 0), 0);  // sun, fraction
    let path = textureLoad(cases, first + vec2i(8, 0), 0);   // x, b, distance, samples
    let angle = textureLoad(cases, first + vec2i(9, 0), 0);  // 1 - cos, samples towards the sun, first, span of the sun's
    let share = textureLoad(cases, first + vec2i(10, 0), 0); // azimuth, row, whether to the ground, direction of a node
    let scale = textureLoad(cases, first + vec2i(11, 0), 0); // altitudes' steepness and growth, the sun's middle and width
    let d = densities(layers_of(m), view.w);
    if answer == 0 {
        return vec4f(d, rayleigh_phase(1.0 - angle.x));
    }
    if answer == 1 {
        return vec4f(extinction(coefficients_of(m), d), 0.0);
    }
    if answer == 2 {
        return vec4f(henyey_greenstein_phase(angle.x, 2.0 - angle.x, m.mie_asymmetry), 0.0);
    }
    if answer == 3 {
        return vec4f(cornette_shanks_phase(angle.x, 2.0 - angle.x, m.mie_asymmetry), 0.0);
    }
    return vec4f(mean_transmittance(extinction(coefficients_of(m), d) * path.z), 0.0);
}
