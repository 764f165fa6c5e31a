//! Headers and crates for C: programs in C99 and C++11 get the bits of Rust, generated files in the repository are those of
//! today's generator, and what a library cannot have is refused by name.

mod common;

use common::{program, root};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ZOO: &str = include_str!("header/zoo.chain");

fn succeed(command: &mut Command) -> Output {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn text(output: Output) -> String {
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Returns an empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Makes the crate of the chains in a text and returns its messages.
fn made(folder: &Path, chains: &str, options: &[&str]) -> String {
    let output = folder.display().to_string();
    let arguments = [&["header", "-", "-o", &output], options].concat();
    let (code, result, messages) = program(&arguments, chains);
    assert_eq!((code, &*result), (0, ""), "{messages}");
    messages
}

/// A closed chain with branches, repetitions, balls, a prescribed motion and arrays of parameters; a chain in a plane with
/// selected results and names that differ only in C; a chain on a line without inputs and parameters.
#[test]
fn programs_in_c_and_cpp_get_the_bits_of_rust() {
    let folder = folder("zoo");
    let messages = made(&folder, ZOO, &["--scalar", "f32"]);
    assert!(messages.contains("`Zoo`: answers without functions in C: momentum"), "{messages}");
    std::fs::create_dir_all(folder.join("examples")).expect("a folder");
    let example = format!("mstmm::mstmm_chain! {{ {ZOO} }}");
    std::fs::create_dir_all(folder.join("examples/zoo")).expect("a folder");
    std::fs::write(folder.join("examples/zoo/chains.rs"), example).expect("a file");
    std::fs::write(folder.join("examples/zoo/main.rs"), include_str!("header/zoo.rs"))
        .expect("a file");

    // Without optimisation, which does not change bits.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("header");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(&folder).args(["build", "--offline", "--lib", "--examples", "--target-dir"]);
    succeed(cargo.arg(&target).env("RUSTFLAGS", "-D warnings"));
    let in_rust = text(succeed(&mut Command::new(target.join("debug/examples/zoo"))));
    assert!(in_rust.lines().count() > 30, "{in_rust}");

    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/header/zoo.c");
    for (compiler, language) in [("cc", &["-std=c99"][..]), ("c++", &["-x", "c++", "-std=c++11"])] {
        if Command::new(compiler).arg("--version").output().is_err() {
            // Written directly, since the test harness hides the output of successful tests.
            let _ = writeln!(std::io::stderr(), "skipped: there is no compiler `{compiler}`");
            continue;
        }
        let built = folder.join(compiler);
        let mut compile = Command::new(compiler);
        compile.args(language).args(["-Wall", "-Wextra", "-Werror", "-pedantic"]);
        compile.arg("-I").arg(folder.join("include")).arg(&source);
        compile.args(["-x", "none"]).arg(target.join("debug/libmstmm_zoo.a"));
        succeed(compile.args(["-pthread", "-ldl", "-lm", "-o"]).arg(&built));
        assert_eq!(text(succeed(&mut Command::new(&built))), in_rust, "{compiler}");
    }
}

/// `examples/c` is generated from its chain; `cargo mstmm header arm.chain --scalar f32 -o .` there makes it again.
#[test]
fn the_example_is_that_of_the_generator() {
    let (example, folder) = (root().join("examples/c"), folder("arm"));
    let chain = std::fs::read_to_string(example.join("arm.chain")).expect("the chain");
    made(&folder, &chain, &["--scalar", "f32"]);
    let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_default();
    for file in ["include/mstmm_arm.h", "src/lib.rs", "src/mstmm_arm.rs", "src/status.rs"] {
        assert!(read(&folder.join(file)) == read(&example.join(file)), "{file} is stale");
    }
    let sources = std::fs::read_dir(example.join("src")).expect("the sources").count();
    assert_eq!(sources, 3, "examples/c/src has sources that are not generated");
}

#[test]
fn the_header_is_a_result_of_the_command() {
    let chain = "line chain A { body M { mass = 1; output = 1; } ground -> slider s -> M m; }";
    let (code, header, messages) = program(["header", "-"], chain);
    assert_eq!(code, 0, "{messages}");
    assert!(
        header.contains("typedef double mstmm_real;") && header.contains("mstmm_a_step("),
        "{header}"
    );
    let file = folder("alone").join("a.h");
    let path = file.display().to_string();
    let (code, result, messages) = program(["header", "-", "-o", &path], chain);
    assert_eq!((code, &*result), (0, ""), "{messages}");
    assert_eq!(std::fs::read_to_string(file).expect("the header"), header);
    // A longer step needs fewer states.
    let (_, euler, _) = program(["header", "-", "--method", "semi-implicit-euler"], chain);
    assert!(euler.contains("semi-implicit Euler") && euler != header, "{euler}");
}

/// The sizes of all methods in both scalars are those of the compiler.
#[test]
fn sizes_of_all_methods_are_right() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("header");
    for (number, method) in
        ["semi-implicit-euler", "linearly-implicit-euler", "newmark"].into_iter().enumerate()
    {
        let scalar = ["f32", "f64", "f32"][number];
        let folder = folder(&format!("method{number}"));
        made(
            &folder,
            "line chain A { body M { mass = 1; output = 1; } ground -> slider s -> M m; }",
            &["--method", method, "--scalar", scalar],
        );
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(&folder).args(["check", "--offline", "--target-dir"]).arg(&target);
        succeed(cargo.env("RUSTFLAGS", "-D warnings"));
    }
}

#[test]
fn what_a_library_cannot_have_is_refused_by_name() {
    let refused = |chains: &str, expected: &str| {
        let (code, result, messages) = program(["header", "-"], chains);
        assert_eq!((code, &*result), (1, ""), "{messages}");
        assert!(messages.contains(expected), "{messages}");
    };
    let chain = |name: &str, mass: &str| {
        format!(
            "line chain {name} {{ body M {{ mass = {mass}; output = 1; }} ground -> slider s -> M m; }}"
        )
    };
    refused(
        &chain("A", "self::MASS"),
        "`A` has Rust constants, which the library does not have: `self::MASS`",
    );
    refused(
        &chain("Status", "1"),
        "`Status` and the header would both have the name `mstmm_status`",
    );
    let both = chain("ArmStep", "1") + &chain("Arm", "1");
    refused(&both, "`Arm` and ArmStep would both have the name `mstmm_arm_step`");
    refused(&chain("A", "-1"), "a mass must be positive");

    // A source of the user is not overwritten.
    let folder = folder("own");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    std::fs::write(folder.join("src/lib.rs"), "// mine\n").expect("a file");
    let path = folder.display().to_string();
    let (code, _, messages) = program(["header", "-", "-o", &path], &chain("A", "1"));
    assert_eq!(code, 1);
    assert!(messages.contains("lib.rs: this file is not generated"), "{messages}");
}
