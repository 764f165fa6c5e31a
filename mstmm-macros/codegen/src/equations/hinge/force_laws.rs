//! The laws of springs, dampers, friction and stops.

use super::rows::dot;
use crate::equations::SymbolValues;
use crate::math::Scalar;
use crate::model::{DofGroup, Friction, Limits, Passive, Representation};

/// The effort along a strain, and how it falls with the strain and with its rate.
#[derive(Clone, Copy, Debug)]
pub struct LinearizedEffort<S> {
    /// The effort.
    pub effort: S,
    /// `−∂σ/∂s`
    pub stiffness: S,
    /// `−∂σ/∂ṡ`
    pub damping: S,
}

/// A group of degrees of freedom in a state.
pub struct GroupState<'a, S> {
    /// The group.
    pub group: &'a DofGroup,
    /// What acts on each strain.
    pub passive: &'a [Passive],
    /// The numbers of the chain.
    pub numbers: &'a SymbolValues<S>,
    /// The strains.
    pub strains: &'a [S],
    /// Their rates.
    pub rates: &'a [S],
    /// The coordinates.
    pub coordinates: &'a [S],
}

impl<S: Scalar> LinearizedEffort<S> {
    /// Nothing acts.
    pub fn nothing() -> Self {
        LinearizedEffort { effort: S::zero(), stiffness: S::zero(), damping: S::zero() }
    }

    fn add(&mut self, other: LinearizedEffort<S>) {
        self.effort = self.effort + other.effort;
        self.stiffness = self.stiffness + other.stiffness;
        self.damping = self.damping + other.damping;
    }
}

/// What acts along each strain of a group, and the energy that springs and stops hold.
pub fn along_group<S: Scalar>(acting: &GroupState<S>) -> (Vec<LinearizedEffort<S>>, S) {
    let mut energy = S::zero();
    let mut alongs = Vec::new();
    for (k, passive) in acting.passive.iter().enumerate() {
        let (mut along, stored) = spring(acting, passive, k);
        energy = energy + stored;
        if let Some(friction) = &passive.friction {
            along.add(dry_friction(acting, friction, k));
        }
        if let (Some(limits), Representation::Numbers | Representation::Angles) =
            (&passive.limits, acting.group.representation)
        {
            let (stop, stored) = stop(acting, limits, k);
            along.add(stop);
            energy = energy + stored;
        }
        alongs.push(along);
    }
    if let (Some(limits), Representation::Quaternion) =
        (&acting.passive[0].limits, acting.group.representation)
    {
        energy = energy + add_cone(acting, limits, &mut alongs);
    }
    (alongs, energy)
}

/// A spring and a damper, `−k s − c ṡ`, and `½ k s²`.
fn spring<S: Scalar>(
    acting: &GroupState<S>,
    passive: &Passive,
    k: usize,
) -> (LinearizedEffort<S>, S) {
    let stiffness = acting.numbers.scalar(&passive.stiffness);
    let damping = acting.numbers.scalar(&passive.damping);
    let force = stiffness * acting.strains[k];
    let effort = -force - damping * acting.rates[k];
    (LinearizedEffort { effort, stiffness, damping }, force * acting.strains[k] * S::number(0.5))
}

/// `−f ṡ / √(ṡ² + v²)`; of a rotation vector the length of its rate counts.
fn dry_friction<S: Scalar>(
    acting: &GroupState<S>,
    friction: &Friction,
    k: usize,
) -> LinearizedEffort<S> {
    let (effort, speed) =
        (acting.numbers.scalar(&friction.effort), acting.numbers.scalar(&friction.speed));
    let rates = match acting.group.representation {
        Representation::Quaternion => acting.rates,
        Representation::Numbers | Representation::Angles => &acting.rates[k..=k],
    };
    let square = speed * speed;
    let inverse = (dot(rates, rates) + square).sqrt().recip();
    let slope = effort * inverse;
    LinearizedEffort {
        effort: -(slope * acting.rates[k]),
        stiffness: S::zero(),
        damping: slope * square * (inverse * inverse),
    }
}

/// A spring and a damper that act while a coordinate is beyond its limits, and the spring's energy.
fn stop<S: Scalar>(acting: &GroupState<S>, limits: &Limits, k: usize) -> (LinearizedEffort<S>, S) {
    let [low, high, stiffness, damping] =
        [&limits.low, &limits.high, &limits.stiffness, &limits.damping]
            .map(|value| acting.numbers.scalar(value));
    let coordinate = acting.coordinates[k];
    let (above, below) = (coordinate - high, low - coordinate);
    let (over, under) = (above.positive_part(), below.positive_part());
    let beyond = above.is_positive() + below.is_positive();
    let (stiff, damp) = (stiffness * beyond, damping * beyond);
    let effort = stiffness * (under - over) - damp * acting.rates[k];
    let energy = stiffness * (over * over + under * under) * S::number(0.5);
    (LinearizedEffort { effort, stiffness: stiff, damping: damp }, energy)
}

/// A stop against turns by more than an angle from rest; returns its energy.
fn add_cone<S: Scalar>(
    acting: &GroupState<S>,
    limits: &Limits,
    alongs: &mut [LinearizedEffort<S>],
) -> S {
    let [high, stiffness, damping] = [&limits.high, &limits.stiffness, &limits.damping]
        .map(|value| acting.numbers.scalar(value));
    // So small that it only keeps 0/0 away where nothing is turned and no stop acts.
    let angle = (dot(acting.strains, acting.strains) + S::number(1e-30)).sqrt();
    let over = (angle - high).positive_part();
    let beyond = (angle - high).is_positive();
    let along_axis = stiffness * over * angle.recip();
    for (along, (&strain, &rate)) in alongs.iter_mut().zip(acting.strains.iter().zip(acting.rates))
    {
        along.add(LinearizedEffort {
            effort: -(along_axis * strain) - damping * beyond * rate,
            stiffness: stiffness * beyond,
            damping: damping * beyond,
        });
    }
    stiffness * (over * over) * S::number(0.5)
}
