//! The values of parameters are lent to be read.

use mstmm::prelude::*;

mstmm_chain! {
    plane chain Pendulum {
        gravity = [0, -9.8] m/s^2;
        param m = 1 kg;
        body Rod { mass = m; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {
    let mut chain = Pendulum::<f64>::new();
    chain.parameters().m = 100.0;
    *chain.parameters() = PendulumParameters { m: 100.0 };
    chain.changed_by_setters.derived()[0] = 100.0;
}
