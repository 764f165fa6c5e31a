//! Runs programs on `f64`, loops included. Its sines, cosines and angles have the same bits on every machine.

use mstmm_codegen::math::Scalar;
use mstmm_codegen::program::{
    Block, Loop, Name, Operand, Operation, Program, Section, Slot, Statement,
};

/// What a program reads.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    /// Unknowns by number: one value each, or one for every repetition.
    pub symbols: Vec<Vec<f64>>,
    /// Values known since setup that stand once, by slot.
    pub slots: Vec<f64>,
    /// Those of repeated parts, by part and slot, one for every repetition.
    pub repeated_slots: Vec<Vec<Vec<f64>>>,
    /// How often each part stands there.
    pub repetitions: Vec<usize>,
    /// Whether a product and a sum are rounded once.
    pub fused: bool,
}

/// What a program computes, by group and place; what a loop computes has a value for every repetition.
pub type Results = Vec<Vec<Vec<f64>>>;

/// Runs a program.
pub fn run(program: &Program, arguments: &Arguments) -> Results {
    let empty = |group: &Vec<Operand>| vec![Vec::new(); group.len()];
    let mut machine = Machine {
        program,
        arguments,
        values: vec![None; program.names.count()],
        stored: vec![Vec::new(); program.blocks.len()],
        results: program.outputs.iter().map(empty).collect(),
        time: 0,
    };
    machine.read_slots(&program.slots, |slot| arguments.slots[slot.index]);
    for (number, block) in program.blocks.iter().enumerate() {
        match block {
            Block::Once(sections) => machine.sections(sections),
            Block::Loop(turn) => machine.turn(number, turn),
        }
    }
    for (group, outputs) in program.outputs.iter().enumerate() {
        for (place, output) in outputs.iter().enumerate() {
            if *output != Operand::Repeated {
                machine.results[group][place] = vec![machine.value(output)];
            }
        }
    }
    machine.results
}

struct Machine<'a> {
    program: &'a Program,
    arguments: &'a Arguments,
    /// Values by number, as far as they are known.
    values: Vec<Option<f64>>,
    /// What loops have stored, by block and repetition.
    stored: Vec<Vec<Vec<f64>>>,
    results: Results,
    /// The repetition that a loop is in.
    time: usize,
}

impl Machine<'_> {
    fn read_slots(&mut self, slots: &[Slot], value: impl Fn(&Slot) -> f64) {
        for slot in slots {
            self.set(slot.name, value(slot));
        }
    }

    fn set(&mut self, name: Name, value: f64) {
        self.values[name.index()] = Some(value);
    }

    fn sections(&mut self, sections: &[Section]) {
        for statement in sections.iter().flat_map(|section| &section.statements) {
            match statement {
                Statement::Let(name, operation) => {
                    let value = self.operation(operation);
                    self.set(*name, value);
                }
                Statement::SinCos { sines, cosines, angles } => {
                    for (k, angle) in angles.iter().enumerate() {
                        let angle = self.value(angle);
                        if let Some(name) = sines[k] {
                            self.set(name, libm::sin(angle));
                        }
                        if let Some(name) = cosines[k] {
                            self.set(name, libm::cos(angle));
                        }
                    }
                }
            }
        }
    }

    fn operation(&self, operation: &Operation) -> f64 {
        let value = |operand: &Operand| self.value(operand);
        let product_sum = |a: f64, b: f64, c: f64| match self.arguments.fused {
            true => libm::fma(a, b, c),
            false => a * b + c,
        };
        match operation {
            Operation::Sum(a, b) => value(a) + value(b),
            Operation::Difference(a, b) => value(a) - value(b),
            Operation::Product(a, b) => value(a) * value(b),
            Operation::MulAdd(a, b, c) => product_sum(value(a), value(b), value(c)),
            Operation::MulSub(a, b, c) => product_sum(value(a), value(b), -value(c)),
            Operation::MulNegAdd(a, b, c) => product_sum(-value(a), value(b), value(c)),
            Operation::Recip(a) => value(a).recip(),
            Operation::Sqrt(a) => value(a).sqrt(),
            Operation::CopySign(a, b) => value(a).copysign(value(b)),
            Operation::Atan2(a, b) => libm::atan2(value(a), value(b)),
            Operation::RecipAbove(a, b) => value(a).recip_above(value(b)),
        }
    }

    fn value(&self, operand: &Operand) -> f64 {
        match operand {
            Operand::Number(number) => *number,
            Operand::Symbol(number) => {
                let values = &self.arguments.symbols[*number as usize];
                if values.len() == 1 { values[0] } else { values[self.time] }
            }
            Operand::Named(name) => {
                let text = self.program.names.text(*name);
                self.values[name.index()].unwrap_or_else(|| panic!("`{text}` has no value"))
            }
            Operand::Minus(inner) => -self.value(inner),
            Operand::Repeated => panic!("it has as many values as there are repetitions"),
        }
    }

    fn turn(&mut self, block: usize, turn: &Loop) {
        let count = self.arguments.repetitions[turn.repeat.index()];
        self.stored[block] = vec![Vec::new(); count];
        for (group, place, _) in &turn.outputs {
            self.results[*group][*place] = vec![f64::NAN; count];
        }
        for carry in &turn.carries {
            let first = self.value(&carry.first);
            self.set(carry.name, first);
        }
        let times: Vec<usize> =
            if turn.inwards { (0..count).rev().collect() } else { (0..count).collect() };
        for time in times {
            self.time = time;
            self.repetition(block, turn);
        }
        self.time = 0;
    }

    fn repetition(&mut self, block: usize, turn: &Loop) {
        let (time, arguments) = (self.time, self.arguments);
        self.read_slots(&turn.slots, |slot| {
            arguments.repeated_slots[turn.repeat.index()][slot.index][time]
        });
        for (from, names) in &turn.loads {
            let Block::Loop(earlier) = &self.program.blocks[*from] else {
                panic!("only loops store values")
            };
            for name in names {
                let place = earlier.stores.iter().position(|stored| stored == name);
                let value = self.stored[*from][time][place.expect("a stored value")];
                self.set(*name, value);
            }
        }
        for carry in &turn.carries {
            let value = self.values[carry.name.index()];
            self.values[carry.entering.index()] = value;
        }
        self.sections(&turn.sections);
        for (group, place, operand) in &turn.outputs {
            self.results[*group][*place][time] = self.value(operand);
        }
        let stores = turn.stores.iter().map(|&name| self.value(&Operand::Named(name)));
        self.stored[block][time] = stores.collect();
        let next: Vec<f64> = turn.carries.iter().map(|carry| self.value(&carry.next)).collect();
        for (carry, next) in turn.carries.iter().zip(next) {
            self.set(carry.name, next);
        }
    }
}
