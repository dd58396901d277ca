//! Figures as SVG.

use std::ops::Range;
use std::path::Path;

use anyhow::anyhow;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Colours of series, distinguishable with colour-vision deficiencies.
const COLOURS: [RGBColor; 6] = [
    RGBColor(11, 111, 194),
    RGBColor(179, 83, 0),
    RGBColor(10, 125, 86),
    RGBColor(142, 68, 173),
    RGBColor(93, 106, 120),
    RGBColor(192, 40, 70),
];

/// Width of figures, in pixels.
const WIDTH: u32 = 760;

/// Colour of bands.
const BAND_COLOUR: RGBColor = RGBColor(93, 106, 120);

/// Kind of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Line through the points; NaN values break it.
    Line,
    /// One dot per point.
    Dots,
    /// One line over the full height at each x.
    VerticalLines,
    /// One band over the full height from x to y of each point, with its middle marked.
    Bands,
}

/// Points that are drawn in one style.
pub struct Series {
    label: String,
    points: Vec<(f64, f64)>,
    kind: Kind,
}

impl Series {
    /// Creates a line; NaN values break it.
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, kind: Kind::Line }
    }

    /// Creates a set of dots.
    pub fn dots(label: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points, kind: Kind::Dots }
    }

    /// Creates vertical lines at the given x.
    pub fn vertical_lines(label: impl Into<String>, positions: impl IntoIterator<Item = f64>) -> Series {
        let points = positions.into_iter().map(|x| (x, 0.0)).collect();
        Series { label: label.into(), points, kind: Kind::VerticalLines }
    }

    /// Creates bands over ranges of x.
    pub fn bands(label: impl Into<String>, ranges: Vec<(f64, f64)>) -> Series {
        Series { label: label.into(), points: ranges, kind: Kind::Bands }
    }

    /// Creates an empty series, which skips a colour.
    pub fn placeholder() -> Series {
        Series::dots("", Vec::new())
    }
}

/// One set of axes.
pub struct Panel<'a> {
    /// Title above the axes.
    pub title: &'a str,
    /// Label and range of the x axis.
    pub x: (&'a str, Range<f64>),
    /// Label and range of the y axis.
    pub y: (&'a str, Range<f64>),
    /// Series in the order of their colours.
    pub series: Vec<Series>,
}

impl Panel<'_> {
    /// Removes the legend.
    pub fn without_legend(mut self) -> Self {
        self.series.iter_mut().for_each(|series| series.label.clear());
        self
    }
}

/// Draws panels below one another.
pub fn draw(path: &Path, panels: &[Panel]) -> anyhow::Result<()> {
    let height = if panels.len() == 1 { 380 } else { 240 * panels.len() as u32 };
    draw_on_white(path, (WIDTH, height), |area| {
        for (part, panel) in area.split_evenly((panels.len(), 1)).iter().zip(panels) {
            draw_panel(part, panel)?;
        }
        Ok(())
    })
}

/// A matrix of amounts.
pub struct Matrix<'a> {
    /// Title above the matrix.
    pub title: &'a str,
    /// Names of the rows.
    pub rows: &'a [&'a str],
    /// Title and names of the columns.
    pub columns: (&'a str, &'a [&'a str]),
    /// Amount of each row in each column.
    pub amounts: &'a [Vec<f64>],
}

/// Draws a matrix whose cells are as dark as their fraction of the row.
pub fn draw_matrix(path: &Path, matrix: &Matrix) -> anyhow::Result<()> {
    const CELL: (i32, i32) = (64, 30);
    const ORIGIN: (i32, i32) = (230, 84);
    let height = ORIGIN.1 + CELL.1 * matrix.rows.len() as i32 + 16;
    draw_on_white(path, (WIDTH, height as u32), |area| {
        let text = |text: &str, size: i32, position: (i32, i32), horizontal: HPos, colour: &RGBColor| {
            let style = ("sans-serif", size).into_text_style(area).color(colour);
            area.draw_text(text, &style.pos(Pos::new(horizontal, VPos::Center)), position)
        };
        let (title, names) = matrix.columns;
        let column_middle = |column: usize| ORIGIN.0 + CELL.0 * column as i32 + CELL.0 / 2;
        let row_middle = |row: usize| ORIGIN.1 + CELL.1 * row as i32 + CELL.1 / 2;
        text(matrix.title, 15, (WIDTH as i32 / 2, 18), HPos::Center, &BLACK)?;
        text(title, 12, (ORIGIN.0, ORIGIN.1 - 34), HPos::Left, &BLACK)?;
        for (column, name) in names.iter().enumerate() {
            text(name, 13, (column_middle(column), ORIGIN.1 - 12), HPos::Center, &BLACK)?;
        }
        for (row, (name, amounts)) in matrix.rows.iter().zip(matrix.amounts).enumerate() {
            text(name, 13, (ORIGIN.0 - 12, row_middle(row)), HPos::Right, &BLACK)?;
            let total = amounts.iter().sum::<f64>().max(f64::MIN_POSITIVE);
            for (column, amount) in amounts.iter().enumerate() {
                let (x, y) = (ORIGIN.0 + CELL.0 * column as i32, ORIGIN.1 + CELL.1 * row as i32);
                let corners = [(x + 1, y + 1), (x + CELL.0 - 1, y + CELL.1 - 1)];
                let fraction = amount / total;
                area.draw(&Rectangle::new(corners, COLOURS[0].mix(0.06 + 0.94 * fraction).filled()))?;
                if *amount > 0.0 {
                    let colour = if fraction > 0.5 { &WHITE } else { &BLACK };
                    let middle = (column_middle(column), row_middle(row));
                    text(&format!("{amount:.1}"), 12, middle, HPos::Center, colour)?;
                }
            }
        }
        Ok(())
    })
}

fn draw_on_white(
    path: &Path,
    size: (u32, u32),
    content: impl FnOnce(&DrawingArea<SVGBackend, Shift>) -> Result<(), Box<dyn std::error::Error>>,
) -> anyhow::Result<()> {
    let area = SVGBackend::new(path, size).into_drawing_area();
    let result = (|| {
        area.fill(&WHITE).map_err(|error| error.to_string())?;
        content(&area).map_err(|error| error.to_string())?;
        area.present().map_err(|error| error.to_string())
    })();
    result.map_err(|error: String| anyhow!("cannot draw {}: {error}", path.display()))
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
    let mut series_and_colours: Vec<(&Series, &RGBColor)> =
        panel.series.iter().zip(COLOURS.iter().cycle()).collect();
    // Bands are drawn first, below all other series.
    series_and_colours.sort_by_key(|(series, _)| series.kind != Kind::Bands);
    let (bottom, top) = (panel.y.1.start, panel.y.1.end);
    let vertical = |x: f64| vec![(x, bottom), (x, top)];
    for (series, &colour) in series_and_colours {
        let points = series.points.iter().copied();
        let mut style = colour.stroke_width(2);
        let result = match series.kind {
            Kind::Dots => chart.draw_series(points.map(|point| Circle::new(point, 2, colour.filled()))),
            Kind::Line => {
                let parts = series.points.split(|point| point.1.is_nan());
                chart.draw_series(parts.map(|part| PathElement::new(part, style)))
            }
            Kind::VerticalLines => {
                chart.draw_series(points.map(|point| PathElement::new(vertical(point.0), style)))
            }
            Kind::Bands => {
                let middles = points.clone().map(|(from, to)| vertical((from + to) / 2.0));
                let middles = middles.map(|line| PathElement::new(line, BAND_COLOUR));
                chart.draw_series(middles).map_err(|error| error.to_string())?;
                style = BAND_COLOUR.mix(0.25).stroke_width(9);
                let corners = points.map(|(from, to)| [(from, bottom), (to, top)]);
                chart.draw_series(
                    corners.map(|corners| Rectangle::new(corners, BAND_COLOUR.mix(0.25).filled())),
                )
            }
        };
        let drawn = result.map_err(|error| error.to_string())?;
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
