//! The arm in a timer's interrupt, 1000 times a second, as in a product: the interrupt owns the model, and
//! the main loop has copies of the values it needs.
#![no_std]
#![no_main]

use core::cell::Cell;
use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use cortex_m::interrupt::{Mutex, free};
use cortex_m::peripheral::syst::SystClkSource;
use image::{Report, TIMER_LIMIT, entry, exception};
use models::{Arm, ArmState, INTERRUPT_STEPS, Model};
use mstmm::Rk4;

/// The clock frequency of the board in Hz.
const CLOCK_HZ: u32 = 25_000_000;
const STEPS_PER_SECOND: u32 = 1000;
const RELOAD: u32 = CLOCK_HZ / STEPS_PER_SECOND - 1;

/// The values that the interrupt passes to the main loop.
static STATE: Mutex<Cell<Option<ArmState<f32>>>> = Mutex::new(Cell::new(None));
static TAKEN: AtomicU32 = AtomicU32::new(0);
static FAILED: AtomicBool = AtomicBool::new(false);
static LONGEST: AtomicU32 = AtomicU32::new(0);

/// The state of the interrupt between two calls.
struct Simulation {
    arm: Arm<f32>,
    rk4: Rk4<Arm<f32>>,
    state: ArmState<f32>,
}

impl Simulation {
    fn new() -> Self {
        let arm = Arm::new();
        Self { rk4: Arm::work(), state: arm.start(), arm }
    }
}

#[exception]
fn SysTick() {
    static mut SIMULATION: Option<Simulation> = None;

    if TAKEN.load(Ordering::Relaxed) == INTERRUPT_STEPS {
        return;
    }
    let Simulation { arm, rk4, state } = SIMULATION.get_or_insert_with(Simulation::new);
    // A step that fails leaves the state unchanged: here a product would go to its safe state.
    if image::step(arm, rk4, state).is_err() {
        FAILED.store(true, Ordering::Relaxed);
    }
    let copy = state.clone();
    free(|token| STATE.borrow(token).set(Some(copy)));
    TAKEN.store(TAKEN.load(Ordering::Relaxed) + 1, Ordering::Release);
    // The timer counts down and restarted at the call: this is the time since the call.
    let passed = RELOAD - cortex_m::peripheral::SYST::get_current();
    LONGEST.store(LONGEST.load(Ordering::Relaxed).max(passed), Ordering::Relaxed);
}

#[entry]
fn main() -> ! {
    let mut report = Report::new();
    let Some(mut board) = cortex_m::Peripherals::take() else { report.failure("no board") };
    board.SYST.set_clock_source(SystClkSource::Core);
    board.SYST.set_reload(RELOAD & TIMER_LIMIT);
    board.SYST.clear_current();
    board.SYST.enable_counter();
    board.SYST.enable_interrupt();

    while TAKEN.load(Ordering::Acquire) < INTERRUPT_STEPS {
        cortex_m::asm::wfi();
    }
    let state = free(|token| STATE.borrow(token).take());
    match state {
        Some(state) if !FAILED.load(Ordering::Relaxed) => {
            report.numbers("q", state.q.iter().copied());
            report.numbers("v", state.v.iter().copied());
            report.line("longest", &[LONGEST.load(Ordering::Relaxed), RELOAD + 1]);
            report.success()
        }
        _ => report.failure("a step failed"),
    }
}
