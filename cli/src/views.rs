//! The views that the contact sheet, the tests and the documentation share.

use glam::DVec3;
use welkin::model::scene::Pose;
use welkin::{AtmosphereParams, Camera, DepthConvention, Scene, TerrainStyle};

/// A camera and a sun above a planet. Angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// What `--view` calls it.
    pub name: &'static str,
    /// What a caption calls it.
    pub title: &'static str,
    /// A preset of [`AtmosphereParams::preset`].
    pub planet: &'static str,
    /// Metres above the ground.
    pub altitude: f64,
    /// How far above the horizontal the camera looks.
    pub pitch: f64,
    /// Where the camera looks, from north towards east.
    pub heading: f64,
    /// Vertical field of view.
    pub fov: f64,
    /// How far the sun stands above the horizontal at the camera's place.
    pub sun_elevation: f64,
    /// Where the sun stands, from north towards east.
    pub sun_azimuth: f64,
    /// Radiance is multiplied by this before tone mapping.
    pub exposure: f32,
}

/// Where on the planet the camera stands, degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Latitude, north of the equator.
    pub latitude: f64,
    /// Longitude, east of Greenwich.
    pub longitude: f64,
}

impl Place {
    /// Where a view is seen from unless a place is asked for: on the demonstration terrain's sea, with
    /// mountains to the west and south.
    pub const DEFAULT: Self = Self { latitude: -15.2, longitude: 37.4 };

    /// Unit vectors up, north and east. The planet's axis is +Z and longitude 0 lies towards +X.
    ///
    /// At a pole north is along the meridian that the longitude names.
    pub fn frame(self) -> [DVec3; 3] {
        let (sin_lat, cos_lat) = self.latitude.to_radians().sin_cos();
        let (sin_lon, cos_lon) = self.longitude.to_radians().sin_cos();
        let up = DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat);
        let north = DVec3::new(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat);
        let east = DVec3::new(-sin_lon, cos_lon, 0.0);
        [up, north, east]
    }
}

impl View {
    /// The scene of this view with the planet's centre at the origin. Checked. The camera's altitude counts
    /// from the ground where there is some, so that nobody stands inside a mountain.
    pub fn scene(&self, place: Place, aspect: f64, ground: Option<&TerrainStyle>) -> welkin::Result<Scene> {
        let atmosphere = AtmosphereParams::preset(self.planet)?;
        let [up, north, east] = place.frame();
        let pose = Pose {
            altitude: self.altitude + ground.map_or(0.0, |g| g.height(up, atmosphere.planet_radius).0),
            pitch: self.pitch.to_radians(),
            heading: self.heading.to_radians(),
            fov_y: self.fov.to_radians(),
        };
        let camera = Camera::above(DVec3::ZERO, atmosphere.planet_radius, up, north, pose, aspect)?;
        let (sin_el, cos_el) = self.sun_elevation.to_radians().sin_cos();
        let (sin_az, cos_az) = self.sun_azimuth.to_radians().sin_cos();
        let scene = Scene {
            camera,
            planet_center: DVec3::ZERO,
            atmosphere,
            sun_direction: (north * cos_az + east * sin_az) * cos_el + up * sin_el,
            depth: DepthConvention::default(),
            moon: None,
            ellipsoid: None,
        };
        scene.validate()?;
        Ok(scene)
    }

    /// The ground of this view's planet.
    pub fn terrain(&self) -> TerrainStyle {
        match AtmosphereParams::preset(self.planet) {
            Ok(params) if !self.planet.starts_with("earth") => TerrainStyle::dry(&params),
            _ => TerrainStyle::earth(),
        }
    }

    /// Altitude, sun and field of view in words of Latin-1, for a caption.
    pub fn caption(&self) -> String {
        format!("{} · sun {}° · view {}°", length(self.altitude), self.sun_elevation, self.fov)
    }
}

/// A length in metres, or in kilometres from 1000 m, with commas between the thousands.
pub fn length(metres: f64) -> String {
    if metres.abs() < 1000.0 {
        return format!("{} m", (metres * 10.0).round() / 10.0);
    }
    let km = (metres / 100.0).round() / 10.0;
    let whole = km.abs().trunc();
    let digits = format!("{whole}");
    let mut text = String::new();
    for (i, d) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(d);
    }
    let tenth = (km.abs() - whole) * 10.0;
    let sign = if km < 0.0 { "-" } else { "" };
    if tenth.round() > 0.0 { format!("{sign}{text}.{tenth:.0} km") } else { format!("{sign}{text} km") }
}

/// What a single picture shows where nothing else is said.
pub const DEFAULT: View = View {
    name: "default",
    title: "Ground",
    planet: "earth",
    altitude: 100.0,
    pitch: 10.0,
    heading: 180.0,
    fov: 60.0,
    sun_elevation: 30.0,
    sun_azimuth: 180.0,
    exposure: 1.0,
};

/// The panels of the contact sheet, in reading order; the last one is drawn by every backend.
pub const VIEWS: [View; 9] = [
    View {
        name: "noon",
        title: "Earth: ground, noon",
        pitch: 12.0,
        sun_elevation: 60.0,
        sun_azimuth: 150.0,
        exposure: 0.4,
        ..DEFAULT
    },
    View {
        name: "sunset",
        title: "Earth: ground, sunset",
        pitch: 8.0,
        heading: 270.0,
        fov: 50.0,
        sun_elevation: 1.5,
        sun_azimuth: 270.0,
        exposure: 0.8,
        ..DEFAULT
    },
    View {
        name: "dusk",
        title: "Earth: ground, dusk",
        pitch: 12.0,
        heading: 270.0,
        sun_elevation: -5.0,
        sun_azimuth: 270.0,
        exposure: 15.0,
        ..DEFAULT
    },
    View {
        name: "stratosphere",
        title: "Earth: stratosphere",
        altitude: 15_000.0,
        pitch: 4.0,
        sun_elevation: 30.0,
        sun_azimuth: 240.0,
        exposure: 0.5,
        ..DEFAULT
    },
    // The horizon lies acos(R / (R + h)) = 19.8° below the horizontal.
    View {
        name: "limb",
        title: "Earth: limb",
        altitude: 400e3,
        pitch: -20.0,
        heading: 0.0,
        fov: 40.0,
        sun_elevation: 25.0,
        sun_azimuth: 60.0,
        exposure: 0.35,
        ..DEFAULT
    },
    // The planet's disk is 2 asin(R / (R + h)) = 40.5° wide.
    View {
        name: "planet",
        title: "Earth: whole planet",
        altitude: 12_000e3,
        pitch: -90.0,
        heading: 0.0,
        fov: 44.0,
        sun_elevation: 35.0,
        sun_azimuth: 60.0,
        exposure: 0.35,
        ..DEFAULT
    },
    View {
        name: "mars-day",
        title: "Mars: ground, day",
        planet: "mars",
        pitch: 8.0,
        sun_elevation: 40.0,
        sun_azimuth: 230.0,
        exposure: 0.8,
        ..DEFAULT
    },
    View {
        name: "mars-sunset",
        title: "Mars: ground, sunset",
        planet: "mars",
        pitch: 6.0,
        heading: 270.0,
        fov: 40.0,
        sun_elevation: 3.0,
        sun_azimuth: 270.0,
        exposure: 0.7,
        ..DEFAULT
    },
    View {
        name: "summit",
        title: "Earth: summit height",
        altitude: 5000.0,
        pitch: 2.0,
        heading: 230.0,
        fov: 50.0,
        sun_elevation: 8.0,
        sun_azimuth: 250.0,
        exposure: 0.7,
        ..DEFAULT
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_view_makes_a_valid_scene() {
        for view in &VIEWS {
            let scene = view.scene(Place::DEFAULT, 1.6, None).unwrap();
            let zenith = scene.validate().unwrap();
            assert!((zenith.altitude - view.altitude).abs() < 1e-3, "{}", view.name);
            let elevation = zenith.sun.z.asin().to_degrees();
            assert!((elevation - view.sun_elevation).abs() < 1e-9, "{}: sun at {elevation}", view.name);
            assert_eq!(VIEWS.iter().filter(|v| v.name == view.name).count(), 1, "{}", view.name);
        }
    }

    #[test]
    fn north_is_towards_the_axis_and_east_is_to_its_right() {
        for place in [Place::DEFAULT, Place { latitude: -33.9, longitude: 151.2 }] {
            let [up, north, east] = place.frame();
            assert!(north.z > 0.0 && east.z.abs() < 1e-12);
            assert!((north.cross(up) - east).length() < 1e-12);
        }
        // Both poles have a frame, and a camera.
        for latitude in [-90.0, 90.0] {
            VIEWS[0].scene(Place { latitude, longitude: 20.0 }, 1.6, None).unwrap();
        }
    }

    #[test]
    fn sun_is_in_the_middle_when_the_camera_looks_at_it() {
        let view = View { heading: 250.0, pitch: 8.0, sun_azimuth: 250.0, sun_elevation: 8.0, ..DEFAULT };
        let scene = view.scene(Place::DEFAULT, 1.6, None).unwrap();
        assert!((scene.camera.forward.normalize() - scene.sun_direction.normalize()).length() < 1e-9);
    }

    #[test]
    fn lengths_read_well() {
        for (metres, text) in [
            (100.0, "100 m"),
            (-430.0, "-430 m"),
            (1500.0, "1.5 km"),
            (15_000.0, "15 km"),
            (12_000e3, "12,000 km"),
            (1e9, "1,000,000 km"),
        ] {
            assert_eq!(length(metres), text);
        }
    }
}
