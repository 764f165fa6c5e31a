//! Limbs of one shape side by side: a chain of `f64` computes them in packs, a chain of lanes one after the other. All
//! answers must agree, bit for bit except for the sign of zeros.

use mstmm::lanes::{NativeF32, NativeF64};
use mstmm::{Columns, Error, Mask, Scalar, mstmm_chain};

mstmm_chain! {
    /// A floating body with four legs, mirrored from left to right and from front to back, and two arms.
    pub chain Robot {
        gravity = [0, 0, -9.81] m/s^2;
        answers = [basic, bias_efforts, momentum, derivatives, linearize, push, pull];
        param damping = 0.1 N*m*s/rad;

        body Trunk {
            mass = 60 kg;
            com = [0.05, 0.02, 0] m;
            inertia = tensor(1.5, 8.5, 9.1, 0.02, -0.2, 0) kg*m^2 about com;
            point lf = [0.37, 0.2, 0] m turned rpy(0, 90, 180) deg;
            point rf = [0.37, -0.2, 0] m turned rpy(0, 90, 0) deg;
            point lh = [-0.37, 0.2, 0] m turned rpy(0, 90, 180) deg;
            point rh = [-0.37, -0.2, 0] m turned rpy(0, 90, 0) deg;
            point left = [0.4, 0.15, 0.3] m;
            point right = [0.4, -0.15, 0.3] m;
        }

        part Leg(side, front) {
            body Hip {
                mass = 2.9 kg;
                com = [0.04, 0, side*front*0.17] m;
                inertia = diag(0.05, 0.05, 0.01) kg*m^2 about com;
                output = [0.08, 0, 0] m turned rpy(side*90, 0, 0) deg;
            }
            body Shank {
                mass = 0.9 kg;
                com = [0.13, front*0.01, 0] m;
                inertia = tensor(0.002, 0.01, 0.01, front*0.001, 0, 0) kg*m^2 about com;
                output = [0.35, 0, 0] m;
            }
            pin(z) hip_joint -> Hip hip -> pin(z) knee -> Shank shank;
            hinge hip_joint, knee { torque = input; damping = damping; }
            load ground_force { on = shank.output; force = input; }
        }

        part Arm(side) {
            body Link {
                mass = 1.5 kg;
                com = [0.2, side*0.02, 0] m;
                inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
            }
            ball shoulder -> Link link;
        }

        Trunk trunk;
        trunk.lf -> Leg(1, 1) lf;
        trunk.rf -> Leg(-1, 1) rf;
        trunk.lh -> Leg(1, -1) lh;
        trunk.rh -> Leg(-1, -1) rh;
        trunk.left -> Arm(1) left;
        trunk.right -> Arm(-1) right;
    }
}

fn number<T: Scalar>(k: usize) -> T {
    T::constant(0.7 * (1.7 * k as f64).sin())
}

struct Sample<T> {
    robot: Robot<T>,
    state: RobotState<T>,
    inputs: RobotInputs<T>,
}

/// Returns the robot at a state that has no symmetry.
fn sample<T: Scalar>() -> Result<Sample<T>, Error> {
    let mut robot = Robot::<T>::new();
    robot.set_damping(T::constant(0.3))?;
    let mut state = robot.initial_state();
    for (k, q) in state.q.iter_mut().enumerate() {
        *q += number(k);
    }
    for (k, v) in state.v.iter_mut().enumerate() {
        *v = number(k + 40);
    }
    mstmm::Chain::normalize(&robot, &mut state);
    let mut inputs = RobotInputs::default();
    (inputs.lf_knee, inputs.rh_hip_joint) = (number(3), number(4));
    inputs.rf_ground_force_force = [5, 6, 7].map(number).into();
    Ok(Sample { robot, state, inputs })
}

fn direction<T: Scalar>() -> RobotVariation<T> {
    let mut direction = RobotVariation::default();
    direction.coordinates.iter_mut().enumerate().for_each(|(k, x)| *x = number(k + 80));
    direction.inputs.iter_mut().enumerate().for_each(|(k, x)| *x = number(k + 90));
    direction
}

/// Returns the numbers of all answers.
fn answers<T: Scalar>() -> Result<Vec<T>, Error> {
    let Sample { robot, state, inputs } = sample::<T>()?;
    let accelerations = robot.accelerations(&state, &inputs)?;
    let mut all: Vec<T> = accelerations.iter().copied().collect();
    let mut at = robot.workspace();
    robot.solve_into(&state, &inputs, &mut at)?;
    all.extend(at.accelerations.iter());
    let shank = at.rh_shank();
    all.extend(shank.input().force().iter());
    all.extend(shank.input().moment().iter());
    all.extend(robot.inverse_dynamics(&state, &accelerations, &inputs)?.iter());
    all.extend(robot.bias_efforts(&state, &inputs)?.iter());
    all.extend(robot.mass_matrix(&state, &inputs)?.iter());
    all.extend(robot.inverse_mass_matrix(&state, &inputs)?.iter());
    let derivatives = robot.inverse_dynamics_derivatives(&state, &accelerations, &inputs)?;
    all.extend(derivatives.by_coordinates.iter().chain(derivatives.by_rates.iter()));
    let linear = robot.linearize(&state, &inputs)?;
    all.extend(linear.a().iter());
    let (mut along, mut change) = (accelerations, accelerations);
    robot.push_into(&state, &inputs, &direction(), &mut along, &mut change)?;
    all.extend(change.iter());
    Ok(all)
}

/// Compares all lanes with the packed chain.
fn compare<T: Scalar + PartialEq, L: Scalar + Columns<T>>() -> Result<(), Error> {
    assert_eq!(<T::Pack as Columns<T>>::COUNT, 4, "limbs are not side by side");
    let (packed, lanes) = (answers::<T>()?, answers::<L>()?);
    assert_eq!(packed.len(), lanes.len());
    for (k, (&one, &all)) in packed.iter().zip(&lanes).enumerate() {
        assert!(one.is_finite().all(), "number {k} is {one:?}");
        assert!(all.values().all(|lane| lane == one), "number {k}: {one:?} and {all:?}");
    }
    Ok(())
}

#[test]
fn packs_of_f64_have_the_results_of_lanes() -> Result<(), Error> {
    compare::<f64, NativeF64>()
}

#[test]
fn packs_of_f32_have_the_results_of_lanes() -> Result<(), Error> {
    compare::<f32, NativeF32>()
}

/// The products with the inverse mass matrix leave out what one limb does not change in another. Products with the
/// matrices have the results of a sweep that does not use them.
#[test]
fn matrices_have_the_products_of_a_sweep() -> Result<(), Error> {
    let Sample { robot, state, inputs } = sample::<f64>()?;
    let linear = robot.linearize(&state, &inputs)?;
    let mut along = linear.accelerations;
    let mut change = along;
    let rates = along.len();
    for rate in 0..rates {
        for of_rate in [false, true] {
            let mut unit = RobotVariation::default();
            let entries = if of_rate { &mut unit.rates } else { &mut unit.coordinates };
            entries[rate] = 1.0;
            robot.push_into(&state, &inputs, &unit, &mut along, &mut change)?;
            let matrix = if of_rate { &linear.by_rates } else { &linear.by_coordinates };
            let off = (matrix.column(rate) - change).abs().max();
            let size = linear.inverse_mass_matrix.abs().max() * 100.0;
            // Efforts change by up to 100 N or N m; sums of twenty products, and about fifty roundings of each.
            assert!(off < 1000.0 * f64::EPSILON * size, "rate {rate}, {of_rate}: {off:e}");
        }
    }
    let direction = direction();
    robot.push_into(&state, &inputs, &direction, &mut along, &mut change)?;
    let products =
        linear.by_coordinates * direction.coordinates + linear.by_inputs * direction.inputs;
    let off = (products - change).abs().max() / change.abs().max();
    assert!(off < 1000.0 * f64::EPSILON, "{off:e}");
    Ok(())
}
