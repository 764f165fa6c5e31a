//! Assigns the unknowns of limbs of one shape to each other.

use crate::ids::BodyId;
use crate::model::{Chain, InputKind, Layout, LimbGroup, Link, limb_groups};
use crate::passes::{Leaf, Limb, LimbQuantity, Limbs};
use crate::program::{Argument, Given, PACK};
use std::collections::HashMap;

/// The given vectors that have one entry for each rate.
const BY_RATE: [Given; 5] = [
    Given::Accelerations,
    Given::Vector,
    Given::VirtualRates,
    Given::CoordinateDirection,
    Given::RateDirection,
];

/// Returns the limbs of a chain, in groups of at most [`PACK`], and the unknowns that belong to them.
pub(super) fn limbs(chain: &Chain, layout: &Layout, merged: &Layout) -> Limbs {
    let mut limbs = Limbs { sizes: Vec::new(), leaves: HashMap::new() };
    if !chain.repeats.is_empty() {
        return limbs;
    }
    for LimbGroup { limbs: all } in limb_groups(chain, merged) {
        // A limb that is left over is computed alone.
        for group in all.chunks(PACK).filter(|group| group.len() > 1) {
            for (number, links) in group.iter().enumerate() {
                let limb = Limb { group: limbs.sizes.len(), number };
                for (place, &link) in links.iter().enumerate() {
                    let mut add = |(argument, entry), quantity, offset| {
                        let given = match argument {
                            Argument::Given(given) => Some(given),
                            _ => None,
                        };
                        let leaf = Leaf { limb, quantity, given, place, offset };
                        limbs.leaves.insert((argument, entry), leaf);
                    };
                    add_link((chain, layout), &merged.links[link], &mut add);
                }
            }
            limbs.sizes.push(group.len());
        }
    }
    limbs
}

/// Adds the unknowns of a link's hinge and of the loads and springs on its bodies, each with its index among its quantity.
fn add_link(
    (chain, layout): (&Chain, &Layout),
    link: &Link,
    add: &mut impl FnMut((Argument, usize), LimbQuantity, usize),
) {
    for (offset, entry) in layout.q[link.hinge].clone().enumerate() {
        add((Argument::Coordinates, entry), LimbQuantity::Coordinate, offset);
    }
    for (offset, entry) in layout.v[link.hinge].clone().enumerate() {
        let given = BY_RATE.map(Argument::Given);
        for argument in [Argument::Rates].into_iter().chain(given) {
            add((argument, entry), LimbQuantity::Rate, offset);
        }
    }
    let on_link = |body: BodyId| link.members.contains(&body);
    let mut loads = 0;
    for (id, input) in layout.inputs.enumerate() {
        let quantity = match input.what {
            InputKind::Efforts(hinge) if hinge == link.hinge => LimbQuantity::Effort,
            InputKind::Motion(hinge) if hinge == link.hinge => LimbQuantity::Motion,
            what if chain.body_of_input(what).is_some_and(on_link) => {
                loads += 1;
                LimbQuantity::Load(loads)
            }
            _ => continue,
        };
        for (offset, entry) in input.range.clone().enumerate() {
            add((Argument::Input(id), offset), quantity, offset);
            add((Argument::Given(Given::InputDirection), entry), quantity, offset);
        }
    }
}
