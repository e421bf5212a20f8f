//! Times qualities on a device: what [`ParetoFront`] holds of it.

use std::time::Duration;

use glam::DVec3;

use super::picture::{PictureRenderer, PictureSettings};
use crate::error::{Error, Result};
use crate::frame::luts::MEDIUM_LABELS;
use crate::gpu::{Backend, Inputs, Pass, Program, Target, TextureDesc, TextureId};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::{Camera, DepthConvention, Pose, Scene};
use crate::settings::front::{MeanError, Measured, ParetoFront, Point};
use crate::settings::quality::Quality;
use crate::settings::{LutSettings, SkySettings};
use crate::shaders::copy;

/// Rounds of timing of which the best counts; one more before them does not.
const ROUNDS: usize = 3;

impl ParetoFront {
    /// Times some qualities on a backend, in frames of `size` pixels: the mean over three Earth scenes
    /// (ground, limb, whole planet), each the best of three rounds, with a full-screen copy in the same
    /// submissions. The errors are [`Self::committed`]'s, which do not depend on the device.
    ///
    /// This waits for the GPU: seconds on a software driver. Scenes alternate, so that nothing of the frame
    /// before can be used again.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for no qualities, for one whose numbers are not among the committed, and
    /// for a size that the backend does not have, before anything is created;
    /// [`crate::ErrorKind::Unavailable`] where waiting or timing is impossible (browsers); errors of the
    /// backend.
    pub fn measure(backend: &mut dyn Backend, qualities: &[Quality], size: [u32; 2]) -> Result<Self> {
        let committed = Self::committed();
        let committed = committed.on(backend.info().backend).unwrap_or(committed);
        let errors = |quality: &Quality| committed.errors(quality);
        Self::measure_with(backend, qualities, size, &errors, &committed.source())
    }

    /// As [`Self::measure`], with errors from elsewhere; `errors_from` says from where.
    pub fn measure_with(
        backend: &mut dyn Backend,
        qualities: &[Quality],
        size: [u32; 2],
        errors: &dyn Fn(&Quality) -> Result<[MeanError; 3]>,
        errors_from: &str,
    ) -> Result<Self> {
        if qualities.is_empty() {
            return Err(Error::invalid("qualities", "none", "at least one"));
        }
        let mut points = Vec::with_capacity(qualities.len());
        for quality in qualities {
            SkySettings::from(*quality).validate()?;
            points.push(Point { quality: *quality, time: Duration::ZERO, errors: errors(quality)? });
        }
        let copy_to = TextureDesc::new("front", size[0], size[1], PictureSettings::default().radiance);
        copy_to.validate(backend.info().max_texture_size)?;
        let scenes = scenes(f64::from(size[0]) / f64::from(size[1]))?;
        let copy_to = backend.create_texture(&copy_to)?;
        let mut renderers = Renderers::default();
        let timed = time(backend, &mut renderers, &scenes, &mut points, size, copy_to);
        renderers.0.iter_mut().for_each(|(_, r)| r.destroy(backend));
        backend.destroy_texture(copy_to);
        let copy = timed?;
        let info = backend.info();
        let line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        Ok(Self {
            measured: vec![Measured {
                backend: info.backend.to_owned(),
                adapter: line(&info.adapter),
                driver: line(&info.driver),
                timer: info.timer.to_string(),
                size,
                errors_from: line(errors_from),
                copy,
                points,
            }],
        })
    }
}

/// A camera above Earth: altitude in metres, then degrees: of the sun from the zenith, pitch, field of view.
const SCENES: [[f64; 4]; 3] = [[2.0, 60.0, 20.0, 60.0], [400e3, 70.0, -19.0, 10.0], [1e7, 60.0, -90.0, 50.0]];

fn scenes(aspect: f64) -> Result<Vec<Scene>> {
    let scene = |[altitude, sun, pitch, fov]: [f64; 4]| {
        let atmosphere = AtmosphereParams::earth();
        let (pitch, fov_y) = (pitch.to_radians(), fov.to_radians());
        let pose = Pose { altitude, pitch, heading: 0.0, fov_y };
        let (sin, cos) = sun.to_radians().sin_cos();
        Ok(Scene {
            camera: Camera::above(DVec3::ZERO, atmosphere.planet_radius, DVec3::Z, DVec3::X, pose, aspect)?,
            planet_center: DVec3::ZERO,
            atmosphere,
            sun_direction: DVec3::new(sin, 0.0, cos),
            depth: DepthConvention::default(),
            moon: None,
            ellipsoid: None,
        })
    };
    SCENES.into_iter().map(scene).collect()
}

/// A renderer for each set of LUTs, so that none is filled anew in every round, and one for what has none.
#[derive(Default)]
struct Renderers(Vec<(Option<LutSettings>, PictureRenderer)>);

impl Renderers {
    fn of(&mut self, quality: Quality) -> &mut PictureRenderer {
        let lut = match quality {
            Quality::Luts(lut) => Some(lut),
            Quality::March { .. } => None,
        };
        let at = self.0.iter().position(|(of, _)| *of == lut).unwrap_or_else(|| {
            self.0.push((lut, PictureRenderer::default()));
            self.0.len() - 1
        });
        &mut self.0[at].1
    }
}

/// Fills in the times of `points`; answers the best of the copy.
fn time(
    backend: &mut dyn Backend,
    renderers: &mut Renderers,
    scenes: &[Scene],
    points: &mut [Point],
    size: [u32; 2],
    copy_to: TextureId,
) -> Result<Duration> {
    let program = backend.create_program(Program::new(&copy::INFO, 0))?;
    let mut best = vec![f64::INFINITY; points.len() * scenes.len()];
    let mut best_copy = f64::INFINITY;
    // Round after round, so that a disturbance of a moment does not hit every run of a quality.
    for round in 0..=ROUNDS {
        let each = points.iter().flat_map(|p| scenes.iter().map(move |s| (p.quality, s)));
        for ((quality, scene), best) in each.zip(&mut best) {
            let settings =
                PictureSettings { sky: quality.into(), terrain: None, ..PictureSettings::default() };
            let (passes, drawn) = renderers.of(quality).passes(backend, scene, &settings, size)?;
            let mut passes: Vec<Pass> =
                passes.iter().filter(|p| p.target.color != drawn.display).cloned().collect();
            let inputs = Inputs::new([("source", Some(drawn.radiance))]);
            passes.push(Pass {
                program: Some(program),
                inputs,
                ..Pass::clear("copy", Target::color(copy_to))
            });
            let times = backend.times(&passes)?;
            // The first round makes pipelines and warms caches.
            if let Some((copy, sky)) = times.split_last().filter(|_| round > 0) {
                let of_frame = sky.iter().filter(|t| !MEDIUM_LABELS.contains(&t.label));
                *best = best.min(of_frame.map(|t| t.nanoseconds).sum());
                best_copy = best_copy.min(copy.nanoseconds);
            }
        }
    }
    let duration = |nanoseconds: f64| Duration::from_nanos(nanoseconds.max(0.0) as u64);
    for (point, best) in points.iter_mut().zip(best.chunks(scenes.len())) {
        point.time = duration(best.iter().sum::<f64>() / best.len() as f64);
    }
    Ok(duration(best_copy))
}
