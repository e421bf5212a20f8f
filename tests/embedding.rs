//! In somebody else's frame: the user's own device, encoder and views; the user's own context, with its
//! state as it was; loss; and nothing left behind.
#![cfg(all(feature = "egl", feature = "translate", feature = "reference"))]
#![allow(unsafe_code)] // The test plays the user, who calls OpenGL.

mod common;

use common::{View, on_both};
use glow::HasContext as _;
use welkin::gpu::egl::Headless;
use welkin::gpu::webgl::WebGlBackend;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, RowOrder, Target, TextureDesc};
use welkin::{Error, ErrorKind, Method, PictureRenderer, PictureSettings, Scene, SkyRenderer, SkySettings};

const SIZE: u32 = 32;

fn scene() -> Scene {
    View { pitch: 10.0, ..View::default() }.scene()
}

/// The background by a backend of welkin's own, RGBA8.
fn own(backend: &mut dyn Backend) -> Vec<f32> {
    let color = backend.create_texture(&TextureDesc::new("own", SIZE, SIZE, Format::Rgba8)).unwrap();
    let target = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(color) };
    let mut sky = SkyRenderer::new(SkySettings::default()).unwrap();
    let passes = sky.background(backend, &scene(), target).unwrap().to_vec();
    backend.run(&passes).unwrap();
    let pixels = backend.read(color).unwrap();
    backend.destroy_texture(color);
    pixels
}

/// A device that cannot filter 32-bit floats gets its sky tables in 16 bits.
#[test]
fn tables_of_16_bits_hold_the_light() {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("a Vulkan driver");
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default())).unwrap();
    let mut poor = WgpuBackend::from_device(device, queue, "no features").unwrap();
    let mut rich = WgpuBackend::headless().unwrap();
    assert!(!poor.info().filters_f32 && rich.info().filters_f32, "{} {}", poor.info(), rich.info());
    let settings = PictureSettings { terrain: None, ..PictureSettings::default() };
    let mut worst = 0.0_f32;
    for (altitude, pitch) in [(2.0, 10.0), (30e3, -4.0), (4e5, -18.0), (1e7, -90.0)] {
        for sun_elevation in [40.0, 2.0, -4.0] {
            let scene = View { altitude, pitch, sun_elevation, ..View::default() }.scene();
            let draw = |backend: &mut WgpuBackend| {
                let mut renderer = PictureRenderer::default();
                let drawn = renderer.draw(backend, &scene, &settings, [SIZE, SIZE]).unwrap();
                let pixels = backend.read(drawn.radiance).unwrap();
                renderer.destroy(backend);
                pixels
            };
            let [got, want] = [draw(&mut poor), draw(&mut rich)];
            let brightest = want.chunks_exact(4).flat_map(|p| &p[..3]).fold(0.0_f32, |m, v| m.max(*v));
            for (got, want) in got.iter().zip(&want) {
                worst = worst.max((got - want).abs() / want.max(1e-3 * brightest));
            }
        }
    }
    println!("16-bit tables change light by {worst:.1e} at most");
    // Roots of the fourth degree in half floats: 4 · 2^-11 in the sky's table and as much again in the air's.
    assert!(worst > 0.0 && worst < 4e-3, "{worst}");
}

#[test]
fn a_wgpu_user_hands_in_device_queue_encoder_and_view() {
    // The user's side: instance, device, texture, encoder.
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("a Vulkan driver");
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default())).unwrap();
    let extent = wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some("user's target"),
        size: extent,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Bgra8Unorm,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(256 * SIZE),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });

    let mut backend = WgpuBackend::from_device(device.clone(), queue.clone(), &adapter.get_info().name).unwrap();
    let mut sky = SkyRenderer::new(SkySettings::default()).unwrap();
    let desc = TextureDesc::new("user's target", SIZE, SIZE, Format::Bgra8);
    let id = backend.import_view(texture.create_view(&Default::default()), desc).unwrap();
    let mut encoder = device.create_command_encoder(&Default::default());
    let target = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(id) };
    let passes = sky.background(&mut backend, &scene(), target).unwrap().to_vec();
    backend.encode(&mut encoder, &passes).unwrap();
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(256), rows_per_image: None },
        },
        extent,
    );
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |r| r.unwrap());
    device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let bytes = buffer.get_mapped_range(..).unwrap().to_vec();
    backend.destroy_texture(id);

    let want = own(&mut WgpuBackend::headless().unwrap());
    for y in 0..SIZE as usize {
        for x in 0..SIZE as usize {
            let (got, want) = (&bytes[256 * y + 4 * x..][..3], &want[4 * (SIZE as usize * y + x)..][..3]);
            for c in 0..3 {
                assert!((f32::from(got[2 - c]) - want[c] * 255.0).abs() < 1.01, "{x} {y}: {got:?} {want:?}");
            }
        }
    }
}

/// Everything of a context that the backend touches, as text.
fn state(gl: &glow::Context) -> String {
    // SAFETY: queries of state that every ES 3 context has.
    unsafe {
        let mut viewport = [0; 4];
        gl.get_parameter_i32_slice(glow::VIEWPORT, &mut viewport);
        let mut clear = [0.0; 4];
        gl.get_parameter_f32_slice(glow::COLOR_CLEAR_VALUE, &mut clear);
        let numbers = [
            glow::CURRENT_PROGRAM,
            glow::VERTEX_ARRAY_BINDING,
            glow::ACTIVE_TEXTURE,
            glow::UNIFORM_BUFFER_BINDING,
            glow::PIXEL_PACK_BUFFER_BINDING,
            glow::PIXEL_UNPACK_BUFFER_BINDING,
            glow::DRAW_FRAMEBUFFER_BINDING,
            glow::READ_FRAMEBUFFER_BINDING,
            glow::DEPTH_FUNC,
            glow::DEPTH_WRITEMASK,
            glow::BLEND_SRC_RGB,
            glow::BLEND_DST_RGB,
            glow::BLEND_SRC_ALPHA,
            glow::BLEND_DST_ALPHA,
            glow::BLEND_EQUATION_RGB,
            glow::BLEND_EQUATION_ALPHA,
            glow::PACK_ALIGNMENT,
            glow::UNPACK_ALIGNMENT,
            glow::PACK_ROW_LENGTH,
            glow::UNPACK_ROW_LENGTH,
            glow::UNPACK_SKIP_ROWS,
            glow::ARRAY_BUFFER_BINDING,
            glow::RENDERBUFFER_BINDING,
        ]
        .map(|p| gl.get_parameter_i32(p));
        let switches = [
            glow::SCISSOR_TEST,
            glow::DEPTH_TEST,
            glow::BLEND,
            glow::CULL_FACE,
            glow::STENCIL_TEST,
            glow::POLYGON_OFFSET_FILL,
            glow::SAMPLE_ALPHA_TO_COVERAGE,
            glow::SAMPLE_COVERAGE,
            glow::RASTERIZER_DISCARD,
            glow::DITHER,
        ]
        .map(|p| gl.is_enabled(p));
        let mask: [bool; 4] = gl.get_parameter_bool_array(glow::COLOR_WRITEMASK);
        let active = gl.get_parameter_i32(glow::ACTIVE_TEXTURE) as u32;
        let units: Vec<_> = (0..4)
            .map(|unit| {
                gl.active_texture(glow::TEXTURE0 + unit);
                (gl.get_parameter_i32(glow::TEXTURE_BINDING_2D), gl.get_parameter_i32(glow::SAMPLER_BINDING))
            })
            .collect();
        gl.active_texture(active);
        let points = [0, 1, 2].map(|i| gl.get_parameter_indexed_i32(glow::UNIFORM_BUFFER_BINDING, i));
        format!("{viewport:?} {clear:?} {numbers:?} {switches:?} {mask:?} {units:?} {points:?}")
    }
}

#[test]
fn a_webgl2_user_gets_the_contexts_state_back() {
    let headless = Headless::new().expect("EGL with OpenGL ES 3");
    let gl = headless.backend.context().clone();
    // The user's own unusual state.
    // SAFETY: plain calls with objects made here, on the current context.
    let (framebuffer, color) = unsafe {
        let program = gl.create_program().unwrap();
        for (stage, text) in [
            (glow::VERTEX_SHADER, "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }"),
            (
                glow::FRAGMENT_SHADER,
                "#version 300 es\nprecision highp float; out vec4 c; void main() { c = vec4(1.0); }",
            ),
        ] {
            let shader = gl.create_shader(stage).unwrap();
            gl.shader_source(shader, text);
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
        }
        gl.link_program(program);
        gl.use_program(Some(program));
        gl.bind_vertex_array(Some(gl.create_vertex_array().unwrap()));
        let color = gl.create_texture().unwrap();
        gl.active_texture(glow::TEXTURE1);
        gl.bind_texture(glow::TEXTURE_2D, Some(color));
        gl.tex_storage_2d(glow::TEXTURE_2D, 1, glow::RGBA8, SIZE as i32, SIZE as i32);
        gl.bind_sampler(1, Some(gl.create_sampler().unwrap()));
        gl.active_texture(glow::TEXTURE3);
        let framebuffer = gl.create_framebuffer().unwrap();
        gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
        gl.framebuffer_texture_2d(glow::FRAMEBUFFER, glow::COLOR_ATTACHMENT0, glow::TEXTURE_2D, Some(color), 0);
        let buffer = gl.create_buffer().unwrap();
        gl.bind_buffer_base(glow::UNIFORM_BUFFER, 1, Some(buffer));
        gl.viewport(3, 4, 5, 6);
        gl.clear_color(0.1, 0.2, 0.3, 0.4);
        for switch in
            [glow::SCISSOR_TEST, glow::DEPTH_TEST, glow::CULL_FACE, glow::STENCIL_TEST, glow::POLYGON_OFFSET_FILL]
        {
            gl.enable(switch);
        }
        gl.scissor(1, 1, 2, 2);
        gl.depth_func(glow::GEQUAL);
        gl.depth_mask(false);
        gl.color_mask(true, false, true, false);
        gl.enable(glow::BLEND);
        gl.blend_func_separate(glow::DST_COLOR, glow::ZERO, glow::ONE, glow::ONE);
        gl.blend_equation_separate(glow::MAX, glow::FUNC_SUBTRACT);
        gl.pixel_store_i32(glow::UNPACK_ROW_LENGTH, 77);
        gl.pixel_store_i32(glow::PACK_ALIGNMENT, 8);
        (framebuffer, color)
    };
    let before = state(&gl);
    let mut backend = WebGlBackend::new(gl.clone()).unwrap();
    assert_eq!(state(&gl), before, "making the backend changed the state");

    // The sky into the user's framebuffer, whose rows run upwards.
    let desc =
        TextureDesc { rows: RowOrder::BottomUp, ..TextureDesc::new("user's framebuffer", SIZE, SIZE, Format::Rgba8) };
    let id = backend.import_framebuffer(Some(framebuffer), desc).unwrap();
    let target = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..Target::color(id) };
    let mut sky = SkyRenderer::new(SkySettings::default()).unwrap();
    let passes = sky.background(&mut backend, &scene(), target).unwrap().to_vec();
    backend.run(&passes).unwrap();
    assert_eq!(state(&gl), before, "drawing changed the state");

    let mut picture = PictureRenderer::default();
    let drawn = picture.draw(&mut backend, &scene(), &PictureSettings::default(), [16, 16]).unwrap();
    let _ = backend.read(drawn.radiance).unwrap();
    let (passes, _) = picture.passes(&mut backend, &scene(), &PictureSettings::default(), [16, 16]).unwrap();
    let passes = passes.to_vec();
    let _ = backend.times(&passes).unwrap();
    let scratch = backend.create_texture(&TextureDesc::new("scratch", 2, 2, Format::Rgba32Float)).unwrap();
    backend.write_texture(scratch, &[1.0; 16]).unwrap();
    picture.destroy(&mut backend);
    assert_eq!(state(&gl), before, "a whole picture, reading and timing changed the state");

    // The user's framebuffer holds the picture upside down in memory, which is the right way up there.
    let imported =
        backend.import_texture(color, TextureDesc::new("user's texture", SIZE, SIZE, Format::Rgba8)).unwrap();
    let got = backend.read(imported).unwrap();
    let mut other = Headless::new().unwrap();
    let want = own(&mut other.backend);
    drop(other);
    let row = 4 * SIZE as usize;
    for (y, line) in got.chunks_exact(row).rev().enumerate() {
        for (a, b) in line.iter().zip(&want[y * row..][..row]) {
            assert!((a - b).abs() * 255.0 < 1.01, "row {y}: {a} {b}");
        }
    }
}

#[test]
fn a_lost_device_is_an_error_and_a_new_one_works() {
    let mut backend = WgpuBackend::headless().unwrap();
    let want = own(&mut backend);
    backend.device().destroy();
    let color = TextureDesc::new("after", 4, 4, Format::Rgba8);
    let lost = backend.create_texture(&color).map(|_| ()).or_else(|_| {
        let mut sky = PictureRenderer::default();
        sky.draw(&mut backend, &scene(), &PictureSettings::default(), [4, 4]).map(|_| ())
    });
    println!("{lost:?}");
    assert!(
        matches!(lost.as_ref().map_err(Error::kind), Err(ErrorKind::Lost { .. } | ErrorKind::Driver { .. })),
        "{lost:?}"
    );
    assert!(
        matches!(backend.run(&[]).map_err(Error::into_kind), Err(ErrorKind::Lost { .. })),
        "the loss is not remembered"
    );
    assert_eq!(own(&mut WgpuBackend::headless().unwrap()), want);

    let mut headless = Headless::new().unwrap();
    let want = own(&mut headless.backend);
    headless.backend.set_lost("told by the browser");
    assert!(matches!(headless.backend.run(&[]).map_err(Error::into_kind), Err(ErrorKind::Lost { .. })));
    drop(headless);
    assert_eq!(own(&mut Headless::new().unwrap().backend), want);
}

#[test]
fn a_window_less_context_outlives_those_that_come_and_go() {
    let mut first = Headless::new().unwrap();
    let want = own(&mut first.backend);
    for _ in 0..3 {
        assert_eq!(own(&mut Headless::new().unwrap().backend), want);
        let mut second = Headless::new().unwrap();
        first.make_current().unwrap();
        assert_eq!(own(&mut first.backend), want);
        second.make_current().unwrap();
        assert_eq!(own(&mut second.backend), want);
        drop(second);
        first.make_current().unwrap();
        assert_eq!(own(&mut first.backend), want);
    }
    // One that is dropped while another is current leaves that one what it draws with, once it is asked for.
    let second = Headless::new().unwrap();
    drop(first);
    second.make_current().unwrap();
}

#[test]
fn nothing_leaks_over_many_sizes_and_settings() {
    on_both(|backend| {
        let mut renderer = PictureRenderer::default();
        let mut settings = PictureSettings { terrain: None, ..Default::default() };
        settings.sky.method = Method::Single { view_samples: 2, light_samples: 1 };
        let mut draw = |backend: &mut dyn Backend, i: u32| {
            settings.sky.render_scale = if i.is_multiple_of(2) { 1.0 } else { 0.5 };
            renderer.draw(backend, &scene(), &settings, [1 + i % 13, 1 + i % 7]).unwrap();
        };
        (0..4).for_each(|i| draw(backend, i));
        let after_few = backend.live();
        (0..1000).for_each(|i| draw(backend, i));
        (0..4).for_each(|i| draw(backend, i));
        assert_eq!(backend.live(), after_few);
        renderer.destroy(backend);
        let left = backend.live();
        assert_eq!((left.textures, left.framebuffers), (0, 0));
        // Passes without textures (the sky's and the sun's) keep their bind groups with their programs.
        assert!(left.bind_groups <= 2, "{left:?}");
    });
}
