//! Hinges: their kinds, coordinates and rates.

use super::geometry::Indices;
use super::items::Element;
use super::part::{Part, QuantityKind};

/// The degrees of freedom of one type in a kind of hinge: translations or rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dofs {
    /// The accessors of coordinates and rates.
    names: [&'static str; 2],
    /// Their components, a character for each; empty for a scalar.
    components: [&'static str; 2],
    /// The kinds of coordinates and rates.
    kinds: [QuantityKind; 2],
}

impl Dofs {
    /// Makes translations.
    pub(crate) const fn moving(
        coordinates: &'static str,
        rates: &'static str,
        components: &'static str,
    ) -> Self {
        Dofs {
            names: [coordinates, rates],
            components: [components; 2],
            kinds: [QuantityKind::Length, QuantityKind::Velocity],
        }
    }

    /// Makes rotations by angles.
    pub(crate) const fn turning(
        coordinates: &'static str,
        rates: &'static str,
        components: &'static str,
    ) -> Self {
        Dofs {
            names: [coordinates, rates],
            components: [components; 2],
            kinds: [QuantityKind::Angle, QuantityKind::AngularVelocity],
        }
    }

    /// Makes all rotations, with a quaternion.
    pub(crate) const fn orienting(coordinates: &'static str, rates: &'static str) -> Self {
        Dofs {
            names: [coordinates, rates],
            components: ["wxyz", "xyz"],
            kinds: [QuantityKind::Quaternion, QuantityKind::AngularVelocity],
        }
    }

    /// Returns whether these are rotations.
    #[must_use]
    pub fn is_rotation(&self) -> bool {
        self.kinds[0] != QuantityKind::Length
    }

    pub(super) fn has_quaternion(&self) -> bool {
        self.kinds[0] == QuantityKind::Quaternion
    }

    pub(super) fn coordinate_count(&self) -> usize {
        self.count(0)
    }

    pub(super) fn rate_count(&self) -> usize {
        self.count(1)
    }

    fn count(&self, side: usize) -> usize {
        self.components[side].len().max(1)
    }
}

/// A kind of hinge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HingeShape {
    keyword: &'static str,
    dofs: &'static [Dofs],
}

#[doc(hidden)]
impl HingeShape {
    /// Makes a kind of hinge.
    pub(crate) const fn new(keyword: &'static str, dofs: &'static [Dofs]) -> Self {
        HingeShape { keyword, dofs }
    }

    /// Makes a hinge of this kind.
    #[must_use]
    pub const fn named(self, path: &'static str) -> Hinge {
        Hinge {
            path,
            shape: self,
            is_prescribed: false,
            start: &[],
            start_rate: &[],
            limits: &[],
            points: None,
            axes: &[],
        }
    }
}

/// A hinge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    path: &'static str,
    shape: HingeShape,
    is_prescribed: bool,
    start: &'static [f64],
    start_rate: &'static [f64],
    limits: &'static [[f64; 2]],
    /// The connection points at its input and its output.
    points: Option<[Indices; 2]>,
    /// Its axes as written, with default parameters.
    axes: &'static [[f64; 3]],
}

#[doc(hidden)]
impl Hinge {
    /// Makes its motion prescribed.
    #[must_use]
    pub const fn prescribed(mut self) -> Self {
        self.is_prescribed = true;
        self
    }

    /// Sets coordinates and rates at the start; not a number if the compiler does not know them.
    #[must_use]
    pub const fn starting(mut self, start: &'static [f64], rate: &'static [f64]) -> Self {
        (self.start, self.start_rate) = (start, rate);
        self
    }

    /// Sets the indices of the connection points at its input and its output.
    #[must_use]
    pub const fn between(mut self, input: usize, output: usize) -> Self {
        self.points = Some([Indices::new([input, input, 0]), Indices::new([output, output, 0])]);
        self
    }

    /// Sets these indices for each repetition: those in the first and the second one, and the difference from each later
    /// one to the next.
    #[must_use]
    pub const fn between_each(mut self, input: [usize; 3], output: [usize; 3]) -> Self {
        self.points = Some([Indices::new(input), Indices::new(output)]);
        self
    }

    /// Sets its axes: components in the frame of its output, of the first of two axes in that of its input.
    #[must_use]
    pub const fn about(mut self, axes: &'static [[f64; 3]]) -> Self {
        self.axes = axes;
        self
    }

    /// Sets the limits of its degrees of freedom, one pair for those of each type.
    #[must_use]
    pub const fn limited(mut self, limits: &'static [[f64; 2]]) -> Self {
        self.limits = limits;
        self
    }
}

impl Hinge {
    /// Returns the keyword of its kind, such as `pin`.
    #[must_use]
    pub fn keyword(&self) -> &'static str {
        self.shape.keyword
    }

    /// Returns whether its motion is prescribed: it then has no coordinates and rates in the state.
    #[must_use]
    pub fn is_prescribed(&self) -> bool {
        self.is_prescribed
    }

    /// Returns its degrees of freedom: translations, then rotations.
    #[must_use]
    pub fn dofs(&self) -> &'static [Dofs] {
        self.shape.dofs
    }

    /// Returns whether its displacement is along axes that its angles turn.
    pub(super) fn is_elastic(&self) -> bool {
        self.shape.keyword == "elastic"
    }

    /// Returns the largest angle from rest of a ball, or of the rotations of a floating hinge, in rad.
    #[must_use]
    pub fn angle_limit(&self) -> Option<f64> {
        let dofs = self.shape.dofs.iter().zip(self.limits);
        let mut quaternions = dofs.filter(|(dofs, _)| dofs.has_quaternion());
        quaternions.next().map(|(_, [_, high])| *high).filter(|high| !high.is_nan())
    }

    /// Returns the number of its axes that are fixed on one side: two of a universal hinge and of a gimbal; one of a pin, a
    /// slider, a screw, a cylindrical and a planar hinge; none of others and of the motion of a moving end.
    ///
    /// [`Described::hinge_axis`](super::Described::hinge_axis) returns an axis.
    #[must_use]
    pub fn axis_count(&self) -> usize {
        self.axes.len()
    }

    pub(super) fn points(&self, repetition: usize) -> Option<[usize; 2]> {
        self.points.map(|points| points.map(|point| point.at(repetition)))
    }

    /// Returns its axes as written; those that it does not have are zero.
    pub(super) fn axes(&self) -> [[f64; 3]; 2] {
        let axis = |index: usize| self.axes.get(index).copied().unwrap_or_default();
        [axis(0), axis(1)]
    }

    /// Returns the number of its coordinates in the state.
    #[must_use]
    pub fn coordinate_count(&self) -> usize {
        self.count(0)
    }

    /// Returns the number of its rates in the state.
    #[must_use]
    pub fn rate_count(&self) -> usize {
        self.count(1)
    }

    fn count(&self, side: usize) -> usize {
        if self.is_prescribed {
            return 0;
        }
        self.shape.dofs.iter().map(|dofs| dofs.count(side)).sum()
    }

    /// Returns the number of its efforts, also if its motion is prescribed.
    #[must_use]
    pub fn effort_count(&self) -> usize {
        self.shape.dofs.iter().map(|dofs| dofs.count(1)).sum()
    }

    pub(super) fn coordinate(&self, entry: usize) -> Part {
        let part = self.part(0, entry);
        Part { start: self.start.get(entry).copied().unwrap_or(part.start), ..part }
    }

    pub(super) fn rate(&self, entry: usize) -> Part {
        let start = self.start_rate.get(entry).copied().unwrap_or(0.0);
        Part { start, limits: None, ..self.part(1, entry) }
    }

    pub(super) fn acceleration(&self, entry: usize) -> Part {
        let kinds = [QuantityKind::Acceleration, QuantityKind::AngularAcceleration];
        let groups = ["acceleration", "acceleration.linear", "acceleration.angular"];
        self.along(entry, kinds, groups)
    }

    pub(super) fn effort(&self, entry: usize) -> Part {
        let kinds = [QuantityKind::Force, QuantityKind::Torque];
        self.along(entry, kinds, ["effort", "effort.force", "effort.torque"])
    }

    /// Returns a quantity along a rate, from the kinds of translations and rotations, and from the accessors for a hinge
    /// with only one of them, for translations and for rotations.
    fn along(&self, entry: usize, kinds: [QuantityKind; 2], groups: [&'static str; 3]) -> Part {
        let [only, translations, rotations] = groups;
        let mut first = 0;
        for dofs in self.shape.dofs {
            if let Some(component) = entry.checked_sub(first).filter(|it| *it < dofs.count(1)) {
                let [translation, rotation] = kinds;
                let kind = if dofs.is_rotation() { rotation } else { translation };
                let group = match (self.shape.dofs, dofs.is_rotation()) {
                    ([_], _) => only,
                    (_, false) => translations,
                    (_, true) => rotations,
                };
                let component = dofs.components[1].chars().nth(component);
                return Part { group, component, start: f64::NAN, ..Part::of(kind) };
            }
            first += dofs.count(1);
        }
        Part::of(QuantityKind::Parameter)
    }

    /// Returns an entry of the coordinates (side 0) or the rates (side 1).
    fn part(&self, side: usize, mut entry: usize) -> Part {
        for (number, dofs) in self.shape.dofs.iter().enumerate() {
            if entry < dofs.count(side) {
                let limits = self.limits.get(number).filter(|limits| !limits[0].is_nan());
                let kind = dofs.kinds[side];
                let component = dofs.components[side].chars().nth(entry);
                return Part {
                    group: dofs.names[side],
                    limits: limits.copied().filter(|_| kind != QuantityKind::Quaternion),
                    ..Part::component(kind, component)
                };
            }
            entry -= dofs.count(side);
        }
        Part::of(QuantityKind::Parameter)
    }
}

impl Element for Hinge {
    fn path(&self) -> &'static str {
        self.path
    }
}
