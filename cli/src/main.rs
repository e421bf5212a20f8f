//! `welkin`: skies from the command line. `welkin --help` tells what it can do.

mod accuracy;
mod args;
mod cache;
mod choose;
mod compare;
mod costs;
mod draw;
mod eclipse;
mod ephemeris;
mod film;
mod flight;
mod info;
mod output;
mod plan;
mod progress;
mod radiance;
mod render;
mod shaders;
mod sheet;
mod stress;
mod sun;
mod views;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command, UsageError};

/// Exit status after a request that cannot be carried out as it was put; clap uses the same.
const USAGE: u8 = 2;
/// Exit status after a fault of this program (`EX_SOFTWARE` of sysexits).
const INTERNAL: u8 = 70;

fn main() -> ExitCode {
    // A fault in here or in a graphics driver's binding ends in one line, not in a backtrace.
    std::panic::set_hook(Box::new(|info| {
        complain(&format!("internal error, please report it: {info}"));
    }));
    std::panic::catch_unwind(|| {
        let cli = Cli::parse();
        let name = cli.command.name();
        exit_code(run(cli), name)
    })
    .unwrap_or(ExitCode::from(INTERNAL))
}

/// Carries out one subcommand.
fn run(cli: Cli) -> anyhow::Result<()> {
    match cli.command {
        Command::Render(args) => render::run(&args),
        Command::Film(args) => film::run(&args),
        Command::Flight(args) => flight::run(&args),
        Command::Costs(args) => costs::run(&args),
        Command::Plan(args) => plan::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Accuracy(args) => accuracy::run(&args),
        Command::Radiance(args) => radiance::run(&args),
        Command::Stress(args) => stress::run(&args),
        Command::Eclipse(args) => eclipse::run(&args),
        Command::Info => info::run(),
        Command::Shaders { check, root } => shaders::run(&root, check),
    }
}

/// Says what went wrong in a subcommand, on stderr, and with which status to leave.
fn exit_code(result: anyhow::Result<()>, name: &str) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    if is_broken_pipe(&error) {
        return ExitCode::SUCCESS;
    }
    complain(&format!("{error:#}"));
    if error.is::<UsageError>() {
        let _ = writeln!(std::io::stderr(), "\nFor what is accepted, try 'welkin {name} --help'.");
        return ExitCode::from(USAGE);
    }
    ExitCode::FAILURE
}

/// Whether whoever read our output has gone, as `head` does; that is no error.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let io = error.downcast_ref::<std::io::Error>();
    io.is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe)
}

/// One line on stderr. Unlike `eprintln!` it does not panic when stderr is closed.
fn complain(message: &str) {
    let _ = writeln!(std::io::stderr(), "error: {message}");
}
