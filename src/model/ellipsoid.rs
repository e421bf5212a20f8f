//! Planets that are no spheres.

use glam::{DMat3, DVec3};

use crate::error::{Decimal, Error, Result, in_range};

/// The shape of a planet: an ellipsoid, around [`Scene::planet_center`](super::scene::Scene::planet_center).
///
/// The sky is that of a sphere in a frame that is stretched until the ellipsoid is one, of
/// [`AtmosphereParams::planet_radius`](super::atmosphere::AtmosphereParams::planet_radius). Straight lines
/// stay straight: horizon, limb and terminator are the ellipsoid's, from wherever they are seen, and no LUT
/// depends on where the camera is. What is not exact are angles between directions, and heights, which are
/// stretched with the rest: on WGS84 by at most 0.34 % (0.2° and a metre in 300).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Half axes along the columns of [`Self::axes`]. Metres, 1e2 to 1e9, the largest at most 1.25 times the
    /// smallest.
    pub radii: DVec3,
    /// Directions of the axes in the scene's frame of reference, one a column: of length 1, at right angles.
    pub axes: DMat3,
}

impl Ellipsoid {
    /// The Earth's of the World Geodetic System 1984 (NGA.STND.0036, 2014), in an earth-fixed frame: x to
    /// latitude and longitude 0, z to the north pole.
    pub const WGS84: Self =
        Self { radii: DVec3::new(6_378_137.0, 6_378_137.0, 6_356_752.314_245), axes: DMat3::IDENTITY };
    /// Mars' (IAU Working Group on Cartographic Coordinates, Archinal et al. 2018), in its own fixed frame.
    pub const MARS: Self =
        Self { radii: DVec3::new(3_396_190.0, 3_396_190.0, 3_376_200.0), axes: DMat3::IDENTITY };

    /// The same ellipsoid with its axes turned, as in a frame of reference that is level somewhere.
    pub fn turned(self, axes: DMat3) -> Self {
        Self { axes: axes * self.axes, ..self }
    }

    /// Checks both fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for half axes out of range, and for axes that do more than turn.
    pub fn validate(&self) -> Result<()> {
        for (axis, radius) in ["x", "y", "z"].iter().zip(self.radii.to_array()) {
            in_range(format_args!("ellipsoid.radii.{axis}"), radius, 1e2, 1e9, "m")?;
        }
        let flat = self.radii.max_element() / self.radii.min_element();
        if flat > 1.25 {
            let given = format_args!("{} times the smallest", Decimal(flat));
            return Err(Error::invalid("ellipsoid.radii's largest", given, "at most 1.25 times"));
        }
        let product = self.axes.transpose() * self.axes;
        let off = (product - DMat3::IDENTITY).to_cols_array();
        if !off.iter().all(|v| v.abs() < 1e-6) {
            let worst =
                off.into_iter().fold(0.0, |most: f64, v| if v.abs() <= most { most } else { v.abs() });
            return Err(Error::invalid(
                "ellipsoid.axes",
                format_args!("{} from it", Decimal(worst)),
                "columns of length 1 at right angles, within 1e-6",
            ));
        }
        Ok(())
    }

    /// Direction away from the ground, unit, in the scene's axes: at geodetic latitude and longitude,
    /// radians. Latitude is towards the third axis, longitude 0 along the first.
    pub fn up(&self, latitude: f64, longitude: f64) -> DVec3 {
        let (sin, cos) = latitude.sin_cos();
        self.axes * DVec3::new(cos * longitude.cos(), cos * longitude.sin(), sin)
    }

    /// The place at geodetic latitude and longitude (radians) and a height above the ellipsoid (metres):
    /// metres from its centre, in the scene's axes.
    pub fn position(&self, latitude: f64, longitude: f64, height: f64) -> DVec3 {
        let up = self.up(latitude, longitude);
        let own = self.axes.transpose() * up;
        let foot = self.radii * self.radii * own;
        self.axes * (foot / foot.dot(own).sqrt()) + up * height
    }

    /// Height of a place above the ellipsoid, below it negative: metres. The place: metres from the centre,
    /// in the scene's axes, not next to it.
    pub fn height(&self, place: DVec3) -> f64 {
        let own = self.axes.transpose() * place;
        let squares = self.radii * self.radii;
        // The foot is where own_i / (1 + t / r_i²) is on the ellipsoid; t by Newton's rule from outside,
        // where it falls evenly.
        let mut t = (own.length() - self.radii.min_element()) * self.radii.max_element();
        for _ in 0..12 {
            let at = self.radii * own / (squares + t);
            let slope = -2.0 * (at * at / (squares + t)).element_sum();
            t -= (at.length_squared() - 1.0) / slope;
        }
        let foot = squares * own / (squares + t);
        (own - foot).length().copysign(t)
    }

    /// From places around the centre to those of the frame in which the ellipsoid is a sphere of that radius
    /// (metres), in the same axes.
    pub(crate) fn to_sphere(self, radius: f64) -> DMat3 {
        self.axes * DMat3::from_diagonal(radius / self.radii) * self.axes.transpose()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_standard() {
        // NGA.STND.0036 has a² / b = 6399593.6258 m as the radius of curvature at the pole; 45° N by the
        // closed formula, N = a / sqrt(1 - e² / 2).
        let wgs84 = Ellipsoid::WGS84;
        let pole = wgs84.position(std::f64::consts::FRAC_PI_2, 0.0, 1000.0);
        assert!((pole - DVec3::Z * 6_357_752.314_245).length() < 1e-6, "{pole}");
        let e2 = 1.0 - (wgs84.radii.z / wgs84.radii.x).powi(2);
        let n = wgs84.radii.x / (1.0 - 0.5 * e2).sqrt();
        let half = 0.5_f64.sqrt();
        let want = DVec3::new(0.0, (n + 300.0) * half, (n * (1.0 - e2) + 300.0) * half);
        let got = wgs84.position(45.0_f64.to_radians(), 90.0_f64.to_radians(), 300.0);
        assert!((got - want).length() < 1e-6, "{got} {want}");
        let turn = DMat3::from_rotation_x(1.0);
        assert!(
            (wgs84.turned(turn).position(0.3, 0.7, 5.0) - turn * wgs84.position(0.3, 0.7, 5.0)).length()
                < 1e-6
        );
        for height in [-11e3, -1.0, 0.0, 2.0, 4e5, 3.6e7, 1e9] {
            for latitude in [-1.5, -0.4, 0.0, 0.8, 1.57] {
                let got = wgs84.turned(turn).height(wgs84.turned(turn).position(latitude, 1.0, height));
                assert!((got - height).abs() < 1e-3, "{height}: {got}");
            }
        }
        // What is on the ellipsoid is on the sphere.
        let sphere = Ellipsoid::WGS84.turned(turn).to_sphere(6.36e6);
        for latitude in [-1.4, -0.5, 0.0, 0.2, 1.0] {
            let place = sphere * wgs84.turned(turn).position(latitude, 2.0, 0.0);
            assert!((place.length() - 6.36e6).abs() < 1e-6);
        }
    }

    #[test]
    fn what_is_no_ellipsoid_is_refused() {
        let bad = |radii, axes| Ellipsoid { radii, axes }.validate().unwrap_err().to_string();
        let (round, unit) = (DVec3::splat(6e6), DMat3::IDENTITY);
        assert!(Ellipsoid::WGS84.validate().is_ok() && Ellipsoid::MARS.validate().is_ok());
        assert!(bad(DVec3::new(6e6, f64::NAN, 6e6), unit).contains("ellipsoid.radii.y"));
        assert!(bad(DVec3::new(6e6, 6e6, 4e6), unit).contains("at most 1.25"));
        assert!(bad(round, unit * 2.0).contains("ellipsoid.axes"));
        assert!(bad(round, DMat3::NAN).contains("ellipsoid.axes"));
    }
}
