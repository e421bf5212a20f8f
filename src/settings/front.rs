//! What every quality was measured to cost and to miss, and the choice by it.

use std::fmt;
use std::str::FromStr;
use std::time::Duration;

use glam::DVec3;

use super::quality::Quality;
use crate::error::{Error, Result};
use crate::frame::lut::MEDIUM_LABELS;
use crate::gpu::{Backend, DepthUse, Pass, Target, TextureDesc, TextureId, Uniform, reads};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::{Camera, DepthConvention, Pose, Scene};
use crate::render::picture::{PictureRenderer, PictureSettings};
use crate::render::sky::SkySettings;
use crate::shaders::Program;

/// `welkin accuracy --write-front src/quality/front.txt` writes it.
const COMMITTED: &str = include_str!("front.txt");

/// The media of [`Point::errors`], in order. `haze` is Earth with 400 times the aerosol.
pub const MEDIA: [&str; 3] = ["earth", "mars", "haze"];

/// All-orders errors whose ratio is below this are told apart by the sampling, not by luck.
const SAME: f64 = 1.05;

/// Rounds of timing of which the best counts; one more before them does not.
const ROUNDS: usize = 3;

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
    /// Whose.
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
    /// How the time was taken: [`crate::gpu::TimerKind`].
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

/// What a quality costs and misses, the worst of the backends of a [`Front`].
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
/// Errors are those of 32-bit floats on any device. Times are one device's: [`Self::committed`] holds those of
/// the device that it names, [`Self::measure`] takes yours. It is written ([`ToString`]) and read ([`FromStr`])
/// as text, so that a program may measure once and keep it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Front {
    /// One for each backend.
    pub measured: Vec<Measured>,
}

impl Front {
    /// The table in this crate: every preset on both backends.
    pub fn committed() -> Self {
        // A test holds it to be readable.
        COMMITTED.parse().unwrap_or_default()
    }

    /// Times some qualities on a backend, in frames of `size` pixels: the mean over three Earth scenes
    /// (ground, limb, whole planet), each the best of three rounds, with a full-screen copy in the same
    /// submissions. The errors are [`Self::committed`]'s, which do not depend on the device.
    ///
    /// This waits for the GPU: seconds on a software driver. Scenes alternate, so that nothing of the frame
    /// before can be used again.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for no qualities, for one whose numbers are not among the committed, and for a size
    /// that the backend does not have, before anything is created; [`crate::ErrorKind::Unavailable`] where waiting or
    /// timing is impossible (browsers); errors of the backend.
    pub fn measure(backend: &mut dyn Backend, qualities: &[Quality], size: [u32; 2]) -> Result<Self> {
        let committed = Self::committed();
        let committed = committed.on(backend.info().backend).unwrap_or(committed);
        let errors = |quality: &Quality| committed.errors(quality);
        Self::measure_with(backend, qualities, size, &errors, &committed.source())
    }

    /// As [`Self::measure`], with errors from elsewhere; `errors_from` says from where.
    pub fn measure_with(
        backend: &mut dyn Backend,
        qualities: &[Quality],
        size: [u32; 2],
        errors: &dyn Fn(&Quality) -> Result<[MeanError; 3]>,
        errors_from: &str,
    ) -> Result<Self> {
        if qualities.is_empty() {
            return Err(Error::invalid("qualities", "none", "at least one"));
        }
        let mut points = Vec::with_capacity(qualities.len());
        for quality in qualities {
            SkySettings::from(*quality).validate()?;
            points.push(Point { quality: *quality, time: Duration::ZERO, errors: errors(quality)? });
        }
        let copy_to = TextureDesc::new("front", size[0], size[1], PictureSettings::default().radiance);
        copy_to.validate(backend.info().max_texture_size)?;
        let scenes = scenes(f64::from(size[0]) / f64::from(size[1]))?;
        let copy_to = backend.create_texture(&copy_to)?;
        let mut renderer = PictureRenderer::default();
        let timed = time(backend, &mut renderer, &scenes, &mut points, size, copy_to);
        renderer.destroy(backend);
        backend.destroy_texture(copy_to);
        let copy = timed?;
        let info = backend.info();
        let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        Ok(Self {
            measured: vec![Measured {
                backend: info.backend.to_owned(),
                adapter: line(&info.adapter),
                driver: line(&info.driver),
                timer: info.timer.to_string(),
                size,
                errors_from: line(errors_from),
                copy,
                points,
            }],
        })
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

    /// What a quality costs and misses, if its numbers were measured; the worst where there are several backends.
    pub fn cost(&self, quality: &Quality) -> Option<Cost> {
        let mut worst: Option<Cost> = None;
        for m in &self.measured {
            let Some(p) = m.points.iter().find(|p| p.quality.same_numbers(quality)) else { continue };
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

    /// The cheapest quality whose mean relative error of radiance in the worst channel, against **all orders of
    /// scattering** and over the Earth scenes of the report, is at most `error` (0.1 is 10 %).
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so exact, or `error` is not a number: it says which comes closest.
    pub fn within_error(&self, error: f64) -> Result<Quality> {
        let all = self.all("within_error", error)?;
        let fits = all.iter().filter(|(_, c)| error.is_finite() && c.error <= error);
        let cheapest = fits.min_by(|(_, a), (_, b)| a.time.cmp(&b.time).then(a.error.total_cmp(&b.error)));
        cheapest.map(|(q, _)| *q).ok_or_else(|| {
            let best = all.iter().min_by(|(_, a), (_, b)| a.error.total_cmp(&b.error));
            let allowed = best.map_or_else(String::new, |(q, c)| {
                // Rounded up: what is said here must be accepted.
                let least = (c.error * 1e3).ceil() / 1e3;
                format!("a number, {least} or more: quality {q} has that, the least mean error against all orders")
            });
            Error::invalid("within_error", error, allowed)
        })
    }

    /// The best quality that takes at most `budget` for the sky's passes of a frame, on the device and at the
    /// size of this front (on every backend of it; [`Self::on`] picks one).
    ///
    /// Best is what has the least error against all orders. Where that differs by less than a twentieth among
    /// methods that compute single scattering alone, what they all lack hides the rest: their sampling decides.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] if none is so fast: it says which is the fastest.
    pub fn within_budget(&self, budget: Duration) -> Result<Quality> {
        let all = self.all("within_budget", milliseconds(budget))?;
        let fits: Vec<_> = all.iter().filter(|(_, c)| c.time <= budget).collect();
        let least = fits.iter().map(|(_, c)| c.error).fold(f64::INFINITY, f64::min);
        let close: Vec<_> = fits.iter().filter(|(_, c)| c.error <= SAME * least).collect();
        let judge = |c: &Cost| {
            let sampling = close.iter().all(|(_, c)| c.sampling.is_some());
            if sampling { c.sampling.unwrap_or(c.error) } else { c.error }
        };
        let best = close.iter().min_by(|(_, a), (_, b)| judge(a).total_cmp(&judge(b)).then(a.time.cmp(&b.time)));
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
        let on_all = |q: &Quality| self.measured.iter().all(|m| m.points.iter().any(|p| p.quality.same_numbers(q)));
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

    fn errors(&self, quality: &Quality) -> Result<[MeanError; 3]> {
        let mut points = self.measured.iter().flat_map(|m| &m.points);
        points.find(|p| p.quality.same_numbers(quality)).map(|p| p.errors).ok_or_else(|| {
            let known: Vec<_> = self.measured.iter().take(1).flat_map(|m| &m.points).map(|p| p.quality).collect();
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

    fn source(&self) -> String {
        self.measured.first().map_or_else(String::new, |m| m.errors_from.clone())
    }
}

/// A camera above Earth: altitude in metres, then degrees: of the sun from the zenith, pitch, field of view.
const SCENES: [[f64; 4]; 3] = [[2.0, 60.0, 20.0, 60.0], [400e3, 70.0, -19.0, 10.0], [1e7, 60.0, -90.0, 50.0]];

fn scenes(aspect: f64) -> Result<Vec<Scene>> {
    let scene = |[altitude, sun, pitch, fov]: [f64; 4]| {
        let atmosphere = AtmosphereParams::earth();
        let (pitch, fov_y) = (pitch.to_radians(), fov.to_radians());
        let pose = Pose { altitude, pitch, heading: 0.0, fov_y };
        let (sin, cos) = sun.to_radians().sin_cos();
        Ok(Scene {
            camera: Camera::above(DVec3::ZERO, atmosphere.planet_radius, DVec3::Z, DVec3::X, pose, aspect)?,
            planet_center: DVec3::ZERO,
            atmosphere,
            sun_direction: DVec3::new(sin, 0.0, cos),
            depth: DepthConvention::default(),
            moon: None,
        })
    };
    SCENES.into_iter().map(scene).collect()
}

/// Fills in the times of `points`; answers the best of the copy.
fn time(
    backend: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scenes: &[Scene],
    points: &mut [Point],
    size: [u32; 2],
    copy_to: TextureId,
) -> Result<Duration> {
    let program = backend.create_program(Program::Copy)?;
    let mut best = vec![f64::INFINITY; points.len() * scenes.len()];
    let mut best_copy = f64::INFINITY;
    // Round after round, so that a disturbance of a moment does not hit every run of a quality.
    for round in 0..=ROUNDS {
        let each = points.iter().flat_map(|p| scenes.iter().map(move |s| (p.quality, s)));
        for ((quality, scene), best) in each.zip(&mut best) {
            let settings = PictureSettings { sky: quality.into(), terrain: None, ..PictureSettings::default() };
            let (passes, drawn) = renderer.passes(backend, scene, &settings, size)?;
            let mut passes: Vec<Pass> = passes.iter().copied().filter(|p| p.target.color != drawn.display).collect();
            passes.push(Pass {
                label: "copy",
                program: Some(program),
                textures: reads([drawn.radiance]),
                uniform: Uniform::NONE,
                target: Target::color(copy_to),
                depth: DepthUse::Always,
            });
            let times = backend.times(&passes)?;
            // The first round makes pipelines and warms caches.
            if let Some((copy, sky)) = times.split_last().filter(|_| round > 0) {
                let of_frame = sky.iter().filter(|t| !MEDIUM_LABELS.contains(&t.label));
                *best = best.min(of_frame.map(|t| t.nanoseconds).sum());
                best_copy = best_copy.min(copy.nanoseconds);
            }
        }
    }
    let duration = |nanoseconds: f64| Duration::from_nanos(nanoseconds.max(0.0) as u64);
    for (point, best) in points.iter_mut().zip(best.chunks(scenes.len())) {
        point.time = duration(best.iter().sum::<f64>() / best.len() as f64);
    }
    Ok(duration(best_copy))
}

fn milliseconds(time: Duration) -> String {
    let text = format!("{:.3}", time.as_secs_f64() * 1e3);
    format!("{} ms", text.trim_end_matches('0').trim_end_matches('.'))
}

const HEAD: &str = "\
# What every quality costs and misses, as measured: one part for each backend.
# Written by `welkin accuracy --write-front FILE`; change nothing by hand.
# ms: the sky's passes of a frame of `size`, tables of altitude and sun made anew, mean over three Earth scenes; copy_ms: a full-screen copy beside them.
# Errors: mean relative error of radiance in the worst channel over the report's scenes of a medium,
# against all orders of scattering, and against single scattering for methods that compute only that.
";
const COLUMNS: &str = "quality, method, render_scale, ms, \
                       earth_all, earth_single, mars_all, mars_single, haze_all, haze_single";

impl fmt::Display for Front {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(HEAD)?;
        for m in &self.measured {
            let ms = |time: Duration| format!("{:.4}", time.as_secs_f64() * 1e3);
            writeln!(f, "\n[{}]", m.backend)?;
            writeln!(f, "adapter = {}\ndriver = {}\ntimer = {}", m.adapter, m.driver, m.timer)?;
            writeln!(f, "size = {}x{}", m.size[0], m.size[1])?;
            writeln!(f, "errors_from = {}\ncopy_ms = {}\n{COLUMNS}", m.errors_from, ms(m.copy))?;
            for p in &m.points {
                let Quality { name, method, render_scale } = p.quality;
                write!(f, "{name}, {method}, {render_scale}, {}", ms(p.time))?;
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

impl FromStr for Front {
    type Err = Error;

    /// Reads what [`Front`]'s `to_string` wrote. Only presets can be read back.
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
                front.measured.push(Measured { backend, adapter, driver, timer, size, errors_from, copy, points });
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
                        m.size = size.ok_or_else(|| Error::invalid(field(key), value, "pixels, as in 1920x1080"))?;
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
        let numbers = [quality.method.to_string(), quality.render_scale.to_string()];
        for (i, is) in [1, 2].into_iter().zip(&numbers) {
            if values[i] != is {
                let allowed = format!("{is}, as quality {} is now: measure again", quality.name);
                return Err(Error::invalid(field(names[i]), values[i], allowed));
            }
        }
        let mut errors = [MeanError { all_orders: 0.0, single: None }; 3];
        for (medium, error) in errors.iter_mut().enumerate() {
            let [all, single] = [4 + 2 * medium, 5 + 2 * medium];
            error.all_orders = share(field(names[all]), values[all])?;
            if values[single] != "-" {
                error.single = Some(share(field(names[single]), values[single])?);
            }
        }
        Ok(Self { quality, time: time_of(field(names[3]), values[3])?, errors })
    }
}

fn share(field: String, text: &str) -> Result<f64> {
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
    use crate::render::sky::Method;

    #[test]
    fn the_committed_front_is_as_written_and_holds_every_preset_on_both_backends() {
        let front: Front = COMMITTED.parse().unwrap();
        assert_eq!(front.to_string(), COMMITTED, "changed by hand, or not written by this version");
        assert_eq!(front.measured.iter().map(|m| m.backend.as_str()).collect::<Vec<_>>(), ["webgpu", "webgl2"]);
        for m in &front.measured {
            let held: Vec<_> = m.points.iter().map(|p| p.quality).collect();
            assert_eq!(held, Quality::ALL, "run welkin accuracy --write-front src/quality/front.txt");
            assert!(!m.copy.is_zero() && m.points.iter().all(|p| p.time > m.copy), "{m:?}");
            for text in [&m.adapter, &m.driver, &m.timer, &m.errors_from] {
                assert!(!text.is_empty(), "{m:?}");
            }
        }
    }

    /// Times in milliseconds and errors on Earth, of as many presets.
    fn front(of: &[(u64, f64, Option<f64>)]) -> Front {
        let mut front = Front::committed().on("webgpu").unwrap();
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
        let mut other = front(&[(50, 0.5, Some(0.02)), (15, 0.3, Some(0.01)), (45, 0.34, Some(0.03))]).measured;
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
        let empty = Front::default();
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
        let row = "single-low, single 8 × 8, 1, 1.0, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1";
        assert_eq!(format!("[webgpu]\n{row}").parse::<Front>().unwrap().measured[0].points.len(), 1);
        for (text, words) in [
            (row.to_owned(), ["line 1", "[backend]"]),
            ("[webgpu]\nsize = 12".into(), ["line 2, size = 12", "1920x1080"]),
            ("[webgpu]\ncopy_ms = -1".into(), ["copy_ms = -1", "milliseconds"]),
            ("[webgpu]\ncolour = red".into(), ["key = colour", "adapter"]),
            ("[webgpu]\nlow, 3".into(), ["2 values", "10: quality"]),
            (format!("[webgpu]\n{}", row.replace("single-low", "lowest")), ["quality = \"lowest\"", "low, medium"]),
            (format!("[webgpu]\n{}", row.replace("8 × 8", "9 × 8")), ["method = single 9 × 8", "measure again"]),
            (format!("[webgpu]\n{}", row.replacen("0.3", "NaN", 1)), ["earth_all = NaN", "0 or more"]),
            (format!("[webgpu]\n{}", row.replace("1.0,", "soon,")), ["ms = soon", "milliseconds"]),
        ] {
            let message = text.parse::<Front>().unwrap_err().to_string();
            assert!(words.iter().all(|w| message.contains(w)), "{text}: {message}");
        }
    }

    #[test]
    fn a_method_that_is_not_of_single_scattering_has_no_error_against_it() {
        let mut f = front(&[(1, 0.1, None)]);
        let text = f.to_string();
        assert!(text.contains("0.10000, -, 0.10000, -"), "{text}");
        assert_eq!(text.parse::<Front>().as_ref(), Ok(&f));
        f.measured[0].points[0].quality.method = Method::Single { view_samples: 9, light_samples: 9 };
        assert!(f.to_string().parse::<Front>().is_err());
    }
}
