//! The f64 reference against numbers from other programs, at its finest: a table of differences and times.
//!
//! ```text
//! cargo run --release --features reference --example reference_table [-- quick]
//! ```
//!
//! Each line: file, sun, channel, rows, mean and largest relative difference, and the largest difference in
//! standard errors of the Monte Carlo mean that is compared with. The fine settings need about two minutes on
//! two cores, `quick` half of one.

use std::collections::BTreeMap;
use std::time::Instant;

use welkin::AtmosphereParams;
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{Sun, Tolerance, single_scattering};

#[path = "../tests/harness/tables.rs"]
#[allow(dead_code)] // The tests compare; this example only reads and writes.
mod tables;
use tables::{Table, against_noise, medium, ray};

#[derive(Default)]
struct Line {
    rows: usize,
    sum: f64,
    largest: f64,
    sigma: f64,
    failed: usize,
}

impl Line {
    fn add(&mut self, ours: f64, mean: f64, std_err: f64) {
        let relative = (ours / mean - 1.0).abs();
        self.rows += 1;
        self.sum += relative;
        self.largest = self.largest.max(relative);
        self.sigma = self.sigma.max((ours - mean).abs() / std_err);
        self.failed += usize::from(against_noise(ours, mean, std_err) > 1.0);
    }
}

fn main() -> welkin::Result<()> {
    let quick = std::env::args().any(|a| a == "quick");
    let settings = if quick { Settings::QUICK } else { Settings::FINE };
    println!("{settings:?}");
    for name in ["rayleigh", "earth"] {
        for albedo in [0.0, 0.3] {
            let params = AtmosphereParams { ground_albedo: [albedo; 3], ..medium(name) };
            let start = Instant::now();
            let orders = Orders::solve(&params, settings, |_| {})?;
            let solved = start.elapsed().as_secs_f64();
            println!("\n{name}, albedo {albedo}: {} iterations in {solved:.1} s", orders.history().len());
            compare(name, albedo, &orders)?;
        }
    }
    Ok(())
}

fn compare(name: &str, albedo: f64, orders: &Orders) -> welkin::Result<()> {
    let params = orders.params();
    let mut lines: BTreeMap<(String, u32, usize), Line> = BTreeMap::new();
    let (mut rays, mut single, mut all) = (0, 0.0, 0.0);
    for file in [format!("sky_{name}.csv"), "limb.csv".into(), "mc_twilight.csv".into()] {
        let table = Table::read(&file);
        for row in &table.rows {
            let other = table.has("atmosphere") && table.text(row, "atmosphere") != name;
            if other || table.number(row, "albedo") != albedo {
                continue;
            }
            let query = ray(&table, row, params.planet_radius);
            let start = Instant::now();
            single_scattering(params, &query, Sun::Point, Tolerance::PICTURE)?;
            single += start.elapsed().as_secs_f64();
            let start = Instant::now();
            let light = orders.radiance(&query, Tolerance::PICTURE)?;
            all += start.elapsed().as_secs_f64();
            rays += 1;
            let sun =
                ["sun_zenith_deg", "sun_zenith_at_tangent_point_deg"].iter().find(|c| table.has(c)).unwrap();
            let sun = table.number(row, sun) as u32;
            let c = table.channel(row);
            lines.entry((file.clone(), sun, c)).or_default().add(
                light.per_irradiance[c],
                table.number(row, "mc_total_per_sr"),
                table.number(row, "mc_total_std_err_per_sr"),
            );
        }
    }
    let table = Table::read("mc_ground_irradiance.csv");
    for row in &table.rows {
        if table.text(row, "atmosphere") == name && table.number(row, "albedo") == albedo {
            let light = orders.ground_irradiance(table.angle(row, "sun_zenith_deg"));
            let c = table.channel(row);
            lines.entry(("diffuse irradiance of the ground".into(), 0, c)).or_default().add(
                light.diffuse[c],
                table.number(row, "mc_diffuse_irradiance_rel"),
                table.number(row, "mc_std_err"),
            );
        }
    }
    for ((file, sun, c), line) in &lines {
        println!(
            "{file:34} sun {sun:2}° {}  n {:3}  mean {:.1e}  max {:.1e}  {:5.1} σ  outside max(0.5 %, 4 \
             σ): {}",
            ["R", "G", "B"][*c],
            line.rows,
            line.sum / line.rows as f64,
            line.largest,
            line.sigma,
            line.failed
        );
    }
    let per_ray = 1e6 / f64::from(rays);
    println!(
        "{:.0} µs a ray for single scattering, {:.0} µs for all orders",
        single * per_ray,
        all * per_ray
    );
    Ok(())
}
