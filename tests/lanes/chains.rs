//! The chains: every kind of hinge, of end and of force, both methods.

use mstmm::nalgebra::Vector3;
use mstmm::{FloatingState, HingeMotion, PinState, Scalar, mstmm_chain};

use super::sample::{Draw, Sample};

/// Implements samples for generated chains: setters of their parameters and inputs.
macro_rules! sample {
    ($($name:ident)*: |$chain:ident, $inputs:ident, $draw:ident| $vary:block $set:block) => { $(
        impl<T: Scalar> Sample for $name<T> {
            fn vary(&mut self, $draw: Draw<T>) {
                let $chain = self;
                $vary.expect("such a parameter");
            }

            #[allow(unused_mut, unused_variables)]
            fn inputs(&self, $draw: Draw<T>) -> Self::Inputs {
                let mut $inputs = self.no_inputs();
                $set
                $inputs
            }
        }
    )* };
}

macro_rules! arm {
    ($name:ident $method:ident) => {
        mstmm_chain! {
            /// Seven pins at right angles, full tensors.
            pub chain $name {
                method = $method;
                gravity = [0, 0, -9.81] m/s^2;
                param payload = 0 kg;
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
        }
    };
}

arm! { Arm riccati }
arm! { ArmByTransfer transfer }

mstmm_chain! {
    /// Quaternions with springs and motors.
    pub chain Balls {
        gravity = [0, -9.8, 0] m/s^2;
        param stiffness = 20 N*m/rad;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball a -> Cube upper -> ball b -> Cube middle -> ball c -> Cube lower;
        hinge a { torque = input; stiffness = stiffness; damping = 0.3; rest = rpy(10, 20, 30) deg; }
        hinge b { limits = 0.3 rad; limit_stiffness = 500; limit_damping = 3; }
        hinge c { friction = 2 N*m; friction_speed = 0.1 rad/s; armature = 0.1 kg*m^2; }
    }

    /// Translations and rotations with springs, limits and friction.
    pub chain Slides {
        gravity = input;
        param payload = 1 kg;
        param slope = 0.1 m;
        body Block {
            mass = 1 kg + payload;
            com = [0.1 m, slope, 0.2 m];
            output = [0.5, 0, 0.1] m turned rpy(20, -10, 40) deg;
            inertia = tensor(0.4, 0.5, 0.6, 0.01, 0.02, -0.03) kg*m^2 about com;
        }
        ground -> slider(x) a -> Block b1 -> cylindrical(y) b -> Block b2
            -> universal(x, z) c -> Block b3 -> screw([1, 1, 0], 5 mm/rev) d -> Block b4
            -> planar(z) e -> Block b5;
        hinge a {
            force = input; stiffness = 300; rest = 0.2 m;
            limits = [-0.1, 0.1]; limit_stiffness = 1e4; limit_damping = 20;
        }
        hinge b { friction = 3; friction_speed = 0.05; turning_stiffness = 10; turning_damping = 1; }
        hinge c { stiffness = [10, 20]; limits = [-0.2, 0.2]; limit_stiffness = 100; }
        hinge d { friction = 1; friction_speed = 0.1; armature = 0.2; }
        hinge e { stiffness = 200; turning_friction = 1; turning_friction_speed = 0.1; }
    }

    /// A free body, elastic hinges, loads and a spring to the ground.
    pub chain Afloat {
        gravity = [0, -9.8, 0] m/s^2;
        param length = 0.5 m;
        body Link {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        Link first -> elastic a -> Link second -> elastic b -> Link third;
        hinge a { stiffness = 400; damping = 3; turning_stiffness = 30; turning_damping = 0.5; }
        hinge b { stiffness = [300, 400, 500]; turning_stiffness = [20, 30, 40]; }
        load wind { on = third; at = output; force = input; torque = input; axes = body; }
        spring rope {
            on = second; at = com; to = [1, 2, 0] m; stiffness = 50; damping = 1; length = length;
        }
    }

    /// A loop in a plane.
    pub plane chain Loop {
        gravity = [0, -9.8] m/s^2;
        param load = 0 kg;
        body Crank {
            mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.4, 0] m;
        }
        body Coupler {
            mass = 2 kg + load; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com;
            output = [1.1, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.7, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.9, 0] m;
        hinge a { start = 60 deg; torque = input; }
        hinge b { start = -50 deg; stiffness = 5; damping = 0.3; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; stiffness = 3; damping = 0.2; }
    }

    /// A loop in space with three redundant constraints at its last pin.
    pub chain Parallelogram {
        gravity = [0, -9.81, 0] m/s^2;
        param load = 0 kg;
        body Crank {
            mass = 1 kg; com = [0.15, 0, 0] m; output = [0.3, 0, 0] m;
            inertia = diag(0.001, 0.03, 0.03) kg*m^2 about input;
        }
        body Rod {
            mass = 2 kg + load; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(0.001, 1/6, 1/6) kg*m^2 about com;
        }
        ground -> pin a -> Crank left -> pin b -> Rod rod
               -> pin c -> Crank right -> pin d -> ground at [1, 0, 0] m;
        hinge a { start = 60 deg; torque = input; }
        hinge b { start = -60 deg; }
        hinge c { start = -120 deg; }
        hinge d { start = 120 deg; }
    }

    /// Repeated parts, with a parameter and an input for every repetition.
    pub chain Repeated {
        gravity = [0, -9.8, 0] m/s^2;
        param knot[6] = 0.1 kg;
        body Rod {
            mass = 1 kg + knot;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> repeat 6 { pin(y) a -> Rod upper -> ball b -> Rod lower };
        hinge a { torque = input; stiffness = 30; }
        hinge b { stiffness = 20; damping = 0.4; }
    }

    /// Along a line.
    pub line chain Train {
        param freight = 1 t;
        body Car { mass = 20 t + freight; output = 15 m; }
        Car first -> elastic a -> Car second -> elastic b -> Car last;
        hinge a, b { stiffness = 1e6 N/m; damping = 1e4 N*s/m; }
        load engine { on = first; force = input; }
    }

    /// A hinge and an end with prescribed motions.
    pub chain Told {
        gravity = [0, -9.8, 0] m/s^2;
        param payload = 0 kg;
        body Link {
            mass = 1 kg + payload;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
        }
        moving deck -> ball a -> Link upper -> pin(y) shaker -> Link middle -> ball b -> Link lower;
        hinge a { stiffness = 20; }
        hinge shaker { motion = input; }
        hinge b { stiffness = 10; damping = 0.3; }
    }

    /// A tree: a floating trunk with two legs of a part, a spring between them, and a repeated part
    /// with branches, a parameter and inputs for every repetition.
    pub chain Branched {
        gravity = [0, -9.8, 0] m/s^2;
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

    /// A tree on a hinge with a prescribed motion, in a loop with a branch.
    pub plane chain ToldLoop {
        gravity = [0, -9.8] m/s^2;
        param load = 0 kg;
        body Crank {
            mass = 1 kg; com = [0.2, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.4, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.5, 0.1] m; inertia = 0.2 kg*m^2 about com;
            output = [1.1, 0] m; point hook = [0.5, 0.3] m turned 20 deg;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.7, 0] m;
        }
        body Weight {
            mass = 1 kg + load; com = [0, -0.2] m; inertia = 0.02 kg*m^2 about com;
            output = [0, -0.4] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
            -> pin d -> ground at [0.9, 0] m;
        coupler.hook -> pin shaker -> Weight near -> pin swing -> Weight far;
        hinge a { start = 60 deg; torque = input; }
        hinge b { start = -50 deg; stiffness = 5; damping = 0.3; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; stiffness = 3; damping = 0.2; }
        hinge shaker { motion = input; }
    }

    /// A rod that may be so thin that it has no inertia about its axis.
    pub chain Thin {
        gravity = [0, -9.8, 0] m/s^2;
        param thickness = 0.01 kg*m^2;
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(thickness, 1/12 kg*m^2, 1/12 kg*m^2) about com;
        }
        ground -> ball arm -> Rod upper -> ball loose -> Rod lower;
        hinge arm { armature = 0.1 kg*m^2; torque = input; }
    }
}

/// Three numbers, as a vector.
fn three<T: Scalar>(draw: Draw<T>) -> Vector3<T> {
    [(); 3].map(|()| draw(-5.0, 5.0)).into()
}

sample!(Arm ArmByTransfer: |chain, inputs, draw| { chain.set_payload(draw(0.0, 3.0)) } {
    let torques = [(); 7].map(|()| draw(-5.0, 5.0));
    [inputs.j1, inputs.j2, inputs.j3, inputs.j4, inputs.j5, inputs.j6, inputs.j7] = torques;
});
sample!(Balls: |chain, inputs, draw| { chain.set_stiffness(draw(0.0, 50.0)) } {
    inputs.a = three(draw);
});
sample!(Slides: |chain, inputs, draw| {
    chain.set_payload(draw(0.0, 3.0)).and_then(|()| chain.set_slope(draw(-0.1, 0.1)))
} {
    inputs.gravity = three(draw);
    inputs.a = draw(-5.0, 5.0);
});
sample!(Afloat: |chain, inputs, draw| { chain.set_length(draw(0.0, 1.0)) } {
    (inputs.wind_force, inputs.wind_torque) = (three(draw), three(draw));
});
sample!(Loop Parallelogram: |chain, inputs, draw| { chain.set_load(draw(0.0, 1.0)) } {
    inputs.a = draw(-5.0, 5.0);
});
sample!(Repeated: |chain, inputs, draw| { chain.set_knot(|_| draw(0.0, 1.0)) } {
    inputs.a = [(); 6].map(|()| draw(-5.0, 5.0));
});
sample!(Train: |chain, inputs, draw| { chain.set_freight(draw(0.0, 2e4)) } {
    inputs.engine_force = draw(-1e5, 1e5);
});
sample!(Told: |chain, inputs, draw| { chain.set_payload(draw(0.0, 3.0)) } {
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
});
sample!(Branched: |chain, inputs, draw| { chain.set_knot(|_| draw(0.0, 1.0)) } {
    (inputs.left_knee, inputs.right_knee) = (draw(-5.0, 5.0), draw(-5.0, 5.0));
    inputs.b = [(); 2].map(|()| draw(-5.0, 5.0));
    inputs.push_force = [(); 2].map(|()| three(draw));
});
sample!(ToldLoop: |chain, inputs, draw| { chain.set_load(draw(0.0, 1.0)) } {
    inputs.a = draw(-5.0, 5.0);
    let state = PinState::new(draw(-3.0, 3.0), draw(-3.0, 3.0));
    inputs.shaker = HingeMotion { state, acceleration: draw(-5.0, 5.0) };
});
sample!(Thin: |chain, inputs, draw| { chain.set_thickness(draw(0.01, 0.1)) } {
    inputs.arm = three(draw);
});
