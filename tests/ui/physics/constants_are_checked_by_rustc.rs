mstmm::mstmm_chain! {
    chain Pendulum {
        gravity = [0, 0, -1 / (core::f64::consts::PI - core::f64::consts::PI)] m/s^2;
        body Rod {
            mass = core::f64::consts::PI - 4;
            com = [0.5, 0, 0] m;
            output = [0, 0, core::f64::INFINITY];
            inertia = diag(core::f64::consts::E - 3, 1/6, 1/6) kg*m^2 about com;
        }
        body Plate {
            mass = core::f64::consts::PI;
            com = [0.5, 0, 0] m;
            inertia = diag(core::f64::consts::PI, 1, 1) kg*m^2 about com;
        }
        body Far {
            mass = core::f64::consts::PI;
            com = [1, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.1, 1, 1) kg*m^2 about input;
        }
        ground -> pin([core::f64::consts::PI - core::f64::consts::PI, 0, 0]) joint -> Rod rod
            -> universal(x, [core::f64::consts::PI, 0, 0]) cross -> Far far
            -> elastic last -> Plate plate;
        hinge joint { stiffness = 1 - core::f64::consts::PI; limits = [core::f64::consts::PI, 3]; limit_stiffness = 1; }
        hinge last { start = [0, 0, 0] m turned rpy(0, core::f64::consts::PI, 0); }
        spring rope { on = rod; to = [0, 0, 0]; stiffness = core::f64::consts::E - 3; }
    }
}

fn main() {}
