//! `welkin render`: the contact sheet, or one picture.

use std::io::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};
use clap::Args;
use welkin::SkySettings;

use crate::args::backend::{BackendArgs, BackendChoice};
use crate::args::look::LookArgs;
use crate::args::output::OutputArgs;
use crate::args::quality::QualityArgs;
use crate::args::scene::{FramedScene, SceneArgs};
use crate::args::usage::UsageError;
use crate::gpu::{self, Gpu};
use crate::output::Output;
use crate::picture::{Picture, RenderRequest};
use crate::progress::Progress;
use crate::quality_choice::QualityChoice;
use crate::sheet::{self, Panel, Sheet};
use crate::views::{self, Place, View};

const RENDER_ABOUT: &str = "\
Draw a sky: a contact sheet of many views, or one picture

Without an option that says what is seen (the groups \"View\", \"Sun\" and \"Picture\" below) this \
draws the contact sheet: the sky from the ground to far orbit on Earth and Mars, and one view by every \
backend side by side with their largest difference. Each of those options asks for a single picture \
instead.";

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

/// What the CPU draws.
const CPU_METHOD: &str = "light scattered once, by the f64 reference";

/// The heading of the options that say how it is drawn.
pub const QUALITY_AND_OUTPUT: &str = "Quality and output";

/// Options of `welkin render`.
#[derive(Args, Debug)]
#[command(long_about = RENDER_ABOUT, after_long_help = RENDER_EXAMPLES)]
#[command(after_help = "Examples and more words: welkin render --help")]
#[command(mut_arg("output", |arg| arg.help(
    "Where to write; the ending decides: .png is 8-bit sRGB, .exr and .hdr are linear radiance [default: \
     welkin.png]"
)))]
pub struct RenderArgs {
    /// `None` asks for the contact sheet.
    #[command(flatten)]
    pub scene: Option<SceneArgs>,

    #[command(flatten, next_help_heading = QUALITY_AND_OUTPUT)]
    pub look: LookArgs,

    #[command(flatten, next_help_heading = QUALITY_AND_OUTPUT)]
    pub quality: QualityArgs,

    #[command(flatten, next_help_heading = QUALITY_AND_OUTPUT)]
    pub backend: BackendArgs,

    #[command(flatten, next_help_heading = QUALITY_AND_OUTPUT)]
    pub output: OutputArgs,
}

impl RenderArgs {
    fn output(&self) -> &Path {
        self.output.path_or("welkin.png")
    }

    /// The scene that is asked for, or that of the default view.
    pub fn scene_or_default(&self) -> Result<FramedScene, UsageError> {
        let default = SceneArgs::default();
        self.scene.as_ref().unwrap_or(&default).scene(self.look.terrain())
    }

    /// The options given of which the CPU's reference takes no notice, as errors name them.
    fn unheeded_by_cpu(&self) -> Vec<&'static str> {
        self.quality.option().into_iter().chain(self.look.unheeded_by_cpu()).collect()
    }

    /// Refuses what the CPU, where it was asked for, would take no notice of.
    fn check_cpu(&self) -> Result<(), UsageError> {
        match (self.backend.backend, self.unheeded_by_cpu().first()) {
            // That error says more: what draws here.
            (BackendChoice::Cpu, Some(option)) if !option.starts_with("--within-budget") => {
                Err(UsageError::new(format!(
                    "'{option}' is not for '--backend cpu', which draws {CPU_METHOD}, nothing else"
                )))
            }
            _ => Ok(()),
        }
    }

    /// Says so where the CPU stood in and took no notice of an option.
    fn note_cpu(&self, gpu: &mut Gpu) {
        let unheeded = self.unheeded_by_cpu();
        if gpu.backend().is_none() && !unheeded.is_empty() {
            let options = unheeded.join(", ");
            let note = format!("note: drawn without {options}: the CPU draws {CPU_METHOD}, nothing else");
            let _ = writeln!(std::io::stderr(), "{note}");
        }
    }

    /// A scene to be drawn as these options say, with a sky of this quality.
    pub fn request(&self, framed: FramedScene, quality: SkySettings) -> RenderRequest {
        let moon = framed.scene.moon.is_some();
        let sky = self.look.sky(quality, &framed.view, moon, self.output());
        RenderRequest::new(framed, &self.look, sky)
    }
}

/// Checks everything, then draws, then writes.
pub fn run(args: &RenderArgs) -> anyhow::Result<()> {
    match &args.scene {
        Some(scene) => single(args, scene.scene(args.look.terrain())?),
        None => contact_sheet(args),
    }
}

fn single(args: &RenderArgs, framed: FramedScene) -> anyhow::Result<()> {
    args.look.check(framed.view.planet)?;
    args.check_cpu()?;
    let output = Output::new(args.output(), false)?;
    let start = Instant::now();
    let (name, size) = (framed.view.name, framed.size);
    let mut gpu = Gpu::open(args.backend.backend)?;
    let choice = QualityChoice::new(args.quality.asked(), args.look.mode(), &mut gpu, size)?;
    let radiance = output.radiance();
    let request = RenderRequest { radiance, ..args.request(framed, choice.sky) };
    let steps = Progress::new(1);
    let picture = draw_one(&mut gpu, &request, &steps, name)?;
    drop(steps);
    output.write(&picture)?;
    args.note_cpu(&mut gpu);
    report(args, &choice, size, &gpu, start.elapsed())
}

fn contact_sheet(args: &RenderArgs) -> anyhow::Result<()> {
    let output = Output::new(args.output(), true)?;
    let [panels @ .., compared] = &views::VIEWS;
    let start = Instant::now();
    // Before one is kept open: NVIDIA's EGL does not survive that others come and go meanwhile.
    let (backends, missing) = gpu::available();
    let mut gpu = Gpu::open(args.backend.backend)?;
    let size = [sheet::PANEL_WIDTH, sheet::PANEL_HEIGHT];
    let choice = QualityChoice::new(args.quality.asked(), args.look.mode(), &mut gpu, size)?;
    let request = |view: &View| {
        let terrain = args.look.terrain().then(|| view.terrain());
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        let scene = view.scene(Place::DEFAULT, aspect, terrain.as_ref())?;
        anyhow::Ok(args.request(FramedScene { view: *view, scene, terrain, size }, choice.sky))
    };
    let steps = Progress::new(panels.len() + backends.len());

    let panels = panels.iter().map(|view| {
        let picture = draw_one(&mut gpu, &request(view)?, &steps, view.name)?;
        Ok(Panel { title: view.title.to_owned(), caption: view.caption(), picture })
    });
    let panels = panels.collect::<anyhow::Result<Vec<_>>>()?;
    let mut comparison = Comparison::draw(&backends, &request(compared)?, &steps);
    comparison.failed.extend(missing);
    drop(steps);

    let sheet = Sheet {
        title: format!("welkin {}", env!("CARGO_PKG_VERSION")),
        subtitle: gpu.adapter(),
        panels,
        comparison_title: comparison.title(compared),
        comparison: comparison.panels,
        foot: format!(
            "altitude · sun elevation · vertical field of view; {} · tone map {}",
            if gpu.backend().is_some() { &choice.name } else { CPU_METHOD },
            args.look.tone_map_title()
        ),
    };
    let (width, height, pixels) = sheet.compose();
    output.write_png(width, height, &pixels)?;
    args.note_cpu(&mut gpu);
    for (name, why) in &comparison.failed {
        let _ = writeln!(std::io::stderr(), "note: left out of the contact sheet: {name}: {why}");
    }
    report(args, &choice, [width, height], &gpu, start.elapsed())?;
    Ok(())
}

/// Draws a request and checks what came back.
fn draw_one(gpu: &mut Gpu, request: &RenderRequest, steps: &Progress, name: &str) -> anyhow::Result<Picture> {
    let picture = gpu.draw(request, &steps.step(name)).with_context(|| format!("cannot draw {name}"))?;
    let pixels = request.width as usize * request.height as usize;
    ensure!(
        [picture.width, picture.height] == [request.width, request.height]
            && picture.hdr.len() == pixels
            && picture.display.len() == pixels,
        "{name}: the picture that came back is not {}×{}",
        request.width,
        request.height
    );
    let broken = picture.hdr.iter().filter(|p| p.iter().any(|v| !v.is_finite())).count();
    ensure!(broken == 0, "{name}: {broken} of {pixels} pixels are not finite");
    Ok(picture)
}

/// One view by every backend that this machine has.
struct Comparison {
    panels: Vec<Panel>,
    /// How many of the panels are a backend's picture.
    drawn: usize,
    /// Which backends failed, and why.
    failed: Vec<(&'static str, String)>,
}

impl Comparison {
    /// The same request by every backend, each with its largest difference from the first; then that
    /// difference between two GPU backends, magnified. A backend that fails has no panel.
    fn draw(backends: &[BackendChoice], request: &RenderRequest, steps: &Progress) -> Self {
        let (mut panels, mut failed) = (Vec::new(), Vec::new());
        let mut drawn: Vec<(&str, Picture)> = Vec::new();
        for choice in backends {
            let name = choice.name();
            let picture =
                match Gpu::open(*choice).and_then(|mut gpu| draw_one(&mut gpu, request, steps, name)) {
                    Err(error) => {
                        failed.push((name, format!("{error:#}")));
                        continue;
                    }
                    Ok(picture) => picture,
                };
            let caption = match drawn.first() {
                None if backends.len() == 1 => "the only one that can draw here".to_owned(),
                None => "what the others are compared with".to_owned(),
                Some((first, p)) => {
                    let most = sheet::largest_difference(p, &picture);
                    match choice {
                        // No fault of a backend.
                        BackendChoice::Cpu => format!("light scattered once: {most}/255 from {first}"),
                        _ => format!("largest difference from {first}: {most}/255"),
                    }
                }
            };
            panels.push(Panel { title: name.to_owned(), caption, picture: picture.clone() });
            drawn.push((name, picture));
        }
        // The CPU's light is scattered once: what it differs by is no fault of a backend.
        let on_gpu = |(name, _): &&(&str, Picture)| *name != BackendChoice::Cpu.name();
        if let [(a, first), (b, second)] = &drawn.iter().filter(on_gpu).collect::<Vec<_>>()[..] {
            panels.push(Panel {
                title: format!("{a} less {b}, × {}", sheet::MAGNIFY),
                caption: "grey where they are the same".to_owned(),
                picture: sheet::difference(first, second),
            });
        }
        Self { panels, drawn: drawn.len(), failed }
    }

    fn title(&self, view: &View) -> String {
        let by = if self.drawn > 1 { "One view by every backend" } else { "One more view" };
        let failed: Vec<_> = self.failed.iter().map(|(name, _)| *name).collect();
        let but =
            if failed.is_empty() { String::new() } else { format!(" (not here: {})", failed.join(", ")) };
        format!("{by}{but}: {}, {}", view.title, view.caption())
    }
}

/// Prints the quality, if it was chosen by measurements; last what there is now, who drew it, how long it
/// took.
fn report(
    args: &RenderArgs,
    choice: &QualityChoice,
    [width, height]: [u32; 2],
    gpu: &Gpu,
    took: Duration,
) -> anyhow::Result<()> {
    let path = args.output().display();
    let mut stdout = std::io::stdout().lock();
    if let Some(why) = &choice.why {
        writeln!(stdout, "{why}")?;
    }
    writeln!(stdout, "{path}: {width}×{height}, drawn by {} in {:.2} s", gpu.describe(), took.as_secs_f64())?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    #[derive(Parser)]
    struct Options {
        #[command(flatten)]
        render: RenderArgs,
    }

    /// The panels' titles, the heading, and how many backends failed.
    fn compared(backends: &[BackendChoice], options: &[&str]) -> (Vec<String>, String, usize) {
        let small = ["test", "--view", "summit", "--size", "8x6", "--samples", "500", "--no-terrain"];
        let args = Options::parse_from(small.iter().chain(options)).render;
        let request = args.request(args.scene_or_default().unwrap(), march_sky(&args));
        let comparison = Comparison::draw(backends, &request, &Progress::new(backends.len()));
        let heading = comparison.title(&views::DEFAULT);
        assert!(comparison.panels.iter().all(|p| p.picture.width == 8 && p.picture.display.len() == 48));
        (comparison.panels.into_iter().map(|p| p.title).collect(), heading, comparison.failed.len())
    }

    fn march_sky(args: &RenderArgs) -> SkySettings {
        let mut cpu = Gpu::open(BackendChoice::Cpu).unwrap();
        QualityChoice::new(args.quality.asked(), args.look.mode(), &mut cpu, [8, 6]).unwrap().sky
    }

    /// What is not drawn has no place on the sheet.
    #[test]
    fn one_view_is_drawn_by_what_is_there() {
        use BackendChoice::{Cpu, WebGl2, WebGpu};
        let (titles, heading, failed) = compared(&[WebGpu, WebGl2, Cpu], &[]);
        assert_eq!((titles, failed), (vec!["webgpu".into(), "webgl2".into(), "cpu".into(), LESS.into()], 0));
        assert!(heading.starts_with("One view by every backend: Ground, 100 m"), "{heading}");
        // No magnified difference from the CPU, which is another method's.
        for gpu in [WebGpu, WebGl2] {
            let (titles, heading, _) = compared(&[gpu, Cpu], &[]);
            assert_eq!(titles, [gpu.name(), "cpu"]);
            assert!(heading.starts_with("One view by every backend"), "{heading}");
        }
        let (titles, heading, _) = compared(&[Cpu], &[]);
        assert_eq!(titles, ["cpu"]);
        assert!(heading.starts_with("One more view: "), "{heading}");
        // More samples than llvmpipe takes: it fails, is told and left out.
        let (titles, _, failed) = compared(&[WebGl2, Cpu], &["--light-samples", "256"]);
        assert_eq!((titles.len() + failed, titles.last().unwrap().as_str()), (2, "cpu"));
    }

    const LESS: &str = "webgpu less webgl2, × 32";
}
