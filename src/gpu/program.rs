//! What a backend is told of a program: its texts, and what they read. Nothing here knows any physics.
//!
//! A [`ProgramInfo`] is a table row that is made from the shader's own reflection. A [`Program`] is such a
//! row with a choice of its constants: lines `const NAME: bool = true;` in the text, which the backend
//! rewrites when it compiles, so that the driver drops what is off.

use std::fmt;
use std::hash::{Hash, Hasher};

use super::{Error, Result, TextureId};
#[cfg(any(feature = "wgpu", feature = "webgl"))]
use crate::error::Quoted;

/// Most textures that a program reads.
pub const TEXTURES_MAX: usize = 7;

/// The binding at which shaders find the sampler: bilinear, clamped to the edges.
#[cfg(any(feature = "wgpu", feature = "translate"))]
pub(crate) const SAMPLER_BINDING: u32 = TEXTURES_MAX as u32 + 1;

/// A texture that a program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextureSlot {
    /// The texture's name in the shader.
    pub name: &'static str,
    /// The texture's binding in group 0, from 1.
    pub binding: u32,
    /// Whether the bilinear sampler reads it; otherwise the shader reads single texels.
    pub filtered: bool,
}

/// The shape that a program draws; its vertex shader makes it from the vertices' numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vertices {
    /// One triangle that covers the target.
    Triangle,
    /// A triangle strip of so many vertices.
    Strip(u32),
}

impl Vertices {
    /// The number of vertices to draw.
    pub fn count(self) -> u32 {
        match self {
            Self::Triangle => 3,
            Self::Strip(count) => count,
        }
    }
}

/// A program's texts and what they read: a row of a table that is made from naga's reflection.
#[derive(Debug)]
pub struct ProgramInfo {
    /// A name that no other program has.
    pub name: &'static str,
    /// Size of the uniform block at binding 0 in bytes; 0 for none.
    pub uniform_size: u32,
    /// The textures that it reads, by binding.
    pub textures: &'static [TextureSlot],
    /// Names of the lines `const NAME: bool`; bit i of a program's constants is the i-th.
    pub constants: &'static [&'static str],
    /// What it draws.
    pub vertices: Vertices,
    /// The WGSL, in parts that follow each other.
    #[cfg(any(feature = "wgpu", feature = "translate"))]
    pub wgsl: &'static [&'static str],
    /// The GLSL that naga made of it.
    #[cfg(feature = "webgl")]
    pub glsl: Glsl,
}

/// A program in GLSL ES 3.00: its shaders as lists of indices into a table of parts, and naga's names of what
/// they bind.
#[cfg(feature = "webgl")]
#[derive(Debug)]
pub struct Glsl {
    /// The table.
    pub parts: &'static [&'static str],
    /// The vertex shader.
    pub vertex: &'static [u16],
    /// The fragment shader.
    pub fragment: &'static [u16],
    /// Names of the uniform block in the vertex and in the fragment shader; empty where there is none.
    pub blocks: [&'static str; 2],
    /// Names of the samplers, in the order of [`ProgramInfo::textures`].
    pub samplers: &'static [&'static str],
}

impl ProgramInfo {
    /// The bit of a constant; 0 if the program has none of that name.
    pub fn constant(&self, name: &str) -> u32 {
        self.constants.iter().position(|c| *c == name).map_or(0, |i| 1 << i)
    }

    /// The bits of all constants.
    pub const fn all(&self) -> u32 {
        (1 << self.constants.len()) - 1
    }
}

/// What becomes of what is in the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Blend {
    /// The output takes its place.
    None,
    /// The output is laid over it by its (premultiplied) alpha.
    Over,
    /// Its colour is multiplied by the output's, channel by channel; its alpha stays.
    Multiply,
}

/// A program with a choice of its constants. Two of them are equal where names and choices are.
#[derive(Clone, Copy)]
pub struct Program {
    info: &'static ProgramInfo,
    constants: u32,
    blend: Blend,
}

impl Program {
    /// A program with those constants on whose bits are set, the others off.
    pub const fn new(info: &'static ProgramInfo, constants: u32) -> Self {
        Self { info, constants: constants & info.all(), blend: Blend::None }
    }

    /// The same program, its output laid over the target by its (premultiplied) alpha.
    pub const fn blended(self) -> Self {
        Self { blend: Blend::Over, ..self }
    }

    /// The same program, the target's colour multiplied by its output.
    pub const fn multiplied(self) -> Self {
        Self { blend: Blend::Multiply, ..self }
    }

    /// The row of the table.
    pub const fn info(&self) -> &'static ProgramInfo {
        self.info
    }

    /// The bits of the constants that are on.
    pub const fn constants(&self) -> u32 {
        self.constants
    }

    /// What becomes of what is in the target.
    pub const fn blend(&self) -> Blend {
        self.blend
    }

    /// Whether what is in the target counts.
    pub const fn blends(&self) -> bool {
        !matches!(self.blend, Blend::None)
    }

    /// The program's name and what is on, for people: `sky_march+RAYLEIGH+MIE`.
    pub fn name(&self) -> String {
        let mut name = self.info.name.to_owned();
        for (i, constant) in self.info.constants.iter().enumerate() {
            if self.constants & (1 << i) != 0 {
                name += "+";
                name += constant;
            }
        }
        name
    }

    /// The complete WGSL with this choice of constants.
    #[cfg(any(feature = "wgpu", feature = "translate"))]
    pub fn wgsl(&self) -> String {
        self.choose(self.info.wgsl.concat(), ["const ", ":bool=true;", ":bool=false;"])
    }

    /// The vertex and the fragment shader in GLSL ES 3.00 with this choice of constants.
    #[cfg(feature = "webgl")]
    pub fn glsl(&self) -> [String; 2] {
        let glsl = &self.info.glsl;
        [glsl.vertex, glsl.fragment].map(|list| {
            let text = list.iter().map(|&i| glsl.parts[usize::from(i)]).collect();
            self.choose(text, ["const bool ", " = true;", " = false;"])
        })
    }

    /// Rewrites the lines of the constants that are off.
    #[inline(never)]
    #[cfg(any(feature = "wgpu", feature = "translate", feature = "webgl"))]
    fn choose(&self, mut text: String, [before, on, off]: [&str; 3]) -> String {
        for (i, constant) in self.info.constants.iter().enumerate() {
            if self.constants & (1 << i) == 0 {
                let head = [before, constant].concat();
                let line = [&head, on].concat();
                // A search by hand: the standard library's is kilobytes of a browser's module.
                let at = |text: &str| text.as_bytes().windows(line.len()).position(|w| w == line.as_bytes());
                while let Some(start) = at(&text) {
                    let rest = text.split_off(start + head.len());
                    text += off;
                    text += rest.get(on.len()..).unwrap_or_default();
                }
            }
        }
        text
    }
}

impl PartialEq for Program {
    fn eq(&self, other: &Self) -> bool {
        (self.constants, self.blend) == (other.constants, other.blend) && self.info.name == other.info.name
    }
}

impl Eq for Program {}

impl Hash for Program {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.info.name, self.constants, self.blend).hash(state);
    }
}

impl fmt::Debug for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let blend = match self.blend {
            Blend::None => "",
            Blend::Over => ", blended",
            Blend::Multiply => ", multiplied",
        };
        write!(f, "Program({}{blend})", self.name())
    }
}

/// The textures that a pass gives its program, by name. A texture that the program's constants leave unread
/// may be given as `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    list: [(&'static str, Option<TextureId>); TEXTURES_MAX],
    len: usize,
}

impl Inputs {
    /// No textures.
    pub const NONE: Self = Self { list: [("", None); TEXTURES_MAX], len: 0 };

    /// Textures by their names in the shader; at most [`TEXTURES_MAX`], which is checked when compiling.
    pub fn new<const N: usize>(named: [(&'static str, Option<TextureId>); N]) -> Self {
        const { assert!(N <= TEXTURES_MAX, "more inputs than TEXTURES_MAX") };
        let mut inputs = Self { len: N, ..Self::NONE };
        inputs.list[..N].copy_from_slice(&named);
        inputs
    }

    /// One more texture.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] beyond [`TEXTURES_MAX`].
    pub fn push(&mut self, name: &'static str, texture: Option<TextureId>) -> Result<()> {
        let free = self.list.get_mut(self.len).ok_or_else(|| {
            Error::invalid(
                "inputs",
                TEXTURES_MAX + 1,
                format_args!("at most {TEXTURES_MAX} textures of a pass"),
            )
        })?;
        *free = (name, texture);
        self.len += 1;
        Ok(())
    }

    /// Names and textures.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Option<TextureId>)> + '_ {
        self.list[..self.len].iter().copied()
    }

    /// The textures in the order of a program's slots; an error says which name is missing, unknown or given
    /// twice.
    #[cfg(any(feature = "wgpu", feature = "webgl"))]
    pub(crate) fn by_slot(&self, info: &ProgramInfo) -> std::result::Result<Bound, String> {
        let mut bound = [None; TEXTURES_MAX];
        for (texture, slot) in bound.iter_mut().zip(info.textures) {
            let found = self.iter().find(|(name, _)| *name == slot.name);
            *texture = found.ok_or_else(|| format!("no texture given for {}", Quoted(slot.name)))?.1;
        }
        // All slots have a name in the list: one more is unknown or a repetition.
        if self.len > info.textures.len() {
            let known = |name| info.textures.iter().any(|slot| slot.name == name);
            let reason = match self.iter().find(|(name, _)| !known(*name)) {
                Some((name, _)) => format!("it reads no texture {}", Quoted(name)),
                None => "a texture is given twice".to_owned(),
            };
            return Err(reason);
        }
        Ok(bound)
    }
}

/// Textures in the order of a program's slots; `None` for those that are not read.
#[cfg(any(feature = "wgpu", feature = "webgl"))]
pub(crate) type Bound = [Option<TextureId>; TEXTURES_MAX];
