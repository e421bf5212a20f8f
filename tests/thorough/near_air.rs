//! The air before a near scene, against the f64 reference: transmittance and light from a metre to the
//! horizon, in Earth's air, in Mars' dust and in thick haze.

use glam::DVec3;
use welkin::gpu::Backend;
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{RayQuery, Tolerance, transmittance};
use welkin::{AtmosphereParams, LutSettings, Scene, SkyRenderer};

use crate::harness::{
    View, aerial_passes, everything, frame_textures, free, luts, on_both, orders, query, rgb, without_disk,
};

/// Rays of one picture, and pictures of one medium.
const SIZE: [u32; 2] = [1, 10];

/// Numbers from 0 to 1 that fill it evenly: the golden ratio's multiples and relatives of them (Roberts
/// 2018).
struct Even(u32);

impl Even {
    fn next(&self, dimension: usize) -> f64 {
        const RATIOS: [f64; 4] = [
            0.856_674_883_854_502_9,
            0.733_891_856_627_126,
            0.628_706_721_037_808_3,
            0.538_597_257_223_611_6,
        ];
        (0.5 + RATIOS[dimension] * f64::from(self.0)).fract()
    }
}

/// What air makes of black and of white a distance away: light and transmittance.
fn air(b: &mut dyn Backend, sky: &mut SkyRenderer, scene: &Scene, depth: f64) -> Vec<[[f64; 3]; 2]> {
    let [color, texels, out] = frame_textures(b, SIZE);
    let count = (SIZE[0] * SIZE[1]) as usize;
    b.write_texture(texels, &vec![scene.depth.encode(depth) as f32; count]).unwrap();
    let [black, white] = [0.0, 1.0].map(|shade: f32| {
        b.write_texture(color, &vec![shade; 4 * count]).unwrap();
        let passes = aerial_passes(b, sky, scene, [color, texels, out]);
        b.run(&passes).unwrap();
        b.read(out).unwrap()
    });
    free(b, [color, texels, out]);
    let pixel = |i| {
        let (light, sum) = (rgb(&black, i), rgb(&white, i));
        [light, std::array::from_fn(|c| sum[c] - light[c])]
    };
    (0..count).map(pixel).collect()
}

/// Radiance of the air along a ray, without what the ground reflects.
fn light_of(orders: &Orders, p: &AtmosphereParams, query: &RayQuery) -> [f64; 3] {
    let light = orders.radiance(query, Tolerance::PICTURE).unwrap();
    std::array::from_fn(|c| (light.per_irradiance[c] - light.ground[c]) * p.sun_intensity)
}

/// A sorted list's mean, its 95th percentile and its last.
fn summary(errors: &mut [f64]) -> [f64; 3] {
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    [mean, errors[errors.len() * 95 / 100], errors[errors.len() - 1]]
}

fn haze() -> AtmosphereParams {
    let earth = AtmosphereParams::earth();
    AtmosphereParams {
        mie_scattering: earth.mie_scattering.map(|v| v * 400.0),
        mie_absorption: earth.mie_absorption.map(|v| v * 400.0),
        mie_asymmetry: [0.7; 3],
        ..earth
    }
}

/// Half of the rays lie within a degree of the horizon.
#[test]
fn air_before_a_near_scene_is_right_next_to_the_horizon_too() {
    let media = [("Earth", AtmosphereParams::earth()), ("Mars", AtmosphereParams::mars()), ("haze", haze())];
    let pictures = if everything() { 200 } else { 24 };
    on_both(|b| {
        for (name, params) in &media {
            let orders = (*name == "Earth").then(|| orders(params, Settings::QUICK));
            let mut sky = SkyRenderer::new(without_disk(luts(LutSettings::default()))).unwrap();
            let finest = LutSettings { aerial: [16, 64, 48], ..LutSettings::default() };
            let mut fine_sky = SkyRenderer::new(without_disk(luts(finest))).unwrap();
            let (mut passed, mut lit) = (Vec::new(), Vec::new());
            let mut worst = (0.0, String::new());
            for picture in 0..pictures {
                let even = Even(picture);
                let altitude = 2.0 * 5e3_f64.powf(even.next(0));
                let distance = 1e2 * 1e3_f64.powf(even.next(1));
                let dip = (params.planet_radius / (params.planet_radius + altitude)).acos().to_degrees();
                let spread = if picture % 2 == 0 { 2.0 } else { 60.0 };
                let view = View {
                    params: params.clone(),
                    altitude,
                    pitch: -dip,
                    heading: 180.0 * even.next(2),
                    fov: spread,
                    sun_elevation: 3.0 + 60.0 * even.next(3),
                    aspect: 0.1,
                };
                let scene = view.scene();
                let near = air(b, &mut sky, &scene, distance);
                // Of dust and of haze the model of light that is scattered again is rough; how it is shared
                // out along a ray is not.
                let fine = (*name != "Earth").then(|| air(b, &mut fine_sky, &scene, distance));
                for i in 0..near.len() {
                    let ray = query(&scene, SIZE, i);
                    let along = distance / ray.direction.dot(forward(&scene));
                    // Nothing stands behind the ground.
                    let (r, mu) = (params.planet_radius + altitude, ray.direction.z);
                    let half2 = params.planet_radius.powi(2) - r * r * (1.0 - mu * mu);
                    if mu < 0.0 && half2 > 0.0 && along > -r * mu - half2.sqrt() {
                        continue;
                    }
                    let ended = ray.ended_at(along);
                    let right = transmittance(params, &ended, Tolerance::PICTURE).unwrap();
                    let part = match &fine {
                        Some(fine) => fine[i][0],
                        None => light_of(orders.as_ref().unwrap(), params, &ended),
                    };
                    let [light, through] = near[i];
                    for c in 0..3 {
                        passed.push((through[c] - right[c]).abs());
                        let off = (light[c] / part[c] - 1.0).abs();
                        if off > worst.0 {
                            let elevation = ray.direction.z.asin().to_degrees();
                            let what = format!(
                                "{altitude:.0} m, {elevation:.3} deg, {along:.0} m, channel {c}: {} of {}",
                                light[c], part[c]
                            );
                            worst = (off, what);
                        }
                        lit.push(off);
                    }
                }
            }
            let (passed, lit) = (summary(&mut passed), summary(&mut lit));
            eprintln!("{name}: transmittance off by {passed:.4?}, light by {lit:.4?} (mean, 95th, most)");
            eprintln!("    {worst:?}");
            assert!(passed[1] <= 0.01, "{name}: {passed:?}");
            assert!(lit[1] <= 0.03, "{name}: {lit:?}");
            sky.destroy(b);
            fine_sky.destroy(b);
        }
    });
}

/// The camera's axis in the zenith frame.
fn forward(scene: &Scene) -> DVec3 {
    scene.validate().unwrap().basis.forward.normalize()
}
