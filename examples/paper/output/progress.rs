//! Says how far the run has come: a bar on a terminal, plain lines elsewhere. All of it goes to
//! standard error, so that standard output holds results only.

use std::cell::Cell;
use std::io::{IsTerminal, stderr};

use indicatif::{ProgressBar, ProgressStyle};

use crate::system::DURATION;

/// How finely the bar divides a second of motion.
const TICKS_PER_SECOND: f64 = 10.0;

/// The progress of several motions of equal duration, one after the other.
pub struct Progress {
    /// None without a terminal.
    bar: Option<ProgressBar>,
    /// The ticks of all motions before the present one.
    behind: Cell<f64>,
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
        Progress { bar, behind: Cell::new(0.0), begun: Cell::new(false) }
    }

    /// The next motion begins.
    pub fn begin(&self, what: &str) {
        if self.begun.replace(true) {
            self.behind.set(self.behind.get() + ticks_per_motion());
        }
        match &self.bar {
            Some(bar) => bar.set_message(what.to_owned()),
            None => eprintln!("{what}"),
        }
    }

    /// The present motion has been computed up to a time in s.
    pub fn reach(&self, time: f64) {
        if let Some(bar) = &self.bar {
            bar.set_position((self.behind.get() + time * TICKS_PER_SECOND) as u64);
        }
    }

    /// All motions are done; the bar makes way for the results.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn ticks_per_motion() -> f64 {
    f64::from(DURATION) * TICKS_PER_SECOND
}
