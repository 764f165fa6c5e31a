//! Emulated boards.

use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};

/// The emulator of both boards.
pub const EMULATOR: &str = "qemu-system-arm";

/// The shift for counting: an instruction takes 2⁸ ns of emulated time.
const COUNTING: u32 = 8;

/// The shift for realistic timing: an instruction takes 2⁵ ns.
const LIFELIKE: u32 = 5;

/// The system timer of both boards ticks at 25 MHz.
const NANOSECONDS_PER_TICK: u32 = 40;

/// The timeout of an image; on a slow machine an image runs for a minute.
const PATIENCE: Duration = Duration::from_secs(600);

/// A processor that the firmware is built for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Processor {
    /// With a floating-point unit for single precision, on the board MPS2 AN386.
    CortexM4,
    /// With a floating-point unit for both precisions, on the board MPS2 AN500.
    CortexM7,
}

impl Processor {
    pub const ALL: [Self; 2] = [Self::CortexM4, Self::CortexM7];

    /// Returns the compiler's name of the processor.
    pub fn name(self) -> &'static str {
        match self {
            Self::CortexM4 => "cortex-m4",
            Self::CortexM7 => "cortex-m7",
        }
    }

    fn board(self) -> &'static str {
        match self {
            Self::CortexM4 => "mps2-an386",
            Self::CortexM7 => "mps2-an500",
        }
    }

    /// Returns whether the processor has double precision in hardware.
    pub fn has_double(self) -> bool {
        self == Self::CortexM7
    }
}

/// The results of a run on a board.
#[derive(Clone, Debug)]
pub struct Run {
    /// Instructions of a step, over the random states.
    pub fewest: u32,
    pub most: u32,
    /// The same for states that are out of bounds or NaN.
    pub most_of_bad: u32,
    /// The largest stack depth of a step, in bytes.
    pub stack: u32,
    /// The bits of the coordinates and rates at the end of the motion.
    pub end: Vec<u64>,
    /// The bits of the results of the motion.
    pub results: Vec<u64>,
    /// The hash of the bits of all states of the motion.
    pub hash: u64,
}

/// The emulator and its version, if there is one.
pub fn emulator() -> Option<String> {
    let output = Command::new(EMULATOR).arg("--version").output().ok()?;
    let version = String::from_utf8_lossy(&output.stdout).lines().next()?.to_owned();
    output.status.success().then_some(version)
}

/// The results of the arm in a timer's interrupt.
#[derive(Clone, Debug)]
pub struct InterruptRun {
    /// The bits of the coordinates and rates at the end.
    pub end: Vec<u64>,
    /// The time from the timer's call to the end of the longest step, and the timer's period, in ticks.
    pub longest: u64,
    pub period: u64,
}

/// Measures the steps of an image.
pub fn run(processor: Processor, image: &Path) -> Result<Run> {
    Report::of(processor, image, COUNTING)?.run()
}

/// Runs the image in which the timer's interrupt steps the arm.
pub fn run_interrupt(processor: Processor, image: &Path) -> Result<InterruptRun> {
    let report = Report::of(processor, image, LIFELIKE)?;
    let [longest, period] = report.words("longest")?[..] else { bail!("longest are two numbers") };
    Ok(InterruptRun { end: report.end()?, longest, period })
}

/// The output of an image: lines with a name and words in hexadecimal.
struct Report(String);

impl Report {
    /// Runs an image to its end; an instruction takes 2 to the power of `shift` ns.
    fn of(processor: Processor, image: &Path, shift: u32) -> Result<Self> {
        let emulator = Command::new(EMULATOR)
            .args(["-machine", processor.board(), "-nographic", "-monitor", "none"])
            .args(["-serial", "none", "-semihosting-config", "enable=on,target=native"])
            .args(["-icount", &format!("shift={shift},align=off,sleep=off")])
            .arg("-kernel")
            .arg(image)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()?;
        let output = output(emulator, PATIENCE)
            .with_context(|| format!("{} on the {}", image.display(), processor.name()))?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        let complaint = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success(), "{} failed: {printed}{complaint}", image.display());
        Ok(Self(printed))
    }

    fn words(&self, name: &str) -> Result<Vec<u64>> {
        let mut lines = self.0.lines().map(str::split_whitespace);
        let words = lines.find_map(|mut words| (words.next()? == name).then_some(words));
        let Some(words) = words else { bail!("there is no {name} in {:?}", self.0) };
        words.map(|word| Ok(u64::from_str_radix(word, 16)?)).collect()
    }

    fn end(&self) -> Result<Vec<u64>> {
        Ok([self.words("q")?, self.words("v")?].concat())
    }

    fn run(&self) -> Result<Run> {
        let [fewest, most, bad] = self.words("ticks")?[..] else {
            bail!("ticks are three numbers")
        };
        let [stack] = self.words("stack")?[..] else { bail!("stack is one number") };
        let [hash] = self.words("hash")?[..] else { bail!("hash is one number") };
        Ok(Run {
            fewest: instructions(fewest),
            most: instructions(most),
            most_of_bad: instructions(bad),
            stack: stack.try_into()?,
            end: self.end()?,
            results: self.words("results")?,
            hash,
        })
    }
}

/// Returns the output of a program if it ends in time; the output must fit into a pipe.
fn output(mut program: Child, patience: Duration) -> Result<Output> {
    let start = Instant::now();
    while program.try_wait()?.is_none() {
        if start.elapsed() > patience {
            program.kill()?;
            bail!("no end after {patience:?}: {:?}", program.wait_with_output()?);
        }
        sleep(Duration::from_millis(20));
    }
    Ok(program.wait_with_output()?)
}

/// Returns the number of instructions for a number of ticks. An instruction takes 6.4 ticks, so an
/// error of one tick does not change the count.
fn instructions(ticks: u64) -> u32 {
    let nanoseconds = ticks * u64::from(NANOSECONDS_PER_TICK);
    let one = 1 << COUNTING;
    ((nanoseconds + one / 2) / one) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tick_more_or_less_is_no_instruction() {
        for ticks in 6400 - 2..=6400 + 2 {
            assert_eq!(instructions(ticks), 1000, "{ticks} ticks");
        }
        assert_eq!(instructions(6406), 1001);
    }

    #[test]
    fn endless_runs_are_ended() {
        let endless = Command::new("sleep").arg("60").spawn().expect("there is one");
        assert!(output(endless, Duration::from_millis(10)).is_err());
    }

    #[test]
    fn a_report_without_a_line_is_none() {
        let report = "ticks 00000040 00000080 00000046\nstack 00000010\nq 3f800000\nv 00000000\nresults 40000000\nhash 00ff\n";
        let run = Report(report.into()).run().expect("all lines are there");
        assert_eq!((run.fewest, run.most, run.most_of_bad), (10, 20, 11));
        assert_eq!((run.stack, run.hash), (16, 255));
        assert_eq!(run.end, [0x3f80_0000, 0]);
        assert_eq!(run.results, [0x4000_0000]);
        for missing in 0..6 {
            let lines = report.lines().enumerate().filter(|&(line, _)| line != missing);
            let rest: Vec<_> = lines.map(|(_, line)| line).collect();
            assert!(Report(rest.join("\n")).run().is_err());
        }
    }
}
