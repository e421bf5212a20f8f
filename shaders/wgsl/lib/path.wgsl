//#include geometry
//#include medium
// Sums along a path through the air.

// Steps are even in u, with distance = low + u |u| from the lowest point of the path: they crowd
// quadratically where the air is densest, wherever that is, and move continuously with the ray.
fn warp(low: f32, u: f32) -> f32 {
    return low + u * abs(u);
}

fn unwarp(low: f32, t: f32) -> f32 {
    return sign(t - low) * sqrt(abs(t - low));
}

// Densities integrated (km) from a point (x = r^2 - R^2, b = r cos of the direction's zenith angle)
// over a distance (km), by the midpoint rule in u.
fn path_densities(layers: vec4f, radius: f32, x: f32, b: f32, distance: f32, samples: u32) -> vec3f {
    let low = clamp(-b, 0.0, distance);
    let u0 = -sqrt(low);
    let du = (sqrt(distance - low) - u0) / f32(samples);
    var sum = vec3f(0.0);
    var t0 = 0.0;
    for (var i = 0u; i < samples; i++) {
        let u = u0 + du * f32(i);
        let t = warp(low, u + 0.5 * du);
        let t1 = warp(low, u + du);
        let h = altitude_after(x, b, t, radius);
        sum += densities(layers, h) * (t1 - t0);
        t0 = t1;
    }
    return sum;
}

// (1 - exp(-tau)) / tau, which is 1 at 0: the mean of exp(-s) over 0..tau.
fn mean_transmittance(tau: vec3f) -> vec3f {
    let series = 1.0 - tau * (0.5 - tau * (1.0 / 6.0));
    return select((1.0 - exp(-tau)) / tau, series, tau < vec3f(1e-2));
}
