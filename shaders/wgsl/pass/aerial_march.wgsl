//#include aerial
//#include single_scattering
//#include open_sun
// The air between the camera and the scene, marched along each ray: the scene dimmed by transmittance, per
// channel, plus the light scattered once into the ray on the way.

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;
@group(0) @binding(3) var lit_fraction: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = frame.medium;
    let pixel = vec2i(position.xy);
    var scene = vec4f(0.0);
    if BLEND {
    } else {
        scene = textureLoad(scene_color, pixel, 0);
    }
    let direction = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(frame.depth, textureLoad(scene_depth, pixel, 0).x, ray_length);
    let seen = direction / ray_length;
    let line = line_to_scene(
        line_past(seen, frame.altitude, m.radius), frame.altitude, distance, m.radius, m.thickness,
        frame.pixel_angle);
    let dir = line_direction(line, seen, m.radius + frame.altitude);
    let ray = air_ray_of(line, dir, frame.altitude, m.radius, m.thickness, frame.sun);
    let end = ray_end(
        ray.start, ray.length, ray.r_mu, ray.ground, distance,
        m.radius, frame.pixel_angle, frame.shell_weight, frame.flags);
    if end.length <= 0.0 || end.weight <= 0.0 {
        return scene;
    }
    let offset = dir - frame.sun;
    let s = single_scattering(
        m, ray, dir, end.length, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
    let transmittance = select(vec3f(1.0), s.transmittance, end.dims);
    let light = s.radiance * m.irradiance * (end.weight * lit_fraction_at(lit_fraction, pixel));
    return compose(scene, transmittance, light, most_light(frame.flags));
}
