//! What is drawn of the atmosphere, and how radiance becomes a picture.

use std::path::Path;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use welkin::{Airglow, Bound, Look, Mode, SkySettings, ToneMap};

use crate::args::usage::UsageError;
use crate::views::View;

/// Options of what is drawn.
#[derive(Args, Debug)]
pub struct LookArgs {
    /// Draw the sun's disk darker towards its edge
    #[arg(long, help_heading = super::scene::SUN)]
    limb_darkening: bool,

    /// Draw the night sky's own light: a layer at 90 km that shines as brightly as a natural night sky
    ///
    /// The Earth's alone. It shows in exposures of some 1e5 and more, brightest at the limb from orbit.
    #[arg(long)]
    airglow: bool,

    /// Which passes draw the atmosphere, and how unless a quality is asked for
    ///
    /// sky-dome: the sky alone, in one pass behind the scene. atmosphere-post: one pass over the scene, which
    /// reads its colour and depth. planet: a shell laid over the scene by blending. These three march single
    /// scattering, 24 × 8 samples. lut: everything from LUTs (lookup tables), with all orders of scattering,
    /// from the ground to far orbit.
    #[arg(long, value_name = "MODE", default_value = "lut", value_parser = mode())]
    mode: Mode,

    /// The curve from radiance to display values; .exr and .hdr are written without one
    #[arg(long, value_name = "CURVE", default_value = "aces")]
    tone_map: ToneMapName,

    /// Round display values without the noise that hides bands; .exr and .hdr never have it
    #[arg(long)]
    no_dither: bool,

    /// Leave the ground a smooth sphere
    #[arg(long)]
    no_terrain: bool,

    /// Draw every effect that the settings have, whether the scene calls for it or not
    #[arg(long)]
    all_effects: bool,
}

/// The option that forces every effect on, as errors name it.
const ALL: &str = "--all-effects";

/// Whether a planet's preset is one of the Earth's.
fn on_earth(planet: &str) -> bool {
    planet.starts_with("earth")
}

fn mode() -> impl TypedValueParser<Value = Mode> {
    PossibleValuesParser::new(Mode::ALL.map(Mode::name)).try_map(|name: String| Mode::from_name(&name))
}

impl LookArgs {
    /// The mode that was asked for.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// Refuses what a planet does not have.
    ///
    /// # Errors
    /// A [`UsageError`] for airglow anywhere but on Earth.
    pub fn check(&self, planet: &str) -> Result<(), UsageError> {
        if self.airglow && !on_earth(planet) {
            let allowed = "an Earth: of other planets' airglow nothing is known here";
            return Err(UsageError::value("--planet <NAME>", planet, format_args!("{allowed} (--airglow)")));
        }
        Ok(())
    }

    /// The options given of which the CPU's reference takes no notice, as errors name them.
    pub fn unheeded_by_cpu(&self) -> impl Iterator<Item = &'static str> {
        let given =
            [("--airglow", self.airglow), ("--mode <MODE>", self.mode != Mode::Lut), (ALL, self.all_effects)];
        given.into_iter().filter_map(|(name, given)| given.then_some(name))
    }

    /// The settings of a sky that is drawn as well as `quality` says and looks as these options say, for a
    /// view; `moon` says whether the scene has a moon, `output` where the picture is written. A planet that
    /// has no airglow gets none.
    pub fn sky(&self, quality: SkySettings, view: &View, moon: bool, output: &Path) -> SkySettings {
        let exposure = view.exposure;
        let look = Look {
            composition: self.mode.composition(),
            limb_darkening: self.limb_darkening || moon,
            airglow: (self.airglow && on_earth(view.planet)).then_some(Airglow::EARTH),
            ..quality.look
        };
        SkySettings { look, bound: self.bound(exposure, output), ..quality }
    }

    /// How much what is left out may change a picture of that exposure: as much as nobody sees in 8 bits, or
    /// what suits numbers.
    fn bound(&self, exposure: f32, output: &Path) -> Option<Bound> {
        let linear = output
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("exr") || e.eq_ignore_ascii_case("hdr"));
        let bound = if linear { Bound::LINEAR } else { Bound::eight_bit(exposure.into()) };
        (!self.all_effects).then_some(bound)
    }

    /// The tone curve.
    pub fn tone_map(&self) -> ToneMap {
        self.tone_map.into()
    }

    /// The tone curve's name in words.
    pub fn tone_map_title(&self) -> &'static str {
        match self.tone_map {
            ToneMapName::Aces => "ACES",
            ToneMapName::AgX => "AgX",
            ToneMapName::Neutral => "Khronos Neutral",
        }
    }

    /// Whether display values are dithered before they are rounded.
    pub fn dither(&self) -> bool {
        !self.no_dither
    }

    /// Whether the ground has mountains and seas.
    pub fn terrain(&self) -> bool {
        !self.no_terrain
    }
}

/// The names of [`ToneMap`] on the command line.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ToneMapName {
    /// Contrasty; bright colours turn white
    Aces,
    /// Soft shoulder, keeps hues
    #[value(name = "agx")]
    AgX,
    /// Leaves what is not bright as it is
    Neutral,
}

impl From<ToneMapName> for ToneMap {
    fn from(name: ToneMapName) -> Self {
        match name {
            ToneMapName::Aces => Self::Aces,
            ToneMapName::AgX => Self::AgX,
            ToneMapName::Neutral => Self::Neutral,
        }
    }
}
