//! Elimination of the degrees of freedom of a hinge: equations (1), (2), (4) and (6).

use super::super::hinge::BasisVector;
use super::super::strategy;
use super::articulated_body::ArticulatedBody;
use super::eliminated_dof::EliminatedDof;
use crate::math::{Scalar, SpatialInertia, Wrench};

/// A degree of freedom of a hinge.
#[derive(Clone, Copy)]
pub struct HingeDof<S> {
    /// Its index in the basis of the motion subspace.
    pub column: usize,
    /// Its direction `s`.
    pub direction: BasisVector<S>,
    /// Its effort `τ`.
    pub effort: S,
    /// The rotor inertia along it.
    pub armature: S,
}

impl<S: Scalar> HingeDof<S> {
    /// Returns the axis whose entries the elimination sets to zero; none with a rotor.
    fn axis(&self) -> Option<usize> {
        match self.direction {
            BasisVector::Axis(axis) if self.armature.vanishes() => Some(axis),
            _ => None,
        }
    }
}

/// Returns `1 / D` of the second direction by equation (6), from `Iᴬ` before the first elimination.
/// Both directions must be axes that are coupled.
fn second_inverse<S: Scalar>(
    (first, old): &(HingeDof<S>, SpatialInertia<S>),
    second: &HingeDof<S>,
) -> Option<S> {
    let (i, j) = (first.axis()?, second.axis()?);
    let (a, b, c) = (old.at(i, i), old.at(i, j), old.at(j, j));
    strategy::inverts_early(b).then(|| a * (a * c - b * b).recip())
}

/// Eliminates all degrees of freedom of a hinge, one after the other.
pub fn eliminate<S: Scalar>(
    body: &mut ArticulatedBody<S>,
    dofs: &[HingeDof<S>],
) -> Vec<EliminatedDof<S>> {
    let mut before = None;
    let mut eliminate_next = |(number, dof): (usize, &HingeDof<S>)| {
        let is_last = number + 1 == dofs.len();
        let first = before.replace((*dof, body.inertia)).filter(|_| is_last);
        eliminate_one(body, dof, first.as_ref())
    };
    dofs.iter().enumerate().map(&mut eliminate_next).collect()
}

/// Returns the degrees of freedom of a free base, those first on which no child acts: the entries of
/// `Iᴬ` along them are those of the base's own `inertia`, which are constant.
pub fn constant_first<S: Scalar>(
    dofs: Vec<HingeDof<S>>,
    body: &ArticulatedBody<S>,
    inertia: &SpatialInertia<S>,
) -> Vec<HingeDof<S>> {
    let is_constant = |dof: &HingeDof<S>| {
        let equal = |i: usize, j: usize| (body.inertia.at(i, j) - inertia.at(i, j)).vanishes();
        dof.axis().is_some_and(|axis| (0..6).all(|k| equal(axis, k)))
    };
    let (mut constant, others): (Vec<_>, Vec<_>) = dofs.into_iter().partition(is_constant);
    constant.extend(others);
    constant
}

/// Eliminates one degree of freedom by equations (1), (2) and (4). For the last one, equation (6)
/// uses `first`: the degree of freedom before it, with `Iᴬ` before its elimination.
fn eliminate_one<S: Scalar>(
    body: &mut ArticulatedBody<S>,
    dof: &HingeDof<S>,
    first: Option<&(HingeDof<S>, SpatialInertia<S>)>,
) -> EliminatedDof<S> {
    let &HingeDof { column, direction, effort, armature } = dof;
    let s = direction.motion();
    let (old, bias) = (body.inertia, body.bias_force);
    let u = old.times(s);
    let pivot = s.power(u) + armature;
    let early = first.and_then(|first| second_inverse(first, dof));
    let inverse = early.unwrap_or_else(|| pivot.recip());
    let u_over_d = (effort - s.power(bias)) * inverse;
    let axis = dof.axis();
    let is_along = |k: usize| axis == Some(k);
    let gain = Wrench::from_fn(|k| if is_along(k) { S::one() } else { u.at(k) * inverse });
    let waiting_axis = axis.filter(|_| strategy::waits_for_pivot(&u));
    body.inertia = SpatialInertia::from_fn(|i, j| {
        if is_along(i) || is_along(j) {
            S::zero()
        } else if waiting_axis.is_some() {
            old.at(i, j) - u.at(i) * u.at(j) * inverse
        } else {
            old.at(i, j) - gain.at(i) * u.at(j)
        }
    });
    body.bias_force =
        Wrench::from_fn(|k| if is_along(k) { effort } else { bias.at(k) + u.at(k) * u_over_d });
    let (t, t_scales) = body.eliminate_constraints(dof, gain);
    let t_over_d = t.iter().map(|&t| t * inverse).collect();
    EliminatedDof {
        column,
        direction,
        pivot,
        inverse,
        gain,
        u_over_d,
        t,
        t_over_d,
        t_scales,
        waiting_axis,
    }
}

impl<S: Scalar> ArticulatedBody<S> {
    /// Applies equation (4) to `Tᴬ`. Returns `t`, and the scales of its squares.
    fn eliminate_constraints(&mut self, dof: &HingeDof<S>, gain: Wrench<S>) -> (Vec<S>, Vec<S>) {
        let (s, axis) = (dof.direction.motion(), dof.axis());
        let t: Vec<S> = self.constraint_wrenches.iter().map(|&column| s.power(column)).collect();
        let scale = |column: &Wrench<S>| {
            let force = column.force.dot(column.force);
            let moment = column.moment.dot(column.moment) + force * self.squared_arms;
            dof.direction.pivot_scale(force, moment)
        };
        let t_scales = self.constraint_wrenches.iter().map(scale).collect();
        for (column, &t) in self.constraint_wrenches.iter_mut().zip(&t) {
            let old = *column;
            let left = |k| if axis == Some(k) { S::zero() } else { old.at(k) - gain.at(k) * t };
            *column = Wrench::from_fn(left);
        }
        (t, t_scales)
    }
}

#[cfg(test)]
pub mod tests {
    use super::super::articulated_body::ArticulatedBody;
    use super::{BasisVector, HingeDof, SpatialInertia, Wrench, eliminate};
    use crate::math::{Mat3, Scalar, Structured, Sym3, Vec3};

    /// A value that is not known while compiling.
    pub fn some(value: f64) -> Structured<f64> {
        Structured::variable(value)
    }

    /// An articulated body without zero entries; the entries about y and z are coupled most.
    pub fn articulated_body() -> ArticulatedBody<Structured<f64>> {
        let inertia = SpatialInertia {
            linear: Sym3([3.1, 2.7, 4.3, 0.3, -0.2, 0.7].map(some)),
            coupling: Mat3(
                [[0.1, 0.7, -0.3], [0.2, -0.6, 0.9], [0.4, 0.3, 0.8]].map(|row| row.map(some)),
            ),
            angular: Sym3([2.3, 3.7, 2.9, 0.11, -0.23, 2.37].map(some)),
        };
        let bias = Wrench {
            force: Vec3([0.3, -0.7, 1.1].map(some)),
            moment: Vec3([1.3, 0.9, -0.1].map(some)),
        };
        ArticulatedBody {
            pivot_scales: (some(10.0), some(7.0)),
            ..ArticulatedBody::new(inertia, bias)
        }
    }

    /// Without exact zeros, rounding errors leak back into the angular block at every ball and grow
    /// from ball to ball until no digit is left.
    #[test]
    fn eliminated_ball_entries_are_exactly_zero() {
        let mut body = articulated_body();
        let dof = |(k, effort): (usize, f64)| {
            let (effort, armature) = (some(effort), Structured::zero());
            HingeDof { column: k, direction: BasisVector::Axis(3 + k), effort, armature }
        };
        let dofs = [0.25, -0.5, 0.125].into_iter().enumerate().map(dof);
        let dofs: Vec<HingeDof<Structured<f64>>> = dofs.collect();
        let steps = eliminate(&mut body, &dofs);
        assert!(steps.iter().all(|step| step.pivot.value() > 0.0));
        assert!(body.inertia.angular.0.iter().all(|x| x.vanishes()));
        assert!(body.inertia.coupling.0.iter().flatten().all(|x| x.vanishes()));
        assert_eq!(body.bias_force.moment.0.map(|x| x.value()), [0.25, -0.5, 0.125]);
    }
}
