//! What the tests of both backends share. A missing driver is a failure, never a skip.
#![allow(dead_code)]

pub mod lines;

use glam::DVec3;
use welkin::gpu::{Backend, egl::Headless, wgpu::WgpuBackend};
use welkin::{AtmosphereParams, Camera, DepthConvention, Pose, Scene};

/// Runs the same body on both backends. A test binary prints which adapters it ran on.
pub fn on_both(mut body: impl FnMut(&mut dyn Backend)) {
    let mut webgpu = WgpuBackend::headless().expect("WebGPU needs a Vulkan driver: run scripts/setup");
    eprintln!("{}", webgpu.info());
    body(&mut webgpu);
    let mut webgl2 = Headless::new().expect("WebGL2 needs EGL with OpenGL ES 3: run scripts/setup");
    eprintln!("{}", webgl2.backend.info());
    body(&mut webgl2.backend);
}

/// A scene on the planet's north pole: heading 0 looks along +X, the sun's azimuth counts from there.
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
            Camera::above(DVec3::ZERO, self.params.planet_radius, DVec3::Z, DVec3::X, pose, self.aspect).unwrap();
        let e = self.sun_elevation.to_radians();
        Scene {
            camera,
            planet_center: DVec3::ZERO,
            atmosphere: self.params.clone(),
            sun_direction: DVec3::new(e.cos(), 0.0, e.sin()),
            depth: DepthConvention::default(),
            moon: None,
        }
    }
}

/// Mean of the RGB channels of an RGBA picture.
pub fn mean(pixels: &[f32]) -> [f64; 3] {
    let n = (pixels.len() / 4) as f64;
    let mut sum = [0.0; 3];
    for p in pixels.chunks_exact(4) {
        for c in 0..3 {
            sum[c] += f64::from(p[c]) / n;
        }
    }
    sum
}
