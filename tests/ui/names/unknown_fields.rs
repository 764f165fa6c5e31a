mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mas = 2 kg;
            com = [0.5, 0, 0] m;
            colour = 3;
            inertia = diagonal(0, 1/6, 1/6) kg*m^2 about con;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            angle = 30 deg;
            torque = inputs;
        }
        hinge elbow {
            start = 1 rad;
        }
    }
}

fn main() {}
