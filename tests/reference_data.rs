//! The f64 reference against numbers from other programs (`tests/data/README.md`).
//!
//! `cargo test --test reference_data -- --nocapture` prints the differences file by file.

use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

use glam::DVec3;
use welkin::reference::single::{RayQuery, Sun, Tolerance, optical_depth, single_scattering, transmittance};
use welkin::{AtmosphereParams, MiePhase};

/// A table of `tests/data`, its columns by name.
struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn read(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
        let mut reader = csv::Reader::from_path(path).unwrap();
        let columns = reader.headers().unwrap().iter().map(String::from).collect();
        let rows: Vec<Vec<String>> = reader.records().map(|r| r.unwrap().iter().map(String::from).collect()).collect();
        assert!(rows.len() > 40, "{name} has only {} rows", rows.len());
        Self { columns, rows }
    }

    fn text<'a>(&self, row: &'a [String], column: &str) -> &'a str {
        let i = self.columns.iter().position(|c| c == column).unwrap_or_else(|| panic!("no column {column}"));
        &row[i]
    }

    fn number(&self, row: &[String], column: &str) -> f64 {
        self.text(row, column).parse().unwrap()
    }

    fn angle(&self, row: &[String], column: &str) -> f64 {
        self.number(row, column).to_radians()
    }

    fn channel(&self, row: &[String]) -> usize {
        ["R", "G", "B"].iter().position(|c| *c == self.text(row, "channel")).unwrap()
    }

    fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|c| c == column)
    }
}

/// Differences of one comparison.
#[derive(Default)]
struct Differences {
    count: usize,
    sum: f64,
    max: f64,
    worst: String,
}

impl Differences {
    fn add(&mut self, difference: f64, case: &[String]) {
        assert!(difference.is_finite(), "{case:?}");
        self.count += 1;
        self.sum += difference;
        if difference > self.max {
            self.max = difference;
            self.worst = case.join(",");
        }
    }

    fn report(&self, name: &str) {
        let mean = self.sum / self.count as f64;
        println!("{name:52} n {:5}  mean {mean:.2e}  max {:.2e}  at {}", self.count, self.max, self.worst);
    }
}

fn medium(name: &str) -> AtmosphereParams {
    AtmosphereParams::preset(name).unwrap()
}

/// The ray of a row of a sky or limb table.
fn ray(table: &Table, row: &[String], planet_radius: f64) -> RayQuery {
    let azimuth = table.angle(row, "azimuth_from_sun_deg");
    if !table.has("tangent_altitude_km") {
        let (view, sun) = (table.angle(row, "view_zenith_deg"), table.angle(row, "sun_zenith_deg"));
        return RayQuery::new(0.0, view, sun, azimuth);
    }
    // The tangent point lies on z, the ray runs along x; the observer is before it.
    let sun = table.angle(row, "sun_zenith_at_tangent_point_deg");
    let sun = DVec3::new(sun.sin() * azimuth.cos(), sun.sin() * azimuth.sin(), sun.cos());
    let tangent = 1e3 * table.number(row, "tangent_altitude_km");
    let observer = 1e3 * table.number(row, "observer_altitude_km");
    let back = ((observer - tangent) * (2.0 * planet_radius + observer + tangent)).sqrt();
    let position = DVec3::new(-back, 0.0, planet_radius + tangent);
    RayQuery::in_world(position, DVec3::X, sun, planet_radius).unwrap()
}

#[test]
fn transmittance_is_the_quadrature() {
    let table = Table::read("exact_transmittance.csv");
    let (mut depth, mut through) = (Differences::default(), Differences::default());
    for row in &table.rows {
        let params = medium(table.text(row, "atmosphere"));
        let query = RayQuery::new(table.number(row, "altitude_m"), table.angle(row, "view_zenith_deg"), 1.0, 0.0);
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
            for (tolerance, differences) in [(Tolerance::TRUTH, &mut truth), (Tolerance::PICTURE, &mut picture)] {
                let ours = single_scattering(&params, &query, Sun::Point, tolerance).unwrap().per_irradiance[c];
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
