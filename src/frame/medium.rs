//! The air itself: which constituents a frame has, and whether sunlight reaches them. These effects draw
//! nothing; they decide which constants the others are compiled with.

use super::Frame;
use super::effect::{Decision, Effect, Reason};
use super::omit::{Candidate, LightBounds, cost, omit};
use crate::gpu::{Program, ProgramInfo};
use crate::model::atmosphere::AtmosphereParams;
use crate::settings::{Bound, Quality};

/// Which constituents a frame's air has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Air {
    /// Gas that scatters after Rayleigh.
    pub rayleigh: bool,
    /// Aerosol.
    pub mie: bool,
    /// The absorbing layer.
    pub ozone: bool,
}

impl Air {
    /// Every constituent: what programs are compiled with whose LUTs hold whatever the air has.
    pub(crate) const ALL: Self = Self { rayleigh: true, mie: true, ozone: true };

    /// The constituents whose coefficients are not all zero.
    pub fn of(params: &AtmosphereParams) -> Self {
        let some = |c: &[f64; 3]| c.iter().any(|&v| v > 0.0);
        Self {
            rayleigh: some(&params.rayleigh_scattering),
            mie: some(&params.mie_scattering) || some(&params.mie_absorption),
            ozone: some(&params.ozone_absorption),
        }
    }

    /// Whether there is any air at all.
    pub fn any(self) -> bool {
        self.rayleigh || self.mie || self.ozone
    }

    /// A program with the constants of these constituents, and with others of which the program may have
    /// some.
    pub(crate) fn program<const N: usize>(
        self,
        info: &'static ProgramInfo,
        others: [(&str, bool); N],
    ) -> Program {
        let own = [("RAYLEIGH", self.rayleigh), ("MIE", self.mie), ("OZONE", self.ozone)];
        let on = own.iter().chain(&others).filter(|(_, on)| *on);
        Program::new(info, on.fold(0, |bits, (name, _)| bits | info.constant(name)))
    }
}

/// What was left out of a frame's light, and the bounds that decided.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Omission {
    /// Constituents that the medium has.
    pub there: Air,
    /// Constituents that the frame has.
    pub air: Air,
    /// Optical depth of each along the longest path in sight, at most.
    pub depths: [f64; 3],
    /// Optical depth of all scattering along that path, at most.
    pub scattering_depth: f64,
    /// Whether anything scatters sunlight.
    pub scatters: bool,
    /// Radiance of the air where the sun is below the horizon, at most; infinite by day.
    pub night: f64,
    /// Whether sunlight is left out.
    pub unlit: bool,
    /// Radiance of what was scattered more than once, at most.
    pub multiple: f64,
    /// Whether light that was scattered more than once is left out.
    pub single: bool,
}

impl Omission {
    /// Chooses what is left out, from upper bounds of what each omission changes. `was_on`: of the frame
    /// before, by the effect's name. sun_disk: whether the sun's disk is in the picture.
    pub fn new(frame: &Frame, sun_disk: bool, was_on: impl Fn(&dyn Effect) -> bool) -> Self {
        let params = &frame.scene.atmosphere;
        let there = Air::of(params);
        let luts = matches!(frame.settings.quality, Quality::Luts(_));
        // LUTs hold every direction, whichever way the camera looks.
        let lowest = if luts { 0.0 } else { frame.visibility.lowest };
        let bounds = LightBounds::new(params, &frame.visibility, lowest);
        let bound = frame.settings.bound.unwrap_or(Bound::EXACT);
        // A sun whose disk is in the picture stands in no night, however large it is.
        let night = if sun_disk { f64::INFINITY } else { bounds.night(&frame.visibility, luts) };
        let constituent = |i: usize, there: bool, effect: &dyn Effect| Candidate {
            cost: if there { bounds.without(i, bound) } else { 0.0 },
            absent: !there,
            was_on: was_on(effect),
        };
        let light =
            |cost: f64, effect: &dyn Effect| Candidate { cost, absent: false, was_on: was_on(effect) };
        let multiple = bounds.multiple();
        let out = omit(
            [
                constituent(0, there.rayleigh, &Rayleigh),
                constituent(1, there.mie, &Mie),
                constituent(2, there.ozone, &Ozone),
                light(cost(night, bound.absolute), &Sunlight),
                light(
                    if luts { cost(multiple, bound.absolute) } else { f64::INFINITY },
                    &super::luts::MultiScattering,
                ),
            ],
            frame.settings.bound.is_some(),
        );
        Self {
            there,
            air: Air { rayleigh: !out[0], mie: !out[1], ozone: !out[2] },
            depths: [0, 1, 2].map(|i| bounds.depth(i)),
            scattering_depth: bounds.total(),
            scatters: bounds.scatters(),
            night,
            unlit: out[3],
            multiple,
            single: out[4],
        }
    }
}

/// Any air at all.
pub(crate) struct Atmosphere;

impl Effect for Atmosphere {
    fn name(&self) -> &'static str {
        "atmosphere"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let o = &frame.omission;
        if let Some(text) = frame.no_air {
            (false, Reason::of(text))
        } else if !o.air.any() {
            (false, Reason::of("too thin to be seen"))
        } else {
            (true, Reason::number("in the picture; camera at", frame.view.altitude / 1e3, " km"))
        }
    }
}

/// Says of a constituent whether the frame has it.
fn constituent(frame: &Frame, there: bool, on: bool, depth: f64) -> Decision {
    if frame.no_air.is_some() {
        return NO_AIR;
    }
    let reason = match (there, on) {
        (false, _) => Reason::of("its coefficients are 0"),
        (_, false) => Reason::number("changes no pixel by more than the bound: optical depth", depth, ""),
        (_, true) => Reason::number("optical depth along the longest path", depth, ""),
    };
    (on, reason)
}

pub(crate) const NO_AIR: Decision = (false, Reason::of("no air to see"));

/// The gas.
pub(crate) struct Rayleigh;

impl Effect for Rayleigh {
    fn name(&self) -> &'static str {
        "rayleigh"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let o = &frame.omission;
        constituent(frame, o.there.rayleigh, o.air.rayleigh, o.depths[0])
    }
}

/// The aerosol.
pub(crate) struct Mie;

impl Effect for Mie {
    fn name(&self) -> &'static str {
        "mie"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let o = &frame.omission;
        constituent(frame, o.there.mie, o.air.mie, o.depths[1])
    }
}

/// The absorbing layer.
pub(crate) struct Ozone;

impl Effect for Ozone {
    fn name(&self) -> &'static str {
        "ozone"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        let o = &frame.omission;
        constituent(frame, o.there.ozone, o.air.ozone, o.depths[2])
    }
}

/// Sunlight on the air; without it the air dims what lies behind and sends no light.
pub(crate) struct Sunlight;

impl Effect for Sunlight {
    fn name(&self) -> &'static str {
        "sunlight"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let o = &frame.omission;
        let sun = frame.visibility.sun_elevation.to_degrees();
        let reason = match (o.scatters, o.unlit) {
            (false, _) => Reason::of("nothing scatters it, or the sun is dark"),
            (_, true) if o.night == 0.0 => {
                Reason::number("the planet's shadow covers all air in sight; sun at", sun, "°")
            }
            (_, true) => Reason::number("night: the air in sight is darker than the bound; sun at", sun, "°"),
            (_, false) if frame.settings.bound.is_none() => Reason::of("nothing is to be left out"),
            (_, false) => Reason::number("sun at", sun, "°"),
        };
        (o.scatters && !o.unlit, reason)
    }
}
