//! `welkin stress`: the shaders' functions on a million cases, against f64.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, bail};
use welkin::gpu::Backend;
use welkin::probe::{self, BATCH, Cases, Probe, Record};

use crate::args::{StressArgs, UsageError};
use crate::draw::{BackendChoice, Drawer};
use crate::progress::Progress;

/// Runs and judges the cases, prints the table, and fails if a promise was broken.
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
    if args.backend == BackendChoice::Cpu {
        return Err(
            UsageError::value("--backend <NAME>", "cpu", "webgpu, webgl2 or auto: what is tried are shaders").into()
        );
    }
    let mut drawer = Drawer::open(args.backend)?;
    let about = drawer.describe();
    let Some(backend) = drawer.backend() else { bail!("no GPU backend can be had here: {about}") };
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
        let progress = Progress::of("trying", batches as usize);
        let mut cases = Cases::at(args.seed, first);
        for batch in 0..batches {
            let size = (count - batch * BATCH as u64).min(BATCH as u64) as usize;
            let done = progress.step(&format!("{} cases", count.min((batch + 1) * BATCH as u64)));
            let number = (first + batch * BATCH as u64) as usize;
            let list: Vec<_> = cases.by_ref().take(size).collect();
            for which in Probe::of_batch(number as u64 / BATCH as u64) {
                record.tally.add(probe::judge(which, number, &list, &probe::run(backend, which, &list)?));
            }
            done(1.0);
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
fn frames(out: &mut impl Write, backend: &mut dyn Backend, seed: u64, first: u64, count: u64) -> anyhow::Result<()> {
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
fn numbers(out: &mut impl Write, backend: &mut dyn Backend, number: usize, case: &probe::Case) -> anyhow::Result<()> {
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
