//! Types of bodies: what stands in `body Type { … }`.

use proc_macro2::Ident;

use super::context::{Context, Given};
use super::dimension::{LENGTH, MASS};
use super::fields::{self, Fields};
use super::orientation::frame;
use crate::model::{Frame, Inertia, Value};
use crate::syntax::{Block, BlockWord, ChainDef, Extent, Written};

/// The fields of a type of body.
const FIELDS: &[&str] = &["mass", "com", "inertia", "output"];

/// A type of body as far as it could be read.
pub(crate) struct BodyType<'a> {
    /// The type's name.
    pub name: &'a Ident,
    /// Mass in kg.
    pub mass: Option<Given<Value>>,
    /// Centre of mass in m.
    pub com: Option<Given<[Value; 3]>>,
    /// Inertia tensor in kg m².
    pub inertia: Option<Given<Inertia>>,
    /// The output frame.
    pub output: Option<Given<Frame>>,
    block: &'a Block,
}

/// Whether a block describes a type of body.
pub(super) fn is_type(block: &Block) -> bool {
    block.word == BlockWord::Body && !block.after_route
}

/// All types of bodies.
pub(super) fn types<'a>(def: &'a ChainDef, context: &mut Context) -> Vec<BodyType<'a>> {
    let blocks = def.blocks.iter().filter(|block| is_type(block));
    blocks.filter_map(|block| body_type(block, context)).collect()
}

fn body_type<'a>(block: &'a Block, context: &mut Context) -> Option<BodyType<'a>> {
    let (name, others) = block.names.split_first()?;
    if let Some(other) = others.first() {
        context.diagnostics.error(other.span(), "a block describes one type of body");
    }
    let mut given = Fields::default();
    let owner = format!("body `{name}`");
    for field in &block.fields {
        given.add(field, FIELDS, &owner, context);
    }
    let [mass, com, inertia, output] = ["mass", "com", "inertia", "output"].map(|f| given.get(f));
    Some(BodyType {
        name,
        mass: mass.and_then(|f| context.field(f, |all, it| all.written_number(it, MASS))),
        com: com.and_then(|f| context.field(f, |all, it| all.written_vector(it, LENGTH))),
        inertia: inertia.and_then(|f| context.field(f, |all, it| all.written_inertia(it))),
        output: output
            .and_then(|f| context.field(f, |all, it| all.written_placement(it).map(frame))),
        block,
    })
}

impl BodyType<'_> {
    /// The fields that it lacks; it needs an output where something follows on the route.
    pub fn missing(&self, output_is_used: bool) -> Vec<&'static str> {
        let required = if output_is_used { FIELDS } else { &FIELDS[..3] };
        if !self.block.whole {
            return Vec::new();
        }
        fields::missing(&self.block.fields, required, FIELDS)
    }

    /// Where an entry of the inertia tensor stands.
    pub fn inertia_entry(&self, index: usize) -> Option<Extent> {
        let field = self.block.fields.iter().find(|field| field.name == "inertia")?;
        match field.value.as_ref()? {
            Written::Form(form) => form.list.entries.get(index).map(|entry| entry.extent),
            _ => None,
        }
    }
}
