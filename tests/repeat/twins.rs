//! Two chains that should be the same: everything that generic code can ask of them, side by side.

pub use crate::support::printed::numbers;
use crate::support::printed::quantities;
pub use crate::support::states::{copied, random_state};
use mstmm::{
    Chain, ChainState, Energy, Error, GeneratedChain, LinearlyImplicitEuler, Scalar,
    SemiImplicitEuler,
};
use mstmm_reference::Random;
use std::fmt::Debug;

/// Random states tried of each pair.
const STATES: u64 = 20;

/// In units in the last place of one. Loops compute the same equations, but simplified less than what
/// is written out: both round some hundred times on the way to a number, in chains whose condition is
/// some ten to a hundred, and half of the errors cancel.
const TOLERANCE: f64 = 1e3;

/// Steps of each integration, and their length in s.
const STEPS: usize = 10;
const STEP: f64 = 1.0 / 512.0;

/// A number that these tests are run in.
pub trait Number: Scalar<Real = Self, Mask = bool> + PartialOrd {}

impl Number for f32 {}
impl Number for f64 {}

/// A generated chain whose states and results can be printed.
pub trait Twin:
    GeneratedChain<Scalar: Number, State: Debug + PartialEq, Workspace: Debug> + Default
{
}

impl<C> Twin for C where
    C: GeneratedChain<Scalar: Number, State: Debug + PartialEq, Workspace: Debug> + Default
{
}

/// The largest difference of any quantity, relative to its largest number, at least 1. Which
/// reactions a closure leaves open is no number that has to agree.
fn apart(a: &dyn Debug, b: &dyn Debug) -> f64 {
    let (a, b) = (quantities(a), quantities(b));
    assert!(a.keys().eq(b.keys()), "{:?} and {:?}", a.keys(), b.keys());
    let compared = a.iter().zip(b.values()).filter(|((name, _), _)| !name.contains("undet"));
    let differences = compared.map(|((_, a), b)| crate::support::difference(a, b));
    differences.fold(0.0, crate::support::worst)
}

/// A repeated chain and the same one written out.
pub struct Pair<A, B> {
    pub name: &'static str,
    pub repeated: A,
    pub unrolled: B,
}

/// What sets the inputs of a chain from numbers.
pub type Inputs<C> = fn(&mut <C as Chain>::Inputs, &[<C as Chain>::Scalar]);

impl<A, B> Pair<A, B>
where
    A: Twin<Inputs: Copy>,
    B: Twin<Scalar = A::Scalar, Inputs: Copy>,
{
    /// Compares everything in many states, with inputs from numbers of up to ±1 that both chains
    /// are given.
    pub fn check(&self, inputs: Inputs<A>, same: Inputs<B>) {
        let Pair { name, repeated, unrolled, .. } = self;
        let tolerance = TOLERANCE * numbers(&A::Scalar::epsilon())[0];
        assert_eq!(
            numbers(&A::State::zero_position()),
            numbers(&B::State::zero_position()),
            "{name}"
        );
        let start = [numbers(&repeated.initial_state()), numbers(&unrolled.initial_state())];
        assert_eq!(start[0], start[1], "{name}");
        let mut largest = (0.0, "anything", 0);
        let mut closed = 0;
        for seed in 0..STATES {
            let mut random = Random::new(seed);
            let mut state = random_state::<A>(&mut random);
            let given = [(); 64].map(|()| A::Scalar::constant(random.between(-1.0, 1.0)));
            let (mut drives, mut twin_drives) = (repeated.no_inputs(), unrolled.no_inputs());
            inputs(&mut drives, &given);
            same(&mut twin_drives, &given);
            let mut twin: B::State = copied(&state);
            let assembled = repeated.assemble(&mut state, &drives);
            assert_eq!(
                assembled,
                unrolled.assemble(&mut twin, &twin_drives),
                "{name}, seed {seed}"
            );
            if assembled.is_err() {
                continue;
            }
            closed += 1;
            // Every correction adds its rounding to that of a start that is far from closed.
            let off = apart(&state, &twin);
            assert!(off <= 1e3 * tolerance, "{name}, seed {seed}: assembled {off:e} apart");
            for (what, off) in self.differences(&state, (drives, twin_drives)) {
                assert!(off <= tolerance, "{name}, seed {seed}: {what} off by {off:e}");
                if off > largest.0 {
                    largest = (off, what, seed);
                }
            }
        }
        assert!(closed > STATES / 4, "{name}: only {closed} states close");
        let (off, what, seed) = largest;
        println!("{name}: {closed} states, off by {off:.1e} at most: {what} of seed {seed}");
    }

    fn differences(
        &self,
        state: &A::State,
        (given, same): (A::Inputs, B::Inputs),
    ) -> Vec<(&'static str, f64)> {
        let Pair { name, repeated: a, unrolled: b, .. } = self;
        let twin: B::State = copied(state);
        let regular = |result: Result<(), Error>| result.unwrap_or_else(|e| panic!("{name}: {e}"));
        let step = A::Scalar::constant(STEP);

        let (mut rate, mut twin_rate) = (state.clone(), twin.clone());
        regular(a.derivative_into(state, &given, &mut rate));
        regular(b.derivative_into(&twin, &same, &mut twin_rate));
        let mut found = vec![("rates", apart(&rate, &twin_rate))];

        let (mut coordinates, mut twin_coordinates) = (state.clone(), twin.clone());
        a.configuration_rate_into(state, &mut coordinates);
        b.configuration_rate_into(&twin, &mut twin_coordinates);
        found.push(("coordinate rates", apart(&coordinates, &twin_coordinates)));
        let fast = crate::support::difference(
            &numbers(&coordinates.coordinates()),
            &numbers(&rate.coordinates()),
        );
        assert_eq!(fast, 0.0, "{name}: two ways to the rates of coordinates");

        regular(a.implicit_derivative_into(state, &given, step, &mut rate));
        regular(b.implicit_derivative_into(&twin, &same, step, &mut twin_rate));
        found.push(("implicit rates", apart(&rate, &twin_rate)));

        let (mut at, mut twin_at) = (a.workspace(), b.workspace());
        regular(a.solve_into(state, &given, &mut at));
        regular(b.solve_into(&twin, &same, &mut twin_at));
        found.push(("solution", apart(&at, &twin_at)));

        let (energy, twin_energy) = (a.energy(state), b.energy(&twin));
        let joules = |energy: Energy<_>| [energy.kinetic, energy.potential, energy.total()];
        found.push(("energy", apart(&joules(energy), &joules(twin_energy))));

        let (mut long, mut twin_long) = (state.clone(), twin.clone());
        let scale = A::Scalar::constant(1.0 + 1.0 / 64.0);
        long.coordinates_mut()
            .iter_mut()
            .chain(twin_long.coordinates_mut())
            .for_each(|q| *q *= scale);
        a.normalize(&mut long);
        b.normalize(&mut twin_long);
        found.push(("normalized", apart(&long, &twin_long)));

        let (mut moved, mut twin_moved) = (state.clone(), twin.clone());
        regular(a.project(&mut moved, |_| Ok(given)));
        regular(b.project(&mut twin_moved, |_| Ok(same)));
        found.push(("closed", apart(&moved, &twin_moved)));

        // No method with stages: there quaternions are not quite of unit length, and what a program
        // makes of such is its own affair.
        let (mut euler, mut twin_euler) =
            (SemiImplicitEuler::new(step), SemiImplicitEuler::new(step));
        for _ in 0..STEPS {
            regular(euler.step(a, &mut moved, |_, _| given));
            regular(twin_euler.step(b, &mut twin_moved, |_, _| same));
        }
        found.push(("motion", apart(&moved, &twin_moved)));

        let mut euler = LinearlyImplicitEuler::new(step);
        let mut twin_euler = LinearlyImplicitEuler::new(step);
        for _ in 0..STEPS {
            regular(euler.step(a, &mut moved, |_, _| given));
            regular(twin_euler.step(b, &mut twin_moved, |_, _| same));
        }
        found.push(("implicit motion", apart(&moved, &twin_moved)));
        found
    }
}

/// Chains with a repeated part and the same written out, with tests that compare them:
/// `twins! { [dimension, what stands before the route] test: Repeated ByTransfer { … } = Written
/// { … }; … }`. Where no name for it is given, there is none by `transfer`. Inputs are set from a
/// list of numbers: `given |x| { field = x[0]; } = { … }`.
macro_rules! twins {
    ($head:tt) => {};
    (
        $head:tt
        $test:ident: $repeated:ident $($transfer:ident)? { $($short:tt)* }
        = $unrolled:ident { $($long:tt)* }
        $(given |$x:ident| $given:tt = $same:tt)?;
        $($others:tt)*
    ) => {
        twins!(@chain [$repeated] riccati $head { $($short)* });
        twins!(@chain [$($transfer)?] transfer $head { $($short)* });
        twins!(@chain [$unrolled] riccati $head { $($long)* });

        #[test]
        fn $test() {
            twins!(@compare f64 [$repeated] $unrolled $($x $given $same)?);
            twins!(@compare f64 [$($transfer)?] $unrolled $($x $given $same)?);
        }

        twins! { $head $($others)* }
    };
    (@chain [] $($rest:tt)*) => {};
    (@chain [$name:ident] $method:ident [$dimension:ident $($head:tt)*] { $($rest:tt)* }) => {
        mstmm::mstmm_chain! {
            $dimension chain $name { method = $method; $($head)* $($rest)* }
        }
    };
    (@compare $number:ident [] $($rest:tt)*) => {};
    (@compare $number:ident [$a:ident] $b:ident) => {
        twins!(@compare $number [$a] $b x {} {});
    };
    (
        @compare $number:ident [$a:ident] $b:ident
        $x:ident { $($field:ident = $value:expr;)* } { $($twin:ident = $twin_value:expr;)* }
    ) => {
        $crate::repeat::twins::Pair {
            name: concat!(stringify!($a), "<", stringify!($number), ">"),
            repeated: $a::<$number>::new(),
            unrolled: $b::<$number>::new(),
        }
        .check(
            |_inputs, $x| { let _ = $x; $( _inputs.$field = $value; )* },
            |_inputs, $x| { let _ = $x; $( _inputs.$twin = $twin_value; )* },
        );
    };
}
pub(crate) use twins;
