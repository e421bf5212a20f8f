//! The programs `welkin` and, with the feature `lab`, `welkin-lab` as a user meets them: the built binaries,
//! their messages, their files.

mod eclipse;
mod harness;
#[cfg(feature = "lab")]
mod lab;
mod plan;
mod radiance;
mod refused;
mod render;
mod sheet;
mod usage;
