//! A chain in numbers: somewhere around its start, put onto its closure, solved.

use crate::equations::{
    self, Axes, EvalContext, ForwardDynamics, SweepResult, SymbolValues, Trace,
};
use crate::math::Structured;
use crate::model::{Chain, ClosureRank, InputKind, Layout, SolutionMethod};

/// Corrections that put a chain onto its closure; they converge quadratically where they do. After so
/// many that bring it no nearer it is given up.
const CORRECTIONS: usize = 100;
const PATIENCE: usize = 5;
/// A residual in m, rad, m/s and rad/s that counts as closed.
const CLOSED: f64 = 1e-9;

pub(super) type Number = Structured<f64>;

/// The chain's numbers with parameters at their defaults. Rust constants, which are not known, are any
/// numbers, others for every seed.
pub(super) fn numbers(chain: &Chain, seed: usize) -> SymbolValues<Number> {
    let any = |constant: usize| 0.5 + scattered(constant + 1, seed + 1);
    let constants = (0..chain.constants).map(|constant| Number::variable(any(constant))).collect();
    let mut numbers = SymbolValues { constants, ..SymbolValues::default() };
    let defaults = chain.parameters.iter().map(|parameter| {
        // No default uses another parameter.
        Number::variable(numbers.scalar(&parameter.default).value())
    });
    numbers.parameters = defaults.collect();
    numbers
}

/// Numbers from 0 to 1 as far from each other as they can be: multiples of the golden ratio.
fn scattered(number: usize, seed: usize) -> f64 {
    (number as f64 * seed as f64 * 0.618_033_988_749_895).fract()
}

/// By how much a coordinate differs from the start: by nothing for the first seed, up to a half for others.
fn around(number: usize, seed: usize) -> f64 {
    if seed == 0 { 0.0 } else { scattered(number, seed) - 0.5 }
}

/// Coordinates, and inputs with motions that are prescribed.
pub(super) struct Configuration {
    pub q: Vec<Number>,
    pub inputs: Vec<Number>,
}

/// A chain without repeated parts and its numbers.
pub(super) struct DryRun {
    pub chain: Chain,
    pub layout: Layout,
    /// The layout with welded bodies merged, which has the same hinges in the same places.
    pub merged: Layout,
    pub numbers: SymbolValues<Number>,
    /// Whether what closes the chain holds what has no inertia otherwise.
    pub held_by_closure: bool,
}

impl DryRun {
    pub fn new(chain: Chain) -> Self {
        let (layout, merged) = (Layout::of(&chain), Layout::merged(&chain));
        DryRun { numbers: numbers(&chain, 0), chain, layout, merged, held_by_closure: false }
    }

    pub fn context<'a>(
        &'a self,
        layout: &'a Layout,
        numbers: &'a SymbolValues<Number>,
        state: (&'a [Number], &'a [Number], &'a [Number]),
    ) -> EvalContext<'a, Number> {
        let context = EvalContext::new(&self.chain, layout, numbers, state);
        context.with_closure(self.held_by_closure, ClosureRank::Unknown)
    }

    pub fn solved(
        &self,
        numbers: &SymbolValues<Number>,
        pose: &Configuration,
    ) -> ForwardDynamics<Number> {
        let (v, Configuration { q, inputs }) = (self.at_rest(), pose);
        let context = self.context(&self.merged, numbers, (q, &v, inputs));
        equations::forward_dynamics(
            &context,
            SolutionMethod::Riccati,
            Axes::Body,
            &mut Trace::silent(),
        )
    }

    pub fn swept(
        &self,
        numbers: &SymbolValues<Number>,
        pose: &Configuration,
    ) -> (ForwardDynamics<Number>, SweepResult<Number>) {
        let (v, Configuration { q, inputs }) = (self.at_rest(), pose);
        let context = self.context(&self.merged, numbers, (q, &v, inputs));
        equations::forward_dynamics_with_wrenches(
            &context,
            SolutionMethod::Riccati,
            Axes::Body,
            &mut Trace::silent(),
        )
    }

    /// The coordinates put onto the closure; nothing if that leads nowhere.
    pub fn closed(&self, pose: Configuration) -> Option<Configuration> {
        let (v, Configuration { mut q, inputs }) = (self.at_rest(), pose);
        let (mut nearest, mut stalled) = (f64::INFINITY, 0);
        for _ in 0..CORRECTIONS {
            let context = self.context(&self.merged, &self.numbers, (&q, &v, &inputs));
            let correction = equations::project(&context, &mut Trace::silent())?;
            let residual = correction.residual.value();
            if residual < CLOSED {
                return Some(Configuration { q, inputs });
            }
            // Written so that NaN is no progress.
            stalled = if residual < 0.9 * nearest { 0 } else { stalled + 1 };
            if stalled > PATIENCE {
                return None;
            }
            nearest = nearest.min(residual);
            q = equations::displace(&self.chain, &self.merged, &q, &correction.coordinates);
        }
        None
    }

    /// The start with what is prescribed at rest, or somewhere around them.
    pub fn pose(&self, numbers: &SymbolValues<Number>, seed: usize) -> Configuration {
        Configuration { q: self.coordinates(numbers, seed), inputs: self.inputs(seed) }
    }

    /// The start, or somewhere around it: every coordinate by up to a half.
    fn coordinates(&self, numbers: &SymbolValues<Number>, seed: usize) -> Vec<Number> {
        let mut count = 0;
        let free = self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
        let coordinates = free.flat_map(|hinge| {
            let near: Vec<Number> = hinge
                .start
                .iter()
                .map(|start| {
                    count += 1;
                    Number::variable(numbers.scalar(start).value() + around(count, seed))
                })
                .collect();
            equations::hinge::normalized(&hinge.kind, &near)
        });
        coordinates.collect()
    }

    pub fn at_rest(&self) -> Vec<Number> {
        vec![Number::variable(0.0); self.merged.dof_count()]
    }

    /// Prescribed motions at rest in the zero position, or around it, and nothing that drives.
    fn inputs(&self, seed: usize) -> Vec<Number> {
        let total = self.merged.inputs.iter().map(|input| input.range.len());
        let mut inputs = vec![Number::variable(0.0); total.sum()];
        // Numbered after the coordinates, whose deviations they should not repeat.
        let mut count = self.merged.coordinates();
        for input in &self.merged.inputs {
            let InputKind::Motion(hinge) = input.what else { continue };
            let kind = &self.chain.hinges[hinge].kind;
            let near = kind.spec().coordinates.iter().map(|coordinate| {
                count += 1;
                Number::variable(coordinate.rest + around(count, seed))
            });
            let near = equations::hinge::normalized(kind, &near.collect::<Vec<_>>());
            inputs[input.range.clone()][..near.len()].copy_from_slice(&near);
        }
        inputs
    }
}
