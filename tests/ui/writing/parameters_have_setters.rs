//! What a chain keeps is out of reach in the module of its macro call as everywhere.

use mstmm::prelude::*;

mstmm_chain! {
    plane chain Pendulum {
        gravity = [0, -9.8] m/s^2;
        param m = 1 kg;
        body Rod { mass = m; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin joint -> Rod rod;
    }
}

mstmm_chain! {
    plane chain Rope {
        param knot[3] = 0 kg;
        body Rod { mass = 1 kg + knot; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> repeat 3 { pin joint -> Rod rod };
    }
}

fn main() {
    let mut chain = Pendulum::<f64>::new();
    chain.parameters.m = 100.0;
    chain.m = 100.0;
    chain.set_m = 100.0;
    chain.derived[0] = 100.0;
    let parameters = &mut chain.parameters;
    let Pendulum { parameters, .. } = &mut chain;
    chain = Pendulum { parameters: *chain.parameters(), ..chain };
    chain.changed_by_setters.parameters.m = 100.0;
    chain.changed_by_setters.derived[0] = 100.0;
    chain.changed_by_setters.parameters().m() = 100.0;
    (chain, _) = Pendulum::derive(PendulumParameters { m: -1.0 });

    let mut rope = Rope::<f64>::new();
    rope.parameters.knot[1] = 100.0;
    rope.knot[1] = 100.0;
    rope.derived0[0] = 100.0;
}
