mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = 2 kg + 1 m;
            com = [0.5 m, 1, 0];
            inertia = diag(0, 1/6, 1/6 kg) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            start = 30 deg + 1;
        }
    }
}

fn main() {}
