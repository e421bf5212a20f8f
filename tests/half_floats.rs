//! Half floats: what a picture loses in 16-bit targets, from the sun's disk to the end of astronomical
//! twilight.
//!
//! `cargo test --all-features --test all half_floats -- --nocapture` prints it.

use welkin::gpu::{Backend, Format};
use welkin::render::picture::scale;
use welkin::{AtmosphereParams, Composition, PictureRenderer, PictureSettings, Quality, Scene, SkySettings};

use crate::harness::{View, composed, on_both, with_disk};

/// Half floats: the largest, the step below 6e-5, and the largest relative rounding above.
const LARGEST: f32 = 65504.0;
const STEP: f64 = 5.97e-8;
const ROUNDING: f64 = 4.9e-4;

/// Radiance as drawn, its scale, and display values from 0 to 255.
fn draw(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    settings: &PictureSettings,
) -> (Vec<f32>, f64, Vec<f64>) {
    let drawn = renderer.draw(b, scene, settings, [12, 12]).unwrap();
    let display = b.read(drawn.display).unwrap().iter().map(|v| 255.0 * f64::from(*v)).collect();
    (b.read(drawn.radiance).unwrap(), drawn.scale, display)
}

fn settings(radiance: Format, exposure: f64, sun_disk: bool) -> PictureSettings {
    let sky = with_disk(sun_disk, Quality::LOW.into());
    PictureSettings { sky, exposure, radiance, terrain: None, dither: false, ..PictureSettings::default() }
}

fn colors(pixels: &[f32]) -> impl Iterator<Item = f64> {
    pixels.iter().enumerate().filter(|(i, _)| i % 4 < 3).map(|(_, v)| f64::from(*v))
}

#[test]
fn twilight_fits_into_half_floats() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        for sun_elevation in [-6.0, -12.0, -18.0] {
            for heading in [0.0, 180.0] {
                let view =
                    View { altitude: 2.0, pitch: 45.0, fov: 80.0, heading, sun_elevation, ..View::default() };
                let scene = view.scene();
                let exact = draw(b, &mut renderer, &scene, &settings(Format::Rgba32Float, 1.0, false));
                assert_eq!(exact.1, 1.0);
                let brightest = colors(&exact.0).fold(0.0, f64::max);
                let darkest = colors(&exact.0).fold(f64::MAX, f64::min);
                assert!(darkest > 0.0, "the reference is black");
                // As far as 1e6, the most that the command line lets through.
                let exposure = (0.5 / brightest).min(1e6);
                let of = |b: &mut dyn Backend, renderer: &mut PictureRenderer, exposure| {
                    let [wide, half] = [Format::Rgba32Float, Format::Rgba16Float]
                        .map(|format| draw(b, renderer, &scene, &settings(format, exposure, false)));
                    assert_eq!(wide.1, half.1);
                    let off = colors(&wide.0).zip(colors(&half.0)).map(|(w, h)| {
                        // Two passes round.
                        assert!((w - h).abs() <= 2.0 * (ROUNDING * w).max(STEP), "{view:?}: {h}, not {w}");
                        (w - h).abs() / half.1 * exposure
                    });
                    let off = off.fold(0.0, f64::max);
                    let shown = wide.2.iter().zip(&half.2).map(|(w, h)| (w - h).abs()).fold(0.0, f64::max);
                    let lost =
                        colors(&wide.0).zip(colors(&half.0)).filter(|(w, h)| *w > 0.0 && *h == 0.0).count();
                    (off, shown, lost, half.1)
                };
                let (off, shown, lost, by) = of(b, &mut renderer, exposure);
                let unscaled = darkest < STEP;
                println!(
                    "{} sun {sun_elevation}, heading {heading}: radiance {darkest:.1e} to {brightest:.1e}, \
                     scale {by}: off by {off:.1e} of display white, {shown:.0} of 255, {lost} values lost",
                    b.info().backend
                );
                assert!(off < 1e-3 && shown < 1.01 && lost == 0, "{off} {shown} {lost}");
                // In the unit of radiance itself they would be lost.
                assert_eq!(
                    sun_elevation == -18.0,
                    unscaled && brightest < 100.0 * STEP,
                    "{darkest} {brightest}"
                );
                // The scale rounds nothing.
                let scaled = draw(b, &mut renderer, &scene, &settings(Format::Rgba32Float, exposure, false));
                for (a, e) in colors(&scaled.0).zip(colors(&exact.0)) {
                    assert!((a / scaled.1 / e - 1.0).abs() < 1e-6, "{a} {e}");
                }
            }
        }
        renderer.destroy(b);
    });
}

#[test]
fn nothing_is_infinite_in_half_floats() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        // The sun in the middle of the picture, some pixels wide; then air before the ground, and a hazy limb
        // with the sun behind it, which only the depth-aware pass draws.
        let views = [
            (100.0, 20.0, 20.0),
            (30e3, 20.0, 20.0),
            (4e5, 20.0, 20.0),
            (30e3, -40.0, 20.0),
            (4e5, -19.2, -19.0),
        ];
        for sun_intensity in [22.0, 1e6] {
            for (altitude, pitch, sun_elevation) in views {
                let mie_asymmetry = if sun_elevation < 0.0 { [0.95; 3] } else { [0.8; 3] };
                let params = AtmosphereParams { sun_intensity, mie_asymmetry, ..AtmosphereParams::earth() };
                let view = View { params, altitude, pitch, fov: 4.0, sun_elevation, ..View::default() };
                let scene = view.scene();
                if sun_elevation < 0.0 && sun_intensity == 22.0 {
                    let (wide, _, _) =
                        draw(b, &mut renderer, &scene, &settings(Format::Rgba32Float, 1.0, false));
                    let brightest = wide.iter().copied().fold(0.0, f32::max) / 22.0;
                    println!(
                        "{}: the limb sends {brightest} of the sun's irradiance, 1/sr",
                        b.info().backend
                    );
                    assert!(1e6 * brightest > 2.0 * LARGEST, "the brightest sun stays in range: not a test");
                }
                for exposure in [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e9] {
                    for (composition, render_scale) in
                        [(Composition::Full, 1.0), (Composition::Full, 0.5), (Composition::Planet, 1.0)]
                    {
                        let mut s = settings(Format::Rgba16Float, exposure, true);
                        s.sky = composed(composition, SkySettings { render_scale, ..s.sky });
                        let what =
                            format!("{altitude} m, {pitch}, {sun_intensity}, {exposure}, {composition:?}");
                        let (half, _, display) = draw(b, &mut renderer, &scene, &s);
                        assert!(half.iter().all(|v| (0.0..=LARGEST).contains(v)), "{what}: {half:?}");
                        s.radiance = Format::Rgba32Float;
                        let (wide, _, wide_display) = draw(b, &mut renderer, &scene, &s);
                        assert!(wide.iter().all(|v| v.is_finite() && *v >= 0.0), "{what}: {wide:?}");
                        let off =
                            display.iter().zip(&wide_display).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                        assert!(off < 1.01, "{what}: {off} of 255 from a 32-bit target");
                        // What is far above white is white, without a hole in its middle.
                        if pitch > 0.0 && exposure >= 1e-3 {
                            let i = 4 * (6 * 12 + 6);
                            assert!(
                                display[i..i + 3].iter().all(|v| *v > 254.0),
                                "{what}: {:?}",
                                &display[i..i + 3]
                            );
                        }
                    }
                }
            }
        }
        renderer.destroy(b);
    });
}

#[test]
fn the_scale_is_a_power_of_two_within_range() {
    for exposure in [0.0, 1e-9, 0.3, 0.999, 1.0, 1.5, 2.0, 7e4, 1e9] {
        for sun_intensity in [0.0, 1e-6, 22.0, 1e6] {
            let s = scale(exposure, sun_intensity);
            assert_eq!(s.log2().fract(), 0.0);
            assert!(
                s * sun_intensity <= 1e6 && (exposure == 0.0 || s <= exposure),
                "{exposure} {sun_intensity}: {s}"
            );
            assert!(exposure * sun_intensity > 1e6 || s > 0.5 * exposure, "{exposure} {sun_intensity}: {s}");
        }
    }
}
