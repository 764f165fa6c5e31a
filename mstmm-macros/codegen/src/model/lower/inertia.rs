//! Inertia tensors.

use proc_macro2::Ident;

use super::context::Context;
use super::dimension::{INERTIA, Quantity};
use crate::diag::did_you_mean;
use crate::model::{About, Dimension, Inertia, Value};
use crate::syntax::{FormSyntax, OrientationSyntax, SpanRange, ValueSyntax};

/// Reads one of the forms of a tensor: xx, yy, zz, xy, xz, yz.
type TensorReader = fn(&mut Context, &FormSyntax, &Quantity) -> Option<[Value; 6]>;

/// The forms of a tensor.
const TENSORS: &[(&str, TensorReader)] = &[("diag", diag), ("tensor", tensor), ("matrix", matrix)];

/// The indices of the entries of a tensor in a matrix, row by row.
const IN_MATRIX: [usize; 6] = [0, 4, 8, 1, 2, 5];

/// Entries are equal if their difference is less than this, relative to the largest one.
const ROUNDING: f64 = 1e-9;

/// The reference points of a tensor.
const POINTS: &[(&str, About)] = &[("input", About::Input), ("com", About::Com)];

fn diag(context: &mut Context, form: &FormSyntax, expected: &Quantity) -> Option<[Value; 6]> {
    let [xx, yy, zz] = context.form_numbers(form, ["xx", "yy", "zz"], expected)?;
    let zero = || Value::number(0.0);
    Some([xx, yy, zz, zero(), zero(), zero()])
}

fn tensor(context: &mut Context, form: &FormSyntax, expected: &Quantity) -> Option<[Value; 6]> {
    context.form_numbers(form, ["xx", "yy", "zz", "xy", "xz", "yz"], expected)
}

/// The whole tensor, row by row.
fn matrix(context: &mut Context, form: &FormSyntax, expected: &Quantity) -> Option<[Value; 6]> {
    let names = ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"];
    let entries = context.form_numbers(form, names, expected)?;
    let largest = entries.iter().filter_map(Value::known).fold(0.0, |a: f64, b| a.max(b.abs()));
    let mut symmetric = Some(());
    for (above, below) in [(1, 3), (2, 6), (5, 7)] {
        let same = match (entries[above].known(), entries[below].known()) {
            (Some(a), Some(b)) => (a - b).abs() <= ROUNDING * largest,
            _ => entries[above] == entries[below],
        };
        if !same {
            let at = form.list.entries[below].extent;
            let (above, below) = (names[above], names[below]);
            let message = format!("an inertia is symmetric: `{below}` must equal `{above}`");
            symmetric = context.refuse(at, message);
        }
    }
    symmetric?;
    Some(IN_MATRIX.map(|index| entries[index].clone()))
}

/// Returns `R I Rᵀ`: a tensor in axes that the rotation matrix `R` takes to the body's axes.
fn rotated(tensor: &[Value; 6], rotation: &[[Value; 3]; 3]) -> [Value; 6] {
    let dot = |a: [&Value; 3], b: [&Value; 3]| {
        let products = a.into_iter().zip(b).map(|(a, b)| a.clone().times(b.clone()));
        products.fold(Value::number(0.0), Value::plus)
    };
    let [xx, yy, zz, xy, xz, yz] = tensor;
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    IN_MATRIX.map(|index| {
        let [left, right] = [index / 3, index % 3].map(|row| rotation[row].each_ref());
        let product = rows.map(|row| dot(row, right));
        dot(left, product.each_ref())
    })
}

/// Returns the place of an entry of a tensor in a form.
pub(super) fn entry(form: &FormSyntax, index: usize) -> Option<SpanRange> {
    let index = if form.word == "matrix" { *IN_MATRIX.get(index)? } else { index };
    form.list.entries.get(index).map(|entry| entry.extent)
}

impl Context<'_> {
    /// Reads an inertia tensor.
    pub fn read_inertia(&mut self, syntax: &ValueSyntax) -> Option<Inertia> {
        const EXPECTED: &str =
            "expected `diag(xx, yy, zz)`, `tensor(xx, yy, zz, xy, xz, yz)` or `matrix(…)`";
        if self.space == Dimension::Plane {
            return self.plane_inertia(syntax);
        }
        let (written, axes) = match syntax {
            ValueSyntax::Turned(written, axes) => (&**written, Some(axes)),
            written => (written, None),
        };
        let ValueSyntax::Form(form) = written else {
            let message = format!("{EXPECTED}, found {}", written.described());
            return self.refuse(written.extent(), message);
        };
        let word = form.word.to_string();
        let Some((_, read)) = TENSORS.iter().find(|(known, _)| *known == word) else {
            let hint = did_you_mean(&word, TENSORS.iter().map(|(known, _)| *known));
            return self.refuse(&form.word, format!("{EXPECTED}, found `{word}`{hint}"));
        };
        let tensor = read(self, form, INERTIA);
        let about = match axes {
            Some(OrientationSyntax::Form(FormSyntax { about: Some(point), .. })) => {
                let message = format!("write `about {point}` before `turned`");
                return self.refuse(point, message);
            }
            _ => self.about(SpanRange::token(form.word.span()), form.about.as_ref()),
        };
        let axes = axes.map(|axes| self.turned(axes));
        let tensor = match axes {
            Some(axes) => rotated(&tensor?, &axes?.rotation()),
            None => tensor?,
        };
        Some(Inertia { tensor, about: about? })
    }

    /// Reads the inertia in a plane chain: the moment about z.
    fn plane_inertia(&mut self, syntax: &ValueSyntax) -> Option<Inertia> {
        let (expr, point) = match syntax {
            ValueSyntax::Number(expr) => (expr, None),
            ValueSyntax::About(expr, point) => (expr, Some(point)),
            other => {
                let found = other.described();
                let message = format!(
                    "expected one moment of inertia in a plane chain, such as `0.1 kg*m^2 about \
                     com`, found {found}"
                );
                return self.refuse(other.extent(), message);
            }
        };
        let about_z = self.number(expr, INERTIA);
        let about = self.about(expr.extent, point);
        let mut tensor = [(); 6].map(|()| Value::number(0.0));
        tensor[2] = about_z?;
        Some(Inertia { tensor, about: about? })
    }

    fn about(&mut self, inertia: SpanRange, point: Option<&Ident>) -> Option<About> {
        let Some(point) = point else {
            let message = "an inertia needs a reference point: end with `about com` or `about \
                           input`";
            return self.refuse(inertia, message);
        };
        let about = POINTS.iter().find(|(word, _)| point == word).map(|&(_, about)| about);
        if about.is_none() {
            let hint = did_you_mean(&point.to_string(), POINTS.iter().map(|(word, _)| *word));
            let message = format!("expected `input` or `com`, found `{point}`{hint}");
            self.diagnostics.error(point.span(), message);
        }
        about
    }
}
