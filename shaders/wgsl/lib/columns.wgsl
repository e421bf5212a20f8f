//#include geometry
//#include medium
//#include path
// Densities integrated along a path by eight nodes: what a pixel can afford, for any part of a ray that has
// one lowest point. Along a line densities are nearly Gaussian in the distance from its perigee, for which
// Gauss-Legendre's rule with 8 points (Abramowitz & Stegun 1964, table 25.4) is off by at most 9.1e-4 of the
// integral, on one side of the perigee, across it and straight up, where it ends 7 scale heights above the
// lowest point (6: 2.5e-3, 9: 2.0e-3; the tests of `model::quadrature` print these). Transmittances are right
// to 5e-4 (`thorough::near_air`).

const COLUMN_NODES: vec4f = vec4f(0.1834346425, 0.5255324099, 0.7966664774, 0.9602898565);
const COLUMN_WEIGHTS: vec4f = vec4f(0.3626837834, 0.3137066459, 0.2223810345, 0.1012285363);
const COLUMN_HEIGHTS: f32 = 7.0; // scale heights; what lies higher is exp(-7) of the whole

// Heights above the lowest ground (km, never negative) at distances from a point of a line: see
// `altitude_after`.
fn heights_after(excess: f32, r_mu: f32, t: vec4f, radius: f32) -> vec4f {
    let x = excess + t * (2.0 * r_mu + t);
    return max(x / (radius + sqrt(max(radius * radius + x, vec4f(0.0)))), vec4f(0.0));
}

// Distance (km) from a line's perigee at which it is at a height; 0 where it always is higher.
fn distance_at_height(excess: f32, r_mu: f32, h: f32, radius: f32) -> f32 {
    return sqrt(max(excess_of(h, radius) - excess + r_mu * r_mu, 0.0));
}

// Middle and half length (km) of the part of a way from one distance to another that lies at most so far (km)
// above its lowest point, or above altitude 0 where that is higher. Distances count from the lowest point,
// whose excess and r mu are given; datum: height of altitude 0, km.
fn dense_part(
    excess: f32, r_mu: f32, first: f32, last: f32, radius: f32, above: f32, datum: f32,
) -> vec2f {
    let reach = distance_at_height(excess, r_mu, max(altitude_of(excess, radius), datum) + above, radius);
    let begin = max(first, -reach - r_mu);
    let half = 0.5 * max(min(last, reach - r_mu) - begin, 0.0);
    return vec2f(begin + half, half);
}

// An exponential of altitude integrated (km) from one distance to another, counted as there. fall: 1 / scale
// height, 1/km.
fn exponential_column(
    excess: f32, r_mu: f32, first: f32, last: f32, radius: f32, fall: f32, datum: f32,
) -> f32 {
    let part = dense_part(excess, r_mu, first, last, radius, COLUMN_HEIGHTS / fall, datum);
    let half = part.y;
    let t = half * COLUMN_NODES;
    let above = max(heights_after(excess, r_mu, part.x - t, radius) - datum, vec4f(0.0));
    let beyond = max(heights_after(excess, r_mu, part.x + t, radius) - datum, vec4f(0.0));
    return half * dot(COLUMN_WEIGHTS, exp(-above * fall) + exp(-beyond * fall));
}

// Abscissas and weights of the same rule with 3 points on 0..1.
const TENT_NODES: vec3f = vec3f(0.1127016654, 0.5, 0.8872983346);
const TENT_WEIGHTS: vec3f = vec3f(0.2777777778, 0.4444444444, 0.2777777778);

// A slope of a tent of altitude, the same way: along it altitude is nearly a parabola. tip: altitude of its
// tip; fall: 1 / half width.
fn slope_column(
    excess: f32, r_mu: f32, first: f32, last: f32, radius: f32, fall: f32, tip: f32, datum: f32,
) -> f32 {
    let span = max(last - first, 0.0);
    let t = first + span * TENT_NODES;
    let h = vec3f(
        altitude_after(excess, r_mu, t.x, radius), altitude_after(excess, r_mu, t.y, radius),
        altitude_after(excess, r_mu, t.z, radius));
    let z = max(h - datum, vec3f(0.0));
    return span * dot(TENT_WEIGHTS, max(1.0 - abs(z - tip) * fall, vec3f(0.0)));
}

// The tent over the first `length` km of a rising path.
fn tent_column(
    excess: f32, r_mu: f32, length: f32, radius: f32, fall: f32, tip: f32, datum: f32,
) -> f32 {
    let width = 1.0 / fall;
    // Below altitude 0 there is as much as at it, if there is some.
    let low = datum + tip - width;
    let first = select(distance_at_height(excess, r_mu, low, radius) - r_mu, 0.0, tip <= width);
    if first >= length {
        return 0.0;
    }
    let edges = clamp(
        vec3f(
            first,
            distance_at_height(excess, r_mu, datum + tip, radius) - r_mu,
            distance_at_height(excess, r_mu, datum + tip + width, radius) - r_mu,
        ),
        vec3f(0.0), vec3f(length));
    return slope_column(excess, r_mu, edges.x, edges.y, radius, fall, tip, datum)
        + slope_column(excess, r_mu, edges.y, edges.z, radius, fall, tip, datum);
}

// Gas, aerosol and absorber (km, relative densities times km) from one distance to another, first <= 0 <=
// last, counted as above.
fn columns(
    layers: mat2x3f, excess: f32, r_mu: f32, first: f32, last: f32, radius: f32,
) -> vec3f {
    let fall = layers[0];
    let datum = layers[1].x;
    var sum = vec3f(0.0);
    if RAYLEIGH {
        sum.x = exponential_column(excess, r_mu, first, last, radius, fall.x, datum);
    }
    if MIE {
        sum.y = exponential_column(excess, r_mu, first, last, radius, fall.y, datum);
    }
    if OZONE {
        // Away from the lowest point: one way, or both.
        let tip = layers[1].y;
        sum.z = tent_column(excess, abs(r_mu), max(-first, last), radius, fall.z, tip, datum);
        let other = min(-first, last);
        if other > 0.0 {
            sum.z += tent_column(excess, 0.0, other, radius, fall.z, tip, datum);
        }
    }
    return sum;
}

// The same over the first `length` km of a path. whole: all of the path, which may end on the ground.
fn path_columns(
    layers: mat2x3f, line: Line, path: AirPath, length: f32, whole: bool, radius: f32,
) -> vec3f {
    let lowest = lowest_point(
        path.excess, path.r_mu, line.perigee_excess, line.ground && whole, length, radius);
    return columns(
        layers, lowest.excess, lowest.r_mu, -lowest.distance, length - lowest.distance, radius);
}

// The rule with 4 points on -1..1: for what two passes have to agree in, see `rough_opacity`.
const ROUGH_NODES: vec2f = vec2f(0.3399810436, 0.8611363116);
const ROUGH_WEIGHTS: vec2f = vec2f(0.6521451549, 0.3478548451);
const ROUGH_HEIGHTS: f32 = 5.0; // scale heights

// An exponential of altitude, as in `exponential_column`, within 6 % (the same test).
fn rough_column(
    excess: f32, r_mu: f32, first: f32, last: f32, radius: f32, fall: f32, datum: f32,
) -> f32 {
    let part = dense_part(excess, r_mu, first, last, radius, ROUGH_HEIGHTS / fall, datum);
    let half = part.y;
    let t = half * ROUGH_NODES;
    let h = heights_after(excess, r_mu, part.x + vec4f(-t, t), radius);
    let density = exp(-max(h - datum, vec4f(0.0)) * fall);
    return half * dot(ROUGH_WEIGHTS, density.xy + density.zw);
}

// What gas and aerosol take away along all of a path that reaches from `first` to `last` about its lowest
// point, roughly, but smoothly from ray to ray, and the same wherever it is computed.
fn rough_opacity(
    layers: mat2x3f, coefficients: mat3x3f, excess: f32, r_mu: f32, first: f32, last: f32, radius: f32,
) -> vec3f {
    var sum = vec3f(0.0);
    if RAYLEIGH {
        sum.x = rough_column(excess, r_mu, first, last, radius, layers[0].x, layers[1].x);
    }
    if MIE {
        sum.y = rough_column(excess, r_mu, first, last, radius, layers[0].y, layers[1].x);
    }
    return opacity(extinction(coefficients, sum));
}
