//! What a picture sees: the planet with its air, and the disks of sun and moon. All in f64, in the camera's
//! zenith frame, metres and radians; nothing here knows how light is computed.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DMat3, DVec3};

use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::{RayBasis, ZenithView};

/// Radians by which a picture is taken to be wider than it is: rounding, and half a pixel, decide nothing
/// then.
pub(crate) const MARGIN: f64 = 1e-3;

/// What a picture sees of the planet: the cone around its middle that holds its corners, against the planet
/// and its shell of air.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Visibility {
    /// Radius of the lowest ground, metres.
    pub ground_radius: f64,
    /// Radius of the top of the air, metres.
    pub top: f64,
    /// Distance of the camera from the planet's centre, metres; the lowest ground's for a camera below that.
    pub camera_radius: f64,
    /// Height of the camera above the lowest ground, metres, never negative.
    pub height: f64,
    /// Half angle under which the planet is seen, radians.
    pub planet_angle: f64,
    /// Elevation of the sun's centre at the camera, radians.
    pub sun_elevation: f64,
    /// Whether air can be in the picture.
    pub air: bool,
    /// Whether a ray of the picture can end on the ground.
    pub ground: bool,
    /// Whether a ray through air can miss the ground.
    pub sky: bool,
    /// Height above the lowest ground of the lowest air in the picture, metres.
    pub lowest: f64,
}

impl Visibility {
    /// What the picture of a checked scene sees.
    pub fn new(p: &AtmosphereParams, view: &ZenithView) -> Self {
        let b = &view.basis;
        let axis = b.forward.normalize_or_zero();
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        let corners = corners.map(|(x, y)| (b.forward + b.right * x + b.up * y).normalize_or_zero());
        let most = |of: DVec3| corners.iter().map(|&c| angle(c, of)).fold(0.0, f64::max);
        // Beyond a right angle the cone does not hold what lies between its corners.
        let widest = Some(most(axis)).filter(|w| *w < 0.5 * PI).unwrap_or(PI);
        let (ground_radius, top) = (p.ground_radius(), p.atmosphere_radius);
        let height = view.height.max(0.0);
        let camera_radius = ground_radius + height;
        let planet_angle = (ground_radius / camera_radius).min(1.0).asin();
        let shell = if camera_radius > top { (top / camera_radius).asin() } else { PI };
        // Angles from straight down to the picture: no nearer than its cone and than each of its four sides.
        let down = -DVec3::Z;
        let side = |i: usize| {
            let inward = corners[i].cross(corners[(i + 1) % 4]).normalize_or_zero();
            let inward = if inward.dot(axis) < 0.0 { -inward } else { inward };
            (-inward.dot(down)).clamp(0.0, 1.0).asin()
        };
        let nearest = (0..4).map(side).fold(angle(axis, down) - widest, f64::max) - MARGIN;
        let (nearest, farthest) = (nearest.max(0.0), most(down) + MARGIN);
        let air = nearest <= shell;
        let ground = nearest <= planet_angle;
        let lowest = match nearest {
            _ if ground => 0.0,
            n if n < 0.5 * PI => (camera_radius * n.sin() - ground_radius).max(0.0),
            _ => height,
        };
        Self {
            ground_radius,
            top,
            camera_radius,
            height,
            planet_angle,
            sun_elevation: view.sun.z.clamp(-1.0, 1.0).asin(),
            air,
            ground,
            sky: air && farthest >= planet_angle,
            lowest,
        }
    }

    /// Whether the planet hides all of a disk. towards: unit; radius: radians.
    pub fn hides(&self, towards: DVec3, radius: f64) -> bool {
        angle(towards, -DVec3::Z) + radius + MARGIN < self.planet_angle
    }

    /// Distance to the farthest air that a straight line from the camera reaches before the ground or space,
    /// metres.
    pub fn farthest(&self) -> f64 {
        let to = |r: f64| ((r - self.ground_radius) * (r + self.ground_radius)).max(0.0).sqrt();
        to(self.camera_radius) + to(self.top)
    }

    /// Angle at the planet's centre from the camera to the farthest air above a height (metres) that it sees,
    /// radians.
    pub fn arc_to_air_above(&self, height: f64) -> f64 {
        let a = self.ground_radius + height;
        (a / self.camera_radius).min(1.0).acos() + (a / self.top).min(1.0).acos()
    }
}

/// Angle between two unit vectors, radians.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.dot(b).clamp(-1.0, 1.0).acos()
}

/// Where in the picture (left, bottom, right, top, -1 to 1) a disk in the sky may touch a pixel; `None`
/// outside of it. towards: its middle, unit; radius: with its soft edge, radians; size: of the target,
/// pixels.
pub(crate) fn disk_rectangle(
    basis: &RayBasis,
    towards: DVec3,
    radius: f64,
    size: [u32; 2],
) -> Option<[f64; 4]> {
    let axis = basis.right.cross(basis.up).normalize_or_zero();
    let axis = if axis.dot(basis.forward) < 0.0 { -axis } else { axis };
    let along = axis.dot(towards);
    let angle = axis.cross(towards).length().atan2(along);
    if angle + radius > FRAC_PI_2 - 0.01 {
        // A cone that reaches the camera's plane has no outline in the picture.
        let corner = |x: f64, y: f64| axis.angle_between(basis.forward + basis.right * x + basis.up * y);
        let widest = [corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, -1.0), corner(1.0, 1.0)];
        let seen = widest.into_iter().fold(0.0, f64::max) + 0.01 > angle - radius;
        return seen.then_some([-1.0, -1.0, 1.0, 1.0]);
    }
    // On the camera's plane at distance 1 the disk lies within a circle around its centre.
    let reach = (angle + radius).tan() - angle.tan();
    // In a stretched frame the picture's sides are not quite at right angles.
    let middle = DMat3::from_cols(basis.right, basis.up, basis.forward).inverse() * towards;
    let span = |side: DVec3, other: DVec3, middle: f64, pixels: u32| {
        let across = side.cross(other).length() / other.length();
        let half = reach / across + 2.0 / f64::from(pixels.max(1)); // one pixel
        (middle - half, middle + half)
    };
    let (left, right) = span(basis.right, basis.up, middle.x / middle.z, size[0]);
    let (bottom, top) = span(basis.up, basis.right, middle.y / middle.z, size[1]);
    let outside = left > 1.0 || right < -1.0 || bottom > 1.0 || top < -1.0;
    (!outside).then(|| [left, bottom, right, top].map(|v| v.clamp(-1.0, 1.0)))
}
