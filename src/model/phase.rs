//! Phase functions: the share of scattered light per steradian, by the angle between the directions
//! of flight before and after. Each integrates to 1 over the sphere. Unit 1/sr.

use std::f64::consts::PI;

use crate::model::atmosphere::MiePhase;

/// Rayleigh: `3 / (16 π) (1 + μ²)`, μ the cosine of the scattering angle.
pub fn rayleigh(mu: f64) -> f64 {
    3.0 / (16.0 * PI) * (1.0 + mu * mu)
}

/// Henyey & Greenstein 1941, eq. 2: asymmetry `g`, -1 < g < 1.
///
/// `1 + g² - 2 g μ` is written `(1 - g)² + 2 g (1 - μ)`, which keeps its digits where g and μ are near 1.
pub fn henyey_greenstein(mu: f64, g: f64) -> f64 {
    let base = (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - mu);
    (1.0 - g * g) / (4.0 * PI * base * base.sqrt())
}

/// Cornette & Shanks 1992, eq. 8: Henyey–Greenstein times a Rayleigh-like `1 + μ²`, renormalised.
pub fn cornette_shanks(mu: f64, g: f64) -> f64 {
    1.5 * (1.0 + mu * mu) / (2.0 + g * g) * henyey_greenstein(mu, g)
}

/// The aerosol phase function that the parameters ask for.
pub fn mie(kind: MiePhase, mu: f64, g: f64) -> f64 {
    match kind {
        MiePhase::HenyeyGreenstein => henyey_greenstein(mu, g),
        MiePhase::CornetteShanks => cornette_shanks(mu, g),
    }
}

/// Cosine of a scattering angle drawn from [`henyey_greenstein`] by inverting its distribution;
/// `u` is uniform in [0, 1). (Witt 1977, eq. 19; the isotropic limit is taken below |g| = 1e-3.)
pub fn sample_hg(g: f64, u: f64) -> f64 {
    if g.abs() < 1e-3 {
        return 1.0 - 2.0 * u;
    }
    let s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
    ((1.0 + g * g - s * s) / (2.0 * g)).clamp(-1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral over the sphere by Gauss–Legendre-free means: midpoint in the angle with sin weight.
    fn sphere(f: impl Fn(f64) -> f64) -> f64 {
        let n = 200_000;
        (0..n)
            .map(|i| {
                let a = PI * (f64::from(i) + 0.5) / f64::from(n);
                f(a.cos()) * a.sin() * 2.0 * PI * PI / f64::from(n)
            })
            .sum()
    }

    #[test]
    fn phase_functions_integrate_to_one() {
        assert!((sphere(rayleigh) - 1.0).abs() < 1e-8);
        for g in [-0.999, -0.5, 0.0, 0.5, 0.758, 0.8, 0.999] {
            assert!((sphere(|mu| henyey_greenstein(mu, g)) - 1.0).abs() < 1e-4, "HG {g}");
            assert!((sphere(|mu| cornette_shanks(mu, g)) - 1.0).abs() < 1e-4, "CS {g}");
        }
    }

    #[test]
    fn hg_samples_follow_their_density() {
        for g in [-0.7, 0.0, 0.0005, 0.3, 0.8] {
            let (bins, n) = (40, 400_000_u32);
            let mut histogram = vec![0.0; bins];
            for i in 0..n {
                let mu = sample_hg(g, (f64::from(i) + 0.5) / f64::from(n));
                let bin = (((mu + 1.0) * 0.5 * bins as f64) as usize).min(bins - 1);
                histogram[bin] += 1.0 / f64::from(n);
            }
            for (bin, &got) in histogram.iter().enumerate() {
                // The bin's probability, by a fine midpoint rule.
                let want: f64 = (0..200)
                    .map(|k| {
                        let mu = -1.0 + 2.0 * (bin as f64 + (f64::from(k) + 0.5) / 200.0) / bins as f64;
                        henyey_greenstein(mu, g) * 2.0 * PI * 2.0 / bins as f64 / 200.0
                    })
                    .sum();
                assert!((got - want).abs() < 1e-3 * want + 2e-5, "g {g} bin {bin}: {got} {want}");
            }
        }
    }
}
