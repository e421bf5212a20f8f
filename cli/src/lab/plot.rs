//! What the laboratory's plots share: the page, its parts, colours and legends.

use anyhow::anyhow;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;

/// Colours that stay apart for colour-blind readers (Okabe & Ito).
pub const COLORS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

/// A part of the page.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
/// What drawing a diagram comes to.
pub type Drawn = Result<(), Box<dyn std::error::Error>>;

/// A white page of `size` pixels as SVG, in rows and columns of diagrams; `draw` draws each of `diagrams` on
/// its part.
pub fn svg<T>(
    size: (u32, u32),
    rows_and_columns: (usize, usize),
    diagrams: impl IntoIterator<Item = T>,
    draw: impl Fn(&Area<'_>, T) -> Drawn,
) -> anyhow::Result<String> {
    let mut text = String::new();
    {
        let page = SVGBackend::with_string(&mut text, size).into_drawing_area();
        page.fill(&WHITE).map_err(|e| anyhow!("plot: {e}"))?;
        for (part, diagram) in page.split_evenly(rows_and_columns).iter().zip(diagrams) {
            draw(part, diagram).map_err(|e| anyhow!("plot: {e}"))?;
        }
        page.present().map_err(|e| anyhow!("plot: {e}"))?;
    }
    Ok(text)
}

/// Draws the legend in the upper right corner.
pub fn legend<'a, X, Y>(chart: &mut ChartContext<'a, SVGBackend<'a>, Cartesian2d<X, Y>>) -> Drawn
where
    X: Ranged + ValueFormatter<X::ValueType>,
    Y: Ranged + ValueFormatter<Y::ValueType>,
{
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.8))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 12))
        .draw()?;
    Ok(())
}
