//! What the programs `welkin` and `welkin-lab` are made of; each of them is a call of one function here.

mod args;
mod cache;
mod canvas;
mod cli;
mod commands;
mod entry;
mod ephemeris;
mod gpu;
#[cfg(feature = "lab")]
mod lab;
#[cfg(test)]
mod layers;
mod medium;
mod output;
mod picture;
mod progress;
mod quality_choice;
mod renamed;
mod sheet;
mod sun;
mod views;

use std::process::ExitCode;

/// The program `welkin`: draws, plans, tabulates.
pub fn welkin() -> ExitCode {
    entry::run("welkin", |cli: cli::Cli| (cli.command.name(), cli.command.run()))
}

/// The program `welkin-lab`: measures, compares and times.
#[cfg(feature = "lab")]
pub fn welkin_lab() -> ExitCode {
    entry::run("welkin-lab", |cli: lab::cli::Cli| (cli.command.name(), cli.command.run()))
}
