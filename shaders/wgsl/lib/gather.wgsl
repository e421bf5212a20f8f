//#include path
//#include transmittance_lut
//#include multi_scattering_lut
// Light of all orders along a ray, with the LUTs of the medium. Per unit of the sun's irradiance: 1/sr. One
// function fills all other LUTs, so that they agree. A program includes `open_sun` or `eclipsed_sun` too.

const MULTI_SCATTERING: bool = true; // Light is scattered again; off: sunlight alone.

struct Gathered {
    radiance: vec3f,       // 1/sr
    transmittance: vec3f,  // with the aerosol's forward light counted as not scattered
    optical_path: vec3f,   // densities integrated, km
}

// From u_from to u_to in even steps of u (see `u_to_distance`), L = sum of T (S_sun + multiple S_before)
// over steps: of each step the part that the sun reaches, with the transmittance LUT towards it, and what
// the multi-scattering LUT holds of light that was scattered before, times `multiple`. gas, aerosol:
// scattering coefficient at altitude 0 times phase function for direct sunlight, 1/(km sr). The aerosol's
// extinction is that without its forward light, which goes on as if it were not scattered (delta-M,
// Wiscombe 1977). dir: the ray's, unit.
fn gather(
    transmittance_lut: texture_2d<f32>, multi_scattering_lut: texture_2d<f32>,
    m: Medium, luts: Luts, ray: AirRay, dir: vec3f,
    perigee: Perigee, u_from: f32, u_to: f32, steps: u32, gas: vec3f, aerosol: vec3f, multiple: f32,
) -> Gathered {
    let layers = layers_of(m);
    let coefficients = mat3x3f(m.rayleigh, luts.mie_extinction, m.ozone);
    let shadow = shadow_stretch(ray);
    let axis = sun_axis(luts);
    let span = multi_scattering_span(multi_scattering_lut);
    let moments = mat3x3f(
        m.mie_scattering * luts.mie_moment0,
        m.mie_scattering * luts.mie_moment1,
        m.mie_scattering * luts.mie_moment2,
    );
    let nearest = perigee.distance;
    let du = (u_to - u_from) / f32(steps);
    var out = Gathered(vec3f(0.0), vec3f(1.0), vec3f(0.0));
    var t0 = u_to_distance(nearest, u_from);
    for (var i = 0u; i < steps; i++) {
        let u = u_from + du * f32(i);
        let t1 = u_to_distance(nearest, u + du);
        let step = t1 - t0;
        let mid = u_to_distance(nearest, u + 0.5 * du);
        let h = altitude_after(perigee.excess, perigee.r_mu, mid - nearest, m.radius);
        let d = densities(layers, h);
        let tau = extinction(coefficients, d) * step;
        let weight = out.transmittance * mean_transmittance(tau);
        let dark = dark_part(shadow, t0, t1);
        if dark.z < step {
            var lit = mid;
            if dark.z > 0.0 {
                lit = lit_middle(dark, nearest, t0, t1);
            }
            let past = lit - nearest;
            let lit_excess = max(perigee.excess + past * (2.0 * perigee.r_mu + past), 0.0);
            let lit_h = altitude_of(lit_excess, m.radius);
            let lit_d = densities(layers, lit_h);
            let sun_r_mu = ray.sun_r_mu + ray.nu * lit;
            let path = optical_path_to_top(
                transmittance_lut, m.radius, m.thickness, lit_excess, lit_h, sun_r_mu);
            var source = (gas * lit_d.x + aerosol * lit_d.y) * exp(-extinction(coefficients, path));
            source *= sun_visibility(dir, ray.start + lit);
            out.radiance += weight * source * (step - dark.z);
        }
        if MULTI_SCATTERING {
            let r = m.radius + h;
            let mu = clamp((perigee.r_mu + mid - nearest) / r, -1.0, 1.0);
            let mu_sun = clamp((ray.sun_r_mu + ray.nu * mid) / r, -1.0, 1.0);
            let v = altitude_to_v(luts.altitude_steepness, luts.altitude_growth, h, m.thickness);
            let node = vec2f(mu_sun_to_u(axis, mu_sun), v) * span;
            let before = multi_scattering_source(
                multi_scattering_lut, node, m.rayleigh, moments, mu, mu_sun, ray.nu);
            let around = sun_visibility_around(dir, ray.start + mid);
            let source = before.gas * around * d.x + before.aerosol * around * d.y;
            out.radiance += weight * (step * multiple) * source;
        }
        out.transmittance *= exp(-tau);
        out.optical_path += d * step;
        t0 = t1;
    }
    return out;
}
