//! The moon before the sun: light in the air under its shadow.

use std::f64::consts::PI;

use glam::DVec3;
use welkin::gpu::{Backend, Target};
use welkin::model::moon::{Disks, MOON_RADIUS, Moon, limb_darkening};
use welkin::probe::{self, Case, Probe};
use welkin::reference::multiple::Settings as Solve;
use welkin::reference::path::{Settings, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering, transmittance};
use welkin::render::cpu_picture::render;
use welkin::{
    AtmosphereParams, Bound, Composition, Error, Frame, Look, PictureSettings, Quality, Scene, SkyRenderer,
    SkySettings,
};

use crate::harness::{
    TINY, View, background, background_passes, clear_pass, composed, luts, march, mean, on_both, orders,
    query, rgb, sky, target,
};

/// Of the real one, metres.
pub const DISTANCE: f64 = 3.6e8;

/// A moon whose middle stands `apart` sun radii from the sun's, to the side of `across`.
pub fn moon(query: &RayQuery, size: f64, apart: f64, across: DVec3, distance: f64) -> Moon {
    let p = AtmosphereParams::earth();
    let side = (across - query.sun * across.dot(query.sun)).normalize();
    let (sin, cos) = (apart * p.sun_angular_radius).sin_cos();
    Moon::new((query.sun * cos + side * sin) * distance, (size * p.sun_angular_radius).sin() * distance)
}

fn light(query: &RayQuery) -> [f64; 3] {
    single_scattering(&AtmosphereParams::earth(), query, Sun::Point, Tolerance::TRUTH).unwrap().per_irradiance
}

const RAYS: [(f64, f64, f64, f64); 5] = [
    (2.0, 0.4, 0.6, 0.3),
    (2.0, 1.5, 0.9, 2.5),
    (2.0, 1.565, 1.3, 0.0),
    (4e5, 1.95, 1.2, 1.0),
    (2e7, 3.0, 2.2, 0.5),
];

#[test]
fn a_far_moon_dims_all_air_alike() {
    for (altitude, view, sun, azimuth) in RAYS {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let clear = light(&query);
        for (size, apart, darkened) in [(1.05, 0.6, false), (0.9, 0.05, true), (1.0, 1.4, true)] {
            // So far that every point sees the same.
            let moon = Moon { limb_darkening: darkened, ..moon(&query, size, apart, DVec3::Y, 9e14) };
            let p = AtmosphereParams::earth();
            let share = moon.sunlight(DVec3::ZERO, query.sun, p.sun_angular_radius);
            let dimmed = light(&query.eclipsed_by(moon));
            for c in 0..3 {
                let expected = share[c] * clear[c];
                assert!(
                    (dimmed[c] - expected).abs() <= 3e-6 * expected,
                    "{altitude} {view} {c}: {dimmed:?} {expected}"
                );
            }
        }
        let total = moon(&query, 2.0, 0.1, DVec3::X, 9e14);
        assert_eq!(light(&query.eclipsed_by(total)), [0.0; 3]);
        for c in 0..3 {
            let floor = light(&query.eclipsed_by(Moon { floor: 0.075, ..total }))[c];
            assert!((floor - 0.075 * clear[c]).abs() <= 3e-6 * clear[c]);
        }
        assert_eq!(light(&query.eclipsed_by(moon(&query, 1.0, 100.0, DVec3::X, DISTANCE))), clear);
    }
}

#[test]
fn every_point_of_a_ray_has_its_own_share() {
    // Pieces of the ray by differences of its light up to them, each times the share in its middle.
    for (altitude, view, sun, azimuth, apart) in [
        (2.0, 1.45, 0.6, 0.3, 0.0),
        (2.0, 0.8, 0.9, 2.0, 0.5),
        (2.0, 1.52, 0.3, 1.0, 1.2),
        (4e5, 1.9, 1.2, 1.0, 1.0),
    ] {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let moon = moon(&query, 1.05, apart, query.direction, DISTANCE);
        let p = AtmosphereParams::earth();
        let end = if altitude > 1e5 { 4e6 } else { 1.2e6 };
        let mut sum = [0.0; 3];
        let mut before = [0.0; 3];
        const PIECES: usize = 2000;
        let place = |i: f64| end * (i / PIECES as f64).powi(if altitude > 1e5 { 1 } else { 2 });
        for i in 0..PIECES {
            let upto = light(&query.ended_at(place(i as f64 + 1.0)));
            let middle = query.direction * place(i as f64 + 0.5);
            let share = moon.sunlight(middle, query.sun, p.sun_angular_radius);
            for c in 0..3 {
                sum[c] += (upto[c] - before[c]) * share[c];
            }
            before = upto;
        }
        let (dimmed, clear) = (light(&query.eclipsed_by(moon)), light(&query));
        for c in 0..3 {
            let off = (dimmed[c] - sum[c]).abs() / clear[c];
            assert!(off < 2e-5, "{altitude} {view} {apart} {c}: {dimmed:?} {sum:?} {clear:?}");
        }
        assert!(dimmed[1] < 0.9 * clear[1], "the shadow misses the ray: {dimmed:?} {clear:?}");
    }
}

#[test]
fn paths_know_the_moon() {
    let params = AtmosphereParams { ground_albedo: [0.3; 3], ..AtmosphereParams::earth() };
    let settings = Settings { paths: 2000, seed: 3 };
    for (altitude, view, sun, azimuth) in [(2.0, 0.4, 0.6, 0.3), (2e5, 2.5, 0.9, 1.0)] {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let clear = path_trace(&params, &query, settings).unwrap();
        let far = moon(&query, 1.0, 0.8, DVec3::Y, 9e14);
        let share = far.sunlight(DVec3::ZERO, query.sun, params.sun_angular_radius);
        // The same paths, each with the same share of its light.
        let dimmed = path_trace(&params, &query.eclipsed_by(far), settings).unwrap();
        for c in 0..3 {
            let expected = share[c] * clear.per_irradiance[c];
            assert!((dimmed.per_irradiance[c] / expected - 1.0).abs() < 1e-5, "{altitude} {c}");
            assert!((dimmed.std_err[c] / (share[c] * clear.std_err[c]) - 1.0).abs() < 1e-4);
        }
    }
    // In the middle of the umbra the sky is dark but not black: light comes from outside of it.
    let query = RayQuery::new(2.0, 0.2, 0.6, 0.3);
    let total = moon(&query, 1.06, 0.0, DVec3::Y, DISTANCE);
    let once = light(&query.eclipsed_by(total));
    let clear = path_trace(&params, &query, settings).unwrap().per_irradiance;
    let dark = path_trace(&params, &query.eclipsed_by(total), Settings { paths: 40_000, seed: 5 }).unwrap();
    for c in 0..3 {
        assert!(once[c] < 1e-3 * clear[c], "{once:?}");
        let share = dark.per_irradiance[c] / clear[c];
        assert!((1e-5..3e-3).contains(&share), "{share} ± {}", dark.std_err[c] / clear[c]);
    }
}

#[test]
fn what_has_no_shadow_says_so() {
    let params = AtmosphereParams::rayleigh();
    let query = RayQuery::new(2.0, 0.4, 0.6, 0.3);
    let moon = Moon::new(query.sun * DISTANCE, MOON_RADIUS);
    let field = |e: Error| e.to_string().split(' ').next().unwrap_or_default().to_owned();
    let disk =
        single_scattering(&params, &query.eclipsed_by(moon), Sun::Disk { rings: 2 }, Tolerance::PICTURE);
    assert_eq!(field(disk.unwrap_err()), "sun");
    let orders = orders(&params, Solve::QUICK);
    orders.radiance(&query, Tolerance::PICTURE).unwrap();
    assert_eq!(field(orders.radiance(&query.eclipsed_by(moon), Tolerance::PICTURE).unwrap_err()), "ray.moon");
    let inside = Moon { radius: 5e8, ..moon };
    let refused = single_scattering(&params, &query.eclipsed_by(inside), Sun::Point, Tolerance::PICTURE);
    assert_eq!(field(refused.unwrap_err()), "moon.position");
    let refused = path_trace(&params, &query.eclipsed_by(inside), Settings { paths: 16, seed: 1 });
    assert_eq!(field(refused.unwrap_err()), "moon.position");
}

/// What the shaders make of the shares, one case a pixel.
#[test]
fn shares_in_f32_are_those_of_f64() {
    let tangent = 4.65e-3_f32;
    let mut cases = Vec::new();
    for size in [0.02, 0.3, 0.9, 0.95, 0.999, 1.0, 1.001, 1.05, 1.3, 8.0_f32] {
        let (far, near) = (1.0 + size, (1.0 - size).abs());
        let mut aparts: Vec<f32> = (0..=60).map(|i| far * 1.02 * i as f32 / 60.0).collect();
        for step in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
            aparts.extend([far - step, far + step, (near - step).max(0.0), near + step]);
        }
        for (i, apart) in aparts.into_iter().enumerate() {
            // The moon at its distance, turned about the axis; some nearer, some beyond the planets.
            let along = [3.6e5, 1.2e3, 7.7e9_f32][i % 3];
            let (sin, cos) = (i as f32).sin_cos();
            let across = apart * tangent * along;
            cases.push(Case {
                direction: [across * cos, across * sin, along],
                altitude: size * tangent * along,
                fraction: tangent,
                ..Case::default()
            });
        }
    }
    // Behind the point, and in its plane.
    for along in [-3.6e5, 0.0] {
        cases.push(Case {
            direction: [0.0, 0.0, along],
            altitude: 1737.0,
            fraction: tangent,
            ..Case::default()
        });
    }
    on_both(|b| {
        let answers = probe::run(b, Probe::Eclipse, &cases).unwrap();
        let mut worst = 0.0_f64;
        let mut crescents = 0;
        for (case, got) in cases.iter().zip(&answers) {
            let [x, y, along] = case.direction.map(f64::from);
            let sun = f64::from(case.fraction);
            let disks = Disks { sun, moon: f64::from(case.altitude) / along, apart: x.hypot(y) / along };
            let uniform = if along > 0.0 { disks.visible() } else { 1.0 };
            worst = worst.max((f64::from(got[0]) - uniform).abs());
            // The last of the sun keeps its digits, as far as the place of the moon has them: light goes with
            // the depth of the crescent to the power of 1.5, and that is a difference of numbers rounded to
            // 2^-22 of them.
            let depth = (disks.apart + sun - disks.moon) / sun;
            if uniform < 1e-3 && depth > 9e-5 && disks.moon > 1.04 * sun {
                let off = (f64::from(got[0]) / uniform - 1.0).abs();
                let rounding = 1.5 * 2f64.powi(-22) * disks.moon / sun / depth;
                assert!(off < 1e-3 + rounding, "{disks:?}: {} {uniform}", got[0]);
                crescents += 1;
            }
        }
        assert!(crescents > 5, "{crescents}");
        println!("share within {worst:.1e}");
        assert!(worst < 5e-7, "{worst}");
    });
}

/// The background alone over black in a square picture.
fn black_background(b: &mut dyn Backend, scene: &Scene, settings: SkySettings, n: u32) -> Vec<f32> {
    background(b, scene, settings, [n, n], [0.0, 0.0, 0.0, 1.0])
}

/// Above the air, looking at the sun, whose irradiance is 1; degrees of view.
fn at_the_sun(fov: f64) -> View {
    let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
    View { params, altitude: 1e6, pitch: 30.0, sun_elevation: 30.0, fov, ..View::default() }
}

/// Light in a small picture, per channel.
fn irradiance(pixels: &[f32], fov: f64, n: u32) -> [f64; 3] {
    let pixel = (2.0 * (0.5 * fov.to_radians()).tan() / f64::from(n)).powi(2);
    mean(pixels).map(|v| v * f64::from(n * n) * pixel)
}

const DARKENED: SkySettings = SkySettings { look: Look { limb_darkening: true, ..BARE.look }, ..BARE };
const BARE: SkySettings = SkySettings {
    look: Look {
        enabled: true,
        composition: Composition::Full,
        sun_disk: true,
        limb_darkening: false,
        foreground: true,
        airglow: None,
        scene_shaders: false,
    },
    quality: Quality::March { view_samples: 8, light_samples: 4 },
    render_scale: 1.0,
    bound: Some(Bound::LINEAR),
};

#[test]
fn a_darker_limb_keeps_the_suns_light() {
    on_both(|b| {
        // From 140 pixels across to less than one.
        for (n, fov, off) in [(160, 0.6, 5e-3), (64, 1.0, 5e-3), (16, 1.0, 0.02), (9, 3.0, 0.05)] {
            let scene = at_the_sun(fov).scene();
            let [flat, dark] =
                [BARE, DARKENED].map(|s| irradiance(&black_background(b, &scene, s, n), fov, n));
            for c in 0..3 {
                println!("{n} pixels of {fov}°: {} of {}", dark[c], flat[c]);
                assert!((dark[c] / flat[c] - 1.0).abs() < off, "{n} {fov} {c}: {dark:?} {flat:?}");
            }
        }
        let n = 200;
        let pixels = black_background(b, &at_the_sun(0.6).scene(), DARKENED, n);
        let pixel = 2.0 * 0.3_f64.to_radians().tan() / f64::from(n);
        let full = 1.0 / (PI * AtmosphereParams::earth().sun_angular_radius.powi(2));
        for x in n / 2..n {
            let r = (f64::from(x) + 0.5 - f64::from(n) / 2.0).hypot(0.5) * pixel
                / at_the_sun(1.0).params.sun_angular_radius;
            if r < 0.97 {
                for c in 0..3 {
                    let got = f64::from(pixels[4 * (n / 2 * n + x) as usize + c]) / full;
                    assert!((got / limb_darkening(r)[c] - 1.0).abs() < 3e-3, "{r} {c}: {got}");
                }
            }
        }
    });
}

#[test]
fn the_moon_hides_the_drawn_sun() {
    on_both(|b| {
        for (size, apart) in [(1.06, 1.2), (0.95, 0.02), (1.06, 0.03), (1.0, 0.4), (1.0, 2.1)] {
            let view = at_the_sun(0.6);
            let mut scene = view.scene();
            let p = &scene.atmosphere;
            let (sin, cos) = (apart * p.sun_angular_radius).sin_cos();
            let towards = scene.sun_direction * cos + DVec3::Y * sin;
            let radius = (size * p.sun_angular_radius).sin() * DISTANCE;
            scene.moon = Some(Moon::new(scene.camera.position + towards * DISTANCE, radius));
            let disks = Disks {
                sun: p.sun_angular_radius,
                moon: size * p.sun_angular_radius,
                apart: apart * p.sun_angular_radius,
            };
            let flat = irradiance(&black_background(b, &scene, BARE, 256), 0.6, 256);
            let dark = irradiance(&black_background(b, &scene, DARKENED, 256), 0.6, 256);
            let (share, shares) = (disks.visible(), disks.visible_limb_darkened());
            for c in 0..3 {
                assert!((flat[c] - share).abs() < 5e-3, "{size} {apart}: {flat:?} {share}");
                assert!((dark[c] - shares[c]).abs() < 5e-3, "{size} {apart} {c}: {dark:?} {shares:?}");
            }
            if share == 0.0 {
                assert!(flat == [0.0; 3], "{flat:?}");
            }
            // Of a pixel or two.
            let coarse = irradiance(&black_background(b, &scene, BARE, 3), 0.6, 3);
            let whole = irradiance(&black_background(b, &view.scene(), BARE, 3), 0.6, 3);
            assert!(
                (coarse[1] - share * whole[1]).abs() < 0.02,
                "{size} {apart}: {coarse:?} {share} of {whole:?}"
            );
        }
    });
}

#[test]
fn the_moon_has_its_phase_and_the_air_dims_it() {
    on_both(|b| {
        for (altitude, elevation, sun_azimuth) in
            [(1e6, 40.0, 180.0), (1e6, 40.0, 90.0), (1e6, 40.0, 30.0_f64), (2.0, 25.0, 100.0)]
        {
            let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
            let view = View { params, altitude, pitch: elevation, fov: 0.7, ..View::default() };
            let mut scene = view.scene();
            let azimuth = sun_azimuth.to_radians();
            scene.sun_direction = DVec3::new(0.6 * azimuth.cos(), 0.6 * azimuth.sin(), 0.8);
            if altitude < 1e3 {
                // Night: the sky's light is out of the way.
                scene.sun_direction.z = -0.8;
            }
            let towards = scene.camera.forward.normalize();
            let moon = Moon {
                earthshine: 0.01,
                ..Moon::new(scene.camera.position + towards * DISTANCE, MOON_RADIUS)
            };
            scene.moon = Some(moon);
            let n = 48;
            let got = black_background(b, &scene, BARE, n);
            let mut none = scene.clone();
            none.moon = None;
            let sky = black_background(b, &none, BARE, n);
            let view = scene.validate().unwrap();
            let sun = scene.sun_direction.normalize();
            let mut seen = 0;
            for y in 0..n {
                for x in 0..n {
                    let query = query(&scene, [n, n], (y * n + x) as usize);
                    let world = view.world_to_zenith.transpose() * query.direction;
                    // Well inside of the disk, where pixels are whole.
                    let offset = (world - towards).length() / (MOON_RADIUS / DISTANCE);
                    let i = 4 * (y * n + x) as usize;
                    if offset > 1.1 {
                        assert_eq!(got[i..i + 3], sky[i..i + 3]);
                    }
                    if offset > 0.9 {
                        continue;
                    }
                    let radiance = moon.radiance(scene.camera.position, world, sun).unwrap();
                    let through =
                        transmittance(&scene.atmosphere, &query, Tolerance { relative: 1e-6 }).unwrap();
                    for c in 0..3 {
                        let want = radiance * through[c] + f64::from(sky[i + c]);
                        let off = (f64::from(got[i + c]) - want).abs();
                        assert!(
                            off < 2e-3 * want + 2e-6,
                            "{altitude} {sun_azimuth} {offset}: {} {want}",
                            got[i + c]
                        );
                    }
                    seen += 1;
                }
            }
            assert!(seen > 300, "{seen}");
        }
    });
}

#[test]
fn without_a_moon_there_is_nothing_of_it() {
    let view = at_the_sun(1.0);
    let mut scene = view.scene();
    let plan = |scene: &Scene| Frame::new(scene, &SkySettings::default(), [64, 64]).unwrap();
    let labels = |scene: &Scene| {
        plan(scene).planned_passes().iter().map(|p| p.program.map(|p| p.name())).collect::<Vec<_>>()
    };
    assert!(labels(&scene).iter().flatten().all(|name| !name.to_lowercase().contains("moon")));
    let towards =
        |direction: DVec3| Some(Moon::new(scene.camera.position + direction * DISTANCE, MOON_RADIUS));
    let (sun, up) = (scene.sun_direction, scene.camera.up);
    let [behind, total, partial, beside] = [-sun, sun, sun + up * 2e-3, up].map(towards);
    for (moon, drawn, hides) in
        [(behind, false, false), (total, true, false), (partial, true, true), (beside, false, false)]
    {
        scene.moon = moon;
        let names: Vec<_> = labels(&scene).into_iter().flatten().collect();
        assert_eq!(names.iter().any(|n| n.starts_with("moon_disk")), drawn, "{names:?}");
        assert_eq!(
            names.iter().any(|n| n.starts_with("sun_disk") && n.contains("+MOON")),
            hides,
            "{names:?}"
        );
        // All of the sun behind the moon: no pass for it.
        assert_eq!(names.iter().any(|n| n.starts_with("sun_disk")), moon != total, "{names:?}");
    }
    scene.moon = Some(Moon { radius: 1e9, ..Moon::new(scene.camera.position + DVec3::X * DISTANCE, 1.0) });
    let error = Frame::new(&scene, &SkySettings::default(), [64, 64]).unwrap_err().to_string();
    assert!(error.starts_with("moon.position"), "{error}");
}

/// The processor's picture of an eclipse has the sun, the moon and the shadow of the judges above.
#[test]
fn the_processor_draws_the_same_disks() {
    let view = View { altitude: 2.0, ..at_the_sun(0.8) };
    let mut scene = view.scene();
    let p = scene.atmosphere.clone();
    let (sin, cos) = (0.7 * p.sun_angular_radius).sin_cos();
    let towards = scene.sun_direction * cos + DVec3::Y * sin;
    scene.moon = Some(Moon::new(
        scene.camera.position + towards * DISTANCE,
        (0.97 * p.sun_angular_radius).sin() * DISTANCE,
    ));
    let n = 24;
    let settings = PictureSettings {
        sky: composed(Composition::SkyDome, DARKENED),
        terrain: None,
        ..PictureSettings::default()
    };
    let cpu = render(&scene, &settings, [n, n], &|_| {}).unwrap().radiance;
    on_both(|b| {
        let gpu = black_background(b, &scene, settings.sky, n);
        let brightest = f64::from(gpu.iter().copied().fold(0.0, f32::max));
        for (i, (a, b)) in cpu.iter().zip(gpu.chunks_exact(4)).enumerate() {
            for c in 0..3 {
                // Disks by one formula; the sky behind, under the shadow in one of them only, is 1e-5 of
                // that.
                let off = (f64::from(a[c]) - f64::from(b[c])).abs();
                assert!(off < 2e-3 * f64::from(a[c]) + 5e-3 * brightest, "{i} {c}: {a:?} {b:?}");
            }
        }
    });
}

/// The moon is a body: stars do not shine through its dark side, and the air before it shines all the same.
/// By LUTs, in a march, and where the air is laid over everything afterwards.
#[test]
fn stars_are_behind_the_moon() {
    const N: u32 = 15;
    const STARS: [f32; 4] = [0.5, 0.25, 0.125, 1.0];
    let view =
        View { altitude: 3e3, pitch: 25.0, sun_elevation: -8.0, fov: 4.0, aspect: 1.0, ..View::default() };
    let mut scene = view.scene();
    let forward = scene.camera.forward.normalize();
    // A new moon but for its earthshine: the sun stands behind it.
    let moon = Moon::new(scene.camera.position + forward * DISTANCE, 6e6);
    scene.moon = Some(moon);
    let middle = scene.validate().unwrap().world_to_zenith * forward;
    on_both(|b| {
        for sky in [luts(TINY), sky(march(8, 4)), composed(Composition::AtmospherePost, luts(TINY))] {
            let mut drawn = |behind: [f32; 4], moon: Option<Moon>| {
                let scene = Scene { moon, ..scene.clone() };
                let color = target(b, [N, N]);
                b.run(&[clear_pass(color, behind)]).unwrap();
                let mut renderer = SkyRenderer::new(sky).unwrap();
                let passes = background_passes(b, &mut renderer, &scene, Target::color(color));
                b.run(&passes).unwrap();
                let pixels = b.read(color).unwrap();
                renderer.destroy(b);
                b.destroy_texture(color);
                pixels
            };
            let (dark, stars) = (drawn([0.0, 0.0, 0.0, 1.0], Some(moon)), drawn(STARS, Some(moon)));
            let sky_alone = drawn(STARS, None);
            let mut hidden = 0;
            for i in 0..(N * N) as usize {
                let ray = query(&scene, [N, N], i);
                let apart = (ray.direction - middle).length();
                let (a, b) = (rgb(&dark, i), rgb(&stars, i));
                // Half a pixel inside of the edge, a seventh of the radius, pixels are covered whole.
                if apart < 0.7 * 6e6 / DISTANCE {
                    hidden += 1;
                    assert!(
                        (0..3).all(|c| (a[c] - b[c]).abs() < 1e-6),
                        "{i}: stars through the moon: {a:?} {b:?}"
                    );
                } else if apart > 1.3 * 6e6 / DISTANCE {
                    assert!(b[0] > a[0] + 0.1, "{i}: no stars beside the moon");
                    assert!(
                        (0..3).all(|c| (b[c] - rgb(&sky_alone, i)[c]).abs() < 1e-6),
                        "{i}: beside the moon"
                    );
                }
            }
            assert!(hidden > 10, "{hidden} pixels of the moon");
        }
    });
}
