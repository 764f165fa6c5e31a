mstmm::mstmm_chain! {
    chain { }
}

fn main() {}
