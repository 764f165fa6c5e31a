//! The progress of a run: a bar on a terminal, one line elsewhere. It goes to standard error, so that
//! standard output has the results only.

use std::cell::Cell;
use std::io::{IsTerminal, stderr};

use indicatif::{ProgressBar, ProgressStyle};

use crate::system::DURATION;

/// The ticks of the bar for a second of motion.
const TICKS_PER_SECOND: f64 = 10.0;

/// The progress of several motions of equal duration, one after the other.
pub struct Progress {
    /// `None` without a terminal.
    bar: Option<ProgressBar>,
    /// The ticks of all motions that are done.
    done: Cell<f64>,
    begun: Cell<bool>,
}

impl Progress {
    pub fn new(motions: usize) -> Self {
        let bar = stderr().is_terminal().then(|| {
            let ticks = motions as f64 * ticks_per_motion();
            let style = ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}");
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(ticks as u64).with_style(style)
        });
        if bar.is_none() {
            eprintln!("computing {motions} motions and measurements …");
        }
        Progress { bar, done: Cell::new(0.0), begun: Cell::new(false) }
    }

    /// Begins the next motion.
    pub fn begin(&self, what: &str) {
        if self.begun.replace(true) {
            self.done.set(self.done.get() + ticks_per_motion());
        }
        if let Some(bar) = &self.bar {
            bar.set_message(what.to_owned());
        }
    }

    /// Reports that the current motion has been computed up to a time in s.
    pub fn reach(&self, time: f64) {
        if let Some(bar) = &self.bar {
            bar.set_position((self.done.get() + time * TICKS_PER_SECOND) as u64);
        }
    }

    /// Removes the bar after the last motion.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn ticks_per_motion() -> f64 {
    f64::from(DURATION) * TICKS_PER_SECOND
}
