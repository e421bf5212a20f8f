// Phase functions, 1/sr; each integrates to 1 over the sphere. mu: cosine of the angle by which light is
// turned. away = 1 - mu and toward = 1 + mu are given on their own because they decide at a sharp peak.

const INV_4PI: f32 = 0.07957747154594767; // 1 / (4 pi)

const CORNETTE_SHANKS: bool = true; // The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.

// Rayleigh 1871: 3 / (16 pi) (1 + mu^2).
fn rayleigh_phase(mu: f32) -> f32 {
    return 0.75 * INV_4PI * (1.0 + mu * mu);
}

// Henyey & Greenstein 1941, equation 2, per channel: (1 - g^2) / (4 pi (1 + g^2 - 2 g mu)^(3/2)). The base
// is (1 - g)^2 + 2 g away = (1 + g)^2 - 2 g toward, of which the first has no difference for g > 0 and the
// second none for g < 0.
fn henyey_greenstein_phase(away: f32, toward: f32, g: vec3f) -> vec3f {
    let rest = 1.0 - abs(g);
    let base = rest * rest + 2.0 * abs(g) * select(vec3f(toward), vec3f(away), g >= vec3f(0.0));
    return INV_4PI * (1.0 - g * g) / (base * sqrt(base));
}

// Cornette & Shanks 1992, equation 8: 3 (1 + mu^2) / (2 (2 + g^2)) times the former.
fn cornette_shanks_phase(away: f32, toward: f32, g: vec3f) -> vec3f {
    let mu = 1.0 - away;
    return 1.5 * (1.0 + mu * mu) / (2.0 + g * g) * henyey_greenstein_phase(away, toward, g);
}

// The aerosol's phase function.
fn mie_phase(away: f32, toward: f32, asymmetry: vec3f) -> vec3f {
    if CORNETTE_SHANKS {
        return cornette_shanks_phase(away, toward, asymmetry);
    } else {
        return henyey_greenstein_phase(away, toward, asymmetry);
    }
}

// The aerosol's phase function between two unit directions: 1 - cos and 1 + cos of their angle are half the
// squared length of their difference and of their sum, without cancellation.
fn mie_phase_between(dir: vec3f, sun: vec3f, asymmetry: vec3f) -> vec3f {
    let apart = dir - sun;
    let together = dir + sun;
    return mie_phase(0.5 * dot(apart, apart), 0.5 * dot(together, together), asymmetry);
}
