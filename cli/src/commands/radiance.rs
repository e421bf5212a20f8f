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
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering, transmittance};
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
use crate::medium;
use crate::output::Destination;
use crate::progress::Progress;

const RADIANCE_ABOUT: &str = "\
Compute the sky's radiance in given directions, from a table to a table

Radiance is per unit of the sun's irradiance at the top of the atmosphere on a plane normal to the sun: \
1/sr. Multiply it by the sun's irradiance. The sun's disk is never part of it; the sun is a point, \
nothing is refracted or polarised. R, G, B are the medium's three channels (earth: 680, 550, 440 nm).";

const RADIANCE_DETAILS: &str = "\
The table of cases is CSV with a header. Columns, found by name, in any order:
  medium                earth, rayleigh, mars, venus or earth-like, or a
                        TOML file in the table's folder, as haze.toml, see
                        below
  albedo                fraction of light that the ground reflects
                        (Lambertian), 0 to 1
  altitude_m            of the observer, from the lowest ground's (0 of the
                        presets) to 1e12
  sun_zenith_deg        angle of the sun from the zenith, 0 to 180
  view_zenith_deg       angle of the view from the zenith, 0 to 180
  azimuth_from_sun_deg  of the view, 0 towards the sun, -360 to 360
  distance_m            of a black surface that ends the ray, 1e-3 to 1e12,
                        or nothing where there is none; may be left out
Other columns are copied. The output adds the columns R, G and B, and with
distance_m also T_R, T_G and T_B: the transmittance of the air up to the
surface (or the ray's end), 0 to 1.

A medium's file has the fields of the library's AtmosphereParams by their
names, in SI units; 'base' names the preset that has the others:
  base = \"earth\"
  mie_scattering = [1.6e-3, 1.6e-3, 1.6e-3]   # 1/m
  mie_asymmetry = [0.7, 0.7, 0.7]

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
/// What may be asked besides.
const DISTANCE: &str = "distance_m";
/// What the answer adds: the light, and with [`DISTANCE`] what it comes through.
const CHANNELS: [&str; 6] = ["R", "G", "B", "T_R", "T_G", "T_B"];
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
    /// Where a surface ends the ray, metres; infinite for none.
    distance: f64,
}

/// What is asked: light along a ray, and the transmittance of its air.
#[derive(Clone, Copy, Debug)]
struct Answer {
    light: [f64; 3],
    transmittance: [f64; 3],
}

impl Answer {
    fn values(&self) -> [f64; 6] {
        let ([r, g, b], [tr, tg, tb]) = (self.light, self.transmittance);
        [r, g, b, tr, tg, tb]
    }
}

/// The cases, and what of the file is copied.
struct Table {
    header: StringRecord,
    rows: Vec<StringRecord>,
    cases: Vec<Case>,
    /// Whether there is a column of distances.
    distances: bool,
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
        drawn(backend, method, &table)?
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
            light.values().iter().all(|v| v.is_finite()),
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
        let mut distance = header.iter().enumerate().filter(|(_, h)| h.trim() == DISTANCE).map(|(i, _)| i);
        let (distance, again) = (distance.next(), distance.next());
        if again.is_some() {
            return Err(UsageError::new(format!("{name}, line 1: column '{DISTANCE}' is there twice")));
        }
        let added = added(distance.is_some());
        if let Some(taken) = header.iter().find(|h| added.contains(&h.trim())) {
            return Err(UsageError::new(format!(
                "{name}, line 1: column '{taken}' is one that the output adds; rename it"
            )));
        }
        let (mut rows, mut cases) = (Vec::new(), Vec::new());
        let mut media = Media { folder: path.parent().unwrap_or(Path::new("")), known: HashMap::new() };
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
            let distance =
                distance.and_then(|i| record.get(i)).map(str::trim).filter(|text| !text.is_empty());
            let case = Case::new(values, distance, &mut media);
            cases.push(case.map_err(|e| UsageError::new(format!("{name}, line {line}: {e}")))?);
            rows.push(record);
        }
        Ok(Self { header, rows, cases, distances: distance.is_some() })
    }

    fn write(&self, answers: &[Answer], file: &mut dyn Write) -> anyhow::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let added = added(self.distances);
        writer.write_record(self.header.iter().chain(added.iter().copied()))?;
        for (row, answer) in self.rows.iter().zip(answers) {
            let values = answer.values().map(|v| format!("{v:.8e}"));
            writer.write_record(row.iter().chain(values[..added.len()].iter().map(String::as_str)))?;
        }
        writer.flush()?;
        Ok(())
    }
}

/// The columns that the output adds.
fn added(distances: bool) -> &'static [&'static str] {
    if distances { &CHANNELS } else { &CHANNELS[..3] }
}

/// The media of a table: presets, and files in its folder, each read once.
struct Media<'a> {
    folder: &'a Path,
    known: HashMap<String, AtmosphereParams>,
}

impl Media<'_> {
    fn find(&mut self, name: &str) -> Result<AtmosphereParams, String> {
        if let Some(known) = self.known.get(name) {
            return Ok(known.clone());
        }
        let medium = if AtmosphereParams::PRESETS.contains(&name) {
            AtmosphereParams::preset(name).map_err(|e| e.to_string())
        } else if Path::new(name).extension().is_some_and(|end| end == "toml") {
            medium::read(&self.folder.join(name)).map_err(|e| format!("medium '{name}': {e}"))
        } else {
            let presets = AtmosphereParams::PRESETS.join(", ");
            Err(format!("medium '{name}' must be one of {presets}, or a file whose name ends in .toml"))
        }?;
        self.known.insert(name.to_owned(), medium.clone());
        Ok(medium)
    }
}

impl Case {
    /// From the values of [`COLUMNS`], and that of [`DISTANCE`].
    fn new(
        [medium, albedo, altitude, sun_zenith, view_zenith, azimuth]: [&str; 6],
        distance: Option<&str>,
        media: &mut Media,
    ) -> Result<Self, String> {
        let mut atmosphere = media.find(medium)?;
        let lowest = atmosphere.lowest_ground;
        atmosphere.ground_albedo = [number("albedo", albedo, 0.0, 1.0)?; 3];
        atmosphere.sun_intensity = 1.0;
        Ok(Self {
            medium: medium.to_owned(),
            atmosphere,
            altitude: number("altitude_m", altitude, lowest, 1e12)?,
            sun_zenith: number("sun_zenith_deg", sun_zenith, 0.0, 180.0)?.to_radians(),
            view_zenith: number("view_zenith_deg", view_zenith, 0.0, 180.0)?.to_radians(),
            azimuth: number("azimuth_from_sun_deg", azimuth, -360.0, 360.0)?.to_radians(),
            distance: distance.map_or(Ok(f64::INFINITY), |text| number(DISTANCE, text, 1e-3, 1e12))?,
        })
    }

    fn query(&self) -> RayQuery {
        RayQuery::new(self.altitude, self.view_zenith, self.sun_zenith, self.azimuth).ended_at(self.distance)
    }

    /// The light of a method, and what its air lets through by the f64 reference.
    fn answer(&self, light: [f64; 3]) -> welkin::Result<Answer> {
        let transmittance = transmittance(&self.atmosphere, &self.query(), Tolerance::TRUTH)?;
        Ok(Answer { light, transmittance })
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
            depth: DepthConvention::ReversedInfinite { near: 1e-4 },
            moon: None,
            ellipsoid: None,
        }
    }
}

/// A finite number in `lo..=hi`.
fn number(column: &str, text: &str, lo: f64, hi: f64) -> Result<f64, String> {
    let value: f64 = text.parse().unwrap_or(f64::NAN);
    let allowed = (lo..=hi).contains(&value);
    allowed.then_some(value).ok_or_else(|| format!("{column} '{text}' must be a number from {lo} to {hi}"))
}

/// Radiance through the passes of a picture: the background sky, then the air before an empty scene, or
/// before a surface.
fn drawn(choice: BackendChoice, quality: Quality, table: &Table) -> anyhow::Result<(Vec<Answer>, String)> {
    let mut gpu = Gpu::open(choice)?;
    let by = format!("{quality} by {}", gpu.describe());
    let Some(backend) = gpu.backend() else {
        anyhow::bail!("no backend can draw here: {by}; '--method reference-single' needs none");
    };
    gpu::check_samples(backend.info(), &quality)?;
    let mut settings = SkySettings::from(quality);
    settings.look.sun_disk = false;
    let mut sky = SkyRenderer::new(settings)?;
    let steps = Progress::of("drawing", table.cases.len().div_ceil(BATCH));
    let mut textures = Textures { made: Vec::new(), pixels: Vec::new(), distances: table.distances };
    // LUTs are made anew for each medium, and what is not drawn by then would lose them.
    let answers = table
        .cases
        .chunk_by(|a, b| a.medium == b.medium)
        .flat_map(|cases| cases.chunks(BATCH))
        .map(|batch| {
            let _ = steps.step(&format!("{} cases", batch.len()));
            textures.draw(backend, &mut sky, batch)
        })
        .collect::<anyhow::Result<Vec<_>>>();
    sky.destroy(backend);
    textures.made.iter().for_each(|&id| backend.destroy_texture(id));
    Ok((answers?.concat(), by))
}

/// Pictures of one pixel.
struct Textures {
    made: Vec<TextureId>,
    /// Before and after the air is laid over.
    pixels: Vec<[TextureId; 2]>,
    /// Whether what lies behind is drawn in white too, to tell the transmittance.
    distances: bool,
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
    ) -> anyhow::Result<Vec<Answer>> {
        let depth = self.made.first().copied();
        let depth = depth.map_or_else(|| self.make(backend, Format::Depth32Float), Ok)?;
        let shades: &[f32] = if self.distances { &[0.0, 1.0] } else { &[0.0] };
        while self.pixels.len() < cases.len() * shades.len() {
            let pixel = [self.make(backend, Format::Rgba32Float)?, self.make(backend, Format::Rgba32Float)?];
            self.pixels.push(pixel);
        }
        let mut passes = Vec::new();
        let mut results = Vec::with_capacity(self.pixels.len());
        let drawings = cases.iter().flat_map(|case| shades.iter().map(move |shade| (case, *shade)));
        for ((case, shade), &[behind, front]) in drawings.zip(&self.pixels) {
            let scene = case.scene();
            let stored = match case.distance.is_finite() {
                true => scene.depth.encode(case.distance),
                false => scene.depth.background(),
            };
            let clear = Target {
                color: behind,
                depth: Some(depth),
                clear: Some([shade; 4]),
                clear_depth: Some(stored as f32),
                ..Target::color(behind)
            };
            let aerial = AerialTargets { color: Some(behind), depth, target: Target::color(front) };
            let sky_target = Target::color(behind);
            // A surface hides the sky.
            let targets = match case.distance.is_finite() {
                true => FrameTargets::default(),
                false => FrameTargets::background(sky_target),
            };
            let frame = sky.frame(backend, &scene, &targets.with_aerial(aerial))?;
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
        let texels = reads.into_iter().map(|read| {
            let texel = backend.poll_read(&read)?.context("this backend cannot wait for the GPU")?;
            ensure!(texel.len() == 4, "a pixel of {} values came back", texel.len());
            Ok([texel[0], texel[1], texel[2]].map(f64::from))
        });
        let texels = texels.collect::<anyhow::Result<Vec<_>>>()?;
        let answers = texels.chunks(shades.len()).map(|drawn| {
            let (light, through) = (drawn[0], drawn[drawn.len() - 1]);
            Answer { light, transmittance: std::array::from_fn(|c| through[c] - light[c]) }
        });
        Ok(answers.collect())
    }
}

fn reference_single(cases: &[Case]) -> anyhow::Result<Vec<Answer>> {
    let light = |case: &Case| {
        let light = single_scattering(&case.atmosphere, &case.query(), Sun::Point, Tolerance::TRUTH)?;
        Ok(case.answer(light.per_irradiance)?)
    };
    cases.par_iter().map(light).collect()
}

/// Cases of one medium and albedo share one solution.
fn reference(cases: &[Case], cache: &mut Cache) -> anyhow::Result<Vec<Answer>> {
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
    let mut answers = vec![Answer { light: [0.0; 3], transmittance: [1.0; 3] }; cases.len()];
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
            .map(|&i| {
                let light = orders.radiance(&cases[i].query(), Tolerance::TRUTH)?.per_irradiance;
                Ok((i, cases[i].answer(light)?))
            })
            .collect::<welkin::Result<_>>()?;
        solved.into_iter().for_each(|(i, answer)| answers[i] = answer);
    }
    Ok(answers)
}
