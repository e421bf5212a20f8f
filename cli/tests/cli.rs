//! The command-line tool as a user meets it: the built binary, its messages, its files.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use welkin::Quality;
use welkin::settings::quality::Front;

/// A new empty folder; the test works inside it.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_welkin"));
    // Mesa complains on stderr where this is not set, and stderr is what some tests look at.
    command.args(args).current_dir(folder).stdin(Stdio::null()).env("XDG_RUNTIME_DIR", env!("CARGO_TARGET_TMPDIR"));
    command
}

fn welkin(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn help_teaches_every_option() {
    let folder = folder("help");
    let long = welkin(&folder, &["render", "--help"]);
    assert!(long.status.success());
    let long = text(&long.stdout);
    for option in [
        "--view",
        "--planet",
        "--altitude",
        "--pitch",
        "--heading",
        "--fov",
        "--sun-elevation",
        "--sun-azimuth",
        "--place",
        "--time",
        "--size",
        "--exposure",
        "--quality",
        "--within-error",
        "--within-budget",
        "--samples",
        "--light-samples",
        "--tone-map",
        "--no-dither",
        "--backend",
        "--no-terrain",
        "--output",
        "-o,",
        "View:",
        "Picture:",
        "Examples:",
        "Exit status:",
    ] {
        assert!(long.contains(option), "{option} is missing from:\n{long}");
    }
    let short = text(&welkin(&folder, &["--help"]).stdout);
    assert!(short.contains("render") && short.contains("info"), "{short}");
    assert!(text(&welkin(&folder, &["--version"]).stdout).contains(env!("CARGO_PKG_VERSION")));
    let nothing = welkin(&folder, &[]);
    assert_eq!(nothing.status.code(), Some(2));
    assert!(text(&nothing.stderr).contains("render"));
}

/// Exit status 2, a message with all of `parts`, and nothing in the folder.
#[track_caller]
fn rejected(args: &[&str], parts: &[&str]) {
    rejected_by("render", args, parts);
}

#[track_caller]
fn rejected_by(subcommand: &str, args: &[&str], parts: &[&str]) {
    // Tests run at the same time: a folder for each.
    let name: String = [&[subcommand], args]
        .concat()
        .join("_")
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' })
        .collect();
    let folder = folder(&format!("rejected-{name}"));
    let out = welkin(&folder, &[&[subcommand], args].concat());
    let message = text(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{args:?}: {message}");
    assert!(out.stdout.is_empty(), "{args:?}");
    for part in parts {
        assert!(message.contains(part), "{args:?}: no {part:?} in: {message}");
    }
    assert!(!message.contains("panicked"), "{message}");
    assert_eq!(files(&folder), [""; 0], "{args:?}");
    std::fs::remove_dir(&folder).unwrap();
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
    rejected(&["--altitude", "-4000km"], &["--altitude", "'-4000km'", "-3,180 km", "earth", "1,000,000,000 km"]);
    rejected(&["--planet", "mars", "--altitude", "-2000 km"], &["--altitude", "'-2000 km'", "-1,694.8 km", "mars"]);
}

#[test]
fn unknown_names_are_rejected_with_the_known_ones() {
    rejected(&["--planet", "pluto"], &["'pluto'", "--planet", "earth, mars, venus, earth-like"]);
    rejected(&["--backend", "metal"], &["'metal'", "--backend", "auto, webgpu, webgl2, cpu"]);
    rejected(&["--tone-map", "hable"], &["'hable'", "--tone-map", "aces, agx, neutral"]);
    rejected(&["--view", "brunch"], &["'brunch'", "--view", "noon, sunset, dusk"]);
    let names: Vec<_> = welkin::Quality::ALL.iter().map(|q| q.name).collect();
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
    let front = Front::committed();
    let costs: Vec<_> = Quality::ALL.iter().map(|q| (q, front.cost(q).unwrap())).collect();
    let (best, cost) = costs.iter().min_by(|a, b| a.1.error.total_cmp(&b.1.error)).unwrap();
    let least = format!("{} or more", (cost.error * 1e3).ceil() / 1e3);
    rejected(&["--within-error", "1e-4"], &["--within-error", "'0.0001'", &least, best.name, "all orders"]);
    rejected(
        &["--within-budget", "1ns", "--view", "noon", "--size", "16x16"],
        &["--within-budget", "ms or more", "quality ", "at 16×16 on "],
    );
    rejected(&["--within-budget", "1s", "--backend", "cpu"], &["--within-budget", "'1000 ms'", "GPU backend", "cpu"]);
}

#[test]
fn a_quality_is_chosen_by_name_error_or_budget_and_told() {
    let folder = folder("quality");
    let draw = |args: &[&str], file: &str| {
        let common = ["render", "--backend", "webgpu", "--view", "sunset", "--size", "32x20", "-o", file];
        let out = welkin(&folder, &[&common[..], args].concat());
        assert!(out.status.success(), "{}", text(&out.stderr));
        (text(&out.stdout), image::open(folder.join(file)).unwrap().into_rgb32f())
    };
    let (said, by_name) = draw(&["--quality", "single-low"], "name.exr");
    assert!(said.starts_with("name.exr: "), "a quality that was asked for needs no reasons: {said}");
    let (_, by_samples) = draw(&["--samples", "8", "--light-samples", "8"], "samples.exr");
    assert_eq!(by_name, by_samples);
    let (_, other) = draw(&["--quality", "single-ultra"], "other.exr");
    assert_ne!(by_name, other);

    let (said, by_error) = draw(&["--within-error", "0.6"], "error.exr");
    let want = Quality::within_error(0.6).unwrap();
    let error = format!("{:.3}", Front::committed().cost(&want).unwrap().error);
    for part in [&format!("quality {want}"), "cheapest", "0.6 or less", "it has ", &error, "all orders"] {
        assert!(said.contains(part), "no {part:?}: {said}");
    }
    assert_eq!(by_error, draw(&["--quality", want.name], "same.exr").1);

    let (said, by_budget) = draw(&["--within-budget", "10s"], "budget.exr");
    let want = Front::committed().within_budget(Duration::MAX).unwrap();
    for part in [&format!("quality {want}"), "best that takes 10000 ms or less", "measured here at 32×20", "copies"] {
        assert!(said.contains(part), "no {part:?}: {said}");
    }
    assert_eq!(by_budget, draw(&["--quality", want.name], "same.exr").1);
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
    rejected(&["--planet", "mars", "--place", "46.5,8", "--time", time], &["--planet", "'mars'", "earth", "--time"]);
    for bad in ["yesterday", "2024-06-20", "2024-06-20T20:51:00", "2024-02-30T00:00:00Z", "3000-01-01T00:00:00Z"] {
        rejected(&["--place", "46.5,8", "--time", bad], &["--time", bad, "RFC 3339", "2999"]);
    }
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

#[test]
fn single_pictures_have_their_size_and_are_not_black() {
    let folder = folder("single");
    for ending in ["png", "exr", "hdr"] {
        let file = format!("limb.{ending}");
        let args = ["render", "--view", "limb", "--backend", "cpu", "--size", "48x30", "-o", &file];
        let out = welkin(&folder, &[&args[..], &["--samples", "4", "--light-samples", "2"]].concat());
        assert!(out.status.success(), "{}", text(&out.stderr));
        let said = text(&out.stdout);
        assert!(said.contains(&file) && said.contains("48×30") && said.contains("cpu"), "{said}");
        let image = image::open(folder.join(&file)).unwrap();
        assert_eq!((image.width(), image.height()), (48, 30));
        let floats = image.into_rgb32f();
        assert!(floats.iter().all(|v| v.is_finite() && *v >= 0.0));
        let row = |y| (0..48).map(|x| floats.get_pixel(x, y).0[2]).sum::<f32>();
        assert!(row(29) > 0.0, "{ending}: the lit ground is black");
        assert!(row(0) < row(29), "{ending}: space is brighter than the ground");
    }
    assert_eq!(files(&folder), ["limb.exr", "limb.hdr", "limb.png"]);
}

#[test]
fn place_and_time_put_the_sun_where_it_was() {
    let folder = folder("place");
    let draw = |args: &[&str], file: &str| {
        let common = ["render", "--backend", "cpu", "--size", "16x10", "--no-terrain", "--samples", "4", "-o", file];
        let out = welkin(&folder, &[&common[..], args].concat());
        assert!(out.status.success(), "{}", text(&out.stderr));
        image::open(folder.join(file)).unwrap().into_rgb32f().iter().sum::<f32>()
    };
    // Noon and midnight in London.
    let noon = draw(&["--place", "51.48,0.0", "--time", "2024-03-20T12:00:00Z"], "noon.exr");
    let night = draw(&["--place", "51.48,0.0", "--time", "2024-03-20T00:00:00Z"], "night.exr");
    assert!(noon > 10.0 * night, "{noon} {night}");
}

#[test]
fn contact_sheet_is_the_default() {
    let folder = folder("sheet");
    let out = welkin(&folder, &["render", "--samples", "8", "--light-samples", "4"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let said = text(&out.stdout);
    assert!(said.starts_with("welkin.png: 1600×1000, drawn by "), "{said}");
    assert_eq!(files(&folder), ["welkin.png"]);
    let image = image::open(folder.join("welkin.png")).unwrap().into_rgb8();
    assert_eq!(image.dimensions(), (1600, 1000));
    let bright = image.pixels().filter(|p| p.0.iter().any(|c| *c > 60)).count();
    assert!(bright > 1600 * 1000 / 5, "only {bright} pixels are not dark");
}

#[test]
fn info_lists_every_backend() {
    let out = welkin(&folder("info"), &["info"]);
    assert!(out.status.success());
    let said = text(&out.stdout);
    for backend in ["webgpu", "webgl2", "cpu"] {
        assert!(said.contains(&format!("{backend}:")), "{said}");
    }
}

/// `welkin info | true` and the like.
#[test]
fn a_reader_that_leaves_is_no_error() {
    let folder = folder("pipe");
    for args in [&["info"][..], &["render", "--view", "noon", "--backend", "cpu", "--size", "4x4"], &["--help"]] {
        let mut child = command(&folder, args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let out = child.wait_with_output().unwrap();
        let message = text(&out.stderr);
        assert!(out.status.success() && !message.contains("error"), "{args:?}: {:?} {message}", out.status);
    }
}

/// A sheet opens every backend: the one that draws has to stay in charge of its context.
#[test]
fn either_backend_draws_the_contact_sheet() {
    let folder = folder("either");
    for backend in ["webgpu", "webgl2"] {
        let file = format!("{backend}.png");
        let out = welkin(&folder, &["render", "--backend", backend, "--quality", "low", "--output", &file]);
        assert!(out.status.success(), "{backend}: {}", String::from_utf8_lossy(&out.stderr));
        assert!(String::from_utf8_lossy(&out.stdout).contains(&format!("drawn by {backend}")));
    }
}

#[test]
fn a_film_is_drawn_and_measured() {
    let folder = folder("film");
    let args =
        ["film", "climb", "--frames", "5", "--size", "24x36", "--steps", "24", "--cache-dir", ".", "--csv", "s.csv"];
    let out = welkin(&folder, &args);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let table = text(&out.stdout);
    assert!(table.contains("film.png: 5 frames, 132×52") && table.contains("24 steps"), "{table}");
    let strip = image::open(folder.join("film.png")).unwrap().into_rgb8();
    assert_eq!(strip.dimensions(), (5 * (24 + 2) + 2, 36 + 16));
    // Each frame is lit, and differs from the one before it.
    let frame = |i: u32| image::imageops::crop_imm(&strip, 2 + 26 * i, 2, 24, 36).to_image();
    for i in 0..5 {
        assert!(frame(i).pixels().any(|p| p.0[2] > 100), "frame {i} is dark");
        assert!(i == 0 || frame(i) != frame(i - 1), "frame {i}");
    }
    let mut rows = 0;
    for row in csv::Reader::from_path(folder.join("s.csv")).unwrap().records() {
        let row = row.unwrap();
        let values: Vec<f64> = row.iter().skip(1).map(|v| v.parse().unwrap()).collect();
        let [from, to, mean, mean_truth, mean_off, pixel, pixel_truth, pixel_off] = values[..] else {
            panic!("{row:?}")
        };
        assert!(["webgpu", "webgl2"].contains(&&row[0]) && from < to, "{row:?}");
        // The picture changes as the reference does, from the ground to a million kilometres.
        assert!(mean_off < 0.005 && pixel_off < 0.05, "{row:?}");
        assert!(
            mean_off >= (mean - mean_truth).abs() - 1e-6 && pixel_off >= (pixel - pixel_truth).abs() - 1e-6,
            "{row:?}"
        );
        rows += 1;
    }
    assert_eq!(rows, 2 * 24, "{table}");
    let out = welkin(&folder, &["film", "day", "--frames", "9", "--size", "16x24", "--steps", "0", "-o", "day.png"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let strip = image::open(folder.join("day.png")).unwrap().into_rgb8();
    assert_eq!(strip.dimensions(), (9 * 18 + 2, 40));
    // Night, noon, night.
    let mean = |i: u32| {
        let frame = image::imageops::crop_imm(&strip, 2 + 18 * i, 2, 16, 16).to_image();
        frame.pixels().map(|p| u32::from(p.0[2])).sum::<u32>() / 256
    };
    assert!(mean(0) < 20 && mean(4) > 60 && mean(8) < 20, "{} {} {}", mean(0), mean(4), mean(8));
}

#[test]
fn a_film_that_cannot_be_is_rejected() {
    for (args, part) in [
        (&["climb", "--altitude", "2km"][..], "the altitude is what changes"),
        (&["day", "--sun-elevation", "3"], "the sun is what changes"),
        (&["climb", "--steps", "0", "--csv", "s.csv"], "no step is measured"),
        (&["climb", "--steps", "7"], "0 or a whole number from 8"),
        (&["climb", "--frames", "1"], "2..=64"),
        (&["climb", "--size", "4x4"], "from 8 to 1000"),
        (&["day", "--altitude", "2000km"], "from 0 m to 1,000 km"),
        (&["climb", "--backend", "cpu"], "webgl2"),
        (&["climb", "-o", "film.exr"], ".png"),
        (&["night"], "climb"),
    ] {
        rejected_by("film", args, &[part]);
    }
}

#[test]
fn plans_are_printed() {
    let folder = folder("plan");
    // The options of `render`, and as JSON.
    let away = ["plan", "--altitude", "400km", "--pitch", "60", "--heading", "0"];
    let out = welkin(&folder, &away);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    assert!(printed.contains("no passes") && printed.contains("outside the picture"), "{printed}");
    let out = welkin(&folder, &["plan", "--sun-elevation", "-30", "--quality", "low", "--json"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let plan: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    let effects = plan["effects"].as_array().unwrap();
    let on = |name: &str| effects.iter().find(|e| e["name"] == name).unwrap()["on"].as_bool().unwrap();
    assert!(on("rayleigh") && on("background sky") && !on("sunlight") && !on("multiple scattering"), "{effects:?}");
    assert!(effects.iter().all(|e| !e["reason"].as_str().unwrap().is_empty()));
    let passes = plan["passes"].as_array().unwrap();
    assert!(passes.iter().any(|p| p["program"] == "lut_sky-rayleigh-mie-ozone-bare"), "{passes:?}");
    assert!(passes.iter().all(|p| p["label"] != "moments table"), "{passes:?}");
    // Linear radiance has another bound than a picture of 8 bits.
    let bound = |file| {
        let out = welkin(&folder, &["plan", "-o", file, "--json"]);
        serde_json::from_slice::<serde_json::Value>(&out.stdout).unwrap()["bound"]["absolute"].as_f64().unwrap()
    };
    assert!(bound("a.exr") < 0.01 * bound("a.png"));
    assert_eq!(files(&folder), [""; 0], "something was written");
    // What `render` refuses is refused.
    let refused = welkin(&folder, &["plan", "--fov", "0"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("from 0.01 to 179.0 degrees"));
}

#[test]
fn eclipses_are_told() {
    let folder = folder("eclipse");
    let total = ["eclipse", "--place", "25.29,-104.14", "--time", "2024-04-08T18:17:16Z"];
    let out = welkin(&folder, &total);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    assert!(printed.contains("eclipse      total") && printed.contains("magnitude    1.0566"), "{printed}");
    let out = welkin(&folder, &[&total[..], &["--json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!(told["now"]["obscuration"], 1.0);
    assert_eq!(told["eclipse"]["central"].as_array().unwrap().len(), 2);
    let out = welkin(&folder, &["eclipse", "--place", "25.29,-104.14", "--time", "1024-04-08T18:17:16Z"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("1900 to 2099"), "{}", text(&out.stderr));
}

#[test]
fn a_flight_is_planned_timed_and_plotted() {
    let folder = folder("flight");
    let args =
        ["flight", "--frames", "24", "--size", "32x18", "--compare-size", "16x9", "--repeat", "1", "--quality", "low"];
    let out = welkin(&folder, &[&args[..], &["--no-terrain", "-o", "f.svg", "--csv", "f.csv"]].concat());
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    for part in ["| background sky | off |", "| sunlight | off |", "night", "pipelines made ahead", "of the bound"] {
        assert!(printed.contains(part), "no '{part}' in {printed}");
    }
    let rows: Vec<Vec<f64>> = csv::Reader::from_path(folder.join("f.csv"))
        .unwrap()
        .records()
        .map(|row| row.unwrap().iter().take(14).map(|v| v.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 24);
    let mut nothing = 0;
    for row in &rows {
        let [_, _, _, passes, passes_all, pixels, pixels_all, .., share, display, _] = row[..] else {
            panic!("{row:?}")
        };
        assert!(passes <= passes_all && pixels <= pixels_all, "{row:?}");
        nothing += usize::from(passes == 0.0 && passes_all > 0.0);
        assert!(share <= 1.0 && display <= 1.0, "what is left out shows: {row:?}");
    }
    assert!(nothing > 0, "no passes where the planet is out of sight");
    // Up by day, around, and down by night.
    let column = |i: usize| rows.iter().map(|row| row[i]).collect::<Vec<_>>();
    let (altitudes, suns) = (column(1), column(2));
    assert!(altitudes[0] < 3.0 && altitudes[23] < 3.0 && altitudes[12] > 3e8 && suns[0] == 20.0 && suns[23] == -60.0);
    // Something is saved at the end: night.
    assert!(rows[23][3] < rows[23][4] && rows[23][5] < rows[23][6], "{:?}", rows[23]);
    let svg = std::fs::read_to_string(folder.join("f.svg")).unwrap();
    assert!(svg.contains("everything on") && svg.contains("planned") && svg.contains(" km, sun -60°"));
}

#[test]
fn every_effect_costs_nothing_when_it_is_off() {
    let out = welkin(&folder("costs"), &["costs", "--size", "24x16", "--repeat", "1", "--quality", "low"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    let rows: Vec<Vec<&str>> = printed
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| effect"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let effects: Vec<_> = rows.iter().map(|row| row[0]).collect();
    for effect in welkin::EffectPlan::NAMES {
        assert!(effects.contains(&effect), "{effect} is missing in {printed}");
    }
    for row in &rows {
        assert_eq!(row[6], "0, 0, 0", "{row:?}");
        let bytes: i64 = row[2].parse().unwrap();
        // Under a moon's shadow passes march: no tables of the sky.
        assert!(bytes >= 0 || row[0] == "eclipse", "{row:?}");
    }
    let bytes = |effect| rows.iter().find(|row| row[0] == effect).unwrap()[2].parse::<i64>().unwrap();
    assert!(bytes("atmosphere") > 100_000 && bytes("multiple scattering") > 0 && bytes("sun disk") == 0);
}
