//! Parts: named pieces of routes, which are written out.

use super::trees::{ROD, joints, rods};
use super::{chain, known};
use crate::model::Chain;

/// A leg with a separate type, whose mass is the first parameter and whose side is the second one.
const LEG: &str = "part Leg(heavy, side) {
        body Hip {
            mass = heavy; com = [0, side*0.1, 0] m; output = [0, side*20, 0] cm;
            inertia = diag(1, 1, 1) kg*m^2 about com;
            point foot = [0, 0, side] m turned rpy(side*90, 0, 0) deg;
        }
        pin([side, 0, 0]) haa -> Hip hip -> pin(y) kfe -> Hip shank;
        hip.foot -> weld w -> Rod sole;
        hinge haa, kfe { torque = input; }
        hinge kfe { start = side*0.5 rad; }
        load push { on = hip.foot; force = input; }
        spring cord { on = sole.tip; to = hip.input; stiffness = 3 N/m; }
    }";

fn legs(routes: &str) -> Chain {
    rods(&format!("param m = 2 kg; {LEG} {routes}"))
}

fn names(chain: &Chain) -> [Vec<String>; 2] {
    let bodies = chain.bodies.iter().map(|body| format!("{} {}", body.name, body.path));
    let hinges = chain.hinges.iter().map(|hinge| format!("{} {}", hinge.name, hinge.path));
    [bodies.collect(), hinges.collect()]
}

#[test]
fn parts_are_written_out() {
    let tree = legs(
        "Rod trunk; trunk.tip -> Leg(m, 1) lf -> weld glue -> Rod boot; trunk.output -> Leg(3 kg, -1) rf; \
         hinge lf.haa { start = 30 deg; }",
    );
    assert_eq!(
        joints(&tree),
        [
            "ground trunk trunk.input",
            "trunk.tip lf.haa lf.hip.input",
            "lf.hip.output lf.kfe lf.shank.input",
            "lf.shank.output glue boot.input",
            "lf.hip.foot lf.w lf.sole.input",
            "trunk.output rf.haa rf.hip.input",
            "rf.hip.output rf.kfe rf.shank.input",
            "rf.hip.foot rf.w rf.sole.input",
        ]
    );
    assert_eq!(
        names(&tree)[0],
        [
            "trunk trunk",
            "lf_hip lf.hip",
            "lf_shank lf.shank",
            "boot boot",
            "lf_sole lf.sole",
            "rf_hip rf.hip",
            "rf_shank rf.shank",
            "rf_sole rf.sole",
        ]
    );
    let results: Vec<String> =
        tree.bodies.iter().map(|body| format!("{} {}", body.type_name, body.result_name)).collect();
    assert_eq!(results[..2], ["Rod Rod", "Hip LegHip"]);
    let start = |path: &str| {
        let hinge = tree.hinges.iter().find(|hinge| hinge.path == path).expect("a hinge");
        hinge.start[0].known()
    };
    assert_eq!(start("lf.haa"), Some(30_f64.to_radians()));
    assert_eq!([start("lf.kfe"), start("rf.kfe")], [Some(0.5), Some(-0.5)]);
    let springs: Vec<&str> = tree.springs.iter().map(|spring| &*spring.path).collect();
    assert_eq!(springs, ["lf.cord", "rf.cord"]);
    let loads: Vec<String> = tree.loads.iter().map(|load| load.name.to_string()).collect();
    assert_eq!(loads, ["lf_push", "rf_push"]);
}

#[test]
fn parameters_are_replaced_by_their_arguments() {
    let tree = legs("Rod trunk; trunk.tip -> Leg(m + 1 kg, -2) lf;");
    let hip = tree.bodies.iter().find(|body| body.path == "lf.hip").expect("a body");
    assert_eq!(hip.mass.at(&[Some(2.0)]), Some(3.0));
    assert_eq!(known(&hip.com), [0.0, -0.2, 0.0]);
    assert_eq!(known(&hip.output.position), [0.0, -0.4, 0.0]);
    assert_eq!(known(&hip.points[0].frame.position), [0.0, 0.0, -2.0]);
    // An angle of -180 degrees.
    assert_eq!(hip.points[0].frame.rotation[1][1].known(), Some(-1.0));
    let axes = tree.hinges.iter().find(|hinge| hinge.path == "lf.haa").expect("a hinge");
    assert_eq!(
        axes.kind.axes()[0].each_ref().map(|entry| entry.known()),
        [-2.0, 0.0, 0.0].map(Some)
    );
}

/// The arguments are those of where they are written: an inner parameter may have the name of an outer one.
#[test]
fn arguments_have_the_names_of_where_they_are_written() {
    let tree = rods(
        "param m = 1 kg;
         part Inner(x, y) {
             body B { mass = x; com = [y, 0, 0] m; output = [1, 0, 0]; inertia = diag(1, 1, 1) kg*m^2 about com; }
             pin a -> B b;
         }
         part Outer(y, x) { Inner(2*y + m, x) first -> Inner(y, y/(1 kg)) second; }
         ground -> Outer(3 kg, 7) o;
         o.second.b.input -> weld k -> Rod r;",
    );
    let values =
        tree.bodies.iter().take(2).map(|body| {
            (body.path.clone(), body.mass.at(&[Some(1.0)]), body.com[0].at(&[Some(1.0)]))
        });
    assert_eq!(
        values.collect::<Vec<_>>(),
        [
            ("o.first.b".to_owned(), Some(7.0), Some(7.0)),
            ("o.second.b".to_owned(), Some(3.0), Some(3.0)),
        ]
    );
}

#[test]
fn parts_may_be_a_hinge_or_contain_parts_and_repeats() {
    let tree = rods(
        "part Servo(gain) { pin(y) axle; hinge axle { damping = gain*1 N*m*s/rad; } }
         part Finger { Servo(2) -> Rod near -> repeat 3 { pin bend -> Rod link }; }
         part Hand { pin wrist -> Rod palm; palm.tip -> Finger left; palm.output -> Finger right; palm.tip -> pin t -> Rod thumb; }
         ground -> Hand hand;
         hand.left.link.tip -> weld nail -> Rod tip;
         hinge hand.left.servo.axle { start = 1 rad; }",
    );
    let paths: Vec<String> = tree.hinges.iter().take(7).map(|hinge| hinge.path.clone()).collect();
    assert_eq!(
        paths,
        [
            "hand.wrist",
            "hand.left.servo.axle",
            "hand.left.bend",
            "hand.right.servo.axle",
            "hand.right.bend",
            "hand.t",
            "nail",
        ]
    );
    assert_eq!(
        tree.hinges.iter().nth(1).map(|hinge| hinge.name.to_string()).as_deref(),
        Some("hand_left_servo_axle")
    );
}

#[test]
fn parts_may_be_set_in_a_repeat() {
    let tree = rods(
        "part Foot(side) { ball hip -> Rod thigh; thigh.tip -> pin toe -> Rod claw; }
         part Segment { pin joint -> Rod bone -> weld w -> Rod plate; }
         ground -> weld w -> Rod head
             -> repeat 4 { Segment s; s.bone.tip -> Foot(1) left; s.plate.tip -> Foot(-1) right; };
         hinge s.joint, left.hip, right.toe { damping = 1; }",
    );
    let repeat = tree.repeats.iter().next().expect("a repeat");
    let paths = |ids: crate::ids::IdRange<crate::model::BodyId>| -> Vec<String> {
        ids.into_iter().map(|body| tree.bodies[body].path.clone()).collect()
    };
    assert_eq!(
        paths(repeat.bodies),
        ["s.bone", "s.plate", "left.thigh", "left.claw", "right.thigh", "right.claw"]
    );
    assert_eq!(tree.bodies[repeat.last_body].path, "s.plate");
}

#[test]
fn a_part_may_float() {
    let tree = rods(
        "part Rex { Rod trunk -> pin a -> Rod tail; } Rex rex; body rex.trunk { start = [0, 0, 1] m; }",
    );
    assert_eq!(
        joints(&tree),
        ["ground rex.trunk rex.trunk.input", "rex.trunk.output rex.a rex.tail.input"]
    );
    assert_eq!(
        tree.hinges.iter().next().map(|hinge| hinge.name.to_string()).as_deref(),
        Some("rex_trunk")
    );
    assert_eq!(tree.hinges.iter().next().map(|hinge| hinge.start[2].known()), Some(Some(1.0)));
}

#[test]
fn uses_of_names_in_parts_are_those_of_the_first_instance() {
    let source = format!(
        "chain A {{ {ROD} param m = 2 kg; {LEG} Rod trunk; trunk.tip -> Leg(m, 1) lf; trunk.output -> Leg(m, -1) rf; }}"
    );
    let (_, passthrough) = chain(&source);
    let instances: Vec<String> = passthrough
        .instances
        .iter()
        .map(|instance| format!("{} {}", instance.part, instance.path))
        .collect();
    assert_eq!(instances, ["Leg lf", "Leg rf"]);
    let text =
        |names: &[proc_macro2::Ident]| names.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(text(&passthrough.references.types), ["Rod", "LegHip"]);
    assert_eq!(
        text(&passthrough.references.elements),
        ["lf_haa", "lf_kfe", "lf_kfe", "lf_hip", "lf_sole", "lf_hip"]
    );
}
