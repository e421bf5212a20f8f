//! Renderers: what a user plugs in.

#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
pub mod cpu_picture;
#[cfg(feature = "webgl")]
pub mod in_webgl;
#[cfg(feature = "wgpu")]
pub mod in_wgpu;
mod measure;
pub mod picture;
pub mod scene_air;
pub mod sky;
pub mod sky_light;
pub mod warm_up;
