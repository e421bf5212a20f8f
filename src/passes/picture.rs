//! A whole picture in the right order: sky, terrain, air, tone mapping.

use super::sky::{SkyRenderer, SkySettings};
use super::terrain::TerrainStyle;
use super::tone::{ToneMap, tone_pass};
use crate::backend::{Backend, DepthUse, Format, Pass, Target, TextureDesc, TextureId, Uniform, reads};
use crate::error::Result;
use crate::view::Scene;

/// What a [`PictureRenderer`] draws with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSettings {
    /// The sky's.
    pub sky: SkySettings,
    /// Display units per unit of radiance, 0 to 1e9.
    pub exposure: f64,
    /// How radiance becomes display values.
    pub tone_map: ToneMap,
    /// The ground; `None` draws none.
    pub terrain: Option<TerrainStyle>,
    /// Format of the radiance before tone mapping: `Rgba16Float` or `Rgba32Float` (needs float blending).
    pub radiance: Format,
}

impl Default for PictureSettings {
    fn default() -> Self {
        Self {
            sky: SkySettings::default(),
            exposure: 1.0,
            tone_map: ToneMap::default(),
            terrain: Some(TerrainStyle::earth()),
            radiance: Format::Rgba16Float,
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Textures {
    radiance: Format,
    scene: TextureId,
    depth: TextureId,
    aerial: TextureId,
    /// Where nobody else gave one.
    display: Option<TextureId>,
}

/// Where a finished picture is.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// Radiance, before exposure and tone mapping.
    pub radiance: TextureId,
    /// The scene's depth.
    pub depth: TextureId,
    /// sRGB; [`Format::Rgba8`] unless it is the caller's.
    pub display: TextureId,
}

/// Draws pictures of a planet; used by the command line and by the page. Its source is the shortest
/// complete example of a frame.
#[derive(Debug, Default)]
pub struct PictureRenderer {
    sky: SkyRenderer,
    textures: Option<Textures>,
    /// What the depth buffer holds everywhere, once the passes handed out last have run.
    empty_depth: Option<f32>,
    passes: Vec<Pass>,
}

impl PictureRenderer {
    /// The passes of one picture, in order, and where they leave it.
    ///
    /// # Errors
    /// [`crate::Error::Invalid`] for a scene, a setting or a size that is out of range, before anything is
    /// created; errors of the backend.
    pub fn passes(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        size: [u32; 2],
    ) -> Result<(&[Pass], Drawn)> {
        self.frame(backend, scene, settings, size, None)
    }

    /// As [`Self::passes`], drawn straight to a texture of the caller: a canvas, say. Its row order may be either.
    ///
    /// # Errors
    /// As [`Self::passes`].
    pub fn passes_to(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        display: TextureId,
    ) -> Result<(&[Pass], Drawn)> {
        let desc = super::sky::texture(backend, display)?;
        self.frame(backend, scene, settings, [desc.width, desc.height], Some(display))
    }

    fn frame(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        size: [u32; 2],
        display: Option<TextureId>,
    ) -> Result<(&[Pass], Drawn)> {
        scene.validate()?;
        self.sky.set_settings(settings.sky)?;
        crate::error::in_range("exposure", settings.exposure, 0.0, 1e9, "")?;
        let t = self.textures(backend, size, settings.radiance)?;
        let display = match (display, t.display) {
            (Some(display), _) | (None, Some(display)) => display,
            (None, None) => self.add_display(backend, size)?,
        };
        self.passes.clear();
        let background = scene.depth.background() as f32;
        let target = Target {
            color: t.scene,
            depth: Some(t.depth),
            clear: Some([0.0, 0.0, 0.0, 1.0]),
            // Only terrain writes depth: an empty one stays so.
            clear_depth: (self.empty_depth != Some(background)).then_some(background),
        };
        self.passes.extend_from_slice(self.sky.background(backend, scene, target)?);
        let drawn = self.passes.iter().any(|p| p.target.color == t.scene);
        let after = if drawn { Target { clear: None, clear_depth: None, ..target } } else { target };
        if let Some(terrain) = &settings.terrain {
            self.passes.push(terrain.pass(backend, scene, after)?);
        } else if !drawn {
            let (textures, uniform, depth) = (reads([]), Uniform::NONE, DepthUse::Always);
            self.passes.push(Pass { label: "clear", program: None, textures, uniform, target, depth });
        }
        let air = self.sky.aerial(backend, scene, t.scene, t.depth, t.aerial)?;
        let radiance = if air.is_empty() { t.scene } else { t.aerial };
        self.passes.extend_from_slice(air);
        self.passes.extend_from_slice(self.sky.shell(backend, scene, t.depth, Target::color(t.scene))?);
        self.passes.push(tone_pass(backend, settings.tone_map, settings.exposure, radiance, display)?);
        self.empty_depth = settings.terrain.is_none().then_some(background);
        Ok((&self.passes, Drawn { radiance, depth: t.depth, display }))
    }

    /// Makes the passes and runs them.
    pub fn draw(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        size: [u32; 2],
    ) -> Result<Drawn> {
        let (passes, drawn) = self.passes(backend, scene, settings, size)?;
        backend.run(passes)?;
        Ok(drawn)
    }

    /// Frees every texture that it made.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.sky.destroy(backend);
        self.free(backend);
    }

    /// Frees the picture's own textures; the sky's tables do not depend on its size.
    fn free(&mut self, backend: &mut dyn Backend) {
        self.empty_depth = None;
        if let Some(t) = self.textures.take() {
            for id in [t.scene, t.depth, t.aerial].into_iter().chain(t.display) {
                backend.destroy_texture(id);
            }
        }
    }

    fn add_display(&mut self, backend: &mut dyn Backend, [width, height]: [u32; 2]) -> Result<TextureId> {
        let made = backend.create_texture(&TextureDesc::new("display", width, height, Format::Rgba8))?;
        if let Some(t) = &mut self.textures {
            t.display = Some(made);
        }
        Ok(made)
    }

    fn textures(&mut self, backend: &mut dyn Backend, size: [u32; 2], radiance: Format) -> Result<Textures> {
        // Not another's: the ids of a new device begin where a lost one's did.
        let ours = |id: TextureId, label: &str| {
            backend.texture(id).is_some_and(|d| d.label == label && [d.width, d.height] == size)
        };
        if let Some(t) = self.textures.filter(|t| {
            let own = [(t.scene, "scene"), (t.depth, "depth"), (t.aerial, "aerial")];
            t.radiance == radiance
                && own.iter().all(|&(id, label)| ours(id, label))
                && t.display.is_none_or(|id| ours(id, "display"))
        }) {
            return Ok(t);
        }
        let [width, height] = size;
        // Sizes are checked before the old textures go.
        TextureDesc::new("picture", width, height, radiance).validate(backend.info().max_texture_size)?;
        self.free(backend);
        let mut made = Vec::with_capacity(3);
        for (label, format) in [("scene", radiance), ("depth", Format::Depth32Float), ("aerial", radiance)] {
            match backend.create_texture(&TextureDesc::new(label, width, height, format)) {
                Ok(id) => made.push(id),
                Err(e) => {
                    made.into_iter().for_each(|id| backend.destroy_texture(id));
                    return Err(e);
                }
            }
        }
        let t = Textures { radiance, scene: made[0], depth: made[1], aerial: made[2], display: None };
        self.textures = Some(t);
        Ok(t)
    }
}
