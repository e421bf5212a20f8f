//! A whole picture in the right order: sky, terrain, air, tone mapping.

use super::sky::{GroundLight, SkyRenderer, SkySettings};
use crate::error::Result;
use crate::frame::plan::{Bound, EffectPlan};
use crate::frame::terrain::TerrainStyle;
use crate::frame::tone_map::{ToneMap, tone_pass};
use crate::gpu::{Backend, DepthUse, Format, Pass, Target, TextureDesc, TextureId, Uniform, reads};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::Scene;

/// What a [`PictureRenderer`] draws with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSettings {
    /// The sky's.
    pub sky: SkySettings,
    /// Display units per unit of radiance, 0 to 1e9.
    pub exposure: f64,
    /// How radiance becomes display values.
    pub tone_map: ToneMap,
    /// Whether display values get noise of one 8-bit step, so that gradients show no bands; their mean stays. See
    /// [`super::tone::dither`].
    pub dither: bool,
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
            dither: true,
            terrain: Some(TerrainStyle::earth()),
            radiance: Format::Rgba16Float,
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Textures {
    scene: TextureId,
    depth: TextureId,
    aerial: TextureId,
    /// Where nobody else gave one.
    display: Option<TextureId>,
}

impl Textures {
    fn ids(&self) -> [TextureId; 3] {
        [self.scene, self.depth, self.aerial]
    }

    /// Of a picture, in the order of [`Self::ids`], the display last.
    fn descs([width, height]: [u32; 2], radiance: Format) -> [TextureDesc; 4] {
        let formats = [radiance, Format::Depth32Float, radiance, Format::Rgba8];
        let mut descs = LABELS.map(|label| TextureDesc::new(label, width, height, radiance));
        descs.iter_mut().zip(formats).for_each(|(desc, format)| desc.format = format);
        descs
    }
}

/// Tell a picture's textures from others, which have their ids where a device was lost and another is used.
const LABELS: [&str; 4] = ["picture's scene", "picture's depth", "picture's air", "picture's display"];

/// Where a finished picture is.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// Radiance times [`Self::scale`], before tone mapping.
    pub radiance: TextureId,
    /// Power of two: see [`scale`].
    pub scale: f64,
    /// The scene's depth.
    pub depth: TextureId,
    /// sRGB; [`Format::Rgba8`] unless it is the caller's.
    pub display: TextureId,
}

/// What radiance is multiplied by while it is drawn: the power of two next below `exposure`, so that the range of half
/// floats, from 6e-8 to 65504, lies around what the display shows and not around 1. Twilight needs that, with radiance
/// from 1e-6 down and an exposure to match. 1 for an exposure of 0; never so much that `sun_intensity` (both as in
/// [`PictureSettings`] and [`crate::AtmosphereParams`]) leaves its range. Multiplying by it rounds nothing.
pub fn scale(exposure: f64, sun_intensity: f64) -> f64 {
    const BRIGHTEST: f64 = 1e6; // of sun_intensity
    // A float without its fraction's bits is the power of two next below it.
    let floor = |v: f64| f64::from_bits(v.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE);
    if exposure > 0.0 { floor(exposure.min(BRIGHTEST / sun_intensity)) } else { 1.0 }
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
    /// The passes of one picture, in order, and where they leave it. Run all of them before you ask for the next: what these
    /// leave (tables, an empty depth buffer) is not made again.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a scene, a setting or a size that is out of range, before anything is
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
        let foreground = settings.sky.foreground && settings.terrain.is_some();
        settings.sky.validate()?;
        crate::error::in_range("exposure", settings.exposure, 0.0, 1e9, "")?;
        let sun_intensity = scene.atmosphere.sun_intensity;
        let scale = scale(settings.exposure, sun_intensity);
        let bound = settings.sky.bound.map(|b| Bound { absolute: (b.absolute * scale).min(1e6), ..b });
        self.sky.set_settings(SkySettings { foreground, bound, ..settings.sky })?;
        let atmosphere = AtmosphereParams { sun_intensity: sun_intensity * scale, ..scene.atmosphere.clone() };
        let scene = &Scene { atmosphere, ..scene.clone() };
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
        let mut light = GroundLight::default();
        if settings.terrain.is_some() {
            let (passes, found) = self.sky.ground_light(backend, scene, size)?;
            self.passes.extend_from_slice(passes);
            light = found;
        }
        self.passes.extend_from_slice(self.sky.background(backend, scene, target)?);
        let drawn = self.passes.iter().any(|p| p.target.color == t.scene);
        let after = if drawn { Target { clear: None, clear_depth: None, ..target } } else { target };
        if let Some(terrain) = &settings.terrain {
            self.passes.push(terrain.pass(backend, scene, after, &light)?);
        } else if !drawn {
            let (textures, uniform, depth) = (reads([]), Uniform::NONE, DepthUse::Always);
            self.passes.push(Pass { label: "clear", program: None, textures, uniform, target, depth });
        }
        let air = self.sky.aerial(backend, scene, t.scene, t.depth, t.aerial)?;
        let radiance = if air.is_empty() { t.scene } else { t.aerial };
        self.passes.extend_from_slice(air);
        self.passes.extend_from_slice(self.sky.shell(backend, scene, t.depth, Target::color(t.scene))?);
        let PictureSettings { tone_map, exposure, dither, .. } = *settings;
        self.passes.push(tone_pass(backend, tone_map, exposure / scale, dither, radiance, display)?);
        self.empty_depth = settings.terrain.is_none().then_some(background);
        Ok((&self.passes, Drawn { radiance, scale, depth: t.depth, display }))
    }

    /// The plan of the passes that were handed out last.
    pub fn plan(&self) -> Option<&EffectPlan> {
        self.sky.last_plan()
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
            for (id, label) in t.ids().into_iter().chain(t.display).zip(LABELS) {
                if backend.texture(id).is_some_and(|desc| desc.label == label) {
                    backend.destroy_texture(id);
                }
            }
        }
    }

    fn add_display(&mut self, backend: &mut dyn Backend, size: [u32; 2]) -> Result<TextureId> {
        let [.., desc] = Textures::descs(size, Format::Rgba8);
        let made = backend.create_texture(&desc)?;
        if let Some(t) = &mut self.textures {
            t.display = Some(made);
        }
        Ok(made)
    }

    fn textures(&mut self, backend: &mut dyn Backend, size: [u32; 2], radiance: Format) -> Result<Textures> {
        let fits = |t: &Textures| {
            let descs = Textures::descs(size, radiance);
            t.ids().into_iter().chain(t.display).zip(descs).all(|(id, desc)| backend.texture(id) == Some(desc))
        };
        if let Some(t) = self.textures.filter(fits) {
            return Ok(t);
        }
        let [width, height] = size;
        // Sizes are checked before the old textures go.
        TextureDesc::new("picture", width, height, radiance).validate(backend.info().max_texture_size)?;
        self.free(backend);
        let [descs @ .., _] = Textures::descs(size, radiance);
        let mut made = Vec::with_capacity(descs.len());
        for desc in descs {
            match backend.create_texture(&desc) {
                Ok(id) => made.push(id),
                Err(e) => {
                    made.into_iter().for_each(|id| backend.destroy_texture(id));
                    return Err(e);
                }
            }
        }
        let t = Textures { scene: made[0], depth: made[1], aerial: made[2], display: None };
        self.textures = Some(t);
        Ok(t)
    }
}
