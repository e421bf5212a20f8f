//! The shaders' functions, term by term, against f64: on both backends, from one body.

use welkin::AtmosphereParams;
use welkin::frame::uniforms::MediumUniform;
use welkin::gpu::Backend;
use welkin::model::phase;
use welkin::probe::{self, BATCH, Case, Cases, Probe, Quantity, Record, Row, Tally};
use welkin::reference::single::{RayQuery, Tolerance, transmittance};

use crate::harness::{asked_for, on_both};

/// Of the grid of hard cases, then random ones.
const CASES: usize = 200_000;

fn judged(backend: &mut dyn Backend, count: usize) -> Tally {
    let mut tally = Tally::default();
    let mut cases = Cases::new(1);
    for batch in 0..count.div_ceil(BATCH) {
        let list: Vec<Case> = cases.by_ref().take(BATCH.min(count - batch * BATCH)).collect();
        for which in Probe::of_batch(batch as u64) {
            let answers = probe::run(backend, which, &list).unwrap();
            tally.add(probe::judge(which, batch * BATCH, &list, &answers));
        }
    }
    tally
}

#[test]
fn many_cases_keep_every_promise() {
    on_both(|backend| {
        let live = backend.live();
        let tally = judged(backend, asked_for("WELKIN_CASES", CASES));
        // Textures are freed.
        assert_eq!((live.textures, live.bind_groups), (backend.live().textures, backend.live().bind_groups));
        for (quantity, row) in &tally.rows {
            println!(
                "{:<33} {:>8} worst {:.1e} broken {}",
                quantity.name(),
                row.tried,
                row.worst,
                row.broken
            );
        }
        for f in &tally.findings {
            println!("{}: case {} got {} expected {}", f.quantity.name(), f.index, f.got, f.expected);
            println!("{}", probe::describe(&f.case));
        }
        assert_eq!(tally.rows.len(), probe::Quantity::ALL.len(), "a quantity was never judged");
        assert_eq!(tally.broken(), 0);
    });
}

/// Cases that no random seed need find again.
#[test]
fn rays_that_once_lost_the_shadow_keep_it() {
    let earth = MediumUniform::new(&AtmosphereParams::earth());
    let medium = |radius: f32, thickness: f32| MediumUniform { radius, thickness, ..earth };
    let ray = |medium, altitude, direction, sun| Case {
        medium,
        altitude,
        direction,
        sun,
        fraction: 0.5,
        ..Case::default()
    };
    let cases = [
        // 29 m of 71,656 km inside the shadow's edge, at the foot of a ray of 325,000 km: 190 km of shadow
        // were lost.
        ray(
            medium(71_656.39, 261_611.23),
            261_704.78,
            [0.0574992, -0.207118, -0.976_624_8],
            [0.634_123_44, 0.0, -0.773_231_86],
        ),
        // Towards the sun past the limb, from just outside a shell of two radii and from farther out.
        ray(
            medium(6360.0, 12_720.0),
            12_720.001,
            [1.0 / 3.0, 0.0, -0.942_809_05],
            [0.333_333_3, 0.0, -0.942_809_05],
        ),
        ray(
            medium(6360.0, 12_720.0),
            20_526.395,
            [0.236_560_58, 0.0, -0.971_616_74],
            [0.236_560_58, 0.0, -0.971_616_74],
        ),
    ];
    on_both(|backend| {
        let answers = probe::run(backend, Probe::Geometry, &cases).unwrap();
        let tally = probe::judge(Probe::Geometry, 0, &cases, &answers);
        assert!(tally.broken() == 0, "{:#?}", tally.findings);
        // Of the first, f64 has 132 to 239 km.
        let dark = answers[2][3] - answers[2][2];
        assert!((132.0..239.0).contains(&dark), "{dark} km of shadow");
        // Along the sun's own line its height is the ray's.
        assert_eq!(answers[9][0], answers[8][3], "r cos(sun) and r cos(zenith)");
    });
}

#[test]
fn a_record_is_kept_to_the_last_digit() {
    let row = Row {
        tried: 7,
        not_finite: 1,
        steep: 2,
        worst: 1.0 / 3.0,
        promise: 1e-3,
        used: (f64::INFINITY, 123_456),
        broken: 3,
    };
    let rows = [(Quantity::Length, row), (Quantity::Radiance, Row::default())].into();
    let tally = Tally { rows, findings: Vec::new() };
    let record = Record { about: "webgpu: a (b, c), d".into(), seed: u64::MAX, cases: 9, tally };
    let back = Record::load(&record.save()).unwrap();
    assert_eq!((&back.about, back.seed, back.cases), (&record.about, record.seed, record.cases));
    assert_eq!(back.tally.rows, record.tally.rows);
    let table = probe::side_by_side(&[back]);
    assert!(
        table.contains("| A | webgpu: a (b, c), d | 18446744073709551615 | 9 | 7 | 1 | 2 | 3 |"),
        "{table}"
    );
    let lines = record.save();
    let first = lines.lines().next().unwrap().len();
    for wrong in [
        "",
        &lines[..first],
        &lines.replace("seed", "weed"),
        &lines.replace('7', "seven"),
        &format!("{lines}\t1"),
    ] {
        let error = Record::load(wrong).unwrap_err();
        assert!(matches!(error.kind(), welkin::ErrorKind::Invalid { .. }), "{error}");
    }
}

/// Within 0.1 %, or 1e-6 of the brightest value, or less than f32 holds.
fn same(got: f32, want: f64, brightest: f64, what: &str) {
    let error = (f64::from(got) - want).abs();
    assert!(error <= (1e-3 * want).max(1e-6 * brightest).max(1e-30), "{what}: got {got}, reference {want}");
}

fn presets() -> Vec<AtmosphereParams> {
    AtmosphereParams::PRESETS.iter().map(|name| AtmosphereParams::preset(name).unwrap()).collect()
}

#[test]
fn densities_and_phases_are_the_reference_s() {
    let mut list = Vec::new();
    let aways = [0.0, 1e-12, 1e-7, 1e-4, 0.02, 0.3, 1.0, 1.7, 1.99, 2.0];
    for params in presets() {
        for asymmetry in [params.mie_asymmetry, [0.0, 0.5, -0.5], [0.999, -0.999, 0.76]] {
            let params = AtmosphereParams { mie_asymmetry: asymmetry, ..params.clone() };
            for altitude in [0.0, 1e-3, 1.7, 1000.0, 10e3, 24e3, 25e3, 26e3, 39.9e3, 80e3, 1e6] {
                for away in aways {
                    list.push((params.clone(), altitude, away));
                }
            }
        }
    }
    let cases: Vec<_> = list
        .iter()
        .map(|(params, altitude, away)| Case {
            medium: MediumUniform::new(params),
            altitude: (altitude / 1000.0) as f32,
            away: *away as f32,
            path_distance: 10.0,
            ..Case::default()
        })
        .collect();
    on_both(|backend| {
        let answers = probe::run(backend, Probe::Medium, &cases).unwrap();
        for ((params, altitude, away), a) in list.iter().zip(answers.chunks_exact(5)) {
            let cos = 1.0 - f64::from(*away as f32);
            for (c, density) in params.densities(*altitude).into_iter().enumerate() {
                same(a[0][c], density, 1.0, "density");
            }
            same(a[0][3], phase::rayleigh(cos), 0.1, "Rayleigh");
            let extinction = params.extinction(*altitude).map(|e| e * 1000.0);
            for c in 0..3 {
                same(a[1][c], extinction[c], extinction[2].max(extinction[0]), "extinction");
                let g = f64::from(params.mie_asymmetry[c] as f32);
                let (hg, cs) = (phase::henyey_greenstein(cos, g), phase::cornette_shanks(cos, g));
                same(a[2][c], hg, hg, "Henyey-Greenstein");
                same(a[3][c], cs, cs, "Cornette-Shanks");
                let tau = extinction[c] * 10.0;
                let mean = if tau > 1e-9 { -(-tau).exp_m1() / tau } else { 1.0 };
                same(a[4][c], mean, 1.0, "mean transmittance");
            }
        }
    });
}

/// With so many steps the shader's rule is the integral.
#[test]
fn columns_with_many_steps_are_the_reference_s() {
    const STEPS: f32 = 2048.0;
    let mut list = Vec::new();
    for params in presets() {
        for altitude in [0.0, 1.7, 5e3, 40e3, 0.9 * params.thickness()] {
            let r = params.planet_radius + altitude;
            let dip = (params.planet_radius / r).acos();
            for zenith in
                [0.0, 0.8, 1.4, 1.55, std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2 + 0.98 * dip]
            {
                list.push((params.clone(), altitude, zenith));
            }
        }
    }
    // Each constituent's column is the optical depth of a medium that holds only it.
    let only = |p: &AtmosphereParams, which: usize| {
        let one = |i: usize, f: f64| if i == which { [f; 3] } else { [0.0; 3] };
        AtmosphereParams {
            rayleigh_scattering: one(0, 1e-6),
            mie_scattering: one(1, 1e-6),
            mie_absorption: [0.0; 3],
            ozone_absorption: one(2, 1e-6),
            ..p.clone()
        }
    };
    let cases: Vec<_> = list
        .iter()
        .map(|(params, altitude, zenith)| {
            let (radius, h) = (params.planet_radius / 1000.0, altitude / 1000.0);
            let top = params.thickness() / 1000.0;
            let (x, b) = (h * (2.0 * radius + h), (radius + h) * zenith.cos());
            let c = top * (2.0 * radius + top) - x;
            let root = (b * b + c).sqrt();
            Case {
                medium: MediumUniform::new(params),
                path_excess: x as f32,
                path_r_mu: b as f32,
                path_distance: if b > 0.0 { c / (b + root) } else { root - b } as f32,
                samples: STEPS,
                ..Case::default()
            }
        })
        .collect();
    on_both(|backend| {
        let answers = probe::run(backend, Probe::Path, &cases).unwrap();
        for ((params, altitude, zenith), a) in list.iter().zip(answers.chunks_exact(2)) {
            let query = RayQuery::new(*altitude, *zenith, 0.0, 0.0);
            let depth = |which| {
                let p = only(params, which);
                welkin::reference::single::optical_depth(&p, &query, Tolerance::TRUTH).unwrap()[0] * 1e3
            };
            let columns = [0, 1, 2].map(depth);
            let longest = columns.into_iter().fold(0.0, f64::max);
            for c in 0..3 {
                same(a[0][c], columns[c], longest, &format!("column {c} at {altitude} m, {zenith} rad"));
            }
            let through = transmittance(params, &query, Tolerance::TRUTH).unwrap();
            for c in 0..3 {
                same(a[1][c], through[c], 1.0, &format!("transmittance at {altitude} m, {zenith} rad"));
            }
        }
    });
}
