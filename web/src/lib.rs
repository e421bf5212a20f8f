//! The wasm modules of the planet viewer in `web/`: one class, [`Viewer`], over one backend a module.
//!
//! The features `webgl` and `webgpu` say which backends a module can open. `scripts/build-web` builds one
//! module for each, so that a page downloads no more than it needs; a module with both works as well.
#![cfg(target_arch = "wasm32")]

#[cfg(not(any(feature = "webgl", feature = "webgpu")))]
compile_error!("a module needs a backend: build welkin-web with the feature `webgl` or `webgpu`");

mod args;
mod math;
#[cfg(feature = "probe")]
mod probe;
mod surface;
#[cfg(feature = "webgl")]
mod webgl;
#[cfg(feature = "webgpu")]
mod webgpu;

use std::cell::RefCell;
use std::rc::Rc;

use glam::DVec3;
use wasm_bindgen::prelude::*;

use welkin::model::airglow::Airglow;
use welkin::render::picture::{Drawn, PictureRenderer, PictureSettings};
use welkin::{
    AtmosphereParams, Bound, Camera, DepthConvention, Error, Frame, Look, Mode, Pose, Quality, Result, Scene,
    SkySettings, TerrainStyle, ToneMap, WarmUp,
};

use args::{canvas, flag, name, number, whole};
use surface::Surface;

/// A few kilobytes smaller than Rust's own, and as fast: a frame allocates nothing.
#[global_allocator]
static ALLOCATOR: rlsf::GlobalTlsf = rlsf::GlobalTlsf::new();

/// What a method of the module's classes returns to JavaScript.
type Answer<T> = std::result::Result<T, JsError>;

/// Prints a panic's message to the console, should there ever be one.
#[wasm_bindgen(start)]
pub fn start() {
    console_error_panic_hook::set_once();
}

/// A planet and its sky on a canvas.
#[wasm_bindgen]
pub struct Viewer {
    /// Shared with reads under way, which outlive the call that began them.
    canvas: Rc<RefCell<Box<dyn Surface>>>,
    picture: PictureRenderer,
    drawn: Option<Drawn>,
    /// What makes programs ahead, and for which air and settings.
    warm_up: Option<(AtmosphereParams, PictureSettings, WarmUp)>,
    settings: PictureSettings,
    params: AtmosphereParams,
    dry: bool,
    terrain: bool,
    airglow: bool,
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

#[wasm_bindgen]
impl Viewer {
    /// Opens `"webgl2"` or `"webgpu"` on a canvas; rejects with the reason if that cannot be had.
    pub async fn create(element: JsValue, backend: JsValue) -> Answer<Viewer> {
        let element = canvas(element)?;
        let size = [element.width().max(1), element.height().max(1)];
        let canvas = surface::open(element, &name(&backend)).await?;
        Ok(Viewer {
            canvas: Rc::new(RefCell::new(canvas)),
            picture: PictureRenderer::default(),
            drawn: None,
            warm_up: None,
            settings: PictureSettings::default(),
            params: AtmosphereParams::earth(),
            dry: false,
            terrain: true,
            airglow: true,
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
    pub fn set_planet(&mut self, planet: JsValue) -> Answer<()> {
        let planet = name(&planet);
        self.params = AtmosphereParams::preset(&planet)?;
        self.dry = !planet.starts_with("earth");
        Ok(())
    }

    /// Altitude above the ground in metres, the rest in degrees: pitch above the horizontal, heading from
    /// north to east, vertical field of view.
    pub fn set_camera(
        &mut self,
        altitude: JsValue,
        pitch: JsValue,
        heading: JsValue,
        fov: JsValue,
    ) -> Answer<()> {
        let altitude = number("camera.altitude", &altitude, 0.0, 1e12, "m")?;
        let pitch = number("camera.pitch", &pitch, -90.0, 90.0, "degrees")?.to_radians();
        let heading = number("camera.heading", &heading, -36000.0, 36000.0, "degrees")?.to_radians();
        let fov_y = number("camera.fov", &fov, 0.001, 170.0, "degrees")?.to_radians();
        self.pose = Pose { altitude, pitch, heading, fov_y };
        Ok(())
    }

    /// The sun's elevation and its azimuth from north to east, in degrees.
    pub fn set_sun(&mut self, elevation: JsValue, azimuth: JsValue) -> Answer<()> {
        let elevation = number("sun.elevation", &elevation, -90.0, 90.0, "degrees")?;
        let azimuth = number("sun.azimuth", &azimuth, -36000.0, 36000.0, "degrees")?;
        self.sun = (elevation.to_radians(), azimuth.to_radians());
        Ok(())
    }

    fn set_sky(&mut self, change: impl FnOnce(&mut SkySettings)) -> Answer<()> {
        let mut sky = self.settings.sky;
        change(&mut sky);
        sky.validate()?;
        self.settings.sky = sky;
        Ok(())
    }

    /// Single scattering with steps along the view ray (1 to 1024) and towards the sun (1 to 256).
    pub fn set_samples(&mut self, view: JsValue, light: JsValue) -> Answer<()> {
        let quality = Quality::March {
            view_samples: whole("view_samples", &view, 1024)?,
            light_samples: whole("light_samples", &light, 256)?,
        };
        self.set_sky(|s| s.quality = quality)
    }

    /// The modes' names.
    pub fn modes() -> Vec<String> {
        Mode::ALL.map(|mode| mode.name().to_owned()).into()
    }

    /// Which passes draw, as in a mode, by its name. The method stays: see `set_quality` and `set_samples`.
    pub fn set_mode(&mut self, mode: JsValue) -> Answer<()> {
        let composition = Mode::from_name(&name(&mode))?.composition();
        self.set_sky(|s| s.look.composition = composition)
    }

    /// The method in use and its numbers: `lut 100 × 100 × 32`.
    #[wasm_bindgen(getter)]
    pub fn method(&self) -> String {
        let quality = &self.settings.sky.quality;
        format!("{} {}", quality.method(), quality.numbers())
    }

    /// The presets' names, the cheapest of a method first.
    pub fn qualities() -> Vec<String> {
        Quality::PRESETS.iter().map(|(name, _)| (*name).to_owned()).collect()
    }

    /// Method and render scale of a preset, by its name.
    pub fn set_quality(&mut self, quality: JsValue) -> Answer<()> {
        let quality = Quality::from_name(&name(&quality))?;
        self.set_sky(|s| (s.quality, s.render_scale) = (quality, 1.0))
    }

    /// Turns the whole atmosphere on or off.
    pub fn set_enabled(&mut self, on: JsValue) -> Answer<()> {
        self.settings.sky.look.enabled = flag("enabled", &on)?;
        Ok(())
    }

    /// Whether the atmosphere is on.
    #[wasm_bindgen(getter)]
    pub fn enabled(&self) -> bool {
        self.settings.sky.look.enabled
    }

    /// Display units per unit of radiance.
    pub fn set_exposure(&mut self, exposure: JsValue) -> Answer<()> {
        self.settings.exposure = number("exposure", &exposure, 0.0, 1e9, "")?;
        Ok(())
    }

    /// `aces`, `agx` or `neutral`.
    pub fn set_tone_map(&mut self, tone_map: JsValue) -> Answer<()> {
        self.settings.tone_map = ToneMap::from_name(&name(&tone_map))?;
        Ok(())
    }

    /// Background resolution as a fraction of the canvas', 0.125 to 1.
    pub fn set_render_scale(&mut self, scale: JsValue) -> Answer<()> {
        let scale = number("render_scale", &scale, 0.125, 1.0, "")?;
        self.set_sky(|s| s.render_scale = scale)
    }

    /// Shows or hides the ground.
    pub fn set_terrain(&mut self, on: JsValue) -> Answer<()> {
        self.terrain = flag("terrain", &on)?;
        Ok(())
    }

    /// Turns the night sky's own light on or off; planets other than the Earth have none.
    pub fn set_airglow(&mut self, on: JsValue) -> Answer<()> {
        self.airglow = flag("airglow", &on)?;
        Ok(())
    }

    /// Follows the canvas to a new size in whole pixels.
    pub fn resize(&mut self, width: JsValue, height: JsValue) -> Answer<()> {
        let mut canvas = self.canvas.borrow_mut();
        let most = canvas.info().max_texture_size;
        self.size = [whole("canvas.width", &width, most)?, whole("canvas.height", &height, most)?];
        canvas.resize(self.size);
        Ok(())
    }

    /// What the view calls for: for each effect its name, `on` or `off`, and why.
    pub fn plan(&self) -> Answer<Vec<String>> {
        let bound = Some(Bound::eight_bit(self.settings.exposure));
        let look = Look { foreground: self.terrain, ..self.look() };
        let frame = Frame::new(&self.scene()?, &SkySettings { look, bound, ..self.settings.sky }, self.size)?;
        let state = |on| if on { "on" } else { "off" };
        Ok(frame
            .effects()
            .iter()
            .flat_map(|e| [e.name.into(), state(e.on).into(), e.reason.to_string()])
            .collect())
    }

    /// Draws a frame and shows it.
    pub fn render(&mut self) -> Answer<()> {
        let scene = self.scene()?;
        self.settings.terrain = self.style();
        self.settings.sky.look = self.look();
        self.settings.sky.bound = Some(Bound::eight_bit(self.settings.exposure));
        let mut canvas = self.canvas.borrow_mut();
        if let Some(reason) = canvas.lost() {
            return Err(Error::lost(canvas.info().backend, reason).into());
        }
        let Self { picture, settings, drawn, .. } = self;
        canvas.present(self.size, &mut |backend, canvas| {
            let (passes, result) = picture.passes_to(backend, &scene, settings, canvas)?;
            backend.run(passes)?;
            *drawn = Some(result);
            Ok(())
        })?;
        Ok(())
    }

    /// Makes one more program that other views of this planet call for, so that no frame waits for it;
    /// `false` once all are there. For moments in which the page has nothing else to do.
    pub fn warm_up(&mut self) -> Answer<bool> {
        // Exposure changes no program.
        let settings = PictureSettings { exposure: 1.0, terrain: self.style(), ..self.settings };
        let mut canvas = self.canvas.borrow_mut();
        let current =
            self.warm_up.take_if(|(params, made_for, _)| *params == self.params && *made_for == settings);
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
    pub fn read_pixels(&mut self) -> Answer<js_sys::Promise> {
        let drawn =
            self.drawn.ok_or_else(|| Error::invalid("read_pixels", "no frame", "called after render"))?;
        let read = self.canvas.borrow_mut().backend().begin_read(drawn.radiance)?;
        let canvas = self.canvas.clone();
        Ok(wasm_bindgen_futures::future_to_promise(async move {
            loop {
                let pixels = canvas.borrow_mut().backend().poll_read(&read).map_err(JsError::from)?;
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
        self.canvas.borrow_mut().lose();
    }

    fn look(&self) -> Look {
        Look { airglow: (self.airglow && !self.dry).then_some(Airglow::EARTH), ..self.settings.sky.look }
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
            ellipsoid: None,
        })
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        self.picture.destroy(self.canvas.borrow_mut().backend());
    }
}

/// Where the page stands: 15.2° south, 37.4° east in the planet's own axes, a coast of the demonstration
/// terrain.
fn place() -> DVec3 {
    let (latitude, longitude) = ((-15.2_f64).to_radians(), 37.4_f64.to_radians());
    DVec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin())
}
