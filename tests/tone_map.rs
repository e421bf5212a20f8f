//! From radiance to display values: the curves are the twin's, dither hides bands and keeps every mean.

use welkin::frame::tone_map::{dither, srgb_encode, tone_map, tone_pass};
use welkin::gpu::{Backend, Format};
use welkin::render::cpu_picture::render;
use welkin::{PictureRenderer, PictureSettings, Scene, SkySettings, ToneMap};

use crate::harness::{View, airless, draw_both, free, on_both, texture, without_disk};

/// Display values of radiance as a pass leaves them in a target, red, green and blue of each pixel, 0 to 255.
fn shown(
    b: &mut dyn Backend,
    radiance: &[[f32; 3]],
    size: [u32; 2],
    map: ToneMap,
    dither: bool,
    format: Format,
) -> Vec<[f64; 3]> {
    let [from, to] = [("radiance", Format::Rgba32Float), ("display", format)]
        .map(|(label, format)| texture(b, label, size, format));
    let texels: Vec<f32> = radiance.iter().flat_map(|[r, g, b]| [*r, *g, *b, 1.0]).collect();
    b.write_texture(from, &texels).unwrap();
    let pass = tone_pass(b, map, 1.0, dither, from, to).unwrap();
    b.run(&[pass]).unwrap();
    let pixels = b.read(to).unwrap();
    free(b, [from, to]);
    assert!(pixels.chunks_exact(4).all(|p| p[3] == 1.0), "alpha");
    pixels.chunks_exact(4).map(|p| [p[0], p[1], p[2]].map(|v| 255.0 * f64::from(v))).collect()
}

/// Exact display values, 0 to 255.
fn exact(map: ToneMap, radiance: [f32; 3]) -> [f64; 3] {
    tone_map(map, radiance.map(f64::from)).map(|v| 255.0 * srgb_encode(v))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, n) = values.fold((0.0, 0.0), |(s, n), v| (s + v, n + 1.0));
    sum / n
}

/// Colours from black to far too bright.
fn colors() -> Vec<[f32; 3]> {
    (0..1024)
        .map(|i| {
            let v = if i < 8 { 0.0 } else { 1e-4 * 1e6_f32.powf(i as f32 / 1023.0) };
            [v, v * (0.2 + 0.1 * (i % 9) as f32), v * (0.1 + 0.3 * (i % 5) as f32)]
        })
        .collect()
}

#[test]
fn curves_are_the_twins() {
    let colors = colors();
    on_both(|b| {
        for map in ToneMap::ALL {
            for on in [false, true] {
                let got = shown(b, &colors, [32, 32], map, on, Format::Rgba8);
                let mut ties = 0;
                for (i, (got, color)) in got.iter().zip(&colors).enumerate() {
                    let want = exact(map, *color);
                    let noise = if on { dither([i as u32 % 32, i as u32 / 32]) } else { [0.0; 3] };
                    for c in 0..3 {
                        let want = want[c] + noise[c];
                        // A 32-bit pow may round the other way next to the middle of two steps.
                        let tie = (want - want.floor() - 0.5).abs() < 2e-3;
                        ties += usize::from(tie);
                        let off = (got[c] - want.clamp(0.0, 255.0).round()).abs();
                        assert!(
                            off < if tie { 1.01 } else { 0.01 },
                            "{map:?} {on} {color:?}: {got:?}, not {want}"
                        );
                    }
                }
                assert!(ties < 40, "{ties} of {} are no test", 3 * colors.len());
            }
        }
    });
}

#[test]
fn dither_keeps_the_mean_of_flat_areas() {
    // Sizes that no period of the pattern divides.
    let size = [61, 47];
    let n = (size[0] * size[1]) as usize;
    // Through Neutral, which leaves colours below 0.76 as they are but for an offset.
    let levels: Vec<f32> = (0..40).map(|i| 0.0008 + 0.0185 * i as f32).collect();
    on_both(|b| {
        let mut worst = 0.0_f64;
        for &level in &levels {
            let color = [level, 0.9 * level, 0.7 * level];
            let want = exact(ToneMap::Neutral, color);
            let got = shown(b, &vec![color; n], size, ToneMap::Neutral, true, Format::Rgba8);
            for c in 0..3 {
                let off = (mean(got.iter().map(|p| p[c])) - want[c]).abs();
                worst = worst.max(off);
                assert!(off < 0.01, "{color:?}, channel {c}: {off} of a step");
                assert!(got.iter().all(|p| (p[c] - want[c]).abs() < 1.0 + 1e-3), "more than one step");
            }
        }
        println!("{}: means are off by at most {worst:.4} of a step", b.info().backend);
        // Black and white are exact, with every curve.
        for map in ToneMap::ALL {
            for (color, want) in [([0.0; 3], 0.0), ([1e9; 3], 255.0)] {
                let got = shown(b, &vec![color; n], size, map, true, Format::Rgba8);
                if exact(map, color).iter().all(|v| (v - want).abs() < 1e-9) {
                    assert!(got.iter().all(|p| (0..3).all(|c| (p[c] - want).abs() < 1e-3)), "{map:?} {want}");
                } else {
                    assert!(want == 255.0 && map != ToneMap::Aces, "{map:?}: {:?}", exact(map, color));
                }
            }
            assert_eq!(exact(map, [0.0; 3]), [0.0; 3]);
        }
    });
}

/// Longest run of equal values of each channel along the rows.
fn longest_runs(pixels: &[[f64; 3]], width: usize) -> [usize; 3] {
    std::array::from_fn(|c| {
        let of_row = |row: &[[f64; 3]]| row.chunk_by(|a, b| a[c] == b[c]).map(<[_]>::len).max().unwrap_or(0);
        pixels.chunks(width).map(of_row).max().unwrap_or(0)
    })
}

/// Root mean square of what means over areas `window` pixels wide and all rows high differ by from the exact
/// values'.
fn banding(pixels: &[[f64; 3]], want: &[[f64; 3]], window: usize) -> f64 {
    let columns: Vec<f64> =
        (0..want.len()).map(|x| mean(pixels[x..].iter().step_by(want.len()).map(|p| p[1]))).collect();
    let errors = (0..=want.len() - window).map(|i| {
        let wanted = mean(want[i..i + window].iter().map(|p| p[1]));
        (mean(columns[i..i + window].iter().copied()) - wanted).powi(2)
    });
    mean(errors).sqrt()
}

#[test]
fn gradients_have_no_bands() {
    on_both(|b| {
        // A step every 8, 16, 64 and 256 pixels: of sky near the horizon, and of a dark zenith.
        for (steps, width) in [(64.0, 512), (32.0, 512), (16.0, 1024), (4.0, 1024)] {
            let row: Vec<[f32; 3]> = (0..width)
                .map(|x| {
                    let display = 0.35 + steps / 255.0 * (x as f32 + 0.5) / width as f32;
                    [display.powf(2.2) + 0.04; 3]
                })
                .collect();
            let want: Vec<_> = row.iter().map(|&c| exact(ToneMap::Neutral, c)).collect();
            let field: Vec<_> = (0..16).flat_map(|_| row.iter().copied()).collect();
            let size = [width, 16];
            let [off, on] =
                [false, true].map(|on| shown(b, &field, size, ToneMap::Neutral, on, Format::Rgba8));
            let w = width as usize;
            let (bands, runs) = (longest_runs(&off, w), longest_runs(&on, w));
            let per_step = w as f64 / f64::from(steps);
            let window = (0.5 * per_step) as usize;
            let [left, right] = [&off, &on].map(|p| banding(p, &want, window));
            println!(
                "{}: a step in {per_step} pixels: runs of {bands:?} become {runs:?}, \
                 bands of {left:.3} {right:.3}",
                b.info().backend
            );
            for c in 0..3 {
                assert!(bands[c] as f64 > 0.9 * per_step, "without dither there is no band: not a test");
                assert!(runs[c] <= bands[c], "{runs:?} {bands:?}");
                if per_step > 30.0 {
                    assert!(2 * runs[c] < bands[c], "{runs:?} {bands:?}");
                }
            }
            // Over half a band the mean is the exact one: an eye that blurs sees none.
            assert!(right < 0.2 * left && left > 0.1, "{left} {right}");
        }
    });
}

#[test]
fn dither_is_for_bytes_alone() {
    let colors = colors();
    on_both(|b| {
        for map in ToneMap::ALL {
            let [off, on] = [false, true].map(|on| shown(b, &colors, [32, 32], map, on, Format::Rgba32Float));
            assert!(off == on, "a float target is dithered");
            let [off, on] = [false, true].map(|on| shown(b, &colors, [32, 32], map, on, Format::Rgba8));
            assert!(off != on, "a byte target is not");
        }
    });
}

#[test]
fn pictures_of_all_renderers_have_the_same_noise() {
    let size = [48, 32];
    let scene: Scene = View { pitch: 20.0, sun_elevation: 20.0, aspect: 1.5, ..View::default() }.scene();
    let empty = Scene { atmosphere: airless(scene.atmosphere.clone()), ..scene.clone() };
    let settings = PictureSettings {
        sky: without_disk(SkySettings::default()),
        terrain: None,
        ..PictureSettings::default()
    };
    assert!(settings.dither, "by default");
    let mut displays = Vec::new();
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut draw = |scene: &Scene, dither| {
            draw_both(b, &mut renderer, scene, &PictureSettings { dither, ..settings }, size)
        };
        let [radiance, with] = draw(&scene, true);
        let [same, without] = draw(&scene, false);
        assert!(radiance == same, "dither changed the radiance");
        assert!(with != without);
        assert!(draw(&scene, true)[1] == with, "not the same twice");
        assert!(draw(&empty, true)[1].chunks_exact(4).all(|p| p[..3] == [0.0; 3]), "black is not black");
        // The noise that the twin adds to this backend's own radiance.
        let mut off = 0;
        for (i, (p, light)) in with.chunks_exact(4).zip(radiance.chunks_exact(4)).enumerate() {
            let want = exact(ToneMap::Aces, [light[0], light[1], light[2]]);
            let noise = dither([i as u32 % size[0], i as u32 / size[0]]);
            off += (0..3)
                .filter(|&c| (255.0 * f64::from(p[c]) - (want[c] + noise[c]).round()).abs() > 0.1)
                .count();
        }
        assert!(off < 10, "{off} values are not the twin's");
        displays.push(with);
        renderer.destroy(b);
    });
    let differ = displays[0].iter().zip(&displays[1]).filter(|(a, b)| a != b).count();
    assert!(
        differ * 50 < displays[0].len(),
        "the backends differ in {differ} of {} values",
        displays[0].len()
    );
    // On the processor, by its own light.
    let [on, off] = [true, false]
        .map(|dither| render(&scene, &PictureSettings { dither, ..settings }, size, &|_| ()).unwrap());
    assert!(on.radiance == off.radiance);
    for (i, p) in on.radiance.iter().enumerate() {
        let want = exact(ToneMap::Aces, [p[0], p[1], p[2]]);
        let noise = dither([i as u32 % size[0], i as u32 / size[0]]);
        for c in 0..3 {
            assert_eq!(f64::from(on.display[i][c]), (want[c] + noise[c]).round());
            assert_eq!(f64::from(off.display[i][c]), want[c].round());
        }
    }
}
