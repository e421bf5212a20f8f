//! The LUTs (lookup tables): what depends on the medium alone, and what on the camera's altitude and the sun.
//!
//! | LUT | depends on | holds |
//! |---|---|---|
//! | transmittance | medium | logarithms of densities up to the top (Bruneton & Neyret 2008, section 4) |
//! | multi-scattering | medium, ground | light of all orders, as angular moments per altitude and sun angle |
//! | sky view | + altitude of the camera, the sun's | light of every whole ray (Hillaire 2020, section 5.3) |
//! | aerial | the same | fractions of that light, and transmittance, along each ray |
//!
//! Nothing depends on where the camera looks. In a spherical atmosphere under a parallel sun, light at a
//! point depends on two numbers; scattering after Rayleigh needs its moments of degree 0 and 2 only, so that
//! six numbers per colour carry all orders of it exactly. What an aerosol turns by small angles only counts
//! as not scattered in the multi-scattering LUT (delta-M, Wiscombe 1977, with a smaller fraction), and is
//! seen with its whole phase function when it comes straight from the sun (TMS, Nakajima & Tanaka 1988).

use super::Frame;
use super::effect::{Decision, Effect, Reason};
use super::graph::{Extent, Node, Resource, Runs, Texel, Work, reads};
use super::medium::{Air, NO_AIR};
use super::uniforms::{FrameUniform, MediumUniform, block};
use super::{aerial, background};
use crate::gpu::Uniform;
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::settings::{LutSettings, Quality};
use crate::shaders::aerial_lut::numbers::{AIR_KINDS, AIR_SUMMANDS};
use crate::shaders::multi_scattering_lut::numbers::{AZIMUTHS, MOMENTS, ZENITHS};
use crate::shaders::{
    aerial_lut, aerial_lut_summands, multi_scattering_gather, multi_scattering_lut, sky_view_lut,
    transmittance_lut,
};

block! {
    /// `struct Luts`: see the fields' comments in `lib/luts.wgsl`.
    #[allow(missing_docs)]
    LutsUniform {
        mie_extinction: [f32; 3],
        altitude_steepness: f32,
        mie_moment0: [f32; 3],
        altitude_growth: f32,
        mie_moment1: [f32; 3],
        sun_middle: f32,
        mie_moment2: [f32; 3],
        sun_width: f32,
        mie_asymmetry: [f32; 3],
        pad: f32,
        albedo: [f32; 3],
        sun_first: f32,
        sun_span: f32,
        ground_rows: f32,
        size: [u32; 2],
        steps: u32,
        pad1: u32,
        slices: u32,
        aerial_ground_rows: f32,
    }
}

block! {
    /// `struct Uniforms` of the passes whose LUTs depend on the medium alone.
    #[allow(missing_docs)]
    MediumLuts {
        medium: MediumUniform,
        luts: LutsUniform,
    }
}

block! {
    /// `struct Uniforms` of the passes that know the camera.
    #[allow(missing_docs)]
    FrameLuts {
        frame: FrameUniform,
        luts: LutsUniform,
    }
}

/// Labels of the passes whose LUTs depend on the medium alone: a scene pays for them once.
pub const MEDIUM_LABELS: [&str; 2] = ["transmittance LUT", "multi-scattering LUT"];
const SKY_VIEW_LABEL: &str = "sky-view LUT";
const AERIAL_LABEL: &str = "aerial LUT";

/// The LUTs as nodes name them.
pub(crate) const TRANSMITTANCE: Resource = Resource::pool("transmittance_lut", 0);
pub(crate) const SKY_VIEW: Resource = Resource::pool("sky_view_lut", 0);
pub(crate) const MIE_SINGLE: Resource = Resource::pool("mie_single_lut", 0);
const AERIAL: Resource = Resource::pool("aerial_lut", 0);
const AERIAL_SUMMANDS: Resource = Resource::pool("aerial_lut_summands", 0);
const GATHERED: Resource = Resource::pool("gathered_radiance", 0);

/// The multi-scattering LUT after so many rounds of scattering: rounds read one of two and write the other.
pub(crate) const fn multi_scattering(rounds: u32) -> Resource {
    Resource::pool("multi_scattering_lut", (rounds % 2) as u8)
}

/// Steps of the transmittance LUT's integrals.
const TRANSMITTANCE_STEPS: u32 = 96;

/// Phase moments `χ_l = ∫ p(μ) P_l(μ) 2π dμ`, l from 0 to 3.
fn phase_moments(phase: MiePhase, g: f64) -> [f64; 4] {
    let hg = |l: i32| if l < 0 { 0.0 } else { g.powi(l) };
    match phase {
        MiePhase::HenyeyGreenstein => [0, 1, 2, 3].map(hg),
        MiePhase::CornetteShanks => {
            // 1.5 (1 + μ²) / (2 + g²) of the former; twice (2 l + 1) μ P_l = (l + 1) P_{l+1} + l P_{l-1}.
            let once = |l: i32| {
                let k = f64::from(l);
                ((k + 1.0) * hg(l + 1) + k * hg(l - 1)) / (2.0 * k + 1.0)
            };
            [0, 1, 2, 3].map(|l| {
                let k = f64::from(l);
                let below = if l == 0 { 0.0 } else { once(l - 1) };
                let twice = ((k + 1.0) * once(l + 1) + k * below) / (2.0 * k + 1.0);
                1.5 / (2.0 + g * g) * (hg(l) + twice)
            })
        }
    }
}

/// Vertical optical depth of scattering, the largest channel's: gas and aerosol.
fn scattering_depths(p: &AtmosphereParams) -> [f64; 2] {
    let depth = |c: [f64; 3], height: f64| c.iter().fold(0.0, |a: f64, &v| a.max(v * height));
    [depth(p.rayleigh_scattering, p.rayleigh_scale_height), depth(p.mie_scattering, p.mie_scale_height)]
}

/// The fraction of the light that an aerosol scatters which counts as going straight on, per channel.
///
/// Delta-M would take the first moment that is left out, g³. A lobe of g = 0.8 is wider than the bright band
/// at the horizon, though, and light that it turns is lost from there: a much smaller fraction is right in
/// thin haze. Against the f64 reference the best power of g for Mars' dust is 5. For Earth's haze it is 10 by
/// the sky (`thorough::accuracy`: of the light 0.23 % are wrong in the mean) and 40 by the air before near
/// scenes (`thorough::near_air`: at most 1.9 % for 95 of 100 rays, where 10 has 3.7 %); 12 has 0.29 % and 2.9
/// %.
fn forward_fractions(p: &AtmosphereParams) -> [f64; 3] {
    let [_, depth] = scattering_depths(p);
    let power = 5.0 + 7.7 * (-depth / 0.05).exp();
    p.mie_asymmetry.map(|g| g.max(0.0).powf(power))
}

impl LutsUniform {
    /// For a medium that [`AtmosphereParams::validate`] accepts; a pass fills in the size and the steps of
    /// its LUT.
    pub fn new(p: &AtmosphereParams, settings: &LutSettings) -> Self {
        let moments: [[f64; 4]; 3] = std::array::from_fn(|c| phase_moments(p.mie_phase, p.mie_asymmetry[c]));
        // The fraction that counts as not scattered at all.
        let forward = forward_fractions(p);
        let extinction = p.mie_extinction();
        let top = p.thickness();
        let mut scale = p.rayleigh_scale_height;
        if extinction.iter().any(|&v| v > 0.0) {
            scale = scale.min(p.mie_scale_height);
        }
        let steepness = (1.0 + top / (8.0 * scale)).ln().clamp(0.5, 9.0);
        // Where the top of the air still sees the sun when the ground does not.
        let dip = (p.ground_radius() / p.atmosphere_radius).acos();
        let middle = -0.5 * dip.sin();
        let width = (0.3 * dip.sin()).clamp(0.01, 0.3);
        let last = ((1.0 - middle) / width).asinh();
        let lowest = -(2.5 * dip).min(std::f64::consts::FRAC_PI_2).sin();
        let first = ((lowest - middle) / width).asinh();
        let moment = |l: usize| std::array::from_fn(|c| (moments[c][l] - forward[c]) as f32);
        let [sky, aerial] = settings.ground_rows().map(|rows| rows as f32);
        Self {
            mie_extinction: std::array::from_fn(|c| {
                ((extinction[c] - forward[c] * p.mie_scattering[c]) * 1e3) as f32
            }),
            altitude_steepness: steepness as f32,
            mie_moment0: moment(0),
            altitude_growth: steepness.exp_m1() as f32,
            mie_moment1: moment(1),
            sun_middle: middle as f32,
            mie_moment2: moment(2),
            sun_width: width as f32,
            mie_asymmetry: std::array::from_fn(|c| {
                ((moments[c][1] - forward[c]) / (1.0 - forward[c])) as f32
            }),
            albedo: p.ground_albedo.map(|a| a as f32),
            sun_first: first as f32,
            sun_span: (last - first) as f32,
            ground_rows: sky,
            slices: settings.aerial[2],
            aerial_ground_rows: aerial,
            ..Self::default()
        }
    }
}

impl Frame {
    /// The settings of the frame's LUTs, if it has air whose light comes from LUTs and a pass that draws it.
    pub(crate) fn luts(&self) -> Option<LutSettings> {
        match self.settings.quality {
            Quality::Luts(luts)
                if background::is_drawn(self) || aerial::is_drawn(self) || self.is_read_by_scene() =>
            {
                Some(luts)
            }
            _ => None,
        }
    }

    /// Rounds of scattering after the first; 0 without multiple scattering, or without LUTs.
    pub(crate) fn rounds(&self) -> u32 {
        let luts = self.luts().filter(|_| self.is_on(&MultiScattering));
        luts.map_or(0, |luts| rounds(&luts, &self.scene.atmosphere))
    }

    /// The multi-scattering LUT once it is finished, if the frame has one.
    pub(crate) fn multi_scattering(&self) -> Option<Resource> {
        Some(self.rounds()).filter(|rounds| *rounds > 0).map(multi_scattering)
    }

    /// Whether what the aerosol scatters straight from the sun has a LUT of its own.
    pub(crate) fn has_mie_single(&self) -> bool {
        self.omission.air.mie && self.is_lit() && self.is_on(&SkyViewLut)
    }

    /// The aerial LUT once it is finished.
    pub(crate) fn aerial_lut(&self) -> Option<Resource> {
        (self.luts().is_some() && self.is_on(&AerialLut)).then_some(AERIAL)
    }

    /// The blocks of frame and LUTs together.
    pub(crate) fn with_luts(&self, frame: FrameUniform) -> Uniform {
        Uniform::new(&FrameLuts { frame, luts: self.luts_block })
    }
}

/// Rounds of scattering for a medium: thick ones need more than [`LutSettings::orders`].
fn rounds(luts: &LutSettings, p: &AtmosphereParams) -> u32 {
    let depth = scattering_depths(p).iter().sum::<f64>();
    (f64::from(luts.orders) * (1.0 + depth)).round().clamp(1.0, f64::from(luts.orders.max(24))) as u32
}

/// Light that was scattered more than once: the LUTs of the medium.
pub(crate) struct MultiScattering;

impl Effect for MultiScattering {
    fn name(&self) -> &'static str {
        "multiple scattering"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let o = &frame.omission;
        let luts = matches!(frame.settings.quality, Quality::Luts(_));
        if !frame.is_on(&super::medium::Sunlight) {
            (false, Reason::of("there is no light to scatter again"))
        } else if !luts {
            (false, Reason::of("the method computes light scattered once"))
        } else if o.single && frame.is_on(&super::eclipse::Eclipse) {
            (true, Reason::of("under the moon's shadow it is most of the light"))
        } else if o.single {
            (
                false,
                Reason::number("changes no pixel by more than the bound: radiance at most", o.multiple, ""),
            )
        } else {
            (true, Reason::number("optical depth of scattering", o.scattering_depth, ""))
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let Some(luts) = frame.luts() else { return };
        let size = [luts.multi_scattering[0], luts.multi_scattering[1] * MOMENTS + 1];
        let full = Extent { size, texel: Texel::Exact };
        let block = medium_block(frame, luts.multi_scattering, luts.multi_scattering_steps);
        let label = MEDIUM_LABELS[1];
        // Darkness: the logarithm of next to no light.
        nodes.push(Node {
            clear: Some([LOG_OF_DARKNESS; 4]),
            ..Node::fill(label, Runs::PerMedium, Work::Clear, multi_scattering(0), full, Uniform::NONE)
        });
        let [suns, altitudes] = luts.multi_scattering;
        let directions = [suns * AZIMUTHS, altitudes * ZENITHS];
        let gathered = Extent { size: directions, texel: Texel::Exact };
        let gather =
            Work::Draw(Air::ALL.program(&multi_scattering_gather::INFO, [("MULTI_SCATTERING", true)]));
        let moments = Work::Draw(Air::ALL.program(&multi_scattering_lut::INFO, []));
        for round in 0..frame.rounds() {
            let light = multi_scattering(round);
            nodes.push(Node {
                reads: reads([
                    ("transmittance_lut", Some(TRANSMITTANCE)),
                    ("multi_scattering_lut", Some(light)),
                ]),
                ..Node::fill(label, Runs::PerMedium, gather, GATHERED, gathered, block)
            });
            nodes.push(Node {
                reads: reads([("gathered", Some(GATHERED))]),
                ..Node::fill(label, Runs::PerMedium, moments, multi_scattering(round + 1), full, block)
            });
        }
    }
}

/// What the multi-scattering LUT holds before the first round: log2 of next to no light.
const LOG_OF_DARKNESS: f32 = -100.0;

fn medium_block(frame: &Frame, size: [u32; 2], steps: u32) -> Uniform {
    let luts = LutsUniform { size, steps, ..frame.luts_block };
    // LUTs hold light per unit of irradiance.
    Uniform::new(&MediumLuts { medium: MediumUniform { irradiance: [0.0; 3], ..frame.uniform.medium }, luts })
}

/// How much of the air a ray passes, for every altitude and direction: read by everything that has LUTs.
pub(crate) struct TransmittanceLut;

impl Effect for TransmittanceLut {
    fn name(&self) -> &'static str {
        "transmittance LUT"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        match (frame.settings.quality, frame.luts()) {
            (Quality::March { .. }, _) => (false, Reason::of("the method marches along each ray")),
            (_, None) => (false, Reason::of("no pass reads it")),
            (_, Some(_)) => (true, Reason::of("holds the air between any altitude and space")),
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let Some(luts) = frame.luts() else { return };
        let program = Work::Draw(Air::ALL.program(&transmittance_lut::INFO, []));
        let extent = Extent { size: luts.transmittance, texel: Texel::Exact };
        let block = medium_block(frame, luts.transmittance, TRANSMITTANCE_STEPS);
        nodes.push(Node::fill(MEDIUM_LABELS[0], Runs::PerMedium, program, TRANSMITTANCE, extent, block));
    }
}

/// The light of every direction around the camera.
pub(crate) struct SkyViewLut;

impl Effect for SkyViewLut {
    fn name(&self) -> &'static str {
        "sky-view LUT"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let eclipse = frame.is_on(&super::eclipse::Eclipse);
        match (frame.settings.quality, frame.luts()) {
            (Quality::March { .. }, _) => (false, Reason::of("the method marches along each ray")),
            (_, None) => (false, Reason::of("no pass reads it")),
            (_, Some(_)) if eclipse && !frame.is_read_by_scene() => {
                (false, Reason::of("the sky is marched: a moon's shadow is not symmetric"))
            }
            (_, Some(_)) if frame.is_lit() => (true, Reason::of("holds the light of every direction")),
            (_, Some(_)) => (true, Reason::of("holds the transmittance of every direction")),
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let Some(luts) = frame.luts() else { return };
        let of_sky = LutsUniform { size: luts.sky_view, steps: luts.sky_view_steps, ..frame.luts_block };
        let block = Uniform::new(&FrameLuts { frame: frame.view_luts, luts: of_sky });
        let extent = Extent { size: luts.sky_view, texel: Texel::Filtered };
        let mut fill = |writes, mie_single: bool, light: Option<Resource>| {
            let constants = [("MIE_SINGLE", mie_single), ("MULTI_SCATTERING", light.is_some())];
            let work = Work::Draw(frame.omission.air.program(&sky_view_lut::INFO, constants));
            nodes.push(Node {
                reads: reads([("transmittance_lut", Some(TRANSMITTANCE)), ("multi_scattering_lut", light)]),
                ..Node::fill(SKY_VIEW_LABEL, Runs::PerAltitude, work, writes, extent, block)
            });
        };
        fill(SKY_VIEW, false, frame.multi_scattering());
        if frame.has_mie_single() {
            fill(MIE_SINGLE, true, None);
        }
    }
}

/// How much of that light, and of what lies behind, there is up to a distance.
pub(crate) struct AerialLut;

impl Effect for AerialLut {
    fn name(&self) -> &'static str {
        "aerial LUT"
    }

    fn decide(&self, frame: &Frame) -> Decision {
        if !frame.has_air() {
            return NO_AIR;
        }
        let luts = frame.luts().is_some();
        let drawn = luts && aerial::is_drawn(frame);
        match (drawn, frame.is_on(&super::eclipse::Eclipse)) {
            _ if luts && frame.is_read_by_scene() => (true, Reason::of("the scene's own shaders read it")),
            (true, true) => (false, Reason::of("the air is marched under the moon's shadow")),
            (true, false) if frame.is_lit() => (true, Reason::of("holds the light up to the scene")),
            (true, false) => (true, Reason::of("holds the transmittance up to the scene")),
            (false, _) if luts => (false, Reason::of("no pass reads it")),
            (false, _) => (false, Reason::of("no LUTs")),
        }
    }

    fn push_nodes(&self, frame: &Frame, nodes: &mut Vec<Node>) {
        let Some(luts) = frame.luts() else { return };
        let [azimuths, zeniths, slices] = luts.aerial;
        let [_, ground_rows] = luts.ground_rows();
        let mut push = |kinds: u32, texel, program, reads, writes| {
            let size = [azimuths * slices, zeniths * kinds];
            let steps = luts.aerial_steps;
            let own = LutsUniform { size, steps, ground_rows: ground_rows as f32, ..frame.luts_block };
            let block = Uniform::new(&FrameLuts { frame: frame.view_luts, luts: own });
            let extent = Extent { size, texel };
            let work = Work::Draw(program);
            let node = Node::fill(AERIAL_LABEL, Runs::PerAltitude, work, writes, extent, block);
            nodes.push(Node { reads, ..node });
        };
        let light = frame.multi_scattering();
        let air = frame.omission.air;
        let own = air.program(&aerial_lut_summands::INFO, [("MULTI_SCATTERING", light.is_some())]);
        let medium = reads([("transmittance_lut", Some(TRANSMITTANCE)), ("multi_scattering_lut", light)]);
        push(AIR_SUMMANDS, Texel::Exact, own, medium, AERIAL_SUMMANDS);
        let sum = air.program(&aerial_lut::INFO, []);
        push(AIR_KINDS, Texel::Filtered, sum, reads([("summands", Some(AERIAL_SUMMANDS))]), AERIAL);
    }
}
