//! What both programs do around a command: parse, run, say what went wrong, leave with a status that tells
//! it.

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::args::usage::UsageError;
use crate::renamed;

/// Exit status after a request that cannot be carried out as it was put; clap uses the same.
const USAGE: u8 = 2;
/// Exit status after a fault of this program (`EX_SOFTWARE` of sysexits).
const INTERNAL: u8 = 70;

/// Parses the command line of `program` and carries it out; `command` returns its name and its result.
pub fn run<C: Parser>(
    program: &str,
    command: impl FnOnce(C) -> (&'static str, anyhow::Result<()>),
) -> ExitCode {
    // A fault in here or in a graphics driver's binding ends in one line, not in a backtrace.
    std::panic::set_hook(Box::new(|info| {
        complain(&format!("internal error, please report it: {info}"));
    }));
    let carried_out = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        let parsed = C::try_parse().unwrap_or_else(|error| {
            let Some(now) = renamed_in(program, &error) else { error.exit() };
            complain(&now);
            std::process::exit(USAGE.into());
        });
        let (name, result) = command(parsed);
        exit_code(result, program, name)
    }));
    carried_out.unwrap_or(ExitCode::from(INTERNAL))
}

/// What to write instead, if what was not understood is an old name.
fn renamed_in(program: &str, error: &clap::Error) -> Option<String> {
    let (kind, renamed): (_, fn(&str, &str) -> Option<String>) = match error.kind() {
        ErrorKind::InvalidSubcommand => (ContextKind::InvalidSubcommand, renamed::command),
        ErrorKind::UnknownArgument => (ContextKind::InvalidArg, |_, name| renamed::option(name)),
        _ => return None,
    };
    match error.get(kind)? {
        ContextValue::String(name) => renamed(program, name),
        _ => None,
    }
}

/// Says on stderr what went wrong in a command, and with which status to leave.
fn exit_code(result: anyhow::Result<()>, program: &str, name: &str) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    if is_broken_pipe(&error) {
        return ExitCode::SUCCESS;
    }
    complain(&format!("{error:#}"));
    if error.is::<UsageError>() {
        let _ = writeln!(std::io::stderr(), "\nFor what is accepted, try '{program} {name} --help'.");
        return ExitCode::from(USAGE);
    }
    ExitCode::FAILURE
}

/// Whether whoever read our output has gone, as `head` does; that is no error.
fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let io = error.downcast_ref::<std::io::Error>();
    io.is_some_and(|e| e.kind() == std::io::ErrorKind::BrokenPipe)
}

/// Prints one line on stderr. Unlike `eprintln!` it does not panic when stderr is closed.
fn complain(message: &str) {
    let _ = writeln!(std::io::stderr(), "error: {message}");
}
