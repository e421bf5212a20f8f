//! What takes long: numbers against the reference and other programs', lines across every edge, many random
//! cases.
//!
//! By default a sample of each kind is tried; with `WELKIN_ALL` set, as `scripts/test --all` has it, all
//! there is.

mod accuracy;
mod continuity;
mod energy;
mod hard_media;
mod near_air;
mod probe;
mod quality;
mod random_frames;
mod reference_data;
mod reference_physics;
mod shadow;
