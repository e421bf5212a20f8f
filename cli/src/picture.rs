//! A picture as it is asked for, and as it is drawn.

use welkin::gpu::Format;
use welkin::{PictureSettings, SkySettings, TerrainStyle, ToneMap};

use crate::args::look::LookArgs;
use crate::args::scene::FramedScene;

/// Everything that one picture depends on.
#[derive(Clone, Debug)]
pub struct RenderRequest {
    /// Camera, planet, air and sun.
    pub scene: welkin::Scene,
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// Look and quality of the sky.
    pub sky: SkySettings,
    /// Radiance is multiplied by this before tone mapping.
    pub exposure: f32,
    /// The tone curve.
    pub tone_map: ToneMap,
    /// Whether noise of one step is added before display values are rounded.
    pub dither: bool,
    /// The ground; `None` leaves it out.
    pub terrain: Option<TerrainStyle>,
    /// What the picture's radiance is drawn in: halves, where the brightest is cut at 32,000 (the sun's disk
    /// is brighter), or 32-bit floats, where nothing is.
    pub radiance: Format,
}

impl RenderRequest {
    /// A scene drawn as the options say, with this sky, for display.
    pub fn new(framed: FramedScene, look: &LookArgs, sky: SkySettings) -> Self {
        let FramedScene { view, scene, terrain, size: [width, height] } = framed;
        let (tone_map, dither) = (look.tone_map(), look.dither());
        Self {
            scene,
            width,
            height,
            sky,
            exposure: view.exposure,
            tone_map,
            dither,
            terrain,
            radiance: Format::Rgba16Float,
        }
    }

    /// What the library's renderer is told.
    pub fn settings(&self) -> PictureSettings {
        PictureSettings {
            sky: self.sky,
            exposure: self.exposure.into(),
            tone_map: self.tone_map,
            dither: self.dither,
            terrain: self.terrain,
            radiance: self.radiance,
        }
    }
}

/// A drawn [`RenderRequest`].
#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// Linear radiance before exposure, row 0 at the top.
    pub hdr: Vec<[f32; 4]>,
    /// sRGB after exposure and tone mapping, row 0 at the top.
    pub display: Vec<[u8; 4]>,
}
