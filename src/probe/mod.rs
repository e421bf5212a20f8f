//! The shaders' own functions, one case at a time, against f64 (feature `probe`).
//!
//! Tens of thousands of [`Case`]s go into a texture, one draw runs the library's WGSL on each of them, and
//! [`judge()`] compares what comes back with the same quantity in f64. `cargo lab stress` does it a million
//! times; `tests/probe.rs` does it on both backends.
//!
//! Both sides start from the same f32 numbers, so what differs is what the shader's arithmetic loses.
//! [`Promise`] says what may be lost.

mod cases;
pub mod film;
mod frames;
#[allow(dead_code)] // Constants that only some probes ask for.
#[rustfmt::skip]
mod generated;
mod judge;
mod report;
pub mod scenes;
mod shrink;
mod truth;

pub use cases::{Cases, describe, grid, grid_len, random};
pub use frames::{Fault, Frame, frame, look, shrink_frame};
pub use generated::PROGRAMS;
pub use judge::{Finding, Quantity, Row, Tally, explain, judge};
pub use report::{NUMBERS, Record, side_by_side};
pub use shrink::{Shrink, shrink};
pub use truth::{Promise, RESOLUTION};

use crate::error::Result;
use crate::frame::luts::LutsUniform;
use crate::frame::uniforms::{FrameUniform, MediumUniform};
use crate::gpu::{Backend, Format, Inputs, Pass, Program, ReadId, Target, TextureDesc, TextureId, Ticket};
use crate::model::atmosphere::{AtmosphereParams, MiePhase};
use crate::settings::LutSettings;

/// Which functions a probe runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Probe {
    /// Rays, spheres, altitudes and the planet's shadow.
    Geometry,
    /// Densities, extinction, phase functions and the mean transmittance of a step.
    Medium,
    /// Columns along a path and the transmittance to the sun.
    Path,
    /// Single scattering, with this aerosol phase function.
    Scatter(MiePhase),
    /// Which share of the sun a moon leaves; judged by a test of its own, on cases of its own.
    Eclipse,
    /// Where in the precomputed LUTs a ray, an altitude or a sun's angle is, and what a place in them
    /// stands for.
    Luts,
}

impl Probe {
    /// All of them that [`Cases`] are for.
    pub const ALL: [Self; 6] = [
        Self::Geometry,
        Self::Medium,
        Self::Path,
        Self::Luts,
        Self::Scatter(MiePhase::HenyeyGreenstein),
        Self::Scatter(MiePhase::CornetteShanks),
    ];

    /// Those that a batch of cases is tried with, by its number: the two phase functions' scattering in turn.
    pub fn of_batch(number: u64) -> [Self; 5] {
        let phase =
            if number.is_multiple_of(2) { MiePhase::HenyeyGreenstein } else { MiePhase::CornetteShanks };
        [Self::Geometry, Self::Medium, Self::Path, Self::Luts, Self::Scatter(phase)]
    }

    /// Name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Geometry => "geometry",
            Self::Medium => "medium",
            Self::Path => "path",
            Self::Eclipse => "eclipse",
            Self::Luts => "luts",
            Self::Scatter(MiePhase::HenyeyGreenstein) => "scatter_hg",
            Self::Scatter(MiePhase::CornetteShanks) => "scatter_cs",
        }
    }

    /// The program that runs these functions, with all of its constants on but the other phase function.
    fn program(self) -> Program {
        let info = match self {
            Self::Geometry => &generated::probe_geometry::INFO,
            Self::Medium => &generated::probe_medium::INFO,
            Self::Path => &generated::probe_path::INFO,
            Self::Eclipse => &generated::probe_eclipse::INFO,
            Self::Luts => &generated::probe_luts::INFO,
            Self::Scatter(_) => &generated::probe_scatter::INFO,
        };
        let off = match self {
            Self::Scatter(MiePhase::HenyeyGreenstein) => generated::probe_scatter::CORNETTE_SHANKS,
            _ => 0,
        };
        Program::new(info, info.all() & !off)
    }

    /// Pixels that one case fills.
    pub fn answers(self) -> usize {
        let answers = match self {
            Self::Geometry => generated::probe_geometry::numbers::ANSWERS,
            Self::Medium => generated::probe_medium::numbers::ANSWERS,
            Self::Path => generated::probe_path::numbers::ANSWERS,
            Self::Scatter(_) => generated::probe_scatter::numbers::ANSWERS,
            Self::Eclipse => generated::probe_eclipse::numbers::ANSWERS,
            Self::Luts => generated::probe_luts::numbers::ANSWERS,
        };
        answers as usize
    }
}

/// What a case's functions are given: kilometres, 1/km, unit vectors of the camera's zenith frame.
/// [`Self::medium`] is the block that pictures are drawn with.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Case {
    /// Planet and air.
    pub medium: MediumUniform,
    /// Of the ray.
    pub direction: [f32; 3],
    /// Of the ray's origin, never negative.
    pub altitude: f32,
    /// Towards the sun.
    pub sun: [f32; 3],
    /// Share of the ray's way through the air that is asked about, 0 to 1.
    pub fraction: f32,
    /// Excess, r² − R², where a path begins.
    pub path_excess: f32,
    /// r μ where a path begins.
    pub path_r_mu: f32,
    /// Length of the path.
    pub path_distance: f32,
    /// Steps along it.
    pub samples: f32,
    /// 1 − cosine of a scattering angle.
    pub away: f32,
    /// Steps towards the sun.
    pub light_samples: f32,
    /// Of the LUTs' uniform block: `sun_first`.
    pub sun_first: f32,
    /// `sun_span`.
    pub sun_span: f32,
    /// u and v of a LUT, 0 to 1 each.
    pub uv: [f32; 2],
    /// 1 where u and v are among the rays that end on the ground.
    pub to_ground: f32,
    /// Number of a direction in which light is gathered.
    pub node: f32,
    /// `altitude_steepness`, `altitude_growth`, `sun_middle` and `sun_width`.
    pub scales: [f32; 4],
    /// Of the frame's uniform block, for this altitude: `sky_view_mapping`.
    pub sky_view_mapping: [f32; 4],
}

impl Case {
    /// The LUTs' numbers for this medium.
    fn with_luts(self, params: &AtmosphereParams) -> Self {
        let t = LutsUniform::new(params, &LutSettings::default());
        let scales = [t.altitude_steepness, t.altitude_growth, t.sun_middle, t.sun_width];
        let sky_view_mapping = FrameUniform::sky_view_mapping(f64::from(self.altitude) * 1000.0, params);
        Self { sun_first: t.sun_first, sun_span: t.sun_span, scales, sky_view_mapping, ..self }
    }
}

/// Texels of a case.
const CASE_TEXELS: usize = size_of::<Case>() / 16;
const _: () = assert!(CASE_TEXELS == generated::probe_luts::numbers::CASE_TEXELS as usize);
/// Cases in a row of the texture: it is then no wider than the 2048 texels that WebGL2 promises.
const ROW: usize = 146;

/// Most cases of one draw.
pub const BATCH: usize = ROW * 250;

/// A probe that was drawn and whose answers are on their way.
#[derive(Debug)]
pub struct Running {
    probe: Probe,
    count: usize,
    textures: [TextureId; 2],
    read: Ticket<ReadId>,
}

impl Running {
    /// Draws a probe over at most [`BATCH`] cases. Nothing stays on the backend but the compiled program.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn begin(backend: &mut dyn Backend, probe: Probe, cases: &[Case]) -> Result<Self> {
        let cases = &cases[..cases.len().min(BATCH)];
        let rows = cases.len().div_ceil(ROW).max(1);
        let size = |texels: usize| (ROW.min(cases.len().max(1)) * texels) as u32;
        let desc = |label, texels| TextureDesc::new(label, size(texels), rows as u32, Format::Rgba32Float);
        let input = backend.create_texture(&desc("probe cases", CASE_TEXELS))?;
        let output = backend.create_texture(&desc("probe answers", probe.answers()));
        let output = output.inspect_err(|_| backend.destroy_texture(input))?;
        let textures = [input, output];
        let read = Self::draw(backend, probe, cases, textures).inspect_err(|_| {
            for texture in textures {
                backend.destroy_texture(texture);
            }
        })?;
        Ok(Self { probe, count: cases.len(), textures, read })
    }

    fn draw(
        backend: &mut dyn Backend,
        probe: Probe,
        cases: &[Case],
        [input, output]: [TextureId; 2],
    ) -> Result<Ticket<ReadId>> {
        let desc = backend.texture(input);
        let mut texels: Vec<f32> = bytemuck::cast_slice(cases).to_vec();
        texels.resize(desc.map_or(0, |d| d.texels() * 4), 0.0);
        backend.write_texture(input, &texels)?;
        let program = Some(backend.create_program(probe.program())?);
        let inputs = Inputs::new([("cases", Some(input))]);
        let pass = Pass { program, inputs, ..Pass::clear("probe", Target::color(output)) };
        backend.run(&[pass])?;
        backend.begin_read(output)
    }

    /// The answers once they are there, [`Probe::answers`] pixels a case; does not wait.
    ///
    /// # Errors
    /// What the backend reports.
    pub fn poll(&self, backend: &mut dyn Backend) -> Result<Option<Vec<[f32; 4]>>> {
        let Some(texels) = backend.poll_read(&self.read)? else { return Ok(None) };
        for texture in self.textures {
            backend.destroy_texture(texture);
        }
        let mut pixels: Vec<[f32; 4]> = texels.as_chunks().0.to_vec();
        pixels.truncate(self.count * self.probe.answers());
        Ok(Some(pixels))
    }
}

/// [`Running::begin`] and [`Running::poll`] in one, for any number of cases, where waiting is possible.
///
/// # Errors
/// What the backend reports.
pub fn run(backend: &mut dyn Backend, probe: Probe, cases: &[Case]) -> Result<Vec<[f32; 4]>> {
    let mut answers = Vec::with_capacity(cases.len() * probe.answers());
    for batch in cases.chunks(BATCH) {
        let running = Running::begin(backend, probe, batch)?;
        backend.wait()?;
        let done = running.poll(backend)?;
        answers.extend(done.ok_or_else(|| crate::gpu::cannot_wait(backend.info().backend))?);
    }
    Ok(answers)
}
