//! Names that the language forbids: each is one error, and where Rust can have it, it is there as written.

use mstmm::prelude::*;

mstmm_chain! {
    chain T {
        param time = 0.5 kg;
        param sqrt = 1 m;
        body pin {
            mass = 1 kg + time;
            com = [sqrt, 0, 0];
            output = [1, 0, 0] m;
            inertia = diag(1, 1, 1) kg*m^2 about com;
        }
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> pin q -> Rod energy -> ball gravity -> Rod hinge -> pin upper_mut -> Rod upper
            -> pin upper -> Rod new;
        hinge q { torque = input; }
        hinge gravity { start_rate = [1, 0, 0] rad/s; }
        load default { on = energy; force = input; }
        load default { on = hinge; torque = input; }
    }
}

fn main() -> Result<(), mstmm::Error> {
    let mut chain = T::<f64>::new();
    chain.set_time(0.5)?;
    chain.set_sqrt(chain.parameters().time())?;
    let mut state = chain.initial_state();
    state.q_mut().set_angle(1.0);
    state.gravity_mut().set_rate([1.0, 0.0, 0.0].into());
    let inputs = |_time: f64, state: &TState<f64>| TInputs {
        q: state.q().angle() + state.upper_mut().angle(),
        default_force: [1.0, 0.0, 0.0].into(),
        default_torque: [1.0, 0.0, 0.0].into(),
    };
    Rk4::new(1e-3).step(&chain, &mut state, inputs)?;
    let mut at = chain.workspace();
    chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
    println!("{} {}", at.energy().output().force(), at.hinge().input().moment());
    println!("{} {}", at.new().input().force(), at.gravity().effort());
    Ok(())
}
