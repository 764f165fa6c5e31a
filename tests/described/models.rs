//! The chains: every kind of hinge, dimension and end, parts, repeated parts, loads and parameters.

use mstmm::mstmm_chain;

/// A Rust constant of a description.
pub const MASS: f64 = 0.75;

mstmm_chain! {
    /// Hinges of all kinds in space.
    ///
    /// They begin at a moving frame.
    pub chain Kinds {
        gravity = input;
        answers = [momentum, mass_matrix];
        param payload = 0.5 kg;
        param slope = 0.1 m;
        param lift = 20 deg;
        body Block {
            mass = 1 kg + payload;
            com = [0.1 m, slope, 0.2 m];
            output = [0.5, 0, 0.1] m turned rpy(20, -10, 40) deg;
            inertia = tensor(0.4, 0.5, 0.6, 0.01, 0.02, -0.03) kg*m^2 about com;
            point side = [0.1, 0.4, 0] m turned rpy(0, 30, 0) deg;
        }
        body Cube {
            mass = MASS;
            com = [0.25, 0, 0] m;
            inertia = diag(1/8, 5/16, 5/16) kg*m^2 about input;
        }
        moving deck -> slider(x) a -> Block b1 -> cylindrical(y) b -> Block b2
            -> universal(x, z) c -> Block b3 -> screw([1, 1, 0], 5 mm/rev) d -> Block b4
            -> planar(z) e -> Block b5 -> pin(y) shaker -> Block b6 -> weld plate -> Cube tip;
        b2.side -> elastic f -> Block b7 -> ball g -> Block b8 -> floating h -> Block b9;
        hinge a { force = input; start = 0.3 m; limits = [-0.1, 0.4]; limit_stiffness = 1e3; }
        hinge b {
            force = input; torque = input; start = 1 m turned 30 deg; start_rate = 2;
            turning_limits = [-90, 45] deg; turning_limit_stiffness = 10;
        }
        hinge c {
            torque = input; start = [10 deg, lift]; limits = [-0.2, 0.2]; limit_stiffness = 100;
        }
        hinge e { force = input; start = [0.1, 0.2] m turned 0.3; start_velocity = [1, 2]; }
        hinge shaker { motion = input; }
        hinge f { stiffness = 300; turning_stiffness = 30; start = [1, 2, 3] m turned rpy(4, 5, 6) deg; }
        hinge g {
            torque = input; start = quaternion(0.8, 0, 0.6, 0); start_rate = [0, 0.1, 0];
            limits = 40 deg; limit_stiffness = 5;
        }
        hinge h { force = input; torque = input; start_velocity = [1, 2, 3]; }
        load push { on = tip; at = com; force = input; torque = input; }
        spring rope { on = tip; at = com; to = [0, 0, 5] m; stiffness = 3; }
    }

    /// A floating trunk with two instances of a part and a repeated part.
    pub chain Crawler {
        gravity = [0, -9.8, 0] m/s^2;
        answers = momentum;
        param knot[3] = 0.1 kg;
        param hull = 2 kg;
        param bend[3] = 0.02;
        body Trunk {
            mass = 1 kg + hull;
            com = [0.1, 0, 0.05] m;
            output = [0.5, 0, 0] m;
            inertia = tensor(0.3, 0.4, 0.5, 0.01, 0.02, -0.03) kg*m^2 about com;
            point left = [0.2, 0.3, 0] m turned rpy(10, 0, 20) deg;
            point right = [0.2, -0.3, 0] m;
        }
        body Link {
            mass = 1 kg + knot;
            com = [0.3 m, (0.1 m) * bend, 0 m];
            output = [0.6, 0, 0.2] m;
            inertia = diag(0.1, 0.12, 0.09) kg*m^2 about com;
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
                inertia = diag(0.02, 0.02, 0.005) kg*m^2 about com;
            }
            pin(x) hip -> Thigh thigh -> pin(y) knee -> Rung shank;
            hinge knee { torque = input; limits = [-0.2, 0.3]; limit_stiffness = 200; }
            load kick { on = shank; at = end; force = input; }
        }
        Trunk trunk -> repeat 3 { ball a -> Link link; link.side -> pin(z) b -> Rung rung; }
            -> slider(x) c -> Rung last;
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        body trunk { start = [0, 0, 1] m; start_rate = [0, 0, 0.5]; }
        hinge b { torque = input; start = 0.1; }
        spring cord { on = left.shank.end; to = right.shank.end; stiffness = 40; length = 0.4 m; }
        spring tie { on = rung.end; to = [0, 0, 0] m; stiffness = 4; }
        load push { on = rung; at = end; force = input; }
        load steer { on = trunk; torque = input; }
    }

    /// A floating chain in a plane.
    pub plane chain Raft {
        gravity = input;
        answers = momentum;
        param load = 0.5 kg;
        body Plank {
            mass = 2 kg + load;
            com = [0.5, 0.1] m;
            inertia = 0.9 kg*m^2 about input;
            output = [1.1, 0] m;
        }
        Plank first -> elastic a -> Plank second -> pin b -> Plank third -> slider(x) c
            -> Plank fourth -> planar d -> Plank last;
        hinge a { stiffness = 400; turning_stiffness = 30; start = [0.1, 0.2] m turned 0.3; }
        hinge b { torque = input; }
        hinge d { force = input; torque = input; }
        load wind { on = third; at = output; force = input; torque = input; }
    }

    /// Along a line, with a prescribed hinge.
    pub line chain Train {
        gravity = input;
        body Car { mass = 20 kg; output = 15 m; }
        Car first -> elastic a -> Car second -> slider b -> Car last;
        hinge a { stiffness = 1e3 N/m; start = 0.5 m; }
        hinge b { motion = input; }
        load engine { on = first; force = input; }
    }

    /// Repeated from the ground: the first repetition leaves a point outside of the part.
    pub plane chain Rope {
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; output = [1, 0] m; }
        ground -> repeat 100 { pin joint -> Rod rod } -> pin hook -> Rod weight;
        hinge joint { torque = input; }
    }

    /// A closed chain.
    pub plane chain FourBar {
        body Bar { mass = 1 kg; com = [0.5, 0] m; inertia = 0.1 kg*m^2 about com; output = [1, 0] m; }
        ground -> pin a -> Bar crank -> pin b -> Bar coupler -> pin c -> Bar rocker -> pin d
            -> ground at [1, 0.2] m;
        hinge a { start = 1.2; torque = input; }
        hinge b { start = -1.2; }
        hinge c { start = -1.7; }
    }
}
