//! A glass sphere in the sky, with wgpu: `cargo run --example wgpu_glass`.
//!
//! The sphere mirrors the sky and lies behind 2 km of air. It is drawn after the air before the scene, by a
//! shader that calls welkin's functions: [`GLASS`]. The picture goes to `wgpu_glass.ppm`.

use welkin::{Look, PictureSettings, SkySettings, WgpuSky, shaders};

#[allow(dead_code)] // Of the other example the scene, the output and how to read it.
#[path = "wgpu_scene.rs"]
pub mod wgpu_scene;
use wgpu_scene::{SIZE, output, read, scene};

/// The sphere: metres from the camera, to its middle in the axes of the scene, and its radius. It stands 2 km
/// away and is large enough to be seen.
pub const SPHERE: ([f64; 3], f64) = ([2000.0, 800.0, 600.0], 420.0);

/// What the sphere does to light, between functions of welkin's: the ray's meeting with it, the
/// reflection of coated glass after Schlick, what is mirrored and what the air does on the way.
const GLASS: &str = "
@fragment fn glass(@location(0) ray: vec3f) -> @location(0) vec4f {
    let direction = normalize(ray);
    let along = dot(direction, MIDDLE);
    let inside = RADIUS * RADIUS - (dot(MIDDLE, MIDDLE) - along * along);
    if inside < 0.0 { discard; }
    let distance = along - sqrt(inside);
    let normal = (direction * distance - MIDDLE) / RADIUS;
    let reflectance = 0.15 + 0.85 * pow(1.0 - max(dot(-direction, normal), 0.0), 5.0);
    let air = welkin_aerial(direction, distance);
    let mirrored = welkin_sky(reflect(direction, normal)) * air.transmittance + air.inscatter;
    return vec4f(mirrored * reflectance, reflectance);
}";

/// A triangle over the whole picture, with the camera's ray through each pixel in the axes of the scene.
const RAYS: &str = "
struct Ray { @builtin(position) position: vec4f, @location(0) ray: vec3f }
@vertex fn rays(@builtin(vertex_index) i: u32) -> Ray {
    let ndc = vec2f(f32((i << 1u) & 2u), f32(i & 2u)) * 2.0 - 1.0;
    return Ray(vec4f(ndc, DEPTH, 1.0), FORWARD + RIGHT * ndc.x + UP * ndc.y);
}";

/// The pipeline. Group 0 is welkin's here; with groups of your own, give the number of another to
/// `shaders::scene::wgsl`, `AirGroup::bind` and the pipeline's layout.
pub fn glass(sky: &mut WgpuSky, device: &wgpu::Device) -> welkin::Result<wgpu::RenderPipeline> {
    let (scene, (middle, radius)) = (scene(), SPHERE);
    let camera = scene.camera.basis()?;
    let vec3 = |v: glam::DVec3| format!("vec3f({:?}, {:?}, {:?})", v.x, v.y, v.z);
    let text = [RAYS, GLASS].concat().replace("DEPTH", &format!("{:?}", scene.depth.encode(middle[0])));
    let text = text.replace("MIDDLE", &vec3(middle.into())).replace("RADIUS", &format!("{radius:?}"));
    let text = text.replace("FORWARD", &vec3(camera.forward));
    let text = text.replace("RIGHT", &vec3(camera.right)).replace("UP", &vec3(camera.up));
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("glass"),
        source: wgpu::ShaderSource::Wgsl(shaders::scene::wgsl(0, &text).into()),
    });
    let air = sky.backend().air_layout()?;
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("glass"),
        bind_group_layouts: &[Some(&air)],
        immediate_size: 0,
    });
    Ok(device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("glass"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: WgpuSky::DEPTH,
            depth_write_enabled: Some(false),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: WgpuSky::COLOR,
                blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    }))
}

/// Settings whose air a scene's own shaders read.
pub fn settings() -> PictureSettings {
    let look = Look { scene_shaders: true, ..Look::default() };
    PictureSettings { sky: SkySettings { look, ..SkySettings::default() }, ..PictureSettings::default() }
}

/// One frame: clear, sky, (nothing opaque,) air, the sphere, tone mapping.
pub fn frame(
    sky: &mut WgpuSky,
    encoder: &mut wgpu::CommandEncoder,
    output: &wgpu::TextureView,
    glass: &wgpu::RenderPipeline,
) -> welkin::Result<()> {
    sky.draw_layers(
        encoder,
        output,
        &scene(),
        |_, _| {},
        |encoder, frame| {
            let mut pass = frame.begin(encoder);
            pass.set_pipeline(glass);
            frame.air.expect("look.scene_shaders is on").bind(&mut pass, 0);
            pass.draw(0..3, 0..1);
        },
    )
}

#[allow(dead_code)] // The tests have a main of their own.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
    let mut sky = WgpuSky::new(&device, &queue, settings())?;
    let (glass, output) = (glass(&mut sky, &device)?, output(&device));
    let mut encoder = device.create_command_encoder(&Default::default());
    frame(&mut sky, &mut encoder, &output.create_view(&Default::default()), &glass)?;
    queue.submit([encoder.finish()]);
    let mut file = format!("P6 {} {} 255\n", SIZE[0], SIZE[1]).into_bytes();
    file.extend(read(&device, &queue, &output).chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    std::fs::write("wgpu_glass.ppm", file)?;
    println!("wgpu_glass.ppm: drawn by {}", adapter.get_info().name);
    Ok(())
}
