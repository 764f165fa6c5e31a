//! Builds the firmware for two processors, analyses the images, runs them on emulated boards and on this
//! machine, and compares the steps with their budgets.

mod board;
mod build;
mod callgrind;
mod case;
mod findings;
mod host;
mod image;
mod payload;
mod steps;
mod table;
mod thumb;

use anyhow::{Context, Result, bail, ensure};

use crate::board::Processor;
use crate::case::Case;
use crate::findings::Findings;
use crate::payload::Payload;
use crate::table::{Row, Table};

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => check(false),
        ["--bless"] => check(true),
        [callgrind::STEPS, name] => steps::take(Case::of_name(name).context("no such case")?),
        _ => bail!("unknown arguments; the only option is --bless, which stores the figures"),
    }
}

/// Runs all checks; stores the figures, or compares them with the stored figures.
fn check(bless: bool) -> Result<()> {
    let mut findings = Findings::default();
    let mut table = Table::default();

    println!("A step that can panic must not link");
    findings.require(build::control_is_refused()?, || "a step that can panic was linked".into());

    let emulator = board::emulator();
    let valgrind = callgrind::version();
    ensure!(
        !bless || emulator.is_some() && valgrind.is_some(),
        "the figures need {} and valgrind: one of them is missing",
        board::EMULATOR
    );
    for case in Case::ALL {
        let host = host::simulate(case);
        println!("\n{case}: {host}");
        if case.estimates() {
            let payload = Payload::read(&host.results, case.precision)?;
            println!("  {payload}");
            findings.of_payload(case, &payload);
        }
        for processor in Processor::ALL {
            let path = build::image(case.name(), processor)?;
            let image = image::read(&path)?;
            let run = emulator.as_ref().map(|_| board::run(processor, &path)).transpose()?;
            let row = Row { case, processor, image, run };
            println!("{row}");
            findings.of_image(&row, &host);
            table.rows.push(row);
        }
        if valgrind.is_some() {
            let counts = callgrind::steps(case)?;
            println!("  this machine: {counts}");
            findings.require(counts.fewest == counts.most, || {
                format!("{case} on this machine: instructions depend on the state, {counts}")
            });
            table.host.push((case, counts));
        }
        table.motions.push((case, host));
    }
    if emulator.is_some() {
        println!("\nThe arm in an interrupt, 1000 times a second");
        for processor in Processor::ALL {
            let run = board::run_interrupt(processor, &build::image("interrupt", processor)?)?;
            println!("  {}: {} of {} ticks", processor.name(), run.longest, run.period);
            findings.of_interrupt(processor, &run, &host::arm_of_interrupt());
        }
    } else {
        println!(
            "skipped: bits and instructions on the boards, since there is no {}",
            board::EMULATOR
        );
    }
    if valgrind.is_none() {
        println!("skipped: instructions on this machine, since there is no valgrind");
    }
    table.tools.extend([build::compiler()?].into_iter().chain(emulator).chain(valgrind));
    findings.of_table(&table, bless)?;
    findings.conclude()
}
