mstmm::mstmm_chain! {
    chain Pendulum {
        gravity = [0, -1, 0] g;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            start_rate = 5 Hz;
        }
    }
}

fn main() {}
