//! Every integration test of the library, in one binary: a module a subject, and [`harness`] for what they
//! share.
//!
//! One process links the drivers once and solves the reference once for each medium. Tests run in threads,
//! each with its own devices and contexts; what a test counts (live objects, allocations) belongs to its
//! device or its thread. The harness runs tests in the order of their names: what takes long is in
//! [`thorough`], nearly last, and `cargo test --all-features --test all -- --skip thorough::` leaves it out.
#![allow(clippy::needless_range_loop)] // Loops over the three channels index several arrays.

#[cfg(not(all(
    feature = "wgpu",
    feature = "egl",
    feature = "translate",
    feature = "probe",
    feature = "reference"
)))]
compile_error!("the integration tests need every feature: give cargo test --all-features");

mod airglow;
mod depth;
mod device_loss;
mod eclipse;
mod ellipsoid;
mod embedding;
mod encoders;
mod frame;
mod half_floats;
mod harness;
mod inside;
mod layers;
mod lifetime;
mod lighting;
mod lit_fraction;
mod lowest_ground;
mod plan;
mod properties;
mod random_use;
mod rejects;
mod scene_shaders;
mod shaders;
mod short_way;
mod sky;
mod staleness;
mod thorough;
mod tone_map;
mod two_planets;
