//#include luts
//#include sky_view_lut
//#include path
// The aerial LUT: how bright the air is between the camera and the scene (the idea: Hillaire 2020, section
// 5.4, a volume of the view; this one does not depend on where the camera looks). Per direction, as the
// sky-view LUT with fewer texels; along the ray at slices, even in u (see `u_to_distance`), from the camera
// to the ray's end.
//
// The light before a point grows with what the air there takes away, L = S (1 - T), and S, the brightness of
// the air so far, changes slowly along a ray and from ray to ray: where T is known (`columns`), next to the
// horizon too. The LUT holds S over the light of the whole ray, times `rough_opacity` of that, which pixels
// can afford: a number around 1. Slices stand side by side, two kinds of light above each other: scattered
// once by the aerosol (AIR_MIE), and all other (AIR_SMOOTH).

const AIR_SMOOTH: i32 = 0;
const AIR_MIE: i32 = 1;
const AIR_KINDS: i32 = 2;

// What is summed up for it has a third kind of values: densities integrated (AIR_PATH, km).
const AIR_PATH: i32 = 2;
const AIR_SUMMANDS: i32 = 3;

// A texel of the LUT, or of what is summed up for it.
struct AerialTexel {
    kind: i32,
    row: i32,
    column: i32,
    slice: i32,
    rows: i32,
    columns: i32,
}

fn aerial_texel(position: vec2f, luts: Luts, kinds: i32) -> AerialTexel {
    let texel = vec2i(position);
    let columns = i32(luts.size.x / luts.slices);
    let rows = i32(luts.size.y) / kinds;
    return AerialTexel(texel.y / rows, texel.y % rows, texel.x % columns, texel.x / columns, rows, columns);
}

// The ray of a texel's direction: see `sky_view_ray`. ground_rows: how many rows of the LUT look down.
fn aerial_ray(
    a: AerialTexel, ground_rows: f32, h: f32, radius: f32, thickness: f32, mapping: vec4f, sun: vec3f,
) -> SkyViewRay {
    let u = f32(a.column) / f32(a.columns - 1);
    let row = row_to_v(a.row, a.rows, i32(ground_rows));
    return sky_view_ray(u, row.x, row.y > 0.5, h, radius, thickness, mapping, sun);
}

// Coefficients of what counts as taken from light on its way (1/km): what gas and aerosol take, but for what
// the aerosol turns by small angles only. The absorber would be a step where rays begin to pass it.
fn scatterer_coefficients(m: Medium, luts: Luts) -> mat3x3f {
    return mat3x3f(m.rayleigh, luts.mie_extinction, vec3f(0.0));
}

// A point of a ray in the LUT: the position in one slice (texels), the size of a slice (texels), how many
// slices there are, and where the point is among them.
struct AerialPoint {
    texel: vec2f,
    size: vec2f,
    slices: f32,
    slice: f32,
}

// A point at a distance (km) along a path.
fn aerial_point(
    lut: texture_2d<f32>, luts: Luts, u: f32, v: f32, ground: bool, path: AirPath, distance: f32,
) -> AerialPoint {
    let slices = f32(luts.slices);
    let size = vec2f(textureDimensions(lut)) / vec2f(slices, f32(AIR_KINDS));
    let row = v_to_row(v, ground, size.y, luts.aerial_ground_rows);
    let perigee = clamp(-path.r_mu, 0.0, path.length);
    let u0 = distance_to_u(perigee, 0.0);
    let part = (distance_to_u(perigee, distance) - u0) / (distance_to_u(perigee, path.length) - u0);
    return AerialPoint(
        vec2f(u * (size.x - 1.0), row), size, slices, clamp(part, 0.0, 1.0) * (slices - 1.0));
}

// The brightness of a kind of light up to a point, as the LUT has it.
fn aerial_brightness(lut: texture_2d<f32>, sampling: sampler, p: AerialPoint, kind: i32) -> vec3f {
    let first = min(floor(p.slice), p.slices - 2.0);
    let scale = 1.0 / vec2f(p.size.x * p.slices, p.size.y * f32(AIR_KINDS));
    let near = (p.texel + p.size * vec2f(first, f32(kind)) + 0.5) * scale;
    let far = near + vec2f(p.size.x * scale.x, 0.0);
    return mix(
        textureSampleLevel(lut, sampling, near, 0.0).xyz, textureSampleLevel(lut, sampling, far, 0.0).xyz,
        p.slice - first);
}
