//! Kinds, words, names and fields with slips: each is one error, and what the chain is meant to offer is there.

use mstmm::prelude::*;

mstmm_chain! {
    pub chain Arm {
        gravty = input;
        parm payload = 0.5 kg;
        param knot[0] = 1 kg;
        body Link {
            mass = 1 kg + payload;
            com = [0.5, 0, 0] m;
            tip = [1, 0, 0] m;
            inertia = diag(0.1, 1/6, 1/6) kg*m^2 about com;
            pont lug = [0.5, 0.1, 0] m;
        }
        body Bead {
            weight = 1 kg + knot;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            J = diag(0.1, 1/6, 1/6) kg*m^2 about com;
        }
        bdy Tool { mass = 1 kg; com = [0.1, 0, 0] m; inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com; }
        movng deck -> pni(z) shoulder -> Link upper -> bal elbow -> Link lower
            -> repat 3 { pin y joint -> Bead bead } -> hook wrist -> Tool tool;
        hing shoulder { torque = inpt; }
        hinge elbow { moton = input; }
        hinge joint { tork = input; }
        lod wind { on = tool; forc = input; }
        load push { body = bead; force = "input"; }
    }
}

fn main() -> Result<(), mstmm::Error> {
    let mut arm = Arm::<f64>::new();
    arm.set_payload(0.5)?;
    arm.set_knot(|index| index as f64)?;
    let mut state = arm.initial_state();
    state.shoulder_mut().set_angle(1.0).set_rate(2.0);
    state.wrist_mut().set_angle(1.0);
    state.set_each_joint(|index| mstmm::PinState::new(index as f64, 0.0));
    let inputs = |_time: f64, state: &ArmState<f64>| ArmInputs {
        gravity: [0.0, -9.8, 0.0].into(),
        deck: mstmm::HingeMotion::default(),
        shoulder: -state.shoulder().angle(),
        elbow: mstmm::HingeMotion {
            state: mstmm::BallState::new([1.0, 0.0, 0.0, 0.0], [0.0; 3]),
            acceleration: [0.0; 3].into(),
        },
        joint: [1.0; 3],
        wind_force: [1.0, 0.0, 0.0].into(),
        push_force: [[1.0, 0.0, 0.0].into(); 3],
    };
    Rk4::new(1e-3).step(&arm, &mut state, inputs)?;
    let mut at = arm.workspace();
    arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
    println!("{} {}", at.upper().output().force(), at.elbow().effort());
    println!("{:?} {}", at.bead(1).map(|bead| bead.input().velocity()), at.wrist().effort());
    Ok(())
}
