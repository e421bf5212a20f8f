//! The accuracy report as Markdown and CSV.

use std::fmt::Write;

use welkin::probe::scenes::MEDIA;

use crate::lab::accuracy::findings::{Entry, Findings, Over};
use crate::lab::accuracy::measure::{Against, FLOOR, Statistics};

fn percent(v: f64) -> String {
    // Three digits; large ones without decimals.
    let p = 100.0 * v;
    let digits = if p >= 99.95 { 0 } else { (1 - p.max(1e-3).log10().floor() as i32).clamp(0, 4) as usize };
    format!("{p:.digits$}")
}

fn three(s: [Statistics; 3], of: impl Fn(&Statistics) -> f64) -> String {
    s.iter().map(|s| percent(of(s))).collect::<Vec<_>>().join(" / ")
}

const HEAD: &str = "\
| method | settings | time | time / copy | mean, % (R / G / B) | 95th percentile, % | maximum, % | ΔE mean / \
95th / max |
|---|---|---|---|---|---|---|---|
";

fn row(text: &mut String, first: &[&str], e: &Entry, against: Against) -> std::fmt::Result {
    let s = &e.errors[against as usize];
    writeln!(
        text,
        "| {} | {:.2} ms | {:.1} | {} | {} | {} | {:.2} / {:.2} / {:.1} |",
        first.join(" | "),
        e.times.sky,
        e.ratio(),
        three(s.relative, |s| s.mean),
        three(s.relative, |s| s.p95),
        three(s.relative, |s| s.max),
        s.delta_e.mean,
        s.delta_e.p95,
        s.delta_e.max,
    )
}

fn front(findings: &Findings, backend: &str, medium: usize, against: Against) -> String {
    let front = findings.front(backend, medium, against);
    let points = front.iter().map(|e| {
        let c = &e.candidate;
        format!(
            "{} {}: {:.1} copies, {} %",
            c.quality.method(),
            c.numbers(),
            e.ratio(),
            percent(e.mean(against))
        )
    });
    points.collect::<Vec<_>>().join("; ")
}

fn title(against: Against) -> &'static str {
    match against {
        Against::AllOrders => "against all orders",
        Against::Single => "against single scattering (the sampling alone)",
    }
}

/// The fronts alone, for the terminal.
pub fn short(f: &Findings) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    for (backend, adapter) in f.backends().into_iter().zip(&f.adapters) {
        writeln!(text, "{adapter}")?;
        for (medium, name) in MEDIA.into_iter().enumerate() {
            for against in Against::BOTH {
                writeln!(text, "  {name}, {}: {}", title(against), front(f, backend, medium, against))?;
            }
        }
    }
    for what in &f.missing {
        writeln!(text, "not measured: {what}")?;
    }
    Ok(text)
}

/// The whole report.
pub fn markdown(f: &Findings) -> Result<String, std::fmt::Error> {
    let mut t = String::new();
    let ([w, h], [tw, th]) = (f.frame.size, f.timed);
    let command = if f.quick { "welkin-lab accuracy --quick" } else { "welkin-lab accuracy" };
    writeln!(t, "# Accuracy and time\n\nWritten by `{command}`, welkin {}.\n", env!("CARGO_PKG_VERSION"))?;
    writeln!(
        t,
        "{} scenes, in 32-bit floats. {} pixels of a picture of {w} × {h} are compared with the reference, \
         and drawn alone. An error is the difference from \
         the reference over the reference's radiance, or over {FLOOR} of the picture's brightest where \
         that is \
         more. ΔE is CIEDE2000 after ACES tone mapping, exposed so that the 95th percentile of the \
         all-orders \
         luminance comes out at 0.5. Time is that of the sky's passes in frames of {tw} × {th} pixels, \
         and beside it \
         that of a full-screen copy of the same target, timed in the same submissions: the best of {} for \
         each scene, \
         then the mean over the scenes; for the copy, the best of all. Every frame makes the LUTs of its \
         altitude \
         and sun anew; those of the medium are made once and stand apart (`once_ms` in accuracy.csv).\n\n\
         ![Error against time](accuracy.svg)\n",
        f.scenes.len(),
        f.frame.counts().iter().product::<u32>(),
        f.runs
    )?;
    for (backend, adapter) in f.backends().into_iter().zip(&f.adapters) {
        let copy = f
            .entries
            .iter()
            .filter(|e| e.backend == backend)
            .map(|e| e.times.copy)
            .fold(f64::INFINITY, f64::min);
        writeln!(t, "## {adapter}\n\nA copy takes {copy:.3} ms.\n")?;
        for (medium, name) in MEDIA.into_iter().enumerate() {
            for against in Against::BOTH {
                writeln!(t, "### {name}, {}\n", title(against))?;
                t += HEAD;
                f.compared(backend, medium, against).try_for_each(|e| {
                    row(&mut t, &[e.candidate.quality.method(), &e.candidate.numbers()], e, against)
                })?;
                let points = front(f, backend, medium, against);
                writeln!(t, "\nFront of all methods, by the worst channel's mean: {points}.\n")?;
            }
        }
        let one_by_one =
            |e: &&Entry| e.backend == backend && matches!(e.over, Over::Scene(_)) && e.candidate.by_scene;
        for method in f.methods() {
            let of_method =
                || f.entries.iter().filter(one_by_one).filter(|e| e.candidate.quality.method() == method);
            for against in Against::BOTH {
                let mut scenes = of_method().filter(|e| e.candidate.is_compared_with(against)).peekable();
                let Some(first) = scenes.peek() else { continue };
                writeln!(
                    t,
                    "### Scene by scene: {method} {}, {}\n",
                    first.candidate.numbers(),
                    title(against)
                )?;
                t += &HEAD.replace("method | settings", "scene").replacen("---|", "", 1);
                scenes.try_for_each(|e| row(&mut t, &[e.over.name()], e, against))?;
                writeln!(t)?;
            }
        }
    }
    writeln!(
        t,
        "## Scenes\n\nThe sun's azimuth is 0. No terrain; light from the ground itself is left out.\n"
    )?;
    writeln!(
        t,
        "| scene | medium | altitude, m | sun zenith | pitch | heading | field of view \
         |\n|---|---|---|---|---|---|---|"
    )?;
    for s in &f.scenes {
        let medium = MEDIA[s.medium];
        writeln!(
            t,
            "| {} | {medium} | {} | {}° | {}° | {}° | {}° |",
            s.name, s.altitude, s.sun_zenith, s.pitch, s.heading, s.fov
        )?;
    }
    writeln!(
        t,
        "\n`earth` and `mars` are the presets; `haze` is Earth with 400 times the aerosol and g = 0.7 \
         (vertical \
         optical depth 2.1).\n\n## Not measured\n"
    )?;
    for what in &f.missing {
        writeln!(t, "- {what}")?;
    }
    if f.adapters.iter().any(|a| a.contains("llvmpipe")) {
        writeln!(
            t,
            "- A GPU, on the backends that llvmpipe drew: it is a software renderer. Times and ratios are \
             this \
             processor's; errors are those of 32-bit floats anywhere."
        )?;
    }
    writeln!(t, "- Browsers: both backends ran natively.")?;
    if f.quick {
        writeln!(
            t,
            "- Anything finer than 1 % against all orders: `--quick` solves the reference on coarse grids. \
             It also leaves out scenes that `welkin-lab accuracy` has."
        )?;
    }
    Ok(t)
}

/// One line for each backend, method and settings, medium or scene, and reference. Errors are fractions,
/// times milliseconds.
pub fn csv(f: &Findings, file: &mut dyn std::io::Write) -> anyhow::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header: Vec<String> =
        ["backend", "method", "settings", "quality", "scene", "against"].map(str::to_owned).to_vec();
    for channel in ["R", "G", "B", "delta_e"] {
        header.extend(["mean", "p95", "max"].map(|s| format!("{s}_{channel}")));
    }
    header.extend(["time_ms", "copy_ms", "time_over_copy", "once_ms"].map(str::to_owned));
    writer.write_record(&header)?;
    for e in &f.entries {
        let c = &e.candidate;
        for against in Against::BOTH.into_iter().filter(|a| c.is_compared_with(*a)) {
            let s = &e.errors[against as usize];
            let mut line = vec![
                e.backend.to_owned(),
                c.quality.method().to_owned(),
                c.quality.numbers(),
                c.preset.unwrap_or_default().to_owned(),
                e.over.name().to_owned(),
                against.name().to_owned(),
            ];
            for s in s.relative.iter().chain([&s.delta_e]) {
                line.extend([s.mean, s.p95, s.max].map(|v| format!("{v:.4e}")));
            }
            line.extend([e.times.sky, e.times.copy, e.ratio(), e.times.once].map(|v| format!("{v:.4}")));
            writer.write_record(&line)?;
        }
    }
    writer.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn percents_keep_two_digits_or_more() {
        let texts = [0.0, 0.000123, 0.00123, 0.0123, 0.123, 0.99, 1.23].map(percent);
        assert_eq!(texts, ["0.0000", "0.012", "0.12", "1.2", "12", "99", "123"]);
    }
}
