//! The bodies on the routes of a described tree, by their paths.

use crate::chain::{Body, Element};
use crate::described::{Described, Instance, Part, Routes, Step};

impl Described {
    /// Returns the path of the last body of steps that end with a body.
    pub(crate) fn last_path(&self, steps: &[Step]) -> String {
        match steps.last().expect("a step") {
            Step::Element(Element::Body(body)) => body.name.clone(),
            Step::Element(Element::Hinge(hinge)) => panic!("{} is the last step", hinge.name),
            Step::Instance(Instance { part, name, .. }) => {
                let inner = self.last_path(&self.parts[*part].scope.routes[0].1);
                format!("{name}.{inner}")
            }
            Step::Repeat(repeat) => repeat.last_body.clone(),
        }
    }

    /// Returns whether the first route of a part begins with a hinge, and whether it ends with a body.
    pub(crate) fn ends(&self, part: usize) -> (bool, bool) {
        let (_, steps) = &self.parts[part].scope.routes[0];
        let (first, last) = (steps.first().expect("a step"), steps.last().expect("a step"));
        let begins = match first {
            Step::Element(element) => matches!(element, Element::Hinge(_)),
            Step::Instance(instance) => self.ends(instance.part).0,
            Step::Repeat(_) => true,
        };
        let ends = match last {
            Step::Element(element) => matches!(element, Element::Body(_)),
            Step::Instance(instance) => self.ends(instance.part).1,
            Step::Repeat(_) => true,
        };
        (begins, ends)
    }

    /// Returns whether routes have repeated parts, also in instances.
    pub(crate) fn has_repeats(&self, routes: &Routes) -> bool {
        routes.iter().flat_map(|(_, steps)| steps).any(|step| match step {
            Step::Element(_) => false,
            Step::Instance(it) => self.has_repeats(&self.parts[it.part].scope.routes),
            Step::Repeat(_) => true,
        })
    }

    /// Returns the paths of all bodies on routes, each with the last body of its repeated part.
    pub(crate) fn paths(&self, routes: &Routes) -> Vec<(String, Option<String>)> {
        let of_step = |step: &Step| match step {
            Step::Element(Element::Body(body)) => vec![(body.name.clone(), None)],
            Step::Element(Element::Hinge(_)) => Vec::new(),
            Step::Instance(Instance { part, name, .. }) => {
                let inner = self.paths(&self.parts[*part].scope.routes).into_iter();
                let path = |path: String| format!("{name}.{path}");
                inner.map(|(body, repeat)| (path(body), repeat.map(path))).collect()
            }
            Step::Repeat(repeat) => {
                let inner = self.paths(&repeat.routes).into_iter();
                inner.map(|(body, _)| (body, Some(repeat.last_body.clone()))).collect()
            }
        };
        routes.iter().flat_map(|(_, steps)| steps).flat_map(of_step).collect()
    }

    /// Returns the paths of the bodies that a step has on its own route.
    pub(crate) fn first_paths(&self, step: &Step) -> Vec<String> {
        match step {
            Step::Element(Element::Body(body)) => vec![body.name.clone()],
            Step::Element(Element::Hinge(_)) => Vec::new(),
            Step::Instance(Instance { part, name, .. }) => {
                let steps = &self.parts[*part].scope.routes[0].1;
                let inner = steps.iter().flat_map(|step| self.first_paths(step));
                inner.map(|path| format!("{name}.{path}")).collect()
            }
            Step::Repeat(repeat) => {
                let inner = self.paths(&repeat.routes).into_iter();
                inner.map(|(path, _)| path).collect()
            }
        }
    }
}

/// Returns the body of a path, which is that of the part for all its instances.
pub(crate) fn body_mut<'a>(
    parts: &'a mut [Part],
    routes: &'a mut Routes,
    path: &str,
) -> Option<&'a mut Body> {
    let (first, rest) = match path.split_once('.') {
        Some((instance, rest)) => (instance, Some(rest)),
        None => (path, None),
    };
    for step in routes.iter_mut().flat_map(|(_, steps)| steps) {
        match (step, rest) {
            (Step::Element(Element::Body(body)), None) if body.name == first => return Some(body),
            (Step::Instance(instance), Some(rest)) if instance.name == first => {
                let (inner, part) = parts[..=instance.part].split_at_mut(instance.part);
                return body_mut(inner, &mut part[0].scope.routes, rest);
            }
            (Step::Repeat(repeat), _) if contains(&repeat.routes, first) => {
                return body_mut(parts, &mut repeat.routes, path);
            }
            _ => {}
        }
    }
    None
}

/// Returns whether a body or an instance with this name is on the routes.
fn contains(routes: &Routes, name: &str) -> bool {
    routes.iter().flat_map(|(_, steps)| steps).any(|step| match step {
        Step::Element(Element::Body(body)) => body.name == name,
        Step::Instance(instance) => instance.name == name,
        _ => false,
    })
}
