//! Where things lie: the order in which motion spreads from the ground, and the places of every
//! hinge's numbers in the coordinates `q`, the rates `v` and the inputs.

use super::{
    Attachment, Body, BodyId, Chain, Drive, Effort, Hinge, HingeId, HingeKind, InputId, LinkId,
    Load, LoadId, RepeatBoundary, RepeatId, Source,
};
use crate::ids::IdVec;
use proc_macro2::Ident;
use quote::format_ident;
use std::collections::BTreeSet;
use std::ops::Range;

/// A rigid part and the hinge that ties it to where its motion comes from.
#[derive(Clone, Debug)]
pub struct Link {
    /// The hinge.
    pub hinge: HingeId,
    /// The body that the hinge sits on; the part's frame is that body's.
    pub body: BodyId,
    /// All bodies of the part, that one first: the others are welded to it.
    pub members: Vec<BodyId>,
    /// The link of the part on the hinge's other side; none if that is the ground.
    pub parent: Option<LinkId>,
    /// Whether the part is on the inboard side of its hinge, as in a chain held at its end.
    pub reversed: bool,
    /// Whether it is a place where a repeated part begins or ends.
    pub boundary: Option<RepeatBoundary>,
    /// Whether the hinge belongs to a repeated part.
    pub repeated: bool,
}

/// What a body belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovesWith {
    /// What does not move.
    Ground,
    /// The part of this link.
    Link(LinkId),
}

/// A weld that was merged away.
#[derive(Clone, Copy, Debug)]
pub struct MergedWeld {
    /// The weld.
    pub weld: HingeId,
    /// Whether the body is on the inboard side of its weld.
    pub reversed: bool,
}

/// The order of a chain.
#[derive(Clone, Debug)]
pub struct Layout {
    /// From the ground outwards: each link stands after its parent.
    pub links: IdVec<LinkId, Link>,
    /// Hinges that close loops: both sides move already without them.
    pub loop_hinges: Vec<HingeId>,
    /// What each body belongs to.
    pub parts: IdVec<BodyId, MovesWith>,
    /// The weld by which a body joined its part, unless it is the part's first.
    pub joined: IdVec<BodyId, Option<MergedWeld>>,
    /// Each hinge's part of `q`; empty where its motion is prescribed.
    pub q: IdVec<HingeId, Range<usize>>,
    /// Each hinge's part of `v`; empty where its motion is prescribed.
    pub v: IdVec<HingeId, Range<usize>>,
    /// Each hinge's part of what is reported of rates: accelerations and efforts.
    pub rates: IdVec<HingeId, Range<usize>>,
    /// What the caller gives at every step, in the order of the inputs.
    pub inputs: IdVec<InputId, Input>,
}

/// Something that the caller gives at every step.
#[derive(Clone, Debug)]
pub struct Input {
    /// What it is.
    pub what: InputKind,
    /// Its part of the inputs.
    pub range: Range<usize>,
}

/// What is given by the caller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// Acceleration of free fall.
    Gravity,
    /// Those efforts of a hinge that are inputs.
    Efforts(HingeId),
    /// Coordinates, rates and accelerations of a hinge.
    Motion(HingeId),
    /// The force of a load.
    Force(LoadId),
    /// The torque of a load.
    Torque(LoadId),
}

impl Layout {
    /// The layout of `chain` with every body a part of its own.
    pub fn of(chain: &Chain) -> Self {
        Layout::new(chain, false)
    }

    /// The layout of `chain` with welded bodies merged: otherwise the same.
    pub fn merged(chain: &Chain) -> Self {
        Layout::new(chain, true)
    }

    fn new(chain: &Chain, merge: bool) -> Self {
        // What is on a seam is no part of what lies on its other side.
        let at_boundary = |hinge: &Hinge| {
            chain
                .repeat_boundary(&hinge.inboard)
                .or_else(|| chain.repeat_boundary(&hinge.outboard))
                .is_some()
        };
        let is_weld = |index: HingeId| {
            let hinge = &chain.hinges[index];
            hinge.kind == HingeKind::Weld && !at_boundary(hinge)
        };
        let free = |hinge: &Hinge, count: usize| if hinge.is_prescribed() { 0 } else { count };
        let Tree { links, loop_hinges, parts, joined } = Tree::of(chain, is_weld, merge);
        Layout {
            links,
            loop_hinges,
            parts,
            joined,
            q: consecutive(chain.hinges.iter().map(|hinge| free(hinge, hinge.kind.coordinates()))),
            v: consecutive(chain.hinges.iter().map(|hinge| free(hinge, hinge.kind.dof_count()))),
            rates: consecutive(chain.hinges.iter().map(|hinge| hinge.kind.dof_count())),
            inputs: inputs(chain),
        }
    }

    /// Whether a link's hinge, or its parent's, is on a seam.
    pub fn is_at_repeat_boundary(&self, link: LinkId) -> bool {
        let is_boundary = |link: LinkId| self.links[link].boundary.is_some();
        is_boundary(link) || self.links[link].parent.is_some_and(is_boundary)
    }

    /// Length of `q`.
    pub fn coordinates(&self) -> usize {
        self.q.iter().last().map_or(0, |range| range.end)
    }

    /// Length of `v`: the degrees of freedom, but for those that closures take.
    pub fn dof_count(&self) -> usize {
        self.v.iter().last().map_or(0, |range| range.end)
    }

    /// The part of the inputs that gives `what`, which the caller does give.
    pub fn input(&self, what: InputKind) -> Range<usize> {
        let found = self.inputs.iter().find(|input| input.what == what);
        found.map_or_else(|| bug!("{what:?} is no input"), |input| input.range.clone())
    }
}

impl Chain {
    /// Whether the motion of some hinge is prescribed.
    pub fn has_prescribed_hinges(&self) -> bool {
        self.hinges.iter().any(Hinge::is_prescribed)
    }

    /// What the field of the inputs is called that gives `what`.
    pub fn name_of_input(&self, what: InputKind) -> Ident {
        let of_load = |load: LoadId, what: &str| {
            let name = &self.loads[load].name;
            format_ident!("{name}_{what}", span = name.span())
        };
        match what {
            InputKind::Gravity => format_ident!("gravity"),
            InputKind::Efforts(hinge) | InputKind::Motion(hinge) => self.hinges[hinge].name.clone(),
            InputKind::Force(load) => of_load(load, "force"),
            InputKind::Torque(load) => of_load(load, "torque"),
        }
    }
}

impl Attachment {
    /// The body that it is on, unless it is on the ground.
    pub fn body(&self) -> Option<BodyId> {
        match self {
            Attachment::Ground(_) => None,
            Attachment::Input(body) | Attachment::Output(body) => Some(*body),
        }
    }
}

fn consecutive<C: FromIterator<Range<usize>>>(lengths: impl Iterator<Item = usize>) -> C {
    lengths
        .scan(0, |end, length| {
            let start = *end;
            *end += length;
            Some(start..*end)
        })
        .collect()
}

fn inputs(chain: &Chain) -> IdVec<InputId, Input> {
    let mut given: Vec<(InputKind, usize)> = Vec::new();
    let (shifts, turns) = (chain.dimension.shifts().len(), chain.dimension.turns().len());
    if chain.gravity == Source::Input {
        given.push((InputKind::Gravity, shifts));
    }
    for (index, hinge) in chain.hinges.enumerate() {
        match &hinge.drive {
            Drive::Prescribed => {
                let count = hinge.kind.coordinates() + 2 * hinge.kind.dof_count();
                given.push((InputKind::Motion(index), count));
            }
            Drive::Efforts(efforts) => {
                let count = efforts.iter().filter(|effort| **effort == Effort::Input).count();
                given.push((InputKind::Efforts(index), count));
            }
        }
    }
    for (index, Load { force, torque, .. }) in chain.loads.enumerate() {
        for (source, what, count) in
            [(force, InputKind::Force(index), shifts), (torque, InputKind::Torque(index), turns)]
        {
            if *source == Source::Input {
                given.push((what, count));
            }
        }
    }
    given.retain(|(_, count)| *count > 0);
    let ranges: Vec<Range<usize>> = consecutive(given.iter().map(|(_, count)| *count));
    given.iter().zip(ranges).map(|(&(what, _), range)| Input { what, range }).collect()
}

/// How motion spreads from the ground.
struct Tree {
    links: IdVec<LinkId, Link>,
    loop_hinges: Vec<HingeId>,
    parts: IdVec<BodyId, MovesWith>,
    joined: IdVec<BodyId, Option<MergedWeld>>,
}

impl Tree {
    /// Over the hinges, those written first before the others; welds, which may be merged, and those
    /// of seams before all others. A repeated part is gone through without a break, since all that
    /// lies between its seams is done for each time.
    fn of(chain: &Chain, is_weld: impl Fn(HingeId) -> bool, merge: bool) -> Tree {
        let sides = |hinge: HingeId| {
            [&chain.hinges[hinge].inboard, &chain.hinges[hinge].outboard].map(Attachment::body)
        };
        let is_free = |hinge: HingeId| {
            !is_weld(hinge) && chain.repeat_boundary(&chain.hinges[hinge].outboard).is_none()
        };
        let mut touching: IdVec<BodyId, Vec<HingeId>> =
            IdVec::filled(Vec::new(), chain.bodies.len());
        let mut next: BTreeSet<(bool, HingeId)> = BTreeSet::new();
        for hinge in chain.hinges.ids() {
            for side in sides(hinge) {
                match side {
                    Some(body) => touching[body].push(hinge),
                    None => _ = next.insert((is_free(hinge), hinge)),
                }
            }
        }
        let mut reached: IdVec<BodyId, Option<MovesWith>> = IdVec::filled(None, chain.bodies.len());
        let (mut links, mut loop_hinges) = (IdVec::<LinkId, Link>::new(), Vec::new());
        let mut joined = IdVec::filled(None, chain.bodies.len());
        let mut inside: Option<RepeatId> = None;
        while let Some((_, hinge)) =
            pop(&mut next, |hinge| inside.is_none_or(|repeat| chain.lies_in_repeat(hinge, repeat)))
        {
            let part =
                |side: Option<BodyId>| side.map_or(Some(MovesWith::Ground), |body| reached[body]);
            let [inboard, outboard] = sides(hinge);
            let (body, from, reversed) =
                match [(inboard, part(inboard)), (outboard, part(outboard))] {
                    [(_, Some(from)), (Some(body), None)] => (body, from, false),
                    [(Some(body), None), (_, Some(from))] => (body, from, true),
                    [(_, Some(_)), (_, Some(_))] => {
                        loop_hinges.push(hinge);
                        continue;
                    }
                    _ => bug!("hinge `{}` is reached from no side", chain.hinges[hinge].name),
                };
            let part = if !(is_weld(hinge) && merge) {
                let parent = match from {
                    MovesWith::Ground => None,
                    MovesWith::Link(link) => Some(link),
                };
                let boundary = chain.repeat_boundary(&Attachment::Input(body));
                inside = match boundary {
                    Some(RepeatBoundary { repeat, at_end: false }) => Some(repeat),
                    Some(RepeatBoundary { at_end: true, .. }) => None,
                    None => inside,
                };
                let (members, repeated) = (vec![body], chain.repeat_of_hinge(hinge).is_some());
                let link = Link { hinge, body, members, parent, reversed, boundary, repeated };
                MovesWith::Link(links.push(link))
            } else {
                if let MovesWith::Link(link) = from {
                    links[link].members.push(body);
                }
                joined[body] = Some(MergedWeld { weld: hinge, reversed });
                from
            };
            reached[body] = Some(part);
            let others = touching[body].iter().filter(|&&other| other != hinge);
            next.extend(others.map(|&other| (is_free(other), other)));
        }
        let part = |(body, part): (&Body, Option<MovesWith>)| {
            part.unwrap_or_else(|| bug!("no hinge holds body `{}`", body.name))
        };
        let parts = chain.bodies.iter().zip(reached).map(part).collect();
        Tree { links, loop_hinges, parts, joined }
    }
}

/// Takes out the first hinge that may come next.
fn pop(
    next: &mut BTreeSet<(bool, HingeId)>,
    may_come: impl Fn(HingeId) -> bool,
) -> Option<(bool, HingeId)> {
    let first = next.iter().copied().find(|&(_, hinge)| may_come(hinge))?;
    next.remove(&first);
    Some(first)
}
