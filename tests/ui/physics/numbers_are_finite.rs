mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = 1/0 kg;
            com = [sqrt(-1), 0, 0] m;
            inertia = diag(1e999, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
