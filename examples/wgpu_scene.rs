//! A scene of one's own in a sky, with wgpu: `cargo run --example wgpu_scene`.
//!
//! A program with a window has its device, its surface and its loop; what is welkin's are the lines of
//! [`frame`]. This one has no window: it draws one frame, a column before a low sun, to `wgpu_scene.ppm`.

use glam::DVec3;
use welkin::{AtmosphereParams, Camera, DepthConvention, PictureSettings, Scene, WgpuSky};

/// Pixels.
pub const SIZE: [u32; 2] = [96, 64];

/// A metre and a half above the north pole, looking along +X, where the sun is 12° high.
pub fn scene() -> Scene {
    let earth = AtmosphereParams::earth();
    let position = DVec3::Z * (earth.planet_radius + 1.5);
    Scene {
        camera: Camera::new(position, DVec3::new(1.0, 0.0, 0.1), DVec3::Z, 1.0, 1.5),
        planet_center: DVec3::ZERO,
        atmosphere: earth,
        sun_direction: DVec3::new(0.978, 0.0, 0.208),
        depth: DepthConvention::ReversedInfinite { near: 0.1 },
        moon: None,
        ellipsoid: None,
    }
}

/// One frame: clear, sky, `my_pass`, air, tone mapping.
pub fn frame(
    sky: &mut WgpuSky,
    encoder: &mut wgpu::CommandEncoder,
    output: &wgpu::TextureView,
    my_pass: impl FnOnce(&mut wgpu::RenderPass<'_>),
) -> welkin::Result<()> {
    sky.draw(encoder, output, &scene(), |encoder, frame| my_pass(&mut frame.begin(encoder)))
}

/// A pipeline of the user's: a column 3 km away, lit by the sun, in linear radiance.
pub fn column(device: &wgpu::Device, scene: &Scene) -> wgpu::RenderPipeline {
    let depth = scene.depth.encode(3e3);
    let shader = format!(
        "@vertex fn v(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {{
            let corner = vec2f(f32(i & 1u), f32(i >> 1u));
            return vec4f(corner * vec2f(0.3, 1.2) - vec2f(0.6, 0.9), {depth}, 1.0);
        }}
        @fragment fn f() -> @location(0) vec4f {{ return vec4f(0.5, 0.4, 0.3, 1.0); }}"
    );
    let source = wgpu::ShaderSource::Wgsl(shader.into());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("column"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: WgpuSky::DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            targets: &[Some(WgpuSky::COLOR.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// What a window's surface would give: a texture of 8 bits.
pub fn output(device: &wgpu::Device) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("output"),
        size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The bytes of the output, row by row from the top; rows of [`SIZE`] are a multiple of what wgpu copies.
pub fn read(device: &wgpu::Device, queue: &wgpu::Queue, texture: &wgpu::Texture) -> Vec<u8> {
    let row = (4 * SIZE[0]).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(row * SIZE[1]),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), to, texture.size());
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |result| result.expect("a buffer to read"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that is there");
    let bytes = buffer.get_mapped_range(..).expect("a mapped buffer");
    bytes.chunks_exact(row as usize).flat_map(|line| line[..4 * SIZE[0] as usize].to_vec()).collect()
}

#[allow(dead_code)] // The tests have a main of their own.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
    let mut sky = WgpuSky::new(&device, &queue, PictureSettings::default())?;
    let (column, output) = (column(&device, &scene()), output(&device));
    let mut encoder = device.create_command_encoder(&Default::default());
    frame(&mut sky, &mut encoder, &output.create_view(&Default::default()), |pass| {
        pass.set_pipeline(&column);
        pass.draw(0..4, 0..1);
    })?;
    queue.submit([encoder.finish()]);
    let mut file = format!("P6 {} {} 255\n", SIZE[0], SIZE[1]).into_bytes();
    file.extend(read(&device, &queue, &output).chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    std::fs::write("wgpu_scene.ppm", file)?;
    println!("wgpu_scene.ppm: drawn by {}", adapter.get_info().name);
    Ok(())
}
