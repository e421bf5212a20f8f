// The moon before the sun: which share of the sun's light passes it. Radii and distances on the plane at distance 1 across
// the sun's direction, so that nothing is an angle near 0. No sine, cosine or arc function of the driver's, whose
// errors may be 5e-4.

const HALF_TURN: f32 = 3.14159265358979;

// Arc tangent of y / x, both >= 0. Abramowitz & Stegun 4.4.49, within 2e-8 for y <= x.
fn quarter_atan(y: f32, x: f32) -> f32 {
    let q = min(x, y) / max(max(x, y), 1e-30);
    let s = q * q;
    let p = 1.0 + s * (-0.3333314528 + s * (0.1999355085 + s * (-0.1420889944 + s * (0.1065626393
        + s * (-0.0752896400 + s * (0.0429096138 + s * (-0.0161657367 + s * 0.0028662257)))))));
    return select(q * p, 0.5 * HALF_TURN - q * p, y > x);
}

// Of the angle at a circle's middle to where it meets another circle: numbers in the ratio of sine and cosine of its
// half, after Kahan's form of a triangle's angle by its sides.
fn half_angle(own: f32, apart: f32, other: f32) -> vec2f {
    // The difference of the radii first: it is exact where they are alike.
    let more = other - own;
    let opposite = (more + apart) * (other + own - apart);
    let adjacent = (apart - more) * (own + apart + other);
    return sqrt(max(vec2f(opposite, adjacent), vec2f(0.0)));
}

// a - sin a cos a for the angle a, 0 to pi, of such a half: of a circle's area, times its radius squared, what lies
// beyond a chord.
fn segment(half: vec2f) -> f32 {
    let a = 2.0 * quarter_atan(half.x, half.y);
    if a < 0.5 {
        // (y - sin y) / 2 with y = 2 a as a series.
        let y2 = 4.0 * a * a;
        return a * y2 * (1.0 / 6.0) * (1.0 - y2 * (1.0 / 20.0) * (1.0 - y2 * (1.0 / 42.0) * (1.0 - y2 * (1.0 / 72.0))));
    }
    let sum = dot(half, half);
    return a - 2.0 * half.x * half.y * (half.y * half.y - half.x * half.x) / (sum * sum);
}

// Share of a uniform sun that is not covered. moon: radius, apart: distance of the middles, both in radii of the sun.
fn visible_share(moon: f32, apart: f32) -> f32 {
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
        return clamp((segment(at_sun.yx) - of_moon) / HALF_TURN, 0.0, 1.0);
    }
    return clamp(1.0 - (segment(at_sun) + of_moon) / HALF_TURN, 0.0, 1.0);
}

// Radius of the moon and distance of the middles, in radii of the sun, as seen from a point. apart, along: the moon's
// distance from the sun's axis through the point, and along it, km; radius: of the moon, km; tangent: of the sun's
// angular radius. A moon that is not before the point is far beside the sun.
fn moon_before_sun(apart: f32, along: f32, radius: f32, tangent: f32) -> vec2f {
    let scale = 1.0 / (max(along, 1e-3 * radius) * tangent);
    return select(vec2f(0.0, 1e3), vec2f(radius, apart) * scale, along > 0.0);
}
