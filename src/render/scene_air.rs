//! The air for a scene's own shaders: what a user binds to them.

use crate::error::{Error, Result};
use crate::frame::Frame;
use crate::frame::graph::{Graph, Resource};
use crate::frame::scene_air::SceneAirUniform;
#[cfg(any(feature = "wgpu", feature = "webgl"))]
use crate::gpu::Program;
use crate::gpu::{Backend, Inputs, TEXTURES_MAX, TexturePool, Uniform, fold_contents};
use crate::render::sky_light::SkyLight;
use crate::shaders::generated_scene::scene_air;

/// What a frame's air is for a scene's own shaders: glass, water, particles, everything that is drawn after
/// the air before the scene or reflects the sky. Such a shader calls the functions of
/// [`shaders::scene`](crate::shaders::scene): the air between the camera and a point, the sky in a direction,
/// the light on a surface.
///
/// Frames have it with [`Look::scene_shaders`](crate::Look::scene_shaders), once the passes before the scene
/// have run; it is good until the next frame's. With wgpu,
/// [`WgpuBackend::air_group`](crate::gpu::wgpu::WgpuBackend::air_group) makes a bind group of it; with
/// OpenGL, [`WebGlBackend::scene_air`](crate::gpu::webgl::WebGlBackend::scene_air) sets it for a program of
/// yours.
#[derive(Clone, Copy, Debug)]
pub struct SceneAir {
    block: SceneAirUniform,
    inputs: Inputs,
    /// Of the camera, metres, and sine of the sun's elevation there: where its light is asked for.
    place: (f64, f64),
    left: [f64; 3],
    /// What the textures hold, folded.
    contents: u64,
}

impl SceneAir {
    /// The program whose layout a user's shader shares.
    #[cfg(any(feature = "wgpu", feature = "webgl"))]
    pub(crate) const PROGRAM: Program = Program::new(&scene_air::INFO, scene_air::INFO.all());

    /// That of a frame, if its look asks for it: with the LUTs that its passes leave in a pool.
    pub(crate) fn of(
        frame: &Frame,
        backend: &dyn Backend,
        graph: &Graph,
        pool: &mut TexturePool,
    ) -> Result<Option<Self>> {
        if !frame.settings.look.scene_shaders {
            return Ok(None);
        }
        let mut inputs = Inputs::NONE;
        let reads = frame.scene_reads();
        let mut contents = [None; TEXTURES_MAX];
        for (content, slot) in contents.iter_mut().zip(scene_air::INFO.textures) {
            let read = reads.iter().flatten().find(|(name, _)| *name == slot.name);
            let id = match read.and_then(|(_, resource)| *resource) {
                Some(resource @ Resource::Pool(key)) => {
                    *content = Some(graph.content_of(resource));
                    pool.find(backend, key)
                }
                _ => None,
            };
            inputs.push(slot.name, id)?;
        }
        let place = (frame.view.altitude, frame.view.sun.z.clamp(-1.0, 1.0));
        let (block, left) = (frame.scene_air_block(), frame.sunlight_left());
        Ok(Some(Self { block, inputs, place, left, contents: fold_contents(contents.into_iter().flatten()) }))
    }

    /// The same with light from the sky for the function `irradiance`, which is 0 without.
    pub fn with_light(self, light: &SkyLight) -> Self {
        let (altitude, sun_sine) = self.place;
        let harmonics = light.harmonics(altitude, sun_sine).0;
        let harmonics = harmonics.map(|v| std::array::from_fn(|c| v[c] * self.left[c]));
        Self { block: self.block.with_harmonics(harmonics), ..self }
    }

    /// Checks that the textures hold what this frame's passes draw to them: they were recorded, or run, and
    /// no other frame's since.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] where they do not.
    pub fn validate(&self, backend: &dyn Backend) -> Result<()> {
        let ids = self.inputs.iter().filter_map(|(_, id)| id);
        if fold_contents(ids.map(|id| backend.content(id))) == self.contents {
            return Ok(());
        }
        let value = "of another frame, or of one whose passes before the scene were not run";
        Err(Error::invalid("scene air", value, "the air of the frame that was run, or recorded, last"))
    }

    /// The uniform block, `welkin_SceneAir` in both languages, in the layout std140.
    pub fn block(&self) -> Uniform {
        Uniform::new(&self.block)
    }

    /// The textures by the names that they have in the shaders after `welkin_`; none where there is no air.
    pub fn textures(&self) -> Inputs {
        self.inputs
    }
}
