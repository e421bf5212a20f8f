//! How far the f64 reference is from its own limit: what changes when each of its sizes is doubled.
//!
//! ```text
//! cargo run --release --features reference --example reference_convergence [-- quick|fine]
//! ```
//!
//! All orders are solved with the settings that `welkin radiance` uses (for Mars on the coarser tables of
//! `Settings::QUICK`, else this would take ten minutes instead of six; `fine` does it), then once more with
//! each of the table sizes and quadratures halved: the doubling back is the change that is printed, in per
//! cent, the largest of the three channels, at fixed rays. Each next doubling brings less. Also: what is left
//! of the iteration (its tolerance ten times larger), and the tolerance of the integrals along a ray, which
//! single scattering has too. The last lines are one ray that Monte Carlo tables are 1.6 standard errors away
//! from, by tables with up to four times the altitudes and by path tracing. `quick` starts from coarse
//! settings everywhere.

use std::time::Instant;

use welkin::AtmosphereParams;
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::path::{self, path_trace};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};

/// Name, altitude in metres, zenith angle of the view (NaN: the tangent at 10 km), of the sun, azimuth,
/// degrees.
const RAYS: [(&str, f64, f64, f64, f64); 6] = [
    ("day", 0.0, 30.0, 60.0, 90.0),
    ("horizon", 0.0, 89.9, 60.0, 90.0),
    ("sunset", 0.0, 80.0, 90.0, 0.0),
    ("behind", 0.0, 89.9, 90.0, 180.0),
    ("twilight", 0.0, 85.0, 94.0, 0.0),
    ("limb", 400e3, f64::NAN, 70.0, 0.0),
];

fn rays(params: &AtmosphereParams) -> [RayQuery; 6] {
    RAYS.map(|(_, altitude, view, sun, azimuth)| {
        let r = params.planet_radius;
        let tangent = std::f64::consts::PI - ((r + 10e3) / (r + altitude)).min(1.0).asin();
        let view = if view.is_nan() { tangent } else { view.to_radians() };
        RayQuery::new(altitude, view, sun.to_radians(), azimuth.to_radians())
    })
}

type Light = [[f64; 3]; 6];

/// One line of the table: the largest channel's change at each ray, per cent.
fn line(what: &str, before: &Light, after: &Light, seconds: f64) {
    print!("{what:34}");
    for (before, after) in before.iter().zip(after) {
        let change = (0..3).map(|c| (before[c] / after[c] - 1.0).abs()).fold(0.0, f64::max);
        print!(" {:>9}", if change < 5e-7 { "<0.0001".into() } else { format!("{:.4}", 100.0 * change) });
    }
    println!("   {seconds:.0} s");
}

fn main() -> welkin::Result<()> {
    let asked = |word: &str| std::env::args().any(|a| a == word);
    let (quick, fine) = (asked("quick"), asked("fine"));
    let base = if quick { Settings::QUICK } else { Settings::FINE };
    for name in ["rayleigh", "earth", "mars"] {
        let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::preset(name)? };
        let base = if name == "mars" && !fine { Settings::QUICK } else { base };
        convergence(name, &params, base.for_medium(&params))?;
    }
    one_ray(base)
}

fn convergence(name: &str, params: &AtmosphereParams, fine: Settings) -> welkin::Result<()> {
    let rays = rays(params);
    println!("\n{name}: change in %, largest channel\n{fine:?}");
    print!("{:34}", "");
    RAYS.iter().for_each(|ray| print!(" {:>9}", ray.0));
    println!();
    let solve = |settings: Settings| -> welkin::Result<(Orders, Light, f64)> {
        let start = Instant::now();
        let orders = Orders::solve(params, settings, |_| {})?;
        if !orders.converged() {
            println!("not converged: {settings:?}");
        }
        let light = all_orders(&orders, &rays, Tolerance::TRUTH)?;
        Ok((orders, light, start.elapsed().as_secs_f64()))
    };
    let (orders, truth, seconds) = solve(fine)?;
    println!("{:94}   {seconds:.0} s", "solved");
    let half = |n: u32| n.div_ceil(2);
    let aerosol = params.mie_scattering.iter().any(|s| *s > 0.0);
    let coarser = [
        ("altitudes", fine.altitudes, Settings { altitudes: half(fine.altitudes), ..fine }),
        ("sun_angles", fine.sun_angles, Settings { sun_angles: half(fine.sun_angles), ..fine }),
        ("zeniths", fine.zeniths, Settings { zeniths: half(fine.zeniths), ..fine }),
        // As few as the degree allows: without aerosol that is 2.
        ("azimuths", fine.azimuths, {
            let degree = if aerosol { fine.degree } else { 2 };
            let azimuths = half(fine.azimuths).max(degree + 1);
            Settings { azimuths, degree, ..fine }
        }),
        ("degree", fine.degree, Settings { degree: half(fine.degree), ..fine }),
    ];
    for (what, to, settings) in coarser {
        let from = match what {
            "altitudes" => settings.altitudes,
            "sun_angles" => settings.sun_angles,
            "zeniths" => settings.zeniths,
            "azimuths" => settings.azimuths,
            _ if !aerosol => continue,
            _ => settings.degree,
        };
        let (_, light, seconds) = solve(settings)?;
        line(&format!("{what} {from} → {to}"), &light, &truth, seconds);
    }
    let tolerance = 10.0 * fine.tolerance;
    let (_, light, took) = solve(Settings { tolerance, ..fine })?;
    line(&format!("tolerance {tolerance:.0e} → {:.0e}", fine.tolerance), &light, &truth, took);
    let start = Instant::now();
    let light = all_orders(&orders, &rays, Tolerance { relative: 1e-5 })?;
    line("along the ray, 1e-5 → 1e-6", &light, &truth, start.elapsed().as_secs_f64());
    let once = |relative: f64| -> welkin::Result<Light> {
        let mut light = [[0.0; 3]; 6];
        for (light, ray) in light.iter_mut().zip(&rays) {
            *light = single_scattering(params, ray, Sun::Point, Tolerance { relative })?.per_irradiance;
        }
        Ok(light)
    };
    for (from, to) in [(1e-3, 1e-4), (1e-6, 1e-7)] {
        let start = Instant::now();
        let (before, after) = (once(from)?, once(to)?);
        let what = format!("single scattering, {from:.0e} → {to:.0e}");
        line(&what, &before, &after, start.elapsed().as_secs_f64());
    }
    Ok(())
}

fn all_orders(orders: &Orders, rays: &[RayQuery; 6], tolerance: Tolerance) -> welkin::Result<Light> {
    let mut light = [[0.0; 3]; 6];
    for (light, ray) in light.iter_mut().zip(rays) {
        *light = orders.radiance(ray, tolerance)?.per_irradiance;
    }
    Ok(light)
}

/// Blue light near the horizon, sun at 60°, in gas over black ground: 0.0586465 ± 0.0000663 in `tests/data`.
fn one_ray(base: Settings) -> welkin::Result<()> {
    let params = AtmosphereParams::rayleigh();
    let [_, ray, ..] = rays(&params);
    println!("\nrayleigh, black ground, horizon, blue");
    for altitudes in [1, 2, 4].map(|n| n * base.altitudes) {
        let orders = Orders::solve(&params, Settings { altitudes, ..base }, |_| {})?;
        println!(
            "{altitudes:4} altitudes   {:.7}",
            orders.radiance(&ray, Tolerance::TRUTH)?.per_irradiance[2]
        );
    }
    let traced = path_trace(&params, &ray, path::Settings { paths: 30_000_000, seed: 1 })?;
    println!("path tracing     {:.7} ± {:.7}", traced.per_irradiance[2], traced.std_err[2]);
    println!("tests/data       0.0586465 ± 0.0000663");
    Ok(())
}
