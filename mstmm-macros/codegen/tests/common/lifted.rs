//! Chains whose numbers are all parameters, so that nothing is folded or rounded at compile time.

use mstmm_codegen::ids::{IdVec, ParameterId};
use mstmm_codegen::model::{
    Attachment, Chain, Drive, Effort, Frame, Friction, Hinge, HingeKind, Limits, Parameter,
    Passive, Source, SpringEnd, Symbol, Value,
};
use proc_macro2::{Ident, Span};

/// Returns the same chain with a parameter for every number except zeros and ones, which determine its structure.
pub fn lifted(mut chain: Chain) -> Chain {
    let mut lift = Lift { parameters: std::mem::take(&mut chain.parameters) };
    lift.source(&mut chain.gravity);
    for body in &mut chain.bodies {
        lift.value(&mut body.mass);
        lift.all(&mut body.com);
        lift.all(&mut body.inertia.tensor);
        lift.frame(&mut body.output);
        body.points.iter_mut().for_each(|point| lift.frame(&mut point.frame));
    }
    chain.hinges.iter_mut().for_each(|hinge| lift.hinge(hinge));
    for load in chain.loads.iter_mut() {
        lift.frame(&mut load.at);
        lift.source(&mut load.force);
        lift.source(&mut load.torque);
    }
    for spring in &mut chain.springs {
        lift.all(&mut spring.on.at);
        match &mut spring.to {
            SpringEnd::Ground(point) => lift.all(point),
            SpringEnd::Body(point) => lift.all(&mut point.at),
            SpringEnd::Previous { point, first } => {
                lift.all(&mut point.at);
                lift.all(&mut first.at);
            }
        }
        let numbers = [&mut spring.stiffness, &mut spring.damping, &mut spring.length];
        numbers.into_iter().for_each(|value| lift.value(value));
        lift.effort(&mut spring.force);
    }
    Chain { parameters: lift.parameters, ..chain }
}

struct Lift {
    parameters: IdVec<ParameterId, Parameter>,
}

impl Lift {
    fn value(&mut self, value: &mut Value) {
        match value {
            Value::Number(number) if is_structure(*number) => {}
            Value::Number(number) => {
                let magnitude = self.parameter(number.abs());
                *value = if *number < 0.0 { magnitude.negated() } else { magnitude };
            }
            Value::Symbol(_) => {}
            Value::Sum(a, b) | Value::Product(a, b) | Value::Quotient(a, b) => {
                self.value(a);
                self.value(b);
            }
            Value::Sqrt(a) | Value::Sin(a) | Value::Cos(a) => self.value(a),
        }
    }

    /// Returns the parameter for a number.
    fn parameter(&mut self, number: f64) -> Value {
        let name = Ident::new(&format!("number{:x}", number.to_bits()), Span::call_site());
        let is_it = |it: &Parameter| it.name == name;
        let id = self.parameters.position(is_it).unwrap_or_else(|| {
            let (default, unit) = (Value::Number(number), String::new());
            self.parameters.push(Parameter { name, default, unit, repetitions: None })
        });
        Value::Symbol(Symbol::Parameter(id))
    }

    fn all(&mut self, values: &mut [Value]) {
        values.iter_mut().for_each(|value| self.value(value));
    }

    fn source(&mut self, source: &mut Source) {
        if let Source::Constant(values) = source {
            self.all(values);
        }
    }

    fn frame(&mut self, frame: &mut Frame) {
        self.all(&mut frame.position);
        self.rotation(&mut frame.rotation);
    }

    /// Expresses the entries by a rotation angle or by a quaternion of any length. A rounded matrix is not a rotation, and
    /// expressions that are equal for every rotation may differ for it.
    fn rotation(&mut self, matrix: &mut [[Value; 3]; 3]) {
        let known = matrix.iter().flatten().map(Value::known).collect::<Option<Vec<f64>>>();
        let Some(entries) = known else { return };
        if entries.iter().all(|entry| is_structure(*entry)) {
            return;
        }
        match entries.iter().position(|entry| entry.abs() == 1.0) {
            Some(axis) => self.turn(matrix, &entries, axis),
            None => self.any_rotation(matrix, &entries),
        }
    }

    /// Lifts a matrix whose only one is at this entry: the four entries in other rows and columns are a cosine and a sine.
    fn turn(&mut self, matrix: &mut [[Value; 3]; 3], entries: &[f64], axis: usize) {
        let others = |axis: usize| [(axis + 1) % 3, (axis + 2) % 3];
        let (rows, columns) = (others(axis / 3), others(axis % 3));
        let sides = columns.map(|column| self.parameter(entries[3 * rows[0] + column].abs()));
        let square = |x: &Value| x.clone().times(x.clone());
        let length = square(&sides[0]).plus(square(&sides[1])).sqrt();
        for (i, row) in rows.into_iter().enumerate() {
            for (j, column) in columns.into_iter().enumerate() {
                let size = sides[i ^ j].clone();
                let is_negative = entries[3 * row + column] < 0.0;
                let side = if is_negative { size.negated() } else { size };
                matrix[row][column] = side.over(length.clone());
            }
        }
    }

    fn any_rotation(&mut self, matrix: &mut [[Value; 3]; 3], entries: &[f64]) {
        let q = quaternion(entries).map(|x| {
            let mut value = Value::Number(x);
            self.value(&mut value);
            value
        });
        let product = |a: usize, b: usize| q[a].clone().times(q[b].clone());
        let square = (1..4).fold(product(0, 0), |sum, k| sum.plus(product(k, k)));
        for (row, values) in matrix.iter_mut().enumerate() {
            for (column, value) in values.iter_mut().enumerate() {
                let entry = if row == column {
                    let others = (1..4).filter(|&k| k != row + 1);
                    let sum = product(0, 0).plus(product(row + 1, row + 1));
                    others.fold(sum, |sum, k| sum.minus(product(k, k)))
                } else {
                    let along = product(0, 4 - row - column);
                    let across = product(row + 1, column + 1);
                    let is_next = (row + 1) % 3 == column;
                    let sum = if is_next { across.minus(along) } else { across.plus(along) };
                    sum.times(Value::Number(2.0))
                };
                *value = entry.over(square.clone());
            }
        }
    }

    fn hinge(&mut self, hinge: &mut Hinge) {
        for place in [&mut hinge.inboard, &mut hinge.outboard] {
            if let Attachment::Ground(frame) = place {
                self.frame(frame);
            }
        }
        match &mut hinge.kind {
            HingeKind::Pin { axis }
            | HingeKind::Slider { axis }
            | HingeKind::Cylindrical { axis } => self.all(axis),
            HingeKind::Screw { axis, pitch } => {
                self.all(axis);
                self.value(pitch);
            }
            HingeKind::Universal { axes } => axes.iter_mut().for_each(|axis| self.all(axis)),
            HingeKind::Gimbal { axes } => axes.iter_mut().for_each(|axis| self.all(axis)),
            _ => {}
        }
        self.all(&mut hinge.rest);
        if let Drive::Efforts(efforts) = &mut hinge.drive {
            efforts.iter_mut().for_each(|effort| self.effort(effort));
        }
        hinge.passive.iter_mut().for_each(|passive| self.passive(passive));
    }

    fn effort(&mut self, effort: &mut Effort) {
        if let Effort::Constant(value) = effort {
            self.value(value);
        }
    }

    fn passive(&mut self, passive: &mut Passive) {
        let Passive { stiffness, damping, armature, friction, limits } = passive;
        let mut values = vec![stiffness, damping, armature];
        if let Some(Friction { effort, speed }) = friction {
            values.extend([effort, speed]);
        }
        if let Some(Limits { low, high, stiffness, damping }) = limits {
            values.extend([low, high, stiffness, damping]);
        }
        values.into_iter().for_each(|value| self.value(value));
    }
}

/// Returns whether a number determines the structure of a chain.
fn is_structure(number: f64) -> bool {
    [0.0, 1.0].contains(&number.abs())
}

/// Returns a multiple of the quaternion of a rotation: the longest of four.
fn quaternion(m: &[f64]) -> [f64; 4] {
    let at = |row: usize, column: usize| m[3 * row + column];
    let antisymmetric = [at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)];
    let [a, b, c] = antisymmetric;
    let mut found = [1.0 + at(0, 0) + at(1, 1) + at(2, 2), a, b, c];
    for k in 0..3 {
        let mut other = [antisymmetric[k], 0.0, 0.0, 0.0];
        for i in 0..3 {
            other[i + 1] = at(i, k) + at(k, i);
        }
        other[k + 1] = 1.0 + 2.0 * at(k, k) - at(0, 0) - at(1, 1) - at(2, 2);
        let length = |q: &[f64; 4]| q.iter().map(|x| x * x).sum::<f64>();
        if length(&other) > length(&found) {
            found = other;
        }
    }
    found
}
