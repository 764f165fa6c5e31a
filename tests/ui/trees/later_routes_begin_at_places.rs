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
        one -> pin b -> Rod two;
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
        pin b -> Rod two;
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
        Rod two -> pin b -> Rod three;
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
        a -> pin b -> Rod two;
    }
    chain E {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Leg { pin a -> Rod thigh; }
        ground -> Leg leg;
        leg -> pin b -> Rod two;
    }
}

fn main() {}
