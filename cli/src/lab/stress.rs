//! `welkin-lab stress`: the shaders' functions on a million cases, against f64.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, bail};
use clap::Args;
use welkin::gpu::Backend;
use welkin::probe::{self, BATCH, Cases, Probe, Record};

use crate::args::backend::BackendArgs;
use crate::gpu::Gpu;
use crate::progress::Progress;

const STRESS_ABOUT: &str = "\
Run the shaders' functions on a million cases, against f64

Each case is a planet, its air, a camera, a ray and a sun: first a fixed grid of what breaks atmosphere \
code, then random ones over everything that the library accepts. The shaders' own functions run on each \
of them, one pixel a case, and every number that comes back must be finite, possible (no negative light, \
transmittance from 0 to 1) and right: geometry within 1e-5 or 1 m (in proportion on planets smaller than \
the Earth), everything else within 0.1 % or 1e-6 of the case's brightest value.";

const STRESS_DETAILS: &str = "\
The table, a line for each quantity:
  tried       numbers that were compared
  non-finite  NaN or infinite ones
  steep       numbers that depend on digits of the inputs that 32-bit floats do not have, such as the length
              of a ray that touches the planet; they must be right for some inputs within 2^-22 of the case's
  worst       largest error of all others, over the true value (or over what counts as small beside it); a
              little above the promise where the last digits of the inputs explain the rest
  promise     what that may be
  used        largest part of what is allowed that any number used, the last digits of its inputs counted in
  by case     which one that was
  broken      wrong by more, not finite or impossible

For the first case that breaks a promise, each quantity shows its number, its inputs, what came back and what
f64 makes of it; then the plainest case that breaks it too. A case is the same on every machine, by its
number and the seed.

Examples:
  welkin-lab stress
      A million cases on the backend that draws by default
  welkin-lab stress --cases 20000000 --seed 7 --backend webgl2
      More of them, other random ones, the other backend
  welkin-lab stress --case 123456
      That case alone: its inputs, and every number that comes back
  welkin-lab stress --frames 1000
      A thousand small pictures of random scenes, and the plainest one of which something is wrong
  welkin-lab stress --save here.tsv && welkin-lab stress --table here.tsv there.tsv
      Drivers side by side

Exit status: 0 every promise was kept; 1 one was broken, or a backend failed; 2 the request was not \
accepted.";

/// Options of `welkin-lab stress`.
#[derive(Args, Debug)]
#[command(long_about = STRESS_ABOUT, after_long_help = STRESS_DETAILS)]
#[command(after_help = "What the table says, and examples: welkin-lab stress --help")]
#[command(mut_arg("backend", |arg| {
    arg.help("What runs the shaders: auto, webgpu or webgl2").hide_possible_values(true)
}))]
pub struct StressArgs {
    /// How many cases, 1 to 10^10
    #[arg(long, value_name = "N", default_value = "1000000")]
    #[arg(value_parser = clap::value_parser!(u64).range(1..=10_000_000_000))]
    cases: u64,

    /// Which random cases follow the grid
    #[arg(long, value_name = "S", default_value = "1")]
    seed: u64,

    /// Only the case of this number
    #[arg(long, value_name = "NUMBER", conflicts_with = "cases")]
    case: Option<u64>,

    /// Instead of cases, draw so many whole pictures of random scenes: all light must be finite and possible
    #[arg(long, value_name = "N", conflicts_with = "cases")]
    frames: Option<u64>,

    #[command(flatten)]
    backend: BackendArgs,

    /// Also write the table's numbers to a file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["case", "frames"])]
    save: Option<PathBuf>,

    /// Instead of trying anything, print what such files hold side by side, as Markdown
    #[arg(
        long, value_name = "FILE", num_args = 1..,
        conflicts_with_all = ["cases", "case", "frames", "save"]
    )]
    table: Vec<PathBuf>,
}

/// Runs the cases, compares them with f64, prints the table, and fails if a promise was broken.
pub fn run(args: &StressArgs) -> anyhow::Result<()> {
    let mut out = std::io::stdout().lock();
    if !args.table.is_empty() {
        let load = |path: &PathBuf| {
            let text = std::fs::read_to_string(path).with_context(|| format!("read {}", path.display()))?;
            Record::load(&text).with_context(|| path.display().to_string())
        };
        let records: Vec<_> = args.table.iter().map(load).collect::<Result<_, _>>()?;
        return Ok(write!(out, "{}", probe::side_by_side(&records))?);
    }
    let mut gpu = Gpu::open(args.backend.gpu("what is tried are shaders")?)?;
    let about = gpu.describe();
    let Some(backend) = gpu.backend() else { bail!("no GPU backend can be had here: {about}") };
    writeln!(out, "{about}")?;
    if let Some(count) = args.frames {
        let (first, count) = args.case.map_or((0, count), |number| (number, 1));
        return frames(&mut out, backend, args.seed, first, count);
    }
    let (first, count) = args.case.map_or((0, args.cases), |number| (number, 1));
    let begun = Instant::now();
    let mut record = Record::new(backend.info(), args.seed, count);
    {
        let batches = count.div_ceil(BATCH as u64);
        let steps = Progress::of("trying", batches as usize);
        let mut cases = Cases::at(args.seed, first);
        for batch in 0..batches {
            let size = (count - batch * BATCH as u64).min(BATCH as u64) as usize;
            let progress = steps.step(&format!("{} cases", count.min((batch + 1) * BATCH as u64)));
            let number = (first + batch * BATCH as u64) as usize;
            let list: Vec<_> = cases.by_ref().take(size).collect();
            for which in Probe::of_batch(number as u64 / BATCH as u64) {
                record.tally.add(probe::judge(which, number, &list, &probe::run(backend, which, &list)?));
            }
            progress(1.0);
        }
    }
    if args.case.is_some()
        && let Some(case) = Cases::at(args.seed, first).next()
    {
        writeln!(out, "\ncase {first}, seed {}\n{}", args.seed, indent(&probe::describe(&case)))?;
        numbers(&mut out, backend, first as usize, &case)?;
    } else {
        write!(out, "\n{record}")?;
    }
    let seconds = begun.elapsed().as_secs_f64();
    writeln!(out, "\n{count} cases, seed {}, in {seconds:.1} s", args.seed)?;
    if let Some(path) = &args.save {
        std::fs::write(path, record.save()).with_context(|| format!("write {}", path.display()))?;
    }
    for finding in &record.tally.findings {
        let plainest = probe::shrink(backend, finding)?;
        write!(out, "\n{}", finding.report(args.seed, &plainest))?;
    }
    match record.tally.broken() {
        0 => Ok(()),
        n => bail!("{n} promises were broken in {count} cases"),
    }
}

/// Whole pictures of random scenes.
fn frames(
    out: &mut impl Write,
    backend: &mut dyn Backend,
    seed: u64,
    first: u64,
    count: u64,
) -> anyhow::Result<()> {
    let (mut wrong, mut pixels) = (0, 0);
    for number in first..first + count {
        let frame = probe::frame(seed, number);
        pixels += u64::from(frame.size[0] * frame.size[1]);
        let Some(fault) = probe::look(backend, &frame)? else { continue };
        wrong += 1;
        if wrong == 1 {
            writeln!(out, "\nframe {number}, seed {seed}: {fault:?}")?;
            let plainest = probe::shrink_frame(backend, &frame)?;
            writeln!(out, "  plainest: {:?}\n{plainest:#?}", probe::look(backend, &plainest)?)?;
        } else {
            writeln!(out, "frame {number}, seed {seed}: {fault:?}")?;
        }
    }
    writeln!(out, "{count} frames of {pixels} pixels, seed {seed}: {wrong} with something wrong")?;
    if wrong == 0 { Ok(()) } else { bail!("{wrong} of {count} frames are not finite or not possible") }
}

/// Everything that the shaders answer to one case.
fn numbers(
    out: &mut impl Write,
    backend: &mut dyn Backend,
    number: usize,
    case: &probe::Case,
) -> anyhow::Result<()> {
    writeln!(out, "\n{}", probe::NUMBERS)?;
    for which in Probe::ALL {
        let answers = probe::run(backend, which, std::slice::from_ref(case))?;
        for finding in probe::explain(which, number, case, &answers) {
            writeln!(out, "{}", finding.line())?;
        }
    }
    Ok(())
}

fn indent(text: &str) -> String {
    text.lines().map(|l| format!("    {l}")).collect::<Vec<_>>().join("\n")
}
