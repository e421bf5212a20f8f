//! What both programs have in common: help, names that have changed, a reader that leaves.

use std::process::Stdio;

use crate::harness::{WELKIN, command, folder, rejected, text, welkin};

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
    for args in
        [&["info"][..], &["render", "--view", "noon", "--backend", "cpu", "--size", "4x4"], &["--help"]]
    {
        let mut child =
            command(WELKIN, &folder, args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let out = child.wait_with_output().unwrap();
        let message = text(&out.stderr);
        assert!(out.status.success() && !message.contains("error"), "{args:?}: {:?} {message}", out.status);
    }
}

#[test]
fn what_has_another_name_now_is_told() {
    rejected(
        WELKIN,
        &["accuracy", "--quick"],
        &["'welkin accuracy' is now 'welkin-lab accuracy'", "cargo lab accuracy"],
    );
    rejected(
        WELKIN,
        &["film"],
        &["'welkin film' is now 'welkin-lab film'", "--features lab --bin welkin-lab -- film"],
    );
    rejected(WELKIN, &["radiance", "--out", "r.csv"], &["'--out' is now '--output'"]);
    rejected(WELKIN, &["radiance", "--out=r.csv"], &["'--out' is now '--output'"]);
    // What was never there is told as before.
    rejected(WELKIN, &["paint"], &["'paint'"]);
    rejected(WELKIN, &["render", "--colour", "red"], &["'--colour'"]);
}

#[cfg(feature = "lab")]
#[test]
fn the_laboratory_sends_back_to_the_users_program() {
    use crate::harness::{LAB, lab};

    rejected(LAB, &["render"], &["'render' is a command of 'welkin'", "cargo run --release -- render"]);
    rejected(LAB, &["accuracy", "--out", "a"], &["'--out' is now '--output'"]);
    let help = text(&lab(&folder("lab-help"), &["--help"]).stdout);
    for command in ["accuracy", "stress", "flight", "costs", "film", "compare", "shaders"] {
        assert!(help.contains(command), "{command} is missing from {help}");
    }
}
