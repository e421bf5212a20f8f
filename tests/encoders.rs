//! Passes in encoders of the user's: submitted late, dropped, with many others; and mistakes with the user's
//! textures, each an error by name.

use glam::DVec3;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, Live, Pass, Target, TextureDesc, TextureId};
use welkin::{
    AerialTargets, AtmosphereParams, Camera, DepthConvention, FrameTargets, Moon, Scene, SkyRenderer,
    SkySettings,
};

use crate::harness::{TINY, View, background_passes, cleared, luts, on_both, target, texture, without_disk};

const SIZE: [u32; 2] = [8, 6];

/// A device of the user's, and the errors that nobody caught.
pub struct User {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub backend: WgpuBackend,
    errors: std::sync::Arc<std::sync::Mutex<Vec<String>>>,
}

impl User {
    pub fn new() -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter =
            pollster::block_on(instance.request_adapter(&Default::default())).expect("a Vulkan driver");
        let desc = wgpu::DeviceDescriptor {
            required_features: adapter.features() & wgpu::Features::FLOAT32_BLENDABLE,
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&desc)).unwrap();
        let errors = std::sync::Arc::<std::sync::Mutex<Vec<String>>>::default();
        let list = errors.clone();
        device.on_uncaptured_error(std::sync::Arc::new(move |e: wgpu::Error| {
            list.lock().unwrap().push(e.to_string());
        }));
        let backend = WgpuBackend::from_device(device.clone(), queue.clone(), "the user's").unwrap();
        Self { device, queue, backend, errors }
    }

    pub fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&Default::default())
    }

    /// Records passes in an encoder and submits it.
    pub fn frame(&mut self, passes: &[Pass]) {
        let mut encoder = self.encoder();
        self.backend.encode(&mut encoder, passes).unwrap();
        self.queue.submit([encoder.finish()]);
    }

    #[track_caller]
    pub fn no_errors(&self) {
        assert_eq!(*self.errors.lock().unwrap(), Vec::<String>::new());
    }
}

fn sky() -> SkyRenderer {
    SkyRenderer::new(without_disk(luts(TINY))).unwrap()
}

fn day() -> Scene {
    View { pitch: 10.0, ..View::default() }.scene()
}

/// What a renderer that has drawn nothing else draws.
fn fresh(b: &mut dyn Backend, scene: &Scene) -> Vec<f32> {
    let (mut sky, color) = (sky(), target(b, SIZE));
    let passes = background_passes(b, &mut sky, scene, cleared(color));
    b.run(&passes).unwrap();
    let pixels = b.read(color).unwrap();
    sky.destroy(b);
    b.destroy_texture(color);
    pixels
}

/// An encoder that is dropped instead of submitted, or submitted after one that was recorded later: the sky
/// is right again in the next frame.
#[test]
fn what_a_dropped_encoder_would_have_made_is_made_again() {
    let mut user = User::new();
    let noon = View { sun_elevation: 60.0, pitch: 10.0, ..View::default() }.scene();
    let want = [&day(), &noon].map(|scene| fresh(&mut user.backend, scene));
    assert_ne!(want[0], want[1]);
    let color = target(&mut user.backend, SIZE);
    // Dropped at once; after another frame was recorded; after that was submitted. And submitted after it.
    for later in [0, 1, 2, 3] {
        let mut sky = sky();
        let mut passes = |user: &mut User, scene: &Scene| {
            background_passes(&mut user.backend, &mut sky, scene, cleared(color))
        };
        let first = passes(&mut user, &day());
        assert!(first.len() > 3, "no LUTs in the first frame");
        let mut lost = user.encoder();
        user.backend.encode(&mut lost, &first).unwrap();
        if later > 0 {
            // The LUTs of the medium seem to be there; those of the view are made of them.
            let second = passes(&mut user, &noon);
            assert!(second.len() < first.len(), "LUTs that were recorded are made again");
            let mut encoder = user.encoder();
            user.backend.encode(&mut encoder, &second).unwrap();
            match later {
                1 => {
                    drop(lost);
                    user.queue.submit([encoder.finish()]);
                }
                2 => {
                    user.queue.submit([encoder.finish()]);
                    drop(lost);
                }
                _ => {
                    user.queue.submit([encoder.finish()]);
                    user.queue.submit([lost.finish()]);
                    // Known once both have run.
                    user.backend.wait().unwrap();
                }
            }
        } else {
            drop(lost);
        }
        for (scene, want) in [&noon, &day()].into_iter().zip([&want[1], &want[0]]) {
            let again = passes(&mut user, scene);
            user.frame(&again);
            assert!(user.backend.read(color).unwrap() == *want, "{later}: the sky is wrong for good");
        }
        sky.destroy(&mut user.backend);
    }
    user.no_errors();
}

/// An encoder that is kept for a while is no reason to make anything again; nor is one that made no LUT.
#[test]
fn an_encoder_may_wait() {
    let mut user = User::new();
    let (mut sky, color) = (sky(), target(&mut user.backend, SIZE));
    let scene = day();
    let mut passes = |user: &mut User| background_passes(&mut user.backend, &mut sky, &scene, cleared(color));
    let first = passes(&mut user);
    let mut encoder = user.encoder();
    user.backend.encode(&mut encoder, &first).unwrap();
    assert_eq!(passes(&mut user).len(), 1, "the frame after");
    user.queue.submit([encoder.finish()]);
    let steady = passes(&mut user);
    let mut dropped = user.encoder();
    user.backend.encode(&mut dropped, &steady).unwrap();
    drop(dropped);
    assert_eq!(passes(&mut user).len(), 1, "an encoder without a LUT was dropped");
    user.no_errors();
}

/// Each of a thousand passes in one encoder, or in twenty that wait, reads its own uniform block.
#[test]
fn an_encoder_holds_any_number_of_passes() {
    let mut user = User::new();
    let b = &mut user.backend;
    let headings: Vec<f64> = (0..1000).map(|i| f64::from(i) * 0.36).collect();
    let scene = |heading| View { heading, pitch: 5.0, sun_elevation: 20.0, ..View::default() }.scene();
    let (mut sky, colors): (_, Vec<TextureId>) =
        (sky(), headings.iter().map(|_| target(b, [1, 1])).collect());
    let mut passes = Vec::new();
    for (&heading, &color) in headings.iter().zip(&colors) {
        // LUTs are made in the first of these alone.
        let mut made = background_passes(b, &mut sky, &scene(heading), cleared(color));
        if passes.is_empty() {
            b.run(&made[..made.len() - 1]).unwrap();
            made.drain(..made.len() - 1);
        }
        passes.extend(made);
    }
    assert_eq!(passes.len(), colors.len());
    let read = |user: &mut User| -> Vec<_> {
        colors.iter().step_by(37).map(|&color| user.backend.read(color).unwrap()).collect()
    };
    // In twenty encoders, all of which wait for the last.
    let encoders: Vec<_> = passes
        .chunks(50)
        .map(|chunk| {
            let mut encoder = user.encoder();
            user.backend.encode(&mut encoder, chunk).unwrap();
            // What is run meanwhile, if only nothing, does not free what waits.
            user.backend.run(&[]).unwrap();
            encoder.finish()
        })
        .collect();
    user.queue.submit(encoders);
    let in_many = read(&mut user);
    // In one.
    user.frame(&passes);
    let in_one = read(&mut user);
    // Each alone.
    passes.iter().step_by(37).for_each(|pass| user.backend.run(std::slice::from_ref(pass)).unwrap());
    let alone = read(&mut user);
    assert!(in_many == alone, "encoders that wait share their blocks");
    assert!(in_one == alone, "passes of an encoder share their blocks");
    user.no_errors();
}

/// Passes that are run later than they were made for, when their inputs hold another medium: what they make
/// is not taken for what it should be.
#[test]
fn passes_that_run_late_spoil_nothing() {
    on_both(|b| {
        let (mut sky, color) = (sky(), target(b, SIZE));
        let evening = View { sun_elevation: 8.0, pitch: 10.0, ..View::default() }.scene();
        let mars = View { params: AtmosphereParams::mars(), pitch: 10.0, ..View::default() }.scene();
        let (noon, want) = (day(), fresh(b, &evening));
        let mut passes = |b: &mut dyn Backend, scene| background_passes(b, &mut sky, scene, cleared(color));
        let first = passes(b, &noon);
        b.run(&first).unwrap();
        let late = passes(b, &evening);
        assert!(late.len() < first.len(), "all LUTs are made again for another sun");
        let other = passes(b, &mars);
        b.run(&other).unwrap();
        b.run(&late).unwrap();
        let again = passes(b, &evening);
        b.run(&again).unwrap();
        assert!(b.read(color).unwrap() == want, "the sky is wrong for good");
        sky.destroy(b);
    });
}

/// A moon in the line from a camera to the sun; the first radius hides all of it, the second half.
fn eclipse(radius: f64) -> Scene {
    let mut scene = View { pitch: 30.0, sun_elevation: 30.0, fov: 40.0, ..View::default() }.scene();
    let towards = scene.sun_direction.normalize();
    let position = scene.camera.position + towards * 3.7e8;
    scene.moon = Some(Moon::new(position, radius));
    scene
}

/// Two scenes with different moons in one submission: each has its own shade, in either order and with either
/// way to run.
#[test]
fn two_moons_in_one_submission_have_their_own_shade() {
    on_both(|b| {
        let scenes = [eclipse(1.9e6), eclipse(0.8e6)];
        let want = [0, 1].map(|i| fresh(b, &scenes[i]));
        let brightness = |pixels: &[f32]| pixels.chunks_exact(4).map(|p| p[1]).fold(0.0, f32::max);
        assert!(brightness(&want[1]) > 5.0 * brightness(&want[0]), "one scene is much darker");
        let (mut sky, colors) = (sky(), [target(b, SIZE), target(b, SIZE)]);
        let both = [0, 1].map(|i| background_passes(b, &mut sky, &scenes[i], cleared(colors[i])));
        b.run(&both.concat()).unwrap();
        for i in [0, 1] {
            assert!(b.read(colors[i]).unwrap() == want[i], "scene {i} has the other's shade");
        }
        sky.destroy(b);
    });
}

/// Ids of one backend mean nothing on another, whatever is there in their place.
#[test]
fn ids_of_another_backend_are_refused() {
    let mut seen = Vec::new();
    on_both(|b| seen.push(target(b, SIZE)));
    let (first, second) = (seen[0], seen[1]);
    assert_ne!(first, second);
    let mut turn = 0;
    on_both(|b| {
        let own = target(b, SIZE);
        for foreign in [first, second] {
            assert_eq!(b.texture(foreign), None, "{turn}");
            let targets = FrameTargets::background(Target::color(foreign));
            let error = sky().frame(b, &day(), &targets).map(|_| ()).unwrap_err().to_string();
            assert!(error.contains("background = a texture of another backend"), "{error}");
            let error = b.run(&[Pass::clear("clear", cleared(foreign))]).unwrap_err().to_string();
            assert!(error.contains("it belongs to another backend"), "{error}");
            b.destroy_texture(foreign);
        }
        assert!(b.texture(own).is_some());
        turn += 1;
    });
}

/// The result of a frame says which texture holds it: with air before the scene, without any, and without an
/// aerial target.
#[test]
fn a_frame_says_where_it_is() {
    on_both(|b| {
        let [color, out] = [0; 2].map(|_| target(b, SIZE));
        let depth = texture(b, "depth", SIZE, Format::R32Float);
        let air = AerialTargets { color: Some(color), depth, target: cleared(out) };
        let behind = FrameTargets::background(cleared(color));
        let away = View { altitude: 4e5, pitch: 60.0, heading: 180.0, ..View::default() }.scene();
        for (scene, targets, want) in [
            (&day(), behind, color),
            (&day(), behind.with_aerial(air), out),
            (&away, behind.with_aerial(air), color),
        ] {
            let mut sky = sky();
            assert_eq!(sky.frame(b, scene, &targets).unwrap().color, want);
            sky.destroy(b);
        }
        let alone = FrameTargets { aerial: Some(air), ..FrameTargets::default() };
        assert_eq!(sky().frame(b, &away, &alone).unwrap().color, color, "the scene's colour as it was read");
    });
}

/// Every mistake with a texture of the user's is an error that names it, and none reaches the device.
#[test]
fn mistakes_with_a_users_textures_are_told_by_name() {
    let mut user = User::new();
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
    let srgb = [wgpu::TextureFormat::Rgba8UnormSrgb];
    let good = wgpu::TextureDescriptor {
        label: Some("user's"),
        size: wgpu::Extent3d { width: 8, height: 6, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage,
        view_formats: &srgb,
    };
    let desc = |width, height, format| TextureDesc::new("user's", width, height, format);
    let rgba8 = desc(8, 6, Format::Rgba8);
    let none = wgpu::TextureViewDescriptor::default();
    let as_srgb = wgpu::TextureViewDescriptor { format: Some(srgb[0]), ..Default::default() };
    let samples = wgpu::TextureDescriptor { sample_count: 4, view_formats: &[], ..good.clone() };
    let layers = wgpu::TextureDescriptor {
        size: wgpu::Extent3d { depth_or_array_layers: 2, ..good.size },
        ..good.clone()
    };
    let mips = wgpu::TextureDescriptor { mip_level_count: 3, ..good.clone() };
    let packed = wgpu::TextureDescriptor {
        format: wgpu::TextureFormat::Rg11b10Ufloat,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
        ..good.clone()
    };
    let useless = wgpu::TextureDescriptor { usage: wgpu::TextureUsages::COPY_DST, ..good.clone() };
    for (what, texture, view, desc, word) in [
        ("samples", &samples, &none, rgba8, "sample count = 4"),
        ("sRGB view", &good, &as_srgb, rgba8, "view = an sRGB view is not allowed"),
        ("another format", &good, &none, desc(8, 6, Format::Rgba16Float), "format = Rgba16Float"),
        ("larger", &good, &none, desc(9, 6, Format::Rgba8), "size = 9 × 6"),
        ("smaller", &good, &none, desc(4, 3, Format::Rgba8), "size = 4 × 3"),
        ("layers", &layers, &none, rgba8, "view = a view of user's"),
        ("mip levels", &mips, &none, rgba8, "view = a view of user's"),
        ("no usage", &useless, &none, rgba8, "usage = "),
        ("packed floats", &packed, &none, rgba8, "format = Rgba8"),
    ] {
        let view = user.device.create_texture(texture).create_view(view);
        let error = user.backend.import_view(view, desc).expect_err(what).to_string();
        println!("{what}: {error}");
        assert!(error.contains(word), "{what}: {error}");
    }
    let as_its_own = wgpu::TextureDescriptor { format: srgb[0], view_formats: &[], ..good.clone() };
    for (what, desc, word) in [
        ("sRGB", &as_its_own, "texture.format = Rgba8UnormSrgb is not allowed: must be Rgba8Unorm,"),
        ("packed floats", &packed, "texture.format = Rg11b10Ufloat"),
        ("layers", &layers, "layers = 2"),
        ("mip levels", &mips, "mip levels = 3"),
        ("samples", &samples, "sample count = 4"),
    ] {
        let texture = user.device.create_texture(desc);
        let error = user.backend.import_texture("user's", &texture).expect_err(what).to_string();
        println!("{what}: {error}");
        assert!(error.contains(word), "{what}: {error}");
    }
    user.no_errors();

    // In their right places, and in each other's.
    let import = |user: &mut User, format, usage| {
        let texture = user.device.create_texture(&wgpu::TextureDescriptor {
            format,
            usage,
            view_formats: &[],
            ..good.clone()
        });
        user.backend.import_texture("user's", &texture).unwrap()
    };
    let half = wgpu::TextureFormat::Rgba16Float;
    let [color, out] = [0; 2].map(|_| import(&mut user, half, usage));
    let depth = import(&mut user, wgpu::TextureFormat::Depth32Float, usage);
    let read_only = import(&mut user, half, wgpu::TextureUsages::TEXTURE_BINDING);
    let drawn_only = import(&mut user, half, wgpu::TextureUsages::RENDER_ATTACHMENT);
    let frame = |background, color, depth, out| {
        let air = AerialTargets { color: Some(color), depth, target: Target::color(out) };
        FrameTargets::background(cleared(background)).with_aerial(air)
    };
    let with_depth = Target { depth: Some(out), ..cleared(color) };
    for (what, targets, word) in [
        ("right", frame(color, color, depth, out), ""),
        ("swapped", frame(color, depth, color, out), "aerial depth = user's (Rgba16Float)"),
        ("depth as color", frame(color, depth, depth, out), "aerial color = user's (Depth32Float)"),
        ("drawn to depth", frame(color, color, depth, depth), "color target = user's (Depth32Float"),
        ("background to depth", frame(depth, color, depth, out), "color target = user's (Depth32Float"),
        ("color as depth buffer", FrameTargets::background(with_depth), "depth target = user's (Rgba16Float"),
        ("not to be drawn to", frame(read_only, color, depth, out), "without the usage RENDER_ATTACHMENT"),
        ("not to be read", frame(color, drawn_only, depth, out), "without the usage TEXTURE_BINDING"),
    ] {
        let mut sky = sky();
        let made = sky.frame(&mut user.backend, &day(), &targets).map(|f| [f.background, f.aerial].concat());
        let mut encoder = user.encoder();
        let drawn = made.and_then(|passes| user.backend.encode(&mut encoder, &passes));
        if word.is_empty() {
            drawn.unwrap();
            user.queue.submit([encoder.finish()]);
        } else {
            let error = drawn.expect_err(what).to_string();
            println!("{what}: {error}");
            assert!(error.contains(word), "{what}: {error}");
        }
        sky.destroy(&mut user.backend);
    }
    user.no_errors();
}

/// Reading does not wait: what was begun is there after a while, or is given up with its ticket. And there is
/// no light of passes that have not run.
#[test]
fn reads_do_not_wait_and_are_given_up() {
    on_both(|b| {
        let color = target(b, SIZE);
        let scene = day();
        let mut sky = sky();
        let passes = background_passes(b, &mut sky, &scene, cleared(color));
        assert!(sky.begin_sky_light(b).unwrap().is_none(), "light of passes that were never run");
        b.run(&passes).unwrap();
        let before = b.live();
        assert_eq!(before.reads, 0);
        let read = sky.begin_sky_light(b).unwrap().expect("light of passes that were run");
        assert_eq!(b.live().reads, 1);
        let mut light = None;
        for _ in 0..100_000 {
            light = read.poll(b).unwrap();
            if light.is_some() {
                break;
            }
            std::thread::yield_now();
        }
        let light = light.expect("light after a while").ground_irradiance(0.5).unwrap();
        assert!(light.iter().all(|v| (0.1..3.0).contains(v)), "{light:?}");
        for _ in 0..20 {
            drop(b.begin_read(color).unwrap());
            drop(b.begin_times(&passes).unwrap());
        }
        // The last is freed with the next that begins.
        assert!(b.live().reads <= 1, "{:?}: reads that were given up are kept", b.live());
        assert_eq!(Live { reads: 0, ..b.live() }, before);
        sky.destroy(b);
    });
    // Recorded, but not yet submitted.
    let mut user = User::new();
    let (mut sky, color) = (sky(), target(&mut user.backend, SIZE));
    let passes = background_passes(&mut user.backend, &mut sky, &day(), cleared(color));
    let mut encoder = user.encoder();
    user.backend.encode(&mut encoder, &passes).unwrap();
    assert!(sky.begin_sky_light(&mut user.backend).unwrap().is_none(), "light of an encoder that waits");
    user.queue.submit([encoder.finish()]);
    user.backend.wait().unwrap();
    let read = sky.begin_sky_light(&mut user.backend).unwrap().expect("light of an encoder that has run");
    let light = read.wait(&mut user.backend).unwrap().ground_irradiance(0.5).unwrap();
    assert!(light.iter().all(|v| (0.1..3.0).contains(v)), "{light:?}");
    user.no_errors();
}

/// Two eyes 65 mm apart share their LUTs, wherever on the planet they are and whichever way they look.
#[test]
fn two_eyes_share_their_luts() {
    on_both(|b| {
        let color = target(b, SIZE);
        let mut sky = sky();
        for altitude in [1.6, 1e3, 12e3, 4e5] {
            for heading in [0.0, 37.0, 90.0, 201.0] {
                let scene = View { altitude, heading, pitch: -2.0, ..View::default() }.scene();
                let right = scene.camera.forward.cross(scene.camera.up).normalize();
                let eye = |side: f64| {
                    let position = scene.camera.position + right * (side * 0.0325);
                    Scene { camera: Camera { position, ..scene.camera }, ..scene.clone() }
                };
                let [left, right] = [-1.0, 1.0].map(eye);
                let first = background_passes(b, &mut sky, &left, cleared(color));
                b.run(&first).unwrap();
                for (i, eye) in [&right, &left, &right].into_iter().enumerate() {
                    let passes = background_passes(b, &mut sky, eye, cleared(color));
                    let lut = passes.iter().find(|p| p.label.ends_with("LUT"));
                    assert!(
                        lut.is_none(),
                        "{altitude} m, {heading}°, look {i}: {:?} again",
                        lut.map(|p| p.label)
                    );
                    b.run(&passes).unwrap();
                }
            }
        }
        sky.destroy(b);
    });
}

/// Small steps add up: a LUT that is kept is not kept for ever.
#[test]
fn small_steps_add_up() {
    on_both(|b| {
        let (color, mut sky) = (target(b, SIZE), sky());
        let mut made = 0;
        for i in 0..100 {
            // A tenth of what may differ, each; ten times that in all.
            let sun_elevation = 20.0 + f64::from(i) * (1e-7_f64).to_degrees();
            let scene = View { sun_elevation, pitch: 10.0, ..View::default() }.scene();
            let passes = background_passes(b, &mut sky, &scene, cleared(color));
            made += usize::from(passes.iter().any(|p| p.label == "sky-view LUT"));
            b.run(&passes).unwrap();
        }
        assert!((6..=20).contains(&made), "made {made} times");
        sky.destroy(b);
    });
}

/// On a planet of 5 km the sky is handed over within its air, not 10 radii away.
#[test]
fn a_small_planet_hands_over_within_its_air() {
    on_both(|b| {
        let atmosphere = AtmosphereParams::earth_like(5000.0);
        let thickness = atmosphere.thickness();
        assert!(thickness < 200.0);
        let color = target(b, SIZE);
        let mut passes_at = |altitude: f64| {
            let radius = atmosphere.planet_radius;
            let scene = Scene {
                camera: Camera::new(DVec3::Z * (radius + altitude), DVec3::X, DVec3::Z, 1.0, 1.3),
                planet_center: DVec3::ZERO,
                atmosphere: atmosphere.clone(),
                sun_direction: DVec3::new(1.0, 0.0, 0.5),
                depth: DepthConvention::default(),
                moon: None,
                ellipsoid: None,
            };
            let mut sky = SkyRenderer::new(SkySettings { bound: None, ..without_disk(luts(TINY)) }).unwrap();
            let passes = background_passes(b, &mut sky, &scene, cleared(color));
            sky.destroy(b);
            passes.iter().any(|p| p.label == "background sky")
        };
        assert!(passes_at(1.0) && passes_at(0.4 * thickness));
        assert!(!passes_at(0.6 * thickness) && !passes_at(10e3));
    });
}
