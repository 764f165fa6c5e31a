//! Simulation of arms, with timing.

use std::io::{IsTerminal, stderr};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use mstmm::lanes::{NativeF32, NativeF64};
use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use mstmm::{Error, Scalar};
use mstmm_payloads::{RESULTS, STEPS, Sample, simulate};
use rayon::prelude::*;
use serde::Serialize;

/// The results of an arm.
type End = [f64; RESULTS.len()];

/// A scalar type to simulate with.
#[derive(Clone, Copy)]
pub struct Way {
    name: &'static str,
    lanes: usize,
    simulate: fn(&[Sample], u32) -> Result<Vec<End>, Error>,
}

macro_rules! ways {
    ($($number:ident)*) => {
        &[$(Way {
            name: stringify!($number),
            lanes: <$number as Scalar>::LANES,
            simulate: simulate::<$number>,
        }),*]
    };
}

/// One by one.
pub const ONE_BY_ONE: &[Way] = ways!(f64);

/// In lanes. Lanes that are wider than the registers need several registers for each value.
pub const DOUBLE: Precision =
    Precision { ways: ways!(f64x2 f64x4 f64x8), native: NativeF64::LANES };
pub const SINGLE: Precision =
    Precision { ways: ways!(f32x4 f32x8 f32x16), native: NativeF32::LANES };

/// The types of one precision.
#[derive(Clone, Copy)]
pub struct Precision {
    pub ways: &'static [Way],
    /// Returns the number of lanes that fit into a register.
    native: usize,
}

impl Precision {
    /// Returns the type whose lanes fit into a register.
    pub fn native(self) -> Option<Way> {
        self.ways.iter().find(|way| way.lanes == self.native).copied()
    }
}

/// The duration of the simulations with one scalar type.
#[derive(Serialize)]
pub struct Run {
    pub number: &'static str,
    pub lanes: usize,
    pub cores: usize,
    pub arms: usize,
    pub seconds: f64,
    /// Steps of one arm; each takes four evaluations.
    pub steps_per_second: f64,
}

impl Way {
    /// Simulates chunks of arms on a number of cores and measures the time.
    pub fn run(
        self,
        arms: &[Sample],
        chunk: usize,
        cores: usize,
        progress: &Progress,
    ) -> Result<(Run, Vec<End>), Box<dyn std::error::Error>> {
        let Self { name: number, lanes, simulate } = self;
        progress.begin(&format!("{number}, {}", count(cores, "core")));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(cores).build()?;
        let start = Instant::now();
        let parts: Result<Vec<Vec<End>>, Error> = pool.install(|| {
            let part = |arms: &[Sample]| {
                let ends = simulate(arms, 1)?;
                progress.advance(arms.len());
                Ok(ends)
            };
            arms.par_chunks(chunk).map(part).collect()
        });
        let seconds = start.elapsed().as_secs_f64();
        let (ends, arms) = (parts?.concat(), arms.len());
        let steps_per_second = arms as f64 * f64::from(STEPS) / seconds;
        Ok((Run { number, lanes, cores, arms, seconds, steps_per_second }, ends))
    }

    /// Returns the results of arms with `finer` times the steps, without timing.
    pub fn ends(self, arms: &[Sample], finer: u32) -> Result<Vec<End>, Error> {
        (self.simulate)(arms, finer)
    }
}

/// Returns a number with its noun in the singular or plural.
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// The progress of all runs: a bar on a terminal, plain lines elsewhere. It is written to standard
/// error, so that standard output contains only results.
pub struct Progress(Option<ProgressBar>);

impl Progress {
    pub fn new(arms: usize) -> Self {
        Self(stderr().is_terminal().then(|| {
            let style = ProgressStyle::with_template("{bar:30} {percent:>3} %, {eta}  {msg}");
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(arms as u64).with_style(style)
        }))
    }

    fn begin(&self, what: &str) {
        match &self.0 {
            Some(bar) => bar.set_message(what.to_owned()),
            None => eprintln!("{what}"),
        }
    }

    fn advance(&self, arms: usize) {
        if let Some(bar) = &self.0 {
            bar.inc(arms as u64);
        }
    }

    /// Removes the bar before the results are printed.
    pub fn finish(&self) {
        if let Some(bar) = &self.0 {
            bar.finish_and_clear();
        }
    }
}
