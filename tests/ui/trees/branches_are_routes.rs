mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod left, pin c -> Rod right;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod crank -> { pin b -> Rod left, pin c -> Rod right };
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod crank;
        branch { crank -> pin b -> Rod bar }
    }
}

fn main() {}
