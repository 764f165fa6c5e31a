//! The Rust project of a Python module.

use crate::commands::Failure;
use crate::new::Dependency;

/// A Python module of chains.
#[derive(Clone, Debug)]
pub struct Module {
    name: String,
    version: String,
    chains: Vec<String>,
    texts: Vec<String>,
}

impl Module {
    /// Makes a module from its name, its version, the names of its chains and the texts with them.
    ///
    /// # Errors
    ///
    /// If the name cannot be that of a module, or a chain occurs twice.
    pub fn new(
        name: &str,
        version: &str,
        chains: &[String],
        texts: &[String],
    ) -> Result<Self, Failure> {
        let is_start = |letter: char| letter.is_ascii_alphabetic() || letter == '_';
        let is_name = name.starts_with(is_start)
            && name.chars().all(|letter| is_start(letter) || letter.is_ascii_digit());
        let is_keyword = syn::parse_str::<syn::Ident>(name).is_err();
        if !is_name || is_keyword {
            let text =
                "is not the name of a Python module: write letters, digits and `_`, no keyword";
            return Err(Failure(format!("`{name}` {text}")));
        }
        let is_version = version.split('.').count() == 3
            && version.split('.').all(|part| part.parse::<u32>().is_ok());
        if !is_version {
            return Err(Failure(format!(
                "`{version}` is not a version: write three numbers as in `0.1.0`"
            )));
        }
        for (number, chain) in chains.iter().enumerate() {
            if chains[..number].contains(chain) {
                return Err(Failure(format!("the files have two chains `{chain}`: rename one")));
            }
        }
        let [name, version] = [name, version].map(str::to_owned);
        Ok(Module { name, version, chains: chains.to_vec(), texts: texts.to_vec() })
    }

    /// Returns the files of the project, each with its path.
    #[must_use]
    pub fn files(&self, dependency: &Dependency, native: bool) -> [(&'static str, String); 3] {
        [
            ("Cargo.toml", self.manifest(dependency, native)),
            ("pyproject.toml", self.pyproject()),
            ("src/lib.rs", self.library()),
        ]
    }

    fn manifest(&self, dependency: &Dependency, native: bool) -> String {
        let (name, version) = (&self.name, &self.version);
        let fma = if native { ", \"fma\"" } else { "" };
        let mstmm = dependency.with_features("", "\"wide\"");
        let python =
            dependency.with_features("bridges/mstmm-python", &format!("\"extension\"{fma}"));
        format!(
            "[package]\nname = \"{name}\"\nversion = \"{version}\"\nedition = \"2024\"\n\n\
             [lib]\ncrate-type = [\"cdylib\"]\n\n\
             [dependencies]\nmstmm = {mstmm}\nmstmm-python = {python}\n\n\
             [profile.release]\npanic = \"unwind\"\n\n[workspace]\n"
        )
    }

    fn pyproject(&self) -> String {
        let name = &self.name;
        format!(
            "[build-system]\nrequires = [\"maturin>=1.7,<2\"]\nbuild-backend = \"maturin\"\n\n\
             [project]\nname = \"{name}\"\nrequires-python = \">=3.10\"\n\
             dependencies = [\"numpy>=1.25\"]\ndynamic = [\"version\"]\n"
        )
    }

    fn library(&self) -> String {
        let (name, chains) = (&self.name, self.chains.join(", "));
        let texts: Vec<String> =
            self.texts.iter().map(|text| format!("mstmm_chain! {{\n{text}\n}}\n")).collect();
        let texts = texts.join("\n");
        format!("use mstmm::mstmm_chain;\n\n{texts}\nmstmm_python::module!({name}: {chains});\n")
    }
}

/// Returns the name of a chain in snake case.
#[must_use]
pub fn module_name(chain: &str) -> String {
    let mut name = String::new();
    let mut before = '_';
    for letter in chain.chars() {
        if letter.is_uppercase() && (before.is_lowercase() || before.is_ascii_digit()) {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
        before = letter;
    }
    name
}
