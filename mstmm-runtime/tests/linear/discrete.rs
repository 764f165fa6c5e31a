//! Discrete models against closed forms, and against dual numbers that go through the integrator.

use crate::common::{Pendulum, Spring, State, Top};
use mstmm_runtime::description::Origin;
use mstmm_runtime::linear::{ContinuousModel, DiscreteModel, Linearize, discretize};
use mstmm_runtime::nalgebra::{Matrix2, Matrix3, SMatrix, Vector1, Vector2, Vector3, Vector4};
use mstmm_runtime::{Chain, Dual, Error, Rk4, Scalar};
use std::marker::PhantomData;

impl<T: Scalar> Linearize<1, 1> for Spring<T> {
    fn linearize_into(
        &self,
        state: &Self::State,
        inputs: &T,
        at: &mut ContinuousModel<T, 1, 1>,
    ) -> Result<(), Error> {
        let mut rate = Self::State::default();
        self.derivative_into(state, inputs, &mut rate)?;
        at.accelerations = rate.v.into();
        at.by_coordinates = [[-self.stiffness]].into();
        at.by_rates = [[-self.damping]].into();
        at.by_inputs = [[T::constant(1.0)]].into();
        at.tangent_rate = [[T::constant(0.0)]].into();
        Ok(())
    }
}

/// By hand: v̇ = u − sin θ.
impl Linearize<1, 1> for Pendulum<f64> {
    fn linearize_into(
        &self,
        state: &Self::State,
        inputs: &f64,
        at: &mut ContinuousModel<f64, 1, 1>,
    ) -> Result<(), Error> {
        let mut rate = Self::State::default();
        self.derivative_into(state, inputs, &mut rate)?;
        at.accelerations = rate.v.into();
        at.by_coordinates = Vector1::new(-state.q[0].cos());
        at.by_rates = Vector1::new(0.0);
        at.by_inputs = Vector1::new(1.0);
        at.tangent_rate = Vector1::new(0.0);
        Ok(())
    }
}

/// A cart of 1 kg with a pole of 0.5 m and a mass of 0.3 kg at its end, with a force on the cart and a torque on the
/// pole.
struct CartPole<T>(PhantomData<T>);

impl<T: Scalar> Chain for CartPole<T> {
    type Scalar = T;
    type State = State<T, 2, 2>;
    type Inputs = [T; 2];

    fn derivative_into(
        &self,
        state: &Self::State,
        &[force, torque]: &[T; 2],
        rate: &mut Self::State,
    ) -> Result<(), Error> {
        let ([sine], [cosine]) = T::sin_cos([state.q[1]]);
        let [mass, length, gravity] = [0.3, 0.5, 9.81].map(T::constant);
        let turning = length * state.v[1] * state.v[1];
        let along = mass * sine * (turning - gravity * cosine);
        let reaction = torque * cosine * length.recip();
        let cart = (force + along - reaction) * (T::constant(1.0) + mass * sine * sine).recip();
        let swing = torque * (mass * length).recip() + gravity * sine - cart * cosine;
        rate.q = state.v;
        rate.v = [cart, swing * length.recip()];
        Ok(())
    }

    fn configuration_rate_into(&self, state: &Self::State, rate: &mut Self::State) {
        rate.q = state.v;
    }

    fn normalize(&self, _: &mut Self::State) {}
}

/// The state of the cart and the pole, and inputs, as six variables.
fn six_variables(
    state: &State<f64, 2, 2>,
    inputs: &[f64; 2],
) -> (State<Dual<f64, 6>, 2, 2>, [Dual<f64, 6>; 2]) {
    let ([x, angle], [v, rate], [force, torque]) = (state.q, state.v, *inputs);
    let [x, angle, v, rate, force, torque] = Dual::variables([x, angle, v, rate, force, torque]);
    (State { q: [x, angle], v: [v, rate], t: Dual::from(state.t) }, [force, torque])
}

impl Linearize<2, 2> for CartPole<f64> {
    fn linearize_into(
        &self,
        state: &Self::State,
        inputs: &[f64; 2],
        at: &mut ContinuousModel<f64, 2, 2>,
    ) -> Result<(), Error> {
        let (state, inputs) = six_variables(state, inputs);
        let mut rate = State::default();
        CartPole(PhantomData).derivative_into(&state, &inputs, &mut rate)?;
        let derivative = |row: usize, column: usize| rate.v[row].derivatives[column];
        at.accelerations = Vector2::from(rate.v.map(|v| v.value));
        at.by_coordinates = SMatrix::from_fn(derivative);
        at.by_rates = SMatrix::from_fn(|row, column| derivative(row, column + 2));
        at.by_inputs = SMatrix::from_fn(|row, column| derivative(row, column + 4));
        at.tangent_rate = SMatrix::zeros();
        Ok(())
    }
}

/// For a linear system A and B are the first terms of the matrix exponential, up to h⁴.
#[test]
fn a_linear_system_has_the_series_of_its_exponential() -> Result<(), Error> {
    for (stiffness, damping, h) in [(0.0, 0.0, 0.5), (3.0, 0.2, 0.1), (9.0, -1.0, -0.3)] {
        let chain = Spring::<f64>::new(stiffness, damping);
        let model = discretize(&chain, &Spring::at(0.3, -0.8), &0.7, h)?;
        let a = Matrix2::new(0.0, 1.0, -stiffness, -damping) * h;
        let identity = Matrix2::identity();
        let series =
            |last: i32| (1..=last).rev().fold(identity, |sum, k| identity + a * sum / f64::from(k));
        // B is ∫ exp(A t) dt, whose series has one factorial more.
        let integral = (2..=4).rev().fold(identity, |sum, k| identity + a * sum / f64::from(k));
        let near = |off: f64| assert!(off < 1e-15 * 10.0, "off by {off:e}");
        near((model.a() - series(4)).abs().max());
        near((model.b() - integral * Vector2::new(0.0, h)).abs().max());
        // The model in continuous time.
        let mut at = ContinuousModel::default();
        chain.linearize_into(&Spring::at(0.3, -0.8), &0.7, &mut at)?;
        assert_eq!((at.a() * h, at.b()), (a, Vector2::new(0.0, 1.0)));
    }
    Ok(())
}

#[test]
fn a_pendulum_by_hand_has_the_derivatives_of_the_step() -> Result<(), Error> {
    for (angle, rate, torque) in [(0.3, -0.2, 0.5), (3.0, 2.0, -1.0)] {
        let model = discretize(&Pendulum::new(), &Pendulum::at(angle, rate), &torque, 0.1)?;
        let [q, v, u] = Dual::variables([angle, rate, torque]);
        let mut state = State { q: [q], v: [v], t: Dual::default() };
        Rk4::new(Dual::from(0.1)).step_held(&Pendulum::new(), &mut state, &u)?;
        let (a, b) = (model.a::<2>(), model.b::<2>());
        for (row, end) in [state.q[0], state.v[0]].into_iter().enumerate() {
            let found = [a[(row, 0)], a[(row, 1)], b[row]];
            let off = found.iter().zip(end.derivatives).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) < 1e-14, "{found:?} {:?}", end.derivatives);
        }
    }
    Ok(())
}

/// Where q̇ = v the model has the derivatives of the result of `Rk4::step_held`, whatever the step.
#[test]
fn a_model_has_the_derivatives_of_the_step() -> Result<(), Error> {
    let chain = CartPole(PhantomData);
    for (q, v, inputs, h) in [
        ([0.1, 0.2], [0.0, 0.0], [0.0, 0.0], 0.02),
        ([0.0, 2.0], [1.0, -3.0], [4.0, 0.5], 0.1),
        ([0.5, -1.0], [-2.0, 6.0], [-3.0, 1.0], 0.3),
    ] {
        let state = State { q, v, t: 1.5 };
        let model: DiscreteModel<f64, 2, 2> = discretize(&chain, &state, &inputs, h)?;
        let (mut moved, held) = six_variables(&state, &inputs);
        Rk4::new(Dual::from(h)).step_held(&CartPole(PhantomData), &mut moved, &held)?;
        let ends = [moved.q[0], moved.q[1], moved.v[0], moved.v[1]];
        let a = SMatrix::<f64, 4, 4>::from_fn(|row, column| ends[row].derivatives[column]);
        let b = SMatrix::<f64, 4, 2>::from_fn(|row, column| ends[row].derivatives[column + 4]);
        let off = (model.a() - a).abs().max().max((model.b() - b).abs().max());
        // Some hundred operations on numbers of this size.
        let size = a.abs().max().max(b.abs().max()).max(1.0);
        assert!(off < 1e-14 * size, "off by {off:e} of {size}");
        assert!((a - SMatrix::identity()).abs().max() > h * 0.5);
    }
    Ok(())
}

/// The state along δ, small rotations in the axes of the body, and along its rates.
fn moved_top(state: &State<f64, 4, 3>) -> State<Dual<f64, 6>, 4, 3> {
    let mut moved =
        State { q: state.q.map(Dual::from), v: state.v.map(Dual::from), t: Dual::default() };
    for direction in 0..3 {
        let mut along = state.clone();
        along.v = [0.0; 3];
        along.v[direction] = 1.0;
        let mut rate = State::default();
        Top::new().configuration_rate_into(&along, &mut rate);
        for (q, rate) in moved.q.iter_mut().zip(rate.q) {
            q.derivatives[direction] = rate;
        }
        moved.v[direction].derivatives[direction + 3] = 1.0;
    }
    moved
}

impl Linearize<3, 0> for Top<f64> {
    fn linearize_into(
        &self,
        state: &Self::State,
        (): &(),
        at: &mut ContinuousModel<f64, 3, 0>,
    ) -> Result<(), Error> {
        let chain = Top { axial: Dual::from(self.axial), weight: Dual::from(self.weight) };
        let mut rate = State::default();
        chain.derivative_into(&moved_top(state), &(), &mut rate)?;
        let derivative = |row: usize, column: usize| rate.v[row].derivatives[column];
        at.accelerations = Vector3::from(rate.v.map(|v| v.value));
        at.by_coordinates = SMatrix::from_fn(derivative);
        at.by_rates = SMatrix::from_fn(|row, column| derivative(row, column + 3));
        at.tangent_rate = -Vector3::from(state.v).cross_matrix();
        Ok(())
    }
}

/// With a quaternion the model is that of the motion up to the order of the step. The derivatives of the end of the step
/// are taken along the rates there: δ is twice the vector part of the conjugate quaternion times its derivative.
#[test]
fn a_model_with_a_quaternion_is_accurate_to_the_order_of_the_step() -> Result<(), Error> {
    let exact = |h: f64| -> Result<SMatrix<f64, 6, 6>, Error> {
        let chain = Top { axial: Dual::from(0.3), weight: Dual::from(-2.0) };
        let mut state = moved_top(&Top::<f64>::start());
        Rk4::new(Dual::from(h)).step_held(&chain, &mut state, &())?;
        let [w, x, y, z] = state.q.map(|q| q.value);
        Ok(SMatrix::from_fn(|row, column| {
            let q = Vector4::from(state.q.map(|q| q.derivatives[column]));
            let along = [
                Vector4::new(-x, w, z, -y),
                Vector4::new(-y, -z, w, x),
                Vector4::new(-z, y, -x, w),
            ];
            match row {
                0..3 => 2.0 * along[row].dot(&q),
                _ => state.v[row - 3].derivatives[column],
            }
        }))
    };
    let off = |h: f64| -> Result<f64, Error> {
        let model = discretize(&Top::hanging(), &Top::start(), &(), h)?;
        Ok((model.a() - exact(h)?).abs().max())
    };
    let errors = [off(0.1)?, off(0.05)?, off(0.025)?];
    assert!(errors[0] < 1e-4, "{errors:?}");
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((24.0..44.0).contains(&ratio), "2⁵ is expected: {errors:?}");
    }
    // The axes of δ rotate with the body: without it the error would be of order one.
    let turned = exact(1e-3)?.fixed_view::<3, 3>(0, 0).into_owned();
    let expected = -Vector3::from(Top::<f64>::start().v).cross_matrix();
    assert!(((turned - Matrix3::identity()) * 1e3 - expected).abs().max() < 1e-2);
    Ok(())
}

#[test]
fn errors_are_those_of_the_chain() {
    let chain = Pendulum::new();
    let refused = discretize(&chain, &Pendulum::at(f64::NAN, 0.0), &0.0, 0.1);
    assert_eq!(refused.err(), Some(Error::NotFinite(Origin::Coordinate(0))));
    let refused = discretize(&chain, &Pendulum::at(0.0, 0.0), &0.0, f64::NAN);
    assert_eq!(refused.err(), Some(Error::NotFinite(Origin::Coordinate(0))));
    let refused = discretize(&chain, &Pendulum::at(0.0, 0.0), &0.0, 1e200);
    assert_eq!(refused.err(), Some(Error::NotFinite(Origin::Result)));
    let chain = Pendulum { singular_beyond: 0.1 };
    let refused = discretize(&chain, &Pendulum::at(0.2, 0.0), &0.0, 0.1);
    assert_eq!(refused.err(), Some(Error::Singular { hinge: "pivot" }));
}

/// Single precision, and lanes with different states.
#[test]
fn other_scalars_have_models() -> Result<(), Error> {
    let expected: SMatrix<f64, 2, 2> =
        discretize(&Spring::new(3.0, 0.2), &Spring::at(0.3, -0.8), &0.7, 0.1)?.a();
    let single = discretize(&Spring::<f32>::new(3.0, 0.2), &Spring::at(0.3, -0.8), &0.7, 0.1)?;
    assert!((single.a::<2>().map(f64::from) - expected).abs().max() < 1e-6);
    #[cfg(feature = "wide")]
    {
        use mstmm_runtime::wide::f64x4;
        let stiffness = f64x4::new([1.0, 2.0, 3.0, 4.0]);
        let chain = Spring { stiffness, damping: f64x4::splat(0.2) };
        let state = Spring::<f64x4>::at(0.3, -0.8);
        let lanes = discretize(&chain, &state, &f64x4::splat(0.7), f64x4::splat(0.1))?;
        assert_eq!(lanes.a::<2>().map(|x| x.to_array()[2]), expected);
    }
    Ok(())
}
