//! The renderer that a user plugs in: background sky, and air before the scene.

use std::fmt;

use crate::error::{Error, Quoted, Result, in_range};
use crate::frame::disks::disk_pass;
use crate::frame::eclipse::{EclipseUniform, Shade, ShadowUniform, TEXELS, shadow};
use crate::frame::lut::{FrameTables, IDLE, LutSettings, Luts, TablesUniform};
use crate::frame::plan::{Bound, EffectPlan, TablePlan};
use crate::frame::uniforms::{FrameOptions, FrameUniform};
use crate::gpu::{Backend, DepthUse, Format, Pass, Target, TextureDesc, TextureId, Uniform, reads};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::{Scene, ZenithView};
use crate::render::sky_light::SkyLightRead;
use crate::shaders::Program;

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
    /// Light of all orders, from precomputed tables.
    Lut(LutSettings),
}

impl Method {
    /// Its short name, as in tables and on the command line: `single`, `lut`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Single { .. } => "single",
            Self::Lut(_) => "lut",
        }
    }

    /// Whether it computes light scattered once and no more.
    pub const fn is_single_scattering(&self) -> bool {
        match self {
            Self::Single { .. } => true,
            Self::Lut(_) => false,
        }
    }

    /// Its numbers in short, as in tables: samples, or texels of the sky table and
    /// steps: `16 × 8`, `100 × 100 × 32`.
    pub fn numbers(&self) -> String {
        match self {
            Self::Single { view_samples, light_samples } => format!("{view_samples} × {light_samples}"),
            Self::Lut(LutSettings { sky: [width, height], sky_steps, .. }) => {
                format!("{width} × {height} × {sky_steps}")
            }
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
            Self::Lut(settings) => settings.validate(),
        }
    }
}

impl fmt::Display for Method {
    /// Name and numbers: `single 16 × 8`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name(), self.numbers())
    }
}

/// Which passes draw the atmosphere, and how they share the sky.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Composition {
    /// From the ground to far orbit: [`SkyRenderer::background`] draws the sky near the ground,
    /// [`SkyRenderer::aerial`] the air before the scene and, handed over from 15 to 50 km, the planet's shell.
    #[default]
    Full,
    /// The sky alone, in one pass: [`SkyRenderer::background`], at any altitude.
    SkyDome,
    /// Everything in one pass after the scene, which reads its colour and depth: [`SkyRenderer::aerial`].
    /// [`SkyRenderer::background`] draws the sun's disk only.
    AtmospherePost,
    /// A shell around a planet's mesh, laid over the scene by blending, where its colour cannot be read:
    /// [`SkyRenderer::shell`], which dims it by the grey mean of the transmittance.
    /// [`SkyRenderer::background`] draws the sun's disk only.
    Planet,
}

/// The four ways to use the library, each a composition with a method; see [`Self::settings`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// One pass behind the scene: [`Composition::SkyDome`], single scattering by 24 × 8 samples.
    SkyDome,
    /// One pass over the scene: [`Composition::AtmospherePost`], single scattering by 24 × 8 samples.
    AtmospherePost,
    /// A shell around a mesh: [`Composition::Planet`], single scattering by 24 × 8 samples.
    Planet,
    /// Everything from tables, all orders of scattering: [`Composition::Full`] with [`Method::Lut`].
    Lut,
}

impl Mode {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::SkyDome, Self::AtmospherePost, Self::Planet, Self::Lut];

    /// Its name: `sky-dome`, `atmosphere-post`, `planet`, `lut`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SkyDome => "sky-dome",
            Self::AtmospherePost => "atmosphere-post",
            Self::Planet => "planet",
            Self::Lut => "lut",
        }
    }

    /// By its name; the error lists the names.
    pub fn from_name(name: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|m| m.name() == name)
            .ok_or_else(|| Error::invalid("mode", Quoted(name), "one of sky-dome, atmosphere-post, planet, lut"))
    }

    /// The settings that it stands for.
    pub fn settings(self) -> SkySettings {
        let march = Method::Single { view_samples: 24, light_samples: 8 };
        let (composition, method) = match self {
            Self::SkyDome => (Composition::SkyDome, march),
            Self::AtmospherePost => (Composition::AtmospherePost, march),
            Self::Planet => (Composition::Planet, march),
            Self::Lut => (Composition::Full, Method::Lut(LutSettings::default())),
        };
        SkySettings { composition, method, ..SkySettings::default() }
    }
}

/// What may be turned on a [`SkyRenderer`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkySettings {
    /// Off: no passes at all.
    pub enabled: bool,
    /// Which passes draw it.
    pub composition: Composition,
    /// How the light is computed.
    pub method: Method,
    /// Background resolution as a share of the target's, per side, 0.125 to 1.
    pub render_scale: f64,
    /// Whether the background holds the sun's disk.
    pub sun_disk: bool,
    /// Whether that disk is darker towards its edge ([`crate::model::moon::LIMB_DARKENING`]); its light in all stays the same.
    pub limb_darkening: bool,
    /// Whether something may stand before the sky: `false` promises a depth buffer that holds the background alone.
    pub foreground: bool,
    /// How much pixels may change by what the plan leaves out; `None` leaves nothing out that the settings ask for.
    pub bound: Option<Bound>,
}

impl Default for SkySettings {
    /// From the ground to orbit, all orders of scattering from tables, full resolution, with the sun.
    fn default() -> Self {
        let method = Method::Lut(LutSettings::default());
        Self {
            enabled: true,
            composition: Composition::Full,
            method,
            render_scale: 1.0,
            sun_disk: true,
            limb_darkening: false,
            foreground: true,
            bound: Some(Bound::LINEAR),
        }
    }
}

impl SkySettings {
    /// Checks the method and the ranges given at the fields.
    pub fn validate(&self) -> Result<()> {
        self.method.validate()?;
        in_range("render_scale", self.render_scale, 0.125, 1.0, "")?;
        self.bound.map_or(Ok(()), |bound| bound.validate())
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
    luts: Luts,
    /// Frames' passes in a row that called for no tables.
    idle: u32,
    /// What of the moon's shadow is in a texture, and what that was made for.
    shade: Option<(TextureId, Shade)>,
    /// What the last passes were made for.
    plan: Option<EffectPlan>,
}

impl SkyRenderer {
    /// A renderer with the given settings.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`SkySettings::validate`].
    pub fn new(settings: SkySettings) -> Result<Self> {
        settings.validate()?;
        Ok(Self {
            settings,
            passes: Vec::with_capacity(4),
            low: None,
            luts: Luts::default(),
            idle: 0,
            shade: None,
            plan: None,
        })
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

    /// What a scene calls for, with the settings in use, in a picture of a size in pixels, after what was drawn last: see
    /// [`EffectPlan::after`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`].
    pub fn plan(&self, scene: &Scene, size: [u32; 2]) -> Result<EffectPlan> {
        let view = scene.validate()?;
        Ok(EffectPlan::of(scene, &view, &self.settings, size, self.plan.as_ref()))
    }

    /// The plan of the passes that were handed out last.
    pub fn last_plan(&self) -> Option<&EffectPlan> {
        self.plan.as_ref()
    }

    /// The plan of the passes that are asked for now.
    fn next_plan(&mut self, backend: &mut dyn Backend, scene: &Scene, view: &ZenithView, size: [u32; 2]) -> EffectPlan {
        let plan = EffectPlan::of(scene, view, &self.settings, size, self.plan.as_ref());
        self.plan = Some(plan.clone());
        if !plan.eclipse {
            self.free_shade(backend);
        }
        plan
    }

    fn options(desc: &TextureDesc, plan: &EffectPlan) -> FrameOptions {
        let [view_samples, light_samples] = plan.samples;
        FrameOptions {
            size: [desc.width, desc.height],
            rows: desc.rows,
            view_samples,
            light_samples,
            sky_weight: plan.sky_weight,
            low_resolution: false,
        }
    }

    /// The background sky, to be drawn first: depth ALWAYS, no depth write. Rays that meet the planet
    /// draw nothing. Above 50 km only the sun is left of it; [`Self::aerial`] draws the rest.
    ///
    /// The colour is laid over what is in the target (stars, say), which the air dims by its grey mean. The first pass
    /// that draws to the target clears it as `target` says; opaque black is fastest, as the sky is then just written.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`], before anything is created; errors of the backend.
    pub fn background(&mut self, backend: &mut dyn Backend, scene: &Scene, target: Target) -> Result<&[Pass]> {
        let view = scene.validate()?;
        let desc = texture(backend, target.color)?;
        let plan = self.next_plan(backend, scene, &view, [desc.width, desc.height]);
        self.passes.clear();
        self.free_tables_unless(backend, plan.tables.is_some());
        let mut options = Self::options(&desc, &plan);
        let frame = FrameUniform::new(scene, &view, &options);
        let small = if plan.reduced { self.low_size(&desc) } else { options.size };
        let full = small == options.size;
        if full {
            self.free_low(backend);
        }
        if let Some(program) = plan.background {
            let label = "background sky";
            options.size = small;
            options.low_resolution = !full;
            let drawn = FrameUniform::new(scene, &view, &options);
            // Nothing but black is behind the sky: no need to clear it first, nor to blend.
            let only = full && target.clear == Some([0.0, 0.0, 0.0, 1.0]);
            let mut target = target;
            let (program, textures, uniform) = match (&plan.tables, program) {
                (wanted, Program::EclipseSky { .. }) => {
                    let (uniform, [shade, columns, moments]) =
                        self.eclipse(backend, scene, &view, drawn, wanted.as_ref())?;
                    (program, [shade, columns, moments, None, None, None], uniform)
                }
                (Some(wanted), Program::SkyLut { mie, .. }) => {
                    let passes = &mut self.passes;
                    let (t, tables) = self.luts.update(backend, &scene.atmosphere, wanted, &frame, false, passes)?;
                    let textures = t.haze.map_or(reads([t.sky]), |haze| reads([t.sky, haze]));
                    if only {
                        target.clear = None;
                    }
                    (Program::SkyLut { mie, only }, textures, Uniform::new(&FrameTables { frame: drawn, tables }))
                }
                _ => (program, reads([]), Uniform::new(&drawn)),
            };
            let program = Some(backend.create_program(program)?);
            let depth = DepthUse::Always;
            if full {
                self.passes.push(Pass { label, program, textures, uniform, target, depth });
            } else {
                let low = self.low_texture(backend, small)?;
                let clear = Target { clear: Some([0.0; 4]), ..Target::color(low) };
                self.passes.push(Pass { label, program, textures, uniform, target: clear, depth });
                self.passes.push(Pass {
                    label: "upsample sky",
                    program: Some(backend.create_program(Program::Upsample)?),
                    textures: reads([low]),
                    uniform: Uniform::new(&frame),
                    target,
                    depth,
                });
            }
        }
        for disk in [&plan.sun, &plan.moon].into_iter().flatten() {
            let drawn = self.passes.iter().any(|p| p.target.color == target.color);
            let target = if drawn { Target { clear: None, clear_depth: None, ..target } } else { target };
            self.passes.push(disk_pass(backend, &view, &frame, disk, target)?);
        }
        Ok(&self.passes)
    }

    /// Size of the background.
    fn low_size(&self, desc: &TextureDesc) -> [u32; 2] {
        let side = |s: u32| ((f64::from(s) * self.settings.render_scale).ceil() as u32).max(1);
        [side(desc.width), side(desc.height)]
    }

    /// Air between the camera and the scene: reads the scene's colour and depth and writes to another
    /// texture of the same size, `scene × transmittance + light`, per channel. With the background pass
    /// fading out from 15 to 50 km it draws the rest of the sky: the limb and the shell around the planet.
    ///
    /// # Errors
    /// As [`Self::background`]; [`crate::ErrorKind::Invalid`] if sizes or row orders differ.
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
        same_size(backend, "aerial color", color, &desc)?;
        same_size(backend, "aerial depth", depth, &desc)?;
        let wanted = matches!(self.settings.composition, Composition::Full | Composition::AtmospherePost);
        if wanted {
            self.before(backend, scene, &view, &desc, Some(color), depth, Target::color(target))?;
        }
        Ok(&self.passes)
    }

    /// As [`Self::aerial`], but laid over the target by blending: for [`Composition::Planet`], where the
    /// scene's colour cannot be read. It is dimmed by the grey mean of the transmittance. `target` must not hold
    /// `depth` as its depth buffer: it is read here.
    ///
    /// # Errors
    /// As [`Self::aerial`].
    pub fn shell(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        depth: TextureId,
        target: Target,
    ) -> Result<&[Pass]> {
        let view = scene.validate()?;
        self.passes.clear();
        let desc = texture(backend, target.color)?;
        same_size(backend, "shell depth", depth, &desc)?;
        if self.settings.composition == Composition::Planet {
            self.before(backend, scene, &view, &desc, None, depth, target)?;
        }
        Ok(&self.passes)
    }

    /// The pass for the air before a scene: reads its colour, or is laid over it.
    #[allow(clippy::too_many_arguments)]
    fn before(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        view: &ZenithView,
        desc: &TextureDesc,
        color: Option<TextureId>,
        depth: TextureId,
        target: Target,
    ) -> Result<()> {
        let plan = self.next_plan(backend, scene, view, [desc.width, desc.height]);
        self.free_tables_unless(backend, plan.tables.is_some());
        if let Some(program) = plan.before {
            let frame = FrameUniform::new(scene, view, &Self::options(desc, &plan));
            let (textures, uniform) = match &plan.tables {
                wanted if plan.eclipse => {
                    let (uniform, tables) = self.eclipse(backend, scene, view, frame, wanted.as_ref())?;
                    let scene = color.into_iter().chain([depth]);
                    let mut textures = reads([]);
                    for (slot, id) in textures.iter_mut().zip(scene.chain(tables.into_iter().flatten())) {
                        *slot = Some(id);
                    }
                    (textures, uniform)
                }
                Some(wanted) => {
                    let passes = &mut self.passes;
                    let (t, tables) = self.luts.update(backend, &scene.atmosphere, wanted, &frame, true, passes)?;
                    let textures = match (color, t.haze) {
                        (Some(color), Some(haze)) => reads([color, depth, t.sky, t.air, t.columns, haze]),
                        (Some(color), None) => reads([color, depth, t.sky, t.air, t.columns]),
                        (None, Some(haze)) => reads([depth, t.sky, t.air, t.columns, haze]),
                        (None, None) => reads([depth, t.sky, t.air, t.columns]),
                    };
                    (textures, Uniform::new(&FrameTables { frame, tables }))
                }
                _ => {
                    let textures = color.map_or(reads([depth]), |color| reads([color, depth]));
                    (textures, Uniform::new(&frame))
                }
            };
            let program = Some(backend.create_program(program)?);
            let label = if color.is_none() { "planet shell" } else { "aerial perspective" };
            self.passes.push(Pass { label, program, textures, uniform, target, depth: DepthUse::Always });
        }
        Ok(())
    }

    /// The block of a pass under the moon's shadow, and what it reads: the shade, and where the plan has tables columns and
    /// moments. The passes that fill them are appended.
    fn eclipse(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        view: &ZenithView,
        frame: FrameUniform,
        wanted: Option<&TablePlan>,
    ) -> Result<(Uniform, [Option<TextureId>; 3])> {
        let (eclipse, shade) = self.moon_shadow(backend, view, &scene.atmosphere)?;
        let mut tables = TablesUniform::default();
        let mut textures = [Some(shade), None, None];
        if let Some(wanted) = wanted {
            let (t, made) = self.luts.of_medium(backend, &scene.atmosphere, wanted, false, &mut self.passes)?;
            // Half of what a texel of the tables gets: here it is for each pixel.
            tables = TablesUniform { steps: (wanted.settings.sky_steps / 2).max(4), ..made };
            textures[1..].copy_from_slice(&[Some(t.columns()), self.luts.moments().map(|(moments, ..)| moments)]);
        }
        Ok((Uniform::new(&EclipseUniform { frame, tables, eclipse }), textures))
    }

    /// The moon's shadow as passes are told of it, and its shade.
    fn moon_shadow(
        &mut self,
        backend: &mut dyn Backend,
        view: &ZenithView,
        params: &AtmosphereParams,
    ) -> Result<(ShadowUniform, TextureId)> {
        let moon =
            view.moon.as_ref().ok_or_else(|| Error::invalid("moon", "none", "a moon whose shadow is asked for"))?;
        let shade = Shade::new(view, params, moon);
        let desc = TextureDesc::new(SHADE, TEXELS as u32, 2, Format::Rgba32Float);
        let id = match self.shade.filter(|&(id, _)| backend.texture(id) == Some(desc)) {
            Some((id, made_for)) if made_for == shade => id,
            there => {
                let id = there.map_or_else(|| backend.create_texture(&desc), |(id, _)| Ok(id))?;
                backend.write_texture(id, &shade.texels())?;
                self.shade = Some((id, shade));
                id
            }
        };
        Ok((shadow(view, params, moon, &shade), id))
    }

    /// Light of the sky for ground that is drawn before the air: the passes that fill its table, to be run first, and
    /// how a pass reads it; and the moon's shadow. `size`: of the picture, pixels.
    ///
    /// # Errors
    /// As [`Self::background`].
    pub fn ground_light(
        &mut self,
        backend: &mut dyn Backend,
        scene: &Scene,
        size: [u32; 2],
    ) -> Result<(&[Pass], GroundLight)> {
        let view = scene.validate()?;
        let plan = self.next_plan(backend, scene, &view, size);
        self.passes.clear();
        let mut light = GroundLight::default();
        if let Some(wanted) = plan.tables.filter(|t| t.rounds > 0) {
            light.tables = self.luts.of_medium(backend, &scene.atmosphere, &wanted, false, &mut self.passes)?.1;
            light.moments = self.luts.moments().map(|(moments, ..)| moments);
        }
        if plan.eclipse {
            light.shadow = Some(self.moon_shadow(backend, &view, &scene.atmosphere)?);
        }
        Ok((&self.passes, light))
    }

    /// Asks for the light of the sky that was drawn last, for a scene's own shading: see [`SkyLight`]. The passes that
    /// fill its tables must have been run. `None` where the method or the plan has no table of it.
    ///
    /// [`SkyLight`]: crate::render::sky_light::SkyLight
    ///
    /// # Errors
    /// Those of the backend.
    pub fn begin_sky_light(&self, backend: &mut dyn Backend, scene: &Scene) -> Result<Option<SkyLightRead>> {
        let Some((table, made_for, nodes)) = self.luts.moments() else { return Ok(None) };
        let read = backend.begin_read(table)?;
        Ok(Some(SkyLightRead { read, params: scene.atmosphere.clone(), made_for, nodes }))
    }

    /// Frees what this renderer made on a backend.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.free_low(backend);
        self.free_shade(backend);
        self.luts.destroy(backend);
    }

    /// Tables that no scene has called for in a while are freed; not at once, for the camera may turn back.
    fn free_tables_unless(&mut self, backend: &mut dyn Backend, needed: bool) {
        self.idle = if needed { 0 } else { self.idle.saturating_add(1) };
        if self.idle == IDLE {
            self.luts.destroy(backend);
        }
    }

    fn free_shade(&mut self, backend: &mut dyn Backend) {
        if let Some((shade, _)) = self.shade.take()
            && backend.texture(shade).is_some_and(|d| d.label == SHADE)
        {
            backend.destroy_texture(shade);
        }
    }

    fn free_low(&mut self, backend: &mut dyn Backend) {
        if let Some(low) = self.low.take()
            && backend.texture(low).is_some_and(|d| d.label == LOW)
        {
            backend.destroy_texture(low);
        }
    }

    fn low_texture(&mut self, backend: &mut dyn Backend, [width, height]: [u32; 2]) -> Result<TextureId> {
        let desc = TextureDesc::new(LOW, width, height, Format::Rgba16Float);
        if let Some(low) = self.low.filter(|&low| backend.texture(low) == Some(desc)) {
            return Ok(low);
        }
        self.free_low(backend);
        let low = backend.create_texture(&desc)?;
        self.low = Some(low);
        Ok(low)
    }
}

/// What a pass needs for the light on the ground; see [`SkyRenderer::ground_light`].
#[derive(Clone, Copy, Debug, Default)]
pub struct GroundLight {
    /// The sky's light, where the method or the plan has a table of it.
    pub(crate) moments: Option<TextureId>,
    pub(crate) tables: TablesUniform,
    /// The moon's shadow with its shade, where one falls on what is seen.
    pub(crate) shadow: Option<(ShadowUniform, TextureId)>,
}

/// Label of the shade.
const SHADE: &str = "moon's shade";

/// Label of the sky in low resolution.
const LOW: &str = "low-resolution sky";

/// Checks that a texture covers the same pixels as the target.
fn same_size(backend: &dyn Backend, name: &str, id: TextureId, target: &TextureDesc) -> Result<()> {
    let other = texture(backend, id)?;
    if (other.width, other.height, other.rows) == (target.width, target.height, target.rows) {
        return Ok(());
    }
    Err(Error::invalid(
        name,
        format_args!("{} × {}, {:?}", other.width, other.height, other.rows),
        format_args!("as the target: {} × {}, {:?}", target.width, target.height, target.rows),
    ))
}

pub(crate) fn texture(backend: &dyn Backend, id: TextureId) -> Result<TextureDesc> {
    backend.texture(id).ok_or_else(|| crate::gpu::unknown(backend.info().backend, "texture"))
}
