//! Random trees with parts and repeated parts.

use crate::chain::{Chain, Dimension, Element, End, Gravity};
use crate::described::{
    Described, Instance, LAST, Part, Repeat, Routes, Scope, Step, Values, each_element,
};
use crate::hinge::HingeKind;
use crate::load::{BodyPoint, SpringEnd};
use crate::paths::body_mut;
use crate::random::Random;
use crate::random_chain::{TRIES, bare_chain, random_body, random_ground, random_hinge};
use crate::random_forces::add_forces;
use crate::random_state::{closing_frame, has_states};
use crate::random_tree::{TreeRecipe, add_spring, place_of_spring, random_place};
use crate::recipe::{Ends, Recipe};
use crate::route::Place;

/// Whether a random tree has parts, and whether it has repeated parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Features {
    /// Parts, also inside of parts and of repeated parts.
    pub parts: bool,
    /// Repeated parts, also inside of parts.
    pub repeats: bool,
}

/// Returns the text of a random tree with parts and repeated parts, and the same tree written out.
///
/// In the tree written out, names of elements are their paths joined by underscores, in a repeated
/// part with an underscore and the number of the repetition after them. The number of bodies in the
/// recipe is ignored. With repeated parts, a first route that begins with a body must not end with a
/// hinge.
///
/// # Panics
///
/// Panics like [`crate::random_tree()`].
pub fn random_described_tree(
    random: &mut Random,
    name: &str,
    recipe: &TreeRecipe,
    features: Features,
) -> (String, Chain) {
    let mut recipe = recipe.clone();
    let layout = recipe.chain.layout();
    recipe.chain.kinds.retain(|kind| kind.exists_in(layout));
    let found = (0..TRIES).find_map(|_| {
        let mut tree = Growing::new(random, name, &recipe, features).grown(random);
        let mut written = tree.written_out();
        if written.bodies().count() > LARGEST || !tree.sets_all_parts() {
            return None;
        }
        if recipe.chain.ends == Ends::HeldHeld {
            tree.chain.finish = End::Held(closing_frame(random, &written));
            written = tree.written_out();
        }
        let dof_count = if written.closed() { layout.directions().len() } else { 0 };
        let moves = written.elements.len() > 1 && written.dof_count() > dof_count;
        (moves && has_states(random, &written)).then(|| (tree.text(), written))
    });
    found.unwrap_or_else(|| panic!("tree {name}: no tree like this has been found"))
}

/// The largest number of bodies with all parts and repetitions written out.
const LARGEST: usize = 40;

/// The kinds of steps that may follow.
#[derive(Clone, Copy)]
struct Allowed {
    /// A repeated part, also inside of an instance.
    repeats: bool,
    /// Whether the steps begin with a hinge.
    hinge_first: bool,
    /// Whether the last step is a body, if that matters.
    to_body: Option<bool>,
    /// The smallest number of steps.
    length: usize,
}

/// A tree to which parts and routes are added.
struct Growing<'a> {
    recipe: &'a TreeRecipe,
    features: Features,
    tree: Described,
    bodies: usize,
    hinges: usize,
    instances: usize,
    points: usize,
}

impl Growing<'_> {
    fn new<'a>(
        random: &mut Random,
        name: &str,
        recipe: &'a TreeRecipe,
        features: Features,
    ) -> Growing<'a> {
        let chain = bare_chain(random, name, &Recipe { bodies: 1, ..recipe.chain.clone() });
        let tree = Described { chain, parts: Vec::new(), scope: Scope::default() };
        let (bodies, hinges, instances, points) = (0, 0, 0, 0);
        Growing { recipe, features, tree, bodies, hinges, instances, points }
    }

    fn grown(mut self, random: &mut Random) -> Described {
        for number in 0..if self.features.parts { 1 + random.below(3) } else { 0 } {
            let part = self.part(random, number);
            self.tree.parts.push(part);
        }
        let (start, ends) = (self.tree.chain.start.clone(), self.recipe.chain.ends);
        let allowed = Allowed {
            repeats: true,
            hinge_first: !ends.free_start(),
            to_body: Some(ends.free_finish()),
            length: 2 + random.below(4),
        };
        let steps = self.steps(random, allowed);
        let mut scope = Scope { routes: vec![(start, steps)], ..Scope::default() };
        self.free_closing_hinge(&mut scope.routes);
        for _ in 0..1 + random.below(3) {
            let start = match random.chance(self.recipe.forest) {
                true => End::Held(random_ground(random, self.recipe.chain.layout())),
                false => self.place(random, &mut scope.routes),
            };
            let length = 2 + random.below(3);
            let steps = self.steps(random, Allowed { repeats: true, ..branch(length) });
            scope.routes.push((start, steps));
        }
        self.add_seeds(random, &mut scope.routes);
        self.tree.chain.gravity = self.add_forces(random, &mut scope);
        self.add_springs(random, &mut scope);
        self.tree.scope = scope;
        self.tree
    }

    /// Makes the last hinge of a closed route one that moves, so that it is the closing one.
    fn free_closing_hinge(&mut self, routes: &mut Routes) {
        if let Some(Step::Element(Element::Hinge(hinge))) = routes[0].1.last_mut()
            && hinge.kind == HingeKind::Weld
        {
            hinge.kind = HingeKind::of_base(self.recipe.chain.layout());
        }
    }

    fn part(&mut self, random: &mut Random, number: usize) -> Part {
        let hinge_first = random.chance(0.7);
        let length = 1 + random.below(4);
        let allowed = Allowed { repeats: random.chance(0.5), hinge_first, to_body: None, length };
        let mut scope = Scope::default();
        scope.routes.push((End::Free, self.steps(random, allowed)));
        for _ in 0..random.below(3) {
            if self.tree.paths(&scope.routes).is_empty() {
                break;
            }
            let start = self.place(random, &mut scope.routes);
            let length = 2 + random.below(2);
            let steps = self.steps(random, Allowed { repeats: allowed.repeats, ..branch(length) });
            scope.routes.push((start, steps));
        }
        self.add_seeds(random, &mut scope.routes);
        let has_bodies = self.tree.elements_of(&scope).bodies().count() > 0;
        let is_line = self.recipe.chain.layout() == Dimension::Line;
        let side = has_bodies && !is_line && random.chance(0.6);
        let size = has_bodies && random.chance(0.6);
        self.add_forces(random, &mut scope);
        Part { name: format!("Limb{number}"), side, size, scope }
    }

    fn steps(&mut self, random: &mut Random, allowed: Allowed) -> Vec<Step> {
        let (mut steps, mut hinge_next) = (Vec::new(), allowed.hinge_first);
        while steps.len() < allowed.length || allowed.to_body.is_some_and(|body| body != hinge_next)
        {
            let parts = 0..self.tree.parts.len();
            let fitting: Vec<usize> = parts
                .filter(|part| {
                    let routes = &self.tree.parts[*part].scope.routes;
                    self.tree.ends(*part).0 == hinge_next
                        && (allowed.repeats || !self.tree.has_repeats(routes))
                })
                .collect();
            let repeats = self.features.repeats && allowed.repeats && hinge_next;
            if !fitting.is_empty() && random.chance(0.4) {
                let part = *random.choose(&fitting);
                steps.push(Step::Instance(self.instance(random, part)));
                hinge_next = self.tree.ends(part).1;
            } else if repeats && !steps.is_empty() && random.chance(0.4) {
                steps.push(Step::Repeat(self.repeat(random)));
            } else {
                steps.push(Step::Element(self.element(random, hinge_next)));
                hinge_next = !hinge_next;
            }
        }
        steps
    }

    fn repeat(&mut self, random: &mut Random) -> Repeat {
        let (count, length) = (1 + random.below(4), 2 + random.below(3));
        let mut routes = vec![(End::Free, self.steps(random, branch(length)))];
        let last_body = self.tree.last_path(&routes[0].1);
        for _ in 0..random.below(3) {
            let mut start = self.place(random, &mut routes);
            if let (End::Place(place), true) = (&mut start, random.chance(0.3)) {
                place.body.insert_str(0, LAST);
            }
            let length = 2 + random.below(2);
            routes.push((start, self.steps(random, branch(length))));
        }
        Repeat { last_body, count, seeds: Vec::new(), routes }
    }

    fn element(&mut self, random: &mut Random, is_hinge: bool) -> Element {
        if is_hinge {
            self.hinges += 1;
            Element::Hinge(random_hinge(random, format!("j{}", self.hinges), &self.recipe.chain))
        } else {
            self.bodies += 1;
            let layout = self.recipe.chain.layout();
            Element::Body(random_body(random, format!("b{}", self.bodies), layout))
        }
    }

    fn instance(&mut self, random: &mut Random, part: usize) -> Instance {
        self.instances += 1;
        let Part { name, side, size, .. } = &self.tree.parts[part];
        // Only the first instance of all has no name, so that no name is used twice.
        let has_name = self.instances > 1 || random.chance(0.5);
        let name = if has_name { format!("i{}", self.instances) } else { name.to_lowercase() };
        let drawn = (*random.choose(&[1.0, -1.0]), *random.choose(&[1.0, 2.0, 0.5]));
        let side = if *side { drawn.0 } else { 1.0 };
        let size = if *size { drawn.1 } else { 1.0 };
        Instance { part, name, has_name, values: Values { side, size } }
    }

    /// Returns a place on a body of these routes, which may be in an instance.
    fn place(&mut self, random: &mut Random, routes: &mut Routes) -> End {
        let (path, _) = random.choose(&self.tree.paths(routes)).clone();
        End::Place(self.place_on(random, routes, &path))
    }

    fn place_on(&mut self, random: &mut Random, routes: &mut Routes, path: &str) -> Place {
        self.points += 1;
        let (points, layout) = (self.points, self.recipe.chain.layout());
        let body = body_mut(&mut self.tree.parts, routes, path).expect("a body of this path");
        Place { body: path.to_owned(), ..random_place(random, body, points, layout) }
    }

    /// Gives the places of previous repetitions their first values, or takes those of the same
    /// repetition instead if there is no body before.
    fn add_seeds(&mut self, random: &mut Random, routes: &mut Routes) {
        let mut before: Vec<String> = Vec::new();
        for route in 0..routes.len() {
            for step in 0..routes[route].1.len() {
                if let Step::Repeat(repeat) = &mut routes[route].1[step] {
                    let mut used: Vec<Place> = Vec::new();
                    for (start, _) in &mut repeat.routes {
                        let End::Place(place) = start else { continue };
                        let Some(path) = place.body.strip_prefix(LAST) else { continue };
                        let path = path.to_owned();
                        if before.is_empty() {
                            place.body = path;
                        } else if !used.iter().any(|it| it.body == path && it.point == place.point)
                        {
                            used.push(Place { body: path, ..place.clone() });
                        }
                    }
                    for previous in used {
                        let path = random.choose(&before).clone();
                        let first = self.place_on(random, routes, &path);
                        if let Step::Repeat(repeat) = &mut routes[route].1[step] {
                            repeat.seeds.push((previous, first));
                        }
                    }
                }
                before.extend(self.tree.first_paths(&routes[route].1[step]));
            }
            // The further routes of instances follow the whole route.
            let done =
                self.tree.paths(&vec![routes[route].clone()]).into_iter().map(|(path, _)| path);
            before.extend(done);
        }
    }

    /// Adds passive elements and prescribed motions to the hinges of a scope, loads and springs to its
    /// bodies, and returns gravity.
    fn add_forces(&mut self, random: &mut Random, scope: &mut Scope) -> Gravity {
        let mut chain = self.tree.elements_of(scope);
        add_forces(random, &mut chain, &self.recipe.chain);
        let mut elements = chain.elements.into_iter();
        each_element(&mut scope.routes, &mut |element| {
            *element = elements.next().expect("as many elements");
        });
        (scope.loads, scope.springs) = (chain.loads, chain.springs);
        chain.gravity
    }

    /// Adds springs between bodies, also of instances.
    fn add_springs(&mut self, random: &mut Random, scope: &mut Scope) {
        let mut chain = self.tree.elements_of(scope);
        let paths = self.tree.paths(&scope.routes);
        for (path, repeat) in &paths {
            if !random.chance(self.recipe.springs_between) {
                continue;
            }
            let (other, other_repeat) = random.choose(&paths).clone();
            // A spring ends outside of repeated parts, or in its own.
            let allowed = other_repeat.is_none() || other_repeat == *repeat;
            if other == *path || !allowed {
                continue;
            }
            let seeds = match (&other_repeat, random.chance(0.5)) {
                (Some(last_body), true) => seeds_of(&scope.routes, last_body),
                _ => Vec::new(),
            };
            let to = match seeds.first() {
                Some((previous, _)) => {
                    let body = format!("{LAST}{}", previous.body);
                    SpringEnd::Body { body, at: body_point(&previous.point) }
                }
                None => SpringEnd::Body { body: other, at: place_of_spring(random) },
            };
            add_spring(random, &mut chain, path, to);
        }
        scope.springs = chain.springs;
    }
}

/// Returns what is allowed on a branch without repeated parts.
fn branch(length: usize) -> Allowed {
    Allowed { repeats: false, hinge_first: true, to_body: Some(true), length }
}

/// Returns the seeds of a repeated part of these routes.
fn seeds_of(routes: &Routes, last_body: &str) -> Vec<(Place, Place)> {
    let steps = routes.iter().flat_map(|(_, steps)| steps);
    let seeds = steps.filter_map(|step| match step {
        Step::Repeat(repeat) if repeat.last_body == last_body => Some(repeat.seeds.clone()),
        _ => None,
    });
    seeds.flatten().collect()
}

fn body_point(point: &str) -> BodyPoint {
    match point {
        "input" => BodyPoint::Input,
        "output" => BodyPoint::Output,
        // Its position is that on the body.
        name => BodyPoint::Named { name: name.to_owned(), position: [0.0; 3] },
    }
}
