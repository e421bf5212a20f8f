//! What every quality was measured to cost and to miss, and the choice by it.

use std::fmt;
use std::str::FromStr;
use std::time::Duration;

use super::quality::Quality;
use crate::error::{Error, Result};

/// `welkin-lab accuracy --write-front src/settings/front.txt` writes it.
const COMMITTED: &str = include_str!("front.txt");

/// The media of [`Point::errors`], in order. `haze` is Earth with 400 times the aerosol.
pub const MEDIA: [&str; 3] = ["earth", "mars", "haze"];

/// All-orders errors whose ratio is below this are told apart by the sampling, not by luck.
const SAME: f64 = 1.05;

/// A mean relative error of radiance, in the worst channel, over the scenes of a medium.
///
/// Relative to the f64 reference's radiance, or to a thousandth of the picture's brightest value where
/// that is more. 0.01 is 1 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanError {
    /// Against all orders of scattering: everything that is missing or wrong.
    pub all_orders: f64,
    /// Against single scattering, for methods that compute only that: what the sampling does.
    pub single: Option<f64>,
}

/// One quality on one backend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The quality that was measured.
    pub quality: Quality,
    /// Of the sky's passes of a frame: background and air before the scene.
    pub time: Duration,
    /// By [`MEDIA`].
    pub errors: [MeanError; 3],
}

/// What was measured on one backend.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// `webgpu` or `webgl2`.
    pub backend: String,
    /// The adapter that the times were taken on.
    pub adapter: String,
    /// Its driver.
    pub driver: String,
    /// How the time was taken: the timer of the backend.
    pub timer: String,
    /// Of the frames that were timed, pixels.
    pub size: [u32; 2],
    /// Where the errors come from: date, version and scenes.
    pub errors_from: String,
    /// A full-screen copy of the same target, timed in the same submissions.
    pub copy: Duration,
    /// One for each quality.
    pub points: Vec<Point>,
}

/// What a quality costs and misses, the worst of the backends of a [`ParetoFront`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// On Earth, against all orders of scattering: [`MeanError::all_orders`].
    pub error: f64,
    /// On Earth, against single scattering: [`MeanError::single`].
    pub sampling: Option<f64>,
    /// [`Point::time`].
    pub time: Duration,
    /// Time over that of a full-screen copy.
    pub copies: f64,
}

/// Error and time of some qualities, measured; answers which of them to take.
///
/// Errors are those of 32-bit floats on any device. Times are one device's: [`Self::committed`] holds those
/// of the device that it names, [`Self::measure`] takes yours. It is written ([`ToString`]) and read
/// ([`FromStr`]) as text, so that a program may measure once and keep it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ParetoFront {
    /// One for each backend.
    pub measured: Vec<Measured>,
}

impl ParetoFront {
    /// The table in this crate: every preset on both backends.
    pub fn committed() -> Self {
        // A test holds it to be readable.
        COMMITTED.parse().unwrap_or_default()
    }

    /// What was measured on one backend alone.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the backends that there are.
    pub fn on(&self, backend: &str) -> Result<Self> {
        let measured: Vec<_> = self.measured.iter().filter(|m| m.backend == backend).cloned().collect();
        if measured.is_empty() {
            let names: Vec<_> = self.measured.iter().map(|m| m.backend.as_str()).collect();
            let names = if names.is_empty() { "measured first".to_owned() } else { names.join(" or ") };
            return Err(Error::invalid("backend", format_args!("{backend:?}"), names));
        }
        Ok(Self { measured })
    }

    /// What a quality costs and misses, if its numbers were measured; the worst where there are several
    /// backends.
    pub fn cost(&self, quality: &Quality) -> Option<Cost> {
        let mut worst: Option<Cost> = None;
        for m in &self.measured {
            let Some(p) = m.points.iter().find(|p| p.quality == *quality) else { continue };
            let MeanError { all_orders: error, single: sampling } = p.errors[0];
            let copies = p.time.as_secs_f64() / m.copy.as_secs_f64().max(1e-9);
            let one = Cost { error, sampling, time: p.time, copies };
            worst = Some(worst.map_or(one, |w| Cost {
                error: w.error.max(one.error),
                sampling: w.sampling.zip(one.sampling).map(|(a, b)| a.max(b)),
                time: w.time.max(one.time),
                copies: w.copies.max(one.copies),
            }));
        }
        worst
    }

    /// The cheapest quality whose mean relative error of radiance in the worst channel, against **all orders
    /// of scattering** and over the Earth scenes of the report, is at most `error` (0.1 is 10 %).
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so exact, or `error` is not a number: it says which comes
    /// closest.
    pub fn within_error(&self, error: f64) -> Result<Quality> {
        let all = self.all("within_error", error)?;
        let fits = all.iter().filter(|(_, c)| error.is_finite() && c.error <= error);
        let cheapest = fits.min_by(|(_, a), (_, b)| a.time.cmp(&b.time).then(a.error.total_cmp(&b.error)));
        cheapest.map(|(q, _)| *q).ok_or_else(|| {
            let best = all.iter().min_by(|(_, a), (_, b)| a.error.total_cmp(&b.error));
            let allowed = best.map_or_else(String::new, |(q, c)| {
                // Rounded up: what is said here must be accepted.
                let least = (c.error * 1e3).ceil() / 1e3;
                format!(
                    "a number, {least} or more: quality {q} has that, the least mean error against all orders"
                )
            });
            Error::invalid("within_error", error, allowed)
        })
    }

    /// The best quality that takes at most `budget` for the sky's passes of a frame, on the device and at the
    /// size of this front (on every backend of it; [`Self::on`] picks one).
    ///
    /// Best is what has the least error against all orders. Where that differs by less than a twentieth among
    /// methods that compute single scattering alone, what they all lack hides the rest: their sampling
    /// decides.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so fast: it says which is the fastest.
    pub fn within_budget(&self, budget: Duration) -> Result<Quality> {
        let all = self.all("within_budget", milliseconds(budget))?;
        let fits: Vec<_> = all.iter().filter(|(_, c)| c.time <= budget).collect();
        let least = fits.iter().map(|(_, c)| c.error).fold(f64::INFINITY, f64::min);
        let close: Vec<_> = fits.iter().filter(|(_, c)| c.error <= SAME * least).collect();
        let compared = |c: &Cost| {
            let sampling = close.iter().all(|(_, c)| c.sampling.is_some());
            if sampling { c.sampling.unwrap_or(c.error) } else { c.error }
        };
        let best = close
            .iter()
            .min_by(|(_, a), (_, b)| compared(a).total_cmp(&compared(b)).then(a.time.cmp(&b.time)));
        best.map(|(q, _)| *q).ok_or_else(|| {
            let fastest = all.iter().min_by_key(|(_, c)| c.time);
            let (w, h) = self.measured.first().map_or((0, 0), |m| (m.size[0], m.size[1]));
            let mut adapters: Vec<_> = self.measured.iter().map(|m| m.adapter.as_str()).collect();
            adapters.dedup();
            let allowed = fastest.map_or_else(String::new, |(q, c)| {
                let least = Duration::from_micros((c.time.as_nanos().div_ceil(1000)) as u64);
                let least = milliseconds(least);
                format!("{least} or more: quality {q} takes that at {w}×{h} on {}", adapters.join(" and "))
            });
            Error::invalid("within_budget", milliseconds(budget), allowed)
        })
    }

    /// Every quality that was measured on all backends, with its cost.
    fn all(&self, field: &str, value: impl fmt::Display) -> Result<Vec<(Quality, Cost)>> {
        let first = self.measured.first().map_or(&[][..], |m| &m.points);
        let on_all = |q: &Quality| self.measured.iter().all(|m| m.points.iter().any(|p| p.quality == *q));
        let all: Vec<_> = first
            .iter()
            .filter(|p| on_all(&p.quality))
            .filter_map(|p| Some((p.quality, self.cost(&p.quality)?)))
            .collect();
        if all.is_empty() {
            return Err(Error::invalid(field, value, "asked of a front that holds a measured quality"));
        }
        Ok(all)
    }

    pub(crate) fn errors(&self, quality: &Quality) -> Result<[MeanError; 3]> {
        let mut points = self.measured.iter().flat_map(|m| &m.points);
        points.find(|p| p.quality == *quality).map(|p| p.errors).ok_or_else(|| {
            let known: Vec<_> =
                self.measured.iter().take(1).flat_map(|m| &m.points).map(|p| p.quality).collect();
            let known: Vec<_> = known.iter().map(Quality::to_string).collect();
            Error::invalid(
                "quality",
                quality,
                format_args!(
                    "one whose error was measured: {}",
                    if known.is_empty() { "none".into() } else { known.join(", ") }
                ),
            )
        })
    }

    pub(crate) fn source(&self) -> String {
        self.measured.first().map_or_else(String::new, |m| m.errors_from.clone())
    }
}

fn milliseconds(time: Duration) -> String {
    let text = format!("{:.3}", time.as_secs_f64() * 1e3);
    format!("{} ms", text.trim_end_matches('0').trim_end_matches('.'))
}

const HEAD: &str = "\
# What every quality costs and misses, as measured: one part for each backend.
# Written by `welkin-lab accuracy --write-front FILE`; change nothing by hand.
# ms: the sky's passes of a frame of `size`, LUTs of altitude and sun made anew, mean over three Earth scenes;
# copy_ms: a full-screen copy beside them.
# Errors: mean relative error of radiance in the worst channel over the report's scenes of a medium,
# against all orders of scattering, and against single scattering for methods that compute only that.
";
const COLUMNS: &str = "quality, method, ms, \
                       earth_all, earth_single, mars_all, mars_single, haze_all, haze_single";

impl fmt::Display for ParetoFront {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(HEAD)?;
        for m in &self.measured {
            let ms = |time: Duration| format!("{:.4}", time.as_secs_f64() * 1e3);
            writeln!(f, "\n[{}]", m.backend)?;
            writeln!(f, "adapter = {}\ndriver = {}\ntimer = {}", m.adapter, m.driver, m.timer)?;
            writeln!(f, "size = {}x{}", m.size[0], m.size[1])?;
            writeln!(f, "errors_from = {}\ncopy_ms = {}\n{COLUMNS}", m.errors_from, ms(m.copy))?;
            for p in &m.points {
                let name = p.quality.preset_name().unwrap_or("unnamed");
                write!(f, "{name}, {} {}, {}", p.quality.method(), p.quality.numbers(), ms(p.time))?;
                for e in p.errors {
                    let single = e.single.map_or_else(|| "-".to_owned(), |v| format!("{v:.5}"));
                    write!(f, ", {:.5}, {single}", e.all_orders)?;
                }
                writeln!(f)?;
            }
        }
        Ok(())
    }
}

impl FromStr for ParetoFront {
    type Err = Error;

    /// Reads what [`ParetoFront`]'s `to_string` wrote. Only presets can be read back.
    fn from_str(text: &str) -> Result<Self> {
        let mut front = Self::default();
        for (i, line) in text.lines().enumerate() {
            let line = line.trim();
            let field = |name: &str| format!("front, line {}, {name}", i + 1);
            if line.is_empty() || line.starts_with('#') || line == COLUMNS {
                continue;
            }
            if let Some(backend) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
                let (copy, size) = (Duration::ZERO, [0; 2]);
                let [adapter, driver, timer, errors_from] = std::array::from_fn(|_| String::new());
                let (backend, points) = (backend.to_owned(), Vec::new());
                front.measured.push(Measured {
                    backend,
                    adapter,
                    driver,
                    timer,
                    size,
                    errors_from,
                    copy,
                    points,
                });
                continue;
            }
            let Some(m) = front.measured.last_mut() else {
                return Err(Error::invalid(field("part"), line, "[backend] before anything else"));
            };
            if let Some((key, value)) = line.split_once(" = ") {
                match key {
                    "adapter" => m.adapter = value.to_owned(),
                    "driver" => m.driver = value.to_owned(),
                    "timer" => m.timer = value.to_owned(),
                    "errors_from" => m.errors_from = value.to_owned(),
                    "copy_ms" => m.copy = time_of(field(key), value)?,
                    "size" => {
                        let side = |s: &str| s.parse().ok().filter(|n| *n > 0);
                        let size = value.split_once('x').and_then(|(w, h)| Some([side(w)?, side(h)?]));
                        m.size =
                            size.ok_or_else(|| Error::invalid(field(key), value, "pixels, as in 1920x1080"))?;
                    }
                    _ => {
                        let known = "adapter, driver, timer, size, errors_from or copy_ms";
                        return Err(Error::invalid(field("key"), key, known));
                    }
                }
                continue;
            }
            m.points.push(Point::read(line, field)?);
        }
        Ok(front)
    }
}

impl Point {
    fn read(line: &str, field: impl Fn(&str) -> String) -> Result<Self> {
        let names: Vec<_> = COLUMNS.split(", ").collect();
        let values: Vec<_> = line.split(',').map(str::trim).collect();
        if values.len() != names.len() {
            let count = format!("{} values", values.len());
            return Err(Error::invalid(field("row"), count, format_args!("{}: {COLUMNS}", names.len())));
        }
        let quality = Quality::from_name(values[0])?;
        let is = format!("{} {}", quality.method(), quality.numbers());
        if values[1] != is {
            let allowed = format!("{is}, as quality {} is now: measure again", values[0]);
            return Err(Error::invalid(field(names[1]), values[1], allowed));
        }
        let mut errors = [MeanError { all_orders: 0.0, single: None }; 3];
        for (medium, error) in errors.iter_mut().enumerate() {
            let [all, single] = [3 + 2 * medium, 4 + 2 * medium];
            error.all_orders = error_of(field(names[all]), values[all])?;
            if values[single] != "-" {
                error.single = Some(error_of(field(names[single]), values[single])?);
            }
        }
        Ok(Self { quality, time: time_of(field(names[2]), values[2])?, errors })
    }
}

fn error_of(field: String, text: &str) -> Result<f64> {
    let value = text.parse().ok().filter(|v: &f64| v.is_finite() && *v >= 0.0);
    value.ok_or_else(|| Error::invalid(field, text, "a number of 0 or more"))
}

fn time_of(field: String, text: &str) -> Result<Duration> {
    let seconds = text.parse().ok().map(|v: f64| v * 1e-3);
    let time = seconds.and_then(|s| Duration::try_from_secs_f64(s).ok());
    time.ok_or_else(|| Error::invalid(field, text, "milliseconds, 0 or more"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_committed_front_is_as_written_and_holds_every_preset_on_both_backends() {
        let front: ParetoFront = COMMITTED.parse().unwrap();
        assert_eq!(front.to_string(), COMMITTED, "changed by hand, or not written by this version");
        assert_eq!(
            front.measured.iter().map(|m| m.backend.as_str()).collect::<Vec<_>>(),
            ["webgpu", "webgl2"]
        );
        for m in &front.measured {
            let held: Vec<_> = m.points.iter().map(|p| p.quality).collect();
            let presets: Vec<_> = Quality::PRESETS.iter().map(|(_, quality)| *quality).collect();
            assert_eq!(held, presets, "run welkin-lab accuracy --write-front src/settings/front.txt");
            assert!(!m.copy.is_zero() && m.points.iter().all(|p| p.time > m.copy), "{m:?}");
            for text in [&m.adapter, &m.driver, &m.timer, &m.errors_from] {
                assert!(!text.is_empty(), "{m:?}");
            }
        }
    }

    /// Times in milliseconds and errors on Earth, of as many presets.
    fn front(of: &[(u64, f64, Option<f64>)]) -> ParetoFront {
        let mut front = ParetoFront::committed().on("webgpu").unwrap();
        let point = |(q, &(ms, all_orders, single)): (&Quality, &(u64, f64, Option<f64>))| Point {
            quality: *q,
            time: Duration::from_millis(ms),
            errors: [MeanError { all_orders, single }; 3],
        };
        front.measured[0].points = SINGLES.iter().zip(of).map(point).collect();
        front.measured[0].size = [1920, 1080];
        front
    }

    const SINGLES: [Quality; 4] =
        [Quality::SINGLE_LOW, Quality::SINGLE_MEDIUM, Quality::SINGLE_HIGH, Quality::SINGLE_ULTRA];

    const SINGLE: [(u64, f64, Option<f64>); 4] =
        [(10, 0.335, Some(0.02)), (20, 0.338, Some(0.01)), (30, 0.341, Some(0.005)), (60, 0.34, Some(0.002))];

    #[test]
    fn the_cheapest_within_an_error_and_the_best_within_a_budget() {
        let f = front(&SINGLE);
        assert_eq!(f.within_error(0.4), Ok(Quality::SINGLE_LOW));
        assert_eq!(f.within_error(0.335), Ok(Quality::SINGLE_LOW));
        let ms = Duration::from_millis;
        // More samples, however small their gain beside what is missing from all of them.
        for (budget, want) in [(10, 0), (29, 1), (59, 2), (60, 3), (9999, 3)] {
            assert_eq!(f.within_budget(ms(budget)), Ok(SINGLES[want]), "{budget} ms");
        }
        // Time decides, not the order in the list; and errors that differ by more.
        let f = front(&[(40, 0.5, None), (20, 0.2, None), (10, 0.3, None), (80, 0.1, None)]);
        assert_eq!(f.within_error(0.3), Ok(Quality::SINGLE_HIGH));
        assert_eq!(f.within_error(0.2), Ok(Quality::SINGLE_MEDIUM));
        assert_eq!(f.within_error(0.9), Ok(Quality::SINGLE_HIGH));
        assert_eq!(f.within_budget(ms(19)), Ok(Quality::SINGLE_HIGH));
        assert_eq!(f.within_budget(ms(79)), Ok(Quality::SINGLE_MEDIUM));
        assert_eq!(f.within_budget(ms(80)), Ok(Quality::SINGLE_ULTRA));
    }

    #[test]
    fn the_slower_and_the_worse_backend_counts() {
        let mut f = front(&SINGLE);
        let mut other =
            front(&[(50, 0.5, Some(0.02)), (15, 0.3, Some(0.01)), (45, 0.34, Some(0.03))]).measured;
        other[0].backend = "webgl2".into();
        f.measured.append(&mut other);
        let cost = f.cost(&Quality::SINGLE_MEDIUM).unwrap();
        assert_eq!((cost.time, cost.error, cost.sampling), (Duration::from_millis(20), 0.338, Some(0.01)));
        assert_eq!(f.cost(&Quality::SINGLE_LOW).unwrap().error, 0.5);
        assert_eq!(f.within_error(0.4), Ok(Quality::SINGLE_MEDIUM));
        assert_eq!(f.on("webgpu").unwrap().within_error(0.4), Ok(Quality::SINGLE_LOW));
        // What only one of them was measured with is not chosen for both.
        assert_eq!(f.within_budget(Duration::from_secs(1)), Ok(Quality::SINGLE_MEDIUM));
        let message = f.on("metal").unwrap_err().to_string();
        assert_eq!(message, "backend = \"metal\" is not allowed: must be webgpu or webgl2");
    }

    #[test]
    fn the_impossible_is_refused_with_the_best_that_can_be_had() {
        let f = front(&SINGLE);
        for bad in [0.05, 0.3349, 0.0, -1.0, f64::NAN, f64::INFINITY] {
            let message = f.within_error(bad).unwrap_err().to_string();
            assert!(message.starts_with(&format!("within_error = {bad} ")), "{message}");
            assert!(message.contains("0.335 or more: quality single-low (single 8 × 8)"), "{message}");
        }
        let message = f.within_budget(Duration::from_micros(9_999)).unwrap_err().to_string();
        assert!(message.starts_with("within_budget = 9.999 ms "), "{message}");
        assert!(
            message.contains("10 ms or more: quality single-low (single 8 × 8) takes that at 1920×1080 on "),
            "{message}"
        );
        let empty = ParetoFront::default();
        for e in [empty.within_error(1.0), empty.within_budget(Duration::MAX)] {
            assert!(e.unwrap_err().to_string().contains("holds a measured quality"));
        }
        assert!(empty.on("webgpu").is_err() && empty.cost(&Quality::SINGLE_LOW).is_none());
        // The least that a message names is accepted.
        let f = front(&[(1, 0.123_456, None)]);
        assert!(f.within_error(0.05).unwrap_err().to_string().contains(" 0.124 or more"));
        assert_eq!(f.within_error(0.124), Ok(Quality::SINGLE_LOW));
    }

    #[test]
    fn text_that_is_not_a_front_is_refused_by_line_and_value() {
        let row = "single-low, single 8 × 8, 1.0, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1";
        assert_eq!(format!("[webgpu]\n{row}").parse::<ParetoFront>().unwrap().measured[0].points.len(), 1);
        for (text, words) in [
            (row.to_owned(), ["line 1", "[backend]"]),
            ("[webgpu]\nsize = 12".into(), ["line 2, size = 12", "1920x1080"]),
            ("[webgpu]\ncopy_ms = -1".into(), ["copy_ms = -1", "milliseconds"]),
            ("[webgpu]\ncolour = red".into(), ["key = colour", "adapter"]),
            ("[webgpu]\nlow, 3".into(), ["2 values", "9: quality"]),
            (
                format!("[webgpu]\n{}", row.replace("single-low", "lowest")),
                ["quality = \"lowest\"", "low, medium"],
            ),
            (
                format!("[webgpu]\n{}", row.replace("8 × 8", "9 × 8")),
                ["method = single 9 × 8", "measure again"],
            ),
            (format!("[webgpu]\n{}", row.replacen("0.3", "NaN", 1)), ["earth_all = NaN", "0 or more"]),
            (format!("[webgpu]\n{}", row.replace(" 1.0,", " soon,")), ["ms = soon", "milliseconds"]),
        ] {
            let message = text.parse::<ParetoFront>().unwrap_err().to_string();
            assert!(words.iter().all(|w| message.contains(w)), "{text}: {message}");
        }
    }

    #[test]
    fn a_method_that_is_not_of_single_scattering_has_no_error_against_it() {
        let mut f = front(&[(1, 0.1, None)]);
        let text = f.to_string();
        assert!(text.contains("0.10000, -, 0.10000, -"), "{text}");
        assert_eq!(text.parse::<ParetoFront>().as_ref(), Ok(&f));
        f.measured[0].points[0].quality = Quality::March { view_samples: 9, light_samples: 9 };
        assert!(f.to_string().parse::<ParetoFront>().is_err());
    }
}
