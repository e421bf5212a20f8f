//! The demonstration's terrain: a planet-scale height field, so that occlusion and depth are real.
//!
//! It stands in for a user's own scene. The mesh is made in the vertex shader (`pass/terrain.wgsl`); the same
//! height field is here in f64, for cameras that shall stand on it and for the CPU renderer.

use glam::{DVec3, IVec3};

use super::eclipse::{MOON_SHADOW, ShadowUniform};
use super::graph::{Node, Resource, Stage, reads};
use super::luts::LutsUniform;
use super::uniforms::{FrameUniform, block};
use super::{Air, Frame};
use crate::gpu::{DepthUse, Uniform};
use crate::model::atmosphere::AtmosphereParams;
use crate::shaders::terrain;

block! {
    /// `struct Terrain` in `pass/terrain.wgsl`.
    #[allow(missing_docs)]
    TerrainUniform {
        frame: FrameUniform,
        axis: [f32; 3],
        amplitude: f32,
        grid_x: [f32; 3],
        arc_scale: f32,
        grid_y: [f32; 3],
        arc_rate: f32,
        planet_x: [f32; 3],
        sea: f32,
        planet_y: [f32; 3],
        offset_x: f32,
        planet_z: [f32; 3],
        offset_y: f32,
        low_albedo: [f32; 3],
        mountain_rate: f32,
        high_albedo: [f32; 3],
        snow_line: f32,
        sky_light: [f32; 3],
        pad: f32,
        luts: LutsUniform,
        moon_shadow: ShadowUniform,
    }
}

/// What the ground looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TerrainStyle {
    /// Height of the highest mountains, metres.
    pub amplitude: f64,
    /// Distance between mountain ranges, metres.
    pub range_spacing: f64,
    /// Whether the lowest places are water.
    pub sea: bool,
    /// Albedo of plains, 0 to 1.
    pub low_albedo: [f64; 3],
    /// Albedo of rock, 0 to 1.
    pub high_albedo: [f64; 3],
    /// Metres above which snow lies; infinite for none.
    pub snow_line: f64,
}

impl TerrainStyle {
    /// Green plains, grey rock, snow and sea.
    pub fn earth() -> Self {
        Self {
            amplitude: 8000.0,
            range_spacing: 40_000.0,
            sea: true,
            low_albedo: [0.09, 0.11, 0.045],
            high_albedo: [0.19, 0.17, 0.15],
            snow_line: 3200.0,
        }
    }

    /// Dry ground in the planet's own albedo.
    pub fn dry(params: &AtmosphereParams) -> Self {
        Self {
            amplitude: 6000.0_f64.min(params.planet_radius * 1e-3),
            range_spacing: 60_000.0_f64.min(params.planet_radius * 0.03),
            sea: false,
            low_albedo: params.ground_albedo,
            high_albedo: params.ground_albedo.map(|a| a * 0.7),
            snow_line: f64::INFINITY,
        }
    }
}

/// `lattice` in `lib/noise.wgsl`.
fn lattice(p: IVec3) -> f64 {
    let mut h = (p.x as u32).wrapping_mul(0x8da6_b343)
        ^ (p.y as u32).wrapping_mul(0xd816_3841)
        ^ (p.z as u32).wrapping_mul(0xcb1a_b31f);
    h = (h ^ (h >> 13)).wrapping_mul(0x5bd1_e995);
    h = (h ^ (h >> 15)).wrapping_mul(0x2c1b_3c6d);
    h ^= h >> 14;
    f64::from(h >> 8) / 16_777_216.0
}

/// `noise` in `lib/noise.wgsl`: value and gradient.
fn noise(p: DVec3) -> (f64, DVec3) {
    let cell = p.floor();
    let i = cell.as_ivec3();
    let f = p - cell;
    let w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let dw = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let at = |x, y, z| lattice(i + IVec3::new(x, y, z));
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let (v000, v100, v010, v110) = (at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(1, 1, 0));
    let (v001, v101, v011, v111) = (at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), at(1, 1, 1));
    let (x00, x10, x01, x11) =
        (mix(v000, v100, w.x), mix(v010, v110, w.x), mix(v001, v101, w.x), mix(v011, v111, w.x));
    let (y0, y1) = (mix(x00, x10, w.y), mix(x01, x11, w.y));
    let dx = mix(mix(v100 - v000, v110 - v010, w.y), mix(v101 - v001, v111 - v011, w.y), w.z);
    let dy = mix(x10 - x00, x11 - x01, w.z);
    (mix(y0, y1, w.z), DVec3::new(dx, dy, y1 - y0) * dw)
}

impl TerrainStyle {
    fn mountain_rate(&self, radius: f64) -> f64 {
        radius / self.range_spacing
    }

    /// Height above the surface (metres, ≥ 0) and its gradient (metres per radian) below a unit direction
    /// in the planet's own axes. `height_field` in `pass/terrain.wgsl`.
    pub fn height(&self, n: DVec3, planet_radius: f64) -> (f64, DVec3) {
        let mut land = (0.0, DVec3::ZERO);
        for (rate, shift, gain) in [(2.3, 11.0, 0.6), (5.1, 5.0, 0.3), (13.7, 3.0, 0.1)] {
            let (v, g) = noise(n * rate + shift);
            land = (land.0 + v * gain, land.1 + g * (rate * gain));
        }
        let (coast, slope) = (if self.sea { 0.48 } else { 0.25 }, 14.0);
        let rise = (land.0 - coast) * slope;
        if rise <= 0.0 {
            return (0.0, DVec3::ZERO);
        }
        let above = rise.min(1.0);
        let d_above = if rise < 1.0 { land.1 * slope } else { DVec3::ZERO };
        let (belt_noise, belt_gradient) = noise(n * 9.0 + 29.0);
        let t = ((belt_noise - 0.38) * 4.0).clamp(0.0, 1.0);
        let belt = 0.1 + 0.9 * t * t * (3.0 - 2.0 * t);
        let d_belt = belt_gradient * (9.0 * 0.9 * 6.0 * t * (1.0 - t) * 4.0);
        let mut ridge = (0.0, DVec3::ZERO);
        let (mut frequency, mut gain) = (self.mountain_rate(planet_radius), 0.55);
        for octave in 0..6 {
            let (v, g) = noise(n * frequency + f64::from(octave) * 17.0);
            let s = if v < 0.5 { 2.0 } else { -2.0 };
            ridge = (ridge.0 + (1.0 - (2.0 * v - 1.0).abs()) * gain, ridge.1 + g * (s * frequency * gain));
            frequency *= 2.03;
            gain *= 0.45;
        }
        let height = above * belt * ridge.0;
        let gradient = d_above * (belt * ridge.0) + d_belt * (above * ridge.0) + ridge.1 * (above * belt);
        (height * self.amplitude, gradient * self.amplitude)
    }

    /// Sky light on level ground per unit of the sun's irradiance, sun in the zenith: half of what a
    /// vertical beam loses to scattering. A rough stand-in where no table holds the sky's irradiance.
    pub fn sky_light(params: &AtmosphereParams) -> [f64; 3] {
        std::array::from_fn(|c| {
            let tau = params.rayleigh_scattering[c] * params.rayleigh_scale_height
                + params.mie_scattering[c] * params.mie_scale_height;
            0.5 * -(-tau).exp_m1()
        })
    }

    /// The node that draws the ground with depth, after the sky. The target's depth must be cleared to
    /// [`crate::DepthConvention::background`].
    pub(crate) fn node(&self, of: &Frame) -> Node {
        let (scene, view, frame) = (&of.scene, &of.view, of.uniform);
        let rows = view.axes;
        let to_zenith = |v: DVec3| (rows * v).as_vec3().to_array();
        let (radius, h) = (scene.atmosphere.planet_radius, view.altitude.max(1.0));
        // Arc to the horizon, and on to where the highest mountain would still peep over it.
        let dip = |h: f64| (h * (2.0 * radius + h)).sqrt().atan2(radius);
        let arc_max = (dip(h) + 1.05 * dip(self.amplitude)).min(3.0);
        let arc_scale = 0.25 * h / radius;
        let up = view.from_center.normalize();
        let east = DVec3::Z.cross(up);
        let east = if east.length() > 1e-3 { east.normalize() } else { DVec3::Y.cross(up).normalize() };
        let b = &view.basis;
        let axis = b.right.cross(b.up).normalize();
        // right × up points backwards in a right-handed frame.
        let axis = if axis.dot(b.forward) < 0.0 { -axis } else { axis };
        let offset = |side: DVec3| (b.forward.dot(side) / side.length_squared()) as f32;
        // Columns of the matrix are the zenith frame's axes in world coordinates, transposed: rows to go
        // back.
        let back = rows.transpose();
        let row = |i: usize| back.row(i).as_vec3().to_array();
        let color = |c: [f64; 3]| c.map(|v| v as f32);
        let uniform = TerrainUniform {
            frame,
            axis: axis.as_vec3().to_array(),
            amplitude: (self.amplitude / 1000.0) as f32,
            grid_x: to_zenith(east),
            arc_scale: arc_scale as f32,
            grid_y: to_zenith(up.cross(east)),
            arc_rate: (((0.5 * arc_max).tan() / arc_scale).asinh() / f64::from(terrain::numbers::RINGS))
                as f32,
            planet_x: row(0),
            sea: if self.sea { 1.0 } else { 0.0 },
            planet_y: row(1),
            offset_x: offset(b.right),
            planet_z: row(2),
            offset_y: offset(b.up),
            low_albedo: color(self.low_albedo),
            mountain_rate: self.mountain_rate(radius) as f32,
            high_albedo: color(self.high_albedo),
            snow_line: (self.snow_line / 1000.0).min(1e6) as f32,
            sky_light: color(Self::sky_light(&scene.atmosphere)),
            pad: 0.0,
            luts: if of.rounds() > 0 { of.luts_block } else { LutsUniform::default() },
            moon_shadow: of.moon_shadow_block().unwrap_or_default(),
        };
        let light = of.multi_scattering();
        let shadow = of.moon_shadow().map(|_| MOON_SHADOW);
        let program =
            Air::ALL.program(&terrain::INFO, [("SKY_LIGHT", light.is_some()), ("MOON", shadow.is_some())]);
        Node {
            uniform: Uniform::new(&uniform),
            reads: reads([("moon_shadow_lut", shadow), ("multi_scattering_lut", light)]),
            depth: DepthUse::Nearer { reversed: scene.depth.is_reversed() },
            ..Node::draw("terrain", Stage::Scene, program, Resource::Background)
        }
    }
}
