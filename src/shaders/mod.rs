//! The shader programs: a table made from `shaders/wgsl/`, which is the only source.
//!
//! A file in `shaders/wgsl/pass/` is a program; it includes functions from `shaders/wgsl/lib/`. `welkin shaders`
//! translates each program to GLSL ES 3.00 and writes the table with what naga's reflection tells: a module here for
//! every program, with its [`ProgramInfo`](crate::gpu::ProgramInfo) and the bits of its constants. Lines
//! `const NAME: bool = true;` are what may be turned off: see [`crate::gpu::Program`].

/// Text of a WGSL module below `shaders/wgsl/` without its comments. The compiler takes them out: they stay in the
/// source, drivers and the wasm module need none.
macro_rules! wgsl {
    ($module:literal) => {{
        const WHOLE: &[u8] = include_bytes!(concat!("../../shaders/wgsl/", $module, ".wgsl"));
        const LENGTH: usize = $crate::shaders::bare::<0>(WHOLE).1;
        const BARE: [u8; LENGTH] = $crate::shaders::bare(WHOLE).0;
        match std::str::from_utf8(&BARE) {
            Ok(text) => text,
            Err(_) => panic!(),
        }
    }};
}
pub(crate) use wgsl;

#[rustfmt::skip]
mod generated;
#[cfg(feature = "translate")]
pub mod translate;

pub use generated::*;

use crate::gpu::ProgramInfo;
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
/// Functions for a scene's own shaders, which shade with [`crate::LightingContextUniform`]; no program includes them.
pub const LIGHTING_WGSL: &str = wgsl!("lib/lighting");

/// A text less comments, blank lines and what ends lines, and its length.
pub(crate) const fn bare<const LENGTH: usize>(text: &[u8]) -> ([u8; LENGTH], usize) {
    let mut out = [0; LENGTH];
    let (mut length, mut at) = (0, 0);
    while at < text.len() {
        let start = at;
        // Behind the last character that stays.
        let mut end = start;
        let mut comment = false;
        while at < text.len() && text[at] != b'\n' {
            comment |= text[at] == b'/' && at + 1 < text.len() && text[at + 1] == b'/';
            if !comment && text[at] != b' ' {
                end = at + 1;
            }
            at += 1;
        }
        at += 1;
        if end > start {
            let mut from = start;
            while from < end {
                if LENGTH > 0 {
                    out[length] = text[from];
                }
                length += 1;
                from += 1;
            }
            if LENGTH > 0 {
                out[length] = b'\n';
            }
            length += 1;
        }
    }
    (out, length)
}

/// Which constituents of the air a shader holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Constituents {
    /// Gas that scatters light like Rayleigh's molecules.
    pub rayleigh: bool,
    /// Aerosol.
    pub mie: bool,
    /// The absorbing layer.
    pub ozone: bool,
    /// No sunlight reaches the air: it dims what lies behind and sends no light.
    pub unlit: bool,
}

impl Constituents {
    /// The constituents whose coefficients are not all zero.
    pub fn of(params: &AtmosphereParams) -> Self {
        let some = |c: &[f64; 3]| c.iter().any(|&v| v > 0.0);
        Self {
            rayleigh: some(&params.rayleigh_scattering),
            mie: some(&params.mie_scattering) || some(&params.mie_absorption),
            ozone: some(&params.ozone_absorption),
            unlit: false,
        }
    }

    /// Whether there is any air at all.
    pub fn any(self) -> bool {
        self.rayleigh || self.mie || self.ozone
    }

    /// Whether the air sends light.
    pub fn scatters(self) -> bool {
        !self.unlit && (self.rayleigh || self.mie)
    }

    /// Whether there is an aerosol that sends light, which has a table of its own.
    pub fn has_mie_light(self) -> bool {
        self.mie && !self.unlit
    }

    /// The bits of those of a program's constants that tell of the air: what it holds, whether the sun reaches it, and the
    /// aerosol's phase function.
    pub fn constants(self, info: &ProgramInfo, phase: MiePhase) -> u32 {
        let choices = [
            ("RAYLEIGH", self.rayleigh),
            ("MIE", self.mie),
            ("OZONE", self.ozone),
            ("AIR", self.any()),
            ("SUNLIGHT", self.scatters()),
            ("MIE_SINGLE", self.has_mie_light()),
            ("CORNETTE_SHANKS", self.has_mie_light() && phase == MiePhase::CornetteShanks),
        ];
        choices.into_iter().filter(|(_, on)| *on).fold(0, |bits, (name, _)| bits | info.constant(name))
    }
}

/// How scene radiance becomes display values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ToneMap {
    /// ACES filmic, Stephen Hill's fit: strong contrast, the film look.
    #[default]
    Aces,
    /// AgX: bright colours go to white without changing hue.
    AgX,
    /// Khronos PBR Neutral: leaves everything below the highlights as it is.
    Neutral,
}

impl ToneMap {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Aces, Self::AgX, Self::Neutral];

    /// Name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Aces => "aces",
            Self::AgX => "agx",
            Self::Neutral => "neutral",
        }
    }

    /// By its name; the error lists the names.
    pub fn from_name(name: &str) -> crate::Result<Self> {
        Self::ALL
            .into_iter()
            .find(|t| t.name() == name)
            .ok_or_else(|| crate::Error::invalid("tone_map", format_args!("{name:?}"), "one of aces, agx, neutral"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_bare() {
        let text = b"// a\n\n  //#include x // why\nlet a = b / c;  // d\n   \n    f();//\n/ 2";
        const BARE: &str = "let a = b / c;\n    f();\n/ 2\n";
        let (out, length) = bare::<{ BARE.len() }>(text);
        assert_eq!((std::str::from_utf8(&out), length), (Ok(BARE), BARE.len()));
    }
}
