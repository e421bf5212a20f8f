//! A lost device is an error, a renderer that was kept draws on a new device what a new one draws, and
//! contexts come and go without harm to each other.

use welkin::gpu::egl::Headless;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, Pass, TextureDesc, TextureId};
use welkin::{Error, ErrorKind, PictureRenderer, PictureSettings, SkyRenderer};

use crate::embedding::{own, scene, small};
use crate::harness::world::{World, fresh_picture, whole_picture};
use crate::harness::{background_passes, cleared, on_both, texture};

/// After a device was lost, a renderer that was kept draws on a new one what a fresh one draws.
#[test]
fn a_renderer_outlives_its_device() {
    fn outlive<M>(
        open: impl Fn() -> M,
        backend: impl Fn(&mut M) -> &mut dyn Backend,
        lose: impl Fn(&mut M),
        others: usize,
    ) {
        let (world, settings) = (World::new(), PictureSettings::default());
        let mut kept = PictureRenderer::default();
        let mut machine = open();
        let want = fresh_picture(backend(&mut machine), &world, &settings);
        for round in 0..3 {
            let b = backend(&mut machine);
            // Textures of the user's, with the ids that the renderer's had.
            let users: Vec<_> =
                (0..round * others).map(|_| texture(b, "user's", [10, 8], Format::Rgba32Float)).collect();
            users.iter().for_each(|&id| b.write_texture(id, &[0.25; 320]).unwrap());
            assert!(
                whole_picture(b, &mut kept, &world, &settings) == want,
                "{others} textures, round {round}"
            );
            for &id in &users {
                let pixels = b.texture(id).map(|_| b.read(id).unwrap());
                assert!(pixels.is_some_and(|p| p.iter().all(|v| *v == 0.25)), "a user's texture was taken");
            }
            lose(&mut machine);
            let lost = kept.draw(backend(&mut machine), &world.view.scene(), &settings, [10, 8]);
            assert!(lost.is_err(), "drawn on a lost device");
            // The old context goes before the new one is made current.
            drop(machine);
            machine = open();
        }
    }
    for others in [0, 1, 4] {
        let open = || WgpuBackend::headless().unwrap();
        outlive(open, |b| b, |b: &mut WgpuBackend| b.device().destroy(), others);
        let open = || Headless::new().unwrap();
        outlive(open, |h| &mut h.backend, |h: &mut Headless| h.backend.set_lost("on purpose"), others);
    }
}

/// After a device was lost the user has a new one, with textures of his own.
#[test]
fn luts_of_a_lost_device_are_forgotten() {
    let world = World::new();
    let scene = world.view.scene();
    let target_of = |b: &mut dyn Backend| texture(b, "user's", [10, 8], Format::Rgba32Float);
    let sky_over = |b: &mut dyn Backend, sky: &mut SkyRenderer, target: TextureId| {
        let passes = background_passes(b, sky, &scene, cleared(target));
        let sky_or_sun = |p: &&Pass| ["background sky", "sun"].contains(&p.label);
        let drawn = passes.iter().filter(|p| p.target.color == target).count();
        assert!(drawn > 0 && passes.iter().filter(sky_or_sun).count() == drawn);
        b.run(&passes).unwrap();
        b.read(target).unwrap()
    };
    let settings = small();
    // As many textures of the user's as there may be before the first LUT, so that the ids meet.
    for own in [0, 1, 7] {
        let mut kept = SkyRenderer::new(settings).unwrap();
        let mut want = Vec::new();
        on_both(|b| {
            let target = target_of(b);
            let mut fresh = SkyRenderer::new(settings).unwrap();
            want.push(sky_over(b, &mut fresh, target));
            fresh.destroy(b);
        });
        let mut seen = 0;
        on_both(|b| {
            let target = target_of(b);
            let users: Vec<_> = (0..if seen == 0 { 0 } else { own }).map(|_| target_of(b)).collect();
            users.iter().for_each(|&id| b.write_texture(id, &[0.25; 320]).unwrap());
            let got = sky_over(b, &mut kept, target);
            assert!(got == want[seen], "{own} textures: the new device's sky is not drawn from its own LUTs");
            for &id in &users {
                let pixels = b.texture(id).map(|_| b.read(id).unwrap());
                assert!(
                    pixels.is_some_and(|p| p.iter().all(|v| *v == 0.25)),
                    "{own}: a user's texture was taken"
                );
            }
            seen += 1;
        });
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
        let settings = PictureSettings { sky: small(), ..PictureSettings::default() };
        sky.draw(&mut backend, &scene(), &settings, [4, 4]).map(|_| ())
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
