//! The linear problem that both methods solve: how the links move under given loads, efforts and
//! velocities, with or without a closing hinge.

use super::closing::Closing;
use super::motion::LinkMotion;
use super::passage::Passage;
use crate::math::{Motion, Scalar, Wrench};
use crate::model::Dimension;

/// What the links are to do. `a` may be accelerations, or changes of velocities.
#[derive(Clone, Debug)]
pub struct Problem<'a, S> {
    /// The links.
    pub links: &'a [LinkMotion<S>],
    /// The directions that matter.
    pub dimension: Dimension,
    /// What happens at the seams of repeated parts.
    pub passage: Passage<'a, S>,
    /// What joins `a` at every link on the way from its parent.
    pub drift: Vec<Motion<S>>,
    /// The part of the wrench at every link's point that does not hang on `a`, of its part alone.
    pub loads: Vec<Wrench<S>>,
    /// Efforts along the columns of every link.
    pub efforts: Vec<Vec<S>>,
    /// `a` of the ground.
    pub ground: Motion<S>,
    /// The hinge that closes the chain, with what it demands, if there is one.
    pub closing: Option<Demand<'a, S>>,
}

/// What a closing hinge demands.
#[derive(Clone, Debug)]
pub struct Demand<'a, S> {
    /// The hinge.
    pub closing: &'a Closing<S>,
    /// What `a` of the point reached from the inboard side has to be along each of the closing's
    /// directions: `r_j` of `T_jᵀ a = r_j`.
    pub reached: Vec<S>,
    /// The wrench in the closing hinge that does not hang on its reactions.
    pub given: Wrench<S>,
}

/// How the links move.
#[derive(Clone, Debug)]
pub struct Movement<S> {
    /// Amounts of every link's free columns.
    pub amounts: Vec<Vec<S>>,
    /// `a` of every link's point.
    pub points: Vec<Motion<S>>,
    /// Reactions along the closing's directions.
    pub reactions: Vec<S>,
    /// Reactions that make no difference to the movement, one for each of the closing's directions;
    /// zeros where there is none.
    pub undetermined: Vec<Vec<S>>,
}

impl<S: Scalar> Problem<'_, S> {
    /// `a` of a link's point but for the hinge's own columns.
    pub fn carried(&self, index: usize, points: &[Motion<S>]) -> Motion<S> {
        let link = &self.links[index];
        let parent = link.parent.map_or(self.ground, |parent| points[parent]);
        link.over.carried(parent) + self.drift[index]
    }

    /// The wrenches with which the closing's reactions pull at the link that it hangs on, about its
    /// point, and that link.
    pub fn pulls(&self) -> Option<(usize, Vec<Wrench<S>>)> {
        let closing = self.closing.as_ref()?.closing;
        let parent = closing.parent?;
        let pulls = closing.held.iter().map(|held| closing.over.returned(held.wrench)).collect();
        Some((parent, pulls))
    }

    /// What the closing demands where it hangs on the ground, or on no link at all.
    pub fn at_rest(&self) -> Vec<S> {
        let Some(Demand { closing, .. }) = &self.closing else { return Vec::new() };
        let a = closing.over.carried(self.ground);
        closing.held.iter().map(|held| a.power(held.wrench)).collect()
    }
}

/// `Σ motion · amount` of columns.
pub fn moved<S: Scalar>(link: &LinkMotion<S>, amounts: &[S]) -> Motion<S> {
    let columns = link.over.freedom.columns.iter().map(|column| column.motion());
    columns.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
