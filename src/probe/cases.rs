//! Which cases are tried: a fixed grid of what breaks atmosphere code, and random ones over everything that
//! [`AtmosphereParams::validate`] and a camera's position accept.

use std::f64::consts::{PI, TAU};

use fastrand::Rng;
use glam::DVec3;

use super::Case;
use crate::frame::uniforms::MediumUniform;
use crate::model::atmosphere::AtmosphereParams;

const KM: f64 = 1000.0;
/// Farthest camera from the planet's centre, metres: what `Scene::validate` accepts.
const FARTHEST: f64 = 1e15;

/// A source of cases: the grid first, then random ones.
#[derive(Clone, Debug)]
pub struct Cases {
    seed: u64,
    next: u64,
}

impl Cases {
    /// From the first case of the grid on.
    pub fn new(seed: u64) -> Self {
        Self::at(seed, 0)
    }

    /// From a case's number on.
    pub fn at(seed: u64, number: u64) -> Self {
        Self { seed, next: number }
    }
}

impl Iterator for Cases {
    type Item = Case;

    fn next(&mut self) -> Option<Case> {
        let index = self.next;
        self.next += 1;
        Some(match index.checked_sub(grid_len() as u64) {
            None => grid(index as usize),
            Some(index) => random(self.seed, index),
        })
    }
}

/// The media of the grid.
fn media() -> Vec<AtmosphereParams> {
    let earth = AtmosphereParams::earth();
    let thin = |shell: f64| AtmosphereParams {
        atmosphere_radius: earth.planet_radius * (1.0 + shell),
        ..earth.clone()
    };
    let scale = |height: f64| AtmosphereParams {
        rayleigh_scale_height: height,
        mie_scale_height: height,
        ..earth.clone()
    };
    let depth = |tau: f64| AtmosphereParams {
        rayleigh_scattering: [tau / earth.rayleigh_scale_height; 3],
        mie_scattering: [0.0; 3],
        mie_absorption: [0.0; 3],
        ozone_absorption: [0.0; 3],
        ..earth.clone()
    };
    let g = |g: [f64; 3]| AtmosphereParams { mie_asymmetry: g, ..earth.clone() };
    let none = depth(0.0);
    vec![
        earth.clone(),
        AtmosphereParams::mars(),
        AtmosphereParams::venus(),
        none.clone(),
        depth(1.0),
        AtmosphereParams { mie_scattering: earth.mie_scattering, ..none.clone() },
        AtmosphereParams { mie_absorption: [1e-4; 3], ..none.clone() },
        AtmosphereParams { ozone_absorption: earth.ozone_absorption, ..none },
        depth(1e-9),
        // Of 16 km: 1 1/m is the most that is accepted.
        AtmosphereParams { rayleigh_scale_height: 16e3, ..depth(5e3) },
        scale(1.0),
        scale(1e6),
        thin(1e-5),
        thin(0.1),
        thin(2.0),
        AtmosphereParams::earth_like(1e3),
        AtmosphereParams::earth_like(1e5),
        AtmosphereParams::earth_like(7e7),
        g([0.0; 3]),
        g([-0.5, 0.5, 0.999]),
        g([-0.999, 0.999, 0.9]),
        AtmosphereParams { lowest_ground: -430.0, ..earth.clone() },
        AtmosphereParams { lowest_ground: -11e3, ..earth.clone() },
        AtmosphereParams { lowest_ground: -7e3, ..AtmosphereParams::mars() },
    ]
}

/// Altitudes of the grid, metres; below the surface counts as on it.
pub(super) fn altitudes(p: &AtmosphereParams) -> [f64; 14] {
    let (r, t) = (p.planet_radius, p.thickness());
    let ulp = t * f64::from(f32::EPSILON);
    [
        0.0,
        1e-3,
        1.7,
        100.0,
        0.3 * t,
        t - ulp,
        t,
        t + ulp,
        t + 1.0,
        4e5_f64.max(1.5 * t),
        3.6e7_f64.max(6.0 * r),
        3.844e8_f64.max(60.0 * r),
        1.5e11_f64.max(100.0 * r),
        FARTHEST * 0.9,
    ]
}

const GRID_DIRECTIONS: usize = 18;
const GRID_SUNS: usize = 14;
const GRID_MEDIA: usize = 24;

/// How many cases [`grid`] has.
pub fn grid_len() -> usize {
    GRID_MEDIA * 14 * GRID_DIRECTIONS * GRID_SUNS
}

/// A case of the grid, by its number below [`grid_len`].
pub fn grid(index: usize) -> Case {
    let mut rest = index;
    let mut digit = |base: usize| {
        let digit = rest % base;
        rest /= base;
        digit
    };
    let (sun, direction) = (digit(GRID_SUNS), digit(GRID_DIRECTIONS));
    let (altitude, medium) = (digit(14), digit(GRID_MEDIA));
    let p = &media()[medium];
    let h = altitudes(p)[altitude];
    let mut rng = Rng::with_seed(index as u64 ^ 0x9e37_79b9);
    build(p, h, sun, direction, &mut rng)
}

/// A random case, by a seed and its number.
pub fn random(seed: u64, index: u64) -> Case {
    let mut rng = Rng::with_seed(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ index);
    let mut p = any_medium(&mut rng);
    p.sun_intensity = 1.0;
    let (r, t) = (p.planet_radius, p.thickness());
    let h = match rng.u8(0..8) {
        0 => altitudes(&p)[rng.usize(0..14)],
        1..=3 => t * rng.f64(),
        4 => t * log(&mut rng, 1e-9, 1.0),
        5 => t + r * log(&mut rng, 1e-9, 1e3),
        _ => t + (FARTHEST - r - t).min(r * log(&mut rng, 1e-3, 1e7)),
    };
    let (sun, direction) = (rng.usize(0..GRID_SUNS + 6), rng.usize(0..GRID_DIRECTIONS + 8));
    build(&p, h.min(FARTHEST - r), sun, direction, &mut rng)
}

/// The grid's media, or parameters from everything that is accepted.
pub(super) fn any_medium(rng: &mut Rng) -> AtmosphereParams {
    if rng.u8(0..4) == 0 { media().swap_remove(rng.usize(0..GRID_MEDIA)) } else { medium(rng) }
}

fn log(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low * (high / low).powf(rng.f64())
}

/// Parameters from everything that `validate` accepts; an edge of a range now and then.
fn medium(rng: &mut Rng) -> AtmosphereParams {
    let within = |rng: &mut Rng, low: f64, high: f64| match rng.u8(0..24) {
        0 => low,
        1 => high,
        _ => log(rng, low, high),
    };
    let coefficients = |rng: &mut Rng| {
        if rng.u8(0..5) == 0 {
            return [0.0; 3];
        }
        let middle = log(rng, 1e-9, 1.0);
        [(); 3].map(|()| if rng.u8(0..20) == 0 { 0.0 } else { (middle * log(rng, 0.1, 10.0)).min(1.0) })
    };
    let planet_radius = within(rng, 1e2, 1e9);
    let shell = within(rng, 1.000_001e-6, 3.999_999);
    // Scale heights that matter for the shell, more often than others.
    let height = |rng: &mut Rng| {
        let fitting = shell * planet_radius * log(rng, 1e-2, 1.0);
        if rng.bool() { fitting.clamp(0.1, 1e7) } else { within(rng, 0.1, 1e7) }
    };
    let mut p = AtmosphereParams {
        planet_radius,
        atmosphere_radius: planet_radius * (1.0 + shell),
        rayleigh_scattering: coefficients(rng),
        rayleigh_scale_height: height(rng),
        mie_scattering: coefficients(rng),
        mie_absorption: coefficients(rng),
        mie_scale_height: height(rng),
        mie_asymmetry: [(); 3].map(|()| match rng.u8(0..8) {
            0 => 0.0,
            1 => 0.999,
            2 => -0.999,
            _ => 1.998 * rng.f64() - 0.999,
        }),
        ozone_absorption: coefficients(rng),
        ozone_center_altitude: if rng.u8(0..8) == 0 { 0.0 } else { height(rng) },
        ozone_half_width: height(rng).max(1.0),
        ..AtmosphereParams::earth()
    };
    if rng.u8(0..4) == 0 {
        // As deep as the promise of right light goes, or as deep as is accepted.
        let scale = p.rayleigh_scale_height.min(p.mie_scale_height);
        let deepest = 0.1 * planet_radius;
        p.lowest_ground = -[(3.0 * scale * rng.f64()).min(deepest), deepest][usize::from(rng.u8(0..4) == 0)];
        p.atmosphere_radius = p.atmosphere_radius.min(4.999_999 * p.ground_radius());
    }
    p
}

/// The sun by its number: the grid's fixed places, then random ones.
fn sun(number: usize, dip: f64, rng: &mut Rng) -> DVec3 {
    let zenith = match number {
        0 => 0.0,
        1 => 0.5 * PI - 1e-6,
        2 => 0.5 * PI,
        3 => 0.5 * PI + 1e-6,
        4 => 96f64.to_radians(),
        5 => 102f64.to_radians(),
        6 => 108f64.to_radians(),
        7 => PI,
        // Grazing the limb, from its night side and its day side.
        8 => 0.5 * PI + dip + 1e-5,
        9 => 0.5 * PI + dip,
        10 => 0.5 * PI + dip - 1e-5,
        11 => 1.0,
        12 => PI - 1e-4,
        13 => 1e-4,
        _ => (2.0 * rng.f64() - 1.0).acos(),
    };
    let (sin, cos) = zenith.sin_cos();
    DVec3::new(sin, 0.0, cos)
}

fn build(p: &AtmosphereParams, h: f64, sun_number: usize, direction: usize, rng: &mut Rng) -> Case {
    debug_assert!(p.validate().is_ok(), "{:?}", p.validate());
    let m = MediumUniform::new(p);
    let altitude = (h.max(0.0) / KM) as f32;
    let (radius, thickness) = (f64::from(m.radius), f64::from(m.thickness));
    let r = radius + f64::from(altitude);
    // Cosine of the zenith angle below the horizontal at which a sphere `k` km above the surface is touched.
    let dip = |k: f64| {
        let sin = ((radius + k) / r).min(1.0);
        let cos2 = ((f64::from(altitude) - k).max(0.0) * (r + radius + k)) / (r * r);
        (sin, -cos2.sqrt())
    };
    let sun = sun(sun_number, dip(0.0).0.acos(), rng);
    let turn = [0.0, PI, 0.7, 2.0, -1.3][rng.usize(0..5)];
    let at = |(sin, cos): (f64, f64)| DVec3::new(sin * f64::cos(turn), sin * f64::sin(turn), cos);
    let near = |(sin, cos): (f64, f64), e: f64| {
        // One unit in the last place of f32 up or down, in whichever of the two is fine.
        if sin < cos.abs() {
            let s = sin * (1.0 + e);
            (s, ((1.0 - s) * (1.0 + s)).max(0.0).sqrt().copysign(cos))
        } else {
            let c = cos * (1.0 - e);
            (((1.0 - c) * (1.0 + c)).max(0.0).sqrt(), c)
        }
    };
    let ulp = f64::from(f32::EPSILON);
    let dir = match direction {
        0 => DVec3::Z,
        1 => -DVec3::Z,
        2 => DVec3::new(f64::cos(turn), f64::sin(turn), 0.0),
        3 => at(dip(0.0)),
        4 => at(near(dip(0.0), ulp)),
        5 => at(near(dip(0.0), -ulp)),
        6 => at(dip(thickness)),
        7 => at(near(dip(thickness), ulp)),
        8 => at(near(dip(thickness), -ulp)),
        9 => sun,
        10 => -sun,
        11 => at(dip(0.3 * thickness)),
        12 => at((0.6, 0.8)),
        13 => at((0.6, -0.8)),
        14 => at((1.0, 1e-3)),
        15 => at((1.0, -1e-3)),
        16 => at((1e-4, -1.0)),
        17 => (sun + DVec3::new(1e-3, 1e-3, -1e-3)).normalize(),
        18..=20 => {
            // Aimed by where it passes the centre: from outside most rays would miss.
            let p = (radius + thickness) * 1.05 * rng.f64();
            let sin = (p / r).min(1.0);
            at((sin, -((1.0 - sin) * (1.0 + sin)).sqrt()))
        }
        21 | 22 => at(dip(thickness * (1.2 * rng.f64() - 0.1))),
        23 => {
            let e = log(rng, 1e-7, 1.0);
            (sun * if rng.bool() { 1.0 } else { -1.0 }
                + DVec3::new(e * rng.f64(), e * rng.f64(), -e * rng.f64()))
            .normalize()
        }
        _ => {
            let z = 2.0 * rng.f64() - 1.0;
            let (s, c) = (TAU * rng.f64()).sin_cos();
            let sin = (1.0 - z * z).sqrt();
            DVec3::new(sin * c, sin * s, z)
        }
    };
    let dir = dir.normalize();
    let fraction = [0.0, 1e-6, 0.1, 0.5, 0.99, 1.0][rng.usize(0..6)] as f32;
    // A path within the shell, from the altitude or from somewhere in it.
    let start = if f64::from(altitude) <= thickness { f64::from(altitude) } else { thickness * rng.f64() };
    let mut x = (start * (2.0 * radius + start)) as f32;
    let mut b = ((radius + start) * dir.z) as f32;
    if b < 0.0 && f64::from(b) * f64::from(b) >= f64::from(x) {
        // It would meet the ground: seen from there.
        (x, b) = (0.0, -b);
    }
    let excess = |k: f64| k * (2.0 * radius + k);
    let (x64, b64) = (f64::from(x), f64::from(b));
    let c = (excess(thickness) - x64).max(0.0);
    let root = (b64 * b64 + c).sqrt();
    let length = if b64 > 0.0 { c / (b64 + root) } else { root - b64 };
    Case {
        medium: m,
        direction: dir.as_vec3().to_array(),
        altitude,
        sun: sun.as_vec3().to_array(),
        fraction,
        path_excess: x,
        path_r_mu: b,
        path_distance: (length * f64::from(fraction)) as f32,
        samples: [1.0, 2.0, 4.0, 7.0][rng.usize(0..4)],
        away: match rng.u8(0..6) {
            0 => 0.0,
            1 => 2.0,
            2 => log(rng, 1e-14, 1e-2) as f32,
            _ => 2.0 * rng.f32(),
        },
        light_samples: [1.0, 2.0, 3.0][rng.usize(0..3)],
        // Rays to the ground and others; outside, the planet is all that there is without air.
        to_ground: f32::from(rng.bool()),
        uv: [(); 2].map(|()| match rng.u8(0..8) {
            0 => 0.0,
            1 => 1.0,
            2 => log(rng, 1e-9, 1.0) as f32,
            _ => rng.f32(),
        }),
        node: rng.u8(0..128).into(),
        ..Case::default()
    }
    .with_luts(p)
}

/// A case's inputs in words, one a line.
pub fn describe(case: &Case) -> String {
    let m = &case.medium;
    format!(
        "planet radius {} km, shell {} km\n\
         gas {:?} 1/km, scale height {} km\n\
         aerosol scattering {:?} extinction {:?} 1/km, scale height {} km, g {:?}\n\
         absorber {:?} 1/km, centre {} km, half width {} km\n\
         altitude {} km, direction {:?}, sun {:?}, share of the ray {}\n\
         path from r²-R² {} km² with rμ {} km over {} km; {} steps, {} towards the sun; 1 - cos {}\n\
         place in a LUT {:?}, {}; direction {} of a node",
        m.radius,
        m.thickness,
        m.rayleigh,
        1.0 / m.rayleigh_inv_height,
        m.mie_scattering,
        m.mie_extinction,
        1.0 / m.mie_inv_height,
        m.mie_asymmetry,
        m.ozone,
        m.ozone_center,
        1.0 / m.ozone_inv_half_width,
        case.altitude,
        case.direction,
        case.sun,
        case.fraction,
        case.path_excess,
        case.path_r_mu,
        case.path_distance,
        case.samples,
        case.light_samples,
        case.away,
        case.uv,
        if case.to_ground > 0.5 { "to the ground" } else { "to the sky" },
        case.node,
    )
}
