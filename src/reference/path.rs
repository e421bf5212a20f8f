//! Monte Carlo: paths traced backwards from the eye, with the sun connected at every scattering event.
//!
//! Independent of [`super::multiple`]: no tables, no moments, no interpolation, so its only error is
//! noise, and it says how large that is. Free paths come from delta tracking (Woodcock et al. 1965; Galtier
//! et al. 2013) with majorants per altitude shell, which is unbiased. Absorption is a weight.
//! What was scattered once is not sampled but integrated ([`super::single`]), likewise sunlight from ground
//! that is seen directly; the paths carry the rest.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::geometry::{Chord, RayEnd};
use super::medium::{ColumnRule, Medium};
use super::parallel;
use super::single::{Line, RayQuery, Tolerance, scatter};
use crate::error::{Result, in_range};
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::model::moon::Moon;
use crate::model::phase;

/// How much to trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Paths per channel, 16 to 1e10. The standard error falls with the root.
    pub paths: u64,
    /// Equal seeds give equal results, on any number of cores.
    pub seed: u64,
}

/// A mean and how far off it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Radiance per unit solar irradiance, 1/sr, all orders; no sun disk. See
    /// [`super::multiple::Radiance::per_irradiance`].
    pub per_irradiance: [f64; 3],
    /// One standard error of it.
    pub std_err: [f64; 3],
}

/// Radiance along a ray by path tracing; under a moon, if the query has one.
///
/// Runs on all cores with the cargo feature `reference`; about 1 µs a path and channel for Earth on two
/// cores.
///
/// # Errors
/// Parameters that [`AtmosphereParams::validate`] refuses; a query or setting out of range.
pub fn path_trace(params: &AtmosphereParams, query: &RayQuery, settings: Settings) -> Result<Estimate> {
    params.validate()?;
    let query = query.validate(params)?;
    in_range("settings.paths", settings.paths as f64, 16.0, 1e10, "")?;
    let medium = Medium::new(params);
    let to_eye = DVec3::Z * (medium.from_ground.planet_radius + query.altitude);
    let moon = query.moon.map(|moon| Moon { position: moon.position + to_eye, ..moon });
    let tracer = Tracer { moon, ..Tracer::new(medium) };
    let once = scatter(&tracer.medium, &query, Line::Adaptive(Tolerance { relative: 1e-5 }), None);
    let mut out = Estimate { per_irradiance: once.per_irradiance, std_err: [0.0; 3] };
    let Some(first) = First::new(&tracer, &query) else { return Ok(out) };
    // Batches of equal size; their means give the error, so that it knows about the strata.
    const BATCHES: usize = 64;
    let batches = BATCHES.min(settings.paths as usize);
    let per_batch = settings.paths.div_ceil(batches as u64);
    let means = parallel::map(batches, |batch| {
        std::array::from_fn::<f64, 3, _>(|c| {
            let mut random = Random::new(settings.seed, (batch * 3 + c) as u64);
            let mut sum = 0.0;
            for i in 0..per_batch {
                sum += first.path(&tracer, c, (i as f64 + random.uniform()) / per_batch as f64, &mut random);
            }
            sum / per_batch as f64
        })
    });
    for c in 0..3 {
        let n = batches as f64;
        let mean = means.iter().map(|m| m[c]).sum::<f64>() / n;
        let variance = means.iter().map(|m| (m[c] - mean).powi(2)).sum::<f64>() / (n - 1.0);
        out.per_irradiance[c] += mean + first.direct_ground[c];
        out.std_err[c] = (variance / n).sqrt();
    }
    Ok(out)
}

/// xoshiro256++ (Blackman & Vigna 2021), seeded by SplitMix64.
struct Random([u64; 4]);

impl Random {
    fn new(seed: u64, stream: u64) -> Self {
        let mut state = seed ^ stream.wrapping_mul(0xD6E8_FEB8_6659_FD93);
        Self(std::array::from_fn(|_| {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^ (z >> 31)
        }))
    }

    fn next(&mut self) -> u64 {
        let s = &mut self.0;
        let out = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = s[3].rotate_left(45);
        out
    }

    /// In [0, 1).
    fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2f64.powi(-53)
    }
}

/// A point on a path: where, how high, and where to go next.
#[derive(Clone, Copy)]
struct Vertex {
    /// From the planet's centre, length 1.
    zenith: DVec3,
    altitude: f64,
    direction: DVec3,
}

struct Tracer {
    medium: Medium,
    /// What dims the sun; positions from the planet's centre.
    moon: Option<Moon>,
    /// Ascending altitudes from 0 to the top.
    shells: Vec<f64>,
    /// Largest extinction in the shell above `shells[i]`.
    majorants: Vec<[f64; 3]>,
}

impl Tracer {
    fn new(medium: Medium) -> Self {
        let p = &medium.from_ground;
        let mut scale = p.rayleigh_scale_height;
        if medium.mie_extinction.iter().any(|&v| v > 0.0) {
            scale = scale.min(p.mie_scale_height);
        }
        // Shells that start half a scale height thick and grow, at most 64.
        let mut shells = vec![0.0];
        let (mut thickness, mut h) = (0.5 * scale, 0.0);
        while h + thickness < medium.top && shells.len() < 64 {
            h += thickness;
            shells.push(h);
            thickness =
                (1.15 * thickness).max((medium.top - h) / 40.0).min(0.5 * p.rayleigh_scale_height.max(scale));
            if shells.len() > 32 {
                thickness = thickness.max((medium.top - h) / (65 - shells.len()) as f64);
            }
        }
        let majorants = (0..shells.len())
            .map(|i| {
                let (low, high) = (shells[i], shells.get(i + 1).copied().unwrap_or(medium.top));
                let [gas, aerosol, _] = medium.densities(low);
                let ozone = medium.densities(medium.kinks()[1].clamp(low, high))[2];
                std::array::from_fn(|c| {
                    p.rayleigh_scattering[c] * gas
                        + medium.mie_extinction[c] * aerosol
                        + p.ozone_absorption[c] * ozone
                })
            })
            .collect();
        Self { medium, moon: None, shells, majorants }
    }

    fn chord(&self, at: &Vertex) -> Chord {
        let (mu, sin) = (at.zenith.dot(at.direction), at.zenith.cross(at.direction).length());
        Chord::new(self.medium.from_ground.planet_radius, at.altitude, mu, sin)
    }

    /// The vertex `s` along a chord that starts at `from`.
    fn step(&self, from: &Vertex, chord: &Chord, s: f64) -> Vertex {
        let r = self.medium.from_ground.planet_radius + from.altitude;
        let point = from.zenith * r + from.direction * (s - chord.origin);
        Vertex { zenith: point.normalize(), altitude: chord.altitude(s).max(0.0), direction: from.direction }
    }

    /// Where light of a channel is next scattered or absorbed between s0 and s1, or `None`.
    fn collide(&self, chord: &Chord, s0: f64, s1: f64, c: usize, random: &mut Random) -> Option<f64> {
        let mut s = s0;
        let mut depth = -(1.0 - random.uniform()).ln();
        let mut shell = self.shells.partition_point(|&h| h <= chord.altitude(s)).saturating_sub(1);
        loop {
            // The end of this shell on the line: down through its floor, or up through its ceiling.
            let low = self.shells[shell];
            let mut next = None;
            if s < 0.0 {
                next = chord
                    .at_altitude(low)
                    .map(|d| (-d, shell.saturating_sub(1)))
                    .filter(|(at, _)| *at > s || shell > 0);
            }
            let (end, after) = next.unwrap_or_else(|| {
                let ceiling =
                    self.shells.get(shell + 1).and_then(|&h| chord.at_altitude(h)).unwrap_or(f64::INFINITY);
                (ceiling, shell + 1)
            });
            let stop = end.min(s1);
            let majorant = self.majorants[shell][c];
            loop {
                let reach = majorant * (stop - s);
                if depth >= reach {
                    depth -= reach.max(0.0);
                    break;
                }
                s += depth / majorant;
                let extinction = self.medium.extinction(chord.altitude(s))[c];
                if random.uniform() * majorant < extinction {
                    return Some(s);
                }
                depth = -(1.0 - random.uniform()).ln();
            }
            s = stop;
            if s >= s1 || after >= self.shells.len() {
                return None;
            }
            shell = after;
        }
    }

    /// Scattering coefficients of gas and aerosol at an altitude.
    fn scattering(&self, altitude: f64, c: usize) -> (f64, f64) {
        let p = &self.medium.from_ground;
        let [gas, aerosol, _] = self.medium.densities(altitude);
        (p.rayleigh_scattering[c] * gas, p.mie_scattering[c] * aerosol)
    }

    /// Share of the sun's light that arrives at a vertex, 0 in the planet's shadow.
    fn sunlight(&self, at: &Vertex, sun: DVec3, c: usize) -> f64 {
        let p = &self.medium.from_ground;
        let passed = self.moon.map_or(1.0, |moon| {
            moon.sunlight(at.zenith * (p.planet_radius + at.altitude), sun, p.sun_angular_radius)[c]
        });
        if passed <= 0.0 {
            return 0.0;
        }
        let chord = self.chord(&Vertex { direction: sun, ..*at });
        match self.medium.columns_to_sun(&chord, ColumnRule::Quick) {
            Some(columns) => passed * (-self.medium.optical_depth(columns)[c]).exp(),
            None => 0.0,
        }
    }

    /// A direction of scattering, by the mixture of both phase functions.
    fn scatter_direction(&self, at: &Vertex, c: usize, random: &mut Random) -> DVec3 {
        let p = &self.medium.from_ground;
        let (gas, aerosol) = self.scattering(at.altitude, c);
        let cos = if random.uniform() * (gas + aerosol) < gas {
            loop {
                let cos = 2.0 * random.uniform() - 1.0;
                if random.uniform() * 2.0 < 1.0 + cos * cos {
                    break cos;
                }
            }
        } else {
            loop {
                let cos = phase::sample_hg(p.mie_asymmetry[c], random.uniform());
                if p.mie_phase == MiePhase::HenyeyGreenstein || random.uniform() * 2.0 < 1.0 + cos * cos {
                    break cos;
                }
            }
        };
        turn(at.direction, cos, random)
    }
}

/// A unit vector at an angle of cosine `cos` to `axis`, of any azimuth.
fn turn(axis: DVec3, cos: f64, random: &mut Random) -> DVec3 {
    let (x, y) = axis.any_orthonormal_pair();
    let sin = ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
    let (s, c) = (TAU * random.uniform()).sin_cos();
    ((x * c + y * s) * sin + axis * cos).normalize()
}

/// The ray from the eye, shared by all paths: where to put their first vertex.
struct First {
    eye: Vertex,
    sun: DVec3,
    chord: Chord,
    s0: f64,
    end: f64,
    hits_ground: bool,
    /// Cells of the ray in `v`: edges, and per channel the distribution over cells.
    edges: Vec<f64>,
    distribution: [Vec<f64>; 3],
    ground_transmittance: [f64; 3],
    /// Sunlight from the ground at the ray's end.
    direct_ground: [f64; 3],
}

impl First {
    fn new(tracer: &Tracer, query: &RayQuery) -> Option<Self> {
        let medium = &tracer.medium;
        let eye = Vertex { zenith: DVec3::Z, altitude: query.altitude, direction: query.direction };
        let chord = tracer.chord(&eye);
        let (s0, end, ends_at) = chord.clip(medium.top, query.length)?;
        let hits_ground = ends_at == RayEnd::Ground;
        let (v0, v1) = (chord.v_at(s0), chord.v_at(end));
        const CELLS: usize = 96;
        let edges: Vec<f64> = (0..=CELLS).map(|i| v0 + (v1 - v0) * i as f64 / CELLS as f64).collect();
        let transmittance = |s: f64| {
            medium.optical_depth(medium.columns(&chord, s0, s, ColumnRule::Precise)).map(|t| (-t).exp())
        };
        let mut distribution: [Vec<f64>; 3] = std::array::from_fn(|_| vec![0.0]);
        for w in edges.windows(2) {
            let (s, jacobian) = chord.at_v(0.5 * (w[0] + w[1]));
            let through = transmittance(s);
            for c in 0..3 {
                let (gas, aerosol) = tracer.scattering(chord.altitude(s), c);
                let weight = (gas + aerosol) * through[c] * jacobian * (w[1] - w[0]);
                let sum = distribution[c][distribution[c].len() - 1];
                distribution[c].push(sum + weight);
            }
        }
        for cells in &mut distribution {
            // A little everywhere, so that no part of the ray is left out.
            let total = cells[CELLS];
            for (i, v) in cells.iter_mut().enumerate() {
                let even = i as f64 / CELLS as f64;
                *v = if total > 0.0 { 0.95 * *v / total + 0.05 * even } else { even };
            }
        }
        let ground_transmittance = transmittance(end);
        let mut direct_ground = [0.0; 3];
        if hits_ground {
            let at = tracer.step(&eye, &chord, end);
            let cos = at.zenith.dot(query.sun).max(0.0);
            if cos > 0.0 {
                direct_ground = std::array::from_fn(|c| {
                    let light = cos * tracer.sunlight(&Vertex { altitude: 0.0, ..at }, query.sun, c);
                    ground_transmittance[c] * medium.from_ground.ground_albedo[c] / PI * light
                });
            }
        }
        Some(Self {
            eye,
            sun: query.sun,
            chord,
            s0,
            end,
            hits_ground,
            edges,
            distribution,
            ground_transmittance,
            direct_ground,
        })
    }

    /// Light of one path, all orders but those that [`path_trace`] adds itself. `stratum` in [0, 1) places
    /// its first vertex.
    fn path(&self, tracer: &Tracer, c: usize, stratum: f64, random: &mut Random) -> f64 {
        let medium = &tracer.medium;
        let albedo = medium.from_ground.ground_albedo[c];
        let at_ground = if self.hits_ground {
            let through = self.ground_transmittance[c] * albedo;
            through / (through + 1.0 - self.ground_transmittance[c] + 1e-12)
        } else {
            0.0
        };
        if stratum < at_ground {
            let mut vertex = tracer.step(&self.eye, &self.chord, self.end);
            vertex.altitude = 0.0;
            vertex.direction = turn(vertex.zenith, random.uniform().sqrt(), random);
            return self.follow(tracer, vertex, c, self.ground_transmittance[c] * albedo / at_ground, random);
        }
        let u = (stratum - at_ground) / (1.0 - at_ground);
        let cells = &self.distribution[c];
        let cell = cells.partition_point(|&v| v <= u).clamp(1, cells.len() - 1) - 1;
        let share = cells[cell + 1] - cells[cell];
        let (lo, hi) = (self.edges[cell], self.edges[cell + 1]);
        if share <= 0.0 || hi <= lo {
            return 0.0;
        }
        let (s, jacobian) = self.chord.at_v(lo + (hi - lo) * random.uniform());
        let density = share / ((hi - lo) * jacobian) * (1.0 - at_ground);
        let depth = medium.optical_depth(medium.columns(&self.chord, self.s0, s, ColumnRule::Quick))[c];
        let mut vertex = tracer.step(&self.eye, &self.chord, s);
        let (gas, aerosol) = tracer.scattering(vertex.altitude, c);
        let weight = (gas + aerosol) * (-depth).exp() / density;
        if weight <= 0.0 {
            return 0.0;
        }
        vertex.direction = tracer.scatter_direction(&vertex, c, random);
        self.follow(tracer, vertex, c, weight, random)
    }

    /// Light from all later vertices of a path that leaves `vertex` with a weight.
    fn follow(
        &self,
        tracer: &Tracer,
        mut vertex: Vertex,
        c: usize,
        mut weight: f64,
        random: &mut Random,
    ) -> f64 {
        let p = &tracer.medium.from_ground;
        let start = weight;
        let mut light = 0.0;
        loop {
            let chord = tracer.chord(&vertex);
            let Some((s0, s1, ends_at)) = chord.clip(tracer.medium.top, f64::INFINITY) else { return light };
            if let Some(s) = tracer.collide(&chord, s0, s1, c, random) {
                vertex = tracer.step(&vertex, &chord, s);
                let (gas, aerosol) = tracer.scattering(vertex.altitude, c);
                let extinction = tracer.medium.extinction(vertex.altitude)[c];
                if gas + aerosol <= 0.0 {
                    return light;
                }
                let cos = vertex.direction.dot(self.sun).clamp(-1.0, 1.0);
                let phase =
                    gas * phase::rayleigh(cos) + aerosol * phase::mie(p.mie_phase, cos, p.mie_asymmetry[c]);
                light += weight * phase / extinction * tracer.sunlight(&vertex, self.sun, c);
                weight *= (gas + aerosol) / extinction;
                vertex.direction = tracer.scatter_direction(&vertex, c, random);
            } else if ends_at == RayEnd::Ground && p.ground_albedo[c] > 0.0 {
                vertex = tracer.step(&vertex, &chord, s1);
                vertex.altitude = 0.0;
                weight *= p.ground_albedo[c];
                let cos = vertex.zenith.dot(self.sun);
                if cos > 0.0 {
                    light += weight / PI * cos * tracer.sunlight(&vertex, self.sun, c);
                }
                vertex.direction = turn(vertex.zenith, random.uniform().sqrt(), random);
            } else {
                return light;
            }
            // Russian roulette on what absorption has left over.
            if weight < 0.25 * start {
                if random.uniform() < 0.5 {
                    return light;
                }
                weight *= 2.0;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_seeds_give_equal_light() {
        let params = AtmosphereParams::earth();
        let query = RayQuery::new(0.0, 1.0, 1.2, 0.5);
        let trace = |seed| path_trace(&params, &query, Settings { paths: 200, seed }).unwrap();
        assert_eq!(trace(7), trace(7));
        assert_ne!(trace(7), trace(8));
    }

    #[test]
    fn free_paths_follow_the_transmittance() {
        let params = AtmosphereParams::earth();
        let tracer = Tracer::new(Medium::new(&params));
        let mut random = Random::new(1, 0);
        for (altitude, angle) in
            [(0.0, 1.5f64), (30_000.0, 1.62), (20_000.0, 1.65), (99_000.0, 3.0), (5000.0, 0.2)]
        {
            let vertex =
                Vertex { zenith: DVec3::Z, altitude, direction: DVec3::new(angle.sin(), 0.0, angle.cos()) };
            let chord = tracer.chord(&vertex);
            let (s0, s1, _) = chord.clip(tracer.medium.top, f64::INFINITY).unwrap();
            for c in 0..3 {
                for part in [0.3, 1.0] {
                    let s1 = s0 + (s1 - s0) * part;
                    let columns = tracer.medium.columns(&chord, s0, s1, ColumnRule::Precise);
                    let through = (-tracer.medium.optical_depth(columns)[c]).exp();
                    let n = 20_000;
                    let free =
                        (0..n).filter(|_| tracer.collide(&chord, s0, s1, c, &mut random).is_none()).count();
                    let deviation = (through * (1.0 - through) / f64::from(n)).sqrt();
                    let difference = free as f64 / f64::from(n) - through;
                    assert!(
                        difference.abs() < 4.5 * deviation + 1e-9,
                        "{altitude} {angle} {c} {part}: {difference} {deviation}"
                    );
                }
            }
        }
    }

    #[test]
    fn nothing_scatters_where_there_is_nothing() {
        let mut params = AtmosphereParams::rayleigh();
        params.rayleigh_scattering = [0.0; 3];
        let query = RayQuery::new(0.0, 1.0, 1.2, 0.5);
        let dark = path_trace(&params, &query, Settings { paths: 100, seed: 1 }).unwrap();
        assert_eq!((dark.per_irradiance, dark.std_err), ([0.0; 3], [0.0; 3]));
        // Only the ground is left, and it is exact: albedo / π × cosine.
        params.ground_albedo = [0.5; 3];
        let down = RayQuery::new(1000.0, PI, 0.6, 0.0);
        let ground = path_trace(&params, &down, Settings { paths: 100, seed: 1 }).unwrap();
        assert!((ground.per_irradiance[1] - 0.5 / PI * 0.6f64.cos()).abs() < 1e-12);
    }
}
