//#include view
//#include reach
//#include single_scattering
//#include all_orders
//#include eclipsed_sun
// Air between the camera and the scene under a moon's shadow, as `aerial_march`. MULTI_SCATTERING: light of all orders
// from the medium's tables; off: light scattered once.

@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;
@group(0) @binding(3) var moon_shadow_lut: texture_2d<f32>;
@group(0) @binding(4) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(5) var multi_scattering_lut: texture_2d<f32>;

const BLEND: bool = true; // laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let frame = uniforms.frame;
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
    var radiance = vec3f(0.0);
    var transmittance = vec3f(1.0);
    if MULTI_SCATTERING {
        let g = all_orders(
            transmittance_lut, multi_scattering_lut, m, uniforms.tables, ray, dir, frame.sun, end);
        radiance = g.radiance;
        transmittance = exp(-extinction(coefficients_of(m), g.columns));
    } else {
        let s = single_scattering(
            m, ray, dir, end, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
        radiance = s.radiance;
        transmittance = s.transmittance;
    }
    let through = select(vec3f(1.0), transmittance, dims);
    let light = radiance * m.irradiance * weight;
    if BLEND {
        return vec4f(min(light, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
    } else {
        let dimmed = behind.rgb * through; // never cut, whatever the scene holds
        return vec4f(dimmed + min(light, max(HALF_MAX - dimmed, vec3f(0.0))), behind.a);
    }
}
