//#include aerial
//#include aerial_lut
//#include transmittance_lut
// The air up to a point on a ray, from LUTs. The light of the ray's whole length is in the sky-view LUT; the
// aerial LUT tells which part of it comes from before the point.

const MIE_SINGLE: bool = true; // With sunlight scattered once by the aerosol, which has a LUT of its own.

// Transmittance and light of a part of a ray.
struct AirBefore {
    transmittance: vec3f,
    inscatter: vec3f, // 1/sr
}

// The air before a point at a distance (km) along a path. smooth_light, mie_light: of the whole path.
fn air_before(
    aerial_lut: texture_2d<f32>, linear: sampler, m: Medium, path: AirPath, column: AerialColumn,
    distance: f32, smooth_light: vec3f, mie_light: vec3f,
) -> AirBefore {
    let s = aerial_slice(aerial_lut, linear, column, path, distance);
    let passed = slice_passed(s, path, distance, m);
    // Optical depth grows with the gas that is passed, and light by what it lets through.
    let tau = slice_depth(s);
    let seen = mean_transmittance(tau * passed.x) / mean_transmittance(tau);
    var light = smooth_light;
    var mie = mie_light;
    if distance < path.length {
        light *= aerial_light(aerial_lut, linear, column, s.index, AIR_SMOOTH, passed.x * seen);
        if MIE_SINGLE {
            let mie_passed = min(passed.y * seen, vec3f(1.0));
            mie *= aerial_light(aerial_lut, linear, column, s.index, AIR_MIE, mie_passed);
        }
    }
    if MIE_SINGLE {
        light += mie;
    }
    return AirBefore(s.near.xyz * exp(-tau * passed.x), light);
}

// Transmittance of a whole path to space.
fn whole_transmittance(transmittance_lut: texture_2d<f32>, m: Medium, path: AirPath) -> vec3f {
    let h = altitude_of(path.excess, m.radius);
    let sums = optical_path_to_top(transmittance_lut, m.radius, m.thickness, path.excess, h, path.r_mu);
    return exp(-extinction(coefficients_of(m), sums));
}

// The light of a whole path: of the sky-view LUT at uv, and of the aerosol's own by its phase function.
// Where the path ends on the ground, LUTs hold the mean over its length (km).
struct PathLight {
    smooth_light: vec3f,
    mie_light: vec3f,
}

fn path_light(
    sky_view_lut: texture_2d<f32>, mie_single_lut: texture_2d<f32>, linear: sampler, uv: vec2f,
    ground: bool, length: f32, phase: vec3f,
) -> PathLight {
    let scale = select(1.0, length, ground);
    let smooth_light = decode_light(textureSampleLevel(sky_view_lut, linear, uv, 0.0).rgb) * scale;
    var mie_light = vec3f(0.0);
    if MIE_SINGLE {
        mie_light = decode_light(textureSampleLevel(mie_single_lut, linear, uv, 0.0).rgb) * scale * phase;
    }
    return PathLight(smooth_light, mie_light);
}
