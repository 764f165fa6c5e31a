mstmm::mstmm_chain! {
    chian Pendulum {}
    chain {}
}

fn main() {}
