//! No energy comes or goes: white ground under air that absorbs nothing, black ground, and an absorber.

use welkin::frame::luts::LutsUniform;
use welkin::gpu::{Backend, Target};
use welkin::reference::single::{RayQuery, Tolerance, transmittance};
use welkin::{AtmosphereParams, LutSettings, PictureRenderer, Quality, SkyRenderer, SkySettings};

use crate::harness::{View, background_passes, draw, luts, on_both, over_black, target};

/// Gas of a vertical optical depth that absorbs nothing, over ground that reflects a share of what it gets.
fn gas(depth: f64, albedo: f64) -> AtmosphereParams {
    AtmosphereParams {
        rayleigh_scattering: [0.5, 1.0, 2.0].map(|c| c * depth / 8000.0),
        ground_albedo: [albedo; 3],
        ..AtmosphereParams::rayleigh()
    }
}

/// Net flux upwards of all light but the sun's own, through spheres: altitude and flux for each row of the
/// table, the mean over all angles of the sun, in shares of what meets a flat plate.
fn diffuse_flux(b: &mut dyn Backend, params: &AtmosphereParams, lut: LutSettings) -> Vec<(f64, [f64; 3])> {
    let view = View { params: params.clone(), ..View::default() };
    let target = target(b, [4, 4]);
    let settings = SkySettings { quality: Quality::Luts(lut), ..SkySettings::default() };
    let mut sky = SkyRenderer::new(settings).unwrap();
    let passes = background_passes(b, &mut sky, &view.scene(), Target::color(target));
    b.run(&passes).unwrap();
    let last = passes.iter().rfind(|p| p.label == "multi-scattering LUT").unwrap();
    let texels = b.read(last.target.color).unwrap();
    let t = LutsUniform::new(params, &lut);
    sky.destroy(b);
    b.destroy_texture(target);
    let [suns, altitudes] = lut.multi_scattering.map(|n| n as usize);
    let value = |x: usize, row: usize, c: usize| f64::from(texels[4 * (row * suns + x) + c]);
    let span = |v: f32| f64::from(v);
    let sun = |x: usize| {
        let y = span(t.sun_first) + x as f64 / (suns - 1) as f64 * span(t.sun_span);
        (span(t.sun_middle) + span(t.sun_width) * y.sinh()).clamp(-1.0, 1.0)
    };
    (0..altitudes)
        .map(|row| {
            let altitude = rows(params, lut)[row];
            let flux = std::array::from_fn(|c| {
                // The moment of cos(zenith) of where light comes from, over its harmonic's factor sqrt(3 /
                // 4π).
                let factor = (3.0 / (4.0 * std::f64::consts::PI)).sqrt();
                let diffuse = |x: usize| -value(x, 6 * row, c).exp2() * value(x, 6 * row + 1, c) / factor;
                // Trapezia: the columns crowd where light changes.
                (1..suns).map(|x| 0.5 * (diffuse(x) + diffuse(x - 1)) * (sun(x) - sun(x - 1))).sum::<f64>()
                    * 0.5
            });
            (altitude, flux)
        })
        .collect()
}

/// Altitudes of the table's rows.
fn rows(params: &AtmosphereParams, lut: LutSettings) -> Vec<f64> {
    let t = LutsUniform::new(params, &lut);
    let share = |row: u32| f64::from(row) / f64::from(lut.multi_scattering[1] - 1);
    let grown =
        |row| (share(row).powi(2) * f64::from(t.altitude_steepness)).exp_m1() / f64::from(t.altitude_growth);
    (0..lut.multi_scattering[1]).map(|row| params.thickness() * grown(row).min(1.0)).collect()
}

/// The sun's flux downwards through the sphere at an altitude, as [`diffuse_flux`] gives the other light's.
fn direct_flux(params: &AtmosphereParams, altitude: f64) -> [f64; 3] {
    const ANGLES: u32 = 400;
    let dip = -(1.0 - (params.planet_radius / (params.planet_radius + altitude)).powi(2)).sqrt();
    let mut sum = [0.0; 3];
    for i in 0..ANGLES {
        // Even in the root of the way from the edge of the shadow.
        let u = (f64::from(i) + 0.5) / f64::from(ANGLES);
        let mu = dip + (1.0 - dip) * u * u;
        let query = RayQuery::new(altitude, mu.acos(), 0.0, 0.0);
        let through = transmittance(params, &query, Tolerance { relative: 1e-6 }).unwrap();
        for c in 0..3 {
            sum[c] += 0.5 * mu * through[c] * (1.0 - dip) * 2.0 * u / f64::from(ANGLES);
        }
    }
    sum
}

/// Of the light that meets the planet's disk, a quarter per area of the sphere.
const INCOMING: f64 = 0.25;

#[test]
fn energy_neither_comes_nor_goes() {
    let lut = LutSettings { orders: 24, ..LutSettings::MEDIUM };
    let direct = [0.3].map(|depth| {
        let params = gas(depth, 0.0);
        let altitudes = rows(&params, lut);
        (depth, altitudes.into_iter().map(|h| direct_flux(&params, h)).collect::<Vec<_>>())
    });
    on_both(|b| {
        let name = b.info().backend;
        for (depth, direct) in &direct {
            // White ground and air that absorbs nothing: through no sphere anything is lost or won.
            let furnace = diffuse_flux(b, &gas(*depth, 1.0), lut);
            // Black ground: all that is lost is lost there; nothing on the way.
            let black = diffuse_flux(b, &gas(*depth, 0.0), lut);
            let radius = gas(*depth, 0.0).planet_radius;
            let lost = |flux: [f64; 3], direct: [f64; 3], altitude: f64, c: usize| {
                ((radius + altitude) / radius).powi(2) * (direct[c] - flux[c]) / INCOMING
            };
            let mut worst = [0.0_f64; 2];
            for ((altitude, open), ((_, closed), direct_here)) in furnace.iter().zip(black.iter().zip(direct))
            {
                for c in 0..3 {
                    worst[0] = worst[0].max(lost(*open, *direct_here, *altitude, c).abs());
                    let here = lost(*closed, *direct_here, *altitude, c);
                    let ground = lost(black[0].1, direct[0], 0.0, c);
                    assert!(ground > 0.1, "{name} {depth}: black ground takes only {ground}");
                    worst[1] = worst[1].max((here - ground).abs());
                }
            }
            println!(
                "{name}: depth {depth}: white ground loses {:.4}, air over black {:.4}",
                worst[0], worst[1]
            );
            assert!(worst.iter().all(|w| *w < 0.02), "{name} {depth}: {worst:?}");
        }
        // An absorber over black ground creates nothing.
        let params = AtmosphereParams {
            rayleigh_scattering: [0.0; 3],
            mie_scattering: [0.0; 3],
            mie_absorption: [1e-4; 3],
            ..gas(1.0, 0.0)
        };
        let view = View { params, pitch: 20.0, ..View::default() };
        let settings = over_black(luts(LutSettings::LOW));
        let mut renderer = PictureRenderer::default();
        for altitude in [2.0, 3e4, 4e5] {
            let scene = View { altitude, ..view.clone() }.scene();
            let pixels = draw(b, &mut renderer, &scene, &settings, [16, 16]);
            // 2^-100, the tables' floor, of a few thousand texels' worth.
            let most = pixels.chunks_exact(4).flat_map(|p| &p[..3]).fold(0.0_f32, |m, v| m.max(*v));
            assert!(most < 1e-24, "{name}: {most} of light from nothing");
        }
        renderer.destroy(b);
    });
}
