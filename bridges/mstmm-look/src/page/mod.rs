//! Pages: one HTML file with the motion, styles and program.

use crate::encode::Encoder;
use crate::recording::dimensions;
use crate::rotation::{
    Quaternion, Vector, difference, inverse, nearer, norm, product, rotated, sum,
};
use crate::{Body, Column, Motion, mesh};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use mstmm_runtime::description::{Geometry, Shape};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

const STYLE: &str = include_str!("style.css");
const BODY: &str = include_str!("page.html");
const SCRIPTS: [&str; 9] = [
    include_str!("data.js"),
    include_str!("geometry.js"),
    include_str!("view.js"),
    include_str!("render.js"),
    include_str!("scene.js"),
    include_str!("overlay.js"),
    include_str!("plots.js"),
    include_str!("controls.js"),
    include_str!("main.js"),
];

/// Options of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PageOptions {
    title: Option<String>,
    meshes: Option<PathBuf>,
}

impl PageOptions {
    /// Sets the title; by default the name of the chain.
    #[must_use]
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// Sets the folder in which STL and OBJ files of shapes are searched. A body whose meshes are not found is drawn as
    /// one without shapes.
    #[must_use]
    pub fn meshes(mut self, folder: impl Into<PathBuf>) -> Self {
        self.meshes = Some(folder.into());
        self
    }

    pub(crate) fn mesh_folder(&self) -> Option<&Path> {
        self.meshes.as_deref()
    }
}

/// Returns the page of a motion.
pub fn html(motion: &Motion, options: &PageOptions) -> io::Result<String> {
    let refused = |message: &str| Err(io::Error::new(io::ErrorKind::InvalidInput, message));
    if motion.is_empty() {
        return refused("the recording has no frames; call `record` first");
    }
    if motion.block("position").is_none() {
        return refused(
            "the recording has no poses; record the group `Poses` of a chain whose `results` has `poses`",
        );
    }
    let title = options.title.as_deref().unwrap_or(&motion.mechanism().name);
    let (model, values) = model(motion, options, title)?;
    let scripts = SCRIPTS.join("\n");
    let title = escaped(title);
    // Within a script no text of the data can end it.
    let model = model.to_string().replace('<', "\\u003c");
    let values = STANDARD.encode(values);
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{BODY}\n\
         <script type=\"application/json\" id=\"model\">{model}</script>\n\
         <script type=\"text/plain\" id=\"values\">{values}</script>\n\
         <script>\n\"use strict\";\n(() => {{\n{scripts}\n}})();\n</script>\n</body>\n</html>\n"
    ))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Returns what the page knows of the motion, and its compressed values.
fn model(motion: &Motion, options: &PageOptions, title: &str) -> io::Result<(Value, Vec<u8>)> {
    let mechanism = motion.mechanism();
    let fixed = FixedPoints::of(motion);
    let mut encoder = Encoder::new(motion.len());
    let mut encodings = vec![Value::Null; motion.columns().len()];
    for (index, encoding) in encodings.iter_mut().enumerate() {
        if !fixed.columns.contains_key(&index) {
            let values: Vec<f64> = motion.values(index).collect();
            *encoding = encoder.add(&motion.columns()[index].name, &values)?;
        }
    }
    for (index, from) in &fixed.columns {
        encodings[*index] = from.clone();
    }
    let columns = motion.columns().iter().zip(encodings).map(|(column, encoding)| {
        let Column { name, unit, limits } = column;
        json!({ "name": name, "unit": unit, "limits": limits, "values": encoding })
    });
    let blocks = motion
        .blocks()
        .iter()
        .map(|block| json!({ "name": block.name, "first": block.first, "shape": block.shape }));
    let mut meshes = Map::new();
    let bodies: Vec<Value> = mechanism
        .bodies
        .iter()
        .map(|it| body(it, &fixed, &mut |path| add_mesh(&mut meshes, options, path)))
        .collect();
    let points = mechanism.points.iter().map(|it| json!({ "name": it.name, "body": it.body }));
    let springs = mechanism.springs.iter().filter(|it| mechanism.is_drawn(it)).map(|it| {
        let ends = it.ends.map(|end| json!({ "body": end.body, "position": end.position }));
        json!({ "name": it.name, "ends": ends })
    });
    let axes = mechanism
        .axes
        .iter()
        .map(|it| json!({ "hinge": it.hinge, "point": it.point, "direction": it.direction }));
    let model = json!({
        "title": title,
        "docs": mechanism.docs,
        "gravity": mechanism.gravity,
        "dimensions": dimensions(mechanism.dimension),
        "frames": motion.len(),
        "columns": columns.collect::<Vec<Value>>(),
        "blocks": blocks.collect::<Vec<Value>>(),
        "bodies": bodies,
        "points": points.collect::<Vec<Value>>(),
        "springs": springs.collect::<Vec<Value>>(),
        "axes": axes.collect::<Vec<Value>>(),
        "meshes": meshes,
        "stored": encoder.stored(),
    });
    Ok((model, encoder.finish()?))
}

fn body(body: &Body, fixed: &FixedPoints, mesh: &mut impl FnMut(&str)) -> Value {
    let points = body.points.iter().map(|it| {
        json!({ "point": it.point, "place": it.place, "offset": fixed.offsets.get(&it.point) })
    });
    let shapes = body.shapes.iter().map(|it| shape(it, mesh));
    json!({
        "name": body.name,
        "type": body.type_name,
        "mass": body.mass,
        "com": body.com,
        "input": body.input,
        "points": points.collect::<Vec<Value>>(),
        "shapes": shapes.collect::<Vec<Value>>(),
    })
}

fn shape(shape: &Shape, mesh: &mut impl FnMut(&str)) -> Value {
    let geometry = match &shape.geometry {
        Geometry::Box(size) => json!({ "box": size }),
        Geometry::Cylinder { radius, length } => json!({ "cylinder": [radius, length] }),
        Geometry::Capsule { radius, length } => json!({ "capsule": [radius, length] }),
        Geometry::Sphere { radius } => json!({ "sphere": radius }),
        Geometry::Mesh(path) => {
            mesh(path);
            json!({ "mesh": path })
        }
    };
    json!({ "geometry": geometry, "position": shape.position, "orientation": shape.orientation })
}

/// Adds a mesh once, as the text of its corners in `f32`, or a note why it is not shown.
fn add_mesh(meshes: &mut Map<String, Value>, options: &PageOptions, path: &str) {
    if meshes.contains_key(path) {
        return;
    }
    let value = match mesh::read(options.mesh_folder(), path) {
        Ok(corners) => {
            let bytes = corners.iter().flatten().flat_map(|it| (*it as f32).to_le_bytes());
            json!({ "corners": STANDARD.encode(bytes.collect::<Vec<u8>>()) })
        }
        Err(note) => json!({ "note": note }),
    };
    meshes.insert(path.to_owned(), value);
}

/// The connection points that are at rest in their body, whose poses the page computes from that of the body.
struct FixedPoints {
    /// The offset from the input in m, body frame.
    offsets: BTreeMap<usize, Vector>,
    /// For each column that is not stored: its point, and its component of position or orientation.
    columns: BTreeMap<usize, Value>,
}

impl FixedPoints {
    fn of(motion: &Motion) -> Self {
        let mut fixed = FixedPoints { offsets: BTreeMap::new(), columns: BTreeMap::new() };
        let blocks = ["position", "orientation"].map(|name| motion.block(name).map(|it| it.first));
        let [Some(positions), Some(orientations)] = blocks else { return fixed };
        for body in &motion.mechanism().bodies {
            let Some(input) = body.input else { continue };
            for point in body.points.iter().map(|it| it.point) {
                let Some((offset, turned)) = offset(motion, input, point) else { continue };
                fixed.offsets.insert(point, offset);
                for (first, count, key) in
                    [(positions, 3, "position"), (orientations, 4, "orientation")]
                {
                    for entry in 0..count {
                        let from =
                            json!({ "of": input, key: entry, "offset": offset, "turned": turned });
                        fixed.columns.insert(first + count * point + entry, from);
                    }
                }
            }
        }
        fixed
    }
}

/// Returns the pose of a point relative to an input, if it is the same in all frames up to rounding.
fn offset(motion: &Motion, input: usize, point: usize) -> Option<(Vector, Quaternion)> {
    let pose = |at: usize, row: &[f64]| {
        Some((motion.vector("position", at, row)?, motion.orientation(at, row)?))
    };
    let relative = |row: &[f64]| {
        let ((from, turned), (to, also)) = (pose(input, row)?, pose(point, row)?);
        let back = inverse(turned);
        Some((rotated(back, difference(to, from)), product(back, also)))
    };
    let (offset, turned) = relative(motion.rows().next()?)?;
    let is_fixed = motion.rows().all(|row| {
        let (Some((from, by)), Some((to, also))) = (pose(input, row), pose(point, row)) else {
            return false;
        };
        let expected = sum(from, rotated(by, offset));
        let size = norm(from).max(norm(offset)).max(norm(to));
        let also = nearer(also, product(by, turned));
        let angle = product(by, turned).into_iter().zip(also).map(|(a, b)| (a - b).abs());
        norm(difference(to, expected)) <= 1e-9 * size && angle.fold(0.0, f64::max) <= 1e-9
    });
    is_fixed.then_some((offset, turned))
}
