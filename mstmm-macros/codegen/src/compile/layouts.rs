//! The layouts of a chain's arrays.

use super::PointStorage;
use crate::ids::{HingeId, ParameterId, RepeatId};
use crate::model::{Chain, ConnectionPoints, Dimension, DynamicParameter, Input, Layout};
use crate::program::ArrayLayout;

/// Returns the layout of items, each with its number of entries and its repeated part.
pub fn of(
    chain: &Chain,
    items: impl IntoIterator<Item = (usize, Option<RepeatId>)>,
) -> ArrayLayout {
    let part = |repeat: RepeatId| (repeat, chain.repeats[repeat].count);
    ArrayLayout::of(items.into_iter().map(|(count, repeat)| (count, repeat.map(part))))
}

fn of_hinges(chain: &Chain, count: impl Fn(HingeId) -> usize) -> ArrayLayout {
    let hinges = chain.hinges.ids().into_iter();
    of(chain, hinges.map(|hinge| (count(hinge), chain.repeat_of_hinge(hinge))))
}

/// Returns the layout of the joint coordinates `q`.
pub fn coordinates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.q[hinge].len())
}

/// Returns the layout of the joint rates `v`.
pub fn rates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.v[hinge].len())
}

/// Returns the number of rates, rounded up so that all columns of the widest scalar type are there.
pub fn padded_rates(layout: &Layout) -> usize {
    layout.dof_count().next_multiple_of(16)
}

/// Returns the layout of one entry for every rate, including the rates of prescribed hinges.
pub fn all_rates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.rates[hinge].len())
}

/// Returns the layout of a parameter.
pub fn parameter(chain: &Chain, id: ParameterId) -> ArrayLayout {
    of(chain, [(1, part_of_values(chain, id))])
}

/// Returns the layout of all parameters.
pub fn parameters(chain: &Chain) -> ArrayLayout {
    of(chain, chain.parameters.ids().into_iter().map(|id| (1, part_of_values(chain, id))))
}

/// Returns the repeated part that a parameter has a value for in each repetition, if it has several values.
fn part_of_values(chain: &Chain, id: ParameterId) -> Option<RepeatId> {
    chain.parameters[id].repetitions?;
    chain.repeat_of_parameter(id)
}

/// Returns the layout of all inputs.
pub fn inputs(chain: &Chain, layout: &Layout) -> ArrayLayout {
    let inputs = layout.inputs.iter();
    of(chain, inputs.map(|input| (input.range.len(), chain.repeat_of_input(input.what))))
}

/// Returns the layout of the dynamic parameters.
pub fn dynamic_parameters(chain: &Chain) -> ArrayLayout {
    let repeat = |parameter: DynamicParameter| match parameter {
        DynamicParameter::Inertial(body, _) => chain.repeat_of_body(body),
        DynamicParameter::Passive(hinge, ..) => chain.repeat_of_hinge(hinge),
    };
    of(chain, chain.dynamic_parameters().into_iter().map(|parameter| (1, repeat(parameter))))
}

/// Returns the layout of an input.
pub fn input(chain: &Chain, input: &Input) -> ArrayLayout {
    of(chain, [(input.range.len(), chain.repeat_of_input(input.what))])
}

/// Returns the layout of one entry for every connection point.
pub fn points(chain: &Chain, points: &ConnectionPoints) -> ArrayLayout {
    of(chain, points.points.iter().map(|point| (1, point.repeat)))
}

/// Returns the layout of one entry for every body on the routes.
pub fn bodies(chain: &Chain) -> ArrayLayout {
    of(chain, chain.physical_bodies().map(|body| (1, chain.repeat_of_body(body))))
}

/// Returns the layout of the position of a point.
pub fn place(chain: &Chain) -> ArrayLayout {
    ArrayLayout::once(chain.dimension.translations().len())
}

/// Returns the number of stored values of a body's motion.
pub fn motion_count(dimension: Dimension) -> usize {
    let (translations, rotations) = (dimension.translations().len(), dimension.rotations().len());
    3 * translations + dimension.columns() * translations + 2 * rotations
}

/// Returns the layout of the motions of all bodies on the routes.
pub fn motions(chain: &Chain) -> ArrayLayout {
    let count = motion_count(chain.dimension);
    of(chain, chain.physical_bodies().map(|body| (count, chain.repeat_of_body(body))))
}

/// Returns the layout of the columns of all rates.
pub fn columns(chain: &Chain, layout: &Layout) -> ArrayLayout {
    let rows = chain.dimension.axes().len();
    of_hinges(chain, |hinge| rows * layout.v[hinge].len())
}

/// Returns the layout of the frames of bodies that parameters change.
pub fn changing_frames(chain: &Chain) -> ArrayLayout {
    let frames = chain.changing_frames();
    let items =
        frames.iter().map(|(body, _, values)| (values.all().count(), chain.repeat_of_body(*body)));
    of(chain, items)
}

/// Returns the layout of the results of all springs: length, rate of the length, tension, and the components of the force.
pub fn springs(chain: &Chain) -> ArrayLayout {
    let count = 3 + chain.dimension.translations().len();
    let springs = chain.springs.iter();
    of(chain, springs.map(|spring| (count, chain.repeat_of_body(spring.on.body))))
}

/// Returns the layout of the stored values of all connection points; points without values form no segment.
pub fn numbers_of_points(chain: &Chain, storage: &PointStorage) -> ArrayLayout {
    of(chain, storage.segments.iter().copied())
}
