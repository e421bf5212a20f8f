//#include frame
//#include path
//#include phase
// Single scattering along a ray through a spherical atmosphere, with the planet's own shadow. Per unit of
// the sun's irradiance: radiance in 1/sr. A program includes `open_sun` or `eclipsed_sun` too.

const SUNLIGHT: bool = true; // Sunlight reaches the air; off: it dims what lies behind and sends no light.

// What a ray collects.
struct Scattered {
    radiance: vec3f,       // 1/sr
    transmittance: vec3f,  // 0 to 1
}

// Transmittance from a point to the sun, whose disk's centre is above the point's horizon: exp(-tau), tau
// the optical depth to the top of the air (Nishita et al. 1993, equation 4). excess, sun_r_mu: of the point
// and towards the sun.
fn sun_transmittance(
    coefficients: mat3x3f, layers: mat2x3f, radius: f32, thickness: f32,
    excess: f32, sun_r_mu: f32, samples: u32,
) -> vec3f {
    let distance = distance_to_top(excess, sun_r_mu, excess_of(thickness, radius));
    let sums = path_densities(layers, radius, excess, sun_r_mu, distance, samples);
    return exp(-extinction(coefficients, sums));
}

// Light scattered once into a ray over its first `length` km, and what the ray lets through (Nishita et al.
// 1993, equations 3 to 9):
//   L = integral of T(0, t) T(t, sun) (beta_R p_R d_R + beta_M p_M d_M) dt
// by steps even in u (see `u_to_distance`). Within a step the extinction is even: `mean_transmittance`. What
// of a step lies in the planet's shadow is left out exactly. dir: unit; away: 1 - cos of the angle between
// ray and sun.
fn single_scattering(
    m: Medium, ray: AirRay, dir: vec3f, length: f32, away: f32, view_samples: u32, light_samples: u32,
) -> Scattered {
    var rayleigh = vec3f(0.0);
    var mie = vec3f(0.0);
    var shadow = vec2f(0.0);
    if SUNLIGHT {
        shadow = shadow_stretch(ray);
        if RAYLEIGH {
            rayleigh = m.rayleigh * rayleigh_phase(1.0 - away);
        }
        if MIE {
            // 1 + cos: the squared sine over 1 - cos, where that is the small one.
            let toward = select(2.0 - away, ray.sin2 / max(away, 1.0), away > 1.0);
            mie = m.mie_scattering * mie_phase(away, toward, m.mie_asymmetry);
        }
    }
    let layers = layers_of(m);
    let coefficients = coefficients_of(m);
    let perigee = perigee_of(ray, length, m.radius);
    let nearest = perigee.distance;
    let u0 = -sqrt(nearest);
    let du = (sqrt(length - nearest) - u0) / f32(view_samples);
    var out = Scattered(vec3f(0.0), vec3f(1.0));
    var t0 = 0.0;
    for (var i = 0u; i < view_samples; i++) {
        let u = u0 + du * f32(i);
        let t1 = u_to_distance(nearest, u + du);
        let mid = u_to_distance(nearest, u + 0.5 * du);
        let h = altitude_after(perigee.excess, perigee.r_mu, mid - nearest, m.radius);
        let step = t1 - t0;
        let tau = extinction(coefficients, densities(layers, h)) * step;
        if SUNLIGHT {
            let dark = dark_part(shadow, t0, t1);
            if dark.z < step {
                var lit = mid;
                if dark.z > 0.0 {
                    lit = lit_middle(dark, nearest, t0, t1);
                }
                let past = lit - nearest;
                let excess = perigee.excess + past * (2.0 * perigee.r_mu + past);
                let d = densities(layers, max(altitude_of(excess, m.radius), 0.0));
                var source = vec3f(0.0);
                if RAYLEIGH {
                    source += rayleigh * d.x;
                }
                if MIE {
                    source += mie * d.y;
                }
                let sun_r_mu = ray.sun_r_mu + ray.nu * lit;
                source *= sun_transmittance(
                    coefficients, layers, m.radius, m.thickness, excess, sun_r_mu, light_samples);
                source *= sun_visibility(dir, ray.start + lit);
                out.radiance += out.transmittance * mean_transmittance(tau) * source * (step - dark.z);
            }
        }
        out.transmittance *= exp(-tau);
        t0 = t1;
    }
    return out;
}
