//! What hides the sun from parts of the air, as a texture of the user's says: clouds, mountains.

use welkin::gpu::{Backend, Format, Target};
use welkin::{AerialTargets, Composition, FrameTargets, Moon, Scene, SkyRenderer, SkySettings};

use crate::harness::*;

const SIZE: [u32; 2] = [16, 12];

/// The light of the air's pass over a scene of one colour, with so much of the sunlight along each ray.
fn over(b: &mut dyn Backend, scene: &Scene, sky: SkySettings, shade: f32, left: Option<&[f32]>) -> Vec<f32> {
    let [color, depth, out] = frame_textures(b, SIZE);
    let visibility = texture(b, "visibility", SIZE, Format::R32Float);
    let stored = scene.depth.encode(2e4) as f32;
    b.run(&[clear_pass(color, [shade, shade, shade, 1.0]), clear_pass(depth, [stored; 4])]).unwrap();
    if composed(Composition::Planet, sky) == sky {
        b.run(&[clear_pass(out, [shade, shade, shade, 1.0])]).unwrap();
    }
    let air = AerialTargets { color: Some(color), depth, target: Target::color(out) };
    let mut targets = FrameTargets { aerial: Some(air), ..FrameTargets::default() };
    if let Some(left) = left {
        b.write_texture(visibility, left).unwrap();
        targets = targets.with_lit_fraction(visibility);
    }
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let frame = renderer.frame(b, scene, &targets).unwrap();
    let passes: Vec<_> = frame.background.iter().chain(frame.aerial).cloned().collect();
    b.run(&passes).unwrap();
    let pixels = b.read(out).unwrap();
    assert_physical(&pixels, "with a sun that is hidden");
    renderer.destroy(b);
    free(b, [color, depth, out, visibility]);
    pixels
}

/// By every way in which the air's pass computes light: it is dimmed pixel by pixel, and what lies behind is
/// not dimmed any more than before.
#[test]
fn light_is_dimmed_by_what_hides_the_sun_and_the_scene_is_not() {
    let day = View { altitude: 500.0, pitch: -2.0, sun_elevation: 20.0, ..View::default() }.scene();
    let towards = day.sun_direction.normalize();
    let moon = Moon::new(day.camera.position + towards * 3.8e8, 1.6e6);
    let eclipsed = Scene { moon: Some(moon), ..day.clone() };
    // In stripes and in between, with values out of range at the ends.
    let left: Vec<f32> = (0..SIZE[0] * SIZE[1]).map(|i| (i % SIZE[0]) as f32 / 12.0 - 0.1).collect();
    on_both(|b| {
        for (name, scene, sky) in [
            ("from LUTs", &day, luts(TINY)),
            ("marched", &day, sky(march(8, 4))),
            ("under the moon", &eclipsed, luts(TINY)),
            ("over the scene", &day, composed(Composition::AtmospherePost, luts(TINY))),
            ("a shell", &day, composed(Composition::Planet, luts(TINY))),
        ] {
            let all = over(b, scene, sky, 0.0, None);
            let some = over(b, scene, sky, 0.0, Some(&left));
            let most = brightest(&colors(&all)).into_iter().fold(0.0, f64::max);
            assert!(most > 0.0, "{name}: no light");
            let behind = [over(b, scene, sky, 0.5, None), over(b, scene, sky, 0.5, Some(&left))];
            for (i, left) in left.iter().enumerate() {
                let left = f64::from(left.clamp(0.0, 1.0));
                let (p, q) = (rgb(&all, i), rgb(&some, i));
                for c in 0..3 {
                    assert!((q[c] - p[c] * left).abs() <= 2e-6 * most, "{name}: pixel {i} is {q:?} of {p:?}");
                    let dimmed = [rgb(&behind[0], i)[c] - p[c], rgb(&behind[1], i)[c] - q[c]];
                    assert!(
                        (dimmed[0] - dimmed[1]).abs() <= 2e-6 * (most + 0.5),
                        "{name}: {dimmed:?} behind"
                    );
                }
            }
        }
    });
}

#[test]
fn textures_that_do_not_fit_are_refused() {
    on_both(|b| {
        let scene = View::default().scene();
        let [color, depth, out] = frame_textures(b, SIZE);
        let small = texture(b, "small", [4, 4], Format::R32Float);
        let mut renderer = SkyRenderer::new(luts(TINY)).unwrap();
        let air = AerialTargets { color: Some(color), depth, target: Target::color(out) };
        let targets = FrameTargets::background(Target::color(color));
        let mut refusal = |b: &mut dyn Backend, targets: FrameTargets| {
            renderer.frame(b, &scene, &targets.with_lit_fraction(small)).unwrap_err().to_string()
        };
        let error = refusal(b, targets.with_aerial(air));
        assert!(error.starts_with("lit fraction = 4 × 4"), "{error}");
        let error = refusal(b, targets);
        assert!(error.starts_with("lit fraction = a texture"), "{error}");
        free(b, [color, depth, out, small]);
    });
}
