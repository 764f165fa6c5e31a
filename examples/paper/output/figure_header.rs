//! The title and the legend of a figure, above its diagrams.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of the drawing per pixel of the picture. All points are rounded to units; with one unit per pixel,
/// lines would have visible steps.
pub const FINE: u32 = 4;
/// The width of a figure in pixels.
pub const WIDTH: u32 = 800;
pub const FONT: &str = "sans-serif";
/// The width of a line, and half the size of a mark.
pub const LINE_WIDTH: u32 = 2 * FINE;
pub const MARK_SIZE: u32 = 4 * FINE;

/// The left end of the legend, the height of the title and of a row of the legend, in pixels.
const LEFT: u32 = 80;
const TITLE_HEIGHT: u32 = 40;
const ROW_HEIGHT: u32 = 26;

pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub type Drawn = Result<(), Box<dyn std::error::Error>>;

/// An entry of the legend.
pub struct Entry<'a> {
    pub label: &'a str,
    pub symbol: Symbol,
}

/// The symbol of an entry.
#[derive(Clone, Copy)]
pub enum Symbol {
    Line(RGBColor),
    Cross(RGBColor),
    /// No symbol: the label is a heading.
    Heading,
}

impl Entry<'_> {
    /// The approximate width in pixels.
    fn width(&self) -> u32 {
        let symbol = match self.symbol {
            Symbol::Line(_) => 38,
            Symbol::Cross(_) => 24,
            Symbol::Heading => 0,
        };
        symbol + 8 * self.label.chars().count() as u32 + 16
    }
}

/// The place of each entry in pixels.
fn places(entries: &[Entry]) -> Vec<(u32, u32)> {
    let (mut x, mut y) = (LEFT, TITLE_HEIGHT + ROW_HEIGHT / 2);
    let position = |entry: &Entry| {
        if x > LEFT && x + entry.width() > WIDTH {
            (x, y) = (LEFT, y + ROW_HEIGHT);
        }
        let here = (x, y);
        x += entry.width();
        here
    };
    entries.iter().map(position).collect()
}

/// The height of the header in pixels.
pub fn height(entries: &[Entry]) -> u32 {
    places(entries).last().map_or(TITLE_HEIGHT, |(_, y)| y + ROW_HEIGHT / 2) + 4
}

/// Draws title and legend.
pub fn draw(area: &Area, title: &str, entries: &[Entry]) -> Drawn {
    let at = |x: u32, y: u32| ((x * FINE) as i32, (y * FINE) as i32);
    let style = |size: u32, side: HPos| {
        (FONT, size * FINE).into_text_style(area).pos(Pos::new(side, VPos::Center))
    };
    area.draw(&Text::new(title, at(WIDTH / 2, 22), style(20, HPos::Center)))?;
    for (entry, (x, y)) in entries.iter().zip(places(entries)) {
        let text = match entry.symbol {
            Symbol::Line(colour) => {
                let ends = [at(x, y), at(x + 30, y)];
                area.draw(&PathElement::new(ends, colour.stroke_width(LINE_WIDTH)))?;
                x + 38
            }
            Symbol::Cross(colour) => {
                let stroke = colour.stroke_width(LINE_WIDTH / 2);
                area.draw(&Cross::new(at(x + 8, y), MARK_SIZE, stroke))?;
                x + 24
            }
            Symbol::Heading => x,
        };
        area.draw(&Text::new(entry.label, at(text, y), style(16, HPos::Left)))?;
    }
    Ok(())
}

/// Sets the size of a picture in pixels. The view box keeps the units of the drawing.
pub fn in_pixels(svg: &str, height: u32) -> String {
    let size = |scale: u32| format!(r#"width="{}" height="{}""#, WIDTH * scale, height * scale);
    svg.replacen(&size(FINE), &size(1), 1)
}
