//! What the generated code of the golden chains costs, kept in a table: a change that moves a count
//! shows in its diff. `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test operation_counts` accepts.

use mstmm_codegen::compile::programs;
use mstmm_codegen::model::{self, Layout, Method};
use mstmm_codegen::program::Cost;
use std::fmt::Write;
use std::path::Path;

const HEADER: &str = "\
chain           method    mul  add  recip  sqrt  sincos  total  with z
";

fn file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

fn chains() -> Vec<model::Chain> {
    let text = std::fs::read_to_string(file("operation_counts.chains")).expect("the chains");
    let chains = model::read(text.parse().expect("tokens")).unwrap_or_else(|e| panic!("{e}"));
    chains.into_iter().map(|(chain, _)| chain).collect()
}

fn table() -> String {
    let mut table = HEADER.to_owned();
    for mut chain in chains() {
        let layout = Layout::of(&chain);
        for (method, name) in [(Method::Riccati, "riccati"), (Method::Transfer, "transfer")] {
            chain.method = Some(method);
            let programs = programs(&chain, &layout);
            let cost = programs.accelerations.cost();
            let Cost { mul, add, recip, sqrt, trig } = cost;
            let (total, all) = (cost.arithmetic(), programs.solution.cost().arithmetic());
            writeln!(
                table,
                "{:<15} {name:<8} {mul:>4} {add:>4} {recip:>6} {sqrt:>5} {trig:>7} {total:>6} {all:>7}",
                chain.name.to_string()
            )
            .expect("text can be written");
        }
    }
    table
}

#[test]
fn counts_are_those_of_the_table() {
    let path = file("operation_counts.txt");
    let table = table();
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(&path, &table).expect("a writable folder");
    }
    let committed = std::fs::read_to_string(&path).expect("the table");
    assert!(table == committed, "now:\n{table}\nMSTMM_BLESS=1 accepts it");
}

/// Counts of a straightforward body-frame recursion on the same chains, traced with common
/// subexpressions and folding (multiplications, additions and reciprocals).
#[test]
fn counts_are_below_those_of_a_traced_recursion() {
    let limits = [("IiwaLike", 1599), ("IiwaAxial", 1280), ("Dh", 1831), ("BallPendulum", 661)];
    for chain in chains() {
        let limit = limits.iter().find(|(name, _)| chain.name == name);
        if let Some((name, limit)) = limit {
            let count = programs(&chain, &Layout::of(&chain)).accelerations.cost().arithmetic();
            assert!(count <= *limit, "{name}: {count} operations, {limit} were reached before");
        }
    }
}
