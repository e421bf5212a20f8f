//#include gather
//#include open_sun
//#include phase
//#include directions
// Radiance of all orders in a set of directions at each node of `moments`: the light that the last round's moments
// and the sun send into them. Column: sun angle, azimuth within it. Row: altitude, zenith angle within it.

struct Uniforms {
    medium: Medium,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

const PI: f32 = 3.141592653589793;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = uniforms.medium;
    let t = uniforms.tables;
    let at = vec2i(position.xy);
    let dims = vec2i(textureDimensions(multi_scattering_lut));
    let size = vec2i(dims.x, (dims.y - 1) / MOMENTS);
    let node = vec2i(at.x / AZIMUTHS, at.y / ZENITHS);
    let mu_sun = share_sun(t, f32(node.x) / f32(size.x - 1));
    let h = share_altitude(t, f32(node.y) / f32(size.y - 1), m.thickness);
    let sun = vec3f(sqrt(max((1.0 - mu_sun) * (1.0 + mu_sun), 0.0)), 0.0, mu_sun);
    let view = node_direction(at.y % ZENITHS, at.x % AZIMUTHS, h, m.radius);
    let sine = sqrt(max((1.0 - view.mu) * (1.0 + view.mu), 0.0));
    let dir = vec3f(sine * cos(view.azimuth), sine * sin(view.azimuth), view.mu);
    let ray = inner_ray(dir, h, m.radius, m.thickness, sun, !view.above);
    let nu = ray.nu;
    // Direct light: of the aerosol's phase function the part that is not counted as passing straight on.
    let gas = m.rayleigh * rayleigh_phase(nu);
    let aerosol = m.mie_scattering * t.mie_moment0 * henyey_greenstein_phase(1.0 - nu, 1.0 + nu, t.mie_asymmetry);
    let low = lowest(ray, ray.length, m.radius);
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, t, ray, dir, low, unwarp(low.t, 0.0), unwarp(low.t, ray.length), gas, aerosol, 1.0);
    var radiance = g.radiance;
    if ray.ground {
        let sun_b = ray.sun_b + ray.nu * ray.length;
        let mu_ground = clamp(sun_b / m.radius, -1.0, 1.0);
        var light = ground_irradiance(multi_scattering_lut, t, mu_ground);
        if mu_ground > 0.0 {
            let coefficients = mat3x3f(m.rayleigh, t.mie_extinction, m.ozone);
            light += mu_ground * exp(-extinction(coefficients, columns_to_top(transmittance_lut, m.radius, m.thickness, 0.0, 0.0, sun_b)));
        }
        radiance += g.transmittance * light * t.albedo * (1.0 / PI);
    }
    return vec4f(radiance, 0.0);
}
