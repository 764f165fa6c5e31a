//! Shapes as visual elements.

use mstmm_codegen::model::{Geometry, Shape};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::import::{angles_of, number};

/// Returns the elements of a shape, one a line. URDF has no capsules: a capsule is a cylinder and two spheres.
pub fn visuals(shape: &Shape) -> Vec<String> {
    let position = Vector3::from(shape.position);
    let here = |geometry: String| vec![element(shape, position, &geometry)];
    let cylinder = |[radius, length]: [f64; 2]| {
        format!("<cylinder radius=\"{}\" length=\"{}\"/>", number(radius), number(length))
    };
    let sphere = |radius: f64| format!("<sphere radius=\"{}\"/>", number(radius));
    match &shape.geometry {
        Geometry::Box(edges) => here(format!("<box size=\"{}\"/>", list(&(*edges).into()))),
        Geometry::Cylinder(lengths) => here(cylinder(*lengths)),
        Geometry::Capsule([radius, length]) => {
            let to_end = rotation(shape) * Vector3::new(0.0, 0.0, length / 2.0);
            let end = |side: f64| element(shape, position + to_end * side, &sphere(*radius));
            vec![element(shape, position, &cylinder([*radius, *length])), end(-1.0), end(1.0)]
        }
        Geometry::Sphere(radius) => here(sphere(*radius)),
        Geometry::Mesh(file) => here(format!("<mesh filename=\"{}\"/>", escaped(file))),
    }
}

fn rotation(shape: &Shape) -> UnitQuaternion<f64> {
    let [w, x, y, z] = shape.orientation;
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

fn element(shape: &Shape, position: Vector3<f64>, geometry: &str) -> String {
    let turned = || angles_of(rotation(shape).to_rotation_matrix().matrix());
    let angles: Vector3<f64> = shape.angles.unwrap_or_else(turned).into();
    let origin = match position == Vector3::zeros() && angles == Vector3::zeros() {
        true => String::new(),
        false => format!("<origin xyz=\"{}\" rpy=\"{}\"/>", list(&position), list(&angles)),
    };
    format!("<visual>{origin}<geometry>{geometry}</geometry></visual>")
}

fn list(vector: &Vector3<f64>) -> String {
    vector.iter().map(|value| number(*value)).collect::<Vec<_>>().join(" ")
}

/// Returns a text as the value of an attribute. A reader makes a space of a line break that is not escaped.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '"' => escaped.push_str("&quot;"),
            letter if letter.is_control() => escaped.push_str(&format!("&#{};", u32::from(letter))),
            letter => escaped.push(letter),
        }
    }
    escaped
}
