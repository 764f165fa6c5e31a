//! Small URDF files and MuJoCo models, each with its text or with the reason why it is refused; and files with random errors.

mod common;

use cargo_mstmm::import::{Options, import};
use cargo_mstmm::source::Source;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Returns all files, in the order of their names.
fn files() -> Vec<PathBuf> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut files = Vec::new();
    for (folder, extension) in [("urdf", "urdf"), ("mjcf", "xml")] {
        let entries = fs::read_dir(tests.join(folder)).expect("the folder is there");
        let paths = entries.map(|entry| entry.unwrap().path());
        files.extend(paths.filter(|path| path.extension().is_some_and(|e| e == extension)));
    }
    files.sort();
    files
}

/// Reads the options from the comment with which a file begins: `<!-- options: floating, tip tool -->`.
fn options(path: &Path, text: &str) -> Options {
    let line = text
        .strip_prefix("<!-- options: ")
        .and_then(|text| Some(text.split_once(" -->")?.0))
        .unwrap_or("");
    let file = path.file_name().unwrap().to_string_lossy().into_owned();
    let mut options = Options { file, ..Options::default() };
    for option in line.split(", ").filter(|option| !option.is_empty()) {
        let (word, value) = option.split_once(' ').unwrap_or((option, ""));
        match word {
            "floating" => options.floating = true,
            "strict" => options.strict = true,
            "tip" => options.tip = Some(value.to_owned()),
            "name" => options.name = Some(value.to_owned()),
            "snap" => options.snap = value.parse().unwrap(),
            _ => panic!("{}: {word}", path.display()),
        }
    }
    options
}

/// Compares with the stored text; `MSTMM_BLESS=1` stores it.
#[test]
fn files_become_the_stored_texts() {
    let mut wrong = String::new();
    let files = files();
    assert!(files.len() > 30, "the files are missing");
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        let (found, extension, other) = match import(&text, &options(&path, &text)) {
            Ok(imported) => {
                let warnings =
                    imported.warnings.iter().map(|warning| format!("// warning: {warning}\n"));
                (warnings.collect::<String>() + &imported.text, "chain", "error")
            }
            Err(error) => (format!("{error}\n"), "error", "chain"),
        };
        let stored = path.with_extension(extension);
        if std::env::var_os("MSTMM_BLESS").is_some() {
            fs::write(&stored, &found).unwrap();
            let _ = fs::remove_file(path.with_extension(other));
        } else if fs::read_to_string(&stored).unwrap_or_default() != found {
            writeln!(wrong, "{} is now:\n{found}", stored.display()).unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn standard_input_is_a_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf");
    let urdf = fs::read_to_string(folder.join("arm.urdf")).unwrap();
    let expected = fs::read_to_string(folder.join("arm.chain")).unwrap();
    let (code, text, _) = common::program(["import", "-"], &urdf);
    assert_eq!((code, text), (0, expected.replace("arm.urdf", "standard input")));
    let (code, _, messages) = common::program(["import", "-"], "<robot/>");
    assert!(code == 1 && messages.starts_with("error: standard input:"), "{messages}");
}

/// Imported texts give no warnings: no unused parameters, no starts beyond limits.
#[test]
fn imported_texts_give_no_warnings() {
    let mut count = 0;
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        let Ok(imported) = import(&text, &options(&path, &text)) else { continue };
        let (_, messages) = Source::new("a.chain", &imported.text).check();
        assert!(messages.is_empty(), "{}: {messages:?}", path.display());
        count += 1;
    }
    assert!(count > 10, "{count}");
}

/// Many links that are fixed in a row, which quadratic searches took 40 s for.
#[test]
fn a_file_may_have_thousands_of_links() {
    let inertial = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>";
    let mut urdf = "<robot name=\"long\"><link name=\"l0\"/>\n".to_owned();
    for index in 1..6000 {
        let kind = if index == 1 { "continuous" } else { "fixed" };
        let parent = index - 1;
        writeln!(
            urdf,
            "<link name=\"l{index}\">{inertial}</link><joint name=\"j{index}\" type=\"{kind}\">\
             <origin xyz=\"0.1 0 0\"/><parent link=\"l{parent}\"/><child link=\"l{index}\"/></joint>"
        )
        .unwrap();
    }
    let text = import(&(urdf + "</robot>"), &Options::default()).expect("a chain").text;
    assert!(text.contains("mass = 5999 kg;"), "{text}");
}

/// Files with errors are refused on one line or become a text, and never panic.
#[test]
fn files_with_random_errors_do_not_panic() {
    let mut random = common::Random::new();
    let words = [
        "nan", "-1", "0", "1e999", "0 0 0", "\"", "<", ">", "/>", "&", "world", "fixed", "", "é",
        "1e-320",
    ];
    let files = files();
    let mut refused = 0;
    for round in 0..2000 {
        let path = &files[round % files.len()];
        let mut text: Vec<char> = fs::read_to_string(path).unwrap().chars().collect();
        let options = options(path, &text.iter().collect::<String>());
        if random.below(4) == 0 {
            text.truncate(random.below(text.len()));
        } else {
            for _ in 0..=random.below(3) {
                // A word of the file is replaced: names, numbers and tags.
                let start = random.below(text.len());
                let is_end = |c: &char| matches!(c, '"' | ' ' | '<' | '>' | '=' | '\n');
                let length = text[start..].iter().position(is_end).unwrap_or(0);
                let word = words[random.below(words.len())];
                text.splice(start..start + length, word.chars());
            }
        }
        let text: String = text.into_iter().collect();
        match import(&text, &options) {
            Ok(imported) => assert!(imported.text.contains("mstmm_chain!")),
            Err(error) => {
                assert!(!error.to_string().contains('\n'), "{error}");
                refused += 1;
            }
        }
    }
    assert!(refused > 400, "{refused}");
}
