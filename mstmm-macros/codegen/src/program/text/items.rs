//! The statements of the readable text: each sine and cosine is computed where it is first read.

use crate::program::{Block, Operand, Operation, Section, Statement, ValueId};
use std::rc::Rc;

/// The items under one heading.
pub struct ItemSection {
    /// The prefix of the names of unnamed values.
    pub prefix: Rc<str>,
    /// The title: what is computed.
    pub title: Rc<str>,
    /// The source of the equations.
    pub source: Rc<str>,
    /// The items.
    pub items: Vec<Item>,
}

/// A statement of the readable text.
pub enum Item {
    /// Defines one value.
    Let(ValueId, Operation),
    /// Defines sine and cosine of an angle, if they are used.
    Angle {
        /// The sine.
        sine: Option<ValueId>,
        /// The cosine.
        cosine: Option<ValueId>,
        /// The angle.
        angle: Operand,
    },
}

impl Item {
    /// Returns the values that it defines.
    pub fn names(&self) -> [Option<ValueId>; 2] {
        match self {
            Item::Let(name, _) => [Some(*name), None],
            Item::Angle { sine, cosine, .. } => [*sine, *cosine],
        }
    }

    /// Iterates over its operands.
    pub fn operands(&self) -> impl Iterator<Item = &Operand> {
        let all = match self {
            Item::Let(_, operation) => operation.operands(),
            Item::Angle { angle, .. } => [Some(angle), None, None],
        };
        all.into_iter().flatten()
    }

    fn reads_any(&self, names: [Option<ValueId>; 2]) -> bool {
        self.operands().filter_map(Operand::value).any(|name| names.contains(&Some(name)))
    }
}

/// Returns the items of a block, by section.
pub fn items(block: &Block) -> Vec<ItemSection> {
    let mut angles = Vec::new();
    let mut all: Vec<ItemSection> = Vec::new();
    for (number, section) in block.sections().iter().enumerate() {
        let Section { prefix, title, source, statements } = section;
        let [prefix, title, source] = [prefix, title, source].map(Rc::clone);
        let mut items = Vec::new();
        for statement in statements {
            match statement {
                Statement::Let(name, operation) => items.push(Item::Let(*name, *operation)),
                Statement::SinCos { sines, cosines, angles: of } => {
                    let both = sines.iter().zip(cosines).zip(of);
                    angles.extend(both.map(|((&sine, &cosine), angle)| {
                        (number, items.len(), Item::Angle { sine, cosine, angle: *angle })
                    }));
                }
                Statement::Pack { .. } | Statement::Lane { .. } => {
                    bug!("a program has no packs")
                }
            }
        }
        all.push(ItemSection { prefix, title, source, items });
    }
    // From the last to the first, so that earlier positions stay valid.
    for (section, place, angle) in angles.into_iter().rev() {
        let (section, place) = first_reader(&all, &angle).unwrap_or((section, place));
        all[section].items.insert(place, angle);
    }
    all
}

/// Returns section and position of the first item that reads a sine or a cosine.
fn first_reader(sections: &[ItemSection], angle: &Item) -> Option<(usize, usize)> {
    sections.iter().enumerate().find_map(|(number, section)| {
        let reads = |item: &Item| item.reads_any(angle.names());
        section.items.iter().position(reads).map(|place| (number, place))
    })
}
