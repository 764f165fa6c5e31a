//! Indices that cannot be taken for one another, and the lists that they index.

use std::fmt;
use std::marker::PhantomData;
use std::ops::{Index, IndexMut, Range};

/// An index into a list of one kind of things.
pub trait Id: Copy + Ord {
    /// The one at this place.
    fn new(index: usize) -> Self;
    /// Its place.
    fn index(self) -> usize;
}

macro_rules! declare_id {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub usize);

        impl $name {
            /// Its place in the list.
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
    /// A link: a rigid part of the chain and the hinge that moves it.
    LinkId,
    /// A repeated part of the route.
    RepeatId,
    /// An input: something that the caller gives at every step.
    InputId,
    /// A load.
    LoadId,
}

/// A list that is indexed by one type of indices only.
#[derive(Clone, PartialEq, Eq)]
pub struct IdVec<I, T> {
    values: Vec<T>,
    ids: PhantomData<fn() -> I>,
}

impl<I: Id, T> IdVec<I, T> {
    /// An empty list.
    pub fn new() -> Self {
        IdVec { values: Vec::new(), ids: PhantomData }
    }

    /// A list of `count` equal values.
    pub fn filled(value: T, count: usize) -> Self
    where
        T: Clone,
    {
        vec![value; count].into()
    }

    /// How many values it holds.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether it holds none.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Appends a value; its index.
    pub fn push(&mut self, value: T) -> I {
        self.values.push(value);
        I::new(self.values.len() - 1)
    }

    /// Takes out the last value.
    pub fn pop(&mut self) -> Option<T> {
        self.values.pop()
    }

    /// All indices, in their order.
    pub fn ids(&self) -> IdRange<I> {
        (0..self.values.len()).into()
    }

    /// All values, in their order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// All values, in their order, to be changed.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.values.iter_mut()
    }

    /// All values with their indices.
    pub fn enumerate(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + Clone {
        self.values.iter().enumerate().map(|(index, value)| (I::new(index), value))
    }

    /// The index of the first value that is meant.
    pub fn position(&self, is_meant: impl FnMut(&T) -> bool) -> Option<I> {
        self.values.iter().position(is_meant).map(I::new)
    }

    /// The values alone.
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }
}

/// Indices that follow on each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IdRange<I> {
    start: usize,
    end: usize,
    ids: PhantomData<fn() -> I>,
}

impl<I: Id> IdRange<I> {
    /// How many they are.
    pub fn len(self) -> usize {
        self.end - self.start
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.start >= self.end
    }

    /// The first one of a range that is not empty.
    pub fn first(self) -> I {
        self.into_iter().next().unwrap_or_else(|| bug!("a range without an index has no first one"))
    }

    /// The last one of a range that is not empty.
    pub fn last(self) -> I {
        let last = self.into_iter().next_back();
        last.unwrap_or_else(|| bug!("a range without an index has no last one"))
    }

    /// Whether an index is among them.
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
