//! Whole pictures on the processor: the renderer of last resort, and a judge of whole frames.
//!
//! Single scattering adaptive to [`Tolerance::PICTURE`], on all cores. The same planet, terrain, sun and
//! tone mapping as [`crate::PictureRenderer`], with nothing shared but the formulas of the terrain and of
//! the tone curves.

use glam::{DVec2, DVec3};
use rayon::prelude::*;

use crate::error::Result;
use crate::frame::Air;
use crate::frame::terrain::TerrainStyle;
use crate::frame::tone_map::{dither, srgb_encode, tone_map};
use crate::gpu::TextureDesc;
use crate::model::moon::{Moon, limb_darkening_of_ring};
use crate::model::scene::{Scene, ZenithView};
use crate::reference::geometry::ray_sphere_intersect;
use crate::reference::single::{RayQuery, Sun, Tolerance, single_scattering, transmittance};
use crate::render::picture::PictureSettings;

/// A picture, row 0 on top.
#[derive(Clone, Debug)]
pub struct CpuPicture {
    /// Radiance before exposure.
    pub radiance: Vec<[f32; 4]>,
    /// sRGB after exposure and tone mapping.
    pub display: Vec<[u8; 4]>,
}

/// Largest side of a picture, pixels.
const MAX_SIDE: u32 = 16_384;

/// Draws a scene. `settings.sky.method` does not matter here; `progress` hears the share that is done.
///
/// # Errors
/// [`crate::ErrorKind::Invalid`] for a scene, a setting or a size out of range.
pub fn render(
    scene: &Scene,
    settings: &PictureSettings,
    size: [u32; 2],
    progress: &dyn Fn(f32),
) -> Result<CpuPicture> {
    let view = scene.validate()?;
    settings.sky.validate()?;
    super::picture::check_terrain(scene, settings)?;
    crate::error::in_range("exposure", settings.exposure, 0.0, 1e9, "")?;
    let [width, height] = size;
    TextureDesc::new("picture", width, height, settings.radiance).validate(MAX_SIDE)?;
    let painter = Painter::new(scene, &view, settings, size);
    let mut radiance = Vec::with_capacity(width as usize * height as usize);
    // Some rows at a time, so that progress is heard from this thread.
    let rows = (16_384 / width).clamp(1, height);
    for first in (0..height).step_by(rows as usize) {
        let pixels = first * width..(first + rows).min(height) * width;
        let band: Result<Vec<_>> =
            pixels.into_par_iter().map(|i| painter.pixel(i % width, i / width)).collect();
        radiance.extend(band?);
        progress(radiance.len() as f32 / (width as f32 * height as f32));
    }
    let display = radiance
        .par_iter()
        .enumerate()
        .map(|(i, p)| {
            let exposed = [p[0], p[1], p[2]].map(|v| f64::from(v) * settings.exposure);
            let shown = tone_map(settings.tone_map, exposed).map(srgb_encode);
            let noise = if settings.dither { dither([i as u32 % width, i as u32 / width]) } else { [0.0; 3] };
            let [r, g, b] = std::array::from_fn(|c| (255.0 * shown[c] + noise[c]).round() as u8);
            [r, g, b, 255]
        })
        .collect();
    Ok(CpuPicture { radiance, display })
}

struct Painter<'a> {
    scene: &'a Scene,
    view: &'a ZenithView,
    settings: &'a PictureSettings,
    size: [u32; 2],
    air: bool,
    pixel_angle: f64,
    /// Camera from the planet's centre, in the planet's own axes, stretched to a sphere.
    camera: DVec3,
    sun: DVec3,
}

impl<'a> Painter<'a> {
    fn new(scene: &'a Scene, view: &'a ZenithView, settings: &'a PictureSettings, size: [u32; 2]) -> Self {
        let back = view.axes.transpose();
        Self {
            scene,
            view,
            settings,
            size,
            air: settings.sky.look.enabled && Air::of(&scene.atmosphere).any(),
            pixel_angle: 2.0 * view.basis.up.length() / f64::from(size[1]),
            camera: view.from_center,
            sun: back * view.sun,
        }
    }

    fn pixel(&self, x: u32, y: u32) -> Result<[f32; 4]> {
        let [width, height] = self.size.map(f64::from);
        let ndc =
            DVec2::new((f64::from(x) + 0.5) / width * 2.0 - 1.0, 1.0 - (f64::from(y) + 0.5) / height * 2.0);
        let dir = self.view.basis.ray(ndc).normalize();
        let world = self.view.axes.transpose() * dir;
        let p = &self.scene.atmosphere;
        let (ground, distance) = match &self.settings.terrain {
            Some(style) => match self.trace(style, world) {
                Some(t) => (Some(self.shade(style, self.camera + world * t)?), t),
                None => (None, f64::INFINITY),
            },
            None => (None, f64::INFINITY),
        };
        let mut color = ground.unwrap_or([0.0; 3]);
        let hits_planet = ray_sphere_intersect(self.camera, world, DVec3::ZERO, p.ground_radius())
            .is_some_and(|(near, _)| near >= 0.0);
        if ground.is_none()
            && !hits_planet
            && self.settings.sky.look.enabled
            && self.settings.sky.look.sun_disk
        {
            let chord = 2.0 * (0.5 * p.sun_angular_radius).sin();
            let cover = ((chord - (dir - self.view.sun).length()) / self.pixel_angle + 0.5).clamp(0.0, 1.0);
            let full = cover * p.sun_intensity / (std::f64::consts::PI * chord * chord);
            let left = self.view.moon.map_or(1.0, |m| {
                // A small disk's edges and the moon's share pixels: then the share of the whole disk counts.
                let whole =
                    m.disks(DVec3::ZERO, self.view.sun, p.sun_angular_radius).map_or(1.0, |d| d.visible());
                let t = ((chord / self.pixel_angle - 1.0) / 3.0).clamp(0.0, 1.0);
                let own = 1.0 - self.moon_cover(&m, dir);
                if whole > 0.0 { whole + (own - whole) * t * t * (3.0 - 2.0 * t) } else { 0.0 }
            });
            color = [full * left; 3];
            if self.settings.sky.look.limb_darkening {
                let r = (dir - self.view.sun).length() / chord;
                let brightness = limb_darkening_of_ring(r, 0.5 * self.pixel_angle / chord);
                color = std::array::from_fn(|c| color[c] * brightness[c]);
            }
        }
        let sight = ground.is_none() && !hits_planet && self.settings.sky.look.enabled;
        if let Some(moon) = self.view.moon.filter(|_| sight) {
            // The disk's soft edge shines as its rim.
            let (towards, sine) = (moon.position.normalize(), moon.radius / moon.position.length());
            let chord = 2.0 * (0.5 * sine.asin()).sin();
            let rim = ((dir - towards).length() / chord).max(1.0);
            let inward = (towards + (dir - towards) / rim * 0.999_999).normalize();
            let cover = self.moon_cover(&moon, dir);
            if cover > 0.0 {
                let light = moon.radiance(DVec3::ZERO, inward, self.view.sun).unwrap_or(0.0);
                color = color.map(|c| c + cover * light * p.sun_intensity);
            }
        }
        if self.air {
            let query = RayQuery {
                altitude: self.view.altitude,
                direction: dir,
                sun: self.view.sun,
                length: distance,
                moon: self.view.moon,
            };
            let s = single_scattering(p, &query, Sun::Point, Tolerance::PICTURE)?;
            color = std::array::from_fn(|c| color[c] * s.transmittance[c] + s.radiance[c]);
        }
        Ok([color[0] as f32, color[1] as f32, color[2] as f32, 1.0])
    }

    /// Share of the pixel around a ray of the zenith frame that the moon covers.
    fn moon_cover(&self, moon: &Moon, dir: DVec3) -> f64 {
        let distance = moon.position.length();
        let chord = 2.0 * (0.5 * (moon.radius / distance).asin()).sin();
        ((chord - (dir - moon.position / distance).length()) / self.pixel_angle + 0.5).clamp(0.0, 1.0)
    }

    /// Distance to the terrain along a ray, or `None`: steps of half the clearance, then a bisection.
    fn trace(&self, style: &TerrainStyle, dir: DVec3) -> Option<f64> {
        let radius = self.scene.atmosphere.planet_radius;
        let (near, far) = ray_sphere_intersect(self.camera, dir, DVec3::ZERO, radius + style.amplitude)?;
        let floor =
            ray_sphere_intersect(self.camera, dir, DVec3::ZERO, radius).map(|(t, _)| t).filter(|t| *t >= 0.0);
        let clearance = |t: f64| {
            let point = self.camera + dir * t;
            let r = point.length();
            r - radius - style.height(point / r, radius).0
        };
        let end = floor.unwrap_or(far);
        let mut t = near.max(0.0);
        let mut before = t;
        while t < end {
            let above = clearance(t);
            if above < 0.0 {
                let (mut outside, mut inside) = (before, t);
                for _ in 0..40 {
                    let middle = 0.5 * (outside + inside);
                    if clearance(middle) < 0.0 { inside = middle } else { outside = middle }
                }
                return Some(inside);
            }
            before = t;
            t += (0.5 * above).max(1e-3 * t + 0.01);
        }
        floor
    }

    /// Sunlight and a share of sky light on the ground; the formulas of `pass/terrain.wgsl`.
    fn shade(&self, style: &TerrainStyle, point: DVec3) -> Result<[f64; 3]> {
        let p = &self.scene.atmosphere;
        let n = point.normalize();
        let (h, gradient) = style.height(n, p.planet_radius);
        let normal = (n - (gradient - n * gradient.dot(n)) / p.planet_radius).normalize();
        let smooth = |a: f64, b: f64, v: f64| {
            let t = ((v - a) / (b - a)).clamp(0.0, 1.0);
            t * t * (3.0 - 2.0 * t)
        };
        let mix = |a: [f64; 3], b: [f64; 3], t: f64| -> [f64; 3] {
            std::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
        };
        let mut albedo = mix(style.low_albedo, style.high_albedo, smooth(0.05, 0.6, h / style.amplitude));
        albedo = mix(style.high_albedo, albedo, smooth(0.80, 0.95, normal.dot(n)));
        if style.snow_line.is_finite() {
            albedo = mix(albedo, [0.8; 3], smooth(style.snow_line, 1.15 * style.snow_line, h));
        }
        if style.sea {
            albedo = mix(albedo, [0.02, 0.04, 0.06], 1.0 - smooth(0.0, 4.0, h));
        }
        let up = n.dot(self.sun);
        let share = TerrainStyle::sky_light(p)
            .map(|s| s * ((up + 0.1) / 1.1).clamp(0.0, 1.0) * (0.5 + 0.5 * normal.dot(n)));
        let dip = (h * (2.0 * p.planet_radius + h)).sqrt() / (p.planet_radius + h);
        let chord = 2.0 * (0.5 * p.sun_angular_radius).sin();
        let visible = smooth(-1.0, 1.0, (up + dip) / chord) * normal.dot(self.sun).max(0.0);
        let through = if visible > 0.0 {
            // Never through the ground: a sun whose centre is below the horizon counts as on it.
            let toward = if up > -dip { self.sun } else { (self.sun - n * (up + dip)).normalize() };
            let query = RayQuery::in_world(n * (p.planet_radius + h), toward, self.sun, p.planet_radius)?;
            transmittance(p, &query, Tolerance::PICTURE)?
        } else {
            [0.0; 3]
        };
        // Sky light has the share of the sun that is left here, for want of one of its own.
        let left = match &self.scene.moon {
            Some(moon) => {
                let point = self.scene.planet_center + n * (p.planet_radius + h);
                moon.sunlight(point, self.sun, p.sun_angular_radius)
            }
            None => [1.0; 3],
        };
        Ok(std::array::from_fn(|c| {
            albedo[c] * left[c] * (share[c] + through[c] * visible) * p.sun_intensity / std::f64::consts::PI
        }))
    }
}
