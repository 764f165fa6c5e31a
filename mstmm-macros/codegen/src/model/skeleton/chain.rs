//! From a route in which hinges and bodies alternate to a chain.

use super::{End, Part, Sketch, asked, is_identifier};
use crate::diag::nearest;
use crate::ids::IdVec;
use crate::model::check::can_be_a_point;
use crate::model::lower::{Draft, Motion, of_everything};
use crate::model::{
    About, Body, BodyId, Chain, ClosureRank, Drive, Effort, Element, Frame, Hinge, HingeId,
    HingeKind, Inertia, Load, LoadAxes, LoadId, Method, NamedPoint, Place, Repeat, RepeatId, Role,
    Value, Written,
};
use proc_macro2::Ident;
use std::collections::HashSet;

impl Sketch<'_, '_> {
    /// The chain.
    pub(super) fn finish(self, name: Ident) -> Chain {
        let Sketch { draft, parts, start, finish, parameters, .. } = self;
        let counts = count(&parts);
        let numbers = Numbers { parts: &parts, counts: &counts };
        let ends: Vec<&Ident> = [&start, &finish].into_iter().filter_map(End::name).collect();
        let everything = || of_everything(draft.space);
        let floats = matches!((&start, &finish), (End::Free, End::Free));
        let first_body = parts.iter().find(|part| part.hinge.is_none());
        let on_ground = || Place::Ground(Frame::identity());
        let bodies_on_route = counts.last().map_or(0, |&(bodies, _)| bodies);
        let end_body = |number: usize| BodyId(bodies_on_route + number);

        let mut hinges: IdVec<HingeId, Hinge> = IdVec::new();
        if floats && let Some(first) = first_body {
            let efforts = Drive::Efforts(vec![Effort::Free; everything().freedoms()]);
            let places = [on_ground(), Place::Input(BodyId(0))];
            hinges.push(hinge(first.name.clone(), everything(), places, efforts));
        }
        for (number, end) in ends.iter().enumerate() {
            let places = [on_ground(), Place::Input(end_body(number))];
            hinges.push(hinge((*end).clone(), everything(), places, Drive::Motion));
        }
        let implied = hinges.len();
        let held = |end: &End, number: usize| match end {
            End::Moving(_) => Place::Output(end_body(number)),
            End::Free | End::Held => on_ground(),
        };
        for (index, part) in parts.iter().enumerate() {
            let Some((kind, drive)) = &part.hinge else { continue };
            let (before, _) = counts[index];
            let inboard =
                if index == 0 { held(&start, 0) } else { Place::Output(BodyId(before - 1)) };
            let outboard = match parts.get(index + 1) {
                Some(_) => Place::Input(BodyId(before)),
                None => held(&finish, ends.len().saturating_sub(1)),
            };
            let hinge = hinge(part.name.clone(), kind.clone(), [inboard, outboard], drive.clone());
            hinges.push(hinge);
        }
        let bodies = parts.iter().filter(|part| part.hinge.is_none());
        let bodies = bodies.map(|part| Body {
            type_name: part.body_type.as_ref().unwrap_or(&part.name).clone(),
            points: points(draft, part.body_type.as_ref()),
            ..body(&part.name, Role::Matter)
        });
        let bodies: IdVec<BodyId, Body> =
            bodies.chain(ends.iter().map(|end| body(end, Role::End))).collect();
        Chain {
            name,
            dimension: draft.space,
            gravity: asked::source(asked::gravity(draft)),
            parameters,
            constants: draft.constants,
            loads: loads(draft, &parts, bodies_on_route),
            springs: Vec::new(),
            route: numbers.route(implied),
            repeats: numbers.repeats(draft, implied),
            bodies,
            hinges,
            method: Some(Method::Riccati),
            results: draft.settings.results,
            held_by_closure: false,
            closure_rank: ClosureRank::Unknown,
            assertions: Vec::new(),
        }
    }
}

impl End {
    fn name(&self) -> Option<&Ident> {
        match self {
            End::Moving(name) => Some(name),
            End::Free | End::Held => None,
        }
    }
}

/// How many bodies and hinges stand before each part, and before the end.
fn count(parts: &[Part]) -> Vec<(usize, usize)> {
    let mut counts = vec![(0, 0)];
    let (mut bodies, mut hinges) = (0, 0);
    for part in parts {
        if part.hinge.is_some() {
            hinges += 1
        } else {
            bodies += 1
        }
        counts.push((bodies, hinges));
    }
    counts
}

/// Which bodies and hinges of the model the parts are.
struct Numbers<'p> {
    parts: &'p [Part],
    counts: &'p [(usize, usize)],
}

impl Numbers<'_> {
    fn route(&self, implied: usize) -> Vec<Element> {
        let element = |(part, &(bodies, hinges)): (&Part, &(usize, usize))| match part.hinge {
            Some(_) => Element::Hinge(HingeId(implied + hinges)),
            None => Element::Body(BodyId(bodies)),
        };
        self.parts.iter().zip(self.counts).map(element).collect()
    }

    /// The repeated parts; one that holds nothing is none.
    fn repeats(&self, draft: &Draft, implied: usize) -> IdVec<RepeatId, Repeat> {
        let written = draft.def.route.iter().flat_map(|route| &route.repeats).enumerate();
        // A parameter for every time has the count of its part.
        let of_parameters = draft.parameters.iter().find_map(|parameter| parameter.times);
        let repeat = |(index, repeat): (usize, &crate::syntax::Repeat)| {
            let is_in = |part: &Part| part.repeat == Some(index);
            let first = self.parts.iter().position(is_in)?;
            let end = self.parts.iter().rposition(is_in)? + 1;
            let ((bodies, hinges), (last_body, last_hinge)) =
                (self.counts[first], self.counts[end]);
            Some(Repeat {
                count: repeat.count.or(of_parameters).unwrap_or(UNKNOWN_COUNT),
                hinges: (implied + hinges..implied + last_hinge).into(),
                bodies: (bodies..last_body).into(),
                route: first..end,
            })
        };
        written.filter_map(repeat).collect()
    }
}

/// The count of a `repeat` of which nothing tells it.
const UNKNOWN_COUNT: usize = 2;

/// Loads beyond so many of a wrong chain have no inputs: a long chain has many names.
const MOST_LOADS: usize = 1000;

/// The loads, for the inputs that they have: none by the name of a hinge's or of another load.
fn loads(draft: &Draft, parts: &[Part], bodies: usize) -> IdVec<LoadId, Load> {
    let mut names: HashSet<String> = parts.iter().map(|part| part.name.to_string()).collect();
    let on_route = parts.iter().filter(|part| part.hinge.is_none());
    let on_route: Vec<String> = on_route.map(|part| part.name.to_string()).collect();
    let mut loads = IdVec::new();
    for load in draft.loads.iter().take(MOST_LOADS) {
        let name = load.name;
        if !is_identifier(name) {
            continue;
        }
        let [force, torque] = asked::efforts_of_load(load.block);
        let mut is_free = |(asked, effort)| asked && names.insert(format!("{name}_{effort}"));
        let [force, torque] = [(force, "force"), (torque, "torque")].map(&mut is_free);
        let on = asked::body_of_load(load.block).and_then(|on| {
            let on = on.to_string();
            let exact = on_route.iter().position(|name| *name == on);
            let near = || nearest(&on, on_route.iter().map(String::as_str));
            exact.or_else(|| near().and_then(|near| on_route.iter().position(|name| name == near)))
        });
        loads.push(Load {
            name: name.clone(),
            body: on
                .map(BodyId)
                .or(load.body)
                .filter(|body| body.index() < bodies)
                .unwrap_or(BodyId(0)),
            at: Frame::identity(),
            axes: LoadAxes::Inertial,
            force: asked::source(force),
            torque: asked::source(torque),
        });
    }
    loads
}

fn hinge(name: Ident, kind: HingeKind, [inboard, outboard]: [Place; 2], drive: Drive) -> Hinge {
    let Motion { start, start_rate, rest, passive, .. } = Motion::none(kind.shape());
    Hinge { name, kind, inboard, outboard, start, start_rate, rest, drive, passive }
}

/// A body of 1 kg and 1 kg m², or one without mass that stands for an end.
fn body(name: &Ident, role: Role) -> Body {
    let number = |value| Value::number(value);
    let one = if role == Role::Matter { 1.0 } else { 0.0 };
    Body {
        name: name.clone(),
        type_name: name.clone(),
        mass: number(one),
        com: [(); 3].map(|()| number(0.0)),
        inertia: Inertia { tensor: [one, one, one, 0.0, 0.0, 0.0].map(number), about: About::Com },
        output: Frame::identity(),
        points: Vec::new(),
        written: Written::ALL,
        role,
    }
}

/// The named points of a type of body; those of all types where the type is unknown.
fn points(draft: &Draft, body_type: Option<&Ident>) -> Vec<NamedPoint> {
    let Some(body_type) = body_type else { return Vec::new() };
    let known = draft.types.iter().find(|known| known.name == body_type);
    let types = known.map_or(&draft.types[..], std::slice::from_ref);
    let mut names = HashSet::new();
    let all = types.iter().flat_map(|body_type| &body_type.points);
    let usable = all.filter(|point| {
        can_be_a_point(point.name) && is_identifier(point.name) && names.insert(point.name)
    });
    let zeros = || [(); 3].map(|()| Value::number(0.0));
    usable.map(|point| NamedPoint { name: point.name.clone(), position: zeros() }).collect()
}
