//! The air for a scene's own shaders: which LUTs they read, and the block of `lib/scene_air.wgsl`.

use super::Frame;
use super::graph::{Reads, Resource, reads};
use super::luts::{LutsUniform, MIE_SINGLE, SKY_VIEW};
use super::uniforms::{FrameUniform, block};
use crate::model::atmosphere::MiePhase;

block! {
    /// `struct SceneAir` in `lib/scene_air.wgsl`: see the fields' comments there.
    #[allow(missing_docs)]
    SceneAirUniform {
        frame: FrameUniform,
        luts: LutsUniform,
        zenith_x: [f32; 3],
        present: f32,
        zenith_y: [f32; 3],
        cornette_shanks: f32,
        zenith_z: [f32; 3],
        mie_light: f32,
        harmonics_00: [f32; 4],
        harmonics_1y: [f32; 4],
        harmonics_1z: [f32; 4],
        harmonics_1x: [f32; 4],
        harmonics_2xy: [f32; 4],
        harmonics_2yz: [f32; 4],
        harmonics_2zz: [f32; 4],
        harmonics_2xz: [f32; 4],
        harmonics_2xx: [f32; 4],
    }
}

impl SceneAirUniform {
    /// With light from all sides: real spherical harmonics in the order of
    /// [`SkyHarmonics`](crate::render::sky_light::SkyHarmonics).
    pub(crate) fn with_harmonics(self, light: [[f64; 3]; 9]) -> Self {
        let [a, b, c, d, e, f, g, h, i] = light.map(|[r, g, b]| [r as f32, g as f32, b as f32, 0.0]);
        Self {
            harmonics_00: a,
            harmonics_1y: b,
            harmonics_1z: c,
            harmonics_1x: d,
            harmonics_2xy: e,
            harmonics_2yz: f,
            harmonics_2zz: g,
            harmonics_2xz: h,
            harmonics_2xx: i,
            ..self
        }
    }
}

impl Frame {
    /// Whether the scene's own shaders read the LUTs of the frame's air.
    #[inline(never)]
    pub(crate) fn is_read_by_scene(&self) -> bool {
        self.settings.look.scene_shaders && self.has_air()
    }

    /// Appends the LUTs that the scene's own shaders read, if they read any.
    #[inline(never)]
    pub(crate) fn push_scene_reads(&self, list: &mut Vec<Resource>) {
        if self.is_read_by_scene() {
            list.extend([SKY_VIEW, MIE_SINGLE]);
            list.extend(self.aerial_lut());
        }
    }

    /// The LUTs that the scene's own shaders read, by their names; none where the look asks for none.
    pub(crate) fn scene_reads(&self) -> Reads {
        if !self.is_read_by_scene() || self.luts().is_none() {
            return Reads::default();
        }
        reads([
            ("sky_view_lut", Some(SKY_VIEW)),
            ("aerial_lut", self.aerial_lut()),
            // Any other texture where there is none: it counts for nothing then.
            ("mie_single_lut", Some(if self.has_mie_single() { MIE_SINGLE } else { SKY_VIEW })),
        ])
    }

    /// The block of the scene's own shaders. Under a moon's shadow light is that of the clear sky times what
    /// the moon leaves of the sun at the camera.
    pub(crate) fn scene_air_block(&self) -> SceneAirUniform {
        let p = &self.scene.atmosphere;
        let left = self.sunlight_left();
        let mut frame = self.uniform;
        frame.medium.irradiance = left.map(|left| (left * p.sun_intensity) as f32);
        let axis = |i: usize| self.view.world_to_zenith.row(i).as_vec3().to_array();
        SceneAirUniform {
            frame,
            luts: self.luts_block,
            zenith_x: axis(0),
            present: if self.is_read_by_scene() { 1.0 } else { 0.0 },
            zenith_y: axis(1),
            cornette_shanks: if p.mie_phase == MiePhase::CornetteShanks { 1.0 } else { 0.0 },
            zenith_z: axis(2),
            mie_light: if self.has_mie_single() { 1.0 } else { 0.0 },
            ..SceneAirUniform::default()
        }
    }

    /// Fractions of the sun's light that a moon leaves at the camera, 0 to 1; 1 without a moon.
    pub(crate) fn sunlight_left(&self) -> [f64; 3] {
        let radius = self.scene.atmosphere.sun_angular_radius;
        let moon = self.view.moon.as_ref();
        moon.map_or([1.0; 3], |moon| moon.sunlight(glam::DVec3::ZERO, self.view.sun, radius))
    }
}
