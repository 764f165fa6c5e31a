mstmm::mstmm_chain! {
    chain Empty {
        gravity = [0, -9.81, 0] m/s^2;
    }
    chain Ground {
        ground;
    }
}

fn main() {}
