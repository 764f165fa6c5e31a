mstmm::mstmm_chain! {
    chain Pendulum {
        param body = 2;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin hinge -> Rod ground -> pin param -> Rod rod;
        hinge hinge {
            start = 1 rad;
        }
    }
}

fn main() {}
