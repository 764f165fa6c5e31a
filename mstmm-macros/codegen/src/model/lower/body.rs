//! Body types: `body Type { … }`.

use proc_macro2::Ident;
use std::collections::HashMap;
use syn::ext::IdentExt;

use super::context::{Context, Spanned};
use super::dimension::{LENGTH, MASS};
use super::fields::{self, FieldOwner, Fields};
use super::inertia;
use super::parts::{WrittenBlock, WrittenOut};
use super::vector::zeros;
use crate::model::{About, Dimension, Frame, Inertia, NamedPoint, Shape, Value};
use crate::syntax::{BlockKeyword, BlockSyntax, FieldSyntax, SpanRange, ValueSyntax};

/// The fields of a body type.
pub(super) const FIELDS: &[&str] = &["mass", "com", "inertia", "output", "shape"];
/// Its fields in a line chain, which has no rotations.
const LINE_FIELDS: &[&str] = &["mass", "com", "output", "shape"];

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
    /// Its named points.
    pub points: Vec<PointDraft<'a>>,
    /// Its shapes for pictures; without those that are not readable.
    pub shapes: Vec<Shape>,
    /// The beginning of the name of the type of its results: its name, after that of its part.
    pub result_name: Ident,
    /// The part in which it is described.
    pub part: Option<&'a Ident>,
    /// The block as written.
    pub source: &'a BlockSyntax,
    block: &'a BlockSyntax,
    space: Dimension,
}

/// All body types.
pub(crate) struct BodyTypes<'a> {
    /// The types. Instances of a part share those that do not depend on its parameters.
    pub all: Vec<BodyType<'a>>,
    /// The first type of each name in each scope.
    by_name: HashMap<(usize, String), usize>,
    /// The types of each scope.
    of_scope: HashMap<usize, Vec<usize>>,
}

impl<'a> BodyTypes<'a> {
    /// Returns the index of the type that a name means in a scope: one of the part, or one of the chain.
    pub fn find(&self, scope: usize, name: &Ident) -> Option<usize> {
        let in_scope = |scope: usize| self.by_name.get(&(scope, name.to_string())).copied();
        in_scope(scope).or_else(|| in_scope(0))
    }

    /// Returns the types that a scope may use.
    pub fn visible(&self, scope: usize) -> impl Iterator<Item = &BodyType<'a>> {
        let chain = (scope > 0).then_some(0);
        let scopes = [Some(scope), chain].into_iter().flatten();
        let types = scopes.filter_map(|scope| self.of_scope.get(&scope)).flatten();
        types.map(|&index| &self.all[index])
    }
}

/// A named point.
pub(crate) struct PointDraft<'a> {
    /// The name.
    pub name: &'a Ident,
    /// The frame there, in the body frame.
    pub frame: Option<Frame>,
}

impl PointDraft<'_> {
    /// Returns the point; `None` if its frame was not readable.
    pub fn finish(&self) -> Option<NamedPoint> {
        Some(NamedPoint { name: self.name.clone(), frame: self.frame.clone()? })
    }
}

/// Whether a block describes a body type.
pub(super) fn is_type(block: &BlockSyntax) -> bool {
    block.word == BlockKeyword::Body
        && !block.after_route
        && block.names.iter().all(|path| path.names.len() == 1)
}

/// Returns whether a block has fields that only a body type has.
pub(super) fn describes_type(block: &BlockSyntax) -> bool {
    let of_type = |field: &FieldSyntax| FIELDS.iter().any(|known| field.name == known);
    !block.points.is_empty() || block.fields.iter().any(of_type)
}

/// All body types.
pub(super) fn types<'a>(written: &'a WrittenOut<'a>, context: &mut Context) -> BodyTypes<'a> {
    let (by_name, of_scope) = (HashMap::new(), HashMap::<usize, Vec<usize>>::new());
    let mut types = BodyTypes { all: Vec::new(), by_name, of_scope };
    // Blocks without parameters are read once.
    let mut read: HashMap<*const BlockSyntax, usize> = HashMap::new();
    for block in written.blocks.iter().filter(|block| is_type(&block.syntax)) {
        let key = std::ptr::from_ref(&*block.syntax);
        let index = match read.get(&key) {
            Some(&index) => index,
            None => {
                let part = written.scopes[block.scope].part.map(|part| &part.name);
                let Some(body_type) = body_type(block, part, context) else { continue };
                types.all.push(body_type);
                types.all.len() - 1
            }
        };
        read.insert(key, index);
        let name = types.all[index].name.to_string();
        types.by_name.entry((block.scope, name)).or_insert(index);
        types.of_scope.entry(block.scope).or_default().push(index);
    }
    types
}

fn body_type<'a>(
    written: &'a WrittenBlock<'a>,
    part: Option<&'a Ident>,
    context: &mut Context,
) -> Option<BodyType<'a>> {
    let block = &*written.syntax;
    let (path, others) = block.names.split_first()?;
    let name = path.end();
    if let Some(other) = others.first() {
        context.diagnostics.error(
            other.end().span(),
            "a block describes one body type: write a \
                                                 block for each",
        );
    }
    let mut fields = Fields::default();
    let owner = format!("body `{name}`{}", context.of_chain());
    let listed = [field_names(context.space), &[fields::POINT]].concat();
    for field in &block.fields {
        fields.add(field, &listed, &FieldOwner::of_block(&owner, &block.fields), context);
    }
    let [mass, com, inertia, output, shape] =
        ["mass", "com", "inertia", "output", "shape"].map(|f| fields.get(f));
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
        shapes: context.readable(shape, Vec::new, |context, syntax| context.read_shapes(syntax)),
        result_name: match part {
            Some(part) => Ident::new(&format!("{}{}", part.unraw(), name.unraw()), name.span()),
            None => name.clone(),
        },
        part,
        source: written.source,
        block,
        space: context.space,
    };
    Some(body_type.with_line_defaults(SpanRange::token(name.span())))
}

fn point<'a>(point: &'a FieldSyntax, context: &mut Context) -> PointDraft<'a> {
    let frame = context.field(point, |context, syntax| context.read_frame(syntax));
    PointDraft { name: &point.name, frame: frame.map(|frame| frame.value) }
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

    /// Returns whether a point of this name may be written with an error: as a field that does not exist, or in a block
    /// that was not readable in all places.
    pub fn may_have_point(&self, name: &Ident) -> bool {
        let is_field = self.block.fields.iter().any(|field| field.name == *name)
            && !field_names(self.space).iter().any(|known| name == known);
        is_field || !self.block.complete
    }

    /// The fields that it lacks; it needs an output where something follows on the route.
    pub fn missing(&self, output_is_used: bool) -> Vec<&'static str> {
        if !self.block.complete {
            return Vec::new();
        }
        let may_miss = |field: &&str| {
            *field == "shape"
                || (*field == "output" && !output_is_used)
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
