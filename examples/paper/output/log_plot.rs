//! Figures with logarithmic axes: the method as lines, the rival as crosses.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::prelude::*;

/// Units of the drawing in a pixel of the picture.
const FINE: u32 = 4;
const WIDTH: u32 = 900 * FINE;
const HEIGHT: u32 = 520 * FINE;
const FONT: &str = "sans-serif";
/// Colours that readers with colour-deficient sight tell apart (Okabe and Ito 2008).
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];
/// Half the size of a mark.
const MARK_SIZE: u32 = 4 * FINE;

/// Ways beside each other, both axes logarithmic.
pub struct LogFigure {
    pub file_name: &'static str,
    pub title: &'static str,
    /// What it shows.
    pub says: &'static str,
    pub x: &'static str,
    pub y: &'static str,
    pub series: Vec<Series>,
}

/// Points of one way, in order.
pub struct Series {
    pub label: &'static str,
    pub way: Way,
    pub points: Vec<(f64, f64)>,
}

/// Whose points they are.
#[derive(Clone, Copy, PartialEq)]
pub enum Way {
    /// A line with dots.
    Method,
    /// Crosses.
    Rival,
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
            .y_label_formatter(&|value| format!("{value:.0e}"))
            .axis_style(BLACK.stroke_width(FINE))
            .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (series, &colour) in self.series.iter().zip(COLOURS.iter().cycle()) {
            let line = colour.stroke_width(2 * FINE);
            let points = series.points.iter().copied();
            match series.way {
                Way::Method => {
                    let dot = move |point| Circle::new(point, MARK_SIZE, colour.filled());
                    chart.draw_series(LineSeries::new(points.clone(), line))?;
                    let legend = move |(x, y)| {
                        PathElement::new([(x, y), (x + 30 * FINE as i32, y)], line).into_dyn()
                    };
                    chart.draw_series(points.map(dot))?.label(series.label).legend(legend);
                }
                Way::Rival => {
                    let cross = move |point| Cross::new(point, MARK_SIZE, line);
                    let legend = move |(x, y)| {
                        Cross::new((x + 15 * FINE as i32, y), MARK_SIZE, line).into_dyn()
                    };
                    chart.draw_series(points.map(cross))?.label(series.label).legend(legend);
                }
            }
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .legend_area_size(44 * FINE)
            .label_font((FONT, 16 * FINE))
            .margin(16 * FINE)
            .background_style(WHITE.mix(0.8))
            .draw()?;
        root.present()?;
        Ok(())
    }

    /// What an axis spans: all values and a little more.
    fn range(&self, value: impl Fn(&(f64, f64)) -> f64) -> Range<f64> {
        let values = || self.series.iter().flat_map(|series| &series.points).map(&value);
        let lowest = values().fold(f64::INFINITY, f64::min);
        let highest = values().fold(0.0, f64::max);
        lowest / 1.3..highest * 1.3
    }
}
