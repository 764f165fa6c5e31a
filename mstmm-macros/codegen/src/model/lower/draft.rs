//! A chain on its way from what was written to what was meant.

use super::body::BodyType;
use super::context::Given;
use super::hinge::Motion;
use super::properties;
use super::route::Stop;
use super::setting::Settings;
use crate::model::{Body, Chain, Element, Frame, Hinge, HingeKind, Parameter, Place};
use crate::syntax::ChainDef;

/// A chain as far as it could be read.
pub(crate) struct Draft<'a> {
    /// As written.
    pub def: &'a ChainDef,
    /// Settings of the whole chain.
    pub(super) settings: Settings,
    /// Numbers that may change at run time.
    pub parameters: Vec<Parameter>,
    /// How many Rust paths there are.
    pub constants: usize,
    /// All types of bodies.
    pub types: Vec<BodyType<'a>>,
    /// All stops of the route.
    pub stops: Vec<Stop<'a>>,
    /// How the stops move at first, one for each.
    pub motions: Vec<Option<Motion>>,
}

impl Draft<'_> {
    /// The defaults of the parameters, where they are known.
    pub fn defaults(&self) -> Vec<Option<f64>> {
        self.parameters.iter().map(|parameter| parameter.default.known()).collect()
    }

    /// The chain; nothing where a part is missing, which is reported then.
    pub fn finish(self) -> Option<Chain> {
        let mut chain = Chain {
            name: self.def.name.clone(),
            gravity: self.settings.gravity.clone()?,
            parameters: self.parameters.clone(),
            constants: self.constants,
            bodies: Vec::new(),
            hinges: Vec::new(),
            route: Vec::new(),
            method: self.settings.method,
        };
        chain.hinges.extend(self.implied_hinge());
        for (index, stop) in self.stops.iter().enumerate() {
            match stop {
                Stop::Ground { .. } => {}
                Stop::Hinge { name, frees, .. } => {
                    // As many bodies as there are so far: the next one has this index.
                    let next = chain.bodies.len();
                    let inboard = match self.stops.get(index.checked_sub(1)?)? {
                        Stop::Ground { frame, .. } => Place::Ground(frame.clone()?),
                        _ => Place::Output(next.checked_sub(1)?),
                    };
                    let outboard = match self.stops.get(index + 1)? {
                        Stop::Ground { frame, .. } => Place::Ground(frame.clone()?),
                        _ => Place::Input(next),
                    };
                    let Given { value: kind, .. } = frees.clone()?;
                    let Motion { start, start_rate, effort } = self.motions[index].clone()?;
                    let name = (*name)?.clone();
                    chain.route.push(Element::Hinge(chain.hinges.len()));
                    let hinge = Hinge { name, kind, inboard, outboard, start, start_rate, effort };
                    chain.hinges.push(hinge);
                }
                Stop::Body { .. } => {
                    chain.route.push(Element::Body(chain.bodies.len()));
                    chain.bodies.push(self.body(stop)?);
                }
                Stop::Unknown { .. } => return None,
            }
        }
        Some(chain)
    }

    /// The hinge by which a floating chain is free of the ground.
    fn implied_hinge(&self) -> Option<Hinge> {
        if !properties::floats(&self.stops) {
            return None;
        }
        let Motion { start, start_rate, effort } = self.motions.first()?.clone()?;
        Some(Hinge {
            name: self.stops.first()?.name()?.clone(),
            kind: HingeKind::Floating,
            inboard: Place::Ground(Frame::identity()),
            outboard: Place::Input(0),
            start,
            start_rate,
            effort,
        })
    }

    fn body(&self, stop: &Stop) -> Option<Body> {
        let Stop::Body { name, body_type, .. } = stop else { return None };
        let body_type = &self.types[(*body_type)?];
        Some(Body {
            name: name.clone(),
            type_name: body_type.name.clone(),
            mass: body_type.mass.clone()?.value,
            com: body_type.com.clone()?.value,
            inertia: body_type.inertia.clone()?.value,
            output: body_type.output.clone().map_or_else(Frame::identity, |given| given.value),
        })
    }
}
