//! An SVG that grows, with its bounds.

use std::fmt::Write;

/// Elements in pixels; the y axis points downwards.
#[derive(Debug, Default)]
pub struct Svg {
    text: String,
    /// The least and the largest coordinates.
    bounds: Option<[[f64; 2]; 2]>,
    /// The boxes of the labels.
    labels: Vec<[f64; 4]>,
}

type Pixel = [f64; 2];

impl Svg {
    /// The size of the mechanism in pixels.
    pub const METRES: f64 = 400.0;

    fn include(&mut self, [x, y]: Pixel, margin: f64) {
        let [least, most] = self.bounds.get_or_insert([[x, y]; 2]);
        for (k, value) in [x, y].into_iter().enumerate() {
            least[k] = least[k].min(value - margin);
            most[k] = most[k].max(value + margin);
        }
    }

    fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // Text can always be written.
        let _ = writeln!(self.text, "{element}");
    }

    /// Hatching below a point of the ground.
    pub fn ground(&mut self, [x, y]: Pixel) {
        self.include([x, y], 24.0);
        self.add(format_args!(
            "<path d=\"M{:.1} {:.1}h36m-30 9l7 -9m3 9l7 -9m3 9l7 -9\" fill=\"none\" stroke=\"#77808a\"/>",
            x - 18.0,
            y + 9.0
        ));
    }

    /// A body between two of its points.
    pub fn rod(&mut self, from: Pixel, to: Pixel, colour: &str) {
        self.thick(from, to, colour, 11.0);
    }

    /// A line of some width with round ends.
    pub fn thick(&mut self, from: Pixel, to: Pixel, colour: &str, width: f64) {
        self.include(from, width);
        self.include(to, width);
        let ([a, b], [c, d]) = (from, to);
        self.add(format_args!(
            "<path d=\"M{a:.1} {b:.1}L{c:.1} {d:.1}\" stroke=\"{colour}\" stroke-width=\"{width:.1}\" stroke-opacity=\"0.8\"/>"
        ));
    }

    /// The outline of some places.
    pub fn hull(&mut self, places: Vec<Pixel>, colour: &str) {
        places.iter().for_each(|place| self.include(*place, 4.0));
        let outline: Vec<String> =
            hull(places).iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        let outline = outline.join(" ");
        self.add(format_args!(
            "<polygon points=\"{outline}\" fill=\"{colour}\" fill-opacity=\"0.75\" stroke=\"{colour}\"/>"
        ));
    }

    /// Triangles as one area.
    pub fn triangles(&mut self, corners: &[Pixel], colour: &str) {
        let mut path = String::new();
        for triangle in corners.chunks_exact(3) {
            // All with the same direction, so that those in front and behind add up.
            let [[a, b], [c, d], [e, f]] = [triangle[0], triangle[1], triangle[2]];
            if (c - a) * (f - b) - (d - b) * (e - a) > 0.0 {
                let _ = write!(path, "M{a:.1} {b:.1}L{c:.1} {d:.1}L{e:.1} {f:.1}z");
            }
        }
        corners.iter().for_each(|place| self.include(*place, 4.0));
        self.add(format_args!("<path d=\"{path}\" fill=\"{colour}\" fill-opacity=\"0.45\"/>"));
    }

    /// A spring: a zig-zag between two straight ends. A spring that points at the viewer has no zig-zag.
    pub fn spring(&mut self, from: Pixel, to: Pixel, colour: &str) {
        self.include(from, 8.0);
        self.include(to, 8.0);
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        let [ux, uy] = along.map(|entry| entry / length.max(1.0));
        let width = 6f64.min(0.1 * length);
        let place = |share: f64, side: f64| {
            let across = side * width;
            [from[0] + share * along[0] - across * uy, from[1] + share * along[1] + across * ux]
        };
        let [[a, b], [c, d]] = [from, place(0.15, 0.0)];
        let mut path = format!("M{a:.1} {b:.1}L{c:.1} {d:.1}");
        for turn in 0..12 {
            let side = if turn % 2 == 0 { 1.0 } else { -1.0 };
            let [x, y] = place(0.15 + 0.7 * (f64::from(turn) + 0.5) / 12.0, side);
            let _ = write!(path, "L{x:.1} {y:.1}");
        }
        let [[a, b], [c, d]] = [place(0.85, 0.0), to];
        let _ = write!(path, "L{a:.1} {b:.1}L{c:.1} {d:.1}");
        self.add(format_args!(
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.8\"/>"
        ));
    }

    /// A joint.
    pub fn joint(&mut self, [x, y]: Pixel, colour: &str) {
        self.include([x, y], 6.0);
        self.add(format_args!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\" fill=\"#ffffff\" stroke=\"{colour}\" stroke-width=\"2\"/>"
        ));
    }

    /// A centre of mass.
    pub fn mass(&mut self, [x, y]: Pixel) {
        self.include([x, y], 6.0);
        self.add(format_args!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"#ffffff\" stroke=\"#3b4450\"/>\
             <path d=\"M{x:.1} {y:.1}h4a4 4 0 0 1 -4 4zh-4a4 4 0 0 1 4 -4z\" fill=\"#3b4450\"/>"
        ));
    }

    /// An arrow with one or two heads and a label at its tip, unless the label would cover another one.
    pub fn arrow(&mut self, from: Pixel, along: Pixel, colour: &str, heads: usize, label: &str) {
        let length = along[0].hypot(along[1]);
        let to = [from[0] + along[0], from[1] + along[1]];
        self.include(from, 4.0);
        // A tenth of a pixel: the arrow points at the viewer.
        if length < 0.1 {
            return;
        }
        let [ux, uy] = along.map(|entry| entry / length);
        let size = 10f64.min(0.6 * length);
        let [sx, sy] = [to[0] - 0.8 * size * ux, to[1] - 0.8 * size * uy];
        self.add(format_args!(
            "<path d=\"M{:.1} {:.1}L{sx:.1} {sy:.1}\" stroke=\"{colour}\" stroke-width=\"2.5\"/>",
            from[0], from[1]
        ));
        for head in 0..heads {
            let back = head as f64 * 0.7 * size;
            let [x, y] = [to[0] - back * ux, to[1] - back * uy];
            let [bx, by] = [x - size * ux, y - size * uy];
            let [wx, wy] = [0.4 * size * uy, -0.4 * size * ux];
            self.add(format_args!(
                "<path d=\"M{x:.1} {y:.1}L{:.1} {:.1}L{:.1} {:.1}z\" fill=\"{colour}\"/>",
                bx + wx,
                by + wy,
                bx - wx,
                by - wy
            ));
        }
        let anchor = if ux < -0.3 { "end" } else { "start" };
        let x = to[0] + if ux < -0.3 { -6.0 } else { 6.0 };
        let y = to[1] + 4.0 + 8.0 * uy;
        let width = 7.0 * label.chars().count() as f64;
        let left = if ux < -0.3 { x - width } else { x };
        let [a, b, c, d] = [left, y - 11.0, left + width, y + 3.0];
        let covers = |it: &[f64; 4]| a < it[2] && it[0] < c && b < it[3] && it[1] < d;
        if self.labels.iter().any(covers) {
            return;
        }
        self.labels.push([a, b, c, d]);
        self.include([if ux < -0.3 { x - width } else { x + width }, y], 8.0);
        self.add(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{colour}\" text-anchor=\"{anchor}\">{label}</text>"
        ));
    }

    /// Returns the picture with this text for those who do not see it.
    pub fn finish(self, label: &str) -> String {
        let [[left, top], [right, bottom]] = self.bounds.unwrap_or([[0.0; 2], [1.0; 2]]);
        let (width, height) = (right - left + 24.0, bottom - top + 24.0);
        let label = label.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{label}\" \
             viewBox=\"{:.0} {:.0} {width:.0} {height:.0}\" width=\"{width:.0}\" style=\"max-width:100%;height:auto\" \
             font-family=\"sans-serif\" font-size=\"13\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n{}</svg>\n",
            left - 12.0,
            top - 12.0,
            self.text
        )
    }
}

/// Returns a value with three digits and a prefix.
pub fn measure(value: f64, unit: &str) -> String {
    let prefixes = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ")];
    let found = prefixes.iter().find(|(factor, _)| value.abs() >= 0.9995 * factor);
    let (factor, prefix) = found.unwrap_or(&(1e-6, "µ"));
    let number = value / factor;
    let decimals = if number.abs() < 9.995 { 2 } else { usize::from(number.abs() < 99.95) };
    format!("{number:.decimals$} {prefix}{unit}")
}

/// Returns the convex hull, counter-clockwise, by Andrew's monotone chain.
fn hull(mut places: Vec<Pixel>) -> Vec<Pixel> {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |places: &mut dyn Iterator<Item = Pixel>| {
        let mut chain: Vec<Pixel> = Vec::new();
        for place in places {
            while let [.., a, b] = chain[..] {
                let turn = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]);
                if turn > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(place);
        }
        chain.pop();
        chain
    };
    let mut outline = half(&mut places.iter().copied());
    outline.extend(half(&mut places.iter().rev().copied()));
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_has_the_corners() {
        let mut places =
            vec![[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0]];
        places.push([0.25, 0.75]);
        assert_eq!(hull(places), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    }

    #[test]
    fn values_have_three_digits() {
        let texts = [12_345.0, 9.81, 0.0421, 1e6, 99.96].map(|value| measure(value, "N"));
        assert_eq!(texts, ["12.3 kN", "9.81 N", "42.1 mN", "1.00 MN", "100 N"]);
    }
}
