//! The laboratory: what measures how exact, how fast and how smooth the skies are. Its commands share their
//! timing, their plots and how they ask the reference.

mod accuracy;
pub mod cli;
mod compare;
mod costs;
mod device;
mod film;
mod flight;
mod plot;
mod reference;
mod shaders;
mod stress;
mod timing;
mod values;
