//! Every depth convention gives the same air and the same shell.

use welkin::gpu::{Backend, Target};
use welkin::{Composition, DepthConvention, LutSettings, Mode, Scene, SkyRenderer};

use crate::harness::{
    View, aerial_passes, assert_physical, composed, frame_textures, free, luts, march, on_both, shell_passes,
    sky, without_disk,
};

const SIDE: u32 = 8;
const TEXELS: usize = 64;

/// A plane `z` metres away under the air, or under the shell.
fn before(b: &mut dyn Backend, sky: &mut SkyRenderer, scene: &Scene, z: f64) -> Vec<f32> {
    let [color, depth, out] = frame_textures(b, [SIDE; 2]);
    b.write_texture(color, &[0.5; 4 * TEXELS]).unwrap();
    let stored = if z.is_finite() { scene.depth.encode(z) } else { scene.depth.background() };
    b.write_texture(depth, &[stored as f32; TEXELS]).unwrap();
    let shell = sky.settings().look.composition == Composition::Planet;
    let passes = if shell {
        shell_passes(b, sky, scene, depth, Target::color(color))
    } else {
        aerial_passes(b, sky, scene, [color, depth, out])
    };
    b.run(&passes).unwrap();
    let pixels = b.read(if shell { color } else { out }).unwrap();
    free(b, [color, depth, out]);
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
            composed(Composition::Full, luts(LutSettings::LOW)),
            composed(Composition::Full, sky(march(24, 8))),
            composed(Composition::Planet, luts(LutSettings::LOW)),
            without_disk(Mode::Planet.settings()),
        ] {
            let mut renderer = SkyRenderer::new(settings).unwrap();
            let mut seen = Vec::new();
            for z in [50.0, 2e3, 40e3, f64::INFINITY] {
                let results = conventions.map(|depth| {
                    let view = View { altitude: 20e3, pitch: -5.0, fov: 30.0, ..View::default() };
                    before(b, &mut renderer, &Scene { depth, ..view.scene() }, z)
                });
                for (depth, r) in conventions.iter().zip(&results) {
                    assert_physical(r, "a depth convention");
                    let off = |(a, b): (&f32, &f32)| (a - b).abs() / b.abs().max(1e-3);
                    let worst = r.iter().zip(&results[0]).map(off).fold(0.0, f32::max);
                    // A forward 32-bit depth with near 10 m resolves 40 km to 1 %; the others to 1e-5.
                    let forward = matches!(
                        depth,
                        DepthConvention::ZeroToOne { .. } | DepthConvention::NegativeOneToOne { .. }
                    );
                    assert!(
                        worst < if forward { 1e-2 } else { 1e-4 },
                        "{settings:?} {depth:?} at {z} m: {worst}"
                    );
                }
                seen.push(results[0].clone());
            }
            assert!(seen.windows(2).all(|w| w[0] != w[1]), "the distance changes nothing: not a test");
            renderer.destroy(b);
        }
    });
}
