//! How a scene is drawn, as plain data: what of it ([`Look`]), how well ([`Quality`]), and how much may be
//! left out ([`Bound`]). Nothing here knows a GPU.

pub mod front;
pub mod luts;
pub mod quality;

use std::fmt;

use crate::error::{Error, Quoted, Result, in_range};
use crate::model::airglow::Airglow;

pub use luts::LutSettings;
pub use quality::Quality;

/// Which passes draw the atmosphere, and how they divide the sky between them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Composition {
    /// From the ground to far orbit: the background pass draws the sky near the ground, the aerial pass the
    /// air before the scene and, handed over from 15 to 50 km, the planet's shell.
    #[default]
    Full,
    /// The sky alone, in one background pass, at any altitude: what is seen of it above the planet's horizon.
    /// Below it nothing is drawn; a ground that is drawn there lays its own air.
    SkyDome,
    /// Everything in one pass after the scene, which reads its colour and depth. The background holds the
    /// disks of sun and moon only.
    AtmospherePost,
    /// A shell around a planet's mesh, laid over the scene by blending, where its colour cannot be read: the
    /// scene, and the stars around it, are dimmed by the grey mean of the transmittance, at every altitude
    /// alike. The background holds the disks of sun and moon only.
    Planet,
}

impl Composition {
    /// Whether a pass after the scene draws the air before it.
    pub const fn draws_over_scene(self) -> bool {
        !matches!(self, Self::SkyDome)
    }
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// `false` draws nothing at all.
    pub enabled: bool,
    /// Which passes draw it.
    pub composition: Composition,
    /// Whether the background holds the sun's disk.
    pub sun_disk: bool,
    /// Whether that disk is darker towards its edge ([`crate::model::moon::LIMB_DARKENING`]); its light in
    /// all stays the same.
    pub limb_darkening: bool,
    /// Whether something may stand before the sky: `false` promises a depth buffer that holds the background
    /// alone.
    pub foreground: bool,
    /// The night sky's own light, for instance [`Airglow::EARTH`]; `None` draws none.
    pub airglow: Option<Airglow>,
    /// Whether the scene's own shaders read the air ([`SceneAir`](crate::SceneAir)): its LUTs are then made
    /// even where no pass of the frame reads them, for reflections look the other way. Wants
    /// [`Quality::Luts`].
    pub scene_shaders: bool,
}

impl Default for Look {
    /// From the ground to orbit, with the sun and with a scene before the sky.
    fn default() -> Self {
        Self {
            enabled: true,
            composition: Composition::Full,
            sun_disk: true,
            limb_darkening: false,
            foreground: true,
            airglow: None,
            scene_shaders: false,
        }
    }
}

/// How much the radiance `L` of a pixel may change by all that is left out: `relative × L + absolute`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Fraction of the pixel's radiance, 0 to 1.
    pub relative: f64,
    /// In the unit of the picture's radiance, 0 to 1e6.
    pub absolute: f64,
}

impl Bound {
    /// Nothing that could be seen in any exposure: only what changes no pixel at all.
    pub const EXACT: Self = Self { relative: 0.0, absolute: 0.0 };

    /// For radiance that somebody reads: a thousandth, and 1e-9 (an 8-bit picture of 10,000 times the
    /// exposure).
    pub const LINEAR: Self = Self { relative: 1e-3, absolute: 1e-9 };

    /// For a picture of 8 bits per channel: less than half a step after any of the tone maps. `exposure`:
    /// display units per unit of radiance, above 0.
    pub fn eight_bit(exposure: f64) -> Self {
        Self { relative: 1e-3, absolute: (1e-5 / exposure).min(1e6) }
    }

    /// Checks the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        in_range("bound.relative", self.relative, 0.0, 1.0, "")?;
        in_range("bound.absolute", self.absolute, 0.0, 1e6, "")?;
        Ok(())
    }
}

/// Everything that may be chosen about a sky: what is drawn, how well, and what may be left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkySettings {
    /// What is drawn.
    pub look: Look,
    /// How the light is computed, and how finely.
    pub quality: Quality,
    /// Resolution of the background as a fraction of the target's, per side, 0.125 to 1.
    pub render_scale: f64,
    /// How much pixels may change by what a frame leaves out; `None` leaves nothing out that the look asks
    /// for.
    pub bound: Option<Bound>,
}

impl Default for SkySettings {
    /// From the ground to orbit, all orders of scattering from LUTs, full resolution, with the sun.
    fn default() -> Self {
        Self {
            look: Look::default(),
            quality: Quality::MEDIUM,
            render_scale: 1.0,
            bound: Some(Bound::LINEAR),
        }
    }
}

impl SkySettings {
    /// Checks the quality and the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        crate::count::one(|c| &mut c.settings_checks);
        self.quality.validate()?;
        if self.look.scene_shaders && matches!(self.quality, Quality::March { .. }) {
            let allowed = "one with LUTs, which look.scene_shaders reads";
            return Err(Error::invalid("quality", "a march", allowed));
        }
        self.look.airglow.map_or(Ok(()), |airglow| airglow.validate())?;
        in_range("render_scale", self.render_scale, 0.125, 1.0, "")?;
        self.bound.map_or(Ok(()), |bound| bound.validate())
    }
}

impl From<Quality> for SkySettings {
    /// The rest is that of [`SkySettings::default`].
    fn from(quality: Quality) -> Self {
        Self { quality, ..Self::default() }
    }
}

/// The four ways to use the library by name: a [`Composition`] with a [`Quality`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// One pass behind the scene: [`Composition::SkyDome`], single scattering by 24 × 8 samples.
    SkyDome,
    /// One pass over the scene: [`Composition::AtmospherePost`], single scattering by 24 × 8 samples.
    AtmospherePost,
    /// A shell around a mesh: [`Composition::Planet`], single scattering by 24 × 8 samples.
    Planet,
    /// Everything from LUTs, all orders of scattering: [`Composition::Full`] with [`Quality::MEDIUM`].
    Lut,
}

impl Mode {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::SkyDome, Self::AtmospherePost, Self::Planet, Self::Lut];

    /// Its name: `sky-dome`, `atmosphere-post`, `planet`, `lut`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SkyDome => "sky-dome",
            Self::AtmospherePost => "atmosphere-post",
            Self::Planet => "planet",
            Self::Lut => "lut",
        }
    }

    /// The mode of a name.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the names that there are.
    pub fn from_name(name: &str) -> Result<Self> {
        Self::ALL.into_iter().find(|m| m.name() == name).ok_or_else(|| {
            Error::invalid("mode", Quoted(name), "one of sky-dome, atmosphere-post, planet, lut")
        })
    }

    /// Its composition.
    pub const fn composition(self) -> Composition {
        match self {
            Self::SkyDome => Composition::SkyDome,
            Self::AtmospherePost => Composition::AtmospherePost,
            Self::Planet => Composition::Planet,
            Self::Lut => Composition::Full,
        }
    }

    /// The settings that it stands for.
    pub fn settings(self) -> SkySettings {
        let quality = match self {
            Self::Lut => Quality::MEDIUM,
            _ => Quality::March { view_samples: 24, light_samples: 8 },
        };
        let look = Look { composition: self.composition(), ..Look::default() };
        SkySettings { look, quality, ..SkySettings::default() }
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

    /// Its name: `aces`, `agx`, `neutral`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Aces => "aces",
            Self::AgX => "agx",
            Self::Neutral => "neutral",
        }
    }

    /// The tone map of a name.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the names that there are.
    pub fn from_name(name: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|t| t.name() == name)
            .ok_or_else(|| Error::invalid("tone_map", Quoted(name), "one of aces, agx, neutral"))
    }
}

impl fmt::Display for ToneMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
