mstmm::mstmm_chain! {
    chain Long {
        body Rod { mass = 1 kg; com = [1e200, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> pin a -> Rod rod;
    }
    chain Heavy {
        body Rod { mass = 1e200 kg; com = [1e100, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> pin a -> Rod rod;
    }
    chain Light {
        body Rod { mass = 1e-310 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> slider a -> Rod rod;
        hinge a { force = input; }
    }
    chain Stiff {
        body Rod { mass = 1 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        ground -> pin a -> Rod rod;
        hinge a { stiffness = 1e308 N*m/rad; start = 100 rev; rest = -100 rev; }
    }
    chain Far {
        body Rod {
            mass = 1 kg; com = [0.5, 0, 0] m; output = [1e200, 0, 0] m;
            inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin a -> Rod rod -> slider b -> Rod r2;
    }
}

fn main() {}
