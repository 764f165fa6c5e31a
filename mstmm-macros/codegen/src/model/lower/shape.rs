//! Shapes of bodies.

use super::context::Context;
use super::dimension::LENGTH;
use super::fields::listed;
use super::orientation::Orientation;
use super::vector::zeros;
use crate::diag::{did_you_mean, nearest};
use crate::model::shape::{Geometry, Shape};
use crate::model::{Dimension, Value};
use crate::syntax::{
    ExprSyntax, OrientationSyntax, SHAPES, ShapeArgument, ShapeSyntax, SpanRange, ValueSyntax,
};

/// The lengths of shapes by their names.
pub(super) const LENGTHS: [&str; 2] = ["radius", "length"];

const FIXED: &str = "a shape has fixed values: write numbers, not parameters or Rust constants";
const POSITIVE: &str = "a length of a shape must be positive";

/// Names of shapes in other programs.
const SYNONYMS: &[(&str, &str)] = &[
    ("cube", "box"),
    ("cuboid", "box"),
    ("block", "box"),
    ("ball", "sphere"),
    ("tube", "cylinder"),
    ("pill", "capsule"),
    ("file", "mesh"),
    ("stl", "mesh"),
];

impl Context<'_> {
    /// Reads the shapes of a body after `=`.
    pub fn read_shapes(&mut self, syntax: &ValueSyntax) -> Option<Vec<Shape>> {
        let ValueSyntax::Shapes(list) = syntax else { bug!("shapes are no other value") };
        // All are read before returning, so that all errors in them are reported.
        let shapes: Vec<_> = list.shapes.iter().map(|shape| self.shape(shape)).collect();
        shapes.into_iter().collect()
    }

    fn shape(&mut self, shape: &ShapeSyntax) -> Option<Shape> {
        let geometry = self.geometry(shape);
        let position = self.shape_position(shape.position.as_ref());
        let orientation = match &shape.orientation {
            None => Some(([1.0, 0.0, 0.0, 0.0], None)),
            Some(orientation) => self.shape_orientation(orientation),
        };
        let (orientation, angles) = orientation?;
        Some(Shape { geometry: geometry?, position: position?, orientation, angles })
    }

    fn geometry(&mut self, shape: &ShapeSyntax) -> Option<Geometry> {
        match &*shape.word.to_string() {
            "box" => self.edges(shape).map(Geometry::Box),
            "cylinder" => self.lengths(shape, LENGTHS).map(Geometry::Cylinder),
            "capsule" => self.lengths(shape, LENGTHS).map(Geometry::Capsule),
            "sphere" => self.lengths(shape, [LENGTHS[0]]).map(|[radius]| Geometry::Sphere(radius)),
            "mesh" => self.file(shape).map(Geometry::Mesh),
            other => {
                let near = SYNONYMS.iter().find(|(synonym, _)| *synonym == other);
                let near = near.map(|&(_, kind)| kind);
                let hint = match near.or_else(|| nearest(other, SHAPES.iter().copied())) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => {
                        let kinds: Vec<_> = SHAPES.iter().map(|kind| format!("`{kind}`")).collect();
                        format!("there are {}", listed(&kinds))
                    }
                };
                self.refuse(&shape.word, format!("unknown shape `{other}`; {hint}"))
            }
        }
    }

    /// Reads the edges of a box.
    fn edges(&mut self, shape: &ShapeSyntax) -> Option<[f64; 3]> {
        let [(None, ShapeArgument::Value(value @ ValueSyntax::Vector(list)))] =
            &shape.arguments[..]
        else {
            return self.misshaped(shape, "box([x, y, z] m)");
        };
        let edges: [Value; 3] = self.components(value, 3, LENGTH)?.try_into().ok()?;
        let edges = self.fixed(&edges, list.extent)?;
        for (edge, ExprSyntax { extent, .. }) in edges.iter().zip(&list.entries) {
            self.positive(*edge, *extent)?;
        }
        Some(edges)
    }

    /// Reads lengths with names, in any order.
    fn lengths<const N: usize>(
        &mut self,
        shape: &ShapeSyntax,
        names: [&str; N],
    ) -> Option<[f64; N]> {
        let word = &shape.word;
        let mut found: [Option<f64>; N] = [None; N];
        for (name, argument) in &shape.arguments {
            let (Some(name), ShapeArgument::Value(value)) = (name, argument) else {
                let written: Vec<_> = names.iter().map(|name| format!("{name} = …")).collect();
                return self.misshaped(shape, &format!("{word}({})", written.join(", ")));
            };
            let Some(index) = names.iter().position(|known| name == known) else {
                let hint = did_you_mean(&name.to_string(), names);
                return self.refuse(name, format!("a {word} has no `{name}`{hint}"));
            };
            if found[index].is_some() {
                return self.refuse(name, format!("`{name}` of the {word} is given twice"));
            }
            let length = self.read_number(value, LENGTH)?;
            let [length] = self.fixed(&[length], value.extent())?;
            found[index] = Some(self.positive(length, value.extent())?);
        }
        let missing = names.iter().zip(&found).filter(|(_, found)| found.is_none());
        let missing: Vec<_> = missing.map(|(name, _)| format!("`{name}`")).collect();
        if !missing.is_empty() {
            return self.refuse(word, format!("a {word} needs {}", listed(&missing)));
        }
        Some(found.map(Option::unwrap_or_default))
    }

    /// Reads the file of a mesh.
    fn file(&mut self, shape: &ShapeSyntax) -> Option<String> {
        match &shape.arguments[..] {
            [(None, ShapeArgument::Text(file, _))] if !file.is_empty() => Some(file.clone()),
            _ => self.misshaped(shape, "mesh(\"file.stl\")"),
        }
    }

    /// Reports arguments of another form.
    fn misshaped<T>(&mut self, shape: &ShapeSyntax, example: &str) -> Option<T> {
        let message = format!("write a {} as `{example}`", shape.word);
        self.refuse(shape.parentheses, message)
    }

    /// Reads a position of the chain's dimension or of space.
    fn shape_position(&mut self, syntax: Option<&ValueSyntax>) -> Option<[f64; 3]> {
        let Some(syntax) = syntax else { return Some([0.0; 3]) };
        let position = match syntax {
            ValueSyntax::Vector(list) if list.entries.len() == zeros().len() => {
                self.vector(list, 3, LENGTH)?.try_into().ok()?
            }
            other => self.read_vector(other, LENGTH)?,
        };
        self.fixed(&position, syntax.extent())
    }

    /// Reads an orientation in space, or an angle in a plane: its quaternion, and the angles if they are written.
    fn shape_orientation(
        &mut self,
        syntax: &OrientationSyntax,
    ) -> Option<([f64; 4], Option<[f64; 3]>)> {
        let orientation = match (self.space, syntax) {
            (Dimension::Plane, OrientationSyntax::Angle(_)) => {
                self.angle(syntax).map(Orientation::about_z)?
            }
            _ => self.turned(syntax)?,
        };
        let quaternion = self.fixed(&orientation.quaternion(), syntax.extent())?;
        let known = |angles: [Value; 3]| angles.map(|angle| angle.known().unwrap_or(f64::NAN));
        Some((quaternion, orientation.angles().map(known)))
    }

    /// Returns the numbers if all are known.
    fn fixed<const N: usize>(&mut self, values: &[Value; N], at: SpanRange) -> Option<[f64; N]> {
        let numbers = values.each_ref().map(|value| value.known().unwrap_or(f64::NAN));
        let is_known = values.iter().all(|value| value.known().is_some());
        if is_known { Some(numbers) } else { self.refuse(at, FIXED) }
    }

    fn positive(&mut self, length: f64, at: SpanRange) -> Option<f64> {
        if length > 0.0 { Some(length) } else { self.refuse(at, POSITIVE) }
    }
}
