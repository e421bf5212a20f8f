//! How a scene is drawn: plain data.

pub mod front;
pub mod quality;
