mstmm::mstmm_chain! {
    chain Pendulum {
        gravty = [0, -9.81, 0] m/s^2;
        parm load = 1 kg;
        length = 1 m;
        bdy Lead {
            mass = 2 kg;
        }
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
