//! What an effect is: something that a frame may have or not, and why.

use std::fmt;

use super::graph::Node;
use super::{Frame, aerial, airglow, background, disks, eclipse, luts, medium};
use crate::error::short;

/// Why an effect is on or off: words, and where a number decided, that number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reason {
    text: &'static str,
    value: Option<f64>,
    unit: &'static str,
}

impl Reason {
    /// A reason without a number.
    pub(crate) const fn of(text: &'static str) -> Self {
        Self { text, value: None, unit: "" }
    }

    /// A reason with the number that decided; the unit begins with its space.
    pub(crate) const fn number(text: &'static str, value: f64, unit: &'static str) -> Self {
        Self { text, value: Some(value), unit }
    }
}

impl fmt::Display for Reason {
    /// The words, then the number in three digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text)?;
        let Some(value) = self.value else { return Ok(()) };
        f.write_str(" ")?;
        f.write_str(&short(three_digits(value)))?;
        f.write_str(self.unit)
    }
}

fn three_digits(v: f64) -> f64 {
    if v == 0.0 || !v.is_finite() {
        return v;
    }
    // By division, so that the result is the nearest to a short decimal.
    let digits = 2 - v.abs().log10().floor() as i32;
    if digits > 0 { (v * 10_f64.powi(digits)).round() / 10_f64.powi(digits) } else { v.round() }
}

/// Whether a frame has an effect, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectReport {
    /// What the effect is called, in lower case.
    pub name: &'static str,
    /// Whether the frame has it.
    pub on: bool,
    /// Why it has it or not.
    pub reason: Reason,
}

/// On or off, with the reason.
pub(crate) type Decision = (bool, Reason);

/// An effect: it decides whether a frame has it, and adds the nodes that draw it. One type in one file; the
/// list of all is [`EFFECTS`].
pub(crate) trait Effect: Sync {
    /// What it is called, in lower case; no two effects have the same name.
    fn name(&self) -> &'static str;

    /// Whether the frame has it. Effects that stand before it in the list have decided.
    fn decide(&self, frame: &Frame) -> Decision;

    /// Adds what draws it, if the frame has it. Nodes run in the order of the list, within their stages.
    fn push_nodes(&self, _frame: &Frame, _nodes: &mut Vec<Node>) {}
}

/// Every effect: in the order in which they decide, are listed and are drawn.
pub(crate) static EFFECTS: [&dyn Effect; EFFECT_COUNT] = [
    &medium::Atmosphere,
    &medium::Rayleigh,
    &medium::Mie,
    &medium::Ozone,
    &medium::Sunlight,
    &eclipse::Eclipse,
    &luts::TransmittanceLut,
    &luts::MultiScattering,
    &luts::SkyViewLut,
    &luts::AerialLut,
    &airglow::AirglowBehind,
    &background::BackgroundSky,
    &background::ReducedResolution,
    &disks::SunDisk,
    &disks::MoonDisk,
    &aerial::PlanetShell,
    &aerial::AerialPerspective,
    &airglow::AirglowBefore,
];

/// How many effects there are.
pub(crate) const EFFECT_COUNT: usize = 18;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reasons_are_written_in_three_digits() {
        for (value, text) in
            [(0.0, "0"), (1234.5, "1235"), (0.012_345, "0.0123"), (-6.0, "-6"), (12.345, "12.3")]
        {
            assert_eq!(Reason::number("sun at", value, "°").to_string(), format!("sun at {text}°"));
        }
        assert_eq!(Reason::of("switched off").to_string(), "switched off");
    }

    #[test]
    fn names_are_unique() {
        for (i, effect) in EFFECTS.iter().enumerate() {
            assert!(EFFECTS[..i].iter().all(|e| e.name() != effect.name()), "{}", effect.name());
        }
    }
}
