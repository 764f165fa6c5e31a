/// A rod on a motor.
///
/// # The chain
///
/// `ground -> pin joint -> rod`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 139 472" width="139" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 450l12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="40.2" y="463.5" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 450l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="432.0" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M22 450l-12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="3.8" y="463.5" font-size="10" opacity="0.6" text-anchor="middle">z</text>
/// <path d="M36.0 36.0L36.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M36.0 36.0L36.0 436.0L36.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="36.0" cy="436.0" r="3" fill="#3a87c8"/>
/// <path d="M22.0 45.0h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="36.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <text x="44.0" y="28.0">joint</text>
/// <text x="36.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <path d="M109.0 22.0l0.0 28.0m-3.5 -6.1l3.5 6.1l3.5 -6.1" fill="none" stroke="currentColor" stroke-width="1.5"/><text x="122.0" y="40.0" font-style="italic" text-anchor="middle">g</text>
/// </svg>
///
/// | element | kind | degrees of freedom |
/// |---|---|---|
/// | `joint` | pin(z) | 1 |
/// | `rod` | body `Rod` |  |
///
/// Mobility 1: 1 degree of freedom.
///
/// Accelerations by `riccati`: 4 operations (3 mul, 1 add, 0 reciprocal, 1 sin/cos). With all results at every connection point: 17 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct Pendulum<T> {
    changed_by_setters: ::mstmm::generated::Sealed<PendulumParameters<T>, [T; 7]>,
}
/// The parameters of [`Pendulum`], which can change at run time.
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
    /// Makes the chain of the description, with default parameters.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters_ = PendulumParameters {
            payload: T::constant(0.5f64),
        };
        let (chain_, _) = Self::derive(::mstmm::generated::Sealed::new(parameters_));
        chain_
    }
    /// Returns the parameters, which can change at run time. Each has a setter.
    #[inline]
    pub fn parameters(&self) -> &PendulumParameters<T> {
        self.changed_by_setters.parameters()
    }
    /// Sets `payload` in kg.
    ///
    /// # Errors
    ///
    /// `Error::InvalidParameter` if the number is not finite or would leave the chain with a mass that is not
    /// positive, with a negative moment of inertia, stiffness or damping, with limits out of order or, for a ball, above
    /// 180 deg, with an axis or a quaternion whose length is not between 1e-15 and 1e15, with a universal hinge or a
    /// gimbal whose successive axes are parallel, with an elastic hinge whose pitch angle at the start or at rest is
    /// not between -90 and 90 deg, or with a quantity that is not finite. It names the body, the hinge or the spring,
    /// and the old number is kept. Whether moments and products of inertia fit together is not tested, because
    /// parameters are set one by one.
    #[allow(unused_variables, clippy::all)]
    pub fn set_payload(
        &mut self,
        value_: T,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let mut parameters_ = *self.parameters();
        parameters_.payload = value_;
        let values_ = &[value_];
        let sealed_ = ::mstmm::generated::Sealed::new(parameters_);
        let (chain_, checks_) = Self::derive(sealed_);
        ::mstmm::generated::check_parameter("payload", values_)?;
        ::mstmm::generated::check_rules(
            "payload",
            &checks_,
            &[(true, "must leave the mass of body `rod` positive")],
        )?;
        ::mstmm::generated::check_derived(
            "payload",
            &[&*chain_.changed_by_setters.derived()],
        )?;
        *self = chain_;
        ::core::result::Result::Ok(())
    }
    /// Computes the values derived from parameters and constants: 3 mul, 6 add, 1 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(
        sealed_: ::mstmm::generated::Sealed<PendulumParameters<T>>,
    ) -> (Self, [T; 1]) {
        let parameters_ = sealed_.parameters();
        let c_ = T::constant;
        let payload_ = parameters_.payload;
        /// Quantities derived from parameters and constants: 3 mul, 6 add, 1 reciprocal.
        let rod_mass_ = payload_ + c_(1.0);
        let rod_first_moment_x_ = rod_mass_ * c_(0.5);
        let t0_ = rod_mass_ * c_(0.25);
        let rod_inertia_yy_ = t0_ + c_(0.08333333333333333);
        let t1_ = t0_ + c_(0.07333333333333333);
        let rod_inertia_xx_ = rod_inertia_yy_ - t1_;
        let joint_d_inverse_ = T::recip(rod_inertia_yy_);
        let t2_ = rod_inertia_yy_ + rod_inertia_xx_;
        let joint_d_scale_ = rod_inertia_yy_ + t2_;
        let joint_gain_fy_ = rod_first_moment_x_ * joint_d_inverse_;
        let derived_ = [
            rod_mass_,
            rod_first_moment_x_,
            rod_inertia_xx_,
            rod_inertia_yy_,
            joint_d_inverse_,
            joint_d_scale_,
            joint_gain_fy_,
        ];
        let checks_ = [rod_mass_];
        (
            Self {
                changed_by_setters: sealed_.with(derived_),
            },
            checks_,
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for Pendulum<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    #[doc(alias("forward dynamics", "aba", "qacc"))]
    /// Computes the accelerations `v̇` of all hinges, in the order of `v` of the state, in rad/s² and m/s²
    /// (forward dynamics). This is the fastest method.
    ///
    /// 4 operations: 3 mul, 1 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Kinematics of `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Riccati transfer over `joint` | F = I a + p, \[P, Eqs. (18), (19), (25), (35)\] | 1 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
    /// `Error::NotFinite` if the state or the inputs are not finite. `accelerations` is then
    /// unchanged.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state_: &PendulumState<T>,
        inputs_: &PendulumInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 1>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [known_rod_mass_, known_rod_first_moment_x_, known_rod_inertia_xx_,
        known_rod_inertia_yy_, known_joint_d_inverse_, known_joint_d_scale_,
        known_joint_gain_fy_] = *self.changed_by_setters.derived();
        let [[joint_angle_]] = state_.q.data.0;
        let joint_input0_ = inputs_.joint;
        /// Kinematics of `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
        /// Riccati transfer over `joint`, F = I a + p, [P, Eqs. (18), (19), (25), (35)]: 1 mul, 0 add, 0 reciprocal.
        let joint_u_over_d_ = joint_input0_ * known_joint_d_inverse_;
        /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t0_ = cos_joint_angle_ * known_joint_gain_fy_;
        let joint_acc_ang_z_ = T::mul_neg_add(c_(9.8), t0_, joint_u_over_d_);
        if !::mstmm::generated::pivots_ok::<
            T,
            _,
            _,
        >(
            [known_rod_inertia_yy_],
            [known_joint_d_scale_],
            [state_.t, state_.v.data.0[0][0], joint_acc_ang_z_],
        ) {
            return ::core::result::Result::Err(
                ::mstmm::generated::pivot_error::<
                    Self,
                    _,
                >(
                    &["joint"],
                    [known_rod_inertia_yy_],
                    [known_joint_d_scale_],
                    state_,
                    inputs_,
                ),
            );
        }
        accelerations_.data.0 = [[joint_acc_ang_z_]];
        ::core::result::Result::Ok(())
    }
    /// Computes into `at`: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
    ///
    /// 17 operations: 14 mul, 3 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Kinematics of `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Loads on `rod` | \[P, Eqs. (14), (15), (20)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = I a + p, \[P, Eqs. (18), (19), (25), (35)\] | 1 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Results |  | 4 | 0 | 0 | 0 | 0 |
    /// | Wrench in `joint` | \[P, Eqs. (18), (19)\] | 3 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// Those of [`accelerations_into`](Self::accelerations_into). `at` is then an empty workspace, without
    /// the results of earlier calls.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &PendulumState<T>,
        inputs_: &PendulumInputs<T>,
        at_: &mut PendulumWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let [_, _, _, _, _, n7_5_, n7_6_, n7_7_, _, n7_9_, n7_10_, _, _, _, _, n7_15_,
        n7_16_, _, _, _, n7_20_, n7_21_, n7_22_, _, _, _, n7_26_] = &mut at_.numbers;
        let c_ = T::constant;
        let [known_rod_mass_, known_rod_first_moment_x_, known_rod_inertia_xx_,
        known_rod_inertia_yy_, known_joint_d_inverse_, known_joint_d_scale_,
        known_joint_gain_fy_] = *self.changed_by_setters.derived();
        let [[joint_angle_]] = state_.q.data.0;
        let [[joint_rate_]] = state_.v.data.0;
        let joint_input0_ = inputs_.joint;
        at_.efforts.data.0 = [[joint_input0_]];
        *n7_5_ = T::negate(joint_input0_);
        *n7_20_ = joint_rate_;
        /// Kinematics of `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_joint_angle_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
        *n7_7_ = sin_joint_angle_;
        *n7_9_ = T::negate(sin_joint_angle_);
        *n7_6_ = cos_joint_angle_;
        *n7_10_ = cos_joint_angle_;
        ::mstmm::generated::store_fence();
        /// Loads on `rod`, [P, Eqs. (14), (15), (20)]: 2 mul, 0 add, 0 reciprocal.
        let t0_ = joint_rate_ * joint_rate_;
        /// Riccati transfer over `joint`, F = I a + p, [P, Eqs. (18), (19), (25), (35)]: 1 mul, 0 add, 0 reciprocal.
        let joint_u_over_d_ = joint_input0_ * known_joint_d_inverse_;
        /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 4 mul, 1 add, 0 reciprocal.
        let t1_ = cos_joint_angle_ * known_joint_gain_fy_;
        let joint_acc_lin_y_ = cos_joint_angle_ * c_(9.8);
        *n7_22_ = joint_acc_lin_y_;
        ::mstmm::generated::store_fence();
        /// Loads on `rod`.
        let minus_rod_velocity_wrench_fx_ = known_rod_first_moment_x_ * t0_;
        /// Results: 4 mul, 0 add, 0 reciprocal.
        let t3_ = known_rod_inertia_yy_ * t0_;
        /// Acceleration of `joint`.
        let joint_acc_lin_x_ = sin_joint_angle_ * c_(9.8);
        *n7_21_ = joint_acc_lin_x_;
        ::mstmm::generated::store_fence();
        /// Results.
        let t5_ = sin_joint_angle_ * known_rod_first_moment_x_;
        /// Acceleration of `joint`.
        let joint_acc_ang_z_ = T::mul_neg_add(c_(9.8), t1_, joint_u_over_d_);
        if !::mstmm::generated::pivots_ok::<
            T,
            _,
            _,
        >(
            [known_rod_inertia_yy_],
            [known_joint_d_scale_],
            [state_.t, state_.v.data.0[0][0], joint_acc_ang_z_],
        ) {
            let error_ = ::mstmm::generated::pivot_error::<
                Self,
                _,
            >(
                &["joint"],
                [known_rod_inertia_yy_],
                [known_joint_d_scale_],
                state_,
                inputs_,
            );
            ::mstmm::generated::reset(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        at_.accelerations.data.0 = [[joint_acc_ang_z_]];
        *n7_26_ = joint_acc_ang_z_;
        ::mstmm::generated::store_fence();
        /// Wrench in `joint`, [P, Eqs. (18), (19)]: 3 mul, 2 add, 0 reciprocal.
        let t2_ = known_rod_mass_ * joint_acc_lin_y_;
        /// Results.
        let t4_ = c_(0.5) * t3_;
        at_.kinetic_energy = t4_;
        ::mstmm::generated::store_fence();
        /// Wrench in `joint`.
        let joint_wrench_fx_ = T::mul_sub(
            known_rod_mass_,
            joint_acc_lin_x_,
            minus_rod_velocity_wrench_fx_,
        );
        *n7_15_ = joint_wrench_fx_;
        ::mstmm::generated::store_fence();
        /// Results.
        let t6_ = c_(9.8) * t5_;
        at_.potential_energy = t6_;
        ::mstmm::generated::store_fence();
        /// Wrench in `joint`.
        let joint_wrench_fy_ = T::mul_add(
            known_rod_first_moment_x_,
            joint_acc_ang_z_,
            t2_,
        );
        *n7_16_ = joint_wrench_fy_;
        ::core::result::Result::Ok(())
    }
    /// Returns kinetic and potential energy in J.
    ///
    /// The potential energy of gravity is zero if all centres of mass are at the inertial origin.
    ///
    /// 5 operations: 5 mul, 0 add, 0 reciprocal, 1 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Kinematics of `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Results |  | 5 | 0 | 0 | 0 | 0 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    #[must_use]
    pub fn energy(&self, state_: &PendulumState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [known_rod_mass_, known_rod_first_moment_x_, _, known_rod_inertia_yy_, ..] = *self
            .changed_by_setters
            .derived();
        let [[joint_angle_]] = state_.q.data.0;
        let [[joint_rate_]] = state_.v.data.0;
        /// Kinematics of `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_joint_angle_], [_]) = T::sin_cos([joint_angle_]);
        /// Results: 5 mul, 0 add, 0 reciprocal.
        let t0_ = joint_rate_ * joint_rate_;
        let t1_ = known_rod_inertia_yy_ * t0_;
        let t3_ = sin_joint_angle_ * known_rod_first_moment_x_;
        let t2_ = c_(0.5) * t1_;
        let t4_ = c_(9.8) * t3_;
        let energies_ = [t2_, t4_];
        let [kinetic_, potential_] = energies_;
        ::mstmm::Energy {
            kinetic: kinetic_,
            potential: potential_,
        }
    }
    /// Computes the time derivatives of the coordinates.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    #[inline]
    fn coordinate_rates_into_(
        &self,
        state_: &PendulumState<T>,
        coordinates_: &mut ::mstmm::nalgebra::SVector<T, 1>,
    ) -> () {
        let [[joint_rate_]] = state_.v.data.0;
        (*coordinates_).data.0 = [[joint_rate_]];
    }
    /// Returns the coordinates with normalised quaternions.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    #[inline]
    fn normalized_(&self, state_: &PendulumState<T>) -> [T; 1] {
        let [[joint_angle_]] = state_.q.data.0;
        let coordinates_ = [joint_angle_];
        coordinates_
    }
    /// Returns the state at the start of the description, at time zero.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    #[must_use]
    pub fn initial_state(&self) -> PendulumState<T> {
        let c_ = T::constant;
        let coordinates_ = [c_(-1.5707963267948966)];
        let rates_ = [c_(0.0)];
        PendulumState {
            q: ::mstmm::generated::vector(coordinates_),
            v: ::mstmm::generated::vector(rates_),
            t: T::constant(0.0),
        }
    }
    /// Returns the accelerations `v̇` of all hinges; see [`accelerations_into`](Self::accelerations_into).
    ///
    /// # Errors
    ///
    /// Those of [`accelerations_into`](Self::accelerations_into).
    #[inline]
    pub fn accelerations(
        &self,
        state_: &PendulumState<T>,
        inputs_: &PendulumInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 1>, ::mstmm::Error> {
        let mut rates_ = ::mstmm::generated::vector([T::constant(0.0); 1]);
        self.accelerations_into(state_, inputs_, &mut rates_)?;
        ::core::result::Result::Ok(rates_)
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
        state_: &PendulumState<T>,
        inputs_: &PendulumInputs<T>,
        rate_: &mut PendulumState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state_: &PendulumState<T>,
        rate_: &mut PendulumState<T>,
    ) {
        self.coordinate_rates_into_(state_, &mut rate_.q);
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut PendulumState<T>) {
        state_.q.data.0 = [self.normalized_(state_)];
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
        state_: &PendulumState<T>,
        inputs_: &PendulumInputs<T>,
        at_: &mut PendulumWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn energy(&self, state_: &PendulumState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
    }
}
::mstmm::generated::not_asked! {
    Pendulum rod_jacobian rod_jacobian_into
}
/// The state of [`Pendulum`]: coordinates, rates and time.
///
/// The entries of all hinges are in the order of the route. The floating base comes first, if there
/// is one. Hinges with a prescribed motion have no entries.
///
/// | hinge | indices in `q` | indices in `v` |
/// |---|---|---|
/// | `joint` | 0 | 0 |
///
/// [`Default`] is the start of the description with default parameters, at time zero.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumState<T> {
    /// The coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    #[doc(alias("generalized coordinates", "qpos", "configuration", "nq"))]
    pub q: ::mstmm::nalgebra::SVector<T, 1>,
    /// The rates in rad/s and m/s.
    #[doc(alias("generalized velocities", "qvel", "nv"))]
    pub v: ::mstmm::nalgebra::SVector<T, 1>,
    /// The time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> PendulumState<T> {
    /// Returns coordinates and rates of hinge `joint`.
    #[inline]
    #[must_use]
    pub fn joint(&self) -> ::mstmm::PinState<T> {
        let [[q0_, ..]] = self.q.data.0;
        let [[v0_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0_, v0_)
    }
    /// Returns coordinates and rates of hinge `joint`, for writing.
    #[inline]
    pub fn joint_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0_, ..]] = &mut self.q.data.0;
        let [[v0_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0_, v0_)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for PendulumState<T> {
    fn default() -> Self {
        Pendulum::new().initial_state()
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for PendulumState<T> {
    type Scalar = T;
    fn zero_position() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector([zero_]),
            v: ::mstmm::generated::vector([zero_; 1]),
            t: zero_,
        }
    }
    #[inline]
    fn coordinates(&self) -> &[T] {
        self.q.as_slice()
    }
    #[inline]
    fn coordinates_mut(&mut self) -> &mut [T] {
        self.q.as_mut_slice()
    }
    #[inline]
    fn rates(&self) -> &[T] {
        self.v.as_slice()
    }
    #[inline]
    fn rates_mut(&mut self) -> &mut [T] {
        self.v.as_mut_slice()
    }
    #[inline]
    fn time(&self) -> T {
        self.t
    }
    #[inline]
    fn set_time(&mut self, time_: T) {
        self.t = time_;
    }
}
/// The inputs of [`Pendulum`]: what acts on it from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumInputs<T> {
    /// The efforts of the motor of `joint` in N m, in the order of its rates.
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
    /// Returns inputs that are all zero; prescribed motions are at rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> PendulumInputs<T> {
        ::core::default::Default::default()
    }
}
/// The results of [`Pendulum::solve_into`]: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
#[derive(Clone, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct PendulumWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 1>,
    efforts: ::mstmm::nalgebra::SVector<T, 1>,
    kinetic_energy: T,
    potential_energy: T,
    numbers: [T; 27],
    base_acceleration: [T; 3],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> PendulumWorkspace<T> {
    /// Returns the accelerations `v̇` of all hinges, in the order of `v` of the state, in rad/s² and m/s².
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 1> {
        &self.accelerations
    }
    /// Returns the kinetic energy in J.
    #[inline]
    pub fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Returns the potential energy in J of gravity and springs.
    ///
    /// That of gravity is zero if all centres of mass are at the inertial origin.
    #[inline]
    pub fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// Returns all connection points in the order of the route: the input of the first element, then the
    /// output of every element, which is the input of the next element.
    #[inline]
    pub fn points(&self) -> [::mstmm::Point<T>; 3] {
        [self.point_(0), self.point_(1), self.point_(2)]
    }
    /// Where every point of the model has its numbers.
    const PLACES_: [::mstmm::generated::PointSlots<3, 6>; 3] = [
        ::mstmm::generated::PointSlots::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([0, 0, 0], 1),
                ([0, 0, 0], 0),
                ([7, 10, 13], 4),
                ([7, 10, 13], 16),
            ],
        ),
        ::mstmm::generated::PointSlots::new(
            0,
            [7, 10, 13],
            [
                ([0, 0, 0], 0),
                ([7, 10, 13], 19),
                ([7, 10, 13], 22),
                ([7, 10, 13], 25),
                ([7, 10, 13], 4),
                ([7, 10, 13], 16),
            ],
        ),
        ::mstmm::generated::PointSlots::new(
            0,
            [7, 10, 13],
            [
                ([0, 0, 0], 0),
                ([7, 10, 13], 19),
                ([7, 10, 13], 22),
                ([7, 10, 13], 25),
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
            ],
        ),
    ];
    /// Connection point number `index`.
    #[inline(always)]
    fn point_(&self, index_: ::core::primitive::usize) -> ::mstmm::Point<T> {
        let (model_, numbers_) = (index_, &self.numbers[..]);
        <::mstmm::Point<
            T,
        >>::read(numbers_, Self::PLACES_.as_slice().get(model_), self.base_acceleration)
    }
    /// Returns acceleration, effort, input and output of hinge `joint`.
    #[inline]
    pub fn joint(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::Point<T>> {
        let (input_, output_) = (self.point_(0), self.point_(1));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::segment::<
                    _,
                    1,
                    0,
                >(&self.accelerations);
                value_
            },
            {
                let [value_] = ::mstmm::generated::segment::<_, 1, 0>(&self.efforts);
                value_
            },
            input_,
            output_,
        )
    }
    /// Returns the results at body `rod`: input and centre of mass.
    #[inline]
    pub fn rod(
        &self,
    ) -> ::mstmm::BodyResult<
        T,
        ::mstmm::Point<T>,
        ::mstmm::OptionalPoints<false, true>,
    > {
        let (input_, output_) = (self.point_(1), self.point_(2));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.5f64), T::constant(0f64), T::constant(0f64)],
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::fmt::Debug for PendulumWorkspace<T> {
    fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
        to_.debug_struct("PendulumWorkspace")
            .field("accelerations", &self.accelerations)
            .field("efforts", &self.efforts)
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
            .field("points", &self.points())
            .finish()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Pendulum<T> {
    /// Returns an empty workspace for [`solve_into`](Self::solve_into). Its contents are unspecified until then.
    #[must_use]
    #[allow(clippy::all)]
    pub fn workspace(&self) -> PendulumWorkspace<T> {
        let zero_ = T::constant(0.0);
        PendulumWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 1]),
            efforts: ::mstmm::generated::vector([zero_; 1]),
            kinetic_energy: T::constant(0f64),
            potential_energy: T::constant(0f64),
            numbers: ::mstmm::generated::with_constants(
                [T::constant(0.0); 27],
                &[(1, T::constant(9.8f64)), (14, T::constant(1f64))],
            ),
            base_acceleration: ::mstmm::generated::with_constants(
                [T::constant(0.0); 3],
                &[(1, T::constant(9.8f64))],
            ),
        }
    }
}
#[allow(clippy::all)]
impl<T: ::mstmm::Scalar> ::mstmm::Described for Pendulum<T> {
    const DESCRIPTION: &'static ::mstmm::Description = &{
        use ::mstmm::generated::description::*;
        const PIN_: Shape_ = shape_("pin", &[turning_("angle", "rate", "")]);
        const BODY0_: Inertia_ = diag_(
            1.5,
            [0.5, 0.0, 0.0],
            [0.01, 0.08333333333333333, 0.08333333333333333],
            true,
        );
        describe_("Pendulum", "A rod on a motor.", 3)
            .hinged(
                &[
                    PIN_
                        .named("joint")
                        .starting(&[-1.5707963267948966], &[0.0])
                        .between(0, 1)
                        .about(&[[0.0, 0.0, 1.0]]),
                ],
            )
            .bodied(&[BODY0_.named("rod", "Rod")])
            .connected(&["joint.input", "rod.input", "rod.output"])
            .driven(&[torque_("joint", "")])
            .changed(&[parameter_("payload", "kg", 0.5)])
    };
    fn arrays_(
        at_: &PendulumWorkspace<T>,
    ) -> ::mstmm::generated::description::Arrays_<'_, T> {
        ::mstmm::generated::description::Arrays_ {
            accelerations: at_.accelerations.as_slice(),
            efforts: at_.efforts.as_slice(),
            energy: ::core::option::Option::Some(::mstmm::Energy {
                kinetic: at_.kinetic_energy,
                potential: at_.potential_energy,
            }),
            springs: &[],
            base_acceleration: &at_.base_acceleration,
        }
    }
    fn point_(
        at_: &PendulumWorkspace<T>,
        index_: ::core::primitive::usize,
    ) -> ::mstmm::generated::description::PointResult_<T> {
        ::core::convert::From::from(at_.point_(index_))
    }
    fn change_inertia_(&self, it_: &mut ::mstmm::generated::description::Inertia_<T>) {
        let parameters_ = self.parameters();
        match it_.row {
            0 => {
                it_.mass = (T::constant(1f64) + parameters_.payload);
            }
            _ => {}
        }
    }
    fn copy_inputs_(
        inputs_: &mut PendulumInputs<T>,
        mut values_: ::mstmm::generated::Values<'_, T>,
    ) {
        values_.once(&mut inputs_.joint);
    }
    fn parameter_(&self, row_: ::core::primitive::usize) -> &[T] {
        ::mstmm::generated::ParameterRows::row_(self.parameters(), row_)
    }
    fn set_parameter_(
        &mut self,
        row_: ::core::primitive::usize,
        value_: (::core::primitive::usize, T),
    ) -> ::mstmm::generated::description::Set_ {
        match row_ {
            0 => self.set_payload(value_.1),
            _ => ::mstmm::generated::description::no_parameter_(),
        }
    }
}
#[allow(clippy::all, unused_imports, unused_variables)]
impl<T: ::mstmm::Scalar> ::mstmm::Answers for Pendulum<T> {
    const FRAMES_: &'static [&'static [&'static ::core::primitive::str]] = &[
        &["input", "com"],
    ];
}
impl<T: ::mstmm::Scalar> ::mstmm::generated::ParameterRows<T> for PendulumParameters<T> {
    fn row_(&self, row_: ::core::primitive::usize) -> &[T] {
        match row_ {
            0 => ::core::slice::from_ref(&self.payload),
            _ => &[],
        }
    }
}
::mstmm::formats_of_chain_! {
    Pendulum PendulumState 3 PendulumInputs 1 PendulumParameters 1
}
const _: () = {
    #[allow(dead_code)]
    fn methods<T: ::mstmm::Scalar>() {
        let _ = PendulumWorkspace::<T>::joint;
        let _ = PendulumParameters::<T>::payload;
    }
};
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Rod;
    const _: Rod = Rod;
    use ::mstmm::keywords::unique::*;
    type Keywords_ = (
        pin,
        gravity,
        mass,
        com,
        inertia,
        start,
        torque,
        m,
        s,
        kg,
        kg,
        m,
        kg,
        m,
        deg,
    );
};
