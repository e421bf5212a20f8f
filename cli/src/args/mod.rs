//! The options that commands share: groups for `#[command(flatten)]`, each declared once, and what is
//! accepted of them.

pub mod backend;
pub mod cache;
pub mod look;
pub mod output;
pub mod quality;
pub mod scene;
pub mod usage;
pub mod values;
