mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod one;
        ground -> pin b -> Rod two;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod one;
        one -> pin b -> Rod two;
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod one;
        pin b -> Rod two;
    }
}

fn main() {}
