//! Tables of names, values and units.

use core::fmt::{self, Display, Write};
use core::slice;

/// The number of digits behind the point if the format has no precision.
const PRECISION: usize = 4;

/// A row of a table.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a, L, T> {
    /// The label in the first column.
    pub label: L,
    /// The values.
    pub values: &'a [T],
    /// Their unit; `1` and an empty text are omitted.
    pub unit: &'static str,
}

impl<'a, L, T> Row<'a, L, T> {
    /// Makes a row with one value.
    pub fn one(label: L, value: &'a T, unit: &'static str) -> Self {
        Row { label, values: slice::from_ref(value), unit }
    }

    /// Makes a row with some values.
    pub fn of(label: L, values: &'a [T], unit: &'static str) -> Self {
        Row { label, values, unit }
    }
}

/// How a scalar is shown.
pub type Show<T> = fn(&T, &mut fmt::Formatter<'_>) -> fmt::Result;

/// Writes the rows of a table, one a line, without a line break after the last one.
///
/// `rows` is called twice, first for the widths of the columns.
///
/// # Errors
/// Those of the formatter.
pub fn write<'a, L: Display, T: 'a, I: Iterator<Item = Row<'a, L, T>>>(
    f: &mut fmt::Formatter<'_>,
    show: Show<T>,
    rows: impl Fn() -> I,
) -> fmt::Result {
    let style = Style { precision: f.precision().unwrap_or(PRECISION), plus: f.sign_plus() };
    let (mut of_labels, mut of_values) = (0, 0);
    for row in rows() {
        of_labels = of_labels.max(length(|to| write!(to, "{}", row.label))?);
        for value in row.values {
            of_values = of_values.max(length(|to| style.write(to, Shown(value, show)))?);
        }
    }
    for (number, row) in rows().enumerate() {
        if number > 0 {
            f.write_char('\n')?;
        }
        write!(f, "{}", row.label)?;
        spaces(f, of_labels - length(|to| write!(to, "{}", row.label))?)?;
        for value in row.values {
            spaces(f, 2 + of_values - length(|to| style.write(to, Shown(value, show)))?)?;
            style.write(f, Shown(value, show))?;
        }
        if !matches!(row.unit, "1" | "") {
            write!(f, " {}", row.unit)?;
        }
    }
    Ok(())
}

/// How all values of a table are written.
struct Style {
    precision: usize,
    plus: bool,
}

impl Style {
    fn write(&self, to: &mut impl Write, value: impl Display) -> fmt::Result {
        match self.plus {
            true => write!(to, "{value:+.*}", self.precision),
            false => write!(to, "{value:.*}", self.precision),
        }
    }
}

/// A value with the function that shows it.
struct Shown<'a, T>(&'a T, Show<T>);

impl<T> Display for Shown<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (self.1)(self.0, f)
    }
}

fn spaces(f: &mut fmt::Formatter<'_>, count: usize) -> fmt::Result {
    (0..count).try_for_each(|_| f.write_char(' '))
}

/// The number of characters written.
struct Length(usize);

impl Write for Length {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 += text.chars().count();
        Ok(())
    }
}

fn length(write: impl FnOnce(&mut Length) -> fmt::Result) -> Result<usize, fmt::Error> {
    let mut length = Length(0);
    write(&mut length)?;
    Ok(length.0)
}
