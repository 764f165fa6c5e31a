mstmm::mstmm_chain! {
    chain Pendulum {
        param input = 1 kg;
        param sin = 1 kg;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
