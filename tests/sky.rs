//! What is drawn: the same bodies on both backends, judged by physics and by the f64 reference.

use glam::{DQuat, DVec2, DVec3};
use welkin::frame::{HAND_OVER, background_weight, hand_over};
use welkin::gpu::{Backend, Format, Pass, RowOrder, Target, TextureDesc};
use welkin::reference::single::{Sun, Tolerance, single_scattering, transmittance};
use welkin::{
    AerialTargets, AtmosphereParams, Bound, Composition, FrameTargets, Look, LutSettings, MiePhase,
    PictureRenderer, PictureSettings, Quality, Scene, SkyRenderer, SkySettings,
};

use crate::harness::{
    View, aerial_passes, airless, assert_physical, background, background_by, background_passes, clear_pass,
    cleared, composed, copy_pass, draw, draw_both, frame_passes, frame_textures, free, march, mean, on_both,
    over_black, picture, picture_passes, query, rays, rgb, texture, with_disk, without_disk,
};

const FINE: SkySettings = SkySettings {
    look: Look {
        enabled: true,
        composition: Composition::Full,
        sun_disk: false,
        limb_darkening: false,
        foreground: true,
        airglow: None,
        scene_shaders: false,
    },
    quality: Quality::March { view_samples: 256, light_samples: 64 },
    render_scale: 1.0,
    bound: Some(Bound::LINEAR),
};

/// Light scattered once, and of all orders: what holds of any sky holds of both. No sun's disk.
const ANY: [SkySettings; 2] = [
    SkySettings { quality: Quality::March { view_samples: 24, light_samples: 8 }, ..FINE },
    SkySettings { quality: Quality::Luts(LutSettings::MEDIUM), ..FINE },
];

/// Sky and shell together over black, without any scene: what an eye sees.
fn whole_sky(b: &mut dyn Backend, scene: &Scene, settings: SkySettings, size: [u32; 2]) -> Vec<f32> {
    picture(b, scene, &over_black(settings), size)
}

fn pixel(pixels: &[f32], width: u32, x: u32, y: u32) -> [f64; 3] {
    rgb(pixels, (y * width + x) as usize)
}

/// Runs the body on both backends with either method.
fn on_each(mut body: impl FnMut(&mut dyn Backend, SkySettings)) {
    on_both(|b| ANY.into_iter().for_each(|settings| body(b, settings)));
}

#[test]
fn radiance_is_the_references() {
    let views = [
        ("ground, noon", View { sun_elevation: 60.0, pitch: 30.0, ..View::default() }),
        ("ground, sunset", View { sun_elevation: 1.0, pitch: 20.0, ..View::default() }),
        (
            "ground, away from the setting sun",
            View { sun_elevation: 1.0, pitch: 20.0, heading: 180.0, ..View::default() },
        ),
        ("ground, dusk", View { sun_elevation: -4.0, pitch: 25.0, ..View::default() }),
        ("11 km", View { altitude: 11e3, sun_elevation: 10.0, ..View::default() }),
        ("30 km, half handed over", View { altitude: 30e3, sun_elevation: 10.0, ..View::default() }),
        (
            "400 km, limb",
            View { altitude: 4e5, pitch: -19.0, fov: 10.0, sun_elevation: 20.0, ..View::default() },
        ),
        (
            "12,000 km",
            View { altitude: 1.2e7, pitch: -90.0, fov: 44.0, sun_elevation: 35.0, ..View::default() },
        ),
        (
            "moon's distance",
            View { altitude: 3.8e8, pitch: -90.0, fov: 2.2, sun_elevation: 35.0, ..View::default() },
        ),
        (
            "mars",
            View { params: AtmosphereParams::mars(), sun_elevation: 5.0, pitch: 25.0, ..View::default() },
        ),
        (
            "earth-like",
            View { params: AtmosphereParams::earth_like(6_371_000.0), pitch: 30.0, ..View::default() },
        ),
    ];
    on_both(|backend| {
        for (name, view) in &views {
            let (scene, size) = (view.scene(), [24, 24]);
            let pixels = whole_sky(backend, &scene, FINE, size);
            assert_physical(&pixels, name);
            let brightest = pixels.iter().copied().fold(0.0, f32::max);
            let (mut worst, mut compared) = (0.0_f64, 0);
            for (x, y) in (0..24).step_by(5).flat_map(|y| (0..24).step_by(5).map(move |x| (x, y))) {
                let want = single_scattering(
                    &scene.atmosphere,
                    &query(&scene, size, (y * 24 + x) as usize),
                    Sun::Point,
                    Tolerance::TRUTH,
                )
                .unwrap();
                let got = pixel(&pixels, 24, x, y);
                for c in 0..3 {
                    // Deviation relative to the value, or to a thousandth of the picture's brightest.
                    let scale = want.radiance[c].max(1e-3 * f64::from(brightest));
                    worst = worst.max((got[c] - want.radiance[c]).abs() / scale);
                    compared += usize::from(want.radiance[c] > 0.0);
                }
            }
            println!("{} {name}: largest deviation {:.3} %", backend.info().backend, worst * 100.0);
            assert!(compared > 20, "{name}: only {compared} values to compare");
            assert!(worst < 1e-3, "{name}: {worst}");
        }
    });
}

#[test]
fn looks_are_those_of_the_documents() {
    on_each(|b, settings| {
        let mut renderer = PictureRenderer::default();
        let mut see = |view: View| {
            let p = draw(b, &mut renderer, &view.scene(), &over_black(settings), [16, 16]);
            assert_physical(&p, "look");
            mean(&p)
        };
        let narrow = View { fov: 4.0, ..View::default() };
        let sum = |c: [f64; 3]| c[0] + c[1] + c[2];
        let zenith = see(View { pitch: 90.0, ..narrow.clone() });
        let horizon = see(View { pitch: 3.0, heading: 90.0, ..narrow.clone() });
        assert!(zenith[2] > 2.0 * zenith[0], "the zenith is blue: {zenith:?}");
        assert!(sum(horizon) > 1.5 * sum(zenith), "the horizon is brighter: {horizon:?} {zenith:?}");
        assert!(horizon[2] / horizon[0] < 0.7 * zenith[2] / zenith[0], "and paler");
        let sunset = see(View { pitch: 2.0, sun_elevation: 1.0, ..narrow.clone() });
        assert!(sunset[0] > 2.0 * sunset[2], "the sunset is red: {sunset:?}");
        // Redder with every step of the sun towards the horizon.
        let ratios = [60.0, 30.0, 10.0, 4.0, 1.0].map(|sun_elevation| {
            let c = see(View { pitch: 5.0, heading: 60.0, sun_elevation, ..narrow.clone() });
            c[0] / c[2]
        });
        assert!(ratios.windows(2).all(|w| w[1] > w[0]), "{ratios:?}");
        // Dusk is dark, night is black: nothing is scattered once behind the planet's shadow, and next to
        // nothing often.
        let dusk = see(View { pitch: 90.0, sun_elevation: -5.0, ..narrow.clone() });
        let night = see(View { pitch: 90.0, sun_elevation: -30.0, ..narrow.clone() });
        assert!(sum(dusk) > 0.0 && sum(dusk) < 2e-2 * sum(zenith), "{dusk:?}");
        let single = settings.quality.is_single_scattering();
        assert!(sum(night) <= if single { 0.0 } else { 1e-6 * sum(zenith) }, "{night:?}");
        // The zenith darkens with altitude.
        let up = [100.0, 5e3, 15e3, 40e3]
            .map(|altitude| sum(see(View { pitch: 90.0, altitude, ..narrow.clone() })));
        assert!(up.windows(2).all(|w| w[1] < 0.8 * w[0]), "{up:?}");
        // From orbit the limb is a thin bright line: bright at its foot, black 150 km above.
        let dip = |h: f64, tangent: f64| -((6.36e6 + tangent) / (6.36e6 + h)).acos().to_degrees();
        let limb = [5e3, 40e3, 150e3]
            .map(|t| sum(see(View { altitude: 4e5, pitch: dip(4e5, t), fov: 0.05, ..narrow.clone() })));
        assert!(limb[0] > 5.0 * limb[1] && limb[1] > 0.0 && limb[2] == 0.0, "{limb:?}");
        // Mars: butterscotch by day, blue around the setting sun.
        let mars = View { params: AtmosphereParams::mars(), ..narrow };
        let day = see(View { pitch: 30.0, heading: 120.0, sun_elevation: 50.0, ..mars.clone() });
        let glow = see(View { pitch: 3.0, sun_elevation: 3.0, ..mars });
        assert!(day[0] > 1.2 * day[2], "{day:?}");
        assert!(glow[2] > glow[0], "{glow:?}");
        renderer.destroy(b);
    });
}

#[test]
fn planet_rays_draw_nothing_and_depth_is_left_alone() {
    on_each(|b, settings| {
        let scene = View { pitch: 0.0, ..View::default() }.scene();
        let sentinel = [0.125, 0.25, 0.5, 1.0];
        let p = background(b, &scene, settings, [16, 16], sentinel);
        assert_eq!(pixel(&p, 16, 8, 15), [0.125, 0.25, 0.5], "a ray that meets the planet drew");
        assert_ne!(pixel(&p, 16, 8, 0), [0.125, 0.25, 0.5], "the sky drew nothing");

        // With a depth attachment: whatever it holds, the sky draws and leaves it as it was.
        let [color, depth, out] = [Format::Rgba32Float, Format::Depth32Float, Format::R32Float]
            .map(|format| texture(b, "shared", [16, 16], format));
        let mut sky = SkyRenderer::new(settings).unwrap();
        for stored in [0.0, 0.7, 1.0] {
            let target = Target {
                clear: Some(sentinel),
                clear_depth: Some(stored),
                depth: Some(depth),
                ..Target::color(color)
            };
            let mut passes = background_passes(b, &mut sky, &scene, target);
            let copy = copy_pass(b, depth, out);
            passes.push(Pass { target: Target::color(out), ..copy });
            b.run(&passes).unwrap();
            assert_eq!(
                pixel(&b.read(color).unwrap(), 16, 3, 2),
                pixel(&p, 16, 3, 2),
                "depth {stored} changed the sky"
            );
            assert!(b.read(out).unwrap().iter().all(|d| *d == stored), "the sky wrote depth");
        }
    });
}

#[test]
fn terrain_occludes_the_sky() {
    on_each(|b, sky| {
        let scene = View { altitude: 2000.0, pitch: -10.0, ..View::default() }.scene();
        let with = PictureSettings { sky, ..Default::default() };
        let without = PictureSettings { terrain: None, ..with };
        let (a, n) = (picture(b, &scene, &with, [32, 32]), picture(b, &scene, &without, [32, 32]));
        assert_physical(&a, "terrain");
        assert_eq!(pixel(&a, 32, 16, 0), pixel(&n, 32, 16, 0), "terrain changed the sky above it");
        let (ground, hole) = (pixel(&a, 32, 16, 31), pixel(&n, 32, 16, 31));
        assert!(ground[1] > 1.05 * hole[1], "no ground below: {ground:?} {hole:?}");
    });
}

#[test]
fn both_backends_draw_the_same() {
    let views = [
        ("ground", View { altitude: 1500.0, ..View::default() }),
        ("sunset", View { altitude: 1500.0, sun_elevation: 1.0, ..View::default() }),
        ("15 km", View { altitude: 15e3, ..View::default() }),
        ("30 km", View { altitude: 30e3, ..View::default() }),
        ("limb", View { altitude: 4e5, pitch: -19.0, fov: 40.0, ..View::default() }),
        ("planet", View { altitude: 1.2e7, pitch: -90.0, fov: 44.0, ..View::default() }),
        (
            "mars",
            View {
                params: AtmosphereParams::mars(),
                altitude: 3000.0,
                sun_elevation: 4.0,
                ..View::default()
            },
        ),
    ];
    let mut drawn: Vec<Vec<Vec<f32>>> = Vec::new();
    on_both(|b| {
        let settings = PictureSettings::default();
        let mut renderer = PictureRenderer::default();
        drawn.push(
            views
                .iter()
                .map(|(_, v)| draw_both(b, &mut renderer, &v.scene(), &settings, [160, 120])[1].clone())
                .collect(),
        );
        renderer.destroy(b);
    });
    for (i, (name, _)) in views.iter().enumerate() {
        let differences: Vec<f32> =
            drawn[0][i].iter().zip(&drawn[1][i]).map(|(a, b)| (a - b).abs() * 255.0).collect();
        let largest = differences.iter().copied().fold(0.0, f32::max);
        let beyond = differences.iter().filter(|d| **d > 1.5).count();
        println!(
            "{name}: largest difference {largest:.0}/255, {beyond} of {} values beyond 1/255",
            differences.len()
        );
        // A triangle's edge may fall on the other side of a pixel's centre; the sky may not.
        assert!(beyond * 1000 <= differences.len(), "{name}: {beyond} values differ by more than 1/255");
    }
}

/// Synthetic scene: a plane `z` metres away along the camera's axis, in a depth convention.
fn air_before(b: &mut dyn Backend, settings: SkySettings, scene: &Scene, z: f64, behind: f32) -> Vec<f32> {
    let [color, depth, out] = frame_textures(b, [8, 8]);
    b.write_texture(color, &[behind; 256]).unwrap();
    let stored = if z.is_finite() { scene.depth.encode(z) } else { scene.depth.background() };
    b.write_texture(depth, &[stored as f32; 64]).unwrap();
    let mut sky = SkyRenderer::new(settings).unwrap();
    let passes = aerial_passes(b, &mut sky, scene, [color, depth, out]);
    b.run(&passes).unwrap();
    // Where no air is in the picture the scene stays as it is.
    let pixels = b.read(if passes.is_empty() { color } else { out }).unwrap();
    sky.destroy(b);
    free(b, [color, depth, out]);
    pixels
}

#[test]
fn air_dims_the_scene_and_adds_light_as_the_reference_does() {
    on_both(|b| {
        for (altitude, z) in [(100.0, 10.0), (100.0, 1e3), (100.0, 50e3), (9e3, 200e3), (4e5, 3e6)] {
            let scene = View { altitude, pitch: 1.0, fov: 1.0, ..View::default() }.scene();
            let (dark, bright) = (air_before(b, FINE, &scene, z, 0.0), air_before(b, FINE, &scene, z, 1.0));
            let q = query(&scene, [8, 8], 4 * 8 + 3);
            let ndc = DVec2::new(3.5 / 4.0 - 1.0, 1.0 - 4.5 / 4.0);
            let length = z * scene.camera.basis().unwrap().ray(ndc).length();
            let want =
                single_scattering(&scene.atmosphere, &q.ended_at(length), Sun::Point, Tolerance::TRUTH)
                    .unwrap();
            let (added, both) = (pixel(&dark, 8, 3, 4), pixel(&bright, 8, 3, 4));
            for c in 0..3 {
                let through = both[c] - added[c];
                assert!(
                    (added[c] - want.radiance[c]).abs() < 3e-3 * want.radiance[c] + 1e-6,
                    "{altitude} {z}: light {added:?} {want:?}"
                );
                assert!(
                    (through - want.transmittance[c]).abs() < 1e-3,
                    "{altitude} {z}: transmittance {through} {want:?}"
                );
            }
        }
    });
}

/// What lies behind the air is dimmed once on either side of the hand-over's end, however little of the sky
/// the background still draws: the middle of a low sun's disk does not change there. On the Earth and on a
/// small planet, whose hand-over ends elsewhere.
#[test]
fn what_lies_behind_is_dimmed_once_where_the_hand_over_ends() {
    let small = AtmosphereParams {
        planet_radius: 60e3,
        atmosphere_radius: 62e3,
        rayleigh_scale_height: 200.0,
        mie_scale_height: 100.0,
        rayleigh_scattering: AtmosphereParams::earth().rayleigh_scattering.map(|v| 30.0 * v),
        ..AtmosphereParams::earth()
    };
    on_each(|b, settings| {
        let settings = with_disk(true, settings);
        for (name, params) in [("Earth", AtmosphereParams::earth()), ("small", small.clone())] {
            // So dark that no target clips its disk.
            let params = AtmosphereParams { sun_intensity: 0.1, ..params };
            let (_, end) = hand_over(params.thickness());
            // Through the air, a tenth of its depth up.
            let lowest = params.planet_radius + 0.1 * params.thickness();
            let down = -(lowest / (params.planet_radius + end)).acos().to_degrees();
            let mut renderer = PictureRenderer::default();
            let mut disk = |b: &mut dyn Backend, altitude: f64| {
                let view = View { altitude, pitch: down, sun_elevation: down, fov: 1.5, ..View::default() };
                let scene = View { params: params.clone(), aspect: 1.0, ..view }.scene();
                let pixels = draw(b, &mut renderer, &scene, &over_black(settings), [15, 15]);
                rgb(&pixels, 7 * 15 + 7)
            };
            let above = disk(b, end + 1.0);
            assert!(above[0] > 1e-3 && above[0] > 2.0 * above[2], "{name}: no low sun: {above:?}");
            for part in [1e-3, 1e-4, 7e-5, 1e-5, 1e-7, 1e-10] {
                let below = disk(b, end * (1.0 - part));
                for c in 0..3 {
                    let off = (below[c] / above[c] - 1.0).abs();
                    assert!(off < 0.05, "{name}, {part:e} below the end: {below:?}, above {above:?}");
                }
            }
            renderer.destroy(b);
        }
    });
}

/// What lies behind the air is dimmed channel by channel, by whichever pass: a star seen low through the air
/// is red from below the hand-over's end as from above it. (A blend with one alpha made it grey.)
#[test]
fn stars_keep_their_color_through_the_air() {
    const SIZE: [u32; 2] = [4, 4];
    on_each(|b, settings| {
        for (altitude, pitch) in [(2.0, 3.0), (2.0, 40.0), (14e3, -1.5), (49.9e3, -6.0), (50.001e3, -6.0)] {
            for render_scale in [1.0, 0.5] {
                let mut settings = SkySettings { render_scale, bound: None, ..settings };
                if settings.quality.is_single_scattering() {
                    settings.quality = march(64, 8); // By its samples a march knows how much air there is.
                }
                let scene =
                    View { altitude, pitch, fov: 1.0, sun_elevation: -30.0, ..View::default() }.scene();
                let [color, depth, out] = frame_textures(b, SIZE);
                b.write_texture(depth, &[scene.depth.background() as f32; 16]).unwrap();
                let mut sky = SkyRenderer::new(settings).unwrap();
                let [without, with] = [0.0, 1.0].map(|star: f32| {
                    let mut passes = vec![clear_pass(color, [star, star, star, 1.0])];
                    let textures = [color, depth, out];
                    let (frame, last) = frame_passes(b, &mut sky, &scene, Target::color(color), textures);
                    passes.extend(frame);
                    b.run(&passes).unwrap();
                    b.read(last).unwrap()
                });
                for (i, query) in rays(&scene, SIZE).iter().enumerate() {
                    let want = transmittance(&scene.atmosphere, query, Tolerance::PICTURE).unwrap();
                    for c in 0..3 {
                        let through = rgb(&with, i)[c] - rgb(&without, i)[c];
                        let name = format!(
                            "{altitude} m, {pitch}°, scale {render_scale}, {}, channel {c}",
                            settings.quality
                        );
                        assert!((through - want[c]).abs() < 2e-3, "{name}: {through} {}", want[c]);
                    }
                }
                sky.destroy(b);
                free(b, [color, depth, out]);
            }
        }
    });
}

#[test]
fn hand_over_keeps_the_sum() {
    assert_eq!(
        [-5.0, 15e3, 50e3, 1e9].map(|altitude| background_weight(altitude, 1e5)),
        [1.0, 1.0, 0.0, 0.0]
    );
    // Venus' air is deeper, that of a planet of 5 km 125 m deep.
    assert_eq!(hand_over(250e3), HAND_OVER);
    assert_eq!(hand_over(125.0), (18.75, 62.5));
    on_each(|b, settings| {
        let (mut whole, mut behind) = (PictureRenderer::default(), SkyRenderer::new(settings).unwrap());
        let mut last: Option<[f64; 3]> = None;
        for altitude in [14_999.0, 15_001.0, 24e3, 32.5e3, 41e3, 49_999.0, 50_001.0] {
            let scene = View { altitude, pitch: -2.0, fov: 3.0, ..View::default() }.scene();
            let total = mean(&draw(b, &mut whole, &scene, &over_black(settings), [8, 8]));
            // The two passes alone: their weights add up to one.
            let first = mean(&background_by(b, &mut behind, &scene, [8, 8], [0.0; 4]));
            let weight = background_weight(altitude, 1e5);
            assert!(
                (first[1] - weight * total[1]).abs() < 2e-3 * total[1],
                "{altitude}: {first:?} {total:?}"
            );
            if let Some(last) = last.filter(|_| (altitude % 1000.0) == 1.0) {
                assert!(
                    (total[2] / last[2] - 1.0).abs() < 1e-3,
                    "a step at {altitude} m: {last:?} {total:?}"
                );
            }
            last = Some(total);
        }
        whole.destroy(b);
        behind.destroy(b);
    });
}

#[test]
fn half_resolution_looks_like_full_resolution() {
    on_each(|b, full| {
        let half = SkySettings { render_scale: 0.5, ..full };
        let mut renderers = [full, half].map(|settings| SkyRenderer::new(settings).unwrap());
        for size in [[64, 48], [65, 47], [7, 5]] {
            let scene =
                View { pitch: 5.0, aspect: f64::from(size[0]) / f64::from(size[1]), ..View::default() }
                    .scene();
            let clear = [0.0, 0.0, 0.0, 1.0];
            let [f, h] = renderers.each_mut().map(|sky| background_by(b, sky, &scene, size, clear));
            assert_physical(&h, "half resolution");
            for (i, (a, c)) in f.chunks_exact(4).zip(h.chunks_exact(4)).enumerate() {
                assert_eq!(
                    a[1] > 0.0,
                    c[1] > 0.0,
                    "{size:?}: pixel {i} is sky in one and planet in the other"
                );
            }
            if size[0] < 20 {
                continue; // Four texels for 60° resolve no horizon: only the planet's edge is promised.
            }
            let (a, c) = (mean(&f), mean(&h));
            assert!((0..3).all(|k| (a[k] / c[k] - 1.0).abs() < 0.03), "{size:?}: {a:?} {c:?}");
        }
        renderers.iter_mut().for_each(|sky| sky.destroy(b));
    });
}

#[test]
fn extreme_viewports_are_drawn() {
    on_both(|b| {
        for size in [[1, 1], [1, 4096], [4096, 1], [3, 2]] {
            let scene = View {
                pitch: 30.0,
                fov: 1.0,
                aspect: f64::from(size[0]) / f64::from(size[1]),
                ..View::default()
            }
            .scene();
            let method = march(4, 2);
            let p = whole_sky(b, &scene, SkySettings { quality: method, ..Default::default() }, size);
            assert_physical(&p, "viewport");
            assert!(mean(&p)[2] > 0.1, "{size:?} is dark");
        }
    });
}

/// What a user asked to be cleared is cleared also in frames in which no pass draws there: from orbit, with
/// the air before the scene drawing all of it, and where the sky is switched off.
#[test]
fn what_nothing_draws_to_is_cleared_as_asked() {
    let size = [8, 6];
    let high = View { altitude: 4e5, pitch: -20.0, ..View::default() };
    let off = SkySettings { look: Look { enabled: false, ..Look::default() }, ..SkySettings::default() };
    on_both(|b| {
        for (view, settings, with_aerial) in [
            (&high, SkySettings::default(), false),
            (&high, SkySettings::default(), true),
            (&View::default(), off, false),
            (&View::default(), off, true),
        ] {
            let scene = view.scene();
            let textures @ [color, depth, out] = frame_textures(b, size);
            for id in textures {
                b.run(&[clear_pass(id, [7.0; 4])]).unwrap();
            }
            b.run(&[clear_pass(depth, [scene.depth.background() as f32; 4])]).unwrap();
            let asked = |id, clear| Target { clear: Some(clear), ..Target::color(id) };
            let mut targets = FrameTargets::background(asked(color, [0.0, 0.0, 0.0, 1.0]));
            if with_aerial {
                let target = asked(out, [1.0, 2.0, 3.0, 1.0]);
                targets = targets.with_aerial(AerialTargets { color: Some(color), depth, target });
            }
            let mut sky = SkyRenderer::new(settings).unwrap();
            let frame = sky.frame(b, &scene, &targets).unwrap();
            let air = frame.frame.effect("aerial perspective").unwrap().on;
            b.run(&[frame.background, frame.aerial].concat()).unwrap();
            assert_eq!(b.read(color).unwrap(), [0.0, 0.0, 0.0, 1.0].repeat(48), "{view:?} {with_aerial}");
            let stays = if !with_aerial { [7.0; 4] } else { [1.0, 2.0, 3.0, 1.0] };
            if !air {
                assert_eq!(b.read(out).unwrap(), stays.repeat(48), "{view:?} {with_aerial}");
            }
            // Nothing was asked for here.
            let kept = FrameTargets::background(Target::color(color));
            assert!(sky.frame(b, &scene, &kept).unwrap().background.iter().all(|p| p.target.color != color));
            sky.destroy(b);
            free(b, textures);
        }
    });
}

#[test]
fn moving_and_turning_the_world_changes_nothing() {
    on_each(|b, settings| {
        let settings = with_disk(true, settings);
        let base = View { altitude: 500.0, pitch: 10.0, sun_elevation: 5.0, ..View::default() }.scene();
        let mut renderer = PictureRenderer::default();
        let want = draw(b, &mut renderer, &base, &over_black(settings), [12, 12]);
        for center in [DVec3::ZERO, DVec3::splat(1e9), DVec3::new(0.0, -1e12, 1e12)] {
            let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 1.1, -2.0);
            let mut scene = base.clone();
            scene.planet_center = center;
            scene.camera.position = center + turn * base.camera.position;
            scene.camera.forward = turn * base.camera.forward;
            scene.camera.up = turn * base.camera.up;
            scene.sun_direction = turn * base.sun_direction * 3.0;
            let got = draw(b, &mut renderer, &scene, &over_black(settings), [12, 12]);
            // At 1e12 m an f64 metre has 1e-4 m left.
            let worst = got.iter().zip(&want).map(|(a, b)| (a - b).abs() / b.max(1e-2)).fold(0.0, f32::max);
            assert!(worst < 1e-4, "{center}: {worst}");
        }
        renderer.destroy(b);
    });
}

#[test]
fn what_is_off_is_not_there() {
    on_both(|b| {
        let view = View { pitch: 20.0, ..View::default() };
        let target = texture(b, "target", [8, 8], Format::Rgba16Float);
        let live = b.live();
        let mut off = SkyRenderer::new(SkySettings {
            look: Look { enabled: false, ..Look::default() },
            ..SkySettings::default()
        })
        .unwrap();
        assert!(background_passes(b, &mut off, &view.scene(), Target::color(target)).is_empty());
        let empty = View { params: airless(view.params.clone()), ..view.clone() }.scene();
        let mut sky = SkyRenderer::new(without_disk(SkySettings::default())).unwrap();
        assert!(background_passes(b, &mut sky, &empty, Target::color(target)).is_empty());
        assert_eq!(b.live(), live, "something was made for nothing");
        // Without ozone, without the sun: the program is the one without them, and draws what the
        // complete one draws with their coefficients at zero.
        let mut gas = view.scene();
        gas.atmosphere.mie_phase = MiePhase::CornetteShanks;
        gas.atmosphere.ozone_absorption = [0.0; 3];
        let lean = background(b, &gas, FINE, [8, 8], [0.0; 4]);
        gas.atmosphere.ozone_absorption = [0.0, 0.0, 1e-30];
        assert_eq!(background(b, &gas, FINE, [8, 8], [0.0; 4]), lean);
        b.destroy_texture(target);
    });
}

#[test]
fn sun_disk_has_the_suns_irradiance() {
    on_both(|b| {
        // Above the air the disk's mean radiance times its solid angle is the sun's irradiance.
        let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
        let view =
            View { params, altitude: 1e6, pitch: 30.0, fov: 1.0, sun_elevation: 30.0, ..View::default() };
        let settings = SkySettings::default();
        let n = 64;
        let p = background(b, &view.scene(), settings, [n, n], [0.0; 4]);
        let pixel_solid_angle = (2.0 * 0.5_f64.to_radians().tan() / f64::from(n)).powi(2);
        let total = mean(&p)[1] * f64::from(n * n) * pixel_solid_angle;
        assert!((total - 1.0).abs() < 5e-3, "{total}");
        // In 16-bit targets the earth's sun at 22 is cut at half of the largest half float.
        let bright = View { params: AtmosphereParams::earth(), ..view };
        let pixels =
            picture(b, &bright.scene(), &PictureSettings { terrain: None, ..Default::default() }, [16, 16]);
        assert_physical(&pixels, "sun at half float");
        assert!(pixels.iter().copied().fold(0.0, f32::max) > 3e4);
    });
}

/// The disk's radiance over black where there is no air, as its shader defines it.
fn bare_disk(scene: &Scene, size: [u32; 2]) -> Vec<f64> {
    let view = scene.validate().unwrap();
    let p = &scene.atmosphere;
    let chord = 2.0 * (0.5 * p.sun_angular_radius).sin();
    let pixel = 2.0 * view.basis.up.length() / f64::from(size[1]);
    let full = p.sun_intensity / (std::f64::consts::PI * chord * chord);
    let rays = rays(scene, size);
    rays.iter()
        .map(|q| full * ((chord - (q.direction - view.sun).length()) / pixel + 0.5).clamp(0.0, 1.0))
        .collect()
}

#[test]
fn sun_is_drawn_where_it_is_in_either_row_order() {
    let params = AtmosphereParams {
        sun_intensity: 1.0,
        sun_angular_radius: 0.03,
        ..airless(AtmosphereParams::earth())
    };
    let size = [60, 36];
    let view = View { params, altitude: 1e7, sun_elevation: 40.0, aspect: 60.0 / 36.0, ..View::default() };
    // In the middle, at an edge, in a corner, just outside, behind; narrow, and so wide that the disk is
    // drawn out.
    let views =
        [(40.0, 0.0, 60.0), (12.0, 0.0, 60.0), (28.0, 48.0, 50.0), (40.0, 1.6, 1.0), (5.0, 70.0, 150.0)];
    let away = [(40.0, 90.0, 60.0), (-40.0, 180.0, 60.0), (-89.0, 0.0, 170.0)];
    on_both(|b| {
        for (i, (pitch, heading, fov)) in views.into_iter().chain(away).enumerate() {
            let scene = View { pitch, heading, fov, ..view.clone() }.scene();
            let want = bare_disk(&scene, size);
            let shown = want.iter().filter(|v| **v > 0.0).count();
            assert!((i < views.len()) == (shown > 0), "{pitch} {heading} {fov}: {shown} pixels");
            for rows in [RowOrder::TopDown, RowOrder::BottomUp] {
                let desc =
                    TextureDesc { rows, ..TextureDesc::new("target", size[0], size[1], Format::Rgba32Float) };
                let target = b.create_texture(&desc).unwrap();
                let mut sky = SkyRenderer::new(SkySettings::default()).unwrap();
                let passes = background_passes(b, &mut sky, &scene, cleared(target));
                assert!(
                    i < views.len() || passes.iter().all(|p| p.label != "sun") || fov == 170.0,
                    "{heading}"
                );
                let got = if passes.is_empty() {
                    vec![0.0; 4 * want.len()]
                } else {
                    b.run(&passes).unwrap();
                    b.read(target).unwrap()
                };
                for (at, pixel) in got.chunks_exact(4).enumerate() {
                    let (x, y) = (at % size[0] as usize, at / size[0] as usize);
                    let y = if rows == RowOrder::TopDown { y } else { size[1] as usize - 1 - y };
                    let want = want[y * size[0] as usize + x];
                    let off = (f64::from(pixel[0]) - want).abs();
                    assert!(
                        off < 1e-3 * want.max(1.0),
                        "{pitch} {heading} {fov} {rows:?}: {x} {y}: {pixel:?} {want}"
                    );
                }
                b.destroy_texture(target);
            }
        }
    });
}

#[test]
fn sun_is_dimmed_by_the_air_as_in_the_reference() {
    // So dim that disk and sky simply add up.
    let params = AtmosphereParams { sun_intensity: 1e-3, ..AtmosphereParams::earth() };
    let settings = |on| with_disk(on, composed(Composition::SkyDome, SkySettings::default()));
    let mut worst = 0.0_f64;
    on_both(|b| {
        let mut renderers = [true, false].map(|on| SkyRenderer::new(settings(on)).unwrap());
        // From the ground to the horizon, from the stratosphere below it, through the limb from orbit.
        for (altitude, elevation) in
            [(2.0, 60.0), (2.0, 5.0), (2.0, 0.5), (30e3, -4.0), (4e5, -19.0), (4e5, -18.0)]
        {
            let view =
                View { params: params.clone(), altitude, pitch: elevation, fov: 0.02, ..View::default() };
            let scene = View { sun_elevation: elevation, ..view }.scene();
            let [with, without] =
                renderers.each_mut().map(|sky| background_by(b, sky, &scene, [3, 3], [0.0; 4]));
            let full = bare_disk(&scene, [3, 3])[4];
            let through =
                transmittance(&params, &rays(&scene, [3, 3])[4], Tolerance { relative: 1e-8 }).unwrap();
            for c in 0..3 {
                let got = f64::from(with[16 + c]) - f64::from(without[16 + c]);
                let off = (got / full - through[c]).abs();
                worst = worst.max(off / through[c].max(1e-3));
                println!("{altitude} m, sun {elevation}: {} {}", got / full, through[c]);
            }
        }
        renderers.iter_mut().for_each(|sky| sky.destroy(b));
    });
    println!("worst: {worst:.1e} of the transmittance");
    assert!(worst < 5e-4, "{worst}");
}

#[test]
fn passes_are_timed() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let passes = picture_passes(
            b,
            &mut renderer,
            &View::default().scene(),
            &PictureSettings::default(),
            [256, 144],
        );
        let times = b.times(&passes).unwrap();
        println!("{}: {times:?}", b.info());
        assert_eq!(
            times.iter().map(|t| t.label).collect::<Vec<_>>(),
            passes.iter().map(|p| p.label).collect::<Vec<_>>()
        );
        assert!(times.iter().all(|t| t.nanoseconds.is_finite() && t.nanoseconds >= 0.0));
        assert!(times.iter().map(|t| t.nanoseconds).sum::<f64>() > 0.0);
    });
}
