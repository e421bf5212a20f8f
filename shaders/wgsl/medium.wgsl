//#include frame
// What the air holds at an altitude. Constituents that are off are not compiled.

// Densities of gas, aerosol and absorber at altitude h (km), relative to their coefficients.
fn densities(m: Medium, h: f32) -> vec3f {
    var d = vec3f(0.0);
    //#if RAYLEIGH
    d.x = exp(-h * m.rayleigh_inv_height);
    //#endif
    //#if MIE
    d.y = exp(-h * m.mie_inv_height);
    //#endif
    //#if OZONE
    // Tent: 1 at the centre, 0 at half_width from it (Bruneton 2017, section 2.4).
    d.z = max(0.0, 1.0 - abs(h - m.ozone_center) * m.ozone_inv_half_width);
    //#endif
    return d;
}

// Extinction (1/km) for densities, or optical depth for densities integrated over a path (km).
fn extinction(m: Medium, d: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    //#if RAYLEIGH
    sum += m.rayleigh * d.x;
    //#endif
    //#if MIE
    sum += m.mie_extinction * d.y;
    //#endif
    //#if OZONE
    sum += m.ozone * d.z;
    //#endif
    return sum;
}
