//! The elements of a URDF file.

use mstmm_codegen::model::{
    About, Attachment, Body, BodyId, Chain, Frame, Hinge, HingeKind, Inertia, Passive,
};
use nalgebra::{Matrix3, Vector3};
use std::collections::HashSet;
use std::fmt::Write as _;

use super::values::Values;
use super::visuals::visuals;
use crate::import::{Distance, Names, number};

/// The name of the root link, unless it is a floating base. No body can have it.
const GROUND: &str = "ground";

/// The number for a limit that the chain does not have. Readers refuse infinity, and zero would hold the joint. The
/// import reads it as no limit.
const NONE: &str = "1e9";

/// Why a file has efforts and velocities of limits, for a comment in it and a note about it.
pub const NOT_FROM_CHAIN: &str = "URDF requires effort and velocity of a limit, which a chain does not have: 1e9 is no limit, and other \
     efforts are limit_stiffness times 1 deg or 1 mm, not those of a motor";

/// Returns the file of a chain without repeated parts.
pub fn write(chain: &Chain, values: &Values) -> String {
    let mut writer = Writer { chain, values, names: Names::default(), text: String::new() };
    writer.names.unique(GROUND, "");
    let links: Vec<String> =
        chain.bodies.iter().map(|body| writer.names.unique(&body.name.to_string(), "")).collect();
    let base = floating_base(chain);
    let _ = writeln!(writer.text, "<?xml version=\"1.0\"?>\n<robot name=\"{}\">", chain.name);
    if chain.hinges.iter().any(needs_limit) {
        let _ = writeln!(writer.text, "  <!-- {NOT_FROM_CHAIN}. -->");
    }
    if base.is_none() {
        let _ = writeln!(writer.text, "  <link name=\"{GROUND}\"/>");
    }
    for (index, body) in chain.bodies.iter().enumerate() {
        writer.link(body, &links[index]);
    }
    for hinge in chain.hinges.iter() {
        let Attachment::Input(body) = hinge.outboard else { continue };
        if base != Some(body) {
            writer.joint(hinge, &links, body);
        }
    }
    writer.points(&links);
    writer.text + "</robot>\n"
}

/// Returns the floating base, if it is the only body that is not outboard of another one.
fn floating_base(chain: &Chain) -> Option<BodyId> {
    let on_ground =
        chain.hinges.iter().filter(|hinge| matches!(hinge.inboard, Attachment::Ground(_)));
    let mut bases = on_ground.map(|hinge| match hinge.outboard {
        Attachment::Input(body) if chain.bodies[body].name == hinge.name => Some(body),
        _ => None,
    });
    match (bases.next(), bases.next()) {
        (Some(base), None) => base,
        _ => None,
    }
}

struct Writer<'a> {
    chain: &'a Chain,
    values: &'a Values,
    names: Names,
    text: String,
}

impl Writer<'_> {
    fn line(&mut self, indent: usize, text: &str) {
        self.text.push_str(&"  ".repeat(indent));
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn link(&mut self, body: &Body, name: &str) {
        let mass = self.values.of(&body.mass);
        let com = self.values.vector(&body.com);
        let j = about_com(&body.inertia, self.values, mass, com);
        let entries = [
            ("xx", (0, 0)),
            ("xy", (0, 1)),
            ("xz", (0, 2)),
            ("yy", (1, 1)),
            ("yz", (1, 2)),
            ("zz", (2, 2)),
        ];
        let entries = entries.map(|(name, at)| format!("i{name}=\"{}\"", number(j[at]))).join(" ");
        self.line(1, &format!("<link name=\"{name}\">"));
        self.line(2, "<inertial>");
        self.line(3, &format!("<origin xyz=\"{}\"/>", list(com)));
        self.line(3, &format!("<mass value=\"{}\"/>", number(mass)));
        self.line(3, &format!("<inertia {entries}/>"));
        self.line(2, "</inertial>");
        for visual in body.shapes.iter().flat_map(visuals) {
            self.line(2, &visual);
        }
        self.line(1, "</link>");
    }

    fn joint(&mut self, hinge: &Hinge, links: &[String], child: BodyId) {
        let (kind, axis) = match &hinge.kind {
            HingeKind::Pin { axis } if has_limits(hinge) => {
                ("revolute", Some(unit(self.values.vector(axis))))
            }
            HingeKind::Pin { axis } => ("continuous", Some(unit(self.values.vector(axis)))),
            HingeKind::Slider { axis } => ("prismatic", Some(unit(self.values.vector(axis)))),
            HingeKind::Planar { normal } => ("planar", Some(Vector3::ith(*normal, 1.0))),
            HingeKind::Floating => ("floating", None),
            // Other kinds are refused.
            _ => ("fixed", None),
        };
        let (parent, frame) = self.inboard(&hinge.inboard, links);
        let name = self.names.unique(&hinge.name.to_string(), "");
        self.line(1, &format!("<joint name=\"{name}\" type=\"{kind}\">"));
        self.origin(&frame);
        self.line(2, &format!("<parent link=\"{parent}\"/>"));
        self.line(2, &format!("<child link=\"{}\"/>", links[child.index()]));
        if let Some(axis) = axis {
            self.line(2, &format!("<axis xyz=\"{}\"/>", list(axis)));
        }
        if let Some(passive) = hinge.passive.first() {
            self.passive(passive, kind);
        }
        self.line(1, "</joint>");
    }

    /// Returns the parent link and the frame there.
    fn inboard(&self, attachment: &Attachment, links: &[String]) -> (String, Frame) {
        let link = |body: &BodyId| links[body.index()].clone();
        match attachment {
            Attachment::Ground(frame) => (GROUND.to_owned(), frame.clone()),
            Attachment::Input(body) => (link(body), Frame::identity()),
            Attachment::Output(body) => (link(body), self.chain.bodies[*body].output.clone()),
            Attachment::Point(body, point) => {
                (link(body), self.chain.bodies[*body].points[*point].frame.clone())
            }
        }
    }

    fn origin(&mut self, frame: &Frame) {
        let (position, angles) = self.values.frame(frame);
        if position != Vector3::zeros() || angles != Vector3::zeros() {
            self.line(2, &format!("<origin xyz=\"{}\" rpy=\"{}\"/>", list(position), list(angles)));
        }
    }

    /// Writes limits, damping and friction. [`NOT_FROM_CHAIN`] explains the values that URDF requires.
    fn passive(&mut self, passive: &Passive, kind: &str) {
        let distance = if kind == "prismatic" { Distance::Millimetre } else { Distance::Degree };
        let limit = passive.limits.as_ref().map(|limits| {
            let [low, high] =
                [&limits.low, &limits.high].map(|limit| number(self.values.of(limit)));
            let effort = distance.effort(self.values.of(&limits.stiffness));
            format!("lower=\"{low}\" upper=\"{high}\" effort=\"{}\"", number(effort))
        });
        match limit {
            Some(limit) => self.line(2, &format!("<limit {limit} velocity=\"{NONE}\"/>")),
            // URDF requires the element.
            None if kind == "prismatic" => {
                let range = format!("lower=\"-{NONE}\" upper=\"{NONE}\"");
                self.line(2, &format!("<limit {range} effort=\"{NONE}\" velocity=\"{NONE}\"/>"));
            }
            None => {}
        }
        let damping = self.values.of(&passive.damping);
        let friction =
            passive.friction.as_ref().map_or(0.0, |friction| self.values.of(&friction.effort));
        if damping != 0.0 || friction != 0.0 {
            let (damping, friction) = (number(damping), number(friction));
            self.line(2, &format!("<dynamics damping=\"{damping}\" friction=\"{friction}\"/>"));
        }
    }

    /// Writes the named points from which no hinge leaves, and outputs of the same kind, as links without mass.
    fn points(&mut self, links: &[String]) {
        let left: Vec<&Attachment> = self.chain.hinges.iter().map(|hinge| &hinge.inboard).collect();
        let mut points: Vec<(usize, String, Frame)> = Vec::new();
        for id in self.chain.bodies.ids() {
            let body = &self.chain.bodies[id];
            if body.present.output && !left.contains(&&Attachment::Output(id)) {
                points.push((id.index(), "output".to_owned(), body.output.clone()));
            }
            for (index, point) in body.points.iter().enumerate() {
                if !left.contains(&&Attachment::Point(id, index)) {
                    points.push((id.index(), point.name.to_string(), point.frame.clone()));
                }
            }
        }
        let names: Vec<String> =
            points.iter().map(|(body, point, _)| self.in_part(*body, point)).collect();
        let mut seen = HashSet::new();
        let twice: HashSet<&String> = names.iter().filter(|name| !seen.insert(*name)).collect();
        for ((body, point, frame), name) in points.iter().zip(&names) {
            let is_output = point == "output";
            let name = if is_output || twice.contains(name) {
                format!("{}_{point}", links[*body])
            } else {
                name.clone()
            };
            let name = self.names.unique(&name, "_link");
            self.line(1, &format!("<link name=\"{name}\"/>"));
            let joint = self.names.unique(&format!("{name}_fixed"), "_joint");
            self.line(1, &format!("<joint name=\"{joint}\" type=\"fixed\">"));
            self.origin(frame);
            self.line(2, &format!("<parent link=\"{}\"/>", links[*body]));
            self.line(2, &format!("<child link=\"{name}\"/>"));
            self.line(1, "</joint>");
        }
    }

    /// Returns the name of a point after the names of the parts that contain its body.
    fn in_part(&self, body: usize, point: &str) -> String {
        let body = self.chain.bodies.iter().nth(body);
        let parts = body.and_then(|body| body.path.rsplit_once('.'));
        parts.map_or_else(
            || point.to_owned(),
            |(parts, _)| format!("{}_{point}", parts.replace('.', "_")),
        )
    }
}

/// Returns whether URDF requires the element `limit` for a hinge.
fn needs_limit(hinge: &Hinge) -> bool {
    match hinge.kind {
        HingeKind::Pin { .. } => has_limits(hinge),
        HingeKind::Slider { .. } => true,
        _ => false,
    }
}

fn has_limits(hinge: &Hinge) -> bool {
    hinge.passive.first().is_some_and(|passive| passive.limits.is_some())
}

/// Returns an axis with unit length, which URDF requires. A unit vector that a file rounds to seven digits stays.
fn unit(axis: Vector3<f64>) -> Vector3<f64> {
    // The largest component scales, so that no square overflows.
    let scaled = axis / axis.amax();
    let is_unit = (axis.norm() - 1.0).abs() < 1e-6;
    if is_unit || !scaled.norm().is_finite() { axis } else { scaled.normalize() }
}

fn list(vector: Vector3<f64>) -> String {
    vector.iter().map(|value| number(*value)).collect::<Vec<_>>().join(" ")
}

/// Returns the tensor about the centre of mass: J − m (d·d 1 − d dᵀ) if it is about the input, Huygens and Steiner.
fn about_com(inertia: &Inertia, values: &Values, mass: f64, d: Vector3<f64>) -> Matrix3<f64> {
    let [xx, yy, zz, xy, xz, yz] = inertia.tensor.each_ref().map(|value| values.of(value));
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    match inertia.about {
        About::Com => tensor,
        About::Input => tensor - (Matrix3::identity() * d.dot(&d) - d * d.transpose()) * mass,
    }
}
