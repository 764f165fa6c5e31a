//! A MuJoCo model (MJCF) as links and joints: its kinematic tree. Shapes, contacts and actuators are omitted.
//!
//! The frame of a body is moved to the anchor of its joint, because the frame of a link is there. The world is the
//! ground.

mod attributes;

use nalgebra::{Matrix3, Vector3};
use std::collections::HashMap;

use super::error::{ImportError, Result};
use super::frame::Frame;
use super::mass::Mass;
use super::robot::{Joint, Kind, Limit, Link, Note, Robot};
use super::xml::Element;
use attributes::{Attributes, Compiler, Defaults};

/// Elements that change what is described; MuJoCo writes a file without them.
const EXPANDED: [&str; 4] = ["include", "replicate", "attach", "composite"];

/// Reads the element `mujoco`.
pub fn read(root: Element, snap: f64) -> Result<Robot> {
    if let Some(element) = root.descendants().find(|element| EXPANDED.contains(&element.tag())) {
        return Err(element.error(format!(
            "`{}` is not read: write the model without it by `mujoco.mj_saveLastXML` in Python",
            element.tag()
        )));
    }
    let mut reader = Reader {
        compiler: Compiler::read(root, snap)?,
        defaults: Defaults::read(root)?,
        robot: Robot {
            name: root.attribute("model").unwrap_or("robot").to_owned(),
            links: Vec::new(),
            joints: Vec::new(),
            notes: notes(root)?,
        },
        taken: HashMap::new(),
        moves: Vec::new(),
        couples: couples(root)?,
    };
    let world = reader.link("world".to_owned(), root, Mass::none())?;
    for element in root.children("worldbody") {
        reader.contents(element, world, &Frame::identity(), None)?;
    }
    Ok(reader.robot)
}

/// Returns what the model has and the text does not.
fn notes(root: Element) -> Result<Vec<Note>> {
    let mut notes = Vec::new();
    for option in root.children("option") {
        let gravity = option.vector("gravity", [0.0, 0.0, -9.81])?;
        if gravity != Vector3::new(0.0, 0.0, -9.81) {
            let [x, y, z]: [f64; 3] = gravity.into();
            let text =
                format!("the gravity is [{x}, {y}, {z}] m/s^2 in the file; set it in the text");
            notes.push(Note { place: option.place(), text });
        }
    }
    for (section, what) in [
        ("actuator", "actuators are omitted; the efforts of all joints are inputs"),
        (
            "tendon",
            "tendons are omitted; one between two sites is a `spring`, with `force = input` if it is driven",
        ),
        ("contact", "contacts are omitted"),
    ] {
        let first = root.children(section).find(|element| element.any_children().next().is_some());
        notes.extend(first.map(|element| Note { place: element.place(), text: what.to_owned() }));
    }
    Ok(notes)
}

/// Returns the joints that equations couple to others: name of the joint, name of the other. Closed loops are errors.
fn couples(root: Element) -> Result<HashMap<String, String>> {
    let mut couples = HashMap::new();
    for equation in root.children("equality").flat_map(Element::any_children) {
        match equation.tag() {
            "joint" => {
                let joint = equation.required_attribute("joint1")?.to_owned();
                let other = equation.attribute("joint2").unwrap_or_default();
                couples.insert(joint, other.to_owned());
            }
            tag => {
                return Err(equation.error(format!(
                    "the constraint `{tag}` closes a loop, which is not supported"
                )));
            }
        }
    }
    Ok(couples)
}

struct Reader<'a> {
    compiler: Compiler,
    defaults: Defaults<'a>,
    robot: Robot,
    /// The names of links.
    taken: HashMap<String, ()>,
    /// Whether joints move each link.
    moves: Vec<bool>,
    couples: HashMap<String, String>,
}

impl<'a> Reader<'a> {
    /// Adds a link and returns its index.
    fn link(&mut self, name: String, element: Element, mass: Mass) -> Result<usize> {
        if self.taken.insert(name.clone(), ()).is_some() {
            return Err(element.error(format!("the body `{name}` exists twice")));
        }
        self.robot.links.push(Link { name, place: element.place(), mass, visuals: Vec::new() });
        self.moves.push(false);
        Ok(self.robot.links.len() - 1)
    }

    /// Reads the bodies, sites and frames in an element; `outer` is its frame in the frame of the link.
    fn contents(
        &mut self,
        element: Element<'a>,
        link: usize,
        outer: &Frame,
        class: Option<&'a str>,
    ) -> Result<()> {
        for child in element.any_children() {
            match child.tag() {
                "body" => self.body(child, link, outer, class)?,
                "site" => self.site(child, link, outer, class)?,
                "frame" => {
                    let class = child.attribute("childclass").or(class);
                    let inner = self.frame(&Attributes::only(child))?;
                    self.contents(child, link, &outer.compose(&inner), class)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn body(
        &mut self,
        element: Element<'a>,
        parent: usize,
        outer: &Frame,
        class: Option<&'a str>,
    ) -> Result<()> {
        let class = element.attribute("childclass").or(class);
        let own = Attributes::only(element);
        let frame = outer.compose(&self.frame(&own)?);
        let name = match element.attribute("name") {
            Some(name) => name.to_owned(),
            None => format!("body{}", self.robot.links.len()),
        };
        let joints: Vec<Element<'a>> = element
            .any_children()
            .filter(|child| matches!(child.tag(), "joint" | "freejoint"))
            .collect();
        let moving = match joints.as_slice() {
            [] => None,
            [joint] => Some(self.defaults.of(*joint, "joint", class)?),
            [_, second, ..] => {
                let count = joints.len();
                return Err(second.error(format!(
                    "the body `{name}` has {count} joints, and a chain has a body after each hinge"
                )));
            }
        };
        let anchor = match &moving {
            Some(joint) => joint.vector("pos", [0.0; 3])?,
            None => Vector3::zeros(),
        };
        let to_anchor = |sign: f64| Frame::at(anchor * sign);
        let moves = moving.is_some() || self.moves[parent];
        // The mass of the ground does not matter.
        let mass = if moves { self.mass(element)? } else { Mass::none() };
        let link = self.link(name.clone(), element, mass.seen_from(&to_anchor(-1.0)))?;
        self.moves[link] = moves;
        let origin = frame.compose(&to_anchor(1.0));
        let joint = match moving {
            Some(joint) => self.joint(&joint, &name, [parent, link], origin)?,
            None => fixed(&name, element, [parent, link], origin),
        };
        self.robot.joints.push(joint);
        self.contents(element, link, &to_anchor(-1.0), class)
    }

    /// Adds a named site as a link without mass.
    fn site(
        &mut self,
        element: Element<'a>,
        parent: usize,
        outer: &Frame,
        class: Option<&'a str>,
    ) -> Result<()> {
        let Some(name) = element.attribute("name") else { return Ok(()) };
        let frame = outer.compose(&self.frame(&self.defaults.of(element, "site", class)?)?);
        let is_taken = self.taken.contains_key(name);
        let name = if is_taken { format!("{name}_site") } else { name.to_owned() };
        let link = self.link(name.clone(), element, Mass::none())?;
        self.robot.joints.push(fixed(&name, element, [parent, link], frame));
        Ok(())
    }

    /// Returns the frame that `pos` and an orientation describe.
    fn frame(&self, element: &Attributes) -> Result<Frame> {
        Ok(Frame::rotated(
            element.vector("pos", [0.0; 3])?,
            &self.compiler.orientation(element)?,
            self.compiler.snap,
        ))
    }

    /// Returns the mass that the element `inertial` describes.
    fn mass(&self, body: Element) -> Result<Mass> {
        let Some(inertial) = body.child("inertial") else {
            return match body.child("geom") {
                Some(geom) => Err(geom.error(
                    "no `inertial`: masses of geoms are not read; write those of the compiled model, `body_mass`, \
                     `body_ipos`, `body_iquat` and `body_inertia`",
                )),
                None => Ok(Mass::none()),
            };
        };
        let own = Attributes::only(inertial);
        let mass = inertial.required_number("mass")?;
        if mass < 0.0 {
            return Err(inertial.error(format!("the mass {mass} kg is negative")));
        }
        let tensor = match (own.numbers::<3>("diaginertia")?, own.numbers::<6>("fullinertia")?) {
            (Some(diagonal), None) => Matrix3::from_diagonal(&diagonal.into()),
            (None, Some([xx, yy, zz, xy, xz, yz])) => {
                Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
            }
            _ => return Err(inertial.error("expected `diaginertia` or `fullinertia`")),
        };
        Ok(Mass { mass, com: Vector3::zeros(), tensor }.seen_from(&self.frame(&own)?))
    }

    fn joint(
        &self,
        joint: &Attributes,
        body: &str,
        [parent, child]: [usize; 2],
        origin: Frame,
    ) -> Result<Joint> {
        let element = joint.element();
        let tag = element.tag();
        let kind = match (tag, joint.text("type").unwrap_or("hinge")) {
            ("freejoint", _) | (_, "free") => Kind::Floating,
            (_, "hinge") => Kind::Continuous,
            (_, "slide") => Kind::Prismatic,
            (_, "ball") => Kind::Ball,
            (_, other) => return Err(element.error(format!("`{other}` is not a type of joint"))),
        };
        for refused in ["ref", "stiffness", "springdamper"] {
            if joint.numbers_of(refused)?.iter().any(|number| *number != 0.0) {
                return Err(element.error(format!("`{refused}` of a joint is not read")));
            }
        }
        let number = |name: &str| match joint.numbers_of(name)?.first() {
            Some(value) if *value < 0.0 => {
                Err(element.error(format!("the {name} {value} is negative")))
            }
            value => Ok(value.copied().unwrap_or(0.0)),
        };
        let axis = joint.vector("axis", [0.0, 0.0, 1.0])?;
        if axis == Vector3::zeros() {
            return Err(element.error("the axis is zero"));
        }
        let limit = self.limit(joint, kind)?;
        let kind = match (kind, limit.range) {
            (Kind::Continuous, Some(_)) => Kind::Revolute,
            (kind, _) => kind,
        };
        let name = joint.text("name").map_or_else(|| format!("{body}_joint"), str::to_owned);
        // A free joint has no passive efforts, whatever its class has.
        let of_joint = |name: &str| if kind == Kind::Floating { Ok(0.0) } else { number(name) };
        Ok(Joint {
            mimic: self.couples.get(&name).cloned(),
            name,
            place: element.place(),
            kind,
            parent,
            child,
            origin,
            axis,
            limit,
            damping: of_joint("damping")?,
            friction: of_joint("frictionloss")?,
            armature: of_joint("armature")?,
        })
    }

    /// Returns the range of a hinge or a slide, if it is limited.
    fn limit(&self, joint: &Attributes, kind: Kind) -> Result<Limit> {
        let efforts = joint.numbers::<2>("actuatorfrcrange")?.unwrap_or_default();
        let effort = efforts.iter().fold(0.0, |largest: f64, effort| largest.max(effort.abs()));
        let range = joint.numbers::<2>("range")?;
        let is_limited = match joint.text("limited").unwrap_or("auto") {
            "true" => true,
            "false" => false,
            _ => self.compiler.limits_alone && range.is_some(),
        };
        let range = range.filter(|[low, high]| is_limited && low < high);
        let range = match kind {
            Kind::Continuous => range.map(|range| range.map(|angle| self.compiler.angle(angle))),
            Kind::Prismatic => range,
            // The swing of a ball has no limit in a chain.
            _ => None,
        };
        Ok(Limit { range, effort, velocity: 0.0 })
    }
}

/// Returns a joint that does not move.
fn fixed(name: &str, element: Element, [parent, child]: [usize; 2], origin: Frame) -> Joint {
    Joint {
        name: format!("{name}_fixed"),
        place: element.place(),
        kind: Kind::Fixed,
        parent,
        child,
        origin,
        axis: Vector3::x(),
        limit: Limit::default(),
        damping: 0.0,
        friction: 0.0,
        armature: 0.0,
        mimic: None,
    }
}

/// Makes the error about a file of the simulator Gazebo.
pub fn refuse_sdf(root: Element) -> ImportError {
    root.error(
        "SDF files are not read: convert the file by `sdf2mjcf` of the Python package `sdformat-mjcf`, which needs Gazebo, and \
         import the MJCF file",
    )
}
