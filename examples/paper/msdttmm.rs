//! The original method that the paper compares with, the discrete time transfer matrix method of
//! multibody systems (MSDTTMM), for a rod on a hinge in the plane.
//!
//! Its state vector holds positions, `z = [x, y, θ, m, q_x, q_y, 1]`. In every step Newmark's formulas
//! make accelerations of the positions sought, and what is not linear in them is replaced by Taylor
//! series about the step before: that is the error that the paper's Table 1 shows. Of the variants in
//! the literature this is the plain one: β = 1/4, γ = 1/2, kinematics to first order in the angle,
//! arms of forces at the angle that the rate before predicts, also to first order.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Newmark's parameters: the mean acceleration of a step.
const BETA: f64 = 0.25;
const GAMMA: f64 = 0.5;

/// How a coordinate moves at a time.
#[derive(Clone, Copy)]
struct Motion {
    at: f64,
    rate: f64,
    acceleration: f64,
}

impl Motion {
    /// The constant part of the acceleration that Newmark's formula gives for a position `x` after a
    /// step: `ẍ = x / (β h²) + rest`.
    fn rest(self, h: f64) -> f64 {
        let Motion { at, rate, acceleration } = self;
        -(at + h * rate + (0.5 - BETA) * h * h * acceleration) / (BETA * h * h)
    }

    /// The motion after a step that leads to this position.
    fn step(self, at: f64, h: f64) -> Motion {
        let acceleration = at / (BETA * h * h) + self.rest(h);
        let mean = (1.0 - GAMMA) * self.acceleration + GAMMA * acceleration;
        Motion { at, rate: self.rate + h * mean, acceleration }
    }
}

/// A homogeneous rod that is hung at its start.
pub struct Rod {
    pub mass: f64,
    pub length: f64,
    pub gravity: f64,
    /// Of the angle against the horizontal.
    angle: Motion,
    /// Of its start, which the hinge holds.
    input: [Motion; 2],
    /// Of the centre of mass.
    centre: [Motion; 2],
}

impl Rod {
    /// At an angle in rad with a rate in rad/s.
    pub fn new(mass: f64, length: f64, gravity: f64, angle: f64, rate: f64) -> Self {
        // J θ̈ = −m g l cos θ / 2 about the hinge, J = m l²/3.
        let acceleration = -1.5 * gravity / length * angle.cos();
        let (s, c) = angle.sin_cos();
        let half = length / 2.0;
        let along = |at: f64, across: f64, to_centre: f64| Motion {
            at: half * at,
            rate: half * rate * across,
            acceleration: half * (acceleration * across + rate * rate * to_centre),
        };
        Rod {
            mass,
            length,
            gravity,
            angle: Motion { at: angle, rate, acceleration },
            input: [Motion { at: 0.0, rate: 0.0, acceleration: 0.0 }; 2],
            centre: [along(c, -s, -c), along(s, c, -s)],
        }
    }

    pub fn angle(&self) -> f64 {
        self.angle.at
    }

    /// One step of length `h`.
    pub fn step(&mut self, h: f64) {
        let transfer = self.transfer_matrix(h);
        // At the hinge x = y = m = 0; at the free end m = q = 0. Unknown are θ, q_x and q_y.
        let unknowns = [2, 4, 5];
        let conditions = [3, 4, 5];
        let left = Matrix3::from_fn(|i, k| transfer[(conditions[i], unknowns[k])]);
        let right = Vector3::from_fn(|i, _| -transfer[(conditions[i], 6)]);
        // Regular for every positive step: the mass matrix over β h² outweighs the rest.
        let Some(solution) = left.lu().solve(&right) else { return };
        let mut z = SVector::<f64, 7>::zeros();
        for (&place, &value) in unknowns.iter().zip(solution.iter()) {
            z[place] = value;
        }
        z[6] = 1.0;
        let centre = self.kinematics(0.5) * z;
        self.angle = self.angle.step(z[2], h);
        self.input = [0, 1].map(|k| self.input[k].step(z[k], h));
        self.centre = [0, 1].map(|k| self.centre[k].step(centre[k], h));
    }

    /// Positions of the point at a fraction of the length, to first order in the angle.
    fn kinematics(&self, fraction: f64) -> SMatrix<f64, 2, 7> {
        let (s, c) = self.angle.at.sin_cos();
        let arm = fraction * self.length;
        let mut rows = SMatrix::<f64, 2, 7>::zeros();
        rows[(0, 0)] = 1.0;
        rows[(1, 1)] = 1.0;
        rows[(0, 2)] = -arm * s;
        rows[(1, 2)] = arm * c;
        rows[(0, 6)] = arm * (c + s * self.angle.at);
        rows[(1, 6)] = arm * (s - c * self.angle.at);
        rows
    }

    /// From the rod's input to its output.
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
            matrix[(4 + k, 6)] -= mass * self.centre[k].rest(h);
        }
        matrix[(5, 6)] -= mass * self.gravity;
        // m_O = m_I − J_I θ̈ − r_IC × (m r̈_I − m g) − r_IO × q_O, at the angle that is predicted.
        let (s, c) = self.angle.at.sin_cos();
        let turn = h * self.angle.rate;
        let arm = [c - s * turn, s + c * turn].map(|part| part * self.length);
        for column in 0..7 {
            let [x, y] = [matrix[(4, column)], matrix[(5, column)]];
            matrix[(3, column)] = -(arm[0] * y - arm[1] * x);
        }
        matrix[(3, 0)] += arm[1] / 2.0 * mass * stiff;
        matrix[(3, 1)] -= arm[0] / 2.0 * mass * stiff;
        matrix[(3, 2)] -= inertia * stiff;
        matrix[(3, 3)] += 1.0;
        let load = [self.input[0].rest(h), self.input[1].rest(h) + self.gravity];
        matrix[(3, 6)] -=
            inertia * self.angle.rest(h) + mass / 2.0 * (arm[0] * load[1] - arm[1] * load[0]);
        matrix
    }
}
