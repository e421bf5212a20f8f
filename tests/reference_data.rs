//! The f64 reference against numbers from other programs (`tests/data/README.md`).
//!
//! `cargo test --test all reference_data -- --nocapture` prints the differences file by file. The same for
//! the fine settings of multiple scattering: `cargo run --release --features reference --example
//! reference_table`.

use std::f64::consts::{FRAC_PI_2, PI};

use welkin::reference::multiple;
use welkin::reference::path::{self, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, optical_depth, single_scattering, transmittance};
use welkin::{AtmosphereParams, MiePhase};

use crate::harness::orders;
use crate::harness::tables::{Differences, Table, against_noise, medium, ray};

#[test]
fn transmittance_is_the_quadrature() {
    let table = Table::read("exact_transmittance.csv");
    let (mut depth, mut through) = (Differences::default(), Differences::default());
    for row in &table.rows {
        let params = medium(table.text(row, "atmosphere"));
        let query =
            RayQuery::new(table.number(row, "altitude_m"), table.angle(row, "view_zenith_deg"), 1.0, 0.0);
        let c = table.channel(row);
        let exact = table.number(row, "slant_optical_depth");
        let ours = optical_depth(&params, &query, Tolerance::TRUTH).unwrap()[c];
        depth.add((ours / exact - 1.0).abs(), row);
        let ours = transmittance(&params, &query, Tolerance::TRUTH).unwrap()[c];
        through.add((ours / table.number(row, "transmittance") - 1.0).abs(), row);
    }
    depth.report("exact_transmittance.csv: optical depth, relative");
    through.report("exact_transmittance.csv: transmittance, relative");
    // The table is good to 1e-9. So are we where it matters; a path of 1 m straight down is the difference of
    // two distances from the perigee at the planet's centre, and f64 holds those to 1e-9 m.
    assert!(depth.max < 4e-9, "{}", depth.worst);
    // Ten printed digits of a transmittance; large optical depths multiply the table's 1e-9.
    assert!(through.max < 1e-7, "{}", through.worst);
}

#[test]
fn single_scattering_is_the_quadrature() {
    for file in ["sky_rayleigh.csv", "sky_earth.csv", "limb.csv", "mc_twilight.csv"] {
        let table = Table::read(file);
        let (mut truth, mut picture) = (Differences::default(), Differences::default());
        for row in &table.rows {
            // The ground's colour does not matter to light that was scattered once, by the air.
            if table.number(row, "albedo") != 0.0 {
                continue;
            }
            let params = medium(match file {
                "sky_rayleigh.csv" => "rayleigh",
                "sky_earth.csv" => "earth",
                _ => table.text(row, "atmosphere"),
            });
            let query = ray(&table, row, params.planet_radius);
            let exact = table.number(row, "exact_single_per_sr");
            let c = table.channel(row);
            for (tolerance, differences) in
                [(Tolerance::TRUTH, &mut truth), (Tolerance::PICTURE, &mut picture)]
            {
                let ours =
                    single_scattering(&params, &query, Sun::Point, tolerance).unwrap().per_irradiance[c];
                if exact == 0.0 {
                    assert_eq!(ours, 0.0, "{row:?}");
                } else {
                    differences.add((ours / exact - 1.0).abs(), row);
                }
            }
        }
        truth.report(&format!("{file}: single, 1e-6, relative"));
        picture.report(&format!("{file}: single, 1e-3, relative"));
        // The table's accuracy and its six printed digits.
        assert!(truth.max < 1e-5, "{file}: {} at {}", truth.max, truth.worst);
        assert!(picture.max < 1e-3, "{file}: {} at {}", picture.max, picture.worst);
    }
}

#[test]
fn both_aerosol_phase_functions_are_the_quadrature() {
    let table = Table::read("exact_single_earth_cornette_shanks.csv");
    for (phase, column) in [
        (MiePhase::HenyeyGreenstein, "exact_single_HG_per_sr"),
        (MiePhase::CornetteShanks, "exact_single_cornette_shanks_per_sr"),
    ] {
        let params = AtmosphereParams { mie_phase: phase, ..medium("earth") };
        let mut differences = Differences::default();
        for row in &table.rows {
            let query = ray(&table, row, params.planet_radius);
            let ours = single_scattering(&params, &query, Sun::Point, Tolerance::TRUTH).unwrap();
            let (ours, exact) = (ours.per_irradiance[table.channel(row)], table.number(row, column));
            if exact == 0.0 {
                assert_eq!(ours, 0.0, "{row:?}");
            } else {
                differences.add((ours / exact - 1.0).abs(), row);
            }
        }
        differences.report(&format!("exact_single_earth_cornette_shanks.csv: {phase:?}"));
        assert!(differences.max < 1e-5, "{} at {}", differences.max, differences.worst);
    }
}

/// Direct irradiance, and that of the sky's single scattering, on level ground.
#[test]
fn ground_irradiance_of_single_scattering_is_the_quadrature() {
    let table = Table::read("mc_ground_irradiance.csv");
    let (mut direct, mut diffuse) = (Differences::default(), Differences::default());
    let mut sky: std::collections::HashMap<(String, String), [f64; 3]> = Default::default();
    for row in &table.rows {
        let params = medium(table.text(row, "atmosphere"));
        let sun = table.angle(row, "sun_zenith_deg");
        let c = table.channel(row);
        let exact = table.number(row, "direct_horizontal_irradiance_rel");
        let beam = transmittance(&params, &RayQuery::new(0.0, sun, sun, 0.0), Tolerance::TRUTH).unwrap();
        if exact > 0.0 {
            direct.add((beam[c] * sun.cos() / exact - 1.0).abs(), row);
        }
        let key = (table.text(row, "atmosphere").to_owned(), table.text(row, "sun_zenith_deg").to_owned());
        let ours = *sky.entry(key).or_insert_with(|| {
            // Midpoints in the angles, crowded towards the horizon; 96 × 48 directions.
            let (zeniths, azimuths) = (96, 48);
            let mut sum = [0.0; 3];
            for i in 0..zeniths {
                let u = (f64::from(i) + 0.5) / f64::from(zeniths);
                let view = FRAC_PI_2 * (1.0 - (1.0 - u) * (1.0 - u));
                let width = PI * (1.0 - u) / f64::from(zeniths);
                for j in 0..azimuths {
                    let azimuth = PI * (f64::from(j) + 0.5) / f64::from(azimuths);
                    let query = RayQuery::new(0.0, view, sun, azimuth);
                    let light = single_scattering(&params, &query, Sun::Point, Tolerance::PICTURE).unwrap();
                    let weight = 2.0 * PI / f64::from(azimuths) * width * view.sin() * view.cos();
                    sum = std::array::from_fn(|c| sum[c] + weight * light.per_irradiance[c]);
                }
            }
            sum
        });
        diffuse.add((ours[c] / table.number(row, "exact_single_diffuse_irradiance_rel") - 1.0).abs(), row);
    }
    direct.report("mc_ground_irradiance.csv: direct");
    diffuse.report("mc_ground_irradiance.csv: diffuse, single scattering");
    assert!(direct.max < 2e-6, "{} at {}", direct.max, direct.worst);
    // The midpoint rule of this test, not the library, sets the limit.
    assert!(diffuse.max < 1e-3, "{} at {}", diffuse.max, diffuse.worst);
}

/// All orders of scattering: sky, limb, twilight and the light on the ground, for one medium and albedo.
fn multiple_scattering(name: &str, albedo: f64) {
    let params = AtmosphereParams { ground_albedo: [albedo; 3], ..medium(name) };
    let orders = orders(&params, multiple::Settings::QUICK);
    for file in [format!("sky_{name}.csv"), "limb.csv".into(), "mc_twilight.csv".into()] {
        let table = Table::read(&file);
        let (mut relative, mut noise) = (Differences::default(), Differences::default());
        for row in &table.rows {
            let other = table.has("atmosphere") && table.text(row, "atmosphere") != name;
            if other || table.number(row, "albedo") != albedo {
                continue;
            }
            let light = orders.radiance(&ray(&table, row, params.planet_radius), Tolerance::PICTURE).unwrap();
            let ours = light.per_irradiance[table.channel(row)];
            let (mean, std_err) =
                (table.number(row, "mc_total_per_sr"), table.number(row, "mc_total_std_err_per_sr"));
            relative.add((ours / mean - 1.0).abs(), row);
            noise.add(against_noise(ours, mean, std_err), row);
        }
        relative.report(&format!("{file}: {name}, albedo {albedo}, all orders, relative"));
        noise.report(&format!("{file}: {name}, albedo {albedo}, of max(0.5 %, 4 σ)"));
        assert!(noise.max <= 1.0, "{file}: {} at {}", noise.max, noise.worst);
    }
    let table = Table::read("mc_ground_irradiance.csv");
    let mut noise = Differences::default();
    for row in &table.rows {
        if table.text(row, "atmosphere") != name || table.number(row, "albedo") != albedo {
            continue;
        }
        let ours = orders.ground_irradiance(table.angle(row, "sun_zenith_deg"));
        let c = table.channel(row);
        let direct = table.number(row, "direct_horizontal_irradiance_rel");
        assert!((ours.direct[c] - direct).abs() <= 2e-6 * direct + 1e-15, "{row:?} {ours:?}");
        let (mean, std_err) =
            (table.number(row, "mc_diffuse_irradiance_rel"), table.number(row, "mc_std_err"));
        noise.add(against_noise(ours.diffuse[c], mean, std_err), row);
    }
    noise.report(&format!("mc_ground_irradiance.csv: {name}, albedo {albedo}, of max(0.5 %, 4 σ)"));
    assert!(noise.max <= 1.0, "{} at {}", noise.max, noise.worst);
}

#[test]
fn multiple_scattering_in_gas_is_the_monte_carlo() {
    multiple_scattering("rayleigh", 0.0);
    multiple_scattering("rayleigh", 0.3);
}

#[test]
fn multiple_scattering_on_earth_is_the_monte_carlo() {
    // Black ground is in the example; here time counts.
    multiple_scattering("earth", 0.3);
}

/// Our path tracer against the other Monte Carlo: every 97th row, within 4.5 standard errors of both.
#[test]
fn path_tracing_is_the_monte_carlo() {
    let mut noise = Differences::default();
    for file in ["sky_earth.csv", "limb.csv", "mc_twilight.csv"] {
        let table = Table::read(file);
        for row in table.rows.iter().step_by(97) {
            let name = if file == "sky_earth.csv" { "earth" } else { table.text(row, "atmosphere") };
            let params = AtmosphereParams { ground_albedo: [table.number(row, "albedo"); 3], ..medium(name) };
            let query = ray(&table, row, params.planet_radius);
            let ours = path_trace(&params, &query, path::Settings { paths: 16_384, seed: 1 }).unwrap();
            let c = table.channel(row);
            let error = ours.std_err[c].hypot(table.number(row, "mc_total_std_err_per_sr"));
            noise.add((ours.per_irradiance[c] - table.number(row, "mc_total_per_sr")).abs() / error, row);
        }
    }
    noise.report("path tracing, standard errors");
    assert!(noise.max < 4.5, "{} at {}", noise.max, noise.worst);
    // Standard errors that are neither too large nor too small: the mean of |normal| is 0.80.
    assert!((0.5..1.1).contains(&(noise.sum / noise.count as f64)), "{}", noise.sum / noise.count as f64);
}
