//#include frame
// What the air holds at an altitude. A constituent that is off is not compiled. Loops call these functions:
// they take a few numbers and not the block, which some software renderers copy at every call.

const RAYLEIGH: bool = true; // The air holds gas that scatters light like Rayleigh's molecules.
const MIE: bool = true;      // The air holds an aerosol.
const OZONE: bool = true;    // The air holds an absorber.

// Where the constituents are: 1 / scale height of gas and of aerosol (1/km), the absorber's altitude (km) and
// 1 / half width (1/km).
fn layers_of(m: Medium) -> vec4f {
    return vec4f(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

// Extinction coefficients (1/km) of gas, aerosol and absorber, a column each.
fn coefficients_of(m: Medium) -> mat3x3f {
    return mat3x3f(m.rayleigh, m.mie_extinction, m.ozone);
}

// Densities of gas, aerosol and absorber at altitude h (km), relative to those that their coefficients are
// for: exp(-h / H) for gas and aerosol, for ozone a tent that is 1 at its centre and 0 at half_width from
// it (Bruneton 2017, section 2.4 of "A Qualitative and Quantitative Evaluation of 8 Clear Sky Models").
fn densities(layers: vec4f, h: f32) -> vec3f {
    var d = vec3f(0.0);
    if RAYLEIGH {
        d.x = exp(-h * layers.x);
    }
    if MIE {
        d.y = exp(-h * layers.y);
    }
    if OZONE {
        d.z = max(0.0, 1.0 - abs(h - layers.z) * layers.w);
    }
    return d;
}

// Extinction (1/km) of densities, sum of coefficient times density; or the optical depth of densities that
// were integrated along a path (km).
fn extinction(coefficients: mat3x3f, d: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    if RAYLEIGH {
        sum += coefficients[0] * d.x;
    }
    if MIE {
        sum += coefficients[1] * d.y;
    }
    if OZONE {
        sum += coefficients[2] * d.z;
    }
    return sum;
}
