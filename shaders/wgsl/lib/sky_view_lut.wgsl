//#include constants
//#include frame
//#include geometry
// Where a view ray is in the sky-view LUT, and which ray a texel stands for (the idea: Hillaire 2020,
// section 5.3; the mapping is new). u: azimuth from the sun, half a turn; the other half is its mirror
// image. Rows: first the rays that end on the ground, by their angle there, then the others: those that go
// down by the altitude of their perigee (the limb), those that go up by their angle. Both parts begin at
// the horizon, where the light changes most, and no texel straddles it; near the ground limb and sky go
// over into each other without a bend. As the camera rises the limb takes more of the rows, at the top of
// the air all: nothing jumps there. No coordinate needs an arc function.
//
// The LUT holds fourth roots of light: between texels light then changes almost exponentially, as it does
// with altitude.

// A coordinate of half an angle's sine s: 0 where s = s_max, 1 at s = 0; square root at the first end,
// linear at the other. rest: s_max^2 - s^2, which is what the caller has without a difference.
fn crowded(rest: f32, s: f32, s_max: f32) -> f32 {
    return sqrt(max(rest, 0.0) / (s_max * (s + s_max)));
}

// u of a direction: s / (s + c) with sine and cosine of half the azimuth.
fn azimuth_to_u(dir: vec3f) -> f32 {
    let flat = max(length(dir.xy), 1e-30);
    let cosine = dir.x / flat;
    let large = sqrt(0.5 + 0.5 * min(abs(cosine), 1.0)); // cosine (or sine) of half the azimuth
    let small = 0.5 * abs(dir.y) / flat / large;
    let s = select(large, small, cosine >= 0.0);
    return s / (large + small);
}

// The inverse: cosine and sine of the azimuth.
fn u_to_azimuth(u: f32) -> vec2f {
    let c = 1.0 - u;
    let norm = 1.0 / (u * u + c * c);
    return vec2f((c - u) * (c + u), 2.0 * u * c) * norm;
}

// v of a ray along its part of the rows, 0 to 1. mu: its direction's cosine of the zenith angle; h: the
// camera's altitude; mapping: the limb's part of the rows, how far it is spaced as from outside (0 to 1),
// its part if it were not at all, and the horizon's cosine with its sign changed; see `FrameUniform` in
// Rust.
fn zenith_to_v(line: Line, mu: f32, h: f32, radius: f32, thickness: f32, mapping: vec4f) -> f32 {
    if line.ground {
        // Cosine of the angle to the vertical where the ray ends, and the sine of half of it.
        let cosine = min(sqrt(max(-line.perigee_excess, 0.0)) / radius, 1.0);
        return crowded(0.5 * cosine, line.perigee / radius / sqrt(2.0 + 2.0 * cosine), SQRT_HALF);
    }
    if mu >= 0.0 {
        // Half the zenith angle's sine, not from the cosine: near the zenith that is 1.
        let s = line.perigee / (radius + h) / sqrt(2.0 + 2.0 * mu);
        let near = crowded(0.5 * (mu + mapping.w), s, sqrt(0.5 + 0.5 * mapping.w));
        return mapping.x + (1.0 - mapping.x) * max(near - mapping.z, 0.0) / (1.0 - mapping.z);
    }
    let limit = max(min(h, thickness), 1e-20);
    let perigee_h = max(line.perigee_excess, 0.0) / (radius + line.perigee);
    let part = min(perigee_h / limit, 1.0);
    // y^2 = 1 - part. Near the ground y is the ray's angle below the horizontal over the horizon's: there
    // rows are even in it, from outside in `part`.
    let r_mu2 = select(line.r_mu * line.r_mu, top_half_chord2(line, h, radius, thickness), h > thickness);
    let y = sqrt(clamp(r_mu2 / (limit * (2.0 * radius + limit + perigee_h)), 0.0, 1.0));
    return mapping.x * sqrt(part * (1.0 + mapping.y * y) / (1.0 + y));
}

// A direction with its ray.
struct SkyViewRay {
    dir: vec3f,
    ray: AirRay,
}

// The ray that goes up of its v: the inverse of `zenith_to_v` for mu >= 0.
fn upward_ray(
    azimuth: vec2f, v: f32, h: f32, radius: f32, thickness: f32, mapping: vec4f, sun: vec3f,
) -> SkyViewRay {
    // Not beyond the zenith by a rounding error.
    let u = min(mapping.z + (v - mapping.x) / (1.0 - mapping.x) * (1.0 - mapping.z), 1.0);
    let rest = (1.0 - u) * (1.0 + u); // 1 - u^2
    let half = 0.5 + 0.5 * mapping.w;
    let s = sqrt(half) * rest;
    // 1 - 2 s^2, which is no difference at the horizon.
    let mu = max(2.0 * half * u * u * (1.0 + rest) - mapping.w, 0.0);
    let dir = vec3f(azimuth * (2.0 * s * sqrt(1.0 - s * s)), mu);
    return SkyViewRay(dir, inner_ray(dir, h, radius, thickness, sun, false));
}

// The ray of u and v; the inverse of `azimuth_to_u` and `zenith_to_v`. ground: whether it is among those
// that end on the ground. A ray that goes down is given by its perigee p: its direction's rounding decides
// nothing.
fn sky_view_ray(
    u: f32, v: f32, ground: bool, h: f32, radius: f32, thickness: f32, mapping: vec4f, sun: vec3f,
) -> SkyViewRay {
    let azimuth = u_to_azimuth(u);
    if !ground && v > mapping.x {
        return upward_ray(azimuth, v, h, radius, thickness, mapping, sun);
    }
    let r = radius + h;
    let excess = excess_of(h, radius);
    let top_excess = excess_of(thickness, radius);
    let outside = h > thickness;
    let start_excess = select(excess, top_excess, outside);
    var perigee_excess = 0.0;
    var perigee = 0.0;
    var from_start = 0.0; // start_excess - perigee_excess
    var mu = 0.0;         // cosine at the ground
    if ground {
        let rest = (1.0 - v) * (1.0 + v);
        let s = SQRT_HALF * rest;
        mu = v * v * (1.0 + rest); // 1 - 2 s^2
        perigee_excess = -radius * radius * mu * mu;
        perigee = radius * (2.0 * s * sqrt(1.0 - s * s));
        from_start = start_excess - perigee_excess;
    } else {
        let limit = min(h, thickness);
        let s = min(v / max(mapping.x, 1e-20), 1.0);
        let z = (1.0 - s) * (1.0 + s);
        let k = 1.0 - mapping.y;
        let y = 2.0 * z / max(k + sqrt(k * k + 4.0 * mapping.y * z), 1e-20);
        let perigee_h = limit * min(s * s * (1.0 + y) / (1.0 + mapping.y * y), 1.0);
        perigee_excess = excess_of(perigee_h, radius);
        perigee = radius + perigee_h;
        from_start = limit * y * y * (2.0 * radius + limit + perigee_h);
    }
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    let r_mu = -sqrt(max(from_start, 0.0));
    let down = select(r_mu, -sqrt(max(above + from_start, 0.0)), outside) / r;
    let dir = vec3f(azimuth * min(perigee / r, 1.0), down);
    var s: SunSide;
    var start = 0.0;
    if outside {
        start = above / (-r_mu - r * down);
        s = sun_side_outside(dir, sun, r, start, -r_mu, top_excess, radius);
    } else {
        s = sun_side_inside(dir, sun, r, excess, radius);
    }
    let to_top = distance_to_top(start_excess, r_mu, top_excess);
    let reach = select(to_top, start_excess / max(radius * mu - r_mu, 1e-20), ground);
    let ray = AirRay(
        start, reach, start_excess, r_mu, perigee_excess,
        s.sun_r_mu, s.nu, s.sin2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
    return SkyViewRay(dir, ray);
}

// The row of a v in a LUT of so many rows, of which the first ground_rows are for rays that end on the
// ground.
fn v_to_row(v: f32, ground: bool, rows: f32, ground_rows: f32) -> f32 {
    return select(ground_rows + v * (rows - ground_rows - 1.0), v * (ground_rows - 1.0), ground);
}

// The inverse at a texel: v in x, and in y 1 for rays that end on the ground.
fn row_to_v(row: i32, rows: i32, ground_rows: i32) -> vec2f {
    let ground = row < ground_rows;
    let first = select(ground_rows, 0, ground);
    let count = select(rows - ground_rows, ground_rows, ground);
    return vec2f(f32(row - first) / f32(count - 1), select(0.0, 1.0, ground));
}

// Where the sampler finds u and a row.
fn sky_view_uv(u: f32, row: f32, size: vec2f) -> vec2f {
    return (vec2f(u * (size.x - 1.0), row) + 0.5) / size;
}

// Light as the LUT stores it.
fn encode_light(light: vec3f) -> vec3f {
    return sqrt(sqrt(light));
}

// The inverse.
fn decode_light(texel: vec3f) -> vec3f {
    let square = texel * texel;
    return square * square;
}
