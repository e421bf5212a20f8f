// Phase functions, 1/sr, each integrates to 1 over the sphere.

const INV_4PI: f32 = 0.07957747154594767; // 1 / (4 pi)

// Rayleigh: 3 / (16 pi) (1 + mu^2).
fn rayleigh_phase(mu: f32) -> f32 {
    return 0.75 * INV_4PI * (1.0 + mu * mu);
}

// Henyey & Greenstein 1941, eq. 2, per channel. away = 1 - mu, given on its own because it is what
// decides near the sun: 1 + g^2 - 2 g mu = (1 - g)^2 + 2 g away.
fn henyey_greenstein_phase(away: f32, g: vec3f) -> vec3f {
    let base = (1.0 - g) * (1.0 - g) + 2.0 * g * away;
    return INV_4PI * (1.0 - g * g) / (base * sqrt(base));
}

// Cornette & Shanks 1992, eq. 8.
fn cornette_shanks_phase(mu: f32, away: f32, g: vec3f) -> vec3f {
    return 1.5 * (1.0 + mu * mu) / (2.0 + g * g) * henyey_greenstein_phase(away, g);
}
