//! New projects: they build and run, and their tests pass; wrong names, folders and chains are refused.

mod common;

use common::program;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder outside of every workspace, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("mstmm-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        Folder(folder)
    }

    fn file(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Runs cargo in a project without the network, in the target folder of the tests.
fn cargo(project: &str, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO"));
    command.current_dir(project).args(arguments).arg("--offline");
    command.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("new"));
    command.env("RUSTFLAGS", "-D warnings");
    let output = command.output().expect("cargo starts");
    let [text, messages] =
        [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(output.status.success(), "{project}, {arguments:?}: {messages}\n{text}");
    text
}

/// Tests the format of a file. Without rustfmt, which the smallest installation of Rust lacks, it only says so.
fn assert_formatted(file: &str) {
    let check = Command::new("rustfmt").args(["--edition", "2024", "--check", file]).output();
    match check {
        Ok(check) => {
            assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stdout));
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            eprintln!("there is no rustfmt: the format of {file} is not tested");
        }
        Err(error) => panic!("rustfmt: {error}"),
    }
}

/// Makes a project, runs it and its test, and returns what the program prints.
fn made(folder: &Folder, name: &str, options: &[&str]) -> String {
    let project = folder.file(name);
    let arguments = [&["new", &project, "--vcs", "none"], options].concat();
    let (code, result, messages) = program(&arguments, "");
    assert_eq!((code, &*result), (0, ""), "{messages}");
    assert!(messages.contains("note: the package depends on mstmm in the folder"), "{messages}");
    assert_formatted(&format!("{project}/src/main.rs"));
    let tests = cargo(&project, &["test"]);
    assert!(tests.contains("1 passed"), "{tests}");
    cargo(&project, &["run"])
}

/// Returns the numbers of the line with this heading.
fn line(text: &str, heading: &str) -> Vec<f64> {
    let found = text.lines().find(|line| line.starts_with(heading));
    let found = found.unwrap_or_else(|| panic!("no line `{heading}`:\n{text}"));
    let numbers = found[heading.len()..].split_whitespace();
    numbers.map(|number| number.parse().expect("a number")).collect()
}

#[test]
fn projects_build_run_and_pass_their_tests() {
    let folder = Folder::new("new");
    let crane = made(&folder, "first-crane", &[]);
    // The start of the description, 60 degrees.
    let start = line(&crane, "foot.angle, rad")[0];
    assert!((start - std::f64::consts::FRAC_PI_3).abs() < 1e-5, "{start}");
    // Everything hangs from the foot: its force carries nearly the weights of 1100 kg.
    let [_, up, _] = line(&crane, "boom.input")[..] else { panic!("{crane}") };
    assert!((8000.0..14000.0).contains(&up), "{up} of {}", 1100.0 * 9.81);

    // In space, with repeated hinges, a private type and the whole call as the file.
    let rope = folder.file("rope.chain");
    let text = "mstmm_chain! {\n    chain Rope { gravity = [0, 0, -9.81];\n        \
        body Rod { mass = 2; com = [0, 0, -0.5]; output = [0, 0, -1]; inertia = diag(0.1, 0.1, 0.01) about com; }\n\n        \
        ground -> repeat 3 { ball joint -> Rod rod };\n        \
        hinge joint { start = rpy(10, 20, 0) deg; } }\n}\n";
    std::fs::write(&rope, text).expect("a file");
    let swinging = made(&folder, "rope", &["--chain", &rope]);
    assert_eq!(line(&swinging, "joint[2].orientation.w, 1").len(), 6);
    // The input of the ground is the input of the first rope.
    assert!(line(&swinging, "rod[2].input").len() == 6, "{swinging}");
    let main = std::fs::read_to_string(folder.file("rope/src/main.rs")).expect("the program");
    assert!(main.contains("//! The motion of the chain of `rope.chain`"), "{main}");

    // A robot, and a chain on a line without loads as results.
    let urdf = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf/arm.urdf");
    made(&folder, "robot", &["--urdf", &urdf.display().to_string()]);
    let line_chain = folder.file("line.chain");
    let text = "line chain Cart { results = energies; body Mass { mass = 2 kg; output = 1 m; }\n\
                ground -> slider rail -> Mass mass; hinge rail { force = 3 N; } }";
    std::fs::write(&line_chain, text).expect("a file");
    let cart = made(&folder, "cart", &["--chain", &line_chain]);
    // 3 N accelerate 2 kg.
    assert_eq!(line(&cart, "rail.velocity, m/s/s"), [1.5]);
}

/// Firmware: its library has a test for this computer, its program also runs here, and all of it links for a Cortex-M4F.
#[test]
fn firmware_links_for_a_microcontroller() {
    const TARGET: &str = "thumbv7em-none-eabihf";
    let skipped = |reason: &str| {
        // Written directly, since the test harness hides the output of successful tests.
        let _ = writeln!(std::io::stderr(), "skipped: {reason}");
    };
    let folder = Folder::new("firmware");
    let urdf = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf/dog.urdf");
    let urdf = urdf.display().to_string();
    let crane: &[&str] = &[];
    for (name, options) in
        [("small-crane", crane), ("dog", &["--urdf", &urdf, "--floating", "--name", "my-dog"])]
    {
        let project = folder.file(name);
        let arguments = [&["new", &project, "--vcs", "none", "--no-std"], options].concat();
        let (code, result, messages) = program(&arguments, "");
        assert_eq!((code, &*result), (0, ""), "{messages}");
        assert!(messages.contains(&format!("cargo build --release --target {TARGET}")));
        for file in ["src/main.rs", "src/lib.rs", "build.rs"] {
            assert_formatted(&format!("{project}/{file}"));
        }
        let mut fetch = Command::new(env!("CARGO"));
        let fetch = fetch.current_dir(&project).arg("fetch").output().expect("cargo starts");
        if !fetch.status.success() {
            return skipped("the registry is not available");
        }
        let tests = cargo(&project, &["test"]);
        assert!(tests.contains("1 passed"), "{tests}");
        let motion = cargo(&project, &["run"]);
        assert_eq!(motion.lines().count(), 11, "{motion}");
        let mut libraries = Command::new("rustc");
        let libraries = libraries.args(["--print", "target-libdir", "--target", TARGET]).output();
        let libraries = libraries.expect("rustc starts").stdout;
        let libraries = String::from_utf8(libraries).expect("UTF-8");
        if !Path::new(libraries.trim()).is_dir() {
            return skipped(&format!("the target {TARGET} is not installed"));
        }
        cargo(&project, &["build", "--release", "--target", TARGET]);
        let package = if name == "dog" { "my-dog" } else { name };
        let built = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new").join(TARGET);
        let image = std::fs::read(built.join("release").join(package)).expect("the firmware");
        // An ELF file for ARM that begins at the start-up code.
        assert_eq!((&image[..4], image[18]), (&b"\x7fELF"[..], 40));
    }
}

#[test]
fn wrong_names_folders_and_chains_are_refused() {
    let folder = Folder::new("refused");
    let chain = folder.file("wrong.chain");
    let text = "chain A { body R { mass = -1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about input; } ground -> pin(z) p -> R r; }";
    std::fs::write(&chain, text).expect("a file");
    let refused = |arguments: &[&str], expected: &str| {
        let (code, result, messages) = program(arguments, "");
        assert_eq!((code, &*result), (1, ""), "{arguments:?}: {messages}");
        assert!(messages.contains(expected), "{arguments:?}: {messages}");
    };
    refused(&["new", &folder.file("a"), "--chain", &chain], "wrong.chain:1:27");
    refused(&["new", &folder.file("")], "already exists");
    refused(&["new", &folder.file("match")], "Rust keyword");
    refused(&["new", &folder.file("1a")], "cannot start with a digit");
    refused(&["new", &folder.file("a"), "--name", "b c"], "invalid character");
    refused(&["new", &folder.file("a"), "--path", &folder.file("")], "Cargo.toml");
    refused(&["new", &folder.file("a"), "--chain", &folder.file("none")], "none: ");
    assert!(!Path::new(&folder.file("a")).exists(), "nothing is written");

    let (code, _, messages) = program(["new", "a", "--path", "b", "--git", "c"], "");
    assert_eq!(code, 2, "{messages}");
}

#[test]
fn dependencies_are_those_asked_for() {
    let folder = Folder::new("dependencies");
    let manifest = |name: &str, options: &[&str]| {
        let project = folder.file(name);
        let (code, _, messages) =
            program([&["new", &project, "--vcs", "none"], options].concat(), "");
        assert_eq!(code, 0, "{messages}");
        std::fs::read_to_string(folder.file(&format!("{name}/Cargo.toml"))).expect("a manifest")
    };
    let git = manifest("a", &["--git", "https://example.org/mstmm"]);
    assert!(git.ends_with("[dependencies]\nmstmm = { git = \"https://example.org/mstmm\" }\n"));
    let version = manifest("b", &["--version", "0.1"]);
    assert!(version.ends_with("[dependencies]\nmstmm = { version = \"0.1\" }\n"), "{version}");
    let root = common::root().canonicalize().expect("the checkout");
    let path = manifest("c", &["--path", &common::root().display().to_string()]);
    assert!(path.contains(&format!("mstmm = {{ path = \"{}\" }}", root.display())), "{path}");
}
