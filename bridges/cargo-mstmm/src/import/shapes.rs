//! Shapes for looking, as text.

use super::numbers::number;
use super::scope::angles_in_a_unit;
use super::visual::{Shape, Visual};

/// Returns the line of a shape.
pub fn shape(visual: &Visual, snap: f64) -> String {
    let form = match &visual.shape {
        Shape::Box(sides) => format!("box({}) m", list(sides.iter())),
        Shape::Cylinder { radius, length } => format!("cylinder({}) m", list([radius, length])),
        Shape::Capsule { radius, length } => format!("capsule({}) m", list([radius, length])),
        Shape::Sphere { radius } => format!("sphere({}) m", number(*radius)),
        Shape::Mesh { file } => format!("mesh({file:?})"),
    };
    let position = match visual.frame.position.iter().any(|component| *component != 0.0) {
        true => format!(" at [{}] m", list(visual.frame.position.iter())),
        false => String::new(),
    };
    let rotation = match visual.frame.is_parallel() {
        true => String::new(),
        false => {
            let (values, unit) = angles_in_a_unit(&[visual.frame.angles(snap)]);
            format!(" turned rpy({}) {unit}", list(values.iter().flatten()))
        }
    };
    format!("// shape = {form}{position}{rotation};")
}

fn list<'a>(values: impl IntoIterator<Item = &'a f64>) -> String {
    values.into_iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}
