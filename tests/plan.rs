//! What a plan leaves out: why, how little it changes, and that nothing is made for it. On both backends.
//!
//! `WELKIN_SCENES=2000 cargo test --all-features --test all plan -- --nocapture` tries more random scenes and
//! prints the largest changes.

use std::collections::BTreeMap;

use welkin::gpu::{Backend, Target};
use welkin::{
    AtmosphereParams, Bound, Composition, Frame, Look, LutSettings, MiePhase, Quality, SkyRenderer,
    SkySettings,
};

use crate::harness::{
    View, airless, asked_for, clear_pass, cleared, draw, frame_passes, frame_textures, free, march, on_both,
};

const SIZE: [u32; 2] = [12, 9];

/// A view with settings, in front of a plane at a distance (metres; infinite for none) and of stars.
#[derive(Clone, Debug)]
struct Case {
    view: View,
    sky: SkySettings,
    plane: f64,
    behind: f32,
}

impl Case {
    fn plan(&self) -> Frame {
        Frame::new(&self.view.scene(), &self.sky, SIZE).unwrap()
    }

    /// Radiance, and the bound that the plan had.
    fn draw(&self, b: &mut dyn Backend, sky: &mut SkyRenderer, bound: Option<Bound>) -> Vec<f32> {
        sky.set_settings(SkySettings { bound, ..self.sky }).unwrap();
        let scene = self.view.scene();
        let [color, depth, out] = frame_textures(b, SIZE);
        let stored =
            |z: f64| if z.is_finite() { scene.depth.encode(z) } else { scene.depth.background() } as f32;
        let texels = (SIZE[0] * SIZE[1]) as usize;
        // Columns of the plane and of what is behind it.
        let depths: Vec<f32> =
            (0..texels).map(|i| stored(if i % 3 == 0 { self.plane } else { f64::INFINITY })).collect();
        b.write_texture(depth, &depths).unwrap();
        let clear = [self.behind, self.behind, self.behind, 1.0];
        let mut passes = vec![clear_pass(color, clear)];
        let (drawn, done) = frame_passes(b, sky, &scene, Target::color(color), [color, depth, out]);
        passes.extend(drawn);
        b.run(&passes).unwrap();
        let pixels = b.read(done).unwrap();
        free(b, [color, depth, out]);
        pixels
    }
}

/// The largest change that a plan makes, as a share of its bound, and which effects it leaves out.
fn change(b: &mut dyn Backend, case: &Case, renderers: &mut [SkyRenderer; 2]) -> (f64, String) {
    let bound = case.sky.bound.unwrap();
    let [planned, whole] = renderers;
    let (some, all) = (case.draw(b, planned, Some(bound)), case.draw(b, whole, None));
    let rounding = 2e-6; // Of 32-bit floats, in programs that a compiler orders differently.
    let share = |(a, b): (&f32, &f32)| {
        let (a, b) = (f64::from(*a), f64::from(*b));
        assert!(a.is_finite() && b.is_finite(), "{case:?}");
        (a - b).abs() / ((bound.relative + rounding) * a.max(b) + bound.absolute)
    };
    let worst = some.iter().zip(&all).map(share).fold(0.0, f64::max);
    let full = Frame::new(&case.view.scene(), &SkySettings { bound: None, ..case.sky }, SIZE).unwrap();
    let plan = case.plan();
    let off: Vec<_> = plan
        .effects()
        .iter()
        .zip(full.effects())
        .filter(|(a, b)| b.on && !a.on)
        .map(|(e, _)| e.name)
        .collect();
    (worst, off.join(", "))
}

/// Runs cases on both backends, prints the largest change for every set of effects that was left out, and
/// checks them.
fn check(name: &str, cases: &[Case]) -> BTreeMap<String, usize> {
    let mut seen = BTreeMap::new();
    on_both(|b| {
        let mut worst: BTreeMap<String, (f64, usize, usize)> = BTreeMap::new();
        let mut renderers = [SkyRenderer::default(), SkyRenderer::default()];
        for (i, case) in cases.iter().enumerate() {
            let (share, off) = change(b, case, &mut renderers);
            let entry = worst.entry(off).or_default();
            entry.1 += 1;
            if share >= entry.0 {
                (entry.0, entry.2) = (share, i);
            }
        }
        renderers.iter_mut().for_each(|r| r.destroy(b));
        for (off, (share, count, at)) in &worst {
            println!(
                "{} {name}: without {off:?}: {count} scenes, {share:.3} of the bound, case {at}",
                b.info().backend
            );
            *seen.entry(off.clone()).or_default() += count;
        }
        for (off, (share, _, at)) in &worst {
            assert!(
                *share <= 1.0,
                "{name}: without {off}: {share} of the bound: {:?}\n{:?}",
                cases[*at],
                cases[*at].plan()
            );
        }
    });
    seen
}

/// Small LUTs: how exact they are does not matter here.
pub fn luts() -> Quality {
    Quality::Luts(LutSettings {
        transmittance: [24, 12],
        multi_scattering: [12, 8],
        multi_scattering_steps: 4,
        orders: 3,
        sky_view: [12, 20],
        sky_view_steps: 6,
        aerial: [4, 10, 4],
        aerial_steps: 1,
    })
}

/// From the ground to the moon's distance, around to the night side and back down.
fn flight(method: Quality) -> Vec<Case> {
    let sky = SkySettings { quality: method, bound: Some(Bound::eight_bit(1.0)), ..SkySettings::default() };
    let up = [2.0, 500.0, 5e3, 14e3, 16e3, 30e3, 49e3, 51e3, 99e3, 101e3, 4e5, 6e6, 3.8e8];
    let leg = |altitude: f64, sun_elevation: f64, pitch: f64| Case {
        view: View { altitude, sun_elevation, pitch, ..View::default() },
        sky,
        plane: 2e3_f64.max(altitude),
        behind: 0.01,
    };
    let down = up.into_iter().rev();
    let day = up.into_iter().flat_map(|h| [-90.0, -10.0, 25.0].map(|pitch| leg(h, 30.0, pitch)));
    let night = down.flat_map(|h| [-90.0, -10.0, 25.0].map(|pitch| leg(h, -40.0, pitch)));
    let dusk = (0..24).map(|i| leg(2.0, 3.0 - f64::from(i), 10.0));
    day.chain(dusk).chain(night).collect()
}

#[test]
fn a_flight_changes_by_no_more_than_the_bound() {
    for method in [march(32, 8), luts()] {
        let seen = check(method.method(), &flight(method));
        assert!(seen.keys().any(|off| off.contains("sunlight")), "no night in {seen:?}");
        assert!(
            seen.keys().any(|off| off.contains("background sky")),
            "no sky out of the picture in {seen:?}"
        );
        assert!(seen.keys().any(|off| off.contains("atmosphere")), "never without the planet in {seen:?}");
    }
}

/// Random scenes: any altitude, any view, any sun, any way to draw, and media from next to nothing to thick.
fn random(count: usize) -> Vec<Case> {
    let mut rng = fastrand::Rng::with_seed(6);
    let mut uniform = move |lo: f64, hi: f64| lo + (hi - lo) * rng.f64();
    (0..count)
        .map(|i| {
            let mut params = AtmosphereParams::preset(AtmosphereParams::PRESETS[i % 5]).unwrap();
            let thickness = params.thickness();
            if i % 3 > 0 {
                // Every constituent from a billionth of the preset's to twice as much; some have none.
                let mut scale =
                    || if uniform(0.0, 1.0) < 0.15 { 0.0 } else { 10_f64.powf(uniform(-9.0, 0.3)) };
                params.rayleigh_scattering = params.rayleigh_scattering.map(|v| v * scale());
                let haze = scale();
                params.mie_scattering = params.mie_scattering.map(|v| v * haze);
                params.mie_absorption = params.mie_absorption.map(|v| v * haze);
                let ozone = scale();
                params.ozone_absorption = params.ozone_absorption.map(|v| v * ozone);
                params.ground_albedo = [[0.0, 0.1, 0.9][i % 3]; 3];
                params.mie_asymmetry = [uniform(-0.9, 0.9); 3];
                params.mie_phase = [MiePhase::HenyeyGreenstein, MiePhase::CornetteShanks][i % 2];
                params.rayleigh_scale_height *= uniform(0.3, 2.0);
                params.mie_scale_height *= uniform(0.3, 3.0);
            }
            let far = [1.0, 2.0, 1e3][i % 3] * params.planet_radius;
            let altitude = match i % 4 {
                0 => uniform(0.0, thickness),
                1 => uniform(0.9, 1.1) * thickness,
                _ => 10_f64.powf(uniform(0.0, far.log10())),
            };
            let view = View {
                params,
                altitude,
                pitch: uniform(-90.0, 90.0),
                heading: uniform(0.0, 360.0),
                fov: 10_f64.powf(uniform(-1.0, 2.0)),
                sun_elevation: if i % 2 == 0 { uniform(-90.0, 0.0) } else { uniform(-20.0, 90.0) },
                aspect: 4.0 / 3.0,
            };
            let method = [march(32, 8), luts()][usize::from(uniform(0.0, 1.0) < 0.3)];
            let composition =
                [Composition::Full, Composition::SkyDome, Composition::AtmospherePost, Composition::Planet]
                    [i / 3 % 4];
            let bound =
                [Bound::LINEAR, Bound::eight_bit(1.0), Bound::eight_bit(0.01), Bound::EXACT][i / 7 % 4];
            let foreground = i % 5 > 0;
            let sky = SkySettings {
                look: Look { composition, foreground, ..Look::default() },
                quality: method,
                bound: Some(bound),
                ..SkySettings::default()
            };
            let plane = if foreground { 10_f64.powf(uniform(0.0, 7.0)) } else { f64::INFINITY };
            Case { view, sky, plane, behind: [0.0, 0.5][i / 2 % 2] }
        })
        .collect()
}

#[test]
fn random_scenes_change_by_no_more_than_the_bound() {
    let count = asked_for("WELKIN_SCENES", 160);
    let seen = check("random", &random(count));
    for effect in
        ["rayleigh", "mie", "ozone", "sunlight", "multiple scattering", "sun disk", "background sky"]
    {
        assert!(seen.keys().any(|off| off.contains(effect)), "{effect} was never left out");
    }
}

fn plan(view: View, sky: SkySettings) -> Frame {
    Frame::new(&view.scene(), &sky, SIZE).unwrap()
}

/// Name of every effect that is on.
fn on(plan: &Frame) -> Vec<&'static str> {
    plan.effects().iter().filter(|e| e.on).map(|e| e.name).collect()
}

fn why(plan: &Frame, name: &str) -> String {
    plan.effect(name).unwrap().reason.to_string()
}

#[test]
fn scenes_call_for_what_they_should() {
    let sky = SkySettings::default();
    let ground = View { pitch: 10.0, heading: 180.0, ..View::default() };
    // Day, from the ground.
    let day = plan(ground.clone(), sky);
    for name in [
        "rayleigh",
        "mie",
        "ozone",
        "sunlight",
        "multiple scattering",
        "background sky",
        "aerial perspective",
    ] {
        assert!(on(&day).contains(&name), "{name}: {}", why(&day, name));
    }
    assert_eq!(
        why(&day, "planet shell"),
        "below the hand-over the background is all of the sky; camera at 0.1 km"
    );
    assert_eq!(why(&day, "sun disk"), "outside the picture");
    // No air, and no sun in sight: nothing at all.
    let none = plan(View { params: airless(ground.params.clone()), ..ground.clone() }, sky);
    assert!(none.planned_passes().is_empty() && on(&none).is_empty(), "{none:?}");
    assert_eq!(why(&none, "atmosphere"), "no constituent has a coefficient above 0");
    let off = plan(ground.clone(), SkySettings { look: Look { enabled: false, ..sky.look }, ..sky });
    assert!(off.planned_passes().is_empty() && why(&off, "atmosphere") == "switched off");
    // The hand-over.
    let shell = |altitude| {
        let plan = plan(View { altitude, pitch: -5.0, ..ground.clone() }, sky);
        ["background sky", "planet shell"].map(|n| on(&plan).contains(&n))
    };
    assert_eq!(
        [14.9e3, 15.1e3, 49.9e3, 50.1e3].map(shell),
        [[true, false], [true, true], [true, true], [false, true]]
    );
    // The planet outside the picture: nothing, from just above the air to the moon's distance.
    for altitude in [1.5e5, 4e5, 3.8e8] {
        let away = plan(View { altitude, pitch: 50.0, ..ground.clone() }, sky);
        assert!(away.planned_passes().is_empty(), "{altitude}: {away:?}");
        assert_eq!(why(&away, "atmosphere"), "outside the picture");
        let there = plan(View { altitude, pitch: -90.0, ..ground.clone() }, sky);
        assert!(on(&there).contains(&"aerial perspective"), "{altitude}");
    }
    // Straight down there is no sky; straight up, without a scene, there is nothing before it.
    let down = plan(View { pitch: -90.0, ..ground.clone() }, sky);
    assert_eq!(why(&down, "background sky"), "the planet fills the picture");
    let up = plan(
        View { pitch: 60.0, ..ground.clone() },
        SkySettings { look: Look { foreground: false, ..sky.look }, ..sky },
    );
    assert_eq!(why(&up, "aerial perspective"), "nothing lies before the sky");
    assert!(!on(&up).contains(&"aerial LUT"));
    // The sun behind the planet.
    let set = plan(View { heading: 0.0, sun_elevation: -5.0, ..ground.clone() }, sky);
    assert_eq!(why(&set, "sun disk"), "behind the planet");
}

#[test]
fn night_begins_where_the_light_does_not_count() {
    let sky = |method, bound| SkySettings { quality: method, bound: Some(bound), ..SkySettings::default() };
    // Degrees of the sun below the horizontal at which the night begins.
    let begins = |altitude: f64, sky: SkySettings| {
        let pitch = if altitude > 1e5 { -90.0 } else { 0.0 };
        let view = |d: f64| View { altitude, pitch, sun_elevation: -d, ..View::default() };
        let lit = |d: f64| on(&plan(view(d), sky)).contains(&"sunlight");
        assert!(lit(0.0), "never day");
        (0..=1800).map(|i| f64::from(i) * 0.05).find(|&d| !lit(d))
    };
    let seen = Bound::eight_bit(1.0);
    let from_ground = begins(1.7, sky(luts(), seen)).unwrap();
    assert!((16.0..19.0).contains(&from_ground), "{from_ground}");
    // Marching: where the shadow covers all air in sight, acos(6360 / 6460) twice, even if nothing may
    // change.
    let covered = begins(0.0, sky(march(32, 8), Bound::EXACT)).unwrap();
    assert!((covered - 2.0 * (6360.0_f64 / 6460.0).acos().to_degrees()).abs() < 0.2, "{covered}");
    // Deeper for a camera that sees over the horizon, by its dip.
    let dip = (6360.0_f64 / 6390.0).acos().to_degrees();
    let high = begins(30e3, sky(march(32, 8), Bound::EXACT)).unwrap();
    assert!((high - covered - dip).abs() < 0.2, "{high} {covered} {dip}");
    // Later in a longer exposure, never in one without end, and never from far away.
    assert!(begins(1.7, sky(luts(), Bound::eight_bit(1e4))).unwrap() > from_ground + 4.0);
    assert_eq!(begins(1.7, sky(luts(), Bound::EXACT)), None);
    assert_eq!(begins(3.8e8, sky(luts(), seen)), None);
}

/// What half an 8-bit step is worth: no radiance and no tone map turns a bound into more.
#[test]
fn eight_bits_show_no_more_than_half_a_step() {
    use welkin::ToneMap;
    use welkin::frame::tone_map::{srgb_encode, tone_map};
    let mut worst: f64 = 0.0;
    for curve in ToneMap::ALL {
        for exposure in [1e-3, 1.0, 1e4] {
            let bound = Bound::eight_bit(exposure);
            for i in 0..4000 {
                let radiance = 10_f64.powf(-7.0 + 10.0 * f64::from(i) / 4000.0) / exposure;
                for tint in [[1.0, 1.0, 1.0], [0.3, 0.6, 1.0], [1.0, 0.4, 0.1]] {
                    let color = tint.map(|t| t * radiance);
                    let more = color.map(|v| v * (1.0 + bound.relative) + bound.absolute);
                    let [a, b] =
                        [color, more].map(|c| tone_map(curve, c.map(|v| v * exposure)).map(srgb_encode));
                    worst = (0..3).map(|c| (a[c] - b[c]).abs() * 255.0).fold(worst, f64::max);
                }
            }
        }
    }
    println!("largest change of a display value: {worst:.3} of 1/255");
    assert!(worst < 0.5, "{worst}");
}

/// What is off is not compiled, allocated, bound or drawn; and what is drawn is what the plan says.
#[test]
fn nothing_is_made_for_what_is_off() {
    let sky = |method| SkySettings { quality: method, ..SkySettings::default() };
    let ground = View { pitch: 10.0, ..View::default() };
    let thin = |scale: f64| {
        let mut view = ground.clone();
        view.params.rayleigh_scattering = view.params.rayleigh_scattering.map(|v| v * scale);
        view.params.ground_albedo = [0.0; 3];
        View {
            params: AtmosphereParams { mie_scattering: [0.0; 3], mie_absorption: [0.0; 3], ..view.params },
            ..view
        }
    };
    let cases = [
        ("day", ground.clone(), sky(luts())),
        ("march", ground.clone(), sky(march(32, 8))),
        ("half", ground.clone(), SkySettings { render_scale: 0.5, ..sky(march(32, 8)) }),
        ("night", View { sun_elevation: -60.0, ..ground.clone() }, sky(luts())),
        ("night, marched", View { sun_elevation: -60.0, ..ground.clone() }, sky(march(32, 8))),
        ("away", View { altitude: 4e5, pitch: 60.0, ..ground.clone() }, sky(luts())),
        ("down", View { altitude: 4e5, pitch: -90.0, ..ground.clone() }, sky(luts())),
        ("thin", thin(1e-7), SkySettings { bound: Some(Bound::eight_bit(1.0)), ..sky(luts()) }),
        ("thinner", thin(1e-4), SkySettings { bound: Some(Bound::eight_bit(0.1)), ..sky(luts()) }),
    ];
    for (name, view, settings) in cases {
        on_both(|b| {
            let scene = view.scene();
            let [color, depth, out] = frame_textures(b, SIZE);
            let before = b.live();
            let mut renderer = SkyRenderer::new(settings).unwrap();
            let plan = renderer.plan(&scene, SIZE).unwrap();
            let (passes, _) = frame_passes(b, &mut renderer, &scene, cleared(color), [color, depth, out]);
            b.run(&passes).unwrap();
            let live = b.live();
            // The passes, and how often each; the order within the LUTs is the renderer's.
            let mut wanted: Vec<&str> = plan
                .planned_passes()
                .iter()
                .flat_map(|p| std::iter::repeat_n(p.label, p.times as usize))
                .collect();
            // Where nothing is drawn the target is cleared nonetheless.
            let mut drawn: Vec<&str> = passes.iter().map(|p| p.label).filter(|l| *l != "clear").collect();
            wanted.sort_unstable();
            drawn.sort_unstable();
            assert_eq!(drawn, wanted, "{name}");
            // A program for each that the plan names, and no other.
            let programs: std::collections::HashSet<_> =
                plan.planned_passes().iter().filter_map(|p| p.program).collect();
            assert_eq!(live.programs - before.programs, programs.len(), "{name}: programs");
            // Textures: what the passes draw to and read, besides the user's.
            let mut used: Vec<_> = passes.iter().map(|p| p.target.color).collect();
            used.extend(passes.iter().flat_map(|p| p.inputs.iter().filter_map(|(_, id)| id)));
            used.retain(|id| ![color, depth, out].contains(id));
            used.sort_unstable();
            used.dedup();
            assert_eq!(live.textures - before.textures, used.len(), "{name}: textures");
            if plan.planned_passes().is_empty() {
                assert_eq!(live, before, "{name}: something was made for nothing");
            }
            println!("{} {name}: {} programs, {} textures", b.info().backend, programs.len(), used.len());
            renderer.destroy(b);
            free(b, [color, depth, out]);
            assert_eq!(b.live().textures, before.textures - 3, "{name}");
        });
    }
}

/// A scene on a threshold does not switch in every frame, and either way it is within the bound.
#[test]
fn a_scene_on_a_threshold_switches_once() {
    let sky = SkySettings { quality: luts(), bound: Some(Bound::eight_bit(1.0)), ..SkySettings::default() };
    let lit = |plan: &Frame| plan.effect("sunlight").unwrap().on;
    let at = |elevation: f64| View { sun_elevation: elevation, pitch: 10.0, ..View::default() }.scene();
    let fresh = |elevation: f64| lit(&Frame::new(&at(elevation), &sky, SIZE).unwrap());
    // Where a plan without a past switches.
    let (mut day, mut night) = (0.0, -60.0);
    for _ in 0..40 {
        let middle = 0.5 * (day + night);
        if fresh(middle) { day = middle } else { night = middle }
    }
    let mut switches = 0;
    let mut plan = Frame::new(&at(day + 1.0), &sky, SIZE).unwrap();
    for i in 0..200 {
        // Down through the threshold, trembling.
        let elevation = day + 0.5 - 0.01 * f64::from(i) + if i % 2 == 0 { 0.05 } else { -0.05 };
        let next = Frame::after(&plan, &at(elevation), &sky, SIZE).unwrap();
        switches += usize::from(lit(&next) != lit(&plan));
        // Never brighter than the bound without light, and off by the time half of it is left.
        assert!(lit(&next) || !fresh(elevation), "dark at {elevation}");
        plan = next;
    }
    assert_eq!((switches, lit(&plan)), (1, false));
    // On again only above the threshold itself.
    for (elevation, want) in [(day - 0.05, false), (day + 0.05, true), (day - 0.05, true)] {
        plan = Frame::after(&plan, &at(elevation), &sky, SIZE).unwrap();
        assert_eq!(lit(&plan), want, "{elevation}");
    }
}

/// After a warm-up no frame of a flight makes a program or a pipeline; and nothing of it is left.
#[test]
fn pipelines_are_made_ahead() {
    let terrain = [None, Some(welkin::TerrainStyle::earth())];
    for (i, method) in [march(32, 8), luts()].into_iter().enumerate() {
        on_both(|b| {
            let sky =
                SkySettings { quality: method, bound: Some(Bound::eight_bit(1.0)), ..SkySettings::default() };
            let settings = welkin::PictureSettings { sky, terrain: terrain[i], ..Default::default() };
            let views: Vec<_> = flight(method).into_iter().map(|case| case.view.scene()).collect();
            let before = b.live();
            let mut warm_up = welkin::WarmUp::picture(&views[0], &settings).unwrap();
            let mut steps = 0;
            let mut made = b.live();
            while warm_up.step(b).unwrap() {
                let now = b.live();
                assert!(
                    now.programs <= made.programs + 1 && now.pipelines <= made.pipelines + 1,
                    "too much at once"
                );
                (made, steps) = (now, steps + 1);
            }
            let ready = b.live();
            assert_eq!(ready.textures, before.textures, "left behind");
            assert!(ready.programs > before.programs + 5, "{ready:?}");
            let mut renderer = welkin::PictureRenderer::default();
            for scene in &views {
                draw(b, &mut renderer, scene, &settings, SIZE);
            }
            let after = b.live();
            println!("{} {}: {steps} steps, {} programs", b.info().backend, method.method(), ready.programs);
            assert_eq!((after.programs, after.pipelines), (ready.programs, ready.pipelines));
            renderer.destroy(b);
        });
    }
}
