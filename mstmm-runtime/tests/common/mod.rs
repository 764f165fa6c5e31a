//! Mechanical systems written by hand whose motion is known in closed form.
#![allow(dead_code, reason = "each test uses a part")]

use mstmm_runtime::description::Origin;
use mstmm_runtime::{Chain, ChainState, Error, Scalar};

/// A state with `Q` coordinates and `V` rates.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T, const Q: usize, const V: usize> {
    pub q: [T; Q],
    pub v: [T; V],
    pub t: T,
}

impl<T: Scalar, const Q: usize, const V: usize> Default for State<T, Q, V> {
    fn default() -> Self {
        // What buffers hold at first must not matter.
        let nan = T::constant(f64::NAN);
        Self { q: [nan; Q], v: [nan; V], t: nan }
    }
}

impl<T: Scalar, const Q: usize, const V: usize> ChainState for State<T, Q, V> {
    type Scalar = T;

    fn coordinates(&self) -> &[T] {
        &self.q
    }

    fn coordinates_mut(&mut self) -> &mut [T] {
        &mut self.q
    }

    fn rates(&self) -> &[T] {
        &self.v
    }

    fn rates_mut(&mut self) -> &mut [T] {
        &mut self.v
    }

    fn time(&self) -> T {
        self.t
    }

    fn set_time(&mut self, time: T) {
        self.t = time;
    }
}

/// θ̈ = u − sin θ. With the input of [`swing`] it moves as θ = sin t.
pub struct Pendulum<T> {
    /// Where θ reaches this angle nothing has inertia; for tests of errors.
    pub singular_beyond: T,
}

impl<T: Scalar> Pendulum<T> {
    pub fn new() -> Self {
        Self { singular_beyond: T::constant(f64::INFINITY) }
    }

    pub fn no_inputs(&self) -> T {
        T::default()
    }

    pub fn at(angle: f64, rate: f64) -> State<T, 1, 1> {
        State { q: [T::constant(angle)], v: [T::constant(rate)], t: T::default() }
    }
}

/// Returns the origin of the first value that is not finite.
fn first_of<T: Scalar>([angle, rate, _]: [T; 3]) -> Origin {
    let is_wrong = |value: T| !mstmm_runtime::Mask::all(value.is_finite());
    match (is_wrong(angle), is_wrong(rate)) {
        (true, _) => Origin::Coordinate(0),
        (false, true) => Origin::Rate(0),
        (false, false) => Origin::Input(0),
    }
}

impl<T: Scalar> Chain for Pendulum<T> {
    type Scalar = T;
    type State = State<T, 1, 1>;
    type Inputs = T;

    fn derivative_into(
        &self,
        state: &Self::State,
        inputs: &T,
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        let ([angle], [speed]) = (state.q, state.v);
        if !mstmm_runtime::Mask::all(angle.is_finite() & speed.is_finite() & inputs.is_finite()) {
            return Err(Error::NotFinite(first_of([angle, speed, *inputs])));
        }
        if mstmm_runtime::Mask::all(angle.simd_gt(self.singular_beyond)) {
            return Err(Error::Singular { hinge: "pivot" });
        }
        let ([sine], _) = T::sin_cos([angle]);
        rate.q = [speed];
        rate.v = [*inputs - sine];
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State) {
        rate.q = state.v;
    }

    fn normalize(&self, _state: &mut Self::State) {}
}

/// The torque that makes the pendulum swing as θ = sin t.
pub fn swing<T: Scalar>(time: T) -> T {
    let ([wanted], _) = T::sin_cos([time]);
    let ([sine], _) = T::sin_cos([wanted]);
    sine - wanted
}

/// ẍ = u − k x − c ẋ: a unit mass on a spring and a damper.
pub struct Spring<T> {
    pub stiffness: T,
    pub damping: T,
}

impl<T: Scalar> Spring<T> {
    pub fn new(stiffness: f64, damping: f64) -> Self {
        Self { stiffness: T::constant(stiffness), damping: T::constant(damping) }
    }

    pub fn at(position: f64, velocity: f64) -> State<T, 1, 1> {
        Pendulum::at(position, velocity)
    }
}

impl<T: Scalar> Chain for Spring<T> {
    type Scalar = T;
    type State = State<T, 1, 1>;
    type Inputs = T;

    fn derivative_into(
        &self,
        state: &Self::State,
        inputs: &T,
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        let ([x], [v]) = (state.q, state.v);
        rate.q = [v];
        rate.v = [*inputs - self.stiffness * x - self.damping * v];
        Ok(())
    }

    fn implicit_derivative_into(
        &self,
        state: &Self::State,
        inputs: &T,
        step: T,
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        self.derivative_into(state, inputs, rate)?;
        let ahead = step * self.stiffness;
        let inertia = T::constant(1.0) + step * (self.damping + ahead);
        rate.v = [(rate.v[0] - ahead * state.v[0]) * inertia.recip()];
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State) {
        rate.q = state.v;
    }

    fn normalize(&self, _state: &mut Self::State) {}
}

/// The distance of an undamped spring of unit stiffness, let go at 1 at time zero, from cos t and
/// −sin t.
pub fn spring_error(state: &State<f64, 1, 1>) -> f64 {
    (state.q[0] - state.t.cos()).abs().max((state.v[0] + state.t.sin()).abs())
}

/// A rigid body with moments of inertia 1, 1 and `axial`: quaternion w, x, y, z and the angular
/// velocity in the body. It is free, or a ball holds a point of its z axis.
pub struct Top<T> {
    pub axial: T,
    /// Weight times the distance of the centre of mass from the ball, positive where it stands up.
    pub weight: T,
}

impl<T: Scalar> Top<T> {
    pub fn new() -> Self {
        Self { axial: T::constant(2.0), weight: T::default() }
    }

    /// A pendulum in space.
    pub fn hanging() -> Self {
        Self { axial: T::constant(0.3), weight: T::constant(-2.0) }
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, state: &State<T, 4, 3>) -> T {
        let [a, b, c] = state.v;
        let half = T::constant(0.5);
        let [_, _, up] = vertical(state.q);
        half * (a * a + b * b + self.axial * c * c) + self.weight * up
    }

    pub fn start() -> State<T, 4, 3> {
        let [w, x, y, z] = START.map(T::constant);
        State { q: [w, x, y, z], v: RATE.map(T::constant), t: T::default() }
    }
}

/// The inertial z axis in the body.
fn vertical<T: Scalar>([w, x, y, z]: [T; 4]) -> [T; 3] {
    let (one, two) = (T::constant(1.0), T::constant(2.0));
    [two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)]
}

/// Of unit length: 16 + 4 + 4 + 1 = 25.
const START: [f64; 4] = [0.8, 0.4, -0.4, 0.2];
const RATE: [f64; 3] = [0.7, 0.3, 1.1];

impl<T: Scalar> Chain for Top<T> {
    type Scalar = T;
    type State = State<T, 4, 3>;
    type Inputs = ();

    fn derivative_into(
        &self,
        state: &Self::State,
        (): &(),
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        self.configuration_rate_into(state, rate);
        let [a, b, c] = state.v;
        let difference = T::constant(1.0) - self.axial;
        let [east, north, _] = vertical(state.q);
        rate.v = [
            difference * b * c + self.weight * north,
            -(difference * c * a) - self.weight * east,
            T::default(),
        ];
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State) {
        let ([w, x, y, z], [a, b, c]) = (state.q, state.v);
        let half = T::constant(0.5);
        rate.q = [
            -half * (x * a + y * b + z * c),
            half * (w * a + y * c - z * b),
            half * (w * b + z * a - x * c),
            half * (w * c + x * b - y * a),
        ];
    }

    /// One step of Newton's method, as generated chains do.
    fn normalize(&self, state: &mut Self::State) {
        let square = state.q.iter().fold(T::default(), |sum, &x| sum + x * x);
        let factor = T::constant(1.5) - T::constant(0.5) * square;
        state.q = state.q.map(|x| x * factor);
    }
}

/// The free top's motion in closed form, for an axial moment of 2: the angular momentum L stays, and the
/// rotation is a turn about L by |L| t after the start after a turn about the body's axis by (1 −
/// 2) ω₃ t.
pub fn top_at(time: f64) -> ([f64; 4], [f64; 3]) {
    use nalgebra::{Quaternion, UnitQuaternion, Vector3};
    let [w, x, y, z] = START;
    let [a, b, c] = RATE;
    let start = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    let momentum = start * Vector3::new(a, b, 2.0 * c);
    let spin = UnitQuaternion::new(Vector3::z() * (-c * time));
    let now = UnitQuaternion::new(momentum * time) * start * spin;
    let rate = now.inverse() * momentum;
    let sign = now.w.signum() * w.signum();
    ([now.w, now.i, now.j, now.k].map(|q| q * sign), [rate.x, rate.y, rate.z / 2.0])
}

/// The distance of a state from the closed form at its own time.
pub fn top_error(state: &State<f64, 4, 3>) -> f64 {
    let (q, v) = top_at(state.t);
    distance(state, q, v)
}

/// The distance of a state from a quaternion and a rate; q and −q are the same orientation.
pub fn distance(state: &State<f64, 4, 3>, q: [f64; 4], v: [f64; 3]) -> f64 {
    let distance =
        |sign: f64| state.q.iter().zip(q).map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max);
    let rates = state.v.iter().zip(v).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    distance(1.0).min(distance(-1.0)).max(rates)
}

/// The distance of a pendulum driven by [`swing`] from sin t and cos t.
pub fn swing_error(state: &State<f64, 1, 1>) -> f64 {
    (state.q[0] - state.t.sin()).abs().max((state.v[0] - state.t.cos()).abs())
}

/// The slope of the line of least squares through log(error) over log(step): the order that was
/// measured.
pub fn measured_order(samples: &[(f64, f64)]) -> f64 {
    let count = samples.len() as f64;
    let logs: Vec<(f64, f64)> =
        samples.iter().map(|(step, error)| (step.ln(), error.ln())).collect();
    let mean = logs.iter().fold((0.0, 0.0), |(x, y), log| (x + log.0 / count, y + log.1 / count));
    let covariance: f64 = logs.iter().map(|log| (log.0 - mean.0) * (log.1 - mean.1)).sum();
    covariance / logs.iter().map(|log| (log.0 - mean.0).powi(2)).sum::<f64>()
}

/// Fails unless the order measured is within 0.3 of the one expected.
pub fn assert_order(expected: f64, samples: &[(f64, f64)]) {
    let order = measured_order(samples);
    println!("order {order:.2}");
    assert!((order - expected).abs() < 0.3, "order {order} instead of {expected}: {samples:?}");
}

/// The length of the top's quaternion less one.
pub fn norm_error(state: &State<f64, 4, 3>) -> f64 {
    (state.q.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs()
}
