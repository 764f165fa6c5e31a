//! Columns that are computed side by side have the bits of products with one vector, for every hinge, end and load.

use mstmm::nalgebra::SVector;
use mstmm::{Columns, Error, Scalar, mstmm_chain};

mstmm_chain! {
    chain Kinds {
        answers = [mass_matrix, linearize, push, derivatives, regressor, coriolis_matrix];
        gravity = input;
        param extra = 0.2 kg;
        param bend = 0.3;
        body Rod {
            mass = 1 kg + extra;
            com = [0.3, 0.1, 0] m;
            output = [0.6 m, 0 m, 0.2 m] turned rpy(0.3, bend, 0.1);
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point tip = [0.2, 0.5, -0.1] m;
        }
        body Cube {
            mass = 2 kg;
            com = [0.1, -0.1, 0.2] m;
            output = [0, 0.4, 0] m;
            inertia = diag(0.3, 0.4, 0.5) kg*m^2 about input;
        }
        moving deck -> repeat 2 { pin([1, 2, 3]) a -> Rod b -> slider(y) c -> Cube d
            -> screw(x, 5 cm/rev) e -> Rod f } -> floating g -> Cube h
            -> repeat 3 { cylindrical(y) i -> Rod j -> universal(x, [1, 0, 2]) k -> Cube l }
            -> elastic m -> Rod n -> planar(z) o -> Cube p -> weld fixed -> Rod r -> ball wrist -> Cube hand;
        h.output -> pin(x) side -> Rod arm -> pin(y) driven -> Rod finger;
        hinge a {
            rest = 0.2; stiffness = 30; damping = 0.5; armature = 0.2 kg*m^2; friction = 0.4 N*m;
            friction_speed = 0.1 rad/s; limits = [-0.5, 0.4] rad; limit_stiffness = 200;
            limit_damping = 2; torque = -3 N*m;
        }
        hinge driven { motion = input; }
        hinge i { force = input; torque = 2 N*m; }
        hinge m { stiffness = 100; turning_stiffness = [2, 3, 4]; }
        hinge wrist { rest = rpy(10, 20, 30) deg; stiffness = 20; damping = 0.3; torque = input; }
        load p1 { on = j; at = tip; force = input; }
        load p2 { on = hand; force = input; torque = input; }
        spring s { on = arm.output; to = hand.output; stiffness = 30 * bend; length = 0.4 m; damping = 2; }
        spring cord { on = b.output; to = [0, 1, 2] m; stiffness = 30 * bend; length = 0.4 m; }
    }
}

mstmm_chain! {
    plane chain Swing {
        answers = [mass_matrix, linearize, push, derivatives, regressor, coriolis_matrix];
        gravity = [1, -9.8] m/s^2;
        body Rod {
            mass = 1 kg; com = [0.3, 0.1] m; output = [0.6, 0.1] m turned 20 deg; inertia = 0.1 kg*m^2 about com;
        }
        ground -> repeat 5 { pin a -> Rod b -> slider c -> Rod d } -> planar e -> Rod f;
        hinge a { torque = input; damping = 0.1; friction = 0.2; friction_speed = 0.3; }
    }
}

mstmm_chain! {
    line chain Train {
        answers = [mass_matrix, linearize, push, derivatives, regressor, coriolis_matrix];
        gravity = 1 m/s^2;
        body Car { mass = 3 kg; output = 1 m; }
        ground -> repeat 7 { slider a -> Car b };
        hinge a { force = input; stiffness = 3; damping = 0.1; limits = [-0.1, 0.1] m; limit_stiffness = 50; }
    }
}

/// Compares all matrices of a chain with products with one vector, which have a single column.
macro_rules! compare {
    ($name:ident, $motors:literal, $chain:ident, $variation:ident, $linearization:ident, $derivatives:ident) => {
        fn $name<T: Scalar>() -> Result<(), Error> {
            let number = |k: usize| T::constant(0.3 - 0.17 * ((k * k) % 7) as f64);
            let chain = $chain::<T>::new();
            let mut state = chain.initial_state();
            state.q.iter_mut().enumerate().for_each(|(k, q)| *q += T::constant(0.3) * number(k));
            state.v.iter_mut().enumerate().for_each(|(k, v)| *v = number(k + 3));
            mstmm::Chain::normalize(&chain, &mut state);
            let inputs = chain.no_inputs();
            let zero = state.v.map(|_| T::constant(0.0));
            let (mut accelerations, mut change) = (zero, zero);
            let mut found = $linearization::<T>::default();
            chain.linearize_into(&state, &inputs, &mut found)?;
            macro_rules! along {
                ($field:ident, $matrix:ident, $equal:expr) => {
                    for (index, column) in found.$matrix.column_iter().enumerate() {
                        let mut direction = $variation::<T>::default();
                        direction.$field[index] = T::constant(1.0);
                        chain.push_into(
                            &state,
                            &inputs,
                            &direction,
                            &mut accelerations,
                            &mut change,
                        )?;
                        let is_equal: bool = $equal(column.as_slice(), change.as_slice());
                        assert!(is_equal, "{} {index}: {column:?} {change:?}", stringify!($field));
                        assert_eq!(found.accelerations, accelerations);
                    }
                };
            }
            along!(coordinates, by_coordinates, |column: &[T], change: &[T]| column == change);
            along!(rates, by_rates, |column: &[T], change: &[T]| column == change);
            along!(parameters, by_parameters, |column: &[T], change: &[T]| column == change);
            // The column of a motor is a column of the inverse mass matrix, and equal to the product up to rounding: the
            // product solves for accelerations of the order of one, with condition numbers below 1000.
            let mut motors = 0;
            along!(inputs, by_inputs, |column: &[T], change: &[T]| {
                let mut inverse = found.inverse_mass_matrix.column_iter();
                if !inverse.any(|inverse| inverse.as_slice() == column) {
                    return column == change;
                }
                motors += 1;
                let most = (T::constant(1e4) * T::epsilon()).max_lane();
                let is_close = |(&one, &other): (&T, &T)| (one - other).abs().max_lane() <= most;
                column.iter().zip(change).all(is_close)
            });
            assert_eq!(motors, $motors, "columns of motors");
            let mut derivatives = $derivatives::<T>::default();
            let mut coriolis = found.inverse_mass_matrix;
            chain.coriolis_matrix_into(&state, &inputs, &mut coriolis)?;
            chain.inverse_dynamics_derivatives_into(&state, &zero, &inputs, &mut derivatives)?;
            for (index, column) in found.inverse_mass_matrix.column_iter().enumerate() {
                let unit = SVector::from_fn(|row, _| T::constant(f64::from(row == index)));
                chain.inverse_mass_matrix_times_into(&state, &inputs, &unit, &mut change)?;
                assert_eq!(column, change, "column {index} of the inverse");
                chain.mass_matrix_times_into(&state, &inputs, &unit, &mut change)?;
                assert_eq!(derivatives.by_accelerations.column(index), change, "column {index}");
                chain.coriolis_matrix_times_into(&state, &inputs, &unit, &mut change)?;
                assert_eq!(coriolis.column(index), change, "column {index} of the Coriolis matrix");
            }
            let parameters = chain.dynamic_parameters();
            let regressor = chain.regressor(&state, &zero, &inputs)?;
            for (index, column) in regressor.column_iter().enumerate() {
                let mut unit = parameters.map(|_| T::constant(0.0));
                unit[index] = T::constant(1.0);
                chain.regressor_times_into(&state, &zero, &inputs, &unit, &mut change)?;
                assert_eq!(column, change, "column {index} of the regressor");
            }
            Ok(())
        }
    };
}

compare!(kinds, 6, Kinds, KindsVariation, KindsLinearization, KindsInverseDynamicsDerivatives);
compare!(swing, 5, Swing, SwingVariation, SwingLinearization, SwingInverseDynamicsDerivatives);
compare!(train, 7, Train, TrainVariation, TrainLinearization, TrainInverseDynamicsDerivatives);

#[test]
fn columns_have_the_bits_of_single_products() -> Result<(), Error> {
    const { assert!(<<f64 as Scalar>::Columns as Columns<f64>>::COUNT > 1, "the tests have lanes") }
    kinds::<f64>()?;
    kinds::<f32>()?;
    swing::<f64>()?;
    swing::<f32>()?;
    train::<f64>()?;
    train::<f32>()
}
