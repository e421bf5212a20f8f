//! A canvas with a backend that draws to it: one implementation a backend, chosen by the crate's features.

use web_sys::HtmlCanvasElement;

use welkin::error::{Error, Quoted, Result};
use welkin::gpu::{AdapterInfo, Backend, TextureId};

/// The backends that this module was built with.
pub const BACKENDS: &[&str] = &[
    #[cfg(feature = "webgl")]
    "webgl2",
    #[cfg(feature = "webgpu")]
    "webgpu",
];

/// A backend and how its picture gets to the canvas.
pub trait Surface {
    /// The machine that runs passes.
    fn backend(&mut self) -> &mut dyn Backend;

    /// The backend's adapter.
    fn info(&self) -> &AdapterInfo;

    /// The reason why the device or context is gone, if it is.
    fn lost(&mut self) -> Option<String>;

    /// Follows the canvas to a new size in pixels.
    fn resize(&mut self, size: [u32; 2]);

    /// Hands `draw` the canvas, of a size in pixels, as a texture to draw to, and shows what it drew.
    fn present(
        &mut self,
        size: [u32; 2],
        draw: &mut dyn FnMut(&mut dyn Backend, TextureId) -> Result<()>,
    ) -> Result<()>;

    /// Loses the device or the context on purpose, for tests.
    fn lose(&mut self);
}

/// Opens `"webgl2"` or `"webgpu"` on a canvas that has no context yet.
///
/// # Errors
/// [`welkin::ErrorKind::Invalid`] for a backend that this module was not built with;
/// [`welkin::ErrorKind::Unavailable`] with the reason if the browser does not have it.
pub async fn open(canvas: HtmlCanvasElement, backend: &str) -> Result<Box<dyn Surface>> {
    match backend {
        #[cfg(feature = "webgl")]
        "webgl2" => crate::webgl::open(&canvas),
        #[cfg(feature = "webgpu")]
        "webgpu" => crate::webgpu::open(canvas).await,
        other => Err(Error::invalid("backend", Quoted(other), BACKENDS.join(" or "))),
    }
}
