//! The planar pendulum of section 4.3, homogeneous rods in a row, by the methods of Figure 8: Lagrange's
//! equations, and a recursion of order n for any chain at run time.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// The length in m and the mass in kg of a rod.
pub const LENGTH: f64 = 1.0;
pub const MASS: f64 = 1.0;
/// The moment of inertia of a rod about its centre in kg m².
pub const INERTIA: f64 = MASS * LENGTH * LENGTH / 12.0;

/// The angles of the hinges in rad and their rates in rad/s. Gravity is in m/s².
pub struct Rods {
    pub gravity: f64,
    pub angles: Vec<f64>,
    pub rates: Vec<f64>,
}

impl Rods {
    /// The absolute angles and rates.
    fn absolute(&self) -> [DVector<f64>; 2] {
        [&self.angles, &self.rates].map(|relative| {
            let sums = relative.iter().scan(0.0, |sum, part| {
                *sum += part;
                Some(*sum)
            });
            DVector::from_iterator(relative.len(), sums)
        })
    }

    /// The hinges' accelerations by Lagrange's equations [P, Eq. (46)]. The off-diagonal entries have the mass
    /// outboard of both rods; the printed index is corrected.
    pub fn by_lagrange(&self) -> Vec<f64> {
        let count = self.angles.len();
        let [angles, rates] = self.absolute();
        let outboard = |j: usize| MASS * (count - 1 - j) as f64;
        let coupling = |i: usize, j: usize| LENGTH * LENGTH * (MASS / 2.0 + outboard(i.max(j)));
        let matrix = DMatrix::from_fn(count, count, |i, j| match i == j {
            true => (MASS / 4.0 + outboard(j)) * LENGTH * LENGTH + INERTIA,
            false => coupling(i, j) * (angles[i] - angles[j]).cos(),
        });
        let right = DVector::from_fn(count, |i, _| {
            let centrifugal: f64 = (0..count)
                .filter(|&j| j != i)
                .map(|j| coupling(i, j) * (angles[i] - angles[j]).sin() * rates[j] * rates[j])
                .sum();
            let weight = self.gravity * LENGTH * (MASS / 2.0 + outboard(i)) * angles[i].cos();
            -centrifugal - weight
        });
        // The mass matrix is positive definite.
        let Some(factors) = matrix.cholesky() else { return vec![f64::NAN; count] };
        let absolute = factors.solve(&right);
        (0..count).map(|i| absolute[i] - if i == 0 { 0.0 } else { absolute[i - 1] }).collect()
    }

    /// The same by articulated bodies, after Brandl, Johanni and Otter: velocities outward, inertias inward,
    /// accelerations outward. Vectors are `[x, y, rotation]` in the axes of each rod.
    pub fn by_recursion(&self, work: &mut Recursion) -> Vec<f64> {
        let count = self.angles.len();
        let mut omega = 0.0;
        for (k, (&angle, &rate)) in self.angles.iter().zip(&self.rates).enumerate() {
            let (sine, cosine) = angle.sin_cos();
            // From the input of the previous rod to the input of this rod, then into its axes.
            let arm = if k == 0 { 0.0 } else { LENGTH };
            let translation = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, arm, 0.0, 0.0, 1.0);
            let rotation = Matrix3::new(cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0);
            work.transforms[k] = rotation * translation;
            work.bias_accelerations[k] = rotation * Vector3::new(-arm * omega * omega, 0.0, 0.0);
            omega += rate;
            let centre = LENGTH / 2.0;
            work.inertias[k] = Matrix3::new(
                MASS,
                0.0,
                0.0,
                0.0,
                MASS,
                MASS * centre,
                0.0,
                MASS * centre,
                INERTIA + MASS * centre * centre,
            );
            work.loads[k] = Vector3::new(-MASS * centre * omega * omega, 0.0, 0.0);
        }
        for k in (0..count).rev() {
            let (inertia, load) = (work.inertias[k], work.loads[k]);
            let column: Vector3<f64> = inertia.column(2).into();
            let pivot = column[2];
            work.gains[k] = column / pivot;
            work.bias_rates[k] = -load[2] / pivot;
            if k > 0 {
                let reduced = inertia - work.gains[k] * column.transpose();
                let load =
                    load + reduced * work.bias_accelerations[k] + column * work.bias_rates[k];
                let transform = work.transforms[k];
                work.inertias[k - 1] += transform.transpose() * reduced * transform;
                work.loads[k - 1] += transform.transpose() * load;
            }
        }
        // Gravity is an acceleration of the ground.
        let mut acceleration = Vector3::new(0.0, self.gravity, 0.0);
        (0..count)
            .map(|k| {
                acceleration = work.transforms[k] * acceleration + work.bias_accelerations[k];
                let relative = work.bias_rates[k] - work.gains[k].dot(&acceleration);
                acceleration[2] += relative;
                relative
            })
            .collect()
    }
}

/// The memory for the recursion.
pub struct Recursion {
    transforms: Vec<Matrix3<f64>>,
    bias_accelerations: Vec<Vector3<f64>>,
    inertias: Vec<Matrix3<f64>>,
    loads: Vec<Vector3<f64>>,
    gains: Vec<Vector3<f64>>,
    bias_rates: Vec<f64>,
}

impl Recursion {
    pub fn new(count: usize) -> Self {
        Recursion {
            transforms: vec![Matrix3::zeros(); count],
            bias_accelerations: vec![Vector3::zeros(); count],
            inertias: vec![Matrix3::zeros(); count],
            loads: vec![Vector3::zeros(); count],
            gains: vec![Vector3::zeros(); count],
            bias_rates: vec![0.0; count],
        }
    }
}
