//! One frame: checked and computed once, by one call; everything after reads it.
//!
//! [`Frame::new`] checks scene, settings and size, turns the scene into the camera's zenith frame, decides
//! which effects the picture calls for, and computes the uniform block. What draws it is a list of
//! [`graph::Node`]s, one or more for each effect that is on. That list is the plan: what is printed, made
//! ahead, timed and drawn.
//!
//! ```
//! use welkin::{Frame, SkySettings};
//! # use glam::DVec3;
//! # use welkin::{AtmosphereParams, Camera, DepthConvention, Scene};
//! # let earth = AtmosphereParams::earth();
//! # let scene = Scene {
//! #     camera: Camera::new(DVec3::Z * (earth.planet_radius + 4e5), DVec3::Z, DVec3::X, 1.0, 1.5),
//! #     planet_center: DVec3::ZERO,
//! #     atmosphere: earth,
//! #     sun_direction: DVec3::X,
//! #     depth: DepthConvention::default(),
//! #     moon: None,
//! #     ellipsoid: None,
//! # };
//! // From orbit, looking away from the planet.
//! let frame = Frame::new(&scene, &SkySettings::default(), [960, 640])?;
//! assert!(frame.planned_passes().is_empty());
//! for effect in frame.effects() {
//!     println!("{} is {}: {}", effect.name, if effect.on { "on" } else { "off" }, effect.reason);
//! }
//! # Ok::<(), welkin::Error>(())
//! ```
//!
//! # How much may change
//!
//! Some omissions change nothing: what lies outside the picture or behind the planet. The others (a
//! constituent next to nothing of which is in sight, light at night) change pixels by less than a
//! [`crate::Bound`]: each has an upper bound of its own, worked out in `omit`, and the cheapest are taken as
//! long as their sum stays within it.

mod aerial;
pub mod airglow;
mod background;
pub mod disks;
pub mod eclipse;
mod effect;
pub mod graph;
pub mod luts;
mod medium;
mod omit;
pub mod scene_air;
pub mod terrain;
pub mod tone_map;
pub mod uniforms;
mod visibility;

use crate::count;
use crate::error::{Error, Result};
use crate::gpu::{Program, RowOrder};
use crate::model::scene::{Scene, ZenithView};
use crate::settings::{Composition, Quality, SkySettings};

pub use background::{HAND_OVER, background_weight, hand_over};
pub use effect::{EffectReport, Reason};
pub use medium::Air;

use disks::SkyDisk;
use effect::{EFFECT_COUNT, EFFECTS, Effect};
use graph::{Graph, Node, Runs};
use luts::LutsUniform;
use medium::Omission;
use uniforms::FrameUniform;
use visibility::Visibility;

/// A frame: a scene, settings and a size, checked and computed. See the [module](self).
#[derive(Clone, Debug)]
pub struct Frame {
    pub(crate) scene: Scene,
    pub(crate) view: ZenithView,
    pub(crate) settings: SkySettings,
    pub(crate) size: [u32; 2],
    pub(crate) visibility: Visibility,
    /// The disks of sun and moon, where they are in the picture.
    pub(crate) sun: SkyDisk,
    pub(crate) moon: SkyDisk,
    /// Why there is no air in the picture, if there is none.
    pub(crate) no_air: Option<&'static str>,
    pub(crate) omission: Omission,
    /// Fraction of the sky's light that the background pass draws; the aerial pass draws the rest.
    pub(crate) background_weight: f64,
    /// Whether the user says how much of the sunlight along each ray is not hidden.
    pub(crate) lit_fraction: bool,
    /// Whether the background's target holds something when the frame begins.
    pub(crate) behind: bool,
    /// The block of every pass of the atmosphere, for the whole picture.
    pub(crate) uniform: FrameUniform,
    /// What of it the LUTs of the view are made of: the previous frame's, where the difference cannot be
    /// seen.
    pub(crate) view_luts: FrameUniform,
    /// The LUTs' part of the blocks that have one; zeros where the light is marched.
    pub(crate) luts_block: LutsUniform,
    effects: [EffectReport; EFFECT_COUNT],
}

/// A pass as the plan lists it; it may run several times in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedPass {
    /// What it makes: the label of the passes that are drawn.
    pub label: &'static str,
    /// Its program with its constants; `None` only clears or uploads.
    pub program: Option<Program>,
    /// How often its content changes.
    pub runs: Runs,
    /// How many times in a row it runs.
    pub times: u32,
    /// Fraction of its target's pixels that it draws, 0 to 1.
    pub fraction: f64,
}

impl Frame {
    /// The frame of a scene in a picture of a size in pixels, rows from the top.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`] and [`SkySettings::validate`], and for a side
    /// of 0.
    pub fn new(scene: &Scene, settings: &SkySettings, size: [u32; 2]) -> Result<Self> {
        settings.validate()?;
        Self::checked(scene, settings, size, RowOrder::TopDown, None)
    }

    /// The frame that follows another: what is on stays on until leaving it out uses up less than half of the
    /// bound, so that a scene on a threshold does not switch in every frame. Either way it is within the
    /// bound.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] as for [`Self::new`].
    pub fn after(previous: &Self, scene: &Scene, settings: &SkySettings, size: [u32; 2]) -> Result<Self> {
        settings.validate()?;
        Self::checked(scene, settings, size, RowOrder::TopDown, Some(previous))
    }

    /// The one place where a frame is checked and computed. The settings are checked already.
    pub(crate) fn checked(
        scene: &Scene,
        settings: &SkySettings,
        size: [u32; 2],
        rows: RowOrder,
        previous: Option<&Self>,
    ) -> Result<Self> {
        count::one(|c| &mut c.frames);
        let view = scene.validate()?;
        for (name, side) in ["width", "height"].into_iter().zip(size) {
            if side == 0 {
                return Err(Error::invalid(format_args!("picture.{name}"), side, "1 pixel or more"));
            }
        }
        let background_weight = match settings.look.composition {
            Composition::Full => background_weight(view.height, scene.atmosphere.thickness()),
            Composition::SkyDome => 1.0,
            Composition::AtmospherePost | Composition::Planet => 0.0,
        };
        let samples = match settings.quality {
            Quality::March { view_samples, light_samples } => [view_samples, light_samples],
            Quality::Luts(_) => [0; 2],
        };
        let uniform = FrameUniform::new(scene, &view, size, rows, samples, background_weight);
        let view_luts = uniform.of_view_luts(previous.map(|p| &p.view_luts));
        let off = EffectReport { name: "", on: false, reason: Reason::of("no air to see") };
        let mut frame = Self {
            visibility: Visibility::new(&scene.atmosphere, &view),
            uniform,
            view_luts,
            luts_block: match &settings.quality {
                Quality::Luts(luts) => LutsUniform::new(&scene.atmosphere, luts),
                Quality::March { .. } => LutsUniform::default(),
            },
            scene: scene.clone(),
            view,
            settings: *settings,
            size,
            sun: SkyDisk::default(),
            moon: SkyDisk::default(),
            no_air: None,
            omission: Omission::default(),
            background_weight,
            lit_fraction: false,
            behind: false,
            effects: EFFECTS.map(|effect| EffectReport { name: effect.name(), ..off }),
        };
        frame.sun = SkyDisk::sun(&frame);
        frame.moon = SkyDisk::moon(&frame);
        frame.no_air = if !settings.look.enabled {
            Some("switched off")
        } else if !Air::of(&scene.atmosphere).any() {
            Some("no constituent has a coefficient above 0")
        } else if settings.bound.is_some() && !frame.visibility.air && !settings.look.scene_shaders {
            Some("outside the picture")
        } else {
            None
        };
        if frame.no_air.is_none() {
            let was_on = |effect: &dyn Effect| previous.is_some_and(|p| p.is_on(effect));
            frame.omission = Omission::new(&frame, frame.sun.is_seen(), was_on);
        }
        // Each decision reads those before it.
        for (i, effect) in EFFECTS.iter().enumerate() {
            let (on, reason) = effect.decide(&frame);
            (frame.effects[i].on, frame.effects[i].reason) = (on, reason);
        }
        Ok(frame)
    }

    /// Every effect with its reason.
    pub fn effects(&self) -> &[EffectReport] {
        &self.effects
    }

    /// The names of all effects, in the order of [`Self::effects`].
    pub fn effect_names() -> [&'static str; EFFECT_COUNT] {
        EFFECTS.map(|effect| effect.name())
    }

    /// An effect by its name.
    pub fn effect(&self, name: &str) -> Option<&EffectReport> {
        self.effects.iter().find(|e| e.name == name)
    }

    /// The scene that it was computed from.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The settings that it was computed with.
    pub fn settings(&self) -> &SkySettings {
        &self.settings
    }

    /// Size of the picture, pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The passes in order as a first frame runs them, those that fill LUTs included.
    pub fn planned_passes(&self) -> Vec<PlannedPass> {
        let mut graph = Graph::default();
        graph.list(self, |_| true, None);
        planned(&graph.nodes)
    }

    pub(crate) fn is_on(&self, effect: &dyn Effect) -> bool {
        self.effect(effect.name()).is_some_and(|e| e.on)
    }

    /// Whether there is air in the picture that counts.
    pub(crate) fn has_air(&self) -> bool {
        self.no_air.is_none() && self.omission.air.any()
    }

    /// Whether the frame's air gets sunlight, or a sun in the picture is seen through it.
    pub(crate) fn is_lit(&self) -> bool {
        self.is_on(&medium::Sunlight) || self.sun.is_seen()
    }

    /// Whether the frame's air scatters light into the rays of the picture.
    pub(crate) fn sends_light(&self) -> bool {
        self.is_lit() && (self.omission.air.rayleigh || self.omission.air.mie)
    }

    pub(crate) fn push_nodes(&self, nodes: &mut Vec<Node>) {
        if self.settings.look.enabled {
            EFFECTS
                .iter()
                .filter(|effect| self.is_on(**effect))
                .for_each(|effect| effect.push_nodes(self, nodes));
        }
    }
}

/// Nodes as the plan lists them: what runs several times in a row is one line.
pub(crate) fn planned(nodes: &[Node]) -> Vec<PlannedPass> {
    let mut passes: Vec<PlannedPass> = Vec::new();
    for node in nodes.iter().filter(|n| !matches!(n.work, graph::Work::Upload(_))) {
        let Node { label, runs, fraction, .. } = *node;
        let pass = PlannedPass { label, program: node.work.program(), runs, times: 1, fraction };
        // Two programs in turn, as the rounds of scattering have them, count as two lines.
        let recent = passes.iter_mut().rev().take(2);
        match recent.into_iter().find(|p| (p.label, p.program) == (label, pass.program)) {
            Some(known) => known.times += 1,
            None => passes.push(pass),
        }
    }
    passes
}
