//#include frame
//#include geometry
//#include luts
// The transmittance LUT's mapping, Bruneton 2017's (GetTransmittanceTextureUvFromRMu), in excess form. v:
// the distance to the horizon rho = sqrt(r^2 - R^2) over its largest value. u: the distance to the top,
// between the shortest there is (straight up) and the longest (along the horizon). It holds log2 of the
// optical path and not the transmittance: one LUT serves all channels and extinction coefficients, and the
// logarithm is nearly linear between texels.

// The ray of a texel: excess (km^2), r mu (km) and distance to the top (km).
fn transmittance_texel_ray(position: vec2f, size: vec2f, m: Medium) -> vec3f {
    let uv = position / (size - 1.0);
    let rho_top = sqrt(excess_of(m.thickness, m.radius));
    let rho = uv.y * rho_top;
    let h = min(altitude_of(rho * rho, m.radius), m.thickness);
    let shortest = m.thickness - h;
    let d = shortest + uv.x * (rho + rho_top - shortest);
    // From r_top^2 = r^2 + 2 d r mu + d^2.
    let r_mu = select(m.radius + h, ((rho_top - rho) * (rho_top + rho) / d - d) * 0.5, d > 0.0);
    return vec3f(rho * rho, max(r_mu, -rho), d);
}

// The inverse: u and v of a ray from altitude h.
fn transmittance_uv(excess: f32, h: f32, r_mu: f32, radius: f32, thickness: f32) -> vec2f {
    let top_excess = excess_of(thickness, radius);
    let rho = sqrt(max(excess, 0.0));
    let rho_top = sqrt(top_excess);
    let d = distance_to_top(excess, r_mu, top_excess);
    let shortest = max(thickness - h, 0.0);
    return vec2f((d - shortest) / max(rho + rho_top - shortest, 1e-20), rho / rho_top);
}

// Optical path (km, per constituent) from a point at altitude h to the top, from the LUT.
fn optical_path_to_top(
    lut: texture_2d<f32>, radius: f32, thickness: f32, excess: f32, h: f32, r_mu: f32,
) -> vec3f {
    let size = vec2i(textureDimensions(lut));
    let position = transmittance_uv(excess, h, r_mu, radius, thickness) * vec2f(size - 1);
    return exp2(bilinear(lut, corner(position, size), vec2i(0)).xyz);
}
