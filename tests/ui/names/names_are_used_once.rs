mstmm::mstmm_chain! {
    chain Pendulum {
        param load = 1 kg;
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin load -> Bar -> ball elbow -> Bar -> pin elbow -> Bar elbow_mut;
    }
}

fn main() {}
