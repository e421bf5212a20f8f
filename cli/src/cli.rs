//! The command line of `welkin`.

use clap::{Parser, Subcommand};

use crate::commands::eclipse::{self, EclipseArgs};
use crate::commands::info;
use crate::commands::plan::{self, PlanArgs};
use crate::commands::radiance::{self, RadianceArgs};
use crate::commands::render::{self, RenderArgs};

/// Physically based skies, from the ground to orbit.
#[derive(Debug, Parser)]
#[command(name = "welkin", version, after_help = "Start with:  welkin render")]
#[command(arg_required_else_help = true, subcommand_required = true, disable_help_subcommand = false)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands; each has a file of its own.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw a sky: a contact sheet of many views, or one picture
    Render(Box<RenderArgs>),
    /// Say which effects a picture calls for, why, and the passes that draw them
    Plan(Box<PlanArgs>),
    /// Compute the sky's radiance in given directions, from a table to a table
    Radiance(RadianceArgs),
    /// Tell how much of the sun the moon hides above a place on Earth, and when
    Eclipse(EclipseArgs),
    /// List the backends and adapters that can draw here
    Info,
}

impl Command {
    /// Its name on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Render(_) => "render",
            Self::Plan(_) => "plan",
            Self::Radiance(_) => "radiance",
            Self::Eclipse(_) => "eclipse",
            Self::Info => "info",
        }
    }

    /// Carries it out.
    pub fn run(&self) -> anyhow::Result<()> {
        match self {
            Self::Render(args) => render::run(args),
            Self::Plan(args) => plan::run(args),
            Self::Radiance(args) => radiance::run(args),
            Self::Eclipse(args) => eclipse::run(args),
            Self::Info => info::run(),
        }
    }
}
