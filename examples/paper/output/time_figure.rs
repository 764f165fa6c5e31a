//! Figures over time as SVG pictures: lines and marks, in panels one below the other.

use std::error::Error;
use std::f64::consts::PI;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of the drawing per pixel of the picture. All points are rounded to units; with one unit per pixel,
/// lines would have visible steps.
const FINE: u32 = 4;
const WIDTH: u32 = 800 * FINE;
const PANEL_HEIGHT: u32 = 320 * FINE;
/// The height of the title and the legend above the panels.
const HEADER_HEIGHT: u32 = 76 * FINE;
const LINE_WIDTH: u32 = 2 * FINE;
const FONT: &str = "sans-serif";
/// Colours that readers with colour vision deficiency can distinguish (Okabe and Ito 2008).
const COLOURS: [RGBColor; 3] = [RGBColor(0, 130, 200), RGBColor(213, 94, 0), RGBColor(0, 158, 115)];
/// Half the size of a mark.
const MARK_SIZE: u32 = 4 * FINE;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

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
        let height = HEADER_HEIGHT + PANEL_HEIGHT * self.panels.len() as u32;
        let mut svg = String::new();
        self.draw(SVGBackend::with_string(&mut svg, (WIDTH, height)).into_drawing_area())?;
        // The view box keeps the drawing's units; only the size of the picture is in pixels.
        let size = |scale: u32| format!(r#"width="{}" height="{}""#, WIDTH / scale, height / scale);
        Ok(svg.replacen(&size(1), &size(FINE), 1))
    }

    fn draw(&self, root: Area) -> Drawn {
        root.fill(&WHITE)?;
        let (header, below) = root.split_vertically(HEADER_HEIGHT);
        self.draw_header(&header)?;
        // Each curve has a colour of its own, so that the panels share one legend.
        let mut colours = COLOURS.iter().cycle();
        for (panel, area) in self.panels.iter().zip(below.split_evenly((self.panels.len(), 1))) {
            panel.draw(&area, self.end, &mut colours)?;
        }
        root.present()?;
        Ok(())
    }

    /// Draws title and legend.
    fn draw_header(&self, header: &Area) -> Drawn {
        let at = |x: u32, y: u32| ((x * FINE) as i32, (y * FINE) as i32);
        let style = |size: u32, side: HPos| {
            (FONT, size * FINE).into_text_style(header).pos(Pos::new(side, VPos::Center))
        };
        header.draw(&Text::new(self.title, at(400, 24), style(20, HPos::Center)))?;

        let y = 56;
        header.draw(&Text::new("generated code:", at(80, y), style(16, HPos::Left)))?;
        let mut x = 210;
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        for (curve, colour) in curves.zip(COLOURS.iter().cycle()) {
            let line = [at(x, y), at(x + 30, y)];
            header.draw(&PathElement::new(line, colour.stroke_width(LINE_WIDTH)))?;
            header.draw(&Text::new(curve.label, at(x + 38, y), style(16, HPos::Left)))?;
            x += 60 + 9 * curve.label.chars().count() as u32;
        }
        x += 20;
        header.draw(&Cross::new(at(x + 8, y), MARK_SIZE, BLACK.stroke_width(FINE)))?;
        header.draw(&Text::new(self.reference, at(x + 24, y), style(16, HPos::Left)))?;
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
