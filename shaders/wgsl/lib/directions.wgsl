//#include constants
//#include geometry
// The directions in which light is gathered at the nodes of the multi-scattering LUT: Gauss's rule in
// zenith angle on each side of the horizon, the midpoint rule in azimuth over half a turn (the other half
// is its mirror image).

const ZENITHS: i32 = 16;  // half of them above the horizon
const AZIMUTHS: i32 = 8;

// Abscissa and weight of Gauss-Legendre's rule with 8 points on 0..1 (Abramowitz & Stegun 1964, table 25.4).
fn gauss8(i: i32) -> vec2f {
    switch i {
        case 0: { return vec2f(0.019855071751231884, 0.050614268145188130); }
        case 1: { return vec2f(0.101666761293186630, 0.111190517226687235); }
        case 2: { return vec2f(0.237233795041835507, 0.156853322938943644); }
        case 3: { return vec2f(0.408282678752175098, 0.181341891689180991); }
        case 4: { return vec2f(0.591717321247824902, 0.181341891689180991); }
        case 5: { return vec2f(0.762766204958164493, 0.156853322938943644); }
        case 6: { return vec2f(0.898333238706813370, 0.111190517226687235); }
        default: { return vec2f(0.980144928248768116, 0.050614268145188130); }
    }
}

struct Direction {
    mu: f32,       // cosine of the zenith angle
    azimuth: f32,  // from the sun's, rad
    above: bool,   // the horizon
    weight: f32,   // solid angle, both halves of the turn, sr
}

// The direction of a number on both axes. Zenith angles crowd at the horizon, where the light changes most:
// mu = horizon + span x^2, dmu = 2 span x dx with the abscissa x. h: altitude of the node, km.
fn node_direction(zenith: i32, azimuth: i32, h: f32, radius: f32) -> Direction {
    let half = ZENITHS / 2;
    let above = zenith < half;
    let node = gauss8(select(zenith - half, zenith, above));
    let horizon = -sqrt(excess_of(h, radius)) / (radius + h);
    let span = select(-1.0 - horizon, 1.0 - horizon, above);
    let mu = clamp(horizon + span * node.x * node.x, -1.0, 1.0);
    let step = PI / f32(AZIMUTHS);
    return Direction(mu, (f32(azimuth) + 0.5) * step, above, abs(span) * 2.0 * node.x * node.y * 2.0 * step);
}
