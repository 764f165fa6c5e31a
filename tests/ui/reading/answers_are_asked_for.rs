//! A method that the description does not ask for names the word to add; a method that it asks for compiles.

use mstmm::prelude::*;

mstmm_chain! {
    chain Silent {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
        hinge joint { torque = input; }
    }

    plane chain Asked {
        answers = [bias_efforts, mass_matrix, kinematics];
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
    }
}

mstmm_chain! {
    plane chain Closed {
        answers = inverse_dynamics;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> pin a -> Rod one -> pin b -> Rod two -> pin c -> Rod three -> pin d -> ground at [1, 0] m;
        hinge a, b, c { start = 90 deg; }
    }
}

mstmm_chain! {
    plane chain Rope {
        answers = [mass_matrix, linearize];
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> repeat 3 { pin joint -> Rod rod };
    }
}

/// A user's method with the name of an answer.
trait Regressor {
    fn regressor(&self) -> f64;
}

impl Regressor for Silent<f64> {
    fn regressor(&self) -> f64 {
        1.0
    }
}

fn main() -> Result<(), mstmm::Error> {
    let robot = Silent::<f64>::new();
    let (state, inputs) = (robot.initial_state(), SilentInputs { joint: 0.0 });
    let bias = robot.bias_efforts(&state, &inputs)?;
    let mass = robot.mass_matrix(&state, &inputs)?;
    println!("{}", mass[(0, 0)] * bias.norm() + robot.regressor());
    let mut dynamics = [[0.0; 2]; 2];
    robot.linearize_into(&state, &inputs, &mut dynamics)?;
    robot.push(&state, &inputs, &state.v)?;
    robot.pull_into(&state, &inputs, &state.v, &mut state.v.clone(), &mut dynamics)?;
    robot.rod_jacobian(&state, &inputs, &mstmm::nalgebra::Vector3::zeros())?;

    let pendulum = Asked::<f64>::new();
    let (state, inputs) = (pendulum.initial_state(), pendulum.no_inputs());
    let bias = pendulum.bias_efforts(&state, &inputs)?;
    pendulum.mass_matrix_times(&state, &inputs, &bias)?;
    pendulum.inverse_dynamics(&state, &bias, &inputs)?;
    pendulum.kinematics(&state, &inputs)?.rod().com().jacobian();

    let closed = Closed::<f64>::new();
    let (state, inputs) = (closed.initial_state(), closed.no_inputs());
    let efforts = closed.inverse_dynamics(&state, &state.v, &inputs)?;
    closed.inverse_solve_into(&state, &efforts, &inputs, &mut closed.workspace())?;

    let rope = Rope::<f64>::new();
    let (state, inputs) = (rope.initial_state(), rope.no_inputs());
    rope.mass_matrix(&state, &inputs)?;
    rope.coriolis_matrix(&state, &inputs)?;
    rope.rod_jacobian_into(&state, &inputs, &mstmm::nalgebra::Vector2::zeros(), &mut dynamics)?;
    mstmm::linear::discretize(&rope, &state, &inputs, 0.1)?;
    mstmm::linear::discretize(&closed, &closed.initial_state(), &closed.no_inputs(), 0.1)?;
    Ok(())
}
