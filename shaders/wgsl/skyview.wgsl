//#include frame
//#include geometry
//#include tables
// Where a view ray is in the sky tables, and which ray a texel stands for. Column: azimuth from the sun, half a turn (the
// other half is its mirror image). Rows: first the rays that end on the ground, by their angle there, then the others,
// by their angle above the horizon or, from outside, by the altitude that they pass. Both begin at the horizon,
// where the light changes most, and no texel straddles it. No coordinate needs an arc function.

const SQRT_HALF: f32 = 0.7071067811865476;

// Half an angle's sine s to a share: 0 where s = s_max, 1 at s = 0; square root at the first end, linear at the other.
// rest: s_max^2 - s^2, which is what the caller has without a difference.
fn crowded(rest: f32, s: f32, s_max: f32) -> f32 {
    return sqrt(max(rest, 0.0) / (s_max * (s + s_max)));
}

fn azimuth_share(dir: vec3f) -> f32 {
    let flat = max(length(dir.xy), 1e-30);
    let cosine = dir.x / flat;
    let large = sqrt(0.5 + 0.5 * min(abs(cosine), 1.0)); // cosine (or sine) of half the azimuth
    let small = 0.5 * abs(dir.y) / flat / large;
    let s = select(large, small, cosine >= 0.0);
    return s / (large + small);
}

// Cosine and sine of the azimuth.
fn share_azimuth(share: f32) -> vec2f {
    let c = 1.0 - share;
    let norm = 1.0 / (share * share + c * c);
    return vec2f((c - share) * (c + share), 2.0 * share * c) * norm;
}

// Share of a ray along its part of the rows. h: camera's altitude.
fn zenith_share(ray: AirRay, dir: vec3f, h: f32, m: Medium) -> f32 {
    let flat = length(dir.xy);
    if ray.ground {
        // Cosine of the angle to the vertical where the ray ends, and the sine of half of it.
        let mu = clamp(-(ray.b + ray.length) / m.radius, 0.0, 1.0);
        let s = (1.0 + h / m.radius) * flat / sqrt(2.0 + 2.0 * mu);
        return crowded(0.5 * mu, s, SQRT_HALF);
    }
    if ray.start > 0.0 || h > m.thickness {
        return sqrt(clamp(altitude_of(ray.x_closest, m.radius) / m.thickness, 0.0, 1.0));
    }
    let horizon = sqrt(ray.x) / (m.radius + h); // less the horizon's cosine
    // Half the zenith angle's sine; near the zenith not from the cosine, which is 1 there.
    let s = select(sqrt(0.5 - 0.5 * dir.z), flat / sqrt(max(2.0 + 2.0 * dir.z, 1.0)), dir.z > 0.0);
    return crowded(0.5 * (dir.z + horizon), s, sqrt(0.5 + 0.5 * horizon));
}

struct TableRay {
    dir: vec3f,
    ray: AirRay,
}

// The ray of a share of the azimuth and of the rows; the inverse of the above.
fn table_ray(azimuth: f32, share: f32, ground: bool, h: f32, m: Medium, sun: vec3f) -> TableRay {
    let r = m.radius + h;
    let x = excess_of(h, m.radius);
    let x_top = excess_of(m.thickness, m.radius);
    let around = share_azimuth(azimuth);
    let outside = h > m.thickness;
    let q = share * share;
    let rest = (1.0 - share) * (1.0 + share); // 1 - q
    if !outside && !ground {
        let horizon = sqrt(x) / r;
        let s = sqrt(0.5 + 0.5 * horizon) * rest;
        // 1 - 2 s^2 and 1 - s^2, of which neither is a difference at the horizon.
        let rise = (0.5 + 0.5 * horizon) * q * (1.0 + rest);
        let mu = 2.0 * rise - horizon;
        let foot = m.radius / r;
        let dir = vec3f(around * (2.0 * s * sqrt(0.5 * foot * foot / (1.0 + horizon) + rise)), mu);
        return TableRay(dir, inner_ray(dir, h, m.radius, m.thickness, sun, false));
    }
    // The rest is given by the closest approach p: p^2 = R^2 + c2.
    var c2 = 0.0;
    var approach = 0.0;
    var under_top = 0.0; // x_top - c2
    var mu = 0.0; // cosine at the ground
    if ground {
        let s = SQRT_HALF * rest;
        mu = q * (1.0 + rest); // 1 - 2 s^2
        c2 = -m.radius * m.radius * mu * mu;
        approach = m.radius * (2.0 * s * sqrt(1.0 - s * s));
        under_top = x_top - c2;
    } else {
        c2 = excess_of(m.thickness * q, m.radius);
        approach = m.radius + m.thickness * q;
        under_top = m.thickness * rest * (2.0 * m.radius + m.thickness * (1.0 + q));
    }
    let above = (h - m.thickness) * (2.0 * m.radius + m.thickness + h);
    let start_x = select(x, x_top, outside);
    let b = -sqrt(select(max(x - c2, 0.0), under_top, outside));
    let down = select(b, -sqrt(max(above + under_top, 0.0)), outside) / r;
    let dir = vec3f(around * min(approach / r, 1.0), down);
    var s: SunSide;
    var start = 0.0;
    if outside {
        start = above / (-b - r * down);
        s = sun_side_outside(dir, sun, r, start, -b, x_top, m.radius);
    } else {
        s = sun_side_inside(dir, sun, r, x, m.radius);
    }
    let reach = select(-2.0 * b, start_x / max(m.radius * mu - b, 1e-20), ground);
    let ray = AirRay(start, reach, start_x, b, c2, s.sun_b, s.nu, s.cross2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
    return TableRay(dir, ray);
}

// Rows of a sky table of so many, and where in them a ray is.
fn sky_row(share: f32, ground: bool, rows: i32, ground_rows: f32) -> f32 {
    return select(ground_rows + share * (f32(rows) - ground_rows - 1.0), share * (ground_rows - 1.0), ground);
}
