//! `cargo mstmm check` and `show`: the messages of the macro, at the same places, and no panic on any text.

mod common;

use cargo_mstmm::messages::{Message, Severity};
use cargo_mstmm::source::Source;
use common::{program, root};
use std::fs;
use std::path::PathBuf;

fn chain(name: &str) -> String {
    let folder = root().join("mstmm-macros/codegen/tests/expand");
    folder.join(name).with_extension("chain").to_str().expect("a path in Unicode").to_owned()
}

/// Returns the files of a folder and its folders, in the order of their names.
fn files(folder: PathBuf) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    entries.sort();
    entries
        .into_iter()
        .flat_map(|path| if path.is_dir() { files(path) } else { vec![path] })
        .collect()
}

/// Returns the text inside each call of the macro, with spaces instead of all other text, so that places stay.
fn calls(text: &str) -> Vec<String> {
    let starts = text.match_indices("mstmm_chain! {").map(|(at, call)| at + call.len());
    let blank = |part: &str| -> String {
        part.chars().map(|letter| if letter == '\n' { '\n' } else { ' ' }).collect()
    };
    let call = |start: usize| {
        let mut depth = 1;
        let end = text[start..].find(|letter| {
            depth += i32::from(letter == '{') - i32::from(letter == '}');
            depth == 0
        });
        let end = end.map_or(text.len(), |length| start + length);
        blank(&text[..start]) + &text[start..end]
    };
    // rustc marks the call if it is empty.
    starts.filter(|&start| !text[start..].starts_with('}')).map(call).collect()
}

/// rustc prints the same errors for the calls in `tests/ui`, at the same lines and columns.
#[test]
fn messages_and_places_are_those_of_the_macro() {
    let mut compared = 0;
    for path in files(root().join("tests/ui")) {
        let Ok(printed) = fs::read_to_string(path.with_extension("stderr")) else { continue };
        let Ok(text) = fs::read_to_string(path.with_extension("rs")) else { continue };
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        for call in calls(&text) {
            let (_, messages) = Source::new("a.chain", &call).check();
            for Message { line, column, severity, message, .. } in messages {
                let place = format!(":{line}:{column}\n");
                let mut blocks = printed.split("\n\n");
                let told = blocks.any(|block| block.contains(&message) && block.contains(&place));
                assert!(told, "{}{place}{severity:?}: {message}", path.display());
                compared += 1;
            }
        }
    }
    assert!(compared > 300, "only {compared} messages were compared");
}

#[test]
fn right_chains_pass_silently() {
    let (code, result, messages) = program(["check", &chain("arm"), &chain("four_bar")], "");
    assert_eq!((code, result, messages), (0, String::new(), String::new()));
}

/// A wrong chain with a letter of two bytes before the errors.
const WRONG: &str = "// é\nchain A {\n    /* é */ gravty = [0, 0, 1];\n}\n";

#[test]
fn an_error_has_its_line_and_an_exit_code() {
    let (code, result, messages) = program(["check", "-"], WRONG);
    let expected = "
error: chain `A` has no field `gravty`; did you mean `gravity`?
 --> standard input:3:13
  |
3 |     /* é */ gravty = [0, 0, 1];
  |             ^^^^^^

error: 2 errors
";
    assert!(messages.ends_with(expected), "{messages}");
    assert_eq!((code, result), (1, String::new()));
}

#[test]
fn editors_get_objects() {
    let (code, result, _) = program(["check", "--json", "-"], WRONG);
    let lines: Vec<serde_json::Value> =
        result.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    assert_eq!((code, lines.len()), (1, 2));
    let error = lines.iter().find(|error| error["help"] == "gravity").expect("the suggestion");
    let place = ["line", "column", "end_line", "end_column"].map(|name| error[name].as_u64());
    assert_eq!(place, [3, 13, 3, 19].map(Some));
    assert_eq!((&error["severity"], &error["file"]), (&"error".into(), &"standard input".into()));
}

#[test]
fn a_file_that_cannot_be_read_is_an_object() {
    let (code, result, messages) = program(["check", "--json", "no.chain", &chain("arm")], "");
    let error: serde_json::Value = serde_json::from_str(&result).expect("one object");
    let place = ["line", "column", "end_line", "end_column"].map(|name| error[name].as_u64());
    assert_eq!(place, [Some(1); 4]);
    assert_eq!((&error["severity"], &error["file"]), (&"error".into(), &"no.chain".into()));
    let message = error["message"].as_str().expect("a text");
    assert!(!message.is_empty() && !message.contains("no.chain"), "{message}");
    assert_eq!((code, &*messages), (1, "error: 1 error\n"));
}

#[test]
fn warnings_do_not_fail() {
    let text = fs::read_to_string(chain("pendulum")).expect("the chain");
    let text = text.replace("start = -90 deg", "start = -90");
    let (code, result, messages) = program(["check", "--json", "-"], &text);
    let severities: Vec<bool> = Source::new("a", &text)
        .check()
        .1
        .iter()
        .map(|message| message.severity == Severity::Warning && message.rule.is_some())
        .collect();
    assert!(!severities.is_empty() && severities.iter().all(|&is_warning| is_warning));
    assert_eq!((code, result.lines().count(), messages), (0, severities.len(), String::new()));
}

/// The message at a brace that closes an outer bracket too early.
const EXTRA: &str = "this `}` is too many, or a `{` before it is missing";

#[test]
fn what_is_not_closed_is_told_with_its_place() {
    for (text, place, message) in [
        ("chain A {\n    ground -> (\n", (2, 15), "`(` is not closed: expected `)`"),
        ("chain A {\n}}\n", (2, 2), "`}` closes no bracket"),
        ("chain A {\n a = [1, 2)\n", (2, 11), "expected `]`, found `)`"),
        ("/* a /* b */\nchain", (1, 1), "this comment is not closed"),
        ("\u{feff}é \"a\n", (1, 3), "this string is not closed"),
        ("chain A {\n pin(y j -> Rod;\n}\n", (2, 5), "`(` is not closed: expected `)`"),
        // Indentation tells which brace is too many, or in one line the text after it.
        (
            "chain A {\n    body B {\n        mass = 1;\n    }\n    }\n    ground -> B b;\n}\n",
            (5, 5),
            EXTRA,
        ),
        (
            "chain A {\n    body B\n        mass = 1;\n    }\n    hinge a { start = 1; }\n}\n",
            (4, 5),
            EXTRA,
        ),
        ("chain A {\n body B mass = 1; }\n hinge a { start = 1; }\n}\n", (2, 19), EXTRA),
        ("chain A {\n}\nchain B {\n}}\n", (4, 2), "`}` closes no bracket"),
        // Indentation tells which brace is not closed.
        (
            "chain A {\n    body B {\n        mass = 1;\n    ground -> B b;\n}\n",
            (2, 12),
            "`{` is not closed: expected `}`",
        ),
        (
            "chain A { // ²\n mass = 1 m²;\n}\n",
            (2, 12),
            "`²` (U+00B2) is not a character of the language: write `^2`",
        ),
        (
            "chain A {\n start = \u{2212}30;\n}\n",
            (2, 10),
            "`\u{2212}` (U+2212) is not a character of the language: write `-`",
        ),
        (
            "chain A {\n mass = 1'000 kg;\n}\n",
            (2, 10),
            "`'` (U+0027) is not a character of the language: write `_` between digits",
        ),
        ("chain A {\n a = 30';\n}\n", (2, 8), "`'` (U+0027) is not a character of the language"),
        // Rust has tokens with an apostrophe.
        (
            "chain A {\n a = 'b'; c = '\\''; d = 'e; f = '';\n}\n",
            (2, 33),
            "`'` (U+0027) is not a character of the language",
        ),
        (
            "chain A {\n mass = 1\0 kg;\n}\n",
            (2, 10),
            "`\\0` (U+0000) is not a character of the language",
        ),
        // A blank that is none in Rust.
        (
            "chain A {\u{2028} // a\u{a0}b\n mass = 1\u{a0}kg;\n}\n",
            (2, 10),
            "`\\u{a0}` (U+00A0) is not a character of the language",
        ),
        // A letter that no name has.
        (
            "chain A {\n mass = ⓐ kg;\n}\n",
            (2, 9),
            "expected a name, a number or a sign of the language",
        ),
        ("chain A {\n a = `b`;\n}\n", (2, 6), "``` (U+0060) is not a character of the language"),
    ] {
        let (_, messages) = Source::new("a.chain", text).check();
        let found: Vec<_> =
            messages.iter().map(|of| ((of.line, of.column), &*of.message)).collect();
        assert_eq!(found, [(place, message)]);
    }
}

#[test]
fn a_file_has_chains_only() {
    let body = "body B { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }";
    let chain = format!("chain A {{ {body} ground -> pin a -> B b; }}");
    for call in ["mstmm_chain!", "mstmm::mstmm_chain!", "::mstmm::mstmm_chain!"] {
        let (chains, messages) = Source::new("a.chain", &format!("{call} {{ {chain} }}")).check();
        assert_eq!((chains.len(), messages), (1, Vec::new()));
    }
    let message = "a file has chains, or one `mstmm_chain! { … }` around all its text: this is a file of Rust";
    for (before, column) in [
        ("use mstmm::mstmm_chain;", 1),
        ("//! A program.\n", 1),
        ("#![no_std]", 1),
        ("#[test]\nfn main() {}", 1),
        ("pub(crate) mod a;", 12),
    ] {
        let text = format!("{before} mstmm_chain! {{ {chain} }} fn b() {{}}");
        let (_, messages) = Source::new("a.rs", &text).check();
        let found: Vec<_> = messages.iter().map(|of| (of.column, &*of.message)).collect();
        assert_eq!(found, [(column, message)], "{before}");
    }
}

/// Texts with random changes: cut off, parts removed, doubled or replaced by other letters.
#[test]
fn no_text_makes_it_panic() {
    let mut random = common::Random::new();
    let chains = ["arm", "four_bar", "rope", "top"]
        .map(|name| fs::read_to_string(chain(name)).expect("a chain"));
    for text in chains.iter().cycle().take(160) {
        let mut letters: Vec<char> = text.chars().collect();
        for _ in 0..1 + random.below(3) {
            let at = random.below(letters.len());
            let end = (at + random.below(12)).min(letters.len());
            match random.below(4) {
                0 => letters.truncate(at.max(1)),
                1 => drop(letters.drain(at..end)),
                2 => drop(letters.splice(at..at, letters[at..end].to_vec()).collect::<Vec<_>>()),
                _ => {
                    letters[at] =
                        ['{', ')', ';', '-', '9', 'é', '"', '\0', '/', '*'][random.below(10)]
                }
            }
            letters.push('\n');
        }
        let text: String = letters.iter().collect();
        let source = Source::new("a.chain", &text);
        let (chains, messages) = source.check();
        let errors = Message::count_errors(&messages);
        assert!(errors > 0 || !chains.is_empty(), "neither chains nor errors: {text}");
        for message in &messages {
            assert!(text.get(message.range.clone()).is_some(), "{message:?} is not in {text}");
        }
        let lines = cargo_mstmm::messages::rendered(&source, &messages);
        assert_eq!(lines.is_empty(), messages.is_empty());
    }
}

#[test]
fn functions_counts_picture_and_code_are_shown() {
    let show = |arguments: &[&str]| {
        let arm = chain("arm");
        let (code, result, messages) = program(["show", &arm].iter().chain(arguments), "");
        assert_eq!((code, &*messages), (0, ""), "{arguments:?}");
        result
    };
    let function = show(&["accelerations"]);
    assert!(function.starts_with("fn accelerations() {\n"), "{function}");
    assert!(show(&[]).contains(&function));
    // The table of all functions has the totals of the tables of sections.
    let total =
        function.lines().last().expect("a total").split_whitespace().take(5).collect::<Vec<_>>();
    let counts = show(&["--counts", "accelerations"]);
    let row = counts.lines().last().expect("a row").split_whitespace().collect::<Vec<_>>();
    assert_eq!((&row[..5], row[6]), (&total[..], "accelerations"));
    let picture = show(&["--picture"]);
    assert!(picture.starts_with("<svg xmlns") && picture.ends_with("</svg>\n"), "{picture}");
    let code = show(&["--expand"]);
    let items = syn::parse_file(&code).expect("code").items;
    assert!(items.iter().any(|item| matches!(item, syn::Item::Struct(of) if of.ident == "Arm")));
}

#[test]
fn an_unknown_function_is_answered_with_the_known_ones() {
    let (code, result, messages) = program(["show", &chain("top"), "forces"], "");
    assert!(
        messages.starts_with("error: `Top` has the functions setup, accelerations, "),
        "{messages}"
    );
    assert_eq!((code, result), (1, String::new()));
}

#[test]
fn wrong_arguments_have_another_exit_code() {
    let (code, _, messages) = program(["shwo"], "");
    assert!(messages.contains("a similar subcommand exists: 'show'"), "{messages}");
    assert_eq!(code, 2);
    let (code, _, messages) = program(["check", "no.chain"], "");
    assert!(messages.starts_with("error: no.chain: "), "{messages}");
    assert_eq!(code, 1);
}
