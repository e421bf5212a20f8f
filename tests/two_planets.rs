//! Two planets in one picture, as the example has it: the far one first.

use glam::{DVec2, DVec3};
use welkin::reference::geometry::RayEnd;
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{Scene, SkyRenderer, SkySettings};

use crate::harness::{free, march, on_both, rgb, sky, without_disk};

#[path = "../examples/two_planets.rs"]
mod example;

const SIZE: [u32; 2] = [24, 24];
/// Radiance of both grounds.
const GROUND: f32 = 0.3;

/// What a planet does to what is behind it along a ray: light that is added, its ground's among it, and
/// transmittance.
fn alone(scene: &Scene, ray: DVec3) -> [[f64; 3]; 2] {
    let p = &scene.atmosphere;
    let position = scene.camera.position - scene.planet_center;
    let query = RayQuery::in_world(position, ray, scene.sun_direction.normalize(), p.planet_radius).unwrap();
    let light = single_scattering(p, &query, Sun::Point, Tolerance::PICTURE).unwrap();
    if light.ends_at != RayEnd::Ground {
        return [light.radiance, light.transmittance];
    }
    [std::array::from_fn(|c| light.radiance[c] + light.transmittance[c] * f64::from(GROUND)), [0.0; 3]]
}

/// From the ground, where the near planet's sky is drawn before its ground, and from orbit, where its limb is
/// drawn over everything: each pixel is the near planet's light over what its air lets through of the far
/// one's.
#[test]
fn a_far_planet_is_seen_through_the_air_of_a_near_one() {
    on_both(|b| {
        for (altitude, pitch, fov) in [(2.0, 3.0, 16.0), (3e4, 0.0, 16.0), (4e5, -18.5, 16.0)] {
            let settings = SkySettings { bound: None, ..without_disk(sky(march(128, 64))) };
            let scenes = example::scenes(altitude, pitch, fov);
            let mut skies = [SkyRenderer::new(settings).unwrap(), SkyRenderer::new(settings).unwrap()];
            let textures = [(); 2].map(|()| example::Textures::new(b, SIZE).unwrap());
            let [far, near] = &textures;
            let seen = example::both(b, &mut skies, &scenes, [far, near], SIZE, GROUND).unwrap();
            let pixels = b.read(seen).unwrap();
            let basis = scenes[1].camera.basis().unwrap();
            let share = |i: usize, n: u32| (i as f64 + 0.5) / f64::from(n) * 2.0 - 1.0;
            let [mut through, mut worst] = [0, 0].map(f64::from);
            for i in 0..(SIZE[0] * SIZE[1]) as usize {
                let (x, y) = (i % SIZE[0] as usize, i / SIZE[0] as usize);
                let ray = basis.ray(DVec2::new(share(x, SIZE[0]), -share(y, SIZE[1]))).normalize();
                let [[behind, _], [light, passed]] = [0, 1].map(|k| alone(&scenes[k], ray));
                if behind[0] > 0.1 && passed[2] > 0.0 && passed[2] < 0.9 {
                    through += 1.0;
                }
                for c in 0..3 {
                    let want = light[c] + passed[c] * behind[c];
                    let off = (rgb(&pixels, i)[c] - want).abs() / want.max(1e-2);
                    worst = worst.max(off);
                    assert!(off < 0.02, "{altitude} m, {x} {y} {c}: {:?}, not {want}", rgb(&pixels, i));
                }
            }
            println!("{} from {altitude} m: {through} pixels, off by {worst:.4}", b.info().backend);
            assert!(
                through >= 20.0,
                "{altitude} m: {through} pixels of the far planet through the near one's air"
            );
            for sky in &mut skies {
                sky.destroy(b);
            }
            textures.into_iter().for_each(|t| free(b, [t.color, t.depth, t.out]));
        }
    });
}
