//! No LUT is ever stale: whatever a renderer has drawn before, it draws what a new one draws; and nothing is
//! made again without need.

use welkin::gpu::{Backend, Format, Pass, TextureId};
use welkin::{AtmosphereParams, PictureRenderer, PictureSettings, SkyRenderer, TerrainStyle, ToneMap};

use crate::harness::world::{World, changes, fresh_picture, whole_picture};
use crate::harness::{assert_physical, on_both, over_black, picture_passes};

#[test]
fn no_lut_is_ever_stale() {
    on_both(|b| {
        let base = World::new();
        let want = base.draw_fresh(b);
        let mut renderer = SkyRenderer::default();
        assert!(base.draw(b, &mut renderer) == want);
        for (name, apply) in changes() {
            let mut world = base.clone();
            apply(&mut world);
            let changed = world.draw_fresh(b);
            assert_physical(&changed, &name);
            assert!(changed != want, "{name} changes nothing: not a test");
            // There and back.
            assert!(world.draw(b, &mut renderer) == changed, "{name}: a LUT is stale");
            assert!(base.draw(b, &mut renderer) == want, "{name}: a LUT is stale on the way back");
        }
        // A day in fast motion.
        for i in 0..24 {
            let mut world = base.clone();
            world.view.sun_elevation = 180.0 - 15.0 * f64::from(i);
            assert!(world.draw(b, &mut renderer) == world.draw_fresh(b), "hour {i}");
        }
        renderer.destroy(b);
    });
}

/// One change upon the other, never back: whatever a renderer has drawn before, it draws what a fresh one
/// does.
#[test]
fn a_kept_renderer_draws_what_a_fresh_one_does() {
    on_both(|b| {
        let mut kept = PictureRenderer::default();
        let (mut world, mut settings) = (World::new(), PictureSettings::default());
        let mut last = [Vec::new(), Vec::new()];
        let mut changed = 0;
        let mut check = |world: &World, settings: &PictureSettings, what: &str| {
            let want = fresh_picture(b, world, settings);
            let got = whole_picture(b, &mut kept, world, settings);
            assert_physical(&got[0], what);
            assert!(got == want, "{what}: not what a fresh renderer draws");
            changed += usize::from(got != last);
            last = got;
        };
        check(&world, &settings, "first");
        for planet in ["mars", "venus", "earth", "venus", "mars", "earth-like", "rayleigh", "earth"] {
            world.view.params = AtmosphereParams::preset(planet).unwrap();
            settings.terrain = Some(TerrainStyle::dry(&world.view.params));
            check(&world, &settings, planet);
        }
        type Own = (&'static str, fn(&mut PictureSettings));
        let own: [Own; 9] = [
            ("exposure", |s| s.exposure = 3.0),
            ("agx", |s| s.tone_map = ToneMap::AgX),
            ("neutral", |s| s.tone_map = ToneMap::Neutral),
            ("no dither", |s| s.dither = false),
            ("32 bits", |s| s.radiance = Format::Rgba32Float),
            ("terrain", |s| s.terrain = Some(TerrainStyle::earth())),
            ("no terrain", |s| s.terrain = None),
            ("16 bits", |s| s.radiance = Format::Rgba16Float),
            ("dither", |s| s.dither = true),
        ];
        for (what, apply) in own {
            apply(&mut settings);
            check(&world, &settings, what);
        }
        // Each input of a sky on top of the ones before; off is followed by on.
        for (what, apply) in changes() {
            apply(&mut world);
            check(&world, &settings, &what);
            world.sky.look.enabled = true;
        }
        world = World::new();
        // A day in fast motion, from deep night to the zenith and back, and a climb.
        for i in 0..=22 {
            world.view.sun_elevation = 90.0 - 10.0 * (f64::from(i) - 11.0).abs();
            check(&world, &settings, &format!("sun {}", world.view.sun_elevation));
        }
        for i in 0..=16 {
            world.view.altitude = 2.0 * 5e8_f64.powf(f64::from(i) / 16.0);
            check(&world, &settings, &format!("{} m", world.view.altitude));
        }
        // Some change nothing: ozone without its layer, the sun's size behind the camera.
        assert!(changed > 80, "only {changed} changes changed the picture: not a test");
        kept.destroy(b);
    });
}

/// Labels of the passes that fill LUTs, without repetitions.
fn filled(passes: &[Pass]) -> Vec<&'static str> {
    let mut labels: Vec<_> = passes.iter().map(|p| p.label).filter(|l| l.ends_with("LUT")).collect();
    labels.dedup();
    labels
}

#[test]
fn only_stale_luts_are_made_again() {
    const ALL: [&str; 4] = ["transmittance LUT", "multi-scattering LUT", "sky-view LUT", "aerial LUT"];
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let mut next = |world: &World| {
            let settings = over_black(world.sky());
            let passes = picture_passes(b, &mut renderer, &world.view.scene(), &settings, world.size);
            b.run(&passes).unwrap();
            filled(&passes)
        };
        let mut world = World::new();
        assert_eq!(next(&world), ALL);
        assert!(next(&world).is_empty(), "nothing has changed");
        world.view.heading += 30.0;
        assert!(next(&world).is_empty(), "the camera has turned");
        world.view.pitch += 30.0;
        world.view.fov = 30.0;
        assert!(next(&world).is_empty(), "the camera has turned");
        world.view.params.sun_intensity *= 2.0;
        world.view.params.sun_angular_radius *= 2.0;
        assert!(next(&world).is_empty(), "the LUTs know nothing of the sun's light and size");
        world.sky.look.sun_disk = false;
        world.sky.render_scale = 0.5;
        assert!(next(&world).is_empty(), "the same LUTs");
        world.view.sun_elevation += 1.0;
        assert_eq!(next(&world), ALL[2..], "the sun has moved");
        world.view.altitude += 1.0;
        assert_eq!(next(&world), ALL[2..], "the camera has risen");
        world.view.params.mie_scattering[1] *= 1.1;
        assert_eq!(next(&world), ALL, "another medium");
        world.view.params.ground_albedo[2] *= 0.9;
        assert_eq!(next(&world), ALL, "another ground");
        assert!(next(&world).is_empty());
        world.size = [20, 30];
        assert!(next(&world).is_empty(), "LUTs do not depend on the picture's size");
        renderer.destroy(b);
    });
}

/// How often light is scattered depends on the medium more finely than the medium's 32-bit numbers do.
#[test]
fn the_number_of_orders_is_never_stale() {
    on_both(|b| {
        let mut world = World::new();
        let passes = |b: &mut dyn Backend, world: &World| {
            let mut renderer = PictureRenderer::default();
            let settings = over_black(world.sky());
            let n = picture_passes(b, &mut renderer, &world.view.scene(), &settings, world.size).len();
            renderer.destroy(b);
            n
        };
        let scattering = |w: &mut World, v: f64| w.view.params.rayleigh_scattering[2] = v;
        let (mut low, mut high) = (33.1e-6, 200e-6);
        scattering(&mut world, low);
        let few = passes(b, &world);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            scattering(&mut world, middle);
            *(if passes(b, &world) == few { &mut low } else { &mut high }) = middle;
        }
        assert!((high - low) / low < 1e-14 && (low * 1e3) as f32 == (high * 1e3) as f32, "{low} {high}");
        let mut renderer = SkyRenderer::default();
        for v in [low, high, low] {
            scattering(&mut world, v);
            assert!(world.draw(b, &mut renderer) == world.draw_fresh(b), "{v} of {low} {high}");
        }
        renderer.destroy(b);
    });
}

/// A LUT that somebody freed is made again, and with it what depends on it.
#[test]
fn lost_textures_are_made_again() {
    on_both(|b| {
        let world = World::new();
        let want = world.draw_fresh(b);
        for label in
            ["transmittance_lut", "gathered_radiance", "multi_scattering_lut", "sky_view_lut", "aerial_lut"]
        {
            let mut sky = SkyRenderer::default();
            let (passes, _) = world.run(b, &mut sky);
            let label_of = |id: TextureId| b.texture(id).map(|d| d.label);
            let lost = passes.iter().map(|p| p.target.color).find(|&id| label_of(id) == Some(label));
            b.destroy_texture(lost.unwrap());
            assert!(world.draw(b, &mut sky) == want, "without its {label}");
            sky.destroy(b);
        }
    });
}
