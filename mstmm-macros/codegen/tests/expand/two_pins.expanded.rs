/// Two rods in a plane, by the forward product.
///
/// # The chain
///
/// `ground -> pin shoulder -> upper -> pin elbow -> lower`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 472 303" width="472" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 281l12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="40.2" y="294.4" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 281l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="262.9" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M22 281l-12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="3.8" y="294.4" font-size="10" opacity="0.6" text-anchor="middle">z</text>
/// <path d="M36.0 36.0L236.0 151.5" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M36.0 36.0L136.0 93.7L236.0 151.5" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="136.0" cy="93.7" r="3" fill="#3a87c8"/>
/// <path d="M236.0 151.5L436.0 266.9" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M236.0 151.5L336.0 209.2L436.0 266.9" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="336.0" cy="209.2" r="3" fill="#3a87c8"/>
/// <path d="M22.0 45.0h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="36.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="236.0" cy="151.5" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <text x="44.0" y="28.0">shoulder</text>
/// <text x="136.0" y="113.7" text-anchor="middle" font-style="italic">upper</text>
/// <text x="244.0" y="143.5">elbow</text>
/// <text x="336.0" y="229.2" text-anchor="middle" font-style="italic">lower</text>
/// </svg>
///
/// | element | what it is | freedoms |
/// |---|---|---|
/// | `shoulder` | pin(z) | 1 |
/// | `upper` | body `Rod`, 1 kg |  |
/// | `elbow` | pin(z) | 1 |
/// | `lower` | body `Rod`, 1 kg |  |
///
/// Mobility 2: 2 degrees of freedom.
///
/// Accelerations by `transfer`, 122 operations (69 mul, 48 add, 3 reciprocal, 2 square root, 2 sin/cos); with everything at every connection point 172 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPins<T> {
    parameters: TwoPinsParameters<T>,
    derived: [T; 0],
}
/// Numbers of [`TwoPins`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsParameters<T> {}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters_ = TwoPinsParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain_, _) = Self::derive(parameters_);
        chain_
    }
    /// The numbers that may change at run time.
    #[inline]
    pub fn parameters(&self) -> &TwoPinsParameters<T> {
        &self.parameters
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> TwoPinsState<T> {
        let c_ = T::constant;
        TwoPinsState {
            q: ::mstmm::generated::vector([c_(0.0), c_(0.0)]),
            v: ::mstmm::generated::vector([c_(0.0), c_(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters_: TwoPinsParameters<T>) -> (Self, [T; 0]) {
        let (derived_, checks_) = ([], []);
        (
            Self {
                parameters: parameters_,
                derived: derived_,
            },
            checks_,
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPins<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 122 operations: 69 mul, 48 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 1 | 1 | 0 | 0 | 0 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 54 | 39 | 3 | 2 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 7 | 5 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if nothing with inertia lies beyond a
    /// hinge, `Error::NotFinite` if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 1 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 54 mul, 39 add, 3 reciprocal, 2 square root.
        let t7_ = elbow_omega_z_ * elbow_omega_z_;
        let t8_ = c_(0.5) * t7_;
        let t24_ = T::mul_add(
            sin_elbow_angle_,
            c_(0.48639392383214375),
            sin_elbow_angle_,
        );
        let t15_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t26_ = T::mul_add(cos_elbow_angle_, c_(0.5), c_(0.4931969619160719));
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 7 mul, 5 add, 0 reciprocal.
        let elbow_a4_lin_y_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(0.013606076167856269),
            cos_elbow_angle_,
        );
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        /// Boundary solve at the far end.
        let t18_ = T::mul_neg_add(
            sin_elbow_angle_,
            c_(0.16439898730535732),
            sin_elbow_angle_,
        );
        let t16_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(2.0685934174848226),
            cos_elbow_angle_,
        );
        /// Transfer to `elbow`.
        let t6_ = cos_elbow_angle_ * c_(0.16439898730535732);
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t0_ = sin_elbow_angle_ * sin_elbow_angle_;
        /// Boundary solve at the far end.
        let t25_ = T::mul_sub(sin_elbow_angle_, c_(0.17120202538928544), t24_);
        let t27_ = T::mul_sub(cos_elbow_angle_, c_(0.17120202538928544), t26_);
        let t14_ = T::mul_add(c_(0.5), elbow_a4_lin_y_, c_(0.3287979746107146));
        let t9_ = T::mul_sub(minus_elbow_centripetal_x_, c_(0.5), shoulder_a_lin_x_);
        /// Transfer to `elbow`.
        let t1_ = minus_elbow_centripetal_x_ - shoulder_a_lin_x_;
        /// Boundary solve at the far end.
        let t10_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        /// Transfer to `elbow`.
        let t4_ = T::mul_neg_add(cos_shoulder_angle_, c_(4.9), shoulder_a_lin_y_);
        /// Boundary solve at the far end.
        let t19_ = T::mul_sub(sin_elbow_angle_, c_(2.0685934174848226), t18_);
        /// Transfer to `elbow`.
        let t2_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        /// Boundary solve at the far end.
        let t29_ = T::mul_add(t25_, t25_, t15_);
        /// Inertia beyond the hinges, to be divided by.
        let shoulder_d_ = T::mul_add(t0_, c_(0.75), c_(0.5833333333333333));
        /// Boundary solve at the far end.
        let t28_ = elbow_a4_lin_y_ - t27_;
        let t47_ = t14_ * t25_;
        let t17_ = t9_ + t1_;
        let t11_ = sin_elbow_angle_ * t9_;
        /// Transfer to `elbow`.
        let t5_ = t4_ * c_(0.9863939238321437);
        /// Boundary solve at the far end.
        let t12_ = t4_ * c_(0.054054054054054064);
        /// Transfer to `elbow`.
        let t3_ = T::mul_add(sin_elbow_angle_, t1_, t2_);
        /// Boundary solve at the far end.
        let t30_ = T::sqrt(t29_);
        let t37_ = t25_ * t28_;
        let t20_ = T::mul_add(cos_elbow_angle_, t17_, t8_);
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t74_ = t4_ * c_(1.9863939238321437);
        /// Boundary solve at the far end.
        let t42_ = T::mul_neg_add(t4_, c_(0.0810810810810811), t11_);
        let t44_ = T::mul_add(t5_, t16_, t2_);
        /// Transfer to `elbow`.
        let elbow_a_lin_y_ = T::mul_neg_add(t5_, t6_, t3_);
        /// Boundary solve at the far end.
        let t21_ = t10_ - t20_;
        let t43_ = elbow_a_lin_y_ + t42_;
        let t22_ = t10_ + t21_;
        let t13_ = T::mul_sub(c_(0.5), elbow_a_lin_y_, t12_);
        let t23_ = T::mul_sub(t5_, t19_, t22_);
        let t31_ = T::copysign(t30_, cos_elbow_angle_);
        let t32_ = cos_elbow_angle_ + t31_;
        let t33_ = t31_ * t32_;
        let t38_ = T::mul_add(sin_elbow_angle_, t32_, t37_);
        let t34_ = T::recip(t33_);
        let t39_ = t34_ * t38_;
        let t48_ = t34_ * t47_;
        let t35_ = t32_ * t34_;
        let t41_ = T::mul_neg_add(t25_, t39_, t28_);
        let t50_ = T::mul_neg_add(t25_, t48_, t14_);
        let t36_ = t23_ * t35_;
        let t40_ = T::mul_neg_add(t32_, t39_, sin_elbow_angle_);
        let t49_ = t32_ * t48_;
        let t51_ = T::mul_add(t41_, t41_, c_(0.25));
        let t71_ = t32_ * t36_;
        let t45_ = T::mul_add(t36_, t40_, t44_);
        let t63_ = T::mul_neg_add(t36_, t49_, t13_);
        let t52_ = T::sqrt(t51_);
        let t46_ = t43_ + t45_;
        let t53_ = T::copysign(t52_, -t41_);
        let t54_ = t41_ - t53_;
        let t55_ = t53_ * t54_;
        let t59_ = T::mul_add(t50_, t54_, c_(0.16666666666666666));
        let t56_ = T::recip(t55_);
        let t60_ = t56_ * t59_;
        let t57_ = t54_ * t56_;
        let t62_ = T::mul_add(c_(0.5), t60_, c_(0.3333333333333333));
        let t58_ = t46_ * t57_;
        let t61_ = T::mul_add(t54_, t60_, t50_);
        let t65_ = T::recip(t62_);
        let t67_ = t54_ * t58_;
        let t64_ = T::mul_sub(t58_, t61_, t63_);
        let t66_ = t64_ * t65_;
        let t68_ = T::mul_neg_add(c_(0.5), t66_, t67_);
        let t69_ = t56_ * t68_;
        let t70_ = T::mul_add(t54_, t69_, t58_);
        let end_x5_ = T::mul_neg_add(c_(0.5), t69_, t66_);
        let t72_ = T::mul_neg_add(t25_, t70_, t71_);
        let t73_ = t34_ * t72_;
        let minus_end_x4_ = T::mul_add(t25_, t73_, t70_);
        /// Back to `shoulder`.
        let t75_ = T::mul_neg_add(c_(0.16666666666666669), minus_end_x4_, t74_);
        let minus_shoulder_beta0_ = T::mul_add(
            c_(0.0816364570071376),
            t75_,
            minus_end_x4_,
        );
        ::mstmm::generated::finite::<T>(&[&[state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [-minus_shoulder_beta0_, end_x5_],
        )?;
        accelerations_.data.0 = [[-minus_shoulder_beta0_, end_x5_]];
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
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 2>, ::mstmm::Error> {
        let mut accelerations_ = ::mstmm::generated::vector([T::constant(0.0); 2]);
        self.accelerations_into(state_, inputs_, &mut accelerations_)?;
        ::core::result::Result::Ok(accelerations_)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 172 operations: 95 mul, 72 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 9 | 3 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 7 | 5 | 0 | 0 | 0 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 54 | 39 | 3 | 2 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    /// | Point of `elbow` | \[P, Eqs. (12), (13), (36)\] | 2 | 3 | 0 | 0 | 0 |
    /// | Load of the body at `shoulder` | \[P, Eqs. (18), (19)\] | 1 | 0 | 0 | 0 | 0 |
    /// | Load of the body at `elbow` | \[P, Eqs. (18), (19)\] | 9 | 8 | 0 | 0 | 0 |
    /// | Load on `shoulder` | \[P, Eqs. (18), (19)\] | 0 | 3 | 0 | 0 | 0 |
    /// | Results |  | 6 | 8 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        at_: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let [point0_, point1_, point2_, point3_, point4_] = &mut at_.points;
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 9 mul, 3 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t0_ = sin_elbow_angle_ * sin_elbow_angle_;
        let shoulder_d_ = T::mul_add(t0_, c_(0.75), c_(0.5833333333333333));
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 7 mul, 5 add, 0 reciprocal.
        let elbow_a4_lin_y_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(0.013606076167856269),
            cos_elbow_angle_,
        );
        let t1_ = minus_elbow_centripetal_x_ - shoulder_a_lin_x_;
        let t2_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        let t3_ = T::mul_add(sin_elbow_angle_, t1_, t2_);
        let t4_ = T::mul_neg_add(cos_shoulder_angle_, c_(4.9), shoulder_a_lin_y_);
        let t5_ = t4_ * c_(0.9863939238321437);
        let t6_ = cos_elbow_angle_ * c_(0.16439898730535732);
        let elbow_a_lin_y_ = T::mul_neg_add(t5_, t6_, t3_);
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 54 mul, 39 add, 3 reciprocal, 2 square root.
        let t7_ = elbow_omega_z_ * elbow_omega_z_;
        let t8_ = c_(0.5) * t7_;
        let t9_ = T::mul_sub(minus_elbow_centripetal_x_, c_(0.5), shoulder_a_lin_x_);
        let t10_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        let t11_ = sin_elbow_angle_ * t9_;
        let t12_ = t4_ * c_(0.054054054054054064);
        let t13_ = T::mul_sub(c_(0.5), elbow_a_lin_y_, t12_);
        let t14_ = T::mul_add(c_(0.5), elbow_a4_lin_y_, c_(0.3287979746107146));
        let t15_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t16_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(2.0685934174848226),
            cos_elbow_angle_,
        );
        let t17_ = t9_ + t1_;
        let t18_ = T::mul_neg_add(
            sin_elbow_angle_,
            c_(0.16439898730535732),
            sin_elbow_angle_,
        );
        let t19_ = T::mul_sub(sin_elbow_angle_, c_(2.0685934174848226), t18_);
        let t20_ = T::mul_add(cos_elbow_angle_, t17_, t8_);
        let t21_ = t10_ - t20_;
        let t22_ = t10_ + t21_;
        let t23_ = T::mul_sub(t5_, t19_, t22_);
        let t24_ = T::mul_add(
            sin_elbow_angle_,
            c_(0.48639392383214375),
            sin_elbow_angle_,
        );
        let t25_ = T::mul_sub(sin_elbow_angle_, c_(0.17120202538928544), t24_);
        let t26_ = T::mul_add(cos_elbow_angle_, c_(0.5), c_(0.4931969619160719));
        let t27_ = T::mul_sub(cos_elbow_angle_, c_(0.17120202538928544), t26_);
        let t28_ = elbow_a4_lin_y_ - t27_;
        let t29_ = T::mul_add(t25_, t25_, t15_);
        let t30_ = T::sqrt(t29_);
        let t31_ = T::copysign(t30_, cos_elbow_angle_);
        let t32_ = cos_elbow_angle_ + t31_;
        let t33_ = t31_ * t32_;
        let t34_ = T::recip(t33_);
        let t35_ = t32_ * t34_;
        let t36_ = t23_ * t35_;
        let t37_ = t25_ * t28_;
        let t38_ = T::mul_add(sin_elbow_angle_, t32_, t37_);
        let t39_ = t34_ * t38_;
        let t40_ = T::mul_neg_add(t32_, t39_, sin_elbow_angle_);
        let t41_ = T::mul_neg_add(t25_, t39_, t28_);
        let t42_ = T::mul_neg_add(t4_, c_(0.0810810810810811), t11_);
        let t43_ = elbow_a_lin_y_ + t42_;
        let t44_ = T::mul_add(t5_, t16_, t2_);
        let t45_ = T::mul_add(t36_, t40_, t44_);
        let t46_ = t43_ + t45_;
        let t47_ = t14_ * t25_;
        let t48_ = t34_ * t47_;
        let t49_ = t32_ * t48_;
        let t50_ = T::mul_neg_add(t25_, t48_, t14_);
        let t51_ = T::mul_add(t41_, t41_, c_(0.25));
        let t52_ = T::sqrt(t51_);
        let t53_ = T::copysign(t52_, -t41_);
        let t54_ = t41_ - t53_;
        let t55_ = t53_ * t54_;
        let t56_ = T::recip(t55_);
        let t57_ = t54_ * t56_;
        let t58_ = t46_ * t57_;
        let t59_ = T::mul_add(t50_, t54_, c_(0.16666666666666666));
        let t60_ = t56_ * t59_;
        let t61_ = T::mul_add(t54_, t60_, t50_);
        let t62_ = T::mul_add(c_(0.5), t60_, c_(0.3333333333333333));
        let t63_ = T::mul_neg_add(t36_, t49_, t13_);
        let t64_ = T::mul_sub(t58_, t61_, t63_);
        let t65_ = T::recip(t62_);
        let t66_ = t64_ * t65_;
        let t67_ = t54_ * t58_;
        let t68_ = T::mul_neg_add(c_(0.5), t66_, t67_);
        let t69_ = t56_ * t68_;
        let t70_ = T::mul_add(t54_, t69_, t58_);
        let t71_ = t32_ * t36_;
        let t72_ = T::mul_neg_add(t25_, t70_, t71_);
        let t73_ = t34_ * t72_;
        let minus_end_x4_ = T::mul_add(t25_, t73_, t70_);
        let end_x5_ = T::mul_neg_add(c_(0.5), t69_, t66_);
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t74_ = t4_ * c_(1.9863939238321437);
        let t75_ = T::mul_neg_add(c_(0.16666666666666669), minus_end_x4_, t74_);
        let minus_shoulder_beta0_ = T::mul_add(
            c_(0.0816364570071376),
            t75_,
            minus_end_x4_,
        );
        ::mstmm::generated::finite::<T>(&[&[state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [-minus_shoulder_beta0_, end_x5_],
        )?;
        at_.efforts.data.0 = [[c_(0.0), c_(0.0)]];
        point0_.set_position([c_(0.0), c_(0.0), c_(0.0)]);
        point0_
            .set_orientation([
                c_(1.0),
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
            ]);
        point0_.set_velocity([c_(0.0), c_(0.0), c_(0.0)]);
        point0_.set_angular_velocity([c_(0.0), c_(0.0), c_(0.0)]);
        point0_.set_acceleration([c_(0.0), c_(0.0), c_(0.0)]);
        point0_.set_angular_acceleration([c_(0.0), c_(0.0), c_(0.0)]);
        point0_.set_moment([c_(0.0), c_(0.0), c_(0.0)]);
        point1_.set_position([c_(0.0), c_(0.0), c_(0.0)]);
        point1_
            .set_orientation([
                cos_shoulder_angle_,
                -sin_shoulder_angle_,
                c_(0.0),
                sin_shoulder_angle_,
                cos_shoulder_angle_,
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
            ]);
        point1_.set_velocity([c_(0.0), c_(0.0), c_(0.0)]);
        point1_.set_angular_velocity([c_(0.0), c_(0.0), shoulder_rate_]);
        point1_.set_acceleration([c_(0.0), c_(0.0), c_(0.0)]);
        point1_.set_moment([c_(0.0), c_(0.0), c_(0.0)]);
        point2_.set_position([cos_shoulder_angle_, sin_shoulder_angle_, c_(0.0)]);
        point2_
            .set_orientation([
                cos_shoulder_angle_,
                -sin_shoulder_angle_,
                c_(0.0),
                sin_shoulder_angle_,
                cos_shoulder_angle_,
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
            ]);
        point2_.set_angular_velocity([c_(0.0), c_(0.0), shoulder_rate_]);
        point2_.set_moment([c_(0.0), c_(0.0), c_(0.0)]);
        point3_.set_position([cos_shoulder_angle_, sin_shoulder_angle_, c_(0.0)]);
        point3_.set_angular_velocity([c_(0.0), c_(0.0), elbow_omega_z_]);
        point3_.set_moment([c_(0.0), c_(0.0), c_(0.0)]);
        point4_.set_angular_velocity([c_(0.0), c_(0.0), elbow_omega_z_]);
        point4_.set_moment([c_(0.0), c_(0.0), c_(0.0)]);
        point4_.set_force([c_(0.0), c_(0.0), c_(0.0)]);
        at_.accelerations.data.0 = [[-minus_shoulder_beta0_, end_x5_]];
        at_.rate_accelerations.data.0 = [[-minus_shoulder_beta0_, end_x5_]];
        point1_.set_angular_acceleration([c_(0.0), c_(0.0), -minus_shoulder_beta0_]);
        point2_.set_angular_acceleration([c_(0.0), c_(0.0), -minus_shoulder_beta0_]);
        /// Motion across `elbow`.
        let t76_ = cos_shoulder_angle_ * cos_elbow_angle_;
        let elbow_axes_x_x_ = T::mul_neg_add(
            sin_shoulder_angle_,
            sin_elbow_angle_,
            t76_,
        );
        let t77_ = cos_shoulder_angle_ * sin_elbow_angle_;
        let minus_elbow_axes_x_y_ = T::mul_add(
            sin_shoulder_angle_,
            cos_elbow_angle_,
            t77_,
        );
        point3_
            .set_orientation([
                elbow_axes_x_x_,
                -minus_elbow_axes_x_y_,
                c_(0.0),
                minus_elbow_axes_x_y_,
                elbow_axes_x_x_,
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
            ]);
        point4_
            .set_orientation([
                elbow_axes_x_x_,
                -minus_elbow_axes_x_y_,
                c_(0.0),
                minus_elbow_axes_x_y_,
                elbow_axes_x_x_,
                c_(0.0),
                c_(0.0),
                c_(0.0),
                c_(1.0),
            ]);
        let t78_ = shoulder_rate_ * cos_shoulder_angle_;
        let minus_elbow_centripetal_x_2_ = shoulder_rate_ * t78_;
        let t79_ = shoulder_rate_ * sin_shoulder_angle_;
        point2_.set_velocity([-t79_, t78_, c_(0.0)]);
        point3_.set_velocity([-t79_, t78_, c_(0.0)]);
        let minus_elbow_centripetal_y_ = shoulder_rate_ * t79_;
        /// Point of `elbow`, [P, Eqs. (12), (13), (36)]: 2 mul, 3 add, 0 reciprocal.
        let minus_elbow_acc_lin_x_ = T::mul_neg_add(
            sin_shoulder_angle_,
            minus_shoulder_beta0_,
            minus_elbow_centripetal_x_2_,
        );
        let minus_elbow_acc_lin_y_ = T::mul_add(
            cos_shoulder_angle_,
            minus_shoulder_beta0_,
            minus_elbow_centripetal_y_,
        );
        point2_
            .set_acceleration([
                -minus_elbow_acc_lin_x_,
                -minus_elbow_acc_lin_y_,
                c_(0.0),
            ]);
        point3_
            .set_acceleration([
                -minus_elbow_acc_lin_x_,
                -minus_elbow_acc_lin_y_,
                c_(0.0),
            ]);
        let elbow_acc_ang_z_ = end_x5_ - minus_shoulder_beta0_;
        point3_.set_angular_acceleration([c_(0.0), c_(0.0), elbow_acc_ang_z_]);
        point4_.set_angular_acceleration([c_(0.0), c_(0.0), elbow_acc_ang_z_]);
        /// Load of the body at `shoulder`, [P, Eqs. (18), (19)]: 1 mul, 0 add, 0 reciprocal.
        let minus_shoulder_own_force_x_ = c_(0.5) * minus_elbow_acc_lin_x_;
        /// Load of the body at `elbow`, [P, Eqs. (18), (19)]: 9 mul, 8 add, 0 reciprocal.
        let t80_ = elbow_omega_z_ * elbow_axes_x_x_;
        let t81_ = elbow_omega_z_ * t80_;
        let t82_ = T::mul_add(minus_elbow_axes_x_y_, elbow_acc_ang_z_, t81_);
        let t83_ = minus_elbow_acc_lin_x_ + t82_;
        let minus_elbow_own_force_x_ = T::mul_add(
            c_(0.5),
            t83_,
            minus_shoulder_own_force_x_,
        );
        let t84_ = elbow_omega_z_ * minus_elbow_axes_x_y_;
        let t85_ = elbow_omega_z_ * t84_;
        let t86_ = c_(9.8) - minus_elbow_acc_lin_y_;
        let t87_ = c_(0.5) * t86_;
        let t88_ = T::mul_neg_add(elbow_axes_x_x_, elbow_acc_ang_z_, t85_);
        let t89_ = minus_elbow_acc_lin_y_ + t88_;
        point4_.set_acceleration([-t83_, -t89_, c_(0.0)]);
        let t90_ = c_(9.8) - t89_;
        let elbow_own_force_y_ = T::mul_add(c_(0.5), t90_, t87_);
        point2_.set_force([-minus_elbow_own_force_x_, elbow_own_force_y_, c_(0.0)]);
        point3_.set_force([-minus_elbow_own_force_x_, elbow_own_force_y_, c_(0.0)]);
        /// Load on `shoulder`, [P, Eqs. (18), (19)]: 0 mul, 3 add, 0 reciprocal.
        let minus_shoulder_load_force_x_ = minus_shoulder_own_force_x_
            + minus_elbow_own_force_x_;
        let t91_ = c_(4.9) + t87_;
        let shoulder_load_force_y_ = elbow_own_force_y_ + t91_;
        point0_
            .set_force([-minus_shoulder_load_force_x_, shoulder_load_force_y_, c_(0.0)]);
        point1_
            .set_force([-minus_shoulder_load_force_x_, shoulder_load_force_y_, c_(0.0)]);
        /// Results: 6 mul, 8 add, 0 reciprocal.
        let t92_ = t79_ + t84_;
        let t93_ = t78_ + t80_;
        point4_.set_velocity([-t92_, t93_, c_(0.0)]);
        let t94_ = c_(0.5) * t92_;
        let t95_ = c_(0.5) * t93_;
        let t96_ = minus_elbow_centripetal_x_ + t7_;
        let t97_ = c_(0.16666666666666666) * t96_;
        let t98_ = T::mul_add(t79_, t94_, t97_);
        let t99_ = T::mul_add(t78_, t95_, t98_);
        at_.kinetic_energy = t99_;
        let t100_ = sin_shoulder_angle_ + minus_elbow_axes_x_y_;
        let t101_ = T::mul_add(c_(4.9), t100_, shoulder_a_lin_x_);
        at_.potential_energy = t101_;
        let t102_ = cos_shoulder_angle_ + elbow_axes_x_x_;
        point4_.set_position([t102_, t100_, c_(0.0)]);
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 26 operations: 17 mul, 9 add, 0 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 5 | 3 | 0 | 0 | 0 |
    /// | Results |  | 12 | 6 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state_: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 5 mul, 3 add, 0 reciprocal.
        let t0_ = cos_shoulder_angle_ * cos_elbow_angle_;
        let elbow_axes_x_x_ = T::mul_neg_add(sin_shoulder_angle_, sin_elbow_angle_, t0_);
        let t1_ = cos_shoulder_angle_ * sin_elbow_angle_;
        let minus_elbow_axes_x_y_ = T::mul_add(
            sin_shoulder_angle_,
            cos_elbow_angle_,
            t1_,
        );
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        /// Motion across `elbow`.
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Results: 12 mul, 6 add, 0 reciprocal.
        let t2_ = shoulder_rate_ * sin_shoulder_angle_;
        let t3_ = shoulder_rate_ * cos_shoulder_angle_;
        let t4_ = T::mul_add(elbow_omega_z_, minus_elbow_axes_x_y_, t2_);
        let t5_ = T::mul_add(elbow_omega_z_, elbow_axes_x_x_, t3_);
        let t6_ = c_(0.5) * t4_;
        let t7_ = c_(0.5) * t5_;
        let t8_ = T::mul_add(elbow_omega_z_, elbow_omega_z_, minus_elbow_centripetal_x_);
        let t9_ = c_(0.16666666666666666) * t8_;
        let t10_ = T::mul_add(t2_, t6_, t9_);
        let t11_ = T::mul_add(t3_, t7_, t10_);
        let t12_ = sin_shoulder_angle_ * c_(14.700000000000001);
        let t13_ = T::mul_add(c_(4.9), minus_elbow_axes_x_y_, t12_);
        ::mstmm::Energy {
            kinetic: t11_,
            potential: t13_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for TwoPins<T> {
    type Scalar = T;
    type State = TwoPinsState<T>;
    type Inputs = TwoPinsInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        rate_: &mut TwoPinsState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state_: &TwoPinsState<T>,
        rate_: &mut TwoPinsState<T>,
    ) {
        rate_.q.data.0 = {
            let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
            [[shoulder_rate_, elbow_rate_]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut TwoPinsState<T>) {
        state_.q.data.0 = {
            let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
            [[shoulder_angle_, elbow_angle_]]
        };
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for TwoPins<T> {
    type Workspace = TwoPinsWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> TwoPinsState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> TwoPinsInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> TwoPinsWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        at_: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn energy(&self, state_: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
    }
}
/// Coordinates and rates of [`TwoPins`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    pub q: ::mstmm::nalgebra::SVector<T, 2>,
    /// Rates in rad/s and m/s.
    pub v: ::mstmm::nalgebra::SVector<T, 2>,
    /// Time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsState<T> {
    /// Coordinates and rates of hinge `shoulder`.
    #[inline]
    #[must_use]
    pub fn shoulder(&self) -> ::mstmm::PinState<T> {
        let [[q0_, ..]] = self.q.data.0;
        let [[v0_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `shoulder`, to be changed.
    #[inline]
    pub fn shoulder_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0_, ..]] = &mut self.q.data.0;
        let [[v0_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `elbow`.
    #[inline]
    #[must_use]
    pub fn elbow(&self) -> ::mstmm::PinState<T> {
        let [[_, q1_, ..]] = self.q.data.0;
        let [[_, v1_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q1_, v1_)
    }
    /// Coordinates and rates of hinge `elbow`, to be changed.
    #[inline]
    pub fn elbow_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, q1_, ..]] = &mut self.q.data.0;
        let [[_, v1_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q1_, v1_)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPinsState<T> {
    fn default() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector([zero_, zero_]),
            v: ::mstmm::generated::vector([zero_; 2]),
            t: zero_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for TwoPinsState<T> {
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
    fn set_time(&mut self, time_: T) {
        self.t = time_;
    }
}
/// What drives [`TwoPins`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPinsInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> TwoPinsInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`TwoPins::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 2>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 2>,
    efforts: ::mstmm::nalgebra::SVector<T, 2>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::Point<T>; 5],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 2> {
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
    pub fn points(&self) -> &[::mstmm::Point<T>; 5] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `shoulder`.
    #[inline]
    pub fn shoulder(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 0);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0);
                value_
            },
            input_,
            output_,
        )
    }
    /// Input and output of body `upper`.
    #[inline]
    pub fn upper(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `elbow`.
    #[inline]
    pub fn elbow(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [_, _, input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 1);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 1);
                value_
            },
            input_,
            output_,
        )
    }
    /// Input and output of body `lower`.
    #[inline]
    pub fn lower(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, _, _, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> TwoPinsWorkspace<T> {
        let zero_ = T::constant(0.0);
        TwoPinsWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 2]),
            rate_accelerations: ::mstmm::generated::vector([zero_; 2]),
            efforts: ::mstmm::generated::vector([zero_; 2]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            points: [::core::default::Default::default(); 5],
        }
    }
}
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Rod;
    const _: Rod = Rod;
    const _: Rod = Rod;
};
