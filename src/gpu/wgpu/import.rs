//! Textures of the user's: what can be wrong with them is found when they are handed over, by name, and not
//! by the device's handler for errors in the middle of a frame.

use super::{Texture, WgpuBackend, format};
use crate::error::{Error, Result};
use crate::gpu::{Format, TextureDesc, TextureId};

/// The error for a pass whose texture was made without a usage.
pub(super) fn lacks(pass: &str, what: &str, usage: &str) -> Error {
    Error::invalid(
        format_args!("pass {pass}: {what}"),
        format_args!("a texture without the usage {usage}"),
        format_args!("a texture that was made with wgpu::TextureUsages::{usage}"),
    )
}

/// The format of this crate for one of wgpu's.
pub(crate) fn known_format(of: wgpu::TextureFormat) -> Result<Format> {
    let all = [
        Format::Rgba8,
        Format::Bgra8,
        Format::Rgba16Float,
        Format::Rgba32Float,
        Format::R32Float,
        Format::Depth32Float,
    ];
    all.into_iter().find(|f| format(*f) == of).ok_or_else(|| {
        let value = format_args!("{of:?}");
        let same = of.remove_srgb_suffix();
        if same != of {
            let allowed = format_args!(
                "{same:?}, as passes write what a display wants already: import a view of that format, and \
                 name it among the texture's view_formats; or draw in a pass of yours \
                 (WgpuBackend::import_pass), for the device to encode"
            );
            return Error::invalid("texture.format", value, allowed);
        }
        let allowed = format_args!(
            "one of {all:?}; to others a device can draw in a pass of yours (WgpuBackend::import_pass)"
        );
        Error::invalid("texture.format", value, allowed)
    })
}

impl WgpuBackend {
    /// Makes a user's texture known, whole: size and format are its own. Release it with
    /// [`Backend::destroy_texture`](crate::gpu::Backend::destroy_texture), which leaves the texture alone.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for more than one sample, layer, level or dimension than a plain picture
    /// has, and for a format that [`Format`] lacks, sRGB among them.
    pub fn import_texture(&mut self, label: &'static str, texture: &wgpu::Texture) -> Result<TextureId> {
        let desc =
            TextureDesc::new(label, texture.width(), texture.height(), known_format(texture.format())?);
        for (name, value) in
            [("layers", texture.depth_or_array_layers()), ("mip levels", texture.mip_level_count())]
        {
            if value != 1 {
                return Err(Error::invalid(name, value, "1, or else import a view of one"));
            }
        }
        self.import_view(texture.create_view(&Default::default()), desc)
    }

    /// Makes a user's view known as a texture; release it with
    /// [`Backend::destroy_texture`](crate::gpu::Backend::destroy_texture). A view has one layer and one mip
    /// level, whose size `desc` gives.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a `desc` that is out of range, of another size than any mip level of
    /// the view's texture, or of another format; for a texture with several samples a pixel, or with neither
    /// of the usages `RENDER_ATTACHMENT` and `TEXTURE_BINDING`. Natively also for a view that nothing can be
    /// drawn to as its texture's usages promise: of an sRGB format, say, as passes write what a display wants
    /// already. A browser tells that in its console, when it is drawn to. On a device of the backend's own
    /// ([`WgpuBackend::new`]) only the range is checked: what that device objects to is the next call's
    /// error.
    pub fn import_view(&mut self, view: wgpu::TextureView, desc: TextureDesc) -> Result<TextureId> {
        desc.validate(self.info.max_texture_size)?;
        if let Some(check) = self.check_import {
            check(self, &view, &desc)?;
        }
        Ok(self.textures.insert(Texture {
            desc,
            content: 0,
            generation: 0,
            fate: None,
            view,
            imported: true,
            open: None,
        }))
    }

    /// Checks what is promised of a view.
    pub(super) fn check_view(&self, view: &wgpu::TextureView, desc: &TextureDesc) -> Result<()> {
        let texture = view.texture();
        if format(desc.format) != texture.format().remove_srgb_suffix() {
            let allowed = format_args!("that of the view's texture, {:?}", texture.format());
            return Err(Error::invalid("format", format_args!("{:?}", desc.format), allowed));
        }
        let (width, height) = (texture.width(), texture.height());
        let is_level =
            |level: u32| (desc.width, desc.height) == ((width >> level).max(1), (height >> level).max(1));
        if !(0..texture.mip_level_count()).any(is_level) {
            let given = format_args!("{} × {}", desc.width, desc.height);
            let allowed = format_args!("that of the view: its texture has {width} × {height}");
            return Err(Error::invalid("size", given, allowed));
        }
        if texture.sample_count() != 1 {
            let allowed = "1: draw in a pass of yours (WgpuBackend::import_pass), to a texture of one sample \
                           a pixel, or to the one that yours resolves to";
            return Err(Error::invalid("sample count", texture.sample_count(), allowed));
        }
        let drawn_to = texture.usage().contains(wgpu::TextureUsages::RENDER_ATTACHMENT);
        if !drawn_to && !texture.usage().contains(wgpu::TextureUsages::TEXTURE_BINDING) {
            let allowed = "RENDER_ATTACHMENT to draw to it, TEXTURE_BINDING to read it, or both";
            return Err(Error::invalid("usage", format_args!("{:?}", texture.usage()), allowed));
        }
        if drawn_to && let Some(reason) = self.try_to_draw(view, desc.format) {
            if reason.contains("Srgb") {
                let wanted = format(desc.format);
                let allowed = format_args!(
                    "one of {wanted:?}: passes write what a display wants already; or draw in a pass of \
                     yours (WgpuBackend::import_pass), for the device to encode"
                );
                return Err(Error::invalid("view", "an sRGB view", allowed));
            }
            let value = format_args!("a view of {}", desc.label);
            let allowed = format_args!("one that passes can draw to as {:?} ({reason})", desc.format);
            return Err(Error::invalid("view", value, allowed));
        }
        Ok(())
    }

    /// Does something that the device may object to; answers what it says. In a browser, which says so later,
    /// the device's own handler is told instead.
    pub(super) fn trial<T>(&self, f: impl FnOnce() -> T) -> (T, Option<String>) {
        #[cfg(not(target_arch = "wasm32"))]
        {
            let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
            let made = f();
            (made, pollster::block_on(scope.pop()).map(|e| one_line(&e.to_string())))
        }
        #[cfg(target_arch = "wasm32")]
        (f(), None)
    }

    /// Records a pass that draws next to nothing to a view, and forgets it; answers what the device objects
    /// to.
    fn try_to_draw(&self, view: &wgpu::TextureView, of: Format) -> Option<String> {
        if cfg!(target_arch = "wasm32") {
            return None;
        }
        let operations = wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store };
        let is_depth = of == Format::Depth32Float;
        let colors = [Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: operations,
        })];
        let depth = wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        };
        let (_, refused) = self.trial(|| {
            let mut encoder = self.encoder();
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("welkin import"),
                color_attachments: if is_depth { &[] } else { &colors },
                depth_stencil_attachment: is_depth.then_some(depth),
                ..Default::default()
            });
            if !is_depth {
                // A bundle says what it can be drawn to, as a pipeline does, and needs no shader.
                let bundle = self.device.create_render_bundle_encoder(&wgpu::RenderBundleEncoderDescriptor {
                    label: Some("welkin import"),
                    color_formats: &[Some(format(of))],
                    depth_stencil: None,
                    sample_count: 1,
                    multiview: None,
                });
                pass.execute_bundles([&bundle.finish(&Default::default())]);
            }
            drop(pass);
            encoder.finish()
        });
        refused
    }
}

/// The last part of what wgpu says, which tells what is wrong; the others tell where.
#[cfg(not(target_arch = "wasm32"))]
fn one_line(message: &str) -> String {
    let last = message.lines().map(str::trim).rfind(|line| !line.is_empty());
    last.unwrap_or("no reason given").to_owned()
}
