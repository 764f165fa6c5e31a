mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> screw a -> Bar one -> screw(z, 5 mm) b -> Bar two -> universal(x) c -> Bar three
            -> gimbal(x, y) g -> Bar six
            -> planar(-z) d -> Bar four -> slider(w) e -> Bar five;
    }
}

fn main() {}
