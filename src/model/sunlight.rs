//! What the air leaves of the sun's light.

use super::atmosphere::AtmosphereParams;
use super::quadrature::gauss_16;
use crate::error::{Result, in_range};

/// Irradiance by the sun on a plane that faces it, at an altitude (metres; the lowest ground below it) where
/// its centre stands at the given sine of elevation (-1 to 1): what the air leaves of
/// [`AtmosphereParams::sun_intensity`], within 0.1 %, times the part of the sun's disk that the planet does
/// not hide. A sun whose centre is below the horizon is seen through the air as if it were on it.
///
/// # Errors
/// [`crate::ErrorKind::Invalid`] from [`AtmosphereParams::validate`] and for inputs out of range.
pub fn sunlight(params: &AtmosphereParams, altitude: f64, sun_sine: f64) -> Result<[f64; 3]> {
    params.validate()?;
    in_range("sun_sine", sun_sine, -1.0, 1.0, "")?;
    in_range("altitude", altitude, -1e15, 1e15, "m")?;
    let altitude = altitude.max(params.lowest_ground);
    let (h, radius) = (altitude - params.lowest_ground, params.ground_radius());
    // Sine of the horizon's dip: sqrt(r² - R²) / r.
    let dip = (h * (2.0 * radius + h)).sqrt() / (radius + h);
    let visible = disk_above((sun_sine.asin() + dip.asin()) / params.sun_angular_radius);
    if visible == 0.0 {
        return Ok([0.0; 3]);
    }
    let [gas, aerosol, absorber] = columns_to_space(params, altitude, sun_sine.max(-dip));
    let extinction = params.mie_extinction();
    Ok(std::array::from_fn(|c| {
        let depth = params.rayleigh_scattering[c] * gas
            + extinction[c] * aerosol
            + params.ozone_absorption[c] * absorber;
        params.sun_intensity * visible * (-depth).exp()
    }))
}

/// The part of a disk above a straight line, 0 to 1: the segment of a circle. height: of the disk's centre
/// above the line, in radii.
fn disk_above(height: f64) -> f64 {
    let h = height.clamp(-1.0, 1.0);
    // Of the smaller part, so that a sliver keeps its digits: (acos h - h sqrt(1 - h²)) / π.
    let root = ((1.0 - h) * (1.0 + h)).sqrt();
    let part = |h: f64| (root.atan2(h) - h * root) / std::f64::consts::PI;
    if h < 0.0 { part(-h) } else { 1.0 - part(h) }
}

/// Densities of gas, aerosol and absorber integrated (metres) from an altitude `h` (metres) in a
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
    let span = p.top_altitude() - perigee;
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
        let at = |altitude: f64| (altitude - self.perigee).max(0.0).sqrt();
        // Below altitude 0 densities are even.
        let even = self.integral(0.0, at(0.0), |_| 1.0);
        let exponential = |height: f64| {
            let density = |v: f64| (-(self.perigee + v * v) / height).exp();
            // Six scale heights above the lowest point of this side that is not below altitude 0, and from
            // there thirty more.
            let from = self.from.max(at(0.0));
            let reach = |heights: f64| (from * from + heights * height).sqrt();
            even + self.integral(from, reach(6.0), density) + self.integral(reach(6.0), reach(36.0), density)
        };
        let (center, width) = (p.ozone_center_altitude, p.ozone_half_width);
        let tent = |v: f64| (1.0 - (self.perigee + v * v - center).abs() / width).max(0.0);
        let absorber = even * p.densities(0.0)[2]
            + self.integral(at(0.0).max(at(center - width)), at(center), tent)
            + self.integral(at(center), at(center + width), tent);
        [exponential(p.rayleigh_scale_height), exponential(p.mie_scale_height), absorber]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::single::{RayQuery, Tolerance, transmittance};

    /// The part of a disk above a line by thin strips.
    fn strips_above(height: f64) -> f64 {
        const STRIPS: usize = 20_000;
        let strips = (0..STRIPS).map(|i| (2 * i + 1) as f64 / STRIPS as f64 - 1.0);
        let width = |y: f64| (1.0 - y * y).sqrt();
        strips.clone().filter(|y| y + height > 0.0).map(width).sum::<f64>() / strips.map(width).sum::<f64>()
    }

    /// An Earth with a trench.
    fn trench() -> AtmosphereParams {
        AtmosphereParams { lowest_ground: -10.9e3, ..AtmosphereParams::earth() }
    }

    #[test]
    fn a_disk_sinks_below_a_line_bit_by_bit() {
        for (height, part) in [(-1.5, 0.0), (-1.0, 0.0), (0.0, 0.5), (1.0, 1.0), (1.5, 1.0)] {
            assert!((disk_above(height) - part).abs() < 1e-15, "{height}");
        }
        for i in 0..=200 {
            let height = i as f64 / 100.0 - 1.0;
            assert!((disk_above(height) - strips_above(height)).abs() < 1e-4, "{height}");
        }
        // A sliver: the segment's area is (2 t)^(3/2) 2 / (3 π) of the circle's for a height t.
        let sliver = disk_above(-1.0 + 1e-6) / (2e-6_f64.powf(1.5) * 2.0 / (3.0 * std::f64::consts::PI));
        assert!((sliver - 1.0).abs() < 1e-3, "{sliver}");
    }

    /// At sunset nothing jumps: not at the horizon, where all of the light once went out, nor at the disk's
    /// ends.
    #[test]
    fn light_falls_with_the_visible_part_of_the_disk() {
        for params in [AtmosphereParams::earth(), AtmosphereParams::mars(), trench()] {
            for altitude in [params.lowest_ground, 0.0, 3e3, 4e5] {
                let r = params.planet_radius;
                let horizon = -(params.ground_radius() / (r + altitude)).acos();
                let at = |radii: f64| {
                    let sine = (horizon + radii * params.sun_angular_radius).sin();
                    sunlight(&params, altitude, sine).unwrap()[0]
                };
                let full = at(1.0);
                let steps: Vec<f64> = (0..=2400).map(|i| at(i as f64 / 1000.0 - 1.2)).collect();
                for pair in steps.windows(2) {
                    assert!(pair[1] >= pair[0], "{altitude}: {pair:?} falls");
                    // A step of a thousandth of the radius. From 400 km that lowers the ray by 10 m at the
                    // ground: a hundredth of the aerosol's scale height.
                    // Over a trench all of the disk is seen where rays graze altitude 0: 1.3 %, by optical
                    // depths of 0.97 of aerosol and 3.3 of gas that grow by 10.7 m over their scale heights.
                    let most = if params.lowest_ground < 0.0 { 1.3e-2 } else { 1e-2 };
                    assert!(pair[1] - pair[0] <= most * full.max(pair[1]), "{altitude}: {pair:?} of {full}");
                }
                assert_eq!((steps[0], steps[199]), (0.0, 0.0));
                assert!((at(-1e-9) - at(1e-9)).abs() <= 1e-6 * at(1e-9), "{altitude}: a step at the horizon");
            }
        }
    }

    #[test]
    fn it_is_what_the_reference_lets_through() {
        let thick = AtmosphereParams {
            mie_scale_height: 20.0,
            rayleigh_scale_height: 2e5,
            ..AtmosphereParams::venus()
        };
        for params in
            [AtmosphereParams::earth(), AtmosphereParams::mars(), AtmosphereParams::venus(), thick, trench()]
        {
            for altitude in [params.lowest_ground, -430.0, 0.0, 1.7, 3e3, 2.4e4, 9e4, 4e5, 3.6e7] {
                for degrees in [90.0_f64, 30.0, 5.0, 0.3, 0.0, -0.3, -3.0, -20.0, -80.0] {
                    let sine = degrees.to_radians().sin();
                    let got = sunlight(&params, altitude, sine).unwrap();
                    let h = (altitude - params.lowest_ground).max(0.0);
                    let horizon =
                        -(h * (2.0 * params.ground_radius() + h)).sqrt() / (params.ground_radius() + h);
                    let above = (sine.asin() - horizon.asin()) / params.sun_angular_radius;
                    if above <= -1.0 {
                        assert_eq!(got, [0.0; 3]);
                        continue;
                    }
                    let visible = strips_above(above);
                    // Just above the horizon, so that rounding does not end the ray on the ground.
                    let zenith = sine.max(horizon + 1e-7).acos();
                    let query = RayQuery::new(altitude, zenith, zenith, 0.0);
                    let expected = transmittance(&params, &query, Tolerance::PICTURE).unwrap();
                    for c in 0..3 {
                        let expected = expected[c] * params.sun_intensity * visible;
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
