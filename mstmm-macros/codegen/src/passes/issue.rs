//! The order in which statements run: those first from which most is still to come.
//!
//! A recursion over a chain is one long path on which every operation waits for the one before. A
//! processor looks a few hundred instructions ahead for others that it may do meanwhile; here they are
//! put where it finds them. That is list scheduling by critical paths, for a processor that starts five
//! operations in two cycles. Where there is work enough at any time, the order of the equations
//! stays, in which fewer values have to be kept; and so it does in loops, each time of which gives the
//! next one work.

use super::latency::of_statement;
use crate::program::{Block, Operand, Program, Section, Statement};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// So many operations are started in [`CYCLES`], for multiplications have two units and additions others
/// beside. Orders for more need more registers than there are.
const OPERATIONS: u32 = 5;
const CYCLES: u32 = 2;

/// There is work enough if all operations take so many times as long as the longest path.
const ENOUGH: f64 = 1.2;

/// The same program with its statements in the order in which they should run. A section that others
/// interrupt falls into several of the same heading.
pub fn issue(mut program: Program) -> Program {
    for block in &mut program.blocks {
        if let Block::Once(sections) = block {
            *sections = issued(std::mem::take(sections));
        }
    }
    program
}

/// The sections of a block.
fn issued(sections: Vec<Section>) -> Vec<Section> {
    let owners = sections.iter().enumerate();
    let owners =
        owners.flat_map(|(number, section)| section.statements.iter().map(move |_| number));
    let owners: Vec<usize> = owners.collect();
    let statements: Vec<&Statement> =
        sections.iter().flat_map(|section| &section.statements).collect();
    let dependencies = Dependencies::of(&statements);
    let heights = dependencies.heights();
    let longest = heights.iter().max().copied().unwrap_or(0);
    let room = f64::from(longest * OPERATIONS) / f64::from(CYCLES);
    if statements.len() as f64 > ENOUGH * room {
        return sections;
    }
    let order = dependencies.order(&heights);
    let headings: Vec<(String, String)> =
        sections.iter().map(|section| (section.title.clone(), section.source.clone())).collect();
    let statements = sections.into_iter().flat_map(|section| section.statements);
    let mut statements: Vec<Option<Statement>> = statements.map(Some).collect();
    let mut ordered: Vec<Section> = Vec::new();
    let mut current = None;
    for number in order {
        let owner = owners[number];
        if current.replace(owner) != Some(owner) {
            let (title, source) = headings[owner].clone();
            ordered.push(Section { title, source, statements: Vec::new() });
        }
        if let Some(section) = ordered.last_mut() {
            section.statements.extend(statements[number].take());
        }
    }
    ordered
}

/// Which statements wait for which, by their numbers.
struct Dependencies {
    /// How many others a statement waits for.
    missing: Vec<usize>,
    users: Vec<Vec<usize>>,
    latencies: Vec<u32>,
}

impl Dependencies {
    fn of(statements: &[&Statement]) -> Self {
        let mut makers: HashMap<&str, usize> = HashMap::new();
        for (number, statement) in statements.iter().enumerate() {
            makers.extend(statement.names().map(|name| (name, number)));
        }
        let mut missing = vec![0; statements.len()];
        let mut users = vec![Vec::new(); statements.len()];
        for (number, statement) in statements.iter().enumerate() {
            let names = statement.operands().filter_map(Operand::name);
            let mut read: Vec<usize> = names.filter_map(|name| makers.get(name).copied()).collect();
            read.sort_unstable();
            read.dedup();
            missing[number] = read.len();
            read.into_iter().for_each(|maker| users[maker].push(number));
        }
        let latencies = statements.iter().map(|statement| of_statement(statement)).collect();
        Dependencies { missing, users, latencies }
    }

    /// How many cycles the longest path takes from a statement to the end, itself included.
    fn heights(&self) -> Vec<u32> {
        let mut heights = self.latencies.clone();
        // Statements stand before their users.
        for number in (0..heights.len()).rev() {
            let beyond = self.users[number].iter().map(|&user| heights[user]).max();
            heights[number] += beyond.unwrap_or(0);
        }
        heights
    }

    /// The numbers of the statements in the order in which they should run.
    fn order(mut self, heights: &[u32]) -> Vec<usize> {
        let count = heights.len();
        let (mut order, mut ready_at) = (Vec::with_capacity(count), vec![0; count]);
        // What has its operands at some time, and what has them now; of two of the same height the
        // one that stands first runs first. Time is in parts of cycles, of which an operation takes
        // `CYCLES` and a cycle has `OPERATIONS`.
        let mut coming: BinaryHeap<Reverse<(u32, usize)>> = BinaryHeap::new();
        let mut ready: BinaryHeap<(u32, Reverse<usize>)> = BinaryHeap::new();
        coming.extend((0..count).filter(|&n| self.missing[n] == 0).map(|n| Reverse((0, n))));
        let mut now = 0;
        loop {
            while let Some(&Reverse((time, number))) = coming.peek()
                && time <= now
            {
                coming.pop();
                ready.push((heights[number], Reverse(number)));
            }
            let Some((_, Reverse(number))) = ready.pop() else {
                let Some(&Reverse((time, _))) = coming.peek() else { return order };
                now = time;
                continue;
            };
            order.push(number);
            for &user in &self.users[number] {
                ready_at[user] = ready_at[user].max(now + OPERATIONS * self.latencies[number]);
                self.missing[user] -= 1;
                if self.missing[user] == 0 {
                    coming.push(Reverse((ready_at[user], user)));
                }
            }
            now += CYCLES;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::issued;
    use crate::program::{Operand, Operation, Section, Statement};

    fn section(title: &str, statements: Vec<Statement>) -> Section {
        Section { title: title.into(), source: String::new(), statements }
    }

    fn named(name: &str) -> Operand {
        Operand::Named(name.into())
    }

    fn reciprocal(name: &str, of: &str) -> Statement {
        Statement::Let(name.into(), Operation::Recip(named(of)))
    }

    #[test]
    fn the_longest_path_comes_first_and_the_rest_fills_its_gaps() {
        let fill = (0..8).map(|k| {
            Statement::Let(format!("f{k}"), Operation::Sum(Operand::Symbol(k), Operand::Symbol(9)))
        });
        let path = vec![reciprocal("a", "x"), reciprocal("b", "a"), reciprocal("c", "b")];
        let ordered = issued(vec![section("fill", fill.collect()), section("path", path)]);
        let titles: Vec<&str> = ordered.iter().map(|section| &section.title[..]).collect();
        assert_eq!(titles, ["path", "fill", "path"]);
        let names: Vec<&str> = ordered
            .iter()
            .flat_map(|section| &section.statements)
            .flat_map(Statement::names)
            .collect();
        assert_eq!(names, ["a", "f0", "f1", "f2", "f3", "f4", "f5", "f6", "f7", "b", "c"]);
    }

    #[test]
    fn where_there_is_work_enough_the_order_stays() {
        let sums = (0..100).map(|k| {
            Statement::Let(format!("f{k}"), Operation::Sum(Operand::Symbol(k), Operand::Symbol(k)))
        });
        let sections =
            vec![section("sums", sums.collect()), section("end", vec![reciprocal("a", "f99")])];
        assert_eq!(issued(sections.clone()), sections);
    }
}
