//! The constraint Jacobian of closed chains.

use mstmm::linear::{null_space, solve_positive_definite};
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{Error, mstmm_chain};

/// Makes a four-bar linkage with a ball and a universal joint, so that its constraints are independent, with this closing pin.
macro_rules! linkage {
    ($name:ident, pin($($axis:tt)*) $($end:tt)*) => {
        mstmm_chain! {
            chain $name {
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
                ground -> pin(z) a -> Crank b -> ball c -> Rod d -> universal(y, z) e -> Rod f -> pin($($axis)*) g $($end)*
                hinge a { torque = input; start = 70 deg; }
                hinge e { start = [0, -110] deg; damping = 0.1; }
            }
        }
    };
}

linkage! { Linkage, pin(z) -> ground at [0.7, 0, 0] m; hinge g { stiffness = 2; armature = 0.3; } }
linkage! { Oblique, pin([1, 2, 5]) -> ground at [0.7, 0, 0] m turned rpy(20, -10, 0) deg; }

mstmm_chain! {
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

/// The multipliers of the constraints are the wrench in the closing hinge, in the axes of its outboard frame, in motion.
#[test]
fn multipliers_are_the_wrench_in_the_closing_hinge() -> Result<(), Error> {
    macro_rules! check {
        ($chain:ident) => {{
            let chain = $chain::<f64>::new();
            let (mut state, mut inputs) = (chain.initial_state(), chain.no_inputs());
            state.v[0] = 1.0;
            chain.assemble(&mut state, &inputs)?;
            // Rounding of positions of a metre and velocities of a metre per second, several times.
            assert!(chain.closure_error(&state, &inputs)? < 100.0 * f64::EPSILON);
            inputs.a = 3.0;
            let mut at = chain.workspace();
            chain.solve_into(&state, &inputs, &mut at)?;
            let jacobian = chain.closure_jacobian(&state, &inputs)?;
            let mut unbalanced = chain.inverse_dynamics(&state, at.accelerations(), &inputs)?;
            unbalanced[0] -= inputs.a;
            let gram: SMatrix<f64, 6, 6> = jacobian * jacobian.transpose();
            let right: SMatrix<f64, 6, 1> = jacobian * unbalanced;
            let multipliers = solve_positive_definite(&gram, &right)?;
            let rest = (jacobian.transpose() * multipliers - unbalanced).norm();
            let output = at.g().output();
            let to_axes = output.orientation().inverse();
            let (force, moment) = (-(to_axes * output.force()), to_axes * output.moment());
            let wrench = SVector::from([force.x, force.y, force.z, moment.x, moment.y, moment.z]);
            let scale = wrench.norm();
            // The condition of G Gᵀ is below 1e5, a hundred roundings.
            assert!(rest / scale < 1e-9, "{rest:e}");
            let off = (multipliers.column(0) - wrench).norm() / scale;
            assert!(off < 1e-9, "{} and {wrench}: {off:e}", multipliers);
        }};
    }
    check!(Linkage);
    check!(Oblique);
    Ok(())
}

/// The gap of a chain that is opened by hand is the distance of its ends.
#[test]
fn a_chain_that_is_open_has_a_gap() -> Result<(), Error> {
    let chain = Ring::<f64>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    chain.assemble(&mut state, &inputs)?;
    assert!(chain.closure_error(&state, &inputs)? < 1e-14);
    state.v.fill(0.0);
    let closed = state.clone();
    let small = 1e-4;
    state.q[0] += small;
    let (opened, untouched) = (chain.closure_error(&state, &inputs)?, state.clone());
    // The end turns by this angle, but the closing pin does not, and moves about the first pin at a distance of √(0.5² + 0.2²).
    let expected = small * (1.0 + 0.5_f64.powi(2) + 0.2_f64.powi(2)).sqrt();
    assert!((opened / expected - 1.0).abs() < small, "{opened:e} and {expected:e}");
    assert_eq!(state, untouched);
    let mut moving = closed;
    moving.v[0] = small;
    let gap = chain.closure_error(&moving, &inputs)?;
    assert!((gap / expected - 1.0).abs() < small, "{gap:e} and {expected:e}");
    state.q[0] = f64::NAN;
    let error = Error::NotFinite(mstmm::description::Origin::Coordinate(0));
    assert_eq!(chain.closure_error(&state, &inputs), Err(error));
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
