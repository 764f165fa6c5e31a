//! The operation counts of the golden chains, in a table, so that a diff shows every change of a count.
//! `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test operation_counts` updates it.

use mstmm_codegen::compile::{Compiled, compile};
use mstmm_codegen::diag::Diagnostics;
use mstmm_codegen::examine::{Findings, examine};
use mstmm_codegen::model::{self, Answer, Layout, Results, SolutionMethod};
use mstmm_codegen::program::Cost;
use std::fmt::Write;
use std::path::Path;

const HEADER: &str = "\
chain           method     mul   add  recip  sqrt  sincos  total  with z      all
";

fn file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

fn chains() -> Vec<(model::Chain, Findings)> {
    let text = std::fs::read_to_string(file("operation_counts.chains")).expect("the chains");
    let chains =
        mstmm_codegen::read(text.parse().expect("tokens")).unwrap_or_else(|e| panic!("{e}"));
    let tried = |chain| {
        // The rank of a closure is found by trying.
        let findings = examine(&chain, &mut Diagnostics::default());
        (chain, findings)
    };
    chains.into_iter().map(|(chain, _)| tried(chain)).collect()
}

fn cost(compiled: &Compiled, answer: Answer) -> Cost {
    compiled.function(answer).procedure.cost()
}

fn table() -> String {
    let mut table = HEADER.to_owned();
    for (mut chain, findings) in chains() {
        let layout = Layout::of(&chain);
        for (method, name) in
            [(SolutionMethod::Riccati, "riccati"), (SolutionMethod::Transfer, "transfer")]
        {
            chain.method = Some(method);
            let compiled = compile(&chain, &findings, &layout);
            let fast = cost(&compiled, Answer::Accelerations);
            let Cost { mul, add, recip, sqrt, trig } = fast;
            let (total, all) = (fast.arithmetic(), cost(&compiled, Answer::Solution).arithmetic());
            let with_z = solution_with_z(&chain, &findings, &layout);
            writeln!(
                table,
                "{:<15} {name:<8} {mul:>5} {add:>5} {recip:>6} {sqrt:>5} {trig:>7} {total:>6} {with_z:>7} {all:>8}",
                chain.name.to_string()
            )
            .expect("text can be written");
        }
    }
    table
}

/// Returns the operation count of a solution with the state vectors z only.
fn solution_with_z(chain: &model::Chain, findings: &Findings, layout: &Layout) -> usize {
    let chain = model::Chain { results: Results { z: true, ..Results::NONE }, ..chain.clone() };
    cost(&compile(&chain, findings, layout), Answer::Solution).arithmetic()
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

/// Named points cost no operations, and the workspace stores only points that parameters change.
#[test]
fn points_of_bodies_cost_nothing() {
    let of = |points: &str| {
        let text = format!(
            "chain Arm {{
                gravity = [0, 0, -9.8];
                param reach = 1;
                body Rod {{
                    mass = 1;
                    com = [0.5, 0.1, 0];
                    output = [1, 0, 0];
                    inertia = diag(1, 1, 1) about com;
                    {points}
                }}
                ground -> pin(y) base -> Rod first -> repeat 3 {{ ball joint -> Rod rod }};
            }}"
        );
        let mut chains =
            mstmm_codegen::read(text.parse().expect("tokens")).unwrap_or_else(|e| panic!("{e}"));
        let (chain, _) = chains.remove(0);
        let compiled = compile(&chain, &Findings::default(), &Layout::of(&chain));
        let kept: usize = compiled.point_storage.segments.iter().map(|(count, _)| count).sum();
        (
            cost(&compiled, Answer::Accelerations),
            cost(&compiled, Answer::Solution),
            compiled.setup.procedure.cost(),
            kept,
        )
    };
    let (accelerations, solution, setup, kept) = of("");
    let fixed = of("point tip = [1, 0.2, 0.3]; point mark = [CONSTANT, 0, 2 * CONSTANT];");
    assert_eq!(fixed, (accelerations, solution, setup, kept));
    let changing = of("point tip = [reach, 0.2, 0]; point mark = [0, 2 * reach, -reach];");
    assert_eq!((changing.0, changing.1), (accelerations, solution));
    // Two vectors for the single body, and two for the repeated bodies.
    assert_eq!(changing.3, kept + 12);
}
