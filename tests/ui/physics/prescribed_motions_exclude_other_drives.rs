mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Bar one -> ball b -> Bar two;
        hinge a { motion = input; start = 30 deg; torque = 3 N*m; }
        hinge b { motion = 2; }
    }
}

fn main() {}
