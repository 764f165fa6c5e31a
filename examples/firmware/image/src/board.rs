//! Measurement of ticks and stack on the processor.

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::register::msp;

/// The largest count of the system timer, which counts down.
pub const TIMER_LIMIT: u32 = 0x00ff_ffff;

/// The system timer as a stopwatch.
pub struct Board {
    _timer: SYST,
}

impl Board {
    /// Returns the board, only once.
    pub fn take() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(TIMER_LIMIT);
        timer.clear_current();
        timer.enable_counter();
        Some(Self { _timer: timer })
    }

    /// Returns the number of ticks of a function; on an emulator whose timer ticks with its instructions,
    /// they count instructions.
    #[inline(never)]
    pub fn ticks<R>(&mut self, work: impl FnOnce() -> R) -> (u32, R) {
        let start = SYST::get_current();
        let result = work();
        let end = SYST::get_current();
        (start.wrapping_sub(end) & TIMER_LIMIT, result)
    }
}

/// The pattern that is painted on the stack, and the size of the painted part in bytes.
const PAINT: u32 = 0xa5c3_a5c3;
const PAINTED: usize = 16 * 1024;

/// Returns the stack depth of a function in bytes, below the frame of its caller.
#[inline(never)]
pub fn stack_used<R>(work: impl FnOnce() -> R) -> (u32, R) {
    let top = msp::read() as usize;
    let words = || (top - PAINTED..top).step_by(size_of::<u32>());
    // SAFETY: this is memory below the stack pointer, which nothing else uses; the memory map leaves more
    // than that between the data and the stack, and no interrupt is enabled.
    words().for_each(|word| unsafe { (word as *mut u32).write_volatile(PAINT) });
    let result = work();
    // SAFETY: as above.
    let left = words().take_while(|&word| unsafe { (word as *const u32).read_volatile() } == PAINT);
    ((PAINTED - left.count() * size_of::<u32>()) as u32, result)
}
