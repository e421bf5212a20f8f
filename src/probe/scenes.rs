//! The fixed scenes of the accuracy report: `cargo lab accuracy` measures over them, and the tests measure
//! again.

use crate::model::scene::Tangents;
use crate::{AtmosphereParams, Camera, DepthConvention, Pose, Scene};
use glam::DVec3;

/// A camera and a sun above a planet; the sun's azimuth is 0. Angles in degrees, no terrain.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Unique, for the tables.
    pub name: &'static str,
    /// Index into [`MEDIA`].
    pub medium: usize,
    /// The camera's height above the ground, metres.
    pub altitude: f64,
    /// The sun's angle from the zenith at the camera.
    pub sun_zenith: f64,
    /// How far above the horizontal the camera looks.
    pub pitch: f64,
    /// How far away from the sun the camera looks.
    pub heading: f64,
    /// Vertical field of view.
    pub fov: f64,
    /// Whether `--quick` has it.
    pub quick: bool,
}

/// A picture of which some pixels are compared.
///
/// Errors need few pixels of it, and no more are drawn: see [`Frame::compared`].
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// One pixel in so many is compared in a row and in a column, the middle one of them; 1 or more.
    pub stride: u32,
}

impl Frame {
    /// The frame of every scene.
    pub const WHOLE: Self = Self { size: [320, 180], stride: 20 };
    /// The frame of the quick scenes.
    pub const QUICK: Self = Self { size: [256, 144], stride: 24 };

    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.size[0]) / f64::from(self.size[1])
    }

    /// How many pixels are compared: in a row, and in a column.
    pub fn counts(&self) -> [u32; 2] {
        let [width, height] = self.size;
        let first = self.stride / 2;
        [width, height].map(|n| n.saturating_sub(first).div_ceil(self.stride))
    }

    /// The camera in whose picture of [`Frame::counts`] pixels there are the compared pixels alone: their
    /// middles are where they are in the whole frame.
    pub fn compared(&self, camera: &Camera) -> Camera {
        let Tangents { left, right, bottom, top } = camera.tangents;
        // From an edge, in pixels of the frame: the compared pixel i is at i · stride + first, and its middle
        // is the middle of a pixel that is stride wide.
        let first = f64::from(self.stride / 2) + 0.5 - 0.5 * f64::from(self.stride);
        let [across, down] = self.counts().map(|n| first + f64::from(n * self.stride));
        let [x, y] = [(right - left) / f64::from(self.size[0]), (top - bottom) / f64::from(self.size[1])];
        let tangents = Tangents {
            left: left + first * x,
            right: left + across * x,
            bottom: top - down * y,
            top: top - first * y,
        };
        Camera { tangents, ..*camera }
    }
}

pub use crate::settings::front::MEDIA;

/// A medium of [`MEDIA`], with a sun of irradiance 1.
///
/// `haze` is Earth with 400 times the aerosol: vertical optical depth 2.1, and a broader forward
/// peak (g = 0.7), as thick as a heavy dust storm.
pub fn medium(index: usize) -> crate::Result<AtmosphereParams> {
    let mut air = AtmosphereParams::preset(if index == 1 { "mars" } else { "earth" })?;
    if index == 2 {
        air.mie_scattering = air.mie_scattering.map(|v| v * 400.0);
        air.mie_absorption = air.mie_absorption.map(|v| v * 400.0);
        air.mie_asymmetry = [0.7; 3];
    }
    air.sun_intensity = 1.0;
    Ok(air)
}

#[allow(clippy::too_many_arguments)]
const fn setup(
    name: &'static str,
    medium: usize,
    altitude: f64,
    sun_zenith: f64,
    pitch: f64,
    heading: f64,
    fov: f64,
    quick: bool,
) -> Setup {
    Setup { name, medium, altitude, sun_zenith, pitch, heading, fov, quick }
}

/// All of them.
#[rustfmt::skip]
pub const SETUPS: [Setup; 22] = [
    //    name                         medium  altitude   sun  pitch heading  fov  quick
    setup("earth 2 m, sun 0°",              0,      2.0,   0.0,  20.0,   0.0, 60.0, false),
    setup("earth 2 m, sun 60°",             0,      2.0,  60.0,  20.0,  60.0, 60.0, true),
    setup("earth 2 m, sun 85°",             0,      2.0,  85.0,  20.0,   0.0, 60.0, false),
    setup("earth 2 m, sun 90°",             0,      2.0,  90.0,  20.0,   0.0, 60.0, true),
    setup("earth 2 m, sun 90° behind",      0,      2.0,  90.0,  20.0, 180.0, 60.0, false),
    setup("earth 2 m, sun 94°",             0,      2.0,  94.0,  20.0,   0.0, 60.0, true),
    setup("earth 2 m, sun 102°",            0,      2.0, 102.0,  20.0,   0.0, 60.0, true),
    setup("earth 5 km, sun 75°",            0,    5.0e3,  75.0,   0.0,   0.0, 60.0, false),
    setup("earth 30 km, sun 80°",           0,   30.0e3,  80.0,   0.0,   0.0, 60.0, false),
    setup("earth 100 km, sun 85°",          0,  100.0e3,  85.0,  -9.0,   0.0, 30.0, false),
    setup("earth 400 km limb, sun 70°",     0,  400.0e3,  70.0, -19.0,   0.0, 10.0, true),
    setup("earth 400 km limb, sun 102°",    0,  400.0e3, 102.0, -19.0,   0.0, 10.0, false),
    setup("earth 10,000 km, sun 60°",       0, 10000.0e3, 60.0, -90.0,   0.0, 50.0, true),
    setup("earth 10,000 km, sun 102°",      0, 10000.0e3,102.0, -90.0,   0.0, 50.0, false),
    setup("mars 2 m, sun 60°",              1,      2.0,  60.0,  20.0,  60.0, 60.0, true),
    setup("mars 2 m, sun 90°",              1,      2.0,  90.0,  20.0,   0.0, 60.0, false),
    setup("mars 400 km limb, sun 70°",      1,  400.0e3,  70.0, -25.0,   0.0, 15.0, false),
    setup("mars 10,000 km, sun 60°",        1, 10000.0e3, 60.0, -90.0,   0.0, 32.0, false),
    setup("haze 2 m, sun 60°",              2,      2.0,  60.0,  20.0,  60.0, 60.0, true),
    setup("haze 2 m, sun 85°",              2,      2.0,  85.0,  20.0,   0.0, 60.0, false),
    setup("haze 2 m, sun 94°",              2,      2.0,  94.0,  20.0,   0.0, 60.0, false),
    setup("haze 400 km limb, sun 70°",      2,  400.0e3,  70.0, -19.0,   0.0, 10.0, false),
];

impl Setup {
    /// The scene with the compared pixels of a frame alone: a picture of [`Frame::counts`] pixels.
    ///
    /// # Errors
    /// Those of [`Setup::scene`].
    pub fn compared(&self, frame: &Frame) -> crate::Result<Scene> {
        let whole = self.scene(frame.aspect())?;
        Ok(Scene { camera: frame.compared(&whole.camera), ..whole })
    }

    /// The scene in a picture of the given width over height.
    pub fn scene(&self, aspect: f64) -> crate::Result<Scene> {
        let atmosphere = medium(self.medium)?;
        let pose = Pose {
            altitude: self.altitude,
            pitch: self.pitch.to_radians(),
            heading: self.heading.to_radians(),
            fov_y: self.fov.to_radians(),
        };
        let camera = Camera::above(DVec3::ZERO, atmosphere.planet_radius, DVec3::Z, DVec3::X, pose, aspect)?;
        let (sin, cos) = self.sun_zenith.to_radians().sin_cos();
        Ok(Scene {
            camera,
            planet_center: DVec3::ZERO,
            atmosphere,
            sun_direction: DVec3::new(sin, 0.0, cos),
            depth: DepthConvention::default(),
            moon: None,
            ellipsoid: None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compared_pixels_look_where_they_do_in_the_whole_frame() {
        let middle = |t: Tangents, [x, y]: [u32; 2], [width, height]: [u32; 2]| {
            let part = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n);
            [t.left + part(x, width) * (t.right - t.left), t.top - part(y, height) * (t.top - t.bottom)]
        };
        for frame in [Frame::WHOLE, Frame::QUICK, Frame { size: [7, 5], stride: 1 }] {
            let whole = SETUPS[0].scene(frame.aspect()).unwrap().camera;
            let few = frame.compared(&whole);
            let [columns, rows] = frame.counts();
            for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
                let pixel = [i, j].map(|n| frame.stride / 2 + n * frame.stride);
                assert!(pixel[0] < frame.size[0] && pixel[1] < frame.size[1], "{pixel:?} in {frame:?}");
                let want = middle(whole.tangents, pixel, frame.size);
                let got = middle(few.tangents, [i, j], [columns, rows]);
                assert!((0..2).all(|c| (got[c] - want[c]).abs() < 1e-12), "{pixel:?}: {got:?}, {want:?}");
            }
            let beyond = frame.counts().map(|n| frame.stride / 2 + n * frame.stride);
            assert!(beyond[0] >= frame.size[0] && beyond[1] >= frame.size[1], "{frame:?} has more pixels");
        }
    }

    #[test]
    fn every_scene_is_valid_and_has_its_own_name() {
        let mut names = std::collections::BTreeSet::new();
        for setup in SETUPS {
            setup.scene(16.0 / 9.0).unwrap().validate().unwrap();
            assert!(names.insert(setup.name), "{}", setup.name);
        }
        assert!((0..MEDIA.len()).all(|m| SETUPS.iter().any(|s| s.medium == m && s.quick)));
    }
}
