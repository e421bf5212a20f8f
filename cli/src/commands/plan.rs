//! `welkin plan`: which effects a picture calls for, and why.

use std::io::Write;

use clap::Args;
use serde_json::json;
use welkin::{Bound, Frame, Look, SkySettings};

use crate::args::backend::BackendChoice;
use crate::args::quality::QualityArg;
use crate::commands::render::RenderArgs;
use crate::gpu::Gpu;
use crate::quality_choice::QualityChoice;

const PLAN_ABOUT: &str = "\
Say which effects a picture calls for, why, and the passes that draw them

Takes the options of 'welkin render' and draws nothing. Without any this is the plan of the default view \
from the ground. What a plan leaves out changes no pixel by more than the bound that it names, and is \
not compiled, allocated, bound or drawn.";

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
#[command(mut_arg("output", |arg| arg.help(
    "Where 'welkin render' would write, and nothing is written here: .exr and .hdr leave out less, as they \
     hold more than 8 bits"
)))]
pub struct PlanArgs {
    #[command(flatten)]
    render: RenderArgs,

    /// Print JSON
    #[arg(long, help_heading = super::render::QUALITY_AND_OUTPUT)]
    json: bool,
}

/// Prints the plan of the picture that `welkin render` would draw.
pub fn run(args: &PlanArgs) -> anyhow::Result<()> {
    let render = &args.render;
    render.backend.gpu("the CPU's reference draws no passes")?;
    let framed = render.scene_or_default()?;
    render.look.check(framed.view.planet)?;
    // Only a budget makes anything draw.
    let budget = matches!(render.quality.asked(), QualityArg::WithinBudget(_));
    let mut gpu = Gpu::open(if budget { render.backend.backend } else { BackendChoice::Cpu })?;
    let choice = QualityChoice::new(render.quality.asked(), render.look.mode(), &mut gpu, framed.size)?;
    let request = render.request(framed, choice.sky);
    let settings = SkySettings {
        look: Look { foreground: request.terrain.is_some(), ..request.sky.look },
        ..request.sky
    };
    let plan = Frame::new(&request.scene, &settings, [request.width, request.height])?;
    let text = if args.json { json(&plan, settings.bound) } else { words(&plan, settings.bound) };
    writeln!(std::io::stdout().lock(), "{text}")?;
    Ok(())
}

fn json(plan: &Frame, bound: Option<Bound>) -> String {
    let effects: Vec<_> = plan
        .effects()
        .iter()
        .map(|e| json!({ "name": e.name, "on": e.on, "reason": e.reason.to_string() }))
        .collect();
    let passes: Vec<_> = plan
        .planned_passes()
        .iter()
        .map(|p| {
            let program = p.program.map(|program| program.name());
            json!({ "label": p.label, "program": program, "runs": p.runs.name(), "times": p.times })
        })
        .collect();
    let bound = bound.map(|b| json!({ "relative": b.relative, "absolute": b.absolute }));
    format!("{:#}", json!({ "bound": bound, "effects": effects, "passes": passes }))
}

fn words(plan: &Frame, bound: Option<Bound>) -> String {
    let mut text = match bound {
        Some(b) => {
            format!("what is off changes no pixel by more than {} of it + {:.2e}\n", b.relative, b.absolute)
        }
        None => "nothing is left out\n".to_owned(),
    };
    for e in plan.effects() {
        text += &format!("\n{:20} {:4} {}", e.name, if e.on { "on" } else { "off" }, e.reason);
    }
    let passes = plan.planned_passes();
    text += if passes.is_empty() { "\n\nno passes" } else { "\n" };
    for p in passes {
        let program = p.program.map_or_else(|| "(clears)".to_owned(), |program| program.name());
        let times = if p.times == 1 { String::new() } else { format!(" × {}", p.times) };
        text += &format!("\n{:12} {:20} {program}{times}", p.runs.name(), p.label);
    }
    text
}
