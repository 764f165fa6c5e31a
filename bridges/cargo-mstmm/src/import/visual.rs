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
    Cylinder { radius: f64, length: f64 },
    Capsule { radius: f64, length: f64 },
    Sphere { radius: f64 },
    Mesh { file: String },
}

/// Reads the elements `visual` of a link; a mesh without a file is omitted.
pub fn visuals(link: Element) -> Result<Vec<Visual>> {
    let mut visuals = Vec::new();
    for visual in link.children("visual") {
        let Some(shape) = visual.child("geometry").map(shape).transpose()?.flatten() else {
            continue;
        };
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
    let file = round("mesh").and_then(|mesh| mesh.attribute("filename"));
    Ok(file.map(|file| Shape::Mesh { file: file.to_owned() }))
}
