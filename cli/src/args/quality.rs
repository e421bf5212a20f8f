//! How well the sky is drawn: by a name, by what it has to reach, or by numbers.

use std::time::Duration;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use welkin::Quality;

use crate::args::values::{self, number};

/// Most samples along a ray.
const MAX_SAMPLES: u32 = 1024;
/// Most samples towards the sun.
const MAX_LIGHT_SAMPLES: u32 = 256;
/// The samples along a ray and towards the sun where only the other number is asked for.
const SAMPLES: [u32; 2] = [32, 8];

/// Single scattering by its numbers.
pub fn march([view_samples, light_samples]: [u32; 2]) -> Quality {
    Quality::March { view_samples, light_samples }
}

/// How a quality was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QualityArg {
    /// The one that the mode stands for.
    Default,
    /// By the numbers of single scattering: samples along a ray, and from each of them towards the sun.
    Samples([u32; 2]),
    /// By name.
    Named(Quality),
    /// The cheapest with at most this mean error against all orders of scattering.
    WithinError(f64),
    /// The best that takes at most this time a frame, here.
    WithinBudget(Duration),
}

/// The name of a preset.
pub fn parse_quality() -> impl TypedValueParser<Value = Quality> {
    PossibleValuesParser::new(Quality::PRESETS.iter().map(|(name, _)| *name))
        .try_map(|name: String| Quality::from_name(&name))
}

/// A quality by its name.
#[derive(Args, Debug)]
pub struct PresetArgs {
    /// Quality and its numbers by name; 'welkin-lab accuracy' measures what each costs and misses [default:
    /// medium]
    #[arg(long, value_name = "NAME", group = "chosen", value_parser = parse_quality())]
    quality: Option<Quality>,
}

impl PresetArgs {
    /// The quality that was named.
    pub fn named(&self) -> Option<Quality> {
        self.quality
    }

    /// The quality that was named, or the medium one.
    pub fn quality(&self) -> Quality {
        self.quality.unwrap_or(Quality::MEDIUM)
    }
}

/// Single scattering by its numbers.
#[derive(Args, Debug)]
pub struct SamplesArgs {
    /// Single scattering with so many samples along each view ray, 1 to 1024 [default: 32 if it is asked for]
    #[arg(long, value_name = "N", conflicts_with = "chosen", allow_hyphen_values = true)]
    #[arg(value_parser = values::count(MAX_SAMPLES))]
    samples: Option<u32>,

    /// Single scattering with so many samples from each of those towards the sun, 1 to 256 [default: 8 if it
    /// is asked for]
    #[arg(long, value_name = "N", conflicts_with = "chosen", allow_hyphen_values = true)]
    #[arg(value_parser = values::count(MAX_LIGHT_SAMPLES))]
    light_samples: Option<u32>,
}

impl SamplesArgs {
    /// Both numbers, if at least one of them was given.
    pub fn given(&self) -> Option<[u32; 2]> {
        (self.samples.is_some() || self.light_samples.is_some()).then(|| self.or_default())
    }

    /// Both numbers, those that were not given as by default.
    pub fn or_default(&self) -> [u32; 2] {
        [self.samples.unwrap_or(SAMPLES[0]), self.light_samples.unwrap_or(SAMPLES[1])]
    }
}

/// A quality in one of four ways.
#[derive(Args, Debug)]
pub struct QualityArgs {
    #[command(flatten)]
    preset: PresetArgs,

    /// The cheapest quality with at most this mean error against all orders of scattering, as in 0.4 for 40 %
    ///
    /// Of radiance, in the worst channel, over the Earth scenes of 'welkin-lab accuracy', by the table in
    /// this program.
    #[arg(long, value_name = "ERROR", group = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = number(0.0, 1e6, ""))]
    within_error: Option<f64>,

    /// The best quality whose sky takes at most this time a frame, as in 5ms; measured here first
    ///
    /// Every quality is timed on the backend that draws, in frames of the picture's size: the mean over a
    /// view from the ground, one of the limb and one of the whole Earth.
    #[arg(long, value_name = "TIME", group = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = values::duration)]
    within_budget: Option<Duration>,

    #[command(flatten)]
    samples: SamplesArgs,
}

impl QualityArgs {
    /// The option that asked for a quality, as errors name it.
    pub fn option(&self) -> Option<&'static str> {
        match self.asked() {
            QualityArg::Default => None,
            QualityArg::Named(_) => Some("--quality <NAME>"),
            QualityArg::WithinError(_) => Some("--within-error <ERROR>"),
            QualityArg::WithinBudget(_) => Some("--within-budget <TIME>"),
            QualityArg::Samples(_) => Some("--samples <N> and --light-samples <N>"),
        }
    }

    /// How the quality was asked for.
    pub fn asked(&self) -> QualityArg {
        let named = self.preset.named().map(QualityArg::Named);
        let error = self.within_error.map(QualityArg::WithinError);
        let budget = self.within_budget.map(QualityArg::WithinBudget);
        let samples = self.samples.given().map(QualityArg::Samples);
        named.or(error).or(budget).or(samples).unwrap_or(QualityArg::Default)
    }
}
