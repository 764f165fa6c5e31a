//! Printed from the seeds in `../random_trees.rs`; not to be edited.

use super::face::printed;
use crate::support::motion::*;

printed! {
    Tree0, Point, energy_with(state, inputs);
    inputs |drives| {
        base1: space_frame(&drives.route_starts[0]),
        j2: vector(&drives.efforts, [1, 2, 3, 4, 5, 6]),
        s1_force: drives.springs[0],
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.86 kg;
        com = [-0.01, 0.32, -0.35] m;
        output = [0.38, 1.03, -0.41] m turned rpy(-88.8, 49.1, 155.1) deg;
        inertia = tensor(0.024579, 0.008471, 0.025053, 0.000795, -0.000809, 0.00145) kg*m^2 about com;
    }
    body B2 {
        mass = 0.85 kg;
        com = [-0.45, -0.58, 0.34] m;
        output = [0.0, -0.99, 0.0] m turned rpy(180.0, -90.0, 180.0) deg;
        inertia = tensor(0.428088, 0.30134, 0.50538, -0.219927, 0.120677, 0.165013) kg*m^2 about input;
    }
    body B3 {
        mass = 2.93 kg;
        com = [0.0, 0.14, 0.0] m;
        output = [0.0, 0.66, 0.0] m turned rpy(162.7, -103.6, -135.7) deg;
        inertia = tensor(0.059828, 0.069012, 0.089242, -0.002351, 0.012763, -0.014858) kg*m^2 about com;
    }
    ground -> pin([0.0, -0.44, -0.66]) j1 -> B1 b1;
    moving base1 -> floating j2 -> B2 b2;
    b1.output -> pin(x) j3 -> B3 b3;
    hinge j1 { rest = 0.78 rad; stiffness = 36.61 N*m/rad; damping = 0.98 N*m*s/rad; }
    hinge j2 { force = input; turning_damping = 2.51 N*m*s/rad; torque = input; }
    hinge j3 { stiffness = 8.76 N*m/rad; damping = 0.39 N*m*s/rad; armature = 0.24 kg*m^2; limits = [-0.83, 0.96] rad; limit_stiffness = 5.5 N*m/rad; }
    load l1 { on = b1; at = [0.0, -0.9, 0.0] m; torque = [-5.8, 0.5, -2.5] N*m; axes = body; }
    load l2 { on = b2; at = output; torque = [4.6, -5.8, -5.7] N*m; axes = body; }
    spring s1 { on = b2; at = output; to = [0.4, 0.9, -1.6] m; stiffness = 31.8 N/m; length = 0.93 m; force = input; }
}
}

printed! {
    Tree1, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        j2: slider(&drives.motions[0]),
        j1: vector(&drives.efforts, [3, 4, 5]),
        l1_torque: drives.loads[0].torque[2],
        l3_torque: drives.loads[2].torque[2],
        l4_torque: drives.loads[3].torque[2],
        c3_force: drives.springs[2],
    }
    hinges j1 j2 j3 j4 j5;
    springs c1 c2 c3;
pub plane chain {
    gravity = [-5.74, 0.82] m/s^2;
    body B1 {
        mass = 4.86 kg;
        com = [-0.48, 0.0] m;
        output = [-0.23, 0.25] m turned -90.0 deg;
        inertia = 1.142189 kg*m^2 about input;
    }
    body B2 {
        mass = 0.41 kg;
        com = [0.1, -0.12] m;
        output = [0.1, 0.6] m turned 132.8 deg;
        inertia = 0.037394 kg*m^2 about input;
    }
    body B3 {
        mass = 0.72 kg;
        com = [0.0, 0.0] m;
        output = [-0.9, -0.78] m;
        inertia = 0.047966 kg*m^2 about com;
        point p1 = [0.0, 0.0] m;
    }
    body B4 {
        mass = 0.34 kg;
        com = [-0.14, -0.42] m;
        output = [0.0, 0.0] m turned -8.2 deg;
        inertia = 0.06978 kg*m^2 about input;
    }
    body B5 {
        mass = 3.33 kg;
        com = [0.06, 0.49] m;
        output = [0.8, -0.6] m turned 90.0 deg;
        inertia = 0.921002 kg*m^2 about input;
    }
    body B6 {
        mass = 4.43 kg;
        com = [0.0, 0.0] m;
        output = [0.59, 0.0] m turned -155.6 deg;
        inertia = 0.499462 kg*m^2 about input;
        point p2 = [0.7, -0.93] m;
    }
    B1 b1 -> planar j1 -> B2 b2;
    b1.input -> slider([0.0, -1.0]) j2 -> B3 b3 -> planar j3 -> B4 b4;
    b2.output -> slider(x) j4 -> B5 b5;
    ground -> weld j5 -> B6 b6;
    hinge j1 { rest = [-0.21, 0.04] m turned -1.36 rad; stiffness = [30.32, 17.73] N/m; damping = [2.89, 0.7] N*s/m; limits = [-0.8, 0.2] m; limit_stiffness = 45.6 N/m; limit_damping = 1.67 N*s/m; force = input; turning_stiffness = 13.87 N*m/rad; turning_damping = 0.66 N*m*s/rad; turning_armature = 0.42 kg*m^2; turning_friction = 0.69 N*m; turning_friction_speed = 0.8 rad/s; turning_limits = [-0.36, 0.83] rad; turning_limit_stiffness = 44.4 N*m/rad; torque = input; }
    hinge j2 { motion = input; }
    hinge j3 { limits = [-0.4, 0.56] m; limit_stiffness = 43.0 N/m; limit_damping = 1.67 N*s/m; turning_stiffness = 17.42 N*m/rad; }
    hinge j4 { force = -1.1 N; }
    load l1 { on = b1; at = input; torque = input; axes = body; }
    load l2 { on = b3; at = p1; torque = 0.3 N*m; }
    load l3 { on = b5; torque = input; axes = body; }
    load l4 { on = b6; at = p2; force = [1.8, -3.6] N; torque = input; }
    spring c1 { on = b1; at = [0.0, 0.0] m; to = b5.com; stiffness = 17.0 N/m; damping = 2.05 N*s/m; length = 0.77 m; force = 5.1 N; }
    spring c2 { on = b3; at = [-0.83, 0.47] m; to = b2.output; stiffness = 2.2 N/m; length = 1.09 m; }
    spring c3 { on = b5; at = [0.0, 0.0] m; to = b2.output; stiffness = 16.5 N/m; damping = 1.1 N*s/m; force = input; }
}
}

printed! {
    Tree2, Point, energy_with(state, inputs);
    inputs |drives| {
        j3: floating(&drives.motions[0]),
        l1_force: drives.loads[0].force.into(),
    }
    hinges j1 j2 j3 j4;
    springs;
pub chain {
    gravity = [-5.11, -2.34, -0.25] m/s^2;
    body B1 {
        mass = 3.06 kg;
        com = [0.0, 0.0, -0.27] m;
        output = [-0.39, -0.15, 0.13] m;
        inertia = diag(0.066679, 0.0671, 0.040439) kg*m^2 about com;
    }
    body B2 {
        mass = 3.17 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.25, -0.56, -0.38] m turned rpy(90.0, 180.0, 90.0) deg;
        inertia = tensor(0.121618, 0.045406, 0.139162, 0.037025, 0.011349, -0.033713) kg*m^2 about input;
    }
    body B3 {
        mass = 1.31 kg;
        com = [0.3, 0.0, 0.0] m;
        output = [-0.42, -1.19, 0.28] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.088881, 0.200109, 0.212061, 0.015868, -0.03591, 0.019472) kg*m^2 about input;
    }
    body B4 {
        mass = 3.54 kg;
        com = [0.52, 0.0, 0.0] m;
        output = [-1.2, 0.64, 0.52] m;
        inertia = tensor(0.374678, 0.375179, 0.408666, 0.017507, 0.013688, -0.067027) kg*m^2 about com;
    }
    B1 b1 -> universal([-1.0, 0.0, 0.0], z) j1 -> B2 b2 -> ball j2 -> B3 b3 -> floating j3 -> ground;
    b1.output -> cylindrical([0.42, -0.57, 1.46]) j4 -> B4 b4;
    hinge j1 { stiffness = [33.03, 12.57] N*m/rad; }
    hinge j2 { stiffness = 18.87 N*m/rad; damping = 2.66 N*m*s/rad; }
    hinge j3 { damping = 0.48 N*s/m; armature = 0.72 kg; friction = 1.47 N; friction_speed = 0.2 m/s; limits = [-1.13, 0.93] m; limit_stiffness = 47.0 N/m; limit_damping = 0.36 N*s/m; turning_armature = 0.36 kg*m^2; turning_friction = 0.53 N*m; turning_friction_speed = 0.9 rad/s; motion = input; }
    load l1 { on = b2; at = [-0.52, -0.58, 0.78] m; force = input; torque = [7.5, 5.1, -5.6] N*m; }
}
}

printed! {
    Tree3, Point, energy_with(state, inputs);
    inputs |drives| {
        base1: space_frame(&drives.route_starts[0]),
        j2: pin(&drives.motions[0]),
        j3: vector(&drives.efforts, [2, 3]),
        j5: vector(&drives.efforts, [10, 11, 12, 13, 14, 15]),
        s3_force: drives.springs[2],
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5 j6 j7 j8;
    springs s1 s2 s3;
pub chain {
    gravity = input;
    body B1 {
        mass = 3.55 kg;
        com = [-0.27, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.29] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.320313, 0.355042, 0.370583, -0.029021, 0.022713, 0.023207) kg*m^2 about com;
    }
    body B2 {
        mass = 4.49 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.85, 0.0, 0.0] m turned rpy(-127.1, 60.7, 35.1) deg;
        inertia = tensor(0.245331, 0.359042, 0.175413, 0.01524, 0.11245, -0.019726) kg*m^2 about input;
    }
    body B3 {
        mass = 1.24 kg;
        com = [0.36, -0.21, -0.21] m;
        output = [0.93, -1.18, 0.99] m;
        inertia = tensor(0.120707, 0.167962, 0.140931, -0.011871, 0.00779, -0.034371) kg*m^2 about com;
    }
    body B4 {
        mass = 4.84 kg;
        com = [0.24, 0.0, 0.0] m;
        output = [0.1, 1.02, 0.85] m turned rpy(0.0, 180.0, 0.0) deg;
        inertia = diag(0.337181, 0.14198, 0.345305) kg*m^2 about com;
    }
    body B5 {
        mass = 1.04 kg;
        com = [0.14, 0.5, 0.57] m;
        output = [1.03, 0.0, 0.0] m;
        inertia = diag(0.018053, 0.016322, 0.004397) kg*m^2 about com;
    }
    body B6 {
        mass = 2.34 kg;
        com = [0.0, 0.0, 0.3] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-90.0, 180.0, 180.0) deg;
        inertia = diag(0.456742, 0.33427, 0.133386) kg*m^2 about input;
    }
    body B7 {
        mass = 1.05 kg;
        com = [0.08, 0.06, -0.15] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = tensor(0.079573, 0.047035, 0.05579, -0.00504, 0.0126, 0.00945) kg*m^2 about input;
    }
    ground -> universal(y, z) j1 -> B1 b1 -> pin([0.0, 0.0, -1.0]) j2 -> B2 b2 -> universal([-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]) j3 -> B3 b3 -> elastic j4 -> B4 b4 -> floating j5 -> ground at [-3.35, -1.52, 0.84] m turned rpy(-95.1, 11.6, -23.2) deg;
    moving base1 -> ball j6 -> B5 b5 -> weld j7 -> B6 b6;
    b5.input -> slider(x) j8 -> B7 b7;
    hinge j2 { rest = 0.84 rad; stiffness = 13.29 N*m/rad; damping = 2.77 N*m*s/rad; motion = input; }
    hinge j3 { torque = input; }
    hinge j4 { force = [-2.4, -2.3, 3.5] N; turning_damping = 0.5 N*m*s/rad; turning_armature = 0.29 kg*m^2; torque = [-4.0, 1.4, 4.7] N*m; }
    hinge j5 { force = input; turning_stiffness = 18.75 N*m/rad; turning_limits = 0.58 rad; turning_limit_stiffness = 22.5 N*m/rad; torque = input; }
    hinge j6 { armature = 0.14 kg*m^2; friction = 1.6 N*m; friction_speed = 0.3 rad/s; }
    load l1 { on = b3; at = [0.0, 0.0, 0.22] m; force = [0.4, 1.9, 0.4] N; }
    load l2 { on = b4; at = output; force = [-2.7, 1.7, -3.2] N; axes = body; }
    spring s1 { on = b1; at = com; to = [1.7, 1.9, -0.4] m; stiffness = 34.4 N/m; damping = 1.1 N*s/m; }
    spring s2 { on = b2; at = input; to = [-0.4, 1.4, 1.2] m; stiffness = 38.7 N/m; length = 0.31 m; force = -7.8 N; }
    spring s3 { on = b7; at = com; to = [-0.4, 0.2, -1.1] m; stiffness = 30.7 N/m; damping = 1.49 N*s/m; force = input; }
}
}

printed! {
    Tree4, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base: plane_frame(&drives.start),
        j2: plane_elastic(&drives.motions[0]),
        j3: planar(&drives.motions[1]),
        j4: planar(&drives.motions[2]),
        j1: vector(&drives.efforts, [0, 1, 2]),
        j5: drives.efforts[3],
        l1_force: part(&drives.loads[0].force, 0).into(),
        l1_torque: drives.loads[0].torque[2],
    }
    hinges j1 j2 j3 j4 j5;
    springs;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    body B1 {
        mass = 4.33 kg;
        com = [0.0, 0.0] m;
        output = [0.85, 0.0] m turned 180.0 deg;
        inertia = 0.152638 kg*m^2 about com;
    }
    body B2 {
        mass = 3.69 kg;
        com = [0.56, 0.0] m;
        output = [-0.96, -0.75] m turned 13.5 deg;
        inertia = 1.424929 kg*m^2 about input;
    }
    body B3 {
        mass = 2.34 kg;
        com = [0.35, -0.35] m;
        output = [-0.35, -0.5] m;
        inertia = 0.626915 kg*m^2 about input;
        point p1 = [0.79, 0.2] m;
    }
    body B4 {
        mass = 2.72 kg;
        com = [-0.54, -0.26] m;
        output = [0.06, 0.18] m;
        inertia = 0.263349 kg*m^2 about com;
    }
    body B5 {
        mass = 3.94 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m;
        inertia = 0.356432 kg*m^2 about input;
    }
    moving base -> planar j1 -> B1 b1 -> elastic j2 -> B2 b2;
    ground -> floating j3 -> B3 b3 -> floating j4 -> B4 b4 -> slider(y) j5 -> B5 b5;
    hinge j1 { force = input; turning_stiffness = 27.71 N*m/rad; turning_friction = 1.63 N*m; turning_friction_speed = 0.5 rad/s; turning_limits = [-1.09, 0.64] rad; turning_limit_stiffness = 15.0 N*m/rad; torque = input; }
    hinge j2 { stiffness = [10.75, 34.72] N/m; damping = [0.78, 0.37] N*s/m; friction = 1.36 N; friction_speed = 1.0 m/s; limits = [-1.09, 0.12] m; limit_stiffness = 12.9 N/m; limit_damping = 0.75 N*s/m; turning_stiffness = 13.81 N*m/rad; turning_limits = [-1.0, 0.36] rad; turning_limit_stiffness = 55.2 N*m/rad; motion = input; }
    hinge j3 { rest = [0.48, 0.05] m turned 1.08 rad; stiffness = [4.03, 32.22] N/m; limits = [-1.17, 0.98] m; limit_stiffness = 29.8 N/m; limit_damping = 1.1 N*s/m; turning_stiffness = 28.73 N*m/rad; turning_damping = 2.67 N*m*s/rad; turning_armature = 0.26 kg*m^2; motion = input; }
    hinge j4 { motion = input; }
    hinge j5 { force = input; }
    load l1 { on = b3; at = p1; force = input; torque = input; axes = body; }
    load l2 { on = b4; at = output; torque = 3.7 N*m; }
}
}

printed! {
    Tree5, LinePoint, energy_with(state, inputs);
    inputs |drives| {
        tip: line_frame(&drives.finish),
        j3: slider(&drives.motions[0]),
        gravity: drives.gravity[0],
    }
    hinges j1 j2 j3;
    springs;
pub line chain {
    gravity = input;
    body B1 {
        mass = 1.32 kg;
        com = 0.0 m;
        output = 0.0 m;
    }
    body B2 {
        mass = 1.24 kg;
        com = 0.31 m;
        output = 0.99 m;
    }
    body B3 {
        mass = 2.28 kg;
        com = 0.22 m;
        output = 0.0 m;
    }
    B1 b1 -> slider j1 -> B2 b2 -> elastic j2 -> moving tip;
    ground -> elastic j3 -> B3 b3;
    hinge j1 { damping = 1.12 N*s/m; armature = 0.58 kg; limits = [-0.86, 0.89] m; limit_stiffness = 60.0 N/m; limit_damping = 1.95 N*s/m; }
    hinge j3 { motion = input; }
}
}

printed! {
    Tree6, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j1: vector(&drives.efforts, [0, 1, 2]),
        j3: vector(&drives.efforts, [6, 7, 8]),
        j4: vector(&drives.efforts, [9, 10]),
        l1_torque: drives.loads[0].torque.into(),
        l2_torque: drives.loads[1].torque.into(),
        l3_torque: drives.loads[2].torque.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5 j6 j7;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 1.95 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.31, 0.09, -0.76] m;
        inertia = diag(0.100004, 0.101834, 0.084188) kg*m^2 about input;
    }
    body B2 {
        mass = 4.38 kg;
        com = [-0.36, -0.34, 0.52] m;
        output = [0.0, 0.0, 0.75] m turned rpy(180.0, 90.0, 0.0) deg;
        inertia = diag(0.383251, 0.144929, 0.283738) kg*m^2 about com;
        point p1 = [0.0, 0.0, 0.0] m;
    }
    body B3 {
        mass = 2.24 kg;
        com = [0.48, 0.0, 0.0] m;
        output = [0.22, 0.0, 0.0] m;
        inertia = tensor(0.034852, 0.547885, 0.545467, -0.004677, -0.000308, -4.6e-5) kg*m^2 about input;
        point p2 = [0.91, -0.6, -0.18] m;
    }
    body B4 {
        mass = 4.0 kg;
        com = [0.0, 0.0, 0.48] m;
        output = [0.0, 0.0, 0.13] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = diag(1.150225, 0.969909, 0.262683) kg*m^2 about input;
    }
    body B5 {
        mass = 4.01 kg;
        com = [0.15, -0.58, -0.19] m;
        output = [-0.76, 0.83, -0.05] m;
        inertia = tensor(1.662336, 0.552039, 1.829179, 0.308723, 0.056043, -0.414424) kg*m^2 about input;
    }
    body B6 {
        mass = 1.57 kg;
        com = [0.0, -0.28, 0.0] m;
        output = [1.07, -0.26, 1.15] m turned rpy(-161.6, -126.2, -49.0) deg;
        inertia = diag(0.222207, 0.14452, 0.323663) kg*m^2 about input;
    }
    ground at [-0.92, 0.0, 0.0] m turned rpy(148.5, -42.7, -29.8) deg -> ball j1 -> B1 b1 -> ball j2 -> B2 b2 -> ball j3 -> B3 b3 -> universal(x, [0.0, 0.46, -0.13]) j4 -> moving tip;
    b2.output -> weld j5 -> B4 b4 -> screw([-1.0, 0.0, 0.0], 0.31 m/rad) j6 -> B5 b5 -> pin([-0.85, -1.15, -0.92]) j7 -> B6 b6;
    hinge j1 { torque = input; }
    hinge j2 { damping = 1.18 N*m*s/rad; }
    hinge j3 { torque = input; }
    hinge j4 { torque = input; }
    hinge j6 { rest = 0.05 rad; stiffness = 35.5 N*m/rad; damping = 0.9 N*m*s/rad; armature = 0.66 kg*m^2; friction = 0.29 N*m; friction_speed = 0.3 rad/s; limits = [-0.57, 0.74] rad; limit_stiffness = 31.7 N*m/rad; limit_damping = 0.98 N*m*s/rad; }
    load l1 { on = b1; at = input; torque = input; axes = body; }
    load l2 { on = b2; at = p1; torque = input; axes = body; }
    load l3 { on = b5; force = [-7.5, -4.7, 3.5] N; torque = input; }
    spring s1 { on = b3; at = p2; to = [-1.2, 0.4, -1.3] m; stiffness = 11.1 N/m; damping = 1.82 N*s/m; length = 0.95 m; force = 7.2 N; }
}
}

printed! {
    Tree7, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base: plane_frame(&drives.start),
        base2: plane_frame(&drives.route_starts[1]),
        j2: drives.efforts[2],
        j3: drives.efforts[3],
        l1_force: part(&drives.loads[0].force, 0).into(),
        l2_force: part(&drives.loads[1].force, 0).into(),
        s1_force: drives.springs[0],
        gravity: part(&drives.gravity, 0).into(),
    }
    hinges j1 j2 j3 j4 j5;
    springs s1;
pub plane chain {
    gravity = input;
    body B1 {
        mass = 3.0 kg;
        com = [0.0, 0.0] m;
        output = [0.0, -1.16] m turned 92.6 deg;
        inertia = 0.055266 kg*m^2 about com;
    }
    body B2 {
        mass = 2.94 kg;
        com = [-0.29, 0.0] m;
        output = [0.0, -0.98] m;
        inertia = 0.096803 kg*m^2 about com;
    }
    body B3 {
        mass = 1.42 kg;
        com = [0.0, 0.0] m;
        output = [0.0, -1.08] m;
        inertia = 0.133193 kg*m^2 about input;
        point p1 = [0.0, 0.0] m;
    }
    body B4 {
        mass = 4.23 kg;
        com = [0.28, -0.45] m;
        output = [0.0, 0.0] m;
        inertia = 1.283856 kg*m^2 about input;
    }
    moving base -> weld j1 -> B1 b1 -> planar j2 -> ground;
    b1.input -> slider([0.0, -1.0]) j3 -> B2 b2;
    moving base2 -> pin j4 -> B3 b3;
    b1.input -> elastic j5 -> B4 b4;
    hinge j2 { force = [1.4, 4.2] N; torque = input; }
    hinge j3 { force = input; }
    hinge j4 { rest = -1.49 rad; stiffness = 31.34 N*m/rad; damping = 1.27 N*m*s/rad; armature = 0.15 kg*m^2; }
    hinge j5 { stiffness = 17.66 N/m; damping = [1.34, 1.57] N*s/m; limits = [-0.67, 0.65] m; limit_stiffness = 51.9 N/m; limit_damping = 0.31 N*s/m; turning_stiffness = 21.12 N*m/rad; turning_armature = 0.14 kg*m^2; turning_limits = [-0.85, 0.2] rad; turning_limit_stiffness = 51.2 N*m/rad; turning_limit_damping = 0.67 N*m*s/rad; }
    load l1 { on = b3; force = input; }
    load l2 { on = b4; at = input; force = input; torque = 4.5 N*m; }
    spring s1 { on = b3; at = p1; to = [-0.8, 0.1] m; stiffness = 36.6 N/m; force = input; }
}
}

printed! {
    Tree8, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        tip: space_frame(&drives.finish),
        j8: ball(&drives.motions[0]),
        j1: vector(&drives.efforts, [0, 1]),
        j3: vector(&drives.efforts, [3, 4, 5]),
        l1_force: drives.loads[0].force.into(),
        l2_torque: drives.loads[1].torque.into(),
        c1_force: drives.springs[0],
    }
    hinges j1 j2 j3 j4 j5 j6 j7 j8;
    springs c1 c2;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.23 kg;
        com = [0.08, -0.36, -0.02] m;
        output = [-0.27, -0.51, -0.22] m turned rpy(151.8, 164.2, -1.5) deg;
        inertia = tensor(0.482422, 0.162239, 0.419126, 0.029814, 0.017249, -0.012543) kg*m^2 about input;
    }
    body B2 {
        mass = 0.74 kg;
        com = [0.0, -0.38, 0.0] m;
        output = [-0.51, 0.0, 0.0] m turned rpy(90.0, -90.0, 0.0) deg;
        inertia = tensor(0.064163, 0.061522, 0.09574, 0.00341, 0.018309, 0.005989) kg*m^2 about com;
    }
    body B3 {
        mass = 1.26 kg;
        com = [0.0, 0.0, -0.19] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-77.0, -172.5, 45.4) deg;
        inertia = tensor(0.191114, 0.190314, 0.100963, -0.014237, 0.004264, -0.011348) kg*m^2 about input;
    }
    body B4 {
        mass = 2.96 kg;
        com = [0.0, -0.19, 0.0] m;
        output = [0.54, 0.0, 0.0] m turned rpy(0.0, 180.0, 0.0) deg;
        inertia = tensor(0.312309, 0.201978, 0.187352, -0.00231, -0.014222, -0.015392) kg*m^2 about input;
    }
    body B5 {
        mass = 3.56 kg;
        com = [0.05, 0.08, 0.55] m;
        output = [0.36, 0.68, -0.37] m turned rpy(90.0, 90.0, 180.0) deg;
        inertia = tensor(0.083274, 0.093945, 0.062594, -0.010713, -0.008776, -0.01513) kg*m^2 about com;
    }
    body B6 {
        mass = 4.78 kg;
        com = [0.0, 0.0, 0.51] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = diag(0.127053, 0.126046, 0.114488) kg*m^2 about com;
        point f1 = [0.08, -1.19, -0.21] m;
    }
    body B7 {
        mass = 3.0 kg;
        com = [0.56, 0.03, -0.52] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-90.0, 0.0, 0.0) deg;
        inertia = tensor(0.83503, 1.819231, 0.997804, -0.043455, 0.893161, 0.042868) kg*m^2 about input;
    }
    moving base -> universal(x, [-0.61, 0.8, -0.73]) j1 -> B1 b1 -> screw(x, 0.41 m/rad) j2 -> B2 b2 -> planar(x) j3 -> B3 b3 -> planar(x) j4 -> B4 b4 -> elastic j5 -> B5 b5 -> slider(z) j6 -> B6 b6 -> weld j7 -> moving tip;
    b6.f1 -> ball j8 -> B7 b7;
    hinge j1 { torque = input; }
    hinge j3 { force = input; torque = input; }
    hinge j4 { turning_stiffness = 14.75 N*m/rad; }
    hinge j8 { rest = quaternion(-0.09, -0.18, 0.02, -0.45); stiffness = 3.17 N*m/rad; friction = 0.59 N*m; friction_speed = 0.7 rad/s; motion = input; }
    load l1 { on = b1; at = output; force = input; }
    load l2 { on = b5; torque = input; }
    spring c1 { on = b3; at = input; to = b4.output; stiffness = 22.2 N/m; damping = 0.34 N*s/m; length = 1.15 m; force = input; }
    spring c2 { on = b6; at = output; to = b3.output; stiffness = 37.8 N/m; damping = 1.61 N*s/m; length = 1.37 m; force = 4.9 N; }
}
}

printed! {
    Tree9, Point, energy_with(state, inputs);
    inputs |drives| {
        j4: gimbal(&drives.motions[0]),
        j5: vector(&drives.efforts, [13, 14, 15, 16, 17, 18]),
        l2_force: drives.loads[1].force.into(),
        l3_force: drives.loads[2].force.into(),
    }
    hinges j1 j2 j3 j4 j5;
    springs c1 s2;
pub chain {
    gravity = [-5.92, 5.61, 2.33] m/s^2;
    body B1 {
        mass = 1.35 kg;
        com = [0.08, -0.36, 0.13] m;
        output = [-1.01, -0.08, -0.3] m turned rpy(-86.6, 48.8, 72.9) deg;
        inertia = diag(0.087363, 0.085905, 0.003746) kg*m^2 about com;
    }
    body B2 {
        mass = 3.93 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.57, 0.0, 0.0] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = tensor(0.260162, 0.1228, 0.232272, -0.009616, -0.001134, 0.015097) kg*m^2 about input;
        point f1 = [1.13, 0.74, -0.58] m;
    }
    body B3 {
        mass = 2.56 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.66, 0.0] m;
        inertia = tensor(0.101545, 0.172216, 0.123792, 0.024639, -0.060795, 0.025947) kg*m^2 about input;
    }
    body B4 {
        mass = 2.83 kg;
        com = [-0.03, 0.16, -0.39] m;
        output = [0.89, 0.0, 0.0] m;
        inertia = tensor(0.826083, 0.688719, 0.325111, 0.097683, -0.055287, 0.155009) kg*m^2 about input;
        point p1 = [-0.46, 0.0, 0.0] m;
    }
    body B5 {
        mass = 3.43 kg;
        com = [0.19, -0.1, -0.59] m;
        output = [-0.29, -0.38, -0.6] m turned rpy(-9.8, 155.8, -26.9) deg;
        inertia = tensor(1.686925, 1.595467, 0.390207, 0.06517, 0.384503, -0.20237) kg*m^2 about input;
        point p2 = [0.0, 0.0, 0.25] m;
    }
    ground at [0.0, 0.0, 0.0] m turned rpy(0.0, 0.0, -90.0) deg -> slider([0.0, -0.41, 0.93]) j1 -> B1 b1 -> floating j2 -> B2 b2;
    b2.f1 -> elastic j3 -> B3 b3 -> gimbal(z, [-1.08, 0.57, 0.36], [0.0, 0.0, -1.0]) j4 -> B4 b4 -> elastic j5 -> B5 b5;
    hinge j4 { limits = [-0.25, 0.54] rad; limit_stiffness = 8.0 N*m/rad; motion = input; }
    hinge j5 { force = input; torque = input; }
    load l1 { on = b3; at = input; torque = [0.6, 3.8, -1.9] N*m; }
    load l2 { on = b4; at = p1; force = input; axes = body; }
    load l3 { on = b5; at = p2; force = input; axes = body; }
    spring c1 { on = b1; at = [0.0, 0.0, 0.0] m; to = b4.input; stiffness = 10.1 N/m; }
    spring s2 { on = b3; at = com; to = [1.0, 1.2, -0.2] m; stiffness = 13.9 N/m; }
}
}

printed! {
    Tree10, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base2: plane_frame(&drives.route_starts[1]),
        j2: drives.efforts[6],
    }
    hinges j1 j2;
    springs;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.46 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 1.02] m turned 85.1 deg;
        inertia = 0.071535 kg*m^2 about input;
    }
    body B2 {
        mass = 1.53 kg;
        com = [0.53, 0.26] m;
        output = [0.0, -0.6] m;
        inertia = 0.141546 kg*m^2 about com;
    }
    body B3 {
        mass = 3.21 kg;
        com = [0.42, -0.52] m;
        output = [1.19, 0.8] m turned 180.0 deg;
        inertia = 0.313607 kg*m^2 about com;
    }
    B1 b1;
    b1.input -> elastic j1 -> B2 b2;
    moving base2 -> pin j2 -> B3 b3;
    hinge j2 { rest = 0.56 rad; stiffness = 9.16 N*m/rad; armature = 0.51 kg*m^2; limits = [-0.54, 0.23] rad; limit_stiffness = 23.5 N*m/rad; torque = input; }
}
}

printed! {
    Tree11, LinePoint, energy(state);
    inputs |drives| {
        j1: drives.efforts[0],
        j3: drives.efforts[2],
        j4: drives.efforts[3],
        j5: drives.efforts[4],
        l1_force: drives.loads[0].force[0],
        l2_force: drives.loads[1].force[0],
        gravity: drives.gravity[0],
    }
    hinges j1 j2 j3 j4 j5 j6;
    springs s1 s2;
pub line chain {
    gravity = input;
    body B1 {
        mass = 3.26 kg;
        com = 0.0 m;
        output = -0.81 m;
    }
    body B2 {
        mass = 0.65 kg;
        com = -0.58 m;
        output = 0.41 m;
    }
    body B3 {
        mass = 0.45 kg;
        com = 0.29 m;
        output = 0.0 m;
    }
    body B4 {
        mass = 4.44 kg;
        com = -0.1 m;
        output = 0.16 m;
    }
    body B5 {
        mass = 2.72 kg;
        com = 0.0 m;
        output = -0.37 m;
    }
    body B6 {
        mass = 2.16 kg;
        com = -0.36 m;
        output = 0.0 m;
    }
    B1 b1 -> elastic j1 -> B2 b2 -> floating j2 -> ground at -0.96 m;
    b1.output -> floating j3 -> B3 b3 -> floating j4 -> B4 b4;
    b1.output -> slider j5 -> B5 b5 -> elastic j6 -> B6 b6;
    hinge j1 { force = input; }
    hinge j2 { damping = 0.64 N*s/m; friction = 0.96 N; friction_speed = 0.9 m/s; }
    hinge j3 { force = input; }
    hinge j4 { force = input; }
    hinge j5 { rest = -0.46 m; stiffness = 22.24 N/m; armature = 0.54 kg; friction = 0.69 N; friction_speed = 0.5 m/s; limits = [-0.46, 0.99] m; limit_stiffness = 20.4 N/m; limit_damping = 0.45 N*s/m; force = input; }
    load l1 { on = b3; force = input; }
    load l2 { on = b4; force = input; }
    spring s1 { on = b1; at = com; to = 1.3 m; stiffness = 25.7 N/m; }
    spring s2 { on = b3; at = 0.59 m; to = -0.6 m; stiffness = 18.1 N/m; damping = 0.43 N*s/m; force = -5.8 N; }
}
}

printed! {
    Tree12, Point, energy_with(state, inputs);
    inputs |drives| {
        j2: screw(&drives.motions[0]),
        j5: vector(&drives.efforts, [10, 11, 12]),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5;
    springs s1 s2;
pub chain {
    gravity = input;
    body B1 {
        mass = 4.32 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-1.19, 0.95, 0.12] m turned rpy(15.9, -170.1, 59.0) deg;
        inertia = tensor(0.156746, 0.275987, 0.187806, -0.011821, -0.010694, 0.036062) kg*m^2 about input;
    }
    body B2 {
        mass = 3.66 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.22, 0.0, 0.0] m;
        inertia = diag(0.128432, 0.110188, 0.072142) kg*m^2 about input;
    }
    body B3 {
        mass = 4.46 kg;
        com = [0.0, -0.53, 0.0] m;
        output = [0.0, -0.25, 0.0] m turned rpy(118.0, -132.9, -13.6) deg;
        inertia = tensor(1.32311, 0.086654, 1.317882, 0.001072, -0.011037, -0.017393) kg*m^2 about input;
    }
    body B4 {
        mass = 0.83 kg;
        com = [0.01, 0.35, -0.04] m;
        output = [0.0, 0.81, 0.0] m;
        inertia = tensor(0.164403, 0.072337, 0.209617, -0.002905, 0.000332, 0.01162) kg*m^2 about input;
    }
    ground at [0.45, 0.0, 0.0] m -> elastic j1 -> B1 b1 -> screw(x, -0.34 m/rad) j2 -> ground at [0.08, -1.41, -0.83] m turned rpy(152.6, -22.6, -27.1) deg;
    b1.output -> screw([1.08, -0.16, 0.0], -0.38 m/rad) j3 -> B2 b2 -> gimbal([0.0, -1.0, 0.0], [0.0, -0.47, 0.96], [0.0, 1.11, 0.28]) j4 -> B3 b3 -> elastic j5 -> B4 b4;
    hinge j1 { rest = [-0.25, -0.05, 0.05] m turned rpy(-0.27, -0.21, 0.31) rad; turning_stiffness = 28.84 N*m/rad; turning_armature = 0.12 kg*m^2; turning_limits = [-0.58, 0.66] rad; turning_limit_stiffness = 58.8 N*m/rad; }
    hinge j2 { motion = input; }
    hinge j3 { torque = 4.6 N*m; }
    hinge j4 { limits = [-0.92, 1.19] rad; limit_stiffness = 41.9 N*m/rad; }
    hinge j5 { stiffness = [30.37, 18.43, 5.79] N/m; damping = 1.15 N*s/m; limits = [-0.96, 0.68] m; limit_stiffness = 25.2 N/m; limit_damping = 1.45 N*s/m; force = input; torque = [4.1, -0.6, 2.6] N*m; }
    spring s1 { on = b2; at = [0.0, 0.72, 0.0] m; to = [-0.6, -1.0, -0.7] m; stiffness = 17.2 N/m; length = 1.14 m; }
    spring s2 { on = b3; at = output; to = [1.2, -1.5, 0.4] m; stiffness = 16.0 N/m; damping = 0.28 N*s/m; }
}
}

printed! {
    Tree13, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base1: plane_frame(&drives.route_starts[0]),
        base3: plane_frame(&drives.route_starts[2]),
        base17: plane_frame(&drives.route_starts[16]),
        j18: planar(&drives.motions[0]),
        j29: planar(&drives.motions[1]),
        j2: drives.efforts[6],
        j3: vector(&drives.efforts, [7, 8, 9]),
        j16: vector(&drives.efforts, [30, 31]),
        j19: drives.efforts[34],
        j20: vector(&drives.efforts, [35, 36, 37]),
        j23: vector(&drives.efforts, [38, 39]),
        j26: vector(&drives.efforts, [43, 44, 45]),
        j28: drives.efforts[49],
        j33: vector(&drives.efforts, [54, 55]),
        j35: vector(&drives.efforts, [58, 59, 60]),
        j37: vector(&drives.efforts, [62, 63, 64]),
        j39: vector(&drives.efforts, [65, 66]),
        l2_torque: drives.loads[1].torque[2],
        l5_force: part(&drives.loads[4].force, 0).into(),
        l6_torque: drives.loads[5].torque[2],
        l7_force: part(&drives.loads[6].force, 0).into(),
        l7_torque: drives.loads[6].torque[2],
        l10_torque: drives.loads[9].torque[2],
        s11_force: drives.springs[10],
    }
    hinges j1 j2 j3 j4 j5 j6 j7 j8 j9 j10 j11 j12 j13 j14 j15 j16 j17 j18 j19 j20 j21 j22 j23 j24 j25 j26 j27 j28 j29 j30 j31 j32 j33 j34 j35 j36 j37 j38 j39;
    springs c1 c2 c3 c4 c5 c6 c7 s8 s9 s10 s11 s12 s13 s14 s15 s16 s17 s18 s19;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    body B1 {
        mass = 3.24 kg;
        com = [-0.18, 0.27] m;
        output = [0.06, 0.3] m turned -59.0 deg;
        inertia = 0.081848 kg*m^2 about com;
        point f2 = [0.65, 1.06] m;
    }
    body B2 {
        mass = 1.89 kg;
        com = [0.0, 0.0] m;
        output = [0.88, -0.1] m;
        inertia = 0.240687 kg*m^2 about com;
    }
    body B3 {
        mass = 3.34 kg;
        com = [0.0, 0.0] m;
        output = [0.67, 0.0] m turned 140.4 deg;
        inertia = 0.211631 kg*m^2 about com;
        point f1 = [-1.11, -1.0] m;
    }
    body B4 {
        mass = 5.0 kg;
        com = [0.28, 0.0] m;
        output = [-0.3, 1.04] m turned -90.0 deg;
        inertia = 0.724534 kg*m^2 about input;
    }
    body B5 {
        mass = 1.88 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m;
        inertia = 0.134924 kg*m^2 about com;
    }
    body B6 {
        mass = 0.41 kg;
        com = [-0.58, -0.15] m;
        output = [0.0, 0.0] m turned 90.0 deg;
        inertia = 0.025033 kg*m^2 about com;
        point f3 = [0.0, 0.0] m turned 11.3 deg;
    }
    body B7 {
        mass = 1.17 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m;
        inertia = 0.029415 kg*m^2 about com;
    }
    body B8 {
        mass = 1.58 kg;
        com = [0.0, 0.0] m;
        output = [0.84, 0.2] m;
        inertia = 0.200068 kg*m^2 about input;
    }
    body B9 {
        mass = 3.11 kg;
        com = [0.0, 0.0] m;
        output = [1.19, 0.0] m;
        inertia = 0.100181 kg*m^2 about com;
    }
    body B10 {
        mass = 1.07 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m;
        inertia = 0.116909 kg*m^2 about input;
        point f4 = [0.0, 1.1] m turned 39.0 deg;
    }
    body B11 {
        mass = 1.77 kg;
        com = [0.45, -0.28] m;
        output = [0.0, 0.31] m;
        inertia = 0.763234 kg*m^2 about input;
    }
    body B12 {
        mass = 1.64 kg;
        com = [0.21, 0.14] m;
        output = [-1.0, 0.0] m turned 59.6 deg;
        inertia = 0.224469 kg*m^2 about input;
    }
    body B13 {
        mass = 0.37 kg;
        com = [-0.25, -0.27] m;
        output = [0.38, -0.56] m;
        inertia = 0.092249 kg*m^2 about input;
    }
    body B14 {
        mass = 2.37 kg;
        com = [0.15, -0.5] m;
        output = [1.11, 0.0] m turned -136.7 deg;
        inertia = 0.057505 kg*m^2 about com;
    }
    body B15 {
        mass = 0.25 kg;
        com = [0.48, 0.53] m;
        output = [0.0, 0.77] m turned 90.0 deg;
        inertia = 0.018474 kg*m^2 about com;
        point p1 = [0.5, 0.0] m;
    }
    body B16 {
        mass = 1.62 kg;
        com = [0.58, -0.14] m;
        output = [0.5, 0.21] m;
        inertia = 0.716186 kg*m^2 about input;
    }
    body B17 {
        mass = 1.12 kg;
        com = [0.0, 0.0] m;
        output = [1.13, 0.13] m turned 180.0 deg;
        inertia = 0.15887 kg*m^2 about com;
        point p2 = [0.3, 0.0] m;
    }
    body B18 {
        mass = 3.15 kg;
        com = [0.16, 0.22] m;
        output = [0.0, 0.0] m;
        inertia = 0.520302 kg*m^2 about input;
    }
    body B19 {
        mass = 0.49 kg;
        com = [0.0, 0.0] m;
        output = [-0.57, 0.72] m;
        inertia = 0.025909 kg*m^2 about com;
    }
    body B20 {
        mass = 0.57 kg;
        com = [0.0, 0.0] m;
        output = [-0.68, 0.22] m;
        inertia = 0.01466 kg*m^2 about com;
    }
    body B21 {
        mass = 0.25 kg;
        com = [0.0, 0.0] m;
        output = [0.18, 0.0] m turned 45.2 deg;
        inertia = 0.034253 kg*m^2 about com;
    }
    body B22 {
        mass = 4.65 kg;
        com = [-0.1, 0.29] m;
        output = [0.0, 0.04] m;
        inertia = 0.974007 kg*m^2 about input;
    }
    body B23 {
        mass = 3.22 kg;
        com = [0.0, -0.57] m;
        output = [0.0, 0.0] m turned -90.0 deg;
        inertia = 1.067423 kg*m^2 about input;
    }
    body B24 {
        mass = 2.08 kg;
        com = [-0.33, 0.31] m;
        output = [-1.19, 0.0] m turned 90.0 deg;
        inertia = 0.521936 kg*m^2 about input;
    }
    body B25 {
        mass = 3.27 kg;
        com = [0.36, 0.12] m;
        output = [0.02, -0.49] m;
        inertia = 0.06779 kg*m^2 about com;
    }
    body B26 {
        mass = 2.9 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m turned 99.8 deg;
        inertia = 0.242499 kg*m^2 about input;
        point p3 = [-0.76, -0.32] m;
    }
    body B27 {
        mass = 0.21 kg;
        com = [-0.16, 0.3] m;
        output = [0.0, -0.28] m;
        inertia = 0.037274 kg*m^2 about input;
    }
    body B28 {
        mass = 2.7 kg;
        com = [0.0, 0.0] m;
        output = [0.16, -0.69] m turned -82.9 deg;
        inertia = 0.289837 kg*m^2 about com;
    }
    body B29 {
        mass = 2.94 kg;
        com = [-0.08, -0.35] m;
        output = [-0.29, -0.33] m turned -67.1 deg;
        inertia = 0.526571 kg*m^2 about input;
        point f5 = [-0.05, 0.13] m;
    }
    body B30 {
        mass = 1.49 kg;
        com = [0.39, 0.24] m;
        output = [0.0, 0.51] m;
        inertia = 0.070454 kg*m^2 about com;
        point p4 = [0.37, 0.7] m;
    }
    body B31 {
        mass = 3.1 kg;
        com = [-0.51, 0.19] m;
        output = [-0.44, 1.18] m turned -90.0 deg;
        inertia = 0.195062 kg*m^2 about com;
        point p5 = [0.72, 0.0] m;
    }
    body B32 {
        mass = 4.63 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 0.0] m;
        inertia = 0.107212 kg*m^2 about input;
    }
    body B33 {
        mass = 0.84 kg;
        com = [0.52, -0.44] m;
        output = [0.0, 0.6] m;
        inertia = 0.030515 kg*m^2 about com;
    }
    body B34 {
        mass = 1.21 kg;
        com = [0.0, 0.0] m;
        output = [0.0, 1.17] m;
        inertia = 0.168819 kg*m^2 about input;
    }
    body B35 {
        mass = 3.74 kg;
        com = [0.21, 0.0] m;
        output = [-0.07, -0.11] m turned -103.8 deg;
        inertia = 0.214319 kg*m^2 about input;
    }
    body B36 {
        mass = 2.79 kg;
        com = [-0.17, 0.19] m;
        output = [-1.14, 0.0] m turned -139.6 deg;
        inertia = 0.343805 kg*m^2 about input;
    }
    body B37 {
        mass = 0.57 kg;
        com = [-0.22, 0.33] m;
        output = [0.76, 0.0] m turned 15.6 deg;
        inertia = 0.046425 kg*m^2 about com;
    }
    body B38 {
        mass = 0.54 kg;
        com = [0.0, 0.12] m;
        output = [-0.4, -0.92] m turned 4.9 deg;
        inertia = 0.02429 kg*m^2 about input;
    }
    body B39 {
        mass = 3.25 kg;
        com = [-0.6, 0.27] m;
        output = [0.6, 0.0] m;
        inertia = 1.578774 kg*m^2 about input;
    }
    body B40 {
        mass = 3.87 kg;
        com = [0.0, -0.32] m;
        output = [0.0, 0.0] m;
        inertia = 0.413565 kg*m^2 about com;
    }
    B1 b1 -> planar j1 -> B2 b2;
    moving base1 -> pin j2 -> B3 b3 -> elastic j3 -> B4 b4;
    b3.f1 -> pin j4 -> B5 b5 -> weld j5 -> B6 b6;
    moving base3 -> planar j6 -> B7 b7;
    b1.f2 -> slider(x) j7 -> B8 b8 -> planar j8 -> B9 b9;
    b6.f3 -> floating j9 -> B10 b10 -> planar j10 -> B11 b11;
    b6.input -> elastic j11 -> B12 b12;
    b6.input -> weld j12 -> B13 b13 -> elastic j13 -> B14 b14 -> weld j14 -> B15 b15;
    b5.input -> weld j15 -> B16 b16 -> floating j16 -> B17 b17;
    b10.f4 -> pin j17 -> B18 b18 -> planar j18 -> B19 b19 -> pin j19 -> B20 b20 -> elastic j20 -> B21 b21;
    b21.input -> weld j21 -> B22 b22 -> weld j22 -> B23 b23 -> elastic j23 -> B24 b24 -> pin j24 -> B25 b25;
    b11.output -> slider([-0.44, 0.16]) j25 -> B26 b26 -> floating j26 -> B27 b27 -> slider(x) j27 -> B28 b28;
    b24.output -> floating j28 -> B29 b29;
    b29.f5 -> planar j29 -> B30 b30 -> weld j30 -> B31 b31;
    ground -> floating j31 -> B32 b32 -> pin j32 -> B33 b33;
    b29.input -> floating j33 -> B34 b34 -> pin j34 -> B35 b35 -> floating j35 -> B36 b36;
    b33.output -> slider([-0.62, 0.21]) j36 -> B37 b37 -> elastic j37 -> B38 b38 -> weld j38 -> B39 b39;
    moving base17 -> floating j39 -> B40 b40;
    hinge j1 { turning_damping = 0.83 N*m*s/rad; turning_limits = [-0.14, 1.14] rad; turning_limit_stiffness = 40.8 N*m/rad; }
    hinge j2 { torque = input; }
    hinge j3 { force = input; turning_damping = 1.02 N*m*s/rad; turning_armature = 0.76 kg*m^2; turning_friction = 1.87 N*m; turning_friction_speed = 0.3 rad/s; torque = input; }
    hinge j7 { limits = [-0.19, 0.23] m; limit_stiffness = 20.4 N/m; }
    hinge j9 { rest = [0.18, -0.12] m turned 1.41 rad; stiffness = [24.15, 35.91] N/m; damping = [1.43, 1.81] N*s/m; turning_stiffness = 33.82 N*m/rad; turning_limits = [-1.18, 0.75] rad; turning_limit_stiffness = 16.7 N*m/rad; turning_limit_damping = 1.65 N*m*s/rad; }
    hinge j10 { friction = 1.69 N; friction_speed = 0.4 m/s; }
    hinge j16 { force = input; torque = -4.5 N*m; }
    hinge j18 { rest = [-0.24, 0.16] m turned -0.94 rad; stiffness = 32.12 N/m; damping = [1.66, 2.31] N*s/m; armature = [0.77, 0.66] kg; motion = input; }
    hinge j19 { torque = input; }
    hinge j20 { friction = 0.54 N; friction_speed = 1.0 m/s; limits = [-0.59, 1.11] m; limit_stiffness = 43.1 N/m; force = input; turning_armature = 0.56 kg*m^2; turning_limits = [-0.73, 0.78] rad; turning_limit_stiffness = 6.6 N*m/rad; turning_limit_damping = 1.35 N*m*s/rad; torque = input; }
    hinge j23 { force = input; turning_damping = 2.83 N*m*s/rad; torque = 1.0 N*m; }
    hinge j25 { force = 4.3 N; }
    hinge j26 { force = input; torque = input; }
    hinge j27 { stiffness = 18.54 N/m; damping = 1.01 N*s/m; armature = 0.25 kg; friction = 1.9 N; friction_speed = 0.5 m/s; }
    hinge j28 { force = [-4.2, -3.1] N; torque = input; }
    hinge j29 { rest = [-0.42, 0.37] m turned -0.65 rad; stiffness = 14.86 N/m; damping = [1.52, 2.73] N*s/m; friction = [0.21, 1.5] N; friction_speed = 0.7 m/s; turning_damping = 2.11 N*m*s/rad; turning_armature = 0.65 kg*m^2; motion = input; }
    hinge j31 { damping = [0.85, 2.14] N*s/m; armature = 0.51 kg; }
    hinge j32 { damping = 0.11 N*m*s/rad; }
    hinge j33 { rest = [-0.36, -0.44] m turned -1.13 rad; damping = [1.43, 1.75] N*s/m; armature = 0.3 kg; limits = [-1.02, 1.14] m; limit_stiffness = 28.7 N/m; force = input; turning_stiffness = 39.04 N*m/rad; turning_damping = 2.39 N*m*s/rad; turning_friction = 0.89 N*m; turning_friction_speed = 0.7 rad/s; torque = 1.3 N*m; }
    hinge j34 { damping = 0.24 N*m*s/rad; friction = 1.78 N*m; friction_speed = 0.1 rad/s; torque = 2.6 N*m; }
    hinge j35 { rest = [0.11, 0.24] m turned -0.27 rad; armature = 0.5 kg; friction = 0.95 N; friction_speed = 0.5 m/s; force = input; turning_stiffness = 34.87 N*m/rad; turning_damping = 2.07 N*m*s/rad; turning_limits = [-0.36, 0.21] rad; turning_limit_stiffness = 52.5 N*m/rad; turning_limit_damping = 0.8 N*m*s/rad; torque = input; }
    hinge j36 { force = 1.7 N; }
    hinge j37 { armature = [0.56, 0.73] kg; friction = [1.55, 1.49] N; friction_speed = 0.9 m/s; force = input; turning_damping = 1.51 N*m*s/rad; turning_limits = [-0.63, 0.76] rad; turning_limit_stiffness = 8.9 N*m/rad; torque = input; }
    hinge j39 { rest = [-0.39, -0.11] m turned -0.34 rad; stiffness = 31.4 N/m; armature = 0.15 kg; friction = 1.11 N; friction_speed = 0.7 m/s; force = input; turning_stiffness = 10.56 N*m/rad; turning_damping = 1.81 N*m*s/rad; turning_friction = 0.35 N*m; turning_friction_speed = 0.1 rad/s; torque = 2.6 N*m; }
    load l1 { on = b6; at = input; force = [-3.6, 1.9] N; axes = body; }
    load l2 { on = b12; at = [0.0, 0.0] m; torque = input; }
    load l3 { on = b14; at = output; force = [-5.6, -5.8] N; axes = body; }
    load l4 { on = b15; at = p1; torque = -1.4 N*m; }
    load l5 { on = b17; at = p2; force = input; torque = -6.8 N*m; }
    load l6 { on = b19; at = input; torque = input; }
    load l7 { on = b26; at = p3; force = input; torque = input; }
    load l8 { on = b30; at = input; torque = -7.8 N*m; }
    load l9 { on = b31; at = p5; torque = -3.4 N*m; axes = body; }
    load l10 { on = b36; at = [0.0, 0.0] m; torque = input; axes = body; }
    load l11 { on = b39; at = output; torque = -7.0 N*m; axes = body; }
    spring c1 { on = b5; at = output; to = b33.input; stiffness = 10.5 N/m; }
    spring c2 { on = b10; at = [0.81, 0.0] m; to = b11.output; stiffness = 10.4 N/m; damping = 0.58 N*s/m; length = 1.35 m; }
    spring c3 { on = b16; at = [0.0, 0.0] m; to = b28.input; stiffness = 14.7 N/m; }
    spring c4 { on = b24; at = [-0.98, 0.0] m; to = b33.com; stiffness = 39.4 N/m; damping = 0.33 N*s/m; length = 0.43 m; }
    spring c5 { on = b26; at = [-0.88, 0.0] m; to = b4.com; stiffness = 8.5 N/m; damping = 1.44 N*s/m; length = 0.99 m; }
    spring c6 { on = b30; at = [0.0, 0.0] m; to = b22.output; stiffness = 2.9 N/m; length = 0.2 m; }
    spring c7 { on = b31; at = [-0.43, 0.41] m; to = b19.com; stiffness = 33.0 N/m; damping = 0.28 N*s/m; }
    spring s8 { on = b3; at = [0.0, 0.43] m; to = [-0.3, -0.6] m; stiffness = 37.3 N/m; damping = 0.62 N*s/m; length = 0.9 m; }
    spring s9 { on = b6; at = input; to = [0.3, 0.0] m; stiffness = 7.8 N/m; }
    spring s10 { on = b10; at = output; to = [1.8, 1.9] m; stiffness = 23.9 N/m; force = -2.3 N; }
    spring s11 { on = b17; at = [0.0, 0.0] m; to = [1.5, 0.9] m; stiffness = 37.1 N/m; damping = 0.74 N*s/m; length = 0.23 m; force = input; }
    spring s12 { on = b22; at = com; to = [0.2, -0.6] m; stiffness = 25.8 N/m; }
    spring s13 { on = b26; at = [0.0, 0.0] m; to = [0.8, -1.5] m; stiffness = 23.3 N/m; damping = 2.34 N*s/m; length = 0.54 m; }
    spring s14 { on = b29; at = com; to = [-1.3, -0.1] m; stiffness = 39.5 N/m; length = 1.38 m; }
    spring s15 { on = b30; at = p4; to = [-1.4, 0.5] m; stiffness = 30.9 N/m; }
    spring s16 { on = b32; at = output; to = [-1.0, -0.2] m; stiffness = 25.8 N/m; damping = 1.95 N*s/m; }
    spring s17 { on = b33; at = [-0.67, -0.99] m; to = [-1.5, 1.1] m; stiffness = 25.1 N/m; damping = 0.52 N*s/m; }
    spring s18 { on = b38; at = output; to = [1.1, -0.6] m; stiffness = 28.5 N/m; force = 3.1 N; }
    spring s19 { on = b39; at = output; to = [0.1, 1.0] m; stiffness = 36.2 N/m; length = 0.72 m; force = -5.8 N; }
}
}

printed! {
    Tree20, Point, energy_with(state, inputs);
    inputs |drives| {
        j7: floating(&drives.motions[0]),
        i3_i1_j3: drives.efforts[14],
        i3_i1_j4: vector(&drives.efforts, [15, 16, 17, 18, 19, 20]),
        i3_i2_j3: drives.efforts[21],
        i3_i2_j4: vector(&drives.efforts, [22, 23, 24, 25, 26, 27]),
        i3_j5: drives.efforts[30],
        i4_i1_j3: drives.efforts[49],
        i4_i1_j4: vector(&drives.efforts, [50, 51, 52, 53, 54, 55]),
        i4_i2_j3: drives.efforts[56],
        i4_i2_j4: vector(&drives.efforts, [57, 58, 59, 60, 61, 62]),
        i4_j5: drives.efforts[65],
        l1_force: drives.loads[0].force.into(),
        l1_torque: drives.loads[0].torque.into(),
        i3_i1_l2_torque: drives.loads[2].torque.into(),
        i3_i2_l2_torque: drives.loads[4].torque.into(),
        i3_l1_torque: drives.loads[5].torque.into(),
        i4_i1_l2_torque: drives.loads[7].torque.into(),
        i4_i2_l2_torque: drives.loads[9].torque.into(),
        i4_l1_torque: drives.loads[10].torque.into(),
        c3_force: drives.springs[2],
        i3_i1_s1_force: drives.springs[3],
        i3_i1_s2_force: drives.springs[4],
        i3_i2_s1_force: drives.springs[5],
        i3_i2_s2_force: drives.springs[6],
        i4_i1_s1_force: drives.springs[7],
        i4_i1_s2_force: drives.springs[8],
        i4_i2_s1_force: drives.springs[9],
        i4_i2_s2_force: drives.springs[10],
    }
    hinges i3_i1_j1 i3_i1_j2 i3_i2_j1 i3_i2_j2 j7 i3_i1_j3 i3_i1_j4 i3_i2_j3 i3_i2_j4 i3_j5 i3_j6 j8 j9 i4_i1_j1 i4_i1_j2 i4_i2_j1 i4_i2_j2 i4_i1_j3 i4_i1_j4 i4_i2_j3 i4_i2_j4 i4_j5 i4_j6;
    springs c1 c2 c3 i3_i1_s1 i3_i1_s2 i3_i2_s1 i3_i2_s2 i4_i1_s1 i4_i1_s2 i4_i2_s1 i4_i2_s2;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    part Limb0(size) {
    body B1 {
        mass = size*1.57 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.73, -0.01, 0.21] m turned rpy(0.0, 0.0, -90.0) deg;
        inertia = tensor(size*0.037134, size*0.048914, size*0.070011, size*-0.00435, size*0.00176, size*-0.010544) kg*m^2 about com;
        point f3 = [0.0, 0.0, 0.57] m turned rpy(90.0, 0.0, 0.0) deg;
        point p1 = [0.66, 0.8, 0.95] m;
    }
    body B2 {
        mass = size*1.22 kg;
        com = [0.0, 0.0, -0.53] m;
        output = [1.1, -0.32, 0.96] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = tensor(size*0.423937, size*0.428328, size*0.076872, size*-0.001331, size*-0.003187, size*-0.003822) kg*m^2 about input;
    }
    body B3 {
        mass = size*4.91 kg;
        com = [-0.11, 0.0, 0.0] m;
        output = [-1.15, -1.06, -0.14] m turned rpy(104.0, -1.3, 107.9) deg;
        inertia = diag(size*0.182439, size*0.256609, size*0.118036) kg*m^2 about com;
        point f2 = [0.42, 0.0, 0.0] m;
    }
    body B4 {
        mass = size*1.24 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.12, -0.41, 0.64] m turned rpy(-43.0, -124.8, 62.7) deg;
        inertia = tensor(size*0.154263, size*0.093782, size*0.118635, size*-0.01933, size*0.021252, size*-0.001731) kg*m^2 about input;
    }
    elastic j1 -> B1 b1 -> screw([0.5, 0.66, 0.0], 0.51 m/rad) j2 -> B2 b2;
    b1.output -> slider(x) j3 -> B3 b3 -> elastic j4 -> B4 b4;
    hinge j1 { stiffness = [17.87, 2.25, 37.39] N/m; damping = 0.47 N*s/m; turning_armature = 0.68 kg*m^2; }
    hinge j2 { damping = 0.46 N*m*s/rad; limits = [-1.04, 0.35] rad; limit_stiffness = 12.7 N*m/rad; limit_damping = 1.87 N*m*s/rad; }
    hinge j3 { force = input; }
    hinge j4 { force = input; torque = input; }
    load l1 { on = b1; force = [4.0, -6.7, -7.7] N; torque = [4.6, 1.8, -1.1] N*m; }
    load l2 { on = b3; at = [0.0, 0.0, 0.0] m; force = [-4.9, -3.0, -7.5] N; torque = input; axes = body; }
    spring s1 { on = b1; at = p1; to = [-1.9, -1.3, 0.3] m; stiffness = 37.3 N/m; damping = 0.3 N*s/m; force = input; }
    spring s2 { on = b4; at = input; to = [-1.2, 0.6, 0.5] m; stiffness = 16.4 N/m; damping = 2.99 N*s/m; force = input; }
    }
    part Limb1(size) {
    body B5 {
        mass = size*3.21 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(73.6, -128.6, 133.7) deg;
        inertia = tensor(size*0.045631, size*0.044349, size*0.046501, size*0.00529, size*0.008238, size*0.009307) kg*m^2 about input;
    }
    body B6 {
        mass = size*2.56 kg;
        com = [0.0, 0.33, 0.0] m;
        output = [-0.25, -0.99, 0.84] m;
        inertia = diag(size*0.035225, size*0.080628, size*0.099001) kg*m^2 about com;
    }
    Limb0(2.0) i1 -> Limb0(0.5) i2;
    i1.b3.f2 -> planar(z) j5 -> B5 b5 -> screw([0.73, 1.39, -0.29], -0.57 m/rad) j6 -> B6 b6;
    hinge j5 { force = [-3.9, -0.3] N; turning_stiffness = 12.53 N*m/rad; torque = input; }
    hinge j6 { damping = 0.67 N*m*s/rad; armature = 0.13 kg*m^2; limits = [-0.99, 0.92] rad; limit_stiffness = 41.2 N*m/rad; }
    load l1 { on = b6; at = output; torque = input; axes = body; }
    }
    body B7 {
        mass = 4.04 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.092091, 0.061037, 0.06485, 0.017929, 0.004374, -0.020226) kg*m^2 about input;
    }
    body B8 {
        mass = 1.96 kg;
        com = [0.4, 0.0, 0.0] m;
        output = [0.0, 0.42, 0.0] m turned rpy(-174.5, -152.0, -110.2) deg;
        inertia = tensor(0.149222, 0.458053, 0.456712, 0.005825, -0.007967, 0.013141) kg*m^2 about input;
    }
    body B9 {
        mass = 3.59 kg;
        com = [-0.6, 0.12, -0.24] m;
        output = [-1.18, 0.75, -1.14] m turned rpy(-141.9, -42.1, -157.2) deg;
        inertia = tensor(0.24827, 0.255682, 0.282674, -0.009777, 0.082946, -0.015174) kg*m^2 about com;
    }
    B7 b7 -> Limb1(1.0) i3 -> floating j7 -> ground;
    i3.i2.b1.f3 -> weld j8 -> B8 b8;
    b7.output -> planar(y) j9 -> B9 b9 -> Limb1(0.5) i4;
    hinge j7 { rest = [-0.13, -0.21, -0.26] m turned quaternion(-0.19, -0.29, 0.33, 0.15); turning_stiffness = 6.77 N*m/rad; turning_damping = 1.69 N*m*s/rad; turning_armature = 0.53 kg*m^2; turning_limits = 1.84 rad; turning_limit_stiffness = 19.5 N*m/rad; turning_limit_damping = 1.15 N*m*s/rad; motion = input; }
    hinge j9 { turning_damping = 0.21 N*m*s/rad; turning_limits = [-0.99, 0.91] rad; turning_limit_stiffness = 45.9 N*m/rad; }
    load l1 { on = b7; force = input; torque = input; }
    spring c1 { on = i3.i1.b4; at = [0.0, 0.97, 0.0] m; to = i4.b5.com; stiffness = 20.0 N/m; }
    spring c2 { on = i3.b5; at = output; to = i4.i1.b3.input; stiffness = 18.1 N/m; damping = 1.29 N*s/m; }
    spring c3 { on = b9; at = [0.86, -0.66, -0.45] m; to = i3.i2.b2.com; stiffness = 19.4 N/m; damping = 1.18 N*s/m; force = input; }
}
}

printed! {
    Tree21, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        j4: slider(&drives.motions[0]),
        j5: vector(&drives.efforts, [6, 7]),
        j6: drives.efforts[12],
        i1_l1_force: part(&drives.loads[0].force, 0).into(),
    }
    hinges j4 i1_j1 i1_j2 j5 i1_j3 j6;
    springs;
pub plane chain {
    gravity = [-0.96, 5.67] m/s^2;
    part Limb0 {
    body B1 {
        mass = 3.53 kg;
        com = [0.0, 0.16] m;
        output = [0.0, 0.0] m turned 67.0 deg;
        inertia = 0.174858 kg*m^2 about input;
    }
    body B2 {
        mass = 2.21 kg;
        com = [0.0, 0.0] m;
        output = [0.57, 0.0] m turned -45.0 deg;
        inertia = 0.071163 kg*m^2 about com;
    }
    body B3 {
        mass = 0.81 kg;
        com = [0.47, 0.07] m;
        output = [1.03, -0.65] m turned 180.0 deg;
        inertia = 0.036032 kg*m^2 about com;
    }
    floating j1 -> B1 b1 -> planar j2 -> B2 b2;
    b1.input -> planar j3 -> B3 b3;
    hinge j1 { rest = [-0.23, 0.34] m turned -0.66 rad; stiffness = [35.13, 9.12] N/m; damping = [1.39, 1.01] N*s/m; armature = [0.55, 0.63] kg; limits = [-0.92, 0.77] m; limit_stiffness = 13.7 N/m; limit_damping = 0.68 N*s/m; turning_stiffness = 37.03 N*m/rad; turning_armature = 0.78 kg*m^2; turning_limits = [-1.04, 1.0] rad; turning_limit_stiffness = 32.5 N*m/rad; turning_limit_damping = 0.35 N*m*s/rad; }
    hinge j3 { stiffness = 4.96 N/m; damping = 2.55 N*s/m; armature = [0.45, 0.5] kg; limits = [-0.2, 1.14] m; limit_stiffness = 23.4 N/m; }
    load l1 { on = b3; at = [0.26, 0.0] m; force = input; }
    }
    body B4 {
        mass = 1.89 kg;
        com = [0.01, 0.14] m;
        output = [1.19, -0.25] m;
        inertia = 0.039429 kg*m^2 about com;
    }
    body B5 {
        mass = 4.46 kg;
        com = [0.0, 0.2] m;
        output = [-0.23, 0.63] m;
        inertia = 0.35878 kg*m^2 about com;
    }
    ground at [0.43, 0.0] m -> slider(y) j4 -> B4 b4 -> Limb0 i1 -> planar j5 -> ground at [2.12, 0.06] m turned -138.2 deg;
    i1.b3.output -> slider([0.0, -1.0]) j6 -> B5 b5;
    hinge j4 { motion = input; }
    hinge j5 { force = input; torque = -2.4 N*m; }
    hinge j6 { force = input; }
}
}

printed! {
    Tree22, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        j3: ball(&drives.motions[0]),
        j2: drives.efforts[0],
        j5: vector(&drives.efforts, [4, 5, 6, 7, 8, 9]),
        j6: drives.efforts[10],
        l3_force: drives.loads[2].force.into(),
        s1_force: drives.springs[0],
        s4_force: drives.springs[3],
    }
    hinges j2 j3 i1_j1 j4 j5 j6 j7;
    springs s1 s2 s3 s4;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    part Limb0 {
    ball j1;
    hinge j1 { armature = 0.71 kg*m^2; friction = 1.67 N*m; friction_speed = 0.4 rad/s; limits = 1.39 rad; limit_stiffness = 32.0 N*m/rad; }
    }
    body B1 {
        mass = 4.13 kg;
        com = [-0.47, 0.0, 0.0] m;
        output = [0.0, 0.0, 1.1] m turned rpy(146.7, 71.2, -39.6) deg;
        inertia = tensor(0.132913, 1.065313, 1.011078, -0.010901, -0.003371, -0.03605) kg*m^2 about input;
        point p1 = [0.0, 0.52, 0.0] m;
    }
    body B2 {
        mass = 0.48 kg;
        com = [0.14, -0.09, 0.54] m;
        output = [-0.04, 0.42, 1.12] m turned rpy(0.0, 0.0, -90.0) deg;
        inertia = tensor(0.070862, 0.06066, 0.065017, -0.002268, 0.002592, -0.001688) kg*m^2 about com;
    }
    body B3 {
        mass = 3.09 kg;
        com = [0.0, 0.0, 0.27] m;
        output = [0.36, 0.0, 0.0] m;
        inertia = tensor(0.37671, 0.41539, 0.216632, -0.017319, 0.058426, -0.004411) kg*m^2 about input;
    }
    body B4 {
        mass = 3.61 kg;
        com = [-0.44, 0.26, -0.3] m;
        output = [-0.17, -1.12, 0.11] m turned rpy(0.0, 0.0, -90.0) deg;
        inertia = tensor(0.72144, 1.230547, 1.176183, 0.386359, -0.43864, 0.271609) kg*m^2 about input;
        point f2 = [0.0, 1.1, 0.0] m;
    }
    body B5 {
        mass = 1.31 kg;
        com = [-0.24, 0.14, -0.32] m;
        output = [0.0, 0.0, 0.82] m turned rpy(-90.0, 90.0, 180.0) deg;
        inertia = tensor(0.24482, 0.306238, 0.19199, 0.055457, -0.092322, 0.050755) kg*m^2 about input;
    }
    body B6 {
        mass = 3.87 kg;
        com = [0.0, -0.38, 0.0] m;
        output = [1.16, 0.0, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = diag(0.619783, 0.106219, 0.694408) kg*m^2 about input;
    }
    body B7 {
        mass = 3.21 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [1.04, 1.01, 0.02] m;
        inertia = diag(0.160884, 0.347524, 0.325421) kg*m^2 about input;
    }
    moving base -> slider(y) j2 -> B1 b1 -> ball j3 -> B2 b2 -> Limb0 i1 -> B3 b3;
    b1.input -> weld j4 -> B4 b4 -> floating j5 -> B5 b5;
    b4.f2 -> cylindrical(x) j6 -> B6 b6 -> floating j7 -> B7 b7;
    hinge j2 { force = input; }
    hinge j3 { motion = input; }
    hinge j5 { force = input; torque = input; }
    hinge j6 { rest = 0.22 m turned -0.81 rad; force = input; turning_stiffness = 18.3 N*m/rad; turning_armature = 0.07 kg*m^2; turning_friction = 0.32 N*m; turning_friction_speed = 0.7 rad/s; torque = -1.6 N*m; }
    load l1 { on = b1; at = p1; force = [-8.0, 6.8, -4.0] N; }
    load l2 { on = b2; at = output; force = [-3.9, -6.2, -5.9] N; }
    load l3 { on = b3; at = [0.0, 0.0, 0.0] m; force = input; axes = body; }
    spring s1 { on = b1; at = [0.34, 0.0, 0.0] m; to = [-1.6, -1.7, 1.6] m; stiffness = 1.2 N/m; damping = 0.11 N*s/m; force = input; }
    spring s2 { on = b2; at = com; to = [-0.2, 1.0, -1.7] m; stiffness = 13.2 N/m; damping = 2.2 N*s/m; length = 0.73 m; }
    spring s3 { on = b3; at = [0.94, 0.0, 0.0] m; to = [1.2, -0.4, 0.1] m; stiffness = 11.8 N/m; }
    spring s4 { on = b5; at = com; to = [1.0, -0.4, -1.4] m; stiffness = 15.0 N/m; length = 0.7 m; force = input; }
}
}

printed! {
    Tree23, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j2: drives.efforts[18],
    }
    hinges limb0_j1 i2_j1 i3_j1 j2;
    springs c1;
pub chain {
    gravity = [-0.62, -3.12, -3.83] m/s^2;
    part Limb0(size) {
    body B1 {
        mass = size*1.42 kg;
        com = [-0.47, -0.31, -0.26] m;
        output = [0.0, 0.0, 0.48] m turned rpy(0.0, -90.0, 90.0) deg;
        inertia = tensor(size*0.340471, size*0.594641, size*0.577763, size*-0.215654, size*-0.168076, size*-0.156703) kg*m^2 about input;
    }
    B1 b1 -> floating j1;
    hinge j1 { turning_damping = 2.47 N*m*s/rad; }
    }
    body B2 {
        mass = 1.87 kg;
        com = [-0.2, -0.37, -0.58] m;
        output = [0.0, 0.87, 0.0] m turned rpy(90.0, 180.0, 0.0) deg;
        inertia = tensor(1.129553, 0.849738, 0.437756, -0.13838, -0.21692, -0.401302) kg*m^2 about input;
    }
    Limb0(1.0) -> Limb0(0.5) i2 -> Limb0(1.0) i3 -> moving tip;
    limb0.b1.output -> pin([0.0, -1.0, 0.0]) j2 -> B2 b2;
    hinge j2 { rest = 0.22 rad; stiffness = 18.68 N*m/rad; damping = 1.71 N*m*s/rad; armature = 0.68 kg*m^2; torque = input; }
    spring c1 { on = b2; at = [0.0, 0.0, 0.0] m; to = limb0.b1.input; stiffness = 4.6 N/m; force = -7.5 N; }
}
}

printed! {
    Tree24, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        i3_limb0_j2: drives.efforts[16],
        i3_j4: drives.efforts[17],
        i3_j5: vector(&drives.efforts, [18, 19]),
        i3_j6: vector(&drives.efforts, [20, 21]),
        i3_i2_j2: drives.efforts[30],
        i4_j2: drives.efforts[39],
        j10: vector(&drives.efforts, [47, 48]),
        i5_j2: drives.efforts[60],
        i6_j2: drives.efforts[69],
        l1_force: drives.loads[0].force.into(),
        l1_torque: drives.loads[0].torque.into(),
        l2_force: drives.loads[1].force.into(),
        l3_force: drives.loads[2].force.into(),
        l3_torque: drives.loads[2].torque.into(),
        i3_l1_torque: drives.loads[3].torque.into(),
        i3_l2_force: drives.loads[4].force.into(),
        i3_l2_torque: drives.loads[4].torque.into(),
        gravity: drives.gravity.into(),
    }
    hinges j7 i3_j3 i3_limb0_j1 i3_limb0_j2 i3_j4 i3_j5 i3_j6 i3_i2_j1 i3_i2_j2 i4_j1 i4_j2 j8 j9 j10 j11 i5_j1 i5_j2 i6_j1 i6_j2;
    springs c1 c2 c3 c4;
pub chain {
    gravity = input;
    part Limb0(side) {
    body B1 {
        mass = 0.54 kg;
        com = [-0.22, side*-0.03, 0.22] m;
        output = [0.18, side*0.0, 0.0] m turned rpy(109.9, 98.1, 0.5) deg;
        inertia = diag(0.033894, 0.039966, 0.017032) kg*m^2 about com;
        point f2 = [0.26, side*0.0, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
    }
    body B2 {
        mass = 3.63 kg;
        com = [-0.46, side*-0.43, 0.2] m;
        output = [-1.16, side*0.28, 0.76] m turned rpy(-46.1, -29.1, 35.4) deg;
        inertia = tensor(1.351555, 1.291193, 1.757821, side*-0.59933, 0.35475, side*0.3225) kg*m^2 about input;
    }
    elastic j1 -> B1 b1 -> planar(z) j2 -> B2 b2;
    hinge j1 { rest = [-0.2, -0.21, -0.05] m turned rpy(-0.01, 0.02, 0.35) rad; stiffness = [36.47, 26.83, 37.78] N/m; armature = [0.08, 0.3, 0.13] kg; friction = 1.88 N; friction_speed = 0.8 m/s; }
    hinge j2 { rest = [0.39, 0.39] m turned 0.89 rad; stiffness = 29.9 N/m; armature = 0.55 kg; limits = [-0.44, 0.28] m; limit_stiffness = 25.8 N/m; limit_damping = 1.89 N*s/m; force = [4.5, -4.9] N; turning_stiffness = 35.74 N*m/rad; turning_damping = 1.64 N*m*s/rad; torque = input; }
    }
    part Limb1(side) {
    body B3 {
        mass = 1.07 kg;
        com = [0.0, side*-0.46, 0.0] m;
        output = [-0.29, side*0.53, 0.84] m turned rpy(133.7, -11.4, 101.3) deg;
        inertia = diag(0.23053, 0.090024, 0.318547) kg*m^2 about input;
    }
    body B4 {
        mass = 0.41 kg;
        com = [0.23, side*0.0, 0.0] m;
        output = [0.81, side*0.09, 0.28] m;
        inertia = tensor(0.033694, 0.078597, 0.051214, side*0.000471, 0.003069, side*-0.004382) kg*m^2 about input;
    }
    body B5 {
        mass = 0.98 kg;
        com = [0.07, side*-0.6, -0.17] m;
        output = [-0.98, side*-0.64, 0.45] m;
        inertia = diag(0.138136, 0.081764, 0.062489) kg*m^2 about com;
        point f4 = [0.08, side*0.71, 0.63] m turned rpy(144.9, 124.4, -168.8) deg;
    }
    elastic j3 -> B3 b3 -> Limb0(-1.0) -> slider([0.0, -1.0, 0.0]) j4;
    limb0.b1.input -> cylindrical([-0.68, -0.32, 0.9]) j5 -> B4 b4;
    limb0.b1.f2 -> universal([-1.32, -0.95, 1.04], x) j6 -> B5 b5 -> Limb0(1.0) i2;
    hinge j3 { turning_damping = [1.35, 0.14, 2.72] N*m*s/rad; turning_friction = 1.66 N*m; turning_friction_speed = 0.9 rad/s; }
    hinge j4 { force = input; }
    hinge j5 { force = input; turning_stiffness = 21.09 N*m/rad; turning_damping = 1.39 N*m*s/rad; turning_armature = 0.66 kg*m^2; torque = input; }
    hinge j6 { rest = [-1.07, 0.39] rad; stiffness = 35.02 N*m/rad; damping = 2.64 N*m*s/rad; armature = 0.63 kg*m^2; friction = 0.97 N*m; friction_speed = 0.4 rad/s; torque = input; }
    load l1 { on = b3; at = output; torque = input; axes = body; }
    load l2 { on = b5; at = input; force = input; torque = input; axes = body; }
    }
    body B6 {
        mass = 0.83 kg;
        com = [0.0, -0.35, 0.0] m;
        output = [0.0, -1.11, 0.0] m;
        inertia = tensor(0.159514, 0.062176, 0.185007, -0.007589, 0.013183, -0.017045) kg*m^2 about input;
    }
    body B7 {
        mass = 0.92 kg;
        com = [0.56, -0.21, -0.42] m;
        output = [0.0, -1.05, 0.0] m turned rpy(0.0, 180.0, -90.0) deg;
        inertia = tensor(0.236147, 0.516879, 0.397084, 0.108192, 0.216384, -0.081144) kg*m^2 about input;
    }
    body B8 {
        mass = 4.12 kg;
        com = [0.0, 0.0, 0.11] m;
        output = [0.0, 0.0, 0.31] m turned rpy(-90.0, 0.0, 0.0) deg;
        inertia = diag(0.196143, 0.215925, 0.19595) kg*m^2 about input;
    }
    body B9 {
        mass = 1.76 kg;
        com = [0.47, 0.57, 0.56] m;
        output = [-1.05, -1.16, 0.02] m turned rpy(0.0, 180.0, 0.0) deg;
        inertia = tensor(0.033098, 0.021891, 0.023491, -0.004292, -0.005519, 0.003066) kg*m^2 about com;
        point p1 = [0.0, -0.57, 0.0] m;
    }
    body B10 {
        mass = 3.05 kg;
        com = [0.4, 0.14, 0.21] m;
        output = [0.63, 1.0, -1.14] m;
        inertia = tensor(0.341695, 0.206237, 0.243676, 0.073309, 0.010722, -0.010505) kg*m^2 about com;
    }
    ground at [0.71, 1.31, 1.43] m -> universal([0.26, -1.37, 0.0], [0.64, -0.42, -0.67]) j7 -> B6 b6 -> Limb1(1.0) i3 -> moving tip;
    i3.limb0.b1.f2 -> Limb0(1.0) i4 -> pin([0.0, -1.0, 0.0]) j8 -> B7 b7 -> elastic j9 -> B8 b8;
    i3.b5.f4 -> universal(z, x) j10 -> B9 b9 -> gimbal([0.29, 1.2, 0.72], [0.41, 0.38, 0.0], z) j11 -> B10 b10;
    i4.b2.output -> Limb0(-1.0) i5 -> Limb0(1.0) i6;
    hinge j7 { stiffness = 22.34 N*m/rad; damping = 1.03 N*m*s/rad; limits = [-0.25, 1.15] rad; limit_stiffness = 27.2 N*m/rad; torque = [0.5, 0.9] N*m; }
    hinge j9 { rest = [0.18, 0.17, -0.12] m turned rpy(0.19, 0.04, 1.24) rad; stiffness = 18.82 N/m; friction = 0.45 N; friction_speed = 0.1 m/s; limits = [-0.96, 0.15] m; limit_stiffness = 51.7 N/m; limit_damping = 0.54 N*s/m; turning_stiffness = [20.2, 20.74, 10.18] N*m/rad; turning_damping = 2.04 N*m*s/rad; turning_friction = 0.44 N*m; turning_friction_speed = 0.9 rad/s; }
    hinge j10 { torque = input; }
    load l1 { on = b7; force = input; torque = input; axes = body; }
    load l2 { on = b8; at = output; force = input; torque = [-1.8, 1.5, 3.1] N*m; axes = body; }
    load l3 { on = b9; at = p1; force = input; torque = input; }
    spring c1 { on = i3.b5; at = [0.0, -0.84, 0.0] m; to = i5.b1.input; stiffness = 3.6 N/m; damping = 2.82 N*s/m; }
    spring c2 { on = i4.b1; at = [-0.27, 0.0, 0.0] m; to = i3.b5.com; stiffness = 9.3 N/m; length = 0.67 m; }
    spring c3 { on = b8; at = com; to = i4.b2.input; stiffness = 19.1 N/m; force = -2.1 N; }
    spring c4 { on = i6.b1; at = [0.54, -0.38, 0.89] m; to = i3.i2.b1.com; stiffness = 25.4 N/m; damping = 2.14 N*s/m; length = 1.33 m; force = -7.3 N; }
}
}

printed! {
    Tree25, PlanePoint, energy_with(state, inputs);
    inputs |drives| {
        base: plane_frame(&drives.start),
        i3_j1: planar(&drives.motions[0]),
        i7_j1: planar(&drives.motions[1]),
        i9_j1: planar(&drives.motions[2]),
        limb1_j3: vector(&drives.efforts, [0, 1, 2]),
        i2_j3: vector(&drives.efforts, [3, 4, 5]),
        i4_j3: vector(&drives.efforts, [8, 9, 10]),
        i5_j3: vector(&drives.efforts, [11, 12, 13]),
        i6_j3: vector(&drives.efforts, [14, 15, 16]),
        i8_j3: vector(&drives.efforts, [18, 19, 20]),
        l1_torque: drives.loads[0].torque[2],
        l2_force: part(&drives.loads[1].force, 0).into(),
    }
    hinges j4 limb1_j3 i2_j3 j5 i3_j1 i3_j2 i4_j3 i5_j3 i6_j3 i7_j1 i7_j2 i8_j3 i9_j1 i9_j2 j6;
    springs s1 c2;
pub plane chain {
    gravity = [0.0, 0.0] m/s^2;
    part Limb0(size) {
    body B1 {
        mass = size*4.84 kg;
        com = [0.0, 0.0] m;
        output = [0.7, 0.0] m;
        inertia = size*0.149877 kg*m^2 about input;
    }
    floating j1 -> B1 b1 -> slider([0.7, -1.2]) j2;
    hinge j1 { rest = [0.24, 0.39] m turned -1.34 rad; stiffness = 9.35 N/m; damping = 2.07 N*s/m; turning_stiffness = 6.1 N*m/rad; turning_damping = 2.56 N*m*s/rad; motion = input; }
    hinge j2 { stiffness = 26.13 N/m; }
    }
    part Limb1(size) {
    body B2 {
        mass = size*2.71 kg;
        com = [0.34, -0.52] m;
        output = [-0.2, -0.8] m;
        inertia = size*1.133046 kg*m^2 about input;
        point f2 = [0.0, 0.0] m;
    }
    B2 b2 -> planar j3;
    hinge j3 { rest = [0.03, -0.12] m turned -1.25 rad; stiffness = [5.31, 38.22] N/m; damping = 2.25 N*s/m; friction = 1.44 N; friction_speed = 0.9 m/s; force = input; torque = input; }
    }
    body B3 {
        mass = 3.41 kg;
        com = [-0.43, -0.03] m;
        output = [-1.09, -0.92] m;
        inertia = 0.685493 kg*m^2 about input;
    }
    body B4 {
        mass = 4.61 kg;
        com = [0.0, 0.0] m;
        output = [0.89, 0.23] m turned 70.8 deg;
        inertia = 0.440988 kg*m^2 about input;
    }
    body B5 {
        mass = 1.47 kg;
        com = [-0.39, -0.09] m;
        output = [0.0, 0.0] m;
        inertia = 0.09679 kg*m^2 about com;
    }
    body B6 {
        mass = 1.65 kg;
        com = [0.3, 0.0] m;
        output = [0.0, 0.33] m turned 180.0 deg;
        inertia = 0.292419 kg*m^2 about input;
    }
    body B7 {
        mass = 4.37 kg;
        com = [0.58, 0.57] m;
        output = [0.0, 0.0] m;
        inertia = 3.294751 kg*m^2 about input;
    }
    moving base -> weld j4 -> Limb1(0.5) -> Limb1(0.5) i2 -> ground at [-1.46, 0.48] m;
    limb1.b2.input -> slider(y) j5 -> B3 b3 -> Limb0(0.5) i3 -> Limb1(1.0) i4 -> Limb1(1.0) i5 -> Limb1(2.0) i6 -> B4 b4;
    i6.b2.f2 -> Limb0(0.5) i7 -> Limb1(1.0) i8 -> B5 b5;
    ground at [0.0, 0.0] m turned -94.3 deg -> Limb0(0.5) i9 -> B6 b6 -> weld j6 -> B7 b7;
    hinge j5 { rest = -0.1 m; stiffness = 17.72 N/m; friction = 0.96 N; friction_speed = 0.9 m/s; }
    load l1 { on = b3; at = [0.0, -0.46] m; torque = input; }
    load l2 { on = b7; force = input; torque = -8.0 N*m; axes = body; }
    spring s1 { on = b5; at = input; to = [-0.9, -0.9] m; stiffness = 32.1 N/m; length = 0.21 m; }
    spring c2 { on = i6.b2; at = com; to = b5.output; stiffness = 38.2 N/m; damping = 2.8 N*s/m; }
}
}
