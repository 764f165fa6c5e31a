//! Chains of the paper's cubes in states that are known exactly, and what each way is given of them.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use mstmm_reference::Random;
use nalgebra::{Matrix3, Vector3};

/// A binary number of as many digits as the numbers that it is computed from.
pub type Real = FBig<HalfEven>;

/// How a hinge is turned and turns. All numbers are exact, so that no rounding enters before a way
/// takes them over into its own precision.
pub enum Joint {
    /// The quaternion w, x, y, z, of any length, turns outboard components into inboard ones; the rate
    /// is that of the outboard side in rad/s, outboard axes.
    Ball { quaternion: [f64; 4], rate: [f64; 3] },
    /// About an axis of any length, with the tangent of half the angle and the rate in rad/s for an
    /// axis of length one.
    Pin { axis: [f64; 3], tangent: f64, rate: f64 },
}

/// A state of a chain of cubes that hangs on the ground, a hinge for each cube.
pub struct Pose {
    pub joints: Vec<Joint>,
}

/// How a cube is turned and turns, inertial frame.
pub struct Placed {
    pub rotation: Matrix3<Real>,
    pub spin: Vector3<Real>,
}

/// The number itself, to so many binary digits from here on.
pub fn exact(value: f64, digits: usize) -> Real {
    // Only what is not finite cannot be converted, and nothing here is.
    Real::try_from(value).unwrap_or_default().with_precision(digits).value()
}

pub fn exact_vector(vector: &[f64; 3], digits: usize) -> Vector3<Real> {
    Vector3::from(*vector).map(|x| exact(x, digits))
}

impl Pose {
    /// Cubes on balls, anyhow.
    pub fn of_balls(count: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let joint = |_| Joint::Ball {
            quaternion: [(); 4].map(|()| random.between(-1.0, 1.0)),
            rate: [(); 3].map(|()| random.between(-2.0, 2.0)),
        };
        Pose { joints: (0..count).map(joint).collect() }
    }

    /// Cubes on pins about these axes, anyhow.
    pub fn of_pins(axes: impl IntoIterator<Item = [f64; 3]>, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let joint = |axis| Joint::Pin {
            axis,
            tangent: random.between(-1.0, 1.0),
            rate: random.between(-2.0, 2.0),
        };
        Pose { joints: axes.into_iter().map(joint).collect() }
    }

    /// Coordinates of all hinges, and their rates, as generated code takes them.
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

    /// The motion of every cube to so many binary digits.
    pub fn placed(&self, digits: usize) -> Vec<Placed> {
        let (mut rotation, mut spin) = (Matrix3::identity(), Vector3::zeros());
        let place = |joint: &Joint| {
            rotation = &rotation * joint.rotation(digits);
            spin += &rotation * joint.rate(digits);
            Placed { rotation: rotation.clone(), spin: spin.clone() }
        };
        self.joints.iter().map(place).collect()
    }
}

impl Joint {
    /// Of the outboard side against the inboard one, outboard axes.
    fn rate(&self, digits: usize) -> Vector3<Real> {
        match self {
            Joint::Ball { rate, .. } => exact_vector(rate, digits),
            Joint::Pin { axis, rate, .. } => exact_vector(axis, digits) * exact(*rate, digits),
        }
    }

    /// Turns outboard components into inboard ones: (w² − v·v) I + 2 v vᵀ + 2 w ṽ over the square of
    /// the quaternion's length, without a root or a sine.
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
        let turned = Matrix3::identity() * (&ww - &vv)
            + &v * v.transpose() * twice.clone()
            + crossing(&v) * (w * twice);
        turned / (ww + vv)
    }
}

/// ṽ, the matrix of the cross product v × ….
pub fn crossing(v: &Vector3<Real>) -> Matrix3<Real> {
    let columns = [Vector3::x(), Vector3::y(), Vector3::z()].map(|unit| v.cross(&unit));
    Matrix3::from_columns(&columns)
}
