//! A window-less OpenGL ES 3 context through EGL, for tests and the command line. Linux.
#![allow(unsafe_code)] // Loading a system library and calling EGL; see the reason at each block.

use std::ptr::{null, null_mut};
use std::rc::Rc;
use std::sync::{Mutex, OnceLock, PoisonError};

use khronos_egl as egl;

use super::webgl::WebGlBackend;
use crate::error::{Error, Result};

const PLATFORM_SURFACELESS_MESA: egl::Enum = 0x31DD;
const PLATFORM_DEVICE_EXT: egl::Enum = 0x313F;

type Egl = egl::DynamicInstance<egl::EGL1_5>;

/// A context current on the thread that made it, and its backend.
pub struct Headless {
    /// Draws; dropped before the context.
    pub backend: WebGlBackend,
    context: Context,
}

struct Context {
    egl: &'static Egl,
    api: Api,
    display: egl::Display,
    context: egl::Context,
}

/// Which of a display's APIs a context is of.
#[derive(Clone, Copy)]
enum Api {
    Es,
    Desktop,
}

impl Api {
    /// Name, number, the bit of configurations, and what a context of it is asked for.
    fn parts(self) -> (&'static str, egl::Enum, egl::Int, &'static [egl::Int]) {
        match self {
            Self::Es => (
                "OpenGL ES",
                egl::OPENGL_ES_API,
                egl::OPENGL_ES3_BIT,
                &[egl::CONTEXT_MAJOR_VERSION, 3, egl::CONTEXT_MINOR_VERSION, 0, egl::NONE],
            ),
            Self::Desktop => (
                "OpenGL",
                egl::OPENGL_API,
                egl::OPENGL_BIT,
                &[
                    egl::CONTEXT_MAJOR_VERSION,
                    3,
                    egl::CONTEXT_MINOR_VERSION,
                    3,
                    egl::CONTEXT_OPENGL_PROFILE_MASK,
                    egl::CONTEXT_OPENGL_CORE_PROFILE_BIT,
                    egl::NONE,
                ],
            ),
        }
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        let _ = self.egl.bind_api(self.api.parts().1);
        // The display is shared by every context of the process: it is not terminated.
        if self.egl.get_current_context() == Some(self.context) {
            let _ = self.egl.make_current(self.display, None, None, None);
        }
        let _ = self.egl.destroy_context(self.display, self.context);
    }
}

impl Drop for Headless {
    fn drop(&mut self) {
        // The backend deletes its objects in its own context.
        let _ = self.make_current();
    }
}

impl Headless {
    /// Makes this context the thread's current one, as [`Self::new`] leaves it: to be called before drawing
    /// wherever a thread has several.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Driver`] with what EGL answers.
    pub fn make_current(&self) -> Result<()> {
        let Context { egl, api, display, context } = &self.context;
        egl.bind_api(api.parts().1).map_err(|e| Error::driver("webgl2", "bind the API", e.to_string()))?;
        egl.make_current(*display, None, None, Some(*context))
            .map_err(|e| Error::driver("webgl2", "make current", e.to_string()))
    }

    /// Opens a surfaceless context: on the first EGL device that has ES 3 (a GPU, if its driver is
    /// installed), else through Mesa's surfaceless platform.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] with what each attempt answered.
    pub fn new() -> Result<Self> {
        Self::with_api(Api::Es)
    }

    /// As [`Self::new`], with OpenGL (3.3, core) instead of OpenGL ES: what programs on desktops have.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] with what each attempt answered.
    pub fn desktop() -> Result<Self> {
        Self::with_api(Api::Desktop)
    }

    fn with_api(api: Api) -> Result<Self> {
        let mut answers = Vec::new();
        for platform in [PLATFORM_DEVICE_EXT, PLATFORM_SURFACELESS_MESA] {
            match Self::open(platform, api) {
                Ok(made) => return Ok(made),
                Err(e) => answers.push(e),
            }
        }
        Err(Error::unavailable("webgl2", answers.join("; ")))
    }

    fn open(platform: egl::Enum, api: Api) -> Result<Self, String> {
        let text = |what: &str, e: &dyn std::fmt::Display| format!("{what}: {e}");
        let egl = egl()?;
        let display = display(egl, platform)?;
        let (name, number, bit, version) = api.parts();
        egl.bind_api(number).map_err(|e| text(name, &e))?;
        let wanted = [egl::SURFACE_TYPE, egl::PBUFFER_BIT, egl::RENDERABLE_TYPE, bit, egl::NONE];
        let config = egl
            .choose_first_config(display, &wanted)
            .map_err(|e| text("config", &e))?
            .ok_or_else(|| format!("no configuration with {name} 3"))?;
        let context = egl.create_context(display, config, None, version).map_err(|e| text("context", &e))?;
        let holder = Context { egl, api, display, context };
        holder.egl.make_current(display, None, None, Some(context)).map_err(|e| text("make current", &e))?;
        // SAFETY: the context is current, so the functions that EGL names are its own.
        let gl = unsafe {
            glow::Context::from_loader_function(|name| {
                holder.egl.get_proc_address(name).map_or(null(), |p| p as *const _)
            })
        };
        let backend = WebGlBackend::own(Rc::new(gl)).map_err(|e| e.to_string())?;
        Ok(Self { backend, context: holder })
    }
}

/// The system's EGL. It stays loaded: drivers keep threads and thread-local data that do not survive being
/// unloaded and loaded again.
fn egl() -> Result<&'static Egl, String> {
    static LOADED: OnceLock<Result<Egl, String>> = OnceLock::new();
    let load = || {
        // SAFETY: the system's EGL loader; its initialisers have no preconditions.
        let library =
            unsafe { libloading::Library::new("libEGL.so.1") }.map_err(|e| format!("libEGL.so.1: {e}"))?;
        // SAFETY: symbols are looked up by their standard names.
        unsafe { Egl::load_required_from(library) }.map_err(|e| format!("EGL 1.5: {e}"))
    };
    LOADED.get_or_init(load).as_ref().map_err(Clone::clone)
}

/// A display that was initialised; it stays so until the process ends.
struct Initialised {
    platform: egl::Enum,
    display: egl::Display,
}

// SAFETY: EGL handles belong to the process, and its functions may be called from any thread (EGL 1.5, 2.2).
unsafe impl Send for Initialised {}

/// A platform's display. All contexts of a process share one: EGL gives the same handle again, and what one
/// caller initialises or terminates is so for all (EGL 1.5, 3.2).
fn display(egl: &Egl, platform: egl::Enum) -> Result<egl::Display, String> {
    static INITIALISED: Mutex<Vec<Initialised>> = Mutex::new(Vec::new());
    let mut initialised = INITIALISED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = initialised.iter().find(|i| i.platform == platform) {
        return Ok(found.display);
    }
    let native = if platform == PLATFORM_DEVICE_EXT { first_device(egl)? } else { null_mut() };
    // SAFETY: `native` is a device that EGL named, or null as the surfaceless platform wants it.
    let display = unsafe { egl.get_platform_display(platform, native, &[egl::ATTRIB_NONE]) }
        .map_err(|e| format!("display: {e}"))?;
    egl.initialize(display).map_err(|e| format!("initialise: {e}"))?;
    initialised.push(Initialised { platform, display });
    Ok(display)
}

/// The first device of `EGL_EXT_device_enumeration`.
fn first_device(egl: &Egl) -> Result<*mut std::ffi::c_void, String> {
    type QueryDevices =
        unsafe extern "system" fn(egl::Int, *mut *mut std::ffi::c_void, *mut egl::Int) -> egl::Boolean;
    let query = egl.get_proc_address("eglQueryDevicesEXT").ok_or("EGL_EXT_device_enumeration is missing")?;
    // SAFETY: the extension's function has this signature.
    let query: QueryDevices = unsafe { std::mem::transmute(query) };
    let mut device = null_mut();
    let mut count = 0;
    // SAFETY: room for one device, and a count to write.
    let ok = unsafe { query(1, &mut device, &mut count) };
    if ok == egl::TRUE && count > 0 { Ok(device) } else { Err("no EGL device".into()) }
}
