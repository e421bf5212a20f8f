//#include constants
// The moon before the sun: the visible fraction of the sun's disk. Radii and distances are those on the
// plane at distance 1 across the sun's direction, so that nothing is an angle near 0. No sine, cosine or
// arc function of the driver's, whose errors may be 5e-4.

// Arc tangent of y / x, rad, both >= 0: Abramowitz & Stegun 1964, 4.4.49, within 2e-8 for y <= x.
fn quarter_atan(y: f32, x: f32) -> f32 {
    let q = min(x, y) / max(max(x, y), 1e-30);
    let s = q * q;
    let p = 1.0 + s * (-0.3333314528 + s * (0.1999355085 + s * (-0.1420889944 + s * (0.1065626393
        + s * (-0.0752896400 + s * (0.0429096138 + s * (-0.0161657367 + s * 0.0028662257)))))));
    return select(q * p, 0.5 * PI - q * p, y > x);
}

// The angle at a circle's middle to where it meets another circle, as numbers in the ratio of sine and
// cosine of its half: Kahan 2014, "Miscalculating Area and Angles of a Needle-like Triangle", the angle of
// a triangle by its sides. own, other: radii; apart: distance of the middles.
fn half_angle(own: f32, apart: f32, other: f32) -> vec2f {
    // The difference of the radii first: it is exact where they are alike.
    let more = other - own;
    let opposite = (more + apart) * (other + own - apart);
    let adjacent = (apart - more) * (own + apart + other);
    return sqrt(max(vec2f(opposite, adjacent), vec2f(0.0)));
}

// Area that a chord cuts from a circle of radius 1, a - sin a cos a, where the chord's ends are seen from
// the middle at the angles +-a. half: sine and cosine of a / 2 in their ratio. As a series where the
// difference loses its digits.
fn segment(half: vec2f) -> f32 {
    let a = 2.0 * quarter_atan(half.x, half.y);
    if a < 0.5 {
        // (y - sin y) / 2 with y = 2 a as a series.
        let y2 = 4.0 * a * a;
        let series = 1.0 - y2 * (1.0 / 20.0) * (1.0 - y2 * (1.0 / 42.0) * (1.0 - y2 * (1.0 / 72.0)));
        return a * y2 * (1.0 / 6.0) * series;
    }
    let sum = dot(half, half);
    return a - 2.0 * half.x * half.y * (half.y * half.y - half.x * half.x) / (sum * sum);
}

// Visible fraction of a uniform sun, 0 to 1: 1 less both segments of the disks' lens over the sun's area.
// moon: radius, apart: distance of the middles, both in radii of the sun.
fn visible_fraction(moon: f32, apart: f32) -> f32 {
    if apart >= 1.0 + moon {
        return 1.0;
    }
    if apart <= moon - 1.0 {
        return 0.0;
    }
    if apart <= 1.0 - moon {
        return (1.0 - moon) * (1.0 + moon);
    }
    let at_sun = half_angle(1.0, apart, moon);
    let of_moon = moon * moon * segment(half_angle(moon, apart, 1.0));
    // More than half of the sun's circle lies within the moon's: what is left is a crescent.
    if at_sun.y < at_sun.x {
        return clamp((segment(at_sun.yx) - of_moon) / PI, 0.0, 1.0);
    }
    return clamp(1.0 - (segment(at_sun) + of_moon) / PI, 0.0, 1.0);
}

// Radius of the moon and distance of the middles, in radii of the sun, as seen from a point. apart, along:
// the moon's distance from the sun's axis through the point, and along it, km; radius: of the moon, km;
// tan_sun_radius: tangent of the sun's angular radius. A moon that is not before the point is far beside
// the sun.
fn moon_before_sun(apart: f32, along: f32, radius: f32, tan_sun_radius: f32) -> vec2f {
    let scale = 1.0 / (max(along, 1e-3 * radius) * tan_sun_radius);
    return select(vec2f(0.0, 1e3), vec2f(radius, apart) * scale, along > 0.0);
}
