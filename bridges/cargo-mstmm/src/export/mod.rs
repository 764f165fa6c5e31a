//! Writes a chain as a URDF file.

mod refusals;
mod urdf;
mod values;
mod visuals;

use mstmm_codegen::model::Chain;
pub use urdf::NOT_FROM_CHAIN;
use values::Values;

/// Returns a chain as a URDF file.
///
/// # Errors
///
/// All reasons why a URDF file cannot have what the chain has.
pub fn export(chain: &Chain) -> Result<String, Vec<String>> {
    let values = Values::of_chain(chain);
    let reasons = refusals::refusals(chain, &values);
    if !reasons.is_empty() {
        return Err(reasons);
    }
    // Loads and springs are refused above; the written out chain does not have them.
    let most = chain.repeats.iter().map(|repeat| repeat.count).max().unwrap_or(1);
    let text = urdf::write(&chain.unrolled(most), &values);
    match values.is_incomplete() {
        false => Ok(text),
        true => Err(vec!["a value depends on a Rust constant: write it as a number".to_owned()]),
    }
}

/// Returns one of several chains by its name.
///
/// # Errors
///
/// The names that there are.
pub fn select<'a>(chains: &[&'a Chain], name: Option<&str>) -> Result<&'a Chain, String> {
    let names =
        || chains.iter().map(|chain| format!("`{}`", chain.name)).collect::<Vec<_>>().join(", ");
    match (chains, name) {
        ([], _) => Err("the text has no chains".to_owned()),
        ([chain], None) => Ok(chain),
        (_, None) => Err(format!("select one of the chains {} by `--name`", names())),
        (_, Some(name)) => {
            let missing = || format!("the text has the chains {}, and no `{name}`", names());
            chains.iter().copied().find(|chain| chain.name == name).ok_or_else(missing)
        }
    }
}
