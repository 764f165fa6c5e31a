//! A MuJoCo model (MJCF) as links and joints: its kinematic tree. Shapes, contacts and actuators are omitted.
//!
//! The frame of a body is moved to the anchor of its joint, because the frame of a link is there. The world is the
//! ground.

mod attributes;
mod joint;
mod settings;
mod spelling;

use nalgebra::{Matrix3, Vector3};
use std::collections::{HashMap, HashSet};

use super::error::{ImportError, Result};
use super::frame::Frame;
use super::mass::Mass;
use super::robot::{Joint, Kind, Limit, Link, Mimic, Robot};
use super::xml::Element;
use attributes::{Attributes, BOOL, Compiler, Defaults};
use settings::Settings;

/// Elements that change what is described; MuJoCo writes a file without them.
const EXPANDED: [&str; 5] = ["include", "replicate", "attach", "composite", "flexcomp"];

/// The index of the link that is the world.
const WORLD: usize = 0;

/// Reads the element `mujoco`.
pub fn read(root: Element, snap: f64) -> Result<Robot> {
    if let Some(element) = root.descendants().find(|element| EXPANDED.contains(&element.tag())) {
        return Err(element.error(format!(
            "`{}` is not read: write the model without it by `mujoco.mj_saveLastXML` in Python",
            element.tag()
        )));
    }
    let settings = Settings::read(root)?;
    let mut notes = spelling::notes(root);
    notes.extend(settings::notes(root)?);
    let mut reader = Reader {
        compiler: Compiler::read(root, snap)?,
        defaults: Defaults::read(root)?,
        robot: Robot {
            name: root.attribute("model").unwrap_or("robot").to_owned(),
            links: Vec::new(),
            joints: Vec::new(),
            gravity: settings.gravity,
            notes,
        },
        settings,
        bodies: root
            .descendants()
            .filter(|it| it.tag() == "body")
            .filter_map(Element::name)
            .collect(),
        taken: HashSet::new(),
        joints: HashSet::new(),
        sites: HashSet::new(),
        moves: Vec::new(),
        couples: settings::couples(root)?,
    };
    reader.link("world".to_owned(), root, Mass::none())?;
    for element in root.children("worldbody") {
        reader.contents(element, WORLD, &Frame::identity(), None)?;
    }
    Ok(reader.robot)
}

struct Reader<'a> {
    compiler: Compiler,
    defaults: Defaults<'a>,
    settings: Settings,
    robot: Robot,
    /// The names of all bodies of the file.
    bodies: HashSet<&'a str>,
    /// The names of links so far.
    taken: HashSet<String>,
    /// The names of joints so far.
    joints: HashSet<&'a str>,
    /// The names of sites so far.
    sites: HashSet<&'a str>,
    /// Whether joints move each link.
    moves: Vec<bool>,
    /// The joints that equations couple.
    couples: HashMap<String, Mimic>,
}

impl<'a> Reader<'a> {
    /// Adds a link and returns its index.
    fn link(&mut self, name: String, element: Element, mass: Mass) -> Result<usize> {
        if !self.taken.insert(name.clone()) {
            return Err(element.error(format!("the body `{name}` exists twice")));
        }
        self.robot.links.push(Link { name, place: element.place(), mass, visuals: Vec::new() });
        self.moves.push(false);
        Ok(self.robot.links.len() - 1)
    }

    /// Returns a name that neither a link nor a body of the file has: the name, or with the suffix.
    fn free_name(&self, mut name: String, suffix: &str) -> String {
        while self.taken.contains(&name) || self.bodies.contains(&*name) {
            name.push_str(suffix);
        }
        name
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
                tag @ ("joint" | "freejoint" | "inertial") if link == WORLD => {
                    return Err(
                        child.error(format!("the world has no `{tag}`: write it in a body"))
                    );
                }
                tag @ ("joint" | "freejoint" | "inertial") if element.tag() == "frame" => {
                    return Err(child.error(format!(
                        "a `{tag}` in a `frame` is not read: write it in the body, without the frame"
                    )));
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
        let name = match element.name() {
            Some(name) => name.to_owned(),
            None => self.free_name(format!("body{}", self.robot.links.len()), "_link"),
        };
        let moving = self.moving(element, &name, class)?;
        let anchor = match &moving {
            Some(joint) => joint.vector("pos", [0.0; 3])?,
            None => Vector3::zeros(),
        };
        let to_anchor = |sign: f64| Frame::at(anchor * sign);
        let moves = moving.is_some() || self.moves[parent];
        self.omitted(element, moves)?;
        element.only_child("inertial")?;
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

    /// Returns the only joint of a body, if it has one.
    fn moving(
        &mut self,
        body: Element<'a>,
        name: &str,
        class: Option<&'a str>,
    ) -> Result<Option<Attributes<'a>>> {
        let is_joint = |child: &Element| matches!(child.tag(), "joint" | "freejoint");
        let joints: Vec<Element<'a>> = body.any_children().filter(is_joint).collect();
        let joint = match joints[..] {
            [] => return Ok(None),
            [joint] => joint,
            [_, second, ..] => {
                let count = joints.len();
                let message = format!(
                    "body `{}` has {count} joints, and a chain has a body after each hinge",
                    name.escape_debug()
                );
                return Err(ImportError::at(second.place(), message));
            }
        };
        if let Some(name) = joint.name().filter(|name| !self.joints.insert(name)) {
            return Err(ImportError::at(joint.place(), format!("the joint `{name}` exists twice")));
        }
        self.defaults.of(joint, "joint", class).map(Some)
    }

    /// Notes what a body has and the text does not.
    fn omitted(&mut self, body: Element, moves: bool) -> Result<()> {
        let notes = &mut self.robot.notes;
        let has_gravity = self.settings.gravity != Vector3::zeros();
        if body.number("gravcomp", 0.0)? != 0.0 && moves && has_gravity {
            notes.push(body.note("`gravcomp` is omitted; the whole weight acts here"));
        }
        if body.keyword("mocap", &BOOL)? == Some("true") {
            notes.push(body.note("`mocap` is omitted; the body is fixed to the ground here"));
        }
        notes.extend(body.child("plugin").map(|plugin| plugin.note("plugins are omitted")));
        Ok(())
    }

    /// Adds a named site as a link without mass.
    fn site(
        &mut self,
        element: Element<'a>,
        parent: usize,
        outer: &Frame,
        class: Option<&'a str>,
    ) -> Result<()> {
        let Some(name) = element.name() else { return Ok(()) };
        if !self.sites.insert(name) {
            return Err(element.error(format!("the site `{name}` exists twice")));
        }
        let site = self.defaults.of(element, "site", class)?;
        let inner = match self.compiler.line(&site)? {
            Some((middle, rotation)) => Frame::rotated(middle, &rotation, self.compiler.snap),
            None => self.frame(&site)?,
        };
        let frame = outer.compose(&inner);
        let name = self.free_name(name.to_owned(), "_site");
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
        if inertial.attribute("fullinertia").is_some() && own.orientation()?.is_some() {
            return Err(inertial.error(
                "`fullinertia` and an orientation exclude each other, as in MuJoCo: remove the orientation, or write \
                 `diaginertia` in its axes",
            ));
        }
        let frame = self.frame(&own)?;
        Ok(Mass { mass, com: Vector3::zeros(), tensor }.seen_from(&frame))
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
