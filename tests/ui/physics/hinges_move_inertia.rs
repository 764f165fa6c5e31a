mstmm::mstmm_chain! {
    chain Pin {
        body Point { mass = 1 kg; com = [0, 0, 0] m; inertia = diag(0, 0, 0) kg*m^2 about com; }
        ground -> pin(x) joint -> Point point;
    }

    chain Chain {
        param thickness = 0;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(thickness, 0.1, 0.1) kg*m^2 about com;
        }
        body Block { mass = 1 kg; com = [0, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; }
        ground -> ball first -> Block block -> repeat 10 { universal(x, y) turns -> Rod rod }
            -> cylindrical(x) tube -> Rod end;
    }

    chain Constant {
        body Rod {
            mass = core::f64::consts::PI;
            com = [core::f64::consts::PI, 0, 0] m;
            inertia = diag(0, core::f64::consts::PI, core::f64::consts::PI) kg*m^2 about com;
        }
        ground -> ball joint -> Rod rod;
    }

    chain Adrift {
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0, 0.1, 0.1) kg*m^2 about com; }
        Rod rod;
    }

    plane chain Flat {
        body Point { mass = 1 kg; com = [0, 0] m; output = [1, 0] m; inertia = 0 about com; }
        ground -> pin first -> Point point -> pin second -> Point end;
    }

    chain Closed {
        body Rod { mass = 1; com = [0.5, 0, 0]; output = [1, 0, 0]; inertia = diag(0, 0.1, 0.1) about com; }
        ground -> ball socket -> Rod rod -> ball slack -> Rod other -> ball last -> ground at [1, 0.5, 0];
    }
}

fn main() {}
