//! What there is: the medium, the scene, the moon, phase functions, light by constants. All in f64 and
//! metres; no GPU is known here.

pub mod airglow;
pub mod atmosphere;
pub mod ellipsoid;
pub mod lighting;
pub mod matrices;
pub mod moon;
pub mod phase;
pub(crate) mod quadrature;
pub mod rays;
pub mod scene;
pub mod sunlight;
