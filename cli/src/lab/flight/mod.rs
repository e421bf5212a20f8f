//! `welkin-lab flight`: what a plan draws along a flight, why, what it saves and what it changes.

mod frame;
mod plot;

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::Context;
use clap::Args;
use welkin::frame::graph::Runs;
use welkin::gpu::{Backend, Format, Pass};
use welkin::probe::film::Moment;
use welkin::{AtmosphereParams, Bound, Frame, PictureRenderer, PictureSettings, Scene, SkySettings, WarmUp};

use crate::args::backend::{BackendArgs, BackendChoice};
use crate::args::output::{self, OutputArgs};
use crate::args::quality::PresetArgs;
use crate::args::scene::PlanetArgs;
use crate::args::values;
use crate::gpu::Gpu;
use crate::lab::values::frame_size;
use crate::lab::{device, timing};
use crate::output::Destination;
use crate::progress::Progress;
use crate::views::{self, Place, View};
use frame::{Cost, FlightFrame};

/// Metres from the Earth's ground to the moon.
const MOON: f64 = 3.84e8;
/// Degrees of the sun by day and on the night side.
const SUN: [f64; 2] = [20.0, -60.0];
/// Fractions of the flight: up by day, around, a look away from the planet, down by night.
const LEGS: [f64; 4] = [0.4, 0.2, 0.1, 0.3];

/// Options of `welkin-lab flight`.
#[derive(Args, Debug)]
#[command(long_about = "\
Fly from the ground to the moon's distance and around to the night side: what is drawn, why, and what it costs

The camera rises from 2 m to 384,000 km by day, goes around to the night side, looks away from the \
planet for a moment and comes down by night. For each frame: the passes that the plan calls for, the \
pixels that they shade and their time on the GPU, beside the same with every effect forced on. Then \
every switch of an effect with its reason, the slowest frame with pipelines made ahead and made when \
they are first needed, and the largest change of a pixel by what was left out.")]
#[command(after_long_help = "\
Times are of the sky's passes alone, LUTs included, and the best of --repeat; the demonstration's ground \
and tone mapping cost the same in both. The slowest frame is by the clock, with everything. A driver \
that keeps compiled shaders on disk hides what pipelines cost: empty that first (Mesa: \
MESA_SHADER_CACHE_DIR=an empty folder).

Examples:
  welkin-lab flight
  welkin-lab flight --frames 400 --size 1920x1080 -o flight.svg --csv flight.csv")]
#[command(mut_arg("backend", |arg| {
    arg.help("What draws: auto, webgpu or webgl2").hide_possible_values(true)
}))]
#[command(mut_arg("output", |arg| {
    arg.help("Draw times, pixels and passes along the flight to this file (SVG)")
}))]
pub struct FlightArgs {
    /// Frames, 16 to 4000
    #[arg(
        long, value_name = "N", default_value = "120",
        value_parser = clap::value_parser!(u32).range(16..=4000)
    )]
    frames: u32,

    /// Pixels of the frames that are timed
    #[arg(long, value_name = "WxH", default_value = "960x540", value_parser = values::size)]
    size: [u32; 2],

    /// Pixels of the frames whose radiance is compared, 8x8 to 1000x1000
    #[arg(long, value_name = "WxH", default_value = "96x54", value_parser = frame_size)]
    compare_size: [u32; 2],

    /// Rounds of timing, of which the best counts, 1 to 100
    #[arg(
        long, value_name = "N", default_value = "3",
        value_parser = clap::value_parser!(u32).range(1..=100)
    )]
    repeat: u32,

    #[command(flatten)]
    planet: PlanetArgs,

    #[command(flatten)]
    preset: PresetArgs,

    /// Leave the demonstration's ground out, which software renderers need a second for
    #[arg(long)]
    no_terrain: bool,

    #[command(flatten)]
    backend: BackendArgs,

    /// Write every frame to this file (CSV)
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Checks everything, then flies.
pub fn run(args: &FlightArgs) -> anyhow::Result<()> {
    let csv = args.csv.as_deref().map(|path| Destination::new(path, "--csv <FILE>")).transpose()?;
    let plot = args.output.path().map(|path| Destination::new(path, output::OPTION)).transpose()?;
    let flight = Flight::new(args)?;
    let (frames, describe, ahead) = flight.fly()?;
    let mut out = std::io::stdout().lock();
    writeln!(out, "{describe}")?;
    writeln!(out, "{}", report(args, &frames, ahead))?;
    if let Some(csv) = csv {
        csv.write(|file| Ok(file.write_all(table(&frames)?.as_bytes())?))?;
    }
    if let Some(to) = plot {
        let svg = plot::svg(&frames, args.size, &describe)?;
        to.write(|file| Ok(file.write_all(svg.as_bytes())?))?;
    }
    Ok(())
}

struct Flight<'a> {
    args: &'a FlightArgs,
    backend: BackendChoice,
    planet: &'static str,
    params: AtmosphereParams,
    settings: PictureSettings,
}

/// Whether a pass is the sky's.
fn of_sky(pass: &Pass) -> bool {
    !matches!(pass.label, "terrain" | "tone mapping" | "clear")
}

impl<'a> Flight<'a> {
    fn new(args: &'a FlightArgs) -> anyhow::Result<Self> {
        let backend = args.backend.gpu("what is timed are a GPU's passes")?;
        let planet = args.planet.or("earth");
        let terrain = (!args.no_terrain).then(|| View { planet, ..views::DEFAULT }.terrain());
        let mut sky = SkySettings::from(args.preset.quality());
        sky.bound = Some(Bound::eight_bit(1.0));
        let settings = PictureSettings { sky, terrain, dither: false, ..PictureSettings::default() };
        Ok(Self { args, backend, planet, params: AtmosphereParams::preset(planet)?, settings })
    }

    fn everything(&self) -> PictureSettings {
        let mut all = self.settings;
        all.sky.bound = None;
        all
    }

    fn moments(&self) -> Vec<Moment> {
        let [width, height] = self.args.size.map(f64::from);
        let n = f64::from(self.args.frames - 1);
        let up = |climbed: f64, sun: f64| {
            let altitude = 2.0 * (MOON / 2.0).powf(climbed.clamp(0.0, 1.0));
            Moment::climb(&self.params, altitude, sun, width / height)
        };
        let moment = |i: u32| {
            let t = f64::from(i) / n;
            if t <= LEGS[0] {
                up(t / LEGS[0], SUN[0])
            } else if t <= LEGS[0] + LEGS[1] {
                up(1.0, SUN[0] + (SUN[1] - SUN[0]) * (t - LEGS[0]) / LEGS[1])
            } else if t < 1.0 - LEGS[3] {
                // Away and back.
                let away = 1.0 - (2.0 * (t - LEGS[0] - LEGS[1]) / LEGS[2] - 1.0).abs();
                let there = up(1.0, SUN[1]);
                Moment { pitch: there.pitch + 90.0 * away, ..there }
            } else {
                up((1.0 - t) / LEGS[3], SUN[1])
            }
        };
        (0..self.args.frames).map(moment).collect()
    }

    fn scene(&self, moment: &Moment, [width, height]: [u32; 2]) -> anyhow::Result<Scene> {
        let view = View {
            planet: self.planet,
            altitude: moment.altitude,
            pitch: moment.pitch,
            heading: 270.0,
            fov: moment.fov,
            sun_elevation: moment.sun_elevation,
            sun_azimuth: 290.0,
            ..views::DEFAULT
        };
        Ok(view.scene(
            Place::DEFAULT,
            f64::from(width) / f64::from(height),
            self.settings.terrain.as_ref(),
        )?)
    }

    fn fly(&self) -> anyhow::Result<(Vec<FlightFrame>, String, f64)> {
        let moments = self.moments();
        let steps = Progress::of("flying", 3 * moments.len());
        // Each with a device of its own: nothing is compiled yet.
        let cold = self.clocks(&mut Gpu::open(self.backend)?, &moments, &steps)?;
        let mut gpu = Gpu::open(self.backend)?;
        let start = Instant::now();
        let backend = device::current(&mut gpu)?;
        let mut warm_up = WarmUp::picture(&self.scene(&moments[0], self.args.size)?, &self.settings)?;
        while warm_up.step(backend)? {}
        let ahead = start.elapsed().as_secs_f64();
        let warmed_up = self.clocks(&mut gpu, &moments, &steps)?;
        let describe = gpu.describe();
        let backend = device::current(&mut gpu)?;
        let mut renderers: [PictureRenderer; 4] = Default::default();
        let mut frames = Vec::with_capacity(moments.len());
        for (moment, clock) in moments.into_iter().zip(cold.into_iter().zip(warmed_up)) {
            let progress = steps.step(&views::length(moment.altitude));
            let scene = self.scene(&moment, self.args.size)?;
            let [planned, whole, small, small_whole] = &mut renderers;
            let cost = |backend: &mut dyn Backend, renderer: &mut PictureRenderer, settings| {
                self.cost(backend, renderer, settings, &scene)
            };
            let (planned_cost, plan) = cost(backend, planned, &self.settings)?;
            let (everything, _) = cost(backend, whole, &self.everything())?;
            let change = self.change(backend, [small, small_whole], &moment)?;
            let clock = [clock.0, clock.1];
            frames.push(FlightFrame { moment, plan, planned: planned_cost, everything, clock, change });
            progress(1.0);
        }
        renderers.iter_mut().for_each(|r| r.destroy(backend));
        Ok((frames, describe, ahead))
    }

    /// Milliseconds of each frame by the clock.
    fn clocks(&self, gpu: &mut Gpu, moments: &[Moment], steps: &Progress) -> anyhow::Result<Vec<f64>> {
        let backend = device::current(gpu)?;
        let mut renderer = PictureRenderer::default();
        let mut clocks = Vec::with_capacity(moments.len());
        for moment in moments {
            let progress = steps.step(&views::length(moment.altitude));
            let scene = self.scene(moment, self.args.size)?;
            let start = Instant::now();
            let (passes, _) = renderer.passes(backend, &scene, &self.settings, self.args.size)?;
            // Waits for the GPU.
            backend.times(passes)?;
            clocks.push(1e3 * start.elapsed().as_secs_f64());
            progress(1.0);
        }
        renderer.destroy(backend);
        Ok(clocks)
    }

    fn cost(
        &self,
        backend: &mut dyn Backend,
        renderer: &mut PictureRenderer,
        settings: &PictureSettings,
        scene: &Scene,
    ) -> anyhow::Result<(Cost, Frame)> {
        let passes = renderer.passes(backend, scene, settings, self.args.size)?.0.to_vec();
        let plan = renderer.last_frame().context("a frame has a plan")?.clone();
        let sun = plan.planned_passes().iter().find(|p| p.label == "sun").map_or(0.0, |p| p.fraction);
        let sky: Vec<&Pass> = passes.iter().filter(|p| of_sky(p)).collect();
        let pixels = |p: &&Pass| {
            let texels = backend.texture(p.target.color).map_or(0, |desc| desc.texels()) as f64;
            if p.program.is_none() { 0.0 } else { texels * if p.label == "sun" { sun } else { 1.0 } }
        };
        let mut cost = Cost {
            passes: sky.len(),
            pixels: sky.iter().map(pixels).sum::<f64>() + 0.0,
            time: f64::INFINITY,
        };
        // Once in whole: that fills the depth buffer, makes pipelines and warms caches. Then the sky's passes
        // alone.
        backend.run(&passes)?;
        let sky: Vec<Pass> = sky.into_iter().cloned().collect();
        let times = timing::best_of(backend, &sky, self.args.repeat)?;
        cost.time = times.iter().map(|t| 1e-6 * t.nanoseconds).sum::<f64>() + 0.0;
        Ok((cost, plan))
    }

    /// The largest changes by what is left out.
    fn change(
        &self,
        backend: &mut dyn Backend,
        [planned, whole]: [&mut PictureRenderer; 2],
        moment: &Moment,
    ) -> anyhow::Result<[f64; 2]> {
        let size = self.args.compare_size;
        let scene = self.scene(moment, size)?;
        let mut draw = |renderer: &mut PictureRenderer, settings: PictureSettings| {
            let settings = PictureSettings { radiance: Format::Rgba32Float, ..settings };
            let drawn = renderer.draw(backend, &scene, &settings, size)?;
            anyhow::Ok((backend.read(drawn.radiance)?, backend.read(drawn.display)?, drawn.scale))
        };
        let (some, some_display, scale) = draw(planned, self.settings)?;
        let (all, all_display, _) = draw(whole, self.everything())?;
        let bound = self.settings.sky.bound.unwrap_or(Bound::EXACT);
        let of_bound = some.iter().zip(&all).map(|(a, b)| {
            let (a, b) = (f64::from(*a) / scale, f64::from(*b) / scale);
            (a - b).abs() / (bound.relative * a.max(b) + bound.absolute)
        });
        let display = some_display.iter().zip(&all_display).map(|(a, b)| 255.0 * f64::from((a - b).abs()));
        Ok([of_bound.fold(0.0, f64::max), display.fold(0.0, f64::max)])
    }
}

fn report(args: &FlightArgs, frames: &[FlightFrame], ahead: f64) -> String {
    let [width, height] = args.size;
    let mut text = format!(
        "{} frames of {width}×{height}, {}, {}\n\n",
        frames.len(),
        args.planet.or("earth"),
        args.preset.quality()
    );
    text += "| frame | altitude | sun | passes | all on | megapixels | all on | GPU ms | all on | effects \
     off |\n";
    text += "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n";
    let stations = 17.min(frames.len());
    for i in 0..stations {
        let at = i * (frames.len() - 1) / (stations - 1);
        let f = &frames[at];
        let off: Vec<_> = f.plan.effects().iter().filter(|e| !e.on).map(|e| e.name).collect();
        let _ = writeln!(
            text,
            "| {at} | {} | {:.0}° | {} | {} | {:.2} | {:.2} | {:.3} | {:.3} | {} |",
            views::length(f.moment.altitude),
            f.moment.sun_elevation,
            f.planned.passes,
            f.everything.passes,
            1e-6 * f.planned.pixels,
            1e-6 * f.everything.pixels,
            f.planned.time,
            f.everything.time,
            off.join(", "),
        );
    }
    text += "\nSwitches:\n\n| frame | altitude | sun | effect | | because |\n|---:|---:|---:|---|---|---|\n";
    for (at, pair) in frames.windows(2).enumerate() {
        for (before, now) in pair[0].plan.effects().iter().zip(pair[1].plan.effects()) {
            if before.on != now.on {
                let (altitude, sun) = (views::length(pair[1].moment.altitude), pair[1].moment.sun_elevation);
                let state = if now.on { "on" } else { "off" };
                let _ = writeln!(
                    text,
                    "| {} | {altitude} | {sun:.0}° | {} | {state} | {} |",
                    at + 1,
                    now.name,
                    now.reason
                );
            }
        }
    }
    let sum = |of: fn(&FlightFrame) -> f64| frames.iter().map(of).sum::<f64>();
    let most =
        |of: fn(&FlightFrame) -> f64| frames.iter().map(of).enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    let (planned, all) = (sum(|f| f.planned.time), sum(|f| f.everything.time));
    let _ = write!(
        text,
        "\nThe sky's passes over the whole flight: {planned:.1} ms of the GPU, {all:.1} ms with \
         everything on ({:.2}×)\n",
        all / planned
    );
    // A frame's clock holds its own work: what is compiled in it stands out against a flight that compiles
    // nothing.
    for (name, which) in [("pipelines made when first needed", 0), ("pipelines made ahead", 1)] {
        let mut clocks: Vec<f64> = frames[1..].iter().map(|f| f.clock[which]).collect();
        let worst = clocks.iter().copied().fold(0.0, f64::max);
        let at = frames.iter().skip(1).position(|f| f.clock[which] == worst).unwrap_or(0) + 1;
        clocks.sort_by(f64::total_cmp);
        let _ = writeln!(
            text,
            "By the clock, {name}: first frame {:.0} ms; after it the slowest {worst:.1} ms (frame {at}), \
             the middle one {:.1} ms",
            frames[0].clock[which],
            clocks[clocks.len() / 2],
        );
    }
    let _ = writeln!(text, "Making them ahead took {:.0} ms", 1e3 * ahead);
    if let (Some((a, of_bound)), Some((b, display))) = (most(|f| f.change[0]), most(|f| f.change[1])) {
        let _ = writeln!(
            text,
            "Largest change by what is left out: {of_bound:.3} of the bound (frame {a}), {display:.0} of \
             255 on the display (frame {b})"
        );
    }
    text
}

fn table(frames: &[FlightFrame]) -> anyhow::Result<String> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_record([
        "frame",
        "altitude_m",
        "sun_deg",
        "passes",
        "passes_all",
        "pixels",
        "pixels_all",
        "gpu_ms",
        "gpu_all_ms",
        "clock_ms",
        "clock_ahead_ms",
        "change_of_bound",
        "change_of_255",
        "per_frame_passes",
        "off",
    ])?;
    for (i, f) in frames.iter().enumerate() {
        let off: Vec<_> = f.plan.effects().iter().filter(|e| !e.on).map(|e| e.name).collect();
        let steady = f.plan.planned_passes().iter().filter(|p| p.runs == Runs::PerFrame).count();
        let numbers = [
            f.moment.altitude,
            f.moment.sun_elevation,
            f.planned.passes as f64,
            f.everything.passes as f64,
            f.planned.pixels.round(),
            f.everything.pixels.round(),
            f.planned.time,
            f.everything.time,
            f.clock[0],
            f.clock[1],
            f.change[0],
            f.change[1],
        ];
        let mut row = vec![i.to_string()];
        row.extend(numbers.map(|v| v.to_string()));
        row.push(steady.to_string());
        row.push(off.join("; "));
        csv.write_record(row)?;
    }
    Ok(String::from_utf8(csv.into_inner()?)?)
}
