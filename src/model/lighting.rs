//! Light for a scene of one's own by constants: in space, on the ground and between, as an engine's shaders
//! want it.
//!
//! [`lighting_context_at_altitude`] blends a context of the ground into [`LightingContext::space`], and
//! [`modulate_ambient_by_sun`] dims it at night. By physics instead: [`crate::model::sunlight::sunlight`] and
//! [`crate::SkyLight`].

use glam::Vec3;

use crate::error::{Error, Result, in_range};

/// What a place does to light: how much comes from the sky, and how dark shadows are.
#[derive(Clone, Debug, PartialEq)]
pub struct LightingContext {
    /// Colour of the light from the sky; zero in space.
    pub ambient_color: Vec3,
    /// Multiplies it, 0 to 1.
    pub ambient_intensity: f32,
    /// Light in the darkest shadow as a share of that outside, 0 (black, in space) to 1 (no shadow).
    pub shadow_min_light: f32,
    /// 0 in space to 1 in all of the air.
    pub atmosphere_density: f32,
}

impl LightingContext {
    /// No air: no light but the sun's, and black shadows.
    pub fn space() -> Self {
        Self {
            ambient_color: Vec3::ZERO,
            ambient_intensity: 0.0,
            shadow_min_light: 0.0,
            atmosphere_density: 0.0,
        }
    }

    /// Constants for the ground of an Earth by day; its colour and strength are a matter of taste, not
    /// measured.
    pub fn earth_like_surface() -> Self {
        Self {
            ambient_color: Vec3::new(0.4, 0.5, 0.7),
            ambient_intensity: 0.15,
            shadow_min_light: 0.08,
            atmosphere_density: 1.0,
        }
    }
}

/// Between which altitudes the light of the ground turns into that of space. Metres above the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtmosphereConfig {
    /// Below it the ground's context holds unchanged. 0 to 1e9.
    pub atmosphere_start: f64,
    /// Above it there is none of it left. More than `atmosphere_start`, up to 1e9.
    pub atmosphere_end: f64,
}

impl Default for AtmosphereConfig {
    /// The Earth's: 10 km and 100 km.
    fn default() -> Self {
        Self { atmosphere_start: 10_000.0, atmosphere_end: 100_000.0 }
    }
}

impl AtmosphereConfig {
    /// Checks the ranges given at the fields.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for the first that is wrong.
    pub fn validate(&self) -> Result<()> {
        in_range("atmosphere_start", self.atmosphere_start, 0.0, 1e9, "m")?;
        in_range("atmosphere_end", self.atmosphere_end, 0.0, 1e9, "m")?;
        if self.atmosphere_end <= self.atmosphere_start {
            return Err(Error::invalid("atmosphere_end", self.atmosphere_end, "above atmosphere_start"));
        }
        Ok(())
    }
}

/// The context at an altitude (metres): the surface's below `atmosphere_start`, that of space above
/// `atmosphere_end`, and between them a smooth step. Any altitude gives a finite context; one that is no
/// number, that of space.
pub fn lighting_context_at_altitude(
    altitude: f64,
    config: &AtmosphereConfig,
    surface_context: &LightingContext,
) -> LightingContext {
    let AtmosphereConfig { atmosphere_start: start, atmosphere_end: end } = *config;
    if altitude <= start {
        return surface_context.clone();
    }
    if !(altitude < end && end > start) {
        return LightingContext::space();
    }
    let t = ((altitude - start) / (end - start)).clamp(0.0, 1.0) as f32;
    let left = 1.0 - t * t * (3.0 - 2.0 * t);
    LightingContext {
        ambient_color: surface_context.ambient_color * left,
        ambient_intensity: surface_context.ambient_intensity * left,
        shadow_min_light: surface_context.shadow_min_light * left,
        atmosphere_density: surface_context.atmosphere_density * left,
    }
}

/// Ambient light by the sine of the sun's elevation, -1 to 1: all of it from 0.25 up, a twentieth (stars,
/// moon) from -0.225 down.
pub fn modulate_ambient_by_sun(base_ambient: Vec3, sun_elevation: f32) -> Vec3 {
    base_ambient * (sun_elevation * 2.0 + 0.5).clamp(0.05, 1.0)
}
