// What all look-up tables (LUTs) share: their block, and how one is read between its texels. Texels sit on
// both ends of each axis. What fills other LUTs is interpolated here, in 32-bit floats: the same on every
// driver. What pixels read the sampler interpolates.
//
// transmittance_lut:    log2 of the optical path (km) from an altitude to the top: gas, aerosol, absorber.
// multi_scattering_lut: all light that was scattered before, as angular moments per altitude and sun angle.
// sky_view_lut, mie_single_lut: the light of every direction around the camera.
// aerial_lut:           how bright the air is up to a distance, in every direction.
//
// Rust twin: `LutsUniform` in src/frame/luts.rs.

struct Luts {
    mie_extinction: vec3f,      // aerosol, less the light that it turns by small angles only, 1/km
    altitude_steepness: f32,    // altitude grows like expm1(steepness v^2) over rows of moments
    mie_moment0: vec3f,         // phase moments l = 0, 1, 2 of the rest, times its fraction (delta-M)
    altitude_growth: f32,       // expm1(altitude_steepness)
    mie_moment1: vec3f,
    sun_middle: f32,            // cosine of the sun's zenith angle where columns of moments crowd
    mie_moment2: vec3f,
    sun_width: f32,             // of the crowd, in the cosine
    mie_asymmetry: vec3f,       // of the rest
    pad: f32,
    albedo: vec3f,              // of the ground, Lambert
    sun_first: f32,             // asinh((cosine - middle) / width) of the first column of moments
    sun_span: f32,              // ... of the last, less the first
    ground_rows: f32,           // rows for rays to the ground, of the LUT that is filled or the sky view
    size: vec2u,                // of the LUT that is filled, texels
    steps: u32,                 // along a ray, or along a slice's part of it
    pad1: u32,
    slices: u32,                // of the aerial LUT
    aerial_ground_rows: f32,    // rows of the aerial LUT for rays that end on the ground
}

const LOG_FLOOR: f32 = -100.0; // log2 of next to nothing

// Four texels around a position counted in texels, and where it lies between them.
struct Corner {
    first: vec2i,
    last: vec2i,
    between: vec2f,
}

fn corner(position: vec2f, size: vec2i) -> Corner {
    let inside = clamp(position, vec2f(0.0), vec2f(size - 1));
    let first = min(vec2i(inside), size - 1);
    return Corner(first, min(first + 1, size - 1), inside - vec2f(first));
}

// Bilinear interpolation between these texels, counted from `origin`.
fn bilinear(lut: texture_2d<f32>, c: Corner, origin: vec2i) -> vec4f {
    let first = c.first + origin;
    let last = c.last + origin;
    let bottom = mix(textureLoad(lut, first, 0), textureLoad(lut, vec2i(last.x, first.y), 0), c.between.x);
    let top = mix(textureLoad(lut, vec2i(first.x, last.y), 0), textureLoad(lut, last, 0), c.between.x);
    return mix(bottom, top, c.between.y);
}
