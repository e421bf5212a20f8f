//! Where the camera, the planet and the sun are, in f64 metres and any frame; and what the GPU gets
//! of it: camera-relative kilometres in f32, in the camera's own zenith frame.
//!
//! The **zenith frame** has its z axis from the planet's centre to the camera and the sun in its
//! x–z half plane (x ≥ 0). Everything the shaders see is expressed in it, so moving the planet or
//! rotating the world changes nothing but the last bits of f64. A ray's horizontal part, which decides
//! where it passes the planet, is computed in f64 and never as a difference on the GPU.

use glam::{DMat3, DVec2, DVec3};

use crate::error::{Decimal, Error, Result, Vector, direction, in_range};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::ellipsoid::Ellipsoid;
use crate::model::moon::Moon;

/// A pinhole camera. Metres and radians, in any right-handed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it is, metres, |component| ≤ 1e15. Its distance to [`Scene::planet_center`] is known to the
    /// spacing of f64 at the larger of both: 1e-4 m at 1e12 m, 0.1 m at 1e15 m.
    pub position: DVec3,
    /// Where it looks; any length but zero.
    pub forward: DVec3,
    /// Which way is up in the picture; not parallel to `forward`.
    pub up: DVec3,
    /// Tangents of the angles from `forward` to the picture's left, right, bottom and top edge.
    /// A symmetric camera has `left = -right`. -1e4 to 1e4, `left < right`, `bottom < top`.
    pub tangents: Tangents,
}

/// Extent of the picture on the plane at distance 1 in front of the camera; see [`Camera::tangents`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Tangents {
    pub left: f64,
    pub right: f64,
    pub bottom: f64,
    pub top: f64,
}

impl Tangents {
    /// A symmetric picture: vertical field of view in radians, and width / height.
    pub fn symmetric(fov_y: f64, aspect: f64) -> Self {
        let top = (0.5 * fov_y).tan();
        Self { left: -top * aspect, right: top * aspect, bottom: -top, top }
    }
}

/// A direction on the camera's plane at distance 1, per picture position; see [`Camera::basis`].
#[derive(Clone, Copy, Debug)]
pub struct RayBasis {
    /// Through the middle of the picture.
    pub forward: DVec3,
    /// Added from the middle to the right edge.
    pub right: DVec3,
    /// Added from the middle to the top edge.
    pub up: DVec3,
}

impl RayBasis {
    /// The ray through `x, y` in -1..1 (right and up positive); its component along the camera's axis is 1.
    pub fn ray(&self, ndc: DVec2) -> DVec3 {
        self.forward + self.right * ndc.x + self.up * ndc.y
    }
}

impl Camera {
    /// A symmetric camera; `fov_y` is the vertical field of view in radians.
    pub fn new(position: DVec3, forward: DVec3, up: DVec3, fov_y: f64, aspect: f64) -> Self {
        Self { position, forward, up, tangents: Tangents::symmetric(fov_y, aspect) }
    }

    /// A camera above a planet. `heading` turns from `north` towards east, `pitch` is 0 at the
    /// horizontal and positive upwards; radians. `zenith` is the direction from the planet's centre.
    pub fn above(
        planet_center: DVec3,
        radius: f64,
        zenith: DVec3,
        north: DVec3,
        pose: Pose,
        aspect: f64,
    ) -> Result<Self> {
        use std::f64::consts::{FRAC_PI_2, PI};
        in_range("pose.fov_y", pose.fov_y, 1e-9, PI - 1e-4, "radians")?;
        in_range("pose.pitch", pose.pitch, -FRAC_PI_2, FRAC_PI_2, "radians")?;
        let up = direction("zenith", zenith)?;
        let east = direction("north (must not be parallel to zenith)", north.cross(up))?;
        let north = up.cross(east);
        let flat = north * pose.heading.cos() + east * pose.heading.sin();
        let forward = flat * pose.pitch.cos() + up * pose.pitch.sin();
        let head = up * pose.pitch.cos() - flat * pose.pitch.sin();
        Ok(Self::new(planet_center + up * (radius + pose.altitude), forward, head, pose.fov_y, aspect))
    }

    /// The camera's rays, by rotation and projection alone.
    pub fn basis(&self) -> Result<RayBasis> {
        let forward = direction("camera.forward", self.forward)?;
        let up = direction("camera.up", self.up)?;
        let right = forward.cross(up);
        if right.length() < 1e-6 {
            return Err(Error::invalid(
                "camera.up",
                Vector(self.up),
                "a direction that is not parallel to camera.forward",
            ));
        }
        let right = right.normalize();
        let up = right.cross(forward);
        let t = &self.tangents;
        for (name, v) in [("left", t.left), ("right", t.right), ("bottom", t.bottom), ("top", t.top)] {
            in_range(format_args!("camera.tangents.{name}"), v, -1e4, 1e4, "(less than 180° of view)")?;
        }
        if t.right - t.left < 1e-9 || t.top - t.bottom < 1e-9 {
            return Err(Error::invalid(
                "camera.tangents",
                format_args!(
                    "Tangents {{ left: {}, right: {}, bottom: {}, top: {} }}",
                    Decimal(t.left),
                    Decimal(t.right),
                    Decimal(t.bottom),
                    Decimal(t.top)
                ),
                "left < right and bottom < top, by at least 1e-9; a field of view is in radians",
            ));
        }
        Ok(RayBasis {
            forward: forward + right * (0.5 * (t.left + t.right)) + up * (0.5 * (t.bottom + t.top)),
            right: right * (0.5 * (t.right - t.left)),
            up: up * (0.5 * (t.top - t.bottom)),
        })
    }
}

/// Where a camera stands above a planet and looks; see [`Camera::above`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Metres above the surface.
    pub altitude: f64,
    /// Radians above the horizontal.
    pub pitch: f64,
    /// Radians from north towards east.
    pub heading: f64,
    /// Vertical field of view, radians.
    pub fov_y: f64,
}

/// How the scene's depth texture stores distance. `z` is the distance along the camera's axis, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DepthConvention {
    /// 0 at `near`, 1 at `far`: Direct3D, Vulkan and WebGPU's default.
    ZeroToOne {
        /// Metres.
        near: f64,
        /// Metres.
        far: f64,
    },
    /// 1 at `near`, 0 at `far`.
    Reversed {
        /// Metres.
        near: f64,
        /// Metres.
        far: f64,
    },
    /// 1 at `near`, 0 infinitely far: `near / z`. The best use of a float depth buffer, and the default.
    ReversedInfinite {
        /// Metres.
        near: f64,
    },
    /// OpenGL's projection to -1..1, stored as `(z_ndc + 1) / 2` by the default depth range.
    NegativeOneToOne {
        /// Metres.
        near: f64,
        /// Metres.
        far: f64,
    },
    /// `log2(1 + z) / log2(1 + far)`, as three.js' `logarithmicDepthBuffer` writes it.
    Logarithmic {
        /// Metres.
        far: f64,
    },
}

impl Default for DepthConvention {
    fn default() -> Self {
        Self::ReversedInfinite { near: 0.1 }
    }
}

impl DepthConvention {
    /// Checks the planes: `near` from 1e-4 m, `far` up to 1e15 m and at least 1.001 × near.
    pub fn validate(&self) -> Result<()> {
        let (near, far) = match *self {
            Self::ZeroToOne { near, far }
            | Self::Reversed { near, far }
            | Self::NegativeOneToOne { near, far } => (near, Some(far)),
            Self::ReversedInfinite { near } => (near, None),
            Self::Logarithmic { far } => (1e-3, Some(far)),
        };
        in_range("depth.near", near, 1e-4, 1e9, "m")?;
        if let Some(far) = far {
            in_range("depth.far", far, near * 1.001, 1e15, "m (and beyond near)")?;
        }
        Ok(())
    }

    /// The depth value of the background: what the depth texture is cleared to.
    pub fn background(&self) -> f64 {
        if self.is_reversed() { 0.0 } else { 1.0 }
    }

    /// Whether nearer things have larger values.
    pub fn is_reversed(&self) -> bool {
        matches!(self, Self::Reversed { .. } | Self::ReversedInfinite { .. })
    }

    /// The stored value for a thing `z` metres away along the camera's axis.
    pub fn encode(&self, z: f64) -> f64 {
        match *self {
            Self::ZeroToOne { near, far } | Self::NegativeOneToOne { near, far } => {
                far / (far - near) * (1.0 - near / z)
            }
            Self::Reversed { near, far } => near / (far - near) * (far / z - 1.0),
            Self::ReversedInfinite { near } => near / z,
            Self::Logarithmic { far } => z.ln_1p() / far.ln_1p(),
        }
    }

    /// Metres along the camera's axis for a stored value; infinite for the background.
    pub fn decode(&self, d: f64) -> f64 {
        let [a, b, log_far, _] = self.coefficients();
        if log_far > 0.0 {
            return if d >= 1.0 { f64::INFINITY } else { (d * log_far * std::f64::consts::LN_2).exp_m1() };
        }
        if d == self.background() { f64::INFINITY } else { 1.0 / (a * d + b) }
    }

    /// `[a, b, log2(1 + far), background]`, metres: `1 / z = a d + b`, or the logarithm where the third is
    /// not 0.
    pub(crate) fn coefficients(&self) -> [f64; 4] {
        let background = self.background();
        match *self {
            Self::ZeroToOne { near, far } | Self::NegativeOneToOne { near, far } => {
                [1.0 / far - 1.0 / near, 1.0 / near, 0.0, background]
            }
            Self::Reversed { near, far } => [1.0 / near - 1.0 / far, 1.0 / far, 0.0, background],
            Self::ReversedInfinite { near } => [1.0 / near, 0.0, 0.0, background],
            Self::Logarithmic { far } => [0.0, 0.0, far.ln_1p() / std::f64::consts::LN_2, background],
        }
    }
}

/// Everything that a sky depends on.
///
/// What the shaders' 32-bit floats leave of it, on every driver that was tried (`docs/stability.md`):
/// distances and altitudes along a ray are right to 1e-5 or 1 m, whichever is more (on planets smaller than
/// the Earth, that metre in proportion), for a ray turned by up to 2^-22 of the smaller of its zenith angle's
/// sine and cosine. On an Earth that moves where a ray passes the planet by up to 1.5 m, from the ground as
/// from 1 au. Altitudes within metres of the top of the air are known to 2^-22 of the shell's thickness.
/// Light is within 0.1 %, or 1e-6 of the ray's brightest channel, of the same sum in f64.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The observer.
    pub camera: Camera,
    /// Centre of the planet in the camera's frame of reference, metres, |component| ≤ 1e15.
    pub planet_center: DVec3,
    /// The planet and its air.
    pub atmosphere: AtmosphereParams,
    /// Towards the sun; any length but zero.
    pub sun_direction: DVec3,
    /// How the scene's depth is stored.
    pub depth: DepthConvention,
    /// A moon that may hide the sun; the camera is outside of it. It is drawn, and hides the sun's disk;
    /// light in the air under its shadow is marched for each pixel.
    pub moon: Option<Moon>,
    /// The planet's shape, if it is not a sphere: the ground is that, wherever it says, and
    /// [`AtmosphereParams::planet_radius`] need only be near its half axes. Altitudes are above it.
    pub ellipsoid: Option<Ellipsoid>,
}

/// A [`Scene`] checked and turned into the camera's zenith frame; still f64, metres.
#[derive(Clone, Debug)]
pub struct ZenithView {
    /// From the scene's frame to the zenith frame, places as seen from the camera. Rows are the frame's x, y
    /// and z axes; with an [`Scene::ellipsoid`], these times its stretch.
    pub world_to_zenith: DMat3,
    /// Rows: the axes alone.
    pub(crate) axes: DMat3,
    /// The camera from the planet's centre, metres: in the scene's axes, stretched.
    pub(crate) from_center: DVec3,
    /// Altitude of the camera; negative below the planet's radius.
    pub altitude: f64,
    /// Height of the camera above [`AtmosphereParams::lowest_ground`]; negative below it.
    pub height: f64,
    /// The camera's rays in the zenith frame.
    pub basis: RayBasis,
    /// Towards the sun: (sin, 0, cos) of its zenith angle at the camera.
    pub sun: DVec3,
    /// The scene's moon, its position from the camera.
    pub moon: Option<Moon>,
}

impl Scene {
    /// Checks everything; see [`AtmosphereParams::validate`] for the medium. Returns the zenith view.
    pub fn validate(&self) -> Result<ZenithView> {
        crate::count::one(|c| &mut c.scene_checks);
        self.atmosphere.validate()?;
        self.depth.validate()?;
        for (name, v) in [("camera.position", self.camera.position), ("planet_center", self.planet_center)] {
            for (axis, c) in ["x", "y", "z"].iter().zip(v.to_array()) {
                in_range(format_args!("{name}.{axis}"), c, -1e15, 1e15, "m")?;
            }
        }
        if let Some(moon) = &self.moon {
            moon.validate(self.camera.position)?;
        }
        let basis = self.camera.basis()?;
        let sun = direction("sun_direction", self.sun_direction)?;
        let stretch = match self.ellipsoid {
            Some(ellipsoid) => {
                ellipsoid.validate()?;
                ellipsoid.to_sphere(self.atmosphere.planet_radius)
            }
            None => DMat3::IDENTITY,
        };
        let sun = (stretch * sun).normalize();
        let from_center = stretch * (self.camera.position - self.planet_center);
        let r = from_center.length();
        if r < 0.5 * self.atmosphere.planet_radius {
            return Err(Error::invalid(
                "camera.position",
                format_args!("{} m from the planet's centre", Decimal(r)),
                format_args!(
                    "at least half the planet's radius ({} m) from it",
                    Decimal(0.5 * self.atmosphere.planet_radius)
                ),
            ));
        }
        let altitude = r - self.atmosphere.planet_radius;
        let z = from_center / r;
        // The sun's horizontal part; any horizontal direction where it has none.
        let flat = sun - z * sun.dot(z);
        let x = if flat.length() > 1e-9 { flat.normalize() } else { z.any_orthonormal_vector() };
        let x = (x - z * x.dot(z)).normalize();
        let axes = DMat3::from_cols(x, z.cross(x), z).transpose();
        let rows = axes * stretch;
        Ok(ZenithView {
            world_to_zenith: rows,
            axes,
            from_center,
            altitude,
            height: altitude - self.atmosphere.lowest_ground,
            basis: RayBasis { forward: rows * basis.forward, right: rows * basis.right, up: rows * basis.up },
            sun: axes * sun,
            moon: self.moon.map(|m| Moon { position: rows * (m.position - self.camera.position), ..m }),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depth_round_trips_in_every_convention() {
        for depth in [
            DepthConvention::ZeroToOne { near: 0.5, far: 1e5 },
            DepthConvention::Reversed { near: 0.5, far: 1e5 },
            DepthConvention::ReversedInfinite { near: 0.5 },
            DepthConvention::NegativeOneToOne { near: 0.5, far: 1e5 },
            DepthConvention::Logarithmic { far: 1e5 },
        ] {
            depth.validate().unwrap();
            for z in [0.6, 1.0, 37.0, 5000.0, 9.9e4] {
                let back = depth.decode(depth.encode(z));
                assert!((back / z - 1.0).abs() < 1e-6, "{depth:?} {z} {back}");
            }
            assert_eq!(depth.decode(depth.background()), f64::INFINITY, "{depth:?}");
        }
    }

    #[test]
    fn zenith_frame_does_not_depend_on_the_world() {
        let earth = AtmosphereParams::earth();
        let make = |center: DVec3, turn: glam::DQuat| Scene {
            camera: Camera::new(
                center + turn * (DVec3::new(0.3, 0.8, 0.2).normalize() * 6_361_000.0),
                turn * DVec3::new(1.0, 0.1, 0.0),
                turn * DVec3::Y,
                1.0,
                1.5,
            ),
            planet_center: center,
            atmosphere: earth.clone(),
            sun_direction: turn * DVec3::new(1.0, 1.0, 0.5) * 7.0,
            depth: DepthConvention::default(),
            moon: None,
            ellipsoid: None,
        };
        let a = make(DVec3::ZERO, glam::DQuat::IDENTITY).validate().unwrap();
        let b = make(DVec3::new(1e9, -2e9, 3e9), glam::DQuat::from_rotation_x(1.0)).validate().unwrap();
        assert!((a.altitude - 1000.0).abs() < 1e-6 && (b.altitude - 1000.0).abs() < 1e-4);
        assert!((a.basis.forward - b.basis.forward).length() < 1e-9);
        assert!((a.sun - b.sun).length() < 1e-9 && a.sun.y.abs() < 1e-12 && a.sun.x >= 0.0);
    }
}
