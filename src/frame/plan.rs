//! What a scene calls for: which effects are on, why, and the passes that draw them.
//!
//! An [`EffectPlan`] is a pure function of the [`Scene`], the [`SkySettings`] and the picture's size. [`crate::SkyRenderer`] asks it once a
//! frame and decides nothing by itself: what a plan leaves out is not compiled, allocated, bound or drawn.
//!
//! ```
//! use welkin::{EffectPlan, SkySettings};
//! # use glam::DVec3;
//! # use welkin::{AtmosphereParams, Camera, DepthConvention, Scene};
//! # let earth = AtmosphereParams::earth();
//! # let scene = Scene {
//! #     camera: Camera::new(DVec3::Z * (earth.planet_radius + 4e5), DVec3::Z, DVec3::X, 1.0, 1.5),
//! #     planet_center: DVec3::ZERO,
//! #     atmosphere: earth,
//! #     sun_direction: DVec3::X,
//! #     depth: DepthConvention::default(),
//! #     moon: None,
//! # };
//! // From orbit, looking away from the planet.
//! let plan = EffectPlan::new(&scene, &SkySettings::default(), [960, 640])?;
//! assert!(plan.passes().is_empty());
//! for effect in plan.effects() {
//!     println!("{} is {}: {}", effect.name, if effect.on { "on" } else { "off" }, effect.reason);
//! }
//! # Ok::<(), welkin::Error>(())
//! ```
//!
//! # How much may change
//!
//! Some omissions change nothing: what lies outside the picture or behind the planet. The others (a constituent next to
//! nothing of which is in sight, light at night) change pixels by less than a [`Bound`]: each has an upper bound of its
//! own, worked out in `bounds`, and the cheapest are taken as long as their sum stays within it.

use std::fmt;

use super::omit::{Scattering, Sight, share};
use crate::error::{Result, in_range, short};
use crate::frame::disks::{DiskPlan, rectangle};
use crate::frame::eclipse::misses;
use crate::frame::lut::LutSettings;
use crate::model::atmosphere::AtmosphereParams;
use crate::model::moon::{Disks, Phase};
use crate::model::scene::{Scene, ZenithView};
use crate::render::sky::{Composition, Method, SkySettings, background_weight};
use crate::shaders::{Constituents, Program};

/// How much the radiance `L` of a pixel may change by all that is left out: `relative × L + absolute`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Share of the pixel's radiance, 0 to 1.
    pub relative: f64,
    /// In the unit of the picture's radiance, 0 to 1e6.
    pub absolute: f64,
}

impl Bound {
    /// Nothing that could be seen in any exposure: only what changes no pixel at all.
    pub const EXACT: Self = Self { relative: 0.0, absolute: 0.0 };

    /// For radiance that somebody reads: a thousandth, and 1e-9 (an 8-bit picture of 10,000 times the exposure).
    pub const LINEAR: Self = Self { relative: 1e-3, absolute: 1e-9 };

    /// For a picture of 8 bits per channel: less than half a step after any of the tone maps. `exposure`:
    /// display units per unit of radiance, above 0.
    pub fn eight_bit(exposure: f64) -> Self {
        Self { relative: 1e-3, absolute: (1e-5 / exposure).min(1e6) }
    }

    /// Checks the ranges given at the fields.
    pub fn validate(&self) -> Result<()> {
        in_range("bound.relative", self.relative, 0.0, 1.0, "")?;
        in_range("bound.absolute", self.absolute, 0.0, 1e6, "")?;
        Ok(())
    }
}

/// Why an effect is on or off: words, and where a number decided, that number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reason {
    text: &'static str,
    value: Option<f64>,
    unit: &'static str,
}

impl Reason {
    const fn of(text: &'static str) -> Self {
        Self { text, value: None, unit: "" }
    }

    const fn number(text: &'static str, value: f64, unit: &'static str) -> Self {
        Self { text, value: Some(value), unit }
    }
}

impl fmt::Display for Reason {
    /// The words, then the number in three digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text)?;
        let Some(value) = self.value else { return Ok(()) };
        f.write_str(" ")?;
        f.write_str(&short(three_digits(value)))?;
        f.write_str(self.unit)
    }
}

fn three_digits(v: f64) -> f64 {
    if v == 0.0 || !v.is_finite() {
        return v;
    }
    // By division, so that the result is the nearest to a short decimal.
    let digits = 2 - v.abs().log10().floor() as i32;
    if digits > 0 { (v * 10_f64.powi(digits)).round() / 10_f64.powi(digits) } else { v.round() }
}

/// One effect of a plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// What it is called, in lower case.
    pub name: &'static str,
    /// Whether the scene calls for it.
    pub on: bool,
    /// Why.
    pub reason: Reason,
}

/// How often a pass runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Runs {
    /// Again when the medium or the ground's albedo changes.
    PerMedium,
    /// Again when the camera's altitude or the sun's elevation changes.
    PerAltitude,
    /// In each frame.
    PerFrame,
}

impl Runs {
    /// In words: `per medium`, `per altitude`, `per frame`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PerMedium => "per medium",
            Self::PerAltitude => "per altitude",
            Self::PerFrame => "per frame",
        }
    }
}

/// A pass of a plan, which may run several times in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedPass {
    /// [`crate::gpu::Pass::label`].
    pub label: &'static str,
    /// Its program with the variant; `None` only clears.
    pub program: Option<Program>,
    /// How often.
    pub runs: Runs,
    /// How many times in a row.
    pub times: u32,
    /// Share of its target's pixels that it draws.
    pub share: f64,
}

/// Which tables a plan needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TablePlan {
    pub settings: LutSettings,
    /// Without a phase function.
    pub air: Constituents,
    /// Whether what the aerosol scatters straight from the sun has a table.
    pub haze: bool,
    /// Rounds of scattering after the first; 0 leaves their tables out.
    pub rounds: u32,
    /// Whether the air before the scene is drawn.
    pub slices: bool,
    /// Whether pixels read the sky from tables; otherwise passes march, with the medium's tables alone.
    pub sky: bool,
}

/// The effects, in the order of [`EffectPlan::effects`].
#[derive(Clone, Copy)]
enum Name {
    Atmosphere,
    Rayleigh,
    Mie,
    Ozone,
    Sunlight,
    Multiple,
    Background,
    Shell,
    Aerial,
    Tables,
    Slices,
    Eclipse,
    SunDisk,
    MoonDisk,
    Reduced,
}

const NAMES: [&str; 15] = [
    "atmosphere",
    "rayleigh",
    "mie",
    "ozone",
    "sunlight",
    "multiple scattering",
    "background sky",
    "planet shell",
    "aerial perspective",
    "sky tables",
    "air table",
    "eclipse",
    "sun disk",
    "moon disk",
    "reduced resolution",
];

/// What a scene calls for.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectPlan {
    effects: [Effect; NAMES.len()],
    /// Draws the background.
    pub(crate) background: Option<Program>,
    /// Whether it is drawn smaller and brought to full size.
    pub(crate) reduced: bool,
    /// Draws the sun's disk.
    pub(crate) sun: Option<DiskPlan>,
    /// Draws the moon's disk.
    pub(crate) moon: Option<DiskPlan>,
    /// Draws the air before the scene.
    pub(crate) before: Option<Program>,
    pub(crate) tables: Option<TablePlan>,
    /// Whether the moon's shadow falls on what is seen.
    pub(crate) eclipse: bool,
    /// Share of the background pass in the sky's light.
    pub(crate) sky_weight: f64,
    /// Along a view ray and from each step towards the sun, for passes that march.
    pub(crate) samples: [u32; 2],
}

/// Share of the bound below which what is on goes off.
const STAYS: f64 = 0.5;

/// Radians by which a picture is taken to be wider than it is: rounding, and half a pixel, decide nothing then.
pub(super) const MARGIN: f64 = 1e-3;

impl EffectPlan {
    /// The names of all effects, in the order of [`Self::effects`].
    pub const NAMES: [&'static str; NAMES.len()] = NAMES;

    /// The plan of a scene, for a picture of a size in pixels.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`Scene::validate`] and [`SkySettings::validate`].
    pub fn new(scene: &Scene, settings: &SkySettings, size: [u32; 2]) -> Result<Self> {
        let view = scene.validate()?;
        settings.validate()?;
        Ok(Self::of(scene, &view, settings, size, None))
    }

    /// The plan of the frame that follows another: what is on stays on until leaving it out uses up less than half of the
    /// bound, so that a scene on a threshold does not switch in every frame. Either way it is within the bound.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn after(previous: &Self, scene: &Scene, settings: &SkySettings, size: [u32; 2]) -> Result<Self> {
        let view = scene.validate()?;
        settings.validate()?;
        Ok(Self::of(scene, &view, settings, size, Some(previous)))
    }

    /// Every effect with its reason.
    pub fn effects(&self) -> &[Effect] {
        &self.effects
    }

    /// An effect by its name.
    pub fn effect(&self, name: &str) -> Option<&Effect> {
        self.effects.iter().find(|e| e.name == name)
    }

    /// Of a checked scene and settings.
    pub(crate) fn of(
        scene: &Scene,
        view: &ZenithView,
        settings: &SkySettings,
        size: [u32; 2],
        previous: Option<&Self>,
    ) -> Self {
        let p = &scene.atmosphere;
        let sight = Sight::new(p, view);
        let mut plan = Self {
            effects: NAMES.map(|name| Effect { name, on: false, reason: Reason::of("no air to see") }),
            background: None,
            reduced: false,
            sun: None,
            moon: None,
            before: None,
            tables: None,
            eclipse: false,
            sky_weight: match settings.composition {
                Composition::Full => background_weight(view.altitude),
                Composition::SkyDome => 1.0,
                Composition::AtmospherePost | Composition::Planet => 0.0,
            },
            samples: [0; 2],
        };
        plan.set(Name::Reduced, false, Reason::of("no sky to draw smaller"));
        let sky = Looking { p, view, settings, sight: &sight, size };
        let (sun, moon) = (plan.sun_disk(&sky), plan.moon_disk(&sky));
        let all = Constituents::of(p);
        let why_not = if !settings.enabled {
            Some("switched off")
        } else if !all.any() {
            Some("no constituent has a coefficient above 0")
        } else if settings.bound.is_some() && !sight.air {
            Some("outside the picture")
        } else {
            None
        };
        let air = match why_not {
            Some(text) => {
                plan.set(Name::Atmosphere, false, Reason::of(text));
                Constituents::default()
            }
            None => plan.constituents(p, settings, &sight, all, sun.is_some(), previous),
        };
        if settings.enabled {
            plan.eclipse(p, view, settings, &sight, air);
            plan.passes_for(p, view, settings, &sight, air, [sun, moon]);
        }
        plan
    }

    fn set(&mut self, name: Name, on: bool, reason: Reason) {
        let effect = &mut self.effects[name as usize];
        (effect.on, effect.reason) = (on, reason);
    }

    fn is_on(&self, name: Name) -> bool {
        self.effects[name as usize].on
    }

    /// Where in the picture the sun's disk is drawn.
    fn sun_disk(&mut self, sky: &Looking<'_>) -> Option<[f64; 4]> {
        let behind_moon = disks(sky.p, sky.view).is_some_and(|d| d.phase() == Phase::Total);
        let switched_on = sky.settings.sun_disk;
        let place = sky.disk(sky.view.sun, sky.p.sun_angular_radius, switched_on);
        let place = place.and_then(|(rect, text)| {
            let left_out = behind_moon && sky.settings.bound.is_some();
            if left_out { Err("behind the moon") } else { Ok((rect, text)) }
        });
        self.set_disk(Name::SunDisk, place)
    }

    /// Where in the picture the moon's disk is drawn.
    fn moon_disk(&mut self, sky: &Looking<'_>) -> Option<[f64; 4]> {
        let place = sky.view.moon.ok_or("the scene has none").and_then(|moon| {
            let distance = moon.position.length();
            sky.disk(moon.position / distance, (moon.radius / distance).min(1.0).asin(), true)
        });
        self.set_disk(Name::MoonDisk, place)
    }

    fn set_disk(
        &mut self,
        name: Name,
        place: std::result::Result<([f64; 4], &'static str), &'static str>,
    ) -> Option<[f64; 4]> {
        let text = place.map_or_else(|text| text, |(_, text)| text);
        self.set(name, place.is_ok(), Reason::of(text));
        place.ok().map(|(rect, _)| rect)
    }

    /// Which constituents and which light: everything that needs an upper bound.
    fn constituents(
        &mut self,
        p: &AtmosphereParams,
        settings: &SkySettings,
        sight: &Sight,
        all: Constituents,
        sun: bool,
        previous: Option<&Self>,
    ) -> Constituents {
        let tables = matches!(settings.method, Method::Lut(_));
        // Tables hold every direction, whichever way the camera looks.
        let low = if tables { 0.0 } else { sight.lowest };
        let scattering = Scattering::new(p, sight, low);
        let bound = settings.bound.unwrap_or(Bound::EXACT);
        let everything = settings.bound.is_none();
        let there = [all.rayleigh, all.mie.is_some(), all.ozone];
        // Each candidate with the share of the bound that leaving it out uses up.
        // A sun whose disk is in the picture stands in no night, however large it is.
        let night = if sun { f64::INFINITY } else { scattering.night(sight, tables) };
        let scattered = scattering.scatters();
        let mut costs = [
            (Name::Rayleigh, if there[0] { scattering.without(0, bound) } else { 0.0 }),
            (Name::Mie, if there[1] { scattering.without(1, bound) } else { 0.0 }),
            (Name::Ozone, if there[2] { scattering.without(2, bound) } else { 0.0 }),
            (Name::Sunlight, share(night, bound.absolute)),
            (Name::Multiple, if tables { share(scattering.multiple(), bound.absolute) } else { f64::INFINITY }),
        ];
        costs.sort_unstable_by(|a, b| a.1.total_cmp(&b.1));
        let mut spent = 0.0;
        let mut out = [false; 5];
        for (name, cost) in costs {
            let index = name as usize - Name::Rayleigh as usize;
            // What is not there at all costs nothing to leave out, not even where nothing is to be left out.
            let absent = index < 3 && !there[index];
            let most = if previous.is_some_and(|p| p.is_on(name)) { STAYS } else { 1.0 };
            if absent || (!everything && spent + cost <= most) {
                spent += if absent { 0.0 } else { cost };
                out[index] = true;
            }
        }
        let names = [Name::Rayleigh, Name::Mie, Name::Ozone];
        for (i, name) in names.into_iter().enumerate() {
            let depth = scattering.depth(i);
            let reason = match (there[i], out[i]) {
                (false, _) => Reason::of("its coefficients are 0"),
                (_, true) => Reason::number("changes no pixel by more than the bound: optical depth", depth, ""),
                (_, false) => Reason::number("optical depth along the longest path", depth, ""),
            };
            self.set(name, !out[i], reason);
        }
        let air = Constituents { rayleigh: !out[0], mie: all.mie.filter(|_| !out[1]), ozone: !out[2], dark: false };
        if !air.any() {
            self.set(Name::Atmosphere, false, Reason::of("too thin to be seen"));
            return air;
        }
        let altitude = Reason::number("in the picture; camera at", sight.altitude / 1e3, " km");
        self.set(Name::Atmosphere, true, altitude);
        let depression = -sight.sun_elevation.to_degrees();
        let lit = scattered && !out[3];
        let reason = match (scattered, out[3]) {
            (false, _) => Reason::of("nothing scatters it, or the sun is dark"),
            (_, true) if night == 0.0 => {
                Reason::number("the planet's shadow covers all air in sight; sun at", -depression, "°")
            }
            (_, true) => Reason::number("night: the air in sight is darker than the bound; sun at", -depression, "°"),
            (_, false) if everything => Reason::of("nothing is to be left out"),
            (_, false) => Reason::number("sun at", -depression, "°"),
        };
        self.set(Name::Sunlight, lit, reason);
        let multiple = lit && tables && !out[4];
        let reason = if !lit {
            Reason::of("there is no light to scatter again")
        } else if !tables {
            Reason::of("the method computes light scattered once")
        } else if out[4] {
            Reason::number("changes no pixel by more than the bound: radiance at most", scattering.multiple(), "")
        } else {
            Reason::number("optical depth of scattering", scattering.total(), "")
        };
        self.set(Name::Multiple, multiple, reason);
        if lit || sun { air } else { air.in_the_dark() }
    }

    /// Whether the moon's shadow falls on air that is seen.
    fn eclipse(
        &mut self,
        p: &AtmosphereParams,
        view: &ZenithView,
        settings: &SkySettings,
        sight: &Sight,
        air: Constituents,
    ) {
        let down = -glam::DVec3::Z * sight.r;
        // The whole planet with its air; and what a camera within the air can see of it.
        let apart = misses(view, p, down, sight.top).max(misses(view, p, glam::DVec3::ZERO, sight.farthest()));
        let (on, reason) = if view.moon.is_none() {
            (false, Reason::of("the scene has no moon"))
        } else if !air.any() {
            (false, Reason::of("no air to see"))
        } else if !self.is_on(Name::Sunlight) {
            (false, Reason::of("there is no light to hide"))
        } else if settings.bound.is_some() && apart > 0.0 {
            (false, Reason::number("the moon's shadow misses the air in sight by", apart / 1e3, " km"))
        } else {
            (true, Reason::of("the moon's shadow falls on air in sight"))
        };
        self.set(Name::Eclipse, on, reason);
        self.eclipse = on;
        if on && matches!(settings.method, Method::Lut(_)) && !self.is_on(Name::Multiple) {
            self.set(Name::Multiple, true, Reason::of("under the moon's shadow it is most of the light"));
        }
    }

    /// Which passes draw that air.
    fn passes_for(
        &mut self,
        p: &AtmosphereParams,
        view: &ZenithView,
        settings: &SkySettings,
        sight: &Sight,
        air: Constituents,
        [sun, moon]: [Option<[f64; 4]>; 2],
    ) {
        let all = settings.bound.is_none();
        let sky = air.any() && (all || sight.sky);
        let weight = self.sky_weight;
        let altitude = view.altitude / 1e3;
        let composition = settings.composition;
        let behind = sky && weight > 0.0;
        if air.any() {
            let reason = if !sky {
                Reason::of("the planet fills the picture")
            } else if weight > 0.0 && composition == Composition::Full {
                Reason::number("below 50 km the sky is drawn first; camera at", altitude, " km")
            } else if weight > 0.0 {
                Reason::of("the composition draws all of the sky first")
            } else if composition == Composition::Full {
                Reason::number("above 50 km the depth-aware pass draws the sky; camera at", altitude, " km")
            } else {
                Reason::of("the composition draws the sky over the scene")
            };
            self.set(Name::Background, behind, reason);
        }
        // The share of the sky that the depth-aware pass draws.
        let over = matches!(composition, Composition::Full | Composition::AtmospherePost | Composition::Planet);
        let shell = over && sky && weight < 1.0;
        let something = settings.foreground || sight.ground || all;
        let aerial = over && air.any() && something;
        if air.any() {
            let reason = if !over {
                Reason::of("the composition draws the sky alone")
            } else if !sky {
                Reason::of("the planet fills the picture")
            } else if weight < 1.0 {
                Reason::number("its share of the sky is", 1.0 - weight, "")
            } else {
                Reason::number("below 15 km the background is all of the sky; camera at", altitude, " km")
            };
            self.set(Name::Shell, shell, reason);
            let reason = if !over {
                Reason::of("the composition draws the sky alone")
            } else if settings.foreground {
                Reason::of("a scene with depth")
            } else if something {
                Reason::of("the ground is in the picture")
            } else {
                Reason::of("nothing lies before the sky")
            };
            self.set(Name::Aerial, aerial, reason);
        }
        let tables = match settings.method {
            Method::Lut(lut) if air.any() => Some(lut),
            _ => None,
        };
        self.samples = match settings.method {
            Method::Single { view_samples, light_samples } => [view_samples, light_samples],
            Method::Lut(_) => [0; 2],
        };
        let behind_air = if behind { air } else { Constituents::default() };
        let haze = air.mie.filter(|_| air.has_haze());
        if behind {
            self.background = Some(match tables {
                _ if self.eclipse => Program::EclipseSky { phase: p.mie_phase, tables: tables.is_some() },
                Some(_) => Program::SkyLut { mie: haze, only: false },
                None => Program::Sky { air },
            });
        }
        let dims = Constituents { dark: false, ..behind_air.without_phase() };
        let disks = disks(p, view);
        let share = disks.map_or(1.0, |d| d.visible());
        let hidden = disks.is_some_and(|d| d.apart < d.sun + d.moon + MARGIN);
        let program = Program::Sun { air: dims, limb: settings.limb_darkening, moon: hidden };
        self.sun = sun.map(|rect| DiskPlan { label: "sun", program, rect, share });
        self.moon = moon.map(|rect| DiskPlan { label: "moon", program: Program::Moon { air: dims }, rect, share });
        if shell || aerial {
            let blend = composition == Composition::Planet;
            self.before = Some(match tables {
                _ if self.eclipse => Program::EclipseAerial { phase: p.mie_phase, tables: tables.is_some(), blend },
                Some(_) => Program::AerialLut { mie: haze, blend },
                None => Program::Aerial { air, blend },
            });
        }
        let needed = behind || self.before.is_some();
        self.tables = tables.filter(|_| needed).map(|settings| TablePlan {
            settings,
            air: Constituents { dark: false, ..air.without_phase() },
            haze: air.has_haze() && !self.eclipse,
            rounds: if self.is_on(Name::Multiple) { settings.rounds(p) } else { 0 },
            slices: self.before.is_some() && !self.eclipse,
            sky: !self.eclipse,
        });
        if air.any() {
            let reason = match (tables, needed) {
                (Some(_), true) if self.eclipse => "the sky is marched: a moon's shadow is not as its tables are",
                (Some(_), true) if air.dark => "hold the transmittance of every direction",
                (Some(_), true) => "hold the light of every direction",
                (Some(_), false) => "no pass reads them",
                (None, _) => "the method marches along each ray",
            };
            self.set(Name::Tables, self.tables.is_some_and(|t| t.sky), Reason::of(reason));
            let slices = self.tables.is_some_and(|t| t.slices);
            let reason = match (self.tables.is_some(), slices) {
                (_, true) if air.dark => "holds the transmittance up to the scene",
                (_, true) => "holds the light up to the scene",
                (true, false) if self.eclipse => "the air is marched under the moon's shadow",
                (true, false) => "no pass reads it",
                (false, _) => "no tables",
            };
            self.set(Name::Slices, slices, Reason::of(reason));
        }
        if self.background.is_some() {
            self.reduced = settings.render_scale < 1.0;
            let text = if self.reduced { "render scale" } else { "the background is drawn in full size: render scale" };
            self.set(Name::Reduced, self.reduced, Reason::number(text, settings.render_scale, ""));
        }
    }

    /// The passes in order, those that fill tables included, as a first frame runs them.
    pub fn passes(&self) -> Vec<PlannedPass> {
        let mut passes = Vec::new();
        let mut add =
            |label, program, runs, times| passes.push(PlannedPass { label, program, runs, times, share: 1.0 });
        if let Some(t) = &self.tables {
            let (air, diffuse) = (t.air, t.rounds > 0);
            add("columns table", Some(Program::LutColumns), Runs::PerMedium, 1);
            if t.rounds > 0 {
                add("moments table", None, Runs::PerMedium, 1);
                add("moments table", Some(Program::LutRadiance), Runs::PerMedium, t.rounds);
                add("moments table", Some(Program::LutMoments), Runs::PerMedium, t.rounds);
            }
            if t.sky {
                add("sky table", Some(Program::LutSky { air, aerosol: false, diffuse }), Runs::PerAltitude, 1);
            }
            if t.haze {
                add("sky table", Some(Program::LutSky { air, aerosol: true, diffuse: false }), Runs::PerAltitude, 1);
            }
            if t.slices {
                add("air table", Some(Program::LutAir { air, diffuse }), Runs::PerAltitude, 1);
                let scans = t.settings.air[2].next_power_of_two().trailing_zeros();
                add("air table", Some(Program::LutScan { finish: false }), Runs::PerAltitude, scans);
                add("air table", Some(Program::LutScan { finish: true }), Runs::PerAltitude, 1);
            }
        }
        if let Some(program) = self.background {
            add("background sky", Some(program), Runs::PerFrame, 1);
            if self.reduced {
                add("upsample sky", Some(Program::Upsample), Runs::PerFrame, 1);
            }
        }
        for disk in [self.sun, self.moon].into_iter().flatten() {
            let [left, bottom, right, top] = disk.rect;
            let share = 0.25 * (right - left) * (top - bottom);
            let (label, program) = (disk.label, Some(disk.program));
            passes.push(PlannedPass { label, program, runs: Runs::PerFrame, times: 1, share });
        }
        let mut add =
            |label, program, runs, times| passes.push(PlannedPass { label, program, runs, times, share: 1.0 });
        if let Some(program) = self.before {
            let blend = program.blends();
            add(if blend { "planet shell" } else { "aerial perspective" }, Some(program), Runs::PerFrame, 1);
        }
        passes
    }
}

/// A camera that may see a disk in the sky.
struct Looking<'a> {
    p: &'a AtmosphereParams,
    view: &'a ZenithView,
    settings: &'a SkySettings,
    sight: &'a Sight,
    size: [u32; 2],
}

impl Looking<'_> {
    /// Where in the picture a disk lit by the sun is and why it is drawn, or why it is not. radius: radians.
    fn disk(
        &self,
        towards: glam::DVec3,
        radius: f64,
        switched_on: bool,
    ) -> std::result::Result<([f64; 4], &'static str), &'static str> {
        // With the soft edge of half a pixel.
        let radius = radius + self.view.basis.up.length() / f64::from(self.size[1].max(1));
        if !self.settings.enabled || !switched_on {
            return Err("switched off");
        }
        if self.p.sun_intensity <= 0.0 {
            return Err("the sun is dark");
        }
        let rect = rectangle(&self.view.basis, towards, radius, self.size).ok_or("outside the picture")?;
        match self.settings.bound {
            None => Ok((rect, "nothing is to be left out")),
            Some(_) if self.sight.hides(towards, radius) => Err("behind the planet"),
            Some(_) => Ok((rect, "in the picture")),
        }
    }
}

/// The disks of sun and moon as the camera sees them.
fn disks(p: &AtmosphereParams, view: &ZenithView) -> Option<Disks> {
    view.moon?.disks(glam::DVec3::ZERO, view.sun, p.sun_angular_radius)
}
