//! `welkin info`: what can draw here.

use std::io::Write;

use crate::args::backend::BackendChoice;
use crate::gpu::{self, Gpu};

/// Opens every backend in turn and says what it is, or why it cannot be had.
pub fn run() -> anyhow::Result<()> {
    let mut lines = vec![format!("welkin {}", env!("CARGO_PKG_VERSION"))];
    let preferred = gpu::available().0.first().copied();
    for choice in BackendChoice::ALL {
        let mark = if Some(choice) == preferred { '*' } else { ' ' };
        lines.push(match Gpu::open(choice) {
            Ok(gpu) => format!("{mark} {}", gpu.describe()),
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
