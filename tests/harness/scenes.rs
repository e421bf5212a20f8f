//! Scenes above a pole, and the rays of their pixels.

use glam::{DVec2, DVec3};
use welkin::reference::single::RayQuery;
use welkin::{AtmosphereParams, Camera, DepthConvention, Pose, Scene};

/// A scene on the planet's north pole: heading 0 looks along +X, the sun's azimuth counts from there. Metres
/// and degrees.
#[derive(Clone, Debug)]
pub struct View {
    pub params: AtmosphereParams,
    pub altitude: f64,
    pub pitch: f64,
    pub heading: f64,
    pub fov: f64,
    pub sun_elevation: f64,
    pub aspect: f64,
}

impl Default for View {
    fn default() -> Self {
        Self {
            params: AtmosphereParams::earth(),
            altitude: 100.0,
            pitch: 0.0,
            heading: 0.0,
            fov: 60.0,
            sun_elevation: 30.0,
            aspect: 1.0,
        }
    }
}

impl View {
    pub fn scene(&self) -> Scene {
        let pose = Pose {
            altitude: self.altitude,
            pitch: self.pitch.to_radians(),
            heading: self.heading.to_radians(),
            fov_y: self.fov.to_radians(),
        };
        let camera =
            Camera::above(DVec3::ZERO, self.params.planet_radius, DVec3::Z, DVec3::X, pose, self.aspect)
                .unwrap();
        let e = self.sun_elevation.to_radians();
        Scene {
            camera,
            planet_center: DVec3::ZERO,
            atmosphere: self.params.clone(),
            sun_direction: DVec3::new(e.cos(), 0.0, e.sin()),
            depth: DepthConvention::default(),
            moon: None,
            ellipsoid: None,
        }
    }
}

/// A medium in which nothing scatters or absorbs.
pub fn airless(params: AtmosphereParams) -> AtmosphereParams {
    AtmosphereParams {
        rayleigh_scattering: [0.0; 3],
        mie_scattering: [0.0; 3],
        mie_absorption: [0.0; 3],
        ozone_absorption: [0.0; 3],
        ..params
    }
}

/// The vector through the middle of a pixel, one metre deep: its length is metres along the ray per metre of
/// depth.
pub fn through_pixel(scene: &Scene, [w, h]: [u32; 2], i: usize) -> DVec3 {
    let basis = scene.validate().unwrap().basis;
    let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    basis.ray(DVec2::new(share(i as u32 % w, w), -share(i as u32 / w, h)))
}

/// The ray through the middle of a pixel, as the reference asks for it; pixels count row by row from the top.
pub fn query(scene: &Scene, size: [u32; 2], i: usize) -> RayQuery {
    let view = scene.validate().unwrap();
    let direction = through_pixel(scene, size, i).normalize();
    RayQuery { altitude: view.altitude, direction, sun: view.sun, length: f64::INFINITY, moon: None }
}

/// The rays through the middles of all pixels.
pub fn rays(scene: &Scene, size: [u32; 2]) -> Vec<RayQuery> {
    (0..(size[0] * size[1]) as usize).map(|i| query(scene, size, i)).collect()
}
