//! f64 ground truth on the CPU: the same physics as the shaders, written again from the equations.
//!
//! Nothing here shares code, tables or approximations with the shaders, so that agreement means
//! something. It judges accuracy, and it renders where no GPU driver exists.
//!
//! * [`geometry`]: rays, spheres, and the chord form that keeps altitudes exact near the horizon.
//! * [`single`]: transmittance and single scattering, adaptive to a stated [`single::Tolerance`].
//! * [`multiple`]: all orders of scattering and the ground, solved once for an atmosphere, then quick for any
//!   ray.
//! * [`path`]: the same by Monte Carlo, with its standard error: slow, and without any table.
//!
//! `multiple` and `path` use all cores with the cargo feature `reference`. How well all this agrees with
//! other programs: `cargo run --release --features reference --example reference_table`.
//!
//! Radiance is given per unit solar irradiance (1/sr) and multiplied by
//! [`AtmosphereParams::sun_intensity`](crate::AtmosphereParams::sun_intensity). No refraction, no
//! polarisation, the sun's own disk is not part of the radiance.

// Loops over the three channels index several arrays at once.
#![allow(clippy::needless_range_loop)]

pub mod geometry;
mod harmonics;
mod medium;
pub mod multiple;
pub(crate) mod parallel;
pub mod path;
pub mod single;

pub use geometry::{clip_segment, ray_sphere_intersect, ray_sphere_intersect_f32};
pub use single::compute_single_scatter;
