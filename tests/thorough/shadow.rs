//! Light in the air under the moon's shadow: once scattered, of all orders, and on the planet from orbit.

use glam::DVec3;
use welkin::gpu::Backend;
use welkin::model::moon::{MOON_RADIUS, Moon};
use welkin::reference::path::{Settings, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{
    AtmosphereParams, Composition, LutSettings, PictureRenderer, PictureSettings, Quality, Scene,
    SkyRenderer, SkySettings, TerrainStyle,
};

use crate::eclipse::{DISTANCE, moon};
use crate::harness::{
    View, aerial_passes, background_passes, cleared, composed, draw, everything, frame_textures, free, luts,
    march, on_both, rgb, sky,
};

/// A scene as [`View`] has it with the moon of a [`RayQuery`], whose azimuth turns the other way.
fn under(moon: &Moon, view: View) -> Scene {
    let mut scene = view.scene();
    scene.moon = Some(Moon { position: scene.camera.position + moon.position, ..*moon });
    scene
}

/// What the first pixel of the air's passes has: the background alone, or the air before a scene at a
/// distance.
fn air(b: &mut dyn Backend, scene: &Scene, sky: SkySettings, distance: Option<f64>) -> [f64; 3] {
    let [color, depth, out] = frame_textures(b, [1, 1]);
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let mut passes = background_passes(b, &mut renderer, scene, cleared(color));
    let mut from = color;
    if sky.look.composition == Composition::Full {
        if distance.is_some() {
            // Of the sky nothing is seen.
            passes.clear();
            b.write_texture(color, &[0.0, 0.0, 0.0, 1.0]).unwrap();
        }
        let stored = distance.map_or(scene.depth.background(), |z| scene.depth.encode(z)) as f32;
        b.write_texture(depth, &[stored]).unwrap();
        passes.extend(aerial_passes(b, &mut renderer, scene, [color, depth, out]));
        from = out;
    }
    assert!(
        passes.iter().any(|p| ["background sky", "aerial perspective"].contains(&p.label)),
        "nothing is drawn"
    );
    b.run(&passes).unwrap();
    let pixel = b.read(from).unwrap();
    renderer.destroy(b);
    free(b, [color, out, depth]);
    rgb(&pixel, 0)
}

/// Light scattered once under the shadow, against the reference: from the ground, from orbit, and before a
/// scene.
#[test]
fn light_scattered_once_under_a_shadow() {
    let p = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
    let sky = sky(march(200, 40));
    // Altitude, zenith angle and azimuth from the sun (degrees), distance of a scene.
    let rays = [
        (2.0, 10.0, 30.0, None),
        (2.0, 80.0, 90.0, None),
        (2.0, 88.0, 180.0, None),
        (2.0, 89.0, 40.0, Some(3e4)),
        (4e5, 112.0, 60.0, None),
        (4e5, 165.0, 60.0, None),
        (1.2e7, 169.0, 178.0, None),
        (1.2e7, 172.0, 120.0, None),
    ];
    on_both(|b| {
        let mut worst = 0.0_f64;
        for (altitude, zenith, azimuth, distance) in rays {
            for apart in [0.0, 0.3, 0.9, 1.7] {
                let [z, a] = [zenith, azimuth].map(f64::to_radians);
                // From afar so that the shadow behind the camera falls on the planet.
                let sun: f64 = if altitude > 1e6 { 0.2 } else { 0.6 };
                let query = RayQuery::new(altitude, z, sun, a);
                let moon = moon(&query, 1.05, apart, DVec3::Y, DISTANCE);
                let query = distance.map_or(query, |end| query.ended_at(end)).eclipsed_by(moon);
                let want =
                    single_scattering(&p, &query, Sun::Point, Tolerance::PICTURE).unwrap().per_irradiance;
                let view = View {
                    params: p.clone(),
                    altitude,
                    pitch: 90.0 - zenith,
                    heading: -azimuth,
                    fov: 0.01,
                    sun_elevation: 90.0 - sun.to_degrees(),
                    aspect: 1.0,
                };
                let got = air(b, &under(&moon, view), sky, distance);
                let top = want.into_iter().fold(0.0, f64::max);
                for c in 0..3 {
                    worst = worst.max((got[c] - want[c]).abs() / want[c].max(0.01 * top));
                }
            }
        }
        println!("{}: light scattered once under a shadow: off by {worst:.4} at most", b.info().backend);
        assert!(worst < 2e-3, "{worst}");
    });
}

/// Light of all orders under the shadow, against path tracing. From the middle of the umbra outwards.
#[test]
fn light_of_all_orders_under_a_shadow() {
    let p = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
    let sky = composed(Composition::SkyDome, luts(LutSettings::MEDIUM));
    // Distance of the disks' middles as seen from the camera in sun radii (0.0566 is the umbra's edge), and
    // by which factor light may be off: what is scattered more often is an estimate.
    let places = [(0.0, 2.0), (0.04, 2.4), (0.1, 1.6), (0.5, 1.04), (1.0, 1.02)];
    // Zenith angle and azimuth from the sun, degrees.
    let mut rays = vec![(0.0_f64, 0.0_f64), (80.0, 90.0)];
    if everything() {
        rays.extend([(45.0, 90.0), (45.0, 180.0), (88.0, 180.0)]);
    }
    let elevation: f64 = 60.0;
    let mut wanted = Vec::new();
    for (apart, _) in places {
        for &(zenith, azimuth) in &rays {
            let query = RayQuery::new(
                2.0,
                zenith.to_radians(),
                (90.0 - elevation).to_radians(),
                azimuth.to_radians(),
            );
            let moon = moon(&query, 1.0566, apart, DVec3::Y, DISTANCE);
            let paths = if apart < 0.2 { 60_000 } else { 20_000 };
            wanted.push((
                moon,
                path_trace(&p, &query.eclipsed_by(moon), Settings { paths, seed: 11 }).unwrap(),
            ));
        }
    }
    on_both(|b| {
        println!("{}: apart, zenith angle, azimuth: light, ours over it, its own noise", b.info().backend);
        let mut at = wanted.iter();
        for (apart, allowed) in places {
            for &(zenith, azimuth) in &rays {
                let (moon, all) = at.next().unwrap();
                let view = View {
                    params: p.clone(),
                    altitude: 2.0,
                    pitch: 90.0 - zenith,
                    heading: -azimuth,
                    fov: 0.01,
                    sun_elevation: elevation,
                    aspect: 1.0,
                };
                let got = air(b, &under(moon, view), sky, None);
                let want = all.per_irradiance;
                let ratio: [f64; 3] = std::array::from_fn(|c| got[c] / want[c]);
                let noise: [f64; 3] = std::array::from_fn(|c| all.std_err[c] / want[c]);
                let short = |v: [f64; 3], digits: usize| v.map(|v| format!("{v:.digits$}")).join(" ");
                let light = want.map(|v| format!("{v:.2e}")).join(" ");
                println!(
                    "{apart:4} {zenith:2}° {azimuth:3}°  {light}  {}  {}",
                    short(ratio, 2),
                    short(noise, 3)
                );
                for c in 0..3 {
                    let room = allowed * (1.0 + 4.0 * noise[c]);
                    assert!(
                        ratio[c] < room && ratio[c] > 1.0 / room,
                        "{apart} {zenith} {azimuth}: {ratio:?}"
                    );
                }
            }
        }
    });
}

/// The ground and the air under the shadow from orbit: dark in the umbra, and as without a moon where it does
/// not reach.
#[test]
fn the_umbra_is_on_the_planet_and_nowhere_else() {
    let size = [48, 48];
    let view = View {
        altitude: 1.2e7,
        pitch: -90.0,
        fov: 44.0,
        sun_elevation: 70.0,
        aspect: 1.0,
        ..View::default()
    };
    let clear = view.scene();
    let sun = clear.sun_direction;
    let planet = |b: &mut dyn Backend, scene: &Scene, method| {
        let (sky, terrain) = (sky(method), Some(TerrainStyle::earth()));
        let settings = PictureSettings { sky, terrain, dither: false, ..PictureSettings::default() };
        let mut renderer = PictureRenderer::default();
        let pixels = draw(b, &mut renderer, scene, &settings, size);
        let on = renderer.last_frame().unwrap().effect("eclipse").unwrap().on;
        renderer.destroy(b);
        (pixels, on)
    };
    let moon_at = |point: DVec3| Moon::new(point + sun * 3.6e8, MOON_RADIUS * 1.02);
    let ground = clear.planet_center + DVec3::Z * clear.atmosphere.planet_radius;
    on_both(|b| {
        for method in [Quality::Luts(LutSettings::LOW), march(24, 8)] {
            let (bright, on) = planet(b, &clear, method);
            assert!(!on);
            let (dark, on) = planet(b, &Scene { moon: Some(moon_at(ground)), ..clear.clone() }, method);
            assert!(on);
            let brightness = |pixels: &[f32], x: usize, y: usize| pixels[4 * (48 * y + x) + 1];
            let share = |x, y| brightness(&dark, x, y) / brightness(&bright, x, y);
            let umbra = (22..26).map(|i| share(i, 24)).fold(1.0, f32::min);
            println!("{} {}: {umbra:.4} of the light in the umbra", b.info().backend, method.method());
            assert!(umbra < 0.1, "{umbra}");
            // Darker towards the middle, and hardly at the limb.
            let row: Vec<_> = (24..44).map(|x| share(x, 24)).collect();
            assert!(row.iter().all(|s| *s < 1.01) && row[15] > 0.9 && row[6] > 2.0 * row[1], "{row:?}");
            // Beside the planet: no eclipse, and not a bit of a pixel is another.
            let beside = moon_at(ground + sun.any_orthonormal_vector() * 1.2e7);
            let (missed, on) = planet(b, &Scene { moon: Some(beside), ..clear.clone() }, method);
            assert!(!on && missed == bright);
            // Behind the planet: nothing hides the sun.
            let behind = Moon::new(ground - sun * 3.6e8, MOON_RADIUS);
            let (missed, on) = planet(b, &Scene { moon: Some(behind), ..clear.clone() }, method);
            assert!(!on && missed == bright);
        }
    });
}
