//! What one frame costs: how often it allocates, checks, plans and uploads.

use welkin::count::{self, Counts};
use welkin::gpu::Target;
use welkin::{FrameTargets, PictureRenderer, PictureSettings, SkyRenderer, SkySettings};

use crate::harness::{TINY, View, allocations, luts, on_both, target};

const SIZE: [u32; 2] = [8, 6];

/// Frames of a flight: the camera turns in all, climbs in some.
fn flight(i: u32) -> View {
    let altitude = [100.0, 100.0, 100.0, 120.0, 30_000.0, 31_000.0, 400e3, 410e3][i as usize % 8];
    View { altitude, pitch: -10.0, heading: f64::from(i), ..View::default() }
}

/// A frame is checked, planned and listed once, and each of its passes sends its block once.
#[test]
fn a_frame_is_checked_planned_and_sent_once() {
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let settings = PictureSettings { sky: luts(TINY), ..PictureSettings::default() };
        for i in 0..10 {
            let scene = flight(i).scene();
            let (blocks, counts) = count::during(|| {
                let (passes, _) = renderer.passes(b, &scene, &settings, SIZE).unwrap();
                b.run(passes).unwrap();
                passes.iter().filter(|p| !p.uniform.bytes().is_empty()).count() as u32
            });
            println!("picture {i}: {counts:?}");
            let once = Counts {
                scene_checks: 1,
                settings_checks: 1,
                frames: 1,
                node_lists: 1,
                uniform_uploads: blocks,
            };
            assert_eq!(counts, once, "picture {i}");
            assert!(blocks >= 3, "{blocks} passes are not a picture");
        }
        renderer.destroy(b);
        // The settings of a sky are checked when they are set.
        let mut sky = SkyRenderer::new(luts(TINY)).unwrap();
        let targets = FrameTargets::background(Target::color(target(b, SIZE)));
        for i in 0..3 {
            let scene = flight(i).scene();
            let (passes, counts) = count::during(|| {
                let frame = sky.frame(b, &scene, &targets).unwrap();
                b.run(frame.background).unwrap();
                frame.background.iter().filter(|p| !p.uniform.bytes().is_empty()).count() as u32
            });
            println!("sky {i}: {counts:?}");
            let once = Counts {
                settings_checks: 0,
                scene_checks: 1,
                frames: 1,
                node_lists: 1,
                uniform_uploads: passes,
            };
            assert_eq!(counts, once, "sky {i}");
        }
    });
}

/// A frame like the one before allocates nothing, whether its LUTs are made again or not; nor does a WebGL2
/// backend that runs it. (wgpu allocates for every encoder and pass.)
#[test]
fn a_steady_frame_allocates_nothing() {
    on_both(|b| {
        let webgl = b.info().backend == "webgl2";
        for sky in [SkySettings::default(), luts(TINY)] {
            let mut renderer = PictureRenderer::default();
            let settings = PictureSettings { sky, ..PictureSettings::default() };
            for i in 0..24 {
                let view = View { altitude: 100.0 + f64::from(i / 2), ..flight(i) };
                let scene = view.scene();
                let (passes, listing) =
                    allocations::during(|| renderer.passes(b, &scene, &settings, SIZE).unwrap().0);
                let ((), running) = allocations::during(|| b.run(passes).unwrap());
                println!(
                    "frame {i}: {listing} allocations for {} passes, {running} to run them",
                    passes.len()
                );
                if i >= 4 {
                    assert_eq!(listing, 0, "frame {i}");
                    assert!(running == 0 || !webgl, "frame {i}: {running}");
                }
            }
            renderer.destroy(b);
        }
    });
}

#[test]
fn allocations_are_counted_for_this_thread_alone() {
    let (kept, n) = allocations::during(|| vec![Box::new(1), Box::new(2)]);
    assert_eq!((kept.len(), n), (2, 3));
    let (sum, n) = allocations::during(|| kept.iter().map(|v| **v).sum::<i32>());
    assert_eq!((sum, n), (3, 0));
    let other = std::thread::spawn(|| drop(vec![0_u8; 1 << 20]));
    let (_, n) = allocations::during(|| while !other.is_finished() {});
    assert_eq!(n, 0, "another thread's were counted");
}
