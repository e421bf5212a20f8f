//#include view
//#include reach
//#include single_scattering
//#include open_sun
// Air between the camera and the scene: the scene dimmed by transmittance, per channel, plus the light
// scattered into the ray on the way. Where there is no scene it draws the shell's share of the sky
// (all of it from orbit, none of it near the ground, where the background pass has drawn it).

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;

const BLEND: bool = true; // laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    var behind = vec4f(0.0);
    if BLEND {
    } else {
        behind = textureLoad(scene_color, pixel, 0);
    }
    let direction = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(frame.depth, textureLoad(scene_depth, pixel, 0).x, ray_length);
    let dir = direction / ray_length;
    let m = frame.medium;
    let ray = air_ray(dir, frame.altitude, m.radius, m.thickness, frame.sun);
    var end = ray.length;
    var weight = 1.0;
    var dims = true;
    if distance >= 0.0 {
        end = scene_reach(ray.start, ray.length, ray.b, ray.ground, distance, m.radius, frame.pixel_angle);
    } else if !ray.ground {
        weight = frame.shell_weight;
        // The background pass, as long as it draws any air, has dimmed what lies behind.
        dims = weight >= 1.0;
    }
    if end <= 0.0 || weight <= 0.0 {
        return behind;
    }
    let offset = dir - frame.sun;
    let s = single_scattering(
        m, ray, dir, end, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
    let through = select(vec3f(1.0), s.transmittance, dims);
    let light = s.radiance * m.irradiance * weight;
    if BLEND {
        return vec4f(min(light, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
    } else {
        let dimmed = behind.rgb * through; // never cut, whatever the scene holds
        return vec4f(dimmed + min(light, max(HALF_MAX - dimmed, vec3f(0.0))), behind.a);
    }
}
