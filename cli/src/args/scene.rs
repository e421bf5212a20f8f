//! What is there: planet, camera, sun and moon. [`SceneArgs::scene`] alone turns options into a [`Scene`].

use clap::Args;
use glam::DVec3;
use welkin::model::moon::{MOON_RADIUS, Moon};
use welkin::{AtmosphereParams, Scene, TerrainStyle};

use crate::args::usage::UsageError;
use crate::args::values::{self, Length, degrees, number};
use crate::ephemeris;
use crate::sun;
use crate::views::{self, Place, View};

/// Farthest camera, metres.
const MAX_ALTITUDE: f64 = 1e12;
/// Pixels of a picture whose size nobody asked for.
const SIZE: [u32; 2] = [1280, 720];

/// The heading of the options that place the camera.
const VIEW: &str = "View";
/// The heading of the options that place the sun.
pub const SUN: &str = "Sun (by angles, or by place and time)";
/// The heading of the options that shape the picture.
const PICTURE: &str = "Picture";

/// The planet of a scene.
#[derive(Args, Debug, Default)]
pub struct PlanetArgs {
    /// The planet and its air [default: earth]
    #[arg(long, value_name = "NAME", value_parser = values::planet())]
    planet: Option<&'static str>,
}

impl PlanetArgs {
    /// The planet that was named, or `default`.
    pub fn or(&self, default: &'static str) -> &'static str {
        self.planet.unwrap_or(default)
    }
}

/// The options of which any one asks for a single picture. (A group with a flattened part has no members of
/// its own accord.)
const SINGLE: [&str; 13] = [
    "view",
    "planet",
    "altitude",
    "lowest_ground",
    "pitch",
    "heading",
    "fov",
    "sun_elevation",
    "sun_azimuth",
    "place",
    "time",
    "size",
    "exposure",
];

/// Options of which any one asks for a single picture: what it shows, and its frame.
#[derive(Args, Debug, Default)]
#[group(id = "scene", args = SINGLE)]
pub struct SceneArgs {
    /// Start from this view of the contact sheet
    #[arg(long, value_name = "NAME", help_heading = VIEW, value_parser = values::view())]
    view: Option<&'static View>,

    #[command(flatten, next_help_heading = VIEW)]
    planet: PlanetArgs,

    /// Height above the ground (sea level with --no-terrain): metres, or as in 15km [default: 100m]
    #[arg(long, value_name = "LENGTH", help_heading = VIEW, allow_hyphen_values = true)]
    #[arg(value_parser = values::length)]
    altitude: Option<Length>,

    /// Altitude of the lowest ground, down to which the sky goes on, as in -430m [default: 0m]
    #[arg(long, value_name = "LENGTH", help_heading = VIEW, allow_hyphen_values = true)]
    #[arg(value_parser = values::length)]
    lowest_ground: Option<Length>,

    /// Degrees above the horizontal that the camera looks, -90 to 90 [default: 10]
    #[arg(long, value_name = "DEGREES", help_heading = VIEW, allow_hyphen_values = true)]
    #[arg(value_parser = degrees(-90.0, 90.0))]
    pitch: Option<f64>,

    /// Where the camera looks: 0 is north, 90 east; -360 to 360 [default: 180]
    #[arg(long, value_name = "DEGREES", help_heading = VIEW, allow_hyphen_values = true)]
    #[arg(value_parser = degrees(-360.0, 360.0))]
    heading: Option<f64>,

    /// Vertical field of view, 0.01 to 179 degrees [default: 60]
    #[arg(long, value_name = "DEGREES", help_heading = VIEW, allow_hyphen_values = true)]
    #[arg(value_parser = degrees(0.01, 179.0))]
    fov: Option<f64>,

    /// Degrees of the sun above the horizontal, -90 to 90 [default: 30]
    #[arg(long, value_name = "DEGREES", help_heading = SUN)]
    #[arg(allow_hyphen_values = true, value_parser = degrees(-90.0, 90.0))]
    sun_elevation: Option<f64>,

    /// Where the sun stands: 0 is north, 90 east; -360 to 360 [default: 180]
    #[arg(long, value_name = "DEGREES", help_heading = SUN)]
    #[arg(allow_hyphen_values = true, value_parser = degrees(-360.0, 360.0))]
    sun_azimuth: Option<f64>,

    /// Latitude north and longitude east in degrees, as in 46.5,8.0; needs --time
    ///
    /// The sun then stands where the ephemeris has it, without refraction.
    #[arg(
        long, value_name = "LAT,LON", help_heading = SUN, allow_hyphen_values = true,
        value_parser = values::place
    )]
    place: Option<Place>,

    /// Time in RFC 3339, as in 2024-06-20T20:51:00Z; needs --place
    #[arg(
        long, value_name = "TIME", help_heading = SUN, allow_hyphen_values = true,
        value_parser = values::time
    )]
    time: Option<jiff::Timestamp>,

    /// Put the moon where it stood, too; needs --place and --time, years 1900 to 2099
    ///
    /// It is drawn with its phase, hides the sun's disk, whose edge is then darker, and its shadow falls on
    /// the ground and through the air. With --backend cpu for light scattered once.
    #[arg(long, help_heading = SUN, requires_all = ["place", "time"])]
    moon: bool,

    /// Pixels, as in 1920x1080; each side 1 to 8192, at most 33,554,432 in all [default: 1280x720]
    #[arg(
        long, value_name = "WxH", help_heading = PICTURE, allow_hyphen_values = true,
        value_parser = values::size
    )]
    size: Option<[u32; 2]>,

    /// Multiplies radiance before tone mapping, 1e-6 to 1e6: 2 is one stop brighter [default: the view's, or
    /// 1]
    #[arg(long, value_name = "FACTOR", help_heading = PICTURE, allow_hyphen_values = true)]
    #[arg(value_parser = number(1e-6, 1e6, ""))]
    exposure: Option<f64>,
}

/// A scene that was checked, with what a picture of it needs beside it.
#[derive(Clone, Debug)]
pub struct FramedScene {
    /// Camera and sun as the options have them, for captions and the exposure.
    pub view: View,
    /// Planet, air, camera, sun and moon.
    pub scene: Scene,
    /// The ground's look; `None` leaves it a smooth sphere.
    pub terrain: Option<TerrainStyle>,
    /// Width and height in pixels.
    pub size: [u32; 2],
}

impl SceneArgs {
    /// The scene that these options ask for, the rest as in the view that they start from.
    pub fn scene(&self, terrain: bool) -> Result<FramedScene, UsageError> {
        let (mut view, size) = (self.view(), self.size.unwrap_or(SIZE));
        self.check_altitude(&view)?;
        let place_and_time = self.place_and_sun(&mut view)?;
        let place = place_and_time.map_or(Place::DEFAULT, |(place, _)| place);
        let terrain = terrain.then(|| view.terrain());
        let [width, height] = size;
        let mut scene =
            view.scene(place, f64::from(width) / f64::from(height), terrain.as_ref()).map_err(|e| match e
                .into_kind()
            {
                welkin::ErrorKind::Invalid { field, value, allowed }
                    if field.starts_with("camera.tangents") =>
                {
                    UsageError::new(format!(
                        "'--fov <DEGREES>' {} and '--size <WxH>' {width}x{height} make too wide a view: \
                         its edge lies at {value} (tangent of the angle), must be {allowed}",
                        view.fov
                    ))
                }
                other => UsageError::new(other.to_string()),
            })?;
        if let Some(lowest) = &self.lowest_ground {
            scene.atmosphere.lowest_ground = lowest.metres;
            scene.atmosphere.validate().map_err(|_| {
                let least = views::length(-0.1 * scene.atmosphere.planet_radius);
                let allowed = format_args!("from {least} (a tenth of the planet's radius) to 0 m");
                UsageError::value("--lowest-ground <LENGTH>", &lowest.text, allowed)
            })?;
        }
        if let (true, Some((place, time))) = (self.moon, place_and_time) {
            place_moon(&mut scene, place, time)?;
        }
        Ok(FramedScene { view, scene, terrain, size })
    }

    /// The view that the options start from, with what they change of it. The sun may be moved later, by
    /// place and time.
    fn view(&self) -> View {
        let base = self.view.unwrap_or(&views::DEFAULT);
        View {
            planet: self.planet.or(base.planet),
            altitude: self.altitude.as_ref().map_or(base.altitude, |a| a.metres),
            pitch: self.pitch.unwrap_or(base.pitch),
            heading: self.heading.unwrap_or(base.heading),
            fov: self.fov.unwrap_or(base.fov),
            sun_elevation: self.sun_elevation.unwrap_or(base.sun_elevation),
            sun_azimuth: self.sun_azimuth.unwrap_or(base.sun_azimuth),
            exposure: self.exposure.map_or(base.exposure, |e| e as f32),
            ..*base
        }
    }

    fn check_altitude(&self, view: &View) -> Result<(), UsageError> {
        let radius =
            AtmosphereParams::preset(view.planet).map_err(|e| UsageError::new(e.to_string()))?.planet_radius;
        let lowest = -0.5 * radius;
        if view.altitude >= lowest && view.altitude <= MAX_ALTITUDE {
            return Ok(());
        }
        let text = self.altitude.as_ref().map_or_else(|| views::length(view.altitude), |a| a.text.clone());
        Err(UsageError::value(
            "--altitude <LENGTH>",
            text,
            format_args!(
                "from {} (half the radius of {} down) to {}",
                views::length(lowest),
                view.planet,
                views::length(MAX_ALTITUDE)
            ),
        ))
    }

    /// Puts the sun where place and time have it, if they were given; returns them.
    fn place_and_sun(&self, view: &mut View) -> Result<Option<(Place, jiff::Timestamp)>, UsageError> {
        let angle = [("--sun-elevation", self.sun_elevation), ("--sun-azimuth", self.sun_azimuth)];
        let angle = angle.into_iter().find_map(|(name, value)| value.map(|v| format!("{name} {v}")));
        let by_place = [("--place", self.place.is_some()), ("--time", self.time.is_some())];
        let by_place = by_place.into_iter().find_map(|(name, given)| given.then_some(name));
        if let (Some(angle), Some(by_place)) = (angle, by_place) {
            return Err(UsageError::new(format!(
                "'{angle}' cannot be used with '{by_place}': the sun stands either at --sun-elevation and \
                 --sun-azimuth, or where --place and --time put it"
            )));
        }
        match (self.place, self.time) {
            (None, None) => Ok(None),
            (Some(_), None) => Err(UsageError::new(
                "'--place <LAT,LON>' needs '--time <TIME>', as in --time 2024-06-20T20:51:00Z: \
                 together they say where the sun stands",
            )),
            (None, Some(_)) => Err(UsageError::new(
                "'--time <TIME>' needs '--place <LAT,LON>', as in --place 46.5,8.0: \
                 together they say where the sun stands",
            )),
            (Some(place), Some(time)) => {
                if !view.planet.starts_with("earth") {
                    return Err(UsageError::value(
                        "--planet <NAME>",
                        view.planet,
                        "earth or earth-like with '--time <TIME>': the ephemeris is the Earth's",
                    ));
                }
                let sun = sun::position(time, place, 0.0).map_err(|e| {
                    UsageError::value("--time <TIME>", time, format_args!("one that SPA covers: {e}"))
                })?;
                (view.sun_elevation, view.sun_azimuth) = (sun.elevation, sun.azimuth);
                Ok(Some((place, time)))
            }
        }
    }
}

/// Puts the moon, and with the same ephemeris the sun, where they stood.
fn place_moon(scene: &mut Scene, place: Place, time: jiff::Timestamp) -> Result<(), UsageError> {
    let bodies = ephemeris::bodies(time, place, 0.0)
        .map_err(|_| UsageError::value("--time <TIME>", time, "in the years 1900 to 2099 with '--moon'"))?;
    let [up, north, east] = place.frame();
    let turn = |v: DVec3| east * v.x + north * v.y + up * v.z;
    // As seen from sea level at the place, wherever above it the camera is.
    let moon = up * scene.atmosphere.planet_radius + turn(bodies.moon);
    scene.moon = Some(Moon::new(moon, MOON_RADIUS));
    scene.sun_direction = turn(bodies.sun);
    scene.atmosphere.sun_angular_radius = bodies.disks().sun;
    scene.validate().map_err(|e| UsageError::new(e.to_string()))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use clap::{FromArgMatches, Parser};

    use super::*;

    #[derive(Parser)]
    struct Options {
        #[command(flatten)]
        scene: Option<SceneArgs>,
    }

    /// The contact sheet is drawn unless one of them is given: none may be forgotten in the group.
    #[test]
    fn each_of_the_options_asks_for_a_single_picture() {
        let given = |args: &[&str]| Options::parse_from(["test"].iter().chain(args)).scene.is_some();
        assert!(!given(&[]));
        for (option, value) in [
            ("--view", "noon"),
            ("--planet", "mars"),
            ("--altitude", "2km"),
            ("--lowest-ground", "-430m"),
            ("--pitch", "1"),
            ("--heading", "1"),
            ("--fov", "1"),
            ("--sun-elevation", "1"),
            ("--sun-azimuth", "1"),
            ("--place", "1,2"),
            ("--time", "2024-06-20T20:51:00Z"),
            ("--size", "4x4"),
            ("--exposure", "2"),
        ] {
            assert!(given(&[option, value]), "{option}");
        }
        let command = <Options as clap::CommandFactory>::command();
        let takes_values = command.get_arguments().filter(|arg| arg.get_action().takes_values()).count();
        assert_eq!(takes_values, SINGLE.len(), "an option that this test does not know");
        let none = command.try_get_matches_from(["test"]).unwrap();
        assert!(Options::from_arg_matches(&none).is_ok());
    }

    #[test]
    fn without_options_it_is_the_default_view() {
        let framed = SceneArgs::default().scene(true).unwrap();
        assert_eq!((framed.view, framed.size), (views::DEFAULT, SIZE));
        assert!(framed.terrain.is_some() && framed.scene.moon.is_none());
    }
}
