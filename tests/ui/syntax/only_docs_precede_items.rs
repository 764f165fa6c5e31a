mstmm::mstmm_chain! {
    chain Pendulum {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        #[cfg(test)]
        ground -> pin joint -> Rod rod;
    }
}

fn main() {}
