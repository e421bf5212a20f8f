//! The precomputed tables: what depends on the medium alone, what on the camera's altitude and the sun, and which
//! passes bring the stale ones up to date.
//!
//! | table | depends on | holds |
//! |---|---|---|
//! | columns | medium | densities integrated towards the top (Bruneton & Neyret 2008, section 4), as logarithms |
//! | moments | medium, ground | light of all orders, as angular moments per altitude and sun angle |
//! | sky | + altitude of the camera, sun's elevation | light of every ray's whole length (Hillaire 2020, section 5.3) |
//! | air | the same | shares of that light, and transmittance, along each ray |
//!
//! Nothing depends on where the camera looks. In a spherical atmosphere under a parallel sun, light at a point
//! depends on two numbers; scattering after Rayleigh needs its moments of degree 0 and 2 only, so that
//! six numbers per colour carry all orders of it exactly. What an aerosol turns by small angles only counts as
//! not scattered in `moments` (delta-M, Wiscombe 1977, with a smaller share), and is seen with its whole phase function when it comes straight
//! from the sun (TMS, Nakajima & Tanaka 1988).

use super::draw::Draw;
use super::uniforms::{FrameUniform, MediumUniform, block};
use crate::error::{Error, Result};
use crate::frame::plan::TablePlan;
use crate::gpu::{Backend, DepthUse, Format, Inputs, Pass, Target, TextureDesc, TextureId, Uniform};
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::shaders::Constituents;
use crate::shaders::aerial_lut_slices::numbers::AIR_KINDS;
use crate::shaders::multi_scattering_lut::numbers::{AZIMUTHS, MOMENTS, ZENITHS};

block! {
    /// `struct Luts`: see the fields' comments in `lib/luts.wgsl`.
    #[allow(missing_docs)]
    TablesUniform {
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
        shift: u32,
        slices: u32,
        aerial_ground_rows: f32,
    }
}

block! {
    /// `struct Uniforms` of the passes whose tables depend on the medium alone.
    #[allow(missing_docs)]
    MediumTables {
        medium: MediumUniform,
        luts: TablesUniform,
    }
}

block! {
    /// `struct Uniforms` of the passes that know the camera.
    #[allow(missing_docs)]
    FrameTables {
        frame: FrameUniform,
        luts: TablesUniform,
    }
}

/// Sizes of the tables and steps along rays. All sides count texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LutSettings {
    /// Distances to the top and altitudes of the columns' table, 8 to 1024 each.
    pub columns: [u32; 2],
    /// Sun angles and altitudes of the table of moments, 8 to 256 each.
    pub moments: [u32; 2],
    /// Steps along the rays that fill the table of moments, 4 to 256.
    pub moment_steps: u32,
    /// How often light is scattered again before the rest is left out, 1 to 64, in thin air; times 1 + the
    /// optical depth of scattering in thick, up to 24.
    pub orders: u32,
    /// Azimuths in half a turn (the other half is the mirror image) and zenith angles of the sky table, 8 to 1024 each.
    pub sky: [u32; 2],
    /// Steps along the rays that fill the sky table, 4 to 256.
    pub sky_steps: u32,
    /// Azimuths in half a turn, zenith angles and slices along the ray of the air table, 4 to 128 each.
    pub air: [u32; 3],
    /// Steps in each slice, 1 to 16.
    pub air_steps: u32,
}

impl Default for LutSettings {
    /// [`Self::MEDIUM`].
    fn default() -> Self {
        Self::MEDIUM
    }
}

impl LutSettings {
    /// Rounds of scattering for a medium: thick ones need more than `orders`.
    pub(crate) fn rounds(&self, p: &AtmosphereParams) -> u32 {
        let depth = scattering_depths(p).iter().sum::<f64>();
        (f64::from(self.orders) * (1.0 + depth)).round().clamp(1.0, f64::from(self.orders.max(24))) as u32
    }

    /// The least that keeps the sky within about a percent of [`Self::HIGH`] by day; coarse at the limb.
    pub const LOW: Self = Self {
        columns: [64, 32],
        moments: [40, 14],
        moment_steps: 12,
        orders: 6,
        sky: [48, 64],
        sky_steps: 16,
        air: [12, 24, 12],
        air_steps: 1,
    };

    /// For ordinary use. The sky table has 200 × 100 texels over the whole turn, half of which are mirrored.
    pub const MEDIUM: Self = Self {
        columns: [128, 64],
        moments: [40, 14],
        moment_steps: 12,
        orders: 6,
        sky: [100, 100],
        sky_steps: 32,
        air: [16, 32, 16],
        air_steps: 1,
    };

    /// Next to no sampling error: what is left is the model's.
    pub const HIGH: Self = Self {
        columns: [256, 64],
        moments: [56, 20],
        moment_steps: 16,
        orders: 10,
        sky: [200, 400],
        sky_steps: 64,
        air: [32, 64, 32],
        air_steps: 1,
    };

    /// Checks the ranges given at the fields.
    pub fn validate(&self) -> Result<()> {
        let check = |name: &str, v: u32, lo: u32, hi: u32| {
            let allowed = (lo..=hi).contains(&v);
            if allowed { Ok(()) } else { Err(Error::invalid(name, v, format_args!("from {lo} to {hi}"))) }
        };
        for v in self.columns {
            check("lut.columns", v, 8, 1024)?;
        }
        for v in self.moments {
            check("lut.moments", v, 8, 256)?;
        }
        for v in self.sky {
            check("lut.sky", v, 8, 1024)?;
        }
        for v in self.air {
            check("lut.air", v, 4, 128)?;
        }
        check("lut.moment_steps", self.moment_steps, 4, 256)?;
        check("lut.orders", self.orders, 1, 64)?;
        check("lut.sky_steps", self.sky_steps, 4, 256)?;
        check("lut.air_steps", self.air_steps, 1, 16)
    }

    /// Rows of the sky and of the air table for rays that end on the ground.
    fn ground_rows(&self) -> [u32; 2] {
        [self.sky[1] * 2 / 5, self.air[1] / 2]
    }
}

/// Labels of the passes whose tables depend on the medium alone: a scene pays for them once.
pub const MEDIUM_LABELS: [&str; 2] = ["columns table", "moments table"];

/// Steps of the columns' integrals.
const COLUMN_STEPS: u32 = 96;

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

/// The share of the light that an aerosol scatters which counts as going straight on, per channel.
///
/// Delta-M would take the first moment that is left out, g³. A lobe of g = 0.8 is wider than the bright band at the
/// horizon, though, and light that it turns is lost from there: a much smaller share is right in thin haze. The
/// powers of g are the best for Earth's haze (10) and for Mars' dust (5) against the f64 reference.
fn forward_shares(p: &AtmosphereParams) -> [f64; 3] {
    let [_, depth] = scattering_depths(p);
    let power = 5.0 + 5.0 * (-depth / 0.05).exp();
    p.mie_asymmetry.map(|g| g.max(0.0).powf(power))
}

impl TablesUniform {
    /// For a medium that [`AtmosphereParams::validate`] accepts; a pass fills in the size and the steps of its table.
    pub fn new(p: &AtmosphereParams, settings: &LutSettings) -> Self {
        let moments: [[f64; 4]; 3] = std::array::from_fn(|c| phase_moments(p.mie_phase, p.mie_asymmetry[c]));
        // The share that goes on as if nothing had happened: the first moment that is left out.
        let forward = forward_shares(p);
        let extinction = p.mie_extinction();
        let top = p.thickness();
        let mut scale = p.rayleigh_scale_height;
        if extinction.iter().any(|&v| v > 0.0) {
            scale = scale.min(p.mie_scale_height);
        }
        let steepness = (1.0 + top / (8.0 * scale)).ln().clamp(0.5, 9.0);
        // Where the top of the air still sees the sun when the ground does not.
        let dip = (p.planet_radius / p.atmosphere_radius).acos();
        let middle = -0.5 * dip.sin();
        let width = (0.3 * dip.sin()).clamp(0.01, 0.3);
        let last = ((1.0 - middle) / width).asinh();
        let lowest = -(2.5 * dip).min(std::f64::consts::FRAC_PI_2).sin();
        let first = ((lowest - middle) / width).asinh();
        let moment = |l: usize| std::array::from_fn(|c| (moments[c][l] - forward[c]) as f32);
        let [sky, air] = settings.ground_rows().map(|rows| rows as f32);
        Self {
            mie_extinction: std::array::from_fn(|c| ((extinction[c] - forward[c] * p.mie_scattering[c]) * 1e3) as f32),
            altitude_steepness: steepness as f32,
            mie_moment0: moment(0),
            altitude_growth: steepness.exp_m1() as f32,
            mie_moment1: moment(1),
            sun_middle: middle as f32,
            mie_moment2: moment(2),
            sun_width: width as f32,
            mie_asymmetry: std::array::from_fn(|c| ((moments[c][1] - forward[c]) / (1.0 - forward[c])) as f32),
            albedo: p.ground_albedo.map(|a| a as f32),
            sun_first: first as f32,
            sun_span: (last - first) as f32,
            ground_rows: sky,
            slices: settings.air[2],
            aerial_ground_rows: air,
            ..Self::default()
        }
    }
}

/// Textures of the tables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Textures {
    columns: TextureId,
    sky: Option<TextureId>,
    /// Gathered radiance, and two tables of moments.
    scattered: Option<[TextureId; 3]>,
    haze: Option<TextureId>,
    air: Option<[TextureId; 2]>,
}

impl Textures {
    /// Densities integrated towards the top.
    pub fn columns(&self) -> TextureId {
        self.columns
    }

    /// What only some scenes call for.
    fn add(&mut self, backend: &mut dyn Backend, plan: &TablePlan, with_air: bool) -> Result<()> {
        let settings = &plan.settings;
        let format = sampled(backend);
        if plan.rounds > 0 && self.scattered.is_none() {
            let [suns, altitudes] = settings.moments;
            let moments = [suns, altitudes * MOMENTS + 1];
            let radiance = [suns * AZIMUTHS, altitudes * ZENITHS];
            let full = Format::Rgba32Float;
            let sizes = [("gathered radiance", radiance), ("moments table", moments), ("moments table", moments)];
            self.scattered = Some(create(backend, sizes.map(|(label, size)| (label, size, full)))?);
        }
        if plan.sky && self.sky.is_none() {
            let [sky] = create(backend, [("sky table", settings.sky, format)])?;
            self.sky = Some(sky);
        }
        if plan.haze && self.haze.is_none() {
            let [haze] = create(backend, [("sky table", settings.sky, format)])?;
            self.haze = Some(haze);
        }
        if with_air && self.air.is_none() {
            let [azimuths, zeniths, slices] = settings.air;
            let size = [azimuths * slices, zeniths * AIR_KINDS];
            self.air = Some(create(backend, [(AIR, size, format); 2])?);
        }
        Ok(())
    }

    /// All of them, with their labels.
    fn named(&self) -> impl Iterator<Item = (TextureId, &'static str)> {
        let air = self.air.into_iter().flatten().map(|id| (id, AIR));
        let scattered = self.scattered.into_iter().flatten();
        let scattered = scattered.zip(["gathered radiance", "moments table", "moments table"]);
        std::iter::once((self.columns, "columns table"))
            .chain(scattered)
            .chain(self.sky.into_iter().chain(self.haze).map(|id| (id, "sky table")))
            .chain(air)
    }
}

const AIR: &str = "air table";

/// Whether a texture is still there, and not another's: the ids of a new device begin where a lost one's did.
fn is_ours(backend: &dyn Backend, id: TextureId, label: &str) -> bool {
    backend.texture(id).is_some_and(|desc| desc.label == label)
}

/// The tables as a pass reads them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ready {
    pub columns: TextureId,
    pub sky: TextureId,
    /// Where there is an aerosol.
    pub haze: Option<TextureId>,
    /// The columns' again where no air table was asked for.
    pub air: TextureId,
}

/// What a table that is up to date was made for: camera, sun, what of the air it holds, whether with light that was
/// scattered before, and whether there is one for the aerosol's.
type ViewKey = ([f32; 4], Constituents, [bool; 2]);

/// How often in a row something is not called for before its textures go: about five seconds of frames. Not at once, for
/// the camera may turn back.
pub(crate) const IDLE: u32 = 600;

/// The tables of one medium and one view.
#[derive(Debug, Default)]
pub(crate) struct Luts {
    textures: Option<(LutSettings, Textures)>,
    /// With the rounds of scattering, which may change where the block's 32-bit numbers do not.
    medium: Option<(MediumTables, usize)>,
    sky: Option<ViewKey>,
    air: Option<ViewKey>,
    /// Plans in a row that had no use for some of the textures.
    spare: u32,
}

impl Luts {
    /// Appends the passes that bring the tables of the medium up to date.
    pub fn of_medium(
        &mut self,
        backend: &mut dyn Backend,
        params: &AtmosphereParams,
        plan: &TablePlan,
        with_air: bool,
        passes: &mut Vec<Pass>,
    ) -> Result<(Textures, TablesUniform)> {
        let t = self.textures(backend, plan, with_air)?;
        let tables = TablesUniform::new(params, &plan.settings);
        // Tables hold light per unit of irradiance.
        let medium = MediumUniform { irradiance: [0.0; 3], ..MediumUniform::new(params) };
        let key = MediumTables { medium, luts: tables };
        let rounds = plan.rounds as usize;
        let fresh = self.medium.is_some_and(|(made_for, made)| made_for == key && (rounds == 0 || made == rounds));
        if !fresh {
            self.forget();
            self.medium_passes(backend, &plan.settings, key, rounds, &t, passes)?;
            self.medium = Some((key, rounds));
        }
        Ok((t, tables))
    }

    /// Appends the passes that bring stale tables up to date. `frame`: the camera's block.
    pub fn update(
        &mut self,
        backend: &mut dyn Backend,
        params: &AtmosphereParams,
        plan: &TablePlan,
        frame: &FrameUniform,
        with_air: bool,
        passes: &mut Vec<Pass>,
    ) -> Result<(Ready, TablesUniform)> {
        let (settings, constituents, rounds) = (&plan.settings, plan.air, plan.rounds as usize);
        let (t, tables) = self.of_medium(backend, params, plan, with_air, passes)?;
        let sky = t.sky.ok_or_else(|| crate::gpu::unknown(backend.info().backend, "sky table"))?;
        // Columns, and with light that was scattered before its moments.
        let scattered = t.scattered.filter(|_| rounds > 0);
        let moments = scattered.map(|s| s[1 + rounds % 2]);
        let reads = |moments| Inputs::new([("transmittance_lut", Some(t.columns)), ("multi_scattering_lut", moments)]);
        let (diffuse, haze) = (scattered.is_some(), t.haze.filter(|_| plan.haze));
        let view =
            ([frame.altitude, frame.sun[0], frame.sun[1], frame.sun[2]], constituents, [diffuse, haze.is_some()]);
        let block = |luts: TablesUniform| Uniform::new(&FrameTables { frame: *frame, luts });
        if self.sky != Some(view) {
            let uniform = block(TablesUniform { size: settings.sky, steps: settings.sky_steps, ..tables });
            let even = (sky, false, moments);
            let straight = haze.map(|haze| (haze, true, None));
            for (target, mie_single, moments) in [Some(even), straight].into_iter().flatten() {
                let multi_scattering = moments.is_some();
                let draw = Draw::SkyView { air: constituents, mie_single, multi_scattering };
                let (program, inputs) = (Some(backend.create_program(draw.program())?), reads(moments));
                let (label, target, depth) = ("sky table", Target::color(target), DepthUse::Always);
                passes.push(Pass { label, program, inputs, uniform, target, depth });
            }
            self.sky = Some(view);
        }
        let mut ready = Ready { columns: t.columns, sky, haze, air: t.columns };
        if let (true, Some(air)) = (with_air, t.air) {
            let scans = settings.air[2].next_power_of_two().trailing_zeros();
            let at = |step: u32| air[(step % 2) as usize];
            if self.air != Some(view) {
                let [azimuths, zeniths, slices] = settings.air;
                let size = [azimuths * slices, zeniths * AIR_KINDS];
                let [_, ground_rows] = settings.ground_rows();
                let own = TablesUniform { size, steps: settings.air_steps, ground_rows: ground_rows as f32, ..tables };
                passes.push(Pass {
                    label: "air table",
                    program: Some(backend.create_program(
                        Draw::AerialSlices { air: constituents, multi_scattering: diffuse }.program(),
                    )?),
                    inputs: reads(moments),
                    uniform: block(own),
                    target: Target::color(at(0)),
                    depth: DepthUse::Always,
                });
                for step in 0..=scans {
                    let finish = step == scans;
                    passes.push(Pass {
                        label: "air table",
                        program: Some(backend.create_program(Draw::AerialScan { finish }.program())?),
                        inputs: Inputs::new([("aerial_lut", Some(at(step)))]),
                        uniform: block(TablesUniform { shift: 1 << step, ..own }),
                        target: Target::color(at(step + 1)),
                        depth: DepthUse::Always,
                    });
                }
                self.air = Some(view);
            }
            ready.air = at(scans + 1);
        }
        Ok((ready, tables))
    }

    fn medium_passes(
        &self,
        backend: &mut dyn Backend,
        settings: &LutSettings,
        block: MediumTables,
        rounds: usize,
        t: &Textures,
        passes: &mut Vec<Pass>,
    ) -> Result<()> {
        let uniform = |size: [u32; 2], steps: u32| {
            Uniform::new(&MediumTables { luts: TablesUniform { size, steps, ..block.luts }, ..block })
        };
        let mut pass = |label, program: Option<Draw>, inputs, uniform, target| {
            let program = program.map(|p| backend.create_program(p.program())).transpose()?;
            passes.push(Pass { label, program, inputs, uniform, target, depth: DepthUse::Always });
            Ok::<_, Error>(())
        };
        let columns = uniform(settings.columns, COLUMN_STEPS);
        let [columns_label, moments_label] = MEDIUM_LABELS;
        pass(columns_label, Some(Draw::Transmittance), Inputs::NONE, columns, Target::color(t.columns))?;
        let Some([radiance, moments @ ..]) = t.scattered.filter(|_| rounds > 0) else { return Ok(()) };
        // Darkness: logarithms of next to nothing.
        let dark = Target { clear: Some([-100.0; 4]), ..Target::color(moments[0]) };
        pass(moments_label, None, Inputs::NONE, Uniform::NONE, dark)?;
        for order in 0..rounds {
            let (from, to) = (moments[order % 2], moments[(order + 1) % 2]);
            let block = uniform(settings.moments, settings.moment_steps);
            let inputs = [("transmittance_lut", Some(t.columns)), ("multi_scattering_lut", Some(from))];
            pass(moments_label, Some(Draw::Gather), Inputs::new(inputs), block, Target::color(radiance))?;
            let inputs = Inputs::new([("gathered", Some(radiance))]);
            pass(moments_label, Some(Draw::MultiScattering), inputs, block, Target::color(to))?;
        }
        Ok(())
    }

    /// The table of moments once its passes were given out, what it was made for, and its nodes.
    pub fn moments(&self) -> Option<(TextureId, MediumTables, [u32; 2])> {
        let (settings, t) = self.textures.as_ref()?;
        let (made_for, rounds) = self.medium.filter(|(_, rounds)| *rounds > 0)?;
        let [_, moments @ ..] = t.scattered?;
        Some((moments[rounds % 2], made_for, settings.moments))
    }

    /// Nothing is up to date any more.
    fn forget(&mut self) {
        self.medium = None;
        self.sky = None;
        self.air = None;
    }

    /// Frees all textures.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.forget();
        if let Some((_, t)) = self.textures.take() {
            for (id, _) in t.named().filter(|&(id, label)| is_ours(backend, id, label)).collect::<Vec<_>>() {
                backend.destroy_texture(id);
            }
        }
    }

    fn textures(&mut self, backend: &mut dyn Backend, plan: &TablePlan, with_air: bool) -> Result<Textures> {
        let settings = &plan.settings;
        let known = self
            .textures
            .filter(|(made_for, t)| made_for == settings && t.named().all(|(id, label)| is_ours(backend, id, label)));
        let mut t = match known {
            Some((_, t)) => t,
            None => {
                self.destroy(backend);
                let [columns] = create(backend, [("columns table", settings.columns, Format::Rgba32Float)])?;
                Textures { columns, sky: None, scattered: None, haze: None, air: None }
            }
        };
        let (haze, scattered) = (t.haze.is_some() && !plan.haze, t.scattered.is_some() && plan.rounds == 0);
        let sky = t.sky.is_some() && !plan.sky;
        self.spare = if haze || scattered || sky { self.spare.saturating_add(1) } else { 0 };
        if self.spare >= IDLE {
            if let Some(id) = t.sky.take_if(|_| sky) {
                backend.destroy_texture(id);
                self.sky = None;
            }
            for id in t.air.take_if(|_| sky).into_iter().flatten() {
                backend.destroy_texture(id);
                self.air = None;
            }
            if let Some(haze) = t.haze.take_if(|_| haze) {
                backend.destroy_texture(haze);
            }
            if let Some(ids) = t.scattered.take_if(|_| scattered) {
                ids.into_iter().for_each(|id| backend.destroy_texture(id));
                self.medium = self.medium.map(|(made_for, _)| (made_for, 0));
            }
        }
        let more = t.add(backend, plan, with_air);
        self.textures = Some((*settings, t));
        more.map(|()| t)
    }
}

/// Format of the tables that pixels read through the sampler. Half floats hold fourth roots of light to 0.1 % of the
/// light, and shares and transmittances to 0.03 %.
fn sampled(backend: &dyn Backend) -> Format {
    if backend.info().filters_f32 { Format::Rgba32Float } else { Format::Rgba16Float }
}

/// All of the textures or none.
fn create<const N: usize>(
    backend: &mut dyn Backend,
    sizes: [(&'static str, [u32; 2], Format); N],
) -> Result<[TextureId; N]> {
    let max = backend.info().max_texture_size;
    let descs = sizes.map(|(label, [w, h], format)| TextureDesc::new(label, w, h, format));
    descs.iter().try_for_each(|d| d.validate(max))?;
    let mut made = [TextureId::default(); N];
    for (i, desc) in descs.iter().enumerate() {
        match backend.create_texture(desc) {
            Ok(id) => made[i] = id,
            Err(e) => {
                made[..i].iter().for_each(|&id| backend.destroy_texture(id));
                return Err(e);
            }
        }
    }
    Ok(made)
}
