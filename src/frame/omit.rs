//! What may be left out of a frame: upper bounds of what the air does to light, and the choice of what costs
//! least of the
//! [`Bound`].

use std::f64::consts::PI;

use super::visibility::{MARGIN, Visibility};
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::settings::Bound;

/// The part of a bound that a change uses up; 0 for no change.
pub(crate) fn cost(change: f64, bound: f64) -> f64 {
    if change <= 0.0 { 0.0 } else { change / bound }
}

/// Fraction of the bound below which what is on goes off; off goes on again above the whole bound. So a scene
/// on a threshold does not switch in every frame.
const STAYS_ON: f64 = 0.5;

/// Something that may be left out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    /// The part of the bound that leaving it out uses up; infinite where that cannot be said.
    pub cost: f64,
    /// Whether the scene has it at all: what is absent costs nothing to leave out, not even of no bound.
    pub absent: bool,
    /// Whether it was on in the frame before.
    pub was_on: bool,
}

/// Which candidates are left out: the cheapest, as long as their costs add up to no more than the bound.
/// bounded: `false` leaves out only what is absent.
pub(crate) fn omit<const N: usize>(candidates: [Candidate; N], bounded: bool) -> [bool; N] {
    let mut order: [usize; N] = std::array::from_fn(|i| i);
    order.sort_unstable_by(|&a, &b| candidates[a].cost.total_cmp(&candidates[b].cost));
    let mut spent = 0.0;
    let mut out = [false; N];
    for i in order {
        let Candidate { cost, absent, was_on } = candidates[i];
        let most = if was_on { STAYS_ON } else { 1.0 };
        if absent || (bounded && spent + cost <= most) {
            spent += if absent { 0.0 } else { cost };
            out[i] = true;
        }
    }
    out
}

/// Upper bounds of optical depths and of light, for the air above a height over the lowest ground.
pub(crate) struct LightBounds<'a> {
    p: &'a AtmosphereParams,
    low: f64,
    /// Densities along the longest path in sight, and of a sunbeam to it, metres.
    seen: [f64; 3],
    sunbeam: [f64; 3],
}

impl<'a> LightBounds<'a> {
    pub fn new(p: &'a AtmosphereParams, visibility: &Visibility, low: f64) -> Self {
        let seen = longest(p, low);
        // Where the sun stands above the horizon of all air in sight, no beam comes from below.
        let below = visibility.sun_elevation < visibility.arc_to_air_above(low);
        Self { p, low, seen, sunbeam: if below { longest(p, 0.0) } else { seen } }
    }

    pub fn extinction(&self, i: usize) -> [f64; 3] {
        [self.p.rayleigh_scattering, self.p.mie_extinction(), self.p.ozone_absorption][i]
    }

    pub fn scattering(&self, i: usize) -> [f64; 3] {
        [self.p.rayleigh_scattering, self.p.mie_scattering, [0.0; 3]][i]
    }

    /// Optical depth of a constituent along the longest path in sight, at most.
    pub fn depth(&self, i: usize) -> f64 {
        largest(self.extinction(i)) * self.seen[i]
    }

    /// Optical depth of all scattering along that path.
    pub fn total(&self) -> f64 {
        (0..2).map(|i| largest(self.scattering(i)) * self.seen[i]).sum()
    }

    pub fn scatters(&self) -> bool {
        self.p.sun_intensity > 0.0 && (0..2).any(|i| largest(self.scattering(i)) > 0.0)
    }

    /// Least and largest value of a constituent's phase function, any channel, 1/sr.
    pub fn phase(&self, i: usize) -> [f64; 2] {
        if i == 0 {
            return [3.0 / (16.0 * PI), 3.0 / (8.0 * PI)];
        }
        let g = self.p.mie_asymmetry.iter().fold(0.0_f64, |a, g| a.max(g.abs()));
        let hg = [(1.0 - g) / (1.0 + g).powi(2), (1.0 + g) / (1.0 - g).powi(2)].map(|v| v / (4.0 * PI));
        match self.p.mie_phase {
            MiePhase::HenyeyGreenstein => hg,
            // 1.5 (1 + cos²) / (2 + g²) of it.
            MiePhase::CornetteShanks => [hg[0] * 0.5, hg[1] * 1.5],
        }
    }

    /// The part of a bound that leaving a constituent out uses up.
    ///
    /// Without its extinction, light on the way to the eye and on the way from the sun is brighter by at most
    /// the exponential of its optical depth along both. The light that it scatters is at most its optical
    /// depth times its largest phase function times the light that there is; and against the other
    /// constituent, at most the largest ratio of what both scatter at any altitude in any direction. Light
    /// that comes from elsewhere counts as three times the sun's: that of a white ground and of the air.
    pub fn without(&self, i: usize, bound: Bound) -> f64 {
        let depth = largest(self.extinction(i)) * (self.seen[i] + self.sunbeam[i]);
        let scattering = self.scattering(i);
        let [_, most] = self.phase(i);
        let light = 4.0 * self.p.sun_intensity * largest(scattering) * self.seen[i] * most;
        let j = 1 - i.min(1);
        let [least, _] = self.phase(j);
        let other = self.scattering(j);
        let ends = [self.low, self.p.thickness()].map(|h| self.p.densities(h + self.p.lowest_ground));
        let mut ratio: f64 = 0.0;
        for c in 0..3 {
            for d in ends {
                let (own, others) = (scattering[c] * d[i] * most, other[c] * d[j] * least);
                ratio = ratio.max(if own <= 0.0 { 0.0 } else { own / others });
            }
        }
        cost(depth.exp_m1(), bound.relative)
            + cost(light, bound.absolute).min(cost(2.0 * ratio, bound.relative))
    }

    /// Radiance of light that was scattered more than once, at most: what is scattered into a ray of all that
    /// the sun and the ground send, twice where the air is thin enough for this to matter.
    pub fn multiple(&self) -> f64 {
        let again = (0..2).map(|i| largest(self.scattering(i)) * longest(self.p, 0.0)[i]).sum::<f64>();
        let ground = 2.0 * largest(self.p.ground_albedo);
        let field = self.p.sun_intensity * (ground + 4.0 * again) / (1.0 - (ground + again).min(0.9));
        let phase =
            (0..2).map(|i| largest(self.scattering(i)) * self.seen[i] * self.phase(i)[1]).sum::<f64>();
        phase * field
    }

    /// Radiance of the air in sight where the sun is far below the horizon, at most; infinite otherwise.
    ///
    /// Scattered once, there is none where the planet's shadow covers all air in sight. Of all orders: the
    /// lowest lit point that a horizontal ray meets is at `z = R (1 / cos(d / 2) - 1)` for a sun `d` below
    /// the horizon, and the light falls with the scale heights `x` that this is up. The exponential lies
    /// above the all-orders LUTs of every preset from `x = 4` on, by 1.6 (Mars) and more; tests hold it to
    /// that.
    pub fn night(&self, visibility: &Visibility, luts: bool) -> f64 {
        let depression =
            -visibility.sun_elevation - (visibility.ground_radius / visibility.camera_radius).acos();
        let dip = (visibility.ground_radius / visibility.top).acos();
        if !luts && depression > 2.0 * dip + MARGIN {
            return 0.0;
        }
        let p = self.p;
        let heights = [p.rayleigh_scale_height, p.mie_scale_height];
        let there = |i: usize| largest(self.scattering(i)) > 0.0;
        let height = (0..2).filter(|&i| there(i)).map(|i| heights[i]).fold(0.0, f64::max);
        if depression <= 0.0 || height <= 0.0 {
            return if height <= 0.0 { 0.0 } else { f64::INFINITY };
        }
        let lit = visibility.ground_radius * (1.0 / (0.5 * depression).cos() - 1.0) + p.lowest_ground;
        let x = lit / height;
        if x < 4.0 {
            return f64::INFINITY;
        }
        let depth: f64 = (0..2).map(|i| largest(self.scattering(i)) * heights[i]).sum();
        p.sun_intensity * NIGHT_LIGHT * depth.max(NIGHT_DEPTH) * (-NIGHT_FALL * x).exp()
    }
}

/// Radiance per irradiance and optical depth that the light at night begins with, 1/sr; how fast it falls
/// with the scale heights up to the lit air; and the least depth that counts. See `LightBounds::night`.
const NIGHT_LIGHT: f64 = 1.1e-3;
const NIGHT_FALL: f64 = 0.7;
const NIGHT_DEPTH: f64 = 0.2;

fn largest(v: [f64; 3]) -> f64 {
    v.into_iter().fold(0.0, f64::max)
}

/// Densities integrated along a straight line that comes down to a height over the lowest ground, from top to
/// top: at most. Metres.
///
/// Of an exponential: its Chapman function for a horizontal ray, `sqrt(2 pi r H) (1 + 3 H / (8 r))` and less,
/// and no more than the line is long; below altitude 0, where it is even, the line's length. Of the absorber:
/// its largest density times the length within it.
fn longest(p: &AtmosphereParams, low: f64) -> [f64; 3] {
    let low = low + p.lowest_ground;
    let a = p.planet_radius + low;
    let half = |h: f64| ((h - low) * (p.planet_radius + h + a)).max(0.0).sqrt();
    let line = 2.0 * half(p.top_altitude());
    let exponential = |height: f64| {
        let above = (2.0 * PI * a * height).sqrt() * (1.0 + 0.375 * height / a);
        (-low.max(0.0) / height).exp() * line.min(2.0 * half(0.0) + above)
    };
    let (center, width) = (p.ozone_center_altitude, p.ozone_half_width);
    let (from, to) = ((center - width).max(low), (center + width).min(p.top_altitude()));
    let densest = (1.0 - (low.max(0.0) - center).max(0.0) / width).max(0.0);
    let layer = if to > from { 2.0 * (half(to) - half(from)) * densest } else { 0.0 };
    [exponential(p.rayleigh_scale_height), exponential(p.mie_scale_height), layer]
}
