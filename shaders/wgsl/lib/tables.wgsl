//#include frame
//#include geometry
//#include medium
// Precomputed tables: what is in them, where, and how they are read. Texels sit on both ends of each axis. What fills
// other tables is interpolated here, in 32-bit floats: the same on every driver. What pixels read the sampler does.
//
// columns: log2 of the densities' integral (km) from an altitude towards the top, gas, aerosol, absorber.
// moments: all light that was scattered at least once, as angular moments per altitude and sun angle.

struct Tables {
    mie_extinction: vec3f,      // aerosol, less the light that it turns by small angles only, 1/km
    altitude_steepness: f32,    // altitude grows like expm1(steepness x^2) over the rows of `moments`
    mie_moment0: vec3f,         // the rest's phase moments l = 0, 1, 2 times its share (delta-M)
    altitude_growth: f32,       // expm1(altitude_steepness)
    mie_moment1: vec3f,
    sun_middle: f32,            // cosine of the sun's zenith angle where the columns crowd
    mie_moment2: vec3f,
    sun_width: f32,             // of the crowd, in the cosine
    mie_asymmetry: vec3f,       // of the rest
    pad: f32,
    albedo: vec3f,              // of the ground, Lambert
    sun_first: f32,             // asinh((cosine - middle) / width) of the first column of `moments`
    sun_span: f32,              // ... of the last, less the first
    ground_rows: f32,           // rows of the sky table (or of the air table, where that is filled) for rays to the ground
    size: vec2u,                // of the table that is filled, texels
    steps: u32,                 // along a ray, or along a slice's part of it
    shift: u32,                 // of the scan, slices
    slices: u32,                // of the air table
    air_ground_rows: f32,       // rows of the air table for rays that end on the ground
}

const LOG_FLOOR: f32 = -100.0; // log2 of next to nothing

// Four texels and their weights around a position counted in texels.
struct Corner {
    low: vec2i,
    high: vec2i,
    part: vec2f,
}

fn corner(at: vec2f, size: vec2i) -> Corner {
    let inside = clamp(at, vec2f(0.0), vec2f(size - 1));
    let low = min(vec2i(inside), size - 1);
    return Corner(low, min(low + 1, size - 1), inside - vec2f(low));
}

fn bilinear(table: texture_2d<f32>, c: Corner, origin: vec2i) -> vec4f {
    let low = c.low + origin;
    let high = c.high + origin;
    let bottom = mix(textureLoad(table, low, 0), textureLoad(table, vec2i(high.x, low.y), 0), c.part.x);
    let top = mix(textureLoad(table, vec2i(low.x, high.y), 0), textureLoad(table, high, 0), c.part.x);
    return mix(bottom, top, c.part.y);
}

// Where the sampler finds a position counted in texels.
fn table_uv(x_share: f32, row: f32, size: vec2f) -> vec2f {
    return (vec2f(x_share * (size.x - 1.0), row) + 0.5) / size;
}

// --- columns: Bruneton 2017's coordinates, in excess form. Row: sqrt(r^2 - R^2) over its largest value. Column:
// distance to the top, between the shortest there is (straight up) and the longest (along the horizon).

fn columns_ray(at: vec2f, size: vec2f, m: Medium) -> vec3f {
    let share = at / (size - 1.0);
    let rho_top = sqrt(excess_of(m.thickness, m.radius));
    let rho = share.y * rho_top;
    let h = min(altitude_of(rho * rho, m.radius), m.thickness);
    let shortest = m.thickness - h;
    let d = shortest + share.x * (rho + rho_top - shortest);
    let b = select(m.radius + h, ((rho_top - rho) * (rho_top + rho) / d - d) * 0.5, d > 0.0);
    return vec3f(rho * rho, max(b, -rho), d);
}

// The inverse: shares along the columns and the rows.
fn columns_share(x: f32, h: f32, b: f32, radius: f32, thickness: f32) -> vec2f {
    let x_top = excess_of(thickness, radius);
    let rho = sqrt(max(x, 0.0));
    let rho_top = sqrt(x_top);
    let d = distance_to_top(x, b, x_top);
    let shortest = max(thickness - h, 0.0);
    return vec2f((d - shortest) / max(rho + rho_top - shortest, 1e-20), rho / rho_top);
}

// Densities integrated (km) from a point (x = r^2 - R^2 at altitude h, b = r mu) to the top.
fn columns_to_top(table: texture_2d<f32>, radius: f32, thickness: f32, x: f32, h: f32, b: f32) -> vec3f {
    let size = vec2i(textureDimensions(table));
    let at = columns_share(x, h, b, radius, thickness) * vec2f(size - 1);
    return exp2(bilinear(table, corner(at, size), vec2i(0)).xyz);
}

// --- moments: rows for each altitude are six, the harmonics even in azimuth up to degree 2 about the zenith, with the
// sun at azimuth 0. The first holds log2 of the moment l = 0, the others their ratio to it. The last row of all
// is log2 of the ground's irradiance from the sky.

const MOMENTS: i32 = 6;

fn altitude_share(steepness: f32, growth: f32, h: f32, thickness: f32) -> f32 {
    let grown = max(h, 0.0) / thickness * growth;
    // log1p in the form that keeps its digits.
    let s = select(log(1.0 + grown), grown * (1.0 - grown * (0.5 - grown * (1.0 / 3.0 - grown * 0.25))), grown < 0.05);
    return sqrt(s / steepness);
}

fn share_altitude(t: Tables, share: f32, thickness: f32) -> f32 {
    let s = t.altitude_steepness * share * share;
    // expm1 in the form that keeps its digits.
    let grown = select(exp(s) - 1.0, s * (1.0 + s * (0.5 + s * (1.0 / 6.0 + s * (1.0 / 24.0)))), s < 0.05);
    return thickness * min(grown / t.altitude_growth, 1.0);
}

// The sun's axis of `moments`: middle, width, first and span of `Tables`.
fn sun_axis(t: Tables) -> vec4f {
    return vec4f(t.sun_middle, t.sun_width, t.sun_first, t.sun_span);
}

fn sun_share(axis: vec4f, mu: f32) -> f32 {
    let y = (mu - axis.x) / axis.y;
    return (sign(y) * log(abs(y) + sqrt(y * y + 1.0)) - axis.z) / axis.w;
}

fn share_sun(t: Tables, share: f32) -> f32 {
    return clamp(t.sun_middle + t.sun_width * sinh(t.sun_first + share * t.sun_span), -1.0, 1.0);
}

// Normalised real harmonics up to degree 2 (Y_00 = SH0, ...). along: part of the direction along the sun's
// horizontal direction; mu: along the zenith.
const SH0: f32 = 0.28209479177387814;  // sqrt(1 / (4 pi))
const SH1: f32 = 0.4886025119029199;   // sqrt(3 / (4 pi))
const SH20: f32 = 0.31539156525252005; // sqrt(5 / (16 pi))
const SH21: f32 = 1.0925484305920792;  // sqrt(15 / (4 pi))
const SH22: f32 = 0.5462742152960396;  // sqrt(15 / (16 pi))

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

// Light scattered before that gas and aerosol scatter into a direction, for densities of 1.
struct Source {
    gas: vec3f,      // 1/km
    aerosol: vec3f,  // 1/km
}

// The moments at a node (counted in texels) times those of the phase functions (addition theorem; Chandrasekhar 1960,
// section 48). gas: scattering, 1/km; aerosol: the same times its phase moments 0, 1 and 2; mu, mu_sun: cosines of
// the zenith angles of direction and sun; nu: of the angle between them.
fn diffuse_source(
    table: texture_2d<f32>, at: vec2f, gas: vec3f, aerosol: mat3x3f, mu: f32, mu_sun: f32, nu: f32,
) -> Source {
    let dims = vec2i(textureDimensions(table));
    var c = corner(at, vec2i(dims.x, (dims.y - 1) / MOMENTS));
    c.low.y *= MOMENTS;
    c.high.y *= MOMENTS;
    let mean = exp2(bilinear(table, c, vec2i(0)).xyz);
    let sin_sun = sqrt(max((1.0 - mu_sun) * (1.0 + mu_sun), 1e-12));
    let sin_view = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
    let along = clamp((nu - mu * mu_sun) / sin_sun, -sin_view, sin_view);
    let l2 = bilinear(table, c, vec2i(0, 3)).xyz * harmonic(3, mu, along)
        + bilinear(table, c, vec2i(0, 4)).xyz * harmonic(4, mu, along)
        + bilinear(table, c, vec2i(0, 5)).xyz * harmonic(5, mu, along);
    var source = Source(vec3f(0.0), vec3f(0.0));
    if RAYLEIGH {
        source.gas = gas * (SH0 + 0.1 * l2) * mean;
    }
    if MIE {
        let l1 = bilinear(table, c, vec2i(0, 1)).xyz * harmonic(1, mu, along)
            + bilinear(table, c, vec2i(0, 2)).xyz * harmonic(2, mu, along);
        source.aerosol = (SH0 * aerosol[0] + l1 * aerosol[1] + l2 * aerosol[2]) * mean;
    }
    return source;
}

// Irradiance of level ground from the sky.
fn ground_irradiance(table: texture_2d<f32>, t: Tables, mu_sun: f32) -> vec3f {
    let dims = vec2i(textureDimensions(table));
    let at = vec2f(sun_share(sun_axis(t), mu_sun) * f32(dims.x - 1), 0.0);
    return exp2(bilinear(table, corner(at, vec2i(dims.x, 1)), vec2i(0, dims.y - 1)).xyz);
}
