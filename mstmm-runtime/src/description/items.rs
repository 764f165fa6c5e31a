//! Lists of elements.

use core::ops::Deref;

use super::name::{Name, repetition_in};
use super::table::{Entry, Table};

/// Elements of a chain: hinges, bodies, springs or connection points. Each repetition is an element.
#[derive(Debug)]
pub struct Items<R: 'static>(Table<R>);

impl<R> Clone for Items<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Items<R> {}

/// An element of a chain. It dereferences to the properties that all repetitions have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Item<R: 'static> {
    name: Name,
    row: &'static R,
}

impl<R> Item<R> {
    /// Returns the name, such as `joint[12]`.
    #[must_use]
    pub fn name(&self) -> Name {
        self.name
    }
}

impl<R> Deref for Item<R> {
    type Target = R;

    fn deref(&self) -> &R {
        self.row
    }
}

/// A row of a table of elements.
pub trait Element {
    /// Returns the path.
    fn path(&self) -> &'static str;
}

impl<R> Items<R> {
    pub(super) const fn new(table: Table<R>) -> Self {
        Items(table)
    }

    /// Returns the number of elements.
    #[must_use]
    pub fn len(self) -> usize {
        self.0.len(|_| 1)
    }

    /// Returns whether there are no elements.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }
}

#[allow(private_bounds)]
impl<R: Element> Items<R> {
    /// Returns the element at an index.
    #[must_use]
    pub fn get(self, index: usize) -> Option<Item<R>> {
        let Entry { row, repetition, .. } = self.0.entry(index, |_| 1)?;
        Some(Item { name: Name::new(row.path(), repetition), row })
    }

    /// Returns the index of the element with this name.
    ///
    /// The time does not depend on the number of repetitions.
    #[must_use]
    pub fn index(self, name: &str) -> Option<usize> {
        let repetition = repetition_in(name)?;
        let mut rows = self.0.rows();
        let (number, _) = rows.find(|(_, row)| Name::new(row.path(), repetition) == *name)?;
        self.0.first_of(number, repetition, |_| 1)
    }

    /// Returns all elements in their order.
    pub fn iter(self) -> impl Iterator<Item = Item<R>> {
        (0..self.len()).map_while(move |index| self.get(index))
    }
}
