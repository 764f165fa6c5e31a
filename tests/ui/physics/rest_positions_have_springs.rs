mstmm::mstmm_chain! {
    chain Refused {
        body Rod { mass = 1 kg; com = [1, 0, 0] m; output = [1, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        part Leg { pin(z) knee -> Rod shank; hinge knee { rest = 20 deg; } }
        ground -> pin(z) a -> Rod one -> pin(z) b -> Rod two -> elastic c -> Rod three -> ball d -> Rod four
            -> Leg left -> Leg right;
        hinge a, b { rest = 30 deg; }
        hinge a, left.knee { stiffness = 2 N*m/rad; }
        hinge c { rest = [1, 0, 0] mm; damping = 1 N*s/m; }
        hinge d { rest = rpy(0, 30, 0) deg; torque = input; }
    }
}

fn main() {}
