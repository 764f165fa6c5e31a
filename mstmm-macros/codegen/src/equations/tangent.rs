//! The equations along a direction: a chain in a given state whose coordinates, rates, inputs and
//! parameters change along one direction. All equations run on dual numbers, so every result comes with
//! its derivative along the direction.
//!
//! Coordinates change along the rates: the small displacement `dq = N(q) δ` of a direction `δ` with one
//! entry for each rate.

use super::sweep::{Channel, LoopHook};
use super::{EvalContext, SymbolValues};
use crate::math::{Dual, Scalar};

/// A direction in which a chain changes. An empty vector stands for zeros.
#[derive(Clone, Debug)]
pub struct Direction<S> {
    /// Along the rates: the small displacement `δ` of the coordinates.
    pub coordinates: Vec<S>,
    /// The change of the rates.
    pub rates: Vec<S>,
    /// The change of the accelerations, where they are given.
    pub accelerations: Vec<S>,
    /// The change of the inputs.
    pub inputs: Vec<S>,
    /// The change of the parameters.
    pub parameters: Vec<S>,
}

impl<S> Default for Direction<S> {
    /// Nothing changes.
    fn default() -> Self {
        Direction {
            coordinates: Vec::new(),
            rates: Vec::new(),
            accelerations: Vec::new(),
            inputs: Vec::new(),
            parameters: Vec::new(),
        }
    }
}

/// The arguments of a chain as dual numbers, from which [`Tangent::context`] makes a context.
#[derive(Debug)]
pub struct Tangent<'a, S> {
    values: SymbolValues<Dual<S>>,
    q: Vec<Dual<S>>,
    v: Vec<Dual<S>>,
    inputs: Vec<Dual<S>>,
    displacement: Vec<Dual<S>>,
    accelerations: Option<Vec<Dual<S>>>,
    hook: Option<DualLoops<'a, S>>,
}

impl<'a, S: Scalar> Tangent<'a, S> {
    /// Returns the arguments of `context` that change along `direction`.
    pub fn new(context: &EvalContext<'a, S>, direction: &Direction<S>) -> Self {
        let values = context.values;
        let displacement = vec![S::zero(); context.v.len()];
        Tangent {
            values: SymbolValues {
                parameters: dual(&values.parameters, &direction.parameters),
                constants: dual(&values.constants, &[]),
                closure_steps: dual(&values.closure_steps, &[]),
            },
            q: dual(context.q, &[]),
            v: dual(context.v, &direction.rates),
            inputs: dual(context.inputs, &direction.inputs),
            displacement: dual(&displacement, &direction.coordinates),
            accelerations: context.accelerations.map(|a| dual(a, &direction.accelerations)),
            hook: context.tree.hook().map(DualLoops),
        }
    }

    /// Returns the context in which the equations of `context` run on dual numbers.
    pub fn context<'b>(&'b self, context: &EvalContext<'b, S>) -> EvalContext<'b, Dual<S>> {
        let state = (&self.q[..], &self.v[..], &self.inputs[..]);
        let dual = EvalContext::new(context.chain, context.layout, &self.values, state)
            .with_closure(context.held_by_closure, context.closure_rank)
            .with_displacement(&self.displacement);
        let dual = match &self.accelerations {
            Some(accelerations) => dual.with_accelerations(accelerations),
            None => dual,
        };
        match &self.hook {
            Some(hook) => dual.with_loops(hook),
            None => dual,
        }
    }
}

/// Returns dual numbers with these values and derivatives; no derivatives stand for zeros.
fn dual<S: Scalar>(values: &[S], derivatives: &[S]) -> Vec<Dual<S>> {
    if derivatives.is_empty() {
        return values.iter().map(|&value| Dual::new(value, S::zero())).collect();
    }
    if derivatives.len() != values.len() {
        bug!("{} values have {} derivatives", values.len(), derivatives.len())
    }
    values.iter().zip(derivatives).map(|(&value, &by)| Dual::new(value, by)).collect()
}

/// Replaces dual numbers at the boundaries of repeated parts: their values as the equations without
/// derivatives do, so that both share loops, and then their derivatives.
#[derive(Debug)]
struct DualLoops<'a, S>(&'a dyn LoopHook<S>);

impl<S: Scalar> LoopHook<Dual<S>> for DualLoops<'_, S> {
    fn enter(&self, channel: Channel, inward: bool, first: &[Dual<S>]) -> Vec<Dual<S>> {
        let (values, derivatives) = parts(first);
        let values = self.0.enter(channel, inward, &values);
        let derivatives = self.0.enter(channel, inward, &derivatives);
        dual(&values, &derivatives)
    }

    fn leave(&self, channel: Channel, any: &[Dual<S>]) -> Vec<Dual<S>> {
        let (values, derivatives) = parts(any);
        // A loop hook ends what it has begun last.
        let derivatives = self.0.leave(channel, &derivatives);
        let values = self.0.leave(channel, &values);
        dual(&values, &derivatives)
    }
}

fn parts<S: Scalar>(numbers: &[Dual<S>]) -> (Vec<S>, Vec<S>) {
    numbers.iter().map(|number| (number.value(), number.derivative())).unzip()
}
