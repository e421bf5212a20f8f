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
    sun_b: f32,    // r times the cosine of the sun's zenith angle at the entry
    nu: f32,       // cosine of the angle between ray and sun
    cross2: f32,   // squared sine of that angle
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

// The part of a ray inside the air. dir: unit, zenith frame; h: camera's altitude >= 0; sun: unit.
fn air_ray(dir: vec3f, h: f32, radius: f32, thickness: f32, sun: vec3f) -> AirRay {
    var ray: AirRay;
    let r = radius + h;
    let side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2 = dot(side, side);
    ray.ground = false;
    let x_top = excess_of(thickness, radius);
    if h <= thickness {
        ray.start = 0.0;
        ray.x = excess_of(h, radius);
        ray.b = r * dir.z;
        ray.sun_b = r * sun.z;
        ray.length = distance_to_top(ray.x, ray.b, x_top);
        let disc = ray.b * ray.b - ray.x;
        if ray.b < 0.0 && disc >= 0.0 {
            ray.ground = true;
            ray.length = ray.x / (sqrt(disc) - ray.b);
        }
        return ray;
    }
    // From outside: everything follows from the closest approach p, which the horizontal part of dir
    // gives without a difference of large numbers.
    let horizontal2 = dot(dir.xy, dir.xy);
    let p = r * sqrt(horizontal2);
    let top = radius + thickness;
    let top_disc = (top - p) * (top + p);
    if dir.z >= 0.0 || top_disc <= 0.0 {
        ray.length = -1.0;
        return ray;
    }
    let half = sqrt(top_disc);
    // Entry distance as c / q: (h - H)(r + T) / (-r mu + half).
    ray.start = (h - thickness) * (r + top) / (half - r * dir.z);
    ray.x = x_top;
    ray.b = -half;
    // Point of closest approach, r (z - mu dir), has the parts below; the entry is `half` before it.
    let closest = vec3f(-dir.z * dir.xy, horizontal2) * r;
    ray.sun_b = dot(closest, sun) - half * ray.nu;
    ray.length = 2.0 * half;
    let ground_disc = (radius - p) * (radius + p);
    if ground_disc >= 0.0 {
        ray.ground = true;
        ray.length = x_top / (half + sqrt(ground_disc));
    }
    return ray;
}

// Whether a camera ray meets the planet's surface. Same decision as air_ray, cheaper.
fn hits_planet(dir: vec3f, h: f32, radius: f32, thickness: f32) -> bool {
    let r = radius + h;
    if dir.z >= 0.0 {
        return false;
    }
    if h <= thickness {
        let b = r * dir.z;
        return b * b - excess_of(h, radius) >= 0.0;
    }
    return radius - r * length(dir.xy) >= 0.0;
}

// The stretch of a ray that lies in the planet's shadow (a half cylinder behind it): begin and end
// distance from the entry; begin > end where there is none.
fn shadow_stretch(ray: AirRay) -> vec2f {
    let none = vec2f(1.0, 0.0);
    let far = 1e30;
    // (r^2 - R^2) - (r cos(sun))^2 < 0 along the ray, a quadratic a t^2 + 2 b t + c < 0 ...
    let a = ray.cross2;
    let b = ray.b - ray.sun_b * ray.nu;
    let c = ray.x - ray.sun_b * ray.sun_b;
    var stretch = vec2f(-far, far);
    let disc = b * b - a * c;
    if a > 1e-12 {
        if disc <= 0.0 {
            return none;
        }
        let q = -(b + select(-1.0, 1.0, b >= 0.0) * sqrt(disc));
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
