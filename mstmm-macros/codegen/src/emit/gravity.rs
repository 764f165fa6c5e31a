//! Draws the arrow of gravity on the picture of a chain.

/// The width of the space for the arrow, in pixels.
pub const ROOM: f64 = 60.0;
/// The length of an arrow that is not foreshortened, in pixels.
const LENGTH: f64 = 28.0;
/// The smallest foreshortening: a shorter arrow is drawn as if it pointed along the line of sight.
const SHORTEST: f64 = 0.2;
/// The length of the strokes of the arrow head, in pixels.
const HEAD: f64 = 7.0;

/// The direction of gravity on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sign {
    /// In this direction, pixels to the right and down.
    Across([f64; 2]),
    /// Out of the picture.
    Towards,
    /// Into the picture.
    Away,
}

impl Sign {
    /// Returns the direction of gravity for this projection of the inertial axes; none if gravity is unknown.
    pub fn of(axes: &[[f64; 2]; 3], gravity: Option<[f64; 3]>) -> Option<Sign> {
        let gravity = gravity?;
        let largest = gravity.iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
        let gravity = gravity.map(|part| part / largest);
        let size = gravity.iter().map(|part| part * part).sum::<f64>().sqrt();
        let seen = [0, 1].map(|k| {
            let parts = axes.iter().zip(gravity).map(|(axis, part)| axis[k] * part);
            parts.sum::<f64>() / size
        });
        if seen[0].hypot(seen[1]) >= SHORTEST {
            return Some(Sign::Across(seen.map(|part| part * LENGTH)));
        }
        // The picture is seen from where all coordinates are positive.
        let towards = gravity.iter().sum::<f64>() > 0.0;
        Some(if towards { Sign::Towards } else { Sign::Away })
    }

    /// Draws the symbol in the middle of the space that starts at this position.
    pub fn drawn(self, [left, middle]: [f64; 2]) -> String {
        let [x, y] = [left + ROOM / 2.0, middle];
        let (sign, [right, down]) = match self {
            Sign::Across(direction) => (arrow([x, y], direction), label_offset(direction)),
            Sign::Towards => {
                let dot = format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\"/>");
                (ring([x, y]) + &dot, [18.0, 0.0])
            }
            Sign::Away => {
                let cross = format!(
                    "<path d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\" stroke=\"currentColor\" \
                     stroke-width=\"1.5\"/>",
                    x - 4.0,
                    y - 4.0
                );
                (ring([x, y]) + &cross, [18.0, 0.0])
            }
        };
        format!(
            " {sign}<text x=\"{:.1}\" y=\"{:.1}\" font-style=\"italic\" \
             text-anchor=\"middle\">g</text>",
            x + right,
            y + down + 4.0
        )
    }
}

/// Draws an arrow with its middle at this position.
fn arrow([x, y]: [f64; 2], [right, down]: [f64; 2]) -> String {
    let length = right.hypot(down);
    let [along, across] =
        [[right, down], [-down, right]].map(|direction| direction.map(|part| part / length));
    let stroke = |side: f64| [0, 1].map(|k| HEAD * (-0.87 * along[k] + side * 0.5 * across[k]));
    let [[left_x, left_y], [right_x, right_y]] = [stroke(1.0), stroke(-1.0)];
    format!(
        "<path d=\"M{:.1} {:.1}l{right:.1} {down:.1}m{left_x:.1} {left_y:.1}l{:.1} {:.1}l{right_x:.1} \
         {right_y:.1}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\"/>",
        x - right / 2.0,
        y - down / 2.0,
        -left_x,
        -left_y
    )
}

/// Returns the offset of the letter: to the right of an arrow, above a horizontal one.
fn label_offset([right, down]: [f64; 2]) -> [f64; 2] {
    let distance = 13.0 / right.hypot(down);
    let across = [down * distance, -right * distance];
    let turned = across[0] < -1e-9 || (across[0].abs() <= 1e-9 && across[1] > 0.0);
    if turned { across.map(|part| -part) } else { across }
}

fn ring([x, y]: [f64; 2]) -> String {
    format!(
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8\" fill=\"none\" stroke=\"currentColor\" \
         stroke-width=\"1.5\"/>"
    )
}

#[cfg(test)]
mod tests {
    use super::super::drawing::{axes, picture};
    use super::Sign;
    use crate::diag::Diagnostics;
    use crate::examine::{Drawing, examine};
    use crate::model::Dimension;

    /// A chain with this gravity as it is drawn.
    fn drawing(text: &str) -> Drawing {
        let chains = crate::read(text.parse().expect("tokens")).expect("a right chain");
        examine(&chains[0].0, &mut Diagnostics::default()).start.expect("a picture")
    }

    fn in_space(gravity: &str, rest: &str) -> Drawing {
        drawing(&format!(
            "chain C {{ {gravity} param tilt = 30 deg;
                body Rod {{ mass = 1; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }}
                ground -> pin a -> Rod rod; {rest} }}"
        ))
    }

    fn sign(drawing: &Drawing) -> Option<Sign> {
        Sign::of(&axes(drawing.chain.dimension, drawing.up), drawing.gravity)
    }

    /// The direction to the right and down, of unit length.
    fn direction(drawing: &Drawing) -> [f64; 2] {
        let Some(Sign::Across([right, down])) = sign(drawing) else { panic!("no arrow") };
        [right, down].map(|part| part / right.hypot(down))
    }

    #[track_caller]
    fn assert_near(found: [f64; 2], expected: [f64; 2]) {
        let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        assert!(off < 1e-3, "{found:?} is not {expected:?}");
    }

    #[test]
    fn gravity_points_down_along_each_axis() {
        for gravity in ["[-9.8, 0, 0]", "[0, -9.8, 0]", "[0, 0, -9.8]", "[0, 0, -1e-300]"] {
            assert_near(direction(&in_space(&format!("gravity = {gravity};"), "")), [0.0, 1.0]);
        }
        assert_near(direction(&in_space("gravity = [0, 0, 9.8];", "")), [0.0, -1.0]);
    }

    /// As far across as down: on the picture y leads to the right and down by 30°.
    #[test]
    fn gravity_that_is_tilted_points_where_the_axes_are_drawn() {
        let tilted = in_space("gravity = [0, 5, -5 - 1e-9];", "");
        assert_near(direction(&tilted), [0.5, 0.866]);
        let by_parameter = in_space("gravity = [sin(tilt), 0, -cos(tilt)];", "");
        let (across, down) = (0.5 * 0.866, 0.5 * 0.5 + 0.866);
        let length = f64::hypot(across, down);
        assert_near(direction(&by_parameter), [-across / length, down / length]);
    }

    #[test]
    fn gravity_along_the_view_is_a_ring() {
        assert_eq!(sign(&in_space("gravity = [-1, -1, -1];", "")), Some(Sign::Away));
        assert_eq!(sign(&in_space("gravity = [2, 2, 2];", "")), Some(Sign::Towards));
        assert_eq!(sign(&in_space("gravity = [-9, -9, -9.5];", "")), Some(Sign::Away));
    }

    #[test]
    fn gravity_that_is_not_known_or_zero_is_not_drawn() {
        for gravity in ["", "gravity = input;", "gravity = [0, 0, 0];"] {
            assert_eq!(sign(&in_space(gravity, "")), None);
        }
    }

    #[test]
    fn gravity_lies_in_the_plane_and_along_the_line() {
        let plane = "plane chain C { gravity = [3, -4];
            body Rod { mass = 1; com = [1, 0]; inertia = 1 about com; } ground -> pin a -> Rod rod; }";
        assert_eq!(axes(Dimension::Plane, 2), [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]]);
        assert_near(direction(&drawing(plane)), [0.6, 0.8]);
        let line =
            "line chain C { gravity = -9.8; body Car { mass = 1; } ground -> slider a -> Car b; }";
        assert_near(direction(&drawing(line)), [-1.0, 0.0]);
    }

    /// All that is drawn before it ends to the left of the arrow's room.
    #[test]
    fn the_arrow_is_beside_the_chain() {
        let long = "plane chain C { gravity = [0, -9.8];
            body Rod { mass = 1; com = [1, 0]; output = [2, 0]; inertia = 1 about com; }
            ground -> repeat 4 { pin a -> Rod rod } -> pin a_hinge_with_a_long_name -> Rod last; }";
        let lines = picture(&drawing(long));
        let arrow = lines.iter().find(|line| line.contains(">g<")).expect("an arrow");
        let coordinate = |text: &str, before: &str| -> f64 {
            let (_, rest) = text.split_once(before).expect("a coordinate");
            rest.split([' ', '"']).next().and_then(|x| x.parse().ok()).expect("a number")
        };
        let width = coordinate(&lines[1], "viewBox=\"0 0 ");
        let at = coordinate(arrow, "d=\"M");
        assert!(at + 28.0 < width, "{arrow}");
        let names = lines.iter().filter(|line| line.contains("a_hinge_with_a_long_name"));
        let ends = names.map(|name| coordinate(name, "<text x=\"") + 24.0 * 6.0);
        assert!(ends.chain([436.0]).all(|end| end < at), "{lines:?}");
    }
}
