//#include aerial
//#include aerial_lut
//#include columns
// The air up to a point on a ray, from LUTs. The light of the ray's whole length is in the sky-view LUT; the
// aerial LUT tells which part of it comes from before the point.

const MIE_SINGLE: bool = true; // With sunlight scattered once by the aerosol, which has a LUT of its own.

// Transmittance and light of a part of a ray.
struct AirBefore {
    transmittance: vec3f,
    inscatter: vec3f, // 1/sr
}

// The air before a point at a distance (km) along a path. smooth_light, mie_light: of the whole path; u, v:
// the ray's in the LUTs.
fn air_before(
    aerial_lut: texture_2d<f32>, linear: sampler, m: Medium, luts: Luts, line: Line, path: AirPath,
    u: f32, v: f32, distance: f32, smooth_light: vec3f, mie_light: vec3f,
) -> AirBefore {
    let layers = layers_of(m);
    let to_end = distance >= path.length;
    let near = path_columns(layers, line, path, min(distance, path.length), to_end, m.radius);
    var light = smooth_light;
    var mie = mie_light;
    if !to_end {
        let scatterers = scatterer_coefficients(m, luts);
        let all = lowest_point(
            path.excess, path.r_mu, line.perigee_excess, line.ground, path.length, m.radius);
        let rough = rough_opacity(
            layers, scatterers, all.excess, all.r_mu, -all.distance, path.length - all.distance, m.radius);
        // A camera far away enters air so thin that there is none.
        let part = opacity(extinction(scatterers, near)) / max(rough, vec3f(1e-30));
        let point = aerial_point(aerial_lut, luts, u, v, line.ground, path, distance);
        light *= min(part * aerial_brightness(aerial_lut, linear, point, AIR_SMOOTH), vec3f(1.0));
        if MIE_SINGLE {
            mie *= min(part * aerial_brightness(aerial_lut, linear, point, AIR_MIE), vec3f(1.0));
        }
    }
    if MIE_SINGLE {
        light += mie;
    }
    return AirBefore(exp(-extinction(coefficients_of(m), near)), light);
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
