//! The chains: every kind of hinge, of end and of force, a tree with parts and repetitions, all dimensions.

use super::asked::asked;
use crate::sample::{Draw, Sample};
use mstmm::nalgebra::Vector3;
use mstmm::{FloatingState, HingeMotion, PinState, Scalar, mstmm_chain};

mstmm_chain! {
    /// Seven pins at right angles, full tensors.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        answers = [basic, push];
        param payload = 0.5 kg;
        body Link {
            mass = 3 kg;
            com = [0.03, 0.1, -0.05] m;
            output = [0.08, 0.38, 0] m turned rpy(90, 0, 0) deg;
            inertia = tensor(0.05, 0.04, 0.03, 0.004, -0.003, 0.006) kg*m^2 about com;
        }
        body Hand {
            mass = 1 kg + payload;
            com = [0.01, -0.004, 0.06] m;
            inertia = diag(0.012, 0.01, 0.005) kg*m^2 about com;
        }
        ground at [0, 0, 0.333] m
            -> pin(z) j1 -> Link l1 -> pin(z) j2 -> Link l2 -> pin(z) j3 -> Link l3
            -> pin(z) j4 -> Link l4 -> pin(z) j5 -> Link l5 -> pin(z) j6 -> Link l6
            -> pin(z) j7 -> Hand hand;
        hinge j1, j2, j3, j4, j5, j6, j7 { torque = input; armature = 0.1; damping = 1; }
    }

    /// Hinges of all other kinds between a moving frame and a prescribed pin.
    pub chain Slides {
        gravity = input;
        answers = [basic, push];
        param payload = 1 kg;
        param slope = 0.1 m;
        body Block {
            mass = 1 kg + payload;
            com = [0.1 m, slope, 0.2 m];
            output = [0.5, 0, 0.1] m turned rpy(20, -10, 40) deg;
            inertia = tensor(0.4, 0.5, 0.6, 0.01, 0.02, -0.03) kg*m^2 about com;
            point side = [0.1, 0.4, 0] m turned rpy(0, 30, 0) deg;
        }
        moving deck -> slider(x) a -> Block b1 -> cylindrical(y) b -> Block b2
            -> universal(x, z) c -> Block b3 -> screw([1, 1, 0], 5 mm/rev) d -> Block b4
            -> planar(z) e -> Block b5 -> pin(y) shaker -> Block b6;
        b2.side -> elastic f -> Block b7 -> ball g -> Block b8;
        hinge a {
            force = input; stiffness = 300; rest = 0.2 m;
            limits = [-0.1, 0.1]; limit_stiffness = 1e3; limit_damping = 20;
        }
        hinge b { friction = 3; friction_speed = 0.05; turning_stiffness = 10; turning_damping = 1; }
        hinge c { torque = input; stiffness = [10, 20]; limits = [-0.2, 0.2]; limit_stiffness = 100; }
        hinge d { friction = 1; friction_speed = 0.1; armature = 0.2; }
        hinge e { stiffness = 200; turning_friction = 1; turning_friction_speed = 0.1; }
        hinge shaker { motion = input; }
        hinge f { stiffness = [300, 400, 500]; turning_stiffness = [20, 30, 40]; armature = 0.3; }
        hinge g { torque = input; stiffness = 5; damping = 0.3; rest = rpy(10, 20, 30) deg; }
    }

    /// A floating trunk with two legs of a part, a spring between them, and a repeated part with
    /// branches, a parameter and inputs for every repetition.
    pub chain Branched {
        gravity = [0, -9.8, 0] m/s^2;
        answers = [basic, push];
        param knot[2] = 0.1 kg;
        body Trunk {
            mass = 3 kg;
            com = [0.1, 0, 0.05] m;
            output = [0.5, 0, 0] m;
            inertia = tensor(0.3, 0.4, 0.5, 0.01, 0.02, -0.03) kg*m^2 about com;
            point left = [0.2, 0.3, 0] m turned rpy(10, 0, 20) deg;
            point right = [0.2, -0.3, 0] m turned rpy(-10, 0, -20) deg;
        }
        body Link {
            mass = 1 kg + knot;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point side = [0.2, 0.2, 0] m;
        }
        body Rung {
            mass = 0.5 kg;
            com = [0.1, 0.2, 0] m;
            inertia = diag(0.02, 0.01, 0.025) kg*m^2 about com;
            point end = [0.2, 0.4, 0.1] m;
        }
        part Leg(side) {
            body Thigh {
                mass = 0.8 kg;
                com = [0, side*0.02, -0.2] m;
                output = [0, 0, -0.4] m;
                inertia = tensor(0.02, 0.02, 0.005, side*0.001, 0, side*0.002) kg*m^2 about com;
            }
            universal(x, y) hip -> Thigh thigh -> pin(y) knee -> Rung shank;
            hinge hip { damping = 0.2; }
            hinge knee { torque = input; limits = [-0.2, 0.2]; limit_stiffness = 200; }
        }
        Trunk trunk -> repeat 2 { ball a -> Link link; link.side -> pin(z) b -> Rung rung; };
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        hinge a { stiffness = 20; friction = 0.2 N*m; friction_speed = 0.1 rad/s; }
        hinge b { torque = input; }
        spring cord { on = left.shank.end; to = right.shank.end; stiffness = 40; length = 0.4 m; }
        load push { on = rung; at = end; force = input; }
    }

    /// A floating chain in a plane.
    pub plane chain Raft {
        gravity = [0, -9.8] m/s^2;
        answers = [basic, push];
        param load = 0.5 kg;
        body Plank {
            mass = 2 kg + load; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com;
            output = [1.1, 0] m;
        }
        Plank first -> elastic a -> Plank second -> pin b -> Plank third -> slider(x) c -> Plank last;
        hinge a { stiffness = 400; damping = 3; turning_stiffness = 30; turning_damping = 0.5; }
        hinge b { torque = input; armature = 0.1; }
        hinge c { stiffness = 100; friction = 2; friction_speed = 0.1; }
        load wind { on = third; at = output; force = input; }
    }

    /// Along a line.
    pub line chain Train {
        answers = [basic, push];
        param freight = 1 kg;
        body Car { mass = 20 kg + freight; output = 15 m; }
        Car first -> elastic a -> Car second -> elastic b -> Car last;
        hinge a, b { stiffness = 1e3 N/m; damping = 10 N*s/m; }
        load engine { on = first; force = input; }
    }
}

/// Implements samples for generated chains: setters of their parameters and inputs, and the efforts of
/// motors in the order of the rates.
macro_rules! sample {
    (
        $name:ident $variation:ident: |$chain:ident, $inputs:ident, $draw:ident| $vary:block $set:block
        efforts $efforts:expr
    ) => {
        impl<T: Scalar> Sample for $name<T> {
            fn vary(&mut self, $draw: Draw<T>) {
                let $chain = self;
                $vary.expect("such a parameter");
            }

            fn inputs(&self, $draw: Draw<T>) -> Self::Inputs {
                let mut $inputs = self.no_inputs();
                $set
                $inputs
            }
        }
        asked! { $name $variation |$inputs| $efforts }
    };
}

/// Three numbers, as a vector.
fn three<T: Scalar>(draw: Draw<T>) -> Vector3<T> {
    [(); 3].map(|()| draw(-5.0, 5.0)).into()
}

fn zeros<T: Scalar>(count: usize) -> Vec<T> {
    vec![T::default(); count]
}

sample! {
    Arm ArmVariation: |chain, inputs, draw| { chain.set_payload(draw(0.0, 3.0)) } {
        let torques = [(); 7].map(|()| draw(-5.0, 5.0));
        [inputs.j1, inputs.j2, inputs.j3, inputs.j4, inputs.j5, inputs.j6, inputs.j7] = torques;
    }
    efforts vec![inputs.j1, inputs.j2, inputs.j3, inputs.j4, inputs.j5, inputs.j6, inputs.j7]
}
sample! {
    Slides SlidesVariation: |chain, inputs, draw| {
        chain.set_payload(draw(0.0, 3.0)).and_then(|()| chain.set_slope(draw(-0.1, 0.1)))
    } {
        inputs.gravity = three(draw);
        inputs.a = draw(-5.0, 5.0);
        inputs.c = [(); 2].map(|()| draw(-5.0, 5.0)).into();
        inputs.g = three(draw);
        let turned = T::sin_cos([draw(0.0, 3.0)]);
        let orientation = [turned.1[0], turned.0[0], T::default(), T::default()];
        inputs.deck = HingeMotion {
            state: FloatingState::new(
                three(draw).into(),
                orientation,
                three(draw).into(),
                three(draw).into(),
            ),
            acceleration: [(); 6].map(|()| draw(-5.0, 5.0)).into(),
        };
        let state = PinState::new(draw(-3.0, 3.0), draw(-3.0, 3.0));
        inputs.shaker = HingeMotion { state, acceleration: draw(-5.0, 5.0) };
    }
    efforts [
        vec![inputs.a],
        zeros(2),
        inputs.c.as_slice().to_vec(),
        zeros(4),
        zeros(6),
        inputs.g.as_slice().to_vec(),
    ]
    .concat()
}
sample! {
    Branched BranchedVariation: |chain, inputs, draw| { chain.set_knot(|_| draw(0.0, 1.0)) } {
        (inputs.left_knee, inputs.right_knee) = (draw(-5.0, 5.0), draw(-5.0, 5.0));
        inputs.b = [(); 2].map(|()| draw(-5.0, 5.0));
        inputs.push_force = [(); 2].map(|()| three(draw));
    }
    efforts [
        zeros(6 + 3),
        vec![inputs.b[0]],
        zeros(3),
        vec![inputs.b[1]],
        zeros(2),
        vec![inputs.left_knee],
        zeros(2),
        vec![inputs.right_knee],
    ]
    .concat()
}
sample! {
    Raft RaftVariation: |chain, inputs, draw| { chain.set_load(draw(0.0, 1.0)) } {
        inputs.b = draw(-5.0, 5.0);
        inputs.wind_force = [draw(-5.0, 5.0), draw(-5.0, 5.0)].into();
    }
    efforts [zeros(3 + 3), vec![inputs.b], zeros(1)].concat()
}
sample! {
    Train TrainVariation: |chain, inputs, draw| { chain.set_freight(draw(0.0, 20.0)) } {
        inputs.engine_force = draw(-100.0, 100.0);
    }
    efforts { let _ = inputs; zeros(3) }
}
