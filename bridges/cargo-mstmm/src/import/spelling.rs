//! Finds misspelled attributes and elements.

use mstmm_codegen::diag::nearest;

use super::robot::Note;
use super::xml::Element;

/// An element that is read, with what it may have.
pub struct Known {
    pub tag: &'static str,
    /// The names of its attributes, in lists of words.
    pub attributes: &'static [&'static str],
    /// The names of the elements in it, as words.
    pub elements: &'static str,
}

/// Returns a warning for each attribute and each element that is not known and that is close to one that is. Others may
/// be those of a later version. Elements that are not in the list, and what is in them, are not searched.
pub fn notes(root: Element, list: &[Known]) -> Vec<Note> {
    let mut notes = Vec::new();
    // Without recursion, since a file may have any depth.
    let mut waiting = vec![root];
    while let Some(element) = waiting.pop() {
        let Some(known) = list.iter().find(|known| known.tag == element.tag()) else { continue };
        notes.extend(element.names().filter_map(|name| of_attribute(element, known, name)));
        let inner: Vec<Element> = element.any_children().collect();
        notes.extend(inner.iter().filter_map(|inner| of_element(*inner, known)));
        waiting.extend(inner.into_iter().rev());
    }
    notes
}

fn of_attribute(element: Element, known: &Known, name: &str) -> Option<Note> {
    let words = known.attributes.iter().flat_map(|list| list.split_whitespace());
    let meant = meant(name, words)?;
    let tag = known.tag;
    Some(element.note(format!("`{tag}` has no attribute `{name}`; did you mean `{meant}`?")))
}

fn of_element(element: Element, outer: &Known) -> Option<Note> {
    let plain = element.namespace().is_none().then(|| element.tag())?;
    let meant = meant(plain, outer.elements.split_whitespace())?;
    let tag = outer.tag;
    Some(element.note(format!("`{tag}` has no element `{plain}`; did you mean `{meant}`?")))
}

/// Returns the known word that is close to a word that is not known.
fn meant<'a>(word: &str, known: impl Iterator<Item = &'a str> + Clone) -> Option<&'a str> {
    if known.clone().any(|known| known == word) { None } else { nearest(word, known) }
}
