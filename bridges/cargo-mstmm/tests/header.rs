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

/// Makes the library of the chains in `tests/header/NAME.chain`, and compares the output of `NAME.c`, compiled as C and as
/// C++, with that of `NAME.rs`. Returns the messages.
fn compare(name: &str, library: &str, [chains, program]: [&str; 2], options: &[&str]) -> String {
    let folder = folder(name);
    let messages = made(&folder, chains, options);
    let example = folder.join("examples").join(name);
    std::fs::create_dir_all(&example).expect("a folder");
    let call = format!("mstmm::mstmm_chain! {{ {chains} }}");
    std::fs::write(example.join("chains.rs"), call).expect("a file");
    std::fs::write(example.join("main.rs"), program).expect("a file");

    // Without optimisation, which does not change bits.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("header");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(&folder).args(["build", "--offline", "--lib", "--examples", "--target-dir"]);
    succeed(cargo.arg(&target).env("RUSTFLAGS", "-D warnings"));
    let in_rust = text(succeed(&mut Command::new(target.join("debug/examples").join(name))));
    assert!(in_rust.lines().count() > 30, "{in_rust}");

    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/header/{name}.c"));
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
        compile.args(["-x", "none"]).arg(target.join(format!("debug/{library}")));
        succeed(compile.args(["-pthread", "-ldl", "-lm", "-o"]).arg(&built));
        let output = text(succeed(&mut Command::new(&built)));
        let lines = output.lines().zip(in_rust.lines());
        let different: Vec<_> = lines.filter(|(c, rust)| c != rust).collect();
        assert_eq!(output, in_rust, "{compiler}: {different:#?}");
    }
    messages
}

/// A closed chain with branches, repetitions, balls, a prescribed motion and arrays of parameters; a chain in a plane with
/// selected results and names that differ only in C; a chain on a line without inputs and parameters.
#[test]
fn programs_in_c_and_cpp_get_the_bits_of_rust() {
    let sources = [ZOO, include_str!("header/zoo.rs")];
    let messages = compare("zoo", "libmstmm_zoo.a", sources, &["--scalar", "f32"]);
    for name in ["closure_jacobian", "operational_space_inertia", "`at` of kinematics"] {
        assert!(messages.contains(name), "{messages}");
    }
}

/// All answers: of a chain with repetitions and balls, in a plane, and on a line without inputs and parameters.
#[test]
fn answers_in_c_and_cpp_have_the_bits_of_rust() {
    let sources = [include_str!("header/answers.chain"), include_str!("header/answers.rs")];
    let messages = compare("answers", "libmstmm_whip.a", sources, &[]);
    assert!(
        messages.contains("`Whip`: the header does not have: `at` of kinematics"),
        "{messages}"
    );
    assert!(messages.contains("BASE_PARAMETERS"), "{messages}");
    // The header has the same list.
    let header = Path::new(env!("CARGO_TARGET_TMPDIR")).join("answers/include/mstmm_whip.h");
    let header = std::fs::read_to_string(header).expect("the header");
    assert!(header.contains("this header does not have:") && header.contains("BASE_PARAMETERS"));
}

/// A request is a function of the header, or is listed by name in it and in the messages.
#[test]
fn no_answer_is_silently_absent() {
    let words = [
        ("inverse_dynamics", "mstmm_a_inverse_dynamics("),
        ("bias_efforts", "mstmm_a_bias_efforts("),
        ("mass_matrix", "mstmm_a_mass_matrix("),
        ("kinematics", "mstmm_a_kinematics("),
        ("jacobian", "mstmm_a_jacobian("),
        ("momentum", "mstmm_a_momentum("),
        ("regressor", "mstmm_a_regressor("),
        ("derivatives", "mstmm_a_inverse_dynamics_derivatives("),
        ("linearize", "mstmm_a_linearize("),
        ("push", "mstmm_a_push("),
        ("pull", "mstmm_a_pull("),
        ("coriolis_matrix", "mstmm_a_coriolis_matrix("),
    ];
    let known = mstmm_codegen::model::ANSWER_WORDS.iter().filter(|(_, of)| of.len() == 1);
    assert_eq!(known.map(|(word, _)| *word).collect::<Vec<_>>(), words.map(|(word, _)| word));
    for (route, is_empty) in [
        ("slider s -> M m", false),
        ("repeat 3 { slider s -> M m }", false),
        ("weld w -> M m", true),
    ] {
        for (word, function) in words {
            let chain = format!(
                "chain A {{ answers = {word}; body M {{ mass = 1; com = [0, 0, 0]; output = [1, 0, 0]; \
                 inertia = diag(1, 1, 1) about com; }} ground -> {route}; }}"
            )
            .replace("slider", "slider(x)");
            let (code, header, messages) = program(["header", "-"], &chain);
            if code != 0 {
                // Refused by the language.
                assert!(is_empty && header.is_empty() && messages.contains("error"), "{messages}");
                continue;
            }
            let is_said = messages.contains("the header does not have: ")
                && header.contains("this header does not have:");
            assert!(
                header.contains(function) || (is_empty && is_said),
                "{word}, {route}: {messages}"
            );
        }
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
