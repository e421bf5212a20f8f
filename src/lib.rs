//! Physically based skies and atmospheres on two GPU backends from one set of shaders.
#![doc = ""]

pub mod atmosphere;
pub mod error;
pub mod phase;
pub mod reference;
pub mod view;

pub use atmosphere::{AtmosphereParams, MiePhase};
pub use error::{Error, Result};
pub use view::{Camera, DepthConvention, Scene};
