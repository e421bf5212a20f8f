//! A canvas that WebGL2 draws to.

use std::rc::Rc;

use wasm_bindgen::JsCast;
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext};

use welkin::gpu::webgl::WebGlBackend;
use welkin::gpu::{AdapterInfo, Backend, Format, RowOrder, TextureDesc, TextureId};
use welkin::{Error, Result};

use crate::surface::Surface;

struct WebGl {
    backend: WebGlBackend,
    context: WebGl2RenderingContext,
}

/// The canvas' WebGL2 context with a backend on it.
///
/// # Errors
/// [`welkin::ErrorKind::Unavailable`] if the browser gives no context, or one that cannot draw to float
/// textures.
pub fn open(canvas: &HtmlCanvasElement) -> Result<Box<dyn Surface>> {
    let options = js_sys::Object::new();
    for (key, value) in [
        ("antialias", false),
        ("depth", false),
        ("stencil", false),
        ("alpha", false),
        ("preserveDrawingBuffer", true),
    ] {
        let _ = js_sys::Reflect::set(&options, &key.into(), &value.into());
    }
    let context = canvas
        .get_context_with_context_options("webgl2", &options)
        .ok()
        .flatten()
        .and_then(|c| c.dyn_into::<WebGl2RenderingContext>().ok())
        .ok_or_else(|| Error::unavailable("webgl2", "the browser gives no WebGL2 context"))?;
    let gl = glow::Context::from_webgl2_context(context.clone());
    let mut backend = WebGlBackend::own(Rc::new(gl))?;
    // UNMASKED_RENDERER_WEBGL: what draws, where the browser tells.
    if context.get_extension("WEBGL_debug_renderer_info").ok().flatten().is_some()
        && let Some(name) = context.get_parameter(0x9246).ok().and_then(|v| v.as_string())
    {
        backend.set_adapter_name(&name);
    }
    Ok(Box::new(WebGl { backend, context }))
}

impl Surface for WebGl {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn info(&self) -> &AdapterInfo {
        self.backend.info()
    }

    fn lost(&mut self) -> Option<String> {
        if self.context.is_context_lost() && self.backend.lost().is_none() {
            self.backend.set_lost("the browser took the WebGL context away");
        }
        self.backend.lost()
    }

    fn resize(&mut self, _: [u32; 2]) {}

    fn present(
        &mut self,
        [width, height]: [u32; 2],
        draw: &mut dyn FnMut(&mut dyn Backend, TextureId) -> Result<()>,
    ) -> Result<()> {
        let desc = TextureDesc::new("canvas", width, height, Format::Rgba8);
        let id = self.backend.import_framebuffer(None, TextureDesc { rows: RowOrder::BottomUp, ..desc })?;
        let drawn = draw(&mut self.backend, id);
        self.backend.destroy_texture(id);
        drawn
    }

    fn lose(&mut self) {
        let extension = self.context.get_extension("WEBGL_lose_context").ok().flatten();
        let lose =
            extension.and_then(|e| js_sys::Reflect::get(&e, &"loseContext".into()).ok().map(|f| (e, f)));
        if let Some((extension, function)) = lose
            && let Ok(function) = function.dyn_into::<js_sys::Function>()
        {
            let _ = function.call0(&extension);
        }
    }
}
