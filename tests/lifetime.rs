//! Nothing is left behind: textures that no frame needs any more go, and what is in use stays as it is.

use welkin::gpu::{Backend, Target};
use welkin::{
    AtmosphereParams, Composition, LutSettings, PictureRenderer, PictureSettings, SkyRenderer, SkySettings,
};

use crate::embedding::scene;
use crate::harness::world::World;
use crate::harness::{
    TINY, View, background_passes, cleared, everything, finish, march, on_both, over_black, target,
};
use crate::plan::luts;

#[test]
fn luts_are_freed() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut world = World::new();
        let before = b.live();
        let mut frame = |b: &mut dyn Backend, i: u32| {
            world.size = [1 + i % 12, 1 + i % 8];
            world.sky.render_scale = if i.is_multiple_of(3) { 0.5 } else { 1.0 };
            // Now and then other LUTs, and another medium's.
            world.lut = LutSettings { sky_view: [8 + i % 40 / 20, 12], ..TINY };
            world.view.params =
                if i % 20 < 10 { AtmosphereParams::earth() } else { AtmosphereParams::rayleigh() };
            world.sky.look.composition =
                if i.is_multiple_of(5) { Composition::SkyDome } else { Composition::Full };
            let settings = over_black(world.sky());
            renderer.draw(b, &world.view.scene(), &settings, world.size).unwrap();
            if i.is_multiple_of(20) {
                finish(b);
            }
        };
        (0..120).for_each(|i| frame(b, i));
        let after_few = b.live();
        assert!(after_few.textures > before.textures + 4 + 5);
        // A multiple of every period, so that the last frame is alike.
        let frames = if everything() { 1200 } else { 120 };
        (120..120 + frames).for_each(|i| frame(b, i));
        assert_eq!(b.live(), after_few);
        renderer.destroy(b);
        let left = b.live();
        assert_eq!((left.textures, left.framebuffers), (before.textures, before.framebuffers));
    });
}

#[test]
fn nothing_leaks_over_many_sizes_and_settings() {
    on_both(|backend| {
        let mut renderer = PictureRenderer::default();
        let mut settings = PictureSettings { terrain: None, ..PictureSettings::default() };
        settings.sky.quality = march(2, 1);
        let mut draw = |backend: &mut dyn Backend, i: u32| {
            settings.sky.render_scale = if i.is_multiple_of(2) { 1.0 } else { 0.5 };
            renderer.draw(backend, &scene(), &settings, [1 + i % 13, 1 + i % 7]).unwrap();
            if i.is_multiple_of(20) {
                finish(backend);
            }
        };
        (0..4).for_each(|i| draw(backend, i));
        let after_few = backend.live();
        // Every size at either scale, twice.
        let frames = if everything() { 2000 } else { 4 * 7 * 13 };
        (0..frames).for_each(|i| draw(backend, i));
        (0..4).for_each(|i| draw(backend, i));
        assert_eq!(backend.live(), after_few);
        renderer.destroy(backend);
        let left = backend.live();
        assert_eq!((left.textures, left.framebuffers), (0, 0));
        // Passes without textures (the sky's and the sun's) keep their bind groups with their programs.
        assert!(left.bind_groups <= 2, "{left:?}");
    });
}

/// LUTs that the plan has no use for are freed after a while, and made again when it has.
#[test]
fn luts_go_when_the_camera_stays_away() {
    on_both(|b| {
        let mut renderer =
            SkyRenderer::new(SkySettings { quality: luts(), ..SkySettings::default() }).unwrap();
        let color = target(b, [4, 4]);
        let before = b.live().textures;
        let day = View { pitch: 20.0, ..View::default() }.scene();
        let away = View { altitude: 4e5, pitch: 60.0, heading: 180.0, ..View::default() }.scene();
        assert!(!background_passes(b, &mut renderer, &day, Target::color(color)).is_empty());
        let with = b.live().textures;
        assert!(with > before + 4);
        for _ in 0..100 {
            assert!(background_passes(b, &mut renderer, &away, Target::color(color)).is_empty());
        }
        assert_eq!(b.live().textures, with, "gone at once: turning back would make them again");
        for _ in 0..1000 {
            assert!(background_passes(b, &mut renderer, &away, Target::color(color)).is_empty());
        }
        assert_eq!(b.live().textures, before);
        let again = background_passes(b, &mut renderer, &day, Target::color(color));
        assert!(again.iter().any(|p| p.label == "multi-scattering LUT"));
        renderer.destroy(b);
        b.destroy_texture(color);
    });
}

/// Night and day in turn make nothing anew but the LUTs of the camera; what night has no use for goes after
/// a while.
#[test]
fn a_night_keeps_the_luts_of_the_medium_for_a_while() {
    on_both(|b| {
        let mut renderer =
            SkyRenderer::new(SkySettings { quality: luts(), ..SkySettings::default() }).unwrap();
        let color = target(b, [4, 4]);
        let scene =
            |sun_elevation| View { sun_elevation, pitch: 20.0, heading: 180.0, ..View::default() }.scene();
        let [day, night] = [30.0, -60.0].map(scene);
        let mut labels = |b: &mut dyn Backend, scene| -> Vec<&str> {
            let passes = background_passes(b, &mut renderer, scene, cleared(color));
            b.run(&passes).unwrap();
            passes.iter().map(|p| p.label).collect()
        };
        assert!(labels(b, &day).contains(&"multi-scattering LUT"));
        let with = b.live().textures;
        for _ in 0..3 {
            assert_eq!(labels(b, &night), ["sky-view LUT", "background sky"]);
            // The aerosol's light is still that of this day.
            assert_eq!(labels(b, &day), ["sky-view LUT", "background sky"]);
        }
        assert_eq!(b.live().textures, with);
        for i in 0..700 {
            labels(b, &night);
            if i % 20 == 0 {
                finish(b);
            }
        }
        assert_eq!(
            b.live().textures,
            with - 4,
            "gathered radiance, two LUTs of moments, the aerosol's light"
        );
        assert!(labels(b, &day).contains(&"multi-scattering LUT"));
        renderer.destroy(b);
        b.destroy_texture(color);
    });
}
