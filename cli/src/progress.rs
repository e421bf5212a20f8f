//! How far the work is, on stderr: a bar in a terminal, plain lines elsewhere.

use std::cell::Cell;
use std::io::{IsTerminal, Write};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Positions of the bar per step.
const FINE: u64 = 1000;

/// Progress through a known number of steps.
pub struct Progress {
    bar: Option<ProgressBar>,
    verb: &'static str,
    steps: u64,
    begun: Cell<u64>,
}

impl Progress {
    /// Progress through `steps` pictures.
    pub fn new(steps: usize) -> Self {
        Self::of("drawing", steps)
    }

    /// Progress through `steps`; `verb` says what is being done.
    pub fn of(verb: &'static str, steps: usize) -> Self {
        let steps = steps as u64;
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::with_draw_target(Some(steps * FINE), ProgressDrawTarget::stderr());
            if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent:>3}% {msg}  {elapsed}") {
                bar.set_style(style);
            }
            bar
        });
        Self { bar, verb, steps, begun: Cell::new(0) }
    }

    /// Begins the next step; the function that is returned hears the fraction of it that is done, 0 to 1.
    pub fn step(&self, what: &str) -> impl Fn(f32) + use<'_> {
        let before = self.begun.get();
        self.begun.set(before + 1);
        match &self.bar {
            Some(bar) => {
                bar.set_position(before * FINE);
                bar.set_message(what.to_owned());
            }
            None => {
                let _ = writeln!(std::io::stderr(), "{} {}/{}: {what}", self.verb, before + 1, self.steps);
            }
        }
        move |fraction| {
            if let Some(bar) = &self.bar {
                bar.set_position(before * FINE + (fraction.clamp(0.0, 1.0) * FINE as f32) as u64);
            }
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
