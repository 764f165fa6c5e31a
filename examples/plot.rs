//! Line plots as SVG, which the programs write to `target/pictures/` and the tutorial shows.

use std::fmt::Write;
use std::path::PathBuf;

/// Pixels of the frame of the axes.
const FRAME: [f64; 4] = [50.0, 30.0, 600.0, 270.0]; // left, top, right, bottom
/// Pixels between lines of text.
const LINE: f64 = 18.0;
/// Pixels of the widest letters on average.
const LETTER: f64 = 7.0;
const COLOURS: [&str; 3] = ["#3a87c8", "#d0761a", "#2f9e62"];
/// Readable on white and on black.
const GREY: &str = "#77808a";

/// Curves over a common axis.
pub struct Plot {
    title: &'static str,
    axes: [&'static str; 2],
    curves: Vec<(&'static str, Vec<[f64; 2]>)>,
}

impl Plot {
    /// Returns a plot without curves. The title describes it in words; the axes have quantities with units.
    pub fn new(title: &'static str, axes: [&'static str; 2]) -> Self {
        Self { title, axes, curves: Vec::new() }
    }

    /// Adds a curve through points.
    pub fn curve(mut self, label: &'static str, points: Vec<[f64; 2]>) -> Self {
        self.curves.push((label, points));
        self
    }

    /// Returns the ticks of an axis, at round values around all values and 0.
    fn ticks(&self, axis: usize) -> Vec<f64> {
        let values = self.curves.iter().flat_map(|(_, points)| points.iter().map(|p| p[axis]));
        let [least, most] =
            values.fold([0.0, 0.0], |[least, most], value| [value.min(least), value.max(most)]);
        // Rounding errors do not add a tick.
        let margin = 1e-3 * (most - least);
        let decade = 10f64.powf((most - least).log10().floor());
        let steps = [0.1, 0.2, 0.5, 1.0].map(|step| step * decade);
        let step = steps.into_iter().find(|step| (most - least) / step < 7.0).unwrap_or(decade);
        let first = ((least + margin) / step).floor() as i32;
        let last = ((most - margin) / step).ceil() as i32;
        (first..=last).map(|number| f64::from(number) * step).collect()
    }

    /// Returns the plot as SVG without empty lines, so that it may be in Markdown.
    pub fn svg(&self) -> String {
        let [left, top, right, bottom] = FRAME;
        let ticks = [self.ticks(0), self.ticks(1)];
        let along = |axis: usize, [from, to]: [f64; 2], value: f64| {
            let (first, last) = (ticks[axis][0], ticks[axis][ticks[axis].len() - 1]);
            from + (value - first) / (last - first) * (to - from)
        };
        let x = |value: f64| along(0, [left, right], value);
        let y = |value: f64| along(1, [bottom, top], value);

        let mut lines: Vec<String> = Vec::new();
        for &tick in &ticks[1] {
            let width = if tick == 0.0 { 1.0 } else { 0.3 };
            let at = y(tick);
            lines.push(format!(
                r#"<path d="M{left} {at:.1}H{right}" stroke="{GREY}" stroke-width="{width}"/>"#
            ));
            lines.push(text([left - 6.0, at + 5.0], "end", GREY, &number(tick)));
        }
        for &tick in &ticks[0] {
            lines.push(text([x(tick), bottom + LINE], "middle", GREY, &number(tick)));
        }
        lines.push(text([(left + right) / 2.0, bottom + 2.0 * LINE], "middle", GREY, self.axes[0]));
        lines.push(text([8.0, top - 12.0], "start", GREY, self.axes[1]));
        for (index, (_, points)) in self.curves.iter().enumerate() {
            let mut path = String::new();
            for (number, [px, py]) in points.iter().map(|p| [x(p[0]), y(p[1])]).enumerate() {
                let _ = write!(path, "{}{px:.1} {py:.1}", if number == 0 { 'M' } else { 'L' });
            }
            let colour = COLOURS[index % COLOURS.len()];
            lines.push(format!(
                r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>"#
            ));
        }
        let height = self.legend(bottom + 3.5 * LINE, &mut lines) + 0.5 * LINE;
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 620 {height}" width="620" font-family="sans-serif" font-size="13" role="img" aria-label="{}">"#,
            self.title
        ) + "\n"
            + &lines.join("\n")
            + "\n</svg>\n"
    }

    /// Adds the labels of the curves in rows from `y` on, and returns that of the last row.
    fn legend(&self, mut y: f64, lines: &mut Vec<String>) -> f64 {
        let [left, _, right, _] = FRAME;
        let mut x = left;
        for (index, (label, _)) in self.curves.iter().enumerate() {
            let width = LETTER * label.chars().count() as f64 + 3.0 * LINE;
            if x > left && x + width > right {
                (x, y) = (left, y + LINE);
            }
            let colour = COLOURS[index % COLOURS.len()];
            let middle = y - 4.5;
            lines.push(format!(
                r#"<path d="M{x} {middle}h{LINE}" stroke="{colour}" stroke-width="3"/>"#
            ));
            lines.push(text([x + 1.5 * LINE, y], "start", colour, label));
            x += width;
        }
        y
    }

    /// Writes the plot to `target/pictures/`.
    #[cfg_attr(test, allow(dead_code))]
    pub fn save(&self, name: &str) {
        let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
        let here = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target");
        let folder = target.unwrap_or_else(here).join("pictures");
        let path = folder.join(name).with_extension("svg");
        match std::fs::create_dir_all(&folder).and_then(|()| std::fs::write(&path, self.svg())) {
            Ok(()) => println!("{}: {}", self.title, path.display()),
            Err(error) => println!("{} cannot be written: {error}", path.display()),
        }
    }

    /// Compares the plot with that of the tutorial.
    #[cfg(test)]
    pub fn check(&self, name: &str) {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src/tutorial");
        let path = folder.join(name).with_extension("svg");
        if std::env::var_os("MSTMM_BLESS").is_some() {
            std::fs::write(&path, self.svg()).expect("a writable folder");
        }
        let kept = std::fs::read_to_string(&path).expect("MSTMM_BLESS=1 draws the picture");
        assert!(kept == self.svg(), "MSTMM_BLESS=1 draws {} anew", path.display());
    }
}

fn text([x, y]: [f64; 2], anchor: &str, colour: &str, text: &str) -> String {
    format!(r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{text}</text>"#)
}

/// Returns a tick without the rounding errors of its product.
fn number(value: f64) -> String {
    format!("{}", (value * 1e6).round() / 1e6).replace('-', "−")
}
