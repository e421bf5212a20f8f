//! The moon before the sun: light in the air under its shadow.
#![allow(clippy::needless_range_loop)]

use glam::DVec3;
use welkin::eclipse::{MOON_RADIUS, Moon};
use welkin::reference::multiple::{Orders, Settings as Solve};
use welkin::reference::path::{Settings, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{AtmosphereParams, Error};

/// Of the real one, metres.
const DISTANCE: f64 = 3.6e8;

/// A moon whose middle stands `apart` sun radii from the sun's, to the side of `across`.
fn moon(query: &RayQuery, size: f64, apart: f64, across: DVec3, distance: f64) -> Moon {
    let p = AtmosphereParams::earth();
    let side = (across - query.sun * across.dot(query.sun)).normalize();
    let (sin, cos) = (apart * p.sun_angular_radius).sin_cos();
    Moon::new((query.sun * cos + side * sin) * distance, (size * p.sun_angular_radius).sin() * distance)
}

fn light(query: &RayQuery) -> [f64; 3] {
    single_scattering(&AtmosphereParams::earth(), query, Sun::Point, Tolerance::TRUTH).unwrap().per_irradiance
}

const RAYS: [(f64, f64, f64, f64); 5] =
    [(2.0, 0.4, 0.6, 0.3), (2.0, 1.5, 0.9, 2.5), (2.0, 1.565, 1.3, 0.0), (4e5, 1.95, 1.2, 1.0), (2e7, 3.0, 2.2, 0.5)];

#[test]
fn a_far_moon_dims_all_air_alike() {
    for (altitude, view, sun, azimuth) in RAYS {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let clear = light(&query);
        for (size, apart, darkened) in [(1.05, 0.6, false), (0.9, 0.05, true), (1.0, 1.4, true)] {
            // So far that every point sees the same.
            let moon = Moon { limb_darkening: darkened, ..moon(&query, size, apart, DVec3::Y, 9e14) };
            let p = AtmosphereParams::earth();
            let share = moon.sunlight(DVec3::ZERO, query.sun, p.sun_angular_radius);
            let dimmed = light(&query.eclipsed_by(moon));
            for c in 0..3 {
                let expected = share[c] * clear[c];
                assert!(
                    (dimmed[c] - expected).abs() <= 3e-6 * expected,
                    "{altitude} {view} {c}: {dimmed:?} {expected}"
                );
            }
        }
        let total = moon(&query, 2.0, 0.1, DVec3::X, 9e14);
        assert_eq!(light(&query.eclipsed_by(total)), [0.0; 3]);
        for c in 0..3 {
            let floor = light(&query.eclipsed_by(Moon { floor: 0.075, ..total }))[c];
            assert!((floor - 0.075 * clear[c]).abs() <= 3e-6 * clear[c]);
        }
        assert_eq!(light(&query.eclipsed_by(moon(&query, 1.0, 100.0, DVec3::X, DISTANCE))), clear);
    }
}

#[test]
fn every_point_of_a_ray_has_its_own_share() {
    // Pieces of the ray by differences of its light up to them, each times the share in its middle.
    for (altitude, view, sun, azimuth, apart) in
        [(2.0, 1.45, 0.6, 0.3, 0.0), (2.0, 0.8, 0.9, 2.0, 0.5), (2.0, 1.52, 0.3, 1.0, 1.2), (4e5, 1.9, 1.2, 1.0, 1.0)]
    {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let moon = moon(&query, 1.05, apart, query.direction, DISTANCE);
        let p = AtmosphereParams::earth();
        let end = if altitude > 1e5 { 4e6 } else { 1.2e6 };
        let mut sum = [0.0; 3];
        let mut before = [0.0; 3];
        const PIECES: usize = 2000;
        let place = |i: f64| end * (i / PIECES as f64).powi(if altitude > 1e5 { 1 } else { 2 });
        for i in 0..PIECES {
            let upto = light(&query.ended_at(place(i as f64 + 1.0)));
            let middle = query.direction * place(i as f64 + 0.5);
            let share = moon.sunlight(middle, query.sun, p.sun_angular_radius);
            for c in 0..3 {
                sum[c] += (upto[c] - before[c]) * share[c];
            }
            before = upto;
        }
        let (dimmed, clear) = (light(&query.eclipsed_by(moon)), light(&query));
        for c in 0..3 {
            let off = (dimmed[c] - sum[c]).abs() / clear[c];
            assert!(off < 2e-5, "{altitude} {view} {apart} {c}: {dimmed:?} {sum:?} {clear:?}");
        }
        assert!(dimmed[1] < 0.9 * clear[1], "the shadow misses the ray: {dimmed:?} {clear:?}");
    }
}

#[test]
fn paths_know_the_moon() {
    let params = AtmosphereParams { ground_albedo: [0.3; 3], ..AtmosphereParams::earth() };
    let settings = Settings { paths: 2000, seed: 3 };
    for (altitude, view, sun, azimuth) in [(2.0, 0.4, 0.6, 0.3), (2e5, 2.5, 0.9, 1.0)] {
        let query = RayQuery::new(altitude, view, sun, azimuth);
        let clear = path_trace(&params, &query, settings).unwrap();
        let far = moon(&query, 1.0, 0.8, DVec3::Y, 9e14);
        let share = far.sunlight(DVec3::ZERO, query.sun, params.sun_angular_radius);
        // The same paths, each with the same share of its light.
        let dimmed = path_trace(&params, &query.eclipsed_by(far), settings).unwrap();
        for c in 0..3 {
            let expected = share[c] * clear.per_irradiance[c];
            assert!((dimmed.per_irradiance[c] / expected - 1.0).abs() < 1e-5, "{altitude} {c}");
            assert!((dimmed.std_err[c] / (share[c] * clear.std_err[c]) - 1.0).abs() < 1e-4);
        }
    }
    // In the middle of the umbra the sky is dark but not black: light comes from outside of it.
    let query = RayQuery::new(2.0, 0.2, 0.6, 0.3);
    let total = moon(&query, 1.06, 0.0, DVec3::Y, DISTANCE);
    let once = light(&query.eclipsed_by(total));
    let clear = path_trace(&params, &query, settings).unwrap().per_irradiance;
    let dark = path_trace(&params, &query.eclipsed_by(total), Settings { paths: 40_000, seed: 5 }).unwrap();
    for c in 0..3 {
        assert!(once[c] < 1e-3 * clear[c], "{once:?}");
        let share = dark.per_irradiance[c] / clear[c];
        assert!((1e-5..3e-3).contains(&share), "{share} ± {}", dark.std_err[c] / clear[c]);
    }
}

#[test]
fn what_has_no_shadow_says_so() {
    let params = AtmosphereParams::rayleigh();
    let query = RayQuery::new(2.0, 0.4, 0.6, 0.3);
    let moon = Moon::new(query.sun * DISTANCE, MOON_RADIUS);
    let field = |e: Error| e.to_string().split(' ').next().unwrap_or_default().to_owned();
    let disk = single_scattering(&params, &query.eclipsed_by(moon), Sun::Disk { rings: 2 }, Tolerance::PICTURE);
    assert_eq!(field(disk.unwrap_err()), "sun");
    let orders = Orders::solve(&params, Solve::QUICK, |_| {}).unwrap();
    orders.radiance(&query, Tolerance::PICTURE).unwrap();
    assert_eq!(field(orders.radiance(&query.eclipsed_by(moon), Tolerance::PICTURE).unwrap_err()), "ray.moon");
    let inside = Moon { radius: 5e8, ..moon };
    let refused = single_scattering(&params, &query.eclipsed_by(inside), Sun::Point, Tolerance::PICTURE);
    assert_eq!(field(refused.unwrap_err()), "moon.position");
    let refused = path_trace(&params, &query.eclipsed_by(inside), Settings { paths: 16, seed: 1 });
    assert_eq!(field(refused.unwrap_err()), "moon.position");
}
