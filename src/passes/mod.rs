//! The passes: what each reads, computes and draws, as data for a [`crate::backend::Backend`].

pub mod frame;
pub mod lut;
pub mod picture;
pub mod sky;
pub mod sun;
pub mod terrain;
pub mod tone;
pub mod warm;
