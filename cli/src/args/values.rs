//! What is accepted as an option's value: one parser for each kind, whose error says what is allowed.

use std::time::Duration;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use welkin::AtmosphereParams;

use crate::views::{Place, VIEWS, View};

/// Most pixels along one side of a picture: the smallest limit of WebGPU and of WebGL2 in practice.
const MAX_SIDE: u32 = 8192;
/// Most pixels in a picture; 16 bytes of radiance each.
const MAX_PIXELS: u64 = 1 << 25;

/// A length and how it was written.
#[derive(Clone, Debug)]
pub struct Length {
    /// The length in metres.
    pub metres: f64,
    /// The words of the command line, for errors.
    pub text: String,
}

/// A parser of finite numbers in `lo..=hi`.
pub fn number(
    lo: f64,
    hi: f64,
    unit: &'static str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        let value: f64 = text.trim().parse().unwrap_or(f64::NAN);
        let allowed = (lo..=hi).contains(&value);
        allowed.then_some(value).ok_or_else(|| format!("must be a number from {lo:?} to {hi:?}{unit}"))
    }
}

/// A parser of finite numbers of degrees in `lo..=hi`.
pub fn degrees(lo: f64, hi: f64) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    number(lo, hi, " degrees")
}

/// A length in metres, or a number with the unit m or km.
pub fn length(text: &str) -> Result<Length, String> {
    let trimmed = text.trim();
    let (digits, unit) = if let Some(digits) = trimmed.strip_suffix("km") {
        (digits, 1000.0)
    } else {
        (trimmed.strip_suffix('m').unwrap_or(trimmed), 1.0)
    };
    let value: Option<f64> = digits.trim_end().parse().ok().filter(|v: &f64| v.is_finite());
    let metres = value.map(|v| v * unit).filter(|v| v.is_finite());
    let metres = metres.ok_or("must be a number of metres, or one with a unit as in 400m or 15km")?;
    Ok(Length { metres, text: trimmed.to_owned() })
}

/// Degrees north and east with a comma between.
pub fn place(text: &str) -> Result<Place, String> {
    let allowed =
        "must be LAT,LON: degrees north from -90 to 90 and degrees east from -180 to 180, as in 46.5,8.0";
    let (latitude, longitude) = text.split_once(',').ok_or(allowed)?;
    let latitude = number(-90.0, 90.0, "")(latitude).map_err(|_| allowed)?;
    let longitude = number(-180.0, 180.0, "")(longitude).map_err(|_| allowed)?;
    Ok(Place { latitude, longitude })
}

/// A date, a time and an offset in RFC 3339.
pub fn time(text: &str) -> Result<jiff::Timestamp, String> {
    let allowed = "must be a date, a time and an offset in RFC 3339, as in 2024-06-20T20:51:00Z";
    let time: jiff::Timestamp = text.trim().parse().map_err(|_| allowed)?;
    // Four digits and no sign, as RFC 3339 has it; ΔT is known for all of them.
    let year = time.to_zoned(jiff::tz::TimeZone::UTC).year();
    if (0..=2999).contains(&year) { Ok(time) } else { Err("must be in the years 0000 to 2999".to_owned()) }
}

/// The width and the height of a picture in pixels.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |s: &str| s.trim().parse().ok().filter(|n| (1..=MAX_SIDE).contains(n));
    let size = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([side(w)?, side(h)?]));
    let size = size.filter(|[w, h]| u64::from(*w) * u64::from(*h) <= MAX_PIXELS);
    size.ok_or_else(|| {
        format!(
            "must be WIDTHxHEIGHT, each from 1 to {MAX_SIDE} and at most {MAX_PIXELS} pixels in all, as \
             in 1920x1080"
        )
    })
}

/// A time above 0 with a unit.
pub fn duration(text: &str) -> Result<Duration, String> {
    let time: Option<jiff::SignedDuration> = text.trim().parse().ok();
    let time = time.and_then(|t| Duration::try_from(t).ok()).filter(|t| !t.is_zero());
    time.ok_or_else(|| "must be a time above 0 with a unit, as in 5ms, 0.5ms or 1s".to_owned())
}

/// A parser of whole numbers from 1 to `most`.
pub fn count(most: u32) -> impl Fn(&str) -> Result<u32, String> + Clone + Send + Sync {
    move |text| {
        let value = text.trim().parse().ok().filter(|n| (1..=most).contains(n));
        value.ok_or_else(|| format!("must be a whole number from 1 to {most}"))
    }
}

/// A parser of the names of [`AtmosphereParams::PRESETS`].
pub fn planet() -> impl TypedValueParser<Value = &'static str> {
    let named =
        |name: String| AtmosphereParams::PRESETS.into_iter().find(|p| *p == name).ok_or("no such planet");
    PossibleValuesParser::new(AtmosphereParams::PRESETS).try_map(named)
}

/// A parser of the names of [`VIEWS`].
pub fn view() -> impl TypedValueParser<Value = &'static View> {
    let named = |name: String| VIEWS.iter().find(|v| v.name == name).ok_or("no such view");
    PossibleValuesParser::new(VIEWS.iter().map(|v| v.name)).try_map(named)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_with_and_without_a_unit() {
        for (text, metres) in [
            ("100", 100.0),
            ("-430m", -430.0),
            ("15km", 15e3),
            ("400 km", 4e5),
            ("1.5e3 m", 1500.0),
            ("12e3km", 12e6),
        ] {
            assert_eq!(length(text).unwrap().metres, metres, "{text}");
        }
        for text in ["", "m", "km", "nan", "inf", "12 miles", "1e308km"] {
            assert!(length(text).is_err(), "{text}");
        }
    }

    #[test]
    fn sizes() {
        assert_eq!(size("1920x1080"), Ok([1920, 1080]));
        assert_eq!(size("8192X4096"), Ok([8192, 4096]));
        for text in ["0x10", "10x0", "10", "10x", "-1x5", "8193x1", "8192x8192", "1.5x2", "99999999999x1"] {
            assert!(size(text).is_err(), "{text}");
        }
    }

    #[test]
    fn budgets_have_a_unit() {
        for (text, micros) in
            [("5ms", 5000), ("0.5ms", 500), ("16.6 ms", 16_600), ("250us", 250), ("1s", 1_000_000)]
        {
            assert_eq!(duration(text), Ok(Duration::from_micros(micros)), "{text}");
        }
        for text in ["", "5", "0ms", "-5ms", "fast", "nan", "infms", "5 lightyears"] {
            assert!(duration(text).is_err(), "{text}");
        }
    }

    #[test]
    fn times_need_an_offset() {
        assert!(time("2003-10-17T12:30:30-07:00").is_ok());
        for text in
            ["2003-10-17T12:30:30", "2003-10-17", "noon", "2003-13-01T00:00:00Z", "-000500-01-01T00:00:00Z"]
        {
            assert!(time(text).is_err(), "{text}");
        }
    }
}
