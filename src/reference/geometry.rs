//! Rays and concentric spheres in f64, in forms that keep their digits.
//!
//! Two things go wrong when this is written down from a textbook: the smaller root of the quadratic is
//! the difference of two nearly equal numbers, and `|o|² - R²` loses everything about a small altitude
//! above a large radius. Here the discriminant is `(R - p)(R + p)` with the impact parameter `p`, the
//! nearer root is `c / q` (Press et al., Numerical Recipes, section 5.6), and a ray through the air is a
//! [`Chord`]: measured from its perigee, in altitudes and not in radii.

use glam::DVec3;

pub use crate::model::rays::{ray_sphere_intersect, ray_sphere_intersect_f32};

/// What ends a ray's way through the air.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayEnd {
    /// It leaves through the top of the atmosphere, or never enters.
    Space,
    /// The planet's surface.
    Ground,
    /// A thing in the scene (terrain, a ship) in front of both.
    Object,
}

/// The part of a ray that runs through the air; metres from the ray's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Where it begins, ≥ 0: the origin, or the entry through the top.
    pub start: f64,
    /// Where it ends, ≥ `start`.
    pub end: f64,
    /// What ends it.
    pub ends_at: RayEnd,
}

/// The part of a ray between the camera and whatever comes first: the way out of the atmosphere, the
/// ground, or a scene object `object_distance` metres away. `None` if no air lies in between: the ray
/// misses the shell, leaves it behind, or meets the object before it enters.
///
/// `dir` needs no particular length; distances are metres. An origin below the surface counts as lying
/// on it: looking down, the segment is empty and ends at the ground.
/// Inputs that are not finite give `None`; an infinite `object_distance` means none.
///
/// ```
/// use glam::DVec3;
/// use welkin::reference::geometry::{RayEnd, clip_segment};
/// let planet = DVec3::new(0.0, -6_360_000.0, 0.0);
/// let down = clip_segment(DVec3::Y * 1000.0, -DVec3::Y, planet, 6_360e3, 6_460e3, f64::INFINITY).unwrap();
/// assert_eq!(down.ends_at, RayEnd::Ground);
/// assert!((down.end - 1000.0).abs() < 1e-6);
/// ```
pub fn clip_segment(
    origin: DVec3,
    dir: DVec3,
    center: DVec3,
    planet_radius: f64,
    atmosphere_radius: f64,
    object_distance: f64,
) -> Option<Segment> {
    if object_distance.is_nan() || object_distance < 0.0 {
        return None;
    }
    let dir = (dir / dir.abs().max_element()).normalize();
    let (enter, leave) = ray_sphere_intersect(origin, dir, center, atmosphere_radius)?;
    if leave <= 0.0 {
        return None;
    }
    let start = enter.max(0.0);
    let mut segment = Segment { start, end: leave, ends_at: RayEnd::Space };
    let from_center = origin - center;
    if from_center.length() <= planet_radius {
        if from_center.dot(dir) < 0.0 {
            segment = Segment { start: 0.0, end: 0.0, ends_at: RayEnd::Ground };
        }
    } else if let Some((near, _)) = ray_sphere_intersect(origin, dir, center, planet_radius)
        && near >= 0.0
    {
        segment = Segment { start, end: near.max(start), ends_at: RayEnd::Ground };
    }
    if object_distance < start {
        return None;
    }
    if object_distance < segment.end {
        segment = Segment { start, end: object_distance, ends_at: RayEnd::Object };
    }
    Some(segment)
}

/// A straight line past a sphere, measured from its perigee (the point nearest to the centre).
///
/// With perigee radius `p`, perigee altitude `a = p - R` and distance `s` from the perigee, the altitude
/// is `a + s² / (r + p)`, `r² = p² + s²`: no difference of radii, whatever the planet's size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    planet_radius: f64,
    /// Altitude of the perigee above the sphere, metres; negative if the line pierces the sphere.
    pub perigee_altitude: f64,
    /// Distance of the perigee from the centre, metres.
    pub perigee_radius: f64,
    /// Where the ray's origin lies on the line: metres from the perigee, negative before it.
    pub origin: f64,
}

impl Chord {
    /// The line from a point `altitude` metres above a sphere of `planet_radius` metres whose direction
    /// has the cosine `mu` and the sine `sin ≥ 0` to the zenith there. Giving both keeps the digits
    /// that either loses: the sine near the zenith, the cosine near the horizon.
    pub fn new(planet_radius: f64, altitude: f64, mu: f64, sin: f64) -> Self {
        let r = planet_radius + altitude;
        let perigee_radius = r * sin;
        // 1 - sin = mu² / (1 + sin), used where sin is near 1.
        let perigee_altitude =
            if mu * mu < 0.5 { altitude - r * mu * mu / (1.0 + sin) } else { perigee_radius - planet_radius };
        Self { planet_radius, perigee_altitude, perigee_radius, origin: r * mu }
    }

    /// Distance from the planet's centre, metres, `s` metres after the perigee.
    pub fn radius(&self, s: f64) -> f64 {
        self.perigee_radius.hypot(s)
    }

    /// Altitude, metres, `s` metres after the perigee.
    pub fn altitude(&self, s: f64) -> f64 {
        let sum = self.radius(s) + self.perigee_radius;
        if sum > 0.0 { self.perigee_altitude + s * (s / sum) } else { self.perigee_altitude }
    }

    /// Distance `s ≥ 0` from the perigee at which the line is at an altitude; `None` if it never is.
    pub fn at_altitude(&self, altitude: f64) -> Option<f64> {
        let above = altitude - self.perigee_altitude;
        let sum = 2.0 * self.planet_radius + altitude + self.perigee_altitude;
        (above >= 0.0 && sum >= 0.0).then(|| (above * sum).sqrt())
    }

    /// The part of the ray inside a shell up to altitude `top`, cut by the ground and at `length` metres
    /// from the origin; as distances from the perigee. `None` if the ray has no part in the shell.
    ///
    /// An object behind the ground, no farther away than air can be, stands in a trench: the ray goes on to
    /// it below the ground.
    pub fn clip(&self, top: f64, length: f64) -> Option<(f64, f64, RayEnd)> {
        let s_top = self.at_altitude(top)?;
        let start = self.origin.max(-s_top);
        if start > s_top || length.is_nan() {
            return None;
        }
        let (mut end, mut kind) = (s_top, RayEnd::Space);
        if self.perigee_altitude < 0.0 && self.origin < 0.0 {
            let half = self.at_altitude(0.0)?;
            let horizon = |s: f64| ((s - half) * (s + half)).max(0.0).sqrt();
            let farthest = horizon(self.origin.abs()) + horizon(s_top);
            if !(self.origin + length > -half && length <= farthest) {
                (end, kind) = (-half, RayEnd::Ground);
            }
        }
        let object = self.origin + length;
        if object < end {
            if object < start {
                return None;
            }
            (end, kind) = (object, RayEnd::Object);
        }
        Some((start, end.max(start), kind))
    }

    /// `v` with `v² = altitude - perigee altitude`, signed like `s`. An exponential density is a Gaussian in
    /// it.
    pub(crate) fn v_at(self, s: f64) -> f64 {
        let sum = self.radius(s) + self.perigee_radius;
        if sum > 0.0 { s / sum.sqrt() } else { 0.0 }
    }

    /// `s` and `ds/dv` at `v`.
    pub(crate) fn at_v(self, v: f64) -> (f64, f64) {
        let sum = 2.0 * self.perigee_radius + v * v;
        if sum <= 0.0 {
            return (0.0, 0.0);
        }
        let root = sum.sqrt();
        (v * root, 2.0 * (self.perigee_radius + v * v) / root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    const R: f64 = 6_360_000.0;

    #[test]
    fn sphere_hits_are_stable_from_far_and_from_the_surface() {
        // Head-on from the Moon's distance: the naive root loses kilometres in f32 and micrometres in f64.
        let far = DVec3::new(3.844e8, 0.0, 0.0);
        let (near, exit) = ray_sphere_intersect(far, -DVec3::X, DVec3::ZERO, R).unwrap();
        assert!((near - (3.844e8 - R)).abs() < 1e-7 && (exit - (3.844e8 + R)).abs() < 1e-6);
        let (near, exit) = ray_sphere_intersect_f32(Vec3::X * 3.844e8, -Vec3::X, Vec3::ZERO, R as f32);
        assert_eq!((near, exit), ((3.844e8 - R) as f32, (3.844e8 + R) as f32));
        // 1 mm above the surface, looking down at 30°: about 2 mm to the ground.
        let low = DVec3::new(0.0, R + 1e-3, 0.0);
        let dir = DVec3::new(0.75f64.sqrt(), -0.5, 0.0);
        let (near, _) = ray_sphere_intersect(low, dir, DVec3::ZERO, R).unwrap();
        assert!((near - 2e-3).abs() < 1e-8, "{near}");
        // A direction of any length: t counts in its lengths.
        let (near, _) = ray_sphere_intersect(far, -DVec3::X * 4.0, DVec3::ZERO, R).unwrap();
        assert!((near - (3.844e8 - R) / 4.0).abs() < 1e-7);
        // Behind the origin.
        let (near, exit) = ray_sphere_intersect(far, DVec3::X, DVec3::ZERO, R).unwrap();
        assert!(near < exit && exit < 0.0);
    }

    #[test]
    fn misses_and_nonsense_are_answered() {
        assert_eq!(ray_sphere_intersect_f32(Vec3::Y * 2.0, Vec3::X, Vec3::ZERO, 1.0), (-1.0, -1.0));
        assert_eq!(ray_sphere_intersect(DVec3::Y, DVec3::ZERO, DVec3::ZERO, 1.0), None);
        assert_eq!(ray_sphere_intersect(DVec3::Y, DVec3::X, DVec3::ZERO, f64::NAN), None);
        assert_eq!(ray_sphere_intersect(DVec3::NAN, DVec3::X, DVec3::ZERO, 1.0), None);
        assert_eq!(ray_sphere_intersect(DVec3::Y, DVec3::X, DVec3::ZERO, -1.0), None);
        assert_eq!(clip_segment(DVec3::Y, DVec3::ZERO, DVec3::ZERO, 1.0, 2.0, 1.0), None);
        assert_eq!(clip_segment(DVec3::Y, DVec3::X, DVec3::ZERO, 1.0, 2.0, f64::NAN), None);
        // Exactly tangent: hit with two equal roots, never NaN.
        let (a, b) = ray_sphere_intersect(DVec3::new(-3.0, 1.0, 0.0), DVec3::X, DVec3::ZERO, 1.0).unwrap();
        assert!((a - 3.0).abs() < 1e-15 * 4.0 && (b - 3.0).abs() < 1e-15 * 4.0, "{a} {b}");
    }

    #[test]
    fn segments_end_where_they_should_for_any_planet_centre() {
        let top = R + 100_000.0;
        for center in [DVec3::ZERO, DVec3::new(1e9, -2e9, 5e8)] {
            let clip = |o: DVec3, d: DVec3, object| clip_segment(center + o, d, center, R, top, object);
            let surface = DVec3::Y * (R + 2.0);
            // Out to space from the ground, straight up.
            let up = clip(surface, DVec3::Y, f64::INFINITY).unwrap();
            assert_eq!((up.start, up.ends_at), (0.0, RayEnd::Space));
            assert!((up.end - 99_998.0).abs() < 1e-5, "{up:?}");
            // Down to the ground.
            let down = clip(surface, -DVec3::Y * 3.0, f64::INFINITY).unwrap();
            assert_eq!(down.ends_at, RayEnd::Ground);
            assert!((down.end - 2.0).abs() < 1e-5, "{down:?}");
            // An object in front of the ground, and one behind it.
            let high = DVec3::Y * (R + 50_000.0);
            assert_eq!(
                clip(high, -DVec3::Y, 10_000.0).unwrap(),
                Segment { start: 0.0, end: 10_000.0, ends_at: RayEnd::Object }
            );
            assert_eq!(clip(high, -DVec3::Y, 60_000.0).unwrap().ends_at, RayEnd::Ground);
            // From orbit: a miss, a graze of the shell, a hit, and an object before the shell.
            let orbit = DVec3::Y * (top + 400_000.0);
            assert_eq!(clip(orbit, DVec3::X, f64::INFINITY), None);
            assert_eq!(clip(orbit, DVec3::Y, f64::INFINITY), None);
            let aim = |altitude: f64| {
                let sin = (R + altitude) / orbit.y;
                DVec3::new(sin, -(1.0 - sin * sin).sqrt(), 0.0)
            };
            assert_eq!(clip(orbit, aim(100_001.0), f64::INFINITY), None);
            let limb = clip(orbit, aim(20_000.0), f64::INFINITY).unwrap();
            assert_eq!(limb.ends_at, RayEnd::Space);
            let chord = 2.0 * (80_000.0 * (2.0 * R + 120_000.0)).sqrt();
            assert!((limb.end - limb.start - chord).abs() < 1e-3 * chord.sqrt(), "{limb:?}");
            assert_eq!(clip(orbit, aim(-1.0), f64::INFINITY).unwrap().ends_at, RayEnd::Ground);
            assert_eq!(clip(orbit, -DVec3::Y, 399_000.0), None);
            // Below the ground: up is free, down ends at once.
            let trench = DVec3::Y * (R - 11_000.0);
            assert_eq!(clip(trench, DVec3::Y, f64::INFINITY).unwrap().ends_at, RayEnd::Space);
            assert_eq!(
                clip(trench, -DVec3::Y, f64::INFINITY).unwrap(),
                Segment { start: 0.0, end: 0.0, ends_at: RayEnd::Ground }
            );
        }
    }

    #[test]
    fn chords_keep_their_altitudes() {
        // 1.7 m up, level: after 4.65 km the altitude is t²/2R + 1.7 m, to a nanometre.
        let level = Chord::new(R, 1.7, 0.0, 1.0);
        let t = 4650.0;
        let exact = 1.7 + t * t / (2.0 * (R + 1.7)) - t.powi(4) / (8.0 * (R + 1.7).powi(3));
        assert!((level.altitude(t) - exact).abs() < 1e-9);
        assert!((level.at_altitude(exact).unwrap() - t).abs() < 1e-6);
        for (altitude, angle) in [(0.0, 0.3f64), (1000.0, 1.57), (5e4, 2.0), (3.8e8, 3.1), (0.0, 0.0)] {
            let chord = Chord::new(R, altitude, angle.cos(), angle.sin());
            assert!(
                (chord.altitude(chord.origin) - altitude).abs() < 1e-8 + 1e-15 * altitude,
                "{altitude} {angle}"
            );
            for s in [-1e6, -12.0, 1e5] {
                assert!((chord.at_v(chord.v_at(s)).0 - s).abs() < 1e-9 * s.abs(), "{altitude} {angle} {s}");
            }
        }
    }
}
