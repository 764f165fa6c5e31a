//! The force laws of springs, dampers, friction and stops.
//!
//! `s` is a strain, `ṡ` its rate and `σ` the effort along it.

use super::rows::dot;
use crate::equations::SymbolValues;
use crate::math::Scalar;
use crate::model::{DofGroup, Friction, Limits, Passive, Representation};

/// The effort along a strain, linearised in the strain and its rate.
#[derive(Clone, Copy, Debug)]
pub struct LinearizedEffort<S> {
    /// The effort `σ`.
    pub effort: S,
    /// `−∂σ/∂s`
    pub stiffness: S,
    /// The effort per rate that acts at the end of an implicit step: `−∂σ/∂ṡ`, and `−σ/ṡ` of dry
    /// friction.
    pub damping: S,
}

/// The state of a group of degrees of freedom.
pub struct GroupState<'a, S> {
    /// The group.
    pub group: &'a DofGroup,
    /// The passive elements along each strain.
    pub passive: &'a [Passive],
    /// The values of the chain's symbols.
    pub values: &'a SymbolValues<S>,
    /// The strains.
    pub strains: &'a [S],
    /// The strain rates.
    pub rates: &'a [S],
    /// The coordinates.
    pub coordinates: &'a [S],
}

impl<S: Scalar> LinearizedEffort<S> {
    /// No effort.
    pub fn zero() -> Self {
        LinearizedEffort { effort: S::zero(), stiffness: S::zero(), damping: S::zero() }
    }

    fn add(&mut self, other: LinearizedEffort<S>) {
        self.effort = self.effort + other.effort;
        self.stiffness = self.stiffness + other.stiffness;
        self.damping = self.damping + other.damping;
    }
}

/// Returns the effort along each strain of a group, and the energy of its springs and stops in J.
pub fn group_efforts<S: Scalar>(state: &GroupState<S>) -> (Vec<LinearizedEffort<S>>, S) {
    let mut energy = S::zero();
    let mut efforts = Vec::new();
    for (k, passive) in state.passive.iter().enumerate() {
        let (mut along, stored) = spring(state, passive, k);
        energy = energy + stored;
        if let Some(friction) = &passive.friction {
            along.add(dry_friction(state, friction, k));
        }
        if let (Some(limits), Representation::Numbers | Representation::Angles) =
            (&passive.limits, state.group.representation)
        {
            let (stop, stored) = stop(state, limits, k);
            along.add(stop);
            energy = energy + stored;
        }
        efforts.push(along);
    }
    if let (Some(limits), Representation::Quaternion) =
        (&state.passive[0].limits, state.group.representation)
    {
        energy = energy + add_cone_stop(state, limits, &mut efforts);
    }
    (efforts, energy)
}

/// Returns the effort `−k s − c ṡ` of a spring and a damper, and the energy `½ k s²`.
fn spring<S: Scalar>(
    state: &GroupState<S>,
    passive: &Passive,
    k: usize,
) -> (LinearizedEffort<S>, S) {
    let stiffness = state.values.scalar(&passive.stiffness);
    let damping = state.values.scalar(&passive.damping);
    let force = stiffness * state.strains[k];
    let effort = -force - damping * state.rates[k];
    (LinearizedEffort { effort, stiffness, damping }, force * state.strains[k] * S::number(0.5))
}

/// Returns `−f ṡ / √(ṡ² + v²)`. For a rotation vector, the root contains the norm of its rate.
///
/// An implicit step divides by the root at its start: `−f ṡ⁺ / √(ṡ² + v²)` stops a motion without reversing it, however
/// long the step. The derivative, which is almost zero at high rates, would let the whole effort act for the whole step.
fn dry_friction<S: Scalar>(
    state: &GroupState<S>,
    friction: &Friction,
    k: usize,
) -> LinearizedEffort<S> {
    let (effort, speed) =
        (state.values.scalar(&friction.effort), state.values.scalar(&friction.speed));
    let rates = match state.group.representation {
        Representation::Quaternion => state.rates,
        Representation::Numbers | Representation::Angles => &state.rates[k..=k],
    };
    let slope = effort * (dot(rates, rates) + speed * speed).sqrt().recip();
    LinearizedEffort { effort: -(slope * state.rates[k]), stiffness: S::zero(), damping: slope }
}

/// Returns the effort of a spring and a damper that act if a coordinate is beyond its limits, and
/// the energy of the spring.
fn stop<S: Scalar>(state: &GroupState<S>, limits: &Limits, k: usize) -> (LinearizedEffort<S>, S) {
    let [low, high, stiffness, damping] =
        [&limits.low, &limits.high, &limits.stiffness, &limits.damping]
            .map(|value| state.values.scalar(value));
    let coordinate = state.coordinates[k];
    let (above, below) = (coordinate - high, low - coordinate);
    let (over, under) = (above.positive_part(), below.positive_part());
    let beyond = above.is_positive() + below.is_positive();
    let (stiff, damp) = (stiffness * beyond, damping * beyond);
    let effort = stiffness * (under - over) - damp * state.rates[k];
    let energy = stiffness * (over * over + under * under) * S::number(0.5);
    (LinearizedEffort { effort, stiffness: stiff, damping: damp }, energy)
}

/// Adds the stop against a rotation from rest by more than an angle; returns its energy.
fn add_cone_stop<S: Scalar>(
    state: &GroupState<S>,
    limits: &Limits,
    efforts: &mut [LinearizedEffort<S>],
) -> S {
    let [high, stiffness, damping] =
        [&limits.high, &limits.stiffness, &limits.damping].map(|value| state.values.scalar(value));
    // At rest no stop acts.
    let angle = dot(state.strains, state.strains).divisible_root();
    let over = (angle - high).positive_part();
    let beyond = (angle - high).is_positive();
    let along_axis = stiffness * over * angle.recip();
    for (along, (&strain, &rate)) in efforts.iter_mut().zip(state.strains.iter().zip(state.rates)) {
        along.add(LinearizedEffort {
            effort: -(along_axis * strain) - damping * beyond * rate,
            stiffness: stiffness * beyond,
            damping: damping * beyond,
        });
    }
    stiffness * (over * over) * S::number(0.5)
}
