//! What a program of this crate reads, set in a program of the user's.

use glow::HasContext as _;

use super::{NAME, RING, WebGlBackend};
use crate::error::Result;
use crate::gpu::{Inputs, Program, TEXTURES_MAX, UNIFORM_MAX, Uniform, check_inputs};

/// A uniform block and textures for a program of the user's; see [`WebGlBackend::bindings`].
#[derive(Clone, Copy, Debug)]
pub struct Bindings {
    block: &'static str,
    ring: glow::Buffer,
    offset: i32,
    point: u32,
    /// Names after the prefix, textures, and whether they are interpolated.
    textures: [Option<(&'static str, glow::Texture, bool)>; TEXTURES_MAX],
}

impl WebGlBackend {
    /// What a program reads, for a program of the user's with a block of the given name, and with samplers
    /// that have the slots' names after `welkin_`. Good until the backend has run 63 passes more, or destroys
    /// a texture. `label`: for errors.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and [`crate::ErrorKind::Driver`] for textures and a block that are not
    /// the program's; [`crate::ErrorKind::Lost`].
    pub fn bindings(
        &mut self,
        label: &str,
        program: Program,
        block: &'static str,
        inputs: &Inputs,
        uniform: &Uniform,
    ) -> Result<Bindings> {
        let bound = check_inputs(NAME, label, program, inputs, uniform)?;
        let mut textures = [None; TEXTURES_MAX];
        for ((texture, id), slot) in textures.iter_mut().zip(bound).zip(program.info().textures) {
            let Some(id) = id else { continue };
            *texture = Some((slot.name, self.textures.find(id)?.handle()?, slot.filtered));
        }
        let offset = self.guarded(|this| Ok(this.upload_block(uniform)))?;
        Ok(Bindings { block, ring: self.ring, offset, point: self.binding_point, textures })
    }

    /// Writes a block to the next slot of the ring and binds it; answers its offset, bytes.
    pub(super) fn upload_block(&mut self, uniform: &Uniform) -> i32 {
        crate::count::one(|c| &mut c.uniform_uploads);
        let offset = (self.ring_next * self.ring_stride) as i32;
        // SAFETY: the ring is alive, and a slot holds UNIFORM_MAX bytes.
        unsafe {
            let (ring, point) = (Some(self.ring), self.binding_point);
            self.gl.bind_buffer(glow::UNIFORM_BUFFER, ring);
            self.gl.buffer_sub_data_u8_slice(glow::UNIFORM_BUFFER, offset, uniform.bytes());
            self.gl.bind_buffer_range(glow::UNIFORM_BUFFER, point, ring, offset, UNIFORM_MAX as i32);
        }
        self.ring_next = (self.ring_next + 1) % RING;
        offset
    }
}

impl Bindings {
    /// Makes a program of the user's current and sets what it reads: textures on units from `unit` on, as
    /// many as [`Inputs`] has, and the block at the last binding point of the context
    /// (`MAX_UNIFORM_BUFFER_BINDINGS` less 1), which the backend uses too: yours has others, and this is to
    /// be called again after each call of the backend. What the program does not have is left out.
    pub fn set(&self, gl: &glow::Context, program: glow::Program, unit: u32) {
        // SAFETY: the caller's context is current, the program is of it; buffer and textures are alive, by
        // the words at `WebGlBackend::bindings`.
        unsafe {
            gl.use_program(Some(program));
            if let Some(index) = gl.get_uniform_block_index(program, self.block) {
                gl.uniform_block_binding(program, index, self.point);
                let (point, ring) = (self.point, Some(self.ring));
                gl.bind_buffer_range(glow::UNIFORM_BUFFER, point, ring, self.offset, UNIFORM_MAX as i32);
            }
            for (unit, (name, texture, filtered)) in (unit..).zip(self.textures.iter().flatten()) {
                let name = ["welkin_", name].concat();
                let Some(location) = gl.get_uniform_location(program, &name) else { continue };
                gl.active_texture(glow::TEXTURE0 + unit);
                gl.bind_texture(glow::TEXTURE_2D, Some(*texture));
                gl.bind_sampler(unit, None);
                let filter = if *filtered { glow::LINEAR } else { glow::NEAREST };
                for (parameter, value) in [
                    (glow::TEXTURE_MIN_FILTER, filter),
                    (glow::TEXTURE_MAG_FILTER, filter),
                    (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                    (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                ] {
                    gl.tex_parameter_i32(glow::TEXTURE_2D, parameter, value as i32);
                }
                gl.uniform_1_i32(Some(&location), unit as i32);
            }
        }
    }
}
