//#include gather
//#include phase
// Light of all orders along a ray, marched for each pixel: where a moon's shadow breaks the symmetry that tables of the
// sky rest on.

// Over a ray's first `length` km. dir, sun: unit.
fn all_orders(
    transmittance_lut: texture_2d<f32>, multi_scattering_lut: texture_2d<f32>,
    m: Medium, t: Tables, ray: AirRay, dir: vec3f, sun: vec3f, length: f32,
) -> Gathered {
    let low = lowest(ray, length, m.radius);
    let gas = m.rayleigh * rayleigh_phase(ray.nu);
    let aerosol = m.mie_scattering * aerosol_phase(dir, sun, m.mie_asymmetry);
    return gather(
        transmittance_lut, multi_scattering_lut, m, t, ray, dir,
        low, unwarp(low.t, 0.0), unwarp(low.t, length), gas, aerosol, 1.0);
}
