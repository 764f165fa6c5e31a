//! The cost per body in chains of 10 to 10 000 bodies, with the same loop in the generated code.

use std::error::Error;
use std::hint::black_box;
use std::thread;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput};
use mstmm::{ChainState, mstmm_chain};
use mstmm_benches::{numbers_of_state, random_states, state_from};

/// The stack size: long chains keep their values on the stack.
const STACK: usize = 1 << 28;

/// The number of bodies in all states of a chain: a chain of ten has a tenth as many states. There are
/// too many angles for branch prediction.
const STATES: usize = 10_000;

macro_rules! lengths {
    ($($rods:ident $balls:ident $count:literal)*) => {
        mstmm_chain! { $(
            plane chain $rods {
                gravity = [0, -9.8] m/s^2;
                body Rod {
                    mass = 1 kg;
                    com = [0.5, 0] m;
                    output = [1, 0] m;
                    inertia = 1/12 kg*m^2 about com;
                }
                ground -> repeat $count { pin joint -> Rod rod };
            }
            chain $balls {
                gravity = [0, -9.8, 0] m/s^2;
                body Cube {
                    mass = 1 kg;
                    com = [0.5, 0, 0] m;
                    output = [1, 0, 0] m;
                    inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
                }
                ground -> repeat $count { ball joint -> Cube cube };
            }
        )* }

        fn all_lengths(criterion: &mut Criterion) {
            let mut group = criterion.benchmark_group("rods on pins");
            $(time!(group, $rods, $count);)*
            group.finish();
            let mut group = criterion.benchmark_group("cubes on balls");
            $(time!(group, $balls, $count);)*
            group.finish();
        }
    };
}

/// Times a chain at several states.
macro_rules! time {
    ($group:ident, $chain:ident, $count:literal) => {
        let chain = $chain::<f64>::new();
        let inputs = chain.no_inputs();
        let mut rate = chain.initial_state();
        let mut states = vec![chain.initial_state(); STATES.div_ceil($count)];
        set_randomly(&mut states);
        let mut index = 0;
        $group.throughput(Throughput::Elements($count));
        $group.bench_function(BenchmarkId::from_parameter($count), |bencher| {
            bencher.iter(|| {
                let state = black_box(&states[index]);
                let _ = black_box(chain.accelerations_into(state, &inputs, &mut rate.v));
                index = if index + 1 == states.len() { 0 } else { index + 1 };
            });
        });
    };
}

fn set_randomly<S: ChainState<Scalar = f64>>(states: &mut [S]) {
    let numbers = random_states::<S>(states.len());
    let each = numbers.chunks_exact(numbers_of_state::<S>());
    for (state, numbers) in states.iter_mut().zip(each) {
        (*state, _) = state_from(numbers.iter().copied());
    }
}

lengths! {
    Rods10 Balls10 10
    Rods30 Balls30 30
    Rods100 Balls100 100
    Rods300 Balls300 300
    Rods1000 Balls1000 1000
    Rods3000 Balls3000 3000
    Rods10000 Balls10000 10000
}

fn main() -> Result<(), Box<dyn Error>> {
    let run = || {
        let mut criterion = Criterion::default()
            .warm_up_time(Duration::from_millis(300))
            .measurement_time(Duration::from_millis(700))
            .sample_size(40)
            .configure_from_args();
        all_lengths(&mut criterion);
        criterion.final_summary();
    };
    let thread = thread::Builder::new().stack_size(STACK).spawn(run)?;
    thread.join().map_err(|_| "a length could not be timed".into())
}
