//! One frame: what a scene calls for and why, and the passes that draw it.

pub mod disks;
pub(crate) mod draw;
pub mod eclipse;
pub mod lut;
mod omit;
pub mod plan;
pub mod terrain;
pub mod tone_map;
pub mod uniforms;
