mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Leg(side, front) {
            pin haa -> Rod hip;
            load push { on = base; force = input; }
            hinge haa { start = side; damping = front; }
        }
        ground -> pin root -> Rod base;
        base.tip -> Leg(1) lf;
        base.tip -> Leg(1, [1, 2]) rf;
        base.tip -> Leg(1 kg, -1) lh;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Leg(front) { pin haa -> Rod hip; hinge haa { damping = front; } }
        part Beam { Rod near -> pin far; }
        ground -> pin root -> Rod base;
        base.tip -> pin a -> Leg(-1) lf;
        base.tip -> pin b -> Beam beam -> Leg(1) rf;
        base.tip -> pin c -> Beam other -> pin d -> Rod end;
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Leg { pin haa -> Rod hip; hinge haa { start = 1 rad; } }
        ground -> pin root -> Rod base;
        base.tip -> Leg lf;
        base.tip -> Leg lf;
        base.tip -> Leg(1) rf;
        base.tip -> Leg last;
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Leg { pin haa -> Rod hip; hinge haa { start = 1 rad; } }
        ground -> pin root -> Rod base;
        base.tip -> Leg lf;
        base.tip -> pin lf_haa -> Rod other;
        lf.hip -> pin a -> Rod x;
        lf.output -> pin b -> Rod y;
        lf.haa -> pin c -> Rod z;
        hinge lf.haa { start = 2 rad; }
        hinge lf { start = 2 rad; }
        hinge lf.hfe { start = 2 rad; }
    }
}

fn main() {}
