//! Where solutions of the all-orders reference are kept.

use std::path::PathBuf;

use clap::Args;

/// Options of what uses the all-orders reference.
#[derive(Args, Debug)]
#[command(next_help_heading = "Kept solutions of the all-orders reference")]
pub struct CacheArgs {
    /// Solve, even what was solved before, and keep nothing
    #[arg(long)]
    pub no_cache: bool,

    /// Where solutions are kept; may be emptied at any time [default: welkin in the user's cache folder]
    #[arg(long, value_name = "FOLDER", env = "WELKIN_CACHE_DIR", hide_env_values = true)]
    pub cache_dir: Option<PathBuf>,
}
