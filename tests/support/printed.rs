//! Reading what anything generated prints of itself.

use std::collections::BTreeMap;
use std::fmt::Debug;

/// The numbers of anything generated, in order, as it prints itself: to the last bit.
pub fn numbers(of: &dyn Debug) -> Vec<f64> {
    quantities(of).into_values().flatten().collect()
}

/// The same by the names of the fields that hold them: positions of all points are one quantity,
/// accelerations of all hinges another one. Numbers of no field have no name.
pub fn quantities(of: &dyn Debug) -> BTreeMap<String, Vec<f64>> {
    let text = format!("{of:?}");
    let mut quantities: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    let mut name = String::new();
    let is_word = |c: char| c.is_alphanumeric() || "_-+.".contains(c);
    for word in text.split(|c: char| !(is_word(c) || c == ':')).filter(|word| !word.is_empty()) {
        match (word.strip_suffix(':'), word.parse()) {
            (Some(field), _) => name = field.to_owned(),
            (None, Ok(number)) => quantities.entry(name.clone()).or_default().push(number),
            // The name of a type.
            (None, Err(_)) => {}
        }
    }
    quantities
}
