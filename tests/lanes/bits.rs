//! Every lane has exactly the same bits as the chain alone.

use mstmm::lanes::{NativeF32, NativeF64};
use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use mstmm::{ChainState, Error, LinearlyImplicitEuler, Newmark, Rk4, Scalar, SemiImplicitEuler};

use super::chains::{
    Afloat, Arm, ArmByTransfer, Balls, Branched, Loop, Parallelogram, Repeated, Slides, Told,
    ToldLoop, Train,
};
use super::numbers::{Lanes, numbers, of_lane, same_bits};
use super::sample::{Case, Sample, each, wide};

/// Random cases of each chain.
const SEEDS: u64 = 5;

/// Steps of each integration, and their length in s, which differs from lane to lane.
const STEPS: usize = 5;
const STEP: f64 = 1.0 / 512.0;

/// A result of a case: its name and its numbers, with all lanes.
type Results = Vec<(&'static str, Vec<f64>)>;

/// Everything that is computed in one state.
fn evaluations<C: Sample<Scalar: Lanes>>(case: &Case<C>) -> Result<Results, Error> {
    let Case { chain, state, inputs, step } = case;
    let [mut rate, mut implicit_rate, mut of_coordinates] =
        [(); 3].map(|()| C::State::zero_position());
    chain.derivative_into(state, inputs, &mut rate)?;
    chain.implicit_derivative_into(state, inputs, *step, &mut implicit_rate)?;
    chain.configuration_rate_into(state, &mut of_coordinates);
    let mut at = chain.workspace();
    chain.solve_into(state, inputs, &mut at)?;
    Ok(vec![
        ("state", numbers(state)),
        ("accelerations", numbers(&rate)),
        ("implicit accelerations", numbers(&implicit_rate)),
        ("rates of coordinates", numbers(&of_coordinates)),
        ("everything", numbers(&at)),
        ("energy", numbers(&chain.energy(state))),
    ])
}

/// The results of whole steps, and of steps up to a time.
fn steps<C: Sample<Scalar: Lanes>>(case: &Case<C>) -> Result<Results, Error> {
    let Case { chain, state: start, inputs, step } = case;
    let end = Scalar::constant(STEP * (STEPS as f64 + 0.3));
    let mut results = Vec::new();
    macro_rules! run {
        ($($name:literal: $method:ident;)*) => { $(
            let (mut state, mut method) = (start.clone(), $method::new(*step));
            for _ in 0..STEPS {
                method.step(chain, &mut state, |_, _| inputs.clone())?;
            }
            results.push(($name, numbers(&state)));

            let (mut state, mut method) = (start.clone(), $method::new(Scalar::constant(STEP)));
            state.set_time(Scalar::constant(0.0));
            method.advance_to(chain, &mut state, end, |_, _| inputs.clone())?;
            results.push((concat!($name, ", to a time"), numbers(&state)));
        )* };
    }
    run! {
        "Runge and Kutta": Rk4;
        "semi-implicit Euler": SemiImplicitEuler;
        "linearly implicit Euler": LinearlyImplicitEuler;
        "Newmark": Newmark;
    }
    Ok(results)
}

/// Compares each lane with the chain alone.
fn check<W, C>(name: &str)
where
    W: Sample<Scalar: Lanes>,
    C: Sample<Scalar = <W::Scalar as Scalar>::Real>,
    C::Scalar: Lanes + Scalar<Real = C::Scalar>,
{
    for seed in 0..SEEDS {
        let each: Vec<Case<C>> = each(seed, W::Scalar::COUNT, STEP);
        let wide: Case<W> = wide(seed, &each);
        let all = |case: &Case<W>| Ok([evaluations(case)?, steps(case)?].concat());
        let found: Results = all(&wide).unwrap_or_else(|error: Error| panic!("{name}: {error}"));
        for (lane, case) in each.iter().enumerate() {
            let alone = [evaluations(case), steps(case)].map(|part| part.expect("a regular chain"));
            for ((what, found), (_, alone)) in found.iter().zip(alone.concat()) {
                let found = of_lane(found, lane, W::Scalar::COUNT);
                assert!(
                    same_bits(&found, &alone),
                    "{name}, seed {seed}, lane {lane}: {what}\nfound {found:?}\nalone {alone:?}"
                );
            }
        }
    }
}

/// The stack size: unoptimised code keeps every value of a function on the stack, in sixteen lanes.
const STACK: usize = 64 << 20;

fn with_room(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(test).expect("a thread");
    if let Err(panic) = thread.join() {
        std::panic::resume_unwind(panic);
    }
}

macro_rules! chains {
    ($($test:ident: $name:ident;)*) => { $(
        #[test]
        fn $test() {
            with_room(|| {
                check::<$name<f64x8>, $name<f64>>(stringify!($name of f64x8));
                check::<$name<f32x16>, $name<f32>>(stringify!($name of f32x16));
            });
        }
    )* };
}

chains! {
    pins: Arm;
    pins_by_transfer: ArmByTransfer;
    balls_with_springs_stops_and_friction: Balls;
    slides_with_springs_stops_and_friction: Slides;
    elastic_hinges_of_a_floating_chain: Afloat;
    a_loop_in_a_plane: Loop;
    a_redundant_loop: Parallelogram;
    repeated_parts: Repeated;
    a_line: Train;
    prescribed_motions: Told;
    a_tree_with_parts_and_repetitions: Branched;
    a_loop_with_a_prescribed_branch: ToldLoop;
}

#[test]
fn shorter_lanes() {
    check::<Balls<f64x2>, Balls<f64>>("Balls of f64x2");
    check::<Balls<f64x4>, Balls<f64>>("Balls of f64x4");
    check::<Balls<f32x4>, Balls<f32>>("Balls of f32x4");
    check::<Balls<f32x8>, Balls<f32>>("Balls of f32x8");
}

#[test]
fn lanes_of_one_register() {
    check::<Slides<NativeF64>, Slides<f64>>("Slides of NativeF64");
    check::<Slides<NativeF32>, Slides<f32>>("Slides of NativeF32");
}
