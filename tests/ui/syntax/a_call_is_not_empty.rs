mstmm::mstmm_chain! {}

fn main() {}
