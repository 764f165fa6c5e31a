//! List scheduling by critical paths: runs each statement as late as its users allow.
//!
//! A recursion over a chain is one long dependency path. A processor looks a few hundred instructions ahead for
//! independent operations; this pass moves such operations into that window. It schedules backwards from the end, for a
//! processor that starts sixteen operations in seven cycles, so that values are computed no earlier than necessary and
//! register pressure stays low. The order of the equations is kept if there is enough independent work at all times, if
//! no path is long, and in loops, where consecutive repetitions overlap.
//!
//! It saves 14 % of the time for seven crossed pins, 9 % for three balls and 5 % for the Panda (`benches/README.md`).

use super::latency::of_statement;
use crate::ids::copies;
use crate::program::{Block, Program, Section, Statement};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// The number of operations that start in [`CYCLES`] cycles: multiplications have two units, additions have others.
/// Schedules for more operations need more registers than there are: with five in two cycles, the accelerations of three balls
/// take 1 % more time on Zen 4, and 2 % more in `f64x8`.
const OPERATIONS: u32 = 16;
const CYCLES: u32 = 7;

/// There is enough independent work if all operations together take this many times as long as the longest path.
const ENOUGH: f64 = 1.3;

/// The length in cycles up to which a path is short: 100 operations start in this time, and a processor overlaps so many
/// without help. If all paths are short, as in coordinate rates, scheduling only increases register pressure: with it,
/// three balls would need 1.8 % more instructions in `f32` on a Cortex-M4.
const SHORT: u32 = 40;

/// Reorders the statements of a program. A section whose statements are separated becomes several sections with the same
/// heading.
pub fn list_schedule(mut program: Program) -> Program {
    for block in &mut program.blocks {
        if let Block::Once(sections) = block
            && let Some(order) = new_order(sections, program.names.count())
        {
            *sections = reordered(std::mem::take(sections), &order);
        }
    }
    program
}

/// Returns the indices of a block's statements in their new order, if there is too little independent work; `names` is the
/// number of the program's values.
fn new_order(sections: &[Section], names: usize) -> Option<Vec<usize>> {
    let statements: Vec<&Statement> =
        sections.iter().flat_map(|section| &section.statements).collect();
    let dependencies = Dependencies::of(&statements, names);
    let depths = dependencies.depths();
    dependencies.wait(&depths).then(|| dependencies.order(&depths))
}

/// Returns the sections of a block in this order of statements.
fn reordered(sections: Vec<Section>, order: &[usize]) -> Vec<Section> {
    let owners = sections.iter().enumerate();
    let owners =
        owners.flat_map(|(number, section)| section.statements.iter().map(move |_| number));
    let owners: Vec<usize> = owners.collect();
    let headings: Vec<Section> = sections.iter().map(Section::without_statements).collect();
    let statements = sections.into_iter().flat_map(|section| section.statements);
    let mut statements: Vec<Option<Statement>> = statements.map(Some).collect();
    let mut ordered: Vec<Section> = Vec::new();
    let mut current = None;
    for &number in order {
        let owner = owners[number];
        if current.replace(owner) != Some(owner) {
            ordered.push(headings[owner].clone());
        }
        if let Some(section) = ordered.last_mut() {
            section.statements.extend(statements[number].take());
        }
    }
    ordered
}

/// The dependencies between statements, by index.
struct Dependencies {
    /// The statements that compute the operands of the first statement, of the second, and so on.
    makers: Vec<usize>,
    /// The end of each statement's part of `makers`.
    ends: Vec<usize>,
    /// The number of statements that use its values.
    users: Vec<usize>,
    latencies: Vec<u32>,
}

impl Dependencies {
    fn of(statements: &[&Statement], names: usize) -> Self {
        let mut maker_of = copies(None, names);
        for (number, statement) in statements.iter().enumerate() {
            for name in statement.defined() {
                maker_of[name.index()] = Some(number);
            }
        }
        let mut users = vec![0; statements.len()];
        let (mut makers, mut ends) = (Vec::new(), Vec::with_capacity(statements.len()));
        for statement in statements {
            let start = makers.len();
            for operand in statement.operands() {
                let maker = operand.value().and_then(|value| maker_of[value.index()]);
                if let Some(maker) = maker
                    && !makers[start..].contains(&maker)
                {
                    makers.push(maker);
                    users[maker] += 1;
                }
            }
            ends.push(makers.len());
        }
        let latencies = statements.iter().map(|statement| of_statement(statement)).collect();
        Dependencies { makers, ends, users, latencies }
    }

    /// Returns the range of a statement's makers in `makers`.
    fn range(&self, statement: usize) -> Range<usize> {
        let start = statement.checked_sub(1).map_or(0, |previous| self.ends[previous]);
        start..self.ends[statement]
    }

    /// Returns, for each statement, the latency of the longest path that leads to it, in cycles.
    fn depths(&self) -> Vec<u32> {
        let mut depths: Vec<u32> = Vec::with_capacity(self.latencies.len());
        // Statements come before their users.
        for statement in 0..self.ends.len() {
            let end = |&maker: &usize| depths[maker] + self.latencies[maker];
            let depth = self.makers[self.range(statement)].iter().map(end).max();
            depths.push(depth.unwrap_or(0));
        }
        depths
    }

    /// Returns whether a path is long and there is too little independent work for statements of these depths.
    fn wait(&self, depths: &[u32]) -> bool {
        let ends = depths.iter().zip(&self.latencies).map(|(depth, latency)| depth + latency);
        let longest = ends.max().unwrap_or(0);
        let room = f64::from(longest * OPERATIONS) / f64::from(CYCLES);
        longest > SHORT && depths.len() as f64 <= ENOUGH * room
    }

    /// Returns the indices of the statements in their new order.
    fn order(mut self, depths: &[u32]) -> Vec<usize> {
        let count = depths.len();
        let (mut order, mut done_before) = (Vec::with_capacity(count), vec![0; count]);
        // Time runs backwards from the end. `coming` has the statements whose users have all started, by the time at which
        // they may run; `ready` has those that may run now. Of two statements of the same depth the later one in the
        // original order runs last. The unit of time is a cycle divided by `OPERATIONS`; an operation takes `CYCLES` units.
        let mut coming: BinaryHeap<(Reverse<u32>, usize)> = BinaryHeap::new();
        let mut ready: BinaryHeap<(u32, usize)> = BinaryHeap::new();
        let parts = |latency: u32| OPERATIONS * latency;
        let last = (0..count).filter(|&n| self.users[n] == 0);
        coming.extend(last.map(|n| (Reverse(parts(self.latencies[n])), n)));
        let mut now = 0;
        loop {
            while let Some(&(Reverse(time), number)) = coming.peek()
                && time <= now
            {
                coming.pop();
                ready.push((depths[number], number));
            }
            let Some((_, number)) = ready.pop() else {
                let Some(&(Reverse(time), _)) = coming.peek() else { break };
                now = time;
                continue;
            };
            order.push(number);
            for maker in self.range(number).map(|index| self.makers[index]) {
                done_before[maker] = done_before[maker].max(now + parts(self.latencies[maker]));
                self.users[maker] -= 1;
                if self.users[maker] == 0 {
                    coming.push((Reverse(done_before[maker]), maker));
                }
            }
            now += CYCLES;
        }
        order.reverse();
        order
    }
}

#[cfg(test)]
mod tests {
    use super::{new_order, reordered};
    use crate::program::{Operand, Operation, Section, Statement, ValueId, ValueNames};

    fn section(title: &str, statements: Vec<Statement>) -> Section {
        Section { title: title.into(), statements, ..Section::default() }
    }

    fn root(name: ValueId, of: Operand) -> Statement {
        Statement::Let(name, Operation::Sqrt(of))
    }

    /// Adds values with numbered names.
    fn values<const N: usize>(names: &mut ValueNames, letter: &str) -> [ValueId; N] {
        std::array::from_fn(|number| names.add(format!("{letter}{number}")))
    }

    #[test]
    fn independent_work_fills_the_gaps_of_the_longest_path() {
        let mut names = ValueNames::default();
        let [a, b] = values(&mut names, "path");
        let (fill, end): ([ValueId; 6], [ValueId; 6]) =
            (values(&mut names, "f"), values(&mut names, "g"));
        let unknowns: [ValueId; 10] = values(&mut names, "x");
        let unknown = |k: usize| Operand::Value(unknowns[k]);
        let filling = |k: usize| Operation::Sum(unknown(k), unknown(9));
        let ending = |k: usize| Operation::Sum(Operand::Value(fill[k]), Operand::Value(b));
        let filling = (0..6).map(|k| Statement::Let(fill[k], filling(k))).collect();
        let path = vec![root(a, unknown(0)), root(b, Operand::Value(a))];
        let ending = (0..6).map(|k| Statement::Let(end[k], ending(k))).collect();
        let given = vec![section("fill", filling), section("path", path), section("end", ending)];
        let order = new_order(&given, names.count()).expect("it waits");
        let ordered = reordered(given, &order);
        let titles: Vec<&str> = ordered.iter().map(|section| &section.title[..]).collect();
        assert_eq!(titles, ["path", "fill", "end"]);
        let statements = ordered.iter().flat_map(|section| &section.statements);
        let made: Vec<ValueId> = statements.flat_map(Statement::defined).collect();
        assert_eq!(made, [&[a, b], &fill[..], &end[..]].concat());
    }

    /// Returns the new order of sums and of a path of square roots that begins at the last sum.
    fn order_of(sums: usize, roots: usize) -> Option<Vec<usize>> {
        let mut names = ValueNames::default();
        let mut value = |letter: &str, number: usize| names.add(format!("{letter}{number}"));
        let mut last = Operand::Number(0.0);
        let mut sum = |number: usize| {
            let (name, unknown) = (value("f", number), Operand::Value(value("x", number)));
            last = Operand::Value(name);
            Statement::Let(name, Operation::Sum(unknown, unknown))
        };
        let sums = (0..sums).map(&mut sum).collect();
        let mut path = Vec::new();
        for number in 0..roots {
            let name = value("path", number);
            path.push(root(name, std::mem::replace(&mut last, Operand::Value(name))));
        }
        new_order(&[section("sums", sums), section("path", path)], names.count())
    }

    #[test]
    fn the_order_is_kept_if_there_is_enough_work() {
        assert_ne!(order_of(100, 2), None);
        assert_eq!(order_of(200, 2), None);
    }

    #[test]
    fn the_order_is_kept_if_no_path_is_long() {
        assert_ne!(order_of(10, 2), None);
        assert_eq!(order_of(10, 1), None);
    }
}
