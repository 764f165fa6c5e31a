mstmm::mstmm_chain! {
    chain Arm {
        body Link {
            mass = -1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        body Tool {
            mass = 300 mm;
            com = [0, 0, 0] m;
            size = 2;
        }
        ground -> pin(z) shoulder -> Link upper -> pin(z) elbow -> ball wrist -> Tool tool;
    }
}

fn main() {}
