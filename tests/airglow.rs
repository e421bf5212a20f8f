//! Airglow: as bright as it is stated at the zenith, brighter towards the horizon and at the limb as geometry
//! says, behind the air and before the planet; and nothing of it where it is off.

use welkin::gpu::Backend;
use welkin::reference::single::{RayQuery, Tolerance, transmittance};
use welkin::{Airglow, AtmosphereParams, Bound, Frame, Look, Scene, SkyRenderer, SkySettings};

use crate::harness::{View, airless, cleared, frame_passes, frame_textures, free, luts, on_both, query, rgb};

const SIZE: [u32; 2] = [8, 8];

/// The Earth with so little air that it changes no digit.
fn next_to_nothing() -> AtmosphereParams {
    let earth = AtmosphereParams::earth();
    AtmosphereParams { rayleigh_scattering: [1e-18; 3], ..airless(earth) }
}

fn glowing(airglow: Airglow, bound: Option<Bound>) -> SkySettings {
    let sky = luts(welkin::LutSettings::LOW);
    SkySettings { look: Look { airglow: Some(airglow), ..sky.look }, bound, ..sky }
}

/// The emission along a ray (1/sr, per unit of the sun's irradiance) in f64: before its perigee, and behind
/// it.
fn emission(glow: &Airglow, radius: f64, query: &RayQuery, ground: bool) -> [f64; 2] {
    let r = radius + query.altitude;
    let mu = query.direction.z;
    let p = r * (1.0 - mu * mu).max(0.0).sqrt();
    let at = |s: f64| {
        let h = p.hypot(s) - radius;
        (1.0 - (h - glow.altitude).abs() / glow.half_width).max(0.0)
    };
    // Distance from the perigee, by the trapezoidal rule in even steps of altitude: fine enough for 1e-4.
    let side = |from: f64| {
        let reach = |h: f64| ((radius + h).powi(2) - p * p).max(0.0).sqrt();
        let (first, last) =
            (reach(glow.altitude - glow.half_width).max(from), reach(glow.altitude + glow.half_width));
        let steps = 20_000;
        let ds = (last - first).max(0.0) / f64::from(steps);
        (0..steps).map(|i| at(first + (f64::from(i) + 0.5) * ds) * ds).sum::<f64>() / glow.half_width
            * glow.zenith[0]
    };
    let camera = r * mu;
    let before = if camera < 0.0 { (side(0.0) - side(-camera)).max(0.0) } else { 0.0 };
    let behind = if ground { 0.0 } else { side(camera.max(0.0)) };
    [before, behind]
}

/// By a renderer that may have drawn others.
fn draw(b: &mut dyn Backend, sky: &mut SkyRenderer, scene: &Scene) -> Vec<f32> {
    let [color, depth, out] = frame_textures(b, SIZE);
    let far = scene.depth.background() as f32;
    b.write_texture(depth, &[far; 64]).unwrap();
    let (mut passes, last) = frame_passes(b, sky, scene, cleared(color), [color, depth, out]);
    if !passes.iter().any(|p| p.target.color == color) {
        passes.insert(0, welkin::gpu::Pass::clear("clear", cleared(color)));
    }
    b.run(&passes).unwrap();
    let pixels = b.read(last).unwrap();
    free(b, [color, depth, out]);
    pixels
}

/// Without air to speak of it is the integral of the emission: from the ground to the horizon, from within
/// the layer and from orbit.
#[test]
fn it_is_the_emission_along_the_ray() {
    let thin = Airglow { half_width: 300.0, ..Airglow::EARTH };
    on_both(|b| {
        let mut worst: f64 = 0.0;
        for glow in [Airglow::EARTH, thin] {
            let mut sky = SkyRenderer::new(glowing(glow, None)).unwrap();
            for (altitude, pitch, fov) in
                [(2.0, 90.0, 20.0), (2.0, 10.0, 18.0), (85e3, 5.0, 20.0), (4e5, 60.0, 10.0)]
            {
                let params = AtmosphereParams { sun_intensity: 1e6, ..next_to_nothing() };
                let view = View { params, altitude, pitch, fov, sun_elevation: -60.0, ..View::default() };
                let scene = view.scene();
                let pixels = draw(b, &mut sky, &scene);
                for i in 0..64 {
                    let query = query(&scene, SIZE, i);
                    let ground = false;
                    let [before, behind] = emission(&glow, view.params.planet_radius, &query, ground);
                    let want = (before + behind) * 1e6;
                    let got = f64::from(pixels[4 * i]);
                    let brightest = glow.zenith[0] * 1e6;
                    worst = worst.max((got - want).abs() / want.max(0.01 * brightest));
                }
            }
            sky.destroy(b);
        }
        println!("{}: off by {worst:.5} at most", b.info().backend);
        assert!(worst < 0.01, "{worst}");
    });
}

/// At the zenith of a ground observer it is what it says, dimmed by the air; towards the horizon van Rhijn's
/// factor more.
#[test]
fn the_ground_sees_it_through_the_air() {
    let params = AtmosphereParams::earth();
    on_both(|b| {
        for (pitch, cosine) in [(90.0, 1.0_f64), (30.0, 0.5)] {
            let view = View { pitch, fov: 0.01, altitude: 2.0, sun_elevation: -60.0, ..View::default() };
            let scene = view.scene();
            let dark = Airglow { zenith: [0.0; 3], ..Airglow::EARTH };
            let bound = Some(Bound::LINEAR);
            let [with, without] = [Airglow::EARTH, dark].map(|glow| {
                let mut sky = SkyRenderer::new(glowing(glow, bound)).unwrap();
                let pixels = draw(b, &mut sky, &scene);
                sky.destroy(b);
                rgb(&pixels, 27)
            });
            let query = query(&scene, SIZE, 27);
            let through = transmittance(&params, &query, Tolerance::PICTURE).unwrap();
            // Laid over by blending, the sky dims it by the grey mean.
            let grey = through.iter().sum::<f64>() / 3.0;
            let factor = Airglow::EARTH.van_rhijn(params.planet_radius, cosine);
            let want = Airglow::EARTH.zenith[1] * params.sun_intensity * factor * grey;
            let got = with[1] - without[1];
            assert!((got / want - 1.0).abs() < 0.02, "pitch {pitch}: {got:e} for {want:e}");
        }
    });
}

/// From orbit the layer is a bright line above the limb, and a veil before the planet that no air dims.
#[test]
fn orbit_sees_a_bright_limb() {
    let params = AtmosphereParams { sun_intensity: 1e6, ..next_to_nothing() };
    let (radius, altitude) = (params.planet_radius, 4e5);
    on_both(|b| {
        let mut sky = SkyRenderer::new(glowing(Airglow::EARTH, None)).unwrap();
        for (tangent, least) in [(87e3, 50.0), (30e3, 10.0), (101e3, 0.0)] {
            let pitch = -((radius + tangent) / (radius + altitude)).acos().to_degrees();
            let view = View {
                params: params.clone(),
                altitude,
                pitch,
                fov: 0.01,
                sun_elevation: -80.0,
                ..View::default()
            };
            let scene = view.scene();
            let [before, behind] = emission(&Airglow::EARTH, radius, &query(&scene, SIZE, 27), false);
            let want = (before + behind) / Airglow::EARTH.zenith[0];
            let drawn = draw(b, &mut sky, &scene);
            let got = f64::from(drawn[4 * 27]) / 1e6 / Airglow::EARTH.zenith[0];
            println!("{}: {got:.2} zeniths at a tangent of {tangent} m, {want:.2} in f64", b.info().backend);
            assert!((got - want).abs() < 0.005 * want.max(1.0) && want >= least);
        }
        let nadir = View {
            params: params.clone(),
            altitude,
            pitch: -90.0,
            fov: 0.01,
            sun_elevation: -80.0,
            ..View::default()
        };
        let veil = f64::from(draw(b, &mut sky, &nadir.scene())[4 * 27]) / 1e6;
        assert!((veil / Airglow::EARTH.zenith[0] - 1.0).abs() < 0.01, "{veil:e}");
        sky.destroy(b);
    });
}

/// Off by default; off where it does not count; and then nothing of it is compiled or drawn.
#[test]
fn nothing_of_it_is_there_where_it_is_off() {
    let names = |view: &View, sky: SkySettings| {
        let frame = Frame::new(&view.scene(), &sky, SIZE).unwrap();
        let drawn = frame.planned_passes().iter().filter(|p| p.label == "airglow").count();
        (frame.effect("airglow").unwrap().on, drawn)
    };
    let ground = View { pitch: 20.0, sun_elevation: -60.0, ..View::default() };
    assert_eq!(names(&ground, SkySettings::default()), (false, 0));
    assert_eq!(
        names(&ground, glowing(Airglow::EARTH, Some(Bound::eight_bit(1.0)))),
        (false, 0),
        "too dark to be seen"
    );
    assert_eq!(names(&ground, glowing(Airglow::EARTH, Some(Bound::eight_bit(1e5)))), (true, 1));
    let orbit = View { altitude: 4e5, pitch: -20.0, ..ground };
    assert_eq!(names(&orbit, glowing(Airglow::EARTH, Some(Bound::eight_bit(1e5)))), (true, 2));
    for (field, bad) in [
        ("airglow.altitude", Airglow { altitude: 0.0, ..Airglow::EARTH }),
        ("airglow.half_width", Airglow { half_width: 2e5, ..Airglow::EARTH }),
        ("airglow.zenith[1]", Airglow { zenith: [0.0, f64::NAN, 0.0], ..Airglow::EARTH }),
    ] {
        let error = SkyRenderer::new(glowing(bad, None)).unwrap_err().to_string();
        assert!(error.starts_with(field), "{error}");
    }
}
