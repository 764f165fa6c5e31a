//! The open chains: in space, in a plane and on a line.

use mstmm::mstmm_chain;

mstmm_chain! {
    pub chain Space {
        gravity = input;
        answers = [basic, bias_efforts, momentum, regressor, derivatives, linearize, push, pull, coriolis_matrix];
        param more = 0.7 kg;
        param length = 0.6 m;
        param each[2] = 0.2 kg;
        param turn = 0.3;
        body Block {
            mass = 1 kg + more;
            com = [0.2, 0.1, -0.1] m;
            output = [length, 0.1 m, 0.05 m] turned rpy(0.3, -0.2, turn);
            inertia = tensor(0.3, 0.4, 0.5, 0.02, -0.03, 0.01) kg*m^2 about com;
            point tip = [0.1 m, 0.3 m, length];
            point lug = [-0.2, 0.1, 0.3] m turned rpy(0.4, 0.1, 0.2);
        }
        body Link {
            mass = 0.5 kg + each;
            com = [0.2, 0.05, 0.01] m;
            output = [0.4, 0.1, 0] m turned rpy(0.2, 0.1, -0.3);
            inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com;
            point side = [0, 0.3, 0.1] m turned rpy(-0.3, 0.2, 0.1);
        }
        body Small {
            mass = 0.3 kg;
            com = [0.1, 0.02, 0.03] m;
            output = [0.2, 0, 0.1] m;
            inertia = diag(0.05, 0.06, 0.07) kg*m^2 about com;
        }
        moving deck -> universal(x, [0, 1, 1]) gimbal -> Block first
            -> slider([1, 1, 0]) drive -> Block second
            -> repeat 2 from link.side = first.tip {
                pin([0, 1, 0.2]) knee -> Link link;
                link.side -> pin(x) branch -> Small rod -> slider(y) pump -> Small piston
            }
            -> ball wrist -> Small hand;
        second.lug -> elastic mount -> Small engine -> screw(y, 0.1 m/rad) thread -> Small nut;
        hinge drive { motion = input; armature = 0.3; }
        hinge gimbal { start = [0.3, -0.4]; torque = input; damping = 0.2; armature = 0.1; }
        hinge knee { torque = input; damping = 0.1; friction = 0.2; friction_speed = 0.3; }
        hinge pump { motion = input; }
        hinge branch { limits = [-0.2, 0.3] rad; limit_stiffness = 5; limit_damping = 0.2; armature = 0.05; }
        hinge mount { stiffness = 20; damping = 0.3; turning_stiffness = 5; turning_damping = 0.2; }
        hinge wrist { stiffness = 3; damping = 0.3; torque = input; rest = rpy(0.1, 0.2, 0.3); }
        load push { on = link.side; force = input; axes = body; }
        spring cord { on = link.side; to = last.link.side; stiffness = 2; damping = 0.1; length = 0.1 m; }
        spring stay { on = hand; to = first.tip; stiffness = 3; damping = 0.2; length = 0.1; }
    }

    pub plane chain Plane {
        gravity = [0.3, -9.81] m/s^2;
        answers = [basic, bias_efforts, momentum, regressor, derivatives, linearize, push, pull, coriolis_matrix];
        param each[3] = 0.7 kg;
        param stiffness = 2;
        body Block {
            mass = 1 kg;
            com = [0.2, 0.1] m;
            output = [0.5, 0.1] m turned 0.3;
            inertia = 0.3 kg*m^2 about com;
            point tip = [0.1, 0.3] m turned -0.4;
        }
        body Link {
            mass = 0.5 kg + each;
            com = [0.2, 0.05] m;
            output = [0.4, 0.1] m turned -0.2;
            inertia = 0.3 kg*m^2 about input;
            point side = [0, 0.3] m turned 0.5;
        }
        moving deck -> pin crank -> Block first
            -> repeat 3 {
                pin knee -> Link link -> slider([1, 1]) pump -> Block block;
                link.side -> slider(y) branch -> Block side;
                block.tip -> pin tail -> Block flap
            }
            -> elastic mount -> Block engine -> weld seam -> Block frame;
        first.tip -> planar float -> Block plate;
        hinge crank, pump { motion = input; }
        hinge knee { stiffness = stiffness; damping = 0.1; torque = input; }
        hinge branch { armature = 0.4; friction = 0.3; friction_speed = 0.2; }
        hinge mount { stiffness = 10; turning_stiffness = 4; damping = 0.2; turning_damping = 0.1; }
        load push { on = flap; force = input; torque = input; axes = body; }
        spring stay { on = frame.tip; to = [1, 2] m; stiffness = 3; }
    }

    pub line chain Line {
        gravity = input;
        answers = [basic, bias_efforts, momentum, regressor, derivatives, linearize, push, pull, coriolis_matrix];
        param stiffness = 2 N/m;
        param each[3] = 0.4 kg;
        body Car { mass = 1 kg; }
        body Hub { mass = 0.5 kg; com = 0.1 m; output = 0.3 m; }
        body Link { mass = 0.5 kg + each; com = 0.1 m; output = 0.3 m; point middle = 0.2 m; }
        ground -> slider first -> Hub hub
            -> repeat 3 { slider rail -> Link link; link.middle -> slider side -> Car car }
            -> slider last -> Car end;
        hinge first { motion = input; }
        hinge rail { stiffness = stiffness; damping = 0.2; force = input; }
        hinge side { armature = 0.3; friction = 0.1; friction_speed = 0.1; }
        load push { on = car; force = input; }
        spring stay { on = end; to = hub.output; stiffness = stiffness; length = 0.1; }
    }
}
