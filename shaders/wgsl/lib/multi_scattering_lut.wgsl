//#include medium
//#include luts
// The multi-scattering LUT. In a spherical atmosphere under a parallel sun the light at a point depends on
// its altitude and on the sun's zenith angle alone; of its directions six harmonics are kept, those even in
// azimuth up to degree 2 about the zenith, with the sun at azimuth 0. Scattering after Rayleigh needs
// degrees 0 and 2 only, so that for gas this is exact. Columns: sun angle. Rows: six for each altitude; the
// first holds log2 of the moment of degree 0, the others their ratio to it. The last row of all is log2 of
// the ground's irradiance from the sky.

const MOMENTS: i32 = 6; // harmonics of a node

// v of an altitude: h grows like expm1(steepness v^2), so that rows crowd near the ground; v =
// sqrt(log1p(..) / s). log1p in the form that keeps its digits.
fn altitude_to_v(steepness: f32, growth: f32, h: f32, thickness: f32) -> f32 {
    let grown = max(h, 0.0) / thickness * growth;
    let series = grown * (1.0 - grown * (0.5 - grown * (1.0 / 3.0 - grown * 0.25)));
    return sqrt(select(log(1.0 + grown), series, grown < 0.05) / steepness);
}

// The inverse: altitude in km. expm1 in the form that keeps its digits.
fn v_to_altitude(luts: Luts, v: f32, thickness: f32) -> f32 {
    let s = luts.altitude_steepness * v * v;
    let grown = select(exp(s) - 1.0, s * (1.0 + s * (0.5 + s * (1.0 / 6.0 + s * (1.0 / 24.0)))), s < 0.05);
    return thickness * min(grown / luts.altitude_growth, 1.0);
}

// Numbers of the sun's axis: middle, width, first and span, see `Luts`.
fn sun_axis(luts: Luts) -> vec4f {
    return vec4f(luts.sun_middle, luts.sun_width, luts.sun_first, luts.sun_span);
}

// u of the cosine of the sun's zenith angle: asinh((mu - middle) / width), so that columns crowd where the
// sun sets.
fn mu_sun_to_u(axis: vec4f, mu_sun: f32) -> f32 {
    let y = (mu_sun - axis.x) / axis.y;
    return (sign(y) * log(abs(y) + sqrt(y * y + 1.0)) - axis.z) / axis.w;
}

// The inverse.
fn u_to_mu_sun(luts: Luts, u: f32) -> f32 {
    return clamp(luts.sun_middle + luts.sun_width * sinh(luts.sun_first + u * luts.sun_span), -1.0, 1.0);
}

// Nodes along both axes less 1, for the LUT's size in texels: what u and v are multiplied by.
fn multi_scattering_span(lut: texture_2d<f32>) -> vec2f {
    let dims = vec2i(textureDimensions(lut));
    return vec2f(f32(dims.x), f32((dims.y - 1) / MOMENTS)) - 1.0;
}

const SH0: f32 = 0.28209479177387814;  // sqrt(1 / (4 pi))
const SH1: f32 = 0.4886025119029199;   // sqrt(3 / (4 pi))
const SH20: f32 = 0.31539156525252005; // sqrt(5 / (16 pi))
const SH21: f32 = 1.0925484305920792;  // sqrt(15 / (4 pi))
const SH22: f32 = 0.5462742152960396;  // sqrt(15 / (16 pi))

// Normalised real spherical harmonics Y_00, Y_10, Y_11, Y_20, Y_21, Y_22. mu: the direction's part along
// the zenith; along: its part along the sun's horizontal direction.
fn harmonic(index: i32, mu: f32, along: f32) -> f32 {
    switch index {
        case 0: { return SH0; }
        case 1: { return SH1 * mu; }
        case 2: { return SH1 * along; }
        case 3: { return SH20 * (3.0 * mu * mu - 1.0); }
        case 4: { return SH21 * mu * along; }
        default: { return SH22 * (2.0 * along * along + mu * mu - 1.0); }
    }
}

// What gas and aerosol scatter into a direction of light that was scattered before, for densities of 1.
struct Source {
    gas: vec3f,      // 1/km
    aerosol: vec3f,  // 1/km
}

// The moments at a node (counted in texels) times those of the phase functions: the addition theorem,
// Chandrasekhar 1960, "Radiative Transfer", section 48. Rayleigh's phase function has the moments 1, 0 and
// 1/10. gas: scattering, 1/km; aerosol: the same times its phase moments 0, 1 and 2; mu, mu_sun: cosines of
// the zenith angles of direction and sun; nu: of the angle between them.
fn multi_scattering_source(
    lut: texture_2d<f32>, node: vec2f, gas: vec3f, aerosol: mat3x3f, mu: f32, mu_sun: f32, nu: f32,
) -> Source {
    let dims = vec2i(textureDimensions(lut));
    var c = corner(node, vec2i(dims.x, (dims.y - 1) / MOMENTS));
    c.first.y *= MOMENTS;
    c.last.y *= MOMENTS;
    let mean = exp2(bilinear(lut, c, vec2i(0)).xyz);
    let sin_sun = sqrt(max((1.0 - mu_sun) * (1.0 + mu_sun), 1e-12));
    let sin_view = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
    let along = clamp((nu - mu * mu_sun) / sin_sun, -sin_view, sin_view);
    let l2 = bilinear(lut, c, vec2i(0, 3)).xyz * harmonic(3, mu, along)
        + bilinear(lut, c, vec2i(0, 4)).xyz * harmonic(4, mu, along)
        + bilinear(lut, c, vec2i(0, 5)).xyz * harmonic(5, mu, along);
    var source = Source(vec3f(0.0), vec3f(0.0));
    if RAYLEIGH {
        source.gas = gas * (SH0 + 0.1 * l2) * mean;
    }
    if MIE {
        let l1 = bilinear(lut, c, vec2i(0, 1)).xyz * harmonic(1, mu, along)
            + bilinear(lut, c, vec2i(0, 2)).xyz * harmonic(2, mu, along);
        source.aerosol = (SH0 * aerosol[0] + l1 * aerosol[1] + l2 * aerosol[2]) * mean;
    }
    return source;
}

// Irradiance of level ground from the sky, per unit of the sun's: the LUT's last row.
fn ground_irradiance(lut: texture_2d<f32>, luts: Luts, mu_sun: f32) -> vec3f {
    let dims = vec2i(textureDimensions(lut));
    let position = vec2f(mu_sun_to_u(sun_axis(luts), mu_sun) * f32(dims.x - 1), 0.0);
    return exp2(bilinear(lut, corner(position, vec2i(dims.x, 1)), vec2i(0, dims.y - 1)).xyz);
}
