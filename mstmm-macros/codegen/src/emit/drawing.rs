//! Draws a chain in its initial state, for the docs of its type, so that a user sees errors in the description at once.

mod label;
mod passive;

use super::{gravity, routes};
use crate::examine::Drawing;
use crate::ids::PointId;
use crate::model::{Attachment, Dimension, Element, ElementPoints, Hinge, Role};

/// The longer side of the drawing without margins, in pixels.
const SIZE: f64 = 400.0;
/// The margin, in pixels.
const MARGIN: f64 = 36.0;
const BLUE: &str = "#3a87c8";

/// Returns the picture as an SVG file.
pub fn drawing_file(drawing: &Drawing) -> String {
    let lines = picture(drawing);
    let lines: Vec<&str> = lines.iter().map(|line| line.trim()).collect();
    // In a page of HTML the element needs no namespace, and has the page's font.
    let file = lines.join("\n").replacen(
        "<svg ",
        "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" ",
        1,
    );
    file.trim_start().to_owned() + "\n"
}

/// Returns the lines of the picture as SVG, with the inertial axes and an arrow along gravity.
pub fn picture(drawing: &Drawing) -> Vec<String> {
    let camera = Camera::of(drawing);
    let [mut width, height] = camera.size;
    let is_tree = routes::written(&drawing.chain).len() > 1;
    let (mut labels, most) = match is_tree {
        true => (label::of_tree(drawing, &camera), label::IN_TREE),
        false => (label::of_chain(drawing, &camera), label::IN_CHAIN),
    };
    if !labels.is_empty() {
        passive::add_labels(drawing, &camera, most, &mut labels);
    }
    let sign = gravity::Sign::of(&camera.axes, drawing.gravity);
    let arrow = sign.map(|sign| {
        // To the right of everything else.
        let right = labels.iter().map(label::Label::right).fold(width, f64::max);
        width = right + gravity::ROOM;
        sign.drawn([right, MARGIN])
    });
    let may_be_outside = is_tree || passive::positions(drawing).next().is_some();
    let [left, top, width, height] = match may_be_outside {
        true => label::around(&labels, [width, height]),
        false => [0.0, 0.0, width, height],
    };
    let mut lines = vec![
        String::new(),
        format!(
            " <svg role=\"img\" aria-label=\"The chain at its start\" viewBox=\"{left:.0} {top:.0} {width:.0} \
             {height:.0}\" width=\"{width:.0}\" style=\"max-width:100%;height:auto\" \
             font-size=\"12\" stroke-linecap=\"round\" fill=\"currentColor\">"
        ),
    ];
    lines.extend(triad(drawing.chain.dimension, &camera));
    let elements = drawing.chain.elements.iter().enumerate();
    let bodies = elements.clone().filter(|(_, element)| matches!(element, Element::Body(_)));
    lines.extend(bodies.map(|(number, _)| body(drawing, &camera, number)));
    lines.extend(passive::marks(drawing, &camera));
    lines.extend(passive::springs(drawing, &camera));
    lines.extend(ends(drawing, &camera));
    lines.extend(elements.filter_map(|(number, element)| match element {
        Element::Hinge(index) => {
            Some(hinge(drawing, &camera, number, &drawing.chain.hinges[*index]))
        }
        Element::Body(_) => None,
    }));
    lines.extend(labels.iter().map(label::Label::drawn));
    lines.extend(arrow);
    lines.push(" </svg>".into());
    lines
}

/// The projection onto the picture: a plane chain is seen from the front, a chain in space in an isometric view.
struct Camera {
    /// The projection of each axis: right and down.
    axes: [[f64; 2]; 3],
    /// The scale in pixels per metre.
    scale: f64,
    /// The projection of the inertial origin, in pixels.
    origin: [f64; 2],
    size: [f64; 2],
}

impl Camera {
    fn of(drawing: &Drawing) -> Camera {
        let axes = axes(drawing.chain.dimension, drawing.up);
        let mut camera = Camera { axes, scale: 1.0, origin: [0.0; 2], size: [0.0; 2] };
        let seen = drawing.points.iter().chain(&drawing.centres);
        let seen = seen.chain(passive::positions(drawing)).map(|point| camera.project(point));
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in seen {
            for k in 0..2 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let largest = extent[0].max(extent[1]);
        camera.scale = if largest > 0.0 { SIZE / largest } else { SIZE };
        for k in 0..2 {
            camera.size[k] = extent[k] * camera.scale + 2.0 * MARGIN;
            camera.origin[k] = MARGIN - low[k] * camera.scale;
        }
        camera
    }

    /// Projects a point.
    fn project(&self, point: &[f64; 3]) -> [f64; 2] {
        [0, 1].map(|k| {
            let seen: f64 = self.axes.iter().zip(point).map(|(axis, x)| axis[k] * x).sum();
            self.origin[k] + seen * self.scale
        })
    }
}

/// Returns the projection of each axis, right and down; `up` is the axis that is nearest to the vertical.
pub(super) fn axes(dimension: Dimension, up: usize) -> [[f64; 2]; 3] {
    let (c, s) = (0.866, 0.5);
    let [near, across, upwards] = [[-c, s], [c, s], [0.0, -1.0]];
    match (dimension, up) {
        (Dimension::Plane | Dimension::Line, _) => [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]],
        (Dimension::Space, 0) => [upwards, near, across],
        (Dimension::Space, 1) => [across, upwards, near],
        (Dimension::Space, _) => [near, across, upwards],
    }
}

/// Draws the directions of the inertial axes in the corner.
fn triad(dimension: Dimension, camera: &Camera) -> Vec<String> {
    let [x, y] = [22.0, camera.size[1] - 22.0];
    let arrow = |&axis: &usize| {
        let [right, down] = camera.axes[axis].map(|part| part * 14.0);
        let name = ["x", "y", "z"][axis];
        format!(
            " <path d=\"M{x:.0} {y:.0}l{right:.1} {down:.1}\" stroke=\"currentColor\" \
             opacity=\"0.6\"/><text x=\"{:.1}\" y=\"{:.1}\" font-size=\"10\" opacity=\"0.6\" \
             text-anchor=\"middle\">{name}</text>",
            x + right * 1.5,
            y + down * 1.5 + 3.0
        )
    };
    dimension.translations().iter().map(arrow).collect()
}

/// Returns input and output of an element in the picture.
fn ends_of(drawing: &Drawing, camera: &Camera, element: usize) -> [[f64; 2]; 2] {
    let ElementPoints { input, output, .. } = drawing.of.elements[element];
    [input, output].map(|end| camera.project(&drawing.points[end]))
}

/// Draws a body: bars from its input to its output and to the named points that hinges leave, and a dot at its centre of
/// mass.
fn body(drawing: &Drawing, camera: &Camera, element: usize) -> String {
    let [input, output] = ends_of(drawing, camera, element);
    let centre = camera.project(&drawing.centres[element]);
    let Element::Body(index) = drawing.chain.elements[element] else {
        bug!("element {element} is no body")
    };
    let joined = (0..drawing.chain.bodies[index].points.len())
        .filter_map(|point| drawing.of.joined.get(&(index, point)));
    let bars: String = joined
        .map(|&point| {
            let point = camera.project(&drawing.points[point]);
            format!(
                " <path d=\"M{}L{}\" stroke=\"{BLUE}\" stroke-width=\"7\" stroke-opacity=\"0.45\"/>",
                text(input),
                text(point)
            )
        })
        .collect();
    format!(
        "{bars} <path d=\"M{}L{}\" stroke=\"{BLUE}\" stroke-width=\"7\" stroke-opacity=\"0.45\"/>\
         <path d=\"M{}L{}L{}\" fill=\"none\" stroke=\"{BLUE}\" stroke-width=\"1\"/>\
         <circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\" fill=\"{BLUE}\"/>",
        text(input),
        text(output),
        text(input),
        text(centre),
        text(output),
        centre[0],
        centre[1]
    )
}

/// Draws the attachments of hinges to the ground, hatched, and to moving ends, dashed.
fn ends(drawing: &Drawing, camera: &Camera) -> Vec<String> {
    let chain = &drawing.chain;
    let is_moving = |attachment: &Attachment| {
        attachment.body().is_some_and(|body| chain.bodies[body].role == Role::MovingEnd)
    };
    let elements = chain.elements.iter().zip(&drawing.of.elements);
    let sides = elements.filter_map(|(element, ends)| match *element {
        Element::Hinge(index) => {
            let Hinge { inboard, outboard, .. } = &chain.hinges[index];
            Some([(inboard, ends.input), (outboard, ends.output)])
        }
        Element::Body(_) => None,
    });
    let end = |(attachment, point): (&Attachment, PointId)| {
        let [x, y] = camera.project(&drawing.points[point]);
        let dashes = match attachment {
            Attachment::Ground(_) => "",
            moving if is_moving(moving) => " stroke-dasharray=\"3 3\"",
            _ => return None,
        };
        Some(format!(
            " <path d=\"M{:.1} {:.1}h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7\" fill=\"none\" \
             stroke=\"currentColor\"{dashes}/>",
            x - 14.0,
            y + 9.0
        ))
    };
    sides.flatten().filter_map(end).collect()
}

/// Draws a hinge: a line between its frames, and a symbol for its degrees of freedom: a ring for rotations about axes, a
/// disc for a ball, a box if it translates, a cross for a weld.
fn hinge(drawing: &Drawing, camera: &Camera, element: usize, hinge: &Hinge) -> String {
    let [inboard, outboard] = ends_of(drawing, camera, element);
    let [x, y] = inboard;
    let groups = hinge.kind.spec().groups;
    let sign = if groups.is_empty() {
        format!("<path d=\"M{:.1} {:.1}l8 8m0 -8l-8 8\"", x - 4.0, y - 4.0)
    } else if groups.iter().any(|group| !group.rotational) {
        let (x, y) = (x - 5.0, y - 5.0);
        format!("<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"10\" height=\"10\" fill-opacity=\"0.15\"")
    } else if hinge.kind.spec().quaternion().is_some() {
        format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\"")
    } else {
        format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill-opacity=\"0.15\"")
    };
    let line = match inboard == outboard {
        true => String::new(),
        false => format!(
            "<path d=\"M{}L{}\" stroke=\"currentColor\" stroke-dasharray=\"4 3\"/>",
            text(inboard),
            text(outboard)
        ),
    };
    format!(" {line}{sign} stroke=\"currentColor\" stroke-width=\"1.5\"/>")
}

fn text([x, y]: [f64; 2]) -> String {
    format!("{x:.1} {y:.1}")
}
