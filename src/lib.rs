//! Physically based skies and atmospheres on two GPU backends from one set of shaders.
#![doc = ""]

pub mod atmosphere;
pub mod backend;
pub mod error;
pub mod passes;
pub mod phase;
pub mod reference;
pub mod shaders;
pub mod view;

pub use atmosphere::{AtmosphereParams, MiePhase};
pub use error::{Error, Result};
pub use passes::picture::{PictureRenderer, PictureSettings};
pub use passes::sky::{SkyRenderer, SkySettings};
pub use passes::terrain::TerrainStyle;
pub use passes::tone::ToneMap;
pub use reference::{clip_segment, compute_single_scatter, ray_sphere_intersect, ray_sphere_intersect_f32};
pub use view::{Camera, DepthConvention, Pose, Scene};

#[cfg(all(feature = "web", target_arch = "wasm32"))]
pub mod web;
