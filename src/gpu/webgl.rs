//! Passes on WebGL2 and OpenGL ES 3 through glow, with the GLSL that naga made beforehand.
//!
//! The context is yours ([`WebGlBackend::new`]); every call gives its state back as it was, except for the
//! last uniform buffer binding point, `MAX_UNIFORM_BUFFER_BINDINGS - 1`, which is this backend's (WebGL
//! has no way to ask what an indexed point holds that glow passes on). A context that nobody else draws
//! with can skip that: [`WebGlBackend::own`].
//!
//! Needed: OpenGL ES 3.0 or WebGL2 with `EXT_color_buffer_float`, or OpenGL 3.3 with `ARB_ES3_compatibility`
//! (which 4.3 includes): macOS' OpenGL has neither.
#![allow(unsafe_code)] // Every OpenGL call is a foreign function; see the reason at each block.

mod bindings;
mod context;
mod import;
mod precision;
mod state;

use std::sync::Arc;

use glow::HasContext as _;

pub use bindings::Bindings;

use super::arena::Arena;
use super::map::Map;
use super::{
    AdapterInfo, Backend, Blend, DepthUse, Format, Live, Pass, PassTime, Precision, Program, ProgramId,
    ReadId, TEXTURES_MAX, TextureDesc, TextureId, Ticket, TimerId, TimerKind, UNIFORM_MAX, Vertices,
    Viewport, check_pass, check_texels, encode_texels, unsuitable,
};
use crate::error::{Error, Result};
pub use context::SharedContext;
use state::{PLAIN_PIXELS, SWITCHES, Saved, store_pixels};

const NAME: &str = "webgl2";

// EXT_disjoint_timer_query.
const TIME_ELAPSED: u32 = 0x88BF;
const GPU_DISJOINT: u32 = 0x8FBB;
/// Uniform blocks in flight; the buffer is a ring.
const RING: u32 = 64;

/// What a user's context needs and one of the backend's own does not.
#[derive(Clone, Copy)]
struct Users {
    /// Takes the context's state.
    take: fn(&glow::Context, bool) -> Saved,
    /// Gives it back.
    restore: fn(&Saved, &glow::Context, bool),
    /// Compares what is bound with what the user says of it.
    compare: fn(&glow::Context, u32, &TextureDesc) -> Result<()>,
}

#[derive(Clone, Copy)]
enum Source {
    Own(glow::Texture),
    User(glow::Texture),
    /// A user's framebuffer; `None` is the default one.
    Framebuffer(Option<glow::Framebuffer>),
}

struct Texture {
    desc: TextureDesc,
    /// See [`Backend::content`].
    content: u64,
    source: Source,
}

struct Compiled {
    program: Program,
    handle: glow::Program,
}

/// A read-back on its way: the GPU copies to a buffer of its own, and a fence tells when it has.
struct Read {
    held: Arc<()>,
    desc: TextureDesc,
    /// What the buffer holds: four values a texel.
    wire: Format,
    buffer: glow::Buffer,
    fence: glow::Fence,
}

struct Timer {
    held: Arc<()>,
    passes: Vec<(&'static str, Option<glow::Query>, f64)>,
}

/// See the [module](self).
pub struct WebGlBackend {
    epoch: u32,
    gl: SharedContext,
    info: AdapterInfo,
    /// On a user's context. A program without such a context has no code for it.
    users: Option<Users>,
    web: bool,
    textures: Arena<TextureId, Texture>,
    programs: Arena<ProgramId, Compiled>,
    framebuffers: Map<(TextureId, Option<TextureId>), glow::Framebuffer>,
    reads: Arena<ReadId, Read>,
    timers: Arena<TimerId, Timer>,
    vertex_array: glow::VertexArray,
    nearest: glow::Sampler,
    linear: glow::Sampler,
    ring: glow::Buffer,
    ring_stride: u32,
    ring_next: u32,
    binding_point: u32,
    lost: Option<String>,
    /// Numbers of textures, programs and framebuffers at the last check for errors.
    checked: (usize, usize, usize),
}

/// Internal format, format and type.
fn format(format: Format) -> Option<(u32, u32, u32)> {
    Some(match format {
        Format::Rgba8 => (glow::RGBA8, glow::RGBA, glow::UNSIGNED_BYTE),
        Format::Bgra8 => return None,
        Format::Rgba16Float => (glow::RGBA16F, glow::RGBA, glow::HALF_FLOAT),
        Format::Rgba32Float => (glow::RGBA32F, glow::RGBA, glow::FLOAT),
        Format::R32Float => (glow::R32F, glow::RED, glow::FLOAT),
        Format::Depth32Float => (glow::DEPTH_COMPONENT32F, glow::DEPTH_COMPONENT, glow::FLOAT),
    })
}

/// The error for a format that WebGL2 lacks.
fn lacks_format(desc: &TextureDesc) -> Error {
    Error::invalid(
        format_args!("{}.format", desc.label),
        format_args!("{:?}", desc.format),
        "a format that WebGL2 has",
    )
}

impl Texture {
    /// What is read and written; not a framebuffer.
    fn handle(&self) -> Result<glow::Texture> {
        match self.source {
            Source::Own(handle) | Source::User(handle) => Ok(handle),
            Source::Framebuffer(_) => Err(Error::invalid(
                self.desc.label,
                "a framebuffer",
                "a texture: a framebuffer is only drawn to and read back",
            )),
        }
    }
}

/// What an error of OpenGL is called, and what it may come from. Browsers tell more in their consoles.
#[cfg(not(target_arch = "wasm32"))]
fn gl_error(code: u32) -> &'static str {
    match code {
        glow::INVALID_ENUM => ", invalid enum (of the user's before, if not of this call)",
        glow::INVALID_VALUE => ", invalid value (of the user's before, if not of this call)",
        glow::INVALID_OPERATION => ", invalid operation (is the backend's context current?)",
        glow::OUT_OF_MEMORY => ", out of memory",
        glow::INVALID_FRAMEBUFFER_OPERATION => {
            ", invalid framebuffer operation (is the output still there, and the backend's context current?)"
        }
        _ => "",
    }
}

#[cfg(target_arch = "wasm32")]
fn gl_error(_: u32) -> &'static str {
    ""
}

/// Whether a context is one of OpenGL's and not of OpenGL ES or WebGL.
fn is_desktop(gl: &glow::Context) -> bool {
    cfg!(not(target_arch = "wasm32")) && !gl.version().is_embedded
}

fn driver(what: impl ToString, reason: impl ToString) -> Error {
    Error::driver(NAME, what.to_string(), reason.to_string())
}

impl WebGlBackend {
    /// On a user's context, which must be current on this thread now and at every later call. Its state
    /// is put back after each call; see the [module](self) for the one exception. `gl` is an `Rc`, an `Arc`
    /// or a `'static` reference: see [`SharedContext`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] if the context cannot draw to float textures or lacks the shaders of
    /// OpenGL ES 3, or if it computes fragment shaders with fewer than 32 bits: one pixel is drawn to find
    /// out.
    pub fn new(gl: impl Into<SharedContext>) -> Result<Self> {
        let users = Users { take: Saved::take, restore: Saved::restore, compare: import::compare };
        Self::make(gl.into(), Some(users))
    }

    /// As [`Self::new`], on a context that nobody else uses: its state is not saved and put back.
    pub fn own(gl: impl Into<SharedContext>) -> Result<Self> {
        Self::make(gl.into(), None)
    }

    fn make(gl: SharedContext, users: Option<Users>) -> Result<Self> {
        let web = cfg!(target_arch = "wasm32");
        let extensions = gl.supported_extensions();
        // Natively the names begin with GL_.
        let has = |name: &str| extensions.iter().any(|e| e.ends_with(name));
        let mut filters_f32 = has("OES_texture_float_linear");
        if is_desktop(&gl) {
            // It draws to float textures, and filters them, since 3.0. The shaders are those of ES.
            let version = gl.version();
            if (version.major, version.minor) < (4, 3) && !has("ARB_ES3_compatibility") {
                let reason = "the context has no shaders of OpenGL ES 3: it takes OpenGL 4.3, or \
                    ARB_ES3_compatibility";
                return Err(Error::unavailable(NAME, reason));
            }
            filters_f32 = true;
        } else if !has("EXT_color_buffer_float") {
            return Err(Error::unavailable(
                NAME,
                "the context has no EXT_color_buffer_float: it cannot draw to float textures",
            ));
        }
        let timer = if extensions.iter().any(|e| e.contains("disjoint_timer_query")) {
            TimerKind::TimerQuery
        } else {
            TimerKind::Clock
        };
        let saved = users.map(|users| ((users.take)(&gl, web), users.restore));
        let failed = |e: String| driver("create", e);
        // SAFETY: the caller's context is current; only objects made here are touched.
        let mut made = unsafe {
            // Left-over errors of the user are not ours.
            while gl.get_error() != glow::NO_ERROR {}
            let alignment = gl.get_parameter_i32(glow::UNIFORM_BUFFER_OFFSET_ALIGNMENT).max(16) as u32;
            let ring_stride = (UNIFORM_MAX as u32).next_multiple_of(alignment);
            let ring = gl.create_buffer().map_err(failed)?;
            gl.bind_buffer(glow::UNIFORM_BUFFER, Some(ring));
            gl.buffer_data_size(glow::UNIFORM_BUFFER, (ring_stride * RING) as i32, glow::DYNAMIC_DRAW);
            // They stand above a texture's own parameters, whoever made it.
            let sampler = |filter: u32| {
                let sampler = gl.create_sampler().map_err(failed)?;
                for (parameter, value) in [
                    (glow::TEXTURE_MIN_FILTER, filter),
                    (glow::TEXTURE_MAG_FILTER, filter),
                    (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                    (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                ] {
                    gl.sampler_parameter_i32(sampler, parameter, value as i32);
                }
                Ok::<_, Error>(sampler)
            };
            let (nearest, linear) = (sampler(glow::NEAREST)?, sampler(glow::LINEAR)?);
            let epoch = super::next_epoch();
            Self {
                epoch,
                info: AdapterInfo {
                    backend: NAME,
                    adapter: gl.get_parameter_string(glow::RENDERER),
                    driver: gl.get_parameter_string(glow::VERSION),
                    timer,
                    max_texture_size: gl.get_parameter_i32(glow::MAX_TEXTURE_SIZE).max(1) as u32,
                    filters_f32,
                    precision: Precision::Full,
                },
                users,
                web,
                textures: Arena::new(NAME, epoch),
                programs: Arena::new(NAME, epoch),
                framebuffers: Map::new(),
                reads: Arena::new(NAME, epoch),
                timers: Arena::new(NAME, epoch),
                vertex_array: gl.create_vertex_array().map_err(failed)?,
                nearest,
                linear,
                ring,
                ring_stride,
                ring_next: 0,
                binding_point: gl.get_parameter_i32(glow::MAX_UNIFORM_BUFFER_BINDINGS).max(1) as u32 - 1,
                lost: None,
                checked: (0, 0, 0),
                gl,
            }
        };
        let precision = precision::test(&made.gl, web, made.vertex_array, made.ring, made.binding_point);
        if let Some((saved, restore)) = saved {
            restore(&saved, &made.gl, web);
        }
        made.info.precision = precision?;
        Ok(made)
    }

    /// The context that it draws with; a clone shares it.
    pub fn context(&self) -> &SharedContext {
        &self.gl
    }

    /// Gives [`AdapterInfo::adapter`] a better name than the context's own, which browsers keep vague.
    pub fn set_adapter_name(&mut self, name: &str) {
        name.clone_into(&mut self.info.adapter);
    }

    /// Tells the backend that its context is gone; every later call says so.
    pub fn set_lost(&mut self, reason: &str) {
        self.lost = Some(reason.to_owned());
    }

    /// Runs `f` with the user's state put back afterwards.
    fn guarded<T>(&mut self, f: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if let Some(reason) = &self.lost {
            return Err(Error::lost(NAME, reason.as_str()));
        }
        if cfg!(debug_assertions) && self.users.is_some() {
            // Debug builds ask for errors after every call: the user's before it are not ours.
            // SAFETY: no arguments.
            unsafe { self.gl.get_error() };
        }
        let saved = self.users.map(|users| ((users.take)(&self.gl, self.web), users.restore));
        let result = f(self);
        if let Some((saved, restore)) = saved {
            restore(&saved, &self.gl, self.web);
        }
        result
    }

    /// [`Self::check`] where something new was made since the last one: drivers object to objects, not to
    /// their repetition, and asking makes a browser wait for the GPU. Debug builds always ask.
    fn check_news(&mut self, what: &str) -> Result<()> {
        let made = (self.textures.len(), self.programs.len(), self.framebuffers.len());
        if cfg!(debug_assertions) || made != self.checked {
            self.checked = made;
            return self.check(what);
        }
        Ok(())
    }

    fn check(&mut self, what: &str) -> Result<()> {
        // SAFETY: no arguments.
        match unsafe { self.gl.get_error() } {
            glow::NO_ERROR => Ok(()),
            // CONTEXT_LOST_WEBGL, GL_CONTEXT_LOST.
            code @ (0x9242 | 0x0507) => {
                let reason = format!("context lost (GL error {code:#06x})");
                self.lost = Some(reason.clone());
                Err(Error::lost(NAME, reason))
            }
            code => Err(driver(what, format!("GL error {code:#06x}{}", gl_error(code)))),
        }
    }

    /// Checks what a pass draws to; answers what its colour target is.
    fn check_targets(&self, pass: &Pass) -> Result<TextureDesc> {
        let color = self.textures.find(pass.target.color)?.desc;
        if color.format == Format::Depth32Float && pass.texels.is_none() {
            return Err(unsuitable(pass.label, "color target", color, "a format of colors"));
        }
        if let Some(depth) = pass.target.depth {
            let depth = self.textures.find(depth)?.desc;
            if depth.format != Format::Depth32Float
                || (depth.width, depth.height) != (color.width, color.height)
            {
                let allowed = "Depth32Float and as large as the color target";
                return Err(unsuitable(pass.label, "depth target", depth, allowed));
            }
        }
        pass.target.viewport.map_or(Ok(()), |viewport| viewport.validate(&color))?;
        Ok(color)
    }

    /// The framebuffer that draws to these textures; made at the first use.
    fn framebuffer(
        &mut self,
        color: TextureId,
        depth: Option<TextureId>,
    ) -> Result<Option<glow::Framebuffer>> {
        let handle = |this: &Self, id: TextureId| -> Result<Source> { Ok(this.textures.find(id)?.source) };
        let color_texture = match handle(self, color)? {
            Source::Framebuffer(framebuffer) => return Ok(framebuffer),
            Source::Own(t) | Source::User(t) => t,
        };
        if let Some(&known) = self.framebuffers.get(&(color, depth)) {
            return Ok(Some(known));
        }
        let gl = self.gl.clone();
        // SAFETY: attaches living textures to a new framebuffer.
        let made = unsafe {
            let framebuffer = gl.create_framebuffer().map_err(|e| driver("framebuffer", e))?;
            gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
            let is_depth = self.textures.get(color).is_some_and(|t| t.desc.format == Format::Depth32Float);
            let point = if is_depth { glow::DEPTH_ATTACHMENT } else { glow::COLOR_ATTACHMENT0 };
            gl.framebuffer_texture_2d(glow::FRAMEBUFFER, point, glow::TEXTURE_2D, Some(color_texture), 0);
            if let Some(depth) = depth
                && let Source::Own(t) | Source::User(t) = handle(self, depth)?
            {
                gl.framebuffer_texture_2d(
                    glow::FRAMEBUFFER,
                    glow::DEPTH_ATTACHMENT,
                    glow::TEXTURE_2D,
                    Some(t),
                    0,
                );
            }
            let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
            if status != glow::FRAMEBUFFER_COMPLETE {
                gl.delete_framebuffer(framebuffer);
                return Err(driver("framebuffer", format!("incomplete, status {status:#06x}")));
            }
            framebuffer
        };
        self.framebuffers.insert((color, depth), made);
        Ok(Some(made))
    }

    fn draw(&mut self, pass: &Pass) -> Result<()> {
        let contents = pass.contents(|id| self.content(id));
        self.draw_only(pass)?;
        for (id, content) in contents.into_iter().flatten() {
            self.set_content(id, content);
        }
        Ok(())
    }

    fn draw_only(&mut self, pass: &Pass) -> Result<()> {
        let desc = self.check_targets(pass)?;
        if let Some(texels) = &pass.texels {
            return self.upload(pass.target.color, texels);
        }
        let mut bound = [None; TEXTURES_MAX];
        let program = match pass.program {
            Some(id) => {
                let compiled = self.programs.find(id)?;
                bound = check_pass(NAME, pass, compiled.program)?;
                Some((compiled.program, compiled.handle))
            }
            None => None,
        };
        let mut read = [None; TEXTURES_MAX];
        let slots = program.map_or(&[][..], |(program, _)| program.info().textures);
        for ((handle, id), slot) in read.iter_mut().zip(bound).zip(slots) {
            // Nothing is bound where the program's constants leave a texture unread.
            let Some(id) = id else { continue };
            let texture = self.textures.find(id)?;
            if slot.filtered && texture.desc.format == Format::Depth32Float {
                return Err(unsuitable(pass.label, slot.name, texture.desc, "a format of colors"));
            }
            *handle = Some(texture.handle()?);
        }
        let framebuffer = self.framebuffer(pass.target.color, pass.target.depth)?;
        if program.is_some() && !pass.uniform.bytes().is_empty() {
            self.upload_block(&pass.uniform);
        }
        let gl = &self.gl;
        // SAFETY: all objects are alive (looked up above); the uniform range lies inside the ring and is at
        // least as large as the block (check_pass); vertex shaders make their own vertices.
        unsafe {
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, framebuffer);
            let all = Viewport { x: 0, y: 0, width: desc.width, height: desc.height };
            let Viewport { x, y, width, height } = pass.target.viewport.unwrap_or(all);
            gl.viewport(x as i32, y as i32, width as i32, height as i32);
            for switch in SWITCHES {
                gl.disable(switch);
            }
            gl.color_mask(true, true, true, true);
            gl.depth_mask(true);
            if let Some(clear) = pass.target.clear {
                gl.clear_buffer_f32_slice(glow::COLOR, 0, &clear);
            }
            if let Some(clear) = pass.target.clear_depth {
                gl.clear_buffer_f32_slice(glow::DEPTH, 0, &[clear]);
            }
            let Some((program, handle)) = program else { return Ok(()) };
            // Depth ALWAYS without write is the same as no test.
            if let DepthUse::Nearer { reversed } = pass.depth {
                gl.enable(glow::DEPTH_TEST);
                gl.depth_func(if reversed { glow::GREATER } else { glow::LESS });
            } else {
                gl.depth_mask(false);
            }
            if program.blends() {
                gl.enable(glow::BLEND);
                gl.blend_equation(glow::FUNC_ADD);
                if program.blend() == Blend::Multiply {
                    gl.blend_func_separate(glow::DST_COLOR, glow::ZERO, glow::ZERO, glow::ONE);
                } else {
                    gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
                }
            }
            gl.use_program(Some(handle));
            gl.bind_vertex_array(Some(self.vertex_array));
            for ((unit, texture), slot) in (0..).zip(read).zip(program.info().textures) {
                if texture.is_some() {
                    gl.active_texture(glow::TEXTURE0 + unit);
                    gl.bind_texture(glow::TEXTURE_2D, texture);
                    gl.bind_sampler(unit, Some(if slot.filtered { self.linear } else { self.nearest }));
                }
            }
            let vertices = program.info().vertices;
            let mode = if vertices == Vertices::Triangle { glow::TRIANGLES } else { glow::TRIANGLE_STRIP };
            gl.draw_arrays(mode, 0, vertices.count() as i32);
            // Textures stay bound to no unit of ours: the next pass may draw to them.
            for (unit, texture) in (0..).zip(read) {
                if texture.is_some() {
                    gl.active_texture(glow::TEXTURE0 + unit);
                    gl.bind_texture(glow::TEXTURE_2D, None);
                    gl.bind_sampler(unit, None);
                }
            }
        }
        Ok(())
    }

    fn compile(&self, program: Program) -> Result<glow::Program> {
        let name = program.name();
        let (names, [vertex, fragment]) = (&program.info().glsl, program.glsl());
        let gl = &self.gl;
        // SAFETY: objects made here; on failure they are deleted before returning.
        unsafe {
            let handle = gl.create_program().map_err(|e| driver(&name, e))?;
            let stages = [(glow::VERTEX_SHADER, vertex), (glow::FRAGMENT_SHADER, fragment)];
            let mut problem = None;
            for (stage, text) in stages {
                let shader = gl.create_shader(stage).map_err(|e| driver(&name, e))?;
                gl.shader_source(shader, &text);
                gl.compile_shader(shader);
                if !gl.get_shader_compile_status(shader) {
                    problem.get_or_insert_with(|| gl.get_shader_info_log(shader));
                }
                gl.attach_shader(handle, shader);
                // Freed together with the program.
                gl.delete_shader(shader);
            }
            if problem.is_none() {
                gl.link_program(handle);
                if !gl.get_program_link_status(handle) {
                    problem = Some(gl.get_program_info_log(handle));
                }
            }
            if let Some(problem) = problem {
                gl.delete_program(handle);
                return Err(driver(format!("program {name}"), problem));
            }
            for block in names.blocks.iter().filter(|b| !b.is_empty()) {
                if let Some(index) = gl.get_uniform_block_index(handle, block) {
                    gl.uniform_block_binding(handle, index, self.binding_point);
                }
            }
            gl.use_program(Some(handle));
            for (unit, sampler) in (0..).zip(names.samplers) {
                // Drivers drop a sampler that is not read: it has no location, and setting that does nothing.
                gl.uniform_1_i32(gl.get_uniform_location(handle, sampler).as_ref(), unit);
            }
            Ok(handle)
        }
    }

    /// Fills a texture with values.
    fn upload(&self, id: TextureId, texels: &[f32]) -> Result<()> {
        let texture = self.textures.find(id)?;
        let desc = texture.desc;
        check_texels(&desc, texels)?;
        let handle = texture.handle()?;
        let Some((_, layout, kind)) = format(desc.format) else { return Err(lacks_format(&desc)) };
        let bytes = encode_texels(desc.format, texels);
        self.plain_pixels();
        let (w, h) = (desc.width as i32, desc.height as i32);
        let data = glow::PixelUnpackData::Slice(Some(&bytes));
        // SAFETY: `bytes` holds every texel of the texture in its format.
        unsafe {
            let gl = &self.gl;
            gl.active_texture(glow::TEXTURE0);
            gl.bind_texture(glow::TEXTURE_2D, Some(handle));
            gl.tex_sub_image_2d(glow::TEXTURE_2D, 0, 0, 0, w, h, layout, kind, data);
            gl.bind_texture(glow::TEXTURE_2D, None);
        }
        Ok(())
    }

    /// Rows and texels packed without gaps, no pixel buffers.
    fn plain_pixels(&self) {
        // SAFETY: default values of the pixel store, which every context takes.
        unsafe {
            self.gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            self.gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
            store_pixels(&self.gl, self.web, PLAIN_PIXELS, [false; 2]);
        }
    }
}

impl Backend for WebGlBackend {
    fn info(&self) -> &AdapterInfo {
        &self.info
    }

    fn create_texture(&mut self, desc: &TextureDesc) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        let (internal, ..) = format(desc.format).ok_or_else(|| lacks_format(desc))?;
        let desc = *desc;
        self.guarded(|this| {
            // SAFETY: a new texture, its size within the limit.
            let handle = unsafe {
                let gl = &this.gl;
                let handle = gl.create_texture().map_err(|e| driver(desc.label, e))?;
                gl.active_texture(glow::TEXTURE0);
                gl.bind_texture(glow::TEXTURE_2D, Some(handle));
                gl.tex_storage_2d(glow::TEXTURE_2D, 1, internal, desc.width as i32, desc.height as i32);
                gl.bind_texture(glow::TEXTURE_2D, None);
                handle
            };
            if let Err(e) = this.check(desc.label) {
                // SAFETY: made above, used by nothing.
                unsafe { this.gl.delete_texture(handle) };
                return Err(e);
            }
            Ok(this.textures.insert(Texture { desc, content: 0, source: Source::Own(handle) }))
        })
    }

    fn texture(&self, id: TextureId) -> Option<TextureDesc> {
        self.textures.get(id).map(|t| t.desc)
    }

    fn epoch(&self) -> u32 {
        self.epoch
    }

    fn content(&self, id: TextureId) -> u64 {
        self.textures.get(id).map_or(0, |t| t.content)
    }

    fn set_content(&mut self, id: TextureId, content: u64) {
        if let Some(texture) = self.textures.get_mut(id) {
            texture.content = content;
        }
    }

    fn destroy_texture(&mut self, id: TextureId) {
        let gl = self.gl.clone();
        self.framebuffers.retain(|&(color, depth), framebuffer| {
            let keep = color != id && depth != Some(id);
            if !keep {
                // SAFETY: made by this backend; forgotten here.
                unsafe { gl.delete_framebuffer(*framebuffer) };
            }
            keep
        });
        if let Some(Texture { source: Source::Own(handle), .. }) = self.textures.remove(id) {
            // SAFETY: made by this backend; forgotten here.
            unsafe { gl.delete_texture(handle) };
        }
    }

    fn write_texture(&mut self, id: TextureId, texels: &[f32]) -> Result<()> {
        self.guarded(|this| {
            this.upload(id, texels)?;
            this.check("write_texture")
        })
    }

    fn create_program(&mut self, program: Program) -> Result<ProgramId> {
        if let Some(id) = self.programs.position(|c| c.program == program) {
            return Ok(id);
        }
        self.guarded(|this| {
            let handle = this.compile(program)?;
            this.check("program")?;
            Ok(this.programs.insert(Compiled { program, handle }))
        })
    }

    fn destroy_program(&mut self, id: ProgramId) {
        if let Some(compiled) = self.programs.remove(id) {
            // SAFETY: made by this backend; forgotten here.
            unsafe { self.gl.delete_program(compiled.handle) };
        }
    }

    fn run(&mut self, passes: &[Pass]) -> Result<()> {
        self.guarded(|this| {
            for pass in passes {
                this.draw(pass)?;
            }
            this.check_news("run")
        })
    }

    fn begin_read(&mut self, id: TextureId) -> Result<Ticket<ReadId>> {
        let desc = self.textures.find(id)?.desc;
        if desc.format == Format::Depth32Float {
            return Err(Error::invalid(
                format_args!("read of {}", desc.label),
                "a depth buffer",
                "a color texture: WebGL2 reads no depth; copy it first",
            ));
        }
        self.forget_given_up();
        let held = Arc::default();
        let read = self.guarded(|this| {
            let framebuffer = this.framebuffer(id, None)?;
            this.plain_pixels();
            let wire = if desc.format == Format::Rgba8 { Format::Rgba8 } else { Format::Rgba32Float };
            let kind = if wire == Format::Rgba8 { glow::UNSIGNED_BYTE } else { glow::FLOAT };
            let size = (desc.texels() * wire.bytes()) as i32;
            let (w, h) = (desc.width as i32, desc.height as i32);
            let gl = &this.gl;
            // SAFETY: RGBA with these types reads from any colour buffer here, and the buffer holds all
            // texels.
            let (buffer, fence) = unsafe {
                // To both ends: with the canvas to draw to, Chromium reads as if from there.
                gl.bind_framebuffer(glow::FRAMEBUFFER, framebuffer);
                let buffer = gl.create_buffer().map_err(|e| driver("read back", e))?;
                gl.bind_buffer(glow::PIXEL_PACK_BUFFER, Some(buffer));
                gl.buffer_data_size(glow::PIXEL_PACK_BUFFER, size, glow::STREAM_READ);
                let to = glow::PixelPackData::BufferOffset(0);
                gl.read_pixels(0, 0, w, h, glow::RGBA, kind, to);
                gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
                let fence = gl.fence_sync(glow::SYNC_GPU_COMMANDS_COMPLETE, 0);
                // Nobody may draw any more, and without this the fence would not be reached.
                gl.flush();
                (buffer, fence.map_err(|e| driver("read back", e))?)
            };
            this.check("read back")?;
            Ok(Read { held, desc, wire, buffer, fence })
        })?;
        Ok(Ticket::new(&read.held.clone(), self.reads.insert(read)))
    }

    fn poll_read(&mut self, ticket: &Ticket<ReadId>) -> Result<Option<Vec<f32>>> {
        let fence = self.reads.find(ticket.id)?.fence;
        self.guarded(|this| {
            // SAFETY: a fence of a read that is kept.
            let state = unsafe { this.gl.client_wait_sync(fence, 0, 0) };
            if state == glow::TIMEOUT_EXPIRED {
                return Ok(None);
            }
            let Some(Read { desc, wire, buffer, fence, .. }) = this.reads.remove(ticket.id) else {
                return Ok(None);
            };
            // SAFETY: `bytes` is as long as the buffer, which is deleted after its only use.
            let bytes = unsafe {
                this.gl.bind_buffer(glow::PIXEL_PACK_BUFFER, Some(buffer));
                let bytes = buffer_bytes(&this.gl, desc.texels() * wire.bytes());
                this.gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
                this.gl.delete_sync(fence);
                this.gl.delete_buffer(buffer);
                bytes
            };
            this.check("read back")?;
            // Four values a texel come back, of which a format may have one.
            let (texel, value) = (wire.bytes(), wire.bytes() / 4);
            let mut values = Vec::with_capacity(desc.texels() * desc.format.channels());
            for texel in bytes.chunks_exact(texel) {
                for v in texel.chunks_exact(value).take(desc.format.channels()) {
                    values.push(match *v {
                        [a, b, c, d] => f32::from_le_bytes([a, b, c, d]),
                        _ => f32::from(v[0]) / 255.0,
                    });
                }
            }
            Ok(Some(values))
        })
    }

    fn begin_times(&mut self, passes: &[Pass]) -> Result<Ticket<TimerId>> {
        self.forget_given_up();
        let query = self.info.timer == TimerKind::TimerQuery;
        let timed = self.guarded(|this| {
            let gl = this.gl.clone();
            let mut timed = Vec::with_capacity(passes.len());
            for pass in passes {
                if query {
                    // SAFETY: the extension is there; begin and end pair up.
                    let q = unsafe {
                        let q = gl.create_query().map_err(|e| driver("timer", e))?;
                        gl.begin_query(TIME_ELAPSED, q);
                        q
                    };
                    let drawn = this.draw(pass);
                    // SAFETY: as above.
                    unsafe { gl.end_query(TIME_ELAPSED) };
                    drawn?;
                    timed.push((pass.label, Some(q), 0.0));
                } else {
                    timed.push((pass.label, None, this.clock(pass)?));
                }
            }
            this.check("times")?;
            Ok(timed)
        })?;
        let held = Arc::default();
        Ok(Ticket::new(&held, self.timers.insert(Timer { held: held.clone(), passes: timed })))
    }

    fn poll_times(&mut self, ticket: &Ticket<TimerId>) -> Result<Option<Vec<PassTime>>> {
        let id = ticket.id;
        let timer = self.timers.find(id)?;
        let gl = &self.gl;
        let queries: Vec<_> = timer.passes.iter().filter_map(|(_, q, _)| *q).collect();
        // SAFETY: queries made by this backend and not yet deleted.
        let ready = || {
            queries
                .iter()
                .all(|&q| unsafe { gl.get_query_parameter_u32(q, glow::QUERY_RESULT_AVAILABLE) } != 0)
        };
        if !ready() {
            return Ok(None);
        }
        let Some(timer) = self.timers.remove(id) else { return Ok(None) };
        // SAFETY: results are available; each query is deleted after its only use.
        let (times, disjoint) = unsafe {
            let times: Vec<_> = timer
                .passes
                .iter()
                .map(|&(label, q, clock)| {
                    let nanoseconds = q.map_or(clock, |q| {
                        let n = gl.get_query_parameter_u32(q, glow::QUERY_RESULT);
                        gl.delete_query(q);
                        f64::from(n)
                    });
                    PassTime { label, nanoseconds }
                })
                .collect();
            (times, !queries.is_empty() && gl.get_parameter_i32(GPU_DISJOINT) != 0)
        };
        if disjoint {
            return Err(driver("times", "the GPU's clock was disturbed (GPU_DISJOINT); measure again"));
        }
        Ok(Some(times))
    }

    fn wait(&mut self) -> Result<()> {
        if self.web {
            return Err(super::cannot_wait(NAME));
        }
        // SAFETY: no arguments.
        unsafe { self.gl.finish() };
        self.check("wait")
    }

    fn lost(&self) -> Option<String> {
        self.lost.clone()
    }

    fn live(&self) -> Live {
        Live {
            textures: self.textures.len(),
            texture_bytes: self.textures.values().map(|t| t.desc.texels() * t.desc.format.bytes()).sum(),
            programs: self.programs.len(),
            framebuffers: self.framebuffers.len(),
            pipelines: 0,
            bind_groups: 0,
            reads: self.reads.len(),
        }
    }
}

/// The bytes of the buffer that is bound for pixels to be packed into.
///
/// # Safety
/// The buffer has that many bytes, and is not mapped.
unsafe fn buffer_bytes(gl: &glow::Context, len: usize) -> Vec<u8> {
    let mut bytes = vec![0; len];
    // SAFETY: as the caller promises; what is mapped is copied and unmapped before anything else happens.
    unsafe {
        #[cfg(target_arch = "wasm32")]
        gl.get_buffer_sub_data(glow::PIXEL_PACK_BUFFER, 0, &mut bytes);
        // OpenGL ES has no such function.
        #[cfg(not(target_arch = "wasm32"))]
        {
            let mapped = gl.map_buffer_range(glow::PIXEL_PACK_BUFFER, 0, len as i32, glow::MAP_READ_BIT);
            if !mapped.is_null() {
                std::ptr::copy_nonoverlapping(mapped, bytes.as_mut_ptr(), len);
                gl.unmap_buffer(glow::PIXEL_PACK_BUFFER);
            }
        }
    }
    bytes
}

impl WebGlBackend {
    /// Frees what was kept for tickets that were dropped.
    fn forget_given_up(&mut self) {
        let gl = self.gl.clone();
        self.reads.retain(|read| {
            let keep = Arc::strong_count(&read.held) > 1;
            if !keep {
                // SAFETY: made by this backend; forgotten here.
                unsafe {
                    gl.delete_sync(read.fence);
                    gl.delete_buffer(read.buffer);
                }
            }
            keep
        });
        self.timers.retain(|timer| {
            let keep = Arc::strong_count(&timer.held) > 1;
            for (_, query, _) in timer.passes.iter().filter(|_| !keep) {
                if let Some(query) = query {
                    // SAFETY: made by this backend; forgotten here.
                    unsafe { gl.delete_query(*query) };
                }
            }
            keep
        });
    }

    /// Nanoseconds of a pass by a wall clock that waits before and after.
    #[cfg(not(target_arch = "wasm32"))]
    fn clock(&mut self, pass: &Pass) -> Result<f64> {
        // SAFETY: no arguments.
        unsafe { self.gl.finish() };
        let start = std::time::Instant::now();
        self.draw(pass)?;
        // SAFETY: no arguments.
        unsafe { self.gl.finish() };
        Ok(start.elapsed().as_nanos() as f64)
    }

    /// As natively; reading one pixel back is what makes a browser wait.
    #[cfg(target_arch = "wasm32")]
    fn clock(&mut self, pass: &Pass) -> Result<f64> {
        let wait = |this: &Self| {
            let mut pixel = [0; 16];
            // SAFETY: one pixel into a buffer that holds it.
            unsafe {
                this.gl.read_pixels(
                    0,
                    0,
                    1,
                    1,
                    glow::RGBA,
                    glow::FLOAT,
                    glow::PixelPackData::Slice(Some(&mut pixel)),
                )
            };
        };
        let now = || js_sys::Date::now();
        wait(self);
        let start = now();
        self.draw(pass)?;
        wait(self);
        Ok((now() - start) * 1e6)
    }
}

impl Drop for WebGlBackend {
    fn drop(&mut self) {
        let gl = &self.gl;
        // SAFETY: everything deleted here was made by this backend; a lost context ignores it.
        unsafe {
            for framebuffer in self.framebuffers.values() {
                gl.delete_framebuffer(*framebuffer);
            }
            for texture in self.textures.values() {
                if let Source::Own(handle) = texture.source {
                    gl.delete_texture(handle);
                }
            }
            for compiled in self.programs.values() {
                gl.delete_program(compiled.handle);
            }
            for (_, query, _) in self.timers.values().flat_map(|t| &t.passes) {
                if let Some(query) = query {
                    gl.delete_query(*query);
                }
            }
            for read in self.reads.values() {
                gl.delete_sync(read.fence);
                gl.delete_buffer(read.buffer);
            }
            gl.delete_vertex_array(self.vertex_array);
            gl.delete_sampler(self.nearest);
            gl.delete_sampler(self.linear);
            gl.delete_buffer(self.ring);
        }
    }
}
