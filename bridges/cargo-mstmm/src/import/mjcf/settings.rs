//! Reads the settings of the elements `option`, and lists what the import omits.

use nalgebra::Vector3;
use std::collections::HashMap;

use super::super::error::Result;
use super::super::robot::{Mimic, Note};
use super::super::xml::Element;
use super::attributes::BOOL;

/// Gravity, and which passive efforts act.
pub struct Settings {
    /// In m/s², zero if it is disabled.
    pub gravity: Vector3<f64>,
    pub dampers: bool,
    /// Whether dry friction acts.
    pub friction: bool,
    pub limits: bool,
}

impl Settings {
    /// Reads the elements `option` of a file, of which later ones override earlier ones.
    pub fn read(root: Element) -> Result<Self> {
        let gravity = match last(root, "gravity") {
            Some(option) => option.vector("gravity", [0.0; 3])?,
            None => Vector3::new(0.0, 0.0, -9.81),
        };
        let constraints = is_enabled(root, "constraint")?;
        Ok(Settings {
            gravity: if is_enabled(root, "gravity")? { gravity } else { Vector3::zeros() },
            // Older versions have the flag `passive` instead of `spring` and `damper`.
            dampers: is_enabled(root, "damper")? && is_enabled(root, "passive")?,
            friction: constraints && is_enabled(root, "frictionloss")?,
            limits: constraints && is_enabled(root, "limit")?,
        })
    }
}

/// Returns the last element `option` with an attribute.
fn last<'a>(root: Element<'a>, name: &str) -> Option<Element<'a>> {
    root.children("option").filter(|option| option.attribute(name).is_some()).last()
}

fn is_enabled(root: Element, name: &str) -> Result<bool> {
    let flags = root.children("option").flat_map(|option| option.children("flag"));
    let Some(flag) = flags.filter(|flag| flag.attribute(name).is_some()).last() else {
        return Ok(true);
    };
    Ok(flag.keyword(name, &["enable", "disable"])? != Some("disable"))
}

/// Returns what the model has and the text does not, except for what bodies and joints have.
pub fn notes(root: Element) -> Result<Vec<Note>> {
    let mut notes = Vec::new();
    // Wind acts by density and viscosity.
    for name in ["density", "viscosity"] {
        let Some(option) = last(root, name) else { continue };
        if option.number(name, 0.0)? != 0.0 {
            notes.push(option.note(format!("the fluid with a `{name}` is omitted")));
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
        notes.extend(first.map(|element| element.note(what)));
    }
    let flex = root.children("deformable").find_map(|element| element.child("flex"));
    notes.extend(flex.map(|flex| flex.note("flexible elements are omitted")));
    Ok(notes)
}

/// Returns the joints that active equations couple, by their names. Closed loops are errors.
pub fn couples(root: Element) -> Result<HashMap<String, Mimic>> {
    let mut couples = HashMap::new();
    if !(is_enabled(root, "constraint")? && is_enabled(root, "equality")?) {
        return Ok(couples);
    }
    let equations = root.children("equality").flat_map(Element::any_children);
    for equation in equations {
        if equation.keyword("active", &BOOL)? == Some("false") {
            continue;
        }
        match equation.tag() {
            "joint" => {
                let joint = equation.required_attribute("joint1")?.to_owned();
                let other = equation.attribute("joint2").map(str::to_owned);
                couples.insert(joint, other.map_or(Mimic::Constant, Mimic::Joint));
            }
            tag @ ("connect" | "weld" | "distance") => {
                return Err(equation.error(format!(
                    "the constraint `{tag}` closes a loop, which is not supported"
                )));
            }
            tag => {
                return Err(equation.error(format!("the constraint `{tag}` is not supported")));
            }
        }
    }
    Ok(couples)
}
