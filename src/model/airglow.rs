//! The night sky's own light: a thin layer of air that shines by itself.

use crate::error::{Result, in_range};

/// A layer that emits light alike in all directions; its density is a tent. It lies above nearly all air:
/// what stands between it and the camera is the air of the sky's passes, never the layer's own.
///
/// It is some 1e9 times fainter than the sky by day: it shows in exposures of 1e5 and more. Into a target of
/// halves draw with a multiple of [`AtmosphereParams::sun_intensity`](crate::AtmosphereParams), which it
/// follows, up to 1e6, and leave the rest of the exposure to your tone mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airglow {
    /// Radiance of the layer seen from straight below, as a fraction of the sun's irradiance above the air,
    /// 1/sr, per channel, 0 to 1.
    pub zenith: [f64; 3],
    /// Altitude of the layer's middle, metres, 1 to 1e7.
    pub altitude: f64,
    /// Distance from the middle at which it has thinned to nothing, metres, 1 to 1e7, less than
    /// [`Self::altitude`].
    pub half_width: f64,
}

/// Luminance of a clear, moonless sky at the zenith far from cities, cd/m²: 22 magnitudes per square arc
/// second, which by 10.8e4 × 10^(-0.4 m) cd/m² (Garstang 1986, PASP 98, 364) are 1.7e-4.
const NIGHT_ZENITH: f64 = 1.7e-4;

/// Illuminance by the sun above the Earth's air, lx: the solar constant of 1361 W/m² (Kopp & Lean 2011) at
/// the 98 lm/W of the spectrum outside the air (Darula, Kittler & Gueymard 2005), about 1.33e5.
const SUN_ILLUMINANCE: f64 = 1.33e5;

impl Airglow {
    /// The Earth's: 90 km ± 10 km, as bright as a natural night sky, without a colour of its own.
    pub const EARTH: Self =
        Self { zenith: [NIGHT_ZENITH / SUN_ILLUMINANCE; 3], altitude: 90_000.0, half_width: 10_000.0 };

    /// Checks the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        for (c, v) in self.zenith.iter().enumerate() {
            in_range(format_args!("airglow.zenith[{c}]"), *v, 0.0, 1.0, "/sr")?;
        }
        in_range("airglow.altitude", self.altitude, 1.0, 1e7, "m")?;
        in_range("airglow.half_width", self.half_width, 1.0, (0.999 * self.altitude).max(1.0), "m")?;
        Ok(())
    }

    /// Factor by which a ray that leaves a ground observer at a zenith angle (its cosine) sees more of a thin
    /// layer than the vertical one: van Rhijn 1921, `1 / sqrt(1 - (R sin z / (R + h))²)`.
    pub fn van_rhijn(&self, planet_radius: f64, cosine: f64) -> f64 {
        let ratio = planet_radius / (planet_radius + self.altitude);
        1.0 / (1.0 - ratio * ratio * (1.0 - cosine * cosine)).max(0.0).sqrt()
    }
}
