//! Linearisations of generated chains against the same chains on dual numbers: accelerations by coordinates, rates, inputs
//! and parameters, the state matrices, and quaternion components.

#[path = "linearization/steep.rs"]
mod steep;

use mstmm::description::Origin;
use mstmm::lanes::NativeF64;
use mstmm::prelude::*;
use mstmm::{Dual, Error, HingeMotion, Scalar, SliderState, mstmm_chain};
use mstmm_reference::Random;
use nalgebra::{SMatrix, Vector3};

mstmm_chain! {
    /// A branched arm with all kinds of internal forces and inputs.
    chain Arm {
        answers = [inverse_dynamics, mass_matrix, derivatives, linearize];
        gravity = input;
        param load = 3 kg;
        param rigidity = 20;
        param reach = 0.5;

        body Link {
            mass = 2 kg;
            com = [0.2, 0.01, 0.02] m;
            inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
            output = [1 * reach, 0, 0.1] m;
        }
        body Tip {
            mass = load;
            com = [0.3, 0.1, 0] m;
            inertia = diag(0.03, 0.02, 0.04) kg*m^2 about com;
        }

        ground -> ball shoulder -> Link upper -> elastic elbow -> Link lower
               -> slider(x) wrist -> Tip hand;
        upper.output -> pin(y) side -> Tip other;

        hinge shoulder { torque = input; damping = 0.2; }
        hinge elbow {
            stiffness = [300, 200, 100] N/m;
            turning_stiffness = [25, 40, 1 * rigidity] N*m/rad;
        }
        hinge wrist { motion = input; }
        hinge side { torque = 2 * rigidity N*m; friction = 0.5 N*m; friction_speed = 0.1 rad/s; armature = 0.1; }
        load push { on = hand; at = input; force = input; }
        spring cord { on = other; at = com; to = hand.com; stiffness = 30 N/m; length = 0.3 m; }
    }
}

const RATES: usize = 10;
const COORDINATES: usize = 11;
const INPUTS: usize = 12;

/// The arguments of forward dynamics in a random state.
#[derive(Clone)]
struct Arguments<T> {
    q: [T; COORDINATES],
    v: [T; RATES],
    inputs: [T; INPUTS],
    parameters: [T; 3],
}

impl Arguments<f64> {
    fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut number = || random.between(-1.0, 1.0);
        let mut q = [(); COORDINATES].map(|()| 0.4 * number());
        q[0] += 1.0;
        let length = q[..4].iter().map(|x| x * x).sum::<f64>().sqrt();
        q[..4].iter_mut().for_each(|x| *x /= length);
        let v = [(); RATES].map(|()| number());
        let inputs = [(); INPUTS].map(|()| number());
        Arguments { q, v, inputs, parameters: [3.0, 20.0, 0.5] }
    }

    /// Returns the same arguments of another scalar type.
    fn map<T>(&self, constant: impl Fn(f64) -> T + Copy) -> Arguments<T> {
        Arguments {
            q: self.q.map(constant),
            v: self.v.map(constant),
            inputs: self.inputs.map(constant),
            parameters: self.parameters.map(constant),
        }
    }
}

/// An arm with its state and its inputs.
type Posed<T> = (Arm<T>, ArmState<T>, ArmInputs<T>);

/// Returns the arm, its state and its inputs.
fn arm<T: Scalar>(arguments: &Arguments<T>) -> Result<Posed<T>, Error> {
    let mut arm = Arm::<T>::new();
    arm.set_load(arguments.parameters[0])?;
    arm.set_rigidity(arguments.parameters[1])?;
    arm.set_reach(arguments.parameters[2])?;
    let mut state = arm.initial_state();
    state.coordinates_mut().copy_from_slice(&arguments.q);
    state.rates_mut().copy_from_slice(&arguments.v);
    let mut inputs = arm.no_inputs();
    let u = arguments.inputs;
    inputs.gravity = Vector3::new(u[0], u[1], u[2]);
    inputs.shoulder = Vector3::new(u[3], u[4], u[5]);
    inputs.wrist = HingeMotion { state: SliderState::new(u[6], u[7]), acceleration: u[8] };
    inputs.push_force = Vector3::new(u[9], u[10], u[11]);
    Ok((arm, state, inputs))
}

type Moved = Dual<f64>;

/// Returns the derivatives of the accelerations along a change of the arguments.
fn slope(
    at: &Arguments<f64>,
    change: impl Fn(&mut Arguments<Moved>),
) -> Result<[f64; RATES], Error> {
    let mut moved = at.map(Moved::from);
    change(&mut moved);
    let (arm, state, inputs) = arm(&moved)?;
    let accelerations = arm.accelerations(&state, &inputs)?;
    Ok(std::array::from_fn(|row| accelerations[row].derivative()))
}

/// Returns the derivatives of the coordinates along a displacement along rate `k`.
fn displacement<T: Scalar>(arguments: &Arguments<T>, rates: [T; RATES]) -> [T; COORDINATES] {
    let mut moving = arguments.clone();
    moving.v = rates;
    let (arm, state, _) = arm(&moving).expect("good parameters");
    let mut rate = arm.initial_state();
    arm.configuration_rate_into(&state, &mut rate);
    std::array::from_fn(|k| rate.coordinates()[k])
}

fn unit<const N: usize>(k: usize) -> [f64; N] {
    std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

fn moving(values: &mut [Moved], along: &[f64]) {
    for (value, &slope) in values.iter_mut().zip(along) {
        *value = Moved::new(value.value, [slope]);
    }
}

/// Compares a matrix with its columns, relative to its largest entry.
fn compare<const R: usize, const C: usize>(
    what: &str,
    found: &SMatrix<f64, R, C>,
    columns: impl Fn(usize) -> [f64; R],
) {
    let expected = SMatrix::<f64, R, C>::from_iterator((0..C).flat_map(columns));
    let off = (found - expected).amax() / expected.amax().max(1.0);
    // A few thousand operations, and a mass matrix with a condition number of some hundreds.
    assert!(off < 1e-11, "{what}: off by {off:e}\n{found}{expected}");
}

#[test]
fn derivatives_are_those_of_dual_numbers() -> Result<(), Error> {
    for seed in 0..20 {
        let at = Arguments::random(seed);
        let (arm, state, inputs) = arm(&at)?;
        let found = arm.linearize(&state, &inputs)?;
        let accelerations = arm.accelerations(&state, &inputs)?;
        compare("accelerations", &found.accelerations, |_| {
            std::array::from_fn(|row| accelerations[row])
        });
        let slope = |change: &dyn Fn(&mut Arguments<Moved>)| slope(&at, change).expect("regular");
        compare("by coordinates", &found.by_coordinates, |k| {
            let along = displacement(&at, unit(k));
            slope(&|moved| moving(&mut moved.q, &along))
        });
        compare("by rates", &found.by_rates, |k| slope(&|m| moving(&mut m.v, &unit::<RATES>(k))));
        compare("by inputs", &found.by_inputs, |k| {
            slope(&|moved| moving(&mut moved.inputs, &unit::<INPUTS>(k)))
        });
        compare("by parameters", &found.by_parameters, |k| {
            slope(&|moved| moving(&mut moved.parameters, &unit::<3>(k)))
        });
        let mass = arm.mass_matrix(&state, &inputs)?;
        let inverse = arm.inverse_mass_matrix(&state, &inputs)?;
        compare("inverse", &(mass * inverse), unit);
        compare("inverse of the linearisation", &(mass * found.inverse_mass_matrix), unit);
        assert_eq!((mass, inverse), (mass.transpose(), inverse.transpose()));
    }
    Ok(())
}

/// Components of the quaternion: with the tangent vectors at the quaternion, derivatives along the rates. Along a change of
/// the length the derivative is zero.
#[test]
fn derivatives_by_quaternion_components_vanish_along_the_length() -> Result<(), Error> {
    for seed in 0..5 {
        let at = Arguments::random(seed);
        let (arm, state, inputs) = arm(&at)?;
        let found = arm.linearize(&state, &inputs)?;
        let quaternion = [at.q[0], at.q[1], at.q[2], at.q[3]];
        let by_components = found.by_quaternion(0, quaternion).expect("a ball");
        let vector = nalgebra::Vector4::from(quaternion);
        assert!((by_components * vector).amax() < 1e-13 * by_components.amax());
        for k in 0..3 {
            let along = displacement(&at, unit(k));
            let product =
                by_components * nalgebra::Vector4::new(along[0], along[1], along[2], along[3]);
            let off = (product - found.by_coordinates.column(k)).amax();
            assert!(off < 1e-13 * (1.0 + found.by_coordinates.amax()), "{off:e}");
        }
        // The second rotation in space is the elastic hinge's.
        assert!(found.by_quaternion(1, quaternion).is_some());
        assert!(found.by_quaternion(2, quaternion).is_none());
    }
    Ok(())
}

/// The displacement `δ` along the rates of a motion with `q̇ = N(q) v` changes by `δ̇ = dv + c`, where
/// `N c = (∂(N v)/∂q) N δ − (∂(N δ)/∂q) N v`: both displacements are one if they are done in either order.
#[test]
fn state_matrices_have_the_rates_of_displacements() -> Result<(), Error> {
    for seed in 0..10 {
        let at = Arguments::random(seed);
        let (arm, state, inputs) = arm(&at)?;
        let found = arm.linearize(&state, &inputs)?;
        let (a, b) = (found.a(), found.b());
        let lower = a.fixed_view::<RATES, { 2 * RATES }>(RATES, 0);
        assert_eq!(lower.fixed_view::<RATES, RATES>(0, 0), found.by_coordinates);
        assert_eq!(lower.fixed_view::<RATES, RATES>(0, RATES), found.by_rates);
        assert_eq!(
            a.fixed_view::<RATES, RATES>(0, RATES),
            SMatrix::<f64, RATES, RATES>::identity()
        );
        assert_eq!(b.fixed_view::<RATES, INPUTS>(0, 0), SMatrix::<f64, RATES, INPUTS>::zeros());
        assert_eq!(b.fixed_view::<RATES, INPUTS>(RATES, 0), found.by_inputs);
        // The derivative of `N(q) rates` along `N(q) along`.
        let second = |rates: [f64; RATES], along: [f64; RATES]| {
            let mut moved = at.map(Moved::from);
            moving(&mut moved.q, &displacement(&at, along));
            displacement(&moved, rates.map(Moved::from)).map(|entry| entry.derivative())
        };
        for k in 0..RATES {
            let (forth, back) = (second(at.v, unit(k)), second(unit(k), at.v));
            let c = displacement(&at, std::array::from_fn(|row| a[(row, k)]));
            for (entry, found) in c.into_iter().enumerate() {
                let expected = forth[entry] - back[entry];
                assert!((found - expected).abs() < 1e-13, "{k}: {found} {expected}");
            }
        }
    }
    Ok(())
}

/// The derivatives of inverse dynamics are those of forward dynamics with the mass matrix taken off.
#[test]
fn both_derivatives_agree() -> Result<(), Error> {
    for seed in 0..10 {
        let at = Arguments::random(seed);
        let (arm, state, inputs) = arm(&at)?;
        let found = arm.linearize(&state, &inputs)?;
        let accelerations = found.accelerations;
        let inverse = arm.inverse_dynamics_derivatives(&state, &accelerations, &inputs)?;
        let mass = arm.mass_matrix(&state, &inputs)?;
        let near = |a: SMatrix<f64, RATES, RATES>, b: SMatrix<f64, RATES, RATES>| {
            let off = (a - b).amax() / b.amax();
            assert!(off < 1e-11, "seed {seed}: {off:e}");
        };
        near(inverse.by_accelerations, mass);
        near(-(mass * found.by_coordinates), inverse.by_coordinates);
        near(-(mass * found.by_rates), inverse.by_rates);
    }
    Ok(())
}

/// Lanes compute the same bits.
#[test]
fn lanes_have_the_same_bits() -> Result<(), Error> {
    let at = Arguments::random(3);
    let (one, state, inputs) = arm(&at)?;
    let one = one.linearize(&state, &inputs)?;
    let (lanes, state, inputs) = arm(&at.map(NativeF64::constant))?;
    let lanes = lanes.linearize(&state, &inputs)?;
    let bits = |found: &[f64], lanes: &[NativeF64]| {
        for (found, lanes) in found.iter().zip(lanes) {
            assert_eq!(found.to_bits(), lanes.max_lane().to_bits());
        }
    };
    bits(one.by_coordinates.as_slice(), lanes.by_coordinates.as_slice());
    bits(one.by_rates.as_slice(), lanes.by_rates.as_slice());
    bits(one.by_inputs.as_slice(), lanes.by_inputs.as_slice());
    bits(one.by_parameters.as_slice(), lanes.by_parameters.as_slice());
    Ok(())
}

#[test]
fn infinite_states_are_refused() -> Result<(), Error> {
    let mut at = Arguments::random(0);
    at.v[4] = f64::INFINITY;
    let (arm, state, inputs) = arm(&at)?;
    assert_eq!(arm.linearize(&state, &inputs).err(), Some(Error::NotFinite(Origin::Rate(4))));
    assert_eq!(arm.mass_matrix(&state, &inputs).err(), Some(Error::NotFinite(Origin::Rate(4))));
    Ok(())
}
