//! Trees of parts: their text, and the same trees written out.

use crate::chain::{Body, Chain, Element, End};
use crate::load::{Load, Spring, SpringEnd};
use crate::route::{Place, Route};
use crate::text::{Factors, camel_case};

/// A tree of which some pieces are parts.
pub(crate) struct PartTree {
    /// The ends of the first route, gravity, and the loads and springs outside of parts.
    pub(crate) chain: Chain,
    pub(crate) parts: Vec<Part>,
    /// The routes with their starts; the first has the ends of the chain.
    pub(crate) routes: Vec<(End, Vec<Step>)>,
}

/// A part.
pub(crate) struct Part {
    /// The CamelCase name.
    pub(crate) name: String,
    /// Whether the part has the parameter `side`, which is 1 or -1 and mirrors its bodies.
    pub(crate) side: bool,
    /// Whether the part has the parameter `size`, by which masses and inertias are multiplied.
    pub(crate) size: bool,
    /// The routes; the start of the first means nothing.
    pub(crate) routes: Vec<(End, Vec<Step>)>,
    /// The loads and springs on its bodies.
    pub(crate) loads: Vec<Load>,
    pub(crate) springs: Vec<Spring>,
}

/// A step of a route.
#[derive(Clone)]
#[expect(clippy::large_enum_variant, reason = "trees have few elements")]
pub(crate) enum Step {
    Element(Element),
    Instance(Instance),
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

impl PartTree {
    /// Returns the text in the description language.
    pub(crate) fn text(&self) -> String {
        let routes = self.routes.iter().enumerate().map(|(number, (start, steps))| {
            let finish = if number == 0 { &self.chain.finish } else { &End::Free };
            let ends = [self.chain.end(start), self.chain.end(finish)].map(Option::into_iter);
            let [start, finish] = ends;
            start.chain(self.steps(steps)).chain(finish).collect::<Vec<_>>().join(" -> ")
        });
        let own = self.scope(&self.routes, &self.chain.loads, &self.chain.springs);
        let text = own.text_with_routes(None, routes);
        let head = text.find(';').expect("gravity") + 1;
        let parts: String = self.parts.iter().map(|part| self.part_text(part)).collect();
        format!("{}{parts}{}", &text[..head], &text[head..])
    }

    fn part_text(&self, part: &Part) -> String {
        let scope = self.scope(&part.routes, &part.loads, &part.springs);
        let names = [("side", part.side), ("size", part.size)];
        let names: Vec<&str> = names.into_iter().filter(|it| it.1).map(|it| it.0).collect();
        let parameters = match names[..] {
            [] => String::new(),
            _ => format!("({})", names.join(", ")),
        };
        let factor = |has: bool, name: &str| if has { format!("{name}*") } else { String::new() };
        let factors = Factors { side: factor(part.side, "side"), size: factor(part.size, "size") };
        let mut lines = vec![format!("\n    part {}{parameters} {{", part.name)];
        lines.extend(scope.bodies().map(|body| scope.body_type(body, &factors)));
        for (number, (start, steps)) in part.routes.iter().enumerate() {
            let start = if number == 0 { None } else { self.chain.end(start) };
            let steps: Vec<String> = start.into_iter().chain(self.steps(steps)).collect();
            lines.push(format!("    {};", steps.join(" -> ")));
        }
        lines.extend(scope.blocks());
        lines.push("    }".to_owned());
        lines.join("\n")
    }

    fn steps(&self, steps: &[Step]) -> Vec<String> {
        let step = |step: &Step| match step {
            Step::Element(element) => self.chain.steps(std::slice::from_ref(element)).concat(),
            Step::Instance(Instance { part, name, has_name, values: Values { side, size } }) => {
                let part = &self.parts[*part];
                let numbers = [(*side, part.side), (*size, part.size)];
                let numbers = numbers.into_iter().filter(|it| it.1);
                let numbers: Vec<String> = numbers.map(|it| format!("{:?}", it.0)).collect();
                let arguments = match numbers[..] {
                    [] => String::new(),
                    _ => format!("({})", numbers.join(", ")),
                };
                let name = if *has_name { format!(" {name}") } else { String::new() };
                format!("{}{arguments}{name}", part.name)
            }
        };
        steps.iter().map(step).collect()
    }

    /// Returns a chain of the elements that a scope has itself, with its loads and springs.
    pub(crate) fn scope(
        &self,
        routes: &[(End, Vec<Step>)],
        loads: &[Load],
        springs: &[Spring],
    ) -> Chain {
        let steps = routes.iter().flat_map(|(_, steps)| steps);
        let elements = steps.filter_map(|step| match step {
            Step::Element(element) => Some(element.clone()),
            Step::Instance(_) => None,
        });
        let (loads, springs) = (loads.to_vec(), springs.to_vec());
        Chain { elements: elements.collect(), loads, springs, ..self.chain.clone() }
    }

    /// Returns whether every part is set on a route.
    pub(crate) fn sets_all_parts(&self) -> bool {
        let routes = self.parts.iter().flat_map(|part| &part.routes).chain(&self.routes);
        let steps = routes.flat_map(|(_, steps)| steps);
        let set: Vec<usize> = steps
            .filter_map(|step| match step {
                Step::Element(_) => None,
                Step::Instance(instance) => Some(instance.part),
            })
            .collect();
        (0..self.parts.len()).all(|part| set.contains(&part))
    }

    /// Returns the tree written out: what belongs to an instance has the name of the instance and an
    /// underscore before its name.
    pub(crate) fn written_out(&self) -> Chain {
        let chain = &self.chain;
        let mut out = Chain {
            elements: Vec::new(),
            later_routes: Vec::new(),
            loads: Vec::new(),
            springs: Vec::new(),
            ..chain.clone()
        };
        self.add_blocks(&mut out, "", &chain.loads, &chain.springs);
        let identity = Values { side: 1.0, size: 1.0 };
        for (start, steps) in &self.routes {
            self.add_route(&mut out, "", start, (steps, identity));
        }
        // The first route has the start of the chain.
        let first = out.later_routes.remove(0);
        Chain { elements: first.elements, ..out }
    }

    /// Adds a route, and then the further routes of its parts.
    fn add_route(
        &self,
        out: &mut Chain,
        prefix: &str,
        start: &End,
        (steps, values): (&[Step], Values),
    ) {
        let start = match start {
            End::Place(Place { body, point }) => {
                End::Place(Place { body: joined(prefix, body), point: point.clone() })
            }
            other => other.clone(),
        };
        let (mut elements, mut instances) = (Vec::new(), Vec::new());
        self.add_steps(&mut elements, &mut instances, prefix, (steps, values));
        out.later_routes.push(Route { start, elements, finish: End::Free });
        for (prefix, Instance { part, values, .. }) in instances {
            let part = &self.parts[part];
            self.add_blocks(out, &prefix, &part.loads, &part.springs);
            for (start, steps) in &part.routes[1..] {
                self.add_route(out, &prefix, start, (steps, values));
            }
        }
    }

    /// Adds steps with the first routes of their parts, and returns the instances, inner ones first.
    fn add_steps(
        &self,
        elements: &mut Vec<Element>,
        instances: &mut Vec<(String, Instance)>,
        prefix: &str,
        (steps, values): (&[Step], Values),
    ) {
        for step in steps {
            match step {
                Step::Element(element) => elements.push(named(element, prefix, values)),
                Step::Instance(instance) => {
                    let prefix = format!("{prefix}{}_", instance.name);
                    let (_, steps) = &self.parts[instance.part].routes[0];
                    self.add_steps(elements, instances, &prefix, (steps, instance.values));
                    instances.push((prefix, instance.clone()));
                }
            }
        }
    }

    fn add_blocks(&self, out: &mut Chain, prefix: &str, loads: &[Load], springs: &[Spring]) {
        out.loads.extend(loads.iter().map(|load| Load {
            name: joined(prefix, &load.name),
            body: joined(prefix, &load.body),
            ..load.clone()
        }));
        out.springs.extend(springs.iter().map(|spring| Spring {
            name: joined(prefix, &spring.name),
            body: joined(prefix, &spring.body),
            to: match &spring.to {
                SpringEnd::Ground(position) => SpringEnd::Ground(*position),
                SpringEnd::Body { body, at } => {
                    SpringEnd::Body { body: joined(prefix, body), at: at.clone() }
                }
            },
            ..spring.clone()
        }));
    }
}

/// Returns a path in the scope of an instance, joined by underscores.
fn joined(prefix: &str, path: &str) -> String {
    format!("{prefix}{}", path.replace('.', "_"))
}

/// Returns an element of an instance.
fn named(element: &Element, prefix: &str, values: Values) -> Element {
    match element {
        Element::Hinge(hinge) => {
            let mut hinge = hinge.clone();
            hinge.name = joined(prefix, &hinge.name);
            Element::Hinge(hinge)
        }
        Element::Body(body) => {
            let mut body = scaled(body, values);
            body.name = joined(prefix, &body.name);
            Element::Body(body)
        }
    }
}

/// Returns a body with the factors of an instance.
fn scaled(body: &Body, Values { side, size }: Values) -> Body {
    let mut body = body.clone();
    let [xx, yy, zz, xy, xz, yz] = body.inertia;
    body.mass *= size;
    body.inertia = [xx, yy, zz, side * xy, xz, side * yz].map(|entry| size * entry);
    body.com[1] *= side;
    body.output.position[1] *= side;
    body.points.iter_mut().for_each(|point| point.frame.position[1] *= side);
    body
}

/// Returns the name of an instance without a name.
pub(crate) fn snake_case(name: &str) -> String {
    debug_assert_eq!(name, camel_case(&name.to_lowercase()));
    name.to_lowercase()
}
