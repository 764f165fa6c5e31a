//! The requirements, and the violations found.

use std::fs;

use anyhow::{Context, Result, bail};

use crate::board::{InterruptRun, Processor};
use crate::case::{Case, Precision};
use crate::host::Motion;
use crate::payload::Payload;
use crate::table::{self, Row, Table};

/// Parts of the names of functions that allocate.
const PANICS: [&str; 2] = ["panic", "unwind"];
const ALLOCATIONS: [&str; 4] = ["__rust_alloc", "__rust_dealloc", "malloc", "alloc::"];

/// The largest number of bytes of data in an image: an allocator that is inlined has no name, but needs
/// memory.
const MOST_DATA: u64 = 64;

/// The most instructions that a failed step searches for the value that is not finite: about eight for each value of
/// the state, the inputs and the accelerations, of which a case has up to 30.
const MOST_SEARCH: u32 = 250;

/// Parts of the names of functions that emulate double precision by integers.
const SOFT_DOUBLES: [&str; 3] = ["__aeabi_d", "__aeabi_f2d", "df3"];

/// All violations, in the order in which they were found.
#[derive(Default)]
pub struct Findings {
    wrong: Vec<String>,
}

impl Findings {
    /// Adds a violation if a condition does not hold.
    pub fn require(&mut self, holds: bool, otherwise: impl FnOnce() -> String) {
        if !holds {
            self.wrong.push(otherwise());
        }
    }

    /// Compares an image with this machine.
    pub fn of_image(&mut self, row: &Row, host: &Motion) {
        let Row { case, processor, image, run } = row;
        let name = format!("{case} on the {}", processor.name());
        let is_single = case.precision == Precision::Single;
        let by_whole_numbers = !is_single && !processor.has_double();

        for unwanted in [&PANICS[..], &ALLOCATIONS] {
            let found = image.named(unwanted);
            self.require(found.is_empty(), || format!("{name}: the image holds {found:?}"));
        }
        self.require(image.ram <= MOST_DATA, || {
            format!("{name}: {} bytes of data, more than {MOST_DATA}", image.ram)
        });
        let doubles = image.named(&SOFT_DOUBLES);
        // Images that need these functions show that the search finds them.
        self.require(doubles.is_empty() != by_whole_numbers, || {
            format!("{name}: routines for double precision: {doubles:?}")
        });

        if let Some(budget) = case.budget() {
            self.require(image.stack <= budget.stack, || {
                format!("{name}: {} bytes of stack, more than {}", image.stack, budget.stack)
            });
            self.require(budget.code.is_none_or(|code| image.code <= code), || {
                format!("{name}: {} bytes of code, more than {:?}", image.code, budget.code)
            });
            let most = run.as_ref().map_or(0, |run| run.most);
            self.require(most <= budget.instructions, || {
                format!("{name}: {most} instructions, more than {}", budget.instructions)
            });
        }

        let Some(run) = run else { return };
        let is_same = run.end == host.end && run.hash == host.hash && run.results == host.results;
        self.require(is_same, || {
            format!("{name}: other bits than on this machine, hash {:016x}", run.hash)
        });
        self.require(run.stack <= image.stack, || {
            format!("{name}: {} bytes of stack, more than the bound {}", run.stack, image.stack)
        });
        // The cost of emulated arithmetic depends on its values: this difference shows that the
        // count would detect such a dependence elsewhere.
        self.require((run.fewest == run.most) != by_whole_numbers, || {
            format!("{name}: {} to {} instructions", run.fewest, run.most)
        });
        self.require(by_whole_numbers || run.most_of_bad <= run.most + MOST_SEARCH, || {
            format!("{name}: {} instructions from a bad state", run.most_of_bad)
        });
    }

    /// Compares the estimate of a payload with the true one, on this machine and with the same bits on the boards.
    pub fn of_payload(&mut self, case: Case, payload: &Payload) {
        self.require(payload.is_found(), || format!("{case}: {payload}"));
        let [before, after] = payload.errors;
        // The controller holds its torques for a period, which leaves a smaller error.
        self.require(after < before / 100.0, || format!("{case}: {payload}"));
    }

    /// Compares the arm in an interrupt with the same steps on this machine.
    pub fn of_interrupt(&mut self, processor: Processor, run: &InterruptRun, end: &[u64]) {
        let name = format!("interrupt on the {}", processor.name());
        self.require(run.end == end, || format!("{name}: other bits than on this machine"));
        self.require(run.longest < run.period, || {
            format!("{name}: a step took {} ticks of {}", run.longest, run.period)
        });
    }

    /// Compares the hashes with those in the stored figures.
    pub fn of_table(&mut self, table: &Table, bless: bool) -> Result<()> {
        let path = Table::path();
        if bless {
            println!("wrote {}", path.display());
            return Ok(fs::write(path, table.to_string())?);
        }
        let kept = fs::read_to_string(&path).context("the stored figures cannot be read")?;
        for (case, motion) in &table.motions {
            self.of_motion(&kept, *case, motion);
        }
        if kept != table.to_string() {
            println!("\nSome figures differ from {}; now they are\n\n{table}", path.display());
        }
        Ok(())
    }

    fn of_motion(&mut self, kept: &str, case: Case, motion: &Motion) {
        self.require(kept.contains(&table::bits(case, motion)), || {
            format!(
                "{case}: other bits than the figures have, hash {:016x}; --bless keeps them",
                motion.hash
            )
        });
    }

    /// Fails with all violations.
    pub fn conclude(self) -> Result<()> {
        if !self.wrong.is_empty() {
            bail!("\n{}", self.wrong.join("\n"));
        }
        println!("\nAll requirements are met.");
        Ok(())
    }
}
