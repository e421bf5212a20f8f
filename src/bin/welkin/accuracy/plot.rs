//! The accuracy report's plot: error against time, a colour for each backend, fronts drawn.

use anyhow::anyhow;
use plotters::prelude::*;

use super::Findings;
use super::measure::Against;

/// Colours that stay apart for colour-blind readers (Okabe & Ito).
const COLORS: [RGBColor; 4] =
    [RGBColor(0, 114, 178), RGBColor(213, 94, 0), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];
const SIZE: (u32, u32) = (1200, 440);

/// Three diagrams side by side.
pub fn svg(findings: &Findings) -> anyhow::Result<String> {
    let mut text = String::new();
    let diagrams = [
        ("Earth: sampling", 0, Against::Single),
        ("Haze: sampling", 2, Against::Single),
        ("Earth: sampling and model", 0, Against::AllOrders),
    ];
    {
        let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        area.fill(&WHITE).map_err(|e| anyhow!("plot: {e}"))?;
        for (part, (title, medium, against)) in area.split_evenly((1, 3)).iter().zip(diagrams) {
            diagram(findings, part, title, medium, against).map_err(|e| anyhow!("plot: {e}"))?;
        }
        area.present().map_err(|e| anyhow!("plot: {e}"))?;
    }
    Ok(text)
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

fn diagram(
    findings: &Findings,
    area: &Area<'_>,
    title: &str,
    medium: usize,
    against: Against,
) -> Result<(), Box<dyn std::error::Error>> {
    let point = |e: &super::Entry| (e.ratio().max(1e-3), (100.0 * e.mean(against)).max(1e-4));
    let points: Vec<_> = findings.totals(medium).map(point).collect();
    let span = |values: Vec<f64>| {
        let lo = values.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = values.iter().copied().fold(0.0, f64::max);
        // At least a decade and a half: axes without a power of ten have no marks.
        (lo / 1.6).min(hi / 20.0)..(hi * 1.6)
    };
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 17))
        .margin(10)
        .x_label_area_size(38)
        .y_label_area_size(52)
        .build_cartesian_2d(
            span(points.iter().map(|p| p.0).collect()).log_scale(),
            span(points.iter().map(|p| p.1).collect()).log_scale(),
        )?;
    // Names for 1, 2 and 5 times a power of ten: more would not fit.
    let number = |v: &f64| {
        let leading = v / 10f64.powf((v * 1.000_001).log10().floor());
        let named = [1.0, 2.0, 5.0].iter().any(|n| (leading - n).abs() < 0.01);
        let text = format!("{v:.4}");
        if named { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { String::new() }
    };
    chart
        .configure_mesh()
        .x_desc("time over that of a full-screen copy")
        .y_desc("mean error of the worst channel, %")
        .x_label_formatter(&number)
        .y_label_formatter(&number)
        .light_line_style(RGBColor(235, 235, 235))
        .label_style(("sans-serif", 12))
        .draw()?;
    for (i, (backend, color)) in findings.backends().into_iter().zip(COLORS.into_iter().cycle()).enumerate() {
        // Above the first front and below the second, so that they do not cover each other.
        let offset = if i % 2 == 0 { (6, -14) } else { (-34, 6) };
        let all = findings.totals(medium).filter(|e| e.backend == backend);
        chart.draw_series(all.map(|e| Circle::new(point(e), 3, color.mix(0.5).filled())))?;
        let front = findings.front(backend, medium, against);
        chart
            .draw_series(LineSeries::new(front.iter().map(|e| point(e)), color.stroke_width(2)))?
            .label(format!("{backend}, single"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], color.stroke_width(2)));
        chart.draw_series(front.iter().map(|e| {
            EmptyElement::at(point(e))
                + Circle::new((0, 0), 4, color.filled())
                + Text::new(
                    format!("{}×{}", e.samples[0], e.samples[1]),
                    offset,
                    ("sans-serif", 11).into_font().color(&color),
                )
        }))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.8))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 12))
        .draw()?;
    Ok(())
}
