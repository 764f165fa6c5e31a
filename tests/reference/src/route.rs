//! The routes of a chain after its first one, and the places on bodies where they begin.

use crate::chain::{Body, Chain, Element, End, Frame};
use crate::hinge::Hinge;

/// A route of a chain after the first one.
///
/// It begins at a frame in the inertial frame, at a moving frame, or at a place of a body of an
/// earlier route, with a hinge. It ends with a body. If it ends with a hinge instead, that hinge
/// closes the chain or holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// What the input of the first element is attached to. It is [`End::Free`] only for bodies that
    /// only the finish of this route holds.
    pub start: End,
    /// The hinges and bodies in written order.
    pub elements: Vec<Element>,
    /// What the output of the last element is attached to. Only one route of a chain may have a
    /// finish that is not [`End::Free`].
    pub finish: End,
}

/// A place of a body where hinges join it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The name of the body.
    pub body: String,
    /// `input`, `output` or the name of a point of the body.
    pub point: String,
}

/// A named point of a body, with axes for the hinges that begin there.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedPoint {
    /// The snake_case name.
    pub name: String,
    /// The position and the axes, in the body frame.
    pub frame: Frame,
}

impl Route {
    /// Returns a route from a place of a body to a free end.
    pub fn from_place(body: &str, point: &str, elements: Vec<Element>) -> Route {
        let place = Place { body: body.to_owned(), point: point.to_owned() };
        Route { start: End::Place(place), elements, finish: End::Free }
    }
}

impl Body {
    /// Returns the frame of a place on this body, in the body frame, if the body has the place.
    pub fn place(&self, point: &str) -> Option<Frame> {
        match point {
            "input" => Some(Frame::IDENTITY),
            "output" => Some(self.output.clone()),
            name => {
                let found = self.points.iter().find(|point| point.name == name);
                found.map(|point| point.frame.clone())
            }
        }
    }
}

impl Chain {
    /// Returns all routes in written order, each as its start, its elements and its finish.
    pub(crate) fn routes(&self) -> impl Iterator<Item = (&End, &[Element], &End)> {
        let later = self.later_routes.iter();
        let later = later.map(|route| (&route.start, &route.elements[..], &route.finish));
        std::iter::once((&self.start, &self.elements[..], &self.finish)).chain(later)
    }

    /// Returns the elements of all routes in written order.
    pub fn all_elements(&self) -> impl Iterator<Item = &Element> {
        self.routes().flat_map(|(_, elements, _)| elements)
    }

    /// Returns the elements of all routes in written order.
    pub fn all_elements_mut(&mut self) -> impl Iterator<Item = &mut Element> {
        let later = self.later_routes.iter_mut().flat_map(|route| &mut route.elements);
        self.elements.iter_mut().chain(later)
    }

    /// Returns the index of the first rate of a hinge in [`crate::State::v`].
    ///
    /// # Panics
    ///
    /// Panics if no hinge has this name.
    pub fn first_rate(&self, name: &str) -> usize {
        let number = self.hinges().position(|hinge| hinge.name == name);
        let number = number.unwrap_or_else(|| panic!("chain {}: no hinge {name}", self.name));
        self.base_dof_count() + self.hinges().take(number).map(Hinge::dof_count).sum::<usize>()
    }

    /// Returns what the finish of the chain is attached to: the one finish of its routes that is not
    /// free, if there is one.
    pub fn attached_finish(&self) -> &End {
        let mut finishes = self.routes().map(|(_, _, finish)| finish);
        finishes.find(|finish| **finish != End::Free).unwrap_or(&End::Free)
    }
}
