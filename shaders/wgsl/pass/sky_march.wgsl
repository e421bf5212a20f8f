//#include view
//#include single_scattering
//#include open_sun
// The background sky, marched along each ray: what a ray sees that meets no ground. Drawn first, depth ALWAYS, no
// depth write. Out: premultiplied radiance, and in alpha the grey share of what lies behind that the air takes away.

@group(0) @binding(0) var<uniform> frame: Frame;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let dir = normalize(pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up));
    let m = frame.medium;
    if hits_planet(dir, frame.altitude, m.radius) {
        if frame.low_resolution == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    let offset = dir - frame.sun;
    var light = vec3f(0.0);
    var through = vec3f(1.0);
    let ray = air_ray(dir, frame.altitude, m.radius, m.thickness, frame.sun);
    if ray.length > 0.0 {
        let s = single_scattering(
            m, ray, dir, ray.length, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
        light = s.radiance * frame.sky_weight;
        // What lies behind is dimmed in full: while this pass fades, the depth-aware one only adds light.
        through = s.transmittance;
    }
    return vec4f(min(light * m.irradiance, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
}
