//! Light for a scene of one's own: in space, on the ground and between, as an engine's shaders want it.
//!
//! Two ways lead to a [`LightingContext`]:
//!
//! * by constants: [`lighting_context_at_altitude`] blends a context of the ground into [`LightingContext::space`],
//!   [`modulate_ambient_by_sun`] dims it at night;
//! * by physics: [`sunlight`] is what the air leaves of the sun's light, and a [`SkyLight`] the light of the simulated sky,
//!   as irradiance and as spherical harmonics, from the tables that draw it.
//!
//! [`LightingContextUniform`] is the block that `lighting.wgsl` (in [`crate::shaders::MODULES`]) reads.

use glam::{DVec3, Vec3};

use crate::error::{Error, Result, in_range};
use crate::frame::lut::MediumTables;
use crate::frame::uniforms::block;
use crate::gpu::{Backend, ReadId};
use crate::model::atmosphere::AtmosphereParams;
use crate::reference::single::{RayQuery, Tolerance, transmittance};

/// What a place does to light: how much comes from the sky, and how dark shadows are.
#[derive(Clone, Debug, PartialEq)]
pub struct LightingContext {
    /// Colour of the light from the sky; zero in space.
    pub ambient_color: Vec3,
    /// Multiplies it, 0 to 1.
    pub ambient_intensity: f32,
    /// Light in the darkest shadow as a share of that outside, 0 (black, in space) to 1 (no shadow).
    pub shadow_min_light: f32,
    /// 0 in space to 1 in all of the air.
    pub atmosphere_density: f32,
}

impl LightingContext {
    /// No air: no light but the sun's, and black shadows.
    pub fn space() -> Self {
        Self { ambient_color: Vec3::ZERO, ambient_intensity: 0.0, shadow_min_light: 0.0, atmosphere_density: 0.0 }
    }

    /// The seed document's constants for the ground of an Earth by day; colours are a matter of taste here.
    pub fn earth_like_surface() -> Self {
        Self {
            ambient_color: Vec3::new(0.4, 0.5, 0.7),
            ambient_intensity: 0.15,
            shadow_min_light: 0.08,
            atmosphere_density: 1.0,
        }
    }
}

/// Between which altitudes the light of the ground turns into that of space. Metres above the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtmosphereConfig {
    /// Below it the ground's context holds unchanged. 0 to 1e9.
    pub atmosphere_start: f64,
    /// Above it there is none of it left. More than `atmosphere_start`, up to 1e9.
    pub atmosphere_end: f64,
}

impl Default for AtmosphereConfig {
    /// The Earth's: 10 km and 100 km.
    fn default() -> Self {
        Self { atmosphere_start: 10_000.0, atmosphere_end: 100_000.0 }
    }
}

impl AtmosphereConfig {
    /// Checks the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first that is wrong.
    pub fn validate(&self) -> Result<()> {
        in_range("atmosphere_start", self.atmosphere_start, 0.0, 1e9, "m")?;
        in_range("atmosphere_end", self.atmosphere_end, 0.0, 1e9, "m")?;
        if self.atmosphere_end <= self.atmosphere_start {
            return Err(Error::invalid("atmosphere_end", self.atmosphere_end, "above atmosphere_start"));
        }
        Ok(())
    }
}

/// The context at an altitude (metres): the surface's below `atmosphere_start`, that of space above `atmosphere_end`, and
/// between them a smooth step. Any altitude gives a finite context; one that is no number, that of space.
pub fn lighting_context_at_altitude(
    altitude: f64,
    config: &AtmosphereConfig,
    surface_context: &LightingContext,
) -> LightingContext {
    let AtmosphereConfig { atmosphere_start: start, atmosphere_end: end } = *config;
    if altitude <= start {
        return surface_context.clone();
    }
    if !(altitude < end && end > start) {
        return LightingContext::space();
    }
    let t = ((altitude - start) / (end - start)).clamp(0.0, 1.0) as f32;
    let left = 1.0 - t * t * (3.0 - 2.0 * t);
    LightingContext {
        ambient_color: surface_context.ambient_color * left,
        ambient_intensity: surface_context.ambient_intensity * left,
        shadow_min_light: surface_context.shadow_min_light * left,
        atmosphere_density: surface_context.atmosphere_density * left,
    }
}

/// Ambient light by the sine of the sun's elevation, -1 to 1: all of it from 0.25 up, a twentieth (stars, moon)
/// from -0.225 down.
pub fn modulate_ambient_by_sun(base_ambient: Vec3, sun_elevation: f32) -> Vec3 {
    base_ambient * (sun_elevation * 2.0 + 0.5).clamp(0.05, 1.0)
}

block! {
    /// `struct LightingContext` in `lighting.wgsl`: 32 bytes.
    LightingContextUniform {
        /// Ambient colour times intensity; last the light in the darkest shadow.
        ambient_shadow: [f32; 4],
        /// Density of the air, then padding.
        atmosphere_padding: [f32; 4],
    }
}

impl From<&LightingContext> for LightingContextUniform {
    fn from(context: &LightingContext) -> Self {
        let ambient = context.ambient_color * context.ambient_intensity;
        Self {
            ambient_shadow: ambient.extend(context.shadow_min_light).to_array(),
            atmosphere_padding: [context.atmosphere_density, 0.0, 0.0, 0.0],
        }
    }
}

/// Irradiance by the sun on a plane that faces it, at an altitude (metres, ground level below 0) where its centre stands
/// at the given sine of elevation (-1 to 1): what the air leaves of [`AtmosphereParams::sun_intensity`], 0 behind the
/// planet. Within 0.1 %.
///
/// # Errors
/// [`crate::ErrorKind::Invalid`] from [`AtmosphereParams::validate`] and for inputs out of range.
pub fn sunlight(params: &AtmosphereParams, altitude: f64, sun_sine: f64) -> Result<[f64; 3]> {
    in_range("sun_sine", sun_sine, -1.0, 1.0, "")?;
    in_range("altitude", altitude, -1e15, 1e15, "m")?;
    let h = altitude.max(0.0);
    let radius = params.planet_radius;
    // Sine of the horizon's dip: sqrt(r² - R²) / r.
    if sun_sine < -(h * (2.0 * radius + h)).sqrt() / (radius + h) {
        params.validate()?;
        return Ok([0.0; 3]);
    }
    let zenith = sun_sine.acos();
    let query = RayQuery::new(h, zenith, zenith, 0.0);
    Ok(transmittance(params, &query, Tolerance::PICTURE)?.map(|t| t * params.sun_intensity))
}

/// Real spherical harmonics up to degree 2 of the light that arrives from all directions, per channel, in the order
/// (0,0), (1,-1), (1,0), (1,1), (2,-2), (2,-1), (2,0), (2,1), (2,2), normalised to 1 over the sphere.
///
/// z is up, the sun stands in the half plane of +x. Radiance times steradian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkyHarmonics(pub [[f64; 3]; 9]);

/// `sqrt(1 / 4π)`, `sqrt(3 / 4π)`, `sqrt(5 / 16π)`, `sqrt(15 / 4π)`, `sqrt(15 / 16π)`.
const SH: [f64; 5] = [
    0.282_094_791_773_878_14,
    0.488_602_511_902_919_9,
    0.315_391_565_252_520_05,
    1.092_548_430_592_079_2,
    0.546_274_215_296_039_6,
];

impl SkyHarmonics {
    /// The harmonics themselves in a direction of length 1.
    pub fn basis(n: DVec3) -> [f64; 9] {
        [
            SH[0],
            SH[1] * n.y,
            SH[1] * n.z,
            SH[1] * n.x,
            SH[3] * n.x * n.y,
            SH[3] * n.y * n.z,
            SH[2] * (3.0 * n.z * n.z - 1.0),
            SH[3] * n.x * n.z,
            SH[4] * (n.x * n.x - n.y * n.y),
        ]
    }

    /// Irradiance of a plane that faces a direction of length 1 (Ramamoorthi & Hanrahan 2001, equation 8), never
    /// negative. Degree 2 leaves out some per cent where one half of the sphere is much brighter than the other.
    pub fn irradiance(&self, normal: DVec3) -> [f64; 3] {
        use std::f64::consts::PI;
        const DEGREE: [usize; 9] = [0, 1, 1, 1, 2, 2, 2, 2, 2];
        let (basis, lobe) = (Self::basis(normal), [PI, 2.0 * PI / 3.0, PI / 4.0]);
        std::array::from_fn(|c| (0..9).map(|i| lobe[DEGREE[i]] * self.0[i][c] * basis[i]).sum::<f64>().max(0.0))
    }
}

/// A read-back of the sky's light that was begun; see [`crate::SkyRenderer::begin_sky_light`].
#[derive(Debug)]
pub struct SkyLightRead {
    pub(crate) read: ReadId,
    pub(crate) params: AtmosphereParams,
    pub(crate) made_for: MediumTables,
    pub(crate) nodes: [u32; 2],
}

impl SkyLightRead {
    /// The light once it is there; `None` until then. In a browser nothing waits for it; natively this call does, as
    /// [`Backend::poll_read`].
    ///
    /// # Errors
    /// Those of the backend.
    pub fn poll(&self, backend: &mut dyn Backend) -> Result<Option<SkyLight>> {
        let texels = backend.poll_read(self.read)?;
        Ok(texels.map(|texels| SkyLight {
            params: self.params.clone(),
            made_for: self.made_for,
            nodes: self.nodes.map(|n| n as usize),
            texels,
        }))
    }
}

/// The light of a simulated sky, of all orders of scattering, for every altitude and every elevation of the sun: one
/// read-back per medium is enough.
#[derive(Clone, Debug)]
pub struct SkyLight {
    params: AtmosphereParams,
    made_for: MediumTables,
    nodes: [usize; 2],
    texels: Vec<f32>,
}

/// Rows per altitude in the table of moments.
const ROWS: usize = 6;

impl SkyLight {
    /// Where altitude and sun are among the nodes: `tables.wgsl`'s `altitude_share` and `sun_share`, in f64.
    fn at(&self, altitude: f64, sun_sine: f64) -> [(usize, f64); 2] {
        let t = &self.made_for.tables;
        let h = (altitude / self.params.thickness()).clamp(0.0, 1.0);
        let row = ((h * f64::from(t.altitude_growth)).ln_1p() / f64::from(t.altitude_steepness)).sqrt();
        let y = (sun_sine - f64::from(t.sun_middle)) / f64::from(t.sun_width);
        let column = (y.asinh() - f64::from(t.sun_first)) / f64::from(t.sun_span);
        let place = |share: f64, count: usize| {
            let at = share.clamp(0.0, 1.0) * (count - 1) as f64;
            let low = (at as usize).min(count - 2);
            (low, at - low as f64)
        };
        [place(column, self.nodes[0]), place(row, self.nodes[1])]
    }

    fn texel(&self, column: usize, row: usize, channel: usize) -> f64 {
        f64::from(self.texels[4 * (row * self.nodes[0] + column) + channel])
    }

    /// Irradiance of level ground from the sky, the sun's own light not counted. `sun_sine`: of the elevation of the sun's
    /// centre, -1 to 1.
    ///
    /// # Errors
    /// As [`sunlight`].
    pub fn ground_irradiance(&self, sun_sine: f64) -> Result<[f64; 3]> {
        let beam = sunlight(&self.params, 0.0, sun_sine)?;
        let [(column, part), _] = self.at(0.0, sun_sine);
        let row = self.nodes[1] * ROWS;
        let forward = self.forward(0.0, sun_sine)?;
        Ok(std::array::from_fn(|c| {
            let log = self.texel(column, row, c) * (1.0 - part) + self.texel(column + 1, row, c) * part;
            log.exp2() * self.params.sun_intensity + (forward[c] - beam[c]) * sun_sine.max(0.0)
        }))
    }

    /// Sunlight with what the aerosol turns by small angles only, which the tables count as not scattered.
    fn forward(&self, altitude: f64, sun_sine: f64) -> Result<[f64; 3]> {
        let mut straight = self.params.clone();
        let kept: [f64; 3] = std::array::from_fn(|c| f64::from(self.made_for.tables.mie_extinction[c]) / 1e3);
        straight.mie_absorption = [0.0; 3];
        straight.mie_scattering = kept;
        sunlight(&straight, altitude, sun_sine)
    }

    /// All light at an altitude (metres) that was scattered at least once, by the air or by the ground.
    pub fn harmonics(&self, altitude: f64, sun_sine: f64) -> SkyHarmonics {
        let [(column, a), (row, b)] = self.at(altitude, sun_sine.clamp(-1.0, 1.0));
        let mix = |index: usize, c: usize| {
            let along = |row: usize| {
                let row = row * ROWS + index;
                self.texel(column, row, c) * (1.0 - a) + self.texel(column + 1, row, c) * a
            };
            along(row) * (1.0 - b) + along(row + 1) * b
        };
        let moment = |index: usize| -> [f64; 3] {
            std::array::from_fn(|c| {
                let mean = mix(0, c).exp2() * self.params.sun_intensity;
                if index == 0 { mean } else { mix(index, c) * mean }
            })
        };
        // The table has those that are even about the sun's plane: (0,0), (1,0), (1,1), (2,0), (2,1), (2,2).
        let none = [0.0; 3];
        let [zero, up, along, up2, up_along, along2] = [0, 1, 2, 3, 4, 5].map(moment);
        SkyHarmonics([zero, none, up, along, none, none, up2, up_along, along2])
    }

    /// The physical context at an altitude (metres): a white ground under its sky shines as bright as
    /// [`LightingContext::ambient_color`], and shadows have the sky's share of all light on level ground.
    ///
    /// # Errors
    /// As [`sunlight`].
    pub fn context(&self, altitude: f64, sun_sine: f64) -> Result<LightingContext> {
        let sky = self.harmonics(altitude, sun_sine).irradiance(DVec3::Z);
        let beam = sunlight(&self.params, altitude, sun_sine)?.map(|v| v * sun_sine.max(0.0));
        let [sky_sum, all] = [sky.iter().sum::<f64>(), sky.iter().chain(&beam).sum()];
        let density = self.params.densities(altitude)[0];
        Ok(LightingContext {
            ambient_color: DVec3::from(sky.map(|v| v / std::f64::consts::PI)).as_vec3(),
            ambient_intensity: if sky_sum > 0.0 { 1.0 } else { 0.0 },
            shadow_min_light: if all > 0.0 { (sky_sum / all) as f32 } else { 0.0 },
            atmosphere_density: if altitude > self.params.thickness() { 0.0 } else { density as f32 },
        })
    }
}
