//! The moon before the sun: which share of the sun's disk a point sees, in f64.
//!
//! Both disks are taken as plane ones, their angular radii and the angle between their centres as lengths. On
//! the sphere of directions that is off by the square of these angles, 1e-5 of the share for the Earth's sun
//! and moon. The sun is infinitely far, as everywhere in this crate: the shadow is exact at the camera, and
//! at a distance x from it it lies off by x times the ratio of the distances of moon and sun, 0.3 % of x for
//! the Earth.

use std::f64::consts::PI;

use glam::DVec3;

use crate::error::{Decimal, Result, in_range};
use crate::model::quadrature::gauss_32;
use crate::model::rays::ray_sphere_intersect;

/// Exponents of the sun's limb darkening at 680, 550 and 440 nm: `I(μ) = I(1) μ^α`, μ the cosine of the angle
/// to the photosphere's normal.
///
/// Hestroffer & Magnan 1998, "Wavelength dependency of the Solar limb darkening", A&A 333, 338–342, equation
/// 1 with u = 1 and the α of table 2 after Pierce & Slaughter at 679.1, 552.2 and 443.9 nm. Their fit over
/// wavelengths, α = −0.023 + 0.292 μm / λ from 416 to 1099 nm, gives 0.406, 0.508 and 0.641 here.
pub const LIMB_DARKENING: [f64; 3] = [0.397, 0.503, 0.652];

/// The moon's mean radius, metres: k = 0.2725076 (IAU 1982) times the Earth's equatorial radius of 6378.137
/// km.
pub const MOON_RADIUS: f64 = 0.272_507_6 * 6_378_137.0;

/// The moon's visual geometric albedo, all channels alike: NASA's Moon Fact Sheet.
pub const MOON_ALBEDO: f64 = 0.12;

/// Brightness of the sun's disk over its mean, for 680, 550 and 440 nm, at `r` sun radii from its middle (0
/// to 1; clamped).
pub fn limb_darkening(r: f64) -> [f64; 3] {
    let mu2 = ((1.0 - r) * (1.0 + r)).clamp(0.0, 1.0);
    // The mean of mu^a over the disk is 2 / (a + 2).
    LIMB_DARKENING.map(|a| (0.5 * a + 1.0) * mu2.powf(0.5 * a))
}

/// The mean of [`limb_darkening`] over a ring of radius `r` and half width `half`, sun radii.
#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
pub(crate) fn limb_darkening_of_ring(r: f64, half: f64) -> [f64; 3] {
    let (inner, outer) = ((r - half).clamp(0.0, 1.0), (r + half).clamp(0.0, 1.0));
    let area = (outer - inner) * (outer + inner);
    if area < 1e-6 {
        return limb_darkening(0.5 * (inner + outer));
    }
    let outside = |r: f64, a: f64| ((1.0 - r) * (1.0 + r)).powf(0.5 * a + 1.0);
    LIMB_DARKENING.map(|a| (outside(inner, a) - outside(outer, a)) / area)
}

/// A moon: a sphere that hides the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moon {
    /// Its centre in the scene's frame of reference, metres, |component| ≤ 1e15.
    pub position: DVec3,
    /// Metres, 1 to 1e13.
    pub radius: f64,
    /// Least share of sunlight that reaches a point, 0 to 1; 0 is what physics says.
    pub floor: f64,
    /// Light that the planet throws on the moon's side towards the camera, per sunlight there; 0 to 1, and 0
    /// to leave it out. The Earth's is some 1e-4 at new moon.
    pub earthshine: f64,
    /// Whether the share counts the sun's edge as darker than its middle ([`LIMB_DARKENING`]); otherwise all
    /// of the disk counts the same.
    pub limb_darkening: bool,
}

impl Moon {
    /// A moon with physical light: no floor, a sun with limb darkening; no earthshine. Metres.
    pub fn new(position: DVec3, radius: f64) -> Self {
        Self { position, radius, floor: 0.0, earthshine: 0.0, limb_darkening: true }
    }

    /// Checks the ranges, and that `camera` (same frame, metres) is outside of it.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with `moon.position`, `moon.radius`, `moon.floor` or `moon.earthshine`.
    pub fn validate(&self, camera: DVec3) -> Result<()> {
        for (axis, c) in ["x", "y", "z"].iter().zip(self.position.to_array()) {
            in_range(format_args!("moon.position.{axis}"), c, -1e15, 1e15, "m")?;
        }
        in_range("moon.radius", self.radius, 1.0, 1e13, "m")?;
        in_range("moon.floor", self.floor, 0.0, 1.0, "")?;
        in_range("moon.earthshine", self.earthshine, 0.0, 1.0, "")?;
        let distance = (self.position - camera).length();
        if distance <= self.radius {
            return Err(crate::Error::invalid(
                "moon.position",
                format_args!("{} m from the camera", Decimal(distance)),
                format_args!("more than moon.radius ({} m) from it", Decimal(self.radius)),
            ));
        }
        Ok(())
    }

    /// The two disks as seen from `point` (the moon's frame, metres). sun: unit; sun_radius: radians. `None`
    /// inside the moon.
    pub fn disks(&self, point: DVec3, sun: DVec3, sun_radius: f64) -> Option<Disks> {
        let to_moon = self.position - point;
        let distance = to_moon.length();
        (distance > self.radius).then(|| Disks {
            sun: sun_radius,
            moon: (self.radius / distance).asin(),
            apart: to_moon.cross(sun).length().atan2(to_moon.dot(sun)),
        })
    }

    /// Share of the sun's light that the moon lets pass to `point`, for each channel; at least
    /// [`Self::floor`]. Arguments as for [`Self::disks`].
    pub fn sunlight(&self, point: DVec3, sun: DVec3, sun_radius: f64) -> [f64; 3] {
        let share = match self.disks(point, sun, sun_radius) {
            Some(disks) if self.limb_darkening => disks.visible_limb_darkened(),
            Some(disks) => [disks.visible(); 3],
            None => [0.0; 3],
        };
        share.map(|v| v.max(self.floor))
    }

    /// Radiance of its disk per unit of the sun's irradiance, 1/sr, where a ray from `camera` meets it, and
    /// `None` where it does not. direction, sun: unit. After Lommel and Seeliger (see `pass/moon_disk.wgsl`),
    /// with [`MOON_ALBEDO`].
    pub fn radiance(&self, camera: DVec3, direction: DVec3, sun: DVec3) -> Option<f64> {
        let (near, _) = ray_sphere_intersect(camera, direction, self.position, self.radius)?;
        if near < 0.0 {
            return None;
        }
        let normal = (camera + direction * near - self.position) / self.radius;
        let (mu, mu0) = (-normal.dot(direction), normal.dot(sun).max(0.0));
        Some(MOON_ALBEDO / PI * (2.0 * mu0 / (mu0 + mu.max(1e-4)) + self.earthshine))
    }

    /// Where along a ray (metres from `origin`, ascending) the share of sunlight may bend: on the edges of
    /// umbra and penumbra. direction, sun: unit; sun_radius: radians.
    pub(crate) fn edges(&self, origin: DVec3, direction: DVec3, sun: DVec3, sun_radius: f64) -> Vec<f64> {
        let m = self.position - origin;
        let (nu, along) = (direction.dot(sun), m.dot(sun));
        // Across the sun's direction the moon is at |across - side t|.
        let (across, side) = (m - sun * along, direction - sun * nu);
        let (sin, cos) = sun_radius.sin_cos();
        let mut edges = Vec::with_capacity(8);
        for sign in [1.0, -1.0] {
            // A cone: radius / cos ± (along - nu t) tan.
            let (at, slope) = ((self.radius + sign * along * sin) / cos, -sign * nu * sin / cos);
            let a = side.length_squared() - slope * slope;
            let half_b = -across.dot(side) - at * slope;
            let c = across.length_squared() - at * at;
            let discriminant = half_b * half_b - a * c;
            if discriminant > 0.0 {
                let q = -(half_b + discriminant.sqrt().copysign(half_b));
                edges.extend([q / a, c / q].into_iter().filter(|t| t.is_finite()));
            }
        }
        // Where the moon's middle is closest to the sun's.
        let nearest = across.dot(side) / side.length_squared();
        edges.extend(nearest.is_finite().then_some(nearest));
        edges.sort_by(f64::total_cmp);
        edges
    }
}

/// How the moon stands before the sun.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Phase {
    /// The disks do not overlap.
    None,
    /// Part of the sun is hidden.
    Partial,
    /// All of the moon is before the sun, which is larger.
    Annular,
    /// All of the sun is hidden.
    Total,
}

/// The sun's disk and the moon's, as seen from a point: radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disks {
    /// Angular radius of the sun, > 0.
    pub sun: f64,
    /// Angular radius of the moon, ≥ 0.
    pub moon: f64,
    /// Angle between their centres, ≥ 0.
    pub apart: f64,
}

impl Disks {
    /// What kind of eclipse this is.
    pub fn phase(&self) -> Phase {
        let Self { sun, moon, apart } = *self;
        if apart >= sun + moon {
            Phase::None
        } else if apart <= moon - sun {
            Phase::Total
        } else if apart <= sun - moon {
            Phase::Annular
        } else {
            Phase::Partial
        }
    }

    /// Share of the sun's diameter that is covered; in a total or annular eclipse the ratio of the diameters,
    /// as NASA's eclipse predictions define it. 0 without an eclipse.
    pub fn magnitude(&self) -> f64 {
        match self.phase() {
            Phase::None => 0.0,
            Phase::Partial => (self.sun + self.moon - self.apart) / (2.0 * self.sun),
            Phase::Annular | Phase::Total => self.moon / self.sun,
        }
    }

    /// Share of the sun's disk that is covered, 0 to 1.
    pub fn obscuration(&self) -> f64 {
        1.0 - self.visible()
    }

    /// Share of a uniform disk that is not covered, 0 to 1.
    pub fn visible(&self) -> f64 {
        let ratio = self.moon / self.sun;
        match self.phase() {
            Phase::None => 1.0,
            Phase::Total => 0.0,
            Phase::Annular => (1.0 - ratio) * (1.0 + ratio),
            Phase::Partial => {
                let (at_sun, beyond) = half_angle(self.sun, self.apart, self.moon);
                let (at_moon, _) = half_angle(self.moon, self.apart, self.sun);
                let moon = ratio * ratio * segment(at_moon);
                // More than half of the sun's circle within the moon's: what is left is a crescent.
                let share = if beyond < at_sun {
                    (segment(beyond) - moon) / PI
                } else {
                    1.0 - (segment(at_sun) + moon) / PI
                };
                share.clamp(0.0, 1.0)
            }
        }
    }

    /// Share of the sun's light that is not covered, for 680, 550 and 440 nm, with [`LIMB_DARKENING`]; to
    /// 1e-6.
    pub fn visible_limb_darkened(&self) -> [f64; 3] {
        let (moon, apart) = (self.moon / self.sun, self.apart / self.sun);
        match self.phase() {
            Phase::None => return [1.0; 3],
            Phase::Total => return [0.0; 3],
            Phase::Annular | Phase::Partial => {}
        }
        let mu = |r: f64| ((1.0 - r) * (1.0 + r)).max(0.0).sqrt();
        // Rings of the sun between these radii are crossed by the moon's edge.
        let (inner, outer) = ((moon - apart).abs(), (moon + apart).min(1.0));
        let whole = if moon > apart { mu(inner) } else { 1.0 };
        let (low, high) = (mu(outer), mu(inner));
        // Rings inside of `inner` are hidden if the moon covers the sun's middle.
        let mut hidden = LIMB_DARKENING.map(|a| 1.0 - whole.powf(a + 2.0));
        for (x, weight) in gauss_32() {
            // A cosine takes away the roots at both ends.
            let (sin, cos) = (0.5 * PI * (x + 1.0)).sin_cos();
            let half = 0.5 * (high - low);
            let mu = 0.5 * (high + low) - half * cos;
            let r = ((1.0 - mu) * (1.0 + mu)).max(0.0).sqrt();
            let (covered, _) = half_angle(r, apart, moon);
            let part = 0.5 * PI * weight * half * sin * covered / PI;
            for (hidden, a) in hidden.iter_mut().zip(LIMB_DARKENING) {
                *hidden += part * (a + 2.0) * mu.powf(a + 1.0);
            }
        }
        hidden.map(|v| (1.0 - v).clamp(0.0, 1.0))
    }
}

/// Half the arc of a circle of radius `own` that lies in a circle of radius `other`, `apart` away, and what
/// of half a turn is left. Kahan's form for a triangle's angle by its sides.
fn half_angle(own: f64, apart: f64, other: f64) -> (f64, f64) {
    // The difference of the radii first: it is exact where they are alike.
    let more = other - own;
    let opposite = ((more + apart) * (other + own - apart)).max(0.0).sqrt();
    let adjacent = ((apart - more) * (own + apart + other)).max(0.0).sqrt();
    (2.0 * opposite.atan2(adjacent), 2.0 * adjacent.atan2(opposite))
}

/// Twice the area of a unit circle's segment of half angle `a`, halved: `a - sin a cos a`, from 0 to π.
fn segment(a: f64) -> f64 {
    let y = 2.0 * a;
    if y > 1.0 {
        return a - a.sin() * a.cos();
    }
    // (y - sin y) / 2 as a series.
    let y2 = y * y;
    let series = [210.0, 156.0, 110.0, 72.0, 42.0, 20.0].iter().fold(1.0, |sum, k| 1.0 - y2 / k * sum);
    y * y2 / 12.0 * series
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disks(moon: f64, apart: f64) -> Disks {
        Disks { sun: 4.65e-3, moon: moon * 4.65e-3, apart: apart * 4.65e-3 }
    }

    /// Rings of the sun, each cut by the moon's edge; a plain midpoint rule over radius and azimuth's closed
    /// form.
    fn by_rings(d: &Disks, brightness: impl Fn(f64) -> f64) -> f64 {
        let (moon, apart) = (d.moon / d.sun, d.apart / d.sun);
        const RINGS: usize = 400_000;
        let mut sum = 0.0;
        for i in 0..RINGS {
            let r = (i as f64 + 0.5) / RINGS as f64;
            let cos = (r * r + apart * apart - moon * moon) / (2.0 * r * apart);
            let hidden =
                if apart == 0.0 { f64::from(u8::from(r < moon)) } else { cos.clamp(-1.0, 1.0).acos() / PI };
            sum += 2.0 * r * brightness(r) * (1.0 - hidden) / RINGS as f64;
        }
        sum
    }

    const CASES: [(f64, f64); 14] = [
        (1.05, 0.3),
        (1.05, 1.0),
        (1.05, 1.9),
        (0.95, 0.06),
        (0.95, 0.02),
        (0.95, 0.0),
        (1.0, 1e-3),
        (1.0, 0.5),
        (0.2, 0.5),
        (0.2, 0.9),
        (5.0, 4.5),
        (5.0, 5.9),
        (0.7, 0.7),
        (1.05, 0.051),
    ];

    #[test]
    fn overlap_is_what_integration_says() {
        for (moon, apart) in CASES {
            let d = disks(moon, apart);
            let sum = by_rings(&d, |_| 1.0);
            assert!((d.visible() - sum).abs() < 3e-8, "{moon} {apart}: {} {sum}", d.visible());
            for (c, share) in d.visible_limb_darkened().into_iter().enumerate() {
                let sum = by_rings(&d, |r| limb_darkening(r)[c]);
                assert!((share - sum).abs() < 1e-6, "{moon} {apart} {c}: {share} {sum}");
            }
        }
    }

    #[test]
    fn kinds_and_magnitudes() {
        for (moon, apart, phase, magnitude, visible) in [
            (1.05, 2.06, Phase::None, 0.0, 1.0),
            (1.05, 0.04, Phase::Total, 1.05, 0.0),
            (0.9, 0.05, Phase::Annular, 0.9, 0.19),
            (1.0, 1.0, Phase::Partial, 0.5, 1.0 / 3.0 + 0.75f64.sqrt() / PI),
        ] {
            let d = disks(moon, apart);
            assert_eq!(d.phase(), phase);
            assert!((d.magnitude() - magnitude).abs() < 1e-12, "{moon} {apart}: {}", d.magnitude());
            // Equal circles at a radius from each other: a lens of 2π/3 - √3/2.
            assert!((d.visible() - visible).abs() < 1e-12, "{moon} {apart}: {}", d.visible());
            assert!((d.obscuration() + d.visible() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn light_is_continuous_at_every_contact_and_falls_towards_the_middle() {
        for moon in [0.2, 0.95, 0.999, 1.0, 1.001, 1.05, 5.0f64] {
            for contact in [1.0 + moon, (1.0 - moon).abs()] {
                for step in [1e-6, 1e-9, 1e-12f64] {
                    let (inside, outside) =
                        (disks(moon, (contact - step).max(0.0)), disks(moon, contact + step));
                    assert!(
                        (inside.visible() - outside.visible()).abs() < 3.0 * step.powf(0.5) * moon + 1e-12
                    );
                    for c in 0..3 {
                        let step = outside.visible_limb_darkened()[c] - inside.visible_limb_darkened()[c];
                        assert!(step.abs() < 2e-3, "{moon} {contact} {c}: {step}");
                    }
                }
            }
            let mut before = 0.0;
            for i in 0..=1000 {
                let visible = disks(moon, (1.0 + moon) * f64::from(i) / 1000.0).visible();
                assert!(visible >= before - 1e-14, "{moon} {i}: {before} {visible}");
                before = visible;
            }
            assert_eq!(before, 1.0);
        }
    }

    #[test]
    fn what_is_hidden_of_one_disk_is_hidden_of_the_other() {
        for (moon, apart) in CASES {
            let there = disks(moon, apart);
            let back = Disks { sun: there.moon, moon: there.sun, apart: there.apart };
            let (a, b) = (there.obscuration() * there.sun.powi(2), back.obscuration() * back.sun.powi(2));
            assert!(
                (a - b).abs() < 1e-13 * there.sun.powi(2).max(there.moon.powi(2)),
                "{moon} {apart}: {a} {b}"
            );
        }
    }

    #[test]
    fn slivers_keep_their_digits() {
        // Near a contact the lens is a pair of parabolas: 8/3 of the depth times the half chord, over 2.
        for (moon, depth) in [(1.05, 1e-4), (0.5, 1e-6), (1.0, 1e-8)] {
            let d = Disks { sun: 1.0, moon, apart: 1.0 + moon - depth };
            let chord = (2.0 * depth * moon / (1.0 + moon)).sqrt();
            let lens = 4.0 / 3.0 * depth * chord / PI;
            let (a, b) = (half_angle(1.0, d.apart, moon).0, half_angle(moon, d.apart, 1.0).0);
            let ours = (segment(a) + moon * moon * segment(b)) / PI;
            assert!((ours / lens - 1.0).abs() < 2.0 * depth + 1e-7, "{moon} {depth}: {ours} {lens}");
        }
        // The last of the sun before totality.
        for depth in [1e-3, 1e-5, 1e-7] {
            let d = Disks { sun: 1.0, moon: 1.05, apart: 0.05 + depth };
            let chord = (2.0 * depth * 1.05 / 0.05).sqrt();
            let crescent = 4.0 / 3.0 * depth * chord / PI;
            assert!(
                (d.visible() / crescent - 1.0).abs() < 15.0 * depth + 1e-6,
                "{depth}: {} {crescent}",
                d.visible()
            );
        }
    }

    #[test]
    fn limb_darkening_falls_outwards_more_in_blue_and_keeps_the_light() {
        for c in 0..3 {
            let whole = by_rings(&Disks { sun: 1.0, moon: 0.0, apart: 2.0 }, |r| limb_darkening(r)[c]);
            assert!((whole - 1.0).abs() < 1e-6, "{c}: {whole}");
        }
        let mut before = [f64::INFINITY; 3];
        for i in 0..=100 {
            let now = limb_darkening(f64::from(i) / 100.0);
            assert!((0..3).all(|c| now[c] < before[c]));
            let share = (0..3).map(|c| now[c] / limb_darkening(0.0)[c]).collect::<Vec<_>>();
            assert!(i == 0 || i == 100 || (share[0] > share[1] && share[1] > share[2]));
            before = now;
        }
        // The fit over wavelengths that the same paper gives.
        for (alpha, nm) in LIMB_DARKENING.into_iter().zip([680.0, 550.0, 440.0]) {
            assert!((alpha - (292.0 / nm - 0.023)).abs() < 0.012, "{alpha} {nm}");
        }
    }

    #[test]
    fn the_shadow_has_its_place_and_width() {
        // From a point on the axis and beside it: the shadow's edges are where the disks touch.
        let sun = DVec3::new(0.3, -0.4, 0.8).normalize();
        let moon = Moon::new(sun * 3.7e8 + DVec3::new(1e6, 2e6, 0.0), MOON_RADIUS);
        let radius = 4.65e-3;
        let direction = DVec3::new(-0.2, 0.9, 0.5).normalize();
        let edges = moon.edges(DVec3::ZERO, direction, sun, radius);
        assert!(edges.len() >= 3, "{edges:?}");
        for t in &edges {
            let at = |t: f64| moon.disks(direction * t, sun, radius).unwrap();
            let d = at(*t);
            let contact = (d.apart - d.sun - d.moon).abs().min((d.apart - (d.sun - d.moon).abs()).abs());
            let least = at(t - 1e4).apart > d.apart && at(t + 1e4).apart > d.apart;
            assert!(contact < 1e-6 * d.sun || least, "{t}: {d:?}");
        }
        // Behind the point it hides nothing.
        let behind = Moon::new(sun * -3.7e8, MOON_RADIUS);
        assert_eq!(behind.sunlight(DVec3::ZERO, sun, radius), [1.0; 3]);
        let floor = Moon { floor: 0.075, ..Moon::new(sun * 3.7e8, MOON_RADIUS) };
        assert_eq!(floor.sunlight(DVec3::ZERO, sun, radius), [0.075; 3]);
        assert_eq!(Moon { floor: 0.0, ..floor }.sunlight(DVec3::ZERO, sun, radius), [0.0; 3]);
    }

    #[test]
    fn bad_moons_name_the_field() {
        let good = Moon::new(DVec3::X * 3.8e8, MOON_RADIUS);
        good.validate(DVec3::ZERO).unwrap();
        for (moon, field) in [
            (Moon { position: DVec3::NAN, ..good }, "moon.position.x"),
            (Moon { position: DVec3::Z * 1e16, ..good }, "moon.position.z"),
            (Moon { position: DVec3::X * 1e6, ..good }, "moon.position ="),
            (Moon { radius: 0.0, ..good }, "moon.radius"),
            (Moon { radius: f64::INFINITY, ..good }, "moon.radius"),
            (Moon { floor: -0.1, ..good }, "moon.floor"),
            (Moon { floor: f64::NAN, ..good }, "moon.floor"),
        ] {
            let error = moon.validate(DVec3::ZERO).unwrap_err().to_string();
            assert!(error.starts_with(field), "{error}");
        }
    }
}
