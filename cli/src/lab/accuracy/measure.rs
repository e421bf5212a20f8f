//! What the accuracy report measures: what the reference expects of some pixels of a scene, and a backend's
//! errors and times.

use anyhow::{Context, ensure};
use palette::color_difference::Ciede2000;
use palette::white_point::D65;
use palette::{IntoColor, Lab, Srgb};
use rayon::prelude::*;
use welkin::frame::luts::MEDIUM_LABELS;
use welkin::frame::tone_map::{srgb_encode, tone_map};
use welkin::gpu::{Backend, Format, Pass, PassTime, TextureId};
use welkin::reference::multiple::Orders;
use welkin::reference::single::{Sun, Tolerance, single_scattering};
use welkin::{PictureRenderer, PictureSettings, Scene, SkySettings, ToneMap};

use crate::lab::reference;
use crate::lab::timing;

/// Values below this fraction of the picture's brightest count as that bright: errors in the dark do not
/// show.
pub const FLOOR: f64 = 1e-3;

/// What an error is an error against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// All orders of scattering: everything that is missing or wrong.
    AllOrders,
    /// Light scattered once: what the sampling does, of a method that computes no more than that.
    Single,
}

impl Against {
    /// The main comparison first.
    pub const BOTH: [Self; 2] = [Self::AllOrders, Self::Single];

    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::AllOrders => "all-orders",
        }
    }
}

/// The reference's radiance at the compared pixels.
pub struct Expected {
    single: Vec<[f64; 3]>,
    all_orders: Vec<[f64; 3]>,
    exposure: f64,
}

impl Expected {
    /// Of every pixel of a scene's picture. Light that comes straight from the ground is left out: it is the
    /// scene's own to draw.
    pub fn new(scene: &Scene, size: [u32; 2], orders: &Orders) -> anyhow::Result<Self> {
        let view = scene.validate()?;
        let both = |i: u32| {
            let ray = reference::pixel_ray(&view, [i % size[0], i / size[0]], size);
            let once = single_scattering(&scene.atmosphere, &ray, Sun::Point, Tolerance::TRUTH)?;
            Ok((once.per_irradiance, reference::inscatter(orders, &ray)?))
        };
        let both = (0..size[0] * size[1]).into_par_iter().map(both).collect::<welkin::Result<Vec<_>>>()?;
        let (single, all_orders): (Vec<[f64; 3]>, Vec<[f64; 3]>) = both.into_iter().unzip();
        let mut luminance: Vec<f64> =
            all_orders.iter().map(|c: &[f64; 3]| 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]).collect();
        luminance.sort_by(f64::total_cmp);
        let bright = luminance[(luminance.len() - 1) * 95 / 100].max(1e-30);
        Ok(Self { single, all_orders, exposure: 0.5 / bright })
    }

    fn values(&self, against: Against) -> &[[f64; 3]] {
        match against {
            Against::Single => &self.single,
            Against::AllOrders => &self.all_orders,
        }
    }

    fn display(&self, radiance: [f64; 3]) -> Lab<D65, f64> {
        let display = tone_map(ToneMap::Aces, radiance.map(|v| v * self.exposure)).map(srgb_encode);
        Srgb::new(display[0], display[1], display[2]).into_color()
    }

    /// Errors of radiance drawn at the compared pixels.
    pub fn errors(&self, drawn: &[[f64; 3]], against: Against) -> Errors {
        let want = self.values(against);
        let mut errors = Errors::default();
        let brightest: [f64; 3] = std::array::from_fn(|c| want.iter().map(|w| w[c]).fold(0.0, f64::max));
        for (got, want) in drawn.iter().zip(want) {
            for c in 0..3 {
                let scale = want[c].max(FLOOR * brightest[c]);
                let off = (got[c] - want[c]).abs();
                // Black where black is expected is right; light there is all wrong.
                errors.relative[c].push(if scale > 0.0 { off / scale } else { f64::from(off > 0.0) });
            }
            errors.delta_e.push(self.display(*got).difference(self.display(*want)));
        }
        errors
    }
}

/// Every single error, so that statistics can be taken over several scenes.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// Errors of radiance, per channel.
    pub relative: [Vec<f64>; 3],
    /// CIEDE2000 after tone mapping.
    pub delta_e: Vec<f64>,
}

impl Errors {
    pub fn extend(&mut self, other: &Self) {
        for c in 0..3 {
            self.relative[c].extend(&other.relative[c]);
        }
        self.delta_e.extend(&other.delta_e);
    }

    pub fn summary(&self) -> Summary {
        Summary {
            relative: std::array::from_fn(|c| Statistics::of(&self.relative[c])),
            delta_e: Statistics::of(&self.delta_e),
        }
    }
}

/// Mean, 95th percentile and maximum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    pub mean: f64,
    pub p95: f64,
    pub max: f64,
}

impl Statistics {
    /// All 0 of nothing.
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let Some(&max) = sorted.last() else { return Self::default() };
        // The smallest value that at least 95 % do not exceed.
        let rank = (sorted.len() * 95).div_ceil(100).max(1);
        Self { mean: sorted.iter().sum::<f64>() / sorted.len() as f64, p95: sorted[rank - 1], max }
    }
}

/// [`Errors`] in short.
#[derive(Clone, Copy, Debug, Default)]
pub struct Summary {
    pub relative: [Statistics; 3],
    pub delta_e: Statistics,
}

impl Summary {
    /// The worst channel's.
    pub fn worst(&self, of: impl Fn(&Statistics) -> f64) -> f64 {
        self.relative.iter().map(of).fold(0.0, f64::max)
    }
}

/// Milliseconds, the best of several runs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Times {
    /// Time of the sky's passes: background and aerial perspective.
    pub sky: f64,
    /// Time of a full-screen copy of the same target in the same runs.
    pub copy: f64,
    /// Time of what is made once for a medium, in the frame that made it.
    pub once: f64,
}

impl Times {
    /// Worse than any measurement.
    pub const NEVER: Self = Self { sky: f64::INFINITY, copy: f64::INFINITY, once: 0.0 };

    pub fn best(self, other: Self) -> Self {
        Self {
            sky: self.sky.min(other.sky),
            copy: self.copy.min(other.copy),
            once: self.once.max(other.once),
        }
    }
}

/// The sky's passes of a frame, and where they leave its radiance.
fn sky_passes(
    backend: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    size: [u32; 2],
    sky: SkySettings,
) -> welkin::Result<(Vec<Pass>, TextureId)> {
    let mut sky = sky;
    sky.look.sun_disk = false;
    let settings =
        PictureSettings { sky, terrain: None, radiance: Format::Rgba32Float, ..PictureSettings::default() };
    let (passes, drawn) = renderer.passes(backend, scene, &settings, size)?;
    Ok((passes.iter().filter(|p| p.target.color != drawn.display).cloned().collect(), drawn.radiance))
}

/// Draws a picture: the radiance of every pixel.
pub fn draw(
    backend: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    size: [u32; 2],
    sky: SkySettings,
) -> anyhow::Result<Vec<[f64; 3]>> {
    let (passes, radiance) = sky_passes(backend, renderer, scene, size, sky)?;
    backend.run(&passes).context("draw")?;
    let pixels = backend.read(radiance).context("read the radiance back")?;
    let drawn: Vec<_> = pixels.chunks_exact(4).map(|p| [p[0], p[1], p[2]].map(f64::from)).collect();
    ensure!(drawn.len() == (size[0] * size[1]) as usize, "the picture that came back has another size");
    for (i, radiance) in drawn.iter().enumerate() {
        ensure!(radiance.iter().all(|v| v.is_finite()), "compared pixel {i} is not finite");
    }
    Ok(drawn)
}

/// Times a frame once, with a full-screen copy of its target in the same submission.
pub fn time(
    backend: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    scene: &Scene,
    size: [u32; 2],
    sky: SkySettings,
    copy_to: TextureId,
) -> welkin::Result<Times> {
    let (mut passes, radiance) = sky_passes(backend, renderer, scene, size, sky)?;
    passes.push(timing::copy(backend, radiance, copy_to)?);
    let times = backend.times(&passes)?;
    let sum = |of: &dyn Fn(&PassTime) -> bool| {
        times.iter().filter(|t| of(t)).map(|t| t.nanoseconds).sum::<f64>() * 1e-6
    };
    let (copy, once) =
        (|t: &PassTime| t.label == timing::COPY, |t: &PassTime| MEDIUM_LABELS.contains(&t.label));
    Ok(Times { sky: sum(&|t| !copy(t) && !once(t)), copy: sum(&copy), once: sum(&once) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statistics_of_a_hundred_and_of_none() {
        let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!(Statistics::of(&values), Statistics { mean: 50.5, p95: 95.0, max: 100.0 });
        assert_eq!(Statistics::of(&[]), Statistics::default());
    }

    #[test]
    fn errors_are_relative_above_the_floor_and_visible_ones_have_a_distance() {
        let expected = Expected {
            single: vec![[1.0, 2.0, 4.0], [0.0; 3]],
            all_orders: vec![[1.0; 3]; 2],
            exposure: 0.5,
        };
        let errors = expected.errors(&[[1.1, 2.0, 3.0], [0.0, 2e-3, 0.0]], Against::Single);
        assert!((errors.relative[0][0] - 0.1).abs() < 1e-12 && errors.relative[0][1] == 0.0);
        assert!((errors.relative[1][1] - 1.0).abs() < 1e-12, "2e-3 over a floor of 2e-3: {errors:?}");
        assert!((errors.relative[2][0] - 0.25).abs() < 1e-12);
        assert!(errors.delta_e[0] > 1.0 && errors.delta_e[1] < 1.0, "{errors:?}");
        let same = expected.errors(&[[1.0; 3]; 2], Against::AllOrders);
        assert_eq!(same.summary().delta_e.max, 0.0);
    }

    /// Pair 1 of Sharma, Wu & Dalal 2005, table 1.
    #[test]
    fn colour_difference_is_the_published_one() {
        let a: Lab<D65, f64> = Lab::new(50.0, 2.6772, -79.7751);
        let difference = a.difference(Lab::new(50.0, 0.0, -82.7485));
        assert!((difference - 2.0425).abs() < 1e-4, "{difference}");
    }
}
