//! Shapes for looking, as text.

use super::numbers::number;
use super::scope::angles_in_a_unit;
use super::visual::{Shape, Visual};

/// Returns the lines of the shapes of a body: the field `shape`, and comments for what it cannot have.
pub fn shapes<'a>(visuals: impl Iterator<Item = &'a Visual>, snap: f64) -> Vec<String> {
    let (mut shapes, mut comments) = (Vec::new(), Vec::new());
    for visual in visuals {
        let text = shape(visual, snap);
        match visual.shape.scale() {
            None => shapes.push(text),
            Some(scale) => comments.push(format!("// scaled by [{}]: {text}", list(scale.iter()))),
        }
    }
    let mut lines = match &shapes[..] {
        [] => Vec::new(),
        [only] => vec![format!("shape = {only};")],
        [..] => {
            let entries = shapes.iter().map(|shape| format!("    {shape},"));
            let first = std::iter::once("shape = [".to_owned());
            first.chain(entries).chain(["];".to_owned()]).collect()
        }
    };
    lines.extend(comments);
    lines
}

fn shape(visual: &Visual, snap: f64) -> String {
    let round = |kind: &str, radius: &f64, length: &f64| {
        format!("{kind}(radius = {} m, length = {} m)", number(*radius), number(*length))
    };
    let form = match &visual.shape {
        Shape::Box(sides) => format!("box([{}] m)", list(sides.iter())),
        Shape::Cylinder { radius, length } => round("cylinder", radius, length),
        Shape::Capsule { radius, length } => round("capsule", radius, length),
        Shape::Sphere { radius } => format!("sphere(radius = {} m)", number(*radius)),
        Shape::Mesh { file, .. } => format!("mesh({file:?})"),
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
    format!("{form}{position}{rotation}")
}

fn list<'a>(values: impl IntoIterator<Item = &'a f64>) -> String {
    values.into_iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}
