mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = tensor(1, 2, 4, 0, 0, 0) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
    chain Shifted {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 0.4, 0.4) kg*m^2 about input;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
