//! Where a line meets a sphere, in f64.
//!
//! The smaller root of the quadratic is the difference of two nearly equal numbers, and `|o|² - R²` loses
//! everything about a small altitude above a large radius. Here the discriminant is `(R - p)(R + p)` with the
//! impact parameter `p`, and the nearer root is `c / q` (Press et al., Numerical Recipes, section 5.6).

use glam::{DVec3, Vec3};

/// Where a line meets a sphere: the two values of `t` with `|origin + t dir - center| = radius`,
/// ascending, in lengths of `dir` (metres if `dir` has length 1). Negative values lie behind the origin.
///
/// `None` if the line misses, if `dir` has no length or if any input is not finite.
/// A line that touches within rounding gives two equal values or `None`.
pub fn ray_sphere_intersect(origin: DVec3, dir: DVec3, center: DVec3, radius: f64) -> Option<(f64, f64)> {
    let from_center = origin - center;
    let scale = dir.abs().max_element();
    if !from_center.is_finite() || !dir.is_finite() || !radius.is_finite() || scale <= 0.0 || radius < 0.0 {
        return None;
    }
    let length = scale * (dir / scale).length();
    let unit = dir / length;
    let to_perigee = -from_center.dot(unit);
    let impact = (from_center + unit * to_perigee).length();
    if impact > radius {
        return None;
    }
    let half_chord = ((radius - impact) * (radius + impact)).sqrt();
    let distance = from_center.length();
    // t1 t2 = c; the root of larger magnitude has no cancellation.
    let c = (distance - radius) * (distance + radius);
    let large = if to_perigee >= 0.0 { to_perigee + half_chord } else { to_perigee - half_chord };
    let small = if large == 0.0 { 0.0 } else { c / large };
    Some((small.min(large) / length, small.max(large) / length))
}

/// [`ray_sphere_intersect`] for f32 callers, `(-1, -1)` on a miss; computed inside in f64.
///
/// The digits that f32 inputs do not have stay missing: at an Earth radius from the centre an f32
/// position is good to 0.5 m.
pub fn ray_sphere_intersect_f32(origin: Vec3, dir: Vec3, center: Vec3, radius: f32) -> (f32, f32) {
    match ray_sphere_intersect(origin.as_dvec3(), dir.as_dvec3(), center.as_dvec3(), f64::from(radius)) {
        Some((near, far)) => (near as f32, far as f32),
        None => (-1.0, -1.0),
    }
}
