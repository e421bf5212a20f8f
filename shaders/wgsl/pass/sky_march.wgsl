//#include view
//#include behind
//#include single_scattering
//#include open_sun
// The background sky, marched along each ray: what a ray sees that meets no ground, scattered once. Drawn
// first, depth ALWAYS, no depth write.

@group(0) @binding(0) var<uniform> frame: Frame;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = frame.medium;
    let dir = normalize(pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up));
    if hits_planet(dir, frame.altitude, m.radius) {
        if (frame.flags & REDUCED) == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    let ray = air_ray(dir, frame.altitude, m.radius, m.thickness, frame.sun);
    if ray.length <= 0.0 {
        return vec4f(0.0);
    }
    let offset = dir - frame.sun;
    let s = single_scattering(
        m, ray, dir, ray.length, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
    // What lies behind is dimmed in full: while this pass fades, the depth-aware one only adds light.
    let light = min(s.radiance * frame.sky_weight * m.irradiance, vec3f(most_light(frame.flags)));
    return vec4f(light, behind_alpha(dot(s.transmittance, vec3f(1.0 / 3.0))));
}
