mstmm::mstmm_chain! {
    chain T {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }
}

fn main() {}
