//! `welkin-lab costs`: what each effect costs when it is on, and that it costs nothing when it is off.

use std::collections::HashSet;
use std::io::Write;

use anyhow::{Context, ensure};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use welkin::frame::graph::Runs;
use welkin::gpu::{Format, Target, TextureDesc};
use welkin::model::moon::{MOON_RADIUS, Moon};
use welkin::{
    AerialTargets, Airglow, AtmosphereParams, Bound, Composition, Frame, FrameTargets, Look, Quality, Scene,
    SkyRenderer, SkySettings,
};

use crate::args::backend::BackendArgs;
use crate::args::quality::{PresetArgs, march};
use crate::args::values;
use crate::gpu::Gpu;
use crate::lab::{device, timing};
use crate::progress::Progress;
use crate::views::{self, Place, View};

/// Options of `welkin-lab costs`.
#[derive(Args, Debug)]
#[command(long_about = "\
Say what each effect costs: bytes, pipelines and milliseconds

Two pictures for each effect: one that calls for it and one that does not, alike otherwise. Programs and \
textures are freed after each. The table has the difference: bytes of textures, pipelines (on WebGL2: \
programs), milliseconds of the GPU in a frame in which camera and sun move, and milliseconds once for \
each medium. The last columns count what of the effect was there when it was off: passes, and textures \
or programs more than the plan without it names.")]
#[command(mut_arg("backend", |arg| {
    arg.help("What draws: auto, webgpu or webgl2").hide_possible_values(true)
}))]
pub struct CostsArgs {
    /// Pixels of the pictures
    #[arg(long, value_name = "WxH", default_value = "960x540", value_parser = values::size)]
    size: [u32; 2],

    /// Rounds of timing, of which the best counts, 1 to 100
    #[arg(
        long, value_name = "N", default_value = "5",
        value_parser = clap::value_parser!(u32).range(1..=100)
    )]
    repeat: u32,

    /// Of this effect alone, as in 'sun disk'; may be given several times [default: every effect]
    #[arg(long = "effect", value_name = "NAME", value_parser = effect())]
    effects: Vec<&'static str>,

    #[command(flatten)]
    preset: PresetArgs,

    #[command(flatten)]
    backend: BackendArgs,
}

fn effect() -> impl TypedValueParser<Value = &'static str> {
    let named = |name: String| Frame::effect_names().into_iter().find(|n| *n == name).ok_or("not an effect");
    PossibleValuesParser::new(Frame::effect_names()).try_map(named)
}

/// A picture that calls for an effect, or does not.
#[derive(Clone)]
struct Case {
    view: View,
    params: AtmosphereParams,
    sky: SkySettings,
    moon: Option<Where>,
}

/// Where a moon stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Where {
    /// The moon is in the middle of the picture.
    Ahead,
    /// The moon is before half of the sun.
    BeforeSun,
}

/// An effect, what a case is like that does not call for it, and both cases.
struct Row {
    effect: &'static str,
    without: &'static str,
    cases: [Case; 2],
}

/// What a frame made and took.
struct Found {
    on: bool,
    bytes: usize,
    pipelines: usize,
    /// Milliseconds: of the passes that run once for a medium, and of the others.
    times: [f64; 2],
    /// Passes that the plan does not name, programs that no pass uses, textures that no pass uses.
    idle: [usize; 3],
}

/// Draws every pair and prints the table.
pub fn run(args: &CostsArgs) -> anyhow::Result<()> {
    let quality = args.preset.quality();
    let mut rows = rows(quality);
    if !args.effects.is_empty() {
        rows.retain(|row| args.effects.contains(&row.effect));
    }
    let mut gpu = Gpu::open(args.backend.gpu("what is timed are a GPU's passes")?)?;
    let describe = gpu.describe();
    let steps = Progress::of("measuring", 2 * rows.len());
    let [width, height] = args.size;
    let mut text = format!("{describe}\n\n{width}×{height}, {}; on less off:\n\n", quality);
    text += "| effect | off because | bytes | pipelines | ms a frame | ms a medium | left when off: \
     passes, pipelines, textures |\n";
    text += "|---|---|---:|---:|---:|---:|---|\n";
    for row in &rows {
        let mut found = Vec::with_capacity(2);
        for case in &row.cases {
            let progress = steps.step(row.effect);
            found.push(measure(&mut gpu, case, row.effect, args)?);
            progress(1.0);
        }
        let [on, off] = &found[..] else { continue };
        ensure!(on.on && !off.on, "{}: the plan says {} and {}", row.effect, on.on, off.on);
        let less = |a: usize, b: usize| a as i64 - b as i64;
        text += &format!(
            "| {} | {} | {} | {} | {:.3} | {:.3} | {}, {}, {} |\n",
            row.effect,
            row.without,
            less(on.bytes, off.bytes),
            less(on.pipelines, off.pipelines),
            on.times[1] - off.times[1],
            on.times[0] - off.times[0],
            off.idle[0],
            off.idle[1],
            off.idle[2],
        );
    }
    std::io::stdout().lock().write_all(text.as_bytes())?;
    Ok(())
}

fn rows(quality: Quality) -> Vec<Row> {
    let day = Case {
        view: View { pitch: 10.0, sun_azimuth: 200.0, ..views::DEFAULT },
        params: AtmosphereParams::earth(),
        sky: SkySettings { bound: Some(Bound::eight_bit(1.0)), ..SkySettings::from(quality) },
        moon: None,
    };
    let orbit = Case { view: View { altitude: 4e5, pitch: -18.0, fov: 40.0, ..day.view }, ..day.clone() };
    let dome = Case {
        sky: SkySettings { look: Look { composition: Composition::SkyDome, ..day.sky.look }, ..day.sky },
        ..day.clone()
    };
    let medium = |change: fn(&mut AtmosphereParams)| {
        let mut case = day.clone();
        change(&mut case.params);
        case
    };
    let sky = |change: fn(&mut SkySettings)| {
        let mut case = day.clone();
        change(&mut case.sky);
        case
    };
    let down = |case: &Case| Case { view: View { pitch: -90.0, fov: 40.0, ..case.view }, ..case.clone() };
    let thin = |scale: f64| {
        let mut case = day.clone();
        let p = &mut case.params;
        (p.mie_scattering, p.mie_absorption, p.ground_albedo) = ([0.0; 3], [0.0; 3], [0.0; 3]);
        p.rayleigh_scattering = p.rayleigh_scattering.map(|v| v * scale);
        case.sky.bound = Some(Bound::eight_bit(0.1));
        case
    };
    let up = Case { view: View { pitch: 50.0, ..day.view }, ..day.clone() };
    let nothing_before =
        Case { sky: SkySettings { look: Look { foreground: false, ..up.sky.look }, ..up.sky }, ..up.clone() };
    let half = sky(|s| s.render_scale = 0.5);
    let full = sky(|s| s.render_scale = 1.0);
    let march = sky(|s| s.quality = march([16, 8]));
    // Too faint for a picture of a day: without a bound nothing is left out.
    let dark = |case: &Case| Case { sky: SkySettings { bound: None, ..case.sky }, ..case.clone() };
    let glow = |case: &Case| {
        let mut case = dark(case);
        case.sky.look.airglow = Some(Airglow::EARTH);
        case
    };
    let row =
        |effect, without, on: &Case, off: &Case| Row { effect, without, cases: [on.clone(), off.clone()] };
    vec![
        row("atmosphere", "switched off", &day, &sky(|s| s.look.enabled = false)),
        row("rayleigh", "no gas", &day, &medium(|p| p.rayleigh_scattering = [0.0; 3])),
        row(
            "mie",
            "no aerosol",
            &day,
            &medium(|p| (p.mie_scattering, p.mie_absorption) = ([0.0; 3], [0.0; 3])),
        ),
        row("ozone", "no ozone", &day, &medium(|p| p.ozone_absorption = [0.0; 3])),
        row(
            "sunlight",
            "night",
            &day,
            &Case { view: View { sun_elevation: -40.0, ..day.view }, ..day.clone() },
        ),
        row("multiple scattering", "too thin to be seen twice", &thin(1e-3), &thin(1e-4)),
        row("background sky", "the planet fills the picture", &dome, &down(&dome)),
        row("planet shell", "the planet fills the picture", &orbit, &down(&orbit)),
        row("aerial perspective", "nothing before the sky", &up, &nothing_before),
        row("transmittance LUT", "marching 16 × 8", &day, &march),
        row("sky-view LUT", "marching 16 × 8", &day, &march),
        row("aerial LUT", "nothing before the sky", &up, &nothing_before),
        row("eclipse", "no moon before the sun", &Case { moon: Some(Where::BeforeSun), ..day.clone() }, &day),
        row("sun disk", "switched off", &day, &sky(|s| s.look.sun_disk = false)),
        row("moon disk", "the scene has none", &Case { moon: Some(Where::Ahead), ..day.clone() }, &day),
        row("airglow", "not asked for", &glow(&day), &dark(&day)),
        row("airglow before the planet", "not asked for", &glow(&orbit), &dark(&orbit)),
        row("reduced resolution", "render scale 1", &half, &full),
    ]
}

fn measure(gpu: &mut Gpu, case: &Case, effect: &str, args: &CostsArgs) -> anyhow::Result<Found> {
    let backend = device::current(gpu)?;
    let [width, height] = args.size;
    let scene = case.view.scene(Place::DEFAULT, f64::from(width) / f64::from(height), None)?;
    let moon = case.moon.map(|place| {
        let towards = match place {
            Where::Ahead => scene.camera.forward.normalize_or_zero(),
            Where::BeforeSun => {
                let sun = scene.sun_direction.normalize_or_zero();
                sun + sun.any_orthonormal_vector() * case.params.sun_angular_radius
            }
        };
        Moon::new(scene.camera.position + towards * 3.8e8, MOON_RADIUS)
    });
    let scene = Scene { atmosphere: case.params.clone(), moon, ..scene };
    let mut make = |label, format| backend.create_texture(&TextureDesc::new(label, width, height, format));
    let color = make("color", Format::Rgba16Float)?;
    let depth = make("depth", Format::R32Float)?;
    let out = make("out", Format::Rgba16Float)?;
    // Something 20 km away in the lower half.
    let (near, far) = (scene.depth.encode(2e4) as f32, scene.depth.background() as f32);
    let texels = (width * height) as usize;
    let depths: Vec<f32> = (0..texels).map(|i| if i < texels / 2 { far } else { near }).collect();
    backend.write_texture(depth, &depths)?;
    let before = backend.live();
    let mut sky = SkyRenderer::new(case.sky)?;
    let black = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(color) };
    let aerial = AerialTargets { color: Some(color), depth, target: Target::color(out) };
    let frame = sky.frame(backend, &scene, &FrameTargets::background(black).with_aerial(aerial))?;
    let passes = [frame.background, frame.aerial].concat();
    let plan = frame.frame.clone();
    // Makes pipelines and warms caches; it does not count.
    backend.times(&passes)?;
    let best = timing::best_of(backend, &passes, args.repeat)?;
    let live = backend.live();
    let named = plan.planned_passes();
    let mut times = [0.0; 2];
    for (pass, time) in passes.iter().zip(best) {
        let often = named.iter().any(|n| n.label == pass.label && n.runs != Runs::PerMedium);
        times[usize::from(often)] += 1e-6 * time.nanoseconds;
    }
    // Without a program it clears a target, as its owner says, which nothing is drawn to.
    let drawn = passes.iter().filter(|p| p.program.is_some());
    let strangers = drawn.filter(|p| !named.iter().any(|n| n.label == p.label)).count();
    let programs: HashSet<_> = passes.iter().filter_map(|p| p.program).collect();
    let mut textures: HashSet<_> = passes.iter().map(|p| p.target.color).collect();
    textures.extend(passes.iter().flat_map(|p| p.inputs.iter().filter_map(|(_, id)| id)));
    textures.retain(|id| ![color, depth, out].contains(id));
    let found = Found {
        on: plan.effect(effect).with_context(|| format!("no effect '{effect}'"))?.on,
        bytes: live.texture_bytes - before.texture_bytes,
        pipelines: if live.pipelines > 0 {
            live.pipelines - before.pipelines
        } else {
            live.programs - before.programs
        },
        times,
        idle: [
            strangers,
            live.programs - before.programs - programs.len(),
            live.textures - before.textures - textures.len(),
        ],
    };
    sky.destroy(backend);
    programs.into_iter().for_each(|id| backend.destroy_program(id));
    [color, depth, out].into_iter().for_each(|id| backend.destroy_texture(id));
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_has_its_pictures() {
        let rows = rows(Quality::LOW);
        for effect in Frame::effect_names() {
            assert_eq!(rows.iter().filter(|row| row.effect == effect).count(), 1, "{effect}");
        }
        assert_eq!(rows.len(), Frame::effect_names().len());
    }
}
