//#include gather
//#include single_scattering
// Light along a ray under a moon's shadow, which breaks the symmetry that LUTs of the sky rest on: marched
// for each pixel, with the LUTs of the medium.

// Light of all orders over a ray's first `length` km. dir, sun: unit.
fn all_orders(
    transmittance_lut: texture_2d<f32>, multi_scattering_lut: texture_2d<f32>,
    m: Medium, luts: Luts, ray: AirRay, dir: vec3f, sun: vec3f, length: f32,
) -> Scattered {
    let perigee = perigee_of(ray, length, m.radius);
    let u_from = distance_to_u(perigee.distance, 0.0);
    let u_to = distance_to_u(perigee.distance, length);
    let gas = m.rayleigh * rayleigh_phase(ray.nu);
    let aerosol = m.mie_scattering * mie_phase_between(dir, sun, m.mie_asymmetry);
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, luts, ray, dir,
        perigee, u_from, u_to, luts.steps, gas, aerosol, 1.0);
    return Scattered(g.radiance, exp(-extinction(coefficients_of(m), g.optical_path)));
}

// Light of all orders with MULTI_SCATTERING, else light scattered once. dir, sun: unit.
fn eclipsed_light(
    transmittance_lut: texture_2d<f32>, multi_scattering_lut: texture_2d<f32>,
    m: Medium, luts: Luts, ray: AirRay, dir: vec3f, sun: vec3f, length: f32,
    view_samples: u32, light_samples: u32,
) -> Scattered {
    if MULTI_SCATTERING {
        return all_orders(transmittance_lut, multi_scattering_lut, m, luts, ray, dir, sun, length);
    } else {
        let offset = dir - sun;
        return single_scattering(m, ray, dir, length, 0.5 * dot(offset, offset), view_samples, light_samples);
    }
}
