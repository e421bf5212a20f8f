//! Textures and framebuffers of the user's: what a context tells about them is compared with what the user
//! says, when they are handed over.

use glow::HasContext as _;

use super::{NAME, Source, Texture, WebGlBackend};
use crate::error::{Error, Result};
use crate::gpu::{Format, TextureDesc, TextureId};

/// What a framebuffer tells of an attachment of a format: the parameter, what it must be, and what it is
/// called.
fn expected(format: Format) -> Option<[(u32, u32, &'static str); 3]> {
    let red = |bits, kind| {
        [
            (glow::FRAMEBUFFER_ATTACHMENT_RED_SIZE, bits, "bits of red"),
            (glow::FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, kind, "type of its values"),
            (glow::FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, glow::LINEAR, "color encoding"),
        ]
    };
    Some(match format {
        Format::Rgba8 => red(8, glow::UNSIGNED_NORMALIZED),
        Format::Rgba16Float => red(16, glow::FLOAT),
        Format::Rgba32Float | Format::R32Float => red(32, glow::FLOAT),
        Format::Depth32Float => [
            (glow::FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, 32, "bits of depth"),
            (glow::FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, glow::FLOAT, "type of its values"),
            (glow::FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, glow::LINEAR, "color encoding"),
        ],
        Format::Bgra8 => return None,
    })
}

impl WebGlBackend {
    /// Makes a user's texture known, to be read by passes or drawn to; it stays the user's.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a `desc` that is out of range, or of another format than the texture
    /// has. Contexts do not tell a texture's size: that `desc` has to be right about.
    pub fn import_texture(&mut self, texture: glow::Texture, desc: TextureDesc) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        self.guarded(|this| {
            let is_depth = desc.format == Format::Depth32Float;
            let point = if is_depth { glow::DEPTH_ATTACHMENT } else { glow::COLOR_ATTACHMENT0 };
            // SAFETY: a framebuffer made here, and the user's texture, which the caller says is alive.
            unsafe {
                let gl = this.gl.clone();
                let framebuffer = gl.create_framebuffer().map_err(|e| Error::driver(NAME, "import", e))?;
                gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
                gl.framebuffer_texture_2d(glow::FRAMEBUFFER, point, glow::TEXTURE_2D, Some(texture), 0);
                let told = this.users.map_or(Ok(()), |users| (users.compare)(&gl, point, &desc));
                gl.delete_framebuffer(framebuffer);
                told?;
            }
            Ok(this.textures.insert(Texture { desc, content: 0, source: Source::User(texture) }))
        })
    }

    /// Makes a user's framebuffer known as a target (`None`: the default one). Its rows are usually
    /// [`RowOrder::BottomUp`](crate::gpu::RowOrder::BottomUp). Its own depth attachment is used; pass no
    /// depth target with it.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a `desc` that is out of range, or of another format than the
    /// framebuffer's color has. Contexts do not tell its size: that `desc` has to be right about.
    pub fn import_framebuffer(
        &mut self,
        framebuffer: Option<glow::Framebuffer>,
        desc: TextureDesc,
    ) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        self.guarded(|this| {
            if let Some(users) = this.users {
                // SAFETY: the user's framebuffer, which the caller says is alive.
                unsafe { this.gl.bind_framebuffer(glow::FRAMEBUFFER, framebuffer) };
                let point = if framebuffer.is_some() { glow::COLOR_ATTACHMENT0 } else { glow::BACK };
                (users.compare)(&this.gl, point, &desc)?;
            }
            Ok(this.textures.insert(Texture { desc, content: 0, source: Source::Framebuffer(framebuffer) }))
        })
    }

    /// OpenGL's name of a texture, of the backend's own or imported, for your own shaders to read: a LUT,
    /// say, or the radiance of a picture. `None` for a framebuffer, and for ids of nothing.
    pub fn texture_name(&self, id: TextureId) -> Option<glow::Texture> {
        self.textures.get(id)?.handle().ok()
    }

    /// Calls `f` with a framebuffer of two textures bound and the viewport as large as they are, for a user
    /// to draw to; binds afterwards what was bound before. The framebuffer belongs to the backend. OpenGL
    /// draws from the lowest row on: your scene stands upright in textures whose rows are
    /// [`RowOrder::BottomUp`](crate::gpu::RowOrder::BottomUp), all of a frame's alike.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Driver`] for textures that are not there, or that no framebuffer can have
    /// together.
    pub fn with_framebuffer(
        &mut self,
        color: TextureId,
        depth: TextureId,
        f: impl FnOnce(&glow::Context, Option<glow::Framebuffer>),
    ) -> Result<()> {
        let TextureDesc { width, height, .. } = self.textures.find(color)?.desc;
        let framebuffer = self.guarded(|this| this.framebuffer(color, Some(depth)))?;
        let gl = self.gl.clone();
        let mut viewport = [0; 4];
        // SAFETY: the caller's context is current; bindings are put back as they were.
        unsafe {
            let draw = gl.get_parameter_framebuffer(glow::DRAW_FRAMEBUFFER_BINDING);
            let read = gl.get_parameter_framebuffer(glow::READ_FRAMEBUFFER_BINDING);
            gl.get_parameter_i32_slice(glow::VIEWPORT, &mut viewport);
            gl.bind_framebuffer(glow::FRAMEBUFFER, framebuffer);
            gl.viewport(0, 0, width as i32, height as i32);
            f(&gl, framebuffer);
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, draw);
            gl.bind_framebuffer(glow::READ_FRAMEBUFFER, read);
            gl.viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        }
        Ok(())
    }
}

/// Compares the framebuffer that is bound with what the user says of it. One that cannot be drawn to
/// tells nothing: textures that are only read may be such, and a context without a window has such a
/// default.
pub(super) fn compare(gl: &glow::Context, point: u32, desc: &TextureDesc) -> Result<()> {
    // SAFETY: questions about the framebuffer that is bound.
    let complete = unsafe { gl.check_framebuffer_status(glow::FRAMEBUFFER) } == glow::FRAMEBUFFER_COMPLETE;
    for (parameter, want, what) in expected(desc.format).into_iter().flatten().filter(|_| complete) {
        // SAFETY: as above.
        let told =
            unsafe { gl.get_framebuffer_attachment_parameter_i32(glow::FRAMEBUFFER, point, parameter) };
        // Some say of a canvas that it has no type.
        if told as u32 != want && !(point == glow::BACK && told == 0) {
            let field = format_args!("{}: {what}", desc.label);
            let allowed = format_args!("{}, as {:?} has", text(want), desc.format);
            return Err(Error::invalid(field, text(told as u32), allowed));
        }
    }
    // Whatever it is, drawing will say it.
    // SAFETY: no arguments.
    unsafe { gl.get_error() };
    Ok(())
}

/// A number, or the name of a constant.
fn text(value: u32) -> String {
    match value {
        glow::FLOAT => "float".into(),
        glow::UNSIGNED_NORMALIZED => "normalized".into(),
        glow::LINEAR => "linear".into(),
        glow::SRGB => "sRGB".into(),
        glow::UNSIGNED_INT => "whole numbers".into(),
        other => other.to_string(),
    }
}
