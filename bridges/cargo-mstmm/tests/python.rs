//! The Rust project of a Python module, and what is refused. `bridges/check` builds wheels.

mod common;

use cargo_mstmm::new::Dependency;
use cargo_mstmm::python::{Module, module_name};
use common::{program, root};

fn module(name: &str, version: &str, chains: &[&str]) -> Result<Module, String> {
    let chains: Vec<String> = chains.iter().map(|chain| (*chain).to_owned()).collect();
    Module::new(name, version, &chains, &["    chain A {}".to_owned()]).map_err(|it| it.to_string())
}

#[test]
fn the_project_depends_on_the_checkout() {
    let module = module("robots", "1.2.3", &["A", "B"]).expect("a module");
    let dependency = Dependency::in_folder(&root()).expect("the checkout");
    let [(_, manifest), (_, pyproject), (_, library)] = module.files(&dependency, false);
    assert!(
        manifest.contains("version = \"1.2.3\"") && manifest.contains("crate-type = [\"cdylib\"]")
    );
    assert!(manifest.contains("bridges/mstmm-python\", features = [\"extension\"] }"));
    assert!(
        pyproject.contains("name = \"robots\"")
            && pyproject.contains("requires-python = \">=3.10\"")
    );
    assert!(library.ends_with("mstmm_python::module!(robots: A, B);\n"));
    let [(_, native), ..] = module.files(&dependency, true);
    assert!(native.contains("features = [\"extension\", \"fma\"]"));
    let registry = Dependency::Version("0.1.0".into());
    let [(_, manifest), ..] = module.files(&registry, false);
    assert!(
        manifest.contains("mstmm-python = { version = \"0.1.0\", features = [\"extension\"] }")
    );
}

#[test]
fn names_and_versions_are_checked() {
    for name in ["", "my robots", "3d", "robot-arm", "fn", "größe"] {
        let refused = module(name, "0.1.0", &["A"]).expect_err("a wrong name");
        assert!(refused.contains("is not the name of a Python module"), "{refused}");
    }
    let refused = module("robots", "1.0", &["A"]).expect_err("a wrong version");
    assert_eq!(refused, "`1.0` is not a version: write three numbers as in `0.1.0`");
    let refused = module("robots", "0.1.0", &["A", "B", "A"]).expect_err("two chains A");
    assert_eq!(refused, "the files have two chains `A`: rename one");
}

#[test]
fn modules_have_the_name_of_the_first_chain() {
    for (chain, name) in
        [("CartPole", "cart_pole"), ("Ur5", "ur5"), ("G1Arm", "g1_arm"), ("HYQ", "hyq")]
    {
        assert_eq!(module_name(chain), name);
    }
}

#[test]
fn errors_of_chains_are_those_of_the_macro() {
    let (code, output, messages) = program(["python", "-"], "chain A { gravty = 1; }");
    assert_eq!((code, output.as_str()), (1, ""));
    assert!(messages.contains("gravty"), "{messages}");
    let (code, _, messages) = program(["python", "no.chain"], "");
    assert!(code == 1 && messages.contains("no.chain"), "{messages}");
}
