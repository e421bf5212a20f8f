//#include probe_case
//#include path
//#include phase
// Densities, extinction, phase functions and the mean transmittance of a step, one case at a time.

const ANSWERS: i32 = 5;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let c = case_of(pixel, ANSWERS);
    let m = c.medium;
    let away = c.angle.x;
    let d = densities(layers_of(m), c.view.w);
    let sum = extinction(coefficients_of(m), d);
    switch pixel.x % ANSWERS {
        case 0: { return vec4f(d, rayleigh_phase(1.0 - away)); }
        case 1: { return vec4f(sum, 0.0); }
        case 2: { return vec4f(henyey_greenstein_phase(away, 2.0 - away, m.mie_asymmetry), 0.0); }
        case 3: { return vec4f(cornette_shanks_phase(away, 2.0 - away, m.mie_asymmetry), 0.0); }
        default: { return vec4f(mean_transmittance(sum * c.path.z), 0.0); }
    }
}
