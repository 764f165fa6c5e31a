//! A dry run of a chain with numbers: at its start and nearby, projected onto its loop constraints.

use crate::equations::{
    self, Axes, EvalContext, ForwardDynamics, SweepResult, SymbolValues, Trace,
};
use crate::math::{CORRECTIONS, LARGEST_ROTATION, Structured};
use crate::model::{
    Chain, ClosureRank, DofGroup, HingeKind, InputKind, Layout, RotationCoordinates,
    SolutionMethod, rotation_coordinates,
};
use std::ops::Range;

/// The relative residual below which a chain counts as closed.
const CLOSED: f64 = 1e-9;

pub(super) type Number = Structured<f64>;

/// Returns the values of the chain's symbols, with parameters at their defaults. Rust constants are
/// not known while compiling; they get arbitrary values that depend on the seed.
pub(super) fn values(chain: &Chain, seed: usize) -> SymbolValues<Number> {
    let any = |constant: usize| 0.5 + low_discrepancy(constant + 1, seed + 1);
    let constants = (0..chain.constants).map(|constant| Number::variable(any(constant))).collect();
    let mut values = SymbolValues { constants, ..SymbolValues::default() };
    let defaults = chain.parameters.iter().map(|parameter| {
        // A default never depends on another parameter.
        Number::variable(values.scalar(&parameter.default).value())
    });
    values.parameters = defaults.collect();
    values
}

/// Returns evenly spread numbers from 0 to 1: multiples of the golden ratio.
pub(super) fn low_discrepancy(number: usize, seed: usize) -> f64 {
    (number as f64 * seed as f64 * 0.618_033_988_749_895).fract()
}

/// The number of the first input among the numbers of a motion, above those of rates and accelerations.
const OF_INPUTS: usize = 10_000;

/// Returns evenly spread numbers from −2 to 2.
pub(super) fn near_zero(number: usize, seed: usize) -> Number {
    Number::variable(4.0 * low_discrepancy(number, seed) - 2.0)
}

/// Returns the deviation of a coordinate from the start in units of the coordinate: zero for the first seed, up to a half
/// for others.
fn deviation(number: usize, seed: usize) -> f64 {
    if seed == 0 { 0.0 } else { low_discrepancy(number, seed) - 0.5 }
}

/// Coordinates, and inputs with prescribed motions.
pub(super) struct Configuration {
    pub q: Vec<Number>,
    pub inputs: Vec<Number>,
}

/// A chain without repeated parts, with numbers.
pub(super) struct DryRun {
    pub chain: Chain,
    pub layout: Layout,
    /// The layout with welded bodies merged. Its hinges have the same ids.
    pub merged: Layout,
    pub values: SymbolValues<Number>,
    /// The size of the chain at its start in m: deviations of translations are relative to it.
    pub size: f64,
    /// Whether some bodies have inertia in all directions only because of the loop constraints.
    pub held_by_closure: bool,
}

impl DryRun {
    pub fn new(chain: Chain) -> Self {
        let (layout, merged) = (Layout::of(&chain), Layout::merged(&chain));
        let values = values(&chain, 0);
        let mut dry_run =
            DryRun { values, chain, layout, merged, size: 1.0, held_by_closure: false };
        let (v, pose) = (dry_run.at_rest(), dry_run.pose(&dry_run.values, 0));
        let state = (&pose.q[..], &v[..], &pose.inputs[..]);
        let size = equations::size(&dry_run.context(&dry_run.merged, &dry_run.values, state));
        if size.value().is_normal() {
            dry_run.size = size.value();
        }
        dry_run
    }

    /// Returns the units of the coordinates of a hinge, or of other quantities that `of` selects in its groups: the size of
    /// the chain for translations, one for rotations.
    pub fn units(
        &self,
        kind: &HingeKind,
        of: impl Fn(&DofGroup) -> Range<usize>,
    ) -> impl Iterator<Item = f64> {
        let unit = |group: &DofGroup| if group.rotational { 1.0 } else { self.size };
        kind.spec().groups.iter().flat_map(move |group| of(group).map(move |_| unit(group)))
    }

    pub fn context<'a>(
        &'a self,
        layout: &'a Layout,
        values: &'a SymbolValues<Number>,
        state: (&'a [Number], &'a [Number], &'a [Number]),
    ) -> EvalContext<'a, Number> {
        let context = EvalContext::new(&self.chain, layout, values, state);
        context.with_closure(self.held_by_closure, ClosureRank::Unknown)
    }

    pub fn solved(
        &self,
        values: &SymbolValues<Number>,
        pose: &Configuration,
    ) -> ForwardDynamics<Number> {
        let (v, Configuration { q, inputs }) = (self.at_rest(), pose);
        let context = self.context(&self.merged, values, (q, &v, inputs));
        equations::forward_dynamics(
            &context,
            SolutionMethod::Riccati,
            Axes::Body,
            &mut Trace::silent(),
        )
    }

    pub fn swept(
        &self,
        values: &SymbolValues<Number>,
        pose: &Configuration,
    ) -> (ForwardDynamics<Number>, SweepResult<Number>) {
        let (v, Configuration { q, inputs }) = (self.at_rest(), pose);
        let context = self.context(&self.merged, values, (q, &v, inputs));
        equations::forward_dynamics_with_wrenches(
            &context,
            SolutionMethod::Riccati,
            Axes::Body,
            &mut Trace::silent(),
        )
    }

    /// Returns the configuration projected onto the loop constraints as `assemble` does it, or `None` without convergence.
    pub fn closed(&self, pose: Configuration) -> Option<Configuration> {
        let (v, Configuration { mut q, inputs }) = (self.at_rest(), pose);
        for _ in 0..CORRECTIONS {
            let context = self.context(&self.merged, &self.values, (&q, &v, &inputs));
            let correction = equations::project(&context, &mut Trace::silent())?;
            let residual = correction.relative.value();
            if residual < CLOSED {
                return Some(Configuration { q, inputs });
            }
            if !residual.is_finite() {
                return None;
            }
            let next = equations::displace(&self.chain, &self.merged, &q, &correction.coordinates);
            q = self.limited(&q, next);
        }
        None
    }

    /// Returns `to`, or coordinates on the way there so that no hinge rotates by more than [`LARGEST_ROTATION`].
    fn limited(&self, from: &[Number], to: Vec<Number>) -> Vec<Number> {
        let change = |k: usize| to[k].value() - from[k].value();
        let rotations = rotation_coordinates(&self.chain, &self.merged);
        let changes = rotations.into_iter().flat_map(|rotation| {
            let RotationCoordinates { coordinates, quaternion } = rotation;
            coordinates.map(move |k| if quaternion { 2.0 * change(k) } else { change(k) })
        });
        let largest = changes.fold(0.0, |largest: f64, change| largest.max(change.abs()));
        if largest <= LARGEST_ROTATION {
            return to;
        }
        let scale = LARGEST_ROTATION / largest;
        let nearer = |k: usize| Number::variable(from[k].value() + scale * change(k));
        let near: Vec<Number> = (0..to.len()).map(nearer).collect();
        let hinges = self.chain.hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed());
        let of_hinges = hinges.flat_map(|(id, hinge)| {
            equations::hinge::normalized(&hinge.kind, &near[self.merged.q[id].clone()])
        });
        of_hinges.collect()
    }

    /// Returns the start with prescribed motions at rest, or a configuration near it.
    pub fn pose(&self, values: &SymbolValues<Number>, seed: usize) -> Configuration {
        Configuration { q: self.coordinates(values, seed), inputs: self.inputs(seed) }
    }

    /// Returns a pose near the start in which prescribed motions have rates and accelerations, and all
    /// other inputs have values: from −2 to 2, times the units of translations and of `frequency`.
    pub fn pose_in_motion(&self, frequency: f64, seed: usize) -> Configuration {
        let mut pose = self.pose(&self.values, seed);
        for input in &self.merged.inputs {
            let (first, units) = match input.what {
                InputKind::Motion(hinge) => {
                    let kind = &self.chain.hinges[hinge].kind;
                    let rates: Vec<f64> = self
                        .units(kind, |group| group.rates.clone())
                        .map(|it| it * frequency)
                        .collect();
                    let accelerations = rates.iter().map(|rate| rate * frequency);
                    let units = rates.iter().copied().chain(accelerations).collect();
                    (input.range.start + kind.coordinates(), units)
                }
                InputKind::Gravity => (input.range.start, vec![self.size; input.range.len()]),
                _ => (input.range.start, vec![1.0; input.range.len()]),
            };
            for (index, unit) in (first..input.range.end).zip(units) {
                let number = near_zero(OF_INPUTS + index, seed).value();
                pose.inputs[index] = Number::variable(unit * number);
            }
        }
        pose
    }

    /// Returns the start, or coordinates that differ from it by up to half a rad, or half the size of the chain.
    fn coordinates(&self, values: &SymbolValues<Number>, seed: usize) -> Vec<Number> {
        let mut count = 0;
        let free = self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed());
        let coordinates = free.flat_map(|hinge| {
            let units = self.units(&hinge.kind, |group| group.coordinates.clone());
            let near = hinge.start.iter().zip(units).map(|(start, unit)| {
                count += 1;
                Number::variable(values.scalar(start).value() + unit * deviation(count, seed))
            });
            let near: Vec<Number> = near.collect();
            equations::hinge::normalized(&hinge.kind, &near)
        });
        coordinates.collect()
    }

    pub fn at_rest(&self) -> Vec<Number> {
        vec![Number::variable(0.0); self.merged.dof_count()]
    }

    /// Returns prescribed motions at rest in the zero position or near it; all other inputs are
    /// zero.
    fn inputs(&self, seed: usize) -> Vec<Number> {
        let total = self.merged.inputs.iter().map(|input| input.range.len());
        let mut inputs = vec![Number::variable(0.0); total.sum()];
        // Counted after the coordinates, so that the deviations differ.
        let mut count = self.merged.coordinates();
        for input in &self.merged.inputs {
            let InputKind::Motion(hinge) = input.what else { continue };
            let kind = &self.chain.hinges[hinge].kind;
            let units = self.units(kind, |group| group.coordinates.clone());
            let near = kind.spec().coordinates.iter().zip(units).map(|(coordinate, unit)| {
                count += 1;
                Number::variable(coordinate.rest + unit * deviation(count, seed))
            });
            let near = equations::hinge::normalized(kind, &near.collect::<Vec<_>>());
            inputs[input.range.clone()][..near.len()].copy_from_slice(&near);
        }
        inputs
    }
}
