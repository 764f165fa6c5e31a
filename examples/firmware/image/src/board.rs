//! Measurement of ticks and stack on the processor.

use cortex_m::Peripherals;
use cortex_m::register::msp;

/// The largest count of the system timer, which counts down.
pub const TIMER_LIMIT: u32 = 0x00ff_ffff;

/// The registers of a timer of both boards that counts 32 bits down, in the Cortex-M System Design Kit: control, value,
/// reload. It ticks as often as the system timer, whose 24 bits end after 2.6 million instructions.
const TIMER: *mut [u32; 3] = 0x4000_0000 as *mut [u32; 3];

/// The timer as a stopwatch.
pub struct Board {
    _peripherals: Peripherals,
}

impl Board {
    /// Returns the board, only once.
    pub fn take() -> Option<Self> {
        let _peripherals = Peripherals::take()?;
        // SAFETY: these are the registers of the timer, which nothing else uses.
        unsafe { TIMER.write_volatile([0, u32::MAX, u32::MAX]) };
        // SAFETY: as above; the bit starts the timer.
        unsafe { TIMER.cast::<u32>().write_volatile(1) };
        Some(Self { _peripherals })
    }

    /// Returns the number of ticks of a function; on an emulator whose timer ticks with its instructions,
    /// they count instructions.
    #[inline(never)]
    pub fn ticks<R>(&mut self, work: impl FnOnce() -> R) -> (u32, R) {
        let start = value();
        let result = work();
        let end = value();
        (start.wrapping_sub(end), result)
    }
}

/// Returns the value of the timer.
fn value() -> u32 {
    // SAFETY: this is the second register of the timer.
    unsafe { TIMER.cast::<u32>().add(1).read_volatile() }
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
