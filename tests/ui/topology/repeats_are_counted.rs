mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> repeat 0 { pin a -> Bar one } -> repeat 2.5 { pin b -> Bar two } -> repeat 3 { }
            -> repeat 4 { repeat 5 { pin c -> Bar three } } -> pin d -> Bar four;
    }
}

fn main() {}
