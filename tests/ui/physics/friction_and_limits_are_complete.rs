mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Bar one -> floating b -> Bar two;
        hinge a { friction = 0.1 N*m; limits = [-30, 30] deg; }
        hinge b { turning_limit_damping = 1 N*m*s/rad; }
    }
}

fn main() {}
