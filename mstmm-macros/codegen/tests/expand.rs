//! The golden expansion of a small chain. `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test expand` updates it. The
//! functions themselves are easier to read in the goldens of `text`.

use proc_macro2::TokenStream;
use quote::quote;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/expand")
}

fn compile(text: &str) -> TokenStream {
    let tokens = text.parse().expect("tokens");
    let expansion = mstmm_codegen::expand(tokens, &quote!(::mstmm));
    assert!(expansion.errors.is_none(), "{:?}", expansion.errors);
    expansion.items
}

/// Returns the expansion of a chain, formatted.
fn expand(text: &str) -> String {
    let items = compile(text);
    let file = syn::parse2(items.clone()).unwrap_or_else(|error| panic!("{error}\n{items}"));
    prettyplease::unparse(&file)
}

#[test]
fn pendulum_with_a_motor_and_a_parameter() {
    let text = std::fs::read_to_string(folder().join("pendulum.chain")).expect("a chain");
    let path = folder().join("pendulum.expanded.rs");
    let expanded = expand(&text);
    assert_eq!(expanded, expand(&text), "the expansion differs from one run to the next");
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(&path, &expanded).expect("a writable folder");
    }
    let golden = std::fs::read_to_string(&path).expect("the committed expansion");
    let changed = expanded.lines().zip(golden.lines()).position(|(now, then)| now != then);
    assert!(expanded == golden, "line {changed:?} from 0: MSTMM_BLESS=1 accepts it");
}

/// The compiler is deterministic, also for repeated parts and loop closures.
#[test]
fn expansions_are_the_same_from_one_run_to_the_next() {
    for name in ["top", "two_pins", "rope", "four_bar", "arm"] {
        let text = std::fs::read_to_string(folder().join(format!("{name}.chain")));
        let text = text.expect("a chain");
        assert_eq!(compile(&text).to_string(), compile(&text).to_string(), "{name}");
    }
}

/// A repeated part is a loop: the code for ten thousand repetitions is that for a hundred, except for literals.
#[test]
fn code_does_not_grow_with_the_count_of_a_repeat() {
    let rope = std::fs::read_to_string(folder().join("rope.chain")).expect("a chain");
    let length = |count: &str| {
        let text = rope.replace("repeat 10 ", &format!("repeat {count} "));
        let text = text.replace("[10]", &format!("[{count}]"));
        let items = compile(&text);
        items.to_string().chars().filter(|letter| !letter.is_ascii_digit()).count()
    };
    // Fewer are drawn one by one in the picture of the chain.
    assert_eq!(length("100"), length("10000"));
}

/// Rust constants, parameters with a value per repetition, an elastic hinge.
const CONSTANTS: &str = "
    line chain Train {
        param coal[3] = 2 kg;
        body Engine { mass = data::MASS; output = 1 m; }
        body Car { mass = data::MASS + coal; output = 1 m; }
        Engine first -> repeat 3 { elastic a -> Car next };
        hinge a { stiffness = 3; damping = data::DAMPING; }
    }";

/// Hinges with prescribed motion, and loads.
const TOLD: &str = "
    chain Crane {
        gravity = input;
        body Rod { mass = 1 kg; com = [1, 0, 0] m; inertia = diag(1, 1, 1) about com; output = [2, 0, 0] m; }
        moving deck -> screw(x, 5 mm/rev) a -> Rod b -> repeat 3 { universal(x, y) c -> Rod d }
            -> elastic e -> Rod f -> planar(y) g -> moving hook;
        hinge a { motion = input; }
        hinge e { stiffness = 3; turning_stiffness = 3; torque = input; }
        load push { on = d; force = input; torque = input; }
    }";

/// If the user's code has a constant, a static or a unit struct with the name of a variable, Rust takes the pattern for it.
/// Therefore all variables end in an underscore.
#[test]
fn variables_end_in_an_underscore() {
    #[derive(Default)]
    struct Variables(BTreeSet<String>);
    impl<'ast> syn::visit::Visit<'ast> for Variables {
        fn visit_pat_ident(&mut self, variable: &'ast syn::PatIdent) {
            self.0.insert(variable.ident.to_string());
        }
    }
    let names = ["pendulum", "top", "two_pins", "rope", "four_bar", "arm"];
    let texts = names.map(|name| std::fs::read_to_string(folder().join(format!("{name}.chain"))));
    let texts = texts.map(|text| text.expect("a chain"));
    for text in texts.iter().map(String::as_str).chain([CONSTANTS, TOLD]) {
        let file = syn::parse2(compile(text)).expect("items");
        let mut variables = Variables::default();
        syn::visit::Visit::visit_file(&mut variables, &file);
        assert!(variables.0.len() > 20, "{:?}", variables.0);
        let plain: Vec<_> = variables.0.iter().filter(|name| !name.ends_with('_')).collect();
        assert!(plain.is_empty(), "{plain:?}");
    }
}
