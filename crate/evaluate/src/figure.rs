//! Line figures as SVG.

use std::ops::Range;
use std::path::Path;

use anyhow::anyhow;
use plotters::coord::Shift;
use plotters::prelude::*;

/// Colours that differ for everyone, in order.
const COLOURS: [RGBColor; 6] = [
    RGBColor(11, 111, 194),
    RGBColor(179, 83, 0),
    RGBColor(10, 125, 86),
    RGBColor(142, 68, 173),
    RGBColor(93, 106, 120),
    RGBColor(192, 40, 70),
];

/// One line or set of dots.
pub struct Series {
    pub label: String,
    pub points: Vec<(f64, f64)>,
    pub dots: bool,
}

impl Series {
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, dots: false }
    }

    pub fn dots(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, dots: true }
    }
}

/// One set of axes.
pub struct Panel<'a> {
    pub title: &'a str,
    pub x: (&'a str, Range<f64>),
    pub y: (&'a str, Range<f64>),
    pub series: Vec<Series>,
}

/// Draws panels below one another.
pub fn draw(path: &Path, panels: &[Panel]) -> anyhow::Result<()> {
    let height = if panels.len() == 1 { 380 } else { 240 * panels.len() as u32 };
    let area = SVGBackend::new(path, (760, height)).into_drawing_area();
    let drawn = (|| {
        area.fill(&WHITE).map_err(|error| error.to_string())?;
        for (part, panel) in area.split_evenly((panels.len(), 1)).iter().zip(panels) {
            draw_panel(part, panel).map_err(|error| error.to_string())?;
        }
        area.present().map_err(|error| error.to_string())
    })();
    drawn.map_err(|error: String| anyhow!("{}: {error}", path.display()))
}

fn draw_panel(
    area: &DrawingArea<SVGBackend, Shift>,
    panel: &Panel,
) -> Result<(), Box<dyn std::error::Error>> {
    let mut chart = ChartBuilder::on(area)
        .caption(panel.title, ("sans-serif", 15))
        .margin(10)
        .x_label_area_size(36)
        .y_label_area_size(52)
        .build_cartesian_2d(panel.x.1.clone(), panel.y.1.clone())
        .map_err(|error| error.to_string())?;
    chart
        .configure_mesh()
        .x_desc(panel.x.0)
        .y_desc(panel.y.0)
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 229, 234))
        .draw()
        .map_err(|error| error.to_string())?;
    for (series, colour) in panel.series.iter().zip(COLOURS.iter().cycle()) {
        let colour = *colour;
        let points = series.points.iter().copied();
        let drawn = if series.dots {
            chart.draw_series(points.map(|point| Circle::new(point, 2, colour.filled())))
        } else {
            chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))
        };
        let drawn = drawn.map_err(|error| error.to_string())?;
        if !series.label.is_empty() {
            drawn
                .label(&series.label)
                .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 14, y)], colour.stroke_width(2)));
        }
    }
    if panel.series.iter().any(|series| !series.label.is_empty()) {
        chart
            .configure_series_labels()
            .background_style(WHITE.mix(0.85))
            .border_style(RGBColor(225, 229, 234))
            .position(SeriesLabelPosition::UpperRight)
            .draw()
            .map_err(|error| error.to_string())?;
    }
    Ok(())
}
