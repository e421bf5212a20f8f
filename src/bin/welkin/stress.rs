//! `welkin stress`: the shaders' functions on a million cases, against f64.

use std::io::Write;
use std::time::Instant;

use anyhow::bail;
use welkin::MiePhase;
use welkin::backend::Backend;
use welkin::probe::{self, BATCH, Cases, Finding, Probe, Tally};

use crate::args::{StressArgs, UsageError};
use crate::draw::{BackendChoice, Drawer};
use crate::progress::Progress;

/// Runs and judges the cases, prints the table, and fails if a promise was broken.
pub fn run(args: &StressArgs) -> anyhow::Result<()> {
    if args.backend == BackendChoice::Cpu {
        return Err(
            UsageError::value("--backend <NAME>", "cpu", "webgpu, webgl2 or auto: what is tried are shaders").into()
        );
    }
    let mut drawer = Drawer::open(args.backend)?;
    let about = drawer.describe();
    let Some(backend) = drawer.backend() else { bail!("no GPU backend can be had here: {about}") };
    let mut out = std::io::stdout().lock();
    writeln!(out, "{about}")?;
    if let Some(count) = args.frames {
        let (first, count) = args.case.map_or((0, count), |number| (number, 1));
        return frames(&mut out, backend, args.seed, first, count);
    }
    let (first, count) = args.case.map_or((0, args.cases), |number| (number, 1));
    let begun = Instant::now();
    let mut tally = Tally::default();
    {
        let batches = count.div_ceil(BATCH as u64) as usize;
        let progress = Progress::of("trying", batches);
        let mut cases = Cases::at(args.seed, first);
        for batch in 0..batches {
            let size = (count - (batch * BATCH) as u64).min(BATCH as u64) as usize;
            let done = progress.step(&format!("{} cases", count.min(((batch + 1) * BATCH) as u64)));
            let number = first as usize + batch * BATCH;
            let list: Vec<_> = cases.by_ref().take(size).collect();
            tally.add(one_batch(backend, number, &list)?);
            done(1.0);
        }
    }
    if args.case.is_some()
        && let Some(case) = Cases::at(args.seed, first).next()
    {
        writeln!(out, "\ncase {first}, seed {}\n{}", args.seed, indent(&probe::describe(&case)))?;
        numbers(&mut out, backend, first as usize, &case)?;
    } else {
        table(&mut out, &tally)?;
    }
    let seconds = begun.elapsed().as_secs_f64();
    writeln!(out, "\n{count} cases, seed {}, in {seconds:.1} s", args.seed)?;
    for finding in &tally.findings {
        let plainest = probe::shrink(backend, finding)?;
        report(&mut out, args.seed, finding, &plainest)?;
    }
    match tally.broken() {
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

/// All probes on one draw's cases; the two phase functions' scattering in turn.
fn one_batch(backend: &mut dyn Backend, number: usize, cases: &[probe::Case]) -> anyhow::Result<Tally> {
    let phase = if (number / BATCH).is_multiple_of(2) { MiePhase::HenyeyGreenstein } else { MiePhase::CornetteShanks };
    let mut tally = Tally::default();
    for which in [Probe::Geometry, Probe::Medium, Probe::Path, Probe::Tables, Probe::Scatter(phase)] {
        let answers = probe::run(backend, which, cases)?;
        tally.add(probe::judge(which, number, cases, &answers));
    }
    Ok(tally)
}

/// Everything that the shaders answer to one case.
fn numbers(out: &mut impl Write, backend: &mut dyn Backend, number: usize, case: &probe::Case) -> anyhow::Result<()> {
    writeln!(
        out,
        "\n{:<33} {:>15} {:>17}  {:>15} {:>15} {:>9}",
        "quantity", "shader", "f64", "neighbours from", "to", "allowed"
    )?;
    for which in Probe::ALL {
        let answers = probe::run(backend, which, std::slice::from_ref(case))?;
        for f in probe::explain(which, number, case, &answers) {
            let (name, [low, high]) = (f.quantity.name(), f.range);
            writeln!(
                out,
                "{name:<33} {:>15.8e} {:>17.10e}  {low:>15.8e} {high:>15.8e} {:>9.1e}",
                f.got, f.expected, f.allowed
            )?;
        }
    }
    Ok(())
}

fn table(out: &mut impl Write, tally: &Tally) -> std::io::Result<()> {
    writeln!(
        out,
        "\n{:<33} {:>10} {:>10} {:>10} {:>9} {:>8} {:>5} {:>9} {:>8}",
        "quantity", "tried", "non-finite", "steep", "worst", "promise", "used", "by case", "broken"
    )?;
    for (quantity, row) in &tally.rows {
        writeln!(
            out,
            "{:<33} {:>10} {:>10} {:>10} {:>9.1e} {:>8.0e} {:>4.0}% {:>9} {:>8}",
            quantity.name(),
            row.tried,
            row.not_finite,
            row.steep,
            row.worst,
            row.promise,
            100.0 * row.used.0,
            row.used.1,
            row.broken
        )?;
    }
    Ok(())
}

fn report(out: &mut impl Write, seed: u64, finding: &Finding, plainest: &Finding) -> std::io::Result<()> {
    writeln!(out, "\nbroken: {} (case {}, seed {seed})", finding.quantity.name(), finding.index)?;
    for (title, f) in [("as found", finding), ("plainest", plainest)] {
        let unit = f.quantity.unit();
        writeln!(out, "  {title}: got {:e} {unit}, expected {:e} {unit}", f.got, f.expected)?;
        let [low, high] = f.range;
        writeln!(out, "  ({low:e} to {high:e} for inputs that f32 cannot tell apart; ± {:e})", f.allowed)?;
        writeln!(out, "{}", indent(&probe::describe(&f.case)))?;
        if finding.case == plainest.case {
            break;
        }
    }
    Ok(())
}

fn indent(text: &str) -> String {
    text.lines().map(|l| format!("    {l}")).collect::<Vec<_>>().join("\n")
}
