mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> slider(x) a -> Bar one -> cylindrical(z) b -> Bar two -> universal c -> Bar three;
        hinge a { torque = 1 N*m; }
        hinge b { start = 1 m turned rpy(0, 0, 1); turning_dampng = 2 N*m*s/rad; }
        hinge c { start = 30 deg; }
    }
}

fn main() {}
