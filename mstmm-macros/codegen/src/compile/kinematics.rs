//! The function for kinematics and Jacobians.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs};
use crate::equations::{self, BodyMotion};
use crate::expr::Expr;
use crate::function::{Function, Output, Written};
use crate::math::{Motion, Vec3};
use crate::model::{BodyId, MovesWith, Request};
use crate::program::Given;

impl<'a> ChainCompiler<'a> {
    pub(super) fn kinematics(&self) -> Traced<'a> {
        let bodies: Vec<BodyId> = self.chain.physical_bodies().collect();
        let (found, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            equations::chain_kinematics(&context, &bodies, trace)
        });
        let by_entry =
            |output: Output| Output { written: Written::ByEntryOnceIfConstant, ..output };
        let motions = found.bodies.iter().flat_map(|body| self.numbers_of_motion(body));
        let motions = motions.collect::<Vec<_>>();
        let layout = layouts::motions(self.chain);
        let mut outputs = vec![by_entry(self.output(outputs::MOTIONS, layout, &motions))];
        if self.chain.requests.contains(&Request::Jacobian) {
            let columns = found.columns.iter().flat_map(|column| self.numbers_of_column(column));
            let columns = columns.collect::<Vec<_>>();
            let layout = layouts::columns(self.chain, self.layout);
            outputs.push(by_entry(self.output(outputs::COLUMNS, layout, &columns)));
        }
        let frames = self.chain.changing_frames();
        let frames = frames.iter().flat_map(|(_, _, frame)| frame.all());
        let frames: Vec<Expr> = frames.map(|value| self.numbers.scalar(value)).collect();
        if !frames.is_empty() {
            let layout = layouts::changing_frames(self.chain);
            outputs.push(by_entry(self.output(outputs::FRAMES, layout, &frames)));
        }
        Function { outputs, ..function }.into()
    }

    /// Returns the bodies with a Jacobian that is computed without the motions of other bodies: those at the free ends of a
    /// chain that has no repeated parts and is not closed.
    pub(super) fn end_bodies(&self) -> Vec<BodyId> {
        let layout = self.layout;
        let is_asked = self.chain.requests.contains(&Request::Jacobian);
        if !is_asked || !self.chain.repeats.is_empty() || !layout.loop_hinges.is_empty() {
            return Vec::new();
        }
        let is_end = |body: &BodyId| match layout.parts[*body] {
            MovesWith::Ground => false,
            MovesWith::Link(link) => layout.links.iter().all(|other| other.parent != Some(link)),
        };
        self.chain.physical_bodies().filter(is_end).collect()
    }

    /// Returns the function for the Jacobian of any point of a body.
    pub(super) fn jacobian_of(&self, body: BodyId) -> Traced<'a> {
        let given = self.given(Given::Place);
        let mut place = Vec3::zero();
        for (&axis, value) in self.chain.dimension.translations().iter().zip(given) {
            place.0[axis] = value;
        }
        let (columns, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            equations::point_jacobian(&context, body, place, trace)
        });
        let columns = columns.iter().flat_map(|column| self.numbers_of_column(column));
        let output = self.once(outputs::MATRIX, &columns.collect::<Vec<_>>());
        let outputs = vec![Output { written: Written::ByEntry, ..output }];
        Function { outputs, ..function }.into()
    }

    /// Returns the stored values of a body's motion.
    fn numbers_of_motion(&self, body: &BodyMotion<Expr<'a>>) -> Vec<Expr<'a>> {
        let dimension = self.chain.dimension;
        let (translations, rotations) = (dimension.translations(), dimension.rotations());
        let mut numbers: Vec<Expr> = translations.iter().map(|&k| body.position[k]).collect();
        match dimension.columns() {
            // Cosine and sine.
            1 => numbers.extend(translations.iter().map(|&k| body.rotation[k][0])),
            count => {
                numbers.extend(body.rotation.0.iter().take(count).flatten());
            }
        }
        let Motion { linear, angular } = body.bias_acceleration;
        numbers.extend(translations.iter().map(|&k| body.velocity[k]));
        numbers.extend(rotations.iter().map(|&k| body.omega[k]));
        numbers.extend(translations.iter().map(|&k| linear[k]));
        numbers.extend(rotations.iter().map(|&k| angular[k]));
        numbers
    }

    /// Returns the entries of a column that the dimension has.
    pub(super) fn numbers_of_column(&self, column: &Motion<Expr<'a>>) -> Vec<Expr<'a>> {
        let dimension = self.chain.dimension;
        let linear = dimension.translations().iter().map(|&k| column.linear[k]);
        linear.chain(dimension.rotations().iter().map(|&k| column.angular[k])).collect()
    }
}
