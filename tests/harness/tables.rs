//! Tables of `tests/data` (see the README there), their rays, and how differences are summed up.

use std::path::Path;

use glam::DVec3;
use welkin::AtmosphereParams;
use welkin::reference::single::RayQuery;

/// A table, its columns by name.
pub struct Table {
    columns: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    pub fn read(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
        let mut reader = csv::Reader::from_path(path).unwrap();
        let columns = reader.headers().unwrap().iter().map(String::from).collect();
        let rows: Vec<Vec<String>> =
            reader.records().map(|r| r.unwrap().iter().map(String::from).collect()).collect();
        assert!(rows.len() > 40, "{name} has only {} rows", rows.len());
        Self { columns, rows }
    }

    pub fn text<'a>(&self, row: &'a [String], column: &str) -> &'a str {
        let i = self.columns.iter().position(|c| c == column).unwrap_or_else(|| panic!("no column {column}"));
        &row[i]
    }

    pub fn number(&self, row: &[String], column: &str) -> f64 {
        self.text(row, column).parse().unwrap()
    }

    pub fn angle(&self, row: &[String], column: &str) -> f64 {
        self.number(row, column).to_radians()
    }

    pub fn channel(&self, row: &[String]) -> usize {
        ["R", "G", "B"].iter().position(|c| *c == self.text(row, "channel")).unwrap()
    }

    pub fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|c| c == column)
    }
}

/// Differences of one comparison.
#[derive(Default)]
pub struct Differences {
    pub count: usize,
    pub sum: f64,
    pub max: f64,
    pub worst: String,
}

impl Differences {
    pub fn add(&mut self, difference: f64, case: &[String]) {
        assert!(difference.is_finite(), "{case:?}");
        self.count += 1;
        self.sum += difference;
        if difference > self.max {
            self.max = difference;
            self.worst = case.join(",");
        }
    }

    pub fn report(&self, name: &str) {
        let mean = self.sum / self.count as f64;
        println!("{name:52} n {:5}  mean {mean:.2e}  max {:.2e}  at {}", self.count, self.max, self.worst);
    }
}

/// A preset by name.
pub fn medium(name: &str) -> AtmosphereParams {
    AtmosphereParams::preset(name).unwrap()
}

/// The ray of a row of a sky or limb table.
pub fn ray(table: &Table, row: &[String], planet_radius: f64) -> RayQuery {
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

/// How far a result lies from a Monte Carlo mean, of what is allowed: the larger of 0.5 % and 4 standard
/// errors. Up to 1 is right.
pub fn against_noise(result: f64, mean: f64, std_err: f64) -> f64 {
    (result - mean).abs() / (0.005 * mean).max(4.0 * std_err)
}
