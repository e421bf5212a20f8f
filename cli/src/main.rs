//! `welkin`: skies from the command line. `welkin --help` says what it can do.

use std::process::ExitCode;

fn main() -> ExitCode {
    welkin_cli::welkin()
}
