//! Figures with logarithmic axes as SVG pictures: lines with dots, and crosses.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::prelude::*;

/// Units of the drawing per pixel of the picture.
const FINE: u32 = 4;
const WIDTH: u32 = 800 * FINE;
const HEIGHT: u32 = 520 * FINE;
const FONT: &str = "sans-serif";
/// Colours that readers with colour vision deficiency can distinguish (Okabe and Ito 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 130, 200),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];
/// Half the size of a mark.
const MARK_SIZE: u32 = 4 * FINE;

/// The size of a mark as a fraction of the diagram.
const MARGIN: f64 = 0.02;

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

impl Series {
    /// The points, and points of the lines between them.
    fn drawn_points(&self) -> Vec<(f64, f64)> {
        let between = |pair: &[(f64, f64)]| -> Vec<(f64, f64)> {
            let &[(x, y), (next_x, next_y)] = pair else { return Vec::new() };
            let at = |from: f64, to: f64, part: f64| from * (to / from).powf(part);
            let parts = (1..10).map(|part| f64::from(part) / 10.0);
            parts.map(|part| (at(x, next_x, part), at(y, next_y, part))).collect()
        };
        let lines = match self.style {
            SeriesStyle::Line => self.points.windows(2).flat_map(between).collect(),
            SeriesStyle::Crosses => Vec::new(),
        };
        [self.points.clone(), lines].concat()
    }
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
        self.draw(&mut svg)?;
        // The view box keeps the drawing's units; only the size of the picture is in pixels.
        let size = |scale: u32| format!(r#"width="{}" height="{}""#, WIDTH / scale, HEIGHT / scale);
        Ok(svg.replacen(&size(1), &size(FINE), 1))
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let root = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
        root.fill(&WHITE)?;
        let (x, y) = (self.range(|point| point.0), self.range(|point| point.1));
        let mut chart = ChartBuilder::on(&root)
            .caption(self.title, (FONT, 20 * FINE))
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
            let line = colour.stroke_width(2 * FINE);
            let points = series.points.iter().copied();
            match series.style {
                SeriesStyle::Line => {
                    let dot = move |point| Circle::new(point, MARK_SIZE, colour.filled());
                    chart.draw_series(LineSeries::new(points.clone(), line))?;
                    let legend = move |(x, y)| {
                        PathElement::new([(x, y), (x + 30 * FINE as i32, y)], line).into_dyn()
                    };
                    chart.draw_series(points.map(dot))?.label(series.label).legend(legend);
                }
                SeriesStyle::Crosses => {
                    let cross = move |point| Cross::new(point, MARK_SIZE, line);
                    let legend = move |(x, y)| {
                        Cross::new((x + 15 * FINE as i32, y), MARK_SIZE, line).into_dyn()
                    };
                    chart.draw_series(points.map(cross))?.label(series.label).legend(legend);
                }
            }
        }
        let position = self.legend_position(chart.plotting_area().dim_in_pixel());
        chart
            .configure_series_labels()
            .position(position)
            .legend_area_size(44 * FINE)
            .label_font((FONT, 16 * FINE))
            .margin(16 * FINE)
            .background_style(WHITE.mix(0.8))
            .draw()?;
        root.present()?;
        Ok(())
    }

    /// The position of the legend that hides the fewest points, in a diagram of this size.
    fn legend_position(&self, size: (u32, u32)) -> SeriesLabelPosition {
        let (x, y) = (self.range(|point| point.0), self.range(|point| point.1));
        let along = |range: &Range<f64>, value: f64| {
            (value / range.start).ln() / (range.end / range.start).ln()
        };
        let points = self.series.iter().flat_map(Series::drawn_points);
        let drawn: Vec<_> =
            points.map(|point| (along(&x, point.0), 1.0 - along(&y, point.1))).collect();
        // The approximate size of the legend as a fraction of the diagram, with its margin.
        let letters = self.series.iter().map(|series| series.label.chars().count()).max();
        let letters = letters.unwrap_or(0) as u32;
        let [width, height] = [
            f64::from((100 + 8 * letters) * FINE) / f64::from(size.0),
            f64::from((40 + 20 * self.series.len() as u32) * FINE) / f64::from(size.1),
        ];
        let hidden = |(left, top): &(f64, f64)| {
            let near = |from: f64, length: f64, value: f64| {
                (from - MARGIN..from + length + MARGIN).contains(&value)
            };
            let inside = |&&(x, y): &&(f64, f64)| near(*left, width, x) && near(*top, height, y);
            drawn.iter().filter(inside).count()
        };
        let parts = || (0..=10).map(|part| f64::from(part) / 10.0);
        let positions = parts()
            .flat_map(|left| parts().map(move |top| (left * (1.0 - width), top * (1.0 - height))));
        let (left, top) = positions.min_by_key(hidden).unwrap_or_default();
        let at = |part: f64, size: u32| (part * f64::from(size)) as i32;
        SeriesLabelPosition::Coordinate(at(left, size.0), at(top, size.1))
    }

    /// The range of an axis: all values, and a margin. A short axis begins at a power of ten, because it would
    /// have too few numbers otherwise.
    fn range(&self, value: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let values = || self.series.iter().flat_map(|series| &series.points).map(&value);
        let lowest = values().fold(f64::INFINITY, f64::min);
        let highest = values().fold(0.0, f64::max);
        let start = if highest < 30.0 * lowest {
            10.0_f64.powf(lowest.log10().floor())
        } else {
            lowest / 1.3
        };
        start..highest * 1.3
    }
}
