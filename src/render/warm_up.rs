//! Programs and pipelines made ahead, so that no frame of a flight waits for one.

use glam::{DVec2, DVec3};

use super::picture::{PictureSettings, list};
use crate::error::Result;
use crate::frame::Frame;
use crate::frame::graph::{Graph, Node, Resource, Stage, Work};
use crate::frame::tone_map::{Display, is_8_bit};
use crate::gpu::{Backend, DepthUse, Format, Inputs, Pass, Program, Target, TextureDesc, TextureId, Uniform};
use crate::model::moon::Moon;
use crate::model::scene::{Camera, Pose, Scene};
use crate::settings::{LutSettings, Quality, SkySettings};

/// What a [`crate::SkyRenderer`]'s passes draw to; pipelines depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TargetFormats {
    /// Format of the background's target.
    pub color: Format,
    /// Whether the background's target holds a depth buffer.
    pub depth_buffer: bool,
    /// Format of the target of the air before the scene.
    pub aerial: Format,
}

/// A pipeline to be made: what has to be drawn once, to a target of which kind.
#[derive(Clone, Copy, Debug)]
struct Job {
    label: &'static str,
    program: Program,
    uniform: Uniform,
    depth: Option<DepthUse>,
    format: TexelFormat,
}

/// The format of a job's target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TexelFormat {
    Known(Format),
    /// That of a texture of the pool, which the backend decides.
    Pool(crate::frame::graph::Extent),
}

impl Job {
    fn is_same(&self, other: &Self) -> bool {
        (self.program, self.depth, self.format) == (other.program, other.depth, other.format)
    }
}

/// Makes the programs and pipelines that the views of a planet may call for, one a step: from the ground to
/// far orbit, by day and by night. Which these are follows from the frames of such views, without a GPU. Each
/// is drawn once, to a single texel: drivers that compile at the first draw have done so then.
///
/// ```no_run
/// # fn frame(backend: &mut dyn welkin::gpu::Backend, scene: &welkin::Scene) -> welkin::Result<()> {
/// # let settings = welkin::PictureSettings::default();
/// let mut warm_up = welkin::WarmUp::picture(scene, &settings)?;
/// // At start, or one step in each of the first frames:
/// while warm_up.step(backend)? {}
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct WarmUp {
    jobs: std::vec::IntoIter<Job>,
    /// A job whose program is made and which is to be drawn.
    made: Option<Job>,
    programs: Vec<Program>,
    textures: Vec<(Format, TextureId)>,
}

const SIZE: [u32; 2] = [1, 1];

/// Metres to the moon of the views that have one.
const MOON_AWAY: f64 = 1e9;

impl WarmUp {
    /// For a [`crate::PictureRenderer`]. Of the scene, only planet, air and depth convention count.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`] and [`SkySettings::validate`].
    pub fn picture(scene: &Scene, settings: &PictureSettings) -> Result<Self> {
        let mut jobs = Vec::new();
        let mut graph = Graph::default();
        let targets =
            TargetFormats { color: settings.radiance, depth_buffer: true, aerial: settings.radiance };
        for view in views(scene)? {
            let frame = Frame::new(&view, &quick(&settings.sky), SIZE)?;
            list(&mut graph, &frame, settings.terrain.as_ref(), Stage::Scene);
            graph.nodes.iter().for_each(|node| push(&mut jobs, node, &targets, true));
        }
        let (tone_map, exposure, display) = (settings.tone_map, 1.0, Format::Rgba8);
        let dither = settings.dither && is_8_bit(display);
        let node = Display { tone_map, exposure, dither, flipped: false }.node();
        push(&mut jobs, &node, &TargetFormats { color: display, depth_buffer: false, aerial: display }, true);
        Ok(Self::new(jobs))
    }

    /// For a [`crate::SkyRenderer`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`] and [`SkySettings::validate`].
    pub fn sky(scene: &Scene, settings: &SkySettings, targets: TargetFormats) -> Result<Self> {
        let mut jobs = Vec::new();
        let mut graph = Graph::default();
        for view in views(scene)? {
            // Before a target that holds nothing, and before stars.
            for behind in [false, true] {
                let mut frame = Frame::new(&view, &quick(settings), SIZE)?;
                frame.behind = behind;
                graph.list(&frame, |_| true, None);
                graph.nodes.iter().for_each(|node| push(&mut jobs, node, &targets, false));
            }
        }
        Ok(Self::new(jobs))
    }

    fn new(jobs: Vec<Job>) -> Self {
        Self { jobs: jobs.into_iter(), made: None, programs: Vec::new(), textures: Vec::new() }
    }

    /// How many pipelines are still to be made.
    pub fn remaining(&self) -> usize {
        self.jobs.len() + usize::from(self.made.is_some())
    }

    /// Makes one program or one pipeline; `false` when all are there, and nothing else of this is left on the
    /// backend.
    ///
    /// # Errors
    /// Those of the backend.
    pub fn step(&mut self, backend: &mut dyn Backend) -> Result<bool> {
        if let Some(job) = self.made.take() {
            self.draw(backend, &job)?;
            return Ok(true);
        }
        let Some(job) = self.jobs.next() else {
            self.destroy(backend);
            return Ok(false);
        };
        if self.programs.contains(&job.program) {
            self.draw(backend, &job)?;
        } else {
            backend.create_program(job.program)?;
            self.programs.push(job.program);
            self.made = Some(job);
        }
        Ok(true)
    }

    /// Draws one texel with a job's program; every texture that it reads is the backend's placeholder.
    fn draw(&mut self, backend: &mut dyn Backend, job: &Job) -> Result<()> {
        let format = match job.format {
            TexelFormat::Known(format) => format,
            TexelFormat::Pool(extent) => extent.desc(job.label, backend).format,
        };
        let color = self.texture(backend, format)?;
        let depth = job.depth.map(|_| self.texture(backend, Format::Depth32Float)).transpose()?;
        let mut inputs = Inputs::NONE;
        for slot in job.program.info().textures {
            inputs.push(slot.name, None)?;
        }
        let program = Some(backend.create_program(job.program)?);
        let target = Target { depth, ..Target::color(color) };
        let (uniform, depth) = (job.uniform, job.depth.unwrap_or_default());
        backend.run(&[Pass { program, inputs, uniform, depth, ..Pass::clear(job.label, target) }])
    }

    fn texture(&mut self, backend: &mut dyn Backend, format: Format) -> Result<TextureId> {
        if let Some((_, id)) = self.textures.iter().find(|(made, _)| *made == format) {
            return Ok(*id);
        }
        let id = backend.create_texture(&TextureDesc::new("warm-up", SIZE[0], SIZE[1], format))?;
        self.textures.push((format, id));
        Ok(id)
    }

    /// Frees what is left when it is given up half-way; programs and pipelines stay.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.textures.drain(..).for_each(|(_, id)| backend.destroy_texture(id));
    }
}

/// Adds what a node draws with to the list, unless it is there. black: the background's target is cleared to
/// opaque black.
fn push(jobs: &mut Vec<Job>, node: &Node, targets: &TargetFormats, black: bool) {
    let Work::Draw(program) = node.work else { return };
    let format = match (node.writes, node.extent) {
        (Resource::Pool(_), Some(extent)) => TexelFormat::Pool(extent.of_one_texel()),
        (Resource::Aerial, _) => TexelFormat::Known(targets.aerial),
        _ => TexelFormat::Known(targets.color),
    };
    let depth = (node.writes == Resource::Background && targets.depth_buffer).then_some(node.depth);
    let over_black = node.over_black.filter(|_| black);
    // A target that is not black needs the other one too.
    let plain = Some(program).filter(|_| over_black.is_none());
    for program in [plain, node.over_black].into_iter().flatten() {
        let job = Job { label: node.label, program, uniform: node.uniform, depth, format };
        if !jobs.iter().any(|j| j.is_same(&job)) {
            jobs.push(job);
        }
    }
}

/// The same programs with next to no work.
fn quick(settings: &SkySettings) -> SkySettings {
    let quality = match settings.quality {
        Quality::March { .. } => Quality::March { view_samples: 1, light_samples: 1 },
        Quality::Luts(_) => Quality::Luts(LutSettings::TINY),
    };
    SkySettings { quality, ..*settings }
}

/// Views that between them call for every program of a planet with these constituents: from the ground to
/// beyond the air, up and down, towards the sun and away from it, by day and by night.
fn views(scene: &Scene) -> Result<Vec<Scene>> {
    let p = &scene.atmosphere;
    let mut views = Vec::new();
    for sun_elevation in [0.7_f64, -1.2] {
        for altitude in [0.0, 0.2, 0.6, 1.5, 2.0 * p.planet_radius / p.thickness()] {
            for pitch in [sun_elevation, 0.2, -1.57] {
                let pose = Pose { altitude: altitude * p.thickness(), pitch, heading: 0.0, fov_y: 0.8 };
                let camera =
                    Camera::above(scene.planet_center, p.planet_radius, DVec3::Z, DVec3::X, pose, 1.0)?;
                let sun = DVec2::from_angle(sun_elevation);
                let sun_direction = DVec3::new(sun.x, 0.0, sun.y);
                views.push(Scene { camera, sun_direction, moon: None, ..scene.clone() });
                // Half before the sun: its own program, and that of a sun behind it.
                let aside = sun_direction + DVec3::Y * p.sun_angular_radius;
                let radius = p.sun_angular_radius * MOON_AWAY;
                views.extend(scene.moon.map(|_| Scene {
                    camera,
                    sun_direction,
                    moon: Some(Moon::new(camera.position + aside * MOON_AWAY, radius)),
                    ellipsoid: None,
                    ..scene.clone()
                }));
            }
        }
    }
    Ok(views)
}
