mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = core::f32::consts::PI;
            com = [0.5, 0, 0] m;
            output = [core::i32::MAX, 0, 0] m;
            inertia = diag(core::f32::consts::PI, 3, 3) kg*m^2 about com;
        }
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
