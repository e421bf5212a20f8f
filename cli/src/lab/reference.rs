//! What the f64 reference says of a pixel.

use glam::DVec2;
use welkin::model::scene::ZenithView;
use welkin::reference::multiple::Orders;
use welkin::reference::single::{RayQuery, Tolerance};

/// The ray through the middle of the pixel in column `x` and row `y` of a picture; row 0 is at the top.
pub fn pixel_ray(view: &ZenithView, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> RayQuery {
    let ndc = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    let direction = view.basis.ray(DVec2::new(ndc(x, width), -ndc(y, height))).normalize();
    RayQuery { altitude: view.altitude, direction, sun: view.sun, length: f64::INFINITY, moon: None }
}

/// Light of all orders that the air sends along a ray, per unit of the sun's irradiance. Light that comes
/// straight from the ground is left out: it is the scene's own to draw.
pub fn inscatter(orders: &Orders, ray: &RayQuery) -> welkin::Result<[f64; 3]> {
    let light = orders.radiance(ray, Tolerance { relative: 1e-4 })?;
    Ok(std::array::from_fn(|c| light.per_irradiance[c] - light.ground[c]))
}
