//! Renderers: what a user plugs in.

#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
pub mod cpu_picture;
mod measure;
pub mod picture;
pub mod sky;
pub mod sky_light;
pub mod warm_up;
