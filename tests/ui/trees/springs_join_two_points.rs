mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod crank -> pin b -> Rod bar;
        spring first { on = crank; to = bar; stiffness = 3 N/m; }
        spring second { on = crank.tip; to = bar.lug; stiffness = 3 N/m; }
        spring third { on = [crank, bar]; stiffness = 3 N/m; }
        spring fourth { on = crank; to = ground; stiffness = 3 N/m; }
        spring fifth { on = crank.tip; at = tip; to = bar.tip; stiffness = 3 N/m; }
        spring sixth { on = crank.tip; to = crank.output; stiffness = 3 N/m; }
        spring seventh { on = crank at tip; to = bar at tip; stiffness = 3 N/m; }
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod beam -> repeat 5 { ball knot -> Rod link }
            -> repeat 5 { ball other -> Rod ring };
        spring first { on = beam.tip; to = link.tip; stiffness = 3 N/m; }
        spring second { on = ring.tip; to = link.tip; stiffness = 3 N/m; }
        spring third { on = link.tip; to = last.link.tip; stiffness = 3 N/m; }
        spring fourth { on = beam.tip; to = last.link.tip; stiffness = 3 N/m; }
        spring fifth { on = last.link.tip; to = beam.tip; stiffness = 3 N/m; }
    }
}

fn main() {}
