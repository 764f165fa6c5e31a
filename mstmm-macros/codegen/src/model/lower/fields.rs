//! The fields of one part, whatever they say.

use super::context::Context;
use crate::diag::{did_you_mean, nearest};
use crate::syntax::Field;

/// Fields by name, each known and given once.
#[derive(Clone, Debug, Default)]
pub(super) struct Fields<'a> {
    fields: Vec<&'a Field>,
}

/// Fields that are kept for later.
const LATER_FIELDS: &[&str] =
    &["stiffness", "damping", "armature", "rest", "friction", "limits", "motion"];

impl<'a> Fields<'a> {
    /// Takes a field, unless it is not `known` or given twice, which is reported.
    /// `owner` is whom it speaks of.
    pub fn add(
        &mut self,
        field: &'a Field,
        known: &[&str],
        owner: &str,
        context: &mut Context,
    ) -> Option<()> {
        let name = field.name.to_string();
        if !known.contains(&name.as_str()) {
            // One without a value is reported already: it may be no field at all.
            field.value.as_ref()?;
            if LATER_FIELDS.contains(&name.as_str()) {
                return context.refuse(&field.name, format!("`{name}` is not supported yet"));
            }
            let hint = did_you_mean(&name, known.iter().copied());
            return context.refuse(&field.name, format!("{owner} has no field `{name}`{hint}"));
        }
        if self.get(&name).is_some() {
            return context.refuse(&field.name, format!("`{name}` of {owner} is given twice"));
        }
        self.fields.push(field);
        Some(())
    }

    /// The field of this name.
    pub fn get(&self, name: &str) -> Option<&'a Field> {
        self.fields.iter().copied().find(|field| field.name == name)
    }
}

/// Those of `required` that are missing. A field whose name is close counts as given: it is
/// reported as unknown, and its correction is the cure. One that could not be read may be any.
pub(super) fn missing<'r>(fields: &[Field], required: &[&'r str], known: &[&str]) -> Vec<&'r str> {
    if fields.iter().any(|field| field.value.is_none() && !known.iter().any(|k| field.name == k)) {
        return Vec::new();
    }
    let is_meant = |name: &str| {
        fields.iter().any(|field| {
            let given = field.name.to_string();
            given == name
                || (!known.contains(&given.as_str())
                    && nearest(&given, known.iter().copied()) == Some(name))
        })
    };
    required.iter().copied().filter(|name| !is_meant(name)).collect()
}
