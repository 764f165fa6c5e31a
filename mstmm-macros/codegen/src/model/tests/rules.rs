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

/// Quaternions count once, and known ones not at all.
#[test]
fn setters_check_the_lengths_of_axes_and_quaternions() {
    let (chain, _) = chain(
        "chain Bent {
            param tilt = 1;
            param each[2] = 1;
            body Link {
                mass = 1 kg;
                com = [0, 0, 0];
                inertia = diag(1, 1, 1) about com;
                output = [1, 0, 0] turned quaternion(1, tilt, 0, 0);
            }
            ground turned quaternion(1, 1, 0, 0) -> universal(x, [0, tilt, 1]) edge -> Link leaf
                -> gimbal(z, [tilt, 0, 1], y) swivel -> Link arm
                -> repeat 2 { pin([each, 0, 0]) fold -> Link part };
        }",
    );
    let asked: Vec<String> = chain
        .checks()
        .iter()
        .map(|Check { reason, part, .. }| {
            format!("{}: {reason}", part.map_or("once".into(), |part| part.index().to_string()))
        })
        .collect();
    assert_eq!(
        asked,
        [
            "once: must leave the length of the axis of hinge `edge` between 1e-15 and 1e15",
            "once: must not leave successive axes of hinge `edge` parallel",
            "once: must leave the length of the axis of hinge `swivel` between 1e-15 and 1e15",
            "once: must not leave successive axes of hinge `swivel` parallel",
            "once: must not leave successive axes of hinge `swivel` parallel",
            "once: must leave the length of a quaternion between 1e-15 and 1e15",
            "0: must leave the length of the axis of hinge `fold` between 1e-15 and 1e15",
        ]
    );
}

/// No angle of a quaternion exceeds half a turn.
#[test]
fn setters_check_the_limits_of_balls() {
    let (chain, _) = chain(
        "chain Wrist {
            param widest = 1 rad;
            body Link { mass = 1 kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> ball joint -> Link leaf;
            hinge joint { limits = widest; limit_stiffness = 1; }
        }",
    );
    let reasons: Vec<String> = chain.checks().into_iter().map(|check| check.reason).collect();
    let expected = [
        "must leave the width of the limits of hinge `joint` positive",
        "must not leave the limits of hinge `joint` above 180 deg",
    ];
    assert_eq!(reasons, expected);
}

/// The angles of an elastic hinge are singular at a right angle.
#[test]
fn setters_check_the_pitch_of_elastic_hinges() {
    let (chain, _) = chain(
        "chain Bush {
            param tilt = 0.1 rad;
            body Link { mass = 1 kg; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> elastic e -> Link leaf;
            hinge e {
                stiffness = 1; turning_stiffness = 1;
                rest = [0, 0, 0] m turned rpy(tilt, tilt, tilt);
                start = [0, 0, 0] m turned rpy(0, 2*tilt, 0);
            }
        }",
    );
    let reasons: Vec<String> = chain.checks().into_iter().map(|check| check.reason).collect();
    let of = |which: &str| {
        format!("must leave the pitch angle of the {which} of hinge `e` between -90 deg and 90 deg")
    };
    assert_eq!(reasons, [of("start"), of("start"), of("rest"), of("rest")]);
}
