//! Stores results as soon as they are known.
//!
//! If all stores came last, the values of all connection points would be spilled and reloaded, which is a third of the
//! instructions then. Therefore no store waits for the check of the results; if the check fails, the results are reset.
//! This makes `solve_into` 10 % faster for a seven-hinge arm and 18 % faster for seven crossed pins.

use crate::program::{Operand, Procedure, Section, Statement, Step};

/// Moves stores and the check of results up to the point at which their operands are known. Applies to procedures without
/// loops that may leave results after a failure.
pub fn early_stores(mut procedure: Procedure) -> Procedure {
    let has_loops = procedure.body.iter().any(|step| matches!(step, Step::Loop(_)));
    if !procedure.failure.allows_early_stores() || has_loops {
        return procedure;
    }
    let last = procedure.body.iter().rposition(|step| matches!(step, Step::Compute(_)));
    let Some(last) = last else { return procedure };
    let mut final_steps = procedure.body.split_off(last + 1);
    // A check of stored results stays behind their stores.
    let checks_stored = |step: &mut Step| matches!(step, Step::CheckResults(check) if !check.unless_bounded.is_empty());
    let of_stored = final_steps.pop_if(checks_stored);
    let mut waiting = Waiting::new(procedure.values.count(), &procedure.body);
    let mut ready = Vec::new();
    for step in final_steps {
        ready.extend(waiting.add(step));
    }
    let steps = std::mem::take(&mut procedure.body);
    let first = steps.iter().position(|step| matches!(step, Step::Compute(_)));
    for (number, step) in steps.into_iter().enumerate() {
        if Some(number) == first {
            procedure.body.append(&mut ready);
        }
        match step {
            Step::Compute(section) => procedure.body.extend(waiting.split(section)),
            _ => procedure.body.push(step),
        }
    }
    procedure.body.extend(of_stored);
    procedure
}

/// The steps that wait for values.
struct Waiting {
    /// Whether a value is computed by the procedure.
    computed: Vec<bool>,
    /// The steps, each with the number of values that it still waits for.
    steps: Vec<(usize, Option<Step>)>,
    /// The steps that wait for a value.
    users: Vec<Vec<usize>>,
}

impl Waiting {
    fn new(values: usize, body: &[Step]) -> Self {
        let mut computed = vec![false; values];
        for step in body {
            if let Step::Compute(section) = step {
                let values = section.statements.iter().flat_map(Statement::defined);
                values.for_each(|value| computed[value.index()] = true);
            }
        }
        Waiting { computed, steps: Vec::new(), users: vec![Vec::new(); values] }
    }

    /// Adds a step, or returns it if it waits for nothing.
    fn add(&mut self, step: Step) -> Option<Step> {
        let mut needed: Vec<usize> = operands(&step)
            .into_iter()
            .filter_map(|operand| operand.value().map(|value| value.index()))
            .filter(|&value| self.computed[value])
            .collect();
        needed.sort_unstable();
        needed.dedup();
        if needed.is_empty() {
            return Some(step);
        }
        needed.iter().for_each(|&value| self.users[value].push(self.steps.len()));
        self.steps.push((needed.len(), Some(step)));
        None
    }

    /// Splits a section and puts each waiting step after the statement that computes its last operand.
    fn split(&mut self, section: Section) -> Vec<Step> {
        let heading = section.without_statements();
        let part = |statements| Section { statements, ..heading.clone() };
        let (mut steps, mut current) = (Vec::new(), Vec::new());
        for statement in section.statements {
            let ready = self.ready_after(&statement);
            current.push(statement);
            if !ready.is_empty() {
                steps.push(Step::Compute(part(std::mem::take(&mut current))));
                steps.extend(ready);
            }
        }
        if !current.is_empty() {
            steps.push(Step::Compute(part(current)));
        }
        steps
    }

    fn ready_after(&mut self, statement: &Statement) -> Vec<Step> {
        let mut ready = Vec::new();
        for value in statement.defined() {
            for number in std::mem::take(&mut self.users[value.index()]) {
                let (missing, step) = &mut self.steps[number];
                *missing -= 1;
                if *missing == 0 {
                    ready.extend(step.take());
                }
            }
        }
        ready
    }
}

/// Returns the operands of a store or of the check of results.
fn operands(step: &Step) -> Vec<&Operand> {
    match step {
        Step::Store { values, .. } => values.iter().flatten().collect(),
        Step::CheckResults(finish) => finish.operands().collect(),
        Step::CheckArguments(_)
        | Step::Load { .. }
        | Step::Compute(_)
        | Step::Loop(_)
        | Step::TestBounds(_)
        | Step::CheckPivot { .. } => {
            bug!("a step other than a store or the check of results follows the last section")
        }
    }
}
