//! What the commands ask of a backend: a [`RenderRequest`] in, a [`Picture`] out.

use anyhow::Context;
use welkin::gpu::egl::Headless;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{AdapterInfo, Backend};
use welkin::{PictureRenderer, Quality};

use crate::args::backend::BackendChoice;
use crate::args::usage::UsageError;
use crate::picture::{Picture, RenderRequest};

enum Device {
    WebGpu(Box<WgpuBackend>),
    WebGl2(Box<Headless>),
    Cpu,
}

impl Device {
    fn web_gpu() -> welkin::Result<Self> {
        Ok(Self::WebGpu(Box::new(WgpuBackend::headless()?)))
    }

    fn web_gl2() -> welkin::Result<Self> {
        Ok(Self::WebGl2(Box::new(Headless::new()?)))
    }

    /// Makes a context the current one: another device may have been opened since.
    fn make_current(&self) -> welkin::Result<()> {
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

/// A backend that is ready to draw. Where no GPU driver is, the f64 reference on the CPU stands in.
pub struct Gpu {
    device: Device,
    renderer: PictureRenderer,
    /// Why [`BackendChoice::Auto`] passed better ones over.
    passed_over: Vec<String>,
}

impl Gpu {
    /// Opens a backend; an error says why it cannot be had here. `Auto` always finds one.
    pub fn open(choice: BackendChoice) -> anyhow::Result<Self> {
        let mut passed_over = Vec::new();
        let device = match choice {
            BackendChoice::WebGpu => Device::web_gpu()?,
            BackendChoice::WebGl2 => Device::web_gl2()?,
            BackendChoice::Cpu => Device::Cpu,
            BackendChoice::Auto => [Device::web_gpu, Device::web_gl2]
                .into_iter()
                .find_map(|open| open().map_err(|e| passed_over.push(e.to_string())).ok())
                .unwrap_or(Device::Cpu),
        };
        Ok(Self { device, renderer: PictureRenderer::default(), passed_over })
    }

    /// Backend, adapter and timer, on one line.
    pub fn adapter(&self) -> String {
        match &self.device {
            Device::WebGpu(b) => b.info().to_string(),
            Device::WebGl2(h) => h.backend.info().to_string(),
            Device::Cpu => {
                let threads = std::thread::available_parallelism().map_or(1, usize::from);
                format!("cpu: f64 reference, single scattering, {threads} threads")
            }
        }
    }

    /// Backend, adapter and timer, on one line; and what was passed over for it, with reasons.
    pub fn describe(&self) -> String {
        let mut text = self.adapter();
        for reason in &self.passed_over {
            text += &format!(" (not {reason})");
        }
        text
    }

    /// The backend behind it; `None` for the CPU.
    pub fn backend(&mut self) -> Option<&mut dyn Backend> {
        self.device.backend()
    }

    /// The backend behind it, current, with the renderer that [`Self::draw`] uses; `None` for the CPU.
    pub fn parts(&mut self) -> anyhow::Result<Option<(&mut dyn Backend, &mut PictureRenderer)>> {
        self.device.make_current()?;
        Ok(self.device.backend().map(|backend| (backend, &mut self.renderer)))
    }

    /// Draws one picture; `progress` hears the fraction that is done, 0 to 1.
    pub fn draw(&mut self, request: &RenderRequest, progress: &dyn Fn(f32)) -> anyhow::Result<Picture> {
        let (width, height) = (request.width, request.height);
        let settings = request.settings();
        let Some((backend, renderer)) = self.parts()? else {
            let p =
                welkin::render::cpu_picture::render(&request.scene, &settings, [width, height], progress)?;
            return Ok(Picture { width, height, hdr: p.radiance, display: p.display });
        };
        check_samples(backend.info(), &request.sky.quality)?;
        progress(0.0);
        let drawn = renderer.draw(backend, &request.scene, &settings, [width, height]).context("draw")?;
        progress(0.5);
        let hdr = backend.read(drawn.radiance).context("read the radiance back")?;
        let display = backend.read(drawn.display).context("read the picture back")?;
        progress(1.0);
        Ok(Picture {
            width,
            height,
            hdr: hdr.as_chunks().0.iter().map(|p: &[f32; 4]| unscaled(*p, drawn.scale)).collect(),
            display: display
                .as_chunks()
                .0
                .iter()
                .map(|p: &[f32; 4]| p.map(|v| (v * 255.0).round() as u8))
                .collect(),
        })
    }
}

/// Radiance as it is without the scale that it was drawn with.
fn unscaled([r, g, b, a]: [f32; 4], scale: f64) -> [f32; 4] {
    let [r, g, b] = [r, g, b].map(|v| (f64::from(v) / scale) as f32);
    [r, g, b, a]
}

impl Drop for Gpu {
    fn drop(&mut self) {
        // A context that cannot be made current frees what it holds when it goes.
        if let Ok(Some((backend, renderer))) = self.parts() {
            renderer.destroy(backend);
        }
    }
}

/// Refuses samples that an adapter is known to cut short without an error.
///
/// Mesa's llvmpipe counts the rounds of all of a pixel's loops together, each loop's last test included, and
/// stops at 65,535 (`LP_MAX_TGSI_LOOP_ITERATIONS`); pictures then come out dark.
pub fn check_samples(adapter: &AdapterInfo, method: &Quality) -> Result<(), UsageError> {
    const MOST: u32 = 65_535;
    let Quality::March { view_samples: view, light_samples: light } = *method else { return Ok(()) };
    if !adapter.adapter.contains("llvmpipe") || view * (light + 2) < MOST {
        return Ok(());
    }
    Err(UsageError::new(format!(
        "'--samples {view}' and '--light-samples {light}' are too many for {}, which silently ends a \
         shader's loops \
         after {MOST} rounds in all: samples × (light samples + 2) must be less",
        adapter.adapter
    )))
}

/// All backends that can be had here, the preferred one first: never empty, the CPU is always there. And the
/// names of those that cannot, with reasons.
pub fn available() -> (Vec<BackendChoice>, Vec<(&'static str, String)>) {
    let (mut there, mut missing) = (Vec::new(), Vec::new());
    for choice in BackendChoice::ALL {
        match Gpu::open(choice) {
            Ok(_) => there.push(choice),
            Err(why) => {
                let (name, why) = (choice.name(), format!("{why:#}"));
                let why = why.strip_prefix(name).and_then(|w| w.strip_prefix(": ")).unwrap_or(&why);
                missing.push((name, why.to_owned()));
            }
        }
    }
    (there, missing)
}
