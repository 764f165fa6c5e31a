//! Tests of C programs with the header and the static library: the same bits and the same memory
//! layout as in Rust.

use std::io::Write;
use std::mem::offset_of;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use mstmm::{Error, Rk4};
use mstmm_arm::mstmm_arm::{Inputs, Model, Point, Results, State};
use mstmm_arm::{Arm, ArmInputs, Real, Status};

const PACKAGE: &str = env!("CARGO_MANIFEST_DIR");
const FLAGS: &str = "-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror -ffp-contract=off -Iinclude";

/// The static library as firmware uses it; `cargo test` builds no static library.
static LIBRARY: LazyLock<PathBuf> = LazyLock::new(|| {
    let target =
        Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("it lies in the target folder");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(PACKAGE).args(["build", "--release", "--target-dir"]).arg(target);
    succeed(&mut cargo);
    target.join("release/libmstmm_arm.a")
});

fn succeed(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Returns the output of a C program, or none, with a note, if there is no C compiler.
fn run(source: &str) -> Option<String> {
    let compiler = std::env::var("CC").unwrap_or("cc".to_owned());
    if Command::new(&compiler).arg("--version").output().is_err() {
        // Written directly, since the test harness hides the output of successful tests.
        let _ =
            writeln!(std::io::stderr(), "{source}: skipped, there is no C compiler `{compiler}`");
        return None;
    }
    let name = Path::new(source).file_stem().expect("it names a file");
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let mut compile = Command::new(compiler);
    compile.current_dir(PACKAGE);
    compile.args(FLAGS.split(' ')).arg(source);
    compile.arg(&*LIBRARY).args(["-pthread", "-ldl", "-lm", "-o"]).arg(&program);
    succeed(&mut compile);
    let output = succeed(&mut Command::new(program));
    Some(String::from_utf8(output.stdout).expect("it prints text"))
}

/// Returns the numbers that `main.c` prints, computed without the functions for C.
fn main_in_rust() -> Result<Vec<Real>, Error> {
    let (target, stiffness, damping) =
        ([0.5, -0.5, 1.25], [200.0, 400.0, 200.0], [40.0, 60.0, 20.0]);
    let mut chain = Arm::<Real>::new();
    chain.set_payload_mass(3.0)?;
    let mut state = chain.initial_state();
    let mut rk4 = Rk4::new(1e-3);
    let mut inputs = chain.no_inputs();
    for _ in 0..1000 {
        let [waist, shoulder, elbow] = std::array::from_fn(|i| {
            stiffness[i] * (target[i] - state.q[i]) - damping[i] * state.v[i]
        });
        inputs = ArmInputs { waist, shoulder, elbow };
        rk4.step(&chain, &mut state, |_, _| inputs)?;
    }
    let mut at = chain.workspace();
    chain.solve_into(&state, &inputs, &mut at)?;

    let tip = at.payload().output();
    let mut numbers = vec![state.t];
    numbers.extend(&state.q);
    numbers.extend(&state.v);
    numbers.extend(&tip.position());
    numbers.extend(tip.orientation().matrix().row_iter().flat_map(|row| [row[0], row[1], row[2]]));
    numbers.extend(&tip.acceleration());
    numbers.extend(&at.camera().output().position());
    numbers.extend(&at.column().mast().force());
    numbers.extend(&at.hook().output().force());
    numbers.extend(&at.waist().input().moment());
    numbers.extend([at.kinetic_energy(), at.potential_energy()]);
    Ok(numbers)
}

#[test]
fn a_c_program_gets_the_bits_of_rust() -> Result<(), Error> {
    let Some(printed) = run("main.c") else { return Ok(()) };
    let bits = |number: &Real| number.to_bits();
    let words = printed.lines().flat_map(|line| line[22..].split_whitespace());
    let from_c: Vec<Real> = words.map(|word| word.parse().expect("a number")).collect();
    let in_rust = main_in_rust()?;
    assert_eq!(from_c, in_rust);
    assert!(from_c.iter().map(bits).eq(in_rust.iter().map(bits)), "some zero has another sign");
    Ok(())
}

#[test]
fn misuse_is_answered_and_changes_nothing() {
    run("tests/misuse.c");
}

#[test]
fn the_jacobian_of_a_body_is_that_of_a_frame_on_it() {
    run("tests/jacobian.c");
}

#[test]
fn both_have_the_same_in_the_same_places() {
    let Some(in_c) = run("tests/layout.c") else { return };
    macro_rules! layout {
        ($($name:literal $type:ident { $($field:ident)* })*) => {
            [$(
                format!("{} {}", $name, size_of::<$type>()),
                $(format!("{}.{} {}", $name, stringify!($field), offset_of!($type, $field)),)*
            )*]
        };
    }
    let in_rust = layout! {
        "mstmm_status" Status { code hinge }
        "mstmm_arm" Model {}
        "mstmm_arm_state" State { q v t }
        "mstmm_arm_inputs" Inputs { u }
        "mstmm_arm_point" Point {
            position orientation velocity angular_velocity
            acceleration angular_acceleration moment force
        }
        "mstmm_arm_results" Results { accelerations kinetic_energy potential_energy points }
    };
    assert_eq!(in_c.lines().collect::<Vec<_>>(), in_rust);
}
