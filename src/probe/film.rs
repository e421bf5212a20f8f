//! Where a film's camera and sun go, and how far neighbouring frames lie apart: `cargo lab film` and the
//! tests share it.

use crate::AtmosphereParams;
use crate::frame::HAND_OVER;

/// Lowest and highest camera of a climb, metres.
pub const CLIMB: [f64; 2] = [2.0, 1e9];
/// Lowest sun of a day, degrees above the horizontal.
pub const NIGHT: f64 = -20.0;

/// A camera and a sun; angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Metres above the ground.
    pub altitude: f64,
    /// How far above the horizontal the camera looks.
    pub pitch: f64,
    /// Vertical field of view.
    pub fov: f64,
    /// How far the sun stands above the horizontal, -90 to 90.
    pub sun_elevation: f64,
    /// Where the sun stands, from where it rises: 0 before noon, 180 after.
    pub sun_azimuth: f64,
}

impl Moment {
    /// A moment of a climb, in pictures of this width over height. The horizon is in the middle near the
    /// ground; from 100 km on the camera turns towards the planet's centre, which it looks at from 10,000 km;
    /// from where the whole planet fits into 60°, it fills 5/6 of the picture.
    pub fn climb(params: &AtmosphereParams, altitude: f64, sun_elevation: f64, aspect: f64) -> Self {
        let radius = params.planet_radius;
        // Of the planet's edge from the point below the camera; the horizon lies 90° - edge below the
        // horizontal.
        let edge = (radius / (radius + altitude)).min(1.0).asin().to_degrees();
        let t = ((altitude / 1e5).max(1.0).ln() / 1e2_f64.ln()).min(1.0);
        let down = t * t * (3.0 - 2.0 * t);
        let fov = (2.4 * edge / aspect.min(1.0)).min(60.0);
        Self {
            altitude,
            pitch: (edge * (1.0 - down) - 90.0).max(-90.0),
            fov,
            sun_elevation,
            sun_azimuth: 0.0,
        }
    }

    /// A moment of a day, `angle` degrees along the sun's way through the zenith: from [`NIGHT`] to 180 -
    /// [`NIGHT`]. The camera sees the horizon above which the sun sets.
    pub fn day(altitude: f64, angle: f64) -> Self {
        let (sun_elevation, sun_azimuth) = if angle <= 90.0 { (angle, 0.0) } else { (180.0 - angle, 180.0) };
        Self { altitude, pitch: 20.0, fov: 60.0, sun_elevation, sun_azimuth }
    }
}

/// `n` values from `from` to `to`, both included.
fn even(from: f64, to: f64, n: u32) -> impl Iterator<Item = f64> {
    (0..n).map(move |i| from + (to - from) * f64::from(i) / f64::from(n.max(2) - 1))
}

/// `n` altitudes of a climb, even in their logarithms.
pub fn log_spaced(n: u32) -> Vec<f64> {
    let [low, high] = CLIMB;
    let mut all: Vec<f64> = even(low.ln(), high.ln(), n).map(f64::exp).collect();
    if let [first, .., last] = &mut all[..] {
        (*first, *last) = (low, high);
    }
    all
}

/// `n` angles of a day.
pub fn angles(n: u32) -> Vec<f64> {
    even(NIGHT, 180.0 - NIGHT, n).collect()
}

/// About `n` altitudes: [`log_spaced`], and a quarter of them each where the passes hand over and around the
/// top of the air, in even steps.
pub fn altitudes(params: &AtmosphereParams, n: u32) -> Vec<f64> {
    let top = params.thickness();
    let mut all = log_spaced(n - n / 2);
    all.extend(even(HAND_OVER.0 - 1e3, HAND_OVER.1 + 1e3, n / 4));
    all.extend(even(0.9 * top, 1.1 * top, n / 4));
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// How far two neighbouring frames lie apart, as a fraction of the brightest value of each channel in the
/// reference's two.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Step {
    /// Mean over pixels and channels: drawn, the reference's, and of the difference between the two changes.
    pub mean: [f64; 3],
    /// The change of the pixel and channel where it is largest, each for itself.
    pub pixel: [f64; 3],
}

impl Step {
    /// The step from the first to the second frame; red, green and blue of each pixel.
    pub fn between(drawn: [&[[f64; 3]]; 2], expected: [&[[f64; 3]]; 2]) -> Self {
        let mut step = Self::default();
        let n = (3 * expected[0].len()) as f64;
        for c in 0..3 {
            let top = expected.iter().flat_map(|t| t.iter()).fold(0.0, |m: f64, v| m.max(v[c]));
            // Where there is no light at all, light that is drawn is all wrong.
            let scale = if top > 0.0 { 1.0 / top } else { 1.0 };
            for i in 0..expected[0].len() {
                let changes = [drawn, expected].map(|[a, b]| scale * (b[i][c] - a[i][c]));
                let sizes = [changes[0].abs(), changes[1].abs(), (changes[0] - changes[1]).abs()];
                for (k, size) in sizes.into_iter().enumerate() {
                    step.mean[k] += size / n;
                    step.pixel[k] = step.pixel[k].max(size);
                }
            }
        }
        step
    }
}
