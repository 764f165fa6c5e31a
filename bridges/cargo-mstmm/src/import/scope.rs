//! The bodies and hinges of a scope as text: those of a part, or all that are in no part.

use super::bodies::{Body, Tree};
use super::expressions::Expressions;
use super::frame::{Angle, Frame};
use super::numbers::number;
use super::robot::{Joint, Kind, Robot};
use super::shapes::shapes;
use super::stiffness::Distance;

/// Names in the text, for each body; in a part those of the first branch are written.
#[derive(Clone)]
pub struct NameTable {
    pub bodies: Vec<String>,
    /// The inboard hinges.
    pub hinges: Vec<String>,
    /// The points of the inboard body from which the hinges leave.
    pub places: Vec<String>,
    /// The points of the links that are fixed to each body.
    pub fixed: Vec<Vec<String>>,
}

/// A robot, as merged, with the setting that its text depends on.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    pub robot: &'a Robot,
    pub tree: &'a Tree,
    /// The tolerance of angles in rad.
    pub snap: f64,
}

/// What is written once, for one or several branches.
pub struct Scope<'a> {
    pub source: Source<'a>,
    pub names: &'a NameTable,
    /// The branches with their bodies, depth first.
    pub branches: &'a [Vec<usize>],
    pub expressions: Expressions,
}

impl<'a> Source<'a> {
    pub fn joint(self, body: usize) -> Option<&'a Joint> {
        self.tree.bodies[body].joint.map(|joint| &self.robot.joints[joint])
    }

    pub fn link_name(self, body: usize) -> &'a str {
        &self.robot.links[self.tree.bodies[body].link].name
    }
}

impl<'a> Scope<'a> {
    fn bodies(&self, position: usize) -> Vec<&'a Body> {
        self.branches.iter().map(|branch| &self.source.tree.bodies[branch[position]]).collect()
    }

    fn joints(&self, position: usize) -> Vec<&'a Joint> {
        self.branches.iter().filter_map(|branch| self.source.joint(branch[position])).collect()
    }

    /// Returns the fields of a body type.
    pub fn fields(&mut self, position: usize) -> Vec<String> {
        let bodies = self.bodies(position);
        let first = self.branches[0][position];
        let name = self.names.bodies[first].clone();
        let masses: Vec<f64> = bodies.iter().map(|body| body.mass.mass).collect();
        let mut fields =
            vec![format!("mass = {} kg;", self.number(&masses, &format!("{name}_mass")))];
        let com = self.vector(&each(&bodies, |body| body.mass.com.into()), &format!("{name}_com"));
        fields.push(format!("com = {com} m;"));
        fields.push(format!("inertia = {} kg*m^2 about com;", self.inertia(&bodies, &name)));
        let children = bodies[0].children.len();
        for index in 0..children {
            let child = |body: &Body| self.source.tree.bodies[body.children[index]].frame.clone();
            let frames: Vec<Frame> = bodies.iter().map(|body| child(body)).collect();
            let place = &self.names.places[bodies[0].children[index]];
            // The only child continues the route, a branch leaves from a named point.
            let (word, slot) = if children == 1 {
                ("output".to_owned(), "output")
            } else {
                (format!("point {place}"), &**place)
            };
            fields.push(format!("{word} = {};", self.frame(&frames, &format!("{name}_{slot}"))));
        }
        for (index, point) in self.names.fixed[first].clone().iter().enumerate() {
            let frames: Vec<Frame> =
                bodies.iter().map(|body| body.fixed[index].1.clone()).collect();
            if !frames.iter().all(Frame::is_identity) {
                let frame = self.frame(&frames, &format!("{name}_{point}"));
                fields.push(format!("point {point} = {frame};"));
            }
        }
        let is_same = bodies.iter().all(|body| body.visuals == bodies[0].visuals);
        let visuals = bodies[0].visuals.iter().filter(|_| is_same);
        fields.extend(shapes(visuals, self.source.snap));
        fields
    }

    fn number(&mut self, values: &[f64], place: &str) -> String {
        self.expressions.number(values, largest([values]), place)
    }

    fn vector(&mut self, vectors: &[[f64; 3]], place: &str) -> String {
        let scale = largest(vectors);
        format!("[{}]", self.expressions.list(&components(vectors), scale, place, &["x", "y", "z"]))
    }

    fn inertia(&mut self, bodies: &[&Body], name: &str) -> String {
        let entry = |i: usize, j: usize| each(bodies, |body| body.mass.tensor[(i, j)]);
        let moments = [entry(0, 0), entry(1, 1), entry(2, 2)];
        let products = [entry(0, 1), entry(0, 2), entry(1, 2)];
        let scale = largest(&moments);
        let mut list =
            |values: &[Vec<f64>], names: &[&str]| self.expressions.list(values, scale, name, names);
        let moments = list(&moments, &["xx", "yy", "zz"]);
        if products.iter().flatten().all(|product| *product == 0.0) {
            return format!("diag({moments})");
        }
        format!("tensor({moments}, {})", list(&products, &["xy", "xz", "yz"]))
    }

    /// Returns a position, and the orientation unless the axes are parallel.
    pub fn frame(&mut self, frames: &[Frame], place: &str) -> String {
        let position = self.vector(&each(frames, |frame| frame.position.into()), place);
        match frames.iter().all(Frame::is_parallel) {
            true => format!("{position} m"),
            false => format!("{position} m turned {}", self.orientation(frames, place)),
        }
    }

    /// Returns a rotation by roll, pitch and yaw.
    pub fn orientation(&mut self, frames: &[Frame], place: &str) -> String {
        let angles = each(frames, |frame| frame.angles(self.source.snap));
        let (values, unit) = angles_in_a_unit(&angles);
        let scale = largest(&values);
        let names = ["roll", "pitch", "yaw"];
        format!("rpy({}) {unit}", self.expressions.list(&components(&values), scale, place, &names))
    }

    /// Returns the kind of a hinge with its axis.
    pub fn hinge_kind(&mut self, position: usize) -> String {
        let joints = self.joints(position);
        let Some(first) = joints.first() else { return String::new() };
        let word = match first.kind {
            Kind::Fixed => return "weld".to_owned(),
            Kind::Floating => return "floating".to_owned(),
            Kind::Ball => return "ball".to_owned(),
            Kind::Revolute | Kind::Continuous => "pin",
            Kind::Prismatic => "slider",
            Kind::Planar => "planar",
        };
        let axes = each(&joints, |joint| <[f64; 3]>::from(joint.axis));
        let principal = (0..3).find(|i| (0..3).all(|j| i == &j || axes[0][j] == 0.0));
        match principal {
            Some(axis) if axes.iter().all(|other| *other == axes[0]) => {
                // A plane has no sign.
                let minus =
                    if axes[0][axis] < 0.0 && first.kind != Kind::Planar { "-" } else { "" };
                format!("{word}({minus}{})", ["x", "y", "z"][axis])
            }
            _ => {
                let hinge = self.names.hinges[self.branches[0][position]].clone();
                format!("{word}({})", self.vector(&axes, &format!("{hinge}_axis")))
            }
        }
    }

    /// Returns the fields of a hinge.
    pub fn properties(&mut self, position: usize) -> Vec<String> {
        let joints = self.joints(position);
        let Some(first) = joints.first() else { return Vec::new() };
        let name = self.names.hinges[self.branches[0][position]].clone();
        let units = match first.kind {
            Kind::Fixed => return Vec::new(),
            Kind::Planar | Kind::Floating => {
                return vec!["force = input;".into(), "torque = input;".into()];
            }
            Kind::Prismatic => &SLIDER,
            Kind::Revolute | Kind::Continuous | Kind::Ball => &PIN,
        };
        let mut fields = vec![format!("{} = input;", units.effort_word)];
        if first.kind != Kind::Ball {
            fields.extend(self.passive(&joints, units, &name));
        }
        let ranges: Vec<[f64; 2]> = joints.iter().filter_map(|joint| joint.limit.range).collect();
        if ranges.len() == joints.len() {
            fields.extend(self.limits(&ranges, &joints, units, &name));
        }
        fields
    }

    /// Returns damping, friction and armature.
    fn passive(&mut self, joints: &[&Joint], units: &Units, name: &str) -> Vec<String> {
        let mut fields = Vec::new();
        let dampings = each(joints, |joint| joint.damping);
        if dampings.iter().any(|damping| *damping != 0.0) {
            let damping = self.number(&dampings, &format!("{name}_damping"));
            fields.push(format!("damping = {damping} {};", units.damping));
        }
        let frictions = each(joints, |joint| joint.friction);
        if frictions.iter().any(|friction| *friction != 0.0) {
            let friction = self.number(&frictions, &format!("{name}_friction"));
            fields.push(format!("friction = {friction} {};", units.effort));
            fields.push(format!("friction_speed = {};", units.friction_speed));
        }
        let rotors = each(joints, |joint| joint.armature);
        if rotors.iter().any(|rotor| *rotor != 0.0) {
            let armature = self.number(&rotors, &format!("{name}_armature"));
            fields.push(format!("armature = {armature} {};", units.inertia));
        }
        fields
    }

    /// Returns the largest effort and velocity of the file for a comment, since a chain limits neither.
    pub fn largest(&self, position: usize) -> Option<String> {
        let joints = self.joints(position);
        let units = match joints.first()?.kind {
            Kind::Prismatic => &SLIDER,
            Kind::Revolute | Kind::Continuous => &PIN,
            Kind::Fixed | Kind::Planar | Kind::Floating | Kind::Ball => return None,
        };
        let efforts = each(&joints, |joint| joint.limit.effort);
        let velocities = each(&joints, |joint| joint.limit.velocity);
        let limits = [
            range(&efforts).map(|efforts| format!("{efforts} {}", units.effort)),
            range(&velocities).map(|velocities| format!("{velocities} {}/s", units.coordinate)),
        ];
        let limits: Vec<String> = limits.into_iter().flatten().collect();
        (!limits.is_empty()).then(|| limits.join(", "))
    }

    fn limits(
        &mut self,
        ranges: &[[f64; 2]],
        joints: &[&Joint],
        units: &Units,
        name: &str,
    ) -> Vec<String> {
        let angles = |range: &[f64; 2]| {
            range.map(|angle| Angle::snapped(angle, self.source.snap.min(1e-12)))
        };
        let is_degrees =
            units.in_degrees && ranges.iter().flat_map(angles).all(|angle| angle.degrees.is_some());
        let unit = if is_degrees { "deg" } else { units.coordinate };
        let value = |range: &[f64; 2]| match is_degrees {
            true => angles(range).map(|angle| angle.degrees.unwrap_or_default()),
            false => *range,
        };
        let values = each(ranges, value);
        let starts = each(&values, |[low, high]| 0.0_f64.clamp(*low, *high));
        let lists = [each(&values, |range| range[0]), each(&values, |range| range[1])];
        let scale = largest(&values);
        let limits = match joints.iter().any(|joint| joint.kind == Kind::Ball) {
            // The largest angle from rest.
            true => self.expressions.number(&lists[1], scale, &format!("{name}_largest")),
            false => {
                let names = ["lowest", "highest"];
                format!("[{}]", self.expressions.list(&lists, scale, name, &names))
            }
        };
        let mut fields = vec![format!("limits = {limits} {unit};")];
        let efforts = each(joints, |joint| match joint.limit.effort {
            effort if effort > 0.0 => units.limit_distance.written(effort),
            _ => 1.0,
        });
        let stiffness = self.number(&efforts, &format!("{name}_effort"));
        fields.push(format!("limit_stiffness = {stiffness} {};", units.limit_stiffness));
        if starts.iter().any(|start| *start != 0.0) {
            let start = self.number(&starts, &format!("{name}_start"));
            fields.push(format!("start = {start} {unit};"));
        }
        fields
    }
}

/// The units of a hinge with one degree of freedom, and what URDF does not have.
struct Units {
    coordinate: &'static str,
    in_degrees: bool,
    effort_word: &'static str,
    effort: &'static str,
    damping: &'static str,
    inertia: &'static str,
    /// The speed that smooths friction.
    friction_speed: &'static str,
    /// The largest effort that the file allows acts this far beyond a limit.
    limit_stiffness: &'static str,
    limit_distance: Distance,
}

const PIN: Units = Units {
    coordinate: "rad",
    in_degrees: true,
    effort_word: "torque",
    effort: "N*m",
    damping: "N*m*s/rad",
    inertia: "kg*m^2",
    friction_speed: "0.1 rad/s",
    limit_stiffness: "N*m/deg",
    limit_distance: Distance::Degree,
};

const SLIDER: Units = Units {
    coordinate: "m",
    in_degrees: false,
    effort_word: "force",
    effort: "N",
    damping: "N*s/m",
    inertia: "kg",
    friction_speed: "0.01 m/s",
    limit_stiffness: "N/mm",
    limit_distance: Distance::Millimetre,
};

/// Returns angles in degrees if all are whole degrees, otherwise in rad, with the unit.
pub fn angles_in_a_unit(angles: &[[Angle; 3]]) -> (Vec<[f64; 3]>, &'static str) {
    if angles.iter().flatten().all(|angle| angle.degrees.is_some()) {
        return (
            each(angles, |angles| angles.map(|angle| angle.degrees.unwrap_or_default())),
            "deg",
        );
    }
    (each(angles, |angles| angles.map(|angle| angle.radians)), "rad")
}

fn each<T, U>(items: &[T], value: impl Fn(&T) -> U) -> Vec<U> {
    items.iter().map(value).collect()
}

/// Returns the values of each component.
fn components(vectors: &[[f64; 3]]) -> Vec<Vec<f64>> {
    (0..3).map(|index| each(vectors, |vector| vector[index])).collect()
}

/// Returns a number, or the lowest and the highest of several; nothing if all are zero.
fn range(values: &[f64]) -> Option<String> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(0.0, f64::max);
    match (high > 0.0, low == high) {
        (false, _) => None,
        (true, true) => Some(number(high)),
        (true, false) => Some(format!("{} to {}", number(low), number(high))),
    }
}

fn largest<T: AsRef<[f64]>>(values: impl IntoIterator<Item = T>) -> f64 {
    let sizes =
        |values: T| values.as_ref().iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    values.into_iter().map(sizes).fold(0.0, f64::max)
}
