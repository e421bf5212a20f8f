//! What there is: the medium, the scene, the moon, phase functions. All in f64 and metres; no GPU is known here.

pub mod atmosphere;
pub mod moon;
pub mod phase;
pub mod scene;
