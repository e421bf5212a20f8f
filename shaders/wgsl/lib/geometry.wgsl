// Rays through a spherical shell, in forms that keep their digits in f32. Lengths in km.
//
// The formulas are those of Bruneton & Neyret 2008 ("Precomputed Atmospheric Scattering", section 4) and of
// Bruneton's implementation of 2017 (ebruneton.github.io/precomputed_atmospheric_scattering,
// functions.glsl); the forms are new. With R = 6371 km a float has a step of 0.5 m, so that no function
// here subtracts two radii. A position is carried as its excess, which is small near the surface.
//
//   R       radius of the planet                  r        distance from its centre
//   h       altitude, r - R                       mu       cosine of a direction's zenith angle
//   excess  x = r^2 - R^2 = h (2R + h), km^2      r_mu     b = r mu, km
//   perigee the point of a line or of a path that is nearest to the centre; p its distance from there
//   nu      cosine of the angle between ray and sun
//
// A ray at distance t from (x, b) has the excess x + 2 b t + t^2 and r mu = b + t.

// Altitude (km) of an excess: h = x / (R + r), from x = (r - R)(r + R) without the difference.
fn altitude_of(excess: f32, radius: f32) -> f32 {
    return excess / (radius + sqrt(max(radius * radius + excess, 0.0)));
}

// Excess (km^2) of an altitude: h (2R + h).
fn excess_of(h: f32, radius: f32) -> f32 {
    return h * (2.0 * radius + h);
}

// Altitude (km), never negative, at a distance t along a ray: of the excess x + t (2 b + t).
fn altitude_after(excess: f32, r_mu: f32, t: f32, radius: f32) -> f32 {
    return max(altitude_of(excess + t * (2.0 * r_mu + t), radius), 0.0);
}

// A view ray in the air, from where it enters (or the camera) to where it ends.
struct AirRay {
    start: f32,          // distance from the camera to the entry, 0 inside
    length: f32,         // distance from the entry to the ground or the top; negative if it misses the air
    excess: f32,         // at the entry
    r_mu: f32,           // at the entry
    perigee_excess: f32, // of the whole line, negative if its perigee is underground
    sun_r_mu: f32,       // r times the cosine of the sun's zenith angle at the entry
    nu: f32,             // cosine of the angle between ray and sun
    sin2: f32,           // squared sine of that angle
    shadow_b: f32,       // at the entry: position times direction, both without their parts along the sun
    shadow_c: f32,       // squared distance of the entry from the planet's axis towards the sun, less R^2
    shadow_half2: f32,   // squared half chord that the shadow's circle cuts from the ray, see below
    ground: bool,        // the ray ends on the ground
}

// Distance (km) to the top of the air, t = -b + sqrt(b^2 + x_top - x): Bruneton 2017,
// DistanceToTopAtmosphereBoundary. Upwards as c / (b + root), the quadratic's other form, whose sum does
// not cancel. x <= x_top: it leaves once.
fn distance_to_top(excess: f32, r_mu: f32, top_excess: f32) -> f32 {
    let c = max(top_excess - excess, 0.0);
    let root = sqrt(r_mu * r_mu + c);
    if r_mu > 0.0 {
        return c / (r_mu + root);
    }
    return root - r_mu;
}

// Squared half of the chord (km^2) that a line cuts from a sphere, s^2 - p^2 = b^2 - (r^2 - s^2) for a
// radius s; negative if the line passes by. above: r^2 - s^2, depth: s - p. The difference keeps its digits
// near the sphere, where p is next to r; the product (s - p)(s + p) keeps them far away, where b^2 and
// above are large and nearly equal.
fn half_chord2(r_mu: f32, above: f32, depth: f32, p: f32) -> f32 {
    let sphere = depth + p;
    if abs(r_mu) < sphere {
        return r_mu * r_mu - above;
    }
    return depth * (sphere + p);
}

// What a ray has to do with the sun: see the fields of `AirRay`.
struct SunSide {
    sun_r_mu: f32,
    nu: f32,
    sin2: f32,
    shadow_b: f32,
    shadow_c: f32,
    shadow_half2: f32,
}

// The planet's shadow is a half cylinder of radius R around its axis away from the sun. Across that axis it
// is a circle, and the ray's part there a line that passes the centre at a distance that is a product,
// without a difference: the component of dir x sun along r, over its length.
fn shadow_half2(s: SunSide, side_z: f32, r: f32, radius: f32) -> f32 {
    let sine = max(sqrt(s.sin2), 1e-18);
    let p = r * abs(side_z) / sine;
    return half_chord2(s.shadow_b / sine, s.shadow_c, radius - p, p);
}

// For a camera in the air at r = R + h with this excess. dir, sun: unit, zenith frame.
fn sun_side_inside(dir: vec3f, sun: vec3f, r: f32, excess: f32, radius: f32) -> SunSide {
    var s: SunSide;
    s.nu = dot(dir, sun);
    // Near the sun and opposite to it, products of both lose the digits that their difference keeps.
    let side = cross(dir - select(-1.0, 1.0, s.nu >= 0.0) * sun, sun); // dir x sun
    s.sin2 = dot(side, side);
    s.sun_r_mu = r * sun.z;
    // (position x sun) . (direction x sun)
    s.shadow_b = r * (sun.x * side.y - sun.y * side.x);
    let q = r * length(sun.xy);
    s.shadow_c = -half_chord2(s.sun_r_mu, excess, radius - q, q);
    s.shadow_half2 = shadow_half2(s, side.z, r, radius);
    return s;
}

// For a ray from outside: at its entry, `start` after the camera at distance r and `half` before the
// perigee. A position that far away would lose metres in differences: everything is told from the perigee.
fn sun_side_outside(
    dir: vec3f, sun: vec3f, r: f32, start: f32, half: f32, top_excess: f32, radius: f32,
) -> SunSide {
    var s: SunSide;
    s.nu = dot(dir, sun);
    let same = select(-1.0, 1.0, s.nu >= 0.0);
    let apart = dir - same * sun;
    let side = cross(apart, sun); // dir x sun
    s.sin2 = dot(side, side);
    // The perigee is r (z - mu dir), whose parts are these; the entry is `half` before it.
    let perigee = vec3f(-dir.z * dir.xy, dot(dir.xy, dir.xy)) * r;
    // perigee . dir = 0, so perigee . sun = perigee . (sun - same dir). From there or from the camera: the
    // smaller terms.
    let there = -same * dot(perigee, apart);
    let here = r * sun.z;
    let nearer = abs(here) + start * abs(s.nu) < abs(there) + half * abs(s.nu);
    s.sun_r_mu = select(there - half * s.nu, here + start * s.nu, nearer);
    let perigee_side = cross(perigee, sun);
    s.shadow_b = dot(perigee_side, side) - half * s.sin2;
    let q = length(perigee_side - half * side);
    s.shadow_c = -half_chord2(s.sun_r_mu, top_excess, radius - q, q);
    s.shadow_half2 = shadow_half2(s, side.z, r, radius);
    return s;
}

// A camera ray as a line past the planet.
struct Line {
    r_mu: f32,           // at the camera
    perigee: f32,        // p, the distance of closest approach to the centre
    perigee_excess: f32, // p^2 - R^2, negative if that is underground
    ground: bool,        // meets the planet's surface
}

// The line of a camera at altitude h >= 0. p = r sin(zenith angle), from the horizontal part of the
// direction: from mu it would be a difference near the zenith. dir: unit, zenith frame.
fn line_past(dir: vec3f, h: f32, radius: f32) -> Line {
    let r = radius + h;
    let r_mu = r * dir.z;
    let p = r * sqrt(dot(dir.xy, dir.xy));
    let ground2 = half_chord2(r_mu, excess_of(h, radius), radius - p, p);
    return Line(r_mu, p, -ground2, r_mu < 0.0 && ground2 >= 0.0);
}

// The direction of a line with the azimuth of dir, which is its direction unless it was raised; unit, zenith
// frame. r: the camera's distance from the centre, km.
fn line_direction(line: Line, dir: vec3f, r: f32) -> vec3f {
    if line.r_mu == r * dir.z {
        return dir;
    }
    let sine = length(dir.xy);
    let azimuth = select(vec2f(1.0, 0.0), dir.xy / sine, sine > 1e-9);
    return vec3f(azimuth * (line.perigee / r), line.r_mu / r);
}

// Squared half of the chord (km^2) that a line from a camera at altitude h cuts from the top of the air.
// Not from the rounded radius of the top, in which a thin shell is lost; where r mu is small, from the
// height above the top.
fn top_half_chord2(line: Line, h: f32, radius: f32, thickness: f32) -> f32 {
    let r_mu2 = line.r_mu * line.r_mu;
    let top_excess = excess_of(thickness, radius);
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    return select(top_excess - line.perigee_excess, r_mu2 - above, r_mu2 < top_excess);
}

// What of a ray lies in the air, without the sun: see the fields of `AirRay`.
struct AirPath {
    start: f32,
    length: f32,
    excess: f32,
    r_mu: f32,
}

// Distance (km) to the ground for r mu < 0: t = -b - sqrt(b^2 - x) = x / (root - b), Bruneton 2017,
// DistanceToBottomAtmosphereBoundary. root: half of the chord that the planet cuts from the line. Never
// past the perigee: where a ray along the sun's direction touches the ground, the planet's shadow ends, and
// a division that rounds up would let light in behind it.
fn distance_to_ground(excess: f32, r_mu: f32, root: f32) -> f32 {
    return min(excess / (root - r_mu), -r_mu);
}

// The path through the air of a line from a camera at altitude h.
fn air_path(line: Line, h: f32, radius: f32, thickness: f32) -> AirPath {
    let top_excess = excess_of(thickness, radius);
    let ground_root = sqrt(max(-line.perigee_excess, 0.0));
    if h <= thickness {
        let excess = excess_of(h, radius);
        let to_top = distance_to_top(excess, line.r_mu, top_excess);
        let to_ground = distance_to_ground(excess, line.r_mu, ground_root);
        return AirPath(0.0, select(to_top, to_ground, line.ground), excess, line.r_mu);
    }
    // From outside: the ray is moved to where it enters.
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    let top2 = top_half_chord2(line, h, radius, thickness);
    if line.r_mu >= 0.0 || top2 <= 0.0 {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    let half = sqrt(top2);
    // Entry distance as c / q: (h - H)(r + T) / (-r mu + half).
    let reach = select(2.0 * half, distance_to_ground(top_excess, -half, ground_root), line.ground);
    return AirPath(above / (half - line.r_mu), reach, top_excess, -half);
}

// The part of a ray inside the air. dir, sun: unit, zenith frame; h: the camera's altitude, km, >= 0.
fn air_ray(dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f) -> AirRay {
    return air_ray_of(line_past(dir, h, radius), dir, h, radius, thickness, sun);
}

// The same for a line that is known.
fn air_ray_of(line: Line, dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f) -> AirRay {
    let path = air_path(line, h, radius, thickness);
    var s: SunSide;
    if h <= thickness {
        s = sun_side_inside(dir, sun, radius + h, path.excess, radius);
    } else if path.length > 0.0 {
        s = sun_side_outside(dir, sun, radius + h, path.start, -path.r_mu, path.excess, radius);
    } else {
        s.nu = dot(dir, sun);
    }
    let ground = line.ground && path.length >= 0.0;
    return AirRay(
        path.start, path.length, path.excess, path.r_mu, line.perigee_excess,
        s.sun_r_mu, s.nu, s.sin2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
}

// A ray from inside the air of which it is known whether it ends on the ground, whatever rounding says: for
// texels of a LUT, whose rows are all of one kind. Otherwise as `air_ray`.
fn inner_ray(dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f, ground: bool) -> AirRay {
    let r = radius + h;
    let excess = excess_of(h, radius);
    let r_mu = r * dir.z;
    let p = r * sqrt(dot(dir.xy, dir.xy));
    let ground2 = half_chord2(r_mu, excess, radius - p, p);
    let s = sun_side_inside(dir, sun, r, excess, radius);
    let to_top = distance_to_top(excess, r_mu, excess_of(thickness, radius));
    let to_ground = distance_to_ground(excess, r_mu, sqrt(max(ground2, 0.0)));
    let reach = select(to_top, to_ground, ground && r_mu < 0.0);
    return AirRay(
        0.0, reach, excess, r_mu, -ground2,
        s.sun_r_mu, s.nu, s.sin2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
}

// The perigee of a ray's first `length` km, from which altitudes along it are told: that is where the air
// is dense, and from a far away entry its altitude would be a small difference of large numbers.
struct Perigee {
    distance: f32, // from the entry, km
    excess: f32,   // km^2
    r_mu: f32,     // km, 0 at the closest approach of the whole line
}

fn perigee_of(ray: AirRay, length: f32, radius: f32) -> Perigee {
    let to_ground = ray.ground && length >= ray.length;
    return lowest_point(ray.excess, ray.r_mu, ray.perigee_excess, to_ground, length, radius);
}

// The same by the numbers of its entry and of its line. to_ground: it ends on the ground.
fn lowest_point(
    excess: f32, r_mu: f32, perigee_excess: f32, to_ground: bool, length: f32, radius: f32,
) -> Perigee {
    if r_mu >= 0.0 {
        return Perigee(0.0, excess, r_mu);
    }
    if -r_mu <= length {
        return Perigee(-r_mu, perigee_excess, 0.0);
    }
    let end = r_mu + length;
    if to_ground {
        return Perigee(length, 0.0, end);
    }
    // x + 2 b t + t^2, or from the whole line's perigee where that sum is of large terms.
    let far = -r_mu * length > radius * radius;
    let near_excess = excess + length * (2.0 * r_mu + length);
    return Perigee(length, select(near_excess, perigee_excess + end * end, far), end);
}

// Whether a camera ray meets the planet's surface.
fn hits_planet(dir: vec3f, h: f32, radius: f32) -> bool {
    return line_past(dir, h, radius).ground;
}

// The stretch of a ray that lies in the planet's shadow: begin and end (km) from the entry; begin > end
// where there is none. The shadow is the half cylinder behind the planet (Nishita et al. 1993, section 3.2;
// the penumbra is left out): a t^2 + 2 b t + c < 0 across the sun's direction, and behind the planet along
// it.
fn shadow_stretch(ray: AirRay) -> vec2f {
    let none = vec2f(1.0, 0.0);
    let far = 1e30;
    let a = ray.sin2;
    let b = ray.shadow_b;
    let c = ray.shadow_c;
    var stretch = vec2f(-far, far);
    if a > 1e-30 {
        if ray.shadow_half2 <= 0.0 {
            return none;
        }
        // The quadratic's two roots, q / a and c / q, with the sign that does not cancel in q.
        let q = -(b + select(-1.0, 1.0, b >= 0.0) * sqrt(a * ray.shadow_half2));
        let t0 = q / a;
        let t1 = select(t0, c / q, q != 0.0);
        stretch = vec2f(min(t0, t1), max(t0, t1));
    } else if c >= 0.0 {
        return none;
    }
    // Behind the planet: sun_r_mu + nu t < 0.
    if abs(ray.nu) < 1e-12 {
        if ray.sun_r_mu >= 0.0 {
            return none;
        }
    } else {
        let t = -ray.sun_r_mu / ray.nu;
        if ray.nu > 0.0 {
            stretch.y = min(stretch.y, t);
        } else {
            stretch.x = max(stretch.x, t);
        }
    }
    return stretch;
}
