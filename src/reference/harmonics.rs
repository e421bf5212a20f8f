//! Real spherical harmonics that are even in azimuth, and the moments of phase functions.
//!
//! Light in a spherical atmosphere is symmetric about the plane of zenith and sun, so `cos(m φ)` terms
//! suffice. With `Y_lm = N_lm P_l^m(μ) cos(m φ)` of unit norm, scattering multiplies the moment `L_lm` of
//! the radiance by the phase function's moment `χ_l` (addition theorem; Chandrasekhar 1960, section 48).

use std::f64::consts::PI;

use crate::model::atmosphere::MiePhase;

/// How many `(l, m)` there are with `0 ≤ m ≤ l ≤ degree`.
pub(crate) fn count(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// Place of `(l, m)` in a list ordered by m, then l.
pub(crate) fn index(degree: usize, l: usize, m: usize) -> usize {
    m * (degree + 1) - m * m.saturating_sub(1) / 2 + l - m
}

/// `N_lm P_l^m(mu)` for all `(l, m)` in the order of [`index`], so that `Y_lm` has unit norm over the sphere.
pub(crate) fn legendre(degree: usize, mu: f64, out: &mut Vec<f64>) {
    out.clear();
    out.resize(count(degree), 0.0);
    let sin = ((1.0 - mu) * (1.0 + mu)).max(0.0).sqrt();
    let mut diagonal = (1.0 / (4.0 * PI)).sqrt();
    for m in 0..=degree {
        let mf = m as f64;
        if m > 0 {
            diagonal *= sin * ((2.0 * mf + 1.0) / (2.0 * mf)).sqrt();
        }
        let (mut before, mut p) = (0.0, diagonal);
        let norm = if m > 0 { 2f64.sqrt() } else { 1.0 };
        for l in m..=degree {
            out[index(degree, l, m)] = norm * p;
            let next = (l + 1) as f64;
            let a = ((4.0 * next * next - 1.0) / (next * next - mf * mf)).sqrt();
            let b = (((next - 1.0).powi(2) - mf * mf) / (4.0 * (next - 1.0).powi(2) - 1.0)).max(0.0).sqrt();
            let b = if l == m { 0.0 } else { b };
            (before, p) = (p, a * (mu * p - b * before));
        }
    }
}

/// Moments `χ_l = ∫ p(μ) P_l(μ) 2π dμ` of the aerosol's phase function, l from 0 to `degree`.
pub(crate) fn mie_moments(kind: MiePhase, g: f64, degree: usize) -> Vec<f64> {
    let hg = |l: i64| if l < 0 { 0.0 } else { g.powi(l as i32) };
    // Moments of μ p: (2 l + 1) μ P_l = (l + 1) P_{l+1} + l P_{l-1}.
    let times_mu = |f: &dyn Fn(i64) -> f64, l: i64| {
        let lf = l as f64;
        ((lf + 1.0) * f(l + 1) + lf * f(l - 1)) / (2.0 * lf + 1.0)
    };
    (0..=degree as i64)
        .map(|l| match kind {
            MiePhase::HenyeyGreenstein => hg(l),
            MiePhase::CornetteShanks => {
                let once = |l: i64| if l < 0 { 0.0 } else { times_mu(&hg, l) };
                1.5 / (2.0 + g * g) * (hg(l) + times_mu(&once, l))
            }
        })
        .collect()
}

/// Moments of Rayleigh's phase function: 1, 0, 1/10, 0, …
pub(crate) fn rayleigh_moment(l: usize) -> f64 {
    match l {
        0 => 1.0,
        2 => 0.1,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::phase;
    use crate::model::quadrature::gauss_legendre;

    #[test]
    fn harmonics_are_orthonormal() {
        let degree = 9;
        let n = count(degree);
        let mut gram = vec![0.0; n * n];
        let mut p = Vec::new();
        let lm: Vec<(usize, usize)> = (0..=degree).flat_map(|m| (m..=degree).map(move |l| (l, m))).collect();
        for (mu, w) in gauss_legendre(12) {
            legendre(degree, mu, &mut p);
            for k in 0..24 {
                let azimuth = PI * (f64::from(k) + 0.5) / 24.0;
                for (i, &(_, mi)) in lm.iter().enumerate() {
                    for (j, &(_, mj)) in lm.iter().enumerate() {
                        let cos = (mi as f64 * azimuth).cos() * (mj as f64 * azimuth).cos();
                        gram[i * n + j] += w * 2.0 * PI / 24.0 * p[i] * p[j] * cos;
                    }
                }
            }
        }
        for (i, &(l, m)) in lm.iter().enumerate() {
            assert_eq!(index(degree, l, m), i);
            for j in 0..n {
                let exact = f64::from(u8::from(i == j));
                assert!(
                    (gram[i * n + j] - exact).abs() < 1e-12,
                    "{:?} {:?} {}",
                    lm[i],
                    lm[j],
                    gram[i * n + j]
                );
            }
        }
    }

    #[test]
    fn moments_are_those_of_the_phase_functions() {
        for kind in [MiePhase::HenyeyGreenstein, MiePhase::CornetteShanks] {
            for g in [-0.4, 0.0, 0.8] {
                let moments = mie_moments(kind, g, 8);
                for (l, moment) in moments.iter().enumerate() {
                    let integral: f64 = gauss_legendre(120)
                        .iter()
                        .map(|&(mu, w)| {
                            let (mut before, mut p) = (0.0, 1.0);
                            for k in 0..l {
                                let k = k as f64;
                                (before, p) = (p, ((2.0 * k + 1.0) * mu * p - k * before) / (k + 1.0));
                            }
                            2.0 * PI * w * p * phase::mie(kind, mu, g)
                        })
                        .sum();
                    assert!((integral - moment).abs() < 1e-10, "{kind:?} g {g} l {l}: {integral} {moment}");
                }
            }
        }
        let second: f64 = gauss_legendre(8)
            .iter()
            .map(|&(mu, w)| 2.0 * PI * w * phase::rayleigh(mu) * (1.5 * mu * mu - 0.5))
            .sum();
        assert!((second - rayleigh_moment(2)).abs() < 1e-14);
    }
}
