//! Two planets in one picture: `cargo run --example two_planets`, Mars above the Earth's limb.
//!
//! The far one is drawn first, whole: sky, ground, air. To the near one that is part of what lies behind its
//! sky, as stars are: its frame begins with the far one's colours, and with a depth buffer that is cleared.
//! Each planet has a [`SkyRenderer`] and a [`Scene`] of its own, with the same camera.

use glam::{DVec2, DVec3};
use welkin::frame::tone_map::{srgb_encode, tone_map};
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, Pass, Target, TextureDesc, TextureId};
use welkin::{
    AerialTargets, AtmosphereParams, Camera, DepthConvention, FrameTargets, Scene, SkyRenderer, SkySettings,
    ToneMap, ray_sphere_intersect,
};

/// The two planets as one camera sees them, the far one first.
pub fn scenes(altitude: f64, pitch: f64, fov: f64) -> [Scene; 2] {
    let (earth, mars) = (AtmosphereParams::earth(), AtmosphereParams::mars());
    let position = DVec3::Z * (earth.planet_radius + altitude);
    let (sin, cos) = pitch.to_radians().sin_cos();
    let forward = DVec3::new(cos, 0.0, sin);
    let near = Scene {
        camera: Camera::new(position, forward, DVec3::Z, fov.to_radians(), 1.0),
        planet_center: DVec3::ZERO,
        atmosphere: earth,
        sun_direction: DVec3::new(-0.6, 0.5, 0.5),
        depth: DepthConvention::default(),
        moon: None,
        ellipsoid: None,
    };
    // Ten of its radii away, its middle half a radius above the picture's.
    let up = forward.cross(DVec3::Y);
    let center = position + forward * (10.0 * mars.planet_radius) - up * (0.5 * mars.planet_radius);
    [Scene { planet_center: center, atmosphere: mars, ..near.clone() }, near]
}

/// Textures of a picture: colours and depth that grounds are drawn to, and colours with the air before them.
pub struct Textures {
    /// Radiance: what is behind, the sky, the ground.
    pub color: TextureId,
    /// Distances of the ground, as [`Scene::depth`] stores them.
    pub depth: TextureId,
    /// The colours with the air before them.
    pub out: TextureId,
}

impl Textures {
    /// Those of a picture of a size in pixels.
    pub fn new(backend: &mut dyn Backend, size: [u32; 2]) -> welkin::Result<Self> {
        let mut make =
            |label, format| backend.create_texture(&TextureDesc::new(label, size[0], size[1], format));
        Ok(Self {
            color: make("color", Format::Rgba32Float)?,
            depth: make("depth", Format::R32Float)?,
            out: make("out", Format::Rgba32Float)?,
        })
    }
}

/// Draws a planet over what the colours hold; answers the texture that then holds all of it. `ground` draws
/// yours, with depth, over what is there.
pub fn planet(
    backend: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    textures: &Textures,
    ground: impl FnOnce(&mut dyn Backend) -> welkin::Result<()>,
) -> welkin::Result<TextureId> {
    let &Textures { color, depth, out } = textures;
    let air = AerialTargets { color: Some(color), depth, target: Target::color(out) };
    // Not cleared: what is behind the sky is there already.
    let targets = FrameTargets::background(Target::color(color)).with_aerial(air);
    let frame = sky.frame(backend, scene, &targets)?;
    let aerial = frame.aerial.to_vec();
    backend.run(frame.background)?;
    ground(backend)?;
    backend.run(&aerial)?;
    Ok(if aerial.is_empty() { color } else { out })
}

/// Both planets before black: the far one first, and the near one over it.
pub fn both(
    backend: &mut dyn Backend,
    skies: &mut [SkyRenderer; 2],
    scenes: &[Scene; 2],
    textures: [&Textures; 2],
    size: [u32; 2],
    albedo: f32,
) -> welkin::Result<TextureId> {
    let [far, near] = textures;
    let black = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(far.color) };
    backend.run(&[Pass::clear("space", black)])?;
    let seen = planet(backend, &mut skies[0], &scenes[0], far, |b| ground(b, &scenes[0], far, size, albedo))?;
    // The near planet's colours begin as the far planet's end, its depth with nothing.
    let colors = backend.read(seen)?;
    backend.write_texture(near.color, &colors)?;
    planet(backend, &mut skies[1], &scenes[1], near, |b| ground(b, &scenes[1], near, size, albedo))
}

/// Stands for a planet's mesh: a sphere of one radiance, drawn on the CPU.
fn ground(
    backend: &mut dyn Backend,
    scene: &Scene,
    textures: &Textures,
    [w, h]: [u32; 2],
    radiance: f32,
) -> welkin::Result<()> {
    let basis = scene.camera.basis()?;
    let mut colors = backend.read(textures.color)?;
    let mut depths = Vec::with_capacity((w * h) as usize);
    let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    for (i, pixel) in (0..w * h).zip(colors.chunks_exact_mut(4)) {
        let ray = basis.ray(DVec2::new(share(i % w, w), -share(i / w, h)));
        let camera = scene.camera.position - scene.planet_center;
        let hit = ray_sphere_intersect(camera, ray.normalize(), DVec3::ZERO, scene.atmosphere.planet_radius);
        let depth = match hit.filter(|(near, _)| *near > 0.0) {
            Some((near, _)) => {
                pixel.copy_from_slice(&[radiance, radiance, radiance, 1.0]);
                scene.depth.encode(near / ray.length())
            }
            None => scene.depth.background(),
        };
        depths.push(depth as f32);
    }
    backend.write_texture(textures.color, &colors)?;
    backend.write_texture(textures.depth, &depths)
}

#[allow(dead_code)] // The tests have a main of their own.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    const SIZE: [u32; 2] = [256, 256];
    let mut backend = WgpuBackend::headless()?;
    let scenes = scenes(4e5, -18.5, 16.0);
    let new = || SkyRenderer::new(SkySettings::default());
    let mut skies = [new()?, new()?];
    let [far, near] = [Textures::new(&mut backend, SIZE)?, Textures::new(&mut backend, SIZE)?];
    let seen = both(&mut backend, &mut skies, &scenes, [&far, &near], SIZE, 0.3)?;
    let mut file = format!("P6 {} {} 255\n", SIZE[0], SIZE[1]).into_bytes();
    for pixel in backend.read(seen)?.chunks_exact(4) {
        let shown = tone_map(ToneMap::Aces, [0, 1, 2].map(|c| f64::from(pixel[c])));
        file.extend(shown.map(|v| (srgb_encode(v) * 255.0).round() as u8));
    }
    std::fs::write("two_planets.ppm", file)?;
    println!("two_planets.ppm: drawn by {}", backend.info().adapter);
    Ok(())
}
