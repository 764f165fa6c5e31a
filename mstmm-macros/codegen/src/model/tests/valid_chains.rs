//! Chains without errors: dimensions, ends, loads and repeated parts.

use super::{all_known, chain, edited, known};
use crate::ids::{BodyId, ChannelId, HingeId, LoadId, RepeatId, SpringId};
use crate::model::{
    Attachment, Chain, Dimension, Drive, Element, HingeKind, LoadAxes, Repeat, RepeatBoundary,
    Role, Source, SpringEnd, Value,
};

const ROUTE: &str = "ground -> pin(z) shoulder -> Cube upper -> ball wrist -> Rod rod;";

/// The example with another route, whose hinges `wrist` and `shoulder` need no properties.
fn on_route(route: &str) -> Chain {
    let (chain, _) = chain(&edited(&[
        (ROUTE, route),
        ("hinge wrist { start_rate = [0, 0.1, 0] rad/s; }", ""),
        ("hinge shoulder { start = 30 deg; torque = input; }", ""),
        ("1/6, 1/6) kg*m^2 about com;", "1/6, 1/6) kg*m^2 about com; output = [1, 0, 0] m;"),
    ]));
    chain
}

fn names(chain: &Chain) -> (Vec<String>, Vec<String>) {
    let bodies = chain.bodies.iter().map(|body| body.name.to_string());
    (bodies.collect(), chain.hinges.iter().map(|hinge| hinge.name.to_string()).collect())
}

fn is_moving(chain: &Chain, hinge: usize, body: usize) -> bool {
    let (hinge, body) = (HingeId(hinge), BodyId(body));
    let implied = &chain.hinges[hinge];
    let body_is_end =
        chain.bodies[body].role == Role::MovingEnd && chain.bodies[body].mass.is_zero();
    body_is_end && implied.is_prescribed() && implied.outboard == Attachment::Input(body)
}

const PLANE: &str = "
    plane chain Swing {
        gravity = [0, -9.8] m/s^2;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0] m;
            output = [1, 0] m turned 90 deg;
            inertia = 1/12 kg*m^2 about com;
            point tip = [1, 0.1] m;
        }
        ground at [1, 2] m turned 90 deg -> pin a -> Rod first
            -> slider([3, 4]) b -> Rod second -> elastic c -> Rod third -> floating d -> Rod last;
        hinge c { start = [1, 2] mm turned 3 rad; turning_stiffness = 7; }
        load push { on = last; at = tip; force = [1, 2] N; torque = 3 N*m; axes = body; }
        spring rope { on = last; at = output; to = [5, 6] m; stiffness = 7; damping = 8; length = 9; }
    }";

#[test]
fn a_plane_chain_lies_in_the_plane() {
    let (chain, _) = chain(PLANE);
    assert_eq!(chain.dimension, Dimension::Plane);
    assert_eq!(chain.gravity, Source::Constant([0.0, -9.8, 0.0].map(Value::number)));
    let body = &chain.bodies[BodyId(0)];
    assert_eq!(known(&body.com), [0.5, 0.0, 0.0]);
    assert_eq!(known(&body.inertia.tensor), [0.0, 0.0, 1.0 / 12.0, 0.0, 0.0, 0.0]);
    let quarter = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(body.output.rotation.each_ref().map(known), quarter);
    let Attachment::Ground(frame) = &chain.hinges[HingeId(0)].inboard else {
        panic!("on the ground")
    };
    assert_eq!(known(&frame.position), [1.0, 2.0, 0.0]);
    assert_eq!(frame.rotation.each_ref().map(known), quarter);
    let kinds: Vec<_> = chain.hinges.iter().map(|hinge| hinge.kind.clone()).collect();
    let z = [0.0, 0.0, 1.0].map(Value::number);
    let slide = [3.0, 4.0, 0.0].map(Value::number);
    assert_eq!(kinds[0], HingeKind::Pin { axis: z });
    assert_eq!(kinds[1], HingeKind::Slider { axis: slide });
    assert_eq!(kinds[2..], [HingeKind::PlaneElastic, HingeKind::Planar { normal: 2 }]);
    assert_eq!(all_known(&chain.hinges[HingeId(2)].start), [0.001, 0.002, 3.0]);

    let load = &chain.loads[LoadId(0)];
    assert_eq!((load.body, load.axes), (BodyId(3), LoadAxes::Body));
    assert_eq!(known(&load.at.position), [1.0, 0.1, 0.0]);
    assert_eq!(load.force, Source::Constant([1.0, 2.0, 0.0].map(Value::number)));
    assert_eq!(load.torque, Source::Constant([0.0, 0.0, 3.0].map(Value::number)));
    let spring = &chain.springs[SpringId(0)];
    assert_eq!(known(&spring.on.at), [1.0, 0.0, 0.0]);
    assert_eq!(spring.to, SpringEnd::Ground([5.0, 6.0, 0.0].map(Value::number)));
    let numbers = [&spring.stiffness, &spring.damping, &spring.length];
    assert_eq!(numbers.map(|number| number.known()), [Some(7.0), Some(8.0), Some(9.0)]);
}

#[test]
fn a_floating_plane_chain_has_three_coordinates() {
    let route = "ground at [1, 2] m turned 90 deg -> pin a -> Rod first";
    let (chain, _) = chain(&PLANE.replace(route, "Rod first").replace(
        "hinge c",
        "body first { start = [1, 2] m turned 3; start_velocity = [4, 5] m/s; start_rate = 6; }
         hinge c",
    ));
    let implied = &chain.hinges[HingeId(0)];
    assert_eq!(
        (implied.name.to_string(), &implied.kind),
        ("first".into(), &HingeKind::Planar { normal: 2 })
    );
    assert_eq!(all_known(&implied.start), [1.0, 2.0, 3.0]);
    assert_eq!(all_known(&implied.start_rate), [4.0, 5.0, 6.0]);
}

#[test]
fn a_line_chain_has_numbers_for_vectors() {
    let (chain, _) = chain(
        "line chain Train {
            gravity = -1 m/s^2;
            body Car { mass = 2 kg; output = 0.3 m; point hook = 0.2 m; }
            body Last { mass = 1 kg; com = 0.1 m; }
            Car front -> elastic a -> Car second -> floating b -> Car third -> slider c -> Last;
            body front { start = 3 m; start_velocity = 4 m/s; }
            hinge a, c { stiffness = 5 N/m; force = input; }
            load push { on = last; at = input; force = 6 N; }
            spring buffer { on = second; at = hook; to = 7 m; stiffness = 8 N/m; }
        }",
    );
    assert_eq!(chain.gravity, Source::Constant([-1.0, 0.0, 0.0].map(Value::number)));
    let slider = HingeKind::Slider { axis: [1.0, 0.0, 0.0].map(Value::number) };
    assert!(chain.hinges.iter().all(|hinge| hinge.kind == slider));
    assert_eq!(names(&chain).1, ["front", "a", "b", "c"]);
    assert_eq!(all_known(&chain.hinges[HingeId(0)].start), [3.0]);
    assert_eq!(all_known(&chain.hinges[HingeId(0)].start_rate), [4.0]);
    assert_eq!(known(&chain.bodies[BodyId(0)].com), [0.0; 3]);
    assert_eq!(known(&chain.bodies[BodyId(0)].inertia.tensor), [0.0; 6]);
    assert_eq!(known(&chain.bodies[BodyId(3)].com), [0.1, 0.0, 0.0]);
    assert_eq!(known(&chain.bodies[BodyId(0)].output.position), [0.3, 0.0, 0.0]);
    assert_eq!(chain.loads[LoadId(0)].force, Source::Constant([6.0, 0.0, 0.0].map(Value::number)));
    assert_eq!(chain.loads[LoadId(0)].torque, Source::Nothing);
    assert_eq!(known(&chain.springs[SpringId(0)].on.at), [0.2, 0.0, 0.0]);
}

#[test]
fn gravity_can_be_an_input() {
    let (chain, _) = chain(&edited(&[("[0, -9.8, 0] m/s^2", "input")]));
    assert_eq!(chain.gravity, Source::Input);
}

#[test]
fn both_ends_can_be_held() {
    let chain = on_route(
        "ground -> pin a -> Cube upper -> pin b -> Rod rod -> ball c -> ground at [1, 0, 0] m;",
    );
    assert_eq!(chain.hinges.len(), 3);
    assert_eq!(chain.hinges[HingeId(2)].inboard, Attachment::Output(BodyId(1)));
    assert!(
        matches!(&chain.hinges[HingeId(2)].outboard, Attachment::Ground(frame) if known(&frame.position) == [1.0, 0.0, 0.0])
    );
}

/// The bodies of moving ends follow all others, their hinges in front.
#[test]
fn ends_can_move() {
    let chain = on_route("moving hand -> pin a -> Cube upper -> ball b -> Rod rod;");
    assert_eq!(names(&chain).0, ["upper", "rod", "hand"]);
    assert_eq!(names(&chain).1, ["hand", "a", "b"]);
    assert!(is_moving(&chain, 0, 2));
    assert_eq!(chain.hinges[HingeId(0)].kind, HingeKind::Floating);
    assert_eq!(all_known(&chain.hinges[HingeId(0)].start), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(
        (&chain.hinges[HingeId(1)].inboard, &chain.hinges[HingeId(1)].outboard),
        (&Attachment::Output(BodyId(2)), &Attachment::Input(BodyId(0)))
    );
    let route = [
        Element::Hinge(HingeId(1)),
        Element::Body(BodyId(0)),
        Element::Hinge(HingeId(2)),
        Element::Body(BodyId(1)),
    ];
    assert_eq!(chain.elements, route);

    let chain = on_route("Cube upper -> ball b -> Rod rod -> pin a -> moving hand;");
    assert_eq!(names(&chain).1, ["hand", "b", "a"]);
    assert_eq!(
        (&chain.hinges[HingeId(2)].inboard, &chain.hinges[HingeId(2)].outboard),
        (&Attachment::Output(BodyId(1)), &Attachment::Input(BodyId(2)))
    );

    let chain = on_route(
        "moving left -> pin a -> Cube upper -> ball b -> Rod rod -> weld c -> moving right;",
    );
    assert_eq!(names(&chain).0, ["upper", "rod", "left", "right"]);
    assert_eq!(names(&chain).1, ["left", "right", "a", "b", "c"]);
    assert!(is_moving(&chain, 0, 2) && is_moving(&chain, 1, 3));
    assert_eq!(chain.hinges[HingeId(2)].inboard, Attachment::Output(BodyId(2)));
    assert_eq!(chain.hinges[HingeId(4)].outboard, Attachment::Input(BodyId(3)));
}

#[test]
fn loads_act_at_points() {
    let load = |at: &str| {
        let load = format!(
            "load push {{ on = upper; {at} force = input; torque = [0, 0, 1] N*mm; }} hinge wrist"
        );
        let (chain, _) = chain(&edited(&[
            ("hinge wrist", &load),
            (
                "output = [1, 0, 0] m;",
                "output = [1, 0, 0] m; /// At its corner.\n point tip = [1, 1, 0] m;",
            ),
        ]));
        let load = chain.loads[LoadId(0)].clone();
        assert_eq!(load.force, Source::Input);
        assert_eq!(load.torque, Source::Constant([0.0, 0.0, 0.001].map(Value::number)));
        assert_eq!((load.body, load.axes), (BodyId(0), LoadAxes::Inertial));
        known(&load.at.position)
    };
    assert_eq!(load(""), [0.5, 0.0, 0.0]);
    assert_eq!(load("at = com;"), [0.5, 0.0, 0.0]);
    assert_eq!(load("at = input;"), [0.0, 0.0, 0.0]);
    assert_eq!(load("at = output;"), [1.0, 0.0, 0.0]);
    assert_eq!(load("at = tip;"), [1.0, 1.0, 0.0]);
    assert_eq!(load("at = [1, 2, 3] mm;"), [0.001, 0.002, 0.003]);
}

/// The boundary on the inboard side of a hinge, and what that is welded to.
fn behind_seam(chain: &Chain, hinge: usize) -> (RepeatBoundary, Attachment) {
    let boundary =
        chain.repeat_boundary(&chain.hinges[HingeId(hinge)].inboard).expect("a boundary");
    let weld = chain.weld_of(boundary);
    (boundary, chain.hinges[weld].inboard.clone())
}

#[test]
fn parts_of_the_route_can_be_repeated() {
    let chain = on_route(
        "Cube first -> repeat 1_000 { pin a -> Cube upper -> ball b -> Rod rod } -> weld c -> Rod d
         -> repeat 3 { pin e -> Rod f };",
    );
    assert_eq!(names(&chain).1[..5], ["first", "a", "b", "c", "e"]);
    assert_eq!(
        chain.repeats.as_slice(),
        [
            Repeat {
                count: 1000,
                hinges: (1..3).into(),
                bodies: (1..3).into(),
                elements: 1..5,
                last_body: BodyId(2),
                from_previous: vec![]
            },
            Repeat {
                count: 3,
                hinges: (4..5).into(),
                bodies: (4..5).into(),
                elements: 7..9,
                last_body: BodyId(4),
                from_previous: vec![]
            },
        ]
    );
    assert_eq!(
        behind_seam(&chain, 1),
        (
            RepeatBoundary { repeat: RepeatId(0), channel: ChannelId(0), at_end: false },
            Attachment::Output(BodyId(0))
        )
    );
    assert_eq!(
        behind_seam(&chain, 3),
        (
            RepeatBoundary { repeat: RepeatId(0), channel: ChannelId(0), at_end: true },
            Attachment::Output(BodyId(2))
        )
    );

    let chain = on_route("ground -> repeat 5 { pin a -> Rod b } -> pin c -> ground; load x { on = b; force = input; }".replace("Rod b }", "Cube u -> pin d -> Rod b }").as_str());
    assert_eq!(
        chain.repeats.as_slice(),
        [Repeat {
            count: 5,
            hinges: (0..2).into(),
            bodies: (0..2).into(),
            elements: 0..4,
            last_body: BodyId(1),
            from_previous: vec![]
        }]
    );
    assert_eq!(chain.loads[LoadId(0)].body, BodyId(1));
    assert!(matches!(behind_seam(&chain, 0).1, Attachment::Ground(_)));
    assert_eq!(behind_seam(&chain, 2).1, Attachment::Output(BodyId(1)));
    assert_eq!(chain.hinges[HingeId(0)].drive, Drive::Efforts(vec![crate::model::Effort::Free]));
}

/// Words of this language that are also good names.
#[test]
fn words_that_begin_items_can_be_names() {
    let chain = on_route(
        "ground -> elastic spring -> Cube load -> ball moving -> Rod line; load plane { on = load; force = input; }",
    );
    assert_eq!(names(&chain).1, ["spring", "moving"]);
    assert_eq!(chain.loads[LoadId(0)].body, BodyId(0));
}
