mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar -> pin c -> crank;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar -> pin c -> crank at lug;
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar;
        bar.output -> pin c -> Rod lever -> pin d -> ground at [1, 0, 0] m;
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        moving deck -> pin a -> Rod crank -> pin b -> moving deck;
    }
    chain E {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank;
        loop { crank -> pin b -> ground }
    }
}

fn main() {}
