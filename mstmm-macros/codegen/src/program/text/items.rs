//! Statements for people: sines and cosines are computed where they are read first.

use crate::program::{Block, Operand, Operation, Section, Statement, ValueId};

/// Items under one heading.
pub struct ItemSection {
    /// What names of values begin with that have none of their own.
    pub prefix: String,
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// The items.
    pub items: Vec<Item>,
}

/// A statement.
pub enum Item {
    /// A value.
    Let(ValueId, Operation),
    /// Sine and cosine of an angle, as far as they are read.
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
    /// The values that it computes.
    pub fn names(&self) -> [Option<ValueId>; 2] {
        match self {
            Item::Let(name, _) => [Some(*name), None],
            Item::Angle { sine, cosine, .. } => [*sine, *cosine],
        }
    }

    /// What it reads.
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

/// The items of a block.
pub fn items(block: &Block) -> Vec<ItemSection> {
    let sections = match block {
        Block::Once(sections) => sections,
        Block::Loop(one) => &one.sections,
    };
    let mut angles = Vec::new();
    let mut all: Vec<ItemSection> = Vec::new();
    for (number, section) in sections.iter().enumerate() {
        let Section { prefix, title, source, statements } = section;
        let [prefix, title, source] = [prefix, title, source].map(String::clone);
        let mut items = Vec::new();
        for statement in statements {
            match statement {
                Statement::Let(name, operation) => items.push(Item::Let(*name, operation.clone())),
                Statement::SinCos { sines, cosines, angles: of } => {
                    let both = sines.iter().zip(cosines).zip(of);
                    angles.extend(both.map(|((&sine, &cosine), angle)| {
                        (number, items.len(), Item::Angle { sine, cosine, angle: angle.clone() })
                    }));
                }
            }
        }
        all.push(ItemSection { prefix, title, source, items });
    }
    // The last first: the places of those before stay what they are.
    for (section, place, angle) in angles.into_iter().rev() {
        let (section, place) = first_reader(&all, &angle).unwrap_or((section, place));
        all[section].items.insert(place, angle);
    }
    all
}

/// Section and place of the first item that reads a sine or a cosine.
fn first_reader(sections: &[ItemSection], angle: &Item) -> Option<(usize, usize)> {
    sections.iter().enumerate().find_map(|(number, section)| {
        let reads = |item: &Item| item.reads_any(angle.names());
        section.items.iter().position(reads).map(|place| (number, place))
    })
}
