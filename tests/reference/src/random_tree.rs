//! Random trees: chains of several routes.

use crate::chain::{Body, Chain, Dimension, Element, End, Frame, Gravity};
use crate::load::{BodyPoint, Spring, SpringEnd};
use crate::random::Random;
use crate::random_chain::{
    TRIES, bare_chain, finished, random_body, random_ground, random_hinge, random_offset,
    random_turn,
};
use crate::random_forces::random_actuator;
use crate::recipe::{Ends, HingeChoice, Recipe};
use crate::route::{NamedPoint, Place, Route};

/// The properties of a random tree.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeRecipe {
    /// The properties of the hinges and bodies, the ends of the first route, and the number of bodies
    /// in all routes.
    pub chain: Recipe,
    /// The number of bodies, counted from the last one, among which a route chooses its parent.
    pub spread: usize,
    /// The probability that a later route begins on the ground or at a moving frame.
    pub forest: f64,
    /// The probability of a spring from a body to another body, for each body.
    pub springs_between: f64,
}

impl TreeRecipe {
    /// Returns a tree of the given size in which everything may occur.
    pub fn rich(
        random: &mut Random,
        dimension: Dimension,
        bodies: usize,
        ends: Ends,
    ) -> TreeRecipe {
        TreeRecipe {
            chain: Recipe::rich(dimension, bodies, ends, &HingeChoice::ALL),
            spread: 1 + random.below(bodies),
            forest: 0.1,
            springs_between: 0.15,
        }
    }

    /// Returns any tree of up to `bodies` bodies, in which everything may occur. One of four trees is
    /// closed at its first route.
    pub fn any(random: &mut Random, bodies: usize) -> TreeRecipe {
        let Recipe { dimension, bodies, .. } = Recipe::any(random, bodies);
        let ends: &[Ends] = if random.chance(0.25) { &Ends::CLOSED } else { &Ends::OPEN };
        let ends = *random.choose(ends);
        TreeRecipe::rich(random, dimension, bodies, ends)
    }
}

/// Returns a tree made by a recipe. Names are those of [`crate::random_mechanism`]; points where
/// hinges begin are called `f1`, …, springs between bodies `c1`, …, and moving frames of later routes
/// `base1`, ….
///
/// # Panics
///
/// Panics like [`crate::random_mechanism`].
pub fn random_tree(random: &mut Random, name: &str, recipe: &TreeRecipe) -> Chain {
    let mut recipe = recipe.clone();
    let layout = recipe.chain.layout();
    recipe.chain.kinds.retain(|kind| kind.exists_in(layout));
    assert!(recipe.chain.bodies > 0 && !recipe.chain.kinds.is_empty(), "bodies and hinges");
    let chain = (0..TRIES).find_map(|_| {
        let mut chain = bare_tree(random, name, &recipe);
        add_springs_between(random, &mut chain, &recipe);
        finished(random, chain, &recipe.chain).filter(moves)
    });
    chain.unwrap_or_else(|| panic!("tree {name}: no tree like this has been found"))
}

/// Returns whether a chain has degrees of freedom, and its closed route more than loop constraints if
/// nothing drives it.
fn moves(chain: &Chain) -> bool {
    let hinges = |element: &Element| match element {
        Element::Hinge(hinge) => [hinge.dof_count(), usize::from(hinge.prescribed)],
        Element::Body(_) => [0, 0],
    };
    let counts = chain.elements.iter().map(hinges);
    let [free, prescribed] = counts.fold([0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]]);
    let moving = |end: &End| matches!(end, End::Moving { .. });
    let driven = prescribed > 0 || moving(&chain.start) || moving(&chain.finish);
    let closes = driven || free > chain.dimension.directions().len();
    chain.dof_count() > 0 && (!chain.closed() || closes)
}

/// Returns a tree with motors and gravity.
fn bare_tree(random: &mut Random, name: &str, recipe: &TreeRecipe) -> Chain {
    let bodies = recipe.chain.bodies;
    let first = 1 + random.below(bodies);
    let mut chain = bare_chain(random, name, &Recipe { bodies: first, ..recipe.chain.clone() });
    let (mut hinges, mut done) = (chain.hinges().count(), first);
    while done < bodies {
        let length = 1 + random.below((bodies - done).min(4));
        let start = random_start(random, &mut chain, recipe, done);
        let mut elements = Vec::new();
        for _ in 0..length {
            (hinges, done) = (hinges + 1, done + 1);
            elements.push(Element::Hinge(random_hinge(
                random,
                format!("j{hinges}"),
                &recipe.chain,
            )));
            let body = random_body(random, format!("b{done}"), recipe.chain.layout());
            elements.push(Element::Body(body));
        }
        chain.later_routes.push(Route { start, elements, finish: End::Free });
    }
    if random.chance(recipe.chain.gravity_inputs) {
        chain.gravity = Gravity::Input;
    }
    chain
}

/// Returns the start of a route; a new point is added to its body.
fn random_start(random: &mut Random, chain: &mut Chain, recipe: &TreeRecipe, bodies: usize) -> End {
    let layout = recipe.chain.layout();
    if random.chance(recipe.forest) {
        return if recipe.chain.flat || random.chance(0.6) {
            End::Held(random_ground(random, layout))
        } else {
            End::Moving { name: format!("base{}", chain.later_routes.len() + 1) }
        };
    }
    let parent = bodies - 1 - random.below(recipe.spread.min(bodies));
    let points: usize = chain.bodies().map(|body| body.points.len()).sum();
    let is_body = |element: &&mut Element| matches!(element, Element::Body(_));
    let Some(Element::Body(body)) = chain.all_elements_mut().filter(is_body).nth(parent) else {
        unreachable!("a parent among the bodies")
    };
    End::Place(random_place(random, body, points + 1, layout))
}

/// Returns a place of a body where a route can begin: its input, its output or a named point, which
/// may be new and then has the given number.
pub(crate) fn random_place(
    random: &mut Random,
    body: &mut Body,
    number: usize,
    layout: Dimension,
) -> Place {
    let point = match random.below(5) {
        0 => "input".to_owned(),
        1 | 2 => "output".to_owned(),
        3 if !body.points.is_empty() => random.choose(&body.points).name.clone(),
        _ => {
            let name = format!("f{number}");
            let position = random_offset(random, 1.2, layout);
            let frame = Frame { position, rpy_degrees: random_turn(random, layout) };
            body.points.push(NamedPoint { name: name.clone(), frame });
            name
        }
    };
    Place { body: body.name.clone(), point }
}

/// Adds springs between bodies.
fn add_springs_between(random: &mut Random, chain: &mut Chain, recipe: &TreeRecipe) {
    let names: Vec<String> = chain.bodies().map(|body| body.name.clone()).collect();
    for (number, body) in names.iter().enumerate() {
        if names.len() == 1 || !random.chance(recipe.springs_between) {
            continue;
        }
        let other = (number + 1 + random.below(names.len() - 1)) % names.len();
        let to = SpringEnd::Body { body: names[other].clone(), at: place_of_spring(random) };
        add_spring(random, chain, body, to);
    }
}

/// Adds a spring from a body to another end.
pub(crate) fn add_spring(random: &mut Random, chain: &mut Chain, body: &str, to: SpringEnd) {
    let at = match random.below(2) {
        0 => place_of_spring(random),
        _ => BodyPoint::At(random_offset(random, 1.0, chain.dimension)),
    };
    chain.springs.push(Spring {
        name: format!("c{}", chain.springs.len() + 1),
        body: body.to_owned(),
        at,
        to,
        stiffness: random.rounded(1.0, 40.0, 1),
        damping: if random.chance(0.5) { random.rounded(0.1, 3.0, 2) } else { 0.0 },
        length: if random.chance(0.5) { random.rounded(0.1, 1.5, 2) } else { 0.0 },
        force: random_actuator(&mut random.beside()),
    });
}

/// Returns an end of a spring that has a name.
pub(crate) fn place_of_spring(random: &mut Random) -> BodyPoint {
    match random.below(3) {
        0 => BodyPoint::Com,
        1 => BodyPoint::Input,
        _ => BodyPoint::Output,
    }
}
