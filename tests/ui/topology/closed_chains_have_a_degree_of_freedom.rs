mstmm::mstmm_chain! {
    plane chain Triangle {
        body Bar { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Bar left -> pin b -> Bar right -> pin c -> ground at [1, 0] m;
    }

    chain Frame {
        body Bar {
            mass = 1 kg;
            com = [0.5, 0.1, 0] m;
            output = [1, 0, 0.3] m turned rpy(20, 30, 40) deg;
            inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin a -> Bar first -> universal b -> Bar second -> pin c -> ground at [1, 0, 0.5] m;
    }
}

fn main() {}
