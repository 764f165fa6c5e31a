mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar;
        crank -> pin c -> Rod lever;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod left, pin c -> Rod right;
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> { pin b -> Rod left, pin c -> Rod right };
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        Rod hub -> pin b -> Rod left;
        Rod hub -> pin c -> Rod right;
    }
    chain E {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank;
        branch { crank -> pin b -> Rod bar }
    }
}

fn main() {}
