//! The parameters that efforts are linear in: inertias of bodies, and passive elements of hinges.

use super::{Body, BodyId, Chain, Dimension, Hinge, HingeId, Passive, Role};

/// A parameter that the efforts of inverse dynamics are linear in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DynamicParameter {
    /// An inertial parameter of a body, about its input in its axes.
    Inertial(BodyId, InertialParameter),
    /// A passive element along a rate of a hinge.
    Passive(HingeId, usize, PassiveElement),
}

/// An inertial parameter of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InertialParameter {
    /// The mass.
    Mass,
    /// An entry of the first moment, mass times centre of mass.
    FirstMoment(usize),
    /// An entry of the rotational inertia, by its row and column.
    Inertia(usize, usize),
}

/// A passive element whose effort is proportional to one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassiveElement {
    /// Dry friction.
    Friction,
    /// A damper.
    Damping,
    /// A rotor.
    Armature,
    /// A spring.
    Stiffness,
}

const AXES: [&str; 3] = ["x", "y", "z"];

impl InertialParameter {
    /// Returns the parameters that matter in a dimension, in their order.
    fn all(dimension: Dimension) -> Vec<InertialParameter> {
        use InertialParameter::{FirstMoment, Inertia, Mass};
        match dimension {
            Dimension::Space => {
                let moments = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
                let firsts = (0..3).map(FirstMoment);
                let inertias = moments.into_iter().map(|(i, j)| Inertia(i, j));
                std::iter::once(Mass).chain(firsts).chain(inertias).collect()
            }
            Dimension::Plane => vec![Mass, FirstMoment(0), FirstMoment(1), Inertia(2, 2)],
            Dimension::Line => vec![Mass],
        }
    }

    fn name(self) -> String {
        match self {
            InertialParameter::Mass => "mass".to_owned(),
            InertialParameter::FirstMoment(k) => format!("first_moment.{}", AXES[k]),
            InertialParameter::Inertia(i, j) => format!("inertia.{}{}", AXES[i], AXES[j]),
        }
    }
}

impl PassiveElement {
    const ALL: [PassiveElement; 4] = [
        PassiveElement::Friction,
        PassiveElement::Damping,
        PassiveElement::Armature,
        PassiveElement::Stiffness,
    ];

    /// Returns whether the elements along a rate have this one.
    fn is_in(self, passive: &Passive) -> bool {
        match self {
            PassiveElement::Friction => passive.friction.is_some(),
            PassiveElement::Damping => !passive.damping.is_zero(),
            PassiveElement::Armature => !passive.armature.is_zero(),
            PassiveElement::Stiffness => !passive.stiffness.is_zero(),
        }
    }

    fn name(self) -> &'static str {
        match self {
            PassiveElement::Friction => "friction",
            PassiveElement::Damping => "damping",
            PassiveElement::Armature => "armature",
            PassiveElement::Stiffness => "stiffness",
        }
    }
}

impl Chain {
    /// Returns the parameters that the efforts are linear in: those of all bodies in the order of the text, then the passive
    /// elements that the hinges have.
    pub fn dynamic_parameters(&self) -> Vec<DynamicParameter> {
        let is_physical = |(_, body): &(BodyId, &Body)| body.role == Role::Physical;
        let of_body = |(id, _): (BodyId, &Body)| {
            let all = InertialParameter::all(self.dimension).into_iter();
            all.map(move |parameter| DynamicParameter::Inertial(id, parameter))
        };
        let of_hinge = |(id, hinge): (HingeId, &Hinge)| {
            let along = |(k, passive): (usize, &Passive)| {
                let present = PassiveElement::ALL.into_iter().filter(|it| it.is_in(passive));
                present.map(|it| DynamicParameter::Passive(id, k, it)).collect::<Vec<_>>()
            };
            hinge.passive.iter().enumerate().flat_map(along).collect::<Vec<_>>()
        };
        let bodies = self.bodies.enumerate().filter(is_physical).flat_map(of_body);
        let free = self.hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed());
        bodies.chain(free.flat_map(of_hinge)).collect()
    }

    /// Returns the name of a parameter: `rod.inertia.xx`, `elbow.damping`, `hip.damping.x`.
    pub fn name_of_dynamic_parameter(&self, parameter: DynamicParameter) -> String {
        match parameter {
            DynamicParameter::Inertial(body, of_body) => {
                format!("{}.{}", self.bodies[body].path, of_body.name())
            }
            DynamicParameter::Passive(id, k, element) => {
                let hinge = &self.hinges[id];
                let rates = hinge.kind.spec().rates;
                match rates.len() {
                    1 => format!("{}.{}", hinge.path, element.name()),
                    _ => format!("{}.{}.{}", hinge.path, element.name(), rates[k]),
                }
            }
        }
    }
}
