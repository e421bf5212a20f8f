//! `welkin plan`: which effects a picture calls for, and why.

use std::io::Write;

use serde_json::json;
use welkin::{Bound, EffectPlan, SkySettings};

use crate::args::PlanArgs;
use crate::choose::{Choice, Wish};
use crate::draw::{BackendChoice, Drawer};

/// Prints the plan of the picture that `welkin render` would draw.
pub fn run(args: &PlanArgs) -> anyhow::Result<()> {
    let render = &args.render;
    let (_, shot) = render.single_or_default()?;
    // Only a budget makes anything draw.
    let budget = matches!(render.wish(), Wish::WithinBudget(_));
    let mut drawer = Drawer::open(if budget { render.backend } else { BackendChoice::Cpu })?;
    let choice = Choice::of(render.wish(), render.mode(), &mut drawer, [shot.width, shot.height])?;
    let settings = SkySettings {
        composition: shot.sky.composition,
        bound: shot.sky.bound,
        limb_darkening: shot.sky.limb_darkening,
        foreground: shot.terrain.is_some(),
        ..choice.sky
    };
    let plan = EffectPlan::new(&shot.scene, &settings, [shot.width, shot.height])?;
    let text = if args.json { json(&plan, settings.bound) } else { words(&plan, settings.bound) };
    writeln!(std::io::stdout().lock(), "{text}")?;
    Ok(())
}

fn json(plan: &EffectPlan, bound: Option<Bound>) -> String {
    let effects: Vec<_> =
        plan.effects().iter().map(|e| json!({ "name": e.name, "on": e.on, "reason": e.reason.to_string() })).collect();
    let passes: Vec<_> = plan
        .passes()
        .iter()
        .map(|p| {
            let program = p.program.map(|program| program.name());
            json!({ "label": p.label, "program": program, "runs": p.runs.name(), "times": p.times })
        })
        .collect();
    let bound = bound.map(|b| json!({ "relative": b.relative, "absolute": b.absolute }));
    format!("{:#}", json!({ "bound": bound, "effects": effects, "passes": passes }))
}

fn words(plan: &EffectPlan, bound: Option<Bound>) -> String {
    let mut text = match bound {
        Some(b) => format!("what is off changes no pixel by more than {} of it + {:.2e}\n", b.relative, b.absolute),
        None => "nothing is left out\n".to_owned(),
    };
    for e in plan.effects() {
        text += &format!("\n{:20} {:4} {}", e.name, if e.on { "on" } else { "off" }, e.reason);
    }
    let passes = plan.passes();
    text += if passes.is_empty() { "\n\nno passes" } else { "\n" };
    for p in passes {
        let program = p.program.map_or_else(|| "(clears)".to_owned(), |program| program.name());
        let times = if p.times == 1 { String::new() } else { format!(" × {}", p.times) };
        text += &format!("\n{:12} {:20} {program}{times}", p.runs.name(), p.label);
    }
    text
}
