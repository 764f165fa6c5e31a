//! Line plots as SVG, which the programs write to `target/pictures/` and the tutorial shows.

use std::fmt::Write;
use std::path::PathBuf;

/// Pixels of the frame of the axes.
const FRAME: [f64; 4] = [70.0, 20.0, 600.0, 260.0]; // left, top, right, bottom
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

    /// Returns the least and the largest value along an axis, 0 included.
    fn range(&self, axis: usize) -> [f64; 2] {
        let values = self.curves.iter().flat_map(|(_, points)| points.iter().map(|p| p[axis]));
        values.fold([0.0, 0.0], |[least, most], value| [value.min(least), value.max(most)])
    }

    /// Returns the plot as SVG without empty lines, so that it may be in Markdown.
    pub fn svg(&self) -> String {
        let ([x_least, x_most], [y_least, y_most]) = (self.range(0), self.range(1));
        let [left, top, right, bottom] = FRAME;
        let x = |value: f64| left + (value - x_least) / (x_most - x_least) * (right - left);
        let y = |value: f64| bottom - (value - y_least) / (y_most - y_least) * (bottom - top);
        let text = |x: f64, y: f64, anchor: &str, colour: &str, text: &str| {
            format!(
                r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" fill="{colour}">{text}</text>"#
            )
        };
        let number = |value: f64| {
            let digits = 10f64.powf((2.0 - value.abs().max(1e-3).log10().floor()).max(0.0));
            format!("{}", (value * digits).round() / digits)
        };
        let mut lines = vec![
            format!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 620 310" width="620" font-family="sans-serif" font-size="13" role="img" aria-label="{}">"#,
                self.title
            ),
            format!(
                r#"<path d="M{left} {top}V{bottom}H{right}M{left} {:.1}H{right}" fill="none" stroke="{GREY}"/>"#,
                y(0.0)
            ),
            text(left - 6.0, top + 5.0, "end", GREY, &number(y_most)),
            text(left - 6.0, bottom + 5.0, "end", GREY, &number(y_least)),
            text(left, bottom + 18.0, "middle", GREY, &number(x_least)),
            text(right, bottom + 18.0, "middle", GREY, &number(x_most)),
            text((left + right) / 2.0, bottom + 18.0, "middle", GREY, self.axes[0]),
            text(left + 8.0, top + 12.0, "start", GREY, self.axes[1]),
        ];
        for (index, (label, points)) in self.curves.iter().enumerate() {
            let colour = COLOURS[index % COLOURS.len()];
            let mut path = String::new();
            for (number, [px, py]) in points.iter().map(|p| [x(p[0]), y(p[1])]).enumerate() {
                let _ = write!(path, "{}{px:.1} {py:.1}", if number == 0 { 'M' } else { 'L' });
            }
            lines.push(format!(
                r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>"#
            ));
            let along = left + (index as f64 + 0.5) * (right - left) / self.curves.len() as f64;
            lines.push(text(along, bottom + 40.0, "middle", colour, label));
        }
        lines.join("\n") + "\n</svg>\n"
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
