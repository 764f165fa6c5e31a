/// A rod on a motor.
///
/// # The chain
///
/// `ground -> pin joint -> rod`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `joint` | pin | 1 |
/// | `rod` | body `Rod` |  |
///
/// 1 degree of freedom; accelerations by `riccati`, 4 operations (3 mul, 1 add, 0 reciprocal, 1 sin/cos); with everything at every connection point 32 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct Pendulum<T> {
    parameters: PendulumParameters<T>,
    derived: [T; 6],
}
/// Numbers of [`Pendulum`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumParameters<T> {
    payload: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> PendulumParameters<T> {
    /// `payload` in kg.
    #[inline]
    pub fn payload(&self) -> T {
        self.payload
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    /// The chain as described, its parameters at their defaults.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters = PendulumParameters {
            payload: T::constant(0.5f64),
        };
        let (chain, _) = Self::derive(parameters);
        chain
    }
    /// The numbers that may change at run time.
    #[inline]
    pub fn parameters(&self) -> &PendulumParameters<T> {
        &self.parameters
    }
    /// Sets `payload` in kg.
    ///
    /// # Errors
    ///
    /// [`Error::Parameter`](::mstmm::Error::Parameter) if the number is not finite or would
    /// leave the chain with a mass that is not positive, a stiffness or damping that is negative
    /// or a quantity that is not finite; the old one is kept then.
    #[allow(unused_variables, clippy::all)]
    pub fn set_payload(
        &mut self,
        value: T,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let mut parameters = self.parameters;
        parameters.payload = value;
        let values = &[value];
        let (chain, checks) = Self::derive(parameters);
        ::mstmm::generated::check_parameter("payload", values, &[&chain.derived])?;
        ::mstmm::generated::check_numbers(
            "payload",
            &checks,
            &[(true, "must leave the mass of body `rod` positive")],
        )?;
        *self = chain;
        ::core::result::Result::Ok(())
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> PendulumState<T> {
        let c = T::constant;
        PendulumState {
            q: ::mstmm::generated::vector([c(-1.5707963267948966)]),
            v: ::mstmm::generated::vector([c(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 3 mul, 4 add, 1 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters: PendulumParameters<T>) -> (Self, [T; 1]) {
        let c = T::constant;
        let payload = parameters.payload;
        /// Quantities derived from parameters and constants: 3 mul, 4 add, 1 reciprocal.
        let joint_k_xx = payload + c(1.0);
        let joint_b_y_z = joint_k_xx * c(0.5);
        let t0 = joint_k_xx * c(0.25);
        let joint_j_yy = t0 + c(0.08333333333333333);
        let p4 = T::recip(joint_j_yy);
        let joint_z0_force_y = joint_b_y_z * p4;
        let t1 = t0 + c(0.09333333333333332);
        let p5 = joint_j_yy + t1;
        let (derived, checks) = (
            [joint_k_xx, joint_b_y_z, joint_j_yy, joint_z0_force_y, p4, p5],
            [joint_k_xx],
        );
        (Self { parameters, derived }, checks)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for Pendulum<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 4 operations: 3 mul, 1 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 3 | 1 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state: &PendulumState<T>,
        inputs: &PendulumInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 1>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [known_joint_k_xx, known_joint_b_y_z, known_joint_j_yy,
        known_joint_z0_force_y, known_p4, known_p5, ..] = self.derived;
        let [[joint_angle]] = state.q.data.0;
        let joint_input0 = inputs.joint;
        /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([_], [cos_joint_angle]) = T::sin_cos([joint_angle]);
        /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 3 mul, 1 add, 0 reciprocal.
        let joint_a_lin_y = cos_joint_angle * c(9.8);
        let t0 = joint_input0 * known_p4;
        let t1 = known_joint_z0_force_y * joint_a_lin_y;
        let joint_a_ang_z = t0 - t1;
        ::mstmm::generated::finite::<
            T,
        >(&[state.q.as_slice(), state.v.as_slice(), &[inputs.joint]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(&["joint"], [known_joint_j_yy], [known_p5], [joint_a_ang_z])?;
        accelerations.data.0 = [[joint_a_ang_z]];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges by value; see
    /// [`accelerations_into`](Self::accelerations_into).
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into).
    #[inline]
    pub fn accelerations(
        &self,
        state: &PendulumState<T>,
        inputs: &PendulumInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 1>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::generated::vector([T::constant(0.0); 1]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 32 operations: 25 mul, 7 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Load of the body at `joint` | \[P, Eqs. (18), (19)\] | 7 | 4 | 0 | 0 | 0 |
    /// | Results |  | 12 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state: &PendulumState<T>,
        inputs: &PendulumInputs<T>,
        at: &mut PendulumWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [known_joint_k_xx, known_joint_b_y_z, known_joint_j_yy,
        known_joint_z0_force_y, known_p4, known_p5, ..] = self.derived;
        let [[joint_angle]] = state.q.data.0;
        let [[joint_rate]] = state.v.data.0;
        let joint_input0 = inputs.joint;
        /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
        /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t0 = joint_rate * known_joint_b_y_z;
        let minus_joint_e_force_x = joint_rate * t0;
        /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 4 mul, 1 add, 0 reciprocal.
        let joint_a_lin_x = sin_joint_angle * c(9.8);
        let joint_a_lin_y = cos_joint_angle * c(9.8);
        let t1 = joint_input0 * known_p4;
        let t2 = known_joint_z0_force_y * joint_a_lin_y;
        let joint_a_ang_z = t1 - t2;
        /// Load of the body at `joint`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t3 = known_joint_k_xx * joint_a_lin_x;
        let t4 = known_joint_k_xx * joint_a_lin_y;
        let t5 = minus_joint_e_force_x - t3;
        let t6 = known_joint_b_y_z * joint_a_ang_z;
        let t7 = t4 + t6;
        let t8 = cos_joint_angle * t5;
        let t9 = sin_joint_angle * t7;
        let minus_joint_own_force_x = t8 + t9;
        let t10 = sin_joint_angle * t5;
        let t11 = cos_joint_angle * t7;
        let minus_joint_own_force_y = t10 - t11;
        /// Results: 12 mul, 2 add, 0 reciprocal.
        let t12 = cos_joint_angle * c(0.5);
        let t13 = sin_joint_angle * c(0.5);
        let t14 = joint_rate * t13;
        let t15 = joint_rate * t12;
        let t16 = joint_rate * c(0.08333333333333333);
        let t17 = joint_rate * t16;
        let t18 = t14 * t14;
        let t19 = t15 * t15;
        let t20 = t18 + t19;
        let t21 = known_joint_k_xx * t20;
        let t22 = t17 + t21;
        let t23 = c(0.5) * t22;
        let t24 = sin_joint_angle * c(4.9);
        let t25 = known_joint_k_xx * t24;
        ::mstmm::generated::finite::<
            T,
        >(&[state.q.as_slice(), state.v.as_slice(), &[inputs.joint]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(&["joint"], [known_joint_j_yy], [known_p5], [joint_a_ang_z])?;
        at.accelerations.data.0 = [[joint_a_ang_z]];
        at.rate_accelerations.data.0 = [[joint_a_ang_z]];
        at.efforts.data.0 = [[joint_input0]];
        at.kinetic_energy = t23;
        at.potential_energy = t25;
        at.points = [
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [c(1.0), c(0.0), c(0.0)],
                    [c(0.0), c(1.0), c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [c(0.0), c(0.0), c(0.0)],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), -joint_input0],
                    [-minus_joint_own_force_x, -minus_joint_own_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [cos_joint_angle, -sin_joint_angle, c(0.0)],
                    [sin_joint_angle, cos_joint_angle, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [c(0.0), c(0.0), joint_rate],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), joint_a_ang_z],
                    [c(0.0), c(0.0), -joint_input0],
                    [-minus_joint_own_force_x, -minus_joint_own_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [cos_joint_angle, -sin_joint_angle, c(0.0)],
                    [sin_joint_angle, cos_joint_angle, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [c(0.0), c(0.0), joint_rate],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), joint_a_ang_z],
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
                ),
            ),
        ];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 14 operations: 12 mul, 2 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Results |  | 12 | 2 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state: &PendulumState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [known_joint_k_xx, ..] = self.derived;
        let [[joint_angle]] = state.q.data.0;
        let [[joint_rate]] = state.v.data.0;
        /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
        /// Results: 12 mul, 2 add, 0 reciprocal.
        let t0 = cos_joint_angle * c(0.5);
        let t1 = sin_joint_angle * c(0.5);
        let t2 = joint_rate * t1;
        let t3 = joint_rate * t0;
        let t4 = joint_rate * c(0.08333333333333333);
        let t5 = joint_rate * t4;
        let t6 = t2 * t2;
        let t7 = t3 * t3;
        let t8 = t6 + t7;
        let t9 = known_joint_k_xx * t8;
        let t10 = t5 + t9;
        let t11 = c(0.5) * t10;
        let t12 = sin_joint_angle * c(4.9);
        let t13 = known_joint_k_xx * t12;
        ::mstmm::Energy {
            kinetic: t11,
            potential: t13,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for Pendulum<T> {
    type Scalar = T;
    type State = PendulumState<T>;
    type Inputs = PendulumInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state: &PendulumState<T>,
        inputs: &PendulumInputs<T>,
        rate: &mut PendulumState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state: &PendulumState<T>,
        rate: &mut PendulumState<T>,
    ) {
        rate.q.data.0 = {
            let [[joint_rate]] = state.v.data.0;
            [[joint_rate]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut PendulumState<T>) {
        state.q.data.0 = {
            let [[joint_angle]] = state.q.data.0;
            [[joint_angle]]
        };
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for Pendulum<T> {
    type Workspace = PendulumWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> PendulumState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> PendulumInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> PendulumWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state: &PendulumState<T>,
        inputs: &PendulumInputs<T>,
        at: &mut PendulumWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state, inputs, at)
    }
    #[inline]
    fn energy(&self, state: &PendulumState<T>) -> ::mstmm::Energy<T> {
        self.energy(state)
    }
}
/// Coordinates and rates of [`Pendulum`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    pub q: ::mstmm::nalgebra::SVector<T, 1>,
    /// Rates in rad/s and m/s.
    pub v: ::mstmm::nalgebra::SVector<T, 1>,
    /// Time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> PendulumState<T> {
    /// Coordinates and rates of hinge `joint`.
    #[inline]
    #[must_use]
    pub fn joint(&self) -> ::mstmm::PinState<T> {
        let [[q0, ..]] = self.q.data.0;
        let [[v0, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0, v0)
    }
    /// Coordinates and rates of hinge `joint`, to be changed.
    #[inline]
    pub fn joint_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0, ..]] = &mut self.q.data.0;
        let [[v0, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0, v0)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for PendulumState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::generated::vector([zero]),
            v: ::mstmm::generated::vector([zero; 1]),
            t: zero,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for PendulumState<T> {
    type Scalar = T;
    #[inline]
    fn q(&self) -> &[T] {
        self.q.as_slice()
    }
    #[inline]
    fn q_mut(&mut self) -> &mut [T] {
        self.q.as_mut_slice()
    }
    #[inline]
    fn v(&self) -> &[T] {
        self.v.as_slice()
    }
    #[inline]
    fn v_mut(&mut self) -> &mut [T] {
        self.v.as_mut_slice()
    }
    #[inline]
    fn time(&self) -> T {
        self.t
    }
    #[inline]
    fn set_time(&mut self, time: T) {
        self.t = time;
    }
}
/// What drives [`Pendulum`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumInputs<T> {
    /// Efforts in N m that drive `joint`, in the order of its rates.
    pub joint: T,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for PendulumInputs<T> {
    #[inline]
    fn default() -> Self {
        Self { joint: T::constant(0.0) }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> PendulumInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`Pendulum::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 1>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 1>,
    efforts: ::mstmm::nalgebra::SVector<T, 1>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::Point<T>; 3],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> PendulumWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 1> {
        &self.accelerations
    }
    /// Kinetic energy in J.
    #[inline]
    pub fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Potential energy in J: of gravity, zero with every centre of mass at the inertial
    /// origin, and of springs.
    #[inline]
    pub fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// All connection points in the order written: the first element's input, then every
    /// element's output.
    #[inline]
    pub fn points(&self) -> &[::mstmm::Point<T>; 3] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `joint`.
    #[inline]
    pub fn joint(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 0);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0);
                value
            },
            input,
            output,
        )
    }
    /// Input and output of body `rod`.
    #[inline]
    pub fn rod(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> PendulumWorkspace<T> {
        let zero = T::constant(0.0);
        PendulumWorkspace {
            accelerations: ::mstmm::generated::vector([zero; 1]),
            rate_accelerations: ::mstmm::generated::vector([zero; 1]),
            efforts: ::mstmm::generated::vector([zero; 1]),
            kinetic_energy: zero,
            potential_energy: zero,
            points: [::core::default::Default::default(); 3],
        }
    }
}
