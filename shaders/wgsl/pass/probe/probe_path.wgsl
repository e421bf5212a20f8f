//#include probe_case
//#include single_scattering
//#include open_sun
// The optical path and the transmittance to the sun, one case at a time.

const ANSWERS: i32 = 2;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let c = case_of(pixel, ANSWERS);
    let m = c.medium;
    let samples = u32(c.path.w);
    let layers = layers_of(m);
    if pixel.x % ANSWERS == 0 {
        return vec4f(path_densities(layers, m.radius, c.path.x, c.path.y, c.path.z, samples), 0.0);
    }
    return vec4f(sun_transmittance(
        coefficients_of(m), layers, m.radius, m.thickness, c.path.x, c.path.y, samples), 0.0);
}
