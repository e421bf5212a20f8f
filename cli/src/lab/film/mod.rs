//! `welkin-lab film`: a climb to a million kilometres or a day as a strip of frames, and how smoothly they
//! follow.

mod strip;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, ensure};
use clap::{Args, ValueEnum};
use rayon::prelude::*;
use welkin::frame::HAND_OVER;
use welkin::gpu::Format;
use welkin::probe::film::{self, Moment, Step};
use welkin::reference::multiple::{Orders, Settings};
use welkin::{AtmosphereParams, PictureRenderer, PictureSettings, Scene, SkySettings, ToneMap};

use crate::args::backend::{BackendArgs, BackendChoice};
use crate::args::cache::CacheArgs;
use crate::args::output::OutputArgs;
use crate::args::quality::PresetArgs;
use crate::args::scene::PlanetArgs;
use crate::args::usage::UsageError;
use crate::args::values::{self, Length, degrees, number};
use crate::cache::Cache;
use crate::gpu::{self, Gpu};
use crate::lab::values::frame_size;
use crate::lab::{device, reference};
use crate::output::{Destination, Output};
use crate::picture::{Picture, RenderRequest};
use crate::progress::Progress;
use crate::views::{self, Place, View};

const FILM_ABOUT: &str = "\
Draw a climb to a million kilometres, or a day, as a strip of frames; measure how smoothly they follow

climb: the camera rises from 2 m to 1,000,000 km, each frame higher by the same factor. It looks at the \
horizon, from 100 km on more and more towards the planet's centre, and keeps the whole planet in the \
picture once it fits.
day: the sun rises 20° below the horizon behind the camera, passes through the zenith and sets in front of it.

Then the same film in many more and smaller frames, by every backend and by the f64 reference: how far \
neighbouring frames lie apart, and how far that is from what the reference changes by. A seam, a popping \
LUT or a hand-over that does not add up shows as a difference there.";

const FILM_DETAILS: &str = "\
The table of steps: light of the air over black, without ground and sun's disk, in 32-bit floats. All \
numbers are fractions of the brightest value that the reference has in the two frames, channel by \
channel, in %:
  mean    of all values of the frame
  pixel   the value that changes most
  off     of the change that is drawn less the reference's change; the two above it are sizes of either change
Half of a climb's steps are spread evenly in the altitude's logarithm, a quarter over 14 to 51 km, where \
the background hands over to the depth-aware pass, and a quarter around the top of the air. --csv writes \
every step.

The reference is solved once for each planet (Earth: 10 s) and kept; its frames take some minutes of a core.

Examples:
  welkin-lab film climb
      The strip to film.png, then the table for every backend
  welkin-lab film climb --planet mars --frames 24 --steps 0 -o mars.png
      Only the strip
  welkin-lab film day --altitude 11km --backend webgl2 --csv steps.csv
      A day from an airliner; every step into a file

Exit status: 0 drawn and written; 1 drawing, measuring or writing failed; 2 the request was not accepted, and
nothing was written.";

/// A parser of the number of steps that are measured.
fn steps(text: &str) -> Result<u32, String> {
    let value = text.trim().parse().ok().filter(|n| *n == 0 || (8..=10_000).contains(n));
    value.ok_or_else(|| "must be 0 or a whole number from 8 to 10000".to_owned())
}

/// Which film.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FilmKind {
    /// The camera rises from 2 m to 1,000,000 km
    Climb,
    /// The sun rises, passes through the zenith and sets
    Day,
}

/// Options of `welkin-lab film`.
#[derive(Args, Debug)]
#[command(long_about = FILM_ABOUT, after_long_help = FILM_DETAILS)]
#[command(after_help = "What the table says, and examples: welkin-lab film --help")]
#[command(mut_arg("backend", |arg| arg.hide_possible_values(true).help(
    "What draws: webgpu, webgl2 or auto, which is the best for the strip and each that can be had for the \
     table"
)))]
#[command(mut_arg("output", |arg| arg.help("Where to write the strip (.png) [default: film.png]")))]
pub struct FilmArgs {
    /// What changes from frame to frame
    #[arg(value_name = "FILM")]
    kind: FilmKind,

    #[command(flatten)]
    planet: PlanetArgs,

    /// Degrees of the sun above the horizontal, -90 to 90; only of a climb [default: 25]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = degrees(-90.0, 90.0))]
    sun_elevation: Option<f64>,

    /// Height above the ground, 0 to 1,000 km: metres, or as in 15km; only of a day [default: 2m]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = values::length)]
    altitude: Option<Length>,

    /// Frames of the strip, 2 to 64
    #[arg(
        long, value_name = "N", default_value = "16",
        value_parser = clap::value_parser!(u32).range(2..=64)
    )]
    frames: u32,

    /// Pixels of each frame, 8x8 to 1000x1000
    #[arg(long, value_name = "WxH", default_value = "80x120", value_parser = frame_size)]
    size: [u32; 2],

    /// Steps that are measured, 8 to 10000; 0 does not measure
    #[arg(long, value_name = "N", default_value = "240", value_parser = steps)]
    steps: u32,

    #[command(flatten)]
    preset: PresetArgs,

    /// Multiplies radiance before tone mapping, 1e-6 to 1e6 [default: 0.4; of a day, 0.25 / median^0.85 of
    /// each frame]
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, value_parser = number(1e-6, 1e6, ""))]
    exposure: Option<f64>,

    /// Round display values without the noise that hides bands: a smaller file
    #[arg(long)]
    no_dither: bool,

    #[command(flatten)]
    backend: BackendArgs,

    /// Write every step to this file (CSV)
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    cache: CacheArgs,
}

impl FilmArgs {
    fn output(&self) -> &Path {
        self.output.path_or("film.png")
    }

    /// The sun's elevation of a climb (degrees) and the altitude of a day (metres).
    fn fixed(&self) -> Result<(f64, f64), UsageError> {
        let other = match self.kind {
            FilmKind::Climb => {
                self.altitude.is_some().then_some(("--altitude <LENGTH>", "climb", "altitude"))
            }
            FilmKind::Day => {
                self.sun_elevation.is_some().then_some(("--sun-elevation <DEGREES>", "day", "sun"))
            }
        };
        if let Some((option, film, what)) = other {
            return Err(UsageError::new(format!(
                "'{option}' cannot be used with '{film}': the {what} is what changes from frame to frame"
            )));
        }
        if self.csv.is_some() && self.steps == 0 {
            return Err(UsageError::new(
                "'--csv <FILE>' cannot be used with '--steps 0': no step is measured",
            ));
        }
        let altitude = self.altitude.as_ref().map_or(2.0, |a| a.metres);
        if let Some(text) =
            self.altitude.as_ref().filter(|a| !(0.0..=1e6).contains(&a.metres)).map(|a| &a.text)
        {
            return Err(UsageError::value("--altitude <LENGTH>", text, "from 0 m to 1,000 km"));
        }
        Ok((self.sun_elevation.unwrap_or(25.0), altitude))
    }
}

/// Pixels across the frames that are compared with the reference.
const COMPARED_WIDTH: u32 = 12;

/// One frame and what names it.
struct Frame {
    /// Metres, or degrees along the sun's way.
    at: f64,
    moment: Moment,
}

/// Checks everything, then draws the strip, then measures.
pub fn run(args: &FilmArgs) -> anyhow::Result<()> {
    let film = Film::new(args)?;
    let output = Output::new(args.output(), true)?;
    let csv = args.csv.as_deref().map(|path| Destination::new(path, "--csv <FILE>")).transpose()?;
    let mut choices = match args.backend.gpu("what is measured are a GPU's frames")? {
        BackendChoice::Auto => gpu::available().0,
        choice => vec![choice],
    };
    choices.retain(|c| *c != BackendChoice::Cpu);
    ensure!(!choices.is_empty(), device::NONE);
    let start = Instant::now();
    let mut gpus =
        choices.iter().map(|&c| Ok((c.name(), Gpu::open(c)?))).collect::<anyhow::Result<Vec<_>>>()?;
    let mut out = std::io::stdout().lock();
    if let Some((_, gpu)) = gpus.first_mut() {
        let (width, height, pixels) = film.strip(gpu)?;
        output.write_png(width, height, &pixels)?;
        let took = start.elapsed().as_secs_f64();
        let who = gpu.describe();
        writeln!(
            out,
            "{}: {} frames, {width}×{height}, drawn by {who} in {took:.2} s",
            args.output().display(),
            args.frames
        )?;
    }
    if args.steps > 0 {
        film.measure(&mut gpus, csv.as_ref(), &mut out)?;
    }
    Ok(())
}

struct Film<'a> {
    args: &'a FilmArgs,
    planet: &'static str,
    params: AtmosphereParams,
    kind: FilmKind,
    /// The sun's height during a climb, degrees.
    sun_elevation: f64,
    /// The camera's height during a day, metres.
    altitude: f64,
    sky: SkySettings,
}

impl<'a> Film<'a> {
    fn new(args: &'a FilmArgs) -> anyhow::Result<Self> {
        let (sun_elevation, altitude) = args.fixed()?;
        let planet = args.planet.or("earth");
        let mut sky = SkySettings::from(args.preset.quality());
        sky.look.sun_disk = false;
        let params = AtmosphereParams::preset(planet)?;
        Ok(Self { args, planet, params, kind: args.kind, sun_elevation, altitude, sky })
    }

    fn moment(&self, at: f64) -> Moment {
        match self.kind {
            FilmKind::Climb => {
                let [width, height] = self.args.size.map(f64::from);
                Moment::climb(&self.params, at, self.sun_elevation, width / height)
            }
            FilmKind::Day => Moment::day(self.altitude, at),
        }
    }

    fn frames(&self, at: Vec<f64>) -> Vec<Frame> {
        at.into_iter().map(|at| Frame { at, moment: self.moment(at) }).collect()
    }

    fn view(&self, moment: &Moment) -> View {
        // A climb has the sun to the right, so that the planet shows day and night. A day's sun sets ahead.
        let (heading, east) = if self.kind == FilmKind::Climb { (270.0, 330.0) } else { (270.0, 90.0) };
        View {
            planet: self.planet,
            altitude: moment.altitude,
            pitch: moment.pitch,
            heading,
            fov: moment.fov,
            sun_elevation: moment.sun_elevation,
            sun_azimuth: (east + moment.sun_azimuth) % 360.0,
            ..views::DEFAULT
        }
    }

    fn scene(&self, moment: &Moment, [width, height]: [u32; 2]) -> anyhow::Result<Scene> {
        Ok(self.view(moment).scene(Place::DEFAULT, f64::from(width) / f64::from(height), None)?)
    }

    /// What is under a frame.
    fn caption(&self, frame: &Frame) -> String {
        match self.kind {
            FilmKind::Climb => views::length(frame.at),
            FilmKind::Day => format!("sun {:.0}°", frame.moment.sun_elevation),
        }
    }

    /// The frames side by side, with terrain and the sun's disk: width, height and pixels.
    fn strip(&self, gpu: &mut Gpu) -> anyhow::Result<(u32, u32, Vec<[u8; 4]>)> {
        let [width, height] = self.args.size;
        let at = match self.kind {
            FilmKind::Climb => film::log_spaced(self.args.frames),
            FilmKind::Day => film::angles(self.args.frames),
        };
        let steps = Progress::new(at.len());
        let frames = self.frames(at).into_iter().map(|frame| {
            let caption = self.caption(&frame);
            let progress = steps.step(&caption);
            let view = self.view(&frame.moment);
            let terrain = view.terrain();
            let mut sky = self.sky;
            sky.look.sun_disk = true;
            let mut request = RenderRequest {
                scene: view.scene(Place::DEFAULT, f64::from(width) / f64::from(height), Some(&terrain))?,
                width,
                height,
                sky,
                exposure: self.args.exposure.unwrap_or(0.4) as f32,
                tone_map: ToneMap::Aces,
                dither: !self.args.no_dither,
                terrain: Some(terrain),
                radiance: Format::Rgba16Float,
            };
            let mut picture =
                gpu.draw(&request, &progress).with_context(|| format!("cannot draw {caption}"))?;
            if self.kind == FilmKind::Day && self.args.exposure.is_none() {
                request.exposure = adapted(&picture);
                picture = gpu.draw(&request, &progress).with_context(|| format!("cannot draw {caption}"))?;
            }
            let broken = picture.hdr.iter().flatten().filter(|v| !v.is_finite()).count();
            ensure!(broken == 0, "{caption}: {broken} values are not finite");
            Ok((caption, picture))
        });
        let frames = frames.collect::<anyhow::Result<Vec<_>>>()?;
        Ok(strip::strip(&frames))
    }

    /// Frames over black by every backend and by the reference, how far neighbours lie apart.
    fn measure(
        &self,
        gpus: &mut [(&'static str, Gpu)],
        csv: Option<&Destination>,
        out: &mut impl Write,
    ) -> anyhow::Result<()> {
        let at = match self.kind {
            FilmKind::Climb => film::altitudes(&self.params, self.args.steps + 1),
            FilmKind::Day => film::angles(self.args.steps + 1),
        };
        let frames = self.frames(at);
        let [width, height] = self.args.size;
        let size = [COMPARED_WIDTH, (COMPARED_WIDTH * height).div_ceil(width).clamp(2, 4 * COMPARED_WIDTH)];
        let scenes =
            frames.iter().map(|f| self.scene(&f.moment, size)).collect::<anyhow::Result<Vec<_>>>()?;
        let expected = self.expected(&scenes, size)?;
        let mut steps = Vec::new();
        for (name, gpu) in gpus.iter_mut() {
            let drawn = self.drawn(gpu, &scenes, size).with_context(|| format!("by {name}"))?;
            let pairs = drawn.windows(2).zip(expected.windows(2));
            let all =
                pairs.map(|(ours, want)| Step::between([&ours[0], &ours[1]], [&want[0], &want[1]])).collect();
            steps.push((*name, all));
        }
        self.report(&frames, &steps, size, out)?;
        csv.map_or(Ok(()), |file| file.write(|file| self.table(&frames, &steps, file)))
    }

    fn expected(&self, scenes: &[Scene], size: [u32; 2]) -> anyhow::Result<Vec<Vec<[f64; 3]>>> {
        let steps = Progress::of("reference", scenes.len() + 1);
        let mut cache = Cache::new(&self.args.cache);
        let settings = Settings::QUICK.for_medium(&self.params);
        let orders = cache.solve(&self.params, settings, &steps.step("solving"))?;
        cache.print_notes();
        ensure!(
            orders.converged(),
            "{}: the reference does not converge in so thick an atmosphere",
            self.planet
        );
        scenes
            .iter()
            .enumerate()
            .map(|(i, scene)| {
                // Lines for a hundred frames would say less than ten.
                let progress = (i % 40 == 0).then(|| steps.step(&format!("frames from {}", i + 1)));
                let expected = expected(scene, &orders, size);
                progress.iter().for_each(|progress| progress(1.0));
                expected
            })
            .collect()
    }

    fn drawn(&self, gpu: &mut Gpu, scenes: &[Scene], size: [u32; 2]) -> anyhow::Result<Vec<Vec<[f64; 3]>>> {
        let settings = PictureSettings {
            sky: self.sky,
            terrain: None,
            radiance: Format::Rgba32Float,
            ..PictureSettings::default()
        };
        let backend = device::current(gpu)?;
        let mut renderer = PictureRenderer::default();
        let frames = scenes.iter().map(|scene| {
            let drawn = renderer.draw(backend, scene, &settings, size)?;
            let pixels = backend.read(drawn.radiance)?;
            Ok(pixels.chunks_exact(4).map(|p| [p[0], p[1], p[2]].map(f64::from)).collect())
        });
        let frames = frames.collect::<anyhow::Result<Vec<_>>>();
        renderer.destroy(backend);
        frames
    }

    /// Where one kind of step ends and another begins: names, and the largest value of each.
    fn stretches(&self) -> Vec<(String, f64)> {
        let top = self.params.thickness();
        let mut all = match self.kind {
            FilmKind::Climb => vec![
                ("to 15 km".to_owned(), HAND_OVER.0),
                ("hand-over, to 50 km".to_owned(), HAND_OVER.1),
                (format!("to {}", views::length(0.95 * top)), 0.95 * top),
                (format!("top of the air, to {}", views::length(1.05 * top)), 1.05 * top),
                ("to 10,000 km".to_owned(), 1e7),
                ("to 1,000,000 km".to_owned(), f64::INFINITY),
            ],
            FilmKind::Day => {
                let names = [
                    "night, to -12°",
                    "dawn, to 0°",
                    "morning, to 90°",
                    "afternoon, to 0°",
                    "dusk, to -12°",
                    "night",
                ];
                let ends = [-12.0, 0.0, 90.0, 180.0, 192.0, f64::INFINITY];
                names.map(str::to_owned).into_iter().zip(ends).collect()
            }
        };
        // A thin shell's top lies below the end of the hand-over.
        all.sort_by(|a, b| a.1.total_cmp(&b.1));
        all
    }

    fn report(
        &self,
        frames: &[Frame],
        steps: &[(&str, Vec<Step>)],
        size: [u32; 2],
        out: &mut impl Write,
    ) -> anyhow::Result<()> {
        writeln!(
            out,
            "\n{} steps, {} × {} pixels, {}: largest change from one frame to the next, as % of each \
             channel's\n\
             brightest value, of the frame's mean and of a single value; off: of ours less the reference's\n",
            frames.len() - 1,
            size[0],
            size[1],
            self.args.preset.quality()
        )?;
        writeln!(
            out,
            "| backend | stretch | steps | mean: ours | reference | off | pixel: ours | reference | off | \
             worst at |"
        )?;
        writeln!(out, "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|")?;
        for (name, steps) in steps {
            let mut from = f64::NEG_INFINITY;
            for (stretch, to) in self.stretches() {
                let here: Vec<(&Frame, &Step)> =
                    frames[1..].iter().zip(steps).filter(|(f, _)| f.at > from && f.at <= to).collect();
                from = to;
                let Some((worst, _)) = here.iter().max_by(|a, b| a.1.pixel[2].total_cmp(&b.1.pixel[2]))
                else {
                    continue;
                };
                let most = |of: fn(&Step) -> [f64; 3]| -> [f64; 3] {
                    here.iter()
                        .map(|(_, s)| of(s))
                        .fold([0.0; 3], |m, v| std::array::from_fn(|k| m[k].max(v[k])))
                };
                let [mean, pixel] = [most(|s| s.mean), most(|s| s.pixel)]
                    .map(|v| v.map(|v| format!("{:.3}", 100.0 * v)).join(" | "));
                writeln!(
                    out,
                    "| {name} | {stretch} | {} | {mean} | {pixel} | {} |",
                    here.len(),
                    self.caption(worst)
                )?;
            }
        }
        Ok(())
    }

    fn table(
        &self,
        frames: &[Frame],
        steps: &[(&str, Vec<Step>)],
        file: &mut dyn Write,
    ) -> anyhow::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let at = if self.kind == FilmKind::Climb { ["from_m", "to_m"] } else { ["from_deg", "to_deg"] };
        let values = ["mean", "mean_reference", "mean_off", "pixel", "pixel_reference", "pixel_off"];
        writer.write_record(["backend"].iter().chain(&at).chain(&values))?;
        for (name, steps) in steps {
            for (pair, step) in frames.windows(2).zip(steps) {
                let at = [pair[0].at, pair[1].at].map(|v| v.to_string());
                let values = step.mean.iter().chain(&step.pixel).map(|v| format!("{v:.6e}"));
                writer.write_record(std::iter::once((*name).to_owned()).chain(at).chain(values))?;
            }
        }
        writer.flush()?;
        Ok(())
    }
}

/// An eye that adapts, but not quite: 0.25 / median^0.85 of the picture's luminance (Rec. 709), at most 1e6.
fn adapted(picture: &Picture) -> f32 {
    let mut luminance: Vec<f32> =
        picture.hdr.iter().map(|p| 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]).collect();
    luminance.sort_by(f32::total_cmp);
    let median = luminance.get(luminance.len() / 2).map_or(1.0, |v| f64::from(*v));
    (0.25 / median.max(1e-12).powf(0.85)).min(1e6) as f32
}

/// The reference's light of the air over black, through the middle of each pixel.
fn expected(scene: &Scene, orders: &Orders, size: [u32; 2]) -> anyhow::Result<Vec<[f64; 3]>> {
    let view = scene.validate()?;
    let [width, height] = size;
    let light = |i: u32| {
        let light = reference::inscatter(orders, &reference::pixel_ray(&view, [i % width, i / width], size))?;
        Ok(light.map(|v| v * scene.atmosphere.sun_intensity))
    };
    (0..width * height).into_par_iter().map(light).collect::<welkin::Result<_>>().map_err(Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_camera_moves_without_a_jump_and_ends_with_the_planet_in_its_picture() {
        for planet in AtmosphereParams::PRESETS {
            let params = AtmosphereParams::preset(planet).unwrap();
            let at = film::log_spaced(4000);
            assert_eq!((at[0], at[3999]), (film::CLIMB[0], film::CLIMB[1]));
            let moments: Vec<_> = at.iter().map(|&h| Moment::climb(&params, h, 25.0, 2.0 / 3.0)).collect();
            for (pair, h) in moments.windows(2).zip(&at) {
                let turned = (pair[1].pitch - pair[0].pitch).abs();
                assert!(turned < 0.2 && (pair[1].fov - pair[0].fov).abs() < 0.4, "{planet}, {h} m: {pair:?}");
            }
            let last = moments[3999];
            let planet_wide = 2.0 * (params.planet_radius / (params.planet_radius + 1e9)).asin().to_degrees();
            assert!(last.pitch == -90.0 && last.fov * 2.0 / 3.0 > 1.1 * planet_wide, "{planet}: {last:?}");
        }
        let day: Vec<_> = film::angles(23).into_iter().map(|a| Moment::day(2.0, a)).collect();
        assert_eq!((day[0].sun_elevation, day[22].sun_elevation), (film::NIGHT, film::NIGHT));
        assert!(day.iter().any(|m| m.sun_elevation == 90.0) && day.iter().all(|m| m.sun_elevation <= 90.0));
    }

    #[test]
    fn altitudes_are_dense_where_something_hands_over() {
        let params = AtmosphereParams::earth();
        let all = film::altitudes(&params, 241);
        let within = |low: f64, high: f64| all.iter().filter(|h| (low..=high).contains(*h)).count();
        assert!((235..=241).contains(&all.len()) && all.is_sorted());
        assert!(within(14e3, 51e3) >= 60 && within(9e4, 1.11e5) >= 60, "{all:?}");
    }

    #[test]
    fn a_step_is_compared_with_the_references() {
        let dark = vec![[0.0, 0.0, 0.0], [1.0, 2.0, 4.0]];
        let light = vec![[0.5, 0.0, 0.0], [1.0, 2.0, 4.0]];
        let same = Step::between([&dark, &light], [&dark, &light]);
        assert_eq!(same, Step { mean: [0.5 / 6.0, 0.5 / 6.0, 0.0], pixel: [0.5, 0.5, 0.0] });
        // The same size the other way is off by both.
        let wrong = Step::between([&light, &dark], [&dark, &light]);
        assert_eq!(wrong.pixel, [0.5, 0.5, 1.0]);
        // Of the channel's own brightest value.
        let popped = vec![[0.0, 0.0, 0.0], [1.0, 2.0, 4.4]];
        let pop = Step::between([&dark, &popped], [&dark, &dark]);
        assert!((pop.pixel[2] - 0.1).abs() < 1e-12 && pop.pixel[1] == 0.0, "{pop:?}");
    }
}
