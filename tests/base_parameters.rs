//! The base parameters are as many as motions can identify: as the rank of regressors stacked over random states,
//! accelerations and inputs.

#[allow(dead_code)]
#[path = "combinations/sample.rs"]
mod sample;

use mstmm::description::Answer;
use mstmm::{Answers, mstmm_chain};
use nalgebra::DMatrix;
use sample::Sample;

// Inputs move these chains, or are their gravity.
mstmm_chain! {
    chain Cart {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        moving cart -> pin(y) joint -> Rod rod;
    }

    plane chain FlatCart {
        gravity = [0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, -0.5] m; output = [0, -1] m; inertia = 0.1 kg*m^2 about com; }
        moving cart -> pin joint -> Rod rod -> slider(x) gap -> Rod last;
        hinge joint { damping = 0.1; }
    }

    chain Driven {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> pin(y) joint -> Rod rod -> pin(x) drive -> Rod two;
        hinge drive { motion = input; }
    }

    chain DrivenBase {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> ball drive -> Rod rod -> pin(y) joint -> Rod two;
        hinge drive { motion = input; }
    }

    chain GivenGravity {
        gravity = input;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod -> slider(x) rail -> Rod two;
        load push { on = two; force = input; torque = input; axes = body; }
    }

    chain BetweenMovingEnds {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; point side = [0.1, 0.2, 0] m; }
        moving deck -> ball one -> Rod a -> pin(x) two -> Rod b -> ball three -> Rod c;
        moving cart -> pin(y) four -> Rod d;
        a.side -> weld fix -> Rod e -> pin(z) five -> Rod f;
        hinge two { motion = input; }
        hinge one { stiffness = 2; torque = input; }
        hinge five { torque = input; }
    }

    chain Closed {
        gravity = input;
        answers = regressor;
        body Bar { mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0] m; inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com; }
        moving deck -> ball a -> Bar first -> pin(x) b -> Bar second -> ball c -> moving cart;
        hinge b { motion = input; }
    }

    chain Floating {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Trunk { mass = 5 kg; com = [0.02, 0, 0.01] m; inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com; output = [0.1, 0, 0.3] m; point side = [0, 0.2, 0] m; }
        body Link { mass = 1 kg; com = [0.1, 0.02, -0.2] m; inertia = diag(0.01, 0.02, 0.03) kg*m^2 about com; output = [0, 0, -0.4] m; }
        Trunk trunk -> pin(y) hip -> Link thigh -> pin(y) knee -> Link shank;
        trunk.side -> universal(x, z) shoulder -> Link arm -> pin(x) elbow -> Link fore;
        hinge hip, shoulder { motion = input; }
    }

    /// The single rate of one branch has equations with the parameters of five bodies.
    chain Uneven {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Link { mass = 1 kg; com = [0.1, 0.02, -0.2] m; inertia = diag(0.01, 0.02, 0.03) kg*m^2 about com; output = [0.1, 0, -0.4] m; }
        ground -> pin(y) axle -> Link a -> universal(x, y) b -> Link b2 -> universal(z, x) c -> Link c2
            -> universal(x, y) d -> Link d2 -> universal(z, x) e -> Link e2;
        ground at [1, 0, 0] m -> ball f -> Link f2 -> ball g -> Link g2 -> ball h -> Link h2 -> ball i -> Link i2
            -> ball j -> Link j2;
        hinge b, c, d, e { motion = input; }
    }
}

// Gravity as an input; many rates on other branches than the pin's, and bodies from the free ends inward.
mstmm_chain! {
    /// The single rate of the pin has equations with ten parameters, the six of each floating body with as many.
    chain Sparse {
        gravity = input;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> floating a -> Rod one;
        ground -> floating b -> Rod two;
        ground -> floating c -> Rod three;
        ground -> floating d -> Rod four;
        moving cart -> pin(x) e -> Rod five;
    }

    chain Inward {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0.1, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        Rod fourth -> pin(x) a -> Rod third -> slider(y) b -> Rod second -> weld c -> Rod joined -> pin(z) d -> Rod first
            -> pin(x) e -> ground;
        hinge a, d { armature = 0.1; damping = 0.2; }
    }
}

// These have constant gravity and no prescribed motions.
mstmm_chain! {
    chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Link { mass = 2 kg; com = [0.25, 0.02, 0] m; output = [0.5, 0, 0] m; inertia = diag(0.001, 0.04, 0.04) kg*m^2 about com; }
        ground -> pin(-y) shoulder -> Link upper -> pin(-y) elbow -> Link fore;
        hinge shoulder, elbow { torque = input; damping = 0.3 N*m*s/rad; armature = 0.1 kg*m^2; }
    }

    chain Weightless {
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod -> slider(x) rail -> Rod two;
    }

    chain Balls {
        gravity = [0, 0, -9.81] m/s^2;
        answers = regressor;
        body Rod { mass = 1 kg; com = [0.1, 0.1, -0.5] m; output = [0, 0, -1] m; inertia = diag(0.1, 0.12, 0.05) kg*m^2 about com; }
        ground -> ball a -> Rod one -> ball b -> Rod two;
    }
}

macro_rules! of_sizes {
    ($($name:ident $m:ident;)*) => { $(
        mstmm_chain! {
            chain $name {
                gravity = [0, 0, -9.81] m/s^2;
                answers = regressor;
                body Rod {
                    mass = 1 kg; com = [0.1, 0.1, -0.5] $m; output = [0, 0.1, -1] $m;
                    inertia = diag(0.1, 0.12, 0.05) kg*$m^2 about com;
                    point side = [0.2, 0.3, 0] $m turned rpy(0.3, 0, 0.2);
                }
                ground -> pin(x) a -> Rod one -> slider([0, 1, 1]) b -> Rod two -> pin([0, 0.6, 0.8]) c -> Rod three
                    -> ball d -> Rod four;
                one.side -> universal e -> Rod five -> screw(z, 0.1 $m/rad) f -> Rod six -> elastic g -> Rod seven;
                moving cart -> pin(y) h -> Rod eight;
                hinge a, c, e { damping = 0.1 N*$m*s; armature = 0.2 kg*$m^2; }
                hinge b { armature = 0.2 kg; start = 0.1 $m; }
            }
        }
    )* };
}

of_sizes! { Micrometers um; Millimeters mm; Meters m; Kilometers km; Megameters Mm; }

/// The singular values of an identifiable combination are above the first, rounding errors below the second, relative to
/// the largest: those of a few hundred rows of sums of tens of products.
const PRESENT: f64 = 1e-7;
const ROUNDING: f64 = 1e-13;

fn rank(matrix: &DMatrix<f64>, name: &str) -> usize {
    let values = matrix.singular_values();
    let largest = values.max();
    let present = values.iter().filter(|value| **value > PRESENT * largest).count();
    let vanishing = values.iter().filter(|value| **value < ROUNDING * largest).count();
    assert_eq!(present + vanishing, values.len(), "{name}: the rank is not clear: {values}");
    present
}

/// Returns the regressors at random states, below each other.
fn stacked<C: Answers<Scalar = f64> + Default + Clone>() -> DMatrix<f64> {
    let regressor = |seed| {
        let mut sample = Sample::<C>::new(C::default(), seed);
        let entries = (0..sample.inputs.len()).filter(|&index| sample.is_orientation(index));
        for quaternion in entries.collect::<Vec<_>>().chunks(4) {
            let parts = [1.0, 0.0, 0.0, 0.0].map(|one| one + sample.random.between(-0.4, 0.4));
            let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
            quaternion.iter().zip(parts).for_each(|(&at, part)| sample.inputs[at] = part / length);
        }
        let accelerations = sample.vector(3.0);
        sample.matrix_of(Answer::Regressor, accelerations.as_slice())
    };
    // A single rate may have equations with the parameters of five bodies.
    let all: Vec<DMatrix<f64>> = (0..150).map(regressor).collect();
    let rows: Vec<_> = all.iter().flat_map(|part| part.row_iter()).collect();
    DMatrix::from_rows(&rows)
}

/// Compares the base parameters with the rank, and returns their number.
fn compare<C: Answers<Scalar = f64> + Default + Clone>(name: &str, base: &[usize]) -> usize {
    let all = stacked::<C>();
    assert_eq!(rank(&all, name), base.len(), "{name}: {base:?}");
    assert_eq!(rank(&all.select_columns(base), name), base.len(), "{name}: {base:?}");
    base.len()
}

macro_rules! compare {
    ($chain:ident) => {
        compare::<$chain<f64>>(stringify!($chain), &$chain::<f64>::BASE_PARAMETERS)
    };
}

#[test]
fn inputs_that_move_a_chain_identify_parameters() {
    // The moment about y depends on the first moments along x and z, on Iyy, on the three products, and on Ixx − Izz.
    assert_eq!(compare!(Cart), 7);
    assert_eq!(compare!(Driven), 9);
    assert_eq!(compare!(DrivenBase), 7);
    compare!(FlatCart);
    compare!(BetweenMovingEnds);
    compare!(Closed);
    compare!(Floating);
    compare!(Uneven);
    compare!(Sparse);
}

#[test]
fn gravity_as_an_input_identifies_parameters() {
    assert_eq!(compare!(GivenGravity), 6);
}

#[test]
fn constant_gravity_and_free_hinges_need_no_inputs() {
    // A moment and two first moments for each link, a rotor inertia of the second, and two dampers.
    assert_eq!(compare!(Arm), 3 + 3 + 1 + 2);
    compare!(Weightless);
    compare!(Balls);
    compare!(Inward);
}

#[test]
fn the_size_of_a_chain_does_not_matter() {
    let of_meters = Meters::<f64>::BASE_PARAMETERS;
    compare!(Meters);
    assert_eq!(Micrometers::<f64>::BASE_PARAMETERS[..], of_meters);
    assert_eq!(Millimeters::<f64>::BASE_PARAMETERS[..], of_meters);
    assert_eq!(Kilometers::<f64>::BASE_PARAMETERS[..], of_meters);
    assert_eq!(Megameters::<f64>::BASE_PARAMETERS[..], of_meters);
}
