//! Closed chains with branches, repeated parts and prescribed hinges: their answers are those of the open chain, and the
//! accelerations satisfy M v̇ + bias = τ + Gᵀ λ.

use super::differences::jacobians;
use super::identities::{coriolis_matrix, mass_matrix, momentum, regressor};
use super::sample::{Sample, off_by};
use mstmm::GeneratedChain;
use mstmm::prelude::*;
use nalgebra::{DMatrix, DVector};

mstmm_chain! {
    pub chain Linkage {
        gravity = input;
        answers = [basic, bias_efforts, momentum, regressor, coriolis_matrix];
        param more = 0.7 kg;
        param length = 0.6 m;
        body Block {
            mass = 1 kg + more;
            com = [0.2, 0.1, -0.1] m;
            output = [length, 0.1 m, 0.05 m] turned rpy(0.3, -0.2, 0.1);
            inertia = tensor(0.3, 0.4, 0.5, 0.02, -0.03, 0.01) kg*m^2 about com;
            point tip = [0.1, 0.3, 0.2] m;
        }
        body Small {
            mass = 0.3 kg;
            com = [0.1, 0.02, 0.03] m;
            output = [0.4, 0, 0.1] m;
            inertia = diag(0.05, 0.06, 0.07) kg*m^2 about com;
            point side = [0, 0.1, 0.2] m;
        }
        ground -> universal(x, y) gimbal -> Block first -> slider([1, 1, 0]) drive -> Small second
            -> pin(z) knee -> Block third -> ball joint -> Small fourth -> cylindrical(z) sleeve -> Small fifth
            -> ball end -> moving deck;
        first.tip -> repeat 2 { pin(x) branch -> Small rod; rod.side -> slider(y) pump -> Small piston };
        fourth.side -> pin(y) tail -> Small flap;
        hinge drive, pump { motion = input; }
        hinge knee { torque = input; stiffness = 2; }
        hinge branch { torque = input; damping = 0.1; }
        load push { on = flap; force = input; }
        spring stay { on = flap; to = [1, 2, 3] m; stiffness = 3 N/m; }
    }

    pub plane chain FlatLinkage {
        gravity = [0, -9.81] m/s^2;
        answers = [basic, bias_efforts, momentum, regressor, coriolis_matrix];
        param more = 0.7 kg;
        body Block {
            mass = 1 kg + more;
            com = [0.2, 0.1] m;
            output = [1, 0.1] m turned 0.3;
            inertia = 0.3 kg*m^2 about com;
            point tip = [0.1, 0.3] m;
        }
        moving deck -> pin crank -> Block first -> pin knee -> Block second
            -> repeat 2 { slider([1, 0.2]) rail -> Block link } -> pin elbow -> Block last
            -> pin end -> ground at [2, 1] m;
        first.tip -> slider pump -> Block side;
        link.tip -> planar float -> Block plate;
        hinge pump { motion = input; }
        hinge crank { torque = input; damping = 0.1; }
        hinge rail { force = input; armature = 0.2; }
        hinge knee { friction = 0.2; friction_speed = 0.1; }
    }
}

/// Returns a basis of the vectors with G b = 0.
fn null_space(jacobian: &DMatrix<f64>) -> DMatrix<f64> {
    let squares = (jacobian.transpose() * jacobian).symmetric_eigen();
    let kept = (0..jacobian.ncols()).filter(|&index| squares.eigenvalues[index].abs() < 1e-9);
    let columns: Vec<_> = kept.map(|index| squares.eigenvectors.column(index)).collect();
    DMatrix::from_columns(&columns)
}

macro_rules! check {
    ($name:ident, $rows:expr) => {{
        let mut assembled = 0;
        for seed in 0..12 {
            println!("seed {seed}");
            let mut sample = Sample::new($name::<f64>::new(), seed);
            let inputs = sample.typed_inputs();
            if GeneratedChain::assemble(&sample.chain, &mut sample.state, &inputs).is_err() {
                continue;
            }
            assembled += 1;
            mass_matrix(&mut sample);
            coriolis_matrix(&mut sample);
            regressor(&mut sample);
            momentum(&sample);
            if seed < 2 {
                jacobians(&sample);
            }
            let jacobian = sample.chain.closure_jacobian(&sample.state, &inputs).expect("finite");
            let jacobian = DMatrix::from_column_slice($rows, sample.count(), jacobian.as_slice());
            let free = null_space(&jacobian);
            assert_eq!(free.ncols(), sample.count() - $rows);
            // The power of the loop constraints along rates that keep the chain closed is zero.
            let reactions = sample.inverse_dynamics(&sample.accelerations()) - motors(&sample);
            let power = free.transpose() * &reactions;
            let none = DVector::zeros(free.ncols());
            let off = off_by(&power, &none) / (1.0 + reactions.amax());
            assert!(off < 1e-11, "power of the reactions: {off:e}");
        }
        assert!(assembled > 6, "only {assembled} states can be assembled");
    }};
}

/// The efforts of the motors, in the order of the rates; they have the names of their inputs.
fn motors<C: mstmm::Answers<Scalar = f64> + Clone>(sample: &Sample<C>) -> DVector<f64> {
    let rates = C::DESCRIPTION.rates();
    let name = |index: usize| rates.get(index).expect("a rate").name.to_string();
    DVector::from_fn(sample.count(), |index, _| {
        let hinge = name(index);
        let hinge = hinge.split('.').next().expect("a hinge");
        let input = (0..sample.inputs.len()).find(|&input| sample.input_name(input) == hinge);
        input.map_or(0.0, |input| sample.inputs[input])
    })
}

#[test]
fn in_space() {
    check!(Linkage, 6);
}

#[test]
fn in_a_plane() {
    check!(FlatLinkage, 3);
}
