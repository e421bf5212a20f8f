//! Passes on WebGPU through wgpu: Vulkan natively, WebGPU in a browser.
//!
//! [`WgpuBackend::new`] makes its own device. [`WgpuBackend::from_device`] takes yours: import your
//! textures with [`WgpuBackend::import_texture`] or [`WgpuBackend::import_view`] and record passes into your
//! own encoder with [`WgpuBackend::encode`].

mod import;
mod inside;
mod recording;
mod uncaptured;

use std::num::NonZeroU64;
use std::sync::{Arc, Mutex, PoisonError};

use super::arena::Arena;
use super::map::Map;
use super::{
    AdapterInfo, Backend, Blend, DepthUse, Format, Inputs, Live, Pass, PassTime, Precision, Program,
    ProgramId, ReadId, SAMPLER_BINDING, TEXTURES_MAX, TextureDesc, TextureId, Ticket, TimerId, TimerKind,
    Uniform, Vertices, check_inputs, check_pass, check_texels, decode_texels, encode_texels, program::Bound,
    unsuitable,
};
use crate::error::{Error, Result};
pub(crate) use import::known_format;
use inside::{Draw, Inside};
pub use inside::{InPass, OpenPass};
use recording::{Fate, Recordings};

const NAME: &str = "webgpu";

/// The target's colour times the output's; its alpha stays.
const MULTIPLY: wgpu::BlendState = {
    use wgpu::{BlendComponent, BlendFactor, BlendOperation};
    wgpu::BlendState {
        color: BlendComponent {
            src_factor: BlendFactor::Dst,
            dst_factor: BlendFactor::Zero,
            operation: BlendOperation::Add,
        },
        alpha: BlendComponent {
            src_factor: BlendFactor::Zero,
            dst_factor: BlendFactor::One,
            operation: BlendOperation::Add,
        },
    }
};

struct Texture {
    desc: TextureDesc,
    /// See [`Backend::content`].
    content: u64,
    /// [`Recordings::generation`] when it got its content.
    generation: u32,
    /// The encoder that was recorded in what gave it its content.
    fate: Option<Arc<Fate>>,
    view: wgpu::TextureView,
    /// Whether it is the user's: it is neither written nor read back.
    imported: bool,
    /// It is no texture but a pass of the user's, with pipelines of this shape; the view is a placeholder.
    open: Option<Shape>,
}

/// What the pipelines of a render pass have in common: the format of its colour, that of its depth, and
/// samples a pixel.
type Shape = (wgpu::TextureFormat, Option<wgpu::TextureFormat>, u32);

struct Compiled {
    program: Program,
    module: wgpu::ShaderModule,
    layout: wgpu::BindGroupLayout,
    pipeline_layout: wgpu::PipelineLayout,
}

impl Texture {
    /// The texture, if it is the backend's own.
    fn own(&self) -> Result<&wgpu::Texture> {
        if self.imported {
            let allowed = "a texture of the backend's own: the user reads and writes imported ones";
            return Err(Error::invalid(self.desc.label, "an imported view", allowed));
        }
        Ok(self.view.texture())
    }
}

/// What wgpu gives for a mapped buffer: 29 its bytes, and a panic if there are none; 30 an error then.
trait Mapped {
    fn mapped(self) -> Result<wgpu::BufferView>;
}

impl Mapped for wgpu::BufferView {
    fn mapped(self) -> Result<wgpu::BufferView> {
        Ok(self)
    }
}

impl<E: ToString> Mapped for Result<wgpu::BufferView, E> {
    fn mapped(self) -> Result<wgpu::BufferView> {
        self.map_err(|e| Error::driver(NAME, "read back", e.to_string()))
    }
}

type CheckImport = fn(&WgpuBackend, &wgpu::TextureView, &TextureDesc) -> Result<()>;

type Slot<T> = Arc<Mutex<Option<T>>>;

struct Read {
    held: Arc<()>,
    desc: TextureDesc,
    buffer: wgpu::Buffer,
    row_bytes: u32,
    done: Slot<Result<(), wgpu::BufferAsyncError>>,
}

struct Timer {
    held: Arc<()>,
    labels: Vec<&'static str>,
    buffer: wgpu::Buffer,
    done: Slot<Result<(), wgpu::BufferAsyncError>>,
    /// Filled at once where times come from a clock.
    times: Option<Vec<PassTime>>,
}

/// See the [module](self).
pub struct WgpuBackend {
    epoch: u32,
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: AdapterInfo,
    textures: Arena<TextureId, Texture>,
    programs: Arena<ProgramId, Compiled>,
    pipelines: Map<(ProgramId, Shape, DepthUse), wgpu::RenderPipeline>,
    bind_groups: Map<(ProgramId, Bound), wgpu::BindGroup>,
    reads: Arena<ReadId, Read>,
    timers: Arena<TimerId, Timer>,
    sampler: wgpu::Sampler,
    /// Bound where a program's constants leave a texture unread.
    placeholder: wgpu::TextureView,
    /// On a user's device, whose handler for errors is the user's: compares a view with what the user says of
    /// it. A program without such a device has no code for it.
    check_import: Option<CheckImport>,
    recordings: Recordings,
    /// Where passes of the user's are drawn in. A program without has no code for it.
    inside: Option<Box<dyn Inside>>,
    lost: Slot<String>,
    failure: Slot<String>,
}

fn lock<T>(slot: &Slot<T>) -> std::sync::MutexGuard<'_, Option<T>> {
    slot.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Writes a block to a slot of its own; answers its offset, bytes.
fn upload(recordings: &mut Recordings, queue: &wgpu::Queue, uniform: &Uniform) -> u32 {
    crate::count::one(|c| &mut c.uniform_uploads);
    let offset = recordings.slot();
    queue.write_buffer(&recordings.buffer, u64::from(offset), uniform.bytes());
    offset
}

fn format(format: Format) -> wgpu::TextureFormat {
    match format {
        Format::Rgba8 => wgpu::TextureFormat::Rgba8Unorm,
        Format::Bgra8 => wgpu::TextureFormat::Bgra8Unorm,
        Format::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        Format::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
        Format::R32Float => wgpu::TextureFormat::R32Float,
        Format::Depth32Float => wgpu::TextureFormat::Depth32Float,
    }
}

impl WgpuBackend {
    /// An instance with the APIs that this crate was built for.
    pub fn instance() -> wgpu::Instance {
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle())
    }

    /// Makes a device of its own on the adapter that can present to `surface` (any, if `None`), best first.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Unavailable`] with the reason if there is no adapter or no device.
    pub async fn new(instance: &wgpu::Instance, surface: Option<&wgpu::Surface<'_>>) -> Result<Self> {
        let unavailable = |reason: String| Error::unavailable(NAME, reason);
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                compatible_surface: surface,
                ..Default::default()
            })
            .await
            .map_err(|e| match e {
                // What else wgpu has to say is about APIs that a browser does not have.
                _ if cfg!(target_arch = "wasm32") => unavailable("the browser offers no adapter".into()),
                e => unavailable(e.to_string()),
            })?;
        let wanted = wgpu::Features::TIMESTAMP_QUERY
            | wgpu::Features::FLOAT32_BLENDABLE
            | wgpu::Features::FLOAT32_FILTERABLE;
        let limits = wgpu::Limits {
            max_texture_dimension_2d: adapter.limits().max_texture_dimension_2d,
            ..wgpu::Limits::downlevel_defaults()
        };
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("welkin"),
                required_features: adapter.features() & wanted,
                required_limits: limits,
                ..Default::default()
            })
            .await
            .map_err(|e| unavailable(e.to_string()))?;
        let about = adapter.get_info();
        let driver = format!("{:?} {} {}", about.backend, about.driver, about.driver_info);
        let kind = if about.device_type == wgpu::DeviceType::Cpu { " (software)" } else { "" };
        let name = if about.name.is_empty() {
            format!("adapter that the browser does not name{kind}")
        } else {
            about.name
        };
        let mut backend = Self::make(device, queue, &name, None);
        driver.trim_end().clone_into(&mut backend.info.driver);
        let lost = backend.lost.clone();
        backend
            .device
            .set_device_lost_callback(move |reason, text| *lock(&lost) = Some(format!("{reason:?}: {text}")));
        let failure = backend.failure.clone();
        uncaptured::on_error(&backend.device, move |text| {
            lock(&failure).get_or_insert(text);
        });
        Ok(backend)
    }

    /// As [`Self::new`] without a surface, waiting for it.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn headless() -> Result<Self> {
        pollster::block_on(Self::new(&Self::instance(), None))
    }

    /// On a user's own device. Handlers for lost devices and errors stay the user's.
    /// `name` is what [`AdapterInfo::adapter`] shall say.
    ///
    /// No feature is needed. With [`wgpu::Features::FLOAT32_FILTERABLE`] the sky's LUTs have 32 bits instead
    /// of 16 ([`AdapterInfo::filters_f32`]); with [`wgpu::Features::TIMESTAMP_QUERY`] passes are timed by the
    /// GPU instead of a clock that waits for it ([`AdapterInfo::timer`]).
    pub fn from_device(device: wgpu::Device, queue: wgpu::Queue, name: &str) -> Result<Self> {
        Ok(Self::make(device, queue, name, Some(Self::check_view)))
    }

    fn make(device: wgpu::Device, queue: wgpu::Queue, name: &str, check_import: Option<CheckImport>) -> Self {
        let limits = device.limits();
        let timer = if device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            TimerKind::Timestamps
        } else if cfg!(target_arch = "wasm32") {
            TimerKind::None
        } else {
            TimerKind::Clock
        };
        let filters_f32 = device.features().contains(wgpu::Features::FLOAT32_FILTERABLE);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("welkin LUTs"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        let placeholder = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("welkin placeholder"),
            size: wgpu::Extent3d { width: 1, height: 1, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            // One that every device filters.
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let placeholder = placeholder.create_view(&Default::default());
        let recordings = Recordings::new(&device);
        let epoch = super::next_epoch();
        Self {
            epoch,
            info: AdapterInfo {
                backend: NAME,
                adapter: name.to_owned(),
                driver: "user's device".into(),
                timer,
                max_texture_size: limits.max_texture_dimension_2d,
                filters_f32,
                precision: Precision::Guaranteed,
            },
            device,
            queue,
            textures: Arena::new(NAME, epoch),
            programs: Arena::new(NAME, epoch),
            pipelines: Map::new(),
            bind_groups: Map::new(),
            reads: Arena::new(NAME, epoch),
            timers: Arena::new(NAME, epoch),
            sampler,
            placeholder,
            recordings,
            inside: None,
            check_import,
            lost: Slot::default(),
            failure: Slot::default(),
        }
    }

    /// The device that it draws with.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// The view that passes read a texture through and draw to it.
    pub fn view(&self, id: TextureId) -> Option<&wgpu::TextureView> {
        self.textures.get(id).map(|t| &t.view)
    }

    /// The queue that it submits to.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Records passes into a user's encoder, to be submitted to the queue of [`Self::from_device`].
    ///
    /// LUTs count as made from now on, and as unknown again if the encoder is dropped without being
    /// submitted: the next frame makes them anew. A frame that was recorded in between, on their account,
    /// shows what they held before. The same goes for encoders that are submitted in another order than
    /// passes were recorded.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and [`crate::ErrorKind::Driver`] for passes that do not fit the textures
    /// that they name, before anything is recorded; [`crate::ErrorKind::Lost`].
    pub fn encode(&mut self, encoder: &mut wgpu::CommandEncoder, passes: &[Pass]) -> Result<()> {
        self.encode_timed(encoder, passes, None)
    }

    fn encode_timed(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        passes: &[Pass],
        queries: Option<&wgpu::QuerySet>,
    ) -> Result<()> {
        self.check()?;
        // An empty list has its place too: `submitted` speaks of what was recorded last.
        let blocks = passes.iter().filter(|p| !p.uniform.bytes().is_empty()).count() as u32;
        let keeps = passes.iter().any(|p| p.content != 0 || p.depth_content != 0);
        if self.recordings.reserve(&self.device, encoder, blocks, keeps)? {
            // They name the buffer.
            self.bind_groups.retain(|_, _| false);
        }
        for pass in passes {
            self.prepare(pass)?;
            let target = self.textures.find(pass.target.color)?;
            if let Some(inside) = self.inside.as_ref().filter(|_| target.open.is_some()) {
                return Err(inside.not_a_texture(pass.label, &target.desc));
            }
        }
        for (index, pass) in passes.iter().enumerate() {
            self.record(encoder, pass, queries.map(|q| (q, index as u32)))?;
            for (id, content) in pass.contents(|id| self.content(id)).into_iter().flatten() {
                self.set_content(id, content);
                if let Some(texture) = self.textures.get_mut(id).filter(|_| content != 0) {
                    texture.fate = self.recordings.fate();
                }
            }
        }
        Ok(())
    }

    /// Records passes into an encoder of its own and submits it.
    fn submit(&mut self, passes: &[Pass]) -> Result<()> {
        let mut encoder = self.encoder();
        self.encode(&mut encoder, passes)?;
        self.queue.submit([encoder.finish()]);
        self.recordings.submitted();
        Ok(())
    }

    /// Everything that can fail, before anything is recorded.
    fn prepare(&mut self, pass: &Pass) -> Result<()> {
        self.inside.as_mut().map_or(Ok(()), |inside| inside.check(pass))?;
        let color = self.target(pass, "color target", pass.target.color)?;
        let written_by_copy = pass.texels.is_some();
        if color.format == Format::Depth32Float && !written_by_copy {
            return Err(unsuitable(pass.label, "color target", color, "a format of colors"));
        }
        if let Some(texels) = &pass.texels {
            check_texels(&color, texels)?;
        }
        if let Some(depth) = pass.target.depth {
            let depth = self.target(pass, "depth target", depth)?;
            if depth.format != Format::Depth32Float
                || (depth.width, depth.height) != (color.width, color.height)
            {
                let allowed = "Depth32Float and as large as the color target";
                return Err(unsuitable(pass.label, "depth target", depth, allowed));
            }
        }
        pass.target.viewport.map_or(Ok(()), |viewport| viewport.validate(&color))?;
        let Some(program) = pass.program else { return self.check() };
        let compiled = self.programs.find(program)?;
        let bound = check_pass(NAME, pass, compiled.program)?;
        self.make_bind_group(program, pass.label, bound)?;
        let compiled = self.programs.find(program)?;
        let key = (program, self.shape(pass)?, pass.depth);
        if !self.pipelines.contains_key(&key) {
            let (pipeline, refused) = self.trial(|| self.pipeline(compiled, key.1, key.2));
            if let Some(reason) = refused {
                return Err(Error::driver(NAME, format!("pipeline of {}", compiled.program.name()), reason));
            }
            self.pipelines.insert(key, pipeline);
        }
        self.check()
    }

    /// Makes the bind group of a pass's program and textures unless it is there.
    fn make_bind_group(&mut self, program: ProgramId, label: &'static str, bound: Bound) -> Result<()> {
        let compiled = self.programs.find(program)?;
        let info = compiled.program.info();
        for (slot, id) in info.textures.iter().zip(bound) {
            let Some(id) = id else { continue };
            let texture = self.textures.find(id)?;
            if slot.filtered && texture.desc.format == Format::Depth32Float {
                return Err(unsuitable(label, slot.name, texture.desc, "a format of colors"));
            }
            if let Some(inside) = self.inside.as_ref().filter(|_| texture.open.is_some()) {
                return Err(inside.not_a_texture(label, &texture.desc));
            }
            if !texture.view.texture().usage().contains(wgpu::TextureUsages::TEXTURE_BINDING) {
                return Err(import::lacks(label, slot.name, "TEXTURE_BINDING"));
            }
        }
        if !self.bind_groups.contains_key(&(program, bound)) {
            let mut entries = Vec::with_capacity(2 + TEXTURES_MAX);
            if info.textures.iter().any(|slot| slot.filtered) {
                let resource = wgpu::BindingResource::Sampler(&self.sampler);
                entries.push(wgpu::BindGroupEntry { binding: SAMPLER_BINDING, resource });
            }
            if info.uniform_size > 0 {
                entries.push(wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                        buffer: &self.recordings.buffer,
                        offset: 0,
                        size: NonZeroU64::new(info.uniform_size.into()),
                    }),
                });
            }
            for (slot, id) in info.textures.iter().zip(bound) {
                let view = match id {
                    Some(id) => &self.textures.find(id)?.view,
                    None => &self.placeholder,
                };
                let resource = wgpu::BindingResource::TextureView(view);
                entries.push(wgpu::BindGroupEntry { binding: slot.binding, resource });
            }
            let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(label),
                layout: &compiled.layout,
                entries: &entries,
            });
            self.bind_groups.insert((program, bound), group);
        }
        Ok(())
    }

    /// A program's bind group layout, for pipelines of a user's that read what the program reads.
    ///
    /// # Errors
    /// Those of [`Backend::create_program`].
    pub fn layout(&mut self, program: Program) -> Result<wgpu::BindGroupLayout> {
        let id = self.create_program(program)?;
        Ok(self.programs.find(id)?.layout.clone())
    }

    /// What a program reads, for a user's pipeline with its [`Self::layout`] and for a pass of the user's in
    /// that encoder: a bind group and its one dynamic offset. `label`: for people and errors.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] and [`crate::ErrorKind::Driver`] for textures and a block that are not
    /// the program's, before anything is made; [`crate::ErrorKind::Lost`].
    pub fn bind_group(
        &mut self,
        encoder: &wgpu::CommandEncoder,
        label: &'static str,
        program: Program,
        inputs: &Inputs,
        uniform: &Uniform,
    ) -> Result<(wgpu::BindGroup, u32)> {
        let id = self.create_program(program)?;
        let bound = check_inputs(NAME, label, program, inputs, uniform)?;
        if self.recordings.reserve(&self.device, encoder, 1, false)? {
            self.bind_groups.retain(|_, _| false);
        }
        self.make_bind_group(id, label, bound)?;
        let group = self.bind_groups.get(&(id, bound)).cloned().ok_or_else(|| self.programs.unknown(id))?;
        self.check()?;
        Ok((group, upload(&mut self.recordings, &self.queue, uniform)))
    }

    /// The shape of the render pass that a pass draws in.
    fn shape(&self, pass: &Pass) -> Result<Shape> {
        let color = self.textures.find(pass.target.color)?;
        let depth = pass.target.depth.map(|_| wgpu::TextureFormat::Depth32Float);
        Ok(color.open.unwrap_or((format(color.desc.format), depth, 1)))
    }

    fn pipeline(
        &self,
        compiled: &Compiled,
        (color, depth, count): Shape,
        depth_use: DepthUse,
    ) -> wgpu::RenderPipeline {
        let program = compiled.program;
        let label = ["welkin ", &program.name()].concat();
        // With several samples a pixel its edges are told by each: the horizon, a disk.
        let inside = self.inside.as_ref().filter(|_| count > 1);
        let by_sample = inside.map(|inside| inside.module(&self.device, program));
        let module = by_sample.as_ref().unwrap_or(&compiled.module);
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(&label),
            layout: Some(&compiled.pipeline_layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("vertex_main"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState {
                topology: match program.info().vertices {
                    Vertices::Triangle => wgpu::PrimitiveTopology::TriangleList,
                    Vertices::Strip(_) => wgpu::PrimitiveTopology::TriangleStrip,
                },
                ..Default::default()
            },
            depth_stencil: depth.map(|format| wgpu::DepthStencilState {
                format,
                depth_write_enabled: Some(depth_use != DepthUse::Always),
                depth_compare: Some(match depth_use {
                    DepthUse::Always => wgpu::CompareFunction::Always,
                    DepthUse::Nearer { reversed: false } => wgpu::CompareFunction::Less,
                    DepthUse::Nearer { reversed: true } => wgpu::CompareFunction::Greater,
                }),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some("fragment_main"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: color,
                    blend: match program.blend() {
                        Blend::None => None,
                        Blend::Over => Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                        Blend::Multiply => Some(MULTIPLY),
                    },
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }

    fn record(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        pass: &Pass,
        query: Option<(&wgpu::QuerySet, u32)>,
    ) -> Result<()> {
        let color = self.textures.find(pass.target.color)?;
        let depth = pass.target.depth.and_then(|d| self.textures.get(d));
        if let Some(texels) = &pass.texels {
            self.record_texels(encoder, color, texels);
            if query.is_none() {
                return Ok(());
            }
        }
        let mut render = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(pass.label),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &color.view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: pass.target.clear.map_or(wgpu::LoadOp::Load, |[r, g, b, a]| {
                        wgpu::LoadOp::Clear(wgpu::Color {
                            r: r.into(),
                            g: g.into(),
                            b: b.into(),
                            a: a.into(),
                        })
                    }),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: depth.map(|d| wgpu::RenderPassDepthStencilAttachment {
                view: &d.view,
                depth_ops: Some(wgpu::Operations {
                    load: pass.target.clear_depth.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: query.map(|(query_set, index)| wgpu::RenderPassTimestampWrites {
                query_set,
                beginning_of_pass_write_index: Some(2 * index),
                end_of_pass_write_index: Some(2 * index + 1),
            }),
            ..Default::default()
        });
        let Some(program) = pass.program else { return Ok(()) };
        let draw = self.draw(program, pass)?;
        draw.draw(&mut render);
        Ok(())
    }

    /// What draws a pass that is prepared, its block written to a slot of its own.
    fn draw(&mut self, program: ProgramId, pass: &Pass) -> Result<Draw> {
        let key = (program, self.shape(pass)?, pass.depth);
        let compiled = self.programs.find(program)?.program;
        let bound = check_pass(NAME, pass, compiled)?;
        let (Some(pipeline), Some(group)) =
            (self.pipelines.get(&key), self.bind_groups.get(&(program, bound)))
        else {
            return Err(self.programs.unknown(program));
        };
        let has_block = !pass.uniform.bytes().is_empty();
        Ok(Draw {
            pipeline: pipeline.clone(),
            group: group.clone(),
            offset: has_block.then(|| upload(&mut self.recordings, &self.queue, &pass.uniform)),
            viewport: pass.target.viewport,
            vertices: compiled.info().vertices.count(),
        })
    }

    /// Records a copy of texels to a texture: written to it by the queue, they would be there for the whole
    /// submission. They are written to a buffer that only this copy reads.
    fn record_texels(&self, encoder: &mut wgpu::CommandEncoder, to: &Texture, texels: &[f32]) {
        let row = to.desc.width as usize * to.desc.format.bytes();
        let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
        let mut bytes = vec![0; padded * to.desc.height as usize];
        let lines = encode_texels(to.desc.format, texels);
        for (line, at) in lines.chunks_exact(row).zip(bytes.chunks_exact_mut(padded)) {
            at[..row].copy_from_slice(line);
        }
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(to.desc.label),
            size: bytes.len() as u64,
            usage: wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, &bytes);
        let padded = padded as u32;
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(padded), rows_per_image: None };
        let texture = to.view.texture();
        encoder.copy_buffer_to_texture(
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            texture.as_image_copy(),
            texture.size(),
        );
    }

    /// What a pass draws to.
    fn target(&self, pass: &Pass, what: &str, id: TextureId) -> Result<TextureDesc> {
        let texture = self.textures.find(id)?;
        if let Some(inside) = self.inside.as_ref().filter(|_| texture.open.is_some()) {
            return inside.target(pass, texture.desc);
        }
        let usage = texture.view.texture().usage();
        if pass.texels.is_none() && !usage.contains(wgpu::TextureUsages::RENDER_ATTACHMENT) {
            return Err(import::lacks(pass.label, what, "RENDER_ATTACHMENT"));
        }
        Ok(texture.desc)
    }

    /// The device's loss or first error since the last call.
    fn check(&self) -> Result<()> {
        if let Some(reason) = self.lost() {
            return Err(Error::lost(NAME, reason));
        }
        match lock(&self.failure).take() {
            Some(reason) => Err(Error::driver(NAME, "device", reason)),
            None => Ok(()),
        }
    }

    /// [`Self::check`] after letting the device say what happened meanwhile.
    fn alive(&self) -> Result<()> {
        #[cfg(not(target_arch = "wasm32"))]
        let _ = self.device.poll(wgpu::PollType::Poll);
        self.check()
    }

    fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("welkin") })
    }

    fn map(&self, buffer: &wgpu::Buffer) -> Slot<Result<(), wgpu::BufferAsyncError>> {
        let done: Slot<_> = Slot::default();
        let slot = done.clone();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| *lock(&slot) = Some(result));
        done
    }

    fn read_buffer(&self, label: &str, size: u64, extra: wgpu::BufferUsages) -> wgpu::Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            size,
            usage: wgpu::BufferUsages::COPY_DST | extra,
            mapped_at_creation: false,
        })
    }

    fn mapped<T>(buffer: &wgpu::Buffer, f: impl FnOnce(&[u8]) -> T) -> Result<T> {
        let range = buffer.get_mapped_range(..).mapped()?;
        let value = f(&range);
        drop(range);
        buffer.unmap();
        Ok(value)
    }

    /// Draws and waits pass by pass with a wall clock.
    #[cfg(not(target_arch = "wasm32"))]
    fn clock(&mut self, passes: &[Pass]) -> Result<Vec<PassTime>> {
        self.wait()?;
        passes
            .iter()
            .map(|pass| {
                let start = std::time::Instant::now();
                self.run(std::slice::from_ref(pass))?;
                self.wait()?;
                Ok(PassTime { label: pass.label, nanoseconds: start.elapsed().as_nanos() as f64 })
            })
            .collect()
    }
}

impl Backend for WgpuBackend {
    fn info(&self) -> &AdapterInfo {
        &self.info
    }

    fn create_texture(&mut self, desc: &TextureDesc) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        self.alive()?;
        let mut usage = wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC;
        if desc.format != Format::Depth32Float {
            usage |= wgpu::TextureUsages::COPY_DST;
        }
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some(desc.label),
            size: wgpu::Extent3d { width: desc.width, height: desc.height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: format(desc.format),
            usage,
            view_formats: &[],
        });
        let view = texture.create_view(&Default::default());
        self.check()?;
        Ok(self.textures.insert(Texture {
            desc: *desc,
            content: 0,
            generation: 0,
            fate: None,
            view,
            imported: false,
            open: None,
        }))
    }

    fn texture(&self, id: TextureId) -> Option<TextureDesc> {
        self.textures.get(id).map(|t| t.desc)
    }

    fn is_texture(&self, id: TextureId) -> bool {
        self.textures.get(id).is_none_or(|t| t.open.is_none())
    }

    fn epoch(&self) -> u32 {
        self.epoch
    }

    fn content(&self, id: TextureId) -> u64 {
        let generation = self.recordings.generation();
        self.textures.get(id).filter(|t| t.generation == generation).map_or(0, |t| t.content)
    }

    fn set_content(&mut self, id: TextureId, content: u64) {
        if let Some(texture) = self.textures.get_mut(id) {
            (texture.content, texture.generation) = (content, self.recordings.generation());
            texture.fate = None;
        }
    }

    fn has_run(&self, id: TextureId) -> bool {
        self.textures.get(id).is_some_and(|t| t.fate.as_ref().is_none_or(|fate| fate.ran()))
    }

    fn destroy_texture(&mut self, id: TextureId) {
        self.bind_groups.retain(|(_, textures), _| !textures.contains(&Some(id)));
        // Dropping the last reference frees it once the GPU is done with it.
        self.textures.remove(id);
    }

    fn write_texture(&mut self, id: TextureId, texels: &[f32]) -> Result<()> {
        let t = self.textures.find(id)?;
        check_texels(&t.desc, texels)?;
        let texture = t.own()?;
        self.queue.write_texture(
            texture.as_image_copy(),
            &encode_texels(t.desc.format, texels),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(t.desc.width * t.desc.format.bytes() as u32),
                rows_per_image: None,
            },
            texture.size(),
        );
        self.check()
    }

    fn create_program(&mut self, program: Program) -> Result<ProgramId> {
        if let Some(id) = self.programs.position(|c| c.program == program) {
            return Ok(id);
        }
        self.alive()?;
        let (label, info) = (program.name(), program.info());
        let mut stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
        if self.device.limits().max_compute_workgroups_per_dimension > 0 {
            // For a user's own shaders, see `Self::layout`.
            stages |= wgpu::ShaderStages::COMPUTE;
        }
        let module = self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(&label),
            source: wgpu::ShaderSource::Wgsl(program.wgsl().into()),
        });
        let mut entries = Vec::with_capacity(2 + TEXTURES_MAX);
        if info.textures.iter().any(|slot| slot.filtered) {
            entries.push(wgpu::BindGroupLayoutEntry {
                binding: SAMPLER_BINDING,
                visibility: stages,
                ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                count: None,
            });
        }
        if info.uniform_size > 0 {
            entries.push(wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: stages,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: true,
                    min_binding_size: NonZeroU64::new(info.uniform_size.into()),
                },
                count: None,
            });
        }
        for slot in info.textures {
            entries.push(wgpu::BindGroupLayoutEntry {
                binding: slot.binding,
                visibility: stages,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: slot.filtered },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            });
        }
        let layout = self.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(&label),
            entries: &entries,
        });
        let pipeline_layout = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(&label),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        self.check()?;
        Ok(self.programs.insert(Compiled { program, module, layout, pipeline_layout }))
    }

    fn destroy_program(&mut self, id: ProgramId) {
        self.pipelines.retain(|(program, ..), _| *program != id);
        self.bind_groups.retain(|(program, _), _| *program != id);
        self.programs.remove(id);
    }

    fn run(&mut self, passes: &[Pass]) -> Result<()> {
        self.alive()?;
        self.submit(passes)?;
        self.check()
    }

    fn begin_read(&mut self, id: TextureId) -> Result<Ticket<ReadId>> {
        self.alive()?;
        self.reads.retain(|read| Arc::strong_count(&read.held) > 1);
        let t = self.textures.find(id)?;
        let texture = t.own()?;
        let row_bytes = (t.desc.width * t.desc.format.bytes() as u32)
            .next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(row_bytes) * u64::from(t.desc.height);
        let buffer = self.read_buffer("welkin read back", size, wgpu::BufferUsages::MAP_READ);
        let mut encoder = self.encoder();
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(row_bytes),
                    rows_per_image: None,
                },
            },
            texture.size(),
        );
        self.queue.submit([encoder.finish()]);
        let done = self.map(&buffer);
        let desc = t.desc;
        let held = Arc::default();
        Ok(Ticket::new(&held, self.reads.insert(Read { held: held.clone(), desc, buffer, row_bytes, done })))
    }

    fn poll_read(&mut self, ticket: &Ticket<ReadId>) -> Result<Option<Vec<f32>>> {
        self.alive()?;
        let ready = lock(&self.reads.find(ticket.id)?.done).take();
        let Some(ready) = ready else { return Ok(None) };
        let Some(read) = self.reads.remove(ticket.id) else { return Ok(None) };
        ready.map_err(|e| Error::driver(NAME, "read back", e.to_string()))?;
        let row = (read.desc.width * read.desc.format.bytes() as u32) as usize;
        Self::mapped(&read.buffer, |bytes| {
            let mut out = Vec::with_capacity(read.desc.texels() * read.desc.format.channels());
            for line in bytes.chunks_exact(read.row_bytes as usize) {
                decode_texels(read.desc.format, &line[..row], &mut out);
            }
            Some(out)
        })
    }

    fn begin_times(&mut self, passes: &[Pass]) -> Result<Ticket<TimerId>> {
        self.timers.retain(|timer| Arc::strong_count(&timer.held) > 1);
        let held = Arc::default();
        let ticket = |id| Ticket::new(&held, id);
        let labels = passes.iter().map(|p| p.label).collect();
        let size = 16 * passes.len().max(1) as u64;
        let buffer = self.read_buffer("welkin times", size, wgpu::BufferUsages::MAP_READ);
        if self.info.timer != TimerKind::Timestamps {
            #[cfg(not(target_arch = "wasm32"))]
            {
                let times = Some(self.clock(passes)?);
                let (held, done) = (held.clone(), Slot::default());
                return Ok(ticket(self.timers.insert(Timer { held, labels, buffer, done, times })));
            }
            #[cfg(target_arch = "wasm32")]
            return Err(Error::unavailable(NAME, "this device has no timestamps and a page cannot wait"));
        }
        let count = 2 * passes.len().max(1) as u32;
        let queries = self.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("welkin times"),
            ty: wgpu::QueryType::Timestamp,
            count,
        });
        let resolved = self.read_buffer(
            "welkin timestamps",
            size,
            wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
        );
        let mut encoder = self.encoder();
        self.encode_timed(&mut encoder, passes, Some(&queries))?;
        encoder.resolve_query_set(&queries, 0..2 * passes.len() as u32, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &buffer, 0, size);
        self.queue.submit([encoder.finish()]);
        self.recordings.submitted();
        let done = self.map(&buffer);
        let held = held.clone();
        Ok(ticket(self.timers.insert(Timer { held, labels, buffer, done, times: None })))
    }

    fn poll_times(&mut self, ticket: &Ticket<TimerId>) -> Result<Option<Vec<PassTime>>> {
        self.alive()?;
        let id = ticket.id;
        let Some(timer) = self.timers.get_mut(id) else { return Err(self.timers.unknown(id)) };
        if let Some(times) = timer.times.take() {
            self.timers.remove(id);
            return Ok(Some(times));
        }
        let ready = lock(&timer.done).take();
        let Some(ready) = ready else { return Ok(None) };
        let Some(timer) = self.timers.remove(id) else { return Ok(None) };
        ready.map_err(|e| Error::driver(NAME, "times", e.to_string()))?;
        let period = f64::from(self.queue.get_timestamp_period());
        Self::mapped(&timer.buffer, |bytes| {
            let stamp = |i: usize| {
                bytes.get(8 * i..8 * i + 8).and_then(|b| b.try_into().ok()).map_or(0, u64::from_le_bytes)
            };
            let times = timer.labels.iter().enumerate().map(|(i, &label)| PassTime {
                label,
                nanoseconds: stamp(2 * i + 1).saturating_sub(stamp(2 * i)) as f64 * period,
            });
            Some(times.collect())
        })
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn wait(&mut self) -> Result<()> {
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|e| Error::driver(NAME, "wait", e.to_string()))?;
        self.check()
    }

    #[cfg(target_arch = "wasm32")]
    fn wait(&mut self) -> Result<()> {
        Err(super::cannot_wait(NAME))
    }

    fn lost(&self) -> Option<String> {
        lock(&self.lost).clone()
    }

    fn live(&self) -> Live {
        Live {
            textures: self.textures.len(),
            texture_bytes: self.textures.values().map(|t| t.desc.texels() * t.desc.format.bytes()).sum(),
            programs: self.programs.len(),
            framebuffers: 0,
            pipelines: self.pipelines.len(),
            bind_groups: self.bind_groups.len(),
            reads: self.reads.len(),
        }
    }
}
