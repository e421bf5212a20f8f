//#include probe_case
//#include single_scattering
//#include open_sun
// Single scattering along a ray, one case at a time.

const ANSWERS: i32 = 2;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let c = case_of(pixel, ANSWERS);
    let m = c.medium;
    let ray = air_ray(c.view.xyz, c.view.w, m.radius, m.thickness, c.light.xyz);
    let offset = c.view.xyz - c.light.xyz;
    let away = 0.5 * dot(offset, offset);
    let length = max(ray.length, 0.0) * c.light.w;
    let s = single_scattering(m, ray, c.view.xyz, length, away, u32(c.path.w), u32(c.angle.y));
    if pixel.x % ANSWERS == 0 {
        return vec4f(s.radiance, length);
    }
    return vec4f(s.transmittance, f32(ray.ground));
}
