//! A camera as renderers have it: view and projection matrices, both ways.
//!
//! View space is right-handed, x right, y up, looking along -z, as WebGPU's and OpenGL's examples have it.
//! Matrices are f64 and for columns: `clip = projection * view * world`.

use glam::{DMat4, DVec3, DVec4};

use super::scene::{Camera, DepthConvention, Scene, Tangents};
use crate::error::{Decimal, Error, Result};

impl Camera {
    /// From the camera's frame of reference to view space, metres.
    ///
    /// A planet's coordinates do not fit 32-bit floats: give your shaders [`Self::view_rotation`] instead,
    /// and positions from which the camera's was subtracted in f64.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for directions that span no picture, as [`Self::basis`].
    pub fn view(&self) -> Result<DMat4> {
        Ok(self.view_rotation()? * DMat4::from_translation(-self.position))
    }

    /// [`Self::view`] for positions relative to the camera.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for directions that span no picture, as [`Self::basis`].
    pub fn view_rotation(&self) -> Result<DMat4> {
        let symmetric =
            Self { tangents: Tangents { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }, ..*self };
        let basis = symmetric.basis()?;
        let rows = [basis.right, basis.up, -basis.forward, DVec3::ZERO];
        let [x, y, z, _] = rows.map(|row| row.extend(0.0));
        Ok(DMat4::from_cols(x, y, z, DVec4::W).transpose())
    }

    /// From view space to clip space, such that a depth buffer holds what [`DepthConvention::encode`] says.
    ///
    /// This is for WebGPU, Vulkan and Direct3D, and for OpenGL after `glClipControl(.., GL_ZERO_TO_ONE)`; of
    /// [`DepthConvention::NegativeOneToOne`] for OpenGL as it is. Without `glClipControl`, and in WebGL, take
    /// [`Self::projection_gl`].
    ///
    /// [`DepthConvention::Logarithmic`] is no projection: a shader writes it, from the distance `w` as
    /// `log2(1 + w) / log2(1 + far)`. Its matrix keeps what is between 1 mm and `far`.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] from [`DepthConvention::validate`], and for tangents that span no
    /// picture.
    pub fn projection(&self, depth: DepthConvention) -> Result<DMat4> {
        depth.validate()?;
        self.basis()?;
        let Tangents { left, right, bottom, top } = self.tangents;
        // Depth in clip space over w is `constant + over_z / z`.
        let (constant, over_z) = match depth {
            DepthConvention::ZeroToOne { near, far } => (far / (far - near), -far * near / (far - near)),
            DepthConvention::Logarithmic { far } => (far / (far - 1e-3), -far * 1e-3 / (far - 1e-3)),
            DepthConvention::Reversed { near, far } => (-near / (far - near), far * near / (far - near)),
            DepthConvention::ReversedInfinite { near } => (0.0, near),
            DepthConvention::NegativeOneToOne { near, far } => {
                ((far + near) / (far - near), -2.0 * far * near / (far - near))
            }
        };
        let (width, height) = (right - left, top - bottom);
        Ok(DMat4::from_cols(
            DVec4::new(2.0 / width, 0.0, 0.0, 0.0),
            DVec4::new(0.0, 2.0 / height, 0.0, 0.0),
            DVec4::new((right + left) / width, (top + bottom) / height, -constant, -1.0),
            DVec4::new(0.0, 0.0, over_z, 0.0),
        ))
    }

    /// [`Self::projection`] for OpenGL and WebGL as they are, whose depth buffers hold `0.5 z / w + 0.5`:
    /// they come to hold what [`DepthConvention::encode`] says, in every convention. (A reversed one loses
    /// its extra digits that way.)
    ///
    /// # Errors
    /// As for [`Self::projection`].
    pub fn projection_gl(&self, depth: DepthConvention) -> Result<DMat4> {
        let projection = self.projection(depth)?;
        if let DepthConvention::NegativeOneToOne { .. } = depth {
            return Ok(projection);
        }
        // 2 z - w in place of z.
        let stretch = DMat4::from_cols(DVec4::X, DVec4::Y, DVec4::Z * 2.0, DVec4::new(0.0, 0.0, -1.0, 1.0));
        Ok(stretch * projection)
    }

    /// The camera of a view and a projection matrix: off-centre and jittered projections too, and left-handed
    /// ones, which look along +z. One that turns the picture over, as some do for Vulkan, gives the same
    /// camera as without: the sky is drawn upright.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a view that does more than turn and move (or mirror), and for a
    /// projection without perspective.
    pub fn from_matrices(view: DMat4, projection: DMat4) -> Result<Self> {
        let invalid = |field, value: f64, allowed| Error::invalid(field, Decimal(value), allowed);
        let rows = view.transpose();
        let turn = [rows.x_axis, rows.y_axis, rows.z_axis].map(DVec4::truncate);
        for (i, a) in turn.iter().enumerate() {
            for (j, b) in turn.iter().enumerate().skip(i) {
                let (product, want) = (a.dot(*b), if i == j { 1.0 } else { 0.0 });
                if (product - want).abs() >= 1e-4 || product.is_nan() {
                    let allowed =
                        "a matrix whose rows are at right angles and of length 1: one without scale";
                    return Err(invalid("view", product, allowed));
                }
            }
        }
        let moved = view.w_axis.truncate();
        let position = -(turn[0] * moved.x + turn[1] * moved.y + turn[2] * moved.z);
        let along = projection.z_axis.w;
        let is_perspective = (along.abs() - 1.0).abs() < 1e-9 && projection.w_axis.w == 0.0;
        if !is_perspective {
            let allowed = "-1 (or 1, left-handed), as a perspective's last row has it";
            return Err(invalid("projection", along, allowed));
        }
        // A direction with tangents x and y has z = along (1 for a left-handed view, -1 else).
        let tangent = |scale: f64, shift: f64| [-1.0, 1.0].map(|edge| (edge - along * shift) / scale);
        let [left, right] = tangent(projection.x_axis.x, projection.z_axis.x);
        let [bottom, top] = tangent(projection.y_axis.y, projection.z_axis.y);
        // A projection that is upside down, as some have it for Vulkan, is not: the picture's rows are.
        let (bottom, top) = (bottom.min(top), bottom.max(top));
        let (forward, up) = (turn[2] * along, turn[1]);
        let camera = Self { position, forward, up, tangents: Tangents { left, right, bottom, top } };
        camera.basis()?;
        Ok(camera)
    }
}

impl Scene {
    /// Altitude of the camera above the planet's surface, metres; negative below it.
    pub fn altitude(&self) -> f64 {
        (self.camera.position - self.planet_center).length() - self.atmosphere.planet_radius
    }

    /// Elevation of the sun's centre above the horizontal at the camera, radians; no refraction.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] for a scene that [`Self::validate`] refuses.
    pub fn sun_elevation(&self) -> Result<f64> {
        Ok(self.validate()?.sun.z.clamp(-1.0, 1.0).asin())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEPTHS: [DepthConvention; 5] = [
        DepthConvention::ZeroToOne { near: 0.5, far: 1e5 },
        DepthConvention::Reversed { near: 0.5, far: 1e5 },
        DepthConvention::ReversedInfinite { near: 0.5 },
        DepthConvention::NegativeOneToOne { near: 0.5, far: 1e5 },
        DepthConvention::Logarithmic { far: 1e5 },
    ];

    fn camera() -> Camera {
        Camera {
            position: DVec3::new(1e6, -2e6, 6e6),
            forward: DVec3::new(1.0, 2.0, -0.5),
            up: DVec3::new(0.1, 0.0, 1.0),
            tangents: Tangents { left: -0.7, right: 1.1, bottom: -0.4, top: 0.6 },
        }
    }

    #[test]
    fn matrices_put_rays_where_the_picture_has_them() {
        let camera = camera();
        let basis = camera.basis().unwrap();
        for depth in DEPTHS {
            let clip = camera.projection(depth).unwrap() * camera.view().unwrap();
            for (x, y, z) in [(0.0, 0.0, 3.0), (-1.0, 1.0, 700.0), (0.3, -0.8, 4e4)] {
                let point = camera.position + basis.ray(glam::DVec2::new(x, y)) * z;
                let p = clip * point.extend(1.0);
                let ndc = p.truncate() / p.w;
                assert!((ndc.x - x).abs() < 1e-6 && (ndc.y - y).abs() < 1e-6, "{depth:?}: {ndc}");
                assert!((p.w / z - 1.0).abs() < 1e-8, "{depth:?}: {}", p.w);
                let stored = match depth {
                    DepthConvention::NegativeOneToOne { .. } => 0.5 * ndc.z + 0.5,
                    DepthConvention::Logarithmic { .. } => continue,
                    _ => ndc.z,
                };
                assert!((stored - depth.encode(z)).abs() < 1e-9, "{depth:?} {z}: {stored}");
                let clip = camera.projection_gl(depth).unwrap() * camera.view().unwrap();
                let p = clip * point.extend(1.0);
                let stored = 0.5 * p.z / p.w + 0.5;
                assert!((stored - depth.encode(z)).abs() < 1e-9, "OpenGL: {depth:?} {z}: {stored}");
            }
        }
    }

    #[test]
    fn a_camera_comes_back_from_its_matrices() {
        let camera = camera();
        let mirror = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0));
        let view = camera.view().unwrap();
        for depth in DEPTHS {
            let projection = camera.projection(depth).unwrap();
            let upside_down = DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0)) * projection;
            for (view, projection) in
                [(view, projection), (mirror * view, projection * mirror), (view, upside_down)]
            {
                let back = Camera::from_matrices(view, projection).unwrap();
                let (want, got) = (camera.basis().unwrap(), back.basis().unwrap());
                assert!((back.position - camera.position).length() < 1e-6, "{depth:?}: {back:?}");
                let same_height = (want.up - got.up).length() < 1e-9;
                let off = (want.forward - got.forward).length() + (want.right - got.right).length();
                assert!(same_height && (off < 1e-9 || projection == upside_down), "{depth:?}: {back:?}");
            }
        }
        let parallel = DMat4::from_scale(DVec3::new(0.1, 0.1, 0.01));
        let error = Camera::from_matrices(view, parallel).unwrap_err().to_string();
        assert!(error.contains("projection = 0 ") && error.contains("perspective"), "{error}");
        let error = Camera::from_matrices(view * 2.0, camera.projection(DEPTHS[0]).unwrap()).unwrap_err();
        assert!(error.to_string().contains("without scale"), "{error}");
    }
}
