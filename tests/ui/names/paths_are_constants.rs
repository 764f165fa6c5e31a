mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = Self::MASS;
            com = [rods::length(2), 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
