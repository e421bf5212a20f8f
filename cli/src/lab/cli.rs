//! The command line of `welkin-lab`.

use clap::{Parser, Subcommand};

use crate::lab::accuracy::{self, AccuracyArgs};
use crate::lab::compare::{self, CompareArgs};
use crate::lab::costs::{self, CostsArgs};
use crate::lab::film::{self, FilmArgs};
use crate::lab::flight::{self, FlightArgs};
use crate::lab::shaders::{self, ShadersArgs};
use crate::lab::stress::{self, StressArgs};

/// How exact, how fast and how smooth welkin's skies are.
#[derive(Debug, Parser)]
#[command(name = "welkin-lab", version, after_help = "Start with:  welkin-lab stress")]
#[command(arg_required_else_help = true, subcommand_required = true, disable_help_subcommand = false)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands; each has a file of its own.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Measure what accuracy costs in time, on every backend
    Accuracy(AccuracyArgs),
    /// Run the shaders' functions on a million cases, against f64
    Stress(StressArgs),
    /// Fly from the ground to the moon's distance and around to the night side: what is drawn, why, and what
    /// it costs
    Flight(FlightArgs),
    /// Say what each effect costs: bytes, pipelines and milliseconds
    Costs(CostsArgs),
    /// Draw a climb to a million kilometres, or a day, as a strip of frames; measure how smoothly they follow
    Film(Box<FilmArgs>),
    /// Draw every view by every backend: how far apart the pictures are, and what each pass costs
    Compare(CompareArgs),
    /// Translate shaders/wgsl/ to shaders/glsl/ (for work on welkin itself)
    Shaders(ShadersArgs),
}

impl Command {
    /// Its name on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Accuracy(_) => "accuracy",
            Self::Stress(_) => "stress",
            Self::Flight(_) => "flight",
            Self::Costs(_) => "costs",
            Self::Film(_) => "film",
            Self::Compare(_) => "compare",
            Self::Shaders(_) => "shaders",
        }
    }

    /// Carries it out.
    pub fn run(&self) -> anyhow::Result<()> {
        match self {
            Self::Accuracy(args) => accuracy::run(args),
            Self::Stress(args) => stress::run(args),
            Self::Flight(args) => flight::run(args),
            Self::Costs(args) => costs::run(args),
            Self::Film(args) => film::run(args),
            Self::Compare(args) => compare::run(args),
            Self::Shaders(args) => shaders::run(args),
        }
    }
}
