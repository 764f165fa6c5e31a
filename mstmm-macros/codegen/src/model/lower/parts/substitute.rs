//! Replaces the parameters of a part by the arguments of an instance.

use std::collections::HashMap;
use std::rc::Rc;

use crate::diag::InstanceId;
use crate::syntax::{
    ArgumentsSyntax, BlockSyntax, ExprKind, ExprSyntax, FactorSyntax, FieldSyntax, FormSyntax,
    ListSyntax, OrientationSyntax, RouteItemSyntax, ShapeArgument, ShapeSyntax, ShapesSyntax,
    SpanRange, TermSyntax, ValueSyntax,
};

/// The arguments of an instance by the names of the parameters.
pub(super) struct Substitution {
    /// The arguments, in which nothing is to be replaced any more.
    pub arguments: HashMap<String, Rc<ExprSyntax>>,
    /// The instance, for messages.
    pub instance: Option<InstanceId>,
}

/// The functions return `None` where no parameter is used.
impl Substitution {
    /// Returns an item with its parameters replaced.
    pub fn item(&self, item: &RouteItemSyntax) -> Option<RouteItemSyntax> {
        match item {
            RouteItemSyntax::Element {
                word,
                arguments: Some(arguments),
                name,
                place,
                after_error,
            } => Some(RouteItemSyntax::Element {
                word: word.clone(),
                arguments: Some(self.arguments_of(arguments)?),
                name: name.clone(),
                place: *place,
                after_error: *after_error,
            }),
            // Parts contain no ends.
            _ => None,
        }
    }

    fn arguments_of(&self, arguments: &ArgumentsSyntax) -> Option<ArgumentsSyntax> {
        let values = self.all(&arguments.values, |value| self.value(value))?;
        Some(ArgumentsSyntax { values, extent: self.extent(arguments.extent) })
    }

    /// Returns a block with its parameters replaced.
    pub fn block(&self, block: &BlockSyntax) -> Option<BlockSyntax> {
        let fields = self.all(&block.fields, |field| self.field(field));
        let points = self.all(&block.points, |point| self.field(point));
        if fields.is_none() && points.is_none() {
            return None;
        }
        Some(BlockSyntax {
            fields: fields.unwrap_or_else(|| block.fields.clone()),
            points: points.unwrap_or_else(|| block.points.clone()),
            ..block.clone()
        })
    }

    fn field(&self, field: &FieldSyntax) -> Option<FieldSyntax> {
        let value = self.value(field.value.as_ref()?)?;
        Some(FieldSyntax { name: field.name.clone(), value: Some(value) })
    }

    fn value(&self, value: &ValueSyntax) -> Option<ValueSyntax> {
        Some(match value {
            ValueSyntax::Number(expr) => ValueSyntax::Number(self.expr(expr)?),
            ValueSyntax::Vector(list) => ValueSyntax::Vector(self.list(list)?),
            ValueSyntax::Form(form) => ValueSyntax::Form(self.form(form)?),
            ValueSyntax::About(expr, point) => ValueSyntax::About(self.expr(expr)?, point.clone()),
            ValueSyntax::Turned(position, orientation) => {
                let replaced = (self.value(position), self.orientation(orientation));
                if let (None, None) = replaced {
                    return None;
                }
                let (position_of, orientation_of) = replaced;
                ValueSyntax::Turned(
                    position_of.map_or_else(|| position.clone(), Box::new),
                    orientation_of.unwrap_or_else(|| orientation.clone()),
                )
            }
            ValueSyntax::Shapes(list) => ValueSyntax::Shapes(self.shapes(list)?),
            ValueSyntax::Path(_) | ValueSyntax::PlaceOn(..) => return None,
        })
    }

    fn shapes(&self, list: &ShapesSyntax) -> Option<ShapesSyntax> {
        let shapes = self.all(&list.shapes, |shape| self.shape(shape))?;
        Some(ShapesSyntax { shapes, extent: self.extent(list.extent) })
    }

    fn shape(&self, shape: &ShapeSyntax) -> Option<ShapeSyntax> {
        let arguments = self.all(&shape.arguments, |(name, argument)| {
            let ShapeArgument::Value(value) = argument else { return None };
            Some((name.clone(), ShapeArgument::Value(self.value(value)?)))
        });
        let position = shape.position.as_ref().and_then(|position| self.value(position));
        let orientation = shape.orientation.as_ref().and_then(|it| self.orientation(it));
        if arguments.is_none() && position.is_none() && orientation.is_none() {
            return None;
        }
        let ShapeSyntax { word, parentheses, extent, .. } = shape;
        Some(ShapeSyntax {
            word: word.clone(),
            arguments: arguments.unwrap_or_else(|| shape.arguments.clone()),
            parentheses: self.extent(*parentheses),
            position: position.or_else(|| shape.position.clone()),
            orientation: orientation.or_else(|| shape.orientation.clone()),
            extent: self.extent(*extent),
        })
    }

    fn orientation(&self, orientation: &OrientationSyntax) -> Option<OrientationSyntax> {
        Some(match orientation {
            OrientationSyntax::Angle(angle) => OrientationSyntax::Angle(self.expr(angle)?),
            OrientationSyntax::Form(form) => OrientationSyntax::Form(self.form(form)?),
        })
    }

    fn form(&self, form: &FormSyntax) -> Option<FormSyntax> {
        let list = self.list(&form.list)?;
        Some(FormSyntax { word: form.word.clone(), list, about: form.about.clone() })
    }

    fn list(&self, list: &ListSyntax) -> Option<ListSyntax> {
        let entries = self.exprs(&list.entries)?;
        Some(ListSyntax { entries, unit: list.unit.clone(), extent: self.extent(list.extent) })
    }

    fn exprs(&self, exprs: &[ExprSyntax]) -> Option<Vec<ExprSyntax>> {
        self.all(exprs, |expr| self.expr(expr))
    }

    /// Returns a number with its parameters replaced.
    pub fn expr(&self, expr: &ExprSyntax) -> Option<ExprSyntax> {
        let boxed = |expr: &ExprSyntax| self.expr(expr).map(Box::new);
        let kind = match &expr.kind {
            ExprKind::Name(name) => {
                let argument = self.arguments.get(&name.to_string())?;
                ExprKind::Argument(name.clone(), argument.clone())
            }
            ExprKind::Parenthesized(inner) => ExprKind::Parenthesized(boxed(inner)?),
            ExprKind::Negated(inner) => ExprKind::Negated(boxed(inner)?),
            ExprKind::Power(base, power) => ExprKind::Power(boxed(base)?, *power),
            ExprKind::Quantity(inner, unit) => ExprKind::Quantity(boxed(inner)?, unit.clone()),
            ExprKind::Call(function, arguments) => {
                ExprKind::Call(function.clone(), self.exprs(arguments)?)
            }
            ExprKind::Sum(terms) => ExprKind::Sum(self.all(terms, |term| {
                Some(TermSyntax { negative: term.negative, expr: self.expr(&term.expr)? })
            })?),
            ExprKind::Product(factors) => ExprKind::Product(self.all(factors, |factor| {
                Some(FactorSyntax { divides: factor.divides, expr: self.expr(&factor.expr)? })
            })?),
            ExprKind::Number(_) | ExprKind::Path(_) | ExprKind::Argument(..) | ExprKind::Lost => {
                return None;
            }
        };
        Some(ExprSyntax { kind, extent: self.extent(expr.extent) })
    }

    fn extent(&self, extent: SpanRange) -> SpanRange {
        extent.within(self.instance)
    }

    /// Replaces in all entries of a list.
    fn all<T: Clone>(&self, entries: &[T], replace: impl Fn(&T) -> Option<T>) -> Option<Vec<T>> {
        let replaced: Vec<Option<T>> = entries.iter().map(replace).collect();
        if replaced.iter().all(Option::is_none) {
            return None;
        }
        let entries = entries.iter().zip(replaced);
        Some(entries.map(|(entry, replaced)| replaced.unwrap_or_else(|| entry.clone())).collect())
    }
}

/// The size of a formula with its arguments written out.
#[derive(Clone, Copy)]
pub(super) struct FormulaSize {
    /// The number of its nodes.
    nodes: usize,
    /// The length of its longest path from the root.
    depth: usize,
    /// Whether a number in it is lost, which is reported.
    pub is_lost: bool,
}

impl FormulaSize {
    /// The largest number of nodes of an argument.
    const MOST_NODES: usize = 1000;
    /// The largest depth of an argument: formulas are traversed by recursion.
    const DEEPEST: usize = 200;

    /// Returns the size of a number.
    pub fn of(expr: &ExprSyntax) -> Self {
        let is_lost = matches!(expr.kind, ExprKind::Lost);
        let leaf = FormulaSize { nodes: 1, depth: 1, is_lost };
        let of_all = |exprs: &mut dyn Iterator<Item = &ExprSyntax>| {
            exprs.map(FormulaSize::of).fold(leaf, FormulaSize::with)
        };
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Path(_) | ExprKind::Lost => leaf,
            ExprKind::Argument(_, inner) => leaf.with(FormulaSize::of(inner)),
            ExprKind::Parenthesized(inner)
            | ExprKind::Negated(inner)
            | ExprKind::Power(inner, _)
            | ExprKind::Quantity(inner, _) => leaf.with(FormulaSize::of(inner)),
            ExprKind::Sum(terms) => of_all(&mut terms.iter().map(|term| &term.expr)),
            ExprKind::Product(factors) => of_all(&mut factors.iter().map(|factor| &factor.expr)),
            ExprKind::Call(_, arguments) => of_all(&mut arguments.iter()),
        }
    }

    fn with(self, inner: FormulaSize) -> Self {
        FormulaSize {
            nodes: self.nodes + inner.nodes,
            depth: self.depth.max(inner.depth + 1),
            is_lost: self.is_lost || inner.is_lost,
        }
    }

    /// Returns whether a number is too large for an argument.
    pub fn is_too_large(self) -> bool {
        self.nodes > Self::MOST_NODES || self.depth > Self::DEEPEST
    }
}
