//! How well the light is computed: qualities by name, and choosing one by how exact or how fast it has to be.
//!
//! ```
//! use std::time::Duration;
//! use welkin::{PictureSettings, Quality, settings::front::ParetoFront};
//!
//! // By name.
//! let settings = PictureSettings { sky: Quality::HIGH.into(), ..Default::default() };
//! // The cheapest that is within 5 % of all orders of scattering, by the measured table in this crate.
//! let quality = Quality::within_error(0.05)?;
//! let cost = ParetoFront::committed().cost(&quality);
//! # assert!(cost.unwrap().error <= 0.05);
//! # Ok::<(), welkin::Error>(())
//! ```
//!
//! What is possible is what was measured: see [`ParetoFront`].

use std::fmt;
use std::time::Duration;

use super::front::ParetoFront;
use super::luts::LutSettings;
use crate::error::{Error, Quoted, Result};

/// How the light is computed, and how finely. How exact and how fast that is, is measured:
/// [`ParetoFront::cost`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Quality {
    /// Light scattered once, marched along the view ray and from each step towards the sun. What is
    /// scattered more often is missing.
    March {
        /// Steps along the view ray, 1 to 1024.
        view_samples: u32,
        /// Steps towards the sun at each of them, 1 to 256.
        light_samples: u32,
    },
    /// Light of all orders, from LUTs.
    Luts(LutSettings),
}

/// The only list of presets: constants, [`Quality::PRESETS`], the command line, the page and the report
/// follow it.
macro_rules! presets {
    ($($(#[$doc:meta])* $constant:ident = $name:literal, $quality:expr;)*) => {
        impl Default for Quality {
    /// [`Quality::MEDIUM`].
    fn default() -> Self {
        Self::MEDIUM
    }
}

impl Quality {
            $($(#[$doc])* pub const $constant: Self = $quality;)*

            /// Every preset with its name, the cheapest of a method first.
            pub const PRESETS: &'static [(&'static str, Self)] = &[$(($name, Self::$constant)),*];
        }
    };
}

presets! {
    /// All orders from small LUTs.
    LOW = "low", Quality::Luts(LutSettings::LOW);
    /// All orders from LUTs, for ordinary use: the default.
    MEDIUM = "medium", Quality::Luts(LutSettings::MEDIUM);
    /// All orders from large LUTs, for comparing numbers.
    HIGH = "high", Quality::Luts(LutSettings::HIGH);
    /// Single scattering, the fewest samples.
    SINGLE_LOW = "single-low", march(8, 8);
    /// Single scattering, for ordinary use.
    SINGLE_MEDIUM = "single-medium", march(16, 8);
    /// Single scattering, for twilight and limbs.
    SINGLE_HIGH = "single-high", march(16, 16);
    /// Single scattering, for dust and haze.
    SINGLE_ULTRA = "single-ultra", march(32, 16);
}

const fn march(view_samples: u32, light_samples: u32) -> Quality {
    Quality::March { view_samples, light_samples }
}

impl Quality {
    /// A preset by its name.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the names that there are.
    pub fn from_name(name: &str) -> Result<Self> {
        Self::PRESETS.iter().find(|(n, _)| *n == name).map(|(_, quality)| *quality).ok_or_else(|| {
            let names: Vec<_> = Self::PRESETS.iter().map(|(n, _)| *n).collect();
            Error::invalid("quality", Quoted(name), format_args!("one of {}", names.join(", ")))
        })
    }

    /// The name of the preset with these numbers, if there is one.
    pub fn preset_name(&self) -> Option<&'static str> {
        Self::PRESETS.iter().find(|(_, quality)| quality == self).map(|(name, _)| *name)
    }

    /// The short name of its method, as in reports and on the command line: `single`, `lut`.
    pub const fn method(&self) -> &'static str {
        match self {
            Self::March { .. } => "single",
            Self::Luts(_) => "lut",
        }
    }

    /// Whether it computes light scattered once and no more.
    pub const fn is_single_scattering(&self) -> bool {
        match self {
            Self::March { .. } => true,
            Self::Luts(_) => false,
        }
    }

    /// Its numbers in short, as in reports: samples, or texels of the sky-view LUT and
    /// steps: `16 × 8`, `100 × 100 × 32`.
    pub fn numbers(&self) -> String {
        match self {
            Self::March { view_samples, light_samples } => format!("{view_samples} × {light_samples}"),
            Self::Luts(LutSettings { sky_view: [width, height], sky_view_steps, .. }) => {
                format!("{width} × {height} × {sky_view_steps}")
            }
        }
    }

    /// Checks the ranges given at the variants' fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        let whole = |name: &str, v: u32, hi: u32| {
            if (1..=hi).contains(&v) {
                Ok(())
            } else {
                Err(Error::invalid(name, v, format_args!("from 1 to {hi}")))
            }
        };
        match *self {
            Self::March { view_samples, light_samples } => {
                whole("view_samples", view_samples, 1024)?;
                whole("light_samples", light_samples, 256)
            }
            Self::Luts(settings) => settings.validate(),
        }
    }

    /// The cheapest preset whose error is at most `error`: [`ParetoFront::within_error`] of
    /// [`ParetoFront::committed`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so exact: it says which comes closest.
    pub fn within_error(error: f64) -> Result<Self> {
        ParetoFront::committed().within_error(error)
    }

    /// The best preset that takes at most `budget` on the device and at the size that the committed table was
    /// measured with: [`ParetoFront::within_budget`] of [`ParetoFront::committed`]. For your device, call
    /// [`ParetoFront::measure`] first.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so fast: it says which is the fastest.
    pub fn within_budget(budget: Duration) -> Result<Self> {
        ParetoFront::committed().within_budget(budget)
    }
}

impl fmt::Display for Quality {
    /// The preset's name, where it is one, with method and numbers: `medium (lut 100 × 100 × 32)`, `single 12
    /// × 3`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.preset_name() {
            Some(name) => write!(f, "{name} ({} {})", self.method(), self.numbers()),
            None => write!(f, "{} {}", self.method(), self.numbers()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_are_valid_and_have_names_and_numbers_of_their_own() {
        for (i, (name, quality)) in Quality::PRESETS.iter().enumerate() {
            quality.validate().unwrap();
            assert_eq!(Quality::from_name(name), Ok(*quality));
            assert_eq!(quality.preset_name(), Some(*name));
            assert!(Quality::PRESETS[..i].iter().all(|(n, q)| n != name && q != quality), "{quality}");
            // They stand in a table whose columns are parted by commas.
            assert!(
                !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c == '-'),
                "{quality}"
            );
        }
        let own = Quality::March { view_samples: 12, light_samples: 3 };
        assert_eq!(own.to_string(), "single 12 × 3");
        assert_eq!(Quality::SINGLE_MEDIUM.to_string(), "single-medium (single 16 × 8)");
    }
}
