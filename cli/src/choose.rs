//! Which quality `welkin render` draws with, and why.

use std::time::Duration;

use anyhow::bail;
use welkin::settings::quality::{Cost, Front};
use welkin::{Method, Mode, Quality, SkySettings};

use crate::args::UsageError;
use crate::draw::Drawer;

/// How a quality was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wish {
    /// What the mode stands for.
    Default,
    /// By the numbers of single scattering.
    Samples { view: u32, light: u32 },
    /// By name.
    Named(Quality),
    /// The cheapest with at most this mean error against all orders of scattering.
    WithinError(f64),
    /// The best that takes at most this time a frame, here.
    WithinBudget(Duration),
}

/// What is drawn with.
#[derive(Clone, Debug)]
pub struct Choice {
    pub sky: SkySettings,
    /// For the foot of the contact sheet.
    pub name: String,
    /// Where the choice was left to measurements: what was chosen by which.
    pub why: Option<String>,
}

impl Choice {
    /// Grants a wish for pictures of a size; only a budget makes the drawer work.
    pub fn of(wish: Wish, mode: Mode, drawer: &mut Drawer, size: [u32; 2]) -> anyhow::Result<Self> {
        let (quality, why) = match wish {
            Wish::Samples { view: view_samples, light: light_samples } => {
                let method = Method::Single { view_samples, light_samples };
                let sky = SkySettings { method, ..SkySettings::default() };
                return Ok(Self { sky, name: method.to_string(), why: None });
            }
            Wish::Default => {
                let sky = mode.settings();
                return Ok(Self { sky, name: format!("mode {}, {}", mode.name(), sky.method), why: None });
            }
            Wish::Named(quality) => (quality, None),
            Wish::WithinError(error) => {
                let quality = Quality::within_error(error).map_err(|e| refuse("--within-error <ERROR>", e))?;
                (quality, Some(by_error(&quality, error)))
            }
            Wish::WithinBudget(budget) => {
                let Some(backend) = drawer.backend() else {
                    let who = drawer.describe();
                    return Err(UsageError::value(
                        "--within-budget <TIME>",
                        words(budget),
                        format_args!("for a GPU backend, whose passes can be timed; here draws {who}"),
                    )
                    .into());
                };
                let front = Front::measure(backend, Quality::ALL, size)?;
                let quality = front.within_budget(budget).map_err(|e| refuse("--within-budget <TIME>", e))?;
                let Some(cost) = front.cost(&quality) else { bail!("quality {quality} was not measured") };
                (quality, Some(by_budget(&quality, budget, &cost, size)))
            }
        };
        Ok(Self { sky: quality.into(), name: format!("quality {quality}"), why })
    }
}

fn by_error(quality: &Quality, asked: f64) -> String {
    let front = Front::committed();
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
