mstmm::mstmm_chain! {
    chain Pendulum {
        method = ricati;
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> bal joint -> Rodd rod;
    }
    chain Other {
        gravity = [0, 0, 0];
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        grond -> pin joint -> Rod rod;
    }
}

fn main() {}
