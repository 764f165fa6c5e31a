//! Chains of the paper's cubes in exactly known states, and these states for each method.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use mstmm_reference::Random;
use nalgebra::{Matrix3, Vector3};

/// A binary number with the number of digits of its operands.
pub type Real = FBig<HalfEven>;

/// The coordinates and rates of a hinge. All values are exact: the only rounding is that to the precision
/// of each method.
pub enum Joint {
    /// The quaternion w, x, y, z, of any length, transforms outboard components to inboard ones. The rate is
    /// that of the outboard side in rad/s, in outboard axes.
    Ball { quaternion: [f64; 4], rate: [f64; 3] },
    /// A pin about an axis of any length, with the tangent of half the angle and the rate in rad/s, both for
    /// an axis of length one.
    Pin { axis: [f64; 3], tangent: f64, rate: f64 },
}

/// A state of a chain of cubes on the ground, with one hinge per cube.
pub struct Pose {
    pub joints: Vec<Joint>,
}

/// The orientation and the angular velocity of a cube in the inertial frame.
pub struct Placed {
    pub rotation: Matrix3<Real>,
    pub angular_velocity: Vector3<Real>,
}

/// The value itself, as a number with this precision in binary digits.
pub fn exact(value: f64, digits: usize) -> Real {
    // Only values that are not finite cannot be converted, and all values here are finite.
    Real::try_from(value).unwrap_or_default().with_precision(digits).value()
}

pub fn exact_vector(vector: &[f64; 3], digits: usize) -> Vector3<Real> {
    Vector3::from(*vector).map(|x| exact(x, digits))
}

impl Pose {
    /// A random state of cubes on balls.
    pub fn of_balls(count: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let joint = |_| Joint::Ball {
            quaternion: [(); 4].map(|()| random.between(-1.0, 1.0)),
            rate: [(); 3].map(|()| random.between(-2.0, 2.0)),
        };
        Pose { joints: (0..count).map(joint).collect() }
    }

    /// A random state of cubes on pins about these axes.
    pub fn of_pins(axes: impl IntoIterator<Item = [f64; 3]>, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let joint = |axis| Joint::Pin {
            axis,
            tangent: random.between(-1.0, 1.0),
            rate: random.between(-2.0, 2.0),
        };
        Pose { joints: axes.into_iter().map(joint).collect() }
    }

    /// The coordinates of all hinges and their rates for generated code.
    pub fn coordinates(&self) -> (Vec<f64>, Vec<f64>) {
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for joint in &self.joints {
            match joint {
                Joint::Ball { quaternion, rate } => {
                    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
                    q.extend(quaternion.map(|x| x / length));
                    v.extend(rate);
                }
                Joint::Pin { axis, tangent, rate } => {
                    let length = Vector3::from(*axis).norm();
                    q.push(2.0 * (tangent * length).atan());
                    v.push(rate * length);
                }
            }
        }
        (q, v)
    }

    /// The motion of every cube with this precision in binary digits.
    pub fn placed(&self, digits: usize) -> Vec<Placed> {
        let (mut rotation, mut angular_velocity) = (Matrix3::identity(), Vector3::zeros());
        let placed = |joint: &Joint| {
            rotation = &rotation * joint.rotation(digits);
            angular_velocity += &rotation * joint.rate(digits);
            Placed { rotation: rotation.clone(), angular_velocity: angular_velocity.clone() }
        };
        self.joints.iter().map(placed).collect()
    }
}

impl Joint {
    /// The angular velocity of the outboard side relative to the inboard side, in outboard axes.
    fn rate(&self, digits: usize) -> Vector3<Real> {
        match self {
            Joint::Ball { rate, .. } => exact_vector(rate, digits),
            Joint::Pin { axis, rate, .. } => exact_vector(axis, digits) * exact(*rate, digits),
        }
    }

    /// The rotation from outboard to inboard components: (w² − v·v) I + 2 v vᵀ + 2 w ṽ over the square of the
    /// quaternion's length. It needs no root and no sine.
    fn rotation(&self, digits: usize) -> Matrix3<Real> {
        let (w, v) = match self {
            Joint::Ball { quaternion: [w, vector @ ..], .. } => {
                (exact(*w, digits), exact_vector(vector, digits))
            }
            Joint::Pin { axis, tangent, .. } => {
                (exact(1.0, digits), exact_vector(axis, digits) * exact(*tangent, digits))
            }
        };
        let (ww, vv) = (&w * &w, v.dot(&v));
        let twice = exact(2.0, digits);
        let rotation = Matrix3::identity() * (&ww - &vv)
            + &v * v.transpose() * twice.clone()
            + crossing(&v) * (w * twice);
        rotation / (ww + vv)
    }
}

/// ṽ, the matrix of the cross product v × ….
pub fn crossing(v: &Vector3<Real>) -> Matrix3<Real> {
    let columns = [Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| v.cross(&unit));
    Matrix3::from_columns(&columns)
}
