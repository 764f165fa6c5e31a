//! How the arrays of a chain are laid out.

use super::PointStorage;
use crate::ids::{HingeId, RepeatId};
use crate::model::{Chain, Element, Input, Layout};
use crate::program::ArrayLayout;

/// The layout of items, each with so many numbers and its repeated part.
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

/// The coordinates `q`.
pub fn coordinates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.q[hinge].len())
}

/// The rates `v`.
pub fn rates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.v[hinge].len())
}

/// A number for every rate, those of prescribed hinges as well.
pub fn all_rates(chain: &Chain, layout: &Layout) -> ArrayLayout {
    of_hinges(chain, |hinge| layout.rates[hinge].len())
}

/// A parameter.
pub fn parameter(chain: &Chain, index: usize) -> ArrayLayout {
    let is_repeated = chain.parameters[index].times.is_some();
    let repeat = is_repeated.then(|| chain.repeat_of_parameter(index)).flatten();
    of(chain, [(1, repeat)])
}

/// An input.
pub fn input(chain: &Chain, input: &Input) -> ArrayLayout {
    of(chain, [(input.range.len(), chain.repeat_of_input(input.what))])
}

/// All connection points.
pub fn points(chain: &Chain) -> ArrayLayout {
    let outputs = chain.route.iter().map(|element| match *element {
        Element::Hinge(hinge) => (1, chain.repeat_of_hinge(hinge)),
        Element::Body(body) => (1, chain.repeat_of_body(body)),
    });
    of(chain, std::iter::once((1, None)).chain(outputs))
}

/// The numbers of all connection points; points without numbers make no segment.
pub fn numbers_of_points(chain: &Chain, storage: &PointStorage) -> ArrayLayout {
    of(chain, storage.segments.iter().copied())
}
