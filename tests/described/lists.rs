//! Identities between lists, and with states.

use super::models::{Crawler, FourBar, Kinds, Raft, Rope, Train};
use mstmm::description::{Items, Quantities};
use mstmm::{ChainState, Described, Description};
use std::collections::HashSet;

/// Asserts that names are different, and that each leads back to its index.
fn round_trip(list: &str, names: Vec<String>, index: impl Fn(&str) -> Option<usize>) {
    let unique: HashSet<&String> = names.iter().collect();
    assert_eq!(unique.len(), names.len(), "{list}: {names:?}");
    for (at, name) in names.iter().enumerate() {
        assert_eq!(index(name), Some(at), "{list}: {name}");
        for wrong in [format!("{name}."), format!("{name}x"), name[1..].to_owned()] {
            assert_eq!(index(&wrong), None, "{list}: {wrong}");
        }
    }
}

fn of_quantities(list: &str, quantities: Quantities) {
    let names = quantities.iter().map(|quantity| quantity.name.to_string()).collect::<Vec<_>>();
    assert_eq!(names.len(), quantities.len());
    assert!(quantities.get(quantities.len()).is_none());
    round_trip(list, names, |name| quantities.index(name));
}

fn of_names<R>(
    list: &str,
    items: Items<R>,
    names: Vec<String>,
    index: impl Fn(&str) -> Option<usize>,
) {
    assert_eq!(names.len(), items.len());
    round_trip(list, names, index);
}

fn check<C: Described<Scalar = f64>>(chain: &C) {
    let it: &'static Description = C::DESCRIPTION;
    of_quantities("coordinates", it.coordinates());
    of_quantities("rates", it.rates());
    of_quantities("inputs", it.inputs());
    of_quantities("parameters", it.parameters());
    let hinges = it.hinges().iter().map(|item| item.name().to_string()).collect();
    of_names("hinges", it.hinges(), hinges, |name| it.hinge(name));
    let bodies = it.bodies().iter().map(|item| item.name().to_string()).collect();
    of_names("bodies", it.bodies(), bodies, |name| it.body(name));
    let springs = it.springs().iter().map(|item| item.name().to_string()).collect();
    of_names("springs", it.springs(), springs, |name| it.spring(name));
    let points = it.points().iter().map(|item| item.name().to_string()).collect();
    of_names("points", it.points(), points, |name| it.point(name));
    hinges_own_their_quantities(it);
    starts_are_those_of_states(chain);
}

/// The ranges of all hinges follow one another, and their quantities name the hinge.
fn hinges_own_their_quantities(it: &'static Description) {
    for (list, range) in [
        (it.coordinates(), Description::coordinates_of as fn(&_, _) -> _),
        (it.rates(), Description::rates_of),
    ] {
        let mut owners = Vec::new();
        for hinge in 0..it.hinges().len() {
            let range: Option<std::ops::Range<usize>> = range(it, hinge);
            owners.extend(range.expect("a hinge").map(|index| (index, hinge)));
        }
        owners.sort_unstable();
        let found = list.iter().enumerate().map(|(index, it)| (index, it.hinge.expect("a hinge")));
        assert_eq!(owners, found.collect::<Vec<_>>());
        for quantity in list.iter() {
            let hinge = it.hinges().get(quantity.hinge.expect("a hinge")).expect("a hinge");
            let (quantity, hinge) = (quantity.name.to_string(), hinge.name().to_string());
            assert!(quantity.starts_with(&format!("{hinge}.")), "{quantity} of {hinge}");
        }
    }
}

/// Starts are rounded once in the state, by the same formulas: a few units in the last place of numbers below ten.
fn starts_are_those_of_states<C: Described<Scalar = f64>>(chain: &C) {
    let it = C::DESCRIPTION;
    let state = chain.initial_state();
    assert_eq!(it.coordinates().len(), state.coordinates().len());
    assert_eq!(it.rates().len(), state.rates().len());
    let coordinates = it.coordinates().iter().zip(state.coordinates());
    for (quantity, value) in coordinates.chain(it.rates().iter().zip(state.rates())) {
        let start = quantity.start.expect("a known start");
        assert!((start - value).abs() < 1e-14, "{}: {start} is not {value}", quantity.name);
    }
}

#[test]
fn lists_lead_back_to_their_indices() {
    check(&Kinds::new());
    check(&Crawler::new());
    check(&Raft::new());
    check(&Train::new());
    check(&Rope::new());
    check(&FourBar::new());
}

#[test]
fn limits_are_those_of_the_description() {
    let it = <Kinds<f64> as Described>::DESCRIPTION;
    let limits = |name: &str| {
        let index = it.coordinate(name).expect("a coordinate");
        it.coordinates().get(index).expect("a coordinate").limits
    };
    assert_eq!(limits("a.position"), Some([-0.1, 0.4]));
    assert_eq!(limits("b.position"), None);
    let [low, high] = limits("b.angle").expect("limits");
    assert!((low + 90f64.to_radians()).abs() < 1e-15 && (high - 45f64.to_radians()).abs() < 1e-15);
    assert_eq!(limits("c.angles.x"), Some([-0.2, 0.2]));
    assert_eq!(limits("c.angles.y"), Some([-0.2, 0.2]));
    assert_eq!(limits("g.orientation.w"), None);
    let ball = it.hinges().get(it.hinge("g").expect("a hinge")).expect("a hinge");
    let angle = ball.angle_limit().expect("a limit");
    assert!((angle - 40f64.to_radians()).abs() < 1e-15);
    assert!(it.rates().iter().all(|rate| rate.limits.is_none()));
    let crawler = <Crawler<f64> as Described>::DESCRIPTION;
    let limited = crawler.coordinates().iter().filter(|it| it.limits.is_some());
    let names: Vec<String> = limited.map(|it| it.name.to_string()).collect();
    assert_eq!(names, ["left.knee.angle", "right.knee.angle"]);
}

#[test]
fn defaults_of_parameters_are_those_of_new_chains() {
    let (kinds, crawler) = (Kinds::<f64>::new(), Crawler::<f64>::new());
    let defaults = |it: &Description| {
        it.parameters().iter().map(|it| it.start.expect("a default")).collect::<Vec<_>>()
    };
    let set = kinds.parameters();
    assert_eq!(defaults(Kinds::<f64>::DESCRIPTION), [set.payload(), set.slope(), set.lift()]);
    assert_eq!(crawler.parameters().knot(), &[0.1; 3]);
    assert_eq!(defaults(Crawler::<f64>::DESCRIPTION)[..3], [0.1; 3]);
}

/// States that are set by index are read by the accessors that the names say.
#[test]
fn accessors_read_what_indices_set() {
    macro_rules! read {
        ($state:ident, $it:ident: $($name:literal $list:ident $of:ident = $value:expr;)*) => { $(
            let index = $it.$of($name).expect($name);
            assert_eq!($value, $state.$list()[index], $name);
        )* };
    }
    let (it, mut state) = (Kinds::<f64>::DESCRIPTION, Kinds::<f64>::new().initial_state());
    number(&mut state);
    read! { state, it:
        "a.position" coordinates coordinate = state.a().position();
        "a.velocity" rates rate = state.a().velocity();
        "b.angle" coordinates coordinate = state.b().angle();
        "c.angles.y" coordinates coordinate = state.c().angles().y;
        "c.rates.x" rates rate = state.c().rates().x;
        "d.angle" coordinates coordinate = state.d().angle();
        "e.position.y" coordinates coordinate = state.e().position().y;
        "e.rate" rates rate = state.e().rate();
        "f.displacement.z" coordinates coordinate = state.f().displacement().z;
        "f.angles.x" coordinates coordinate = state.f().angles().x;
        "f.rate.y" rates rate = state.f().rate().y;
        "g.orientation.w" coordinates coordinate = state.g().orientation().w;
        "g.orientation.z" coordinates coordinate = state.g().orientation().k;
        "h.position.x" coordinates coordinate = state.h().position().x;
        "h.orientation.y" coordinates coordinate = state.h().orientation().j;
        "h.velocity.z" rates rate = state.h().velocity().z;
        "h.rate.x" rates rate = state.h().rate().x;
    }
    let (it, mut state) = (Crawler::<f64>::DESCRIPTION, Crawler::<f64>::new().initial_state());
    number(&mut state);
    read! { state, it:
        "trunk.position.y" coordinates coordinate = state.trunk().position().y;
        "a[1].orientation.x" coordinates coordinate = state.a(1).expect("a").orientation().i;
        "a[2].rate.z" rates rate = state.a(2).expect("a").rate().z;
        "b[0].angle" coordinates coordinate = state.b(0).expect("b").angle();
        "b[2].rate" rates rate = state.b(2).expect("b").rate();
        "c.velocity" rates rate = state.c().velocity();
        "left.knee.angle" coordinates coordinate = state.left_knee().angle();
        "right.hip.rate" rates rate = state.right_hip().rate();
    }
    let (it, mut state) = (Raft::<f64>::DESCRIPTION, Raft::<f64>::new().initial_state());
    number(&mut state);
    read! { state, it:
        "first.position.x" coordinates coordinate = state.first().position().x;
        "first.rate" rates rate = state.first().rate();
        "a.displacement.y" coordinates coordinate = state.a().displacement().y;
        "a.angle" coordinates coordinate = state.a().angle();
    }
}

/// Numbers all coordinates and rates.
fn number(state: &mut impl ChainState<Scalar = f64>) {
    for (index, value) in state.coordinates_mut().iter_mut().enumerate() {
        *value = 1.0 + index as f64;
    }
    for (index, value) in state.rates_mut().iter_mut().enumerate() {
        *value = -1.0 - index as f64;
    }
}

/// The points of a workspace are those that the names say.
#[test]
fn points_are_in_the_order_of_workspaces() -> Result<(), mstmm::Error> {
    let (it, chain) = (Crawler::<f64>::DESCRIPTION, Crawler::<f64>::new());
    let mut at = chain.workspace();
    chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at)?;
    assert_eq!(at.points().len(), it.points().len());
    for (name, point) in [
        ("trunk.input", at.trunk().input()),
        ("trunk.right", at.trunk().right()),
        ("link[0].input", at.link(0).expect("a link").input()),
        ("link[1].side", at.link(1).expect("a link").side()),
        ("rung[2].input", at.rung(2).expect("a rung").input()),
        ("last.input", at.last().input()),
        ("left.thigh.output", at.left_thigh().output()),
        ("right.shank.input", at.right_shank().input()),
    ] {
        let found = at.points()[it.point(name).expect(name)];
        assert_eq!(found.position(), point.position(), "{name}");
        assert_eq!(found.force(), point.force(), "{name}");
    }
    Ok(())
}
