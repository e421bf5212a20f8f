//! Wrong input: each is refused with a message that names field, value and range, before anything is made.

use std::time::Duration;

use glam::DVec3;
use welkin::gpu::Program;
use welkin::gpu::{Backend, Format, Inputs, Pass, Target, TextureDesc};
use welkin::settings::front::ParetoFront;
use welkin::shaders::copy;
use welkin::{
    AtmosphereParams, Camera, DepthConvention, Error, PictureRenderer, PictureSettings, Pose, Quality, Scene,
    SkySettings, ToneMap,
};

use crate::harness::{View, march, on_both};

fn scene(change: impl FnOnce(&mut Scene)) -> Result<(), Error> {
    let mut scene = View::default().scene();
    change(&mut scene);
    scene.validate().map(|_| ())
}

fn air(change: impl FnOnce(&mut AtmosphereParams)) -> Result<(), Error> {
    let mut params = AtmosphereParams::earth();
    change(&mut params);
    params.validate()
}

fn sky(change: impl FnOnce(&mut SkySettings)) -> Result<(), Error> {
    let mut settings = SkySettings::default();
    change(&mut settings);
    welkin::SkyRenderer::new(settings).map(|_| ())
}

fn above(fov_y: f64, pitch: f64) -> Result<(), Error> {
    let pose = Pose { altitude: 2.0, pitch, heading: 0.0, fov_y };
    Camera::above(DVec3::ZERO, 6.36e6, DVec3::Z, DVec3::X, pose, 1.5).map(|_| ())
}

fn depth(convention: DepthConvention) -> Result<(), Error> {
    convention.validate()
}

/// The input, what it does, and words that its message must hold.
type Case = (&'static str, Result<(), Error>, [&'static str; 2]);

#[test]
fn wrong_scenes_are_refused_by_name_value_and_range() {
    let cases: Vec<Case> = vec![
        ("negative radius", air(|p| p.planet_radius = -6.0), ["atmosphere.planet_radius", "= -6 "]),
        ("radius not a number", air(|p| p.planet_radius = f64::NAN), ["atmosphere.planet_radius", "NaN"]),
        (
            "top below surface",
            air(|p| p.atmosphere_radius = 6e6),
            ["atmosphere.atmosphere_radius", "6000000"],
        ),
        (
            "top at the surface",
            air(|p| p.atmosphere_radius = p.planet_radius),
            ["atmosphere.atmosphere_radius", "6360000"],
        ),
        ("shell too thick", air(|p| p.atmosphere_radius *= 9.0), ["atmosphere.atmosphere_radius", "× 5"]),
        (
            "ground above its datum",
            air(|p| p.lowest_ground = 1.0),
            ["atmosphere.lowest_ground = 1 ", "× -0.1 to 0"],
        ),
        ("ground too deep", air(|p| p.lowest_ground = -7e5), ["atmosphere.lowest_ground", "-700000"]),
        (
            "ground that is no number",
            air(|p| p.lowest_ground = f64::NAN),
            ["atmosphere.lowest_ground", "NaN"],
        ),
        (
            "negative scattering",
            air(|p| p.rayleigh_scattering[2] = -1e-6),
            ["rayleigh_scattering[2]", "-1e-6"],
        ),
        ("endless extinction", air(|p| p.mie_absorption[0] = f64::INFINITY), ["mie_absorption[0]", "inf"]),
        ("scale height 0", air(|p| p.rayleigh_scale_height = 0.0), ["rayleigh_scale_height", "= 0 "]),
        ("asymmetry 1", air(|p| p.mie_asymmetry[1] = 1.0), ["mie_asymmetry[1]", "0.999"]),
        ("ozone without width", air(|p| p.ozone_half_width = 0.0), ["ozone_half_width", "from 1 "]),
        ("albedo above 1", air(|p| p.ground_albedo[0] = 1.5), ["ground_albedo[0]", "1.5"]),
        ("negative sun", air(|p| p.sun_intensity = -22.0), ["sun_intensity", "= -22 "]),
        ("sun as wide as the sky", air(|p| p.sun_angular_radius = 2.0), ["sun_angular_radius", "rad"]),
        ("sun direction not a number", scene(|s| s.sun_direction.x = f64::NAN), ["sun_direction", "NaN"]),
        ("sun direction zero", scene(|s| s.sun_direction = DVec3::ZERO), ["sun_direction", "not zero"]),
        ("camera nowhere", scene(|s| s.camera.position.y = f64::NAN), ["camera.position.y", "NaN"]),
        (
            "camera at the planet's centre",
            scene(|s| s.camera.position = DVec3::ZERO),
            ["camera.position", "half the planet"],
        ),
        ("planet beyond f64", scene(|s| s.planet_center.z = 1e300), ["planet_center.z", "1e15"]),
        ("looking nowhere", scene(|s| s.camera.forward = DVec3::ZERO), ["camera.forward", "not zero"]),
        ("up along forward", scene(|s| s.camera.up = s.camera.forward * 3.0), ["camera.up", "parallel"]),
        (
            "no field of view",
            scene(|s| s.camera.tangents.top = s.camera.tangents.bottom),
            ["camera.tangents", "bottom < top"],
        ),
        (
            "field of view of 180°",
            scene(|s| s.camera.tangents.top = f64::INFINITY),
            ["camera.tangents.top", "inf"],
        ),
        ("field of view in degrees", above(60.0, 0.0), ["pose.fov_y = 60 ", "radians"]),
        ("pitch in degrees", above(1.0, 8.0), ["pose.pitch = 8 ", "radians"]),
        ("near plane 0", depth(DepthConvention::ReversedInfinite { near: 0.0 }), ["depth.near", "= 0 "]),
        ("far before near", depth(DepthConvention::ZeroToOne { near: 1.0, far: 0.5 }), ["depth.far", "0.5"]),
        ("no samples", sky(|s| s.quality = march(0, 8)), ["view_samples", "from 1 to 1024"]),
        ("too many samples", sky(|s| s.quality = march(16, 100_000)), ["light_samples", "100000"]),
        ("scale 0", sky(|s| s.render_scale = 0.0), ["render_scale", "0.125"]),
        ("unknown planet", AtmosphereParams::preset("vulcan").map(|_| ()), ["planet", "vulcan"]),
        (
            "unknown quality",
            Quality::from_name("best").map(|_| ()),
            ["quality = \"best\"", "low, medium, high"],
        ),
        ("an error of 0", Quality::within_error(0.0).map(|_| ()), ["within_error = 0 ", "or more: quality "]),
        (
            "an error that is no number",
            Quality::within_error(f64::NAN).map(|_| ()),
            ["within_error = NaN", "a number"],
        ),
        (
            "no time",
            Quality::within_budget(Duration::ZERO).map(|_| ()),
            ["within_budget = 0 ms", "or more: quality "],
        ),
        ("unknown tone map", ToneMap::from_name("linear").map(|_| ()), ["tone_map", "agx"]),
    ];
    for (what, result, words) in cases {
        let message = result.expect_err(what).to_string();
        println!("{what}: {message}");
        for word in words {
            assert!(message.contains(word), "{what}: {message:?} lacks {word:?}");
        }
        assert!(message.contains("must be"), "{what}: {message:?} does not say what is allowed");
    }
}

#[test]
fn wrong_requests_of_a_backend_are_refused_and_leave_nothing_behind() {
    on_both(|backend| {
        let before = backend.live();
        let max = backend.info().max_texture_size;
        let say = |what: &str, result: Result<(), Error>, word: &str| {
            let message = result.expect_err(what).to_string();
            println!("{what}: {message}");
            assert!(message.contains(word), "{what}: {message:?} lacks {word:?}");
        };
        for (what, w, h) in [("zero width", 0, 4), ("zero height", 4, 0), ("too wide", max + 1, 4)] {
            let made = backend.create_texture(&TextureDesc::new("target", w, h, Format::Rgba8)).map(|_| ());
            say(what, made, "from 1 to");
        }
        let mut renderer = PictureRenderer::default();
        let settings = PictureSettings::default();
        let draw =
            |b: &mut dyn Backend, r: &mut PictureRenderer, scene: &Scene, s: &PictureSettings, size| {
                r.draw(b, scene, s, size).map(|_| ())
            };
        let good = View::default().scene();
        say("zero-size picture", draw(backend, &mut renderer, &good, &settings, [0, 4]), "picture.width = 0");
        let mut bad = good.clone();
        bad.sun_direction = DVec3::splat(f64::NAN);
        say("NaN sun", draw(backend, &mut renderer, &bad, &settings, [4, 4]), "sun_direction");
        let presets: Vec<_> = Quality::PRESETS.iter().map(|(_, quality)| *quality).collect();
        let measure = |b: &mut dyn Backend, q: &[Quality], size| ParetoFront::measure(b, q, size).map(|_| ());
        say("no qualities", measure(backend, &[], [4, 4]), "qualities = none");
        say("front of no size", measure(backend, &presets, [4, 0]), "front.height = 0");
        say("front too large", measure(backend, &presets, [max + 1, 4]), "front.width");
        let mut unknown = march(9, 9);
        say(
            "quality without a known error",
            measure(backend, &[Quality::SINGLE_LOW, unknown], [4, 4]),
            "single 9 × 9",
        );
        unknown = march(0, 9);
        say("quality that is none", measure(backend, &[unknown], [4, 4]), "view_samples = 0");
        let dark = PictureSettings { exposure: f64::NAN, ..settings };
        say("NaN exposure", draw(backend, &mut renderer, &good, &dark, [4, 4]), "exposure");
        assert_eq!(backend.live(), before, "a refused request left something behind");

        let a = backend.create_texture(&TextureDesc::new("a", 4, 4, Format::Rgba16Float)).unwrap();
        let copy = backend.create_program(Program::new(&copy::INFO, 0)).unwrap();
        let inputs = Inputs::new([("source", Some(a))]);
        let pass = Pass { program: Some(copy), inputs, ..Pass::clear("copy onto itself", Target::color(a)) };
        say("feedback loop", backend.run(std::slice::from_ref(&pass)), "different textures");
        let b = backend.create_texture(&TextureDesc::new("b", 4, 4, Format::Rgba16Float)).unwrap();
        let lacking = Pass { inputs: Inputs::NONE, target: Target::color(b), ..pass.clone() };
        say("missing texture", backend.run(&[lacking]), "no texture given for \"source\"");
        let foreign = Pass { inputs: Inputs::new([("source", Some(a))]), target: Target::color(b), ..pass };
        say("too few texels", backend.write_texture(a, &[0.0; 3]), "64 values");
        backend.destroy_texture(a);
        say("destroyed texture", backend.run(&[foreign]), "it was destroyed");
        say("read of a destroyed texture", backend.read(a).map(|_| ()), "it was destroyed");
        backend.destroy_texture(b);
        backend.destroy_program(copy);
        assert_eq!(backend.live().textures, before.textures);
    });
}
