mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = 2 KG;
            com = [0.5, 0, 0] furlong;
            inertia = diag(0, 1/6, 1/6) kgm about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
