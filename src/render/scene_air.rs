//! The air for a scene's own shaders: what a user binds to them.

use crate::error::Result;
use crate::frame::Frame;
use crate::frame::graph::Resource;
use crate::frame::scene_air::SceneAirUniform;
#[cfg(any(feature = "wgpu", feature = "webgl"))]
use crate::gpu::Program;
use crate::gpu::{Backend, Inputs, TexturePool, Uniform};
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
}

impl SceneAir {
    /// The program whose layout a user's shader shares.
    #[cfg(any(feature = "wgpu", feature = "webgl"))]
    pub(crate) const PROGRAM: Program = Program::new(&scene_air::INFO, scene_air::INFO.all());

    /// That of a frame, if its look asks for it: with the LUTs that its passes leave in a pool.
    pub(crate) fn of(frame: &Frame, backend: &dyn Backend, pool: &mut TexturePool) -> Result<Option<Self>> {
        if !frame.settings.look.scene_shaders {
            return Ok(None);
        }
        let mut inputs = Inputs::NONE;
        let reads = frame.scene_reads();
        for slot in scene_air::INFO.textures {
            let read = reads.iter().flatten().find(|(name, _)| *name == slot.name);
            let id = match read.and_then(|(_, resource)| *resource) {
                Some(Resource::Pool(key)) => pool.find(backend, key),
                _ => None,
            };
            inputs.push(slot.name, id)?;
        }
        let place = (frame.view.altitude, frame.view.sun.z.clamp(-1.0, 1.0));
        Ok(Some(Self { block: frame.scene_air_block(), inputs, place, left: frame.sunlight_left() }))
    }

    /// The same with light from the sky for the function `irradiance`, which is 0 without.
    pub fn with_light(self, light: &SkyLight) -> Self {
        let (altitude, sun_sine) = self.place;
        let harmonics = light.harmonics(altitude, sun_sine).0;
        let harmonics = harmonics.map(|v| std::array::from_fn(|c| v[c] * self.left[c]));
        Self { block: self.block.with_harmonics(harmonics), ..self }
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
