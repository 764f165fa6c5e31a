//! Integrators and functions for any chain take the chain first and then the state.

use mstmm::prelude::*;

mstmm_chain! {
    plane chain Pendulum {
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
    }
}

fn print<C: Described>(chain: &C, state: &C::State) {
    let _ = (chain, state);
}

fn main() {
    let pendulum = Pendulum::<f64>::new();
    let mut state = pendulum.initial_state();
    let mut rk4 = Rk4::new(1e-3);
    let _ = rk4.advance_to(&mut state, &pendulum, 1.0, |_, _| pendulum.no_inputs());
    print(&state, &pendulum);
}
