mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank.lug -> pin b -> Rod bar;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank at lug -> pin b at [1, 0, 0] m -> Rod bar;
    }
}

fn main() {}
