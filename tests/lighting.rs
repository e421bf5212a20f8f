//! Light for a scene of one's own: the seven behaviours of the constants, and the physical light against
//! other programs' numbers, on both backends.

use glam::{DVec3, Vec3};
use welkin::gpu::{Backend, Format, Target};
use welkin::model::lighting::{lighting_context_at_altitude, modulate_ambient_by_sun};
use welkin::model::sunlight::sunlight;
use welkin::reference::multiple::Settings;
use welkin::reference::single::{RayQuery, Tolerance};
use welkin::render::sky_light::SkyHarmonics;
use welkin::shaders::{LIGHTING_WGSL, translate};
use welkin::{
    AtmosphereConfig, AtmosphereParams, Error, ErrorKind, LightingContext, LightingContextUniform,
    LutSettings, PictureRenderer, PictureSettings, Quality, SkyLight, SkyRenderer, SkySettings, TerrainStyle,
};

use crate::harness::tables::{Differences, Table, medium};
use crate::harness::{View, background_passes, draw, on_both, orders, rgb, target};

/// Whether a result is the error for a field out of range.
fn names<T>(result: &Result<T, Error>, field: &str) -> bool {
    matches!(result.as_ref().map_err(Error::kind), Err(ErrorKind::Invalid { field: f, .. }) if f == field)
}

// --- by constants

#[test]
fn ambient_light_is_zero_in_space() {
    let space = LightingContext::space();
    assert_eq!(space.ambient_color * space.ambient_intensity, Vec3::ZERO);
    assert_eq!(
        (space.ambient_color, space.ambient_intensity, space.atmosphere_density),
        (Vec3::ZERO, 0.0, 0.0)
    );
}

#[test]
fn ambient_light_is_positive_on_surface() {
    let surface = LightingContext::earth_like_surface();
    assert!((surface.ambient_color * surface.ambient_intensity).cmpgt(Vec3::ZERO).all());
    // The seed's constants.
    assert_eq!(surface.ambient_color, Vec3::new(0.4, 0.5, 0.7));
    assert_eq!((surface.ambient_intensity, surface.shadow_min_light), (0.15, 0.08));
    // Day and night: the same by day, a twentieth in the dark, between them by the sun.
    let base = Vec3::new(0.4, 0.5, 0.7);
    let [day, low, night] = [1.0, 0.0, -1.0].map(|sine| modulate_ambient_by_sun(base, sine));
    assert_eq!((day, low), (base, base * 0.5));
    assert!((night - base * 0.05).abs().max_element() < 1e-7);
}

#[test]
fn shadow_darkness_matches_context() {
    assert_eq!(LightingContext::space().shadow_min_light, 0.0);
    assert!((0.01..0.99).contains(&LightingContext::earth_like_surface().shadow_min_light));
}

#[test]
fn transition_altitude_is_configurable() {
    let surface = LightingContext::earth_like_surface();
    let at = |start, end| {
        let config = AtmosphereConfig { atmosphere_start: start, atmosphere_end: end };
        config.validate().unwrap();
        lighting_context_at_altitude(15_000.0, &config, &surface).ambient_intensity
    };
    assert!(at(5e3, 5e4) < surface.ambient_intensity && at(5e3, 5e4) > 0.0);
    assert_eq!(at(2e4, 2e5), surface.ambient_intensity);
    assert_eq!(at(1e3, 1e4), 0.0);
    for (start, end, field) in
        [(f64::NAN, 1e5, "atmosphere_start"), (-1.0, 1e5, "atmosphere_start"), (1e4, 1e4, "atmosphere_end")]
    {
        let refused = AtmosphereConfig { atmosphere_start: start, atmosphere_end: end }.validate();
        assert!(names(&refused, field), "{refused:?}");
    }
}

fn assert_valid(c: &LightingContext) {
    assert!(c.ambient_color.is_finite() && c.ambient_color.cmpge(Vec3::ZERO).all(), "{c:?}");
    assert!(c.ambient_intensity.is_finite() && c.ambient_intensity >= 0.0, "{c:?}");
    assert!(
        (0.0..=1.0).contains(&c.shadow_min_light) && (0.0..=1.0).contains(&c.atmosphere_density),
        "{c:?}"
    );
}

#[test]
fn both_models_produce_valid_output() {
    let surface = LightingContext::earth_like_surface();
    assert_valid(&LightingContext::space());
    assert_valid(&surface);
    let odd = AtmosphereConfig { atmosphere_start: 1e4, atmosphere_end: 1e4 };
    for altitude in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -5.0, 1e4, 5e4] {
        for config in [AtmosphereConfig::default(), odd] {
            assert_valid(&lighting_context_at_altitude(altitude, &config, &surface));
        }
    }
}

#[test]
fn transition_is_smooth() {
    let (config, surface) = (AtmosphereConfig::default(), LightingContext::earth_like_surface());
    let at = |altitude| lighting_context_at_altitude(altitude, &config, &surface);
    let steps: Vec<_> = (0..=1000).map(|i| at(1e4 + 90.0 * f64::from(i))).collect();
    for pair in steps.windows(2) {
        let fall = pair[0].ambient_intensity - pair[1].ambient_intensity;
        // A smooth step is steepest in its middle: 1.5 of the whole per length.
        assert!((-1e-7..=1.6e-3 * surface.ambient_intensity).contains(&fall), "{pair:?}");
    }
    assert_eq!(steps[0], surface);
    assert_eq!(steps[1000], LightingContext::space());
    let middle = &steps[500];
    assert!((middle.shadow_min_light - 0.04).abs() < 1e-6 && (middle.atmosphere_density - 0.5).abs() < 1e-6);
}

#[test]
fn gpu_uniform_struct_size() {
    assert_eq!(size_of::<LightingContextUniform>(), 32);
    let text = LIGHTING_WGSL;
    let (members, size) = translate::module_layout(text, "LightingContext").unwrap().unwrap();
    let ours: Vec<_> =
        LightingContextUniform::offsets().into_iter().map(|(n, o)| (n.to_owned(), o)).collect();
    assert_eq!((members, size), (ours, 32));
    let uniform = LightingContextUniform::from(&LightingContext::earth_like_surface());
    assert!(
        (Vec3::from_slice(&uniform.ambient_shadow) - Vec3::new(0.06, 0.075, 0.105)).abs().max_element()
            < 1e-7
    );
    assert_eq!((uniform.ambient_shadow[3], uniform.atmosphere_padding), (0.08, [1.0, 0.0, 0.0, 0.0]));
}

// --- by physics

/// The light of a medium's sky, from the tables of a frame.
fn sky_light(b: &mut dyn Backend, params: &AtmosphereParams, lut: LutSettings) -> SkyLight {
    let scene = View { params: params.clone(), pitch: 30.0, ..View::default() }.scene();
    let settings = SkySettings { quality: Quality::Luts(lut), ..SkySettings::default() };
    let mut sky = SkyRenderer::new(settings).unwrap();
    assert!(sky.begin_sky_light(b).unwrap().is_none(), "light before there are tables");
    let target = target(b, [4, 4]);
    let passes = background_passes(b, &mut sky, &scene, Target::color(target));
    b.run(&passes).unwrap();
    let read = sky.begin_sky_light(b).unwrap().unwrap();
    let light = read.wait(b).unwrap();
    sky.destroy(b);
    b.destroy_texture(target);
    light
}

/// Direct and diffuse irradiance of the ground against `mc_ground_irradiance.csv`.
#[test]
fn ground_irradiance_is_the_monte_carlos() {
    let table = Table::read("mc_ground_irradiance.csv");
    on_both(|b| {
        let (mut direct, mut diffuse) = (Differences::default(), Differences::default());
        for name in ["rayleigh", "earth"] {
            for albedo in ["0", "0.3"] {
                let params = AtmosphereParams {
                    ground_albedo: [albedo.parse().unwrap(); 3],
                    sun_intensity: 1.0,
                    ..medium(name)
                };
                let light = sky_light(b, &params, LutSettings::MEDIUM);
                for row in &table.rows {
                    if table.text(row, "atmosphere") != name || table.text(row, "albedo") != albedo {
                        continue;
                    }
                    let (sine, c) = (table.angle(row, "sun_zenith_deg").cos().max(0.0), table.channel(row));
                    let beam = sunlight(&params, 0.0, sine).unwrap()[c] * sine;
                    let want = table.number(row, "direct_horizontal_irradiance_rel");
                    direct.add((beam - want).abs() / want.max(1e-3), row);
                    let (sky, want) = (
                        light.ground_irradiance(sine).unwrap()[c],
                        table.number(row, "mc_diffuse_irradiance_rel"),
                    );
                    diffuse.add((sky / want - 1.0).abs(), row);
                }
            }
        }
        direct.report(&format!("{} sunlight on the ground", b.info().backend));
        diffuse.report(&format!("{} sky light on the ground", b.info().backend));
        assert_eq!(direct.count, table.rows.len());
        assert!(direct.max < 1e-3, "{}", direct.worst);
        assert!(diffuse.max < 0.02, "{}: {}", diffuse.max, diffuse.worst);
    });
}

/// Harmonics of all light, against those of the f64 reference's radiance.
#[test]
fn harmonics_are_the_references() {
    let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::rayleigh() };
    let orders = orders(&params, Settings::QUICK.for_medium(&params));
    // Gauss's rule would straddle the horizon: midpoints on either side of it.
    let truth = |altitude: f64, sun: f64| {
        let mut sum = [[0.0; 3]; 9];
        let horizon = -(altitude * (2.0 * 6.36e6 + altitude)).sqrt() / (6.36e6 + altitude);
        let (zeniths, azimuths) = (24, 12);
        for (from, to) in [(-1.0, horizon), (horizon, 1.0)] {
            for z in 0..zeniths {
                // Crowded towards the horizon.
                let u = (f64::from(z) + 0.5) / f64::from(zeniths);
                let (near, far) = if to == horizon { (to, from) } else { (from, to) };
                let mu = near + (far - near) * u * u;
                let weight = (far - near).abs() * 2.0 * u / f64::from(zeniths) * std::f64::consts::PI
                    / f64::from(azimuths);
                for a in 0..azimuths {
                    let azimuth = (f64::from(a) + 0.5) / f64::from(azimuths) * std::f64::consts::PI;
                    let q = RayQuery::new(altitude, mu.acos(), sun.to_radians(), azimuth);
                    let l = orders.radiance(&q, Tolerance::PICTURE).unwrap().per_irradiance;
                    // Both halves of the turn.
                    for side in [azimuth, -azimuth] {
                        let s = (1.0 - mu * mu).sqrt();
                        let y = SkyHarmonics::basis(DVec3::new(s * side.cos(), s * side.sin(), mu));
                        for (i, y) in y.into_iter().enumerate() {
                            for c in 0..3 {
                                sum[i][c] += l[c] * y * weight;
                            }
                        }
                    }
                }
            }
        }
        sum
    };
    let cases = [(0.0, 30.0), (0.0, 80.0), (5e3, 60.0), (0.0, 93.0)];
    let wanted = cases.map(|(altitude, sun)| truth(altitude, sun));
    on_both(|b| {
        let light = sky_light(b, &params, LutSettings::MEDIUM);
        for ((altitude, sun), want) in cases.iter().zip(&wanted) {
            let got = light.harmonics(*altitude, sun.to_radians().cos());
            let mut worst: f64 = 0.0;
            for c in 0..3 {
                for i in 0..9 {
                    worst = worst.max((got.0[i][c] - want[i][c]).abs() / want[0][c]);
                }
            }
            println!("{} {altitude} m, sun {sun}°: {worst:.4} of the mean", b.info().backend);
            assert!(worst < 0.02, "{altitude} {sun}: {got:?} {want:?}");
        }
    });
}

/// Light of the Earth's sky on level ground at ten elevations of the sun, against the f64 reference of all
/// orders.
#[test]
fn ambient_light_is_the_references_at_ten_elevations() {
    use std::f64::consts::PI;
    let params = AtmosphereParams { sun_intensity: 1.0, ..AtmosphereParams::earth() };
    let orders = orders(&params, Settings::QUICK.for_medium(&params));
    // Midpoints, denser around the sun's azimuth.
    let (zeniths, azimuths) = (48, 24);
    let truth = |elevation: f64| {
        let mut sum = [0.0; 3];
        for z in 0..zeniths {
            let zenith = (f64::from(z) + 0.5) / f64::from(zeniths) * 0.5 * PI;
            let ring = zenith.sin() * zenith.cos() * 0.5 * PI / f64::from(zeniths);
            for a in 0..azimuths {
                let v = (f64::from(a) + 0.5) / f64::from(azimuths);
                let azimuth = PI * v * v;
                // Both halves of the turn.
                let weight = 2.0 * ring * 2.0 * PI * v / f64::from(azimuths);
                let q = RayQuery::new(0.0, zenith, (90.0 - elevation).to_radians(), azimuth);
                let l = orders.radiance(&q, Tolerance::PICTURE).unwrap().per_irradiance;
                (0..3).for_each(|c| sum[c] += l[c] * weight);
            }
        }
        sum
    };
    let elevations = [90.0, 60.0, 40.0, 25.0, 15.0, 8.0, 4.0, 1.0, -2.0, -5.0];
    let wanted = elevations.map(truth);
    on_both(|b| {
        let light = sky_light(b, &params, LutSettings::MEDIUM);
        println!(
            "{}: sun, sky's irradiance of level ground per sunlight above the air, reference, off",
            b.info().backend
        );
        for (elevation, want) in elevations.into_iter().zip(wanted) {
            let got = light.ground_irradiance(elevation.to_radians().sin()).unwrap();
            let off: [f64; 3] = std::array::from_fn(|c| got[c] / want[c] - 1.0);
            let short = |v: [f64; 3]| v.map(|v| format!("{v:.3e}")).join(" ");
            let off_percent = off.map(|v| format!("{:+.1}", 100.0 * v)).join(" ");
            println!("{elevation:4}°   {}   {}   {off_percent} %", short(got), short(want));
            let allowed = if elevation < 0.0 { 0.05 } else { 0.02 };
            assert!(off.iter().all(|v| v.abs() < allowed), "{elevation}°: {off:?}");
        }
    });
}

#[test]
fn physical_contexts_follow_altitude_and_sun() {
    on_both(|b| {
        let earth = AtmosphereParams::earth();
        let light = sky_light(b, &earth, LutSettings::LOW);
        let at = |altitude, elevation: f64| {
            let c = light.context(altitude, elevation.to_radians().sin()).unwrap();
            assert_valid(&c);
            c
        };
        let [noon, dusk, night, space] = [at(0.0, 60.0), at(0.0, -2.0), at(0.0, -30.0), at(1e6, 60.0)];
        assert!(noon.ambient_color.z > 1.5 * noon.ambient_color.x, "a blue sky: {noon:?}");
        assert!((0.05..0.4).contains(&noon.shadow_min_light), "{noon:?}");
        // After sunset all light is the sky's.
        assert!(
            dusk.shadow_min_light > 0.999 && dusk.ambient_color.z < 0.05 * noon.ambient_color.z,
            "{dusk:?}"
        );
        assert!(night.ambient_color.max_element() < 1e-6 * noon.ambient_color.max_element(), "{night:?}");
        assert!(space.atmosphere_density == 0.0 && noon.atmosphere_density == 1.0);
        // The sun through more air is redder, and gone behind the planet.
        let ratio = |elevation: f64| {
            let s = sunlight(&earth, 0.0, elevation.to_radians().sin()).unwrap();
            s[0] / s[2]
        };
        assert!(ratio(2.0) > ratio(20.0) && ratio(20.0) > ratio(90.0));
        assert_eq!(sunlight(&earth, 0.0, -0.01).unwrap(), [0.0; 3]);
        assert!(sunlight(&earth, 4e5, -0.1).unwrap()[0] > 0.0, "the sun is up in orbit");
        for (field, result) in [
            ("sun_sine", sunlight(&earth, 0.0, f64::NAN)),
            ("altitude", sunlight(&earth, f64::INFINITY, 0.0)),
            ("sun_sine", light.ground_irradiance(1.5)),
        ] {
            assert!(names(&result, field), "{result:?}");
        }
    });
}

/// What the demonstration's ground looks like from just above: its albedo times all light that falls on it,
/// over pi.
#[test]
fn the_ground_has_the_light_of_its_sky() {
    let table = Table::read("mc_ground_irradiance.csv");
    // White and flat, without a sea.
    let style = TerrainStyle {
        amplitude: 0.01,
        sea: false,
        low_albedo: [1.0; 3],
        high_albedo: [1.0; 3],
        snow_line: f64::INFINITY,
        ..TerrainStyle::earth()
    };
    on_both(|b| {
        let mut all = Differences::default();
        for (name, albedo) in [("rayleigh", "0"), ("earth", "0.3")] {
            let params = AtmosphereParams {
                ground_albedo: [albedo.parse().unwrap(); 3],
                sun_intensity: 1.0,
                ..medium(name)
            };
            let mut renderer = PictureRenderer::default();
            for row in &table.rows {
                let sun = table.number(row, "sun_zenith_deg");
                if table.text(row, "atmosphere") != name || table.text(row, "albedo") != albedo || sun > 89.0
                {
                    continue;
                }
                let view = View {
                    params: params.clone(),
                    altitude: 2.0,
                    pitch: -90.0,
                    sun_elevation: 90.0 - sun,
                    ..View::default()
                };
                let settings = PictureSettings {
                    terrain: Some(style),
                    radiance: Format::Rgba32Float,
                    ..PictureSettings::default()
                };
                let pixels = draw(b, &mut renderer, &view.scene(), &settings, [8, 8]);
                let c = table.channel(row);
                let got = rgb(&pixels, 27)[c];
                let want = table.number(row, "direct_horizontal_irradiance_rel")
                    + table.number(row, "mc_diffuse_irradiance_rel");
                all.add((got * std::f64::consts::PI / want - 1.0).abs(), row);
            }
            renderer.destroy(b);
        }
        all.report(&format!("{} light on the drawn ground", b.info().backend));
        assert_eq!(all.count, 18);
        assert!(all.max < 0.03, "{}: {}", all.max, all.worst);
    });
}
