//! The commands of `welkin`, a file each: its options and what it does.

pub mod eclipse;
pub mod info;
pub mod plan;
pub mod radiance;
pub mod render;
