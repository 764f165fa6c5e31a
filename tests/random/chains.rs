//! Printed from the seeds in `../random.rs`; not to be edited.

use super::face::printed;
use crate::support::motion::*;

printed! {
    Random0R Random0T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: pin(&drives.motions[0]),
    }
    hinges j1 j2;
    springs s1;
pub chain {
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 1.03 kg;
        com = [0.0, 0.58, 0.0] m;
        output = [0.5, 0.04, -0.03] m turned rpy(-90.0, 0.0, 0.0) deg;
        inertia = tensor(0.130135, 0.092857, 0.087087, 0.016164, 0.014644, 0.00964) kg*m^2 about com;
    }
    body B2 {
        mass = 1.69 kg;
        com = [0.12, 0.0, 0.0] m;
        output = [0.0, 0.55, 0.0] m turned rpy(90.0, 0.0, 90.0) deg;
        inertia = tensor(0.198305, 0.212564, 0.211159, -0.017491, 0.013202, 0.002827) kg*m^2 about com;
    }
    ground at [-0.55, 1.78, 1.73] m turned rpy(-90.0, 0.0, 0.0) deg -> pin([0.0, -1.0, 0.0]) j1 -> B1 b1 -> weld j2 -> B2 b2;
    hinge j1 { rest = -1.5 rad; stiffness = 14.24 N*m/rad; damping = 1.76 N*m*s/rad; armature = 0.15 kg*m^2; motion = input; }
    spring s1 { on = b2; at = [0.77, 0.0, 0.0] m; to = [1.8, -1.2, -1.5] m; stiffness = 9.1 N/m; damping = 0.37 N*s/m; length = 1.44 m; }
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
        j1: floating(&drives.motions[0]),
        j2: gimbal(&drives.motions[1]),
        j4: floating(&drives.motions[2]),
        l1_torque: drives.loads[0].torque.into(),
        s1_force: drives.springs[0],
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.04 kg;
        com = [0.32, -0.23, -0.18] m;
        output = [-0.6, 0.55, -0.39] m turned rpy(155.5, -106.8, -108.0) deg;
        inertia = tensor(0.324288, 0.449264, 0.518557, 0.229922, 0.163918, -0.11339) kg*m^2 about input;
    }
    body B2 {
        mass = 1.01 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.15, 1.15, 0.84] m;
        inertia = tensor(0.069971, 0.051885, 0.050937, -0.001603, -0.00821, -0.014285) kg*m^2 about com;
    }
    body B3 {
        mass = 3.53 kg;
        com = [0.29, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.29] m turned rpy(93.5, 156.1, -64.5) deg;
        inertia = diag(0.103495, 0.431168, 0.383178) kg*m^2 about input;
    }
    body B4 {
        mass = 3.35 kg;
        com = [0.0, 0.14, 0.0] m;
        output = [-0.95, 0.0, 0.0] m turned rpy(-104.2, -175.1, 76.5) deg;
        inertia = diag(0.315872, 0.254632, 0.117245) kg*m^2 about input;
    }
    B1 b1 -> floating j1 -> B2 b2 -> gimbal([0.0, 0.0, -1.0], [-0.11, 0.94, -0.91], [-1.0, 0.0, 0.0]) j2 -> B3 b3 -> gimbal([0.0, 0.0, -1.0], [-0.85, 0.0, 0.77], [0.0, -1.0, 0.0]) j3 -> B4 b4 -> floating j4 -> ground;
    hinge j1 { turning_damping = 0.48 N*m*s/rad; turning_armature = 0.72 kg*m^2; turning_friction = 1.47 N*m; turning_friction_speed = 0.2 rad/s; turning_limits = 0.53 rad; turning_limit_stiffness = 15.5 N*m/rad; motion = input; }
    hinge j2 { motion = input; }
    hinge j4 { turning_stiffness = 25.71 N*m/rad; turning_damping = 2.23 N*m*s/rad; turning_armature = 0.34 kg*m^2; motion = input; }
    load l1 { on = b1; at = output; force = [-3.5, -0.7, -1.6] N; torque = input; axes = body; }
    spring s1 { on = b2; at = output; to = [1.5, -1.7, -1.3] m; stiffness = 17.2 N/m; damping = 2.01 N*s/m; length = 1.33 m; force = input; }
}
}

printed! {
    Random3R Random3T, Point, energy(state);
    inputs |drives| {
        j4: vector(&drives.efforts, [11, 12, 13]),
        l1_force: drives.loads[0].force.into(),
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.48 kg;
        com = [0.52, -0.33, 0.38] m;
        output = [0.0, -0.76, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.17104, 0.202401, 0.182795, -0.000959, 0.000929, -0.006618) kg*m^2 about com;
    }
    body B2 {
        mass = 4.08 kg;
        com = [0.09, -0.4, -0.25] m;
        output = [-0.27, 0.49, -0.02] m;
        inertia = diag(0.06765, 0.255369, 0.280709) kg*m^2 about com;
    }
    body B3 {
        mass = 3.81 kg;
        com = [0.3, -0.15, 0.42] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.877427, 1.180073, 0.589522, 0.20678, -0.481345, 0.210217) kg*m^2 about input;
    }
    ground at [0.0, 0.6, 0.0] m turned rpy(180.0, 90.0, -90.0) deg -> gimbal(z, y, [-0.88, 1.32, 1.48]) j1 -> B1 b1 -> universal([-0.71, -1.14, 1.4], [1.1, -0.53, 0.78]) j2 -> B2 b2 -> floating j3 -> B3 b3 -> gimbal(z, y, [0.4, -0.56, 0.56]) j4 -> ground at [-0.31, -0.17, -0.32] m turned rpy(-127.2, -39.2, 17.2) deg;
    hinge j1 { stiffness = [36.21, 30.04, 3.1] N*m/rad; damping = 0.47 N*m*s/rad; armature = [0.41, 0.66, 0.3] kg*m^2; friction = [0.37, 0.35, 1.14] N*m; friction_speed = 0.7 rad/s; }
    hinge j2 { friction = [0.63, 0.66] N*m; friction_speed = 0.1 rad/s; }
    hinge j3 { rest = [0.25, -0.02, -0.18] m turned quaternion(0.11, 0.45, -0.01, 0.19); stiffness = 33.04 N/m; armature = [0.52, 0.22, 0.16] kg; friction = [1.99, 0.98, 0.21] N; friction_speed = 0.3 m/s; limits = [-0.35, 1.13] m; limit_stiffness = 43.9 N/m; limit_damping = 1.83 N*s/m; force = [-0.4, 1.5, 2.3] N; torque = [0.1, 3.7, -0.5] N*m; }
    hinge j4 { stiffness = 11.59 N*m/rad; damping = [1.16, 2.76, 2.85] N*m*s/rad; limits = [-0.29, 0.32] rad; limit_stiffness = 50.4 N*m/rad; limit_damping = 1.02 N*m*s/rad; torque = input; }
    load l1 { on = b1; at = [0.0, 0.0, 0.0] m; force = input; torque = [4.0, -6.6, 4.7] N*m; axes = body; }
    load l2 { on = b2; at = input; torque = [-5.2, -4.6, -4.2] N*m; }
    spring s1 { on = b1; at = input; to = [1.9, 0.2, 1.5] m; stiffness = 13.9 N/m; force = -1.9 N; }
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
        j1: vector(&drives.efforts, [0, 1]),
    }
    hinges j1;
    springs;
pub chain {
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 2.06 kg;
        com = [0.0, 0.15, 0.0] m;
        output = [-0.18, 0.25, -0.12] m;
        inertia = tensor(0.240263, 0.242453, 0.228241, -0.039251, -0.034734, 0.036592) kg*m^2 about com;
    }
    B1 b1 -> universal([0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]) j1 -> moving tip;
    hinge j1 { torque = input; }
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
        j1: screw(&drives.motions[0]),
        j3: vector(&drives.efforts, [4, 5, 6]),
        l1_torque: drives.loads[0].torque.into(),
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.77 kg;
        com = [0.0, 0.34, 0.0] m;
        output = [0.67, 0.94, -0.08] m turned rpy(-90.0, 180.0, -90.0) deg;
        inertia = diag(0.041176, 0.039838, 0.072855) kg*m^2 about com;
    }
    body B2 {
        mass = 1.92 kg;
        com = [0.0, -0.16, 0.0] m;
        output = [0.0, 0.92, 0.0] m turned rpy(-143.8, 123.6, -101.0) deg;
        inertia = tensor(0.026024, 0.025515, 0.022132, 0.000343, -0.000851, 0.001615) kg*m^2 about com;
    }
    body B3 {
        mass = 4.72 kg;
        com = [-0.39, 0.0, 0.0] m;
        output = [-0.81, 0.0, 0.0] m;
        inertia = diag(0.075798, 0.264449, 0.232263) kg*m^2 about com;
    }
    moving base -> screw([-1.0, 0.0, 0.0], 0.2 m/rad) j1 -> B1 b1 -> slider([-1.24, 0.49, 0.44]) j2 -> B2 b2 -> elastic j3 -> B3 b3 -> planar(x) j4 -> ground;
    hinge j1 { stiffness = 18.04 N*m/rad; damping = 2.36 N*m*s/rad; friction = 0.34 N*m; friction_speed = 1.0 rad/s; motion = input; }
    hinge j3 { stiffness = [36.54, 1.48, 10.18] N/m; damping = [2.36, 1.39, 0.16] N*s/m; friction = 1.96 N; friction_speed = 0.2 m/s; force = [3.0, -1.0, -1.6] N; turning_limits = [-0.59, 0.52] rad; turning_limit_stiffness = 41.2 N*m/rad; turning_limit_damping = 1.91 N*m*s/rad; torque = input; }
    hinge j4 { force = [-1.2, -4.0] N; turning_limits = [-1.12, 0.46] rad; turning_limit_stiffness = 20.4 N*m/rad; turning_limit_damping = 0.71 N*m*s/rad; torque = 0.5 N*m; }
    load l1 { on = b3; force = [-6.4, 6.6, 5.6] N; torque = input; }
    spring s1 { on = b1; at = input; to = [-0.5, 1.0, 1.4] m; stiffness = 11.1 N/m; damping = 2.24 N*s/m; force = -2.2 N; }
}
}

printed! {
    Random8R Random8T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        tip: space_frame(&drives.finish),
        j1: drives.efforts[0],
        j2: vector(&drives.efforts, [4, 5, 6]),
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.75 kg;
        com = [0.0, 0.0, 0.44] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-131.7, -53.9, -35.3) deg;
        inertia = tensor(0.062953, 0.041717, 0.038316, -0.000382, -0.005879, 0.001067) kg*m^2 about com;
        point p1 = [0.02, 0.44, 0.15] m;
    }
    body B2 {
        mass = 0.49 kg;
        com = [0.14, -0.59, 0.52] m;
        output = [-0.01, 1.02, 1.06] m turned rpy(180.0, -90.0, 0.0) deg;
        inertia = diag(0.045512, 0.054019, 0.066345) kg*m^2 about com;
    }
    moving base -> slider([0.85, -0.62, 0.6]) j1 -> B1 b1 -> floating j2 -> B2 b2 -> ball j3 -> moving tip;
    hinge j1 { damping = 1.66 N*s/m; friction = 1.87 N; friction_speed = 0.8 m/s; force = input; }
    hinge j2 { rest = [0.22, 0.22, -0.03] m turned quaternion(-0.02, -0.13, -0.45, -0.17); stiffness = 8.05 N/m; damping = 0.61 N*s/m; limits = [-1.17, 1.07] m; limit_stiffness = 45.7 N/m; force = [-1.4, -2.6, 0.2] N; turning_damping = 1.19 N*m*s/rad; torque = input; }
    hinge j3 { rest = quaternion(0.42, 0.13, 0.2, 0.15); stiffness = 24.23 N*m/rad; damping = 0.55 N*m*s/rad; friction = 1.47 N*m; friction_speed = 0.3 rad/s; limits = 1.64 rad; limit_stiffness = 45.3 N*m/rad; limit_damping = 0.83 N*m*s/rad; }
    spring s1 { on = b1; at = p1; to = [0.4, -1.5, 1.7] m; stiffness = 24.5 N/m; force = 7.3 N; }
}
}

printed! {
    Random9R Random9T, Point, energy(state);
    inputs |drives| {
        l1_torque: drives.loads[0].torque.into(),
    }
    hinges j1;
    springs;
pub chain {
    gravity = [4.24, -4.72, 5.03] m/s^2;
    body B1 {
        mass = 1.47 kg;
        com = [0.0, 0.16, 0.0] m;
        output = [0.22, -0.68, 1.17] m;
        inertia = tensor(0.141835, 0.059633, 0.105399, 0.003533, -0.007862, -0.015581) kg*m^2 about com;
    }
    ground -> ball j1 -> B1 b1;
    load l1 { on = b1; torque = input; axes = body; }
}
}

printed! {
    Random10R Random10T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: floating(&drives.motions[0]),
        j3: vector(&drives.efforts, [12, 13]),
        l1_force: drives.loads[0].force.into(),
        l2_force: drives.loads[1].force.into(),
        l3_torque: drives.loads[2].torque.into(),
        s1_force: drives.springs[0],
        gravity: drives.gravity.into(),
    }
    hinges j1 j2 j3;
    springs s1 s2 s3;
pub chain {
    gravity = input;
    body B1 {
        mass = 0.36 kg;
        com = [0.0, -0.52, 0.0] m;
        output = [1.14, -0.5, -0.62] m;
        inertia = diag(0.101873, 0.028786, 0.122736) kg*m^2 about input;
    }
    body B2 {
        mass = 4.63 kg;
        com = [0.17, 0.0, 0.0] m;
        output = [0.69, -0.36, -0.26] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = diag(0.110841, 0.235404, 0.279414) kg*m^2 about com;
    }
    body B3 {
        mass = 0.93 kg;
        com = [0.39, -0.48, -0.51] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-6.8, 66.9, -65.8) deg;
        inertia = diag(0.01448, 0.044807, 0.040542) kg*m^2 about com;
        point p1 = [0.0, 0.66, 0.0] m;
    }
    body B4 {
        mass = 2.91 kg;
        com = [0.0, -0.21, 0.0] m;
        output = [0.0, 0.15, 0.0] m turned rpy(-148.2, -24.7, -6.5) deg;
        inertia = diag(0.135666, 0.147388, 0.26152) kg*m^2 about com;
        point p2 = [0.0, 0.0, 0.0] m;
        point p3 = [0.0, 0.0, 0.73] m;
    }
    B1 b1 -> floating j1 -> B2 b2 -> floating j2 -> B3 b3 -> universal([0.5, 1.04, -1.3], x) j3 -> B4 b4;
    hinge j1 { rest = [-0.15, 0.02, 0.03] m turned quaternion(0.49, 0.09, -0.04, 0.03); limits = [-1.09, 1.2] m; limit_stiffness = 34.1 N/m; turning_stiffness = 38.7 N*m/rad; turning_damping = 1.5 N*m*s/rad; motion = input; }
    hinge j2 { rest = [-0.01, 0.28, -0.16] m turned quaternion(-0.44, 0.02, 0.23, -0.01); stiffness = 6.1 N/m; limits = [-0.76, 0.36] m; limit_stiffness = 43.5 N/m; }
    hinge j3 { limits = [-0.67, 0.63] rad; limit_stiffness = 30.2 N*m/rad; torque = input; }
    load l1 { on = b1; force = input; }
    load l2 { on = b2; at = [0.4, 0.13, 0.18] m; force = input; }
    load l3 { on = b4; at = p2; torque = input; }
    spring s1 { on = b2; at = com; to = [-0.1, 0.4, 1.8] m; stiffness = 5.5 N/m; damping = 2.68 N*s/m; force = input; }
    spring s2 { on = b3; at = p1; to = [-0.7, -1.4, -0.3] m; stiffness = 30.8 N/m; }
    spring s3 { on = b4; at = p3; to = [-0.6, 0.0, 1.4] m; stiffness = 32.7 N/m; length = 0.24 m; }
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
        j1: vector(&drives.efforts, [0, 1]),
    }
    hinges j1 j2 j3;
    springs;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.17 kg;
        com = [0.0, -0.25, 0.0] m;
        output = [0.0, 1.18, 0.0] m turned rpy(-90.0, 180.0, 90.0) deg;
        inertia = tensor(0.096153, 0.091771, 0.075632, -0.001911, -0.002534, -0.016239) kg*m^2 about com;
    }
    body B2 {
        mass = 4.12 kg;
        com = [0.0, 0.14, 0.0] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = diag(0.173996, 0.249429, 0.28311) kg*m^2 about com;
    }
    ground -> planar(z) j1 -> B1 b1 -> floating j2 -> B2 b2 -> ball j3 -> ground at [0.41, -1.77, 0.54] m turned rpy(177.0, -22.4, -50.7) deg;
    hinge j1 { stiffness = [11.61, 7.57] N/m; armature = 0.17 kg; friction = 1.0 N; friction_speed = 0.7 m/s; limits = [-0.18, 1.0] m; limit_stiffness = 23.5 N/m; force = input; turning_damping = 1.02 N*m*s/rad; turning_limits = [-0.12, 0.61] rad; turning_limit_stiffness = 25.7 N*m/rad; torque = -1.3 N*m; }
    hinge j2 { turning_damping = 2.45 N*m*s/rad; turning_armature = 0.35 kg*m^2; turning_friction = 0.39 N*m; turning_friction_speed = 0.2 rad/s; }
}
}

printed! {
    Random13R Random13T, Point, energy_with(state, inputs);
    inputs |drives| {
        base: space_frame(&drives.start),
        j1: pin(&drives.motions[0]),
    }
    hinges j1;
    springs s1;
pub chain {
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.88 kg;
        com = [0.0, 0.0, -0.21] m;
        output = [0.0, -1.16, 0.0] m turned rpy(90.0, 0.0, 0.0) deg;
        inertia = diag(0.174272, 0.219177, 0.082276) kg*m^2 about com;
    }
    moving base -> pin(y) j1 -> B1 b1;
    hinge j1 { stiffness = 14.7 N*m/rad; damping = 0.59 N*m*s/rad; friction = 1.35 N*m; friction_speed = 0.9 rad/s; motion = input; }
    spring s1 { on = b1; at = [0.22, -0.24, 0.22] m; to = [0.9, 1.4, -0.5] m; stiffness = 5.3 N/m; damping = 1.87 N*s/m; length = 0.46 m; }
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
        j2: vector(&drives.efforts, [3, 4]),
        j4: vector(&drives.efforts, [8, 9, 10, 11, 12, 13]),
        l1_force: drives.loads[0].force.into(),
        s1_force: drives.springs[0],
    }
    hinges j1 j2 j3 j4;
    springs s1;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.08 kg;
        com = [-0.33, -0.09, 0.17] m;
        output = [0.15, -0.2, -0.34] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = tensor(0.201407, 0.195046, 0.185962, 0.003233, 0.000927, 0.007153) kg*m^2 about com;
    }
    body B2 {
        mass = 1.96 kg;
        com = [0.45, 0.04, -0.24] m;
        output = [-1.04, 0.0, 0.0] m;
        inertia = tensor(0.062364, 0.040723, 0.03609, 0.007174, 0.000837, 0.020142) kg*m^2 about com;
    }
    body B3 {
        mass = 4.53 kg;
        com = [0.2, 0.01, -0.11] m;
        output = [0.0, 0.0, -0.41] m;
        inertia = tensor(0.28448, 0.267165, 0.40873, -0.00906, 0.09966, 0.004983) kg*m^2 about input;
    }
    ground -> gimbal([0.4, -1.38, 1.17], z, x) j1 -> B1 b1 -> universal([0.0, -0.4, -1.13], [0.0, -1.0, 0.58]) j2 -> B2 b2 -> gimbal([-1.05, 0.22, 0.94], [-1.08, 0.18, -0.88], [1.09, 1.44, 0.76]) j3 -> B3 b3 -> elastic j4 -> moving tip;
    hinge j1 { armature = 0.29 kg*m^2; limits = [-0.75, 0.33] rad; limit_stiffness = 20.9 N*m/rad; limit_damping = 1.36 N*m*s/rad; }
    hinge j2 { rest = [-1.47, -1.46] rad; stiffness = 2.38 N*m/rad; damping = 2.47 N*m*s/rad; armature = 0.61 kg*m^2; torque = input; }
    hinge j3 { torque = [4.8, 3.9, 1.8] N*m; }
    hinge j4 { rest = [-0.19, 0.02, -0.22] m turned rpy(-0.21, -0.08, 1.22) rad; stiffness = 12.67 N/m; limits = [-1.07, 0.33] m; limit_stiffness = 30.4 N/m; limit_damping = 0.76 N*s/m; force = input; turning_friction = [1.72, 1.47, 1.48] N*m; turning_friction_speed = 0.1 rad/s; torque = input; }
    load l1 { on = b3; force = input; torque = [4.9, 6.4, -1.3] N*m; }
    spring s1 { on = b3; at = com; to = [-1.8, -1.6, -0.4] m; stiffness = 33.5 N/m; force = input; }
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
        s1_force: drives.springs[0],
    }
    hinges j1 j2;
    springs s1;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.86 kg;
        com = [-0.37, 0.11, 0.38] m;
        output = [0.0, 0.0, -0.61] m turned rpy(107.9, 59.6, 107.5) deg;
        inertia = tensor(0.689487, 0.951504, 0.566544, 0.085053, 0.401823, -0.204872) kg*m^2 about input;
        point p1 = [0.31, 0.0, 0.0] m;
    }
    moving base -> screw(y, 0.3 m/rad) j1 -> B1 b1 -> floating j2 -> moving tip;
    hinge j1 { rest = 0.18 rad; stiffness = 7.53 N*m/rad; damping = 1.95 N*m*s/rad; limits = [-0.13, 1.14] rad; limit_stiffness = 10.4 N*m/rad; }
    hinge j2 { turning_stiffness = 7.94 N*m/rad; turning_limits = 0.79 rad; turning_limit_stiffness = 34.0 N*m/rad; }
    spring s1 { on = b1; at = p1; to = [0.2, -1.3, 1.9] m; stiffness = 21.3 N/m; damping = 1.03 N*s/m; length = 1.49 m; force = input; }
}
}

printed! {
    Random18R Random18T, Point, energy_with(state, inputs);
    inputs |drives| {
        j2: gimbal(&drives.motions[0]),
        j4: vector(&drives.efforts, [6, 7, 8]),
        l2_torque: drives.loads[1].torque.into(),
    }
    hinges j1 j2 j3 j4;
    springs;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.27 kg;
        com = [0.0, 0.0, -0.56] m;
        output = [-0.26, 0.87, 0.79] m;
        inertia = tensor(0.028975, 0.023694, 0.026972, 0.006959, -0.00219, -0.003842) kg*m^2 about com;
    }
    body B2 {
        mass = 4.51 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.14] m;
        inertia = tensor(0.280288, 0.23682, 0.182324, 0.042565, 0.045355, -0.128927) kg*m^2 about com;
    }
    body B3 {
        mass = 0.43 kg;
        com = [0.57, -0.32, -0.17] m;
        output = [0.87, 0.0, 0.0] m;
        inertia = diag(0.033546, 0.030003, 0.012152) kg*m^2 about com;
    }
    body B4 {
        mass = 0.56 kg;
        com = [0.26, 0.1, 0.14] m;
        output = [0.93, 0.03, -0.64] m turned rpy(90.0, 180.0, 0.0) deg;
        inertia = tensor(0.064569, 0.08827, 0.121837, -0.01456, -0.020384, -0.00784) kg*m^2 about input;
    }
    ground -> ball j1 -> B1 b1 -> gimbal(x, y, [-0.72, 0.0, -0.69]) j2 -> B2 b2 -> planar(x) j3 -> B3 b3 -> gimbal([0.17, 0.69, 0.25], x, [0.92, -1.05, -0.56]) j4 -> B4 b4;
    hinge j2 { motion = input; }
    hinge j3 { turning_stiffness = 16.2 N*m/rad; turning_friction = 0.49 N*m; turning_friction_speed = 0.8 rad/s; turning_limits = [-0.43, 1.11] rad; turning_limit_stiffness = 6.4 N*m/rad; }
    hinge j4 { rest = [-1.21, 1.04, 0.7] rad; stiffness = [24.12, 38.14, 6.78] N*m/rad; damping = 2.89 N*m*s/rad; armature = [0.13, 0.19, 0.49] kg*m^2; torque = input; }
    load l1 { on = b1; force = [1.9, 0.0, -7.2] N; axes = body; }
    load l2 { on = b4; at = [0.0, 0.0, 0.0] m; force = [1.1, -3.2, -1.8] N; torque = input; }
}
}

printed! {
    Random19R Random19T, Point, energy_with(state, inputs);
    inputs |drives| {
        j1: floating(&drives.motions[0]),
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
        mass = 2.22 kg;
        com = [0.0, 0.0, -0.31] m;
        output = [0.0, 0.0, -0.53] m turned rpy(90.0, 180.0, 180.0) deg;
        inertia = tensor(0.327072, 0.42183, 0.127328, -0.007, -0.045251, 0.002489) kg*m^2 about input;
    }
    body B3 {
        mass = 1.66 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.34, -0.78, -1.15] m turned rpy(0.0, 90.0, 90.0) deg;
        inertia = diag(0.092487, 0.092949, 0.012032) kg*m^2 about input;
    }
    B1 b1 -> floating j1 -> B2 b2 -> screw([0.0, 0.0, -1.0], 0.54 m/rad) j2 -> B3 b3;
    hinge j1 { rest = [0.0, -0.44, -0.34] m turned quaternion(-0.06, 0.4, -0.01, -0.3); damping = 1.12 N*s/m; turning_stiffness = 1.56 N*m/rad; turning_armature = 0.34 kg*m^2; turning_limits = 0.7 rad; turning_limit_stiffness = 23.3 N*m/rad; motion = input; }
    spring s1 { on = b2; at = output; to = [-1.7, -1.7, -2.0] m; stiffness = 19.3 N/m; length = 0.71 m; }
}
}

printed! {
    Random20R Random20T, Point, energy(state);
    inputs |drives| {
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
    B1 b1 -> pin([0.14, -1.16, 0.17]) j1 -> B2 b2 -> floating j2 -> ground;
    hinge j1 { damping = 1.67 N*m*s/rad; limits = [-0.12, 1.07] rad; limit_stiffness = 24.1 N*m/rad; limit_damping = 1.68 N*m*s/rad; }
    hinge j2 { rest = [0.11, -0.29, -0.28] m turned quaternion(-0.31, -0.26, 0.26, 0.13); stiffness = [22.41, 22.55, 12.94] N/m; damping = [1.98, 0.38, 1.34] N*s/m; armature = 0.35 kg; }
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

printed! {
    Random27R Random27T, Point, energy_with(state, inputs);
    inputs |drives| {
        j2: gimbal(&drives.motions[0]),
    }
    hinges j1 j2 j3;
    springs s1;
pub chain {
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 3.42 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.16] m;
        inertia = tensor(0.329604, 0.253541, 0.251354, -0.042854, -0.036387, 0.01054) kg*m^2 about input;
    }
    body B2 {
        mass = 3.68 kg;
        com = [0.47, 0.0, 0.0] m;
        output = [-0.89, 0.78, 0.37] m turned rpy(140.6, -70.0, -48.4) deg;
        inertia = tensor(0.335997, 1.179457, 1.221768, 0.060806, -0.087746, -0.106663) kg*m^2 about input;
    }
    body B3 {
        mass = 4.02 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [1.04, 1.09, 0.15] m;
        inertia = tensor(0.243186, 0.215556, 0.302816, 0.012076, 0.064559, 0.054142) kg*m^2 about input;
    }
    ground at [1.27, 1.66, -1.42] m turned rpy(-90.0, 180.0, 180.0) deg -> weld j1 -> B1 b1 -> gimbal([-0.56, 1.34, -0.68], [0.32, 0.0, 0.53], [-0.58, 0.79, 0.14]) j2 -> B2 b2 -> cylindrical([0.63, 0.0, -0.99]) j3 -> B3 b3;
    hinge j2 { stiffness = [20.82, 15.03, 30.18] N*m/rad; damping = [0.82, 1.73, 1.77] N*m*s/rad; limits = [-0.46, 0.95] rad; limit_stiffness = 35.0 N*m/rad; limit_damping = 0.74 N*m*s/rad; motion = input; }
    hinge j3 { stiffness = 26.9 N/m; damping = 1.71 N*s/m; friction = 0.46 N; friction_speed = 0.1 m/s; }
    spring s1 { on = b1; at = [0.0, -0.84, 0.0] m; to = [-1.2, 0.9, -0.9] m; stiffness = 11.9 N/m; damping = 1.11 N*s/m; length = 0.81 m; }
}
}
