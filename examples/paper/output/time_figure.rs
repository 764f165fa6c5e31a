//! Figures over time as SVG pictures: lines and marks, in panels one below the other.

use std::error::Error;
use std::f64::consts::PI;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::prelude::*;

use super::figure_header::{
    self, Area, Drawn, Entry, FINE, FONT, LINE_WIDTH, MARK_SIZE, Symbol, WIDTH,
};

/// The height of a panel in pixels.
const PANEL_HEIGHT: u32 = 320;
/// Colours that readers with colour vision deficiency can distinguish (Okabe and Ito 2008).
const COLOURS: [RGBColor; 3] = [RGBColor(0, 130, 200), RGBColor(213, 94, 0), RGBColor(0, 158, 115)];

/// A figure of the paper.
pub struct TimeFigure {
    pub file_name: &'static str,
    pub title: &'static str,
    /// What the figure shows.
    pub caption: &'static str,
    /// What the crosses are.
    pub reference: &'static str,
    /// The end of the axis of time in s.
    pub end: f64,
    pub panels: Vec<Panel>,
}

/// Curves that share their axes. All panels have the same time axis.
pub struct Panel {
    /// The label of the vertical axis, with its unit.
    pub axis: &'static str,
    pub curves: Vec<Curve>,
}

/// A coordinate against time in s.
pub struct Curve {
    pub label: &'static str,
    /// The values by generated code.
    pub line: Vec<(f64, f64)>,
    /// The values by the reference.
    pub marks: Vec<(f64, f64)>,
}

impl TimeFigure {
    /// Draws the figure into a file in `folder` and returns the file.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
        let path = folder.join(self.file_name);
        fs::write(&path, self.svg()?)?;
        Ok(path)
    }

    /// The picture.
    pub fn svg(&self) -> Result<String, Box<dyn Error>> {
        let legend = self.legend();
        let height = figure_header::height(&legend) + PANEL_HEIGHT * self.panels.len() as u32;
        let mut svg = String::new();
        let size = (WIDTH * FINE, height * FINE);
        self.draw(SVGBackend::with_string(&mut svg, size).into_drawing_area(), &legend)?;
        Ok(figure_header::in_pixels(&svg, height))
    }

    fn legend(&self) -> Vec<Entry<'_>> {
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        let lines = curves
            .zip(COLOURS.into_iter().cycle())
            .map(|(curve, colour)| Entry { label: curve.label, symbol: Symbol::Line(colour) });
        let heading = Entry { label: "generated code:", symbol: Symbol::Heading };
        let marks = Entry { label: self.reference, symbol: Symbol::Cross(BLACK) };
        [heading].into_iter().chain(lines).chain([marks]).collect()
    }

    fn draw(&self, root: Area, legend: &[Entry]) -> Drawn {
        root.fill(&WHITE)?;
        let (header, below) = root.split_vertically(figure_header::height(legend) * FINE);
        figure_header::draw(&header, self.title, legend)?;
        // Each curve has a different colour, so that the panels share one legend.
        let mut colours = COLOURS.iter().cycle();
        for (panel, area) in self.panels.iter().zip(below.split_evenly((self.panels.len(), 1))) {
            panel.draw(&area, self.end, &mut colours)?;
        }
        root.present()?;
        Ok(())
    }
}

impl Panel {
    fn draw<'c>(
        &self,
        area: &Area,
        end: f64,
        colours: &mut impl Iterator<Item = &'c RGBColor>,
    ) -> Drawn {
        let mut chart = ChartBuilder::on(area)
            .margin(8 * FINE)
            .margin_right(24 * FINE)
            .x_label_area_size(48 * FINE)
            .y_label_area_size(72 * FINE)
            .build_cartesian_2d(0.0..end, self.range())?;
        chart
            .configure_mesh()
            .x_desc("t in s")
            .y_desc(self.axis)
            .axis_desc_style((FONT, 17 * FINE))
            .label_style((FONT, 15 * FINE))
            .axis_style(BLACK.stroke_width(FINE))
            .set_all_tick_mark_size(5 * FINE)
            .bold_line_style(BLACK.mix(0.12).stroke_width(FINE))
            .light_line_style(TRANSPARENT)
            .draw()?;
        for (curve, colour) in self.curves.iter().zip(colours) {
            for part in unbroken_parts(&curve.line) {
                let points = part.iter().copied();
                chart.draw_series(LineSeries::new(points, colour.stroke_width(LINE_WIDTH)))?;
            }
        }
        // Drawn after all lines, so that no line hides a mark.
        let marks = self.curves.iter().flat_map(|curve| &curve.marks);
        chart.draw_series(
            marks.map(|&mark| Cross::new(mark, MARK_SIZE, BLACK.stroke_width(FINE))),
        )?;
        Ok(())
    }

    /// The range of the vertical axis: all values, and a margin.
    fn range(&self) -> Range<f64> {
        let values = || self.curves.iter().flat_map(|curve| &curve.line).map(|&(_, value)| value);
        let (lowest, highest) =
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let margin = 0.06 * (highest - lowest);
        lowest - margin..highest + margin
    }
}

/// The parts of a line between jumps from π to −π or back. A line with values beyond these bounds has no
/// such jumps.
fn unbroken_parts(line: &[(f64, f64)]) -> impl Iterator<Item = &[(f64, f64)]> {
    let wraps = line.iter().all(|(_, value)| value.abs() <= PI);
    line.chunk_by(move |(_, value), (_, next)| !wraps || (next - value).abs() < PI)
}
