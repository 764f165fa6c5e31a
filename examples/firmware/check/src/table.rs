//! The figures, as printed and stored.

use std::fmt;
use std::path::PathBuf;

use crate::board::{Processor, Run};
use crate::callgrind::Counts;
use crate::case::Case;
use crate::host::Motion;
use crate::image::Image;

/// An image and its results.
pub struct Row {
    pub case: Case,
    pub processor: Processor,
    pub image: Image,
    /// The results of the emulator, if there is one.
    pub run: Option<Run>,
}

/// All figures of a run.
#[derive(Default)]
pub struct Table {
    pub rows: Vec<Row>,
    pub host: Vec<(Case, Counts)>,
    pub motions: Vec<(Case, Motion)>,
    pub tools: Vec<String>,
}

impl Table {
    /// The file of the stored figures.
    pub fn path() -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../FIGURES.md")
    }
}

/// Returns the line of a motion in the stored figures.
pub fn bits(case: Case, motion: &Motion) -> String {
    format!("| `{case}` | `{:016x}` |", motion.hash)
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Image { flash, ram, code, stack, loops, .. } = &self.image;
        write!(f, "  {}: ", self.processor.name())?;
        if let Some(run) = &self.run {
            write!(f, "{} to {} instructions a step, ", run.fewest, run.most)?;
            write!(f, "{} from bad states; stack {} of ", run.most_of_bad, run.stack)?;
        } else {
            write!(f, "stack ")?;
        }
        write!(f, "{stack} bytes; code {code}, flash {flash}, RAM {ram} bytes; loops")?;
        for (name, count) in loops {
            write!(f, " {count} in {name}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "# Cost of a step\n")?;
        writeln!(f, "Written by `./run --bless`; see `README.md`. Measured with")?;
        writeln!(f, "{}.\n", self.tools.join(", "))?;
        heading(f, &BOARD_COLUMNS)?;
        for row in &self.rows {
            writeln!(f, "| {} |", row.cells().join(" | "))?;
        }
        writeln!(f)?;
        heading(f, &["on x86-64, by callgrind", "instructions, fewest", "most"])?;
        for (case, counts) in &self.host {
            writeln!(f, "| `{case}` | {} | {} |", counts.fewest, counts.most)?;
        }
        writeln!(f)?;
        heading(f, &["motion", "hash of all bits of all states, everywhere"])?;
        for (case, motion) in &self.motions {
            writeln!(f, "{}", bits(*case, motion))?;
        }
        Ok(())
    }
}

const BOARD_COLUMNS: [&str; 10] = [
    "image, processor",
    "instructions, fewest",
    "most",
    "from bad states, most",
    "stack, bytes",
    "at most",
    "code of a step, bytes",
    "flash of the image",
    "RAM",
    "loops of a step",
];

/// Writes the names of columns; all but the first are aligned to the right.
fn heading(f: &mut fmt::Formatter<'_>, names: &[&str]) -> fmt::Result {
    writeln!(f, "| {} |", names.join(" | "))?;
    writeln!(f, "|---{}|", "|---:".repeat(names.len() - 1))
}

impl Row {
    fn cells(&self) -> [String; BOARD_COLUMNS.len()] {
        let Self { case, processor, image, run } = self;
        let of_run = |figure: fn(&Run) -> u32| {
            run.as_ref().map_or("?".into(), |run| figure(run).to_string())
        };
        [
            format!("`{case}`, {}", processor.name()),
            of_run(|run| run.fewest),
            of_run(|run| run.most),
            of_run(|run| run.most_of_bad),
            of_run(|run| run.stack),
            image.stack.to_string(),
            image.code.to_string(),
            image.flash.to_string(),
            image.ram.to_string(),
            image.loops.values().sum::<usize>().to_string(),
        ]
    }
}
