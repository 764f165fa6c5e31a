//! Every bit of what the functions of many chains compute, as hashes in a table: whoever claims to change no
//! number leaves the table alone. `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test bits` accepts.

mod common;

use common::interpreter::{Arguments, Results, run};
use mstmm_codegen::compile::{Programs, programs};
use mstmm_codegen::diag::Diagnostics;
use mstmm_codegen::examine::{Findings, examine};
use mstmm_codegen::model::{Chain, Layout, Method, Symbol, Value};
use mstmm_codegen::program::Program;
use mstmm_reference::Random;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const STATES: u64 = 10;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// The chains of a file, with what is found of them by trying.
fn chains(name: &str) -> Vec<(Chain, Findings)> {
    let text = std::fs::read_to_string(file(name)).expect("the chains");
    let read = mstmm_codegen::read(text.parse().expect("tokens"));
    let tried = |chain| {
        let findings = examine(&chain, &mut Diagnostics::default());
        (chain, findings)
    };
    let read = read.unwrap_or_else(|errors| {
        let texts: Vec<String> = errors.into_iter().map(|error| error.to_string()).collect();
        panic!("{name}: {texts:#?}")
    });
    read.into_iter().map(|(chain, _)| tried(chain)).collect()
}

/// FNV-1a over the bits of all results.
#[derive(Clone, Copy)]
struct Hash(u64);

impl Hash {
    const EMPTY: Hash = Hash(0xcbf2_9ce4_8422_2325);

    fn add(&mut self, results: &Results) {
        for value in results.iter().flatten().flatten() {
            // The sign and the payload of what is undefined are the processor's.
            let bits = if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() };
            for byte in bits.to_le_bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
}

/// All unknowns at random numbers, but for parameters, which are near their defaults, and the steps of a
/// closure, all of which are taken.
fn arguments(chain: &Chain, programs: &Programs, random: &mut Random) -> Arguments {
    let symbols = &programs.symbols;
    let repetitions: Vec<usize> = chain.repeats.iter().map(|repeat| repeat.count).collect();
    let all = symbols.parts().iter().enumerate().map(|(number, part)| {
        let one = |random: &mut Random| {
            let default = chain.parameters.get(number).map(|one| constant(chain, &one.default));
            let steps = symbols.closure_steps();
            match default {
                Some(default) => default * random.between(0.9, 1.1),
                None if steps.contains(&number) => 1.0,
                None => random.between(-1.0, 1.0),
            }
        };
        let count = part.map_or(1, |part| repetitions[part.index()]);
        (0..count).map(|_| one(random)).collect()
    });
    Arguments { symbols: all.collect(), repetitions: repetitions.clone(), ..Arguments::default() }
}

/// The value of what stands for a parameter's default.
fn constant(chain: &Chain, value: &Value) -> f64 {
    let go = |value: &Value| constant(chain, value);
    match value {
        Value::Number(number) => *number,
        Value::Sum(a, b) => go(a) + go(b),
        Value::Product(a, b) => go(a) * go(b),
        Value::Quotient(a, b) => go(a) / go(b),
        Value::Sqrt(a) => go(a).sqrt(),
        Value::Sin(a) => go(a).sin(),
        Value::Cos(a) => go(a).cos(),
        Value::Symbol(Symbol::Parameter(index)) => go(&chain.parameters[*index].default),
        Value::Symbol(Symbol::Constant(_)) => panic!("these chains have no Rust constants"),
    }
}

/// The functions of a chain besides its setup.
fn functions(programs: &Programs) -> Vec<(&'static str, &Program)> {
    let always = [
        ("accelerations", &programs.accelerations),
        ("solution", &programs.solution),
        ("energy", &programs.energy),
        ("coordinate rates", &programs.coordinate_rates),
        ("normalized", &programs.normalized),
        ("start", &programs.start),
    ];
    let some = [
        ("implicit", programs.implicit.as_ref().map(|(program, _)| program)),
        ("correction", programs.correction.as_ref()),
        ("closure pivots", programs.closure_pivots.as_ref()),
    ];
    let some = some.into_iter().filter_map(|(name, program)| Some((name, program?)));
    always.into_iter().chain(some).collect()
}

/// The hashes of all functions of a chain.
fn hashes(chain: &Chain, findings: &Findings) -> Vec<(&'static str, [Hash; 2])> {
    let programs = programs(chain, findings, &Layout::of(chain));
    let functions = functions(&programs);
    let mut hashes: Vec<_> = functions.iter().map(|(name, _)| (*name, [Hash::EMPTY; 2])).collect();
    hashes.push(("checks", [Hash::EMPTY; 2]));
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let mut arguments = arguments(chain, &programs, &mut random);
        for fused in [false, true] {
            arguments.fused = fused;
            let setup = run(&programs.setup, &arguments);
            arguments.slots = setup[0].iter().map(|slot| slot[0]).collect();
            arguments.repeated_slots = setup[2..].iter().map(|part| every(part, chain)).collect();
            for ((_, program), (_, hashes)) in functions.iter().zip(&mut hashes) {
                hashes[usize::from(fused)].add(&run(program, &arguments));
            }
            if let Some((_, hashes)) = hashes.last_mut() {
                hashes[usize::from(fused)].add(&setup[1..2].to_vec());
            }
        }
    }
    hashes
}

/// The slots of a repeated part; what is the same in every repetition stands once.
fn every(part: &[Vec<f64>], chain: &Chain) -> Vec<Vec<f64>> {
    let most = chain.repeats.iter().map(|repeat| repeat.count).max().unwrap_or(1);
    let spread = |slot: &Vec<f64>| if slot.len() == 1 { vec![slot[0]; most] } else { slot.clone() };
    part.iter().map(spread).collect()
}

fn table() -> String {
    let mut table =
        "chain           method   function          products and sums apart     fused\n".to_owned();
    let counted = chains("operation_counts.chains").into_iter().flat_map(|(chain, findings)| {
        [Method::Riccati, Method::Transfer]
            .map(|method| (Chain { method: Some(method), ..chain.clone() }, findings.clone()))
    });
    for (chain, findings) in counted.chain(chains("bits.chains")) {
        let method = match chain.method {
            Some(Method::Transfer) => "transfer",
            Some(Method::Riccati) | None => "riccati",
        };
        for (function, [apart, fused]) in hashes(&chain, &findings) {
            let name = chain.name.to_string();
            writeln!(
                table,
                "{name:<15} {method:<8} {function:<16}  {:016x} {:016x}",
                apart.0, fused.0
            )
            .expect("text can be written");
        }
    }
    table
}

#[test]
fn bits_are_those_of_the_table() {
    let path = file("bits.txt");
    let table = table();
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(&path, &table).expect("a writable folder");
    }
    let committed = std::fs::read_to_string(&path).expect("the table");
    let changed: Vec<&str> = table.lines().filter(|line| !committed.contains(line)).collect();
    assert!(table == committed, "changed:\n{}\nMSTMM_BLESS=1 accepts it", changed.join("\n"));
}
