//! Draws springs and the named points that no hinge leaves.

use super::label::{Label, Style};
use super::{BLUE, Camera, text};
use crate::examine::{Drawing, DrawnEnd, DrawnMark, DrawnSpring};
use std::collections::BTreeSet;

/// The length of the turns of a spring, and half of their width, in pixels.
const TURN: f64 = 7.0;
const WIDTH: f64 = 4.0;
/// The part of a spring without turns at each end.
const STRAIGHT: f64 = 0.15;
/// The most turns of a spring.
const TURNS: f64 = 10.0;

/// Returns the positions in m of everything that this file draws.
pub fn positions(drawing: &Drawing) -> impl Iterator<Item = &[f64; 3]> {
    let ends = drawing.springs.iter().flat_map(|spring| &spring.ends).map(DrawnEnd::at);
    ends.chain(drawing.marks.iter().map(|mark| &mark.at))
}

/// Draws springs as zigzag lines between their ends, which are hatched on the ground, and lines from the inputs of bodies
/// to the ends.
pub fn springs(drawing: &Drawing, camera: &Camera) -> Vec<String> {
    let one = |DrawnSpring { ends, .. }: &DrawnSpring| {
        let [a, b] = [0, 1].map(|end| camera.project(ends[end].at()));
        let ends: String = ends.iter().map(|end| self::end(end, camera)).collect();
        let line = zigzag(a, b);
        format!(
            " {ends}<path d=\"{line}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1\"/>"
        )
    };
    drawing.springs.iter().map(one).collect()
}

/// Draws named points as small squares, with lines from the inputs of their bodies.
pub fn marks(drawing: &Drawing, camera: &Camera) -> Vec<String> {
    let one = |DrawnMark { input, at, .. }: &DrawnMark| {
        let ([x, y], arm) = (camera.project(at), arm(input, at, camera));
        format!(
            " {arm}<rect x=\"{:.1}\" y=\"{:.1}\" width=\"5\" height=\"5\" fill=\"none\" stroke=\"{BLUE}\"/>",
            x - 2.5,
            y - 2.5
        )
    };
    drawing.marks.iter().map(one).collect()
}

/// Adds the names of springs and points, each once, unless there would be more than `most` labels.
pub fn add_labels(drawing: &Drawing, camera: &Camera, most: usize, labels: &mut Vec<Label>) {
    let mut seen = BTreeSet::new();
    let springs = drawing.springs.iter().filter(|spring| seen.insert(&spring.path));
    let springs = springs.map(|DrawnSpring { path, ends, .. }| {
        let [a, b] = [0, 1].map(|end| camera.project(ends[end].at()));
        let at = [(a[0] + b[0]) / 2.0 + 8.0, (a[1] + b[1]) / 2.0 + 4.0];
        Label { text: path.clone(), at, style: Style::Spring }
    });
    let mut seen = BTreeSet::new();
    let marks = drawing.marks.iter().filter(|mark| seen.insert(&mark.path));
    let marks = marks.map(|DrawnMark { path: [_, name], at, .. }| {
        let [x, y] = camera.project(at);
        Label { text: name.clone(), at: [x + 6.0, y - 4.0], style: Style::Point }
    });
    for more in [springs.collect::<Vec<_>>(), marks.collect()] {
        if labels.len() + more.len() <= most {
            more.into_iter().for_each(|label| label.place(labels));
        }
    }
}

/// Draws what joins an end of a spring to the ground or to its body.
fn end(end: &DrawnEnd, camera: &Camera) -> String {
    match end {
        DrawnEnd::Body { input, at } => arm(input, at, camera),
        DrawnEnd::Ground(at) => {
            let [x, y] = camera.project(at);
            format!(
                "<path d=\"M{:.1} {y:.1}h16m-14 5l4 -5m2 5l4 -5m2 5l4 -5\" fill=\"none\" stroke=\"currentColor\"/>",
                x - 8.0
            )
        }
    }
}

/// Draws the line from the input of a body to a point of it.
fn arm(input: &[f64; 3], at: &[f64; 3], camera: &Camera) -> String {
    let [input, at] = [input, at].map(|place| camera.project(place));
    format!("<path d=\"M{}L{}\" stroke=\"{BLUE}\" stroke-width=\"1\"/>", text(input), text(at))
}

/// Returns the path of a spring between two points.
fn zigzag(a: [f64; 2], b: [f64; 2]) -> String {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let length = x.hypot(y);
    let turns = (length * (1.0 - 2.0 * STRAIGHT) / TURN).floor().min(TURNS);
    let mut path = format!("M{}", text(a));
    if turns >= 1.0 {
        let [along, across] = [[x / length, y / length], [-y / length, x / length]];
        let corners = 2.0 * turns;
        // Corners alternate between both sides of the line.
        for corner in 0..=corners as usize {
            let part = STRAIGHT + (1.0 - 2.0 * STRAIGHT) * corner as f64 / corners;
            let side = match corner {
                0 => 0.0,
                last if last == corners as usize => 0.0,
                odd if odd % 2 == 1 => WIDTH,
                _ => -WIDTH,
            };
            let at = [0, 1].map(|k| a[k] + along[k] * part * length + across[k] * side);
            path += &format!("L{}", text(at));
        }
    }
    path + &format!("L{}", text(b))
}

#[cfg(test)]
mod tests {
    use super::super::picture;
    use super::*;
    use crate::diag::Diagnostics;
    use crate::examine::examine;

    fn drawing(text: &str) -> Drawing {
        let chains = crate::read(text.parse().expect("tokens")).expect("a right chain");
        examine(&chains[0].0, &mut Diagnostics::default()).start.expect("a picture")
    }

    const SWING: &str = "plane chain Swing {
        gravity = [0, -9.8];
        body Rod {
            mass = 1; com = [1, 0]; output = [2, 0]; inertia = 1 about com; point side = [1, 0.5];
            point tip = [2, 0.5];
        }
        ground -> pin z -> Rod base -> repeat 2 from rod.tip = base.tip { pin a -> Rod rod } -> pin b -> Rod end;
        spring prop { on = end.side; to = [5, -4]; stiffness = 3; }
        spring cord { on = rod.side; to = last.rod.tip; stiffness = 3; }
    }";

    /// Returns the numbers of the path of each zigzag line.
    fn zigzags(lines: &[String]) -> Vec<Vec<f64>> {
        let paths = lines.iter().flat_map(|line| line.split("<path d=\"").skip(1));
        let paths = paths.filter_map(|path| path.split('"').next());
        let zigzags = paths.filter(|path| path.matches('L').count() > 3);
        let numbers = |path: &str| {
            let numbers = path.split(['M', 'L', ' ']).filter(|word| !word.is_empty());
            numbers.map(|word| word.parse().expect("a number")).collect()
        };
        zigzags.map(numbers).collect()
    }

    #[test]
    fn springs_are_drawn_between_their_ends_in_all_repetitions() {
        let drawing = drawing(SWING);
        let found = zigzags(&picture(&drawing));
        let camera = Camera::of(&drawing);
        let side = |rod: f64| [2.0 * rod + 1.0, 0.5, 0.0];
        let tip = |rod: f64| [2.0 * rod + 2.0, 0.5, 0.0];
        let expected =
            [[side(3.0), [5.0, -4.0, 0.0]], [side(1.0), tip(0.0)], [side(2.0), tip(1.0)]];
        assert_eq!(found.len(), expected.len());
        for ends in expected {
            let [a, b] = ends.map(|end| camera.project(&end));
            let near = |at: &[f64], end: [f64; 2]| (at[0] - end[0]).hypot(at[1] - end[1]) < 0.1;
            let is_it = |line: &&Vec<f64>| near(line, a) && near(&line[line.len() - 2..], b);
            assert_eq!(found.iter().filter(is_it).count(), 1, "{ends:?} is not in {found:?}");
        }
    }

    #[test]
    fn springs_and_points_have_their_names_once() {
        let lines = picture(&drawing(SWING));
        let count =
            |name: &str| lines.iter().filter(|line| line.contains(&format!(">{name}<"))).count();
        assert_eq!([count("prop"), count("cord")], [1, 1]);
        // A name for each body of the text that has the points.
        assert_eq!([count("side"), count("tip")], [3, 3]);
        assert_eq!(lines.iter().filter(|line| line.contains("<rect")).count(), 8);
    }

    #[test]
    fn short_springs_are_straight() {
        assert_eq!(zigzag([0.0, 0.0], [3.0, 4.0]), "M0.0 0.0L3.0 4.0");
        assert_eq!(zigzag([2.0, 2.0], [2.0, 2.0]), "M2.0 2.0L2.0 2.0");
    }
}
