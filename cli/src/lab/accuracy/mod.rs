//! `welkin-lab accuracy`: what every method, quality and backend costs in time, and how exact it is.

mod findings;
mod measure;
mod plot;
mod report;

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::Context;
use clap::Args;
use welkin::gpu::{Backend, Format, TextureDesc, TextureId};
use welkin::probe::scenes::{self, Frame, MEDIA, SETUPS, Setup};
use welkin::reference::multiple::Settings;
use welkin::settings::front::{MeanError, ParetoFront};
use welkin::{PictureRenderer, Quality};

use crate::args::backend::BackendChoice;
use crate::args::cache::CacheArgs;
use crate::args::output::OutputArgs;
use crate::args::quality::parse_quality;
use crate::args::usage::UsageError;
use crate::args::values;
use crate::cache::Cache;
use crate::gpu::Gpu;
use crate::lab::timing;
use crate::output::Destination;
use crate::progress::Progress;
use crate::quality_choice::presets;
use findings::{Candidate, Entry, Findings, Over};
use measure::{Against, Errors, Expected, Times};

/// The option `--output` as errors name it.
const OPTION: &str = "--output <FOLDER>";

const ACCURACY_ABOUT: &str = "\
Measure what accuracy costs in time, on every backend

Draws a fixed set of scenes (sun from the zenith to 12° below the horizon, camera from 2 m to 10,000 km, \
Earth, Mars and a thick haze) at many qualities on every backend that this machine has, and compares \
them with the f64 reference. Writes accuracy.md (tables), accuracy.csv (every number) and accuracy.svg \
(error against time).";

/// Options of `welkin-lab accuracy`.
#[derive(Args, Debug)]
#[command(long_about = ACCURACY_ABOUT)]
#[command(mut_arg("output", |arg| {
    arg.help("Where to write; made if it is not there [default: accuracy]").value_name("FOLDER")
}))]
pub struct AccuracyArgs {
    /// Fewer scenes, smaller pictures, a coarser reference: a few minutes without a GPU
    #[arg(long)]
    quick: bool,

    #[command(flatten)]
    output: OutputArgs,

    /// Pixels of the frames that are timed; at small ones LUTs weigh more than they do where people draw
    /// [default: 480x270, with --quick 320x180]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = values::size)]
    timed_size: Option<[u32; 2]>,

    /// Also write error and time of every preset, as the library keeps them in src/settings/front.txt
    #[arg(long, value_name = "FILE")]
    write_front: Option<PathBuf>,

    /// Pixels of the frames that the presets' times in that file are of [default: 1920x1080]
    #[arg(
        long,
        value_name = "WxH",
        requires = "write_front",
        default_value = "1920x1080",
        hide_default_value = true
    )]
    #[arg(value_parser = values::size)]
    front_size: [u32; 2],

    /// Leave a preset out, of the report and of that file; may be given several times
    #[arg(long, value_name = "NAME", value_parser = parse_quality())]
    without: Vec<Quality>,

    #[command(flatten)]
    cache: CacheArgs,
}

/// Measures and writes `accuracy.md`, `accuracy.csv` and `accuracy.svg`.
pub fn run(args: &AccuracyArgs) -> anyhow::Result<()> {
    let folder = args.output.path_or("accuracy");
    let shown = folder.display();
    std::fs::create_dir_all(folder).map_err(|e| {
        UsageError::value(OPTION, &shown, format_args!("a folder that exists or can be made: {e}"))
    })?;
    let file = |name: &str| Destination::new(&folder.join(name), OPTION);
    let (markdown, table, picture) = (file("accuracy.md")?, file("accuracy.csv")?, file("accuracy.svg")?);
    let front_file = args.write_front.as_deref().map(|path| Destination::new(path, "--write-front <FILE>"));
    let front_file = front_file.transpose()?;
    let mut cache = Cache::new(&args.cache);
    // Times need as many pixels as people draw, or the LUTs would weigh too much in them.
    let timed = args.timed_size.unwrap_or(if args.quick { [320, 180] } else { [480, 270] });
    let presets: Vec<_> = presets().into_iter().filter(|q| !args.without.contains(q)).collect();
    let front_size = front_file.is_some().then_some(args.front_size);
    let found = investigate(args.quick, &presets, timed, front_size, &mut cache);
    cache.print_notes();
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
        "{shown}: accuracy.md, accuracy.csv, accuracy.svg, in {:.1} s{}",
        findings.seconds,
        cache.summary()
    )?;
    Ok(())
}

/// All findings; and if a size is given, the front of the presets, timed at it.
fn investigate(
    quick: bool,
    presets: &[Quality],
    timed: [u32; 2],
    front_size: Option<[u32; 2]>,
    cache: &mut Cache,
) -> anyhow::Result<(Findings, ParetoFront)> {
    let start = Instant::now();
    let (frame, runs, settings) =
        if quick { (Frame::QUICK, 1, Settings::QUICK) } else { (Frame::WHOLE, 2, Settings::FINE) };
    let scenes: Vec<_> = SETUPS.into_iter().filter(|s| s.quick || !quick).collect();
    let mut missing = Vec::new();
    let mut gpus = Vec::new();
    for choice in [BackendChoice::WebGpu, BackendChoice::WebGl2] {
        match Gpu::open(choice) {
            Ok(gpu) => gpus.push((choice.name(), gpu)),
            Err(e) => missing.push(format!("{}: {e:#}", choice.name())),
        }
    }
    let candidates = Candidate::all(presets);
    let per_backend = candidates.len() + usize::from(front_size.is_some());
    let steps = Progress::of("measuring", MEDIA.len() + 1 + gpus.len() * per_backend);
    let mut orders = Vec::new();
    for (i, name) in MEDIA.into_iter().enumerate() {
        let progress = steps.step(&format!("reference, all orders: {name}"));
        let medium = scenes::medium(i)?;
        let solved = cache.solve(&medium, settings.for_medium(&medium), &progress);
        let solved = solved.with_context(|| format!("solve {name}"))?;
        if !solved.converged() {
            missing.push(format!(
                "{name}: the all-orders reference did not converge, errors against it are uncertain"
            ));
        }
        orders.push(solved);
    }
    let progress = steps.step("reference, pictures");
    let mut compared = Vec::new();
    for (i, setup) in scenes.iter().enumerate() {
        let (whole, scene) = (setup.scene(frame.aspect())?, setup.compared(&frame)?);
        let expected = Expected::new(&scene, frame.counts(), &orders[setup.medium])?;
        compared.push(Compared { setup: *setup, whole, scene, expected });
        progress((i + 1) as f32 / scenes.len() as f32);
    }
    let (mut adapters, mut entries, mut front) = (Vec::new(), Vec::new(), ParetoFront::default());
    for (name, gpu) in &mut gpus {
        adapters.push(gpu.describe());
        let Some(backend) = gpu.backend() else { continue };
        let mut renderers = Renderers::default();
        let [width, height] = timed;
        let copy_to =
            backend.create_texture(&TextureDesc::new(timing::COPY, width, height, Format::Rgba32Float))?;
        let first = entries.len();
        for candidate in &candidates {
            let progress = steps.step(&format!("{name}, {}", candidate.quality));
            let measured = by_scene(
                name,
                backend,
                &mut renderers,
                &compared,
                [frame.counts(), timed],
                candidate,
                runs,
                copy_to,
                &progress,
            );
            // A setting that fails is told, the others are still worth having.
            match measured {
                Ok(found) => entries.extend(found),
                Err(e) => missing.push(format!("{name}, {}: {e:#}", candidate.quality)),
            }
        }
        if let Some(size) = front_size {
            let _ = steps.step(&format!("{name}, presets at {}×{}", size[0], size[1]));
            let timed = front_of(name, backend, &entries, presets, size, quick);
            front.measured.extend(timed.with_context(|| format!("{name}: the front"))?.measured);
        }
        backend.destroy_texture(copy_to);
        renderers.iter_mut().for_each(|r| r.destroy(backend));
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
    presets: &[Quality],
    size: [u32; 2],
    quick: bool,
) -> welkin::Result<ParetoFront> {
    let errors = |q: &Quality| {
        let of = |medium| {
            let mut found = entries.iter().filter(|e| e.backend == name && e.over == Over::Medium(medium));
            let found = found.find(|e| e.candidate.preset == q.preset_name()).ok_or_else(|| {
                welkin::Error::invalid(
                    "quality",
                    q,
                    "one that could be measured; accuracy.md says why it was not",
                )
            })?;
            let single = q.is_single_scattering().then(|| found.mean(Against::Single));
            Ok(MeanError { all_orders: found.mean(Against::AllOrders), single })
        };
        Ok([of(0)?, of(1)?, of(2)?])
    };
    let today = jiff::Timestamp::now().strftime("%Y-%m-%d").to_string();
    let scenes =
        if quick { "quick scenes (welkin-lab accuracy --quick)" } else { "all scenes (welkin-lab accuracy)" };
    let from = format!("{today}, welkin {}, {scenes}", env!("CARGO_PKG_VERSION"));
    ParetoFront::measure_with(backend, presets, size, &errors, &from)
}

/// One for each medium, so that what is made once for it is made once.
type Renderers = [PictureRenderer; MEDIA.len()];

/// A scene and what the reference makes of it.
struct Compared {
    setup: Setup,
    /// As people see it: what is timed.
    whole: welkin::Scene,
    /// The compared pixels alone.
    scene: welkin::Scene,
    expected: Expected,
}

/// One entry for each medium, then one for each scene.
#[allow(clippy::too_many_arguments)]
fn by_scene(
    name: &'static str,
    backend: &mut dyn Backend,
    renderers: &mut Renderers,
    compared: &[Compared],
    [counts, timed]: [[u32; 2]; 2],
    candidate: &Candidate,
    runs: u32,
    copy_to: TextureId,
    progress: &dyn Fn(f32),
) -> anyhow::Result<Vec<Entry>> {
    let sky = candidate.settings();
    let mut times = vec![Times::NEVER; compared.len()];
    // Round after round, so that a disturbance of a moment does not hit every run of a scene.
    for run in 0..=runs {
        for (c, best) in compared.iter().zip(&mut times) {
            let took = measure::time(backend, &mut renderers[c.setup.medium], &c.whole, timed, sky, copy_to);
            let took = took.with_context(|| c.setup.name)?;
            // The first round makes pipelines and wakes the machine up; only what is made once counts in it.
            *best = best.best(if run == 0 { Times { once: took.once, ..Times::NEVER } } else { took });
        }
        progress((run + 1) as f32 / (runs + 1) as f32);
    }
    // Last: what is made once for a medium is timed where it is made.
    let mut errors = Vec::new();
    for c in compared {
        let drawn = measure::draw(backend, &mut renderers[c.setup.medium], &c.scene, counts, sky)
            .with_context(|| c.setup.name)?;
        errors.push(Against::BOTH.map(|against| c.expected.errors(&drawn, against)));
    }
    let entry = |over, errors: &[Errors; 2], times| Entry {
        backend: name,
        candidate: *candidate,
        over,
        errors: [errors[0].summary(), errors[1].summary()],
        times,
    };
    let mut entries = Vec::new();
    for medium in 0..MEDIA.len() {
        let mut all = [Errors::default(), Errors::default()];
        let members: Vec<_> = (0..compared.len()).filter(|&i| compared[i].setup.medium == medium).collect();
        for &i in &members {
            all.iter_mut().zip(&errors[i]).for_each(|(all, e)| all.extend(e));
        }
        let sky = members.iter().map(|&i| times[i].sky).sum::<f64>() / members.len() as f64;
        let copy = members.iter().map(|&i| times[i].copy).fold(f64::INFINITY, f64::min);
        let once = members.iter().map(|&i| times[i].once).fold(0.0, f64::max);
        entries.push(entry(Over::Medium(medium), &all, Times { sky, copy, once }));
    }
    for ((c, errors), times) in compared.iter().zip(&errors).zip(times) {
        entries.push(entry(Over::Scene(c.setup.name), errors, times));
    }
    Ok(entries)
}
