//#include luts
//#include sky_view_lut
//#include path
// The aerial LUT: the air between the camera and the scene (the idea: Hillaire 2020, section 5.4, a volume
// of the view; this one does not depend on where the camera looks). Per direction, as the sky-view LUT with
// fewer texels, slices along the ray, even in u (see `u_to_distance`). Slices stand side by side, four
// kinds of values above each other: the part of the ray's light that is scattered up to a slice's end,
// without and with the aerosol's (AIR_SMOOTH, AIR_MIE); the transmittance up to there with the aerosol's
// forward light counted as not scattered (AIR_BEAM), and with it counted as lost (AIR_TRANSMITTANCE). With
// each, in w, how far along the ray the slice ends, as a fraction of its length: between two rows that is
// not where it ends on a ray of its own, but it is where the interpolated value is reached.

const AIR_SMOOTH: i32 = 0;
const AIR_MIE: i32 = 1;
const AIR_BEAM: i32 = 2;
const AIR_TRANSMITTANCE: i32 = 3;
const AIR_KINDS: i32 = 4;

// A texel of the LUT.
struct AerialTexel {
    kind: i32,
    row: i32,
    column: i32,
    slice: i32,
    rows: i32,    // of a slice
    columns: i32,
}

fn aerial_texel(position: vec2f, luts: Luts) -> AerialTexel {
    let texel = vec2i(position);
    let columns = i32(luts.size.x / luts.slices);
    let rows = i32(luts.size.y) / AIR_KINDS;
    return AerialTexel(texel.y / rows, texel.y % rows, texel.x % columns, texel.x / columns, rows, columns);
}

// The same direction's texel of another kind and slice.
fn aerial_load(lut: texture_2d<f32>, a: AerialTexel, kind: i32, slice: i32) -> vec4f {
    return textureLoad(lut, vec2i(slice * a.columns + a.column, kind * a.rows + a.row), 0);
}

// A pixel's direction in the LUT: the position in one slice (texels), the size of a slice (texels), and how
// many slices there are.
struct AerialColumn {
    texel: vec2f,
    size: vec2f,
    slices: f32,
}

fn aerial_column(lut: texture_2d<f32>, luts: Luts, u: f32, v: f32, ground: bool) -> AerialColumn {
    let slices = f32(luts.slices);
    let size = vec2f(textureDimensions(lut)) / vec2f(slices, f32(AIR_KINDS));
    let row = v_to_row(v, ground, size.y, luts.aerial_ground_rows);
    return AerialColumn(vec2f(u * (size.x - 1.0), row), size, slices);
}

// A value at the end of a slice; at the camera, where it is `first`, for slice -1. w: fraction of the ray's
// length.
fn aerial_at(
    lut: texture_2d<f32>, sampling: sampler, c: AerialColumn, slice: f32, kind: i32, first: f32,
) -> vec4f {
    if slice < 0.0 {
        return vec4f(vec3f(first), 0.0);
    }
    let scale = 1.0 / vec2f(c.size.x * c.slices, c.size.y * f32(AIR_KINDS));
    let position = c.texel + c.size * vec2f(slice, f32(kind)) + 0.5;
    return textureSampleLevel(lut, sampling, position * scale, 0.0);
}

// The slice in which a point lies, with the transmittances before and behind it and where they are reached.
struct AerialSlice {
    index: f32,
    near: vec4f,
    far: vec4f,
}

// The slice that holds a distance along a path. Between rows slices end elsewhere than in u: from the slice
// that u tells, at most four further or nearer.
fn aerial_slice(
    lut: texture_2d<f32>, sampling: sampler, c: AerialColumn, path: AirPath, distance: f32,
) -> AerialSlice {
    let perigee = clamp(-path.r_mu, 0.0, path.length);
    let u0 = distance_to_u(perigee, 0.0);
    let u = (distance_to_u(perigee, distance) - u0) / (distance_to_u(perigee, path.length) - u0);
    let last = c.slices - 1.0;
    let fraction = min(distance / path.length, 1.0);
    var slice = clamp(floor(u * c.slices), 0.0, last);
    var near = aerial_at(lut, sampling, c, slice - 1.0, AIR_TRANSMITTANCE, 1.0);
    var far = aerial_at(lut, sampling, c, slice, AIR_TRANSMITTANCE, 1.0);
    for (var i = 0; i < 4 && fraction > far.w && slice < last; i++) {
        slice += 1.0;
        near = far;
        far = aerial_at(lut, sampling, c, slice, AIR_TRANSMITTANCE, 1.0);
    }
    for (var i = 0; i < 4 && fraction < near.w && slice > 0.0; i++) {
        slice -= 1.0;
        far = near;
        near = aerial_at(lut, sampling, c, slice - 1.0, AIR_TRANSMITTANCE, 1.0);
    }
    return AerialSlice(slice, near, far);
}

// Fraction of a slice's gas, aerosol and absorber (as if that were even) that lies in a part of its way.
// Where densities go from exp(-x0) to exp(-x1) and are exponential between, their mean is exp(-min(x0, x1))
// times that of exp(-s) over 0..|x1 - x0|. h0, h, h1: altitudes of the slice's begin, of the point and of
// the slice's end, km.
fn slice_fraction(inverse_heights: vec3f, h0: f32, h: f32, h1: f32, part: f32) -> vec3f {
    let rise = inverse_heights * (h - h0);
    let whole = inverse_heights * (h1 - h0);
    let ratio = mean_transmittance(abs(rise)) / mean_transmittance(abs(whole));
    let densest = exp(max(-rise, vec3f(0.0)) - max(-whole, vec3f(0.0)));
    return clamp(part * ratio * densest, vec3f(0.0), vec3f(1.0));
}

// The same for a distance along a path within a slice. Light grows with the air that is passed, not with u:
// next to the camera u is the distance's root.
fn slice_passed(s: AerialSlice, path: AirPath, distance: f32, m: Medium) -> vec3f {
    let fraction = min(distance / path.length, 1.0);
    let part = clamp((fraction - s.near.w) / max(s.far.w - s.near.w, 1e-9), 0.0, 1.0);
    return slice_fraction(
        vec3f(m.rayleigh_inv_height, m.mie_inv_height, 0.0),
        altitude_after(path.excess, path.r_mu, s.near.w * path.length, m.radius),
        altitude_after(path.excess, path.r_mu, distance, m.radius),
        altitude_after(path.excess, path.r_mu, s.far.w * path.length, m.radius),
        part,
    );
}

// Optical depth of a slice.
fn slice_depth(s: AerialSlice) -> vec3f {
    return -log(clamp(s.far.xyz / max(s.near.xyz, vec3f(1e-30)), vec3f(1e-30), vec3f(1.0)));
}

// The part of the whole ray's light, of a kind, up to a point in a slice of which `passed` has been passed.
fn aerial_light(
    lut: texture_2d<f32>, sampling: sampler, c: AerialColumn, slice: f32, kind: i32, passed: vec3f,
) -> vec3f {
    let near = aerial_at(lut, sampling, c, slice - 1.0, kind, 0.0).xyz;
    return mix(near, aerial_at(lut, sampling, c, slice, kind, 0.0).xyz, passed);
}
