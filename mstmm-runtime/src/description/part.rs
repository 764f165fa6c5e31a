//! What the rows of tables say of their entries.

use super::name::Name;

/// The kind of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum QuantityKind {
    /// A displacement in m.
    Length,
    /// An angle in rad.
    Angle,
    /// A component of a unit quaternion.
    Quaternion,
    /// A velocity in m/s.
    Velocity,
    /// An angular velocity in rad/s.
    AngularVelocity,
    /// An acceleration in m/s².
    Acceleration,
    /// An angular acceleration in rad/s².
    AngularAcceleration,
    /// A force in N.
    Force,
    /// A torque in N m.
    Torque,
    /// A parameter, whose unit is that of its default.
    Parameter,
}

impl QuantityKind {
    /// Returns the unit as text, `1` for plain numbers.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            QuantityKind::Length => "m",
            QuantityKind::Angle => "rad",
            QuantityKind::Quaternion | QuantityKind::Parameter => "1",
            QuantityKind::Velocity => "m/s",
            QuantityKind::AngularVelocity => "rad/s",
            QuantityKind::Acceleration => "m/s^2",
            QuantityKind::AngularAcceleration => "rad/s^2",
            QuantityKind::Force => "N",
            QuantityKind::Torque => "N*m",
        }
    }
}

/// What a row says of one of its entries.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The accessor of its group; may be empty.
    pub group: &'static str,
    /// The component of its group.
    pub component: Option<char>,
    /// Its kind.
    pub kind: QuantityKind,
    /// Its unit.
    pub unit: &'static str,
    /// Its start; not a number if it is unknown.
    pub start: f64,
    /// Its limits.
    pub limits: Option<[f64; 2]>,
}

impl Part {
    /// Returns a scalar of a kind without limits that starts at zero.
    pub const fn of(kind: QuantityKind) -> Self {
        Part { group: "", component: None, kind, unit: kind.unit(), start: 0.0, limits: None }
    }

    /// Returns a component of a group, which starts in the zero position.
    pub fn component(kind: QuantityKind, component: Option<char>) -> Self {
        let is_scalar_part = kind == QuantityKind::Quaternion && component == Some('w');
        let start = if is_scalar_part { 1.0 } else { 0.0 };
        Part { component, start, ..Part::of(kind) }
    }

    /// Returns the name of the entry in a row with this path.
    pub fn named(&self, path: &'static str, repetition: usize) -> Name {
        Name::new(path, repetition).with(self.group, self.component)
    }
}
