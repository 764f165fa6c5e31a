//! Printed from the seeds in `../random.rs`; not to be edited.

use super::face::printed;
use crate::support::motion::*;

printed! {
    Random0R Random0T, Point, energy(state);
    inputs |drives| {
        j1: drives.efforts[0],
        s1_force: drives.springs[0],
    }
    hinges j1 j2;
    springs s1 s2;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.38 kg;
        com = [0.48, 0.0, 0.0] m;
        output = [-0.03, 0.64, -0.71] m turned rpy(154.6, -61.5, 131.5) deg;
        inertia = tensor(0.06925, 0.050282, 0.060487, 0.013501, 0.008858, -0.0076) kg*m^2 about com;
    }
    body B2 {
        mass = 4.64 kg;
        com = [0.0, 0.0, 0.33] m;
        output = [0.0, 0.0, -0.12] m;
        inertia = diag(1.075202, 1.199649, 0.588383) kg*m^2 about input;
    }
    ground -> cylindrical([0.0, -1.0, 0.0]) j1 -> B1 b1 -> pin(x) j2 -> B2 b2;
    hinge j1 { stiffness = 8.77 N/m; limits = [-0.16, 1.13] m; limit_stiffness = 13.8 N/m; force = input; torque = 2.7 N*m; }
    hinge j2 { damping = 0.16 N*m*s/rad; armature = 0.75 kg*m^2; limits = [-0.64, 0.7] rad; limit_stiffness = 41.2 N*m/rad; limit_damping = 1.51 N*m*s/rad; torque = 3.0 N*m; }
    spring s1 { on = b1; at = com; to = [-0.9, -0.6, -0.1] m; stiffness = 31.2 N/m; length = 0.8 m; force = input; }
    spring s2 { on = b2; at = [0.0, 0.0, 0.18] m; to = [1.1, 1.9, 1.2] m; stiffness = 20.2 N/m; length = 0.4 m; }
}
}

printed! {
    Random1R Random1T, PlanePoint, energy(state);
    inputs |_drives| {}
    hinges;
    springs;
pub plane chain {
    gravity = [0.0, -9.8] m/s^2;
    body B1 {
        mass = 2.92 kg;
        com = [-0.07, -0.07] m;
        output = [-0.51, 0.71] m turned 52.3 deg;
        inertia = 0.319194 kg*m^2 about com;
        point p1 = [-0.91, 1.0] m;
    }
    B1 b1;
    load l1 { on = b1; at = p1; torque = 4.0 N*m; }
}
}

printed! {
    Random2R Random2T, Point, energy_with(state, inputs);
    inputs |drives| {
        j3: universal(&drives.motions[0]),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.04 kg;
        com = [0.32, -0.23, -0.18] m;
        output = [-0.6, 0.55, -0.39] m turned rpy(155.5, -106.8, -108.0) deg;
        inertia = tensor(0.324288, 0.449264, 0.518557, 0.229922, 0.163918, -0.11339) kg*m^2 about input;
    }
    body B2 {
        mass = 1.27 kg;
        com = [0.0, 0.1, 0.0] m;
        output = [0.84, -0.78, 0.12] m turned rpy(34.1, 35.9, -96.7) deg;
        inertia = tensor(0.042877, 0.030865, 0.047725, 0.004753, 0.003151, 0.005389) kg*m^2 about input;
    }
    body B3 {
        mass = 3.84 kg;
        com = [0.0, 0.0, 0.19] m;
        output = [1.03, 0.62, 1.04] m;
        inertia = diag(0.251208, 0.284712, 0.093884) kg*m^2 about input;
    }
    body B4 {
        mass = 0.78 kg;
        com = [0.46, -0.14, -0.28] m;
        output = [0.0, 0.58, 0.0] m turned rpy(-98.5, -148.7, 9.0) deg;
        inertia = tensor(0.160987, 0.278338, 0.23454, 0.054949, 0.093979, -0.033924) kg*m^2 about input;
    }
    B1 b1 -> pin(y) j1 -> B2 b2 -> elastic j2 -> B3 b3 -> universal(x, [0.0, 0.0, -1.0]) j3 -> B4 b4 -> cylindrical([-0.67, -1.38, 0.91]) j4 -> ground;
    hinge j1 { rest = 0.23 rad; stiffness = 6.44 N*m/rad; armature = 0.54 kg*m^2; friction = 1.2 N*m; friction_speed = 0.7 rad/s; }
    hinge j2 { stiffness = 5.14 N/m; damping = [1.05, 2.31, 2.68] N*s/m; force = [0.3, 4.1, 1.9] N; turning_stiffness = 19.75 N*m/rad; turning_armature = [0.12, 0.33, 0.72] kg*m^2; turning_friction = [0.3, 0.6, 0.82] N*m; turning_friction_speed = 0.8 rad/s; turning_limits = [-0.5, 0.63] rad; turning_limit_stiffness = 43.8 N*m/rad; torque = [-0.7, -1.2, 0.5] N*m; }
    hinge j3 { stiffness = 29.51 N*m/rad; damping = 2.85 N*m*s/rad; motion = input; }
    hinge j4 { turning_stiffness = 28.7 N*m/rad; turning_limits = [-1.18, 0.18] rad; turning_limit_stiffness = 8.2 N*m/rad; turning_limit_damping = 0.56 N*m*s/rad; }
    load l1 { on = b2; at = [-0.04, 0.58, 0.47] m; force = [-2.9, 2.2, -1.8] N; torque = [-1.0, 2.2, -7.3] N*m; }
    spring s1 { on = b1; at = [0.0, 0.0, 0.32] m; to = [-1.2, -1.5, 1.1] m; stiffness = 14.4 N/m; }
}
}

printed! {
    Random3R Random3T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: slider(&drives.motions[0]),
        j3: drives.efforts[3],
        j4: vector(&drives.efforts, [4, 5]),
        l1_force: drives.loads[0].force.into(),
        l1_torque: drives.loads[0].torque.into(),
        l2_force: drives.loads[1].force.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4;
    springs;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.55 kg;
        com = [-0.27, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.29] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.320313, 0.355042, 0.370583, -0.029021, 0.022713, 0.023207) kg*m^2 about com;
    }
    body B2 {
        mass = 4.31 kg;
        com = [0.47, -0.58, 0.05] m;
        output = [0.47, 0.08, 0.1] m turned rpy(180.0, 0.0, 0.0) deg;
        inertia = tensor(0.331348, 0.261525, 0.198297, -0.025655, -0.075286, -0.090217) kg*m^2 about com;
    }
    body B3 {
        mass = 0.57 kg;
        com = [0.0, -0.3, 0.0] m;
        output = [0.0, -0.34, 0.0] m;
        inertia = tensor(0.050855, 0.02615, 0.038925, -0.004219, -0.000888, 0.017687) kg*m^2 about com;
    }
    ground at [-0.88, -0.56, -0.85] m turned rpy(133.1, 15.0, 153.2) deg -> slider([0.2, 0.99, 1.34]) j1 -> B1 b1 -> planar(x) j2 -> B2 b2 -> pin([0.0, 0.0, -1.0]) j3 -> B3 b3 -> planar(x) j4 -> ground at [-1.08, 0.3, -1.18] m turned rpy(-155.0, -50.1, 93.1) deg;
    hinge j1 { armature = 0.65 kg; limits = [-0.24, 0.49] m; limit_stiffness = 58.9 N/m; motion = input; }
    hinge j3 { rest = 0.91 rad; stiffness = 22.87 N*m/rad; damping = 2.01 N*m*s/rad; armature = 0.42 kg*m^2; torque = input; }
    hinge j4 { force = input; torque = -4.0 N*m; }
    load l1 { on = b1; force = input; torque = input; }
    load l2 { on = b2; at = output; force = input; }
    load l3 { on = b3; at = output; torque = [-2.9, 2.4, -6.8] N*m; axes = body; }
}
}

printed! {
    Random4R Random4T, LinePoint, energy_with(state, inputs);
    inputs |drives| {
        base: line_frame(&drives.start),
    }
    hinges j1 j2;
    springs s1 s2;
pub line chain {
    gravity = 0.0 m/s^2;
    body B1 {
        mass = 4.32 kg;
        com = 0.0 m;
        output = 0.71 m;
    }
    body B2 {
        mass = 4.55 kg;
        com = -0.3 m;
        output = 0.0 m;
        point p1 = 0.0 m;
    }
    moving base -> floating j1 -> B1 b1 -> weld j2 -> B2 b2;
    load l1 { on = b1; at = 0.0 m; force = -4.9 N; }
    spring s1 { on = b1; at = input; to = -1.9 m; stiffness = 18.9 N/m; length = 0.86 m; }
    spring s2 { on = b2; at = p1; to = 0.4 m; stiffness = 22.4 N/m; damping = 1.47 N*s/m; length = 1.44 m; }
}
}

printed! {
    Random5R Random5T, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j1: drives.efforts[0],
    }
    hinges j1;
    springs;
pub chain {
    gravity = [-1.42, 3.23, 4.96] m/s^2;
    body B1 {
        mass = 2.06 kg;
        com = [0.0, 0.15, 0.0] m;
        output = [-0.18, 0.25, -0.12] m;
        inertia = tensor(0.240263, 0.242453, 0.228241, -0.039251, -0.034734, 0.036592) kg*m^2 about com;
    }
    B1 b1 -> slider([0.0, -1.0, 0.0]) j1 -> moving tip;
    hinge j1 { force = input; }
}
}

printed! {
    Random6R Random6T, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        tip: plane_frame(&drives.finish),
        j2: plane_elastic(&drives.motions[0]),
        j5: vector(&drives.efforts, [2, 3, 4]),
        l1_force: part(&drives.loads[0].force, 0).into(),
        s1_force: drives.springs[0],
    }
    hinges j1 j2 j3 j4 j5;
    springs s1;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    body B1 {
        mass = 4.15 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 1.08] m turned 59.3 deg;
        inertia = 0.087048 kg*m^2 about com;
        point p1 = [0.84, 0.0] m;
    }
    body B2 {
        mass = 1.05 kg;
        com = [0.0, 0.0] m;
        output = [0.92, -0.85] m;
        inertia = 0.060884 kg*m^2 about com;
    }
    body B3 {
        mass = 3.84 kg;
        com = [0.08, -0.32] m;
        output = [0.0, 0.0] m;
        inertia = 0.16201 kg*m^2 about com;
    }
    body B4 {
        mass = 3.53 kg;
        com = [-0.6, 0.33] m;
        output = [0.83, -0.71] m turned 180.0 deg;
        inertia = 0.468995 kg*m^2 about com;
    }
    ground -> slider(x) j1 -> B1 b1 -> elastic j2 -> B2 b2 -> weld j3 -> B3 b3 -> pin j4 -> B4 b4 -> planar j5 -> moving tip;
    hinge j1 { rest = -0.14 m; stiffness = 3.47 N/m; damping = 1.7 N*s/m; friction = 0.74 N; friction_speed = 0.5 m/s; }
    hinge j2 { motion = input; }
    hinge j4 { armature = 0.58 kg*m^2; }
    hinge j5 { force = input; turning_stiffness = 2.22 N*m/rad; turning_limits = [-0.87, 0.86] rad; turning_limit_stiffness = 38.8 N*m/rad; turning_limit_damping = 0.48 N*m*s/rad; torque = input; }
    load l1 { on = b1; at = p1; force = input; torque = -1.2 N*m; axes = body; }
    spring s1 { on = b2; at = input; to = [1.8, -0.5] m; stiffness = 30.0 N/m; length = 1.46 m; force = input; }
}
}

printed! {
    Random7R Random7T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        j1: planar(&drives.motions[0]),
        j3: drives.efforts[6],
        l1_force: drives.loads[0].force.into(),
        l1_torque: drives.loads[0].torque.into(),
        l2_force: drives.loads[1].force.into(),
        l3_force: drives.loads[2].force.into(),
        s2_force: drives.springs[1],
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4;
    springs s1 s2;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.0 kg;
        com = [0.0, 0.0, 0.33] m;
        output = [0.0, -1.16, 0.0] m turned rpy(-62.5, 42.9, 92.6) deg;
        inertia = tensor(0.07606, 0.087806, 0.055266, -0.017039, 0.005681, 0.003535) kg*m^2 about com;
        point p1 = [0.37, 0.0, 0.0] m;
    }
    body B2 {
        mass = 4.17 kg;
        com = [0.2, -0.17, -0.52] m;
        output = [-0.67, 0.0, -0.39] m turned rpy(-46.6, 134.7, -35.4) deg;
        inertia = tensor(0.32605, 0.303742, 0.403073, 0.018258, -0.06587, -0.041593) kg*m^2 about com;
        point p2 = [0.0, 0.0, 0.0] m;
    }
    body B3 {
        mass = 1.42 kg;
        com = [0.0, 0.0, -0.32] m;
        output = [0.0, -1.08, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.289204, 0.276163, 0.133193, 0.008687, -0.00133, 0.010244) kg*m^2 about input;
    }
    moving base -> planar(x) j1 -> B1 b1 -> elastic j2 -> B2 b2 -> screw(z, 0.47 m/rad) j3 -> B3 b3 -> pin([0.92, -1.48, -0.47]) j4 -> ground;
    hinge j1 { turning_stiffness = 25.92 N*m/rad; turning_damping = 1.85 N*m*s/rad; turning_limits = [-0.57, 1.02] rad; turning_limit_stiffness = 42.6 N*m/rad; motion = input; }
    hinge j2 { rest = [-0.04, -0.18, 0.13] m turned rpy(0.02, -0.18, -1.49) rad; force = [1.4, 4.2, -1.2] N; turning_stiffness = [25.52, 34.81, 30.38] N*m/rad; turning_damping = [2.65, 1.88, 1.37] N*m*s/rad; turning_armature = [0.72, 0.63, 0.07] kg*m^2; torque = [-4.6, -1.8, 0.3] N*m; }
    hinge j3 { rest = -0.04 rad; stiffness = 17.66 N*m/rad; damping = 1.34 N*m*s/rad; torque = input; }
    load l1 { on = b1; at = p1; force = input; torque = input; axes = body; }
    load l2 { on = b2; force = input; }
    load l3 { on = b3; at = [0.0, 0.0, 0.5] m; force = input; }
    spring s1 { on = b1; at = com; to = [1.0, -0.8, -0.4] m; stiffness = 10.2 N/m; }
    spring s2 { on = b2; at = p2; to = [-0.8, 0.1, 1.2] m; stiffness = 36.6 N/m; force = input; }
}
}

printed! {
    Random8R Random8T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        tip: space_frame(&drives.finish),
        l1_torque: drives.loads[0].torque.into(),
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 4.42 kg;
        com = [-0.33, 0.05, -0.2] m;
        output = [0.03, 1.04, -0.17] m turned rpy(0.0, -90.0, 180.0) deg;
        inertia = tensor(0.616353, 0.89289, 0.847609, 0.097777, -0.309886, -0.081683) kg*m^2 about input;
    }
    body B2 {
        mass = 4.85 kg;
        com = [-0.48, -0.22, -0.29] m;
        output = [0.0, 0.0, 0.74] m;
        inertia = tensor(0.954435, 2.029163, 1.707584, -0.51216, -0.67512, -0.30943) kg*m^2 about input;
    }
    moving base -> elastic j1 -> B1 b1 -> floating j2 -> B2 b2 -> planar(z) j3 -> moving tip;
    hinge j2 { rest = [0.01, 0.15, -0.08] m turned quaternion(-0.49, 0.04, 0.05, -0.07); stiffness = [29.71, 9.74, 15.5] N/m; damping = 1.07 N*s/m; armature = 0.29 kg; friction = 0.45 N; friction_speed = 0.9 m/s; limits = [-1.15, 0.61] m; limit_stiffness = 35.9 N/m; }
    load l1 { on = b2; at = [-0.4, -0.26, 0.84] m; torque = input; axes = body; }
    spring s1 { on = b2; at = [0.0, 0.0, 0.57] m; to = [1.8, -0.6, -0.2] m; stiffness = 2.9 N/m; length = 0.48 m; force = -7.7 N; }
}
}

printed! {
    Random9R Random9T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: floating(&drives.motions[0]),
        s1_force: drives.springs[0],
    }
    hinges j1;
    springs s1;
pub chain {
    gravity = [4.24, -4.72, 5.03] m/s^2;
    body B1 {
        mass = 1.47 kg;
        com = [0.0, 0.16, 0.0] m;
        output = [0.22, -0.68, 1.17] m;
        inertia = tensor(0.141835, 0.059633, 0.105399, 0.003533, -0.007862, -0.015581) kg*m^2 about com;
    }
    ground -> floating j1 -> B1 b1;
    hinge j1 { motion = input; }
    spring s1 { on = b1; at = com; to = [-0.3, -1.8, 0.7] m; stiffness = 33.3 N/m; damping = 0.43 N*s/m; length = 0.2 m; force = input; }
}
}

printed! {
    Random10R Random10T, Point, energy(state);
    inputs |drives| {
        j2: drives.efforts[7],
        l1_force: drives.loads[0].force.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 0.36 kg;
        com = [0.0, -0.52, 0.0] m;
        output = [1.14, -0.5, -0.62] m;
        inertia = diag(0.101873, 0.028786, 0.122736) kg*m^2 about input;
    }
    body B2 {
        mass = 4.83 kg;
        com = [-0.11, -0.04, -0.44] m;
        output = [0.0, 0.0, 0.0] m turned rpy(103.6, -53.7, -38.7) deg;
        inertia = tensor(0.347417, 0.174545, 0.205252, 0.012882, -0.018217, -0.017864) kg*m^2 about com;
    }
    body B3 {
        mass = 3.27 kg;
        com = [0.0, 0.0, -0.19] m;
        output = [0.0, 0.0, 0.41] m turned rpy(133.8, 37.2, -174.4) deg;
        inertia = diag(0.311045, 0.25829, 0.253965) kg*m^2 about input;
    }
    body B4 {
        mass = 1.82 kg;
        com = [-0.24, 0.0, 0.0] m;
        output = [-0.99, -0.16, -0.04] m turned rpy(-135.7, -61.3, 142.5) deg;
        inertia = tensor(0.090467, 0.028015, 0.078727, 0.006765, -0.000857, -0.015329) kg*m^2 about com;
    }
    B1 b1 -> pin(z) j1 -> B2 b2 -> slider([-0.1, 1.03, 0.0]) j2 -> B3 b3 -> elastic j3 -> B4 b4;
    hinge j1 { rest = 1.2 rad; stiffness = 14.47 N*m/rad; damping = 2.95 N*m*s/rad; friction = 1.88 N*m; friction_speed = 0.9 rad/s; limits = [-0.33, 0.7] rad; limit_stiffness = 9.5 N*m/rad; }
    hinge j2 { force = input; }
    load l1 { on = b1; at = input; force = input; }
    spring s1 { on = b3; at = com; to = [0.2, -0.1, 0.1] m; stiffness = 10.3 N/m; damping = 2.63 N*s/m; }
}
}

printed! {
    Random11R Random11T, PlanePoint, energy(state);
    inputs |drives| {
        j2: drives.efforts[0],
        l1_force: part(&drives.loads[0].force, 0).into(),
    }
    hinges j1 j2 j3;
    springs s1;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.72 kg;
        com = [0.01, -0.4] m;
        output = [0.0, 0.0] m turned 148.2 deg;
        inertia = 0.120766 kg*m^2 about com;
    }
    body B2 {
        mass = 4.63 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m turned 61.1 deg;
        inertia = 0.233131 kg*m^2 about input;
    }
    body B3 {
        mass = 2.81 kg;
        com = [-0.24, -0.07] m;
        output = [1.11, 0.67] m turned -90.0 deg;
        inertia = 0.225244 kg*m^2 about com;
    }
    B1 b1 -> weld j1 -> B2 b2 -> slider([-0.89, 0.46]) j2 -> B3 b3 -> floating j3 -> ground;
    hinge j2 { damping = 2.02 N*s/m; armature = 0.14 kg; limits = [-0.23, 0.96] m; limit_stiffness = 46.5 N/m; force = input; }
    load l1 { on = b3; at = [0.0, 0.0] m; force = input; }
    spring s1 { on = b1; at = [0.0, 0.0] m; to = [0.7, 0.4] m; stiffness = 23.1 N/m; damping = 1.28 N*s/m; length = 1.09 m; force = 4.0 N; }
}
}

printed! {
    Random12R Random12T, Point, energy(state);
    inputs |drives| {
        l1_force: drives.loads[0].force.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 4.7 kg;
        com = [0.3, 0.38, 0.39] m;
        output = [0.3, -0.49, 0.86] m;
        inertia = tensor(1.910785, 1.727608, 1.64419, -0.492705, -0.493792, -0.696051) kg*m^2 about input;
        point p1 = [0.7, -0.29, 0.77] m;
    }
    body B2 {
        mass = 1.0 kg;
        com = [-0.46, 0.0, 0.0] m;
        output = [0.75, -1.08, 0.13] m;
        inertia = diag(0.08422, 0.149382, 0.076535) kg*m^2 about com;
    }
    ground at [0.0, 0.0, 0.27] m -> ball j1 -> B1 b1 -> floating j2 -> B2 b2 -> cylindrical(y) j3 -> ground at [-2.09, 0.26, -1.19] m turned rpy(28.2, 44.5, -33.0) deg;
    hinge j1 { torque = [4.3, 4.6, 2.3] N*m; }
    hinge j2 { turning_stiffness = 21.71 N*m/rad; turning_damping = 0.88 N*m*s/rad; }
    load l1 { on = b2; at = output; force = input; axes = body; }
    spring s1 { on = b1; at = p1; to = [1.2, -1.3, 0.4] m; stiffness = 25.0 N/m; force = 4.9 N; }
}
}

printed! {
    Random13R Random13T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
    }
    hinges j1;
    springs;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.88 kg;
        com = [0.0, 0.0, -0.21] m;
        output = [0.0, -1.16, 0.0] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = diag(0.174272, 0.219177, 0.082276) kg*m^2 about com;
    }
    moving base -> cylindrical(y) j1 -> B1 b1;
    hinge j1 { rest = 0.43 m turned -1.25 rad; stiffness = 14.7 N/m; damping = 0.59 N*s/m; friction = 1.35 N; friction_speed = 0.9 m/s; }
}
}

printed! {
    Random14R Random14T, LinePoint, energy_with(state, inputs);
    inputs |drives| {
        tip: line_frame(&drives.finish),
        l1_force: drives.loads[0].force[0],
    }
    hinges j1 j2 j3 j4;
    springs s1 s2;
pub line chain {
    gravity = -5.48 m/s^2;
    body B1 {
        mass = 2.2 kg;
        com = 0.0 m;
        output = 0.0 m;
    }
    body B2 {
        mass = 4.66 kg;
        com = 0.0 m;
        output = -0.13 m;
    }
    body B3 {
        mass = 2.14 kg;
        com = 0.0 m;
        output = 0.0 m;
    }
    body B4 {
        mass = 4.47 kg;
        com = 0.0 m;
        output = -0.4 m;
        point p1 = 0.99 m;
    }
    B1 b1 -> elastic j1 -> B2 b2 -> elastic j2 -> B3 b3 -> weld j3 -> B4 b4 -> floating j4 -> moving tip;
    hinge j1 { stiffness = 16.87 N/m; armature = 0.28 kg; friction = 1.81 N; friction_speed = 0.7 m/s; limits = [-0.13, 0.98] m; limit_stiffness = 22.0 N/m; }
    hinge j2 { force = -4.9 N; }
    hinge j4 { rest = 0.43 m; stiffness = 28.45 N/m; armature = 0.52 kg; friction = 1.25 N; friction_speed = 0.3 m/s; limits = [-0.34, 1.03] m; limit_stiffness = 13.3 N/m; }
    load l1 { on = b1; at = input; force = input; }
    load l2 { on = b3; at = input; force = 1.1 N; }
    spring s1 { on = b3; at = com; to = -0.2 m; stiffness = 6.7 N/m; damping = 1.19 N*s/m; length = 0.9 m; }
    spring s2 { on = b4; at = p1; to = -1.1 m; stiffness = 23.5 N/m; length = 1.35 m; force = -6.7 N; }
}
}

printed! {
    Random15R Random15T, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j3: drives.efforts[2],
        j4: vector(&drives.efforts, [3, 4]),
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 1.04 kg;
        com = [0.16, 0.0, 0.0] m;
        output = [0.47, -0.66, -0.19] m turned rpy(-90.0, 0.0, 0.0) deg;
        inertia = diag(0.020298, 0.016648, 0.03446) kg*m^2 about com;
        point p1 = [0.96, 0.0, 0.0] m;
    }
    body B2 {
        mass = 4.21 kg;
        com = [0.0, 0.17, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(60.9, -103.0, 119.9) deg;
        inertia = tensor(0.292099, 0.249111, 0.189007, -0.023108, 0.034611, -0.07482) kg*m^2 about com;
    }
    body B3 {
        mass = 2.67 kg;
        com = [-0.53, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(90.0, 180.0, 180.0) deg;
        inertia = tensor(0.195129, 0.265152, 0.177625, 0.034469, 0.005803, 0.022862) kg*m^2 about com;
    }
    ground at [0.0, 0.0, 1.76] m turned rpy(90.0, 0.0, 0.0) deg -> pin([0.4, -1.38, 1.17]) j1 -> B1 b1 -> slider([0.0, -1.0, 0.0]) j2 -> B2 b2 -> screw([0.85, 0.65, -1.29], -0.59 m/rad) j3 -> B3 b3 -> planar(z) j4 -> moving tip;
    hinge j1 { stiffness = 20.48 N*m/rad; damping = 2.32 N*m*s/rad; armature = 0.66 kg*m^2; }
    hinge j2 { rest = -0.04 m; stiffness = 39.12 N/m; limits = [-0.2, 0.83] m; limit_stiffness = 27.7 N/m; }
    hinge j3 { damping = 0.45 N*m*s/rad; armature = 0.11 kg*m^2; torque = input; }
    hinge j4 { armature = 0.29 kg; limits = [-0.75, 0.33] m; limit_stiffness = 20.9 N/m; limit_damping = 1.36 N*s/m; force = input; torque = -3.6 N*m; }
    load l1 { on = b1; at = p1; force = [4.4, -6.7, -2.0] N; }
    spring s1 { on = b1; at = input; to = [1.9, 1.6, 1.2] m; stiffness = 28.6 N/m; damping = 2.88 N*s/m; length = 0.76 m; }
}
}

printed! {
    Random16R Random16T, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base: plane_frame(&drives.start),
        j3: slider(&drives.motions[0]),
        j1: vector(&drives.efforts, [0, 1, 2]),
        j2: vector(&drives.efforts, [3, 4]),
        gravity: part(&drives.gravity, 0).into(),
    }
    hinges j1 j2 j3;
    springs;
pub plane chain {
    gravity = input;
    body B1 {
        mass = 3.29 kg;
        com = [0.0, 0.1] m;
        output = [-1.13, 0.82] m;
        inertia = 0.273599 kg*m^2 about com;
    }
    body B2 {
        mass = 2.59 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m turned -90.0 deg;
        inertia = 0.13835 kg*m^2 about input;
        point p1 = [0.43, -0.8] m;
    }
    moving base -> elastic j1 -> B1 b1 -> floating j2 -> B2 b2 -> slider([-0.54, -1.03]) j3 -> ground;
    hinge j1 { force = input; torque = input; }
    hinge j2 { rest = [0.45, 0.25] m turned 0.83 rad; force = input; turning_stiffness = 1.48 N*m/rad; turning_damping = 1.66 N*m*s/rad; turning_limits = [-0.46, 0.15] rad; turning_limit_stiffness = 31.4 N*m/rad; turning_limit_damping = 0.7 N*m*s/rad; torque = -0.4 N*m; }
    hinge j3 { motion = input; }
    load l1 { on = b2; at = p1; force = [5.4, 1.8] N; axes = body; }
}
}

printed! {
    Random17R Random17T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        tip: space_frame(&drives.finish),
        j1: vector(&drives.efforts, [0, 1, 2]),
        j2: vector(&drives.efforts, [6, 7, 8, 9, 10, 11]),
        l1_torque: drives.loads[0].torque.into(),
    }
    hinges j1 j2;
    springs;
pub chain {
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 3.34 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.19, 0.0, 0.0] m turned rpy(180.0, 0.0, 0.0) deg;
        inertia = diag(0.164277, 0.018353, 0.158508) kg*m^2 about input;
    }
    moving base -> elastic j1 -> B1 b1 -> elastic j2 -> moving tip;
    hinge j1 { force = input; torque = [-4.8, -4.2, -4.7] N*m; }
    hinge j2 { rest = [0.22, 0.05, -0.15] m turned rpy(-0.19, -0.2, -1.45) rad; armature = [0.65, 0.14, 0.73] kg; friction = [0.18, 1.09, 0.42] N; friction_speed = 0.6 m/s; force = input; turning_stiffness = [9.16, 14.86, 9.92] N*m/rad; turning_limits = [-1.01, 0.6] rad; turning_limit_stiffness = 57.9 N*m/rad; torque = input; }
    load l1 { on = b1; at = output; torque = input; }
}
}

printed! {
    Random18R Random18T, Point, energy_with(state, inputs);
    inputs |drives| {
        j3: ball(&drives.motions[0]),
        j2: drives.efforts[2],
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4;
    springs;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.63 kg;
        com = [-0.45, 0.5, 0.58] m;
        output = [0.0, 0.0, 0.0] m turned rpy(130.6, 118.2, -170.6) deg;
        inertia = tensor(0.046334, 0.037889, 0.043131, 0.011128, -0.003501, -0.006145) kg*m^2 about com;
    }
    body B2 {
        mass = 4.15 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.83, 0.0, 0.0] m turned rpy(-90.0, 90.0, -90.0) deg;
        inertia = diag(0.133447, 0.140788, 0.019084) kg*m^2 about com;
    }
    body B3 {
        mass = 4.35 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.46, 0.0, 0.0] m;
        inertia = tensor(0.346324, 0.269938, 0.353471, 0.067802, -0.034108, 0.078909) kg*m^2 about com;
    }
    body B4 {
        mass = 0.23 kg;
        com = [-0.3, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(180.0, 90.0, 0.0) deg;
        inertia = tensor(0.004143, 0.002774, 0.004038, -0.000883, 0.000728, 0.000204) kg*m^2 about com;
    }
    ground at [1.07, 0.0, 0.0] m -> weld j1 -> B1 b1 -> planar(z) j2 -> B2 b2 -> ball j3 -> B3 b3 -> universal(z, [0.43, 0.69, -1.08]) j4 -> B4 b4;
    hinge j2 { force = [0.9, -0.5] N; torque = input; }
    hinge j3 { rest = quaternion(-0.46, -0.12, 0.03, 0.16); stiffness = 4.96 N*m/rad; damping = 1.1 N*m*s/rad; motion = input; }
    hinge j4 { rest = [-1.16, -1.21] rad; stiffness = [24.12, 38.14] N*m/rad; damping = 0.43 N*m*s/rad; friction = [0.31, 0.45] N*m; friction_speed = 0.6 rad/s; }
    load l1 { on = b3; at = [0.81, -0.66, 0.13] m; torque = [6.7, 4.4, -7.6] N*m; }
}
}

printed! {
    Random19R Random19T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: cylindrical(&drives.motions[0]),
        j2: planar(&drives.motions[1]),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.73 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, -0.96, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = tensor(0.418261, 0.455826, 0.442714, -0.010882, -0.004231, -0.001762) kg*m^2 about com;
    }
    body B2 {
        mass = 1.98 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.96, -0.18, 0.57] m turned rpy(90.0, -90.0, 0.0) deg;
        inertia = diag(0.124576, 0.261144, 0.166563) kg*m^2 about input;
    }
    body B3 {
        mass = 1.2 kg;
        com = [0.03, 0.4, 0.28] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.333603, 0.175121, 0.251221, -0.027798, -0.016783, -0.135778) kg*m^2 about input;
    }
    B1 b1 -> cylindrical([0.0, 0.0, -1.0]) j1 -> B2 b2 -> planar(x) j2 -> B3 b3;
    hinge j1 { rest = 0.32 m turned -0.75 rad; stiffness = 19.47 N/m; damping = 2.56 N*s/m; limits = [-1.03, 0.69] m; limit_stiffness = 22.7 N/m; limit_damping = 1.59 N*s/m; motion = input; }
    hinge j2 { rest = [0.28, 0.03] m turned 1.25 rad; stiffness = [17.27, 18.0] N/m; turning_stiffness = 4.39 N*m/rad; turning_damping = 1.23 N*m*s/rad; turning_armature = 0.19 kg*m^2; turning_limits = [-0.95, 0.21] rad; turning_limit_stiffness = 13.9 N*m/rad; motion = input; }
    spring s1 { on = b2; at = [0.24, 0.0, 0.0] m; to = [0.0, -0.5, -1.4] m; stiffness = 24.0 N/m; damping = 0.21 N*s/m; length = 0.21 m; }
}
}

printed! {
    Random20R Random20T, Point, energy_with(state, inputs);
    inputs |drives| {
        j2: ball(&drives.motions[0]),
        l1_torque: drives.loads[0].torque.into(),
    }
    hinges j1 j2;
    springs s1;
pub chain {
    gravity = [4.27, 5.16, -4.62] m/s^2;
    body B1 {
        mass = 1.22 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.21, 0.0] m;
        inertia = diag(0.069193, 0.082097, 0.022013) kg*m^2 about input;
    }
    body B2 {
        mass = 1.45 kg;
        com = [0.25, -0.59, 0.3] m;
        output = [0.0, 0.35, 0.0] m turned rpy(168.6, -94.1, -18.7) deg;
        inertia = tensor(0.826362, 0.321984, 0.718501, 0.213875, -0.10875, 0.25665) kg*m^2 about input;
        point p1 = [0.68, -0.61, 0.34] m;
    }
    B1 b1 -> pin([0.14, -1.16, 0.17]) j1 -> B2 b2 -> ball j2 -> ground;
    hinge j1 { damping = 1.67 N*m*s/rad; limits = [-0.12, 1.07] rad; limit_stiffness = 24.1 N*m/rad; limit_damping = 1.68 N*m*s/rad; }
    hinge j2 { rest = quaternion(0.21, 0.21, -0.38, 0.14); stiffness = 22.41 N*m/rad; damping = 1.12 N*m*s/rad; limits = 1.3 rad; limit_stiffness = 26.8 N*m/rad; limit_damping = 0.95 N*m*s/rad; motion = input; }
    load l1 { on = b2; at = p1; torque = input; axes = body; }
    spring s1 { on = b1; at = [0.61, -0.01, 0.17] m; to = [1.5, -0.9, -1.4] m; stiffness = 7.1 N/m; length = 0.83 m; }
}
}

printed! {
    Random21R Random21T, Point, energy_with(state, inputs);
    inputs |drives| {
        j2: slider(&drives.motions[0]),
        j5: drives.efforts[3],
        l1_torque: drives.loads[0].torque.into(),
        l2_torque: drives.loads[1].torque.into(),
    }
    hinges j1 j2 j3 j4 j5;
    springs;
pub chain {
    gravity = [-1.28, 4.58, 0.0] m/s^2;
    body B1 {
        mass = 3.85 kg;
        com = [0.09, -0.23, 0.0] m;
        output = [0.72, 0.21, 0.0] m;
        inertia = diag(0.352633, 0.226066, 0.372242) kg*m^2 about com;
    }
    body B2 {
        mass = 1.22 kg;
        com = [0.51, -0.05, 0.0] m;
        output = [0.0, 0.19, 0.0] m turned rpy(0.0, 0.0, -55.1) deg;
        inertia = tensor(0.03422, 0.037768, 0.030529, -0.008274, -0.00497, 0.006291) kg*m^2 about com;
    }
    body B3 {
        mass = 1.71 kg;
        com = [0.59, 0.0, 0.0] m;
        output = [0.59, -0.3, 0.0] m;
        inertia = diag(0.108461, 0.134171, 0.239342) kg*m^2 about com;
    }
    body B4 {
        mass = 0.63 kg;
        com = [0.0, 0.52, 0.0] m;
        output = [1.16, 0.0, 0.0] m turned rpy(0.0, 0.0, 67.3) deg;
        inertia = tensor(0.024352, 0.024475, 0.029853, -0.002659, -0.006413, 0.004542) kg*m^2 about com;
    }
    ground at [1.17, -0.5, 0.0] m turned rpy(0.0, 0.0, 90.0) deg -> slider([1.01, -0.74, 0.0]) j1 -> B1 b1 -> slider([0.0, -1.0, 0.0]) j2 -> B2 b2 -> slider([-1.0, 0.0, 0.0]) j3 -> B3 b3 -> pin(z) j4 -> B4 b4 -> slider([0.0, 0.39, 0.0]) j5 -> ground at [0.12, 1.19, 0.0] m turned rpy(0.0, 0.0, -119.6) deg;
    hinge j2 { rest = -0.2 m; stiffness = 30.44 N/m; motion = input; }
    hinge j3 { friction = 1.05 N; friction_speed = 0.1 m/s; limits = [-0.75, 0.92] m; limit_stiffness = 17.9 N/m; force = 3.8 N; }
    hinge j4 { rest = -0.48 rad; stiffness = 5.29 N*m/rad; damping = 2.39 N*m*s/rad; armature = 0.14 kg*m^2; friction = 1.48 N*m; friction_speed = 0.5 rad/s; }
    hinge j5 { rest = -0.27 m; stiffness = 39.79 N/m; damping = 2.18 N*s/m; friction = 1.39 N; friction_speed = 0.7 m/s; force = input; }
    load l1 { on = b1; at = output; torque = input; axes = body; }
    load l2 { on = b2; torque = input; }
}
}
