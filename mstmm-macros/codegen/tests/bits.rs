//! Hashes of all bits of the results of many chains, in a table. A change that claims to change no result must leave the
//! table unchanged. `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test bits` updates it.

mod common;

use common::given::slots;
use common::interpreter::{Arrays, run};
use mstmm_codegen::compile::{Compiled, CompiledFunction, compile, outputs};
use mstmm_codegen::examine::Findings;
use mstmm_codegen::function::Unknowns;
use mstmm_codegen::model::{Answer, Chain, Layout, SolutionMethod, Symbol, Value};
use mstmm_codegen::program::{Argument, ArrayRole, OutputId, Procedure};
use mstmm_reference::Random;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const STATES: u64 = 10;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// Returns the chains of a file, with the findings of their numerical evaluation.
fn chains(name: &str) -> Vec<(Chain, Findings)> {
    let text = std::fs::read_to_string(file(name)).expect("the chains");
    let read = mstmm_codegen::read_and_examine(text.parse().expect("tokens"));
    read.unwrap_or_else(|errors| {
        let texts: Vec<String> = errors.into_iter().map(|error| error.to_string()).collect();
        panic!("{name}: {texts:#?}")
    })
}

/// FNV-1a over the bits of all results.
#[derive(Clone, Copy)]
struct Hash(u64);

impl Hash {
    const EMPTY: Hash = Hash(0xcbf2_9ce4_8422_2325);

    /// Adds the results that are wanted, entry by entry; a value that is the same in all repetitions counts once.
    fn add(
        &mut self,
        procedure: &Procedure,
        arrays: &Arrays<f64>,
        wanted: impl Fn(OutputId) -> bool,
    ) {
        for array in &procedure.arrays {
            let ArrayRole::Result(id) = array.role else { continue };
            if !wanted(id) {
                continue;
            }
            let values = arrays.result(id);
            for segment in &array.layout.segments {
                for entry in 0..segment.count {
                    let repetitions = (0..segment.repetitions)
                        .map(|it| bits(values[segment.offset + it * segment.count + entry]));
                    let mut all: Vec<u64> = repetitions.collect();
                    if all.iter().all(|it| *it == all[0]) {
                        all.truncate(1);
                    }
                    all.into_iter().for_each(|bits| self.add_bits(bits));
                }
            }
        }
    }

    fn add_bits(&mut self, bits: u64) {
        for byte in bits.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// Returns the bits of a number. All NaNs count as the same, since sign and payload depend on the processor.
fn bits(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

/// Returns random values of all unknowns. Parameters are near their defaults, and all elimination steps of a loop closure are
/// taken.
fn arguments(chain: &Chain, unknowns: &Unknowns, random: &mut Random) -> Arrays<f64> {
    let mut arrays = Arrays::default();
    arrays.arguments.insert(Argument::Time, vec![0.0]);
    for (argument, layout) in unknowns.arguments() {
        let mut values = vec![f64::NAN; layout.total];
        for segment in &layout.segments {
            for entry in 0..segment.count {
                for repetition in 0..segment.repetitions {
                    let value = match argument {
                        Argument::Parameter(parameter) => {
                            let default = constant(chain, &chain.parameters[parameter].default);
                            default * random.between(0.9, 1.1)
                        }
                        Argument::ClosureSteps => 1.0,
                        _ => random.between(-1.0, 1.0),
                    };
                    values[segment.offset + repetition * segment.count + entry] = value;
                }
            }
        }
        arrays.arguments.insert(argument, values);
    }
    arrays
}

/// Returns the value of a parameter's default.
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

/// Whether a result counts for the row of its function. Slots are what the other functions read; the results of springs
/// have a row of their own.
fn counts_for_function(id: OutputId) -> bool {
    id != outputs::slots(id.part) && id != outputs::SPRINGS
}

/// Returns the hashes of all functions of a chain, and of the results of its springs.
fn hashes(chain: &Chain, findings: &Findings) -> Vec<(String, [Hash; 2])> {
    let compiled = compile(chain, findings, &Layout::of(chain));
    let name = |function: &CompiledFunction| match function.answer {
        Some(answer) => format!("{answer:?}"),
        None => "Setup".to_owned(),
    };
    let functions = || std::iter::once(&compiled.setup).chain(&compiled.functions);
    let mut hashes: Vec<_> = functions().map(|it| (name(it), [Hash::EMPTY; 2])).collect();
    let mut of_springs = [Hash::EMPTY; 2];
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let given =
            with_unit_quaternions(arguments(chain, &compiled.unknowns, &mut random), &compiled);
        for fused in [false, true] {
            let mut given = Arrays { fused, untested: true, ..given.clone() };
            for (function, (_, hashes)) in functions().zip(&mut hashes) {
                let mut arrays = given.clone();
                run(&function.procedure, &mut arrays).expect("nothing is tested");
                hashes[usize::from(fused)].add(&function.procedure, &arrays, counts_for_function);
                let is_springs = |id| id == outputs::SPRINGS;
                of_springs[usize::from(fused)].add(&function.procedure, &arrays, is_springs);
                if function.answer.is_none() {
                    given.arguments.extend(slots(&compiled, &arrays));
                }
            }
        }
    }
    if of_springs[0].0 != Hash::EMPTY.0 {
        hashes.push(("Springs".to_owned(), of_springs));
    }
    hashes
}

/// Normalises the quaternions among the arguments.
fn with_unit_quaternions(mut given: Arrays<f64>, compiled: &Compiled) -> Arrays<f64> {
    let mut arrays = given.clone();
    run(&compiled.function(Answer::Normalized).procedure, &mut arrays).expect("it cannot fail");
    given.arguments.insert(Argument::Coordinates, arrays.result(outputs::COORDINATES));
    given
}

fn table() -> String {
    let mut table =
        "chain           method   function               products and sums apart     fused\n"
            .to_owned();
    let counted = chains("operation_counts.chains").into_iter().flat_map(|(chain, findings)| {
        [SolutionMethod::Riccati, SolutionMethod::Transfer]
            .map(|method| (Chain { method: Some(method), ..chain.clone() }, findings.clone()))
    });
    for (chain, findings) in counted.chain(chains("bits.chains")) {
        let method = match chain.method {
            Some(SolutionMethod::Transfer) => "transfer",
            Some(SolutionMethod::Riccati) | None => "riccati",
        };
        for (function, [apart, fused]) in hashes(&chain, &findings) {
            let name = chain.name.to_string();
            writeln!(
                table,
                "{name:<15} {method:<8} {function:<21}  {:016x} {:016x}",
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
