//! The probed quantities in f64, from a case's f32 numbers, by the forms of [`crate::reference`].

use glam::DVec3;

use super::Case;
use crate::model::phase;
use crate::reference::geometry::{Chord, RayEnd};

/// How far apart two directions, altitudes or positions may be and still be the same to f32: two units in the
/// last place, relative. A shader's answer is right if it is the answer for such a neighbour of its inputs.
pub const RESOLUTION: f64 = 1.0 / 4_194_304.0; // 2^-22

/// The least normal number of f32: a density or a transmittance that is smaller may be 0.
const LEAST: f64 = 1.175_494_350_822_287_5e-38; // 2^-126

/// Smaller than this is 0: [`LEAST`] times the largest factor that may follow it in a single step.
const FAINT: f64 = 1e-30;

/// What an answer may be wrong by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Promise {
    /// Of the true value.
    pub relative: f64,
    /// In the quantity's unit.
    pub absolute: f64,
}

impl Promise {
    /// Distances and altitudes: 1e-5, or 1 m on an Earth-sized planet or a larger one and proportionally less
    /// on a smaller one. Kilometres.
    pub fn geometry(radius: f64) -> Self {
        Self { relative: 1e-5, absolute: 1e-3 * (radius / 6360.0).min(1.0) }
    }

    /// Single-step quantities: 0.1 %, or 1e-6 of the brightest value of the case. What f32 cannot hold (less
    /// than 1.2e-38, also as the product of two factors one of which is) may be 0.
    pub fn step(brightest: f64) -> Self {
        Self { relative: 1e-3, absolute: (1e-6 * brightest).max(FAINT) }
    }

    /// Light along a ray: as [`Self::step`]. The source, a density times what it sends into the ray per km,
    /// is a product with up to three other factors of at most 1 (transmittance to the eye, within the step
    /// and to the sun): where one of the four, or a product of some, is less than 2^-126 the light may be 0.
    /// `brightest_source`: the largest coefficient times phase function, 1/(km sr); `length`: km.
    pub fn light(brightest: f64, brightest_source: f64, length: f64) -> Self {
        let absolute = Self::step(brightest).absolute.max(LEAST * brightest_source * length);
        Self { absolute, ..Self::step(brightest) }
    }

    /// How far from `value` an answer may lie.
    pub fn allows(self, value: f64) -> f64 {
        (self.relative * value.abs()).max(self.absolute)
    }
}

pub(super) fn wide(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

fn channels(f: impl FnMut(usize) -> f64) -> [f64; 3] {
    std::array::from_fn(f)
}

/// A ray's inputs in f64, one of which may be a neighbour of the case's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Input {
    pub radius: f64,
    pub thickness: f64,
    pub altitude: f64,
    pub direction: DVec3,
    pub sun: DVec3,
    /// Factors of the absorbing layer's centre and half width.
    pub layer: [f64; 2],
    /// Factor of the shadow's radius: whether a ray along its edge is lit is a difference of two large
    /// numbers.
    pub shade: f64,
    /// What the shadow's begin and end are moved apart by, over what is promised of them.
    pub blur: f64,
    /// Factor of the shell's thickness for the way to the sun: next to the top, that is a difference of
    /// altitudes.
    pub lid: f64,
}

/// The absorbing layer's neighbours: near its foot the tent is a small difference of its inputs.
pub(super) const LAYERS: [[f64; 2]; 5] = [
    [1.0, 1.0],
    [1.0 + RESOLUTION, 1.0],
    [1.0 - RESOLUTION, 1.0],
    [1.0, 1.0 + RESOLUTION],
    [1.0, 1.0 - RESOLUTION],
];

impl Input {
    pub fn of(case: &Case) -> Self {
        Self {
            radius: case.medium.radius.into(),
            thickness: case.medium.thickness.into(),
            altitude: case.altitude.into(),
            direction: wide(case.direction).normalize(),
            sun: wide(case.sun).normalize(),
            layer: LAYERS[0],
            shade: 1.0,
            blur: 0.0,
            lid: 1.0,
        }
    }

    /// The ray between two that end differently, from both sides.
    pub fn edge(self, all: &[Self]) -> Option<[Self; 2]> {
        let ending = |i: &Self| Air::new(i).map(|a| a.ground);
        let own = ending(&self);
        let mut other = *all.iter().find(|i| i.direction != self.direction && ending(i) != own)?;
        let mut near = self;
        for _ in 0..50 {
            let middle = Self { direction: (near.direction + other.direction).normalize(), ..self };
            if ending(&middle) == own { near = middle } else { other = middle }
        }
        Some([near, other])
    }

    /// The direction turned up or down by a relative part of its sine or cosine, whichever is smaller: that
    /// is what f32 holds finely.
    pub fn tilted(self, e: f64) -> Self {
        let d = self.direction;
        let sin = d.x.hypot(d.y);
        let flat = if sin > 0.0 { DVec3::new(d.x / sin, d.y / sin, 0.0) } else { DVec3::X };
        let (z, s) = if sin < d.z.abs() {
            let s = sin * (1.0 + e);
            (((1.0 - s) * (1.0 + s)).sqrt().copysign(d.z), s)
        } else {
            let z = d.z * (1.0 + e);
            (z, ((1.0 - z) * (1.0 + z)).sqrt())
        };
        Self { direction: flat * s + DVec3::Z * z, ..self }
    }

    /// Many neighbours in direction, altitude and the shadow's edge together, for answers that do not change
    /// evenly between those of [`Self::neighbours`].
    pub fn swept(self) -> impl Iterator<Item = Self> {
        // From a tangent on, ever finer: there the answer goes with the root.
        let fine = (0..24).flat_map(|k| [1.0, -1.0].map(|sign| sign * RESOLUTION * 0.5f64.powi(k)));
        let edge = self.edge(&self.neighbours()).into_iter().flatten();
        let shades = [0.0, 1.0, -1.0, 0.1, -0.1, 0.01, -0.01].map(|e| 1.0 + e * RESOLUTION);
        let beside = edge
            .flat_map(move |i| fine.clone().map(move |e| i.tilted(e)))
            .flat_map(move |i| shades.map(|shade| Self { shade, ..i }));
        let steps = |n: i32| (-n..=n).map(move |i| f64::from(i) / f64::from(n) * RESOLUTION);
        beside.chain(steps(20).flat_map(move |tilt| {
            steps(1).flat_map(move |rise| {
                steps(2).map(move |shade| {
                    let tilted = self.tilted(tilt);
                    Self { altitude: self.altitude * (1.0 + rise), shade: 1.0 + shade, ..tilted }
                })
            })
        }))
    }

    /// The inputs as they are, and their neighbours within [`RESOLUTION`]: the direction turned up and down
    /// (in several steps: near a tangent the answer goes with the root) and to the sides, altitude and
    /// thickness moved, the sun turned by a quarter of that in radians, and the shadow's edge moved.
    pub fn neighbours(self) -> Vec<Self> {
        let mut all = vec![self];
        let d = self.direction;
        let sin = d.x.hypot(d.y);
        let flat = if sin > 0.0 { DVec3::new(d.x / sin, d.y / sin, 0.0) } else { DVec3::X };
        let side = DVec3::Z.cross(flat);
        all.extend([1.0, -1.0, 0.3, -0.3, 0.1, -0.1, 0.03, -0.03].map(|e| self.tilted(e * RESOLUTION)));
        for e in [RESOLUTION, -RESOLUTION] {
            all.push(Self { direction: (d + side * (e * sin)).normalize(), ..self });
            all.push(Self { altitude: self.altitude * (1.0 + e), ..self });
            all.push(Self { thickness: self.thickness * (1.0 + e), ..self });
            all.push(Self { lid: 1.0 + e, ..self });
            let sun = self.sun + DVec3::new(self.sun.z, 0.0, -self.sun.x) * (0.25 * e);
            all.push(Self { sun: sun.normalize(), ..self });
            all.push(Self { shade: 1.0 + e, ..self });
            all.push(Self { shade: 1.0 + e, ..all[1] });
            all.push(Self { shade: 1.0 + e, ..all[2] });
        }
        // Both move the closest approach the same way.
        all.push(Self { altitude: self.altitude * (1.0 + RESOLUTION), ..all[1] });
        all.push(Self { altitude: self.altitude * (1.0 - RESOLUTION), ..all[2] });
        if let Some(edge) = self.edge(&all) {
            all.extend(edge);
            for e in [1.0, -1.0, 0.3, -0.3, 0.1, -0.1, 0.03, -0.03] {
                all.extend(edge.map(|i| Self { shade: 1.0 + e * RESOLUTION, ..i }));
            }
        }
        all
    }
}

/// The f64 twin of `AirRay`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Air {
    pub chord: Chord,
    pub radius: f64,
    /// From the perigee.
    pub s0: f64,
    pub start: f64,
    pub length: f64,
    pub altitude: f64,
    pub sun_b: f64,
    pub nu: f64,
    /// Sine of the angle to the sun.
    pub sin: f64,
    pub ground: bool,
    /// The shadow's begin and end from the entry; begin > end where there is none.
    pub shadow: [f64; 2],
}

impl Air {
    /// `None` where the ray misses the air.
    pub fn new(i: &Input) -> Option<Self> {
        let d = i.direction;
        let chord = Chord::new(i.radius, i.altitude, d.z, d.x.hypot(d.y));
        let (s0, s1, end) = chord.clip(i.thickness, f64::INFINITY)?;
        let start = s0 - chord.origin;
        let nu = d.dot(i.sun);
        let ground = end == RayEnd::Ground;
        let mut length = s1 - s0;
        if ground && start <= 0.0 {
            // From next to the ground straight down, the difference has no digits even in f64.
            let depth = -chord.perigee_altitude;
            let half = (depth * (2.0 * i.radius - depth)).sqrt();
            length = i.altitude * (2.0 * i.radius + i.altitude) / (half - chord.origin);
        }
        let altitude = if start > 0.0 { i.thickness } else { i.altitude };
        // The point of entry, from the perigee's place: no difference of large numbers.
        let perigee = DVec3::new(-d.z * d.x, -d.z * d.y, d.x * d.x + d.y * d.y) * (i.radius + i.altitude);
        let sun_b =
            if start > 0.0 { perigee.dot(i.sun) + s0 * nu } else { (i.radius + i.altitude) * i.sun.z };
        let mut air = Self {
            chord,
            radius: i.radius,
            s0,
            start,
            length,
            altitude,
            sun_b,
            nu,
            sin: d.cross(i.sun).length(),
            ground,
            shadow: [1.0, 0.0],
        };
        air.shadow = air.shadow_of(perigee, d, i.sun, i.radius * i.shade);
        let blur = i.blur * Promise::geometry(i.radius).allows(air.length);
        if air.shadow[1] > air.shadow[0] {
            air.shadow = [air.shadow[0] - blur, air.shadow[1] + blur];
        }
        Some(air)
    }

    /// Where the line is nearer to the axis through the planet's centre towards the sun than R, on the night
    /// side.
    fn shadow_of(&self, perigee: DVec3, d: DVec3, sun: DVec3, radius: f64) -> [f64; 2] {
        let none = [1.0, 0.0];
        let (p, q) = (perigee - sun * perigee.dot(sun), d - sun * self.nu);
        let (a, b) = (q.length_squared(), p.dot(q));
        let c = p.length_squared() - radius * radius;
        let mut stretch = [f64::NEG_INFINITY, f64::INFINITY];
        if a > 1e-24 {
            let nearest = -b / a;
            let clear = (p + q * nearest).length();
            if clear >= radius {
                return none;
            }
            let half = ((radius - clear) * (radius + clear) / a).sqrt();
            stretch = [nearest - half, nearest + half];
        } else if c >= 0.0 {
            return none;
        }
        let along = perigee.dot(sun);
        if self.nu > 0.0 {
            stretch[1] = stretch[1].min(-along / self.nu);
        } else if self.nu < 0.0 {
            stretch[0] = stretch[0].max(-along / self.nu);
        } else if along >= 0.0 {
            return none;
        }
        stretch.map(|s| s - self.s0)
    }

    /// Altitude a distance after the entry, never negative.
    pub fn altitude_after(&self, t: f64) -> f64 {
        if t <= 0.0 { self.altitude } else { self.chord.altitude(self.s0 + t).max(0.0) }
    }
}

/// `MediumUniform` in f64; the absorbing layer's centre and half width times the two factors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Air64<'a>(pub &'a Case, pub [f64; 2]);

impl Air64<'_> {
    pub fn densities(self, h: f64) -> [f64; 3] {
        let m = &self.0.medium;
        let h = (h - f64::from(m.datum)).max(0.0);
        [
            (-h * f64::from(m.rayleigh_inv_height)).exp(),
            (-h * f64::from(m.mie_inv_height)).exp(),
            (1.0 - (h - f64::from(m.ozone_center) * self.1[0]).abs() * f64::from(m.ozone_inv_half_width)
                / self.1[1])
                .max(0.0),
        ]
    }

    pub fn extinction(self, d: [f64; 3]) -> [f64; 3] {
        let m = &self.0.medium;
        channels(|c| {
            f64::from(m.rayleigh[c]) * d[0]
                + f64::from(m.mie_extinction[c]) * d[1]
                + f64::from(m.ozone[c]) * d[2]
        })
    }

    /// `away` is 1 - cos.
    pub fn henyey_greenstein(self, away: f64) -> [f64; 3] {
        self.0.medium.mie_asymmetry.map(|g| phase::henyey_greenstein(1.0 - away, f64::from(g)))
    }

    /// `away` is 1 - cos.
    pub fn cornette_shanks(self, away: f64) -> [f64; 3] {
        let hg = self.henyey_greenstein(away);
        let mu = 1.0 - away;
        channels(|c| {
            let g = f64::from(self.0.medium.mie_asymmetry[c]);
            1.5 * (1.0 + mu * mu) / (2.0 + g * g) * hg[c]
        })
    }

    /// Columns by the shader's own rule, in f64: steps even in the root of the distance from the lowest
    /// point.
    pub fn columns(self, x: f64, b: f64, distance: f64, samples: u32) -> [f64; 3] {
        let radius = f64::from(self.0.medium.radius);
        let mut sum = [0.0; 3];
        for step in steps(b, distance, samples) {
            let rise = x + step.middle * (2.0 * b + step.middle);
            let h = (rise / (radius + (radius * radius + rise).max(0.0).sqrt())).max(0.0);
            let d = self.densities(h);
            for (sum, d) in sum.iter_mut().zip(d) {
                *sum += d * (step.end - step.begin);
            }
        }
        sum
    }

    /// Distance to the top from r² − R² = x with r μ = b.
    pub fn to_top(self, x: f64, b: f64, lid: f64) -> f64 {
        let (radius, top) = (f64::from(self.0.medium.radius), f64::from(self.0.medium.thickness) * lid);
        let c = (top * (2.0 * radius + top) - x).max(0.0);
        let root = (b * b + c).sqrt();
        if b > 0.0 { c / (b + root) } else { root - b }
    }
}

/// A step of a path; distances from its begin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub begin: f64,
    pub middle: f64,
    pub end: f64,
    pub low: f64,
}

impl Step {
    /// The middle of a part of the step, in the variable that steps are even in.
    fn middle_of(&self, a: f64, b: f64) -> f64 {
        let u = |t: f64| (t - self.low).abs().sqrt().copysign(t - self.low);
        let u = 0.5 * (u(a) + u(b));
        self.low + u * u.abs()
    }
}

fn steps(b: f64, distance: f64, samples: u32) -> impl Iterator<Item = Step> {
    let low = (-b).clamp(0.0, distance);
    let u0 = -low.sqrt();
    let du = ((distance - low).sqrt() - u0) / f64::from(samples);
    let at = move |i: f64| {
        let u = u0 + du * i;
        low + u * u.abs()
    };
    (0..samples).map(move |i| {
        let i = f64::from(i);
        Step { begin: if i == 0.0 { 0.0 } else { at(i) }, middle: at(i + 0.5), end: at(i + 1.0), low }
    })
}

/// What each density sends into the ray, per km, at most: coefficient times phase function, the brightest
/// channel's.
pub(super) fn brightest_source(case: &Case, input: &Input, cornette_shanks: bool) -> f64 {
    let half = 0.5 * (input.direction - input.sun).length_squared();
    let medium = Air64(case, input.layer);
    let aerosol = if cornette_shanks { medium.cornette_shanks(half) } else { medium.henyey_greenstein(half) };
    let (m, gas) = (&case.medium, phase::rayleigh(1.0 - half));
    (0..3)
        .map(|c| f64::from(m.rayleigh[c]) * gas + f64::from(m.mie_scattering[c]) * aerosol[c])
        .fold(0.0, f64::max)
}

/// The f64 twin of `single_scattering`: radiance and transmittance.
pub(super) fn scattering(case: &Case, input: &Input, cornette_shanks: bool) -> Option<([f64; 3], [f64; 3])> {
    let air = Air::new(input)?;
    let half = 0.5 * (input.direction - input.sun).length_squared();
    let medium = Air64(case, input.layer);
    let m = &case.medium;
    let aerosol = if cornette_shanks { medium.cornette_shanks(half) } else { medium.henyey_greenstein(half) };
    let gas = phase::rayleigh(1.0 - half);
    let length = air.length * f64::from(case.fraction);
    let (mut radiance, mut through) = ([0.0; 3], [1.0; 3]);
    for step in steps(air.s0, length, case.samples as u32) {
        let size = step.end - step.begin;
        let tau = medium.extinction(medium.densities(air.altitude_after(step.middle))).map(|e| e * size);
        let dark = air.shadow.map(|s| s.clamp(step.begin, step.end.max(step.begin)));
        let night = if air.shadow[1] > air.shadow[0] { (dark[1] - dark[0]).max(0.0) } else { 0.0 };
        if night < size {
            let mut lit = step.middle;
            if night > 0.0 {
                lit = if dark[0] - step.begin > step.end - dark[1] {
                    step.middle_of(step.begin, dark[0])
                } else {
                    step.middle_of(dark[1], step.end)
                };
            }
            let h = air.altitude_after(lit);
            let x = h * (2.0 * input.radius + h);
            let sun_b = air.sun_b + air.nu * lit;
            let columns =
                medium.columns(x, sun_b, medium.to_top(x, sun_b, input.lid), case.light_samples as u32);
            let light = medium.extinction(columns);
            let d = medium.densities(h);
            for c in 0..3 {
                let own = if tau[c] > 1e-6 { -(-tau[c]).exp_m1() / tau[c] } else { 1.0 - 0.5 * tau[c] };
                let source = f64::from(m.rayleigh[c]) * gas * d[0]
                    + f64::from(m.mie_scattering[c]) * aerosol[c] * d[1];
                radiance[c] += through[c] * own * source * (-light[c]).exp() * (size - night);
            }
        }
        for c in 0..3 {
            through[c] *= (-tau[c]).exp();
        }
    }
    Some((radiance, through))
}
