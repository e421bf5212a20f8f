//! The renderer that a user plugs in: background sky, and air before the scene.

use std::fmt;

use super::frame::{FrameOptions, FrameUniform};
use crate::backend::{Backend, DepthUse, Format, Pass, Target, TextureDesc, TextureId, Uniform};
use crate::error::{Error, Result, in_range};
use crate::shaders::{Constituents, Program};
use crate::view::{Scene, ZenithView};

/// How the sky's light is computed, and how finely.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// Light scattered once, marched along the view ray and from each step towards the sun. What is
    /// scattered more often is missing.
    Single {
        /// Steps along the view ray, 1 to 1024.
        view_samples: u32,
        /// Steps towards the sun at each of them, 1 to 256.
        light_samples: u32,
    },
}

impl Method {
    /// Its short name, as in tables and on the command line: `single`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Single { .. } => "single",
        }
    }

    /// Whether it computes light scattered once and no more.
    pub const fn is_single_scattering(&self) -> bool {
        match self {
            Self::Single { .. } => true,
        }
    }

    /// Its numbers in short, as in tables: `16 × 8`.
    pub fn numbers(&self) -> String {
        match self {
            Self::Single { view_samples, light_samples } => format!("{view_samples} × {light_samples}"),
        }
    }

    /// Checks the ranges given at the variants' fields; errors name these fields.
    pub fn validate(&self) -> Result<()> {
        let whole = |name: &str, v: u32, hi: u32| {
            if (1..=hi).contains(&v) { Ok(()) } else { Err(Error::invalid(name, v, format_args!("from 1 to {hi}"))) }
        };
        match *self {
            Self::Single { view_samples, light_samples } => {
                whole("view_samples", view_samples, 1024)?;
                whole("light_samples", light_samples, 256)
            }
        }
    }

    /// Steps along a view ray and from each towards the sun, for passes that march both.
    fn samples(&self) -> [u32; 2] {
        match *self {
            Self::Single { view_samples, light_samples } => [view_samples, light_samples],
        }
    }
}

impl fmt::Display for Method {
    /// Name and numbers: `single 16 × 8`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name(), self.numbers())
    }
}

/// What may be turned on a [`SkyRenderer`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkySettings {
    /// Off: no passes at all.
    pub enabled: bool,
    /// How the light is computed.
    pub method: Method,
    /// Background resolution as a share of the target's, per side, 0.125 to 1.
    pub render_scale: f64,
    /// Whether the background holds the sun's disk.
    pub sun_disk: bool,
}

impl Default for SkySettings {
    /// Single scattering by 24 × 8 samples, full resolution, with the sun.
    fn default() -> Self {
        let method = Method::Single { view_samples: 24, light_samples: 8 };
        Self { enabled: true, method, render_scale: 1.0, sun_disk: true }
    }
}

impl SkySettings {
    /// Checks the method and the ranges given at the fields.
    pub fn validate(&self) -> Result<()> {
        self.method.validate()?;
        in_range("render_scale", self.render_scale, 0.125, 1.0, "")?;
        Ok(())
    }
}

/// Altitudes over which the background pass hands the sky over to the depth-aware pass, metres.
pub const HAND_OVER: (f64, f64) = (15_000.0, 50_000.0);

/// Share of the background pass in the sky's light at a camera altitude (metres): 1 below 15 km, 0 above
/// 50 km, `1 - smoothstep` between. The depth-aware pass draws the rest, so their sum does not change.
pub fn background_weight(altitude: f64) -> f64 {
    let t = ((altitude - HAND_OVER.0) / (HAND_OVER.1 - HAND_OVER.0)).clamp(0.0, 1.0);
    1.0 - t * t * (3.0 - 2.0 * t)
}

/// Draws the sky behind a scene and the air before it.
///
/// Each method returns passes for [`Backend::run`] (or for recording into your own encoder); an empty
/// list means that this scene calls for nothing. Buffers are reused: a frame allocates nothing.
#[derive(Debug, Default)]
pub struct SkyRenderer {
    settings: SkySettings,
    passes: Vec<Pass>,
    low: Option<TextureId>,
}

impl SkyRenderer {
    /// A renderer with the given settings.
    ///
    /// # Errors
    /// [`Error::Invalid`] from [`SkySettings::validate`].
    pub fn new(settings: SkySettings) -> Result<Self> {
        settings.validate()?;
        Ok(Self { settings, passes: Vec::with_capacity(2), low: None })
    }

    /// The settings in use.
    pub fn settings(&self) -> &SkySettings {
        &self.settings
    }

    /// Changes the settings; on an error the old ones stay.
    pub fn set_settings(&mut self, settings: SkySettings) -> Result<()> {
        settings.validate()?;
        self.settings = settings;
        Ok(())
    }

    fn options(&self, desc: &TextureDesc, view: &ZenithView) -> FrameOptions {
        let [view_samples, light_samples] = self.settings.method.samples();
        FrameOptions {
            size: [desc.width, desc.height],
            rows: desc.rows,
            view_samples,
            light_samples,
            sky_weight: background_weight(view.altitude),
            low_resolution: false,
        }
    }

    /// The background sky, to be drawn first: depth ALWAYS, no depth write. Rays that meet the planet
    /// draw nothing. Above 50 km only the sun is left of it; [`Self::aerial`] draws the rest.
    ///
    /// The colour is laid over what is in the target (stars, say), which the air dims by its grey mean.
    ///
    /// # Errors
    /// [`Error::Invalid`] from [`Scene::validate`], before anything is created; errors of the backend.
    pub fn background(&mut self, backend: &mut dyn Backend, scene: &Scene, target: Target) -> Result<&[Pass]> {
        let view = scene.validate()?;
        self.passes.clear();
        let desc = texture(backend, target.color)?;
        let mut options = self.options(&desc, &view);
        let air = if options.sky_weight > 0.0 { Constituents::of(&scene.atmosphere) } else { Constituents::default() };
        let sun = self.settings.sun_disk && scene.atmosphere.sun_intensity > 0.0;
        if !self.settings.enabled || !(air.any() || sun) {
            self.free_low(backend);
            return Ok(&self.passes);
        }
        let program = Some(backend.create_program(Program::Sky { air, sun })?);
        let label = "background sky";
        let side = |s: u32| ((f64::from(s) * self.settings.render_scale).ceil() as u32).max(1);
        let small = [side(desc.width), side(desc.height)];
        let full = Uniform::new(&FrameUniform::new(scene, &view, &options));
        if small == options.size {
            self.free_low(backend);
            self.passes.push(Pass {
                label,
                program,
                textures: [None; 2],
                uniform: full,
                target,
                depth: DepthUse::Always,
            });
            return Ok(&self.passes);
        }
        let low = self.low_texture(backend, small)?;
        options.size = small;
        options.low_resolution = true;
        self.passes.push(Pass {
            label,
            program,
            textures: [None; 2],
            uniform: Uniform::new(&FrameUniform::new(scene, &view, &options)),
            target: Target { clear: Some([0.0; 4]), ..Target::color(low) },
            depth: DepthUse::Always,
        });
        self.passes.push(Pass {
            label: "upsample sky",
            program: Some(backend.create_program(Program::Upsample)?),
            textures: [Some(low), None],
            uniform: full,
            target,
            depth: DepthUse::Always,
        });
        Ok(&self.passes)
    }

    /// Air between the camera and the scene: reads the scene's colour and depth and writes to another
    /// texture of the same size, `scene × transmittance + light`, per channel. With the background pass
    /// fading out from 15 to 50 km it draws the rest of the sky: the limb and the shell around the planet.
    ///
    /// # Errors
    /// As [`Self::background`]; [`Error::Invalid`] if sizes or row orders differ.
    pub fn aerial(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        color: TextureId,
        depth: TextureId,
        target: TextureId,
    ) -> Result<&[Pass]> {
        let view = scene.validate()?;
        self.passes.clear();
        let desc = texture(backend, target)?;
        for (name, id) in [("color", color), ("depth", depth)] {
            let other = texture(backend, id)?;
            if (other.width, other.height, other.rows) != (desc.width, desc.height, desc.rows) {
                return Err(Error::invalid(
                    format_args!("aerial {name}"),
                    format_args!("{} × {}, {:?}", other.width, other.height, other.rows),
                    format_args!("as the target: {} × {}, {:?}", desc.width, desc.height, desc.rows),
                ));
            }
        }
        let air = Constituents::of(&scene.atmosphere);
        if self.settings.enabled && air.any() {
            self.passes.push(Pass {
                label: "aerial perspective",
                program: Some(backend.create_program(Program::Aerial { air })?),
                textures: [Some(color), Some(depth)],
                uniform: Uniform::new(&FrameUniform::new(scene, &view, &self.options(&desc, &view))),
                target: Target::color(target),
                depth: DepthUse::Always,
            });
        }
        Ok(&self.passes)
    }

    /// Frees what this renderer made on a backend.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.free_low(backend);
    }

    fn free_low(&mut self, backend: &mut dyn Backend) {
        if let Some(low) = self.low.take() {
            backend.destroy_texture(low);
        }
    }

    fn low_texture(&mut self, backend: &mut dyn Backend, [width, height]: [u32; 2]) -> Result<TextureId> {
        if let Some(low) = self.low {
            if backend.texture(low).is_some_and(|d| (d.width, d.height) == (width, height)) {
                return Ok(low);
            }
            self.free_low(backend);
        }
        let low =
            backend.create_texture(&TextureDesc::new("low-resolution sky", width, height, Format::Rgba16Float))?;
        self.low = Some(low);
        Ok(low)
    }
}

pub(crate) fn texture(backend: &dyn Backend, id: TextureId) -> Result<TextureDesc> {
    backend.texture(id).ok_or_else(|| crate::backend::unknown(backend.info().backend, "texture"))
}
