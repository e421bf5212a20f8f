//! The flight's plot: time, pixels and passes along it, planned and with everything on.

use plotters::prelude::*;

use crate::lab::flight::frame::{Cost, FlightFrame};
use crate::lab::plot::{self, Area, COLORS, Drawn};
use crate::views;

const PLANNED: RGBColor = COLORS[0];
const EVERYTHING: RGBColor = COLORS[1];

/// A number of a frame.
type Of = fn(&Cost) -> f64;

/// Three diagrams above one another.
pub fn svg(frames: &[FlightFrame], [width, height]: [u32; 2], describe: &str) -> anyhow::Result<String> {
    let driver = describe.split(',').next().unwrap_or(describe);
    let time = format!("GPU time of the sky, ms ({width}×{height}, {driver})");
    let diagrams: [(&str, Of); 3] =
        [(&time, |c| c.time), ("megapixels shaded", |c| 1e-6 * c.pixels), ("passes", |c| c.passes as f64)];
    plot::svg((1000, 760), (3, 1), diagrams, |area, (title, of)| diagram(area, frames, title, of))
}

fn diagram(area: &Area<'_>, frames: &[FlightFrame], title: &str, of: Of) -> Drawn {
    let last = frames.len() - 1;
    let top = frames.iter().flat_map(|f| [of(&f.planned), of(&f.everything)]).fold(0.0, f64::max);
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 16))
        .margin(8)
        .x_label_area_size(30)
        .y_label_area_size(48)
        .build_cartesian_2d(0..last, 0.0..1.45 * top)?;
    // Where the camera is.
    let name = |at: &usize| {
        let m = &frames[(*at).min(last)].moment;
        format!("{}, sun {:.0}°", views::length(m.altitude), m.sun_elevation)
    };
    chart
        .configure_mesh()
        .x_labels(9)
        .x_label_formatter(&name)
        .light_line_style(RGBColor(240, 240, 240))
        .label_style(("sans-serif", 11))
        .draw()?;
    for (label, color, planned) in [("everything on", EVERYTHING, false), ("planned", PLANNED, true)] {
        let points = frames.iter().enumerate();
        let points = points.map(|(i, f)| (i, of(if planned { &f.planned } else { &f.everything })));
        chart
            .draw_series(LineSeries::new(points, color.stroke_width(2)))?
            .label(label)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], color.stroke_width(2)));
    }
    plot::legend(&mut chart)
}
