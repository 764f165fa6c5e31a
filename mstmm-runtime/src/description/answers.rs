//! The answers of a chain by their names, for code that works with any chain.

use super::{Described, Description, Dimension};
use crate::{Error, FrameMotion};

/// An answer that a chain has if its description asks for it, with `answers = […]`.
///
/// [`Answers::answer`] computes it. [`part`](Self::part) has the names and the sizes of its results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Answer {
    /// Efforts that keep all rates constant.
    BiasEfforts,
    /// Efforts for given accelerations.
    InverseDynamics,
    /// Efforts that balance gravity at rest.
    GravityEfforts,
    /// Efforts of springs, dampers, friction and limits.
    PassiveEfforts,
    /// The mass matrix.
    MassMatrix,
    /// The inverse of the mass matrix.
    InverseMassMatrix,
    /// The product of the mass matrix with given rates.
    MassMatrixTimes,
    /// The product of the inverse of the mass matrix with given efforts.
    InverseMassMatrixTimes,
    /// Derivatives of inverse dynamics at given accelerations.
    InverseDynamicsDerivatives,
    /// Accelerations and their derivatives.
    Linearize,
    /// Accelerations and their change along a given direction.
    Push,
    /// Accelerations and the gradient of their sum with given weights.
    Pull,
    /// The matrix that maps dynamic parameters to efforts, at given accelerations.
    Regressor,
    /// The dynamic parameters.
    DynamicParameters,
    /// Mass, centre of mass and momentum.
    Momentum,
    /// The matrix that maps rates to momentum.
    MomentumMatrix,
    /// The Coriolis matrix.
    CoriolisMatrix,
    /// The product of the Coriolis matrix with a given vector.
    CoriolisMatrixTimes,
}

/// A part of the result of an answer: a matrix, stored column by column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnswerPart {
    /// The name; empty if the answer has one part.
    pub name: &'static str,
    /// The number of rows.
    pub rows: usize,
    /// The number of columns; `None` for a vector, `Some` for a matrix.
    pub columns: Option<usize>,
}

impl AnswerPart {
    /// Returns the number of values.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows * self.columns.unwrap_or(1)
    }

    /// Returns whether the part has no values.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Answer {
    /// All answers.
    pub const ALL: [Answer; 18] = [
        Answer::BiasEfforts,
        Answer::InverseDynamics,
        Answer::GravityEfforts,
        Answer::PassiveEfforts,
        Answer::MassMatrix,
        Answer::InverseMassMatrix,
        Answer::MassMatrixTimes,
        Answer::InverseMassMatrixTimes,
        Answer::InverseDynamicsDerivatives,
        Answer::Linearize,
        Answer::Push,
        Answer::Pull,
        Answer::Regressor,
        Answer::DynamicParameters,
        Answer::Momentum,
        Answer::MomentumMatrix,
        Answer::CoriolisMatrix,
        Answer::CoriolisMatrixTimes,
    ];

    /// Returns the name of its method.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Answer::BiasEfforts => "bias_efforts",
            Answer::InverseDynamics => "inverse_dynamics",
            Answer::GravityEfforts => "gravity_efforts",
            Answer::PassiveEfforts => "passive_efforts",
            Answer::MassMatrix => "mass_matrix",
            Answer::InverseMassMatrix => "inverse_mass_matrix",
            Answer::MassMatrixTimes => "mass_matrix_times",
            Answer::InverseMassMatrixTimes => "inverse_mass_matrix_times",
            Answer::InverseDynamicsDerivatives => "inverse_dynamics_derivatives",
            Answer::Linearize => "linearize",
            Answer::Push => "push",
            Answer::Pull => "pull",
            Answer::Regressor => "regressor",
            Answer::DynamicParameters => "dynamic_parameters",
            Answer::Momentum => "momentum",
            Answer::MomentumMatrix => "momentum_matrix",
            Answer::CoriolisMatrix => "coriolis_matrix",
            Answer::CoriolisMatrixTimes => "coriolis_matrix_times",
        }
    }

    /// Returns the keyword of `answers = […]` that asks for it.
    #[must_use]
    pub const fn keyword(self) -> &'static str {
        match self {
            Answer::BiasEfforts => "bias_efforts",
            Answer::InverseDynamics | Answer::GravityEfforts | Answer::PassiveEfforts => {
                "inverse_dynamics"
            }
            Answer::MassMatrix
            | Answer::InverseMassMatrix
            | Answer::MassMatrixTimes
            | Answer::InverseMassMatrixTimes => "mass_matrix",
            Answer::InverseDynamicsDerivatives => "derivatives",
            Answer::Linearize => "linearize",
            Answer::Push => "push",
            Answer::Pull => "pull",
            Answer::Regressor | Answer::DynamicParameters => "regressor",
            Answer::Momentum | Answer::MomentumMatrix => "momentum",
            Answer::CoriolisMatrix | Answer::CoriolisMatrixTimes => "coriolis_matrix",
        }
    }

    /// Returns the number of given values: accelerations, a vector of one entry for each rate, or the direction of a
    /// push, which is along coordinates, rates, inputs and parameters, in this order.
    #[must_use]
    pub fn given(self, of: &Description) -> usize {
        match self {
            Answer::InverseDynamics
            | Answer::MassMatrixTimes
            | Answer::InverseMassMatrixTimes
            | Answer::CoriolisMatrixTimes
            | Answer::InverseDynamicsDerivatives
            | Answer::Pull
            | Answer::Regressor => of.rates().len(),
            Answer::Push => 2 * of.rates().len() + of.inputs().len() + of.parameters().len(),
            _ => 0,
        }
    }

    /// Returns a part of the result by its index; `None` if there are fewer parts. `dynamic_parameters` is
    /// [`Answers::DYNAMIC_PARAMETER_COUNT`].
    #[must_use]
    pub fn part(
        self,
        of: &Description,
        dynamic_parameters: usize,
        index: usize,
    ) -> Option<AnswerPart> {
        let [n, inputs, parameters] = [of.rates().len(), of.inputs().len(), of.parameters().len()];
        let vector = |name, rows| AnswerPart { name, rows, columns: None };
        let matrix = |name, rows, columns| AnswerPart { name, rows, columns: Some(columns) };
        let [directions, turns] = match of.dimension() {
            Dimension::Space => [3, 3],
            Dimension::Plane => [2, 1],
            Dimension::Line => [1, 0],
        };
        let one = (index == 0).then_some(());
        match self {
            Answer::BiasEfforts
            | Answer::InverseDynamics
            | Answer::GravityEfforts
            | Answer::PassiveEfforts
            | Answer::MassMatrixTimes
            | Answer::InverseMassMatrixTimes
            | Answer::CoriolisMatrixTimes => one.map(|()| vector("", n)),
            Answer::MassMatrix | Answer::InverseMassMatrix | Answer::CoriolisMatrix => {
                one.map(|()| matrix("", n, n))
            }
            Answer::Regressor => one.map(|()| matrix("", n, dynamic_parameters)),
            Answer::DynamicParameters => one.map(|()| vector("", dynamic_parameters)),
            Answer::MomentumMatrix => one.map(|()| matrix("", directions + turns, n)),
            Answer::InverseDynamicsDerivatives => {
                let names = ["by_coordinates", "by_rates", "by_accelerations"];
                names.get(index).map(|name| matrix(name, n, n))
            }
            Answer::Linearize => [
                vector("accelerations", n),
                matrix("inverse_mass_matrix", n, n),
                matrix("by_coordinates", n, n),
                matrix("by_rates", n, n),
                matrix("by_inputs", n, inputs),
                matrix("by_parameters", n, parameters),
                matrix("a", 2 * n, 2 * n),
                matrix("b", 2 * n, inputs),
            ]
            .get(index)
            .copied(),
            Answer::Push => [vector("accelerations", n), vector("change", n)].get(index).copied(),
            Answer::Pull => [
                vector("accelerations", n),
                vector("coordinates", n),
                vector("rates", n),
                vector("inputs", inputs),
                vector("parameters", parameters),
            ]
            .get(index)
            .copied(),
            Answer::Momentum => [
                vector("mass", 1),
                vector("center_of_mass", directions),
                vector("linear", directions),
                vector("angular", turns),
            ]
            .get(index)
            .copied(),
        }
    }

    /// Returns the number of all values of the result.
    #[must_use]
    pub fn len(self, of: &Description, dynamic_parameters: usize) -> usize {
        let part = |index| self.part(of, dynamic_parameters, index);
        (0..).map_while(part).map(|part| part.len()).sum()
    }
}

/// A frame on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyFrame {
    row: usize,
    repetition: usize,
    frame: usize,
}

/// A chain whose answers code can call by their names. `mstmm_chain!` implements it for all chains.
///
/// Tools that work with any chain, such as interfaces to other languages, take their functions from here.
///
/// ```
/// use mstmm_runtime::description::{Answer, Answers};
///
/// /// Prints the mass matrix at the start, column by column, if the chain has it.
/// fn show<C: Answers<Scalar = f64>>(chain: &C) {
///     let mut matrix = vec![0.0; Answer::MassMatrix.len(C::DESCRIPTION, C::DYNAMIC_PARAMETER_COUNT)];
///     let (state, inputs) = (chain.initial_state(), chain.no_inputs());
///     if let Some(Ok(())) = chain.answer(Answer::MassMatrix, &state, &inputs, &[], &mut matrix) {
///         println!("{matrix:?}");
///     }
/// }
/// ```
pub trait Answers: Described {
    /// The number of dynamic parameters: the columns of the regressor; zero without the answer `regressor`.
    const DYNAMIC_PARAMETER_COUNT: usize = 0;

    /// The answers of the chain; for generated code.
    #[doc(hidden)]
    const ANSWERS_: &'static [Answer] = &[];

    /// The frames of a body, by the rows of the table of bodies; for generated code.
    #[doc(hidden)]
    const FRAMES_: &'static [&'static [&'static str]];

    /// Computes an answer. `None` if the chain does not have it, or if the number of given values or of results is wrong.
    ///
    /// [`Answer::given`] is the number of given values. The parts of the result follow each other in `result`, each
    /// column by column.
    ///
    /// Lengths of quaternions are not tested for most answers. Call [`Chain::check_state`](crate::Chain::check_state) and
    /// [`Chain::check_inputs`](crate::Chain::check_inputs) where they may be wrong.
    fn answer(
        &self,
        answer: Answer,
        state: &Self::State,
        inputs: &Self::Inputs,
        given: &[Self::Scalar],
        result: &mut [Self::Scalar],
    ) -> Option<Result<(), Error>> {
        let _ = (answer, state, inputs, given, result);
        None
    }

    /// Returns whether the chain has an answer.
    #[must_use]
    fn has(answer: Answer) -> bool {
        Self::ANSWERS_.contains(&answer)
    }

    /// Returns the names of the frames of a body by its index in [`Description::bodies`]: `input`, `output`, `com` and the
    /// named points, as far as the body has them. Empty if there is no such body.
    #[must_use]
    fn frames(body: usize) -> &'static [&'static str] {
        let row = Self::DESCRIPTION.bodies.entry(body, |_| 1).map(|entry| entry.number);
        row.and_then(|row| Self::FRAMES_.get(row)).copied().unwrap_or_default()
    }

    /// Returns a frame of a body by its name, such as `output`; `None` if there is none.
    #[must_use]
    fn frame(body: usize, name: &str) -> Option<BodyFrame> {
        let entry = Self::DESCRIPTION.bodies.entry(body, |_| 1)?;
        let frame = Self::frames(body).iter().position(|frame| *frame == name)?;
        Some(BodyFrame { row: entry.number, repetition: entry.repetition, frame })
    }

    /// Computes the motion of a frame without dynamics, as `kinematics` does. `None` if the chain does not have the answer.
    ///
    /// `jacobian` becomes the Jacobian of the frame, column by column: rows velocity, then angular velocity. It may be
    /// empty. `None` if the chain does not have the answer `jacobian` and it is not empty, or if its length is wrong.
    fn motion(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        frame: BodyFrame,
        jacobian: &mut [Self::Scalar],
    ) -> Option<Result<FrameMotion<Self::Scalar>, Error>> {
        let BodyFrame { row, repetition, frame } = frame;
        self.motion_(state, inputs, [row, repetition, frame], jacobian)
    }

    /// Computes the motion of a frame, from the row of its body, the repetition and its number; for generated code.
    #[doc(hidden)]
    fn motion_(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        frame: [usize; 3],
        jacobian: &mut [Self::Scalar],
    ) -> Option<Result<FrameMotion<Self::Scalar>, Error>> {
        let _ = (state, inputs, frame, jacobian);
        None
    }
}
