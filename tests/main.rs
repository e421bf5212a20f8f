//! Every integration test of the library, in one binary: a module a subject, and [`harness`] for what they
//! share.
//!
//! One process links the drivers once and solves the reference once for each medium. Tests run in threads,
//! each with its own devices and contexts; what a test counts (live objects, allocations) belongs to its
//! device or its thread. The long checks are in [`long`]: `cargo test --test all -- --skip long::` leaves
//! them out.
#![allow(clippy::needless_range_loop)] // Loops over the three channels index several arrays.

#[cfg(not(all(
    feature = "wgpu",
    feature = "egl",
    feature = "translate",
    feature = "probe",
    feature = "reference"
)))]
compile_error!(
    "the integration tests need every feature: run `cargo test` at the root, or give --all-features"
);

mod accuracy;
mod continuity;
mod depth;
mod device_loss;
mod eclipse;
mod embedding;
mod energy;
mod frame;
mod half_floats;
mod hard_media;
mod harness;
mod layers;
mod lifetime;
mod lighting;
mod plan;
mod probe;
mod properties;
mod quality;
mod random_frames;
mod reference_data;
mod reference_physics;
mod rejects;
mod shaders;
mod sky;
mod staleness;
mod tone_map;
