//! The three unit cubes of sections 4.1 and 4.2 in their starting position.

use std::f64::consts::PI;

use super::{Canvas, FROM_LEFT, Point, Side};

/// A hinge of the cubes.
#[derive(Clone, Copy, PartialEq)]
pub enum Symbol {
    Ball,
    /// A pin about z, towards the reader.
    Pin,
    /// A pin about y, upwards.
    VerticalPin,
}

/// What each cube's drawn side lacks of its real one, so that hinges are visible, in m.
const GAP: f64 = 0.07;

/// Draws cubes of 1 m, each with a hinge at its left face. Returns the canvas and the hinges.
pub fn in_a_row(hinges: [Symbol; 3]) -> (Canvas, [Point; 3]) {
    let mut canvas = Canvas::new([-0.4, 3.35], [-0.95, 0.95], 420.0);
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    canvas.support(points[0], FROM_LEFT);
    for ([x, _], name) in points.into_iter().zip(["body 2", "body 4", "body 6"]) {
        let (left, right, half) = (x + GAP, x + 1.0 - GAP, 0.5 - GAP);
        canvas.line([x, 0.0], [left, 0.0]);
        canvas.body(&[[left, -half], [right, -half], [right, half], [left, half]]);
        if x < 2.0 {
            canvas.line([right, 0.0], [x + 1.0, 0.0]);
        }
        canvas.centre([x + 0.5, 0.0]);
        canvas.text([x + 0.5, 0.05], Side::Above, name);
    }
    for (point, symbol) in points.into_iter().zip(hinges) {
        match symbol {
            Symbol::Ball => canvas.ball(point),
            Symbol::Pin => canvas.pin(point),
            Symbol::VerticalPin => {
                canvas.axis([point[0], -0.62], [point[0], 0.62]);
                canvas.vertical_pin(point);
            }
        }
    }
    canvas.dimension([1.0, -0.6], [2.0, -0.6], "1 m");
    canvas.gravity([3.18, 0.45]);
    (canvas, points)
}

/// A rate about y, at the height `y` above a hinge.
pub fn rate_about_y(canvas: &mut Canvas, [x, _]: Point, y: f64, text: &str) {
    canvas.rotation([x, y], [20.0, 7.0], [-1.1 * PI, 0.35 * PI]);
    canvas.text([x + 0.18, y], Side::Right, text);
}

/// A rate about z at a hinge.
pub fn rate_about_z(canvas: &mut Canvas, hinge: Point, text: &str) {
    canvas.rotation(hinge, [17.0, 17.0], [0.15 * PI, 0.85 * PI]);
    canvas.text([hinge[0], 0.45], Side::Above, text);
}
