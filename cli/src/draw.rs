//! What the subcommands ask of a backend: a [`Shot`] in, a [`Picture`] out.

use anyhow::Context;
use clap::ValueEnum;
use welkin::gpu::Program;
use welkin::gpu::egl::Headless;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{AdapterInfo, Backend, Format, Inputs, Pass, PassTime, Target, TextureDesc, Uniform};
use welkin::shaders::copy;
use welkin::{Method, PictureRenderer, PictureSettings, SkySettings, TerrainStyle, ToneMap};

use crate::args::UsageError;

/// Which backend draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendChoice {
    /// The best that this machine has: webgpu, else webgl2, else cpu.
    Auto,
    /// Vulkan, through wgpu.
    #[value(name = "webgpu")]
    WebGpu,
    /// OpenGL ES 3, which is what WebGL2 is made of, through glow.
    #[value(name = "webgl2")]
    WebGl2,
    /// The f64 reference on all processor cores; slow, needs no driver.
    Cpu,
}

/// Everything that one picture depends on.
#[derive(Clone, Debug)]
pub struct Shot {
    /// Camera, planet, air and sun.
    pub scene: welkin::Scene,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Method and quality of the sky.
    pub sky: SkySettings,
    /// Radiance is multiplied by this before tone mapping.
    pub exposure: f32,
    /// The tone curve.
    pub tone_map: ToneMap,
    /// Noise of one step before display values are rounded.
    pub dither: bool,
    /// The ground; `None` leaves it out.
    pub terrain: Option<TerrainStyle>,
}

impl Shot {
    fn settings(&self) -> PictureSettings {
        PictureSettings {
            sky: self.sky,
            exposure: self.exposure.into(),
            tone_map: self.tone_map,
            dither: self.dither,
            terrain: self.terrain,
            radiance: Format::Rgba16Float,
        }
    }
}

/// A drawn [`Shot`].
#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Linear radiance before exposure, row 0 at the top.
    pub hdr: Vec<[f32; 4]>,
    /// sRGB after exposure and tone mapping, row 0 at the top.
    pub display: Vec<[u8; 4]>,
}

enum Machine {
    WebGpu(Box<WgpuBackend>),
    WebGl2(Box<Headless>),
    Cpu,
}

impl Machine {
    fn web_gpu() -> welkin::Result<Self> {
        Ok(Self::WebGpu(Box::new(WgpuBackend::headless()?)))
    }

    fn web_gl2() -> welkin::Result<Self> {
        Ok(Self::WebGl2(Box::new(Headless::new()?)))
    }

    /// Makes a context the current one: another drawer may have been opened since.
    fn take_over(&self) -> welkin::Result<()> {
        match self {
            Self::WebGl2(h) => h.make_current(),
            Self::WebGpu(_) | Self::Cpu => Ok(()),
        }
    }

    /// The GPU backend, if it is one.
    fn backend(&mut self) -> Option<&mut dyn Backend> {
        match self {
            Self::WebGpu(b) => Some(&mut **b),
            Self::WebGl2(h) => Some(&mut h.backend),
            Self::Cpu => None,
        }
    }
}

/// A backend that is ready to draw.
pub struct Drawer {
    machine: Machine,
    renderer: PictureRenderer,
    /// Why [`BackendChoice::Auto`] passed better ones over.
    passed_over: Vec<String>,
}

impl Drawer {
    /// Opens a backend; an error says why it cannot be had here. `Auto` always finds one.
    pub fn open(choice: BackendChoice) -> anyhow::Result<Self> {
        let mut passed_over = Vec::new();
        let machine = match choice {
            BackendChoice::WebGpu => Machine::web_gpu()?,
            BackendChoice::WebGl2 => Machine::web_gl2()?,
            BackendChoice::Cpu => Machine::Cpu,
            BackendChoice::Auto => [Machine::web_gpu, Machine::web_gl2]
                .into_iter()
                .find_map(|open| open().map_err(|e| passed_over.push(e.to_string())).ok())
                .unwrap_or(Machine::Cpu),
        };
        Ok(Self { machine, renderer: PictureRenderer::default(), passed_over })
    }

    /// Backend, adapter and timer, on one line; and what was passed over for it.
    pub fn describe(&self) -> String {
        let mut text = match &self.machine {
            Machine::WebGpu(b) => b.info().to_string(),
            Machine::WebGl2(h) => h.backend.info().to_string(),
            Machine::Cpu => {
                let threads = std::thread::available_parallelism().map_or(1, usize::from);
                format!("cpu: f64 reference, single scattering, {threads} threads")
            }
        };
        for reason in &self.passed_over {
            text += &format!(" (not {reason})");
        }
        text
    }

    /// The backend behind it; `None` for the CPU.
    pub fn backend(&mut self) -> Option<&mut dyn Backend> {
        self.machine.backend()
    }

    /// Makes this the drawer that [`Self::backend`] is used of: another may have been opened or used since.
    pub fn make_current(&self) -> anyhow::Result<()> {
        Ok(self.machine.take_over()?)
    }

    /// Draws one picture; `progress` is told the share that is done, 0 to 1.
    pub fn draw(&mut self, shot: &Shot, progress: &dyn Fn(f32)) -> anyhow::Result<Picture> {
        let (width, height) = (shot.width, shot.height);
        let settings = shot.settings();
        self.machine.take_over()?;
        let Some(backend) = self.machine.backend() else {
            let p = welkin::render::cpu_picture::render(&shot.scene, &settings, [width, height], progress)?;
            return Ok(Picture { width, height, hdr: p.radiance, display: p.display });
        };
        check_samples(backend.info(), &shot.sky.method)?;
        progress(0.0);
        let drawn = self.renderer.draw(backend, &shot.scene, &settings, [width, height]).context("draw")?;
        progress(0.5);
        let hdr = backend.read(drawn.radiance).context("read the radiance back")?;
        let display = backend.read(drawn.display).context("read the picture back")?;
        progress(1.0);
        Ok(Picture {
            width,
            height,
            hdr: hdr.as_chunks().0.iter().map(|p: &[f32; 4]| unscaled(*p, drawn.scale)).collect(),
            display: display.as_chunks().0.iter().map(|p: &[f32; 4]| p.map(|v| (v * 255.0).round() as u8)).collect(),
        })
    }

    /// The best of `repeat` times of each pass of a picture, and last of a plain full-screen copy of its
    /// radiance, all in the same run. `None` on the CPU, which has no passes.
    pub fn times(&mut self, shot: &Shot, repeat: u32) -> anyhow::Result<Option<Vec<PassTime>>> {
        self.machine.take_over()?;
        let Some(backend) = self.machine.backend() else { return Ok(None) };
        let size = [shot.width, shot.height];
        let (passes, drawn) = self.renderer.passes(backend, &shot.scene, &shot.settings(), size)?;
        let mut passes = passes.to_vec();
        let copy = backend.create_texture(&TextureDesc::new("copy", shot.width, shot.height, Format::Rgba16Float))?;
        passes.push(Pass {
            label: "copy",
            program: Some(backend.create_program(Program::new(&copy::INFO, 0))?),
            inputs: Inputs::new([("source", Some(drawn.radiance))]),
            uniform: Uniform::NONE,
            target: Target::color(copy),
            depth: Default::default(),
        });
        let mut best: Option<Vec<PassTime>> = None;
        // The first round makes pipelines and warms caches; it does not count.
        for round in 0..=repeat {
            let times = backend.times(&passes)?;
            match &mut best {
                _ if round == 0 => {}
                None => best = Some(times),
                Some(best) => {
                    for (b, t) in best.iter_mut().zip(times) {
                        b.nanoseconds = b.nanoseconds.min(t.nanoseconds);
                    }
                }
            }
        }
        backend.destroy_texture(copy);
        Ok(best)
    }
}

/// Radiance as it is without the scale that it was drawn with.
fn unscaled([r, g, b, a]: [f32; 4], scale: f64) -> [f32; 4] {
    let [r, g, b] = [r, g, b].map(|v| (f64::from(v) / scale) as f32);
    [r, g, b, a]
}

impl Drop for Drawer {
    fn drop(&mut self) {
        // A context that cannot be taken over frees what it holds when it goes.
        if self.machine.take_over().is_err() {
            return;
        }
        if let Some(backend) = self.machine.backend() {
            self.renderer.destroy(backend);
        }
    }
}

/// Refuses samples that an adapter is known to cut short without an error.
///
/// Mesa's llvmpipe counts the rounds of all of a pixel's loops together, each loop's last test included, and
/// stops at 65,535 (`LP_MAX_TGSI_LOOP_ITERATIONS`); pictures then come out dark.
pub fn check_samples(adapter: &AdapterInfo, method: &Method) -> Result<(), UsageError> {
    const MOST: u32 = 65_535;
    let Method::Single { view_samples: view, light_samples: light } = *method else { return Ok(()) };
    if !adapter.adapter.contains("llvmpipe") || view * (light + 2) < MOST {
        return Ok(());
    }
    Err(UsageError::new(format!(
        "'--samples {view}' and '--light-samples {light}' are too many for {}, which silently ends a shader's loops \
         after {MOST} rounds in all: samples × (light samples + 2) must be less",
        adapter.adapter
    )))
}

/// All backends that can be had here, the preferred one first. Never empty: the CPU is always there.
pub fn available() -> Vec<BackendChoice> {
    let gpus = [(BackendChoice::WebGpu, Machine::web_gpu as fn() -> _), (BackendChoice::WebGl2, Machine::web_gl2)];
    let mut found: Vec<_> = gpus.into_iter().filter(|(_, open)| open().is_ok()).map(|(choice, _)| choice).collect();
    found.push(BackendChoice::Cpu);
    found
}
