//! Finds the readers of values, and names the values.

use super::items::ItemSection;
use crate::program::{Block, BlockId, CarriedValue, Operand, Program, ValueId};
use std::collections::{HashMap, HashSet};

/// The prefix of values that only results need.
pub const RESULT: &str = "result";

/// A place where a value is computed or read.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Site<'a> {
    block: usize,
    /// The prefix of the section.
    prefix: &'a str,
}

/// The site where a value is computed, if a statement computes it, and the sites where it is read; a read by a
/// loop-carried value has no site.
#[derive(Clone, Default)]
struct Use<'a> {
    owner: Option<Site<'a>>,
    readers: Vec<Option<Site<'a>>>,
}

/// The uses of a program's values, by value.
pub struct Uses<'a>(Vec<Use<'a>>);

impl<'a> Uses<'a> {
    /// Finds the uses in a program whose blocks have these sections.
    pub fn of(program: &Program, blocks: &'a [Vec<ItemSection>]) -> Self {
        let mut uses = Uses(vec![Use::default(); program.names.count()]);
        for (block, sections) in blocks.iter().enumerate() {
            for section in sections {
                let at = Site { block, prefix: &section.prefix };
                for item in &section.items {
                    item.operands().for_each(|operand| uses.read(operand, Some(at)));
                    let names = item.names().into_iter().flatten();
                    names.for_each(|name| uses.0[name.index()].owner = Some(at));
                }
            }
            if let Block::Loop(loop_) = &program.blocks[BlockId(block)] {
                let at = Site { block, prefix: RESULT };
                loop_.results.iter().for_each(|(_, result)| uses.read(result, Some(at)));
                let tested = loop_.pivots.iter().flat_map(|(_, value, scale)| [value, scale]);
                tested.for_each(|operand| uses.read(operand, Some(at)));
                let carried = loop_.carries.iter().flat_map(|carry| [&carry.init, &carry.next]);
                carried.for_each(|operand| uses.read(operand, None));
            }
        }
        let last = Site { block: blocks.len().saturating_sub(1), prefix: RESULT };
        program.results.iter().flatten().for_each(|result| uses.read(result, Some(last)));
        let tested = program.pivots.iter().flatten().flat_map(|(value, scale)| [value, scale]);
        tested.for_each(|operand| uses.read(operand, Some(last)));
        uses
    }

    fn read(&mut self, operand: &Operand, at: Option<Site<'a>>) {
        if let Some(name) = operand.value() {
            self.0[name.index()].readers.push(at);
        }
    }

    /// Returns whether a value is read once, at the site where it is computed.
    pub fn is_once(&self, name: ValueId) -> bool {
        let Use { owner, readers } = &self.0[name.index()];
        readers[..] == [*owner] && owner.is_some()
    }

    /// Returns the prefix of the section that computes a value, if other sections read it.
    fn shared_by(&self, name: ValueId) -> Option<&'a str> {
        let Use { owner, readers } = &self.0[name.index()];
        let own = (*owner)?.prefix;
        let is_own = |reader: &Option<Site>| reader.is_some_and(|at| at.prefix == own);
        (!readers.iter().all(is_own)).then_some(own)
    }

    /// Returns the names of values: their own name, or a number after the prefix of their section if other sections read
    /// them. Other unnamed values get their number when they are written.
    pub fn names(&self, program: &Program, blocks: &[Vec<ItemSection>]) -> Vec<Option<String>> {
        let all = program.names.all().iter().cloned();
        let mut names: Vec<Option<String>> = all.map(Some).collect();
        let mut counts: HashMap<&str, usize> = HashMap::new();
        let items = blocks.iter().flatten().flat_map(|section| &section.items);
        for name in items.flat_map(|item| item.names()).flatten() {
            if !program.names.is_numbered(name) {
                continue;
            }
            names[name.index()] = self.shared_by(name).map(|prefix| {
                let count = counts.entry(prefix).or_default();
                *count += 1;
                format!("{prefix}_x{count}")
            });
        }
        name_carries(program, &mut names);
        names
    }
}

/// Names loop-carried values after their values at the end of a repetition.
fn name_carries(program: &Program, names: &mut [Option<String>]) {
    let carries: Vec<&CarriedValue> = program.loops().flat_map(|loop_| &loop_.carries).collect();
    let is_carried =
        |name: &ValueId| carries.iter().any(|carry| [carry.exit, carry.phi].contains(name));
    let mut taken: HashSet<String> = names.iter().flatten().cloned().collect();
    for carry in &carries {
        let next = carry.next.value().filter(|name| !is_carried(name));
        let next = next.and_then(|name| names[name.index()].clone());
        let base = next.map_or("carried".to_owned(), |next| format!("{next}_carried"));
        let numbered = (2..).map(|number| format!("{base}{number}"));
        let mut free = std::iter::once(base.clone()).chain(numbered);
        let text = free.find(|text| taken.insert(text.clone()));
        names[carry.phi.index()].clone_from(&text);
        names[carry.exit.index()] = text;
    }
}
