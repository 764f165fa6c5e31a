mstmm::mstmm_chain! {
    chain Pendulum {
        gravity = [0, -9.81, 0] m/s;
        body Rod {
            mass = 2 m;
            com = [0.5, 0, 0] kg;
            inertia = diag(0, 1/6, 1/6) kg about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            start = 3 m;
            start_rate = 30 deg;
            torque = 5 N;
        }
    }
}

fn main() {}
