//! The f64 reference against laws and published formulas.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;
use welkin::AtmosphereParams;
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::path::{self, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, optical_depth, single_scattering, transmittance};

/// Length of the gas's column over its length straight up.
fn air_mass(params: &AtmosphereParams, zenith_angle: f64) -> f64 {
    let depth =
        |angle| optical_depth(params, &RayQuery::new(0.0, angle, 1.0, 0.0), Tolerance::TRUTH).unwrap()[0];
    depth(zenith_angle) / depth(0.0)
}

/// Kasten & Young 1989, eq. 3: relative optical air mass of a refracting standard atmosphere, 37.92 at the
/// horizon.
///
/// We have neither refraction nor a stratosphere with a temperature of its own, so this is no identity. It
/// shows the shape: the same to 0.1 % down to 60°, 0.7 % below it at 80° and 7 % at the horizon, where an
/// exponential of 8 km has sqrt(π R / 2 H) = 35.3 air masses.
#[test]
fn air_mass_is_kasten_youngs_as_far_as_it_can_be() {
    let gas = AtmosphereParams::rayleigh();
    let tolerances = [
        (0.0f64, 1e-3),
        (30.0, 1e-3),
        (60.0, 1e-3),
        (70.0, 2.5e-3),
        (80.0, 7e-3),
        (85.0, 0.02),
        (88.0, 0.045),
        (90.0, 0.07),
    ];
    for (degrees, tolerance) in tolerances {
        let fit = 1.0 / (degrees.to_radians().cos() + 0.50572 * (96.07995 - degrees).powf(-1.6364));
        let ours = air_mass(&gas, degrees.to_radians());
        println!("air mass at {degrees:4}°: {ours:8.4}, Kasten & Young {fit:8.4}, {:+.2e}", ours / fit - 1.0);
        assert!((ours / fit - 1.0).abs() < tolerance, "{degrees}: {ours} {fit}");
    }
}

/// Chapman 1931: the grazing column of an exponential atmosphere is `x exp(x) K1(x)` scale heights, x = R /
/// H; asymptotically `sqrt(π x / 2) (1 + 3/(8x) - 15/(128x²) + …)` (Abramowitz & Stegun 9.7.2 for K1).
#[test]
fn grazing_column_is_the_chapman_function() {
    for scale_height in [2000.0, 8000.0, 60_000.0] {
        let gas = AtmosphereParams {
            rayleigh_scale_height: scale_height,
            // So high that what is cut off is below exp(-60).
            atmosphere_radius: 6_360_000.0 + 60.0 * scale_height,
            ..AtmosphereParams::rayleigh()
        };
        let level = RayQuery::new(0.0, FRAC_PI_2, 1.0, 0.0);
        let depth = optical_depth(&gas, &level, Tolerance::TRUTH).unwrap()[0];
        let x = gas.planet_radius / scale_height;
        let mut series = 0.0;
        let mut term = 1.0;
        for k in 0..8 {
            series += term;
            let k = f64::from(k);
            term *= (4.0 - (2.0 * k + 1.0).powi(2)) / (8.0 * x * (k + 1.0));
        }
        let chapman = (0.5 * PI * x).sqrt() * series;
        let ours = depth / (gas.rayleigh_scattering[0] * scale_height);
        assert!((ours / chapman - 1.0).abs() < 1e-10, "H {scale_height}: {ours} {chapman}");
    }
}

/// A plane-parallel limit with a closed form: thin air on a huge planet, `p / μ (1 - exp(-τ m)) / m`, `m =
/// 1/μ + 1/μs`.
#[test]
fn single_scattering_has_the_plane_parallel_limit() {
    let params = AtmosphereParams {
        planet_radius: 1e9,
        atmosphere_radius: 1e9 + 20_000.0,
        rayleigh_scale_height: 1000.0,
        ..AtmosphereParams::rayleigh()
    };
    let (mu, mu_sun) = (0.7f64, 0.4f64);
    // Looking straight through from above at the ground, azimuth 0.
    let query = RayQuery::new(20_000.0, PI - mu.acos(), mu_sun.acos(), 0.0);
    let ours = single_scattering(&params, &query, Sun::Point, Tolerance::TRUTH).unwrap();
    let nu = -mu * mu_sun + ((1.0 - mu * mu) * (1.0 - mu_sun * mu_sun)).sqrt();
    for c in 0..3 {
        let tau = params.rayleigh_scattering[c] * 1000.0 * -f64::exp_m1(-20.0);
        let path = 1.0 / mu + 1.0 / mu_sun;
        let exact = welkin::model::phase::rayleigh(nu) / mu * -(-tau * path).exp_m1() / path;
        assert!(
            (ours.per_irradiance[c] / exact - 1.0).abs() < 1e-4,
            "{c}: {} {exact}",
            ours.per_irradiance[c]
        );
    }
}

/// Transmittance is the same both ways and multiplies along a ray.
#[test]
fn transmittance_is_reciprocal_and_multiplicative() {
    let params = AtmosphereParams::earth();
    let through = |query: &RayQuery| transmittance(&params, query, Tolerance::TRUTH).unwrap();
    for (altitude, view, length) in [(500.0, 1.56f64, 3e5), (60_000.0, 1.70, 5e5), (10.0, 0.3, 2e4)] {
        let there = RayQuery::new(altitude, view, 1.0, 0.0).ended_at(length);
        let start = DVec3::Z * (params.planet_radius + altitude);
        let at = |distance: f64, sign: f64| {
            RayQuery::in_world(
                start + there.direction * distance,
                there.direction * sign,
                DVec3::Z,
                params.planet_radius,
            )
            .unwrap()
        };
        let back = at(length, -1.0).ended_at(length);
        let (first, second) = (there.ended_at(0.4 * length), at(0.4 * length, 1.0).ended_at(0.6 * length));
        for c in 0..3 {
            let one = through(&there)[c];
            assert!((through(&back)[c] / one - 1.0).abs() < 1e-8, "{altitude} {view} {c}");
            assert!(
                (through(&first)[c] * through(&second)[c] / one - 1.0).abs() < 1e-8,
                "{altitude} {view} {c}"
            );
        }
    }
}

/// The furnace: no absorption and white ground return all light; black ground keeps some, and none is made.
#[test]
fn what_comes_in_goes_out() {
    let white = AtmosphereParams { ground_albedo: [1.0; 3], ..AtmosphereParams::rayleigh() };
    let hazy = AtmosphereParams {
        mie_scattering: [2e-5, 4e-5, 8e-5],
        mie_asymmetry: [0.3, 0.5, 0.6],
        mie_scale_height: 3000.0,
        ..white.clone()
    };
    let settings =
        Settings { altitudes: 10, sun_angles: 28, zeniths: 8, azimuths: 8, degree: 6, ..Settings::QUICK };
    for (name, params) in [("gas", white.clone()), ("haze", hazy)] {
        let orders = Orders::solve(&params, Settings { tolerance: 3e-4, ..settings }, |_| {}).unwrap();
        let share = orders.escaping_share(8);
        println!("furnace, {name}: {share:?} after {} iterations", orders.history().len());
        for c in 0..3 {
            assert!((share[c] - 1.0).abs() < 1e-3, "{name}: {share:?}");
        }
    }
    let black = AtmosphereParams::rayleigh();
    let share = Orders::solve(&black, settings, |_| {}).unwrap().escaping_share(8);
    assert!(share.iter().all(|s| (0.01..0.5).contains(s)) && share[2] > share[0], "{share:?}");
    let absorber = AtmosphereParams { rayleigh_scattering: [0.0; 3], ozone_absorption: [1e-5; 3], ..black };
    let orders = Orders::solve(&absorber, settings, |_| {}).unwrap();
    assert_eq!(orders.escaping_share(4), [0.0; 3]);
}

/// Two methods that share only the columns, in air far from Earth's.
#[test]
fn orders_and_paths_agree_off_earth() {
    let tiny = AtmosphereParams {
        planet_radius: 60_000.0,
        atmosphere_radius: 100_000.0,
        rayleigh_scattering: [2e-5, 4e-5, 1e-4],
        rayleigh_scale_height: 6000.0,
        mie_scattering: [1e-5; 3],
        mie_absorption: [1e-5; 3],
        mie_scale_height: 3000.0,
        mie_asymmetry: [0.6; 3],
        ozone_absorption: [0.0; 3],
        ground_albedo: [0.6, 0.3, 0.1],
        ..AtmosphereParams::earth()
    };
    let small = Settings { altitudes: 10, sun_angles: 28, ..Settings::QUICK };
    // Mars' dust throws blue light forward (g = 0.86): at sunset its aureole needs twice the degree.
    let sharp = Settings { degree: 24, azimuths: 25, zeniths: 10, sun_angles: 24, ..small };
    for (name, params, settings) in
        [("tiny", tiny, Settings { degree: 8, ..small }), ("mars", AtmosphereParams::mars(), sharp)]
    {
        let orders = Orders::solve(&params, settings, |_| {}).unwrap();
        let top = params.thickness();
        for (altitude, view, sun, azimuth) in [
            (0.0, 0.5, 0.8, 1.0),
            (0.0, 1.5, 1.5, 3.0),
            (0.3 * top, 2.0, 1.2, 0.5),
            (2.0 * top, 2.9, 0.5, 0.0),
        ] {
            let query = RayQuery::new(altitude, view, sun, azimuth);
            let tabled = orders.radiance(&query, Tolerance::PICTURE).unwrap();
            let traced = path_trace(&params, &query, path::Settings { paths: 40_000, seed: 5 }).unwrap();
            for c in 0..3 {
                let (a, b, e) = (tabled.per_irradiance[c], traced.per_irradiance[c], traced.std_err[c]);
                println!(
                    "{name} {altitude} {view} {sun} {c}: {a:.6} {b:.6} ± {e:.6}, {:+.2e} {:+.1} σ",
                    a / b - 1.0,
                    (a - b) / e
                );
                assert!(
                    (a - b).abs() < (0.005 * b).max(4.5 * e),
                    "{name} {altitude} {view} {sun} {c}: {a} {b} ± {e}"
                );
            }
        }
    }
}

#[test]
fn settings_out_of_range_name_the_field() {
    let params = AtmosphereParams::rayleigh();
    for (settings, field) in [
        (Settings { altitudes: 3, ..Settings::QUICK }, "settings.altitudes"),
        (Settings { degree: 14, ..Settings::QUICK }, "settings.degree"),
        (Settings { tolerance: f64::NAN, ..Settings::QUICK }, "settings.tolerance"),
    ] {
        let error = Orders::solve(&params, settings, |_| {}).unwrap_err();
        assert!(error.to_string().starts_with(field), "{error}");
    }
    // Neither an error nor silence: too few iterations are reported.
    let hasty = Settings {
        altitudes: 6,
        sun_angles: 12,
        zeniths: 4,
        azimuths: 4,
        degree: 3,
        max_iterations: 1,
        ..Settings::QUICK
    };
    assert!(!Orders::solve(&params, hasty, |_| {}).unwrap().converged());
    assert!(Orders::solve(&params, Settings { max_iterations: 20, ..hasty }, |_| {}).unwrap().converged());
    let broken = AtmosphereParams { planet_radius: -1.0, ..params.clone() };
    assert!(Orders::solve(&broken, Settings::QUICK, |_| {}).is_err());
    let query = RayQuery::new(0.0, 0.0, 0.0, 0.0);
    assert!(path_trace(&params, &query, path::Settings { paths: 0, seed: 0 }).is_err());
}

/// Whatever the parameters' checks accept has a finite answer in its physical range.
#[test]
fn accepted_parameters_give_finite_light() {
    use proptest::prelude::*;
    use proptest::test_runner::{Config, RngSeed, TestRunner};
    let power = |lo: f64, hi: f64| (lo.ln()..hi.ln()).prop_map(f64::exp);
    let medium = (
        (power(1e2, 1e9), power(1e-6, 4.0)),
        (power(0.1, 1e7), power(0.1, 1e7), 0.0..1e6, power(1.0, 1e7)),
        (power(1e-9, 1.0), power(1e-9, 1.0), power(1e-9, 1.0), -0.999..0.999),
        (0..8u32, any::<bool>(), 0.0..=1.0),
    );
    let view = (-0.1..3.0, 0.0..=PI, 0.0..=PI, 0.0..=PI, prop_oneof![Just(f64::INFINITY), power(1e-3, 1e9)]);
    let lit = std::cell::Cell::new(0);
    let config =
        Config { cases: 3000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Config::default() };
    let result = TestRunner::new(config).run(&(medium, view), |(medium, view)| {
        let ((radius, thickness), (gas, aerosol, middle, width), (a, b, c, g), (present, cornette, albedo)) =
            medium;
        let on = |bit: u32, v: f64| if present & (1 << bit) != 0 { v } else { 0.0 };
        let params = AtmosphereParams {
            planet_radius: radius,
            atmosphere_radius: radius * (1.0 + 1e-6 + thickness),
            rayleigh_scattering: [on(0, a), on(0, a * 0.1), on(0, a * 0.01)],
            rayleigh_scale_height: gas,
            mie_scattering: [on(1, b), on(1, b * 0.1), 0.0],
            mie_absorption: [0.0, on(1, b), on(1, b * 0.01)],
            mie_scale_height: aerosol,
            mie_asymmetry: [g, -g, 0.0],
            mie_phase: if cornette { welkin::MiePhase::CornetteShanks } else { Default::default() },
            ozone_absorption: [on(2, c), on(2, c * 0.1), 0.0],
            ozone_center_altitude: middle,
            ozone_half_width: width,
            ground_albedo: [albedo; 3],
            ..AtmosphereParams::earth()
        };
        prop_assume!(params.validate().is_ok());
        let (altitude, zenith, sun, azimuth, length) = view;
        let query = RayQuery::new(altitude * params.thickness(), zenith, sun, azimuth).ended_at(length);
        let light = single_scattering(&params, &query, Sun::Point, Tolerance::PICTURE).unwrap();
        for c in 0..3 {
            prop_assert!(light.per_irradiance[c].is_finite() && light.per_irradiance[c] >= 0.0, "{light:?}");
            prop_assert!((0.0..=1.0).contains(&light.transmittance[c]), "{light:?}");
        }
        let camera = DVec3::Z * (params.planet_radius + query.altitude.max(0.0));
        let march =
            welkin::reference::compute_single_scatter(camera, query.direction, query.sun, &params, 16, 8);
        prop_assert!(march.iter().all(|v| v.is_finite() && *v >= 0.0), "{march:?}");
        let n = lit.get();
        lit.set(n + u32::from(light.per_irradiance[0] > 0.0));
        if lit.get() > n && n.is_multiple_of(50) {
            let least = Settings {
                altitudes: 5,
                sun_angles: 10,
                zeniths: 4,
                azimuths: 4,
                degree: 3,
                max_iterations: 6,
                tolerance: 0.01,
            };
            let all =
                Orders::solve(&params, least, |_| {}).unwrap().radiance(&query, Tolerance::PICTURE).unwrap();
            prop_assert!(all.per_irradiance.iter().all(|v| v.is_finite() && *v >= 0.0), "{all:?}");
            let traced = path_trace(&params, &query, path::Settings { paths: 16, seed: 1 }).unwrap();
            prop_assert!(traced.per_irradiance.iter().all(|v| v.is_finite() && *v >= 0.0), "{traced:?}");
        }
        Ok(())
    });
    if let Err(error) = result {
        panic!("{error}");
    }
    assert!(lit.get() > 500, "only {} cases had light", lit.get());
}
