//! In somebody else's frame: the user's own device, encoder and views; the user's own context, with its state
//! as it was; and each of the four modes in a frame of the user's.

#![allow(unsafe_code)] // The test plays the user, who calls OpenGL.

use std::rc::Rc;
use std::sync::Arc;

use glow::HasContext as _;
use welkin::gpu::egl::Headless;
use welkin::gpu::webgl::WebGlBackend;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, Pass, Precision, RowOrder, Target, TextureDesc, TextureId};
use welkin::reference::single::{RayQuery, Sun, Tolerance, single_scattering};
use welkin::{Mode, PictureRenderer, PictureSettings, Quality, Scene, SkyRenderer, SkySettings};

use crate::encoders::User as WgpuUser;
use crate::harness::world::BEHIND;
use crate::harness::{
    TINY, View, aerial_passes, assert_physical, background_passes, cleared, copy_pass, draw, earth, free,
    picture_passes, query, rgb, shell_passes, texture, without_disk,
};

const SIZE: u32 = 32;

pub fn scene() -> Scene {
    View { pitch: 10.0, ..View::default() }.scene()
}

/// A sky that costs little: what it looks like does not matter here.
pub fn small() -> SkySettings {
    SkySettings { quality: Quality::Luts(TINY), ..SkySettings::default() }
}

/// The background by a backend of welkin's own, RGBA8.
pub fn own(backend: &mut dyn Backend) -> Vec<f32> {
    let color = texture(backend, "own", [SIZE, SIZE], Format::Rgba8);
    let mut sky = SkyRenderer::new(small()).unwrap();
    let passes = background_passes(backend, &mut sky, &scene(), cleared(color));
    backend.run(&passes).unwrap();
    let pixels = backend.read(color).unwrap();
    backend.destroy_texture(color);
    pixels
}

/// A device that cannot filter 32-bit floats gets its sky LUTs in 16 bits.
#[test]
fn luts_of_16_bits_hold_the_light() {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).expect("a Vulkan driver");
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default())).unwrap();
    let poor = WgpuBackend::from_device(device, queue, "no features").unwrap();
    let rich = WgpuBackend::headless().unwrap();
    assert!(!poor.info().filters_f32 && rich.info().filters_f32, "{} {}", poor.info(), rich.info());
    assert_eq!(rich.info().precision, Precision::Guaranteed);
    let settings = PictureSettings { terrain: None, ..PictureSettings::default() };
    let mut backends = [poor, rich].map(|backend| (backend, PictureRenderer::default()));
    let mut worst = 0.0_f32;
    for (altitude, pitch) in [(2.0, 10.0), (30e3, -4.0), (4e5, -18.0), (1e7, -90.0)] {
        for sun_elevation in [40.0, 2.0, -4.0] {
            let scene = View { altitude, pitch, sun_elevation, ..View::default() }.scene();
            let [got, want] = backends
                .each_mut()
                .map(|(backend, renderer)| draw(backend, renderer, &scene, &settings, [SIZE, SIZE]));
            let brightest = want.chunks_exact(4).flat_map(|p| &p[..3]).fold(0.0_f32, |m, v| m.max(*v));
            for (got, want) in got.iter().zip(&want) {
                worst = worst.max((got - want).abs() / want.max(1e-3 * brightest));
            }
        }
    }
    println!("16-bit LUTs change light by {worst:.1e} at most");
    // Roots of the fourth degree in half floats, 4 · 2^-11 in each of the sky's two LUTs, and 2^-11 in the
    // air's.
    assert!(worst > 0.0 && worst < 4.4e-3, "{worst}");
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

    let mut backend =
        WgpuBackend::from_device(device.clone(), queue.clone(), &adapter.get_info().name).unwrap();
    let mut sky = SkyRenderer::new(small()).unwrap();
    let desc = TextureDesc::new("user's target", SIZE, SIZE, Format::Bgra8);
    let id = backend.import_view(texture.create_view(&Default::default()), desc).unwrap();
    let mut encoder = device.create_command_encoder(&Default::default());
    let passes = background_passes(&mut backend, &mut sky, &scene(), cleared(id));
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
        gl.framebuffer_texture_2d(
            glow::FRAMEBUFFER,
            glow::COLOR_ATTACHMENT0,
            glow::TEXTURE_2D,
            Some(color),
            0,
        );
        let buffer = gl.create_buffer().unwrap();
        gl.bind_buffer_base(glow::UNIFORM_BUFFER, 1, Some(buffer));
        gl.viewport(3, 4, 5, 6);
        gl.clear_color(0.1, 0.2, 0.3, 0.4);
        for switch in [
            glow::SCISSOR_TEST,
            glow::DEPTH_TEST,
            glow::CULL_FACE,
            glow::STENCIL_TEST,
            glow::POLYGON_OFFSET_FILL,
        ] {
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
    assert_eq!(backend.info().precision, Precision::Full, "{}", backend.info());

    // The sky into the user's framebuffer, whose rows run upwards.
    let desc = TextureDesc {
        rows: RowOrder::BottomUp,
        ..TextureDesc::new("user's framebuffer", SIZE, SIZE, Format::Rgba8)
    };
    let id = backend.import_framebuffer(Some(framebuffer), desc).unwrap();
    let mut sky = SkyRenderer::new(small()).unwrap();
    let passes = background_passes(&mut backend, &mut sky, &scene(), cleared(id));
    backend.run(&passes).unwrap();
    assert_eq!(state(&gl), before, "drawing changed the state");

    let mut renderer = PictureRenderer::default();
    let settings = PictureSettings { sky: small(), ..PictureSettings::default() };
    let _ = draw(&mut backend, &mut renderer, &scene(), &settings, [16, 16]);
    let passes = picture_passes(&mut backend, &mut renderer, &scene(), &settings, [16, 16]);
    let _ = backend.times(&passes).unwrap();
    let scratch = backend.create_texture(&TextureDesc::new("scratch", 2, 2, Format::Rgba32Float)).unwrap();
    backend.write_texture(scratch, &[1.0; 16]).unwrap();
    renderer.destroy(&mut backend);
    assert_eq!(state(&gl), before, "a whole picture, reading and timing changed the state");

    // The user's framebuffer holds the picture upside down in memory, which is the right way up there.
    let imported =
        backend.import_texture(color, TextureDesc::new("user's texture", SIZE, SIZE, Format::Rgba8)).unwrap();
    assert_eq!((backend.texture_name(imported), backend.texture_name(id)), (Some(color), None));
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

/// OpenGL as desktops have it draws what OpenGL ES draws, and gets its state back.
#[test]
fn a_desktop_user_gets_the_same_sky() {
    let want = own(&mut Headless::new().unwrap().backend);
    let mut desktop = Headless::desktop().expect("EGL with OpenGL");
    println!("{}", desktop.backend.info());
    assert!(!desktop.backend.info().driver.contains("ES"), "{}", desktop.backend.info());
    assert!(desktop.backend.info().filters_f32);
    let got = own(&mut desktop.backend);
    for (i, (a, b)) in got.iter().zip(&want).enumerate() {
        assert!((a - b).abs() * 255.0 < 1.01, "value {i}: {a} {b}");
    }
    let gl = desktop.backend.context().clone();
    let before = state(&gl);
    let mut backend = WebGlBackend::new(gl.clone()).unwrap();
    assert!(own(&mut backend) == got);
    assert_eq!(state(&gl), before, "drawing changed the state");
}

/// OpenGL's functions loaded once more, for the context that is current on this thread.
fn loaded() -> glow::Context {
    // SAFETY: the system's EGL, which `Headless` keeps loaded; the functions that it names are those of the
    // context that is current.
    unsafe {
        let egl = khronos_egl::DynamicInstance::<khronos_egl::EGL1_5>::load_required().unwrap();
        let find = |name: &str| egl.get_proc_address(name).map_or(std::ptr::null(), |p| p as *const _);
        glow::Context::from_loader_function(find)
    }
}

/// However a user owns a context, the backend draws the same with it and holds it as long as it is used.
#[test]
fn a_context_may_be_an_rc_an_arc_or_static() {
    let _current = Headless::new().expect("EGL with OpenGL ES 3");
    let (rc, arc) = (Rc::new(loaded()), Arc::new(loaded()));
    let (of_rc, of_arc) = (Rc::downgrade(&rc), Arc::downgrade(&arc));
    let leaked: &'static glow::Context = Box::leak(Box::new(loaded()));
    let at = [Rc::as_ptr(&rc), Arc::as_ptr(&arc), std::ptr::from_ref(leaked)];
    let held = || [of_rc.strong_count() > 0, of_arc.strong_count() > 0];

    let made = [WebGlBackend::new(rc), WebGlBackend::new(arc), WebGlBackend::new(leaked)];
    let mut backends = made.map(Result::unwrap);
    assert_eq!(held(), [true; 2], "the backends own what their user has given away");
    let [of_rc_drawn, of_arc_drawn, of_static_drawn] = backends.each_mut().map(|backend| own(backend));
    assert!(of_rc_drawn[..3].iter().all(|v| *v > 0.0), "{:?}", &of_rc_drawn[..4]);
    assert!(of_arc_drawn == of_rc_drawn && of_static_drawn == of_rc_drawn);
    let contexts = backends.each_ref().map(|backend| backend.context().clone());
    assert_eq!(contexts.each_ref().map(|gl| std::ptr::from_ref(&**gl)), at, "another context");

    drop(backends);
    assert_eq!(held(), [true; 2], "a clone of the backend's context keeps it");
    for context in contexts {
        assert!(own(&mut WebGlBackend::new(context).unwrap()) == of_rc_drawn);
    }
    assert_eq!(held(), [false; 2], "nobody has them any more");
}

// --- the four modes

/// A user with a device and textures of their own.
trait User {
    fn backend(&mut self) -> &mut dyn Backend;
    /// A texture of the user's with four values in each texel (or one), made known.
    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId;
    /// Records passes into a frame of the user's and submits it.
    fn frame(&mut self, passes: &[Pass]);
}

const SIDE: u32 = 8;
const TEXELS: usize = 64;

impl User for WgpuUser {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId {
        let (format, own) = if channels == 1 {
            (Format::R32Float, wgpu::TextureFormat::R32Float)
        } else {
            (Format::Rgba32Float, wgpu::TextureFormat::Rgba32Float)
        };
        let extent = wgpu::Extent3d { width: SIDE, height: SIDE, depth_or_array_layers: 1 };
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("user's"),
            size: extent,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: own,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let bytes: Vec<u8> = texels.iter().flat_map(|v| v.to_ne_bytes()).collect();
        let row = Some(SIDE * 4 * channels as u32);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: row, rows_per_image: None };
        self.queue.write_texture(texture.as_image_copy(), &bytes, layout, extent);
        let view = texture.create_view(&Default::default());
        self.backend.import_view(view, TextureDesc::new("user's", SIDE, SIDE, format)).unwrap()
    }

    fn frame(&mut self, passes: &[Pass]) {
        self.frame(passes);
    }
}

struct GlUser {
    backend: WebGlBackend,
    _context: Headless,
}

impl User for GlUser {
    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn texture(&mut self, channels: usize, texels: &[f32]) -> TextureId {
        let gl = self.backend.context().clone();
        let bytes: Vec<u8> = texels.iter().flat_map(|v| v.to_ne_bytes()).collect();
        let (format, internal, layout) = if channels == 1 {
            (Format::R32Float, glow::R32F, glow::RED)
        } else {
            (Format::Rgba32Float, glow::RGBA32F, glow::RGBA)
        };
        let side = SIDE as i32;
        // SAFETY: plain calls on the current context; the slice holds as many bytes as the texture.
        let texture = unsafe {
            let texture = gl.create_texture().unwrap();
            gl.bind_texture(glow::TEXTURE_2D, Some(texture));
            gl.tex_storage_2d(glow::TEXTURE_2D, 1, internal, side, side);
            for filter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
                gl.tex_parameter_i32(glow::TEXTURE_2D, filter, glow::NEAREST as i32);
            }
            let data = glow::PixelUnpackData::Slice(Some(&bytes));
            gl.tex_sub_image_2d(glow::TEXTURE_2D, 0, 0, 0, side, side, layout, glow::FLOAT, data);
            gl.bind_texture(glow::TEXTURE_2D, None);
            texture
        };
        self.backend.import_texture(texture, TextureDesc::new("user's", SIDE, SIDE, format)).unwrap()
    }

    fn frame(&mut self, passes: &[Pass]) {
        self.backend.run(passes).unwrap();
    }
}

/// A copy of a user's texture, read.
fn content(user: &mut dyn User, id: TextureId) -> Vec<f32> {
    let b = user.backend();
    let copy = texture(b, "copy", [SIDE; 2], Format::Rgba32Float);
    let pass = copy_pass(b, id, copy);
    b.run(&[pass]).unwrap();
    let pixels = b.read(copy).unwrap();
    b.destroy_texture(copy);
    pixels
}

/// What is behind the air in the user's frame.
/// The left half of the picture shows a plane so far away, m.
const PLANE: f64 = 20e3;

#[test]
fn each_mode_draws_in_a_users_own_frame() {
    let view = View { altitude: 30e3, pitch: -5.0, fov: 60.0, sun_elevation: 35.0, ..View::default() };
    let scene = view.scene();
    let size = [SIDE; 2];
    let is_plane = |i: usize| i % 8 < 4;
    // The reference's light and transmittance: once scattered, and of all orders.
    let want: Vec<_> = (0..TEXELS)
        .map(|i| {
            let mut q = query(&scene, size, i);
            if is_plane(i) {
                q = q.ended_at(PLANE / q.direction.dot(scene.validate().unwrap().basis.forward));
            }
            let tolerance = Tolerance { relative: 1e-4 };
            let once = single_scattering(&scene.atmosphere, &q, Sun::Point, tolerance).unwrap();
            let all = earth().radiance(&q, tolerance).unwrap();
            let sun = scene.atmosphere.sun_intensity;
            let air = std::array::from_fn(|c| (all.per_irradiance[c] - all.ground[c]) * sun);
            ([once.radiance, air], once.transmittance, q)
        })
        .collect();
    let is_ground = |i: usize| !is_plane(i) && hits(&scene, &want[i].2);
    assert!((0..TEXELS).any(is_ground) && (0..TEXELS).any(|i| !is_plane(i) && !is_ground(i)));
    let plain: Vec<f32> = BEHIND.repeat(TEXELS);
    let stored: Vec<f32> = (0..TEXELS)
        .map(|i| if is_plane(i) { scene.depth.encode(PLANE) } else { scene.depth.background() } as f32)
        .collect();
    let users: [Box<dyn User>; 2] = [Box::new(WgpuUser::new()), {
        let context = Headless::new().expect("EGL with OpenGL ES 3");
        let backend = WebGlBackend::new(context.backend.context().clone()).unwrap();
        Box::new(GlUser { backend, _context: context })
    }];
    for mut user in users {
        let user = user.as_mut();
        let name = user.backend().info().backend;
        for mode in Mode::ALL {
            let mut sky = SkyRenderer::new(without_disk(mode.settings())).unwrap();
            let (color, depth) = (user.texture(4, &plain), user.texture(1, &stored));
            let out = user.texture(4, &[0.0; 4 * TEXELS]);
            let passes = background_passes(user.backend(), &mut sky, &scene, Target::color(color));
            // What is behind the sky is dimmed by a pass of its own.
            let expected = [2, 0, 0, 2][mode as usize];
            assert_eq!(passes.len() - luts_in(&passes), expected, "{}: background", mode.name());
            assert_eq!(luts_in(&passes) > 0, mode == Mode::Lut);
            user.frame(&passes);
            // Then the user draws the plane.
            let mut drawn = content(user, color);
            (0..TEXELS)
                .filter(|&i| is_plane(i))
                .for_each(|i| drawn[4 * i..4 * i + 4].copy_from_slice(&BEHIND));
            let drawn_color = user.texture(4, &drawn);
            let passes = aerial_passes(user.backend(), &mut sky, &scene, [drawn_color, depth, out]);
            assert_eq!(
                passes.len() - luts_in(&passes),
                [0, 1, 0, 1][mode as usize],
                "{}: aerial",
                mode.name()
            );
            user.frame(&passes);
            let after = passes.last().map_or(drawn_color, |p| p.target.color);
            let passes = shell_passes(user.backend(), &mut sky, &scene, depth, Target::color(after));
            assert_eq!(passes.len(), usize::from(mode == Mode::Planet), "{}: shell", mode.name());
            user.frame(&passes);
            let pixels = content(user, after);
            assert_physical(&pixels, mode.name());
            let mut worst = 0.0_f64;
            for (i, (light, through, _)) in want.iter().enumerate() {
                let light = light[usize::from(mode == Mode::Lut)];
                let grey = through.iter().sum::<f64>() / 3.0;
                let got = rgb(&pixels, i);
                for c in 0..3 {
                    let behind = f64::from(BEHIND[c]);
                    let want = match mode {
                        Mode::SkyDome if is_plane(i) || is_ground(i) => behind,
                        Mode::Planet => behind * grey + light[c],
                        Mode::SkyDome | Mode::AtmospherePost | Mode::Lut => behind * through[c] + light[c],
                    };
                    worst = worst.max((got[c] / want - 1.0).abs());
                    assert!(
                        (got[c] / want - 1.0).abs() < 0.03,
                        "{name} {} {i} {c}: {got:?} {want}",
                        mode.name()
                    );
                }
            }
            println!("{name} {}: largest deviation {worst:.4}", mode.name());
            let b = user.backend();
            sky.destroy(b);
            free(b, [color, depth, out, drawn_color]);
            assert_eq!(b.live().textures, 0, "{}", mode.name());
        }
    }
}

/// How many passes fill LUTs.
fn luts_in(passes: &[Pass]) -> usize {
    passes.iter().filter(|p| p.label.ends_with("LUT")).count()
}

/// Whether a ray ends on the ground.
fn hits(scene: &Scene, q: &RayQuery) -> bool {
    let radius = scene.atmosphere.planet_radius;
    let horizon = -(1.0 - (radius / (radius + q.altitude)).powi(2)).sqrt();
    q.direction.z < horizon
}
