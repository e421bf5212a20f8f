//! Drawing: textures, passes and pictures, by a renderer of the test's or by a new one.

use welkin::gpu::{Backend, Format, Inputs, Pass, Program, Target, TextureDesc, TextureId};
use welkin::shaders::copy;
use welkin::{
    AerialTargets, Composition, FrameTargets, Look, LutSettings, PictureRenderer, PictureSettings, Quality,
    Scene, SkyRenderer, SkySettings,
};

/// Small LUTs, for what does not depend on how exact they are.
pub const TINY: LutSettings = LutSettings {
    transmittance: [16, 8],
    multi_scattering: [8, 8],
    multi_scattering_steps: 4,
    orders: 3,
    sky_view: [8, 12],
    sky_view_steps: 4,
    aerial: [4, 8, 4],
    aerial_steps: 1,
};

/// A march with so many samples along a ray and towards the sun.
pub fn march(view_samples: u32, light_samples: u32) -> Quality {
    Quality::March { view_samples, light_samples }
}

/// The sky by a method, without the sun's disk.
pub fn sky(quality: Quality) -> SkySettings {
    without_disk(quality.into())
}

/// The same with or without the sun's disk.
pub fn with_disk(sun_disk: bool, sky: SkySettings) -> SkySettings {
    SkySettings { look: Look { sun_disk, ..sky.look }, ..sky }
}

/// The same without the sun's disk.
pub fn without_disk(sky: SkySettings) -> SkySettings {
    with_disk(false, sky)
}

/// The same by another composition.
pub fn composed(composition: Composition, sky: SkySettings) -> SkySettings {
    SkySettings { look: Look { composition, ..sky.look }, ..sky }
}

/// The sky by LUTs, without the sun's disk.
pub fn luts(lut: LutSettings) -> SkySettings {
    sky(Quality::Luts(lut))
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

/// Waits until all that was run is drawn. A test that draws hundreds of frames and reads none must do so now
/// and then: a driver in software keeps megabytes for each frame that it has not come to yet.
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
    Pass::clear("clear", Target { clear: Some(clear), ..Target::color(color) })
}

/// A pass that copies a texture of colours or of depth.
pub fn copy_pass(b: &mut dyn Backend, from: TextureId, to: TextureId) -> Pass {
    let program = Some(b.create_program(Program::new(&copy::INFO, 0)).unwrap());
    let inputs = Inputs::new([("source", Some(from))]);
    Pass { program, inputs, ..Pass::clear("copy", Target::color(to)) }
}

/// The passes behind a scene.
pub fn background_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    target: Target,
) -> Vec<Pass> {
    sky.frame(b, scene, &FrameTargets::background(target)).unwrap().background.to_vec()
}

/// The passes before a scene alone: LUTs that they read, then the air.
fn over_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    aerial: AerialTargets,
) -> Vec<Pass> {
    let targets = FrameTargets { aerial: Some(aerial), ..FrameTargets::default() };
    let frame = sky.frame(b, scene, &targets).unwrap();
    [frame.background, frame.aerial].concat()
}

/// The passes of the air before a scene, with its colour and depth, into a third texture. None where the
/// composition lays it over the scene.
pub fn aerial_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    [color, depth, out]: [TextureId; 3],
) -> Vec<Pass> {
    if sky.settings().look.composition == Composition::Planet {
        return Vec::new();
    }
    over_passes(b, sky, scene, AerialTargets { color: Some(color), depth, target: Target::color(out) })
}

/// The passes of the planet's shell over a scene; none where the composition reads the scene's colour.
pub fn shell_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    depth: TextureId,
    target: Target,
) -> Vec<Pass> {
    if sky.settings().look.composition != Composition::Planet {
        return Vec::new();
    }
    over_passes(b, sky, scene, AerialTargets { color: None, depth, target })
}

/// All passes of one frame, and the texture that they leave it in.
pub fn frame_passes(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    background: Target,
    [color, depth, out]: [TextureId; 3],
) -> (Vec<Pass>, TextureId) {
    let over = sky.settings().look.composition == Composition::Planet;
    let (read, target) = if over { (None, color) } else { (Some(color), out) };
    let aerial = AerialTargets { color: read, depth, target: Target::color(target) };
    let frame = sky.frame(b, scene, &FrameTargets::background(background).with_aerial(aerial)).unwrap();
    ([frame.background, frame.aerial].concat(), frame.color)
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
