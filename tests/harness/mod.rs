//! What the tests share: both backends, scenes, drawing, rays and the reference's light.
//!
//! A missing driver is a failure, never a skip. Every call of a renderer goes through a function of this
//! module or of [`draw`], so that a test says what must hold and not how a frame is assembled.

pub mod allocations;
pub mod draw;
pub mod ledger;
pub mod lines;
pub mod reference;
pub mod scenes;
pub mod tables;
pub mod world;

pub use draw::*;
pub use reference::{earth, expected, expected_picture, orders};
pub use scenes::{View, airless, query, rays};

use welkin::gpu::{Backend, egl::Headless, wgpu::WgpuBackend};

/// Runs the same body on both backends, and prints which adapters it ran on.
pub fn on_both(mut body: impl FnMut(&mut dyn Backend)) {
    let mut webgpu = WgpuBackend::headless().expect("WebGPU needs a Vulkan driver: run scripts/setup");
    eprintln!("{}", webgpu.info());
    body(&mut webgpu);
    let mut webgl2 = Headless::new().expect("WebGL2 needs EGL with OpenGL ES 3: run scripts/setup");
    eprintln!("{}", webgl2.backend.info());
    body(&mut webgl2.backend);
}

/// Whether to try all that there is and not a sample of each kind: `scripts/test --all` sets `WELKIN_ALL`.
pub fn everything() -> bool {
    std::env::var_os("WELKIN_ALL").is_some()
}

/// All things, if [`everything`] is to be tried; or else the first and the last of each name.
pub fn sample<T>(all: Vec<T>, name: impl Fn(&T) -> &'static str) -> Vec<T> {
    if everything() {
        return all;
    }
    let names: Vec<_> = all.iter().map(name).collect();
    let at_an_end = |i: usize| !names[..i].contains(&names[i]) || !names[i + 1..].contains(&names[i]);
    all.into_iter().enumerate().filter(|(i, _)| at_an_end(*i)).map(|(_, thing)| thing).collect()
}

/// How many cases or scenes to try: what an environment variable says, or else the usual number.
pub fn asked_for(variable: &str, usual: usize) -> usize {
    let Ok(text) = std::env::var(variable) else { return usual };
    text.parse().unwrap_or_else(|e| panic!("{variable} = {text:?} must be a whole number: {e}"))
}

/// Red, green and blue of a pixel of an RGBA picture.
pub fn rgb(pixels: &[f32], i: usize) -> [f64; 3] {
    [0, 1, 2].map(|c| f64::from(pixels[4 * i + c]))
}

/// Red, green and blue of every pixel of an RGBA picture.
pub fn colors(pixels: &[f32]) -> Vec<[f64; 3]> {
    (0..pixels.len() / 4).map(|i| rgb(pixels, i)).collect()
}

/// Mean of the red, green and blue channels of an RGBA picture.
pub fn mean(pixels: &[f32]) -> [f64; 3] {
    let n = (pixels.len() / 4) as f64;
    let mut sum = [0.0; 3];
    for color in colors(pixels) {
        for c in 0..3 {
            sum[c] += color[c] / n;
        }
    }
    sum
}

/// Largest value of each channel.
pub fn brightest(values: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|c| values.iter().fold(0.0, |m: f64, v| m.max(v[c])))
}

/// Fails unless every value of an RGBA picture is finite and no colour is negative.
#[track_caller]
pub fn assert_physical(pixels: &[f32], what: &str) {
    for (i, p) in pixels.chunks_exact(4).enumerate() {
        assert!(p.iter().all(|v| v.is_finite()), "{what}: pixel {i} is {p:?}");
        assert!(p[..3].iter().all(|v| *v >= 0.0), "{what}: pixel {i} is negative: {p:?}");
    }
}
