//! Shapes for looking.

use nalgebra::Vector3;

use super::error::Result;
use super::frame::{Angle, Frame};
use super::xml::Element;

/// A shape of a link, in its frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Visual {
    pub shape: Shape,
    pub frame: Frame,
}

/// The form of a shape; lengths in m. The axes of cylinders and capsules are z.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    Box(Vector3<f64>),
    Cylinder {
        radius: f64,
        length: f64,
    },
    Capsule {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    /// A file, with the factors of its lengths along the axes.
    Mesh {
        file: String,
        scale: Vector3<f64>,
    },
}

impl Shape {
    fn has_size(&self) -> bool {
        match self {
            Shape::Box(sides) => sides.iter().all(|side| *side > 0.0),
            Shape::Cylinder { radius, length } | Shape::Capsule { radius, length } => {
                *radius > 0.0 && *length > 0.0
            }
            Shape::Sphere { radius } => *radius > 0.0,
            Shape::Mesh { .. } => true,
        }
    }

    /// Returns the factors of a mesh whose lengths are not those of its file.
    pub fn scale(&self) -> Option<&Vector3<f64>> {
        match self {
            Shape::Mesh { scale, .. } if *scale != Vector3::repeat(1.0) => Some(scale),
            _ => None,
        }
    }
}

/// Reads the elements `visual` of a link. A mesh without a file and a shape without a positive size are omitted.
pub fn visuals(link: Element) -> Result<Vec<Visual>> {
    let mut visuals = Vec::new();
    for visual in link.children("visual") {
        let Some(shape) = visual.child("geometry").map(shape).transpose()?.flatten() else {
            continue;
        };
        if !shape.has_size() {
            continue;
        }
        let frame = match visual.child("origin") {
            None => Frame::identity(),
            Some(origin) => {
                let angles: [f64; 3] = origin.vector("rpy", [0.0; 3])?.into();
                let angles = angles.map(|angle| Angle::snapped(angle, 1e-12));
                Frame::new(origin.vector("xyz", [0.0; 3])?, angles)
            }
        };
        visuals.push(Visual { shape, frame });
    }
    Ok(visuals)
}

fn shape(geometry: Element) -> Result<Option<Shape>> {
    let round = |tag: &str| geometry.child(tag);
    if let Some(sides) = round("box") {
        return Ok(Some(Shape::Box(sides.vector("size", [0.0; 3])?)));
    }
    if let Some(sphere) = round("sphere") {
        return Ok(Some(Shape::Sphere { radius: sphere.number("radius", 0.0)? }));
    }
    for tag in ["cylinder", "capsule"] {
        if let Some(element) = round(tag) {
            let radius = element.number("radius", 0.0)?;
            let length = element.number("length", 0.0)?;
            return Ok(Some(match tag {
                "cylinder" => Shape::Cylinder { radius, length },
                _ => Shape::Capsule { radius, length },
            }));
        }
    }
    let Some(mesh) = round("mesh") else { return Ok(None) };
    let scale = mesh.vector("scale", [1.0; 3])?;
    let file = mesh.attribute("filename").filter(|file| !file.is_empty());
    Ok(file.map(|file| Shape::Mesh { file: file.to_owned(), scale }))
}
