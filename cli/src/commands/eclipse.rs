//! `welkin eclipse`: where sun and moon stand above a place, and how much of the sun the moon hides.

use std::io::Write;

use clap::Args;
use glam::DVec3;
use jiff::Timestamp;
use serde_json::json;
use welkin::model::moon::{Disks, Phase};

use crate::args::usage::UsageError;
use crate::args::values::{self, Length};
use crate::ephemeris::{self, Bodies, Eclipse, horizontal};
use crate::views::Place;

const ECLIPSE_DETAILS: &str = "\
elevation, azimuth  of the disks' middles, without refraction; 0° is north,
                    90° east
magnitude           fraction of the sun's diameter that is covered; where one
                    disk lies within the other, the ratio of their diameters
obscuration         fraction of the sun's disk that is covered
sunlight            what is left of the sun's light, its edge being darker
                    than its middle
Contacts are for a moon without mountains: k = 0.2725076 for partial, 0.272281
for total and annular phases. Places are heights above the ellipsoid WGS 84.
Times are good to a second or two from 1972 to the next leap second, beyond by
as much as the Earth's turning was guessed wrong.

Examples:
  welkin eclipse --place 25.29,-104.14 --time 2024-04-08T18:17:16Z
      The total eclipse over Nazas, Mexico
  welkin eclipse --place 35.08,-106.65 --time 2023-10-14T12:00:00Z --json
      The ring over Albuquerque, found from the morning on, for a program to read

Exit status: 0 printed; 1 printing failed; 2 the request was not accepted.";

/// Heights of a place, metres.
const HEIGHTS: std::ops::RangeInclusive<f64> = -1e3..=1e6;

/// Options of `welkin eclipse`.
#[derive(Args, Debug)]
#[command(after_long_help = ECLIPSE_DETAILS)]
#[command(after_help = "What the numbers mean, and examples: welkin eclipse --help")]
pub struct EclipseArgs {
    /// Latitude north and longitude east in degrees, as in 25.3,-104.1
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true, value_parser = values::place)]
    place: Place,

    /// Time in RFC 3339, years 1900 to 2099, as in 2024-04-08T18:17:16Z; the eclipse nearest to it, within 12
    /// hours
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = values::time)]
    time: Timestamp,

    /// Height above the ellipsoid WGS 84: metres, or as in 2km; -1 km to 1000 km
    #[arg(
        long, value_name = "LENGTH", default_value = "0m", allow_hyphen_values = true,
        value_parser = values::length
    )]
    height: Length,

    /// As JSON
    #[arg(long)]
    json: bool,
}

/// Computes and prints.
pub fn run(args: &EclipseArgs) -> anyhow::Result<()> {
    let (time, place, height) = (args.time, args.place, args.height.metres);
    if !HEIGHTS.contains(&height) {
        let allowed = "from -1 km to 1000 km";
        return Err(UsageError::value("--height <LENGTH>", &args.height.text, allowed).into());
    }
    let bodies = ephemeris::bodies(time, place, height)
        .map_err(|_| UsageError::value("--time <TIME>", time, "in the years 1900 to 2099"))?;
    let eclipse = ephemeris::eclipse(time, place, height)?;
    let text = if args.json {
        json(time, &bodies, eclipse.as_ref())?
    } else {
        words(time, &bodies, eclipse.as_ref())
    };
    writeln!(std::io::stdout().lock(), "{text}")?;
    Ok(())
}

fn name(phase: Phase) -> &'static str {
    match phase {
        Phase::None => "none",
        Phase::Partial => "partial",
        Phase::Annular => "annular",
        Phase::Total => "total",
    }
}

/// The fraction of the sun's light that arrives, per channel, in %.
fn light(disks: &Disks) -> [f64; 3] {
    disks.visible_limb_darkened().map(|v| 100.0 * v)
}

fn words(time: Timestamp, bodies: &Bodies, eclipse: Option<&Eclipse>) -> String {
    let disks = bodies.disks();
    let body = |name: &str, direction: DVec3, radius: f64| {
        let (elevation, azimuth) = horizontal(direction);
        format!("{name}{elevation:>10.4}°{azimuth:>10.4}°{:>10.2}'", radius.to_degrees() * 60.0)
    };
    let [r, g, b] = light(&disks);
    let mut lines = vec![
        format!("{time}"),
        "      elevation    azimuth      radius".to_owned(),
        body("sun ", bodies.sun, disks.sun),
        body("moon", bodies.moon, disks.moon),
        format!("separation   {:.3}'", disks.apart.to_degrees() * 60.0),
        format!("eclipse      {}", name(disks.phase())),
        format!("magnitude    {:.4}", bodies.magnitude()),
        format!("obscuration  {:.2} %", 100.0 * disks.obscuration()),
        format!("sunlight     {r:.3} % at 680 nm, {g:.3} % at 550 nm, {b:.3} % at 440 nm"),
        String::new(),
    ];
    let Some(e) = eclipse else {
        lines.push("No eclipse here within 12 hours.".to_owned());
        return lines.join("\n");
    };
    let kind = name(e.bodies.disks().phase());
    let mut times =
        vec![(format!("{kind} eclipse of magnitude {:.4}, greatest", e.bodies.magnitude()), e.greatest)];
    times.extend(["partial begins", "partial ends"].map(str::to_owned).into_iter().zip(e.partial));
    if let Some(central) = e.central {
        times.extend(["begins", "ends"].map(|what| format!("{kind} {what}")).into_iter().zip(central));
    }
    if let Some((_, greatest)) = times.first().filter(|_| horizontal(e.bodies.sun).0 < 0.0) {
        lines.push(format!("At {greatest:.1}, when it is greatest, the sun is below the horizon."));
    }
    times.sort_by_key(|(_, time)| *time);
    lines.extend(times.into_iter().map(|(what, time)| format!("{time:.1}  {what}")));
    if let Some([begin, end]) = e.central {
        lines.push(format!(
            "{kind} for {:.1} s",
            end.as_millisecond() as f64 / 1e3 - begin.as_millisecond() as f64 / 1e3
        ));
    }
    lines.join("\n")
}

fn json(time: Timestamp, bodies: &Bodies, eclipse: Option<&Eclipse>) -> anyhow::Result<String> {
    let disks = bodies.disks();
    let body = |direction: DVec3, radius: f64| {
        let (elevation, azimuth) = horizontal(direction);
        json!({
            "elevation_deg": elevation, "azimuth_deg": azimuth, "distance_m": direction.length(),
            "radius_deg": radius.to_degrees(),
        })
    };
    let disks_json = |bodies: &Bodies| {
        let d = bodies.disks();
        json!({
            "kind": name(d.phase()), "separation_deg": d.apart.to_degrees(), "magnitude": bodies.magnitude(),
            "obscuration": d.obscuration(), "sunlight": d.visible_limb_darkened(),
        })
    };
    let eclipse = eclipse.map(|e| {
        json!({
            "greatest": e.greatest.to_string(), "at_greatest": disks_json(&e.bodies),
            "partial": e.partial.map(|t| t.to_string()),
            "central": e.central.map(|c| c.map(|t| t.to_string())),
        })
    });
    let all = json!({
        "time": time.to_string(), "sun": body(bodies.sun, disks.sun), "moon": body(bodies.moon, disks.moon),
        "now": disks_json(bodies), "eclipse": eclipse,
    });
    Ok(serde_json::to_string_pretty(&all)?)
}
