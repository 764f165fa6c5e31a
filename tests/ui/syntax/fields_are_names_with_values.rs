mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass: 2 kg;
            com [0.5, 0, 0] m;
            = 3;
            inertia = ;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
