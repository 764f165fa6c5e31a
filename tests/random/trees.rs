//! Printed from the seeds in `../random_trees.rs`; not to be edited.

use super::face::printed;
use crate::support::motion::*;

printed! {
    Tree0, Point, energy(state);
    inputs |drives| {
        j3: vector(&drives.efforts, [12, 13, 14]),
    }
    hinges j1 j2 j3;
    springs;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 0.71 kg;
        com = [0.0, 0.0, 0.49] m;
        output = [0.06, 0.13, 0.5] m turned rpy(-106.3, 123.9, 128.0) deg;
        inertia = tensor(0.089705, 0.064008, 0.060031, 0.011142, 0.010095, 0.006645) kg*m^2 about com;
    }
    body B2 {
        mass = 4.79 kg;
        com = [-0.2, -0.31, 0.46] m;
        output = [0.0, 0.0, 0.38] m turned rpy(-49.5, 159.9, 156.1) deg;
        inertia = tensor(0.342233, 0.324039, 0.473788, -0.046278, -0.061273, 0.092924) kg*m^2 about com;
    }
    body B3 {
        mass = 2.45 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.109652, 0.172697, 0.189254, 0.018079, 0.045984, -0.02891) kg*m^2 about com;
    }
    ground -> elastic j1 -> B1 b1;
    ground at [0.0, 0.88, 0.0] m turned rpy(90.0, 0.0, 90.0) deg -> elastic j2 -> B2 b2;
    b2.output -> planar(x) j3 -> B3 b3;
    hinge j1 { rest = [-0.23, -0.2, -0.12] m turned rpy(-0.22, 0.02, -0.48) rad; stiffness = [36.61, 13.02, 36.35] N/m; damping = [1.64, 1.54, 0.74] N*s/m; limits = [-0.66, 0.58] m; limit_stiffness = 58.3 N/m; limit_damping = 1.8 N*s/m; }
    hinge j3 { force = input; torque = input; }
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
        j1: slider(&drives.motions[0]),
        j2: cylindrical(&drives.motions[1]),
        j3: drives.efforts[0],
        j4: drives.efforts[1],
        l2_force: drives.loads[1].force.into(),
    }
    hinges j1 j2 j3 j4;
    springs;
pub chain {
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 3.06 kg;
        com = [0.0, 0.0, -0.27] m;
        output = [-0.39, -0.15, 0.13] m;
        inertia = diag(0.066679, 0.0671, 0.040439) kg*m^2 about com;
    }
    body B2 {
        mass = 3.75 kg;
        com = [-0.59, -0.24, 0.44] m;
        output = [0.0, 0.0, -0.48] m;
        inertia = diag(0.235217, 0.466798, 0.288127) kg*m^2 about com;
        point f1 = [-0.32, 0.83, -0.46] m;
    }
    body B3 {
        mass = 1.73 kg;
        com = [-0.32, 0.12, -0.17] m;
        output = [0.0, 1.09, 0.0] m;
        inertia = tensor(0.145984, 0.342614, 0.275378, 0.057046, -0.095036, 0.046914) kg*m^2 about input;
    }
    body B4 {
        mass = 3.04 kg;
        com = [-0.48, 0.6, -0.2] m;
        output = [0.55, 0.0, 0.0] m;
        inertia = tensor(0.129478, 0.137258, 0.134671, 0.001684, 0.000815, 0.001295) kg*m^2 about com;
    }
    B1 b1 -> slider([-1.0, 0.0, 0.0]) j1 -> B2 b2 -> cylindrical([-0.71, 1.29, 0.87]) j2 -> B3 b3 -> pin(z) j3 -> ground at [-0.72, 1.44, -0.46] m;
    b2.f1 -> screw([0.0, -1.0, 0.0], 0.53 m/rad) j4 -> B4 b4;
    hinge j1 { stiffness = 28.79 N/m; armature = 0.72 kg; friction = 0.44 N; friction_speed = 0.1 m/s; motion = input; }
    hinge j2 { motion = input; }
    hinge j3 { damping = 0.48 N*m*s/rad; armature = 0.72 kg*m^2; friction = 1.47 N*m; friction_speed = 0.2 rad/s; limits = [-1.13, 0.93] rad; limit_stiffness = 47.0 N*m/rad; limit_damping = 0.36 N*m*s/rad; torque = input; }
    hinge j4 { torque = input; }
    load l1 { on = b3; force = [-0.7, -1.6, 3.2] N; }
    load l2 { on = b4; at = input; force = input; torque = [6.1, 2.5, -6.3] N*m; axes = body; }
}
}

printed! {
    Tree3, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: elastic(&drives.motions[0]),
        j3: cylindrical(&drives.motions[1]),
        j8: cylindrical(&drives.motions[2]),
        j5: vector(&drives.efforts, [7, 8, 9]),
        l1_force: drives.loads[0].force.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5 j6 j7 j8;
    springs c1 c2;
pub chain {
    gravity = input;
    body B1 {
        mass = 4.46 kg;
        com = [-0.02, -0.2, 0.26] m;
        output = [0.0, 0.21, 0.0] m turned rpy(-111.2, 44.1, 140.5) deg;
        inertia = tensor(0.740351, 0.622092, 0.555978, -0.032961, 0.109358, 0.321264) kg*m^2 about input;
    }
    body B2 {
        mass = 4.49 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.85, 0.0, 0.0] m turned rpy(-127.1, 60.7, 35.1) deg;
        inertia = tensor(0.245331, 0.359042, 0.175413, 0.01524, 0.11245, -0.019726) kg*m^2 about input;
    }
    body B3 {
        mass = 2.39 kg;
        com = [0.36, 0.0, 0.0] m;
        output = [-0.42, -0.43, -0.67] m turned rpy(90.0, -90.0, 180.0) deg;
        inertia = diag(0.155059, 0.302923, 0.227566) kg*m^2 about com;
    }
    body B4 {
        mass = 2.04 kg;
        com = [0.0, 0.0, 0.43] m;
        output = [-1.02, -0.4, 0.5] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = diag(0.447924, 0.426153, 0.042889) kg*m^2 about input;
    }
    body B5 {
        mass = 4.37 kg;
        com = [0.43, 0.1, -0.56] m;
        output = [-1.19, -0.32, 0.72] m;
        inertia = tensor(0.338004, 0.434002, 0.327277, 0.08514, 0.038858, -0.004611) kg*m^2 about com;
        point f1 = [0.0, 0.0, 1.03] m turned rpy(0.0, 0.0, 90.0) deg;
    }
    body B6 {
        mass = 4.89 kg;
        com = [-0.06, -0.19, 0.12] m;
        output = [0.0, 0.12, 0.0] m;
        inertia = tensor(0.69368, 0.637693, 0.815236, -0.055746, 0.035208, 0.111492) kg*m^2 about input;
    }
    body B7 {
        mass = 2.08 kg;
        com = [0.56, 0.39, -0.39] m;
        output = [1.06, -0.99, 0.66] m;
        inertia = tensor(0.70519, 1.023985, 1.027089, -0.437199, 0.46579, 0.308592) kg*m^2 about input;
    }
    ground -> elastic j1 -> B1 b1 -> screw([0.0, 0.0, -1.0], 0.14 m/rad) j2 -> B2 b2 -> cylindrical([-1.0, 0.0, 0.0]) j3 -> B3 b3 -> elastic j4 -> B4 b4 -> ball j5 -> ground at [-1.84, 0.2, -1.08] m turned rpy(23.1, -51.2, -127.5) deg;
    b4.output -> elastic j6 -> B5 b5;
    b5.f1 -> universal(y, [-0.52, -0.85, -0.93]) j7 -> B6 b6 -> cylindrical([0.0, -1.0, 0.0]) j8 -> B7 b7;
    hinge j1 { rest = [0.05, 0.24, -0.15] m turned rpy(-0.21, -0.23, -0.66) rad; stiffness = [18.75, 32.59, 36.68] N/m; armature = 0.8 kg; motion = input; }
    hinge j3 { turning_damping = 0.66 N*m*s/rad; turning_armature = 0.47 kg*m^2; turning_friction = 0.48 N*m; turning_friction_speed = 0.5 rad/s; motion = input; }
    hinge j4 { stiffness = [23.49, 23.43, 10.99] N/m; damping = [2.45, 1.61, 0.34] N*s/m; }
    hinge j5 { torque = input; }
    hinge j6 { stiffness = 24.37 N/m; armature = 0.4 kg; friction = [1.11, 1.08, 1.51] N; friction_speed = 0.9 m/s; limits = [-1.02, 0.74] m; limit_stiffness = 7.9 N/m; limit_damping = 1.93 N*s/m; }
    hinge j7 { armature = [0.15, 0.26] kg*m^2; torque = [-2.2, 4.3] N*m; }
    hinge j8 { stiffness = 23.56 N/m; armature = 0.11 kg; friction = 1.56 N; friction_speed = 0.3 m/s; limits = [-0.55, 1.15] m; limit_stiffness = 17.6 N/m; limit_damping = 0.35 N*s/m; turning_stiffness = 33.88 N*m/rad; turning_damping = 2.23 N*m*s/rad; turning_armature = 0.7 kg*m^2; motion = input; }
    load l1 { on = b6; force = input; axes = body; }
    spring c1 { on = b2; at = [0.0, 0.0, 0.7] m; to = b6.output; stiffness = 6.4 N/m; damping = 1.16 N*s/m; length = 0.53 m; }
    spring c2 { on = b5; at = [-0.51, -0.63, 0.59] m; to = b3.input; stiffness = 6.4 N/m; }
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
        j3: vector(&drives.efforts, [2, 3, 4]),
        j7: drives.efforts[10],
        l1_torque: drives.loads[0].torque.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5 j6 j7;
    springs s1;
pub chain {
    gravity = input;
    body B1 {
        mass = 4.61 kg;
        com = [0.38, -0.38, -0.27] m;
        output = [0.0, 1.2, 0.0] m turned rpy(-166.1, 59.0, -44.2) deg;
        inertia = tensor(1.203037, 1.283249, 1.483002, 0.665684, 0.472986, -0.472986) kg*m^2 about input;
    }
    body B2 {
        mass = 2.89 kg;
        com = [0.0, 0.0, -0.14] m;
        output = [0.0, -1.07, 0.0] m turned rpy(90.0, -90.0, 180.0) deg;
        inertia = diag(0.081895, 0.124415, 0.194652) kg*m^2 about com;
    }
    body B3 {
        mass = 2.78 kg;
        com = [0.31, 0.0, 0.0] m;
        output = [0.0, 0.0, -1.06] m turned rpy(90.0, 90.0, 90.0) deg;
        inertia = tensor(0.147482, 0.086497, 0.090102, -0.017241, 0.006259, -0.018193) kg*m^2 about com;
        point p1 = [0.91, -0.6, -0.18] m;
    }
    body B4 {
        mass = 0.36 kg;
        com = [0.27, 0.0, 0.0] m;
        output = [0.0, 0.51, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.014501, 0.037988, 0.035313, 8.7e-5, 0.00018, -0.004039) kg*m^2 about input;
    }
    body B5 {
        mass = 3.77 kg;
        com = [0.36, 0.0, 0.0] m;
        output = [0.15, -0.56, 0.62] m turned rpy(-179.1, -169.6, -51.3) deg;
        inertia = tensor(0.232581, 0.764371, 0.795612, -0.033953, -0.030659, 0.061393) kg*m^2 about input;
    }
    body B6 {
        mass = 3.47 kg;
        com = [-0.42, 0.26, -0.03] m;
        output = [0.59, 0.1, 0.21] m turned rpy(90.0, 0.0, 180.0) deg;
        inertia = tensor(0.204186, 0.199004, 0.229644, 0.049446, -0.027762, -0.013993) kg*m^2 about com;
    }
    ground -> pin([0.0, 0.0, -1.0]) j1 -> B1 b1 -> pin([-1.18, -1.23, 0.0]) j2 -> B2 b2 -> floating j3 -> B3 b3 -> screw(z, 0.08 m/rad) j4 -> B4 b4 -> pin([1.18, -1.06, 1.05]) j5 -> moving tip;
    ground at [0.29, 0.06, 1.65] m -> weld j6 -> B5 b5 -> pin(x) j7 -> B6 b6;
    hinge j1 { damping = 1.14 N*m*s/rad; friction = 0.81 N*m; friction_speed = 0.9 rad/s; }
    hinge j2 { stiffness = 14.04 N*m/rad; }
    hinge j3 { force = input; torque = [-3.3, 1.5, 1.3] N*m; }
    hinge j5 { rest = 0.05 rad; stiffness = 35.5 N*m/rad; damping = 0.9 N*m*s/rad; armature = 0.66 kg*m^2; friction = 0.29 N*m; friction_speed = 0.3 rad/s; limits = [-0.57, 0.74] rad; limit_stiffness = 31.7 N*m/rad; limit_damping = 0.98 N*m*s/rad; torque = 1.2 N*m; }
    hinge j7 { torque = input; }
    load l1 { on = b5; force = [-7.5, -4.7, 3.5] N; torque = input; }
    spring s1 { on = b3; at = p1; to = [-1.2, 0.4, -1.3] m; stiffness = 11.1 N/m; damping = 1.82 N*s/m; length = 0.95 m; force = 7.2 N; }
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
        j7: vector(&drives.efforts, [11, 12, 13]),
        c1_force: drives.springs[0],
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5 j6 j7 j8;
    springs c1 s2 s3;
pub chain {
    gravity = input;
    body B1 {
        mass = 0.55 kg;
        com = [0.0, 0.39, 0.26] m;
        output = [-0.67, -0.79, 0.63] m;
        inertia = tensor(0.008811, 0.009538, 0.008002, -0.000764, -0.000481, -0.000748) kg*m^2 about com;
    }
    body B2 {
        mass = 3.36 kg;
        com = [-0.28, -0.27, 0.0] m;
        output = [-0.61, -0.75, -0.86] m;
        inertia = tensor(0.521956, 0.467225, 0.827535, -0.280546, -0.090833, 0.016688) kg*m^2 about input;
    }
    body B3 {
        mass = 3.41 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-1.2, 0.0, 0.0] m;
        inertia = tensor(0.332647, 0.399055, 0.455031, 0.002533, 0.038552, 0.06513) kg*m^2 about com;
    }
    body B4 {
        mass = 2.74 kg;
        com = [0.13, 0.0, 0.0] m;
        output = [0.0, 0.47, 0.0] m turned rpy(-90.0, 180.0, -90.0) deg;
        inertia = diag(0.262888, 0.068724, 0.23243) kg*m^2 about com;
    }
    body B5 {
        mass = 2.97 kg;
        com = [-0.49, -0.5, -0.29] m;
        output = [0.68, -0.07, 1.06] m turned rpy(90.0, 90.0, -90.0) deg;
        inertia = tensor(1.172461, 1.074277, 1.652099, -0.72765, -0.422037, -0.43065) kg*m^2 about input;
    }
    body B6 {
        mass = 1.84 kg;
        com = [0.38, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = tensor(0.119868, 0.373266, 0.422652, -0.058689, 0.016513, 0.013202) kg*m^2 about input;
    }
    body B7 {
        mass = 0.29 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, -0.43, 0.0] m turned rpy(-101.9, -157.5, 174.0) deg;
        inertia = tensor(0.038466, 0.035131, 0.029531, 0.008126, -0.00276, -0.002857) kg*m^2 about com;
    }
    moving base -> floating j1 -> B1 b1 -> slider([0.0, 0.81, 1.03]) j2 -> B2 b2 -> pin([0.0, -1.0, 0.0]) j3 -> moving tip;
    b1.output -> weld j4 -> B3 b3 -> ball j5 -> B4 b4;
    ground at [0.0, 0.0, 0.67] m turned rpy(90.0, 0.0, 0.0) deg -> weld j6 -> B5 b5 -> ball j7 -> B6 b6;
    b6.output -> weld j8 -> B7 b7;
    hinge j1 { turning_friction = 0.28 N*m; turning_friction_speed = 0.8 rad/s; turning_limits = 1.32 rad; turning_limit_stiffness = 40.1 N*m/rad; }
    hinge j2 { rest = -0.08 m; stiffness = 32.65 N/m; damping = 0.59 N*s/m; armature = 0.59 kg; friction = 1.14 N; friction_speed = 0.2 m/s; }
    hinge j3 { rest = -1.22 rad; stiffness = 4.87 N*m/rad; damping = 1.47 N*m*s/rad; armature = 0.76 kg*m^2; torque = 0.9 N*m; }
    hinge j5 { torque = [-0.8, -2.0, -2.6] N*m; }
    hinge j7 { torque = input; }
    spring c1 { on = b5; at = input; to = b6.com; stiffness = 7.6 N/m; force = input; }
    spring s2 { on = b2; at = com; to = [1.4, 1.6, 1.3] m; stiffness = 20.1 N/m; damping = 2.76 N*s/m; length = 1.12 m; }
    spring s3 { on = b4; at = input; to = [-1.7, 0.5, -1.1] m; stiffness = 36.2 N/m; damping = 2.23 N*s/m; force = 1.0 N; }
}
}

printed! {
    Tree9, Point, energy(state);
    inputs |drives| {
        l1_force: drives.loads[0].force.into(),
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3 j4 j5;
    springs;
pub chain {
    gravity = input;
    body B1 {
        mass = 1.46 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.67, 0.69, 0.22] m;
        inertia = tensor(0.108758, 0.118983, 0.142068, 0.004146, 0.003541, -0.040597) kg*m^2 about com;
    }
    body B2 {
        mass = 4.81 kg;
        com = [0.24, -0.23, -0.6] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = tensor(2.211674, 2.345616, 0.692703, 0.243104, 0.553335, -0.667241) kg*m^2 about input;
        point f1 = [0.74, -0.58, -0.32] m turned rpy(-175.9, 0.5, -166.9) deg;
    }
    body B3 {
        mass = 4.62 kg;
        com = [0.0, 0.24, 0.0] m;
        output = [0.0, 0.55, 0.0] m turned rpy(-36.1, 145.7, -32.4) deg;
        inertia = diag(0.367623, 0.197763, 0.487191) kg*m^2 about input;
    }
    body B4 {
        mass = 1.82 kg;
        com = [0.2, 0.06, 0.18] m;
        output = [0.0, 0.8, 0.0] m;
        inertia = tensor(0.077369, 0.097443, 0.053482, -0.021723, -0.005845, 0.004355) kg*m^2 about com;
    }
    body B5 {
        mass = 2.02 kg;
        com = [0.0, 0.4, 0.0] m;
        output = [-0.18, -1.13, -0.67] m turned rpy(35.0, -152.0, -65.7) deg;
        inertia = tensor(0.082083, 0.029635, 0.075178, 0.004273, 0.006184, -0.017243) kg*m^2 about com;
        point p1 = [-0.39, 0.0, 0.0] m;
    }
    ground at [0.0, 1.0, 0.0] m turned rpy(0.0, -90.0, 0.0) deg -> floating j1 -> B1 b1 -> cylindrical(x) j2 -> B2 b2;
    b2.f1 -> elastic j3 -> B3 b3 -> weld j4 -> B4 b4;
    ground at [1.05, 0.65, -0.34] m -> elastic j5 -> B5 b5;
    hinge j1 { damping = [0.26, 0.37, 0.51] N*s/m; armature = [0.35, 0.35, 0.62] kg; friction = 1.33 N; friction_speed = 0.8 m/s; limits = [-0.29, 0.73] m; limit_stiffness = 46.2 N/m; limit_damping = 1.43 N*s/m; }
    hinge j2 { rest = 0.05 m turned -0.04 rad; turning_stiffness = 10.26 N*m/rad; turning_damping = 2.0 N*m*s/rad; }
    hinge j3 { turning_stiffness = 33.83 N*m/rad; turning_armature = 0.56 kg*m^2; turning_friction = 0.63 N*m; turning_friction_speed = 0.7 rad/s; }
    hinge j5 { rest = [0.12, 0.21, 0.02] m turned rpy(-0.09, 0.04, 0.9) rad; stiffness = 5.23 N/m; damping = [1.45, 1.54, 1.59] N*s/m; turning_stiffness = [17.39, 22.83, 32.21] N*m/rad; turning_damping = 0.18 N*m*s/rad; turning_friction = [1.87, 0.29, 1.68] N*m; turning_friction_speed = 1.0 rad/s; }
    load l1 { on = b5; at = p1; force = input; axes = body; }
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
    Tree12, Point, energy(state);
    inputs |drives| {
        j1: vector(&drives.efforts, [0, 1, 2, 3, 4, 5]),
        j4: vector(&drives.efforts, [7, 8, 9, 10, 11, 12]),
    }
    hinges j1 j2 j3 j4 j5;
    springs c1;
pub chain {
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 3.0 kg;
        com = [0.0, 0.0, -0.11] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.322315, 0.388171, 0.369123, 0.034211, 0.008455, 0.00037) kg*m^2 about input;
    }
    body B2 {
        mass = 0.35 kg;
        com = [0.0, 0.0, 0.17] m;
        output = [0.0, 0.0, 0.0] m turned rpy(90.0, 180.0, 0.0) deg;
        inertia = diag(0.033714, 0.018121, 0.029087) kg*m^2 about com;
    }
    body B3 {
        mass = 1.12 kg;
        com = [0.04, -0.06, 0.54] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = tensor(0.357157, 0.380667, 0.056883, -0.002405, -0.021868, 0.04608) kg*m^2 about input;
    }
    body B4 {
        mass = 2.0 kg;
        com = [-0.24, 0.58, 0.39] m;
        output = [-0.36, 0.0, 0.0] m;
        inertia = tensor(1.008769, 0.444552, 0.799556, 0.280028, 0.183836, -0.441822) kg*m^2 about input;
    }
    ground at [0.39, 0.0, 0.0] m -> elastic j1 -> B1 b1 -> pin([-0.7, 0.94, -0.24]) j2 -> B2 b2 -> weld j3 -> ground at [0.04, -0.4, -0.19] m turned rpy(28.1, 12.8, -105.4) deg;
    b2.output -> elastic j4 -> B3 b3;
    ground at [0.0, 1.04, 0.0] m turned rpy(137.6, 166.8, -7.6) deg -> floating j5 -> B4 b4;
    hinge j1 { rest = [0.2, -0.17, -0.16] m turned rpy(0.15, 0.28, -1.48) rad; stiffness = 5.53 N/m; damping = [1.95, 2.24, 2.43] N*s/m; force = input; turning_stiffness = 4.04 N*m/rad; turning_friction = 0.22 N*m; turning_friction_speed = 0.2 rad/s; turning_limits = [-1.05, 0.25] rad; turning_limit_stiffness = 25.0 N*m/rad; turning_limit_damping = 1.19 N*m*s/rad; torque = input; }
    hinge j2 { limits = [-0.74, 1.18] rad; limit_stiffness = 42.9 N*m/rad; }
    hinge j4 { force = input; turning_stiffness = [27.11, 4.24, 8.16] N*m/rad; turning_armature = [0.41, 0.4, 0.22] kg*m^2; torque = input; }
    hinge j5 { rest = [0.48, 0.21, -0.16] m turned quaternion(-0.03, -0.32, -0.05, 0.38); force = [3.3, 5.0, 1.3] N; turning_stiffness = 35.15 N*m/rad; turning_damping = 0.81 N*m*s/rad; turning_armature = 0.11 kg*m^2; turning_limits = 0.73 rad; turning_limit_stiffness = 17.3 N*m/rad; turning_limit_damping = 0.7 N*m*s/rad; torque = [-2.7, -3.5, -3.5] N*m; }
    load l1 { on = b4; at = input; torque = [2.8, -6.6, -3.4] N*m; }
    spring c1 { on = b3; at = [0.0, 0.0, 0.0] m; to = b2.output; stiffness = 37.1 N/m; force = -7.5 N; }
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
    Tree20, Point, energy(state);
    inputs |drives| {
        i2_j2: drives.efforts[3],
        i2_j3: vector(&drives.efforts, [5, 6, 7, 8, 9, 10]),
        i3_j2: drives.efforts[16],
        i3_j3: vector(&drives.efforts, [17, 18, 19, 20, 21, 22]),
        i4_j2: drives.efforts[28],
        i5_limb0_j2: drives.efforts[32],
        i4_j3: vector(&drives.efforts, [45, 46, 47, 48, 49, 50]),
        i5_limb0_j3: vector(&drives.efforts, [53, 54, 55, 56, 57, 58]),
        i5_l1_force: drives.loads[1].force.into(),
        c4_force: drives.springs[3],
        c7_force: drives.springs[6],
    }
    hinges i2_j1 i2_j2 j6 i2_j3 i2_j4 i3_j1 i3_j2 i3_j3 i3_j4 i4_j1 i4_j2 i5_limb0_j1 i5_limb0_j2 i5_j5 j7 i4_j3 i4_j4 i5_limb0_j3 i5_limb0_j4;
    springs s1 s2 c3 c4 c5 c6 c7;
pub chain {
    gravity = [0.0, -9.8, 0.0] m/s^2;
    part Limb0(size) {
    body B1 {
        mass = size*4.43 kg;
        com = [0.0, -0.18, 0.0] m;
        output = [0.0, 0.0, 0.98] m turned rpy(-128.5, 173.8, 137.3) deg;
        inertia = diag(size*0.287713, size*0.489085, size*0.327309) kg*m^2 about com;
        point f1 = [-0.18, 0.0, 0.0] m turned rpy(124.0, 53.0, -145.6) deg;
    }
    body B2 {
        mass = size*3.4 kg;
        com = [0.0, 0.0, 0.41] m;
        output = [0.99, 1.03, 1.04] m turned rpy(143.3, 105.1, -101.7) deg;
        inertia = tensor(size*0.748151, size*0.745286, size*0.098713, size*-0.000482, size*-0.009302, size*-0.024155) kg*m^2 about input;
    }
    body B3 {
        mass = size*2.75 kg;
        com = [0.0, 0.36, 0.39] m;
        output = [0.0, 0.74, 0.0] m;
        inertia = tensor(size*0.805455, size*0.50705, size*0.454152, size*0.0, size*0.0, size*-0.3861) kg*m^2 about input;
    }
    ball j1 -> B1 b1 -> screw([-0.37, -0.26, -0.45], 0.27 m/rad) j2;
    b1.f1 -> elastic j3 -> B2 b2 -> universal(z, [0.2, -1.4, -0.57]) j4 -> B3 b3;
    hinge j1 { limits = 0.72 rad; limit_stiffness = 47.3 N*m/rad; }
    hinge j2 { rest = -0.3 rad; stiffness = 14.34 N*m/rad; damping = 0.24 N*m*s/rad; friction = 0.69 N*m; friction_speed = 0.9 rad/s; torque = input; }
    hinge j3 { damping = 0.62 N*s/m; limits = [-0.17, 0.45] m; limit_stiffness = 59.4 N/m; limit_damping = 0.34 N*s/m; force = input; torque = input; }
    hinge j4 { torque = [-0.6, 0.1] N*m; }
    }
    part Limb1(side, size) {
    body B4 {
        mass = size*3.67 kg;
        com = [-0.08, side*0.55, 0.46] m;
        output = [0.0, side*-0.52, 0.0] m turned rpy(-175.1, -112.9, 24.3) deg;
        inertia = diag(size*0.302644, size*0.330123, size*0.043803) kg*m^2 about com;
    }
    body B5 {
        mass = size*0.79 kg;
        com = [0.25, side*0.0, 0.0] m;
        output = [-0.87, side*0.43, 1.12] m;
        inertia = diag(size*0.010057, size*0.041258, size*0.042843) kg*m^2 about com;
    }
    Limb0(0.5) -> B4 b4 -> elastic j5 -> B5 b5;
    hinge j5 { rest = [-0.25, 0.25, 0.08] m turned rpy(0.29, -0.05, -1.01) rad; turning_stiffness = [33.74, 38.22, 22.46] N*m/rad; turning_limits = [-1.04, 0.33] rad; turning_limit_stiffness = 39.4 N*m/rad; }
    load l1 { on = b5; force = input; }
    }
    body B6 {
        mass = 0.32 kg;
        com = [0.11, 0.0, 0.0] m;
        output = [0.0, 0.21, 0.0] m turned rpy(0.0, 180.0, -90.0) deg;
        inertia = diag(0.022246, 0.035218, 0.015755) kg*m^2 about com;
    }
    body B7 {
        mass = 3.56 kg;
        com = [0.44, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.74] m turned rpy(173.2, 8.4, 40.2) deg;
        inertia = diag(0.350926, 0.204393, 0.259219) kg*m^2 about com;
        point p1 = [-0.56, -0.27, 0.01] m;
    }
    body B8 {
        mass = 0.63 kg;
        com = [0.0, 0.0, 0.53] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.018231, 0.011857, 0.021408, 0.008176, 0.002932, -0.006542) kg*m^2 about com;
    }
    body B9 {
        mass = 1.24 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, -0.31, 0.0] m turned rpy(90.0, -90.0, 180.0) deg;
        inertia = diag(0.074415, 0.081542, 0.147644) kg*m^2 about input;
    }
    body B10 {
        mass = 0.33 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(180.0, 0.0, 180.0) deg;
        inertia = tensor(0.021829, 0.020345, 0.022849, 0.003369, -0.00421, -0.00275) kg*m^2 about input;
    }
    B6 b6 -> Limb0(2.0) i2 -> B7 b7 -> pin([-0.63, 0.72, -0.93]) j6 -> ground;
    i2.b1.output -> Limb0(0.5) i3 -> B8 b8;
    b6.output -> Limb0(1.0) i4 -> B9 b9 -> Limb1(-1.0, 0.5) i5 -> elastic j7 -> B10 b10;
    load l1 { on = b7; at = [0.0, -0.47, 0.0] m; force = [-0.2, 6.0, -1.1] N; }
    spring s1 { on = b7; at = p1; to = [-0.2, 0.4, -0.1] m; stiffness = 16.7 N/m; length = 0.5 m; force = -5.1 N; }
    spring s2 { on = b9; at = input; to = [-1.2, -0.9, 0.9] m; stiffness = 23.2 N/m; force = 6.0 N; }
    spring c3 { on = i2.b1; at = com; to = i5.limb0.b3.input; stiffness = 23.1 N/m; }
    spring c4 { on = b7; at = [0.0, 0.0, 0.0] m; to = b9.input; stiffness = 32.7 N/m; damping = 2.79 N*s/m; force = input; }
    spring c5 { on = i3.b2; at = [0.87, -0.64, -0.02] m; to = i4.b1.output; stiffness = 26.4 N/m; length = 1.12 m; }
    spring c6 { on = i4.b1; at = [-0.35, -0.78, -0.85] m; to = i3.b1.input; stiffness = 13.7 N/m; }
    spring c7 { on = i5.limb0.b2; at = output; to = i5.b4.input; stiffness = 25.8 N/m; length = 1.06 m; force = input; }
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
        j7: cylindrical(&drives.motions[0]),
        j8: elastic(&drives.motions[1]),
        i3_i1_j4: universal(&drives.motions[2]),
        i3_i2_j2: cylindrical(&drives.motions[3]),
        i4_j2: cylindrical(&drives.motions[4]),
        i5_j2: cylindrical(&drives.motions[5]),
        i6_i1_j4: universal(&drives.motions[6]),
        i6_i2_j2: cylindrical(&drives.motions[7]),
        i7_j2: cylindrical(&drives.motions[8]),
        i3_i1_j5: vector(&drives.efforts, [4, 5, 6]),
        i3_j6: vector(&drives.efforts, [13, 14]),
        i6_i1_j5: vector(&drives.efforts, [36, 37, 38]),
        i6_j6: vector(&drives.efforts, [45, 46]),
        j12: drives.efforts[53],
        l1_force: drives.loads[0].force.into(),
        i3_i1_l1_force: drives.loads[1].force.into(),
        i3_i1_l2_force: drives.loads[2].force.into(),
        i3_i1_l3_force: drives.loads[3].force.into(),
        i6_i1_l1_force: drives.loads[7].force.into(),
        i6_i1_l2_force: drives.loads[8].force.into(),
        i6_i1_l3_force: drives.loads[9].force.into(),
        s1_force: drives.springs[0],
        c4_force: drives.springs[3],
        c6_force: drives.springs[5],
        i3_i1_s2_force: drives.springs[7],
        i6_i1_s2_force: drives.springs[9],
    }
    hinges j7 j8 i3_i2_j1 i4_j1 i3_i1_j4 i3_i1_j5 i3_i2_j2 i3_i2_j3 i3_j6 i4_j2 i4_j3 i5_j1 j9 j10 i5_j2 i5_j3 j11 i6_i2_j1 i7_j1 i6_i1_j4 i6_i1_j5 i6_i2_j2 i6_i2_j3 i6_j6 i7_j2 i7_j3 j12;
    springs s1 c2 c3 c4 c5 c6 i3_i1_s1 i3_i1_s2 i6_i1_s1 i6_i1_s2;
pub chain {
    gravity = [4.51, -3.72, 4.1] m/s^2;
    part Limb0(side) {
    body B1 {
        mass = 1.13 kg;
        com = [0.0, side*0.0, 0.54] m;
        output = [0.0, side*0.0, 0.0] m turned rpy(-90.0, 0.0, 0.0) deg;
        inertia = tensor(0.354533, 0.36684, 0.035423, side*-0.000795, 0.009987, side*0.005237) kg*m^2 about input;
    }
    body B2 {
        mass = 3.37 kg;
        com = [0.0, side*0.0, 0.16] m;
        output = [0.0, side*0.0, -0.92] m turned rpy(89.0, -143.5, 83.8) deg;
        inertia = diag(0.091544, 0.068956, 0.047954) kg*m^2 about com;
        point f3 = [1.04, side*-0.45, 0.58] m;
    }
    body B3 {
        mass = 3.07 kg;
        com = [0.0, side*0.59, 0.0] m;
        output = [0.0, side*0.0, 0.0] m;
        inertia = tensor(1.38326, 0.20625, 1.229252, side*0.027884, 0.021533, side*-0.074599) kg*m^2 about input;
    }
    universal([-0.58, -0.58, -1.26], [-0.31, 1.47, 0.44]) j1 -> B1 b1;
    b1.output -> cylindrical([0.0, 0.0, -1.0]) j2 -> B2 b2 -> elastic j3 -> B3 b3;
    hinge j2 { damping = 2.43 N*s/m; armature = 0.69 kg; friction = 0.3 N; friction_speed = 0.6 m/s; limits = [-0.89, 1.14] m; limit_stiffness = 51.1 N/m; motion = input; }
    hinge j3 { rest = [-0.05, 0.17, 0.05] m turned rpy(0.01, 0.14, -1.25) rad; stiffness = [17.32, 34.9, 33.2] N/m; armature = [0.63, 0.09, 0.29] kg; force = [0.4, 4.2, 4.9] N; turning_stiffness = [17.66, 9.85, 24.39] N*m/rad; turning_damping = [1.33, 2.51, 1.04] N*m*s/rad; turning_friction = 0.99 N*m; turning_friction_speed = 0.2 rad/s; turning_limits = [-0.86, 0.12] rad; turning_limit_stiffness = 15.5 N*m/rad; turning_limit_damping = 1.69 N*m*s/rad; torque = [1.4, -0.5, 0.8] N*m; }
    load l1 { on = b2; at = input; force = [-6.9, 6.0, -3.4] N; }
    }
    part Limb1(size) {
    body B4 {
        mass = size*1.71 kg;
        com = [0.13, 0.53, 0.02] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-35.9, 129.5, -24.1) deg;
        inertia = tensor(size*0.50393, size*0.056681, size*0.537341, size*-0.117819, size*-0.004446, size*-0.018126) kg*m^2 about input;
        point f2 = [0.76, 1.17, 0.59] m turned rpy(180.0, -90.0, 180.0) deg;
    }
    body B5 {
        mass = size*3.26 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.5, -0.19, -0.14] m turned rpy(0.0, 0.0, -90.0) deg;
        inertia = tensor(size*0.028685, size*0.064576, size*0.056519, size*0.015263, size*0.008141, size*-0.001305) kg*m^2 about input;
        point f6 = [0.0, 0.0, 0.0] m turned rpy(83.0, -33.8, -56.4) deg;
        point p1 = [0.93, 0.0, 0.0] m;
    }
    body B6 {
        mass = size*3.12 kg;
        com = [0.11, 0.26, 0.14] m;
        output = [0.47, -0.96, -0.05] m turned rpy(41.6, 10.0, 119.6) deg;
        inertia = tensor(size*0.227484, size*0.120798, size*0.139159, size*0.022984, size*-0.000344, size*0.061209) kg*m^2 about com;
    }
    B4 b4;
    b4.f2 -> universal([0.0, 0.0, -1.0], [0.88, 0.3, 0.13]) j4 -> B5 b5 -> planar(x) j5 -> B6 b6;
    hinge j4 { damping = 0.57 N*m*s/rad; armature = [0.17, 0.29] kg*m^2; limits = [-0.9, 1.04] rad; limit_stiffness = 23.2 N*m/rad; motion = input; }
    hinge j5 { force = input; turning_stiffness = 34.8 N*m/rad; turning_damping = 1.73 N*m*s/rad; turning_limits = [-0.67, 0.36] rad; turning_limit_stiffness = 56.0 N*m/rad; turning_limit_damping = 0.9 N*m*s/rad; torque = input; }
    load l1 { on = b4; force = input; axes = body; }
    load l2 { on = b5; at = output; force = input; axes = body; }
    load l3 { on = b6; force = input; axes = body; }
    spring s1 { on = b5; at = p1; to = [-1.6, -0.6, 0.6] m; stiffness = 31.9 N/m; damping = 1.24 N*s/m; length = 0.38 m; }
    spring s2 { on = b6; at = [0.0, 0.0, 0.0] m; to = [0.7, -0.6, 1.5] m; stiffness = 10.2 N/m; force = input; }
    }
    part Limb2(side, size) {
    body B7 {
        mass = size*3.61 kg;
        com = [-0.51, side*0.57, 0.4] m;
        output = [0.96, side*0.86, -0.43] m;
        inertia = tensor(size*1.857064, size*1.716477, size*2.277173, size*side*1.049427, size*0.73644, size*side*-0.82308) kg*m^2 about input;
    }
    Limb1(1.0) i1 -> Limb0(-1.0) i2;
    i2.b2.f3 -> cylindrical([-1.32, -0.4, -1.11]) j6 -> B7 b7;
    hinge j6 { force = input; torque = input; }
    }
    body B8 {
        mass = 4.24 kg;
        com = [0.31, 0.19, 0.2] m;
        output = [-0.09, 0.5, -1.12] m turned rpy(15.1, 48.7, -60.5) deg;
        inertia = tensor(0.592167, 0.837699, 0.978508, -0.248326, -0.305334, -0.173151) kg*m^2 about input;
    }
    body B9 {
        mass = 4.55 kg;
        com = [0.0, 0.0, 0.34] m;
        output = [-0.26, 0.01, 0.06] m;
        inertia = tensor(0.250727, 0.295435, 0.240763, 0.050311, -0.052334, 0.008534) kg*m^2 about com;
        point p1 = [0.09, -0.16, -0.67] m;
    }
    body B10 {
        mass = 3.85 kg;
        com = [0.51, 0.43, -0.11] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.152952, 0.110615, 0.067266, 0.015282, -0.010943, -0.024059) kg*m^2 about com;
    }
    body B11 {
        mass = 2.25 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.5, -1.15, -0.23] m turned rpy(0.0, 180.0, 0.0) deg;
        inertia = tensor(0.329382, 0.304654, 0.289957, 0.012905, -0.018905, 0.006077) kg*m^2 about com;
    }
    moving base -> cylindrical([-0.67, -1.33, 1.22]) j7 -> B8 b8 -> elastic j8 -> Limb2(1.0, 0.5) i3 -> Limb0(1.0) i4;
    i4.b3.output -> Limb0(1.0) i5 -> screw([0.0, -1.0, 0.0], 0.19 m/rad) j9 -> B9 b9 -> screw([0.89, 1.08, 1.08], -0.34 m/rad) j10 -> B10 b10;
    i3.i2.b2.output -> screw(z, 0.26 m/rad) j11 -> Limb2(1.0, 0.5) i6 -> Limb0(1.0) i7;
    i3.i1.b5.f6 -> cylindrical([-0.37, -0.85, -0.48]) j12 -> B11 b11;
    hinge j7 { turning_stiffness = 24.4 N*m/rad; turning_damping = 2.11 N*m*s/rad; turning_armature = 0.22 kg*m^2; turning_friction = 1.34 N*m; turning_friction_speed = 0.5 rad/s; turning_limits = [-0.23, 0.5] rad; turning_limit_stiffness = 12.7 N*m/rad; turning_limit_damping = 0.87 N*m*s/rad; motion = input; }
    hinge j8 { motion = input; }
    hinge j9 { rest = -0.17 rad; stiffness = 36.08 N*m/rad; damping = 2.23 N*m*s/rad; }
    hinge j10 { rest = -1.15 rad; stiffness = 38.73 N*m/rad; damping = 2.54 N*m*s/rad; armature = 0.53 kg*m^2; }
    hinge j11 { torque = -4.4 N*m; }
    hinge j12 { rest = -0.36 m turned -1.23 rad; stiffness = 37.42 N/m; friction = 1.95 N; friction_speed = 0.5 m/s; force = input; turning_damping = 0.53 N*m*s/rad; turning_friction = 0.35 N*m; turning_friction_speed = 0.3 rad/s; turning_limits = [-0.19, 0.38] rad; turning_limit_stiffness = 20.5 N*m/rad; torque = 4.0 N*m; }
    load l1 { on = b9; at = p1; force = input; axes = body; }
    spring s1 { on = b11; at = [0.34, 0.0, 0.0] m; to = [-1.6, -1.7, 1.6] m; stiffness = 1.2 N/m; damping = 0.11 N*s/m; force = input; }
    spring c2 { on = b8; at = input; to = b11.input; stiffness = 23.9 N/m; }
    spring c3 { on = i3.i2.b1; at = [0.0, 0.0, 0.0] m; to = i6.i1.b5.output; stiffness = 13.2 N/m; damping = 2.2 N*s/m; length = 0.73 m; }
    spring c4 { on = i3.i2.b2; at = [0.24, 0.0, 0.0] m; to = i3.i1.b6.output; stiffness = 16.3 N/m; length = 0.26 m; force = input; }
    spring c5 { on = i5.b1; at = [0.07, 0.9, 0.63] m; to = i5.b3.input; stiffness = 26.8 N/m; length = 0.27 m; }
    spring c6 { on = b11; at = [0.0, 0.0, 0.0] m; to = i6.b7.output; stiffness = 28.6 N/m; length = 1.1 m; force = input; }
}
}

printed! {
    Tree23, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j6: slider(&drives.motions[0]),
        i4_i1_j3: vector(&drives.efforts, [9, 10, 11]),
        j5: vector(&drives.efforts, [12, 13, 14, 15, 16, 17]),
        i3_j2: vector(&drives.efforts, [18, 19, 20]),
        i4_i2_j2: vector(&drives.efforts, [33, 34, 35]),
        j7: vector(&drives.efforts, [36, 37]),
        j8: vector(&drives.efforts, [38, 39, 40, 41, 42, 43]),
        i4_l1_force: drives.loads[2].force.into(),
        c2_force: drives.springs[1],
        i3_s1_force: drives.springs[3],
        i3_s2_force: drives.springs[4],
        i4_i2_s1_force: drives.springs[5],
        i4_i2_s2_force: drives.springs[6],
        gravity: drives.gravity.into(),
    }
    hinges i3_j1 i4_i1_j3 j5 j6 i3_j2 i4_i2_j1 i4_j4 i4_i2_j2 j7 j8;
    springs s1 c2 c3 i3_s1 i3_s2 i4_i2_s1 i4_i2_s2;
pub chain {
    gravity = input;
    part Limb0(side, size) {
    body B1 {
        mass = size*0.77 kg;
        com = [0.0, side*0.0, 0.21] m;
        output = [0.0, side*-0.46, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = diag(size*0.033213, size*0.018107, size*0.049442) kg*m^2 about com;
    }
    body B2 {
        mass = size*1.61 kg;
        com = [-0.04, side*-0.15, 0.05] m;
        output = [0.0, side*-0.42, 0.0] m turned rpy(180.0, 0.0, 180.0) deg;
        inertia = tensor(size*0.091367, size*0.051253, size*0.094994, size*side*-0.01609, size*0.000457, size*side*0.00979) kg*m^2 about input;
        point f3 = [0.0, side*0.0, 0.0] m turned rpy(0.0, 0.0, 180.0) deg;
        point p1 = [0.0, 0.0, 0.0] m;
    }
    floating j1 -> B1 b1;
    b1.input -> planar(x) j2 -> B2 b2;
    hinge j2 { limits = [-0.11, 1.1] m; limit_stiffness = 9.3 N/m; force = input; turning_damping = 1.23 N*m*s/rad; turning_armature = 0.17 kg*m^2; turning_limits = [-0.27, 0.1] rad; turning_limit_stiffness = 10.1 N*m/rad; torque = input; }
    spring s1 { on = b1; at = input; to = [1.7, 0.2, -1.6] m; stiffness = 33.8 N/m; damping = 2.05 N*s/m; force = input; }
    spring s2 { on = b2; at = p1; to = [-1.8, 1.0, -1.2] m; stiffness = 14.9 N/m; force = input; }
    }
    part Limb1 {
    floating j3;
    hinge j3 { force = [1.1, 2.7, 1.6] N; turning_friction = 0.9 N*m; turning_friction_speed = 0.7 rad/s; turning_limits = 1.63 rad; turning_limit_stiffness = 5.8 N*m/rad; torque = input; }
    }
    part Limb2(size) {
    body B3 {
        mass = size*3.91 kg;
        com = [0.0, 0.0, 0.17] m;
        output = [0.0, 0.38, 0.0] m turned rpy(-29.6, 23.6, 168.9) deg;
        inertia = tensor(size*0.245842, size*0.156208, size*0.214308, size*0.017325, size*-0.001057, size*0.084105) kg*m^2 about com;
    }
    body B4 {
        mass = size*1.1 kg;
        com = [-0.34, 0.0, 0.0] m;
        output = [0.0, 0.18, 0.0] m;
        inertia = diag(size*0.052176, size*0.060025, size*0.069318) kg*m^2 about com;
        point p1 = [0.0, 0.59, 0.0] m;
    }
    Limb1 i1 -> B3 b3;
    b3.output -> Limb0(1.0, 2.0) i2 -> floating j4 -> B4 b4;
    hinge j4 { rest = [-0.43, -0.35, 0.17] m turned quaternion(-0.44, -0.23, -0.06, 0.02); stiffness = 13.57 N/m; damping = [2.36, 1.44, 2.2] N*s/m; friction = 0.53 N; friction_speed = 0.5 m/s; limits = [-0.58, 0.89] m; limit_stiffness = 47.9 N/m; turning_stiffness = 23.92 N*m/rad; turning_damping = 1.61 N*m*s/rad; turning_limits = 2.18 rad; turning_limit_stiffness = 18.3 N*m/rad; turning_limit_damping = 1.67 N*m*s/rad; }
    load l1 { on = b4; at = p1; force = input; axes = body; }
    }
    body B5 {
        mass = 3.85 kg;
        com = [-0.38, 0.16, 0.13] m;
        output = [-0.44, 1.11, 0.73] m;
        inertia = tensor(0.351227, 0.822577, 0.924115, 0.23408, 0.19019, -0.08008) kg*m^2 about input;
    }
    body B6 {
        mass = 2.15 kg;
        com = [-0.31, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(180.0, 0.0, 90.0) deg;
        inertia = diag(0.214797, 0.363791, 0.276176) kg*m^2 about input;
    }
    body B7 {
        mass = 0.33 kg;
        com = [-0.58, 0.0, 0.0] m;
        output = [0.55, 0.0, 0.0] m;
        inertia = diag(0.017131, 0.126102, 0.117831) kg*m^2 about input;
    }
    body B8 {
        mass = 4.28 kg;
        com = [0.02, 0.48, -0.23] m;
        output = [-0.91, 0.33, 0.04] m turned rpy(0.0, 0.0, -90.0) deg;
        inertia = tensor(1.386882, 0.267145, 1.157845, -0.041088, 0.019688, 0.472512) kg*m^2 about input;
    }
    B5 b5 -> Limb0(1.0, 2.0) i3 -> Limb2(2.0) i4 -> elastic j5 -> B6 b6 -> slider([-1.25, -1.3, -0.68]) j6 -> moving tip;
    i4.i2.b2.f3 -> cylindrical(y) j7 -> B7 b7 -> floating j8 -> B8 b8;
    hinge j5 { force = input; torque = input; }
    hinge j6 { stiffness = 1.3 N/m; damping = 1.58 N*s/m; motion = input; }
    hinge j7 { force = input; torque = input; }
    hinge j8 { stiffness = [12.64, 16.2, 8.37] N/m; damping = 0.17 N*s/m; armature = [0.35, 0.26, 0.54] kg; friction = 0.35 N; friction_speed = 0.6 m/s; force = input; torque = input; }
    load l1 { on = b5; at = input; torque = [-2.0, 3.3, -4.8] N*m; }
    load l2 { on = b7; at = output; torque = [4.8, -5.7, -1.5] N*m; axes = body; }
    spring s1 { on = b7; at = [-0.62, -0.98, -0.82] m; to = [-1.2, 0.0, 0.3] m; stiffness = 35.0 N/m; length = 0.88 m; }
    spring c2 { on = i3.b1; at = input; to = i3.b2.output; stiffness = 17.3 N/m; force = input; }
    spring c3 { on = b8; at = [0.04, -0.98, 0.26] m; to = i3.b2.com; stiffness = 6.6 N/m; damping = 1.56 N*s/m; }
}
}

printed! {
    Tree24, Point, energy_with(state, inputs);
    inputs |drives| {
        tip: space_frame(&drives.finish),
        j6: planar(&drives.motions[0]),
        i4_i3_j3: vector(&drives.efforts, [0, 1, 2]),
        i4_i3_i1_j2: drives.efforts[7],
        i5_j2: drives.efforts[12],
        i4_i3_i2_j2: drives.efforts[18],
        i4_i3_s2_force: drives.springs[2],
    }
    hinges i4_i3_j3 i4_i3_i1_j1 i4_i3_i1_j2 i5_j1 i5_j2 j5 i4_i3_i2_j1 i4_i3_i2_j2 i4_i3_j4 j6 j7;
    springs s1 i4_i3_s1 i4_i3_s2;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    part Limb0(size) {
    body B1 {
        mass = size*4.3 kg;
        com = [-0.29, 0.22, -0.56] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-47.2, 156.3, 89.9) deg;
        inertia = tensor(size*1.620904, size*1.813388, size*0.660498, size*0.27434, size*-0.69832, size*0.52976) kg*m^2 about input;
    }
    body B2 {
        mass = size*2.52 kg;
        com = [-0.52, -0.3, 0.55] m;
        output = [0.0, 0.0, 0.29] m turned rpy(149.0, 90.1, -35.2) deg;
        inertia = diag(size*0.22474, size*0.244797, size*0.062885) kg*m^2 about com;
    }
    cylindrical([-1.0, 0.0, 0.0]) j1 -> B1 b1 -> planar(x) j2 -> B2 b2;
    hinge j1 { turning_armature = 0.35 kg*m^2; turning_friction = 0.19 N*m; turning_friction_speed = 0.1 rad/s; }
    hinge j2 { force = [4.6, 0.5] N; torque = input; }
    }
    part Limb1(size) {
    body B3 {
        mass = size*4.1 kg;
        com = [0.09, -0.37, 0.25] m;
        output = [-1.02, -0.36, 0.01] m turned rpy(180.0, 90.0, 180.0) deg;
        inertia = diag(size*0.082037, size*0.114433, size*0.110752) kg*m^2 about com;
    }
    body B4 {
        mass = size*0.49 kg;
        com = [-0.46, 0.0, 0.0] m;
        output = [0.0, 0.0, -0.64] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = diag(size*0.013044, size*0.0264, size*0.029149) kg*m^2 about com;
    }
    ball j3 -> B3 b3 -> Limb0(0.5) i1;
    b3.output -> Limb0(0.5) i2 -> pin(x) j4 -> B4 b4;
    hinge j3 { limits = 2.15 rad; limit_stiffness = 20.8 N*m/rad; limit_damping = 0.34 N*m*s/rad; torque = input; }
    hinge j4 { stiffness = 33.59 N*m/rad; armature = 0.39 kg*m^2; friction = 1.37 N*m; friction_speed = 0.6 rad/s; limits = [-0.17, 0.19] rad; limit_stiffness = 56.0 N*m/rad; torque = -1.7 N*m; }
    load l1 { on = b4; at = output; torque = [-7.1, 1.8, -5.9] N*m; axes = body; }
    spring s1 { on = b3; at = output; to = [-1.6, -0.7, 1.5] m; stiffness = 34.0 N/m; damping = 2.74 N*s/m; }
    spring s2 { on = b4; at = input; to = [-0.6, -0.1, 1.4] m; stiffness = 32.2 N/m; damping = 0.46 N*s/m; force = input; }
    }
    part Limb2 {
    Limb1(0.5) i3;
    }
    body B5 {
        mass = 2.44 kg;
        com = [0.0, -0.16, 0.0] m;
        output = [1.12, -0.17, -1.18] m turned rpy(0.0, 180.0, 180.0) deg;
        inertia = tensor(0.244002, 0.202213, 0.243558, 0.011259, -0.077996, -0.035223) kg*m^2 about com;
    }
    body B6 {
        mass = 2.44 kg;
        com = [-0.51, 0.29, 0.52] m;
        output = [0.0, 0.91, 0.0] m turned rpy(180.0, 180.0, 180.0) deg;
        inertia = tensor(0.066157, 0.081224, 0.127524, -0.031824, -0.000812, 0.016985) kg*m^2 about com;
    }
    ground at [-0.73, 0.0, 0.0] m turned rpy(90.0, 0.0, 0.0) deg -> Limb2 i4 -> Limb0(0.5) i5 -> pin(x) j5 -> moving tip;
    i4.i3.b4.input -> planar(x) j6 -> B5 b5 -> universal([0.0, -1.0, 0.0], [1.41, 0.0, -0.11]) j7 -> B6 b6;
    hinge j5 { torque = 0.4 N*m; }
    hinge j6 { stiffness = 38.48 N/m; damping = [0.26, 2.04] N*s/m; limits = [-0.11, 0.66] m; limit_stiffness = 30.8 N/m; limit_damping = 0.18 N*s/m; turning_damping = 0.75 N*m*s/rad; turning_friction = 1.17 N*m; turning_friction_speed = 0.6 rad/s; turning_limits = [-0.46, 1.1] rad; turning_limit_stiffness = 56.6 N*m/rad; motion = input; }
    hinge j7 { stiffness = [29.14, 24.24] N*m/rad; armature = 0.07 kg*m^2; }
    load l1 { on = b5; at = output; torque = [2.1, 3.3, 8.0] N*m; }
    spring s1 { on = b5; at = [0.04, -0.62, -0.79] m; to = [0.2, -0.4, 1.9] m; stiffness = 23.4 N/m; length = 0.21 m; }
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
