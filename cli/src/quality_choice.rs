//! Which quality a picture is drawn with, and why.

use std::time::Duration;

use anyhow::bail;
use welkin::settings::front::{Cost, ParetoFront};
use welkin::{Mode, Quality, SkySettings};

use crate::args::quality::{QualityArg, march};
use crate::args::usage::UsageError;
use crate::gpu::Gpu;
use crate::progress::Progress;

/// The quality that is drawn with.
#[derive(Clone, Debug)]
pub struct QualityChoice {
    /// The settings of a sky of that quality, its look as by default.
    pub sky: SkySettings,
    /// The quality in words, for the foot of the contact sheet.
    pub name: String,
    /// Where the choice was left to measurements: what was chosen by which.
    pub why: Option<String>,
}

impl QualityChoice {
    /// Chooses for pictures of a size; only a budget makes the GPU work.
    pub fn new(asked: QualityArg, mode: Mode, gpu: &mut Gpu, size: [u32; 2]) -> anyhow::Result<Self> {
        let (quality, why) = match asked {
            QualityArg::Samples(samples) => {
                let method = march(samples);
                return Ok(Self { sky: SkySettings::from(method), name: method.to_string(), why: None });
            }
            QualityArg::Default => {
                let sky = mode.settings();
                return Ok(Self { sky, name: format!("mode {}, {}", mode.name(), sky.quality), why: None });
            }
            QualityArg::Named(quality) => (quality, None),
            QualityArg::WithinError(error) => {
                let quality =
                    Quality::within_error(error).map_err(|e| refuse("--within-error <ERROR>", e))?;
                (quality, Some(by_error(&quality, error)))
            }
            QualityArg::WithinBudget(budget) => {
                let Some(backend) = gpu.backend() else {
                    let who = gpu.describe();
                    return Err(UsageError::value(
                        "--within-budget <TIME>",
                        words(budget),
                        format_args!("for a GPU backend, whose passes can be timed; here draws {who}"),
                    )
                    .into());
                };
                let steps = Progress::of("measuring", 1);
                let _ = steps.step("every quality, for --within-budget");
                let front = ParetoFront::measure(backend, &presets(), size)?;
                drop(steps);
                let quality = front.within_budget(budget).map_err(|e| refuse("--within-budget <TIME>", e))?;
                let Some(cost) = front.cost(&quality) else { bail!("quality {quality} was not measured") };
                (quality, Some(by_budget(&quality, budget, &cost, size)))
            }
        };
        Ok(Self { sky: SkySettings::from(quality), name: format!("quality {quality}"), why })
    }
}

/// Every preset.
pub fn presets() -> Vec<Quality> {
    Quality::PRESETS.iter().map(|(_, quality)| *quality).collect()
}

fn by_error(quality: &Quality, asked: f64) -> String {
    let front = ParetoFront::committed();
    let mut text = format!("quality {quality}: the cheapest with a mean error of {asked} or less on Earth");
    if let Some(cost) = front.cost(quality) {
        text += &format!("; it has {:.3} against all orders of scattering", cost.error);
    }
    if let Some(m) = front.measured.first() {
        text += &format!(" ({}; cost on {})", m.errors_from, m.adapter);
    }
    text
}

fn by_budget(quality: &Quality, asked: Duration, cost: &Cost, [w, h]: [u32; 2]) -> String {
    format!(
        "quality {quality}: the best that takes {} or less a frame; measured here at {w}×{h} it takes {}, \
         {:.1} full-screen copies; its mean error against all orders of scattering is {:.3} on Earth",
        words(asked),
        words(cost.time),
        cost.copies,
        cost.error
    )
}

fn words(time: Duration) -> String {
    let text = format!("{:.3}", time.as_secs_f64() * 1e3);
    format!("{} ms", text.trim_end_matches('0').trim_end_matches('.'))
}

/// What the library refuses of an option is a wrong request; anything else failed.
fn refuse(option: &str, error: welkin::Error) -> anyhow::Error {
    match error.into_kind() {
        welkin::ErrorKind::Invalid { value, allowed, .. } => UsageError::value(option, value, allowed).into(),
        other => other.into(),
    }
}
