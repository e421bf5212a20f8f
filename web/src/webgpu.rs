//! A canvas that WebGPU draws to.

use web_sys::HtmlCanvasElement;

use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{AdapterInfo, Backend, Format, TextureDesc, TextureId};
use welkin::{Error, Result};

use crate::surface::Surface;

struct WebGpu {
    backend: WgpuBackend,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
}

/// A device that can present to the canvas, with a backend on it.
///
/// # Errors
/// [`welkin::ErrorKind::Unavailable`] if the browser has no WebGPU, no adapter or no device.
pub async fn open(canvas: HtmlCanvasElement) -> Result<Box<dyn Surface>> {
    let unavailable = |reason: String| Error::unavailable("webgpu", reason);
    let (width, height) = (canvas.width().max(1), canvas.height().max(1));
    let instance = WgpuBackend::instance();
    let surface = instance
        .create_surface(wgpu::SurfaceTarget::Canvas(canvas))
        .map_err(|e| unavailable(format!("no WebGPU canvas: {e}")))?;
    let backend = WgpuBackend::new(&instance, Some(&surface)).await?;
    let config = wgpu::SurfaceConfiguration {
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        // A format that does not encode sRGB by itself: the tone-mapping pass does that.
        format: wgpu::TextureFormat::Rgba8Unorm,
        width,
        height,
        present_mode: wgpu::PresentMode::Fifo,
        desired_maximum_frame_latency: 2,
        alpha_mode: wgpu::CompositeAlphaMode::Opaque,
        view_formats: vec![],
        color_space: Default::default(),
    };
    surface.configure(backend.device(), &config);
    Ok(Box::new(WebGpu { backend, surface, config }))
}

impl Surface for WebGpu {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn info(&self) -> &AdapterInfo {
        self.backend.info()
    }

    fn lost(&mut self) -> Option<String> {
        self.backend.lost()
    }

    fn resize(&mut self, [width, height]: [u32; 2]) {
        (self.config.width, self.config.height) = (width, height);
        self.surface.configure(self.backend.device(), &self.config);
    }

    fn present(
        &mut self,
        _: [u32; 2],
        draw: &mut dyn FnMut(&mut dyn Backend, TextureId) -> Result<()>,
    ) -> Result<()> {
        let texture = match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(t) | wgpu::CurrentSurfaceTexture::Suboptimal(t) => t,
            other => {
                // Its own Debug tells of every kind of texture.
                let reason = match other {
                    wgpu::CurrentSurfaceTexture::Timeout => "Timeout",
                    wgpu::CurrentSurfaceTexture::Occluded => "Occluded",
                    wgpu::CurrentSurfaceTexture::Outdated => "Outdated",
                    wgpu::CurrentSurfaceTexture::Lost => "Lost",
                    _ => "Validation",
                };
                return Err(Error::driver("webgpu", "canvas", reason));
            }
        };
        let view = texture.texture.create_view(&Default::default());
        let desc = TextureDesc::new("canvas", self.config.width, self.config.height, Format::Rgba8);
        let id = self.backend.import_view(view, desc)?;
        let drawn = draw(&mut self.backend, id);
        self.backend.destroy_texture(id);
        drawn?;
        self.backend.queue().present(texture);
        Ok(())
    }

    fn lose(&mut self) {
        self.backend.device().destroy();
    }
}
