//! What is measured of each frame of a flight.

use welkin::probe::film::Moment;

/// What a frame's sky costs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost {
    /// Passes in this frame, those of LUTs included.
    pub passes: usize,
    /// Pixels and texels that they shade.
    pub pixels: f64,
    /// Milliseconds of the GPU.
    pub time: f64,
}

/// One frame of the flight.
pub struct FlightFrame {
    /// Where camera and sun are.
    pub moment: Moment,
    /// What is drawn, and why.
    pub plan: welkin::Frame,
    /// What that costs.
    pub planned: Cost,
    /// What it costs with every effect forced on.
    pub everything: Cost,
    /// Milliseconds by the clock, with pipelines made when needed and ahead.
    pub clock: [f64; 2],
    /// Largest change of radiance by what is left out, as a fraction of the bound; and of a display value, of
    /// 255.
    pub change: [f64; 2],
}
