//! A free direction of a hinge is eliminated: equations (1), (2), (4) and (6).

use super::super::hinge::Column;
use super::Carried;
use crate::math::{Scalar, SpatialInertia, Wrench};

/// A free direction that has been eliminated.
pub struct Eliminated<S> {
    /// Which.
    pub column: Column<S>,
    /// `z`
    pub gain: Wrench<S>,
    /// `w / d`
    pub rest: S,
    /// `u`
    pub along: Vec<S>,
    /// `1 / d`
    pub inverse: S,
    /// `u / d`
    pub pulls: Vec<S>,
    /// What the squares of `u` would be if nothing in them cancelled.
    pub sizes: Vec<S>,
    /// The axis that it is, where so little hangs on `y` that the next results wait for `1 / d` most of
    /// the time.
    pub waiting: Option<usize>,
}

impl<S: Scalar> Eliminated<S> {
    /// `z` without its entry along the axis, which is one.
    pub fn beside(&self, axis: usize) -> Wrench<S> {
        Wrench::from_fn(|k| if k == axis { S::zero() } else { self.gain.at(k) })
    }
}

/// How many directions a plane has.
const PLANE: usize = 3;

/// A free direction with its effort and the inertia of its rotor.
#[derive(Clone, Copy)]
pub struct Condition<S> {
    /// Which.
    pub column: Column<S>,
    /// `τ`
    pub effort: S,
    /// Inertia of its rotor.
    pub armature: S,
}

impl<S: Scalar> Condition<S> {
    /// The axis whose entries become zero; beside a rotor none do.
    fn axis(&self) -> Option<usize> {
        match self.column {
            Column::Axis(axis) if self.armature.vanishes() => Some(axis),
            _ => None,
        }
    }
}

/// Equation (6), if both are axes that hang on each other: `1 / d` of the second, from `A` before the
/// first was eliminated.
fn inverse_after<S: Scalar>(
    (first, old): &(Condition<S>, SpatialInertia<S>),
    second: &Condition<S>,
) -> Option<S> {
    let (i, j) = (first.axis()?, second.axis()?);
    let (a, b, c) = (old.at(i, i), old.at(i, j), old.at(j, j));
    (!b.vanishes()).then(|| a * (a * c - b * b).recip())
}

/// All free directions of a hinge, one after the other; with each comes its `d`.
pub fn eliminate<S: Scalar>(
    here: &mut Carried<S>,
    conditions: &[Condition<S>],
) -> Vec<(S, Eliminated<S>)> {
    let mut before = None;
    let mut one = |(number, condition): (usize, &Condition<S>)| {
        let is_last = number + 1 == conditions.len();
        let first = before.replace((*condition, here.inertia)).filter(|_| is_last);
        eliminate_one(here, condition, first.as_ref())
    };
    conditions.iter().enumerate().map(&mut one).collect()
}

/// Equations (1), (2) and (4) for one free direction; returns `d` as well. Equation (6) takes the
/// direction before it, with `A` as it was then, where this is the last.
fn eliminate_one<S: Scalar>(
    here: &mut Carried<S>,
    condition: &Condition<S>,
    first: Option<&(Condition<S>, SpatialInertia<S>)>,
) -> (S, Eliminated<S>) {
    let &Condition { column, effort, armature } = condition;
    let direction = column.motion();
    let (old, before) = (here.inertia, here.load);
    let y = old.times(direction);
    let pivot = direction.power(y) + armature;
    let early = first.and_then(|first| inverse_after(first, condition));
    let inverse = early.unwrap_or_else(|| pivot.recip());
    let rest = (effort - direction.power(before)) * inverse;
    let axis = condition.axis();
    let along = |k: usize| axis == Some(k);
    let gain = Wrench::from_fn(|k| if along(k) { S::one() } else { y.at(k) * inverse });
    let linked = (0..6).filter(|&k| !y.at(k).vanishes()).count();
    let waiting = axis.filter(|_| linked <= PLANE);
    here.inertia = SpatialInertia::from_fn(|i, j| {
        if along(i) || along(j) {
            S::zero()
        } else if waiting.is_some() {
            old.at(i, j) - y.at(i) * y.at(j) * inverse
        } else {
            old.at(i, j) - gain.at(i) * y.at(j)
        }
    });
    here.load = Wrench::from_fn(|k| if along(k) { effort } else { before.at(k) + y.at(k) * rest });
    let u: Vec<S> = here.pulls.iter().map(|&pull| direction.power(pull)).collect();
    let pulls: Vec<S> = u.iter().map(|&u| u * inverse).collect();
    let size = |pull: &Wrench<S>| {
        let force = pull.force.dot(pull.force);
        column.scale(force, pull.moment.dot(pull.moment) + force * here.reach)
    };
    let sizes = here.pulls.iter().map(size).collect();
    for (pull, &u) in here.pulls.iter_mut().zip(&u) {
        let old = *pull;
        *pull = Wrench::from_fn(|k| if along(k) { S::zero() } else { old.at(k) - gain.at(k) * u });
    }
    (pivot, Eliminated { column, gain, rest, along: u, inverse, pulls, sizes, waiting })
}

#[cfg(test)]
pub mod tests {
    use super::super::Carried;
    use super::{Column, Condition, SpatialInertia, Wrench, eliminate};
    use crate::math::{Mat3, Scalar, Structured, Sym3, Vec3};

    /// A number that is not known while compiling.
    pub fn some(value: f64) -> Structured<f64> {
        Structured::variable(value)
    }

    /// What a hinge may carry: all entries hang on each other, those about y and z most.
    pub fn carried() -> Carried<Structured<f64>> {
        let inertia = SpatialInertia {
            linear: Sym3([3.1, 2.7, 4.3, 0.3, -0.2, 0.7].map(some)),
            coupling: Mat3(
                [[0.1, 0.7, -0.3], [0.2, -0.6, 0.9], [0.4, 0.3, 0.8]].map(|row| row.map(some)),
            ),
            angular: Sym3([2.3, 3.7, 2.9, 0.11, -0.23, 2.37].map(some)),
        };
        let load = Wrench {
            force: Vec3([0.3, -0.7, 1.1].map(some)),
            moment: Vec3([1.3, 0.9, -0.1].map(some)),
        };
        let (reach, scales) = (Structured::zero(), (some(10.0), some(7.0)));
        Carried { inertia, load, pulls: Vec::new(), reach, scales }
    }

    /// Without exact zeros, rounding leaks back into the angular block of every ball and grows from
    /// one to the next until no digit is left.
    #[test]
    fn what_a_ball_lets_go_is_exactly_zero() {
        let mut here = carried();
        let condition = |(k, effort): (usize, f64)| {
            let (effort, armature) = (some(effort), Structured::zero());
            Condition { column: Column::Axis(3 + k), effort, armature }
        };
        let conditions = [0.25, -0.5, 0.125].into_iter().enumerate().map(condition);
        let conditions: Vec<Condition<Structured<f64>>> = conditions.collect();
        let steps = eliminate(&mut here, &conditions);
        assert!(steps.iter().all(|(pivot, _)| pivot.value() > 0.0));
        assert!(here.inertia.angular.0.iter().all(|x| x.vanishes()));
        assert!(here.inertia.coupling.0.iter().flatten().all(|x| x.vanishes()));
        assert_eq!(here.load.moment.0.map(|x| x.value()), [0.25, -0.5, 0.125]);
    }
}
