//#include frame
//#include path
//#include phase
// Single scattering along a ray through a spherical atmosphere (Nishita et al. 1993, eq. 3 to 9), with the
// planet's own shadow. Per unit of the sun's irradiance: radiance in 1/sr.

// Transmittance from a point to the sun, whose disk's centre is above the point's horizon.
fn sun_transmittance(
    coefficients: mat3x3f, layers: vec4f, radius: f32, thickness: f32, x: f32, sun_b: f32, samples: u32,
) -> vec3f {
    let distance = distance_to_top(x, sun_b, excess_of(thickness, radius));
    return exp(-extinction(coefficients, path_densities(layers, radius, x, sun_b, distance, samples)));
}

const SUNLIGHT: bool = true; // off: no sunlight reaches the air, which dims what lies behind and sends no light

struct Scattered {
    radiance: vec3f,       // 1/sr
    transmittance: vec3f,  // 0 to 1
}

// Light scattered into a ray over its first `length` km, and what the ray lets through.
// dir: unit; away: 1 - cos of the angle between ray and sun.
fn single_scattering(
    m: Medium, ray: AirRay, dir: vec3f, length: f32, away: f32, view_samples: u32, light_samples: u32,
) -> Scattered {
    var out: Scattered;
    out.radiance = vec3f(0.0);
    out.transmittance = vec3f(1.0);
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
            let toward = select(2.0 - away, ray.cross2 / max(away, 1.0), away > 1.0);
            mie = m.mie_scattering * mie_phase(away, toward, m.mie_asymmetry);
        }
    }
    let layers = layers_of(m);
    let coefficients = coefficients_of(m);
    let lowest = lowest(ray, length, m.radius);
    let low = lowest.t;
    let u0 = -sqrt(low);
    let du = (sqrt(length - low) - u0) / f32(view_samples);
    var t0 = 0.0;
    for (var i = 0u; i < view_samples; i++) {
        let u = u0 + du * f32(i);
        let t1 = warp(low, u + du);
        let step = t1 - t0;
        let t = warp(low, u + 0.5 * du);
        let h = altitude_after(lowest.x, lowest.b, t - low, m.radius);
        let tau = extinction(coefficients, densities(layers, h)) * step;
        if SUNLIGHT {
            // The part of the step that the sun reaches, and a point in its middle.
            let dark0 = clamp(shadow.x, t0, t1);
            let dark1 = clamp(shadow.y, t0, t1);
            let dark = select(0.0, max(dark1 - dark0, 0.0), shadow.y > shadow.x);
            if dark < step {
                var lit_t = t;
                if dark > 0.0 {
                    let first = dark0 - t0 > t1 - dark1;
                    let lit0 = select(dark1, t0, first);
                    let lit1 = select(t1, dark0, first);
                    lit_t = warp(low, 0.5 * (unwarp(low, lit0) + unwarp(low, lit1)));
                }
                let x = lowest.x + (lit_t - low) * (2.0 * lowest.b + (lit_t - low));
                let d = densities(layers, max(altitude_of(x, m.radius), 0.0));
                var source = vec3f(0.0);
                if RAYLEIGH {
                    source += rayleigh * d.x;
                }
                if MIE {
                    source += mie * d.y;
                }
                source *= sun_transmittance(
                    coefficients, layers, m.radius, m.thickness, x, ray.sun_b + ray.nu * lit_t, light_samples);
                source *= sun_visibility(dir, ray.start + lit_t);
                out.radiance += out.transmittance * mean_transmittance(tau) * source * (step - dark);
            }
        }
        out.transmittance *= exp(-tau);
        t0 = t1;
    }
    return out;
}
