//#include view
//#include behind
//#include all_orders
//#include eclipsed_sun
// The background sky under a moon's shadow, as `sky_march`: of all orders, or scattered once.

@group(0) @binding(1) var moon_shadow_lut: texture_2d<f32>;
@group(0) @binding(2) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(3) var multi_scattering_lut: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    if hits_planet(dir, f.altitude, m.radius) {
        if (f.flags & REDUCED) == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    let ray = air_ray(dir, f.altitude, m.radius, m.thickness, f.sun);
    if ray.length <= 0.0 {
        return vec4f(0.0);
    }
    let s = eclipsed_light(
        transmittance_lut, multi_scattering_lut, m, uniforms.luts, ray, dir, f.sun, ray.length,
        f.view_samples, f.light_samples);
    let light = min(s.radiance * f.sky_weight * m.irradiance, vec3f(most_light(f.flags)));
    return vec4f(light, behind_alpha(dot(s.transmittance, vec3f(1.0 / 3.0))));
}
