//! What the command line says, and what is accepted of it.

use std::fmt;
use std::path::PathBuf;
use std::time::Duration;

use clap::builder::{PossibleValuesParser, TypedValueParser as _};
use clap::{Args, Parser, Subcommand, ValueEnum};
use glam::DVec3;
use welkin::model::moon::{MOON_RADIUS, Moon};
use welkin::{AtmosphereParams, Bound, Mode, Quality, SkySettings, ToneMap};

use crate::choose::Wish;
use crate::costs::CostsArgs;
use crate::draw::{BackendChoice, Shot};
use crate::ephemeris;
use crate::flight::FlightArgs;
use crate::sun;
use crate::views::{self, Place, View};

/// Most pixels along one side of a picture: the smallest limit of WebGPU and of WebGL2 in practice.
const MAX_SIDE: u32 = 8192;
/// Most pixels in a picture; 16 bytes of radiance each.
const MAX_PIXELS: u64 = 1 << 25;
/// Most samples along a ray.
const MAX_SAMPLES: u32 = 1024;
/// Most samples towards the sun.
const MAX_LIGHT_SAMPLES: u32 = 256;
/// Farthest camera, metres.
const MAX_ALTITUDE: f64 = 1e12;

/// A request that cannot be carried out as it was put. Ends in exit status 2.
#[derive(Debug)]
pub struct UsageError(String);

impl UsageError {
    /// An error in plain words.
    pub fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }

    /// An error that names option, value and what is allowed, in clap's own form.
    pub fn value(option: &str, value: impl fmt::Display, allowed: impl fmt::Display) -> Self {
        Self(format!("invalid value '{value}' for '{option}': must be {allowed}"))
    }
}

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UsageError {}

/// Physically based skies, from the ground to orbit.
#[derive(Debug, Parser)]
#[command(name = "welkin", version, about, after_help = "Start with:  welkin render")]
#[command(arg_required_else_help = true, subcommand_required = true, disable_help_subcommand = false)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands; each has a file of its own.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw a sky: a contact sheet of many views, or one picture
    Render(Box<RenderArgs>),
    /// Say which effects a picture calls for, why, and the passes that draw them
    Plan(Box<PlanArgs>),
    /// Draw a climb to a million kilometres, or a day, as a strip of frames; measure how smoothly they follow
    Film(Box<FilmArgs>),
    /// Fly from the ground to the moon's distance and around to the night side: what is drawn, why, and what it costs
    Flight(FlightArgs),
    /// Say what each effect costs: bytes, pipelines and milliseconds
    Costs(CostsArgs),
    /// Draw every view by every backend: how far apart the pictures are, and what each pass costs
    Compare(CompareArgs),
    /// Compute the sky's radiance in given directions, from a table to a table
    Radiance(RadianceArgs),
    /// Measure what accuracy costs in time, on every backend
    Accuracy(AccuracyArgs),
    /// Run the shaders' functions on a million cases, against f64
    Stress(StressArgs),
    /// Tell how much of the sun the moon hides above a place on Earth, and when
    Eclipse(EclipseArgs),
    /// List the backends and adapters that can draw here
    Info,
    /// Translate shaders/wgsl/ to shaders/glsl/ (for work on welkin itself)
    Shaders {
        /// Only compare, and fail if a file is stale, missing or left over
        #[arg(long)]
        check: bool,
        /// The repository
        #[arg(long, default_value = ".")]
        root: PathBuf,
    },
}

/// Options of `welkin compare`.
#[derive(Args, Debug)]
#[command(after_help = "Pictures are compared without dither, timed with it.")]
pub struct CompareArgs {
    /// Pixels of the pictures that are compared
    #[arg(long, value_name = "WxH", default_value = "480x270", value_parser = parse_size)]
    pub size: [u32; 2],

    /// Pixels of the pictures that are timed
    #[arg(long, value_name = "WxH", default_value = "1920x1080", value_parser = parse_size)]
    pub time_size: [u32; 2],

    /// Rounds of timing, of which the best counts, 0 to 1000; 0 does not time
    #[arg(long, value_name = "N", default_value = "3", value_parser = clap::value_parser!(u32).range(0..=1000))]
    pub repeat: u32,

    /// Method and its numbers by name
    #[arg(long, value_name = "NAME", default_value = "medium")]
    #[arg(value_parser = PossibleValuesParser::new(Quality::ALL.iter().map(|q| q.name)))]
    quality: String,

    /// Single scattering with so many samples along each view ray instead, 1 to 1024
    #[arg(long, value_name = "N", value_parser = parse_samples)]
    samples: Option<u32>,

    /// Single scattering with so many samples from each of those towards the sun, 1 to 256
    #[arg(long, value_name = "N", value_parser = parse_light_samples)]
    light_samples: Option<u32>,

    /// Also draw on the CPU, by the f64 reference
    #[arg(long)]
    pub cpu: bool,

    /// Keep the pictures in this folder, as VIEW.BACKEND.png
    #[arg(long, value_name = "DIR")]
    pub keep: Option<PathBuf>,

    /// Compare with pictures kept in this folder, from another machine or driver
    #[arg(long, value_name = "DIR")]
    pub with: Option<PathBuf>,
}

impl Command {
    /// As it is written on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Render(_) => "render",
            Self::Plan(_) => "plan",
            Self::Film(_) => "film",
            Self::Flight(_) => "flight",
            Self::Costs(_) => "costs",
            Self::Radiance(_) => "radiance",
            Self::Accuracy(_) => "accuracy",
            Self::Compare(_) => "compare",
            Self::Stress(_) => "stress",
            Self::Eclipse(_) => "eclipse",
            Self::Info => "info",
            Self::Shaders { .. } => "shaders",
        }
    }
}

const ECLIPSE_DETAILS: &str = "\
elevation, azimuth  of the disks' middles, without refraction; 0° is north, 90° east
magnitude           share of the sun's diameter that is covered; where one disk lies within the other, the ratio
                    of their diameters
obscuration         share of the sun's disk that is covered
sunlight            what is left of the sun's light, its edge being darker than its middle
Contacts are for a moon without mountains: k = 0.2725076 for partial, 0.272281 for total and annular phases.
Places are heights above the ellipsoid WGS 84. Times are good to a second or two from 1972 to the next leap second,
beyond by as much as the Earth's turning was guessed wrong.

Examples:
  welkin eclipse --place 25.29,-104.14 --time 2024-04-08T18:17:16Z
      The total eclipse over Nazas, Mexico
  welkin eclipse --place 35.08,-106.65 --time 2023-10-14T12:00:00Z --json
      The ring over Albuquerque, found from the morning on, for a program to read

Exit status: 0 printed; 1 printing failed; 2 the request was not accepted.";

/// Options of `welkin eclipse`.
#[derive(Args, Debug)]
#[command(after_long_help = ECLIPSE_DETAILS)]
#[command(after_help = "What the numbers mean, and examples: welkin eclipse --help")]
pub struct EclipseArgs {
    /// Latitude north and longitude east in degrees, as in 25.3,-104.1
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true, value_parser = parse_place)]
    place: Place,

    /// Time in RFC 3339, years 1900 to 2099, as in 2024-04-08T18:17:16Z; the eclipse nearest to it, within 12 hours
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = parse_time)]
    time: jiff::Timestamp,

    /// Height above sea level: metres, or as in 2km
    #[arg(long, value_name = "LENGTH", default_value = "0m", allow_hyphen_values = true, value_parser = parse_length)]
    height: Length,

    /// As JSON
    #[arg(long)]
    pub json: bool,
}

impl EclipseArgs {
    /// Time, place and height in metres.
    pub fn when_and_where(&self) -> (jiff::Timestamp, Place, f64) {
        (self.time, self.place, self.height.metres)
    }
}

const STRESS_ABOUT: &str = "\
Run the shaders' functions on a million cases, against f64

Each case is a planet, its air, a camera, a ray and a sun: first a fixed grid of what breaks atmosphere code, then \
random ones over everything that the library accepts. The shaders' own functions run on each of them, one pixel a \
case, and every number that comes back must be finite, possible (no negative light, transmittance from 0 to 1) and \
right: geometry within 1e-5 or 1 m (in proportion on planets smaller than the Earth), everything else within 0.1 % \
or 1e-6 of the case's brightest value.";

const STRESS_DETAILS: &str = "\
The table, a line for each quantity:
  tried       numbers that were judged
  non-finite  NaN or infinite ones
  steep       numbers that depend on digits of the inputs that 32-bit floats do not have, such as the length
              of a ray that touches the planet; they must be right for some inputs within 2^-22 of the case's
  worst       largest error of all others, over the true value (or over what counts as small beside it); a little
              above the promise where the last digits of the inputs explain the rest
  promise     what that may be
  used        largest part of what is allowed that any number used, the last digits of its inputs counted in
  by case     which one that was
  broken      wrong by more, not finite or impossible

For the first case that breaks a promise, each quantity shows its number, its inputs, what came back and what
f64 makes of it; then the plainest case that breaks it too. A case is the same on every machine, by its
number and the seed.

Examples:
  welkin stress
      A million cases on the backend that draws by default
  welkin stress --cases 20000000 --seed 7 --backend webgl2
      More of them, other random ones, the other backend
  welkin stress --case 123456
      That case alone: its inputs, and every number that comes back
  welkin stress --frames 1000
      A thousand small pictures of random scenes, and the plainest one of which something is wrong
  welkin stress --save here.tsv && welkin stress --table here.tsv there.tsv
      Drivers side by side

Exit status: 0 every promise was kept; 1 one was broken, or a backend failed; 2 the request was not accepted.";

/// Options of `welkin stress`.
#[derive(Args, Debug)]
#[command(long_about = STRESS_ABOUT, after_long_help = STRESS_DETAILS)]
#[command(after_help = "What the table says, and examples: welkin stress --help")]
pub struct StressArgs {
    /// How many cases, 1 to 10^10
    #[arg(long, value_name = "N", default_value = "1000000")]
    #[arg(value_parser = clap::value_parser!(u64).range(1..=10_000_000_000))]
    pub cases: u64,

    /// Which random cases follow the grid
    #[arg(long, value_name = "S", default_value = "1")]
    pub seed: u64,

    /// Only the case of this number
    #[arg(long, value_name = "NUMBER", conflicts_with = "cases")]
    pub case: Option<u64>,

    /// Instead of cases, draw so many whole pictures of random scenes: all light must be finite and possible
    #[arg(long, value_name = "N", conflicts_with = "cases")]
    pub frames: Option<u64>,

    /// What runs the shaders; the CPU cannot
    #[arg(long, value_name = "NAME", default_value = "auto")]
    pub backend: BackendChoice,

    /// Also write the table's numbers to a file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["case", "frames"])]
    pub save: Option<PathBuf>,

    /// Instead of trying anything, print what such files hold side by side, as Markdown
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["cases", "case", "frames", "save"])]
    pub table: Vec<PathBuf>,
}

const RENDER_ABOUT: &str = "\
Draw a sky: a contact sheet of many views, or one picture

Without an option under \"View\", \"Sun\" or \"Picture\" this draws the contact sheet: the sky from the \
ground to far orbit on Earth and Mars, and one view by every backend side by side with their largest \
difference. Each of those options asks for a single picture instead.";

const RENDER_EXAMPLES: &str = "\
Examples:
  welkin render
      The contact sheet, to welkin.png
  welkin render --view mars-sunset --size 1920x1080 -o mars.png
      One of the contact sheet's views, alone and larger
  welkin render --altitude 400km --pitch -20 --fov 40 --sun-elevation 25 -o limb.exr
      The limb from low orbit, as linear radiance
  welkin render --place 46.55,7.98 --time 2024-06-20T04:00:00Z --altitude 3466 --heading 60
      The sky over the Jungfraujoch on a summer morning, the sun where it was
  welkin render --view noon --backend webgl2 --samples 8 --light-samples 4
      A view by a backend and with samples of your choice
  welkin render --view sunset --within-budget 5ms
      A view by the best quality that this machine draws in 5 milliseconds; says which that is

Exit status: 0 drawn and written; 1 drawing or writing failed; 2 the request was not accepted, and
nothing was written.";

/// Options of `welkin render`.
#[derive(Args, Debug)]
#[command(long_about = RENDER_ABOUT, after_long_help = RENDER_EXAMPLES)]
#[command(after_help = "Examples and more words: welkin render --help")]
pub struct RenderArgs {
    /// Start from this view of the contact sheet
    #[arg(long, value_name = "NAME", help_heading = "View")]
    #[arg(value_parser = PossibleValuesParser::new(views::VIEWS.iter().map(|v| v.name)))]
    view: Option<String>,

    /// The planet and its air [default: earth]
    #[arg(long, value_name = "NAME", help_heading = "View")]
    #[arg(value_parser = PossibleValuesParser::new(AtmosphereParams::PRESETS))]
    planet: Option<String>,

    /// Height above the ground (sea level with --no-terrain): metres, or as in 15km [default: 100m]
    #[arg(long, value_name = "LENGTH", help_heading = "View", allow_hyphen_values = true)]
    #[arg(value_parser = parse_length)]
    altitude: Option<Length>,

    /// Degrees above the horizontal that the camera looks, -90 to 90 [default: 10]
    #[arg(long, value_name = "DEGREES", help_heading = "View", allow_hyphen_values = true)]
    #[arg(value_parser = degrees(-90.0, 90.0))]
    pitch: Option<f64>,

    /// Where the camera looks: 0 is north, 90 east; -360 to 360 [default: 180]
    #[arg(long, value_name = "DEGREES", help_heading = "View", allow_hyphen_values = true)]
    #[arg(value_parser = degrees(-360.0, 360.0))]
    heading: Option<f64>,

    /// Vertical field of view, 0.01 to 179 degrees [default: 60]
    #[arg(long, value_name = "DEGREES", help_heading = "View", allow_hyphen_values = true)]
    #[arg(value_parser = degrees(0.01, 179.0))]
    fov: Option<f64>,

    /// Degrees of the sun above the horizontal, -90 to 90 [default: 30]
    #[arg(long, value_name = "DEGREES", help_heading = "Sun (by angles, or by place and time)")]
    #[arg(allow_hyphen_values = true, value_parser = degrees(-90.0, 90.0))]
    sun_elevation: Option<f64>,

    /// Where the sun stands: 0 is north, 90 east; -360 to 360 [default: 180]
    #[arg(long, value_name = "DEGREES", help_heading = "Sun (by angles, or by place and time)")]
    #[arg(allow_hyphen_values = true, value_parser = degrees(-360.0, 360.0))]
    sun_azimuth: Option<f64>,

    /// Latitude north and longitude east in degrees, as in 46.5,8.0; needs --time
    ///
    /// The sun then stands where the ephemeris has it, without refraction.
    #[arg(long, value_name = "LAT,LON", help_heading = "Sun (by angles, or by place and time)")]
    #[arg(allow_hyphen_values = true, value_parser = parse_place)]
    place: Option<Place>,

    /// Time in RFC 3339, as in 2024-06-20T20:51:00Z; needs --place
    #[arg(long, value_name = "TIME", help_heading = "Sun (by angles, or by place and time)")]
    #[arg(allow_hyphen_values = true, value_parser = parse_time)]
    time: Option<jiff::Timestamp>,

    /// Put the moon where it stood, too; needs --place and --time, years 1900 to 2099
    ///
    /// It is drawn with its phase, hides the sun's disk, whose edge is then darker, and its shadow falls on the ground and
    /// through the air. With --backend cpu for light scattered once.
    #[arg(long, help_heading = "Sun (by angles, or by place and time)", requires_all = ["place", "time"])]
    moon: bool,

    /// Draw the sun's disk darker towards its edge
    #[arg(long, help_heading = "Sun (by angles, or by place and time)")]
    limb_darkening: bool,

    /// Pixels, as in 1920x1080; each side 1 to 8192 [default: 1280x720]
    #[arg(long, value_name = "WxH", help_heading = "Picture", allow_hyphen_values = true)]
    #[arg(value_parser = parse_size)]
    size: Option<[u32; 2]>,

    /// Multiplies radiance before tone mapping, 1e-6 to 1e6: 2 is one stop brighter [default: the view's, or 1]
    #[arg(long, value_name = "FACTOR", help_heading = "Picture", allow_hyphen_values = true)]
    #[arg(value_parser = number(1e-6, 1e6, ""))]
    exposure: Option<f64>,

    /// Which passes draw the atmosphere, and how unless a quality is asked for
    ///
    /// sky-dome: the sky alone, in one pass behind the scene. atmosphere-post: one pass over the scene, which reads its
    /// colour and depth. planet: a shell laid over the scene by blending. These three march single scattering, 24 × 8
    /// samples. lut: everything from tables, with all orders of scattering, from the ground to far orbit.
    #[arg(long, value_name = "MODE", help_heading = "Quality and output", default_value = "lut")]
    #[arg(value_parser = PossibleValuesParser::new(Mode::ALL.map(Mode::name)).try_map(|name: String| Mode::from_name(&name)))]
    mode: Mode,

    /// Method and its numbers by name; 'welkin accuracy' measures what each costs and misses
    #[arg(long, value_name = "NAME", help_heading = "Quality and output", group = "chosen")]
    #[arg(value_parser = PossibleValuesParser::new(Quality::ALL.iter().map(|q| q.name)))]
    quality: Option<String>,

    /// The cheapest quality with at most this mean error against all orders of scattering, as in 0.4 for 40 %
    ///
    /// Of radiance, in the worst channel, over the Earth scenes of 'welkin accuracy', by the table in this program.
    #[arg(long, value_name = "ERROR", help_heading = "Quality and output", group = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = number(0.0, 1e6, ""))]
    within_error: Option<f64>,

    /// The best quality whose sky takes at most this time a frame, as in 5ms; measured here first
    ///
    /// Every quality is timed on the backend that draws, in frames of the picture's size: the mean over a view from
    /// the ground, one of the limb and one of the whole Earth.
    #[arg(long, value_name = "TIME", help_heading = "Quality and output", group = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = parse_budget)]
    within_budget: Option<Duration>,

    /// Single scattering with so many samples along each view ray, 1 to 1024
    #[arg(long, value_name = "N", help_heading = "Quality and output", conflicts_with = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = parse_samples)]
    samples: Option<u32>,

    /// Single scattering with so many samples from each of those towards the sun, 1 to 256
    #[arg(long, value_name = "N", help_heading = "Quality and output", conflicts_with = "chosen")]
    #[arg(allow_hyphen_values = true, value_parser = parse_light_samples)]
    light_samples: Option<u32>,

    /// The curve from radiance to display values; .exr and .hdr are written without one
    #[arg(long, value_name = "CURVE", help_heading = "Quality and output", default_value = "aces")]
    tone_map: ToneMapName,

    /// Round display values without the noise that hides bands; .exr and .hdr never have it
    #[arg(long, help_heading = "Quality and output")]
    no_dither: bool,

    /// What draws
    #[arg(long, value_name = "NAME", help_heading = "Quality and output", default_value = "auto")]
    pub backend: BackendChoice,

    /// Leave the ground a smooth sphere
    #[arg(long, help_heading = "Quality and output")]
    no_terrain: bool,

    /// Draw every effect that the settings have, whether the scene calls for it or not
    #[arg(long, help_heading = "Quality and output")]
    all_effects: bool,

    /// Where to write; the ending decides: .png is 8-bit sRGB, .exr and .hdr are linear radiance
    #[arg(short, long, value_name = "FILE", help_heading = "Quality and output", default_value = "welkin.png")]
    pub output: PathBuf,
}

const PLAN_ABOUT: &str = "\
Say which effects a picture calls for, why, and the passes that draw them

Takes the options of 'welkin render' and draws nothing. Without any this is the plan of the default view from the \
ground. What a plan leaves out changes no pixel by more than the bound that it names, and is not compiled, allocated, \
bound or drawn.";

const PLAN_DETAILS: &str = "\
Examples:
  welkin plan --altitude 400km --pitch 20
      From orbit, looking away from the planet
  welkin plan --sun-elevation -25 --json
      At night, as JSON: bound, effects (name, on, reason) and passes (label, program, runs, times)
  welkin plan --view limb --all-effects
      With everything forced on

Exit status: 0 printed; 1 failed; 2 the request was not accepted.";

/// Options of `welkin plan`.
#[derive(Args, Debug)]
#[command(about = "Say which effects a picture calls for, why, and the passes that draw them")]
#[command(long_about = PLAN_ABOUT, after_long_help = PLAN_DETAILS)]
#[command(after_help = "Examples and more words: welkin plan --help")]
pub struct PlanArgs {
    #[command(flatten)]
    pub render: RenderArgs,

    /// Print JSON
    #[arg(long, help_heading = "Quality and output")]
    pub json: bool,
}

/// The names of [`ToneMap`] on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ToneMapName {
    /// Contrasty; bright colours turn white
    Aces,
    /// Soft shoulder, keeps hues
    #[value(name = "agx")]
    AgX,
    /// Leaves what is not bright as it is
    Neutral,
}

impl From<ToneMapName> for ToneMap {
    fn from(name: ToneMapName) -> Self {
        match name {
            ToneMapName::Aces => Self::Aces,
            ToneMapName::AgX => Self::AgX,
            ToneMapName::Neutral => Self::Neutral,
        }
    }
}

impl ToneMapName {
    fn title(self) -> &'static str {
        match self {
            Self::Aces => "ACES",
            Self::AgX => "AgX",
            Self::Neutral => "Khronos Neutral",
        }
    }
}

const FILM_ABOUT: &str = "\
Draw a climb to a million kilometres, or a day, as a strip of frames; measure how smoothly they follow

climb: the camera rises from 2 m to 1,000,000 km, each frame higher by the same factor. It looks at the horizon, from \
100 km on more and more towards the planet's centre, and keeps the whole planet in the picture once it fits.
day: the sun rises 20° below the horizon behind the camera, passes through the zenith and sets in front of it.

Then the same film in many more and smaller frames, by every backend and by the f64 reference: how far neighbouring \
frames lie apart, and how far that is from what the reference changes by. A seam, a popping table or a hand-over that \
does not add up shows as a difference there.";

const FILM_DETAILS: &str = "\
The table of steps: light of the air over black, without ground and sun's disk, in 32-bit floats. All numbers are shares \
of the brightest value that the reference has in the two frames, channel by channel, in %:
  mean    of all values of the frame
  pixel   the value that changes most
  off     of the change that is drawn less the reference's change; the two above it are sizes of either change
Half of a climb's steps are spread evenly in the altitude's logarithm, a quarter over 14 to 51 km, where the background \
hands over to the depth-aware pass, and a quarter around the top of the air. --csv writes every step.

The reference is solved once for each planet (Earth: 10 s) and kept; its frames take some minutes of a core.

Examples:
  welkin film climb
      The strip to film.png, then the table for every backend
  welkin film climb --planet mars --frames 24 --steps 0 -o mars.png
      Only the strip
  welkin film day --altitude 11km --backend webgl2 --csv steps.csv
      A day from an airliner; every step into a file

Exit status: 0 drawn and written; 1 drawing, measuring or writing failed; 2 the request was not accepted, and
nothing was written.";

/// Which film.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FilmKind {
    /// The camera rises from 2 m to 1,000,000 km
    Climb,
    /// The sun rises, passes through the zenith and sets
    Day,
}

/// Options of `welkin film`.
#[derive(Args, Debug)]
#[command(long_about = FILM_ABOUT, after_long_help = FILM_DETAILS)]
#[command(after_help = "What the table says, and examples: welkin film --help")]
pub struct FilmArgs {
    /// What changes from frame to frame
    #[arg(value_name = "FILM")]
    pub kind: FilmKind,

    /// The planet and its air
    #[arg(long, value_name = "NAME", default_value = "earth")]
    #[arg(value_parser = PossibleValuesParser::new(AtmosphereParams::PRESETS))]
    planet: String,

    /// Degrees of the sun above the horizontal, -90 to 90; only of a climb [default: 25]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, value_parser = degrees(-90.0, 90.0))]
    sun_elevation: Option<f64>,

    /// Height above the ground, 0 to 1,000 km: metres, or as in 15km; only of a day [default: 2m]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, value_parser = parse_length)]
    altitude: Option<Length>,

    /// Frames of the strip, 2 to 64
    #[arg(long, value_name = "N", default_value = "16", value_parser = clap::value_parser!(u32).range(2..=64))]
    pub frames: u32,

    /// Pixels of each frame, 8x8 to 1000x1000
    #[arg(long, value_name = "WxH", default_value = "80x120", value_parser = parse_frame)]
    pub size: [u32; 2],

    /// Steps that are measured, 8 to 10000; 0 does not measure
    #[arg(long, value_name = "N", default_value = "240", value_parser = parse_steps)]
    pub steps: u32,

    /// Method and its numbers by name
    #[arg(long, value_name = "NAME", default_value = "medium")]
    #[arg(value_parser = PossibleValuesParser::new(Quality::ALL.iter().map(|q| q.name)))]
    quality: String,

    /// Multiplies radiance before tone mapping, 1e-6 to 1e6 [default: 0.4; of a day, 0.25 / median^0.85 of each frame]
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, value_parser = number(1e-6, 1e6, ""))]
    pub exposure: Option<f64>,

    /// Round display values without the noise that hides bands: a smaller file
    #[arg(long)]
    pub no_dither: bool,

    /// What draws: webgpu or webgl2 [default: the strip by the best, the table for each that can be had]
    #[arg(long, value_name = "NAME", hide_possible_values = true)]
    #[arg(value_parser = PossibleValuesParser::new(["webgpu", "webgl2"]))]
    backend: Option<String>,

    /// Write every step to this file (CSV)
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,

    /// Where to write the strip (.png)
    #[arg(short, long, value_name = "FILE", default_value = "film.png")]
    pub output: PathBuf,

    #[command(flatten)]
    pub cache: CacheArgs,
}

impl FilmArgs {
    /// The backend that was asked for.
    pub fn backend(&self) -> Option<BackendChoice> {
        match self.backend.as_deref()? {
            "webgl2" => Some(BackendChoice::WebGl2),
            _ => Some(BackendChoice::WebGpu),
        }
    }

    /// The planet's name.
    pub fn planet(&self) -> &'static str {
        AtmosphereParams::PRESETS.into_iter().find(|p| *p == self.planet).unwrap_or("earth")
    }

    /// How the sky is drawn.
    pub fn quality(&self) -> Quality {
        Quality::from_name(&self.quality).unwrap_or(Quality::MEDIUM)
    }

    /// The sun's elevation of a climb (degrees) and the altitude of a day (metres).
    pub fn fixed(&self) -> Result<(f64, f64), UsageError> {
        let other = match self.kind {
            FilmKind::Climb => self.altitude.is_some().then_some(("--altitude <LENGTH>", "climb", "altitude")),
            FilmKind::Day => self.sun_elevation.is_some().then_some(("--sun-elevation <DEGREES>", "day", "sun")),
        };
        if let Some((option, film, what)) = other {
            return Err(UsageError::new(format!(
                "'{option}' cannot be used with '{film}': the {what} is what changes from frame to frame"
            )));
        }
        if self.csv.is_some() && self.steps == 0 {
            return Err(UsageError::new("'--csv <FILE>' cannot be used with '--steps 0': no step is measured"));
        }
        let altitude = self.altitude.as_ref().map_or(2.0, |a| a.metres);
        if let Some(text) = self.altitude.as_ref().filter(|a| !(0.0..=1e6).contains(&a.metres)).map(|a| &a.text) {
            return Err(UsageError::value("--altitude <LENGTH>", text, "from 0 m to 1,000 km"));
        }
        Ok((self.sun_elevation.unwrap_or(25.0), altitude))
    }
}

const RADIANCE_ABOUT: &str = "\
Compute the sky's radiance in given directions, from a table to a table

Radiance is per unit of the sun's irradiance at the top of the atmosphere on a plane normal to the sun: 1/sr. \
Multiply it by the sun's irradiance. The sun's disk is never part of it; the sun is a point, nothing is \
refracted or polarised. R, G, B are the medium's three channels (earth: 680, 550, 440 nm).";

const RADIANCE_DETAILS: &str = "\
The table of cases is CSV with a header. Columns, found by name, in any order:
  medium                earth, rayleigh, mars, venus or earth-like
  albedo                share of light that the ground reflects (Lambertian), 0 to 1
  altitude_m            of the observer above the ground, 0 to 1e12
  sun_zenith_deg        angle of the sun from the zenith, 0 to 180
  view_zenith_deg       angle of the view from the zenith, 0 to 180
  azimuth_from_sun_deg  of the view, 0 towards the sun, -360 to 360
Other columns are copied. The output adds the columns R, G and B.

What is included:
  lut               light of all orders of scattering from tables, by a GPU backend, as the default of
                    'welkin render'. A ray that meets the ground sees it black, but the air is lit by
                    its albedo.
  single            light scattered once by the air, by a GPU backend, through the passes that draw
                    pictures, in 32-bit floats. A ray that meets the ground ends there and sees it
                    black; the albedo has no influence.
  reference-single  the same light in f64 on the CPU, relative error 1e-6.
  reference         light of all orders of scattering in f64 on the CPU, with the light that the ground
                    reflects: into the air, and to the eye where a ray meets the ground. About 0.2 % by
                    day, 0.5 % in twilight. Solves once for each medium and albedo, up to some minutes each, and
                    keeps the solution: up to 11 MB each.

Example:
  welkin radiance --cases sky.csv --method single --samples 256 --light-samples 64 --out radiance.csv

Exit status: 0 written; 1 computing or writing failed; 2 the request or a row was not accepted, and
nothing was written.";

/// Options of `welkin radiance`.
#[derive(Args, Debug)]
#[command(long_about = RADIANCE_ABOUT, after_long_help = RADIANCE_DETAILS)]
#[command(after_help = "Columns, and what each method includes: welkin radiance --help")]
pub struct RadianceArgs {
    /// The table of cases (CSV)
    #[arg(long, value_name = "FILE")]
    pub cases: PathBuf,

    /// How to compute
    #[arg(long, value_name = "NAME")]
    pub method: Method,

    /// Sizes of the tables, for --method lut: low, medium, high
    #[arg(long, value_name = "NAME", default_value = "medium")]
    #[arg(value_parser = PossibleValuesParser::new(TABLES.iter().map(|q| q.name)))]
    quality: String,

    /// What draws; only for a method that draws
    #[arg(long, value_name = "NAME", default_value = "auto")]
    pub backend: BackendChoice,

    /// Samples along each view ray, 1 to 1024; for --method single
    #[arg(long, value_name = "N", default_value = "32")]
    #[arg(allow_hyphen_values = true, value_parser = parse_samples)]
    pub samples: u32,

    /// Samples from each of those towards the sun, 1 to 256; for --method single
    #[arg(long, value_name = "N", default_value = "8")]
    #[arg(allow_hyphen_values = true, value_parser = parse_light_samples)]
    pub light_samples: u32,

    /// Where to write (CSV)
    #[arg(short, long, value_name = "FILE")]
    pub out: PathBuf,

    #[command(flatten)]
    pub cache: CacheArgs,
}

/// Options of what uses the all-orders reference.
#[derive(Args, Debug)]
#[command(next_help_heading = "Kept solutions of the all-orders reference")]
pub struct CacheArgs {
    /// Solve, even what was solved before, and keep nothing
    #[arg(long)]
    pub no_cache: bool,

    /// Where solutions are kept; may be emptied at any time [default: welkin in the user's cache folder]
    #[arg(long, value_name = "FOLDER", env = "WELKIN_CACHE_DIR", hide_env_values = true)]
    pub cache_dir: Option<PathBuf>,
}

const ACCURACY_ABOUT: &str = "\
Measure what accuracy costs in time, on every backend

Draws a fixed set of scenes (sun from the zenith to 12° below the horizon, camera from 2 m to 10,000 km, Earth, \
Mars and a thick haze) at many qualities on every backend that this machine has, and compares them with the f64 \
reference. Writes accuracy.md (tables), accuracy.csv (every number) and accuracy.svg (error against time).";

/// Options of `welkin accuracy`.
#[derive(Args, Debug)]
#[command(long_about = ACCURACY_ABOUT)]
pub struct AccuracyArgs {
    /// Fewer scenes, smaller pictures, a coarser reference: about a minute instead of many
    #[arg(long)]
    pub quick: bool,

    /// Where to write; made if it is not there
    #[arg(short, long, value_name = "FOLDER", default_value = "accuracy")]
    pub out: PathBuf,

    /// Also write error and time of every preset, as the library keeps them in src/quality/front.txt
    #[arg(long, value_name = "FILE")]
    pub write_front: Option<PathBuf>,

    /// Pixels of the frames that the presets' times in that file are of [default: 1920x1080]
    #[arg(long, value_name = "WxH", requires = "write_front", default_value = "1920x1080", hide_default_value = true)]
    #[arg(value_parser = parse_size)]
    pub front_size: [u32; 2],

    #[command(flatten)]
    pub cache: CacheArgs,
}

/// How radiance is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Single scattering by a GPU backend
    Single,
    /// All orders of scattering by a GPU backend, from tables
    Lut,
    /// Single scattering in f64
    ReferenceSingle,
    /// All orders of scattering in f64
    Reference,
}

/// Presets that draw from tables.
const TABLES: [Quality; 3] = [Quality::LOW, Quality::MEDIUM, Quality::HIGH];

impl RadianceArgs {
    /// What draws with `--method lut`.
    pub fn tables(&self) -> welkin::Method {
        TABLES.iter().find(|q| q.name == self.quality).unwrap_or(&Quality::MEDIUM).method
    }
}

impl CompareArgs {
    /// How the sky is drawn.
    pub fn method(&self) -> welkin::Method {
        match (self.samples, self.light_samples) {
            (None, None) => Quality::from_name(&self.quality).unwrap_or(Quality::MEDIUM).method,
            (view, light) => {
                welkin::Method::Single { view_samples: view.unwrap_or(32), light_samples: light.unwrap_or(8) }
            }
        }
    }
}

impl RenderArgs {
    /// The mode that is asked for.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The one picture that is asked for, its sky still as by default, or `None` for the contact sheet. Every
    /// value but the quality is checked here; [`Self::wish`] has that.
    pub fn single(&self) -> Result<Option<(View, Shot)>, UsageError> {
        let asked = self.view.is_some()
            || self.planet.is_some()
            || self.altitude.is_some()
            || self.pitch.is_some()
            || self.heading.is_some()
            || self.fov.is_some()
            || self.sun_elevation.is_some()
            || self.sun_azimuth.is_some()
            || self.place.is_some()
            || self.time.is_some()
            || self.size.is_some()
            || self.exposure.is_some();
        if !asked {
            return Ok(None);
        }
        let base = self.view.as_deref().and_then(views::named).unwrap_or(&views::DEFAULT);
        let planet = AtmosphereParams::PRESETS.into_iter().find(|p| Some(*p) == self.planet.as_deref());
        let mut view = View {
            planet: planet.unwrap_or(base.planet),
            altitude: self.altitude.as_ref().map_or(base.altitude, |a| a.metres),
            pitch: self.pitch.unwrap_or(base.pitch),
            heading: self.heading.unwrap_or(base.heading),
            fov: self.fov.unwrap_or(base.fov),
            sun_elevation: self.sun_elevation.unwrap_or(base.sun_elevation),
            sun_azimuth: self.sun_azimuth.unwrap_or(base.sun_azimuth),
            exposure: self.exposure.map_or(base.exposure, |e| e as f32),
            ..*base
        };
        self.check_altitude(&view)?;
        let place = self.place_and_sun(&mut view)?;
        let size = self.size.unwrap_or([1280, 720]);
        Ok(Some((view, self.shot(&view, place, size, SkySettings::default())?)))
    }

    /// The one picture that is asked for, or the default view.
    pub fn single_or_default(&self) -> Result<(View, Shot), UsageError> {
        if let Some(single) = self.single()? {
            return Ok(single);
        }
        let view = views::DEFAULT;
        let shot = self.shot(&view, Place::DEFAULT, [1280, 720], SkySettings::default())?;
        Ok((view, shot))
    }

    /// How much what is left out may change a picture of that exposure: as much as nobody sees in 8 bits, or what
    /// suits numbers.
    fn bound(&self, exposure: f32) -> Option<Bound> {
        let linear =
            self.output.extension().is_some_and(|e| e.eq_ignore_ascii_case("exr") || e.eq_ignore_ascii_case("hdr"));
        let bound = if linear { Bound::LINEAR } else { Bound::eight_bit(exposure.into()) };
        (!self.all_effects).then_some(bound)
    }

    /// A view as these options have it drawn.
    pub fn shot(
        &self,
        view: &View,
        place: Place,
        [width, height]: [u32; 2],
        sky: SkySettings,
    ) -> Result<Shot, UsageError> {
        let terrain = (!self.no_terrain).then(|| view.terrain());
        let aspect = f64::from(width) / f64::from(height);
        let mut scene = view.scene(place, aspect, terrain.as_ref()).map_err(|e| match e.into_kind() {
            welkin::ErrorKind::Invalid { field, value, allowed } if field.starts_with("camera.tangents") => {
                UsageError::new(format!(
                    "'--fov <DEGREES>' {} and '--size <WxH>' {width}x{height} make too wide a view: \
                     its edge lies at {value} (tangent of the angle), must be {allowed}",
                    view.fov
                ))
            }
            other => UsageError::new(other.to_string()),
        })?;
        if let (true, Some(time)) = (self.moon, self.time) {
            let bodies = ephemeris::bodies(time, place, 0.0)
                .map_err(|_| UsageError::value("--time <TIME>", time, "in the years 1900 to 2099 with '--moon'"))?;
            let [up, north, east] = place.frame();
            let turn = |v: DVec3| east * v.x + north * v.y + up * v.z;
            // As seen from sea level at the place, wherever above it the camera is.
            let moon = up * scene.atmosphere.planet_radius + turn(bodies.moon);
            scene.moon = Some(Moon::new(moon, MOON_RADIUS));
            scene.sun_direction = turn(bodies.sun);
            scene.atmosphere.sun_angular_radius = bodies.disks().sun;
            scene.validate().map_err(|e| UsageError::new(e.to_string()))?;
        }
        let (composition, bound) = (self.mode.settings().composition, self.bound(view.exposure));
        let sky = SkySettings { composition, bound, limb_darkening: self.limb_darkening || self.moon, ..sky };
        Ok(Shot {
            scene,
            width,
            height,
            sky,
            exposure: view.exposure,
            tone_map: self.tone_map.into(),
            dither: !self.no_dither,
            terrain,
        })
    }

    /// How the quality was asked for.
    pub fn wish(&self) -> Wish {
        let named = self.quality.as_deref().and_then(|name| Quality::from_name(name).ok()).map(Wish::Named);
        let error = self.within_error.map(Wish::WithinError);
        let budget = self.within_budget.map(Wish::WithinBudget);
        let samples = || match (self.samples, self.light_samples) {
            (None, None) => None,
            (view, light) => Some(Wish::Samples { view: view.unwrap_or(32), light: light.unwrap_or(8) }),
        };
        named.or(error).or(budget).or_else(samples).unwrap_or(Wish::Default)
    }

    /// Quality and tone map in words, for the foot of the contact sheet.
    pub fn foot(&self, quality: &str) -> String {
        format!("{quality} · tone map {}", self.tone_map.title())
    }

    fn check_altitude(&self, view: &View) -> Result<(), UsageError> {
        let radius = AtmosphereParams::preset(view.planet).map_err(|e| UsageError::new(e.to_string()))?.planet_radius;
        let lowest = -0.5 * radius;
        if view.altitude >= lowest && view.altitude <= MAX_ALTITUDE {
            return Ok(());
        }
        let text = self.altitude.as_ref().map_or_else(|| views::length(view.altitude), |a| a.text.clone());
        Err(UsageError::value(
            "--altitude <LENGTH>",
            text,
            format_args!(
                "from {} (half the radius of {} down) to {}",
                views::length(lowest),
                view.planet,
                views::length(MAX_ALTITUDE)
            ),
        ))
    }

    /// Puts the sun where place and time have it, if they were given.
    fn place_and_sun(&self, view: &mut View) -> Result<Place, UsageError> {
        let angle = [("--sun-elevation", self.sun_elevation), ("--sun-azimuth", self.sun_azimuth)];
        let angle = angle.into_iter().find_map(|(name, value)| value.map(|v| format!("{name} {v}")));
        let by_place = [("--place", self.place.is_some()), ("--time", self.time.is_some())];
        let by_place = by_place.into_iter().find_map(|(name, given)| given.then_some(name));
        if let (Some(angle), Some(by_place)) = (angle, by_place) {
            return Err(UsageError::new(format!(
                "'{angle}' cannot be used with '{by_place}': the sun stands either at --sun-elevation and \
                 --sun-azimuth, or where --place and --time put it"
            )));
        }
        match (self.place, self.time) {
            (None, None) => Ok(Place::DEFAULT),
            (Some(_), None) => Err(UsageError::new(
                "'--place <LAT,LON>' needs '--time <TIME>', as in --time 2024-06-20T20:51:00Z: \
                 together they say where the sun stands",
            )),
            (None, Some(_)) => Err(UsageError::new(
                "'--time <TIME>' needs '--place <LAT,LON>', as in --place 46.5,8.0: \
                 together they say where the sun stands",
            )),
            (Some(place), Some(time)) => {
                if !view.planet.starts_with("earth") {
                    return Err(UsageError::value(
                        "--planet <NAME>",
                        view.planet,
                        "earth or earth-like with '--time <TIME>': the ephemeris is the Earth's",
                    ));
                }
                let sun = sun::position(time, place, 0.0)
                    .map_err(|e| UsageError::value("--time <TIME>", time, format_args!("one that SPA covers: {e}")))?;
                (view.sun_elevation, view.sun_azimuth) = (sun.elevation, sun.azimuth);
                Ok(place)
            }
        }
    }
}

/// A length and how it was written.
#[derive(Clone, Debug)]
struct Length {
    metres: f64,
    text: String,
}

/// A parser of finite numbers in `lo..=hi`.
fn number(lo: f64, hi: f64, unit: &'static str) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        let value: f64 = text.trim().parse().unwrap_or(f64::NAN);
        let allowed = (lo..=hi).contains(&value);
        allowed.then_some(value).ok_or_else(|| format!("must be a number from {lo:?} to {hi:?}{unit}"))
    }
}

fn degrees(lo: f64, hi: f64) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    number(lo, hi, " degrees")
}

/// Metres, or a number with the unit m or km.
fn parse_length(text: &str) -> Result<Length, String> {
    let trimmed = text.trim();
    let (digits, unit) = if let Some(digits) = trimmed.strip_suffix("km") {
        (digits, 1000.0)
    } else {
        (trimmed.strip_suffix('m').unwrap_or(trimmed), 1.0)
    };
    let value: Option<f64> = digits.trim_end().parse().ok().filter(|v: &f64| v.is_finite());
    let metres = value.map(|v| v * unit).filter(|v| v.is_finite());
    let metres = metres.ok_or("must be a number of metres, or one with a unit as in 400m or 15km")?;
    Ok(Length { metres, text: trimmed.to_owned() })
}

fn parse_place(text: &str) -> Result<Place, String> {
    let allowed = "must be LAT,LON: degrees north from -90 to 90 and degrees east from -180 to 180, as in 46.5,8.0";
    let (latitude, longitude) = text.split_once(',').ok_or(allowed)?;
    let latitude = number(-90.0, 90.0, "")(latitude).map_err(|_| allowed)?;
    let longitude = number(-180.0, 180.0, "")(longitude).map_err(|_| allowed)?;
    Ok(Place { latitude, longitude })
}

fn parse_time(text: &str) -> Result<jiff::Timestamp, String> {
    let allowed = "must be a date, a time and an offset in RFC 3339, years 0000 to 2999, as in 2024-06-20T20:51:00Z";
    let time: jiff::Timestamp = text.trim().parse().map_err(|_| allowed)?;
    // Four digits and no sign, as RFC 3339 has it; ΔT is known for all of them.
    let year = time.to_zoned(jiff::tz::TimeZone::UTC).year();
    if (0..=2999).contains(&year) { Ok(time) } else { Err(allowed.to_owned()) }
}

pub fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let side = |s: &str| s.trim().parse().ok().filter(|n| (1..=MAX_SIDE).contains(n));
    let size = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([side(w)?, side(h)?]));
    let size = size.filter(|[w, h]| u64::from(*w) * u64::from(*h) <= MAX_PIXELS);
    size.ok_or_else(|| {
        format!(
            "must be WIDTHxHEIGHT, each from 1 to {MAX_SIDE} and at most {MAX_PIXELS} pixels in all, as in 1920x1080"
        )
    })
}

pub fn parse_frame(text: &str) -> Result<[u32; 2], String> {
    let size = parse_size(text).ok().filter(|size| size.iter().all(|side| (8..=1000).contains(side)));
    size.ok_or_else(|| "must be WIDTHxHEIGHT, each from 8 to 1000, as in 80x120".to_owned())
}

fn parse_steps(text: &str) -> Result<u32, String> {
    let value = text.trim().parse().ok().filter(|n| *n == 0 || (8..=10_000).contains(n));
    value.ok_or_else(|| "must be 0 or a whole number from 8 to 10000".to_owned())
}

fn parse_budget(text: &str) -> Result<Duration, String> {
    let time: Option<jiff::SignedDuration> = text.trim().parse().ok();
    let time = time.and_then(|t| Duration::try_from(t).ok()).filter(|t| !t.is_zero());
    time.ok_or_else(|| "must be a time above 0 with a unit, as in 5ms, 0.5ms or 1s".to_owned())
}

fn parse_samples(text: &str) -> Result<u32, String> {
    whole_number(text, MAX_SAMPLES)
}

fn parse_light_samples(text: &str) -> Result<u32, String> {
    whole_number(text, MAX_LIGHT_SAMPLES)
}

fn whole_number(text: &str, most: u32) -> Result<u32, String> {
    let value = text.trim().parse().ok().filter(|n| (1..=most).contains(n));
    value.ok_or_else(|| format!("must be a whole number from 1 to {most}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_accepts_the_definition() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }

    #[test]
    fn lengths_with_and_without_a_unit() {
        for (text, metres) in
            [("100", 100.0), ("-430m", -430.0), ("15km", 15e3), ("400 km", 4e5), ("1.5e3 m", 1500.0), ("12e3km", 12e6)]
        {
            assert_eq!(parse_length(text).unwrap().metres, metres, "{text}");
        }
        for text in ["", "m", "km", "nan", "inf", "12 miles", "1e308km"] {
            assert!(parse_length(text).is_err(), "{text}");
        }
    }

    #[test]
    fn sizes() {
        assert_eq!(parse_size("1920x1080"), Ok([1920, 1080]));
        assert_eq!(parse_size("8192X4096"), Ok([8192, 4096]));
        for text in ["0x10", "10x0", "10", "10x", "-1x5", "8193x1", "8192x8192", "1.5x2", "99999999999x1"] {
            assert!(parse_size(text).is_err(), "{text}");
        }
    }

    #[test]
    fn budgets_have_a_unit() {
        for (text, micros) in [("5ms", 5000), ("0.5ms", 500), ("16.6 ms", 16_600), ("250us", 250), ("1s", 1_000_000)] {
            assert_eq!(parse_budget(text), Ok(Duration::from_micros(micros)), "{text}");
        }
        for text in ["", "5", "0ms", "-5ms", "fast", "nan", "infms", "5 lightyears"] {
            assert!(parse_budget(text).is_err(), "{text}");
        }
    }

    #[test]
    fn times_need_an_offset() {
        assert!(parse_time("2003-10-17T12:30:30-07:00").is_ok());
        for text in ["2003-10-17T12:30:30", "2003-10-17", "noon", "2003-13-01T00:00:00Z", "-000500-01-01T00:00:00Z"] {
            assert!(parse_time(text).is_err(), "{text}");
        }
    }
}
