//! `welkin radiance`, compared with other programs (`tests/data/README.md`).
//!
//! `cargo test -p welkin-cli --test main radiance -- --nocapture` prints the differences.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Output;
use std::sync::OnceLock;

use glam::DVec3;
use welkin::AtmosphereParams;
use welkin::reference::multiple::{Orders, Settings};

use crate::harness::{self, printed, text, welkin};

const HEADER: &str = "medium,albedo,altitude_m,sun_zenith_deg,view_zenith_deg,azimuth_from_sun_deg";
const GOOD: &str = "earth,0.3,0,60,30,90";

/// Runs `welkin radiance`.
fn radiance(folder: &Path, args: &[&str]) -> Output {
    welkin(folder, &[&["radiance"], args].concat())
}

/// A direction of view under a sky, and what other programs say of it: red, green, blue.
#[derive(Clone, Debug, Default)]
struct Case {
    sun_zenith: f64,
    row: String,
    single: [f64; 3],
    total: [f64; 3],
    total_error: [f64; 3],
}

/// A new empty folder; the test works inside it.
fn folder(name: &str) -> PathBuf {
    harness::folder(&format!("radiance-{name}"))
}

/// The cases of a table, one for each three rows.
fn cases(file: &str) -> Vec<Case> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data").join(file);
    let mut cases: BTreeMap<String, Case> = BTreeMap::new();
    for row in csv::Reader::from_path(path).unwrap().deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        let medium = row
            .get("atmosphere")
            .map_or(if file.contains("earth") { "earth" } else { "rayleigh" }, String::as_str);
        let azimuth = number("azimuth_from_sun_deg");
        let [altitude, sun, view, azimuth] = if row.contains_key("tangent_altitude_km") {
            from_tangent_point(
                number("observer_altitude_km"),
                number("tangent_altitude_km"),
                number("sun_zenith_at_tangent_point_deg"),
                azimuth,
            )
        } else {
            [0.0, number("sun_zenith_deg"), number("view_zenith_deg"), azimuth]
        };
        let key = format!("{medium},{},{altitude},{sun},{view},{azimuth}", row["albedo"]);
        let case = cases.entry(key.clone()).or_insert(Case { sun_zenith: sun, row: key, ..Case::default() });
        let c = ["R", "G", "B"].iter().position(|c| *c == row["channel"]).unwrap();
        case.single[c] = number("exact_single_per_sr");
        case.total[c] = number("mc_total_per_sr");
        case.total_error[c] = number("mc_total_std_err_per_sr");
    }
    let cases: Vec<_> = cases.into_values().collect();
    assert!(cases.len() > 40, "{file} has only {} cases", cases.len());
    assert!(cases.iter().all(|c| c.total.iter().all(|v| *v > 0.0)), "{file}: a channel is missing");
    cases
}

/// Altitude in metres, zenith angles of sun and view and the azimuth between them in degrees, all at the
/// observer, for a horizontal ray at a tangent point; altitudes in km, angles in degrees.
fn from_tangent_point(observer: f64, tangent: f64, sun_zenith: f64, azimuth: f64) -> [f64; 4] {
    let (tangent, radius) = (6360.0 + tangent, 6360.0 + observer);
    let back = ((radius - tangent) * (radius + tangent)).sqrt();
    let (z, a) = (sun_zenith.to_radians(), azimuth.to_radians());
    let sun = DVec3::new(z.sin() * a.cos(), z.sin() * a.sin(), z.cos());
    let zenith = DVec3::new(-back, 0.0, tangent) / radius;
    let ahead = DVec3::new(tangent, 0.0, back) / radius;
    let angle = |across: f64, along: f64| across.atan2(along).to_degrees();
    let flat = sun - zenith * sun.dot(zenith);
    [
        1e3 * observer,
        angle(flat.length(), sun.dot(zenith)),
        angle(tangent, -back),
        angle(flat.y.abs(), flat.dot(ahead)),
    ]
}

/// Runs the command; the answers in the order of the cases.
fn answers(folder: &Path, cases: &[Case], args: &[&str]) -> Vec<[f64; 3]> {
    asked(folder, cases, args).0
}

/// The same, and what it said on stdout and on stderr.
fn asked(folder: &Path, cases: &[Case], args: &[&str]) -> (Vec<[f64; 3]>, String, String) {
    let table: String = std::iter::once(HEADER)
        .chain(cases.iter().map(|c| c.row.as_str()))
        .map(|l| format!("{l}\n"))
        .collect();
    std::fs::write(folder.join("cases.csv"), table).unwrap();
    let out = radiance(folder, &[&["--cases", "cases.csv", "--output", "out.csv"], args].concat());
    assert!(out.status.success(), "{args:?}: {}", text(&out.stderr));
    print!("{}", text(&out.stdout));
    let mut reader = csv::Reader::from_path(folder.join("out.csv")).unwrap();
    assert_eq!(reader.headers().unwrap().iter().skip(6).collect::<Vec<_>>(), ["R", "G", "B"]);
    let rows: Vec<_> = reader.records().map(|r| r.unwrap()).collect();
    assert_eq!(rows.len(), cases.len());
    let light = rows.iter().map(|r| [6, 7, 8].map(|c| r[c].parse().unwrap())).collect();
    (light, text(&out.stdout), text(&out.stderr))
}

/// Largest relative difference, and where.
fn worst<'a>(pairs: impl Iterator<Item = (&'a Case, [f64; 3])>) -> (f64, String) {
    let mut worst = (0.0, String::new());
    let mut count = 0;
    for (case, got) in pairs {
        for (got, want) in got.into_iter().zip(case.single) {
            count += 1;
            let difference = if want == 0.0 { got.abs() } else { (got / want - 1.0).abs() };
            assert!(difference.is_finite());
            if difference > worst.0 {
                worst = (difference, case.row.clone());
            }
        }
    }
    assert!(count > 100, "only {count} values to compare");
    worst
}

#[test]
fn single_is_the_quadrature_on_both_backends() {
    let folder = folder("single");
    let files = ["sky_rayleigh.csv", "sky_earth.csv", "limb.csv", "mc_twilight.csv"];
    let cases: Vec<_> = files.into_iter().flat_map(cases).collect();
    for backend in ["webgpu", "webgl2"] {
        let ask = |light_samples| {
            let args = ["--method", "single", "--backend", backend, "--samples", "256"];
            answers(&folder, &cases, &[&args[..], &["--light-samples", light_samples]].concat())
        };
        let (coarse, fine) = (ask("64"), ask("128"));
        // A sun near or below the horizon shines along the ground, through 1000 km of air: 64 steps of that
        // leave up to 0.13 % in the darkest directions, opposite the sun; twice as many a quarter of it.
        let high = |c: &Case| c.sun_zenith <= 85.0 || c.row.contains(",200000,");
        let pairs = |light: &[[f64; 3]]| cases.iter().zip(light.to_vec()).collect::<Vec<_>>();
        let day = worst(pairs(&coarse).into_iter().filter(|(c, _)| high(c)));
        let low = worst(pairs(&coarse).into_iter().filter(|(c, _)| !high(c)));
        let low_fine = worst(pairs(&fine).into_iter().filter(|(c, _)| !high(c)));
        println!("{backend}: 256 × 64 high sun {:.2e} at {}", day.0, day.1);
        println!("{backend}: 256 × 64 low sun  {:.2e} at {}", low.0, low.1);
        println!("{backend}: 256 × 128 low sun {:.2e} at {}", low_fine.0, low_fine.1);
        assert!(day.0 < 1e-3, "{backend}: {day:?}");
        assert!(low_fine.0 < 1e-3 && low_fine.0 < 0.5 * low.0, "{backend}: {low:?} {low_fine:?}");
    }
}

#[test]
fn reference_single_is_the_quadrature() {
    let folder = folder("reference-single");
    let files = ["sky_rayleigh.csv", "sky_earth.csv", "limb.csv", "mc_twilight.csv"];
    let cases: Vec<_> = files.into_iter().flat_map(cases).collect();
    let light = answers(&folder, &cases, &["--method", "reference-single"]);
    let (worst, at) = worst(cases.iter().zip(light));
    // Six printed digits.
    assert!(worst < 1e-5, "{worst:.2e} at {at}");
}

/// One medium and albedo, which is one solution; every fifth direction of the Monte Carlo tables.
fn one_solution() -> Vec<Case> {
    ["sky_rayleigh.csv", "mc_twilight.csv", "limb.csv"]
        .into_iter()
        .flat_map(|file| cases(file).into_iter().filter(|c| c.row.starts_with("rayleigh,0,")).step_by(5))
        .collect()
}

/// What the reference said of [`one_solution`], with `out.csv` and its solution in `cache` in the folder.
struct Solved {
    folder: PathBuf,
    light: Vec<[f64; 3]>,
    said: String,
    notes: String,
    /// The file that was there before it was asked: a solution of which the end is missing.
    damaged: PathBuf,
}

/// Solved once for all tests, which takes half a minute.
fn solved() -> &'static Solved {
    static SOLVED: OnceLock<Solved> = OnceLock::new();
    SOLVED.get_or_init(|| {
        let folder = folder("reference");
        let params =
            AtmosphereParams { ground_albedo: [0.0; 3], sun_intensity: 1.0, ..AtmosphereParams::rayleigh() };
        let coarse = Settings {
            altitudes: 6,
            sun_angles: 12,
            zeniths: 4,
            azimuths: 6,
            degree: 4,
            max_iterations: 9,
            tolerance: 0.1,
        };
        let other = Orders::solve(&params, coarse, |_| {}).unwrap().to_bytes();
        std::fs::create_dir(folder.join("cache")).unwrap();
        let key = Orders::key(&params, &Settings::FINE);
        let damaged = folder.join("cache").join(format!("orders-{key:032x}"));
        std::fs::write(&damaged, &other[..other.len() - 100]).unwrap();
        let (light, said, notes) = asked(&folder, &one_solution(), &["--method", "reference"]);
        Solved { folder, light, said, notes, damaged }
    })
}

#[test]
fn reference_is_the_monte_carlo() {
    let cases = one_solution();
    let light = &solved().light;
    let mut worst = (0.0, String::new());
    for (case, got) in cases.iter().zip(light) {
        for c in 0..3 {
            let allowed = (0.005 * case.total[c]).max(4.0 * case.total_error[c]);
            let share = (got[c] - case.total[c]).abs() / allowed;
            if share > worst.0 {
                worst = (share, case.row.clone());
            }
            // Multiple scattering only adds.
            assert!(got[c] > case.single[c], "{case:?} {got:?}");
        }
    }
    println!("{} cases, worst {:.2} of the larger of 0.5 % and 4 sigma at {}", cases.len(), worst.0, worst.1);
    assert!(cases.len() > 40);
    assert!(worst.0 < 1.0, "{worst:?}");
}

/// A solution from the cache gives what solving gives; one that was damaged is not used, and said.
#[test]
fn kept_solutions_change_no_result() {
    let Solved { folder: solved, said, notes, damaged, .. } = solved();
    assert!(!said.contains("cache"), "{said}");
    assert!(notes.contains("damaged") && notes.contains("solved again"), "{notes}");
    let fresh = std::fs::read(solved.join("out.csv")).unwrap();
    let folder = folder("kept");
    std::fs::copy(solved.join("cases.csv"), folder.join("cases.csv")).unwrap();
    let ask = |more: &[&str]| {
        let _ = std::fs::remove_file(folder.join("out.csv"));
        let args = ["--cases", "cases.csv", "--method", "reference", "--output", "out.csv"];
        let out = radiance(&folder, &[&args, more].concat());
        let said = printed(&out);
        (std::fs::read(folder.join("out.csv")).unwrap(), said, text(&out.stderr))
    };
    let kept = |folder: &Path| -> Vec<PathBuf> {
        let files = std::fs::read_dir(folder.join("cache")).into_iter().flatten();
        files.map(|f| f.unwrap().path()).collect()
    };
    // Solving left one file, in the place of the damaged one, and it is whole.
    assert_eq!(kept(solved), std::slice::from_ref(damaged));
    std::fs::create_dir(folder.join("cache")).unwrap();
    let ours = folder.join("cache").join(damaged.file_name().unwrap());
    std::fs::copy(damaged, &ours).unwrap();
    let (second, said, notes) = ask(&[]);
    assert!(second == fresh, "{}\n{}", text(&fresh), text(&second));
    assert!(said.contains("(solution from the cache)") && !notes.contains("note:"), "{said} {notes}");
    assert!(std::fs::read(&ours).unwrap() == std::fs::read(damaged).unwrap() && kept(&folder) == [ours]);
    // A folder that the option names goes before the variable's.
    std::fs::rename(folder.join("cache"), folder.join("other")).unwrap();
    let (elsewhere, said, _) = ask(&["--cache-dir", "other"]);
    assert!(elsewhere == fresh && said.contains("from the cache") && kept(&folder).is_empty(), "{said}");
}

#[test]
fn columns_come_in_any_order_and_others_are_copied() {
    let folder = folder("columns");
    let table = "note,view_zenith_deg,medium,sun_zenith_deg,azimuth_from_sun_deg,albedo,altitude_m,id\n\
                 \"up, left\",30,earth,60,90,0.3,0,007\n,30,earth,60,90,0.9,0, x\n";
    std::fs::write(folder.join("in.csv"), table).unwrap();
    let out =
        radiance(&folder, &["--cases", "in.csv", "--method", "reference-single", "--output", "out.csv"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let written = std::fs::read_to_string(folder.join("out.csv")).unwrap();
    let lines: Vec<_> = written.lines().collect();
    assert_eq!(lines.len(), 3);
    assert_eq!(lines[0], format!("{},R,G,B", table.lines().next().unwrap()));
    assert!(lines[1].starts_with("\"up, left\",30,earth,60,90,0.3,0,007,"), "{}", lines[1]);
    assert!(lines[2].starts_with(",30,earth,60,90,0.9,0, x,"), "{}", lines[2]);
    // The ground's albedo does not enter light that the air scattered once.
    let last = |line: &str| line.rsplit(',').take(3).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(last(lines[1]), last(lines[2]));
}

/// Light and transmittance up to a surface, in a medium of a file too, are the same by every method within
/// what each promises; and where no surface is, the whole ray's.
#[test]
fn a_surface_ends_the_ray() {
    let folder = folder("surface");
    let earth = AtmosphereParams::earth();
    let [scattering, absorption] = [earth.mie_scattering, earth.mie_absorption].map(|v| v.map(|v| 400.0 * v));
    let haze = format!(
        "mie_scattering = {scattering:?}\nmie_absorption = {absorption:?}\nmie_asymmetry = [0.7, 0.7, 0.7]\n"
    );
    std::fs::write(folder.join("haze.toml"), haze).unwrap();
    let rows = [
        "earth,0.3,300,60,90,60,20000",
        "earth,0.3,300,60,90.1,60,20000",
        "earth,0.3,300,60,30,60,",
        "earth,0.3,60000,60,97,60,1000000",
        "haze.toml,0.3,300,60,90,60,1000",
        "haze.toml,0.3,1000,60,90,60,5000",
    ];
    let table: String =
        [format!("{HEADER},distance_m").as_str()].iter().chain(&rows).map(|l| format!("{l}\n")).collect();
    std::fs::write(folder.join("in.csv"), table).unwrap();
    let ask = |args: &[&str]| -> Vec<[f64; 6]> {
        let out = radiance(&folder, &[&["--cases", "in.csv", "--output", "out.csv"], args].concat());
        assert!(out.status.success(), "{args:?}: {}", text(&out.stderr));
        let mut reader = csv::Reader::from_path(folder.join("out.csv")).unwrap();
        let header: Vec<_> = reader.headers().unwrap().iter().skip(7).map(str::to_owned).collect();
        assert_eq!(header, ["R", "G", "B", "T_R", "T_G", "T_B"]);
        reader
            .records()
            .map(|row| std::array::from_fn(|i| row.as_ref().unwrap()[7 + i].parse().unwrap()))
            .collect()
    };
    let reference = ask(&["--method", "reference-single"]);
    // Blue over 20 km of Earth's air; a kilometre of thick haze, and five.
    for (row, channel, right) in [(0, 5, 0.491), (4, 3, 0.25), (5, 3, 0.02)] {
        let got = reference[row][channel];
        assert!((got - right).abs() < 0.01, "{}: {got}", rows[row]);
    }
    for backend in ["webgpu", "webgl2"] {
        for (method, light) in
            [(&["single", "--samples", "128", "--light-samples", "128"][..], 0.01), (&["lut"], 0.0)]
        {
            let got = ask(&[&["--backend", backend, "--method"], method].concat());
            for (row, (got, want)) in got.iter().zip(&reference).enumerate() {
                let name = format!("{backend} {method:?} {}: {got:?} {want:?}", rows[row]);
                for c in 0..3 {
                    assert!((got[3 + c] - want[3 + c]).abs() < 1e-3, "{name}");
                    let off = got[c] / want[c] - 1.0;
                    // Light of all orders is more than what was scattered once.
                    assert!(if light > 0.0 { off.abs() < light } else { off > -0.01 }, "{name}");
                }
            }
        }
    }
}

/// Exit status 2, a message with all of `parts`, and no output.
#[track_caller]
fn rejected(name: &str, table: &[u8], args: &[&str], parts: &[&str]) {
    let folder = folder(&format!("rejected-{name}"));
    std::fs::write(folder.join("in.csv"), table).unwrap();
    let given = |option| args.contains(&option);
    let cases = if given("--cases") { &[][..] } else { &["--cases", "in.csv"] };
    let to = if given("--output") { &[][..] } else { &["--output", "out.csv"] };
    let out = radiance(&folder, &[cases, to, args].concat());
    let message = text(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{name}: {message}");
    for part in parts {
        assert!(message.contains(part), "{name}: no {part:?} in: {message}");
    }
    assert!(!message.contains("panicked") && !message.contains("internal"), "{message}");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "{name} left a file");
}

#[test]
fn a_bad_row_is_named_by_its_line_and_nothing_is_written() {
    let single = &["--method", "reference-single"];
    for (name, row, parts) in [
        ("medium", "pluto,0,0,0,0,0", &["medium 'pluto'", "earth, mars, venus, earth-like, rayleigh"][..]),
        ("albedo", "earth,1.1,0,0,0,0", &["albedo '1.1'", "from 0 to 1"]),
        ("altitude", "earth,0,-1,0,0,0", &["altitude_m '-1'", "from 0 to 1000000000000"]),
        ("sun", "earth,0,0,181,0,0", &["sun_zenith_deg '181'", "from 0 to 180"]),
        ("view", "earth,0,0,0,-0.1,0", &["view_zenith_deg '-0.1'", "from 0 to 180"]),
        ("azimuth", "earth,0,0,0,0,361", &["azimuth_from_sun_deg '361'", "from -360 to 360"]),
        ("nan", "earth,0,0,nan,0,0", &["sun_zenith_deg 'nan'"]),
        ("infinite", "earth,0,inf,0,0,0", &["altitude_m 'inf'"]),
        ("empty", "earth,,0,0,0,0", &["albedo ''"]),
        ("word", "earth,0,high,0,0,0", &["altitude_m 'high'"]),
        ("file", "none.toml,0,0,0,0,0", &["medium 'none.toml'", "cannot be read"]),
        ("short", "earth,0,0,0,0", &["5 values", "6 columns"]),
        ("long", "earth,0,0,0,0,0,0", &["7 values", "6 columns"]),
    ] {
        let table = format!("{HEADER}\n{GOOD}\n{row}\n{GOOD}\n");
        rejected(name, table.as_bytes(), single, &[&["in.csv, line 3:"], parts].concat());
    }
    rejected("utf8", &[HEADER.as_bytes(), b"\nearth,0,0,\xff,0,0\n"].concat(), single, &["line 2", "UTF-8"]);
}

#[test]
fn a_bad_header_or_request_is_rejected() {
    let single = &["--method", "reference-single"];
    let table = format!("{HEADER}\n{GOOD}\n");
    rejected("nothing", b"", single, &["line 1", "no column 'medium'"]);
    rejected(
        "missing",
        table.replace("albedo", "whiteness").as_bytes(),
        single,
        &["line 1", "no column 'albedo'"],
    );
    rejected(
        "twice",
        format!("{HEADER},albedo\n{GOOD},0\n").as_bytes(),
        single,
        &["column 'albedo' is there twice"],
    );
    rejected("taken", format!("{HEADER},R\n{GOOD},0\n").as_bytes(), single, &["column 'R'", "rename"]);
    let good = table.as_bytes();
    rejected("method", good, &["--method", "exact"], &["'exact'", "single", "reference-single"]);
    rejected("no-method", good, &[], &["--method"]);
    rejected("samples", good, &["--method", "single", "--samples", "0"], &["--samples", "from 1 to 1024"]);
    rejected(
        "cpu",
        good,
        &["--method", "single", "--backend", "cpu"],
        &["--backend", "'cpu'", "reference-single"],
    );
    rejected(
        "gpu",
        good,
        &["--method", "reference", "--backend", "webgl2"],
        &["--backend", "'webgl2'", "CPU"],
    );
    rejected(
        "no-file",
        good,
        &["--method", "reference-single", "--cases", "none.csv"],
        &["--cases", "'none.csv'", "can be read"],
    );
    rejected(
        "unwritable",
        good,
        &["--method", "reference-single", "--output", "no/out.csv"],
        &["--output", "'no/out.csv'", "can be written"],
    );
}

/// llvmpipe ends loops early and says nothing; the tool does.
#[test]
fn more_steps_than_the_driver_takes_are_rejected() {
    let folder = folder("steps");
    std::fs::write(folder.join("in.csv"), format!("{HEADER}\n{GOOD}\n")).unwrap();
    let args = ["--cases", "in.csv", "--output", "out.csv", "--method", "single"];
    let many = radiance(&folder, &[&args[..], &["--samples", "1024", "--light-samples", "256"]].concat());
    let message = text(&many.stderr);
    // On other adapters it works.
    if many.status.success() {
        return;
    }
    assert_eq!(many.status.code(), Some(2), "{message}");
    assert!(message.contains("65535") && message.contains("llvmpipe"), "{message}");
    assert!(!folder.join("out.csv").exists());
}
