//! A six-axis arm moves to a pose and holds it by gravity compensation and a PD controller in each joint.
//!
//! `cargo run --release --example robot_arm`; with `-- --page robot_arm.html` it also writes a page that shows the motion.

mod page;

use mstmm::Dual;
use mstmm::prelude::*;
use page::Page;

mstmm_chain! {
    /// Universal Robots' UR5, with the geometry and masses of `ur_description` (ROS-Industrial).
    chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        answers = bias_efforts;
        body Shoulder {
            mass = 3.7 kg; com = [0, 0.00193, -0.02561] m; inertia = diag(0.01027, 0.01027, 0.00666) kg*m^2 about com;
            output = [0, 0.13585, 0] m turned rpy(0, 90, 0) deg;
        }
        body UpperArm {
            mass = 8.393 kg; com = [0, -0.024201, 0.2125] m; inertia = diag(0.22689, 0.22689, 0.01511) kg*m^2 about com;
            output = [0, -0.1197, 0.425] m;
        }
        body Forearm {
            mass = 2.275 kg; com = [0, 0.0265, 0.11993] m; inertia = diag(0.04944, 0.04944, 0.0041) kg*m^2 about com;
            output = [0, 0, 0.39225] m turned rpy(0, 90, 0) deg;
        }
        body Wrist1 {
            mass = 1.219 kg; com = [0, 0.110949, 0.01634] m; inertia = diag(0.00256, 0.00256, 0.00219) kg*m^2 about com;
            output = [0, 0.093, 0] m;
        }
        body Wrist2 {
            mass = 1.219 kg; com = [0, 0.0018, 0.11099] m; inertia = diag(0.00256, 0.00256, 0.00219) kg*m^2 about com;
            output = [0, 0, 0.09465] m;
        }
        body Flange { mass = 0.1879 kg; com = [0, 0.001159, 0] m; inertia = diag(0.085, 0.085, 0.132) g*m^2 about com; }
        ground at [0, 0, 0.089159] m
            -> pin(z) pan -> Shoulder -> pin(y) lift -> UpperArm -> pin(y) elbow -> Forearm
            -> pin(y) wrist_1 -> Wrist1 -> pin(z) wrist_2 -> Wrist2 -> pin(y) wrist_3 -> Flange;

        hinge pan, lift, elbow, wrist_1, wrist_2, wrist_3 { torque = input; armature = 0.1 kg*m^2; }
    }
}

const TARGET: [f64; 6] = [1.0, -1.2, 1.5, -0.8, 0.6, 0.3]; // rad
const KP: [f64; 6] = [200.0, 200.0, 100.0, 20.0, 20.0, 20.0]; // N m/rad
const KD: [f64; 6] = [60.0, 60.0, 25.0, 4.0, 4.0, 4.0]; // N m s/rad

/// Returns the torques in N m: the bias torques, which balance gravity, and a PD controller.
fn control(arm: &Arm<f64>, state: &ArmState<f64>) -> Result<ArmInputs<f64>, mstmm::Error> {
    let bias = arm.bias_efforts(state, &arm.no_inputs())?;
    let torque = |i: usize| bias[i] + KP[i] * (TARGET[i] - state.q[i]) - KD[i] * state.v[i];
    let [pan, lift, elbow, wrist_1, wrist_2, wrist_3] = std::array::from_fn(torque);
    Ok(ArmInputs { pan, lift, elbow, wrist_1, wrist_2, wrist_3 })
}

fn main() -> Result<(), mstmm::Error> {
    let arm = Arm::<f64>::new();
    let mut state = arm.initial_state();
    let mut page = Page::of(&arm, 20);
    let mut rk4 = Rk4::new(1e-3);
    for _ in 0..8000 {
        page.record(&state, &control(&arm, &state)?)?;
        rk4.try_step(&arm, &mut state, |_time, state| control(&arm, state))?;
    }
    let holding = arm.bias_efforts(&state, &arm.no_inputs())?;
    println!("holding torques {:.3?} N m", holding.as_slice());
    // The torques that hold an arm are the gradient of its potential energy, which dual numbers compute.
    let mut variables = Arm::<Dual<f64, 6>>::new().initial_state();
    variables.q = Dual::variables(state.q.into()).into();
    let gradient = Arm::new().energy(&variables).potential.derivatives;
    for i in 0..6 {
        // The arm is in its pose, without the offset that gravity would cause.
        assert!((state.q[i] - TARGET[i]).abs() < 1e-6);
        assert!((holding[i] - gradient[i]).abs() < 1e-6);
    }
    page.write();
    Ok(())
}

#[test]
fn arm_holds_its_pose() -> Result<(), mstmm::Error> {
    main()
}
