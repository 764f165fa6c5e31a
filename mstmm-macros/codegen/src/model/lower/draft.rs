//! The draft of a chain: the result of the lowering before the checks.

use proc_macro2::Ident;

use super::body::{BodyType, PointDraft};
use super::context::Spanned;
use super::hinge::{HingeProperties, of_everything};
use super::load::{LoadDraft, SpringDraft};
use super::numbering::Numbering;
use super::properties::{self, ItemProperties};
use super::route::RouteItem;
use super::setting::Settings;
use super::vector::zeros;
use crate::ids::IdVec;
use crate::model::condition::Requirement;
use crate::model::{
    About, Attachment, Body, BodyId, Chain, Dimension, Drive, Element, Frame, Hinge, HingeId,
    HingeKind, Inertia, Parameter, PresentPoints, Repeat, RepeatId, Role, Value,
};
use crate::syntax::{self, ChainSyntax};

/// A chain, as far as it is readable.
pub(crate) struct Draft<'a> {
    /// As written.
    pub def: &'a ChainSyntax,
    /// The dimension of the space that it moves in.
    pub space: Dimension,
    /// Requirements on its values, from reading them.
    pub requirements: Vec<Requirement>,
    /// Settings of the whole chain.
    pub settings: Settings,
    /// Parameters: values that may change at run time.
    pub parameters: Vec<Parameter>,
    /// The number of Rust constants.
    pub constants: usize,
    /// All body types.
    pub types: Vec<BodyType<'a>>,
    /// All items of the route.
    pub items: Vec<RouteItem<'a>>,
    /// The properties of the items, one for each.
    pub properties: Vec<ItemProperties<'a>>,
    /// All loads.
    pub loads: Vec<LoadDraft<'a>>,
    /// All springs to the ground.
    pub springs: Vec<SpringDraft<'a>>,
}

impl Draft<'_> {
    /// The defaults of the parameters, where they are known.
    pub fn defaults(&self) -> Vec<Option<f64>> {
        self.parameters.iter().map(|parameter| parameter.default.known()).collect()
    }

    /// Returns the chain; `None` if a part is missing, which is reported then.
    pub fn finish(self) -> Option<Chain> {
        let numbers = Numbering::of(&self.items);
        let mut bodies: IdVec<BodyId, Body> = IdVec::new();
        let mut hinges = self.implied_hinges(&numbers)?;
        let mut elements = Vec::new();
        for (index, item) in self.items.iter().enumerate() {
            match item {
                RouteItem::Ground { .. } | RouteItem::Moving { .. } => {}
                RouteItem::Hinge { .. } => {
                    elements.push(Element::Hinge(hinges.push(self.hinge(index, &numbers)?)));
                }
                RouteItem::Body { .. } => {
                    elements.push(Element::Body(bodies.push(self.body(item)?)));
                }
                RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => return None,
            }
        }
        let ends = self.items.iter().filter(|item| matches!(item, RouteItem::Moving { .. }));
        for end in ends {
            bodies.push(end_body(end.name()?));
        }
        Some(Chain {
            name: self.def.name.clone(),
            dimension: self.space,
            gravity: self.settings.gravity.clone()?,
            parameters: self.parameters.clone(),
            constants: self.constants,
            bodies,
            hinges,
            elements,
            repeats: self.repeats(&numbers)?,
            loads: self.loads.into_iter().map(LoadDraft::finish).collect::<Option<_>>()?,
            springs: self.springs.into_iter().map(SpringDraft::finish).collect::<Option<_>>()?,
            method: self.settings.method,
            results: self.settings.results,
            answers: self.settings.answers,
            assertions: Vec::new(),
        })
    }

    /// Returns the hinges that are not on the route, all from the ground to the input of a body:
    /// the floating base, or the prescribed hinges of moving ends.
    fn implied_hinges(&self, numbers: &Numbering) -> Option<IdVec<HingeId, Hinge>> {
        let kind = || of_everything(self.space);
        let implied = |name: &Ident, body: BodyId, motion: HingeProperties| {
            let inboard = Attachment::Ground(Frame::identity());
            hinge(name.clone(), kind(), [inboard, Attachment::Input(body)], motion)
        };
        if properties::floats(&self.items) {
            let motion = self.properties.first()?.motion.clone()?;
            return Some(vec![implied(self.items.first()?.name()?, BodyId(0), motion)].into());
        }
        let ends = self.items.iter().enumerate();
        let ends = ends.filter(|(_, item)| matches!(item, RouteItem::Moving { .. }));
        let end = |(index, item): (usize, &RouteItem)| {
            let motion = HingeProperties {
                drive: Drive::Prescribed,
                ..HingeProperties::none(kind().spec())
            };
            Some(implied(item.name()?, numbers.body(index), motion))
        };
        ends.map(end).collect()
    }

    /// The hinge at this stop.
    fn hinge(&self, index: usize, numbers: &Numbering) -> Option<Hinge> {
        let RouteItem::Hinge { name, hinge_kind, .. } = self.items.get(index)? else { return None };
        let Spanned { value: kind, .. } = hinge_kind.clone()?;
        let motion = self.properties.get(index)?.motion.clone()?;
        let attachment = |index: usize, on: fn(BodyId) -> Attachment| match self.items.get(index)? {
            RouteItem::Ground { frame, .. } => Some(Attachment::Ground(frame.clone()?)),
            // A moving end is a body whose output is its input.
            RouteItem::Body { .. } | RouteItem::Moving { .. } => Some(on(numbers.body(index))),
            RouteItem::Hinge { .. } | RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => {
                None
            }
        };
        let sides = [
            attachment(index.checked_sub(1)?, Attachment::Output)?,
            attachment(index + 1, Attachment::Input)?,
        ];
        Some(hinge((*name)?.clone(), kind, sides, motion))
    }

    fn body(&self, item: &RouteItem) -> Option<Body> {
        let RouteItem::Body { name, body_type, .. } = item else { return None };
        let body_type = &self.types[(*body_type)?];
        Some(Body {
            name: name.clone(),
            path: name.to_string(),
            type_name: body_type.name.clone(),
            result_name: body_type.name.clone(),
            mass: body_type.mass.clone()?.value,
            com: body_type.com.clone()?.value,
            inertia: body_type.inertia.clone()?.value,
            output: body_type.output.clone().map_or_else(Frame::identity, |given| given.value),
            points: body_type.points.iter().map(PointDraft::finish).collect::<Option<_>>()?,
            present: PresentPoints {
                output: body_type.gives("output"),
                com: body_type.gives("com"),
            },
            role: Role::Physical,
        })
    }

    fn repeats(&self, numbers: &Numbering) -> Option<IdVec<RepeatId, Repeat>> {
        let repeats = self.def.route.iter().flat_map(|route| &route.repeats);
        let repeat = |repeat: &syntax::RepeatSyntax| {
            let items = repeat.items.clone();
            Some(Repeat {
                count: repeat.count?,
                hinges: numbers.hinges(items.clone()),
                bodies: numbers.bodies(items.clone()),
                last_body: numbers.bodies(items.clone()).last(),
                elements: numbers.elements(items),
                from_previous: Vec::new(),
            })
        };
        repeats.map(repeat).collect()
    }
}

fn hinge(
    name: Ident,
    kind: HingeKind,
    [inboard, outboard]: [Attachment; 2],
    motion: HingeProperties,
) -> Hinge {
    let HingeProperties { start, start_rate, rest, drive, passive } = motion;
    let path = name.to_string();
    Hinge { name, path, kind, inboard, outboard, start, start_rate, rest, drive, passive }
}

/// Returns the massless body of a moving end.
fn end_body(name: &Ident) -> Body {
    let zero = || Value::number(0.0);
    Body {
        name: name.clone(),
        path: name.to_string(),
        type_name: name.clone(),
        result_name: name.clone(),
        mass: zero(),
        com: zeros(),
        inertia: Inertia { tensor: [(); 6].map(|()| zero()), about: About::Com },
        output: Frame::identity(),
        points: Vec::new(),
        present: PresentPoints::ALL,
        role: Role::MovingEnd,
    }
}
