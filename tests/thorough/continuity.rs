//! Light is continuous: flying up, across seams of the LUTs, and along lines across every edge of picture and
//! scene, as much as the reference is.
//!
//! `cargo test --test all continuity -- --nocapture` prints the figures.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};
use welkin::gpu::{Backend, Format, Target};
use welkin::probe::film;
use welkin::reference::single::{RayQuery, Tolerance, transmittance};
use welkin::{
    AtmosphereParams, Camera, Look, PictureRenderer, PictureSettings, Pose, Quality, Scene, SkyRenderer,
    SkySettings, TerrainStyle,
};

use crate::harness::lines::Line;
use crate::harness::{
    View, aerial_passes, assert_physical, background_passes, brightest, colors, copy_pass, draw, expected,
    expected_picture, frame_textures, free, march, on_both, over_black, rays, rgb, sample, sky, texture,
};

// --- from the ground to far away

fn fly(altitude: f64) -> Scene {
    let radius = AtmosphereParams::earth().planet_radius;
    let dip = |tangent: f64| ((radius + tangent) / (radius + altitude)).min(1.0).acos().to_degrees();
    // Up to 60 km the horizon, from there on the air from the ground to 60 km.
    let (low, high) = (dip(0.0), dip(6e4));
    let (pitch, fov) = if altitude < 6e4 { (-low, 60.0) } else { (-0.5 * (low + high), 1.5 * (low - high)) };
    View { altitude, pitch, fov, sun_elevation: 25.0, aspect: 0.5, ..View::default() }.scene()
}

#[test]
fn flying_up_is_the_references_and_without_a_step() {
    let size = [4, 8];
    let mut altitudes = film::altitudes(&AtmosphereParams::earth(), 72);
    altitudes.extend([3.5786e7, 3.844e8]);
    altitudes.sort_by(f64::total_cmp);
    let truths: Vec<_> = altitudes.iter().map(|&h| expected_picture(&fly(h), size)).collect();
    on_both(|b| {
        let name = b.info().backend;
        let mut renderer = PictureRenderer::default();
        let settings = over_black(sky(Quality::MEDIUM));
        let (mut worst, mut largest, mut step) = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0));
        let mut last: Option<Vec<[f64; 3]>> = None;
        for (k, &altitude) in altitudes.iter().enumerate() {
            let scene = fly(altitude);
            let pixels = draw(b, &mut renderer, &scene, &settings, size);
            assert_physical(&pixels, &format!("{altitude} m"));
            let got: Vec<_> = (0..32).map(|i| rgb(&pixels, i)).collect();
            let top = brightest(&truths[k]);
            // Mean deviation, of the value or of a hundredth of the brightest.
            let mut sum = [0.0; 3];
            for (got, want) in got.iter().zip(&truths[k]) {
                for c in 0..3 {
                    let off = (got[c] - want[c]).abs() / want[c].max(1e-2 * top[c]);
                    sum[c] += off / 32.0;
                    if off > largest.0 {
                        largest = (off, altitude);
                    }
                }
            }
            let mean = sum.iter().fold(0.0, |m: f64, v| m.max(*v));
            if mean > worst.0 {
                worst = (mean, altitude);
            }
            // From one frame to the next light changes as the reference's does.
            if let Some(last) = &last {
                let [_, _, off] = film::Step::between([last, &got], [&truths[k - 1], &truths[k]]).pixel;
                if off > step.0 {
                    step = (off, altitude);
                }
            }
            // The limb is resolved: bright at its foot, next to nothing at 75 km.
            if altitude > 1e5 {
                assert!(got[0][1] < 0.05 * got[24][1], "{altitude} m: {:?} {:?}", got[0], got[24]);
            }
            last = Some(got);
        }
        println!(
            "{name}: worst frame {:.4} at {} m, worst pixel {:.4} at {} m, worst step {:.4} to {} m",
            worst.0, worst.1, largest.0, largest.1, step.0, step.1
        );
        assert!(worst.0 < 0.02 && largest.0 < 0.05 && step.0 < 0.05, "{worst:?} {largest:?} {step:?}");
        // Where something begins or ends, a metre changes next to nothing. From above the top, rows of the
        // LUTs stand for other rays than from below: there the method's own error shows.
        for (altitude, bound) in [(15e3, 1e-3), (50e3, 1e-3), (100e3, 0.04)] {
            let [below, above] = [-0.5, 0.5].map(|d| {
                let view = View { altitude: altitude + d, pitch: -3.0, fov: 30.0, ..View::default() };
                draw(b, &mut renderer, &view.scene(), &settings, [12, 12])
            });
            let top = above.chunks_exact(4).fold(0.0, |m: f32, p| m.max(p[2]));
            let step = below.iter().zip(&above).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max) / top;
            println!("{name}: {altitude} m: step {step:.2e}");
            assert!(step < bound, "a step of {step} at {altitude} m");
        }
        renderer.destroy(b);
    });
}

// --- seams

#[test]
fn no_seam_is_seen() {
    let size = [8, 8];
    let mut views = Vec::new();
    for altitude in [2.0, 3e3, 3e4, 2e5] {
        let dip = (6.36e6_f64 / (6.36e6 + altitude)).acos().to_degrees();
        for heading in [0.0, 90.0, 180.0] {
            // The horizon, and the sun's azimuth and its opposite above it.
            views.push(("horizon", View { altitude, pitch: -dip, fov: 0.5, heading, ..View::default() }));
        }
    }
    for (pitch, name) in [(90.0, "zenith"), (-90.0, "nadir")] {
        for altitude in [2.0, 8e3, 4e5] {
            let heading = 30.0;
            views.push((
                name,
                View { altitude, pitch, fov: 2.0, heading, sun_elevation: 50.0, ..View::default() },
            ));
        }
    }
    for heading in [0.0, 180.0] {
        views.push((
            "azimuth",
            View { pitch: 15.0, fov: 4.0, heading, sun_elevation: 40.0, ..View::default() },
        ));
        views.push(("azimuth", View { altitude: 2e4, pitch: -30.0, fov: 4.0, heading, ..View::default() }));
    }
    let truths: Vec<_> = views.iter().map(|(_, v)| expected_picture(&v.scene(), size)).collect();
    on_both(|b| {
        let mut renderer = PictureRenderer::default();
        let settings = over_black(sky(Quality::MEDIUM));
        let mut worst: BTreeMap<&str, f64> = BTreeMap::new();
        for ((name, view), want) in views.iter().zip(&truths) {
            let pixels = draw(b, &mut renderer, &view.scene(), &settings, size);
            assert_physical(&pixels, name);
            let got: Vec<_> = (0..64).map(|i| rgb(&pixels, i)).collect();
            let pairs = (0..64).flat_map(|i| [(i, i + 1, i % 8 < 7), (i, i + 8, i < 56)]);
            for (i, j, _) in pairs.filter(|p| p.2) {
                for c in 0..3 {
                    let own = (want[i][c] - want[j][c]).abs();
                    let more = (got[i][c] - got[j][c]).abs() - own;
                    let share = more / want[i][c].max(want[j][c]).max(1e-3 * brightest(want)[c]).max(1e-30);
                    let at = worst.entry(name).or_default();
                    *at = at.max(share);
                    assert!(share < 0.1, "{name} {view:?}: pixels {i} {:?} and {j} {:?}", got[i], got[j]);
                }
            }
            // Both sides of the sun are each other's mirror image.
            if view.heading % 180.0 == 0.0 {
                for (i, here) in got.iter().enumerate() {
                    let there = got[i / 8 * 8 + 7 - i % 8];
                    for c in 0..3 {
                        assert!(
                            (here[c] - there[c]).abs() <= 1e-4 * here[c],
                            "{name} {view:?}: {i} {here:?} {there:?}"
                        );
                    }
                }
            }
        }
        println!(
            "{}: between neighbours more than the reference's difference: {worst:.4?}",
            b.info().backend
        );
        renderer.destroy(b);
        for (name, bound) in SEAMS {
            assert!(worst[name] < bound, "{name}: {} more than the reference's difference", worst[name]);
        }
    });
}

/// What neighbouring pixels may differ by, beyond the reference's difference, of their light.
const SEAMS: [(&str, f64); 4] = [("horizon", 0.03), ("zenith", 2e-3), ("nadir", 2e-3), ("azimuth", 2e-3)];

// --- lines

/// Pixels of a line.
const N: u32 = 32;

/// Lines within one picture: a column of pixels from its top to its bottom, or a row.
fn within() -> Vec<(&'static str, View, [u32; 2])> {
    let mut all = Vec::new();
    let (up, across) = ([1, N], [N, 1]);
    let column = |v: View| View { aspect: 1.0 / f64::from(N), ..v };
    let row = |v: View| View { fov: v.fov / f64::from(N), aspect: f64::from(N), ..v };
    let dip = |altitude: f64, up: f64| -((6.36e6 + up) / (6.36e6 + altitude)).acos().to_degrees();
    for altitude in [2.0, 3e3, 3e4] {
        for (heading, sun_elevation) in [(0.0, 20.0), (90.0, 2.0), (180.0, -4.0)] {
            let pitch = dip(altitude, 0.0);
            let view = View { altitude, pitch, fov: 0.4, heading, sun_elevation, ..View::default() };
            all.push((if sun_elevation < 0.0 { "horizon at dusk" } else { "horizon" }, column(view), up));
        }
    }
    for altitude in [4e5, 3.6e7, 3.844e8] {
        for heading in [0.0, 90.0, 180.0] {
            // From 60 km above the limb to 10 km of ground inside it.
            let (high, low) = (dip(altitude, 6e4), dip(altitude, 0.0));
            let view = View {
                altitude,
                pitch: 0.5 * (high + low) - 0.1 * (high - low),
                fov: 1.4 * (high - low),
                heading,
                sun_elevation: if heading == 90.0 { -10.0 } else { 25.0 },
                ..View::default()
            };
            all.push((if heading == 90.0 { "limb at night" } else { "limb" }, column(view), up));
        }
    }
    for altitude in [2.0, 2e4] {
        for heading in [0.0, 180.0] {
            let view =
                View { altitude, pitch: 25.0, fov: 6.0, heading, sun_elevation: 40.0, ..View::default() };
            all.push(("sun's azimuth", row(view), across));
        }
        for (name, pitch) in [("zenith", 90.0), ("nadir", -90.0)] {
            let view =
                View { altitude, pitch, fov: 4.0, heading: 30.0, sun_elevation: 50.0, ..View::default() };
            all.push((name, column(view.clone()), up));
            all.push((name, row(view), across));
        }
    }
    // Looking down on the day's end: 2 degrees of the planet on either side of it.
    let view = View { altitude: 4e6, pitch: -90.0, fov: 6.0, sun_elevation: 0.0, ..View::default() };
    all.push(("terminator", column(view), up));
    all
}

/// Lines through time: one pixel while the camera rises or the sun sets.
fn through() -> Vec<(&'static str, Vec<View>)> {
    let steps =
        |from: f64, to: f64| (0..N).map(move |i| from + (to - from) * f64::from(i) / f64::from(N - 1));
    let view = View { altitude: 500.0, pitch: 20.0, fov: 0.1, heading: 40.0, ..View::default() };
    let mut all = Vec::new();
    for (name, altitude, half) in
        [("hand-over begins", 15e3, 1e3), ("hand-over ends", 50e3, 1e3), ("top", 100e3, 1.0)]
    {
        // The sky above, and the ground below.
        for pitch in [10.0, -4.0, -40.0] {
            let at = |altitude| View { altitude, pitch, sun_elevation: 20.0, ..view.clone() };
            all.push((name, steps(altitude - half, altitude + half).map(at).collect()));
        }
    }
    let sun = |altitude: f64, pitch: f64| {
        let view = View { altitude, pitch, ..view.clone() };
        steps(2.0, -6.0).map(move |sun_elevation| View { sun_elevation, ..view.clone() }).collect()
    };
    all.push(("sunset", sun(2.0, 20.0)));
    all.push(("sunset", sun(4e5, -80.0)));
    all
}

/// What second differences may differ by from the reference's, of the logarithm of light; and steps between
/// neighbours, in 255ths of what a screen shows, at an exposure that makes the line's brightest 0.8 and at
/// 1e5. Single scattering by 256 × 64 samples, then the LUTs of [`Quality::MEDIUM`].
///
/// A rounded 255th is a step of 1 or 2. What the LUTs have more than that is their own error, which is not
/// the same on both sides: at dusk a long ray along the horizon is 26 % too dark from 30 km, and one that
/// just meets the ground 3 %.
const BOUNDS: [(&str, [f64; 2], [f64; 2]); 12] = [
    ("horizon", [0.02, 2.0], [0.05, 3.0]),
    ("horizon at dusk", [0.02, 2.0], [0.3, 18.0]),
    ("limb", [0.02, 2.0], [0.1, 5.0]),
    ("limb at night", [0.04, 2.0], [0.18, 8.0]),
    ("sun's azimuth", [1e-3, 2.0], [2e-3, 2.0]),
    ("zenith", [1e-3, 2.0], [2e-3, 2.0]),
    ("nadir", [1e-3, 2.0], [2e-3, 2.0]),
    ("terminator", [1e-3, 2.0], [0.02, 2.0]),
    ("hand-over begins", [1e-3, 2.0], [0.01, 2.0]),
    ("hand-over ends", [1e-3, 2.0], [2e-3, 2.0]),
    ("top", [1e-3, 2.0], [2e-3, 2.0]),
    ("sunset", [1e-3, 2.0], [8e-3, 2.0]),
];

fn continuous(method: Quality, bounds: impl Fn(&str) -> [f64; 2]) {
    let (within, through) = (sample(within(), |line| line.0), sample(through(), |line| line.0));
    let want = |view: &View, size: [u32; 2]| -> Vec<[f64; 3]> {
        let scene = view.scene();
        rays(&scene, size).iter().map(|q| expected(&scene, q, method, 1e-5)).collect()
    };
    let within: Vec<_> = within.into_iter().map(|(n, v, size)| (n, want(&v, size), v, size)).collect();
    let through: Vec<_> = through
        .into_iter()
        .map(|(n, views)| (n, views.iter().flat_map(|v| want(v, [1, 1])).collect::<Vec<_>>(), views))
        .collect();
    let settings = over_black(sky(method));
    on_both(|b| {
        let name = b.info().backend;
        let mut renderer = PictureRenderer::default();
        let mut draw = |b: &mut dyn Backend, view: &View, size: [u32; 2]| -> Vec<[f64; 3]> {
            let pixels = draw(b, &mut renderer, &view.scene(), &settings, size);
            assert_physical(&pixels, &format!("{view:?}"));
            colors(&pixels)
        };
        let mut worst: Vec<(&str, [f64; 2])> = Vec::new();
        let mut judge = |line: &'static str, got: Vec<[f64; 3]>, want: &[[f64; 3]], what: &View| {
            assert_eq!(got.len(), N as usize);
            let line_of = Line { got: &got, want };
            let figures = [line_of.bend(), line_of.levels().max(line_of.levels_at(1e5))];
            if !worst.iter().any(|w| w.0 == line) {
                worst.push((line, [0.0; 2]));
            }
            let entry = worst.iter_mut().find(|w| w.0 == line).unwrap();
            for i in 0..2 {
                entry.1[i] = entry.1[i].max(figures[i]);
            }
            if figures.iter().zip(bounds(line)).any(|(f, b)| *f > b) {
                let View { altitude, pitch, heading, fov, sun_elevation, .. } = what;
                println!(
                    "{name} {line}: {figures:.4?} at {altitude} m, pitch {pitch}, heading {heading}, \
                     fov {fov}, sun {sun_elevation}: blue {:.4?}, off by {:.4?}",
                    want.iter().map(|v| v[2]).collect::<Vec<_>>(),
                    line_of.channel()
                );
            }
        };
        for (line, want, view, size) in &within {
            judge(line, draw(b, view, *size), want, view);
        }
        for (line, want, views) in &through {
            let got = views.iter().flat_map(|v| draw(b, v, [1, 1])).collect();
            judge(line, got, want, &views[0]);
        }
        renderer.destroy(b);
        println!("{name} {}: bend and 255ths beyond the reference's: {worst:.4?}", method.method());
        for (line, figures) in worst {
            let allowed = bounds(line);
            assert!(
                figures.iter().zip(allowed).all(|(f, b)| *f <= b),
                "{name} {line}: {figures:.4?}, {allowed:?}"
            );
        }
    });
}

#[test]
fn single_scattering_is_continuous_along_lines() {
    continuous(march(256, 64), |line| BOUNDS.iter().find(|b| b.0 == line).unwrap().1);
}

#[test]
fn luts_are_continuous_along_lines() {
    continuous(Quality::MEDIUM, |line| BOUNDS.iter().find(|b| b.0 == line).unwrap().2);
}

// --- lines across edges of the scene

/// A line of pixels and the scene in them: metres along each pixel's ray, infinite where there is none.
struct Edge {
    name: &'static str,
    scene: Scene,
    size: [u32; 2],
    /// What a depth buffer holds.
    stored: Vec<f32>,
    ends: Vec<f64>,
}

impl Edge {
    /// With a scene at the given distances along the pixels' rays, metres.
    fn new(name: &'static str, view: &View, size: [u32; 2], ends: impl Fn(usize, &RayQuery) -> f64) -> Self {
        let scene = view.scene();
        let rays = rays(&scene, size);
        let stored = rays.iter().zip(steepness(&scene, size)).enumerate().map(|(i, (ray, per_depth))| {
            let end = ends(i, ray);
            (if end.is_finite() { scene.depth.encode(end / per_depth) } else { scene.depth.background() })
                as f32
        });
        Self::stored(name, scene.clone(), size, stored.collect())
    }

    /// With the scene of a depth buffer.
    fn stored(name: &'static str, scene: Scene, size: [u32; 2], stored: Vec<f32>) -> Self {
        let lengths = steepness(&scene, size);
        let ends = stored.iter().zip(lengths).map(|(d, l)| scene.depth.decode(f64::from(*d)) * l).collect();
        Self { name, scene, size, stored, ends }
    }

    /// Light and transmittance of the air before the scene.
    fn truth(&self, method: Quality) -> [Vec<[f64; 3]>; 2] {
        let tolerance = Tolerance { relative: 1e-5 };
        let rays = rays(&self.scene, self.size);
        let at = |(ray, end): (RayQuery, &f64)| {
            let query = ray.ended_at(*end);
            let through = transmittance(&self.scene.atmosphere, &query, tolerance).unwrap();
            (expected(&self.scene, &query, method, 1e-5), through)
        };
        let (light, through) = rays.into_iter().zip(&self.ends).map(at).unzip();
        [light, through]
    }

    /// The same, drawn: the sky, the scene over it, and the air before both.
    fn draw(&self, b: &mut dyn Backend, sky: &mut SkyRenderer) -> [Vec<[f64; 3]>; 2] {
        let [w, h] = self.size;
        let [color, depth, out] = frame_textures(b, self.size);
        b.write_texture(depth, &self.stored).unwrap();
        let [black, white] = [0.0, 1.0].map(|behind| {
            let clear = [behind, behind, behind, 1.0];
            b.write_texture(color, &clear.repeat((w * h) as usize)).unwrap();
            let passes = background_passes(b, sky, &self.scene, Target::color(color));
            b.run(&passes).unwrap();
            let mut pixels = b.read(color).unwrap();
            for (pixel, end) in pixels.chunks_exact_mut(4).zip(&self.ends) {
                if end.is_finite() {
                    pixel.copy_from_slice(&clear);
                }
            }
            b.write_texture(color, &pixels).unwrap();
            let passes = aerial_passes(b, sky, &self.scene, [color, depth, out]);
            b.run(&passes).unwrap();
            let pixels = b.read(if passes.is_empty() { color } else { out }).unwrap();
            assert_physical(&pixels, self.name);
            colors(&pixels)
        });
        free(b, [color, out, depth]);
        let through = black.iter().zip(&white).map(|(b, w)| [0, 1, 2].map(|c| w[c] - b[c])).collect();
        [black, through]
    }
}

/// Metres along each pixel's ray per metre of depth.
fn steepness(scene: &Scene, [w, h]: [u32; 2]) -> Vec<f64> {
    let basis = scene.camera.basis().unwrap();
    let share = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    (0..w * h).map(|i| basis.ray(DVec2::new(share(i % w, w), -share(i / w, h))).length()).collect()
}

/// Where a ray from outside meets the sphere at an altitude, metres; infinite where it passes.
fn sphere(ray: &RayQuery, altitude: f64, radius: f64) -> f64 {
    let (r, above) = (radius + ray.altitude, ray.altitude - altitude);
    let (b, c) = (r * ray.direction.z, above * (2.0 * r - above));
    let square = b * b - c;
    if b < 0.0 && square > 0.0 { c / (square.sqrt() - b) } else { f64::INFINITY }
}

/// Where a ray from within leaves the sphere at an altitude, metres.
fn leaves(ray: &RayQuery, altitude: f64, radius: f64) -> f64 {
    let (r, below) = (radius + ray.altitude, altitude - ray.altitude);
    let b = r * ray.direction.z;
    (b * b + below * (2.0 * r + below)).sqrt() - b
}

fn edges() -> Vec<Edge> {
    let mut all = Vec::new();
    let (radius, top) = (View::default().params.planet_radius, View::default().params.thickness());
    let column = |v: View| View { aspect: 1.0 / f64::from(N), ..v };
    let row = |v: View| View { fov: v.fov / f64::from(N), aspect: f64::from(N), ..v };
    let dip = |altitude: f64, up: f64| -((radius + up) / (radius + altitude)).acos().to_degrees();
    // Posts of five pixels, before the sky and before the ground.
    let posts =
        |distance: f64| move |i: usize, _: &RayQuery| if i / 5 % 2 == 1 { distance } else { f64::INFINITY };
    for (altitude, sun_elevation) in [(100.0, 20.0), (100.0, -4.0), (3e4, 20.0), (3e4, 2.0)] {
        for distance in [0.01, 1e3, 1e5] {
            for above in [1.0, -0.7] {
                let pitch = dip(altitude, 0.0) + above;
                let view =
                    View { altitude, pitch, fov: 2.0, heading: 90.0, sun_elevation, ..View::default() };
                all.push(Edge::new("posts", &row(view), [N, 1], posts(distance)));
            }
        }
    }
    // The limb from orbit, with something before the air, in it and behind it.
    for distance in [1e3, 2e6, 3e6] {
        let (high, low) = (dip(4e5, 6e4), dip(4e5, -1e4));
        let (pitch, fov) = (0.5 * (high + low), high - low);
        let view = View { altitude: 4e5, pitch, fov, sun_elevation: 25.0, ..View::default() };
        // The ground hides what is behind it.
        let seen = |i: usize, ray: &RayQuery| {
            Some(posts(distance)(i, ray))
                .filter(|end| *end < sphere(ray, 0.0, radius))
                .unwrap_or(f64::INFINITY)
        };
        all.push(Edge::new("posts from orbit", &column(view), [1, N], seen));
    }
    for sun_elevation in [20.0, 2.0, -4.0] {
        let view = View { altitude: 2e3, heading: 90.0, sun_elevation, ..View::default() };
        // A plain 500 m high to its horizon, and one that ends 50 km away, the ground behind.
        let plain = View { pitch: dip(2e3, 500.0), fov: 0.4, ..view.clone() };
        all.push(Edge::new("plain's horizon", &column(plain), [1, N], |_, ray| sphere(ray, 500.0, radius)));
        let pitch = -(1500.0_f64 / 50e3).atan().to_degrees() - 0.22;
        let table = View { pitch, fov: 0.4, ..view.clone() };
        let ends = |_: usize, ray: &RayQuery| Some(sphere(ray, 500.0, radius)).filter(|t| *t < 50e3);
        all.push(Edge::new("plain's end", &column(table), [1, N], move |i, ray| {
            ends(i, ray).unwrap_or(f64::INFINITY)
        }));
        // Farther and farther, to the far end of the air and on, then nothing.
        let wide = |pitch| row(View { pitch, fov: 60.0, ..view.clone() });
        let step = |i: usize| i as f64 / (f64::from(N) - 4.0);
        let far = |i: usize, end: f64| if step(i) > 1.0 { f64::INFINITY } else { end };
        all.push(Edge::new("into the sky", &wide(3.0), [N, 1], |i, ray| {
            far(i, leaves(ray, top, radius) * (0.4 + 0.8 * step(i)))
        }));
        all.push(Edge::new("onto the ground", &wide(-5.0), [N, 1], |i, ray| {
            far(i, sphere(ray, 0.0, radius) * (0.96 + 0.04 * step(i)))
        }));
    }
    all
}

/// The demonstration's mountains, as the backend draws them from 600 m above one: lines across their skyline.
fn mountains(b: &mut dyn Backend) -> Vec<Edge> {
    let style = TerrainStyle::earth();
    let (latitude, longitude) = ((-20.0_f64).to_radians(), 30.0_f64.to_radians());
    let up = DVec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin());
    let north =
        DVec3::new(-latitude.sin() * longitude.cos(), -latitude.sin() * longitude.sin(), latitude.cos());
    let mut all = Vec::new();
    for (sun_elevation, [w, h]) in [(20.0_f64, [1, N]), (20.0, [N, 1]), (2.0, [1, N]), (2.0, [N, 1])] {
        let view = View::default();
        let altitude = style.height(up, view.params.planet_radius).0 + 600.0;
        let fov = (if h == 1 { 40.0 / f64::from(N) } else { 4.0_f64 }).to_radians();
        let pitch = (if h == 1 { 1.0_f64 } else { 0.0 }).to_radians();
        let pose = Pose {
            altitude,
            pitch,
            heading: (if h == 1 { -5.0_f64 } else { -15.0 }).to_radians(),
            fov_y: fov,
        };
        let aspect = f64::from(w) / f64::from(h);
        let camera = Camera::above(DVec3::ZERO, view.params.planet_radius, up, north, pose, aspect).unwrap();
        let (sin, cos) = sun_elevation.to_radians().sin_cos();
        let scene = Scene { camera, sun_direction: up * sin + up.cross(north) * cos, ..view.scene() };
        let copy = texture(b, "mountains", [w, h], Format::R32Float);
        let off = SkySettings { look: Look { enabled: false, ..Look::default() }, ..SkySettings::default() };
        let settings = PictureSettings { terrain: Some(style), ..over_black(off) };
        let mut picture = PictureRenderer::default();
        let depth = picture.draw(b, &scene, &settings, [w, h]).unwrap().depth;
        let copied = copy_pass(b, depth, copy);
        b.run(&[copied]).unwrap();
        picture.destroy(b);
        let stored = b.read(copy).unwrap();
        free(b, [copy]);
        let edge = Edge::stored("mountains", scene, [w, h], stored);
        let sky = edge.ends.iter().filter(|end| end.is_infinite()).count();
        assert!((4..28).contains(&sky), "no skyline: {:?}", edge.ends);
        all.push(edge);
    }
    all
}

/// Bounds as in [`BOUNDS`], then the largest error of light over the light, or over a thousandth of the
/// line's brightest where it has less, and the largest of transmittance. Single scattering, then LUTs.
const EDGE_BOUNDS: [(&str, [f64; 4], [f64; 4]); 7] = [
    ("posts", [2e-3, 2.0, 2e-3, 1e-4], [0.03, 3.0, 0.03, 1e-3]),
    ("posts from orbit", [2e-3, 2.0, 2e-3, 1e-4], [0.03, 3.0, 0.03, 1e-3]),
    ("plain's horizon", [2e-3, 2.0, 2e-3, 1e-4], [0.09, 6.0, 0.08, 1e-3]),
    ("plain's end", [2e-3, 2.0, 2e-3, 1e-4], [0.01, 2.0, 0.03, 1e-3]),
    ("into the sky", [2e-3, 2.0, 2e-3, 1e-4], [0.02, 2.0, 0.03, 1e-3]),
    // What `scene_reach` takes for the ground is a sixteenth of a pixel farther than it is.
    ("onto the ground", [3e-3, 2.0, 0.016, 6e-3], [3e-3, 2.0, 0.07, 0.01]),
    ("mountains", [2e-3, 2.0, 2e-3, 1e-4], [0.05, 3.0, 0.05, 1e-3]),
];

fn continuous_across_edges(method: Quality, bounds: impl Fn(&str) -> [f64; 4]) {
    let edges = sample(edges(), |edge| edge.name);
    let want: Vec<_> = edges.iter().map(|e| e.truth(method)).collect();
    on_both(|b| {
        let name = b.info().backend;
        let mut sky = SkyRenderer::new(sky(method)).unwrap();
        let mut worst: Vec<(&str, [f64; 4])> = Vec::new();
        let mut judge = |edge: &Edge, [light, through]: [Vec<[f64; 3]>; 2], want: &[Vec<[f64; 3]>; 2]| {
            let line = Line { got: &light, want: &want[0] };
            // The background dims what is behind the sky by the mean of the channels.
            let mean = |v: &[f64; 3]| v.iter().sum::<f64>() / 3.0;
            let dims = through.iter().zip(&want[1]).zip(&edge.ends).map(|((got, want), end)| {
                match end.is_finite() {
                    true => (0..3).map(|c| (got[c] - want[c]).abs()).fold(0.0, f64::max),
                    false => (mean(got) - mean(want)).abs(),
                }
            });
            let levels = line.levels().max(line.levels_at(1e5));
            let figures = [line.bend(), levels, line.off(), dims.fold(0.0, f64::max)];
            if !worst.iter().any(|w| w.0 == edge.name) {
                worst.push((edge.name, [0.0; 4]));
            }
            let entry = worst.iter_mut().find(|w| w.0 == edge.name).unwrap();
            for i in 0..4 {
                entry.1[i] = entry.1[i].max(figures[i]);
            }
            if figures.iter().zip(bounds(edge.name)).any(|(f, b)| *f > b) {
                println!(
                    "{name} {}: {figures:.4?} at {} m: blue {:.7?}, off by {:.4?}, ends {:.1?}",
                    edge.name,
                    rays(&edge.scene, [1, 1])[0].altitude,
                    want[0].iter().map(|v| v[2]).collect::<Vec<_>>(),
                    line.channel(),
                    edge.ends
                );
            }
        };
        for (edge, want) in edges.iter().zip(&want) {
            judge(edge, edge.draw(b, &mut sky), want);
        }
        for edge in mountains(b) {
            judge(&edge, edge.draw(b, &mut sky), &edge.truth(method));
        }
        sky.destroy(b);
        println!("{name} {}: bend, 255ths, light and transmittance off: {worst:.4?}", method.method());
        for (line, figures) in worst {
            let allowed = bounds(line);
            assert!(
                figures.iter().zip(allowed).all(|(f, b)| *f <= b),
                "{name} {line}: {figures:.4?}, {allowed:?}"
            );
        }
    });
}

#[test]
fn single_scattering_is_continuous_across_edges() {
    continuous_across_edges(march(256, 64), |line| EDGE_BOUNDS.iter().find(|b| b.0 == line).unwrap().1);
}

#[test]
fn luts_are_continuous_across_edges() {
    continuous_across_edges(Quality::MEDIUM, |line| EDGE_BOUNDS.iter().find(|b| b.0 == line).unwrap().2);
}
