//! Sizes of the LUTs (lookup tables) and steps along the rays that fill them.

use crate::error::{Error, Result};

/// Sizes of the LUTs and steps along rays. All sides count texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LutSettings {
    /// Distances to the top and altitudes of the transmittance LUT, 8 to 1024 each.
    pub transmittance: [u32; 2],
    /// Sun angles and altitudes of the multi-scattering LUT, 8 to 256 each.
    pub multi_scattering: [u32; 2],
    /// Steps along the rays that fill the multi-scattering LUT, 4 to 256.
    pub multi_scattering_steps: u32,
    /// How often light is scattered again before the rest is left out, 1 to 64, in thin air; times 1 + the
    /// optical depth of scattering in thick air, up to 24.
    pub orders: u32,
    /// Azimuths in half a turn (the other half is the mirror image) and zenith angles of the sky-view LUT, 8
    /// to 1024 each.
    pub sky_view: [u32; 2],
    /// Steps along the rays that fill the sky-view LUT, 4 to 256.
    pub sky_view_steps: u32,
    /// Azimuths in half a turn, zenith angles and slices along the ray of the aerial LUT, 4 to 128 each.
    pub aerial: [u32; 3],
    /// Steps in each slice of the aerial LUT, 1 to 16.
    pub aerial_steps: u32,
}

impl Default for LutSettings {
    /// [`Self::MEDIUM`].
    fn default() -> Self {
        Self::MEDIUM
    }
}

impl LutSettings {
    /// The smallest there are: nobody looks at their content. For tests, and for making programs ahead.
    pub const TINY: Self = Self {
        transmittance: [8, 8],
        multi_scattering: [8, 8],
        multi_scattering_steps: 4,
        orders: 1,
        sky_view: [8, 8],
        sky_view_steps: 4,
        aerial: [4, 4, 4],
        aerial_steps: 1,
    };

    /// The least that keeps the sky within about a percent of [`Self::HIGH`] by day; coarse at the limb.
    pub const LOW: Self = Self {
        transmittance: [64, 32],
        multi_scattering: [40, 14],
        multi_scattering_steps: 12,
        orders: 6,
        sky_view: [48, 64],
        sky_view_steps: 16,
        aerial: [12, 24, 12],
        aerial_steps: 1,
    };

    /// For ordinary use. The sky-view LUT has 200 × 100 texels over the whole turn, half of which are
    /// mirrored.
    pub const MEDIUM: Self = Self {
        transmittance: [128, 64],
        multi_scattering: [40, 14],
        multi_scattering_steps: 12,
        orders: 6,
        sky_view: [100, 100],
        sky_view_steps: 32,
        aerial: [16, 32, 16],
        aerial_steps: 1,
    };

    /// Next to no sampling error: what is left is the model's.
    pub const HIGH: Self = Self {
        transmittance: [256, 64],
        multi_scattering: [56, 20],
        multi_scattering_steps: 16,
        orders: 10,
        sky_view: [200, 400],
        sky_view_steps: 64,
        aerial: [32, 64, 32],
        aerial_steps: 1,
    };

    /// Checks the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first field that is out of range.
    pub fn validate(&self) -> Result<()> {
        let check = |name: &str, v: u32, lo: u32, hi: u32| {
            let allowed = (lo..=hi).contains(&v);
            if allowed { Ok(()) } else { Err(Error::invalid(name, v, format_args!("from {lo} to {hi}"))) }
        };
        for v in self.transmittance {
            check("lut.transmittance", v, 8, 1024)?;
        }
        for v in self.multi_scattering {
            check("lut.multi_scattering", v, 8, 256)?;
        }
        for v in self.sky_view {
            check("lut.sky_view", v, 8, 1024)?;
        }
        for v in self.aerial {
            check("lut.aerial", v, 4, 128)?;
        }
        check("lut.multi_scattering_steps", self.multi_scattering_steps, 4, 256)?;
        check("lut.orders", self.orders, 1, 64)?;
        check("lut.sky_view_steps", self.sky_view_steps, 4, 256)?;
        check("lut.aerial_steps", self.aerial_steps, 1, 16)
    }

    /// Rows of the sky-view LUT and of the aerial LUT for rays that end on the ground.
    pub fn ground_rows(&self) -> [u32; 2] {
        [self.sky_view[1] * 2 / 5, self.aerial[1] / 2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_within_its_own_ranges() {
        for settings in [LutSettings::TINY, LutSettings::LOW, LutSettings::MEDIUM, LutSettings::HIGH] {
            settings.validate().unwrap();
        }
    }
}
