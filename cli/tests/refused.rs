//! What `welkin render` refuses: with status 2, a message that names option, value and range, and no file.

use welkin::Quality;
use welkin::settings::front::ParetoFront;

use crate::harness::{self, WELKIN, files, folder, text, welkin};

/// `welkin render` with these options is not accepted.
#[track_caller]
fn rejected(args: &[&str], parts: &[&str]) {
    harness::rejected(WELKIN, &[&["render"], args].concat(), parts);
}

#[test]
fn wrong_numbers_are_rejected_with_option_value_and_range() {
    for (option, values, range) in [
        ("--pitch", &["90.1", "-91", "nan", "up", ""][..], "from -90.0 to 90.0 degrees"),
        ("--heading", &["361", "-inf", "NaN", "north"], "from -360.0 to 360.0 degrees"),
        ("--fov", &["0", "180", "-5", "nan", "inf"], "from 0.01 to 179.0 degrees"),
        ("--sun-elevation", &["nan", "90.5", "-1e3"], "from -90.0 to 90.0 degrees"),
        ("--sun-azimuth", &["NaN", "1e9", "-361"], "from -360.0 to 360.0 degrees"),
        ("--exposure", &["-1", "0", "nan", "inf", "1e7"], "from 1e-6 to 1000000.0"),
        ("--within-error", &["-1", "nan", "inf", "small"], "from 0.0 to 1000000.0"),
        ("--within-budget", &["5", "0ms", "-5ms", "nan", "fast"], "above 0 with a unit"),
        ("--samples", &["0", "-1", "1025", "8.5", "99999999999999999999"], "from 1 to 1024"),
        ("--light-samples", &["0", "-1", "257", "many"], "from 1 to 256"),
        ("--size", &["0x0", "0x720", "1280", "8193x1", "8192x8192", "-4x4", "nanxnan"], "from 1 to 8192"),
        ("--altitude", &["-4000km", "1e300km", "1e13m", "-1e13"], ""),
        ("--altitude", &["nan", "inf", "high", "12 miles", "km"], "metres"),
        ("--place", &["91,0", "0,181", "46.5", "nan,0", "46.5;8", ""], "-90 to 90"),
    ] {
        for value in values {
            rejected(&[option, value], &["error: ", option, &format!("'{value}'"), "must be", range]);
        }
    }
}

#[test]
fn altitude_names_the_range_of_its_planet() {
    rejected(
        &["--altitude", "-4000km"],
        &["--altitude", "'-4000km'", "-3,180 km", "earth", "1,000,000,000 km"],
    );
    rejected(
        &["--planet", "mars", "--altitude", "-2000 km"],
        &["--altitude", "'-2000 km'", "-1,694.8 km", "mars"],
    );
}

#[test]
fn unknown_names_are_rejected_with_the_known_ones() {
    rejected(&["--planet", "pluto"], &["'pluto'", "--planet", "earth, mars, venus, earth-like"]);
    rejected(&["--backend", "metal"], &["'metal'", "--backend", "auto, webgpu, webgl2, cpu"]);
    rejected(&["--tone-map", "hable"], &["'hable'", "--tone-map", "aces, agx, neutral"]);
    rejected(&["--view", "brunch"], &["'brunch'", "--view", "noon, sunset, dusk"]);
    let names: Vec<_> = welkin::Quality::PRESETS.iter().map(|(name, _)| *name).collect();
    rejected(&["--quality", "best"], &["'best'", "--quality", &names.join(", ")]);
    rejected(&["--zenith", "3"], &["--zenith"]);
}

#[test]
fn a_quality_is_asked_for_in_one_way() {
    let ways = [
        ("--quality", "low"),
        ("--within-error", "0.5"),
        ("--within-budget", "1s"),
        ("--samples", "8"),
        ("--light-samples", "8"),
    ];
    for (i, a) in ways.iter().enumerate() {
        // Samples and light samples go together.
        for b in ways.iter().skip(i + 1).filter(|b| !(a.0 == "--samples" && b.0 == "--light-samples")) {
            rejected(&[a.0, a.1, b.0, b.1], &[a.0, b.0, "cannot be used with"]);
        }
    }
}

#[test]
fn what_no_quality_can_do_is_rejected_with_the_best_that_one_can() {
    let front = ParetoFront::committed();
    let costs: Vec<_> = Quality::PRESETS.iter().map(|(_, q)| (q, front.cost(q).unwrap())).collect();
    let (best, cost) = costs.iter().min_by(|a, b| a.1.error.total_cmp(&b.1.error)).unwrap();
    let least = format!("{} or more", (cost.error * 1e3).ceil() / 1e3);
    rejected(
        &["--within-error", "1e-4"],
        &["--within-error", "'0.0001'", &least, best.preset_name().unwrap(), "all orders"],
    );
    rejected(
        &["--within-budget", "1ns", "--view", "noon", "--size", "16x16"],
        &["--within-budget", "ms or more", "quality ", "at 16×16 on "],
    );
    rejected(
        &["--within-budget", "1s", "--backend", "cpu"],
        &["--within-budget", "'1000 ms'", "GPU backend", "cpu"],
    );
}

#[test]
fn the_sun_is_placed_in_one_way() {
    let time = "2024-06-20T20:51:00Z";
    rejected(
        &["--sun-elevation", "5", "--place", "46.5,8", "--time", time],
        &["--sun-elevation 5", "--place", "cannot be used with"],
    );
    rejected(&["--sun-azimuth", "5", "--time", time], &["--sun-azimuth 5", "--time", "cannot be used with"]);
    rejected(&["--place", "46.5,8"], &["--place", "needs", "--time"]);
    rejected(&["--time", time], &["--time", "needs", "--place"]);
    rejected(
        &["--planet", "mars", "--place", "46.5,8", "--time", time],
        &["--planet", "'mars'", "earth", "--time"],
    );
    for bad in ["yesterday", "2024-06-20", "2024-06-20T20:51:00", "2024-02-30T00:00:00Z"] {
        rejected(&["--place", "46.5,8", "--time", bad], &["--time", bad, "RFC 3339"]);
    }
    let late = "3000-01-01T00:00:00Z";
    rejected(&["--place", "46.5,8", "--time", late], &["--time", late, "years 0000 to 2999"]);
}

/// What the CPU's reference, or a planet, does not have is not left out in silence.
#[test]
fn options_that_would_do_nothing_are_refused() {
    for given in [
        &["--quality", "high"][..],
        &["--within-error", "0.1"],
        &["--samples", "4"],
        &["--light-samples", "4"],
        &["--mode", "planet"],
        &["--airglow"],
        &["--all-effects"],
    ] {
        let cpu = ["--view", "noon", "--size", "8x4", "--backend", "cpu"];
        rejected(&[&cpu, given].concat(), &[given[0], "--backend cpu", "scattered once"]);
    }
    rejected(&["--view", "mars-day", "--airglow"], &["--planet", "'mars'", "Earth", "--airglow"]);
}

#[test]
fn outputs_that_cannot_be_are_found_before_drawing() {
    for bad in ["sky.jpg", "sky", "sky.", ".png", "sky.png.gz"] {
        rejected(&["--view", "noon", "-o", bad], &["--output", &format!("'{bad}'"), ".png, .exr or .hdr"]);
    }
    rejected(&["-o", "sky.exr"], &["--output", "'sky.exr'", ".png for the contact sheet"]);
    rejected(&["-o", "missing/sky.png"], &["--output", "'missing/sky.png'", "can be written"]);

    let folder = folder("taken");
    std::fs::create_dir(folder.join("sky.png")).unwrap();
    let out = welkin(&folder, &["render", "--view", "noon", "-o", "sky.png"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("sky.png"));
    assert_eq!(files(&folder), ["sky.png"]);
}

/// The edge of a very wide picture can lie almost 90° off even where the field of view is allowed.
#[test]
fn too_wide_a_view_is_rejected() {
    rejected(&["--fov", "179", "--size", "8192x1"], &["--fov", "--size", "8192x1", "179"]);
}

#[test]
fn a_rejected_request_leaves_an_older_file_alone() {
    let folder = folder("older");
    std::fs::write(folder.join("welkin.png"), "mine").unwrap();
    assert_eq!(welkin(&folder, &["render", "--fov", "180"]).status.code(), Some(2));
    assert_eq!(std::fs::read(folder.join("welkin.png")).unwrap(), b"mine");
}
