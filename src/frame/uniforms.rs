//! The uniform block of the atmosphere's passes; its WGSL twin is `struct Frame` in `lib/frame.wgsl`.

use glam::DVec3;

use super::background::draws_any;
use crate::gpu::{Format, RowOrder};
use crate::model::atmosphere::AtmosphereParams;
use crate::model::scene::{Scene, ZenithView};
use crate::shaders::sky_view::numbers::{REDUCED, SHELL_DIMS, WIDE};

/// How much a coordinate of the unit vector to the sun may change before a view's LUTs are made again. By
/// `docs/effects.md` ("Light for a scene of one's own") green light falls to a fifth from 1° to -2°, so by
/// 3e-5 over this, a hundredth of an 8-bit step; two eyes see the sun 1e-8 radians apart.
const SUN_TURNED: f32 = 1e-6;

/// How much the camera's altitude may change, in proportion, before they are: rounding, as the horizon's dip
/// changes by half of that.
const CLIMBED: f32 = 1e-6;

/// Per-metre to per-kilometre, and metres to kilometres by division.
const KM: f64 = 1000.0;

macro_rules! block {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $ty:ty,)* }) => {
        $(#[$doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
        pub struct $name { $($(#[$field_doc])* pub $field: $ty,)* }

        impl $name {
            /// Name and byte offset of every field, for the check against naga's layout.
            #[allow(dead_code)] // Blocks of private modules are checked through the blocks that hold them.
            pub fn offsets() -> Vec<(&'static str, u32)> {
                vec![$((stringify!($field), std::mem::offset_of!($name, $field) as u32),)*]
            }
        }
    };
}
pub(crate) use block;

block! {
    /// `struct Medium`: kilometres and 1/km.
    #[allow(missing_docs)]
    MediumUniform {
        rayleigh: [f32; 3],
        rayleigh_inv_height: f32,
        mie_scattering: [f32; 3],
        mie_inv_height: f32,
        mie_extinction: [f32; 3],
        ozone_center: f32,
        mie_asymmetry: [f32; 3],
        ozone_inv_half_width: f32,
        ozone: [f32; 3],
        radius: f32,
        irradiance: [f32; 3],
        thickness: f32,
        datum: f32,
        pad1: f32,
        pad2: f32,
        pad3: f32,
    }
}

block! {
    /// `struct DepthCode`: see [`crate::DepthConvention`].
    #[allow(missing_docs)]
    DepthUniform {
        scale: f32,
        bias: f32,
        log: f32,
        background: f32,
    }
}

block! {
    /// `struct Frame`: see the fields' comments in `lib/frame.wgsl`.
    #[allow(missing_docs)]
    FrameUniform {
        medium: MediumUniform,
        ray_forward: [f32; 3],
        altitude: f32,
        ray_right: [f32; 3],
        sky_weight: f32,
        ray_up: [f32; 3],
        shell_weight: f32,
        sun: [f32; 3],
        sun_chord: f32,
        size: [f32; 2],
        sun_disk: f32,
        pixel_angle: f32,
        depth: DepthUniform,
        view_samples: u32,
        light_samples: u32,
        flags: u32,
        camera_altitude: f32,
        sky_view_mapping: [f32; 4],
    }
}

impl MediumUniform {
    /// The medium in kilometres.
    pub fn new(p: &AtmosphereParams) -> Self {
        let per_km = |c: [f64; 3]| c.map(|v| (v * KM) as f32);
        Self {
            rayleigh: per_km(p.rayleigh_scattering),
            rayleigh_inv_height: (KM / p.rayleigh_scale_height) as f32,
            mie_scattering: per_km(p.mie_scattering),
            mie_inv_height: (KM / p.mie_scale_height) as f32,
            mie_extinction: per_km(p.mie_extinction()),
            ozone_center: (p.ozone_center_altitude / KM) as f32,
            mie_asymmetry: p.mie_asymmetry.map(|g| g as f32),
            ozone_inv_half_width: (KM / p.ozone_half_width) as f32,
            ozone: per_km(p.ozone_absorption),
            radius: (p.ground_radius() / KM) as f32,
            irradiance: [p.sun_intensity as f32; 3],
            thickness: (p.thickness() / KM) as f32,
            datum: (-p.lowest_ground / KM) as f32,
            ..Self::default()
        }
    }
}

fn vec3(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}

impl FrameUniform {
    /// How the sky-view LUT shares its rows above the horizon, at a height (metres): the part for rays
    /// that go down and pass the ground, how far that part is spaced as seen from outside (0 to 1), evenly in
    /// the altitude that a ray passes, and the share that it has near the ground, as many rows as crowding at
    /// the horizon alone would give it. Last: the horizon's cosine of the zenith angle with its sign changed.
    pub(crate) fn sky_view_mapping(height: f64, p: &AtmosphereParams) -> [f32; 4] {
        let radius = p.ground_radius();
        let horizon = (height * (2.0 * radius + height)).sqrt() / (radius + height);
        let s_max = (0.5 + 0.5 * horizon).sqrt();
        let near = (0.5 * horizon / (s_max * (s_max + std::f64::consts::FRAC_1_SQRT_2))).sqrt();
        let bend = (height / p.thickness()).min(1.0).powi(4);
        [near + (1.0 - near) * bend, bend, near, horizon].map(|v| v as f32)
    }

    /// The block of a checked scene's picture. The camera counts as on the lowest ground where it is below.
    /// size: pixels; rows: which end of the picture the target's first row is; samples: along the view ray
    /// and from each of them towards the sun; background_weight: fraction of the sky's light that the
    /// background pass draws, 0 to 1.
    pub fn new(
        scene: &Scene,
        view: &ZenithView,
        size: [u32; 2],
        rows: RowOrder,
        [view_samples, light_samples]: [u32; 2],
        background_weight: f64,
    ) -> Self {
        let p = &scene.atmosphere;
        let flip = if rows == RowOrder::BottomUp { -1.0 } else { 1.0 };
        let [scale, bias, log, background] = scene.depth.coefficients();
        let chord = 2.0 * (0.5 * p.sun_angular_radius).sin();
        Self {
            medium: MediumUniform::new(p),
            ray_forward: vec3(view.basis.forward),
            altitude: (view.height.max(0.0) / KM) as f32,
            ray_right: vec3(view.basis.right),
            sky_weight: background_weight as f32,
            ray_up: vec3(view.basis.up * flip),
            shell_weight: (1.0 - background_weight) as f32,
            sun: vec3(view.sun),
            sun_chord: chord as f32,
            size: size.map(|s| s as f32),
            // Uniform disk: irradiance 1 over its solid angle, 2 pi (1 - cos) = pi chord^2.
            sun_disk: (1.0 / (std::f64::consts::PI * chord * chord)) as f32,
            pixel_angle: pixel_angle(view, size),
            depth: DepthUniform {
                scale: (scale * KM) as f32,
                bias: (bias * KM) as f32,
                log: log as f32,
                background: background as f32,
            },
            view_samples,
            light_samples,
            flags: if draws_any(background_weight) { 0 } else { SHELL_DIMS },
            camera_altitude: (view.altitude / KM) as f32,
            sky_view_mapping: Self::sky_view_mapping(view.height.max(0.0), p),
        }
    }

    /// The same block for a picture whose first pixel is not the target's: rays are by the target's pixels.
    pub(crate) fn moved(self, view: &ZenithView, size: [u32; 2], rows: RowOrder, [x, y]: [u32; 2]) -> Self {
        let flip = if rows == RowOrder::BottomUp { -1.0 } else { 1.0 };
        let b = &view.basis;
        let across = b.right * (2.0 * f64::from(x) / f64::from(size[0]));
        let down = b.up * (flip * 2.0 * f64::from(y) / f64::from(size[1]));
        Self { ray_forward: vec3(b.forward - across + down), ..self }
    }

    /// The same block for targets of these formats: nothing is cut where all hold 32-bit floats.
    pub(crate) fn drawn_to(self, formats: impl IntoIterator<Item = Format>) -> Self {
        let wide = formats.into_iter().all(|format| format == Format::Rgba32Float);
        Self { flags: if wide { self.flags | WIDE } else { self.flags }, ..self }
    }

    /// The same block for a smaller picture of the same view, in halves, whose planet pixels are marked
    /// instead of discarded.
    pub(crate) fn reduced(self, view: &ZenithView, size: [u32; 2]) -> Self {
        let pixel_angle = pixel_angle(view, size);
        Self { size: size.map(|s| s as f32), pixel_angle, flags: (self.flags & !WIDE) | REDUCED, ..self }
    }

    /// What of the block the LUTs of a view depend on: medium, altitude and sun; the rest is 0, so that
    /// turning the camera leaves its bytes as they are. LUTs hold light per unit of irradiance.
    ///
    /// `kept`: the same of another frame, which is taken where it differs by less than can be seen. Two eyes
    /// 65 mm apart see the sun 1e-8 radians apart, which would make the LUTs twice in each frame.
    pub(crate) fn of_view_luts(&self, kept: Option<&Self>) -> Self {
        let fresh = Self {
            medium: MediumUniform { irradiance: [0.0; 3], ..self.medium },
            altitude: self.altitude,
            sun: self.sun,
            sky_view_mapping: self.sky_view_mapping,
            ..Self::default()
        };
        let serves = |kept: &&Self| {
            let turned = fresh.sun.iter().zip(kept.sun).fold(0.0_f32, |most, (a, b)| most.max((a - b).abs()));
            let climbed = (fresh.altitude - kept.altitude).abs();
            bytemuck::bytes_of(&kept.medium) == bytemuck::bytes_of(&fresh.medium)
                && turned <= SUN_TURNED
                && climbed <= CLIMBED * fresh.altitude
        };
        kept.filter(serves).copied().unwrap_or(fresh)
    }
}

/// Angle of one pixel in the middle of a picture of a size in pixels, radians.
fn pixel_angle(view: &ZenithView, size: [u32; 2]) -> f32 {
    (2.0 * view.basis.up.length() / f64::from(size[1].max(1))) as f32
}
