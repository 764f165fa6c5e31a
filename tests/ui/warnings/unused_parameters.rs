//! A parameter on which no value depends is a warning on the parameter. One whose name begins with `_` has no warning, and its
//! generated methods have none.

#![deny(warnings)]

mstmm::mstmm_chain! {
    chain Arm {
        param damping = 0.1 N*m*s/rad;
        param load = 2 kg;
        param _later = 1 m;
        param offset[2] = 0 m;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin(z) shoulder -> Rod upper;
        hinge shoulder { damping = damping; }
    }
}

fn main() {
    let mut arm = Arm::<f64>::new();
    let _ = arm.set__later(2.0);
}
