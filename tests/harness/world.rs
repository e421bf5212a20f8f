//! Everything that a picture depends on, and a change of each input, for tests that compare a renderer with a
//! new one.

use welkin::gpu::{Backend, Pass, Target};
use welkin::{
    AtmosphereParams, Composition, LutSettings, MiePhase, PictureRenderer, PictureSettings, Quality,
    SkyRenderer, SkySettings,
};

use super::{TINY, View, draw_both, frame_passes, frame_textures, free};

/// What is behind the air in the user's frame.
pub const BEHIND: [f32; 4] = [0.5, 0.25, 1.0, 1.0];

/// All that a picture depends on.
#[derive(Clone, Debug)]
pub struct World {
    pub view: View,
    pub sky: SkySettings,
    pub lut: LutSettings,
    pub size: [u32; 2],
}

impl World {
    pub fn new() -> Self {
        let params = AtmosphereParams { sun_angular_radius: 0.1, ..AtmosphereParams::earth() };
        // Half handed over, with the ground below and the sun in the picture: every pass and table counts.
        let view =
            View { params, altitude: 25e3, pitch: 5.0, fov: 60.0, sun_elevation: 15.0, ..View::default() };
        Self { view, sky: SkySettings::default(), lut: TINY, size: [10, 8] }
    }

    pub fn sky(&self) -> SkySettings {
        let quality = match self.sky.quality {
            Quality::Luts(_) => Quality::Luts(self.lut),
            other => other,
        };
        SkySettings { quality, ..self.sky }
    }

    /// The passes before and behind a scene of planes, nearer from row to row, and what they leave in the
    /// target.
    pub fn run(&self, b: &mut dyn Backend, sky: &mut SkyRenderer) -> (Vec<Pass>, Vec<f32>) {
        let [w, h] = self.size;
        let scene = self.view.scene();
        let [color, depth, out] = frame_textures(b, self.size);
        let planes = |y: u32| {
            if y < 2 { scene.depth.background() } else { scene.depth.encode(4e5 / f64::from(y * y)) }
        };
        let stored: Vec<f32> = (0..w * h).map(|i| planes(i / w) as f32).collect();
        b.write_texture(depth, &stored).unwrap();
        b.write_texture(color, &BEHIND.repeat((w * h) as usize)).unwrap();
        sky.set_settings(self.sky()).unwrap();
        let (passes, last) = frame_passes(b, sky, &scene, Target::color(color), [color, depth, out]);
        b.run(&passes).unwrap();
        let pixels = b.read(last).unwrap();
        free(b, [color, depth, out]);
        (passes, pixels)
    }

    pub fn draw(&self, b: &mut dyn Backend, sky: &mut SkyRenderer) -> Vec<f32> {
        self.run(b, sky).1
    }

    pub fn draw_fresh(&self, b: &mut dyn Backend) -> Vec<f32> {
        let mut sky = SkyRenderer::default();
        let pixels = self.draw(b, &mut sky);
        sky.destroy(b);
        pixels
    }
}

/// A change of one input, by its name.
pub type Change = (String, Box<dyn Fn(&mut World)>);

fn change(name: impl Into<String>, f: impl Fn(&mut World) + 'static) -> Change {
    (name.into(), Box::new(f))
}

/// One input each.
pub fn changes() -> Vec<Change> {
    let mut all = vec![
        change("planet radius", |w| {
            w.view.params.planet_radius *= 1.01;
            w.view.params.atmosphere_radius *= 1.01;
        }),
        change("lowest ground", |w| w.view.params.lowest_ground -= 430.0),
        change("atmosphere radius", |w| w.view.params.atmosphere_radius += 5e3),
        change("rayleigh scale height", |w| w.view.params.rayleigh_scale_height *= 1.1),
        change("mie scale height", |w| w.view.params.mie_scale_height *= 1.5),
        change("mie phase", |w| w.view.params.mie_phase = MiePhase::CornetteShanks),
        change("ozone altitude", |w| w.view.params.ozone_center_altitude += 3e3),
        change("ozone width", |w| w.view.params.ozone_half_width *= 0.8),
        change("sun intensity", |w| w.view.params.sun_intensity *= 1.5),
        change("sun radius", |w| w.view.params.sun_angular_radius *= 1.5),
        change("no gas", |w| w.view.params.rayleigh_scattering = [0.0; 3]),
        change("no ozone", |w| w.view.params.ozone_absorption = [0.0; 3]),
        change("no aerosol", |w| {
            w.view.params.mie_scattering = [0.0; 3];
            w.view.params.mie_absorption = [0.0; 3];
        }),
        change("mars", |w| w.view.params = AtmosphereParams::mars()),
        change("venus", |w| w.view.params = AtmosphereParams::venus()),
        change("sun", |w| w.view.sun_elevation = 14.9),
        change("sun below the horizon", |w| w.view.sun_elevation = -3.0),
        change("altitude", |w| w.view.altitude += 50.0),
        change("below the ground", |w| w.view.altitude = -50.0),
        change("orbit", |w| w.view.altitude = 4e5),
        change("heading", |w| w.view.heading = 20.0),
        change("pitch", |w| w.view.pitch = 2.0),
        change("field of view", |w| w.view.fov = 50.0),
        change("size", |w| w.size = [11, 8]),
        change("render scale", |w| w.sky.render_scale = 0.5),
        change("disk", |w| w.sky.look.sun_disk = false),
        change("sky dome", |w| w.sky.look.composition = Composition::SkyDome),
        change("one pass", |w| w.sky.look.composition = Composition::AtmospherePost),
        change("shell", |w| w.sky.look.composition = Composition::Planet),
        change("off", |w| w.sky.look.enabled = false),
        change("single scattering", |w| w.sky.quality = Quality::March { view_samples: 4, light_samples: 2 }),
        change("columns", |w| w.lut.transmittance = [32, 16]),
        change("moments", |w| w.lut.multi_scattering = [12, 10]),
        change("moment steps", |w| w.lut.multi_scattering_steps = 6),
        change("orders", |w| w.lut.orders = 1),
        change("one order more", |w| w.lut.orders += 1),
        change("sky", |w| w.lut.sky_view = [12, 16]),
        change("sky steps", |w| w.lut.sky_view_steps = 7),
        change("air", |w| w.lut.aerial = [8, 12, 8]),
        change("air steps", |w| w.lut.aerial_steps = 2),
    ];
    for c in 0..3 {
        all.push(change(format!("rayleigh scattering {c}"), move |w| {
            w.view.params.rayleigh_scattering[c] *= 1.05
        }));
        all.push(change(format!("mie scattering {c}"), move |w| w.view.params.mie_scattering[c] *= 3.0));
        all.push(change(format!("mie absorption {c}"), move |w| w.view.params.mie_absorption[c] *= 3.0));
        all.push(change(format!("mie asymmetry {c}"), move |w| w.view.params.mie_asymmetry[c] = 0.7));
        all.push(change(format!("ozone absorption {c}"), move |w| w.view.params.ozone_absorption[c] *= 2.0));
        all.push(change(format!("albedo {c}"), move |w| w.view.params.ground_albedo[c] = 0.5));
    }
    all
}

/// A whole picture's radiance and display values, by a renderer that may have drawn others.
pub fn whole_picture(
    b: &mut dyn Backend,
    renderer: &mut PictureRenderer,
    world: &World,
    settings: &PictureSettings,
) -> [Vec<f32>; 2] {
    let settings = PictureSettings { sky: world.sky(), ..*settings };
    draw_both(b, renderer, &world.view.scene(), &settings, world.size)
}

/// The same by a new renderer.
pub fn fresh_picture(b: &mut dyn Backend, world: &World, settings: &PictureSettings) -> [Vec<f32>; 2] {
    let mut fresh = PictureRenderer::default();
    let pixels = whole_picture(b, &mut fresh, world, settings);
    fresh.destroy(b);
    pixels
}
