mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> universal(x, [-2, 0, 0]) joint -> Bar bar -> gimbal(x, y, -y) wrist -> Bar tip;
    }
}

fn main() {}
