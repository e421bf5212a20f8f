//! Passes on WebGL2 and OpenGL ES 3 through glow, with the GLSL that naga made beforehand.
//!
//! The context is yours ([`WebGlBackend::new`]); every call gives its state back as it was, except for the
//! last uniform buffer binding point, `MAX_UNIFORM_BUFFER_BINDINGS - 1`, which is this backend's (WebGL
//! has no way to ask what an indexed point holds that glow passes on). A context that nobody else draws
//! with can skip that: [`WebGlBackend::own`].
//!
//! Needed: OpenGL ES 3.0 or WebGL2 with `EXT_color_buffer_float`.
#![allow(unsafe_code)] // Every OpenGL call is a foreign function; see the reason at each block.

mod precision;
mod state;

use std::rc::Rc;

use glow::HasContext as _;
use slotmap::SlotMap;

use super::map::Map;
use super::{
    AdapterInfo, Backend, DepthUse, Format, Live, Pass, PassTime, Precision, Program, ProgramId, ReadId,
    TEXTURES_MAX, TextureDesc, TextureId, TimerId, TimerKind, UNIFORM_MAX, Vertices, check_pass,
    decode_texels, encode_texels, unknown,
};
use crate::error::{Error, Result};
use state::{PLAIN_PIXELS, SWITCHES, Saved, store_pixels};

const NAME: &str = "webgl2";

// EXT_disjoint_timer_query.
const TIME_ELAPSED: u32 = 0x88BF;
const GPU_DISJOINT: u32 = 0x8FBB;
/// Uniform blocks in flight; the buffer is a ring.
const RING: u32 = 64;

/// Takes a context's state, and gives it back.
type Save = (fn(&glow::Context, bool) -> Saved, fn(&Saved, &glow::Context, bool));

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

struct Timer {
    passes: Vec<(&'static str, Option<glow::Query>, f64)>,
}

/// See the [module](self).
pub struct WebGlBackend {
    epoch: u64,
    gl: Rc<glow::Context>,
    info: AdapterInfo,
    /// On a user's context: how its state is kept. A program without such a context has no code for it.
    save: Option<Save>,
    web: bool,
    textures: SlotMap<TextureId, Texture>,
    programs: SlotMap<ProgramId, Compiled>,
    framebuffers: Map<(TextureId, Option<TextureId>), glow::Framebuffer>,
    reads: SlotMap<ReadId, Vec<f32>>,
    timers: SlotMap<TimerId, Timer>,
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

fn driver(what: impl ToString, reason: impl ToString) -> Error {
    Error::driver(NAME, what.to_string(), reason.to_string())
}

impl WebGlBackend {
    /// On a user's context, which must be current on this thread now and at every later call. Its state
    /// is put back after each call; see the [module](self) for the one exception.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] if the context cannot draw to float textures, or if it computes
    /// fragment shaders with fewer than 32 bits: one pixel is drawn to find out.
    pub fn new(gl: Rc<glow::Context>) -> Result<Self> {
        Self::make(gl, Some((Saved::take, Saved::restore)))
    }

    /// As [`Self::new`], on a context that nobody else uses: its state is not saved and put back.
    pub fn own(gl: Rc<glow::Context>) -> Result<Self> {
        Self::make(gl, None)
    }

    fn make(gl: Rc<glow::Context>, save: Option<Save>) -> Result<Self> {
        let web = cfg!(target_arch = "wasm32");
        let extensions = gl.supported_extensions();
        // Natively the names begin with GL_.
        if !extensions.iter().any(|e| e.ends_with("EXT_color_buffer_float")) {
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
        let saved = save.map(|(take, restore)| (take(&gl, web), restore));
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
            Self {
                epoch: super::next_epoch(),
                info: AdapterInfo {
                    backend: NAME,
                    adapter: gl.get_parameter_string(glow::RENDERER),
                    driver: gl.get_parameter_string(glow::VERSION),
                    timer,
                    max_texture_size: gl.get_parameter_i32(glow::MAX_TEXTURE_SIZE).max(1) as u32,
                    filters_f32: extensions.iter().any(|e| e.ends_with("OES_texture_float_linear")),
                    precision: Precision::Full,
                },
                save,
                web,
                textures: SlotMap::with_key(),
                programs: SlotMap::with_key(),
                framebuffers: Map::new(),
                reads: SlotMap::with_key(),
                timers: SlotMap::with_key(),
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

    /// The context that it draws with.
    pub fn context(&self) -> &Rc<glow::Context> {
        &self.gl
    }

    /// Makes a user's texture known, to be read by passes or drawn to; it stays the user's.
    pub fn import_texture(&mut self, texture: glow::Texture, desc: TextureDesc) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        Ok(self.textures.insert(Texture { desc, content: 0, source: Source::User(texture) }))
    }

    /// Makes a user's framebuffer known as a target (`None`: the default one). Its rows are usually
    /// [`super::RowOrder::BottomUp`]. Its own depth attachment is used; pass no depth target with it.
    pub fn import_framebuffer(
        &mut self,
        framebuffer: Option<glow::Framebuffer>,
        desc: TextureDesc,
    ) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        Ok(self.textures.insert(Texture { desc, content: 0, source: Source::Framebuffer(framebuffer) }))
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
        let saved = self.save.map(|(take, restore)| (take(&self.gl, self.web), restore));
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
            code => Err(driver(what, format!("GL error {code:#06x}"))),
        }
    }

    /// The framebuffer that draws to these textures; made at the first use.
    fn framebuffer(
        &mut self,
        color: TextureId,
        depth: Option<TextureId>,
    ) -> Result<Option<glow::Framebuffer>> {
        let handle = |this: &Self, id: TextureId| -> Result<Source> {
            Ok(this.textures.get(id).ok_or_else(|| unknown(NAME, "target"))?.source)
        };
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
        self.draw_only(pass)?;
        for (id, content) in pass.contents() {
            self.set_content(id, content);
        }
        Ok(())
    }

    fn draw_only(&mut self, pass: &Pass) -> Result<()> {
        let mut bound = [None; TEXTURES_MAX];
        let program = match pass.program {
            Some(id) => {
                let compiled = self.programs.get(id).ok_or_else(|| unknown(NAME, "program"))?;
                bound = check_pass(NAME, pass, compiled.program)?;
                Some((compiled.program, compiled.handle))
            }
            None => None,
        };
        let desc = self.texture(pass.target.color).ok_or_else(|| unknown(NAME, "target"))?;
        let mut read = [None; TEXTURES_MAX];
        for (slot, id) in read.iter_mut().zip(bound) {
            // Nothing is bound where the program's constants leave a texture unread.
            let Some(id) = id else { continue };
            *slot = match self.textures.get(id).ok_or_else(|| unknown(NAME, "texture"))?.source {
                Source::Own(t) | Source::User(t) => Some(t),
                Source::Framebuffer(_) => return Err(unknown(NAME, "a framebuffer, which cannot be read")),
            };
        }
        let framebuffer = self.framebuffer(pass.target.color, pass.target.depth)?;
        let gl = &self.gl;
        // SAFETY: all objects are alive (looked up above); the uniform range lies inside the ring and is at
        // least as large as the block (check_pass); vertex shaders make their own vertices.
        unsafe {
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, framebuffer);
            gl.viewport(0, 0, desc.width as i32, desc.height as i32);
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
                gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
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
            let bytes = pass.uniform.bytes();
            if !bytes.is_empty() {
                crate::count::one(|c| &mut c.uniform_uploads);
                let offset = (self.ring_next * self.ring_stride) as i32;
                gl.bind_buffer(glow::UNIFORM_BUFFER, Some(self.ring));
                gl.buffer_sub_data_u8_slice(glow::UNIFORM_BUFFER, offset, bytes);
                gl.bind_buffer_range(
                    glow::UNIFORM_BUFFER,
                    self.binding_point,
                    Some(self.ring),
                    offset,
                    UNIFORM_MAX as i32,
                );
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
        self.ring_next = (self.ring_next + 1) % RING;
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
        let (internal, ..) = format(desc.format).ok_or_else(|| {
            Error::invalid(
                format_args!("{}.format", desc.label),
                format_args!("{:?}", desc.format),
                "a format that WebGL2 has",
            )
        })?;
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

    fn epoch(&self) -> u64 {
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
        let t = self.textures.get(id).ok_or_else(|| unknown(NAME, "texture"))?;
        let desc = t.desc;
        let want = desc.texels() * desc.format.channels();
        if texels.len() != want || desc.format == Format::Depth32Float {
            return Err(Error::invalid(
                format_args!("texels for {}", desc.label),
                texels.len(),
                format_args!("{want} values, and not for a depth buffer"),
            ));
        }
        let (Source::Own(handle) | Source::User(handle), Some((_, layout, kind))) =
            (t.source, format(desc.format))
        else {
            return Err(unknown(NAME, "a framebuffer, which cannot be written"));
        };
        let bytes = encode_texels(desc.format, texels);
        self.guarded(|this| {
            this.plain_pixels();
            // SAFETY: `bytes` holds every texel of the texture in its format.
            unsafe {
                let gl = &this.gl;
                gl.active_texture(glow::TEXTURE0);
                gl.bind_texture(glow::TEXTURE_2D, Some(handle));
                let (w, h) = (desc.width as i32, desc.height as i32);
                gl.tex_sub_image_2d(
                    glow::TEXTURE_2D,
                    0,
                    0,
                    0,
                    w,
                    h,
                    layout,
                    kind,
                    glow::PixelUnpackData::Slice(Some(&bytes)),
                );
                gl.bind_texture(glow::TEXTURE_2D, None);
            }
            this.check(desc.label)
        })
    }

    fn create_program(&mut self, program: Program) -> Result<ProgramId> {
        if let Some((id, _)) = self.programs.iter().find(|(_, c)| c.program == program) {
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

    fn begin_read(&mut self, id: TextureId) -> Result<ReadId> {
        let desc = self.texture(id).ok_or_else(|| unknown(NAME, "texture"))?;
        if desc.format == Format::Depth32Float {
            return Err(Error::invalid(
                format_args!("read of {}", desc.label),
                "a depth buffer",
                "a colour texture: WebGL2 reads no depth; copy it first",
            ));
        }
        let values = self.guarded(|this| {
            let framebuffer = this.framebuffer(id, None)?;
            this.plain_pixels();
            let (kind, wire) = if desc.format == Format::Rgba8 {
                (glow::UNSIGNED_BYTE, Format::Rgba8)
            } else {
                (glow::FLOAT, Format::Rgba32Float)
            };
            let mut bytes = vec![0; desc.texels() * if kind == glow::FLOAT { 16 } else { 4 }];
            // SAFETY: RGBA with these types reads from any colour buffer here, and `bytes` holds all texels.
            unsafe {
                // To both ends: with the canvas to draw to, Chromium reads as if from there.
                this.gl.bind_framebuffer(glow::FRAMEBUFFER, framebuffer);
                let (w, h) = (desc.width as i32, desc.height as i32);
                this.gl.read_pixels(
                    0,
                    0,
                    w,
                    h,
                    glow::RGBA,
                    kind,
                    glow::PixelPackData::Slice(Some(&mut bytes)),
                );
            }
            this.check("read back")?;
            let mut values = Vec::with_capacity(desc.texels() * 4);
            decode_texels(wire, &bytes, &mut values);
            Ok(values)
        })?;
        let values =
            if desc.format.channels() == 1 { values.into_iter().step_by(4).collect() } else { values };
        Ok(self.reads.insert(values))
    }

    fn poll_read(&mut self, id: ReadId) -> Result<Option<Vec<f32>>> {
        self.reads.remove(id).map(Some).ok_or_else(|| unknown(NAME, "read"))
    }

    fn begin_times(&mut self, passes: &[Pass]) -> Result<TimerId> {
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
        Ok(self.timers.insert(Timer { passes: timed }))
    }

    fn poll_times(&mut self, id: TimerId) -> Result<Option<Vec<PassTime>>> {
        let timer = self.timers.get(id).ok_or_else(|| unknown(NAME, "timer"))?;
        let gl = &self.gl;
        let queries: Vec<_> = timer.passes.iter().filter_map(|(_, q, _)| *q).collect();
        // SAFETY: queries made by this backend and not yet deleted.
        let ready = || {
            queries
                .iter()
                .all(|&q| unsafe { gl.get_query_parameter_u32(q, glow::QUERY_RESULT_AVAILABLE) } != 0)
        };
        if !self.web {
            // SAFETY: no arguments.
            unsafe { gl.finish() };
        }
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
        }
    }
}

impl WebGlBackend {
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
            gl.delete_vertex_array(self.vertex_array);
            gl.delete_sampler(self.nearest);
            gl.delete_sampler(self.linear);
            gl.delete_buffer(self.ring);
        }
    }
}
