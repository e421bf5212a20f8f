//! The tables: as exact as promised, never stale, without a seam, in every mode and from every altitude, finite in
//! hard media, and freed.
//!
//! `cargo test --features cli --test lut -- --nocapture` prints the differences.
#![cfg(all(feature = "egl", feature = "translate", feature = "reference"))]
#![allow(unsafe_code)] // The test plays the user, who calls OpenGL.
#![allow(clippy::needless_range_loop)] // Loops over the three channels index several arrays.

mod common;
#[allow(dead_code)] // Written for `welkin film`.
#[path = "../cli/src/lab/film/path.rs"]
mod path;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

use common::{View, on_both};
use glam::DVec2;
use glow::HasContext as _;
use welkin::gpu::Program;
use welkin::gpu::egl::Headless;
use welkin::gpu::webgl::WebGlBackend;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, DepthUse, Format, Inputs, Pass, Target, TextureDesc, TextureId, Uniform};
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::shaders::copy;
use welkin::{
    AtmosphereParams, Composition, DepthConvention, LutSettings, Method, MiePhase, Mode, PictureRenderer,
    PictureSettings, Quality, Scene, SkyRenderer, SkySettings, TerrainStyle, ToneMap,
};

/// Small tables, for what does not depend on how exact they are.
const TINY: LutSettings = LutSettings {
    columns: [16, 8],
    moments: [8, 8],
    moment_steps: 4,
    orders: 3,
    sky: [8, 12],
    sky_steps: 4,
    air: [4, 8, 4],
    air_steps: 1,
};

fn tables(lut: LutSettings) -> SkySettings {
    SkySettings { method: Method::Lut(lut), sun_disk: false, ..SkySettings::default() }
}

/// The sky over black, 32-bit floats.
fn over_black(sky: SkySettings) -> PictureSettings {
    PictureSettings { sky, terrain: None, radiance: Format::Rgba32Float, ..PictureSettings::default() }
}

fn draw(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    settings: &PictureSettings,
    size: [u32; 2],
) -> Vec<f32> {
    let drawn = renderer.draw(b, scene, settings, size).unwrap();
    b.read(drawn.radiance).unwrap()
}

fn rgb(pixels: &[f32], i: usize) -> [f64; 3] {
    [0, 1, 2].map(|c| f64::from(pixels[4 * i + c]))
}

#[track_caller]
fn assert_light(pixels: &[f32], what: &str) {
    for (i, p) in pixels.chunks_exact(4).enumerate() {
        assert!(p.iter().all(|v| v.is_finite()), "{what}: pixel {i} is {p:?}");
        assert!(p[..3].iter().all(|v| *v >= 0.0), "{what}: pixel {i} is negative: {p:?}");
    }
}

/// The ray through the middle of a pixel.
fn query(scene: &Scene, [w, h]: [u32; 2], i: usize) -> RayQuery {
    let view = scene.validate().unwrap();
    let (x, y) = (i as u32 % w, i as u32 / w);
    let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let direction = view.basis.ray(DVec2::new(share(x, w), -share(y, h))).normalize();
    RayQuery { altitude: view.altitude, direction, sun: view.sun, length: f64::INFINITY, moon: None }
}

/// Earth's light of all orders, solved once for all tests here.
fn earth() -> &'static Orders {
    static EARTH: OnceLock<Orders> = OnceLock::new();
    EARTH.get_or_init(|| Orders::solve(&AtmosphereParams::earth(), Settings::QUICK, |_| ()).unwrap())
}

/// What the passes should draw over black: the air's light, without the ground's.
fn truth(scene: &Scene, size: [u32; 2]) -> Vec<[f64; 3]> {
    let sun = scene.atmosphere.sun_intensity;
    (0..(size[0] * size[1]) as usize)
        .map(|i| {
            let light = earth().radiance(&query(scene, size, i), Tolerance { relative: 1e-4 }).unwrap();
            std::array::from_fn(|c| (light.per_irradiance[c] - light.ground[c]) * sun)
        })
        .collect()
}

/// Mean, 95th percentile and largest.
fn figures(mut errors: Vec<f64>) -> [f64; 3] {
    assert!(errors.len() > 100 && errors.iter().all(|e| e.is_finite()), "{} values", errors.len());
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    [mean, errors[errors.len() * 95 / 100], errors[errors.len() - 1]]
}

// --- accuracy

/// A direction of view from the ground, and the Monte Carlo's light: red, green, blue.
struct Case {
    scene: Scene,
    sun: f64,
    want: [f64; 3],
}

/// A table of `tests/data`; neighbours share a medium and a sun.
fn cases(file: &str) -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(file);
    let mut cases: BTreeMap<[String; 5], Case> = BTreeMap::new();
    for row in csv::Reader::from_path(path).unwrap().deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let medium = row.get("atmosphere").map_or(if file.contains("earth") { "earth" } else { "rayleigh" }, |m| m);
        let names = ["albedo", "sun_zenith_deg", "view_zenith_deg", "azimuth_from_sun_deg"];
        let [albedo, sun, view, azimuth] = names.map(|n| row[n].parse::<f64>().unwrap());
        let key = [medium, &row[names[0]], &row[names[1]], &row[names[2]], &row[names[3]]].map(str::to_owned);
        let case = cases.entry(key).or_insert_with(|| {
            let params = AtmosphereParams {
                ground_albedo: [albedo; 3],
                sun_intensity: 1.0,
                ..AtmosphereParams::preset(medium).unwrap()
            };
            let view = View {
                params,
                altitude: 0.0,
                pitch: 90.0 - view,
                heading: azimuth,
                fov: 0.01,
                sun_elevation: 90.0 - sun,
                aspect: 1.0,
            };
            Case { scene: view.scene(), sun, want: [f64::NAN; 3] }
        });
        let c = ["R", "G", "B"].iter().position(|c| *c == row["channel"]).unwrap();
        case.want[c] = row["mc_total_per_sr"].parse().unwrap();
    }
    cases.into_values().collect()
}

#[test]
fn light_is_the_monte_carlos() {
    // File, and the bounds of mean, 95th percentile and maximum: by day 1, 3 and 8 % are promised, at dusk a
    // mean of 5 %. What is asked here is near what is measured.
    let tables_of = [
        ("sky_earth.csv", [0.004, 0.01, 0.015]),
        ("sky_rayleigh.csv", [0.003, 0.007, 0.02]),
        ("mc_twilight.csv", [0.01, 0.03, 0.08]),
    ];
    on_both(|b| {
        let name = b.info().backend;
        let mut renderer = PictureRenderer::default();
        for (file, bounds) in tables_of {
            let cases = cases(file);
            let mut errors = Vec::new();
            for case in &cases {
                assert_eq!(case.sun > 90.0, file.contains("twilight"));
                let pixels = draw(b, &mut renderer, &case.scene, &over_black(Quality::MEDIUM.into_sky()), [1, 1]);
                let got = rgb(&pixels, 0);
                errors.extend((0..3).map(|c| (got[c] / case.want[c] - 1.0).abs()));
            }
            let got = figures(errors);
            let percent = got.map(|e| format!("{:.2}", 100.0 * e)).join(" / ");
            println!("{name} {file}: {} cases, mean / 95th percentile / maximum {percent} %", cases.len());
            assert!((0..3).all(|i| got[i] <= bounds[i]), "{name} {file}: {got:?}, {bounds:?} allowed");
        }
        renderer.destroy(b);
    });
}

trait IntoSky {
    fn into_sky(self) -> SkySettings;
}

impl IntoSky for Quality {
    fn into_sky(self) -> SkySettings {
        SkySettings { sun_disk: false, ..self.into() }
    }
}

#[test]
fn dusk_is_the_references() {
    let size = [6, 6];
    let scenes: Vec<_> = [-2.0, -4.0, -6.0]
        .into_iter()
        .flat_map(|sun_elevation| [0.0, 90.0, 180.0].map(|heading| (sun_elevation, heading)))
        .map(|(sun_elevation, heading)| {
            View { altitude: 2.0, pitch: 50.0, fov: 80.0, heading, sun_elevation, ..View::default() }.scene()
        })
        .collect();
    let truths: Vec<_> = scenes.iter().map(|s| truth(s, size)).collect();
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut errors = Vec::new();
        for (scene, want) in scenes.iter().zip(&truths) {
            let pixels = draw(b, &mut renderer, scene, &over_black(Quality::MEDIUM.into_sky()), size);
            errors.extend(want.iter().enumerate().flat_map(|(i, want)| {
                let got = rgb(&pixels, i);
                [0, 1, 2].map(|c| (got[c] / want[c] - 1.0).abs())
            }));
        }
        renderer.destroy(b);
        let got = figures(errors);
        println!("{} sun 92 to 96 degrees: mean, 95th percentile, maximum {got:.4?}", b.info().backend);
        assert!(got[0] <= 0.01 && got[1] <= 0.03 && got[2] <= 0.06, "{got:?}");
    });
}

// --- staleness

/// All that a picture depends on.
#[derive(Clone, Debug)]
struct World {
    view: View,
    sky: SkySettings,
    lut: LutSettings,
    size: [u32; 2],
}

impl World {
    fn new() -> Self {
        let params = AtmosphereParams { sun_angular_radius: 0.1, ..AtmosphereParams::earth() };
        // Half handed over, with the ground below and the sun in the picture: every pass and table counts.
        let view = View { params, altitude: 25e3, pitch: 5.0, fov: 60.0, sun_elevation: 15.0, ..View::default() };
        Self { view, sky: SkySettings::default(), lut: TINY, size: [10, 8] }
    }

    fn sky(&self) -> SkySettings {
        let method = match self.sky.method {
            Method::Lut(_) => Method::Lut(self.lut),
            other => other,
        };
        SkySettings { method, ..self.sky }
    }

    /// The passes before and behind a scene of planes, nearer from row to row, and what they leave in the target.
    fn run(&self, b: &mut dyn Backend, sky: &mut SkyRenderer) -> (Vec<Pass>, Vec<f32>) {
        let [w, h] = self.size;
        let scene = self.view.scene();
        let [color, out] =
            [(); 2].map(|_| b.create_texture(&TextureDesc::new("target", w, h, Format::Rgba32Float)).unwrap());
        let depth = b.create_texture(&TextureDesc::new("depth", w, h, Format::R32Float)).unwrap();
        let planes = |y: u32| if y < 2 { scene.depth.background() } else { scene.depth.encode(4e5 / f64::from(y * y)) };
        let stored: Vec<f32> = (0..w * h).map(|i| planes(i / w) as f32).collect();
        b.write_texture(depth, &stored).unwrap();
        b.write_texture(color, &BEHIND.repeat((w * h) as usize)).unwrap();
        sky.set_settings(self.sky()).unwrap();
        let mut passes = sky.background(b, &scene, Target::color(color)).unwrap().to_vec();
        let air = sky.aerial(b, &scene, color, depth, out).unwrap();
        let last = if air.is_empty() { color } else { out };
        passes.extend_from_slice(air);
        passes.extend_from_slice(sky.shell(b, &scene, depth, Target::color(color)).unwrap());
        b.run(&passes).unwrap();
        let pixels = b.read(last).unwrap();
        [color, depth, out].into_iter().for_each(|t| b.destroy_texture(t));
        (passes, pixels)
    }

    fn draw(&self, b: &mut dyn Backend, sky: &mut SkyRenderer) -> Vec<f32> {
        self.run(b, sky).1
    }

    fn draw_fresh(&self, b: &mut dyn Backend) -> Vec<f32> {
        let mut sky = SkyRenderer::default();
        let pixels = self.draw(b, &mut sky);
        sky.destroy(b);
        pixels
    }
}

type Change = (String, Box<dyn Fn(&mut World)>);

fn change(name: impl Into<String>, f: impl Fn(&mut World) + 'static) -> Change {
    (name.into(), Box::new(f))
}

/// One input each.
fn changes() -> Vec<Change> {
    let mut all = vec![
        change("planet radius", |w| {
            w.view.params.planet_radius *= 1.01;
            w.view.params.atmosphere_radius *= 1.01;
        }),
        change("atmosphere radius", |w| w.view.params.atmosphere_radius += 5e3),
        change("rayleigh scale height", |w| w.view.params.rayleigh_scale_height *= 1.1),
        change("mie scale height", |w| w.view.params.mie_scale_height *= 1.5),
        change("mie phase", |w| w.view.params.mie_phase = MiePhase::CornetteShanks),
        change("ozone altitude", |w| w.view.params.ozone_center_altitude += 3e3),
        change("ozone width", |w| w.view.params.ozone_half_width *= 0.8),
        change("sun intensity", |w| w.view.params.sun_intensity *= 1.5),
        change("sun radius", |w| w.view.params.sun_angular_radius *= 1.5),
        change("no gas", |w| w.view.params.rayleigh_scattering = [0.0; 3]),
        change("no ozone", |w| w.view.params.ozone_absorption = [0.0; 3]),
        change("no aerosol", |w| {
            w.view.params.mie_scattering = [0.0; 3];
            w.view.params.mie_absorption = [0.0; 3];
        }),
        change("mars", |w| w.view.params = AtmosphereParams::mars()),
        change("venus", |w| w.view.params = AtmosphereParams::venus()),
        change("sun", |w| w.view.sun_elevation = 14.9),
        change("sun below the horizon", |w| w.view.sun_elevation = -3.0),
        change("altitude", |w| w.view.altitude += 50.0),
        change("below the ground", |w| w.view.altitude = -50.0),
        change("orbit", |w| w.view.altitude = 4e5),
        change("heading", |w| w.view.heading = 20.0),
        change("pitch", |w| w.view.pitch = 2.0),
        change("field of view", |w| w.view.fov = 50.0),
        change("size", |w| w.size = [11, 8]),
        change("render scale", |w| w.sky.render_scale = 0.5),
        change("disk", |w| w.sky.sun_disk = false),
        change("sky dome", |w| w.sky.composition = Composition::SkyDome),
        change("one pass", |w| w.sky.composition = Composition::AtmospherePost),
        change("shell", |w| w.sky.composition = Composition::Planet),
        change("off", |w| w.sky.enabled = false),
        change("single scattering", |w| w.sky.method = Method::Single { view_samples: 4, light_samples: 2 }),
        change("columns", |w| w.lut.columns = [32, 16]),
        change("moments", |w| w.lut.moments = [12, 10]),
        change("moment steps", |w| w.lut.moment_steps = 6),
        change("orders", |w| w.lut.orders = 1),
        change("one order more", |w| w.lut.orders += 1),
        change("sky", |w| w.lut.sky = [12, 16]),
        change("sky steps", |w| w.lut.sky_steps = 7),
        change("air", |w| w.lut.air = [8, 12, 8]),
        change("air steps", |w| w.lut.air_steps = 2),
    ];
    for c in 0..3 {
        all.push(change(format!("rayleigh scattering {c}"), move |w| w.view.params.rayleigh_scattering[c] *= 1.05));
        all.push(change(format!("mie scattering {c}"), move |w| w.view.params.mie_scattering[c] *= 3.0));
        all.push(change(format!("mie absorption {c}"), move |w| w.view.params.mie_absorption[c] *= 3.0));
        all.push(change(format!("mie asymmetry {c}"), move |w| w.view.params.mie_asymmetry[c] = 0.7));
        all.push(change(format!("ozone absorption {c}"), move |w| w.view.params.ozone_absorption[c] *= 2.0));
        all.push(change(format!("albedo {c}"), move |w| w.view.params.ground_albedo[c] = 0.5));
    }
    all
}

#[test]
fn no_table_is_ever_stale() {
    on_both(|b| {
        let base = World::new();
        let want = base.draw_fresh(b);
        let mut renderer = SkyRenderer::default();
        assert!(base.draw(b, &mut renderer) == want);
        for (name, apply) in changes() {
            let mut world = base.clone();
            apply(&mut world);
            let changed = world.draw_fresh(b);
            assert_light(&changed, &name);
            assert!(changed != want, "{name} changes nothing: not a test");
            // There and back.
            assert!(world.draw(b, &mut renderer) == changed, "{name}: a table is stale");
            assert!(base.draw(b, &mut renderer) == want, "{name}: a table is stale on the way back");
        }
        // A day in fast motion.
        for i in 0..24 {
            let mut world = base.clone();
            world.view.sun_elevation = 180.0 - 15.0 * f64::from(i);
            assert!(world.draw(b, &mut renderer) == world.draw_fresh(b), "hour {i}");
        }
        renderer.destroy(b);
    });
}

/// A whole picture's radiance and display values, by a renderer that may have drawn others.
fn whole_picture(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    world: &World,
    settings: &PictureSettings,
) -> [Vec<f32>; 2] {
    let settings = PictureSettings { sky: world.sky(), ..*settings };
    let drawn = renderer.draw(b, &world.view.scene(), &settings, world.size).unwrap();
    [drawn.radiance, drawn.display].map(|id| b.read(id).unwrap())
}

fn fresh_picture(b: &mut dyn Backend, world: &World, settings: &PictureSettings) -> [Vec<f32>; 2] {
    let mut fresh = PictureRenderer::default();
    let pixels = whole_picture(b, &mut fresh, world, settings);
    fresh.destroy(b);
    pixels
}

/// One change upon the other, never back: whatever a renderer has drawn before, it draws what a fresh one does.
#[test]
fn a_kept_renderer_draws_what_a_fresh_one_does() {
    on_both(|b| {
        let mut kept = PictureRenderer::default();
        let (mut world, mut settings) = (World::new(), PictureSettings::default());
        let mut last = [Vec::new(), Vec::new()];
        let mut changed = 0;
        let mut check = |world: &World, settings: &PictureSettings, what: &str| {
            let want = fresh_picture(b, world, settings);
            let got = whole_picture(b, &mut kept, world, settings);
            assert_light(&got[0], what);
            assert!(got == want, "{what}: not what a fresh renderer draws");
            changed += usize::from(got != last);
            last = got;
        };
        check(&world, &settings, "first");
        for planet in ["mars", "venus", "earth", "venus", "mars", "earth-like", "rayleigh", "earth"] {
            world.view.params = AtmosphereParams::preset(planet).unwrap();
            settings.terrain = Some(TerrainStyle::dry(&world.view.params));
            check(&world, &settings, planet);
        }
        type Own = (&'static str, fn(&mut PictureSettings));
        let own: [Own; 9] = [
            ("exposure", |s| s.exposure = 3.0),
            ("agx", |s| s.tone_map = ToneMap::AgX),
            ("neutral", |s| s.tone_map = ToneMap::Neutral),
            ("no dither", |s| s.dither = false),
            ("32 bits", |s| s.radiance = Format::Rgba32Float),
            ("terrain", |s| s.terrain = Some(TerrainStyle::earth())),
            ("no terrain", |s| s.terrain = None),
            ("16 bits", |s| s.radiance = Format::Rgba16Float),
            ("dither", |s| s.dither = true),
        ];
        for (what, apply) in own {
            apply(&mut settings);
            check(&world, &settings, what);
        }
        // Each input of a sky on top of the ones before; off is followed by on.
        for (what, apply) in changes() {
            apply(&mut world);
            check(&world, &settings, &what);
            world.sky.enabled = true;
        }
        world = World::new();
        // A day in fast motion, from deep night to the zenith and back, and a climb.
        for i in 0..=22 {
            world.view.sun_elevation = 90.0 - 10.0 * (f64::from(i) - 11.0).abs();
            check(&world, &settings, &format!("sun {}", world.view.sun_elevation));
        }
        for i in 0..=16 {
            world.view.altitude = 2.0 * 5e8_f64.powf(f64::from(i) / 16.0);
            check(&world, &settings, &format!("{} m", world.view.altitude));
        }
        // Some change nothing: ozone without its layer, the sun's size behind the camera.
        assert!(changed > 80, "only {changed} changes changed the picture: not a test");
        kept.destroy(b);
    });
}

/// After a device was lost, a renderer that was kept draws on a new one what a fresh one draws.
#[test]
fn a_renderer_outlives_its_device() {
    fn outlive<M>(
        open: impl Fn() -> M,
        backend: impl Fn(&mut M) -> &mut dyn Backend,
        lose: impl Fn(&mut M),
        others: usize,
    ) {
        let (world, settings) = (World::new(), PictureSettings::default());
        let mut kept = PictureRenderer::default();
        let mut machine = open();
        let want = fresh_picture(backend(&mut machine), &world, &settings);
        for round in 0..3 {
            let b = backend(&mut machine);
            // Textures of the user's, with the ids that the renderer's had.
            let desc = TextureDesc::new("user's", 10, 8, Format::Rgba32Float);
            let users: Vec<_> = (0..round * others).map(|_| b.create_texture(&desc).unwrap()).collect();
            users.iter().for_each(|&id| b.write_texture(id, &[0.25; 320]).unwrap());
            assert!(whole_picture(b, &mut kept, &world, &settings) == want, "{others} textures, round {round}");
            for &id in &users {
                let pixels = b.texture(id).map(|_| b.read(id).unwrap());
                assert!(pixels.is_some_and(|p| p.iter().all(|v| *v == 0.25)), "a user's texture was taken");
            }
            lose(&mut machine);
            let lost = kept.draw(backend(&mut machine), &world.view.scene(), &settings, [10, 8]);
            assert!(lost.is_err(), "drawn on a lost device");
            // The old context goes before the new one is made current.
            drop(machine);
            machine = open();
        }
    }
    for others in [0, 1, 4] {
        let open = || WgpuBackend::headless().unwrap();
        outlive(open, |b| b, |b: &mut WgpuBackend| b.device().destroy(), others);
        let open = || Headless::new().unwrap();
        outlive(open, |h| &mut h.backend, |h: &mut Headless| h.backend.set_lost("on purpose"), others);
    }
}

/// Labels of the passes that fill tables, without repetitions.
fn filled(passes: &[Pass]) -> Vec<&'static str> {
    let mut labels: Vec<_> = passes.iter().map(|p| p.label).filter(|l| l.ends_with("table")).collect();
    labels.dedup();
    labels
}

#[test]
fn only_stale_tables_are_made_again() {
    const ALL: [&str; 4] = ["columns table", "moments table", "sky table", "air table"];
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut next = |world: &World| {
            let settings = over_black(world.sky());
            filled(renderer.passes(b, &world.view.scene(), &settings, world.size).unwrap().0)
        };
        let mut world = World::new();
        assert_eq!(next(&world), ALL);
        assert!(next(&world).is_empty(), "nothing has changed");
        world.view.heading += 30.0;
        assert!(next(&world).is_empty(), "the camera has turned");
        world.view.pitch += 30.0;
        world.view.fov = 30.0;
        assert!(next(&world).is_empty(), "the camera has turned");
        world.view.params.sun_intensity *= 2.0;
        world.view.params.sun_angular_radius *= 2.0;
        assert!(next(&world).is_empty(), "the tables know nothing of the sun's light and size");
        world.sky.sun_disk = false;
        world.sky.render_scale = 0.5;
        assert!(next(&world).is_empty(), "the same tables");
        world.view.sun_elevation += 1.0;
        assert_eq!(next(&world), ALL[2..], "the sun has moved");
        world.view.altitude += 1.0;
        assert_eq!(next(&world), ALL[2..], "the camera has risen");
        world.view.params.mie_scattering[1] *= 1.1;
        assert_eq!(next(&world), ALL, "another medium");
        world.view.params.ground_albedo[2] *= 0.9;
        assert_eq!(next(&world), ALL, "another ground");
        assert!(next(&world).is_empty());
        world.size = [20, 30];
        assert!(next(&world).is_empty(), "tables do not depend on the picture's size");
        renderer.destroy(b);
    });
}

/// How often light is scattered depends on the medium more finely than the medium's 32-bit numbers do.
#[test]
fn the_number_of_orders_is_never_stale() {
    on_both(|b| {
        let mut world = World::new();
        let passes = |b: &mut dyn Backend, world: &World| {
            let mut renderer = PictureRenderer::default();
            let settings = over_black(world.sky());
            let n = renderer.passes(b, &world.view.scene(), &settings, world.size).unwrap().0.len();
            renderer.destroy(b);
            n
        };
        let scattering = |w: &mut World, v: f64| w.view.params.rayleigh_scattering[2] = v;
        let (mut low, mut high) = (33.1e-6, 200e-6);
        scattering(&mut world, low);
        let few = passes(b, &world);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            scattering(&mut world, middle);
            *(if passes(b, &world) == few { &mut low } else { &mut high }) = middle;
        }
        assert!((high - low) / low < 1e-14 && (low * 1e3) as f32 == (high * 1e3) as f32, "{low} {high}");
        let mut renderer = SkyRenderer::default();
        for v in [low, high, low] {
            scattering(&mut world, v);
            assert!(world.draw(b, &mut renderer) == world.draw_fresh(b), "{v} of {low} {high}");
        }
        renderer.destroy(b);
    });
}

/// A table that somebody freed is made again, and with it what depends on it.
#[test]
fn lost_textures_are_made_again() {
    on_both(|b| {
        let world = World::new();
        let want = world.draw_fresh(b);
        for label in ["columns table", "gathered radiance", "moments table", "sky table", "air table"] {
            let mut sky = SkyRenderer::default();
            let (passes, _) = world.run(b, &mut sky);
            let label_of = |id: TextureId| b.texture(id).map(|d| d.label);
            let lost = passes.iter().map(|p| p.target.color).find(|&id| label_of(id) == Some(label));
            b.destroy_texture(lost.unwrap());
            assert!(world.draw(b, &mut sky) == want, "without its {label}");
            sky.destroy(b);
        }
    });
}

/// After a device was lost the user has a new one, with textures of his own.
#[test]
fn tables_of_a_lost_device_are_forgotten() {
    let world = World::new();
    let scene = world.view.scene();
    let target_of =
        |b: &mut dyn Backend| b.create_texture(&TextureDesc::new("user's", 10, 8, Format::Rgba32Float)).unwrap();
    let sky_over = |b: &mut dyn Backend, sky: &mut SkyRenderer, target: TextureId| {
        let cleared = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(target) };
        let passes = sky.background(b, &scene, cleared).unwrap().to_vec();
        let sky_or_sun = |p: &&Pass| ["background sky", "sun"].contains(&p.label);
        let drawn = passes.iter().filter(|p| p.target.color == target).count();
        assert!(drawn > 0 && passes.iter().filter(sky_or_sun).count() == drawn);
        b.run(&passes).unwrap();
        b.read(target).unwrap()
    };
    let settings = SkySettings { method: Method::Lut(TINY), ..SkySettings::default() };
    // As many textures of the user's as there may be before the first table, so that the ids meet.
    for own in [0, 1, 7] {
        let mut kept = SkyRenderer::new(settings).unwrap();
        let mut want = Vec::new();
        on_both(|b| {
            let target = target_of(b);
            let mut fresh = SkyRenderer::new(settings).unwrap();
            want.push(sky_over(b, &mut fresh, target));
            fresh.destroy(b);
        });
        let mut seen = 0;
        on_both(|b| {
            let target = target_of(b);
            let users: Vec<_> = (0..if seen == 0 { 0 } else { own }).map(|_| target_of(b)).collect();
            users.iter().for_each(|&id| b.write_texture(id, &[0.25; 320]).unwrap());
            let got = sky_over(b, &mut kept, target);
            assert!(got == want[seen], "{own} textures: the new device's sky is not drawn from its own tables");
            for &id in &users {
                let pixels = b.texture(id).map(|_| b.read(id).unwrap());
                assert!(pixels.is_some_and(|p| p.iter().all(|v| *v == 0.25)), "{own}: a user's texture was taken");
            }
            seen += 1;
        });
    }
}

// --- the four modes in a user's own frame

/// A user with a device and textures of their own.
trait User {
    fn backend(&mut self) -> &mut dyn Backend;
    /// A texture of the user's with four values in each texel (or one), made known.
    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId;
    /// Records passes into a frame of the user's and submits it.
    fn frame(&mut self, passes: &[Pass]);
}

const SIDE: u32 = 8;
const TEXELS: usize = 64;

struct WgpuUser {
    device: wgpu::Device,
    queue: wgpu::Queue,
    backend: WgpuBackend,
}

impl WgpuUser {
    fn new() -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("a Vulkan driver");
        let desc = wgpu::DeviceDescriptor {
            required_features: adapter.features() & wgpu::Features::FLOAT32_BLENDABLE,
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&desc)).unwrap();
        let backend = WgpuBackend::from_device(device.clone(), queue.clone(), &adapter.get_info().name).unwrap();
        Self { device, queue, backend }
    }
}

impl User for WgpuUser {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId {
        let (format, own) = if channels == 1 {
            (Format::R32Float, wgpu::TextureFormat::R32Float)
        } else {
            (Format::Rgba32Float, wgpu::TextureFormat::Rgba32Float)
        };
        let extent = wgpu::Extent3d { width: SIDE, height: SIDE, depth_or_array_layers: 1 };
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("user's"),
            size: extent,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: own,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let bytes: Vec<u8> = texels.iter().flat_map(|v| v.to_ne_bytes()).collect();
        let row = Some(SIDE * 4 * channels as u32);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: row, rows_per_image: None };
        self.queue.write_texture(texture.as_image_copy(), &bytes, layout, extent);
        let view = texture.create_view(&Default::default());
        self.backend.import_view(view, TextureDesc::new("user's", SIDE, SIDE, format)).unwrap()
    }

    fn frame(&mut self, passes: &[Pass]) {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        self.backend.encode(&mut encoder, passes).unwrap();
        self.queue.submit([encoder.finish()]);
    }
}

struct GlUser {
    backend: WebGlBackend,
    _context: Headless,
}

impl User for GlUser {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId {
        let gl = self.backend.context().clone();
        let bytes: Vec<u8> = texels.iter().flat_map(|v| v.to_ne_bytes()).collect();
        let (format, internal, layout) = if channels == 1 {
            (Format::R32Float, glow::R32F, glow::RED)
        } else {
            (Format::Rgba32Float, glow::RGBA32F, glow::RGBA)
        };
        let side = SIDE as i32;
        // SAFETY: plain calls on the current context; the slice holds as many bytes as the texture.
        let texture = unsafe {
            let texture = gl.create_texture().unwrap();
            gl.bind_texture(glow::TEXTURE_2D, Some(texture));
            gl.tex_storage_2d(glow::TEXTURE_2D, 1, internal, side, side);
            for filter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
                gl.tex_parameter_i32(glow::TEXTURE_2D, filter, glow::NEAREST as i32);
            }
            let data = glow::PixelUnpackData::Slice(Some(&bytes));
            gl.tex_sub_image_2d(glow::TEXTURE_2D, 0, 0, 0, side, side, layout, glow::FLOAT, data);
            gl.bind_texture(glow::TEXTURE_2D, None);
            texture
        };
        self.backend.import_texture(texture, TextureDesc::new("user's", SIDE, SIDE, format)).unwrap()
    }

    fn frame(&mut self, passes: &[Pass]) {
        self.backend.run(passes).unwrap();
    }
}

/// A copy of a user's texture, read.
fn content(user: &mut dyn User, id: TextureId) -> Vec<f32> {
    let b = user.backend();
    let copy = b.create_texture(&TextureDesc::new("copy", SIDE, SIDE, Format::Rgba32Float)).unwrap();
    let program = Some(b.create_program(Program::new(&copy::INFO, 0)).unwrap());
    let (inputs, uniform, target) = (Inputs::new([("source", Some(id))]), Uniform::NONE, Target::color(copy));
    b.run(&[Pass { label: "copy", program, inputs, uniform, target, depth: DepthUse::Always }]).unwrap();
    let pixels = b.read(copy).unwrap();
    b.destroy_texture(copy);
    pixels
}

/// What is behind the air in the user's frame.
const BEHIND: [f32; 4] = [0.5, 0.25, 1.0, 1.0];
/// The left half of the picture shows a plane so far away, m.
const PLANE: f64 = 20e3;

#[test]
fn each_mode_draws_in_a_users_own_frame() {
    let view = View { altitude: 30e3, pitch: -5.0, fov: 60.0, sun_elevation: 35.0, ..View::default() };
    let scene = view.scene();
    let size = [SIDE; 2];
    let is_plane = |i: usize| i % 8 < 4;
    // The reference's light and transmittance: once scattered, and of all orders.
    let want: Vec<_> = (0..TEXELS)
        .map(|i| {
            let mut q = query(&scene, size, i);
            if is_plane(i) {
                q = q.ended_at(PLANE / q.direction.dot(scene.validate().unwrap().basis.forward));
            }
            let tolerance = Tolerance { relative: 1e-4 };
            let once = single_scattering(&scene.atmosphere, &q, Sun::Point, tolerance).unwrap();
            let all = earth().radiance(&q, tolerance).unwrap();
            let sun = scene.atmosphere.sun_intensity;
            let air = std::array::from_fn(|c| (all.per_irradiance[c] - all.ground[c]) * sun);
            ([once.radiance, air], once.transmittance, q)
        })
        .collect();
    let is_ground = |i: usize| !is_plane(i) && hits(&scene, &want[i].2);
    assert!((0..TEXELS).any(is_ground) && (0..TEXELS).any(|i| !is_plane(i) && !is_ground(i)));
    let plain: Vec<f32> = BEHIND.repeat(TEXELS);
    let stored: Vec<f32> = (0..TEXELS)
        .map(|i| if is_plane(i) { scene.depth.encode(PLANE) } else { scene.depth.background() } as f32)
        .collect();
    let users: [Box<dyn User>; 2] = [Box::new(WgpuUser::new()), {
        let context = Headless::new().expect("EGL with OpenGL ES 3");
        let backend = WebGlBackend::new(context.backend.context().clone()).unwrap();
        Box::new(GlUser { backend, _context: context })
    }];
    for mut user in users {
        let user = user.as_mut();
        let name = user.backend().info().backend;
        for mode in Mode::ALL {
            let mut sky = SkyRenderer::new(SkySettings { sun_disk: false, ..mode.settings() }).unwrap();
            let (color, depth) = (user.texture(4, &plain), user.texture(1, &stored));
            let out = user.texture(4, &[0.0; 4 * TEXELS]);
            let passes = sky.background(user.backend(), &scene, Target::color(color)).unwrap().to_vec();
            let expected = [1, 0, 0, 1][mode as usize];
            assert_eq!(passes.len() - tables_in(&passes), expected, "{}: background", mode.name());
            assert_eq!(tables_in(&passes) > 0, mode == Mode::Lut);
            user.frame(&passes);
            // Then the user draws the plane.
            let mut drawn = content(user, color);
            (0..TEXELS).filter(|&i| is_plane(i)).for_each(|i| drawn[4 * i..4 * i + 4].copy_from_slice(&BEHIND));
            let drawn_color = user.texture(4, &drawn);
            let passes = sky.aerial(user.backend(), &scene, drawn_color, depth, out).unwrap().to_vec();
            assert_eq!(passes.len() - tables_in(&passes), [0, 1, 0, 1][mode as usize], "{}: aerial", mode.name());
            user.frame(&passes);
            let after = passes.last().map_or(drawn_color, |p| p.target.color);
            let passes = sky.shell(user.backend(), &scene, depth, Target::color(after)).unwrap().to_vec();
            assert_eq!(passes.len(), usize::from(mode == Mode::Planet), "{}: shell", mode.name());
            user.frame(&passes);
            let pixels = content(user, after);
            assert_light(&pixels, mode.name());
            let mut worst = 0.0_f64;
            for (i, (light, through, _)) in want.iter().enumerate() {
                let light = light[usize::from(mode == Mode::Lut)];
                let grey = through.iter().sum::<f64>() / 3.0;
                let got = rgb(&pixels, i);
                for c in 0..3 {
                    let behind = f64::from(BEHIND[c]);
                    let want = match mode {
                        Mode::SkyDome if is_plane(i) || is_ground(i) => behind,
                        Mode::SkyDome | Mode::Planet => behind * grey + light[c],
                        Mode::AtmospherePost => behind * through[c] + light[c],
                        Mode::Lut if is_plane(i) || is_ground(i) => behind * through[c] + light[c],
                        Mode::Lut => behind * grey + light[c],
                    };
                    worst = worst.max((got[c] / want - 1.0).abs());
                    assert!((got[c] / want - 1.0).abs() < 0.03, "{name} {} {i} {c}: {got:?} {want}", mode.name());
                }
            }
            println!("{name} {}: largest deviation {worst:.4}", mode.name());
            let b = user.backend();
            sky.destroy(b);
            [color, depth, out, drawn_color].into_iter().for_each(|id| b.destroy_texture(id));
            assert_eq!(b.live().textures, 0, "{}", mode.name());
        }
    }
}

/// How many passes fill tables.
fn tables_in(passes: &[Pass]) -> usize {
    passes.iter().filter(|p| p.label.ends_with("table")).count()
}

/// Whether a ray ends on the ground.
fn hits(scene: &Scene, q: &RayQuery) -> bool {
    let radius = scene.atmosphere.planet_radius;
    let horizon = -(1.0 - (radius / (radius + q.altitude)).powi(2)).sqrt();
    q.direction.z < horizon
}

/// A plane `z` metres away under the air, or under the shell.
fn before(b: &mut dyn Backend, sky: &mut SkyRenderer, scene: &Scene, z: f64) -> Vec<f32> {
    let desc = |label, f| TextureDesc::new(label, SIDE, SIDE, f);
    let [color, out] = [(); 2].map(|_| b.create_texture(&desc("color", Format::Rgba32Float)).unwrap());
    let depth = b.create_texture(&desc("depth", Format::R32Float)).unwrap();
    b.write_texture(color, &[0.5; 4 * TEXELS]).unwrap();
    let stored = if z.is_finite() { scene.depth.encode(z) } else { scene.depth.background() };
    b.write_texture(depth, &[stored as f32; TEXELS]).unwrap();
    let shell = sky.settings().composition == Composition::Planet;
    let passes = if shell {
        sky.shell(b, scene, depth, Target::color(color)).unwrap()
    } else {
        sky.aerial(b, scene, color, depth, out).unwrap()
    }
    .to_vec();
    b.run(&passes).unwrap();
    let pixels = b.read(if shell { color } else { out }).unwrap();
    [color, depth, out].into_iter().for_each(|t| b.destroy_texture(t));
    pixels
}

#[test]
fn every_depth_convention_gives_the_same_air_and_shell() {
    let conventions = [
        DepthConvention::ReversedInfinite { near: 0.1 },
        DepthConvention::ZeroToOne { near: 10.0, far: 1e6 },
        DepthConvention::Reversed { near: 0.1, far: 1e7 },
        DepthConvention::NegativeOneToOne { near: 10.0, far: 1e6 },
        DepthConvention::Logarithmic { far: 1e9 },
    ];
    on_both(|b| {
        for settings in [
            SkySettings { composition: Composition::Full, ..tables(LutSettings::LOW) },
            SkySettings { composition: Composition::Planet, ..tables(LutSettings::LOW) },
            SkySettings { sun_disk: false, ..Mode::Planet.settings() },
        ] {
            let mut sky = SkyRenderer::new(settings).unwrap();
            let mut seen = Vec::new();
            for z in [50.0, 2e3, 40e3, f64::INFINITY] {
                let results = conventions.map(|depth| {
                    let view = View { altitude: 20e3, pitch: -5.0, fov: 30.0, ..View::default() };
                    before(b, &mut sky, &Scene { depth, ..view.scene() }, z)
                });
                for (depth, r) in conventions.iter().zip(&results) {
                    assert_light(r, "a depth convention");
                    let off = |(a, b): (&f32, &f32)| (a - b).abs() / b.abs().max(1e-3);
                    let worst = r.iter().zip(&results[0]).map(off).fold(0.0, f32::max);
                    // A forward 32-bit depth with near 10 m resolves 40 km to 1 %; the others to 1e-5.
                    let forward =
                        matches!(depth, DepthConvention::ZeroToOne { .. } | DepthConvention::NegativeOneToOne { .. });
                    assert!(worst < if forward { 1e-2 } else { 1e-4 }, "{settings:?} {depth:?} at {z} m: {worst}");
                }
                seen.push(results[0].clone());
            }
            assert!(seen.windows(2).all(|w| w[0] != w[1]), "the distance changes nothing: not a test");
            sky.destroy(b);
        }
    });
}

// --- from the ground to far away

fn fly(altitude: f64) -> Scene {
    let radius = AtmosphereParams::earth().planet_radius;
    let dip = |tangent: f64| ((radius + tangent) / (radius + altitude)).min(1.0).acos().to_degrees();
    // Up to 60 km the horizon, from there on the air from the ground to 60 km.
    let (low, high) = (dip(0.0), dip(6e4));
    let (pitch, fov) = if altitude < 6e4 { (-low, 60.0) } else { (-0.5 * (low + high), 1.5 * (low - high)) };
    View { altitude, pitch, fov, sun_elevation: 25.0, aspect: 0.5, ..View::default() }.scene()
}

/// Largest value of each channel.
fn brightest(values: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|c| values.iter().fold(0.0, |m: f64, v| m.max(v[c])))
}

#[test]
fn flying_up_is_the_references_and_without_a_step() {
    let size = [4, 8];
    let mut altitudes = path::altitudes(&AtmosphereParams::earth(), 72);
    altitudes.extend([3.5786e7, 3.844e8]);
    altitudes.sort_by(f64::total_cmp);
    let truths: Vec<_> = altitudes.iter().map(|&h| truth(&fly(h), size)).collect();
    on_both(|b| {
        let name = b.info().backend;
        let mut renderer = PictureRenderer::default();
        let settings = over_black(Quality::MEDIUM.into_sky());
        let (mut worst, mut largest, mut step) = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0));
        let mut last: Option<Vec<[f64; 3]>> = None;
        for (k, &altitude) in altitudes.iter().enumerate() {
            let scene = fly(altitude);
            let pixels = draw(b, &mut renderer, &scene, &settings, size);
            assert_light(&pixels, &format!("{altitude} m"));
            let got: Vec<_> = (0..32).map(|i| rgb(&pixels, i)).collect();
            let top = brightest(&truths[k]);
            // Mean deviation, of the value or of a hundredth of the brightest.
            let mut sum = [0.0; 3];
            for (got, want) in got.iter().zip(&truths[k]) {
                for c in 0..3 {
                    let off = (got[c] - want[c]).abs() / want[c].max(1e-2 * top[c]);
                    sum[c] += off / 32.0;
                    if off > largest.0 {
                        largest = (off, altitude);
                    }
                }
            }
            let mean = sum.iter().fold(0.0, |m: f64, v| m.max(*v));
            if mean > worst.0 {
                worst = (mean, altitude);
            }
            // From one frame to the next light changes as the reference's does.
            if let Some(last) = &last {
                let [_, _, off] = path::Step::between([last, &got], [&truths[k - 1], &truths[k]]).pixel;
                if off > step.0 {
                    step = (off, altitude);
                }
            }
            // The limb is resolved: bright at its foot, next to nothing at 75 km.
            if altitude > 1e5 {
                assert!(got[0][1] < 0.05 * got[24][1], "{altitude} m: {:?} {:?}", got[0], got[24]);
            }
            last = Some(got);
        }
        println!(
            "{name}: worst frame {:.4} at {} m, worst pixel {:.4} at {} m, worst step {:.4} to {} m",
            worst.0, worst.1, largest.0, largest.1, step.0, step.1
        );
        assert!(worst.0 < 0.02 && largest.0 < 0.05 && step.0 < 0.05, "{worst:?} {largest:?} {step:?}");
        // Where something begins or ends, a metre changes next to nothing. From above the top, rows of the tables
        // stand for other rays than from below: there the method's own error shows.
        for (altitude, bound) in [(15e3, 1e-3), (50e3, 1e-3), (100e3, 0.04)] {
            let [below, above] = [-0.5, 0.5].map(|d| {
                let view = View { altitude: altitude + d, pitch: -3.0, fov: 30.0, ..View::default() };
                draw(b, &mut renderer, &view.scene(), &settings, [12, 12])
            });
            let top = above.chunks_exact(4).fold(0.0, |m: f32, p| m.max(p[2]));
            let step = below.iter().zip(&above).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max) / top;
            println!("{name}: {altitude} m: step {step:.2e}");
            assert!(step < bound, "a step of {step} at {altitude} m");
        }
        renderer.destroy(b);
    });
}

// --- seams

#[test]
fn no_seam_is_seen() {
    let size = [8, 8];
    let mut views = Vec::new();
    for altitude in [2.0, 3e3, 3e4, 2e5] {
        let dip = (6.36e6_f64 / (6.36e6 + altitude)).acos().to_degrees();
        for heading in [0.0, 90.0, 180.0] {
            // The horizon, and the sun's azimuth and its opposite above it.
            views.push(("horizon", View { altitude, pitch: -dip, fov: 0.5, heading, ..View::default() }));
        }
    }
    for (pitch, name) in [(90.0, "zenith"), (-90.0, "nadir")] {
        for altitude in [2.0, 8e3, 4e5] {
            let heading = 30.0;
            views.push((name, View { altitude, pitch, fov: 2.0, heading, sun_elevation: 50.0, ..View::default() }));
        }
    }
    for heading in [0.0, 180.0] {
        views.push(("azimuth", View { pitch: 15.0, fov: 4.0, heading, sun_elevation: 40.0, ..View::default() }));
        views.push(("azimuth", View { altitude: 2e4, pitch: -30.0, fov: 4.0, heading, ..View::default() }));
    }
    let truths: Vec<_> = views.iter().map(|(_, v)| truth(&v.scene(), size)).collect();
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let settings = over_black(Quality::MEDIUM.into_sky());
        let mut worst: BTreeMap<&str, f64> = BTreeMap::new();
        for ((name, view), want) in views.iter().zip(&truths) {
            let pixels = draw(b, &mut renderer, &view.scene(), &settings, size);
            assert_light(&pixels, name);
            let got: Vec<_> = (0..64).map(|i| rgb(&pixels, i)).collect();
            let pairs = (0..64).flat_map(|i| [(i, i + 1, i % 8 < 7), (i, i + 8, i < 56)]);
            for (i, j, _) in pairs.filter(|p| p.2) {
                for c in 0..3 {
                    let own = (want[i][c] - want[j][c]).abs();
                    let more = (got[i][c] - got[j][c]).abs() - own;
                    let share = more / want[i][c].max(want[j][c]).max(1e-3 * brightest(want)[c]).max(1e-30);
                    let at = worst.entry(name).or_default();
                    *at = at.max(share);
                    assert!(share < 0.1, "{name} {view:?}: pixels {i} {:?} and {j} {:?}", got[i], got[j]);
                }
            }
            // Both sides of the sun are each other's mirror image.
            if view.heading % 180.0 == 0.0 {
                for (i, here) in got.iter().enumerate() {
                    let there = got[i / 8 * 8 + 7 - i % 8];
                    for c in 0..3 {
                        assert!(
                            (here[c] - there[c]).abs() <= 1e-4 * here[c],
                            "{name} {view:?}: {i} {here:?} {there:?}"
                        );
                    }
                }
            }
        }
        println!("{}: between neighbours more than the reference's difference: {worst:.4?}", b.info().backend);
        renderer.destroy(b);
        for (name, bound) in SEAMS {
            assert!(worst[name] < bound, "{name}: {} more than the reference's difference", worst[name]);
        }
    });
}

/// What neighbouring pixels may differ by, beyond the reference's difference, of their light.
const SEAMS: [(&str, f64); 4] = [("horizon", 0.03), ("zenith", 2e-3), ("nadir", 2e-3), ("azimuth", 2e-3)];

// --- hard media

fn media() -> Vec<(&'static str, AtmosphereParams)> {
    let earth = AtmosphereParams::earth;
    let gas = AtmosphereParams::rayleigh;
    let dust = |g: f64, phase| AtmosphereParams {
        rayleigh_scattering: [0.0; 3],
        ozone_absorption: [0.0; 3],
        mie_asymmetry: [g; 3],
        mie_phase: phase,
        ..earth()
    };
    // Of optical depth 1 in blue times so much.
    let depth = |tau: f64| AtmosphereParams {
        rayleigh_scattering: [0.2, 0.5, 1.0].map(|c| c * tau / 12e3),
        rayleigh_scale_height: 12e3,
        ..gas()
    };
    let ball = |radius: f64, thickness: f64, height: f64| AtmosphereParams {
        planet_radius: radius,
        atmosphere_radius: radius + thickness,
        rayleigh_scattering: [0.05, 0.1, 0.2].map(|t| t / height),
        mie_scattering: [0.05 / height; 3],
        mie_absorption: [0.005 / height; 3],
        rayleigh_scale_height: height,
        mie_scale_height: height,
        ozone_absorption: [0.0; 3],
        ..earth()
    };
    let mut all: Vec<_> =
        AtmosphereParams::PRESETS.iter().map(|&n| (n, AtmosphereParams::preset(n).unwrap())).collect();
    all.extend([
        (
            "ozone",
            AtmosphereParams { ozone_absorption: earth().ozone_absorption, rayleigh_scattering: [0.0; 3], ..gas() },
        ),
        ("dust g -0.5", dust(-0.5, MiePhase::HenyeyGreenstein)),
        ("dust g 0.5", dust(0.5, MiePhase::CornetteShanks)),
        ("dust g 0", dust(0.0, MiePhase::CornetteShanks)),
        ("dust g 0.999", dust(0.999, MiePhase::CornetteShanks)),
        ("dust g -0.999", dust(-0.999, MiePhase::HenyeyGreenstein)),
        ("depth 1e-9", depth(1e-9)),
        ("depth 1e4", depth(1e4)),
        ("scale height 1 m", AtmosphereParams { rayleigh_scale_height: 1.0, mie_scale_height: 1.0, ..earth() }),
        ("thin shell", ball(6.36e6, 63.7, 8.0)),
        ("thick shell", ball(6.36e6, 12.72e6, 1e6)),
        ("1 km planet", ball(1e3, 300.0, 40.0)),
        ("black ground", AtmosphereParams { ground_albedo: [0.0; 3], ..earth() }),
        ("white ground", AtmosphereParams { ground_albedo: [1.0; 3], ..earth() }),
    ]);
    all
}

#[test]
fn hard_media_are_finite() {
    let draw_all = |b: &mut dyn Backend, quality: Quality, media: &[(&'static str, AtmosphereParams)]| {
        let mut renderer = PictureRenderer::default();
        for (name, params) in media {
            let (radius, thickness) = (params.planet_radius, params.thickness());
            // Metres above the surface that are the next f64 of the distance from the centre.
            let ulp = |r: f64, up: bool| (if up { r.next_up() } else { r.next_down() }) - radius;
            let top = params.atmosphere_radius;
            let altitudes = [
                -100.0_f64.min(0.4 * radius),
                0.0,
                0.3 * thickness,
                ulp(top, false),
                top - radius,
                ulp(top, true),
                // In 32 bits, as the passes have it.
                f64::from((thickness as f32).next_down()),
                f64::from((thickness as f32).next_up()),
                2.0 * thickness + radius,
            ];
            let mut lit = 0.0_f32;
            for altitude in altitudes {
                for sun_elevation in if (altitude / thickness - 1.0).abs() < 0.1 { &[3.0][..] } else { &[90.0, -20.0] }
                {
                    let sun_elevation = *sun_elevation;
                    let dip = (radius / (radius + altitude.max(0.0))).acos().to_degrees();
                    let view = View {
                        params: params.clone(),
                        altitude,
                        pitch: if altitude > 1.5 * thickness { -89.0 } else { -dip },
                        fov: 130.0,
                        sun_elevation,
                        ..View::default()
                    };
                    let settings = PictureSettings {
                        terrain: None,
                        sky: SkySettings { sun_disk: false, ..quality.into() },
                        radiance: Format::Rgba32Float,
                        ..PictureSettings::default()
                    };
                    let what = format!("{} {quality:?} {name}, {altitude} m, sun {sun_elevation}", b.info().backend);
                    let pixels = draw(b, &mut renderer, &view.scene(), &settings, [8, 8]);
                    assert_light(&pixels, &what);
                    lit = pixels.chunks_exact(4).fold(lit, |m, p| m.max(p[2]));
                }
            }
            assert!((lit > 0.0) == (*name != "ozone"), "{name}: {lit}");
        }
        renderer.destroy(b);
    };
    on_both(|b| {
        draw_all(b, Quality::LOW, &media());
        draw_all(b, Quality::MEDIUM, &media()[..2]);
        draw_all(b, Quality::HIGH, &media()[..1]);
    });
}

// --- nothing is left behind

#[test]
fn tables_are_freed() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut world = World::new();
        let before = b.live();
        let mut frame = |b: &mut dyn Backend, i: u32| {
            world.size = [1 + i % 12, 1 + i % 8];
            world.sky.render_scale = if i.is_multiple_of(3) { 0.5 } else { 1.0 };
            // Now and then other tables, and another medium's.
            world.lut = LutSettings { sky: [8 + i % 100 / 50, 12], ..TINY };
            world.view.params = if i % 50 < 25 { AtmosphereParams::earth() } else { AtmosphereParams::rayleigh() };
            world.sky.composition = if i.is_multiple_of(5) { Composition::SkyDome } else { Composition::Full };
            let settings = over_black(world.sky());
            renderer.draw(b, &world.view.scene(), &settings, world.size).unwrap();
        };
        (0..100).for_each(|i| frame(b, i));
        let after_few = b.live();
        assert!(after_few.textures > before.textures + 4 + 5);
        // A multiple of every period, so that the last frame is alike.
        (100..1300).for_each(|i| frame(b, i));
        assert_eq!(b.live(), after_few);
        renderer.destroy(b);
        let left = b.live();
        assert_eq!((left.textures, left.framebuffers), (before.textures, before.framebuffers));
    });
}
