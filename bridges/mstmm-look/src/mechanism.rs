//! What a picture needs from a chain: bodies with their points and shapes, springs, and axes of hinges.

use crate::rotation::Vector;
use mstmm_runtime::Described;
use mstmm_runtime::description::{Dimension, Shape};

/// The parts of a chain that are drawn, as owned values. It does not depend on the chain's type.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// The name of the chain.
    pub name: String,
    /// The doc comment of the chain.
    pub docs: String,
    /// The dimension of the space that the chain moves in.
    pub dimension: Dimension,
    /// The acceleration of free fall in m/s², inertial frame; zero if it is an input.
    pub gravity: Vector,
    /// The bodies, in the order of the description.
    pub bodies: Vec<Body>,
    /// The connection points, in the order of the description.
    pub points: Vec<Place>,
    /// The springs, in the order of the description, with the parameters of the chain when the recording began.
    pub springs: Vec<Spring>,
    /// The axes of the hinges, in their order, with the same parameters.
    pub axes: Vec<Axis>,
}

/// A body.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name, such as `rod[12]`.
    pub name: String,
    /// The name of its type in the description.
    pub type_name: String,
    /// The mass in kg, with the parameters of the chain when the recording began.
    pub mass: f64,
    /// The centre of mass in m, body frame.
    pub com: Vector,
    /// The index of the connection point at its input, whose frame is the body frame.
    pub input: Option<usize>,
    /// Its other connection points: its output and the named points that hinges leave.
    pub points: Vec<BodyPoint>,
    /// Its shapes, body frame.
    pub shapes: Vec<Shape>,
}

/// A connection point of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPoint {
    /// The index among all connection points.
    pub point: usize,
    /// The name within the body, such as `output`.
    pub place: String,
}

/// A connection point.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The name, such as `rod[12].input`.
    pub name: String,
    /// The index of its body; `None` on the ground and at moving ends.
    pub body: Option<usize>,
}

/// A spring.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// The name, such as `tie[2]`.
    pub name: String,
    /// Its ends.
    pub ends: [SpringEnd; 2],
}

/// An end of a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringEnd {
    /// The index of its body; `None` on the ground.
    pub body: Option<usize>,
    /// The point in m: in the frame of the body, on the ground in the inertial frame.
    pub position: Vector,
}

/// An axis of a hinge.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The name of the hinge, such as `elbow`.
    pub hinge: String,
    /// The index of the connection point whose frame it is fixed in, and through whose origin it passes.
    pub point: usize,
    /// The direction, a unit vector in that frame.
    pub direction: Vector,
}

impl Mechanism {
    /// Returns the mechanism of a chain with its parameters as they are set.
    #[must_use]
    pub fn of<C>(chain: &C) -> Self
    where
        C: Described<Scalar: Into<f64>>,
    {
        let it = C::DESCRIPTION;
        let mut bodies: Vec<Body> = it
            .bodies()
            .iter()
            .enumerate()
            .map(|(index, body)| {
                let inertia = chain.inertia(index);
                Body {
                    name: body.name().to_string(),
                    type_name: body.type_name().to_owned(),
                    mass: inertia.map_or(0.0, |inertia| inertia.mass.into()),
                    com: inertia.map_or([0.0; 3], |inertia| inertia.com.map(Into::into).into()),
                    input: None,
                    points: Vec::new(),
                    shapes: body.shapes().to_vec(),
                }
            })
            .collect();
        let points = it.points().iter().map(|point| point.name().to_string());
        let points = points.enumerate().map(|(index, name)| {
            let body = place(&mut bodies, index, &name);
            Place { name, body }
        });
        let points = points.collect();
        // Gravity is that of results: here those of the start, without inputs. If they cannot be computed it is zero.
        let mut at = chain.workspace();
        let _ = chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at);
        Mechanism {
            name: it.name().to_owned(),
            docs: it.docs().to_owned(),
            dimension: it.dimension(),
            gravity: C::gravity(&at).map(Into::into),
            bodies,
            points,
            springs: springs(chain),
            axes: axes(chain),
        }
    }

    /// Returns the body at whose input a connection point is.
    #[must_use]
    pub fn body_at_input(&self, point: usize) -> Option<usize> {
        let body = self.points.get(point)?.body?;
        (self.bodies.get(body)?.input == Some(point)).then_some(body)
    }

    /// Returns whether the places of both ends of a spring are known: on the ground, or on a body with an input.
    pub(crate) fn is_drawn(&self, spring: &Spring) -> bool {
        let has_input = |body: usize| self.bodies.get(body).is_some_and(|it| it.input.is_some());
        spring.ends.iter().all(|end| end.body.is_none_or(has_input))
    }
}

fn springs<C>(chain: &C) -> Vec<Spring>
where
    C: Described<Scalar: Into<f64>>,
{
    let springs = C::DESCRIPTION.springs();
    let spring = |index: usize| {
        let ends = chain
            .spring_ends(index)?
            .map(|end| SpringEnd { body: end.body, position: end.position.map(Into::into).into() });
        Some(Spring { name: springs.get(index)?.name().to_string(), ends })
    };
    (0..springs.len()).filter_map(spring).collect()
}

fn axes<C>(chain: &C) -> Vec<Axis>
where
    C: Described<Scalar: Into<f64>>,
{
    let hinges = C::DESCRIPTION.hinges().iter().enumerate();
    let axes = hinges.flat_map(|(index, hinge)| {
        (0..hinge.axis_count()).filter_map(move |number| {
            let axis = chain.hinge_axis(index, number)?;
            let direction = axis.direction.map(Into::into).into();
            Some(Axis { hinge: hinge.name().to_string(), point: axis.point, direction })
        })
    });
    axes.collect()
}

/// Adds a point to its body, whose name precedes that of the place.
fn place(bodies: &mut [Body], point: usize, name: &str) -> Option<usize> {
    let (body, place) = name.rsplit_once('.')?;
    let index = bodies.iter().position(|it| it.name == body)?;
    let body = bodies.get_mut(index)?;
    match place {
        "input" => body.input = Some(point),
        _ => body.points.push(BodyPoint { point, place: place.to_owned() }),
    }
    Some(index)
}
