//! Limbs of one shape, such as the legs of a robot: branches that leave the same body over hinges of the same kinds.

use super::{Chain, HingeKind, Layout, LinkId};
use std::mem::{Discriminant, discriminant};

/// Limbs of one shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LimbGroup {
    /// The links of each limb. Links with the same index correspond to each other.
    pub limbs: Vec<Vec<LinkId>>,
}

/// Returns all groups of limbs of one shape, with the links of `layout`. A limb that contains smaller limbs of one shape is
/// not divided if it has a partner itself.
pub fn limb_groups(chain: &Chain, layout: &Layout) -> Vec<LimbGroup> {
    let limbs = LimbSearch { chain, layout };
    let mut groups = Vec::new();
    limbs.search(None, &mut groups);
    groups
}

/// The shape of a branch: the kind of its first hinge, and the shapes of what follows.
#[derive(PartialEq)]
struct BranchShape {
    kind: Discriminant<HingeKind>,
    is_prescribed: bool,
    is_reversed: bool,
    branches: Vec<BranchShape>,
}

struct LimbSearch<'a> {
    chain: &'a Chain,
    layout: &'a Layout,
}

impl LimbSearch<'_> {
    /// Iterates over the links that follow a link, or the ground.
    fn following(&self, parent: Option<LinkId>) -> impl Iterator<Item = LinkId> {
        self.layout.links.enumerate().filter(move |(_, it)| it.parent == parent).map(|(id, _)| id)
    }

    fn shape(&self, link: LinkId) -> BranchShape {
        let of = &self.layout.links[link];
        let hinge = &self.chain.hinges[of.hinge];
        BranchShape {
            kind: discriminant(&hinge.kind),
            is_prescribed: hinge.is_prescribed(),
            is_reversed: of.reversed,
            branches: self.following(Some(link)).map(|next| self.shape(next)).collect(),
        }
    }

    /// Returns a link and all links outboard of it.
    fn limb(&self, link: LinkId) -> Vec<LinkId> {
        let outboard = self.following(Some(link)).flat_map(|next| self.limb(next));
        std::iter::once(link).chain(outboard).collect()
    }

    /// Adds the groups that leave a link, or the ground, and those inside of branches without a partner.
    fn search(&self, parent: Option<LinkId>, groups: &mut Vec<LimbGroup>) {
        let mut by_shape: Vec<(BranchShape, Vec<LinkId>)> = Vec::new();
        for link in self.following(parent) {
            let shape = self.shape(link);
            match by_shape.iter_mut().find(|(other, _)| *other == shape) {
                Some((_, links)) => links.push(link),
                None => by_shape.push((shape, vec![link])),
            }
        }
        for (_, links) in by_shape {
            match links[..] {
                [alone] => self.search(Some(alone), groups),
                _ => {
                    let limbs = links.into_iter().map(|link| self.limb(link)).collect();
                    groups.push(LimbGroup { limbs });
                }
            }
        }
    }
}
