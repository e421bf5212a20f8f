//! Numerical integration: Gauss–Legendre rules of any order, and an adaptive Gauss–Kronrod pair.

use std::f64::consts::PI;
use std::sync::OnceLock;

/// Nodes in -1..1 and weights of the n-point Gauss–Legendre rule, exact for degree 2 n - 1.
///
/// Newton's method on the Legendre polynomial, from Tricomi's starting values
/// (Abramowitz & Stegun 25.4.29 for the weights). `n` of 0 counts as 1.
pub(crate) fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let n = n.max(1);
    let mut rule = vec![(0.0, 0.0); n];
    for i in 0..n.div_ceil(2) {
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..100 {
            let (p, dp) = legendre(n, x);
            slope = dp;
            let step = p / dp;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        let weight = 2.0 / ((1.0 - x * x) * slope * slope);
        rule[i] = (-x, weight);
        rule[n - 1 - i] = (x, weight);
    }
    if n % 2 == 1 {
        rule[n / 2].0 = 0.0;
    }
    rule
}

/// Legendre polynomial of degree n and its derivative, |x| < 1.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut previous, mut p) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (previous, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * previous) / k);
    }
    if n == 0 {
        return (1.0, 0.0);
    }
    (p, n as f64 * (x * p - previous) / (x * x - 1.0))
}

/// A Gauss–Legendre rule that is computed once.
macro_rules! cached_rule {
    ($name:ident, $n:expr) => {
        pub(crate) fn $name() -> &'static [(f64, f64); $n] {
            static RULE: OnceLock<[(f64, f64); $n]> = OnceLock::new();
            RULE.get_or_init(|| {
                let rule = gauss_legendre($n);
                std::array::from_fn(|i| rule[i])
            })
        }
    };
}

cached_rule!(gauss_4, 4);
cached_rule!(gauss_6, 6);
cached_rule!(gauss_10, 10);
cached_rule!(gauss_16, 16);
cached_rule!(gauss_32, 32);

/// Kronrod's 15 nodes (the non-negative ones) with the weights of the 15-point rule and of the
/// 7-point Gauss rule inside it (Piessens et al. 1983, QUADPACK `qk15`).
#[allow(clippy::excessive_precision)]
const KRONROD: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_639_206_854_697_526_329, 0.022_935_322_010_529_224_963_732_008_058_970, 0.0),
    (
        0.949_107_912_342_758_524_526_189_684_047_851,
        0.063_092_092_629_978_553_290_700_663_189_204,
        0.129_484_966_168_869_693_270_611_432_679_082,
    ),
    (0.864_864_423_359_769_072_789_712_788_640_926, 0.104_790_010_322_250_183_839_876_322_541_518, 0.0),
    (
        0.741_531_185_599_394_439_863_864_773_280_788,
        0.140_653_259_715_525_918_745_189_590_510_238,
        0.279_705_391_489_276_667_901_467_771_423_780,
    ),
    (0.586_087_235_467_691_130_294_144_838_258_730, 0.169_004_726_639_267_902_826_583_426_598_550, 0.0),
    (
        0.405_845_151_377_397_166_906_606_412_076_961,
        0.190_350_578_064_785_409_913_256_402_421_014,
        0.381_830_050_505_118_944_950_369_775_488_975,
    ),
    (0.207_784_955_007_898_467_600_689_403_773_245, 0.204_432_940_075_298_892_414_161_999_234_649, 0.0),
    (0.0, 0.209_482_141_084_727_828_012_999_174_891_714, 0.417_959_183_673_469_387_755_102_040_816_327),
];

/// What [`integrate`] found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integral {
    pub value: [f64; 3],
    /// Estimated absolute error of each channel.
    pub error: [f64; 3],
    /// How often the integrand was evaluated.
    pub evaluations: u32,
}

struct Panel {
    lo: f64,
    hi: f64,
    value: [f64; 3],
    error: [f64; 3],
}

fn panel(f: &mut impl FnMut(f64) -> [f64; 3], lo: f64, hi: f64) -> Panel {
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let mut kronrod = [0.0; 3];
    let mut gauss = [0.0; 3];
    let mut samples = [([0.0; 3], 0.0); 15];
    let mut count = 0;
    for (x, wk, wg) in KRONROD {
        for side in [-1.0, 1.0] {
            if x == 0.0 && side > 0.0 {
                continue;
            }
            let y = f(middle + side * half * x);
            for c in 0..3 {
                kronrod[c] += wk * y[c];
                gauss[c] += wg * y[c];
            }
            samples[count] = (y, wk);
            count += 1;
        }
    }
    // QUADPACK's error estimate: the difference of the two rules, scaled by how much the integrand varies.
    let error = std::array::from_fn(|c| {
        let mean = 0.5 * kronrod[c];
        let variation: f64 = samples.iter().map(|(y, w)| w * (y[c] - mean).abs()).sum::<f64>() * half;
        let difference = ((kronrod[c] - gauss[c]) * half).abs();
        if variation > 0.0 {
            variation * (200.0 * difference / variation).powf(1.5).min(1.0)
        } else {
            difference
        }
    });
    Panel { lo, hi, value: kronrod.map(|v| v * half), error }
}

/// Integral of three functions at once over the panels between neighbouring `breaks` (ascending),
/// halving the worst panel until every channel's error is below `tolerance` × its value or `floor`.
pub(crate) fn integrate(
    mut f: impl FnMut(f64) -> [f64; 3],
    breaks: &[f64],
    tolerance: f64,
    floor: f64,
    max_panels: usize,
) -> Integral {
    let mut panels: Vec<Panel> =
        breaks.windows(2).filter(|w| w[1] > w[0]).map(|w| panel(&mut f, w[0], w[1])).collect();
    let mut evaluations = 15 * panels.len() as u32;
    loop {
        let mut value = [0.0; 3];
        let mut error = [0.0; 3];
        for p in &panels {
            for c in 0..3 {
                value[c] += p.value[c];
                error[c] += p.error[c];
            }
        }
        let allowed: [f64; 3] = std::array::from_fn(|c| (tolerance * f64::abs(value[c])).max(floor));
        let done = (0..3).all(|c| error[c] <= allowed[c]);
        if done || panels.len() >= max_panels || panels.is_empty() {
            return Integral { value, error, evaluations };
        }
        let badness = |p: &Panel| (0..3).map(|c| p.error[c] / allowed[c]).fold(0.0, f64::max);
        let mut worst = 0;
        for i in 1..panels.len() {
            if badness(&panels[i]) > badness(&panels[worst]) {
                worst = i;
            }
        }
        let Panel { lo, hi, .. } = panels.swap_remove(worst);
        let middle = 0.5 * (lo + hi);
        if !(lo < middle && middle < hi) {
            // As narrow as numbers get; keep what is known and count its error as nothing.
            let mut last = panel(&mut f, lo, hi);
            last.error = [0.0; 3];
            panels.push(last);
            evaluations += 15;
            continue;
        }
        panels.push(panel(&mut f, lo, middle));
        panels.push(panel(&mut f, middle, hi));
        evaluations += 30;
    }
}

/// Integral by six Gauss–Legendre nodes between neighbouring `breaks`, without an error estimate.
pub(crate) fn fixed(mut f: impl FnMut(f64) -> [f64; 3], breaks: &[f64]) -> Integral {
    let mut sum = Integral { value: [0.0; 3], error: [0.0; 3], evaluations: 0 };
    for w in breaks.windows(2).filter(|w| w[1] > w[0]) {
        let (middle, half) = (0.5 * (w[0] + w[1]), 0.5 * (w[1] - w[0]));
        for &(x, weight) in gauss_6() {
            let y = f(middle + half * x);
            for (sum, y) in sum.value.iter_mut().zip(y) {
                *sum += half * weight * y;
            }
        }
        sum.evaluations += 6;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_legendre_is_exact_to_its_degree() {
        for n in [1, 2, 5, 10, 16, 33, 64] {
            let rule = gauss_legendre(n);
            for degree in 0..2 * n {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree as i32)).sum();
                let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
                assert!((sum - exact).abs() < 1e-13, "n {n} degree {degree}: {sum} {exact}");
            }
        }
        assert_eq!(gauss_legendre(0).len(), 1);
    }

    #[test]
    fn adaptive_integration_meets_its_tolerance() {
        // A peak, a root and a jump at an unknown place.
        let peak = |x: f64| [1.0 / (1e-4 + (x - 0.3).powi(2)), x.sqrt(), f64::from(u8::from(x > 0.7321))];
        let exact = [((0.7f64 / 1e-2).atan() + (0.3f64 / 1e-2).atan()) / 1e-2, 2.0 / 3.0, 0.2679];
        let got = integrate(peak, &[0.0, 1.0], 1e-8, 0.0, 400);
        for (c, (got, exact)) in got.value.into_iter().zip(exact).enumerate() {
            assert!((got / exact - 1.0).abs() < 1e-8, "{c}: {got} {exact}");
        }
    }
    /// What `lib/columns.wgsl` does in a pixel: a Gaussian along a line (distances in roots of a scale
    /// height, which is then 1), from places before, at and behind its middle, over so many scale heights
    /// from the lowest point on; and an exponential, as along a vertical line. The largest error, in parts.
    #[test]
    fn few_nodes_are_enough_for_the_columns_of_pixels() {
        let sum = |n: usize, a: f64, b: f64, f: fn(f64) -> f64| -> f64 {
            let (half, middle) = (0.5 * (b - a), 0.5 * (a + b));
            gauss_legendre(n).iter().map(|(x, w)| half * w * f(middle + half * x)).sum()
        };
        let gauss = |t: f64| (-t * t).exp();
        let worst = |nodes: usize, heights: f64| {
            let mut most = (sum(nodes, 0.0, heights, |h| (-h).exp()) - 1.0).abs();
            for from in [-f64::INFINITY, -2.0, -1.5, -1.0, -0.5, -0.2, 0.0, 0.5, 1.0, 2.0_f64] {
                let reach = (from.max(0.0).powi(2) + heights).sqrt();
                let all = sum(64, from.max(-8.0), 8.0, gauss);
                most = most.max((sum(nodes, from.max(-reach), reach, gauss) / all - 1.0).abs());
            }
            println!("{nodes} nodes over {heights} scale heights: {most:.1e}");
            most
        };
        let [six, seven, nine] = [6.0, 7.0, 9.0].map(|heights| worst(8, heights));
        assert!(seven <= 9.2e-4 && six > seven && nine > seven, "{six} {seven} {nine}");
        assert!((0.03..=0.06).contains(&worst(4, 5.0)));
    }
}
