mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Bar first -> pin b -> Bar last;
    }
}

fn main() {}
