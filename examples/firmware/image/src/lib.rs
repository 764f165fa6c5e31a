//! Firmware that steps a chain, measures the steps, and reports to the host through the debugger.
//!
//! The [panic handler](panic) calls a function that does not exist, so an image whose steps can panic
//! does not link.
#![no_std]

mod board;
mod report;

pub use cortex_m_rt::{entry, exception};

use core::panic::PanicInfo;

use models::{Hash, MOTION_STEPS, Model, RANDOM_STATES, Random, SEED};
use mstmm::{ChainState, Error};

pub use board::{Board, TIMER_LIMIT};
pub use report::Report;

/// Takes one step as a timer's interrupt would; a separate function, so that it is found in the image.
#[inline(never)]
pub fn step<M: Model>(model: &M, work: &mut M::Work, state: &mut M::State) -> Result<(), Error> {
    #[cfg(feature = "control")]
    core::hint::black_box(can_panic());
    model.step(work, state)
}

/// An index that the compiler cannot check: the linker must reject this step.
#[cfg(feature = "control")]
fn can_panic() -> u8 {
    let numbers = core::hint::black_box([1, 2, 3]);
    numbers[core::hint::black_box(1)]
}

/// Measures steps from random states, then reports the end of a motion and the hash of all its bits.
pub fn run<M: Model>() -> ! {
    let mut report = Report::new();
    match measure::<M>(&mut report).and_then(|()| simulate::<M>(&mut report)) {
        Ok(()) => report.success(),
        Err(_) => report.failure("a step failed"),
    }
}

/// Measures instructions and stack of a step.
fn measure<M: Model>(report: &mut Report) -> Result<(), Error> {
    let Some(mut board) = Board::take() else { report.failure("the board is taken") };
    let (model, mut work, mut random) = (M::new(), M::work(), Random::new(SEED));
    let (mut fewest, mut most, mut deepest) = (u32::MAX, 0, 0);
    for _ in 0..RANDOM_STATES {
        let mut state = model.random_state(&mut random);
        model.advance(&mut work, &mut state)?;
        let mut other = state.clone();
        let (ticks, result) = board.ticks(|| step(&model, &mut work, &mut state));
        result?;
        (fewest, most) = (fewest.min(ticks), most.max(ticks));
        let (stack, result) = board::stack_used(|| step(&model, &mut work, &mut other));
        result?;
        deepest = deepest.max(stack);
    }
    // Many of these steps return an error; their time is measured as well.
    let mut longest = 0;
    model.for_each_bad_state(|mut state| {
        let _ = model.advance(&mut work, &mut state);
        let (ticks, _) = board.ticks(|| step(&model, &mut work, &mut state));
        longest = longest.max(ticks);
    });
    let (nothing, ()) = board.ticks(|| ());
    let counts = [fewest, most, longest].map(|ticks| ticks.saturating_sub(nothing));
    report.line("ticks", &counts);
    report.line("stack", &[deepest]);
    Ok(())
}

/// Simulates the motion from the start of the description.
fn simulate<M: Model>(report: &mut Report) -> Result<(), Error> {
    let (model, mut work) = (M::new(), M::work());
    let (mut state, mut hash) = (model.start(), Hash::default());
    for _ in 0..MOTION_STEPS {
        model.advance(&mut work, &mut state)?;
        step(&model, &mut work, &mut state)?;
        hash.add_state(&state);
        M::add_results(&work, &mut hash);
    }
    report.numbers("q", state.coordinates().iter().copied());
    report.numbers("v", state.rates().iter().copied());
    report.numbers("results", M::results(&work));
    report.bits("hash", hash.value());
    Ok(())
}

/// Calls a function that does not exist: code that may panic does not link.
#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: there is no such function, so nothing calls it.
    unsafe extern "C" {
        safe fn this_firmware_can_panic() -> !;
    }
    this_firmware_can_panic()
}
