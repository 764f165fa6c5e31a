//! The draft of a chain: the result of the lowering before the checks.

use proc_macro2::Ident;

use super::body::{BodyTypes, PointDraft};
use super::context::Spanned;
use super::hinge::{HingeProperties, of_everything};
use super::load::{LoadDraft, SpringDraft};
use super::names::NameTable;
use super::numbering::Numbering;
use super::parts::{ItemName, WrittenOut};
use super::place::{BodyPlace, PlacePoint, Resolved};
use super::properties::{self, ItemProperties};
use super::route_item::RouteItem;
use super::setting::Settings;
use super::start::RouteStart;
use super::vector::zeros;
use crate::ids::{IdVec, ParameterId};
use crate::model::condition::Requirement;
use crate::model::{
    About, Attachment, Body, BodyId, Chain, Dimension, Drive, Element, Frame, FromPrevious, Hinge,
    HingeId, HingeKind, Inertia, Parameter, PresentPoints, Repeat, Role, Value,
};
use crate::syntax::ChainSyntax;

/// A chain, as far as it is readable.
pub(crate) struct Draft<'a> {
    /// As written.
    pub def: &'a ChainSyntax,
    /// The dimension of the space that it moves in.
    pub space: Dimension,
    /// Requirements on its values, from reading them.
    pub requirements: Vec<Requirement>,
    /// The squared lengths of its quaternions, as far as they are not known.
    pub quaternions: Vec<Value>,
    /// Settings of the whole chain.
    pub settings: Settings,
    /// Parameters: values that may change at run time.
    pub parameters: IdVec<ParameterId, Parameter>,
    /// The names of the parameters on which no value depends.
    pub unused_parameters: Vec<&'a Ident>,
    /// The number of Rust constants.
    pub constants: usize,
    /// The routes, with all parts written out.
    pub written: &'a WrittenOut<'a>,
    /// All body types.
    pub types: BodyTypes<'a>,
    /// All items of the routes.
    pub items: Vec<RouteItem<'a>>,
    /// The names of the items.
    pub names: NameTable,
    /// Where each route begins.
    pub starts: Vec<RouteStart>,
    /// The properties of the items, one for each.
    pub properties: Vec<ItemProperties<'a>>,
    /// All loads.
    pub loads: Vec<LoadDraft<'a>>,
    /// All springs.
    pub springs: Vec<SpringDraft<'a>>,
}

impl<'a> Draft<'a> {
    /// Returns the items and their names.
    pub fn resolved<'d>(&'d self) -> Resolved<'d, 'a> {
        let Draft { written, items, types, names, .. } = self;
        Resolved { written, items, types, names }
    }

    /// The defaults of the parameters, where they are known.
    pub fn defaults(&self) -> Vec<Option<f64>> {
        self.parameters.iter().map(|parameter| parameter.default.known()).collect()
    }

    /// Returns the chain; `None` if something is missing, which is reported then.
    pub fn finish(self) -> Option<Chain> {
        let numbers = Numbering::of(self.written, &self.items);
        let mut bodies: IdVec<BodyId, Body> = IdVec::new();
        let mut hinges = self.implied_hinges(&numbers)?;
        let mut elements = Vec::new();
        let sides = self.sides(&numbers);
        for (index, item) in self.items.iter().enumerate() {
            match item {
                RouteItem::Ground { .. } | RouteItem::Moving { .. } => {}
                RouteItem::Hinge { .. } => {
                    let hinge = self.hinge(index, sides[index].clone()?)?;
                    elements.push(Element::Hinge(hinges.push(hinge)));
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
        let repeats = (0..self.written.repeats.len()).map(|index| self.repeat(index, &numbers));
        let repeats = repeats.collect::<Option<_>>()?;
        let loads = self.loads.into_iter().map(|load| load.finish(&numbers));
        let springs = self.springs.into_iter().map(|spring| spring.finish(&numbers));
        Some(Chain {
            name: self.def.name.clone(),
            dimension: self.space,
            gravity: self.settings.gravity.clone()?,
            parameters: self.parameters.clone(),
            constants: self.constants,
            bodies,
            hinges,
            elements,
            repeats,
            loads: loads.collect::<Option<_>>()?,
            springs: springs.collect::<Option<_>>()?,
            method: self.settings.method.as_ref().map(|method| method.value),
            results: self.settings.results,
            requests: self.settings.requests.iter().map(|request| request.value).collect(),
            quaternions: self.quaternions,
            assertions: Vec::new(),
        })
    }

    /// Returns the hinges that are not on the routes, all from the ground to the input of a body: that of a floating base,
    /// then the prescribed hinges of moving ends.
    fn implied_hinges(&self, numbers: &Numbering) -> Option<IdVec<HingeId, Hinge>> {
        let kind = || of_everything(self.space);
        let implied = |name: &ItemName, body: BodyId, motion: HingeProperties| {
            let inboard = Attachment::Ground(Frame::identity());
            hinge(name, kind(), [inboard, Attachment::Input(body)], motion)
        };
        let mut hinges = IdVec::new();
        if properties::floats(self.written, &self.items) {
            let motion = self.properties.first()?.motion.clone()?;
            hinges.push(implied(self.items.first()?.name()?, BodyId(0), motion));
        }
        for (index, item) in self.items.iter().enumerate() {
            if matches!(item, RouteItem::Moving { .. }) {
                let motion = HingeProperties {
                    drive: Drive::Prescribed,
                    ..HingeProperties::none(kind().spec())
                };
                hinges.push(implied(item.name()?, numbers.body(index), motion));
            }
        }
        Some(hinges)
    }

    /// Returns the attachments of each hinge: what is before it and after it on its route.
    fn sides(&self, numbers: &Numbering) -> Vec<Option<[Attachment; 2]>> {
        let mut sides = vec![None; self.items.len()];
        for (route, start) in self.written.routes.iter().zip(&self.starts) {
            for (position, &index) in route.items.iter().enumerate() {
                let inboard = match position.checked_sub(1) {
                    Some(before) => {
                        self.attachment(route.items[before], Attachment::Output, numbers)
                    }
                    None => start.attachment(numbers),
                };
                let outboard = route.items.get(position + 1);
                let outboard =
                    outboard.and_then(|&after| self.attachment(after, Attachment::Input, numbers));
                sides[index] = inboard.zip(outboard).map(|(inboard, outboard)| [inboard, outboard]);
            }
        }
        sides
    }

    /// Returns the attachment of a hinge to the item beside it.
    fn attachment(
        &self,
        item: usize,
        on: fn(BodyId) -> Attachment,
        numbers: &Numbering,
    ) -> Option<Attachment> {
        match &self.items[item] {
            RouteItem::Ground { frame, .. } => Some(Attachment::Ground(frame.clone()?)),
            // A moving end is a body whose output is its input.
            RouteItem::Body { .. } | RouteItem::Moving { .. } => Some(on(numbers.body(item))),
            RouteItem::Hinge { .. } | RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => {
                None
            }
        }
    }

    /// The hinge at this item.
    fn hinge(&self, index: usize, sides: [Attachment; 2]) -> Option<Hinge> {
        let RouteItem::Hinge { name, hinge_kind, .. } = &self.items[index] else { return None };
        let Spanned { value: kind, .. } = hinge_kind.clone()?;
        let motion = self.properties.get(index)?.motion.clone()?;
        Some(hinge(name.as_ref()?, kind, sides, motion))
    }

    fn body(&self, item: &RouteItem) -> Option<Body> {
        let RouteItem::Body { name, body_type, .. } = item else { return None };
        let body_type = &self.types.all[(*body_type)?];
        Some(Body {
            name: name.joined.clone(),
            path: name.path.clone(),
            type_name: body_type.name.clone(),
            result_name: body_type.result_name.clone(),
            mass: body_type.mass.clone()?.value,
            com: body_type.com.clone()?.value,
            inertia: body_type.inertia.clone()?.value,
            output: body_type.output.clone().map_or_else(Frame::identity, |output| output.value),
            points: body_type.points.iter().map(PointDraft::finish).collect::<Option<_>>()?,
            shapes: body_type.shapes.clone(),
            present: PresentPoints {
                output: body_type.gives("output"),
                com: body_type.gives("com"),
            },
            role: Role::Physical,
        })
    }

    fn repeat(&self, index: usize, numbers: &Numbering) -> Option<Repeat> {
        let repeat = &self.written.repeats[index];
        let items = repeat.items.clone();
        let route = &self.written.routes[repeat.route];
        let last = *route.items[repeat.on_route.clone()].last()?;
        let branches = self.written.routes.iter().zip(&self.starts);
        let from_previous = branches.filter(|(route, _)| route.repeat == Some(index));
        let from_previous = from_previous.filter_map(|(route, start)| match start {
            RouteStart::Previous(Some(place)) => Some(FromPrevious {
                hinge: numbers.hinge(*route.items.first()?),
                previous: place.previous.attachment(numbers),
            }),
            _ => None,
        });
        Some(Repeat {
            count: repeat.syntax.count?,
            hinges: numbers.hinges(items.clone()),
            bodies: numbers.bodies(items.clone()),
            last_body: numbers.body(last),
            elements: numbers.elements(items),
            from_previous: from_previous.collect(),
        })
    }
}

impl RouteStart {
    /// Returns the inboard attachment of the first hinge; in a repeated part, that of the first repetition.
    fn attachment(&self, numbers: &Numbering) -> Option<Attachment> {
        match self {
            RouteStart::Item => None,
            RouteStart::Place(place) => Some((*place)?.attachment(numbers)),
            RouteStart::Previous(place) => Some((*place)?.first.attachment(numbers)),
        }
    }
}

impl BodyPlace {
    fn attachment(self, numbers: &Numbering) -> Attachment {
        let body = numbers.body(self.item);
        match self.point {
            PlacePoint::Input => Attachment::Input(body),
            PlacePoint::Output => Attachment::Output(body),
            PlacePoint::Named(index) => Attachment::Point(body, index),
            PlacePoint::Com => bug!("a hinge leaves a centre of mass"),
        }
    }
}

fn hinge(
    name: &ItemName,
    kind: HingeKind,
    [inboard, outboard]: [Attachment; 2],
    motion: HingeProperties,
) -> Hinge {
    let HingeProperties { start, start_field, start_rate, rest, drive, passive } = motion;
    let ItemName { joined: name, path } = name.clone();
    Hinge {
        name,
        path,
        kind,
        inboard,
        outboard,
        start,
        start_field,
        start_rate,
        rest,
        drive,
        passive,
    }
}

/// Returns the massless body of a moving end.
fn end_body(name: &ItemName) -> Body {
    let zero = || Value::number(0.0);
    let ItemName { joined, path } = name.clone();
    Body {
        name: joined.clone(),
        path,
        type_name: joined.clone(),
        result_name: joined,
        mass: zero(),
        com: zeros(),
        inertia: Inertia { tensor: [(); 6].map(|()| zero()), about: About::Com },
        output: Frame::identity(),
        points: Vec::new(),
        shapes: Vec::new(),
        present: PresentPoints::ALL,
        role: Role::MovingEnd,
    }
}
