//#include lut_air
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
@group(0) @binding(5) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(6) var lit_fraction: texture_2d<f32>;
@group(0) @binding(8) var linear: sampler;

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
    let line = line_to_scene(
        line_past(dir, f.altitude, m.radius), f.altitude, distance, m.radius, m.thickness, f.pixel_angle);
    let path = air_path(line, f.altitude, m.radius, m.thickness);
    let ground = line.ground && path.length >= 0.0;
    let end = ray_end(
        path.start, path.length, path.r_mu, ground, distance,
        m.radius, f.pixel_angle, f.shell_weight, f.flags);
    if end.length <= 0.0 || end.weight <= 0.0 {
        return scene;
    }
    let u = azimuth_to_u(dir);
    let v = zenith_to_v(line, dir.z, f.altitude, m.radius, m.thickness, f.sky_view_mapping);
    let size = vec2f(textureDimensions(sky_view_lut));
    let uv = sky_view_uv(u, v_to_row(v, ground, size.y, luts.ground_rows), size);
    let whole = path_light(
        sky_view_lut, mie_single_lut, linear, uv, ground, path.length,
        mie_phase_between(dir, f.sun, m.mie_asymmetry));
    let air = air_before(
        aerial_lut, linear, m, luts, line, path, u, v, end.length, whole.smooth_light, whole.mie_light);
    let transmittance = select(vec3f(1.0), air.transmittance, end.dims);
    let light = air.inscatter * m.irradiance * (end.weight * lit_fraction_at(lit_fraction, pixel));
    return compose(scene, transmittance, light, most_light(f.flags));
}
