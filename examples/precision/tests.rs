//! Tests of the whole command.

use std::path::PathBuf;

use clap::Parser;
use serde_json::Value;

use crate::{Arguments, run};

/// A rod that swings, released at 60°.
const PENDULUM: &str = "plane chain Pendulum {
    gravity = [0, -9.81] m/s^2;
    body Rod { mass = 2 kg; com = [0, -0.5] m; inertia = 1/6 kg*m^2 about com; output = [0, -1] m; }
    ground -> pin joint -> Rod rod;
    hinge joint { start = 60 deg; }
}
";

/// All kinds of inputs, also repeated ones, and not all results, in private modules; a closed chain that
/// cannot be closed from its start; and a file with its own `main` and lint.
const FILE: &str = "#![deny(warnings)]
use mstmm::prelude::*;
mod matter { pub const MASS: f64 = 2.0; }
mod inner { mod deeper { mstmm::mstmm_chain!(
    plane chain Rope {
        results = z; /* ± */ gravity = input;
        param stiffness[3] = 5 N/m;
        body Rod { mass = crate::matter::MASS; com = [0.5, 0]; output = [1, 0]; inertia = 0.1 about com; }
        moving hand -> repeat 3 { elastic a -> Rod b -> pin c -> Rod d } -> slider drive -> Rod last;
        hinge a { stiffness = stiffness; turning_stiffness = 3; }
        hinge c { torque = input; limits = [-90, 90] deg; limit_stiffness = 100; }
        hinge drive { motion = input; }
        load push { on = b; force = input; torque = input; axes = body; }
    }
) ; } }
fn main() {
    mstmm_chain! {
        chain Loop {
            results = [z, energies];
            body Rod { mass = 1; com = [0.5, 0, 0]; output = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }
            ground -> ball a -> Rod b -> universal(y, z) c -> Rod d -> ball e -> ground at [1.2, 0.5, 0];
        }
    }
    println!(\"{:?}\", Loop::<f64>::new());
}
";

/// A tree: a floating trunk with two legs of a part, a repeated part with a branch, and a spring.
const TREE: &str = "chain Walker {
    gravity = [0, 0, -9.81] m/s^2;
    param load[2] = 0.1 kg;
    body Trunk {
        mass = 5 kg; com = [0, 0, 0.1] m; output = [0.5, 0, 0] m;
        inertia = diag(0.2, 0.3, 0.4) kg*m^2 about com;
        point left = [0, 0.2, 0] m; point right = [0, -0.2, 0] m;
    }
    body Link {
        mass = 1 kg; com = [0, 0, -0.2] m; output = [0, 0, -0.4] m;
        inertia = diag(0.02, 0.02, 0.01) kg*m^2 about com;
    }
    body Spike { mass = 0.5 kg + load; com = [0.1, 0, 0] m; inertia = diag(0.01, 0.01, 0.01) about com; }
    part Leg(side) {
        universal(x, y) hip -> Link thigh -> pin([0, side, 0]) knee -> Link shank;
        hinge hip { start = [side*10, 5] deg; }
        hinge knee { torque = input; }
        load contact { on = shank; at = output; force = input; }
    }
    Trunk trunk -> repeat 2 { ball joint -> Link link; link.output -> pin(y) root -> Spike spike; };
    trunk.left -> Leg(1) left;
    trunk.right -> Leg(-1) right;
    hinge root { motion = input; }
    hinge joint { stiffness = 5; damping = 0.1; }
    spring cord { on = left.shank.output; to = right.shank.output; stiffness = 50; length = 0.4 m; }
}
";

/// Writes a file with this text and returns the output of the command. Every test has a separate file.
fn run_on(name: &str, text: &str, arguments: &[&str]) -> Result<String, String> {
    let folder = std::env::temp_dir().join("mstmm-precision-tests");
    let file: PathBuf = folder.join(name);
    std::fs::create_dir_all(&folder).expect("a folder for files");
    std::fs::write(&file, text).expect("a file");
    let own = ["precision".as_ref(), file.as_os_str()].into_iter();
    let arguments = own.chain(arguments.iter().map(AsRef::as_ref));
    run(&Arguments::try_parse_from(arguments).expect("arguments as asked for"))
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn a_pendulum_is_as_accurate_as_its_operations_allow() {
    let short = ["--json", "--time", "1", "--step", "1e-3"];
    let compare = |arguments: &[&str]| {
        run_on("pendulum.chain", PENDULUM, &[&short, arguments].concat()).expect("a comparison")
    };
    let text = compare(&[]);
    let report = json(&text);
    let unit = f64::from(f32::EPSILON) / 2.0;

    // m g l sin θ / J: at most five numbers and three products are rounded, and the sine has an error
    // of one unit in the last place, which is two roundings. There are no sums, so no error is amplified.
    let worst = report["errors"]["accelerations"]["worst"].as_f64().expect("a number");
    assert!(worst > 0.0 && worst < 10.0 * unit, "{worst:e}");

    // A step rounds angle θ and rate ω, 1.05 rad and 3.84 rad/s at most, in their last places, and the
    // acceleration k sin θ, k = 3 g / 2 l, has the error above. In the variables θ and ω/√k, differences
    // grow at the rate √k (1 − cos θ)/2 ≤ 0.96 1/s.
    let (steps, rate, growth) = (1008.0, f64::sqrt(1.5 * 9.81), f64::exp(0.97));
    let rounded = steps * unit * (1.05 + 3.84 / rate) + 10.0 * unit * rate;
    let last = report["motion"]["differences"].as_array().and_then(|rows| rows.last());
    let turn = last.and_then(|row| row["turn"].as_f64()).expect("a number");
    assert!(turn > 0.0 && turn < growth * rounded, "{turn:e} beside {:e}", growth * rounded);

    // The truncation error of RK4 is proportional to the fourth power of the step.
    let truncation = |number: usize| report["motion"]["steps"][number]["truncation"].as_f64();
    let (long, short) = (truncation(0).expect("a number"), truncation(1).expect("a number"));
    assert!((long / short).log2() > 3.9 && (long / short).log2() < 4.1, "{}", long / short);

    assert_eq!(compare(&["--seed", "1"]), text);
    assert_ne!(compare(&["--seed", "2"]), text);
}

#[test]
fn every_kind_of_chain_in_a_file_of_rust_is_compared() {
    let compare = |arguments: &[&str]| {
        let arguments = [&["--time", "0.1", "--states", "20"], arguments].concat();
        run_on("chains.rs", FILE, &arguments)
    };
    let several = compare(&[]).expect_err("two chains");
    assert!(several.ends_with("choose a chain with `--chain`: Rope, Loop"), "{several}");

    let rope = compare(&["--chain", "Rope", "--inputs", "random"]).expect("a comparison");
    for line in ["Rope: f32 compared with f64, 20 random states, seed 1, inputs random", "Verdict"]
    {
        assert!(rope.lines().any(|found| found == line), "{rope}");
    }
    let report = json(&compare(&["--chain", "Loop", "--json"]).expect("a comparison"));
    assert_eq!(report["errors"]["states"], 20);
    let opened = |which: &str| report["motion"][which].as_f64().expect("a number");
    assert!(opened("opened_double") < 1e-9 && opened("opened_single") < 1e-4);
}

#[test]
fn a_tree_is_compared() {
    let arguments = ["--time", "0.1", "--states", "20", "--inputs", "random", "--json"];
    let report = json(&run_on("tree.chain", TREE, &arguments).expect("a comparison"));
    assert_eq!(report["errors"]["states"], 20);
    // A few hundred roundings, with a condition of some tens.
    let worst = report["errors"]["accelerations"]["worst"].as_f64().expect("a number");
    assert!(worst > 0.0 && worst < 1e4 * f64::from(f32::EPSILON), "{worst:e}");
    let differences = report["motion"]["differences"].as_array().expect("a motion");
    assert!(differences.iter().any(|row| row["turn"].as_f64() > Some(0.0)));
}

#[test]
fn errors_are_reported_at_their_places() {
    let wrong = PENDULUM.replace("mass = 2 kg", "mass = 2 m");
    let error = run_on("wrong.chain", &wrong, &[]).expect_err("an error");
    assert!(error.contains("expected a mass, found a length"), "{error}");
    assert!(error.contains("wrong.chain:3:25"), "{error}");
    let error = run_on("unclosed.chain", &PENDULUM.replace("]", ""), &[]).expect_err("an error");
    assert!(error.contains("unclosed.chain:2:"), "{error}");
    let error = run_on("empty.rs", "fn main() {}\n", &[]).expect_err("no chain");
    assert!(error.contains("there is no chain in it"), "{error}");
}
