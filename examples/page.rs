//! The page of a motion, which the programs write with `--page FILE`.

use mstmm::{Described, Error};
use mstmm_look::{Options, Recording};

/// A recording, if the program has the argument `--page FILE`.
pub struct Page<'a, C: Described>(Option<(Recording<'a, C>, String)>);

impl<'a, C: Described<Scalar = f64>> Page<'a, C> {
    /// Makes an empty recording of one state of how many.
    pub fn of(chain: &'a C, stride: usize) -> Self {
        let path = std::env::args().skip_while(|argument| argument != "--page").nth(1);
        let options = Options::default().stride(stride);
        Page(path.map(|path| (Recording::with(chain, options), path)))
    }

    /// Records a state.
    pub fn record(&mut self, state: &C::State, inputs: &C::Inputs) -> Result<(), Error> {
        self.0.as_mut().map_or(Ok(()), |(recording, _)| recording.record(state, inputs))
    }

    /// Writes the page.
    pub fn write(self) {
        if let Some((recording, path)) = self.0 {
            recording.write_html(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
            println!("{path} shows the motion");
        }
    }
}
