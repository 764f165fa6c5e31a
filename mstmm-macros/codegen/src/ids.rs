//! Typed indices, and the lists that they index.

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut, Range};

/// A typed index: indices of different lists have different types.
pub trait Id: Copy + Ord {
    /// Returns the id of this index.
    fn new(index: usize) -> Self;
    /// Returns the index.
    fn index(self) -> usize;
}

/// Returns a list of `count` copies of a value.
///
/// It copies memory, where `vec!` clones entry by entry: macros are built unoptimised, and tables of all nodes are large.
pub fn copies<T: Copy>(value: T, count: usize) -> Vec<T> {
    [value].repeat(count)
}

macro_rules! declare_id {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub usize);

        impl $name {
            /// Returns the index into the list.
            pub const fn index(self) -> usize {
                self.0
            }
        }

        impl $crate::ids::Id for $name {
            fn new(index: usize) -> Self {
                $name(index)
            }

            fn index(self) -> usize {
                self.0
            }
        }
    )*};
}

pub(crate) use declare_id;

declare_id! {
    /// A body of the model.
    BodyId,
    /// A hinge of the model.
    HingeId,
    /// A link: a rigid part of the chain with its inboard hinge.
    LinkId,
    /// A repeated part of a route.
    RepeatId,
    /// A way along which values pass from one repetition of a part to the next. The first one is the route.
    ChannelId,
    /// A connection point of the model.
    PointId,
    /// An input: a quantity that the caller supplies at every step.
    InputId,
    /// A load.
    LoadId,
    /// A spring.
    SpringId,
    /// A parameter of the model.
    ParameterId,
    /// A symbol of the graph: an unknown of a chain's functions, or a loop-carried value.
    SymbolId,
}

/// A vector that is indexed by one type of id.
#[derive(Clone, PartialEq, Eq)]
pub struct IdVec<I, T> {
    values: Vec<T>,
    ids: PhantomData<fn() -> I>,
}

impl<I: Id, T> IdVec<I, T> {
    /// Returns an empty list.
    pub fn new() -> Self {
        IdVec { values: Vec::new(), ids: PhantomData }
    }

    /// Returns a list of `count` copies of a value.
    pub fn filled(value: T, count: usize) -> Self
    where
        T: Clone,
    {
        vec![value; count].into()
    }

    /// Returns the number of values.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Returns whether the list is empty.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Appends a value and returns its id.
    pub fn push(&mut self, value: T) -> I {
        self.values.push(value);
        I::new(self.values.len() - 1)
    }

    /// Removes and returns the last value.
    pub fn pop(&mut self) -> Option<T> {
        self.values.pop()
    }

    /// Returns all ids in order.
    pub fn ids(&self) -> IdRange<I> {
        (0..self.values.len()).into()
    }

    /// Iterates over the values.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// Iterates over mutable references to the values.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.values.iter_mut()
    }

    /// Iterates over the values with their ids.
    pub fn enumerate(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + Clone {
        self.values.iter().enumerate().map(|(index, value)| (I::new(index), value))
    }

    /// Returns the id of the first value that satisfies a predicate.
    pub fn position(&self, predicate: impl FnMut(&T) -> bool) -> Option<I> {
        self.values.iter().position(predicate).map(I::new)
    }

    /// Returns the values as a slice.
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }
}

/// A range of consecutive ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IdRange<I> {
    start: usize,
    end: usize,
    ids: PhantomData<fn() -> I>,
}

impl<I: Id> IdRange<I> {
    /// Returns the number of ids.
    pub fn len(self) -> usize {
        self.end - self.start
    }

    /// Returns whether the range is empty.
    pub fn is_empty(self) -> bool {
        self.start >= self.end
    }

    /// Returns the first id of a range that is not empty.
    pub fn first(self) -> I {
        self.into_iter().next().unwrap_or_else(|| bug!("an empty range has no first id"))
    }

    /// Returns the last id of a range that is not empty.
    pub fn last(self) -> I {
        let last = self.into_iter().next_back();
        last.unwrap_or_else(|| bug!("an empty range has no last id"))
    }

    /// Returns the range of indices.
    pub fn indices(self) -> Range<usize> {
        self.start..self.end
    }

    /// Returns whether the range contains an id.
    pub fn contains(self, id: I) -> bool {
        (self.start..self.end).contains(&id.index())
    }
}

impl<I> From<Range<usize>> for IdRange<I> {
    fn from(Range { start, end }: Range<usize>) -> Self {
        IdRange { start, end, ids: PhantomData }
    }
}

impl<I: Id> IntoIterator for IdRange<I> {
    type Item = I;
    type IntoIter = std::iter::Map<Range<usize>, fn(usize) -> I>;

    fn into_iter(self) -> Self::IntoIter {
        (self.start..self.end).map(I::new)
    }
}

impl<I, T> From<Vec<T>> for IdVec<I, T> {
    fn from(values: Vec<T>) -> Self {
        IdVec { values, ids: PhantomData }
    }
}

impl<I, T> FromIterator<T> for IdVec<I, T> {
    fn from_iter<A: IntoIterator<Item = T>>(values: A) -> Self {
        Vec::from_iter(values).into()
    }
}

impl<I, T> Extend<T> for IdVec<I, T> {
    fn extend<A: IntoIterator<Item = T>>(&mut self, values: A) {
        self.values.extend(values);
    }
}

impl<I: Id, T> Default for IdVec<I, T> {
    fn default() -> Self {
        IdVec::new()
    }
}

impl<I: Id, T> Index<I> for IdVec<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        &self.values[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for IdVec<I, T> {
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.values[id.index()]
    }
}

impl<'a, I, T> IntoIterator for &'a IdVec<I, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.iter()
    }
}

impl<'a, I, T> IntoIterator for &'a mut IdVec<I, T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.iter_mut()
    }
}

impl<I, T> IntoIterator for IdVec<I, T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.into_iter()
    }
}

impl<I, T: fmt::Debug> fmt::Debug for IdVec<I, T> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        self.values.fmt(out)
    }
}
