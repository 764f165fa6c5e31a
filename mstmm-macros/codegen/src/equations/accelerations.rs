//! Accelerations of all hinges, by either method.

use super::{Axes, LinkMotion, Situation, Trace, motion, riccati, transfer};
use crate::math::Scalar;
use crate::model::Method;

/// A number that must be positive if the accelerations are to mean anything.
#[derive(Clone, Copy, Debug)]
pub struct Pivot<S> {
    /// Index of the link that it belongs to.
    pub link: usize,
    /// The number.
    pub value: S,
    /// What it is measured by: rounding leaves a few units in the last place of this number.
    pub scale: S,
}

/// The result of a method.
#[derive(Clone, Debug)]
pub struct Solved<S> {
    /// `v̇` in the layout's order.
    pub accelerations: Vec<S>,
    /// The numbers divided by on the way.
    pub pivots: Vec<Pivot<S>>,
}

/// Solves for the accelerations of all hinges.
pub fn accelerations<S: Scalar>(
    situation: &Situation<S>,
    method: Method,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Solved<S> {
    let links = motion(situation, axes, trace);
    let efforts = efforts(situation, &links);
    let ground = situation.ground();
    let (amounts, pivots) = match method {
        Method::Riccati => riccati::solve(&links, &efforts, ground, trace),
        Method::Transfer => {
            let amounts = transfer::solve(&links, &efforts, ground, trace);
            (amounts, riccati::pivots(&links, trace))
        }
    };
    let layout = situation.layout;
    let mut accelerations = vec![S::zero(); layout.freedoms()];
    for (index, link) in links.iter().enumerate() {
        let range = layout.v[layout.links[index].hinge].clone();
        accelerations[range].copy_from_slice(&link.freedom.rates(&amounts[index]));
    }
    Solved { accelerations, pivots }
}

/// Each link's efforts along its columns.
fn efforts<S: Scalar>(situation: &Situation<S>, links: &[LinkMotion<S>]) -> Vec<Vec<S>> {
    let Situation { chain, layout, numbers, inputs, .. } = *situation;
    let all = numbers.efforts(chain, layout, inputs);
    let of = |(index, link): (usize, &LinkMotion<S>)| {
        link.freedom.amounts(&all[layout.v[layout.links[index].hinge].clone()])
    };
    links.iter().enumerate().map(of).collect()
}
