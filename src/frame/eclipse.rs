//! The moon's shadow in the air and on the ground: whether it falls on what is seen, and the LUT that passes
//! read of it.

use std::f64::consts::PI;

use super::Frame;
use super::effect::{Decision, Effect, Reason};
use super::graph::{Extent, Node, Resource, Runs, Texel, Work};
use super::luts::LutsUniform;
use super::medium::{NO_AIR, Sunlight};
use super::uniforms::{FrameUniform, block};
use crate::gpu::Uniform;
use crate::model::atmosphere::AtmosphereParams;
use crate::model::moon::{Disks, Moon};
use crate::model::scene::ZenithView;

block! {
    /// `struct MoonShadow` in `lib/moon_shadow.wgsl`.
    #[allow(missing_docs)]
    ShadowUniform {
        across: [f32; 3],
        along: f32,
        radius: f32,
        tan_sun_radius: f32,
        min_visibility: f32,
        inv_extent: f32,
    }
}

block! {
    /// `struct Uniforms` in `lib/eclipsed_sun.wgsl`, of passes under a moon's shadow.
    #[allow(missing_docs)]
    EclipseUniform {
        frame: FrameUniform,
        luts: LutsUniform,
        moon_shadow: ShadowUniform,
    }
}

block! {
    /// What the texels of the moon-shadow LUT depend on, as bytes; no shader reads it.
    ShadowKey {
        /// Each of the five numbers of `MoonShadow` as the two halves of an f64, then padding.
        halves: [u32; 10],
        /// Fills up sixteen bytes.
        pad: [u32; 2],
    }
}

/// The moon-shadow LUT as nodes name it.
pub(crate) const MOON_SHADOW: Resource = Resource::pool("moon_shadow_lut", 0);

/// Texels of a row of the moon-shadow LUT.
const TEXELS: usize = 256;

/// The moon's shadow on air that is seen.
pub(crate) struct Eclipse;

impl Effect for Eclipse {
    fn name(&self) -> &'static str {
        "eclipse"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let (p, view, seen) = (&frame.scene.atmosphere, &frame.view, &frame.visibility);
        let down = -glam::DVec3::Z * seen.camera_radius;
        // The whole planet with its air; and what a camera within the air can see of it.
        let apart = misses(view, p, down, seen.top).max(misses(view, p, glam::DVec3::ZERO, seen.farthest()));
        if view.moon.is_none() {
            (false, Reason::of("the scene has no moon"))
        } else if !frame.has_air() {
            NO_AIR
        } else if !frame.is_on(&Sunlight) {
            (false, Reason::of("there is no light to hide"))
        } else if frame.settings.bound.is_some() && apart > 0.0 {
            (false, Reason::number("the moon's shadow misses the air in sight by", apart / 1e3, " km"))
        } else {
            (true, Reason::of("the moon's shadow falls on air in sight"))
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let Some(shadow) = frame.moon_shadow() else { return };
        let extent = Extent { size: [TEXELS as u32, 2], texel: Texel::Exact };
        let upload = Work::Upload(|frame| frame.moon_shadow().map_or_else(Vec::new, |s| s.texels().to_vec()));
        let key = Uniform::new(&shadow.key());
        nodes.push(Node::fill("moon-shadow LUT", Runs::PerAltitude, upload, MOON_SHADOW, extent, key));
    }
}

impl Frame {
    /// The moon's shadow, if it falls on what is seen.
    pub(crate) fn moon_shadow(&self) -> Option<MoonShadow> {
        let moon = self.view.moon.as_ref().filter(|_| self.is_on(&Eclipse))?;
        Some(MoonShadow::new(&self.view, &self.scene.atmosphere, moon))
    }

    /// The block that says where it is, if it falls on what is seen.
    pub(crate) fn moon_shadow_block(&self) -> Option<ShadowUniform> {
        let moon = self.view.moon.as_ref().filter(|_| self.is_on(&Eclipse))?;
        Some(shadow_block(&self.view, &self.scene.atmosphere, moon, &self.moon_shadow()?))
    }

    /// The block of a pass that marches under the moon's shadow.
    pub(crate) fn with_eclipse(&self, frame: FrameUniform) -> Uniform {
        let steps = self.luts().map_or(0, |luts| {
            // Half of what a texel of the LUTs gets: here it is for each pixel.
            (luts.sky_view_steps / 2).max(4)
        });
        let moon_shadow = self.moon_shadow_block().unwrap_or_default();
        let luts = if steps > 0 { LutsUniform { steps, ..self.luts_block } } else { LutsUniform::default() };
        Uniform::new(&EclipseUniform { frame, luts, moon_shadow })
    }
}

/// Where the moon stands as seen from the camera: across the sun's direction and along it, metres.
fn offset(view: &ZenithView, moon: &Moon) -> (glam::DVec3, f64) {
    let along = moon.position.dot(view.sun);
    (moon.position - view.sun * along, along)
}

/// Radius of the penumbra (metres) at a distance behind the moon (metres).
fn penumbra(moon: &Moon, sun_radius: f64, behind: f64) -> f64 {
    moon.radius / sun_radius.cos() + behind.max(0.0) * sun_radius.tan()
}

/// How far from a ball (metres; centre from the camera) the penumbra passes; 0 where it touches it.
fn misses(view: &ZenithView, p: &AtmosphereParams, center: glam::DVec3, radius: f64) -> f64 {
    let Some(moon) = &view.moon else { return f64::INFINITY };
    let (across, along) = offset(view, moon);
    let beside = center.dot(view.sun);
    let behind = along - beside + radius;
    if behind <= 0.0 {
        return -behind;
    }
    let apart = (across - (center - view.sun * beside)).length();
    (apart - radius - penumbra(moon, p.sun_angular_radius, behind)).max(0.0)
}

/// How far around a point the sunlight counts that is scattered there again: mean distance in scale heights
/// of the gas. Chosen for the Earth by path tracing under a total eclipse, see docs/eclipse.md: much the same
/// for red and blue, so that it is the air's depth that decides and not how far light goes in it.
const AROUND: f64 = 5.0;

/// What the moon-shadow LUT is made of; it is made again where this changes. Metres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MoonShadow {
    /// Distance of the planet's middle behind the moon.
    behind: f64,
    moon_radius: f64,
    sun_angular_radius: f64,
    /// Mean distance of the points around.
    length: f64,
    limb_darkening: bool,
}

impl MoonShadow {
    pub fn new(view: &ZenithView, p: &AtmosphereParams, moon: &Moon) -> Self {
        let (_, along) = offset(view, moon);
        // At the planet's middle: over the planet the cones change by a percent.
        let middle = -(p.planet_radius + view.altitude) * view.sun.z;
        Self {
            // To the nearest 32-bit float, some metres: the same for two eyes.
            behind: f64::from((along - middle).max(moon.radius) as f32),
            moon_radius: moon.radius,
            sun_angular_radius: p.sun_angular_radius,
            length: AROUND * p.rayleigh_scale_height,
            limb_darkening: moon.limb_darkening,
        }
    }

    fn key(&self) -> ShadowKey {
        let Self { behind, moon_radius, sun_angular_radius, length, limb_darkening } = *self;
        let length = if limb_darkening { length } else { -length };
        let mut halves = [0; 10];
        for (pair, v) in
            halves.chunks_exact_mut(2).zip([behind, moon_radius, sun_angular_radius, length, 0.0])
        {
            let bits = v.to_bits();
            (pair[0], pair[1]) = (bits as u32, (bits >> 32) as u32);
        }
        ShadowKey { halves, pad: [0; 2] }
    }

    /// Distance from the shadow's axis up to which the first row reaches, metres.
    fn reach(&self) -> f64 {
        self.moon_radius / self.sun_angular_radius.cos()
            + self.behind * self.sun_angular_radius.tan()
            + 4.0 * self.length
    }

    /// The disks with their middles at an angle.
    fn disks(&self, apart: f64) -> Disks {
        let moon = (self.moon_radius / self.behind).min(1.0).asin();
        Disks { sun: self.sun_angular_radius, moon, apart }
    }

    /// Share of sunlight by the distance from the shadow's axis, as a mean over points all around whose
    /// distances are distributed like `exp(-x / length)`. In a second row what a darker edge of the sun makes
    /// of the share: over that of a uniform disk, at the positions of `moon_distance_to_u` in
    /// `lib/moon_shadow.wgsl`. Red, green, blue, unused; per texel.
    pub fn texels(&self) -> [f32; 8 * TEXELS] {
        let step = self.reach() / (TEXELS - 1) as f64;
        // Of the point itself.
        let sharp: [[f64; 3]; TEXELS] = std::array::from_fn(|i| {
            let seen = self.disks((i as f64 * step).atan2(self.behind));
            if self.limb_darkening { seen.visible_limb_darkened() } else { [seen.visible(); 3] }
        });
        let share = |distance: f64, c: usize| {
            let at = distance / step;
            let low = (at as usize).min(TEXELS - 2);
            let part = (at - low as f64).min(1.0);
            sharp[low][c] * (1.0 - part) + sharp[low + 1][c] * part
        };
        // Midpoints of equal weights: in the distance, and around half of a turn.
        const RINGS: usize = 12;
        const TURNS: usize = 8;
        let rings: [f64; RINGS] =
            std::array::from_fn(|i| -self.length * (1.0 - (i as f64 + 0.5) / RINGS as f64).ln());
        let turns: [f64; TURNS] = std::array::from_fn(|i| ((i as f64 + 0.5) / TURNS as f64 * PI).cos());
        let mut texels = [1.0; 8 * TEXELS];
        let (around, limb) = texels.split_at_mut(4 * TEXELS);
        for (i, texel) in around.chunks_exact_mut(4).enumerate() {
            let d = i as f64 * step;
            let mut sum = [0.0; 3];
            for x in rings {
                for turn in turns {
                    let apart = (d * d + x * x + 2.0 * d * x * turn).max(0.0).sqrt();
                    (0..3).for_each(|c| sum[c] += share(apart, c));
                }
            }
            (0..3).for_each(|c| texel[c] = (sum[c] / (RINGS * TURNS) as f64) as f32);
        }
        // From outside, so that the umbra, where both are 0, has what its edge has.
        let mut factor = [1.0; 3];
        for i in (0..TEXELS).rev().filter(|_| self.limb_darkening) {
            let seen = self.disks(self.apart_at(i as f64 / (TEXELS - 1) as f64));
            let uniform = seen.visible();
            if uniform > 0.0 {
                factor = seen.visible_limb_darkened().map(|v| (v / uniform) as f32);
            }
            limb[4 * i..4 * i + 3].copy_from_slice(&factor);
        }
        texels
    }

    /// `moon_distance_to_u` the other way: the angle at a share of the second row.
    fn apart_at(&self, share: f64) -> f64 {
        let Disks { sun, moon, .. } = self.disks(0.0);
        let inner = (sun - moon).abs();
        if share < 0.25 {
            4.0 * share * inner
        } else {
            inner + 2.0 * sun.min(moon) * ((share - 0.25) / 0.75).powi(2)
        }
    }
}

fn shadow_block(view: &ZenithView, p: &AtmosphereParams, moon: &Moon, shadow: &MoonShadow) -> ShadowUniform {
    let (across, along) = offset(view, moon);
    ShadowUniform {
        across: (across * 1e-3).as_vec3().to_array(),
        along: (along * 1e-3) as f32,
        radius: (moon.radius * 1e-3) as f32,
        tan_sun_radius: p.sun_angular_radius.tan() as f32,
        min_visibility: moon.floor as f32,
        inv_extent: (1e3 / shadow.reach()) as f32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_darker_edge_is_a_factor_between_the_texels_too() {
        for size in [0.3, 0.95, 1.0, 1.0566, 1.3_f64] {
            let sun = 4.65e-3;
            let shade = MoonShadow {
                behind: 3.7e8,
                moon_radius: (size * sun).sin() * 3.7e8,
                sun_angular_radius: sun,
                length: 4e4,
                limb_darkening: true,
            };
            let texels = shade.texels();
            let mut worst: f64 = 0.0;
            for i in 0..(TEXELS - 1) {
                for part in [0.0, 0.3, 0.5, 0.8] {
                    let seen = shade.disks(shade.apart_at((i as f64 + part) / (TEXELS - 1) as f64));
                    for c in 0..3 {
                        let [a, b] = [i, i + 1].map(|i| f64::from(texels[4 * (TEXELS + i) + c]));
                        let got = (a + (b - a) * part) * seen.visible();
                        worst = worst.max((got - seen.visible_limb_darkened()[c]).abs());
                    }
                }
            }
            assert!(worst < 3e-4, "moon of {size}: {worst}");
        }
    }
}
