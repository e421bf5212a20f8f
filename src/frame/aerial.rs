//! The air before the scene, and from high up the shell around the planet.

use super::Frame;
use super::background::sees_sky;
use super::eclipse::{Eclipse, MOON_SHADOW};
use super::effect::{Decision, Effect, Reason};
use super::graph::{Node, Resource, Stage, Work, reads};
use super::luts::{MIE_SINGLE, SKY_VIEW, TRANSMITTANCE};
use super::medium::{Air, NO_AIR};
use crate::gpu::Uniform;
use crate::model::atmosphere::MiePhase;
use crate::settings::Composition;
use crate::shaders::{aerial_march, aerial_march_eclipse, aerial_perspective};

/// Which phase function the aerosol has, as a constant of the programs; off where no aerosol sends light.
pub(crate) fn phase_constant(frame: &Frame) -> (&'static str, bool) {
    let sends_light = frame.omission.air.mie && frame.is_lit();
    ("CORNETTE_SHANKS", sends_light && frame.scene.atmosphere.mie_phase == MiePhase::CornetteShanks)
}

/// Whether the aerial pass draws a part of the sky.
fn draws_sky(frame: &Frame) -> bool {
    frame.settings.look.composition.draws_over_scene() && sees_sky(frame) && frame.background_weight < 1.0
}

/// Whether something may stand before the sky that the air dims.
fn has_foreground(frame: &Frame) -> bool {
    let seen = frame.visibility.air && (frame.settings.look.foreground || frame.visibility.ground);
    seen || frame.settings.bound.is_none()
}

/// Whether the aerial pass is drawn at all.
pub(crate) fn is_drawn(frame: &Frame) -> bool {
    let over = frame.settings.look.composition.draws_over_scene();
    draws_sky(frame) || (over && frame.has_air() && has_foreground(frame))
}

/// The part of the sky that the aerial pass draws.
pub(crate) struct PlanetShell;

impl Effect for PlanetShell {
    fn name(&self) -> &'static str {
        "planet shell"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let weight = 1.0 - frame.background_weight;
        let reason = if !frame.settings.look.composition.draws_over_scene() {
            Reason::of("the composition draws the sky alone")
        } else if !sees_sky(frame) {
            Reason::of("the planet fills the picture")
        } else if weight > 0.0 {
            Reason::number("its share of the sky is", weight, "")
        } else {
            let altitude = frame.view.altitude / 1e3;
            Reason::number("below the hand-over the background is all of the sky; camera at", altitude, " km")
        };
        (draws_sky(frame), reason)
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        // One pass draws both.
        if !frame.is_on(&AerialPerspective) {
            nodes.push(aerial(frame));
        }
    }
}

/// The air between the camera and the scene: it dims the scene and adds the light that is scattered into each
/// ray.
pub(crate) struct AerialPerspective;

impl Effect for AerialPerspective {
    fn name(&self) -> &'static str {
        "aerial perspective"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let over = frame.settings.look.composition.draws_over_scene();
        let foreground = has_foreground(frame);
        let reason = if !over {
            Reason::of("the composition draws the sky alone")
        } else if !foreground {
            Reason::of("nothing lies before the sky")
        } else if frame.settings.look.foreground {
            Reason::of("a scene with depth")
        } else {
            Reason::of("the ground is in the picture")
        };
        (over && foreground, reason)
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        nodes.push(aerial(frame));
    }
}

/// The pass for the air before a scene: it reads the scene's colour, or is laid over it.
fn aerial(frame: &Frame) -> Node {
    let blend = frame.settings.look.composition == Composition::Planet;
    let air = frame.omission.air;
    let phase = phase_constant(frame);
    let scene_color = ("scene_color", (!blend).then_some(Resource::SceneColor));
    let scene_depth = ("scene_depth", Some(Resource::SceneDepth));
    let lit_fraction = ("lit_fraction", frame.lit_fraction.then_some(Resource::LitFraction));
    let (blended, hidden) = (("BLEND", blend), ("LIT_FRACTION", frame.lit_fraction));
    let (program, uniform, reads) = if frame.is_on(&Eclipse) {
        let light = frame.multi_scattering();
        let constants = [phase, blended, hidden, ("SUNLIGHT", true), ("MULTI_SCATTERING", light.is_some())];
        let list = reads([
            scene_color,
            scene_depth,
            lit_fraction,
            ("moon_shadow_lut", Some(MOON_SHADOW)),
            ("transmittance_lut", light.map(|_| TRANSMITTANCE)),
            ("multi_scattering_lut", light),
        ]);
        (Air::ALL.program(&aerial_march_eclipse::INFO, constants), frame.with_eclipse(frame.uniform), list)
    } else if frame.luts().is_some() {
        let single = frame.has_mie_single();
        let list = reads([
            scene_color,
            scene_depth,
            lit_fraction,
            ("sky_view_lut", Some(SKY_VIEW)),
            ("aerial_lut", frame.aerial_lut()),
            ("mie_single_lut", single.then_some(MIE_SINGLE)),
        ]);
        let program =
            Air::ALL.program(&aerial_perspective::INFO, [phase, blended, hidden, ("MIE_SINGLE", single)]);
        (program, frame.with_luts(frame.uniform), list)
    } else {
        let program =
            air.program(&aerial_march::INFO, [phase, blended, hidden, ("SUNLIGHT", frame.sends_light())]);
        (program, Uniform::new(&frame.uniform), reads([scene_color, scene_depth, lit_fraction]))
    };
    let label = if blend { "planet shell" } else { "aerial perspective" };
    let program = if blend { program.blended() } else { program };
    let node = Node::draw(label, Stage::Aerial, program, Resource::Aerial);
    Node { work: Work::Draw(program), uniform, reads, ..node }
}
