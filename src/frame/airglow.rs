//! Airglow: the night sky's own light. Where a ray leaves the layer behind it, the layer is drawn like the
//! stars, before the sky, and dimmed by the passes that draw the air. Where a ray from above enters it first,
//! it is laid over everything else: there is no air to speak of before it.

use super::effect::{Decision, Effect, Reason};
use super::graph::{Node, Resource, Stage, reads};
use super::medium::Air;
use super::uniforms::{FrameUniform, block};
use super::{Frame, aerial, background};
use crate::gpu::Uniform;
use crate::model::airglow::Airglow;
use crate::shaders::airglow;

block! {
    /// `struct Uniforms` in `airglow.wgsl`.
    #[allow(missing_docs)]
    AirglowUniform {
        frame: FrameUniform,
        zenith: [f32; 3],
        bottom: f32,
        middle: f32,
        top: f32,
        pad1: f32,
        pad2: f32,
    }
}

/// The part of the layer behind the air.
pub(crate) struct AirglowBehind;

/// The part of the layer before everything, for cameras above it.
pub(crate) struct AirglowBefore;

/// The layer, if it is to be drawn: that, or why not.
fn layer(frame: &Frame) -> Result<Airglow, Reason> {
    let Some(glow) = frame.settings.look.airglow else { return Err(Reason::of("switched off")) };
    if !frame.settings.look.enabled {
        return Err(Reason::of("switched off"));
    }
    // The longest way through the layer is along its bottom.
    let (r, w) = (frame.scene.atmosphere.planet_radius + glow.altitude, glow.half_width);
    let longest = 2.0 * (2.0 * w * (2.0 * r)).sqrt() / w;
    let brightest =
        glow.zenith.into_iter().fold(0.0, f64::max) * frame.scene.atmosphere.sun_intensity * longest;
    match frame.settings.bound {
        _ if brightest <= 0.0 => Err(Reason::of("it has no light")),
        Some(bound) if brightest <= bound.absolute => {
            Err(Reason::number("changes no pixel by more than the bound: radiance at most", brightest, ""))
        }
        _ => Ok(glow),
    }
}

impl Effect for AirglowBehind {
    fn name(&self) -> &'static str {
        "airglow"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        match layer(frame) {
            Err(reason) => (false, reason),
            Ok(glow) => (true, Reason::number("a layer that shines at", glow.altitude / 1e3, " km")),
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        nodes.push(node(frame, Stage::Background, Resource::Background, false));
    }
}

impl Effect for AirglowBefore {
    fn name(&self) -> &'static str {
        "airglow before the planet"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let over = frame.settings.look.composition.draws_over_scene();
        match layer(frame) {
            Err(reason) => (false, reason),
            Ok(_) if !over => (false, Reason::of("the composition draws the sky alone")),
            Ok(_) if !aerial::is_drawn(frame) => (false, Reason::of("no pass draws air before the scene")),
            Ok(glow) => {
                let bottom = glow.altitude - glow.half_width;
                let altitude = frame.view.altitude;
                let above = altitude > bottom;
                let text = if above {
                    "the camera is above the layer, at"
                } else {
                    "the camera is below the layer, at"
                };
                (above, Reason::number(text, altitude / 1e3, " km"))
            }
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        nodes.push(node(frame, Stage::Aerial, Resource::Aerial, true));
    }
}

fn node(frame: &Frame, stage: Stage, writes: Resource, before: bool) -> Node {
    let glow = frame.settings.look.airglow.unwrap_or(Airglow::EARTH);
    let intensity = frame.scene.atmosphere.sun_intensity;
    // Above the lowest ground, as all heights in shaders.
    let km = |altitude: f64| ((altitude - frame.scene.atmosphere.lowest_ground) / 1e3) as f32;
    let block = AirglowUniform {
        frame: frame.uniform,
        zenith: glow.zenith.map(|v| (v * intensity) as f32),
        bottom: km(glow.altitude - glow.half_width),
        middle: km(glow.altitude),
        top: km(glow.altitude + glow.half_width),
        ..AirglowUniform::default()
    };
    // What else is behind the sky is dimmed by a pass of its own, this too then.
    let through_air = !before && background::is_drawn(frame) && !frame.behind;
    let program = Air::ALL.program(&airglow::INFO, [("BEFORE", before), ("THROUGH_AIR", through_air)]);
    let depth = before.then_some(Resource::SceneDepth);
    Node {
        uniform: Uniform::new(&block),
        reads: reads([("scene_depth", depth)]),
        ..Node::draw("airglow", stage, program.blended(), writes)
    }
}
