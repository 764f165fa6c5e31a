mstmm::mstmm_chain! {
    chain Rope {
        body Rod { mass = 1; com = [0.5, 0, 0]; output = [1, 0, 0]; inertia = diag(0.1, 1, 1) about com; }
        Rod first -> repeat 3 { pin joint -> Rod rod } -> pin last -> ground;
    }
}

fn main() {}
