//! Still pictures: a frame as SVG, with colours that are readable on white and on black.

mod projection;
mod svg;

use crate::rotation::{Quaternion, Vector, difference, norm, rotated, sum};
use crate::{Body, Motion, PageOptions, SpringEnd, mesh};
use mstmm_runtime::description::{Geometry, Shape};
use projection::Projection;
use std::collections::BTreeMap;
use std::io;
use svg::Svg;

const BODIES: [&str; 6] = ["#3a87c8", "#2a9d8f", "#c98548", "#8f6fc0", "#c26570", "#7a9640"];
const FORCE: &str = "#d0761a";
const MOMENT: &str = "#8a5fd3";
const GREY: &str = "#77808a";

/// The length of the longest arrow relative to the size of the picture.
const ARROW: f64 = 0.24;

/// Returns the picture of a frame.
pub fn svg(motion: &Motion, frame: usize, options: &PageOptions) -> io::Result<String> {
    let refused = |message: String| io::Error::new(io::ErrorKind::InvalidInput, message);
    let Some(row) = motion.row(frame) else {
        return Err(refused(format!("the recording has {} frames, none is {frame}", motion.len())));
    };
    if motion.block("position").is_none() {
        return Err(refused("the recording has no poses; record the group `Poses`".to_owned()));
    }
    if !row.iter().all(|value| value.is_finite()) {
        return Err(refused(format!("frame {frame} has a value that is not finite")));
    }
    let projection = Projection::of(motion.mechanism());
    let meshes = meshes(motion, options);
    let still = Still { motion, row, projection, meshes };
    Ok(still.draw())
}

/// A frame with its projection.
struct Still<'a> {
    motion: &'a Motion,
    row: &'a [f64],
    projection: Projection,
    /// The corners of the meshes that can be read, by the paths of the description.
    meshes: BTreeMap<String, mesh::Corners>,
}

/// Returns the meshes that can be read.
fn meshes(motion: &Motion, options: &PageOptions) -> BTreeMap<String, mesh::Corners> {
    let shapes = motion.mechanism().bodies.iter().flat_map(|body| &body.shapes);
    let read = shapes.filter_map(|shape| match &shape.geometry {
        Geometry::Mesh(path) => {
            mesh::read(options.mesh_folder(), path).ok().map(|corners| (path.to_string(), corners))
        }
        _ => None,
    });
    read.collect()
}

/// An arrow in pixels with its label.
struct Arrow {
    from: [f64; 2],
    along: [f64; 2],
    colour: &'static str,
    heads: usize,
    label: String,
}

impl Still<'_> {
    fn draw(&self) -> String {
        let mechanism = self.motion.mechanism();
        let frames: Vec<(usize, Vector, Quaternion)> = mechanism
            .bodies
            .iter()
            .enumerate()
            .filter_map(|(index, body)| {
                let input = body.input?;
                let at = self.motion.vector("position", input, self.row)?;
                Some((index, at, self.motion.orientation(input, self.row)?))
            })
            .collect();
        let size = self.size(&frames);
        let scale = Svg::METRES / size;
        let mut svg = Svg::default();
        let pixel = |place: Vector| self.projection.pixel(place).map(|it| it * scale);
        for (index, place) in mechanism.points.iter().enumerate() {
            if let (None, Some(at)) = (place.body, self.motion.vector("position", index, self.row))
            {
                svg.ground(pixel(at));
            }
        }
        // Bodies that are farther away are drawn first.
        let mut order: Vec<_> = frames.iter().collect();
        let depth = |(index, at, turned): &(usize, Vector, Quaternion)| {
            let com = mechanism.bodies[*index].com;
            self.projection.depth(sum(*at, rotated(*turned, com)))
        };
        order.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
        for (index, at, turned) in order {
            let body = &mechanism.bodies[*index];
            let colour = BODIES[self.type_number(body) % BODIES.len()];
            let within = |local: Vector| sum(*at, rotated(*turned, local));
            if !body.shapes.iter().any(|it| self.is_drawn(it)) {
                for end in self.ends(body, *at, *turned) {
                    svg.rod(pixel(*at), pixel(end), colour);
                }
            }
            for it in &body.shapes {
                self.shape(&mut svg, it, colour, scale, &|local| pixel(within(local)));
            }
            svg.joint(pixel(*at), GREY);
            svg.mass(pixel(within(body.com)));
        }
        for [from, to] in self.springs(&frames) {
            svg.spring(pixel(from), pixel(to), GREY);
        }
        for arrow in self.arrows(&frames, scale) {
            svg.arrow(arrow.from, arrow.along, arrow.colour, arrow.heads, &arrow.label);
        }
        svg.finish(&format!("{} with the forces at the inputs of its bodies", mechanism.name))
    }

    /// Returns whether a shape can be drawn; a mesh cannot if its file is not read.
    fn is_drawn(&self, shape: &Shape) -> bool {
        match &shape.geometry {
            Geometry::Mesh(path) => self.meshes.contains_key::<str>(path),
            _ => true,
        }
    }

    /// Returns the larger of width and height of all places.
    fn size(&self, frames: &[(usize, Vector, Quaternion)]) -> f64 {
        let mut corners = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut include = |place: Vector| {
            for (axis, value) in self.projection.pixel(place).into_iter().enumerate() {
                corners[0][axis] = corners[0][axis].min(value);
                corners[1][axis] = corners[1][axis].max(value);
            }
        };
        for (index, at, turned) in frames {
            let body = &self.motion.mechanism().bodies[*index];
            include(*at);
            include(sum(*at, rotated(*turned, body.com)));
            self.ends(body, *at, *turned).into_iter().for_each(&mut include);
            for it in &body.shapes {
                include(sum(*at, rotated(*turned, it.position)));
            }
        }
        self.springs(frames).into_iter().flatten().for_each(&mut include);
        let [least, most] = corners;
        let size = (most[0] - least[0]).max(most[1] - least[1]);
        if size > 0.0 { size } else { 1.0 }
    }

    /// Returns the places of the ends of the springs.
    fn springs(&self, frames: &[(usize, Vector, Quaternion)]) -> Vec<[Vector; 2]> {
        let place = |end: &SpringEnd| match end.body {
            None => Some(end.position),
            Some(body) => {
                let (_, at, turned) = frames.iter().find(|(index, ..)| *index == body)?;
                Some(sum(*at, rotated(*turned, end.position)))
            }
        };
        let springs = self.motion.mechanism().springs.iter();
        springs.filter_map(|it| Some([place(&it.ends[0])?, place(&it.ends[1])?])).collect()
    }

    fn type_number(&self, body: &Body) -> usize {
        let mut types: Vec<&str> = Vec::new();
        for it in &self.motion.mechanism().bodies {
            if !types.contains(&it.type_name.as_str()) {
                types.push(&it.type_name);
            }
        }
        types.iter().position(|it| *it == body.type_name).unwrap_or_default()
    }

    /// Returns the places that lines of a body lead to from its input: its other points, or its centre of mass.
    fn ends(&self, body: &Body, at: Vector, turned: Quaternion) -> Vec<Vector> {
        let points = body.points.iter();
        let points = points.filter_map(|it| self.motion.vector("position", it.point, self.row));
        let mut ends: Vec<Vector> = points.collect();
        // An output that is not written is at the input.
        let reach = norm(body.com)
            .max(ends.iter().fold(0.0, |reach, end| norm(difference(*end, at)).max(reach)));
        ends.retain(|end| norm(difference(*end, at)) > 1e-6 * reach);
        if ends.is_empty() {
            ends.push(sum(at, rotated(turned, body.com)));
        }
        ends
    }

    /// Returns the arrows of all inputs and the weights. Forces and weights have one scale, moments another.
    fn arrows(&self, frames: &[(usize, Vector, Quaternion)], scale: f64) -> Vec<Arrow> {
        let mechanism = self.motion.mechanism();
        let mut found: Vec<(Vector, Vector, &'static str)> = Vec::new();
        for (index, at, turned) in frames {
            let Some(input) = mechanism.bodies[*index].input else { continue };
            if let Some(force) = self.motion.vector("force", input, self.row) {
                found.push((*at, force, FORCE));
            }
            // The moment z acts on the inboard element; its negative acts on the body.
            if let Some(moment) = self.motion.vector("moment", input, self.row) {
                found.push((*at, moment.map(|entry| -entry), MOMENT));
            }
            let body = &mechanism.bodies[*index];
            let weight = mechanism.gravity.map(|entry| entry * body.mass);
            found.push((sum(*at, rotated(*turned, body.com)), weight, GREY));
        }
        let largest = |is_moment: bool| {
            let same = found.iter().filter(|(.., colour)| (*colour == MOMENT) == is_moment);
            same.map(|(_, vector, _)| norm(*vector)).fold(0.0, f64::max)
        };
        let [of_forces, of_moments] = [largest(false), largest(true)];
        let arrows = found.iter().filter_map(|(at, vector, colour)| {
            let is_moment = *colour == MOMENT;
            let largest = if is_moment { of_moments } else { of_forces };
            // Moments that are rounding errors of forces are none.
            let size = norm(*vector);
            let is_zero = size <= 0.02 * largest || (is_moment && of_moments <= 1e-9 * of_forces);
            let length = ARROW * Svg::METRES / largest;
            let along = self.projection.pixel(*vector).map(|it| it * length);
            (!is_zero).then(|| Arrow {
                from: self.projection.pixel(*at).map(|it| it * scale),
                along,
                colour,
                heads: if is_moment { 2 } else { 1 },
                label: svg::measure(size, if is_moment { "N·m" } else { "N" }),
            })
        });
        arrows.collect()
    }

    /// Draws a shape from a function that returns the pixel of a place in the body frame.
    fn shape(
        &self,
        svg: &mut Svg,
        shape: &Shape,
        colour: &'static str,
        scale: f64,
        pixel: &dyn Fn(Vector) -> [f64; 2],
    ) {
        let within = |local: Vector| pixel(sum(shape.position, rotated(shape.orientation, local)));
        match &shape.geometry {
            Geometry::Box([x, y, z]) => {
                let corner = |k: usize| {
                    let side = |axis: usize| if k >> axis & 1 == 1 { 0.5 } else { -0.5 };
                    within([x * side(0), y * side(1), z * side(2)])
                };
                svg.hull((0..8).map(corner).collect(), colour);
            }
            Geometry::Cylinder { radius, length } => {
                let rim = |k: usize| {
                    let angle = f64::from(k as u32 % 24) * std::f64::consts::TAU / 24.0;
                    let z = if k < 24 { -0.5 } else { 0.5 };
                    within([radius * angle.cos(), radius * angle.sin(), z * length])
                };
                svg.hull((0..48).map(rim).collect(), colour);
            }
            Geometry::Capsule { radius, length } => {
                let [from, to] = [-0.5, 0.5].map(|side| within([0.0, 0.0, side * length]));
                svg.thick(from, to, colour, 2.0 * radius * scale);
            }
            Geometry::Sphere { radius } => {
                let at = within([0.0; 3]);
                svg.thick(at, at, colour, 2.0 * radius * scale);
            }
            Geometry::Mesh(path) => {
                if let Some(corners) = self.meshes.get::<str>(path) {
                    let places: Vec<[f64; 2]> = corners.iter().map(|it| within(*it)).collect();
                    svg.triangles(&places, colour);
                }
            }
        }
    }
}
