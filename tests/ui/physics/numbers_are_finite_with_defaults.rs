mstmm::mstmm_chain! {
    chain Pendulum {
        param turns = 0;
        param below = -1;
        gravity = [0, 0, 1 / turns];
        body Bar {
            mass = 1 / turns;
            com = [sqrt(below), 0, 0] m;
            output = [1, 0, 0] m turned rpy(0, 0, 1 / turns);
            inertia = diag(1 / turns, 1/6, 1/6) kg*m^2 about com;
        }
        ground turned quaternion(turns, turns, 0, 0)
            -> screw(z, 0.1 / turns) joint -> Bar bar -> pin([1 / turns, 0, 0]) last -> Bar end;
        hinge joint, last { stiffness = 1 / turns; start = sqrt(below); }
        hinge last { torque = 1 / turns; }
    }
}

fn main() {}
