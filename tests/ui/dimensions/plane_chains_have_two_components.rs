mstmm::mstmm_chain! {
    plane chain Swing {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0] m turned rpy(0, 0, 90) deg;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        gravity = [0, 0, -9.8] m/s^2;
        ground at [1, 0, 0] m -> pin(x) a -> Bar one -> slider(z) b -> Bar two -> ball c -> Bar three;
    }
}

fn main() {}
