mstmm::mstmm_chain! {
    chain Pendulum {
        hinge joint {
            start = 30 deg;
        }
        ground -> pin joint -> Rod rod;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
    }
}

fn main() {}
