//! The values of a chain's parameters, constants and formulas.

use crate::math::{Mat3, Scalar, Sym3, Vec3};
use crate::model::{About, Attachment, Body, Chain, Frame, Symbol, Value};

/// Values of the symbols in a chain's formulas.
#[derive(Clone, Debug)]
pub struct SymbolValues<S> {
    /// Indexed by [`Symbol::Parameter`].
    pub parameters: Vec<S>,
    /// Indexed by [`Symbol::Constant`].
    pub constants: Vec<S>,
    /// A one for each independent loop constraint, then zeros. Empty if no constraint is known to
    /// depend on others.
    pub closure_steps: Vec<S>,
}

impl<S> Default for SymbolValues<S> {
    fn default() -> Self {
        SymbolValues { parameters: Vec::new(), constants: Vec::new(), closure_steps: Vec::new() }
    }
}

impl<S: Scalar> SymbolValues<S> {
    /// Returns the value of a formula.
    pub fn scalar(&self, value: &Value) -> S {
        match value {
            Value::Number(number) => S::number(*number),
            Value::Symbol(Symbol::Parameter(id)) => self.parameters[id.index()],
            Value::Symbol(Symbol::Constant(index)) => self.constants[*index],
            Value::Sum(a, b) => self.scalar(a) + self.scalar(b),
            Value::Product(a, b) => self.scalar(a) * self.scalar(b),
            Value::Quotient(a, b) => self.scalar(a) * self.scalar(b).recip(),
            Value::Sqrt(a) => self.scalar(a).sqrt(),
            Value::Sin(a) => self.scalar(a).sin_cos().0,
            Value::Cos(a) => self.scalar(a).sin_cos().1,
        }
    }

    /// Returns the components of a vector.
    pub fn vector(&self, values: &[Value; 3]) -> Vec3<S> {
        Vec3([0, 1, 2].map(|k| self.scalar(&values[k])))
    }

    /// Returns a rotation matrix.
    pub fn rotation(&self, rows: &[[Value; 3]; 3]) -> Mat3<S> {
        Mat3::from_fn(|i, j| self.scalar(&rows[i][j]))
    }

    /// Returns origin and rotation of a frame.
    pub fn frame(&self, frame: &Frame) -> (Vec3<S>, Mat3<S>) {
        (self.vector(&frame.position), self.rotation(&frame.rotation))
    }

    /// Returns origin and rotation of an attachment, in the frame of its body or in the inertial
    /// frame.
    pub fn local_frame(&self, chain: &Chain, attachment: &Attachment) -> (Vec3<S>, Mat3<S>) {
        match attachment {
            Attachment::Ground(frame) => self.frame(frame),
            Attachment::Input(_) => (Vec3::zero(), Mat3::identity()),
            Attachment::Output(body) => self.frame(&chain.bodies[*body].output),
            Attachment::Point(body, point) => self.frame(&chain.bodies[*body].points[*point].frame),
        }
    }

    /// Returns the inertia of a body about its centre of mass, body axes.
    pub fn central_inertia(&self, body: &Body) -> Sym3<S> {
        let tensor = self.tensor(body);
        match body.inertia.about {
            About::Com => tensor,
            About::Input => tensor - self.inertia_of_com(body, Vec3::zero()),
        }
    }

    /// Returns the unit vector along `axis`.
    pub fn unit(&self, axis: &[Value; 3]) -> Vec3<S> {
        let zero = [0, 1, 2].map(|k| axis[k].is_zero());
        if let Some(k) = (0..3).find(|&k| zero[(k + 1) % 3] && zero[(k + 2) % 3])
            && let Some(length) = axis[k].known()
        {
            let unit = Vec3::unit(k);
            return if length < 0.0 { -unit } else { unit };
        }
        let axis = self.vector(axis);
        axis * axis.dot(axis).sqrt().recip()
    }

    /// Returns the inertia of a body about its input point, body axes; unchanged if it is specified
    /// about that point.
    pub fn inertia_about_input(&self, body: &Body) -> Sym3<S> {
        match body.inertia.about {
            About::Input => self.tensor(body),
            About::Com => self.tensor(body) + self.inertia_of_com(body, Vec3::zero()),
        }
    }

    /// Returns the inertia of a body about `point`, body axes.
    pub fn inertia_about(&self, body: &Body, point: Vec3<S>) -> Sym3<S> {
        self.central_inertia(body) + self.inertia_of_com(body, point)
    }

    fn tensor(&self, body: &Body) -> Sym3<S> {
        Sym3([0, 1, 2, 3, 4, 5].map(|k| self.scalar(&body.inertia.tensor[k])))
    }

    fn inertia_of_com(&self, body: &Body, point: Vec3<S>) -> Sym3<S> {
        let arm = self.vector(&body.com) - point;
        Sym3::of_point_mass(self.scalar(&body.mass), arm)
    }
}
