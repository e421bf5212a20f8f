//! The shader programs: their names and variants, the WGSL that wgpu gets, and the GLSL ES 3.00 that
//! naga made of it beforehand.
//!
//! `shaders/wgsl/` is the only source. A module is plain WGSL with three directives in comments:
//!
//! * `//#include name`: the module `name.wgsl`, once, before this point;
//! * `//#if FLAG` … `//#endif`: lines that exist only in variants with that flag.
//!
//! An effect that is off is therefore not in the text that a driver sees. [`Program::all`] is the finite
//! list of variants; `welkin shaders` translates each of them into `shaders/glsl/`.

#[cfg(feature = "webgl")]
#[rustfmt::skip]
mod generated;
#[cfg(all(feature = "webgl", feature = "probe"))]
#[rustfmt::skip]
mod generated_probe;
#[cfg(feature = "translate")]
pub mod translate;

use crate::model::atmosphere::{AtmosphereParams, MiePhase};

/// Which constituents of the air a shader holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Constituents {
    /// Gas that scatters after Rayleigh.
    pub rayleigh: bool,
    /// Aerosol, with its phase function.
    pub mie: Option<MiePhase>,
    /// The absorbing layer.
    pub ozone: bool,
    /// No sunlight reaches it: it dims what lies behind and sends no light.
    pub dark: bool,
}

impl Constituents {
    /// Those whose coefficients are not all zero.
    pub fn of(params: &AtmosphereParams) -> Self {
        let some = |c: &[f64; 3]| c.iter().any(|&v| v > 0.0);
        Self {
            rayleigh: some(&params.rayleigh_scattering),
            mie: (some(&params.mie_scattering) || some(&params.mie_absorption)).then_some(params.mie_phase),
            ozone: some(&params.ozone_absorption),
            dark: false,
        }
    }

    /// Whether there is any air at all.
    pub fn any(self) -> bool {
        self.rayleigh || self.mie.is_some() || self.ozone
    }

    fn each() -> impl Iterator<Item = Self> {
        [false, true].into_iter().flat_map(|rayleigh| {
            [None, Some(MiePhase::HenyeyGreenstein), Some(MiePhase::CornetteShanks)].into_iter().flat_map(move |mie| {
                [false, true].into_iter().map(move |ozone| Self { rayleigh, mie, ozone, dark: false })
            })
        })
    }

    /// For tables, which hold no phase function: any aerosol is the same.
    pub fn without_phase(self) -> Self {
        Self { mie: self.mie.map(|_| MiePhase::HenyeyGreenstein), ..self }
    }

    /// Whether there is an aerosol that scatters light, which has a table of its own.
    pub fn has_haze(self) -> bool {
        self.mie.is_some() && !self.dark
    }

    /// Where no sunlight reaches it. Any aerosol is the same.
    pub fn in_the_dark(self) -> Self {
        Self { dark: true, ..self.without_phase() }
    }

    fn flags(self, flags: &mut Vec<&'static str>) {
        let mut add = |on: bool, names: &[&'static str]| {
            if on {
                flags.extend(names);
            }
        };
        add(self.any(), &["AIR"]);
        add(!self.dark && (self.rayleigh || self.mie.is_some()), &["SCATTER"]);
        add(self.rayleigh, &["RAYLEIGH"]);
        add(self.mie.is_some(), &["MIE"]);
        add(self.ozone, &["OZONE"]);
        add(self.dark, &["DARK"]);
        haze(self.mie.filter(|_| !self.dark), flags);
    }
}

/// Flags of air under a moon's shadow.
fn eclipse(phase: MiePhase, tables: bool, flags: &mut Vec<&'static str>) {
    Constituents { rayleigh: true, mie: Some(phase), ozone: true, dark: false }.flags(flags);
    flags.extend(if tables { &["ECLIPSE", "TABLES", "DIFFUSE"][..] } else { &["ECLIPSE", "MARCH"] });
}

/// Flags of an aerosol that scatters light.
fn haze(mie: Option<MiePhase>, flags: &mut Vec<&'static str>) {
    match mie {
        Some(MiePhase::HenyeyGreenstein) => flags.extend(["HAZE", "MIE_HG"]),
        Some(MiePhase::CornetteShanks) => flags.extend(["HAZE", "MIE_CS"]),
        None => {}
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
            .ok_or_else(|| crate::Error::invalid("tone_map", crate::error::Quoted(name), "one of aces, agx, neutral"))
    }
}

/// A shader program: one WGSL module with its variant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Program {
    /// The background sky, `sky.wgsl`.
    Sky {
        /// What the air holds.
        air: Constituents,
    },
    /// The sun's disk, `sun.wgsl`; any aerosol stands for both phase functions.
    Sun {
        /// What dims it.
        air: Constituents,
        /// Darker towards its edge.
        limb: bool,
        /// Less what a moon hides.
        moon: bool,
    },
    /// The moon's disk, `moon.wgsl`; any aerosol stands for both phase functions.
    Moon {
        /// What dims it.
        air: Constituents,
    },
    /// The background sky under a moon's shadow, `sky.wgsl`; it holds every constituent.
    EclipseSky {
        /// Of the aerosol.
        phase: MiePhase,
        /// Light of all orders, from the medium's tables; otherwise light scattered once.
        tables: bool,
    },
    /// Air before the scene under a moon's shadow, `aerial.wgsl`; it holds every constituent.
    EclipseAerial {
        /// Of the aerosol.
        phase: MiePhase,
        /// As of [`Self::EclipseSky`].
        tables: bool,
        /// Laid over the scene instead of reading its colour.
        blend: bool,
    },
    /// Air before the scene, `aerial.wgsl`.
    Aerial {
        /// What the air holds.
        air: Constituents,
        /// Laid over the scene instead of reading its colour.
        blend: bool,
    },
    /// The background sky from its tables, `sky_lut.wgsl`.
    SkyLut {
        /// Phase function of the aerosol; `None` where none scatters light.
        mie: Option<MiePhase>,
        /// The target holds nothing: written, instead of laid over it.
        only: bool,
    },
    /// Air before the scene from its tables, `aerial_lut.wgsl`.
    AerialLut {
        /// Phase function of the aerosol; `None` where none scatters light.
        mie: Option<MiePhase>,
        /// Laid over the scene instead of reading its colour.
        blend: bool,
    },
    /// Fills the table of densities' integrals towards the top, `lut_columns.wgsl`.
    LutColumns,
    /// Gathers light at the nodes of the table of moments, `lut_radiance.wgsl`.
    LutRadiance,
    /// Fills the table of moments, `lut_moments.wgsl`.
    LutMoments,
    /// Fills the sky table, `lut_sky.wgsl`; any aerosol stands for both phase functions.
    LutSky {
        /// What the air holds.
        air: Constituents,
        /// The table of what the aerosol scatters straight from the sun; otherwise of all other light.
        aerosol: bool,
        /// With light that was scattered before.
        diffuse: bool,
    },
    /// Fills the slices of the air table, `lut_air.wgsl`; any aerosol stands for both phase functions.
    LutAir {
        /// What the air holds.
        air: Constituents,
        /// With light that was scattered before.
        diffuse: bool,
    },
    /// Adds up the slices of the air table, `lut_scan.wgsl`.
    LutScan {
        /// The last step: radiance becomes its share of the whole ray's.
        finish: bool,
    },
    /// A low-resolution sky brought to full size, `upsample.wgsl`.
    Upsample,
    /// Exposure, tone mapping and sRGB, `tonemap.wgsl`.
    ToneMap {
        /// The curve.
        map: ToneMap,
        /// With the noise of one 8-bit step.
        dither: bool,
    },
    /// The demonstration's terrain, `terrain.wgsl`; it holds every constituent.
    Terrain {
        /// With the light of the simulated sky, from the table of moments; otherwise a rough estimate of it.
        sky: bool,
        /// Under a moon's shadow.
        moon: bool,
    },
    /// A plain copy, `copy.wgsl`.
    Copy,
    /// The library's functions on single cases, `probe.wgsl`; see [`crate::probe`].
    #[cfg(feature = "probe")]
    Probe(crate::probe::Probe),
}

/// Vertices of the terrain's one triangle strip; the constants are RINGS and SEGMENTS in `terrain.wgsl`.
pub(crate) const TERRAIN_RINGS: u32 = 256;
const TERRAIN_SEGMENTS: u32 = 384;

impl Program {
    /// Every program that can be asked for.
    pub fn all() -> Vec<Self> {
        let mut all = vec![Self::Copy, Self::Upsample];
        for sky in [false, true] {
            all.extend([false, true].map(|moon| Self::Terrain { sky, moon }));
        }
        for phase in [MiePhase::HenyeyGreenstein, MiePhase::CornetteShanks] {
            for tables in [false, true] {
                all.push(Self::EclipseSky { phase, tables });
                all.extend([false, true].map(|blend| Self::EclipseAerial { phase, tables, blend }));
            }
        }
        all.extend([Self::LutColumns, Self::LutRadiance, Self::LutMoments]);
        all.extend([false, true].map(|finish| Self::LutScan { finish }));
        all.extend([false, true].into_iter().flat_map(|d| ToneMap::ALL.map(|map| Self::ToneMap { map, dither: d })));
        for mie in [None, Some(MiePhase::HenyeyGreenstein), Some(MiePhase::CornetteShanks)] {
            all.extend([false, true].map(|only| Self::SkyLut { mie, only }));
            all.extend([false, true].map(|blend| Self::AerialLut { mie, blend }));
        }
        for air in Constituents::each() {
            if air.any() {
                all.push(Self::Sky { air });
                all.extend([false, true].map(|blend| Self::Aerial { air, blend }));
            }
            if air == air.without_phase() {
                for limb in [false, true] {
                    all.extend([false, true].map(|moon| Self::Sun { air, limb, moon }));
                }
                all.push(Self::Moon { air });
            }
            if air.any() && air == air.without_phase() {
                all.extend([false, true].map(|diffuse| Self::LutSky { air, aerosol: false, diffuse }));
                all.extend(air.mie.map(|_| Self::LutSky { air, aerosol: true, diffuse: false }));
                all.extend([false, true].map(|diffuse| Self::LutAir { air, diffuse }));
                let air = air.in_the_dark();
                all.push(Self::Sky { air });
                all.extend([false, true].map(|blend| Self::Aerial { air, blend }));
            }
        }
        // Last: what only they need is kept apart from what pictures need.
        #[cfg(feature = "probe")]
        all.extend(crate::probe::Probe::ALL.map(Self::Probe));
        #[cfg(feature = "probe")]
        all.push(Self::Probe(crate::probe::Probe::Eclipse));
        all
    }

    /// Unique name, also of the files in `shaders/glsl/`.
    pub fn name(self) -> String {
        let flags = self.flags();
        let part = |flag: &str, text: &'static str| if flags.contains(&flag) { text } else { "" };
        match self {
            Self::Copy | Self::Upsample | Self::LutColumns | Self::LutRadiance | Self::LutMoments => {
                self.module().to_owned()
            }
            Self::Terrain { .. } => [self.module(), part("SKYLIGHT", "-sky"), part("MOON", "-moon")].concat(),
            Self::EclipseSky { .. } | Self::EclipseAerial { .. } => [
                self.module(),
                "-eclipse",
                part("TABLES", "-lut"),
                part("MIE_HG", "-mie_hg"),
                part("MIE_CS", "-mie_cs"),
                part("BLEND", "-blend"),
            ]
            .concat(),
            Self::LutScan { finish } => format!("lut_scan-{}", if finish { "finish" } else { "add" }),
            Self::ToneMap { map, dither } => {
                format!("tonemap-{}{}", map.name(), if dither { "-dither" } else { "" })
            }
            #[cfg(feature = "probe")]
            Self::Probe(p) => format!("probe-{}", p.name()),
            Self::Sun { .. } | Self::Moon { .. } | Self::LutSky { .. } | Self::LutAir { .. } => [
                self.module(),
                part("RAYLEIGH", "-rayleigh"),
                part("MIE", "-mie"),
                part("OZONE", "-ozone"),
                part("AEROSOL", "-haze"),
                part("BARE", "-bare"),
                part("LIMB", "-limb"),
                part("MOON", "-moon"),
            ]
            .concat(),
            Self::SkyLut { .. } | Self::AerialLut { .. } => [
                self.module(),
                part("MIE_HG", "-mie_hg"),
                part("MIE_CS", "-mie_cs"),
                part("ONLY", "-only"),
                part("BLEND", "-blend"),
            ]
            .concat(),
            Self::Sky { .. } | Self::Aerial { .. } => [
                self.module(),
                part("RAYLEIGH", "-rayleigh"),
                part("MIE_HG", "-mie_hg"),
                part("MIE_CS", "-mie_cs"),
                if flags.contains(&"DARK") { part("MIE", "-mie") } else { "" },
                part("OZONE", "-ozone"),
                part("DARK", "-dark"),
                part("BLEND", "-blend"),
            ]
            .concat(),
        }
    }

    /// The WGSL module that holds the entry points.
    pub fn module(self) -> &'static str {
        match self {
            Self::Sky { .. } | Self::EclipseSky { .. } => "sky",
            Self::Sun { .. } => "sun",
            Self::Moon { .. } => "moon",
            Self::Aerial { .. } | Self::EclipseAerial { .. } => "aerial",
            Self::SkyLut { .. } => "sky_lut",
            Self::AerialLut { .. } => "aerial_lut",
            Self::LutColumns => "lut_columns",
            Self::LutRadiance => "lut_radiance",
            Self::LutMoments => "lut_moments",
            Self::LutSky { .. } => "lut_sky",
            Self::LutAir { .. } => "lut_air",
            Self::LutScan { .. } => "lut_scan",
            Self::Upsample => "upsample",
            Self::ToneMap { .. } => "tonemap",
            Self::Terrain { .. } => "terrain",
            Self::Copy => "copy",
            #[cfg(feature = "probe")]
            Self::Probe(crate::probe::Probe::Eclipse) => "probe_eclipse",
            #[cfg(feature = "probe")]
            Self::Probe(_) => "probe",
        }
    }

    fn flags(self) -> Vec<&'static str> {
        let mut flags = Vec::new();
        match self {
            Self::Moon { air } => air.flags(&mut flags),
            Self::Sky { air } => {
                air.flags(&mut flags);
                flags.extend(["OPEN", "MARCH"]);
            }
            Self::EclipseSky { phase, tables } => eclipse(phase, tables, &mut flags),
            Self::EclipseAerial { phase, tables, blend } => {
                eclipse(phase, tables, &mut flags);
                flags.push(if blend { "BLEND" } else { "READ" });
            }
            Self::Sun { air, limb, moon } => {
                air.flags(&mut flags);
                flags.extend(limb.then_some("LIMB"));
                flags.extend(moon.then_some("MOON"));
            }
            Self::SkyLut { mie, only } => {
                haze(mie, &mut flags);
                flags.push("SAMPLED");
                flags.push(if only { "ONLY" } else { "OVER" });
            }
            Self::Aerial { air, blend } => {
                air.flags(&mut flags);
                flags.extend(["OPEN", "MARCH"]);
                flags.push(if blend { "BLEND" } else { "READ" });
            }
            Self::AerialLut { mie, blend } => {
                // Gas and absorber are in the tables; what is left of them is a factor each.
                flags.extend(["AIR", "RAYLEIGH", "MIE", "OZONE", "SAMPLED"]);
                haze(mie, &mut flags);
                flags.push(if blend { "BLEND" } else { "READ" });
            }
            Self::LutSky { air, aerosol, diffuse } => {
                air.flags(&mut flags);
                flags.extend(match (aerosol, diffuse) {
                    (true, _) => &["AEROSOL", "DIRECT"][..],
                    (false, true) => &["SMOOTH", "DIFFUSE"],
                    (false, false) => &["SMOOTH", "BARE", "DIRECT"],
                });
            }
            Self::LutAir { air, diffuse } => {
                air.flags(&mut flags);
                flags.extend(if diffuse { &["DIFFUSE"][..] } else { &["BARE", "DIRECT"] });
            }
            Self::LutScan { finish } => flags.push(if finish { "FINISH" } else { "ADD" }),
            Self::ToneMap { map, dither } => {
                flags.push(match map {
                    ToneMap::Aces => "ACES",
                    ToneMap::AgX => "AGX",
                    ToneMap::Neutral => "NEUTRAL",
                });
                flags.push(if dither { "DITHER" } else { "PLAIN" });
            }
            Self::Terrain { .. } | Self::LutColumns | Self::LutRadiance | Self::LutMoments => {
                Constituents { rayleigh: true, mie: Some(MiePhase::HenyeyGreenstein), ozone: true, dark: false }
                    .flags(&mut flags);
                flags.push("DIFFUSE");
                if let Self::Terrain { sky, moon } = self {
                    flags.push(if sky { "SKYLIGHT" } else { "ROUGH" });
                    flags.push(if moon { "MOON" } else { "OPEN" });
                }
            }
            Self::Upsample | Self::Copy => {}
            #[cfg(feature = "probe")]
            Self::Probe(p) => {
                Constituents { rayleigh: true, mie: Some(p.mie_phase()), ozone: true, dark: false }.flags(&mut flags);
                flags.push(p.flag());
            }
        }
        flags
    }

    /// The complete WGSL of this variant.
    pub fn wgsl(self) -> String {
        let mut text = String::new();
        let mut seen = Vec::new();
        if !self.makes_vertices() {
            link("fullscreen", &[], &mut seen, &mut text);
        }
        link(self.module(), &self.flags(), &mut seen, &mut text);
        text
    }

    /// How many textures it reads, at bindings 1, 2, …
    pub fn textures(self) -> usize {
        match self {
            Self::Sky { .. } | Self::Sun { .. } | Self::Moon { .. } | Self::LutColumns => 0,
            Self::Terrain { sky, moon } => usize::from(sky) + usize::from(moon),
            Self::EclipseSky { tables, .. } => 1 + 2 * usize::from(tables),
            Self::EclipseAerial { tables, blend, .. } => 3 - usize::from(blend) + 2 * usize::from(tables),
            Self::Upsample | Self::ToneMap { .. } | Self::Copy | Self::LutMoments | Self::LutScan { .. } => 1,
            Self::SkyLut { mie, .. } => 1 + usize::from(mie.is_some()),
            Self::LutRadiance => 2,
            Self::LutSky { diffuse, .. } | Self::LutAir { diffuse, .. } => 1 + usize::from(diffuse),
            Self::Aerial { blend, .. } => 2 - usize::from(blend),
            Self::AerialLut { mie, blend } => 5 - usize::from(blend) + usize::from(mie.is_some()),
            #[cfg(feature = "probe")]
            Self::Probe(_) => 1,
        }
    }

    /// Which of them the bilinear sampler reads: bit 0 stands for binding 1.
    pub fn filtered(self) -> u32 {
        match self {
            Self::SkyLut { mie, .. } => 0b1 | u32::from(mie.is_some()) << 1,
            Self::AerialLut { mie, blend } => (0b110 | u32::from(mie.is_some()) << 4) << u32::from(!blend),
            _ => 0,
        }
    }

    /// Size of its uniform block at binding 0 in bytes; 0 for none.
    pub fn uniform_size(self) -> usize {
        use crate::frame::{lut, terrain::TerrainUniform, tone_map::ToneUniform, uniforms::FrameUniform};
        match self {
            Self::Sky { .. } | Self::Aerial { .. } | Self::Upsample => size_of::<FrameUniform>(),
            Self::Sun { .. } | Self::Moon { .. } => size_of::<crate::frame::disks::DiskUniform>(),
            Self::EclipseSky { .. } | Self::EclipseAerial { .. } => size_of::<crate::frame::eclipse::EclipseUniform>(),
            Self::Terrain { .. } => size_of::<TerrainUniform>(),
            Self::ToneMap { .. } => size_of::<ToneUniform>(),
            Self::LutColumns | Self::LutRadiance | Self::LutMoments => size_of::<lut::MediumTables>(),
            Self::SkyLut { .. }
            | Self::AerialLut { .. }
            | Self::LutSky { .. }
            | Self::LutAir { .. }
            | Self::LutScan { .. } => size_of::<lut::FrameTables>(),
            Self::Copy => 0,
            #[cfg(feature = "probe")]
            Self::Probe(_) => 0,
        }
    }

    /// Vertices to draw.
    pub fn vertices(self) -> u32 {
        match self {
            Self::Terrain { .. } => TERRAIN_RINGS * (2 * (TERRAIN_SEGMENTS + 1) + 2),
            Self::Sun { .. } | Self::Moon { .. } => 4,
            _ => 3,
        }
    }

    /// Whether it has a vertex shader of its own, which makes a triangle strip; the others cover their target.
    pub fn makes_vertices(self) -> bool {
        matches!(self, Self::Terrain { .. } | Self::Sun { .. } | Self::Moon { .. })
    }

    /// Whether the output is laid over the target by its (premultiplied) alpha.
    pub fn blends(self) -> bool {
        match self {
            Self::Sky { .. } | Self::EclipseSky { .. } | Self::Sun { .. } | Self::Moon { .. } | Self::Upsample => true,
            Self::SkyLut { only, .. } => !only,
            Self::Aerial { blend, .. } | Self::AerialLut { blend, .. } | Self::EclipseAerial { blend, .. } => blend,
            _ => false,
        }
    }

    /// The translated shaders and the names naga gave to what they bind.
    #[cfg(feature = "webgl")]
    pub(crate) fn glsl(self) -> Option<&'static Glsl> {
        let name = self.name();
        #[cfg(feature = "probe")]
        if matches!(self, Self::Probe(_)) {
            return generated_probe::GLSL.iter().find(|g| g.name == name);
        }
        generated::GLSL.iter().find(|g| g.name == name)
    }
}

/// A program in GLSL ES 3.00. Shaders are lists of indices into the generated table's parts.
#[cfg(feature = "webgl")]
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Glsl {
    name: &'static str,
    vertex: &'static [u16],
    fragment: &'static [u16],
    /// Names of the uniform block in the vertex and in the fragment shader; empty where there is none.
    pub blocks: [&'static str; 2],
    /// Sampler names of the textures at bindings 1, 2, …; empty where a shader does not read one.
    pub textures: &'static [&'static str],
}

#[cfg(feature = "webgl")]
impl Glsl {
    /// Text of the vertex shader.
    pub fn vertex(&self) -> String {
        self.vertex.iter().map(|&i| part(i)).collect()
    }

    /// Text of the fragment shader.
    pub fn fragment(&self) -> String {
        self.fragment.iter().map(|&i| part(i)).collect()
    }
}

/// A part of the generated table; the probe's own follow those of the pictures.
#[cfg(feature = "webgl")]
fn part(index: u16) -> &'static str {
    let index = usize::from(index);
    #[cfg(feature = "probe")]
    if let Some(own) = index.checked_sub(generated::PARTS.len()) {
        return generated_probe::PARTS[own];
    }
    generated::PARTS[index]
}

macro_rules! modules {
    ($($(#[$on:meta])? $name:literal),* $(,)?) => {
        &[$($(#[$on])? ($name, {
            const WHOLE: &[u8] = include_bytes!(concat!("../../shaders/wgsl/", $name, ".wgsl"));
            const LENGTH: usize = bare::<0>(WHOLE).1;
            const BARE: [u8; LENGTH] = bare(WHOLE).0;
            match std::str::from_utf8(&BARE) {
                Ok(text) => text,
                Err(_) => panic!(),
            }
        })),*]
    };
}

/// A text less comments, blank lines and what ends lines, and its length. Lines that begin with `//#` stay. The
/// compiler does this: comments stay in the source, drivers and the wasm module need none.
const fn bare<const LENGTH: usize>(text: &[u8]) -> ([u8; LENGTH], usize) {
    let mut out = [0; LENGTH];
    let (mut length, mut at) = (0, 0);
    while at < text.len() {
        let start = at;
        // Behind the last character that stays, and where the line's first word begins.
        let (mut end, mut word) = (start, start);
        let mut comment = false;
        while at < text.len() && text[at] != b'\n' {
            if word == at && text[at] == b' ' {
                word += 1;
            }
            let slashes = text[at] == b'/' && at + 1 < text.len() && text[at + 1] == b'/';
            comment |= slashes && !(at == word && at + 2 < text.len() && text[at + 2] == b'#');
            // The second slash of `//#` starts no comment either: `/#` are not two slashes.
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

/// Name and text of every WGSL module, without its comments.
pub const MODULES: &[(&str, &str)] = modules![
    "aerial",
    "aerial_lut",
    "air",
    "all_orders",
    "copy",
    "directions",
    "disk",
    #[cfg(feature = "probe")]
    "eclipse",
    "frame",
    "fullscreen",
    "geometry",
    "lighting",
    "limb",
    "lut_air",
    "lut_columns",
    "lut_moments",
    "lut_radiance",
    "lut_scan",
    "lut_sky",
    "march",
    "medium",
    "moon",
    "moon_block",
    "moon_shadow",
    "noise",
    "path",
    "phase",
    #[cfg(feature = "probe")]
    "probe",
    #[cfg(feature = "probe")]
    "probe_eclipse",
    "reach",
    "rectangle",
    "scattering",
    "sky",
    "sky_lut",
    "skylight",
    "skyview",
    "sun",
    "tables",
    "terrain",
    "tonemap",
    "upsample",
    "view",
];

/// Appends a module and what it includes, less the lines whose flag is off. An unknown name adds a line
/// that no WGSL front end accepts, so that the mistake is reported where shaders are compiled.
fn link(name: &'static str, flags: &[&str], seen: &mut Vec<&'static str>, out: &mut String) {
    if seen.contains(&name) {
        return;
    }
    seen.push(name);
    let Some((_, text)) = MODULES.iter().find(|(n, _)| *n == name) else {
        *out += "#error unknown module ";
        *out += name;
        return;
    };
    let mut hidden = Vec::new();
    for line in text.lines() {
        let word = line.trim_start();
        if let Some(flag) = word.strip_prefix("//#if ") {
            hidden.push(!flags.contains(&flag.trim()));
        } else if word.starts_with("//#endif") {
            hidden.pop();
        } else if hidden.contains(&true) {
            // Left out of this variant.
        } else if let Some(include) = word.strip_prefix("//#include ") {
            link(include.trim(), flags, seen, out);
        } else {
            *out += line;
            *out += "\n";
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_bare() {
        let text = b"// a\n\n  //#if X // why\nlet a = b / c;  // d\n   \n    f();//\n  //#endif\n/ 2";
        const BARE: &str = "  //#if X\nlet a = b / c;\n    f();\n  //#endif\n/ 2\n";
        let (out, length) = bare::<{ BARE.len() }>(text);
        assert_eq!((std::str::from_utf8(&out), length), (Ok(BARE), BARE.len()));
        for (name, text) in MODULES {
            for line in text.lines() {
                let code = line.trim_start().strip_prefix("//#").unwrap_or(line);
                assert!(!code.is_empty() && !code.contains("//") && code.trim_end() == code, "{name}: {line:?}");
            }
        }
    }

    #[test]
    #[cfg(feature = "webgl")]
    fn glsl_parts_are_stored_once_and_all_used() {
        let mut used = vec![false; generated::PARTS.len()];
        for &part in generated::GLSL.iter().flat_map(|g| g.vertex.iter().chain(g.fragment)) {
            used[usize::from(part)] = true;
        }
        assert!(used.iter().all(|u| *u), "{used:?}");
        let unique: std::collections::BTreeSet<_> = generated::PARTS.iter().collect();
        assert_eq!(unique.len(), generated::PARTS.len());
        assert!(generated::PARTS.iter().all(|p| !p.contains("\n ") && !p.contains("\n\n")));
    }

    #[test]
    fn names_are_unique_and_variants_hold_only_their_effects() {
        let all = Program::all();
        let names: std::collections::BTreeSet<_> = all.iter().map(|p| p.name()).collect();
        assert_eq!(names.len(), all.len());
        for program in all {
            let text = program.wgsl();
            assert!(!text.contains("#error"), "{}", program.name());
            if let Program::Sky { air } | Program::Sun { air, .. } | Program::Moon { air } = program {
                assert_eq!(text.contains("d.z = "), air.ozone, "{}", program.name());
                assert_eq!(text.contains("d.x = "), air.rayleigh, "{}", program.name());
                assert_eq!(text.contains("d.y = "), air.mie.is_some(), "{}", program.name());
            }
        }
    }
}
