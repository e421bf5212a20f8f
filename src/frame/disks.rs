//! The disks of sun and moon: a rectangle around each, laid over the sky.

use std::f64::consts::FRAC_PI_2;

use super::draw::Draw;
use super::uniforms::{FrameUniform, block};
use crate::error::Result;
use crate::gpu::{Backend, DepthUse, Inputs, Pass, Target, Uniform};
use crate::model::moon::MOON_ALBEDO;
use crate::model::scene::{RayBasis, ZenithView};

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

/// Where in the picture (left, bottom, right, top, -1 to 1) the disk may touch a pixel; `None` outside of it.
/// radius: of the disk with its soft edge, radians; size: of the target, pixels.
pub(crate) fn rectangle(basis: &RayBasis, sun: glam::DVec3, radius: f64, size: [u32; 2]) -> Option<[f64; 4]> {
    let axis = basis.right.cross(basis.up).normalize_or_zero();
    let axis = if axis.dot(basis.forward) < 0.0 { -axis } else { axis };
    let along = axis.dot(sun);
    let angle = axis.cross(sun).length().atan2(along);
    if angle + radius > FRAC_PI_2 - 0.01 {
        // A cone that reaches the camera's plane has no outline in the picture.
        let corner = |x: f64, y: f64| axis.angle_between(basis.forward + basis.right * x + basis.up * y);
        let widest = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, -1.0), corner(1.0, 1.0)];
        let seen = widest.into_iter().fold(0.0, f64::max) + 0.01 > angle - radius;
        return seen.then_some([-1.0, -1.0, 1.0, 1.0]);
    }
    // On the camera's plane at distance 1 the disk lies within a circle around its centre.
    let reach = (angle + radius).tan() - angle.tan();
    let span = |side: glam::DVec3, pixels: u32| {
        let length2 = side.length_squared();
        let middle = (sun / along - basis.forward).dot(side) / length2;
        let half = reach / length2.sqrt() + 2.0 / f64::from(pixels.max(1)); // one pixel
        (middle - half, middle + half)
    };
    let ((left, right), (bottom, top)) = (span(basis.right, size[0]), span(basis.up, size[1]));
    let outside = left > 1.0 || right < -1.0 || bottom > 1.0 || top < -1.0;
    (!outside).then(|| [left, bottom, right, top].map(|v| v.clamp(-1.0, 1.0)))
}

/// How a disk is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DiskPlan {
    pub label: &'static str,
    pub program: Draw,
    /// As `rectangle` gives it.
    pub rect: [f64; 4],
    /// Share of the sun's disk that the moon leaves.
    pub share: f64,
}

/// The pass that draws a disk.
pub(crate) fn disk_pass(
    backend: &mut dyn Backend,
    view: &ZenithView,
    frame: &FrameUniform,
    plan: &DiskPlan,
    target: Target,
) -> Result<Pass> {
    let [left, bottom, right, top] = plan.rect;
    // The frame's up points to the target's first row.
    let flipped = glam::Vec3::from(frame.ray_up).as_dvec3().dot(view.basis.up) < 0.0;
    let rect = if flipped { [left, -top, right, -bottom] } else { [left, bottom, right, top] };
    let mut uniform = DiskUniform { frame: *frame, rectangle: rect.map(|v| v as f32), ..DiskUniform::default() };
    if let Some(m) = &view.moon {
        let (towards, sine) = (m.position.normalize_or_zero(), m.radius / m.position.length());
        // 2 sin(a / 2) of sin a, without a difference of cosines.
        let chord = (2.0 * sine * sine / (1.0 + (1.0 - sine * sine).max(0.0).sqrt())).sqrt();
        uniform = DiskUniform {
            moon_direction: towards.as_vec3().to_array(),
            moon_sine: sine as f32,
            moon_chord: chord as f32,
            albedo_over_pi: (MOON_ALBEDO / std::f64::consts::PI) as f32,
            earthshine: m.earthshine as f32,
            sun_visibility: plan.share as f32,
            ..uniform
        };
    }
    Ok(Pass {
        label: plan.label,
        program: Some(backend.create_program(plan.program.program())?),
        inputs: Inputs::NONE,
        uniform: Uniform::new(&uniform),
        target,
        depth: DepthUse::Always,
    })
}
