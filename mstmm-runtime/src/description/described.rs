//! The trait of chains that describe themselves.

use super::displacement;
use super::geometry::{WrittenVectors, direction};
use super::origin;
use super::results::{Arrays, spring, spring_len};
use super::values::{Search, Values};
use super::{
    BodyInertia, Description, Dimension, HingeAxis, PointResult, Spring, SpringEnd, WrittenInertia,
};
use crate::origin::Origin;
use crate::{ChainState, Energy, Error, GeneratedChain, SpringResult};

/// A chain that describes itself at run time. `mstmm_chain!` implements it for all chains.
///
/// Tools that work with any chain, such as files of results, tables and interfaces to other languages, take names, units
/// and inertia from here. See the [module](crate::description) for names and orders.
///
/// ```
/// use mstmm_runtime::{ChainState, Described};
///
/// fn print<C: Described>(state: &C::State) {
///     for (quantity, value) in C::DESCRIPTION.coordinates().iter().zip(state.coordinates()) {
///         println!("{} = {value:?} {}", quantity.name, quantity.unit);
///     }
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a chain of `mstmm_chain!`: the chain comes first, then the state",
    label = "expected a chain of `mstmm_chain!`"
)]
pub trait Described: GeneratedChain<Inputs: Clone + Default> {
    /// The description.
    #[doc(alias("mj_id2name", "Model::names", "GetStateNames", "introspection"))]
    const DESCRIPTION: &'static Description;

    /// Returns inputs with these values, in the order of [`Description::inputs`]; `None` if their number is another.
    ///
    /// The inputs of a chain are fields of several types, so they are copied. Quaternions of prescribed motions are
    /// checked where the inputs are used.
    #[must_use]
    fn inputs_from_slice(values: &[Self::Scalar]) -> Option<Self::Inputs> {
        if values.len() != Self::DESCRIPTION.inputs().len() {
            return None;
        }
        let mut inputs = Self::Inputs::default();
        Self::copy_inputs_(&mut inputs, Values::From(values.iter()));
        Some(inputs)
    }

    /// Copies inputs to a slice, in the order of [`Description::inputs`]. Returns `None` and copies nothing if the length
    /// of the slice is another.
    #[must_use]
    fn inputs_to_slice(inputs: &Self::Inputs, values: &mut [Self::Scalar]) -> Option<()> {
        if values.len() != Self::DESCRIPTION.inputs().len() {
            return None;
        }
        Self::copy_inputs_(&mut inputs.clone(), Values::To(values.iter_mut()));
        Some(())
    }

    /// Copies the displacement from the coordinates of `from` to those of `to`, with an entry for each rate. Returns `None`
    /// and copies nothing if the length of the slice is another.
    ///
    /// For a `ball` and for the rotation of a `floating` or an `elastic` hinge, the entries are the rotation vector from
    /// the first to the second orientation, in rad, in outboard components, of at most half a turn. The translation of an
    /// `elastic` hinge is that of the outboard origin along inboard axes. All other entries are differences of
    /// coordinates.
    ///
    /// Small displacements are the δ of a linearisation: with `x = (δ, dv)` the state of a regulator is the displacement
    /// from the reference, followed by the difference of the rates. Quaternions must have unit length.
    ///
    /// ```
    /// use mstmm_runtime::{ChainState, Described};
    ///
    /// /// Writes the deviation x = (δ, dv) from a reference; x has two entries for each rate.
    /// fn deviation<C: Described<Scalar = f64>>(reference: &C::State, state: &C::State, x: &mut [f64]) -> Option<()> {
    ///     let (displacement, rates) = x.split_at_mut_checked(state.rates().len())?;
    ///     for ((x, v), v0) in rates.iter_mut().zip(state.rates()).zip(reference.rates()) {
    ///         *x = v - v0;
    ///     }
    ///     C::displacement_to_slice(reference, state, displacement)
    /// }
    /// ```
    #[doc(alias("difference", "mj_differentiatePos", "configuration difference", "log6"))]
    #[must_use]
    fn displacement_to_slice(
        from: &Self::State,
        to: &Self::State,
        displacement: &mut [Self::Scalar],
    ) -> Option<()> {
        let (mut from, mut to, mut rest) = (from.coordinates(), to.coordinates(), displacement);
        if rest.len() != Self::DESCRIPTION.rates().len() {
            return None;
        }
        for hinge in Self::DESCRIPTION.hinges().iter() {
            let (a, b, out);
            (a, from) = from.split_at_checked(hinge.coordinate_count())?;
            (b, to) = to.split_at_checked(hinge.coordinate_count())?;
            (out, rest) = rest.split_at_mut_checked(hinge.rate_count())?;
            displacement::between(&hinge, [a, b], out);
        }
        Some(())
    }

    /// Displaces the coordinates of a state, the inverse of [`displacement_to_slice`](Self::displacement_to_slice). Returns
    /// `None` and leaves the state if the length of the slice is not the number of rates.
    ///
    /// Rates and time stay. A small displacement δ changes the coordinates by `N(q) δ`, as the rates do: q̇ = N(q) v.
    #[doc(alias("integrate", "mj_integratePos", "exp6", "retraction"))]
    #[must_use]
    fn displace(state: &mut Self::State, displacement: &[Self::Scalar]) -> Option<()> {
        if displacement.len() != Self::DESCRIPTION.rates().len() {
            return None;
        }
        let (mut q, mut rest) = (state.coordinates_mut(), displacement);
        for hinge in Self::DESCRIPTION.hinges().iter() {
            let (coordinates, change);
            (coordinates, q) = q.split_at_mut_checked(hinge.coordinate_count())?;
            (change, rest) = rest.split_at_checked(hinge.rate_count())?;
            displacement::displace(&hinge, coordinates, change);
        }
        Some(())
    }

    /// Returns the first value that is NaN or infinite, in any lane: the time, then coordinates, rates and inputs.
    ///
    /// [`Description::name_of`] gives its name. Functions that fail with [`Error::NotFinite`] call it after the failure,
    /// so that a step without a failure has no such search. The inputs are copied, as by
    /// [`inputs_to_slice`](Self::inputs_to_slice).
    ///
    /// ```
    /// use mstmm_runtime::description::Origin;
    /// use mstmm_runtime::Described;
    ///
    /// fn rate_is_wrong<C: Described>(state: &C::State, inputs: &C::Inputs) -> bool {
    ///     matches!(C::not_finite(state, inputs), Some(Origin::Rate(_)))
    /// }
    /// ```
    #[cold]
    #[must_use]
    fn not_finite(state: &Self::State, inputs: &Self::Inputs) -> Option<Origin> {
        origin::of_state(state).or_else(|| {
            let mut search = Search::default();
            Self::copy_inputs_(&mut inputs.clone(), Values::Find(&mut search));
            search.found.map(Origin::Input)
        })
    }

    /// Returns the value of a parameter by its index in [`Description::parameters`]; `None` if there is no such
    /// parameter.
    fn parameter(&self, index: usize) -> Option<Self::Scalar> {
        let (row, repetition) = Self::DESCRIPTION.parameter_row(index)?;
        self.parameter_(row).get(repetition).copied()
    }

    /// Sets a parameter by its index in [`Description::parameters`], as its setter does. Of a parameter with a value for
    /// each repetition the other values stay.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`], as its setter. It names `index` if there is no such parameter. The previous value is
    /// kept.
    fn set_parameter(&mut self, index: usize, value: Self::Scalar) -> Result<(), Error> {
        match Self::DESCRIPTION.parameter_row(index) {
            Some((row, repetition)) => self.set_parameter_(row, (repetition, value)),
            None => no_parameter(),
        }
    }

    /// Returns mass, centre of mass and inertia tensor of a body with the parameters as they are set, by its index in
    /// [`Description::bodies`]. `None` if there is no such body.
    #[doc(alias("body_mass", "body_ipos", "body_inertia", "Model::inertias"))]
    #[doc(alias("CalcSpatialInertiaInBodyFrame"))]
    fn inertia(&self, body: usize) -> Option<BodyInertia<Self::Scalar>> {
        let at = Self::DESCRIPTION.bodies.entry(body, |_| 1)?;
        let mut written = at.row.inertia().of_scalar(at.number, at.repetition);
        self.change_inertia_(&mut written);
        Some(written.about_com(Self::DESCRIPTION.dimension))
    }

    /// Returns the ends of a spring with the parameters as they are set, by its index in [`Description::springs`]: that of
    /// `on`, then that of `to`. `None` if there is no such spring.
    ///
    /// The tension of the spring acts along the line between them, and their distance is its length.
    fn spring_ends(&self, spring: usize) -> Option<[SpringEnd<Self::Scalar>; 2]> {
        let at = Self::DESCRIPTION.springs.entry(spring, |_| 1)?;
        let [on, to] = at.row.ends();
        let positions = [on, to].map(|end| end.position(at.repetition));
        let mut written = WrittenVectors::new(at.number, at.repetition, positions);
        self.change_ends_(&mut written);
        let [first, second] = written.vectors;
        let end = |body, position: [Self::Scalar; 3]| SpringEnd { body, position: position.into() };
        Some([end(on.body(at.repetition), first), end(to.body(at.repetition), second)])
    }

    /// Returns an axis of a hinge with the parameters as they are set, by the index of the hinge in
    /// [`Description::hinges`] and the index of the axis. `None` if there is no such hinge, or if it has fewer axes; see
    /// [`Hinge::axis_count`](super::Hinge::axis_count).
    fn hinge_axis(&self, hinge: usize, axis: usize) -> Option<HingeAxis<Self::Scalar>> {
        let at = Self::DESCRIPTION.hinges.entry(hinge, |_| 1)?;
        let [input, output] = at.row.points(at.repetition)?;
        let point = match (at.row.axis_count(), axis) {
            (2, 0) => input,
            (count, axis) if axis < count => output,
            _ => return None,
        };
        let mut written = WrittenVectors::new(at.number, at.repetition, at.row.axes());
        self.change_axes_(&mut written);
        written.vectors.get(axis).map(|it| HingeAxis { point, direction: direction(*it) })
    }

    /// Returns the accelerations in a workspace, in the order of [`Description::accelerations`].
    #[must_use]
    fn accelerations(at: &Self::Workspace) -> &[Self::Scalar] {
        Self::arrays_(at).accelerations
    }

    /// Returns the efforts in a workspace, in the order of [`Description::efforts`].
    #[must_use]
    fn efforts(at: &Self::Workspace) -> &[Self::Scalar] {
        Self::arrays_(at).efforts
    }

    /// Returns the energies in a workspace; `None` if the chain's setting `results` omits them.
    #[must_use]
    fn energies(at: &Self::Workspace) -> Option<Energy<Self::Scalar>> {
        Self::arrays_(at).energy
    }

    /// Returns the acceleration of free fall in m/s² that the results in a workspace are for, inertial frame.
    #[must_use]
    fn gravity(at: &Self::Workspace) -> [Self::Scalar; 3] {
        let mut gravity = [Self::Scalar::default(); 3];
        for (entry, value) in gravity.iter_mut().zip(Self::arrays_(at).base_acceleration) {
            *entry = Self::Scalar::default() - *value;
        }
        gravity
    }

    /// Returns the results at a connection point by its index in [`Description::points`]; `None` if there is no such
    /// point.
    #[must_use]
    fn point(at: &Self::Workspace, index: usize) -> Option<PointResult<Self::Scalar>> {
        (index < Self::DESCRIPTION.points().len()).then(|| Self::point_(at, index))
    }

    /// Returns the results of a spring by its index in [`Description::springs`], its force with three components; `None`
    /// if there is no such spring or if the chain's setting `results` omits `z`.
    #[must_use]
    fn spring(
        at: &Self::Workspace,
        index: usize,
    ) -> Option<SpringResult<Self::Scalar, [Self::Scalar; 3]>> {
        let count: fn(&Spring) -> usize = match Self::DESCRIPTION.dimension {
            Dimension::Space => |_| spring_len(Dimension::Space),
            Dimension::Plane => |_| spring_len(Dimension::Plane),
            Dimension::Line => |_| spring_len(Dimension::Line),
        };
        let range = Self::DESCRIPTION.springs.range(index, count)?;
        spring(Self::arrays_(at).springs.get(range)?)
    }

    /// Returns the arrays of a workspace; for generated code.
    #[doc(hidden)]
    fn arrays_(at: &Self::Workspace) -> Arrays<'_, Self::Scalar>;

    /// Returns the results at a connection point; for generated code.
    #[doc(hidden)]
    fn point_(at: &Self::Workspace, index: usize) -> PointResult<Self::Scalar>;

    /// Sets the values that parameters change; for generated code.
    #[doc(hidden)]
    fn change_inertia_(&self, inertia: &mut WrittenInertia<Self::Scalar>) {
        let _ = inertia;
    }

    /// Sets the components of the ends of a spring that parameters change; for generated code.
    #[doc(hidden)]
    fn change_ends_(&self, ends: &mut WrittenVectors<Self::Scalar>) {
        let _ = ends;
    }

    /// Sets the components of the axes of a hinge that parameters change; for generated code.
    #[doc(hidden)]
    fn change_axes_(&self, axes: &mut WrittenVectors<Self::Scalar>) {
        let _ = axes;
    }

    /// Copies the scalars of inputs in their order; for generated code.
    #[doc(hidden)]
    fn copy_inputs_(inputs: &mut Self::Inputs, values: Values<'_, Self::Scalar>) {
        let _ = (inputs, values);
    }

    /// Returns the values of a row; for generated code.
    #[doc(hidden)]
    fn parameter_(&self, row: usize) -> &[Self::Scalar] {
        let _ = row;
        &[]
    }

    /// Sets a value of a row, with its repetition; for generated code.
    #[doc(hidden)]
    fn set_parameter_(&mut self, row: usize, value: (usize, Self::Scalar)) -> Result<(), Error> {
        let _ = (row, value);
        no_parameter()
    }
}

/// Returns the error for a parameter that does not exist.
pub(crate) const fn no_parameter() -> Result<(), Error> {
    let reason = "must be less than the number of parameters";
    Err(Error::InvalidParameter { name: "index", reason })
}
