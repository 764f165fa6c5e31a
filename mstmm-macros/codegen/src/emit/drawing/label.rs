//! The labels of elements in the picture of a chain.

use super::{Camera, ends_of};
use crate::examine::Drawing;
use crate::model::{BodyId, Element};

/// The largest number of labels in the picture of a chain; more labels would overlap.
pub const IN_CHAIN: usize = 24;
/// The largest number of labels in the picture of a tree, which moves labels apart.
pub const IN_TREE: usize = 32;
/// The height of a line, in pixels.
const LINE: f64 = 13.0;

/// The label of an element, a spring or a point.
pub struct Label {
    pub text: String,
    /// Its left end, or its middle if it labels a body.
    pub at: [f64; 2],
    pub style: Style,
}

/// What a label names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    Body,
    Hinge,
    Spring,
    Point,
}

/// The approximate width of a letter, in pixels.
const LETTER: f64 = 7.0;

impl Label {
    fn is_body(&self) -> bool {
        self.style == Style::Body
    }

    fn width(&self) -> f64 {
        self.text.chars().count() as f64 * LETTER
    }

    /// Returns its left end.
    fn left(&self) -> f64 {
        self.at[0] - if self.is_body() { self.width() / 2.0 } else { 0.0 }
    }

    /// Returns its right end.
    pub fn right(&self) -> f64 {
        self.at[0] + if self.is_body() { self.width() / 2.0 } else { self.width() }
    }

    fn overlaps(&self, other: &Label) -> bool {
        let is_beside = self.right() <= other.left() || other.right() <= self.left();
        !is_beside && (self.at[1] - other.at[1]).abs() < LINE
    }

    /// Adds the label to others, moved until it overlaps none. The label of a point is omitted if that takes it far from
    /// the point.
    pub fn place(mut self, labels: &mut Vec<Label>) {
        // Labels of bodies move down first, others up; then to the other side, and so on.
        let step = if self.is_body() { LINE } else { -LINE };
        let moves = (1..).map(|k| if k % 2 == 1 { f64::from(k) } else { -f64::from(k) });
        let mut moves = moves.take(if self.style == Style::Point { 2 } else { usize::MAX });
        while labels.iter().any(|placed| self.overlaps(placed))
            && let Some(lines) = moves.next()
        {
            self.at[1] += step * lines;
        }
        if self.style != Style::Point || !labels.iter().any(|placed| self.overlaps(placed)) {
            labels.push(self);
        }
    }

    pub fn drawn(&self) -> String {
        let Label { text, at: [x, y], style } = self;
        let style = match style {
            Style::Body => " text-anchor=\"middle\" font-style=\"italic\"",
            Style::Hinge | Style::Spring => "",
            Style::Point => " font-size=\"10\" opacity=\"0.7\"",
        };
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
        of_element(drawing, camera, number).place(&mut labels);
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
            style: Style::Body,
        },
        Element::Hinge(index) => Label {
            text: drawing.chain.hinges[index].path.clone(),
            at: [a[0] + 8.0, a[1] - 8.0],
            style: Style::Hinge,
        },
    }
}
