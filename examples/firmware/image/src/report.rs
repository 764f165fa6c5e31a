//! Lines to the host in hexadecimal: the formatting of `core` may panic, and would be most of the image.

use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use cortex_m_semihosting::hio::{self, HostStream};
use models::Number;

/// The host's standard output.
pub struct Report {
    host: Option<HostStream>,
}

impl Default for Report {
    fn default() -> Self {
        Self::new()
    }
}

impl Report {
    /// Returns the host's output; without a host nothing is written.
    pub fn new() -> Self {
        Self { host: hio::hstdout().ok() }
    }

    /// Writes a name and some words.
    pub fn line(&mut self, name: &str, words: &[u32]) {
        self.text(name);
        words.iter().for_each(|&word| self.word(word.into(), 8));
        self.text("\n");
    }

    /// Writes a name and 64 bits.
    pub fn bits(&mut self, name: &str, bits: u64) {
        self.text(name);
        self.word(bits, 16);
        self.text("\n");
    }

    /// Writes a name and the bits of some numbers.
    pub fn numbers<T: Number>(&mut self, name: &str, numbers: impl IntoIterator<Item = T>) {
        self.text(name);
        numbers.into_iter().for_each(|number| self.word(number.bits(), 2 * size_of::<T>()));
        self.text("\n");
    }

    /// Ends the emulation successfully.
    pub fn success(&mut self) -> ! {
        debug::exit(EXIT_SUCCESS);
        halt()
    }

    /// Ends the emulation with an error.
    pub fn failure(&mut self, reason: &str) -> ! {
        self.text("failure ");
        self.text(reason);
        self.text("\n");
        debug::exit(EXIT_FAILURE);
        halt()
    }

    fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
    }

    /// Writes a blank and the last `digits` hexadecimal digits of `word`.
    #[inline(never)]
    fn word(&mut self, word: u64, digits: usize) {
        self.text(" ");
        for digit in (0..digits).rev() {
            let nibble = (word >> (4 * digit)) as u8 & 0xf;
            self.bytes(&[if nibble < 10 { b'0' + nibble } else { b'a' + nibble - 10 }]);
        }
    }

    // Neither this function nor `word` is inlined: there are many calls.
    #[inline(never)]
    fn bytes(&mut self, bytes: &[u8]) {
        if let Some(host) = &mut self.host {
            // An error of the host cannot be reported.
            let _ = host.write_all(bytes);
        }
    }
}

/// Loops forever: a real processor continues after a request to the debugger to stop.
fn halt() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}
