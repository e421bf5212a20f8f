//#include march
//#include skylight
// Light of all orders along a ray, marched for each pixel: where a moon's shadow breaks the symmetry that tables of the
// sky rest on.

struct Scattered {
    radiance: vec3f,       // 1/sr
    transmittance: vec3f,  // 0 to 1
}

// Over a ray's first `length` km. dir, sun: unit; the shadow as in `moon_shadow`.
fn all_orders(
    columns: texture_2d<f32>, moments: texture_2d<f32>, shade: texture_2d<f32>,
    m: Medium, t: Tables, ray: AirRay, dir: vec3f, sun: vec3f, shadow: MoonShadow, length: f32,
) -> Scattered {
    let low = lowest(ray, length, m.radius);
    let gas = m.rayleigh * rayleigh_phase(ray.nu);
    let aerosol = m.mie_scattering * aerosol_phase(dir, sun, m.mie_asymmetry);
    let g = gather(
        columns, moments, m, t, ray, dir, sun, shadow, shade,
        low, unwarp(low.t, 0.0), unwarp(low.t, length), gas, aerosol, 1.0);
    return Scattered(g.radiance, exp(-extinction(coefficients_of(m), g.columns)));
}
