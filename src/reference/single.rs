//! Transmittance and single scattering along one ray.
//!
//! Single scattering is the integral along the view ray of
//! `Σ σᵢ(h) pᵢ(ν) exp(-τ_view - τ_sun)` over the sunlit part of the ray: Nishita et al. 1993;
//! Bruneton & Neyret 2008, section 3. Both optical depths are integrals over a spherical shell; the planet
//! casts a shadow.

use std::f64::consts::PI;

use glam::DVec3;

use super::geometry::{Chord, RayEnd};
use super::harmonics;
use super::medium::{ColumnRule, Medium, Phases};
use crate::error::{Error, Result, direction, in_range};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::moon::Moon;
use crate::model::quadrature::{fixed, gauss_legendre, integrate};

/// A ray through a planet's air, in the zenith frame of its origin: z points away from the planet's
/// centre, and the origin's altitude is a number of its own, so nothing is a difference of two radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayQuery {
    /// Altitude of the origin, metres. Below the lowest ground counts as on it; above the top is fine.
    pub altitude: f64,
    /// Where the ray goes, any length but zero.
    pub direction: DVec3,
    /// Towards the sun, any length but zero.
    pub sun: DVec3,
    /// Distance of a scene object that ends the ray, metres; infinite if there is none. One that lies deeper
    /// than the lowest ground, or behind its bulge, stands in air as dense as on it.
    pub length: f64,
    /// A moon that dims the sun, its position from the ray's origin in the ray's own frame; for
    /// [`single_scattering`] and
    /// [`super::path`].
    pub moon: Option<Moon>,
}

impl RayQuery {
    /// A ray by its angles, radians: zenith angles of view and sun, and the azimuth of the view
    /// direction from the sun's. Angles are kept, not cosines, so that a ray may miss the horizon by 1e-9
    /// rad.
    pub fn new(altitude: f64, view_zenith: f64, sun_zenith: f64, azimuth_from_sun: f64) -> Self {
        let (sin, cos) = view_zenith.sin_cos();
        let (sin_sun, cos_sun) = sun_zenith.sin_cos();
        Self {
            altitude,
            direction: DVec3::new(sin * azimuth_from_sun.cos(), sin * azimuth_from_sun.sin(), cos),
            sun: DVec3::new(sin_sun, 0.0, cos_sun),
            length: f64::INFINITY,
            moon: None,
        }
    }

    /// A ray in any frame of reference. `position` is relative to the planet's centre, metres;
    /// `direction` and `sun` need no particular length.
    ///
    /// # Errors
    /// A vector that is not finite or has no direction.
    pub fn in_world(
        position: DVec3,
        direction_of_view: DVec3,
        sun: DVec3,
        planet_radius: f64,
    ) -> Result<Self> {
        let z = direction("ray.position", position)?;
        let view = direction("ray.direction", direction_of_view)?;
        let sun = direction("ray.sun", sun)?;
        let x = z.any_orthonormal_vector();
        let y = z.cross(x);
        let turn = |v: DVec3| DVec3::new(v.dot(x), v.dot(y), v.dot(z));
        Ok(Self {
            altitude: position.length() - planet_radius,
            direction: turn(view),
            sun: turn(sun),
            length: f64::INFINITY,
            moon: None,
        })
    }

    /// The same ray under a moon, its position as in [`Self::moon`].
    pub fn eclipsed_by(self, moon: Moon) -> Self {
        Self { moon: Some(moon), ..self }
    }

    /// The same ray ended by a scene object `length` metres away.
    pub fn ended_at(self, length: f64) -> Self {
        Self { length, ..self }
    }

    /// Checks a ray through this air; answers one with unit vectors whose altitude is the height above the
    /// lowest ground.
    pub(crate) fn validate(&self, params: &AtmosphereParams) -> Result<Self> {
        in_range("ray.altitude", self.altitude, -1e16, 1e16, "m")?;
        if let Some(moon) = &self.moon {
            moon.validate(DVec3::ZERO)?;
        }
        if self.length != f64::INFINITY {
            in_range("ray.length", self.length, 0.0, 1e16, "m (or infinite)")?;
        }
        Ok(Self {
            altitude: (self.altitude - params.lowest_ground).max(0.0),
            direction: direction("ray.direction", self.direction)?,
            sun: direction("ray.sun", self.sun)?,
            length: self.length,
            moon: self.moon,
        })
    }
}

/// How exact an answer shall be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Estimated error over value, in each channel; 1e-10 to 0.1.
    pub relative: f64,
}

impl Tolerance {
    /// 1e-3, for pictures. What is met is usually ten times better.
    pub const PICTURE: Self = Self { relative: 1e-3 };
    /// 1e-6, to judge others by.
    pub const TRUTH: Self = Self { relative: 1e-6 };

    pub(crate) fn columns(self) -> ColumnRule {
        if self.relative < 1e-4 { ColumnRule::Precise } else { ColumnRule::Quick }
    }

    pub(crate) fn validate(self) -> Result<()> {
        in_range("tolerance.relative", self.relative, 1e-10, 0.1, "").map(|_| ())
    }
}

/// How the sun is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Sun {
    /// All light from the disk's centre.
    #[default]
    Point,
    /// A uniform disk of [`AtmosphereParams::sun_angular_radius`], sampled at `rings` Gauss–Legendre radii
    /// times `2 × rings + 1` azimuths. It softens the terminator; `rings` from 1 to 16 costs that often.
    Disk {
        /// 1 to 16.
        rings: u32,
    },
}

/// Light that reaches the eye along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattered {
    /// Radiance per unit solar irradiance, 1/sr, red, green, blue.
    pub per_irradiance: [f64; 3],
    /// Radiance in the unit of [`AtmosphereParams::sun_intensity`] per steradian.
    pub radiance: [f64; 3],
    /// Share of light that gets through from the ray's end to its origin.
    pub transmittance: [f64; 3],
    /// What ends the ray.
    pub ends_at: RayEnd,
    /// Estimated error of `per_irradiance`, 1/sr.
    pub error: [f64; 3],
    /// How many points of the view ray were lit and summed.
    pub evaluations: u32,
}

/// The sun seen from points of a line: cosine to the zenith as a function of `s`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SunLine {
    chord: Chord,
    /// Height of the point over the plane through the centre perpendicular to the sun: `a + b s`.
    a: f64,
    b: f64,
    /// Sine of the angle between line and sun, squared.
    sin2: f64,
    planet_radius: f64,
}

impl SunLine {
    /// `direction` and `sun` of length 1 in the zenith frame of the chord's origin.
    pub fn new(chord: Chord, planet_radius: f64, direction: DVec3, sun: DVec3) -> Self {
        let sin = direction.x.hypot(direction.y);
        // From the centre to the perigee: the zenith less its part along the ray, to length 1.
        let to_perigee = if sin > 0.0 {
            DVec3::new(-direction.z * direction.x / sin, -direction.z * direction.y / sin, sin)
        } else {
            DVec3::X
        };
        Self {
            chord,
            a: chord.perigee_radius * to_perigee.dot(sun),
            b: direction.dot(sun),
            sin2: direction.cross(sun).length_squared(),
            planet_radius,
        }
    }

    /// The line from the point at `s` towards the sun, by the point's altitude.
    pub fn to_sun(self, s: f64, altitude: f64) -> Chord {
        let mu = self.mu(s);
        Chord::new(self.planet_radius, altitude, mu, ((1.0 - mu) * (1.0 + mu)).sqrt())
    }

    /// Cosine of the sun's zenith angle at `s`.
    pub fn mu(self, s: f64) -> f64 {
        let r = self.chord.radius(s);
        if r > 0.0 { ((self.a + self.b * s) / r).clamp(-1.0, 1.0) } else { 0.0 }
    }

    /// The stretch of the line in the planet's shadow: the half cylinder behind the planet, which is
    /// convex, so there is at most one.
    pub fn shadow(self) -> Option<(f64, f64)> {
        // |P|² - (P·sun)² < R²: sin2 s² - 2 a b s + hp (2 R + hp) - a² < 0.
        let hp = self.chord.perigee_altitude;
        let half_b = self.a * self.b;
        let c = hp * (2.0 * self.planet_radius + hp) - self.a * self.a;
        let (mut lo, mut hi) = (f64::NEG_INFINITY, f64::INFINITY);
        if self.sin2 > 1e-24 {
            let discriminant = half_b * half_b - self.sin2 * c;
            if discriminant <= 0.0 {
                return None;
            }
            let q = half_b + discriminant.sqrt().copysign(half_b);
            let (first, second) = (q / self.sin2, if q == 0.0 { 0.0 } else { c / q });
            (lo, hi) = (first.min(second), first.max(second));
        } else if c >= 0.0 {
            return None;
        }
        // Behind the planet: a + b s < 0.
        if self.b > 0.0 {
            hi = hi.min(-self.a / self.b);
        } else if self.b < 0.0 {
            lo = lo.max(-self.a / self.b);
        } else if self.a >= 0.0 {
            return None;
        }
        (lo < hi).then_some((lo, hi))
    }

    /// The sunlit stretches of `s0..s1`.
    pub fn lit(self, s0: f64, s1: f64) -> impl Iterator<Item = (f64, f64)> {
        let pieces = match self.shadow() {
            Some((lo, hi)) => [(s0, s1.min(lo)), (s0.max(hi), s1)],
            None => [(s0, s1), (s0, s0)],
        };
        pieces.into_iter().filter(|(a, b)| b > a)
    }
}

/// Light scattered once towards the ray's origin, and the transmittance to the ray's end.
///
/// The ray ends at the top of the atmosphere, at the ground or at `query.length`, whichever comes
/// first; light from that end (sun disk, ground, object) is not included. Multiply it by
/// [`Scattered::transmittance`] and add.
///
/// # Errors
/// Parameters that [`AtmosphereParams::validate`] refuses; a query or tolerance out of range.
///
/// ```
/// use welkin::AtmosphereParams;
/// use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
/// let zenith = RayQuery::new(0.0, 0.0, 60f64.to_radians(), 0.0);
/// let sky = single_scattering(&AtmosphereParams::earth(), &zenith, Sun::Point, Tolerance::PICTURE)?;
/// assert!(sky.radiance[2] > sky.radiance[0]);
/// # Ok::<(), welkin::Error>(())
/// ```
pub fn single_scattering(
    params: &AtmosphereParams,
    query: &RayQuery,
    sun: Sun,
    tolerance: Tolerance,
) -> Result<Scattered> {
    params.validate()?;
    tolerance.validate()?;
    let query = query.validate(params)?;
    let medium = Medium::new(params);
    let Sun::Disk { rings } = sun else {
        return Ok(scatter(&medium, &query, Line::Adaptive(tolerance), None));
    };
    in_range("sun.rings", f64::from(rings), 1.0, 16.0, "")?;
    if query.moon.is_some() {
        return Err(Error::invalid("sun", "a disk of rings", "a point where a moon hides part of it"));
    }
    // The disk as a cap around the centre: uniform in the squared sine, to the cap's second order.
    let (x, y) = query.sun.any_orthonormal_pair();
    let azimuths = 2 * rings + 1;
    let mut sum = Scattered {
        per_irradiance: [0.0; 3],
        radiance: [0.0; 3],
        error: [0.0; 3],
        evaluations: 0,
        ..scatter(&medium, &query, Line::Adaptive(tolerance), None)
    };
    for (node, weight) in gauss_legendre(rings as usize) {
        let sin = params.sun_angular_radius.sin() * (0.5 * (node + 1.0)).sqrt();
        let weight = 0.5 * weight / f64::from(azimuths);
        for k in 0..azimuths {
            let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(azimuths)).sin_cos();
            let sun = query.sun * (1.0 - sin * sin).sqrt() + (x * c + y * s) * sin;
            let part = scatter(&medium, &RayQuery { sun, ..query }, Line::Adaptive(tolerance), None);
            for c in 0..3 {
                sum.per_irradiance[c] += weight * part.per_irradiance[c];
                sum.radiance[c] += weight * part.radiance[c];
                sum.error[c] += weight * part.error[c];
            }
            sum.evaluations += part.evaluations;
        }
    }
    Ok(sum)
}

/// What repeated scattering by small angles adds to the aerosol's phase function, in the moments beyond a
/// degree: `Σ_l (2 l + 1) / 4π P_l(ν) χ_l (exp(χ_l τ) - 1)`, τ the aerosol's scattering depth towards the
/// sun; as a power series in τ, whose coefficients depend on the scattering angle alone.
#[derive(Clone, Debug)]
pub(crate) struct SmallAngles {
    /// `[channel][n - 1]`: `Σ_l (2 l + 1) / 4π P_l(ν) χ_l^(n + 1) / n!`.
    coefficients: [[f64; Self::TERMS]; 3],
}

impl SmallAngles {
    /// Enough where `g^(degree + 1) τ` is below 3.
    const TERMS: usize = 12;

    /// For a cosine `nu` of the scattering angle and moments from `degree + 1` on.
    pub fn new(params: &AtmosphereParams, degree: usize, nu: f64) -> Self {
        let coefficients = std::array::from_fn(|c| {
            let g = params.mie_asymmetry[c];
            // Squares below 1e-7 do not matter.
            let last = if g.abs() > 1e-3 { (8.0 / -g.abs().ln()).min(1000.0) as usize } else { 0 };
            let mut sums = [0.0; Self::TERMS];
            if last <= degree {
                return sums;
            }
            let moments = harmonics::mie_moments(params.mie_phase, g, last);
            let (mut before, mut p) = (0.0, 1.0);
            for (l, chi) in moments.iter().enumerate() {
                let lf = l as f64;
                if l > degree {
                    let mut term = (2.0 * lf + 1.0) / (4.0 * PI) * p * chi;
                    for (n, sum) in sums.iter_mut().enumerate() {
                        term *= chi / (n as f64 + 1.0);
                        *sum += term;
                    }
                }
                (before, p) = (p, ((2.0 * lf + 1.0) * nu * p - lf * before) / (lf + 1.0));
            }
            sums
        });
        Self { coefficients }
    }

    /// `aerosol` phase functions with the addition for a column (metres) of aerosol towards the sun.
    fn add(&self, aerosol: [f64; 3], scattering: &[f64; 3], column: f64) -> [f64; 3] {
        std::array::from_fn(|c| {
            // Beyond this depth what is left of the sun's own light is below 1e-13.
            let depth = (scattering[c] * column).min(30.0);
            aerosol[c] + self.coefficients[c].iter().rev().fold(0.0, |sum, k| (sum + k) * depth)
        })
    }
}

/// How the integral along a view ray is done.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Line {
    Adaptive(Tolerance),
    /// Six Gauss–Legendre nodes between neighbouring breaks: about 1e-4, for averages over many rays.
    Fixed,
}

/// [`single_scattering`] after all checks.
///
/// `tail` adds light that was scattered several times, each time by a small angle.
pub(crate) fn scatter(
    medium: &Medium,
    query: &RayQuery,
    line: Line,
    tail: Option<&SmallAngles>,
) -> Scattered {
    let params = &medium.from_ground;
    let d = query.direction;
    let chord = Chord::new(params.planet_radius, query.altitude, d.z, d.x.hypot(d.y));
    let Some((s0, s1, ends_at)) = chord.clip(medium.top, query.length) else {
        return Scattered {
            per_irradiance: [0.0; 3],
            radiance: [0.0; 3],
            transmittance: [1.0; 3],
            ends_at: if query.length == f64::INFINITY { RayEnd::Space } else { RayEnd::Object },
            error: [0.0; 3],
            evaluations: 0,
        };
    };
    let rule = match line {
        Line::Adaptive(tolerance) => tolerance.columns(),
        Line::Fixed => ColumnRule::Quick,
    };
    let transmittance = medium.optical_depth(medium.columns(&chord, s0, s1, rule)).map(|t| (-t).exp());
    let sun = SunLine::new(chord, params.planet_radius, d, query.sun);
    let phases = medium.phases(d.dot(query.sun));
    let mut sum = Scattered {
        per_irradiance: [0.0; 3],
        radiance: [0.0; 3],
        transmittance,
        ends_at,
        error: [0.0; 3],
        evaluations: 0,
    };
    let integrand = |v: f64| {
        let (s, jacobian) = chord.at_v(v);
        let altitude = chord.perigee_altitude + v * v;
        let view = medium.columns(&chord, s0, s, rule);
        // Just inside the edge of the shadow rounding may say "dark": the sun's ray then grazes the ground.
        let mut to_sun = sun.to_sun(s, altitude.max(0.0));
        to_sun.perigee_altitude =
            if to_sun.origin < 0.0 { to_sun.perigee_altitude.max(0.0) } else { to_sun.perigee_altitude };
        let Some(light) = medium.columns_to_sun(&to_sun, rule) else { return [0.0; 3] };
        let depth = medium.optical_depth(std::array::from_fn(|i| view[i] + light[i]));
        let phases = match tail {
            Some(tail) => {
                Phases { aerosol: tail.add(phases.aerosol, &params.mie_scattering, light[1]), ..phases }
            }
            None => phases,
        };
        let scattering = medium.scattering(altitude, &phases);
        let share = match &query.moon {
            Some(moon) => moon.sunlight(d * (s - chord.origin), query.sun, params.sun_angular_radius),
            None => [1.0; 3],
        };
        std::array::from_fn(|c| scattering[c] * (-depth[c]).exp() * jacobian * share[c])
    };
    // The edges of the moon's shadow, which an adaptive rule could step over.
    let edges = match &query.moon {
        Some(moon) => moon.edges(DVec3::ZERO, d, query.sun, params.sun_angular_radius),
        None => Vec::new(),
    };
    let mut breaks = Vec::with_capacity(24);
    for (a, b) in sun.lit(s0, s1) {
        breaks.clear();
        let (a, b) = (chord.v_at(a), chord.v_at(b));
        let step = if matches!(line, Line::Fixed) { 1.0 } else { 5.0 };
        view_breaks(medium, &chord, s0, a, b, step, &mut breaks);
        if let [first, .., last] = breaks[..] {
            let edges = edges.iter().map(|t| chord.v_at(chord.origin + t));
            breaks.extend(edges.filter(|v| first < *v && *v < last));
            breaks.sort_by(f64::total_cmp);
        }
        // The stretches' errors add, and so do their values: each may use the whole tolerance.
        let part = match line {
            Line::Adaptive(tolerance) => integrate(integrand, &breaks, tolerance.relative, 1e-40, 600),
            Line::Fixed => fixed(integrand, &breaks),
        };
        for c in 0..3 {
            sum.per_irradiance[c] += part.value[c];
            sum.error[c] += part.error[c];
        }
        sum.evaluations += part.evaluations;
    }
    sum.radiance = sum.per_irradiance.map(|v| v * params.sun_intensity);
    sum
}

/// Where to split an integral over `v` from a to b: perigee, kinks of the profiles, altitudes at which
/// the exponentials have thinned, and every `step` of optical depth from `s0`, so that each panel is easy.
/// Ends where nothing gets through any more.
pub(crate) fn view_breaks(
    medium: &Medium,
    chord: &Chord,
    s0: f64,
    a: f64,
    b: f64,
    step: f64,
    breaks: &mut Vec<f64>,
) {
    let p = &medium.from_ground;
    let low = if a * b <= 0.0 { 0.0 } else { (a * a).min(b * b) };
    breaks.extend([a, b]);
    if a < 0.0 && b > 0.0 {
        breaks.push(0.0);
    }
    let mut push = |square: f64| {
        if square > 0.0 {
            let v = square.sqrt();
            breaks.extend([-v, v].into_iter().filter(|v| a < *v && *v < b));
        }
    };
    for kink in medium.kinks() {
        push(kink - chord.perigee_altitude);
    }
    let aerosol =
        medium.mie_extinction.iter().any(|&v| v > 0.0) && p.mie_scale_height != p.rayleigh_scale_height;
    if aerosol {
        push(low + 1.5 * p.mie_scale_height);
        push(low + 6.0 * p.mie_scale_height);
    }
    push(low + 2.5 * p.rayleigh_scale_height);
    breaks.sort_by(f64::total_cmp);
    let depth = |v: f64| medium.optical_depth(medium.columns(chord, s0, chord.at_v(v).0, ColumnRule::Quick));
    // A place on the ray and the depth to it.
    type Mark = (f64, [f64; 3]);
    let (near, far) = (depth(a), depth(b));
    if (0..3).all(|c| far[c] - near[c] <= step) {
        return;
    }
    let marks: Vec<Mark> = breaks.iter().map(|&v| (v, depth(v))).collect();
    // Panels still to be looked at, the nearest last, and how often each may be halved.
    let mut todo: Vec<(Mark, Mark, u32)> = marks.windows(2).rev().map(|w| (w[0], w[1], 40)).collect();
    breaks.truncate(1);
    while let Some((from, to, left)) = todo.pop() {
        if (0..3).all(|c| from.1[c] > OPAQUE) {
            return;
        }
        // Of a channel that is already dark the depth does not matter.
        if left > 0 && (0..3).any(|c| from.1[c] < OPAQUE && to.1[c] - from.1[c] > step) {
            let v = 0.5 * (from.0 + to.0);
            let middle = (v, depth(v));
            todo.push((middle, to, left - 1));
            todo.push((from, middle, left - 1));
        } else {
            breaks.push(to.0);
        }
    }
}

/// Optical depth behind which nothing is looked for: 4e-18 gets through.
const OPAQUE: f64 = 40.0;

/// Share of light, per channel, that gets through from the ray's end (space, ground or scene object)
/// to its origin.
///
/// # Errors
/// As [`single_scattering`].
pub fn transmittance(params: &AtmosphereParams, query: &RayQuery, tolerance: Tolerance) -> Result<[f64; 3]> {
    Ok(optical_depth(params, query, tolerance)?.map(|t| (-t).exp()))
}

/// Optical depth, per channel, from the ray's origin to its end (space, ground or scene object).
///
/// # Errors
/// As [`single_scattering`].
pub fn optical_depth(params: &AtmosphereParams, query: &RayQuery, tolerance: Tolerance) -> Result<[f64; 3]> {
    params.validate()?;
    tolerance.validate()?;
    let query = query.validate(params)?;
    let medium = Medium::new(params);
    let d = query.direction;
    let chord = Chord::new(medium.from_ground.planet_radius, query.altitude, d.z, d.x.hypot(d.y));
    Ok(match chord.clip(medium.top, query.length) {
        Some((s0, s1, _)) => medium.optical_depth(medium.columns(&chord, s0, s1, tolerance.columns())),
        None => [0.0; 3],
    })
}

/// Most samples that [`compute_single_scatter`] takes of a ray.
pub const MAX_SAMPLES: u32 = 65_536;

/// Single scattering by a plain march with fixed numbers of samples: what a shader does, in f64.
///
/// The planet's centre is the origin; `camera` in metres, `look` and `sun` of any length. Returns radiance,
/// [`AtmosphereParams::sun_intensity`] × 1/sr. The ground ends the ray, the planet shades the air, the sun's
/// disk is not drawn. Samples are midpoints that crowd where the ray is lowest: even in the exponential of
/// [`Chord`]'s `v`. Sample counts are clamped to 1..=[`MAX_SAMPLES`]. Inputs that are not finite,
/// directions without length and parameters that fail [`AtmosphereParams::validate`] give black.
///
/// For an answer with an error bound use [`single_scattering`].
///
/// ```
/// use welkin::{AtmosphereParams, reference::compute_single_scatter};
/// use glam::Vec3;
/// let air = AtmosphereParams::earth_like(6_371_000.0);
/// let noon = compute_single_scatter(Vec3::Y * 6_371_001.7, Vec3::new(1.0, 0.5, 0.0), Vec3::Y, &air, 16, 8);
/// assert!(noon[2] > noon[0]);
/// ```
pub fn compute_single_scatter(
    camera: impl Into<DVec3>,
    look: impl Into<DVec3>,
    sun: impl Into<DVec3>,
    params: &AtmosphereParams,
    view_samples: u32,
    light_samples: u32,
) -> [f32; 3] {
    let query = RayQuery::in_world(camera.into(), look.into(), sun.into(), params.planet_radius);
    let Some(query) = query.and_then(|q| q.validate(params)).ok().filter(|_| params.validate().is_ok())
    else {
        return [0.0; 3];
    };
    let view_samples = view_samples.clamp(1, MAX_SAMPLES);
    let light_samples = light_samples.clamp(1, MAX_SAMPLES);
    let medium = Medium::new(params);
    let d = query.direction;
    let chord = Chord::new(medium.from_ground.planet_radius, query.altitude, d.z, d.x.hypot(d.y));
    let Some((s0, s1, _)) = chord.clip(medium.top, query.length) else { return [0.0; 3] };
    let line = SunLine::new(chord, medium.from_ground.planet_radius, d, query.sun);
    let phases = medium.phases(d.dot(query.sun));
    let mut view_depth = [0.0; 3];
    let mut sum = [0.0; 3];
    march(&chord, s0, s1, view_samples, |s, length| {
        let altitude = chord.altitude(s).max(0.0);
        let extinction = medium.extinction(altitude);
        let step: [f64; 3] = std::array::from_fn(|c| extinction[c] * length);
        let to_sun = line.to_sun(s, altitude);
        let shaded = to_sun.perigee_altitude < 0.0 && to_sun.origin < 0.0;
        if let Some((a, b, _)) = to_sun.clip(medium.top, f64::INFINITY).filter(|_| !shaded) {
            let mut light_depth = [0.0; 3];
            march(&to_sun, a, b, light_samples, |s, length| {
                let extinction = medium.extinction(to_sun.altitude(s));
                for c in 0..3 {
                    light_depth[c] += extinction[c] * length;
                }
            });
            let scattering = medium.scattering(altitude, &phases);
            for c in 0..3 {
                // Light scattered within the step is dimmed by the step itself: (1 - exp(-τ)) / τ on average.
                let own = if step[c] > 1e-6 { -(-step[c]).exp_m1() / step[c] } else { 1.0 - 0.5 * step[c] };
                sum[c] += scattering[c] * length * own * (-(view_depth[c] + light_depth[c])).exp();
            }
        }
        for c in 0..3 {
            view_depth[c] += step[c];
        }
    });
    sum.map(|v| (v * params.sun_intensity) as f32)
}

/// Calls `f` with position and length of `samples` steps that cover `s0..s1`, in order, crowding near the
/// lowest point: `v` grows by a factor between steps. A line with its perigee inside is split there.
fn march(chord: &Chord, s0: f64, s1: f64, samples: u32, mut f: impl FnMut(f64, f64)) {
    /// How much longer the last step is than the first, as a power of e.
    const CROWDING: f64 = 4.0;
    let curve = |u: f64| (CROWDING * u).exp_m1() / CROWDING.exp_m1();
    let (v0, v1) = (chord.v_at(s0), chord.v_at(s1));
    let mut stretch = |from: f64, to: f64, n: u32, away: bool| {
        let place =
            |u: f64| if away { from + (to - from) * curve(u) } else { to + (from - to) * curve(1.0 - u) };
        let mut before = chord.at_v(place(0.0)).0;
        for i in 0..n {
            let middle = chord.at_v(place((f64::from(i) + 0.5) / f64::from(n))).0;
            let after = chord.at_v(place(f64::from(i + 1) / f64::from(n))).0;
            f(middle, after - before);
            before = after;
        }
    };
    if v0 < 0.0 && v1 > 0.0 && samples > 1 {
        let down = ((f64::from(samples) * -v0 / (v1 - v0)).round() as u32).clamp(1, samples - 1);
        stretch(v0, 0.0, down, false);
        stretch(0.0, v1, samples - down, true);
    } else {
        stretch(v0, v1, samples, v0 + v1 >= 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::geometry::ray_sphere_intersect_f32;
    use glam::Vec3;

    fn earth() -> (AtmosphereParams, Vec3) {
        let params = AtmosphereParams::earth_like(6_371_000.0);
        (params, Vec3::new(0.0, 6_371_001.7, 0.0))
    }

    fn sum(color: [f32; 3]) -> f32 {
        color.iter().sum()
    }

    #[test]
    fn the_air_is_above_a_person_on_the_ground() {
        let (params, eye) = earth();
        let (near, far) = ray_sphere_intersect_f32(eye, Vec3::Y, Vec3::ZERO, params.atmosphere_radius as f32);
        assert!(near < 0.0 && far > 0.0);
        assert!((f64::from(far) / params.thickness() - 1.0).abs() < 1e-4, "{far}");
    }

    #[test]
    fn the_limb_is_seen_from_orbit_and_only_the_limb() {
        let (params, _) = earth();
        let eye = DVec3::new(0.0, 3.0 * params.atmosphere_radius, 0.0);
        let sun = DVec3::new(0.2, 1.0, 0.1);
        // Rays by the altitude of their closest approach.
        let aim = |altitude: f64| {
            let sin = (params.planet_radius + altitude) / eye.y;
            DVec3::new(sin, -(1.0 - sin * sin).sqrt(), 0.0)
        };
        let hit = |altitude: f64| {
            ray_sphere_intersect_f32(
                eye.as_vec3(),
                aim(altitude).as_vec3(),
                Vec3::ZERO,
                params.atmosphere_radius as f32,
            )
        };
        let (near, far) = hit(20_000.0);
        assert!(near > 0.0 && far > near, "{near} {far}");
        assert_eq!(hit(params.thickness() + 5000.0), (-1.0, -1.0));
        let light = |altitude: f64| sum(compute_single_scatter(eye, aim(altitude), sun, &params, 32, 16));
        // Grazing the top: next to nothing. The limb glows; above it is black; a halo, thinning outwards.
        assert!(light(10_000.0) > 0.1, "{}", light(10_000.0));
        assert!(light(10_000.0) > 5.0 * light(50_000.0) && light(50_000.0) > 5.0 * light(90_000.0));
        assert!(light(params.thickness() - 1.0) > 0.0 && light(params.thickness() - 1.0) < 1e-6);
        assert_eq!(light(params.thickness() + 1.0), 0.0);
        // The original example's ray passes at 2.9 radii and sees nothing.
        assert_eq!(compute_single_scatter(eye, DVec3::new(1.0, -0.3, 0.0), sun, &params, 16, 8), [0.0; 3]);
    }

    #[test]
    fn the_sky_is_blue_at_noon_and_redder_at_sunset() {
        let (params, eye) = earth();
        let look = Vec3::new(1.0, 0.5, 0.0);
        let noon = compute_single_scatter(eye, look, Vec3::Y, &params, 16, 8);
        let sunset = compute_single_scatter(eye, look, Vec3::new(1.0, 0.01, 0.0), &params, 16, 8);
        assert!(noon[2] > noon[0]);
        assert!(sunset[0] / sunset[2] > 1.5 * noon[0] / noon[2], "{noon:?} {sunset:?}");
    }

    #[test]
    fn the_horizon_differs_from_the_zenith() {
        let (params, eye) = earth();
        let up = sum(compute_single_scatter(eye, Vec3::Y, Vec3::Y, &params, 16, 8));
        let level = sum(compute_single_scatter(eye, Vec3::X, Vec3::Y, &params, 16, 8));
        assert!((up - level).abs() > 0.1 * up);
    }

    #[test]
    fn no_step_in_the_sky_just_above_the_horizon() {
        let (params, eye) = earth();
        let colors: Vec<[f32; 3]> = (0..50)
            .map(|i| {
                let a = 1e-3 * (i as f32 + 1.0);
                compute_single_scatter(eye, Vec3::new(a.cos(), a.sin(), 0.0), Vec3::Y, &params, 16, 8)
            })
            .collect();
        for pair in colors.windows(2) {
            let step: f32 = (0..3).map(|c| (pair[1][c] - pair[0][c]).abs()).sum();
            assert!(step < 0.05 * sum(pair[1]), "{pair:?}");
        }
    }

    #[test]
    fn night_is_dark_and_twilight_is_not() {
        let (params, eye) = earth();
        let light = |degrees: f32| {
            let a = degrees.to_radians();
            sum(compute_single_scatter(eye, Vec3::Y, Vec3::new(a.cos(), -a.sin(), 0.0), &params, 64, 16))
        };
        assert!(light(4.0) > 0.0 && light(4.0) < 0.02 * light(-30.0));
        assert_eq!(light(30.0), 0.0);
    }

    #[test]
    fn nonsense_is_black_and_never_a_panic() {
        let (params, eye) = earth();
        let scatter = |eye, look, n, m| compute_single_scatter(eye, look, Vec3::Y, &params, n, m);
        for (eye, look) in
            [(Vec3::NAN, Vec3::Y), (eye, Vec3::ZERO), (Vec3::ZERO, Vec3::Y), (eye, Vec3::INFINITY)]
        {
            assert_eq!(scatter(eye, look, 16, 8), [0.0; 3]);
        }
        let once = scatter(eye, Vec3::Y, 0, 0);
        assert_eq!(once, scatter(eye, Vec3::Y, 1, 1));
        assert!(once.iter().all(|v| v.is_finite() && *v > 0.0));
        let broken = AtmosphereParams { planet_radius: f64::NAN, ..params.clone() };
        assert_eq!(compute_single_scatter(eye, Vec3::Y, Vec3::Y, &broken, 16, 8), [0.0; 3]);
    }

    #[test]
    fn the_march_converges_to_the_adaptive_integral() {
        let params = AtmosphereParams::earth();
        for (altitude, view, sun) in
            [(1.7, 0.0f64, 0.5f64), (1.7, 1.5, 1.2), (1.7, 1.57, 1.6), (5e3, 1.62, 1.0), (2e5, 1.85, 1.3)]
        {
            let query = RayQuery::new(altitude, view, sun, 0.4);
            let exact = single_scattering(&params, &query, Sun::Point, Tolerance::TRUTH).unwrap();
            let camera = DVec3::Z * (params.planet_radius + altitude);
            let march = compute_single_scatter(camera, query.direction, query.sun, &params, 4096, 512);
            for c in 0..3 {
                let ratio = f64::from(march[c]) / exact.radiance[c];
                assert!((ratio - 1.0).abs() < 1e-3, "{altitude} {view} {sun} channel {c}: {ratio}");
            }
        }
    }

    #[test]
    fn the_ray_may_start_anywhere() {
        let params = AtmosphereParams::earth();
        let light = |altitude: f64, view: f64| {
            let query = RayQuery::new(altitude, view, 1.0, 0.0);
            single_scattering(&params, &query, Sun::Point, Tolerance::TRUTH).unwrap()
        };
        // Below the ground counts as on it.
        assert_eq!(light(-11_000.0, 0.5), light(0.0, 0.5));
        assert_eq!(light(0.0, 2.0).per_irradiance, [0.0; 3]);
        assert_eq!(light(0.0, 2.0).ends_at, RayEnd::Ground);
        // From 1 au, straight down, as from the top.
        let (far, near) =
            (light(1.5e11, std::f64::consts::PI), light(params.thickness(), std::f64::consts::PI));
        for c in 0..3 {
            assert!((far.per_irradiance[c] / near.per_irradiance[c] - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn a_scene_object_splits_a_ray_without_loss() {
        let params = AtmosphereParams::earth();
        let query = RayQuery::new(3000.0, 1.6, 1.3, 0.7);
        let solve = |q: &RayQuery| single_scattering(&params, q, Sun::Point, Tolerance::TRUTH).unwrap();
        let whole = solve(&query);
        let length = 40_000.0;
        let front = solve(&query.ended_at(length));
        assert_eq!(front.ends_at, RayEnd::Object);
        // The rest of the ray, from the object on, in its own zenith frame.
        let position = DVec3::Z * (params.planet_radius + 3000.0) + query.direction * length;
        let rest = RayQuery::in_world(position, query.direction, query.sun, params.planet_radius).unwrap();
        let rest = solve(&rest);
        for c in 0..3 {
            let joined = front.per_irradiance[c] + front.transmittance[c] * rest.per_irradiance[c];
            assert!((joined / whole.per_irradiance[c] - 1.0).abs() < 3e-6, "channel {c}");
            let t = front.transmittance[c] * rest.transmittance[c];
            assert!((t / whole.transmittance[c] - 1.0).abs() < 1e-8, "channel {c}");
        }
    }

    #[test]
    fn a_sun_disk_softens_the_terminator_and_nothing_else() {
        let params = AtmosphereParams::earth();
        let solve = |sun_zenith: f64, sun| {
            single_scattering(&params, &RayQuery::new(0.0, 0.3, sun_zenith, 2.0), sun, Tolerance::TRUTH)
                .unwrap()
                .per_irradiance
        };
        let disk = Sun::Disk { rings: 4 };
        let day = solve(0.7, disk)[1] / solve(0.7, Sun::Point)[1];
        assert!((day - 1.0).abs() < 1e-4, "{day}");
        // Where brightness falls steeply and curves upwards, averaging over the disk raises it.
        let dusk = solve(1.70, disk)[1] / solve(1.70, Sun::Point)[1];
        assert!(dusk > 1.001 && dusk < 1.2, "{dusk}");
    }

    #[test]
    fn bad_queries_name_the_field() {
        let params = AtmosphereParams::earth();
        let good = RayQuery::new(0.0, 0.3, 1.0, 0.0);
        for (query, field) in [
            (RayQuery { altitude: f64::NAN, ..good }, "ray.altitude"),
            (RayQuery { direction: DVec3::ZERO, ..good }, "ray.direction"),
            (RayQuery { sun: DVec3::NAN, ..good }, "ray.sun"),
            (good.ended_at(-1.0), "ray.length"),
        ] {
            let error = single_scattering(&params, &query, Sun::Point, Tolerance::PICTURE).unwrap_err();
            assert!(error.to_string().starts_with(field), "{error}");
        }
        let error =
            single_scattering(&params, &good, Sun::Disk { rings: 0 }, Tolerance::PICTURE).unwrap_err();
        assert!(error.to_string().starts_with("sun.rings"), "{error}");
    }
}
