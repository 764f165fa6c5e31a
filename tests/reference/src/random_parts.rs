//! Random trees of parts.

use crate::chain::{Body, Chain, Dimension, Element, End};
use crate::load::{Load, Spring, SpringEnd};
use crate::parts::{Instance, Part, PartTree, Step, Values, snake_case};
use crate::random::Random;
use crate::random_chain::{TRIES, bare_chain, random_body, random_ground, random_hinge};
use crate::random_forces::add_forces;
use crate::random_state::has_states;
use crate::random_tree::{TreeRecipe, add_spring, place_of_spring, random_place};
use crate::recipe::Recipe;

/// Returns the text of a random tree with parts, and the same tree written out, in which what belongs
/// to an instance has the name of the instance and an underscore before its name.
///
/// The number of bodies in the recipe is ignored. The first route must not end with a hinge.
///
/// # Panics
///
/// Panics like [`crate::random_tree()`].
pub fn random_part_tree(random: &mut Random, name: &str, recipe: &TreeRecipe) -> (String, Chain) {
    let mut recipe = recipe.clone();
    let layout = recipe.chain.layout();
    recipe.chain.kinds.retain(|kind| kind.exists_in(layout));
    let found = (0..TRIES).find_map(|_| {
        let tree = Growing::new(random, name, &recipe).grown(random);
        if !tree.sets_all_parts() {
            return None;
        }
        let written = tree.written_out();
        let found = written.dof_count() > 0 && has_states(random, &written);
        found.then(|| (tree.text(), written))
    });
    found.unwrap_or_else(|| panic!("tree {name}: no tree like this has been found"))
}

/// The routes of a part or of the tree, with the names that are used.
type Routes = Vec<(End, Vec<Step>)>;

/// A tree to which parts and routes are added.
struct Growing<'a> {
    recipe: &'a TreeRecipe,
    tree: PartTree,
    bodies: usize,
    hinges: usize,
    instances: usize,
    points: usize,
}

impl Growing<'_> {
    fn new<'a>(random: &mut Random, name: &str, recipe: &'a TreeRecipe) -> Growing<'a> {
        let chain = bare_chain(random, name, &Recipe { bodies: 1, ..recipe.chain.clone() });
        let tree = PartTree { chain, parts: Vec::new(), routes: Vec::new() };
        Growing { recipe, tree, bodies: 0, hinges: 0, instances: 0, points: 0 }
    }

    fn grown(mut self, random: &mut Random) -> PartTree {
        for number in 0..1 + random.below(3) {
            let part = self.part(random, number);
            self.tree.parts.push(part);
        }
        let (start, free) = (self.tree.chain.start.clone(), self.recipe.chain.ends.free_start());
        let length = 2 + random.below(4);
        let steps = self.steps(random, (!free, length, true));
        self.tree.routes.push((start, steps));
        let mut routes = std::mem::take(&mut self.tree.routes);
        for _ in 0..1 + random.below(3) {
            let start = match random.chance(self.recipe.forest) {
                true => End::Held(random_ground(random, self.recipe.chain.layout())),
                false => self.place(random, &mut routes),
            };
            let length = 2 + random.below(3);
            let steps = self.steps(random, (true, length, true));
            routes.push((start, steps));
        }
        let (loads, springs, gravity) = self.forces(random, &mut routes);
        self.tree.routes = routes;
        self.tree.chain.gravity = gravity;
        self.tree.chain.loads = loads;
        self.tree.chain.springs = springs;
        self.add_springs(random);
        self.tree
    }

    fn part(&mut self, random: &mut Random, number: usize) -> Part {
        let (hinge_first, length) = (random.chance(0.7), 1 + random.below(4));
        let steps = self.steps(random, (hinge_first, length, false));
        let mut routes = vec![(End::Free, steps)];
        for _ in 0..random.below(3) {
            if self.paths(&routes).is_empty() {
                break;
            }
            let start = self.place(random, &mut routes);
            let length = 2 + random.below(2);
            let steps = self.steps(random, (true, length, true));
            routes.push((start, steps));
        }
        let has_bodies = routes.iter().flat_map(|(_, steps)| steps).any(is_body);
        let plain = self.recipe.chain.layout() == Dimension::Line;
        let side = has_bodies && !plain && random.chance(0.6);
        let size = has_bodies && random.chance(0.6);
        let (loads, springs, _) = self.forces(random, &mut routes);
        Part { name: format!("Limb{number}"), side, size, routes, loads, springs }
    }

    /// Returns at least `length` steps that begin with a hinge or a body, and end with a body if they
    /// must.
    fn steps(
        &mut self,
        random: &mut Random,
        (hinge_first, length, to_body): (bool, usize, bool),
    ) -> Vec<Step> {
        let (mut steps, mut hinge_next) = (Vec::new(), hinge_first);
        while steps.len() < length || (to_body && !hinge_next) {
            let fitting: Vec<usize> = (0..self.tree.parts.len())
                .filter(|part| self.ends(*part).0 == hinge_next)
                .collect();
            if !fitting.is_empty() && random.chance(0.4) {
                let part = *random.choose(&fitting);
                let instance = self.instance(random, part);
                steps.push(Step::Instance(instance));
                hinge_next = self.ends(part).1;
            } else {
                steps.push(Step::Element(self.element(random, hinge_next)));
                hinge_next = !hinge_next;
            }
        }
        steps
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
        let plain = snake_case(&self.tree.parts[part].name);
        // A name without a number can be used once; the first instance of all may have it.
        let has_name = self.instances > 1 || random.chance(0.5);
        let name = if has_name { format!("i{}", self.instances) } else { plain };
        let side = *random.choose(&[1.0, -1.0]);
        let size = *random.choose(&[1.0, 2.0, 0.5]);
        let Part { side: has_side, size: has_size, .. } = self.tree.parts[part];
        let side = if has_side { side } else { 1.0 };
        let size = if has_size { size } else { 1.0 };
        Instance { part, name, has_name, values: Values { side, size } }
    }

    /// Returns whether the first route of a part begins with a hinge, and whether it ends with a body.
    fn ends(&self, part: usize) -> (bool, bool) {
        let (_, steps) = &self.tree.parts[part].routes[0];
        let begins = match steps.first().expect("a step") {
            Step::Element(element) => matches!(element, Element::Hinge(_)),
            Step::Instance(instance) => self.ends(instance.part).0,
        };
        let ends = match steps.last().expect("a step") {
            Step::Element(element) => matches!(element, Element::Body(_)),
            Step::Instance(instance) => self.ends(instance.part).1,
        };
        (begins, ends)
    }

    /// Returns the paths of all bodies on routes.
    fn paths(&self, routes: &Routes) -> Vec<String> {
        let of_step = |step: &Step| match step {
            Step::Element(Element::Body(body)) => vec![body.name.clone()],
            Step::Element(Element::Hinge(_)) => Vec::new(),
            Step::Instance(instance) => {
                let inner = self.paths(&self.tree.parts[instance.part].routes);
                inner.iter().map(|path| format!("{}.{path}", instance.name)).collect()
            }
        };
        routes.iter().flat_map(|(_, steps)| steps).flat_map(of_step).collect()
    }

    /// Returns a place on a body of these routes, which may be in an instance.
    fn place(&mut self, random: &mut Random, routes: &mut Routes) -> End {
        let path = random.choose(&self.paths(routes)).clone();
        self.points += 1;
        let (points, layout) = (self.points, self.recipe.chain.layout());
        let body = body_mut(&mut self.tree.parts, routes, &path).expect("a body of this path");
        End::Place(crate::route::Place {
            body: path.clone(),
            ..random_place(random, body, points, layout)
        })
    }

    /// Adds passive elements and prescribed motions to the hinges of these routes, and returns loads
    /// and springs on their bodies, and gravity.
    fn forces(
        &mut self,
        random: &mut Random,
        routes: &mut Routes,
    ) -> (Vec<Load>, Vec<Spring>, crate::chain::Gravity) {
        let mut scope = self.tree.scope(routes, &[], &[]);
        add_forces(random, &mut scope, &self.recipe.chain);
        let mut elements = scope.elements.into_iter();
        for step in routes.iter_mut().flat_map(|(_, steps)| steps) {
            if let Step::Element(element) = step {
                *element = elements.next().expect("as many elements");
            }
        }
        (scope.loads, scope.springs, scope.gravity)
    }

    /// Adds springs between bodies outside of parts or in instances.
    fn add_springs(&mut self, random: &mut Random) {
        let paths = self.paths(&self.tree.routes);
        for path in &paths {
            if !random.chance(self.recipe.springs_between) {
                continue;
            }
            let other = random.choose(&paths).clone();
            if other != *path {
                let to = SpringEnd::Body { body: other, at: place_of_spring(random) };
                add_spring(random, &mut self.tree.chain, path, to);
            }
        }
    }
}

fn is_body(step: &Step) -> bool {
    matches!(step, Step::Element(Element::Body(_)))
}

/// Returns the body of a path, which is that of the part for all its instances.
fn body_mut<'a>(parts: &'a mut [Part], routes: &'a mut Routes, path: &str) -> Option<&'a mut Body> {
    let (first, rest) = match path.split_once('.') {
        Some((instance, rest)) => (instance, Some(rest)),
        None => (path, None),
    };
    for step in routes.iter_mut().flat_map(|(_, steps)| steps) {
        match (step, rest) {
            (Step::Element(Element::Body(body)), None) if body.name == first => return Some(body),
            (Step::Instance(instance), Some(rest)) if instance.name == first => {
                let (inner, part) = parts[..=instance.part].split_at_mut(instance.part);
                return body_mut(inner, &mut part[0].routes, rest);
            }
            _ => {}
        }
    }
    None
}
