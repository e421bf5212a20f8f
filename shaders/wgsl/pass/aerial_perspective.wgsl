//#include aerial
//#include aerial_lut
//#include transmittance_lut
//#include phase
// The air between the camera and the scene from LUTs, as `aerial_march` with all orders of scattering. The
// light of the ray's whole length is in the sky-view LUT; the aerial LUT tells which part of it comes from
// before the scene.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;
@group(0) @binding(3) var sky_view_lut: texture_2d<f32>;
@group(0) @binding(4) var aerial_lut: texture_2d<f32>;
@group(0) @binding(5) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(6) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(7) var linear: sampler;

const MIE_SINGLE: bool = true; // With sunlight scattered once by the aerosol, which has a LUT of its own.

// Transmittance and light of a part of a ray.
struct AirBefore {
    transmittance: vec3f,
    inscatter: vec3f, // 1/sr
}

// The air before a point at a distance (km) along a path. smooth_light, mie_light: of the whole path.
fn air_before(
    m: Medium, path: AirPath, column: AerialColumn, distance: f32, smooth_light: vec3f, mie_light: vec3f,
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
fn whole_transmittance(m: Medium, path: AirPath) -> vec3f {
    let h = altitude_of(path.excess, m.radius);
    let sums = optical_path_to_top(transmittance_lut, m.radius, m.thickness, path.excess, h, path.r_mu);
    return exp(-extinction(coefficients_of(m), sums));
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let luts = uniforms.luts;
    let m = f.medium;
    let pixel = vec2i(position.xy);
    var scene = vec4f(0.0);
    if BLEND {
    } else {
        scene = textureLoad(scene_color, pixel, 0);
    }
    let direction = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(f.depth, textureLoad(scene_depth, pixel, 0).x, ray_length);
    let dir = direction / ray_length;
    let line = line_past(dir, f.altitude, m.radius);
    let path = air_path(line, f.altitude, m.radius, m.thickness);
    let ground = line.ground && path.length >= 0.0;
    let end = ray_end(
        path.start, path.length, path.r_mu, ground, distance, m.radius, f.pixel_angle, f.shell_weight);
    if end.length <= 0.0 || end.weight <= 0.0 {
        return scene;
    }
    // The light of the whole path; where it ends on the ground the LUTs hold the mean over its length.
    let u = azimuth_to_u(dir);
    let v = zenith_to_v(line, dir.z, f.altitude, m.radius, m.thickness, f.sky_view_mapping);
    let size = vec2f(textureDimensions(sky_view_lut));
    let uv = sky_view_uv(u, v_to_row(v, ground, size.y, luts.ground_rows), size);
    let scale = select(1.0, path.length, ground);
    let smooth_light = decode_light(textureSampleLevel(sky_view_lut, linear, uv, 0.0).rgb) * scale;
    var mie_light = vec3f(0.0);
    if MIE_SINGLE {
        mie_light = decode_light(textureSampleLevel(mie_single_lut, linear, uv, 0.0).rgb) * scale
            * mie_phase_between(dir, f.sun, m.mie_asymmetry);
    }
    var air = AirBefore(vec3f(1.0), smooth_light + mie_light);
    if !ground && end.length >= path.length {
        if end.dims {
            air.transmittance = whole_transmittance(m, path);
        }
    } else {
        let column = aerial_column(aerial_lut, luts, u, v, ground);
        air = air_before(m, path, column, end.length, smooth_light, mie_light);
    }
    return compose(scene, air.transmittance, air.inscatter * m.irradiance * end.weight);
}
