//! `welkin radiance`: radiance in given directions, from a CSV table to a CSV table.

use std::collections::HashMap;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use clap::{Args, ValueEnum};
use csv::StringRecord;
use glam::DVec3;
use rayon::prelude::*;
use welkin::gpu::{Backend, Format, Pass, Target, TextureDesc, TextureId};
use welkin::reference::multiple::Settings;
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{
    AerialTargets, AtmosphereParams, Camera, DepthConvention, FrameTargets, Quality, Scene, SkyRenderer,
    SkySettings,
};

use crate::args::backend::{self, BackendArgs, BackendChoice};
use crate::args::cache::CacheArgs;
use crate::args::output::{self, OutputArgs};
use crate::args::quality::{PresetArgs, SamplesArgs, march};
use crate::args::usage::UsageError;
use crate::cache::Cache;
use crate::gpu::{self, Gpu};
use crate::output::Destination;
use crate::progress::Progress;

const RADIANCE_ABOUT: &str = "\
Compute the sky's radiance in given directions, from a table to a table

Radiance is per unit of the sun's irradiance at the top of the atmosphere on a plane normal to the sun: \
1/sr. Multiply it by the sun's irradiance. The sun's disk is never part of it; the sun is a point, \
nothing is refracted or polarised. R, G, B are the medium's three channels (earth: 680, 550, 440 nm).";

const RADIANCE_DETAILS: &str = "\
The table of cases is CSV with a header. Columns, found by name, in any order:
  medium                earth, rayleigh, mars, venus or earth-like
  albedo                fraction of light that the ground reflects
                        (Lambertian), 0 to 1
  altitude_m            of the observer above the ground, 0 to 1e12
  sun_zenith_deg        angle of the sun from the zenith, 0 to 180
  view_zenith_deg       angle of the view from the zenith, 0 to 180
  azimuth_from_sun_deg  of the view, 0 towards the sun, -360 to 360
Other columns are copied. The output adds the columns R, G and B.

What is included:
  lut               light of all orders of scattering from LUTs, by a GPU
                    backend, as the default of 'welkin render'. A ray that
                    meets the ground sees it black, but the air is lit by its
                    albedo.
  single            light scattered once by the air, by a GPU backend, through
                    the passes that draw pictures, in 32-bit floats. A ray
                    that meets the ground ends there and sees it black; the
                    albedo has no influence.
  reference-single  the same light in f64 on the CPU, relative error 1e-6.
  reference         light of all orders of scattering in f64 on the CPU, with
                    the light that the ground reflects: into the air, and to
                    the eye where a ray meets the ground. About 0.2 % by day,
                    0.5 % in twilight. Solves once for each medium and albedo,
                    up to some minutes each, and keeps the solution: up to 11
                    MB each.

Example:
  welkin radiance --cases sky.csv --method single --samples 256 --light-samples 64 -o radiance.csv

Exit status: 0 written; 1 computing or writing failed; 2 the request or a row
was not accepted, and nothing was written.";

/// Options of `welkin radiance`.
#[derive(Args, Debug)]
#[command(after_long_help = RADIANCE_DETAILS, long_about = RADIANCE_ABOUT)]
#[command(after_help = "Columns, and what each method includes: welkin radiance --help")]
#[command(mut_arg("quality", |arg| arg.hide_possible_values(true).help(
    "Sizes of the LUTs, for --method lut: low, medium, high [default: medium]"
)))]
#[command(mut_arg("samples", |arg| arg.help(
    "Samples along each view ray, 1 to 1024; for --method single [default: 32]"
)))]
#[command(mut_arg("light_samples", |arg| arg.help(
    "Samples from each of those towards the sun, 1 to 256; for --method single [default: 8]"
)))]
#[command(mut_arg("backend", |arg| arg.help("What draws; only for a method that draws")))]
#[command(mut_arg("output", |arg| arg.help("Where to write (CSV)").required(true)))]
pub struct RadianceArgs {
    /// The table of cases (CSV)
    #[arg(long, value_name = "FILE")]
    cases: PathBuf,

    /// How to compute
    #[arg(long, value_name = "NAME")]
    method: RadianceMethod,

    #[command(flatten)]
    preset: PresetArgs,

    #[command(flatten)]
    backend: BackendArgs,

    #[command(flatten)]
    samples: SamplesArgs,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    cache: CacheArgs,
}

/// How radiance is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RadianceMethod {
    /// Single scattering by a GPU backend
    Single,
    /// All orders of scattering by a GPU backend, from LUTs
    Lut,
    /// Single scattering in f64
    ReferenceSingle,
    /// All orders of scattering in f64
    Reference,
}

impl RadianceArgs {
    /// How the sky is drawn, by a method that draws.
    fn drawn_by(&self) -> Result<Quality, UsageError> {
        if self.method == RadianceMethod::Single {
            return Ok(march(self.samples.or_default()));
        }
        let quality = self.preset.quality();
        if quality.is_single_scattering() {
            let allowed = "low, medium or high with '--method lut': the others march single scattering";
            return Err(UsageError::value("--quality <NAME>", quality.preset_name().unwrap_or("?"), allowed));
        }
        Ok(quality)
    }
}

/// What is asked of each case, in the order of [`Case::new`].
const COLUMNS: [&str; 6] =
    ["medium", "albedo", "altitude_m", "sun_zenith_deg", "view_zenith_deg", "azimuth_from_sun_deg"];
/// What the answer adds.
const CHANNELS: [&str; 3] = ["R", "G", "B"];
/// Cases that are drawn at a time.
const BATCH: usize = 256;

/// One direction of view under one sky.
#[derive(Clone, Debug)]
struct Case {
    medium: String,
    atmosphere: AtmosphereParams,
    altitude: f64,
    sun_zenith: f64,
    view_zenith: f64,
    azimuth: f64,
}

/// The cases, and what of the file is copied.
struct Table {
    header: StringRecord,
    rows: Vec<StringRecord>,
    cases: Vec<Case>,
}

/// Checks everything, then computes, then writes.
pub fn run(args: &RadianceArgs) -> anyhow::Result<()> {
    let draws = matches!(args.method, RadianceMethod::Single | RadianceMethod::Lut);
    let backend = args.backend.backend;
    if draws {
        args.backend
            .gpu("it draws with '--method single' or 'lut'; on the CPU use '--method reference-single'")?;
    }
    if !draws && matches!(backend, BackendChoice::WebGpu | BackendChoice::WebGl2) {
        let allowed = "auto or cpu with a reference: it is computed on the CPU";
        return Err(UsageError::value(backend::OPTION, backend.name(), allowed).into());
    }
    let method = if draws { Some(args.drawn_by()?) } else { None };
    let table = Table::read(&args.cases)?;
    let path = args.output.path_or("");
    let destination = Destination::new(path, output::OPTION)?;
    let start = std::time::Instant::now();
    let (radiance, by) = if let Some(method) = method {
        drawn(backend, method, &table.cases)?
    } else if args.method == RadianceMethod::ReferenceSingle {
        (reference_single(&table.cases)?, "f64 reference, single scattering".to_owned())
    } else {
        let mut cache = Cache::new(&args.cache);
        let radiance = reference(&table.cases, &mut cache);
        cache.print_notes();
        (radiance?, format!("f64 reference, all orders{}", cache.summary()))
    };
    for (row, (record, light)) in table.rows.iter().zip(&radiance).enumerate() {
        ensure!(
            light.iter().all(|v| v.is_finite()),
            "row {} (line {}) came out as {light:?}, which is not finite",
            row + 1,
            line_of(record)
        );
    }
    destination.write(|file| table.write(&radiance, file))?;
    writeln!(
        std::io::stdout(),
        "{}: {} cases, {by}, in {:.2} s",
        path.display(),
        radiance.len(),
        start.elapsed().as_secs_f64()
    )?;
    Ok(())
}

fn line_of(record: &StringRecord) -> u64 {
    record.position().map_or(0, csv::Position::line)
}

impl Table {
    /// Reads and checks every row; the error names file, line, column, value and what is allowed.
    fn read(path: &Path) -> Result<Self, UsageError> {
        let name = path.display();
        let file = File::open(path).map_err(|e| {
            UsageError::value("--cases <FILE>", path.display(), format_args!("a file that can be read: {e}"))
        })?;
        // `flexible`: a row of the wrong length is reported below, with what was expected.
        let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(file);
        let broken = |e: csv::Error| {
            let line = e.position().map_or(1, csv::Position::line);
            UsageError::new(format!("{name}, line {line}: not a row of UTF-8 CSV: {e}"))
        };
        let mut header = reader.headers().map_err(broken)?.clone();
        if let Some(first) = header.get(0).and_then(|first| first.strip_prefix('\u{feff}')) {
            // A spreadsheet's byte order mark is no part of the first name.
            header = std::iter::once(first).chain(header.iter().skip(1)).collect();
        }
        let mut at = [0; COLUMNS.len()];
        for (column, at) in COLUMNS.iter().zip(&mut at) {
            let mut found = header.iter().enumerate().filter(|(_, h)| h.trim() == *column);
            let expected = COLUMNS.join(", ");
            *at = found.next().map(|(i, _)| i).ok_or_else(|| {
                UsageError::new(format!(
                    "{name}, line 1: no column '{column}'; the columns needed are {expected}"
                ))
            })?;
            if found.next().is_some() {
                return Err(UsageError::new(format!("{name}, line 1: column '{column}' is there twice")));
            }
        }
        if let Some(taken) = header.iter().find(|h| CHANNELS.contains(&h.trim())) {
            return Err(UsageError::new(format!(
                "{name}, line 1: column '{taken}' is one that the output adds; rename it"
            )));
        }
        let (mut rows, mut cases) = (Vec::new(), Vec::new());
        for record in reader.records() {
            let record = record.map_err(broken)?;
            let line = line_of(&record);
            if record.len() != header.len() {
                return Err(UsageError::new(format!(
                    "{name}, line {line}: {} values, but the header has {} columns",
                    record.len(),
                    header.len()
                )));
            }
            let values = at.map(|i| record.get(i).unwrap_or_default().trim());
            cases.push(Case::new(values).map_err(|e| UsageError::new(format!("{name}, line {line}: {e}")))?);
            rows.push(record);
        }
        Ok(Self { header, rows, cases })
    }

    fn write(&self, radiance: &[[f64; 3]], file: &mut dyn Write) -> anyhow::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(self.header.iter().chain(CHANNELS))?;
        for (row, light) in self.rows.iter().zip(radiance) {
            let light = light.map(|v| format!("{v:.8e}"));
            writer.write_record(row.iter().chain(light.iter().map(String::as_str)))?;
        }
        writer.flush()?;
        Ok(())
    }
}

impl Case {
    /// From the values of [`COLUMNS`].
    fn new([medium, albedo, altitude, sun_zenith, view_zenith, azimuth]: [&str; 6]) -> Result<Self, String> {
        if !AtmosphereParams::PRESETS.contains(&medium) {
            return Err(format!("medium '{medium}' must be one of {}", AtmosphereParams::PRESETS.join(", ")));
        }
        let mut atmosphere = AtmosphereParams::preset(medium).map_err(|e| e.to_string())?;
        atmosphere.ground_albedo = [number("albedo", albedo, 0.0, 1.0)?; 3];
        atmosphere.sun_intensity = 1.0;
        Ok(Self {
            medium: medium.to_owned(),
            atmosphere,
            altitude: number("altitude_m", altitude, 0.0, 1e12)?,
            sun_zenith: number("sun_zenith_deg", sun_zenith, 0.0, 180.0)?.to_radians(),
            view_zenith: number("view_zenith_deg", view_zenith, 0.0, 180.0)?.to_radians(),
            azimuth: number("azimuth_from_sun_deg", azimuth, -360.0, 360.0)?.to_radians(),
        })
    }

    fn query(&self) -> RayQuery {
        RayQuery::new(self.altitude, self.view_zenith, self.sun_zenith, self.azimuth)
    }

    /// A camera whose picture's middle looks in the case's direction.
    fn scene(&self) -> Scene {
        let RayQuery { direction, sun, .. } = self.query();
        let position = DVec3::Z * (self.atmosphere.planet_radius + self.altitude);
        Scene {
            camera: Camera::new(position, direction, direction.any_orthonormal_vector(), 1e-3, 1.0),
            planet_center: DVec3::ZERO,
            atmosphere: self.atmosphere.clone(),
            sun_direction: sun,
            depth: DepthConvention::default(),
            moon: None,
        }
    }
}

/// A finite number in `lo..=hi`.
fn number(column: &str, text: &str, lo: f64, hi: f64) -> Result<f64, String> {
    let value: f64 = text.parse().unwrap_or(f64::NAN);
    let allowed = (lo..=hi).contains(&value);
    allowed.then_some(value).ok_or_else(|| format!("{column} '{text}' must be a number from {lo} to {hi}"))
}

/// Radiance through the passes of a picture: the background sky, then the air before an empty scene.
fn drawn(choice: BackendChoice, quality: Quality, cases: &[Case]) -> anyhow::Result<(Vec<[f64; 3]>, String)> {
    let mut gpu = Gpu::open(choice)?;
    let by = format!("{quality} by {}", gpu.describe());
    let Some(backend) = gpu.backend() else {
        anyhow::bail!("no backend can draw here: {by}; '--method reference-single' needs none");
    };
    gpu::check_samples(backend.info(), &quality)?;
    let mut settings = SkySettings::from(quality);
    settings.look.sun_disk = false;
    let mut sky = SkyRenderer::new(settings)?;
    let steps = Progress::of("drawing", cases.len().div_ceil(BATCH));
    let mut textures = Textures { made: Vec::new(), pixels: Vec::new() };
    // LUTs are made anew for each medium, and what is not drawn by then would lose them.
    let radiance = cases
        .chunk_by(|a, b| a.medium == b.medium)
        .flat_map(|cases| cases.chunks(BATCH))
        .map(|batch| {
            let _ = steps.step(&format!("{} cases", batch.len()));
            textures.draw(backend, &mut sky, batch)
        })
        .collect::<anyhow::Result<Vec<_>>>();
    sky.destroy(backend);
    textures.made.iter().for_each(|&id| backend.destroy_texture(id));
    Ok((radiance?.concat(), by))
}

/// Pictures of one pixel.
struct Textures {
    made: Vec<TextureId>,
    /// Before and after the air is laid over.
    pixels: Vec<[TextureId; 2]>,
}

impl Textures {
    fn make(&mut self, backend: &mut dyn Backend, format: Format) -> welkin::Result<TextureId> {
        let id = backend.create_texture(&TextureDesc::new("radiance", 1, 1, format))?;
        self.made.push(id);
        Ok(id)
    }

    fn draw(
        &mut self,
        backend: &mut dyn Backend,
        sky: &mut SkyRenderer,
        cases: &[Case],
    ) -> anyhow::Result<Vec<[f64; 3]>> {
        let depth = self.made.first().copied();
        let depth = depth.map_or_else(|| self.make(backend, Format::Depth32Float), Ok)?;
        while self.pixels.len() < cases.len() {
            let pixel = [self.make(backend, Format::Rgba32Float)?, self.make(backend, Format::Rgba32Float)?];
            self.pixels.push(pixel);
        }
        let mut passes = Vec::new();
        let mut results = Vec::with_capacity(cases.len());
        for (case, &[behind, front]) in cases.iter().zip(&self.pixels) {
            let scene = case.scene();
            let clear = Target {
                color: behind,
                depth: Some(depth),
                clear: Some([0.0; 4]),
                clear_depth: Some(scene.depth.background() as f32),
                ..Target::color(behind)
            };
            let aerial = AerialTargets { color: Some(behind), depth, target: Target::color(front) };
            let targets = FrameTargets::background(Target::color(behind)).with_aerial(aerial);
            let frame = sky.frame(backend, &scene, &targets)?;
            results.push(if frame.aerial.is_empty() { behind } else { front });
            passes.clear();
            passes.push(Pass::clear("clear", clear));
            passes.extend_from_slice(frame.background);
            passes.extend_from_slice(frame.aerial);
            // LUTs that are made by now are not made again for the next case.
            backend.run(&passes).context("draw")?;
        }
        let reads = results.iter().map(|&id| backend.begin_read(id)).collect::<welkin::Result<Vec<_>>>()?;
        backend.wait().context("wait")?;
        reads
            .into_iter()
            .map(|read| {
                let texel = backend.poll_read(&read)?.context("this backend cannot wait for the GPU")?;
                ensure!(texel.len() == 4, "a pixel of {} values came back", texel.len());
                Ok([texel[0], texel[1], texel[2]].map(f64::from))
            })
            .collect()
    }
}

fn reference_single(cases: &[Case]) -> anyhow::Result<Vec<[f64; 3]>> {
    let light = |case: &Case| {
        let light = single_scattering(&case.atmosphere, &case.query(), Sun::Point, Tolerance::TRUTH)?;
        Ok(light.per_irradiance)
    };
    cases.par_iter().map(light).collect()
}

/// Cases of one medium and albedo share one solution.
fn reference(cases: &[Case], cache: &mut Cache) -> anyhow::Result<Vec<[f64; 3]>> {
    let mut groups: Vec<(&Case, Vec<usize>)> = Vec::new();
    let mut known = HashMap::new();
    for (i, case) in cases.iter().enumerate() {
        let key = (case.medium.as_str(), case.atmosphere.ground_albedo[0].to_bits());
        let group = *known.entry(key).or_insert_with(|| {
            groups.push((case, Vec::new()));
            groups.len() - 1
        });
        groups[group].1.push(i);
    }
    let steps = Progress::of("solving", groups.len());
    let mut radiance = vec![[0.0; 3]; cases.len()];
    for (first, members) in groups {
        let progress = steps.step(&format!("{}, albedo {}", first.medium, first.atmosphere.ground_albedo[0]));
        let settings = Settings::FINE.for_medium(&first.atmosphere);
        let orders = cache.solve(&first.atmosphere, settings, &progress)?;
        ensure!(
            orders.converged(),
            "{}: the reference does not converge in so thick an atmosphere; reference-single is what can \
             be had",
            first.medium
        );
        let solved: Vec<_> = members
            .par_iter()
            .map(|&i| Ok((i, orders.radiance(&cases[i].query(), Tolerance::TRUTH)?.per_irradiance)))
            .collect::<welkin::Result<_>>()?;
        solved.into_iter().for_each(|(i, light)| radiance[i] = light);
    }
    Ok(radiance)
}
