//! A robot file as links and joints, with all values checked. Collisions are ignored.

use nalgebra::{Matrix3, Vector3};
use roxmltree::{Document, ParsingOptions};
use std::collections::HashMap;

use super::error::{ImportError, Place, Result, on_one_line};
use super::frame::{Angle, Frame};
use super::mass::Mass;
use super::mjcf;
use super::places::Places;
use super::spelling;
use super::urdf_words;
use super::visual::{Visual, visuals};
use super::xacro;
use super::xml::Element;

/// The content of a file.
pub struct Robot {
    pub name: String,
    pub links: Vec<Link>,
    pub joints: Vec<Joint>,
    /// In m/s².
    pub gravity: Vector3<f64>,
    /// What the file has and the links and joints do not.
    pub notes: Vec<Note>,
}

/// A warning about an element.
pub struct Note {
    pub place: Place,
    /// The warning, on one line.
    pub text: String,
}

impl Note {
    pub fn new(place: Place, text: impl std::fmt::Display) -> Self {
        Note { place, text: on_one_line(text) }
    }
}

/// A link.
pub struct Link {
    pub name: String,
    pub place: Place,
    /// Its mass in its frame.
    pub mass: Mass,
    pub visuals: Vec<Visual>,
}

/// A joint.
pub struct Joint {
    pub name: String,
    pub place: Place,
    pub kind: Kind,
    /// The index of the inboard link.
    pub parent: usize,
    /// The index of the outboard link.
    pub child: usize,
    /// Its inboard frame in the frame of the inboard link.
    pub origin: Frame,
    pub axis: Vector3<f64>,
    pub limit: Limit,
    /// In N s/m or N m s/rad.
    pub damping: f64,
    /// In N or N m.
    pub friction: f64,
    /// The inertia of its rotor in kg or kg m²; URDF has none.
    pub armature: f64,
    /// How the file couples it.
    pub mimic: Option<Mimic>,
}

/// What determines the coordinate of a joint in the file.
#[derive(Clone)]
pub enum Mimic {
    /// The coordinate of the joint with this name.
    Joint(String),
    /// Only in MuJoCo models.
    Constant,
}

/// The type of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    Fixed,
    Revolute,
    Continuous,
    Prismatic,
    Planar,
    Floating,
    /// Only in MuJoCo models.
    Ball,
}

/// Limits of this size are none. URDF requires numbers where a joint is not limited, and readers do not accept infinity.
pub const UNLIMITED: f64 = 1e9;

/// The limits of a joint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limit {
    /// The lowest and the highest coordinate, if the file has a range.
    pub range: Option<[f64; 2]>,
    /// The largest effort; zero if the file has none.
    pub effort: f64,
    /// The largest velocity; zero if the file has none.
    pub velocity: f64,
}

impl Robot {
    /// Parses a file; angles within `snap` of whole degrees are these degrees.
    pub fn parse(text: &str, snap: f64) -> Result<Robot> {
        // Other XML readers accept a document type, so files have one.
        let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
        let places = Places::of(text);
        let document = Document::parse_with_options(text, options).map_err(|error| {
            let position = match error {
                // This error has no place.
                roxmltree::Error::UnexpectedEndOfStream => places.end(),
                _ => Place { line: error.pos().row, column: error.pos().col },
            };
            match error {
                roxmltree::Error::UnknownNamespace(prefix, _) if prefix == "xacro" => {
                    ImportError::at(position, xacro::MESSAGE)
                }
                error => ImportError::at(position, format!("XML: {error}")),
            }
        })?;
        let root = Element::new(document.root_element(), &places);
        xacro::refuse(root)?;
        match root.tag() {
            "mujoco" => return mjcf::read(root, snap),
            "sdf" => return Err(mjcf::refuse_sdf(root)),
            _ => {}
        }
        if root.tag() != "robot" {
            return Err(root.error(format!("expected the element `robot`, found `{}`", root.tag())));
        }
        let links =
            root.children("link").map(|element| link(element, snap)).collect::<Result<Vec<_>>>()?;
        let mut indices = HashMap::new();
        for (index, link) in links.iter().enumerate() {
            if indices.insert(link.name.clone(), index).is_some() {
                return Err(ImportError::at(
                    link.place,
                    format!("link `{}` exists twice", link.name),
                ));
            }
        }
        let mut notes = spelling::notes(root, urdf_words::KNOWN);
        let joints =
            root.children("joint").map(|element| joint(element, &indices, snap, &mut notes));
        let joints = joints.collect::<Result<Vec<_>>>()?;
        let mut names = HashMap::new();
        for joint in &joints {
            if names.insert(&joint.name, ()).is_some() {
                let message = format!("joint `{}` exists twice", joint.name);
                return Err(ImportError::at(joint.place, message));
            }
        }
        let name = root.attribute("name").unwrap_or("robot").to_owned();
        let gravity = Vector3::new(0.0, 0.0, -9.81);
        Ok(Robot { name, links, joints, gravity, notes })
    }
}

fn link(element: Element, snap: f64) -> Result<Link> {
    let name = element.required_name()?.to_owned();
    let mass =
        element.only_child("inertial")?.map_or_else(|| Ok(Mass::none()), |e| mass(e, snap))?;
    Ok(Link { name, place: element.place(), mass, visuals: visuals(element)? })
}

/// Reads the element `inertial`.
fn mass(element: Element, snap: f64) -> Result<Mass> {
    let mass = element.required_only_child("mass")?;
    let value = mass.required_number("value")?;
    if value < 0.0 {
        return Err(mass.error(format!("the mass {value} kg is negative")));
    }
    let inertia = element.required_only_child("inertia")?;
    let entry = |name: &str| inertia.required_number(name);
    let (xx, yy, zz) = (entry("ixx")?, entry("iyy")?, entry("izz")?);
    let (xy, xz, yz) = (entry("ixy")?, entry("ixz")?, entry("iyz")?);
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let frame =
        element.child("origin").map_or_else(|| Ok(Frame::identity()), |e| origin(e, snap))?;
    Ok(Mass { mass: value, com: Vector3::zeros(), tensor }.seen_from(&frame))
}

fn joint(
    element: Element,
    links: &HashMap<String, usize>,
    snap: f64,
    notes: &mut Vec<Note>,
) -> Result<Joint> {
    let name = element.required_name()?.to_owned();
    let kind = kind(element)?;
    let linked = |tag: &str| {
        let end = element.required_child(tag)?;
        let link = end.required_attribute("link")?;
        let missing = || end.error(format!("the link `{link}` does not exist"));
        links.get(link).copied().ok_or_else(missing)
    };
    let (parent, child) = (linked("parent")?, linked("child")?);
    let origin =
        element.child("origin").map_or_else(|| Ok(Frame::identity()), |e| origin(e, snap))?;
    let axis = axis(element, kind)?;
    let [damping, friction] =
        ["damping", "friction"].map(|which| match element.child("dynamics") {
            None => Ok(0.0),
            Some(dynamics) => match dynamics.number(which, 0.0)? {
                value if value < 0.0 => {
                    Err(dynamics.error(format!("the {which} {value} is negative")))
                }
                value => Ok(value),
            },
        });
    let mimic = element.child("mimic").map(|mimic| mimic.required_attribute("joint"));
    let limit = element.child("limit").map(|element| limit(element, kind, notes));
    Ok(Joint {
        name,
        place: element.place(),
        kind,
        parent,
        child,
        origin,
        axis,
        limit: limit.transpose()?.unwrap_or_default(),
        damping: damping?,
        friction: friction?,
        armature: 0.0,
        mimic: mimic.transpose()?.map(|joint| Mimic::Joint(joint.to_owned())),
    })
}

fn kind(element: Element) -> Result<Kind> {
    Ok(match element.required_attribute("type")? {
        "fixed" => Kind::Fixed,
        "revolute" => Kind::Revolute,
        "continuous" => Kind::Continuous,
        "prismatic" => Kind::Prismatic,
        "planar" => Kind::Planar,
        "floating" => Kind::Floating,
        other => return Err(element.error(format!("`{other}` is not a type of joint"))),
    })
}

fn origin(element: Element, snap: f64) -> Result<Frame> {
    let angles: [f64; 3] = element.vector("rpy", [0.0; 3])?.into();
    let angles = angles.map(|angle| Angle::snapped(angle, snap));
    Ok(Frame::new(element.vector("xyz", [0.0; 3])?, angles))
}

/// Returns the axis in the joint's frame, x without the element.
fn axis(element: Element, kind: Kind) -> Result<Vector3<f64>> {
    let x = Vector3::x();
    let Some(axis) = element.child("axis") else { return Ok(x) };
    if matches!(kind, Kind::Fixed | Kind::Floating) {
        return Ok(x);
    }
    axis.required_attribute("xyz")?;
    let vector = axis.vector("xyz", x.into())?;
    let principal = vector.iter().filter(|component| **component != 0.0).count();
    match principal {
        0 => Err(axis.error("the axis is zero")),
        2 | 3 if kind == Kind::Planar => Err(axis.error(
            "the normal of a planar joint must be x, y or z of its frame: rotate the frame by `rpy`",
        )),
        _ => Ok(vector),
    }
}

fn limit(element: Element, kind: Kind, notes: &mut Vec<Note>) -> Result<Limit> {
    let mut largest = |name| {
        let value = element.any_number(name, 0.0)?;
        let size = value.abs();
        if value < 0.0 && kind != Kind::Fixed {
            notes.push(element.note(format!("the {name} {value} is negative; it is {size} here")));
        }
        Ok(if size < UNLIMITED { size } else { 0.0 })
    };
    let [effort, velocity] = [largest("effort")?, largest("velocity")?];
    if !matches!(kind, Kind::Revolute | Kind::Prismatic) {
        return Ok(Limit { range: None, effort, velocity });
    }
    let [low, high] = [element.any_number("lower", 0.0)?, element.any_number("upper", 0.0)?];
    if low > high {
        let text = format!("`lower` {low} is above `upper` {high}; there are no limits here");
        notes.push(element.note(text));
    }
    // Files write equal limits for none.
    let is_limited = low < high && -low < UNLIMITED && high < UNLIMITED;
    Ok(Limit { range: is_limited.then_some([low, high]), effort, velocity })
}
