//! The renderer that a user plugs in: the sky behind a scene, and the air before it.

use crate::error::{Error, Result};
use crate::frame::Frame;
use crate::frame::graph::{Bindings, Graph, Node, Resource, Stage, StageEnds};
use crate::gpu::{
    Backend, Format, Pass, Target, TextureDesc, TextureId, TexturePool, Viewport, check_open, known,
};
use crate::model::scene::Scene;
use crate::render::scene_air::SceneAir;
use crate::render::sky_light::SkyLightRead;
use crate::settings::{Composition, SkySettings};

/// What of a user's frame the aerial pass reads and draws to. All three have the same size and row order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AerialTargets {
    /// The scene's colour, which the pass reads and dims per channel. [`Composition::Planet`] cannot read it
    /// and lays the air over the target instead: `None` there, and needed everywhere else.
    pub color: Option<TextureId>,
    /// The scene's depth, which the pass reads as [`Scene::depth`] says; not the target's own depth buffer.
    pub depth: TextureId,
    /// Where the air before the scene is drawn; cleared as it says also where no pass draws to it, which then
    /// holds no copy of [`Self::color`] either.
    pub target: Target,
}

/// What of a user's frame the sky is drawn to. What is not given is not drawn, and LUTs that only it would
/// read are not made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameTargets {
    /// Where the sky behind the scene is drawn, before the scene: depth ALWAYS, no depth write. The colour is
    /// added to what is there (stars, say), which the air dims channel by channel, in a pass of its own. The
    /// first pass that draws here clears as the target says, and where none does, one that does nothing else;
    /// opaque black is fastest: nothing is behind the sky then, which is just written. (In a pass of your own
    /// something always may be.)
    pub background: Option<Target>,
    /// What the air before the scene reads and draws to, after the scene.
    pub aerial: Option<AerialTargets>,
    /// A texture of numbers ([`Format::R32Float`], or any colour) as large as the targets that says in its
    /// red how much of the light is there that the air sends into a pixel's ray up to the scene, 0 to 1
    /// (clamped): less where clouds or mountains hide the sun from a part of the ray, by a shadow map along
    /// it, say. The aerial pass dims its light by that; what lies behind is dimmed as before, and your
    /// ground's own shadow is yours to draw. [`Composition::AtmospherePost`] draws the sky there too, for
    /// shafts before it.
    ///
    /// It dims all light that is drawn: light scattered once in a march, light of all orders from LUTs, of
    /// which a shadow leaves what was scattered before. Say so in the texture, which need not go down to 0.
    pub lit_fraction: Option<TextureId>,
}

impl FrameTargets {
    /// The sky behind the scene alone.
    pub fn background(target: Target) -> Self {
        Self { background: Some(target), ..Self::default() }
    }

    /// The same with the air before the scene.
    pub fn with_aerial(self, aerial: AerialTargets) -> Self {
        Self { aerial: Some(aerial), ..self }
    }

    /// The same with a texture that says how much of the light along each ray is there.
    pub fn with_lit_fraction(self, texture: TextureId) -> Self {
        Self { lit_fraction: Some(texture), ..self }
    }
}

/// The passes of one frame; empty lists where the scene calls for nothing. Run [`Self::background`], draw
/// your scene, run [`Self::aerial`].
#[derive(Clone, Copy, Debug)]
pub struct SkyFrame<'a> {
    /// LUTs that are not up to date, then the sky behind the scene.
    pub background: &'a [Pass],
    /// The air before the scene.
    pub aerial: &'a [Pass],
    /// The texture that holds the frame once all has run: the aerial target where a pass draws the air to it;
    /// else what the scene is drawn to, for there is no air before it (from space looking away, say).
    pub color: TextureId,
    /// The air for the scene's own shaders, once [`Self::background`] has run, where
    /// [`Look::scene_shaders`](crate::Look::scene_shaders) asks for it.
    pub air: Option<SceneAir>,
    /// What the frame has, and why.
    pub frame: &'a Frame,
}

/// Draws the sky behind a scene and the air before it: [`Self::frame`] gives the passes of one frame.
///
/// Nothing is allocated in a steady frame.
#[derive(Debug, Default)]
pub struct SkyRenderer {
    settings: SkySettings,
    graph: Graph,
    pool: TexturePool,
    passes: Vec<Pass>,
    ends: StageEnds,
    frame: Option<Frame>,
}

impl SkyRenderer {
    /// A renderer with the given settings.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`SkySettings::validate`].
    pub fn new(settings: SkySettings) -> Result<Self> {
        settings.validate()?;
        Ok(Self { settings, ..Self::default() })
    }

    /// The settings in use.
    pub fn settings(&self) -> &SkySettings {
        &self.settings
    }

    /// Changes the settings; on an error the old ones stay.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`SkySettings::validate`].
    pub fn set_settings(&mut self, settings: SkySettings) -> Result<()> {
        settings.validate()?;
        self.settings = settings;
        Ok(())
    }

    /// What a scene would call for in a picture of a size in pixels, before nothing
    /// ([`FrameTargets::background`]), after the frame that was drawn last: see [`Frame::after`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] as for [`Frame::new`].
    pub fn plan(&self, scene: &Scene, size: [u32; 2]) -> Result<Frame> {
        match &self.frame {
            Some(last) => Frame::after(last, scene, &self.settings, size),
            None => Frame::new(scene, &self.settings, size),
        }
    }

    /// The frame whose passes were given out last.
    pub fn last_frame(&self) -> Option<&Frame> {
        self.frame.as_ref()
    }

    /// The passes of one frame, for [`Backend::run`] or for recording into an encoder of your own.
    ///
    /// LUTs that are up to date are not made again; a LUT counts as made once its passes have run.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`], for textures that the backend does not know,
    /// for sizes or row orders that differ, and for a missing [`AerialTargets::color`]; all before anything
    /// is created. Errors of the backend.
    pub fn frame(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        targets: &FrameTargets,
    ) -> Result<SkyFrame<'_>> {
        let desc = self.check(backend, targets)?;
        let viewport = self.viewport(targets, &desc)?;
        let size = viewport.map_or([desc.width, desc.height], |v| [v.width, v.height]);
        let mut frame = Frame::checked(scene, &self.settings, size, desc.rows, self.frame.as_ref())?;
        if let Some(Viewport { x, y, .. }) = viewport {
            frame.uniform = frame.uniform.moved(&frame.view, size, desc.rows, [x, y]);
        }
        frame.lit_fraction = targets.lit_fraction.is_some();
        let black = |clear: [f32; 4]| clear[..3] == [0.0; 3];
        frame.behind = targets.background.is_some_and(|target| !target.clear.is_some_and(black));
        let drawn = targets.background.iter().chain(targets.aerial.iter().map(|a| &a.target));
        let formats = drawn.filter_map(|target| backend.texture(target.color)).map(|desc| desc.format);
        frame.uniform = frame.uniform.drawn_to(formats);
        let frame = self.frame.insert(frame);
        let bindings = Bindings {
            background: targets.background,
            scene_color: targets.aerial.and_then(|a| a.color),
            scene_depth: targets.aerial.map(|a| a.depth),
            lit_fraction: targets.lit_fraction,
            aerial: targets.aerial.map(|a| a.target),
            ..Bindings::default()
        };
        self.graph.list(frame, |target| bindings.has(target), None);
        for (stage, resource) in
            [(Stage::Background, Resource::Background), (Stage::Aerial, Resource::Aerial)]
        {
            let clears =
                bindings.target(resource).is_some_and(|t| t.clear.is_some() || t.clear_depth.is_some());
            if clears && !self.graph.nodes.iter().any(|n| n.writes == resource) {
                self.graph.insert(Node::clear("clear", stage, resource));
            }
        }
        let has_air =
            self.graph.nodes.iter().any(|n| n.writes == Resource::Aerial && n.work.program().is_some());
        let scene_color = bindings.scene_color.or(targets.background.map(|t| t.color));
        let color = match &targets.aerial {
            Some(aerial) if has_air => aerial.target.color,
            aerial => scene_color.or(aerial.map(|a| a.target.color)).ok_or_else(no_targets)?,
        };
        self.passes.clear();
        self.ends = self.graph.passes(backend, &mut self.pool, frame, &bindings, &mut self.passes)?;
        let air = SceneAir::of(frame, backend, &self.graph, &mut self.pool)?;
        Ok(SkyFrame {
            background: self.ends.of(Stage::Background, &self.passes),
            aerial: self.ends.of(Stage::Aerial, &self.passes),
            color,
            air,
            frame,
        })
    }

    /// Checks the targets; answers what they have in common.
    fn check(&self, backend: &dyn Backend, targets: &FrameTargets) -> Result<TextureDesc> {
        let background = targets.background.map(|t| known(backend, "background", t.color)).transpose()?;
        for target in targets.background.iter().chain(targets.aerial.iter().map(|a| &a.target)) {
            if !backend.is_texture(target.color) {
                check_open(target, known(backend, "target", target.color)?.label)?;
            }
        }
        let Some(aerial) = &targets.aerial else {
            if targets.lit_fraction.is_some() {
                return Err(Error::invalid("lit fraction", "a texture", "none without an aerial target"));
            }
            return background.ok_or_else(no_targets);
        };
        let desc = known(backend, "aerial target", aerial.target.color)?;
        let depth = same_size(backend, "aerial depth", aerial.depth, &desc)?;
        if !matches!(depth.format, Format::Depth32Float | Format::R32Float) {
            let value = format_args!("{} ({:?})", depth.label, depth.format);
            let allowed = "the scene's depth, Depth32Float or as numbers in R32Float";
            return Err(Error::invalid("aerial depth", value, allowed));
        }
        match (aerial.color, self.settings.look.composition) {
            (_, Composition::Planet) => {}
            (Some(color), _) => {
                let color = same_size(backend, "aerial color", color, &desc)?;
                if color.format.channels() != 4 {
                    let value = format_args!("{} ({:?})", color.label, color.format);
                    return Err(Error::invalid("aerial color", value, "the scene's color, of four channels"));
                }
            }
            (None, composition) => {
                let allowed = format_args!("a texture to read, as composition {composition:?} wants");
                return Err(Error::invalid("aerial color", "none", allowed));
            }
        }
        if let Some(visibility) = targets.lit_fraction {
            same_size(backend, "lit fraction", visibility, &desc)?;
        }
        if let Some(target) = targets.background {
            same_size(backend, "background", target.color, &desc)?;
        }
        Ok(desc)
    }

    /// The part of the targets that is drawn to, of which both have the same.
    fn viewport(&self, targets: &FrameTargets, desc: &TextureDesc) -> Result<Option<Viewport>> {
        let given = [targets.background, targets.aerial.map(|a| a.target)];
        let mut given = given.into_iter().flatten().map(|target| target.viewport);
        let viewport = given.next().flatten();
        if given.any(|other| other != viewport) {
            return Err(Error::invalid("aerial.viewport", "another", "that of the background"));
        }
        let Some(viewport) = viewport else { return Ok(None) };
        viewport.validate(desc)?;
        if self.settings.render_scale < 1.0 {
            let allowed = "1 where a target has a viewport";
            return Err(Error::invalid("render_scale", self.settings.render_scale, allowed));
        }
        Ok(Some(viewport))
    }

    /// Asks for the light of the sky that was drawn last, for a scene's own shading: see
    /// [`SkyLight`](crate::SkyLight). `None` where the frame has no LUT of it, or the passes that fill it
    /// have not run yet: ask again in the next frame then. Passes in an encoder of yours have run once it was
    /// submitted and the GPU is done with it.
    ///
    /// # Errors
    /// Those of the backend.
    pub fn begin_sky_light(&mut self, backend: &mut dyn Backend) -> Result<Option<SkyLightRead>> {
        let Some(frame) = &self.frame else { return Ok(None) };
        let Some(lut) = frame.multi_scattering() else { return Ok(None) };
        let Some(id) = self.graph.finished(backend, &mut self.pool, lut) else { return Ok(None) };
        SkyLightRead::begin(backend, id, frame).map(Some)
    }

    /// Frees what this renderer made on a backend.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.pool.destroy(backend);
    }

    /// The parts that a picture composes its own frame of.
    pub(crate) fn parts(&mut self) -> (&mut Graph, &mut TexturePool, &mut Option<Frame>) {
        (&mut self.graph, &mut self.pool, &mut self.frame)
    }
}

/// The error for a frame that is drawn to nothing.
fn no_targets() -> Error {
    Error::invalid("targets", "none", "a background, an aerial target or both")
}

/// Checks that a texture covers the same pixels as the target; answers what it is.
fn same_size(backend: &dyn Backend, name: &str, id: TextureId, target: &TextureDesc) -> Result<TextureDesc> {
    let other = known(backend, name, id)?;
    if (other.width, other.height, other.rows) == (target.width, target.height, target.rows) {
        return Ok(other);
    }
    Err(Error::invalid(
        name,
        format_args!("{} × {}, {:?}", other.width, other.height, other.rows),
        format_args!("as the target: {} × {}, {:?}", target.width, target.height, target.rows),
    ))
}
