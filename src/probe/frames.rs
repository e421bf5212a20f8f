//! Whole pictures of random scenes over everything that [`Scene::validate`] accepts: whether all of their
//! light is finite and possible. Small ones, but by the passes, LUTs and textures that large ones are drawn
//! with.

use std::f64::consts::{FRAC_PI_2, PI};

use fastrand::Rng;
use glam::{DQuat, DVec3};

use super::cases;
use crate::error::Result;
use crate::gpu::{Backend, Format, Pass, Target, TextureDesc, TextureId};
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::model::scene::{Camera, DepthConvention, Pose, Scene};
use crate::render::sky::{AerialTargets, FrameTargets, SkyRenderer};
use crate::settings::{Bound, Composition, Look, LutSettings, Quality, SkySettings};

/// A scene, how it is drawn, and what stands before the camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The scene.
    pub scene: Scene,
    /// Passes and method.
    pub settings: SkySettings,
    /// Pixels.
    pub size: [u32; 2],
    /// Distances of planes along the camera's axis, metres, one a row of pixels and again from the first;
    /// infinite: none.
    pub planes: Vec<f64>,
}

/// What is wrong with a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// From the top left.
    pub pixel: [u32; 2],
    /// The pixel over a black scene and over a white one.
    pub over: [[f32; 4]; 2],
    /// In words.
    pub what: &'static str,
}

/// LUTs as small as can be, and next to that: so many frames fit into a test.
const TINY: LutSettings = LutSettings { orders: 2, ..LutSettings::TINY };

/// The frame of a seed and number.
pub fn frame(seed: u64, number: u64) -> Frame {
    let mut rng = Rng::with_seed(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ number ^ 0x6672_616d);
    let rng = &mut rng;
    let mut atmosphere = cases::any_medium(rng);
    atmosphere.mie_phase = [MiePhase::HenyeyGreenstein, MiePhase::CornetteShanks][rng.usize(0..2)];
    atmosphere.ground_albedo = [(); 3].map(|()| [0.0, 1.0, rng.f64()][rng.usize(0..3)]);
    atmosphere.sun_intensity = [1.0, 22.0, 1e-6, 1e6][rng.usize(0..4)];
    atmosphere.sun_angular_radius = [4.65e-3, 1e-5, 0.5][rng.usize(0..3)];
    if rng.u8(0..6) == 0 {
        // One constituent alone, or none.
        let keep = rng.u8(0..4);
        let a = &mut atmosphere;
        for (i, c) in [&mut a.rayleigh_scattering, &mut a.mie_scattering, &mut a.ozone_absorption]
            .into_iter()
            .enumerate()
        {
            if i != usize::from(keep) {
                *c = [0.0; 3];
            }
        }
        a.mie_absorption = if keep == 1 && rng.bool() { a.mie_absorption } else { [0.0; 3] };
    }
    let (radius, thickness) = (atmosphere.planet_radius, atmosphere.thickness());
    let altitude = match rng.u8(0..8) {
        0 => -[100.0_f64, 11_000.0][rng.usize(0..2)].min(0.4 * radius),
        1 => [1e-3, 1.7, 100.0][rng.usize(0..3)],
        2 => thickness * rng.f64(),
        // The f64 and the f32 neighbours of the top.
        3 => [
            atmosphere.atmosphere_radius.next_down() - radius,
            thickness,
            atmosphere.atmosphere_radius.next_up() - radius,
            f64::from((thickness as f32).next_down()),
            f64::from((thickness as f32).next_up()),
        ][rng.usize(0..5)],
        4 => 15_000.0 + 35_000.0 * rng.f64(),
        _ => cases::altitudes(&atmosphere)[rng.usize(0..14)].min(9e14 - radius),
    };
    let dip = |up: f64| -((radius + up) / (radius + altitude.max(0.0))).min(1.0).acos();
    let pitch = match rng.u8(0..6) {
        0 => FRAC_PI_2,
        1 => -FRAC_PI_2,
        2 => dip(0.0),
        3 => dip(thickness),
        4 => 0.0,
        _ => PI * (rng.f64() - 0.5),
    };
    let sun = match rng.u8(0..8) {
        0 => FRAC_PI_2,
        1 => -FRAC_PI_2,
        2 => [1e-6, 0.0, -1e-6][rng.usize(0..3)],
        3 => -[6f64, 12.0, 18.0][rng.usize(0..3)].to_radians(),
        4 => dip(0.0),
        5 => pitch,
        6 => -pitch,
        _ => PI * (rng.f64() - 0.5),
    };
    let size = match rng.u16(0..200) {
        0 => [1, 4096],
        1..=10 => [1, 1],
        11..=20 => [1, 64],
        _ => [16, 12],
    };
    let turn = DQuat::from_euler(glam::EulerRot::XYZ, rng.f64(), rng.f64(), rng.f64());
    let center = [0.0, 1e9, 1e12][rng.usize(0..3)] * DVec3::new(0.6, -0.8, 0.3);
    let fov = [1.0, 1e-4, 0.01, 2.5][rng.usize(0..4)];
    let pose = Pose { altitude, pitch, heading: [0.0, PI, FRAC_PI_2, 1.0][rng.usize(0..4)], fov_y: fov };
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    let camera = Camera::above(DVec3::ZERO, radius, DVec3::Z, DVec3::X, pose, aspect);
    let camera = camera.map_or(Camera::new(DVec3::Z * radius, DVec3::X, DVec3::Z, fov, aspect), |c| Camera {
        position: center + turn * c.position,
        forward: turn * c.forward,
        up: turn * c.up,
        ..c
    });
    let near = [1e-4, 0.01, 1.0, 1e5][rng.usize(0..4)];
    let far = near * [1.001, 1e4, 1e8][rng.usize(0..3)];
    let depth = match rng.u8(0..5) {
        0 => DepthConvention::ZeroToOne { near, far },
        1 => DepthConvention::Reversed { near, far },
        2 => DepthConvention::ReversedInfinite { near },
        3 => DepthConvention::NegativeOneToOne { near, far },
        _ => DepthConvention::Logarithmic { far: far.max(0.01) },
    };
    let quality = match rng.u8(0..8) {
        0 => Quality::Luts(LutSettings::LOW),
        1 => Quality::March { view_samples: rng.u32(1..8), light_samples: rng.u32(1..4) },
        2 => Quality::Luts(LutSettings {
            orders: 4,
            sky_view: [16, 20],
            aerial: [4, 8, 7],
            aerial_steps: 2,
            ..TINY
        }),
        _ => Quality::Luts(TINY),
    };
    let composition = match rng.u8(0..8) {
        0 => Composition::SkyDome,
        1 => Composition::AtmospherePost,
        2 => Composition::Planet,
        _ => Composition::Full,
    };
    let planes = [1e-4, 0.01, 1e3, 1e6, 1e8, f64::INFINITY, f64::INFINITY, f64::INFINITY];
    Frame {
        scene: Scene {
            camera,
            planet_center: center,
            atmosphere,
            sun_direction: turn * DVec3::new(sun.cos(), 0.0, sun.sin()) * [1.0, 1e-9, 1e9][rng.usize(0..3)],
            depth,
            moon: None,
            ellipsoid: None,
        },
        settings: SkySettings {
            quality,
            render_scale: if rng.u8(0..4) == 0 { 0.5 } else { 1.0 },
            look: Look { composition, sun_disk: rng.bool(), limb_darkening: rng.bool(), ..Look::default() },
            bound: [None, Some(Bound::EXACT), Some(Bound::LINEAR)][rng.usize(0..3)],
        },
        size,
        planes: (0..7).map(|_| planes[rng.usize(0..8)]).collect(),
    }
}

/// Draws a frame twice, over a black and over a white scene, and looks for the first pixel that is wrong.
///
/// # Errors
/// What [`Scene::validate`] or the backend reports.
pub fn look(backend: &mut dyn Backend, frame: &Frame) -> Result<Option<Fault>> {
    let mut sky = SkyRenderer::new(frame.settings)?;
    let mut made = Vec::new();
    let pixels = pictures(backend, frame, &mut sky, &mut made);
    sky.destroy(backend);
    made.into_iter().for_each(|id| backend.destroy_texture(id));
    let [black, white] = pixels?;
    let width = frame.size[0];
    let pairs = black.as_chunks::<4>().0.iter().zip(white.as_chunks::<4>().0);
    Ok(pairs.enumerate().find_map(|(i, (black, white))| {
        let pixel = [i as u32 % width, i as u32 / width];
        fault(black, white).map(|what| Fault { pixel, over: [*black, *white], what })
    }))
}

fn fault(black: &[f32; 4], white: &[f32; 4]) -> Option<&'static str> {
    if black.iter().chain(white).any(|v| !v.is_finite()) {
        return Some("a value that is not finite");
    }
    if black.iter().chain(white).any(|v| *v < 0.0) {
        return Some("negative light");
    }
    for c in 0..3 {
        let (black, through) = (f64::from(black[c]), f64::from(white[c]) - f64::from(black[c]));
        // What 24 bits leave of a difference.
        let slack = 4.0 * f64::from(f32::EPSILON) * (1.0 + black);
        if through < -slack || through > 1.0 + slack {
            return Some("transmittance that is not within 0 to 1");
        }
    }
    None
}

fn pictures(
    backend: &mut dyn Backend,
    frame: &Frame,
    sky: &mut SkyRenderer,
    made: &mut Vec<TextureId>,
) -> Result<[Vec<f32>; 2]> {
    let Frame { scene, size: [w, h], planes, .. } = frame;
    let mut texture = |backend: &mut dyn Backend, label, format| {
        let id = backend.create_texture(&TextureDesc::new(label, *w, *h, format))?;
        made.push(id);
        Ok::<_, crate::Error>(id)
    };
    let color = texture(backend, "frame", Format::Rgba32Float)?;
    let out = texture(backend, "frame with air", Format::Rgba32Float)?;
    let depth = texture(backend, "frame's depth", Format::R32Float)?;
    let stored = |y: u32| {
        let z = planes.get(y as usize % planes.len().max(1)).copied().unwrap_or(f64::INFINITY);
        let stored = if z.is_finite() { scene.depth.encode(z) } else { scene.depth.background() };
        // What a depth buffer holds, whatever was drawn.
        (stored as f32).clamp(0.0, 1.0)
    };
    let depths: Vec<f32> = (0..*h).flat_map(|y| std::iter::repeat_n(stored(y), *w as usize)).collect();
    backend.write_texture(depth, &depths)?;
    let mut both = [Vec::new(), Vec::new()];
    for (white, pixels) in [0.0, 1.0].into_iter().zip(&mut both) {
        let behind = [white, white, white, 1.0];
        let target = Target { clear: Some(behind), ..Target::color(color) };
        let over = frame.settings.look.composition == Composition::Planet;
        let drawn = if over { Target::color(color) } else { Target::color(out) };
        let aerial = AerialTargets { color: Some(color).filter(|_| !over), depth, target: drawn };
        let drawn = sky.frame(backend, scene, &FrameTargets::background(target).with_aerial(aerial))?;
        let mut passes = drawn.background.to_vec();
        if !passes.iter().any(|p| p.target.color == color) {
            passes.push(Pass::clear("clear", target));
        }
        let last = if drawn.aerial.is_empty() || over { color } else { out };
        passes.extend_from_slice(drawn.aerial);
        backend.run(&passes)?;
        *pixels = backend.read(last)?;
    }
    Ok(both)
}

/// Replaces parts of a frame by plain ones, one after the other, as long as anything is wrong with it.
///
/// # Errors
/// As [`look`].
pub fn shrink_frame(backend: &mut dyn Backend, frame: &Frame) -> Result<Frame> {
    type Change = fn(&mut Frame);
    let changes: &[Change] = &[
        |f| f.scene.atmosphere = AtmosphereParams::earth(),
        |f| f.scene.atmosphere.rayleigh_scattering = [0.0; 3],
        |f| f.scene.atmosphere.mie_scattering = [0.0; 3],
        |f| f.scene.atmosphere.mie_absorption = [0.0; 3],
        |f| f.scene.atmosphere.ozone_absorption = [0.0; 3],
        |f| f.scene.atmosphere.mie_asymmetry = [0.0; 3],
        |f| f.scene.atmosphere.mie_phase = MiePhase::HenyeyGreenstein,
        |f| f.scene.atmosphere.ground_albedo = [0.0; 3],
        |f| f.scene.atmosphere.sun_intensity = 1.0,
        |f| f.scene.atmosphere.rayleigh_scale_height = 8000.0,
        |f| f.scene.atmosphere.mie_scale_height = 1200.0,
        |f| f.scene.atmosphere.ozone_center_altitude = 25e3,
        |f| f.scene.atmosphere.ozone_half_width = 15e3,
        |f| {
            let turned = f.scene.camera.position - f.scene.planet_center;
            (f.scene.camera.position, f.scene.planet_center) = (turned, DVec3::ZERO);
        },
        |f| f.scene.sun_direction = f.scene.sun_direction.normalize(),
        |f| f.scene.depth = DepthConvention::default(),
        |f| f.settings.quality = Quality::March { view_samples: 1, light_samples: 1 },
        |f| f.settings.quality = Quality::Luts(TINY),
        |f| f.settings.look.composition = Composition::SkyDome,
        |f| f.settings.look.composition = Composition::AtmospherePost,
        |f| f.settings.render_scale = 1.0,
        |f| f.settings.look.sun_disk = false,
        |f| f.planes = vec![f64::INFINITY],
        |f| f.size = [1, 1],
        |f| f.size = [16, 12],
    ];
    let mut best = frame.clone();
    let mut done = false;
    while !done {
        done = true;
        for change in changes {
            let mut plainer = best.clone();
            change(&mut plainer);
            let smaller = plainer.size[0] * plainer.size[1] <= best.size[0] * best.size[1];
            if plainer != best && smaller && look(backend, &plainer).is_ok_and(|fault| fault.is_some()) {
                best = plainer;
                done = false;
            }
        }
    }
    Ok(best)
}
