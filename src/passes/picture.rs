//! A whole picture in the right order: sky, terrain, air, tone mapping.

use super::sky::{SkyRenderer, SkySettings};
use super::terrain::TerrainStyle;
use super::tone::{ToneMap, tone_pass};
use crate::backend::{Backend, Format, Pass, Target, TextureDesc, TextureId, reads};
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
    size: [u32; 2],
    radiance: Format,
    scene: TextureId,
    depth: TextureId,
    aerial: TextureId,
    display: TextureId,
}

/// Where a finished picture is.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// Radiance, before exposure and tone mapping.
    pub radiance: TextureId,
    /// The scene's depth.
    pub depth: TextureId,
    /// sRGB, [`Format::Rgba8`].
    pub display: TextureId,
}

/// Draws pictures of a planet; used by the command line and by the page. Its source is the shortest
/// complete example of a frame.
#[derive(Debug, Default)]
pub struct PictureRenderer {
    sky: SkyRenderer,
    textures: Option<Textures>,
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
        scene.validate()?;
        let foreground = settings.sky.foreground && settings.terrain.is_some();
        self.sky.set_settings(SkySettings { foreground, ..settings.sky })?;
        crate::error::in_range("exposure", settings.exposure, 0.0, 1e9, "")?;
        let t = self.textures(backend, size, settings.radiance)?;
        self.passes.clear();
        let target = Target { depth: Some(t.depth), ..Target::color(t.scene) };
        let mut light = None;
        if settings.terrain.is_some() {
            let (passes, found) = self.sky.ground_light(backend, scene)?;
            self.passes.extend_from_slice(passes);
            light = found;
        }
        self.passes.extend_from_slice(self.sky.background(backend, scene, target)?);
        if let Some(terrain) = &settings.terrain {
            self.passes.push(terrain.pass(backend, scene, target, light)?);
        }
        if self.passes.is_empty() {
            let (textures, uniform) = (reads([]), crate::backend::Uniform::NONE);
            self.passes.push(Pass {
                label: "clear",
                program: None,
                textures,
                uniform,
                target,
                depth: Default::default(),
            });
        }
        // The first pass that draws to the scene clears it.
        if let Some(first) = self.passes.iter_mut().find(|p| p.target.color == t.scene) {
            first.target.clear = Some([0.0, 0.0, 0.0, 1.0]);
            first.target.clear_depth = Some(scene.depth.background() as f32);
        }
        let air = self.sky.aerial(backend, scene, t.scene, t.depth, t.aerial)?;
        let radiance = if air.is_empty() { t.scene } else { t.aerial };
        self.passes.extend_from_slice(air);
        self.passes.extend_from_slice(self.sky.shell(backend, scene, t.depth, Target::color(t.scene))?);
        self.passes.push(tone_pass(backend, settings.tone_map, settings.exposure, radiance, t.display)?);
        Ok((&self.passes, Drawn { radiance, depth: t.depth, display: t.display }))
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
        if let Some(t) = self.textures.take() {
            for id in [t.scene, t.depth, t.aerial, t.display] {
                backend.destroy_texture(id);
            }
        }
    }

    fn textures(&mut self, backend: &mut dyn Backend, size: [u32; 2], radiance: Format) -> Result<Textures> {
        if let Some(t) = self.textures.filter(|t| t.size == size && t.radiance == radiance) {
            return Ok(t);
        }
        let [width, height] = size;
        // Sizes are checked before the old textures go.
        TextureDesc::new("picture", width, height, radiance).validate(backend.info().max_texture_size)?;
        self.free(backend);
        let mut made = Vec::with_capacity(4);
        for (label, format) in
            [("scene", radiance), ("depth", Format::Depth32Float), ("aerial", radiance), ("display", Format::Rgba8)]
        {
            match backend.create_texture(&TextureDesc::new(label, width, height, format)) {
                Ok(id) => made.push(id),
                Err(e) => {
                    made.into_iter().for_each(|id| backend.destroy_texture(id));
                    return Err(e);
                }
            }
        }
        let t = Textures { size, radiance, scene: made[0], depth: made[1], aerial: made[2], display: made[3] };
        self.textures = Some(t);
        Ok(t)
    }
}
