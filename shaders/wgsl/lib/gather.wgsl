//#include tables
//#include path
// All orders of scattering along a ray, with the tables. Per unit of the sun's irradiance: 1/sr.

const MULTI_SCATTERING: bool = true; // with light that was scattered before

struct Gathered {
    radiance: vec3f,       // 1/sr
    transmittance: vec3f,  // with the aerosol's forward light counted as not scattered
    columns: vec3f,        // densities integrated, km
}

// The part of a step that the sun reaches: its length (km), and the distance of a point in its middle.
fn lit_part(shadow: vec2f, low: f32, t0: f32, t1: f32, mid: f32) -> vec2f {
    let dark0 = clamp(shadow.x, t0, t1);
    let dark1 = clamp(shadow.y, t0, t1);
    let dark = select(0.0, max(dark1 - dark0, 0.0), shadow.y > shadow.x);
    if dark <= 0.0 {
        return vec2f(t1 - t0, mid);
    }
    let first = dark0 - t0 > t1 - dark1;
    let lit0 = select(dark1, t0, first);
    let lit1 = select(t1, dark0, first);
    return vec2f(t1 - t0 - dark, warp(low, 0.5 * (unwarp(low, lit0) + unwarp(low, lit1))));
}

// From u_from to u_to in even steps of u. gas, aerosol: scattering coefficient at altitude 0 times phase function for
// direct sunlight, 1/(km sr).
// The sun's light and, with MULTI_SCATTERING, times `diffuse`, what was scattered before. dir: the ray's, unit.
fn gather(
    transmittance_lut: texture_2d<f32>, multi_scattering_lut: texture_2d<f32>,
    medium: Medium, t: Tables, ray: AirRay, dir: vec3f,
    lowest: Low, u_from: f32, u_to: f32, gas: vec3f, aerosol: vec3f, diffuse: f32,
) -> Gathered {
    let radius = medium.radius;
    let thickness = medium.thickness;
    let layers = layers_of(medium);
    let coefficients = mat3x3f(medium.rayleigh, t.mie_extinction, medium.ozone);
    var out = Gathered(vec3f(0.0), vec3f(1.0), vec3f(0.0));
    let shadow = shadow_stretch(ray);
    let axis = sun_axis(t);
    let dims = vec2i(textureDimensions(multi_scattering_lut));
    let nodes = vec2f(f32(dims.x), f32((dims.y - 1) / MOMENTS)) - 1.0;
    let scattered = mat3x3f(
        medium.mie_scattering * t.mie_moment0,
        medium.mie_scattering * t.mie_moment1,
        medium.mie_scattering * t.mie_moment2,
    );
    let low = lowest.t;
    let du = (u_to - u_from) / f32(t.steps);
    var t0 = warp(low, u_from);
    for (var i = 0u; i < t.steps; i++) {
        let u = u_from + du * f32(i);
        let t1 = warp(low, u + du);
        let step = t1 - t0;
        let mid = warp(low, u + 0.5 * du);
        let h = altitude_after(lowest.x, lowest.b, mid - low, radius);
        let d = densities(layers, h);
        let tau = extinction(coefficients, d) * step;
        let share = out.transmittance * mean_transmittance(tau);
        let lit = lit_part(shadow, low, t0, t1, mid);
        if lit.x > 0.0 {
            let past = lit.y - low;
            let lit_x = max(lowest.x + past * (2.0 * lowest.b + past), 0.0);
            let lit_h = altitude_of(lit_x, radius);
            let lit_d = densities(layers, lit_h);
            let path = columns_to_top(transmittance_lut, radius, thickness, lit_x, lit_h, ray.sun_b + ray.nu * lit.y);
            var source = (gas * lit_d.x + aerosol * lit_d.y) * exp(-extinction(coefficients, path));
            source *= sun_visibility(dir, ray.start + lit.y);
            out.radiance += share * source * lit.x;
        }
        if MULTI_SCATTERING {
            let r = radius + h;
            let mu = clamp((lowest.b + mid - low) / r, -1.0, 1.0);
            let mu_sun = clamp((ray.sun_b + ray.nu * mid) / r, -1.0, 1.0);
            let row = altitude_share(t.altitude_steepness, t.altitude_growth, h, thickness);
            let before = diffuse_source(
                multi_scattering_lut, vec2f(sun_share(axis, mu_sun), row) * nodes, medium.rayleigh, scattered, mu, mu_sun, ray.nu);
            let around = sun_visibility_around(dir, ray.start + mid);
            out.radiance += share * (step * diffuse) * (before.gas * around * d.x + before.aerosol * around * d.y);
        }
        out.transmittance *= exp(-tau);
        out.columns += d * step;
        t0 = t1;
    }
    return out;
}
