//! Planets that are ellipsoids: horizon and limb where they are, light and air as right as the stretched
//! frame promises, and no LUT made anew because the camera moves.

use glam::{DMat3, DVec2, DVec3};
use welkin::{
    AtmosphereParams, Camera, DepthConvention, Ellipsoid, LutSettings, PictureRenderer, PictureSettings,
    Scene, SkyRenderer, SkySettings, TerrainStyle,
};

use crate::harness::{
    aerial_passes, background, background_passes, cleared, frame_textures, free, luts, march, on_both,
    over_black, rgb, sky, target, without_disk,
};

const WGS84: Ellipsoid = Ellipsoid::WGS84;
const SIZE: [u32; 2] = [4, 96];

/// A camera above a place of WGS84 (degrees, metres) that looks north, `pitch` degrees above the horizontal.
fn scene(latitude: f64, height: f64, pitch: f64, fov: f64, [w, h]: [u32; 2]) -> Scene {
    let (latitude, pitch) = (latitude.to_radians(), pitch.to_radians());
    let up = WGS84.up(latitude, 0.5);
    let north = (DVec3::Z - up * up.z).normalize();
    let forward = north * pitch.cos() + up * pitch.sin();
    let head = up * pitch.cos() - north * pitch.sin();
    let position = WGS84.position(latitude, 0.5, height);
    let aspect = f64::from(w) / f64::from(h);
    Scene {
        camera: Camera::new(position, forward, head, fov.to_radians(), aspect),
        planet_center: DVec3::ZERO,
        atmosphere: AtmosphereParams::earth(),
        // 30° high, from the side.
        sun_direction: up * 0.5 + north.cross(up) * 0.75_f64.sqrt(),
        depth: DepthConvention::default(),
        moon: None,
        ellipsoid: Some(WGS84),
    }
}

/// Rays of the pixels in the scene's frame, unit.
fn rays(scene: &Scene, [w, h]: [u32; 2]) -> Vec<DVec3> {
    let basis = scene.camera.basis().unwrap();
    let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    (0..w * h).map(|i| basis.ray(DVec2::new(share(i % w, w), -share(i / w, h))).normalize()).collect()
}

/// Distances along a ray at which it enters and leaves an ellipsoid that is so many metres larger all around
/// (next to it: half axes by as much).
fn crossing(from: DVec3, ray: DVec3, more: f64) -> Option<[f64; 2]> {
    let inverse = 1.0 / (WGS84.radii + more);
    let (p, d) = (from * inverse, ray * inverse);
    let (a, b, c) = (d.length_squared(), p.dot(d), p.length_squared() - 1.0);
    let square = b * b - a * c;
    (square > 0.0).then(|| [(-b - square.sqrt()) / a, (-b + square.sqrt()) / a])
}

/// Light scattered once (per irradiance) and transmittance up to a distance, in air whose altitudes are
/// heights above WGS84, by brute force: relative error some 1e-3.
fn brute(scene: &Scene, ray: DVec3, until: f64) -> [[f64; 3]; 2] {
    let p = &scene.atmosphere;
    let from = scene.camera.position;
    let sun = scene.sun_direction.normalize();
    let Some([begin, mut end]) = crossing(from, ray, p.thickness()) else { return [[0.0; 3], [1.0; 3]] };
    if let Some([ground, _]) = crossing(from, ray, 0.0).filter(|[ground, _]| *ground > 0.0) {
        end = end.min(ground);
    }
    let (begin, end) = (begin.max(0.0), end.min(until));
    let path =
        |from: DVec3, ray: DVec3, begin: f64, end: f64, steps: u32, f: &mut dyn FnMut(DVec3, f64, f64)| {
            // Even in the root of the distance from the lowest point.
            let lowest = (-from.dot(ray)).clamp(begin, end);
            let at = |u: f64| lowest + u * u.abs();
            let (a, b) = (-(lowest - begin).sqrt(), (end - lowest).sqrt());
            for i in 0..steps {
                let u = |share: f64| a + (b - a) * (f64::from(i) + share) / f64::from(steps);
                let step = at(u(1.0)) - at(u(0.0));
                let point = from + ray * at(u(0.5));
                f(point, WGS84.height(point).max(0.0), step);
            }
        };
    let mut depth = [0.0; 3];
    let mut light = [0.0; 3];
    let cosine = ray.dot(sun);
    path(from, ray, begin, end, 300, &mut |point, h, step| {
        let extinction = p.extinction(h);
        let mut toward = [f64::INFINITY; 3];
        if crossing(point, sun, 0.0).is_none_or(|[a, _]| a < 0.0) {
            let [_, far] = crossing(point, sun, p.thickness()).unwrap();
            toward = [0.0; 3];
            path(point, sun, 0.0, far, 60, &mut |_, h, step| {
                let extinction = p.extinction(h);
                (0..3).for_each(|c| toward[c] += extinction[c] * step);
            });
        }
        let [gas, aerosol, _] = p.densities(h);
        for c in 0..3 {
            let source = p.rayleigh_scattering[c] * gas * welkin::model::phase::rayleigh(cosine)
                + p.mie_scattering[c]
                    * aerosol
                    * welkin::model::phase::mie(p.mie_phase, cosine, p.mie_asymmetry[c]);
            let tau = extinction[c] * step;
            light[c] += (-depth[c] - toward[c]).exp() * source * (1.0 - (-tau).exp()) / extinction[c];
            depth[c] += tau;
        }
    });
    [light, depth.map(|tau| (-tau).exp())]
}

/// Horizon and limb are the ellipsoid's, to the pixel, and light is as right as promised: at the ground, from
/// 400 km and from 36,000 km, at four latitudes.
#[test]
fn horizon_and_limb_are_the_ellipsoids() {
    on_both(|b| {
        // Heights are off by up to 0.34 %, at 60 km by 200 m, over which air thins by 2.5 %.
        for (height, fov, most) in [(2.0, 0.5, 0.003), (4e5, 4.0, 0.03), (3.6e7, 0.8, 0.03)] {
            let mut worst = 0.0_f64;
            for latitude in [0.0, 30.0, 45.0, 85.0] {
                // The picture's middle is at the horizon, by bisection.
                let looks = |pitch: f64| {
                    let ray = scene(latitude, height, pitch, fov, SIZE).camera.forward;
                    crossing(WGS84.position(f64::to_radians(latitude), 0.5, height), ray, 0.0)
                };
                let (mut low, mut high) = (-89.0, 30.0);
                for _ in 0..60 {
                    let pitch = 0.5 * (low + high);
                    if looks(pitch).is_some_and(|[a, _]| a > 0.0) { low = pitch } else { high = pitch }
                }
                let scene = scene(latitude, height, low, fov, SIZE);
                let settings = without_disk(sky(march(128, 64)));
                let settings = SkySettings { bound: None, ..settings };
                let [color, depth, out] = frame_textures(b, SIZE);
                b.write_texture(depth, &[scene.depth.background() as f32; 4 * 96]).unwrap();
                let mut renderer = SkyRenderer::new(settings).unwrap();
                let mut passes = background_passes(b, &mut renderer, &scene, cleared(color));
                if height > 5e4 {
                    passes.extend(aerial_passes(b, &mut renderer, &scene, [color, depth, out]));
                }
                b.run(&passes).unwrap();
                let last = passes.last().unwrap().target.color;
                let pixels = b.read(last).unwrap();
                let below = scene.camera.basis().unwrap().up.length() * 2.0 / f64::from(SIZE[1]);
                for (i, ray) in rays(&scene, SIZE).iter().enumerate() {
                    let row = i / SIZE[0] as usize;
                    let off_horizon = (row as f64 + 0.5 - 0.5 * f64::from(SIZE[1])).abs() * below;
                    // From above the air before the ground is drawn too.
                    if height < 5e4 {
                        let hit = crossing(scene.camera.position, *ray, 0.0).is_some_and(|[a, _]| a > 0.0);
                        let dark = rgb(&pixels, i) == [0.0; 3];
                        assert!(hit == dark || off_horizon < below, "{latitude}°, {height} m, row {row}");
                    }
                    if row % 8 != 4 || i % SIZE[0] as usize != 1 || off_horizon < below {
                        continue;
                    }
                    let [light, _] = brute(&scene, *ray, f64::INFINITY);
                    for c in 0..3 {
                        let want = light[c] * scene.atmosphere.sun_intensity;
                        let ground = height < 5e4 && rgb(&pixels, i) == [0.0; 3];
                        if want > 1e-3 && !ground {
                            worst = worst.max((rgb(&pixels, i)[c] / want - 1.0).abs());
                        }
                    }
                }
                renderer.destroy(b);
                free(b, [color, depth, out]);
            }
            println!("{} from {height} m: light off by {worst:.4} at most", b.info().backend);
            assert!(worst > 0.0 && worst <= most, "{height} m: {worst}");
        }
    });
}

/// Air before a scene: its distance is the scene's own, not the stretched frame's.
#[test]
fn air_before_a_scene_is_as_long_as_the_scene_says() {
    const PIXELS: [u32; 2] = [2, 2];
    on_both(|b| {
        for settings in [luts(LutSettings::default()), sky(march(64, 32))].map(without_disk) {
            for latitude in [0.0, 50.0, 90.0] {
                let scene = scene(latitude, 300.0, 0.0, 0.01, PIXELS);
                let [color, depth, out] = frame_textures(b, PIXELS);
                b.write_texture(depth, &[scene.depth.encode(20e3) as f32; 4]).unwrap();
                let mut renderer = SkyRenderer::new(settings).unwrap();
                let [black, white] = [0.0, 1.0].map(|shade: f32| {
                    b.write_texture(color, &[shade; 16]).unwrap();
                    let passes = aerial_passes(b, &mut renderer, &scene, [color, depth, out]);
                    b.run(&passes).unwrap();
                    b.read(out).unwrap()
                });
                let [_, want] = brute(&scene, rays(&scene, PIXELS)[0], 20e3);
                for c in 0..3 {
                    let got = rgb(&white, 0)[c] - rgb(&black, 0)[c];
                    assert!((got / want[c] - 1.0).abs() < 4e-3, "{latitude}°: {got} {}", want[c]);
                }
                renderer.destroy(b);
                free(b, [color, depth, out]);
            }
        }
    });
}

/// Moving the camera makes no LUT of the medium anew, and turning the planet's axes with everything else
/// changes nothing.
#[test]
fn only_the_view_is_new_where_the_camera_moves() {
    on_both(|b| {
        let settings = without_disk(luts(LutSettings::default()));
        let mut renderer = SkyRenderer::new(settings).unwrap();
        let color = target(b, SIZE);
        for (i, latitude) in [10.0, 20.0, 70.0].into_iter().enumerate() {
            let scene = scene(latitude, 100.0, 5.0, 10.0, SIZE);
            let passes = background_passes(b, &mut renderer, &scene, cleared(color));
            let medium = passes
                .iter()
                .filter(|p| ["transmittance LUT", "multi-scattering LUT"].contains(&p.label))
                .count();
            assert_eq!(medium == 0, i > 0, "{latitude}°");
            b.run(&passes).unwrap();
        }
        renderer.destroy(b);
        b.destroy_texture(color);
        let plain = scene(40.0, 500.0, 5.0, 20.0, SIZE);
        let turn = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(-1.1);
        let turned = Scene {
            camera: Camera {
                position: turn * plain.camera.position,
                forward: turn * plain.camera.forward,
                up: turn * plain.camera.up,
                ..plain.camera
            },
            sun_direction: turn * plain.sun_direction,
            ellipsoid: Some(WGS84.turned(turn)),
            ..plain.clone()
        };
        let [plain, turned] =
            [plain, turned].map(|s| background(b, &s, settings, SIZE, [0.0, 0.0, 0.0, 1.0]));
        for (a, b) in plain.iter().zip(&turned) {
            assert!((a - b).abs() <= 1e-4 * a.abs().max(1e-3), "{a} {b}");
        }
    });
}

/// A sun on the level horizon of a place on the ground is on the sky's.
#[test]
fn the_sun_sets_on_the_level_horizon() {
    for latitude in [0.0, 30.0, 45.0, 89.0] {
        let mut scene = scene(latitude, 0.0, 0.0, 10.0, SIZE);
        let up = WGS84.up(f64::to_radians(latitude), 0.5);
        let east = DVec3::Z.cross(up).normalize();
        for azimuth in [0.0_f64, 1.0, 2.0, 3.0] {
            scene.sun_direction = east * azimuth.cos() + up.cross(east) * azimuth.sin();
            let sine = scene.validate().unwrap().sun.z;
            assert!(sine.abs() < 1e-9, "{latitude}°, {azimuth}: {sine}");
        }
    }
}

/// A shape that is none, and the demonstration's ground on one, are errors.
#[test]
fn what_cannot_be_is_refused() {
    on_both(|b| {
        let good = scene(40.0, 500.0, 5.0, 20.0, SIZE);
        let flat = Ellipsoid { radii: DVec3::new(6e6, 6e6, 1e6), ..WGS84 };
        let bad = Scene { ellipsoid: Some(flat), ..good.clone() };
        let error = bad.validate().unwrap_err().to_string();
        assert!(error.contains("ellipsoid.radii") && error.contains("1.25"), "{error}");
        let mut picture = PictureRenderer::default();
        let settings =
            PictureSettings { terrain: Some(TerrainStyle::earth()), ..over_black(SkySettings::default()) };
        let error = picture.draw(b, &good, &settings, SIZE).unwrap_err().to_string();
        assert!(error.contains("scene.ellipsoid") && error.contains("terrain"), "{error}");
        picture.destroy(b);
    });
}
