mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 0.1, 0] m;
        }
        ground -> ball joint -> Bar bar;
        load push { on = bra; force = input; }
        load pull { on = joint; force = input; }
        load turn { on = bar; at = tpi; torque = input; axes = bodies; }
    }
}

fn main() {}
