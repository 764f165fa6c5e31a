//! Drawings of mechanisms as SVG, in the colours of the page.

pub mod cubes;

use std::f64::consts::{FRAC_PI_2, PI};

/// A drawing of a mechanism.
pub struct Drawing {
    pub title: &'static str,
    pub caption: &'static str,
    pub svg: String,
}

/// A point in m, x to the right and y upwards.
pub type Point = [f64; 2];

/// The colour of bodies and that of loads, rates and dimensions.
const BODY: &str = "var(--body)";
const MARK: &str = "var(--mark)";
/// The radius of a hinge in pixels.
const HINGE: f64 = 5.5;
/// The font size in pixels.
const FONT: f64 = 14.0;

/// A drawing to scale. Symbols and texts have sizes in pixels.
pub struct Canvas {
    elements: Vec<String>,
    /// Pixels per metre.
    scale: f64,
    x: [f64; 2],
    y: [f64; 2],
}

/// Where a text is relative to its point.
#[derive(Clone, Copy)]
pub enum Side {
    Left,
    Right,
    Above,
    Below,
    Centre,
}

impl Canvas {
    /// A canvas of these ranges in m, with a width in pixels.
    pub fn new(x: [f64; 2], y: [f64; 2], width: f64) -> Self {
        Canvas { elements: Vec::new(), scale: width / (x[1] - x[0]), x, y }
    }

    pub fn finish(self, title: &'static str, caption: &'static str) -> Drawing {
        let [width, height] =
            [self.x, self.y].map(|[low, high]| ((high - low) * self.scale).round());
        let elements = self.elements.join("\n");
        let svg = format!(
            "<svg role=\"img\" aria-label=\"{title}\" xmlns=\"http://www.w3.org/2000/svg\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"system-ui, sans-serif\" \
             font-size=\"{FONT}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\">\n{elements}\n</svg>"
        );
        Drawing { title, caption, svg }
    }

    /// The pixel of a point.
    fn pixel(&self, [x, y]: Point) -> Point {
        [(x - self.x[0]) * self.scale, (self.y[1] - y) * self.scale]
    }

    /// The point at a distance in pixels from another point.
    pub fn beside(&self, [x, y]: Point, [right, up]: Point) -> Point {
        [x + right / self.scale, y + up / self.scale]
    }

    fn path(&mut self, points: &[Point], attributes: &str) {
        let pixel = |&point: &Point| {
            let [x, y] = self.pixel(point);
            format!("{x:.1},{y:.1}")
        };
        let points: Vec<String> = points.iter().map(pixel).collect();
        self.elements.push(format!("<polyline points=\"{}\" {attributes}/>", points.join(" ")));
    }

    pub fn line(&mut self, from: Point, to: Point) {
        self.path(&[from, to], "");
    }

    pub fn dashed(&mut self, points: &[Point]) {
        self.path(points, "stroke-dasharray=\"5 4\" stroke-opacity=\"0.7\"");
    }

    pub fn axis(&mut self, from: Point, to: Point) {
        self.path(&[from, to], "stroke-dasharray=\"9 3 2 3\"");
    }

    /// A closed outline filled as a body.
    pub fn body(&mut self, corners: &[Point]) {
        let closed: Vec<Point> = corners.iter().chain(corners.first()).copied().collect();
        self.path(&closed, &format!("fill=\"{BODY}\""));
    }

    /// A slender body between two points.
    pub fn rod(&mut self, from: Point, to: Point) {
        self.path(&[from, to], "stroke-width=\"11\"");
        self.path(&[from, to], &format!("stroke=\"{BODY}\" stroke-width=\"8\""));
    }

    pub fn text(&mut self, at: Point, side: Side, text: &str) {
        let [x, y] = self.pixel(at);
        let (dx, dy, anchor) = match side {
            Side::Left => (-9.0, 0.35 * FONT, "end"),
            Side::Right => (9.0, 0.35 * FONT, "start"),
            Side::Above => (0.0, -10.0, "middle"),
            Side::Below => (0.0, 10.0 + 0.75 * FONT, "middle"),
            Side::Centre => (0.0, 0.35 * FONT, "middle"),
        };
        self.elements.push(format!(
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" fill=\"currentColor\" \
             stroke=\"none\">{text}</text>",
            x + dx,
            y + dy
        ));
    }

    fn circle(&mut self, at: Point, radius: f64, fill: &str) {
        let [x, y] = self.pixel(at);
        self.elements
            .push(format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\"/>"));
    }

    /// A pin about the axis towards the reader.
    pub fn pin(&mut self, at: Point) {
        self.circle(at, HINGE, "var(--page)");
        self.circle(at, 1.0, "currentColor");
    }

    /// A pin about the vertical axis.
    pub fn vertical_pin(&mut self, at: Point) {
        let [w, h] = [HINGE, 1.6 * HINGE];
        let corners = [[-w, -h], [w, -h], [w, h], [-w, h]].map(|corner| self.beside(at, corner));
        let closed: Vec<Point> = corners.iter().chain(corners.first()).copied().collect();
        self.path(&closed, "fill=\"var(--page)\"");
        self.line(self.beside(at, [0.0, -h]), self.beside(at, [0.0, h]));
    }

    /// A ball in its socket.
    pub fn ball(&mut self, at: Point) {
        self.circle(at, HINGE + 2.5, "var(--page)");
        self.circle(at, HINGE - 1.5, "currentColor");
    }

    /// A centre of mass.
    pub fn centre(&mut self, at: Point) {
        self.circle(at, 2.5, "currentColor");
    }

    /// A hatched support. `outwards` is the angle from the support to the chain in rad.
    pub fn support(&mut self, at: Point, outwards: f64) {
        let (sine, cosine) = outwards.sin_cos();
        // Pixels along and across the support.
        let point = |canvas: &Self, out: f64, across: f64| {
            canvas.beside(at, [out * cosine - across * sine, out * sine + across * cosine])
        };
        self.line(point(self, -9.0, -24.0), point(self, -9.0, 24.0));
        for k in 0..6 {
            let across = -20.0 + 8.0 * f64::from(k);
            self.line(point(self, -9.0, across), point(self, -17.0, across - 8.0));
        }
        self.line(point(self, -9.0, -9.0), at);
        self.line(point(self, -9.0, 9.0), at);
    }

    /// A wall on the left of a point.
    pub fn wall(&mut self, at: Point, half_height: f64) {
        self.line(self.beside(at, [0.0, -half_height]), self.beside(at, [0.0, half_height]));
        let count = (half_height / 5.0) as u32;
        for k in 0..count {
            let up = -half_height + 10.0 * f64::from(k) + 10.0;
            self.line(self.beside(at, [0.0, up]), self.beside(at, [-8.0, up - 8.0]));
        }
    }

    /// A helical spring between two points.
    pub fn spring(&mut self, from: Point, to: Point) {
        const COILS: usize = 8;
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        let across = [-along[1] / length, along[0] / length];
        let point = |k: usize| {
            // Straight ends of a sixth of the length each.
            let part = 1.0 / 6.0 + 2.0 / 3.0 * k as f64 / COILS as f64;
            let side = match k {
                0 | COILS => 0.0,
                _ if k.is_multiple_of(2) => -7.0 / self.scale,
                _ => 7.0 / self.scale,
            };
            [0, 1].map(|i| from[i] + part * along[i] + side * across[i])
        };
        let coils = (0..=COILS).map(point);
        let points: Vec<Point> = [from].into_iter().chain(coils).chain([to]).collect();
        self.path(&points, "");
    }

    /// A spiral spring about a hinge.
    pub fn coil(&mut self, at: Point) {
        const TURNS: f64 = 2.5;
        let point = |canvas: &Self, k: u32| {
            let angle = f64::from(k) * PI / 12.0;
            let radius = HINGE + 3.5 + 1.2 * angle / PI * 2.0;
            canvas.beside(at, [radius * angle.cos(), radius * angle.sin()])
        };
        let points: Vec<Point> = (0..=(TURNS * 24.0) as u32).map(|k| point(self, k)).collect();
        self.path(&points, "");
    }

    /// An arrow of a load, a rate or an axis.
    pub fn arrow(&mut self, from: Point, to: Point) {
        self.path(&[from, to], &format!("stroke=\"{MARK}\" stroke-width=\"2\""));
        let angle = (to[1] - from[1]).atan2(to[0] - from[0]);
        self.arrow_head(to, angle);
    }

    fn arrow_head(&mut self, tip: Point, angle: f64) {
        let corner = |canvas: &Self, turn: f64| {
            let (sine, cosine) = (angle + turn).sin_cos();
            canvas.beside(tip, [9.0 * cosine, 9.0 * sine])
        };
        let corners = [corner(self, PI - 0.4), tip, corner(self, PI + 0.4)];
        self.path(&corners, &format!("fill=\"{MARK}\" stroke=\"{MARK}\" stroke-width=\"1\""));
    }

    /// An arc arrow of a rotation: half axes in pixels, angles in rad.
    pub fn rotation(&mut self, centre: Point, axes: Point, [from, to]: [f64; 2]) {
        const PARTS: u32 = 24;
        let point = |canvas: &Self, angle: f64| {
            canvas.beside(centre, [axes[0] * angle.cos(), axes[1] * angle.sin()])
        };
        let angle = |k: u32| from + (to - from) * f64::from(k) / f64::from(PARTS);
        let points: Vec<Point> = (0..=PARTS).map(|k| point(self, angle(k))).collect();
        self.path(&points, &format!("stroke=\"{MARK}\" stroke-width=\"2\""));
        let direction = (to - from).signum();
        let tangent = [-axes[0] * to.sin() * direction, axes[1] * to.cos() * direction];
        self.arrow_head(point(self, to), tangent[1].atan2(tangent[0]));
    }

    /// Gravity downwards, with its name.
    pub fn gravity(&mut self, at: Point) {
        let end = self.beside(at, [0.0, -36.0]);
        self.arrow(at, end);
        self.text(self.beside(at, [0.0, -18.0]), Side::Right, "g");
    }

    /// A horizontal dimension line with a text.
    pub fn dimension(&mut self, from: Point, to: Point, text: &str) {
        let style = format!("stroke=\"{MARK}\" stroke-width=\"1\"");
        self.path(&[from, to], &style);
        for end in [from, to] {
            let tick = [self.beside(end, [0.0, -5.0]), self.beside(end, [0.0, 5.0])];
            self.path(&tick, &style);
        }
        let middle = [0, 1].map(|i| 0.5 * (from[i] + to[i]));
        self.text(self.beside(middle, [0.0, 5.0]), Side::Below, text);
    }
}

/// The supports' angles: on the left of a chain, above it, below it.
pub const FROM_LEFT: f64 = 0.0;
pub const FROM_ABOVE: f64 = -FRAC_PI_2;
pub const FROM_BELOW: f64 = FRAC_PI_2;
