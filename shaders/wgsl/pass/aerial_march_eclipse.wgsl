//#include aerial
//#include all_orders
//#include eclipsed_sun
// The air between the camera and the scene under a moon's shadow, as `aerial_march`: of all orders, or
// scattered once.

@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;
@group(0) @binding(3) var moon_shadow_lut: texture_2d<f32>;
@group(0) @binding(4) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(5) var multi_scattering_lut: texture_2d<f32>;
@group(0) @binding(6) var lit_fraction: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
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
    let seen = direction / ray_length;
    let line = line_to_scene(
        line_past(seen, f.altitude, m.radius), f.altitude, distance, m.radius, m.thickness, f.pixel_angle);
    let dir = line_direction(line, seen, m.radius + f.altitude);
    let ray = air_ray_of(line, dir, f.altitude, m.radius, m.thickness, f.sun);
    let end = ray_end(
        ray.start, ray.length, ray.r_mu, ray.ground, distance,
        m.radius, f.pixel_angle, f.shell_weight, f.flags);
    if end.length <= 0.0 || end.weight <= 0.0 {
        return scene;
    }
    let s = eclipsed_light(
        transmittance_lut, multi_scattering_lut, m, uniforms.luts, ray, dir, f.sun, end.length,
        f.view_samples, f.light_samples);
    let transmittance = select(vec3f(1.0), s.transmittance, end.dims);
    let light = s.radiance * m.irradiance * (end.weight * lit_fraction_at(lit_fraction, pixel));
    return compose(scene, transmittance, light, most_light(f.flags));
}
