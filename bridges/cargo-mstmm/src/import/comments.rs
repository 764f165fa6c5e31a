//! The comments before a chain: what the text has otherwise than the file.

use super::error::on_one_line;
use super::naming::Naming;
use super::numbers::wrapped;
use super::parts::Group;
use super::robot::Kind;
use super::scope::Source;
use super::text::{Heading, size};

/// Returns the lines.
pub fn comments(
    source: Source,
    groups: &[Group],
    naming: &Naming,
    heading: &Heading,
) -> Vec<String> {
    let robot = source.robot;
    let mut lines = wrapped(
        &format!(
            "// Imported from {}, the robot `{}`: {}.",
            heading.file,
            on_one_line(&robot.name),
            size(source)
        ),
        "//     ",
        ", ",
    );
    let mut list = |title: &str, names: Vec<String>| {
        if !names.is_empty() {
            let text = names.join(", ");
            let end = if text.ends_with('?') { "" } else { "." };
            lines.extend(wrapped(&format!("// {title}: {text}{end}"), "//     ", ", "));
        }
    };
    let link = |index: &usize| on_one_line(&robot.links[*index].name);
    list("The ground", source.tree.ground.iter().map(link).collect());
    for (index, body) in source.tree.bodies.iter().enumerate() {
        let title =
            format!("Merged into {}", naming.path(groups, index, &naming.table.bodies[index]));
        list(&title, body.fixed.iter().map(|(index, _)| link(index)).collect());
    }
    list("Names that differ from those of the file", differing_names(source, groups, naming));
    list(
        "Held at zero",
        source.tree.held.iter().map(|joint| on_one_line(&robot.joints[*joint].name)).collect(),
    );
    for warning in heading.warnings {
        list("Note", vec![warning.clone()]);
    }
    let joints = || (0..source.tree.bodies.len()).filter_map(|body| source.joint(body));
    let moves = |kind: Kind| matches!(kind, Kind::Revolute | Kind::Prismatic | Kind::Continuous);
    if joints().any(|joint| joint.limit.range.is_some()) {
        let rule = "the largest effort of the file acts 1 deg or 1 mm beyond a limit";
        list("Not in the file", vec![format!("`limit_stiffness`; {rule}")]);
    }
    if joints().any(|joint| moves(joint.kind) && joint.friction > 0.0) {
        list("Not in the file", vec!["`friction_speed`".to_owned()]);
    }
    lines
}

/// Returns the names that are not those of the file, as `lf.hip is the joint LF_HIP`.
fn differing_names(source: Source, groups: &[Group], naming: &Naming) -> Vec<String> {
    let robot = source.robot;
    let mut names = Vec::new();
    let compare = |path: &str, what: &str, original: &str| {
        let differs = path.replace('.', "_") != original;
        differs.then(|| format!("{path} is the {what} {}", on_one_line(original)))
    };
    for (index, body) in source.tree.bodies.iter().enumerate() {
        let path = |name: &str| naming.path(groups, index, name);
        if let Some(joint) = source.joint(index) {
            names.extend(compare(&path(&naming.table.hinges[index]), "joint", &joint.name));
        }
        let own = path(&naming.table.bodies[index]);
        names.extend(compare(&own, "link", source.link_name(index)));
        for ((link, frame), point) in body.fixed.iter().zip(&naming.table.fixed[index]) {
            let original = &robot.links[*link].name;
            let is_same = path(point).replace('.', "_") == *original || point == original;
            if !frame.is_identity() && !is_same {
                names.push(format!("{own}.{point} is the link {}", on_one_line(original)));
            }
        }
    }
    names
}
