//! Random trees.

use crate::loads::ends_of;
use crate::samples::{Case, assert_close};
use mstmm_reference::{
    Dimension, End, Ends, Random, SpringEnd, TreeRecipe, random_motion, random_tree,
};

/// Returns random trees of all dimensions and ends.
pub(crate) fn trees() -> impl Iterator<Item = Case> {
    let dimensions = [Dimension::Space, Dimension::Space, Dimension::Plane, Dimension::Line];
    (0..60).map(move |seed| {
        let mut random = Random::new(1000 + seed);
        let dimension = dimensions[seed as usize % dimensions.len()];
        let ends = Ends::ALL[seed as usize % Ends::ALL.len()];
        let bodies = 2 + random.below(if ends.closed() { 6 } else { 9 });
        let recipe = TreeRecipe::rich(&mut random, dimension, bodies, ends);
        tree(&mut random, &format!("Tree{seed}{dimension:?}{ends:?}"), &recipe)
    })
}

/// Returns trees in space of forty bodies.
pub(crate) fn large_trees() -> impl Iterator<Item = Case> {
    [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld].into_iter().map(|ends| {
        let mut random = Random::new(7);
        let recipe = TreeRecipe::rich(&mut random, Dimension::Space, 40, ends);
        tree(&mut random, &format!("Large{ends:?}"), &recipe)
    })
}

fn tree(random: &mut Random, name: &str, recipe: &TreeRecipe) -> Case {
    let chain = random_tree(random, name, recipe);
    let (state, drives) = random_motion(random, &chain);
    Case { chain, state, drives }
}

/// Springs report what their two ends give.
#[test]
fn springs_have_the_lengths_between_their_ends() {
    let mut between = 0;
    for case in trees() {
        let solution = case.solve();
        assert_eq!(solution.springs.len(), case.chain.springs.len());
        let springs = case.chain.springs.iter().zip(&case.drives.springs);
        for ((spring, &input), found) in springs.zip(&solution.springs) {
            let [[here, velocity], [there, other]] = ends_of(&case, &solution, spring);
            let length = (here - there).norm();
            let rate = (here - there).dot(&(velocity - other)) / length;
            let elastic = spring.stiffness * (length - spring.length);
            let tension = elastic + spring.damping * rate - spring.actuator(input);
            let force = (there - here) * (tension / length);
            for (found, expected) in [
                (found.length, length),
                (found.length_rate, rate),
                (found.tension, tension),
                (found.force[0], force.x),
                (found.force[1], force.y),
                (found.force[2], force.z),
            ] {
                assert_close(found, expected, 1e-12, &spring.name);
            }
            between += usize::from(matches!(spring.to, SpringEnd::Body { .. }));
        }
    }
    assert!(between > 20, "{between} springs between bodies");
}

/// Random trees have everything that trees may have.
#[test]
fn random_trees_are_rich() {
    let cases: Vec<Case> = trees().collect();
    let starts = || cases.iter().flat_map(|case| &case.chain.later_routes).map(|it| &it.start);
    let places = |wanted: &dyn Fn(&str) -> bool| {
        starts().filter(|end| matches!(end, End::Place(place) if wanted(&place.point))).count()
    };
    assert!(places(&|point| point == "input") > 5);
    assert!(places(&|point| point == "output") > 5);
    assert!(places(&|point| point.starts_with('f')) > 5);
    assert!(starts().any(|end| matches!(end, End::Held(_))));
    assert!(starts().any(|end| matches!(end, End::Moving { .. })));
    let points = || cases.iter().flat_map(|case| case.chain.bodies()).flat_map(|it| &it.points);
    assert!(points().any(|point| point.frame.rpy_degrees != [0.0; 3]));
    let shared = |case: &Case| {
        let routes = &case.chain.later_routes;
        let start = |k: usize| &routes[k].start;
        (0..routes.len()).any(|k| (0..k).any(|before| start(before) == start(k)))
    };
    assert!(cases.iter().any(shared));
    assert!(cases.iter().any(|case| case.chain.closed() && !case.chain.later_routes.is_empty()));
}
