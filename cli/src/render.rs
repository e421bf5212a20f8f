//! `welkin render`: the contact sheet, or one picture.

use std::io::Write;
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};

use crate::args::RenderArgs;
use crate::choose::Choice;
use crate::draw::{self, BackendChoice, Drawer, Picture, Shot};
use crate::info;
use crate::output::Output;
use crate::progress::Progress;
use crate::sheet::{self, Panel, Sheet};
use crate::views::{self, Place, View};
use welkin::SkySettings;

/// Checks everything, then draws, then writes.
pub fn run(args: &RenderArgs) -> anyhow::Result<()> {
    match args.single()? {
        Some((view, shot)) => single(args, &view, shot),
        None => contact_sheet(args),
    }
}

fn single(args: &RenderArgs, view: &View, mut shot: Shot) -> anyhow::Result<()> {
    let output = Output::new(&args.output, false)?;
    let start = Instant::now();
    let mut drawer = Drawer::open(args.backend)?;
    let choice = Choice::of(args.wish(), args.mode(), &mut drawer, [shot.width, shot.height])?;
    let SkySettings { composition, bound, limb_darkening, .. } = shot.sky;
    shot.sky = SkySettings { composition, bound, limb_darkening, ..choice.sky };
    let progress = Progress::new(1);
    let picture = draw_one(&mut drawer, &shot, &progress, view.name)?;
    drop(progress);
    output.write(&picture)?;
    report(args, &choice, [shot.width, shot.height], &drawer, start.elapsed())
}

fn contact_sheet(args: &RenderArgs) -> anyhow::Result<()> {
    let output = Output::new(&args.output, true)?;
    let [panels @ .., compared] = &views::VIEWS;
    let start = Instant::now();
    // Before one is kept open: NVIDIA's EGL does not survive that others come and go meanwhile.
    let backends = draw::available();
    let mut drawer = Drawer::open(args.backend)?;
    let size = [sheet::PANEL_WIDTH, sheet::PANEL_HEIGHT];
    let choice = Choice::of(args.wish(), args.mode(), &mut drawer, size)?;
    let shot = |view: &View| args.shot(view, Place::DEFAULT, size, choice.sky);
    let progress = Progress::new(panels.len() + backends.len());

    let panels = panels.iter().map(|view| {
        let picture = draw_one(&mut drawer, &shot(view)?, &progress, view.name)?;
        Ok(Panel { title: view.title.to_owned(), caption: view.caption(), picture: Some(picture) })
    });
    let panels = panels.collect::<anyhow::Result<Vec<_>>>()?;
    let compared_shot = shot(compared)?;
    let comparison = compare(&backends, &compared_shot, &progress);
    drop(progress);

    let sheet = Sheet {
        title: format!("welkin {}", env!("CARGO_PKG_VERSION")),
        subtitle: drawer.describe(),
        panels,
        comparison_title: format!("One view by every backend: {}, {}", compared.title, compared.caption()),
        comparison,
        foot: format!("altitude · sun elevation · vertical field of view; {}", args.foot(&choice.name)),
    };
    output.write_png(sheet::WIDTH, sheet::HEIGHT, &sheet.compose())?;
    report(args, &choice, [sheet::WIDTH, sheet::HEIGHT], &drawer, start.elapsed())
}

/// Draws a shot and checks what came back.
fn draw_one(drawer: &mut Drawer, shot: &Shot, progress: &Progress, name: &str) -> anyhow::Result<Picture> {
    let picture = drawer.draw(shot, &progress.step(name)).with_context(|| format!("cannot draw {name}"))?;
    let pixels = shot.width as usize * shot.height as usize;
    ensure!(
        [picture.width, picture.height] == [shot.width, shot.height]
            && picture.hdr.len() == pixels
            && picture.display.len() == pixels,
        "{name}: the picture that came back is not {}×{}",
        shot.width,
        shot.height
    );
    let broken = picture.hdr.iter().filter(|p| p.iter().any(|v| !v.is_finite())).count();
    ensure!(broken == 0, "{name}: {broken} of {pixels} pixels are not finite");
    Ok(picture)
}

/// The same shot by every backend, each with its largest difference from the first; then that difference, magnified.
///
/// A backend that fails leaves an empty panel that says so.
fn compare(backends: &[BackendChoice], shot: &Shot, progress: &Progress) -> Vec<Panel> {
    let mut panels = Vec::new();
    let mut drawn: Vec<(String, Picture)> = Vec::new();
    for choice in [BackendChoice::WebGpu, BackendChoice::WebGl2, BackendChoice::Cpu] {
        let name = info::name(choice);
        if !backends.contains(&choice) {
            panels.push(Panel { title: name, caption: "not available here".to_owned(), picture: None });
            continue;
        }
        let picture = Drawer::open(choice).and_then(|mut drawer| draw_one(&mut drawer, shot, progress, &name));
        let (caption, picture) = match picture {
            Err(error) => (format!("failed: {error:#}"), None),
            Ok(picture) => {
                let caption = drawn.first().map_or_else(
                    || "what the others are compared with".to_owned(),
                    |(first, p)| {
                        format!("largest difference from {first}: {}/255", sheet::largest_difference(p, &picture))
                    },
                );
                drawn.push((name.clone(), picture.clone()));
                (caption, Some(picture))
            }
        };
        panels.push(Panel { title: name, caption, picture });
    }
    if let [(a, first), (b, second), ..] = &drawn[..] {
        panels.push(Panel {
            title: format!("{a} less {b}, × {}", sheet::MAGNIFY),
            caption: "grey where they are the same".to_owned(),
            picture: Some(sheet::difference(first, second)),
        });
    }
    panels
}

/// The quality, if it was chosen by measurements; last what there is now, who drew it, how long it took.
fn report(
    args: &RenderArgs,
    choice: &Choice,
    [width, height]: [u32; 2],
    drawer: &Drawer,
    took: Duration,
) -> anyhow::Result<()> {
    let path = args.output.display();
    let mut stdout = std::io::stdout().lock();
    if let Some(why) = &choice.why {
        writeln!(stdout, "{why}")?;
    }
    writeln!(stdout, "{path}: {width}×{height}, drawn by {} in {:.2} s", drawer.describe(), took.as_secs_f64())?;
    Ok(())
}
