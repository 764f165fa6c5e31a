//! Computed torque of the Panda with an estimate of its payload, for `computed_torque.rs` in `f64` and for `firmware/` in
//! `f32`: generic over the scalar, without allocations, and in optimised code without panics.

use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{ChainState, Error, Scalar, mstmm_chain};

include!("panda.rs");

panda! {
    /// The Franka Emika Panda with a hand, which holds a payload of small size at its centre of mass.
    pub chain Arm {
        bodies {
            answers = [inverse_dynamics, regressor];
            param payload = 0 kg;
            body Hand { mass = 0.7 kg + payload; com = [0, 0, 0.1] m; inertia = diag(2, 2, 1) g*m^2 about com; }
        }
        route { -> weld flange -> Hand hand }
    }
}

/// One value for each joint.
pub type Joints<T> = SVector<T, 7>;

/// The bandwidth ω of the controller in rad/s: an error decays as e^(−ω t).
const BANDWIDTH: f64 = 20.0;

/// The middle and the amplitude of the motion of each joint in rad.
const MIDDLE: [f64; 7] = [0.0, -0.5, 0.0, -2.0, 0.0, 1.6, 0.8];
const AMPLITUDE: [f64; 7] = [0.6, 0.4, 0.5, 0.4, 0.6, 0.5, 0.7];
/// The frequency of the motion of each joint in rad/s.
const FREQUENCY: [f64; 7] = [1.0, 1.3, 1.6, 1.9, 2.2, 2.5, 2.8];

/// The standard deviation of measured torques in N m.
pub const TORQUE_DEVIATION: f64 = 0.1;
/// The standard deviations of the payload's parameters about zero before the first sample: of the mass in kg, the first
/// moments in kg m and the inertia in kg m². They weight the assumption that there is no payload.
pub const PRIOR_DEVIATIONS: [f64; 10] = [10.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];

/// Returns angles, rates and accelerations of the desired motion at a time in s.
pub fn desired<T: Scalar>(time: T) -> [Joints<T>; 3] {
    let [middle, amplitude, frequency] =
        [MIDDLE, AMPLITUDE, FREQUENCY].map(|values| values.map(T::constant));
    let (sines, cosines) = T::sin_cos(frequency.map(|frequency| frequency * time));
    [
        core::array::from_fn(|i| middle[i] + amplitude[i] * sines[i]),
        core::array::from_fn(|i| amplitude[i] * frequency[i] * cosines[i]),
        core::array::from_fn(|i| (amplitude[i] * frequency[i] * frequency[i] * sines[i]).negate()),
    ]
    .map(Joints::from)
}

/// Returns the inputs of the arm with these torques in N m.
pub fn inputs<T: Scalar>(torques: &Joints<T>) -> ArmInputs<T> {
    let [j1, j2, j3, j4, j5, j6, j7] = (*torques).into();
    ArmInputs { j1, j2, j3, j4, j5, j6, j7 }
}

/// A controller that follows the desired motion, and estimates what the hand carries.
pub struct Control<T: Scalar> {
    /// The arm with the payload that the controller assumes.
    model: Arm<T>,
    /// The arm without a payload, with which measured torques are compared.
    unloaded: Arm<T>,
    estimate: Estimate<T>,
    /// The regressor of the last sample, not on the stack.
    regressor: SMatrix<T, 7, 80>,
}

impl<T: Scalar<Mask = bool>> Control<T> {
    /// Returns a controller that assumes no payload.
    pub fn new() -> Self {
        let regressor = [[T::constant(0.0); 7]; 80];
        Self {
            model: Arm::new(),
            unloaded: Arm::new(),
            estimate: Estimate::new(),
            regressor: SMatrix::from(regressor),
        }
    }

    /// Computes the torques in N m by which the arm follows the desired motion: those of inverse dynamics for the desired
    /// accelerations and a correction, by which an error decays as e^(−ω t).
    pub fn torques_into(&self, state: &ArmState<T>, torques: &mut Joints<T>) -> Result<(), Error> {
        let [q, v, a] = desired(state.time());
        let (damping, stiffness) =
            (T::constant(2.0 * BANDWIDTH), T::constant(BANDWIDTH * BANDWIDTH));
        let commanded = core::array::from_fn(|i| {
            a[i] + (v[i] - state.v[i]) * damping + (q[i] - state.q[i]) * stiffness
        });
        let none = self.model.no_inputs();
        self.model.inverse_dynamics_into(state, &Joints::from(commanded), &none, torques)
    }

    /// Adds a sample to the estimate: the accelerations in rad/s² that the arm had in a state under torques in N m, as
    /// encoders and torque sensors measure them. An error leaves the estimate unchanged.
    pub fn observe(
        &mut self,
        state: &ArmState<T>,
        accelerations: &Joints<T>,
        torques: &Joints<T>,
    ) -> Result<(), Error> {
        let none = self.unloaded.no_inputs();
        let mut expected = Joints::from([T::constant(0.0); 7]);
        self.unloaded.inverse_dynamics_into(state, accelerations, &none, &mut expected)?;
        self.compute_regressor(state, accelerations)?;
        if let Some(hand) = self.regressor.data.0.last_chunk() {
            self.estimate.add(hand, &core::array::from_fn(|i| torques[i] - expected[i]));
        }
        Ok(())
    }

    /// Not inlined: its frame is the largest, and is then not on the stack while other functions run.
    #[inline(never)]
    fn compute_regressor(
        &mut self,
        state: &ArmState<T>,
        accelerations: &Joints<T>,
    ) -> Result<(), Error> {
        let none = self.unloaded.no_inputs();
        self.unloaded.regressor_into(state, accelerations, &none, &mut self.regressor)
    }

    /// Returns the dynamic parameters of the payload: mass in kg, first moments in kg m and inertia in kg m² about the
    /// input of the hand, in its axes.
    pub fn payload(&self) -> [T; 10] {
        self.estimate.solution()
    }

    /// Returns the standard deviations of these parameters, if the errors of the torques are independent.
    pub fn deviations(&self) -> [T; 10] {
        self.estimate.deviations()
    }

    /// Lets the model carry the estimated mass, at the centre of mass of the hand.
    pub fn use_estimate(&mut self) -> Result<(), Error> {
        let [mass, ..] = self.payload();
        self.model.set_payload(mass)
    }
}

/// The largest sum of squares of the entries of a sample: products of larger entries could overflow in `f32`.
const LARGEST_SQUARES: f64 = 1e20;

/// The least-squares estimate of ten parameters, updated with each sample.
///
/// The sum of the squared errors of all equations is `Σ d_i (r_i · x − z_i)²` and a constant: the rows `r_i` are a triangle
/// with ones on its diagonal. Givens rotations without square roots add an equation (Gentleman 1973, *Least squares
/// computations by Givens transformations without square roots*). Rounding errors grow with the condition number of the
/// equations; those of the normal equations grow with its square, which is large in slow motions: the inertia then hardly
/// changes the torques.
struct Estimate<T> {
    /// The rows `r_i`, with `z_i` as the last column.
    rows: [[T; 11]; 10],
    /// The weights `d_i`.
    weights: [T; 10],
}

impl<T: Scalar<Mask = bool>> Estimate<T> {
    /// Returns the estimate before the first sample.
    fn new() -> Self {
        let entry = |row, column| T::constant(if row == column { 1.0 } else { 0.0 });
        Self {
            rows: core::array::from_fn(|row| core::array::from_fn(|column| entry(row, column))),
            weights: PRIOR_DEVIATIONS.map(|deviation| {
                let ratio = TORQUE_DEVIATION / deviation;
                T::constant(ratio * ratio)
            }),
        }
    }

    /// Adds the equations of the joints: columns of the regressor, and the torques that the parameters explain. A sample
    /// with entries of more than 10¹⁰ is left out.
    fn add(&mut self, columns: &[[T; 7]; 10], torques: &[T; 7]) {
        let entries = columns.iter().chain([torques]).flatten();
        let squares = entries.fold(T::constant(0.0), |sum, &entry| entry.mul_add(entry, sum));
        if T::constant(LARGEST_SQUARES).simd_gt(squares) {
            for joint in 0..7 {
                let mut equation = [torques[joint]; 11];
                let entries = equation.iter_mut().zip(columns);
                entries.for_each(|(entry, column)| *entry = column[joint]);
                self.rotate(equation);
            }
        }
    }

    /// Rotates an equation into the triangle.
    fn rotate(&mut self, mut equation: [T; 11]) {
        let mut weight = T::constant(1.0);
        for pivot in 0..10 {
            let entry = equation[pivot];
            let weighted = weight * entry;
            let sum = weighted.mul_add(entry, self.weights[pivot]);
            // Not by zero, since weights begin above zero and never shrink.
            let inverse = sum.recip();
            let sine = weighted * inverse;
            weight *= self.weights[pivot] * inverse;
            self.weights[pivot] = sum;
            let others = self.rows[pivot].iter_mut().zip(&mut equation).skip(pivot + 1);
            for (upper, lower) in others {
                *lower = entry.mul_neg_add(*upper, *lower);
                *upper = sine.mul_add(*lower, *upper);
            }
        }
    }

    /// Returns the parameters with the least sum of squares.
    fn solution(&self) -> [T; 10] {
        let mut solution = [T::constant(0.0); 10];
        for pivot in (0..10).rev() {
            let row = &self.rows[pivot];
            let known = row.iter().zip(&solution).skip(pivot + 1);
            solution[pivot] = known.fold(row[10], |rest, (&entry, &x)| entry.mul_neg_add(x, rest));
        }
        solution
    }

    /// Returns the square roots of the diagonal of the inverse of the normal matrix, times the deviation of the torques.
    fn deviations(&self) -> [T; 10] {
        core::array::from_fn(|parameter| {
            // Solves the transposed triangle for a unit vector: its columns are the rows.
            let mut rest = [T::constant(0.0); 10];
            rest[parameter] = T::constant(TORQUE_DEVIATION);
            let mut squares = T::constant(0.0);
            for pivot in parameter..10 {
                let entry = rest[pivot];
                squares += entry * entry * self.weights[pivot].recip();
                let others = rest.iter_mut().zip(&self.rows[pivot]).skip(pivot + 1);
                others.for_each(|(rest, &of_row)| *rest = entry.mul_neg_add(of_row, *rest));
            }
            squares.sqrt()
        })
    }
}
