//! The layout of a chain: its links from the ground outwards, and the ranges of every hinge in the
//! coordinates `q`, the rates `v` and the inputs.

use super::{
    Attachment, Body, BodyId, Chain, Drive, Effort, Hinge, HingeId, HingeKind, InputId, LinkId,
    Load, LoadId, RepeatBoundary, RepeatId, Source, SpringId,
};
use crate::ids::IdVec;
use proc_macro2::Ident;
use quote::format_ident;
use std::collections::BTreeSet;
use std::ops::Range;

/// A link: bodies that are welded together, and the hinge that connects them to their parent.
#[derive(Clone, Debug)]
pub struct Link {
    /// The hinge.
    pub hinge: HingeId,
    /// The body at the hinge; its frame is the frame of the link.
    pub body: BodyId,
    /// All bodies of the link, `body` first: the others are welded to it.
    pub members: Vec<BodyId>,
    /// The link on the other side of the hinge; `None` if that is the ground.
    pub parent: Option<LinkId>,
    /// Whether the link is on the inboard side of its hinge, as in a chain that is held at its end.
    pub reversed: bool,
    /// The boundary of a repeated part, if the link is one.
    pub boundary: Option<RepeatBoundary>,
    /// Whether the hinge belongs to a repeated part.
    pub repeated: bool,
}

/// What a body moves with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MovesWith {
    /// The ground: the body does not move.
    Ground,
    /// This link.
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

/// The layout of a chain.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The links from the ground outwards: each follows its parent.
    pub links: IdVec<LinkId, Link>,
    /// Hinges that close loops: both of their sides are links of the tree already.
    pub loop_hinges: Vec<HingeId>,
    /// What each body moves with.
    pub parts: IdVec<BodyId, MovesWith>,
    /// The weld that merged a body into its link; `None` for the first body of a link.
    pub joined: IdVec<BodyId, Option<MergedWeld>>,
    /// The range of each hinge in `q`; empty if its motion is prescribed.
    pub q: IdVec<HingeId, Range<usize>>,
    /// The range of each hinge in `v`; empty if its motion is prescribed.
    pub v: IdVec<HingeId, Range<usize>>,
    /// The range of each hinge in reported accelerations and efforts.
    pub rates: IdVec<HingeId, Range<usize>>,
    /// The inputs, in their order.
    pub inputs: IdVec<InputId, Input>,
}

/// An input: values that the caller gives at every step.
#[derive(Clone, Debug)]
pub struct Input {
    /// What it is.
    pub what: InputKind,
    /// Its range in the inputs.
    pub range: Range<usize>,
}

/// The kind of an input.
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
    /// The force of a spring's actuator.
    SpringForce(SpringId),
}

impl Layout {
    /// Returns the layout of `chain` with a separate link for every body.
    pub fn of(chain: &Chain) -> Self {
        Layout::new(chain, false)
    }

    /// Returns the layout of `chain` with welded bodies merged into one link.
    pub fn merged(chain: &Chain) -> Self {
        Layout::new(chain, true)
    }

    fn new(chain: &Chain, merge: bool) -> Self {
        // Bodies at a boundary of a repeated part are not merged across it.
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

    /// Returns whether the hinge of a link, or of its parent, is at a boundary of a repeated part.
    pub fn is_at_repeat_boundary(&self, link: LinkId) -> bool {
        let is_boundary = |link: LinkId| self.links[link].boundary.is_some();
        is_boundary(link) || self.links[link].parent.is_some_and(is_boundary)
    }

    /// Returns the length of `q`.
    pub fn coordinates(&self) -> usize {
        self.q.iter().last().map_or(0, |range| range.end)
    }

    /// Returns the length of `v`: the degrees of freedom without loop constraints.
    pub fn dof_count(&self) -> usize {
        self.v.iter().last().map_or(0, |range| range.end)
    }

    /// Returns the numbers of rates on the paths from the ground to all links.
    pub fn path_lengths(&self) -> IdVec<LinkId, usize> {
        let mut paths: IdVec<LinkId, usize> = IdVec::new();
        for (_, link) in self.links.enumerate() {
            let inboard = link.parent.map_or(0, |parent| paths[parent]);
            paths.push(inboard + self.v[link.hinge].len());
        }
        paths
    }

    /// Returns the largest number of rates on a path from the ground to a link.
    pub fn longest_path(&self) -> usize {
        self.path_lengths().iter().copied().max().unwrap_or(0)
    }

    /// Returns the range of an input that exists.
    pub fn input(&self, what: InputKind) -> Range<usize> {
        let found = self.inputs.iter().find(|input| input.what == what);
        found.map_or_else(|| bug!("{what:?} is no input"), |input| input.range.clone())
    }
}

impl Chain {
    /// Returns whether the motion of any hinge is prescribed.
    pub fn has_prescribed_hinges(&self) -> bool {
        self.hinges.iter().any(Hinge::is_prescribed)
    }

    /// Returns the name of the field of an input.
    pub fn name_of_input(&self, what: InputKind) -> Ident {
        let of = |name: &Ident, what: &str| format_ident!("{name}_{what}", span = name.span());
        match what {
            InputKind::Gravity => format_ident!("gravity"),
            InputKind::Efforts(hinge) | InputKind::Motion(hinge) => self.hinges[hinge].name.clone(),
            InputKind::Force(load) => of(&self.loads[load].name, "force"),
            InputKind::Torque(load) => of(&self.loads[load].name, "torque"),
            InputKind::SpringForce(spring) => of(&self.springs[spring].name, "force"),
        }
    }
}

impl Attachment {
    /// Returns the body, or `None` for the ground.
    pub fn body(&self) -> Option<BodyId> {
        match self {
            Attachment::Ground(_) => None,
            Attachment::Input(body) | Attachment::Output(body) | Attachment::Point(body, _) => {
                Some(*body)
            }
        }
    }

    /// Returns the same place of another body.
    pub fn on(&self, body: BodyId) -> Attachment {
        match self {
            Attachment::Ground(_) => self.clone(),
            Attachment::Input(_) => Attachment::Input(body),
            Attachment::Output(_) => Attachment::Output(body),
            Attachment::Point(_, point) => Attachment::Point(body, *point),
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
    let mut inputs: Vec<(InputKind, usize)> = Vec::new();
    let (translations, rotations) =
        (chain.dimension.translations().len(), chain.dimension.rotations().len());
    if chain.gravity == Source::Input {
        inputs.push((InputKind::Gravity, translations));
    }
    for (index, hinge) in chain.hinges.enumerate() {
        match &hinge.drive {
            Drive::Prescribed => {
                let count = hinge.kind.coordinates() + 2 * hinge.kind.dof_count();
                inputs.push((InputKind::Motion(index), count));
            }
            Drive::Efforts(efforts) => {
                let count = efforts.iter().filter(|effort| **effort == Effort::Input).count();
                inputs.push((InputKind::Efforts(index), count));
            }
        }
    }
    for (index, Load { force, torque, .. }) in chain.loads.enumerate() {
        for (source, what, count) in [
            (force, InputKind::Force(index), translations),
            (torque, InputKind::Torque(index), rotations),
        ] {
            if *source == Source::Input {
                inputs.push((what, count));
            }
        }
    }
    let actuated = chain.springs.enumerate().filter(|(_, spring)| spring.force == Effort::Input);
    inputs.extend(actuated.map(|(index, _)| (InputKind::SpringForce(index), 1)));
    inputs.retain(|(_, count)| *count > 0);
    let ranges: Vec<Range<usize>> = consecutive(inputs.iter().map(|(_, count)| *count));
    inputs.iter().zip(ranges).map(|(&(what, _), range)| Input { what, range }).collect()
}

/// The spanning tree of a chain.
struct Tree {
    links: IdVec<LinkId, Link>,
    loop_hinges: Vec<HingeId>,
    parts: IdVec<BodyId, MovesWith>,
    joined: IdVec<BodyId, Option<MergedWeld>>,
}

impl Tree {
    /// Builds the tree over the hinges in the order written; welds, which may be merged, and welds
    /// of boundaries at the start precede all others. A repeated part is traversed without interruption, since
    /// everything between its boundaries is evaluated for each repetition; its ends come last.
    fn of(chain: &Chain, is_weld: impl Fn(HingeId) -> bool, merge: bool) -> Tree {
        let rank = |hinge: HingeId| match chain.repeat_boundary(&chain.hinges[hinge].outboard) {
            Some(RepeatBoundary { at_end: false, .. }) => TraversalOrder::First,
            Some(RepeatBoundary { at_end: true, .. }) => TraversalOrder::Last,
            None if is_weld(hinge) => TraversalOrder::First,
            None => TraversalOrder::Free,
        };
        let mut touching: IdVec<BodyId, Vec<HingeId>> =
            IdVec::filled(Vec::new(), chain.bodies.len());
        let mut next: BTreeSet<(TraversalOrder, HingeId)> = BTreeSet::new();
        for hinge in chain.hinges.ids() {
            for side in sides(chain, hinge) {
                match side {
                    Some(body) => touching[body].push(hinge),
                    None => _ = next.insert((rank(hinge), hinge)),
                }
            }
        }
        let mut reached: IdVec<BodyId, Option<MovesWith>> = IdVec::filled(None, chain.bodies.len());
        let (mut links, mut loop_hinges) = (IdVec::<LinkId, Link>::new(), Vec::new());
        let mut joined = IdVec::filled(None, chain.bodies.len());
        let mut inside: Option<RepeatId> = None;
        while let Some(hinge) = pop(chain, &mut next, inside) {
            let Some((body, from, reversed)) = added(chain, hinge, &reached) else {
                loop_hinges.push(hinge);
                continue;
            };
            let part = if !(is_weld(hinge) && merge) {
                let parent = match from {
                    MovesWith::Ground => None,
                    MovesWith::Link(link) => Some(link),
                };
                let boundary = chain.repeat_boundary(&Attachment::Input(body));
                inside = boundary.map_or(inside, |boundary| Some(boundary.repeat));
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
            next.extend(others.map(|&other| (rank(other), other)));
            inside = inside.filter(|&repeat| {
                next.iter().any(|&(_, hinge)| chain.lies_in_repeat(hinge, repeat))
            });
        }
        let part = |(body, part): (&Body, Option<MovesWith>)| {
            part.unwrap_or_else(|| bug!("no hinge holds body `{}`", body.name))
        };
        let parts = chain.bodies.iter().zip(reached).map(part).collect();
        Tree { links, loop_hinges, parts, joined }
    }
}

/// Returns the bodies on the inboard and the outboard side of a hinge.
fn sides(chain: &Chain, hinge: HingeId) -> [Option<BodyId>; 2] {
    [&chain.hinges[hinge].inboard, &chain.hinges[hinge].outboard].map(Attachment::body)
}

/// Returns the body that a hinge adds to the tree, the part on its other side, and whether the body is on the inboard
/// side; none if both sides are in the tree already.
fn added(
    chain: &Chain,
    hinge: HingeId,
    reached: &IdVec<BodyId, Option<MovesWith>>,
) -> Option<(BodyId, MovesWith, bool)> {
    let part = |side: Option<BodyId>| side.map_or(Some(MovesWith::Ground), |body| reached[body]);
    match sides(chain, hinge).map(|side| (side, part(side))) {
        [(_, Some(from)), (Some(body), None)] => Some((body, from, false)),
        [(Some(body), None), (_, Some(from))] => Some((body, from, true)),
        [(_, Some(_)), (_, Some(_))] => None,
        _ => bug!("hinge `{}` is reached from no side", chain.hinges[hinge].name),
    }
}

/// When a hinge is traversed, among those that can be.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum TraversalOrder {
    First,
    Free,
    Last,
}

/// Removes and returns the first hinge that may come next: inside a repeated part only hinges of this
/// part, and its first one only if all its channels have been reached.
fn pop(
    chain: &Chain,
    next: &mut BTreeSet<(TraversalOrder, HingeId)>,
    inside: Option<RepeatId>,
) -> Option<HingeId> {
    let may_come = |hinge: HingeId| match inside {
        Some(repeat) => chain.lies_in_repeat(hinge, repeat),
        None => match chain.repeat_boundary(&chain.hinges[hinge].outboard) {
            Some(RepeatBoundary { repeat, at_end: false, .. }) => {
                chain.starts_of(repeat).all(|start| next.contains(&(TraversalOrder::First, start)))
            }
            Some(_) | None => true,
        },
    };
    let first = next.iter().copied().find(|&(_, hinge)| may_come(hinge))?;
    next.remove(&first);
    Some(first.1)
}
