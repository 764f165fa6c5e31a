//! Repeated parts with branches are the same as their contents written out.
//!
//! The order of hinges is that of the text, and a repeated part is in order repetition by repetition.
//! The written-out text therefore begins a route for each repetition and for each branch.

use super::twins::twins;

twins! {
    [space
        gravity = [1, -9.8, 2] m/s^2;
        body Base {
            mass = 2 kg;
            com = [0.1, -0.1, 0.2] m;
            output = [0, 0.4, 0] m;
            inertia = diag(0.3, 0.4, 0.5) kg*m^2 about com;
            point left = [0.1, 0.3, 0.2] m turned rpy(10, 0, 30) deg;
            point right = [0.1, 0.3, -0.2] m;
        }
        body Link {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point left = [0.2, 0.5, -0.1] m turned rpy(0, 40, 10) deg;
            point right = [0.2, -0.5, -0.1] m;
        }
        body Rung {
            mass = 0.5 kg;
            com = [0.1, 0.2, 0] m;
            output = [0.2, 0.3, 0] m;
            inertia = diag(0.02, 0.01, 0.025) kg*m^2 about com;
            point end = [0.2, 0.4, 0.1] m;
        }
    ]

    two_rungs_on_every_link: Ladder {
        ground -> weld lashing -> Base beam -> repeat 3 {
            ball knot -> Link link;
            link.left -> pin(z) a -> Rung left;
            link.right -> universal(x, y) b -> Rung right;
        } -> pin hook -> Base weight;
        hinge knot { start_rate = [1, 0, 2]; stiffness = 20; damping = 0.5; }
        hinge a { start = 0.3; torque = input; }
        hinge b { start = [10, 20] deg; limits = [-0.4, 0.4]; limit_stiffness = 100; }
        load push { on = right; at = end; force = input; }
        spring cord { on = left.end; to = right.end; stiffness = 50; damping = 1; length = 0.4 m; }
        spring stay { on = left.com; to = [0, 2, 0] m; stiffness = 30; length = 0.5 m; }
    } = LadderOut {
        ground -> weld lashing -> Base beam -> ball knot1 -> Link link1;
        link1.left -> pin(z) a1 -> Rung left1;
        link1.right -> universal(x, y) b1 -> Rung right1;
        link1.output -> ball knot2 -> Link link2;
        link2.left -> pin(z) a2 -> Rung left2;
        link2.right -> universal(x, y) b2 -> Rung right2;
        link2.output -> ball knot3 -> Link link3;
        link3.left -> pin(z) a3 -> Rung left3;
        link3.right -> universal(x, y) b3 -> Rung right3;
        link3.output -> pin hook -> Base weight;
        hinge knot1, knot2, knot3 { start_rate = [1, 0, 2]; stiffness = 20; damping = 0.5; }
        hinge a1, a2, a3 { start = 0.3; torque = input; }
        hinge b1, b2, b3 { start = [10, 20] deg; limits = [-0.4, 0.4]; limit_stiffness = 100; }
        load push1 { on = right1; at = end; force = input; }
        load push2 { on = right2; at = end; force = input; }
        load push3 { on = right3; at = end; force = input; }
        spring cord1 { on = left1.end; to = right1.end; stiffness = 50; damping = 1; length = 0.4 m; }
        spring cord2 { on = left2.end; to = right2.end; stiffness = 50; damping = 1; length = 0.4 m; }
        spring cord3 { on = left3.end; to = right3.end; stiffness = 50; damping = 1; length = 0.4 m; }
        spring stay1 { on = left1.com; to = [0, 2, 0] m; stiffness = 30; length = 0.5 m; }
        spring stay2 { on = left2.com; to = [0, 2, 0] m; stiffness = 30; length = 0.5 m; }
        spring stay3 { on = left3.com; to = [0, 2, 0] m; stiffness = 30; length = 0.5 m; }
    } given |x| {
        a = [x[0], x[1], x[2]];
        push_force = [3, 6, 9].map(|k| [x[k], x[k + 1], x[k + 2]].into());
    } = {
        a1 = x[0];
        a2 = x[1];
        a3 = x[2];
        push1_force = [x[3], x[4], x[5]].into();
        push2_force = [x[6], x[7], x[8]].into();
        push3_force = [x[9], x[10], x[11]].into();
    };

    // Two rails: the second one continues from the previous repetition. Repeated bodies have the same
    // points in every repetition, so that more points than here have forces: `shares.rs` compares them.
    two_rails: Rails {
        results = energies;
        Base beam -> repeat 3 from right.output = beam.right, right.end = beam.output {
            pin(x) a -> Link left;
            last.right.output -> pin(y) b -> Rung right;
            last.right.end -> slider(z) c -> Rung bead;
            left.right -> ball d -> Rung rung;
        };
        hinge a, b, c { stiffness = 30; damping = 0.1; }
        spring cord { on = rung.end; to = last.right.end; stiffness = 40; length = 0.3 m; }
    } = RailsOut {
        results = energies;
        Base beam -> pin(x) a1 -> Link left1;
        beam.right -> pin(y) b1 -> Rung right1;
        beam.output -> slider(z) c1 -> Rung bead1;
        left1.right -> ball d1 -> Rung rung1;
        left1.output -> pin(x) a2 -> Link left2;
        right1.output -> pin(y) b2 -> Rung right2;
        right1.end -> slider(z) c2 -> Rung bead2;
        left2.right -> ball d2 -> Rung rung2;
        left2.output -> pin(x) a3 -> Link left3;
        right2.output -> pin(y) b3 -> Rung right3;
        right2.end -> slider(z) c3 -> Rung bead3;
        left3.right -> ball d3 -> Rung rung3;
        hinge a1, b1, c1, a2, b2, c2, a3, b3, c3 { stiffness = 30; damping = 0.1; }
        spring cord1 { on = rung1.end; to = beam.output; stiffness = 40; length = 0.3 m; }
        spring cord2 { on = rung2.end; to = right1.end; stiffness = 40; length = 0.3 m; }
        spring cord3 { on = rung3.end; to = right2.end; stiffness = 40; length = 0.3 m; }
    };

    // What leaves a repeated body from outside leaves that of the last repetition: any of its places.
    branches_of_the_last_repetition: Outside {
        results = energies;
        ground -> repeat 3 { ball a -> Link link; link.left -> pin b -> Rung rung; }
            -> slider(y) c -> Base weight;
        link.right -> pin(x) d -> Rung other;
        rung.end -> universal e -> Rung far;
        rung.output -> elastic f -> Base last;
        link.output -> pin(y) g -> Rung beside;
        link.input -> pin(z) h -> Rung above;
        hinge f { stiffness = 200; damping = 2; turning_stiffness = 20; }
    } = OutsideOut {
        results = energies;
        ground -> ball a1 -> Link link1;
        link1.left -> pin b1 -> Rung rung1;
        link1.output -> ball a2 -> Link link2;
        link2.left -> pin b2 -> Rung rung2;
        link2.output -> ball a3 -> Link link3;
        link3.left -> pin b3 -> Rung rung3;
        link3.output -> slider(y) c -> Base weight;
        link3.right -> pin(x) d -> Rung other;
        rung3.end -> universal e -> Rung far;
        rung3.output -> elastic f -> Base last;
        link3.output -> pin(y) g -> Rung beside;
        link3.input -> pin(z) h -> Rung above;
        hinge f { stiffness = 200; damping = 2; turning_stiffness = 20; }
    };

    // Repeated parts that begin routes and follow each other, one of them with branches.
    repeated_parts_on_two_branches: Arms {
        Base hub -> pin a -> Link link;
        hub.left -> repeat 2 { ball b -> Link outer; outer.right -> pin c -> Rung rung; }
            -> repeat 2 { slider d -> Rung bead };
        hub.right -> repeat 3 { pin(y) e -> Rung plain };
        link.left -> universal f -> Rung first -> repeat 2 { pin(x) g -> Rung next };
        hinge e { torque = input; }
        hinge c { motion = input; }
    } = ArmsOut {
        Base hub -> pin a -> Link link;
        hub.left -> ball b1 -> Link outer1;
        outer1.right -> pin c1 -> Rung rung1;
        outer1.output -> ball b2 -> Link outer2;
        outer2.right -> pin c2 -> Rung rung2;
        outer2.output -> slider d1 -> Rung bead1 -> slider d2 -> Rung bead2;
        hub.right -> pin(y) e1 -> Rung p1 -> pin(y) e2 -> Rung p2 -> pin(y) e3 -> Rung p3;
        link.left -> universal f -> Rung first -> pin(x) g1 -> Rung next1 -> pin(x) g2 -> Rung next2;
        hinge e1, e2, e3 { torque = input; }
        hinge c1, c2 { motion = input; }
    } given |x| {
        e = [x[0], x[1], x[2]];
        c = [3, 6].map(|k| mstmm::HingeMotion {
            state: mstmm::PinState::new(x[k], x[k + 1]),
            acceleration: x[k + 2],
        });
    } = {
        e1 = x[0];
        e2 = x[1];
        e3 = x[2];
        c1 = mstmm::HingeMotion {
            state: mstmm::PinState::new(x[3], x[4]),
            acceleration: x[5],
        };
        c2 = mstmm::HingeMotion {
            state: mstmm::PinState::new(x[6], x[7]),
            acceleration: x[8],
        };
    };

    // A part with two legs of a part, set in every repetition.
    a_centipede: Centipede {
        part Leg(side) {
            body Thigh {
                mass = 0.4 kg;
                com = [0.05, side*0.1, 0] m;
                output = [0, side*0.2, 0.1] m;
                inertia = tensor(0.02, 0.01, 0.025, side*0.002, 0, side*0.001) kg*m^2 about com;
            }
            universal(x, z) hip -> Thigh thigh -> pin([side, 0, 0]) knee -> Rung shank;
            hinge knee { start = 0.4; torque = input; damping = 0.2; }
            load foot { on = shank; at = end; force = input; }
        }
        part Segment(side) {
            ball joint -> Link link;
            link.left -> Leg(side) left;
            link.right -> Leg(-side) right;
            hinge joint { stiffness = 30; }
        }
        Base head -> repeat 2 { Segment(1) segment } -> pin(y) tail -> Rung sting;
    } = CentipedeOut {
        body Left {
            mass = 0.4 kg;
            com = [0.05, 0.1, 0] m;
            output = [0, 0.2, 0.1] m;
            inertia = tensor(0.02, 0.01, 0.025, 0.002, 0, 0.001) kg*m^2 about com;
        }
        body Right {
            mass = 0.4 kg;
            com = [0.05, -0.1, 0] m;
            output = [0, -0.2, 0.1] m;
            inertia = tensor(0.02, 0.01, 0.025, -0.002, 0, -0.001) kg*m^2 about com;
        }
        Base head -> ball j1 -> Link link1;
        link1.left -> universal(x, z) h1 -> Left thigh1 -> pin(x) k1 -> Rung shank1;
        link1.right -> universal(x, z) h2 -> Right thigh2 -> pin([-1, 0, 0]) k2 -> Rung shank2;
        link1.output -> ball j2 -> Link link2;
        link2.left -> universal(x, z) h3 -> Left thigh3 -> pin(x) k3 -> Rung shank3;
        link2.right -> universal(x, z) h4 -> Right thigh4 -> pin([-1, 0, 0]) k4 -> Rung shank4;
        link2.output -> pin(y) tail -> Rung sting;
        hinge j1, j2 { stiffness = 30; }
        hinge k1, k2, k3, k4 { start = 0.4; torque = input; damping = 0.2; }
        load foot1 { on = shank1; at = end; force = input; }
        load foot2 { on = shank2; at = end; force = input; }
        load foot3 { on = shank3; at = end; force = input; }
        load foot4 { on = shank4; at = end; force = input; }
    } given |x| {
        segment_left_knee = [x[0], x[1]];
        segment_right_knee = [x[2], x[3]];
        segment_left_foot_force = [4, 7].map(|k| [x[k], x[k + 1], x[k + 2]].into());
        segment_right_foot_force = [10, 13].map(|k| [x[k], x[k + 1], x[k + 2]].into());
    } = {
        k1 = x[0];
        k3 = x[1];
        k2 = x[2];
        k4 = x[3];
        foot1_force = [x[4], x[5], x[6]].into();
        foot3_force = [x[7], x[8], x[9]].into();
        foot2_force = [x[10], x[11], x[12]].into();
        foot4_force = [x[13], x[14], x[15]].into();
    };
}
