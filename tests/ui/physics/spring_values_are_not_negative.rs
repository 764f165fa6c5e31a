mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        param slack = 2 m;
        ground -> ball joint -> Bar bar;
        spring rope {
            on = bar;
            at = output;
            to = [0, 3, 0] m;
            stiffness = -5 N/m;
            damping = -1 N*s/m;
            length = 1 m - slack;
        }
    }
}

fn main() {}
