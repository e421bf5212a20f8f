//! Where results are written.

use std::path::{Path, PathBuf};

use clap::Args;

/// The option `--output` as errors name it.
pub const OPTION: &str = "--output <FILE>";

/// The option that says where to write. What is written, and where by default, a command says in the help
/// text that it puts in place of this one's, by `mut_arg("output", …)`.
#[derive(Args, Debug)]
pub struct OutputArgs {
    /// Where to write
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl OutputArgs {
    /// The path that was given.
    pub fn path(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The path that was given, or `default`.
    pub fn path_or<'a>(&'a self, default: &'a str) -> &'a Path {
        self.path().unwrap_or(Path::new(default))
    }
}
