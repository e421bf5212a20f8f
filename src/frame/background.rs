//! The sky behind the scene.

use super::Frame;
use super::aerial::phase_constant;
use super::airglow::AirglowBehind;
use super::eclipse::{Eclipse, MOON_SHADOW};
use super::effect::{Decision, Effect, Reason};
use super::graph::{Extent, Node, Resource, Stage, Texel, reads};
use super::luts::{MIE_SINGLE, SKY_VIEW, TRANSMITTANCE};
use super::medium::{Air, NO_AIR};
use crate::gpu::{Program, Uniform};
use crate::settings::Composition;
use crate::shaders::{behind_air, sky_march, sky_march_eclipse, sky_view, upsample};

/// Altitudes over which the background pass hands the sky over to the aerial pass, metres, where the air is
/// 100 km deep or more; see [`hand_over`].
pub const HAND_OVER: (f64, f64) = (15_000.0, 50_000.0);

/// Depth of the air from which on [`HAND_OVER`] holds, metres: the Earth's.
const DEEP: f64 = 100_000.0;

/// Altitudes over which the background pass hands the sky over to the aerial pass, metres, for air so deep
/// (metres): [`HAND_OVER`], and in proportion less in air that is less than 100 km deep, as small planets
/// have it.
pub fn hand_over(thickness: f64) -> (f64, f64) {
    let part = (thickness / DEEP).min(1.0);
    (HAND_OVER.0 * part, HAND_OVER.1 * part)
}

/// Fraction of the sky's light that the background pass draws at a camera altitude above a planet with air so
/// deep (metres): 1 below the [`hand_over`], 0 above it, `1 - smoothstep` between. The aerial pass draws the
/// rest, so their sum does not change.
pub fn background_weight(altitude: f64, thickness: f64) -> f64 {
    let (from, to) = hand_over(thickness);
    let t = ((altitude - from) / (to - from)).clamp(0.0, 1.0);
    1.0 - t * t * (3.0 - 2.0 * t)
}

/// Whether the background pass draws sky with so much of its light: it then dims what lies behind the air,
/// and the aerial pass does not, however little it is.
pub(crate) fn draws_any(background_weight: f64) -> bool {
    background_weight > 0.0
}

/// Whether the background pass draws air.
pub(crate) fn is_drawn(frame: &Frame) -> bool {
    sees_sky(frame) && draws_any(frame.background_weight)
}

/// Whether something lies behind the sky that the background pass draws.
pub(crate) fn has_behind(frame: &Frame) -> bool {
    frame.behind || frame.is_on(&AirglowBehind)
}

/// Whether there is a ray in the picture that goes through air and misses the ground.
pub(crate) fn sees_sky(frame: &Frame) -> bool {
    frame.has_air() && (frame.settings.bound.is_none() || frame.visibility.sky)
}

/// The sky behind the scene: a full-screen pass, depth ALWAYS, no depth write.
pub(crate) struct BackgroundSky;

impl Effect for BackgroundSky {
    fn name(&self) -> &'static str {
        "background sky"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let altitude = frame.view.altitude / 1e3;
        let full = frame.settings.look.composition == Composition::Full;
        let drawn = is_drawn(frame);
        let reason = if !sees_sky(frame) {
            Reason::of("the planet fills the picture")
        } else if drawn && full {
            Reason::number("below the hand-over's end the sky is drawn first; camera at", altitude, " km")
        } else if drawn {
            Reason::of("the composition draws all of the sky first")
        } else if full {
            Reason::number(
                "above the hand-over the depth-aware pass draws the sky; camera at",
                altitude,
                " km",
            )
        } else {
            Reason::of("the composition draws the sky over the scene")
        };
        (drawn, reason)
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let reduced = frame.is_on(&ReducedResolution);
        let label = "background sky";
        if frame.behind {
            let program = Air::ALL.program(&behind_air::INFO, []).multiplied();
            let uniform = Uniform::new(&frame.uniform);
            let node = Node::draw("behind the air", Stage::Background, program, Resource::Background);
            nodes.push(Node { uniform, ..node });
        }
        if !reduced {
            let node = Node::draw(label, Stage::Background, NOTHING, Resource::Background);
            nodes.push(sky(frame, node, false));
            return;
        }
        let size = reduced_size(frame);
        let extent = Some(Extent { size, texel: Texel::Radiance });
        let small =
            Node { extent, clear: Some([0.0; 4]), ..Node::draw(label, Stage::Background, NOTHING, REDUCED) };
        nodes.push(sky(frame, small, true));
        let program = Program::new(&upsample::INFO, 0).blended();
        nodes.push(Node {
            reads: reads([("reduced_sky", Some(REDUCED))]),
            uniform: Uniform::new(&frame.uniform),
            ..Node::draw("upsample sky", Stage::Background, program, Resource::Background)
        });
    }
}

/// Stands for a program until [`sky`] has chosen one.
const NOTHING: Program = Program::new(&upsample::INFO, 0);

/// The sky in low resolution.
const REDUCED: Resource = Resource::pool("reduced_sky", 0);

fn reduced_size(frame: &Frame) -> [u32; 2] {
    frame.size.map(|side| ((f64::from(side) * frame.settings.render_scale).ceil() as u32).max(1))
}

/// Fills in program, block and reads of the pass that draws the sky.
fn sky(frame: &Frame, node: Node, reduced: bool) -> Node {
    let block = if reduced { frame.uniform.reduced(&frame.view, reduced_size(frame)) } else { frame.uniform };
    let air = frame.omission.air;
    let phase = phase_constant(frame);
    let dims = ("DIMS", !has_behind(frame));
    let mut over_black = None;
    let (program, uniform, reads) = if frame.is_on(&Eclipse) {
        let light = frame.multi_scattering();
        let constants = [phase, dims, ("SUNLIGHT", true), ("MULTI_SCATTERING", light.is_some())];
        let program = Air::ALL.program(&sky_march_eclipse::INFO, constants);
        let list = reads([
            ("moon_shadow_lut", Some(MOON_SHADOW)),
            ("transmittance_lut", light.map(|_| TRANSMITTANCE)),
            ("multi_scattering_lut", light),
        ]);
        (program, frame.with_eclipse(block), list)
    } else if frame.luts().is_some() {
        let single = frame.has_mie_single();
        let program =
            Air::ALL.program(&sky_view::INFO, [phase, dims, ("MIE_SINGLE", single), ("BLEND", true)]);
        let list =
            reads([("sky_view_lut", Some(SKY_VIEW)), ("mie_single_lut", single.then_some(MIE_SINGLE))]);
        if !reduced && !has_behind(frame) {
            over_black = Some(Air::ALL.program(&sky_view::INFO, [phase, ("MIE_SINGLE", single)]));
        }
        (program, frame.with_luts(block), list)
    } else {
        let program = air.program(&sky_march::INFO, [phase, dims, ("SUNLIGHT", frame.sends_light())]);
        (program, Uniform::new(&block), reads([]))
    };
    Node { work: super::graph::Work::Draw(program.blended()), uniform, reads, over_black, ..node }
}

/// The sky drawn smaller and brought to full size.
pub(crate) struct ReducedResolution;

impl Effect for ReducedResolution {
    fn name(&self) -> &'static str {
        "reduced resolution"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let scale = frame.settings.render_scale;
        if !is_drawn(frame) {
            (false, Reason::of("no sky to draw smaller"))
        } else if scale < 1.0 {
            (true, Reason::number("render scale", scale, ""))
        } else {
            (false, Reason::number("the background is drawn in full size: render scale", scale, ""))
        }
    }
}
