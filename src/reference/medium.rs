//! Column densities of the three constituents along straight lines.

use super::geometry::Chord;
use crate::model::atmosphere::AtmosphereParams;
use crate::model::phase;
use crate::model::quadrature::{gauss_4, gauss_6, gauss_10, gauss_16};

/// How well a column is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColumnRule {
    /// About 1e-6 of the column.
    Quick,
    /// About 1e-11 of the column.
    Precise,
}

/// The parameters in the form that integrals need: told from the lowest ground, so that all altitudes in this
/// module and its users are heights above it.
#[derive(Clone, Debug)]
pub(crate) struct Medium {
    /// As the user gave them.
    pub params: AtmosphereParams,
    /// The same planet, its radius that of the lowest ground.
    pub from_ground: AtmosphereParams,
    /// Altitude 0 above the lowest ground, metres. Below it densities are even.
    datum: f64,
    /// Height of the top, metres.
    pub top: f64,
    pub mie_extinction: [f64; 3],
    scatters_gas: bool,
    has_aerosol: bool,
    has_ozone: bool,
}

impl Medium {
    pub fn new(params: &AtmosphereParams) -> Self {
        let mie_extinction = params.mie_extinction();
        Self {
            top: params.thickness(),
            mie_extinction,
            scatters_gas: params.rayleigh_scattering.iter().any(|&v| v > 0.0),
            has_aerosol: mie_extinction.iter().any(|&v| v > 0.0),
            has_ozone: params.ozone_absorption.iter().any(|&v| v > 0.0),
            params: params.clone(),
            from_ground: AtmosphereParams {
                planet_radius: params.ground_radius(),
                lowest_ground: 0.0,
                ..params.clone()
            },
            datum: -params.lowest_ground,
        }
    }

    /// Densities of gas, aerosol and absorber at a height.
    pub fn densities(&self, height: f64) -> [f64; 3] {
        self.params.densities(height - self.datum)
    }

    /// Extinction coefficient at a height, 1/m.
    pub fn extinction(&self, height: f64) -> [f64; 3] {
        self.params.extinction(height - self.datum)
    }

    /// Optical depth of each channel for columns (metres of density 1) of gas, aerosol, ozone.
    pub fn optical_depth(&self, columns: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|c| {
            self.from_ground.rayleigh_scattering[c] * columns[0]
                + self.mie_extinction[c] * columns[1]
                + self.from_ground.ozone_absorption[c] * columns[2]
        })
    }

    /// Scattering coefficient times phase function at an altitude, 1/(m sr), per channel.
    /// `phase` holds the gas's and the aerosol's phase functions for the scattering angle.
    pub fn scattering(&self, altitude: f64, phase: &Phases) -> [f64; 3] {
        let h = (altitude - self.datum).max(0.0);
        let gas = if self.scatters_gas {
            (-h / self.from_ground.rayleigh_scale_height).exp() * phase.gas
        } else {
            0.0
        };
        let aerosol = if self.has_aerosol { (-h / self.from_ground.mie_scale_height).exp() } else { 0.0 };
        std::array::from_fn(|c| {
            self.from_ground.rayleigh_scattering[c] * gas
                + self.from_ground.mie_scattering[c] * aerosol * phase.aerosol[c]
        })
    }

    /// Both phase functions for a cosine of the scattering angle.
    pub fn phases(&self, cos: f64) -> Phases {
        let cos = cos.clamp(-1.0, 1.0);
        Phases {
            gas: phase::rayleigh(cos),
            aerosol: self.from_ground.mie_asymmetry.map(|g| phase::mie(self.from_ground.mie_phase, cos, g)),
        }
    }

    /// Heights at which the density profiles have a kink.
    pub fn kinks(&self) -> [f64; 4] {
        let (c, w) = (self.from_ground.ozone_center_altitude + self.datum, self.from_ground.ozone_half_width);
        let [foot, tip, end] = if self.has_ozone { [c - w, c, c + w] } else { [-1.0; 3] };
        [foot, tip, end, self.datum]
    }

    /// Columns of gas, aerosol and ozone (metres of density 1) along a line from `s0` to `s1 ≥ s0` metres
    /// after its perigee. Both ends must lie within the shell.
    pub fn columns(&self, chord: &Chord, s0: f64, s1: f64, rule: ColumnRule) -> [f64; 3] {
        let (v0, v1) = (chord.v_at(s0), chord.v_at(s1));
        if v0 >= 0.0 {
            self.side(chord, v0, v1, rule)
        } else if v1 <= 0.0 {
            self.side(chord, -v1, -v0, rule)
        } else {
            let (a, b) = (self.side(chord, 0.0, -v0, rule), self.side(chord, 0.0, v1, rule));
            [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
        }
    }

    /// Columns on one side of the perigee, 0 ≤ va ≤ vb.
    ///
    /// With `v² = h - h_perigee` an exponential density is `exp(-(v² - va²) / H)` and `ds/dv` hardly varies,
    /// so a Gauss–Legendre rule on the stretch where the density matters converges at once.
    fn side(&self, chord: &Chord, va: f64, vb: f64, rule: ColumnRule) -> [f64; 3] {
        if vb <= va {
            return [0.0; 3];
        }
        // Below the datum there is as much of each as of the way, times the density there.
        let level = (self.datum - chord.perigee_altitude).max(0.0).sqrt();
        let even = if va < level { chord.at_v(level.min(vb)).0 - chord.at_v(va).0 } else { 0.0 };
        let [_, _, absorber] = self.params.densities(0.0);
        let below = [even, even, even * absorber];
        let va = va.max(level);
        if vb <= va {
            return below;
        }
        let low = (chord.perigee_altitude + va * va - self.datum).max(0.0);
        let exponential = |scale_height: f64| {
            let n = -1.0 / scale_height;
            let reach = |x: f64| (va * va + x * scale_height).sqrt();
            let f = |v: f64| ((v - va) * (v + va) * n).exp() * chord.at_v(v).1;
            let sum = match rule {
                ColumnRule::Quick => {
                    let (middle, end) = (reach(5.0).min(vb), reach(15.0).min(vb));
                    apply(gauss_6(), va, middle, f) + apply(gauss_6(), middle, end, f)
                }
                ColumnRule::Precise => {
                    let (middle, end) = (reach(6.0).min(vb), reach(34.0).min(vb));
                    apply(gauss_10(), va, middle, f) + apply(gauss_16(), middle, end, f)
                }
            };
            sum * (low * n).exp()
        };
        let p = &self.from_ground;
        let gas = if self.scatters_gas { exponential(p.rayleigh_scale_height) } else { 0.0 };
        let aerosol = match self.has_aerosol {
            false => 0.0,
            true if self.scatters_gas && p.mie_scale_height == p.rayleigh_scale_height => gas,
            true => exponential(p.mie_scale_height),
        };
        let mut ozone = 0.0;
        if self.has_ozone {
            let [foot, tip, end, _] = self.kinks();
            let f = |v: f64| {
                let h = chord.perigee_altitude + v * v;
                (1.0 - (h - tip).abs() / p.ozone_half_width).max(0.0) * chord.at_v(v).1
            };
            let [bottom, middle, top] =
                [foot, tip, end].map(|h| (h - chord.perigee_altitude).max(0.0).sqrt());
            for (a, b) in [(bottom, middle), (middle, top)] {
                let (a, b) = (a.max(va), b.min(vb));
                if b > a {
                    ozone += match rule {
                        ColumnRule::Quick => apply(gauss_4(), a, b, f),
                        ColumnRule::Precise => apply(gauss_16(), a, b, f),
                    };
                }
            }
        }
        [gas + below[0], aerosol + below[1], ozone + below[2]]
    }

    /// Columns from a point towards the sun, up to the top; `None` where the planet is in the way.
    pub fn columns_to_sun(&self, point: &Chord, rule: ColumnRule) -> Option<[f64; 3]> {
        if point.perigee_altitude < 0.0 && point.origin < 0.0 {
            return None;
        }
        let s_top = point.at_altitude(self.top).unwrap_or(0.0);
        Some(self.columns(point, point.origin, s_top.max(point.origin), rule))
    }
}

/// Phase functions of gas and aerosol for one scattering angle, 1/sr.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phases {
    pub gas: f64,
    pub aerosol: [f64; 3],
}

fn apply<const N: usize>(rule: &[(f64, f64); N], a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    if b <= a {
        return 0.0;
    }
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    rule.iter().map(|&(x, w)| w * f(middle + half * x)).sum::<f64>() * half
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::quadrature::integrate;

    /// Columns against an adaptive integral in plain path length, for shapes far from Earth's.
    #[test]
    fn columns_agree_with_plain_adaptive_integration() {
        let mut tiny = AtmosphereParams::earth();
        tiny.planet_radius = 1000.0;
        tiny.atmosphere_radius = 3000.0;
        tiny.rayleigh_scale_height = 300.0;
        tiny.mie_scale_height = 1.0;
        tiny.ozone_center_altitude = 800.0;
        tiny.ozone_half_width = 500.0;
        let mut flat = AtmosphereParams::earth();
        flat.planet_radius = 1e8;
        flat.atmosphere_radius = 1e8 + 1000.0;
        let deep =
            AtmosphereParams { lowest_ground: -5e3, ozone_center_altitude: 1e3, ..AtmosphereParams::earth() };
        for params in [AtmosphereParams::earth(), AtmosphereParams::mars(), tiny, flat, deep] {
            let params = AtmosphereParams { ozone_absorption: [1e-6; 3], ..params };
            let medium = Medium::new(&params);
            for altitude in [0.0, 0.001, 0.3, 0.9].map(|f| f * medium.top) {
                for angle in [0.0, 0.5, 1.4, 1.5607963, 1.57, 1.580796] {
                    let chord = Chord::new(
                        medium.from_ground.planet_radius,
                        altitude,
                        f64::cos(angle),
                        f64::sin(angle),
                    );
                    let Some((s0, s1, _)) = chord.clip(medium.top, f64::INFINITY) else { continue };
                    let mut breaks = vec![s0, s1, 0.0f64.clamp(s0, s1)];
                    for h in
                        [1e-3, 1e-2, 3e-2, 0.1, 0.3].map(|f| f * medium.top).iter().chain(&medium.kinks())
                    {
                        if let Some(s) = chord.at_altitude(*h) {
                            breaks.extend([s.clamp(s0, s1), (-s).clamp(s0, s1)]);
                        }
                    }
                    breaks.sort_by(f64::total_cmp);
                    let plain =
                        integrate(|s| medium.densities(chord.altitude(s)), &breaks, 1e-12, 1e-12, 4000);
                    for (rule, tolerance) in [(ColumnRule::Precise, 1e-9), (ColumnRule::Quick, 5e-6)] {
                        let columns = medium.columns(&chord, s0, s1, rule);
                        for c in 0..3 {
                            let difference = (columns[c] - plain.value[c]).abs();
                            assert!(
                                difference <= tolerance * plain.value[c] + 1e-9,
                                "{rule:?} R {} h {altitude} angle {angle} constituent {c}: {} {}",
                                params.planet_radius,
                                columns[c],
                                plain.value[c]
                            );
                        }
                    }
                }
            }
        }
    }
}
