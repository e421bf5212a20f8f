//! Physically based skies and atmospheres on two GPU backends from one set of shaders: WebGPU through
//! wgpu, WebGL2 (and OpenGL ES 3) through glow. From the ground to far orbit, natively and in browsers.
//!
//! # The shortest example
//!
//! ```no_run
//! # #[cfg(feature = "wgpu")] {
//! use welkin::gpu::{Backend, wgpu::WgpuBackend};
//! use welkin::{AtmosphereParams, Camera, DepthConvention, PictureRenderer, PictureSettings, Scene};
//! use glam::DVec3;
//!
//! let earth = AtmosphereParams::earth();
//! let scene = Scene {
//!     // Two metres above the north pole, looking along +X.
//!     camera: Camera::new(DVec3::Z * (earth.planet_radius + 2.0), DVec3::X, DVec3::Z, 1.0, 16.0 / 9.0),
//!     planet_center: DVec3::ZERO,
//!     atmosphere: earth,
//!     sun_direction: DVec3::new(1.0, 0.3, 0.4),
//!     depth: DepthConvention::default(),
//!     moon: None,
//!     ellipsoid: None,
//! };
//! let mut backend = WgpuBackend::headless()?;
//! let settings = PictureSettings::default();
//! let drawn = PictureRenderer::default().draw(&mut backend, &scene, &settings, [640, 360])?;
//! let rgba = backend.read(drawn.display)?;
//! # }
//! # Ok::<(), welkin::Error>(())
//! ```
//!
//! # Around a scene of your own
//!
//! `WgpuSky` (feature `wgpu`) and `WebGlSky` (feature `webgl`) make a whole frame in one call: they clear,
//! draw the sky, have you draw, lay the air before what you drew and map tones, in your encoder or context.
//! They have the examples; [`Camera::projection`] and [`Camera::from_matrices`] go between matrices and
//! cameras.
//!
//! Glass, water and mirrors call the air in their own shaders: [`shaders::scene`].
//!
//! # In textures of your own
//!
//! [`SkyRenderer::frame`] gives the passes of a frame as data. Run its background first (depth ALWAYS, no
//! depth write), then draw your scene with its depth, then run its aerial passes, which read both and write
//! to a third texture.
//!
//! With wgpu, on your device and in your encoder:
//!
//! ```no_run
//! # #[cfg(feature = "wgpu")]
//! # fn frame(device: wgpu::Device, queue: wgpu::Queue, mut encoder: wgpu::CommandEncoder,
//! #          view: wgpu::TextureView, scene: welkin::Scene) -> welkin::Result<()> {
//! use welkin::gpu::{Format, Target, TextureDesc, wgpu::WgpuBackend};
//! use welkin::{FrameTargets, SkyRenderer, SkySettings};
//!
//! let mut backend = WgpuBackend::from_device(device, queue, "my adapter")?;
//! let mut sky = SkyRenderer::new(SkySettings::default())?;
//! // One of a texture that allows it; `import_texture` takes a whole texture, with its size and format.
//! let target = backend.import_view(view, TextureDesc::new("hdr", 1280, 720, Format::Rgba16Float))?;
//! let frame = sky.frame(&mut backend, &scene, &FrameTargets::background(Target::color(target)))?;
//! backend.encode(&mut encoder, frame.background)?;
//! # Ok(()) }
//! ```
//!
//! Inside a render pass of your own, with its samples and formats: `WgpuBackend::encode_in`. To a part of a
//! target, on either backend: [`Target::viewport`](gpu::Target::viewport).
//!
//! With the air before the scene, without which there is none at all in views from above 50 km:
//!
//! ```no_run
//! # fn frame(backend: &mut dyn welkin::gpu::Backend, sky: &mut welkin::SkyRenderer, scene: &welkin::Scene,
//! #          [color, depth, hazy]: [welkin::gpu::TextureId; 3]) -> welkin::Result<()> {
//! use welkin::gpu::Target;
//! use welkin::{AerialTargets, FrameTargets};
//!
//! // `color` and `depth` (`Format::Depth32Float`) are what your scene is drawn to; passes sample both.
//! let cleared = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(color) };
//! let air = AerialTargets { color: Some(color), depth, target: Target::color(hazy) };
//! let frame = sky.frame(backend, scene, &FrameTargets::background(cleared).with_aerial(air))?;
//! backend.run(frame.background)?;
//! // Here draw your scene. Where it is not, its depth is `scene.depth.background()`.
//! backend.run(frame.aerial)?;
//! // `hazy` now has the frame, in linear light: `frame::tone_map::tone_pass` maps it to your display.
//! // Where no air was drawn (from space looking away, say) it is `color` that has it; `frame.color` tells.
//! # Ok(()) }
//! ```
//!
//! With WebGL2, in your context, whose state is put back:
//!
//! ```no_run
//! # #[cfg(feature = "webgl")]
//! # fn frame(gl: std::rc::Rc<glow::Context>, scene: welkin::Scene) -> welkin::Result<()> {
//! use welkin::gpu::{Backend, Format, RowOrder, Target, TextureDesc, webgl::WebGlBackend};
//! use welkin::{FrameTargets, SkyRenderer, SkySettings};
//!
//! let mut backend = WebGlBackend::new(gl)?;
//! let mut sky = SkyRenderer::new(SkySettings::default())?;
//! // Light comes out linear: into a texture of halves (Format::Rgba16Float) if you map tones yourself.
//! let desc = TextureDesc::new("screen", 1280, 720, Format::Rgba8);
//! let desc = TextureDesc { rows: RowOrder::BottomUp, ..desc };
//! let target = backend.import_framebuffer(None, desc)?;
//! let frame = sky.frame(&mut backend, &scene, &FrameTargets::background(Target::color(target)))?;
//! backend.run(frame.background)?;
//! # Ok(()) }
//! ```
//!
//! # Units
//!
//! Metres, radians, f64, any right-handed frame of reference. The GPU sees kilometres in f32, relative to
//! the camera (see [`model::scene`]). Radiance is in the unit of [`AtmosphereParams::sun_intensity`] per
//! steradian.
//!
//! # What it is not
//!
//! Three wavelengths stand for the spectrum; no polarisation, no refraction.

#[cfg(feature = "probe")]
pub mod count;
#[cfg(not(feature = "probe"))]
mod count;
pub mod error;
pub mod frame;
pub mod gpu;
pub mod model;
#[cfg(feature = "probe")]
pub mod probe;
pub mod reference;
pub mod render;
pub mod settings;
pub mod shaders;

pub use glam;
#[cfg(feature = "webgl")]
pub use glow;
#[cfg(feature = "wgpu")]
pub use wgpu;

pub use error::{Error, ErrorKind, Result};
pub use frame::Frame;
pub use frame::terrain::TerrainStyle;
pub use model::airglow::Airglow;
pub use model::atmosphere::{AtmosphereParams, MiePhase};
pub use model::ellipsoid::Ellipsoid;
pub use model::lighting::{AtmosphereConfig, LightingContext};
pub use model::moon::Moon;
pub use model::rays::{ray_sphere_intersect, ray_sphere_intersect_f32};
pub use model::scene::{Camera, DepthConvention, Pose, Scene};
pub use reference::{clip_segment, compute_single_scatter};
#[cfg(feature = "webgl")]
pub use render::in_webgl::{WebGlFrame, WebGlSky};
#[cfg(feature = "wgpu")]
pub use render::in_wgpu::{AirGroup, WgpuFrame, WgpuSky};
pub use render::picture::{Around, PictureRenderer, PictureSettings};
pub use render::scene_air::SceneAir;
pub use render::sky::{AerialTargets, FrameTargets, SkyFrame, SkyRenderer};
pub use render::sky_light::{LightingContextUniform, SkyLight, SkyLightRead};
pub use render::warm_up::{TargetFormats, WarmUp};
pub use settings::{Bound, Composition, Look, LutSettings, Mode, Quality, SkySettings, ToneMap};
