//! A chain of 45 rates without `repeat`, whose matrices are computed column by column.

use super::agree;
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{Error, mstmm_chain};

mstmm_chain! {
    chain Five {
        answers = [inverse_dynamics, regressor, mass_matrix];
        gravity = [0, -9.8, 1] m/s^2;
        body Rod {
            mass = 1.3 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> floating a1 -> Rod b1 -> ball c1 -> Rod d1;
        ground -> floating a2 -> Rod b2 -> ball c2 -> Rod d2;
        ground -> floating a3 -> Rod b3 -> ball c3 -> Rod d3;
        ground -> floating a4 -> Rod b4 -> ball c4 -> Rod d4;
        ground -> floating a5 -> Rod b5 -> ball c5 -> Rod d5;
        hinge c1, c3 { damping = 0.2; armature = 0.1; }
    }
}

const RATES: usize = 45;
/// Ten for each body, a rotor and a damper for each rate of two balls.
const PARAMETERS: usize = 10 * 10 + 2 * 6;

#[test]
fn matrices_of_many_rates_agree_with_products() -> Result<(), Error> {
    let chain = Five::<f64>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    for (k, rate) in state.v.iter_mut().enumerate() {
        *rate = 0.4 - 0.03 * k as f64;
    }
    let accelerations = SVector::<f64, RATES>::from_fn(|k, _| 0.1 * k as f64 - 1.0);
    let mut regressor = SMatrix::<f64, RATES, PARAMETERS>::zeros();
    chain.regressor_into(&state, &accelerations, &inputs, &mut regressor)?;

    let mut efforts = SVector::zeros();
    chain.inverse_dynamics_into(&state, &accelerations, &inputs, &mut efforts)?;
    let product = regressor * chain.dynamic_parameters();
    agree("Y π", product.as_slice(), efforts.as_slice());

    let any = SVector::<f64, PARAMETERS>::from_fn(|k, _| ((k * 7) % 11) as f64 - 5.0);
    chain.regressor_times_into(&state, &accelerations, &inputs, &any, &mut efforts)?;
    agree("Y x", (regressor * any).as_slice(), efforts.as_slice());

    let mut matrix = SMatrix::<f64, RATES, RATES>::zeros();
    chain.mass_matrix_into(&state, &inputs, &mut matrix)?;
    chain.mass_matrix_times_into(&state, &inputs, &accelerations, &mut efforts)?;
    agree("M x", (matrix * accelerations).as_slice(), efforts.as_slice());

    let columns = regressor.select_columns(&Five::<f64>::BASE_PARAMETERS);
    assert!(columns.column_iter().all(|column| column.norm() > 0.0));
    Ok(())
}
