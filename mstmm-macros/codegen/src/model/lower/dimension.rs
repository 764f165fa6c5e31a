//! Physical dimensions of numbers.

/// A physical dimension: powers of the base units. The angle is only kept for messages: it fits a
/// plain number, as in `N*m*s/rad`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct PhysicalDimension {
    /// Power of the metre.
    pub length: i32,
    /// Power of the kilogram.
    pub mass: i32,
    /// Power of the second.
    pub time: i32,
    /// Power of the radian.
    pub angle: i32,
}

/// A physical quantity: a dimension with its name.
#[derive(Debug)]
pub(super) struct Quantity {
    /// With its article.
    pub name: &'static str,
    /// Its unit in SI.
    pub unit: &'static str,
    /// Its dimension.
    pub dimension: PhysicalDimension,
    /// The field for a number of another dimension, for messages: that of the rotations of a hinge
    /// that also has translations.
    pub rotational: Option<(PhysicalDimension, &'static str)>,
}

const fn quantity(name: &'static str, unit: &'static str, powers: [i32; 4]) -> Quantity {
    let [length, mass, time, angle] = powers;
    let dimension = PhysicalDimension { length, mass, time, angle };
    Quantity { name, unit, dimension, rotational: None }
}

/// A number without a unit.
pub(super) const NUMBER: &Quantity = &quantity("a plain number", "", [0, 0, 0, 0]);
/// A component of a quaternion: a number, but no angle.
pub(super) const COMPONENT: &Quantity = &quantity("a component of a quaternion", "", [0, 0, 0, 0]);
pub(super) const ANGLE: &Quantity = &quantity("an angle", "rad", [0, 0, 0, 1]);
pub(super) const LENGTH: &Quantity = &quantity("a length", "m", [1, 0, 0, 0]);
pub(super) const MASS: &Quantity = &quantity("a mass", "kg", [0, 1, 0, 0]);
pub(super) const VELOCITY: &Quantity = &quantity("a velocity", "m/s", [1, 0, -1, 0]);
pub(super) const ACCELERATION: &Quantity = &quantity("an acceleration", "m/s^2", [1, 0, -2, 0]);
pub(super) const RATE: &Quantity = &quantity("an angular velocity", "rad/s", [0, 0, -1, 1]);
pub(super) const INERTIA: &Quantity = &quantity("a moment of inertia", "kg*m^2", [2, 1, 0, 0]);
pub(super) const FORCE: &Quantity = &quantity("a force", "N", [1, 1, -2, 0]);
pub(super) const TORQUE: &Quantity = &quantity("a torque", "N*m", [2, 1, -2, 0]);
pub(super) const STIFFNESS: &Quantity = &quantity("a stiffness", "N/m", [0, 1, -2, 0]);
pub(super) const DAMPING: &Quantity = &quantity("a damping", "N*s/m", [0, 1, -1, 0]);
pub(super) const ROTATIONAL_STIFFNESS: &Quantity =
    &quantity("a rotational stiffness", "N*m/rad", [2, 1, -2, -1]);
pub(super) const ROTATIONAL_DAMPING: &Quantity =
    &quantity("a rotational damping", "N*m*s/rad", [2, 1, -1, -1]);
pub(super) const PITCH: &Quantity = &quantity("a pitch", "m/rad", [1, 0, 0, -1]);

/// All named quantities. A dimension has the name of the first quantity that it matches.
const QUANTITIES: &[&Quantity] = &[
    NUMBER,
    ANGLE,
    LENGTH,
    MASS,
    VELOCITY,
    ACCELERATION,
    RATE,
    INERTIA,
    FORCE,
    TORQUE,
    STIFFNESS,
    DAMPING,
    ROTATIONAL_STIFFNESS,
    ROTATIONAL_DAMPING,
    PITCH,
    &quantity("a time", "s", [0, 0, 1, 0]),
    &quantity("a frequency", "1/s", [0, 0, -1, 0]),
    &quantity("an angular acceleration", "rad/s^2", [0, 0, -2, 1]),
    &quantity("a power", "W", [2, 1, -3, 0]),
    &quantity("a pressure", "Pa", [-1, 1, -2, 0]),
    &quantity("an area", "m^2", [2, 0, 0, 0]),
    &quantity("a volume", "m^3", [3, 0, 0, 0]),
    &quantity("a density", "kg/m^3", [-3, 1, 0, 0]),
    &quantity("a momentum", "kg*m/s", [1, 1, -1, 0]),
];

/// Quantities whose units messages show, since they are less known.
const WITH_UNITS: &[&Quantity] = &[STIFFNESS, DAMPING, ROTATIONAL_STIFFNESS, ROTATIONAL_DAMPING];

impl Quantity {
    /// What is expected, in words.
    pub fn described(&self) -> String {
        if WITH_UNITS.iter().any(|known| known.dimension == self.dimension) {
            return format!("{}, `{}`", self.name, self.unit);
        }
        self.name.to_owned()
    }
}

impl PhysicalDimension {
    /// Returns the dimension of a product with a power of the other factor.
    pub fn times(self, other: PhysicalDimension, power: i32) -> PhysicalDimension {
        // Powers of powers overflow quickly, and are an error long before.
        let add = |a: i32, b: i32| a.saturating_add(b.saturating_mul(power));
        PhysicalDimension {
            length: add(self.length, other.length),
            mass: add(self.mass, other.mass),
            time: add(self.time, other.time),
            angle: add(self.angle, other.angle),
        }
    }

    /// Of the square root, if it has one.
    pub fn root(self) -> Option<PhysicalDimension> {
        let PhysicalDimension { length, mass, time, angle } = self;
        let even = [length, mass, time, angle].iter().all(|power| power % 2 == 0);
        let half = PhysicalDimension {
            length: length / 2,
            mass: mass / 2,
            time: time / 2,
            angle: angle / 2,
        };
        even.then_some(half)
    }

    /// Whether the two can be added and compared: an angle is a number.
    pub fn fits(self, other: PhysicalDimension) -> bool {
        PhysicalDimension { angle: 0, ..self } == PhysicalDimension { angle: 0, ..other }
    }

    /// Whether it measures nothing: a ratio or an angle.
    pub fn is_number(self) -> bool {
        self.fits(PhysicalDimension::default())
    }

    /// What it measures, in words.
    pub fn name(self) -> String {
        self.quantity().map_or_else(
            || format!("a quantity in {}", self.unit()),
            |quantity| quantity.name.to_owned(),
        )
    }

    /// Its unit in SI.
    pub fn unit(self) -> String {
        if let Some(quantity) = self.quantity() {
            return quantity.unit.to_owned();
        }
        let PhysicalDimension { length, mass, time, angle } = self;
        let powers = [("kg", mass), ("m", length), ("s", time), ("rad", angle)];
        let part = |(symbol, power): &(&str, i32)| match power.unsigned_abs() {
            1 => (*symbol).to_owned(),
            power => format!("{symbol}^{power}"),
        };
        let above: Vec<_> = powers.iter().filter(|(_, power)| *power > 0).map(part).collect();
        let below: Vec<_> = powers.iter().filter(|(_, power)| *power < 0).map(part).collect();
        let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
        below.into_iter().fold(above, |unit, part| format!("{unit}/{part}"))
    }

    fn quantity(self) -> Option<&'static Quantity> {
        QUANTITIES.iter().copied().find(|quantity| quantity.dimension == self)
    }
}

#[cfg(test)]
mod tests {
    use super::{PhysicalDimension, RATE, TORQUE};

    #[test]
    fn dimensions_have_names_and_units() {
        assert_eq!(RATE.dimension.name(), "an angular velocity");
        let odd = TORQUE.dimension.times(RATE.dimension, -2);
        assert_eq!(odd.unit(), "kg*m^2/rad^2");
        assert_eq!(odd.name(), "a quantity in kg*m^2/rad^2");
        assert!(
            RATE.dimension.fits(PhysicalDimension { time: -1, ..PhysicalDimension::default() })
        );
        assert!(!RATE.dimension.fits(TORQUE.dimension));
    }
}
