//! The lowering from the syntax tree to the model.
//!
//! Every step reads as much as possible and reports the rest, so that one build shows all errors. A
//! part that is missing because of an error is `None` in the [`Draft`].

mod angle;
mod body;
mod context;
mod dimension;
mod draft;
mod element;
mod fields;
mod hinge;
mod inertia;
mod keyword_uses;
mod load;
mod load_ends;
mod names;
mod number;
mod numbering;
mod orientation;
mod parameter;
mod parts;
mod place;
mod plane_vectors;
mod properties;
mod quantity;
mod references;
mod route;
mod route_item;
mod setting;
mod shape;
mod start;
mod unit;
mod unknown_name;
mod vector;
mod words;

pub(super) use body::BodyType;
pub(super) use context::Spanned;
pub(super) use draft::Draft;
pub(super) use fields::Fields;
pub(crate) use fields::listed;
pub(super) use hinge::{FieldNames, KINDS, groups};
#[cfg(test)]
pub(super) use keyword_uses::keywords as keywords_of;
pub(super) use parameter::warn_of_unused;
pub(super) use parts::{ItemName, WrittenOut, WrittenRepeat, WrittenRoute, write_out};
pub(super) use place::{POINTS, PlacePoint, example_place, places_of};
pub(super) use route_item::RouteItem;
pub(super) use start::RouteStart;
pub use words::RESERVED as RESERVED_NAMES;
pub(super) use words::{
    INPUTS, ITEM_WORDS, NUMBER_WORDS, PARAMETERS, ROUTE_WORDS, is_keyword_of_rust,
};

use crate::diag::Diagnostics;
use crate::model::Dimension;
use crate::syntax::{ChainSyntax, DimensionKeyword, Passthrough};
use context::Context;
use names::NameTable;
use place::Resolved;

/// Lowers a description as far as it is readable and reports errors. Returns `None` for a chain of
/// unknown dimension.
pub(super) fn draft<'a>(
    def: &'a ChainSyntax,
    written: &'a WrittenOut<'a>,
    diagnostics: &mut Diagnostics,
) -> Option<(Draft<'a>, Passthrough)> {
    let space = match def.dimension? {
        DimensionKeyword::Space if plane_vectors::lacks_plane(def) => {
            let name = &def.name;
            let message =
                format!("all vectors of this chain have 2 components: write `plane chain {name}`");
            diagnostics.error(name.span(), message);
            Dimension::Plane
        }
        DimensionKeyword::Space => Dimension::Space,
        DimensionKeyword::Plane => Dimension::Plane,
        DimensionKeyword::Line => Dimension::Line,
    };
    let mut context = Context::new(space, written.complete, diagnostics);
    context.part_parameters = def.parts.iter().flat_map(|part| &part.parameters).collect();
    let parameters = parameter::parameters(def, &mut context);
    let settings = setting::settings(def, &mut context);
    let types = body::types(written, &mut context);
    let items = route::items(written, &types, &mut context);
    let names = NameTable::new(written, &items);
    let resolved = Resolved { written, items: &items, types: &types, names: &names };
    let seeds = start::seeds(resolved, &mut context);
    let starts = start::starts(resolved, &seeds, &mut context);
    let properties = properties::properties(resolved, &mut context);
    let (loads, springs) = load::loads(resolved, &seeds, &mut context);
    start::warn_of_unused(resolved, &seeds, &mut context);
    parts::warn_of_unused(def, &mut context);
    let references = references::references(def, resolved);
    let requirements = std::mem::take(&mut context.requirements);
    let unused = def.parameters.iter().zip(&context.parameters).filter(|(_, known)| !known.is_used);
    let unused_parameters = unused.map(|(def, _)| &def.field.name).collect();
    let quaternions = std::mem::take(&mut context.quaternions);
    let passthrough = Passthrough {
        visibility: def.visibility.clone(),
        attributes: def.attributes.clone(),
        constants: context.constants,
        instances: written.instances(),
        references,
    };
    let constants = passthrough.constants.len();
    let draft = Draft {
        def,
        space,
        requirements,
        quaternions,
        settings,
        parameters,
        unused_parameters,
        constants,
        written,
        types,
        items,
        names,
        starts,
        properties,
        loads,
        springs,
    };
    Some((draft, passthrough))
}

/// Returns the keywords of all fields and of their values.
#[cfg(test)]
pub(super) fn keywords() -> Vec<&'static str> {
    let fields =
        [body::FIELDS, load::LOAD_FIELDS, load::SPRING_FIELDS, POINTS, &shape::LENGTHS].concat();
    let hinges = KINDS.iter().flat_map(|kind| {
        let of_hinge = |kind: crate::model::HingeKind| hinge::fields(kind.spec());
        std::iter::once(kind.word)
            .chain(kind.plain(Dimension::Space).into_iter().flat_map(of_hinge))
    });
    let methods = setting::METHODS.iter().map(|(word, _)| *word);
    let results = setting::RESULTS.iter().map(|(word, _)| *word);
    let answers = crate::model::ANSWER_WORDS.iter().map(|(word, _)| *word);
    let axes = load::AXES.iter().map(|(word, _)| *word);
    fields
        .into_iter()
        .chain(hinges)
        .chain(methods)
        .chain(results)
        .chain(answers)
        .chain(axes)
        .collect()
}
