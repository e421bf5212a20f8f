//! Ground below altitude 0, and scenes that lie deeper still: the sky goes on down to the lowest ground, and
//! the air before a scene is there at, above and below eye level.

use welkin::gpu::Backend;
use welkin::reference::multiple::Settings;
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering, transmittance};
use welkin::{AtmosphereParams, LutSettings, Quality, Scene, SkyRenderer, SkySettings};

use crate::harness::{
    View, aerial_passes, background, frame_textures, free, luts, march, on_both, orders, rays, rgb, sky,
    without_disk,
};

/// Radiance that air sends along a ray: of all orders for LUTs, scattered once for a march.
fn expected(scene: &Scene, query: &RayQuery, quality: Quality) -> [f64; 3] {
    let p = &scene.atmosphere;
    if quality.is_single_scattering() {
        return single_scattering(p, query, Sun::Point, Tolerance::PICTURE).unwrap().radiance;
    }
    let light = orders(p, Settings::QUICK).radiance(query, Tolerance::PICTURE).unwrap();
    std::array::from_fn(|c| (light.per_irradiance[c] - light.ground[c]) * p.sun_intensity)
}

/// The largest difference of a channel, in parts of the value.
fn off(got: [f64; 3], right: [f64; 3]) -> f64 {
    (0..3).fold(0.0, |most: f64, c| most.max((got[c] - right[c]).abs() / right[c]))
}

fn earth(lowest_ground: f64) -> AtmosphereParams {
    AtmosphereParams { lowest_ground, ..AtmosphereParams::earth() }
}

/// Where the planet's radius ended the rays there was a black band between the horizon and the land: of 0.3°
/// from 100 m above a shore of the Dead Sea, of 0.1° from above a plain 60 m below the ellipsoid.
#[test]
fn the_sky_goes_on_down_to_the_lowest_ground() {
    const SIZE: [u32; 2] = [2, 120];
    let mars = AtmosphereParams { lowest_ground: -7e3, ..AtmosphereParams::mars() };
    // What the aerosol scatters again is a model, which is far off next to Mars' horizon, wherever its ground
    // is.
    let places = [(earth(-430.0), 0.02), (earth(-60.0), 0.02), (earth(-10.6e3), 0.02), (mars, 0.25)];
    on_both(|b| {
        for (params, most) in &places {
            for (settings, most) in [(luts(LutSettings::default()), *most), (sky(march(64, 32)), 0.01)]
                .map(|(s, m)| (without_disk(s), m))
            {
                let altitude = params.lowest_ground + 100.0;
                let view = View {
                    params: params.clone(),
                    altitude,
                    fov: 1.2,
                    aspect: 1.0 / 60.0,
                    ..View::default()
                };
                let scene = View { heading: 70.0, ..view }.scene();
                let pixels = background(b, &scene, settings, SIZE, [0.0, 0.0, 0.0, 1.0]);
                let radius = params.ground_radius();
                let horizon = -(radius / (radius + 100.0)).acos();
                let (mut below, mut worst) = (0, 0.0_f64);
                for (i, query) in rays(&scene, SIZE).iter().enumerate() {
                    let (got, elevation) = (rgb(&pixels, i), query.direction.z.asin());
                    if (elevation - horizon).abs() < 1e-4 {
                        continue; // Half a pixel.
                    }
                    if elevation < horizon {
                        assert_eq!(got, [0.0; 3], "{elevation}: the ground is the user's");
                        continue;
                    }
                    below += usize::from(elevation < 0.0);
                    worst = worst.max(off(got, expected(&scene, query, settings.quality)));
                }
                let name = format!("{} m, {:?}", params.lowest_ground, settings.quality);
                eprintln!("{name}: {below} pixels below eye level, at most {:.2} % off", worst * 100.0);
                assert!(below >= 50, "{name}: {below} pixels of sky below eye level");
                assert!(worst <= most, "{name}: {worst}");
            }
        }
    });
}

/// What surfaces at distances (metres, one a pixel) show through the air: transmittance and light.
fn through(
    b: &mut dyn Backend,
    settings: SkySettings,
    scene: &Scene,
    size: [u32; 2],
    distances: &[f64],
) -> Vec<[[f64; 3]; 2]> {
    let [color, depth, out] = frame_textures(b, size);
    let stored: Vec<_> = distances.iter().map(|&d| scene.depth.encode(d) as f32).collect();
    b.write_texture(depth, &stored).unwrap();
    let mut renderer = SkyRenderer::new(settings).unwrap();
    let [black, white] = [0.0, 1.0].map(|shade: f32| {
        b.write_texture(color, &vec![shade; 4 * distances.len()]).unwrap();
        let passes = aerial_passes(b, &mut renderer, scene, [color, depth, out]);
        b.run(&passes).unwrap();
        b.read(out).unwrap()
    });
    renderer.destroy(b);
    free(b, [color, depth, out]);
    (0..distances.len())
        .map(|i| {
            let (light, sum) = (rgb(&black, i), rgb(&white, i));
            [std::array::from_fn(|c| sum[c] - light[c]), light]
        })
        .collect()
}

/// A scene 20 km away at eye level had no air before it where the camera stood on altitude 0 or below: the
/// ray ended under its feet. Whether the ground is said to be as low as the scene or not, the air is there.
#[test]
fn haze_is_there_at_and_below_eye_level() {
    const SIZE: [u32; 2] = [2, 24];
    const DISTANCE: f64 = 20e3;
    on_both(|b| {
        for settings in [luts(LutSettings::default()), sky(march(64, 32))].map(without_disk) {
            for altitude in [0.0, -1.0, -430.0, -10.6e3] {
                for lowest_ground in [0.0_f64, altitude] {
                    let params = earth(lowest_ground);
                    let view = View { params, altitude, fov: 0.16, aspect: 1.0 / 12.0, ..View::default() };
                    let scene = View { heading: 70.0, ..view }.scene();
                    let seen = through(b, settings, &scene, SIZE, &[DISTANCE; 48]);
                    let (mut thinnest, mut worst, mut light): (f64, f64, f64) = (1.0, 0.0, 0.0);
                    for (query, [passed, lit]) in rays(&scene, SIZE).iter().zip(seen) {
                        let query = query.ended_at(DISTANCE);
                        let right = transmittance(&scene.atmosphere, &query, Tolerance::PICTURE).unwrap();
                        worst = worst.max(off(passed, right));
                        thinnest = thinnest.min(right[2]);
                        light = light.max(off(lit, expected(&scene, &query, settings.quality)));
                    }
                    let name =
                        format!("camera at {altitude} m, ground {lowest_ground} m, {:?}", settings.quality);
                    eprintln!("{name}: blue {thinnest:.3}, at most {worst:.4} off, light {light:.4}");
                    // Sea level's extinction of blue, 3.755e-5 1/m, over 20 km.
                    assert!((thinnest - 0.472).abs() < 0.002, "{name}: {thinnest}");
                    assert!(worst <= 0.01, "{name}: {worst}");
                    // Most red light is the aerosol's, and what that scatters again is a model.
                    assert!(light <= 0.035, "{name}: {light}");
                }
            }
        }
    });
}

/// A scene that is deeper than the ground takes the air before it along without a step: from the ground's own
/// distance on, and over the horizon.
#[test]
fn air_before_a_scene_grows_evenly_through_the_ground() {
    const STEPS: usize = 41;
    let shares: [f64; STEPS] = std::array::from_fn(|i| 0.9 + 0.005 * i as f64);
    // Next to the same ray for all of them.
    let view = View { fov: 1e-4, aspect: STEPS as f64, ..View::default() };
    on_both(|b| {
        for settings in [luts(LutSettings::default()), sky(march(64, 32))].map(without_disk) {
            for (altitude, pitch) in [(2.0, -0.01), (300.0, -0.6), (300.0, -5.0), (12e3, -20.0), (3e5, -40.0)]
            {
                let scene = View { altitude, pitch, ..view.clone() }.scene();
                let rays = rays(&scene, [STEPS as u32, 1]);
                let p = &scene.atmosphere;
                let down = rays[STEPS / 2].direction.z;
                let ground = {
                    let r = p.planet_radius + altitude;
                    let half = (p.planet_radius.powi(2) - r * r * (1.0 - down * down)).max(0.0).sqrt();
                    -r * down - half
                };
                // The gas' density at the end of half a percent of the way, over that at its begin.
                let denser = (-0.005 * ground * down / p.rayleigh_scale_height).exp();
                let ends = shares.map(|share| share * ground);
                let seen = through(b, settings, &scene, [STEPS as u32, 1], &ends);
                let passed =
                    |i: usize, end| transmittance(p, &rays[i].ended_at(end), Tolerance::PICTURE).unwrap();
                for i in 0..STEPS {
                    let name = format!("{altitude} m, {pitch}°, {} of the ground's distance", shares[i]);
                    let ([now, light], right) = (seen[i], passed(i, ends[i]));
                    // Deeper than the ground air is as dense as on it. The raised ray tells a little less,
                    // from high up no more than down to the ground.
                    let most = 0.005 + 0.8 * (shares[i] - 1.0).max(0.0);
                    assert!(altitude > 2e4 || off(now, right) <= most, "{name}: {now:?} {right:?}");
                    let least = passed(i, ends[i].min(ground));
                    for c in 0..3 {
                        let between = 0.995 * right[c]..=1.005 * least[c];
                        assert!(between.contains(&now[c]), "{name}: {now:?}, {between:?}");
                    }
                    let Some([before, light_before]) = i.checked_sub(1).map(|i| seen[i]) else { continue };
                    for c in 0..3 {
                        // Half a percent of the way takes at most so much of the light, unless it is long, or
                        // leads into denser air.
                        let depth = -now[c].ln();
                        let step =
                            (0.01 * (1.0 + depth) + (denser - 1.0) * depth) * before[c].max(1e-3) + 2e-4;
                        let less = before[c] - now[c];
                        assert!((-1e-3..=step).contains(&less), "{name}: {before:?} to {now:?}");
                        let more = light[c] - light_before[c];
                        let most = (denser - 0.98) * light[c] + 2e-4;
                        assert!(
                            more >= -2e-2 * light[c] && more <= most,
                            "{name}: {light_before:?} to {light:?}"
                        );
                    }
                }
            }
        }
    });
}
