//! The numbers of a chain as scalars.

use crate::math::{Mat3, Scalar, Sym3, Vec3};
use crate::model::{About, Body, Chain, Effort, Frame, Hinge, Layout, Place, Symbol, Value};

/// What stands for the symbols of a chain's numbers.
#[derive(Clone, Debug)]
pub struct Numbers<S> {
    /// By [`Symbol::Parameter`].
    pub parameters: Vec<S>,
    /// By [`Symbol::Constant`].
    pub constants: Vec<S>,
}

impl<S: Scalar> Numbers<S> {
    /// The number of a formula.
    pub fn scalar(&self, value: &Value) -> S {
        match value {
            Value::Number(number) => S::number(*number),
            Value::Symbol(Symbol::Parameter(index)) => self.parameters[*index],
            Value::Symbol(Symbol::Constant(index)) => self.constants[*index],
            Value::Sum(a, b) => self.scalar(a) + self.scalar(b),
            Value::Product(a, b) => self.scalar(a) * self.scalar(b),
            Value::Quotient(a, b) => self.scalar(a) * self.scalar(b).recip(),
            Value::Sqrt(a) => self.scalar(a).sqrt(),
            Value::Sin(a) => self.scalar(a).sin_cos().0,
            Value::Cos(a) => self.scalar(a).sin_cos().1,
        }
    }

    /// The components of a vector.
    pub fn vector(&self, values: &[Value; 3]) -> Vec3<S> {
        Vec3([0, 1, 2].map(|k| self.scalar(&values[k])))
    }

    /// A rotation matrix.
    pub fn rotation(&self, rows: &[[Value; 3]; 3]) -> Mat3<S> {
        Mat3::from_fn(|i, j| self.scalar(&rows[i][j]))
    }

    /// Origin and rotation of a frame.
    pub fn frame(&self, frame: &Frame) -> (Vec3<S>, Mat3<S>) {
        (self.vector(&frame.position), self.rotation(&frame.rotation))
    }

    /// Origin and rotation of a place in the frame of its body, or in the inertial frame.
    pub fn place(&self, chain: &Chain, place: &Place) -> (Vec3<S>, Mat3<S>) {
        match place {
            Place::Ground(frame) => self.frame(frame),
            Place::Input(_) => (Vec3::zero(), Mat3::identity()),
            Place::Output(body) => self.frame(&chain.bodies[*body].output),
        }
    }

    /// Inertia of a body about its centre of mass, body axes.
    pub fn central_inertia(&self, body: &Body) -> Sym3<S> {
        let tensor = Sym3([0, 1, 2, 3, 4, 5].map(|k| self.scalar(&body.inertia.tensor[k])));
        match body.inertia.about {
            About::Com => tensor,
            About::Input => tensor - self.inertia_of_com(body, Vec3::zero()),
        }
    }

    /// Inertia of a body about `point`, body axes. As written where it was written about there.
    pub fn inertia_about(&self, body: &Body, place: &Place, point: Vec3<S>) -> Sym3<S> {
        let tensor = Sym3([0, 1, 2, 3, 4, 5].map(|k| self.scalar(&body.inertia.tensor[k])));
        match (body.inertia.about, place) {
            (About::Input, Place::Input(_)) => tensor,
            _ => self.central_inertia(body) + self.inertia_of_com(body, point),
        }
    }

    fn inertia_of_com(&self, body: &Body, point: Vec3<S>) -> Sym3<S> {
        let arm = self.vector(&body.com) - point;
        Sym3::of_point_mass(self.scalar(&body.mass), arm)
    }

    /// The efforts in all hinges' coordinates, in the order of the rates.
    pub fn efforts(&self, chain: &Chain, layout: &Layout, inputs: &[S]) -> Vec<S> {
        let one = |(index, hinge): (usize, &Hinge)| match &hinge.effort {
            Effort::Free => vec![S::zero(); hinge.kind.freedoms()],
            Effort::Constant(values) => values.iter().map(|value| self.scalar(value)).collect(),
            Effort::Input => inputs[layout.inputs[index].clone()].to_vec(),
        };
        chain.hinges.iter().enumerate().flat_map(one).collect()
    }
}
