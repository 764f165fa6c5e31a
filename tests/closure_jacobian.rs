//! The constraint Jacobian of closed chains.

use mstmm::linear::{null_space, solve_positive_definite};
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{Error, mstmm_chain};

mstmm_chain! {
    /// A four-bar linkage with a ball and a universal joint, so that its constraints are independent.
    chain Linkage {
        answers = [jacobian, inverse_dynamics];
        gravity = [0.3, -9.8, 1] m/s^2;
        body Crank {
            mass = 1 kg; com = [0.1, 0.02, 0] m; output = [0.2, 0, 0] m;
            inertia = diag(0.1, 0.12, 0.09) kg*m^2 about com;
        }
        body Rod {
            mass = 2 kg; com = [0.3, 0, 0.01] m; output = [0.6, 0, 0] m;
            inertia = diag(0.1, 0.12, 0.09) kg*m^2 about com;
        }
        ground -> pin(z) a -> Crank b -> ball c -> Rod d -> universal(y, z) e -> Rod f -> pin(z) g
               -> ground at [0.7, 0, 0] m;
        hinge a { torque = input; start = 70 deg; }
        hinge e { start = [0, -110] deg; damping = 0.1; }
        hinge g { stiffness = 2; armature = 0.3; }
    }

    /// A ring of repeated parts.
    plane chain Ring {
        answers = jacobian;
        body Link { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Link b -> repeat 4 { pin c -> Link d } -> pin g -> ground at [0.5, 0.2] m;
        hinge c { start = 60 deg; }
    }
}

/// Rates in the null space of the constraint Jacobian are those that the projection leaves unchanged.
#[test]
fn rates_in_the_null_space_keep_the_chain_closed() -> Result<(), Error> {
    let chain = Ring::<f64>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    chain.assemble(&mut state, &inputs)?;
    let jacobian = chain.closure_jacobian(&state, &inputs)?;
    let (basis, dimension) = null_space(&jacobian, 1e-9);
    assert_eq!(dimension, 3, "six rates, three constraints");
    for k in 0..dimension {
        let mut moving = state.clone();
        moving.v = basis.column(k).into_owned();
        let before = moving.v;
        chain.assemble(&mut moving, &inputs)?;
        // Sums of six terms of size one, and the solution of a linear system of condition below 100.
        assert!((moving.v - before).norm() < 1e-13, "rates {k} change by {}", moving.v - before);
    }
    // Other rates are not kept.
    let mut other = state.clone();
    other.v[0] = 1.0;
    chain.assemble(&mut other, &inputs)?;
    assert!((other.v - SVector::from_fn(|k, _| if k == 0 { 1.0 } else { 0.0 })).norm() > 1e-3);
    Ok(())
}

/// At rest, the accelerations of the closed chain are those of the open one on the tangent space of the closure.
#[test]
fn the_tangent_space_has_the_dynamics_of_the_closed_chain() -> Result<(), Error> {
    let chain = Linkage::<f64>::new();
    let (mut state, mut inputs) = (chain.initial_state(), chain.no_inputs());
    chain.assemble(&mut state, &inputs)?;
    inputs.a = 3.0;
    let (basis, dimension) = null_space(&chain.closure_jacobian(&state, &inputs)?, 1e-9);
    assert_eq!(dimension, 1);
    let tangent = basis.column(0).into_owned();
    let bias = chain.bias_efforts(&state, &inputs)?;
    let efforts = chain.inverse_dynamics(&state, &tangent, &inputs)?;
    let mass: f64 = tangent.dot(&(efforts - bias));
    let mut supplied = -bias;
    supplied[0] += inputs.a;
    let expected = tangent * (tangent.dot(&supplied) / mass);
    let found = chain.accelerations(&state, &inputs)?;
    // Condition numbers of the constraints below 100, a hundred roundings.
    let off = (found - expected).norm() / expected.norm();
    assert!(off < 100.0 * 100.0 * f64::EPSILON, "{off:e}");
    Ok(())
}

/// The null space of random matrices of every rank is orthonormal and complete.
#[test]
fn null_spaces_are_orthonormal_and_complete() {
    for rank in 0..=4_usize {
        let number = |i: usize, j: usize| ((7 * i + 3 * j + i * j) as f64 * 0.618).fract() - 0.5;
        let left =
            SMatrix::<f64, 5, 5>::from_fn(|i, j| if j < rank { number(i, j + 9) } else { 0.0 });
        let matrix = left * SMatrix::<f64, 5, 6>::from_fn(|i, j| number(i + 20, j));
        let (basis, dimension) = null_space(&matrix, 1e-9);
        assert_eq!(dimension, 6 - rank);
        let gram = basis.transpose() * basis;
        let unit =
            SMatrix::<f64, 6, 6>::from_fn(|i, j| if i == j && i < dimension { 1.0 } else { 0.0 });
        // Vectors of six entries, each orthogonalised twice.
        assert!((gram - unit).norm() < 1e-14 && (matrix * basis).norm() < 1e-14, "rank {rank}");
    }
    let full = SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 3.0);
    assert_eq!(null_space(&full, 1e-9).1, 0);
    let inverse = solve_positive_definite(&full, &SMatrix::<f64, 2, 2>::identity());
    assert!(inverse.is_ok());
}
