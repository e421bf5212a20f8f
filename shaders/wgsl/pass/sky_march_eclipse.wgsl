//#include view
//#include single_scattering
//#include all_orders
//#include eclipsed_sun
// The background sky under a moon's shadow, as `sky_march`. MULTI_SCATTERING: light of all orders from the medium's
// tables; off: light scattered once.

@group(0) @binding(1) var moon_shadow_lut: texture_2d<f32>;
@group(0) @binding(2) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(3) var multi_scattering_lut: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let frame = uniforms.frame;
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
        if MULTI_SCATTERING {
            let g = all_orders(
                transmittance_lut, multi_scattering_lut, m, uniforms.tables, ray, dir, frame.sun, ray.length);
            light = g.radiance * frame.sky_weight;
            through = exp(-extinction(coefficients_of(m), g.columns));
        } else {
            let s = single_scattering(
                m, ray, dir, ray.length, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples);
            light = s.radiance * frame.sky_weight;
            through = s.transmittance;
        }
    }
    return vec4f(min(light * m.irradiance, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
}
