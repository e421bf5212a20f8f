//#include geometry
//#include medium
// Sums along a path through the air.

// Distance (km) of a step's end: perigee + u |u|. Steps even in u crowd quadratically at the perigee of the
// path, where the air is densest, wherever that is, and they move continuously with the ray. perigee: its
// distance.
fn u_to_distance(perigee: f32, u: f32) -> f32 {
    return perigee + u * abs(u);
}

// The inverse: u = sign(t - perigee) sqrt(|t - perigee|), sqrt(km).
fn distance_to_u(perigee: f32, t: f32) -> f32 {
    return sign(t - perigee) * sqrt(abs(t - perigee));
}

// Densities integrated over a distance (km, relative densities times km) from a point: the optical path of
// each constituent, Bruneton & Neyret 2008, equation 3, by the midpoint rule in u.
fn path_densities(
    layers: mat2x3f, radius: f32, excess: f32, r_mu: f32, distance: f32, samples: u32,
) -> vec3f {
    let perigee = clamp(-r_mu, 0.0, distance);
    let u0 = -sqrt(perigee);
    let du = (sqrt(distance - perigee) - u0) / f32(samples);
    var sum = vec3f(0.0);
    var t0 = 0.0;
    for (var i = 0u; i < samples; i++) {
        let u = u0 + du * f32(i);
        let t = u_to_distance(perigee, u + 0.5 * du);
        let t1 = u_to_distance(perigee, u + du);
        let h = altitude_after(excess, r_mu, t, radius);
        sum += densities(layers, h) * (t1 - t0);
        t0 = t1;
    }
    return sum;
}

// The mean of exp(-s) over s from 0 to tau: (1 - exp(-tau)) / tau, which is 1 at 0. A step of a ray that
// scatters evenly sends this part of its light out of its own extinction (Hillaire 2015, "Physically Based
// and Unified Volumetric Rendering in Frostbite", slide 28). As a series where the difference loses its
// digits.
fn mean_transmittance(tau: vec3f) -> vec3f {
    let series = 1.0 - tau * (0.5 - tau * (1.0 / 6.0));
    return select((1.0 - exp(-tau)) / tau, series, tau < vec3f(1e-2));
}

// What an optical depth takes away: 1 - exp(-tau), which keeps its digits in thin air.
fn opacity(tau: vec3f) -> vec3f {
    return tau * mean_transmittance(tau);
}

// The part of a step from t0 to t1 (km) that lies in the planet's shadow: where it begins and ends, and its
// length, km. shadow: see `shadow_stretch`.
fn dark_part(shadow: vec2f, t0: f32, t1: f32) -> vec3f {
    let begin = clamp(shadow.x, t0, t1);
    let end = clamp(shadow.y, t0, t1);
    return vec3f(begin, end, select(0.0, max(end - begin, 0.0), shadow.y > shadow.x));
}

// Distance (km) of the middle, in u, of what the sun reaches of a step from t0 to t1. Where the shadow lies
// within the step the longer of both ends stands for both. Two square roots: a step without shadow needs
// none, and a driver that runs both sides of a branch pays for them in every step (7 % of a march on an
// H200, `cargo lab compare --samples 32`), so that callers ask first.
fn lit_middle(dark: vec3f, perigee: f32, t0: f32, t1: f32) -> f32 {
    let first = dark.x - t0 > t1 - dark.y;
    let lit0 = select(dark.y, t0, first);
    let lit1 = select(t1, dark.x, first);
    return u_to_distance(perigee, 0.5 * (distance_to_u(perigee, lit0) + distance_to_u(perigee, lit1)));
}
