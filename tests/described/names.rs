//! The names of each chain, written out.

use super::models::{Crawler, FourBar, Kinds, Raft, Rope, Train};
use mstmm::Described;
use mstmm::description::Quantities;

fn names(list: Quantities) -> Vec<String> {
    list.iter().map(|quantity| quantity.name.to_string()).collect()
}

/// Returns a list with its units.
fn with_units(list: Quantities) -> Vec<String> {
    list.iter().map(|quantity| format!("{} {}", quantity.name, quantity.unit)).collect()
}

/// Returns the words of a text.
fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

#[test]
fn coordinates_are_accessors_of_states() {
    let kinds = <Kinds<f64> as Described>::DESCRIPTION;
    assert_eq!(
        names(kinds.coordinates()),
        words(
            "a.position b.position b.angle c.angles.x c.angles.y d.angle e.position.x e.position.y e.angle
             f.displacement.x f.displacement.y f.displacement.z f.angles.x f.angles.y f.angles.z
             g.orientation.w g.orientation.x g.orientation.y g.orientation.z
             h.position.x h.position.y h.position.z
             h.orientation.w h.orientation.x h.orientation.y h.orientation.z"
        )
    );
    assert_eq!(
        names(kinds.rates()),
        words(
            "a.velocity b.velocity b.rate c.rates.x c.rates.y d.rate e.velocity.x e.velocity.y e.rate
             f.velocity.x f.velocity.y f.velocity.z f.rate.x f.rate.y f.rate.z
             g.rate.x g.rate.y g.rate.z
             h.velocity.x h.velocity.y h.velocity.z h.rate.x h.rate.y h.rate.z"
        )
    );
    let line = <Train<f64> as Described>::DESCRIPTION;
    assert_eq!(names(line.coordinates()), ["first.position", "a.position"]);
    let closed = <FourBar<f64> as Described>::DESCRIPTION;
    assert_eq!(names(closed.coordinates()), ["a.angle", "b.angle", "c.angle", "d.angle"]);
    let plane = <Raft<f64> as Described>::DESCRIPTION;
    assert_eq!(
        names(plane.coordinates()),
        words(
            "first.position.x first.position.y first.angle a.displacement.x a.displacement.y a.angle
             b.angle c.position d.position.x d.position.y d.angle"
        )
    );
}

#[test]
fn repeated_parts_are_in_the_order_of_their_repetitions() {
    let crawler = <Crawler<f64> as Described>::DESCRIPTION;
    let repetition = |k: usize| {
        format!(
            "a[{k}].orientation.w a[{k}].orientation.x a[{k}].orientation.y a[{k}].orientation.z b[{k}].angle "
        )
    };
    let all = [
        "trunk.position.x trunk.position.y trunk.position.z trunk.orientation.w trunk.orientation.x \
         trunk.orientation.y trunk.orientation.z ",
        &repetition(0),
        &repetition(1),
        &repetition(2),
        "c.position left.hip.angle left.knee.angle right.hip.angle right.knee.angle",
    ];
    assert_eq!(names(crawler.coordinates()), words(&all.concat()));
    let rope = <Rope<f64> as Described>::DESCRIPTION;
    assert_eq!(rope.coordinate("joint[12].angle"), Some(12));
    assert_eq!(rope.rate("joint[99].rate"), Some(99));
    assert_eq!(rope.coordinate("hook.angle"), Some(100));
    assert_eq!(rope.point("rod[3].output"), Some(8));
}

#[test]
fn inputs_have_units() {
    let kinds = <Kinds<f64> as Described>::DESCRIPTION;
    let expected = "gravity.x m/s^2 gravity.y m/s^2 gravity.z m/s^2
        deck.state.position.x m deck.state.position.y m deck.state.position.z m
        deck.state.orientation.w 1 deck.state.orientation.x 1 deck.state.orientation.y 1 deck.state.orientation.z 1
        deck.state.velocity.x m/s deck.state.velocity.y m/s deck.state.velocity.z m/s
        deck.state.rate.x rad/s deck.state.rate.y rad/s deck.state.rate.z rad/s
        deck.acceleration.linear.x m/s^2 deck.acceleration.linear.y m/s^2 deck.acceleration.linear.z m/s^2
        deck.acceleration.angular.x rad/s^2 deck.acceleration.angular.y rad/s^2 deck.acceleration.angular.z rad/s^2
        a N b.force N b.torque N*m c.x N*m c.y N*m e.x N e.y N
        shaker.state.angle rad shaker.state.rate rad/s shaker.acceleration rad/s^2
        g.x N*m g.y N*m g.z N*m
        h.force.x N h.force.y N h.force.z N h.torque.x N*m h.torque.y N*m h.torque.z N*m
        push.force.x N push.force.y N push.force.z N push.torque.x N*m push.torque.y N*m push.torque.z N*m";
    assert_eq!(with_units(kinds.inputs()).join(" "), words(expected).join(" "));
    let plane = <Raft<f64> as Described>::DESCRIPTION;
    let expected = "gravity.x m/s^2 gravity.y m/s^2 b N*m d.force.x N d.force.y N d.torque N*m
        wind.force.x N wind.force.y N wind.torque N*m";
    assert_eq!(with_units(plane.inputs()).join(" "), words(expected).join(" "));
    let line = <Train<f64> as Described>::DESCRIPTION;
    let expected =
        "gravity m/s^2 b.state.position m b.state.velocity m/s b.acceleration m/s^2 engine.force N";
    assert_eq!(with_units(line.inputs()).join(" "), expected);
    let crawler = <Crawler<f64> as Described>::DESCRIPTION;
    let expected = "b[0] N*m b[1] N*m b[2] N*m left.knee N*m right.knee N*m
        left.kick.force.x N left.kick.force.y N left.kick.force.z N
        right.kick.force.x N right.kick.force.y N right.kick.force.z N
        push[0].force.x N push[0].force.y N push[0].force.z N
        push[1].force.x N push[1].force.y N push[1].force.z N
        push[2].force.x N push[2].force.y N push[2].force.z N
        steer.torque.x N*m steer.torque.y N*m steer.torque.z N*m";
    assert_eq!(with_units(crawler.inputs()).join(" "), words(expected).join(" "));
}

#[test]
fn parameters_have_the_units_of_their_defaults() {
    let kinds = <Kinds<f64> as Described>::DESCRIPTION;
    assert_eq!(with_units(kinds.parameters()), ["payload kg", "slope m", "lift rad"]);
    let crawler = <Crawler<f64> as Described>::DESCRIPTION;
    let expected = [
        "knot[0] kg",
        "knot[1] kg",
        "knot[2] kg",
        "hull kg",
        "bend[0] 1",
        "bend[1] 1",
        "bend[2] 1",
    ];
    assert_eq!(with_units(crawler.parameters()), expected);
}

#[test]
fn connection_points_have_the_names_of_bodies() {
    let points = |chain: &'static mstmm::Description| {
        chain.points().iter().map(|point| point.name().to_string()).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(
        points(<FourBar<f64> as Described>::DESCRIPTION),
        "a.input crank.input crank.output coupler.input coupler.output rocker.input rocker.output d.output"
    );
    let rope = points(<Rope<f64> as Described>::DESCRIPTION);
    assert!(rope.starts_with("joint[0].input rod[0].input rod[0].output rod[1].input "), "{rope}");
    assert!(rope.ends_with("rod[99].output weight.input weight.output"), "{rope}");
    let tree = points(<Crawler<f64> as Described>::DESCRIPTION);
    for name in ["trunk.input", "trunk.left", "link[2].side", "rung[1].input", "left.thigh.output"]
    {
        assert!(tree.split(' ').any(|other| other == name), "{name} is none of {tree}");
    }
}

#[test]
fn chains_have_their_docs_and_answers() {
    let kinds = <Kinds<f32> as Described>::DESCRIPTION;
    assert_eq!(kinds.name(), "Kinds");
    assert_eq!(kinds.docs(), "Hinges of all kinds in space.\n\nThey begin at a moving frame.");
    assert!(kinds.answers_to("momentum") && kinds.answers_to("mass_matrix"));
    assert!(!kinds.answers_to("push"));
    assert!(<Rope<f64> as Described>::DESCRIPTION.answers().is_empty());
}

#[test]
fn elements_have_their_kinds_and_types() {
    let kinds = <Kinds<f64> as Described>::DESCRIPTION;
    let keywords: Vec<&str> = kinds.hinges().iter().map(|hinge| hinge.keyword()).collect();
    assert_eq!(
        keywords.join(" "),
        "floating slider cylindrical universal screw planar pin weld elastic ball floating"
    );
    let prescribed = kinds.hinges().iter().filter(|hinge| hinge.is_prescribed());
    assert_eq!(
        prescribed.map(|hinge| hinge.name().to_string()).collect::<Vec<_>>(),
        ["deck", "shaker"]
    );
    let tip = kinds.bodies().get(kinds.body("tip").expect("a body"));
    assert_eq!(tip.expect("a body").type_name(), "Cube");
    let crawler = <Crawler<f64> as Described>::DESCRIPTION;
    let springs: Vec<String> = crawler.springs().iter().map(|it| it.name().to_string()).collect();
    assert_eq!(springs, ["cord", "tie[0]", "tie[1]", "tie[2]"]);
}
