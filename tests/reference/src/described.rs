//! Trees as texts describe them, with parts and repeated parts.

use crate::chain::{Chain, Element, End};
use crate::load::{Load, Spring};
use crate::route::Place;
use crate::text::Factors;

/// What precedes the path of a body of the previous repetition.
pub(crate) const LAST: &str = "last.";

/// A tree with parts and repeated parts.
pub(crate) struct Described {
    /// The name, the ends of the first route and gravity.
    pub(crate) chain: Chain,
    pub(crate) parts: Vec<Part>,
    /// The routes, and the loads and springs outside of parts.
    pub(crate) scope: Scope,
}

/// A part that can be set on routes.
pub(crate) struct Part {
    /// The CamelCase name.
    pub(crate) name: String,
    /// Whether the part has the parameter `side`, which is 1 or -1 and mirrors its bodies.
    pub(crate) side: bool,
    /// Whether the part has the parameter `size`, by which masses and inertias are multiplied.
    pub(crate) size: bool,
    pub(crate) scope: Scope,
}

/// Routes with loads and springs on their bodies.
#[derive(Clone, Default)]
pub(crate) struct Scope {
    /// The routes. The start of the first one is that of the chain; in a part it is not used.
    pub(crate) routes: Routes,
    pub(crate) loads: Vec<Load>,
    pub(crate) springs: Vec<Spring>,
}

/// Routes with their starts. Bodies are named by paths, such as `leg.knee.shank`.
pub(crate) type Routes = Vec<(End, Vec<Step>)>;

/// A step of a route.
#[derive(Clone)]
#[expect(clippy::large_enum_variant, reason = "trees have few elements")]
pub(crate) enum Step {
    Element(Element),
    Instance(Instance),
    Repeat(Repeat),
}

/// A part that is set on a route.
#[derive(Clone)]
pub(crate) struct Instance {
    /// The index of the part.
    pub(crate) part: usize,
    /// The name; that of the part in snake case if the text has none.
    pub(crate) name: String,
    pub(crate) has_name: bool,
    pub(crate) values: Values,
}

/// The arguments of an instance.
#[derive(Clone, Copy)]
pub(crate) struct Values {
    pub(crate) side: f64,
    pub(crate) size: f64,
}

/// A repeated part.
#[derive(Clone)]
pub(crate) struct Repeat {
    /// The name of its last body, which no other repeated part has.
    pub(crate) last_body: String,
    /// The number of repetitions.
    pub(crate) count: usize,
    /// The places of the previous repetition that are used, each with its first value.
    pub(crate) seeds: Vec<(Place, Place)>,
    /// The routes. The first begins at the end of the previous repetition.
    pub(crate) routes: Routes,
}

impl Described {
    /// Returns the text in the description language.
    pub(crate) fn text(&self) -> String {
        let finish = self.chain.end(&self.chain.finish);
        let routes = self.scope.routes.iter().enumerate().map(|(number, (start, steps))| {
            let finish = finish.clone().filter(|_| number == 0);
            let start = self.chain.end(start).into_iter();
            start.chain(self.steps(steps)).chain(finish).collect::<Vec<_>>().join(" -> ")
        });
        let text = self.elements_of(&self.scope).text_with_routes(None, routes);
        let head = text.find(';').expect("gravity") + 1;
        let parts: String = self.parts.iter().map(|part| self.part_text(part)).collect();
        format!("{}{parts}{}", &text[..head], &text[head..])
    }

    fn part_text(&self, part: &Part) -> String {
        let elements = self.elements_of(&part.scope);
        let names = [("side", part.side), ("size", part.size)];
        let names: Vec<&str> = names.into_iter().filter(|it| it.1).map(|it| it.0).collect();
        let factor = |has: bool, name: &str| if has { format!("{name}*") } else { String::new() };
        let factors = Factors { side: factor(part.side, "side"), size: factor(part.size, "size") };
        let mut lines = vec![format!("\n    part {}{} {{", part.name, in_parentheses(&names))];
        lines.extend(elements.bodies().map(|body| elements.body_type(body, &factors)));
        lines.extend(self.route_texts(&part.scope.routes).map(|route| format!("    {route};")));
        lines.extend(elements.blocks());
        lines.push("    }".to_owned());
        lines.join("\n")
    }

    /// Returns the routes of a part or a repeated part, of which the first has no start.
    fn route_texts(&self, routes: &Routes) -> impl Iterator<Item = String> {
        routes.iter().enumerate().map(|(number, (start, steps))| {
            let start = if number == 0 { None } else { self.chain.end(start) };
            start.into_iter().chain(self.steps(steps)).collect::<Vec<_>>().join(" -> ")
        })
    }

    fn steps(&self, steps: &[Step]) -> Vec<String> {
        let step = |step: &Step| match step {
            Step::Element(element) => self.chain.steps(std::slice::from_ref(element)).concat(),
            Step::Instance(Instance { part, name, has_name, values: Values { side, size } }) => {
                let part = &self.parts[*part];
                let numbers = [(*side, part.side), (*size, part.size)].into_iter();
                let numbers: Vec<String> =
                    numbers.filter(|it| it.1).map(|it| format!("{:?}", it.0)).collect();
                let name = if *has_name { format!(" {name}") } else { String::new() };
                format!("{}{}{name}", part.name, in_parentheses(&numbers))
            }
            Step::Repeat(Repeat { count, seeds, routes, .. }) => {
                let place = |Place { body, point }: &Place| format!("{body}.{point}");
                let seeds = seeds.iter();
                let seeds = seeds.map(|seed| format!("{} = {}", place(&seed.0), place(&seed.1)));
                let from = match seeds.collect::<Vec<_>>().join(", ") {
                    none if none.is_empty() => none,
                    seeds => format!(" from {seeds}"),
                };
                let routes = self.route_texts(routes).collect::<Vec<_>>().join("; ");
                format!("repeat {count}{from} {{ {routes} }}")
            }
        };
        steps.iter().map(step).collect()
    }

    /// Returns a chain of the elements that a scope has itself, with its loads and springs.
    pub(crate) fn elements_of(&self, scope: &Scope) -> Chain {
        let mut elements = Vec::new();
        each_element(&mut scope.routes.clone(), &mut |element| elements.push(element.clone()));
        let (loads, springs) = (scope.loads.clone(), scope.springs.clone());
        Chain { elements, loads, springs, ..self.chain.clone() }
    }

    /// Returns whether every part is set on a route.
    pub(crate) fn sets_all_parts(&self) -> bool {
        let scopes = self.parts.iter().map(|part| &part.scope).chain([&self.scope]);
        let set: Vec<usize> = scopes.flat_map(|scope| instances(&scope.routes)).collect();
        (0..self.parts.len()).all(|part| set.contains(&part))
    }
}

/// Applies a change to every element of routes, but not to those of their instances.
pub(crate) fn each_element(routes: &mut Routes, change: &mut dyn FnMut(&mut Element)) {
    for step in routes.iter_mut().flat_map(|(_, steps)| steps) {
        match step {
            Step::Element(element) => change(element),
            Step::Instance(_) => {}
            Step::Repeat(repeat) => each_element(&mut repeat.routes, change),
        }
    }
}

/// Returns the parts of all instances on routes.
fn instances(routes: &Routes) -> Vec<usize> {
    let steps = routes.iter().flat_map(|(_, steps)| steps);
    let of_step = |step: &Step| match step {
        Step::Element(_) => Vec::new(),
        Step::Instance(instance) => vec![instance.part],
        Step::Repeat(repeat) => instances(&repeat.routes),
    };
    steps.flat_map(of_step).collect()
}

/// Returns a list in parentheses, or nothing if it is empty.
fn in_parentheses<S: AsRef<str>>(list: &[S]) -> String {
    let list: Vec<&str> = list.iter().map(S::as_ref).collect();
    if list.is_empty() { String::new() } else { format!("({})", list.join(", ")) }
}
