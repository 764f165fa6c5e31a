//! Printed from the seeds in `../random.rs`; not to be edited.

mstmm::mstmm_chain! {
pub chain Random0R {
    method = riccati;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.77 kg;
        com = [-0.31, 0.54, -0.12] m;
        output = [0.13, 0.5, 0.04] m turned rpy(0.0, 180.0, 90.0) deg;
        inertia = tensor(0.639971, 0.36495, 0.805302, 0.290113, -0.09228, 0.108729) kg*m^2 about input;
    }
    ground -> pin([0.0, -1.0, 0.0]) j1 -> B1 b1;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random0r(efforts: &[f64]) -> Random0RInputs<f64> {
    Random0RInputs { j1: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random0T {
    method = transfer;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.77 kg;
        com = [-0.31, 0.54, -0.12] m;
        output = [0.13, 0.5, 0.04] m turned rpy(0.0, 180.0, 90.0) deg;
        inertia = tensor(0.639971, 0.36495, 0.805302, 0.290113, -0.09228, 0.108729) kg*m^2 about input;
    }
    ground -> pin([0.0, -1.0, 0.0]) j1 -> B1 b1;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random0t(efforts: &[f64]) -> Random0TInputs<f64> {
    Random0TInputs { j1: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random1R {
    method = riccati;
    gravity = [-1.83, -0.45, 0.95] m/s^2;
    body B1 {
        mass = 2.92 kg;
        com = [-0.07, -0.07, 0.32] m;
        output = [-0.51, 0.71, -0.23] m turned rpy(-23.1, -119.9, 52.3) deg;
        inertia = diag(0.201485, 0.130069, 0.319194) kg*m^2 about com;
    }
    body B2 {
        mass = 3.63 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.21, -0.25, -0.15] m;
        inertia = tensor(0.307822, 0.312534, 0.374703, 0.020195, -0.032474, -0.012241) kg*m^2 about input;
    }
    body B3 {
        mass = 1.09 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.62] m turned rpy(-101.9, -109.1, -146.2) deg;
        inertia = tensor(0.022545, 0.022444, 0.019063, 0.000515, -0.00124, 0.001327) kg*m^2 about input;
    }
    body B4 {
        mass = 1.41 kg;
        com = [-0.34, 0.37, -0.32] m;
        output = [-0.49, -0.82, 1.04] m;
        inertia = tensor(0.427376, 0.388753, 0.496811, 0.177378, -0.153408, 0.166944) kg*m^2 about input;
    }
    body B5 {
        mass = 2.3 kg;
        com = [0.31, 0.0, 0.0] m;
        output = [0.14, 0.0, 0.0] m turned rpy(-19.4, -138.1, -25.4) deg;
        inertia = diag(0.301816, 0.193355, 0.166551) kg*m^2 about com;
    }
    body B6 {
        mass = 0.94 kg;
        com = [0.25, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-157.3, -7.3, 174.1) deg;
        inertia = tensor(0.014771, 0.02145, 0.018681, 0.00299, 0.004747, -0.000913) kg*m^2 about com;
    }
    B1 b1 -> pin([0.0, -1.0, 0.0]) j1 -> B2 b2 -> pin([-0.14, 1.37, -0.31]) j2 -> B3 b3 -> pin([0.0, 0.0, -1.0]) j3 -> B4 b4 -> weld j4 -> B5 b5 -> pin(y) j5 -> B6 b6;
    hinge j5 { torque = input; }
}
}

pub fn inputs_random1r(efforts: &[f64]) -> Random1RInputs<f64> {
    Random1RInputs { j5: efforts[9] }
}

mstmm::mstmm_chain! {
pub chain Random1T {
    method = transfer;
    gravity = [-1.83, -0.45, 0.95] m/s^2;
    body B1 {
        mass = 2.92 kg;
        com = [-0.07, -0.07, 0.32] m;
        output = [-0.51, 0.71, -0.23] m turned rpy(-23.1, -119.9, 52.3) deg;
        inertia = diag(0.201485, 0.130069, 0.319194) kg*m^2 about com;
    }
    body B2 {
        mass = 3.63 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.21, -0.25, -0.15] m;
        inertia = tensor(0.307822, 0.312534, 0.374703, 0.020195, -0.032474, -0.012241) kg*m^2 about input;
    }
    body B3 {
        mass = 1.09 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.62] m turned rpy(-101.9, -109.1, -146.2) deg;
        inertia = tensor(0.022545, 0.022444, 0.019063, 0.000515, -0.00124, 0.001327) kg*m^2 about input;
    }
    body B4 {
        mass = 1.41 kg;
        com = [-0.34, 0.37, -0.32] m;
        output = [-0.49, -0.82, 1.04] m;
        inertia = tensor(0.427376, 0.388753, 0.496811, 0.177378, -0.153408, 0.166944) kg*m^2 about input;
    }
    body B5 {
        mass = 2.3 kg;
        com = [0.31, 0.0, 0.0] m;
        output = [0.14, 0.0, 0.0] m turned rpy(-19.4, -138.1, -25.4) deg;
        inertia = diag(0.301816, 0.193355, 0.166551) kg*m^2 about com;
    }
    body B6 {
        mass = 0.94 kg;
        com = [0.25, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-157.3, -7.3, 174.1) deg;
        inertia = tensor(0.014771, 0.02145, 0.018681, 0.00299, 0.004747, -0.000913) kg*m^2 about com;
    }
    B1 b1 -> pin([0.0, -1.0, 0.0]) j1 -> B2 b2 -> pin([-0.14, 1.37, -0.31]) j2 -> B3 b3 -> pin([0.0, 0.0, -1.0]) j3 -> B4 b4 -> weld j4 -> B5 b5 -> pin(y) j5 -> B6 b6;
    hinge j5 { torque = input; }
}
}

pub fn inputs_random1t(efforts: &[f64]) -> Random1TInputs<f64> {
    Random1TInputs { j5: efforts[9] }
}

mstmm::mstmm_chain! {
pub chain Random2R {
    method = riccati;
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.04 kg;
        com = [0.32, -0.23, -0.18] m;
        output = [-0.6, 0.55, -0.39] m turned rpy(155.5, -106.8, -108.0) deg;
        inertia = tensor(0.324288, 0.449264, 0.518557, 0.229922, 0.163918, -0.11339) kg*m^2 about input;
    }
    body B2 {
        mass = 1.54 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.97] m turned rpy(172.7, 126.4, -116.9) deg;
        inertia = tensor(0.106688, 0.079112, 0.077667, -0.002444, -0.012518, -0.021782) kg*m^2 about com;
    }
    body B3 {
        mass = 4.51 kg;
        com = [-0.21, -0.59, 0.14] m;
        output = [-0.74, 0.0, 0.0] m;
        inertia = tensor(0.278066, 0.489177, 0.326507, -0.056945, 0.042595, 0.055583) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> B2 b2 -> ball j2 -> B3 b3 -> ball j3 -> ground;
    hinge j1 { torque = input; }
    hinge j2 { torque = input; }
    hinge j3 { torque = input; }
}
}

pub fn inputs_random2r(efforts: &[f64]) -> Random2RInputs<f64> {
    Random2RInputs { j1: [0, 1, 2].map(|k| efforts[k]).into(), j2: [3, 4, 5].map(|k| efforts[k]).into(), j3: [6, 7, 8].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random2T {
    method = transfer;
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.04 kg;
        com = [0.32, -0.23, -0.18] m;
        output = [-0.6, 0.55, -0.39] m turned rpy(155.5, -106.8, -108.0) deg;
        inertia = tensor(0.324288, 0.449264, 0.518557, 0.229922, 0.163918, -0.11339) kg*m^2 about input;
    }
    body B2 {
        mass = 1.54 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.97] m turned rpy(172.7, 126.4, -116.9) deg;
        inertia = tensor(0.106688, 0.079112, 0.077667, -0.002444, -0.012518, -0.021782) kg*m^2 about com;
    }
    body B3 {
        mass = 4.51 kg;
        com = [-0.21, -0.59, 0.14] m;
        output = [-0.74, 0.0, 0.0] m;
        inertia = tensor(0.278066, 0.489177, 0.326507, -0.056945, 0.042595, 0.055583) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> B2 b2 -> ball j2 -> B3 b3 -> ball j3 -> ground;
    hinge j1 { torque = input; }
    hinge j2 { torque = input; }
    hinge j3 { torque = input; }
}
}

pub fn inputs_random2t(efforts: &[f64]) -> Random2TInputs<f64> {
    Random2TInputs { j1: [0, 1, 2].map(|k| efforts[k]).into(), j2: [3, 4, 5].map(|k| efforts[k]).into(), j3: [6, 7, 8].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random3R {
    method = riccati;
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 3.55 kg;
        com = [-0.27, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.29] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.320313, 0.355042, 0.370583, -0.029021, 0.022713, 0.023207) kg*m^2 about com;
    }
    body B2 {
        mass = 2.64 kg;
        com = [-0.22, 0.09, 0.47] m;
        output = [0.0, 0.0, 0.0] m turned rpy(180.0, 0.0, 0.0) deg;
        inertia = diag(0.101127, 0.127364, 0.125083) kg*m^2 about com;
    }
    body B3 {
        mass = 3.07 kg;
        com = [0.0, 0.0, -0.2] m;
        output = [0.0, 0.0, -0.67] m turned rpy(180.0, 90.0, 90.0) deg;
        inertia = tensor(0.135177, 0.098285, 0.082013, 0.002481, -0.002086, 0.01141) kg*m^2 about com;
    }
    body B4 {
        mass = 4.46 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, -0.31, 0.0] m;
        inertia = diag(0.620957, 0.294532, 0.338394) kg*m^2 about input;
    }
    body B5 {
        mass = 1.7 kg;
        com = [0.0, 0.0, -0.27] m;
        output = [0.58, 0.0, 0.0] m;
        inertia = tensor(0.030874, 0.029589, 0.030772, -3.2e-5, -0.00195, -9.7e-5) kg*m^2 about com;
    }
    body B6 {
        mass = 4.3 kg;
        com = [0.0, -0.56, 0.0] m;
        output = [-0.38, -0.27, 0.88] m;
        inertia = tensor(1.685406, 0.176813, 1.589242, -0.063279, -0.044304, -0.153762) kg*m^2 about input;
    }
    body B7 {
        mass = 1.88 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [1.11, 0.0, 0.0] m;
        inertia = diag(0.138807, 0.082033, 0.070738) kg*m^2 about com;
    }
    body B8 {
        mass = 2.28 kg;
        com = [0.0, -0.49, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = tensor(0.727448, 0.096011, 0.661604, 0.013728, -0.001124, -0.00563) kg*m^2 about input;
    }
    ground at [0.13, 1.65, 0.38] m turned rpy(180.0, 180.0, -90.0) deg -> pin([0.2, 0.99, 1.34]) j1 -> B1 b1 -> weld j2 -> B2 b2 -> weld j3 -> B3 b3 -> weld j4 -> B4 b4 -> pin([0.0, 0.0, -1.0]) j5 -> B5 b5 -> ball j6 -> B6 b6 -> ball j7 -> B7 b7 -> ball j8 -> B8 b8;
    hinge j7 { torque = input; }
    hinge j8 { torque = input; }
}
}

pub fn inputs_random3r(efforts: &[f64]) -> Random3RInputs<f64> {
    Random3RInputs { j7: [5, 6, 7].map(|k| efforts[k]).into(), j8: [8, 9, 10].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random3T {
    method = transfer;
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 3.55 kg;
        com = [-0.27, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.29] m turned rpy(0.0, 90.0, 0.0) deg;
        inertia = tensor(0.320313, 0.355042, 0.370583, -0.029021, 0.022713, 0.023207) kg*m^2 about com;
    }
    body B2 {
        mass = 2.64 kg;
        com = [-0.22, 0.09, 0.47] m;
        output = [0.0, 0.0, 0.0] m turned rpy(180.0, 0.0, 0.0) deg;
        inertia = diag(0.101127, 0.127364, 0.125083) kg*m^2 about com;
    }
    body B3 {
        mass = 3.07 kg;
        com = [0.0, 0.0, -0.2] m;
        output = [0.0, 0.0, -0.67] m turned rpy(180.0, 90.0, 90.0) deg;
        inertia = tensor(0.135177, 0.098285, 0.082013, 0.002481, -0.002086, 0.01141) kg*m^2 about com;
    }
    body B4 {
        mass = 4.46 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, -0.31, 0.0] m;
        inertia = diag(0.620957, 0.294532, 0.338394) kg*m^2 about input;
    }
    body B5 {
        mass = 1.7 kg;
        com = [0.0, 0.0, -0.27] m;
        output = [0.58, 0.0, 0.0] m;
        inertia = tensor(0.030874, 0.029589, 0.030772, -3.2e-5, -0.00195, -9.7e-5) kg*m^2 about com;
    }
    body B6 {
        mass = 4.3 kg;
        com = [0.0, -0.56, 0.0] m;
        output = [-0.38, -0.27, 0.88] m;
        inertia = tensor(1.685406, 0.176813, 1.589242, -0.063279, -0.044304, -0.153762) kg*m^2 about input;
    }
    body B7 {
        mass = 1.88 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [1.11, 0.0, 0.0] m;
        inertia = diag(0.138807, 0.082033, 0.070738) kg*m^2 about com;
    }
    body B8 {
        mass = 2.28 kg;
        com = [0.0, -0.49, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, -90.0, 0.0) deg;
        inertia = tensor(0.727448, 0.096011, 0.661604, 0.013728, -0.001124, -0.00563) kg*m^2 about input;
    }
    ground at [0.13, 1.65, 0.38] m turned rpy(180.0, 180.0, -90.0) deg -> pin([0.2, 0.99, 1.34]) j1 -> B1 b1 -> weld j2 -> B2 b2 -> weld j3 -> B3 b3 -> weld j4 -> B4 b4 -> pin([0.0, 0.0, -1.0]) j5 -> B5 b5 -> ball j6 -> B6 b6 -> ball j7 -> B7 b7 -> ball j8 -> B8 b8;
    hinge j7 { torque = input; }
    hinge j8 { torque = input; }
}
}

pub fn inputs_random3t(efforts: &[f64]) -> Random3TInputs<f64> {
    Random3TInputs { j7: [5, 6, 7].map(|k| efforts[k]).into(), j8: [8, 9, 10].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random4R {
    method = riccati;
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 2.27 kg;
        com = [-0.01, -0.13, 0.1] m;
        output = [0.0, 0.0, 0.3] m turned rpy(126.4, 106.0, 38.8) deg;
        inertia = tensor(0.105185, 0.174484, 0.164498, -0.002951, 0.00227, 0.02951) kg*m^2 about input;
    }
    body B2 {
        mass = 0.84 kg;
        com = [0.08, 0.44, -0.3] m;
        output = [-1.07, -0.41, -0.76] m turned rpy(174.7, 122.2, -108.3) deg;
        inertia = diag(0.00857, 0.075125, 0.068022) kg*m^2 about com;
    }
    body B3 {
        mass = 4.26 kg;
        com = [-0.43, -0.39, 0.05] m;
        output = [-1.08, -0.4, -0.74] m;
        inertia = diag(0.246415, 0.380836, 0.276236) kg*m^2 about com;
    }
    body B4 {
        mass = 4.23 kg;
        com = [-0.15, 0.05, 0.23] m;
        output = [-1.09, 0.24, 0.48] m;
        inertia = tensor(0.366885, 0.40175, 0.212045, 0.021159, 0.161376, -0.077644) kg*m^2 about input;
    }
    body B5 {
        mass = 4.74 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.81, -1.08, 0.67] m;
        inertia = tensor(0.379917, 0.281218, 0.247965, 0.077452, 0.067566, -0.135464) kg*m^2 about com;
    }
    B1 b1 -> weld j1 -> B2 b2 -> pin([1.39, 1.17, 0.84]) j2 -> B3 b3 -> pin(x) j3 -> B4 b4 -> ball j4 -> B5 b5;
    hinge j3 { torque = input; }
    hinge j4 { torque = input; }
}
}

pub fn inputs_random4r(efforts: &[f64]) -> Random4RInputs<f64> {
    Random4RInputs { j3: efforts[7], j4: [8, 9, 10].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random4T {
    method = transfer;
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 2.27 kg;
        com = [-0.01, -0.13, 0.1] m;
        output = [0.0, 0.0, 0.3] m turned rpy(126.4, 106.0, 38.8) deg;
        inertia = tensor(0.105185, 0.174484, 0.164498, -0.002951, 0.00227, 0.02951) kg*m^2 about input;
    }
    body B2 {
        mass = 0.84 kg;
        com = [0.08, 0.44, -0.3] m;
        output = [-1.07, -0.41, -0.76] m turned rpy(174.7, 122.2, -108.3) deg;
        inertia = diag(0.00857, 0.075125, 0.068022) kg*m^2 about com;
    }
    body B3 {
        mass = 4.26 kg;
        com = [-0.43, -0.39, 0.05] m;
        output = [-1.08, -0.4, -0.74] m;
        inertia = diag(0.246415, 0.380836, 0.276236) kg*m^2 about com;
    }
    body B4 {
        mass = 4.23 kg;
        com = [-0.15, 0.05, 0.23] m;
        output = [-1.09, 0.24, 0.48] m;
        inertia = tensor(0.366885, 0.40175, 0.212045, 0.021159, 0.161376, -0.077644) kg*m^2 about input;
    }
    body B5 {
        mass = 4.74 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.81, -1.08, 0.67] m;
        inertia = tensor(0.379917, 0.281218, 0.247965, 0.077452, 0.067566, -0.135464) kg*m^2 about com;
    }
    B1 b1 -> weld j1 -> B2 b2 -> pin([1.39, 1.17, 0.84]) j2 -> B3 b3 -> pin(x) j3 -> B4 b4 -> ball j4 -> B5 b5;
    hinge j3 { torque = input; }
    hinge j4 { torque = input; }
}
}

pub fn inputs_random4t(efforts: &[f64]) -> Random4TInputs<f64> {
    Random4TInputs { j3: efforts[7], j4: [8, 9, 10].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random5R {
    method = riccati;
    gravity = [-3.56, 1.06, -0.8] m/s^2;
    body B1 {
        mass = 2.06 kg;
        com = [0.0, 0.15, 0.0] m;
        output = [-0.18, 0.25, -0.12] m;
        inertia = tensor(0.240263, 0.242453, 0.228241, -0.039251, -0.034734, 0.036592) kg*m^2 about com;
    }
    body B2 {
        mass = 2.46 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.99, -0.19, -0.23] m turned rpy(90.0, 180.0, 90.0) deg;
        inertia = diag(0.088232, 0.157216, 0.207007) kg*m^2 about com;
    }
    B1 b1 -> pin([0.0, -1.0, 0.0]) j1 -> B2 b2 -> weld j2 -> ground at [0.04, -1.61, 0.16] m;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random5r(efforts: &[f64]) -> Random5RInputs<f64> {
    Random5RInputs { j1: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random5T {
    method = transfer;
    gravity = [-3.56, 1.06, -0.8] m/s^2;
    body B1 {
        mass = 2.06 kg;
        com = [0.0, 0.15, 0.0] m;
        output = [-0.18, 0.25, -0.12] m;
        inertia = tensor(0.240263, 0.242453, 0.228241, -0.039251, -0.034734, 0.036592) kg*m^2 about com;
    }
    body B2 {
        mass = 2.46 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.99, -0.19, -0.23] m turned rpy(90.0, 180.0, 90.0) deg;
        inertia = diag(0.088232, 0.157216, 0.207007) kg*m^2 about com;
    }
    B1 b1 -> pin([0.0, -1.0, 0.0]) j1 -> B2 b2 -> weld j2 -> ground at [0.04, -1.61, 0.16] m;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random5t(efforts: &[f64]) -> Random5TInputs<f64> {
    Random5TInputs { j1: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random6R {
    method = riccati;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.34 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 180.0, -90.0) deg;
        inertia = tensor(0.166533, 0.090363, 0.205689, -0.030648, -0.022153, -0.021245) kg*m^2 about com;
    }
    body B2 {
        mass = 2.63 kg;
        com = [0.0, 0.0, -0.19] m;
        output = [-0.85, -0.37, 1.16] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = diag(0.273052, 0.314971, 0.061774) kg*m^2 about input;
    }
    body B3 {
        mass = 1.21 kg;
        com = [0.43, -0.56, 0.33] m;
        output = [0.32, 0.63, -0.61] m;
        inertia = tensor(0.594731, 0.411385, 0.667675, 0.291368, -0.171699, 0.223608) kg*m^2 about input;
    }
    body B4 {
        mass = 3.22 kg;
        com = [0.0, -0.17, 0.0] m;
        output = [0.0, 0.0, 0.61] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = diag(0.322939, 0.288421, 0.091627) kg*m^2 about com;
    }
    body B5 {
        mass = 3.53 kg;
        com = [-0.6, 0.33, -0.29] m;
        output = [0.83, -0.71, 1.13] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = diag(0.193086, 0.310598, 0.468995) kg*m^2 about com;
    }
    body B6 {
        mass = 4.35 kg;
        com = [0.0, -0.42, 0.0] m;
        output = [0.0, 0.0, 0.15] m;
        inertia = diag(0.262247, 0.203186, 0.19786) kg*m^2 about com;
    }
    body B7 {
        mass = 1.81 kg;
        com = [-0.43, -0.17, 0.1] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.189799, 0.380136, 0.506669, -0.132311, 0.07783, 0.03077) kg*m^2 about input;
    }
    ground at [-1.57, 1.78, 0.23] m turned rpy(65.5, -13.1, 77.8) deg -> weld j1 -> B1 b1 -> pin(z) j2 -> B2 b2 -> weld j3 -> B3 b3 -> ball j4 -> B4 b4 -> pin(y) j5 -> B5 b5 -> pin(x) j6 -> B6 b6 -> weld j7 -> B7 b7;
    hinge j2 { torque = input; }
}
}

pub fn inputs_random6r(efforts: &[f64]) -> Random6RInputs<f64> {
    Random6RInputs { j2: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random6T {
    method = transfer;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.34 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(0.0, 180.0, -90.0) deg;
        inertia = tensor(0.166533, 0.090363, 0.205689, -0.030648, -0.022153, -0.021245) kg*m^2 about com;
    }
    body B2 {
        mass = 2.63 kg;
        com = [0.0, 0.0, -0.19] m;
        output = [-0.85, -0.37, 1.16] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = diag(0.273052, 0.314971, 0.061774) kg*m^2 about input;
    }
    body B3 {
        mass = 1.21 kg;
        com = [0.43, -0.56, 0.33] m;
        output = [0.32, 0.63, -0.61] m;
        inertia = tensor(0.594731, 0.411385, 0.667675, 0.291368, -0.171699, 0.223608) kg*m^2 about input;
    }
    body B4 {
        mass = 3.22 kg;
        com = [0.0, -0.17, 0.0] m;
        output = [0.0, 0.0, 0.61] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = diag(0.322939, 0.288421, 0.091627) kg*m^2 about com;
    }
    body B5 {
        mass = 3.53 kg;
        com = [-0.6, 0.33, -0.29] m;
        output = [0.83, -0.71, 1.13] m turned rpy(0.0, 0.0, 180.0) deg;
        inertia = diag(0.193086, 0.310598, 0.468995) kg*m^2 about com;
    }
    body B6 {
        mass = 4.35 kg;
        com = [0.0, -0.42, 0.0] m;
        output = [0.0, 0.0, 0.15] m;
        inertia = diag(0.262247, 0.203186, 0.19786) kg*m^2 about com;
    }
    body B7 {
        mass = 1.81 kg;
        com = [-0.43, -0.17, 0.1] m;
        output = [0.0, 0.0, 0.0] m;
        inertia = tensor(0.189799, 0.380136, 0.506669, -0.132311, 0.07783, 0.03077) kg*m^2 about input;
    }
    ground at [-1.57, 1.78, 0.23] m turned rpy(65.5, -13.1, 77.8) deg -> weld j1 -> B1 b1 -> pin(z) j2 -> B2 b2 -> weld j3 -> B3 b3 -> ball j4 -> B4 b4 -> pin(y) j5 -> B5 b5 -> pin(x) j6 -> B6 b6 -> weld j7 -> B7 b7;
    hinge j2 { torque = input; }
}
}

pub fn inputs_random6t(efforts: &[f64]) -> Random6TInputs<f64> {
    Random6TInputs { j2: efforts[0] }
}

mstmm::mstmm_chain! {
pub chain Random7R {
    method = riccati;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.07 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.11, -0.6, -0.08] m;
        inertia = tensor(0.176612, 0.065518, 0.168083, 0.048537, 0.003708, 0.01993) kg*m^2 about com;
    }
    body B2 {
        mass = 2.23 kg;
        com = [-0.51, -0.11, 0.48] m;
        output = [-1.07, -0.28, -0.52] m turned rpy(90.0, 180.0, 180.0) deg;
        inertia = diag(0.040933, 0.164312, 0.196589) kg*m^2 about com;
    }
    body B3 {
        mass = 3.42 kg;
        com = [0.0, 0.23, 0.0] m;
        output = [0.73, 0.0, 0.0] m;
        inertia = tensor(0.293935, 0.135185, 0.308209, -0.000204, -0.004687, -0.003874) kg*m^2 about input;
    }
    body B4 {
        mass = 0.97 kg;
        com = [0.0, 0.0, 0.52] m;
        output = [0.0, 0.0, 0.0] m turned rpy(25.4, -145.7, 140.4) deg;
        inertia = diag(0.317824, 0.337709, 0.127309) kg*m^2 about input;
    }
    B1 b1 -> ball j1 -> B2 b2 -> pin(x) j2 -> B3 b3 -> ball j3 -> B4 b4;
    hinge j1 { torque = input; }
    hinge j3 { torque = input; }
}
}

pub fn inputs_random7r(efforts: &[f64]) -> Random7RInputs<f64> {
    Random7RInputs { j1: [6, 7, 8].map(|k| efforts[k]).into(), j3: [10, 11, 12].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random7T {
    method = transfer;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 2.07 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [-0.11, -0.6, -0.08] m;
        inertia = tensor(0.176612, 0.065518, 0.168083, 0.048537, 0.003708, 0.01993) kg*m^2 about com;
    }
    body B2 {
        mass = 2.23 kg;
        com = [-0.51, -0.11, 0.48] m;
        output = [-1.07, -0.28, -0.52] m turned rpy(90.0, 180.0, 180.0) deg;
        inertia = diag(0.040933, 0.164312, 0.196589) kg*m^2 about com;
    }
    body B3 {
        mass = 3.42 kg;
        com = [0.0, 0.23, 0.0] m;
        output = [0.73, 0.0, 0.0] m;
        inertia = tensor(0.293935, 0.135185, 0.308209, -0.000204, -0.004687, -0.003874) kg*m^2 about input;
    }
    body B4 {
        mass = 0.97 kg;
        com = [0.0, 0.0, 0.52] m;
        output = [0.0, 0.0, 0.0] m turned rpy(25.4, -145.7, 140.4) deg;
        inertia = diag(0.317824, 0.337709, 0.127309) kg*m^2 about input;
    }
    B1 b1 -> ball j1 -> B2 b2 -> pin(x) j2 -> B3 b3 -> ball j3 -> B4 b4;
    hinge j1 { torque = input; }
    hinge j3 { torque = input; }
}
}

pub fn inputs_random7t(efforts: &[f64]) -> Random7TInputs<f64> {
    Random7TInputs { j1: [6, 7, 8].map(|k| efforts[k]).into(), j3: [10, 11, 12].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random8R {
    method = riccati;
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.17 kg;
        com = [0.04, -0.52, -0.15] m;
        output = [0.19, 0.0, 0.0] m turned rpy(-90.0, 0.0, 90.0) deg;
        inertia = diag(0.249286, 0.408107, 0.26589) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> ground at [0.0, -0.54, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random8r(efforts: &[f64]) -> Random8RInputs<f64> {
    Random8RInputs { j1: [0, 1, 2].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random8T {
    method = transfer;
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body B1 {
        mass = 3.17 kg;
        com = [0.04, -0.52, -0.15] m;
        output = [0.19, 0.0, 0.0] m turned rpy(-90.0, 0.0, 90.0) deg;
        inertia = diag(0.249286, 0.408107, 0.26589) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> ground at [0.0, -0.54, 0.0] m turned rpy(0.0, 90.0, 0.0) deg;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random8t(efforts: &[f64]) -> Random8TInputs<f64> {
    Random8TInputs { j1: [0, 1, 2].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random9R {
    method = riccati;
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.23 kg;
        com = [0.0, 0.0, -0.48] m;
        output = [0.42, 0.64, -1.01] m turned rpy(60.4, 165.9, -86.6) deg;
        inertia = diag(0.298968, 0.339387, 0.069486) kg*m^2 about input;
    }
    body B2 {
        mass = 4.61 kg;
        com = [-0.53, 0.44, -0.31] m;
        output = [0.16, 0.0, 0.0] m;
        inertia = tensor(1.723826, 2.200684, 2.316012, 1.079307, -0.762834, 0.553685) kg*m^2 about input;
    }
    body B3 {
        mass = 2.47 kg;
        com = [0.0, 0.32, 0.0] m;
        output = [-0.64, 1.06, 0.56] m turned rpy(169.5, 110.4, -86.3) deg;
        inertia = diag(0.505618, 0.143035, 0.527444) kg*m^2 about input;
    }
    body B4 {
        mass = 1.58 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, -1.03] m turned rpy(148.5, 0.3, 82.8) deg;
        inertia = tensor(0.142763, 0.101447, 0.174414, 0.009493, 0.014686, 0.000226) kg*m^2 about input;
    }
    body B5 {
        mass = 3.18 kg;
        com = [0.18, 0.34, -0.03] m;
        output = [0.0, 0.85, 0.0] m turned rpy(0.0, 90.0, 90.0) deg;
        inertia = tensor(0.60988, 0.270987, 0.61431, -0.245686, 0.018789, 0.003264) kg*m^2 about input;
    }
    body B6 {
        mass = 3.43 kg;
        com = [0.19, -0.1, -0.59] m;
        output = [-0.29, -0.38, -0.6] m turned rpy(-9.8, 155.8, -26.9) deg;
        inertia = tensor(1.686925, 1.595467, 0.390207, 0.06517, 0.384503, -0.20237) kg*m^2 about input;
    }
    ground -> pin([0.0, -1.0, -0.41]) j1 -> B1 b1 -> ball j2 -> B2 b2 -> weld j3 -> B3 b3 -> pin([0.0, -1.0, 0.0]) j4 -> B4 b4 -> ball j5 -> B5 b5 -> pin([0.0, -1.0, 0.0]) j6 -> B6 b6;
    hinge j2 { torque = input; }
    hinge j5 { torque = input; }
}
}

pub fn inputs_random9r(efforts: &[f64]) -> Random9RInputs<f64> {
    Random9RInputs { j2: [1, 2, 3].map(|k| efforts[k]).into(), j5: [5, 6, 7].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random9T {
    method = transfer;
    gravity = [0.0, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.23 kg;
        com = [0.0, 0.0, -0.48] m;
        output = [0.42, 0.64, -1.01] m turned rpy(60.4, 165.9, -86.6) deg;
        inertia = diag(0.298968, 0.339387, 0.069486) kg*m^2 about input;
    }
    body B2 {
        mass = 4.61 kg;
        com = [-0.53, 0.44, -0.31] m;
        output = [0.16, 0.0, 0.0] m;
        inertia = tensor(1.723826, 2.200684, 2.316012, 1.079307, -0.762834, 0.553685) kg*m^2 about input;
    }
    body B3 {
        mass = 2.47 kg;
        com = [0.0, 0.32, 0.0] m;
        output = [-0.64, 1.06, 0.56] m turned rpy(169.5, 110.4, -86.3) deg;
        inertia = diag(0.505618, 0.143035, 0.527444) kg*m^2 about input;
    }
    body B4 {
        mass = 1.58 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, -1.03] m turned rpy(148.5, 0.3, 82.8) deg;
        inertia = tensor(0.142763, 0.101447, 0.174414, 0.009493, 0.014686, 0.000226) kg*m^2 about input;
    }
    body B5 {
        mass = 3.18 kg;
        com = [0.18, 0.34, -0.03] m;
        output = [0.0, 0.85, 0.0] m turned rpy(0.0, 90.0, 90.0) deg;
        inertia = tensor(0.60988, 0.270987, 0.61431, -0.245686, 0.018789, 0.003264) kg*m^2 about input;
    }
    body B6 {
        mass = 3.43 kg;
        com = [0.19, -0.1, -0.59] m;
        output = [-0.29, -0.38, -0.6] m turned rpy(-9.8, 155.8, -26.9) deg;
        inertia = tensor(1.686925, 1.595467, 0.390207, 0.06517, 0.384503, -0.20237) kg*m^2 about input;
    }
    ground -> pin([0.0, -1.0, -0.41]) j1 -> B1 b1 -> ball j2 -> B2 b2 -> weld j3 -> B3 b3 -> pin([0.0, -1.0, 0.0]) j4 -> B4 b4 -> ball j5 -> B5 b5 -> pin([0.0, -1.0, 0.0]) j6 -> B6 b6;
    hinge j2 { torque = input; }
    hinge j5 { torque = input; }
}
}

pub fn inputs_random9t(efforts: &[f64]) -> Random9TInputs<f64> {
    Random9TInputs { j2: [1, 2, 3].map(|k| efforts[k]).into(), j5: [5, 6, 7].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random10R {
    method = riccati;
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 0.36 kg;
        com = [0.0, -0.52, 0.0] m;
        output = [1.14, -0.5, -0.62] m;
        inertia = diag(0.101873, 0.028786, 0.122736) kg*m^2 about input;
    }
    body B2 {
        mass = 1.61 kg;
        com = [0.56, 0.44, 0.51] m;
        output = [0.25, 0.0, 0.0] m turned rpy(-53.7, -38.7, -17.0) deg;
        inertia = tensor(0.827794, 1.011172, 0.926496, -0.396151, -0.466642, -0.349288) kg*m^2 about input;
    }
    body B3 {
        mass = 0.67 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-6.8, 66.9, -65.8) deg;
        inertia = diag(0.010432, 0.03228, 0.029208) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> B2 b2 -> pin(x) j2 -> B3 b3;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random10r(efforts: &[f64]) -> Random10RInputs<f64> {
    Random10RInputs { j1: [6, 7, 8].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random10T {
    method = transfer;
    gravity = [0.0, 0.0, -9.81] m/s^2;
    body B1 {
        mass = 0.36 kg;
        com = [0.0, -0.52, 0.0] m;
        output = [1.14, -0.5, -0.62] m;
        inertia = diag(0.101873, 0.028786, 0.122736) kg*m^2 about input;
    }
    body B2 {
        mass = 1.61 kg;
        com = [0.56, 0.44, 0.51] m;
        output = [0.25, 0.0, 0.0] m turned rpy(-53.7, -38.7, -17.0) deg;
        inertia = tensor(0.827794, 1.011172, 0.926496, -0.396151, -0.466642, -0.349288) kg*m^2 about input;
    }
    body B3 {
        mass = 0.67 kg;
        com = [0.0, 0.0, 0.0] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-6.8, 66.9, -65.8) deg;
        inertia = diag(0.010432, 0.03228, 0.029208) kg*m^2 about com;
    }
    B1 b1 -> ball j1 -> B2 b2 -> pin(x) j2 -> B3 b3;
    hinge j1 { torque = input; }
}
}

pub fn inputs_random10t(efforts: &[f64]) -> Random10TInputs<f64> {
    Random10TInputs { j1: [6, 7, 8].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random11R {
    method = riccati;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.72 kg;
        com = [0.01, -0.4, 0.06] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-121.0, -88.5, 148.2) deg;
        inertia = tensor(0.128206, 0.163732, 0.120766, 0.017945, 0.049132, 0.013383) kg*m^2 about com;
    }
    body B2 {
        mass = 4.63 kg;
        com = [0.0, 0.0, 0.37] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-50.3, 129.4, 61.1) deg;
        inertia = tensor(0.935513, 0.902384, 0.233131, 0.04154, -0.070365, 0.068567) kg*m^2 about input;
    }
    body B3 {
        mass = 2.0 kg;
        com = [0.0, 0.39, 0.0] m;
        output = [0.6, 1.11, 0.67] m;
        inertia = tensor(0.320589, 0.064076, 0.36087, 0.00621, 0.004236, -0.001527) kg*m^2 about input;
    }
    body B4 {
        mass = 2.24 kg;
        com = [0.0, 0.54, 0.0] m;
        output = [-0.39, -0.23, -1.11] m turned rpy(-179.8, 103.6, -45.5) deg;
        inertia = diag(0.78087, 0.197375, 0.763826) kg*m^2 about input;
    }
    body B5 {
        mass = 1.17 kg;
        com = [0.01, 0.31, 0.45] m;
        output = [1.06, 0.0, 0.0] m;
        inertia = tensor(0.06859, 0.072564, 0.063888, -0.008151, 0.013383, 0.021973) kg*m^2 about com;
    }
    body B6 {
        mass = 4.57 kg;
        com = [-0.23, 0.23, -0.18] m;
        output = [1.12, 0.0, 0.0] m turned rpy(180.0, 90.0, 180.0) deg;
        inertia = tensor(0.613073, 0.619673, 0.630903, 0.26692, -0.219195, 0.285525) kg*m^2 about input;
    }
    body B7 {
        mass = 2.62 kg;
        com = [0.55, 0.3, 0.44] m;
        output = [0.0, 0.0, 0.0] m turned rpy(134.5, 47.6, 59.9) deg;
        inertia = tensor(0.156574, 0.302525, 0.183892, 0.00235, 0.004151, -0.017157) kg*m^2 about com;
    }
    body B8 {
        mass = 4.05 kg;
        com = [0.0, 0.19, 0.0] m;
        output = [-1.13, 0.0, 0.0] m turned rpy(90.0, -90.0, 90.0) deg;
        inertia = diag(0.543739, 0.344409, 0.324734) kg*m^2 about com;
    }
    B1 b1 -> weld j1 -> B2 b2 -> pin([-0.89, 0.46, -0.46]) j2 -> B3 b3 -> pin([0.0, -1.0, 0.0]) j3 -> B4 b4 -> weld j4 -> B5 b5 -> ball j5 -> B6 b6 -> ball j6 -> B7 b7 -> ball j7 -> B8 b8 -> ball j8 -> ground;
    hinge j2 { torque = input; }
    hinge j5 { torque = input; }
    hinge j7 { torque = input; }
    hinge j8 { torque = input; }
}
}

pub fn inputs_random11r(efforts: &[f64]) -> Random11RInputs<f64> {
    Random11RInputs { j2: efforts[0], j5: [2, 3, 4].map(|k| efforts[k]).into(), j7: [8, 9, 10].map(|k| efforts[k]).into(), j8: [11, 12, 13].map(|k| efforts[k]).into() }
}

mstmm::mstmm_chain! {
pub chain Random11T {
    method = transfer;
    gravity = [9.81, 0.0, 0.0] m/s^2;
    body B1 {
        mass = 1.72 kg;
        com = [0.01, -0.4, 0.06] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-121.0, -88.5, 148.2) deg;
        inertia = tensor(0.128206, 0.163732, 0.120766, 0.017945, 0.049132, 0.013383) kg*m^2 about com;
    }
    body B2 {
        mass = 4.63 kg;
        com = [0.0, 0.0, 0.37] m;
        output = [0.0, 0.0, 0.0] m turned rpy(-50.3, 129.4, 61.1) deg;
        inertia = tensor(0.935513, 0.902384, 0.233131, 0.04154, -0.070365, 0.068567) kg*m^2 about input;
    }
    body B3 {
        mass = 2.0 kg;
        com = [0.0, 0.39, 0.0] m;
        output = [0.6, 1.11, 0.67] m;
        inertia = tensor(0.320589, 0.064076, 0.36087, 0.00621, 0.004236, -0.001527) kg*m^2 about input;
    }
    body B4 {
        mass = 2.24 kg;
        com = [0.0, 0.54, 0.0] m;
        output = [-0.39, -0.23, -1.11] m turned rpy(-179.8, 103.6, -45.5) deg;
        inertia = diag(0.78087, 0.197375, 0.763826) kg*m^2 about input;
    }
    body B5 {
        mass = 1.17 kg;
        com = [0.01, 0.31, 0.45] m;
        output = [1.06, 0.0, 0.0] m;
        inertia = tensor(0.06859, 0.072564, 0.063888, -0.008151, 0.013383, 0.021973) kg*m^2 about com;
    }
    body B6 {
        mass = 4.57 kg;
        com = [-0.23, 0.23, -0.18] m;
        output = [1.12, 0.0, 0.0] m turned rpy(180.0, 90.0, 180.0) deg;
        inertia = tensor(0.613073, 0.619673, 0.630903, 0.26692, -0.219195, 0.285525) kg*m^2 about input;
    }
    body B7 {
        mass = 2.62 kg;
        com = [0.55, 0.3, 0.44] m;
        output = [0.0, 0.0, 0.0] m turned rpy(134.5, 47.6, 59.9) deg;
        inertia = tensor(0.156574, 0.302525, 0.183892, 0.00235, 0.004151, -0.017157) kg*m^2 about com;
    }
    body B8 {
        mass = 4.05 kg;
        com = [0.0, 0.19, 0.0] m;
        output = [-1.13, 0.0, 0.0] m turned rpy(90.0, -90.0, 90.0) deg;
        inertia = diag(0.543739, 0.344409, 0.324734) kg*m^2 about com;
    }
    B1 b1 -> weld j1 -> B2 b2 -> pin([-0.89, 0.46, -0.46]) j2 -> B3 b3 -> pin([0.0, -1.0, 0.0]) j3 -> B4 b4 -> weld j4 -> B5 b5 -> ball j5 -> B6 b6 -> ball j6 -> B7 b7 -> ball j7 -> B8 b8 -> ball j8 -> ground;
    hinge j2 { torque = input; }
    hinge j5 { torque = input; }
    hinge j7 { torque = input; }
    hinge j8 { torque = input; }
}
}

pub fn inputs_random11t(efforts: &[f64]) -> Random11TInputs<f64> {
    Random11TInputs { j2: efforts[0], j5: [2, 3, 4].map(|k| efforts[k]).into(), j7: [8, 9, 10].map(|k| efforts[k]).into(), j8: [11, 12, 13].map(|k| efforts[k]).into() }
}
