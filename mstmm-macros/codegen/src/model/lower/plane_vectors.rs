//! Finds a chain in a plane without the keyword `plane`: the vectors of its description have two components.

use crate::syntax::{ChainSyntax, FieldSyntax, OrientationSyntax, ValueSyntax};

/// The fields of chains, bodies, loads and springs whose vectors have a component for each direction.
const VECTORS: &[&str] = &["gravity", "com", "output", "force", "at", "to"];

/// Returns whether a description has at least two vectors, all of them with two components, and no inertia or orientation
/// in space.
pub(super) fn lacks_plane(def: &ChainSyntax) -> bool {
    let contents = def.parts.iter().map(|part| &part.content).chain([&def.content]);
    let blocks = contents.flat_map(|content| &content.blocks);
    let (fields, points): (Vec<_>, Vec<_>) =
        blocks.map(|block| (&block.fields, &block.points)).unzip();
    let fields = fields.into_iter().flatten().chain(&def.settings);
    let is_vector = |field: &&FieldSyntax| VECTORS.iter().any(|name| field.name == name);
    let (vectors, others): (Vec<_>, Vec<_>) = fields.partition(is_vector);
    let vectors = vectors.into_iter().chain(points.into_iter().flatten());
    let counts: Vec<usize> = vectors.filter_map(components).collect();
    let is_in_space = |field: &&FieldSyntax| matches!(field.value, Some(ValueSyntax::Form(_)));
    counts.len() > 1 && counts.iter().all(|&count| count == 2) && !others.iter().any(is_in_space)
}

/// Returns the number of components of a vector; one that is rotated in space has three.
fn components(field: &FieldSyntax) -> Option<usize> {
    match field.value.as_ref()? {
        ValueSyntax::Vector(list) => Some(list.entries.len()),
        ValueSyntax::Turned(_, OrientationSyntax::Form(_)) => Some(3),
        ValueSyntax::Turned(position, _) => match &**position {
            ValueSyntax::Vector(list) => Some(list.entries.len()),
            _ => None,
        },
        _ => None,
    }
}
