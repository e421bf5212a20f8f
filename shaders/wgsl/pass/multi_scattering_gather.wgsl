//#include gather
//#include open_sun
//#include phase
//#include directions
// Gathers the radiance of all orders in a set of directions at each node of the multi-scattering LUT: the
// light that the last round's LUT and the sun send into them. Column: sun angle, azimuth within it. Row:
// altitude, zenith angle within it.

struct Uniforms {
    medium: Medium,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

// Radiance (1/sr) of the ground that a ray meets: Lambert's, of light from the sky and from the sun.
fn ground_radiance(m: Medium, luts: Luts, sun_r_mu: f32) -> vec3f {
    let mu_sun = clamp(sun_r_mu / m.radius, -1.0, 1.0);
    var light = ground_irradiance(multi_scattering_lut, luts, mu_sun);
    if mu_sun > 0.0 {
        let coefficients = mat3x3f(m.rayleigh, luts.mie_extinction, m.ozone);
        let path = optical_path_to_top(transmittance_lut, m.radius, m.thickness, 0.0, 0.0, sun_r_mu);
        light += mu_sun * exp(-extinction(coefficients, path));
    }
    return light * luts.albedo * (1.0 / PI);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = uniforms.medium;
    let luts = uniforms.luts;
    let texel = vec2i(position.xy);
    let node = vec2i(texel.x / AZIMUTHS, texel.y / ZENITHS);
    let uv = vec2f(node) / multi_scattering_span(multi_scattering_lut);
    let mu_sun = u_to_mu_sun(luts, uv.x);
    let h = v_to_altitude(luts, uv.y, m.thickness);
    let sun = vec3f(sqrt(max((1.0 - mu_sun) * (1.0 + mu_sun), 0.0)), 0.0, mu_sun);
    let view = node_direction(texel.y % ZENITHS, texel.x % AZIMUTHS, h, m.radius);
    let sine = sqrt(max((1.0 - view.mu) * (1.0 + view.mu), 0.0));
    let dir = vec3f(sine * cos(view.azimuth), sine * sin(view.azimuth), view.mu);
    let ray = inner_ray(dir, h, m.radius, m.thickness, sun, !view.above);
    let nu = ray.nu;
    // Direct light: of the aerosol's phase function the part that is not counted as passing straight on.
    let gas = m.rayleigh * rayleigh_phase(nu);
    let aerosol = m.mie_scattering * luts.mie_moment0
        * henyey_greenstein_phase(1.0 - nu, 1.0 + nu, luts.mie_asymmetry);
    let perigee = perigee_of(ray, ray.length, m.radius);
    let u_from = distance_to_u(perigee.distance, 0.0);
    let u_to = distance_to_u(perigee.distance, ray.length);
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, luts, ray, dir,
        perigee, u_from, u_to, luts.steps, gas, aerosol, 1.0);
    var radiance = g.radiance;
    if ray.ground {
        radiance += g.transmittance * ground_radiance(m, luts, ray.sun_r_mu + ray.nu * ray.length);
    }
    return vec4f(radiance, 0.0);
}
