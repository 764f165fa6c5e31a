//! What a chain can have and a URDF file cannot.

use mstmm_codegen::model::{
    Attachment, Body, Chain, Dimension, Drive, Effort, Hinge, HingeKind, Load, Passive, Role,
    Source, Spring, Value,
};

use super::values::Values;

/// Returns all reasons why a chain cannot be a URDF file, each with the name of its cause.
pub fn refusals(chain: &Chain, values: &Values) -> Vec<String> {
    if chain.dimension != Dimension::Space {
        return vec![format!("chain `{}` is not in space: URDF files are", chain.name)];
    }
    let mut reasons: Vec<String> = Vec::new();
    // The motion of a moving end is a hinge with its name, which has no other reason.
    let is_end = |hinge: &&Hinge| {
        chain.bodies.iter().any(|body| body.role == Role::MovingEnd && body.path == hinge.path)
    };
    let hinges = chain.hinges.iter().filter(|hinge| !is_end(hinge));
    reasons.extend(hinges.filter_map(|hinge| of_hinge(hinge, values)));
    reasons.extend(chain.bodies.iter().filter_map(of_body));
    let load = |Load { path, .. }: &Load| format!("load `{path}`: URDF has no loads");
    reasons.extend(chain.loads.iter().map(load));
    let spring = |Spring { path, .. }: &Spring| format!("spring `{path}`: URDF has no springs");
    reasons.extend(chain.springs.iter().map(spring));
    if chain.gravity == Source::Input {
        reasons.push("`gravity = input`: URDF has no gravity".to_owned());
    }
    reasons
}

fn of_body(body: &Body) -> Option<String> {
    (body.role == Role::MovingEnd)
        .then(|| format!("moving end `{}`: URDF has no prescribed motions", body.path))
}

fn of_hinge(hinge: &Hinge, values: &Values) -> Option<String> {
    let reason = match &hinge.kind {
        HingeKind::Universal { .. } => "URDF has no universal joints",
        HingeKind::Gimbal { .. } => "URDF has no gimbals",
        HingeKind::Ball => "URDF has no ball joints",
        HingeKind::Cylindrical { .. } => "URDF has no cylindrical joints",
        HingeKind::Screw { .. } => "URDF has no screw joints",
        HingeKind::Elastic | HingeKind::PlaneElastic => "URDF has no elastic joints",
        _ if !matches!(hinge.outboard, Attachment::Input(_)) => {
            "it closes a loop, and URDF has only trees"
        }
        _ => return of_properties(hinge, values),
    };
    Some(format!("hinge `{}`: {reason}", hinge.path))
}

fn of_properties(hinge: &Hinge, values: &Values) -> Option<String> {
    let reason = match &hinge.drive {
        Drive::Prescribed => Some("URDF has no prescribed motions"),
        Drive::Efforts(efforts) => {
            let is_constant = |effort: &Effort| matches!(effort, Effort::Constant(_));
            efforts.iter().any(is_constant).then_some("URDF has no constant efforts")
        }
    };
    let is_single = matches!(hinge.kind, HingeKind::Pin { .. } | HingeKind::Slider { .. });
    let nonzero = |value: &Value| values.of(value) != 0.0;
    let passive = |passive: &Passive| {
        if nonzero(&passive.stiffness) {
            Some("URDF has no stiffness")
        } else if nonzero(&passive.armature) {
            Some("URDF has no armature")
        } else if passive.limits.as_ref().is_some_and(|limits| nonzero(&limits.damping)) {
            Some("URDF has no damping of limits")
        } else if !is_single && (passive.has_effort()) {
            Some("URDF has damping, friction and limits only for pins and sliders")
        } else {
            None
        }
    };
    let reason = reason.or_else(|| hinge.passive.iter().find_map(passive))?;
    Some(format!("hinge `{}`: {reason}", hinge.path))
}
