//! The accuracy report's plot: error against time, a colour for each method, a line for each backend's front.

use plotters::prelude::*;

use crate::lab::accuracy::findings::{Entry, Findings};
use crate::lab::accuracy::measure::Against;
use crate::lab::plot::{self, Area, COLORS, Drawn};

const GREY: RGBColor = RGBColor(110, 110, 110);

/// Four diagrams: Earth above, haze below; all orders of scattering left, the sampling alone right.
pub fn svg(findings: &Findings) -> anyhow::Result<String> {
    let diagrams = [
        ("Earth, against all orders of scattering", 0, Against::AllOrders),
        ("Earth, against single scattering", 0, Against::Single),
        ("Haze, against all orders of scattering", 2, Against::AllOrders),
        ("Haze, against single scattering", 2, Against::Single),
    ];
    plot::svg((1100, 900), (2, 2), diagrams, |area, (title, medium, against)| {
        diagram(findings, area, title, medium, against)
    })
}

fn diagram(findings: &Findings, area: &Area<'_>, title: &str, medium: usize, against: Against) -> Drawn {
    let point = |e: &Entry| (e.ratio().max(1e-3), (100.0 * e.mean(against)).max(1e-4));
    let backends = findings.backends();
    let compared = |backend| findings.compared(backend, medium, against);
    let points: Vec<_> = backends.iter().flat_map(|b| compared(b)).map(point).collect();
    let span = |values: Vec<f64>, above: f64| {
        let lo = values.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = values.iter().copied().fold(0.0, f64::max);
        // At least a decade and a half: axes without a power of ten have no marks.
        (lo / 1.6).min(hi / 20.0)..(hi * above)
    };
    // The legend stands above the points.
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 17))
        .margin(10)
        .x_label_area_size(38)
        .y_label_area_size(52)
        .build_cartesian_2d(
            span(points.iter().map(|p| p.0).collect(), 1.6).log_scale(),
            span(points.iter().map(|p| p.1).collect(), 4.0).log_scale(),
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
    let methods = findings.methods();
    let color = |e: &Entry| {
        let at = methods.iter().position(|m| *m == e.candidate.quality.method()).unwrap_or(0);
        COLORS[at % COLORS.len()]
    };
    for (i, backend) in backends.iter().enumerate() {
        // The first backend: full dots, a full line, labels above; the next: rings, a broken line, labels
        // below.
        let (offset, first) = if i == 0 { ((6, -14), true) } else { ((-34, 6), false) };
        let dot = |e: &Entry, size, opacity| {
            let color = color(e).mix(opacity);
            Circle::new(point(e), size, if first { color.filled() } else { color.stroke_width(1) })
        };
        chart.draw_series(compared(backend).map(|e| dot(e, 3, 0.5)))?;
        let front = findings.front(backend, medium, against);
        let line = front.iter().map(|e| point(e));
        let style = GREY.stroke_width(if first { 2 } else { 1 });
        if first {
            chart.draw_series(LineSeries::new(line, style))?
        } else {
            chart.draw_series(DashedLineSeries::new(line, 5, 4, style))?
        }
        .label(format!("front of {backend} ({})", if first { "dots" } else { "rings" }))
        .legend(move |(x, y)| PathElement::new([(x, y), (x + if first { 16 } else { 7 }, y)], style));
        chart.draw_series(front.iter().map(|e| dot(e, 4, 1.0)))?;
        chart.draw_series(front.iter().map(|e| {
            let style = ("sans-serif", 11).into_font().color(&color(e));
            EmptyElement::at(point(e))
                + Text::new(e.candidate.quality.numbers().replace(' ', ""), offset, style)
        }))?;
    }
    for (method, color) in methods.iter().zip(COLORS.into_iter().cycle()) {
        let none = std::iter::empty::<Circle<(f64, f64), i32>>();
        chart
            .draw_series(none)?
            .label(format!("method {method}"))
            .legend(move |(x, y)| Circle::new((x + 8, y), 4, color.filled()));
    }
    plot::legend(&mut chart)
}
