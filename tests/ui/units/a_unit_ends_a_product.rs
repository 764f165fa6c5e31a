mstmm::mstmm_chain! {
    chain Pendulum {
        param ratio = 2;
        body Rod {
            mass = 2 kg * 3;
            com = [(1 m) mm, 0, 0];
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            torque = 2 N * ratio;
        }
    }
}

fn main() {}
