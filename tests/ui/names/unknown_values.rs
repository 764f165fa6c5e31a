mstmm::mstmm_chain! {
    chain Pendulum {
        param load = 1 kg;
        body Rod {
            mass = lode;
            com = [sqr(4), 0, 0] m;
            inertia = diag(0, mm, inertia) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
        hinge joint { torque = 5 * N; damping = N*m*s/rad; }
    }
}

fn main() {}
