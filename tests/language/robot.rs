//! A robot arm as its data sheet has it, with a payload that changes at run time.

use mstmm::prelude::*;

mstmm_chain! {
    /// Seven pins, each about the z axis of its own frame.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        param payload = 0.5 kg;
        body L1 {
            mass = 4.97 kg;
            com = [0, 2, -48] mm;
            inertia = tensor(0.70, 0.71, 0.01, 0, 0.01, 0.02) kg*m^2 about com;
            output = [0, 0, 0] m turned rpy(-90, 0, 0) deg;
        }
        body L2 {
            mass = 0.65 kg;
            com = [-3, -29, 3] mm;
            inertia = tensor(0.008, 0.028, 0.026, -0.004, 0.010, 0.001) kg*m^2 about com;
            output = [0, -316, 0] mm turned rpy(90, 0, 0) deg;
        }
        body L3 {
            mass = 3.23 kg;
            com = [27, 39, -66] mm;
            inertia = tensor(0.037, 0.036, 0.011, -0.005, -0.011, -0.013) kg*m^2 about com;
            output = [82.5, 0, 0] mm turned rpy(90, 0, 0) deg;
        }
        body L4 {
            mass = 3.59 kg;
            com = [-53, 104, 27] mm;
            inertia = tensor(0.026, 0.020, 0.028, 0.008, -0.001, 0.009) kg*m^2 about com;
            output = [-82.5, 384, 0] mm turned rpy(-90, 0, 0) deg;
        }
        body L5 {
            mass = 1.23 kg;
            com = [-12, 41, -38] mm;
            inertia = tensor(0.036, 0.029, 0.009, -0.002, -0.004, 0.001) kg*m^2 about com;
            output = [0, 0, 0] m turned rpy(90, 0, 0) deg;
        }
        body L6 {
            mass = 1.67 kg;
            com = [60, -14, -11] mm;
            inertia = tensor(0.002, 0.004, 0.005, 0, -0.001, 0) kg*m^2 about com;
            output = [88, 0, 0] mm turned rpy(90, 0, 0) deg;
        }
        body L7 {
            mass = 0.74 kg + payload;
            com = [10, -4, 62] mm;
            inertia = tensor(0.0125, 0.010, 0.0048, 0, -0.001, -0.001) kg*m^2 about com;
        }
        ground at [0, 0, 333] mm
            -> pin(z) j1 -> L1 -> pin(z) j2 -> L2 -> pin(z) j3 -> L3 -> pin(z) j4 -> L4
            -> pin(z) j5 -> L5 -> pin(z) j6 -> L6 -> pin(z) j7 -> L7;
        hinge j1, j2, j3, j4, j5, j6, j7 { torque = input; }
        hinge j4 { start = -90 deg; }
        hinge j6 { start = 90 deg; }
    }
}

#[test]
fn an_arm_falls_without_torques_and_keeps_its_energy() -> Result<(), mstmm::Error> {
    let arm = Arm::<f64>::new();
    let mut state = arm.initial_state();
    let before = arm.energy(&state).total();
    let mut rk4 = Rk4::new(1e-4);
    for _ in 0..100 {
        rk4.step(&arm, &mut state, |_time, _state| arm.no_inputs())?;
    }
    let energy = arm.energy(&state);
    assert!(energy.kinetic > 0.01, "{energy:?}");
    // The integrator's error over a hundred small steps.
    assert!((energy.total() - before).abs() < 1e-8, "{before} {energy:?}");
    Ok(())
}

#[test]
fn the_base_carries_all_weight_at_rest() -> Result<(), mstmm::Error> {
    let mut arm = Arm::<f64>::new();
    let state = arm.initial_state();
    // A stiff arm: the torques that hold it, from the accelerations without them, one at a time.
    let weight = |arm: &Arm<f64>| -> Result<f64, mstmm::Error> {
        let free = arm.accelerations(&state, &arm.no_inputs())?;
        let columns = [0, 1, 2, 3, 4, 5, 6].map(|joint| inputs(|other| f64::from(other == joint)));
        let mut mobility = mstmm::nalgebra::SMatrix::<f64, 7, 7>::zeros();
        for (joint, unit) in columns.iter().enumerate() {
            mobility.set_column(joint, &(arm.accelerations(&state, unit)? - free));
        }
        let torques = mobility.lu().solve(&-free).expect("a regular arm");
        let mut at = arm.workspace();
        arm.solve_into(&state, &inputs(|joint| torques[joint]), &mut at)?;
        assert!(at.accelerations().amax() < 1e-9, "{}", at.accelerations());
        Ok(at.l1().input().force().z)
    };
    let masses = 4.97 + 0.65 + 3.23 + 3.59 + 1.23 + 1.67 + 0.74;
    assert!((weight(&arm)? - (masses + 0.5) * 9.81).abs() < 1e-9);
    arm.set_payload(2.0)?;
    assert!((weight(&arm)? - (masses + 2.0) * 9.81).abs() < 1e-9);
    assert!(arm.set_payload(-0.74).is_err());
    Ok(())
}

fn inputs(torque: impl Fn(usize) -> f64) -> ArmInputs<f64> {
    ArmInputs {
        j1: torque(0),
        j2: torque(1),
        j3: torque(2),
        j4: torque(3),
        j5: torque(4),
        j6: torque(5),
        j7: torque(6),
    }
}
