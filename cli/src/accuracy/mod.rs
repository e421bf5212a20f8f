//! `welkin accuracy`: what every method, quality and backend costs in time, and how exact it is.

mod measure;
mod plot;
mod report;
mod scenes;

use std::io::Write;
use std::time::Instant;

use anyhow::Context;
use welkin::gpu::{Backend, Format, TextureDesc, TextureId};
use welkin::reference::multiple::Settings;
use welkin::settings::quality::{Front, MeanError};
use welkin::{Method, PictureRenderer, Quality, SkySettings};

use crate::args::{AccuracyArgs, UsageError};
use crate::cache::Cache;
use crate::draw::{BackendChoice, Drawer};
use crate::info;
use crate::output::Destination;
use crate::progress::Progress;
use measure::{Against, Errors, Summary, Times, Truth};
use scenes::{Frame, MEDIA, SETUPS, Setup};

const VIEW_SAMPLES: [u32; 5] = [4, 8, 16, 32, 64];
const LIGHT_SAMPLES: [u32; 3] = [4, 8, 16];

/// Which scenes an [`Entry`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// One, by its name.
    Scene(&'static str),
    /// All of a medium, by its index.
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
    pub method: Method,
    pub render_scale: f64,
    /// Whether the report shows it scene by scene: the finest preset of its method.
    pub by_scene: bool,
}

impl Candidate {
    /// The grid of single scattering, then the presets that are not in it.
    fn all() -> Vec<Self> {
        let grid = VIEW_SAMPLES
            .into_iter()
            .flat_map(|view_samples| LIGHT_SAMPLES.map(|light_samples| Method::Single { view_samples, light_samples }));
        let bare = |method| Self { preset: None, method, render_scale: 1.0, by_scene: false };
        let mut all: Vec<_> = grid.map(bare).collect();
        for q in Quality::ALL {
            let new = Self { render_scale: q.render_scale, ..bare(q.method) };
            let at = all.iter().position(|c| (c.method, c.render_scale) == (q.method, q.render_scale));
            let at = at.unwrap_or_else(|| {
                all.push(new);
                all.len() - 1
            });
            let finest = Quality::ALL.iter().rfind(|other| other.method.name() == q.method.name());
            (all[at].preset, all[at].by_scene) = (Some(q.name), finest == Some(q));
        }
        all
    }

    fn settings(&self) -> SkySettings {
        SkySettings { method: self.method, render_scale: self.render_scale, ..SkySettings::default() }
    }

    /// The method's numbers, and the preset's name where it has one.
    pub fn numbers(&self) -> String {
        let mut text = self.method.numbers();
        if self.render_scale != 1.0 {
            text += &format!(", scale {}", self.render_scale);
        }
        if let Some(name) = self.preset {
            text += &format!(" ({name})");
        }
        text
    }

    /// Whether an error against this says something about the method.
    pub fn judged_by(&self, against: Against) -> bool {
        against == Against::AllOrders || self.method.is_single_scattering()
    }
}

/// One method and its numbers on one backend, over some scenes.
pub struct Entry {
    pub backend: String,
    pub candidate: Candidate,
    pub over: Over,
    /// By [`Against::BOTH`].
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
    /// Frames that are timed.
    pub timed: Frame,
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
    pub fn backends(&self) -> Vec<&str> {
        let mut names: Vec<_> = self.entries.iter().map(|e| e.backend.as_str()).collect();
        names.dedup();
        names
    }

    /// The methods' names in order.
    pub fn methods(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        for e in &self.entries {
            let name = e.candidate.method.name();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// What was measured of a backend over all scenes of a medium, as far as an error against this means something.
    pub fn judged(&self, backend: &str, medium: usize, against: Against) -> impl Iterator<Item = &Entry> {
        self.totals(medium).filter(move |e| e.backend == backend && e.candidate.judged_by(against))
    }

    /// The settings of all methods that nothing cheaper is as exact as, the cheapest first.
    pub fn front(&self, backend: &str, medium: usize, against: Against) -> Vec<&Entry> {
        let all = self.judged(backend, medium, against).collect();
        front(all, |e| (e.ratio(), e.mean(against)))
    }
}

/// What of `all` is not beaten in one of two costs by something that is no worse in the other; by the first cost.
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

/// Measures and writes `accuracy.md`, `accuracy.csv` and `accuracy.svg`.
pub fn run(args: &AccuracyArgs) -> anyhow::Result<()> {
    let out = args.out.display();
    std::fs::create_dir_all(&args.out).map_err(|e| {
        UsageError::value("--out <FOLDER>", &out, format_args!("a folder that exists or can be made: {e}"))
    })?;
    let file = |name: &str| Destination::new(&args.out.join(name), "--out <FOLDER>");
    let (markdown, table, picture) = (file("accuracy.md")?, file("accuracy.csv")?, file("accuracy.svg")?);
    let front_file = args.write_front.as_deref().map(|path| Destination::new(path, "--write-front <FILE>"));
    let front_file = front_file.transpose()?;
    let mut cache = Cache::new(&args.cache);
    let found = investigate(args.quick, front_file.is_some().then_some(args.front_size), &mut cache);
    cache.tell();
    let (findings, front) = found?;
    let svg = plot::svg(&findings)?;
    let text = report::markdown(&findings)?;
    markdown.write(|f| Ok(f.write_all(text.as_bytes())?))?;
    table.write(|f| report::csv(&findings, f))?;
    picture.write(|f| Ok(f.write_all(svg.as_bytes())?))?;
    if let Some(file) = front_file {
        file.write(|f| Ok(f.write_all(front.to_string().as_bytes())?))?;
    }
    let mut stdout = std::io::stdout().lock();
    write!(stdout, "{}", report::short(&findings)?)?;
    writeln!(
        stdout,
        "{out}: accuracy.md, accuracy.csv, accuracy.svg, in {:.1} s{}",
        findings.seconds,
        cache.summary()
    )?;
    Ok(())
}

/// All findings; and if a size is given, the front of every preset, timed at it.
fn investigate(quick: bool, front_size: Option<[u32; 2]>, cache: &mut Cache) -> anyhow::Result<(Findings, Front)> {
    let start = Instant::now();
    let (frame, runs, tables) =
        if quick { (Frame::QUICK, 2, Settings::QUICK) } else { (Frame::WHOLE, 2, Settings::FINE) };
    // Errors need few pixels. Times need as many as people draw, or the tables would weigh too much in them.
    let timed = Frame { size: if quick { [320, 180] } else { [480, 270] }, ..frame };
    let scenes: Vec<_> = SETUPS.into_iter().filter(|s| s.quick || !quick).collect();
    let mut missing = Vec::new();
    let mut drawers = Vec::new();
    for choice in [BackendChoice::WebGpu, BackendChoice::WebGl2] {
        match Drawer::open(choice) {
            Ok(drawer) => drawers.push((info::name(choice), drawer)),
            Err(e) => missing.push(format!("{}: {e:#}", info::name(choice))),
        }
    }
    let candidates = Candidate::all();
    let per_backend = candidates.len() + usize::from(front_size.is_some());
    let progress = Progress::of("measuring", MEDIA.len() + 1 + drawers.len() * per_backend);
    let mut orders = Vec::new();
    for (i, name) in MEDIA.into_iter().enumerate() {
        let tell = progress.step(&format!("reference, all orders: {name}"));
        let medium = scenes::medium(i)?;
        let tables = tables.for_medium(&medium);
        let solved = cache.solve(&medium, tables, |p| {
            tell((p.change.max(1e-300).ln() / tables.tolerance.ln()) as f32);
        });
        let solved = solved.with_context(|| format!("solve {name}"))?;
        if !solved.converged() {
            missing.push(format!("{name}: the all-orders reference did not converge, errors against it are uncertain"));
        }
        orders.push(solved);
    }
    let tell = progress.step("reference, pictures");
    let mut truths = Vec::new();
    for (i, setup) in scenes.iter().enumerate() {
        let scene = setup.scene(frame.aspect())?;
        let truth = Truth::new(&scene, &frame, &orders[setup.medium])?;
        truths.push(Judged { setup: *setup, scene, truth });
        tell((i + 1) as f32 / scenes.len() as f32);
    }
    let (mut adapters, mut entries, mut front) = (Vec::new(), Vec::new(), Front::default());
    for (name, drawer) in &mut drawers {
        adapters.push(drawer.describe());
        let Some(backend) = drawer.backend() else { continue };
        let mut renderers = Renderers::default();
        let [width, height] = timed.size;
        let copy_to = backend.create_texture(&TextureDesc::new("copy", width, height, Format::Rgba32Float))?;
        let first = entries.len();
        for candidate in &candidates {
            let tell = progress.step(&format!("{name}, {}", candidate.method));
            let measured =
                by_scene(name, backend, &mut renderers, &truths, [&frame, &timed], candidate, runs, copy_to, &tell);
            // A setting that fails is told, the others are still worth having.
            match measured {
                Ok(found) => entries.extend(found),
                Err(e) => missing.push(format!("{name}, {}: {e:#}", candidate.method)),
            }
        }
        if let Some(size) = front_size {
            let _ = progress.step(&format!("{name}, presets at {}×{}", size[0], size[1]));
            let timed = front_of(name, backend, &entries, size, quick);
            front.measured.extend(timed.with_context(|| format!("{name}: the front"))?.measured);
        }
        backend.destroy_texture(copy_to);
        renderers.destroy(backend);
        let of_backend: &mut [Entry] = &mut entries[first..];
        let copy = of_backend.iter().map(|e| e.times.copy).fold(f64::INFINITY, f64::min);
        of_backend.iter_mut().for_each(|e| e.times.copy = copy);
    }
    anyhow::ensure!(!entries.is_empty(), "nothing could be measured: {}", missing.join("; "));
    let seconds = start.elapsed().as_secs_f64();
    Ok((Findings { quick, frame, timed, scenes, runs, adapters, entries, missing, seconds }, front))
}

/// The presets with the errors that were found, timed anew at a size that people draw at.
fn front_of(
    name: &str,
    backend: &mut dyn Backend,
    entries: &[Entry],
    size: [u32; 2],
    quick: bool,
) -> welkin::Result<Front> {
    let errors = |q: &Quality| {
        let of = |medium| {
            let mut found = entries.iter().filter(|e| e.backend == name && e.over == Over::Medium(medium));
            let found = found.find(|e| e.candidate.preset == Some(q.name)).ok_or_else(|| {
                welkin::Error::invalid("quality", q, "one that could be measured; accuracy.md says why it was not")
            })?;
            let single = q.method.is_single_scattering().then(|| found.mean(Against::Single));
            Ok(MeanError { all_orders: found.mean(Against::AllOrders), single })
        };
        Ok([of(0)?, of(1)?, of(2)?])
    };
    let today = jiff::Timestamp::now().strftime("%Y-%m-%d").to_string();
    let scenes = if quick { "quick scenes (welkin accuracy --quick)" } else { "all scenes (welkin accuracy)" };
    let from = format!("{today}, welkin {}, {scenes}", env!("CARGO_PKG_VERSION"));
    Front::measure_with(backend, Quality::ALL, size, &errors, &from)
}

/// One for each medium, so that what is made once for it is made once.
#[derive(Default)]
struct Renderers {
    judged: [PictureRenderer; MEDIA.len()],
    timed: [PictureRenderer; MEDIA.len()],
}

impl Renderers {
    fn destroy(&mut self, backend: &mut dyn Backend) {
        self.judged.iter_mut().chain(&mut self.timed).for_each(|r| r.destroy(backend));
    }
}

/// A scene and the truth about it.
struct Judged {
    setup: Setup,
    scene: welkin::Scene,
    truth: Truth,
}

/// One entry for each medium, then one for each scene.
#[allow(clippy::too_many_arguments)]
fn by_scene(
    name: &str,
    backend: &mut dyn Backend,
    renderers: &mut Renderers,
    judged: &[Judged],
    [frame, timed]: [&Frame; 2],
    candidate: &Candidate,
    runs: u32,
    copy_to: TextureId,
    tell: &dyn Fn(f32),
) -> anyhow::Result<Vec<Entry>> {
    let sky = candidate.settings();
    let mut errors = Vec::new();
    for j in judged {
        let drawn = measure::draw(backend, &mut renderers.judged[j.setup.medium], &j.scene, frame, sky)
            .with_context(|| j.setup.name)?;
        errors.push(Against::BOTH.map(|against| j.truth.errors(&drawn, against)));
    }
    let mut times = vec![Times::NEVER; judged.len()];
    // Round after round, so that a disturbance of a moment does not hit every run of a scene.
    for run in 0..=runs {
        for (j, best) in judged.iter().zip(&mut times) {
            let took = measure::time(backend, &mut renderers.timed[j.setup.medium], &j.scene, timed, sky, copy_to);
            let took = took.with_context(|| j.setup.name)?;
            // The first round makes pipelines and wakes the machine up; only what is made once counts in it.
            *best = best.best(if run == 0 { Times { once: took.once, ..Times::NEVER } } else { took });
        }
        tell((run + 1) as f32 / (runs + 1) as f32);
    }
    let entry = |over, errors: &[Errors; 2], times| Entry {
        backend: name.to_owned(),
        candidate: *candidate,
        over,
        errors: [errors[0].summary(), errors[1].summary()],
        times,
    };
    let mut entries = Vec::new();
    for medium in 0..MEDIA.len() {
        let mut all = [Errors::default(), Errors::default()];
        let members: Vec<_> = (0..judged.len()).filter(|&i| judged[i].setup.medium == medium).collect();
        for &i in &members {
            all.iter_mut().zip(&errors[i]).for_each(|(all, e)| all.extend(e));
        }
        let sky = members.iter().map(|&i| times[i].sky).sum::<f64>() / members.len() as f64;
        let copy = members.iter().map(|&i| times[i].copy).fold(f64::INFINITY, f64::min);
        let once = members.iter().map(|&i| times[i].once).fold(0.0, f64::max);
        entries.push(entry(Over::Medium(medium), &all, Times { sky, copy, once }));
    }
    for ((j, errors), times) in judged.iter().zip(&errors).zip(times) {
        entries.push(entry(Over::Scene(j.setup.name), errors, times));
    }
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::{Against, Candidate, Quality, front};

    #[test]
    fn the_grid_and_every_preset_are_measured_once() {
        let all = Candidate::all();
        for (i, c) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|d| (d.method, d.render_scale) != (c.method, c.render_scale)), "{c:?}");
            assert!(c.judged_by(Against::AllOrders));
        }
        for q in Quality::ALL {
            let found: Vec<_> = all.iter().filter(|c| c.preset == Some(q.name)).collect();
            assert_eq!(found.len(), 1, "{q}");
            assert_eq!((found[0].method, found[0].render_scale), (q.method, q.render_scale));
            let shown = all.iter().filter(|c| c.by_scene && c.method.name() == q.method.name());
            assert_eq!(shown.count(), 1, "{q}");
        }
        assert_eq!(all[1].numbers(), "4 × 8");
        assert_eq!(all[4].numbers(), "8 × 8 (single-low)");
    }

    #[test]
    fn the_front_holds_what_is_not_beaten() {
        let all = vec![(3.0, 1.0), (1.0, 5.0), (2.0, 6.0), (2.0, 5.0), (4.0, 1.0), (2.5, 3.0)];
        assert_eq!(front(all, |e| e), [(1.0, 5.0), (2.5, 3.0), (3.0, 1.0)]);
        assert_eq!(front(Vec::<(f64, f64)>::new(), |e| e), []);
    }
}
