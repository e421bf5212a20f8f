//! Qualities by name, and choosing one by how exact or how fast it has to be.
//!
//! ```
//! use std::time::Duration;
//! use welkin::{PictureSettings, Quality, quality::Front};
//!
//! // By name.
//! let settings = PictureSettings { sky: Quality::HIGH.into(), ..Default::default() };
//! // The cheapest that is within 5 % of all orders of scattering, by the table in this crate.
//! let quality = Quality::within_error(0.05)?;
//! let cost = Front::committed().cost(&quality);
//! # assert!(cost.unwrap().error <= 0.05);
//! # Ok::<(), welkin::Error>(())
//! ```
//!
//! What is possible is what was measured: see [`Front`].

use std::time::Duration;

use crate::error::{Error, Quoted, Result};
use crate::frame::lut::LutSettings;
use crate::render::sky::{Method, SkySettings};

pub use super::front::{Cost, Front, MEDIA, MeanError, Measured, Point};

/// A set of numbers with a name. How exact and how fast it is, is measured: [`Front::cost`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Unique among those that are compared.
    pub name: &'static str,
    /// How the light is computed.
    pub method: Method,
    /// [`SkySettings::render_scale`].
    pub render_scale: f64,
}

/// The only list of presets: constants, [`Quality::ALL`], the command line, the page and the report follow it.
macro_rules! presets {
    ($($(#[$doc:meta])* $constant:ident = $name:literal, $method:expr, scale $scale:literal;)*) => {
        impl Quality {
            $($(#[$doc])* pub const $constant: Self = Self { name: $name, method: $method, render_scale: $scale };)*

            /// Every preset, the cheapest of a method first.
            pub const ALL: &'static [Self] = &[$(Self::$constant),*];
        }
    };
}

presets! {
    /// All orders from small tables.
    LOW = "low", Method::Lut(LutSettings::LOW), scale 1.0;
    /// All orders from tables, for ordinary use: the default.
    MEDIUM = "medium", Method::Lut(LutSettings::MEDIUM), scale 1.0;
    /// All orders from large tables, for comparing numbers.
    HIGH = "high", Method::Lut(LutSettings::HIGH), scale 1.0;
    /// Single scattering, the fewest samples.
    SINGLE_LOW = "single-low", single(8, 8), scale 1.0;
    /// Single scattering, for ordinary use.
    SINGLE_MEDIUM = "single-medium", single(16, 8), scale 1.0;
    /// Single scattering, for twilight and limbs.
    SINGLE_HIGH = "single-high", single(16, 16), scale 1.0;
    /// Single scattering, for dust and haze.
    SINGLE_ULTRA = "single-ultra", single(32, 16), scale 1.0;
}

const fn single(view_samples: u32, light_samples: u32) -> Method {
    Method::Single { view_samples, light_samples }
}

impl Quality {
    /// A preset by its name.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the names that there are.
    pub fn from_name(name: &str) -> Result<Self> {
        Self::ALL.iter().find(|q| q.name == name).copied().ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|q| q.name).collect();
            Error::invalid("quality", Quoted(name), format_args!("one of {}", names.join(", ")))
        })
    }

    /// [`Front::within_error`] of [`Front::committed`]: the cheapest preset whose error is at most `error`.
    ///
    /// # Errors
    /// As there.
    pub fn within_error(error: f64) -> Result<Self> {
        Front::committed().within_error(error)
    }

    /// [`Front::within_budget`] of [`Front::committed`]: the best preset that takes at most `budget` on the
    /// device and at the size that the table was measured with. For your device, [`Front::measure`] first.
    ///
    /// # Errors
    /// As there.
    pub fn within_budget(budget: Duration) -> Result<Self> {
        Front::committed().within_budget(budget)
    }

    /// Whether it draws the same as another, whatever their names.
    pub(crate) fn same_numbers(&self, other: &Self) -> bool {
        self.method == other.method && self.render_scale == other.render_scale
    }
}

impl From<Quality> for SkySettings {
    /// The rest as in [`SkySettings::default`].
    fn from(quality: Quality) -> Self {
        Self { method: quality.method, render_scale: quality.render_scale, ..Self::default() }
    }
}

impl std::fmt::Display for Quality {
    /// Name and numbers: `medium (single 16 × 8)`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({}", self.name, self.method)?;
        if self.render_scale != 1.0 {
            write!(f, ", render scale {}", self.render_scale)?;
        }
        f.write_str(")")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_are_valid_and_have_names_of_their_own() {
        for (i, q) in Quality::ALL.iter().enumerate() {
            SkySettings::from(*q).validate().unwrap();
            assert_eq!(Quality::from_name(q.name), Ok(*q));
            assert!(Quality::ALL[..i].iter().all(|p| p.name != q.name && !p.same_numbers(q)), "{q}");
            // They stand in a table whose columns are parted by commas.
            assert!(!q.name.is_empty() && q.name.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{q}");
        }
        let half = Quality { name: "half", render_scale: 0.5, ..Quality::SINGLE_MEDIUM };
        assert_eq!(half.to_string(), "half (single 16 × 8, render scale 0.5)");
    }
}
