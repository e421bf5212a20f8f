//! The LUTs are as exact as promised: against Monte Carlo tables by day and at dusk, and against the
//! reference.
//!
//! `cargo test --test all accuracy -- --nocapture` prints the differences.

use std::collections::BTreeMap;
use std::path::Path;

use welkin::{AtmosphereParams, PictureRenderer, Quality, Scene};

use crate::harness::{View, draw, expected_picture, on_both, over_black, rgb, sky};

/// Mean, 95th percentile and largest.
fn figures(mut errors: Vec<f64>) -> [f64; 3] {
    assert!(errors.len() > 100 && errors.iter().all(|e| e.is_finite()), "{} values", errors.len());
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    [mean, errors[errors.len() * 95 / 100], errors[errors.len() - 1]]
}

/// A direction of view from the ground, and the Monte Carlo's light: red, green, blue.
struct Case {
    scene: Scene,
    sun: f64,
    want: [f64; 3],
}

/// A table of `tests/data`; neighbours share a medium and a sun.
fn cases(file: &str) -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(file);
    let mut cases: BTreeMap<[String; 5], Case> = BTreeMap::new();
    for row in csv::Reader::from_path(path).unwrap().deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let medium =
            row.get("atmosphere").map_or(if file.contains("earth") { "earth" } else { "rayleigh" }, |m| m);
        let names = ["albedo", "sun_zenith_deg", "view_zenith_deg", "azimuth_from_sun_deg"];
        let [albedo, sun, view, azimuth] = names.map(|n| row[n].parse::<f64>().unwrap());
        let key = [medium, &row[names[0]], &row[names[1]], &row[names[2]], &row[names[3]]].map(str::to_owned);
        let case = cases.entry(key).or_insert_with(|| {
            let params = AtmosphereParams {
                ground_albedo: [albedo; 3],
                sun_intensity: 1.0,
                ..AtmosphereParams::preset(medium).unwrap()
            };
            let view = View {
                params,
                altitude: 0.0,
                pitch: 90.0 - view,
                heading: azimuth,
                fov: 0.01,
                sun_elevation: 90.0 - sun,
                aspect: 1.0,
            };
            Case { scene: view.scene(), sun, want: [f64::NAN; 3] }
        });
        let c = ["R", "G", "B"].iter().position(|c| *c == row["channel"]).unwrap();
        case.want[c] = row["mc_total_per_sr"].parse().unwrap();
    }
    cases.into_values().collect()
}

#[test]
fn light_is_the_monte_carlos() {
    // File, and the bounds of mean, 95th percentile and maximum: by day 1, 3 and 8 % are promised, at dusk a
    // mean of 5 %. What is asked here is near what is measured.
    let tables_of = [
        ("sky_earth.csv", [0.004, 0.01, 0.015]),
        ("sky_rayleigh.csv", [0.003, 0.007, 0.02]),
        ("mc_twilight.csv", [0.01, 0.03, 0.08]),
    ];
    on_both(|b| {
        let name = b.info().backend;
        let mut renderer = PictureRenderer::default();
        for (file, bounds) in tables_of {
            let cases = cases(file);
            let mut errors = Vec::new();
            for case in &cases {
                assert_eq!(case.sun > 90.0, file.contains("twilight"));
                let pixels = draw(b, &mut renderer, &case.scene, &over_black(sky(Quality::MEDIUM)), [1, 1]);
                let got = rgb(&pixels, 0);
                errors.extend((0..3).map(|c| (got[c] / case.want[c] - 1.0).abs()));
            }
            let got = figures(errors);
            let percent = got.map(|e| format!("{:.2}", 100.0 * e)).join(" / ");
            println!("{name} {file}: {} cases, mean / 95th percentile / maximum {percent} %", cases.len());
            assert!((0..3).all(|i| got[i] <= bounds[i]), "{name} {file}: {got:?}, {bounds:?} allowed");
        }
        renderer.destroy(b);
    });
}

#[test]
fn dusk_is_the_references() {
    let size = [6, 6];
    let scenes: Vec<_> = [-2.0, -4.0, -6.0]
        .into_iter()
        .flat_map(|sun_elevation| [0.0, 90.0, 180.0].map(|heading| (sun_elevation, heading)))
        .map(|(sun_elevation, heading)| {
            View { altitude: 2.0, pitch: 50.0, fov: 80.0, heading, sun_elevation, ..View::default() }.scene()
        })
        .collect();
    let truths: Vec<_> = scenes.iter().map(|s| expected_picture(s, size)).collect();
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut errors = Vec::new();
        for (scene, want) in scenes.iter().zip(&truths) {
            let pixels = draw(b, &mut renderer, scene, &over_black(sky(Quality::MEDIUM)), size);
            errors.extend(want.iter().enumerate().flat_map(|(i, want)| {
                let got = rgb(&pixels, i);
                [0, 1, 2].map(|c| (got[c] / want[c] - 1.0).abs())
            }));
        }
        renderer.destroy(b);
        let got = figures(errors);
        println!("{} sun 92 to 96 degrees: mean, 95th percentile, maximum {got:.4?}", b.info().backend);
        assert!(got[0] <= 0.01 && got[1] <= 0.03 && got[2] <= 0.06, "{got:?}");
    });
}
