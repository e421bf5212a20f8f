//! `welkin info`: what can draw here.

use std::io::Write;

use clap::ValueEnum;

use crate::draw::{self, BackendChoice, Drawer};

/// Opens every backend in turn and says what it is, or why it cannot be had.
pub fn run() -> anyhow::Result<()> {
    let mut lines = vec![format!("welkin {}", env!("CARGO_PKG_VERSION"))];
    let preferred = draw::available().first().copied();
    for &choice in BackendChoice::value_variants() {
        if choice == BackendChoice::Auto {
            continue;
        }
        let mark = if Some(choice) == preferred { '*' } else { ' ' };
        lines.push(match Drawer::open(choice) {
            Ok(drawer) => format!("{mark} {}", drawer.describe()),
            Err(error) => format!("{mark} not available: {error:#}"),
        });
    }
    lines.push("* drawn with by default (--backend auto)".to_owned());
    let mut stdout = std::io::stdout().lock();
    for line in lines {
        writeln!(stdout, "{line}")?;
    }
    Ok(())
}

/// A backend's name on the command line.
pub fn name(choice: BackendChoice) -> String {
    choice.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned())
}
