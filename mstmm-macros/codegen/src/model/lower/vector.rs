//! Several numbers of one kind.

use super::context::{Context, Given, Measure};
use super::dimension::Quantity;
use super::number::Measured;
use crate::model::Value;
use crate::syntax::{Form, List, Written};

impl Context<'_> {
    /// A number after `=`.
    pub fn written_number(&mut self, written: &Written, expected: &Quantity) -> Option<Value> {
        match written {
            Written::Number(expr) => self.number(expr, expected),
            other => {
                let message = format!("expected {}, found {}", expected.name, other.described());
                self.refuse(other.extent(), message)
            }
        }
    }

    /// A vector after `=`.
    pub fn written_vector(&mut self, written: &Written, expected: &Quantity) -> Option<[Value; 3]> {
        match written {
            Written::Vector(list) => self.vector(list, expected),
            Written::Placement(_, orientation) => {
                self.refuse(orientation.extent(), "nothing is turned here; `[x, y, z]` is enough")
            }
            other => {
                let message = format!("expected a vector `[x, y, z]`, found {}", other.described());
                self.refuse(other.extent(), message)
            }
        }
    }

    /// Three components.
    pub fn vector(&mut self, list: &List, expected: &Quantity) -> Option<[Value; 3]> {
        if list.entries.len() != 3 {
            let message = format!("a vector has 3 components, here are {}", list.entries.len());
            return self.refuse(list.extent, message);
        }
        self.numbers(list, expected)
    }

    /// The numbers in the parentheses of a form.
    pub fn form_numbers<const N: usize>(
        &mut self,
        form: &Form,
        names: [&str; N],
        expected: &Quantity,
    ) -> Option<[Value; N]> {
        if form.list.entries.len() != N {
            let (word, found) = (&form.word, form.list.entries.len());
            let message = format!("expected `{word}({})`, found {found} numbers", names.join(", "));
            return self.refuse(form.list.extent, message);
        }
        self.numbers(&form.list, expected)
    }

    fn numbers<const N: usize>(&mut self, list: &List, expected: &Quantity) -> Option<[Value; N]> {
        // All entries are read before giving up, so that all mistakes in them are reported.
        let parts: Vec<_> = list.entries.iter().map(|entry| self.measure(entry)).collect();
        let unit = list.unit.as_ref().map(|unit| (unit, self.unit(unit)));
        let mut parts: Vec<_> = parts.into_iter().collect::<Option<_>>()?;
        if let Some((unit, known)) = unit {
            let (scale, dimension) = known?;
            let bare = parts.iter().map(|part| self.expect_no_unit(part)).fold(Some(()), and);
            bare?;
            let whole = Measured {
                value: Value::number(1.0),
                measure: Measure::Of(dimension),
                unit: Some(unit),
                at: unit.extent,
            };
            self.expect(&whole, expected)?;
            for part in &mut parts {
                part.value = scale.apply(part.value.clone());
            }
        } else {
            let fits = parts.iter().map(|part| self.expect(part, expected)).fold(Some(()), and);
            fits?;
            self.common_measure(&parts, "one vector")?;
        }
        let values = parts.into_iter().zip(&list.entries);
        let values: Vec<_> =
            values.map(|(part, entry)| self.finite(part.value, entry.extent)).collect();
        values.into_iter().collect::<Option<Vec<_>>>()?.try_into().ok()
    }

    /// A field that may be left away.
    pub fn optional<T>(
        &mut self,
        field: Option<&crate::syntax::Field>,
        default: impl FnOnce() -> T,
        read: impl FnOnce(&mut Self, &Written) -> Option<T>,
    ) -> Option<T> {
        match field {
            None => Some(default()),
            Some(field) => self.field(field, read).map(|Given { value, .. }| value),
        }
    }
}

fn and(all: Option<()>, next: Option<()>) -> Option<()> {
    all.and(next)
}

/// Three zeros.
pub(super) fn zeros() -> [Value; 3] {
    [(); 3].map(|()| Value::number(0.0))
}
