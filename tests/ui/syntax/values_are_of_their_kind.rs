mstmm::mstmm_chain! {
    chain Pendulum {
        param load = [1, 2, 3] kg;
        body Rod {
            mass = [2, 0, 0] kg;
            com = 0.5 m;
            inertia = 1/6 kg*m^2;
        }
        ground -> pin joint -> Rod rod;
        hinge joint {
            start = rpy(0, 0, 30) deg;
        }
    }
}

fn main() {}
