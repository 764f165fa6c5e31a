//! A parameter that its part does not use is a warning on the parameter.

#![deny(warnings)]

mstmm::mstmm_chain! {
    chain Walker {
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        part Leg(side, damping, _stiffness) {
            pin(x) hip -> Rod thigh -> pin(y) knee -> Rod shank;
            hinge hip { start = 0.1*side; }
        }
        ground -> floating base -> Rod trunk;
        trunk.input -> Leg(1, 2, 3) left;
        trunk.input -> Leg(-1, 2, 3) right;
    }
}

fn main() {
    let _ = Walker::<f64>::new();
}
