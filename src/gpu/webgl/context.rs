//! A context that the backend shares with whoever made it.

use std::any::Any;
use std::ops::Deref;
use std::ptr::NonNull;
use std::rc::Rc;
use std::sync::Arc;

/// An OpenGL context as the backend keeps it: made from an `Rc`, an `Arc` (egui's is one) or a `'static`
/// reference (to one that was leaked, say). It stands in for a reference to the context, and a clone of it
/// shares the context.
///
/// A reference of a shorter life will not do: a backend uses its context until it is dropped, and its type
/// says nothing of how long that may be.
///
/// ```no_run
/// # use welkin::{PictureSettings, WebGlSky};
/// # fn skies(egui: std::sync::Arc<glow::Context>, mine: glow::Context) -> welkin::Result<()> {
/// let sky = WebGlSky::new(egui.clone(), PictureSettings::default())?;
/// let leaked: &'static glow::Context = Box::leak(Box::new(mine));
/// let other = WebGlSky::new(leaked, PictureSettings::default())?;
/// # Ok(()) }
/// ```
// An enum of the three does the same without unsafe code, and makes the browser's module 190 to 650 bytes
// larger (scripts/build-web), as every use of the context then begins with a match; this, 20.
#[derive(Clone, Debug)]
pub struct SharedContext {
    context: NonNull<glow::Context>,
    /// Keeps the context where it is. `None`: nobody has to.
    _owner: Option<Rc<dyn Any>>,
}

impl Deref for SharedContext {
    type Target = glow::Context;

    fn deref(&self) -> &glow::Context {
        // SAFETY: it points into an `Rc` or `Arc` that this holds a share of, so that nobody moves, drops or
        // changes what is in it, or to what is there for good.
        unsafe { self.context.as_ref() }
    }
}

impl From<Rc<glow::Context>> for SharedContext {
    fn from(gl: Rc<glow::Context>) -> Self {
        Self { context: NonNull::from(&*gl), _owner: Some(gl) }
    }
}

impl From<Arc<glow::Context>> for SharedContext {
    fn from(gl: Arc<glow::Context>) -> Self {
        Self { context: NonNull::from(&*gl), _owner: Some(Rc::new(gl)) }
    }
}

impl From<&'static glow::Context> for SharedContext {
    fn from(gl: &'static glow::Context) -> Self {
        Self { context: NonNull::from(gl), _owner: None }
    }
}
