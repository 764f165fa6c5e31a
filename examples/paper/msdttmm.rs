//! The original method that the paper compares with, the discrete time transfer matrix method of
//! multibody systems (MSDTTMM), for a planar rod on a hinge.
//!
//! Its state vector has positions, `z = [x, y, θ, m, q_x, q_y, 1]`. In every step, Newmark's formulas
//! express the accelerations by the unknown positions, and Taylor series about the previous step replace the
//! nonlinear terms: the paper's Table 1 shows the error of this linearisation. Of the variants in the
//! literature, this is the plain one: β = 1/4, γ = 1/2, kinematics to first order in the angle, moment arms
//! at the angle that the previous rate predicts, also to first order.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Newmark's parameters for a constant mean acceleration in a step.
const BETA: f64 = 0.25;
const GAMMA: f64 = 0.5;

/// A coordinate and its first two time derivatives.
#[derive(Clone, Copy)]
struct Motion {
    position: f64,
    rate: f64,
    acceleration: f64,
}

impl Motion {
    /// The constant part of the acceleration by Newmark's formula for a position `x` after a step:
    /// `ẍ = x / (β h²) + constant`.
    fn constant(self, h: f64) -> f64 {
        let Motion { position, rate, acceleration } = self;
        -(position + h * rate + (0.5 - BETA) * h * h * acceleration) / (BETA * h * h)
    }

    /// The motion after a step to this position.
    fn step(self, position: f64, h: f64) -> Motion {
        let acceleration = position / (BETA * h * h) + self.constant(h);
        let mean = (1.0 - GAMMA) * self.acceleration + GAMMA * acceleration;
        Motion { position, rate: self.rate + h * mean, acceleration }
    }
}

/// A homogeneous rod with a hinge at its input.
pub struct Rod {
    pub mass: f64,
    pub length: f64,
    pub gravity: f64,
    /// The angle relative to the horizontal in rad.
    angle: Motion,
    /// The input, which is fixed by the hinge.
    input: [Motion; 2],
    /// The centre of mass.
    centre: [Motion; 2],
}

impl Rod {
    /// A rod at an angle in rad with a rate in rad/s.
    pub fn new(mass: f64, length: f64, gravity: f64, angle: f64, rate: f64) -> Self {
        // J θ̈ = −m g l cos θ / 2 about the hinge, J = m l²/3.
        let acceleration = -1.5 * gravity / length * angle.cos();
        let (s, c) = angle.sin_cos();
        let half = length / 2.0;
        let point = |along: f64, across: f64, to_centre: f64| Motion {
            position: half * along,
            rate: half * rate * across,
            acceleration: half * (acceleration * across + rate * rate * to_centre),
        };
        Rod {
            mass,
            length,
            gravity,
            angle: Motion { position: angle, rate, acceleration },
            input: [Motion { position: 0.0, rate: 0.0, acceleration: 0.0 }; 2],
            centre: [point(c, -s, -c), point(s, c, -s)],
        }
    }

    pub fn angle(&self) -> f64 {
        self.angle.position
    }

    /// One step of length `h`.
    pub fn step(&mut self, h: f64) {
        let transfer = self.transfer_matrix(h);
        // At the hinge x = y = m = 0; at the free end m = q = 0. The unknowns are θ, q_x and q_y.
        let unknowns = [2, 4, 5];
        let conditions = [3, 4, 5];
        let left = Matrix3::from_fn(|i, k| transfer[(conditions[i], unknowns[k])]);
        let right = Vector3::from_fn(|i, _| -transfer[(conditions[i], 6)]);
        // Regular for every positive step, because the mass matrix over β h² dominates.
        let Some(solution) = left.lu().solve(&right) else { return };
        let mut z = SVector::<f64, 7>::zeros();
        for (&index, &value) in unknowns.iter().zip(solution.iter()) {
            z[index] = value;
        }
        z[6] = 1.0;
        let centre = self.kinematics(0.5) * z;
        self.angle = self.angle.step(z[2], h);
        self.input = [0, 1].map(|k| self.input[k].step(z[k], h));
        self.centre = [0, 1].map(|k| self.centre[k].step(centre[k], h));
    }

    /// The position of the point at a fraction of the length, to first order in the angle.
    fn kinematics(&self, fraction: f64) -> SMatrix<f64, 2, 7> {
        let (s, c) = self.angle.position.sin_cos();
        let arm = fraction * self.length;
        let mut rows = SMatrix::<f64, 2, 7>::zeros();
        rows[(0, 0)] = 1.0;
        rows[(1, 1)] = 1.0;
        rows[(0, 2)] = -arm * s;
        rows[(1, 2)] = arm * c;
        rows[(0, 6)] = arm * (c + s * self.angle.position);
        rows[(1, 6)] = arm * (s - c * self.angle.position);
        rows
    }

    /// The transfer matrix from the rod's input to its output.
    fn transfer_matrix(&self, h: f64) -> SMatrix<f64, 7, 7> {
        let (mass, stiff) = (self.mass, 1.0 / (BETA * h * h));
        let inertia = mass * self.length * self.length / 3.0;
        let mut matrix = SMatrix::<f64, 7, 7>::zeros();
        matrix.fixed_view_mut::<2, 7>(0, 0).copy_from(&self.kinematics(1.0));
        matrix[(2, 2)] = 1.0;
        matrix[(6, 6)] = 1.0;
        // q_O = q_I − m r̈_C + m g, with r̈_C from the centre's position.
        let centre = self.kinematics(0.5);
        for k in 0..2 {
            for column in 0..7 {
                matrix[(4 + k, column)] = -mass * stiff * centre[(k, column)];
            }
            matrix[(4 + k, 4 + k)] += 1.0;
            matrix[(4 + k, 6)] -= mass * self.centre[k].constant(h);
        }
        matrix[(5, 6)] -= mass * self.gravity;
        // m_O = m_I − J_I θ̈ − r_IC × (m r̈_I − m g) − r_IO × q_O, at the predicted angle.
        let (s, c) = self.angle.position.sin_cos();
        let rotation = h * self.angle.rate;
        let arm = [c - s * rotation, s + c * rotation].map(|part| part * self.length);
        for column in 0..7 {
            let [x, y] = [matrix[(4, column)], matrix[(5, column)]];
            matrix[(3, column)] = -(arm[0] * y - arm[1] * x);
        }
        matrix[(3, 0)] += arm[1] / 2.0 * mass * stiff;
        matrix[(3, 1)] -= arm[0] / 2.0 * mass * stiff;
        matrix[(3, 2)] -= inertia * stiff;
        matrix[(3, 3)] += 1.0;
        let load = [self.input[0].constant(h), self.input[1].constant(h) + self.gravity];
        matrix[(3, 6)] -=
            inertia * self.angle.constant(h) + mass / 2.0 * (arm[0] * load[1] - arm[1] * load[0]);
        matrix
    }
}
