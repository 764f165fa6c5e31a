//! Numbers that may change at run time.

use super::context::{Context, Measure};
use crate::model::{Parameter, Value};
use crate::syntax::{ChainDef, Field, Written};

/// All parameters. From here on they may be used.
pub(super) fn parameters<'a>(def: &'a ChainDef, context: &mut Context<'a>) -> Vec<Parameter> {
    context.later_parameters = def.parameters.iter().map(|field| &field.name).collect();
    let read: Vec<_> =
        def.parameters.iter().map(|field| (&field.name, parameter(field, context))).collect();
    context.later_parameters.clear();
    let mut parameters = Vec::new();
    for (name, read) in read {
        // One with a mistake is known all the same, and fits anything.
        let (default, measure) = read.unwrap_or((Value::number(0.0), Measure::Open));
        let unit = match measure {
            Measure::Of(dimension) => dimension.unit(),
            _ => String::new(),
        };
        context.parameters.push((name, measure));
        parameters.push(Parameter { name: name.clone(), default, unit });
    }
    parameters
}

fn parameter(field: &Field, context: &mut Context) -> Option<(Value, Measure)> {
    let given = context.field(field, |context, written| match written {
        Written::Number(expr) => {
            let measured = context.measure(expr)?;
            let value = context.finite(measured.value, expr.extent)?;
            // A default of zero says nothing of what else it may be.
            let measure = match measured.measure {
                Measure::Zero => Measure::Plain,
                measure => measure,
            };
            Some((value, measure))
        }
        other => {
            let message = format!("a parameter is a number, found {}", other.described());
            context.refuse(other.extent(), message)
        }
    })?;
    Some(given.value)
}
