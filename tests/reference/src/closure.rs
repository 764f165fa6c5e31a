//! States of closed chains that fulfil the loop constraint.

use crate::chain::{Chain, State};
use crate::drives::Drives;
use crate::mechanism::{FrameState, Mechanism};
use crate::moved::moved_coordinates;
use crate::relative::{Twist, to_inertial, twist};
use crate::rotation::{self, Vec3};
use nalgebra::{DMatrix, DVector, Dyn, Matrix6xX, SVD};

/// The largest number of steps of Newton's method.
const STEPS: usize = 60;
/// The largest position error of the loop constraint, in m and rad.
const GAP: f64 = 1e-12;
/// The longest step in the hinges' coordinates.
const LONGEST_STEP: f64 = 0.5;
/// Singular values of the constraint Jacobian below this count as zero, relative to the largest.
const RANK_TOLERANCE: f64 = 1e-8;

/// The error of the loop constraint at the finish of a closed chain, and its Jacobian.
struct Closure {
    /// The displacement of the end of the chain from the frame: a translation and a rotation vector
    /// in inertial axes, reduced to the directions that the dimension has.
    gap: DVector<f64>,
    /// The velocity of the end of the chain relative to the frame, in the same way.
    gap_rate: DVector<f64>,
    /// The derivative of `gap_rate` by the rates of the state, one column per rate.
    jacobian: DMatrix<f64>,
    /// The singular value decomposition of the Jacobian, if there are any rates.
    decomposed: Option<SVD<f64, Dyn, Dyn>>,
}

impl Chain {
    /// Returns a state close to `guess` in which the closed chain closes, or `None` if Newton's method
    /// does not converge. Coordinates are corrected first, then rates.
    pub fn close(&self, guess: &State, drives: &Drives) -> Option<State> {
        self.check_lengths(guess, drives);
        let mechanism = Mechanism::new(self, drives);
        let mut state = guess.clone();
        let mut closure = Closure::new(&mechanism, &state);
        for _ in 0..STEPS {
            // One more step after convergence reduces the error to rounding.
            let close_enough = closure.gap.amax() < GAP;
            let mut step = closure.least(&-&closure.gap);
            step *= (LONGEST_STEP / step.norm()).min(1.0);
            state.q = stepped(&mechanism, &state, &step);
            closure = Closure::new(&mechanism, &state);
            if close_enough {
                break;
            }
        }
        let change = closure.least(&-&closure.gap_rate);
        state.v.iter_mut().zip(change.iter()).for_each(|(rate, change)| *rate += change);
        let closure = Closure::new(&mechanism, &state);
        let closes = closure.gap.amax() < GAP && closure.gap_rate.amax() < 1e3 * GAP;
        closes.then_some(state)
    }

    /// Returns the smallest nonzero singular value of the constraint Jacobian of a closed chain in the
    /// given state, and the number of nonzero singular values.
    pub fn closure_strength(&self, state: &State, drives: &Drives) -> (f64, usize) {
        let mechanism = Mechanism::new(self, drives);
        let decomposed = Closure::new(&mechanism, state).decomposed;
        let values: Vec<f64> =
            decomposed.iter().flat_map(|d| d.singular_values.iter().copied()).collect();
        let greatest = values.iter().copied().fold(0.0, f64::max);
        let counting = values.iter().filter(|value| **value > RANK_TOLERANCE * greatest);
        (counting.clone().fold(f64::INFINITY, |least, value| least.min(*value)), counting.count())
    }
}

impl Closure {
    fn new(mechanism: &Mechanism, state: &State) -> Closure {
        let finish = finish_of(mechanism);
        let (end, turned) = reached(mechanism, state);
        let mut columns: Vec<Twist> = Vec::new();
        for (origin, directions) in turned {
            columns.extend(directions.column_iter().map(|direction| {
                let spin: Vec3 = direction.fixed_rows::<3>(3).into();
                let velocity = direction.fixed_rows::<3>(0) + spin.cross(&(end.position - origin));
                twist(velocity, spin)
            }));
        }
        let turn = rotation::to_vector(&(end.rotation * finish.rotation.transpose()));
        let gap = twist(end.position - finish.position, turn);
        let gap_rate = twist(end.velocity - finish.velocity, end.spin - finish.spin);
        let kept = mechanism.chain.dimension.directions();
        let select = |all: Twist| DVector::from_iterator(kept.len(), kept.iter().map(|k| all[*k]));
        let jacobian =
            DMatrix::from_fn(kept.len(), columns.len(), |row, column| columns[column][kept[row]]);
        let decomposed = (!columns.is_empty()).then(|| jacobian.clone().svd(true, true));
        Closure { gap: select(gap), gap_rate: select(gap_rate), jacobian, decomposed }
    }

    /// Returns the least-squares change of the rates, of minimum norm, that moves the end of the chain
    /// as wanted.
    fn least(&self, wanted: &DVector<f64>) -> DVector<f64> {
        let change = self.decomposed.as_ref().map(|decomposed| {
            let tolerance = RANK_TOLERANCE * decomposed.singular_values.max();
            decomposed.solve(wanted, tolerance).expect("both sides have been decomposed")
        });
        change.unwrap_or_else(|| DVector::zeros(self.jacobian.ncols()))
    }
}

/// Returns the frame that a closed chain has to meet.
pub(crate) fn finish_of(mechanism: &Mechanism) -> FrameState {
    let closing = mechanism.closing().expect("a closed chain");
    mechanism.frame_motion(&closing.outboard, &[])
}

/// Returns the end of a closed chain, computed from its start over all hinges.
pub(crate) fn end_of_chain(mechanism: &Mechanism, state: &State) -> FrameState {
    reached(mechanism, state).0
}

/// Returns the end of the chain, computed from its start, and for every hinge that is not prescribed
/// the outboard origin and the twists of its rates, in inertial axes. Hinges of branches do not move
/// the end: their twists are zero.
fn reached(mechanism: &Mechanism, state: &State) -> (FrameState, Vec<(Vec3, Matrix6xX<f64>)>) {
    let motions = mechanism.motions(state);
    let on_loop = loop_joints(mechanism);
    let mut end = FrameState::at_rest(Vec3::zeros(), rotation::from_vector(&Vec3::zeros()));
    let mut moving = Vec::new();
    for (joint, on_loop) in mechanism.joints.iter().zip(on_loop) {
        let inboard = mechanism.frame_motion(&joint.inboard, &motions);
        if on_loop {
            end = joint.outboard_motion(state, &inboard);
        }
        if joint.prescribed.is_none() {
            let relative = joint.kind().relative(joint.q(state), joint.v(state));
            let mut directions = to_inertial(&inboard.rotation) * relative.directions;
            if !on_loop {
                directions.fill(0.0);
            }
            moving.push((end.position, directions));
        }
    }
    (end, moving)
}

/// Returns for every hinge whether it is on the way from the start of a closed chain to its finish.
fn loop_joints(mechanism: &Mechanism) -> Vec<bool> {
    let mut on_loop = vec![false; mechanism.joints.len()];
    let closing = mechanism.closing().expect("a closed chain");
    let mut side = closing.outboard;
    // Written order goes outboard, so the hinges of the loop are met in reverse order.
    for (number, joint) in mechanism.joints.iter().enumerate().rev() {
        let same_body = side.body().is_some() && joint.outboard.body() == side.body();
        if joint.outboard == side || same_body {
            on_loop[number] = true;
            side = joint.inboard;
        }
    }
    on_loop
}

/// Returns the coordinates of a closed chain after a small step along its rates.
fn stepped(mechanism: &Mechanism, state: &State, step: &DVector<f64>) -> Vec<f64> {
    let free = mechanism.joints.iter().filter(|joint| joint.prescribed.is_none());
    let own = free.map(|joint| {
        let step = step.rows(joint.first_rate, joint.kind().dof_count());
        let still = vec![0.0; step.len()];
        moved_coordinates(joint.hinge, joint.q(state), [step.into_owned().as_slice(), &still], 1.0)
    });
    own.collect::<Vec<_>>().concat()
}
