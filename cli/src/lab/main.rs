//! `welkin-lab`: how exact, how fast and how smooth the skies are. `welkin-lab --help` says what it can
//! measure.

use std::process::ExitCode;

fn main() -> ExitCode {
    welkin_cli::welkin_lab()
}
