mstmm::mstmm_chain! {
    chain Pendulum {
        gravity = [0, -9.81, 0] m/s^2;
        gravity = [0, 0, 0] m/s^2;
        body Rod {
            mass = 2 kg;
            mass = 3 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            start = 0;
        }
        hinge joint {
            start = 1 rad;
        }
    }
}

fn main() {}
