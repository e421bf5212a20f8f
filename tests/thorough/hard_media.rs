//! Media at the edges of what is accepted are finite at every altitude.

use welkin::gpu::Backend;
use welkin::{AtmosphereParams, LutSettings, MiePhase, PictureRenderer, Quality};

use crate::harness::{View, assert_physical, draw, everything, on_both, over_black, sky};

fn media() -> Vec<(&'static str, AtmosphereParams)> {
    let earth = AtmosphereParams::earth;
    let gas = AtmosphereParams::rayleigh;
    let dust = |g: f64, phase| AtmosphereParams {
        rayleigh_scattering: [0.0; 3],
        ozone_absorption: [0.0; 3],
        mie_asymmetry: [g; 3],
        mie_phase: phase,
        ..earth()
    };
    // Of optical depth 1 in blue times so much.
    let depth = |tau: f64| AtmosphereParams {
        rayleigh_scattering: [0.2, 0.5, 1.0].map(|c| c * tau / 12e3),
        rayleigh_scale_height: 12e3,
        ..gas()
    };
    let ball = |radius: f64, thickness: f64, height: f64| AtmosphereParams {
        planet_radius: radius,
        atmosphere_radius: radius + thickness,
        rayleigh_scattering: [0.05, 0.1, 0.2].map(|t| t / height),
        mie_scattering: [0.05 / height; 3],
        mie_absorption: [0.005 / height; 3],
        rayleigh_scale_height: height,
        mie_scale_height: height,
        ozone_absorption: [0.0; 3],
        ..earth()
    };
    let mut all: Vec<_> =
        AtmosphereParams::PRESETS.iter().map(|&n| (n, AtmosphereParams::preset(n).unwrap())).collect();
    all.extend([
        (
            "ozone",
            AtmosphereParams {
                ozone_absorption: earth().ozone_absorption,
                rayleigh_scattering: [0.0; 3],
                ..gas()
            },
        ),
        ("dust g -0.5", dust(-0.5, MiePhase::HenyeyGreenstein)),
        ("dust g 0.5", dust(0.5, MiePhase::CornetteShanks)),
        ("dust g 0", dust(0.0, MiePhase::CornetteShanks)),
        ("dust g 0.999", dust(0.999, MiePhase::CornetteShanks)),
        ("dust g -0.999", dust(-0.999, MiePhase::HenyeyGreenstein)),
        ("depth 1e-9", depth(1e-9)),
        ("depth 1e4", depth(1e4)),
        (
            "scale height 1 m",
            AtmosphereParams { rayleigh_scale_height: 1.0, mie_scale_height: 1.0, ..earth() },
        ),
        ("thin shell", ball(6.36e6, 63.7, 8.0)),
        ("thick shell", ball(6.36e6, 12.72e6, 1e6)),
        ("1 km planet", ball(1e3, 300.0, 40.0)),
        ("black ground", AtmosphereParams { ground_albedo: [0.0; 3], ..earth() }),
        ("white ground", AtmosphereParams { ground_albedo: [1.0; 3], ..earth() }),
    ]);
    all
}

/// As in [`LutSettings::LOW`], but a quarter of the texels: each is made as it is there.
const FEW: LutSettings = LutSettings {
    transmittance: [32, 16],
    multi_scattering: [20, 8],
    sky_view: [24, 32],
    aerial: [8, 12, 9],
    ..LutSettings::LOW
};

#[test]
fn hard_media_are_finite() {
    let draw_all = |b: &mut dyn Backend, quality: Quality, media: &[(&'static str, AtmosphereParams)]| {
        let mut renderer = PictureRenderer::default();
        for (name, params) in media {
            let (radius, thickness) = (params.planet_radius, params.thickness());
            // Metres above the surface that are the next f64 of the distance from the centre.
            let ulp = |r: f64, up: bool| (if up { r.next_up() } else { r.next_down() }) - radius;
            let top = params.atmosphere_radius;
            let altitudes = [
                -100.0_f64.min(0.4 * radius),
                0.0,
                0.3 * thickness,
                ulp(top, false),
                top - radius,
                ulp(top, true),
                // In 32 bits, as the passes have it.
                f64::from((thickness as f32).next_down()),
                f64::from((thickness as f32).next_up()),
                2.0 * thickness + radius,
            ];
            let mut lit = 0.0_f32;
            for altitude in altitudes {
                for sun_elevation in
                    if (altitude / thickness - 1.0).abs() < 0.1 { &[3.0][..] } else { &[90.0, -20.0] }
                {
                    let sun_elevation = *sun_elevation;
                    let dip = (radius / (radius + altitude.max(0.0))).acos().to_degrees();
                    let view = View {
                        params: params.clone(),
                        altitude,
                        pitch: if altitude > 1.5 * thickness { -89.0 } else { -dip },
                        fov: 130.0,
                        sun_elevation,
                        ..View::default()
                    };
                    let settings = over_black(sky(quality));
                    let what =
                        format!("{} {quality:?} {name}, {altitude} m, sun {sun_elevation}", b.info().backend);
                    let pixels = draw(b, &mut renderer, &view.scene(), &settings, [8, 8]);
                    assert_physical(&pixels, &what);
                    lit = pixels.chunks_exact(4).fold(lit, |m, p| m.max(p[2]));
                }
            }
            assert!((lit > 0.0) == (*name != "ozone"), "{name}: {lit}");
        }
        renderer.destroy(b);
    };
    on_both(|b| {
        draw_all(b, Quality::Luts(FEW), &media());
        if everything() {
            draw_all(b, Quality::LOW, &media());
            draw_all(b, Quality::MEDIUM, &media()[..2]);
            draw_all(b, Quality::HIGH, &media()[..1]);
        }
    });
}
