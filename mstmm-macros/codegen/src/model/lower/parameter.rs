//! Parameters: values that may change at run time.

use proc_macro2::Ident;

use super::context::{Context, KnownParameter, Measure};
use crate::diag::Diagnostics;
use crate::ids::IdVec;
use crate::model::{Parameter, ParameterId, Symbol, Value};
use crate::syntax::{ChainSyntax, FORMS, FieldSyntax, ParameterSyntax, ValueSyntax};

/// Reads all parameters. After this they may be used.
pub(super) fn parameters<'a>(
    def: &'a ChainSyntax,
    context: &mut Context<'a>,
) -> IdVec<ParameterId, Parameter> {
    context.later_parameters = def.parameters.iter().map(|def| &def.field.name).collect();
    let read: Vec<_> =
        def.parameters.iter().map(|def| (def, parameter(&def.field, context))).collect();
    context.later_parameters.clear();
    let mut parameters = IdVec::new();
    for (index, (ParameterSyntax { field, repetitions }, read)) in read.into_iter().enumerate() {
        let FieldSyntax { name, value, .. } = field;
        let default_expr = match value {
            Some(ValueSyntax::Number(expr)) if read.is_some() => Some(expr),
            _ => None,
        };
        // A parameter with an error is known, fits any dimension and has no known value: its
        // default is the parameter itself.
        let itself = Value::Symbol(Symbol::Parameter(ParameterId(index)));
        let (default, measure) = read.unwrap_or((itself, Measure::Open));
        let unit = match measure {
            Measure::Of(dimension) => dimension.unit(),
            _ => String::new(),
        };
        let parameter = KnownParameter {
            name,
            measure,
            default: default.known(),
            default_expr,
            is_used: false,
        };
        context.parameters.push(parameter);
        parameters.push(Parameter { name: name.clone(), default, unit, repetitions: *repetitions });
    }
    parameters
}

/// The rule that a parameter is used: of a chain, or of a part.
pub(super) const UNUSED: &str = "UNUSED_PARAMETER";

/// Warns of parameters on which no value of the chain depends. A name that begins with `_` may be unused, as in Rust.
pub(crate) fn warn_of_unused(unused: &[&Ident], diagnostics: &mut Diagnostics) {
    for name in unused.iter().filter(|name| !name.to_string().starts_with('_')) {
        let message = format!(
            "no value depends on the parameter `{name}`: use it, remove it, or write `_{name}`"
        );
        diagnostics.warn(name.span(), UNUSED, message);
    }
}

fn parameter(field: &FieldSyntax, context: &mut Context) -> Option<(Value, Measure)> {
    let read = context.field(field, |context, syntax| match syntax {
        ValueSyntax::Number(expr) => {
            let measured = context.measure(expr)?;
            let value = context.finite(measured.value, expr.extent)?;
            // A default of zero does not determine the dimension.
            let measure = match measured.measure {
                Measure::Zero => Measure::Plain,
                measure => measure,
            };
            Some((value, measure))
        }
        ValueSyntax::Form(form) if FORMS.iter().all(|known| form.word != known) => {
            context.unknown_function(&form.word)
        }
        other => {
            let message = format!("a parameter is a number, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    })?;
    Some(read.value)
}
