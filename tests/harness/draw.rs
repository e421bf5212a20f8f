//! Drawing: textures, passes and pictures, by a renderer of the test's or by a new one.

use welkin::gpu::{Backend, DepthUse, Format, Pass, Target, TextureDesc, TextureId, Uniform, reads};
use welkin::shaders::Program;
use welkin::{
    LutSettings, Method, PictureRenderer, PictureSettings, Quality, Scene, SkyRenderer, SkySettings,
};

/// Small LUTs, for what does not depend on how exact they are.
pub const TINY: LutSettings = LutSettings {
    columns: [16, 8],
    moments: [8, 8],
    moment_steps: 4,
    orders: 3,
    sky: [8, 12],
    sky_steps: 4,
    air: [4, 8, 4],
    air_steps: 1,
};

/// A march with so many samples along a ray and towards the sun.
pub fn march(view_samples: u32, light_samples: u32) -> Method {
    Method::Single { view_samples, light_samples }
}

/// The sky by a method, without the sun's disk.
pub fn sky(method: Method) -> SkySettings {
    SkySettings { method, sun_disk: false, ..SkySettings::default() }
}

/// The sky by LUTs, without the sun's disk.
pub fn luts(lut: LutSettings) -> SkySettings {
    sky(Method::Lut(lut))
}

/// The sky in a quality, without the sun's disk.
pub fn in_quality(quality: Quality) -> SkySettings {
    SkySettings { sun_disk: false, ..quality.into() }
}

/// The method of a quality.
pub fn method_of(quality: Quality) -> Method {
    SkySettings::from(quality).method
}

/// The picture of a sky alone over black, in 32-bit floats.
pub fn over_black(sky: SkySettings) -> PictureSettings {
    PictureSettings { sky, terrain: None, radiance: Format::Rgba32Float, ..PictureSettings::default() }
}

/// A new texture.
pub fn texture(b: &mut dyn Backend, label: &'static str, [w, h]: [u32; 2], format: Format) -> TextureId {
    b.create_texture(&TextureDesc::new(label, w, h, format)).unwrap()
}

/// A new texture for radiance in 32-bit floats.
pub fn target(b: &mut dyn Backend, size: [u32; 2]) -> TextureId {
    texture(b, "target", size, Format::Rgba32Float)
}

/// Textures that a frame needs: colour, the scene's depth as numbers, and what the air's pass draws to.
pub fn frame_textures(b: &mut dyn Backend, size: [u32; 2]) -> [TextureId; 3] {
    let color = texture(b, "color", size, Format::Rgba32Float);
    let depth = texture(b, "depth", size, Format::R32Float);
    let out = texture(b, "out", size, Format::Rgba32Float);
    [color, depth, out]
}

/// Frees textures.
pub fn free<const N: usize>(b: &mut dyn Backend, textures: [TextureId; N]) {
    textures.into_iter().for_each(|id| b.destroy_texture(id));
}

/// Waits until all that was run is drawn. A test that draws hundreds of frames and reads none must do so now and
/// then: a driver in software keeps megabytes for each frame that it has not come to yet.
pub fn finish(b: &mut dyn Backend) {
    let pixel = target(b, [1, 1]);
    b.read(pixel).unwrap();
    b.destroy_texture(pixel);
}

/// A target that is cleared to opaque black first.
pub fn cleared(color: TextureId) -> Target {
    Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(color) }
}

/// A pass that only clears.
pub fn clear_pass(color: TextureId, clear: [f32; 4]) -> Pass {
    Pass {
        label: "clear",
        program: None,
        textures: reads([]),
        uniform: Uniform::NONE,
        target: Target { clear: Some(clear), ..Target::color(color) },
        depth: DepthUse::Always,
    }
}

/// A pass that copies a texture of colours or of depth.
pub fn copy_pass(b: &mut dyn Backend, from: TextureId, to: TextureId) -> Pass {
    Pass {
        label: "copy",
        program: Some(b.create_program(Program::Copy).unwrap()),
        textures: reads([from]),
        uniform: Uniform::NONE,
        target: Target::color(to),
        depth: DepthUse::Always,
    }
}

/// The passes behind a scene.
pub fn background_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    target: Target,
) -> Vec<Pass> {
    sky.background(b, scene, target).unwrap().to_vec()
}

/// The passes of the air before a scene, with its colour and depth, into a third texture.
pub fn aerial_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    [color, depth, out]: [TextureId; 3],
) -> Vec<Pass> {
    sky.aerial(b, scene, color, depth, out).unwrap().to_vec()
}

/// The passes of the planet's shell over a scene.
pub fn shell_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    depth: TextureId,
    target: Target,
) -> Vec<Pass> {
    sky.shell(b, scene, depth, target).unwrap().to_vec()
}

/// The background alone over a colour, by a new renderer, in 32-bit floats.
pub fn background(
    b: &mut dyn Backend,
    scene: &Scene,
    settings: SkySettings,
    size: [u32; 2],
    clear: [f32; 4],
) -> Vec<f32> {
    let mut sky = SkyRenderer::new(settings).unwrap();
    let pixels = background_by(b, &mut sky, scene, size, clear);
    sky.destroy(b);
    pixels
}

/// The background alone over a colour, by a renderer that may have drawn others, in 32-bit floats.
pub fn background_by(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    size: [u32; 2],
    clear: [f32; 4],
) -> Vec<f32> {
    let color = target(b, size);
    let mut passes = vec![clear_pass(color, clear)];
    passes.extend(background_passes(b, sky, scene, Target::color(color)));
    b.run(&passes).unwrap();
    let pixels = b.read(color).unwrap();
    b.destroy_texture(color);
    pixels
}

/// A whole picture's radiance, by a renderer that may have drawn others.
pub fn draw(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    settings: &PictureSettings,
    size: [u32; 2],
) -> Vec<f32> {
    let drawn = renderer.draw(b, scene, settings, size).unwrap();
    b.read(drawn.radiance).unwrap()
}

/// A whole picture's radiance and display values, by a renderer that may have drawn others.
pub fn draw_both(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    settings: &PictureSettings,
    size: [u32; 2],
) -> [Vec<f32>; 2] {
    let drawn = renderer.draw(b, scene, settings, size).unwrap();
    [drawn.radiance, drawn.display].map(|id| b.read(id).unwrap())
}

/// A whole picture's radiance, by a new renderer.
pub fn picture(b: &mut dyn Backend, scene: &Scene, settings: &PictureSettings, size: [u32; 2]) -> Vec<f32> {
    let mut renderer = PictureRenderer::default();
    let pixels = draw(b, &mut renderer, scene, settings, size);
    renderer.destroy(b);
    pixels
}

/// The passes of a whole picture.
pub fn picture_passes(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    settings: &PictureSettings,
    size: [u32; 2],
) -> Vec<Pass> {
    renderer.passes(b, scene, settings, size).unwrap().0.to_vec()
}
