//! Random trees with a repeated part.

use crate::chain::{Body, Chain, Element, End};
use crate::hinge::HingeKind;
use crate::load::{BodyPoint, SpringEnd};
use crate::random::Random;
use crate::random_chain::{TRIES, bare_chain, random_body, random_ground, random_hinge};
use crate::random_forces::add_forces;
use crate::random_state::{closing_frame, has_states};
use crate::random_tree::{TreeRecipe, add_spring, place_of_spring, random_place};
use crate::recipe::{Ends, Recipe};
use crate::repeated::{LAST, Repeated};
use crate::route::{Place, Route};

/// Returns the text of a random tree with a repeated part, and the same tree written out, in which
/// the elements of the part have the number of the repetition after their names.
///
/// The number of bodies in the recipe is ignored. If the first route begins with a body, it must not
/// end with a hinge.
///
/// # Panics
///
/// Panics like [`crate::random_tree()`].
pub fn random_repeated_tree(
    random: &mut Random,
    name: &str,
    recipe: &TreeRecipe,
) -> (String, Chain) {
    let mut recipe = recipe.clone();
    let layout = recipe.chain.layout();
    recipe.chain.kinds.retain(|kind| kind.exists_in(layout));
    let found = (0..TRIES).find_map(|_| {
        let mut repeated = Growing::new(random, name, &recipe).repeated;
        add_forces(random, &mut repeated.tree, &recipe.chain);
        let mut unrolled = repeated.written_out();
        if recipe.chain.ends == Ends::HeldHeld {
            let finish = End::Held(closing_frame(random, &unrolled));
            repeated.tree.finish = finish;
            unrolled = repeated.written_out();
        }
        let moves = unrolled.dof_count() > unrolled.dimension.directions().len();
        let found = moves && has_states(random, &unrolled);
        found.then(|| (repeated.text(), unrolled))
    });
    found.unwrap_or_else(|| panic!("tree {name}: no tree like this has been found"))
}

/// A tree to which routes are added.
struct Growing<'a> {
    recipe: &'a TreeRecipe,
    repeated: Repeated,
    bodies: usize,
    hinges: usize,
    points: usize,
}

impl Growing<'_> {
    fn new<'a>(random: &mut Random, name: &str, recipe: &'a TreeRecipe) -> Growing<'a> {
        let sizes = [1 + random.below(2), 1 + random.below(2), random.below(3)];
        let bodies = sizes.iter().sum();
        let tree = bare_chain(random, name, &Recipe { bodies, ..recipe.chain.clone() });
        let hinges = tree.hinges().count();
        // The part begins with a hinge.
        let before = 2 * sizes[0] - usize::from(recipe.chain.ends.free_start());
        let main = before..before + 2 * sizes[1];
        let count = 1 + random.below(4);
        let repeated = Repeated { tree, main, branches: 0, count, seeds: Vec::new() };
        let mut growing = Growing { recipe, repeated, bodies, hinges, points: 0 };
        growing.free_closing_hinge();
        for _ in 0..random.below(3) {
            growing.add_branch(random);
        }
        for _ in 0..random.below(3) {
            growing.add_outside(random);
        }
        growing.add_springs(random);
        growing
    }

    /// Makes the last hinge of a closed route one that moves, so that it is the closing one.
    fn free_closing_hinge(&mut self) {
        if let Some(Element::Hinge(hinge)) = self.repeated.tree.elements.last_mut() {
            if hinge.kind == HingeKind::Weld {
                hinge.kind = HingeKind::of_base(self.recipe.chain.layout());
            }
        }
    }

    fn pairs(&mut self, random: &mut Random) -> Vec<Element> {
        let mut elements = Vec::new();
        for _ in 0..1 + random.below(2) {
            (self.bodies, self.hinges) = (self.bodies + 1, self.hinges + 1);
            let hinge = random_hinge(random, format!("j{}", self.hinges), &self.recipe.chain);
            let layout = self.recipe.chain.layout();
            elements.push(Element::Hinge(hinge));
            elements.push(Element::Body(random_body(random, format!("b{}", self.bodies), layout)));
        }
        elements
    }

    /// Returns a place on one of the bodies with this property, if there is one.
    fn place_on(
        &mut self,
        random: &mut Random,
        counts: impl Fn(&Repeated, &str) -> bool,
    ) -> Option<Place> {
        let bodies = self.repeated.tree.bodies().map(|body| body.name.clone());
        let names: Vec<String> = bodies.filter(|name| counts(&self.repeated, name)).collect();
        if names.is_empty() {
            return None;
        }
        let name = random.choose(&names).clone();
        self.points += 1;
        let (points, layout) = (self.points, self.recipe.chain.layout());
        Some(random_place(random, body_mut(&mut self.repeated.tree, &name), points, layout))
    }

    /// Returns a place that the previous repetition has, after [`LAST`], with a first value.
    fn last_place(&mut self, random: &mut Random) -> Option<Place> {
        let previous = self.place_on(random, |repeated, name| repeated.has_body(name))?;
        if !self.repeated.seeds.iter().any(|(known, _)| *known == previous) {
            let before: Vec<String> = self.repeated.tree.elements[..self.repeated.main.start]
                .iter()
                .filter_map(|element| match element {
                    Element::Body(body) => Some(body.name.clone()),
                    Element::Hinge(_) => None,
                })
                .collect();
            let first = self.place_on(random, |_, name| before.iter().any(|it| it == name))?;
            self.repeated.seeds.push((previous.clone(), first));
        }
        Some(Place { body: format!("{LAST}{}", previous.body), point: previous.point })
    }

    /// Adds a branch of the repeated part.
    fn add_branch(&mut self, random: &mut Random) {
        let place = match random.chance(0.3) {
            true => self.last_place(random),
            false => self.place_on(random, |repeated, name| repeated.has_body(name)),
        };
        let start = End::Place(place.expect("a body in front of the part and one in it"));
        let route = Route { start, elements: self.pairs(random), finish: End::Free };
        self.repeated.tree.later_routes.insert(self.repeated.branches, route);
        self.repeated.branches += 1;
    }

    /// Adds a route outside of the part.
    fn add_outside(&mut self, random: &mut Random) {
        let start = match random.chance(self.recipe.forest) {
            true => End::Held(random_ground(random, self.recipe.chain.layout())),
            false => End::Place(self.place_on(random, |_, _| true).expect("a body")),
        };
        let route = Route { start, elements: self.pairs(random), finish: End::Free };
        self.repeated.tree.later_routes.push(route);
    }

    /// Adds springs between bodies; one outside of the part cannot end in the part.
    fn add_springs(&mut self, random: &mut Random) {
        let names: Vec<String> =
            self.repeated.tree.bodies().map(|body| body.name.clone()).collect();
        for name in &names {
            if !random.chance(2.0 * self.recipe.springs_between) {
                continue;
            }
            let inside = self.repeated.has_body(name);
            let to = if inside && random.chance(0.5) {
                self.last_place(random).map(|Place { body, point }| {
                    let plain = body.trim_start_matches(LAST);
                    let at = self.body_point(plain, &point);
                    SpringEnd::Body { body, at }
                })
            } else {
                let other = random.choose(&names).clone();
                let allowed = other != *name && (inside || !self.repeated.has_body(&other));
                let at = place_of_spring(random);
                allowed.then_some(SpringEnd::Body { body: other, at })
            };
            if let Some(to) = to {
                add_spring(random, &mut self.repeated.tree, name, to);
            }
        }
    }

    fn body_point(&mut self, body: &str, point: &str) -> BodyPoint {
        let frame = body_mut(&mut self.repeated.tree, body).place(point).expect("a place");
        match point {
            "input" => BodyPoint::Input,
            "output" => BodyPoint::Output,
            name => BodyPoint::Named { name: name.to_owned(), position: frame.position },
        }
    }
}

fn body_mut<'a>(tree: &'a mut Chain, name: &str) -> &'a mut Body {
    let body = tree.all_elements_mut().find_map(|element| match element {
        Element::Body(body) if body.name == name => Some(body),
        _ => None,
    });
    body.expect("a body of this name")
}
