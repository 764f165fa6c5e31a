//! The labels of elements in the picture of a chain.

use super::{Camera, ends_of};
use crate::examine::Drawing;
use crate::model::{BodyId, Element};

/// The largest number of labels in the picture of a chain; more labels would overlap.
const IN_CHAIN: usize = 24;
/// The largest number of labels in the picture of a tree, which moves labels apart.
const IN_TREE: usize = 32;
/// The height of a line, in pixels.
const LINE: f64 = 13.0;

/// The label of an element.
pub struct Label {
    text: String,
    at: [f64; 2],
    /// Whether it labels a body, centred at its position.
    is_body: bool,
}

/// The approximate width of a letter, in pixels.
const LETTER: f64 = 7.0;

impl Label {
    fn width(&self) -> f64 {
        self.text.chars().count() as f64 * LETTER
    }

    /// Returns its left end.
    fn left(&self) -> f64 {
        self.at[0] - if self.is_body { self.width() / 2.0 } else { 0.0 }
    }

    /// Returns its right end.
    pub fn right(&self) -> f64 {
        self.at[0] + if self.is_body { self.width() / 2.0 } else { self.width() }
    }

    fn overlaps(&self, other: &Label) -> bool {
        let is_beside = self.right() <= other.left() || other.right() <= self.left();
        !is_beside && (self.at[1] - other.at[1]).abs() < LINE
    }

    pub fn drawn(&self) -> String {
        let Label { text, at: [x, y], is_body } = self;
        let style = if *is_body { " text-anchor=\"middle\" font-style=\"italic\"" } else { "" };
        format!(" <text x=\"{x:.1}\" y=\"{y:.1}\"{style}>{text}</text>")
    }
}

/// Returns the labels of all elements of a chain, or none if they would overlap.
pub fn of_chain(drawing: &Drawing, camera: &Camera) -> Vec<Label> {
    let elements = 0..drawing.chain.elements.len();
    if elements.len() > IN_CHAIN {
        return Vec::new();
    }
    elements.map(|number| of_element(drawing, camera, number)).collect()
}

/// Returns the labels of a tree, moved apart: of all elements, or of the first body and the last body of each branch.
pub fn of_tree(drawing: &Drawing, camera: &Camera) -> Vec<Label> {
    let chain = &drawing.chain;
    let has_child =
        |body: BodyId| chain.hinges.iter().any(|hinge| hinge.inboard.body() == Some(body));
    let is_end = |&number: &usize| match chain.elements[number] {
        Element::Body(body) => number == 0 || !has_child(body),
        Element::Hinge(_) => false,
    };
    let mut numbers: Vec<usize> = (0..chain.elements.len()).collect();
    if numbers.len() > IN_TREE {
        numbers.retain(is_end);
    }
    if numbers.len() > IN_TREE {
        return Vec::new();
    }
    let mut labels: Vec<Label> = Vec::new();
    for number in numbers {
        let mut label = of_element(drawing, camera, number);
        // Labels of bodies move down first, those of hinges up; then to the other side, and so on.
        let step = if label.is_body { LINE } else { -LINE };
        let mut moves = (1..).map(|k| if k % 2 == 1 { f64::from(k) } else { -f64::from(k) });
        while labels.iter().any(|placed| label.overlaps(placed))
            && let Some(lines) = moves.next()
        {
            label.at[1] += step * lines;
        }
        labels.push(label);
    }
    labels
}

/// Returns left, top, width and height of a picture of this size with all its labels.
pub fn around(labels: &[Label], [width, height]: [f64; 2]) -> [f64; 4] {
    let left = labels.iter().map(Label::left).fold(0.0, f64::min);
    let right = labels.iter().map(Label::right).fold(width, f64::max);
    let top = labels.iter().map(|label| label.at[1] - LINE).fold(0.0, f64::min);
    let bottom = labels.iter().map(|label| label.at[1] + LINE / 2.0).fold(height, f64::max);
    [left, top, right - left, bottom - top]
}

/// Returns the label of an element: of a body near its middle, of a hinge near its symbol.
fn of_element(drawing: &Drawing, camera: &Camera, number: usize) -> Label {
    let [a, b] = ends_of(drawing, camera, number);
    match drawing.chain.elements[number] {
        Element::Body(index) => Label {
            text: drawing.chain.bodies[index].path.clone(),
            at: [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0 + 20.0],
            is_body: true,
        },
        Element::Hinge(index) => Label {
            text: drawing.chain.hinges[index].path.clone(),
            at: [a[0] + 8.0, a[1] - 8.0],
            is_body: false,
        },
    }
}
