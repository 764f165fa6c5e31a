mstmm::mstmm_chain! {
    chain Pendulum {
        param time = 1 s;
        param parameter = 1 s;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin v -> Rod energy -> pin rates -> Rod rod;
    }
}

fn main() {}
