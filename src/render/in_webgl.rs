//! The short way with OpenGL: a frame around a scene of your own, in one call.

use super::picture::{PictureRenderer, PictureSettings};
use super::scene_air::SceneAir;
use super::sky_light::{KeptLight, SkyLight};
use crate::error::Result;
use crate::frame::Frame;
use crate::gpu::webgl::{Bindings, SharedContext, WebGlBackend};
use crate::gpu::{Backend, Format, RowOrder, TextureDesc, TextureId};
use crate::model::scene::Scene;

/// Clears, draws the sky, has you draw, lays the air before what you drew and maps tones: in your context,
/// whose state is as before afterwards.
///
/// ```no_run
/// # use welkin::{PictureSettings, Scene, WebGlSky};
/// # fn main_loop(gl: std::rc::Rc<glow::Context>, scene: Scene, draw_my_scene: impl Fn(&glow::Context),
/// #              swap_buffers: impl Fn()) -> welkin::Result<()> {
/// let mut sky = WebGlSky::new(gl.clone(), PictureSettings::default())?;
/// loop {
///     sky.draw(None, [1280, 720], &scene, |gl, _| draw_my_scene(gl))?;
///     swap_buffers();
/// }
/// # }
/// ```
///
/// Your scene sends linear radiance in the unit of
/// [`AtmosphereParams::sun_intensity`](crate::AtmosphereParams::sun_intensity) per steradian: a
/// matt surface `albedo / π × (sunlight × max(n · l, 0) + light of the sky)`, by
/// [`sunlight`](crate::model::sunlight::sunlight) and the frame's `light`. The ground is yours to draw: where
/// nothing is drawn below the horizon there is the air's light over black. OpenGL maps depth in its own way
/// unless `glClipControl` says otherwise: project with
/// [`Camera::projection_gl`](crate::Camera::projection_gl), or the air is laid at wrong distances.
///
/// **At night** the sky is darker than halves can hold (6e-8): where you expose by 1e4 or more, multiply
/// `sun_intensity`, and what your scene sends, by that, and expose by as much less.
pub struct WebGlSky {
    /// What is drawn and how; may be changed from frame to frame. Of
    /// [`terrain`](PictureSettings::terrain) nothing is drawn, and
    /// [`radiance`](PictureSettings::radiance) is in halves.
    pub settings: PictureSettings,
    backend: WebGlBackend,
    renderer: PictureRenderer,
    light: KeptLight,
    output: Option<Output>,
}

/// Where pictures went last.
#[derive(Clone, Copy)]
struct Output {
    framebuffer: Option<glow::Framebuffer>,
    size: [u32; 2],
    id: TextureId,
}

/// What you draw to between the sky and the air. The framebuffer is bound and the viewport set.
#[derive(Clone, Copy, Debug)]
pub struct WebGlFrame<'a> {
    /// Linear radiance in four halves, with the sky in it, and a depth buffer of 32-bit floats, cleared to
    /// [`DepthConvention::background`](crate::DepthConvention::background).
    pub framebuffer: Option<glow::Framebuffer>,
    /// Light for your scene, from the sky that is drawn. `None` until it was read, a frame or three after the
    /// medium's LUTs were made, as nothing waits for it; and for good where nothing makes them: in a march of
    /// single scattering, or before a first frame with sunlit air in sight. Shade with
    /// [`sunlight`](crate::model::sunlight::sunlight) alone then, or with a guess.
    pub light: Option<&'a SkyLight>,
    /// The air for your shaders, with [`Look::scene_shaders`](crate::Look::scene_shaders): set it in a
    /// program of yours by [`Bindings::set`]. It has [`Self::light`] in it, once that is there. What you draw
    /// before the air calls `welkin_sky` and `welkin_irradiance` and not `welkin_aerial`, or the air lies
    /// before it twice.
    pub air: Option<Bindings>,
    /// Which effects the frame has, and why.
    pub frame: &'a Frame,
}

impl WebGlSky {
    /// In your context, which must be current on this thread now and at every later call. `gl` is an `Rc`, an
    /// `Arc` or a `'static` reference: see [`SharedContext`].
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for settings that are out of range; [`crate::ErrorKind::Unavailable`] as
    /// for [`WebGlBackend::new`].
    pub fn new(gl: impl Into<SharedContext>, settings: PictureSettings) -> Result<Self> {
        settings.validate()?;
        let (renderer, light) = (PictureRenderer::default(), KeptLight::default());
        Ok(Self { settings, backend: WebGlBackend::new(gl)?, renderer, light, output: None })
    }

    /// Draws a whole frame to a framebuffer of yours (`None`: the default one) of so many pixels: `draw`
    /// draws your scene, with the projection that [`Scene::camera`] and [`Scene::depth`] stand for
    /// ([`Camera::projection_gl`](crate::Camera::projection_gl), unless you call `glClipControl`). Its colors
    /// have 8 bits, of no encoding of their own: values come out as a display wants them.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a scene, a setting or an output that cannot be drawn, before
    /// anything is drawn; errors of the context.
    pub fn draw(
        &mut self,
        framebuffer: Option<glow::Framebuffer>,
        size: [u32; 2],
        scene: &Scene,
        draw: impl FnOnce(&glow::Context, &WebGlFrame<'_>),
    ) -> Result<()> {
        type Nothing = fn(&glow::Context, &WebGlFrame<'_>);
        self.layers(framebuffer, size, scene, draw, None::<Nothing>)
    }

    /// As [`Self::draw`], with a second layer that you draw once the air lies before the first: glass, water,
    /// particles, which blend over the picture and lay the air before themselves
    /// ([`shaders::scene`](crate::shaders::scene)).
    ///
    /// # Errors
    /// As for [`Self::draw`].
    pub fn draw_layers(
        &mut self,
        framebuffer: Option<glow::Framebuffer>,
        size: [u32; 2],
        scene: &Scene,
        opaque: impl FnOnce(&glow::Context, &WebGlFrame<'_>),
        transparent: impl FnOnce(&glow::Context, &WebGlFrame<'_>),
    ) -> Result<()> {
        self.layers(framebuffer, size, scene, opaque, Some(transparent))
    }

    fn layers(
        &mut self,
        framebuffer: Option<glow::Framebuffer>,
        size: [u32; 2],
        scene: &Scene,
        opaque: impl FnOnce(&glow::Context, &WebGlFrame<'_>),
        transparent: Option<impl FnOnce(&glow::Context, &WebGlFrame<'_>)>,
    ) -> Result<()> {
        let display = self.output(framebuffer, size)?;
        let Self { settings, backend, renderer, light, .. } = self;
        light.step(backend, &scene.atmosphere, |b| renderer.begin_sky_light(b))?;
        let settings = PictureSettings { radiance: Format::Rgba16Float, ..*settings };
        let around = renderer.around(backend, scene, &settings, display)?;
        backend.run(around.before)?;
        let (light, frame) = (light.get(), around.frame);
        let air = around.air.map(|air| light.map_or(air, |light| air.with_light(light)));
        // Good for both layers: few passes run between them.
        let air = air.map(|air| backend.scene_air(&air)).transpose()?;
        backend.with_framebuffer(around.color, around.depth, |gl, framebuffer| {
            opaque(gl, &WebGlFrame { framebuffer, light, air, frame });
        })?;
        let Some(transparent) = transparent else { return backend.run(around.after) };
        backend.run(around.aerial)?;
        backend.with_framebuffer(around.radiance, around.depth, |gl, framebuffer| {
            transparent(gl, &WebGlFrame { framebuffer, light, air, frame });
        })?;
        backend.run(around.display)
    }

    /// The light of the sky for your scene, once it was read; see [`WebGlFrame::light`].
    pub fn light(&self) -> Option<&SkyLight> {
        self.light.get()
    }

    /// The backend, for what goes beyond this.
    pub fn backend(&mut self) -> &mut WebGlBackend {
        &mut self.backend
    }

    /// The framebuffer as a texture of the backend. Asking a context about it takes time, so that it is kept.
    fn output(&mut self, framebuffer: Option<glow::Framebuffer>, size: [u32; 2]) -> Result<TextureId> {
        if let Some(known) = self.output {
            if (known.framebuffer, known.size) == (framebuffer, size) {
                return Ok(known.id);
            }
            self.backend.destroy_texture(known.id);
            self.output = None;
        }
        let desc = TextureDesc::new("output", size[0], size[1], Format::Rgba8);
        let desc = TextureDesc { rows: RowOrder::BottomUp, ..desc };
        let id = self.backend.import_framebuffer(framebuffer, desc)?;
        self.output = Some(Output { framebuffer, size, id });
        Ok(id)
    }
}

impl WebGlBackend {
    /// A frame's air for a program of a scene's own that was made with
    /// [`shaders::scene::glsl`](crate::shaders::scene::glsl): [`Bindings::set`] sets it there.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`SceneAir::validate`]; [`crate::ErrorKind::Lost`].
    pub fn scene_air(&mut self, air: &SceneAir) -> Result<Bindings> {
        air.validate(self)?;
        let (inputs, block) = (air.textures(), air.block());
        self.bindings("scene air", SceneAir::PROGRAM, crate::shaders::scene::GLSL_BLOCK, &inputs, &block)
    }
}
