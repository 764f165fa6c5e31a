//! Matrices of chains with repeated parts, which are computed column by column, against the same chains written out.

#[path = "matrices_by_columns/bits.rs"]
mod bits;
#[path = "matrices_by_columns/many_rates.rs"]
mod many_rates;
#[path = "matrices_by_columns/segments.rs"]
mod segments;

use mstmm::description::Origin;
use mstmm::linear::discretize;
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{Error, Scalar, mstmm_chain};

macro_rules! arm {
    ($name:ident, $($route:tt)*) => {
        mstmm_chain! {
            chain $name {
                answers = [mass_matrix, derivatives, linearize, regressor, coriolis_matrix];
                gravity = [0, -9.8, 1] m/s^2;
                param mass = 1.3 kg;
                body Rod {
                    mass = mass;
                    com = [0.3, 0.1, 0] m;
                    output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
                    inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
                }
                $($route)*
            }
        }
    };
}

arm!(Rope,
    ground -> ball a -> Rod b -> repeat 2 { pin c -> Rod d -> ball e -> Rod f };
    hinge a { torque = input; damping = 0.2; armature = 0.1; }
    hinge c { torque = input; stiffness = 3; friction = 0.3; friction_speed = 0.1; }
);
arm!(Written,
    ground -> ball a -> Rod b -> pin c1 -> Rod d1 -> ball e1 -> Rod f1 -> pin c2 -> Rod d2 -> ball e2 -> Rod f2;
    hinge a { torque = input; damping = 0.2; armature = 0.1; }
    hinge c1, c2 { torque = input; stiffness = 3; friction = 0.3; friction_speed = 0.1; }
);

/// The rates of both chains.
const RATES: usize = 11;

/// Returns the same state of both chains.
fn states<T: Scalar>() -> (RopeState<T>, WrittenState<T>) {
    let (rope, written) = (Rope::<T>::new(), Written::<T>::new());
    let (mut one, mut other) = (rope.initial_state(), written.initial_state());
    for k in 0..RATES {
        one.v[k] = T::constant(0.4 - 0.13 * k as f64);
    }
    for (k, q) in one.q.iter_mut().enumerate() {
        *q += T::constant(0.05 * ((k * k) % 5) as f64);
    }
    mstmm::Chain::normalize(&rope, &mut one);
    (other.q, other.v) = (one.q, one.v);
    (one, other)
}

fn largest<T: Scalar<Real = T> + PartialOrd>(values: impl Iterator<Item = T>) -> T {
    values.fold(T::constant(0.0), |most, x| if x.abs() > most { x.abs() } else { most })
}

/// Entries up to 100, sums of some hundred terms, and condition numbers of the mass matrix below 1000.
fn agree<T: Scalar<Real = T> + PartialOrd>(what: &str, one: &[T], other: &[T]) {
    let off = largest(one.iter().zip(other).map(|(&a, &b)| a - b));
    let scale = largest(other.iter().copied()) + T::constant(1.0);
    assert_eq!(one.len(), other.len(), "{what}");
    assert!(scale > T::constant(1.0), "{what}: all entries are zero");
    assert!(off <= T::constant(1e4) * T::epsilon() * scale, "{what}: {off:?} of {scale:?}");
}

/// Returns the product of a matrix with a vector.
fn times<T: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<T, R, C>,
    vector: &SVector<T, C>,
) -> [T; R] {
    let row = |i: usize| (0..C).fold(T::constant(0.0), |sum, j| sum + matrix[(i, j)] * vector[j]);
    std::array::from_fn(row)
}

fn check<T: Scalar<Real = T, Mask = bool> + PartialOrd>() -> Result<(), Error> {
    let (rope, written) = (Rope::<T>::new(), Written::<T>::new());
    let (one, other) = states::<T>();
    let (mut given, mut same) = (rope.no_inputs(), written.no_inputs());
    given.a[1] = T::constant(0.7);
    same.a[1] = T::constant(0.7);
    (given.c[0], given.c[1]) = (T::constant(0.3), T::constant(-0.4));
    (same.c1, same.c2) = (T::constant(0.3), T::constant(-0.4));
    let mut matrix = written.mass_matrix(&other, &same)?;
    let expected = matrix;
    rope.mass_matrix_into(&one, &given, &mut matrix)?;
    agree("M", matrix.as_slice(), expected.as_slice());
    let expected = written.inverse_mass_matrix(&other, &same)?;
    rope.inverse_mass_matrix_into(&one, &given, &mut matrix)?;
    agree("M⁻¹", matrix.as_slice(), expected.as_slice());

    let expected = written.coriolis_matrix(&other, &same)?;
    rope.coriolis_matrix_into(&one, &given, &mut matrix)?;
    agree("C", matrix.as_slice(), expected.as_slice());

    let accelerations = SVector::from_fn(|k, _| T::constant(0.3 * k as f64 - 1.0));
    let expected = written.inverse_dynamics_derivatives(&other, &accelerations, &same)?;
    let mut found = RopeInverseDynamicsDerivatives::default();
    rope.inverse_dynamics_derivatives_into(&one, &accelerations, &given, &mut found)?;
    agree("dID/dq", found.by_coordinates.as_slice(), expected.by_coordinates.as_slice());
    agree("dID/dv", found.by_rates.as_slice(), expected.by_rates.as_slice());
    agree("dID/dv̇", found.by_accelerations.as_slice(), expected.by_accelerations.as_slice());

    let expected = written.linearize(&other, &same)?;
    let mut found = RopeLinearization::default();
    rope.linearize_into(&one, &given, &mut found)?;
    agree("v̇", found.accelerations.as_slice(), expected.accelerations.as_slice());
    agree("A", found.a().as_slice(), expected.a().as_slice());
    agree("B", found.b().as_slice(), expected.b().as_slice());
    agree("by mass", found.by_parameters.as_slice(), expected.by_parameters.as_slice());
    // Stages leave the unit length of quaternions, and the derivatives of both chains differ there: by less than rounding
    // in such a short step.
    let step = T::constant(1e-4);
    let [found, expected] =
        [discretize(&rope, &one, &given, step)?, discretize(&written, &other, &same, step)?];
    agree(
        "discrete A",
        found.a::<{ 2 * RATES }>().as_slice(),
        expected.a::<{ 2 * RATES }>().as_slice(),
    );
    agree(
        "discrete B",
        found.b::<{ 2 * RATES }>().as_slice(),
        expected.b::<{ 2 * RATES }>().as_slice(),
    );

    let mut regressor = SMatrix::from_fn(|_, _| T::constant(0.0));
    rope.regressor_into(&one, &accelerations, &given, &mut regressor)?;
    let found = times(&regressor, &rope.dynamic_parameters());
    let expected = written.regressor(&other, &accelerations, &same)?;
    agree("Y π", &found, &times(&expected, &written.dynamic_parameters()));
    Ok(())
}

#[test]
fn columns_are_those_of_the_chain_written_out() -> Result<(), Error> {
    check::<f64>()
}

#[test]
fn columns_are_those_of_the_chain_written_out_in_single_precision() -> Result<(), Error> {
    check::<f32>()
}

#[test]
fn matrices_of_states_that_are_not_finite_are_errors() {
    let rope = Rope::<f64>::new();
    let (mut state, _) = states::<f64>();
    state.v[RATES - 1] = f64::NAN;
    let mut found = RopeLinearization::default();
    let result = rope.linearize_into(&state, &rope.no_inputs(), &mut found);
    assert_eq!(result.err(), Some(Error::NotFinite(Origin::Rate(RATES - 1))));
}
