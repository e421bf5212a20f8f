//! Drawing inside a render pass, or a render bundle, that the user opened.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Weak};

use super::{Shape, Texture, WgpuBackend, known_format};
use crate::error::{Error, Result};
use crate::gpu::{Format, Pass, Program, TextureDesc, TextureId, Viewport, check_open};

/// A render pass of the user's with one colour attachment: what pipelines have to fit to be drawn in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenPass {
    /// Pixels of its attachments; import the pass again when they change.
    pub size: [u32; 2],
    /// Format of the colour attachment's view, which the device can blend. What is written to one of sRGB is
    /// encoded by the device: right for radiance, wrong for what a tone map wrote.
    pub color: wgpu::TextureFormat,
    /// Format of the depth attachment, if there is one: it is neither tested nor written.
    pub depth: Option<wgpu::TextureFormat>,
    /// Samples a pixel. With more than one, fragments are computed for each sample, so that the horizon and
    /// the disks have edges as smooth as your scene's, and cost as many times as much.
    pub samples: u32,
}

/// One draw.
#[derive(Clone, Debug)]
pub(super) struct Draw {
    pub pipeline: wgpu::RenderPipeline,
    pub group: wgpu::BindGroup,
    /// Where its block is, if it has one.
    pub offset: Option<u32>,
    pub viewport: Option<Viewport>,
    pub vertices: u32,
}

impl Draw {
    /// The group's dynamic offsets.
    fn offsets(&self) -> &[u32] {
        self.offset.as_slice()
    }

    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(Viewport { x, y, width, height }) = self.viewport {
            pass.set_viewport(x as f32, y as f32, width as f32, height as f32, 0.0, 1.0);
        }
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, self.offsets());
        pass.draw(0..self.vertices, 0..1);
    }
}

/// What only backends have that draw in passes of the user's.
pub(super) trait Inside {
    /// A program's module whose fragments are computed for each sample.
    fn module(&self, device: &wgpu::Device, program: Program) -> wgpu::ShaderModule;

    /// Checks that a pass draws to nothing that draws still wait to read in a pass of the user's.
    fn check(&mut self, pass: &Pass) -> Result<()>;

    /// The error for a pass of the user's that is drawn to, or read, as if it were a texture.
    fn not_a_texture(&self, pass: &str, desc: &TextureDesc) -> Error;

    /// Checks that a pass asks nothing of a pass of the user's that only its beginning can do; answers what
    /// the target is.
    fn target(&self, pass: &Pass, desc: TextureDesc) -> Result<TextureDesc>;

    /// Notes that draws, until that flag is set or dropped, wait to read these textures.
    fn note(&mut self, drawn: Weak<AtomicBool>, reads: Vec<TextureId>);
}

/// Draws that wait for their pass, and the textures that they read there.
#[derive(Default)]
struct Waiting(Vec<(Weak<AtomicBool>, Vec<TextureId>)>);

impl Inside for Waiting {
    fn module(&self, device: &wgpu::Device, program: Program) -> wgpu::ShaderModule {
        let entry = "fn fragment_main(@builtin(position)position:vec4f";
        let text = program.wgsl().replace(entry, &[entry, ",@builtin(sample_index)sample:u32"].concat());
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("welkin, by sample"),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        })
    }

    fn check(&mut self, pass: &Pass) -> Result<()> {
        self.0.retain(|(drawn, _)| drawn.upgrade().is_some_and(|drawn| !drawn.load(Ordering::Relaxed)));
        if self.0.iter().any(|(_, reads)| reads.contains(&pass.target.color)) {
            let value = "drawn again, while an InPass that reads it waits for its pass";
            let allowed = "a SkyRenderer for each view of one pass, or InPass::draw before the next view";
            return Err(Error::invalid(pass.label, value, allowed));
        }
        Ok(())
    }

    fn not_a_texture(&self, pass: &str, desc: &TextureDesc) -> Error {
        let value = format_args!("{} (a pass of the user's)", desc.label);
        let allowed = "a texture; draw in a pass with WgpuBackend::encode_in";
        Error::invalid(format_args!("pass {pass}"), value, allowed)
    }

    fn target(&self, pass: &Pass, desc: TextureDesc) -> Result<TextureDesc> {
        check_open(&pass.target, desc.label)?;
        Ok(desc)
    }

    fn note(&mut self, drawn: Weak<AtomicBool>, reads: Vec<TextureId>) {
        self.0.push((drawn, reads));
    }
}

/// What is to be drawn inside a pass of the user's, by [`WgpuBackend::encode_in`]: in the encoder that it was
/// made for, once. The scissor stays as it is; afterwards the pipeline and bind group 0 are others, and the
/// viewport is [`Target::viewport`](crate::gpu::Target::viewport) where that is given, else as it was.
#[derive(Debug)]
#[must_use = "what is not drawn in the pass is not there"]
pub struct InPass {
    draws: Vec<Draw>,
    drawn: Arc<AtomicBool>,
}

impl InPass {
    /// Draws in a render pass.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.drawn.store(true, Ordering::Relaxed);
        self.draws.iter().for_each(|draw| draw.draw(pass));
    }

    /// Draws in a render bundle, which is good for that encoder's pass and not for another frame's. A bundle
    /// has no viewport: set that of the targets, if they have one, in the pass that it is executed in. Drop
    /// this once it was executed: until then nobody may draw to the LUTs that it reads.
    pub fn draw_in_bundle<'a>(&'a self, bundle: &mut wgpu::RenderBundleEncoder<'a>) {
        for draw in &self.draws {
            bundle.set_pipeline(&draw.pipeline);
            bundle.set_bind_group(0, &draw.group, draw.offsets());
            bundle.draw(0..draw.vertices, 0..1);
        }
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.draws.is_empty()
    }
}

impl WgpuBackend {
    /// Makes a kind of render pass of the user's known as something to draw to: give it as the colour of a
    /// [`Target`](crate::gpu::Target) without depth and without anything to clear, and record the passes
    /// with [`Self::encode_in`]. One is enough for all passes of that kind; release it with
    /// [`Backend::destroy_texture`](crate::gpu::Backend::destroy_texture).
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a size, formats or samples that the device does not have.
    pub fn import_pass(&mut self, label: &'static str, pass: OpenPass) -> Result<TextureId> {
        let [width, height] = pass.size;
        let format = known_format(pass.color.remove_srgb_suffix()).unwrap_or(Format::Rgba16Float);
        let desc = TextureDesc::new(label, width, height, format);
        desc.validate(self.info.max_texture_size)?;
        // Textures of that kind say what is wrong with it. A bundle does not.
        let texture = |format| {
            self.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width: 4, height: 4, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: pass.samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            })
        };
        let (_, refused) = self.trial(|| (texture(pass.color), pass.depth.map(texture)));
        let features = self.device.features();
        let flags = pass.color.guaranteed_format_features(features).flags;
        let blends = flags.contains(wgpu::TextureFormatFeatureFlags::BLENDABLE)
            || features.contains(wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES);
        let refused = refused.or((!blends).then(|| "it cannot blend that color".to_owned()));
        let is_color =
            |format: wgpu::TextureFormat| !format.has_depth_aspect() && !format.has_stencil_aspect();
        let fits = is_color(pass.color) && pass.depth.is_none_or(|depth| !is_color(depth));
        let refused = refused.or((!fits).then(|| "color and depth are of the other's kind".to_owned()));
        if let Some(reason) = refused {
            let OpenPass { color, depth, samples, .. } = pass;
            let value = format_args!("{color:?} with depth {depth:?}, {samples} samples");
            let allowed = format_args!("what the device can draw to ({reason})");
            return Err(Error::invalid(format_args!("{label}.formats"), value, allowed));
        }
        self.inside.get_or_insert_with(|| Box::new(Waiting::default()));
        let open: Option<Shape> = Some((pass.color, pass.depth, pass.samples));
        let view = self.placeholder.clone();
        let (content, generation, fate) = (0, 0, None);
        Ok(self.textures.insert(Texture { desc, content, generation, fate, view, imported: true, open }))
    }

    /// Records those of the passes in a user's encoder that draw to textures, as [`Self::encode`] does, and
    /// answers what those draw that are for a pass of the user's ([`Self::import_pass`]): begin it in the
    /// same encoder, then call [`InPass::draw`]. Views that are drawn in one pass need a
    /// [`SkyRenderer`](crate::SkyRenderer) each: the second's LUTs would be drawn over the first's before the
    /// pass begins, which is an error.
    ///
    /// ```no_run
    /// # fn frame(backend: &mut welkin::gpu::wgpu::WgpuBackend, sky: &mut welkin::SkyRenderer,
    /// #          scene: &welkin::Scene, encoder: &mut wgpu::CommandEncoder,
    /// #          mine: wgpu::RenderPassDescriptor) -> welkin::Result<()> {
    /// use welkin::FrameTargets;
    /// use welkin::gpu::{Target, wgpu::OpenPass};
    ///
    /// let (color, depth) = (wgpu::TextureFormat::Rgba16Float, Some(wgpu::TextureFormat::Depth24Plus));
    /// let pass = OpenPass { size: [1280, 720], color, depth, samples: 4 };
    /// let target = backend.import_pass("my pass", pass)?; // Once.
    ///
    /// let frame = sky.frame(backend, scene, &FrameTargets::background(Target::color(target)))?;
    /// let background = backend.encode_in(encoder, frame.background)?;
    /// let mut pass = encoder.begin_render_pass(&mine);
    /// background.draw(&mut pass);
    /// // Here draw your scene in the same pass.
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    /// As for [`Self::encode`], before anything is recorded.
    pub fn encode_in(&mut self, encoder: &mut wgpu::CommandEncoder, passes: &[Pass]) -> Result<InPass> {
        self.check()?;
        for pass in passes {
            self.prepare(pass)?;
        }
        let mut draws = Vec::new();
        let is_open =
            |this: &Self, pass: &Pass| this.textures.get(pass.target.color).is_some_and(|t| t.open.is_some());
        let mut rest = passes;
        while let Some(first) = rest.first() {
            let open = is_open(self, first);
            let count = rest.iter().take_while(|pass| is_open(self, pass) == open).count();
            let (run, others) = rest.split_at(count);
            rest = others;
            if open {
                self.draws(encoder, run, &mut draws)?;
            } else {
                self.encode(encoder, run)?;
            }
        }
        let drawn = Arc::new(AtomicBool::new(false));
        let inside = passes.iter().filter(|pass| is_open(self, pass));
        let reads = inside.flat_map(|pass| pass.inputs.iter().filter_map(|(_, id)| id)).collect();
        if let Some(inside) = &mut self.inside {
            inside.note(Arc::downgrade(&drawn), reads);
        }
        Ok(InPass { draws, drawn })
    }

    /// Prepares passes that draw in a pass of the user's.
    fn draws(&mut self, encoder: &wgpu::CommandEncoder, passes: &[Pass], out: &mut Vec<Draw>) -> Result<()> {
        if self.recordings.reserve(&self.device, encoder, passes.len() as u32, false)? {
            self.bind_groups.retain(|_, _| false);
        }
        for pass in passes {
            self.prepare(pass)?;
            if let Some(program) = pass.program {
                out.push(self.draw(program, pass)?);
            }
        }
        self.check()
    }
}
