//! The short way with wgpu: a frame around a scene of your own, in one call.

use super::picture::{PictureRenderer, PictureSettings};
use super::scene_air::SceneAir;
use super::sky_light::{KeptLight, SkyLight};
use crate::error::{Error, Result};
use crate::frame::Frame;
use crate::gpu::wgpu::WgpuBackend;
use crate::gpu::{Backend, Format, TextureDesc};
use crate::model::scene::Scene;

/// Clears, draws the sky, has you draw, lays the air before what you drew and maps tones: on your device, in
/// your encoder.
///
/// ```no_run
/// # use welkin::{PictureSettings, Scene, WgpuSky};
/// # fn main_loop(device: wgpu::Device, queue: wgpu::Queue, surface: wgpu::Surface, scene: Scene,
/// #              my_pipeline: wgpu::RenderPipeline) -> welkin::Result<()> {
/// let mut sky = WgpuSky::new(&device, &queue, PictureSettings::default())?;
/// loop {
/// #   let wgpu::CurrentSurfaceTexture::Success(picture) = surface.get_current_texture() else { break };
///     let view = picture.texture.create_view(&Default::default());
///     let mut encoder = device.create_command_encoder(&Default::default());
///     sky.draw(&mut encoder, &view, &scene, |encoder, frame| {
///         // WgpuSky::COLOR with the sky in it, and WgpuSky::DEPTH, cleared.
///         let mut pass = frame.begin(encoder);
///         pass.set_pipeline(&my_pipeline);
///         pass.draw(0..3, 0..1);
///     })?;
///     queue.submit([encoder.finish()]);
///     queue.present(picture);
/// }
/// # Ok(()) }
/// ```
///
/// Your scene sends linear radiance in the unit of
/// [`AtmosphereParams::sun_intensity`](crate::AtmosphereParams::sun_intensity) per steradian: a
/// matt surface `albedo / π × (sunlight × max(n · l, 0) + light of the sky)`, by
/// [`sunlight`](crate::model::sunlight::sunlight) and the frame's `light`. The ground is yours to draw: where
/// nothing is drawn below the horizon there is the air's light over black.
///
/// **At night** the sky is darker than halves can hold (6e-8): where you expose by 1e4 or more, multiply
/// `sun_intensity`, and what your scene sends, by that, and expose by as much less.
pub struct WgpuSky {
    /// What is drawn and how; may be changed from frame to frame. Of
    /// [`terrain`](PictureSettings::terrain) nothing is drawn, and
    /// [`radiance`](PictureSettings::radiance) is [`Self::COLOR`].
    pub settings: PictureSettings,
    backend: WgpuBackend,
    renderer: PictureRenderer,
    light: KeptLight,
}

/// What you draw to between the sky and the air.
#[derive(Clone, Copy, Debug)]
pub struct WgpuFrame<'a> {
    /// Linear radiance, format [`WgpuSky::COLOR`], one sample a pixel; the sky is in it.
    pub color: &'a wgpu::TextureView,
    /// Depth, format [`WgpuSky::DEPTH`], cleared to [`DepthConvention::background`](crate::DepthConvention).
    pub depth: &'a wgpu::TextureView,
    /// Light for your scene, from the sky that is drawn. `None` until it was read, a frame or three after the
    /// medium's LUTs were made, as nothing waits for it; and for good where nothing makes them: in a march of
    /// single scattering, or before a first frame with sunlit air in sight. Shade with
    /// [`sunlight`](crate::model::sunlight::sunlight) alone then, or with a guess.
    pub light: Option<&'a SkyLight>,
    /// The air for your shaders, with [`Look::scene_shaders`](crate::Look::scene_shaders): bind it with
    /// [`AirGroup::bind`]. It has [`Self::light`] in it, once that is there. What you draw before the air
    /// calls `welkin_sky` and `welkin_irradiance` and not `welkin_aerial`, or the air lies before it twice.
    pub air: Option<&'a AirGroup>,
    /// Which effects the frame has, and why.
    pub frame: &'a Frame,
}

/// The air for a scene's own shaders: a bind group with the layout of [`WgpuBackend::air_layout`], for passes
/// in the encoder that it was made for. In another frame it holds another frame's air, or nothing.
#[derive(Clone, Debug)]
#[must_use = "a pipeline that reads the air has none without it"]
pub struct AirGroup {
    /// The group.
    pub group: wgpu::BindGroup,
    /// Its dynamic offset.
    pub offset: u32,
}

impl AirGroup {
    /// Binds it, as the group of a number that the shader was made with
    /// ([`shaders::scene::wgsl`](crate::shaders::scene::wgsl)).
    pub fn bind(&self, pass: &mut wgpu::RenderPass<'_>, group: u32) {
        pass.set_bind_group(group, &self.group, &[self.offset]);
    }

    /// The same in a render bundle, which is good for that encoder's pass alone.
    pub fn bind_in_bundle<'a>(&'a self, bundle: &mut wgpu::RenderBundleEncoder<'a>, group: u32) {
        bundle.set_bind_group(group, &self.group, &[self.offset]);
    }
}

impl WgpuFrame<'_> {
    /// Begins a render pass that draws over the sky.
    pub fn begin<'e>(&self, encoder: &'e mut wgpu::CommandEncoder) -> wgpu::RenderPass<'e> {
        let store = wgpu::StoreOp::Store;
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: self.color,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Load, store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: self.depth,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Load, store }),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }
}

impl WgpuSky {
    /// Format of the radiance that your scene is drawn to.
    pub const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
    /// Format of the depth buffer that your scene is drawn with.
    pub const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

    /// On your device. See [`WgpuBackend::from_device`] for features that make it better.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for settings that are out of range.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, settings: PictureSettings) -> Result<Self> {
        settings.validate()?;
        let backend = WgpuBackend::from_device(device.clone(), queue.clone(), "the user's device")?;
        let (renderer, light) = (PictureRenderer::default(), KeptLight::default());
        Ok(Self { settings, backend, renderer, light })
    }

    /// Records a whole frame into your encoder: `draw` draws your scene, with the projection that
    /// [`Scene::camera`] and [`Scene::depth`] stand for ([`Camera::projection`](crate::Camera::projection)).
    ///
    /// `output`: where the picture goes, for instance a view of the surface's texture: all of it is drawn.
    /// Its format is `Rgba8Unorm`, `Bgra8Unorm` or one of floats, not an sRGB format: values come out as a
    /// display wants them. Of a surface that is `Bgra8UnormSrgb`, name `Bgra8Unorm` among its `view_formats`
    /// and make a view of that format. Submit encoders in the order in which they were recorded.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a scene, a setting or an output that cannot be drawn, before
    /// anything is recorded; errors of the device.
    pub fn draw(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        output: &wgpu::TextureView,
        scene: &Scene,
        draw: impl FnOnce(&mut wgpu::CommandEncoder, &WgpuFrame<'_>),
    ) -> Result<()> {
        type Nothing = fn(&mut wgpu::CommandEncoder, &WgpuFrame<'_>);
        self.layers(encoder, output, scene, draw, None::<Nothing>)
    }

    /// As [`Self::draw`], with a second layer that you draw once the air lies before the first: glass, water,
    /// particles, which blend over the picture and lay the air before themselves
    /// ([`shaders::scene`](crate::shaders::scene)).
    ///
    /// # Errors
    /// As for [`Self::draw`].
    pub fn draw_layers(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        output: &wgpu::TextureView,
        scene: &Scene,
        opaque: impl FnOnce(&mut wgpu::CommandEncoder, &WgpuFrame<'_>),
        transparent: impl FnOnce(&mut wgpu::CommandEncoder, &WgpuFrame<'_>),
    ) -> Result<()> {
        self.layers(encoder, output, scene, opaque, Some(transparent))
    }

    fn layers(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        output: &wgpu::TextureView,
        scene: &Scene,
        opaque: impl FnOnce(&mut wgpu::CommandEncoder, &WgpuFrame<'_>),
        transparent: Option<impl FnOnce(&mut wgpu::CommandEncoder, &WgpuFrame<'_>)>,
    ) -> Result<()> {
        let Self { settings, backend, renderer, light } = self;
        light.step(backend, &scene.atmosphere, |b| renderer.begin_sky_light(b))?;
        let display = backend.import_output(output)?;
        let settings = PictureSettings { radiance: Format::Rgba16Float, ..*settings };
        let drawn = (|| {
            let around = renderer.around(backend, scene, &settings, display)?;
            backend.encode(encoder, around.before)?;
            let view = |b: &WgpuBackend, id| {
                b.view(id).cloned().ok_or_else(|| Error::invalid("view", "none", "one"))
            };
            let (color, depth) = (view(backend, around.color)?, view(backend, around.depth)?);
            let air = around.air.map(|air| light.get().map_or(air, |light| air.with_light(light)));
            let air = air.map(|air| backend.air_group(encoder, &air)).transpose()?;
            let (light, air, frame) = (light.get(), air.as_ref(), around.frame);
            opaque(encoder, &WgpuFrame { color: &color, depth: &depth, light, air, frame });
            let Some(transparent) = transparent else { return backend.encode(encoder, around.after) };
            backend.encode(encoder, around.aerial)?;
            let color = view(backend, around.radiance)?;
            transparent(encoder, &WgpuFrame { color: &color, depth: &depth, light, air, frame });
            backend.encode(encoder, around.display)
        })();
        backend.destroy_texture(display);
        drawn
    }

    /// The light of the sky for your scene, once it was read; see [`WgpuFrame::light`].
    pub fn light(&self) -> Option<&SkyLight> {
        self.light.get()
    }

    /// The backend, for what goes beyond this.
    pub fn backend(&mut self) -> &mut WgpuBackend {
        &mut self.backend
    }
}

impl WgpuBackend {
    /// The layout of the bind group that a scene's own shaders read the air from: see
    /// [`shaders::scene`](crate::shaders::scene).
    ///
    /// # Errors
    /// [`crate::ErrorKind::Lost`].
    pub fn air_layout(&mut self) -> Result<wgpu::BindGroupLayout> {
        self.layout(SceneAir::PROGRAM)
    }

    /// A frame's air for a scene's own shaders, in passes of that encoder.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`SceneAir::validate`]; [`crate::ErrorKind::Lost`].
    pub fn air_group(&mut self, encoder: &wgpu::CommandEncoder, air: &SceneAir) -> Result<AirGroup> {
        air.validate(self)?;
        let (program, inputs, block) = (SceneAir::PROGRAM, air.textures(), air.block());
        let (group, offset) = self.bind_group(encoder, "scene air", program, &inputs, &block)?;
        Ok(AirGroup { group, offset })
    }

    /// Makes a user's view of a whole texture known, which is drawn to. The view of an sRGB texture may be
    /// one of the format without.
    fn import_output(&mut self, view: &wgpu::TextureView) -> Result<crate::gpu::TextureId> {
        let texture = view.texture();
        let format = crate::gpu::wgpu::known_format(texture.format().remove_srgb_suffix())?;
        if format.channels() != 4 || !texture.usage().contains(wgpu::TextureUsages::RENDER_ATTACHMENT) {
            let value = format_args!("a view of {:?} for {:?}", texture.format(), texture.usage());
            let allowed = "one of four channels, of a texture with the usage RENDER_ATTACHMENT";
            return Err(Error::invalid("output", value, allowed));
        }
        self.import_view(view.clone(), TextureDesc::new("output", texture.width(), texture.height(), format))
    }
}
