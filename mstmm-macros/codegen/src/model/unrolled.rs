//! A chain with its repeated parts written out.

use super::{Attachment, Body, BodyId, Chain, Element, Hinge, HingeId, Role};
use crate::ids::IdVec;
use std::ops::Range;

impl Chain {
    /// How many elements the route has with its repeated parts written out up to `most` times.
    pub fn elements(&self, most: usize) -> usize {
        let repeated = self.repeats.iter();
        let more = repeated.map(|repeat| repeat.route.len() * (repeat.count.min(most) - 1));
        self.route.len() + more.sum::<usize>()
    }

    /// Returns the same chain with up to `most` repetitions of each part written out. It has no
    /// loads and no springs, and its names are not unique.
    pub fn unrolled(&self, most: usize) -> Chain {
        let is_end = |&body: &BodyId| self.bodies[body].role == Role::MovingEnd;
        let ends: Vec<BodyId> = self.bodies.ids().into_iter().filter(is_end).collect();
        let implied = self.hinges.len() - self.repeats.len() * 2 - self.hinges_on_route();
        let order = self.order(most);
        let bodies_on_route =
            order.iter().filter(|element| matches!(element, Element::Body(_))).count();
        // Where a body of the route's own order goes: nothing is joined to an earlier one.
        let end = |body: BodyId| {
            let number = ends.iter().position(|&end| end == body)?;
            Some(BodyId(bodies_on_route + number))
        };
        let outer = |attachment: &Attachment, on: fn(BodyId) -> Attachment| match attachment.body()
        {
            None => attachment.clone(),
            Some(body) => {
                on(end(body).unwrap_or_else(|| bug!("a chain ends at a body on its route")))
            }
        };
        let mut hinges: IdVec<HingeId, Hinge> = self.hinges.iter().take(implied).cloned().collect();
        for hinge in &mut hinges {
            // Those move the ends, or the first body of a chain that floats.
            let body = hinge.outboard.body().and_then(end);
            hinge.outboard = Attachment::Input(body.unwrap_or(BodyId(0)));
        }
        let mut bodies: IdVec<BodyId, Body> = IdVec::new();
        let mut route = Vec::new();
        for (route_index, element) in order.iter().enumerate() {
            match *element {
                Element::Body(body) => {
                    route.push(Element::Body(bodies.push(self.bodies[body].clone())));
                }
                Element::Hinge(hinge) => {
                    let written = &self.hinges[hinge];
                    let inboard = if route_index == 0 {
                        outer(self.before_boundary(&written.inboard), Attachment::Output)
                    } else {
                        Attachment::Output(bodies.ids().last())
                    };
                    let outboard = if route_index + 1 == order.len() {
                        outer(&written.outboard, Attachment::Input)
                    } else {
                        Attachment::Input(BodyId(bodies.len()))
                    };
                    let hinge = Hinge { inboard, outboard, ..written.clone() };
                    route.push(Element::Hinge(hinges.push(hinge)));
                }
            }
        }
        bodies.extend(ends.iter().map(|&end| self.bodies[end].clone()));
        Chain {
            bodies,
            hinges,
            route,
            repeats: IdVec::new(),
            loads: IdVec::new(),
            springs: Vec::new(),
            ..self.clone()
        }
    }

    /// Returns the attachment inboard of the boundary at `attachment`, or `attachment` itself.
    pub fn before_boundary<'a>(&'a self, attachment: &'a Attachment) -> &'a Attachment {
        self.repeat_boundary(attachment)
            .map_or(attachment, |boundary| &self.hinges[self.weld_of(boundary)].inboard)
    }

    fn hinges_on_route(&self) -> usize {
        self.route.iter().filter(|element| matches!(element, Element::Hinge(_))).count()
    }

    /// The elements in a row.
    fn order(&self, most: usize) -> Vec<Element> {
        let mut order = Vec::new();
        let mut next = 0;
        for repeat in &self.repeats {
            let Range { start, end } = repeat.route.clone();
            order.extend(&self.route[next..start]);
            for _ in 0..repeat.count.min(most) {
                order.extend(&self.route[start..end]);
            }
            next = end;
        }
        order.extend(&self.route[next..]);
        order
    }
}
