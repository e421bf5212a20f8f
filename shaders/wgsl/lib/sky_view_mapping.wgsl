//#include frame
//#include geometry
//#include tables
// Where a view ray is in the sky tables, and which ray a texel stands for. Column: azimuth from the sun, half a turn (the
// other half is its mirror image). Rows: first the rays that end on the ground, by their angle there, then the others:
// those that go down by the altitude that they pass (the limb), those that go up by their angle. Both parts begin at
// the horizon, where the light changes most, and no texel straddles it; near the ground limb and sky go over into each other
// without a bend. As the camera rises the limb takes more of the rows, at the top of the air all: nothing jumps there.
// No coordinate needs an arc function.

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

// Share of a ray along its part of the rows. mu: its direction's cosine of the zenith angle; h: the camera's altitude;
// limb: the limb's share, how far it is spaced as from outside (0 to 1), its share if it were not at all, and the horizon's
// cosine with its sign changed; see `FrameUniform::limb` in Rust.
fn zenith_share(line: Line, mu: f32, h: f32, radius: f32, thickness: f32, limb: vec4f) -> f32 {
    if line.ground {
        // Cosine of the angle to the vertical where the ray ends, and the sine of half of it.
        let cosine = min(sqrt(max(-line.x_closest, 0.0)) / radius, 1.0);
        return crowded(0.5 * cosine, line.p / radius / sqrt(2.0 + 2.0 * cosine), SQRT_HALF);
    }
    if mu >= 0.0 {
        // Half the zenith angle's sine, not from the cosine: near the zenith that is 1.
        let s = line.p / (radius + h) / sqrt(2.0 + 2.0 * mu);
        let near = crowded(0.5 * (mu + limb.w), s, sqrt(0.5 + 0.5 * limb.w));
        return limb.x + (1.0 - limb.x) * max(near - limb.z, 0.0) / (1.0 - limb.z);
    }
    let limit = max(min(h, thickness), 1e-20);
    let lowest = max(line.x_closest, 0.0) / (radius + line.p);
    let part = min(lowest / limit, 1.0);
    // v^2 = 1 - part. Near the ground v is the ray's angle below the horizontal over the horizon's: there rows are even in
    // it, from outside in `part`.
    let b2 = select(line.b * line.b, top_half_chord2(line, h, radius, thickness), h > thickness);
    let v = sqrt(clamp(b2 / (limit * (2.0 * radius + limit + lowest)), 0.0, 1.0));
    return limb.x * sqrt(part * (1.0 + limb.y * v) / (1.0 + v));
}

struct TableRay {
    dir: vec3f,
    ray: AirRay,
}

// The ray of a share of the azimuth and of the rows; the inverse of the above.
fn table_ray(azimuth: f32, share: f32, ground: bool, h: f32, radius: f32, thickness: f32, limb: vec4f, sun: vec3f) -> TableRay {
    let r = radius + h;
    let x = excess_of(h, radius);
    let x_top = excess_of(thickness, radius);
    let around = share_azimuth(azimuth);
    let outside = h > thickness;
    if !ground && share > limb.x {
        // Not beyond the zenith by a rounding error.
        let u = min(limb.z + (share - limb.x) / (1.0 - limb.x) * (1.0 - limb.z), 1.0);
        let rest = (1.0 - u) * (1.0 + u); // 1 - u^2
        let half = 0.5 + 0.5 * limb.w;
        let s = sqrt(half) * rest;
        // 1 - 2 s^2, which is no difference at the horizon.
        let mu = max(2.0 * half * u * u * (1.0 + rest) - limb.w, 0.0);
        let dir = vec3f(around * (2.0 * s * sqrt(1.0 - s * s)), mu);
        return TableRay(dir, inner_ray(dir, h, radius, thickness, sun, false));
    }
    // The rest is given by the closest approach p: p^2 = R^2 + c2.
    let start_x = select(x, x_top, outside);
    var c2 = 0.0;
    var approach = 0.0;
    var from_start = 0.0; // start_x - c2
    var mu = 0.0; // cosine at the ground
    if ground {
        let rest = (1.0 - share) * (1.0 + share);
        let s = SQRT_HALF * rest;
        mu = share * share * (1.0 + rest); // 1 - 2 s^2
        c2 = -radius * radius * mu * mu;
        approach = radius * (2.0 * s * sqrt(1.0 - s * s));
        from_start = start_x - c2;
    } else {
        let limit = min(h, thickness);
        let s = min(share / max(limb.x, 1e-20), 1.0);
        let y = (1.0 - s) * (1.0 + s);
        let k = 1.0 - limb.y;
        let v = 2.0 * y / max(k + sqrt(k * k + 4.0 * limb.y * y), 1e-20);
        let lowest = limit * min(s * s * (1.0 + v) / (1.0 + limb.y * v), 1.0);
        c2 = excess_of(lowest, radius);
        approach = radius + lowest;
        from_start = limit * v * v * (2.0 * radius + limit + lowest);
    }
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    let b = -sqrt(max(from_start, 0.0));
    let down = select(b, -sqrt(max(above + from_start, 0.0)), outside) / r;
    let dir = vec3f(around * min(approach / r, 1.0), down);
    var s: SunSide;
    var start = 0.0;
    if outside {
        start = above / (-b - r * down);
        s = sun_side_outside(dir, sun, r, start, -b, x_top, radius);
    } else {
        s = sun_side_inside(dir, sun, r, x, radius);
    }
    let reach = select(distance_to_top(start_x, b, x_top), start_x / max(radius * mu - b, 1e-20), ground);
    let ray = AirRay(
        start, reach, start_x, b, c2, s.sun_b, s.nu, s.cross2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
    return TableRay(dir, ray);
}

// Rows of a sky table of so many, and where in them a ray is.
fn sky_row(share: f32, ground: bool, rows: f32, ground_rows: f32) -> f32 {
    return select(ground_rows + share * (rows - ground_rows - 1.0), share * (ground_rows - 1.0), ground);
}
