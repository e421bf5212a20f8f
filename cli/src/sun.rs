//! Where the sun stands above a place on Earth at a time.

use solar_positioning::time::JulianDate;
use solar_positioning::{Location, RefractionCorrection, SolarPositions, delta_t};

use crate::views::Place;

/// Degrees: elevation above the horizontal, azimuth from north towards east.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// The angle above the horizontal.
    pub elevation: f64,
    /// The direction, from north towards east.
    pub azimuth: f64,
}

/// The sun's geometric position by NREL's Solar Position Algorithm (Reda & Andreas 2003).
///
/// Refraction is left out: the renderer's rays are straight. `height` is in metres.
pub fn position(time: jiff::Timestamp, place: Place, height: f64) -> anyhow::Result<Sun> {
    position_with(time, place, height, None)
}

fn position_with(
    time: jiff::Timestamp,
    place: Place,
    height: f64,
    refraction: Option<RefractionCorrection>,
) -> anyhow::Result<Sun> {
    // Julian date of the Unix epoch, in days of 86 400 s as both time scales count them.
    let days = time.as_millisecond() as f64 / 86_400_000.0;
    let delta_t = delta_t::estimate(1970.0 + days / 365.2425)?;
    let time = JulianDate::new(2_440_587.5 + days, delta_t)?;
    let location = Location { latitude: place.latitude, longitude: place.longitude };
    let sun = SolarPositions::new().at_from_julian(time, location, height, refraction)?;
    Ok(Sun { elevation: sun.elevation_angle(), azimuth: sun.azimuth() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time: &str) -> jiff::Timestamp {
        time.parse().unwrap()
    }

    /// Reda & Andreas, "Solar Position Algorithm for Solar Radiation Applications", NREL/TP-560-34302
    /// (2003, revised 2008), table A5.1: zenith 50.11162°, azimuth 194.34024°. The report's ΔT is 67 s
    /// where the estimate says 64.6 s, in which the sun moves 3e-5°.
    #[test]
    fn nrel_example() {
        let place = Place { latitude: 39.742476, longitude: -105.1786 };
        let air = RefractionCorrection::new(820.0, 11.0).unwrap();
        let sun = position_with(at("2003-10-17T12:30:30-07:00"), place, 1830.14, Some(air)).unwrap();
        assert!((90.0 - sun.elevation - 50.11162).abs() < 5e-5, "{sun:?}");
        assert!((sun.azimuth - 194.34024).abs() < 5e-5, "{sun:?}");
    }

    /// Seen from the north pole the sun's elevation is its declination less 8.8″ of parallax.
    ///
    /// Meeus, "Astronomical Algorithms" (2nd ed. 1998), example 25.b: 1992 October 13, 0h TD,
    /// apparent declination −7°47′01.74″.
    #[test]
    fn declination_of_meeus_example() {
        let pole = Place { latitude: 90.0, longitude: 0.0 };
        // 0h TD is 59 s before 0h UT.
        let sun = position(at("1992-10-12T23:59:01Z"), pole, 0.0).unwrap();
        let declination = -(7.0 + 47.0 / 60.0 + 1.74 / 3600.0);
        assert!((sun.elevation + 8.8 / 3600.0 - declination).abs() < 3e-4, "{sun:?} {declination}");
    }

    /// US Naval Observatory, "Earth's Seasons": equinox 2024 March 20 03:06 UT, solstice June 20 20:51 UT.
    #[test]
    fn equinox_and_solstice() {
        let pole = Place { latitude: 90.0, longitude: 0.0 };
        let equinox = position(at("2024-03-20T03:06:00Z"), pole, 0.0).unwrap().elevation + 8.8 / 3600.0;
        assert!(equinox.abs() < 5e-4, "{equinox}");
        let around = ["2024-06-19T20:51:00Z", "2024-06-20T20:51:00Z", "2024-06-21T20:51:00Z"];
        let [before, solstice, after] = around.map(|t| position(at(t), pole, 0.0).unwrap().elevation);
        assert!(before < solstice && after < solstice, "{before} {solstice} {after}");
        // Obliquity of the ecliptic in 2024 (IAU 2006): 23.4362°.
        assert!((solstice + 8.0 / 3600.0 - 23.4362).abs() < 4e-3, "{solstice}");
    }
}
