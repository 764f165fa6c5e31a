//! All answers of a short chain and of a long one, as a controller asks for them, compiled separately: `.ci/run`
//! searches their assembly for panics and allocations.

use mstmm::Error;
use mstmm::linear::{DiscreteModel, discretize};
use mstmm::nalgebra::{SMatrix, SVector, Vector3};
use mstmm::prelude::*;

mstmm_chain! {
    /// An arm with a tool, a branch and springs.
    pub chain Arm {
        answers = [
            basic, kinematics, momentum, regressor, derivatives, linearize, push, pull, coriolis_matrix,
        ];
        gravity = [0, 0, -9.8] m/s^2;
        param payload = 0.5 kg;
        body Upper {
            mass = 2 kg; com = [0.2, 0, 0] m; output = [0.4, 0, 0] m; point tap = [0.1, 0.1, 0] m;
            inertia = diag(0.01, 0.05, 0.05) kg*m^2 about com;
        }
        body Tool { mass = 1 kg + payload; com = [0.1, 0, 0.1] m; inertia = diag(0.02, 0.02, 0.02) kg*m^2 about com; }
        ground -> ball shoulder -> Upper upper -> pin(y) elbow -> Tool tool;
        upper.tap -> slider(z) rail -> Tool weight;
        hinge shoulder { torque = input; damping = 0.1; }
        hinge elbow { torque = input; friction = 0.1; friction_speed = 0.01; armature = 0.02; }
        hinge rail { stiffness = 20; limits = [-0.1, 0.1]; limit_stiffness = 100; limit_damping = 1; }
    }

    /// A chain of forty links, whose matrices are computed column by column.
    pub plane chain Whip {
        answers = [
            basic, kinematics, momentum, regressor, derivatives, linearize, push, pull, coriolis_matrix,
        ];
        gravity = [0, -9.8] m/s^2;
        body Link { mass = 20 g; com = [1, 0] cm; output = [2, 0] cm; inertia = 1e-6 kg*m^2 about com; }
        ground -> pin root -> Link first -> repeat 39 { pin joint -> Link link };
        hinge root { torque = input; }
        hinge joint { stiffness = 1 N*m/rad; damping = 1e-4 N*m*s/rad; }
    }
}

/// The storage of the arm's answers.
pub struct ArmAnswers {
    /// Accelerations that inverse dynamics are given, and weights.
    pub given: SVector<f64, 5>,
    /// Efforts, or a product.
    pub vector: SVector<f64, 5>,
    /// A matrix with one row and column for each rate.
    pub matrix: SMatrix<f64, 5, 5>,
    /// The Jacobian of a point, by the kinematics and without them.
    pub jacobians: [SMatrix<f64, 6, 5>; 2],
    /// The inertia in operational space.
    pub operational_space: SMatrix<f64, 6, 6>,
    /// The momentum matrix.
    pub momentum: SMatrix<f64, 6, 5>,
    /// The kinematics.
    pub kinematics: ArmKinematics<f64>,
    /// The regressor.
    pub regressor: SMatrix<f64, 5, { Arm::<f64>::DYNAMIC_PARAMETERS.len() }>,
    /// The derivatives of inverse dynamics.
    pub derivatives: ArmInverseDynamicsDerivatives,
    /// The linearisation.
    pub linearization: ArmLinearization,
    /// A direction, and a gradient.
    pub variation: ArmVariation<f64>,
}

/// All answers of the arm.
#[inline(never)]
pub fn arm_answers(
    arm: &Arm<f64>,
    (state, inputs): (&ArmState<f64>, &ArmInputs<f64>),
    workspace: &mut ArmWorkspace<f64>,
    at: &mut ArmAnswers,
) -> Result<[f64; 2], Error> {
    arm.inverse_dynamics_into(state, &at.given, inputs, &mut at.vector)?;
    arm.inverse_solve_into(state, &at.given, inputs, workspace)?;
    arm.bias_efforts_into(state, inputs, &mut at.vector)?;
    arm.gravity_efforts_into(state, inputs, &mut at.vector)?;
    arm.passive_efforts_into(state, inputs, &mut at.vector)?;
    arm.mass_matrix_into(state, inputs, &mut at.matrix)?;
    arm.inverse_mass_matrix_into(state, inputs, &mut at.matrix)?;
    arm.mass_matrix_times_into(state, inputs, &at.given, &mut at.vector)?;
    arm.inverse_mass_matrix_times_into(state, inputs, &at.given, &mut at.vector)?;
    arm.coriolis_matrix_into(state, inputs, &mut at.matrix)?;
    arm.coriolis_matrix_times_into(state, inputs, &at.given, &mut at.vector)?;
    arm.kinematics_into(state, inputs, &mut at.kinematics)?;
    let point = at.kinematics.tool().com();
    at.jacobians[0] = point.jacobian();
    at.operational_space = arm.inverse_operational_space_inertia(state, inputs, &point)?;
    arm.tool_jacobian_into(state, inputs, &Vector3::new(0.1, 0.0, 0.1), &mut at.jacobians[1])?;
    let momentum = arm.momentum(state, inputs)?;
    arm.momentum_matrix_into(state, inputs, &mut at.momentum)?;
    arm.regressor_into(state, &at.given, inputs, &mut at.regressor)?;
    arm.inverse_dynamics_derivatives_into(state, &at.given, inputs, &mut at.derivatives)?;
    arm.linearize_into(state, inputs, &mut at.linearization)?;
    arm.push_into(state, inputs, &at.variation, &mut at.given, &mut at.vector)?;
    arm.pull_into(state, inputs, &at.vector, &mut at.given, &mut at.variation)?;
    let work = at.kinematics.upper().output().jacobian_times(&at.given);
    Ok([momentum.mass, work.norm()])
}

/// The discrete model of a step of the arm with held inputs.
#[inline(never)]
pub fn arm_discretized(
    arm: &Arm<f64>,
    (state, inputs): (&ArmState<f64>, &ArmInputs<f64>),
) -> Result<DiscreteModel<f64, 5, 4>, Error> {
    discretize(arm, state, inputs, 1e-3)
}

/// The matrices of the whip, which the caller lends storage for, and its products.
#[inline(never)]
pub fn whip_answers(
    whip: &Whip<f64>,
    (state, inputs): (&WhipState<f64>, &WhipInputs<f64>),
    (matrix, linearization): (&mut SMatrix<f64, 40, 40>, &mut WhipLinearization),
    (variation, change): (&mut WhipVariation<f64>, &mut [SVector<f64, 40>; 2]),
) -> Result<(), Error> {
    let [accelerations, change] = change;
    whip.mass_matrix_into(state, inputs, matrix)?;
    whip.inverse_mass_matrix_into(state, inputs, matrix)?;
    whip.coriolis_matrix_into(state, inputs, matrix)?;
    whip.linearize_into(state, inputs, linearization)?;
    whip.push_into(state, inputs, variation, accelerations, change)?;
    whip.pull_into(state, inputs, change, accelerations, variation)
}
