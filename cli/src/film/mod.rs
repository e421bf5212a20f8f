//! `welkin film`: a climb to a million kilometres or a day as a strip of frames, and how smoothly they follow.

pub mod path;

use std::io::Write;
use std::time::Instant;

use anyhow::{Context, ensure};
use glam::DVec2;
use rayon::prelude::*;
use welkin::gpu::Format;
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{RayQuery, Tolerance};
use welkin::render::sky::HAND_OVER;
use welkin::{AtmosphereParams, PictureRenderer, PictureSettings, Scene, SkySettings, ToneMap};

use crate::args::{FilmArgs, FilmKind};
use crate::cache::Cache;
use crate::draw::{self, BackendChoice, Drawer, Picture, Shot};
use crate::info;
use crate::output::{Destination, Output};
use crate::progress::Progress;
use crate::sheet;
use crate::views::{self, Place, View};
use path::{Moment, Step};

/// Pixels across the frames that are compared with the reference.
const JUDGED_WIDTH: u32 = 12;

/// One frame and what names it.
struct Frame {
    /// Metres, or degrees along the sun's way.
    at: f64,
    moment: Moment,
}

/// Checks everything, then draws the strip, then measures.
pub fn run(args: &FilmArgs) -> anyhow::Result<()> {
    let film = Film::new(args)?;
    let output = Output::new(&args.output, true)?;
    let csv = args.csv.as_deref().map(|path| Destination::new(path, "--csv <FILE>")).transpose()?;
    let mut choices = match args.backend() {
        Some(choice) => vec![choice],
        None => draw::available(),
    };
    choices.retain(|c| *c != BackendChoice::Cpu);
    ensure!(!choices.is_empty(), "no GPU backend can be had here ('welkin info' says why)");
    let start = Instant::now();
    let mut drawers =
        choices.iter().map(|&c| Ok((info::name(c), Drawer::open(c)?))).collect::<anyhow::Result<Vec<_>>>()?;
    let mut out = std::io::stdout().lock();
    if let Some((_, drawer)) = drawers.first_mut() {
        let (width, height, pixels) = film.strip(drawer)?;
        output.write_png(width, height, &pixels)?;
        let took = start.elapsed().as_secs_f64();
        let who = drawer.describe();
        writeln!(
            out,
            "{}: {} frames, {width}×{height}, drawn by {who} in {took:.2} s",
            args.output.display(),
            args.frames
        )?;
    }
    if args.steps > 0 {
        film.measure(&mut drawers, csv.as_ref(), &mut out)?;
    }
    Ok(())
}

struct Film<'a> {
    args: &'a FilmArgs,
    planet: &'static str,
    params: AtmosphereParams,
    kind: FilmKind,
    /// Of a climb, degrees.
    sun_elevation: f64,
    /// Of a day, metres.
    altitude: f64,
    sky: SkySettings,
}

impl<'a> Film<'a> {
    fn new(args: &'a FilmArgs) -> anyhow::Result<Self> {
        let (sun_elevation, altitude) = args.fixed()?;
        let planet = args.planet();
        let sky = SkySettings { sun_disk: false, ..args.quality().into() };
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
    fn strip(&self, drawer: &mut Drawer) -> anyhow::Result<(u32, u32, Vec<[u8; 4]>)> {
        let [width, height] = self.args.size;
        let at = match self.kind {
            FilmKind::Climb => path::log_spaced(self.args.frames),
            FilmKind::Day => path::angles(self.args.frames),
        };
        let progress = Progress::new(at.len());
        let frames = self.frames(at).into_iter().map(|frame| {
            let caption = self.caption(&frame);
            let tell = progress.step(&caption);
            let view = self.view(&frame.moment);
            let terrain = view.terrain();
            let mut shot = Shot {
                scene: view.scene(Place::DEFAULT, f64::from(width) / f64::from(height), Some(&terrain))?,
                width,
                height,
                sky: SkySettings { sun_disk: true, ..self.sky },
                exposure: self.args.exposure.unwrap_or(0.4) as f32,
                tone_map: ToneMap::Aces,
                dither: !self.args.no_dither,
                terrain: Some(terrain),
            };
            let mut picture = drawer.draw(&shot, &tell).with_context(|| format!("cannot draw {caption}"))?;
            if self.kind == FilmKind::Day && self.args.exposure.is_none() {
                shot.exposure = adapted(&picture);
                picture = drawer.draw(&shot, &tell).with_context(|| format!("cannot draw {caption}"))?;
            }
            let broken = picture.hdr.iter().flatten().filter(|v| !v.is_finite()).count();
            ensure!(broken == 0, "{caption}: {broken} values are not finite");
            Ok((caption, picture))
        });
        let frames = frames.collect::<anyhow::Result<Vec<_>>>()?;
        Ok(sheet::strip(&frames))
    }

    /// Frames over black by every backend and by the reference, how far neighbours lie apart.
    fn measure(
        &self,
        drawers: &mut [(String, Drawer)],
        csv: Option<&Destination>,
        out: &mut impl Write,
    ) -> anyhow::Result<()> {
        let at = match self.kind {
            FilmKind::Climb => path::altitudes(&self.params, self.args.steps + 1),
            FilmKind::Day => path::angles(self.args.steps + 1),
        };
        let frames = self.frames(at);
        let [width, height] = self.args.size;
        let size = [JUDGED_WIDTH, (JUDGED_WIDTH * height).div_ceil(width).clamp(2, 4 * JUDGED_WIDTH)];
        let scenes = frames.iter().map(|f| self.scene(&f.moment, size)).collect::<anyhow::Result<Vec<_>>>()?;
        let truths = self.truths(&scenes, size)?;
        let mut steps = Vec::new();
        for (name, drawer) in drawers.iter_mut() {
            let drawn = self.drawn(drawer, &scenes, size).with_context(|| format!("by {name}"))?;
            let pairs = drawn.windows(2).zip(truths.windows(2));
            let all = pairs.map(|(ours, truth)| Step::between([&ours[0], &ours[1]], [&truth[0], &truth[1]])).collect();
            steps.push((name.clone(), all));
        }
        self.report(&frames, &steps, size, out)?;
        csv.map_or(Ok(()), |file| file.write(|file| self.table(&frames, &steps, file)))
    }

    fn truths(&self, scenes: &[Scene], size: [u32; 2]) -> anyhow::Result<Vec<Vec<[f64; 3]>>> {
        let progress = Progress::of("reference", scenes.len() + 1);
        let mut cache = Cache::new(&self.args.cache);
        let settings = Settings::QUICK.for_medium(&self.params);
        let tell = progress.step("solving");
        let orders = cache.solve(&self.params, settings, |p| {
            tell((p.change.max(1e-300).ln() / settings.tolerance.ln()) as f32);
        })?;
        cache.tell();
        ensure!(orders.converged(), "{}: the reference does not converge in so thick an atmosphere", self.planet);
        scenes
            .iter()
            .enumerate()
            .map(|(i, scene)| {
                // Lines for a hundred frames would say less than ten.
                let tell = (i % 40 == 0).then(|| progress.step(&format!("frames from {}", i + 1)));
                let truth = truth(scene, &orders, size);
                tell.iter().for_each(|tell| tell(1.0));
                truth
            })
            .collect()
    }

    fn drawn(&self, drawer: &mut Drawer, scenes: &[Scene], size: [u32; 2]) -> anyhow::Result<Vec<Vec<[f64; 3]>>> {
        let settings = PictureSettings {
            sky: self.sky,
            terrain: None,
            radiance: Format::Rgba32Float,
            ..PictureSettings::default()
        };
        drawer.make_current()?;
        let backend = drawer.backend().context("no GPU backend")?;
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
                let names =
                    ["night, to -12°", "dawn, to 0°", "morning, to 90°", "afternoon, to 0°", "dusk, to -12°", "night"];
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
        steps: &[(String, Vec<Step>)],
        size: [u32; 2],
        out: &mut impl Write,
    ) -> anyhow::Result<()> {
        writeln!(
            out,
            "\n{} steps, {} × {} pixels, {}: largest change from one frame to the next, as % of each channel's\n\
             brightest value, of the frame's mean and of a single value; off: of ours less the reference's\n",
            frames.len() - 1,
            size[0],
            size[1],
            self.args.quality()
        )?;
        writeln!(
            out,
            "| backend | stretch | steps | mean: ours | reference | off | pixel: ours | reference | off | worst at |"
        )?;
        writeln!(out, "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|")?;
        for (name, steps) in steps {
            let mut from = f64::NEG_INFINITY;
            for (stretch, to) in self.stretches() {
                let here: Vec<(&Frame, &Step)> =
                    frames[1..].iter().zip(steps).filter(|(f, _)| f.at > from && f.at <= to).collect();
                from = to;
                let Some((worst, _)) = here.iter().max_by(|a, b| a.1.pixel[2].total_cmp(&b.1.pixel[2])) else {
                    continue;
                };
                let most = |of: fn(&Step) -> [f64; 3]| -> [f64; 3] {
                    here.iter().map(|(_, s)| of(s)).fold([0.0; 3], |m, v| std::array::from_fn(|k| m[k].max(v[k])))
                };
                let [mean, pixel] =
                    [most(|s| s.mean), most(|s| s.pixel)].map(|v| v.map(|v| format!("{:.3}", 100.0 * v)).join(" | "));
                writeln!(out, "| {name} | {stretch} | {} | {mean} | {pixel} | {} |", here.len(), self.caption(worst))?;
            }
        }
        Ok(())
    }

    fn table(&self, frames: &[Frame], steps: &[(String, Vec<Step>)], file: &mut dyn Write) -> anyhow::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let at = if self.kind == FilmKind::Climb { ["from_m", "to_m"] } else { ["from_deg", "to_deg"] };
        let values = ["mean", "mean_reference", "mean_off", "pixel", "pixel_reference", "pixel_off"];
        writer.write_record(["backend"].iter().chain(&at).chain(&values))?;
        for (name, steps) in steps {
            for (pair, step) in frames.windows(2).zip(steps) {
                let at = [pair[0].at, pair[1].at].map(|v| v.to_string());
                let values = step.mean.iter().chain(&step.pixel).map(|v| format!("{v:.6e}"));
                writer.write_record(std::iter::once(name.clone()).chain(at).chain(values))?;
            }
        }
        writer.flush()?;
        Ok(())
    }
}

/// An eye that adapts, but not quite: 0.25 / median^0.85 of the picture's luminance (Rec. 709), at most 1e6.
fn adapted(picture: &Picture) -> f32 {
    let mut luminance: Vec<f32> = picture.hdr.iter().map(|p| 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]).collect();
    luminance.sort_by(f32::total_cmp);
    let median = luminance.get(luminance.len() / 2).map_or(1.0, |v| f64::from(*v));
    (0.25 / median.max(1e-12).powf(0.85)).min(1e6) as f32
}

/// The reference's light of the air over black, through the middle of each pixel.
fn truth(scene: &Scene, orders: &Orders, [width, height]: [u32; 2]) -> anyhow::Result<Vec<[f64; 3]>> {
    let view = scene.validate()?;
    let sun = scene.atmosphere.sun_intensity;
    let light = |i: u32| {
        let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
        let ndc = DVec2::new(share(i % width, width), -share(i / width, height));
        let direction = view.basis.ray(ndc).normalize();
        let query = RayQuery { altitude: view.altitude, direction, sun: view.sun, length: f64::INFINITY, moon: None };
        let light = orders.radiance(&query, Tolerance { relative: 1e-4 })?;
        Ok(std::array::from_fn(|c| (light.per_irradiance[c] - light.ground[c]) * sun))
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
            let at = path::log_spaced(4000);
            assert_eq!((at[0], at[3999]), (path::CLIMB[0], path::CLIMB[1]));
            let moments: Vec<_> = at.iter().map(|&h| Moment::climb(&params, h, 25.0, 2.0 / 3.0)).collect();
            for (pair, h) in moments.windows(2).zip(&at) {
                let turned = (pair[1].pitch - pair[0].pitch).abs();
                assert!(turned < 0.2 && (pair[1].fov - pair[0].fov).abs() < 0.4, "{planet}, {h} m: {pair:?}");
            }
            let last = moments[3999];
            let planet_wide = 2.0 * (params.planet_radius / (params.planet_radius + 1e9)).asin().to_degrees();
            assert!(last.pitch == -90.0 && last.fov * 2.0 / 3.0 > 1.1 * planet_wide, "{planet}: {last:?}");
        }
        let day: Vec<_> = path::angles(23).into_iter().map(|a| Moment::day(2.0, a)).collect();
        assert_eq!((day[0].sun_elevation, day[22].sun_elevation), (path::NIGHT, path::NIGHT));
        assert!(day.iter().any(|m| m.sun_elevation == 90.0) && day.iter().all(|m| m.sun_elevation <= 90.0));
    }

    #[test]
    fn altitudes_are_dense_where_something_hands_over() {
        let params = AtmosphereParams::earth();
        let all = path::altitudes(&params, 241);
        let within = |low: f64, high: f64| all.iter().filter(|h| (low..=high).contains(*h)).count();
        assert!((235..=241).contains(&all.len()) && all.is_sorted());
        assert!(within(14e3, 51e3) >= 60 && within(9e4, 1.11e5) >= 60, "{all:?}");
    }

    #[test]
    fn a_step_is_judged_by_the_references() {
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
