//! The light of the simulated sky for a scene of one's own: as irradiance and as spherical harmonics, from
//! the LUTs that draw it.
//!
//! [`LightingContextUniform`] is the block that `lib/lighting.wgsl` ([`crate::shaders::LIGHTING_WGSL`])
//! reads.

use glam::DVec3;

use crate::error::{Error, Result};
use crate::frame::Frame;
use crate::frame::luts::LutsUniform;
use crate::frame::uniforms::block;
use crate::gpu::{Backend, ReadId, TextureId, Ticket};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::lighting::LightingContext;
use crate::model::sunlight::sunlight;
use crate::settings::{LutSettings, Quality};

block! {
    /// `struct LightingContext` in `lib/lighting.wgsl`: 32 bytes.
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

/// Real spherical harmonics up to degree 2 of the light that arrives from all directions, per channel, in the
/// order (0,0), (1,-1), (1,0), (1,1), (2,-2), (2,-1), (2,0), (2,1), (2,2), normalised to 1 over the sphere.
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

    /// Irradiance of a plane that faces a direction of length 1 (Ramamoorthi & Hanrahan 2001, equation 8),
    /// never negative. Degree 2 leaves out some per cent where one half of the sphere is much brighter than
    /// the other.
    pub fn irradiance(&self, normal: DVec3) -> [f64; 3] {
        use std::f64::consts::PI;
        const DEGREE: [usize; 9] = [0, 1, 1, 1, 2, 2, 2, 2, 2];
        let (basis, lobe) = (Self::basis(normal), [PI, 2.0 * PI / 3.0, PI / 4.0]);
        std::array::from_fn(|c| {
            (0..9).map(|i| lobe[DEGREE[i]] * self.0[i][c] * basis[i]).sum::<f64>().max(0.0)
        })
    }
}

/// A read-back of the sky's light that was begun; see [`crate::SkyRenderer::begin_sky_light`]. Dropped, it is
/// given up.
#[derive(Debug)]
pub struct SkyLightRead {
    read: Ticket<ReadId>,
    params: AtmosphereParams,
    luts: LutsUniform,
    nodes: [u32; 2],
}

impl SkyLightRead {
    /// Begins to read the multi-scattering LUT of a frame.
    pub(crate) fn begin(backend: &mut dyn Backend, lut: TextureId, frame: &Frame) -> Result<Self> {
        let Quality::Luts(LutSettings { multi_scattering: nodes, .. }) = frame.settings().quality else {
            return Err(Error::invalid("quality", frame.settings().quality, "one with LUTs"));
        };
        let read = backend.begin_read(lut)?;
        Ok(Self { read, params: frame.scene().atmosphere.clone(), luts: frame.luts_block, nodes })
    }

    /// The light once it is there; `None` until then. Does not wait: ask again in the next frame, or call
    /// [`Self::wait`].
    ///
    /// # Errors
    /// Those of the backend.
    pub fn poll(&self, backend: &mut dyn Backend) -> Result<Option<SkyLight>> {
        let texels = backend.poll_read(&self.read)?;
        Ok(texels.map(|texels| SkyLight {
            params: self.params.clone(),
            luts: self.luts,
            nodes: self.nodes.map(|n| n as usize),
            texels,
        }))
    }

    /// The light, waited for.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] in a browser, where nothing can wait; those of the backend.
    pub fn wait(&self, backend: &mut dyn Backend) -> Result<SkyLight> {
        backend.wait()?;
        self.poll(backend)?.ok_or_else(|| crate::gpu::cannot_wait(backend.info().backend))
    }
}

/// Keeps the light of the sky that a renderer draws: read once a medium, without waiting for the GPU.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
#[derive(Debug, Default)]
pub(crate) struct KeptLight {
    light: Option<SkyLight>,
    pending: Option<SkyLightRead>,
}

#[cfg(any(feature = "wgpu", feature = "webgl"))]
impl KeptLight {
    /// Asks for the light of a medium where it is not there; another medium's is forgotten.
    pub fn step(
        &mut self,
        backend: &mut dyn Backend,
        medium: &AtmosphereParams,
        begin: impl FnOnce(&mut dyn Backend) -> Result<Option<SkyLightRead>>,
    ) -> Result<()> {
        if let Some(read) = &self.pending
            && let Some(light) = read.poll(backend)?
        {
            (self.light, self.pending) = (Some(light), None);
        }
        // Light is in proportion to the sun's.
        let sun_intensity = medium.sun_intensity;
        self.light = self.light.take().and_then(|mut light| {
            light.params.sun_intensity = sun_intensity;
            (light.params == *medium).then_some(light)
        });
        if self.pending.is_none() && self.light.is_none() {
            self.pending = begin(backend)?;
        }
        Ok(())
    }

    /// The light, once it is there.
    pub fn get(&self) -> Option<&SkyLight> {
        self.light.as_ref()
    }
}

/// The light of a simulated sky, of all orders of scattering, for every altitude and every elevation of the
/// sun: one read-back per medium is enough.
#[derive(Clone, Debug)]
pub struct SkyLight {
    params: AtmosphereParams,
    luts: LutsUniform,
    nodes: [usize; 2],
    texels: Vec<f32>,
}

/// Rows per altitude in the LUT of moments.
const ROWS: usize = crate::shaders::multi_scattering_lut::numbers::MOMENTS as usize;

impl SkyLight {
    /// Where altitude and sun are among the nodes: `altitude_to_v` and `mu_sun_to_u` of
    /// `lib/multi_scattering_lut.wgsl`, in f64.
    fn at(&self, altitude: f64, sun_sine: f64) -> [(usize, f64); 2] {
        let t = &self.luts;
        let h = ((altitude - self.params.lowest_ground) / self.params.thickness()).clamp(0.0, 1.0);
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

    /// Irradiance of level ground, the lowest, from the sky, the sun's own light not counted. `sun_sine`: of
    /// the elevation of the sun's centre, -1 to 1.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] as for [`sunlight`].
    pub fn ground_irradiance(&self, sun_sine: f64) -> Result<[f64; 3]> {
        let lowest = self.params.lowest_ground;
        let beam = sunlight(&self.params, lowest, sun_sine)?;
        let [(column, part), _] = self.at(lowest, sun_sine);
        let row = self.nodes[1] * ROWS;
        let forward = self.forward(lowest, sun_sine)?;
        Ok(std::array::from_fn(|c| {
            let log = self.texel(column, row, c) * (1.0 - part) + self.texel(column + 1, row, c) * part;
            log.exp2() * self.params.sun_intensity + (forward[c] - beam[c]) * sun_sine.max(0.0)
        }))
    }

    /// Sunlight with what the aerosol turns by small angles only, which the LUTs count as not scattered.
    fn forward(&self, altitude: f64, sun_sine: f64) -> Result<[f64; 3]> {
        let mut straight = self.params.clone();
        let kept: [f64; 3] = std::array::from_fn(|c| f64::from(self.luts.mie_extinction[c]) / 1e3);
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
        // The LUT has those that are even about the sun's plane: (0,0), (1,0), (1,1), (2,0), (2,1), (2,2).
        let none = [0.0; 3];
        let [zero, up, along, up2, up_along, along2] = [0, 1, 2, 3, 4, 5].map(moment);
        SkyHarmonics([zero, none, up, along, none, none, up2, up_along, along2])
    }

    /// The physical context at an altitude (metres): a white ground under its sky shines as bright as
    /// [`LightingContext::ambient_color`], and shadows have the sky's share of all light on level ground.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] as for [`sunlight`].
    pub fn context(&self, altitude: f64, sun_sine: f64) -> Result<LightingContext> {
        let sky = self.harmonics(altitude, sun_sine).irradiance(DVec3::Z);
        let beam = sunlight(&self.params, altitude, sun_sine)?.map(|v| v * sun_sine.max(0.0));
        let [sky_sum, all] = [sky.iter().sum::<f64>(), sky.iter().chain(&beam).sum()];
        let density = self.params.densities(altitude)[0];
        Ok(LightingContext {
            ambient_color: DVec3::from(sky.map(|v| v / std::f64::consts::PI)).as_vec3(),
            ambient_intensity: if sky_sum > 0.0 { 1.0 } else { 0.0 },
            shadow_min_light: if all > 0.0 { (sky_sum / all) as f32 } else { 0.0 },
            atmosphere_density: if altitude > self.params.top_altitude() { 0.0 } else { density as f32 },
        })
    }
}
