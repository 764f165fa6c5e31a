//! The errors that the tutorial quotes are those of its programs.

use std::path::Path;

/// The second part of the tutorial, which has a section on errors.
const PAGE: &str = "../../src/tutorial/further.md";

#[test]
fn the_tutorial_quotes_the_messages_of_its_programs() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE);
    let page = std::fs::read_to_string(page).expect("the tutorial");
    let mut programs = 0;
    for part in page.split("```compile_fail\n").skip(1) {
        let (program, rest) = part.split_once("```").expect("the end of the program");
        let (_, quoted) = rest.split_once("```text\n").expect("the messages of the program");
        let (quoted, _) = quoted.split_once("```").expect("the end of the messages");
        assert_eq!(messages(program), quotes(quoted), "{program}");
        programs += 1;
    }
    assert_eq!(programs, 2);
}

/// The messages of the call of `mstmm_chain!` in a program.
fn messages(program: &str) -> Vec<String> {
    let call: syn::ItemMacro = syn::parse_str(program).expect("one call of the macro");
    let errors = mstmm_codegen::read_and_examine(call.mac.tokens).expect_err("a wrong chain");
    errors.into_iter().map(|error| error.to_string()).collect()
}

/// Messages in the form of rustc, `error: …`, each of them in one line or in several.
fn quotes(text: &str) -> Vec<String> {
    let words = |message: &str| message.split_whitespace().collect::<Vec<_>>().join(" ");
    text.split("error: ").skip(1).map(words).collect()
}
