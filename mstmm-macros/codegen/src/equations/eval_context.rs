//! The evaluation context: a chain with its layout, symbol values, state and inputs. All equations
//! read their arguments from it.

use super::constraint_forces::{ConstraintRank, Rank};
use super::{LinkTree, LoopHook, SymbolValues};
use crate::ids::IdVec;
use crate::math::{Mat3, Motion, Scalar, Vec3};
use crate::model::{
    Attachment, BodyId, Chain, ClosureRank, Drive, Effort, Element, Frame, HingeId, InputKind,
    Layout, Link, MergedWeld, MovesWith, Source, SpringId,
};

/// Rounding that each link adds to a constraint of the loop hinge, in units in the last place.
const ROUNDINGS: f64 = 8.0;

/// Origin and rotation of a frame in another frame.
type Transform<S> = (Vec3<S>, Mat3<S>);

/// A chain in a given state.
#[derive(Clone, Debug)]
pub struct EvalContext<'a, S> {
    /// The chain.
    pub chain: &'a Chain,
    /// The layout of the chain's coordinates, rates, inputs and links.
    pub layout: &'a Layout,
    /// The values of the chain's symbols.
    pub values: &'a SymbolValues<S>,
    /// Coordinates.
    pub q: &'a [S],
    /// Rates.
    pub v: &'a [S],
    /// Inputs.
    pub inputs: &'a [S],
    /// The length of the step in s, if the accelerations are those of a linearly implicit Euler
    /// step.
    pub implicit: Option<S>,
    /// The accelerations `v̇` of the free rates, where they are given.
    pub accelerations: Option<&'a [S]>,
    /// A small displacement along the free rates, to which the equations hold to first order.
    pub displacement: Option<&'a [S]>,
    /// Whether some bodies have inertia in all directions only because of the loop constraints.
    pub held_by_closure: bool,
    /// The number of independent loop constraints.
    pub closure_rank: ClosureRank,
    /// The tree of links that the sweeps run over.
    pub tree: LinkTree<'a, S>,
    /// The frame of every body in the frame of its part.
    frames: IdVec<BodyId, Transform<S>>,
}

impl<'a, S: Scalar> EvalContext<'a, S> {
    /// Returns the context of `chain` at coordinates `q` and rates `v`, with `inputs`.
    pub fn new(
        chain: &'a Chain,
        layout: &'a Layout,
        values: &'a SymbolValues<S>,
        (q, v, inputs): (&'a [S], &'a [S], &'a [S]),
    ) -> Self {
        let mut context = EvalContext {
            chain,
            layout,
            values,
            q,
            v,
            inputs,
            implicit: None,
            accelerations: None,
            displacement: None,
            held_by_closure: false,
            closure_rank: ClosureRank::Unknown,
            tree: LinkTree::new(layout),
            frames: IdVec::new(),
        };
        context.frames = context.body_frames();
        context
    }

    /// Returns this context with the properties of the chain's loop constraints.
    pub fn with_closure(self, held_by_closure: bool, closure_rank: ClosureRank) -> Self {
        EvalContext { held_by_closure, closure_rank, ..self }
    }

    /// Returns this context with other inputs.
    pub fn with_inputs(self, inputs: &'a [S]) -> Self {
        EvalContext { inputs, ..self }
    }

    /// Returns this context for a linearly implicit Euler step of length `step`, in s.
    pub fn with_implicit_step(self, step: S) -> Self {
        EvalContext { implicit: Some(step), ..self }
    }

    /// Returns this context with given accelerations `v̇` of the free rates.
    pub fn with_accelerations(self, accelerations: &'a [S]) -> Self {
        EvalContext { accelerations: Some(accelerations), ..self }
    }

    /// Returns this context at coordinates that differ from `q` by a small displacement along the free
    /// rates. The equations hold to first order in it: they are exact if its values are dual numbers
    /// with the real part zero, or if it is set to zero after a differentiation.
    pub fn with_displacement(self, displacement: &'a [S]) -> Self {
        EvalContext { displacement: Some(displacement), ..self }
    }

    /// Returns this context with `hook` at the boundaries of repeated parts.
    pub fn with_loops(self, hook: &'a dyn LoopHook<S>) -> Self {
        EvalContext { tree: self.tree.with_loops(hook), ..self }
    }

    /// Returns the frames of all bodies. The frame of a merged body follows from the body that it
    /// is welded to.
    fn body_frames(&self) -> IdVec<BodyId, Transform<S>> {
        let mut frames = IdVec::filled(None, self.chain.bodies.len());
        for body in frames.ids() {
            let mut open = vec![body];
            while let Some(&last) = open.last() {
                match self.frame_across_weld(last, &frames) {
                    Ok(frame) => {
                        frames[last] = Some(frame);
                        open.pop();
                    }
                    Err(needed) => open.push(needed),
                }
            }
        }
        let required = |frame: Option<_>| frame.unwrap_or_else(|| bug!("a body has no frame"));
        frames.into_iter().map(required).collect()
    }

    /// Returns the frame of a body, or the body whose frame must be computed first.
    fn frame_across_weld(
        &self,
        body: BodyId,
        known: &IdVec<BodyId, Option<Transform<S>>>,
    ) -> Result<Transform<S>, BodyId> {
        let identity = (Vec3::zero(), Mat3::identity());
        let Some(MergedWeld { weld, reversed }) = self.layout.joined[body] else {
            return Ok(identity);
        };
        let hinge = &self.chain.hinges[weld];
        let (from, to) = if reversed {
            (&hinge.outboard, &hinge.inboard)
        } else {
            (&hinge.inboard, &hinge.outboard)
        };
        let outer = match from.body() {
            None => identity,
            Some(other) => known[other].ok_or(other)?,
        };
        let (from, to) =
            (self.values.local_frame(self.chain, from), self.values.local_frame(self.chain, to));
        let (origin, rotation) = compose(outer, from);
        let rotation = rotation * to.1.transposed();
        Ok((origin - rotation * to.0, rotation))
    }

    /// Returns the part that an attachment belongs to, with the origin and rotation of the
    /// attachment: in the frame of the part, or in the inertial frame if the part is the ground.
    pub fn frame_of(&self, attachment: &Attachment) -> (MovesWith, Vec3<S>, Mat3<S>) {
        let local = self.values.local_frame(self.chain, attachment);
        match attachment.body() {
            None => (MovesWith::Ground, local.0, local.1),
            Some(body) => {
                let (origin, rotation) = compose(self.frames[body], local);
                (self.layout.parts[body], origin, rotation)
            }
        }
    }

    /// Returns the frame of a body in the frame of its part.
    pub fn frame(&self, body: BodyId) -> (Vec3<S>, Mat3<S>) {
        self.frames[body]
    }

    /// Returns a frame that is fixed on a body, in the frame of the body's part.
    pub fn frame_on(&self, body: BodyId, frame: &Frame) -> (Vec3<S>, Mat3<S>) {
        compose(self.frames[body], self.values.frame(frame))
    }

    /// Returns the coordinates of a hinge.
    pub fn coordinates(&self, hinge: HingeId) -> &'a [S] {
        let count = self.chain.hinges[hinge].kind.coordinates();
        match self.prescribed(hinge) {
            Some(given) => &given[..count],
            None => &self.q[self.layout.q[hinge].clone()],
        }
    }

    /// Returns the rates of a hinge.
    pub fn rates(&self, hinge: HingeId) -> &'a [S] {
        let kind = &self.chain.hinges[hinge].kind;
        let (first, count) = (kind.coordinates(), kind.dof_count());
        match self.prescribed(hinge) {
            Some(given) => &given[first..first + count],
            None => &self.v[self.layout.v[hinge].clone()],
        }
    }

    /// Returns the displacement of a hinge along its rates, if there is one.
    pub fn displacement(&self, hinge: HingeId) -> Option<&'a [S]> {
        let displacement = self.displacement.filter(|_| self.prescribed(hinge).is_none());
        displacement.map(|all| &all[self.layout.v[hinge].clone()])
    }

    /// Returns the given accelerations of the rates of a hinge, if they are given and free.
    pub fn given_accelerations(&self, hinge: HingeId) -> Option<&'a [S]> {
        let accelerations = self.accelerations.filter(|_| self.prescribed(hinge).is_none());
        accelerations.map(|all| &all[self.layout.v[hinge].clone()])
    }

    /// Returns the entries for a hinge of the vector that a matrix is multiplied with, which takes the place of the
    /// accelerations; none if its motion is prescribed, since it has no free rates.
    pub fn factors(&self, hinge: HingeId) -> &'a [S] {
        let Some(vector) = self.accelerations else { bug!("a product lacks its vector") };
        match self.prescribed(hinge) {
            Some(_) => &[],
            None => &vector[self.layout.v[hinge].clone()],
        }
    }

    /// Returns the accelerations of a hinge whose motion is prescribed.
    pub fn prescribed_accelerations(&self, hinge: HingeId) -> Option<&'a [S]> {
        let kind = &self.chain.hinges[hinge].kind;
        self.prescribed(hinge).map(|given| &given[kind.coordinates() + kind.dof_count()..])
    }

    fn prescribed(&self, hinge: HingeId) -> Option<&'a [S]> {
        let prescribed = self.chain.hinges[hinge].is_prescribed();
        prescribed.then(|| &self.inputs[self.layout.input(InputKind::Motion(hinge))])
    }

    /// Returns the actuator efforts of a hinge, one for each rate.
    pub fn actuator_efforts(&self, hinge: HingeId) -> Vec<S> {
        let Drive::Efforts(efforts) = &self.chain.hinges[hinge].drive else {
            return vec![S::zero(); self.chain.hinges[hinge].kind.dof_count()];
        };
        let is_input = |effort: &&Effort| **effort == Effort::Input;
        let value = |(index, effort)| {
            let input =
                (InputKind::Efforts(hinge), efforts[..index].iter().filter(is_input).count());
            self.effort(effort, input).unwrap_or_else(S::zero)
        };
        efforts.iter().enumerate().map(value).collect()
    }

    /// Returns the force of a spring's actuator, if it has one.
    pub fn spring_force(&self, spring: SpringId) -> Option<S> {
        self.effort(&self.chain.springs[spring].force, (InputKind::SpringForce(spring), 0))
    }

    /// Returns an effort, which may be this component of an input.
    fn effort(&self, effort: &Effort, (what, component): (InputKind, usize)) -> Option<S> {
        match effort {
            Effort::Free => None,
            Effort::Constant(value) => Some(self.values.scalar(value)),
            Effort::Input => Some(self.inputs[self.layout.input(what)][component]),
        }
    }

    /// Returns a vector that may be an input. An input has components along `axes` only; the other
    /// components are zero.
    pub fn vector(&self, source: &Source, what: InputKind, axes: &[usize]) -> Vec3<S> {
        match source {
            Source::Nothing => Vec3::zero(),
            Source::Constant(values) => self.values.vector(values),
            Source::Input => {
                let component = |k: usize| self.inputs[self.layout.input(what)][k];
                Vec3(
                    [0, 1, 2].map(|k| {
                        axes.iter().position(|&axis| axis == k).map_or(S::zero(), component)
                    }),
                )
            }
        }
    }

    /// Returns the rank of the loop constraints and the rounding of their rows; `held` is the
    /// number of constraints.
    pub fn constraint_rank(&self, held: usize) -> ConstraintRank<S> {
        let rank = match self.closure_rank {
            // In an implicit step, springs and dampers add constraints with their own inertia. Each
            // of them is independent of all others.
            ClosureRank::Known { rank, directions } => Rank::Known(rank + added(held, directions)),
            ClosureRank::Unknown | ClosureRank::FoundAtRunTime(_) => {
                let steps = &self.values.closure_steps;
                let ones = std::iter::repeat_n(S::one(), added(held, steps.len()));
                Rank::AtRunTime(ones.chain(steps.iter().copied()).collect())
            }
        };
        let times = |link: &Link| self.chain.repetitions(Element::Hinge(link.hinge));
        let links: usize = self.layout.links.iter().map(times).sum();
        ConstraintRank { rank, rounding: ROUNDINGS * (links + 2) as f64 }
    }

    /// Returns the acceleration of the base that replaces gravity. This costs less than a force on
    /// every body.
    pub fn base_acceleration(&self) -> Motion<S> {
        let Chain { gravity, dimension, .. } = self.chain;
        let gravity = self.vector(gravity, InputKind::Gravity, dimension.translations());
        Motion { linear: -gravity, angular: Vec3::zero() }
    }
}

/// Returns the number of constraints that an implicit step adds to those of the loop hinge.
fn added(held: usize, directions: usize) -> usize {
    held.checked_sub(directions)
        .unwrap_or_else(|| bug!("a closing hinge holds {held} of {directions} directions"))
}

/// Returns a frame that is given in `outer`, in the frame that `outer` is given in.
fn compose<S: Scalar>(outer: (Vec3<S>, Mat3<S>), inner: (Vec3<S>, Mat3<S>)) -> (Vec3<S>, Mat3<S>) {
    (outer.0 + outer.1 * inner.0, outer.1 * inner.1)
}
