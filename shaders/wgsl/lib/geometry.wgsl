// Rays through a spherical shell, in forms that keep their digits in f32. Lengths in km.
//
// Glossary: R planet radius, r distance from the centre, h = r - R altitude, mu cosine of the zenith
// angle of a direction, p distance of closest approach to the centre. No function subtracts two radii:
// a position is carried as x = r^2 - R^2 = h (2R + h), which is small near the surface.

// Altitude of a point with r^2 - R^2 = x.
fn altitude_of(x: f32, radius: f32) -> f32 {
    return x / (radius + sqrt(max(radius * radius + x, 0.0)));
}

// r^2 - R^2 of a point at altitude h.
fn excess_of(h: f32, radius: f32) -> f32 {
    return h * (2.0 * radius + h);
}

// Altitude, never negative, a distance t along a ray from r^2 - R^2 = x with r mu = b.
fn altitude_after(x: f32, b: f32, t: f32, radius: f32) -> f32 {
    return max(altitude_of(x + t * (2.0 * b + t), radius), 0.0);
}

// A view ray inside the atmosphere, from where it enters (or the camera) to where it ends.
struct AirRay {
    start: f32,    // distance from the camera to the entry, 0 inside
    length: f32,   // distance from the entry to the ground or the top; negative if the ray misses the air
    x: f32,        // r^2 - R^2 at the entry
    b: f32,        // r mu at the entry
    x_closest: f32, // r^2 - R^2 at the closest approach of the whole line, negative if that is underground
    sun_b: f32,    // r times the cosine of the sun's zenith angle at the entry
    nu: f32,       // cosine of the angle between ray and sun
    cross2: f32,   // squared sine of that angle
    shadow_b: f32, // at the entry: position times direction, both without their parts along the sun
    shadow_c: f32, // squared distance of the entry from the planet's axis towards the sun, less R^2
    shadow_half2: f32, // squared half of the chord that the planet's shadow cuts from the ray's part across the sun's direction
    ground: bool,  // the ray ends on the ground
}

// Distance from r^2 - R^2 = x with r mu = b to the top, r^2 - R^2 = x_top >= x. Leaves the shell once.
fn distance_to_top(x: f32, b: f32, x_top: f32) -> f32 {
    let c = max(x_top - x, 0.0);
    let root = sqrt(b * b + c);
    // The sum that does not cancel; c / (b + root) is the quadratic's other root.
    if b > 0.0 {
        return c / (b + root);
    }
    return root - b;
}

// Squared half of the chord that a line cuts from a sphere; negative if it passes by. b: r mu, above:
// r^2 - sphere^2, depth: sphere - p with p the closest approach to the centre. b^2 - above keeps its digits
// near the sphere, where p is next to r; the product keeps them far away, where b^2 and above are large and
// nearly equal.
fn half_chord2(b: f32, above: f32, depth: f32, p: f32) -> f32 {
    let sphere = depth + p;
    if abs(b) < sphere {
        return b * b - above;
    }
    return depth * (sphere + p);
}

// What a ray has to do with the sun: see the fields of `AirRay`.
struct SunSide {
    sun_b: f32,
    nu: f32,
    cross2: f32,
    shadow_b: f32,
    shadow_c: f32,
    shadow_half2: f32,
}

// The shadow's cylinder across the sun's direction is a circle, and the ray's part there a line that passes its
// centre at a distance that is a product: the component of dir x sun along r, over its length.
fn shadow_half2(s: SunSide, side_z: f32, r: f32, radius: f32) -> f32 {
    let sine = max(sqrt(s.cross2), 1e-18);
    let p = r * abs(side_z) / sine;
    return half_chord2(s.shadow_b / sine, s.shadow_c, radius - p, p);
}

// From a camera in the air at r = R + h, r^2 - R^2 = x.
fn sun_side_inside(dir: vec3f, sun: vec3f, r: f32, x: f32, radius: f32) -> SunSide {
    var s: SunSide;
    s.nu = dot(dir, sun);
    // Near the sun and opposite to it, products of both lose the digits that their difference keeps.
    let side = cross(dir - select(-1.0, 1.0, s.nu >= 0.0) * sun, sun); // dir x sun
    s.cross2 = dot(side, side);
    s.sun_b = r * sun.z;
    // (position x sun) . (direction x sun)
    s.shadow_b = r * (sun.x * side.y - sun.y * side.x);
    let q = r * length(sun.xy);
    s.shadow_c = -half_chord2(s.sun_b, x, radius - q, q);
    s.shadow_half2 = shadow_half2(s, side.z, r, radius);
    return s;
}

// From the entry, `start` after the camera at distance r and `half` before the ray's closest approach.
fn sun_side_outside(dir: vec3f, sun: vec3f, r: f32, start: f32, half: f32, x_top: f32, radius: f32) -> SunSide {
    var s: SunSide;
    s.nu = dot(dir, sun);
    let same = select(-1.0, 1.0, s.nu >= 0.0);
    let apart = dir - same * sun;
    let side = cross(apart, sun); // dir x sun
    s.cross2 = dot(side, side);
    // Point of closest approach, r (z - mu dir), has the parts below; the entry is `half` before it.
    let closest = vec3f(-dir.z * dir.xy, dot(dir.xy, dir.xy)) * r;
    // closest . dir = 0, so closest . sun = closest . (sun - same dir). From there or from the camera: the smaller terms.
    let there = -same * dot(closest, apart);
    let here = r * sun.z;
    let nearer = abs(here) + start * abs(s.nu) < abs(there) + half * abs(s.nu);
    s.sun_b = select(there - half * s.nu, here + start * s.nu, nearer);
    let closest_side = cross(closest, sun);
    s.shadow_b = dot(closest_side, side) - half * s.cross2;
    let q = length(closest_side - half * side);
    s.shadow_c = -half_chord2(s.sun_b, x_top, radius - q, q);
    s.shadow_half2 = shadow_half2(s, side.z, r, radius);
    return s;
}

// A camera ray as a line past the planet.
struct Line {
    b: f32,          // r mu
    p: f32,          // distance of closest approach to the centre
    x_closest: f32,  // r^2 - R^2 there, negative if that is underground
    ground: bool,    // meets the planet's surface
}

// dir: unit, zenith frame; h: camera's altitude >= 0.
fn line_past(dir: vec3f, h: f32, radius: f32) -> Line {
    let r = radius + h;
    let b = r * dir.z;
    let p = r * sqrt(dot(dir.xy, dir.xy));
    let ground2 = half_chord2(b, excess_of(h, radius), radius - p, p);
    return Line(b, p, -ground2, b < 0.0 && ground2 >= 0.0);
}

// Squared half of the chord that a line from a camera at altitude h cuts from the top of the air. Not from the rounded
// radius of the top, in which a thin shell is lost. Where b is small, from the height above it.
fn top_half_chord2(line: Line, h: f32, radius: f32, thickness: f32) -> f32 {
    let b2 = line.b * line.b;
    let x_top = excess_of(thickness, radius);
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    return select(x_top - line.x_closest, b2 - above, b2 < x_top);
}

// What of a ray lies in the air, without the sun: see the fields of `AirRay`.
struct AirPath {
    start: f32,
    length: f32,
    x: f32,
    b: f32,
}

// Distance to the ground from r^2 - R^2 = x with r mu = b < 0; root: half of the chord that the planet cuts from the line.
// Never past the closest approach: where a ray along the sun's direction touches the ground, the planet's shadow ends,
// and a division that rounds up would let light in behind it.
fn to_ground(x: f32, b: f32, root: f32) -> f32 {
    return min(x / (root - b), -b);
}

fn air_path(line: Line, h: f32, radius: f32, thickness: f32) -> AirPath {
    let x_top = excess_of(thickness, radius);
    let ground_root = sqrt(max(-line.x_closest, 0.0));
    if h <= thickness {
        let x = excess_of(h, radius);
        let reach = select(distance_to_top(x, line.b, x_top), to_ground(x, line.b, ground_root), line.ground);
        return AirPath(0.0, reach, x, line.b);
    }
    // From outside: the ray is moved to where it enters.
    let above = (h - thickness) * (2.0 * radius + thickness + h);
    let top2 = top_half_chord2(line, h, radius, thickness);
    if line.b >= 0.0 || top2 <= 0.0 {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    let half = sqrt(top2);
    // Entry distance as c / q: (h - H)(r + T) / (-r mu + half).
    return AirPath(above / (half - line.b), select(2.0 * half, to_ground(x_top, -half, ground_root), line.ground), x_top, -half);
}

// The part of a ray inside the air. dir: unit, zenith frame; h: camera's altitude >= 0; sun: unit.
fn air_ray(dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f) -> AirRay {
    let line = line_past(dir, h, radius);
    let path = air_path(line, h, radius, thickness);
    var s: SunSide;
    if h <= thickness {
        s = sun_side_inside(dir, sun, radius + h, path.x, radius);
    } else if path.length > 0.0 {
        s = sun_side_outside(dir, sun, radius + h, path.start, -path.b, path.x, radius);
    } else {
        s.nu = dot(dir, sun);
    }
    let ground = line.ground && path.length >= 0.0;
    return AirRay(
        path.start, path.length, path.x, path.b, line.x_closest,
        s.sun_b, s.nu, s.cross2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
}

// The lowest point of a ray's first `length` km, from which altitudes along it are told: that is where the
// air is dense, and from a far away entry its altitude would be a small difference of large numbers.
struct Low {
    t: f32,  // distance from the entry
    x: f32,  // r^2 - R^2
    b: f32,  // r mu, 0 at the closest approach
}

fn lowest(ray: AirRay, length: f32, radius: f32) -> Low {
    if ray.b >= 0.0 {
        return Low(0.0, ray.x, ray.b);
    }
    if -ray.b <= length {
        return Low(-ray.b, ray.x_closest, 0.0);
    }
    let b = ray.b + length;
    if ray.ground && length >= ray.length {
        return Low(length, 0.0, b);
    }
    let far = -ray.b * length > radius * radius;
    return Low(length, select(ray.x + length * (2.0 * ray.b + length), ray.x_closest + b * b, far), b);
}

// Whether a camera ray meets the planet's surface.
fn hits_planet(dir: vec3f, h: f32, radius: f32) -> bool {
    return line_past(dir, h, radius).ground;
}

// The stretch of a ray that lies in the planet's shadow (a half cylinder behind it): begin and end
// distance from the entry; begin > end where there is none.
fn shadow_stretch(ray: AirRay) -> vec2f {
    let none = vec2f(1.0, 0.0);
    let far = 1e30;
    // (r^2 - R^2) - (r cos(sun))^2 < 0 along the ray, a quadratic a t^2 + 2 b t + c < 0 ...
    let a = ray.cross2;
    let b = ray.shadow_b;
    let c = ray.shadow_c;
    var stretch = vec2f(-far, far);
    if a > 1e-30 {
        if ray.shadow_half2 <= 0.0 {
            return none;
        }
        let q = -(b + select(-1.0, 1.0, b >= 0.0) * sqrt(a * ray.shadow_half2));
        let t0 = q / a;
        let t1 = select(t0, c / q, q != 0.0);
        stretch = vec2f(min(t0, t1), max(t0, t1));
    } else if c >= 0.0 {
        return none;
    }
    // ... and behind the planet: sun_b + nu t < 0.
    if abs(ray.nu) < 1e-12 {
        if ray.sun_b >= 0.0 {
            return none;
        }
    } else {
        let t = -ray.sun_b / ray.nu;
        if ray.nu > 0.0 {
            stretch.y = min(stretch.y, t);
        } else {
            stretch.x = max(stretch.x, t);
        }
    }
    return stretch;
}

// A ray from inside the air of which it is known whether it ends on the ground, whatever rounding says.
fn inner_ray(dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f, ground: bool) -> AirRay {
    let r = radius + h;
    let x = excess_of(h, radius);
    let b = r * dir.z;
    let p = r * sqrt(dot(dir.xy, dir.xy));
    let ground2 = half_chord2(b, x, radius - p, p);
    let s = sun_side_inside(dir, sun, r, x, radius);
    let ground_root = sqrt(max(ground2, 0.0));
    let reach = select(distance_to_top(x, b, excess_of(thickness, radius)), to_ground(x, b, ground_root), ground && b < 0.0);
    return AirRay(0.0, reach, x, b, -ground2, s.sun_b, s.nu, s.cross2, s.shadow_b, s.shadow_c, s.shadow_half2, ground);
}
