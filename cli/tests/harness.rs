//! How the tests run the programs: each in an empty folder of its own.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The user's program.
pub const WELKIN: &str = env!("CARGO_BIN_EXE_welkin");
/// The laboratory.
#[cfg(feature = "lab")]
pub const LAB: &str = env!("CARGO_BIN_EXE_welkin-lab");

/// A new empty folder; the test works inside it.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Where solutions of the reference are kept from one run of the tests to the next, those of the library's
/// tests too: for `--cache-dir`, where it does not matter whether a solution is new. A changed solver finds
/// none.
#[cfg(feature = "lab")]
pub const KEPT: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/orders");

/// A program, ready to run in a folder. Solutions of the reference are kept in the folder, never in the
/// user's.
pub fn command(program: &str, folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(args).current_dir(folder).stdin(Stdio::null());
    // Mesa complains on stderr where this is not set, and stderr is what some tests look at.
    command.env("XDG_RUNTIME_DIR", env!("CARGO_TARGET_TMPDIR"));
    command.env("WELKIN_CACHE_DIR", "cache").env_remove("XDG_CACHE_HOME");
    command
}

/// Runs `welkin`.
pub fn welkin(folder: &Path, args: &[&str]) -> Output {
    command(WELKIN, folder, args).output().unwrap()
}

/// Runs `welkin-lab`.
#[cfg(feature = "lab")]
pub fn lab(folder: &Path, args: &[&str]) -> Output {
    command(LAB, folder, args).output().unwrap()
}

/// What was printed.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What stdout says of a run that has to succeed.
#[track_caller]
pub fn printed(out: &Output) -> String {
    assert!(out.status.success(), "{}", text(&out.stderr));
    text(&out.stdout)
}

/// The names in a folder, in order.
pub fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|f| f.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Exit status 2, a message with all of `parts`, and nothing in the folder.
#[track_caller]
pub fn rejected(program: &str, args: &[&str], parts: &[&str]) {
    // Tests run at the same time: a folder for each.
    let name = args.join("_").replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    let folder = folder(&format!("rejected-{name}"));
    let out = command(program, &folder, args).output().unwrap();
    let message = text(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{args:?}: {message}");
    assert!(out.stdout.is_empty(), "{args:?}");
    for part in parts {
        assert!(message.contains(part), "{args:?}: no {part:?} in: {message}");
    }
    assert!(!message.contains("panicked") && !message.contains("internal"), "{message}");
    assert_eq!(files(&folder), [""; 0], "{args:?}");
    std::fs::remove_dir(&folder).unwrap();
}
