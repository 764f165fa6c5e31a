//! Trees with all parts and repetitions written out.

use crate::chain::{Body, Chain, Element, End};
use crate::described::{Described, Instance, LAST, Repeat, Routes, Scope, Step, Values};
use crate::load::{BodyPoint, Load, Spring, SpringEnd};
use crate::route::{Place, Route};

impl Described {
    /// Returns the tree written out. Names of elements are their paths joined by underscores, in a
    /// repeated part with an underscore and the number of the repetition after them.
    pub(crate) fn written_out(&self) -> Chain {
        let mut writer =
            Writer { tree: self, routes: Vec::new(), loads: Vec::new(), springs: Vec::new() };
        let context = Context {
            scope: &self.scope,
            prefix: String::new(),
            suffix: String::new(),
            values: Values { side: 1.0, size: 1.0 },
            repetition: None,
        };
        writer.add_blocks(&context);
        writer.add_routes(&context, &self.scope.routes, Some(&self.chain.finish));
        let Writer { mut routes, loads, springs, .. } = writer;
        let Route { elements, finish, .. } = routes.remove(0);
        Chain { elements, finish, later_routes: routes, loads, springs, ..self.chain.clone() }
    }
}

/// Where something is written: in the chain, in an instance or in a repetition.
#[derive(Clone)]
struct Context<'a> {
    scope: &'a Scope,
    /// The prefix of all names of the scope.
    prefix: String,
    /// The suffix of all names of the scope: the number of the repetition.
    suffix: String,
    values: Values,
    /// The repeated part of the scope, with the number of the repetition.
    repetition: Option<(&'a Repeat, usize)>,
}

struct Writer<'a> {
    tree: &'a Described,
    routes: Vec<Route>,
    loads: Vec<Load>,
    springs: Vec<Spring>,
}

impl<'a> Writer<'a> {
    /// Adds routes, each with the further routes of its instances. The first may have a finish.
    fn add_routes(&mut self, context: &Context<'a>, routes: &'a Routes, finish: Option<&End>) {
        for (number, route) in routes.iter().enumerate() {
            let finish = finish.filter(|_| number == 0).cloned();
            self.add_route(context, route, finish.unwrap_or(End::Free));
        }
    }

    /// Adds a route with the further routes of its instances.
    fn add_route(
        &mut self,
        context: &Context<'a>,
        (start, steps): &'a (End, Vec<Step>),
        finish: End,
    ) {
        let start = context.end(self.tree, start);
        let mut open = Route { start, elements: Vec::new(), finish: End::Free };
        let mut instances = Vec::new();
        self.add_steps(&mut open, &mut instances, context, steps);
        open.finish = finish;
        self.close(open);
        self.add_instances(instances);
    }

    fn close(&mut self, route: Route) {
        if !route.elements.is_empty() {
            self.routes.push(route);
        }
    }

    /// Adds the loads, springs and further routes of instances.
    fn add_instances(&mut self, instances: Vec<Context<'a>>) {
        for context in instances {
            self.add_blocks(&context);
            for route in &context.scope.routes[1..] {
                self.add_route(&context, route, End::Free);
            }
        }
    }

    /// Adds steps with the first routes of their instances to an open route, and returns the
    /// instances, inner ones first. After a repetition the route ends, and another one goes on.
    fn add_steps(
        &mut self,
        open: &mut Route,
        instances: &mut Vec<Context<'a>>,
        context: &Context<'a>,
        steps: &'a [Step],
    ) {
        for step in steps {
            match step {
                Step::Element(element) => open.elements.push(context.element(element)),
                Step::Instance(instance) => {
                    let inner = context.instance(self.tree, instance);
                    let steps = &inner.scope.routes[0].1;
                    self.add_steps(open, instances, &inner, steps);
                    instances.push(inner);
                }
                Step::Repeat(repeat) => {
                    for number in 0..repeat.count {
                        self.add_repetition(open, context, (repeat, number));
                    }
                }
            }
        }
    }

    fn add_repetition(
        &mut self,
        open: &mut Route,
        context: &Context<'a>,
        (repeat, number): (&'a Repeat, usize),
    ) {
        let suffix = format!("_{number}");
        let context = Context { suffix, repetition: Some((repeat, number)), ..context.clone() };
        let mut instances = Vec::new();
        self.add_steps(open, &mut instances, &context, &repeat.routes[0].1);
        let body = context.name(&repeat.last_body);
        let next = End::Place(Place { body, point: "output".to_owned() });
        let next = Route { start: next, elements: Vec::new(), finish: End::Free };
        self.close(std::mem::replace(open, next));
        self.add_instances(instances);
        for route in &repeat.routes[1..] {
            self.add_route(&context, route, End::Free);
        }
    }

    /// Adds the loads and springs of a scope.
    fn add_blocks(&mut self, context: &Context<'a>) {
        for load in &context.scope.loads {
            for context in context.repetitions(self.tree, &load.body) {
                let [name, body] = [&load.name, &load.body].map(|name| context.name(name));
                self.loads.push(Load { name, body, ..load.clone() });
            }
        }
        for spring in &context.scope.springs {
            for context in context.repetitions(self.tree, &spring.body) {
                let [name, body] = [&spring.name, &spring.body].map(|name| context.name(name));
                let to = context.spring_end(self.tree, &spring.to);
                self.springs.push(Spring { name, body, to, ..spring.clone() });
            }
        }
    }
}

impl<'a> Context<'a> {
    /// Returns the name of something whose path is written here.
    fn name(&self, path: &str) -> String {
        format!("{}{}{}", self.prefix, path.replace('.', "_"), self.suffix)
    }

    fn instance(&self, tree: &'a Described, instance: &Instance) -> Context<'a> {
        Context {
            scope: &tree.parts[instance.part].scope,
            prefix: format!("{}{}_", self.prefix, instance.name),
            values: instance.values,
            repetition: None,
            ..self.clone()
        }
    }

    fn element(&self, element: &Element) -> Element {
        match element {
            Element::Hinge(hinge) => {
                let mut hinge = hinge.clone();
                hinge.name = self.name(&hinge.name);
                Element::Hinge(hinge)
            }
            Element::Body(body) => {
                let mut body = scaled(body, self.values);
                body.name = self.name(&body.name);
                Element::Body(body)
            }
        }
    }

    fn end(&self, tree: &Described, end: &End) -> End {
        match end {
            End::Place(place) => End::Place(self.place(tree, place)),
            other => other.clone(),
        }
    }

    /// Returns a place that is written here.
    fn place(&self, tree: &Described, place: &Place) -> Place {
        let point = place.point.clone();
        if let Some(path) = place.body.strip_prefix(LAST) {
            let (repeat, number) = self.repetition.expect("a repeated part");
            if number > 0 {
                let suffix = format!("_{}", number - 1);
                return Place { body: Context { suffix, ..self.clone() }.name(path), point };
            }
            let is_it = |seed: &Place| seed.body == path && seed.point == point;
            let seed = repeat.seeds.iter().find(|(previous, _)| is_it(previous));
            return self.place(tree, &seed.expect("a first value").1);
        }
        let found = repeat_of(tree, &self.scope.routes, &place.body, None);
        let suffix = match (found, self.repetition) {
            // In a repetition, or outside of all repeated parts of the scope.
            (Some(found), Some((own, _))) if found.last_body == own.last_body => {
                self.suffix.clone()
            }
            (Some(found), _) => format!("_{}", found.count - 1),
            (None, Some(_)) => String::new(),
            (None, None) => self.suffix.clone(),
        };
        Place { body: Context { suffix, ..self.clone() }.name(&place.body), point }
    }

    /// Returns the contexts in which something on a body exists.
    fn repetitions(&self, tree: &'a Described, body: &str) -> Vec<Context<'a>> {
        let scope = self.scope;
        let Some(repeat) = repeat_of(tree, &scope.routes, body, None) else {
            return vec![self.clone()];
        };
        let repetition = |number: usize| Context {
            suffix: format!("_{number}"),
            repetition: Some((repeat, number)),
            ..self.clone()
        };
        (0..repeat.count).map(repetition).collect()
    }

    fn spring_end(&self, tree: &Described, to: &SpringEnd) -> SpringEnd {
        let SpringEnd::Body { body, at } = to else { return to.clone() };
        let point = match at {
            BodyPoint::Input => "input",
            BodyPoint::Output => "output",
            BodyPoint::Named { name, .. } => name,
            BodyPoint::Com | BodyPoint::At(_) => "",
        };
        let place = Place { body: body.clone(), point: point.to_owned() };
        let Place { body, point } = self.place(tree, &place);
        let at = match point.as_str() {
            "input" => BodyPoint::Input,
            "output" => BodyPoint::Output,
            "" => at.clone(),
            // Its position is that on the body.
            name => BodyPoint::Named { name: name.to_owned(), position: [0.0; 3] },
        };
        SpringEnd::Body { body, at }
    }
}

/// Returns the repeated part that a body belongs to, given by its path.
fn repeat_of<'a>(
    tree: &'a Described,
    routes: &'a Routes,
    path: &str,
    around: Option<&'a Repeat>,
) -> Option<&'a Repeat> {
    let (first, rest) = match path.split_once('.') {
        Some((instance, rest)) => (instance, Some(rest)),
        None => (path, None),
    };
    routes.iter().flat_map(|(_, steps)| steps).find_map(|step| match (step, rest) {
        (Step::Element(Element::Body(body)), None) if body.name == first => around,
        (Step::Instance(instance), Some(rest)) if instance.name == first => {
            repeat_of(tree, &tree.parts[instance.part].scope.routes, rest, around)
        }
        (Step::Repeat(repeat), _) => repeat_of(tree, &repeat.routes, path, Some(repeat)),
        _ => None,
    })
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
