//! A whole picture in the right order: sky, terrain, air, tone mapping.

use crate::error::{Error, Result, in_range};
use crate::frame::Frame;
use crate::frame::graph::{Bindings, Graph, Node, Resource, Stage};
use crate::frame::terrain::TerrainStyle;
use crate::frame::tone_map::{Display, is_8_bit};
use crate::gpu::{Backend, Format, Pass, PoolKey, RowOrder, Target, TextureDesc, TextureId, known};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::Scene;
use crate::render::scene_air::SceneAir;
use crate::render::sky::SkyRenderer;
use crate::render::sky_light::SkyLightRead;
use crate::settings::{Bound, Composition, Look, SkySettings, ToneMap};

/// What a [`PictureRenderer`] draws with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSettings {
    /// The sky's.
    pub sky: SkySettings,
    /// Display units per unit of radiance, 0 to 1e9.
    pub exposure: f64,
    /// How radiance becomes display values.
    pub tone_map: ToneMap,
    /// Whether display values get noise of one 8-bit step, so that gradients show no bands; their mean stays.
    /// See
    /// [`dither`](crate::frame::tone_map::dither).
    pub dither: bool,
    /// The ground; `None` draws none.
    pub terrain: Option<TerrainStyle>,
    /// Format of the radiance before tone mapping: `Rgba16Float` or `Rgba32Float` (needs float blending).
    pub radiance: Format,
}

impl PictureSettings {
    /// Checks the ranges.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for an exposure outside 0 to 1e9, and from [`SkySettings::validate`].
    pub fn validate(&self) -> Result<()> {
        in_range("exposure", self.exposure, 0.0, 1e9, "")?;
        self.sky.validate()
    }
}

impl Default for PictureSettings {
    /// The sky's defaults, exposure 1 (for a sun of 22), the default [`ToneMap`], dither, the Earth's ground,
    /// halves.
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

/// Largest [`AtmosphereParams::sun_intensity`].
const BRIGHTEST: f64 = 1e6;

/// What radiance is multiplied by while it is drawn: the power of two next below `exposure`, so that the
/// range of half floats, from 6e-8 to 65504, lies around what the display shows and not around 1. Twilight
/// needs that, with radiance from 1e-6 down and an exposure to match. 1 for an exposure of 0; never so much
/// that `sun_intensity` (both as in
/// [`PictureSettings`] and [`crate::AtmosphereParams`]) leaves its range. Multiplying by it rounds nothing.
pub fn scale(exposure: f64, sun_intensity: f64) -> f64 {
    // A float without its fraction's bits is the power of two next below it.
    let floor = |v: f64| f64::from_bits(v.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE);
    if exposure > 0.0 { floor(exposure.min(BRIGHTEST / sun_intensity)) } else { 1.0 }
}

/// A picture's textures in the pool.
const SCENE_COLOR: PoolKey = PoolKey { name: "scene_color", index: 0 };
const SCENE_DEPTH: PoolKey = PoolKey { name: "scene_depth", index: 0 };
const AERIAL: PoolKey = PoolKey { name: "aerial_color", index: 0 };
const DISPLAY: PoolKey = PoolKey { name: "display", index: 0 };

/// What is drawn between the sky behind it and the air before it.
#[derive(Clone, Copy, PartialEq)]
enum Between {
    /// The ground of [`PictureSettings::terrain`], if there is one.
    Terrain,
    /// What a user draws, in units of radiance.
    Users,
}

/// The scene and the settings with radiance times [`scale`], which is the third.
fn as_drawn(
    scene: &Scene,
    settings: &PictureSettings,
    between: Between,
) -> Result<(Scene, SkySettings, f64)> {
    settings.sky.validate()?;
    let sun_intensity = scene.atmosphere.sun_intensity;
    // One that is out of range is reported as it was given.
    let scale = if between == Between::Terrain && (0.0..=BRIGHTEST).contains(&sun_intensity) {
        scale(settings.exposure, sun_intensity)
    } else {
        1.0
    };
    let atmosphere = AtmosphereParams { sun_intensity: sun_intensity * scale, ..scene.atmosphere.clone() };
    let something = between == Between::Users || settings.terrain.is_some();
    let foreground = settings.sky.look.foreground && something;
    let sky = SkySettings {
        look: Look { foreground, ..settings.sky.look },
        bound: settings.sky.bound.map(|b| Bound { absolute: (b.absolute * scale).min(1e6), ..b }),
        ..settings.sky
    };
    Ok((Scene { atmosphere, ..scene.clone() }, sky, scale))
}

/// Names the content of a depth buffer that holds the background alone, by the background's depth.
fn empty_depth(background: f32) -> u64 {
    0x656d_7074_7900_0000_u64 ^ u64::from(background.to_bits()) | 1
}

/// Draws pictures of a planet with a ground of its own; used by the command line and by the page.
///
/// In a frame of your own use [`SkyRenderer`].
#[derive(Debug, Default)]
pub struct PictureRenderer {
    sky: SkyRenderer,
    passes: Vec<Pass>,
    /// How many passes there are up to the scene, and up to the air before it.
    stages: [usize; 2],
    /// What the scene is drawn to.
    color: Option<TextureId>,
}

/// A picture around a scene of the user's; see [`PictureRenderer::around`].
#[derive(Clone, Copy, Debug)]
pub struct Around<'a> {
    /// Run these first: they clear [`Self::color`] and [`Self::depth`] and draw the sky behind the scene.
    pub before: &'a [Pass],
    /// Run these after the scene: the air before it, then tone mapping.
    pub after: &'a [Pass],
    /// The first part of [`Self::after`]: the air, which leaves the frame in [`Self::radiance`].
    pub aerial: &'a [Pass],
    /// The rest of it: tone mapping.
    pub display: &'a [Pass],
    /// What the scene is drawn to: linear radiance, in the unit of [`AtmosphereParams::sun_intensity`] per
    /// steradian.
    pub color: TextureId,
    /// What holds the frame's radiance once the air lies before the scene: draw to it what is transparent and
    /// lays the air before itself. It may be [`Self::color`].
    pub radiance: TextureId,
    /// The depth buffer that the scene is drawn with, as [`Scene::depth`] says.
    pub depth: TextureId,
    /// The air for the scene's own shaders, once [`Self::before`] has run, where
    /// [`Look::scene_shaders`] asks for it.
    pub air: Option<SceneAir>,
    /// What the frame has, and why.
    pub frame: &'a Frame,
}

/// The nodes of a picture up to its radiance: those of the frame, with the ground; what nothing draws to is
/// cleared, at the latest in a stage.
pub(crate) fn list(graph: &mut Graph, frame: &Frame, terrain: Option<&TerrainStyle>, by: Stage) {
    graph.list(frame, |_| true, terrain.map(|t| t.node(frame)));
    if !graph.nodes.iter().any(|n| n.writes == Resource::Background && n.stage <= by) {
        graph.insert(Node::clear("clear", by, Resource::Background));
    }
}

/// Where a picture is drawn, and how many pixels it has.
#[derive(Clone, Copy)]
struct Canvas {
    between: Between,
    size: [u32; 2],
    /// Of the textures that the scene is drawn to.
    rows: RowOrder,
    /// The caller's texture with its format and row order; otherwise one of the pool.
    display: Option<(TextureId, TextureDesc)>,
}

impl PictureRenderer {
    /// The passes of one picture, in order, and where they leave it.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a scene, a setting or a size that is out of range, before anything
    /// is created; errors of the backend.
    pub fn passes(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        size: [u32; 2],
    ) -> Result<(&[Pass], Drawn)> {
        let (between, rows) = (Between::Terrain, RowOrder::TopDown);
        self.frame(backend, scene, settings, Canvas { between, size, rows, display: None })
    }

    /// The passes of one picture, drawn straight to a texture of the caller: a canvas, say. Its row order may
    /// be either.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and errors of the backend as for [`Self::passes`].
    pub fn passes_to(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        display: TextureId,
    ) -> Result<(&[Pass], Drawn)> {
        let desc = known(backend, "display", display)?;
        let (between, rows) = (Between::Terrain, RowOrder::TopDown);
        let (size, display) = ([desc.width, desc.height], Some((display, desc)));
        self.frame(backend, scene, settings, Canvas { between, size, rows, display })
    }

    /// A picture around a scene that the caller draws, in textures that are kept from frame to frame, tone
    /// mapped to a texture of the caller's. [`PictureSettings::terrain`] counts for nothing here.
    ///
    /// The textures have the row order of the display. Radiance is not scaled as it is in pictures with a
    /// ground ([`scale`]): see `docs/design.md`, "Half floats", before you draw the night.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and errors of the backend as for [`Self::passes`].
    pub fn around(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        display: TextureId,
    ) -> Result<Around<'_>> {
        let desc = known(backend, "display", display)?;
        let (between, rows) = (Between::Users, desc.rows);
        let (size, display) = ([desc.width, desc.height], Some((display, desc)));
        let (_, drawn) = self.frame(backend, scene, settings, Canvas { between, size, rows, display })?;
        let (graph, pool, last) = self.sky.parts();
        let frame = last.as_ref().ok_or_else(|| Error::invalid("frame", "none", "one"))?;
        let air = SceneAir::of(frame, backend, graph, pool)?;
        let [background, aerial] = self.stages;
        let (before, after) = self.passes.split_at(background);
        let (aerial, display) = after.split_at(aerial - background);
        let color = self.color.unwrap_or(drawn.radiance);
        let Drawn { radiance, depth, .. } = drawn;
        Ok(Around { before, after, aerial, display, color, radiance, depth, air, frame })
    }

    /// Asks for the light of the sky that was drawn last: see [`SkyRenderer::begin_sky_light`].
    ///
    /// # Errors
    /// Those of the backend.
    pub fn begin_sky_light(&mut self, backend: &mut dyn Backend) -> Result<Option<SkyLightRead>> {
        self.sky.begin_sky_light(backend)
    }

    fn frame(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        settings: &PictureSettings,
        canvas: Canvas,
    ) -> Result<(&[Pass], Drawn)> {
        let PictureSettings { exposure, tone_map, .. } = *settings;
        in_range("exposure", exposure, 0.0, 1e9, "")?;
        let [width, height] = canvas.size;
        let max = backend.info().max_texture_size;
        TextureDesc::new("picture", width, height, settings.radiance).validate(max)?;
        check_terrain(scene, settings)?;
        let users = canvas.between == Between::Users;
        let (scene, sky, scale) = as_drawn(scene, settings, canvas.between)?;
        let (graph, pool, last) = self.sky.parts();
        let mut frame = Frame::checked(&scene, &sky, canvas.size, canvas.rows, last.as_ref())?;
        frame.uniform = frame.uniform.drawn_to([settings.radiance]);
        let frame = last.insert(frame);
        if users {
            list(graph, frame, None, Stage::Background);
        } else {
            list(graph, frame, settings.terrain.as_ref(), Stage::Scene);
        }
        let air = graph.nodes.iter().any(|n| n.stage == Stage::Aerial);
        let over = sky.look.composition == Composition::Planet;
        pool.begin(backend);
        let mut texture = |backend: &mut dyn Backend, key: PoolKey, format| {
            let desc = TextureDesc::new(key.name, width, height, format);
            pool.get(backend, key, &TextureDesc { rows: canvas.rows, ..desc })
        };
        let color = texture(backend, SCENE_COLOR, settings.radiance)?;
        let depth = texture(backend, SCENE_DEPTH, Format::Depth32Float)?;
        let radiance = if air && !over { texture(backend, AERIAL, settings.radiance)? } else { color };
        let (display, display_desc) = match canvas.display {
            Some(display) => display,
            None => {
                let id = texture(backend, DISPLAY, Format::Rgba8)?;
                (id, TextureDesc::new(DISPLAY.name, width, height, Format::Rgba8))
            }
        };
        graph.insert(
            Display {
                tone_map,
                exposure: exposure / scale,
                dither: settings.dither && is_8_bit(display_desc.format),
                flipped: display_desc.rows != canvas.rows,
            }
            .node(),
        );
        let background = scene.depth.background() as f32;
        let empty = empty_depth(background);
        let target = Target {
            color,
            depth: Some(depth),
            clear: Some([0.0, 0.0, 0.0, 1.0]),
            // Of ours only terrain writes depth: an empty one stays so.
            clear_depth: (users || backend.content(depth) != empty).then_some(background),
            viewport: None,
        };
        let bindings = Bindings {
            background: Some(target),
            scene_color: Some(color),
            scene_depth: Some(depth),
            lit_fraction: None,
            aerial: Some(Target::color(radiance)),
            radiance: Some(radiance),
            display: Some(display),
        };
        self.passes.clear();
        let ends = graph.passes(backend, pool, frame, &bindings, &mut self.passes)?;
        self.stages = [Stage::Background, Stage::Aerial].map(|stage| ends.end(stage));
        self.color = Some(color);
        if settings.terrain.is_none() && !users {
            let first = self.passes.iter_mut().find(|p| p.target.clear_depth.is_some());
            first.into_iter().for_each(|p| p.depth_content = empty);
        }
        Ok((&self.passes, Drawn { radiance, scale, depth, display }))
    }

    /// The frame whose passes were given out last.
    pub fn last_frame(&self) -> Option<&Frame> {
        self.sky.last_frame()
    }

    /// Makes the passes and runs them.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and errors of the backend as for [`Self::passes`].
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
    }
}

/// Checks that the demonstration's ground can be drawn there.
pub(crate) fn check_terrain(scene: &Scene, settings: &PictureSettings) -> Result<()> {
    if settings.terrain.is_some() && scene.ellipsoid.is_some() {
        let allowed = "none with PictureSettings::terrain: the demonstration's ground is a sphere";
        return Err(Error::invalid("scene.ellipsoid", "an ellipsoid", allowed));
    }
    Ok(())
}
