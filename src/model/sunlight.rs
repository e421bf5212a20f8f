//! What the air leaves of the sun's light.

use super::atmosphere::AtmosphereParams;
use super::quadrature::gauss_16;
use crate::error::{Result, in_range};

/// Irradiance by the sun on a plane that faces it, at an altitude (metres, ground level below 0) where its
/// centre stands at the given sine of elevation (-1 to 1): what the air leaves of
/// [`AtmosphereParams::sun_intensity`], 0 behind the planet. Within 0.1 %.
///
/// # Errors
/// [`crate::ErrorKind::Invalid`] from [`AtmosphereParams::validate`] and for inputs out of range.
pub fn sunlight(params: &AtmosphereParams, altitude: f64, sun_sine: f64) -> Result<[f64; 3]> {
    params.validate()?;
    in_range("sun_sine", sun_sine, -1.0, 1.0, "")?;
    in_range("altitude", altitude, -1e15, 1e15, "m")?;
    let h = altitude.max(0.0);
    let radius = params.planet_radius;
    // Sine of the horizon's dip: sqrt(r² - R²) / r.
    if sun_sine < -(h * (2.0 * radius + h)).sqrt() / (radius + h) {
        return Ok([0.0; 3]);
    }
    let [gas, aerosol, absorber] = columns_to_space(params, h, sun_sine);
    let extinction = params.mie_extinction();
    Ok(std::array::from_fn(|c| {
        let depth = params.rayleigh_scattering[c] * gas
            + extinction[c] * aerosol
            + params.ozone_absorption[c] * absorber;
        params.sun_intensity * (-depth).exp()
    }))
}

/// Densities of gas, aerosol and absorber integrated (metres) from an altitude `h >= 0` (metres) in a
/// direction with the given sine of elevation to the top of the air; the line meets no ground.
///
/// With `v² = altitude - altitude of the perigee` the way along the line is `s = v sqrt(v² + 2 r)`, r the
/// perigee's radius, an exponential density falls like `exp(-v² / H)` and the tent is a parabola: both are
/// smooth in v, so that a Gauss rule on the stretch where the density matters converges at once.
fn columns_to_space(p: &AtmosphereParams, h: f64, sine: f64) -> [f64; 3] {
    let r = p.planet_radius + h;
    let cosine = ((1.0 - sine) * (1.0 + sine)).max(0.0).sqrt();
    // The camera above the perigee, r - r cosine, without a difference.
    let above = r * sine * sine / (1.0 + cosine);
    let perigee = h - above;
    let span = p.thickness() - perigee;
    if span <= 0.0 || (sine >= 0.0 && above >= span) {
        return [0.0; 3];
    }
    let (here, top) = (above.min(span).sqrt(), span.sqrt());
    let side = |from: f64, to: f64| Side { perigee, radius: p.planet_radius + perigee, from, to }.columns(p);
    if sine >= 0.0 {
        return side(here, top);
    }
    // Down to the perigee and up again.
    let (down, up) = (side(0.0, here), side(0.0, top));
    std::array::from_fn(|i| down[i] + up[i])
}

/// One side of a line's perigee, between two values of v (square roots of metres).
struct Side {
    perigee: f64,
    radius: f64,
    from: f64,
    to: f64,
}

impl Side {
    fn integral(&self, from: f64, to: f64, density: impl Fn(f64) -> f64) -> f64 {
        let (from, to) = (from.max(self.from), to.min(self.to));
        if to <= from {
            return 0.0;
        }
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let sum = gauss_16().iter().map(|&(x, weight)| {
            let v = middle + half * x;
            let way = 2.0 * (self.radius + v * v) / (2.0 * self.radius + v * v).sqrt();
            weight * density(v) * way
        });
        half * sum.sum::<f64>()
    }

    fn columns(&self, p: &AtmosphereParams) -> [f64; 3] {
        let exponential = |height: f64| {
            let density = |v: f64| (-(self.perigee + v * v) / height).exp();
            // Six scale heights above the lowest point of this side, and from there thirty more.
            let reach = |heights: f64| (self.from * self.from + heights * height).sqrt();
            self.integral(self.from, reach(6.0), density) + self.integral(reach(6.0), reach(36.0), density)
        };
        let (center, width) = (p.ozone_center_altitude, p.ozone_half_width);
        let tent = |v: f64| (1.0 - (self.perigee + v * v - center).abs() / width).max(0.0);
        let at = |altitude: f64| (altitude - self.perigee).max(0.0).sqrt();
        let absorber = self.integral(at(center - width), at(center), tent)
            + self.integral(at(center), at(center + width), tent);
        [exponential(p.rayleigh_scale_height), exponential(p.mie_scale_height), absorber]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::single::{RayQuery, Tolerance, transmittance};

    #[test]
    fn it_is_what_the_reference_lets_through() {
        let thick = AtmosphereParams {
            mie_scale_height: 20.0,
            rayleigh_scale_height: 2e5,
            ..AtmosphereParams::venus()
        };
        for params in [AtmosphereParams::earth(), AtmosphereParams::mars(), AtmosphereParams::venus(), thick]
        {
            for altitude in [0.0, 1.7, 3e3, 2.4e4, 9e4, 4e5, 3.6e7] {
                for degrees in [90.0_f64, 30.0, 5.0, 0.3, 0.0, -0.3, -3.0, -20.0, -80.0] {
                    let sine = degrees.to_radians().sin();
                    let got = sunlight(&params, altitude, sine).unwrap();
                    let h: f64 = altitude;
                    let horizon = -(h * (2.0 * params.planet_radius + h)).sqrt() / (params.planet_radius + h);
                    if sine < horizon {
                        assert_eq!(got, [0.0; 3]);
                        continue;
                    }
                    let zenith = sine.acos();
                    let query = RayQuery::new(altitude, zenith, zenith, 0.0);
                    let expected = transmittance(&params, &query, Tolerance::PICTURE).unwrap();
                    for c in 0..3 {
                        let expected = expected[c] * params.sun_intensity;
                        let off = (got[c] - expected).abs();
                        assert!(
                            off <= 1e-3 * expected + 1e-12,
                            "{altitude} m, {degrees} deg, channel {c}: {} {expected}",
                            got[c]
                        );
                    }
                }
            }
        }
    }
}
