//! Finds misspelled attributes, which MuJoCo refuses.

use mstmm_codegen::diag::nearest;

use super::super::robot::Note;
use super::super::xml::Element;

const ORIENTATION: &str = "quat axisangle euler xyaxes zaxis";

/// The elements that are read, with the attributes that MuJoCo knows. [`ORIENTATION`] is additional.
const KNOWN: &[(&str, &str)] = &[
    (
        "compiler",
        "autolimits boundmass boundinertia settotalmass balanceinertia strippath coordinate angle fitaabb eulerseq \
         meshdir texturedir assetdir discardvisual usethread fusestatic inertiafromgeom inertiagrouprange saveinertial \
         alignfree conflict",
    ),
    ("option", "gravity density viscosity wind magnetic timestep integrator solver cone jacobian"),
    (
        "flag",
        "gravity constraint damper spring passive frictionloss limit equality contact actuation",
    ),
    ("body", "name childclass pos mocap gravcomp sleep user"),
    ("frame", "name childclass pos"),
    (
        "joint",
        "name class type group pos axis springdamper limited actuatorfrclimited actuatorfrcrange actuatorgravcomp \
         solreflimit solimplimit solreffriction solimpfriction stiffness range margin ref springref springyield armature \
         damping frictionloss user",
    ),
    ("freejoint", "name group align"),
    ("inertial", "pos mass diaginertia fullinertia"),
    ("site", "name class type group pos size fromto material mesh rgba user"),
];

/// Returns a warning for each attribute that MuJoCo does not know and that is close to one that it knows. Others may
/// be those of a later version.
pub fn notes(root: Element) -> Vec<Note> {
    const READ: [&str; 4] = ["compiler", "option", "default", "worldbody"];
    let sections = root.any_children().filter(|section| READ.contains(&section.tag()));
    let elements = sections.flat_map(Element::descendants);
    elements
        .flat_map(|element| element.names().filter_map(move |name| note(element, name)))
        .collect()
}

fn note(element: Element, name: &str) -> Option<Note> {
    let (tag, known) = KNOWN.iter().find(|(tag, _)| *tag == element.tag())?;
    let mut known = known.split_whitespace().chain(ORIENTATION.split_whitespace());
    if known.clone().any(|known| known == name) {
        return None;
    }
    let meant = nearest(name, &mut known)?;
    Some(element.note(format!("`{tag}` has no attribute `{name}`; did you mean `{meant}`?")))
}
