//! An angle of more than a turn without a unit is a warning on its token, which this program denies.

#![deny(warnings)]

mstmm::mstmm_chain! {
    chain Arm {
        param tilt = 40;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m turned rpy(0, -90, 0);
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin(z) shoulder -> Rod upper -> pin(z) elbow -> Rod lower -> pin hand -> Rod tip;
        hinge shoulder, elbow { start = 30; rest = 3*10; stiffness = 9; limits = [-90, 90] deg; limit_stiffness = 10; }
        hinge hand { start = tilt; rest = 40 deg; stiffness = 9; start_rate = 100; }
    }
}

fn main() {
    mstmm::mstmm_chain! {
        plane chain Swing {
            body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; }
            ground turned 45 -> pin joint -> Rod rod;
            hinge joint { start = 10*PI; rest = 100 rad; stiffness = 9; }
        }
    }
    let _ = (Arm::<f64>::new(), Swing::<f64>::new());
}
