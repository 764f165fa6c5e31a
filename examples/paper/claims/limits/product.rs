//! The product of the paper's matrices as printed, in any precision.

use mstmm::Scalar;
use mstmm::paper::body::{Body, Load, Motion};
use mstmm::paper::chain::{self, InputEnd, OutputEnd};
use mstmm::paper::pin::{Blocks, Pin};
use mstmm::paper::{TransferMatrix, ball};
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::pose::{Joint, Placed, Pose, Real};
use crate::system::GRAVITY;

/// The binary digits of orientations and velocities before they are rounded to the precision of the product.
/// Generated code computes them in its own precision, so this favours the product.
const DIGITS: usize = 128;

/// The elements of a chain of cubes in a state, the factors of the product.
pub struct Product<T> {
    bodies: Vec<TransferMatrix<T>>,
    /// One per hinge; `None` for a ball.
    pins: Vec<Option<Pin<T>>>,
}

impl<T: Scalar> Product<T> {
    pub fn new(pose: &Pose) -> Self {
        let placed = pose.placed(DIGITS);
        let pin = |(joint, placed): (&Joint, &Placed)| match joint {
            Joint::Ball { .. } => None,
            Joint::Pin { axis, rate, .. } => {
                let axis = Vector3::from(*axis);
                let orientation = as_f64(&placed.rotation) * frame_about(&axis.normalize());
                Some(Pin {
                    orientation: orientation.map(T::constant),
                    angular_velocity: as_f64(&placed.angular_velocity).map(T::constant),
                    rate: T::constant(rate * axis.norm()),
                })
            }
        };
        Product {
            bodies: placed.iter().map(body).collect(),
            pins: pose.joints.iter().zip(&placed).map(pin).collect(),
        }
    }

    /// U₁ to U_n: hinge, body, hinge, body, ….
    pub fn elements(&self) -> Vec<TransferMatrix<T>> {
        let hinge = |k: usize| match self.pin_blocks(k) {
            None => ball::transfer_matrix(&self.bodies[k]),
            Some(blocks) => blocks.transfer_matrix(),
        };
        (0..self.bodies.len()).flat_map(|k| [hinge(k), self.bodies[k]]).collect()
    }

    /// E₀ to E₅ of a pin [P, Eq. (41)]. The last pin has no next pin, because the end of its body is free; its
    /// own axis is used instead.
    pub fn pin_blocks(&self, k: usize) -> Option<Blocks<T>> {
        let pin = self.pins[k]?;
        let next = self.pins.get(k + 1).copied().flatten().unwrap_or(pin);
        Some(pin.blocks(&self.bodies[k], &next.orientation))
    }

    /// The first pin's frame.
    pub fn first_frame(&self) -> Option<Matrix3<T>> {
        self.pins.first().copied().flatten().map(|pin| pin.orientation)
    }

    /// r̈ and Ω̇ of the inputs of all bodies by steps (iii) to (v) of [P, Section 2.4]. N is twice the number
    /// of bodies.
    pub fn accelerations<const N: usize>(&self) -> Vec<f64>
    where
        T: Into<f64>,
    {
        let mut elements = [SMatrix::from_element(T::default()); N];
        elements.iter_mut().zip(self.elements()).for_each(|(to, element)| *to = element);
        let free = OutputEnd::free();
        let states = match self.first_frame() {
            None => chain::solve(&elements, &InputEnd::ball(), &free).outputs,
            Some(frame) => chain::solve(&elements, &InputEnd::pin(&frame), &free).outputs,
        };
        // The output of each hinge is the input of its body.
        let inputs = states.iter().step_by(2);
        inputs.flat_map(|z| z.iter().take(6)).map(|&x| x.into()).collect()
    }
}

/// The moving cube of [P, Section 4.1] with its weight.
fn body<T: Scalar>(placed: &Placed) -> TransferMatrix<T> {
    let number = T::constant;
    let cube = Body {
        mass: number(1.0),
        com: Vector3::new(0.5, 0.0, 0.0).map(number),
        output: Vector3::new(1.0, 0.0, 0.0).map(number),
        inertia: Matrix3::from_diagonal(&Vector3::new(1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0))
            .map(number),
    };
    let motion = Motion {
        orientation: as_f64(&placed.rotation).map(number),
        angular_velocity: as_f64(&placed.angular_velocity).map(number),
    };
    let weight = Load {
        force: Vector3::new(0.0, -GRAVITY, 0.0).map(number),
        moment: Vector3::zeros().map(number),
    };
    cube.blocks(&motion, &weight).transfer_matrix()
}

/// The nearest `f64` values.
fn as_f64<const R: usize, const C: usize>(matrix: &SMatrix<Real, R, C>) -> SMatrix<f64, R, C> {
    matrix.map(|x| x.to_f64().value())
}

/// A rotation whose third column is `axis`.
fn frame_about(axis: &Vector3<f64>) -> Matrix3<f64> {
    let other = if axis.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() };
    let second = axis.cross(&other).normalize();
    Matrix3::from_columns(&[second.cross(axis), second, *axis])
}
