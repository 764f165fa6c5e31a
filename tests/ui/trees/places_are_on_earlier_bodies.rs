mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod one;
        Rod.tip -> pin b -> Rod two;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod one;
        on.tip -> pin b -> Rod two;
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod one;
        two.tip -> pin b -> Rod three;
        one.tip -> pin c -> Rod two;
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod one;
        one.top -> pin b -> Rod two;
        one.com -> pin c -> Rod three;
        a.tip -> pin d -> Rod four;
        last.one.tip -> pin e -> Rod five;
    }
}

fn main() {}
