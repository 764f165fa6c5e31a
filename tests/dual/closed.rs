//! Closed chains of dual numbers: loop constraints that are regular, redundant, of constant geometry and of a geometry
//! given by parameters, against differences in `f64`.

use mstmm::{ChainState, Dual, Error, GeneratedChain, Rk4, Scalar, mstmm_chain};
use mstmm_reference::Random;

mstmm_chain! {
    plane chain PlaneFourBar {
        gravity = [0, -9.81] m/s^2;
        body Bar { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Bar la -> pin b -> Bar lb -> pin c -> Bar lc -> pin d -> ground at [1.2, 0] m;
        hinge a { start = 80 deg; torque = input; }
        hinge b, c { start = -70 deg; }
    }
    chain SpaceFourBar {
        gravity = [1, -9.81, 2] m/s^2;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin(z) a -> Bar la -> pin(z) b -> Bar lb -> pin(z) c -> Bar lc -> pin(z) d
            -> ground at [1.2, 0, 0] m;
        hinge a { start = 80 deg; torque = input; }
        hinge b, c { start = -70 deg; }
    }
    chain FourBarOfLength {
        gravity = [1, -9.81, 2] m/s^2;
        param length = 1 m;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [length, 0 m, 0 m];
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> pin(z) a -> Bar la -> pin(z) b -> Bar lb -> pin(z) c -> Bar lc -> pin(z) d
            -> ground at [1.2, 0, 0] m;
        hinge a { start = 80 deg; torque = input; }
        hinge b, c { start = -70 deg; }
    }
    chain BallAtEachEnd {
        gravity = [0, 0, -9.81] m/s^2;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [1, 0, 0] m;
            inertia = diag(0.1, 0.12, 0.13) kg*m^2 about com;
        }
        ground -> ball a -> Bar one -> universal(y, z) b -> Bar two -> ball c -> ground at [1.5, 0.2, 0] m;
        hinge b { torque = input; start = [0.7, 0.2]; }
    }
    chain WeldAtTheEnd {
        gravity = [0, 0, -9.81] m/s^2;
        param length = 1 m;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [length, 0 m, 0 m];
            inertia = diag(0.1, 0.12, 0.13) kg*m^2 about com;
        }
        ground -> ball a -> Bar one -> universal(y, z) b -> Bar two -> ball c -> Bar three -> weld e
            -> ground at [2.3, 0.2, 0] m;
        hinge b { torque = input; start = [0.7, 0.2]; }
    }
    chain ConstantToTheWeld {
        gravity = [0, 0, -9.81] m/s^2;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [1, 0, 0] m;
            inertia = diag(0.1, 0.12, 0.13) kg*m^2 about com;
        }
        ground -> ball a -> Bar one -> universal(y, z) b -> Bar two -> ball c -> Bar three -> weld e
            -> ground at [2.3, 0.2, 0] m;
        hinge b { torque = input; start = [0.7, 0.2]; }
    }
    chain SevenPins {
        gravity = [0, 0, -9.81] m/s^2;
        body Bar {
            mass = 1 kg; com = [0.5, 0, 0.1] m; output = [1, 0, 0.1] m;
            inertia = diag(0.1, 0.12, 0.13) kg*m^2 about com;
        }
        ground -> pin(z) a -> Bar la -> pin(x) b -> Bar lb -> pin(y) c -> Bar lc -> pin(z) d -> Bar ld
            -> pin(x) e -> Bar le -> pin(y) f -> Bar lf -> pin(z) g -> ground
            at [1.8751, 3.9310, 0.4683] m turned rpy(0.8984, -0.8573, 1.1849);
        hinge a { start = 0.5; torque = input; }
        hinge b { start = 0.4; }
        hinge c { start = 1.1; }
        hinge d { start = 1.2; }
        hinge e { start = -0.6; }
        hinge f { start = -1; }
    }
    /// Bennett's linkage: its redundant directions depend on the pose.
    chain Bennett {
        gravity = [1, -2, -9.5] m/s^2;
        body Short {
            mass = 1 kg; com = [0.5, 0.1, 0.05] m; inertia = diag(0.05, 0.1, 0.12) kg*m^2 about com;
            output = [1, 0, 0] turned rpy(30, 0, 0) deg;
        }
        body Long {
            mass = 1.5 kg; com = [0.7, 0, 0.1] m; inertia = diag(0.06, 0.2, 0.22) kg*m^2 about com;
            output = [sqrt(2), 0, 0] turned rpy(45, 0, 0) deg;
        }
        ground -> pin a -> Short first -> pin b -> Long second -> pin c -> Short third -> pin d
            -> ground at [-sqrt(2), 0, 0] turned rpy(-45, 0, 0) deg;
        hinge a { start = 80 deg; torque = input; }
        hinge b { start = 155 deg; }
        hinge c { start = -80 deg; }
        hinge d { start = -155 deg; }
    }
}

/// A closed state, and a direction in which coordinates and rates change.
struct Motion {
    coordinates: Vec<[f64; 2]>,
    rates: Vec<[f64; 2]>,
}

impl Motion {
    /// Assembles a state near the start of the chain; the direction leaves the closed states.
    fn new<C: GeneratedChain<Scalar = f64>>(chain: &C, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut state = chain.initial_state();
        state.coordinates_mut().iter_mut().for_each(|q| *q += random.between(-0.1, 0.1));
        state.rates_mut().iter_mut().for_each(|v| *v += random.between(-1.0, 1.0));
        chain.normalize(&mut state);
        chain.assemble(&mut state, &chain.no_inputs()).expect("a linkage nearly closed");
        let mut along = |&x: &f64| [x, random.between(-1.0, 1.0)];
        let coordinates = state.coordinates().iter().map(&mut along).collect();
        Motion { coordinates, rates: state.rates().iter().map(along).collect() }
    }

    /// The state at a displacement along the direction.
    fn at<C: GeneratedChain>(&self, chain: &C, along: C::Scalar) -> C::State {
        let constant = <C::Scalar as Scalar>::constant;
        let mut state = chain.initial_state();
        let place = |to: &mut [C::Scalar], from: &[[f64; 2]]| {
            for (to, &[value, slope]) in to.iter_mut().zip(from) {
                *to = constant(value) + along * constant(slope);
            }
        };
        place(state.coordinates_mut(), &self.coordinates);
        place(state.rates_mut(), &self.rates);
        chain.normalize(&mut state);
        state
    }
}

/// The derivative at zero by a central difference of order four.
fn differences(function: impl Fn(f64) -> Result<Vec<f64>, Error>) -> Vec<f64> {
    const STEP: f64 = 1.0 / 8192.0;
    let values = [-2.0, -1.0, 1.0, 2.0].map(|steps| function(steps * STEP).expect("a value"));
    let slope = |k: usize| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|place: usize| values[place][k]);
        (8.0 * (c - b) - (d - a)) / (12.0 * STEP)
    };
    (0..values[0].len()).map(slope).collect()
}

/// Truncation: STEP⁴/30 = 8e-18 of fifth derivatives, which are below 1e7 times the values of these linkages.
/// Rounding: 1.5 ε/STEP = 3e-12 times a condition of ten.
const TOLERANCE: f64 = 1e-10;

/// Compares a function of dual numbers with the same function of `f64`.
fn compare(
    label: &str,
    dual: impl Fn(Dual<f64>) -> Result<Vec<Dual<f64>>, Error>,
    plain: impl Fn(f64) -> Result<Vec<f64>, Error>,
) {
    let values = plain(0.0).expect("a value");
    let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let parts = |duals: &[Dual<f64>]| -> (Vec<f64>, Vec<f64>) {
        duals.iter().map(|x| (x.value, x.derivative())).unzip()
    };
    // Nothing changes: every derivative is zero.
    let (found, still) = parts(&dual(Dual::from(0.0)).expect("constants have derivatives"));
    assert_eq!(bits(&found), bits(&values), "{label}: values of constants");
    assert!(still.iter().all(|&x| x == 0.0), "{label}: {still:?}");

    let (found, derivatives) = parts(&dual(Dual::variable(0.0)).expect("derivatives"));
    assert_eq!(bits(&found), bits(&values), "{label}: values");
    let expected = differences(plain);
    let size = expected.iter().chain(&values).fold(1.0f64, |size, x| size.max(x.abs()));
    assert!(expected.iter().any(|x| x.abs() > 1e-3), "{label}: nothing changes");
    let mut worst = 0.0f64;
    for (k, (found, expected)) in derivatives.iter().zip(&expected).enumerate() {
        let off = (found - expected).abs() / size;
        assert!(off < TOLERANCE, "{label}: {k} is {found}, not {expected}: off by {off:e}");
        worst = worst.max(off);
    }
    println!("{label}: off by {worst:.1e}");
}

/// Tests of chains: the number of redundant directions, and what changes in addition to the state.
macro_rules! have_derivatives {
    ($($test:ident: $name:ident, $redundant:literal, $last:ident, |$chain:ident, $inputs:ident, $along:ident| $change:block)*) => { $(
        #[test]
        fn $test() {
            /// Accelerations, energies, reactions at the closing hinge and redundant directions.
            fn results<T: Scalar>(motion: &Motion, $along: T) -> Result<Vec<T>, Error> {
                let mut made = $name::<T>::new();
                let $chain = &mut made;
                let mut $inputs = $chain.no_inputs();
                $change
                let mut at = $chain.workspace();
                $chain.solve_into(&motion.at($chain, $along), &$inputs, &mut at)?;
                let closure = at.closure();
                assert_eq!(closure.redundant(), $redundant);
                let mut found = at.accelerations().as_slice().to_vec();
                found.extend([at.kinetic_energy(), at.potential_energy()]);
                found.extend(at.$last().input().force().iter());
                found.extend(closure.undetermined().as_flattened());
                Ok(found)
            }

            /// The state after assembly and a step.
            fn moved<T: Scalar>(motion: &Motion, $along: T) -> Result<Vec<T>, Error> {
                let mut made = $name::<T>::new();
                let $chain = &mut made;
                let mut $inputs = $chain.no_inputs();
                $change
                let mut state = motion.at($chain, $along);
                $chain.assemble(&mut state, &$inputs)?;
                let assembled = [state.coordinates(), state.rates()].concat();
                let mut rk4 = Rk4::new(T::constant(0.01));
                rk4.step($chain, &mut state, |_, _| $inputs.clone())?;
                Ok([&assembled, state.coordinates(), state.rates()].concat())
            }

            for seed in 0..5 {
                let motion = Motion::new(&$name::<f64>::new(), seed);
                let label = |what: &str| format!("{} {seed}: {what}", stringify!($name));
                compare(&label("results"), |x| results(&motion, x), |x| results(&motion, x));
                compare(&label("moved"), |x| moved(&motion, x), |x| moved(&motion, x));
            }
        }
    )* };
}

have_derivatives! {
    a_plane_four_bar: PlaneFourBar, 0, d, |chain, inputs, along| { inputs.a = along; }
    a_four_bar_in_space: SpaceFourBar, 3, d, |chain, inputs, along| { inputs.a = along; }
    a_four_bar_of_variable_length: FourBarOfLength, 3, d, |chain, inputs, along| {
        inputs.a = along;
        chain.set_length(T::constant(1.0) + along)?;
    }
    a_ball_at_each_end: BallAtEachEnd, 0, c, |chain, inputs, along| {
        inputs.b = [along, T::default()].into();
    }
    a_weld_at_the_end: WeldAtTheEnd, 0, e, |chain, inputs, along| {
        inputs.b = [along, T::default()].into();
        chain.set_length(T::constant(1.0) + along)?;
    }
    constant_bars_to_a_weld: ConstantToTheWeld, 0, e, |chain, inputs, along| {
        inputs.b = [along, T::default()].into();
    }
    seven_pins: SevenPins, 0, g, |chain, inputs, along| { inputs.a = along; }
    bennett: Bennett, 3, d, |chain, inputs, along| { inputs.a = along; }
}

/// The corrections of an assembly make second derivatives exact too, in those of the coordinates and of the rates.
#[test]
fn an_assembled_state_has_second_derivatives() {
    fn assembled<T: Scalar>(motion: &Motion, along: T) -> Result<Vec<T>, Error> {
        let chain = BallAtEachEnd::<T>::new();
        let mut state = motion.at(&chain, along);
        chain.assemble(&mut state, &chain.no_inputs())?;
        Ok([state.coordinates(), state.rates()].concat())
    }
    for seed in 0..5 {
        let motion = Motion::new(&BallAtEachEnd::<f64>::new(), seed);
        let twice = Dual::variable(Dual::variable(0.0f64));
        let found = assembled(&motion, twice).expect("derivatives");
        let values = assembled(&motion, 0.0f64).expect("a value");
        let expected = differences(|along| {
            let derivatives = assembled(&motion, Dual::variable(along))?;
            Ok(derivatives.iter().map(|x| x.derivative()).collect())
        });
        let size = expected.iter().fold(1.0f64, |size, x| size.max(x.abs()));
        for ((found, value), expected) in found.iter().zip(values).zip(expected) {
            assert_eq!(found.value.value.to_bits(), value.to_bits(), "seed {seed}");
            let off = (found.derivative().derivative() - expected).abs() / size;
            assert!(off < TOLERANCE, "seed {seed}: off by {off:e}");
        }
    }
}
