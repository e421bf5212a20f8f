//! The wasm module of the planet viewer in `web/`: one class, `Viewer`, over either backend.

#[cfg(feature = "probe")]
mod probe;

use std::cell::RefCell;
use std::rc::Rc;

use glam::DVec3;
use wasm_bindgen::prelude::*;
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext};

use welkin::gpu::webgl::WebGlBackend;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, RowOrder, TextureDesc, TextureId};
use welkin::render::picture::{Drawn, PictureRenderer, PictureSettings};
use welkin::shaders::ToneMap;
use welkin::{
    AtmosphereParams, Bound, Camera, DepthConvention, EffectPlan, Error, Method, Mode, Pose, Quality, Result, Scene,
    SkySettings, TerrainStyle, WarmUp,
};

/// Prints a panic's message to the console, should there ever be one.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

/// A backend and how its picture gets to the canvas.
enum Canvas {
    WebGpu {
        backend: Box<WgpuBackend>,
        surface: wgpu::Surface<'static>,
        config: wgpu::SurfaceConfiguration,
        desc: TextureDesc,
    },
    WebGl2 {
        backend: WebGlBackend,
        context: WebGl2RenderingContext,
    },
}

impl Canvas {
    fn backend(&mut self) -> &mut dyn Backend {
        match self {
            Self::WebGpu { backend, .. } => &mut **backend,
            Self::WebGl2 { backend, .. } => backend,
        }
    }

    fn info(&self) -> &welkin::gpu::AdapterInfo {
        match self {
            Self::WebGpu { backend, .. } => backend.info(),
            Self::WebGl2 { backend, .. } => backend.info(),
        }
    }

    fn lost(&mut self) -> Option<String> {
        if let Self::WebGl2 { backend, context } = self
            && context.is_context_lost()
            && backend.lost().is_none()
        {
            backend.set_lost("the browser took the WebGL context away");
        }
        self.backend().lost()
    }

    fn resize(&mut self, width: u32, height: u32) -> Result<()> {
        if let Self::WebGpu { backend, surface, config, desc } = self {
            (config.width, config.height) = (width, height);
            (desc.width, desc.height) = (width, height);
            surface.configure(backend.device(), config);
        }
        Ok(())
    }

    /// Draws a picture straight to the canvas.
    fn draw(
        &mut self,
        picture: &mut PictureRenderer,
        scene: &Scene,
        settings: &PictureSettings,
        [width, height]: [u32; 2],
    ) -> Result<Drawn> {
        let mut run = |backend: &mut dyn Backend, canvas: TextureId| {
            let (passes, drawn) = picture.passes_to(backend, scene, settings, canvas)?;
            backend.run(passes)?;
            Ok(drawn)
        };
        match self {
            Self::WebGl2 { backend, .. } => {
                let desc = TextureDesc::new("canvas", width, height, Format::Rgba8);
                let id = backend.import_framebuffer(None, TextureDesc { rows: RowOrder::BottomUp, ..desc })?;
                let drawn = run(backend, id);
                backend.destroy_texture(id);
                drawn
            }
            Self::WebGpu { backend, surface, desc, .. } => {
                let texture = match surface.get_current_texture() {
                    wgpu::CurrentSurfaceTexture::Success(t) | wgpu::CurrentSurfaceTexture::Suboptimal(t) => t,
                    other => {
                        return Err(Error::Driver {
                            backend: "webgpu",
                            what: "canvas".into(),
                            reason: format!("{other:?}"),
                        });
                    }
                };
                let view = texture.texture.create_view(&Default::default());
                let id = backend.import_view(view, *desc)?;
                let drawn = run(&mut **backend, id);
                backend.destroy_texture(id);
                let drawn = drawn?;
                backend.queue().present(texture);
                Ok(drawn)
            }
        }
    }
}

async fn open_webgpu(canvas: HtmlCanvasElement) -> Result<Canvas> {
    let unavailable = |reason: String| Error::Unavailable { backend: "webgpu", reason };
    let (width, height) = (canvas.width().max(1), canvas.height().max(1));
    let instance = WgpuBackend::instance();
    let surface = instance
        .create_surface(wgpu::SurfaceTarget::Canvas(canvas))
        .map_err(|e| unavailable(format!("no WebGPU canvas: {e}")))?;
    let backend = Box::new(WgpuBackend::new(&instance, Some(&surface)).await?);
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
    let desc = TextureDesc::new("canvas", width, height, Format::Rgba8);
    Ok(Canvas::WebGpu { backend, surface, config, desc })
}

fn open_webgl2(canvas: &HtmlCanvasElement) -> Result<Canvas> {
    let unavailable = |reason: &str| Error::Unavailable { backend: "webgl2", reason: reason.into() };
    let options = js_sys::Object::new();
    for (key, value) in
        [("antialias", false), ("depth", false), ("stencil", false), ("alpha", false), ("preserveDrawingBuffer", true)]
    {
        let _ = js_sys::Reflect::set(&options, &key.into(), &value.into());
    }
    let context = canvas
        .get_context_with_context_options("webgl2", &options)
        .ok()
        .flatten()
        .and_then(|c| c.dyn_into::<WebGl2RenderingContext>().ok())
        .ok_or_else(|| unavailable("the browser gives no WebGL2 context"))?;
    let gl = glow::Context::from_webgl2_context(context.clone());
    let mut backend = WebGlBackend::own(Rc::new(gl))?;
    // UNMASKED_RENDERER_WEBGL: what draws, where the browser tells.
    if context.get_extension("WEBGL_debug_renderer_info").ok().flatten().is_some()
        && let Some(name) = context.get_parameter(0x9246).ok().and_then(|v| v.as_string())
    {
        backend.set_adapter_name(&name);
    }
    Ok(Canvas::WebGl2 { backend, context })
}

/// A planet and its sky on a canvas.
#[wasm_bindgen]
pub struct Viewer {
    /// Shared with reads under way, which outlive the call that began them.
    canvas: Rc<RefCell<Canvas>>,
    picture: PictureRenderer,
    drawn: Option<Drawn>,
    /// What makes programs ahead, and for which air and settings.
    warm_up: Option<(AtmosphereParams, PictureSettings, WarmUp)>,
    settings: PictureSettings,
    params: AtmosphereParams,
    dry: bool,
    terrain: bool,
    size: [u32; 2],
    pose: Pose,
    sun: (f64, f64),
}

/// Leaves the page to itself for a moment.
async fn pause() {
    let pause = js_sys::Promise::new(&mut |resolve, _| {
        if let Some(window) = web_sys::window() {
            let _ = window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, 1);
        }
    });
    let _ = wasm_bindgen_futures::JsFuture::from(pause).await;
}

fn whole(field: &str, value: f64, most: u32) -> Result<u32> {
    if value.fract() == 0.0 && (1.0..=f64::from(most)).contains(&value) {
        return Ok(value as u32);
    }
    Err(Error::invalid(field, value, format_args!("a whole number from 1 to {most}")))
}

fn check(field: &str, value: f64, lo: f64, hi: f64, unit: &str) -> Result<f64> {
    welkin::error::in_range(field, value, lo, hi, unit)
}

#[wasm_bindgen]
impl Viewer {
    /// Opens `"webgl2"` or `"webgpu"` on a canvas; rejects with the reason if that cannot be had.
    pub async fn create(canvas: HtmlCanvasElement, backend: String) -> std::result::Result<Viewer, JsError> {
        let size = [canvas.width().max(1), canvas.height().max(1)];
        let canvas = match backend.as_str() {
            "webgl2" => open_webgl2(&canvas)?,
            "webgpu" => open_webgpu(canvas).await?,
            other => return Err(Error::invalid("backend", format_args!("{other:?}"), "webgl2 or webgpu").into()),
        };
        Ok(Viewer {
            canvas: Rc::new(RefCell::new(canvas)),
            picture: PictureRenderer::default(),
            drawn: None,
            warm_up: None,
            settings: PictureSettings::default(),
            params: AtmosphereParams::earth(),
            dry: false,
            terrain: true,
            size,
            pose: Pose { altitude: 100.0, pitch: 0.0, heading: 0.0, fov_y: 1.0 },
            sun: (0.5, 0.0),
        })
    }

    /// `webgl2` or `webgpu`.
    #[wasm_bindgen(getter)]
    pub fn backend(&self) -> String {
        self.canvas.borrow().info().backend.into()
    }

    /// Backend, adapter, driver and timer in one line.
    pub fn describe(&self) -> String {
        self.canvas.borrow().info().to_string()
    }

    /// A preset by its name.
    pub fn set_planet(&mut self, name: &str) -> std::result::Result<(), JsError> {
        self.params = AtmosphereParams::preset(name)?;
        self.dry = !name.starts_with("earth");
        Ok(())
    }

    /// Metres and degrees; pitch above the horizontal, heading from north to east, vertical field of view.
    pub fn set_camera(
        &mut self,
        altitude: f64,
        pitch: f64,
        heading: f64,
        fov: f64,
    ) -> std::result::Result<(), JsError> {
        check("camera.altitude", altitude, 0.0, 1e12, "m")?;
        check("camera.pitch", pitch, -90.0, 90.0, "degrees")?;
        check("camera.heading", heading, -36000.0, 36000.0, "degrees")?;
        check("camera.fov", fov, 0.001, 170.0, "degrees")?;
        self.pose =
            Pose { altitude, pitch: pitch.to_radians(), heading: heading.to_radians(), fov_y: fov.to_radians() };
        Ok(())
    }

    /// Degrees; azimuth from north to east.
    pub fn set_sun(&mut self, elevation: f64, azimuth: f64) -> std::result::Result<(), JsError> {
        check("sun.elevation", elevation, -90.0, 90.0, "degrees")?;
        check("sun.azimuth", azimuth, -36000.0, 36000.0, "degrees")?;
        self.sun = (elevation.to_radians(), azimuth.to_radians());
        Ok(())
    }

    fn set_sky(&mut self, change: impl FnOnce(&mut SkySettings)) -> std::result::Result<(), JsError> {
        let mut sky = self.settings.sky;
        change(&mut sky);
        sky.validate()?;
        self.settings.sky = sky;
        Ok(())
    }

    /// Single scattering with steps along the view ray (1 to 1024) and towards the sun (1 to 256).
    pub fn set_samples(&mut self, view: f64, light: f64) -> std::result::Result<(), JsError> {
        let method = Method::Single {
            view_samples: whole("view_samples", view, 1024)?,
            light_samples: whole("light_samples", light, 256)?,
        };
        self.set_sky(|s| s.method = method)
    }

    /// The modes' names.
    pub fn modes() -> Vec<String> {
        Mode::ALL.map(|mode| mode.name().to_owned()).into()
    }

    /// Which passes draw, as in a mode, by its name. The method stays: see `set_quality` and `set_samples`.
    pub fn set_mode(&mut self, name: &str) -> std::result::Result<(), JsError> {
        let composition = Mode::from_name(name)?.settings().composition;
        self.set_sky(|s| s.composition = composition)
    }

    /// The method in use and its numbers: `lut 100 × 100 × 32`.
    #[wasm_bindgen(getter)]
    pub fn method(&self) -> String {
        self.settings.sky.method.to_string()
    }

    /// The presets' names, the cheapest of a method first.
    pub fn qualities() -> Vec<String> {
        Quality::ALL.iter().map(|q| q.name.to_owned()).collect()
    }

    /// Method and render scale of a preset, by its name.
    pub fn set_quality(&mut self, name: &str) -> std::result::Result<(), JsError> {
        let quality = Quality::from_name(name)?;
        self.set_sky(|s| (s.method, s.render_scale) = (quality.method, quality.render_scale))
    }

    /// Turns the whole atmosphere on or off.
    pub fn set_enabled(&mut self, on: bool) {
        self.settings.sky.enabled = on;
    }

    /// Whether the atmosphere is on.
    #[wasm_bindgen(getter)]
    pub fn enabled(&self) -> bool {
        self.settings.sky.enabled
    }

    /// Display units per unit of radiance.
    pub fn set_exposure(&mut self, exposure: f64) -> std::result::Result<(), JsError> {
        self.settings.exposure = check("exposure", exposure, 0.0, 1e9, "")?;
        Ok(())
    }

    /// `aces`, `agx` or `neutral`.
    pub fn set_tone_map(&mut self, name: &str) -> std::result::Result<(), JsError> {
        self.settings.tone_map = ToneMap::from_name(name)?;
        Ok(())
    }

    /// Background resolution as a share of the canvas', 0.125 to 1.
    pub fn set_render_scale(&mut self, scale: f64) -> std::result::Result<(), JsError> {
        self.set_sky(|s| s.render_scale = scale)
    }

    /// Shows or hides the ground.
    pub fn set_terrain(&mut self, on: bool) {
        self.terrain = on;
    }

    /// Follows the canvas; whole pixels.
    pub fn resize(&mut self, width: f64, height: f64) -> std::result::Result<(), JsError> {
        let mut canvas = self.canvas.borrow_mut();
        let most = canvas.info().max_texture_size;
        let size = [("canvas.width", width), ("canvas.height", height)];
        let [width, height] = size.map(|(name, v)| whole(name, v, most));
        self.size = [width?, height?];
        canvas.resize(self.size[0], self.size[1])?;
        Ok(())
    }

    /// What the view calls for: for each effect its name, `on` or `off`, and why.
    pub fn plan(&self) -> std::result::Result<Vec<String>, JsError> {
        let bound = Some(Bound::eight_bit(self.settings.exposure));
        let sky = SkySettings { foreground: self.terrain, bound, ..self.settings.sky };
        let plan = EffectPlan::new(&self.scene()?, &sky, self.size)?;
        let state = |on| if on { "on" } else { "off" };
        Ok(plan.effects().iter().flat_map(|e| [e.name.into(), state(e.on).into(), e.reason.to_string()]).collect())
    }

    /// Draws a frame and shows it.
    pub fn render(&mut self) -> std::result::Result<(), JsError> {
        let scene = self.scene()?;
        self.settings.terrain = self.style();
        self.settings.sky.bound = Some(Bound::eight_bit(self.settings.exposure));
        let mut canvas = self.canvas.borrow_mut();
        if let Some(reason) = canvas.lost() {
            return Err(Error::Lost { backend: canvas.info().backend, reason }.into());
        }
        self.drawn = Some(canvas.draw(&mut self.picture, &scene, &self.settings, self.size)?);
        Ok(())
    }

    /// Makes one more program that other views of this planet call for, so that no frame waits for it; `false` once all
    /// are there. For moments in which the page has nothing else to do.
    pub fn warm_up(&mut self) -> std::result::Result<bool, JsError> {
        // Exposure changes no program.
        let settings = PictureSettings { exposure: 1.0, terrain: self.style(), ..self.settings };
        let mut canvas = self.canvas.borrow_mut();
        let current = self.warm_up.take_if(|(params, made_for, _)| *params == self.params && *made_for == settings);
        if let Some((.., mut stale)) = self.warm_up.take() {
            stale.destroy(canvas.backend());
        }
        let (params, made_for, mut warm_up) = match current {
            Some(current) => current,
            None => (self.params.clone(), settings, WarmUp::picture(&self.scene()?, &settings)?),
        };
        let more = warm_up.step(canvas.backend())?;
        self.warm_up = Some((params, made_for, warm_up));
        Ok(more)
    }

    /// A promise of the last frame's radiance, RGBA, row 0 on top. The viewer may be used meanwhile.
    pub fn read_pixels(&mut self) -> std::result::Result<js_sys::Promise, JsError> {
        let drawn = self.drawn.ok_or_else(|| Error::invalid("read_pixels", "no frame", "called after render"))?;
        let read = self.canvas.borrow_mut().backend().begin_read(drawn.radiance)?;
        let canvas = self.canvas.clone();
        Ok(wasm_bindgen_futures::future_to_promise(async move {
            loop {
                let pixels = canvas.borrow_mut().backend().poll_read(read).map_err(JsError::from)?;
                if let Some(mut pixels) = pixels {
                    // A power of two: nothing is rounded.
                    let scale = (1.0 / drawn.scale) as f32;
                    pixels.chunks_exact_mut(4).for_each(|p| p[..3].iter_mut().for_each(|v| *v *= scale));
                    return Ok(js_sys::Float32Array::from(&pixels[..]).into());
                }
                pause().await;
            }
        }))
    }

    /// Why the device or context is gone, if it is.
    pub fn lost(&mut self) -> Option<String> {
        self.canvas.borrow_mut().lost()
    }

    /// For tests: loses the device or the context on purpose.
    pub fn lose(&mut self) {
        match &*self.canvas.borrow() {
            Canvas::WebGpu { backend, .. } => backend.device().destroy(),
            Canvas::WebGl2 { context, .. } => {
                let extension = context.get_extension("WEBGL_lose_context").ok().flatten();
                let lose = extension.and_then(|e| js_sys::Reflect::get(&e, &"loseContext".into()).ok().map(|f| (e, f)));
                if let Some((extension, function)) = lose
                    && let Ok(function) = function.dyn_into::<js_sys::Function>()
                {
                    let _ = function.call0(&extension);
                }
            }
        }
    }

    fn style(&self) -> Option<TerrainStyle> {
        self.terrain.then(|| if self.dry { TerrainStyle::dry(&self.params) } else { TerrainStyle::earth() })
    }

    fn scene(&self) -> Result<Scene> {
        let (zenith, north) = (place(), DVec3::Z);
        let center = DVec3::ZERO;
        let aspect = f64::from(self.size[0]) / f64::from(self.size[1]);
        let mut pose = self.pose;
        if let Some(style) = self.style() {
            // Altitude counts from the ground under the camera, so that nobody stands inside a hill.
            pose.altitude += style.height(zenith, self.params.planet_radius).0;
        }
        let camera = Camera::above(center, self.params.planet_radius, zenith, north, pose, aspect)?;
        let (east, up) = (north.cross(zenith).normalize(), zenith);
        let flat = up.cross(east) * self.sun.1.cos() + east * self.sun.1.sin();
        let sun_direction = flat * self.sun.0.cos() + up * self.sun.0.sin();
        Ok(Scene {
            camera,
            planet_center: center,
            atmosphere: self.params.clone(),
            sun_direction,
            depth: DepthConvention::default(),
            moon: None,
        })
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        self.picture.destroy(self.canvas.borrow_mut().backend());
    }
}

/// Where the page stands: 15.2° south, 37.4° east in the planet's own axes, a coast of the demonstration terrain.
fn place() -> DVec3 {
    let (latitude, longitude) = ((-15.2_f64).to_radians(), 37.4_f64.to_radians());
    DVec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin())
}
