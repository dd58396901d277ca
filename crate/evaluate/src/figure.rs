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

/// What people said, whatever the order.
const BY_HAND: RGBColor = RGBColor(93, 106, 120);

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Look {
    /// Through the points; a value that is no number breaks the line.
    Line,
    Dots,
    /// From the bottom to the top at each x.
    Upright,
    /// From the bottom to the top between x and y of each point, with its middle marked.
    Band,
}

/// One line or set of dots, uprights or bands.
pub struct Series {
    label: String,
    points: Vec<(f64, f64)>,
    look: Look,
}

impl Series {
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, look: Look::Line }
    }

    pub fn dots(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, look: Look::Dots }
    }

    pub fn uprights(label: impl Into<String>, places: impl IntoIterator<Item = f64>) -> Series {
        let points = places.into_iter().map(|place| (place, 0.0)).collect();
        Series { label: label.into(), points, look: Look::Upright }
    }

    pub fn bands(label: impl Into<String>, ranges: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points: ranges, look: Look::Band }
    }

    /// Nothing, in the place of a colour.
    pub fn none() -> Series {
        Series::dots("", Vec::new())
    }
}

/// One set of axes.
pub struct Panel<'a> {
    pub title: &'a str,
    pub x: (&'a str, Range<f64>),
    pub y: (&'a str, Range<f64>),
    pub series: Vec<Series>,
}

impl Panel<'_> {
    /// Without a legend, where another panel has the same.
    pub fn unlabelled(mut self) -> Self {
        self.series.iter_mut().for_each(|series| series.label.clear());
        self
    }
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
    let mut all: Vec<(&Series, &RGBColor)> = panel.series.iter().zip(COLOURS.iter().cycle()).collect();
    // Bands lie under all else.
    all.sort_by_key(|(series, _)| series.look != Look::Band);
    let (bottom, top) = (panel.y.1.start, panel.y.1.end);
    let upright = |place: f64| vec![(place, bottom), (place, top)];
    for (series, &colour) in all {
        let points = series.points.iter().copied();
        let mut style = colour.stroke_width(2);
        let drawn = match series.look {
            Look::Dots => chart.draw_series(points.map(|point| Circle::new(point, 2, colour.filled()))),
            Look::Line => {
                let pieces = series.points.split(|point| point.1.is_nan());
                chart.draw_series(pieces.map(|piece| PathElement::new(piece, style)))
            }
            Look::Upright => chart.draw_series(points.map(|point| PathElement::new(upright(point.0), style))),
            Look::Band => {
                let middles = points.clone().map(|(from, to)| upright((from + to) / 2.0));
                let middles = middles.map(|line| PathElement::new(line, BY_HAND));
                chart.draw_series(middles).map_err(|error| error.to_string())?;
                style = BY_HAND.mix(0.25).stroke_width(9);
                let corners = points.map(|(from, to)| [(from, bottom), (to, top)]);
                chart.draw_series(corners.map(|corners| Rectangle::new(corners, BY_HAND.mix(0.25).filled())))
            }
        };
        let drawn = drawn.map_err(|error| error.to_string())?;
        if !series.label.is_empty() {
            drawn
                .label(&series.label)
                .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 14, y)], style));
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
