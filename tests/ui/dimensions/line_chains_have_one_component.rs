mstmm::mstmm_chain! {
    line chain Train {
        body Car {
            mass = 2 kg;
            output = [1, 0] m;
            inertia = 1/6 kg*m^2 about com;
        }
        gravity = [0, -9.8] m/s^2;
        ground at 1 m turned 90 deg -> slider(x) a -> Car one -> pin b -> Car two;
    }
}

fn main() {}
