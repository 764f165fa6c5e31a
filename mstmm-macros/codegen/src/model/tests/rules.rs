//! The conditions that setters check for values that depend on parameters.

use super::chain;
use crate::model::{Bound, Check};

#[test]
fn setters_check_the_rules_of_the_compiler() {
    let (chain, _) = chain(
        "plane chain Door {
            gravity = [0, -9.8] m/s^2;
            param m = 1 kg;
            param width = 1;
            body Leaf { mass = m; com = [0, 0]; inertia = width about com; output = [1, 0]; }
            ground -> pin edge -> Leaf leaf -> repeat 2 { pin fold -> Leaf part };
            hinge edge {
                stiffness = width;
                damping = 1;
                armature = width;
                friction = width;
                friction_speed = width;
                limits = [0, width];
                limit_stiffness = width;
                limit_damping = width;
            }
            spring closer { on = leaf; to = [0, 0]; stiffness = width; damping = width; length = width; }
        }",
    );
    let checks = chain.checks();
    let asked: Vec<String> = checks
        .iter()
        .map(|Check { reason, part, must, .. }| {
            assert_eq!(*must == Bound::BePositive, !reason.ends_with("not negative"), "{reason}");
            format!("{}: {reason}", part.map_or("once".into(), |part| part.index().to_string()))
        })
        .collect();
    assert_eq!(
        asked,
        [
            "once: must leave the mass of body `leaf` positive",
            "once: must leave the moments of inertia of body `leaf` not negative",
            "once: must leave the stiffness of hinge `edge` not negative",
            "once: must leave the armature of hinge `edge` not negative",
            "once: must leave the friction of hinge `edge` not negative",
            "once: must leave the friction speed of hinge `edge` positive",
            "once: must leave the limit stiffness of hinge `edge` positive",
            "once: must leave the limit damping of hinge `edge` not negative",
            "once: must leave the width of the limits of hinge `edge` positive",
            "once: must leave the stiffness of spring `closer` not negative",
            "once: must leave the damping of spring `closer` not negative",
            "once: must leave the length of spring `closer` not negative",
            "0: must leave the mass of body `part` positive",
            "0: must leave the moments of inertia of body `part` not negative",
        ]
    );
}
