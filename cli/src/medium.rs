//! A medium that a file describes.

use std::path::Path;

use toml::{Table, Value};
use welkin::AtmosphereParams;

/// Reads a medium from a TOML file: the fields of [`AtmosphereParams`] by their names, in SI units. What is
/// left out is that of the preset that `base` names, earth without it.
///
/// The error names the field, its value and what is allowed, or the line that cannot be read.
pub fn read(path: &Path) -> Result<AtmosphereParams, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("cannot be read: {e}"))?;
    parse(&text)
}

fn parse(text: &str) -> Result<AtmosphereParams, String> {
    let mut given: Table = text.parse().map_err(|e: toml::de::Error| e.to_string().trim_end().to_owned())?;
    let base = match given.remove("base") {
        None => "earth".to_owned(),
        Some(Value::String(name)) => name,
        Some(other) => return Err(format!("base = {other} must be a preset's name, as in \"mars\"")),
    };
    let base = AtmosphereParams::preset(&base).map_err(|e| e.to_string().replacen("planet", "base", 1))?;
    let mut fields = Table::try_from(&base).map_err(|e| e.to_string())?;
    for (name, value) in given {
        let Some(field) = fields.get_mut(&name) else {
            let near = |known: &&String| strsim::jaro_winkler(&name, known);
            let nearest = fields.keys().max_by(|a, b| near(a).total_cmp(&near(b)));
            let nearest = nearest.map_or("", String::as_str);
            return Err(format!("'{name}' is no field of a medium; the nearest is {nearest}"));
        };
        let known = std::mem::replace(field, value);
        // One field at a time, so that an error has its name.
        medium_of(&fields).map_err(|reason| {
            let given = fields.get(&name).map(Value::to_string).unwrap_or_default();
            format!("{name} = {given} must be as in {known}: {reason}")
        })?;
    }
    let medium = medium_of(&fields)?;
    medium.validate().map_err(|e| e.to_string())?;
    Ok(medium)
}

fn medium_of(fields: &Table) -> Result<AtmosphereParams, String> {
    fields.clone().try_into().map_err(|e: toml::de::Error| e.message().trim_end().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_that_are_left_out_are_the_bases() {
        let haze = parse("mie_scattering = [1e-3, 1e-3, 1e-3]\nmie_phase = \"henyey-greenstein\"").unwrap();
        let earth = AtmosphereParams::earth();
        assert_eq!(haze.mie_scattering, [1e-3; 3]);
        assert_eq!((haze.mie_phase, haze.planet_radius), (welkin::MiePhase::HenyeyGreenstein, 6_360_000.0));
        assert_eq!(haze.rayleigh_scattering, earth.rayleigh_scattering);
        let deep = parse("base = \"mars\"\nlowest_ground = -7000").unwrap();
        assert_eq!(deep, AtmosphereParams { lowest_ground: -7e3, ..AtmosphereParams::mars() });
        assert_eq!(parse("").unwrap(), earth);
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, parts) in [
            ("mie_scatering = [1, 1, 1]", &["'mie_scatering'", "mie_scattering"][..]),
            ("mie_scattering = 1e-3", &["mie_scattering = 0.001", "as in ["]),
            ("mie_phase = \"rayleigh\"", &["mie_phase", "henyey-greenstein"]),
            ("planet_radius = -1.0", &["atmosphere.planet_radius", "-1", "100"]),
            ("base = \"moon\"", &["base", "moon", "earth, mars"]),
            ("base = 3", &["base = 3", "name"]),
            ("a = ", &["line 1"]),
        ] {
            let error = parse(text).unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{text}: {error}");
        }
    }
}
