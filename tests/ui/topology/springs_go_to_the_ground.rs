mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar;
        spring first { on = crank; to = bar; stiffness = 3 N/m; }
        spring second { on = crank; to = bar.lug; stiffness = 3 N/m; }
        spring third { on = [crank, bar]; stiffness = 3 N/m; }
        spring fourth { on = crank; to = ground; stiffness = 3 N/m; }
    }
}

fn main() {}
