//! Hinges without errors: all kinds and all properties.

use super::{all_known, chain, constants, edited, known};
use crate::ids::HingeId;
use crate::model::{Drive, Effort, Friction, Hinge, HingeKind, Passive, Value};

/// The last hinge of the example, of another kind and with other properties.
fn hinge(kind: &str, properties: &str) -> Hinge {
    let (chain, _) = chain(&edited(&[
        ("ball wrist", &format!("{kind} wrist")),
        ("start_rate = [0, 0.1, 0] rad/s;", properties),
    ]));
    chain.hinges[HingeId(1)].clone()
}

fn numbers(passive: &[Passive], of: impl Fn(&Passive) -> &Value) -> Vec<f64> {
    passive.iter().map(|passive| of(passive).known().expect("a known number")).collect()
}

fn stiffness(hinge: &Hinge) -> Vec<f64> {
    numbers(&hinge.passive, |passive| &passive.stiffness)
}

#[test]
fn a_weld_has_no_degrees_of_freedom() {
    let weld = hinge("weld", "");
    assert_eq!(weld.kind, HingeKind::Weld);
    assert_eq!(weld.drive, Drive::Efforts(Vec::new()));
    assert!(weld.start.is_empty() && weld.rest.is_empty() && weld.passive.is_empty());
}

#[test]
fn a_slider_has_an_axis() {
    let slider = hinge("slider", "start = 3 mm; start_velocity = 2 mm/s; force = 5 N;");
    assert_eq!(slider.kind, HingeKind::Slider { axis: [0.0, 0.0, 1.0].map(Value::number) });
    assert_eq!(all_known(&slider.start), [0.003]);
    assert_eq!(all_known(&slider.start_rate), [0.002]);
    assert_eq!(constants(&slider.drive), [5.0]);
    let HingeKind::Slider { axis } = hinge("slider(-y)", "").kind else { panic!("a slider") };
    assert_eq!(known(&axis), [0.0, -1.0, 0.0]);
}

#[test]
fn a_screw_has_a_pitch_in_metres_a_radian() {
    let screw = |arguments: &str| match hinge(&format!("screw({arguments})"), "").kind {
        HingeKind::Screw { axis, pitch } => (known(&axis), pitch.known().expect("a number")),
        other => panic!("{other:?}"),
    };
    assert_eq!(screw("x, 5 mm/rad"), ([1.0, 0.0, 0.0], 0.005));
    assert_eq!(screw("0.005"), ([0.0, 0.0, 1.0], 0.005));
    let (axis, pitch) = screw("[0, 3, 4], 5 mm/rev");
    assert_eq!(axis, [0.0, 3.0, 4.0]);
    assert!((pitch - 0.005 / (2.0 * std::f64::consts::PI)).abs() < 1e-18);
}

#[test]
fn a_cylindrical_hinge_slides_and_turns() {
    let hinge = hinge(
        "cylindrical(y)",
        "start = 10 mm turned 0.25 rev; start_velocity = 1; start_rate = 2 rad/s;
         rest = -10 mm; stiffness = 3 N/m; turning_stiffness = 4 N*m/rad; damping = 5 N*s/m;
         turning_armature = 6 kg*m^2; force = input; torque = 7 N*m;",
    );
    assert_eq!(hinge.kind, HingeKind::Cylindrical { axis: [0.0, 1.0, 0.0].map(Value::number) });
    assert_eq!(all_known(&hinge.start), [0.01, std::f64::consts::FRAC_PI_2]);
    assert_eq!(all_known(&hinge.rest), [-0.01, 0.0]);
    assert_eq!(all_known(&hinge.start_rate), [1.0, 2.0]);
    assert_eq!(stiffness(&hinge), [3.0, 4.0]);
    assert_eq!(numbers(&hinge.passive, |passive| &passive.damping), [5.0, 0.0]);
    assert_eq!(numbers(&hinge.passive, |passive| &passive.armature), [0.0, 6.0]);
    let torque = Effort::Constant(Value::number(7.0));
    assert_eq!(hinge.drive, Drive::Efforts(vec![Effort::Input, torque]));
}

#[test]
fn a_universal_hinge_has_two_axes() {
    let plain = hinge("universal", "").kind;
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|axis| axis.map(Value::number));
    assert_eq!(plain, HingeKind::Universal { axes });
    let hinge = hinge(
        "universal(z, [1, 0, 1])",
        "start = [0.1, 0.2] rad; start_rate = [1, 2] rad/s; rest = [30, 60] deg; stiffness = 2;
         damping = [1, 2]; limits = [-1, 2] rad; limit_stiffness = 100 N*m/rad; torque = input;",
    );
    let axes = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]].map(|axis| axis.map(Value::number));
    assert_eq!(hinge.kind, HingeKind::Universal { axes });
    assert_eq!(all_known(&hinge.start), [0.1, 0.2]);
    assert_eq!(all_known(&hinge.start_rate), [1.0, 2.0]);
    assert_eq!(stiffness(&hinge), [2.0, 2.0]);
    assert_eq!(numbers(&hinge.passive, |passive| &passive.damping), [1.0, 2.0]);
    let limits = hinge.passive.iter().map(|passive| passive.limits.clone().expect("limits"));
    for limits in limits {
        let parts = [limits.low, limits.high, limits.stiffness, limits.damping];
        assert_eq!(known(&parts), [-1.0, 2.0, 100.0, 0.0]);
    }
    assert_eq!(hinge.drive, Drive::Efforts(vec![Effort::Input; 2]));
}

#[test]
fn a_gimbal_has_three_axes() {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let axes = axes.map(|axis| axis.map(Value::number));
    assert_eq!(hinge("gimbal", "").kind, HingeKind::Gimbal { axes });
    // The first and the last axis may be the same.
    let hinge = hinge(
        "gimbal(z, [1, 0, 1], z)",
        "start = [0.1, 0.2, 0.3] rad; start_rate = [1, 2, 3] rad/s; rest = [30, 60, 90] deg;
         stiffness = 2; damping = [1, 2, 3]; armature = 4; torque = input;",
    );
    let axes = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]];
    assert_eq!(hinge.kind, HingeKind::Gimbal { axes: axes.map(|axis| axis.map(Value::number)) });
    assert_eq!(all_known(&hinge.start), [0.1, 0.2, 0.3]);
    assert_eq!(all_known(&hinge.start_rate), [1.0, 2.0, 3.0]);
    assert_eq!(stiffness(&hinge), [2.0; 3]);
    assert_eq!(numbers(&hinge.passive, |passive| &passive.damping), [1.0, 2.0, 3.0]);
    assert_eq!(numbers(&hinge.passive, |passive| &passive.armature), [4.0; 3]);
    assert_eq!(hinge.drive, Drive::Efforts(vec![Effort::Input; 3]));
}

#[test]
fn a_ball_shares_its_numbers() {
    let ball = hinge(
        "ball",
        "rest = rpy(0, 0, 180 deg); stiffness = 1; damping = 2; armature = 3; friction = 4 N*m;
         friction_speed = 0.01 rad/s; limits = 30 deg; limit_stiffness = 5; limit_damping = 6;",
    );
    assert_eq!(all_known(&ball.rest), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(ball.passive[0], ball.passive[1]);
    assert_eq!(ball.passive[0], ball.passive[2]);
    let Passive { stiffness, damping, armature, friction, limits } = ball.passive[0].clone();
    assert_eq!(known(&[stiffness, damping, armature]), [1.0, 2.0, 3.0]);
    let Friction { effort, speed } = friction.expect("friction");
    assert_eq!(known(&[effort, speed]), [4.0, 0.01]);
    let limits = limits.expect("limits");
    let angle = 30f64.to_radians();
    assert_eq!(known(&[limits.low, limits.high]), [-angle, angle]);
    assert_eq!(known(&[limits.stiffness, limits.damping]), [5.0, 6.0]);
}

#[test]
fn a_planar_hinge_has_a_normal() {
    let planar = hinge(
        "planar(x)",
        "start = [1, 2] m turned 90 deg; start_velocity = [3, 4] m/s; start_rate = 5 rad/s;
         stiffness = [6, 7] N/m; turning_friction = 8; turning_friction_speed = 9;
         force = [1, 2] N; torque = 3 N*m;",
    );
    assert_eq!(planar.kind, HingeKind::Planar { normal: 0 });
    assert_eq!(all_known(&planar.start), [1.0, 2.0, std::f64::consts::FRAC_PI_2]);
    assert_eq!(all_known(&planar.start_rate), [3.0, 4.0, 5.0]);
    assert_eq!(stiffness(&planar), [6.0, 7.0, 0.0]);
    assert!(planar.passive[0].friction.is_none() && planar.passive[2].friction.is_some());
    assert_eq!(constants(&planar.drive), [1.0, 2.0, 3.0]);
}

#[test]
fn a_floating_hinge_can_be_on_the_route() {
    let floating = hinge(
        "floating",
        "start = [1, 2, 3] m turned quaternion(0, 0, 3, 4); start_velocity = [1, 0, 0] m/s;
         start_rate = [0, 0, 2] rad/s; stiffness = [1, 2, 3] N/m; turning_stiffness = 4;
         turning_limits = 1 rad; turning_limit_stiffness = 10; torque = input;",
    );
    assert_eq!(floating.kind, HingeKind::Floating);
    assert_eq!(all_known(&floating.start), [1.0, 2.0, 3.0, 0.0, 0.0, 0.6, 0.8]);
    assert_eq!(all_known(&floating.start_rate), [1.0, 0.0, 0.0, 0.0, 0.0, 2.0]);
    assert_eq!(stiffness(&floating), [1.0, 2.0, 3.0, 4.0, 4.0, 4.0]);
    assert!(floating.passive[2].limits.is_none() && floating.passive[3].limits.is_some());
    let [free, input] = [Effort::Free, Effort::Input].map(|effort| vec![effort; 3]);
    assert_eq!(floating.drive, Drive::Efforts([free, input].concat()));
}

#[test]
fn an_elastic_hinge_is_turned_by_angles() {
    let elastic = hinge(
        "elastic",
        "start = [1, 2, 3] mm turned rpy(0.1, 0.2, 30); start_rate = [1, 2, 3] rad/s;
         stiffness = 1e6 N/m; turning_stiffness = [1, 2, 3] N*m/rad;
         turning_limits = [-1, 1] rad; turning_limit_stiffness = 10; force = [1, 2, 3] N;
         torque = [4, 5, 6] N*m;",
    );
    assert_eq!(elastic.kind, HingeKind::Elastic);
    assert_eq!(all_known(&elastic.start), [0.001, 0.002, 0.003, 0.1, 0.2, 30.0]);
    assert_eq!(all_known(&elastic.rest), [0.0; 6]);
    assert_eq!(all_known(&elastic.start_rate), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
    assert_eq!(stiffness(&elastic), [1e6, 1e6, 1e6, 1.0, 2.0, 3.0]);
    assert_eq!(constants(&elastic.drive), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert!(elastic.passive[2].limits.is_none() && elastic.passive[3].limits.is_some());
}

#[test]
fn a_motion_can_be_given() {
    let ball = hinge("ball", "motion = input; stiffness = 2; rest = rpy(1, 0, 0);");
    assert_eq!(ball.drive, Drive::Prescribed);
    assert!(ball.is_prescribed());
    assert_eq!(stiffness(&ball), [2.0; 3]);
}

#[test]
fn numbers_of_hinges_may_hang_on_parameters_and_constants() {
    let pin = hinge(
        "pin",
        "stiffness = ratio; friction = MU; friction_speed = 0.1; limits = [-A, A];
         limit_stiffness = 10;",
    );
    assert!(pin.passive[0].stiffness.known().is_none());
    assert!(pin.passive[0].friction.is_some() && pin.passive[0].limits.is_some());
}
