//! What the accuracy report is made of.

use welkin::probe::scenes::{Frame, MEDIA, Setup};
use welkin::{Quality, SkySettings};

use crate::args::quality::march;
use crate::lab::accuracy::measure::{Against, Summary, Times};

const VIEW_SAMPLES: [u32; 5] = [4, 8, 16, 32, 64];
const LIGHT_SAMPLES: [u32; 3] = [4, 8, 16];

/// Which scenes an [`Entry`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// One scene, by its name.
    Scene(&'static str),
    /// All scenes of a medium, by its index.
    Medium(usize),
}

impl Over {
    pub fn name(self) -> &'static str {
        match self {
            Self::Scene(name) => name,
            Self::Medium(i) => MEDIA[i],
        }
    }
}

/// A method with its numbers, to be measured.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// The preset's name, if it is one.
    pub preset: Option<&'static str>,
    pub quality: Quality,
    /// Whether the report shows it scene by scene: the finest preset of its method.
    pub by_scene: bool,
}

impl Candidate {
    /// The grid of single scattering, then those of the presets that are not in it.
    pub fn all(presets: &[Quality]) -> Vec<Self> {
        let grid = VIEW_SAMPLES.into_iter().flat_map(|view| LIGHT_SAMPLES.map(|light| march([view, light])));
        let bare = |quality| Self { preset: None, quality, by_scene: false };
        let mut all: Vec<_> = grid.map(bare).collect();
        for quality in presets {
            let at = all.iter().position(|c| c.quality == *quality).unwrap_or_else(|| {
                all.push(bare(*quality));
                all.len() - 1
            });
            let finest = presets.iter().rfind(|other| other.method() == quality.method());
            (all[at].preset, all[at].by_scene) = (quality.preset_name(), finest == Some(quality));
        }
        all
    }

    /// The settings of a sky that is drawn so.
    pub fn settings(&self) -> SkySettings {
        self.quality.into()
    }

    /// The method's numbers, and the preset's name where it has one.
    pub fn numbers(&self) -> String {
        let mut text = self.quality.numbers();
        if let Some(name) = self.preset {
            text += &format!(" ({name})");
        }
        text
    }

    /// Whether an error against this says something about the method.
    pub fn is_compared_with(&self, against: Against) -> bool {
        against == Against::AllOrders || self.quality.is_single_scattering()
    }
}

/// One method and its numbers on one backend, over some scenes.
pub struct Entry {
    /// The backend's name on the command line.
    pub backend: &'static str,
    /// What was measured.
    pub candidate: Candidate,
    /// The scenes that it was measured over.
    pub over: Over,
    /// The errors against each of [`Against::BOTH`].
    pub errors: [Summary; 2],
    /// The sky's: the mean over the scenes. The copy's: the best that this backend did in the whole run.
    pub times: Times,
}

impl Entry {
    /// Time over that of a copy.
    pub fn ratio(&self) -> f64 {
        self.times.sky / self.times.copy
    }

    /// The worst channel's mean error.
    pub fn mean(&self, against: Against) -> f64 {
        self.errors[against as usize].worst(|s| s.mean)
    }
}

/// All that the report is made of.
pub struct Findings {
    pub quick: bool,
    pub frame: Frame,
    /// Pixels of the frames that are timed.
    pub timed: [u32; 2],
    pub scenes: Vec<Setup>,
    pub runs: u32,
    /// One line for each backend that was measured.
    pub adapters: Vec<String>,
    pub entries: Vec<Entry>,
    /// What could not be measured, and why.
    pub missing: Vec<String>,
    /// Seconds of the whole run.
    pub seconds: f64,
}

impl Findings {
    /// What was measured over all scenes of a medium.
    pub fn totals(&self, medium: usize) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(move |e| e.over == Over::Medium(medium))
    }

    /// The backends' names in order.
    pub fn backends(&self) -> Vec<&'static str> {
        let mut names: Vec<_> = self.entries.iter().map(|e| e.backend).collect();
        names.dedup();
        names
    }

    /// The methods' names in order.
    pub fn methods(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        for e in &self.entries {
            let name = e.candidate.quality.method();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// What was measured of a backend over all scenes of a medium, as far as an error against this means
    /// something.
    pub fn compared(&self, backend: &str, medium: usize, against: Against) -> impl Iterator<Item = &Entry> {
        self.totals(medium).filter(move |e| e.backend == backend && e.candidate.is_compared_with(against))
    }

    /// The settings of all methods that nothing cheaper is as exact as, the cheapest first.
    pub fn front(&self, backend: &str, medium: usize, against: Against) -> Vec<&Entry> {
        let all = self.compared(backend, medium, against).collect();
        front(all, |e| (e.ratio(), e.mean(against)))
    }
}

/// What of `all` is not beaten in one of two costs by something that is no worse in the other; by the first
/// cost.
fn front<T: Copy>(mut all: Vec<T>, cost: impl Fn(T) -> (f64, f64)) -> Vec<T> {
    all.sort_by(|a, b| cost(*a).partial_cmp(&cost(*b)).unwrap_or(std::cmp::Ordering::Equal));
    let mut best = f64::INFINITY;
    all.retain(|e| {
        let better = cost(*e).1 < best;
        best = best.min(cost(*e).1);
        better
    });
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_and_every_preset_are_measured_once() {
        let presets: Vec<_> = Quality::PRESETS.iter().map(|(_, quality)| *quality).collect();
        let all = Candidate::all(&presets);
        for (i, c) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|d| d.quality != c.quality), "{c:?}");
            assert!(c.is_compared_with(Against::AllOrders));
        }
        for (name, quality) in Quality::PRESETS {
            let found: Vec<_> = all.iter().filter(|c| c.preset == Some(*name)).collect();
            assert_eq!(found.len(), 1, "{quality}");
            assert_eq!(found[0].quality, *quality);
            let shown = all.iter().filter(|c| c.by_scene && c.quality.method() == quality.method());
            assert_eq!(shown.count(), 1, "{quality}");
        }
        assert_eq!(all[1].numbers(), "4 × 8");
        assert_eq!(all[4].numbers(), "8 × 8 (single-low)");
        // Without one, the next is the finest of its method.
        let some: Vec<_> = presets.into_iter().filter(|q| *q != Quality::HIGH).collect();
        let fewer = Candidate::all(&some);
        assert_eq!(fewer.len(), all.len() - 1);
        assert!(fewer.iter().all(|c| c.quality != Quality::HIGH));
        assert!(fewer.iter().any(|c| c.quality == Quality::MEDIUM && c.by_scene));
    }

    #[test]
    fn the_front_holds_what_is_not_beaten() {
        let all = vec![(3.0, 1.0), (1.0, 5.0), (2.0, 6.0), (2.0, 5.0), (4.0, 1.0), (2.5, 3.0)];
        assert_eq!(front(all, |e| e), [(1.0, 5.0), (2.5, 3.0), (3.0, 1.0)]);
        assert_eq!(front(Vec::<(f64, f64)>::new(), |e| e), []);
    }
}
