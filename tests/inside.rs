//! Drawing inside a render pass of the user's, and to a part of a target.

use welkin::frame::tone_map::tone_pass;
use welkin::gpu::wgpu::OpenPass;
use welkin::gpu::{Backend, Format, RowOrder, Target, TextureDesc, TextureId, Viewport};
use welkin::{AerialTargets, Composition, FrameTargets, Scene, SkyRenderer, SkySettings, ToneMap};

use crate::encoders::User;
use crate::harness::*;

const SIZE: [u32; 2] = [24, 16];

/// Views with the sun's disk in them, or a shell before the scene.
fn scenes() -> [(&'static str, Scene, SkySettings); 2] {
    let sunset = View { pitch: 4.0, sun_elevation: 5.0, ..View::default() }.scene();
    let orbit = View { altitude: 4e5, pitch: -18.0, sun_elevation: 40.0, ..View::default() }.scene();
    let dome = with_disk(true, composed(Composition::SkyDome, luts(TINY)));
    [("sunset", sunset, dome), ("orbit", orbit, composed(Composition::Planet, luts(TINY)))]
}

/// Radiance of a frame that is drawn to textures of its own.
fn alone(b: &mut dyn Backend, scene: &Scene, sky: SkySettings, size: [u32; 2]) -> Vec<f32> {
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let [color, depth] = ["color", "depth"].map(|name| {
        texture(b, name, size, if name == "color" { Format::Rgba32Float } else { Format::R32Float })
    });
    let stored = scene.depth.background() as f32;
    b.run(&[clear_pass(depth, [stored; 4]), clear_pass(color, [0.0, 0.0, 0.0, 1.0])]).unwrap();
    let targets = FrameTargets {
        background: Some(Target::color(color)),
        aerial: Some(AerialTargets { color: None, depth, target: Target::color(color) }),
        ..FrameTargets::default()
    };
    // A dome draws nothing over the scene; what it would read of it is any other texture.
    let other = target(b, size);
    let aerial = targets.aerial.map(|a| AerialTargets { color: Some(other), ..a });
    let frame = renderer.frame(b, scene, &FrameTargets { aerial, ..targets }).unwrap();
    let passes: Vec<_> = frame.background.iter().chain(frame.aerial).cloned().collect();
    b.run(&passes).unwrap();
    let pixels = b.read(color).unwrap();
    renderer.destroy(b);
    free(b, [color, depth, other]);
    pixels
}

/// A multisampled texture of the user's with depth, and the texture that it resolves to.
struct Multisampled {
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
    resolved: wgpu::Texture,
}

impl Multisampled {
    const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
    const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;
    const OPEN: OpenPass = OpenPass { size: SIZE, color: Self::COLOR, depth: Some(Self::DEPTH), samples: 4 };

    fn new(user: &User) -> Self {
        let texture = |format, sample_count| {
            user.device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | if sample_count == 1 {
                        wgpu::TextureUsages::TEXTURE_BINDING
                    } else {
                        wgpu::TextureUsages::empty()
                    },
                view_formats: &[],
            })
        };
        let view = |texture: wgpu::Texture| texture.create_view(&Default::default());
        Self {
            color: view(texture(Self::COLOR, 4)),
            depth: view(texture(Self::DEPTH, 4)),
            resolved: texture(Self::COLOR, 1),
        }
    }

    /// Begins the user's pass, cleared to opaque black, and draws in it.
    fn pass(&self, encoder: &mut wgpu::CommandEncoder, draw: impl FnOnce(&mut wgpu::RenderPass<'_>)) {
        let resolved = self.resolved.create_view(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: None,
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: Some(&resolved),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.5),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
    }

    /// What it resolved to.
    fn read(&self, user: &mut User) -> Vec<f32> {
        let id = user.backend.import_texture("resolved", &self.resolved).unwrap();
        let copy = texture(&mut user.backend, "copy", SIZE, Format::Rgba32Float);
        let pass = copy_pass(&mut user.backend, id, copy);
        user.backend.run(&[pass]).unwrap();
        let pixels = user.backend.read(copy).unwrap();
        free(&mut user.backend, [id, copy]);
        pixels
    }
}

/// Fails unless two pictures are the same but for the rounding of halves.
#[track_caller]
fn assert_same(what: &str, a: &[f32], b: &[f32]) {
    assert_same_but(what, a, b, 2e-3, |_| false);
}

/// The same where a pixel is not left out, to a fraction of its light.
#[track_caller]
fn assert_same_but(what: &str, a: &[f32], b: &[f32], within: f64, left_out: impl Fn(usize) -> bool) {
    let (a, b) = (colors(a), colors(b));
    let most = brightest(&b).into_iter().fold(0.0, f64::max);
    assert!(most > 0.0, "{what}: all is black");
    for (i, (p, q)) in a.iter().zip(&b).enumerate().filter(|(i, _)| !left_out(*i)) {
        for c in 0..3 {
            let off = (p[c] - q[c].min(65504.0)).abs();
            assert!(off < within * q[c] + 1e-6 * most, "{what}: pixel {i} is {p:?}, not {q:?}");
        }
    }
}

/// The frame of a scene inside the user's pass: the sky behind, then the air of a shell.
fn inside(user: &mut User, scene: &Scene, sky: SkySettings, bundled: bool) -> Vec<f32> {
    let canvas = Multisampled::new(user);
    let open = user.backend.import_pass("the user's pass", Multisampled::OPEN).unwrap();
    let depth = texture(&mut user.backend, "depth", SIZE, Format::R32Float);
    let other = target(&mut user.backend, SIZE);
    user.backend.run(&[clear_pass(depth, [scene.depth.background() as f32; 4])]).unwrap();
    let aerial = AerialTargets { color: Some(other), depth, target: Target::color(open) };
    let targets = FrameTargets::background(Target::color(open)).with_aerial(aerial);
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let mut encoder = user.encoder();
    let frame = renderer.frame(&mut user.backend, scene, &targets).unwrap();
    let before = user.backend.encode_in(&mut encoder, frame.background).unwrap();
    let after = user.backend.encode_in(&mut encoder, frame.aerial).unwrap();
    assert!(!(before.is_empty() && after.is_empty()));
    let bundle = bundled.then(|| {
        let mut bundle = user.device.create_render_bundle_encoder(&wgpu::RenderBundleEncoderDescriptor {
            label: None,
            color_formats: &[Some(Multisampled::COLOR)],
            depth_stencil: Some(wgpu::RenderBundleDepthStencil {
                format: Multisampled::DEPTH,
                depth_read_only: false,
                stencil_read_only: false,
            }),
            sample_count: 4,
            multiview: None,
        });
        before.draw_in_bundle(&mut bundle);
        after.draw_in_bundle(&mut bundle);
        bundle.finish(&Default::default())
    });
    canvas.pass(&mut encoder, |pass| match &bundle {
        Some(bundle) => pass.execute_bundles([bundle]),
        None => {
            before.draw(pass);
            after.draw(pass);
        }
    });
    user.queue.submit([encoder.finish()]);
    let pixels = canvas.read(user);
    user.no_errors();
    renderer.destroy(&mut user.backend);
    free(&mut user.backend, [open, depth, other]);
    pixels
}

#[test]
fn a_users_multisampled_pass_holds_what_a_texture_holds() {
    let mut user = User::new();
    for (name, scene, sky) in scenes() {
        let wanted = alone(&mut user.backend, &scene, sky, SIZE);
        for bundled in [false, true] {
            let what = format!("{name}, {}", if bundled { "in a bundle" } else { "in the pass" });
            let got = inside(&mut user, &scene, sky, bundled);
            // Samples lie around a pixel's middle: at edges they see another part of them.
            let edge = |i: usize| near(i).any(|j| (rgb(&wanted, j)[1] / rgb(&wanted, i)[1]).ln().abs() > 0.5);
            let edges = (0..(SIZE[0] * SIZE[1]) as usize).filter(|i| edge(*i)).count();
            assert!((10..150).contains(&edges), "{edges} pixels at edges");
            assert_same_but(&what, &got, &wanted, 0.03, |i| rgb(&wanted, i)[1] == 0.0 || edge(i));
        }
    }
    // Nothing is left but what the user holds.
    assert_eq!(user.backend.live().textures, 0);
}

/// The pixels around one, those of the same picture.
fn near(i: usize) -> impl Iterator<Item = usize> {
    let [w, h] = SIZE.map(|side| side as usize);
    let (x, y) = (i % w, i / w);
    let rows = y.saturating_sub(1)..(y + 2).min(h);
    rows.flat_map(move |y| (x.saturating_sub(1)..(x + 2).min(w)).map(move |x| y * w + x))
}

/// Where several samples make a pixel, the horizon and the disks have edges as smooth as a scene's: a sky
/// that is computed once a pixel would show black beside a ground that covers some samples.
#[test]
fn edges_inside_a_users_pass_are_as_smooth_as_its_samples() {
    let mut user = User::new();
    let (_, scene, sky) = scenes()[0].clone();
    let got = inside(&mut user, &scene, sky, false);
    let green = |x: u32, y: u32| rgb(&got, (y * SIZE[0] + x) as usize)[1];
    // From the ground straight up: nothing, a part of the sky's light, all of it.
    let mut parts: Vec<f64> = Vec::new();
    for x in 0..SIZE[0] {
        let first = (0..SIZE[1]).rfind(|&y| green(x, y) > 0.0).unwrap();
        parts.push(green(x, first) / green(x, first - 1));
    }
    println!("at the horizon: {parts:.2?}");
    assert!(parts.iter().any(|part| (0.1..0.9).contains(part)), "the horizon is a staircase: {parts:?}");
}

/// Two views in one pass have a renderer each, or an error, but never the other's LUTs.
#[test]
fn views_of_one_pass_do_not_share_a_renderer() {
    let mut user = User::new();
    let [(_, ground, sky), (_, orbit, _)] = scenes();
    let open = user.backend.import_pass("the user's pass", Multisampled::OPEN).unwrap();
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let half = |x| Viewport { x, y: 0, width: SIZE[0] / 2, height: SIZE[1] };
    let targets = |x| FrameTargets::background(Target { viewport: Some(half(x)), ..Target::color(open) });
    let mut encoder = user.encoder();
    let frame = renderer.frame(&mut user.backend, &ground, &targets(0)).unwrap();
    let left = user.backend.encode_in(&mut encoder, frame.background).unwrap();
    let frame = renderer.frame(&mut user.backend, &orbit, &targets(SIZE[0] / 2)).unwrap();
    let error = user.backend.encode_in(&mut encoder, frame.background).map(drop).unwrap_err().to_string();
    assert!(error.contains("a SkyRenderer for each view of one pass"), "{error}");
    // Drawn, or given up, it stands in nobody's way; the viewport comes with it.
    let canvas = Multisampled::new(&user);
    canvas.pass(&mut encoder, |pass| left.draw(pass));
    let frame = renderer.frame(&mut user.backend, &orbit, &targets(SIZE[0] / 2)).unwrap();
    drop(user.backend.encode_in(&mut encoder, frame.background).unwrap());
    let frame = renderer.frame(&mut user.backend, &ground, &targets(0)).unwrap();
    drop(user.backend.encode_in(&mut encoder, frame.background).unwrap());
    user.queue.submit([encoder.finish()]);
    let pixels = canvas.read(&mut user);
    let lit = |x: u32| (0..SIZE[1]).any(|y| rgb(&pixels, (y * SIZE[0] + x) as usize)[1] > 0.0);
    assert!(lit(SIZE[0] / 2 - 1) && !lit(SIZE[0] / 2), "the viewport ends in the middle");
    user.no_errors();
}

/// Tones are mapped in a pass of the user's as to a texture.
#[test]
fn tones_are_mapped_inside_a_users_pass() {
    let mut user = User::new();
    let (_, scene, sky) = scenes()[0].clone();
    let radiance = target(&mut user.backend, SIZE);
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let passes = background_passes(&mut user.backend, &mut renderer, &scene, cleared(radiance));
    user.backend.run(&passes).unwrap();
    let shown = texture(&mut user.backend, "shown", SIZE, Format::Rgba16Float);
    let to_texture = tone_pass(&mut user.backend, ToneMap::AgX, 0.7, false, radiance, shown).unwrap();
    user.backend.run(&[to_texture]).unwrap();
    let wanted = user.backend.read(shown).unwrap();

    let canvas = Multisampled::new(&user);
    let open = user.backend.import_pass("the user's pass", Multisampled::OPEN).unwrap();
    let pass = tone_pass(&mut user.backend, ToneMap::AgX, 0.7, false, radiance, open).unwrap();
    let mut encoder = user.encoder();
    let inside = user.backend.encode_in(&mut encoder, &[pass]).unwrap();
    canvas.pass(&mut encoder, |pass| inside.draw(pass));
    user.queue.submit([encoder.finish()]);
    assert_same("tones", &canvas.read(&mut user), &wanted);
    user.no_errors();
}

/// What a pass of the user's cannot do is an error before anything is recorded.
#[test]
fn what_an_open_pass_cannot_do_is_refused() {
    let mut user = User::new();
    let (_, scene, sky) = scenes()[0].clone();
    let open = user.backend.import_pass("mine", Multisampled::OPEN).unwrap();
    let mut renderer = SkyRenderer::new(sky).unwrap();
    let depth = texture(&mut user.backend, "depth", SIZE, Format::Depth32Float);
    let asked = Target::color(open);
    for (target, word) in [
        (cleared(open), "mine.clear = one"),
        (Target { clear_depth: Some(0.0), ..asked }, "mine.clear_depth = one"),
        (Target { depth: Some(depth), ..asked }, "mine.depth = one"),
    ] {
        let targets = FrameTargets::background(target);
        let error = renderer.frame(&mut user.backend, &scene, &targets).unwrap_err().to_string();
        assert!(error.starts_with(word), "{error}");
    }
    let mut encoder = user.encoder();
    let passes = background_passes(&mut user.backend, &mut renderer, &scene, asked);
    let error = user.backend.encode(&mut encoder, &passes).unwrap_err().to_string();
    assert!(error.contains("draw in a pass with WgpuBackend::encode_in"), "{error}");
    let mut own = passes.clone();
    own.iter_mut().for_each(|pass| pass.target.clear = Some([0.0; 4]));
    let error = user.backend.encode_in(&mut encoder, &own).map(drop).unwrap_err().to_string();
    assert!(error.starts_with("mine.clear = one"), "{error}");
    let out = target(&mut user.backend, SIZE);
    let reads = copy_pass(&mut user.backend, open, out);
    let error = user.backend.encode(&mut encoder, &[reads]).unwrap_err().to_string();
    assert!(error.contains("mine (a pass of the user's)"), "{error}");
    assert!(user.backend.read(open).is_err());
    for (bad, word) in [
        (OpenPass { samples: 3, ..Multisampled::OPEN }, "3 samples"),
        (OpenPass { color: wgpu::TextureFormat::Depth32Float, ..Multisampled::OPEN }, "bad.formats"),
        (OpenPass { depth: Some(Multisampled::COLOR), ..Multisampled::OPEN }, "bad.formats"),
        (OpenPass { color: wgpu::TextureFormat::Rgba8Uint, ..Multisampled::OPEN }, "cannot blend"),
        (OpenPass { size: [0, 4], ..Multisampled::OPEN }, "bad.width = 0"),
    ] {
        let error = user.backend.import_pass("bad", bad).unwrap_err().to_string();
        assert!(error.contains(word), "{error}");
    }
    user.no_errors();
}

/// Two views beside each other in one target, in either order of rows, are the views alone.
#[test]
fn viewports_hold_what_a_target_of_their_size_holds() {
    on_both(|b| {
        for (rows, (name, scene, sky)) in [RowOrder::TopDown, RowOrder::BottomUp].into_iter().zip(scenes()) {
            let size = [SIZE[0] + 7, SIZE[1] + 5];
            let make = |b: &mut dyn Backend, format| {
                b.create_texture(&TextureDesc { rows, ..TextureDesc::new("split", size[0], size[1], format) })
                    .unwrap()
            };
            let (color, depth, other) =
                (make(b, Format::Rgba32Float), make(b, Format::R32Float), make(b, Format::Rgba32Float));
            let stored = scene.depth.background() as f32;
            b.run(&[clear_pass(depth, [stored; 4]), clear_pass(color, [0.25, 0.5, 0.75, 1.0])]).unwrap();
            let viewport = Viewport { x: 7, y: 3, width: SIZE[0], height: SIZE[1] };
            let within = Target { viewport: Some(viewport), ..Target::color(color) };
            let black = Target { clear: Some([0.0, 0.0, 0.0, 1.0]), ..within };
            let aerial = AerialTargets { color: Some(other), depth, target: within };
            let targets = FrameTargets::background(black).with_aerial(aerial);
            let mut renderer = SkyRenderer::new(sky).unwrap();
            let frame = renderer.frame(b, &scene, &targets).unwrap();
            let passes: Vec<_> = frame.background.iter().chain(frame.aerial).cloned().collect();
            b.run(&passes).unwrap();
            let whole = b.read(color).unwrap();
            let part: Vec<f32> = (0..SIZE[1])
                .flat_map(|y| {
                    // The viewport's rows in the target's order, the picture's from the top.
                    let row = if rows == RowOrder::TopDown { y } else { SIZE[1] - 1 - y };
                    let at = 4 * ((3 + row) * size[0] + 7) as usize;
                    whole[at..at + 4 * SIZE[0] as usize].to_vec()
                })
                .collect();
            let wanted = alone(b, &scene, sky, SIZE);
            assert_same(&format!("{name}, {rows:?}"), &part, &wanted);
            // Around it is what the clear left.
            let outside = (0..size[0] * size[1]).filter(|i| {
                let (x, y) = (i % size[0], i / size[0]);
                !((7..7 + SIZE[0]).contains(&x) && (3..3 + SIZE[1]).contains(&y))
            });
            for i in outside {
                assert_eq!(rgb(&whole, i as usize), [0.0; 3], "{name}: pixel {i}");
            }
            renderer.destroy(b);
            free(b, [color, depth, other]);
        }
    });
}

#[test]
fn viewports_out_of_range_are_refused() {
    on_both(|b| {
        let (_, scene, sky) = scenes()[0].clone();
        let color: TextureId = target(b, SIZE);
        let mut renderer = SkyRenderer::new(sky).unwrap();
        let refusal = |b: &mut dyn Backend, renderer: &mut SkyRenderer, viewport| {
            let within = Target { viewport: Some(viewport), ..Target::color(color) };
            renderer.frame(b, &scene, &FrameTargets::background(within)).unwrap_err().to_string()
        };
        let whole = Viewport { x: 0, y: 0, width: SIZE[0], height: SIZE[1] };
        for (viewport, word) in [
            (Viewport { x: 1, ..whole }, "target.viewport.width = 24 from 1 on"),
            (Viewport { height: 0, ..whole }, "target.viewport.height = 0 from 0 on"),
            (Viewport { y: u32::MAX, ..whole }, "target.viewport.height = 16 from 4294967295 on"),
        ] {
            let error = refusal(b, &mut renderer, viewport);
            assert!(error.starts_with(word), "{error}");
        }
        renderer.set_settings(SkySettings { render_scale: 0.5, ..sky }).unwrap();
        let error = refusal(b, &mut renderer, whole);
        assert!(error.starts_with("render_scale = 0.5"), "{error}");
        b.destroy_texture(color);
    });
}

/// The eyes of a headset are layers of one texture: each is a target, and both share their LUTs.
#[test]
fn layers_of_an_array_are_targets() {
    let mut user = User::new();
    let (_, scene, sky) = scenes()[0].clone();
    let array = user.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 2 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba16Float,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let eyes = [-0.0325, 0.0325].map(|aside| {
        let mut eye = scene.clone();
        eye.camera.position += eye.camera.forward.cross(eye.camera.up).normalize() * aside;
        eye
    });
    let mut renderer = SkyRenderer::new(sky).unwrap();
    for (layer, eye) in (0..).zip(&eyes) {
        let view = array.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2),
            base_array_layer: layer,
            array_layer_count: Some(1),
            ..Default::default()
        });
        let desc = TextureDesc::new("eye", SIZE[0], SIZE[1], Format::Rgba16Float);
        let id = user.backend.import_view(view, desc).unwrap();
        let passes = background_passes(&mut user.backend, &mut renderer, eye, cleared(id));
        let luts = passes.iter().filter(|p| p.label.ends_with("LUT")).count();
        assert_eq!(luts > 0, layer == 0, "the second eye has the first one's LUTs");
        user.frame(&passes);
        let copy = texture(&mut user.backend, "copy", SIZE, Format::Rgba32Float);
        let read = copy_pass(&mut user.backend, id, copy);
        user.frame(&[read]);
        let got = user.backend.read(copy).unwrap();
        assert_same("an eye", &got, &alone(&mut user.backend, eye, sky, SIZE));
        free(&mut user.backend, [id, copy]);
    }
    user.no_errors();
}
