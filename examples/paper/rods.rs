//! The planar pendulum of section 4.3, homogeneous rods in a row, by the ways that Figure 8 compares:
//! Lagrange's equations, and a recursion of order n as one writes it for any chain at run time.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

/// Rods of 1 m and 1 kg.
pub const LENGTH: f64 = 1.0;
pub const MASS: f64 = 1.0;
/// About the centre.
pub const INERTIA: f64 = MASS * LENGTH * LENGTH / 12.0;

/// Angles of hinges and their rates, and room for results.
pub struct Rods {
    pub gravity: f64,
    pub angles: Vec<f64>,
    pub rates: Vec<f64>,
}

impl Rods {
    /// Absolute angles and rates.
    fn absolute(&self) -> [DVector<f64>; 2] {
        [&self.angles, &self.rates].map(|relative| {
            let sums = relative.iter().scan(0.0, |sum, part| {
                *sum += part;
                Some(*sum)
            });
            DVector::from_iterator(relative.len(), sums)
        })
    }

    /// The hinges' accelerations by Lagrange's equations [P, Eq. (46)], with the mass beyond both rods
    /// in the off-diagonal entries, whatever the printed index says.
    pub fn by_lagrange(&self) -> Vec<f64> {
        let count = self.angles.len();
        let [angles, rates] = self.absolute();
        let beyond = |j: usize| MASS * (count - 1 - j) as f64;
        let coupling = |i: usize, j: usize| LENGTH * LENGTH * (MASS / 2.0 + beyond(i.max(j)));
        let matrix = DMatrix::from_fn(count, count, |i, j| match i == j {
            true => (MASS / 4.0 + beyond(j)) * LENGTH * LENGTH + INERTIA,
            false => coupling(i, j) * (angles[i] - angles[j]).cos(),
        });
        let right = DVector::from_fn(count, |i, _| {
            let centrifugal: f64 = (0..count)
                .filter(|&j| j != i)
                .map(|j| coupling(i, j) * (angles[i] - angles[j]).sin() * rates[j] * rates[j])
                .sum();
            let weight = self.gravity * LENGTH * (MASS / 2.0 + beyond(i)) * angles[i].cos();
            -centrifugal - weight
        });
        // A mass matrix is positive definite.
        let Some(factors) = matrix.cholesky() else { return vec![f64::NAN; count] };
        let absolute = factors.solve(&right);
        (0..count).map(|i| absolute[i] - if i == 0 { 0.0 } else { absolute[i - 1] }).collect()
    }

    /// The same by articulated bodies, after Brandl, Johanni and Otter: outwards velocities, inwards
    /// inertias, outwards accelerations. Vectors are `[x, y, turn]` in axes of each rod.
    pub fn by_recursion(&self, work: &mut Recursion) -> Vec<f64> {
        let count = self.angles.len();
        let mut omega = 0.0;
        for (k, (&angle, &rate)) in self.angles.iter().zip(&self.rates).enumerate() {
            let (sine, cosine) = angle.sin_cos();
            // From the input of the rod before to this one's, then into its axes.
            let arm = if k == 0 { 0.0 } else { LENGTH };
            let shift = Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, arm, 0.0, 0.0, 1.0);
            let turn = Matrix3::new(cosine, sine, 0.0, -sine, cosine, 0.0, 0.0, 0.0, 1.0);
            work.transforms[k] = turn * shift;
            work.drifts[k] = turn * Vector3::new(-arm * omega * omega, 0.0, 0.0);
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
            work.rests[k] = -load[2] / pivot;
            if k > 0 {
                let reduced = inertia - work.gains[k] * column.transpose();
                let load = load + reduced * work.drifts[k] + column * work.rests[k];
                let transform = work.transforms[k];
                work.inertias[k - 1] += transform.transpose() * reduced * transform;
                work.loads[k - 1] += transform.transpose() * load;
            }
        }
        // Gravity as an acceleration of the ground.
        let mut acceleration = Vector3::new(0.0, self.gravity, 0.0);
        (0..count)
            .map(|k| {
                acceleration = work.transforms[k] * acceleration + work.drifts[k];
                let own = work.rests[k] - work.gains[k].dot(&acceleration);
                acceleration[2] += own;
                own
            })
            .collect()
    }
}

/// Room for the recursion.
pub struct Recursion {
    transforms: Vec<Matrix3<f64>>,
    drifts: Vec<Vector3<f64>>,
    inertias: Vec<Matrix3<f64>>,
    loads: Vec<Vector3<f64>>,
    gains: Vec<Vector3<f64>>,
    rests: Vec<f64>,
}

impl Recursion {
    pub fn new(count: usize) -> Self {
        Recursion {
            transforms: vec![Matrix3::zeros(); count],
            drifts: vec![Vector3::zeros(); count],
            inertias: vec![Matrix3::zeros(); count],
            loads: vec![Vector3::zeros(); count],
            gains: vec![Vector3::zeros(); count],
            rests: vec![0.0; count],
        }
    }
}
