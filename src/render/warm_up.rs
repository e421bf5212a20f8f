//! Programs and pipelines made ahead, so that no frame of a flight waits for one.

use std::collections::HashSet;

use glam::{DVec2, DVec3};

use super::picture::{PictureRenderer, PictureSettings};
use super::sky::{Composition, Method, SkyRenderer, SkySettings};
use crate::error::Result;
use crate::frame::lut::LutSettings;
use crate::frame::plan::EffectPlan;
use crate::gpu::{Backend, Format, Pass, ProgramId, Target, TextureDesc, TextureId};
use crate::model::moon::Moon;
use crate::model::scene::{Camera, Pose, Scene};
use crate::shaders::Program;

/// What a [`SkyRenderer`]'s passes draw to; pipelines depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SkyTargets {
    /// Format of the target of [`SkyRenderer::background`] and [`SkyRenderer::shell`].
    pub color: Format,
    /// Whether the background's target holds a depth buffer.
    pub depth_buffer: bool,
    /// Format of the target of [`SkyRenderer::aerial`].
    pub aerial: Format,
}

/// Smallest tables: their content is not looked at.
const TABLES: LutSettings = LutSettings {
    columns: [8, 8],
    moments: [8, 8],
    moment_steps: 4,
    orders: 1,
    sky: [8, 8],
    sky_steps: 4,
    air: [4, 4, 4],
    air_steps: 1,
};

const SIZE: [u32; 2] = [1, 1];

/// Metres to the moon of the views that have one.
const MOON_AWAY: f64 = 1e9;

#[derive(Debug)]
enum Drawer {
    Picture(Box<PictureRenderer>, Box<PictureSettings>),
    Sky { renderer: Box<SkyRenderer>, targets: SkyTargets, textures: Option<[TextureId; 4]> },
}

/// Makes what the views of a planet may call for, one program a step: draws views from the ground to far orbit, by day and
/// by night, on a single texel with the smallest tables. Drivers that compile at the first draw have done so then.
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
    drawer: Drawer,
    views: std::vec::IntoIter<Scene>,
    /// Of the view that is being made ready.
    scene: Option<Scene>,
    programs: Vec<Program>,
    passes: std::vec::IntoIter<Pass>,
    made: HashSet<Program>,
    drawn: HashSet<(ProgramId, bool)>,
}

impl WarmUp {
    /// For a [`PictureRenderer`]. Of the scene, only planet, air and depth convention count.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`] and [`SkySettings::validate`].
    pub fn picture(scene: &Scene, settings: &PictureSettings) -> Result<Self> {
        let settings = PictureSettings { sky: small(&settings.sky), ..*settings };
        settings.sky.validate()?;
        Self::new(scene, Drawer::Picture(Box::default(), Box::new(settings)))
    }

    /// For a [`SkyRenderer`].
    ///
    /// # Errors
    /// As [`Self::picture`].
    pub fn sky(scene: &Scene, settings: &SkySettings, targets: SkyTargets) -> Result<Self> {
        let renderer = Box::new(SkyRenderer::new(small(settings))?);
        Self::new(scene, Drawer::Sky { renderer, targets, textures: None })
    }

    fn new(scene: &Scene, drawer: Drawer) -> Result<Self> {
        scene.validate()?;
        Ok(Self {
            drawer,
            views: views(scene)?.into_iter(),
            scene: None,
            programs: Vec::new(),
            passes: Vec::new().into_iter(),
            made: HashSet::new(),
            drawn: HashSet::new(),
        })
    }

    /// Makes one program or one pipeline; `false` when all are there, and nothing else of this is left on the backend.
    ///
    /// # Errors
    /// Those of the backend.
    pub fn step(&mut self, backend: &mut dyn Backend) -> Result<bool> {
        loop {
            if let Some(program) = self.programs.pop() {
                if self.made.insert(program) {
                    backend.create_program(program)?;
                    return Ok(true);
                }
            } else if let Some(scene) = self.scene.take() {
                self.passes = self.drawer.passes(backend, &scene)?.into_iter();
            } else if let Some(pass) = self.passes.next() {
                backend.run(&[pass])?;
                if pass.program.is_some_and(|id| self.drawn.insert((id, pass.target.depth.is_some()))) {
                    return Ok(true);
                }
            } else if let Some(scene) = self.views.next() {
                let plan = EffectPlan::new(&scene, self.drawer.settings(), SIZE)?;
                self.programs = plan.passes().iter().filter_map(|p| p.program).collect();
                self.drawer.others(&mut self.programs);
                self.scene = Some(scene);
            } else {
                self.destroy(backend);
                return Ok(false);
            }
        }
    }

    /// Frees what is left when it is given up half-way; programs and pipelines stay.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        match &mut self.drawer {
            Drawer::Picture(renderer, _) => renderer.destroy(backend),
            Drawer::Sky { renderer, textures, .. } => {
                renderer.destroy(backend);
                textures.take().into_iter().flatten().for_each(|id| backend.destroy_texture(id));
            }
        }
    }
}

impl Drawer {
    fn settings(&self) -> &SkySettings {
        match self {
            Self::Picture(_, settings) => &settings.sky,
            Self::Sky { renderer, .. } => renderer.settings(),
        }
    }

    /// What a plan does not name: the sky where nothing is behind it, ground and tone mapping.
    fn others(&self, programs: &mut Vec<Program>) {
        for i in 0..programs.len() {
            if let Program::SkyLut { mie, .. } = programs[i] {
                programs.push(Program::SkyLut { mie, only: true });
            }
        }
        if let Self::Picture(_, settings) = self {
            programs.push(Program::ToneMap { map: settings.tone_map, dither: settings.dither });
            if settings.terrain.is_some() {
                let under = |p: &Program| matches!(p, Program::EclipseSky { .. } | Program::EclipseAerial { .. });
                let (sky, moon) = (programs.contains(&Program::LutMoments), programs.iter().any(under));
                programs.push(Program::Terrain { sky, moon });
            }
        }
    }

    fn passes(&mut self, backend: &mut dyn Backend, scene: &Scene) -> Result<Vec<Pass>> {
        let (renderer, targets, textures) = match self {
            Self::Picture(renderer, settings) => {
                return Ok(renderer.passes(backend, scene, settings, SIZE)?.0.to_vec());
            }
            Self::Sky { renderer, targets, textures } => (renderer, targets, textures),
        };
        let [color, buffer, depth, aerial] = match *textures {
            Some(made) => made,
            None => {
                let formats = [targets.color, Format::Depth32Float, Format::R32Float, targets.aerial];
                let mut made = [TextureId::default(); 4];
                for (id, format) in made.iter_mut().zip(formats) {
                    *id = backend.create_texture(&TextureDesc::new("warm-up", SIZE[0], SIZE[1], format))?;
                }
                *textures.insert(made)
            }
        };
        let target = Target::color(color);
        let behind = Target { depth: targets.depth_buffer.then_some(buffer), ..target };
        let black = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..behind };
        let mut passes = renderer.background(backend, scene, behind)?.to_vec();
        passes.extend_from_slice(renderer.background(backend, scene, black)?);
        match renderer.settings().composition {
            Composition::Planet => passes.extend_from_slice(renderer.shell(backend, scene, depth, target)?),
            _ => passes.extend_from_slice(renderer.aerial(backend, scene, color, depth, aerial)?),
        }
        Ok(passes)
    }
}

/// The same programs with next to no work.
fn small(settings: &SkySettings) -> SkySettings {
    let method = match settings.method {
        Method::Single { .. } => Method::Single { view_samples: 1, light_samples: 1 },
        Method::Lut(_) => Method::Lut(TABLES),
    };
    SkySettings { method, ..*settings }
}

/// Views that between them call for every program of a planet with these constituents: from the ground to beyond the air,
/// up and down, towards the sun and away from it, by day and by night.
fn views(scene: &Scene) -> Result<Vec<Scene>> {
    let p = &scene.atmosphere;
    let mut views = Vec::new();
    for sun_elevation in [0.7_f64, -1.2] {
        for altitude in [0.0, 0.2, 0.6, 1.5, 2.0 * p.planet_radius / p.thickness()] {
            for pitch in [sun_elevation, 0.2, -1.57] {
                let pose = Pose { altitude: altitude * p.thickness(), pitch, heading: 0.0, fov_y: 0.8 };
                let camera = Camera::above(scene.planet_center, p.planet_radius, DVec3::Z, DVec3::X, pose, 1.0)?;
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
                    ..scene.clone()
                }));
            }
        }
    }
    Ok(views)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_tables_are_allowed() {
        TABLES.validate().unwrap();
    }
}
