//! Each figure in the README's text is one that another test or a manifest holds.

use super::read;

/// Names and quantities with digits that are no results.
const NAMES: [&str; 11] = [
    "section 4.1 of the paper",
    "section 4.2",
    "Multibody System Dynamics 38 (2016)",
    "MIT or Apache-2.0",
    "Dormand–Prince 5(4)",
    "RK4",
    "Cortex-M4F",
    "Cortex-M7",
    "x86-64",
    "a C header",
    "Unitree G1",
];

/// The rows of the operation table, by the chains that they stand for.
fn operations() -> Vec<String> {
    let rows = [
        ("three balls (section 4.1 of the paper)", "BallPendulum"),
        ("three parallel pins (section 4.2)", "PinArmA"),
        ("seven pins, DH geometry, full tensors", "Dh"),
        ("Franka Emika Panda", "Panda"),
        ("thirty balls", "ThirtyBalls"),
    ];
    let counts = read("mstmm-macros/codegen/tests/operation_counts.txt");
    // From the right: everything, with z, accelerations.
    let count = |chain: &str, method: &str, column: usize| {
        let mut lines = counts.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
        let line = lines.find(|words| words[..2] == [chain, method]).expect("a row of the table");
        line[line.len() - column].to_owned()
    };
    let row = |(label, chain)| {
        let [accelerations, forces] = [3, 2].map(|column| count(chain, "riccati", column));
        let transfer = count(chain, "transfer", 3);
        format!("| {label} | {accelerations} | {forces} | {transfer} |")
    };
    rows.into_iter().map(row).collect()
}

/// The rows of the table of times, from the benchmarks' table.
fn times() -> Vec<String> {
    let rows = [
        ("ten rods on parallel pins", "A10"),
        ("three cubes on balls", "B3"),
        ("Franka Emika Panda", "D7"),
        ("HyQ, a quadruped that floats", "HyQ"),
        ("Unitree G1, a humanoid that floats", "G1"),
    ];
    let benches = read("benches/README.md");
    let row = |(label, chain)| {
        let start = format!("| {chain}, accelerations |");
        let row = benches.lines().find(|line| line.starts_with(&start)).expect("a row");
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        // This library, the fastest C, Pinocchio, MuJoCo.
        let [ours, c, pinocchio] = [2, 5, 7].map(|cell| cells[cell]);
        // Robots that float were not timed in MuJoCo: the last column is a ratio.
        match chain {
            "HyQ" | "G1" => format!("| {label} | {ours} | {c} | {pinocchio} | |"),
            _ => format!("| {label} | {ours} | {c} | {pinocchio} | {} |", cells[8]),
        }
    };
    rows.into_iter().map(row).collect()
}

/// The rows of the table of answers of the Panda, from the benchmarks' table.
fn answers() -> Vec<String> {
    let benches = read("benches/README.md");
    let row = |answer| {
        let start = format!("| {answer} |");
        let row = benches.lines().find(|line| line.starts_with(&start)).expect("a row");
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let ours = cells[2].split(' ').next().expect("a time");
        format!("| {answer} | {ours} | {} | {} |", cells[3], cells[4])
    };
    let linear = ["A and B, with accelerations", "yᵀJ, with accelerations"];
    ["inverse dynamics", "mass matrix", "Jacobian of the tip"]
        .into_iter()
        .chain(linear)
        .map(row)
        .collect()
}

/// The instructions of a case of the firmware with the Panda, from its table. The stack is at most as deep as given.
fn instructions(case: &str, deepest: u32) -> String {
    let figures = read("examples/firmware/FIGURES.md");
    let start = format!("| `{case}`, cortex-m4 |");
    let row = figures.lines().find(|line| line.starts_with(&start)).expect("a row of the table");
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    let [fewest, most, stack] = [2, 3, 6].map(|cell| cells[cell].parse::<u32>().expect("a figure"));
    assert_eq!(fewest, most, "the same number of instructions from every state");
    assert!(stack <= deepest, "{case}");
    match fewest / 1000 {
        0..10 => fewest.to_string(),
        thousands => format!("{thousands} {:03}", fewest % 1000),
    }
}

/// The costs of the Panda on a microcontroller.
fn firmware() -> Vec<String> {
    let [step, torques, control, linear] = [
        ("arm_f32", 1126),
        ("inverse_dynamics_f32", 1024),
        ("computed_torque_f32", 1023),
        ("linear_arm_f32", 4095),
    ]
    .map(|(case, deepest)| instructions(case, deepest));
    vec![
        format!("{step} instructions"),
        "at most 1.1 KiB of stack".into(),
        format!(
            "inverse dynamics {torques}, computed torque with an estimate of the payload {control} with less than 1 KiB"
        ),
        format!("A and B {linear} with less than 4 KiB"),
    ]
}

/// The tolerance of the random chains, and the oldest Rust.
fn stated() -> Vec<String> {
    let after = |file: &str, start: &str| {
        let text = read(file);
        let line = text.lines().find_map(|line| line.strip_prefix(start)).expect("a line");
        line.trim_matches(['"', ';']).to_owned()
    };
    let tolerance = after("tests/random/compare.rs", "const TOLERANCE: f64 = ");
    let rust = after("Cargo.toml", "rust-version = ");
    vec![format!("to {tolerance} in the"), format!("Rust {rust} or newer")]
}

/// Without programs, code and targets of links.
fn prose(readme: &str) -> String {
    let text = readme.split("```").step_by(2).collect::<String>();
    let text = text.split('`').step_by(2).collect::<Vec<_>>().join(" ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_figure_has_a_source() {
    let mut text = prose(&read("README.md"));
    for figure in [operations(), times(), answers(), firmware(), stated()].concat() {
        let without = text.replacen(&figure, "", 1);
        assert!(without != text, "the README should say\n{figure}");
        text = without;
    }
    for name in NAMES {
        text = text.replace(name, "");
    }
    let digits = text.match_indices(|c: char| c.is_ascii_digit());
    let unknown: Vec<_> = digits
        .map(|(at, _)| text[..at].chars().rev().take(40).collect::<Vec<_>>())
        .map(|before| before.into_iter().rev().collect::<String>())
        .collect();
    assert!(unknown.is_empty(), "nothing holds the figures after {unknown:#?}");
}
