//! Trees: several routes, places, and repeated parts with branches.

use super::chain;
use crate::model::{Attachment, BodyId, Chain, HingeId, SpringEnd};

/// A body type with a turned point.
pub(super) const ROD: &str = "body Rod { mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m; inertia = diag(0, 1/6, 1/6) kg*m^2 about com; \
     point tip = [1, 1, 0] m turned rpy(0, 0, 90) deg; }";

/// A chain of rods.
pub(super) fn rods(text: &str) -> Chain {
    chain(&format!("chain A {{ {ROD} {text} }}")).0
}

/// Returns the name of each hinge with the place that it leaves and the body that it moves.
pub(super) fn joints(chain: &Chain) -> Vec<String> {
    let body = |body: BodyId| chain.bodies[body].path.clone();
    let place = |place: &Attachment| match place {
        Attachment::Ground(_) => "ground".to_owned(),
        Attachment::Input(of) => format!("{}.input", body(*of)),
        Attachment::Output(of) => format!("{}.output", body(*of)),
        Attachment::Point(of, index) => {
            format!("{}.{}", body(*of), chain.bodies[*of].points[*index].name)
        }
    };
    let joint = |hinge: HingeId| {
        let hinge = &chain.hinges[hinge];
        format!("{} {} {}", place(&hinge.inboard), hinge.path, place(&hinge.outboard))
    };
    chain.hinges.ids().into_iter().map(joint).collect()
}

#[test]
fn routes_begin_at_places_of_earlier_bodies() {
    let tree = rods(
        "ground -> pin a -> Rod x -> pin b -> Rod y; x.tip -> ball c -> Rod z; y.input -> pin d -> Rod u; \
         z.output -> weld e -> Rod s; ground at [1, 0, 0] m -> pin f -> Rod w;",
    );
    assert_eq!(
        joints(&tree),
        [
            "ground a x.input",
            "x.output b y.input",
            "x.tip c z.input",
            "y.input d u.input",
            "z.output e s.input",
            "ground f w.input",
        ]
    );
    let [row, ..] = &tree.bodies[BodyId(0)].points[0].frame.rotation;
    assert_eq!(row.each_ref().map(|entry| entry.known()), [Some(0.0), Some(-1.0), Some(0.0)]);
}

#[test]
fn floating_bases_come_before_moving_ends() {
    let tree = rods(
        "Rod x; moving hand -> pin a -> Rod y; x.tip -> pin b -> Rod z; body x { start = [1, 0, 0] m; }",
    );
    assert_eq!(
        joints(&tree),
        ["ground x x.input", "ground hand hand.input", "hand.output a y.input", "x.tip b z.input",]
    );
    assert_eq!(tree.elements.len(), 5);
    let forest =
        rods("Rod x; ground -> floating base -> Rod y; hinge base { start = [1, 0, 0] m; }");
    assert_eq!(joints(&forest), ["ground x x.input", "ground base y.input"]);
}

#[test]
fn the_first_route_may_close_with_branches_on_it() {
    let tree = rods(
        "ground -> pin a -> Rod x -> pin b -> Rod y -> pin c -> ground at [1, 0, 0] m; \
         x.tip -> pin d -> Rod z;",
    );
    assert_eq!(joints(&tree)[2..], ["y.output c ground", "x.tip d z.input"]);
}

#[test]
fn words_of_the_language_may_name_bodies() {
    for name in ["part", "last", "load", "spring", "moving", "from", "repeat", "method", "ball"] {
        let tree = rods(&format!("ground -> pin a -> Rod {name}; {name}.tip -> pin b -> Rod y;"));
        assert_eq!(joints(&tree)[1], format!("{name}.tip b y.input"));
    }
}

#[test]
fn blocks_and_routes_may_be_mixed() {
    let tree = rods(
        "ground -> pin a -> Rod x; hinge b { start = 1 rad; } load l { on = y.tip; force = input; } \
         x.tip -> pin b -> Rod y; hinge a { start = 2 rad; }",
    );
    let starts = tree.hinges.iter().map(|hinge| hinge.start[0].known());
    assert_eq!(starts.collect::<Vec<_>>(), [Some(2.0), Some(1.0)]);
    assert_eq!(tree.loads.iter().next().map(|load| load.body), Some(BodyId(1)));
}

/// A ladder: a rope of links with a rung to the left of each.
const LADDER: &str = "ground -> weld w -> Rod beam
    -> repeat 5 from rung.tip = beam.tip, link.tip = beam.output {
        ball knot -> Rod link;
        link.tip -> ball joint -> Rod rung;
        last.rung.tip -> pin side -> Rod knob;
    }
    -> ball hook -> Rod weight;
    rung.tip -> pin below -> Rod tail;";

#[test]
fn repeated_parts_have_branches() {
    let tree = rods(LADDER);
    let repeat = tree.repeats.iter().next().expect("a repeat");
    let body = |name: &str| {
        let found = tree.bodies.ids().into_iter().find(|&body| tree.bodies[body].path == name);
        found.expect("a body")
    };
    assert_eq!(repeat.count, 5);
    assert_eq!(repeat.last_body, body("link"));
    assert_eq!([repeat.bodies.first(), repeat.bodies.last()], ["link", "knob"].map(body));
    assert_eq!(repeat.elements, 2..8);
    assert_eq!(repeat.from_previous.len(), 1);
    let from = &repeat.from_previous[0];
    assert_eq!(tree.hinges[from.hinge].path, "side");
    assert_eq!(from.previous, Attachment::Point(body("rung"), 0));
    let names = tree.elements.len();
    assert_eq!(names, 12);
}

#[test]
fn springs_end_on_bodies() {
    let tree = rods(&format!(
        "{LADDER}
        spring a {{ on = beam.tip; to = weight.output; stiffness = 1; }}
        spring b {{ on = rung; to = last.rung.tip; stiffness = 1; }}
        spring c {{ on = rung.tip; to = link.com; stiffness = 1; }}
        spring d {{ on = link.input; to = beam.output; stiffness = 1; }}
        spring e {{ on = beam; at = output; to = [1, 2, 3] m; stiffness = 1; }}"
    ));
    let path = |body: BodyId| tree.bodies[body].path.clone();
    let at = |point: &crate::model::BodyPoint| {
        format!("{} {:?}", path(point.body), super::known(&point.at))
    };
    let end = |end: &SpringEnd| match end {
        SpringEnd::Ground(point) => format!("{:?}", super::known(point)),
        SpringEnd::Body(point) => at(point),
        SpringEnd::Previous { point, first } => format!("{} first {}", at(point), at(first)),
    };
    let springs: Vec<String> = tree
        .springs
        .iter()
        .map(|spring| format!("{} to {}", at(&spring.on), end(&spring.to)))
        .collect();
    assert_eq!(
        springs,
        [
            "beam [1.0, 1.0, 0.0] to weight [1.0, 0.0, 0.0]",
            "rung [0.5, 0.0, 0.0] to rung [1.0, 1.0, 0.0] first beam [1.0, 1.0, 0.0]",
            "rung [1.0, 1.0, 0.0] to link [0.5, 0.0, 0.0]",
            "link [0.0, 0.0, 0.0] to beam [1.0, 0.0, 0.0]",
            "beam [1.0, 0.0, 0.0] to [1.0, 2.0, 3.0]",
        ]
    );
}
