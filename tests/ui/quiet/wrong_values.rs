//! Numbers are wrong: the types of the chain are there all the same.

use mstmm::prelude::*;

mstmm_chain! {
    chain Arm {
        gravity = input;
        answers = [push, linearize];
        param payload = 1 m;
        param knot[3] = 1 furlong;
        body Rod {
            mass = -1 kg + payload;
            com = [0.5, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 5, 0.1) kg*m^2 about com;
            point tip = [1, 0, 0] kg;
        }
        moving deck -> pin([0, 0, 0]) shoulder -> Rod upper -> repeat 3 { universal(x, x) joint -> Rod rod }
            -> elastic last -> Rod hand;
        hinge shoulder { torque = input; damping = -1; start = 1 kg; }
        hinge joint { motion = input; stiffness = 3; }
        hinge last { stiffness = 1 m; torque = input; }
        load wind { on = hand; force = input; }
    }
}

fn main() -> Result<(), mstmm::Error> {
    let mut arm = Arm::<f64>::new();
    arm.set_payload(2.0)?;
    arm.set_knot(|index| index as f64)?;
    let mut state = arm.initial_state();
    state.shoulder_mut().set_angle(1.0).set_rate(2.0);
    let inputs = |_time: f64, state: &ArmState<f64>| ArmInputs {
        gravity: [0.0, -9.8, 0.0].into(),
        shoulder: -state.shoulder().angle(),
        joint: [mstmm::HingeMotion::default(); 3],
        last: [0.0; 3].into(),
        wind_force: [1.0, 0.0, 0.0].into(),
        ..arm.no_inputs()
    };
    Rk4::new(1e-3).step(&arm, &mut state, inputs)?;
    let change = arm.push(&state, &arm.no_inputs(), &ArmVariation::default())?;
    let linearization: ArmLinearization<f64> = arm.linearize(&state, &arm.no_inputs())?;
    println!("{change:?} {:?}", linearization.by_rates);
    let mut at = arm.workspace();
    arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
    println!("{} {:?}", at.upper().output().force(), at.rod(1).map(|rod| rod.input().moment()));
    Ok(())
}
