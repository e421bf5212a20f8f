//! Whatever numbers come in: checks answer and never panic, and what they accept becomes finite uniform
//! blocks.
#![cfg(feature = "probe")]

use std::cell::Cell;

use glam::DVec3;
use proptest::num::f64::{ANY, NORMAL};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use welkin::frame::luts::LutsUniform;
use welkin::frame::uniforms::FrameUniform;
use welkin::gpu::RowOrder;
use welkin::model::scene::Tangents;
use welkin::{AtmosphereParams, Camera, DepthConvention, Error, ErrorKind, LutSettings, MiePhase, Scene};

/// From a range, evenly in the logarithm; or one of its ends, or anything at all.
fn near(low: f64, high: f64) -> impl Strategy<Value = f64> {
    let least = low.max(1e-300);
    prop_oneof![
        100 => (0.0..1.0f64).prop_map(move |t| (least * (high / least).powf(t)).clamp(low, high)),
        2 => Just(low),
        2 => Just(high),
        1 => Just(low.next_down()),
        1 => Just(high.next_up()),
        1 => ANY,
    ]
}

fn three(low: f64, high: f64) -> impl Strategy<Value = [f64; 3]> {
    [near(low, high), near(low, high), near(low, high)]
}

fn vector(scale: f64) -> impl Strategy<Value = DVec3> {
    let part = prop_oneof![8 => -scale..scale, 1 => Just(0.0), 1 => ANY];
    [part.clone(), part.clone(), part].prop_map(DVec3::from_array)
}

fn air() -> impl Strategy<Value = AtmosphereParams> {
    let deep = prop_oneof![2 => Just(0.0), 1 => near(-0.1, 0.0)];
    let body = (near(1e2, 1e9), near(1e-6, 4.0), three(0.0, 1.0), near(0.1, 1e7), deep);
    let aerosol = (three(0.0, 1.0), three(0.0, 1.0), near(0.1, 1e7), three(-0.999, 0.999), any::<bool>());
    let rest =
        (three(0.0, 1.0), near(0.0, 1e7), near(1.0, 1e7), three(0.0, 1.0), near(0.0, 1e6), near(1e-5, 0.5));
    (body, aerosol, rest).prop_map(|(body, aerosol, rest)| AtmosphereParams {
        planet_radius: body.0,
        lowest_ground: body.0 * body.4,
        atmosphere_radius: body.0 * (1.0 + body.1),
        rayleigh_scattering: body.2,
        rayleigh_scale_height: body.3,
        mie_scattering: aerosol.0,
        mie_absorption: aerosol.1,
        mie_scale_height: aerosol.2,
        mie_asymmetry: aerosol.3,
        mie_phase: if aerosol.4 { MiePhase::CornetteShanks } else { MiePhase::HenyeyGreenstein },
        ozone_absorption: rest.0,
        ozone_center_altitude: rest.1,
        ozone_half_width: rest.2,
        ground_albedo: rest.3,
        sun_intensity: rest.4,
        sun_angular_radius: rest.5,
    })
}

fn depth() -> impl Strategy<Value = DepthConvention> {
    (0..5, near(1e-4, 1e9), near(1.001, 1e15)).prop_map(|(which, near, ratio)| {
        let far = near * ratio;
        match which {
            0 => DepthConvention::ZeroToOne { near, far },
            1 => DepthConvention::Reversed { near, far },
            2 => DepthConvention::ReversedInfinite { near },
            3 => DepthConvention::NegativeOneToOne { near, far },
            _ => DepthConvention::Logarithmic { far },
        }
    })
}

fn scenes() -> impl Strategy<Value = Scene> {
    let tangent = || prop_oneof![8 => -2.0..2.0f64, 1 => Just(1e4), 1 => Just(-1e4), 1 => ANY];
    let camera = (
        vector(1.0),
        near(0.4, 1e12),
        vector(1.0),
        vector(1.0),
        [tangent(), tangent(), tangent(), tangent()],
    );
    (air(), camera, vector(1e12), vector(1.0), near(1e-150, 1e150), depth()).prop_map(
        |(atmosphere, (up, radii, forward, head, t), planet_center, sun, length, depth)| {
            let turned = |a: f64, b: f64| if a < b { (a, b) } else { (b, a) };
            let ((left, right), (bottom, top)) = (turned(t[0], t[1]), turned(t[2], t[3]));
            Scene {
                camera: Camera {
                    position: planet_center + up.normalize() * radii * atmosphere.planet_radius,
                    forward,
                    up: head,
                    tangents: Tangents { left, right, bottom, top },
                },
                planet_center,
                atmosphere,
                sun_direction: sun * length,
                depth,
                moon: None,
                ellipsoid: None,
            }
        },
    )
}

fn finite(block: &[u8], what: &str) -> Result<(), TestCaseError> {
    let values: Vec<f32> = block.chunks_exact(4).map(|b| f32::from_ne_bytes(b.try_into().unwrap())).collect();
    // Whole numbers in the block read as tiny floats.
    prop_assert!(values.iter().all(|v| v.is_finite()), "{what}: {values:?}");
    Ok(())
}

fn with_radii(planet_radius: f64, atmosphere_radius: f64) -> AtmosphereParams {
    AtmosphereParams { planet_radius, atmosphere_radius, ..AtmosphereParams::earth() }
}

fn config() -> ProptestConfig {
    ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn anything_at_all_is_answered(v in prop::collection::vec(prop_oneof![ANY, NORMAL, -2.0..2.0f64], 24)) {
        let xyz = |i: usize| DVec3::new(v[i], v[i + 1], v[i + 2]);
        let tangents = Tangents { left: v[9], right: v[10], bottom: v[11], top: v[12] };
        let atmosphere = with_radii(v[13], v[14]);
        let camera = Camera { position: xyz(0), forward: xyz(3), up: xyz(6), tangents };
        for depth in [
            DepthConvention::Reversed { near: v[15], far: v[16] },
            DepthConvention::Logarithmic { far: v[17] },
            DepthConvention::default(),
        ] {
            for air in [&atmosphere, &AtmosphereParams::earth()] {
                let (planet_center, sun_direction) = (xyz(18), xyz(21));
                let atmosphere = air.clone();
                let (moon, ellipsoid) = (None, None);
                let scene =
                    Scene { camera, planet_center, atmosphere, sun_direction, depth, moon, ellipsoid };
                if let Ok(view) = scene.validate() {
                    prop_assert!(view.altitude.is_finite() && view.sun.is_finite());
                    prop_assert!(view.basis.forward.is_finite());
                }
            }
        }
    }
}

#[test]
fn what_is_accepted_becomes_finite_blocks() {
    let accepted = Cell::new(0);
    let config = ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() };
    let inputs = (scenes(), [1..5000u32, 1..5000u32], 0.0..=1.0f64);
    let blocks = |(scene, size, sky_weight): (Scene, [u32; 2], f64)| {
        let view = match scene.validate().map_err(Error::into_kind) {
            Ok(view) => view,
            Err(ErrorKind::Invalid { field, value, allowed }) => {
                prop_assert!(!field.is_empty() && !value.is_empty() && !allowed.is_empty());
                return Ok(());
            }
            Err(other) => return Err(TestCaseError::fail(format!("{other}"))),
        };
        accepted.set(accepted.get() + 1);
        prop_assert!(view.altitude.is_finite() && (view.sun.length() - 1.0).abs() < 1e-9, "{view:?}");
        prop_assert!(view.sun.x >= -1e-9 && view.sun.y.abs() < 1e-8, "{view:?}");
        let block = FrameUniform::new(&scene, &view, size, RowOrder::TopDown, [1, 1], sky_weight);
        finite(bytemuck::bytes_of(&block), "frame")?;
        let luts = LutsUniform::new(&scene.atmosphere, &LutSettings::default());
        finite(bytemuck::bytes_of(&luts), "luts")?;
        // Aerosol that is left over once the forward light is taken off neither shines nor amplifies.
        prop_assert!(luts.mie_extinction.iter().all(|e| *e >= 0.0), "{luts:?}");
        prop_assert!(luts.mie_moment0.iter().all(|m| (0.0..=1.000_001).contains(m)), "{luts:?}");
        prop_assert!(luts.mie_asymmetry.iter().all(|g| (-1.0..=1.0).contains(g)), "{luts:?}");
        prop_assert!(luts.sun_span > 0.0 && luts.sun_width > 0.0 && luts.altitude_growth > 0.0, "{luts:?}");
        Ok(())
    };
    TestRunner::new(config).run(&inputs, blocks).unwrap();
    println!("{} of 4000 scenes were accepted", accepted.get());
    assert!(accepted.get() > 400, "too few scenes are accepted to learn from: {}", accepted.get());
}
