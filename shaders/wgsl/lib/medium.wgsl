//#include frame
// What the air holds at a height above the lowest ground; below altitude 0 it is even. A constituent that is
// off is not compiled. Loops call these functions: they take a few numbers and not the block, which some
// software renderers copy at every call.

const RAYLEIGH: bool = true; // The air holds gas that scatters light like Rayleigh's molecules.
const MIE: bool = true;      // The air holds an aerosol.
const OZONE: bool = true;    // The air holds an absorber.

// Where gas, aerosol and absorber are: 1 / scale height of the first two and 1 / half width of the third
// (1/km); then the height of altitude 0 above the lowest ground and the altitude of the third's centre (km).
// These are not added: a thin layer would be lost in the sum.
fn layers_of(m: Medium) -> mat2x3f {
    let fall = vec3f(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_inv_half_width);
    return mat2x3f(fall, vec3f(m.datum, m.ozone_center, 0.0));
}

// Extinction coefficients (1/km) of gas, aerosol and absorber, a column each.
fn coefficients_of(m: Medium) -> mat3x3f {
    return mat3x3f(m.rayleigh, m.mie_extinction, m.ozone);
}

// Densities of gas, aerosol and absorber at a height above the lowest ground (km), relative to those that
// their coefficients are for: at altitude z, at least 0, exp(-z / H) for gas and aerosol, for ozone a tent
// that is 1 at its centre and 0 at half_width from it (Bruneton 2017, section 2.4 of "A Qualitative and
// Quantitative Evaluation of 8 Clear Sky Models").
fn densities(layers: mat2x3f, h: f32) -> vec3f {
    let fall = layers[0];
    let z = max(h - layers[1].x, 0.0);
    var d = vec3f(0.0);
    if RAYLEIGH {
        d.x = exp(-z * fall.x);
    }
    if MIE {
        d.y = exp(-z * fall.y);
    }
    if OZONE {
        d.z = max(0.0, 1.0 - abs(z - layers[1].y) * fall.z);
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
