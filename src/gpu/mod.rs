//! A backend is a small machine that runs a list of passes. It knows no physics.
//!
//! A [`Pass`] is data: a program, the textures and the one uniform block that it reads, and its target.
//! Passes are full-screen triangles (or, for the demonstration's terrain, one strip made in the vertex
//! shader). [`wgpu::WgpuBackend`] and [`webgl::WebGlBackend`] run the same passes with the same result.

pub mod arena;
#[cfg(feature = "egl")]
pub mod egl;
#[cfg(any(feature = "wgpu", feature = "webgl"))]
mod map;
pub mod pool;
mod program;
#[cfg(feature = "webgl")]
pub mod webgl;
#[cfg(feature = "wgpu")]
pub mod wgpu;

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use crate::error::{Error, Result};
pub use pool::{PoolKey, TexturePool};
#[cfg(feature = "webgl")]
pub use program::Glsl;
#[cfg(any(feature = "wgpu", feature = "translate"))]
pub(crate) use program::SAMPLER_BINDING;
pub use program::{Blend, Inputs, Program, ProgramInfo, TEXTURES_MAX, TextureSlot, Vertices};

arena::ids! {
    /// A texture of a backend.
    TextureId, "texture";
    /// A program of a backend.
    ProgramId, "program";
    /// A read-back that was begun.
    ReadId, "read-back";
    /// A list of passes that is being timed.
    TimerId, "timer";
}

/// Something that was asked of the GPU and is not there yet. Dropped, it is given up, and the backend frees
/// what it kept for it.
#[derive(Debug)]
pub struct Ticket<I> {
    pub(crate) id: I,
    _held: Arc<()>,
}

impl<I: Copy> Ticket<I> {
    /// A backend's ticket, which shares `held` with it: the backend is the last to hold it once the ticket
    /// was dropped.
    pub fn new(held: &Arc<()>, id: I) -> Self {
        Self { id, _held: held.clone() }
    }

    /// What it is for.
    pub fn id(&self) -> I {
        self.id
    }
}

/// What a texel holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Four bytes, 0 to 1, no encoding of their own.
    Rgba8,
    /// As [`Self::Rgba8`], blue first: what many window systems present. WebGPU only.
    Bgra8,
    /// Four 16-bit floats: largest 65504, smallest 6e-8.
    Rgba16Float,
    /// Four 32-bit floats.
    Rgba32Float,
    /// One 32-bit float.
    R32Float,
    /// A 32-bit float depth buffer.
    Depth32Float,
}

impl Format {
    /// Values per texel.
    pub fn channels(self) -> usize {
        match self {
            Self::R32Float | Self::Depth32Float => 1,
            _ => 4,
        }
    }

    /// Bytes per texel.
    pub fn bytes(self) -> usize {
        match self {
            Self::Rgba8 | Self::Bgra8 | Self::R32Float | Self::Depth32Float => 4,
            Self::Rgba16Float => 8,
            Self::Rgba32Float => 16,
        }
    }
}

/// Which end of a picture its first row is. Passes draw [`RowOrder::TopDown`] textures; the framebuffer
/// of an OpenGL user is [`RowOrder::BottomUp`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RowOrder {
    /// Row 0 is the top of the picture.
    #[default]
    TopDown,
    /// Row 0 is the bottom of the picture.
    BottomUp,
}

/// Size, format and name of a texture. It can be read by passes, drawn to and read back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureDesc {
    /// For debuggers and errors.
    pub label: &'static str,
    /// Texels, 1 to [`AdapterInfo::max_texture_size`].
    pub width: u32,
    /// Texels, 1 to [`AdapterInfo::max_texture_size`].
    pub height: u32,
    /// What a texel holds.
    pub format: Format,
    /// Which end the first row is.
    pub rows: RowOrder,
}

impl TextureDesc {
    /// A top-down texture.
    pub fn new(label: &'static str, width: u32, height: u32, format: Format) -> Self {
        Self { label, width, height, format, rows: RowOrder::TopDown }
    }

    pub(crate) fn validate(&self, max: u32) -> Result<()> {
        for (name, v) in [("width", self.width), ("height", self.height)] {
            if v == 0 || v > max {
                return Err(Error::invalid(
                    format_args!("{}.{name}", self.label),
                    v,
                    format_args!("from 1 to {max} texels"),
                ));
            }
        }
        Ok(())
    }

    /// Texels.
    pub fn texels(&self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// What a pass does with depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthUse {
    /// Test ALWAYS, no write: a background.
    #[default]
    Always,
    /// Nearer wins and is written; `reversed` where nearer is larger.
    Nearer {
        /// See [`crate::DepthConvention::is_reversed`].
        reversed: bool,
    },
}

/// Where a pass draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Colour.
    pub color: TextureId,
    /// Depth, if the pass is drawn together with a scene's.
    pub depth: Option<TextureId>,
    /// Colour to clear to first; what is there stays otherwise.
    pub clear: Option<[f32; 4]>,
    /// Depth to clear to first.
    pub clear_depth: Option<f32>,
    /// The part of it that is drawn to; `None` for all. What is cleared is all of it either way.
    pub viewport: Option<Viewport>,
}

/// A part of a target, in pixels from its first row and column on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Column of its first pixel.
    pub x: u32,
    /// Row of its first pixel, in the order of the target's rows: of the lowest one in a framebuffer of
    /// OpenGL's.
    pub y: u32,
    /// Pixels, 1 or more.
    pub width: u32,
    /// Pixels, 1 or more.
    pub height: u32,
}

impl Viewport {
    /// Checks that it lies within a texture.
    pub(crate) fn validate(&self, desc: &TextureDesc) -> Result<()> {
        let sides = [("width", self.x, self.width, desc.width), ("height", self.y, self.height, desc.height)];
        for (name, first, side, most) in sides {
            if side == 0 || u64::from(first) + u64::from(side) > u64::from(most) {
                return Err(Error::invalid(
                    format_args!("{}.viewport.{name}", desc.label),
                    format_args!("{side} from {first} on"),
                    format_args!("1 pixel or more, within the target's {most}"),
                ));
            }
        }
        Ok(())
    }
}

impl Target {
    /// A colour texture, kept as it is where the pass draws nothing.
    pub fn color(color: TextureId) -> Self {
        Self { color, depth: None, clear: None, clear_depth: None, viewport: None }
    }
}

/// Largest uniform block, bytes.
pub const UNIFORM_MAX: usize = 768;

/// A uniform block's bytes, held in place: a frame allocates nothing.
#[derive(Clone, Copy, PartialEq)]
pub struct Uniform {
    bytes: [u8; UNIFORM_MAX],
    len: usize,
}

impl std::fmt::Debug for Uniform {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Uniform({} bytes)", self.len)
    }
}

impl Uniform {
    /// No block.
    pub const NONE: Self = Self { bytes: [0; UNIFORM_MAX], len: 0 };

    /// The bytes of a block; its size is checked when compiling.
    pub fn new<T: bytemuck::Pod>(block: &T) -> Self {
        const { assert!(size_of::<T>() <= UNIFORM_MAX, "uniform block is larger than UNIFORM_MAX") };
        let mut uniform = Self::NONE;
        uniform.len = size_of::<T>();
        uniform.bytes[..uniform.len].copy_from_slice(bytemuck::bytes_of(block));
        uniform
    }

    /// The bytes.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes[..self.len]
    }
}

/// One draw, as data.
#[derive(Clone, Debug)]
pub struct Pass {
    /// For debuggers and timings.
    pub label: &'static str,
    /// What to run; `None` only clears the target.
    pub program: Option<ProgramId>,
    /// Values to write to all of the colour target instead of drawing, as for [`Backend::write_texture`].
    /// They are written when the pass runs, between the passes around it.
    pub texels: Option<Arc<[f32]>>,
    /// The textures that the program reads, by name.
    pub inputs: Inputs,
    /// The block at binding 0.
    pub uniform: Uniform,
    /// Where it draws.
    pub target: Target,
    /// What it does with the target's depth.
    pub depth: DepthUse,
    /// Names what the colour target holds once the pass has run; 0 for nothing that anybody asks for. See
    /// [`Backend::content`].
    pub content: u64,
    /// Names what its inputs hold when its target comes to hold [`Self::content`], by [`fold_contents`]; 0
    /// where that does not matter. A pass may run later than it was made for, and find others there.
    pub inputs_content: u64,
    /// Names what the depth target holds once a pass that clears or writes it has run.
    pub depth_content: u64,
}

/// One number for what several textures hold.
pub fn fold_contents(contents: impl IntoIterator<Item = u64>) -> u64 {
    // FNV-1a on whole words: contents are hashes already.
    contents.into_iter().fold(0xcbf2_9ce4_8422_2325, |folded, content| {
        (folded ^ content).wrapping_mul(0x0100_0000_01b3).rotate_left(29)
    })
}

impl Pass {
    /// A pass that clears its target as the target says and draws nothing; fill in the rest for more.
    pub fn clear(label: &'static str, target: Target) -> Self {
        Self {
            label,
            program: None,
            texels: None,
            inputs: Inputs::NONE,
            uniform: Uniform::NONE,
            target,
            depth: DepthUse::Always,
            content: 0,
            inputs_content: 0,
            depth_content: 0,
        }
    }

    /// Which textures hold something else once it has run, and what, by what they hold before: for
    /// [`Backend::run`] to tell [`Backend::set_content`].
    pub fn contents(&self, content: impl Fn(TextureId) -> u64) -> [Option<(TextureId, u64)>; 2] {
        let as_expected = self.content != 0
            && (self.inputs_content == 0
                || self.inputs_content
                    == fold_contents(self.inputs.iter().filter_map(|(_, id)| id).map(content)));
        let made = if as_expected { self.content } else { 0 };
        let writes_depth = self.target.clear_depth.is_some() || self.depth != DepthUse::Always;
        let depth = self.target.depth.filter(|_| writes_depth).map(|id| (id, self.depth_content));
        [Some((self.target.color, made)), depth]
    }
}

/// How a backend measures a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimerKind {
    /// Vulkan or WebGPU timestamps around the pass.
    Timestamps,
    /// `EXT_disjoint_timer_query` around the pass.
    TimerQuery,
    /// A wall clock around a pass that is waited for; includes what submitting costs.
    Clock,
    /// This backend cannot wait (WebGPU in a browser without timestamps).
    None,
}

impl std::fmt::Display for TimerKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Timestamps => "gpu timestamps",
            Self::TimerQuery => "EXT_disjoint_timer_query",
            Self::Clock => "synchronised clock",
            Self::None => "none",
        })
    }
}

/// How precisely fragment shaders compute. Less than 32 bits for plain numbers is no adapter: it is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 32 bits, which WebGPU guarantees; it was not tested.
    Guaranteed,
    /// 32 bits, also for the members of structs: a pixel showed it.
    Full,
    /// 32 bits for plain numbers, fewer for the members of GLSL structs, as a pixel showed. Adreno GPUs up to
    /// the 6xx do that (<https://github.com/KhronosGroup/WebGL/issues/3351>). No shader of this crate holds a
    /// struct value, so that its pictures are right; your own shaders may suffer.
    StructMembersReduced,
}

impl std::fmt::Display for Precision {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Guaranteed => "32 bits by WebGPU's rules",
            Self::Full => "32 bits",
            Self::StructMembersReduced => "32 bits, fewer in structs",
        })
    }
}

/// What draws.
#[derive(Clone, Debug, PartialEq)]
pub struct AdapterInfo {
    /// `webgpu` or `webgl2`.
    pub backend: &'static str,
    /// The adapter's own name.
    pub adapter: String,
    /// Driver or API behind it.
    pub driver: String,
    /// How passes are timed.
    pub timer: TimerKind,
    /// Largest texture side, texels.
    pub max_texture_size: u32,
    /// Whether it interpolates between texels of 32-bit floats. Where it does not, the sky LUTs have 16
    /// bits.
    pub filters_f32: bool,
    /// How precisely its fragment shaders compute.
    pub precision: Precision,
}

impl std::fmt::Display for AdapterInfo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { backend, adapter, driver, timer, precision, .. } = self;
        write!(f, "{backend}: {adapter}, {driver}, timer: {timer}, floats: {precision}")
    }
}

/// Time of a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassTime {
    /// [`Pass::label`].
    pub label: &'static str,
    /// Nanoseconds, by [`AdapterInfo::timer`].
    pub nanoseconds: f64,
}

/// Live objects of a backend, for leak tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub struct Live {
    pub textures: usize,
    /// Of all textures, without what a driver adds.
    pub texture_bytes: usize,
    pub programs: usize,
    pub framebuffers: usize,
    pub pipelines: usize,
    pub bind_groups: usize,
    /// Read-backs that were begun and not answered; one that was given up goes when the next one begins.
    pub reads: usize,
}

/// A machine that runs passes.
pub trait Backend {
    /// Which adapter and driver it runs on.
    fn info(&self) -> &AdapterInfo;

    /// A new texture; its content is undefined.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a side of 0 or beyond [`AdapterInfo::max_texture_size`];
    /// [`crate::ErrorKind::Driver`].
    fn create_texture(&mut self, desc: &TextureDesc) -> Result<TextureId>;

    /// What a texture was made with.
    fn texture(&self, id: TextureId) -> Option<TextureDesc>;

    /// Whether a target may be cleared and have depth: not one that stands for a render pass of the user's.
    fn is_texture(&self, _id: TextureId) -> bool {
        true
    }

    /// A number that no other backend of this process has. Ids mean nothing on a backend of another epoch,
    /// and are refused there.
    fn epoch(&self) -> u32;

    /// The name of what a texture holds: [`Pass::content`] of the last pass that was run or recorded with it
    /// as its target, or what [`Self::set_content`] said since. 0 if that is unknown: also once an encoder
    /// was dropped that it was recorded in.
    fn content(&self, id: TextureId) -> u64;

    /// Whether what gave a texture its [`Self::content`] has run, and was not only recorded in an encoder of
    /// the user's that waits to be submitted or done.
    fn has_run(&self, id: TextureId) -> bool {
        self.texture(id).is_some()
    }

    /// Names what a texture holds, after it was written by other means than a pass.
    fn set_content(&mut self, id: TextureId, content: u64);

    /// Frees a texture; unknown ids are ignored.
    fn destroy_texture(&mut self, id: TextureId);

    /// Fills a texture: [`Format::channels`] values per texel, rows in memory order.
    /// [`Format::Depth32Float`] cannot be written; make a [`Format::R32Float`] instead.
    fn write_texture(&mut self, id: TextureId, texels: &[f32]) -> Result<()>;

    /// A compiled program; asking again gives the same one.
    fn create_program(&mut self, program: Program) -> Result<ProgramId>;

    /// Frees a program; unknown ids are ignored.
    fn destroy_program(&mut self, id: ProgramId);

    /// Runs passes in order.
    fn run(&mut self, passes: &[Pass]) -> Result<()>;

    /// Asks for a texture's content; see [`Self::poll_read`].
    fn begin_read(&mut self, id: TextureId) -> Result<Ticket<ReadId>>;

    /// The content once it is there: [`Format::channels`] values per texel, rows in memory order. Does not
    /// wait: `None` until then.
    fn poll_read(&mut self, ticket: &Ticket<ReadId>) -> Result<Option<Vec<f32>>>;

    /// Runs passes and measures each; see [`Self::poll_times`].
    fn begin_times(&mut self, passes: &[Pass]) -> Result<Ticket<TimerId>>;

    /// The times once they are there. Does not wait: `None` until then.
    fn poll_times(&mut self, ticket: &Ticket<TimerId>) -> Result<Option<Vec<PassTime>>>;

    /// Waits until the GPU has done all that was asked of it, so that what was begun is there.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] in a browser, where nothing can wait: poll now and then instead.
    fn wait(&mut self) -> Result<()>;

    /// Why the device is gone, if it is.
    fn lost(&self) -> Option<String>;

    /// What exists now.
    fn live(&self) -> Live;

    /// [`Self::begin_read`], [`Self::wait`] and [`Self::poll_read`] in one.
    ///
    /// # Errors
    /// Those of the three.
    fn read(&mut self, id: TextureId) -> Result<Vec<f32>> {
        let ticket = self.begin_read(id)?;
        self.wait()?;
        self.poll_read(&ticket)?.ok_or_else(|| cannot_wait(self.info().backend))
    }

    /// [`Self::begin_times`], [`Self::wait`] and [`Self::poll_times`] in one.
    ///
    /// # Errors
    /// Those of the three.
    fn times(&mut self, passes: &[Pass]) -> Result<Vec<PassTime>> {
        let ticket = self.begin_times(passes)?;
        self.wait()?;
        self.poll_times(&ticket)?.ok_or_else(|| cannot_wait(self.info().backend))
    }
}

/// The error for waiting where nothing can wait.
pub(crate) fn cannot_wait(backend: &'static str) -> Error {
    Error::unavailable(backend, "this platform cannot wait for the GPU: poll instead")
}

/// An epoch for a new backend: see [`Backend::epoch`].
pub fn next_epoch() -> u32 {
    static EPOCH: AtomicU32 = AtomicU32::new(1);
    EPOCH.fetch_add(1, Ordering::Relaxed)
}

/// What a texture was made with, or an error that names what it was meant for.
pub(crate) fn known(backend: &dyn Backend, what: &str, id: TextureId) -> Result<TextureDesc> {
    backend.texture(id).ok_or_else(|| {
        let reason = if arena::Id::parts(id).0 == backend.epoch() {
            "a texture that was destroyed"
        } else {
            "a texture of another backend"
        };
        Error::invalid(what, reason, format_args!("a texture of this backend ({})", backend.info().backend))
    })
}

/// Checks the number of values for a texture.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) fn check_texels(desc: &TextureDesc, texels: &[f32]) -> Result<()> {
    let want = desc.texels() * desc.format.channels();
    if texels.len() != want || desc.format == Format::Depth32Float {
        return Err(Error::invalid(
            format_args!("texels for {}", desc.label),
            texels.len(),
            format_args!("{want} values, and not for a depth buffer"),
        ));
    }
    Ok(())
}

/// The error for a texture whose format or size does not suit what a pass does with it.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) fn unsuitable(pass: &str, what: &str, desc: TextureDesc, allowed: &str) -> Error {
    let TextureDesc { label, width, height, format, .. } = desc;
    Error::invalid(
        format_args!("pass {pass}: {what}"),
        format_args!("{label} ({format:?}, {width} × {height})"),
        allowed,
    )
}

/// Checks that a target asks nothing of a render pass of the user's that only its beginning can do.
pub(crate) fn check_open(target: &Target, label: &str) -> Result<()> {
    let asked = [
        ("clear", target.clear.is_some()),
        ("clear_depth", target.clear_depth.is_some()),
        ("depth", target.depth.is_some()),
    ];
    for (name, asked) in asked {
        if asked {
            let allowed = "none: a pass of the user's has its own attachments and is cleared when it begins";
            return Err(Error::invalid(format_args!("{label}.{name}"), "one", allowed));
        }
    }
    Ok(())
}

/// Checks that a pass gives its program what it reads; answers the textures in the order of the program's
/// slots.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) fn check_pass(backend: &'static str, pass: &Pass, program: Program) -> Result<program::Bound> {
    let bound = check_inputs(backend, pass.label, program, &pass.inputs, &pass.uniform)?;
    if bound.iter().flatten().any(|t| *t == pass.target.color || Some(*t) == pass.target.depth) {
        return Err(Error::invalid(
            format_args!("pass {}", pass.label),
            "a texture that is also the target",
            "different textures to read and to draw to",
        ));
    }
    Ok(bound)
}

/// Checks that a program is given what it reads, for a pass of that name; answers the textures in the order
/// of the program's slots.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) fn check_inputs(
    backend: &'static str,
    pass: &str,
    program: Program,
    inputs: &Inputs,
    uniform: &Uniform,
) -> Result<program::Bound> {
    let fault =
        |reason| Error::driver(backend, format!("pass {pass} with program {}", program.name()), reason);
    let (given, needed) = (uniform.bytes().len(), program.info().uniform_size as usize);
    if given != needed {
        return Err(fault(format!("{given} uniform bytes given, {needed} needed")));
    }
    inputs.by_slot(program.info()).map_err(fault)
}

/// Reads texels of a format into f32.
#[cfg(feature = "wgpu")]
pub(crate) fn decode_texels(format: Format, bytes: &[u8], out: &mut Vec<f32>) {
    let from = out.len();
    // One loop for all formats: less code, and nobody waits for it.
    for value in bytes.chunks_exact(format.bytes() / format.channels()) {
        out.push(match *value {
            [a] => f32::from(a) / 255.0,
            [a, b] => half::f16::from_le_bytes([a, b]).to_f32(),
            [a, b, c, d] => f32::from_le_bytes([a, b, c, d]),
            _ => 0.0,
        });
    }
    if format == Format::Bgra8 {
        out[from..].chunks_exact_mut(4).for_each(|texel| texel.swap(0, 2));
    }
}

/// Writes f32 values as texels of a format.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) fn encode_texels(format: Format, values: &[f32]) -> Vec<u8> {
    let size = format.bytes() / format.channels();
    let mut out = Vec::with_capacity(values.len() * size);
    for &v in values {
        match size {
            1 => out.push((v.clamp(0.0, 1.0) * 255.0).round() as u8),
            2 => out.extend_from_slice(&half::f16::from_f32(v).to_le_bytes()),
            _ => out.extend_from_slice(&v.to_le_bytes()),
        }
    }
    if format == Format::Bgra8 {
        out.chunks_exact_mut(4).for_each(|texel| texel.swap(0, 2));
    }
    out
}
