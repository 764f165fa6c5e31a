//! Body types: `body Type { … }`.

use proc_macro2::Ident;

use super::context::{Context, Spanned};
use super::dimension::{LENGTH, MASS};
use super::fields::{self, Fields};
use super::inertia;
use super::vector::zeros;
use crate::model::{About, Dimension, Frame, Inertia, NamedPoint, Value};
use crate::syntax::{BlockKeyword, BlockSyntax, ChainSyntax, FieldSyntax, SpanRange, ValueSyntax};

/// The fields of a body type.
pub(super) const FIELDS: &[&str] = &["mass", "com", "inertia", "output"];
/// Its fields in a line chain, which has no rotations.
const LINE_FIELDS: &[&str] = &["mass", "com", "output"];
/// What messages list after the fields: a body has any number of points.
const POINT: &str = "point name";

/// A body type, as far as it is readable.
pub(crate) struct BodyType<'a> {
    /// The type's name.
    pub name: &'a Ident,
    /// Mass in kg.
    pub mass: Option<Spanned<Value>>,
    /// Centre of mass in m.
    pub com: Option<Spanned<[Value; 3]>>,
    /// Inertia tensor in kg m².
    pub inertia: Option<Spanned<Inertia>>,
    /// The output frame.
    pub output: Option<Spanned<Frame>>,
    /// Its named points, in m.
    pub points: Vec<PointDraft<'a>>,
    block: &'a BlockSyntax,
    space: Dimension,
}

/// A named point.
pub(crate) struct PointDraft<'a> {
    /// The name.
    pub name: &'a Ident,
    /// Where it is in the body frame, in m.
    pub position: Option<[Value; 3]>,
}

impl PointDraft<'_> {
    /// Returns the point; `None` if its position was not readable.
    pub fn finish(&self) -> Option<NamedPoint> {
        let frame = Frame { position: self.position.clone()?, ..Frame::identity() };
        Some(NamedPoint { name: self.name.clone(), frame })
    }
}

/// Whether a block describes a body type.
pub(super) fn is_type(block: &BlockSyntax) -> bool {
    block.word == BlockKeyword::Body && !block.after_route
}

/// Returns whether a block has fields that only a body type has.
pub(super) fn describes_type(block: &BlockSyntax) -> bool {
    let of_type = |field: &FieldSyntax| FIELDS.iter().any(|known| field.name == known);
    !block.points.is_empty() || block.fields.iter().any(of_type)
}

/// All body types.
pub(super) fn types<'a>(def: &'a ChainSyntax, context: &mut Context) -> Vec<BodyType<'a>> {
    let blocks = def.blocks.iter().filter(|block| is_type(block));
    blocks.filter_map(|block| body_type(block, context)).collect()
}

fn body_type<'a>(block: &'a BlockSyntax, context: &mut Context) -> Option<BodyType<'a>> {
    let (name, others) = block.names.split_first()?;
    if let Some(other) = others.first() {
        context.diagnostics.error(
            other.span(),
            "a block describes one body type: write a \
                                                 block for each",
        );
    }
    let mut fields = Fields::default();
    let owner = format!("body `{name}`{}", context.of_chain());
    let listed = [field_names(context.space), &[POINT]].concat();
    for field in &block.fields {
        fields.add(field, &listed, &owner, context);
    }
    let [mass, com, inertia, output] = ["mass", "com", "inertia", "output"].map(|f| fields.get(f));
    let body_type = BodyType {
        name,
        mass: mass
            .and_then(|f| context.field(f, |context, syntax| context.read_number(syntax, MASS))),
        com: com
            .and_then(|f| context.field(f, |context, syntax| context.read_vector(syntax, LENGTH))),
        inertia: inertia
            .and_then(|f| context.field(f, |context, syntax| context.read_inertia(syntax))),
        output: output.and_then(|f| context.field(f, |context, syntax| context.read_frame(syntax))),
        points: block.points.iter().map(|point| self::point(point, context)).collect(),
        block,
        space: context.space,
    };
    Some(body_type.with_line_defaults(SpanRange::token(name.span())))
}

fn point<'a>(point: &'a FieldSyntax, context: &mut Context) -> PointDraft<'a> {
    let position = context.field(point, |context, syntax| context.read_vector(syntax, LENGTH));
    PointDraft { name: &point.name, position: position.map(|position| position.value) }
}

fn field_names(space: Dimension) -> &'static [&'static str] {
    match space {
        Dimension::Line => LINE_FIELDS,
        Dimension::Space | Dimension::Plane => FIELDS,
    }
}

impl BodyType<'_> {
    /// Sets the defaults of a line chain: it has no rotations, so inertia and centre of mass have
    /// no effect.
    fn with_line_defaults(mut self, at: SpanRange) -> Self {
        if self.space == Dimension::Line {
            let tensor = [(); 6].map(|()| Value::number(0.0));
            self.inertia = Some(Spanned { value: Inertia { tensor, about: About::Com }, at });
            if !self.gives("com") {
                self.com = Some(Spanned { value: zeros(), at });
            }
        }
        self
    }

    /// Whether a field is written.
    pub fn gives(&self, name: &str) -> bool {
        self.field(name).is_some()
    }

    fn field(&self, name: &str) -> Option<&FieldSyntax> {
        self.block.fields.iter().find(|field| field.name == name)
    }

    /// Returns whether a field of this name is written that does not exist.
    pub fn has_unknown_field(&self, name: &Ident) -> bool {
        self.block.fields.iter().any(|field| field.name == *name)
            && !field_names(self.space).iter().any(|known| name == known)
    }

    /// The fields that it lacks; it needs an output where something follows on the route.
    pub fn missing(&self, output_is_used: bool) -> Vec<&'static str> {
        if !self.block.complete {
            return Vec::new();
        }
        let may_miss = |field: &&str| {
            (*field == "output" && !output_is_used)
                || (*field == "com" && self.space == Dimension::Line)
        };
        let field_names = field_names(self.space);
        let required: Vec<_> =
            field_names.iter().copied().filter(|field| !may_miss(field)).collect();
        fields::missing(&self.block.fields, &required, field_names)
    }

    /// Returns whether the inertia is written as `tensor(…)`, whose entries other programs have in
    /// another order.
    pub fn is_tensor(&self) -> bool {
        let written = self.field("inertia").and_then(|field| field.value.as_ref());
        matches!(written, Some(ValueSyntax::Form(form)) if form.word == "tensor")
    }

    /// Where an entry of the inertia tensor stands.
    pub fn inertia_entry(&self, index: usize) -> Option<SpanRange> {
        match self.field("inertia")?.value.as_ref()? {
            ValueSyntax::Form(form) => inertia::entry(form, index),
            ValueSyntax::Number(expr) | ValueSyntax::About(expr, _) => Some(expr.extent),
            _ => None,
        }
    }
}
