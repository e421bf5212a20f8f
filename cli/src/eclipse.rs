//! `welkin eclipse`: where sun and moon stand above a place, and how much of the sun the moon hides.

use std::io::Write;

use glam::DVec3;
use jiff::Timestamp;
use serde_json::json;
use welkin::model::moon::{Disks, Phase};

use crate::args::{EclipseArgs, UsageError};
use crate::ephemeris::{self, Bodies, Eclipse, horizontal};

/// Computes and prints.
pub fn run(args: &EclipseArgs) -> anyhow::Result<()> {
    let (time, place, height) = args.when_and_where();
    let bodies = ephemeris::bodies(time, place, height)
        .map_err(|_| UsageError::value("--time <TIME>", time, "in the years 1900 to 2099"))?;
    let eclipse = ephemeris::eclipse(time, place, height)?;
    let text = if args.json { json(time, &bodies, eclipse.as_ref())? } else { words(time, &bodies, eclipse.as_ref()) };
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

/// Share of the sun's light, per channel, in %.
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
    let mut times = vec![(format!("{kind} eclipse of magnitude {:.4}, greatest", e.bodies.magnitude()), e.greatest)];
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
            "partial": e.partial.map(|t| t.to_string()), "central": e.central.map(|c| c.map(|t| t.to_string())),
        })
    });
    let all = json!({
        "time": time.to_string(), "sun": body(bodies.sun, disks.sun), "moon": body(bodies.moon, disks.moon),
        "now": disks_json(bodies), "eclipse": eclipse,
    });
    Ok(serde_json::to_string_pretty(&all)?)
}
