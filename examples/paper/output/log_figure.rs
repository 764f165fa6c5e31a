//! Figures with logarithmic axes as SVG pictures: lines with dots, and crosses.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::prelude::*;

use super::figure_header::{self, Entry, FINE, FONT, LINE_WIDTH, MARK_SIZE, Symbol, WIDTH};

/// The height of the diagram in pixels.
const HEIGHT: u32 = 430;
/// The margin of the axes beyond the points, as a fraction of their logarithmic length.
const MARGIN: f64 = 0.04;
/// Colours that readers with colour vision deficiency can distinguish (Okabe and Ito 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 130, 200),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];
/// Series of points, both axes logarithmic.
pub struct LogFigure {
    pub file_name: &'static str,
    pub title: &'static str,
    /// What the figure shows.
    pub caption: &'static str,
    pub x: &'static str,
    pub y: &'static str,
    pub series: Vec<Series>,
}

/// The points of one method, in order.
pub struct Series {
    pub label: &'static str,
    pub style: SeriesStyle,
    pub points: Vec<(f64, f64)>,
}

/// How the points are drawn.
#[derive(Clone, Copy, PartialEq)]
pub enum SeriesStyle {
    /// A line with dots.
    Line,
    /// Crosses without a line.
    Crosses,
}

/// Formats a value at the horizontal axis.
fn tick(value: &f64) -> String {
    if (1.0..1e6).contains(value) { format!("{value}") } else { format!("{value:.0e}") }
}

impl LogFigure {
    /// Draws the figure into a file in `folder` and returns the file.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
        let path = folder.join(self.file_name);
        fs::write(&path, self.svg()?)?;
        Ok(path)
    }

    /// The picture.
    pub fn svg(&self) -> Result<String, Box<dyn Error>> {
        let mut svg = String::new();
        let legend = self.legend();
        self.draw(&mut svg, &legend)?;
        Ok(figure_header::in_pixels(&svg, figure_header::height(&legend) + HEIGHT))
    }

    fn legend(&self) -> Vec<Entry<'_>> {
        let entry = |(series, colour): (&Series, RGBColor)| Entry {
            label: series.label,
            symbol: match series.style {
                SeriesStyle::Line => Symbol::Line(colour),
                SeriesStyle::Crosses => Symbol::Cross(colour),
            },
        };
        self.series.iter().zip(COLOURS.into_iter().cycle()).map(entry).collect()
    }

    fn draw(&self, svg: &mut String, legend: &[Entry]) -> Result<(), Box<dyn Error>> {
        let header_height = figure_header::height(legend);
        let size = (WIDTH * FINE, (header_height + HEIGHT) * FINE);
        let root = SVGBackend::with_string(svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        let (header, below) = root.split_vertically(header_height * FINE);
        figure_header::draw(&header, self.title, legend)?;
        let (x, y) = (self.range(|point| point.0), self.range(|point| point.1));
        let mut chart = ChartBuilder::on(&below)
            .margin(8 * FINE)
            .margin_right(24 * FINE)
            .x_label_area_size(48 * FINE)
            .y_label_area_size(80 * FINE)
            .build_cartesian_2d(x.log_scale(), y.log_scale())?;
        chart
            .configure_mesh()
            .x_desc(self.x)
            .y_desc(self.y)
            .axis_desc_style((FONT, 17 * FINE))
            .label_style((FONT, 15 * FINE))
            .x_label_formatter(&tick)
            .y_label_formatter(&|value| format!("{value:.0e}"))
            .axis_style(BLACK.stroke_width(FINE))
            .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (series, &colour) in self.series.iter().zip(COLOURS.iter().cycle()) {
            let line = colour.stroke_width(LINE_WIDTH);
            let points = series.points.iter().copied();
            match series.style {
                SeriesStyle::Line => {
                    let dot = |point| Circle::new(point, MARK_SIZE, colour.filled());
                    chart.draw_series(LineSeries::new(points.clone(), line))?;
                    chart.draw_series(points.map(dot))?;
                }
                SeriesStyle::Crosses => {
                    chart.draw_series(points.map(|point| Cross::new(point, MARK_SIZE, line)))?;
                }
            }
        }
        root.present()?;
        Ok(())
    }

    /// The range of an axis: all values, and a margin. A short axis begins at a power of ten, because it
    /// would have too few numbers otherwise.
    fn range(&self, value: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let values = || self.series.iter().flat_map(|series| &series.points).map(&value);
        let lowest = values().fold(f64::INFINITY, f64::min);
        let highest = values().fold(0.0, f64::max);
        let margin = (highest / lowest).powf(MARGIN).max(1.1);
        let start = if highest < 30.0 * lowest {
            10.0_f64.powf(lowest.log10().floor())
        } else {
            lowest / margin
        };
        start..highest * margin
    }
}
