mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
            point move = [1, 0.1, 0] m;
            point r#tip = [1, 0.1, 0] m;
            point clone = [1, -0.1, 0] m;
            point at = [1, -0.2, 0] m;
            point input = [0.5, 0, 0] m;
        }
        ground -> ball joint -> Bar bar;
    }
    chain PendulumBarResult {
        body Bar { mass = 2 kg; com = [0.5, 0, 0] m; inertia = diag(0, 1/6, 1/6) kg*m^2 about com; }
        ground -> pin joint -> Bar bar;
    }
}

fn main() {}
