//! Where things lie: the order in which motion spreads from the ground, and the places of every
//! hinge's numbers in the coordinates `q`, the rates `v` and the inputs.

use super::{BodyId, Chain, Effort, HingeId, HingeKind, Place};
use std::ops::Range;

/// A body and the hinge that ties it to where its motion comes from.
#[derive(Clone, Debug)]
pub struct Link {
    /// The hinge.
    pub hinge: HingeId,
    /// The body.
    pub body: BodyId,
    /// The link of the body on the hinge's other side; none if that is the ground.
    pub parent: Option<usize>,
    /// Whether the body is on the inboard side of its hinge, as in a chain held at its end.
    pub reversed: bool,
}

/// The order of a chain.
#[derive(Clone, Debug)]
pub struct Layout {
    /// From the ground outwards: each link stands after its parent.
    pub links: Vec<Link>,
    /// Each hinge's part of `q`.
    pub q: Vec<Range<usize>>,
    /// Each hinge's part of `v`.
    pub v: Vec<Range<usize>>,
    /// Each hinge's part of the inputs; empty where it takes none.
    pub inputs: Vec<Range<usize>>,
}

impl Layout {
    /// The layout of `chain`.
    pub fn of(chain: &Chain) -> Self {
        let kinds = || chain.hinges.iter().map(|hinge| &hinge.kind);
        Layout {
            links: links(chain),
            q: consecutive(kinds().map(HingeKind::coordinates)),
            v: consecutive(kinds().map(HingeKind::freedoms)),
            inputs: consecutive(chain.hinges.iter().map(|hinge| match hinge.effort {
                Effort::Input => hinge.kind.freedoms(),
                Effort::Free | Effort::Constant(_) => 0,
            })),
        }
    }

    /// Length of `q`.
    pub fn coordinates(&self) -> usize {
        self.q.last().map_or(0, |range| range.end)
    }

    /// Length of `v`: the degrees of freedom.
    pub fn freedoms(&self) -> usize {
        self.v.last().map_or(0, |range| range.end)
    }

    /// How many inputs there are.
    pub fn input_count(&self) -> usize {
        self.inputs.last().map_or(0, |range| range.end)
    }
}

impl Place {
    /// The body that it is on, unless it is on the ground.
    pub fn body(&self) -> Option<BodyId> {
        match self {
            Place::Ground(_) => None,
            Place::Input(body) | Place::Output(body) => Some(*body),
        }
    }
}

fn consecutive(lengths: impl Iterator<Item = usize>) -> Vec<Range<usize>> {
    lengths
        .scan(0, |end, length| {
            let start = *end;
            *end += length;
            Some(start..*end)
        })
        .collect()
}

/// Spreads from the ground over the hinges, nearest first.
fn links(chain: &Chain) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    let mut left: Vec<HingeId> = (0..chain.hinges.len()).collect();
    loop {
        let reached = |body: Option<BodyId>| match body {
            None => Some(None),
            Some(body) => links.iter().position(|link| link.body == body).map(Some),
        };
        let next = left.iter().find_map(|&hinge| {
            let sides =
                [&chain.hinges[hinge].inboard, &chain.hinges[hinge].outboard].map(Place::body);
            match (sides, sides.map(reached)) {
                ([_, Some(body)], [Some(parent), None]) => {
                    Some(Link { hinge, body, parent, reversed: false })
                }
                ([Some(body), _], [None, Some(parent)]) => {
                    Some(Link { hinge, body, parent, reversed: true })
                }
                _ => None,
            }
        });
        match next {
            Some(link) => {
                left.retain(|&hinge| hinge != link.hinge);
                links.push(link);
            }
            None => return links,
        }
    }
}
