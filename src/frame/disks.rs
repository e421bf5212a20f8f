//! The disks of sun and moon: a rectangle around each, laid over the sky.

use super::effect::{Decision, Effect, Reason};
use super::graph::{Node, Resource, Stage};
use super::medium::Air;
use super::uniforms::{FrameUniform, block};
use super::visibility::{MARGIN, disk_rectangle};
use super::{Frame, background};
use crate::gpu::{Program, Uniform};
use crate::model::moon::{Disks, MOON_ALBEDO, Phase};
use crate::shaders::{moon_disk, sun_disk};

block! {
    /// `struct Uniforms` in `lib/celestial_disk.wgsl`.
    #[allow(missing_docs)]
    DiskUniform {
        frame: FrameUniform,
        rectangle: [f32; 4],
        moon_direction: [f32; 3],
        moon_sine: f32,
        moon_chord: f32,
        albedo_over_pi: f32,
        earthshine: f32,
        sun_visibility: f32,
    }
}

/// A disk in the sky, as a frame sees it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SkyDisk {
    /// Where in the picture it is drawn (left, bottom, right, top, -1 to 1); `None` where it is not.
    pub rectangle: Option<[f64; 4]>,
    /// Why it is drawn or not.
    why: &'static str,
}

impl SkyDisk {
    /// The sun's disk.
    pub fn sun(frame: &Frame) -> Self {
        let radius = frame.scene.atmosphere.sun_angular_radius;
        let seen = Self::new(frame, frame.view.sun, radius, frame.settings.look.sun_disk);
        let behind_moon = both(frame).is_some_and(|d| d.phase() == Phase::Total);
        if seen.is_seen() && behind_moon && frame.settings.bound.is_some() {
            return Self { rectangle: None, why: "behind the moon" };
        }
        seen
    }

    /// The moon's disk.
    pub fn moon(frame: &Frame) -> Self {
        let Some(moon) = frame.view.moon else { return Self { rectangle: None, why: "the scene has none" } };
        let distance = moon.position.length();
        Self::new(frame, moon.position / distance, (moon.radius / distance).min(1.0).asin(), true)
    }

    /// A disk lit by the sun. towards: unit; radius: radians.
    fn new(frame: &Frame, towards: glam::DVec3, radius: f64, switched_on: bool) -> Self {
        let hidden = |why| Self { rectangle: None, why };
        let basis = &frame.view.basis;
        // With the soft edge of half a pixel.
        let radius = radius + basis.up.length() / f64::from(frame.size[1].max(1));
        if !frame.settings.look.enabled || !switched_on {
            return hidden("switched off");
        }
        if frame.scene.atmosphere.sun_intensity <= 0.0 {
            return hidden("the sun is dark");
        }
        let Some(rectangle) = disk_rectangle(basis, towards, radius, frame.size) else {
            return hidden("outside the picture");
        };
        let seen = |why| Self { rectangle: Some(rectangle), why };
        match frame.settings.bound {
            None => seen("nothing is to be left out"),
            Some(_) if frame.visibility.hides(towards, radius) => hidden("behind the planet"),
            Some(_) => seen("in the picture"),
        }
    }

    /// Whether it is in the picture.
    pub fn is_seen(&self) -> bool {
        self.rectangle.is_some()
    }

    fn decision(&self) -> Decision {
        (self.is_seen(), Reason::of(self.why))
    }
}

/// The disks of sun and moon as the camera sees them; `None` without a moon.
fn both(frame: &Frame) -> Option<Disks> {
    frame.view.moon?.disks(glam::DVec3::ZERO, frame.view.sun, frame.scene.atmosphere.sun_angular_radius)
}

/// The sun's disk.
pub(crate) struct SunDisk;

impl Effect for SunDisk {
    fn name(&self) -> &'static str {
        "sun disk"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        frame.sun.decision()
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let hidden = both(frame).is_some_and(|d| d.apart < d.sun + d.moon + MARGIN);
        let limb = frame.settings.look.limb_darkening;
        let air = dimming(frame);
        let constants = [("AIR", air.any()), ("LIMB_DARKENING", limb), ("MOON", hidden)];
        push_disk(frame, "sun", air.program(&sun_disk::INFO, constants), &frame.sun, nodes);
    }
}

/// The moon's disk.
pub(crate) struct MoonDisk;

impl Effect for MoonDisk {
    fn name(&self) -> &'static str {
        "moon disk"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        frame.moon.decision()
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let air = dimming(frame);
        push_disk(frame, "moon", air.program(&moon_disk::INFO, [("AIR", air.any())]), &frame.moon, nodes);
        if !frame.behind {
            return;
        }
        // Before anything else that is drawn there, or it would hide the light of the air before it.
        let first = nodes.iter().position(|node| node.writes == Resource::Background);
        push_disk(
            frame,
            "moon's body",
            Air::default().program(&moon_disk::INFO, [("BODY", true)]),
            &frame.moon,
            nodes,
        );
        if let (Some(first), Some(body)) = (first, nodes.pop()) {
            nodes.insert(first, body);
        }
    }
}

/// The air that dims a disk here: none where the aerial pass dims what lies behind the air.
fn dimming(frame: &Frame) -> Air {
    if background::is_drawn(frame) { frame.omission.air } else { Air::default() }
}

/// The node that draws a disk.
#[inline(never)]
fn push_disk(frame: &Frame, label: &'static str, program: Program, disk: &SkyDisk, nodes: &mut Vec<Node>) {
    let Some([left, bottom, right, top]) = disk.rectangle else { return };
    let fraction = 0.25 * (right - left) * (top - bottom);
    let view = &frame.view;
    // The frame's up points to the target's first row.
    let flipped = glam::Vec3::from(frame.uniform.ray_up).as_dvec3().dot(view.basis.up) < 0.0;
    let rect = if flipped { [left, -top, right, -bottom] } else { [left, bottom, right, top] };
    let mut block =
        DiskUniform { frame: frame.uniform, rectangle: rect.map(|v| v as f32), ..DiskUniform::default() };
    if let Some(m) = &view.moon {
        let sine = m.radius / m.position.length();
        // 2 sin(a / 2) of sin a, without a difference of cosines.
        let chord = (2.0 * sine * sine / (1.0 + (1.0 - sine * sine).max(0.0).sqrt())).sqrt();
        block = DiskUniform {
            moon_direction: m.position.normalize_or_zero().as_vec3().to_array(),
            moon_sine: sine as f32,
            moon_chord: chord as f32,
            albedo_over_pi: (MOON_ALBEDO / std::f64::consts::PI) as f32,
            earthshine: m.earthshine as f32,
            sun_visibility: both(frame).map_or(1.0, |d| d.visible()) as f32,
            ..block
        };
    }
    nodes.push(Node {
        uniform: Uniform::new(&block),
        fraction,
        ..Node::draw(label, Stage::Background, program.blended(), Resource::Background)
    });
}
