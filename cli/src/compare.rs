//! `welkin compare`: every view by every backend, side by side in numbers.

use std::io::Write;
use std::path::Path;

use anyhow::{Context, ensure};
use welkin::{SkySettings, ToneMap};

use crate::args::{CompareArgs, UsageError};
use crate::draw::{self, BackendChoice, Drawer, Picture, Shot};
use crate::info;
use crate::views::{Place, VIEWS, View};

/// How far two pictures lie apart, in 255ths of the display's range.
struct Difference {
    largest: u8,
    mean: f64,
    /// Share of values that differ by more than one.
    beyond: f64,
}

impl Difference {
    fn between(a: &[[u8; 4]], b: &[[u8; 4]]) -> Self {
        let values = || a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a.abs_diff(*b));
        let count = (a.len() * 4).max(1) as f64;
        Self {
            largest: values().max().unwrap_or(0),
            mean: values().map(f64::from).sum::<f64>() / count,
            beyond: values().filter(|d| *d > 1).count() as f64 / count,
        }
    }
}

/// Draws, compares, keeps, times; prints Markdown.
pub fn run(args: &CompareArgs) -> anyhow::Result<()> {
    if let Some(dir) = args.with.as_deref().filter(|d| !d.is_dir()) {
        return Err(UsageError::value("--with <DIR>", dir.display(), "a folder with kept pictures").into());
    }
    if let Some(dir) = &args.keep {
        std::fs::create_dir_all(dir).map_err(|e| {
            UsageError::value("--keep <DIR>", dir.display(), format_args!("a folder that can be made: {e}"))
        })?;
    }
    let mut choices = draw::available();
    choices.retain(|c| args.cpu || *c != BackendChoice::Cpu);
    ensure!(!choices.is_empty(), "no GPU backend can be had here ('welkin info' says why); --cpu draws without one");
    let mut drawers = Vec::new();
    let mut out = std::io::stdout().lock();
    for choice in choices {
        let drawer = Drawer::open(choice)?;
        writeln!(out, "- {}", drawer.describe())?;
        drawers.push((info::name(choice), drawer));
    }
    compare(args, &mut drawers, &mut out)?;
    if args.repeat > 0 {
        time(args, &mut drawers, &mut out)?;
    }
    Ok(())
}

fn shot(args: &CompareArgs, view: &View, [width, height]: [u32; 2], dither: bool) -> anyhow::Result<Shot> {
    let terrain = view.terrain();
    Ok(Shot {
        scene: view.scene(Place::DEFAULT, f64::from(width) / f64::from(height), Some(&terrain))?,
        width,
        height,
        sky: SkySettings { method: args.method(), ..SkySettings::default() },
        exposure: view.exposure,
        tone_map: ToneMap::Aces,
        dither,
        terrain: Some(terrain),
    })
}

fn compare(args: &CompareArgs, drawers: &mut [(String, Drawer)], out: &mut impl Write) -> anyhow::Result<()> {
    let [w, h] = args.size;
    writeln!(out, "\nDifferences of display values at {w}×{h}, {} (of 255):\n", args.method())?;
    writeln!(out, "| view | pair | largest | mean | more than 1 apart | not finite |\n|---|---|---:|---:|---:|---:|")?;
    for view in &VIEWS {
        let shot = shot(args, view, args.size, false)?;
        let mut drawn: Vec<(String, Picture)> = Vec::new();
        for (name, drawer) in &mut *drawers {
            let picture = drawer.draw(&shot, &|_| ()).with_context(|| format!("{} by {name}", view.name))?;
            if let Some(dir) = &args.keep {
                keep(&dir.join(format!("{}.{name}.png", view.name)), &picture)?;
            }
            drawn.push((name.clone(), picture));
        }
        let mut row = |pair: String, d: Difference, picture: &Picture| {
            let broken = picture.hdr.iter().flatten().filter(|v| !v.is_finite()).count();
            let share = d.beyond * 100.0;
            writeln!(out, "| {} | {pair} | {} | {:.4} | {share:.3} % | {broken} |", view.name, d.largest, d.mean)
        };
        if let [(first, a), rest @ ..] = &drawn[..] {
            for (name, b) in rest {
                row(format!("{first} – {name}"), Difference::between(&a.display, &b.display), b)?;
            }
        }
        for (name, picture) in drawn.iter().filter(|_| args.with.is_some()) {
            let Some(dir) = &args.with else { continue };
            let path = dir.join(format!("{}.{name}.png", view.name));
            let kept = image::open(&path).with_context(|| path.display().to_string())?.into_rgba8();
            ensure!(kept.dimensions() == (w, h), "{} is {:?}, not {w}×{h}", path.display(), kept.dimensions());
            let kept: Vec<[u8; 4]> = kept.pixels().map(|p| p.0).collect();
            row(format!("{name} – kept {name}"), Difference::between(&kept, &picture.display), picture)?;
        }
    }
    Ok(())
}

fn keep(path: &Path, picture: &Picture) -> anyhow::Result<()> {
    let bytes = picture.display.as_flattened();
    image::save_buffer(path, bytes, picture.width, picture.height, image::ColorType::Rgba8)
        .with_context(|| path.display().to_string())
}

fn time(args: &CompareArgs, drawers: &mut [(String, Drawer)], out: &mut impl Write) -> anyhow::Result<()> {
    let [w, h] = args.time_size;
    writeln!(out, "\nTimes at {w}×{h}, {}, best of {}; × is the ratio to the copy:\n", args.method(), args.repeat)?;
    writeln!(out, "| view | backend | pass | ms | × |\n|---|---|---|---:|---:|")?;
    for view in &VIEWS {
        let shot = shot(args, view, args.time_size, true)?;
        for (name, drawer) in &mut *drawers {
            let Some(times) = drawer.times(&shot, args.repeat)? else { continue };
            let copy = times.last().map_or(0.0, |t| t.nanoseconds);
            for t in &times {
                let ratio = if copy > 0.0 { format!("{:.1}", t.nanoseconds / copy) } else { "–".into() };
                writeln!(out, "| {} | {name} | {} | {:.4} | {ratio} |", view.name, t.label, t.nanoseconds * 1e-6)?;
            }
        }
    }
    Ok(())
}
