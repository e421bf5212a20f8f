//! Multiple scattering to convergence by successive orders, with a Lambertian ground.
//!
//! Under a parallel sun the light at a point of a spherical atmosphere depends on its altitude and on the
//! sun's zenith angle there. So a two-dimensional table suffices, and each entry holds the radiance there as
//! moments over spherical harmonics: scattering is then a product per moment (see `harmonics`), exact for
//! Rayleigh with degree 2 and as good as the degree for aerosols. Light that is scattered once more is
//! gathered along rays from every table point (the scheme of Bruneton & Neyret 2008, algorithm 4.1, with
//! moments in place of their tables of directions), until nothing changes; Anderson's mixing shortens that.
//!
//! The table only feeds further scattering. What was scattered once is seen through [`super::single`],
//! adaptively, for each ray asked for.
//!
//! A finite degree cuts off the sharpest part of the aureole. Moments beyond it hold only light that was
//! turned by small angles at each event, for which there is a closed form: after n events on an optical depth
//! τ of aerosol, the moment is `χ_l^n τ^(n-1) / (n-1)!` (the small-angle approximation; Goudsmit & Saunderson
//! 1940; van de Hulst 1980). That sum is added along each ray asked for.

#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
mod stored;

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::geometry::{Chord, RayEnd};
use super::harmonics;
use super::medium::{ColumnRule, Medium};
use super::parallel;
use super::single::{Line, RayQuery, SmallAngles, SunLine, Tolerance, scatter, view_breaks};
use crate::error::{Error, Result, in_range};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::quadrature::{gauss_legendre, integrate};

#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
pub use stored::NotRestored;

/// Sizes of the tables and sums of [`Orders::solve`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Table rows: altitudes from the ground to the top, denser below. 4 to 256.
    pub altitudes: u32,
    /// Table columns: zenith angles of the sun, denser around sunset. 8 to 512.
    pub sun_angles: u32,
    /// Directions of view above the horizon, and as many below. 4 to 128.
    pub zeniths: u32,
    /// Directions of view in half a turn of azimuth. 4 to 256.
    pub azimuths: u32,
    /// Highest degree of spherical harmonics kept; 2 is exact without aerosols (and all that is used
    /// then). 12 is enough for thin haze with g = 0.8, dense dust with g = 0.86 (Mars) wants 24: with 12
    /// its blue sunset sky comes out half as bright as it is, opposite the sun near the horizon.
    /// [`Settings::for_medium`] chooses. 2 to 64, less than `azimuths`.
    pub degree: u32,
    /// Iterations after which to stop at the latest, 1 to 10 000. Earth needs 5 to 10, dense haze 40.
    pub max_iterations: u32,
    /// Largest relative error of a table entry that iterating may leave. 1e-8 to 0.1.
    pub tolerance: f64,
}

impl Settings {
    /// For Earth and its gas alone, within the larger of 0.5 % and 4 standard errors of the Monte Carlo
    /// tables of `tests/data` everywhere; Earth takes about 10 s of one core. Too few moments for Mars:
    /// [`Self::for_medium`].
    pub const QUICK: Self = Self {
        altitudes: 12,
        sun_angles: 40,
        zeniths: 14,
        azimuths: 14,
        degree: 12,
        max_iterations: 100,
        tolerance: 1e-3,
    };

    /// As [`Self::QUICK`], and within 3.7 standard errors everywhere; Earth takes one to two minutes of one
    /// core.
    pub const FINE: Self = Self {
        altitudes: 20,
        sun_angles: 72,
        zeniths: 16,
        azimuths: 20,
        degree: 16,
        max_iterations: 100,
        tolerance: 1e-4,
    };

    /// These settings with the moments that the aerosol of a medium wants: where |g| is above 0.82 (Mars'
    /// blue) at least degree 24, and azimuths to resolve it. Otherwise they stay as they are.
    #[must_use]
    pub fn for_medium(self, params: &AtmosphereParams) -> Self {
        let aerosol = params.mie_scattering.iter().zip(params.mie_asymmetry);
        if !aerosol.into_iter().any(|(scattering, g)| *scattering > 0.0 && g.abs() > 0.82) {
            return self;
        }
        let degree = self.degree.max(24);
        Self { degree, azimuths: self.azimuths.max(degree + 4), ..self }
    }

    fn validate(&self) -> Result<()> {
        in_range("settings.altitudes", f64::from(self.altitudes), 4.0, 256.0, "")?;
        in_range("settings.sun_angles", f64::from(self.sun_angles), 8.0, 512.0, "")?;
        in_range("settings.zeniths", f64::from(self.zeniths), 4.0, 128.0, "")?;
        in_range("settings.azimuths", f64::from(self.azimuths), 4.0, 256.0, "")?;
        in_range("settings.degree", f64::from(self.degree), 2.0, f64::from(self.azimuths.min(65) - 1), "")?;
        in_range("settings.max_iterations", f64::from(self.max_iterations), 1.0, 1e4, "")?;
        in_range("settings.tolerance", self.tolerance, 1e-8, 0.1, "")?;
        Ok(())
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self::FINE
    }
}

/// What [`Orders::solve`] tells after each iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// From 1.
    pub iteration: u32,
    /// Largest relative change of a table entry.
    pub change: f64,
    /// Estimated ratio of successive orders of scattering, 0 to 1; what is still missing is about
    /// `change / (1 - ratio)`.
    pub ratio: f64,
}

/// Light along a ray, all orders of scattering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiance {
    /// All light per unit solar irradiance, 1/sr: scattered once, scattered more often, and reflected by
    /// the ground if the ray ends there. Without the sun's own disk.
    pub per_irradiance: [f64; 3],
    /// The part of it that was scattered once, by the air alone.
    pub single: [f64; 3],
    /// The part of it that comes straight from the ground, through the air.
    pub ground: [f64; 3],
    /// `per_irradiance` × [`AtmosphereParams::sun_intensity`].
    pub radiance: [f64; 3],
    /// Share of light that gets through from the ray's end.
    pub transmittance: [f64; 3],
    /// What ends the ray.
    pub ends_at: RayEnd,
}

/// Irradiance of level ground per unit solar irradiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundIrradiance {
    /// From the sun's disk.
    pub direct: [f64; 3],
    /// From the sky, all orders of scattering.
    pub diffuse: [f64; 3],
}

/// The nodes of the table.
#[derive(Clone, Debug)]
struct Grid {
    altitudes: Vec<f64>,
    sun_angles: Vec<f64>,
    top: f64,
    /// Altitude grows like `exp(steepness x²) - 1`. The square, because the horizon's dip and with it the
    /// share of the ground in the view go with the root of the altitude: in x that is smooth.
    steepness: f64,
    /// Middle and half width, radians, of the twilight in which sun angles crowd.
    twilight: (f64, f64),
    /// [`Self::stretch`] of the first and the last sun angle.
    stretched: [f64; 2],
}

/// How much denser the sun angles are in twilight than at noon.
const TWILIGHT_DENSITY: f64 = 7.0;

impl Grid {
    fn new(params: &AtmosphereParams, settings: &Settings) -> Self {
        let top = params.thickness();
        let mut scale = params.rayleigh_scale_height;
        if params.mie_extinction().iter().any(|&v| v > 0.0) {
            scale = scale.min(params.mie_scale_height);
        }
        // Where the top of the air still sees the sun when the ground does not.
        let dip = (params.planet_radius / params.atmosphere_radius).acos();
        let mut grid = Self {
            altitudes: vec![],
            sun_angles: vec![],
            top,
            steepness: (1.0 + top / (8.0 * scale)).ln().clamp(0.5, 9.0),
            twilight: (FRAC_PI_2 + 0.5 * dip, (0.8 * dip).clamp(0.05, 0.7)),
            stretched: [0.0; 2],
        };
        let n = settings.altitudes as usize;
        grid.altitudes = (0..n)
            .map(|i| {
                let x = i as f64 / (n - 1) as f64;
                top * (grid.steepness * x * x).exp_m1() / grid.steepness.exp_m1()
            })
            .collect();
        let n = settings.sun_angles as usize;
        let [first, last] = [0.0, PI].map(|angle| grid.stretch(angle));
        grid.stretched = [first, last];
        grid.sun_angles = (0..n)
            .map(|i| {
                let target = first + (last - first) * i as f64 / (n - 1) as f64;
                let (mut lo, mut hi) = (0.0, PI);
                for _ in 0..60 {
                    let middle = 0.5 * (lo + hi);
                    if grid.stretch(middle) < target { lo = middle } else { hi = middle }
                }
                0.5 * (lo + hi)
            })
            .collect();
        grid
    }

    fn stretch(&self, angle: f64) -> f64 {
        let (middle, width) = self.twilight;
        angle + TWILIGHT_DENSITY * width * ((angle - middle) / width).atan()
    }

    /// First of four neighbouring altitudes, and their weights.
    fn altitude_weights(&self, altitude: f64) -> (usize, [f64; 4]) {
        let x = (altitude.clamp(0.0, self.top) / self.top * self.steepness.exp_m1()).ln_1p() / self.steepness;
        cubic(x.sqrt() * (self.altitudes.len() - 1) as f64, self.altitudes.len())
    }

    /// First of four neighbouring sun angles, and their weights, by the cosine of the sun's zenith angle.
    fn sun_weights(&self, mu: f64) -> (usize, [f64; 4]) {
        let [first, last] = self.stretched;
        let x = (self.stretch(mu.clamp(-1.0, 1.0).acos()) - first) / (last - first);
        cubic(x * (self.sun_angles.len() - 1) as f64, self.sun_angles.len())
    }
}

/// Lagrange's cubic through four of `n ≥ 4` equidistant nodes around `x` (counted in nodes).
fn cubic(x: f64, n: usize) -> (usize, [f64; 4]) {
    let first = (x.floor() as isize - 1).clamp(0, n as isize - 4) as usize;
    let t = x - first as f64;
    let (t1, t2, t3) = (t - 1.0, t - 2.0, t - 3.0);
    (first, [-t1 * t2 * t3 / 6.0, t * t2 * t3 / 2.0, -t * t1 * t3 / 2.0, t * t1 * t2 / 6.0])
}

/// Radiance over the table: one order's, or the sum of several.
#[derive(Clone, Debug)]
struct Field {
    /// `[((altitude × sun angles + sun angle) × moments + (l, m)) × 3 + channel]`.
    moments: Vec<f64>,
    /// Diffuse irradiance of the ground, by sun angle.
    ground: Vec<[f64; 3]>,
}

impl Field {
    fn add(&mut self, other: &Self) {
        for (a, b) in self.moments.iter_mut().zip(&other.moments) {
            *a += b;
        }
        for (a, b) in self.ground.iter_mut().zip(&other.ground) {
            *a = std::array::from_fn(|c| a[c] + b[c]);
        }
    }
}

/// A field ready for interpolation. In twilight brightness falls by a factor e within a degree; so each
/// entry is divided by the mean radiance there, and that is interpolated in its logarithm.
#[derive(Clone, Debug)]
struct Interpolant {
    log_mean: Vec<f64>,
    /// As [`Field::moments`], over the mean.
    ratio: Vec<f64>,
    /// From this sun angle on there is no light to speak of, at any altitude.
    night: usize,
    log_ground: Vec<f64>,
    ground_ratio: Vec<[f64; 3]>,
}

impl Interpolant {
    fn new(field: &Field, moments: usize, suns: usize) -> Self {
        let normalised = |means: Vec<f64>| {
            let floor = (means.iter().fold(0.0, |a: f64, &b| a.max(b)) * 1e-14).max(1e-280);
            means.into_iter().map(|v| (v.max(0.0) + floor).ln()).collect::<Vec<f64>>()
        };
        let log_mean = normalised(
            field.moments.chunks_exact(3 * moments).map(|m| m[..3].iter().sum::<f64>() / 3.0).collect(),
        );
        let log_ground = normalised(field.ground.iter().map(|e| e.iter().sum::<f64>() / 3.0).collect());
        let mut ratio = field.moments.clone();
        for (entry, log) in ratio.chunks_exact_mut(3 * moments).zip(&log_mean) {
            let scale = (-log).exp();
            entry.iter_mut().for_each(|v| *v *= scale);
        }
        let ground_ratio =
            field.ground.iter().zip(&log_ground).map(|(e, log)| e.map(|v| v * (-log).exp())).collect();
        let brightest = log_mean.iter().fold(f64::NEG_INFINITY, |a, &b| a.max(b));
        let lit = |(_, log): &(usize, &f64)| **log > brightest - 28.0;
        let night = log_mean.iter().enumerate().filter(lit).map(|(i, _)| i % suns + 1).max().unwrap_or(0);
        Self { log_mean, ratio, night, log_ground, ground_ratio }
    }

    /// Diffuse irradiance of the ground for weights of sun angles.
    fn ground(&self, (first, weights): (usize, [f64; 4])) -> [f64; 3] {
        let (mut log, mut ratio) = (0.0, [0.0; 3]);
        for (k, w) in weights.iter().enumerate() {
            log += w * self.log_ground[first + k];
            for c in 0..3 {
                ratio[c] += w * self.ground_ratio[first + k][c];
            }
        }
        ratio.map(|v| (v * log.exp()).max(0.0))
    }
}

/// Multiple scattering in one atmosphere, solved. See the module's text for the method.
#[derive(Clone, Debug)]
pub struct Orders {
    medium: Medium,
    settings: Settings,
    grid: Grid,
    degree: usize,
    /// Moments of the aerosol's phase function: `[channel][l]`.
    mie: [Vec<f64>; 3],
    total: Interpolant,
    history: Vec<Progress>,
    converged: bool,
}

impl Orders {
    /// Solves for an atmosphere; calls `progress` after each iteration.
    ///
    /// Runs on all cores with the cargo feature `reference`. Time grows with
    /// `altitudes × sun_angles × zeniths × azimuths × degree × iterations`.
    ///
    /// # Errors
    /// Parameters that [`AtmosphereParams::validate`] refuses; settings out of range.
    ///
    /// # Limits
    /// Beyond `settings.degree` light is taken for turned by small angles only; with an aerosol of |g| above
    /// 0.9 raise the degree. Entries below 1e-6 of the brightest (deep night) are not waited for.
    ///
    /// Thick cloud is beyond this method: what interpolation loses at each of hundreds of scattering events
    /// adds up. Haze and gas of a vertical scattering depth of 7 together agree with [`super::path`] within
    /// 1.4 % (its noise: 0.4 to 0.9 %); at 20 (Venus has 37 to 68) the iteration does not settle, and
    /// [`Self::converged`] says so: use
    /// [`super::path::path_trace`] there.
    pub fn solve(
        params: &AtmosphereParams,
        settings: Settings,
        mut progress: impl FnMut(Progress),
    ) -> Result<Self> {
        let mut solved = Self::unsolved(params, settings)?;
        let degree = solved.degree;
        let first = solved.first_order();
        let mut mixer = Anderson::default();
        let mut light = solved.first_guess(&first);
        for iteration in 1..=settings.max_iterations {
            // All light is what was scattered once, and all light scattered once more.
            let mut next = solved.scatter_once_more(&light);
            next.add(&first);
            let change = solved.change(&light, &next);
            let ratio = mixer.ratio(&light, &next);
            let step = Progress { iteration, change, ratio };
            solved.history.push(step);
            progress(step);
            // What is still missing is a geometric series.
            if change <= settings.tolerance * (1.0 - ratio).max(1e-3) {
                solved.converged = true;
                light = next;
                break;
            }
            light = mixer.mix(light, next, harmonics::count(degree));
        }
        solved.total = Interpolant::new(&light, harmonics::count(degree), settings.sun_angles as usize);
        Ok(solved)
    }

    /// All but the tables.
    fn unsolved(params: &AtmosphereParams, settings: Settings) -> Result<Self> {
        params.validate()?;
        settings.validate()?;
        let medium = Medium::new(params);
        let aerosol = params.mie_scattering.iter().any(|&v| v > 0.0);
        let degree = if aerosol { settings.degree as usize } else { 2 };
        let mie = params.mie_asymmetry.map(|g| harmonics::mie_moments(params.mie_phase, g, degree));
        let grid = Grid::new(&medium.from_ground, &settings);
        let empty = Interpolant {
            log_mean: vec![],
            ratio: vec![],
            night: 0,
            log_ground: vec![],
            ground_ratio: vec![],
        };
        Ok(Self { medium, settings, grid, degree, mie, total: empty, history: vec![], converged: false })
    }

    /// The medium that was solved for.
    pub fn params(&self) -> &AtmosphereParams {
        &self.medium.params
    }

    /// What [`Self::solve`] reported.
    pub fn history(&self) -> &[Progress] {
        &self.history
    }

    /// Whether `settings.tolerance` was met within `settings.max_iterations`.
    pub fn converged(&self) -> bool {
        self.converged
    }

    /// Light along a ray. `tolerance` concerns the integrals along the ray; the tables add their own error.
    ///
    /// # Errors
    /// A query or tolerance out of range; a moon in the query, whose shadow the solution, symmetric about the
    /// planet's axis towards the sun, does not have.
    pub fn radiance(&self, query: &RayQuery, tolerance: Tolerance) -> Result<Radiance> {
        tolerance.validate()?;
        let query = query.validate(&self.medium.params)?;
        if query.moon.is_some() {
            return Err(Error::invalid(
                "ray.moon",
                "a moon",
                "none: its shadow has no symmetry; use reference::path",
            ));
        }
        let params = &self.medium.from_ground;
        let once = scatter(&self.medium, &query, Line::Adaptive(tolerance), None);
        let aerosol = params.mie_scattering.iter().any(|&v| v > 0.0);
        let per_irradiance = match aerosol {
            true => {
                let tail = SmallAngles::new(params, self.degree, query.direction.dot(query.sun));
                scatter(&self.medium, &query, Line::Adaptive(tolerance), Some(&tail)).per_irradiance
            }
            false => once.per_irradiance,
        };
        let mut out = Radiance {
            per_irradiance,
            single: once.per_irradiance,
            ground: [0.0; 3],
            radiance: [0.0; 3],
            transmittance: once.transmittance,
            ends_at: once.ends_at,
        };
        let d = query.direction;
        let chord = Chord::new(params.planet_radius, query.altitude, d.z, d.x.hypot(d.y));
        if let Some((s0, s1, _)) = chord.clip(self.medium.top, query.length) {
            let sun = SunLine::new(chord, params.planet_radius, d, query.sun);
            let nu = d.dot(query.sun);
            let rule = tolerance.columns();
            let mut harmonics = Vec::new();
            let mut breaks = Vec::with_capacity(24);
            let (a, b) = (chord.v_at(s0), chord.v_at(s1));
            view_breaks(&self.medium, &chord, s0, a, b, 5.0, &mut breaks);
            let integrand = |v: f64| {
                let (s, jacobian) = chord.at_v(v);
                let altitude = (chord.perigee_altitude + v * v).max(0.0);
                let through = self.medium.optical_depth(self.medium.columns(&chord, s0, s, rule));
                let r = chord.radius(s);
                let mu = if r > 0.0 { (s / r).clamp(-1.0, 1.0) } else { 1.0 };
                let source = self.source(altitude, sun.mu(s), mu, nu, &mut harmonics);
                std::array::from_fn(|c| source[c] * (-through[c]).exp() * jacobian)
            };
            // Multiple scattering is smooth but its tables are not exact: a tenth of the tolerance is no use.
            let more = integrate(integrand, &breaks, tolerance.relative.max(1e-5), 1e-40, 200);
            if out.ends_at == RayEnd::Ground {
                let irradiance = self.ground_irradiance_at(sun.mu(s1));
                for c in 0..3 {
                    let reflected =
                        params.ground_albedo[c] / PI * (irradiance.direct[c] + irradiance.diffuse[c]);
                    out.ground[c] = out.transmittance[c] * reflected;
                }
            }
            for c in 0..3 {
                // Further orders take no light away. A phase function's expansion that is too short for its
                // peak may, in air that is thick enough.
                let scattered = (out.per_irradiance[c] + more.value[c]).max(once.per_irradiance[c]);
                out.per_irradiance[c] = scattered + out.ground[c];
            }
        }
        out.radiance = out.per_irradiance.map(|v| v * params.sun_intensity);
        Ok(out)
    }

    /// Irradiance of level ground per unit solar irradiance, for a sun zenith angle in radians.
    pub fn ground_irradiance(&self, sun_zenith: f64) -> GroundIrradiance {
        self.ground_irradiance_at(if sun_zenith.is_finite() { sun_zenith.cos() } else { -1.0 })
    }

    fn ground_irradiance_at(&self, mu: f64) -> GroundIrradiance {
        GroundIrradiance {
            direct: self.direct_irradiance(mu),
            diffuse: self.total.ground(self.grid.sun_weights(mu)),
        }
    }

    fn direct_irradiance(&self, mu: f64) -> [f64; 3] {
        if mu <= 0.0 {
            return [0.0; 3];
        }
        let up = Chord::new(
            self.medium.from_ground.planet_radius,
            0.0,
            mu,
            ((1.0 - mu) * (1.0 + mu)).max(0.0).sqrt(),
        );
        match self.medium.columns_to_sun(&up, ColumnRule::Quick) {
            Some(columns) => self.medium.optical_depth(columns).map(|t| mu * (-t).exp()),
            None => [0.0; 3],
        }
    }

    /// Share of light that leaves the planet for space, of all that the air and the ground take from
    /// the beam, red, green, blue. With no absorption and white ground it is 1: the furnace test.
    ///
    /// Integrates the radiance that crosses the top outwards over all directions and sun angles.
    pub fn escaping_share(&self, directions: u32) -> [f64; 3] {
        let p = &self.medium.from_ground;
        let n = directions.clamp(2, 128) as usize;
        let ratio = p.planet_radius / p.atmosphere_radius;
        // What is taken from the beam, over the cross-section π R²: all that meets the ground or the shell.
        let mut taken = [ratio * ratio; 3];
        for (x, w) in gauss_legendre(64) {
            // Impact altitudes, crowded near the ground: the chord through each.
            let u = 0.5 * (x + 1.0);
            let altitude = self.medium.top * u * u;
            let weight = w * self.medium.top * u;
            let chord = Chord::new(p.planet_radius, altitude, 0.0, 1.0);
            let end = chord.at_altitude(self.medium.top).unwrap_or(0.0);
            let through =
                self.medium.optical_depth(self.medium.columns(&chord, -end, end, ColumnRule::Precise));
            let ring = 2.0 * (p.planet_radius + altitude) / (p.atmosphere_radius * p.atmosphere_radius);
            for c in 0..3 {
                taken[c] -= weight * ring * (-through[c]).exp_m1();
            }
        }
        let horizon = (1.0 - ratio * ratio).sqrt();
        let downs: Vec<(f64, f64)> = gauss_legendre(n)
            .into_iter()
            .flat_map(|(x, w)| {
                let u = 0.5 * (x + 1.0);
                // Towards the shell above the horizon, and the disk of the planet below it.
                [
                    (-horizon * (1.0 - u * u), w * u * horizon),
                    (-horizon - (1.0 - horizon) * u * u, w * u * (1.0 - horizon)),
                ]
            })
            .collect();
        let angles = &self.grid.sun_angles;
        let rows = parallel::map(angles.len() - 1, |k| {
            let mut sum = [0.0; 3];
            for (x, w) in gauss_legendre(2) {
                let angle = 0.5 * (angles[k] + angles[k + 1]) + 0.5 * (angles[k + 1] - angles[k]) * x;
                let area = 0.5 * (angles[k + 1] - angles[k]) * w * 2.0 * angle.sin();
                for &(mu, weight) in &downs {
                    for i in 0..n {
                        let azimuth = PI * (i as f64 + 0.5) / n as f64;
                        let query =
                            RayQuery::new(self.medium.params.top_altitude(), mu.acos(), angle, azimuth);
                        let Ok(light) = self.radiance(&query, Tolerance::PICTURE) else { continue };
                        for c in 0..3 {
                            sum[c] += area * weight * -mu * 2.0 * PI / n as f64 * light.per_irradiance[c];
                        }
                    }
                }
            }
            sum
        });
        std::array::from_fn(|c| rows.iter().map(|r| r[c]).sum::<f64>() / taken[c])
    }

    /// Scattering coefficient times phase moment: what a moment of radiance becomes, per channel.
    fn moment_factors(&self, altitude: f64) -> Vec<[f64; 3]> {
        let p = &self.medium.from_ground;
        let [gas, aerosol, _] = self.medium.densities(altitude);
        (0..=self.degree)
            .map(|l| {
                std::array::from_fn(|c| {
                    p.rayleigh_scattering[c] * gas * harmonics::rayleigh_moment(l)
                        + p.mie_scattering[c] * aerosol * self.mie[c][l]
                })
            })
            .collect()
    }

    /// Light scattered into a direction per metre, from all orders in the table: altitude, cosines of
    /// the zenith angles of sun and view there, cosine between them.
    fn source(&self, altitude: f64, mu_sun: f64, mu: f64, nu: f64, legendre: &mut Vec<f64>) -> [f64; 3] {
        let n = harmonics::count(self.degree);
        let suns = self.grid.sun_angles.len();
        let (row, row_weights) = self.grid.altitude_weights(altitude);
        let (column, column_weights) = self.grid.sun_weights(mu_sun);
        harmonics::legendre(self.degree, mu, legendre);
        let cos = azimuth_cosine(mu_sun, mu, nu);
        let factors = self.moment_factors(altitude);
        // Moments that matter here: far above the aerosols only those of the gas.
        let mut significant = [self.degree; 3];
        for c in 0..3 {
            while significant[c] > 2 && factors[significant[c]][c] < 3e-5 * factors[0][c] {
                significant[c] -= 1;
            }
        }
        let degree = significant[0].max(significant[1]).max(significant[2]);
        let (mut previous, mut current) = (cos, 1.0);
        for m in 0..=degree {
            for l in m..=degree {
                legendre[harmonics::index(self.degree, l, m)] *= current;
            }
            (previous, current) = (current, 2.0 * cos * current - previous);
        }
        let (mut log, mut sum) = (0.0, [0.0; 3]);
        for (i, wi) in row_weights.iter().enumerate() {
            for (k, wk) in column_weights.iter().enumerate() {
                let entry = (row + i) * suns + column + k;
                let w = wi * wk;
                log += w * self.total.log_mean[entry];
                let ratios = &self.total.ratio[entry * n * 3..(entry + 1) * n * 3];
                for m in 0..=degree {
                    let at = harmonics::index(self.degree, m, m);
                    for l in m..=degree {
                        let y = w * legendre[at + l - m];
                        let ratio = &ratios[(at + l - m) * 3..(at + l - m) * 3 + 3];
                        for c in 0..3 {
                            sum[c] += y * ratio[c] * factors[l][c];
                        }
                    }
                }
            }
        }
        let mean = log.exp();
        sum.map(|v| (v * mean).max(0.0))
    }

    /// Directions of view at a table row: cosine, sine and weight (of the cosine), split at the horizon and
    /// crowded around it.
    fn view_cosines(&self, altitude: f64) -> Vec<(f64, f64)> {
        let r = self.medium.from_ground.planet_radius + altitude;
        let horizon = -(altitude * (r + self.medium.from_ground.planet_radius)).sqrt() / r;
        gauss_legendre(self.settings.zeniths as usize)
            .into_iter()
            .flat_map(|(x, w)| {
                let u = 0.5 * (x + 1.0);
                let up = (horizon + (1.0 - horizon) * u * u, w * u * (1.0 - horizon));
                let down = (horizon - (1.0 + horizon) * u * u, w * u * (1.0 + horizon));
                [up, down]
            })
            .collect()
    }

    /// Radiance after one scattering event or one reflection by the ground.
    fn first_order(&self) -> Field {
        self.gather(|altitude, mu, angles, out| {
            let p = &self.medium.from_ground;
            let sin = ((1.0 - mu) * (1.0 + mu)).max(0.0).sqrt();
            for (k, &sun_angle) in self.grid.sun_angles.iter().enumerate() {
                for (f, &azimuth) in angles.iter().enumerate() {
                    let query = RayQuery {
                        altitude,
                        direction: DVec3::new(sin * azimuth.cos(), sin * azimuth.sin(), mu),
                        sun: DVec3::new(sun_angle.sin(), 0.0, sun_angle.cos()),
                        length: f64::INFINITY,
                        moon: None,
                    };
                    let light = scatter(&self.medium, &query, Line::Fixed, None);
                    let mut radiance = light.per_irradiance;
                    if light.ends_at == RayEnd::Ground {
                        let chord = Chord::new(p.planet_radius, altitude, mu, sin);
                        let sun = SunLine::new(chord, p.planet_radius, query.direction, query.sun);
                        let end = chord
                            .clip(self.medium.top, f64::INFINITY)
                            .map_or(chord.origin, |(_, end, _)| end);
                        let direct = self.direct_irradiance(sun.mu(end));
                        for c in 0..3 {
                            radiance[c] += light.transmittance[c] * p.ground_albedo[c] / PI * direct[c];
                        }
                    }
                    out[k * angles.len() + f] = radiance;
                }
            }
        })
    }

    /// Where to start: light scattered once, and in the depth of a cloud, where hardly any of that arrives,
    /// a tenth of the brightest above it, alike from all sides.
    fn first_guess(&self, first: &Field) -> Field {
        let mut guess = first.clone();
        let stride = 3 * harmonics::count(self.degree);
        let suns = self.grid.sun_angles.len();
        for k in 0..suns {
            let rows = (0..self.grid.altitudes.len()).map(|row| (row * suns + k) * stride);
            for c in 0..3 {
                let least = 0.1 * rows.clone().map(|at| first.moments[at + c]).fold(0.0, f64::max);
                for at in rows.clone() {
                    guess.moments[at + c] = guess.moments[at + c].max(least);
                }
                // The zeroth moment is the mean times the root of 4 π; a hemisphere of it gives π times the
                // mean.
                guess.ground[k][c] = guess.ground[k][c].max(least * PI / (4.0 * PI).sqrt());
            }
        }
        guess
    }

    /// Radiance after one more scattering event or reflection than that of `last`.
    fn scatter_once_more(&self, last: &Field) -> Field {
        let n = harmonics::count(self.degree);
        let suns = self.grid.sun_angles.len();
        let last = Interpolant::new(last, n, suns);
        let bands = self.degree + 1;
        let p = &self.medium.from_ground;
        self.gather(|altitude, mu, angles, out| {
            out.fill([0.0; 3]);
            let sin = ((1.0 - mu) * (1.0 + mu)).max(0.0).sqrt();
            let chord = Chord::new(p.planet_radius, altitude, mu, sin);
            let Some((s0, s1, ends_at)) = chord.clip(self.medium.top, f64::INFINITY) else { return };
            let r0 = p.planet_radius + altitude;
            let mut breaks = Vec::new();
            view_breaks(&self.medium, &chord, s0, chord.v_at(s0), chord.v_at(s1), 2.0, &mut breaks);
            let mut legendre = Vec::new();
            // Per sun angle: the logarithm of the mean radiance, and per cos(m φ) and channel the source.
            let mut log_mean = vec![0.0; suns];
            let mut bands_at = vec![0.0; suns * bands * 3];
            // Sums over the four rows and columns of an interpolation, channel by channel.
            let mut ratio = vec![0.0; n * 3];
            let mut wave = vec![0.0; bands * 3];
            let mut turned = vec![0.0; n * 3];
            let cos_sun: Vec<f64> = self.grid.sun_angles.iter().map(|a| a.cos()).collect();
            let nu: Vec<f64> = self
                .grid
                .sun_angles
                .iter()
                .flat_map(|a| angles.iter().map(move |f| mu * a.cos() + sin * a.sin() * f.cos()))
                .collect();
            for panel in breaks.windows(2).filter(|w| w[1] > w[0]) {
                for &(x, w) in crate::model::quadrature::gauss_6() {
                    let v = 0.5 * (panel[0] + panel[1]) + 0.5 * (panel[1] - panel[0]) * x;
                    let (s, jacobian) = chord.at_v(v);
                    let h = (chord.perigee_altitude + v * v).max(0.0);
                    let depth =
                        self.medium.optical_depth(self.medium.columns(&chord, s0, s, ColumnRule::Quick));
                    let weight = depth.map(|t| (-t).exp() * w * 0.5 * (panel[1] - panel[0]) * jacobian);
                    let factors = self.moment_factors(h);
                    if (0..3).all(|c| weight[c] * factors[0][c] < 1e-9) {
                        continue;
                    }
                    let r = chord.radius(s);
                    let mu_there = (s / r).clamp(-1.0, 1.0);
                    harmonics::legendre(self.degree, mu_there, &mut legendre);
                    let (row, row_weights) = self.grid.altitude_weights(h);
                    log_mean.fill(0.0);
                    bands_at.fill(0.0);
                    let mut used = self.degree;
                    while used > 2 && (0..3).all(|c| factors[used][c] < 1e-5 * factors[0][c]) {
                        used -= 1;
                    }
                    for m in 0..=used {
                        let at = harmonics::index(self.degree, m, m);
                        let of_band = turned[at * 3..(at + used - m + 1) * 3].chunks_exact_mut(3);
                        for ((out, y), factor) in of_band.zip(&legendre[at..]).zip(&factors[m..]) {
                            out.copy_from_slice(&factor.map(|f| f * y));
                        }
                    }
                    for k in 0..suns {
                        let entry = |i: usize| (row + i) * suns + k;
                        log_mean[k] = (0..4).map(|i| row_weights[i] * last.log_mean[entry(i)]).sum();
                        let of = |i| &last.ratio[entry(i) * n * 3..(entry(i) + 1) * n * 3];
                        weighted_sum(row_weights, [of(0), of(1), of(2), of(3)], &mut ratio);
                        for m in 0..=used {
                            let at = harmonics::index(self.degree, m, m);
                            let all = at * 3..(at + used - m + 1) * 3;
                            let mut band = [0.0; 3];
                            for (ratio, turned) in ratio[all.clone()]
                                .as_chunks::<3>()
                                .0
                                .iter()
                                .zip(turned[all].as_chunks::<3>().0)
                            {
                                for c in 0..3 {
                                    band[c] += ratio[c] * turned[c];
                                }
                            }
                            bands_at[(k * bands + m) * 3..(k * bands + m) * 3 + 3].copy_from_slice(&band);
                        }
                    }
                    let t = s - chord.origin;
                    for k in 0..suns {
                        for f in 0..angles.len() {
                            let nu = nu[k * angles.len() + f];
                            let mu_sun = ((r0 * cos_sun[k] + t * nu) / r).clamp(-1.0, 1.0);
                            let (column, weights) = self.grid.sun_weights(mu_sun);
                            if column >= last.night {
                                continue;
                            }
                            let cos = azimuth_cosine(mu_sun, mu_there, nu);
                            let log: f64 = (0..4).map(|j| weights[j] * log_mean[column + j]).sum();
                            let of = |j| {
                                let at = (column + j) * bands * 3;
                                &bands_at[at..at + (used + 1) * 3]
                            };
                            let wave = &mut wave[..(used + 1) * 3];
                            weighted_sum(weights, [of(0), of(1), of(2), of(3)], wave);
                            let mut sum = [0.0; 3];
                            let (mut previous, mut current) = (cos, 1.0);
                            for band in wave.as_chunks::<3>().0 {
                                for c in 0..3 {
                                    sum[c] += current * band[c];
                                }
                                (previous, current) = (current, 2.0 * cos * current - previous);
                            }
                            let mean = log.exp();
                            let out = &mut out[k * angles.len() + f];
                            for c in 0..3 {
                                out[c] += weight[c] * mean * sum[c];
                            }
                        }
                    }
                }
            }
            if ends_at == RayEnd::Ground {
                let depth = self.medium.optical_depth(self.medium.columns(&chord, s0, s1, ColumnRule::Quick));
                let t = s1 - chord.origin;
                for k in 0..suns {
                    for f in 0..angles.len() {
                        let mu_sun = (r0 * cos_sun[k] + t * nu[k * angles.len() + f]) / p.planet_radius;
                        let ground = last.ground(self.grid.sun_weights(mu_sun));
                        let out = &mut out[k * angles.len() + f];
                        for c in 0..3 {
                            out[c] += (-depth[c]).exp() * p.ground_albedo[c] / PI * ground[c];
                        }
                    }
                }
            }
        })
    }

    /// Moments and ground irradiance of a radiance. `radiance(altitude, cosine of view, azimuths, out)` fills
    /// `out[sun angle × azimuths + azimuth]`.
    fn gather(&self, radiance: impl Fn(f64, f64, &[f64], &mut [[f64; 3]]) + Sync) -> Field {
        let n = harmonics::count(self.degree);
        let suns = self.grid.sun_angles.len();
        let azimuths = self.settings.azimuths as usize;
        let angles: Vec<f64> = (0..azimuths).map(|f| PI * (f as f64 + 0.5) / azimuths as f64).collect();
        let cosines: Vec<f64> =
            (0..=self.degree).flat_map(|m| angles.iter().map(move |a| (m as f64 * a).cos())).collect();
        let rows = parallel::map(self.grid.altitudes.len(), |row| {
            let altitude = self.grid.altitudes[row];
            let mut moments = vec![0.0; suns * n * 3];
            let mut ground = vec![[0.0; 3]; suns];
            let mut light = vec![[0.0; 3]; suns * azimuths];
            let mut legendre = Vec::new();
            for (mu, weight) in self.view_cosines(altitude) {
                radiance(altitude, mu, &angles, &mut light);
                harmonics::legendre(self.degree, mu, &mut legendre);
                for k in 0..suns {
                    for m in 0..=self.degree {
                        let mut wave = [0.0; 3];
                        let light = &light[k * azimuths..(k + 1) * azimuths];
                        for (cosine, light) in cosines[m * azimuths..].iter().zip(light) {
                            let w = weight * 2.0 * PI / azimuths as f64 * cosine;
                            for c in 0..3 {
                                wave[c] += w * light[c];
                            }
                        }
                        let at = harmonics::index(self.degree, m, m);
                        let count = self.degree - m + 1;
                        let moments = &mut moments[(k * n + at) * 3..(k * n + at + count) * 3];
                        for (moment, y) in moments.as_chunks_mut::<3>().0.iter_mut().zip(&legendre[at..]) {
                            for c in 0..3 {
                                moment[c] += y * wave[c];
                            }
                        }
                        if m == 0 && mu > 0.0 {
                            for c in 0..3 {
                                ground[k][c] += mu * wave[c];
                            }
                        }
                    }
                }
            }
            (moments, ground)
        });
        let ground = rows[0].1.clone();
        Field { moments: rows.into_iter().flat_map(|(moments, _)| moments).collect(), ground }
    }

    /// Largest relative change of mean radiance or ground irradiance from one iterate to the next, over all
    /// of the table where it is not night.
    fn change(&self, before: &Field, after: &Field) -> f64 {
        let stride = 3 * harmonics::count(self.degree);
        let brightest = brightest(after, stride);
        let means = before.moments.chunks_exact(stride).zip(after.moments.chunks_exact(stride));
        let ground = before.ground.iter().zip(&after.ground);
        let pairs = means.map(|(a, b)| (&a[..3], &b[..3])).chain(ground.map(|(a, b)| (&a[..], &b[..])));
        let mut change = 0.0;
        for (a, b) in pairs {
            for c in 0..3 {
                if b[c] > NIGHT * brightest[c] {
                    change = f64::max(change, (b[c] - a[c]).abs() / b[c]);
                }
            }
        }
        change
    }
}

/// Share of the brightest entry below which an entry need not be converged.
const NIGHT: f64 = 1e-6;

/// Largest mean radiance (zeroth moment) of a field, per channel.
fn brightest(field: &Field, stride: usize) -> [f64; 3] {
    let mut most = [0.0; 3];
    for entry in field.moments.chunks_exact(stride) {
        most = std::array::from_fn(|c| f64::max(most[c], entry[c]));
    }
    most
}

/// Anderson's mixing of a fixed-point iteration (Walker & Ni 2011): the combination of the last iterates
/// whose change is smallest. It halves the iterations for Earth.
#[derive(Default)]
struct Anderson {
    /// Iterates with their images, the newest last.
    past: Vec<(Field, Field)>,
}

impl Anderson {
    const MEMORY: usize = 8;

    /// How much smaller the difference of two images is than that of their iterates: an estimate, from
    /// below, of the ratio of successive orders of scattering. 0 at first.
    fn ratio(&self, x: &Field, image: &Field) -> f64 {
        let Some((last_x, last_image)) = self.past.last() else { return 0.0 };
        let mut ratio = 0.0;
        for c in 0..3 {
            let distance = |a: &Field, b: &Field| {
                let pairs = a.moments.iter().zip(&b.moments).skip(c).step_by(3);
                pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
            };
            let (before, after) = (distance(x, last_x), distance(image, last_image));
            if before > 0.0 {
                ratio = f64::max(ratio, after / before);
            }
        }
        ratio.min(1.0)
    }

    /// The next iterate. Channels are separate problems and are mixed separately.
    fn mix(&mut self, x: Field, image: Field, moments: usize) -> Field {
        self.past.push((x, image));
        if self.past.len() > Self::MEMORY {
            self.past.remove(0);
        }
        let image = &self.past[self.past.len() - 1].1;
        let mut next = image.clone();
        let n = self.past.len() - 1;
        let stride = 3 * moments;
        let brightest = brightest(image, stride);
        for c in 0..3 {
            // Changes relative to the light that is there, so that dim places count too.
            let residual = |(x, image): &(Field, Field)| -> Vec<f64> {
                let mut out = Vec::with_capacity(x.moments.len() / 3);
                let entries = x.moments.chunks_exact(stride).zip(image.moments.chunks_exact(stride));
                for ((a, b), newest) in entries.zip(self.past[n].1.moments.chunks_exact(stride)) {
                    let weight = 1.0 / (newest[c].max(0.0) + 1e-3 * NIGHT * brightest[c] + 1e-290);
                    out.extend(a.iter().zip(b).skip(c).step_by(3).map(|(a, b)| weight * (b - a)));
                }
                out
            };
            let newest = residual(&self.past[n]);
            let steps: Vec<Vec<f64>> = self.past[..n]
                .iter()
                .map(|pair| residual(pair).iter().zip(&newest).map(|(a, b)| b - a).collect())
                .collect();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let matrix: Vec<Vec<f64>> =
                steps.iter().map(|a| steps.iter().map(|b| dot(a, b)).collect()).collect();
            let right: Vec<f64> = steps.iter().map(|a| dot(a, &newest)).collect();
            let weights = solve_symmetric(matrix, right);
            for (weight, (_, old)) in weights.iter().zip(&self.past) {
                for i in (c..next.moments.len()).step_by(3) {
                    next.moments[i] -= weight * (image.moments[i] - old.moments[i]);
                }
                for i in 0..next.ground.len() {
                    next.ground[i][c] -= weight * (image.ground[i][c] - old.ground[i][c]);
                }
            }
            // Light is positive: where a bold step would end that, take the plain one.
            for at in (0..next.moments.len()).step_by(stride) {
                if next.moments[at + c] < 0.1 * image.moments[at + c] {
                    for i in (at + c..at + stride).step_by(3) {
                        next.moments[i] = image.moments[i];
                    }
                }
            }
            for (bold, plain) in next.ground.iter_mut().zip(&image.ground) {
                if bold[c] < 0.1 * plain[c] {
                    bold[c] = plain[c];
                }
            }
        }
        next
    }
}

/// Solves a symmetric positive semidefinite system by Gaussian elimination, a little regularised.
fn solve_symmetric(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for (i, row) in a.iter_mut().enumerate() {
        row[i] = row[i] * (1.0 + 1e-10) + 1e-300;
    }
    for i in 0..n {
        let pivot = a[i].clone();
        for j in i + 1..n {
            let factor = a[j][i] / pivot[i];
            if !factor.is_finite() {
                return vec![0.0; n];
            }
            for k in i..n {
                a[j][k] -= factor * pivot[k];
            }
            b[j] -= factor * b[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| a[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    if b.iter().all(|v| v.is_finite()) { b } else { vec![0.0; n] }
}

/// The sum of four lists of numbers, each times its weight; `out` and they are equally long.
fn weighted_sum(weights: [f64; 4], [a, b, c, d]: [&[f64]; 4], out: &mut [f64]) {
    for ((((out, a), b), c), d) in out.iter_mut().zip(a).zip(b).zip(c).zip(d) {
        *out = weights[0] * a + weights[1] * b + weights[2] * c + weights[3] * d;
    }
}

/// Cosine of the azimuth between view and sun, from the cosines of their zenith angles and between them.
fn azimuth_cosine(mu_sun: f64, mu: f64, nu: f64) -> f64 {
    let sines = (((1.0 - mu_sun) * (1.0 + mu_sun)) * ((1.0 - mu) * (1.0 + mu))).max(0.0).sqrt();
    if sines > 1e-12 { ((nu - mu * mu_sun) / sines).clamp(-1.0, 1.0) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_gets_settings_that_are_accepted() {
        for name in AtmosphereParams::PRESETS {
            let params = AtmosphereParams::preset(name).unwrap();
            for settings in [Settings::QUICK, Settings::FINE] {
                let chosen = settings.for_medium(&params);
                chosen.validate().unwrap();
                assert_eq!(chosen == settings, name != "mars", "{name}: {chosen:?}");
                assert!(chosen == settings || chosen.degree == 24, "{name}: {chosen:?}");
            }
        }
        // A peak that nothing scatters into is none; what is finer already stays.
        let clear = AtmosphereParams { mie_scattering: [0.0; 3], ..AtmosphereParams::mars() };
        assert_eq!(Settings::FINE.for_medium(&clear), Settings::FINE);
        let finer = Settings { degree: 40, azimuths: 60, ..Settings::FINE };
        assert_eq!(finer.for_medium(&AtmosphereParams::mars()), finer);
    }
}
