//! `welkin-lab compare`: every view by every backend, side by side in numbers.

use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use clap::Args;
use welkin::gpu::{Format, PassTime, TextureDesc};
use welkin::{SkySettings, ToneMap};

use crate::args::backend::BackendChoice;
use crate::args::quality::{PresetArgs, SamplesArgs, march};
use crate::args::usage::UsageError;
use crate::args::values;
use crate::gpu::{self, Gpu};
use crate::lab::{device, timing};
use crate::picture::{Picture, RenderRequest};
use crate::views::{Place, VIEWS, View};

/// Options of `welkin-lab compare`.
#[derive(Args, Debug)]
#[command(after_help = "Pictures are compared without dither, timed with it.")]
pub struct CompareArgs {
    /// Pixels of the pictures that are compared
    #[arg(long, value_name = "WxH", default_value = "480x270", value_parser = values::size)]
    size: [u32; 2],

    /// Pixels of the pictures that are timed
    #[arg(long, value_name = "WxH", default_value = "1920x1080", value_parser = values::size)]
    time_size: [u32; 2],

    /// Rounds of timing, of which the best counts, 0 to 1000; 0 does not time
    #[arg(
        long, value_name = "N", default_value = "3",
        value_parser = clap::value_parser!(u32).range(0..=1000)
    )]
    repeat: u32,

    #[command(flatten)]
    preset: PresetArgs,

    #[command(flatten)]
    samples: SamplesArgs,

    /// Also draw on the CPU, by the f64 reference
    #[arg(long)]
    cpu: bool,

    /// Keep the pictures in this folder, as VIEW.BACKEND.png
    #[arg(long, value_name = "DIR")]
    keep: Option<PathBuf>,

    /// Compare with pictures kept in this folder, from another machine or driver
    #[arg(long, value_name = "DIR")]
    with: Option<PathBuf>,
}

/// How far two pictures lie apart, in 255ths of the display's range.
struct Difference {
    largest: u8,
    mean: f64,
    /// Fraction of values that differ by more than one.
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

impl CompareArgs {
    /// The settings of the sky that is drawn.
    fn sky(&self) -> SkySettings {
        self.samples.given().map_or_else(
            || SkySettings::from(self.preset.quality()),
            |samples| SkySettings::from(march(samples)),
        )
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
    let mut choices = gpu::available().0;
    choices.retain(|c| args.cpu || *c != BackendChoice::Cpu);
    ensure!(!choices.is_empty(), "{}; --cpu draws without one", device::NONE);
    let mut gpus = Vec::new();
    let mut out = std::io::stdout().lock();
    for choice in choices {
        let gpu = Gpu::open(choice)?;
        writeln!(out, "- {}", gpu.describe())?;
        gpus.push((choice.name(), gpu));
    }
    compare(args, &mut gpus, &mut out)?;
    if args.repeat > 0 {
        time(args, &mut gpus, &mut out)?;
    }
    Ok(())
}

fn request(
    args: &CompareArgs,
    view: &View,
    [width, height]: [u32; 2],
    dither: bool,
) -> anyhow::Result<RenderRequest> {
    let terrain = view.terrain();
    Ok(RenderRequest {
        scene: view.scene(Place::DEFAULT, f64::from(width) / f64::from(height), Some(&terrain))?,
        width,
        height,
        sky: args.sky(),
        exposure: view.exposure,
        tone_map: ToneMap::Aces,
        dither,
        terrain: Some(terrain),
        radiance: Format::Rgba16Float,
    })
}

fn compare(args: &CompareArgs, gpus: &mut [(&str, Gpu)], out: &mut impl Write) -> anyhow::Result<()> {
    let [w, h] = args.size;
    writeln!(out, "\nDifferences of display values at {w}×{h}, {} (of 255):\n", args.sky().quality)?;
    writeln!(
        out,
        "| view | pair | largest | mean | more than 1 apart | not finite |\n|---|---|---:|---:|---:|---:|"
    )?;
    for view in &VIEWS {
        let request = request(args, view, args.size, false)?;
        let mut drawn: Vec<(&str, Picture)> = Vec::new();
        for (name, gpu) in &mut *gpus {
            let picture = gpu.draw(&request, &|_| ()).with_context(|| format!("{} by {name}", view.name))?;
            if let Some(dir) = &args.keep {
                keep(&dir.join(format!("{}.{name}.png", view.name)), &picture)?;
            }
            drawn.push((name, picture));
        }
        let mut row = |pair: String, d: Difference, picture: &Picture| {
            let broken = picture.hdr.iter().flatten().filter(|v| !v.is_finite()).count();
            let beyond = d.beyond * 100.0;
            writeln!(
                out,
                "| {} | {pair} | {} | {:.4} | {beyond:.3} % | {broken} |",
                view.name, d.largest, d.mean
            )
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
            ensure!(
                kept.dimensions() == (w, h),
                "{} is {:?}, not {w}×{h}",
                path.display(),
                kept.dimensions()
            );
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

fn time(args: &CompareArgs, gpus: &mut [(&str, Gpu)], out: &mut impl Write) -> anyhow::Result<()> {
    let [w, h] = args.time_size;
    writeln!(
        out,
        "\nTimes at {w}×{h}, {}, best of {}; × is the ratio to the copy:\n",
        args.sky().quality,
        args.repeat
    )?;
    writeln!(out, "| view | backend | pass | ms | × |\n|---|---|---|---:|---:|")?;
    for view in &VIEWS {
        let request = request(args, view, args.time_size, true)?;
        for (name, gpu) in &mut *gpus {
            let Some(times) = times(gpu, &request, args.repeat)? else { continue };
            let copy = times.last().map_or(0.0, |t| t.nanoseconds);
            for t in &times {
                let ratio = if copy > 0.0 { format!("{:.1}", t.nanoseconds / copy) } else { "–".into() };
                writeln!(
                    out,
                    "| {} | {name} | {} | {:.4} | {ratio} |",
                    view.name,
                    t.label,
                    t.nanoseconds * 1e-6
                )?;
            }
        }
    }
    Ok(())
}

/// The best of `repeat` times of each pass of a picture, and last of a plain full-screen copy of its
/// radiance, all in the same run. `None` on the CPU, which has no passes.
fn times(gpu: &mut Gpu, request: &RenderRequest, repeat: u32) -> anyhow::Result<Option<Vec<PassTime>>> {
    let Some((backend, renderer)) = gpu.parts()? else { return Ok(None) };
    let size = [request.width, request.height];
    let (passes, drawn) = renderer.passes(backend, &request.scene, &request.settings(), size)?;
    let mut passes = passes.to_vec();
    let copy =
        backend.create_texture(&TextureDesc::new(timing::COPY, size[0], size[1], Format::Rgba16Float))?;
    passes.push(timing::copy(backend, drawn.radiance, copy)?);
    // Makes pipelines and warms caches; it does not count.
    backend.times(&passes)?;
    let best = timing::best_of(backend, &passes, repeat)?;
    backend.destroy_texture(copy);
    Ok(Some(best))
}
