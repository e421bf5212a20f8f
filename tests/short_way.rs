//! The short way to a frame: the examples' pictures against the f64 reference, and against each other.

use glam::DVec3;
use welkin::frame::tone_map::{srgb_encode, tone_map};
use welkin::gpu::egl::Headless;
use welkin::gpu::{Backend, Format};
use welkin::reference::single::{RayQuery, Tolerance};
use welkin::{AtmosphereParams, PictureRenderer, PictureSettings, Scene, WebGlSky, WgpuSky};

use crate::encoders::User;
use crate::harness::{TINY, allocations, earth, luts, on_both, query, texture};

#[path = "../examples/gl_glass.rs"]
mod gl_glass;
#[path = "../examples/wgpu_glass.rs"]
mod wgpu_glass;
use gl_glass::gl_scene;
use wgpu_glass::wgpu_scene;

const SIZE: [u32; 2] = wgpu_scene::SIZE;

/// What the column sends, as the examples' shaders say, and how far away it is, m.
const COLUMN: [f64; 3] = [0.5, 0.4, 0.3];
const DISTANCE: f64 = 3e3;

/// Compares a picture with the reference's, column included.
fn compare(name: &str, bytes: &[u8]) {
    let scene = wgpu_scene::scene();
    let forward = scene.validate().unwrap().basis.forward.normalize();
    let tolerance = Tolerance { relative: 1e-4 };
    let settings = PictureSettings::default();
    // Of the column's middle; of sky above and beside it; of the ground before it.
    for (x, y, column) in
        [(26, 40, true), (30, 26, true), (26, 20, false), (10, 4, false), (80, 8, false), (70, 26, false)]
    {
        let i = y * SIZE[0] + x;
        let mut q = query(&scene, SIZE, i as usize);
        if column {
            q = q.ended_at(DISTANCE / q.direction.dot(forward));
        }
        let light = earth().radiance(&q, tolerance).unwrap();
        let sun = scene.atmosphere.sun_intensity;
        let radiance = std::array::from_fn(|c| {
            let behind = if column { COLUMN[c] * light.transmittance[c] } else { 0.0 };
            (light.per_irradiance[c] - light.ground[c]) * sun + behind
        });
        let want = tone_map(settings.tone_map, radiance.map(|v| v * settings.exposure)).map(srgb_encode);
        let got = [0, 1, 2].map(|c| f64::from(bytes[4 * i as usize + c]) / 255.0);
        println!("{name} {x} {y}: {got:.3?}, the reference {want:.3?}");
        for c in 0..3 {
            // One step of dither, and 2 % of what the LUTs are off.
            assert!((got[c] - want[c]).abs() < 0.02, "{name} {x} {y}: {got:?} is not {want:?}");
        }
    }
}

/// What one frame after another costs: microseconds to record and until it is drawn, and allocations of ours
/// and of the API.
#[derive(Default)]
struct Costs(Vec<[f64; 3]>);

impl Costs {
    /// Draws a frame: `record` hands it to the GPU, `wait` waits for it.
    fn frame(&mut self, record: impl FnOnce(), wait: impl FnOnce()) {
        let start = std::time::Instant::now();
        let ((), allocated) = allocations::during(record);
        let recorded = start.elapsed().as_secs_f64();
        wait();
        self.0.push([recorded * 1e6, start.elapsed().as_secs_f64() * 1e6, allocated as f64]);
    }

    /// The middle of the frames from the fifth on.
    fn median(&self, which: usize) -> f64 {
        let mut values: Vec<_> = self.0[4..].iter().map(|frame| frame[which]).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    }

    fn print(&self, name: &str) {
        println!(
            "{name}: first frame {:.1} ms; then {:.2} ms, of which recording {:.0} µs with {} allocations",
            self.0[0][1] * 1e-3,
            self.median(1) * 1e-3,
            self.median(0),
            self.median(2)
        );
    }
}

/// `cargo test --all-features --test all sixty_frames -- --nocapture`: a steady frame of the short way
/// allocates nothing with OpenGL, and with wgpu what wgpu allocates.
#[test]
fn sixty_frames_of_both_examples() {
    let user = User::new();
    let mut sky = WgpuSky::new(&user.device, &user.queue, PictureSettings::default()).unwrap();
    let column = wgpu_scene::column(&user.device, &wgpu_scene::scene());
    let view = wgpu_scene::output(&user.device).create_view(&Default::default());
    let mut costs = Costs::default();
    for _ in 0..60 {
        let record = || {
            let mut encoder = user.encoder();
            wgpu_scene::frame(&mut sky, &mut encoder, &view, |pass| {
                pass.set_pipeline(&column);
                pass.draw(0..4, 0..1);
            })
            .unwrap();
            user.queue.submit([encoder.finish()]);
        };
        let wait = || {
            user.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        };
        costs.frame(record, wait);
    }
    costs.print("webgpu");
    user.no_errors();

    let window = Headless::new().unwrap();
    let gl = window.backend.context().clone();
    let mut sky = WebGlSky::new(gl.clone(), PictureSettings::default()).unwrap();
    let (column, output) = (gl_scene::column(&gl, &gl_scene::scene()), gl_scene::output(&gl));
    let mut costs = Costs::default();
    for _ in 0..60 {
        let record =
            || gl_scene::frame(&mut sky, Some(output), |gl| gl_scene::draw_column(gl, column)).unwrap();
        costs.frame(record, || drop(gl_scene::read(&gl, output)));
    }
    costs.print("webgl2");
    assert_eq!(costs.median(2), 0.0, "allocations of a steady frame");
}

/// An output that cannot be drawn to is refused before anything is recorded; a view of an sRGB surface in its
/// linear format is one that can.
#[test]
fn outputs_are_checked_before_anything_is_recorded() {
    use wgpu::{TextureFormat as F, TextureUsages as U};
    let user = User::new();
    let settings = PictureSettings { sky: luts(TINY), ..PictureSettings::default() };
    let mut sky = WgpuSky::new(&user.device, &user.queue, settings).unwrap();
    let mut draw = |format, usage, view| {
        let texture = user.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: 4, height: 4, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: if format == F::Bgra8UnormSrgb { &[F::Bgra8Unorm] } else { &[] },
        });
        let view = wgpu::TextureViewDescriptor { format: Some(view), ..Default::default() };
        let (mut encoder, mut called) = (user.encoder(), false);
        let drawn = sky.draw(&mut encoder, &texture.create_view(&view), &wgpu_scene::scene(), |_, _| {
            called = true;
        });
        assert_eq!(called, drawn.is_ok());
        user.queue.submit([encoder.finish()]);
        drawn.map_err(|e| e.to_string())
    };
    let target = U::RENDER_ATTACHMENT;
    assert_eq!(draw(F::Bgra8UnormSrgb, target, F::Bgra8Unorm), Ok(()));
    for (format, usage, word) in [
        (F::Bgra8UnormSrgb, target, "view = an sRGB view is not allowed: must be one of Bgra8Unorm"),
        (F::Rgba8Unorm, U::TEXTURE_BINDING, "output = a view of Rgba8Unorm"),
        (F::Depth32Float, target, "output = a view of Depth32Float"),
        (F::Rg8Unorm, target, "texture.format = Rg8Unorm"),
    ] {
        let error = draw(format, usage, format).unwrap_err();
        assert!(error.contains(word), "{error}");
    }
    user.no_errors();
    for exposure in [-1.0, f64::NAN] {
        let settings = PictureSettings { exposure, ..settings };
        let error = WgpuSky::new(&user.device, &user.queue, settings).err().unwrap().to_string();
        assert!(error.starts_with("exposure = "), "{error}");
    }
}

/// The light that a frame hands out is that of the medium that is drawn.
#[test]
fn light_is_of_the_medium_that_is_drawn() {
    let user = User::new();
    let settings = PictureSettings { sky: luts(TINY), ..PictureSettings::default() };
    let mut sky = WgpuSky::new(&user.device, &user.queue, settings).unwrap();
    let view = wgpu_scene::output(&user.device).create_view(&Default::default());
    let mut light_in = |scene: &Scene| {
        let mut found = None;
        for frame in 0..6 {
            let mut encoder = user.encoder();
            sky.draw(&mut encoder, &view, scene, |_, frame| found = frame.light.cloned()).unwrap();
            user.queue.submit([encoder.finish()]);
            user.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
            assert!(frame > 0 || found.is_none(), "light of another medium");
        }
        found.expect("light").ground_irradiance(0.2).unwrap()[0]
    };
    let earth = wgpu_scene::scene();
    let mars = AtmosphereParams { planet_radius: 6_360_000.0, ..AtmosphereParams::mars() };
    let mars = AtmosphereParams { atmosphere_radius: 6_470_000.0, ..mars };
    let (on_earth, on_mars) = (light_in(&earth), light_in(&Scene { atmosphere: mars, ..earth.clone() }));
    assert!((on_mars / on_earth - 1.0).abs() > 0.1, "{on_earth} {on_mars}");
    assert_eq!(light_in(&earth), on_earth);
}

/// What a user's scene left in the depth buffer is not there in the next frame, also where the renderer drew
/// pictures of its own in between, whose empty depth it need not clear.
#[test]
fn depth_is_cleared_around_every_scene() {
    on_both(|b| {
        let settings = PictureSettings { sky: luts(TINY), terrain: None, ..PictureSettings::default() };
        let scene = wgpu_scene::scene();
        let output = texture(b, "output", [8, 8], Format::Rgba8);
        let mut renderer = PictureRenderer::default();
        for _ in 0..3 {
            renderer.draw(b, &scene, &settings, [8, 8]).unwrap();
            let around = renderer.around(b, &scene, &settings, output).unwrap();
            let first = around.before.iter().find(|p| p.target.depth == Some(around.depth)).unwrap();
            assert_eq!(first.target.clear_depth, Some(0.0));
            b.run(around.before).unwrap();
            assert_eq!(b.content(around.depth), 0, "nobody knows what a user draws");
            b.run(around.after).unwrap();
        }
        renderer.destroy(b);
    });
}

#[test]
fn both_examples_draw_what_the_reference_says() {
    let mut user = User::new();
    let mut sky = WgpuSky::new(&user.device, &user.queue, PictureSettings::default()).unwrap();
    let column = wgpu_scene::column(&user.device, &wgpu_scene::scene());
    let output = wgpu_scene::output(&user.device);
    let view = output.create_view(&Default::default());
    let mut draw = |user: &mut User| {
        let mut encoder = user.encoder();
        wgpu_scene::frame(&mut sky, &mut encoder, &view, |pass| {
            pass.set_pipeline(&column);
            pass.draw(0..4, 0..1);
        })
        .unwrap();
        user.queue.submit([encoder.finish()]);
        wgpu_scene::read(&user.device, &user.queue, &output)
    };
    let webgpu = draw(&mut user);
    // Frames are alike, and the light for the scene comes with one of the next.
    for _ in 0..3 {
        assert!(draw(&mut user) == webgpu, "the next frame differs");
    }
    let [up, ..] = sky.light().expect("light").ground_irradiance(0.208).unwrap();
    assert!((0.1..3.0).contains(&up), "{up}");
    user.no_errors();

    let window = Headless::new().unwrap();
    let gl = window.backend.context().clone();
    let mut sky = WebGlSky::new(gl.clone(), PictureSettings::default()).unwrap();
    let (column, output) = (gl_scene::column(&gl, &gl_scene::scene()), gl_scene::output(&gl));
    let mut draw = || {
        gl_scene::frame(&mut sky, Some(output), |gl| gl_scene::draw_column(gl, column)).unwrap();
        gl_scene::read(&gl, output)
    };
    let webgl2 = draw();
    for _ in 0..3 {
        assert!(draw() == webgl2, "the next frame differs");
    }
    let light = sky.light().expect("light").ground_irradiance(0.208).unwrap();
    assert!((light[0] / up - 1.0).abs() < 1e-3, "{light:?} {up}");
    assert_eq!(sky.backend().live().reads, 0);

    compare("webgpu", &webgpu);
    compare("webgl2", &webgl2);
    let apart = webgpu.iter().zip(&webgl2).map(|(a, b)| a.abs_diff(*b));
    let (most, many) = (apart.clone().max().unwrap(), apart.filter(|d| *d > 1).count());
    println!("the backends differ by at most {most}, in {many} bytes by more than 1");
    assert!(many < 40, "{many}");
}

/// Compares a picture with the reference's: what the glass mirrors, behind the air before it, over the sky.
fn compare_glass(name: &str, bytes: &[u8]) {
    let scene = wgpu_scene::scene();
    let view = scene.validate().unwrap();
    let settings = PictureSettings::default();
    let (middle, radius) = (view.world_to_zenith * DVec3::from(wgpu_glass::SPHERE.0), wgpu_glass::SPHERE.1);
    let sun = scene.atmosphere.sun_intensity;
    let light = |q| earth().radiance(&q, Tolerance { relative: 1e-4 }).unwrap();
    let mut met = 0;
    for (x, y) in (8..32).step_by(4).flat_map(|y| (8..40).step_by(4).map(move |x| (x, y))) {
        let q = query(&scene, SIZE, (y * SIZE[0] + x) as usize);
        let behind = light(q);
        let mut radiance: [f64; 3] =
            std::array::from_fn(|c| (behind.per_irradiance[c] - behind.ground[c]) * sun);
        let along = q.direction.dot(middle);
        let inside = radius * radius - (middle.length_squared() - along * along);
        if inside > 0.0 {
            met += 1;
            let distance = along - inside.sqrt();
            let normal = (q.direction * distance - middle) / radius;
            let reflectance = 0.15 + 0.85 * (1.0 + q.direction.dot(normal)).powi(5);
            let before = light(q.ended_at(distance));
            let mirrored =
                light(RayQuery { direction: q.direction - 2.0 * normal * q.direction.dot(normal), ..q });
            for c in 0..3 {
                let mirrored = mirrored.per_irradiance[c] - mirrored.ground[c];
                let seen = mirrored * before.transmittance[c] + before.per_irradiance[c] - before.ground[c];
                radiance[c] = radiance[c] * (1.0 - reflectance) + seen * sun * reflectance;
            }
        }
        let want = tone_map(settings.tone_map, radiance.map(|v| v * settings.exposure)).map(srgb_encode);
        let i = (y * SIZE[0] + x) as usize;
        let got = [0, 1, 2].map(|c| f64::from(bytes[4 * i + c]) / 255.0);
        println!("{name} {x} {y}: {got:.3?}, the reference {want:.3?}");
        for c in 0..3 {
            assert!((got[c] - want[c]).abs() < 0.02, "{name} {x} {y}: {got:?} is not {want:?}");
        }
    }
    assert!((10..40).contains(&met), "{met} pixels of glass");
}

#[test]
fn both_glass_examples_mirror_what_the_reference_says() {
    let user = User::new();
    let mut sky = WgpuSky::new(&user.device, &user.queue, wgpu_glass::settings()).unwrap();
    let glass = wgpu_glass::glass(&mut sky, &user.device).unwrap();
    let output = wgpu_scene::output(&user.device);
    let view = output.create_view(&Default::default());
    let mut encoder = user.encoder();
    wgpu_glass::frame(&mut sky, &mut encoder, &view, &glass).unwrap();
    user.queue.submit([encoder.finish()]);
    compare_glass("webgpu", &wgpu_scene::read(&user.device, &user.queue, &output));
    user.no_errors();

    let window = Headless::new().unwrap();
    let gl = window.backend.context().clone();
    let mut sky = WebGlSky::new(gl.clone(), wgpu_glass::settings()).unwrap();
    let (glass, output) = (gl_glass::glass(&gl).unwrap(), gl_scene::output(&gl));
    gl_glass::frame(&mut sky, Some(output), glass).unwrap();
    compare_glass("webgl2", &gl_scene::read(&gl, output));
}
