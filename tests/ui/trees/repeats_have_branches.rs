mstmm::mstmm_chain! {
    chain A {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod beam -> repeat 5 {
            ball knot -> Rod link;
            beam.tip -> pin b -> Rod left;
            last.link.tip -> pin c -> Rod right;
            last.beam.tip -> pin d -> Rod middle;
        };
    }
    chain B {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod beam
            -> repeat 5 from beam.tip = link.tip, link.output = link.tip, link.tip = beam.tip, link.tip = beam.tip {
                ball knot -> Rod link
            };
    }
    chain C {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod beam -> repeat 5 from link = beam.tip { ball knot -> Rod link };
    }
    chain D {
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 1/6, 1/6) kg*m^2 about com;
            point tip = [1, 1, 0] m;
        }
        ground -> pin a -> Rod beam -> repeat 5 from last.link.tip = beam.tip {
            ball knot -> Rod link;
            last.link.tip -> pin b -> Rod left;
        };
    }
}

fn main() {}
