//! Choosing a quality: what was promised is rendered and compared with the f64 reference.

use std::collections::HashMap;
use std::time::Duration;

use welkin::gpu::Backend;
use welkin::probe::scenes::{self, Frame, SETUPS, Setup};
use welkin::reference::multiple::{Orders, Settings};
use welkin::reference::single::{Sun, Tolerance, single_scattering};
use welkin::settings::front::{MEDIA, ParetoFront};
use welkin::{PictureRenderer, Quality, Scene};

use crate::harness::{draw, everything, on_both, orders, over_black, rays, rgb, sky};

/// The reference's radiance at a frame's pixels: of all orders of scattering, and scattered once.
struct Truth {
    scene: Scene,
    values: [Vec<[f64; 3]>; 2],
}

fn truth(setup: &Setup, frame: &Frame, orders: &Orders) -> Truth {
    let scene = setup.compared(frame).unwrap();
    let rays = rays(&scene, frame.counts());
    let values = rays.iter().map(|query| {
        let all = orders.radiance(query, Tolerance { relative: 1e-4 }).unwrap();
        let once =
            single_scattering(&scene.atmosphere, query, Sun::Point, Tolerance { relative: 1e-4 }).unwrap();
        (std::array::from_fn(|c| all.per_irradiance[c] - all.ground[c]), once.per_irradiance)
    });
    let (all, once) = values.unzip();
    Truth { scene, values: [all, once] }
}

/// Mean relative error in the worst channel over some scenes, as the table defines it; against both truths.
fn mean_error(backend: &mut dyn Backend, quality: Quality, frame: &Frame, truths: &[Truth]) -> [f64; 2] {
    let mut renderer = PictureRenderer::default();
    let settings = over_black(sky(quality));
    let mut sums = [[0.0; 3]; 2];
    for t in truths {
        let pixels = draw(backend, &mut renderer, &t.scene, &settings, frame.counts());
        for (values, sum) in t.values.iter().zip(&mut sums) {
            for c in 0..3 {
                let floor = 1e-3 * values.iter().map(|v| v[c]).fold(0.0, f64::max);
                for (i, want) in values.iter().enumerate() {
                    let got = rgb(&pixels, i)[c];
                    sum[c] += (got - want[c]).abs() / want[c].max(floor).max(1e-30);
                }
            }
        }
    }
    renderer.destroy(backend);
    let count = f64::from(truths.len() as u32 * frame.counts().iter().product::<u32>());
    sums.map(|sum| sum.iter().fold(0.0, |worst: f64, s| worst.max(s / count)))
}

#[test]
fn what_is_chosen_by_error_is_that_exact() {
    let front = ParetoFront::committed();
    let quick = front.measured[0].errors_from.contains("quick scenes");
    // The table's own pixels and its own truth: a coarser one would be as far off as the tables of the sky
    // are.
    let slack = 1.01;
    let (frame, truth_settings) =
        if quick { (Frame::QUICK, Settings::QUICK) } else { (Frame::WHOLE, Settings::FINE) };
    let setups: Vec<_> =
        SETUPS.iter().filter(|s| MEDIA[s.medium] == "earth" && (s.quick || !quick)).collect();
    let orders = orders(&scenes::medium(0).unwrap(), truth_settings);
    let truths: Vec<_> = setups.iter().map(|s| truth(s, &frame, &orders)).collect();
    on_both(|backend| {
        let on = backend.info().backend;
        let mut known = HashMap::new();
        let mut mean_error = |quality: Quality| {
            let draw = || mean_error(backend, quality, &frame, &truths);
            *known.entry(format!("{quality:?}")).or_insert_with(draw)
        };
        for (name, q) in Quality::PRESETS {
            // The largest LUTs take as long as all others together: on one backend.
            if *q == Quality::HIGH && on != "webgpu" && !everything() {
                continue;
            }
            let cost = front.on(on).unwrap().cost(q).unwrap();
            // Asking for what a quality has gives it or something cheaper, and that is as exact as asked.
            let asked = front.cost(q).unwrap().error;
            let chosen = Quality::within_error(asked).unwrap();
            let [all, _] = mean_error(chosen);
            println!("{name}: {asked:.4} asked: {chosen}, {all:.4} drawn");
            assert!(all <= asked * slack, "{name}: {chosen} is off by {all}, {asked} was asked");
            // The table's own figures, on either side.
            let [all, once] = mean_error(*q);
            println!(
                "{name}: {q}: all orders {:.4} in the table, {all:.4} drawn; single {:?}, {once:.4}",
                cost.error, cost.sampling
            );
            assert!((cost.error / all).max(all / cost.error) <= slack, "{name}: {q}: {} {all}", cost.error);
            if let Some(sampling) = cost.sampling {
                assert!((sampling / once).max(once / sampling) <= slack, "{name}: {q}: {sampling} {once}");
            }
        }
        let chosen = Quality::within_error(0.5).unwrap();
        assert!(mean_error(chosen)[0] <= 0.5, "{on}: {chosen}");
    });
}

#[test]
fn a_front_is_measured_on_any_backend_and_answers_for_it() {
    on_both(|backend| {
        let before = backend.live().textures;
        let some = [Quality::SINGLE_LOW, Quality::SINGLE_ULTRA];
        let front = ParetoFront::measure(backend, &some, [160, 90]).unwrap();
        assert_eq!(backend.live().textures, before, "something was left behind");
        let [m] = &front.measured[..] else { panic!("{front}") };
        assert_eq!((m.backend.as_str(), m.size), (backend.info().backend, [160, 90]));
        assert_eq!(m.points.iter().map(|p| p.quality).collect::<Vec<_>>(), some);
        let [low, ultra] = some.map(|q| front.cost(&q).unwrap());
        println!("{front}");
        // How long it takes is the machine's business.
        assert!(m.copy > Duration::ZERO && [&low, &ultra].iter().all(|c| c.time > Duration::ZERO), "{front}");
        let copies = low.time.as_secs_f64() / m.copy.as_secs_f64();
        assert!((low.copies / copies - 1.0).abs() < 1e-3, "{} {copies}", low.copies);
        assert!(front.cost(&Quality::SINGLE_HIGH).is_none());
        let committed = ParetoFront::committed().on(&m.backend).unwrap();
        assert_eq!(
            low.error,
            committed.cost(&Quality::SINGLE_LOW).unwrap().error,
            "errors are the device's own business"
        );
        assert_eq!(front.within_error(low.error.max(ultra.error)), Ok(Quality::SINGLE_LOW));
        let quickest = low.time.min(ultra.time);
        let in_time = if ultra.time <= quickest { Quality::SINGLE_ULTRA } else { Quality::SINGLE_LOW };
        assert_eq!(front.within_budget(quickest), Ok(in_time));
        assert_eq!(front.within_budget(Duration::MAX), Ok(Quality::SINGLE_ULTRA));
        let message = front.within_budget(Duration::from_nanos(1)).unwrap_err().to_string();
        assert!(message.contains("160×90") && message.contains(&m.adapter), "{message}");
        // Kept as text and read again: times to a tenth of a microsecond.
        let again: ParetoFront = front.to_string().parse().unwrap();
        assert_eq!(again.to_string(), front.to_string());
    });
}
