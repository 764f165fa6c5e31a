mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Empty { }
        part Twice(x, x) { pin a -> Rod rod; hinge a { start = x; } }
        part Twice { pin a -> Rod rod; }
        part Rod { pin a -> Rod rod; }
        part Place { rod.tip -> pin a -> Rod rod; }
        part Held { ground -> pin a -> Rod rod; }
        ground -> Empty a -> Twice(1, 1) b -> Place c -> Held d;
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        param size = 2;
        part Leg(size) {
            param length = 2 m;
            method = riccati;
            part Toe { pin b -> Rod claw; }
            -> pin a -> Rod rod;
        }
        ground -> Leg(1) leg;
        part Late { pin a -> Rod rod; }
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        part Unused { pin a -> Rod rod; }
        part First { pin a -> Rod rod -> Second next; }
        part Second { pin b -> Rod bar -> First next; }
        part Chain { pin a -> Rod link -> repeat 3 { pin b -> Rod ring }; }
        ground -> First one -> repeat 2 { Chain two };
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        body LegHip {
            mass = 1 kg;
            com = [0, 0, 0] m;
            inertia = diag(1, 1, 1) kg*m^2 about com;
        }
        part Leg {
            body Hip {
                mass = 1 kg;
                com = [0, 0, 0] m;
                inertia = diag(1, 1, 1) kg*m^2 about com;
            }
            pin a -> Hip hip;
        }
        part Idle { pin a -> Rod rod; }
        ground -> pin root -> Rod base;
        base.tip -> Leg leg;
        base.output -> pin a -> LegHip hip;
    }
}

fn main() {}
