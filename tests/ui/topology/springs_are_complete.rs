mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> ball joint -> Bar bar;
        spring rope { on = bar; at = output; }
        spring ram { on = bar; to = [1, 0, 0] m; force = input; length = 1 m; }
    }
}

fn main() {}
